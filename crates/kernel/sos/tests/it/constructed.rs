//! Ties about constructed vertices, against whole polynomials, and against small numbers in place of infinitesimals.

use crate::common::substitution::{between, moved, side, turn};
use crate::common::{Random, ask_antisymmetric, grid_scene, questions};
use predicament_exact::Exact;
use predicament_predicates::{
    Axis, Backend, Construction, Off, Plane, PredicateKind, Predicates, Question, Scene, Share, Sign, Vertex,
};
use predicament_sos::{Scheme, Sos, infinitesimal::judge};
use rug::Rational;

/// Distinct vertices, `N` of the first `points`.
fn different<const N: usize>(random: &mut Random, points: usize) -> [Vertex; N] {
    let mut all: Vec<usize> = (0..points).collect();
    std::array::from_fn(|_| Vertex::input(all.swap_remove(random.below(all.len()))))
}

/// A scene of grid points with as many constructions as define a point.
///
/// All of them share the same few points.
fn constructed(random: &mut Random, dimension: usize, side: usize, points: usize, constructions: usize) -> Scene {
    let numbers = random.numbers(side.pow(u32::try_from(dimension).unwrap()), points);
    let mut scene = grid_scene(dimension, side, &numbers);
    let mut added = 0;
    for _ in 0..20 * constructions {
        let construction = match (dimension, random.below(3)) {
            _ if random.below(4) == 0 => {
                // A seventh has all bits in every double; shares may be outside of the segment.
                let numerator = i64::try_from(random.below(12)).unwrap() - 2;
                let share = Share::new(numerator, [1, 2, 3, 7][random.below(4)]).unwrap();
                Construction::Ratio { ends: different(random, points), share }
            }
            (2, _) => Construction::Ssi([different(random, points), different(random, points)]),
            (_, 0) => {
                Construction::Tpi([different(random, points), different(random, points), different(random, points)])
            }
            _ => Construction::Lpi { line: different(random, points), plane: different(random, points) },
        };
        let mut with = scene.clone();
        with.construct(construction).unwrap();
        if added < constructions && Exact.prepare(&with, Off).is_ok() {
            added = with.constructions().len();
            scene = with;
        }
    }
    scene
}

/// Any vertices, input or constructed, each once.
fn arguments(random: &mut Random, scene: &Scene, arity: usize) -> Vec<Vertex> {
    let mut all: Vec<Vertex> = (0..scene.len()).map(Vertex::input).collect();
    // Constructed vertices twice as often.
    all.extend((0..scene.constructions().len()).flat_map(|at| [Vertex::constructed(at); 2]));
    let mut args = Vec::new();
    while args.len() < arity {
        let v = all[random.below(all.len())];
        if !args.contains(&v) {
            args.push(v);
        }
    }
    args
}

fn signs(dimension: usize) -> Vec<Question> {
    let circles = [Question::Incircle, Question::Insphere];
    questions(dimension).into_iter().filter(|question| !circles.contains(question)).collect()
}

/// Checks random queries; returns the number of queries, of ties and of identities.
fn check(random: &mut Random, dimension: usize, side: usize, points: usize, scenes: usize) -> [usize; 3] {
    let mut counts = [0; 3];
    for _ in 0..scenes {
        let scene = constructed(random, dimension, side, points, 3);
        if scene.constructions().len() + scene.len() < 4 {
            continue;
        }
        let (exact, sos) = (Exact.prepare(&scene, Off).unwrap(), Sos::default());
        let session = sos.prepare(&scene, Off).unwrap();
        for question in signs(dimension) {
            let args = arguments(random, &scene, question.kind().arity());
            let answer = ask_antisymmetric(&session, question, &args);
            let context = || format!("{question:?} of {args:?} in {scene:?}");
            assert_eq!(answer, judge(Scheme::PerCoordinate, &scene, question, &args), "{}", context());
            let plain = question.ask(&exact, &args);
            assert!(plain.is_zero() || answer == plain, "not exact: {}", context());
            counts[0] += 1;
            counts[1] += usize::from(plain.is_zero() && !answer.is_zero());
            counts[2] += usize::from(answer.is_zero());
        }
    }
    counts
}

#[test]
fn where_lines_cross() {
    let mut random = Random(11);
    let [queries, ties, identities] = check(&mut random, 2, 3, 6, 2000);
    assert!(ties > queries / 10 && identities > 0, "{queries} {ties} {identities}");
}

#[test]
fn where_lines_and_planes_meet() {
    let mut random = Random(12);
    let [queries, ties, identities] = check(&mut random, 3, 2, 5, 200);
    assert!(ties > queries / 10 && identities > 0, "{queries} {ties} {identities}");
}

/// Six points in space, all distinct vertices.
#[test]
fn where_more_of_them_meet() {
    let mut random = Random(13);
    let [queries, ties, _] = check(&mut random, 3, 3, 7, 60);
    assert!(ties > queries / 20, "{queries} {ties}");
}

