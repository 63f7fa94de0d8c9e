//! The laws on made-up single answers, and the descriptions of relations.

use predicament_exact::Exact;
use predicament_laws::axioms::{
    Direction, Law, Zeros, antisymmetry, equals_reference, independence_of_place, never_zero, relations, transitivity,
};
use predicament_predicates::{
    Axis, Backend, Contract, Off, Plane, PredicateKind, Predicates, QuerySet, Question, Scene, Sign, Vertex,
    ZeroMeaning, forward_to,
};

const SIGNS: [Sign; 3] = [Sign::Negative, Sign::Zero, Sign::Positive];
const MEANINGS: [ZeroMeaning; 3] = [ZeroMeaning::Band, ZeroMeaning::Exact, ZeroMeaning::Never];

/// A session that compares along x with a function; batches of a given length have one wrong answer.
struct Answers<P, F> {
    inner: P,
    compare: F,
    /// The length of the batch, and the index of its negated answer.
    turned: Option<[usize; 2]>,
}

impl<P: Predicates, F: Fn(usize, usize) -> Sign + Send + Sync> Answers<P, F> {
    fn turn(&self, out: &mut [Sign]) {
        if let Some([length, at]) = self.turned
            && out.len() == length
        {
            out[at] = -out[at];
        }
    }
}

impl<P: Predicates, F: Fn(usize, usize) -> Sign + Send + Sync> Predicates for Answers<P, F> {
    forward_to!(inner: scene, orient2d, orient3d, incircle, insphere);

    fn compare(&self, _: Axis, a: Vertex, b: Vertex) -> Sign {
        (self.compare)(a.index(), b.index())
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        self.inner.orient2d_batch(plane, queries, out);
        self.turn(out);
    }

    fn orient3d_plane(&self, [a, b, c]: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) {
        self.inner.orient3d_plane([a, b, c], points, out);
        self.turn(out);
    }
}

fn cube() -> Scene {
    let bit = |at: u8, axis: u8| f64::from(at >> axis & 1);
    Scene::from_points3(&(0..8).map(|at| [bit(at, 0), bit(at, 1), bit(at, 2)]).collect::<Vec<_>>()).unwrap()
}

/// Three signs are those of an order with ties exactly if three numbers have them.
#[test]
fn three_comparisons_are_transitive_if_three_numbers_answer_so() {
    let scene = cube();
    let places = |code: i32| [code % 3, code / 3 % 3, code / 9];
    let signs_of = |[a, b, c]: [i32; 3]| [(a, b), (b, c), (a, c)].map(|(a, b)| Sign::from(a.cmp(&b)));
    let mut broken = 0;
    for code in 0..27_usize {
        let [ab, bc, ac] = [SIGNS[code % 3], SIGNS[code / 3 % 3], SIGNS[code / 9]];
        let compare = move |a: usize, b: usize| match (a, b) {
            (0, 1) => ab,
            (1, 2) => bc,
            _ => ac,
        };
        let session = Answers { inner: Exact.prepare(&scene, Off).unwrap(), compare, turned: None };
        let is_order = (0..27).any(|code| signs_of(places(code)) == [ab, bc, ac]);
        for zero in MEANINGS {
            let found = transitivity(&session, Axis::X, [0, 1, 2].map(Vertex::input), zero);
            let has_a_say = zero != ZeroMeaning::Band || ![ab, bc, ac].contains(&Sign::Zero);
            assert_eq!(found.is_some(), !is_order && has_a_say, "{ab} {bc} {ac} {zero:?}");
            assert!(found.is_none_or(|found| found.answers.len() == 3 && found.law == Law::Transitivity));
        }
        broken += usize::from(!is_order);
    }
    // Of the 27 triples of signs, 13 are weak orders of three.
    assert_eq!(broken, 14);
}

/// Both orders of the two vertices are compared.
#[test]
fn two_orders_are_antisymmetric_if_their_signs_are_opposite() {
    let scene = cube();
    let question = Question::Compare(Axis::X);
    let args = [0, 1].map(Vertex::input);
    for (one, other) in SIGNS.into_iter().flat_map(|one| SIGNS.map(|other| (one, other))) {
        let compare = move |a: usize, _: usize| if a == 0 { one } else { other };
        let session = Answers { inner: Exact.prepare(&scene, Off).unwrap(), compare, turned: None };
        for zero in MEANINGS {
            let has_a_say = zero != ZeroMeaning::Band || (!one.is_zero() && !other.is_zero());
            let found = antisymmetry(&session, question, &args, zero);
            assert_eq!(found.len(), usize::from(other != -one && has_a_say), "{one} {other} {zero:?}");
        }
        for zero in MEANINGS {
            let tie = |identity: bool| never_zero(&session, question, &args, zero, |_| identity).is_some();
            let expected = one.is_zero() && zero == ZeroMeaning::Never;
            assert_eq!([tie(false), tie(true)], [expected, false], "{one} {zero:?}");
            let repeated = [args[0]; 2];
            assert_eq!(never_zero(&session, question, &repeated, zero, |_| false), None);
        }
    }
}

