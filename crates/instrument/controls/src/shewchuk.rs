//! Shewchuk's adaptive predicates, as published.

use predicament_predicates::{Backend, Constructs, Contract, Declined, PredicateKind, Scene, Tally, ZeroMeaning};
use robust::{Coord, Coord3D};

use crate::determinant::Determinant;
use crate::session::{Float, Session};

/// The crate `robust`, without a guard: correct unless a computation underflows or overflows.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Shewchuk;

impl Float for Shewchuk {
    const IN_LANES: bool = false;
    const EVALUATES_FORMULAS: bool = false;
}

/// Writes the determinants of the crate: the points, and the call.
macro_rules! determinants {
    ($(($d:literal, $n:literal): |$points:pat_param| $call:expr;)+) => {
        $(impl Determinant<$d, $n> for Shewchuk {
            #[inline]
            fn determinant(&self, $points: [[f64; $d]; $n]) -> f64 {
                $call
            }
        })+
    };
}

determinants! {
    (1, 2): |[[a], [b]]| a - b;
    (2, 3): |[a, b, c]| robust::orient2d(point2(a), point2(b), point2(c));
    (3, 4): |[a, b, c, d]| robust::orient3d(point3(a), point3(b), point3(c), point3(d));
    (2, 4): |[a, b, c, d]| robust::incircle(point2(a), point2(b), point2(c), point2(d));
    (3, 5): |[a, b, c, d, e]| robust::insphere(point3(a), point3(b), point3(c), point3(d), point3(e));
}

#[inline]
fn point2([x, y]: [f64; 2]) -> Coord<f64> {
    Coord { x, y }
}

#[inline]
fn point3([x, y, z]: [f64; 3]) -> Coord3D<f64> {
    Coord3D { x, y, z }
}

impl Backend for Shewchuk {
    type Session<'s, T: Tally + 's> = Session<'s, Shewchuk, T>;

    fn name(&self) -> String {
        "shewchuk".to_owned()
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["adaptive"]
    }

    fn constructs(&self) -> Constructs {
        Constructs::Rounds
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Self::Session<'s, T>, Declined> {
        Ok(Session::new(scene, Shewchuk, tally))
    }

    predicament_predicates::boxed_here!();
}
