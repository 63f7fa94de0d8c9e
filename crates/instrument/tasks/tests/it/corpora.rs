//! Tests that the embedded suites are as described.

use std::collections::{BTreeMap, BTreeSet};

use predicament_corpus::{Family, Level, Library, LoadedScene, SceneDef, Suite, content_id, fmt};
use predicament_formats::Cache;
use predicament_polygon_locate::task::{MapWithProbes, ProbeKind};
use predicament_predicates::{Sign, Vertex};
use predicament_tasks::signs::{SignQueries, degeneracy};
use rug::Rational;

use crate::common::{PINNED, determinant, pinned, queries, sign};

fn cache() -> Cache {
    Cache::new("/nonexistent/predicament-cache")
}

/// The embedded suites, read once.
fn library() -> &'static Library {
    static LIBRARY: std::sync::OnceLock<Library> = std::sync::OnceLock::new();
    LIBRARY.get_or_init(|| Library::embedded(predicament_bundle::vocabulary()).unwrap())
}

fn definition(name: &str) -> SceneDef {
    let library = library();
    let all = library.suites().unwrap().iter().flat_map(|suite| &suite.scenes);
    all.into_iter().find(|scene| scene.name == name).unwrap_or_else(|| panic!("no scene {name}")).clone()
}

fn load(name: &str) -> LoadedScene {
    definition(name).load(Level::Quick, &cache()).unwrap()
}

/// Every scene that needs no download, loaded.
fn offline() -> Vec<LoadedScene> {
    let library = library();
    let scenes = library.suites().unwrap().iter().flat_map(|suite| &suite.scenes).filter(|scene| !scene.needs_fetch());
    scenes.map(|scene| scene.load(Level::Quick, &cache()).unwrap()).collect()
}

#[test]
fn ids_are_pinned_on_every_platform() {
    let mut pinned = pinned();
    let mut new = Vec::new();
    for loaded in offline() {
        let name = format!("{}/{}", loaded.suite, loaded.name);
        match pinned.remove(&name) {
            None => new.push(format!("{} {name}", loaded.id)),
            Some(pinned) => assert_eq!(
                loaded.id,
                pinned.id,
                "{name} in {}: a generator, a suite or the id has changed: expectations and baselines speak of these ids",
                pinned.file.display()
            ),
        }
    }
    assert!(new.is_empty(), "add these to {PINNED} of the crates whose tasks they are of:\n{}", new.join("\n"));
    assert!(pinned.is_empty(), "these are gone: {:?}", pinned.keys());
    // A perturbation of one mesh is run for these tasks alone.
    for loaded in offline() {
        let has_two = predicament_bundle::task(loaded.task).unwrap().is_on_two_meshes();
        assert_eq!(loaded.scene.second_mesh().is_some(), has_two, "{}/{}", loaded.suite, loaded.name);
    }
}

#[test]
fn the_folder_and_the_embedded_copy_are_the_same() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../corpora");
    let library = Library::from_dir(predicament_bundle::vocabulary(), &folder).unwrap();
    let names = |library: &Library| -> Vec<(String, usize)> {
        library.suites().unwrap().iter().map(|suite| (suite.name.clone(), suite.scenes.len())).collect()
    };
    assert_eq!(names(&library), names(self::library()));
    assert_eq!(library.manifest(), self::library().manifest());
    for suite in library.suites().unwrap() {
        let text = std::fs::read_to_string(suite.file()).unwrap();
        assert_eq!(
            fmt(predicament_bundle::vocabulary(), suite.file(), &text).unwrap(),
            text,
            "{} is not formatted",
            suite.file()
        );
        assert!(!suite.description.is_empty() && suite.scenes.iter().all(|scene| !scene.analysis.is_empty()));
        assert!(suite.scenes.iter().all(|scene| !scene.source.is_empty()), "{}", suite.name);
    }
}

#[test]
fn every_family_is_in_a_suite_for_every_task() {
    let used: BTreeSet<(String, &str)> = offline().into_iter().map(|loaded| (loaded.family, loaded.task)).collect();
    let mut families = 0;
    for task in predicament_bundle::vocabulary().tasks() {
        for &Family { name, reported_as, .. } in task.families() {
            // If a scene is a separate family, it is named after the generator here.
            let is_it =
                |family: &str| reported_as.map_or(family.starts_with(name), |reported_as| family == reported_as);
            assert!(used.iter().any(|(family, of)| *of == task.name() && is_it(family)), "{name} for {}", task.name());
            families += 1;
        }
    }
    assert!(families > 60, "{families} pairs of family and task");
}

