//! `solve`: the files that are asked for, and errors that name the file that is wrong.

use std::path::Path;

use tempfile::{TempDir, tempdir};

use crate::common::{Told, at, expect, read, run, write};

const TETRAHEDRON: &str = "OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

/// Points at random in a square, the same in every run.
pub fn scattered(folder: &TempDir, count: usize) -> String {
    let mut state: u64 = 1;
    let mut number = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        format!("0x{:x}p-32", state >> 32)
    };
    let lines: String = (0..count).map(|_| format!("{},{}\n", number(), number())).collect();
    write(folder, "scattered.csv", &lines)
}

/// The names of the files of a folder, in their order.
fn files(folder: &str) -> String {
    let Ok(entries) = std::fs::read_dir(folder) else { return String::new() };
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names.join(" ")
}

/// The files that `solve` writes into a new folder, and what it says.
fn solved(code: i32, words: &[&str]) -> (String, Told) {
    let folder = tempdir().unwrap();
    let out = at(&folder, "out");
    let told = expect(code, &[&["solve"], words, &["--out", &out]].concat());
    let printed: Vec<&str> = told.stdout.lines().map(|line| line.rsplit('/').next().unwrap()).collect();
    let written = files(&out);
    let mut sorted = printed.clone();
    sorted.sort_unstable();
    assert_eq!(sorted.join(" "), written, "{words:?}: what is printed is what is there");
    (written, told)
}

#[test]
fn only_files_that_are_asked_for_are_written() {
    let folder = tempdir().unwrap();
    let mesh = write(&folder, "part.off", TETRAHEDRON);
    let slice = ["slice", mesh.as_str()];
    let of_scene = |suite: &str, scene: &str, more: &[&str]| solved(0, &[&[suite, "-f", scene], more].concat()).0;
    let of_mesh = |more: &[&str]| solved(0, &[&slice, more].concat()).0;
    assert!(of_mesh(&[]).starts_with("part-0.obj part-0.off part-0.ply part-1.obj"));
    assert_eq!(of_mesh(&["--only", "part-1,parts", "--format", "off,json"]), "part-1.off parts.json");
    assert_eq!(of_mesh(&["--only", "part-0", "--format", "stl"]), "part-0.stl");
    assert_eq!(of_mesh(&["--only", "vertices"]), "vertices.json");
    let squares = "overlay-squares-overlay2d-method-grid$";
    let both = ["--only", "union,intersection", "--format", "geojson"];
    assert_eq!(of_scene("overlays", squares, &both), "intersection.geojson union.geojson");
    assert_eq!(of_scene("overlays", squares, &["--only", "union"]), "union.geojson union.svg");
    assert_eq!(of_scene("tilings", "tilings/bricks$", &["--format", "GeoJSON"]), "probes.geojson");
    let crossed = of_scene("crossings", "segments-lattice-crossings$", &["--format", "geojson"]);
    assert_eq!(crossed, "crossings.geojson");

    for (words, said) in [
        (&["--format", "svg"][..], "--format: the answer has no format `svg`; it has json, obj, off, ply, stl\n"),
        (&["--only", "union,part-0"], "--only: the answer has no part `union`; it has part-0, part-1"),
        (&["--only", "parts", "--format", "off,json"], "--format: no named part has the format `off`; the parts that"),
        (
            &["--only", "parts,part-0", "--format", "ply"],
            "--only: part `parts` does not have any of the named formats; it has json\n",
        ),
    ] {
        let (written, told) = solved(2, &[&slice, words].concat());
        assert!(told.stderr.contains(said), "{words:?}: {}", told.stderr);
        assert_eq!((written.as_str(), told.stderr.lines().count()), ("", 1), "nothing is written");
    }
}

