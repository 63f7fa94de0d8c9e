//! Flaws of rounding in a mesh: reversed triangles, folds, and triangles that pass through each other.

use predicament_grid::{Bounds, BoxIndex, shared};
use predicament_predicates::{Plane, Predicates, Sign, Vertex};

/// The flaws of a mesh of doubles.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Flaws {
    /// The number of reversed triangles.
    pub turned: usize,
    /// Pairs of triangles with a common edge in which one triangle lies on the other.
    pub folded: usize,
    /// Other pairs of triangles that have more in common than corners and edges.
    pub crossing: usize,
    /// The vertices of flawed triangles, ascending.
    pub vertices: Vec<u32>,
}

impl Flaws {
    /// The number of all flaws.
    #[must_use]
    pub fn count(&self) -> usize {
        self.turned + self.folded + self.crossing
    }

    fn note(&mut self, triangle: [u32; 3]) {
        self.vertices.extend(triangle);
    }
}

/// Finds the flaws of triangles with a moved vertex. Each triangle comes with the index of its source, and with its
/// turn in a coordinate plane before rounding.
///
/// The session must return exact zeros.
///
/// # Panics
/// If a triangle has a vertex or an index out of range.
pub fn flaws(
    session: &dyn Predicates,
    triangles: &[([u32; 3], u32)],
    is_moved: &(dyn Fn(u32) -> bool + Sync),
    turns: &[Option<(Plane, Sign)>],
) -> Flaws {
    let mut flaws = Flaws::default();
    for &(triangle, place) in triangles {
        if let Some((plane, turn)) = turns[place as usize] {
            let [a, b, c] = triangle.map(vertex);
            // (Seen from its edge it is flat, not reversed.)
            if session.orient2d(plane, a, b, c) == -turn {
                flaws.turned += 1;
                flaws.note(triangle);
            }
        }
    }
    for (pair, flaw) in pairs(session, triangles.len(), &|at| triangles[at].0, is_moved) {
        match flaw {
            Flaw::Fold => flaws.folded += 1,
            Flaw::Crossing => flaws.crossing += 1,
        }
        pair.into_iter().for_each(|at| flaws.note(triangles[at as usize].0));
    }
    flaws.vertices.sort_unstable();
    flaws.vertices.dedup();
    flaws
}

/// The pairs of triangles, as indices, with a moved vertex and more in common than corners and edges.
pub(crate) fn pairs(
    session: &dyn Predicates,
    count: usize,
    triangle: &(dyn Fn(usize) -> [u32; 3] + Sync),
    is_moved: &(dyn Fn(u32) -> bool + Sync),
) -> Vec<([u32; 2], Flaw)> {
    let has_moved = |at: usize| triangle(at).into_iter().any(is_moved);
    let moved: Vec<usize> = (0..count).filter(|&at| has_moved(at)).collect();
    let box_of = |at: usize| Bounds::of(triangle(at).map(|v| session.scene().point3(vertex(v))));
    let ([_, near], _) = shared([moved.len(), count], [&|at: usize| box_of(moved[at]), &|at: usize| box_of(at)]);
    let index = BoxIndex::new(near.iter().map(|&at| box_of(at as usize)).collect());
    let pairs_of = |first: usize| {
        let mut found = Vec::new();
        index.near(&box_of(first), 0.0, &mut found);
        let others = found.into_iter().map(|at| near[at as usize] as usize);
        // Each pair of two moved triangles once.
        let others = others.filter(|&other| other != first && (other > first || !has_moved(other)));
        let number = |at: usize| u32::try_from(at).expect("fewer than 2^32 triangles");
        let flaw = |other: usize| {
            let flaw = flaw(session, triangle(first), triangle(other))?;
            Some(([number(first), number(other)], flaw))
        };
        others.filter_map(flaw).collect::<Vec<_>>()
    };
    predicament_grid::parallel::each(moved.len(), &|at| pairs_of(moved[at])).into_iter().flatten().collect()
}

fn vertex(v: u32) -> Vertex {
    Vertex::input(v as usize)
}

