//! A test that no batch and no single query of a control or of tolerances allocates.
#![allow(unsafe_code)] // an allocator needs it

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use predicament_controls::{Epsilon, Naive, Pivot, Shewchuk};
use predicament_predicates::{Axis, Backend, Off, Plane, QuerySet, Question, Scene, Sign, Vertex};
use predicament_tolerance::Tolerance;

thread_local! {
    static ALLOCATIONS: Cell<u64> = const { Cell::new(0) };
}

/// The system's allocator, counted by thread.
struct Counting;

// SAFETY: the system's allocator does all the work. The counter needs neither allocation nor destructor.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        // SAFETY: the caller's promise.
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        // SAFETY: the caller's promise.
        unsafe { System.dealloc(memory, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// The number of allocations of `work`.
fn allocations(work: impl FnOnce()) -> u64 {
    let before = ALLOCATIONS.get();
    work();
    ALLOCATIONS.get() - before
}

fn check(backend: &impl Backend, scene: &Scene, questions: &[Question]) {
    let session = backend.prepare(scene, Off).unwrap();
    for &question in questions {
        let args: Vec<Vertex> = (0..1000 * question.kind().arity()).map(|at| Vertex::input(at * 7 % 50)).collect();
        let queries = QuerySet::new(question, args);
        let mut out = vec![Sign::Zero; queries.len()];
        let batch = allocations(|| question.ask_batch(&session, queries.flat(), &mut out));
        let singly = allocations(|| question.ask_singly(&session, queries.flat(), &mut out));
        assert_eq!([batch, singly], [0, 0], "{} {question:?}", backend.name());
    }
}

#[test]
fn controls_and_tolerances_allocate_nothing() {
    assert!(allocations(|| drop(std::hint::black_box(vec![1]))) > 0, "allocations are counted");
    let coordinate = |at: usize| f64::from(u32::try_from(at * 37 % 101).unwrap());
    let flat: Vec<[f64; 2]> = (0..50).map(|at| [coordinate(at), coordinate(at + 13)]).collect();
    let solid: Vec<[f64; 3]> = (0..50).map(|at| [coordinate(at), coordinate(at + 13), coordinate(at + 29)]).collect();
    let scenes = [
        (
            Scene::from_points2(&flat).unwrap(),
            vec![Question::Compare(Axis::X), Question::Orient2d(Plane::Xy), Question::Incircle],
        ),
        (
            Scene::from_points3(&solid).unwrap(),
            vec![Question::Compare(Axis::Z), Question::Orient2d(Plane::Zx), Question::Orient3d, Question::Insphere],
        ),
    ];
    for (scene, questions) in &scenes {
        for pivot in [Pivot::Last, Pivot::First, Pivot::Homogeneous] {
            check(&Naive { pivot }, scene, questions);
        }
        check(&Epsilon::default(), scene, questions);
        check(&Shewchuk, scene, questions);
        check(&Tolerance, scene, questions);
        check(&Tolerance::<f32>::new(), scene, questions);
    }
}
