//! The crate `geogram_predicates`, a port of geogram's PCK, with the predicates that do not break ties.
//!
//! `base.rs` has its conventions. The predicates that break ties are the engine `geogram-predicates-sos`.

mod base;

use geogram_predicates::{in_circle_2d, in_sphere_3d};
use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, locked, serve};

#[derive(Default)]
struct Geogram;

impl Engine for Geogram {
    const NAME: &'static str = "geogram-predicates";
    const ZERO: Zero = Zero::Exact;
    const PREDICATES: &'static [Predicate] =
        &[Predicate::Orient2d, Predicate::Orient3d, Predicate::Incircle, Predicate::Insphere];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "geogram_predicates")
    }

    fn orient2d(&self, points: [Vertex<2>; 3]) -> Answer {
        base::orient2d(points)
    }

    fn orient3d(&self, points: [Vertex<3>; 4]) -> Answer {
        base::orient3d(points)
    }

    fn incircle(&self, points: [Vertex<2>; 4]) -> Answer {
        base::incircle(points, |[a, b, c, d]| in_circle_2d(&a.at, &b.at, &c.at, &d.at))
    }

    fn insphere(&self, points: [Vertex<3>; 5]) -> Answer {
        base::insphere(points, |[a, b, c, d, e]| in_sphere_3d(&a.at, &b.at, &c.at, &d.at, &e.at))
    }
}

fn main() -> std::process::ExitCode {
    serve::<Geogram>()
}
