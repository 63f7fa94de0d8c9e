//! The crate `arithmetica`. Its conventions are those of Shewchuk's C code, as in the tool.

use arithmetica::Sign;
use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, locked, serve};

#[derive(Default)]
struct Arithmetica;

/// The sign; an error is the crate's refusal of coordinates that are not finite, which the tool never sends.
fn answer<E>(sign: Result<Sign, E>) -> Answer {
    sign.map_or(Answer::Nan, |sign| match sign {
        Sign::Negative => Answer::Negative,
        Sign::Zero => Answer::Zero,
        Sign::Positive => Answer::Positive,
    })
}

impl Engine for Arithmetica {
    const NAME: &'static str = "arithmetica";
    const ZERO: Zero = Zero::Exact;
    const PREDICATES: &'static [Predicate] =
        &[Predicate::Orient2d, Predicate::Orient3d, Predicate::Incircle, Predicate::Insphere];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "arithmetica")
    }

    fn orient2d(&self, [a, b, c]: [Vertex<2>; 3]) -> Answer {
        answer(arithmetica::orient2d(a.at, b.at, c.at))
    }

    fn orient3d(&self, [a, b, c, d]: [Vertex<3>; 4]) -> Answer {
        answer(arithmetica::orient3d(a.at, b.at, c.at, d.at))
    }

    fn incircle(&self, [a, b, c, d]: [Vertex<2>; 4]) -> Answer {
        answer(arithmetica::incircle(a.at, b.at, c.at, d.at))
    }

    fn insphere(&self, [a, b, c, d, e]: [Vertex<3>; 5]) -> Answer {
        answer(arithmetica::insphere(a.at, b.at, c.at, d.at, e.at))
    }
}

fn main() -> std::process::ExitCode {
    serve::<Arithmetica>()
}
