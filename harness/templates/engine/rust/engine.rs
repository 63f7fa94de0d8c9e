//! The engine {name}. Each predicate is a plain determinant, which is wrong near a tie.
//!
//! REPLACE the body of each predicate by a call of your library. If your library lacks a predicate, delete the function
//! and its entry in `PREDICATES`. Only the sign of a result counts. `predicament_engine/mod.rs` lists the other members
//! that an engine may have. Stdout belongs to the protocol: print with `eprintln!`.

// An engine does not use all of the helper.
#[allow(dead_code)]
mod predicament_engine;

use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, serve};

#[derive(Default)]
struct Mine;

impl Engine for Mine {
    const NAME: &'static str = "{name}";
    // Exact: a zero means that the points are degenerate. Never: your library breaks ties.
    const ZERO: Zero = Zero::Exact;
    const PREDICATES: &'static [Predicate] =
        &[Predicate::Compare, Predicate::Orient2d, Predicate::Orient3d, Predicate::Incircle, Predicate::Insphere];

    /// The version of your library.
    fn version() -> String {
        "1.0".to_owned()
    }

    // REPLACE. Positive where a's coordinate is greater than b's.
    fn compare(&self, _axis: usize, [a, b]: [Vertex<1>; 2]) -> Answer {
        (a.at[0] - b.at[0]).into()
    }

    // REPLACE. Positive where a, b, c turn counterclockwise.
    fn orient2d(&self, [a, b, c]: [Vertex<2>; 3]) -> Answer {
        let (p, q) = (minus(a, c), minus(b, c));
        (p[0] * q[1] - p[1] * q[0]).into()
    }

    // REPLACE. Positive where d is below the plane of a, b, c, which turn counterclockwise seen from above.
    fn orient3d(&self, [a, b, c, d]: [Vertex<3>; 4]) -> Answer {
        triple(minus(a, d), minus(b, d), minus(c, d)).into()
    }

    // REPLACE. Positive where d is inside the circle of a, b, c, which turn counterclockwise.
    fn incircle(&self, [a, b, c, d]: [Vertex<2>; 4]) -> Answer {
        triple(lifted(a, d), lifted(b, d), lifted(c, d)).into()
    }

    // REPLACE. Positive where e is inside the sphere of a, b, c, d, whose orient3d is positive.
    fn insphere(&self, [a, b, c, d, e]: [Vertex<3>; 5]) -> Answer {
        let [p, q, r, s] = [a, b, c, d].map(|vertex| minus(vertex, e));
        let near = squared(s) * triple(p, q, r) - squared(r) * triple(p, q, s);
        let far = squared(q) * triple(p, r, s) - squared(p) * triple(q, r, s);
        (near + far).into()
    }
}

fn minus<const D: usize>(p: Vertex<D>, q: Vertex<D>) -> [f64; D] {
    std::array::from_fn(|axis| p.at[axis] - q.at[axis])
}

/// The difference of two points of the plane, and its squared length as z.
fn lifted(p: Vertex<2>, q: Vertex<2>) -> [f64; 3] {
    let [x, y] = minus(p, q);
    [x, y, x * x + y * y]
}

fn squared([x, y, z]: [f64; 3]) -> f64 {
    x * x + y * y + z * z
}

fn triple(p: [f64; 3], q: [f64; 3], r: [f64; 3]) -> f64 {
    p[2] * (q[0] * r[1] - r[0] * q[1]) + q[2] * (r[0] * p[1] - p[0] * r[1]) + r[2] * (p[0] * q[1] - q[0] * p[1])
}

fn main() -> std::process::ExitCode {
    serve::<Mine>()
}