#[test]
fn a_rename_keeps_the_id_and_a_change_does_not() {
    let loaded = load("near-orient2d-ulps-4");
    assert_eq!(content_id(&loaded.scene, loaded.content.as_ref()), loaded.id);
    let parse = |text: &str| {
        let suite = Suite::parse(predicament_bundle::vocabulary(), "s.toml", text, None, library().manifest()).unwrap();
        suite.scenes[0].load(Level::Quick, &cache()).unwrap().id
    };
    let text = "title = \"t\"\n[[scene]]\nname = \"a\"\ntask = \"orient2d\"\npoints = [[0, 0], [1, 0], [0, 2]]\n";
    let id = parse(text);
    for same in
        [("\"a\"", "\"b\""), ("[0, 0]", "[-0.0, \"-0x0p+0\"]"), ("= [[0", "= [ [0"), ("[1, 0]", "[\"0x1p0\", 0.0]")]
    {
        assert_eq!(parse(&text.replace(same.0, same.1)), id, "{same:?}");
    }
    for other in [
        ("[1, 0]", "[\"0x1.0000000000001p+0\", 0]"),
        ("[1, 0]", "[1, 5e-324]"),
        ("[1, 0], [0, 2]", "[0, 2], [1, 0]"),
        ("2]]\n", "2]]\nqueries = [[1, 2, 0]]\n"),
        ("2]]\n", "2]]\nqueries = [[0, 1, 2], [0, 1, 2]]\n"),
        ("0], [1, 0], [0, 2]]", "0, 0], [1, 0, 0], [0, 2, 0]]"),
    ] {
        let changed = text.replace(other.0, other.1).replace("5e-324", "\"0x0.0000000000001p-1022\"");
        assert_ne!(parse(&changed), id, "{other:?}");
    }
}

#[test]
fn the_first_queries_of_a_larger_amount_are_those_of_a_smaller_one() {
    for name in [
        "near-insphere-ulps-4",
        "wide-mixed-orient3d",
        "band-orient2d",
        "near-orient2d-dimension-3-plane-yz",
        "lpi-tpi-near-orient3d",
    ] {
        let small = load(name);
        let library = library();
        let suite = library.suite(&small.suite).unwrap();
        let text = library.companion(&format!("{}.toml", suite.name)).unwrap().unwrap().1;
        let larger = text.replace("\nn = ", "\nn = 1");
        let suite =
            Suite::parse(predicament_bundle::vocabulary(), "larger.toml", &larger, None, library.manifest()).unwrap();
        let scene = suite.scenes.iter().find(|scene| scene.name == name).unwrap();
        let large = scene.load(Level::Quick, &cache()).unwrap();
        assert!(large.count() > small.count());
        assert!(large.scene.coordinates().starts_with(small.scene.coordinates()), "{name}");
        assert!(queries(&large).flat().starts_with(queries(&small).flat()), "{name}");
        assert!(large.scene.constructions().starts_with(small.scene.constructions()), "{name}");
    }
}

#[test]
fn degenerate_families_are_degenerate() {
    let mut seen = 0;
    for loaded in offline().iter().filter(|loaded| loaded.family == "degen") {
        let histogram = degeneracy(&loaded.scene, queries(loaded));
        assert_eq!((histogram.zeros, histogram.total()), (loaded.count(), loaded.count()), "{}", loaded.name);
        for query in (0..loaded.count()).step_by(10) {
            assert_eq!(sign(loaded, query), Sign::Zero, "{} {query}", loaded.name);
        }
        // The reason is not that points coincide.
        let args = queries(loaded);
        for query in 0..args.len() {
            let points: BTreeSet<Vec<u64>> =
                args.args(query).iter().map(|&v| loaded.scene.point(v).iter().map(|x| x.to_bits()).collect()).collect();
            assert_eq!(points.len(), args.kind().arity(), "{} {query}", loaded.name);
        }
        seen += 1;
    }
    assert_eq!(seen, 22);
}

#[test]
fn the_histogram_counts_zeros_as_the_judge_does() {
    for name in
        ["grid-incircle", "kettner-orient2d", "wide-mixed-orient3d", "wide-scaled-insphere", "near-compare-ulps-4"]
    {
        let loaded = load(name);
        let zeros = (0..loaded.count()).filter(|&query| sign(&loaded, query).is_zero()).count();
        assert_eq!(degeneracy(&loaded.scene, queries(&loaded)).zeros, zeros, "{name}");
    }
}

