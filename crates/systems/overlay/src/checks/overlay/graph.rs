//! Checks that nodes, edges and faces form the arrangement of segments.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use rug::Rational;

use super::plane::{Common, Neighbours, Point, area, distance, is_on, side};
use super::{Check, Expected, Flaw, Flaws, stride};

/// An arrangement under test.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Graph {
    /// The position of each node.
    pub nodes: Vec<Point>,
    /// The segments as pairs of ends.
    pub segments: Vec<[Point; 2]>,
    /// The nodes on each segment, from its first end to its second.
    pub chains: Vec<Vec<u32>>,
    /// The edges. The half-edges of edge e are 2e, from the first of its nodes to the second, and 2e + 1 back.
    pub edges: Vec<[u32; 2]>,
    /// The next half-edge of each half-edge along the face on its left.
    pub next: Vec<u32>,
    /// The face on the left of each half-edge.
    pub face: Vec<u32>,
    /// The number of faces.
    pub faces: usize,
}

impl Graph {
    /// The laws of arrangements that it violates.
    #[must_use]
    pub fn flaws(&self, expected: Expected) -> Vec<Flaw> {
        let mut flaws = Flaws::default();
        if expected.has_areas {
            self.nodes(&mut flaws);
        }
        self.chains(expected, &mut flaws);
        self.crossings(expected, &mut flaws);
        self.euler(&mut flaws);
        if self.boundaries(&mut flaws) {
            self.nesting(expected, &mut flaws);
        }
        flaws.0
    }

    fn node(&self, node: u32) -> &Point {
        &self.nodes[node as usize]
    }

    fn edge(&self, edge: usize) -> [&Point; 2] {
        self.edges[edge].map(|node| self.node(node))
    }

    fn origin(&self, half: usize) -> u32 {
        self.edges[half / 2][half % 2]
    }

    fn nodes(&self, flaws: &mut Flaws) {
        let mut order: Vec<usize> = (0..self.nodes.len()).collect();
        order.sort_by(|&a, &b| self.nodes[a].cmp(&self.nodes[b]));
        for pair in order.windows(2).filter(|pair| self.nodes[pair[0]] == self.nodes[pair[1]]) {
            flaws.add(Check::Nodes, || format!("nodes {} and {} are at one place", pair[0], pair[1]));
        }
    }

    fn chains(&self, expected: Expected, flaws: &mut Flaws) {
        let sorted = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
        let edges: BTreeSet<[u32; 2]> = self.edges.iter().copied().map(sorted).collect();
        let mut passed = BTreeSet::new();
        for (at, ([a, b], chain)) in self.segments.iter().zip(&self.chains).enumerate() {
            let ends = [chain.first(), chain.last()].map(|node| node.map(|&node| self.node(node)));
            let mut is_right = ends == [Some(a), Some(b)];
            for pair in chain.windows(2) {
                let [p, q] = [self.node(pair[0]), self.node(pair[1])];
                // Along the segment, even if nodes are rounded and beside it.
                let along = |i: usize| Rational::from(&q[i] - &p[i]) * Rational::from(&b[i] - &a[i]);
                is_right &= (along(0) + along(1)).cmp0().is_gt() || p == q && !expected.has_areas;
                if pair[0] != pair[1] {
                    is_right &= edges.contains(&sorted([pair[0], pair[1]]));
                    passed.insert(sorted([pair[0], pair[1]]));
                }
            }
            if !is_right {
                flaws.add(Check::Chain, || format!("segment {at} is not covered by its {} nodes", chain.len()));
            }
            for &node in chain.iter().filter(|&&node| !is_on(a, b, self.node(node))) {
                flaws.add(Check::OnSegment, || {
                    format!("node {node} is {:e} off segment {at}", distance(a, b, self.node(node)))
                });
            }
        }
        for edge in edges.difference(&passed) {
            flaws.add(Check::Edges, || format!("the edge of nodes {} and {} is not on a segment", edge[0], edge[1]));
        }
        if edges.len() != self.edges.len() {
            flaws.add(Check::Edges, || format!("{} edges, {} of them different", self.edges.len(), edges.len()));
        }
        if self.segments.len() != self.chains.len() {
            flaws.add(Check::Chain, || format!("{} segments, {} chains", self.segments.len(), self.chains.len()));
        }
    }

    fn crossings(&self, expected: Expected, flaws: &mut Flaws) {
        let Some(neighbours) = Neighbours::new((0..self.edges.len()).map(|edge| self.edge(edge)).collect()) else {
            return;
        };
        let mut near = Vec::new();
        for edge in (0..self.edges.len()).step_by(stride(self.edges.len(), expected.edges_crossed)) {
            neighbours.of(edge, &mut near);
            for other in near.iter().map(|&other| other as usize).filter(|&other| other != edge) {
                let is_wrong = match neighbours.common(edge, other) {
                    Common::Nothing => false,
                    Common::Crossing => true,
                    Common::Touch => expected.has_areas,
                };
                if is_wrong {
                    flaws.add(Check::Crossing, || format!("edges {edge} and {other} meet between their nodes"));
                }
            }
        }
    }

