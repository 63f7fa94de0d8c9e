//! The laws accept sessions that satisfy them, and each law detects a planted fault.

mod batches;
mod single;

use crate::common::{self, Fault, Faulty};
use predicament_exact::Exact;
use predicament_laws::axioms::{
    Law, Relation, Violation, antisymmetry, equals_reference, independence_of_later_vertices, independence_of_place,
    never_zero, relations, transitivity,
};
use predicament_predicates::{
    Axis, Backend, Construction, Off, Plane, PredicateKind, Predicates, QuerySet, Question, Scene, Sign, Vertex,
    ZeroMeaning,
};
use predicament_sos::{Scheme, Sos};

/// All points of a small grid, which has every kind of tie.
fn grid2(n: i32) -> Scene {
    let points: Vec<[f64; 2]> = (0..n * n).map(|at| [f64::from(at % n), f64::from(at / n)]).collect();
    Scene::from_points2(&points).unwrap()
}

fn grid3() -> Scene {
    let bit = |at: u8, axis: u8| f64::from(at >> axis & 1);
    let mut points: Vec<[f64; 3]> = (0..8).map(|at| [bit(at, 0), bit(at, 1), bit(at, 2)]).collect();
    points.push([0.5, 0.5, 0.5]);
    Scene::from_points3(&points).unwrap()
}

/// Every choice of N vertices out of a scene, ascending.
fn choices<const N: usize>(vertices: usize) -> Vec<[Vertex; N]> {
    fn extend<const N: usize>(chosen: &mut Vec<usize>, vertices: usize, all: &mut Vec<[Vertex; N]>) {
        if chosen.len() == N {
            return all.push(std::array::from_fn(|at| Vertex::input(chosen[at])));
        }
        for next in chosen.last().map_or(0, |last| last + 1)..vertices {
            chosen.push(next);
            extend(chosen, vertices, all);
            chosen.pop();
        }
    }
    let mut all = Vec::new();
    extend(&mut Vec::new(), vertices, &mut all);
    all
}

fn all_tuples<P: Predicates>(session: &P, relation: &Relation, zero: ZeroMeaning) -> Vec<Violation> {
    let tuples = relation.tuples(session.scene().len());
    tuples.filter_map(|tuple| relation.check(session, &tuple, zero.into())).collect()
}

/// All violations of the laws for the planar predicates.
fn planar<P: Predicates>(session: &P, zero: ZeroMeaning) -> Vec<Violation> {
    let n = session.scene().len();
    let mut found = Vec::new();
    for axis in [Axis::X, Axis::Y] {
        for pair in choices::<2>(n) {
            found.extend(antisymmetry(session, Question::Compare(axis), &pair, zero));
        }
        for [a, b, c] in choices(n) {
            for order in [[a, b, c], [b, c, a], [c, a, b], [a, c, b], [c, b, a], [b, a, c]] {
                found.extend(transitivity(session, axis, order, zero));
            }
        }
    }
    for triple in choices::<3>(n) {
        found.extend(antisymmetry(session, Question::Orient2d(Plane::Xy), &triple, zero));
        found.extend(never_zero(session, Question::Orient2d(Plane::Xy), &triple, zero, |_| false));
    }
    for quadruple in choices::<4>(n) {
        found.extend(antisymmetry(session, Question::Incircle, &quadruple, zero));
    }
    for question in [Question::Orient2d(Plane::Xy), Question::Incircle] {
        relations(question).iter().for_each(|relation| found.extend(all_tuples(session, relation, zero)));
    }
    found
}

fn spatial<P: Predicates>(session: &P, zero: ZeroMeaning) -> Vec<Violation> {
    let n = session.scene().len();
    let mut found = Vec::new();
    for quadruple in choices::<4>(n) {
        found.extend(antisymmetry(session, Question::Orient3d, &quadruple, zero));
    }
    for five in choices::<5>(n) {
        found.extend(antisymmetry(session, Question::Insphere, &five, zero));
        found.extend(never_zero(session, Question::Insphere, &five, zero, |_| false));
    }
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        for triple in choices(n) {
            found.extend(transitivity(session, axis, triple, zero));
        }
    }
    for plane in [Plane::Xy, Plane::Yz, Plane::Zx] {
        for relation in relations(Question::Orient2d(plane)) {
            found.extend(all_tuples(session, &relation, zero));
        }
    }
    for question in [Question::Orient3d, Question::Insphere] {
        relations(question).iter().for_each(|relation| found.extend(all_tuples(session, relation, zero)));
    }
    found
}

fn laws(found: &[Violation]) -> Vec<Law> {
    let mut laws: Vec<Law> = found.iter().map(|violation| violation.law).collect();
    laws.sort_unstable();
    laws.dedup();
    laws
}

