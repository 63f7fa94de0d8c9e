//! The circles and spheres of the crate `geogram_predicates` that break ties, by Simulation of Simplicity on keys.
//!
//! Only the lift of a vertex is perturbed. A vertex' id is its key. `base.rs` has the conventions.

mod base;

use geogram_predicates::{SosPoint, in_circle_2d_sos, in_sphere_3d_sos};
use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, locked, serve};

#[derive(Default)]
struct Sos;

impl Engine for Sos {
    const NAME: &'static str = "geogram-predicates-sos";
    const ZERO: Zero = Zero::Never;
    const PREDICATES: &'static [Predicate] = &[Predicate::Incircle, Predicate::Insphere];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "geogram_predicates")
    }

    fn incircle(&self, points: [Vertex<2>; 4]) -> Answer {
        base::incircle(points, |points| {
            let [a, b, c, d] = points.map(keyed);
            in_circle_2d_sos(&a, &b, &c, &d)
        })
    }

    fn insphere(&self, points: [Vertex<3>; 5]) -> Answer {
        base::insphere(points, |points| {
            let [a, b, c, d, e] = points.map(keyed);
            in_sphere_3d_sos(&a, &b, &c, &d, &e)
        })
    }
}

fn keyed<const D: usize>(vertex: Vertex<D>) -> SosPoint<D> {
    SosPoint::new(vertex.at, u64::from(vertex.id))
}

fn main() -> std::process::ExitCode {
    serve::<Sos>()
}
