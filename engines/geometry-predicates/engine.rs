//! The crate `geometry-predicates`. Its conventions are those of Shewchuk's C code, as in the tool.

use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, locked, serve};

#[derive(Default)]
struct GeometryPredicates;

impl Engine for GeometryPredicates {
    const NAME: &'static str = "geometry-predicates";
    const ZERO: Zero = Zero::Exact;
    const PREDICATES: &'static [Predicate] =
        &[Predicate::Orient2d, Predicate::Orient3d, Predicate::Incircle, Predicate::Insphere];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "geometry-predicates")
    }

    fn orient2d(&self, [a, b, c]: [Vertex<2>; 3]) -> Answer {
        geometry_predicates::orient2d(a.at, b.at, c.at).into()
    }

    fn orient3d(&self, [a, b, c, d]: [Vertex<3>; 4]) -> Answer {
        geometry_predicates::orient3d(a.at, b.at, c.at, d.at).into()
    }

    fn incircle(&self, [a, b, c, d]: [Vertex<2>; 4]) -> Answer {
        geometry_predicates::incircle(a.at, b.at, c.at, d.at).into()
    }

    fn insphere(&self, [a, b, c, d, e]: [Vertex<3>; 5]) -> Answer {
        geometry_predicates::insphere(a.at, b.at, c.at, d.at, e.at).into()
    }
}

fn main() -> std::process::ExitCode {
    serve::<GeometryPredicates>()
}
