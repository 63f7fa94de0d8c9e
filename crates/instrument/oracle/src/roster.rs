//! All backends by name: the only module that refers to all of them.
//!
//! A name becomes a backend of some type, and the caller gets the type ([`Visit`]), so that tasks of other crates can
//! use every backend of this workspace.

use std::sync::Arc;

use predicament_controls::{BadEpsilon, BadStep, Epsilon, ExactRational, Grid, Naive, Pivot, Shewchuk};
use predicament_engines::{Engine, EngineError};
use predicament_exact::{Exact, Partial};
use predicament_formats::{nearest, use_one_of};
use predicament_sos::{PerMesh, Scheme, Sos, infinitesimal};
use predicament_tolerance::Tolerance;

use predicament_judge::TieJudge;
use predicament_predicates::Backend;
use predicament_tasks::{Contestant, Entry, Task, TaskList};

use crate::boxed::Boxed;
use crate::faults;
use crate::lacking;
use crate::twice::Twice;
pub use crate::visit::Visit;
use crate::visit::hand;

/// The backends that run by default, in the order of reports.
pub const DEFAULT: &[&str] =
    &["exact", "sos", "sos:edelsbrunner-mucke", "tolerance", "naive", "naive:first", "epsilon:1e-10", "shewchuk"];

/// The backends of [`MORE`] that a run takes by default for scenes of tasks on two meshes.
pub const ON_TWO_MESHES: &[&str] = &["sos:per-mesh"];

/// The parameterless backends of this workspace that do not run by default, in the order of the help.
pub const MORE: &[&str] = &["sos:per-mesh", "exact:rational", "tolerance:f32", "naive:nalgebra"];

/// The part of a name between a backend and the device that it lacks.
pub const WITHOUT: &str = ":without=";

/// The values for `-b`, for help texts.
pub const HELP: &str = "\
exact                   the sign of the real determinant
exact:stages=K          the first K of its 6 stages, then the sign of the double determinant: a control
                        (and exact:twice computes each sign twice: a yardstick of times)
exact:without=DEVICE    without one of plan, static, semi-static, doubles, integers, batch, near-search, empty-cells,
                        or nothing: a control (and sos:without=leading, sos:per-mesh:without=set-aside)
exact:rational          every predicate in rationals alone: what exactness costs without a ladder
sos                     Simulation of Simplicity, x_i + eps^(2^i) (Franklin)
sos:edelsbrunner-mucke  Simulation of Simplicity, last coordinate strongest
sos:per-mesh            the second of two meshes moved by (eps, eps^2, eps^3)
tolerance               the hierarchical tolerances of Wang et al.
tolerance:f32           the same in single precision, for scenes that it holds exactly, if need be after a shift
naive, naive:first      plain floating point, pivot at the last or the first argument
naive:nalgebra          the determinant of the homogeneous matrix, by the crate nalgebra
epsilon:EPS             plain floating point, zero where |det| < EPS (1e-10 if left out)
shewchuk                the crate `robust` as it is
grid:STEP               coordinates rounded to multiples of STEP, then exact signs
fault:NAME              a planted fault; `predicament setup selftest --list` names them
engine:NAME             a program with somebody else's predicates: engines/NAME/engine.toml, or a path to such a file";

/// The reason why a name selects no backend.
#[derive(Debug)]
#[non_exhaustive]
pub enum BackendError {
    /// No backend has the name.
    Unknown {
        /// The name.
        name: String,
    },
    /// The name does not have a number of stages that `exact` has.
    Stages {
        /// The name.
        name: String,
    },
    /// The backend of the name has no such device, or has none that can be left out.
    Device {
        /// The name.
        name: String,
    },
    /// The parameter of `epsilon` or `grid` is not a number.
    NoNumber {
        /// The name.
        name: String,
        /// The text given as the number.
        text: String,
    },
    /// The tolerance of `epsilon` is a number outside of the allowed range.
    Epsilon {
        /// The name.
        name: String,
        /// The reason for the refusal.
        why: BadEpsilon,
    },
    /// The step of `grid` is a number outside of the allowed range.
    Step {
        /// The name.
        name: String,
        /// The reason for the refusal.
        why: BadStep,
    },
    /// No planted fault has the name.
    UnknownFault {
        /// The name after `fault:`.
        fault: String,
    },
    /// The engine does not exist, does not start, or does not speak the protocol.
    Engine(EngineError),
}

