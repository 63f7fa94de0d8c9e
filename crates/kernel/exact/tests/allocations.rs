//! A test that no query allocates on any rung, except the first that needs the exact row of a constructed vertex.
//!
//! Scenes are made so that every rung is needed, and the stages that queries report prove it. The test counts all
//! allocations of the querying thread.
#![allow(unsafe_code)] // an allocator needs it

#[path = "it/common.rs"]
#[allow(dead_code)] // the tests use the rest
mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::hint::black_box;

use common::Random;
use predicament_exact::{Exact, Session, constructed::Constructed, raw, stage};
use predicament_predicates::{
    Axis, Backend, Construction, Counts, Dimension, Off, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex,
};

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

/// The number of queries of each kind.
fn most() -> usize {
    predicament_effort::some_or_all(200, 600)
}

const INPUTS: usize = 40;
const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];
const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// The number of queries by predicate and stage.
type Seen = [[u64; stage::NAMES.len()]; PredicateKind::ALL.len()];

/// A random coordinate that brings queries to a rung.
fn coordinate(random: &mut Random, rung: usize) -> f64 {
    const LONG: f64 = 1.0 + f64::EPSILON;
    match rung {
        stage::DOUBLE => *random.pick(&[0.0, 1.0, 2.0, 3.0]),
        stage::STATIC => random.unit(),
        // All but one of the points are in a corner of the scene.
        stage::SEMI_STATIC => random.unit() * 2f64.powi(-30),
        stage::INTEGER => *random.pick(&[0.0, 0.5, 1.0, LONG]),
        // Differences are not doubles, with 112 bits.
        stage::WIDE_INTEGER => *random.pick(&[0.1, 3.0, 1e17, -7e16]),
        _ => *random.pick(&[0.1, 3.0, 1e200, -7e-170, f64::MAX, 5e-324]),
    }
}

fn scene(rung: usize, dimension: Dimension) -> Scene {
    let mut random = Random(31);
    let mut coordinates: Vec<f64> = (0..INPUTS * dimension.count()).map(|_| coordinate(&mut random, rung)).collect();
    if rung == stage::SEMI_STATIC {
        coordinates.extend(vec![1.0; dimension.count()]);
    }
    Scene::new(dimension, coordinates).expect("finite")
}

fn queries<const N: usize>(random: &mut Random, vertices: &[Vertex]) -> Vec<[Vertex; N]> {
    (0..most()).map(|_| std::array::from_fn(|_| *random.pick(vertices))).collect()
}

/// Asks one predicate in every form for input vertices, and in one form that is counted.
///
/// Returns the number of allocations.
fn ask<const N: usize>(
    queries: &[[Vertex; N]],
    counted: &mut [u64; stage::NAMES.len()],
    decide: impl Fn([Vertex; N]) -> (Sign, usize),
    single: impl Fn([Vertex; N]) -> Sign,
    batch: impl Fn(&[[Vertex; N]], &mut [Sign]),
    raw: Option<&dyn Fn([Vertex; N]) -> Sign>,
) -> u64 {
    let [mut decided, mut signs, mut batched] = [0; 3].map(|_| vec![Sign::Zero; queries.len()]);
    let raws = Cell::new(0);
    let allocated = allocations(|| {
        for (&query, sign) in queries.iter().zip(&mut decided) {
            let (decided, stage) = decide(black_box(query));
            counted[stage] += 1;
            *sign = decided;
        }
        for (&query, sign) in queries.iter().zip(&mut signs) {
            *sign = single(black_box(query));
        }
        batch(black_box(queries), &mut batched);
        if let Some(raw) = raw {
            for (&query, sign) in queries.iter().zip(&decided) {
                raws.set(raws.get() + usize::from(raw(black_box(query)) == *sign));
            }
        }
    });
    assert_eq!([&decided, &decided], [&signs, &batched]);
    assert!(raw.is_none() || raws.get() == queries.len());
    allocated
}

