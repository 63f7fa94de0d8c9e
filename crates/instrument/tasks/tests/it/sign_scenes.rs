//! The crate `conformance` asks what the suites ask: its table of sign scenes is that of the corpora, and its families
//! make the queries of the harness.

use std::fmt::Write as _;

use predicament_conformance::check;
use predicament_corpus::{Level, Library, LoadedScene, SceneDef};
use predicament_formats::{Cache, read_coordinate};
use predicament_predicates::{Construction, PredicateKind, Question, Vertex};
use predicament_tasks::signs::SignQueries;

const HEAD: &str =
    "# The sign scenes of corpora/, by the test `sign_scenes` of the tasks: UPDATE=1 writes them again.\n";

/// The predicates of the table.
fn is_asked(task: &str) -> bool {
    PredicateKind::ALL.iter().any(|kind| kind.name() == task)
}

/// The bits of a coordinate in a suite.
fn bits(value: &toml::Value) -> String {
    let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    format!("{:x}", read_coordinate(&text).unwrap().to_bits())
}

/// The lines of all generated families in a suite, without those that differ in seed, size or axis only.
fn families(text: &str, lines: &mut Vec<String>) {
    let table: toml::Table = text.parse().unwrap();
    let generators = table.get("generate").and_then(toml::Value::as_array);
    for generator in generators.into_iter().flatten().filter(|table| is_asked(table["task"].as_str().unwrap())) {
        let [task, family] = ["task", "family"].map(|key| generator[key].as_str().unwrap());
        if family == "decimals" {
            // Functions of doubles have no second truth.
            continue;
        }
        let mut line = format!("family {task} {family}");
        for key in ["ulps", "digits", "halvings", "side"] {
            match generator.get(key).map(|value| value.as_integer().unwrap()) {
                Some(value) => write!(line, " {key}={value}").unwrap(),
                None if key == "ulps" && family == "near" => line.push_str(" ulps=4"),
                None => {}
            }
        }
        assert!(generator.get("step").is_none(), "the table has no steps of pixel maps yet");
        for key in ["p", "q", "r"] {
            if let Some(point) = generator.get(key) {
                let point: Vec<String> = point.as_array().unwrap().iter().map(bits).collect();
                write!(line, " {key}={}", point.join(",")).unwrap();
            }
        }
        if generator.get("p").is_some() {
            write!(line, " name={}", generator["name"].as_str().unwrap()).unwrap();
        }
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
}

/// Every choice of `k` vertices, in lexicographic order.
fn combinations(all: &[Vertex], k: usize) -> Vec<Vec<Vertex>> {
    if k == 0 {
        return vec![Vec::new()];
    }
    let mut found = Vec::new();
    for (at, &first) in all.iter().enumerate() {
        found.extend(combinations(&all[at + 1..], k - 1).into_iter().map(|rest| [vec![first], rest].concat()));
    }
    found
}

/// The lines of a scene that is written out.
fn scene(loaded: &LoadedScene, text: &mut String) {
    let queries = &loaded.content::<SignQueries>().unwrap().queries;
    let way = match queries.question() {
        Question::Compare(axis) => axis.name(),
        Question::Orient2d(plane) => plane.name(),
        _ => "-",
    };
    let (scene, kind) = (&loaded.scene, queries.kind());
    let dimension = scene.dimension().count();
    writeln!(text, "scene {}/{} {kind} {way} {dimension}", loaded.suite, loaded.name).unwrap();
    for v in scene.vertices() {
        let point: Vec<String> = scene.point(v).iter().map(|x| format!("{:x}", x.to_bits())).collect();
        writeln!(text, "p {}", point.join(" ")).unwrap();
    }
    for construction in scene.constructions() {
        let name = match construction {
            Construction::Ssi(_) => "ssi",
            Construction::Lpi { .. } => "lpi",
            Construction::Tpi(_) => "tpi",
            Construction::Ratio { .. } => unreachable!("left out"),
        };
        let vertices: Vec<String> = construction.flats().flatten().map(ToString::to_string).collect();
        writeln!(text, "{name} {}", vertices.join(" ")).unwrap();
    }
    let all: Vec<Vertex> = scene.vertices().chain((0..scene.constructions().len()).map(Vertex::constructed)).collect();
    if all.len() < 100 && combinations(&all, kind.arity()).concat() == queries.flat() {
        text.push_str("all\n");
        return;
    }
    for query in queries.flat().chunks(kind.arity()) {
        let names: Vec<String> = query.iter().map(ToString::to_string).collect();
        writeln!(text, "q {}", names.join(" ")).unwrap();
    }
}

#[test]
fn the_table_of_the_conformance_tests_is_that_of_the_corpora() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../..");
    let library = Library::embedded(predicament_bundle::vocabulary()).unwrap();
    let (mut generated, mut scenes) = (Vec::new(), String::new());
    for suite in library.suites().unwrap() {
        families(&std::fs::read_to_string(format!("{root}/{}", suite.file())).unwrap(), &mut generated);
        let written = suite.scenes.iter().filter(|scene| is_asked(scene.task) && scene.is_written());
        for written in written {
            let loaded = written.load(Level::Quick, &Cache::new("")).unwrap();
            // Functions under test are given input points, and points where lines and planes meet.
            if !loaded.scene.constructions().iter().any(|one| matches!(one, Construction::Ratio { .. })) {
                scene(&loaded, &mut scenes);
            }
        }
    }
    let table = format!("{HEAD}{}\n{scenes}", generated.join("\n"));
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(format!("{root}/crates/instrument/conformance/src/scenes.txt"), &table).unwrap();
    }
    assert!(table == predicament_conformance::TABLE, "the corpora have changed: run this test with UPDATE=1");
}

/// The queries of a generated suite are among those of the conformance test with the same seed.
#[test]
fn the_families_of_the_conformance_tests_are_those_of_the_harness() {
    let library = Library::embedded(predicament_bundle::vocabulary()).unwrap();
    let suite = library.suite("families").unwrap();
    let is_wanted = |scene: &&SceneDef| scene.task == "orient2d" && scene.family == "near";
    let loaded = suite.scenes.iter().find(is_wanted).unwrap().load(Level::Quick, &Cache::new("")).unwrap();
    let mut seen = std::collections::BTreeSet::new();
    let bits = |points: [[f64; 2]; 3]| points.map(|point| point.map(f64::to_bits));
    let report = check::orient2d(|a: [f64; 2], b, c| {
        seen.insert(bits([a, b, c]));
        0
    });
    let report = report.seed(3).report();
    assert!(report.wrong > 0, "always zero");
    let points = loaded.scene.coordinates().as_chunks::<2>().0.as_chunks::<3>().0;
    assert!(points[..100].iter().all(|&query| seen.contains(&bits(query))), "other queries of the same seed");
}
