//! Laws between answers, independent of the method.
//!
//! The perturbed vertices are points in general position. So the signs of their orientations change with every swap of
//! two arguments, and they obey the three-term Grassmann-Plücker relations: for rank r, any r − 2 vectors X and four
//! more,
//!
//! [X a b][X c d] − [X a c][X b d] + [X a d][X b c] = 0,
//!
//! hence of the three products, with their signs, either all are zero or there is one of each sign. The vectors are the
//! rows (coordinates, lift, 1) of the vertices, and the unit vectors of the coordinates and of the lift. With those,
//! the relations connect `orient3d` to its projections, these to `compare`, and `incircle` and `insphere` to the
//! orientation. No judge is needed.

use crate::common::{self, Random, ask_antisymmetric, first, grid_scene, questions};
use predicament_exact::Exact;
use predicament_predicates::{
    Axis, Backend, Construction, Off, Plane, PredicateKind, Predicates, Question, Scene, Sign, Vertex, answer_by,
};
use predicament_sos::{Scheme, Sos, Term, ties};

/// A vertex of the scene, or the unit vector of a column.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Row {
    Vertex(usize),
    Unit(usize),
}

/// The signs of all determinants of `rank` rows out of a list.
///
/// `rank` is the number of columns: coordinates, lift, ones.
struct Chirotope {
    rows: usize,
    rank: usize,
    signs: Vec<Sign>,
}

impl Chirotope {
    fn new(session: &impl Predicates, lifted: bool, rows: &[Row]) -> Chirotope {
        let dimension = session.scene().dimension().count();
        let rank = dimension + usize::from(lifted) + 1;
        let signs = common::words(rows.len(), u32::try_from(rank).unwrap())
            .map(|word| determinant(session, rank, lifted, word.iter().map(|&place| rows[place]).collect()))
            .collect();
        Chirotope { rows: rows.len(), rank, signs }
    }

    fn sign(&self, places: &[usize]) -> Sign {
        self.signs[places.iter().rev().fold(0, |index, place| index * self.rows + place)]
    }

    /// The number of violations of both laws.
    fn violations(&self) -> usize {
        self.asymmetries() + self.contradictions()
    }

    /// The number of determinants that don't change their sign with a swap of two neighbours.
    fn asymmetries(&self) -> usize {
        let violated = |word: &Vec<usize>| {
            (1..self.rank).any(|place| {
                let mut swapped = word.clone();
                swapped.swap(place - 1, place);
                self.sign(&swapped) != -self.sign(word)
            })
        };
        common::words(self.rows, u32::try_from(self.rank).unwrap()).filter(violated).count()
    }

    /// The number of violated Grassmann-Plücker relations.
    fn contradictions(&self) -> usize {
        let combinations = |size| combinations(self.rows, size);
        let fours = combinations(4);
        let mut violations = 0;
        for fixed in combinations(self.rank - 2) {
            for four in fours.iter().filter(|four| four.iter().all(|place| !fixed.contains(place))) {
                let bracket = |i: usize, j: usize| self.sign(&[fixed.as_slice(), &[four[i], four[j]]].concat());
                let products =
                    [bracket(0, 1) * bracket(2, 3), -(bracket(0, 2) * bracket(1, 3)), bracket(0, 3) * bracket(1, 2)];
                let both = products.contains(&Sign::Positive) && products.contains(&Sign::Negative);
                violations += usize::from(!both && products != [Sign::Zero; 3]);
            }
        }
        violations
    }
}

/// All subsets of 0..n of this size, ascending.
fn combinations(n: usize, size: usize) -> Vec<Vec<usize>> {
    let Some(less) = size.checked_sub(1) else { return vec![Vec::new()] };
    (0..n)
        .flat_map(|last| combinations(last, less).into_iter().map(move |rest| [rest.as_slice(), &[last]].concat()))
        .collect()
}

/// A determinant by predicates: unit rows strike their columns.
fn determinant(session: &impl Predicates, rank: usize, lifted: bool, mut rows: Vec<Row>) -> Sign {
    let mut columns: Vec<usize> = (0..rank).collect();
    let mut sign = Sign::Positive;
    while let Some(row) = rows.iter().position(|row| matches!(row, Row::Unit(_))) {
        let Row::Unit(unit) = rows.remove(row) else { unreachable!() };
        let Some(column) = columns.iter().position(|&column| column == unit) else { return Sign::Zero };
        columns.remove(column);
        if (row + column) % 2 == 1 {
            sign = -sign;
        }
    }
    let vertices: Vec<Vertex> = rows
        .into_iter()
        .filter_map(|row| if let Row::Vertex(index) = row { Some(Vertex::input(index)) } else { None })
        .collect();
    columns.pop();
    let lift_left = lifted && columns.last() == Some(&(rank - 2));
    let (question, orientation) = match columns.as_slice() {
        _ if lift_left && rank == 4 => (Question::Incircle, Sign::Positive),
        _ if lift_left => (Question::Insphere, Sign::Positive),
        [] => return sign,
        [axis] => (Question::Compare([Axis::X, Axis::Y, Axis::Z][*axis]), Sign::Positive),
        [0, 1] => (Question::Orient2d(Plane::Xy), Sign::Positive),
        [1, 2] => (Question::Orient2d(Plane::Yz), Sign::Positive),
        [0, 2] => (Question::Orient2d(Plane::Zx), Sign::Negative),
        _ => (Question::Orient3d, Sign::Positive),
    };
    sign * orientation * question.ask(session, &vertices)
}

