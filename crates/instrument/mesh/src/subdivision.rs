//! Subdivisions of the plane: nodes, edges and faces, which may have holes.
//!
//! Each edge is two half-edges, 2e from its first node to its second and 2e + 1 back, with one face on the left of
//! each. Around a node its half-edges are in counterclockwise order; there is no other geometry. Following half-edges
//! along their left side makes *cycles*. A face is inside of at most one cycle, its outer cycle, and outside of any
//! number: the outer cycles of *components* that lie in it. The order around nodes does not determine which face a
//! component is in: [`Subdivision::with_faces`] takes this as input.
//!
//! A [half-edge mesh](crate::HalfEdgeMesh) is not enough here: its faces have one cycle each.

use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use rayon::prelude::*;

/// The number that identifies nothing.
const NONE: u32 = u32::MAX;
/// The number of edges below which one thread does everything.
const ALONE: usize = 1 << 14;

/// The location of a component.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Nesting {
    /// A half-edge with the outside of the component on its left.
    pub outside: u32,
    /// A half-edge of another component, with the face that contains this component on its left.
    ///
    /// `None` if the component is in the unbounded face.
    pub within: Option<u32>,
}

/// A subdivision of the plane.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Subdivision {
    ends: Vec<[u32; 2]>,
    /// The index of each node's first half-edge in `around`, and their total number.
    first: Vec<u32>,
    around: Vec<u32>,
    next: Vec<u32>,
    /// The face on the left of each half-edge; its cycle as long as there are no faces.
    left: Vec<u32>,
    /// A half-edge of each cycle, the lowest.
    cycles: Vec<u32>,
    /// The component of each node.
    component: Vec<u32>,
    components: usize,
    /// The cycle around each face; `NONE` for the unbounded face.
    outer: Vec<u32>,
    /// The other cycles, around components: each with its face.
    inner: Vec<[u32; 2]>,
}

/// Puts half-edges in counterclockwise order around each of several consecutive nodes.
///
/// It gets the first node, the place of each node's first half-edge in a list, with the list's length, and the list.
pub type Sort<'a> = &'a (dyn Fn(usize, &[u32], &mut [u32]) + Sync);

impl Subdivision {
    /// A subdivision with these edges between nodes, not yet with faces.
    ///
    /// `sort` orders the half-edges that leave a node, if there are more than two. Several threads may call it.
    ///
    /// # Panics
    /// If an edge has a node that does not exist, or there are 2^31 edges or more.
    #[must_use]
    pub fn new(nodes: usize, ends: Vec<[u32; 2]>, sort: Sort<'_>) -> Subdivision {
        u32::try_from(2 * ends.len()).expect("fewer than 2^31 edges");
        let threads = if ends.len() < ALONE { 1 } else { rayon::current_num_threads() };
        // Each thread has nodes of its own.
        let parts = threads.min(nodes).max(1);
        let part = |part: usize| leaving(&ends, nodes * part / parts..nodes * (part + 1) / parts);
        let mut lists: Vec<(Vec<u32>, Vec<u32>)> =
            if parts == 1 { vec![part(0)] } else { (0..parts).into_par_iter().map(part).collect() };
        let sorted = |(part, (first, mut around)): (usize, (Vec<u32>, Vec<u32>))| {
            sort(nodes * part / parts, &first, &mut around);
            (first, around)
        };
        let (first, around, next) = if let [list] = &mut lists[..] {
            let (first, around) = sorted((0, std::mem::take(list)));
            let mut next = vec![NONE; 2 * ends.len()];
            link(&first, &around, |half, after| next[half as usize] = after);
            (first, around, next)
        } else {
            let next: Vec<AtomicU32> = std::iter::repeat_with(|| AtomicU32::new(NONE)).take(2 * ends.len()).collect();
            let linked = |list| {
                let (first, around) = sorted(list);
                link(&first, &around, |half, after| next[half as usize].store(after, Relaxed));
                (first, around)
            };
            let (first, around) = joined(lists.into_par_iter().enumerate().map(linked).collect());
            (first, around, next.into_iter().map(AtomicU32::into_inner).collect())
        };
        let mut subdivision = Subdivision { ends, first, around, next, ..Subdivision::default() };
        let [walk, connect]: [&(dyn Fn() -> (Vec<u32>, Vec<u32>) + Sync); 2] =
            [&|| subdivision.walk(), &|| subdivision.connect(nodes)];
        let (walked, connected) = if threads == 1 { (walk(), connect()) } else { rayon::join(walk, connect) };
        (subdivision.left, subdivision.cycles) = walked;
        subdivision.component = connected.0;
        subdivision.components = connected.1.len();
        subdivision
    }

    /// The cycle of each half-edge, and a half-edge of each cycle, the lowest.
    fn walk(&self) -> (Vec<u32>, Vec<u32>) {
        let mut cycle = vec![NONE; self.next.len()];
        let mut cycles = Vec::new();
        for (half, start) in (0..).zip(0..self.next.len()) {
            if cycle[start] != NONE {
                continue;
            }
            let number = u32::try_from(cycles.len()).unwrap_or(NONE);
            cycles.push(half);
            let mut at = start;
            while cycle[at] == NONE {
                cycle[at] = number;
                at = self.next[at] as usize;
            }
        }
        (cycle, cycles)
    }

