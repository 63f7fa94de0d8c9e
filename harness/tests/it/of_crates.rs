//! The engines of published crates: their conventions, the counterexamples, and the tables of the pages. The engines
//! have to be built; `cargo xtask nightly` builds them and runs these tests.

use std::path::Path;

use crate::common::{at, column, read, told, tool};
use predicament_engines::Engine;
use predicament_judge as judge;
use predicament_predicates::{
    Axis, Backend, Dimension, Off, Plane, PredicateKind, Predicates, Question, Scene, Sign, Vertex, ZeroMeaning,
};

/// The folder of engines.
const ENGINES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../engines");

/// All engines in Rust.
const ALL: [&str; 10] = [
    "robust",
    "geometry-predicates",
    "geogram-predicates",
    "geogram-predicates-sos",
    "simplicity",
    "delaunay",
    "delaunay-sorted",
    "rgeometry",
    "axiolid",
    "hyperlimit",
];

fn engine(name: &str) -> Engine {
    let file = Path::new(ENGINES).join(name).join("engine.toml");
    Engine::find(&file.display().to_string()).unwrap_or_else(|why| panic!("{why}"))
}

/// The output of the tool with the engines, without the folder of the tests.
fn with_engines(code: i32, args: &[&str]) -> String {
    let told = told(tool(args).env("PREDICAMENT_ENGINES", ENGINES).output().expect("the tool starts"));
    assert_eq!(told.code, code, "{args:?}\nstdout: {}\nstderr: {}", told.stdout, told.stderr);
    told.stdout
}

fn questions(dimension: Dimension) -> &'static [Question] {
    match dimension {
        Dimension::Two => &[Question::Compare(Axis::Y), Question::Orient2d(Plane::Xy), Question::Incircle],
        Dimension::Three => &[
            Question::Compare(Axis::Z),
            Question::Orient2d(Plane::Yz),
            Question::Orient2d(Plane::Zx),
            Question::Orient3d,
            Question::Insphere,
        ],
    }
}

fn v<const N: usize>(ids: [usize; N]) -> [Vertex; N] {
    ids.map(Vertex::input)
}

/// Random numbers by a linear congruence (Knuth's MMIX constants), from the high bits.
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }
}

/// Compares each predicate of each engine with the truth on 1,000 random queries on grids of ±1, ±2 and ±30.
#[test]
#[ignore = "needs the engines in Rust, built"]
fn conventions_are_mapped_on_small_integers() {
    let mut random = Random(20);
    let mut seen = Vec::new();
    for name in ALL {
        let engine = engine(name);
        let zero = engine.contract(PredicateKind::Orient2d).zero;
        for (dimension, size) in
            [Dimension::Two, Dimension::Three].into_iter().flat_map(|d| [1_u32, 2, 30].map(|size| (d, size)))
        {
            let coordinate = |random: &mut Random| {
                let up = u32::try_from(random.below(u64::from(2 * size + 1))).expect("small");
                f64::from(up) - f64::from(size)
            };
            let coordinates = (0..60 * dimension.count()).map(|_| coordinate(&mut random)).collect();
            let scene = Scene::new(dimension, coordinates).unwrap();
            let session = engine.prepare(&scene, Off).unwrap();
            for &question in questions(dimension).iter().filter(|q| session.supports(q.kind()).is_ok()) {
                seen.push((name, question.kind()));
                for _ in 0..334 {
                    let mut args: Vec<Vertex> = Vec::new();
                    while args.len() < question.kind().arity() {
                        let one = Vertex::input(usize::try_from(random.below(60)).expect("small"));
                        if !args.contains(&one) {
                            args.push(one);
                        }
                    }
                    let (answer, truth) = (question.ask(&session, &args), judge::sign(&scene, question, &args));
                    let is_right = answer == truth || truth.is_zero() && zero == ZeroMeaning::Never;
                    assert!(is_right, "{name}: {} is {truth} and not {answer}", question.query(&args));
                }
            }
        }
    }
    seen.sort_unstable();
    seen.dedup();
    let offered = |name| seen.iter().filter(|(of, _)| *of == name).map(|(_, kind)| *kind).collect::<Vec<_>>();
    use PredicateKind::{Incircle, Insphere, Orient2d};
    for name in ALL {
        let expected: &[PredicateKind] = match name {
            "simplicity" | "hyperlimit" => &PredicateKind::ALL,
            "rgeometry" => &[Orient2d],
            "geogram-predicates-sos" => &[Incircle, Insphere],
            _ => &PredicateKind::ALL[1..],
        };
        assert_eq!(offered(name), expected, "{name}");
    }
}