#[test]
fn exact_and_perturbed_signs_keep_every_law() {
    let (flat, deep) = (grid2(3), grid3());
    let exact = Exact.prepare(&flat, Off).unwrap();
    let mut found = planar(&exact, ZeroMeaning::Exact);
    found.extend(spatial(&Exact.prepare(&deep, Off).unwrap(), ZeroMeaning::Exact));
    assert_eq!(found, []);
    for scheme in [Scheme::PerCoordinate, Scheme::EdelsbrunnerMucke] {
        let sos = Sos { scheme };
        assert_eq!(sos.contract(PredicateKind::Orient2d).zero, ZeroMeaning::Never);
        let session = sos.prepare(&flat, Off).unwrap();
        let mut found = planar(&session, ZeroMeaning::Never);
        found.extend(spatial(&sos.prepare(&deep, Off).unwrap(), ZeroMeaning::Never));
        assert_eq!(found, [], "{scheme}");
    }
}

#[test]
fn repeated_vertices_are_degenerate_for_all() {
    let scene = grid2(2);
    let [a, b] = [0, 1].map(Vertex::input);
    let session = Sos::default()
        .prepare(&scene, Off)
        .map(|s| antisymmetry(&s, Question::Orient2d(Plane::Xy), &[a, b, a], ZeroMeaning::Never));
    assert_eq!(session.unwrap(), []);
    let exact = Exact.prepare(&scene, Off).unwrap();
    let faulty = Faulty { inner: exact, fault: Fault::TiesUp };
    assert!(!antisymmetry(&faulty, Question::Compare(Axis::X), &[a, a], ZeroMeaning::Never).is_empty());
}

#[test]
fn every_law_catches_a_planted_fault() {
    let scene = grid2(3);
    let planted = |fault: Fault| {
        let inner = Sos::default();
        let inner = inner.prepare(&scene, Off).unwrap();
        laws(&planar(&Faulty { inner, fault }, ZeroMeaning::Never))
    };
    assert_eq!(planted(Fault::None), []);
    let one_sided = [Law::Antisymmetry, Law::Transitivity, Law::MixedGrassmannPlucker];
    assert_eq!(planted(Fault::OneSidedPair([2, 7])), one_sided);
    // the fault is the same in every order, so that only the other laws detect it
    assert_eq!(planted(Fault::MirroredPair([0, 8])), [Law::Transitivity, Law::MixedGrassmannPlucker]);
    // the perturbation alone makes them neighbours in x: the order stays an order, and no other predicate fits it
    assert_eq!(planted(Fault::MirroredPair([0, 3])), [Law::MixedGrassmannPlucker]);
    assert_eq!(planted(Fault::FlippedTriple([0, 2, 7])), [Law::GrassmannPlucker, Law::MixedGrassmannPlucker]);
    // one tie of three collinear neighbours, broken the other way, is consistent with another perturbation: laws can't
    // object, only the judge of this perturbation can
    assert_eq!(planted(Fault::FlippedTriple([0, 4, 8])), []);

    let exact = |fault: Fault| {
        let inner = Exact.prepare(&scene, Off).unwrap();
        laws(&planar(&Faulty { inner, fault }, ZeroMeaning::Never))
    };
    assert_eq!(exact(Fault::None), [Law::NeverZero]);
    assert_eq!(exact(Fault::TiesByPlace), [Law::Antisymmetry, Law::MixedGrassmannPlucker]);

    let scene = grid3();
    let planted = |fault: Fault| {
        let inner = Exact.prepare(&scene, Off).unwrap();
        laws(&spatial(&Faulty { inner, fault }, ZeroMeaning::Exact))
    };
    assert_eq!(planted(Fault::None), []);
    let both = [Law::GrassmannPlucker, Law::MixedGrassmannPlucker];
    assert_eq!(planted(Fault::FlippedQuadruple([0, 1, 2, 4])), both);
}

/// Each predicate alone satisfies every law, but together they fit no scene.
#[test]
fn predicates_of_two_perturbations_break_the_mixed_relations_only() {
    // Ties of turns and of circles are related if points on a line coincide, which a plain grid does not have.
    let grid = (0..9).map(|at: u8| [f64::from(at % 3), f64::from(at / 3)]);
    let points: Vec<[f64; 2]> = grid.chain((0..3).map(|at: u8| [f64::from(at), f64::from(at)])).collect();
    let scene = Scene::from_points2(&points).unwrap();
    let [one, other] = Scheme::ALL.map(|scheme| Sos { scheme });
    let (one, other) = (one.prepare(&scene, Off).unwrap(), other.prepare(&scene, Off).unwrap());
    let mixed = common::Patched { sides: &one, circles: &other };
    assert_eq!(laws(&planar(&mixed, ZeroMeaning::Never)), [Law::MixedGrassmannPlucker]);
    let same = common::Patched { sides: &one, circles: &one };
    assert_eq!(laws(&planar(&same, ZeroMeaning::Never)), []);
}

