//! Sheets without volume: parts of two triangles, one of either mesh, in one plane, that face each other.
//!
//! If the move of a mesh has opened a gap of zero width, a result has both sides of the gap. In the limit these cancel:
//! of either triangle the part remains that the other does not cover, by
//! [`mod@predicament_overlay::algorithm::overlay`] in the plane.

use std::collections::{BTreeMap, BTreeSet};

use predicament_grid::{Bounds, BoxIndex};
use predicament_mesh::MaterialMesh;
use predicament_predicates::Construction::Lpi;
use predicament_predicates::{Axis, Plane, Predicates, Scene, Sign, Vertex};

use super::places::Places;
use super::plane::{InPlane, Line};
use crate::algorithm::overlay::{Contradiction, Source, SurfaceContradiction, Undone};
use predicament_overlay::algorithm::overlay::{Edge, Method, Operation, Polygon, Rule, overlay};
use predicament_triangulate::algorithm::triangulate;

/// The source of a result's triangle, and true if it faces the other way.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Label {
    pub source: Source,
    pub is_turned: bool,
}

/// A triangle of a result, by representatives of its vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// Its index in the result.
    pub place: u32,
    pub triangle: [Vertex; 3],
    /// Its vertices in the overlay.
    pub named: [Vertex; 3],
    pub label: Label,
}

/// Parts of two triangles that face each other and have a common area: their sources in the first mesh and in the
/// second, the plane in which both are seen, and the orientation of the first there.
struct Facing {
    labels: [Label; 2],
    plane: Plane,
    turn: Sign,
}

/// The uncovered remainder of parts: the indices of the removed parts, and their replacements.
#[derive(Default)]
pub(super) struct Left {
    pub gone: Vec<u32>,
    pub instead: Vec<([Vertex; 3], Label)>,
}

/// Parts that are already removed, and still border on others of the same triangle: they make diagonals between parts
/// cancel.
#[derive(Default)]
pub(super) struct Gone {
    /// Parts without area, or with a vertex twice.
    pub flat: Vec<Part>,
    /// Pairs of opposite parts.
    pub cancelled: Vec<[Part; 2]>,
}

/// The uncovered remainder of the parts of both meshes that face each other.
pub(super) fn left(
    session: &mut dyn Predicates,
    places: &Places,
    meshes: [&MaterialMesh; 2],
    parts: [&[Part]; 2],
    gone: &Gone,
) -> Result<Left, Undone> {
    let mut facing = facing(session, places, meshes, parts)?;
    let mut left = Left::default();
    if facing.is_empty() {
        return Ok(left);
    }
    let between = |pair: &&[Part; 2]| pair.each_ref().map(|part| part.label.source.mesh) == [0, 1];
    let mut cancelled: Vec<&[Part; 2]> = gone.cancelled.iter().filter(between).collect();
    let mut by_label: BTreeMap<Label, Vec<&Part>> = BTreeMap::new();
    let dead = gone.flat.iter().chain(cancelled.iter().copied().flatten());
    for part in parts.iter().copied().flatten().chain(dead) {
        by_label.entry(part.label).or_default().push(part);
    }
    // If one part of a triangle is processed, all its parts are, and so are the triangles that face it.
    let mut labels: BTreeSet<Label> = facing.iter().flat_map(|pair| pair.labels).collect();
    loop {
        let is_new = |pair: &&[Part; 2]| pair.iter().any(|part| labels.contains(&part.label));
        let (new, others): (Vec<_>, Vec<_>) = cancelled.into_iter().partition(is_new);
        cancelled = others;
        if new.is_empty() {
            break;
        }
        for pair in new {
            let (plane, turn) = view(session, places, pair[0].triangle)?;
            facing.push(Facing { labels: pair.each_ref().map(|part| part.label), plane, turn });
            labels.extend(pair.each_ref().map(|part| part.label));
        }
    }
    let live: BTreeSet<u32> = parts.iter().copied().flatten().map(|part| part.place).collect();
    for side in 0..2 {
        facing.sort_unstable_by_key(|pair| (pair.labels[side], pair.labels[1 - side]));
        for group in facing.chunk_by(|a, b| a.labels[side] == b.labels[side]) {
            let Facing { labels, plane, turn } = group[0];
            let own = &by_label[&labels[side]];
            let mut others: Vec<Label> = group.iter().map(|pair| pair.labels[1 - side]).collect();
            others.dedup();
            let other: Vec<&Part> = others.iter().flat_map(|label| &by_label[label]).copied().collect();
            left.gone.extend(own.iter().map(|part| part.place).filter(|place| live.contains(place)));
            let triangles = uncovered(session, places, meshes, plane, [own, &other])?;
            // Triangles are counterclockwise in the plane.
            let is_reversed = (turn == Sign::Negative) == (side == 0);
            let turned = |[a, b, c]: [Vertex; 3]| if is_reversed { [a, c, b] } else { [a, b, c] };
            left.instead.extend(triangles.into_iter().map(|triangle| (turned(triangle), labels[side])));
        }
    }
    Ok(left)
}

