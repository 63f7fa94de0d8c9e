//! The topology of a list of triangles: is it a surface, and which one?
//!
//! The definitions are combinatorial. A list is an oriented surface if each side of a triangle is a side of at most one
//! other triangle, in the opposite direction, and the triangles around each vertex are one fan. The classification of
//! surfaces says that each component is then given by its Euler characteristic and its number of boundary loops. The
//! genus follows from both.

use std::collections::BTreeMap;

use predicament_predicates::Vertex;

/// One component of a surface.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Component {
    /// Vertices minus edges plus triangles.
    pub euler: i64,
    /// The number of boundary loops.
    pub loops: usize,
}

impl Component {
    /// The genus: the number of handles.
    #[must_use]
    pub fn genus(self) -> i64 {
        let loops = i64::try_from(self.loops).unwrap_or(i64::MAX);
        (2 - loops - self.euler) / 2
    }
}

impl std::fmt::Display for Component {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Euler characteristic {} with {} boundary loops", self.euler, self.loops)
    }
}

/// The reason why triangles are not an oriented surface.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Flaw {
    /// A triangle has a vertex twice.
    Repeated(usize),
    /// Two triangles have one side in the same direction.
    Side([Vertex; 2]),
    /// The triangles around a vertex are not one fan.
    Fans(Vertex),
}

impl std::fmt::Display for Flaw {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Flaw::Repeated(at) => write!(f, "triangle {at} has a vertex twice"),
            Flaw::Side([a, b]) => write!(f, "two triangles have the side from {a} to {b}"),
            Flaw::Fans(v) => write!(f, "the triangles around vertex {v} are not one fan"),
        }
    }
}

/// The components of a surface in ascending order, by their vertices' smallest indices collected, then sorted.
///
/// # Errors
/// The first [`Flaw`].
pub fn components(triangles: &[[Vertex; 3]]) -> Result<Vec<Component>, Flaw> {
    let mut sides: BTreeMap<[Vertex; 2], usize> = BTreeMap::new();
    for (at, &[a, b, c]) in triangles.iter().enumerate() {
        if a == b || b == c || c == a {
            return Err(Flaw::Repeated(at));
        }
        for side in [[a, b], [b, c], [c, a]] {
            if sides.insert(side, at).is_some() {
                return Err(Flaw::Side(side));
            }
        }
    }
    let mut parts = Parts::default();
    // Around each vertex the step from each triangle to the next one: from the side that leaves it to the side that
    // comes to it.
    let mut around: BTreeMap<Vertex, BTreeMap<Vertex, Vertex>> = BTreeMap::new();
    for &[a, b, c] in triangles {
        for [v, from, to] in [[a, b, c], [b, c, a], [c, a, b]] {
            around.entry(v).or_default().insert(from, to);
        }
        parts.join(a, b);
        parts.join(b, c);
    }
    for (&v, steps) in &around {
        if !is_fan(steps) {
            return Err(Flaw::Fans(v));
        }
    }
    let mut all: BTreeMap<Vertex, Component> = BTreeMap::new();
    let mut add = |v: Vertex, euler: i64, loops: usize| {
        let component = all.entry(parts.root(v)).or_insert(Component { euler: 0, loops: 0 });
        component.euler += euler;
        component.loops += loops;
    };
    around.keys().for_each(|&v| add(v, 1, 0));
    triangles.iter().for_each(|corners| add(corners[0], 1, 0));
    // Edges, once each; the sides without an opposite are the boundary.
    let mut open: BTreeMap<Vertex, Vertex> = BTreeMap::new();
    for &[a, b] in sides.keys() {
        let has_opposite = sides.contains_key(&[b, a]);
        if a < b || !has_opposite {
            add(a, -1, 0);
        }
        if !has_opposite {
            open.insert(a, b);
        }
    }
    while let Some((first, mut at)) = open.pop_first() {
        add(first, 0, 1);
        while let Some(next) = open.remove(&at) {
            at = next;
        }
    }
    let mut all: Vec<Component> = all.into_values().collect();
    all.sort_unstable();
    Ok(all)
}

/// True if the steps around a vertex are one path or one cycle.
fn is_fan(steps: &BTreeMap<Vertex, Vertex>) -> bool {
    let targets: Vec<Vertex> = steps.values().copied().collect();
    let start = steps.keys().copied().find(|from| !targets.contains(from));
    let Some(start) = start.or_else(|| steps.keys().next().copied()) else { return true };
    let (mut at, mut count) = (start, 0);
    while let Some(&next) = steps.get(&at) {
        (at, count) = (next, count + 1);
        if next == start {
            break;
        }
    }
    count == steps.len()
}

/// Sets of connected vertices.
#[derive(Default)]
struct Parts(BTreeMap<Vertex, Vertex>);

impl Parts {
    fn root(&mut self, v: Vertex) -> Vertex {
        let mut root = v;
        while let Some(&up) = self.0.get(&root) {
            root = up;
        }
        let mut at = v;
        while at != root {
            let up = self.0.insert(at, root);
            at = up.unwrap_or(root);
        }
        root
    }

    fn join(&mut self, a: Vertex, b: Vertex) {
        let [a, b] = [self.root(a), self.root(b)];
        if a != b {
            self.0.insert(a.max(b), a.min(b));
        }
    }
}
