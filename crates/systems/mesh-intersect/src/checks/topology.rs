//! The topology of pieces, by their vertices alone: no coordinate is used.
//!
//! Vertices are identified by their definitions, so two of them at one position are two vertices, and the laws hold for
//! perturbed meshes too. In general position, which a perturbation makes of all positions, an edge of pieces is
//! * inside one triangle, which has a piece on either side of it;
//! * or on an edge of a mesh, where each triangle around that edge has a piece;
//! * or a segment of an intersection curve, inside one triangle of either mesh: each has a piece on either side of it.
//!
//! The number of curve segments that end in a constructed vertex therefore equals the number of triangles around its
//! edge: two for a manifold mesh, and an even number on the surface of any solid.
//!
//! # Euler characteristics
//! The curves c cut the surface of A into a part outside B and a part inside. The surface of
//! the union consists of both parts outside, the surface of the intersection of both parts inside. V - E + F adds up,
//! except for curves that belong to both parts: χ(∂(A∪B)) + χ(∂(A∩B)) = χ(∂A) + χ(∂B), and χ(∂(A∆B)) = χ(∂A) + χ(∂B) -
//! χ(c). The characteristic of a solid is half of its surface's, so this is χ(A∪B) = χ(A) + χ(B) - χ(A∩B). The right
//! sides are counted on the given meshes.

use std::collections::{BTreeMap, BTreeSet};

use crate::answer::Source;
use predicament_mesh::{MaterialMesh, OUTSIDE};
use predicament_overlay::answer::Operation;
use predicament_predicates::{Construction, Vertex};

use super::{Laws, Violations, note};

/// An edge, with its smaller vertex first.
type Edge = [Vertex; 2];

/// The pieces at an edge: their sources, each with true if it passes the edge from its first vertex on.
type Around = Vec<(Source, bool)>;

/// The edges of the overlay and of both meshes.
pub struct Edges {
    of_pieces: BTreeMap<Edge, Around>,
    /// For each edge of either mesh, the number of triangles around it.
    of_meshes: [BTreeMap<Edge, usize>; 2],
    /// The triangles around each edge of either mesh, and the number of them that separate inside and outside.
    around: [BTreeMap<Vec<u32>, usize>; 2],
}

/// The edges of a triangle, each with true if it is passed from its smaller vertex on.
fn edges([a, b, c]: [Vertex; 3]) -> [(Edge, bool); 3] {
    [[a, b], [b, c], [c, a]].map(|[a, b]| ([a.min(b), a.max(b)], a < b))
}

fn is_boundary(sides: [u32; 2]) -> bool {
    let [front, behind] = sides.map(|region| region != OUTSIDE);
    front != behind
}

/// The Euler characteristic: vertices − edges + triangles.
fn characteristic(triangles: impl Iterator<Item = [Vertex; 3]>) -> i64 {
    let (mut vertices, mut of_triangles, mut count) = (BTreeSet::new(), BTreeSet::new(), 0_usize);
    for triangle in triangles {
        vertices.extend(triangle);
        of_triangles.extend(edges(triangle).map(|(edge, _)| edge));
        count += 1;
    }
    number(vertices.len() + count) - number(of_triangles.len())
}

fn number(count: usize) -> i64 {
    i64::try_from(count).unwrap_or(i64::MAX)
}

fn boundary(mesh: &MaterialMesh) -> impl Iterator<Item = [Vertex; 3]> {
    mesh.triangles().iter().zip(mesh.sides()).filter(|(_, sides)| is_boundary(**sides)).map(|(triangle, _)| *triangle)
}

impl Edges {
    pub fn of(laws: &Laws<'_>) -> Edges {
        let mut of_pieces: BTreeMap<Edge, Around> = BTreeMap::new();
        for (&triangle, &source) in laws.regions.triangles.iter().zip(&laws.regions.sources) {
            for (edge, is_forward) in edges(triangle) {
                of_pieces.entry(edge).or_default().push((source, is_forward));
            }
        }
        let (mut of_meshes, mut around) = <([BTreeMap<Edge, usize>; 2], [BTreeMap<Vec<u32>, usize>; 2])>::default();
        for (own, mesh) in laws.meshes.iter().enumerate() {
            let mut triangles: BTreeMap<Edge, Vec<u32>> = BTreeMap::new();
            for (&triangle, at) in mesh.triangles().iter().zip(0..) {
                edges(triangle).into_iter().for_each(|(edge, _)| triangles.entry(edge).or_default().push(at));
            }
            let of_surface = |at: &&u32| is_boundary(mesh.sides()[**at as usize]);
            for (edge, triangles) in triangles {
                of_meshes[own].insert(edge, triangles.len());
                let count = triangles.iter().filter(of_surface).count();
                around[own].insert(triangles, count);
            }
        }
        Edges { of_pieces, of_meshes, around }
    }

