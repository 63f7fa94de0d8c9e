//! Tests of scenes with two complexes: written out, from files, and generated.

use std::collections::BTreeMap;
use std::path::Path;

use predicament_contacts::task::Complexes;
use predicament_corpus::{Level, Library, LoadedScene, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_mesh::Complex;
use predicament_predicates::{Scene, Vertex};
use rug::Rational;

fn generated(name: &str) -> LoadedScene {
    let library = Library::embedded(predicament_bundle::vocabulary()).unwrap();
    let suite = library.suite("contacts").unwrap();
    let scene = suite.scenes.iter().find(|scene| scene.name == name).unwrap_or_else(|| panic!("no scene {name}"));
    scene.load(Level::Quick, &Cache::new("nowhere")).unwrap()
}

fn complexes(loaded: &LoadedScene) -> [&Complex; 2] {
    let complexes: Option<&Complexes> = loaded.content();
    complexes.unwrap_or_else(|| panic!("{} asks for no contacts", loaded.name)).both()
}

/// Loads a scene from a suite in a folder.
fn load(folder: &Path, scene: &str) -> LoadedScene {
    let text = format!("title = \"t\"\n[[scene]]\nname = \"x\"\n{scene}");
    let suite =
        Suite::parse(predicament_bundle::vocabulary(), "s.toml", &text, Some(folder), &Manifest::default()).unwrap();
    suite.scenes[0].load(Level::Quick, &Cache::new("nowhere")).unwrap()
}

/// Twice the signed area, exactly.
fn turn(scene: &Scene, [a, b, c]: [Vertex; 3]) -> std::cmp::Ordering {
    let [a, b, c] = [a, b, c].map(|v| [0, 1].map(|i| Rational::from_f64(scene.point(v)[i]).unwrap()));
    let left = Rational::from(&b[0] - &a[0]) * Rational::from(&c[1] - &a[1]);
    left.cmp(&(Rational::from(&b[1] - &a[1]) * Rational::from(&c[0] - &a[0])))
}

/// True if two edges without a common vertex have a common point.
fn meet(scene: &Scene, [a, b]: [Vertex; 2], [c, d]: [Vertex; 2]) -> bool {
    let overlap = (0..2).all(|i| {
        let [a, b, c, d] = [a, b, c, d].map(|v| scene.point(v)[i]);
        a.min(b) <= c.max(d) && c.min(d) <= a.max(b)
    });
    let apart = |a, b, c, d| {
        let sides = [turn(scene, [a, b, c]), turn(scene, [a, b, d])];
        sides[0] == sides[1] && sides[0].is_ne()
    };
    overlap && !apart(a, b, c, d) && !apart(c, d, a, b)
}

#[test]
fn polygons_are_closed_and_simple() {
    for name in ["polygons-uniform", "polygons-near", "polygons-degen", "copy-shifted-0.5", "copy-shifted-10"] {
        let loaded = generated(name);
        for complex in complexes(&loaded) {
            let edges = complex.edges();
            assert!(edges.len() > 50 && edges.len() == complex.vertices().len(), "{name}");
            for v in complex.vertices() {
                assert_eq!(edges.as_flattened().iter().filter(|end| *end == v).count(), 2, "{name}");
            }
            for (at, &e) in edges.iter().enumerate() {
                let others = edges[..at].iter().filter(|f| f.iter().all(|v| !e.contains(v)));
                assert!(others.into_iter().all(|&f| !meet(&loaded.scene, e, f)), "{name}: {e:?}");
            }
        }
    }
}

#[test]
fn surfaces_are_closed() {
    for (name, characteristic) in
        [("surfaces-uniform", 2), ("surfaces-near", 2), ("surfaces-degen", 2 * 8), ("surfaces-shifted-1", 2)]
    {
        let loaded = generated(name);
        for complex in complexes(&loaded) {
            let mut around: BTreeMap<[Vertex; 2], usize> = BTreeMap::new();
            for &[p, q, r] in complex.triangles() {
                [[p, q], [p, r], [q, r]].into_iter().for_each(|side| *around.entry(side).or_default() += 1);
            }
            assert!(around.values().all(|&count| count == 2), "{name}");
            assert_eq!(around.len(), complex.edges().len());
            let euler = complex.vertices().len() + complex.triangles().len() - complex.edges().len();
            assert_eq!(euler, characteristic, "{name}");
        }
    }
}

#[test]
fn copies_are_as_far_away_as_they_say() {
    for (name, by) in
        [("copy-shifted", 0.5), ("copy-shifted", 10.0), ("surfaces-shifted", 1.0), ("surfaces-shifted", 2.0)]
    {
        let loaded = generated(&format!("{name}-{by}"));
        let [a, b] = complexes(&loaded);
        // 2^-26 = √ε and 2^-13 = ε^¼; the rest of L's formula is 1 up to a thousandth.
        let root = 2.0_f64.powi(if loaded.scene.dimension().count() == 2 { -26 } else { -13 });
        let sigma = 6.5 * root * 2.0 * a.primitive_length(&loaded.scene);
        assert_eq!((a.vertices().len(), a.edges().len()), (b.vertices().len(), b.edges().len()));
        for (&p, &q) in a.vertices().iter().zip(b.vertices()) {
            let square: f64 =
                loaded.scene.point(p).iter().zip(loaded.scene.point(q)).map(|(p, q)| (p - q) * (p - q)).sum();
            assert!((square.sqrt() / sigma / by - 1.0).abs() < 1.5e-3, "{name}: {} σ", square.sqrt() / sigma);
        }
    }
}

#[test]
fn near_polygons_are_near_and_not_all_the_same() {
    let loaded = generated("polygons-near");
    let [a, b] = complexes(&loaded);
    let sigma = 6.5 * 2.0_f64.powi(-26) * 2.0 * a.primitive_length(&loaded.scene);
    let distance = |p: Vertex, q: Vertex| {
        let [p, q] = [p, q].map(|v| loaded.scene.point(v));
        (p[0] - q[0]).hypot(p[1] - q[1])
    };
    let nearest = |&q: &Vertex| a.vertices().iter().map(|&p| distance(p, q)).fold(f64::INFINITY, f64::min) / sigma;
    let near: Vec<f64> = b.vertices().iter().map(nearest).filter(|&far| far < 3.0).collect();
    let within = |limit: f64| near.iter().filter(|&&far| far < limit).count();
    assert!(within(1e-9) > 5 && within(1.0) > within(1e-9) + 5 && near.len() > within(1.0) + 10, "{near:?}");
}

#[test]
fn near_surfaces_are_near_vertices_and_triangles() {
    let loaded = generated("surfaces-near");
    let [a, b] = complexes(&loaded);
    let sigma = 6.5 * 2.0_f64.powi(-13) * 2.0 * a.primitive_length(&loaded.scene);
    let distance = |p: Vertex, q: Vertex| {
        let [p, q] = [p, q].map(|v| loaded.scene.point(v));
        p.iter().zip(q).map(|(p, q)| (p - q) * (p - q)).sum::<f64>().sqrt()
    };
    let nearest = |&q: &Vertex| a.vertices().iter().map(|&p| distance(p, q)).fold(f64::INFINITY, f64::min) / sigma;
    let all: Vec<f64> = b.vertices().iter().map(nearest).collect();
    let within = |limit: f64| all.iter().filter(|&&far| far < limit).count();
    assert!(within(1e-9) > 2 && within(1.0) > within(1e-9) && within(4.0) > within(1.0) + 2, "{all:?}");
    assert!(all.len() > within(4.0) + 5, "the others are beside edges and triangles: {all:?}");
}

#[test]
fn meshes_maps_and_copies_come_from_files() {
    let folder = tempfile::tempdir().unwrap();
    let off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0.1000000000000000001\n0 1 0\n4 0 1 2 3\n";
    std::fs::write(folder.path().join("square.off"), off.replace("4 2 0", "4 1 0")).unwrap();
    std::fs::write(folder.path().join("line.obj"), "v 0.5 0.5 -1\nv 0.5 0.5 1\nl 1 2\n").unwrap();
    let loaded = load(
        folder.path(),
        "task = \"contacts3d\"\nround = true\na = { path = \"square.off\" }\nb = { path = \"line.obj\" }\n",
    );
    assert_eq!(loaded.notes.rounded, 1);
    let [a, b] = complexes(&loaded);
    assert_eq!((a.triangles().len(), b.edges(), loaded.scene.len()), (2, &[[4, 5].map(Vertex::input)][..], 6));
    assert_eq!(loaded.scene.point(Vertex::input(2)), [1.0, 1.0, 0.1]);

    let copied = "task = \"contacts3d\"\nround = true\na = { path = \"square.off\" }\nb = { shifted = 2 }\n";
    let loaded = load(folder.path(), copied);
    let [a, b] = complexes(&loaded);
    assert_eq!((a.triangles().len(), b.triangles().len(), loaded.scene.len()), (2, 2, 8));
    assert!(loaded.scene.point(Vertex::input(4))[0] > 0.0);

    let map = r#"{"type": "Topology", "arcs": [[[0, 0], [2, 0], [2, 2], [0, 0]]], "objects":
        {"o": {"type": "GeometryCollection", "geometries": [{"type": "Polygon", "arcs": [[0]]}]}}}"#;
    std::fs::write(folder.path().join("map.json"), map).unwrap();
    let loaded = load(
        folder.path(),
        "task = \"contacts2d\"\npoints = [[1, -1], [1, 5]]\na = { edges = [[0, 1]] }\n\
         b = { topojson = \"map.json\", object = \"o\" }\n",
    );
    let [a, b] = complexes(&loaded);
    assert_eq!((a.len(), b.edges().len(), b.vertices()[0]), (3, 3, Vertex::input(2)));
}

#[test]
fn an_id_is_about_the_complexes_and_not_how_they_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let id = |a: &str, b: &str| {
        let points = "points = [[0, 0], [1, 0], [0, 1], [5, 5], [6, 6]]";
        load(folder.path(), &format!("task = \"contacts2d\"\n{points}\na = {{ {a} }}\nb = {{ {b} }}\n")).id
    };
    let first = id("closed = [[0, 1, 2]]", "vertices = [3]");
    assert_eq!(id("edges = [[2, 1], [0, 1], [0, 2]], vertices = [0]", "vertices = [3, 3]"), first);
    let others = [
        id("closed = [[0, 1, 2]]", "vertices = [4]"),
        id("closed = [[0, 1, 2]]", ""),
        id("triangles = [[0, 1, 2]]", "vertices = [3]"),
        id("vertices = [3]", "closed = [[0, 1, 2]]"),
    ];
    assert!(others.iter().all(|other| *other != first));
}