    /// The number of components, counted independently.
    fn components(&self) -> usize {
        let mut class: Vec<usize> = (0..self.nodes.len()).collect();
        let root = |class: &mut Vec<usize>, mut node: usize| {
            while class[node] != node {
                class[node] = class[class[node]];
                node = class[node];
            }
            node
        };
        let mut count = self.nodes.len();
        for [a, b] in &self.edges {
            let [a, b] = [*a, *b].map(|node| root(&mut class, node as usize));
            if a != b {
                class[a] = b;
                count -= 1;
            }
        }
        count
    }

    fn euler(&self, flaws: &mut Flaws) {
        let [v, e, f, c] = [self.nodes.len(), self.edges.len(), self.faces, self.components()];
        if v + f != e + 1 + c {
            flaws.add(Check::Euler, || format!("V = {v}, E = {e}, F = {f}, C = {c}"));
        }
    }

    /// Checks that the half-edges along faces form cycles, each of one face; returns true if they do.
    fn boundaries(&self, flaws: &mut Flaws) -> bool {
        let halves = 2 * self.edges.len();
        if self.next.len() != halves || self.face.len() != halves {
            flaws.add(Check::Boundary, || {
                format!("{halves} half-edges, {} of them with a next half-edge", self.next.len())
            });
            return false;
        }
        let mut comes = vec![0_u32; halves];
        for (half, &next) in self.next.iter().enumerate() {
            let is_right = (next as usize) < halves
                && self.origin(next as usize) == self.origin(half ^ 1)
                && self.face[half] == self.face[next as usize]
                && (self.face[half] as usize) < self.faces;
            if !is_right {
                flaws.add(Check::Boundary, || format!("the next half-edge of {half} is {next}"));
                return false;
            }
            comes[next as usize] += 1;
        }
        if let Some(half) = comes.iter().position(|&times| times != 1) {
            flaws.add(Check::Boundary, || format!("half-edge {half} follows {} others", comes[half]));
            return false;
        }
        true
    }

    /// Checks that each bounded face has one outer cycle, and that components are in the right faces.
    fn nesting(&self, expected: Expected, flaws: &mut Flaws) {
        let mut seen = vec![false; self.next.len()];
        let mut outer = vec![0_usize; self.faces];
        let mut inner: Vec<usize> = Vec::new();
        for start in 0..self.next.len() {
            if seen[start] {
                continue;
            }
            let mut cycle = Vec::new();
            let mut half = start;
            while !std::mem::replace(&mut seen[half], true) {
                cycle.push(half);
                half = self.next[half] as usize;
            }
            let points = cycle.iter().map(|&half| [half, half ^ 1].map(|half| self.node(self.origin(half))));
            match area(points).cmp0() {
                Ordering::Greater => outer[self.face[start] as usize] += 1,
                // The outside of a component; without areas this cannot be decided.
                _ if expected.has_areas => {
                    inner.push(cycle.into_iter().min_by_key(|&half| self.node(self.origin(half))).unwrap_or(start))
                }
                _ => {}
            }
        }
        if !expected.has_areas {
            return;
        }
        for (face, &count) in outer.iter().enumerate().filter(|&(face, &count)| count != usize::from(face > 0)) {
            flaws.add(Check::Boundary, || format!("face {face} has {count} outer boundaries"));
        }
        for &half in inner.iter().step_by(stride(inner.len(), expected.located)) {
            let found = self.above(self.node(self.origin(half))).map_or(0, |half| self.face[half]);
            if found != self.face[half] {
                let said = self.face[half];
                flaws.add(Check::Nesting, || format!("a component in face {found} is reported in face {said}"));
            }
        }
    }

    /// The half-edge whose face, on its left, contains the points just left of a point: it is the lowest edge that a
    /// line a little left of the point meets above it.
    fn above(&self, from: &Point) -> Option<usize> {
        let mut best: Option<[usize; 2]> = None;
        for edge in 0..self.edges.len() {
            let [a, b] = self.edge(edge);
            let [left, right] = [a, b].map(|p| p[0] < from[0]);
            if left == right {
                continue;
            }
            // From left to right, the point is on the right of an edge above it.
            let half = if left { 2 * edge } else { 2 * edge + 1 };
            let ends = [half, half ^ 1];
            let at = |half: usize| self.node(self.origin(half));
            if side(at(ends[0]), at(ends[1]), from).is_ge() {
                continue;
            }
            let is_lower = |[c, d]: [usize; 2]| {
                let [p, q, r, s] = [ends[0], ends[1], c, d].map(at);
                // The left end that is further right decides, or the right ends if the left ends are equal.
                match if p == r {
                    side(r, s, q)
                } else if p < r {
                    side(p, q, r).reverse()
                } else {
                    side(r, s, p)
                } {
                    Ordering::Less => true,
                    Ordering::Greater => false,
                    Ordering::Equal => side(r, s, q).is_lt(),
                }
            };
            if best.is_none_or(is_lower) {
                best = Some(ends);
            }
        }
        best.map(|[half, _]| half ^ 1)
    }
}
