//! Subdivisions of the plane: nodes, edges and faces, which may have holes.
//!
//! Each edge is two half-edges, 2e from its first node to its second and 2e + 1 back, with one face on the left of
//! each. Around a node its half-edges are in counterclockwise order; there is no other geometry. Following half-edges
//! along their left side makes *cycles*. A face is inside of at most one cycle, its outer cycle, and outside of any
//! number: the outer cycles of *components* that lie in it. The order around nodes does not determine which face a
//! component is in: [`Subdivision::with_faces`] takes this as input.
//!
//! A [half-edge mesh](crate::HalfEdgeMesh) is not enough here: its faces have one cycle each.

/// The number that identifies nothing.
const NONE: u32 = u32::MAX;

/// A face, as its cycles.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct SubdivisionFace {
    /// The cycle around the face; `None` for the unbounded face.
    pub outer: Option<u32>,
    /// The cycles around components in the face.
    pub inner: Vec<u32>,
}

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
    /// The cycle of each half-edge.
    cycle: Vec<u32>,
    /// A half-edge of each cycle.
    cycles: Vec<u32>,
    /// The component of each node.
    component: Vec<u32>,
    components: usize,
    /// The face of each cycle.
    face: Vec<u32>,
    faces: Vec<SubdivisionFace>,
}

impl Subdivision {
    /// A subdivision with these edges between nodes, not yet with faces. `sort` puts the half-edges that leave a node
    /// in counterclockwise order.
    ///
    /// # Panics
    /// If an edge has a node that does not exist, or there are 2^31 edges or more.
    #[must_use]
    pub fn new(nodes: usize, ends: Vec<[u32; 2]>, mut sort: impl FnMut(u32, &mut [u32])) -> Subdivision {
        let halves = u32::try_from(2 * ends.len()).expect("fewer than 2^31 edges");
        let mut first = vec![0_u32; nodes + 1];
        ends.as_flattened().iter().for_each(|&node| first[node as usize] += 1);
        let mut end = 0;
        for start in &mut first {
            end += *start;
            *start = end;
        }
        let mut around = vec![0; ends.len() * 2];
        for (half, &node) in (0..halves).zip(ends.as_flattened()).rev() {
            let start = &mut first[node as usize];
            *start -= 1;
            around[*start as usize] = half;
        }
        let mut next = vec![NONE; around.len()];
        for (node, range) in (0..).zip(first.windows(2)) {
            let own = &mut around[range[0] as usize..range[1] as usize];
            // Up to two half-edges are in cyclic order anyway.
            if own.len() > 2 {
                sort(node, own);
            }
            // A cycle that arrives along a half-edge continues along the one before it: the next clockwise.
            if let Some(&last) = own.last() {
                own.iter().fold(last, |before, &half| {
                    next[(half ^ 1) as usize] = before;
                    half
                });
            }
        }
        let mut subdivision = Subdivision { ends, first, around, next, ..Subdivision::default() };
        subdivision.walk();
        subdivision.connect(nodes);
        subdivision
    }

    /// Numbers the cycles.
    fn walk(&mut self) {
        self.cycle = vec![NONE; self.next.len()];
        for (half, start) in (0..).zip(0..self.next.len()) {
            if self.cycle[start] != NONE {
                continue;
            }
            let number = u32::try_from(self.cycles.len()).unwrap_or(NONE);
            self.cycles.push(half);
            let mut at = start;
            while self.cycle[at] == NONE {
                self.cycle[at] = number;
                at = self.next[at] as usize;
            }
        }
    }

    /// Numbers the components, components of lower nodes first.
    fn connect(&mut self, nodes: usize) {
        self.component = vec![NONE; nodes];
        let mut open = Vec::new();
        for start in 0..nodes {
            if self.component[start] != NONE {
                continue;
            }
            let number = u32::try_from(self.components).unwrap_or(NONE);
            self.components += 1;
            self.component[start] = number;
            open.push(start);
            while let Some(node) = open.pop() {
                for at in self.first[node]..self.first[node + 1] {
                    let other = self.target(self.around[at as usize]) as usize;
                    if self.component[other] == NONE {
                        self.component[other] = number;
                        open.push(other);
                    }
                }
            }
        }
    }

    /// Adds faces to the subdivision; each cycle gets one inside of it, except for the outer cycles of components in
    /// `nestings`, which belong to the face that contains the component.
    ///
    /// Face 0 is the unbounded face. A component whose face no earlier component in the list has is put into face 0;
    /// the returned flag is true if there was no such component.
    #[must_use]
    pub fn with_faces(mut self, nestings: &[Nesting]) -> (Subdivision, bool) {
        self.face = vec![0; self.cycles.len()];
        for nesting in nestings {
            self.face[self.cycle[nesting.outside as usize] as usize] = NONE;
        }
        self.faces = vec![SubdivisionFace::default()];
        for (cycle, face) in (0..).zip(&mut self.face) {
            if *face != NONE {
                *face = u32::try_from(self.faces.len()).unwrap_or(NONE);
                self.faces.push(SubdivisionFace { outer: Some(cycle), inner: Vec::new() });
            }
        }
        let mut all_known = true;
        for nesting in nestings {
            let cycle = self.cycle[nesting.outside as usize];
            let mut face = nesting.within.map_or(0, |half| self.face[self.cycle[half as usize] as usize]);
            if face == NONE {
                all_known = false;
                face = 0;
            }
            self.face[cycle as usize] = face;
            self.faces[face as usize].inner.push(cycle);
        }
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

    /// The faces, the unbounded one first.
    #[must_use]
    pub fn faces(&self) -> &[SubdivisionFace] {
        &self.faces
    }

    /// A half-edge of each cycle.
    #[must_use]
    pub fn cycles(&self) -> &[u32] {
        &self.cycles
    }

    /// The cycle of a half-edge.
    #[inline]
    #[must_use]
    pub fn cycle(&self, half: u32) -> u32 {
        self.cycle[half as usize]
    }

    /// The face on the left of a half-edge.
    #[inline]
    #[must_use]
    pub fn face(&self, half: u32) -> u32 {
        self.face[self.cycle[half as usize] as usize]
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles with a common corner, and a single edge in one of them.
    fn sample() -> Subdivision {
        let ends = vec![[0, 1], [1, 2], [2, 0], [0, 3], [3, 4], [4, 0], [5, 6]];
        // Around node 0: to 1, 2, 3, 4 in this order.
        let order = [0, 5, 6, 11];
        Subdivision::new(8, ends, |node, halves| {
            assert_eq!((node, halves.len()), (0, 4));
            halves.copy_from_slice(&order);
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
        assert_eq!(subdivision.faces().len(), 3);
        assert_eq!(subdivision.face(1), 0);
        assert_eq!(subdivision.face(12), subdivision.face(6));
        assert_eq!(subdivision.faces()[subdivision.face(6) as usize].inner, [subdivision.cycle(12)]);
        let [vertices, edges, components] = [8, 7, 3];
        assert_eq!(vertices + subdivision.faces().len(), edges + 1 + components, "Euler");
        // In the outside of a component that comes later.
        let wrong = [Nesting { outside: 1, within: Some(12) }, Nesting { outside: 12, within: None }];
        assert!(!sample().with_faces(&wrong).1);
    }
}
