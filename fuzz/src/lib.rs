//! The code of the fuzz targets: bytes become points, the points become queries, and the exact backend must agree with
//! the judge in rationals.
//!
//! With a nightly compiler and `cargo install cargo-fuzz`, from the folder above:
//!
//! ```text
//! cargo +nightly fuzz run insphere -- -max_len=256
//! ```
//!
//! Random bytes give random points, which are easy. [`points`] therefore can encode "nearly as before" in a byte or
//! two, so that mutations stay near degenerate cases instead of leaving them. [`constructed`] also constructs lines and
//! planes through the points, and queries their intersections.
//!
//! [`formats`] and [`half_edge`] have other subjects: the readers of data files, which must never panic, and the
//! operations on meshes, which must keep every invariant. [`suites`] and [`run_folder`] are about the other readers.
//!
//! [`ties`] compares Simulation of Simplicity with its own judge. [`scenes`] is about all tasks: it runs a suite's text
//! through `exact`, `sos` and `tolerance`, and judges the answers; [`OF_TASKS`] lists targets that do so for some tasks
//! only. [`seeds`] writes the seeds, and [`finds`] turns finds into scenes.

#![forbid(unsafe_code)]

pub mod constructed;
pub mod finds;
pub mod formats;
pub mod half_edge;
#[path = "../../crates/kernel/exact/tests/it/constructed/judge.rs"]
mod judge_of_constructed;
pub mod mutate;
pub mod points;
pub mod polygons;
pub mod run_folder;
pub mod scenes;
pub mod seeds;
pub mod suites;
pub mod ties;

use predicament_exact::{Exact, raw};
use predicament_judge as judge;
use predicament_predicates::{
    Axis, Backend, Dimension, Off, Plane, PredicateKind, QuerySet, Question, Scene, Sign, Vertex,
};

/// The targets for scenes of some tasks: the hierarchy of tolerances, triangulation, and algorithms on crossing
/// segments.
pub const OF_TASKS: [(&str, &[&str]); 3] = [
    ("contacts", &["contacts2d", "contacts3d"]),
    ("triangulate", &["triangulate", "delaunay2d"]),
    ("overlay", &["overlay2d", "crossings", "snap2d"]),
];

/// The tasks of a target of [`OF_TASKS`].
///
/// # Panics
/// If there is no such target.
#[must_use]
pub fn tasks_of(target: &str) -> &'static [&'static str] {
    OF_TASKS.into_iter().find(|(name, _)| *name == target).expect("a target of some tasks").1
}

/// Runs one fuzz case: sessions, alone and in a batch, and raw predicates.
///
/// # Panics
/// If the exact backend gives a wrong sign: the message has the points bit by bit.
pub fn check(kind: PredicateKind, bytes: &[u8]) {
    if let Some(wrong) = first_wrong(&Exact, kind, bytes) {
        panic!("{wrong}");
    }
    let (scene, questions) = case(kind, bytes);
    let vertices: Vec<Vertex> = scene.vertices().collect();
    for question in questions {
        for args in vertices.windows(kind.arity()) {
            let truth = judge::sign(&scene, question, args);
            if let Some(answer) = ask_raw(&scene, question, args) {
                let asked = question.query(args);
                assert_eq!(answer, truth, "raw {asked}; all coordinates: {}", bits(&scene));
            }
        }
    }
}

/// The answer from bare coordinates; `None` for a comparison, which has no such form.
fn ask_raw(scene: &Scene, question: Question, args: &[Vertex]) -> Option<Sign> {
    let flat = |plane: Plane| move |v| scene.point2(plane, v);
    let solid = |v| scene.point3(v);
    match (question, args) {
        (Question::Orient2d(plane), &[a, b, c]) => Some(raw::orient2d([a, b, c].map(flat(plane)))),
        (Question::Orient3d, &[a, b, c, d]) => Some(raw::orient3d([a, b, c, d].map(solid))),
        (Question::Incircle, &[a, b, c, d]) => Some(raw::incircle([a, b, c, d].map(flat(Plane::Xy)))),
        (Question::Insphere, &[a, b, c, d, e]) => Some(raw::insphere([a, b, c, d, e].map(solid))),
        _ => None,
    }
}

/// The coordinates of a scene, bit by bit.
fn bits(scene: &Scene) -> String {
    let bits: Vec<String> = scene.coordinates().iter().map(|c| format!("{:#018x}", c.to_bits())).collect();
    bits.join(" ")
}