impl std::fmt::Display for BackendError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            BackendError::Unknown { name } => {
                let known: Vec<&str> = DEFAULT.iter().chain(MORE).copied().collect();
                write!(f, "no backend is called `{name}`; {}, engine:NAME and fault:NAME", use_one_of(name, &known))
            }
            BackendError::Stages { name } => {
                write!(f, "`{name}`: write a number of stages from 1 to {}", Partial::STAGES)
            }
            BackendError::Device { name } => {
                let (base, device) = name.split_once(WITHOUT).unwrap_or_default();
                write!(f, "`{name}`: `{base}` lacks no such device; {}", use_one_of(device, &lacking::of(base)))
            }
            BackendError::NoNumber { name, text } => {
                write!(f, "`{name}`: `{text}` is not a number; write e.g. epsilon:1e-10 or grid:0.01")
            }
            BackendError::Epsilon { name, why } => write!(f, "`{name}`: {why}"),
            BackendError::Step { name, why } => write!(f, "`{name}`: {why}"),
            BackendError::UnknownFault { fault } => {
                let known = faults::Fault::planted().map(faults::Fault::name);
                let meant = nearest(fault, known).map_or_else(String::new, |near| format!("did you mean `{near}`? "));
                write!(f, "no fault is called `{fault}`; {meant}`predicament setup selftest --list` names them")
            }
            BackendError::Engine(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for BackendError {}

/// Finds the backend with this name and passes it to the visitor.
///
/// # Errors
/// [`BackendError`] on one line, with the known names.
pub fn visit<V: Visit>(name: &str, visitor: V) -> Result<V::Out, BackendError> {
    let sos = |visitor: V, scheme: Scheme| {
        let judge: Box<TieJudge> =
            Box::new(move |scene, question, args| infinitesimal::judge(scheme, scene, question, args));
        hand(visitor, Sos { scheme }, Some(judge))
    };
    Ok(match name {
        "exact" => hand(visitor, Exact, None),
        "exact:twice" => hand(visitor, Twice, None),
        // A dynamic call is a small part of a rational operation.
        "exact:rational" => visitor.visit(Boxed::new(ExactRational), None),
        "sos" | "sos:per-coordinate" => sos(visitor, Scheme::PerCoordinate),
        "sos:edelsbrunner-mucke" => sos(visitor, Scheme::EdelsbrunnerMucke),
        "sos:per-mesh" => visitor.visit(Boxed::new(PerMesh), Some(Box::new(infinitesimal::judge_per_mesh))),
        "tolerance" | "tolerance:f64" => hand(visitor, Tolerance::<f64>::new(), None),
        "tolerance:f32" => hand(visitor, Tolerance::<f32>::new(), None),
        "naive" | "naive:last" => hand(visitor, Naive { pivot: Pivot::Last }, None),
        "naive:nalgebra" => hand(visitor, Naive { pivot: Pivot::Homogeneous }, None),
        "naive:first" => hand(visitor, Naive { pivot: Pivot::First }, None),
        "epsilon" => hand(visitor, Epsilon::default(), None),
        "shewchuk" => hand(visitor, Shewchuk, None),
        _ => {
            if let Some(engine) = name.strip_prefix(predicament_engines::PREFIX) {
                return Ok(visitor.visit(Boxed::new(Engine::find(engine).map_err(BackendError::Engine)?), None));
            }
            if let Some(stages) = name.strip_prefix("exact:stages=") {
                let partial = stages.parse().ok().and_then(Partial::new);
                let partial = partial.ok_or_else(|| BackendError::Stages { name: name.to_owned() })?;
                return Ok(visitor.visit(Boxed::new(partial), None));
            }
            if let Some((base, device)) = name.split_once(WITHOUT) {
                let unknown = || BackendError::Device { name: name.to_owned() };
                let judge = (base != "exact").then(|| tie_judge(base)).flatten();
                return Ok(visitor.visit(lacking::boxed(base, device).ok_or_else(unknown)?, judge));
            }
            if let Some(eps) = name.strip_prefix("epsilon:") {
                let eps = parameter(name, eps)?;
                let unfit = |why| BackendError::Epsilon { name: name.to_owned(), why };
                let epsilon = Epsilon::new(eps).map_err(unfit)?;
                return Ok(hand(visitor, epsilon, None));
            }
            if let Some(step) = name.strip_prefix("grid:") {
                let unfit = |why| BackendError::Step { name: name.to_owned(), why };
                let grid = Grid::new(parameter(name, step)?).map_err(unfit)?;
                return Ok(hand(visitor, grid, None));
            }
            if let Some(fault) = name.strip_prefix("fault:") {
                return faults::visit(fault, visitor)
                    .map_err(|_| BackendError::UnknownFault { fault: fault.to_owned() });
            }
            return Err(BackendError::Unknown { name: name.to_owned() });
        }
    })
}

/// The judge of the ties that a backend breaks, if it breaks any.
fn tie_judge(name: &str) -> Option<Box<TieJudge>> {
    struct Judge;
    impl Visit for Judge {
        type Out = Option<Box<TieJudge>>;

        fn visit<B: Backend + 'static>(self, _: B, ties: Option<Box<TieJudge>>) -> Option<Box<TieJudge>> {
            ties
        }
    }
    visit(name, Judge).ok().flatten()
}

