//! Tests of scenes written out: reading gives the same scenes, and changes to the text change the scene.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::AtomicBool;

use predicament_corpus::{Items, Level, Library, LoadedScene, Spelled, Suite};
use predicament_effort::some_or_all;
use predicament_formats::{Cache, Manifest};
use predicament_oracle::run;
use predicament_predicates::Vertex;
use predicament_tasks::{Budget, Class, Watch};

use crate::common::pinned;

/// The maximum number of coordinates of tested scenes; the text of larger ones is long and adds nothing.
const MOST: usize = 8_000;
/// The maximum number of coordinates of scenes that are judged again.
const JUDGED: usize = 1_500;

/// The embedded scenes of moderate size that need no download, and the number of larger scenes.
fn moderate() -> (Vec<LoadedScene>, usize) {
    let library = Library::embedded(predicament_bundle::vocabulary()).unwrap();
    let scenes = library.suites().unwrap().iter().flat_map(|suite| &suite.scenes).filter(|scene| !scene.needs_fetch());
    let all: Vec<LoadedScene> = scenes.map(|scene| scene.load(Level::Quick, &Cache::new("nowhere")).unwrap()).collect();
    let count = all.len();
    let moderate: Vec<_> = all.into_iter().filter(|loaded| loaded.scene.coordinates().len() <= MOST).collect();
    let larger = count - moderate.len();
    (moderate, larger)
}

fn read(spelled: &Spelled, name: &str) -> LoadedScene {
    spelled.loaded(predicament_bundle::vocabulary(), name).unwrap_or_else(|why| panic!("{name}: {why}"))
}

/// The numbers of answers of `exact` by class.
fn classes(loaded: &LoadedScene) -> BTreeMap<String, u64> {
    let (cancel, silent) = (AtomicBool::new(false), |_: u64| {});
    let watch = Watch::new(&cancel, None, &silent);
    let task = predicament_bundle::tasks().iter().copied().find(|task| task.name() == loaded.task).unwrap();
    let case = task.case(loaded, &watch).unwrap();
    let exact = predicament_bundle::backend("exact").unwrap();
    let outcome = run(case.as_ref(), exact.as_ref(), Budget::QUICK, &watch).unwrap();
    Class::ALL.iter().map(|&class| (format!("{class}"), outcome.counts.get(class))).collect()
}

#[test]
fn what_is_written_out_is_read_as_the_same_scene() {
    let (scenes, larger) = moderate();
    println!("{} scenes, {larger} left out as they have more than {MOST} coordinates", scenes.len());
    let marked: BTreeSet<String> =
        pinned().into_iter().filter(|(_, id)| id.is_other_once_written).map(|(name, _)| name).collect();
    let mut tasks = BTreeSet::new();
    let (mut others, mut judged) = (BTreeSet::new(), 0);
    for (at, loaded) in scenes.iter().enumerate() {
        let name = format!("{}/{}", loaded.suite, loaded.name);
        // By default the marked ones, one in three others, and those of a task until one has kept its id.
        let is_sampled = at.is_multiple_of(some_or_all(3, 1)) || !tasks.contains(loaded.task);
        if !is_sampled && !marked.contains(&name) {
            continue;
        }
        let spelled = loaded.spelled().unwrap_or_else(|| panic!("{name} can't be written out"));
        let again = read(&spelled, &name);
        assert_eq!((again.task, again.count()), (loaded.task, loaded.count()), "{name}");
        assert_eq!(again.spelled().as_ref(), Some(&spelled), "{name}");
        if again.id == loaded.id {
            tasks.insert(loaded.task);
            continue;
        }
        // Zero has two signs, and one position.
        let places =
            |of: &LoadedScene| -> Vec<u64> { of.scene.coordinates().iter().map(|x| (x + 0.0).to_bits()).collect() };
        assert_eq!(places(&again), places(loaded), "{name}");
        if loaded.scene.coordinates().len() <= JUDGED {
            assert_eq!(classes(&again), classes(loaded), "{name}");
            judged += 1;
        }
        others.insert(name);
    }
    println!("{} of them have another id, of which {judged} are judged again", others.len());
    assert_eq!(others, marked, "mark those in tests/ids.txt of their tasks' crates by the word `other`");
    assert!(judged >= 8, "only {judged} are small enough to be judged");
    assert!(
        tasks.len() + 1 >= predicament_bundle::vocabulary().names().count(),
        "only scenes of {tasks:?} keep their ids"
    );
    assert!(larger * 4 < scenes.len(), "{larger} of {} are left out", scenes.len());
}

