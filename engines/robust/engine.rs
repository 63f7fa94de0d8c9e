//! The crate `robust`. Its conventions are those of Shewchuk's C code, as in the tool.

use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, locked, serve};
use robust::{Coord, Coord3D};

#[derive(Default)]
struct Robust;

impl Engine for Robust {
    const NAME: &'static str = "robust";
    const ZERO: Zero = Zero::Exact;
    const PREDICATES: &'static [Predicate] =
        &[Predicate::Orient2d, Predicate::Orient3d, Predicate::Incircle, Predicate::Insphere];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "robust")
    }

    fn orient2d(&self, points: [Vertex<2>; 3]) -> Answer {
        let [a, b, c] = points.map(coord);
        robust::orient2d(a, b, c).into()
    }

    fn orient3d(&self, points: [Vertex<3>; 4]) -> Answer {
        let [a, b, c, d] = points.map(coord3);
        robust::orient3d(a, b, c, d).into()
    }

    fn incircle(&self, points: [Vertex<2>; 4]) -> Answer {
        let [a, b, c, d] = points.map(coord);
        robust::incircle(a, b, c, d).into()
    }

    fn insphere(&self, points: [Vertex<3>; 5]) -> Answer {
        let [a, b, c, d, e] = points.map(coord3);
        robust::insphere(a, b, c, d, e).into()
    }
}

fn coord(vertex: Vertex<2>) -> Coord<f64> {
    let [x, y] = vertex.at;
    Coord { x, y }
}

fn coord3(vertex: Vertex<3>) -> Coord3D<f64> {
    let [x, y, z] = vertex.at;
    Coord3D { x, y, z }
}

fn main() -> std::process::ExitCode {
    serve::<Robust>()
}
