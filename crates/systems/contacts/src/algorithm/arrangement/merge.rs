//! Merging of registered points by union-find, and the order of points along each edge.

use predicament_mesh::{Complex, Simplex};
use predicament_predicates::Scene;

use super::order::{self, On};
use super::{Arrangement, MergedPoint, Side};
use crate::algorithm::pairs::{Contact, Contacts};

pub(super) fn merge(scene: &Scene, complexes: [&Complex; 2], contacts: &Contacts) -> Arrangement {
    let counts = complexes.map(|complex| complex.vertices().len());
    let node = |side: Side, index: u32| index as usize + if side == Side::A { 0 } else { counts[0] };

    let mut classes = Classes::new(counts[0] + counts[1]);
    for contact in &contacts.registered {
        if let [Simplex { rank: 0, index: i }, Simplex { rank: 0, index: j }] = [contact.a, contact.b] {
            classes.unite(node(Side::A, i), node(Side::B, j));
        }
    }

    // The root of a class is its lowest node, so points are in the order of their first vertices.
    let mut points: Vec<MergedPoint> = Vec::new();
    let mut of_node = vec![usize::MAX; counts[0] + counts[1]];
    for (side, complex) in Side::BOTH.into_iter().zip(complexes) {
        for (index, &vertex) in (0_u32..).zip(complex.vertices()) {
            let node = node(side, index);
            let root = classes.root(node);
            if root == node {
                of_node[node] = points.len();
                points.push(MergedPoint::default());
            }
            of_node[node] = of_node[root];
            points[of_node[node]].vertices[side as usize].push(vertex);
        }
    }

    let mut registrations = Vec::with_capacity(contacts.registered.len());
    for contact in &contacts.registered {
        let point = match [contact.a, contact.b] {
            [Simplex { rank: 0, index }, _] => of_node[node(Side::A, index)],
            [_, Simplex { rank: 0, index }] => of_node[node(Side::B, index)],
            _ => {
                points.push(MergedPoint::default());
                points.len() - 1
            }
        };
        for (side, simplex, weights) in sides(contact) {
            if simplex.rank > 0 {
                points[point].inside[side as usize].push((simplex, weights));
            }
        }
        registrations.push(point);
    }
    // Contacts come by level, but the entries of a point come from several pairs.
    for inside in points.iter_mut().flat_map(|point| &mut point.inside) {
        inside.sort_by_key(|&(simplex, _)| simplex);
    }

    let (of_a, of_b) = of_node.split_at(counts[0]);
    let vertices = [of_a.to_vec(), of_b.to_vec()];
    let paths = Side::BOTH.map(|side| paths(scene, side, complexes, contacts, &registrations, &vertices));
    Arrangement { points, vertices, registrations, paths }
}

fn sides(contact: &Contact) -> [(Side, Simplex, crate::algorithm::pairs::Weights); 2] {
    [(Side::A, contact.a, contact.on_a), (Side::B, contact.b, contact.on_b)]
}

fn paths(
    scene: &Scene,
    side: Side,
    complexes: [&Complex; 2],
    contacts: &Contacts,
    registrations: &[usize],
    vertices: &[Vec<usize>; 2],
) -> Vec<Vec<usize>> {
    let [complex, other] = [side, side.other()].map(|side| complexes[side as usize]);
    let mut between: Vec<Vec<On>> = vec![Vec::new(); complex.edges().len()];
    for (contact, &point) in contacts.registered.iter().zip(registrations) {
        let of = sides(contact);
        let (_, simplex, weights) = of[side as usize];
        let (_, with, _) = of[side.other() as usize];
        if simplex.rank == 1 {
            let vertex = (with.rank == 0).then(|| other.vertices()[with.index as usize]);
            between[simplex.index as usize].push(On { vertex, weight: weights[1], point });
        }
    }
    let end = |vertex| {
        let place = complex.vertices().binary_search(&vertex).expect("an edge's ends are in its complex");
        vertices[side as usize][place]
    };
    let edges = complex.edges().iter().zip(between);
    edges
        .map(|(&[from, to], between)| {
            let inner = order::along(scene, [from, to], between);
            let mut path: Vec<usize> = std::iter::once(end(from)).chain(inner).chain([end(to)]).collect();
            path.dedup();
            path
        })
        .collect()
}

/// A union-find structure; the root of a class is its lowest member.
struct Classes {
    parents: Vec<usize>,
}

impl Classes {
    fn new(count: usize) -> Classes {
        Classes { parents: (0..count).collect() }
    }

    fn root(&mut self, mut node: usize) -> usize {
        while self.parents[node] != node {
            self.parents[node] = self.parents[self.parents[node]];
            node = self.parents[node];
        }
        node
    }

    fn unite(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b)] = a.min(b);
    }
}