#[test]
fn what_is_asked_beside_a_query_or_comes_after_it_must_not_matter() {
    let scene = grid2(4);
    let sos = Sos::default();
    let session = sos.prepare(&scene, Off).unwrap();
    let queries = |question: Question| {
        let flat =
            scene.vertices().chain(scene.vertices()).take(30 / question.kind().arity() * question.kind().arity());
        QuerySet::new(question, flat.collect())
    };
    let turns = queries(Question::Orient2d(Plane::Xy));
    for question in [Question::Compare(Axis::Y), Question::Orient2d(Plane::Xy), Question::Incircle] {
        assert_eq!(independence_of_place(&session, &queries(question)), None, "{question:?}");
    }
    assert_eq!(independence_of_place(&session, &QuerySet::new(Question::Incircle, Vec::new())), None);
    for fault in [Fault::LastOfBatch, Fault::FirstOfLine] {
        let faulty = Faulty { inner: sos.prepare(&scene, Off).unwrap(), fault };
        let violation = independence_of_place(&faulty, &turns).unwrap();
        assert_eq!((violation.law, violation.answers.len()), (Law::Place, 2), "{fault:?}");
        assert_eq!(violation.answers[0].args, violation.answers[1].args);
    }

    // the same points, without the last row
    let fewer = Scene::from_points2(
        &(0..12).map(|at| [scene.point(Vertex::input(at))[0], scene.point(Vertex::input(at))[1]]).collect::<Vec<_>>(),
    )
    .unwrap();
    let later = |fault: Fault| {
        let [few, all] = [&fewer, &scene].map(|scene| Faulty { inner: sos.prepare(scene, Off).unwrap(), fault });
        let turn = Question::Orient2d(Plane::Xy);
        choices::<3>(12).iter().filter_map(|args| independence_of_later_vertices(&few, &all, turn, args)).count()
    };
    assert_eq!(later(Fault::None), 0);
    assert!(later(Fault::CountedFromTheEnd) > 0);
}

#[test]
fn a_perturbation_changes_no_sign_that_is_one() {
    let scene = grid2(3);
    let exact = Exact.prepare(&scene, Off).unwrap();
    let sos = Sos::default();
    let wrong = |fault: Fault| {
        let faulty = Faulty { inner: sos.prepare(&scene, Off).unwrap(), fault };
        let turn = Question::Orient2d(Plane::Xy);
        let triples = choices::<3>(9);
        let violations =
            triples.iter().filter_map(|args| equals_reference(&faulty, &exact, turn, args, ZeroMeaning::Never));
        violations.map(|violation| violation.answers[1].clone()).collect::<Vec<_>>()
    };
    assert_eq!(wrong(Fault::None), []);
    assert_eq!(wrong(Fault::FlippedTriple([0, 4, 8])), [], "a tie");
    let truth = &wrong(Fault::FlippedTriple([0, 1, 3]))[..];
    assert!(matches!(truth, [answer] if answer.sign == Sign::Positive), "{truth:?}");
}

/// A vertex constructed on a line is on it, however the input moves.
#[test]
fn identities_are_no_ties() {
    let mut scene = grid2(3);
    let [a, b, c, d] = [0, 8, 2, 6].map(Vertex::input);
    let v = scene.construct(Construction::Ssi([[a, b], [c, d]])).unwrap();
    let sos = Sos::default();
    let session = sos.prepare(&scene, Off).unwrap();
    let turn = Question::Orient2d(Plane::Xy);
    let zero = |args: [Vertex; 3], identity: bool| never_zero(&session, turn, &args, ZeroMeaning::Never, |_| identity);
    assert_eq!(zero([a, b, v], true), None);
    assert_eq!(zero([a, b, v], false).unwrap().law, Law::NeverZero);
    let elsewhere = [3, 5].map(Vertex::input);
    assert_eq!(zero([elsewhere[0], elsewhere[1], v], false), None, "a tie, and broken");
    assert_eq!(zero([a, a, b], false), None, "not distinct");
}

#[test]
fn zeros_of_a_band_say_nothing() {
    let scene = grid2(3);
    let session = Faulty { inner: Exact.prepare(&scene, Off).unwrap(), fault: Fault::Epsilon(1.5) };
    assert!(!planar(&session, ZeroMeaning::Exact).is_empty());
    assert_eq!(planar(&session, ZeroMeaning::Band), []);
    // but signs break laws
    let session = Faulty { inner: Exact.prepare(&scene, Off).unwrap(), fault: Fault::FlippedTriple([0, 2, 7]) };
    assert!(!planar(&session, ZeroMeaning::Band).is_empty());
}

#[test]
fn a_violation_names_its_queries() {
    let scene = grid2(3);
    let session = Faulty { inner: Exact.prepare(&scene, Off).unwrap(), fault: Fault::OneSidedPair([2, 1]) };
    let args = [1, 2].map(Vertex::input);
    let found = antisymmetry(&session, Question::Compare(Axis::X), &args, ZeroMeaning::Exact);
    let lines: Vec<String> = found.iter().map(ToString::to_string).collect();
    assert_eq!(lines, ["antisymmetry broken: compare(x; 1 2) = -, compare(x; 2 1) = -"]);
}
