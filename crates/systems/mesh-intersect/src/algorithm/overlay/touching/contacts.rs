//! Contacts: where two closed solids meet without a common inside.
//!
//! A regularised intersection is the closure of an open set, so it loses these points, segments and faces.

use std::collections::BTreeMap;

use predicament_mesh::OUTSIDE;
use predicament_predicates::Vertex;

use crate::algorithm::overlay::MeshOverlay;
use crate::answer::{Contact, Contacts};

/// The use of a vertex or an edge by triangles of the overlay.
#[derive(Clone, Copy, Default)]
struct Use {
    /// The meshes that have it, a bit for each.
    meshes: u8,
    /// True if a point beside it is inside of both solids.
    has_inside: bool,
    /// True if it is in a larger contact.
    is_covered: bool,
}

impl MeshOverlay {
    /// The points of both closed solids that are in no solid of interior points of both.
    #[must_use]
    pub fn contacts(&self) -> Contacts {
        let mut contacts = Contacts::default();
        let mut edges: BTreeMap<[Vertex; 2], Use> = BTreeMap::new();
        let mut vertices: BTreeMap<Vertex, Use> = BTreeMap::new();
        let mut add = |[a, b, c]: [Vertex; 3], meshes: u8, sides: [[u32; 2]; 2], is_contact: bool| {
            let has_inside = sides.iter().any(|pair| !pair.contains(&OUTSIDE));
            let mark = |used: &mut Use| {
                used.meshes |= meshes;
                used.has_inside |= has_inside;
                used.is_covered |= is_contact;
            };
            for [v, w] in [[a, b], [b, c], [c, a]] {
                mark(edges.entry([v.min(w), v.max(w)]).or_default());
                mark(vertices.entry(v).or_default());
            }
        };
        for mesh in 0..2 {
            for piece in self.pieces(mesh) {
                let pair = |own: u32| if mesh == 0 { [own, piece.region] } else { [piece.region, own] };
                add(piece.triangle, 1 << mesh, self.meshes()[mesh].sides()[piece.of as usize].map(pair), false);
            }
        }
        for shared in self.shared() {
            let sides = self.sides_of_shared(shared);
            let is_contact = sides.iter().all(|pair| pair.contains(&OUTSIDE));
            add(shared.triangle, 3, sides, is_contact);
            if is_contact {
                match contacts.faces.last_mut() {
                    Some(last) if last.of == shared.of => last.triangles.push(shared.triangle),
                    _ => contacts.faces.push(Contact { of: shared.of, triangles: vec![shared.triangle] }),
                }
            }
        }
        let is_contact = |used: &Use| used.meshes == 3 && !used.has_inside && !used.is_covered;
        for (&ends, used) in &edges {
            if is_contact(used) {
                contacts.segments.push(ends);
                ends.iter().filter_map(|v| vertices.get_mut(v).map(|used| used.is_covered = true)).for_each(drop);
            }
        }
        contacts.points = vertices.iter().filter(|(_, used)| is_contact(used)).map(|(&v, _)| v).collect();
        contacts
    }
}
