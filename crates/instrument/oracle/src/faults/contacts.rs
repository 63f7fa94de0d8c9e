//! Faults in the queries of the contact hierarchy; the signs are right.

use predicament_predicates::{Band, Declined, Plane, PredicateKind, Predicates, Sign, Vertex, forward_to};

use super::Fault;
use super::over::Part;

/// Contacts, right except for one kind.
pub(super) struct Contacts;

impl Part for Contacts {
    type Session<'s, P: Predicates + 's> = Session<P>;

    fn around<'s, P: Predicates + 's>(fault: Fault, honest: P) -> Session<P> {
        Session { fault, honest }
    }
}

pub(super) struct Session<P> {
    fault: Fault,
    honest: P,
}

impl<P: Predicates> Session<P> {
    /// The distance of two vertices in plain floating point: a planted fault need not be exact.
    fn distance(&self, a: Vertex, p: Vertex) -> f64 {
        let [a, p] = [a, p].map(|v| self.scene().point(v));
        a.iter().zip(p).map(|(a, p)| (a - p) * (a - p)).sum::<f64>().sqrt()
    }

    /// The band limits σ₋ and σ₊.
    fn sigma(&self) -> Option<[f64; 2]> {
        self.honest.contact_band([0, 0]).map(|sigma| [sigma.lower, sigma.upper])
    }
}

impl<P: Predicates> Predicates for Session<P> {
    forward_to!(honest: scene, predicates, sign);

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        self.honest.supports(kind)
    }

    fn band(&self, question: predicament_predicates::Question) -> Option<Band> {
        self.honest.band(question)
    }

    /// The reach, wide enough for faults that register too much: every pair is tested.
    fn reach(&self) -> f64 {
        match self.fault {
            Fault::ContactsEndlessEdge => {
                self.honest.scene().coordinates().iter().fold(0.0, |most, x| x.abs().max(most))
            }
            _ => 2.0 * self.honest.reach(),
        }
    }

    fn contact_band(&self, ranks: [u8; 2]) -> Option<Band> {
        self.honest.contact_band(ranks)
    }

    fn supports_contacts(&self) -> Result<(), Declined> {
        self.honest.supports_contacts()
    }

    fn vertex_vertex(&self, a: Vertex, p: Vertex) -> bool {
        let honest = self.honest.vertex_vertex(a, p);
        match (self.fault, self.sigma()) {
            (Fault::ToleranceNarrowContacts, Some([lower, _])) => honest && self.distance(a, p) < lower / 2.0,
            (Fault::ToleranceWideContacts, Some([_, upper])) => honest || self.distance(a, p) < 2.0 * upper,
            _ => honest,
        }
    }

    fn edge_vertex(&self, [a, b]: [Vertex; 2], p: Vertex) -> Option<f64> {
        let planes: &[Plane] = match self.scene().dimension().count() {
            2 => &[Plane::Xy],
            _ => &[Plane::Xy, Plane::Yz, Plane::Zx],
        };
        let on_line = || planes.iter().all(|&plane| self.honest.orient2d(plane, a, b, p) == Sign::Zero);
        match self.fault {
            Fault::ContactsEndlessEdge if on_line() => Some(0.5),
            Fault::ToleranceMirroredWeight => self.honest.edge_vertex([a, b], p).map(|weight| -weight),
            _ => self.honest.edge_vertex([a, b], p),
        }
    }

    fn edge_edge(&self, e: [Vertex; 2], f: [Vertex; 2]) -> Option<[f64; 2]> {
        if self.fault == Fault::ContactsOneSided && self.scene().dimension().count() == 2 {
            let [p, q] = f.map(|v| self.honest.orient2d(Plane::Xy, e[0], e[1], v));
            return (p != Sign::Zero && p == -q).then_some([0.5, 0.5]);
        }
        self.honest.edge_edge(e, f)
    }

    fn triangle_vertex(&self, triangle: [Vertex; 3], p: Vertex) -> Option<[f64; 3]> {
        self.honest.triangle_vertex(triangle, p)
    }

    fn triangle_edge(&self, triangle: [Vertex; 3], edge: [Vertex; 2]) -> Option<([f64; 3], f64)> {
        if self.fault == Fault::ContactsOneSided {
            let [a, b, c] = triangle;
            let [p, q] = edge.map(|v| self.honest.orient3d(a, b, c, v));
            return (p != Sign::Zero && p == -q).then_some(([1.0 / 3.0; 3], 0.5));
        }
        self.honest.triangle_edge(triangle, edge)
    }

    fn tetrahedron_vertex(&self, tetrahedron: [Vertex; 4], p: Vertex) -> Option<[f64; 4]> {
        self.honest.tetrahedron_vertex(tetrahedron, p)
    }
}