/// Asks all predicates about these vertices; returns the stages that settled them, and the number of allocations.
fn ask_all<T: Tally>(session: &Session<'_, T>, vertices: &[Vertex], constructed: bool) -> (Seen, u64) {
    let scene = session.scene();
    let random = &mut Random(37);
    // By predicate, as in `PredicateKind::ALL`.
    let [mut compare, mut orient2d, mut orient3d, mut incircle, mut insphere] = Seen::default();
    let mut allocated = 0;
    let solid = scene.dimension() == Dimension::Three;
    for &axis in &AXES[..scene.dimension().count()] {
        allocated += ask(
            &queries(random, vertices),
            &mut compare,
            |[a, b]| session.decide_compare(axis, a, b),
            |[a, b]| session.compare(axis, a, b),
            |queries, out| queries.iter().zip(out).for_each(|(&[a, b], out)| *out = session.compare(axis, a, b)),
            None,
        );
    }
    for &plane in if solid { &PLANES[..] } else { &PLANES[..1] } {
        let raw = |query: [Vertex; 3]| raw::orient2d(query.map(|v| scene.point2(plane, v)));
        allocated += ask(
            &queries(random, vertices),
            &mut orient2d,
            |[a, b, c]| session.decide_orient2d(plane, a, b, c),
            |[a, b, c]| session.orient2d(plane, a, b, c),
            |queries, out| session.orient2d_batch(plane, queries, out),
            (!constructed).then_some(&raw),
        );
    }
    if solid {
        let raw = |query: [Vertex; 4]| raw::orient3d(query.map(|v| scene.point3(v)));
        allocated += ask(
            &queries(random, vertices),
            &mut orient3d,
            |[a, b, c, d]| session.decide_orient3d(a, b, c, d),
            |[a, b, c, d]| session.orient3d(a, b, c, d),
            |queries, out| session.orient3d_batch(queries, out),
            (!constructed).then_some(&raw),
        );
    }
    if solid && !constructed {
        allocated += ask(
            &queries(random, vertices),
            &mut insphere,
            |[a, b, c, d, e]| session.decide_insphere(a, b, c, d, e),
            |[a, b, c, d, e]| session.insphere(a, b, c, d, e),
            |queries, out| session.insphere_batch(queries, out),
            Some(&|query| raw::insphere(query.map(|v| scene.point3(v)))),
        );
    }
    if !solid && !constructed {
        allocated += ask(
            &queries(random, vertices),
            &mut incircle,
            |[a, b, c, d]| session.decide_incircle(a, b, c, d),
            |[a, b, c, d]| session.incircle(a, b, c, d),
            |queries, out| session.incircle_batch(queries, out),
            Some(&|query| raw::incircle(query.map(|v| scene.point2(Plane::Xy, v)))),
        );
    }
    ([compare, orient2d, orient3d, incircle, insphere], allocated)
}

/// A session allocates its plan once, when a query first climbs beyond the filters.
#[test]
fn no_rung_allocates() {
    for rung in stage::DOUBLE..=stage::DYADIC {
        for dimension in [Dimension::Two, Dimension::Three] {
            let (scene, counts) = (scene(rung, dimension), Counts::new());
            let vertices: Vec<Vertex> = scene.vertices().take(INPUTS).collect();
            let session = Exact.prepare(&scene, Off).expect("prepared");
            let (seen, allocated) = ask_all(&session, &vertices, false);
            assert_eq!(allocated, 1, "its plan");
            assert_eq!(ask_all(&session, &vertices, false), (seen, 0));
            let (again, _) = ask_all(&Exact.prepare(&scene, &counts).expect("prepared"), &vertices, false);
            assert_eq!(again, seen);
            for kind in PredicateKind::ALL {
                if scene.has_dimension_for(kind).is_err() {
                    continue;
                }
                // Asked one by one and as a batch: integers that settle a query in one form may come after filters in
                // the other.
                let both: u64 = (0..stage::NAMES.len()).map(|stage| counts.get(kind, stage)).sum();
                assert_eq!(both, 2 * seen[kind.index()].iter().sum::<u64>());
                let wanted = if kind == PredicateKind::Compare { stage::COMPARE } else { rung };
                let settled = counts.get(kind, wanted);
                assert!(
                    settled > most() as u64 / 30,
                    "{kind} was settled {settled} times by {}: {seen:?}",
                    stage::NAMES[wanted]
                );
            }
        }
    }
}

/// Dyadic numbers answer if coordinates span more than 253 bits: here they have ties to answer.
#[test]
fn the_longest_numbers_do_not_allocate() {
    let ends = [f64::MAX, 5e-324, 0.1];
    let mut random = Random(41);
    let (mut zeros, mut allocated) = ([0; 4], 0);
    for _ in 0..200 {
        let [p, q, r]: [[f64; 3]; 3] = random.points(|random| *random.pick(&ends));
        let corner = |x: usize, y: usize, z: usize| [[p, q][x][0], [p, q][y][1], [p, q][z][2]];
        let flat = |[x, y, _]: [f64; 3]| [x, y, x];
        let box_ = [corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0), corner(0, 0, 1), corner(1, 1, 1)];
        let rectangle = [corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 1, 0)].map(|[x, y, _]| [x, y]);
        allocated += allocations(|| {
            let signs = [
                raw::orient2d([[p[0], p[0]], [q[1], q[1]], [r[2], r[2]]]),
                raw::orient3d([flat(p), flat(q), flat(r), flat(corner(1, 0, 1))]),
                raw::incircle(rectangle),
                raw::insphere(box_),
            ];
            for (zeros, sign) in zeros.iter_mut().zip(signs) {
                *zeros += usize::from(sign.is_zero());
            }
        });
    }
    assert_eq!((zeros, allocated), ([200; 4], 0));
}

