//! The failed checks of a triangulation.

use std::collections::{HashMap, HashSet};

use predicament_predicates::{Axis, Plane, Question, Scene, Sign, Vertex};
use rug::Integer;

use super::outline::Exactly;
use predicament_hull::checks::{Flaw, Signs, Tally, ring};

/// The maximum number of pairs of a triangle and a vertex for which all pairs are checked.
const MOST_PAIRS: usize = 20_000;
/// The maximum number of triangles whose areas are added up.
const MOST_ADDED: usize = 50_000;

/// A triangulation as found.
#[derive(Clone, Copy, Debug)]
pub struct Found<'a> {
    /// The triangles.
    pub triangles: &'a [[Vertex; 3]],
    /// All vertices, if there is no triangle.
    pub chain: &'a [Vertex],
    /// Vertices in the place of another vertex, each with the other one.
    pub copies: &'a [[Vertex; 2]],
    /// The ends of each constraint, which has to be an edge or a chain of edges.
    pub constraints: &'a [[Vertex; 2]],
    /// The rule for faces of more than three cocircular vertices.
    pub cut: Cut,
}

/// The rule by which a face of more than three cocircular vertices is cut into triangles.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Cut {
    /// A fan from its smallest vertex, or as the perturbation cuts it.
    Fan,
    /// In any way.
    Anyhow,
}

/// The failed checks of the Delaunay triangulation of all vertices of the sessions' scene, including constructed ones;
/// for each check, the first flaw is described.
#[must_use]
pub fn flaws(signs: Signs<'_>, found: Found<'_>) -> Vec<Flaw> {
    let mut tally = Tally::new(signs);
    let Some(corner_of) = corners(&mut tally, found) else { return tally.finish() };
    copies(&mut tally, found, &corner_of);
    if found.triangles.is_empty() {
        chain(&mut tally, found.chain);
        return tally.finish();
    }
    if !found.chain.is_empty() {
        tally.flaw("chain", found.chain, || "a chain beside triangles".to_owned());
    }
    let step = found.triangles.len().div_ceil(signs.pairs.max(1)).max(1);
    for triangle in found.triangles.iter().step_by(step) {
        tally.positive("positive", Some("positive"), Question::Orient2d(Plane::Xy), triangle);
    }
    let pairs = edges(&mut tally, found.triangles);
    hull(&mut tally, &pairs);
    area(&mut tally, found.triangles);
    let constrained = constraints(&mut tally, found, &pairs);
    circles(&mut tally, &pairs, &constrained, found.cut);
    if tally.is_clean() && found.constraints.is_empty() {
        everywhere(&mut tally, found);
    }
    tally.finish()
}

/// For each input vertex, true if it is a corner; `None` if a triangle does not have three different corners.
fn corners(tally: &mut Tally<'_>, found: Found<'_>) -> Option<Vec<bool>> {
    let scene = tally.scene();
    let mut is_corner = vec![false; scene.len() + scene.constructions().len()];
    let listed = found.chain.iter().chain(found.copies.as_flattened());
    for v in found.triangles.as_flattened().iter().chain(listed) {
        if !scene.has(*v) {
            tally.flaw("vertices", &[], || format!("{v} is not a vertex of the scene"));
        }
    }
    for triangle @ [a, b, c] in found.triangles {
        if a == b || b == c || a == c {
            tally.flaw("vertices", triangle, || "a triangle with fewer than three different vertices".to_owned());
        }
    }
    if !tally.is_clean() {
        return None;
    }
    found.triangles.as_flattened().iter().chain(found.chain).for_each(|&v| is_corner[place(scene, v)] = true);
    Some(is_corner)
}

/// The index of a vertex, input vertices first.
fn place(scene: &Scene, v: Vertex) -> usize {
    v.construction().map_or(v.index(), |index| scene.len() + index)
}

