//! Predicates in Rust for the tool `predicament`: a type with a library's predicates, and a `main` of one line.
//!
//! ```text
//! use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, locked, serve};
//!
//! #[derive(Default)]
//! struct Mine;
//!
//! impl Engine for Mine {
//!     const NAME: &'static str = "mine";
//!     const ZERO: Zero = Zero::Exact;
//!     const PREDICATES: &'static [Predicate] = &[Predicate::Orient2d];
//!
//!     fn version() -> String {
//!         locked(include_str!("../Cargo.lock"), "mine")
//!     }
//!
//!     fn orient2d(&self, [a, b, c]: [Vertex<2>; 3]) -> Answer {
//!         mine::orient2d(a.at, b.at, c.at).into()
//!     }
//! }
//!
//! fn main() -> std::process::ExitCode {
//!     serve::<Mine>()
//! }
//! ```
//!
//! Signs are those of `docs/ENGINES.md`. If a predicate panics, the answer is `error`, with the query and the text of
//! the panic: the tool counts the scene as a panic and restarts the engine. `stdout.rs` redirects the output of a
//! library.

mod message;
mod server;
mod stdout;

use std::cmp::Ordering;
use std::ops::Neg;
use std::process::ExitCode;

/// The meaning of the engine's zero.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Zero {
    /// The determinant is zero.
    Exact,
    /// The engine breaks ties, so a zero has no meaning.
    Never,
}

/// The precision to which coordinates are rounded.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Precision {
    /// Double precision: coordinates are not rounded.
    F64,
    /// Single precision.
    F32,
}

/// A predicate of the protocol.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Predicate {
    /// The order of two coordinates.
    Compare,
    /// The turn of three points.
    Orient2d,
    /// The side of the fourth of four points.
    Orient3d,
    /// The position of a fourth point relative to the circle of three.
    Incircle,
    /// The position of a fifth point relative to the sphere of four.
    Insphere,
}

impl Predicate {
    /// The predicate's name in the protocol.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Predicate::Compare => "compare",
            Predicate::Orient2d => "orient2d",
            Predicate::Orient3d => "orient3d",
            Predicate::Incircle => "incircle",
            Predicate::Insphere => "insphere",
        }
    }
}

/// An answer; its number is the byte of the protocol.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum Answer {
    /// The sign −1.
    Negative = 255,
    /// The sign 0.
    Zero = 0,
    /// The sign +1.
    Positive = 1,
    /// The engine declines the query, and with it the scene.
    Declined = 2,
    /// The library returned NaN.
    Nan = 3,
}

impl From<Ordering> for Answer {
    fn from(order: Ordering) -> Answer {
        match order {
            Ordering::Less => Answer::Negative,
            Ordering::Equal => Answer::Zero,
            Ordering::Greater => Answer::Positive,
        }
    }
}

impl From<f64> for Answer {
    /// The sign of a determinant; `Nan` for NaN.
    fn from(determinant: f64) -> Answer {
        determinant.partial_cmp(&0.0).map_or(Answer::Nan, Answer::from)
    }
}

impl Neg for Answer {
    type Output = Answer;

    fn neg(self) -> Answer {
        match self {
            Answer::Negative => Answer::Positive,
            Answer::Positive => Answer::Negative,
            other => other,
        }
    }
}

/// A vertex of the scene: its coordinates and its id.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Vertex<const D: usize> {
    /// The coordinates.
    pub at: [f64; D],
    /// The vertex number, counted from 0.
    pub id: u32,
}