#[test]
#[ignore = "needs the engines in Rust, built"]
fn a_vertex_twice_is_a_zero_and_no_panic() {
    let scene = Scene::from_points2(&[[3.0, 1.0], [-7.0, 2.0], [5.0, 11.0]]).unwrap();
    let asked = [
        (Question::Orient2d(Plane::Xy), [0, 1, 0].as_slice()),
        (Question::Incircle, &[0, 1, 0, 2]),
        (Question::Incircle, &[0, 1, 2, 0]),
    ];
    let mut zeros = 0;
    for name in ALL {
        let engine = engine(name);
        let session = engine.prepare(&scene, Off).unwrap();
        for (question, ids) in asked.iter().filter(|(question, _)| session.supports(question.kind()).is_ok()) {
            let args: Vec<Vertex> = ids.iter().map(|&id| Vertex::input(id)).collect();
            assert!(question.ask(&session, &args).is_zero(), "{name}: {}", question.query(&args));
            zeros += 1;
        }
    }
    // Nine engines have orient2d, asked once, and nine have incircle, asked twice.
    assert_eq!(zeros, 27);
}

/// Ten vertices in the plane, at the origin unless given.
fn ten(points: &[(usize, [f64; 2])]) -> Scene {
    let mut coordinates = [[0.0; 2]; 10];
    for &(at, point) in points {
        coordinates[at] = point;
    }
    Scene::from_points2(&coordinates).unwrap()
}

/// The sign of orient2d for three vertices and incircle for four.
fn ask(name: &str, scene: &Scene, ids: &[usize]) -> Sign {
    let question = if ids.len() == 3 { Question::Orient2d(Plane::Xy) } else { Question::Incircle };
    let args: Vec<Vertex> = ids.iter().map(|&id| Vertex::input(id)).collect();
    question.ask(&engine(name).prepare(scene, Off).unwrap(), &args)
}

