//! Constructed vertices: bytes become points, constructions and queries about them.

use predicament_exact::{Exact, constructed::Constructed};
use predicament_predicates::{
    Axis, Backend, Construction, Dimension, Off, Plane, Predicates, QuerySet, Question, Scene, Share, Sign, Vertex,
};

use crate::judge_of_constructed::{Judge, PLANES};
use crate::points;

/// The number of bytes for the constructions, and also for the queries; the points come after both.
const BYTES: usize = 32;
/// The number of constructions that are tried.
const CONSTRUCTIONS: usize = 3;
/// The number of queries; each is made along every axis, in every plane, and in space.
const QUERIES: usize = 6;

/// Runs one fuzz case about constructed vertices.
///
/// # Panics
/// If the exact backend gives a wrong sign, alone or in a batch, or if it and the judge disagree on whether the vertex
/// exists: the message has the scene.
pub fn check(bytes: &[u8]) {
    for (question, args, truth, answers) in answered(bytes).1 {
        let asked = question.query(&args);
        assert_eq!(answers, [truth; 2], "{asked}, alone and in a batch, for bytes {bytes:?}");
    }
}

/// A query, its arguments, the exact sign, and the answers alone and in a batch.
type Answered = (Question, Vec<Vertex>, Sign, [Sign; 2]);

/// The scene that bytes encode, and the answers to all its queries.
fn answered(bytes: &[u8]) -> (Scene, Vec<Answered>) {
    let (&head, bytes) = bytes.split_first().unwrap_or((&0, &[]));
    let mut parts = [[0; BYTES]; 2];
    let mut rest = bytes;
    for part in &mut parts {
        let (first, after) = rest.split_at(rest.len().min(BYTES));
        part[..first.len()].copy_from_slice(first);
        rest = after;
    }
    let (dimension, coordinates) = if head & 1 == 0 {
        (Dimension::Two, points::from_bytes::<2>(rest, 6).into_flattened())
    } else {
        (Dimension::Three, points::from_bytes::<3>(rest, 9).into_flattened())
    };
    let mut scene = Scene::new(dimension, coordinates).expect("points are finite and whole");
    construct(&mut scene, &parts[0]);

    let judge = Judge::new(&scene);
    let session = Exact.prepare(&scene, Off).expect("every construction is a point");
    let (inputs, constructed) = (scene.len(), scene.constructions().len());
    let mut bytes = parts[1].into_iter().map(usize::from);
    let mut answered = Vec::new();
    for _ in 0..QUERIES {
        let any = [0; 4].map(|_| {
            let at = bytes.next().unwrap_or(0);
            // Constructed vertices with probability one half.
            match at / 2 {
                index if at % 2 == 1 && constructed > 0 => Vertex::constructed(index % constructed),
                index => Vertex::input(index % inputs),
            }
        });
        let [a, b, c, _] = any;
        let (axes, planes): (&[Axis], &[Plane]) = match dimension {
            Dimension::Two => (&[Axis::X, Axis::Y], &[Plane::Xy]),
            Dimension::Three => (&[Axis::X, Axis::Y, Axis::Z], &PLANES),
        };
        for &axis in axes {
            let truth = judge.compare(axis, [a, b]);
            answered.push(ask(&session, Question::Compare(axis), &[a, b], truth));
        }
        for &plane in planes {
            let truth = judge.orient2d(plane, [a, b, c]);
            answered.push(ask(&session, Question::Orient2d(plane), &[a, b, c], truth));
        }
        answered.push(match dimension {
            Dimension::Two => ask(&session, Question::Incircle, &any, judge.incircle(any)),
            Dimension::Three => ask(&session, Question::Orient3d, &any, judge.orient3d(any)),
        });
    }
    drop(session);
    (scene, answered)
}

fn ask(session: &impl Predicates, question: Question, args: &[Vertex], truth: Sign) -> Answered {
    let mut batch = [Sign::Zero; 2];
    QuerySet::new(question, args.repeat(2)).ask_batch(session, 0..2, &mut batch);
    (question, args.to_vec(), truth, [question.ask(session, args), batch[1]])
}

