//! One of two meshes moved as a whole, against whole polynomials in ε, and against a small number in place of ε.

use crate::common::{self, Random, ask_antisymmetric, grid_scene, questions};
use predicament_exact::Exact;
use predicament_predicates::formula::{Definition, Formula};
use predicament_predicates::{Axis, Backend, Construction, Counts, Derived, Off, Plane, Question, Scene, Sign, Vertex};
use predicament_sos::{PerMesh, infinitesimal::judge_per_mesh};

fn scene(random: &mut Random, dimension: usize, points: usize) -> Scene {
    let side = 3_usize;
    let numbers = random.numbers(side.pow(u32::try_from(dimension).unwrap()), points);
    let second: Vec<Vertex> = (0..points).filter(|_| random.below(2) == 0).map(Vertex::input).collect();
    grid_scene(dimension, side, &numbers).with_second_mesh(second)
}

fn args(random: &mut Random, from: usize, arity: usize) -> Vec<Vertex> {
    let mut all: Vec<usize> = (0..from).collect();
    (0..arity).map(|_| Vertex::input(all.swap_remove(random.below(all.len())))).collect()
}

/// Moved by ε = 2⁻¹⁶, in doubles that represent it exactly, the scene has exact signs.
///
/// They are those for small enough ε, as the coefficients are small integers.
#[test]
fn ties_between_meshes_are_broken_as_if_one_had_moved() {
    let (mut random, mut ties, mut zeros) = (Random(21), 0, 0);
    let rounds = predicament_effort::some_or_all(75, 300);
    for _ in 0..rounds {
        for dimension in [2, 3] {
            let scene = scene(&mut random, dimension, 6);
            let second = scene.second_mesh().unwrap();
            let epsilon = 2f64.powi(-16);
            let by = |at: usize| {
                if second[at / dimension] { epsilon.powi(1 + i32::try_from(at % dimension).unwrap()) } else { 0.0 }
            };
            let coordinates = scene.coordinates().iter().enumerate().map(|(at, x)| x + by(at)).collect();
            let moved = common::scene(dimension, coordinates).unwrap();
            let (here, there) = (Exact.prepare(&scene, Off).unwrap(), Exact.prepare(&moved, Off).unwrap());
            let session = PerMesh.prepare(&scene, Off).unwrap();
            for question in questions(dimension) {
                let args = args(&mut random, 6, question.kind().arity());
                let answer = ask_antisymmetric(&session, question, &args);
                assert_eq!(answer, judge_per_mesh(&scene, question, &args), "{question:?} of {args:?} in {scene:?}");
                assert_eq!(answer, question.ask(&there, &args), "{question:?} of {args:?} in {scene:?}");
                ties += usize::from(question.ask(&here, &args).is_zero() && !answer.is_zero());
                zeros += usize::from(answer.is_zero());
            }
        }
    }
    assert!(ties > rounds && zeros > rounds / 3, "{ties} {zeros}");
}

#[test]
fn constructed_vertices_move_with_what_defines_them() {
    let (mut random, mut ties) = (Random(22), 0);
    for _ in 0..150 {
        let mut scene = scene(&mut random, 3, 8);
        let planes = args(&mut random, 8, 8);
        let [a, b, c, d, e, f, g, h] = std::array::from_fn(|i| planes[i]);
        let lpi = scene.construct(Construction::Lpi { line: [a, b], plane: [c, d, e] }).unwrap();
        let tpi = scene.construct(Construction::Tpi([[a, b, c], [d, e, f], [g, h, a]])).unwrap();
        let (Ok(exact), Ok(session)) = (Exact.prepare(&scene, Off), PerMesh.prepare(&scene, Off)) else { continue };
        for (question, args) in [
            (Question::Compare(Axis::Y), vec![lpi, f]),
            (Question::Compare(Axis::X), vec![lpi, tpi]),
            (Question::Orient2d(Plane::Xy), vec![tpi, f, lpi]),
            (Question::Orient3d, vec![lpi, f, g, h]),
        ] {
            let answer = ask_antisymmetric(&session, question, &args);
            assert_eq!(answer, judge_per_mesh(&scene, question, &args), "{question:?} of {args:?} in {scene:?}");
            ties += usize::from(question.ask(&exact, &args).is_zero() && !answer.is_zero());
        }
    }
    assert!(ties > 20, "{ties}");
}

