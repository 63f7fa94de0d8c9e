//! The check that a closed curve enters a closed surface as often as it leaves it.

use std::collections::{BTreeMap, BTreeSet};

use crate::answer::Contacts;
use crate::answer::Side;
use predicament_mesh::Complex;
use predicament_predicates::{Predicates, Sign, Vertex};

use super::orient::Oriented;
use super::{NotOriented, oriented_curve, oriented_surface};

/// The piercings of one component of a surface by one component of a curve.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Piercings {
    /// The number of registered piercings in one direction.
    pub forward: usize,
    /// The number of registered piercings in the other direction.
    pub backward: usize,
    /// The number of registered piercings by an edge with neither end strictly on a side of the triangle.
    pub undecided: usize,
    /// The number of registered degeneracies between the two. Their effect on the count depends on the locations of
    /// merged points and on the division of their triangles.
    pub degenerate: usize,
}

impl Piercings {
    /// True if the law applies: it is about transversal piercings.
    #[must_use]
    pub fn is_applicable(&self) -> bool {
        self.degenerate == 0
    }

    /// True if the law applies and is broken.
    #[must_use]
    pub fn is_violated(&self) -> bool {
        self.is_applicable() && (self.forward != self.backward || self.undecided > 0)
    }
}

/// Counts the piercings of a closed surface by a closed curve, for each pair of components with a registered contact,
/// in order.
///
/// The surface is the triangles of `surface`, the curve the edges of the other complex.
///
/// `session` decides the side of a triangle that an edge's end is on. Use the exact session or, for contacts with
/// broken ties, the session that broke them.
///
/// # Errors
/// [`NotOriented`] if the one is not a closed curve or the other not an orientable closed surface.
pub fn piercings<S: Predicates + ?Sized>(
    session: &S,
    complexes: [&Complex; 2],
    surface: Side,
    contacts: &Contacts,
) -> Result<BTreeMap<[usize; 2], Piercings>, NotOriented> {
    let curve = surface.other();
    let (wires, skin) = (complexes[curve as usize], complexes[surface as usize]);
    let edges = oriented_curve(wires, curve)?;
    let triangles = oriented_surface(skin, surface)?;

    let of_wire = components(wires.edges(), &edges);
    let of_skin = components(skin.triangles(), &triangles);

    let mut piercings: BTreeMap<[usize; 2], Piercings> = BTreeMap::new();
    for contact in &contacts.registered {
        let (on_wire, on_skin) = if surface == Side::B { (contact.a, contact.b) } else { (contact.b, contact.a) };
        let (&[p, q], &[a, b, c]) = (wires.vertices_of(on_wire), skin.vertices_of(on_skin)) else {
            for &wire in common(wires.vertices_of(on_wire), &of_wire).iter() {
                for &skin in common(skin.vertices_of(on_skin), &of_skin).iter() {
                    piercings.entry([wire, skin]).or_default().degenerate += 1;
                }
            }
            continue;
        };
        let ((wire, along), (skin, up)) = (edges[on_wire.index as usize], triangles[on_skin.index as usize]);
        // If one end is in the triangle's plane, the other one decides.
        let below = session.orient3d(a, b, c, p);
        let from = if below == Sign::Zero { -session.orient3d(a, b, c, q) } else { below };
        let pair = piercings.entry([wire, skin]).or_default();
        match from * along * up {
            Sign::Positive => pair.forward += 1,
            Sign::Negative => pair.backward += 1,
            Sign::Zero => pair.undecided += 1,
        }
    }
    Ok(piercings)
}

/// The components of each vertex: several if components touch.
fn components<const N: usize>(simplices: &[[Vertex; N]], oriented: &Oriented) -> BTreeMap<Vertex, BTreeSet<usize>> {
    let mut of_vertex: BTreeMap<Vertex, BTreeSet<usize>> = BTreeMap::new();
    for (simplex, &(component, _)) in simplices.iter().zip(oriented) {
        for &vertex in simplex {
            of_vertex.entry(vertex).or_default().insert(component);
        }
    }
    of_vertex
}

/// The components that contain all of these vertices.
fn common(vertices: &[Vertex], of_vertex: &BTreeMap<Vertex, BTreeSet<usize>>) -> BTreeSet<usize> {
    let mut sets = vertices.iter().map(|vertex| of_vertex.get(vertex).cloned().unwrap_or_default());
    let first = sets.next().unwrap_or_default();
    sets.fold(first, |all, set| &all & &set)
}