#[test]
fn near_families_are_near_and_uniform_ones_are_not() {
    let median = |name: &str| {
        let loaded = load(name);
        let histogram = degeneracy(&loaded.scene, queries(&loaded));
        let half = histogram.buckets.values().sum::<usize>() / 2;
        let mut sum = 0;
        histogram.buckets.into_iter().find(|(_, count)| {
            sum += count;
            sum > half
        })
    };
    for task in ["orient2d", "orient3d", "incircle", "insphere"] {
        assert!(median(&format!("uniform-{task}")).unwrap().0 > -10, "{task}");
        assert!(median(&format!("near-{task}-ulps-4")).unwrap().0 < -45, "{task}");
        assert!(median(&format!("kettner-{task}")).unwrap().0 < -45, "{task}");
    }
}

#[test]
fn bands_are_met_at_both_edges_from_both_sides() {
    for (name, multiples, exponent) in
        [("band-orient2d", [10.0, 21.0, 32.0], -52), ("band-orient3d", [28.0, 56.0, 83.14], -39)]
    {
        let loaded = load(name);
        let unit = Rational::from(1) << exponent;
        let mut met: BTreeMap<(usize, bool, bool), usize> = BTreeMap::new();
        for query in 0..loaded.count() {
            let det: Rational = determinant(&loaded, query) / &unit;
            let (size, positive) = (det.clone().abs(), det.cmp0().is_gt());
            let nearest = (0..3).find(|&at| {
                let edge = Rational::from_f64(multiples[at]).unwrap();
                Rational::from(&size - &edge).abs() < edge / 16
            });
            let at = nearest.unwrap_or_else(|| panic!("{name} {query}: {} is near no edge", size.to_f64()));
            let outside = size > Rational::from_f64(multiples[at]).unwrap();
            *met.entry((at, positive, outside)).or_default() += 1;
        }
        assert_eq!(met.len(), 12, "{name}: {met:?}");
        assert!(met.values().all(|&count| count > 100), "{name}: {met:?}");
        let extreme = loaded.scene.coordinates().iter().fold(0.0_f64, |most, &x| most.max(x));
        assert_eq!(extreme, 1.0, "the anchors make L");
    }
}

/// The orientation of p, q, r as Kettner et al. compute it, with p as the pivot.
#[allow(clippy::suboptimal_flops)]
fn float_orient([p, q, r]: [[f64; 2]; 3]) -> Sign {
    Sign::of((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]))
}

#[test]
fn the_classics_fail_where_the_paper_says() {
    use Sign::{Negative, Positive, Zero};
    let exact_orient = |points: [[f64; 2]; 3]| {
        let r = |x: f64| Rational::from_f64(x).unwrap();
        let [p, q, s] = points.map(|[x, y]| [r(x), r(y)]);
        let left = Rational::from(&q[0] - &p[0]) * Rational::from(&s[1] - &p[1]);
        let right = Rational::from(&q[1] - &p[1]) * Rational::from(&s[0] - &p[0]);
        Sign::from(left.cmp(&right))
    };
    // Scene, the triple (counted from 1, as in the paper), the computed sign, whether it is right.
    let claims = [
        ("kettner-a1", [1, 2, 3], Positive, true),
        ("kettner-a1", [1, 2, 4], Positive, true),
        ("kettner-a1", [2, 3, 4], Positive, true),
        ("kettner-a1", [3, 1, 4], Positive, false),
        // The same turn from two pivots: only one is right.
        ("kettner-a1-global", [1, 2, 3], Negative, true),
        ("kettner-a1-global", [3, 1, 2], Positive, false),
        ("kettner-a1-global", [1, 2, 4], Negative, true),
        ("kettner-a1-global", [4, 1, 2], Zero, false),
        ("kettner-a1-global", [2, 3, 4], Zero, false),
        ("kettner-a1-global", [3, 1, 4], Zero, false),
        ("kettner-a2", [1, 2, 3], Positive, true),
        ("kettner-a2", [1, 2, 4], Negative, false),
        ("kettner-a2", [2, 3, 4], Positive, true),
        ("kettner-a2", [3, 1, 4], Positive, true),
        ("kettner-b1", [1, 2, 3], Positive, true),
        ("kettner-b1", [1, 2, 4], Negative, true),
        ("kettner-b1", [2, 3, 4], Negative, true),
        ("kettner-b1", [3, 1, 4], Negative, false),
        ("kettner-b2", [1, 4, 5], Negative, false),
        ("kettner-b2", [4, 3, 5], Positive, true),
        ("kettner-b2", [3, 2, 5], Negative, true),
        ("kettner-b2", [2, 1, 5], Positive, true),
    ];
    for (name, triple, computed, right) in claims {
        let loaded = load(name);
        let points = triple.map(|place| {
            let point = loaded.scene.point(Vertex::input(place - 1));
            [point[0], point[1]]
        });
        assert_eq!(float_orient(points), computed, "{name} {triple:?}");
        assert_eq!(exact_orient(points) == computed, right, "{name} {triple:?}");
    }
}