/// Asks about a point where six grid points' lines and planes meet, and returns the number of ties.
///
/// It compares the signs with those of small numbers in place of infinitesimals.
fn substituted(
    mut scene: Scene,
    construction: Construction,
    values: impl Fn(&[Vec<Rational>], Vertex) -> Vec<(Question, Vec<Vertex>, Rational)>,
) -> usize {
    let at = scene.construct(construction).unwrap();
    let Ok(exact) = Exact.prepare(&scene, Off) else { return 0 };
    let sos = Sos::default();
    let session = sos.prepare(&scene, Off).unwrap();
    let asked = values(&moved(&scene), at);
    for (question, args, value) in &asked {
        assert_eq!(question.ask(&session, args), Sign::from(value.cmp0()), "{question:?} in {scene:?}");
    }
    asked.iter().filter(|(question, args, _)| question.ask(&exact, args).is_zero()).count()
}

#[test]
fn small_numbers_where_two_lines_cross() {
    let (mut random, rounds) = (Random(14), predicament_effort::some_or_all(100, 400));
    let ties = (0..rounds).map(|_| {
        let scene = grid_scene(2, 3, &random.numbers(9, 6));
        let [p, q, a, b, c, d] = std::array::from_fn(Vertex::input);
        substituted(scene, Construction::Ssi([[p, q], [a, b]]), |points, at| {
            let point = |v: Vertex| points[v.index()].as_slice();
            let f = |x| turn(point(a), point(b), point(x));
            let crossing = between(point(p), point(q), [f(p), f(q)]);
            let x = Rational::from(&crossing[0] - &point(c)[0]);
            vec![
                (Question::Compare(Axis::X), vec![at, c], x),
                (Question::Orient2d(Plane::Xy), vec![at, c, d], turn(&crossing, point(c), point(d))),
            ]
        })
    });
    let ties: usize = ties.sum();
    assert!(ties > rounds / 4, "{ties}");
}

#[test]
fn small_numbers_where_a_line_meets_a_plane() {
    let (mut random, rounds) = (Random(15), predicament_effort::some_or_all(10, 30));
    let ties = (0..rounds).map(|_| {
        let scene = grid_scene(3, 2, &random.numbers(8, 6));
        let [p, q, a, b, c, d] = std::array::from_fn(Vertex::input);
        substituted(scene, Construction::Lpi { line: [p, q], plane: [a, b, c] }, |points, at| {
            let point = |v: Vertex| points[v.index()].as_slice();
            let f = |x| side(point(a), point(b), point(c), point(x));
            let meeting = between(point(p), point(q), [f(p), f(q)]);
            let along = |axis: Axis| {
                let value = Rational::from(&meeting[axis.index()] - &point(d)[axis.index()]);
                (Question::Compare(axis), vec![at, d], value)
            };
            [Axis::X, Axis::Y, Axis::Z].map(along).to_vec()
        })
    });
    let ties: usize = ties.sum();
    assert!(ties > rounds / 3, "{ties}");
}

/// Identities: a vertex on the line that it was constructed on, two names of one point.
#[test]
fn identities_stay_zero() {
    let mut scene = grid_scene(2, 3, &[0, 8, 2, 6, 1]);
    let v = Vertex::input;
    let crossing = scene.construct(Construction::Ssi([[v(0), v(1)], [v(2), v(3)]])).unwrap();
    let corner = scene.construct(Construction::Ssi([[v(0), v(1)], [v(0), v(4)]])).unwrap();
    let sos = Sos::default();
    let session = sos.prepare(&scene, Off).unwrap();
    let ask = |question: Question, args: &[Vertex]| question.ask(&session, args);
    assert_eq!(ask(Question::Orient2d(Plane::Xy), &[v(0), v(1), crossing]), Sign::Zero);
    assert_eq!(ask(Question::Compare(Axis::X), &[corner, v(0)]), Sign::Zero);
    assert_ne!(ask(Question::Compare(Axis::X), &[crossing, v(4)]), Sign::Zero, "a tie of (1, 1) and (1, 0)");
    // v(4) = (1, 0) isn't on the diagonal: the corner is v(0) under another name, and not a tie.
    assert_eq!(
        ask(Question::Compare(Axis::Y), &[corner, crossing]),
        ask(Question::Compare(Axis::Y), &[v(0), crossing])
    );
}

#[test]
fn circles_are_declined_once_a_vertex_is_constructed() {
    let scene = grid_scene(2, 3, &[0, 8, 2, 6]);
    let ties = Sos::default();
    let mut session = ties.prepare(&scene, Off).unwrap();
    assert_eq!(session.supports(PredicateKind::Incircle), Ok(()));
    let [a, b, c, d] = [0, 1, 2, 3].map(Vertex::input);
    session.construct(&[Construction::Ssi([[a, b], [c, d]])]).unwrap();
    let declined = session.supports(PredicateKind::Incircle).unwrap_err();
    assert!(declined.to_string().contains("circles through constructed vertices"), "{declined}");
    assert_eq!(session.supports(PredicateKind::Orient2d), Ok(()));
}