/// Adds constructed vertices that have a point.
fn construct(scene: &mut Scene, count: usize) {
    let mut random = Random(43);
    while scene.constructions().len() < count {
        let n = scene.len();
        let mut v = || Vertex::input(random.below(n));
        let construction = match (scene.dimension(), scene.constructions().len() % 2) {
            (Dimension::Two, _) => Construction::Ssi([[v(), v()], [v(), v()]]),
            (Dimension::Three, 0) => Construction::Lpi { line: [v(), v()], plane: [v(), v(), v()] },
            (Dimension::Three, _) => Construction::Tpi([[v(), v(), v()], [v(), v(), v()], [v(), v(), v()]]),
        };
        let mut longer = scene.clone();
        if longer.construct(construction).is_ok() && Constructed::new(&longer).is_ok() {
            *scene = longer;
        }
    }
}

#[test]
fn constructed_vertices_do_not_allocate() {
    for rung in [stage::DOUBLE, stage::STATIC, stage::INTEGER, stage::WIDE_INTEGER, stage::DYADIC] {
        for dimension in [Dimension::Two, Dimension::Three] {
            let mut scene = scene(rung, dimension);
            construct(&mut scene, 20);
            let constructed: Vec<Vertex> = (0..20).map(Vertex::constructed).collect();
            let all: Vec<Vertex> = scene.vertices().take(20).chain(constructed.iter().copied()).collect();
            let session = Exact.prepare(&scene, Off).expect("prepared");
            let touch = || {
                constructed.iter().for_each(|&v| assert!(!black_box(session.constructed().approximation(v)).is_empty()))
            };
            let (first, again) = (allocations(touch), allocations(touch));
            // One row each, and slots for sixteen of them together. If floating point can't prove that there is a
            // point, the row exists already.
            assert!((if rung == stage::DYADIC { 0..=22 } else { 15..=22 }).contains(&first), "{first}");
            assert_eq!(again, 0);
            for vertices in [&constructed, &all] {
                ask_all(&session, vertices, true);
                let (seen, allocated) = ask_all(&session, vertices, true);
                assert_eq!(allocated, 0);
                for kind in [PredicateKind::Compare, PredicateKind::Orient2d, PredicateKind::Orient3d] {
                    if scene.has_dimension_for(kind).is_err() {
                        continue;
                    }
                    for wanted in [stage::SEMI_STATIC, stage::DYADIC] {
                        let settled = seen[kind.index()][wanted];
                        assert!(
                            settled > most() as u64 / 120,
                            "{kind} was settled {settled} times by {}",
                            stage::NAMES[wanted]
                        );
                    }
                }
            }
        }
    }
}

/// A query that the first filter settles needs no row.
#[test]
fn questions_that_floating_point_settles_allocate_nothing() {
    for dimension in [Dimension::Two, Dimension::Three] {
        let mut scene = scene(stage::STATIC, dimension);
        construct(&mut scene, 20);
        let session = Exact.prepare(&scene, Off).expect("prepared");
        let allocated = allocations(|| {
            for (i, j) in (0..20).flat_map(|i| (0..i).map(move |j| (i, j))) {
                let [a, b] = [i, j].map(Vertex::constructed);
                let (sign, stage) = session.decide_compare(Axis::X, black_box(a), b);
                assert_eq!((stage, sign.is_zero()), (stage::SEMI_STATIC, false));
            }
        });
        assert_eq!(allocated, 0);
    }
}

#[test]
fn preparing_input_vertices_allocates_nothing() {
    for rung in stage::DOUBLE..=stage::DYADIC {
        for dimension in [Dimension::Two, Dimension::Three] {
            let scene = scene(rung, dimension);
            let allocated = allocations(|| drop(black_box(Exact.prepare(&scene, Off))));
            assert_eq!(allocated, 0);
        }
    }
}

#[test]
fn what_allocates_is_counted() {
    assert_eq!(allocations(|| drop(black_box(vec![Sign::Zero; 3]))), 1);
    assert_eq!(allocations(|| drop(black_box(Box::new(1)))), 1);
    let mut grows = vec![0; 1];
    assert!(allocations(|| grows.extend(black_box([1; 100]))) > 0, "moved to a larger place");

    // The counter detects a single query that allocates.
    let scene = scene(stage::INTEGER, Dimension::Two);
    let session = Exact.prepare(&scene, Off).expect("prepared");
    let vertices: Vec<Vertex> = scene.vertices().collect();
    let queries = queries::<3>(&mut Random(47), &vertices);
    // (The session's plan exists now.)
    queries.iter().for_each(|&[a, b, c]| _ = black_box(session.orient2d(Plane::Xy, a, b, c)));
    let allocated = allocations(|| {
        for (i, &[a, b, c]) in queries.iter().enumerate() {
            black_box(session.orient2d(Plane::Xy, a, b, c));
            if i == 99 {
                drop(black_box(vec![a, b, c]));
            }
        }
    });
    assert_eq!(allocated, 1);
}
