//! Constructed vertices in suites: the format, the ids, and the families that make them.

use std::collections::{BTreeMap, BTreeSet};

use predicament_corpus::{Level, Library, LoadedScene, Suite, homogeneous};
use predicament_formats::{Cache, Manifest};
use predicament_predicates::{Construction, QuerySet, Vertex};
use predicament_tasks::signs::degeneracy;
use rug::Rational;

use crate::common::queries;

const SUITE: &str = r#"
title = "t"
[[scene]]
name = "a"
task = "orient2d"
points = [[0, 0], [2, 2], [0, 2], [2, 0], [1, 1]]
constructed = [{ ssi = [[0, 1], [2, 3]] }, { ssi = [[0, 2], [4, 3]] }]
queries = [["c1", 4, "c0"], [0, 1, 2]]
"#;

fn parse(text: &str) -> LoadedScene {
    let suite = Suite::parse(predicament_bundle::vocabulary(), "s.toml", text, None, &Manifest::default()).unwrap();
    suite.scenes[0].load(Level::Quick, &Cache::new("nowhere")).unwrap()
}

/// The scenes of the suite, loaded.
fn suite() -> Vec<LoadedScene> {
    let suite = Library::embedded(predicament_bundle::vocabulary()).unwrap().suite("constructed").unwrap();
    suite.scenes.iter().map(|scene| scene.load(Level::Quick, &Cache::new("nowhere")).unwrap()).collect()
}

fn point(loaded: &LoadedScene, v: Vertex) -> Vec<Rational> {
    let row = homogeneous(&loaded.scene, v).unwrap_or_else(|| panic!("{}: {v} is no point", loaded.name));
    let (weight, coordinates) = row.split_last().unwrap();
    coordinates.iter().map(|x| Rational::from((x.clone(), weight.clone()))).collect()
}