/// The vertices of a scene and the unit vectors of some columns.
fn rows(vertices: usize, units: std::ops::Range<usize>) -> Vec<Row> {
    (0..vertices).map(Row::Vertex).chain(units.map(Row::Unit)).collect()
}

/// A backend with one table replaced.
struct Faulty<'s> {
    exact: predicament_exact::Session<'s, Off>,
    scheme: Scheme,
    terms: Vec<Term>,
    kind: PredicateKind,
    fault: Fault,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Fault {
    /// Only the table may be wrong.
    Table,
    /// The sign of the sorting permutation is ignored.
    NoParity,
    /// Places in the argument list replace identities.
    Positions,
}

impl Faulty<'_> {
    fn answer<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let exact = question.ask(&self.exact, &args);
        let (true, Some(sorted)) = (exact.is_zero(), ties::Sorted::new(args)) else { return exact };
        let kind = question.kind();
        let terms = if kind == self.kind { &self.terms } else { self.scheme.terms(kind) };
        let (rows, parity) = match self.fault {
            Fault::Table => (sorted.vertices, sorted.parity),
            Fault::NoParity => (sorted.vertices, Sign::Positive),
            Fault::Positions => (args, Sign::Positive),
        };
        ties::decide(&self.exact, question, terms, &rows).map_or(Sign::Zero, |(sign, _)| sign * parity)
    }
}

impl Predicates for Faulty<'_> {
    fn scene(&self) -> &Scene {
        self.exact.scene()
    }
    answer_by!(answer);
}

fn violations(scheme: Scheme, scene: &Scene, lifted: bool, rows: &[Row]) -> usize {
    let sos = Sos { scheme };
    Chirotope::new(&sos.prepare(scene, Off).unwrap(), lifted, rows).violations()
}

/// The numbers 0..n in an order unrelated to the grid's.
fn shuffled(n: usize, seed: u64) -> Vec<usize> {
    let mut random = Random(seed);
    let mut numbers: Vec<usize> = (0..n).collect();
    for last in (1..n).rev() {
        numbers.swap(last, random.below(last + 1));
    }
    numbers
}

#[test]
fn the_4_by_4_grid() {
    let scenes = [grid_scene(2, 4, &(0..16).collect::<Vec<_>>()), grid_scene(2, 4, &shuffled(16, 1))];
    for scheme in Scheme::ALL {
        for scene in &scenes {
            assert_eq!(violations(scheme, scene, false, &rows(16, 0..2)), 0, "{scheme}");
        }
    }
}

#[test]
fn the_3_by_3_by_3_grid() {
    for scheme in Scheme::ALL {
        let scene = grid_scene(3, 3, &shuffled(27, 2));
        let mut rows = rows(27, 0..3);
        // Some vertices and all units: vertices of all layers, rows and columns.
        let kept = predicament_effort::some_or_all(14, 27);
        rows.drain(kept..27);
        assert_eq!(violations(scheme, &scene, false, &rows), 0, "{scheme}");
    }
}

/// Some grid points several times.
#[test]
fn coincident_vertices() {
    let mut random = Random(9);
    for scheme in Scheme::ALL {
        for _ in 0..predicament_effort::some_or_all(4, 10) {
            let plane = grid_scene(2, 3, &random.numbers(9, 12));
            assert_eq!(violations(scheme, &plane, false, &rows(12, 0..2)), 0, "{scheme}");
            let space = grid_scene(3, 2, &random.numbers(8, 12));
            assert_eq!(violations(scheme, &space, false, &rows(12, 0..3)), 0, "{scheme}");
        }
    }
}

/// The laws of the lifted vertices and the direction of the lift; its minors are `orient2d`.
#[test]
fn circles_are_orientations_of_lifted_vertices() {
    let mut random = Random(10);
    for scheme in Scheme::ALL {
        let grid = grid_scene(2, 4, &shuffled(16, 3));
        assert_eq!(violations(scheme, &grid, true, &rows(16, 2..3)), 0, "{scheme}");
        for _ in 0..10 {
            let coincident = grid_scene(2, 3, &random.numbers(9, 9));
            assert_eq!(violations(scheme, &coincident, true, &rows(9, 2..3)), 0, "{scheme}");
        }
    }
}