/// Lines and planes of one mesh each: the constructions of an overlay of two meshes.
#[test]
fn lines_and_planes_of_one_mesh_move_as_one() {
    let (mut random, mut ties, mut zeros) = (Random(23), 0, 0);
    for round in 0..120 {
        let dimension = 2 + round % 2;
        let side = 3_usize;
        let numbers = random.numbers(side.pow(u32::try_from(dimension).unwrap()), 14);
        let mut scene = grid_scene(dimension, side, &numbers).with_second_mesh((7..14).map(Vertex::input));
        let [a, b, c, d, e, f, g] = std::array::from_fn(Vertex::input);
        let [s, t, u, v, w, x, y] = std::array::from_fn(|i| Vertex::input(7 + i));
        let definitions = if dimension == 2 {
            vec![
                Construction::Ssi([[a, b], [s, t]]),
                Construction::Ssi([[c, d], [s, t]]),
                Construction::Ssi([[a, b], [c, e]]),
                Construction::Ssi([[u, v], [w, x]]),
            ]
        } else {
            vec![
                Construction::Lpi { line: [a, b], plane: [s, t, u] },
                Construction::Lpi { line: [s, t], plane: [a, b, c] },
                Construction::Lpi { line: [c, d], plane: [e, f, g] },
                Construction::Lpi { line: [v, w], plane: [a, b, c] },
                Construction::Tpi([[a, b, c], [d, e, f], [s, t, u]]),
                Construction::Tpi([[c, d, e], [v, w, x], [s, t, y]]),
            ]
        };
        // Those that meet, after the input vertices that are queried with them.
        let taken = |&definition: &Construction| {
            let mut alone = scene.clone();
            alone.construct(definition).unwrap();
            PerMesh.prepare(&alone, Off).is_ok()
        };
        let definitions: Vec<Construction> = definitions.into_iter().filter(taken).collect();
        let mut points: Vec<Vertex> = definitions.into_iter().map(|of| scene.construct(of).unwrap()).collect();
        points.extend([a, c, g, s, v]);
        let (exact, session) = (Exact.prepare(&scene, Off).unwrap(), PerMesh.prepare(&scene, Off).unwrap());
        for question in questions(dimension) {
            if matches!(question, Question::Incircle | Question::Insphere) {
                continue;
            }
            for _ in 0..6 {
                let mut left = points.clone();
                let arity = question.kind().arity();
                if left.len() < arity {
                    continue;
                }
                let args: Vec<Vertex> = (0..arity).map(|_| left.swap_remove(random.below(left.len()))).collect();
                let answer = ask_antisymmetric(&session, question, &args);
                assert_eq!(answer, judge_per_mesh(&scene, question, &args), "{question:?} of {args:?} in {scene:?}");
                ties += usize::from(question.ask(&exact, &args).is_zero() && !answer.is_zero());
                zeros += usize::from(answer.is_zero());
            }
        }
    }
    assert!(ties > 200 && zeros > 50, "{ties} {zeros}");
}

/// In units of the least coordinate, terms of different degrees in the move change their proportion.
///
/// The turns of the first scenes are −2·ε³ + ε·ε² + ε²·ε² and −ε³ + ε·ε² + ε²·ε² if the move is (ε, ε², ε³).
#[test]
fn no_answer_depends_on_the_unit_of_length() {
    let v = Vertex::input;
    let units = [1.0, 2.0, 0.25, 2f64.powi(300), 2f64.powi(-700)];
    let points = [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, 1.0],
        [1.0, -1.0, 1.0],
        [-1.0, -1.0, -1.0],
        [-1.0, 1.0, 1.0],
    ];
    for low in [-1.0, 0.0] {
        for unit in units {
            let points = points.map(|point| point.map(|x| f64::max(x, low) * unit));
            let mut scene = Scene::from_points3(&points).unwrap().with_second_mesh([4, 5, 6].map(v));
            let meet = scene.construct(Construction::Lpi { line: [v(4), v(5)], plane: [v(1), v(2), v(3)] }).unwrap();
            let session = PerMesh.prepare(&scene, Off).unwrap();
            let (turn, args) = (Question::Orient2d(Plane::Yz), [v(0), meet, v(6)]);
            let signs = [ask_antisymmetric(&session, turn, &args), judge_per_mesh(&scene, turn, &args)];
            assert_eq!(signs, [Sign::Negative; 2], "from {low} to 1 in units of {unit}");
        }
    }

    let (mut random, mut ties) = (Random(24), 0);
    for _ in 0..predicament_effort::scaled(600) {
        let numbers = random.numbers(27, 14);
        let seed = random.below(usize::MAX);
        let answers = units.map(|unit| {
            let mut random = Random(seed as u64);
            let coordinates = grid_scene(3, 3, &numbers).coordinates().iter().map(|x| x * unit).collect();
            let mut scene = common::scene(3, coordinates).unwrap().with_second_mesh((7..14).map(v));
            let mut flat = |from: usize| args(&mut random, 7, 3).into_iter().map(move |at| v(from + at.index()));
            let mut points = vec![v(0), v(6), v(7), v(13)];
            for from in [0, 7, 0, 7] {
                let (line, plane): (Vec<Vertex>, Vec<Vertex>) =
                    (flat(from).take(2).collect(), flat(7 - from).collect());
                let of = Construction::Lpi { line: line.try_into().unwrap(), plane: plane.try_into().unwrap() };
                let mut with = scene.clone();
                let meet = with.construct(of).unwrap();
                if PerMesh.prepare(&with, Off).is_ok() {
                    scene = with;
                    points.push(meet);
                }
            }
            let (exact, session) = (Exact.prepare(&scene, Off).unwrap(), PerMesh.prepare(&scene, Off).unwrap());
            let mut signs = Vec::new();
            for question in questions(3) {
                if matches!(question, Question::Incircle | Question::Insphere) {
                    continue;
                }
                for _ in 0..6 {
                    let mut left = points.clone();
                    let mut one = || left.swap_remove(random.below(left.len()));
                    let args: Vec<Vertex> = (0..question.kind().arity()).map(|_| one()).collect();
                    let sign = question.ask(&session, &args);
                    assert_eq!(sign, judge_per_mesh(&scene, question, &args), "{question:?} of {args:?} in {scene:?}");
                    ties += usize::from(question.ask(&exact, &args).is_zero() && !sign.is_zero());
                    signs.push(sign);
                }
            }
            signs
        });
        assert!(answers.iter().all(|signs| *signs == answers[0]), "{answers:?} of {numbers:?} by {seed}");
    }
    assert!(ties > 500, "{ties}");
}