#[test]
fn a_reference_that_is_zero_says_nothing_and_a_zero_of_a_band_is_no_sign() {
    let scene = cube();
    let question = Question::Compare(Axis::X);
    let args = [0, 1].map(Vertex::input);
    let answering = |sign: Sign| Answers {
        inner: Exact.prepare(&scene, Off).unwrap(),
        compare: move |_: usize, _: usize| sign,
        turned: None,
    };
    for (sign, truth) in SIGNS.into_iter().flat_map(|sign| SIGNS.map(|truth| (sign, truth))) {
        for zero in MEANINGS {
            let found = equals_reference(&answering(sign), &answering(truth), question, &args, zero);
            let is_wrong = !truth.is_zero() && sign != truth && !(sign.is_zero() && zero == ZeroMeaning::Band);
            let signs = found.map(|found| found.answers.iter().map(|answer| answer.sign).collect::<Vec<_>>());
            assert_eq!(signs, is_wrong.then(|| vec![sign, truth]), "{sign} for {truth}, {zero:?}");
        }
    }
}

/// The wrong answer is in the batch of all queries, in the batch without the first query, or beside one plane.
#[test]
fn a_violation_of_place_names_the_query_that_was_answered_otherwise() {
    let scene = cube();
    let turns = [[0, 1, 2], [0, 2, 1], [1, 3, 2], [3, 1, 2], [0, 3, 1]];
    let flat = turns.iter().flatten().copied().map(Vertex::input).collect();
    let queries = QuerySet::new(Question::Orient2d(Plane::Xy), flat);
    let session = |turned| {
        let compare = |_: usize, _: usize| Sign::Zero;
        Answers { inner: Exact.prepare(&scene, Off).unwrap(), compare, turned }
    };
    assert_eq!(independence_of_place(&session(None), &queries), None);
    for (turned, query) in [([5, 3], 3), ([4, 0], 1), ([4, 2], 3), ([4, 3], 4)] {
        let found = independence_of_place(&session(Some(turned)), &queries).unwrap();
        let alone = Question::Orient2d(Plane::Xy).ask(&session(None), queries.args(query));
        assert!(!alone.is_zero());
        assert_eq!(found.answers.iter().map(|answer| answer.sign).collect::<Vec<_>>(), [alone, -alone]);
        assert!(found.answers.iter().all(|answer| answer.args == queries.args(query)), "{turned:?}");
    }
    let sides = [[0, 1, 2, 4], [0, 1, 2, 7], [0, 1, 4, 6]];
    let flat = sides.iter().flatten().copied().map(Vertex::input).collect();
    let queries = QuerySet::new(Question::Orient3d, flat);
    assert_eq!(independence_of_place(&session(None), &queries), None);
    let found = independence_of_place(&session(Some([3, 2])), &queries).unwrap();
    // The last point of the third query beside the first query's plane.
    assert!(found.answers.iter().all(|answer| answer.args == [0, 1, 2, 6].map(Vertex::input)), "{found:?}");
    assert_eq!(found.answers[0].sign, -found.answers[1].sign);
}

#[test]
fn zeros_have_the_meaning_that_is_promised_by_predicate() {
    let meaning = |kind: PredicateKind| match kind {
        PredicateKind::Compare => ZeroMeaning::Exact,
        PredicateKind::Orient2d | PredicateKind::Insphere => ZeroMeaning::Band,
        _ => ZeroMeaning::Never,
    };
    let zeros = Zeros::promised(|kind| Contract { zero: meaning(kind), proved: true });
    assert_eq!(PredicateKind::ALL.map(|kind| zeros.of(kind)), PredicateKind::ALL.map(meaning));
    for zero in MEANINGS {
        assert_eq!(PredicateKind::ALL.map(|kind| Zeros::from(zero).of(kind)), [zero; 5]);
    }
}

#[test]
fn relations_tell_what_they_are_about() {
    for question in [Question::Orient2d(Plane::Yz), Question::Orient3d, Question::Incircle, Question::Insphere] {
        let all = relations(question);
        assert!(all.len() >= 2);
        for (at, relation) in all.iter().enumerate() {
            assert_eq!(relation.question(), question);
            assert_eq!(relation.vertices() + relation.at_infinity().len(), question.kind().arity() + 2);
            assert_eq!(relation.law(), if at == 0 { Law::GrassmannPlucker } else { Law::MixedGrassmannPlucker });
            assert_eq!(relation.at_infinity().is_empty(), at == 0);
        }
    }
    let directions = |question| -> Vec<String> {
        let all = relations(question);
        all.iter().map(|relation| relation.at_infinity().iter().map(Direction::to_string).collect()).collect()
    };
    assert_eq!(directions(Question::Orient3d), ["", "x", "y", "z", "xy", "xz", "yz", "xyz"]);
    assert_eq!(directions(Question::Insphere), ["", "lift"]);
    assert_eq!(directions(Question::Orient2d(Plane::Zx)), ["", "z", "x", "zx"]);
}
