//! The one list where backends and tasks meet.

use std::sync::{Arc, OnceLock};

use predicament_corpus::{SceneFormat, Vocabulary};
use predicament_predicates::Backend;

use crate::contacts::Contacts;
use crate::crossings::Crossings;
use crate::cube_union::CubeUnion;
use crate::delaunay::Delaunay2d;
use crate::hull::{Hull2d, Hull3d};
use crate::interval::Interval;
use crate::mesh_intersect::MeshIntersect;
use crate::mesh_locate::MeshLocate;
use crate::overlay::Overlay2d;
use crate::polygon_locate::PolygonLocate;
use crate::signs::Signs;
use crate::slice::Slice;
use crate::snap::Snap2d;
use crate::triangulate::Triangulate;
use crate::{AnyTask, OnTask, Solver, Task};

/// All built-in tasks, in the order of reports and messages. A new task is a line here.
macro_rules! each_task {
    ($do:ident) => {
        vec![
            $do!(Signs::COMPARE),
            $do!(Signs::ORIENT2D),
            $do!(Signs::ORIENT3D),
            $do!(Signs::INCIRCLE),
            $do!(Signs::INSPHERE),
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
            $do!(MeshIntersect),
        ]
    };
}

/// The built-in tasks.
#[must_use]
pub fn built_in() -> Vec<&'static dyn AnyTask> {
    macro_rules! any {
        ($task:expr) => {
            &$task as &'static dyn AnyTask
        };
    }
    each_task!(any)
}

/// A backend on each built-in task.
pub fn solvers<B: Backend + 'static>(backend: &Arc<B>) -> Vec<Box<dyn Solver>> {
    macro_rules! on {
        ($task:expr) => {
            Box::new(OnTask::new(backend, $task)) as Box<dyn Solver>
        };
    }
    each_task!(on)
}

/// The vocabulary of the built-in tasks, for reading suites.
#[must_use]
pub fn vocabulary() -> &'static Vocabulary {
    static VOCABULARY: OnceLock<Vocabulary> = OnceLock::new();
    VOCABULARY
        .get_or_init(|| Vocabulary::new(built_in().into_iter().map(|task| task as &'static dyn SceneFormat).collect()))
}

/// Tasks of other crates: `()`, or a task and more of them.
pub trait TaskList: Clone + Send + Sync + 'static {
    /// The tasks, which live as long as the program.
    fn tasks(&self) -> Vec<&'static dyn AnyTask>;

    /// A backend on each of them.
    fn solvers<B: Backend + 'static>(&self, backend: &Arc<B>) -> Vec<Box<dyn Solver>>;
}

impl TaskList for () {
    fn tasks(&self) -> Vec<&'static dyn AnyTask> {
        Vec::new()
    }

    fn solvers<B: Backend + 'static>(&self, _: &Arc<B>) -> Vec<Box<dyn Solver>> {
        Vec::new()
    }
}

impl<T: Task + Clone, Rest: TaskList> TaskList for (T, Rest) {
    fn tasks(&self) -> Vec<&'static dyn AnyTask> {
        // A task lives as long as the program that it is part of.
        let task: &'static T = Box::leak(Box::new(self.0.clone()));
        let mut tasks = self.1.tasks();
        tasks.push(task);
        tasks
    }

    fn solvers<B: Backend + 'static>(&self, backend: &Arc<B>) -> Vec<Box<dyn Solver>> {
        let mut solvers = self.1.solvers(backend);
        solvers.push(Box::new(OnTask::new(backend, self.0.clone())));
        solvers
    }
}