/// Adds the constructions that bytes encode, if they give points. If the judge finds that a construction gives no
/// point, the backend must decline it.
fn construct(scene: &mut Scene, bytes: &[u8; BYTES]) {
    let judge = Judge::new(scene);
    let n = scene.len();
    let mut bytes = bytes.iter();
    for _ in 0..CONSTRUCTIONS {
        let mut id = || Vertex::input(usize::from(*bytes.next().unwrap_or(&0)) % n);
        let construction = match (scene.dimension(), id().index() % 3) {
            (_, 2) => {
                // A share of a byte over another one; q − p and q are small enough.
                let [p, q] = [id(), id()].map(|v| i64::try_from(v.index()).expect("a byte"));
                Construction::Ratio { ends: [id(), id()], share: Share::new(p - 1, q + 1).expect("q is positive") }
            }
            (Dimension::Two, _) => Construction::Ssi([[id(), id()], [id(), id()]]),
            (Dimension::Three, 0) => Construction::Lpi { line: [id(), id()], plane: [id(), id(), id()] },
            (Dimension::Three, _) => Construction::Tpi([[id(), id(), id()], [id(), id(), id()], [id(), id(), id()]]),
        };
        let mut tried = scene.clone();
        if tried.construct(construction).is_err() {
            continue; // a line or plane with a repeated vertex
        }
        let is_point = judge.meet(&construction).is_some();
        assert_eq!(Constructed::new(&tried).is_ok(), is_point, "{construction} of {:?}", scene.coordinates());
        if is_point {
            *scene = tried;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::bytes;

    const RUNS: u64 = 4000;

    #[test]
    fn the_exact_backend_agrees_on_random_bytes() {
        (0..RUNS).for_each(|run| check(&bytes(run)));
    }

    #[test]
    fn short_inputs_are_cases_too() {
        for length in 0..100 {
            check(&bytes(11)[..length]);
            check(&[0xff; 100][..length]);
        }
    }

    /// Rounded coordinates are detected, so the bytes do not give easy scenes only.
    #[test]
    fn all_kinds_and_signs_come_up_and_rounding_is_caught() {
        let (mut signs, mut kinds, mut rounded) = ([0; 3], [0; 4], 0);
        for run in 0..RUNS {
            let (scene, answered) = answered(&bytes(run));
            for construction in scene.constructions() {
                kinds[match construction {
                    Construction::Ssi(_) => 0,
                    Construction::Lpi { .. } => 1,
                    Construction::Tpi(_) => 2,
                    Construction::Ratio { .. } => 3,
                }] += 1;
            }
            let session = Exact.prepare(&scene, Off).expect("as before");
            let rounding: Vec<Vec<f64>> = scene
                .vertices()
                .chain((0..scene.constructions().len()).map(Vertex::constructed))
                .map(|v| session.constructed().approximation(v).to_vec())
                .collect();
            let Ok(flattened) = Scene::new(scene.dimension(), rounding.concat()) else { continue };
            let judge = Judge::new(&flattened);
            for (question, args, truth, _) in answered {
                signs[usize::try_from(truth.as_i8() + 1).expect("0, 1 or 2")] += 1;
                let moved = |v: Vertex| v.construction().map_or(v, |index| Vertex::input(scene.len() + index));
                let args: Vec<Vertex> = args.into_iter().map(moved).collect();
                let by_rounding = match (question, &args[..]) {
                    (Question::Compare(axis), &[a, b]) => judge.compare(axis, [a, b]),
                    (Question::Orient2d(plane), &[a, b, c]) => judge.orient2d(plane, [a, b, c]),
                    (Question::Incircle, &[a, b, c, d]) => judge.incircle([a, b, c, d]),
                    (_, &[a, b, c, d]) => judge.orient3d([a, b, c, d]),
                    _ => unreachable!("as asked"),
                };
                rounded += usize::from(by_rounding != truth);
            }
        }
        assert!(signs.iter().all(|&n| n > 1000) && kinds.iter().all(|&n| n > 100), "{signs:?}, {kinds:?}");
        assert!(rounded > 100, "{rounded}");
    }
}