/// A picture of many parts is drawn on request, and input vertices are listed on request.
#[test]
fn a_large_answer_is_written_without_what_is_seldom_wanted() {
    let folder = tempdir().unwrap();
    let points = scattered(&folder, 5_200);
    let task = ["delaunay2d", points.as_str()];
    let (written, told) = solved(0, &task);
    assert_eq!(written, "edges.json triangles.geojson");
    let note = format!("predicament: {points}: triangles.svg would have ");
    assert!(told.stderr.starts_with(&note), "{}", told.stderr);
    assert!(told.stderr.ends_with(", more than 10000, and is not drawn; --format svg draws it\n"), "{}", told.stderr);
    for (words, files) in [
        (&["-q"][..], "edges.json triangles.geojson"),
        (&["--format", "svg"], "triangles.svg"),
        (&["--format", "wkt"], "triangles.wkt"),
        (&["--only", "vertices,edges"], "edges.json vertices.json"),
    ] {
        let (written, told) = solved(0, &[&task, words].concat());
        assert_eq!((written.as_str(), told.stderr.as_str()), (files, ""), "{words:?}");
    }
    // Few parts are drawn as before, and a constructed vertex is listed exactly.
    let few = write(&folder, "few.csv", "0,0\n3,3\n3,0\n0,2\n");
    assert_eq!(solved(0, &["delaunay2d", &few]).0, "edges.json triangles.geojson triangles.svg");
    let crossing = ["delaunay2d", &few, "--set", "constraints=[[0, 1], [2, 3]]"];
    assert_eq!(solved(0, &crossing).0, "edges.json triangles.geojson triangles.svg vertices.json");
}

/// Meshes that are open or touch themselves are sliced, others are refused, and an error is about the mesh.
#[test]
fn a_bad_mesh_is_blamed_and_not_the_folder() {
    let second = TETRAHEDRON.lines().skip(2).take(4).map(|line| line.replace('0', "1") + "\n").collect::<String>();
    let double = |points: &str| {
        let lines: Vec<&str> = TETRAHEDRON.lines().collect();
        let (own, faces) = (lines[2..6].join("\n"), lines[6..].join("\n"));
        format!("OFF\n8 8 0\n{own}\n{points}{faces}\n3 4 6 5\n3 4 5 7\n3 5 6 7\n3 6 4 7\n")
    };
    let crossing = double(&second);
    let twice = double("0 0 0\n4 0 0\n0 4 0\n0 0 4\n");
    let pinched = "OFF\n5 2 0\n1 1 0\n-1 -1 0\n2 0 -1\n-1 -2 -2\n1 0 2\n3 0 1 2\n3 1 3 4\n";
    let origin = "planes=[[[0,0,0],[0,1,0],[0,0,1]],[[0,0,0],[0,0,1],[1,0,0]],[[0,0,0],[1,0,0],[0,1,0]]]";
    for (name, text, more, refused) in [
        ("open", TETRAHEDRON.replace("4 4 0", "4 3 0").replace("3 2 0 3\n", ""), &[][..], false),
        ("crossing", crossing.clone(), &[], true),
        ("twice", twice, &[], true),
        ("pinched", pinched.to_owned(), &["--set", origin], false),
        ("turned", TETRAHEDRON.replace("3 2 0 3", "3 0 2 3"), &[], true),
        (
            "three-faces",
            TETRAHEDRON.replace("4 4 0", "5 5 0").replace("\n3 0 2 1", "\n9 9 9\n3 0 2 1\n3 0 1 4"),
            &[],
            true,
        ),
        ("flat", TETRAHEDRON.replace("0 0 4\n", "8 0 0\n"), &[], true),
    ] {
        let folder = tempdir().unwrap();
        let mesh = write(&folder, &format!("{name}.off"), &text);
        for backend in ["exact", "naive", "sos"] {
            let (_, told) = solved(if refused { 104 } else { 0 }, &[&["slice", &mesh, "-b", backend], more].concat());
            assert!(!told.stderr.contains("panic"), "{name} with {backend}: {}", told.stderr);
            let is_about_mesh = told.stderr.lines().all(|line| line.starts_with(&format!("predicament: {mesh}:")));
            assert!(is_about_mesh && (!refused || !told.stderr.is_empty()), "{name}: {}", told.stderr);
        }
    }
    // Of two meshes, the bad one is named, with the line.
    let folder = tempdir().unwrap();
    let [good, bad] =
        [("good.off", TETRAHEDRON), ("bad.off", &crossing)].map(|(name, text)| write(&folder, name, text));
    for meshes in [[&good, &bad], [&bad, &good]] {
        let (_, told) = solved(104, &["mesh-intersect", meshes[0], meshes[1]]);
        let said = told.stderr.strip_prefix(&format!("predicament: {bad}:")).expect("the bad mesh first");
        assert!(said.contains("(line 1") && said.contains(" of the mesh pass through each other; "), "{said}");
        assert!(said.contains("add --set check=false") && !said.contains("good.off"), "{said}");
    }
    solved(0, &["mesh-intersect", &good, &bad, "-b", "sos:per-mesh", "--set", "check=false"]);
}