/// All pairs that face each other.
fn facing(
    session: &dyn Predicates,
    places: &Places,
    meshes: [&MaterialMesh; 2],
    parts: [&[Part]; 2],
) -> Result<Vec<Facing>, Undone> {
    let bounds = |part: &Part| Bounds::of(part.triangle.map(|v| places.nearest(session.scene(), v)));
    let corners =
        |part: &Part| meshes[usize::from(part.label.source.mesh)].triangles()[part.label.source.triangle as usize];
    let index = BoxIndex::new(parts[1].iter().map(bounds).collect());
    let (mut all, mut found) = (Vec::new(), Vec::new());
    for part in parts[0] {
        index.near(&bounds(part), 0.0, &mut found);
        let own = corners(part);
        let mut seen = None;
        for &second in &found {
            let other = &parts[1][second as usize];
            let [a, b, c] = own;
            if corners(other).iter().any(|&v| !session.orient3d(a, b, c, v).is_zero()) {
                continue;
            }
            let (plane, turn) = match seen {
                Some(seen) => seen,
                None => *seen.insert(view(session, places, part.triangle)?),
            };
            let [a, b, c] = other.triangle;
            if session.orient2d(plane, a, b, c) == -turn
                && have_common_area(session, plane, turn, [part.triangle, [a, c, b]])
            {
                all.push(Facing { labels: [part.label, other.label], plane, turn });
            }
        }
    }
    Ok(all)
}

/// The coordinate plane in which a triangle has the largest area, and its turn there.
pub(crate) fn view(session: &dyn Predicates, places: &Places, [a, b, c]: [Vertex; 3]) -> Result<(Plane, Sign), Undone> {
    let [p, q, r] = [a, b, c].map(|v| places.nearest(session.scene(), v));
    let area = |plane: Plane| {
        let [i, j] = plane.axes().map(Axis::index);
        let difference = |to: [f64; 3], axis: usize| to[axis] / 2.0 - p[axis] / 2.0;
        (difference(q, i) * difference(r, j) - difference(q, j) * difference(r, i)).abs()
    };
    let mut planes = [Plane::Xy, Plane::Yz, Plane::Zx].map(|plane| (plane, area(plane)));
    planes.sort_by(|a, b| b.1.total_cmp(&a.1));
    let turns = planes.into_iter().map(|(plane, _)| (plane, session.orient2d(plane, a, b, c)));
    turns.into_iter().find(|(_, turn)| !turn.is_zero()).ok_or(Undone::Broken(Contradiction::NoArea))
}

/// True if two triangles with the same orientation have more in common than a border: no edge of either has the other
/// triangle beyond it.
fn have_common_area(session: &dyn Predicates, plane: Plane, turn: Sign, [first, second]: [[Vertex; 3]; 2]) -> bool {
    let is_beyond = |[a, b, c]: [Vertex; 3], other: [Vertex; 3]| {
        [[a, b], [b, c], [c, a]]
            .into_iter()
            .any(|[u, v]| other.iter().all(|&w| w == u || w == v || session.orient2d(plane, u, v, w) != turn))
    };
    !is_beyond(first, second) && !is_beyond(second, first)
}

/// An edge of parts, as in its first use.
struct Border {
    /// The number of times that it is passed in this direction, less the times back.
    times: i32,
    /// The ends in the plane.
    ends: [Vertex; 2],
    line: Option<Line>,
    /// True if the first use went from the smaller name to the larger.
    is_up: bool,
}