#[test]
fn spheres_are_orientations_of_lifted_vertices() {
    let mut random = Random(11);
    for scheme in Scheme::ALL {
        let cube = grid_scene(3, 2, &shuffled(8, 4));
        assert_eq!(violations(scheme, &cube, true, &rows(8, 3..4)), 0, "{scheme}");
        for _ in 0..predicament_effort::some_or_all(3, 8) {
            let coincident = grid_scene(3, 2, &random.numbers(8, 8));
            assert_eq!(violations(scheme, &coincident, true, &rows(8, 3..4)), 0, "{scheme}");
            let grid = grid_scene(3, 3, &random.numbers(27, 8));
            assert_eq!(violations(scheme, &grid, true, &rows(8, 3..4)), 0, "{scheme}");
        }
    }
}

/// The laws alone detect a planted fault: each swapped sign, if the vertices reach the term.
#[test]
fn a_swapped_sign_breaks_the_laws() {
    let mut random = Random(12);
    let planes: Vec<Scene> = (0..6).map(|_| grid_scene(2, 3, &random.numbers(9, 9))).collect();
    let spaces: Vec<Scene> = (0..6).map(|_| grid_scene(3, 2, &random.numbers(8, 9))).collect();
    for scheme in Scheme::ALL {
        for kind in [PredicateKind::Compare, PredicateKind::Orient2d, PredicateKind::Orient3d] {
            let scenes = if kind == PredicateKind::Orient3d { &spaces } else { &planes };
            let count = scheme.terms(kind).len();
            for fault in (0..count).map(Some).chain([None]) {
                let mut terms = scheme.terms(kind).to_vec();
                if let Some(term) = fault {
                    terms[term].sign = -terms[term].sign;
                }
                let broken = scenes.iter().any(|scene| {
                    let exact = Exact.prepare(scene, Off).unwrap();
                    let faulty = Faulty { exact, scheme, terms: terms.clone(), kind, fault: Fault::Table };
                    let units = 0..scene.dimension().count();
                    Chirotope::new(&faulty, false, &rows(9, units)).violations() > 0
                });
                assert_eq!(broken, fault.is_some(), "{scheme} {kind}, swapped term {fault:?}");
            }
        }
    }
}

#[test]
fn arguments_that_are_not_sorted_rightly_break_the_laws() {
    let scene = grid_scene(2, 3, &shuffled(9, 5));
    for scheme in Scheme::ALL {
        for fault in [Fault::NoParity, Fault::Positions, Fault::Table] {
            let exact = Exact.prepare(&scene, Off).unwrap();
            let kind = PredicateKind::Orient2d;
            let faulty = Faulty { exact, scheme, terms: scheme.terms(kind).to_vec(), kind, fault };
            let violations = Chirotope::new(&faulty, false, &rows(9, 0..2)).violations();
            assert_eq!(violations > 0, fault != Fault::Table, "{scheme} {fault:?}");
        }
    }
}

#[test]
fn compare_is_a_total_order() {
    let mut random = Random(13);
    for scheme in Scheme::ALL {
        let scene = grid_scene(3, 2, &random.numbers(8, 12));
        let sos = Sos { scheme };
        let session = sos.prepare(&scene, Off).unwrap();
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            let below = |&a: &Vertex, &b: &Vertex| session.compare(axis, a, b) == Sign::Negative;
            for a in scene.vertices() {
                for b in scene.vertices() {
                    assert!(a == b || below(&a, &b) != below(&b, &a), "total");
                    for c in scene.vertices() {
                        assert!(!below(&a, &b) || !below(&b, &c) || below(&a, &c), "transitive: {a} {b} {c}");
                    }
                }
            }
        }
    }
}

/// Every tie of a grid, in every order of the arguments.
#[test]
fn all_orders_of_the_arguments_agree() {
    let mut random = Random(14);
    for scheme in Scheme::ALL {
        let sos = Sos { scheme };
        for dimension in [2, 3] {
            for _ in 0..200 {
                let scene = grid_scene(dimension, 2, &random.numbers(4, 5));
                let session = sos.prepare(&scene, Off).unwrap();
                for question in questions(dimension) {
                    assert!(!ask_antisymmetric(&session, question, &first(question.kind().arity())).is_zero());
                }
            }
        }
    }
}

#[test]
fn scenes_with_constructed_vertices_are_declined_where_lifts_move_on_their_own() {
    let mut scene = Scene::from_points2(&[[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]]).unwrap();
    let [a, b, c, d] = [0, 1, 2, 3].map(Vertex::input);
    scene.construct(Construction::Ssi([[a, b], [c, d]])).unwrap();
    assert!(Sos::default().prepare(&scene, Off).is_ok());
    let lifting = Sos { scheme: Scheme::EdelsbrunnerMucke };
    let declined = lifting.prepare(&scene, Off).map(|_| ()).expect_err("its terms are of input vertices");
    assert!(declined.predicate.is_none() && declined.reason.contains("constructed"), "{declined}");
}