/// Every error about what is in a file names that file, and no other.
#[test]
fn errors_about_files_name_them() {
    let folder = tempdir().unwrap();
    let [flat, solid, two, square, mesh, huge] = [
        ("flat.csv", "0,0\n1,0\n0,1\n1,1\n5,5\n"),
        ("solid.csv", "0,0,0\n1,0,0\n0,1,0\n0,0,1\n1,1,1\n"),
        ("two.csv", "0,0\n1,1\n"),
        ("square.geojson", r#"{"type":"Polygon","coordinates":[[[0,0],[2,0],[2,2],[0,2],[0,0]]]}"#),
        ("mesh.off", TETRAHEDRON),
        ("huge.off", &TETRAHEDRON.replace("\n4 0 0\n", "\n4e307 0 0\n")),
    ]
    .map(|(name, text)| write(&folder, name, text));
    let bow = write(&folder, "bow.geojson", r#"{"type":"Polygon","coordinates":[[[0,0],[2,2],[2,0],[0,2],[0,0]]]}"#);
    let cases: [(&[&str], &[&str]); 15] = [
        (&["hull2d", &solid], &[&solid]),
        (&["hull3d", &flat], &[&flat]),
        (&["delaunay2d", &solid], &[&solid]),
        (&["insphere", &flat], &[&flat]),
        (&["orient3d", &two], &[&two]),
        (&["triangulate", &mesh], &[&mesh]),
        (&["overlay2d", &mesh], &[&mesh]),
        (&["crossings", &square], &[&square]),
        (&["polygon-locate", &square, &solid], &[&solid]),
        (&["mesh-locate", &mesh, &flat], &[&flat]),
        (&["contacts3d", &mesh, &flat], &[&flat]),
        (&["mesh-intersect", &mesh, &square], &[&square]),
        // What a backend declines is about all files of the scene.
        (&["mesh-intersect", &mesh, &mesh, "-b", "tolerance"], &[&mesh, &mesh]),
        (&["slice", &huge, "-b", "tolerance"], &[&huge]),
        (&["overlay2d", &bow, "-b", "tolerance"], &[&bow]),
    ];
    let all = [&flat, &solid, &two, &square, &mesh, &huge, &bow];
    for (words, wrong) in cases {
        let told = run(&[&["solve"], words, &["--out", &at(&folder, "out")]].concat());
        assert!([2, 104].contains(&told.code), "{words:?}: {}", told.stderr);
        assert_eq!(told.stderr.lines().count(), 1, "{words:?}: {}", told.stderr);
        for file in all {
            assert_eq!(told.stderr.contains(&**file), wrong.contains(&file.as_str()), "{words:?}: {}", told.stderr);
        }
        assert!(!told.stderr.contains("points, with --set") && !told.stderr.contains("coordinates, with --set"));
        assert!(!Path::new(&at(&folder, "out")).exists(), "{words:?}: nothing is written");
    }
    // That an answer has no form in a file is about the input; that the folder is none is about the folder.
    let cube = write(&folder, "cube.csv", "0,0,0\n1,0,0\n0,1,0\n0,0,1\n1,1,0\n1,0,1\n0,1,1\n1,1,1\n");
    let (_, told) = solved(2, &["hull3d", &cube, "--format", "stl"]);
    let said = format!("predicament: {cube}: exact: hull.stl can't hold the answer: face 0 has 4 corners, and STL has");
    assert!(told.stderr.starts_with(&said), "{}", told.stderr);
    let told = expect(2, &["solve", "hull3d", &cube, "--out", &flat]);
    assert!(told.stderr.contains(&flat) && !told.stderr.contains(&cube), "{}", told.stderr);
}

/// Hulls without area or volume, as docs/FORMAT.md has them.
#[test]
fn flat_hulls_are_written_with_a_note() {
    let folder = tempdir().unwrap();
    let hull = |task: &str, text: &str, backend: &str| {
        let points = write(&folder, "points.csv", text);
        let out = at(&folder, "out");
        let _ = std::fs::remove_dir_all(&out);
        let told = expect(0, &["solve", task, &points, "-b", backend, "--out", &out]);
        let said = told.stderr.replace(&format!("predicament: {points}: "), "");
        let geometry = std::fs::read_to_string(Path::new(&out).join("hull.geojson")).unwrap_or_default();
        (files(&out), said, geometry)
    };
    let (line, place) = ("0,0\n1,1\n3,3\n1,1\n", "2,5\n2,5\n2,5\n");
    let (written, said, geometry) = hull("hull2d", line, "exact");
    assert_eq!(written, "hull.geojson hull.svg");
    assert_eq!(said, "the hull has no area: it is a line between two points\n");
    assert!(geometry.contains(r#"{"coordinates":[[0.0,0.0],[3.0,3.0]],"type":"LineString"}"#), "{geometry}");
    let (_, said, geometry) = hull("hull2d", place, "exact");
    assert_eq!(said, "the hull has no area: it is one point\n");
    assert!(geometry.contains(r#"{"coordinates":[2.0,5.0],"type":"Point"}"#), "{geometry}");
    let (_, said, geometry) = hull("hull2d", place, "sos");
    assert!(said.is_empty() && geometry.contains("Polygon"), "where ties are broken it is a triangle: {geometry}");

    let space = |text: &str| text.lines().map(|line| format!("{line},7\n")).collect::<String>();
    for (text, what) in [(space(line), "a line between two points"), (space(place), "one point")] {
        let (written, said, _) = hull("hull3d", &text, "exact");
        assert_eq!(written, "hull.json vertices.json", "no mesh without faces");
        let note =
            format!("the hull has no faces: it is {what}; hull.json and vertices.json have it, and there is no mesh\n");
        assert_eq!(said, note);
        let (edges, vertices) =
            if text.ends_with("1,1,7\n") { (r#"[["0","2"]]"#, r#"["0","2"]"#) } else { ("[]", r#"["0"]"#) };
        let names = read(&at(&folder, "out"), "hull.json").replace([' ', '\n'], "");
        assert_eq!(names, format!(r#"{{"edges":{edges},"faces":[],"vertices":{vertices}}}"#));
    }
    let points = write(&folder, "points.csv", &space(line));
    let (_, told) = solved(2, &["hull3d", &points, "--format", "off"]);
    let said = "--format: the answer has no format `off`; it has json; the hull has no faces";
    assert!(told.stderr.contains(said), "{}", told.stderr);
    let (written, said, _) = hull("hull3d", &space("0,0\n4,0\n0,4\n4,4\n2,2\n"), "exact");
    assert_eq!(written, "hull.json hull.obj hull.off hull.ply");
    let names = read(&at(&folder, "out"), "hull.json").replace([' ', '\n'], "");
    assert!(names.contains(r#""vertices":["0","1","2","3"]"#) && names.matches("],[").count() == 1, "{names}");
    assert_eq!(said, "the hull has no volume: it is a polygon, written as two faces back to back\n");
    let off = read(&at(&folder, "out"), "hull.off");
    assert!(off.starts_with("OFF\n4 2 0\n") && off.lines().filter(|line| line.starts_with("4 ")).count() >= 2, "{off}");
}
