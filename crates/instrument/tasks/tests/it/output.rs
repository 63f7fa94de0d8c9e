//! Tests of answer files: formats of other programs, and exact vertices.

use std::io::Write;

use predicament_predicates::{Construction, Dimension, Scene, Vertex};
use predicament_tasks::output::{self, Choice, Error, Files, Written};
use serde_json::Value;

fn json(path: &std::path::Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// The formats and parts with these names.
fn only(formats: &[&str], parts: &[&str]) -> Choice {
    let own = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
    Choice { formats: own(formats), parts: own(parts) }
}

/// A folder with the chosen files, and what the writer says.
fn written(
    choice: &Choice,
    offer: impl Fn(&mut Files) -> Result<(), Error>,
) -> (tempfile::TempDir, Result<Written, Error>) {
    let folder = tempfile::tempdir().unwrap();
    let made = output::write(&folder.path().join("made"), choice, offer);
    (folder, made)
}

/// The names of the files that are written.
fn names(written: &Written) -> Vec<&str> {
    written.files.iter().map(|file| file.file_name().unwrap().to_str().unwrap()).collect()
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
    let (scene, x) = plane();
    let (_folder, made) =
        written(&Choice::default(), |files| output::vertices(files, &scene, [x, Vertex::input(1), x]));
    let all = json(&made.unwrap().files[0]);
    let ids: Vec<&str> = all.as_array().unwrap().iter().map(|v| v["vertex"].as_str().unwrap()).collect();
    assert_eq!(ids, ["0", "1", "2", "3", "c0"], "with what defines it, each once");
    assert_eq!(all[4]["exact"], serde_json::json!(["1/3", "1/3"]));
    assert_eq!(all[4]["nearest"], serde_json::json!([1.0 / 3.0, 1.0 / 3.0]));
    assert_eq!(all[4]["constructed_from"], "SSI(0 1, 2 3)");
    assert_eq!((&all[2]["exact"], &all[2]["constructed_from"]), (&serde_json::json!(["0", "1/2"]), &Value::Null));
    let (_folder, made) = written(&only(&[], &["vertices"]), |files| output::vertices(files, &scene, []));
    assert_eq!(json(&made.unwrap().files[0]), serde_json::json!([]));
}

/// The coordinates of input vertices are in the input.
#[test]
fn input_vertices_are_written_on_request() {
    let (scene, x) = plane();
    let write = |choice: &Choice, of: &[Vertex]| {
        let (_folder, made) = written(choice, |files| {
            files.json("pieces.json", || Value::Null)?;
            output::vertices(files, &scene, of.to_vec())
        });
        names(&made.unwrap()).join(" ")
    };
    let inputs = [0, 1].map(Vertex::input);
    assert_eq!(write(&Choice::default(), &inputs), "pieces.json");
    assert_eq!(write(&Choice::default(), &[x]), "pieces.json vertices.json");
    assert_eq!(write(&only(&["json"], &[]), &inputs), "pieces.json vertices.json");
    assert_eq!(write(&only(&[], &["vertices"]), &inputs), "vertices.json");
    assert_eq!(write(&only(&[], &["pieces"]), &inputs), "pieces.json");
}

#[test]
fn polygons_of_the_plane_are_features_a_picture_and_text() {
    let (scene, x) = plane();
    let [a, c] = [0, 2].map(Vertex::input);
    let polygons = [vec![vec![a, x, c]], vec![vec![a, x]], vec![vec![c]]];
    let (_folder, made) = written(&only(&["svg", "geojson", "wkt"], &[]), |files| {
        output::plane(files, &scene, "triangles", polygons.iter().cloned())
    });
    let made = made.unwrap();
    assert_eq!(names(&made), ["triangles.svg", "triangles.geojson", "triangles.wkt"]);
    let features = &json(&made.files[1])["features"];
    let third = 1.0 / 3.0;
    let ring = serde_json::json!([[[0.0, 0.0], [third, third], [0.0, 0.5], [0.0, 0.0]]]);
    assert_eq!(features[0]["geometry"], serde_json::json!({ "type": "Polygon", "coordinates": ring }));
    assert_eq!(features[0]["properties"]["vertices"], serde_json::json!([["0", "c0", "2"]]));
    let line = serde_json::json!({ "type": "LineString", "coordinates": [[0.0, 0.0], [third, third]] });
    assert_eq!(features[1]["geometry"], line, "a polygon has three vertices");
    assert_eq!(features[2]["geometry"], serde_json::json!({ "type": "Point", "coordinates": [0.0, 0.5] }));
    let svg = std::fs::read_to_string(&made.files[0]).unwrap();
    // The box is a third wide and a half high: 640 by 960 pixels within the margin, y upwards.
    assert!(svg.contains("<path d=\"M20.00 980.00L660.00 340.00L20.00 20.00Z\"/>"), "{svg}");
    assert_eq!(svg.matches("<circle").count(), 3);
    let third = "0.3333333333333333";
    let wkt = format!(
        "POLYGON ((0.0 0.0, {third} {third}, 0.0 0.5, 0.0 0.0))\nLINESTRING (0.0 0.0, {third} {third})\nPOINT (0.0 0.5)\n"
    );
    assert_eq!(std::fs::read_to_string(&made.files[2]).unwrap(), wkt);
}

/// GeoJSON and WKT files are read again, the same.
#[test]
fn polygons_are_read_again() {
    let (scene, x) = plane();
    let ring = [Vertex::input(0), Vertex::input(3), x];
    let (_folder, made) = written(&only(&["geojson", "wkt"], &[]), |files| {
        output::plane(files, &scene, "map", std::iter::once(vec![ring.to_vec()]))
    });
    let read = |file: &std::path::Path| {
        let decimals = predicament_formats::Decimals::new(false);
        let name = file.display().to_string();
        let found = predicament_formats::geometry::read(&name, std::fs::read(file).unwrap(), &decimals).unwrap();
        let edges = found.edges();
        (edges.points, edges.edges)
    };
    let files = made.unwrap().files;
    let (points, edges) = read(&files[0]);
    assert_eq!(points, [[0.0, 0.0], [1.0, 0.0], [1.0 / 3.0, 1.0 / 3.0]]);
    assert_eq!(edges.len(), 3);
    assert_eq!(read(&files[1]), (points, edges));
}

/// A picture of many parts is for those who ask for it, and a remark says so.
#[test]
fn a_picture_of_many_parts_is_drawn_on_request() {
    let (scene, _) = plane();
    let write = |count: usize, choice: &Choice| {
        let polygon = |_| vec![[0, 2, 3].map(Vertex::input).to_vec()];
        let (_folder, made) = written(choice, |files| output::plane(files, &scene, "hull", (0..count).map(polygon)));
        let made = made.unwrap();
        (names(&made).join(" "), made.notes)
    };
    let all = Choice::default();
    let note = "hull.svg would have 10001 parts, more than 10000, and is not drawn; --format svg draws it".to_owned();
    assert_eq!(write(10_000, &all), ("hull.svg hull.geojson".to_owned(), Vec::new()));
    assert_eq!(write(10_001, &all), ("hull.geojson".to_owned(), vec![note.clone()]));
    assert_eq!(write(10_001, &only(&[], &["hull"])), ("hull.geojson".to_owned(), vec![note]));
    assert_eq!(write(10_001, &only(&["svg"], &[])), ("hull.svg".to_owned(), Vec::new()));
    assert_eq!(write(10_001, &only(&["geojson"], &["hull"])), ("hull.geojson".to_owned(), Vec::new()));
}

#[test]
fn a_crossing_between_doubles_is_drawn_between_them() {
    // Doubles are one unit apart: two triangles of slide 72 to 76, "Orientation Inversion".
    let base = 2.0_f64.powi(52);
    let corners = [[6.0, 3.0], [0.0, 7.0], [8.0, 2.0], [1.0, 6.0]].map(|point| point.map(|x| base + x));
    let mut scene = Scene::from_points2(&corners).unwrap();
    let [a, b, c, d] = [0, 1, 2, 3].map(Vertex::input);
    let x = scene.construct(Construction::Ssi([[a, b], [c, d]])).unwrap();
    let (_folder, made) =
        written(&Choice::default(), |files| output::plane(files, &scene, "turn", std::iter::once(vec![vec![a, x, d]])));
    let files = made.unwrap().files;
    let svg = std::fs::read_to_string(&files[0]).unwrap();
    // The point (4.5, 4) in the box from (1, 3) to (6, 6), 192 pixels per unit.
    assert!(svg.contains("<path d=\"M980.00 596.00L692.00 404.00L20.00 20.00Z\"/>"), "{svg}");
    let at = &json(&files[1])["features"][0]["geometry"]["coordinates"][0][1];
    assert_eq!(*at, serde_json::json!([base + 4.0, base + 4.0]), "rounded to even");
}

#[test]
fn meshes_are_read_again_and_refused_where_they_are_none() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, 0.5, 0.0]];
    let scene = Scene::new(Dimension::Three, corners.concat()).unwrap();
    let face = |ids: [usize; 3]| ids.map(Vertex::input).to_vec();
    let faces = [face([0, 2, 1]), face([0, 1, 3]), face([1, 2, 3]), face([2, 0, 3])];
    let write = |choice: &Choice, faces: &[Vec<Vertex>]| {
        written(choice, |files| output::mesh(files, &scene, "part", faces.iter().cloned()))
    };
    let (_folder, made) = write(&only(&["off", "obj", "ply", "stl"], &[]), &faces);
    let made = made.unwrap();
    assert_eq!(names(&made), ["part.off", "part.obj", "part.ply", "part.stl"]);
    for file in &made.files {
        let (name, bytes) = (file.display().to_string(), std::fs::read(file).unwrap());
        let decimals = predicament_formats::Decimals::new(false);
        let mut mesh = predicament_formats::mesh::read(&name, bytes, &decimals).unwrap();
        assert_eq!(mesh.faces.len(), 4);
        // STL does not list points.
        mesh.points.sort_by(|a, b| b.partial_cmp(a).unwrap());
        assert_eq!(mesh.points, [corners[1], corners[2], corners[3], corners[0]], "{name}: vertices of faces only");
    }
    let (_folder, made) = write(&Choice::default(), &faces);
    assert_eq!(names(&made.unwrap()), ["part.off", "part.obj", "part.ply"], "STL by its format");

    let (folder, made) = write(&Choice::default(), &[face([0, 1, 1])]);
    let why = made.unwrap_err().to_string();
    assert!(why.starts_with("part.off can't hold the answer: face 0 has vertex 1 twice"), "{why}");
    assert_eq!(std::fs::read_dir(folder.path().join("made")).unwrap().count(), 0, "no empty file is left");

    let (_folder, made) = write(&Choice::default(), &[]);
    assert_eq!(made.unwrap().notes, ["the mesh part is empty: it has no faces"]);
    let (_folder, made) = write(&only(&[], &["other"]), &[]);
    assert_eq!(made.unwrap_err().to_string(), "the answer has no part `other`; it has part");
}

