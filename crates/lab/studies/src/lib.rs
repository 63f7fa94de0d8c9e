//! Studies: one question about predicates each, measured across backends.
//!
//! A study answers one question about backends by measuring many random or exhausted cases, and shows the answer as
//! rows, tables and plots. It never judges the scenes of a suite (the crate `oracle` does). It never decides the truth
//! itself (the crate `judge` and the checks of systems do). It reads and writes no files: the program that starts it
//! does. Read next the trait [`Study`] for the common structure, then [`laws`] for the shortest example, and
//! `harness/src/cmd/study.rs` for the tool's use of a study.
//!
//! * [`bounds`]: which error bounds and constraints of the tolerance paper hold?
//! * [`compare`]: when should one use which backend?
//! * [`stress`]: where do backends break as one knob is turned?
//! * [`laws`]: do answers about the same vertices fit each other?
//! * [`parity`]: how often do registrations make closed curves cross an odd number of times?
//! * [`resolution`]: how small can a feature be before tolerances lose it?
//! * [`audit`]: do the tolerance paper's algorithms keep their guarantee at their thresholds?
//! * [`worst`]: how near do the worst inputs come to that paper's bounds?
//! * [`cascades`]: how does a polygon change if each result is an operand of the next step?
//! * [`touching`]: what do solids that touch cost, and what does each philosophy return?
//! * [`cut`]: how good is a tetrahedral mesh that is cut by the contacts of a backend?
//! * [`decimals`]: which backends are right about decimals as they were written?
//! * [`repeat`]: does a backend give the same answer twice?
//! * [`ablation`]: what does each device of `exact` save?
//! * [`scale`]: how do time and memory grow with the scene?
//! * [`border`]: between which neighbouring doubles does a backend begin to be wrong?
//! * [`Study`]: the interface of all studies; [`Entry`]: a study with a hidden type.
//! * [`shrink`]: the smallest scene that still shows a finding.
//!
//! # Adding a study
//!
//! A study is a type in any crate, registered with the tool: `predicament::cli().study::<Order>()`. This is a complete
//! study: is zero smaller than one?
//!
//! ```
//! use predicament_oracle::roster;
//! use predicament_tasks::Contestant;
//! use predicament_predicates::{Axis, Predicates, Scene, Sign, Vertex};
//! use predicament_studies::{Entry, Error, File, Host, Quiet, Study};
//!
//! /// The arguments.
//! #[derive(clap::Args)]
//! struct Order {
//!     /// Backends
//!     #[arg(short = 'b', long = "backend", default_value = "exact,naive")]
//!     backends: Vec<String>,
//! }
//!
//! impl Study for Order {
//!     const NAME: &'static str = "order";
//!     const ASKS: &'static str = "Ask whether 0 is smaller than 1";
//!     const HELP: &'static str = "Examples:\n  predicament order";
//!     type Measured = Vec<(String, bool)>;
//!
//!     fn backends(&self) -> Vec<String> {
//!         self.backends.clone()
//!     }
//!
//!     fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Self::Measured, Error> {
//!         host.begin(backends.len() as u64, "backends");
//!         let scene = Scene::from_points2(&[[0.0, 0.0], [1.0, 0.0]]).expect("finite");
//!         let [zero, one] = [0, 1].map(Vertex::input);
//!         let ask = |backend: &&dyn Contestant| {
//!             let mut smaller = false;
//!             let mut look = |session: &mut dyn Predicates| {
//!                 smaller = session.compare(Axis::X, zero, one) == Sign::Negative;
//!             };
//!             backend.with_session(&scene, &mut look).map_err(Error::unfit)?;
//!             host.watch().done(1)?;
//!             Ok((backend.name(), smaller))
//!         };
//!         backends.iter().map(ask).collect()
//!     }
//!
//!     fn rows(&self, measured: &Self::Measured) -> Result<Vec<File>, Error> {
//!         Ok(vec![File::csv("order.csv", measured)?])
//!     }
//!
//!     fn page(&self, measured: &Self::Measured) -> String {
//!         measured.iter().map(|(backend, smaller)| format!("* {backend}: {smaller}\n")).collect()
//!     }
//!
//!     fn holds(&self, measured: &Self::Measured) -> bool {
//!         measured.iter().all(|(_, smaller)| *smaller)
//!     }
//! }
//!
//! let entry = Entry::of::<Order>();
//! let matches = entry.command().get_matches_from(["order", "-b", "exact"]);
//! let study = entry.parse(&matches).unwrap();
//! let exact = roster::backend("exact", &()).unwrap();
//! let report = study.report(&[exact.as_ref()], &Quiet::new()).unwrap();
//! assert_eq!(report.printed, "* exact: true\n");
//! assert!(report.holds);
//! ```

pub mod ablation;
pub mod audit;
pub mod border;
pub mod bounds;
pub mod cascades;
pub mod compare;
pub mod cut;
pub mod decimals;
pub mod laws;
pub mod mesh_cascades;
pub mod parity;
pub mod repeat;
pub mod resolution;
pub mod scale;
pub mod shrink;
pub mod stress;
pub mod touching;
pub mod worst;

mod common;
mod contacts;
mod coordinate;
mod entry;
mod error;
mod folder;
mod host;
mod precision;
mod report;
mod solids;
mod steps;
mod study;

pub use common::Common;
pub use entry::{Entry, Ready};
pub use error::Error;
pub use folder::FolderError;
pub use host::{Host, Quiet};
pub use precision::Precision;
pub use report::{File, Report};
pub use study::Study;