#[test]
fn constructions_are_read_as_they_are_written() {
    let loaded = parse(SUITE);
    let v = Vertex::input;
    let [x, y] = [0, 1].map(Vertex::constructed);
    assert_eq!(queries(&loaded).flat(), [y, v(4), x, v(0), v(1), v(2)]);
    let first = Construction::Ssi([[v(0), v(1)], [v(2), v(3)]]);
    assert_eq!(loaded.scene.constructions(), [first, Construction::Ssi([[v(0), v(2)], [v(4), v(3)]]).canonical()]);
    assert_eq!(point(&loaded, x), [1, 1].map(Rational::from));
    assert_eq!(point(&loaded, y), [0, 2].map(Rational::from));

    let all = parse(&SUITE.replace(r#"[["c1", 4, "c0"], [0, 1, 2]]"#, "\"all\""));
    assert_eq!(queries(&all).len(), 35, "three of seven");
    assert_eq!(queries(&all).args(34), [v(4), x, y], "constructed vertices come last");

    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("p.csv"), "0,0\n2,2\n0,2\n2,0\n1,1\n").unwrap();
    let text = SUITE.replace("[[0, 0], [2, 2], [0, 2], [2, 0], [1, 1]]", "{ path = \"p.csv\" }");
    let suite =
        Suite::parse(predicament_bundle::vocabulary(), "s.toml", &text, Some(folder.path()), &Manifest::default())
            .unwrap();
    let from_file = suite.scenes[0].load(Level::Quick, &Cache::new("nowhere")).unwrap();
    assert_eq!((&from_file.scene, &from_file.id), (&loaded.scene, &loaded.id));

    std::fs::write(folder.path().join("p.csv"), "0,0\n2,2\n0,2\n2,4\n1,1\n").unwrap();
    let error = suite.scenes[0].load(Level::Quick, &Cache::new("nowhere")).unwrap_err().to_string();
    assert!(
        error.starts_with("s.toml:7: with ") && error.contains("p.csv: c0 = SSI(0 1, 2 3): the lines are parallel; "),
        "{error}"
    );
}

#[test]
fn shares_are_fractions_and_mistakes_are_named() {
    let ratio = |table: &str| SUITE.replace("{ ssi = [[0, 1], [2, 3]] }", table);
    let thirds = parse(&ratio("{ ratio = [0, 3], share = \"1/3\" }"));
    let share = "1/3".parse().unwrap();
    let v = Vertex::input;
    assert_eq!(thirds.scene.constructions()[0], Construction::Ratio { ends: [v(0), v(3)], share });
    assert_eq!(point(&thirds, Vertex::constructed(0)), [Rational::from((4, 3)), Rational::new()]);
    // The same point, written otherwise; and another one.
    assert_eq!(parse(&ratio("{ ratio = [3, 0], share = \"4/6\" }")).id, thirds.id);
    assert_ne!(parse(&ratio("{ ratio = [3, 0], share = \"1/3\" }")).id, thirds.id);
    let error = |table: &str| {
        Suite::parse(predicament_bundle::vocabulary(), "s.toml", &ratio(table), None, &Manifest::default())
            .and_then(|suite| suite.scenes[0].load(Level::Quick, &Cache::new("nowhere")))
            .unwrap_err()
            .to_string()
    };
    for (table, needle) in [
        ("{ ratio = [0, 3] }", "share"),
        ("{ share = \"1/3\" }", "a `share` without a `ratio`"),
        ("{ ssi = [[0, 1], [2, 3]], share = \"1/3\" }", "a `share` without a `ratio`"),
        ("{ ssi = [[0, 1], [2, 3]], ratio = [0, 3], share = \"1/3\" }", "more than one kind"),
        ("{ ratio = [0, 3], share = \"0.5\" }", "`0.5` is not a fraction such as 1/3"),
        ("{ ratio = [0, 3], share = \"1/0\" }", "a denominator other than zero"),
        ("{ ratio = [0, 3], share = \"1/9007199254740993\" }", "at most 2^53"),
        ("{ ratio = [0, 3], share = 0.5 }", "share"),
        ("{ ratio = [0, 3, 1], share = \"1/3\" }", "a line of 3 points"),
        ("{ ratio = [3, 3], share = \"1/3\" }", "vertex 3 stands twice"),
        ("{ ratio = [0, 9], share = \"1/3\" }", "9"),
    ] {
        let error = error(table);
        assert!(error.starts_with("s.toml:7: ") && error.contains(needle), "{table}: {error}");
    }
}

#[test]
fn ids_are_about_the_constructions_that_there_are() {
    let id = |from: &str, to: &str| {
        assert!(SUITE.contains(from), "{from}");
        parse(&SUITE.replace(from, to)).id
    };
    let own = id("", "");
    assert_eq!(id("[[0, 1], [2, 3]]", "[[3, 2], [1, 0]]"), own, "the same lines");
    for (from, to) in [
        ("[4, 3]", "[4, 1]"),
        ("[[0, 1], [2, 3]] }, { ssi = [[0, 2], [4, 3]] }", "[[0, 2], [4, 3]] }, { ssi = [[0, 1], [2, 3]] }"),
        (" }]", " }, { ssi = [[0, 3], [1, 4]] }]"),
        (r#""c0"]"#, r#""c1"]"#),
    ] {
        assert_ne!(id(from, to), own, "{from}");
    }
}

#[test]
fn every_place_has_its_turn() {
    #[allow(clippy::mutable_key_type)] // predicates compare by name and text, which do not change
    let mut kinds = BTreeSet::new();
    for loaded in suite() {
        let (asked, arity) = (queries(&loaded), queries(&loaded).kind().arity());
        let mut places: BTreeMap<Vec<bool>, usize> = BTreeMap::new();
        for query in 0..asked.len() {
            let args = asked.args(query);
            *places.entry(args.iter().map(|v| v.is_constructed()).collect()).or_default() += 1;
            assert_eq!(args.iter().collect::<BTreeSet<_>>().len(), arity, "{}: a vertex twice", loaded.name);
            kinds.extend(
                args.iter()
                    .filter_map(|&v| loaded.scene.construction(v))
                    .map(|construction| (asked.kind(), construction.to_string()[..3].to_owned())),
            );
        }
        if loaded.source == "generated" {
            assert_eq!(places.len(), (1 << arity) - 1, "{}: {places:?}", loaded.name);
            let (least, most) = (places.values().min().unwrap(), places.values().max().unwrap());
            assert!(most - least <= 1, "{}: {places:?}", loaded.name);
        }
    }
    assert_eq!(kinds.len(), 8, "{kinds:?}");
}

/// Every fifth query by default, otherwise all queries.
fn some(queries: &QuerySet) -> QuerySet {
    let chosen = (0..queries.len()).step_by(predicament_effort::some_or_all(5, 1));
    QuerySet::new(queries.question(), chosen.flat_map(|query| queries.args(query)).copied().collect::<Vec<_>>())
}

#[test]
fn families_are_as_degenerate_as_they_say() {
    let mut seen = 0;
    for loaded in suite().iter().filter(|loaded| loaded.source == "generated") {
        let histogram = degeneracy(&loaded.scene, &some(queries(loaded)));
        let (zeros, total) = (histogram.zeros, histogram.total());
        let below = |exponent| zeros + histogram.buckets.range(..exponent).map(|(_, count)| count).sum::<usize>();
        match loaded.family.rsplit_once('-').unwrap().1 {
            "degen" => assert_eq!(zeros, total, "{}", loaded.name),
            "near" => {
                assert!(zeros < total / 5, "{}: {zeros} ties", loaded.name);
                assert!(below(-40) > total / 2, "{}: {histogram}", loaded.name);
            }
            _ => assert_eq!(below(-30), 0, "{}: {histogram}", loaded.name),
        }
        seen += 1;
    }
    assert_eq!(seen, 39);
}

#[test]
fn ties_have_both_reasons_and_hardly_ever_a_double() {
    let power_of_two = |n: &rug::Integer| n.is_power_of_two();
    for loaded in suite().iter().filter(|loaded| loaded.family.ends_with("-degen")) {
        let points: Vec<Vec<Rational>> =
            (0..loaded.scene.constructions().len()).map(|i| point(loaded, Vertex::constructed(i))).collect();
        let doubles = points.iter().filter(|point| point.iter().all(|x| power_of_two(x.denom()))).count();
        assert!(10 * doubles < 2 * points.len(), "{}: {doubles} of {}", loaded.name, points.len());
        for (patch, points) in points.chunks(4).enumerate() {
            let different: BTreeSet<&Vec<Rational>> = points.iter().collect();
            if patch % 2 == 1 {
                assert_eq!(different.len(), 1, "{}: patch {patch} goes through one point", loaded.name);
            } else {
                assert!(different.len() > 1, "{}: patch {patch} has one point only", loaded.name);
            }
        }
    }
}