/// An answer with four files, of which one waits for its format, and one for its format or its part.
fn four(files: &mut Files) -> Result<(), Error> {
    let text = |text: &'static str| move |out: &mut dyn Write| write!(out, "{text}");
    files.write("union.off", text("1"))?;
    files.write("union.json", text("2"))?;
    files.by_format("union.stl", text("3"))?;
    files.on_request("vertices.json", text("4"))
}

#[test]
fn formats_and_parts_choose_files() {
    for (formats, parts, expected) in [
        (&[][..], &[][..], "union.off union.json"),
        (&["off"], &[], "union.off"),
        (&["OFF", ".stl"], &[], "union.off union.stl"),
        (&["json"], &[], "union.json vertices.json"),
        (&["json"], &["union"], "union.json"),
        (&[], &["union"], "union.off union.json"),
        (&[], &["vertices"], "vertices.json"),
        (&["off", "json"], &["union", "vertices"], "union.off union.json vertices.json"),
        (&["stl"], &["union"], "union.stl"),
    ] {
        let (folder, made) = written(&only(formats, parts), four);
        assert_eq!(names(&made.unwrap()).join(" "), expected, "{formats:?} {parts:?}");
        let count = std::fs::read_dir(folder.path().join("made")).unwrap().count();
        assert_eq!(count, expected.split(' ').count(), "{formats:?} {parts:?}: nothing else is there");
    }
    for (formats, parts, expected) in [
        (&["obj"][..], &[][..], "the answer has no format `obj`; it has json, off, stl"),
        (&["off", ""], &[], "the answer has no format ``; it has json, off, stl"),
        (&["off"], &["unions"], "the answer has no part `unions`; it has union, vertices"),
        (&["off"], &["vertices"], "no named part has the format `off`; the parts that have it are union"),
        (&["off"], &["union", "vertices"], "part `vertices` does not have any of the named formats; it has json"),
    ] {
        let (folder, made) = written(&only(formats, parts), four);
        assert_eq!(made.unwrap_err().to_string(), expected);
        assert!(!folder.path().join("made").exists(), "{expected}: nothing is written");
    }
}

