//! `rgeometry`: an orientation in the plane that breaks ties by three numbers.
//!
//! `Orientation::new` is exact for doubles. `Orientation::break_ties` looks at no
//! coordinate: a tie is the turn of (i, 2^i), (j, 2^j), (k, 2^k). It has no
//! other predicate that breaks ties.

use predicament_predicates::{PredicateKind, Sign, ZeroMeaning};
use rgeometry::{Orientation, SoS};

use super::{Library, Point, sorted};

/// The crate `rgeometry`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Rgeometry;

impl Library for Rgeometry {
    fn name(&self) -> &'static str {
        "rgeometry"
    }

    fn zero(&self, kind: PredicateKind) -> Option<ZeroMeaning> {
        (kind == PredicateKind::Orient2d).then_some(ZeroMeaning::Never)
    }

    fn orient2d(&self, points: [Point<2>; 3]) -> Sign {
        // It panics where a number comes twice.
        if sorted(points).1.is_zero() {
            return Sign::Zero;
        }
        let [a, b, c] = points.map(|point| point.at);
        let [i, j, k] = points.map(|point| u32::try_from(point.key).expect("a small scene"));
        match Orientation::new(&a, &b, &c).break_ties(i, j, k) {
            SoS::CounterClockWise => Sign::Positive,
            SoS::ClockWise => Sign::Negative,
        }
    }
}