/// Checks `copies`.
fn copies(tally: &mut Tally<'_>, found: Found<'_>, is_corner: &[bool]) {
    let scene = tally.scene();
    let at = |v: Vertex| (!v.is_constructed()).then(|| scene.point2(Plane::Xy, v).map(|x| (x + 0.0).to_bits()));
    let mut stands: HashMap<Vertex, Vertex> = HashMap::with_capacity(found.copies.len());
    for &[copy, of] in found.copies {
        if stands.insert(copy, of).is_some() {
            tally.flaw("copies", &[copy], || format!("{copy} is listed twice"));
        }
        if !tally.has_ties() || at(copy).is_none() || at(copy) != at(of) || of >= copy || !is_corner[place(scene, of)] {
            tally.flaw("copies", &[copy, of], || format!("{of} does not stand for {copy}"));
        }
    }
    for v in (0..scene.constructions().len()).map(Vertex::constructed) {
        if !is_corner[place(scene, v)] {
            tally.flaw("copies", &[v], || format!("{v} is not a corner"));
        }
    }
    let mut first: HashMap<Option<[u64; 2]>, Vertex> = HashMap::new();
    for v in scene.vertices() {
        if is_corner[v.index()] == stands.contains_key(&v) {
            let what = if is_corner[v.index()] { "both a corner and a copy" } else { "neither a corner nor a copy" };
            tally.flaw("copies", &[v], || format!("{v} is {what}"));
        }
        // This is tested only if ties stay ties: without ties, two corners may share a place.
        if tally.has_ties() && *first.entry(at(v)).or_insert(v) != v && is_corner[v.index()] {
            tally.flaw("copies", &[v], || format!("{v} is a corner, and a smaller vertex has the same place"));
        }
    }
}

/// The order of two vertices by x, then by y.
fn order(tally: &Tally<'_>, v: Vertex, w: Vertex) -> Sign {
    let session = tally.signs.perturbed.unwrap_or(tally.signs.exact);
    match session.compare(Axis::X, v, w) {
        Sign::Zero => session.compare(Axis::Y, v, w),
        sign => sign,
    }
}

/// Checks `chain`: in order, and all on one line. A perturbation leaves no three vertices on one line.
fn chain(tally: &mut Tally<'_>, chain: &[Vertex]) {
    for pair in chain.windows(2) {
        if order(tally, pair[0], pair[1]) != Sign::Negative {
            tally.flaw("chain", pair, || format!("{} is not before {}", pair[0], pair[1]));
        }
    }
    if let [first, .., last] = *chain {
        for &v in &chain[1..chain.len() - 1] {
            let is_in_line = tally.has_ties() && tally.signs.exact.orient2d(Plane::Xy, first, last, v).is_zero();
            if !is_in_line {
                tally.flaw("chain", &[first, last, v], || format!("{v} is not on the line of {first} and {last}"));
            }
        }
    }
}

/// An edge with the vertices opposite of it, left and right.
struct Pair {
    ends: [Vertex; 2],
    left: Vertex,
    right: Option<Vertex>,
}

/// Checks `edges`, and returns all of them; an edge of one triangle has the triangle's direction.
fn edges(tally: &mut Tally<'_>, triangles: &[[Vertex; 3]]) -> Vec<Pair> {
    let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]]);
    let mut sides: Vec<([Vertex; 2], bool, Vertex)> = sides.map(|[a, b, c]| ([a.min(b), a.max(b)], a > b, c)).collect();
    sides.sort_unstable();
    let mut pairs = Vec::with_capacity(sides.len().div_ceil(2));
    for group in sides.chunk_by(|a, b| a.0 == b.0) {
        match *group {
            [([a, b], false, left)] => pairs.push(Pair { ends: [a, b], left, right: None }),
            [([a, b], true, left)] => pairs.push(Pair { ends: [b, a], left, right: None }),
            [(ends, false, left), (_, true, right)] => pairs.push(Pair { ends, left, right: Some(right) }),
            _ => {
                let ends = group[0].0;
                tally.flaw("edges", &ends, || {
                    format!(
                        "the edge {} {} belongs to {} triangles, or twice in one direction",
                        ends[0],
                        ends[1],
                        group.len()
                    )
                });
            }
        }
    }
    pairs
}

/// Checks `hull`, `convex` and `wound once`.
fn hull(tally: &mut Tally<'_>, pairs: &[Pair]) {
    let mut next: HashMap<Vertex, Vertex> = HashMap::new();
    let border = pairs.iter().filter(|pair| pair.right.is_none());
    for &Pair { ends: [a, b], .. } in border {
        if next.insert(a, b).is_some() {
            tally.flaw("hull", &[a], || format!("two edges of the hull begin at {a}"));
        }
    }
    let Some(&start) = next.keys().min() else {
        return tally.flaw("hull", &[], || "every edge belongs to more than one triangle".to_owned());
    };
    let mut cycle = vec![start];
    while let Some(&v) = next.get(&cycle[cycle.len() - 1])
        && v != start
        && cycle.len() <= next.len()
    {
        cycle.push(v);
    }
    if cycle.len() != next.len() {
        let length = cycle.len();
        return tally
            .flaw("hull", &[start], || format!("{} edges of one triangle, and a cycle of {length}", next.len()));
    }
    ring(tally, Plane::Xy, &cycle, "convex", None);
}

