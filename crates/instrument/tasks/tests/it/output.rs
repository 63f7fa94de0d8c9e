//! Tests of answer files: formats of other programs, and exact vertices.

use predicament_predicates::{Construction, Dimension, Scene, Vertex};
use predicament_tasks::output;
use serde_json::Value;

fn json(path: &std::path::Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// A unit square and its diagonals' crossing at a third.
fn plane() -> (Scene, Vertex) {
    let mut scene = Scene::from_points2(&[[0.0, 0.0], [1.0, 1.0], [0.0, 0.5], [1.0, 0.0]]).unwrap();
    let [a, b, c, d] = [0, 1, 2, 3].map(Vertex::input);
    let x = scene.construct(Construction::Ssi([[a, b], [c, d]])).unwrap();
    (scene, x)
}

#[test]
fn vertices_are_exact_and_say_what_they_were_constructed_from() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, x) = plane();
    let path = output::vertices(&scene, [x, Vertex::input(1), x], folder.path()).unwrap();
    let all = json(&path);
    let ids: Vec<&str> = all.as_array().unwrap().iter().map(|v| v["vertex"].as_str().unwrap()).collect();
    assert_eq!(ids, ["0", "1", "2", "3", "c0"], "with what defines it, each once");
    assert_eq!(all[4]["exact"], serde_json::json!(["1/3", "1/3"]));
    assert_eq!(all[4]["nearest"], serde_json::json!([1.0 / 3.0, 1.0 / 3.0]));
    assert_eq!(all[4]["constructed_from"], "SSI(0 1, 2 3)");
    assert_eq!((&all[2]["exact"], &all[2]["constructed_from"]), (&serde_json::json!(["0", "1/2"]), &Value::Null));
    assert_eq!(json(&output::vertices(&scene, [], folder.path()).unwrap()), serde_json::json!([]));
}

#[test]
fn polygons_of_the_plane_are_features_and_a_picture() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, x) = plane();
    let [a, c] = [0, 2].map(Vertex::input);
    let files = output::plane(&scene, &[vec![vec![a, x, c]]], folder.path(), "triangles").unwrap();
    let feature = &json(&files[1])["features"][0];
    let third = 1.0 / 3.0;
    let ring = serde_json::json!([[[0.0, 0.0], [third, third], [0.0, 0.5], [0.0, 0.0]]]);
    assert_eq!(feature["geometry"], serde_json::json!({ "type": "Polygon", "coordinates": ring }));
    assert_eq!(feature["properties"]["vertices"], serde_json::json!([["0", "c0", "2"]]));
    let svg = std::fs::read_to_string(&files[0]).unwrap();
    // The box is a third wide and a half high: 640 by 960 pixels within the margin, y upwards.
    assert!(svg.contains("<path d=\"M20.00 980.00L660.00 340.00L20.00 20.00Z\"/>"), "{svg}");
    assert_eq!(svg.matches("<circle").count(), 3);
}

#[test]
fn a_crossing_between_doubles_is_drawn_between_them() {
    let folder = tempfile::tempdir().unwrap();
    // Doubles are one unit apart: two triangles of slide 72 to 76, "Orientation Inversion".
    let base = 2.0_f64.powi(52);
    let corners = [[6.0, 3.0], [0.0, 7.0], [8.0, 2.0], [1.0, 6.0]].map(|point| point.map(|x| base + x));
    let mut scene = Scene::from_points2(&corners).unwrap();
    let [a, b, c, d] = [0, 1, 2, 3].map(Vertex::input);
    let x = scene.construct(Construction::Ssi([[a, b], [c, d]])).unwrap();
    let files = output::plane(&scene, &[vec![vec![a, x, d]]], folder.path(), "turn").unwrap();
    let svg = std::fs::read_to_string(&files[0]).unwrap();
    // The point (4.5, 4) in the box from (1, 3) to (6, 6), 192 pixels per unit.
    assert!(svg.contains("<path d=\"M980.00 596.00L692.00 404.00L20.00 20.00Z\"/>"), "{svg}");
    let at = &json(&files[1])["features"][0]["geometry"]["coordinates"][0][1];
    assert_eq!(*at, serde_json::json!([base + 4.0, base + 4.0]), "rounded to even");
}

#[test]
fn meshes_are_read_again_and_refused_where_they_are_none() {
    let folder = tempfile::tempdir().unwrap();
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, 0.5, 0.0]];
    let scene = Scene::new(Dimension::Three, corners.concat()).unwrap();
    let face = |ids: [usize; 3]| ids.map(Vertex::input).to_vec();
    let faces = [face([0, 2, 1]), face([0, 1, 3]), face([1, 2, 3]), face([2, 0, 3])];
    let files = output::mesh(&scene, &faces, folder.path(), "part").unwrap();
    assert_eq!(files.len(), 3);
    for file in &files {
        let (name, bytes) = (file.display().to_string(), std::fs::read(file).unwrap());
        let decimals = predicament_formats::Decimals::new(false);
        let mesh = predicament_formats::mesh::read(&name, bytes, &decimals).unwrap();
        assert_eq!(mesh.points, &corners[..4], "{name}: the vertices of faces only");
        assert_eq!(mesh.faces.len(), 4);
    }
    let why = output::mesh(&scene, &[face([0, 1, 1])], folder.path(), "none").unwrap_err();
    assert!(why.to_string().starts_with("none.off can't hold the answer: face 0 has vertex 1 twice"), "{why}");
    assert!(!folder.path().join("none.off").exists(), "no empty file is left");
}
