//! The laws hold for what keeps them, and each catches a planted fault.

mod common;

use common::{Fault, Faulty};
use predicament_checks::axioms::{Law, Violation, antisymmetry, grassmann_plucker2, grassmann_plucker3, transitivity};
use predicament_exact::Exact;
use predicament_predicates::{
    Axis, Backend, Off, Plane, PredicateKind, Predicates, Question, Scene, Vertex, ZeroMeaning,
};
use predicament_sos::{Scheme, Sos};

/// All points of a small grid: every kind of tie comes up.
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

/// Everything that the laws say about the planar predicates.
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
    }
    for five in choices::<5>(n) {
        for at in 0..5 {
            let mut five = five;
            five[..=at].rotate_right(1);
            let [shared, others @ ..] = five;
            found.extend(grassmann_plucker2(session, Plane::Xy, shared, others, zero));
        }
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
    }
    for six in choices::<6>(n) {
        for (i, j) in (0..6).flat_map(|j| (0..j).map(move |i| (i, j))) {
            let others: Vec<Vertex> = (0..6).filter(|at| ![i, j].contains(at)).map(|at| six[at]).collect();
            let others = others.try_into().expect("four are left");
            found.extend(grassmann_plucker3(session, [six[i], six[j]], others, zero));
        }
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
    let incircle = |found: &mut Vec<Violation>, session: &dyn Fn(&[Vertex]) -> Vec<Violation>| {
        choices::<4>(9).iter().for_each(|args| found.extend(session(args)));
    };
    let exact = Exact.prepare(&flat, Off).unwrap();
    let mut found = planar(&exact, ZeroMeaning::Exact);
    incircle(&mut found, &|args| antisymmetry(&exact, Question::Incircle, args, ZeroMeaning::Exact));
    found.extend(spatial(&Exact.prepare(&deep, Off).unwrap(), ZeroMeaning::Exact));
    assert_eq!(found, []);
    for scheme in [Scheme::PerCoordinate, Scheme::EdelsbrunnerMucke] {
        let sos = Sos { scheme };
        assert_eq!(sos.contract(PredicateKind::Orient2d).zero, ZeroMeaning::Never);
        let session = sos.prepare(&flat, Off).unwrap();
        let mut found = planar(&session, ZeroMeaning::Never);
        incircle(&mut found, &|args| antisymmetry(&session, Question::Incircle, args, ZeroMeaning::Never));
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
    assert_eq!(planted(Fault::OneSidedPair([2, 7])), [Law::Antisymmetry, Law::Transitivity]);
    // in every order the same, so that only the other laws can tell
    assert_eq!(planted(Fault::MirroredPair([0, 8])), [Law::Transitivity]);
    assert_eq!(planted(Fault::FlippedTriple([0, 2, 7])), [Law::GrassmannPlucker]);
    // one tie of three neighbours on a line, broken the other way, is what another
    // perturbation says: laws can't object, only the judge of this one can
    assert_eq!(planted(Fault::FlippedTriple([0, 4, 8])), []);

    let exact = |fault: Fault| {
        let inner = Exact.prepare(&scene, Off).unwrap();
        laws(&planar(&Faulty { inner, fault }, ZeroMeaning::Never))
    };
    assert_eq!(exact(Fault::TiesByPlace), [Law::Antisymmetry]);

    let scene = grid3();
    let planted = |fault: Fault| {
        let inner = Exact.prepare(&scene, Off).unwrap();
        laws(&spatial(&Faulty { inner, fault }, ZeroMeaning::Exact))
    };
    assert_eq!(planted(Fault::None), []);
    assert_eq!(planted(Fault::FlippedQuadruple([0, 1, 2, 4])), [Law::GrassmannPlucker]);
}

#[test]
fn zeros_of_a_band_say_nothing() {
    let scene = grid2(3);
    let session = Faulty { inner: Exact.prepare(&scene, Off).unwrap(), fault: Fault::Epsilon(1.5) };
    assert!(!planar(&session, ZeroMeaning::Exact).is_empty());
    assert_eq!(planar(&session, ZeroMeaning::Band), []);
    // but signs do
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
    assert_eq!(lines, ["antisymmetry broken by compare: (1 2) = -, (2 1) = -"]);
}