/// The formula is δy − δx² where d moves from c: ε² − ε·ε, which is zero, if only the powers of ε count.
#[test]
fn ties_of_formulas_are_decided_by_the_lowest_degree() {
    let text = "(d.y - c.y) * (b.x - a.x) - (d.x - c.x) * (d.x - c.x)";
    let derived = Derived::new(Formula::new(Definition::anonymous(text)).unwrap()).unwrap();
    let points = [[0.0, 0.0], [1.0, 0.0], [3.0, 3.0], [3.0, 3.0]];
    let scene = Scene::from_points2(&points).unwrap().with_second_mesh([Vertex::input(3)]);
    let (question, args) = (Question::Derived(derived), derived.formula().points());
    let args: Vec<Vertex> = args.iter().map(|name| Vertex::input(usize::from(name.as_bytes()[0] - b'a'))).collect();
    let answer = question.ask(&PerMesh.prepare(&scene, Off).unwrap(), &args);
    assert_eq!([answer, judge_per_mesh(&scene, question, &args)], [Sign::Positive; 2]);
}

/// The first nonzero derivative decides: that by x, y or z.
#[test]
fn ties_are_counted_by_the_power_that_decides() {
    // Three points of each coordinate plane, with the origin, and a point of the other mesh on all three planes.
    let points = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.], [2., 0., 0.], [0., 2., 0.], [0., 0., 2.]];
    let v = Vertex::input;
    let scene = Scene::from_points3(&points).unwrap().with_second_mesh([4, 5, 6].map(v));
    let power = |question: Question, args: &[usize]| {
        let counts = Counts::new();
        let session = PerMesh.prepare(&scene, &counts).unwrap();
        assert!(!question.ask(&session, &args.iter().map(|&at| v(at)).collect::<Vec<_>>()).is_zero());
        let stage = (0..PerMesh.stages().len()).find(|&stage| counts.get(question.kind(), stage) > 0).unwrap();
        PerMesh.stages()[stage]
    };
    let powers = ["power 1", "power 2", "power 3"];
    for (axis, expected) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(powers) {
        // The origin and a point on another axis than this.
        let other = 4 + (axis.index() + 1) % 3;
        assert_eq!(power(Question::Compare(axis), &[0, other]), expected);
        assert_eq!(power(Question::Compare(axis), &[other, 0]), expected);
    }
    // On the line along an axis a move along the other axis of the plane decides.
    for (plane, along, expected) in [
        (Plane::Xy, 0, powers[1]),
        (Plane::Xy, 1, powers[0]),
        (Plane::Yz, 1, powers[2]),
        (Plane::Yz, 2, powers[1]),
        (Plane::Zx, 0, powers[2]),
        (Plane::Zx, 2, powers[0]),
    ] {
        assert_eq!(power(Question::Orient2d(plane), &[0, 1 + along, 4 + along]), expected, "{plane:?}, {along}");
    }
    // In a plane across an axis a move along that axis decides.
    for (across, expected) in powers.into_iter().enumerate() {
        let [one, other] = [(across + 1) % 3, (across + 2) % 3];
        assert_eq!(power(Question::Orient3d, &[0, 1 + one, 1 + other, 4 + one]), expected);
    }
}

#[test]
fn a_mesh_keeps_its_own_ties_and_scenes_without_two_are_declined() {
    let flat = grid_scene(2, 3, &[0, 4, 8, 1]);
    assert!(PerMesh.prepare(&flat, Off).err().unwrap().reason.contains("no two meshes"));
    let v = Vertex::input;
    let scene = flat.with_second_mesh([v(3)]);
    let session = PerMesh.prepare(&scene, Off).unwrap();
    let ask = |question: Question, args: &[Vertex]| question.ask(&session, args);
    assert_eq!(ask(Question::Orient2d(Plane::Xy), &[v(0), v(1), v(2)]), Sign::Zero, "three of one mesh on a line");
    // (0, 0) and (1, 0) + (ε, ε²): the second is above.
    assert_eq!(ask(Question::Compare(Axis::Y), &[v(0), v(3)]), Sign::Negative);
}