/// The number in the name of a backend.
fn parameter(name: &str, text: &str) -> Result<f64, BackendError> {
    text.parse().map_err(|_| BackendError::NoNumber { name: name.to_owned(), text: text.to_owned() })
}

/// True if a backend with this name exists. An engine exists if its configuration does; it is not started.
#[must_use]
pub fn knows(name: &str) -> bool {
    struct Nothing;
    impl Visit for Nothing {
        type Out = ();

        fn visit<B: Backend + 'static>(self, _: B, _: Option<Box<TieJudge>>) {}
    }
    match name.strip_prefix(predicament_engines::PREFIX) {
        Some(engine) => predicament_engines::find(engine).is_ok(),
        None => visit(name, Nothing).is_ok(),
    }
}

/// A list of tasks on which built-in backends are found by name.
///
/// The crate that calls the default method compiles every backend with every task. A list with its own method compiles
/// them once, for all programs that use the list.
pub trait Roster: TaskList {
    /// The backend with this name, on the tasks that query signs and on the tasks of the list.
    ///
    /// # Errors
    /// [`BackendError`] on one line, with the known names.
    fn backend(&self, name: &str) -> Result<Box<dyn Contestant>, BackendError> {
        backend(name, self)
    }
}

impl Roster for () {}

impl<T: Task + Clone, Rest: TaskList> Roster for (T, Rest) {}

/// The backend with this name, on the tasks that query signs and on `tasks`.
///
/// # Errors
/// [`BackendError`] on one line, with the known names.
pub fn backend<L: TaskList>(name: &str, tasks: &L) -> Result<Box<dyn Contestant>, BackendError> {
    struct Enter<'a, L>(&'a L);
    impl<L: TaskList> Visit for Enter<'_, L> {
        type Out = Box<dyn Contestant>;

        fn visit<B: Backend + 'static>(self, backend: B, ties: Option<Box<TieJudge>>) -> Box<dyn Contestant> {
            Box::new(Entry::shared(Arc::new(backend), ties, self.0.clone()))
        }
    }
    if let Some(engine) = name.strip_prefix(predicament_engines::PREFIX) {
        return Ok(crate::program::contestant(Engine::find(engine).map_err(BackendError::Engine)?, tasks));
    }
    if let Some(("exact", device)) = name.split_once(WITHOUT)
        && let Some(contestant) = lacking::contestant(device, tasks)
    {
        return Ok(contestant);
    }
    visit(name, Enter(tasks))
}