/// All points that predicates receive, by the ids of their vertices.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Points<'p> {
    /// The points of a scene in the plane, or of a scene in space, projected.
    Plane(&'p [[f64; 2]]),
    /// The points of a scene in space.
    Space(&'p [[f64; 3]]),
}

/// A library's predicates in the tool's conventions.
pub trait Engine: Default {
    /// The engine's name in the answer to `hello`.
    const NAME: &'static str;
    /// The meaning of zero.
    const ZERO: Zero;
    /// The predicates that the engine has; others are declined.
    const PREDICATES: &'static [Predicate];
    /// The precision to which coordinates are rounded.
    const PRECISION: Precision = Precision::F64;
    /// True if orient2d in the zx plane receives (x, z), and the answer is negated. A perturbation that moves a point's
    /// coordinates in their order needs this, since the library itself would project in that order.
    const IN_ORDER: bool = false;

    /// The version of the library, on one line.
    fn version() -> String;

    /// Receives the points before the first batch of a scene, outside of the measured time, and again whenever
    /// predicates get other points: orient2d in a plane of a scene in space gets projected points. Ids stay the same.
    ///
    /// # Errors
    /// The reason why the scene is not for this engine.
    fn prepare(&mut self, points: Points<'_>) -> Result<(), String> {
        let _ = points;
        Ok(())
    }

    /// The order of two coordinates; `axis` is 0, 1 or 2.
    fn compare(&self, axis: usize, points: [Vertex<1>; 2]) -> Answer {
        let _ = (axis, points);
        Answer::Declined
    }

    /// The turn of three points, positive if counterclockwise.
    fn orient2d(&self, points: [Vertex<2>; 3]) -> Answer {
        let _ = points;
        Answer::Declined
    }

    /// The side of the fourth point, positive if it is below the plane of the others, which are counterclockwise from
    /// above.
    fn orient3d(&self, points: [Vertex<3>; 4]) -> Answer {
        let _ = points;
        Answer::Declined
    }

    /// The position of the fourth point, positive if it is inside the circle of the others, which turn
    /// counterclockwise.
    fn incircle(&self, points: [Vertex<2>; 4]) -> Answer {
        let _ = points;
        Answer::Declined
    }

    /// The position of the fifth point, positive if it is inside the sphere of the others, which have a positive
    /// orient3d.
    fn insphere(&self, points: [Vertex<3>; 5]) -> Answer {
        let _ = points;
        Answer::Declined
    }
}

/// The points sorted by id, and true if the permutation is odd; `None` if a vertex occurs twice.
#[must_use]
pub fn by_id<const D: usize, const N: usize>(mut points: [Vertex<D>; N]) -> Option<([Vertex<D>; N], bool)> {
    let mut odd = false;
    for end in (1..N).rev() {
        for at in 0..end {
            if points[at].id > points[at + 1].id {
                points.swap(at, at + 1);
                odd = !odd;
            }
        }
    }
    let twice = points.windows(2).any(|pair| pair[0].id == pair[1].id);
    (!twice).then_some((points, odd))
}

/// The version of a package in a Cargo lock file.
#[must_use]
pub fn locked(lock: &str, package: &str) -> String {
    let name = format!("name = \"{package}\"");
    let version = lock.lines().skip_while(|line| *line != name).nth(1);
    version.and_then(|line| line.split('"').nth(1)).unwrap_or("unknown").to_owned()
}

/// Answers the tool until stdin ends; with `--version`, prints the version of the library.
pub fn serve<E: Engine>() -> ExitCode {
    match server::main::<E>(std::env::args().skip(1).collect()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(2)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_of_numbers_and_orders() {
        assert_eq!([-1e-300, -0.0, 5.0, f64::NAN].map(Answer::from).map(|answer| answer as u8), [255, 0, 1, 3]);
        assert_eq!(Answer::from(1.cmp(&2)), Answer::Negative);
        assert_eq!([Answer::Positive, Answer::Zero, Answer::Nan].map(Neg::neg), {
            [Answer::Negative, Answer::Zero, Answer::Nan]
        });
    }

    #[test]
    fn vertices_are_sorted_with_their_parity() {
        let at = |ids: [u32; 4]| by_id(ids.map(|id| Vertex { at: [f64::from(id)], id }));
        let ids = |ids| at(ids).map(|(points, odd)| (points.map(|point| point.id), odd));
        assert_eq!(ids([0, 1, 2, 3]), Some(([0, 1, 2, 3], false)));
        assert_eq!(ids([3, 1, 2, 0]), Some(([0, 1, 2, 3], true)));
        assert_eq!(ids([7, 9, 2, 4]), Some(([2, 4, 7, 9], false)));
        assert_eq!(ids([7, 9, 2, 7]), None);
    }

    #[test]
    fn versions_are_read_from_a_lock_file() {
        let lock =
            "[[package]]\nname = \"ab\"\nversion = \"2.0.0\"\n\n[[package]]\nname = \"a\"\nversion = \"1.2.3\"\n";
        assert_eq!(locked(lock, "a"), "1.2.3");
        assert_eq!(locked(lock, "b"), "unknown");
    }
}
