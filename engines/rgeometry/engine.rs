//! The crate `rgeometry`: an orientation in the plane that breaks ties by three numbers.
//!
//! `Orientation::new` is exact for doubles. `Orientation::break_ties` uses no coordinates: a tie is the turn of (i,
//! 2^i), (j, 2^j), (k, 2^k), where the numbers are the vertices' ids. It panics if a number occurs twice; this engine
//! answers such queries with zero, without a call. The crate has no other predicate that breaks ties.

use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, by_id, locked, serve};
use rgeometry::{Orientation, SoS};

#[derive(Default)]
struct Rgeometry;

impl Engine for Rgeometry {
    const NAME: &'static str = "rgeometry";
    const ZERO: Zero = Zero::Never;
    const PREDICATES: &'static [Predicate] = &[Predicate::Orient2d];
    const IN_ORDER: bool = true;

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "rgeometry")
    }

    fn orient2d(&self, points: [Vertex<2>; 3]) -> Answer {
        if by_id(points).is_none() {
            return Answer::Zero;
        }
        let [a, b, c] = points;
        match Orientation::new(&a.at, &b.at, &c.at).break_ties(a.id, b.id, c.id) {
            SoS::CounterClockWise => Answer::Positive,
            SoS::ClockWise => Answer::Negative,
        }
    }
}

fn main() -> std::process::ExitCode {
    serve::<Rgeometry>()
}