#[test]
fn pixel_maps_are_squares_of_neighbours_that_naive_arithmetic_gets_wrong() {
    for name in ["kettner-pixels-a", "kettner-pixels-b", "kettner-pixels-c"] {
        let loaded = load(name);
        let side = 256;
        assert_eq!((loaded.scene.len(), loaded.count()), (side * side + 2, side * side));
        let pixel = |i: usize, j: usize| loaded.scene.point(Vertex::input(j * side + i));
        let corner = pixel(0, 0);
        let mut wrong = 0;
        for j in 0..side {
            for i in 0..side {
                // Coordinates ascend from 0.5: neighbours are 2^-53 apart.
                let right = pixel(i, j);
                if i + 1 < side {
                    assert_eq!(right[0].next_up(), pixel(i + 1, j)[0]);
                }
                assert_eq!((right[0], right[1]), (pixel(i, 0)[0], pixel(0, j)[1]));
                assert!(right[0] >= corner[0] && right[1] >= corner[1]);
                let query = j * side + i;
                if query % 7 == 0 {
                    let points = [0, 1, 2].map(|at| {
                        let point = loaded.scene.point(queries(&loaded).args(query)[at]);
                        [point[0], point[1]]
                    });
                    wrong += usize::from(float_orient(points) != sign(&loaded, query));
                }
            }
        }
        assert!(wrong > 500, "{name}: only {wrong} wrong signs");
    }
}

fn content_of_map(loaded: &LoadedScene) -> &MapWithProbes {
    loaded.content().unwrap_or_else(|| panic!("{} is no map", loaded.name))
}

/// True if p is strictly inside the rings by crossing parity, exactly; `None` if it is on them.
fn inside(rings: &[Vec<[f64; 2]>], p: [f64; 2]) -> Option<bool> {
    let mut odd = false;
    for ring in rings {
        for (at, &a) in ring.iter().enumerate() {
            let b = ring[(at + 1) % ring.len()];
            let r = |x: f64| Rational::from_f64(x).unwrap();
            let left = (r(b[0]) - r(a[0])) * (r(p[1]) - r(a[1]));
            let right = (r(b[1]) - r(a[1])) * (r(p[0]) - r(a[0]));
            let turn = left.cmp(&right);
            let between = |i: usize| p[i] >= a[i].min(b[i]) && p[i] <= a[i].max(b[i]);
            if turn.is_eq() && between(0) && between(1) {
                return None;
            }
            if (a[1] > p[1]) != (b[1] > p[1]) {
                odd ^= turn.is_gt() == (b[1] > a[1]);
            }
        }
    }
    Some(odd)
}

#[test]
fn tilings_tile() {
    for name in ["tiling", "bricks"] {
        let loaded = load(name);
        let MapWithProbes { map, probes, .. } = content_of_map(&loaded);
        // A border between two regions occurs once in each direction.
        let mut directed = BTreeSet::new();
        for (_, edge) in map.edges() {
            assert!(directed.insert(edge), "{name}: {edge:?} twice");
        }
        let point = |v: Vertex| [loaded.scene.point(v)[0], loaded.scene.point(v)[1]];
        let rings: Vec<Vec<Vec<[f64; 2]>>> = map
            .regions()
            .iter()
            .map(|region| region.rings.iter().map(|ring| ring.vertices().iter().map(|&v| point(v)).collect()).collect())
            .collect();
        let mut found = BTreeMap::new();
        for probe in probes.iter().filter(|probe| probe.kind != ProbeKind::Vertex).step_by(5) {
            let p = point(probe.vertex);
            let inside: Vec<_> = rings.iter().map(|region| inside(region, p)).collect();
            let strictly = inside.iter().filter(|&&x| x == Some(true)).count();
            assert!(strictly <= 1, "{name}: {p:?} in {strictly} regions");
            assert!(strictly == 0 || !inside.contains(&None), "{name}: {p:?} inside one region and on another");
            *found.entry((probe.kind, strictly)).or_insert(0) += 1;
        }
        assert!(found[&(ProbeKind::Random, 1)] > 100 && found[&(ProbeKind::Random, 0)] > 10, "{found:?}");
        assert!(!found.contains_key(&(ProbeKind::Midpoint, 1)), "midpoints are on borders: {found:?}");
        assert!(name != "tiling" || map.regions().iter().any(|region| region.rings.len() == 2), "no holes");
    }
}

