//! The list of the built-in systems and studies.
//!
//! A system is added as a task of any crate, with a [`TaskList`], and a study as a [`studies::Entry`]. The list is a
//! separate crate because tests of lower layers need backends that know every task. Backends and systems are compiled
//! together here.

use std::sync::{Arc, OnceLock};

use predicament_contacts::task::Contacts;
use predicament_corpus::Vocabulary;
use predicament_cover::task::CoverTask;
use predicament_crossings::task::Crossings;
use predicament_cube_union::task::CubeUnion;
use predicament_delaunay::task::Delaunay2d;
use predicament_distance::task::Distance;
use predicament_hull::task::{Hull2d, Hull3d};
use predicament_interval::task::Interval;
use predicament_mesh_intersect::task::MeshIntersect;
use predicament_mesh_locate::task::MeshLocate;
use predicament_mesh_rays::task::MeshRays;
use predicament_oracle::roster::{self, BackendError, Roster};
use predicament_overlay::task::overlay::Overlay2d;
use predicament_overlay::task::snap::Snap2d;
use predicament_polygon_locate::task::PolygonLocate;
use predicament_predicates::Backend;
use predicament_simplify::task::Simplify;
use predicament_slice::task::Slice;
use predicament_studies as studies;
use predicament_studies::ablation::Ablation;
use predicament_studies::audit::Audit;
use predicament_studies::border::Borders;
use predicament_studies::bounds::Bounds;
use predicament_studies::cascades::Cascades;
use predicament_studies::compare::Compare;
use predicament_studies::cut::Cut;
use predicament_studies::decimals::Decimals;
use predicament_studies::laws::Laws;
use predicament_studies::mesh_cascades::MeshCascades;
use predicament_studies::parity::Parity;
use predicament_studies::repeat::Repeat;
use predicament_studies::resolution::Resolution;
use predicament_studies::scale::Scale;
use predicament_studies::stress::Stress;
use predicament_studies::touching::Touching;
use predicament_studies::worst::Worst;
use predicament_tasks::{AnyTask, Contestant, Entry, OnTask, Solver, TaskList, with_signs};
use predicament_triangulate::task::Triangulate;

/// Calls a macro with all systems, in the order of reports and messages. To add a system, add a line here.
macro_rules! each_task {
    ($do:ident) => {
        vec![
            $do!(Interval),
            $do!(PolygonLocate),
            $do!(CubeUnion),
            $do!(Contacts::IN_PLANE),
            $do!(Contacts::IN_SPACE),
            $do!(Crossings),
            $do!(Triangulate),
            $do!(Hull2d),
            $do!(Hull3d),
            $do!(Slice),
            $do!(Delaunay2d),
            $do!(Overlay2d),
            $do!(Snap2d),
            $do!(MeshLocate),
            $do!(MeshRays),
            $do!(CoverTask),
            $do!(Distance),
            $do!(MeshIntersect),
            $do!(Simplify),
        ]
    };
}

/// The systems, as a list of tasks.
#[derive(Clone, Copy, Default, Debug)]
pub struct Systems;

impl TaskList for Systems {
    fn tasks(&self) -> Vec<&'static dyn AnyTask> {
        macro_rules! any {
            ($task:expr) => {
                &$task as &'static dyn AnyTask
            };
        }
        each_task!(any)
    }

    fn solvers<B: Backend + 'static>(&self, backend: &Arc<B>) -> Vec<Box<dyn Solver>> {
        macro_rules! on {
            ($task:expr) => {
                Box::new(OnTask::new(backend, $task)) as Box<dyn Solver>
            };
        }
        each_task!(on)
    }
}

impl Roster for Systems {
    // Not generic: this crate compiles the backends, and not each program that calls this method.
    fn backend(&self, name: &str) -> Result<Box<dyn Contestant>, BackendError> {
        backend(name)
    }
}

/// The studies, in the order of the help.
pub const STUDIES: &[studies::Entry] = &[
    studies::Entry::of::<Bounds>(),
    studies::Entry::of::<Compare>(),
    studies::Entry::of::<Stress>(),
    studies::Entry::of::<Resolution>(),
    studies::Entry::of::<Parity>(),
    studies::Entry::of::<Cut>(),
    studies::Entry::of::<Audit>(),
    studies::Entry::of::<Worst>(),
    studies::Entry::of::<Laws>(),
    studies::Entry::of::<Cascades>(),
    studies::Entry::of::<MeshCascades>(),
    studies::Entry::of::<Touching>(),
    studies::Entry::of::<Decimals>(),
    studies::Entry::of::<Repeat>(),
    studies::Entry::of::<Borders>(),
    studies::Entry::of::<Ablation>(),
    studies::Entry::of::<Scale>(),
];

/// The tasks that ask for signs, and the systems.
#[must_use]
pub fn tasks() -> &'static [&'static dyn AnyTask] {
    static TASKS: OnceLock<Vec<&'static dyn AnyTask>> = OnceLock::new();
    TASKS.get_or_init(|| with_signs(&Systems))
}

/// The task with this name.
#[must_use]
pub fn task(name: &str) -> Option<&'static dyn AnyTask> {
    tasks().iter().copied().find(|task| task.name() == name)
}

/// The vocabulary of [`tasks`], for reading suites.
#[must_use]
pub fn vocabulary() -> &'static Vocabulary {
    static VOCABULARY: OnceLock<Vocabulary> = OnceLock::new();
    VOCABULARY.get_or_init(|| predicament_tasks::vocabulary(tasks()))
}

/// A backend of any type, on all of [`tasks`].
pub fn entry<B: Backend + 'static>(backend: B) -> Entry<B, Systems> {
    Entry::shared(Arc::new(backend), None, Systems)
}

/// The backend with this name, on all of [`tasks`].
///
/// # Errors
/// One line with the names of all backends.
pub fn backend(name: &str) -> Result<Box<dyn Contestant>, BackendError> {
    roster::backend(name, &Systems)
}