/// The first wrong sign of a backend, in words: every run of consecutive points is a query, made alone and in a batch.
pub fn first_wrong<B: Backend>(backend: &B, kind: PredicateKind, bytes: &[u8]) -> Option<String> {
    let (scene, questions) = case(kind, bytes);
    let session = backend.prepare(&scene, Off).expect("nothing here is beyond the backends that are fuzzed");
    questions.into_iter().find_map(|question| {
        let vertices: Vec<Vertex> = scene.vertices().collect();
        let queries = QuerySet::new(question, vertices.windows(kind.arity()).flatten().copied().collect());
        let mut batch = vec![Sign::Zero; queries.len()];
        queries.ask_batch(&session, 0..queries.len(), &mut batch);
        batch.into_iter().enumerate().find_map(|(query, in_batch)| {
            let args = queries.args(query);
            let (alone, truth) = (question.ask(&session, args), judge::sign(&scene, question, args));
            ([alone, in_batch] != [truth, truth]).then(|| {
                let asked = question.query(args);
                let bits = bits(&scene);
                format!("{asked} is {truth}; alone {alone}, in a batch {in_batch}; all coordinates: {bits}")
            })
        })
    })
}

/// The scene that bytes encode, and its queries.
fn case(kind: PredicateKind, bytes: &[u8]) -> (Scene, Vec<Question>) {
    let (&head, bytes) = bytes.split_first().unwrap_or((&0, &[]));
    let space = kind.dimension().map_or(head & 1 == 1, |dimension| dimension == Dimension::Three);
    let (dimension, axes, planes): (_, &[Axis], &[Plane]) = if space {
        (Dimension::Three, &[Axis::X, Axis::Y, Axis::Z], &[Plane::Xy, Plane::Yz, Plane::Zx])
    } else {
        (Dimension::Two, &[Axis::X, Axis::Y], &[Plane::Xy])
    };
    let questions = match kind {
        PredicateKind::Compare => axes.iter().map(|&axis| Question::Compare(axis)).collect(),
        PredicateKind::Orient2d => planes.iter().map(|&plane| Question::Orient2d(plane)).collect(),
        other => vec![other.first_question()],
    };
    let coordinates = match dimension {
        Dimension::Two => points::from_bytes::<2>(bytes, kind.arity()).into_flattened(),
        Dimension::Three => points::from_bytes::<3>(bytes, kind.arity()).into_flattened(),
    };
    (Scene::new(dimension, coordinates).expect("points are finite and whole"), questions)
}

#[cfg(test)]
mod tests {
    use super::*;
    use predicament_controls::{Epsilon, Naive};

    const RUNS: u64 = 4000;

    /// Bytes from a linear congruential generator (Knuth's MMIX constants), as many as a case can use.
    pub(crate) fn bytes(run: u64) -> Vec<u8> {
        let mut state = run.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        (0..128)
            .map(|_| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                state.to_be_bytes()[0]
            })
            .collect()
    }

    #[test]
    fn the_exact_backend_agrees_on_random_bytes() {
        for kind in PredicateKind::ALL {
            for run in 0..RUNS {
                check(kind, &bytes(run));
            }
        }
    }

    #[test]
    fn short_inputs_are_cases_too() {
        for kind in PredicateKind::ALL {
            for length in 0..40 {
                check(kind, &bytes(7)[..length]);
                check(kind, &[0xff; 40][..length]);
            }
        }
    }

    /// Backends that round are detected, so the bytes do not give easy points only.
    #[test]
    fn backends_that_round_are_caught_on_the_same_bytes() {
        let naive = |kind| (0..RUNS).filter(|&run| first_wrong(&Naive::default(), kind, &bytes(run)).is_some()).count();
        let epsilon =
            |kind| (0..RUNS).filter(|&run| first_wrong(&Epsilon::default(), kind, &bytes(run)).is_some()).count();
        assert_eq!(naive(PredicateKind::Compare), 0, "a comparison needs no rounding");
        assert!(epsilon(PredicateKind::Compare) > 100);
        for kind in &PredicateKind::ALL[1..] {
            assert!(naive(*kind) > 100 && epsilon(*kind) > 100, "{kind}: {} and {}", naive(*kind), epsilon(*kind));
        }
    }

    #[test]
    fn ties_signs_and_all_magnitudes_come_up() {
        for kind in PredicateKind::ALL {
            let mut seen = [0_u32; 3];
            let (mut tiny, mut huge) = (0, 0);
            for run in 0..RUNS {
                let (scene, questions) = case(kind, &bytes(run));
                let args: Vec<Vertex> = scene.vertices().take(kind.arity()).collect();
                let sign = judge::sign(&scene, questions[0], &args);
                seen[usize::try_from(sign.as_i8() + 1).expect("0, 1 or 2")] += 1;
                tiny += u32::from(scene.coordinates().iter().any(|c| c.is_subnormal()));
                huge += u32::from(scene.coordinates().iter().any(|c| c.abs() > 1e300));
            }
            assert!(seen.iter().all(|&n| n > 100) && tiny > 20 && huge > 20, "{kind}: {seen:?}, {tiny}, {huge}");
        }
    }
}