#[test]
fn probes_are_vertices_of_their_own_where_they_should_be() {
    for name in ["tiling", "bricks"] {
        let loaded = load(name);
        let MapWithProbes { map, probes, .. } = content_of_map(&loaded);
        let leading = probes.iter().step_by(2).count();
        let corners = loaded.scene.len() - probes.len();
        let of_map = leading..leading + corners;
        assert!(map.edges().all(|(_, ends)| ends.iter().all(|end| of_map.contains(&end.index()))));
        // Every kind of probe has numbers on both sides of the map.
        let sides: BTreeSet<(ProbeKind, bool)> =
            probes.iter().map(|probe| (probe.kind, probe.vertex.index() < leading)).collect();
        assert_eq!(sides.len(), 2 * 5, "{name}: {sides:?}");
        let mut kinds: BTreeMap<ProbeKind, usize> = BTreeMap::new();
        let mut current = [0.0; 2];
        for (at, probe) in probes.iter().enumerate() {
            let before_the_map = at % 2 == 0;
            assert_eq!(probe.vertex.index(), if before_the_map { at / 2 } else { of_map.end + at / 2 });
            let p = loaded.scene.point(probe.vertex);
            let place = kinds.entry(probe.kind).or_default();
            match probe.kind {
                ProbeKind::Vertex => {
                    current = [p[0], p[1]];
                    assert_eq!(p, loaded.scene.point(Vertex::input(of_map.start + *place)));
                }
                ProbeKind::Below => assert_eq!([p[0], p[1].next_up()], current),
                ProbeKind::Above => assert_eq!([p[0], p[1].next_down()], current),
                ProbeKind::Midpoint | ProbeKind::Random => {}
            }
            *place += 1;
        }
        assert_eq!(kinds[&ProbeKind::Vertex], corners);
        assert_eq!((kinds[&ProbeKind::Below], kinds[&ProbeKind::Above]), (corners, corners));
        assert_eq!(kinds[&ProbeKind::Random], 2000);
        // On integers every midpoint is a double: one probe for each undirected edge.
        let edges: BTreeSet<_> = map.edges().map(|(_, [a, b])| [a.min(b), a.max(b)]).collect();
        let midpoints: BTreeSet<_> = probes
            .iter()
            .filter(|probe| probe.kind == ProbeKind::Midpoint)
            .map(|probe| loaded.scene.point(probe.vertex).iter().map(|x| x.to_bits()).collect::<Vec<_>>())
            .collect();
        let expected: BTreeSet<_> = edges
            .iter()
            .map(|[a, b]| {
                let (a, b) = (loaded.scene.point(*a), loaded.scene.point(*b));
                (0..2).map(|i| ((a[i] + b[i]) / 2.0).to_bits()).collect::<Vec<_>>()
            })
            .collect();
        assert_eq!(midpoints, expected);
    }
}

#[test]
#[ignore = "needs `predicament corpus fetch`"]
fn fetched_suites_load_and_the_fixtures_signs_are_right() {
    let cache = Cache::default_dir().unwrap();
    let mut scenes = 0;
    for suite in library().suites().unwrap().iter().filter(|suite| suite.needs_fetch) {
        for scene in &suite.scenes {
            let loaded = scene.load(Level::Quick, &cache).unwrap();
            scenes += 1;
            if let Some(SignQueries { expected: Some(expected), .. }) = loaded.content() {
                assert_eq!((expected.len(), loaded.count()), (1000, 1000));
                for (query, &expected) in expected.iter().enumerate() {
                    assert_eq!(sign(&loaded, query), expected, "{} {query}", loaded.name);
                }
            }
            if let Some(MapWithProbes { map, .. }) = loaded.content() {
                assert!(map.regions().len() > 170, "{}: {} regions", loaded.name, map.regions().len());
            }
        }
    }
    assert_eq!(scenes, 4 + 4 + 9 + 7);
}
