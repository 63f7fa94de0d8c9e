//! Backends without one device, found by the device's name.
//!
//! A device of `exact` is a constant of a type. Systems are compiled once for all of these types, behind a pointer. The
//! tasks that ask for signs are compiled for each type, because a dynamic call would be a large part of such a query.

use std::sync::Arc;

use predicament_exact::without::{BATCH, DEVICES, DOUBLES, INTEGERS, NOTHING, PLAN, SEMI_STATIC, STATIC, Without};
use predicament_judge::TieJudge;
use predicament_predicates::{Backend, PredicateKind};
use predicament_sos::{PerMesh, Sos};
use predicament_tasks::signs::Signs;
use predicament_tasks::{Contestant, Entry, OnTask, Solver, TaskList};

use crate::boxed::Boxed;
use crate::shortcut::{Forbidding, ListAlone};
use crate::visit::Visit;

/// Passes `exact` without this device to the visitor; `None` if no device has the name.
fn visit<V: Visit>(device: &str, visitor: V) -> Option<V::Out> {
    Some(match DEVICES.iter().position(|&name| name == device)? {
        PLAN => visitor.visit(Without::<PLAN>, None),
        STATIC => visitor.visit(Without::<STATIC>, None),
        SEMI_STATIC => visitor.visit(Without::<SEMI_STATIC>, None),
        DOUBLES => visitor.visit(Without::<DOUBLES>, None),
        INTEGERS => visitor.visit(Without::<INTEGERS>, None),
        BATCH => visitor.visit(Without::<BATCH>, None),
        _ => visitor.visit(Without::<NOTHING>, None),
    })
}

/// The shortcuts of algorithms that a session can forbid, beside the devices of `exact`.
const SHORTCUTS: [&str; 2] = ["near-search", "empty-cells"];

/// The devices that a backend can lack.
pub(crate) fn of(base: &str) -> Vec<&'static str> {
    match base {
        "exact" => DEVICES.into_iter().chain(SHORTCUTS).collect(),
        "sos" => vec!["nothing", "leading"],
        "sos:per-mesh" => vec!["nothing", "set-aside"],
        _ => Vec::new(),
    }
}

/// The backend without the device, behind a pointer; `None` if it has no such device.
pub(crate) fn boxed(base: &str, device: &str) -> Option<Boxed> {
    let shortcut = of(base).into_iter().find(|&known| known == device)?;
    Some(match base {
        "exact" if SHORTCUTS.contains(&shortcut) => {
            Boxed::new(Forbidding { backend: Without::<NOTHING>, base: "exact", shortcut })
        }
        "exact" => hidden(device)?,
        "sos" if shortcut == "leading" => Boxed::new(ListAlone),
        "sos" => Boxed::new(Forbidding { backend: Sos::default(), base: "sos", shortcut }),
        _ => Boxed::new(Forbidding { backend: PerMesh, base: "sos:per-mesh", shortcut }),
    })
}

fn hidden(device: &str) -> Option<Boxed> {
    struct Hide;
    impl Visit for Hide {
        type Out = Boxed;

        fn visit<B: Backend + 'static>(self, backend: B, _: Option<Box<TieJudge>>) -> Boxed {
            Boxed::new(backend)
        }
    }
    visit(device, Hide)
}

/// The exact backend without the device, on the tasks that ask for signs with its own type, and on `tasks`; `None` if
/// no device has the name.
pub(crate) fn contestant<L: TaskList>(device: &str, tasks: &L) -> Option<Box<dyn Contestant>> {
    let entry = Entry::shared(Arc::new(hidden(device)?), None, tasks.clone());
    Some(Box::new(entry.with_solvers(visit(device, SignSolvers)?)))
}

/// Solvers of the tasks that ask for signs of points; none in untimed builds (`build.rs`).
struct SignSolvers;

impl Visit for SignSolvers {
    type Out = Vec<Box<dyn Solver>>;

    fn visit<B: Backend + 'static>(self, backend: B, _: Option<Box<TieJudge>>) -> Vec<Box<dyn Solver>> {
        let backend = Arc::new(backend);
        let kinds: &[PredicateKind] = if cfg!(shared_tasks) { &[] } else { &PredicateKind::ALL };
        kinds.iter().map(|&kind| Box::new(OnTask::new(&backend, Signs::of(kind))) as Box<dyn Solver>).collect()
    }
}