/// The kind of flaw of two triangles.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Flaw {
    /// The triangles overlap along a common edge, or have the same corners.
    Fold,
    /// The triangles have another point in common.
    Crossing,
}

/// The flaw of two triangles that have more in common than their common vertices and edge, if any.
///
/// # Panics
/// If the scene has no such vertex.
pub fn flaw(session: &dyn Predicates, first: [u32; 3], second: [u32; 3]) -> Option<Flaw> {
    let common: Vec<u32> = first.into_iter().filter(|v| second.contains(v)).collect();
    let [t, u] = [first.map(vertex), second.map(vertex)];
    match common[..] {
        // The same triangle twice, or opposite triangles: a sheet.
        [_, _, _] => Some(Flaw::Fold),
        [p, q] => {
            let apex = |triangle: [u32; 3]| triangle.into_iter().find(|v| !common.contains(v)).map(vertex);
            let ([a, b, c], apices) = (t, [apex(first)?, apex(second)?]);
            let in_plane = session.orient3d(a, b, c, apices[1]).is_zero();
            (in_plane && is_one_side(session, [vertex(p), vertex(q)], apices)).then_some(Flaw::Fold)
        }
        [p] => {
            // On a line from p to another common point, the nearer of the two opposite edges is in the other triangle.
            let opposite = |triangle: [Vertex; 3]| {
                let at = triangle.iter().position(|&v| v == vertex(p)).unwrap_or_default();
                [triangle[(at + 1) % 3], triangle[(at + 2) % 3]]
            };
            let meets = meet(session, opposite(t), u) || meet(session, opposite(u), t);
            meets.then_some(Flaw::Crossing)
        }
        _ => {
            let edges = |[a, b, c]: [Vertex; 3]| [[a, b], [b, c], [c, a]];
            let meets = edges(t).into_iter().any(|edge| meet(session, edge, u))
                || edges(u).into_iter().any(|edge| meet(session, edge, t));
            meets.then_some(Flaw::Crossing)
        }
    }
}

/// True if two vertices in one plane with an edge are on the same side of it.
fn is_one_side(session: &dyn Predicates, [p, q]: [Vertex; 2], [v, w]: [Vertex; 2]) -> bool {
    [Plane::Xy, Plane::Yz, Plane::Zx].into_iter().any(|plane| {
        let [first, second] = [v, w].map(|v| session.orient2d(plane, p, q, v));
        !first.is_zero() && first == second
    })
}

/// True if an edge and a triangle without a common vertex have a point in common.
fn meet(session: &dyn Predicates, [p, q]: [Vertex; 2], [a, b, c]: [Vertex; 3]) -> bool {
    let sides = [p, q].map(|v| session.orient3d(a, b, c, v));
    match sides {
        [Sign::Zero, Sign::Zero] => meet_in_plane(session, [p, q], [a, b, c]),
        [first, second] if first == second => false,
        _ => {
            let turns = [[a, b], [b, c], [c, a]].map(|[u, v]| session.orient3d(p, q, u, v));
            !(turns.contains(&Sign::Positive) && turns.contains(&Sign::Negative))
        }
    }
}

/// True if an edge in the plane of a triangle has a point in common with it.
fn meet_in_plane(session: &dyn Predicates, [p, q]: [Vertex; 2], [a, b, c]: [Vertex; 3]) -> bool {
    let planes = [Plane::Xy, Plane::Yz, Plane::Zx].into_iter();
    let seen = planes.map(|plane| (plane, session.orient2d(plane, a, b, c))).find(|(_, turn)| !turn.is_zero());
    let Some((plane, turn)) = seen else { return true };
    // They are apart if an edge of the triangle has both ends beyond it, or the edge's line has the triangle on one
    // side.
    let beyond = |u: Vertex, v: Vertex| [p, q].iter().all(|&w| session.orient2d(plane, u, v, w) == -turn);
    let sides = [a, b, c].map(|v| session.orient2d(plane, p, q, v));
    let is_aside = !sides[0].is_zero() && sides.iter().all(|side| *side == sides[0]);
    !(beyond(a, b) || beyond(b, c) || beyond(c, a) || is_aside)
}
