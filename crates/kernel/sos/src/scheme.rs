//! The perturbation schemes: the infinitesimal of each coordinate.

use predicament_predicates::PredicateKind;

use crate::{Term, tables};

/// A perturbation scheme: a total order of infinitesimals over the coordinates of a scene.
///
/// In both schemes a vertex with a smaller index moves further. The schemes differ within a vertex and in their
/// treatment of the lifted predicates. A scheme is a value, so two schemes can be compared in one run.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub enum Scheme {
    /// Coordinate number i of the scene (2k, 2k+1 or 3k, 3k+1, 3k+2 for vertex k) moves by ε^(3^i).
    ///
    /// The strongest coordinate of a vertex is x. The points are really moved, so lifted predicates lift the moved
    /// points.
    ///
    /// Franklin and Magalhães write ε^(2^i), which works for multilinear determinants only. A lifted determinant is
    /// quadratic in each coordinate, and (ε^(2^i))² is the next coordinate's infinitesimal: monomials collide. In base
    /// 3 they can't, as the exponents' digits are the degrees 0, 1 and 2 of the coordinates. A multilinear determinant
    /// has the digits 0 and 1 only; in both bases its monomials are then ordered lexicographically from the highest
    /// coordinate down, so both bases give the same signs. One base therefore serves all five predicates.
    #[default]
    PerCoordinate,
    /// Coordinate j = 1…δ of vertex i moves by ε^(2^(iδ − j)) (Edelsbrunner and Mücke, ACM Transactions on Graphics
    /// 9(1), 1990).
    ///
    /// The *last* coordinate of a vertex is its strongest. In lifted predicates the lifted coordinate is
    /// coordinate number d + 1 and moves independently, as the strongest of its vertex: every predicate stays
    /// multilinear.
    ///
    /// δ is the same for all predicates of a scene, but its value does not matter: only the order of the exponents
    /// decides.
    EdelsbrunnerMucke,
}

impl Scheme {
    /// Both schemes.
    pub const ALL: [Scheme; 2] = [Scheme::PerCoordinate, Scheme::EdelsbrunnerMucke];

    /// The scheme's name in parameters and files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Scheme::PerCoordinate => "per-coordinate",
            Scheme::EdelsbrunnerMucke => "edelsbrunner-mucke",
        }
    }

    /// The terms that break a tie of this predicate, the largest first.
    ///
    /// The unperturbed determinant is not among them. The last term is a constant, so the list always decides.
    #[must_use]
    pub const fn terms(self, kind: PredicateKind) -> &'static [Term] {
        match (self, kind) {
            (Scheme::PerCoordinate, PredicateKind::Compare) => tables::PER_COORDINATE_COMPARE,
            (Scheme::PerCoordinate, PredicateKind::Orient2d) => tables::PER_COORDINATE_ORIENT2D,
            (Scheme::PerCoordinate, PredicateKind::Orient3d) => tables::PER_COORDINATE_ORIENT3D,
            (Scheme::PerCoordinate, PredicateKind::Incircle) => tables::PER_COORDINATE_INCIRCLE,
            (Scheme::PerCoordinate, PredicateKind::Insphere) => tables::PER_COORDINATE_INSPHERE,
            (Scheme::EdelsbrunnerMucke, PredicateKind::Compare) => tables::EDELSBRUNNER_MUCKE_COMPARE,
            (Scheme::EdelsbrunnerMucke, PredicateKind::Orient2d) => tables::EDELSBRUNNER_MUCKE_ORIENT2D,
            (Scheme::EdelsbrunnerMucke, PredicateKind::Orient3d) => tables::EDELSBRUNNER_MUCKE_ORIENT3D,
            (Scheme::EdelsbrunnerMucke, PredicateKind::Incircle) => tables::EDELSBRUNNER_MUCKE_INCIRCLE,
            (Scheme::EdelsbrunnerMucke, PredicateKind::Insphere) => tables::EDELSBRUNNER_MUCKE_INSPHERE,
            // Formulas derive their terms themselves.
            (_, PredicateKind::Derived(_)) => &[],
        }
    }
}

impl std::fmt::Display for Scheme {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