    /// True if both meshes have pieces here.
    fn is_curve(around: &Around) -> bool {
        [0, 1].iter().all(|mesh| around.iter().any(|(source, _)| source.mesh == *mesh))
    }

    /// The segments of intersection curves.
    fn curves(&self) -> impl Iterator<Item = (&Edge, &Around)> {
        self.of_pieces.iter().filter(|(_, around)| Edges::is_curve(around))
    }

    /// The number of triangles of a surface around the mesh edge of these pieces, one of each triangle; `None` if there
    /// is no such edge.
    fn of_surface(&self, around: &Around) -> Option<usize> {
        let mut triangles: Vec<u32> = around.iter().map(|(source, _)| source.triangle).collect();
        triangles.sort_unstable();
        self.around[usize::from(around[0].0.mesh)].get(&triangles).copied()
    }
}

/// True if these are two pieces of one triangle, one on either side.
fn is_inside(around: &[&(Source, bool)]) -> bool {
    matches!(around, [(source, forward), (other, back)] if source == other && forward != back)
}

impl Laws<'_> {
    /// Checks edges of pieces, curves, and surfaces of results. If zeros mean zero and the meshes touch, only surfaces
    /// of results are checked, for being closed.
    pub fn topology(&self, zeros_are_exact: bool, found: &mut Violations) {
        let edges = Edges::of(self);
        let mut all = Violations::new();
        self.edges_of_pieces(&edges, &mut all);
        self.curves(&edges, &mut all);
        self.surfaces(&edges, &mut all);
        self.characteristics(&edges, &mut all);
        if !all.is_empty() && zeros_are_exact && self.touches() {
            all.retain(|violation| violation.check == "result not closed");
        }
        found.append(&mut all);
    }

    /// Checks that each edge is inside a triangle, on an edge of a mesh, or a segment of a curve.
    fn edges_of_pieces(&self, edges: &Edges, found: &mut Violations) {
        let (mut wrong, mut wrong_curves) = (Vec::new(), Vec::new());
        for (edge, around) in &edges.of_pieces {
            let of = |mesh: u8| around.iter().filter(move |(source, _)| source.mesh == mesh).collect::<Vec<_>>();
            if Edges::is_curve(around) {
                let is_right =
                    edge.iter().all(|v| v.is_constructed()) && [0, 1].iter().all(|&mesh| is_inside(&of(mesh)));
                if !is_right {
                    wrong_curves.push(edge);
                }
            } else if !is_inside(&around.iter().collect::<Vec<_>>()) && edges.of_surface(around).is_none() {
                wrong.push(edge);
            }
        }
        if let Some([a, b]) = wrong.first() {
            let got = format!("{} times, first: the edge of {a} and {b}", wrong.len());
            let law = "an edge is inside a triangle, with a piece on each side, or on an edge of a mesh, with a piece \
                       of each triangle at that edge";
            note(found, "edge of a piece", got, law);
        }
        if let Some([a, b]) = wrong_curves.first() {
            let got = format!("{} times, first: the edge of {a} and {b}", wrong_curves.len());
            let law = "a segment of a curve has, in each mesh, two pieces of one triangle, one on each side";
            note(found, "segment of a curve", got, law);
        }
    }

    /// Checks that curves are closed: the number of segments that end in a constructed vertex is the number of
    /// triangles around the edge that it is on.
    fn curves(&self, edges: &Edges, found: &mut Violations) {
        let sides = [0, 1].map(|mesh: usize| self.meshes[mesh].sides());
        // Counts of all segments, and of those between surfaces of solids.
        let mut ends: BTreeMap<Vertex, [usize; 2]> = BTreeMap::new();
        for (edge, around) in edges.curves() {
            let is_of_surface =
                around.iter().all(|(source, _)| is_boundary(sides[usize::from(source.mesh)][source.triangle as usize]));
            for v in edge {
                let [all, of_surfaces] = ends.entry(*v).or_default();
                *all += 1;
                *of_surfaces += usize::from(is_of_surface);
            }
        }
        let wanted = |at: usize| match self.constructions[at] {
            Construction::Lpi { line: [a, b], .. } => {
                let edge = [a.min(b), a.max(b)];
                edges.of_meshes.iter().find_map(|of_mesh| of_mesh.get(&edge)).copied()
            }
            _ => None,
        };
        let vertex = |at: usize| Vertex::constructed(self.before + at);
        let of = |v: Vertex| ends.get(&v).copied().unwrap_or_default();
        let wrong = (0..self.constructions.len()).find(|&at| {
            let [all, of_surfaces] = of(vertex(at));
            wanted(at) != Some(all) || of_surfaces % 2 != 0
        });
        if let Some(at) = wrong {
            let (v, [all, of_surfaces]) = (vertex(at), of(vertex(at)));
            let around = wanted(at)
                .map_or_else(|| "not on an edge of a mesh".to_owned(), |n| format!("on an edge with {n} triangles"));
            let got = format!("{v} is {around}; {all} segments end there, {of_surfaces} of them between surfaces");
            let law = "the number of curve segments that end in a point equals the number of triangles around its \
                       edge; an even number are between surfaces";
            note(found, "curve not closed", got, law);
        }
    }

    /// Checks that the surface of each result passes each edge equally often in both directions, and goes around each
    /// edge and each constructed vertex once, unless a mesh or two surfaces do so more often.
    fn surfaces(&self, edges: &Edges, found: &mut Violations) {
        for (operation, solid) in Operation::ALL.into_iter().zip(self.solids) {
            let mut uses: BTreeMap<Edge, [usize; 2]> = BTreeMap::new();
            for &triangle in solid {
                for (edge, is_forward) in self::edges(triangle) {
                    uses.entry(edge).or_default()[usize::from(is_forward)] += 1;
                }
            }
            let is_exclusive = operation == Operation::SymmetricDifference;
            let open = uses.iter().find(|(_, [back, forward])| back != forward);
            if let Some(([a, b], _)) = open {
                let got = format!("{}: open at the edge of {a} and {b}", operation.name());
                note(found, "result not closed", got, "the surface of a result is closed and consistently oriented");
                continue;
            }
            let is_right = |edge: &Edge, forward: usize| {
                let Some(around) = edges.of_pieces.get(edge) else { return false };
                forward == 1
                    || is_exclusive && forward == 2 && Edges::is_curve(around)
                    || edges.of_surface(around) == Some(2 * forward)
            };
            if let Some(([a, b], [_, count])) = uses.iter().find(|(edge, [_, forward])| !is_right(edge, *forward)) {
                let got = format!("{}: {} triangles at the edge of {a} and {b}", operation.name(), 2 * count);
                note(found, "edge of a result", got, "an edge has two triangles, or as many as in the meshes");
            } else if !is_exclusive && let Some(v) = self.pinched(solid, &uses) {
                let got = format!("{}: the triangles at {v} make more than one fan", operation.name());
                note(found, "corner of a result", got, "the triangles at a constructed vertex make one fan");
            }
        }
    }

    /// The first constructed vertex, on edges of two triangles each, whose triangles go around it more than once.
    fn pinched(&self, solid: &[[Vertex; 3]], uses: &BTreeMap<Edge, [usize; 2]>) -> Option<Vertex> {
        let mut links: BTreeMap<Vertex, BTreeMap<Vertex, Vertex>> = BTreeMap::new();
        let mut is_manifold: BTreeMap<Vertex, bool> = BTreeMap::new();
        for &[a, b, c] in solid {
            for [v, from, to] in [[a, b, c], [b, c, a], [c, a, b]] {
                if v.is_constructed() {
                    links.entry(v).or_default().insert(from, to);
                    *is_manifold.entry(v).or_insert(true) &= uses.get(&[v.min(from), v.max(from)]) == Some(&[1, 1]);
                }
            }
        }
        let is_pinched = |(v, link): &(&Vertex, &BTreeMap<Vertex, Vertex>)| {
            let Some((&first, &second)) = link.first_key_value() else { return false };
            let (mut at, mut count) = (second, 1);
            while at != first && count <= link.len() {
                let Some(&next) = link.get(&at) else { return true };
                (at, count) = (next, count + 1);
            }
            is_manifold[*v] && count != link.len()
        };
        links.iter().find(is_pinched).map(|(v, _)| *v)
    }

    /// Checks the Euler characteristics of the results against the characteristics of the given meshes.
    fn characteristics(&self, edges: &Edges, found: &mut Violations) {
        let [first, second] = self.meshes.each_ref().map(|mesh| characteristic(boundary(mesh)));
        let of = |at: usize| characteristic(self.solids[at].iter().copied());
        let sides = [0, 1].map(|mesh: usize| self.meshes[mesh].sides());
        let (mut vertices, mut segments) = (BTreeSet::<Vertex>::new(), 0_usize);
        for (edge, around) in edges.curves() {
            if around.iter().all(|(source, _)| is_boundary(sides[usize::from(source.mesh)][source.triangle as usize])) {
                vertices.extend(edge);
                segments += 1;
            }
        }
        let curves = number(vertices.len()) - number(segments);
        let [union, intersection, exclusive] = [of(0), of(1), of(3)];
        if union + intersection != first + second {
            let got = format!("{union} and {intersection}, of meshes of {first} and {second}");
            let law =
                "the Euler characteristics of union and intersection add up to the characteristics of both meshes";
            note(found, "Euler characteristic", got, law);
        } else if exclusive != first + second - curves {
            let got = format!("{exclusive}, of meshes of {first} and {second} and curves of {curves}");
            let law = "the Euler characteristic of the symmetric difference is the sum for both meshes less the \
                       characteristic of the curves";
            note(found, "Euler characteristic", got, law);
        }
    }
}
