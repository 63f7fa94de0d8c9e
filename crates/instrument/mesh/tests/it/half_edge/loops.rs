//! Meshes as lists of loops: a second check of validity, and a form for comparison. This module uses only the loops of
//! a mesh.

use std::collections::{BTreeMap, BTreeSet};

use predicament_mesh::HalfEdgeMesh;
use predicament_predicates::Vertex;

/// The loops of a mesh as vertices, each in its smallest rotation, in ascending order.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Loops {
    pub faces: Vec<Vec<Vertex>>,
    pub boundaries: Vec<Vec<Vertex>>,
    /// Vertices without edges.
    pub alone: Vec<Vertex>,
}

/// The numbers of vertices, edges, faces and boundary loops.
pub type Counts = [i64; 4];

fn rotated(of: &[Vertex]) -> Vec<Vertex> {
    let rotations = (0..of.len()).map(|at| [&of[at..], &of[..at]].concat());
    rotations.min().unwrap_or_default()
}

impl Loops {
    /// The loops, found by following next from each half-edge, with a list of those visited.
    pub fn of(mesh: &HalfEdgeMesh) -> Loops {
        let (mut faces, mut boundaries) = (Vec::new(), Vec::new());
        let mut seen = BTreeSet::new();
        for first in mesh.half_edges() {
            let mut vertices = Vec::new();
            let mut h = first;
            while seen.insert(h) {
                vertices.push(mesh.scene_vertex(mesh.end(h)));
                h = mesh.next(h);
            }
            if !vertices.is_empty() {
                assert_eq!(h, first, "a loop that does not come back");
                let list = if mesh.face(first).is_some() { &mut faces } else { &mut boundaries };
                list.push(rotated(&vertices));
            }
        }
        faces.sort();
        boundaries.sort();
        let mut alone: Vec<Vertex> = mesh.vertices().map(|v| mesh.scene_vertex(v)).collect();
        let used: BTreeSet<Vertex> = faces.iter().chain(&boundaries).flatten().copied().collect();
        alone.retain(|v| !used.contains(v));
        Loops { faces, boundaries, alone }
    }

    pub fn counts(&self) -> Counts {
        let all = || self.faces.iter().chain(&self.boundaries);
        let vertices = all().flatten().collect::<BTreeSet<_>>().len() + self.alone.len();
        let half_edges: usize = all().map(Vec::len).sum();
        [vertices, half_edges / 2, self.faces.len(), self.boundaries.len()].map(|n| i64::try_from(n).unwrap())
    }

    /// Checks the loops: each directed edge occurs once, and so does its reverse; around each vertex, the step from an
    /// edge to the one before its reverse goes through all of its edges; faces have three corners; the Euler
    /// characteristic is that of closed orientable surfaces when all loops are filled.
    ///
    /// The error says what is wrong.
    pub fn check(&self) -> Result<(), String> {
        let mut after = BTreeMap::new();
        for list in self.faces.iter().chain(&self.boundaries) {
            for (at, &v) in list.iter().enumerate() {
                let [next, last] = [1, 2].map(|more| list[(at + more) % list.len()]);
                if v == next {
                    return Err(format!("an edge from {v} to itself"));
                }
                if after.insert((v, next), last).is_some() {
                    return Err(format!("two edges from {v} to {next}"));
                }
            }
        }
        if let Some(corners) = self.faces.iter().find(|face| face.len() < 3) {
            return Err(format!("a face of corners {corners:?}"));
        }
        let mut degrees: BTreeMap<Vertex, usize> = BTreeMap::new();
        for &(from, to) in after.keys() {
            if !after.contains_key(&(to, from)) {
                return Err(format!("no reverse of the edge from {from} to {to}"));
            }
            *degrees.entry(to).or_default() += 1;
        }
        let mut parts: BTreeMap<Vertex, Vertex> = BTreeMap::new();
        for (&to, &degree) in &degrees {
            let first = after.keys().find(|edge| edge.1 == to).expect("a degree");
            let (mut from, mut steps) = (first.0, 0);
            loop {
                // Leaves `to` along the loop, and returns by the reverse.
                from = after[&(from, to)];
                steps += 1;
                if from == first.0 || steps > degree {
                    break;
                }
            }
            if steps != degree {
                return Err(format!("{degree} edges at {to}, {steps} in one ring"));
            }
        }
        // The component of a vertex is the smallest vertex reached.
        for &start in degrees.keys() {
            let mut waiting = vec![start];
            while let Some(v) = waiting.pop() {
                if parts.contains_key(&v) {
                    continue;
                }
                parts.insert(v, start);
                waiting
                    .extend(after.range((v, Vertex::input(0))..).take_while(|(edge, _)| edge.0 == v).map(|(e, _)| e.1));
            }
        }
        let parts = parts.values().collect::<BTreeSet<_>>().len();
        let [vertices, edges, faces, boundaries] = self.counts();
        let alone = i64::try_from(self.alone.len()).expect("a few");
        let holes = 2 * i64::try_from(parts).expect("a few") - (vertices - alone - edges + faces + boundaries);
        if holes < 0 || holes % 2 != 0 {
            return Err(format!("{parts} parts and twice the genus {holes}"));
        }
        Ok(())
    }
}

fn list(loops: &[&[usize]]) -> Vec<Vec<Vertex>> {
    loops.iter().map(|of| of.iter().map(|&v| Vertex::input(v)).collect()).collect()
}

#[test]
fn the_second_judgement_can_fail() {
    let check = |faces: &[&[usize]], boundaries: &[&[usize]]| {
        Loops { faces: list(faces), boundaries: list(boundaries), alone: Vec::new() }.check()
    };
    let refused = |faces: &[&[usize]], boundaries: &[&[usize]]| check(faces, boundaries).expect_err("refused");
    assert_eq!(check(&[&[0, 1, 2]], &[&[2, 1, 0]]), Ok(()));
    assert!(refused(&[&[0, 1, 2]], &[]).contains("no reverse"));
    assert!(refused(&[&[0, 1, 2], &[0, 1, 3]], &[]).contains("two edges"));
    assert!(refused(&[&[0, 1, 1, 2]], &[]).contains("to itself"));
    assert!(refused(&[&[0, 1]], &[]).contains("a face of"));
    // Two triangles that share a vertex, each with its own boundary; with one common boundary they are valid.
    let pinched: [&[usize]; 2] = [&[0, 1, 2], &[0, 3, 4]];
    assert_eq!(refused(&pinched, &[&[2, 1, 0], &[4, 3, 0]]), "4 edges at 0, 2 in one ring");
    assert_eq!(check(&pinched, &[&[2, 1, 0, 4, 3, 0]]), Ok(()));
}