/// Three products whose sum is zero for all points.
type Relation = [[&'static [usize]; 2]; 3];

/// Four orientations at vertex 8.
const TURNS: Relation = [[&[8, 0, 1], &[8, 2, 9]], [&[8, 2, 0], &[8, 1, 9]], [&[8, 0, 9], &[8, 1, 2]]];

/// Orientations and incircle tests at vertices 1 and 7.
const CIRCLES: Relation = [[&[1, 7, 3], &[1, 7, 5, 9]], [&[1, 5, 7], &[1, 7, 3, 9]], [&[1, 7, 9], &[1, 7, 3, 5]]];

/// The determinant of the rows (x, y, 1) or (x, y, x² + y², 1), on integers.
fn determinant(points: &[[i64; 2]], ids: &[usize]) -> i64 {
    let last = points[*ids.last().unwrap()];
    let row = |&id: &usize| {
        let [x, y] = [points[id][0] - last[0], points[id][1] - last[1]];
        [x, y, x * x + y * y]
    };
    let rows: Vec<[i64; 3]> = ids[..ids.len() - 1].iter().map(row).collect();
    let minor = |i: usize, j: usize| rows[i][0] * rows[j][1] - rows[j][0] * rows[i][1];
    match rows.len() {
        2 => minor(0, 1),
        // Expand along the column of lifts, the third of three.
        _ => minor(1, 2) * rows[0][2] - minor(0, 2) * rows[1][2] + minor(0, 1) * rows[2][2],
    }
}

#[test]
fn the_relations_hold_for_points_that_are_somewhere() {
    let mut random = Random(7);
    for _ in 0..50 {
        let coordinate = |random: &mut Random| i64::try_from(random.below(97)).unwrap();
        let points: Vec<[i64; 2]> = (0..10).map(|_| [coordinate(&mut random), coordinate(&mut random)]).collect();
        for relation in [TURNS, CIRCLES] {
            let products = relation.map(|[f, g]| determinant(&points, f) * determinant(&points, g));
            assert!(products.iter().any(|&product| product != 0));
            assert_eq!(products.iter().sum::<i64>(), 0);
        }
    }
}

#[test]
#[ignore = "needs the engines in Rust, built"]
fn counterexamples_to_relations_stand() {
    let products = |name, scene: &Scene, relation: Relation| {
        relation.map(|[f, g]: [&[usize]; 2]| ask(name, scene, f) * ask(name, scene, g))
    };
    let circles = ten(&[(1, [-1., 0.]), (3, [0., -1.]), (5, [0., 1.]), (7, [1., 0.]), (9, [1., 0.])]);
    assert_eq!(products("simplicity", &circles, CIRCLES), [Sign::Positive; 3]);
    let turns = ten(&[(0, [-1., -1.]), (8, [-1., -1.]), (1, [0., -1.]), (2, [1., 1.])]);
    assert_eq!(products("rgeometry", &turns, TURNS), [Sign::Negative; 3]);
}

#[test]
#[ignore = "needs the engines in Rust, built"]
fn delaunay_takes_places_for_vertices() {
    let line = ten(&[(0, [-1., -1.]), (1, [-1., 0.]), (2, [-1., 1.])]);
    let turns = |name| [[0, 1, 2], [0, 2, 1]].map(|turn| ask(name, &line, &turn));
    assert_eq!(turns("delaunay"), [Sign::Negative; 2]);
    let [turn, swapped] = turns("delaunay-sorted");
    assert_eq!(turn, -swapped);
    // The crate's callers sort the simplex and put the query point last.
    let square = ten(&[(0, [-1., -1.]), (1, [-1., 0.]), (3, [0., -1.]), (4, [0., 0.])]);
    let circles = [[0, 1, 3, 4], [0, 1, 4, 3]].map(|circle| ask("delaunay-sorted", &square, &circle));
    assert_eq!(circles, [Sign::Positive; 2]);
}

#[test]
#[ignore = "needs the engines in Rust, built"]
fn counterexamples_of_wrong_signs_stand() {
    use Sign::{Negative, Positive, Zero};
    let (small, large) = (-(2f64.powi(-14)), 2f64.powi(27));
    let circle = ten(&[(0, [small, 0.]), (2, [0., small]), (5, [0., large]), (8, [large, small])]);
    assert_eq!(judge::sign(&circle, Question::Incircle, &v([5, 0, 2, 8])), Negative);
    assert_eq!(ask("geogram-predicates-sos", &circle, &[5, 0, 2, 8]), Positive);
    let cases = [
        ([[0.3, 0.4], [0.8, 0.9], [1.8, 1.9]], Zero, Negative),
        ([[-0.29, -0.187], [-0.079, 0.109], [-1.134, -1.371]], Negative, Zero),
        ([[0.248, 0.052], [1.186, 1.928], [0.114, -0.216]], Negative, Positive),
    ];
    for (points, said, exact) in cases {
        let [a, b, c] = points;
        let scene = ten(&[(0, a), (1, b), (2, c)]);
        assert_eq!(judge::sign(&scene, Question::Orient2d(Plane::Xy), &v([0, 1, 2])), exact);
        assert_eq!(ask("axiolid", &scene, &[0, 1, 2]), said);
    }
    // Twice the area is 1e-400, which is not zero but no double.
    let underflow = ten(&[(1, [1e-200, 0.0]), (2, [0.0, 1e-200])]);
    assert_eq!(judge::sign(&underflow, Question::Orient2d(Plane::Xy), &v([0, 1, 2])), Positive);
    assert_eq!(["robust", "geometry-predicates"].map(|name| ask(name, &underflow, &[0, 1, 2])), [Zero; 2]);
}

/// The table of `docs/PEERS.md` is the tool's current output.
#[test]
#[ignore = "needs the engines in Rust, built, and fetched data"]
fn the_committed_table_of_wrong_answers_is_the_one_that_comes_out() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = at(&folder, "run");
    let engines = ["robust", "geometry-predicates", "geogram-predicates", "simplicity"];
    let names: Vec<String> = engines.iter().map(|name| format!("engine:{name}")).collect();
    let backends = format!("exact,{}", names.join(","));
    with_engines(100, &["run", "families", "decimals", "fixtures", "-b", &backends, "--out", &out]);
    let summary = read(&out, "summary.csv");
    let all = |name: &str| column(&summary, name);
    let number = |name: &str| -> Vec<u64> { all(name).iter().map(|n| n.parse().expect("a count")).collect() };
    let classes = ["overreach", "missed_zero", "sign_flip", "nan"].map(number);
    let (queries, declined, panics) = (number("queries"), number("declined"), number("panic"));
    let (scenes, backends) = (all("scene"), all("backend"));
    let cell = |row: usize| -> String {
        let wrong: u64 = classes.iter().map(|class| class[row]).sum();
        match (declined[row], panics[row], classes[3][row]) {
            (1.., ..) => String::new(),
            (_, 1.., _) => "breaks off".to_owned(),
            (_, _, 0) => wrong.to_string(),
            (_, _, nan) => format!("{wrong}, {nan} NaN"),
        }
    };
    let exact: Vec<usize> = (0..scenes.len()).filter(|&row| backends[row] == "exact").collect();
    assert!(exact.iter().all(|&row| cell(row) == "0"), "{summary}");
    let mut table = String::new();
    for row in exact {
        let of =
            |name: &String| (row..scenes.len()).find(|&other| backends[other] == *name).map_or_else(String::new, cell);
        let cells: Vec<String> = names.iter().map(of).collect();
        if cells.iter().any(|cell| !["", "0"].contains(&cell.as_str())) {
            table += &format!("| {} | {} | 0 | {} |\n", scenes[row], queries[row], cells.join(" | "));
        }
    }
    assert!(table.lines().count() > 10, "{table}");
    let page = include_str!("../../../docs/PEERS.md");
    assert!(page.contains(&table), "docs/PEERS.md has another table than this one:\n{table}");
}

/// The crates violate exactly the laws listed in `docs/LAWS.md`.
#[test]
#[ignore = "needs the engines in Rust, built"]
fn the_committed_table_of_laws_is_the_one_that_comes_out() {
    let names: Vec<String> = ALL.iter().map(|name| format!("engine:{name}")).collect();
    let backends = names.join(",");
    let args = ["study", "laws", "-b", &backends, "--tuples", "200000", "--seed", "1", "--format", "csv"];
    let told = with_engines(100, &args);
    let all = |name: &str| column(&told, name);
    let number = |name: &str| -> Vec<u64> { all(name).iter().map(|n| n.parse().expect("a count")).collect() };
    let (tuples, violations, panics) = (number("tuples"), number("violations"), number("panics"));
    let (backends, laws, predicates) = (all("backend"), all("law"), all("predicates"));
    let letters = |predicates: &str| -> String {
        let letter = |name: &str| match name {
            "compare" => 'c',
            "orient2d" => '2',
            "orient3d" => '3',
            "incircle" => 'C',
            "insphere" => 'S',
            other => panic!("no letter for {other}"),
        };
        predicates.split('+').map(letter).collect()
    };
    let cell = |backend: &str, law: &str| -> String {
        let rows = (0..tuples.len()).filter(|&row| backends[row] == backend && laws[row] == law && tuples[row] > 0);
        let rows: Vec<usize> = rows.collect();
        let broken =
            rows.iter().filter(|&&row| violations[row] + panics[row] > 0).map(|&row| letters(&predicates[row]));
        let mut broken: Vec<String> = broken.collect();
        broken.sort();
        match (rows.is_empty(), broken.is_empty()) {
            (true, _) => "-".to_owned(),
            (false, true) => "0".to_owned(),
            (false, false) => broken.join(" "),
        }
    };
    let page = include_str!("../../../docs/LAWS.md");
    let (_, table) = page.split_once("| law | robust, ").expect("the table");
    let (head, table) = table.split_once('\n').expect("its head");
    let head = format!("robust, {head}");
    let columns: Vec<Vec<&str>> =
        head.trim_matches(['|', ' ']).split('|').map(|names| names.split(',').map(str::trim).collect()).collect();
    assert_eq!(columns.concat().len(), ALL.len(), "{head}");
    let mut seen = 0;
    for line in table.lines().skip(1).take_while(|line| line.starts_with('|')) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let named: Vec<&str> = match cells[0] {
            "independence-of-place, -of-later-vertices" => {
                vec!["independence-of-place", "independence-of-later-vertices"]
            }
            law => vec![law],
        };
        for law in named {
            for (names, said) in columns.iter().zip(&cells[1..]) {
                for name in names {
                    assert_eq!(
                        cell(&format!("engine:{name}"), law),
                        said.trim_end_matches(" (mixed)").trim_end_matches(" (flat)"),
                        "{name}: {law}"
                    );
                }
            }
            seen += 1;
        }
    }
    let distinct: std::collections::BTreeSet<&String> = laws.iter().collect();
    assert_eq!(seen, distinct.len(), "a row for each law");
}