/// Checks `area`, in integers.
fn area(tally: &mut Tally<'_>, triangles: &[[Vertex; 3]]) {
    // (With constructed vertices, the other checks imply the areas.)
    if triangles.len() > MOST_ADDED || !tally.scene().constructions().is_empty() {
        return;
    }
    let exactly = Exactly::new(tally.scene());
    let sum: Integer = triangles.iter().map(|triangle| exactly.area(triangle.map(Vertex::index))).sum();
    let hull = exactly.hull();
    if sum != hull {
        tally.flaw("area", &[], || format!("twice the area is {sum}, expected {hull}, in units of the last place"));
    }
}

/// Checks `constraint`: from one end, an edge leads to the other end or to a vertex between them on their line, and so
/// on. Returns the edges, each by its ends, the smaller first.
fn constraints(tally: &mut Tally<'_>, found: Found<'_>, pairs: &[Pair]) -> HashSet<[Vertex; 2]> {
    let mut edges = HashSet::new();
    if found.constraints.is_empty() {
        return edges;
    }
    let stands: HashMap<Vertex, Vertex> = found.copies.iter().map(|&[copy, of]| (copy, of)).collect();
    let mut beside: HashMap<Vertex, Vec<Vertex>> = HashMap::new();
    for &Pair { ends: [a, b], .. } in pairs {
        beside.entry(a).or_default().push(b);
        beside.entry(b).or_default().push(a);
    }
    for &constraint in found.constraints {
        let [a, b] = constraint.map(|v| stands.get(&v).copied().unwrap_or(v));
        let mut at = a;
        while at != b {
            let exact = tally.signs.exact;
            // A perturbation leaves no third vertex on the line.
            let is_on = |v: Vertex| {
                let direction = order(tally, at, b);
                v == b
                    || tally.has_ties()
                        && exact.orient2d(Plane::Xy, a, b, v).is_zero()
                        && order(tally, at, v) == direction
                        && order(tally, v, b) == direction
            };
            let near = beside.get(&at).map_or(&[][..], Vec::as_slice);
            let Some(next) = near.iter().copied().find(|&v| is_on(v)) else {
                tally.flaw("constraint", &[a, b], || format!("the chain of edges ends at {at} before {b}"));
                break;
            };
            edges.insert([at.min(next), at.max(next)]);
            at = next;
        }
    }
    edges
}

/// Checks `empty circle` and `fan`: all edges that are not part of a constraint, or an even sample.
fn circles(tally: &mut Tally<'_>, pairs: &[Pair], constrained: &HashSet<[Vertex; 2]>, cut: Cut) {
    let step = pairs.len().div_ceil(tally.signs.pairs.max(1)).max(1);
    for pair in pairs.iter().step_by(step) {
        let (&Pair { ends: [a, b], left, .. }, Some(right)) = (pair, pair.right) else { continue };
        if constrained.contains(&[a.min(b), a.max(b)]) {
            continue;
        }
        // Exchanged, so that positive means outside.
        let args = [b, a, left, right];
        tally.positive("empty circle", None, Question::Incircle, &args);
        let is_fan = cut == Cut::Fan && tally.has_ties();
        if is_fan && tally.signs.exact.incircle(b, a, left, right).is_zero() && left.min(right) < a.min(b) {
            tally.flaw("fan", &args, || format!("four vertices on one circle, and {a} {b} is the edge"));
        }
    }
}

/// Checks `empty`: each triangle against each vertex.
fn everywhere(tally: &mut Tally<'_>, found: Found<'_>) {
    let scene: &Scene = tally.scene();
    if found.triangles.len() * scene.len() > MOST_PAIRS.min(tally.signs.pairs) {
        return;
    }
    for &[a, b, c] in found.triangles {
        for v in scene.vertices().filter(|v| ![a, b, c].contains(v)) {
            tally.positive("empty", None, Question::Incircle, &[b, a, c, v]);
        }
    }
}