/// A change to a scene that is written out; returns false if there is nothing to change.
type Change = fn(&mut Spelled) -> bool;

fn drop_an_item(spelled: &mut Spelled) -> bool {
    if spelled.lists.is_empty() {
        return spelled.points.pop().is_some();
    }
    let Some(list) = spelled.lists.iter_mut().max_by_key(|list| list.items.len()) else { return false };
    let last = list.items.len().saturating_sub(1);
    list.items.keep(|at| at != last);
    last > 0
}

fn swap_two_vertices(spelled: &mut Spelled) -> bool {
    spelled.lists.iter_mut().rev().any(|list| match &mut list.items {
        Items::Tuples(all) | Items::Loops(all) | Items::Labelled { tuples: all, .. } => {
            all.first_mut().is_some_and(|tuple| {
                tuple.swap(0, 1);
                tuple[0] != tuple[1]
            })
        }
        _ => false,
    })
}

fn change_a_bit<const BIT: u32>(spelled: &mut Spelled) -> bool {
    let mut coordinates = spelled.rows_mut().flatten();
    let Some(x) = coordinates.find(|x| **x != 0.0) else { return false };
    *x = f64::from_bits(x.to_bits() ^ (1 << BIT));
    true
}

#[test]
fn what_is_changed_is_another_scene() {
    let (scenes, _) = moderate();
    let changes: [(&str, Change); 4] = [
        ("drop", drop_an_item),
        ("swap", swap_two_vertices),
        ("last bit", change_a_bit::<0>),
        ("first bit", change_a_bit::<51>),
    ];
    for task in predicament_bundle::vocabulary().names() {
        let mut of_task: Vec<&LoadedScene> = scenes.iter().filter(|loaded| loaded.task == task).collect();
        of_task.sort_by_key(|loaded| loaded.scene.coordinates().len());
        for (what, change) in changes {
            // Hulls and cubes have no tuples, cells have one direction only, a mesh with one triangle reversed or
            // removed is not closed, and the upper corners of cubes must be doubles.
            if matches!(
                (task, what),
                ("hull2d" | "hull3d" | "cube-union" | "interval" | "mesh-intersect", "swap")
                    | ("mesh-intersect", "drop")
                    | ("cube-union", "last bit")
            ) {
                continue;
            }
            // Scenes for which the change is not refused: a mesh may have to be closed, a face planar.
            let changed = of_task.iter().filter_map(|loaded| {
                let spelled = loaded.spelled()?;
                let mut other = spelled.clone();
                let is_changed = change(&mut other);
                let other = is_changed.then(|| other.loaded(predicament_bundle::vocabulary(), &loaded.name).ok())??;
                Some(other.id != read(&spelled, &loaded.name).id)
            });
            let outcomes: Vec<bool> = changed.take(2).collect();
            // Simplices and rounded segments are stored with sorted vertices, and tetrahedra are oriented.
            let is_kept = matches!((task, what), ("contacts2d" | "contacts3d" | "snap2d" | "mesh-locate", "swap"));
            assert!(!outcomes.is_empty(), "{task}: no scene to {what}");
            assert!(outcomes.iter().all(|&is_other| is_other != is_kept), "{task}: {what} gives {outcomes:?}");
        }
    }
}

/// The only scene of a suite in a folder.
fn load(folder: &std::path::Path, scene: &str) -> LoadedScene {
    let text = format!("title = \"t\"\n[[scene]]\nname = \"x\"\n{scene}");
    let suite =
        Suite::parse(predicament_bundle::vocabulary(), "s.toml", &text, Some(folder), &Manifest::default()).unwrap();
    suite.scenes[0].load(Level::Quick, &Cache::new("nowhere")).unwrap()
}

