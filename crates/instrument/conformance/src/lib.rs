//! Tests for your own geometric predicates: known hard cases, exact answers, and a regression test for each error.
//!
//! ```
//! use predicament_conformance::check;
//! # mod mine {
//! #     pub fn orient2d(a: [i32; 2], b: [i32; 2], c: [i32; 2]) -> i128 {
//! #         let [a, b, c] = [a, b, c].map(|p| p.map(i128::from));
//! #         (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
//! #     }
//! # }
//! check::orient2d(mine::orient2d).assert();
//! ```
//!
//! [`check`] has one function for each predicate, and [`check::indirect`] for predicates of points given by lines and
//! planes. A [`Check`](check::Check) runs as [`assert`](check::Check::assert) in a test, or gives a [`Report`].
//!
//! # The parts, and why they are here
//! A test of a predicate should not cost more than the predicate. So this crate stands on few others:
//! * the queries come from the crate `families`, whose generators the harness runs, too. The scenes that suites write
//!   out are a table (`scenes.txt`), generated from `corpora/`; a test of the crate `tasks` compares the two. Readers
//!   of suites, data files and runs are not needed;
//! * the truth comes from the crate `judge`, from its part without GMP (`portable`). The tests of `judge` compare that
//!   part with the judge of the harness on every family, and it uses no code of a backend.
//!
//! `predicament::conformance(Backend)` tests more: algorithms, constructed vertices in sessions, batches, promises
//! other than exactness. It takes the whole harness.

mod answer;
pub mod check;
mod families;
mod finding;
mod law;
mod number;
mod plain;
mod point;
mod query;
mod quiet;
mod report;
mod run;
mod shrink;
mod table;

pub use answer::Answer;
pub use finding::{Error, Finding, Got, regression_test};
pub use law::Law;
pub use number::Number;
pub use point::{Point, Point2, Point3, Shape};
pub use predicament_predicates::{Axis, Plane, Sign};
pub use report::{Contradiction, LawReport, Rank, Report, SourceReport};
pub use table::TABLE;