    /// The component of each node, and the lowest node of each component, ascending.
    fn connect(&self, nodes: usize) -> (Vec<u32>, Vec<u32>) {
        // For each node a lower one of its component, or itself.
        let mut lower: Vec<u32> = (0..).take(nodes).collect();
        for &[a, b] in &self.ends {
            let [a, b] = [root(&mut lower, a), root(&mut lower, b)];
            lower[a.max(b) as usize] = a.min(b);
        }
        let mut roots = Vec::new();
        for node in 0..nodes {
            lower[node] = match lower[node] as usize {
                own if own == node => {
                    roots.push(lower[node]);
                    u32::try_from(roots.len() - 1).unwrap_or(NONE)
                }
                // A lower node, whose component is known.
                other => lower[other],
            };
        }
        (lower, roots)
    }

    /// Adds faces to the subdivision; each cycle gets one inside of it, except for the outer cycles of components in
    /// `nestings`, which belong to the face that contains the component.
    ///
    /// Face 0 is the unbounded face. A component whose face no earlier component in the list has is put into face 0;
    /// the returned flag is true if there was no such component.
    #[must_use]
    pub fn with_faces(mut self, nestings: &[Nesting]) -> (Subdivision, bool) {
        if !self.outer.is_empty() {
            (self.left, _) = self.walk();
        }
        let mut faces = vec![0; self.cycles.len()];
        for nesting in nestings {
            faces[self.left[nesting.outside as usize] as usize] = NONE;
        }
        self.outer = vec![NONE];
        self.outer.reserve(faces.len());
        self.inner = Vec::with_capacity(nestings.len());
        for (cycle, face) in (0..).zip(&mut faces) {
            if *face != NONE {
                *face = u32::try_from(self.outer.len()).unwrap_or(NONE);
                self.outer.push(cycle);
            }
        }
        let mut all_known = true;
        for nesting in nestings {
            let cycle = self.left[nesting.outside as usize];
            let mut face = nesting.within.map_or(0, |half| faces[self.left[half as usize] as usize]);
            if face == NONE {
                all_known = false;
                face = 0;
            }
            faces[cycle as usize] = face;
            self.inner.push([face, cycle]);
        }
        self.left.iter_mut().for_each(|left| *left = faces[*left as usize]);
        (self, all_known)
    }

    /// The number of nodes, including those without edges.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.component.len()
    }

    /// The nodes of each edge.
    #[must_use]
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.ends
    }

    /// The number of components; a node without edges is a component.
    #[must_use]
    pub fn components(&self) -> usize {
        self.components
    }

    /// The component of a node.
    #[must_use]
    pub fn component(&self, node: u32) -> u32 {
        self.component[node as usize]
    }

    /// The number of faces; face 0 is the unbounded one.
    #[must_use]
    pub fn faces(&self) -> usize {
        self.outer.len()
    }

    /// The cycle around a face; `None` for the unbounded face.
    #[must_use]
    pub fn outer(&self, face: u32) -> Option<u32> {
        Some(self.outer[face as usize]).filter(|&cycle| cycle != NONE)
    }

    /// The outer cycles of components, each after the face that contains the component.
    #[must_use]
    pub fn inner(&self) -> &[[u32; 2]] {
        &self.inner
    }

    /// A half-edge of each cycle.
    #[must_use]
    pub fn cycles(&self) -> &[u32] {
        &self.cycles
    }

    /// The face on the left of a half-edge.
    #[inline]
    #[must_use]
    pub fn face(&self, half: u32) -> u32 {
        self.left[half as usize]
    }

    /// The faces on the left and on the right of each edge, seen from its first node.
    #[inline]
    #[must_use]
    pub fn sides(&self) -> &[[u32; 2]] {
        self.left.as_chunks().0
    }

    /// The next half-edge along the same face.
    #[inline]
    #[must_use]
    pub fn next(&self, half: u32) -> u32 {
        self.next[half as usize]
    }

    /// The node where a half-edge begins.
    #[inline]
    #[must_use]
    pub fn origin(&self, half: u32) -> u32 {
        self.ends[half as usize / 2][half as usize % 2]
    }

    /// The node where a half-edge ends.
    #[inline]
    #[must_use]
    pub fn target(&self, half: u32) -> u32 {
        self.origin(half ^ 1)
    }

    /// The half-edges that leave a node; counterclockwise if there are more than two.
    #[inline]
    #[must_use]
    pub fn leaving(&self, node: u32) -> &[u32] {
        &self.around[self.first[node as usize] as usize..self.first[node as usize + 1] as usize]
    }

    /// The half-edges of a cycle, starting with this half-edge.
    pub fn walk_from(&self, half: u32) -> impl Iterator<Item = u32> + '_ {
        let mut at = Some(half);
        std::iter::from_fn(move || {
            let here = at?;
            let next = self.next(here);
            at = (next != half).then_some(next);
            Some(here)
        })
    }
}