#[test]
fn maps_of_files_keep_the_numbers_of_their_vertices() {
    let folder = tempfile::tempdir().unwrap();
    // A shared border, a hole, a region of two parts, and a region that crosses itself.
    let map = "POLYGON ((4 0, 0 0, 0 4, 4 4, 4 0), (1 1, 1 2, 2 2, 1 1))\nPOLYGON ((4 0, 8 0, 8 4, 4 4, 4 0))\n\
               MULTIPOLYGON (((10 0, 12 0, 12 2, 10 0)), ((20 0, 22 0, 22 2, 20 0)))\nPOLYGON ((30 0, 34 4, 34 0, 30 4, 30 0))\n";
    std::fs::write(folder.path().join("map.wkt"), map).unwrap();
    std::fs::write(folder.path().join("one.wkt"), "POLYGON ((30 0, 34 4, 34 0, 30 4, 30 0))\n").unwrap();
    for (scene, key) in [
        ("task = \"polygon-locate\"\nmap = { path = \"map.wkt\" }\nrandom = 10\n", "regions = [0, 0, 1, 2, 2, 3]\n"),
        ("task = \"triangulate\"\nmap = { path = \"map.wkt\" }\n", "regions = [0, 0, 1, 2, 2, 3]\n"),
        ("task = \"polygon-locate\"\nmap = { path = \"one.wkt\" }\n", "quick_stride = 0\n"),
        (
            "task = \"overlay2d\"\nfirst = { path = \"map.wkt\" }\nsecond = { path = \"one.wkt\" }\n",
            "rule = \"even-odd\"\n",
        ),
    ] {
        let loaded = load(folder.path(), scene);
        let spelled = loaded.spelled().unwrap();
        let text = spelled.suite("Map", predicament_corpus::Heading { name: "x", ..Default::default() });
        assert!(text.contains(key), "{text}");
        assert_eq!(read(&spelled, "map").id, loaded.id, "{text}");
    }
}

#[test]
fn probes_of_a_map_are_written_out_or_in_a_file() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("probes.csv"), "x,y\n4,4\n2,2\n0,9\n").unwrap();
    let scene =
        "task = \"polygon-locate\"\nmap = { polygons = [[[[0, 0], [4, 0], [4, 4], [0, 4]]]] }\nquick_stride = 0\n";
    let load = |probes: &str| load(folder.path(), &format!("{scene}probes = {probes}\n"));
    let loaded = load("[[4, 4], [2, 2], [0, 9]]");
    assert_eq!((loaded.count(), loaded.scene.len()), (3, 7));
    assert_eq!(load("{ path = \"probes.csv\" }").id, loaded.id);
    assert_ne!(load("[[4, 4], [2, 2], [0, 8]]").id, loaded.id);
    // Alternately before and after the map.
    let at = |v: usize| loaded.scene.point(Vertex::input(v)).to_vec();
    assert_eq!((at(0), at(1), at(6)), (vec![4.0, 4.0], vec![0.0, 9.0], vec![2.0, 2.0]));
    assert_eq!(classes(&loaded)["agree"], 3);
}

#[test]
fn tables_without_items_stay() {
    let scene = "task = \"contacts2d\"\npoints = [[0, 0], [1, 1], [2, 2]]\na.vertices = [0]\nb.edges = [[1, 2]]\n";
    let mut spelled = load(std::path::Path::new("."), scene).spelled().unwrap();
    spelled.lists[1].items.keep(|_| false);
    let text = spelled.table(predicament_corpus::Heading { name: "x", ..Default::default() });
    assert!(text.contains("a.vertices = [0]\n") && text.contains("b = {}\n"), "{text}");
    let emptied = read(&spelled, "emptied");
    assert_eq!(emptied.count(), 1);
    assert_eq!(read(&emptied.spelled().unwrap(), "again").id, emptied.id);
}

#[test]
fn loops_that_are_none_are_refused_at_their_line() {
    let refused = |keys: &str| -> String {
        let text = format!(
            "title = \"t\"\n[[scene]]\nname = \"x\"\ntask = \"polygon-locate\"\npoints = [[0, 0], [4, 0], [4, 4], [0, 4]]\n{keys}\n"
        );
        let suite = Suite::parse(predicament_bundle::vocabulary(), "s.toml", &text, None, &Manifest::default());
        suite.and_then(|suite| suite.scenes[0].load(Level::Quick, &Cache::new("nowhere"))).unwrap_err().to_string()
    };
    for (keys, wanted) in [
        ("loops = [[0, 1, 4]]", "s.toml:6: the corner 4 is out of range: the scene has 4 points"),
        ("loops = [[0, 1]]", "s.toml:6: a loop with 2 corners has no inside"),
        ("loops = [[0, 1, 1, 2]]", "s.toml:6: the corner 1 occurs twice in a row"),
        ("loops = [[0, 1, 2, 0]]", "s.toml:6: the corner 0 occurs twice in a row"),
        ("loops = [[0, 1, 2]]\nregions = [0, 1]", "s.toml:7: 2 regions for 1 loops"),
        ("loops = [[0, 1, 2]]\nmap = { polygons = [] }", "s.toml:5: a map with two sources"),
        ("loops = [[0, 1, 2]]\nprobes = [[0, 1, 2]]", "s.toml:7: `probes` have 3 coordinates each"),
    ] {
        let found = refused(keys);
        assert!(found.contains(wanted), "{found}");
    }
}