/// Files that are not wanted cost nothing, and files that fail leave nothing.
#[test]
fn only_wanted_files_are_made_and_only_complete_ones_are_there() {
    let (folder, made) = written(&only(&[], &["good"]), |files| {
        files.write("good.txt", |out| writeln!(out, "good"))?;
        files.write("bad.txt", |_| unreachable!("not wanted"))
    });
    let made = made.unwrap();
    assert_eq!(std::fs::read_to_string(&made.files[0]).unwrap(), "good\n");
    assert_eq!(folder.path().join("made/good.txt"), made.files[0]);
    let (folder, made) = written(&Choice::default(), |files| {
        files.write("half.txt", |out| {
            write!(out, "half")?;
            Err(std::io::Error::other("c5 is no point"))
        })
    });
    assert_eq!(made.unwrap_err().to_string(), "half.txt can't hold the answer: c5 is no point");
    assert_eq!(std::fs::read_dir(folder.path().join("made")).unwrap().count(), 0);
    // What the system refuses is about the place.
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("union.off")).unwrap();
    let refused = output::write(folder.path(), &Choice::default(), four).unwrap_err();
    assert!(matches!(&refused, Error::System(error) if error.path.ends_with("union.off")), "{refused}");
}

/// Remarks about files that an answer does not have are in the error about them, too.
#[test]
fn an_unknown_format_is_explained() {
    let offer = |files: &mut Files| {
        files.note("the hull has no faces");
        files.write("vertices.json", |_| Ok(()))
    };
    let (_folder, made) = written(&only(&["off"], &[]), offer);
    let why = made.unwrap_err().to_string();
    assert_eq!(why, "the answer has no format `off`; it has json; the hull has no faces");
    let (_folder, made) = written(&Choice::default(), offer);
    assert_eq!(made.unwrap().notes, ["the hull has no faces"], "once");
}

#[test]
fn files_of_an_unusual_size_are_on_request() {
    let offer = |files: &mut Files| {
        files.write("signs.csv", |_| Ok(()))?;
        files.all_on_request(|files| files.write("triangles.geojson", |_| Ok(())))?;
        files.write("more.csv", |_| Ok(()))
    };
    let (_folder, made) = written(&Choice::default(), offer);
    assert_eq!(names(&made.unwrap()), ["signs.csv", "more.csv"]);
    let (_folder, made) = written(&only(&[], &["triangles"]), offer);
    assert_eq!(names(&made.unwrap()), ["triangles.geojson"]);
}