/// The lowest known node of a node's component.
fn root(lower: &mut [u32], mut node: u32) -> u32 {
    while lower[node as usize] != node {
        lower[node as usize] = lower[lower[node as usize] as usize];
        node = lower[node as usize];
    }
    node
}

/// The half-edges that leave some nodes, ascending for each node; before them the first place of each node, and the
/// number of half-edges.
fn leaving(ends: &[[u32; 2]], nodes: Range<usize>) -> (Vec<u32>, Vec<u32>) {
    let place = |node: u32| Some((node as usize).wrapping_sub(nodes.start)).filter(|&at| at < nodes.len());
    let mut first = vec![0_u32; nodes.len() + 1];
    ends.as_flattened().iter().filter_map(|&node| place(node)).for_each(|at| first[at] += 1);
    let mut end = 0;
    for start in &mut first {
        end += *start;
        *start = end;
    }
    let mut around = vec![0; end as usize];
    let halves = u32::try_from(2 * ends.len()).unwrap_or(NONE);
    for (half, &node) in (0..halves).zip(ends.as_flattened()).rev() {
        if let Some(at) = place(node) {
            first[at] -= 1;
            around[first[at] as usize] = half;
        }
    }
    (first, around)
}

/// Finds the next half-edge of each one that arrives at some nodes: the next clockwise around its node, which is before
/// it in the order around the node. `set` gets both.
fn link(first: &[u32], around: &[u32], mut set: impl FnMut(u32, u32)) {
    for range in first.windows(2) {
        let own = &around[range[0] as usize..range[1] as usize];
        if let Some(&last) = own.last() {
            own.iter().fold(last, |before, &half| {
                set(half ^ 1, before);
                half
            });
        }
    }
}

/// The lists of consecutive nodes as one.
fn joined(lists: Vec<(Vec<u32>, Vec<u32>)>) -> (Vec<u32>, Vec<u32>) {
    let count = lists.iter().map(|(first, _)| first.len() - 1).sum::<usize>();
    let mut first = Vec::with_capacity(count + 1);
    let mut around = Vec::with_capacity(lists.iter().map(|(_, around)| around.len()).sum());
    first.push(0);
    for (own, halves) in lists {
        let before = u32::try_from(around.len()).unwrap_or(NONE);
        first.extend(own[1..].iter().map(|end| before + end));
        around.extend(halves);
    }
    (first, around)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles with a common corner, and a single edge in one of them.
    fn sample() -> Subdivision {
        let ends = vec![[0, 1], [1, 2], [2, 0], [0, 3], [3, 4], [4, 0], [5, 6]];
        // Around node 0: to 1, 2, 3, 4 in this order.
        Subdivision::new(8, ends, &|node, first, halves| {
            assert_eq!(node, 0);
            assert_eq!(first, [0, 4, 6, 8, 10, 12, 13, 14, 14]);
            halves[..4].copy_from_slice(&[0, 5, 6, 11]);
        })
    }

    #[test]
    fn cycles_follow_the_order_around_nodes() {
        let subdivision = sample();
        assert_eq!(subdivision.cycles().len(), 4);
        assert_eq!(subdivision.walk_from(0).collect::<Vec<_>>(), [0, 2, 4]);
        assert_eq!(subdivision.walk_from(6).collect::<Vec<_>>(), [6, 8, 10]);
        assert_eq!(subdivision.walk_from(1).collect::<Vec<_>>(), [1, 11, 9, 7, 5, 3], "around both");
        assert_eq!(subdivision.walk_from(12).collect::<Vec<_>>(), [12, 13]);
        assert_eq!((subdivision.nodes(), subdivision.components()), (8, 3), "the last node is alone");
    }

    #[test]
    fn faces_have_the_components_that_they_are_told() {
        let nestings = [Nesting { outside: 1, within: None }, Nesting { outside: 12, within: Some(6) }];
        let (subdivision, all_known) = sample().with_faces(&nestings);
        assert!(all_known);
        // The unbounded face, and one face for each triangle.
        assert_eq!(subdivision.faces(), 3);
        assert_eq!(subdivision.face(1), 0);
        assert_eq!(subdivision.face(12), subdivision.face(6));
        let cycle_of = |half: u32| {
            subdivision.cycles().iter().position(|&first| subdivision.walk_from(first).any(|other| other == half))
        };
        for ((half, place), within) in [1, 12].into_iter().zip(subdivision.inner()).zip([0, subdivision.face(6)]) {
            assert_eq!((place[0], Some(place[1] as usize)), (within, cycle_of(half)));
        }
        let [vertices, edges, components] = [8, 7, 3];
        assert_eq!(vertices + subdivision.faces(), edges + 1 + components, "Euler");
        // In the outside of a component that comes later.
        let wrong = [Nesting { outside: 1, within: Some(12) }, Nesting { outside: 12, within: None }];
        assert!(!sample().with_faces(&wrong).1);
    }
}