/// The remainder of some parts that others do not cover, counterclockwise in a coordinate plane.
fn uncovered(
    session: &mut dyn Predicates,
    places: &Places,
    meshes: [&MaterialMesh; 2],
    plane: Plane,
    [own, other]: [&[&Part]; 2],
) -> Result<Vec<[Vertex; 3]>, Undone> {
    let mut vertices: Vec<Vertex> = own.iter().chain(other).flat_map(|part| part.triangle).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let corners =
        |part: &Part| meshes[usize::from(part.label.source.mesh)].triangles()[part.label.source.triangle as usize];
    let [a, b, c] = corners(own[0]);
    let scene = session.scene();
    let all = meshes.iter().flat_map(|mesh| mesh.triangles().as_flattened()).copied();
    let apart = all
        .into_iter()
        .find(|&v| !session.orient3d(a, b, c, v).is_zero())
        .ok_or(Undone::Broken(SurfaceContradiction::Flat.into()))?;
    let at = |v: Vertex| Vertex::input(vertices.partition_point(|&other| other < v));
    let mut lines = Vec::new();
    let mut polygon = |parts: &[&Part]| {
        // Diagonals between parts cancel by their original names, also at vertices with a different representative.
        let mut border: BTreeMap<[Vertex; 2], Border> = BTreeMap::new();
        for part in parts {
            for corner in 0..3 {
                let ends = [corner, (corner + 1) % 3];
                let [from, to] = ends.map(|corner| part.named[corner]);
                let is_up = from < to;
                let edge = border.entry([from.min(to), from.max(to)]).or_insert_with(|| Border {
                    times: 0,
                    ends: ends.map(|corner| at(part.triangle[corner])),
                    line: line_of(scene, corners(part), [from, to]),
                    is_up,
                });
                edge.times += if is_up == edge.is_up { 1 } else { -1 };
            }
        }
        let mut edges = Vec::new();
        for Border { times, ends: [from, to], line, .. } in border.into_values() {
            // (Parts of one side border on each other: a second use of an edge goes back.)
            if times != 0 && from != to {
                edges.push(Edge::whole(from, to));
                lines.extend(line.map(|line| ([from, to], line)));
            }
        }
        Polygon { loops: vec![edges], rule: Rule::NonZero }
    };
    let operands = [polygon(own), polygon(other)];
    let out_of_range = Undone::Broken(SurfaceContradiction::Plane.into());
    let mut flat = InPlane::new(session, places, plane, vertices, ([a, b, c], apart)).ok_or(out_of_range)?;
    lines.into_iter().for_each(|(segment, line)| flat.on_line(segment, line));
    let both = overlay(&mut flat, operands.each_ref(), Method::Grid)?;
    let regions = both.regions(Operation::Difference);
    if let Some(rule) = both.arrangement.broken.or(regions.broken) {
        return Err(Undone::Broken(rule.into()));
    }
    let mut triangles = Vec::new();
    for region in &regions.regions {
        let loops: Vec<Vec<Vertex>> =
            region.loops().map(|edges| edges.iter().map(|edge| flat.vertex(edge.from)).collect()).collect();
        let made =
            triangulate(flat.space(), plane, false, &loops, predicament_triangulate::algorithm::Method::Monotone);
        if let Some(rule) = made.broken {
            return Err(Undone::Broken(rule.into()));
        }
        triangles.extend(made.triangles);
    }
    Ok(triangles)
}

/// The line that contains two vertices of a part of a triangle by definition, if there is a single one: an edge, or the
/// intersection with a triangle of the other mesh.
fn line_of(scene: &Scene, mut triangle: [Vertex; 3], [p, q]: [Vertex; 2]) -> Option<Line> {
    let lpi = |v: Vertex| match scene.construction(v) {
        Some(&Lpi { line, plane }) => Some((line, plane)),
        _ => None,
    };
    match (lpi(p), lpi(q)) {
        (None, None) => (!p.is_constructed() && !q.is_constructed()).then_some(Line::Edge([p, q])),
        (None, Some((line, _))) => line.contains(&p).then_some(Line::Edge(line)),
        (Some((line, _)), None) => line.contains(&q).then_some(Line::Edge(line)),
        (Some((first, _)), Some((second, _))) if first == second => Some(Line::Edge(first)),
        (Some(first), Some(second)) => {
            triangle.sort_unstable();
            let other = [first, second].into_iter().map(|(_, plane)| plane).find(|plane| *plane != triangle);
            // Both are on edges of the other triangle.
            let of_edges = || {
                let mut corners = [first.0, second.0].concat();
                corners.sort_unstable();
                corners.dedup();
                <[Vertex; 3]>::try_from(corners).ok()
            };
            let other = other.or_else(of_edges)?;
            let is_on =
                |(line, plane): ([Vertex; 2], [Vertex; 3])| plane == other || line.iter().all(|v| other.contains(v));
            (is_on(first) && is_on(second)).then_some(Line::Cut(other))
        }
    }
}
