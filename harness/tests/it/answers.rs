//! Tests of `judge`: answers of other programs, in the files that they leave.

use std::fs;

use tempfile::tempdir;

use crate::common::{at, run};

/// Two squares that overlap in a unit square.
fn squares(folder: &tempfile::TempDir) -> [String; 2] {
    let square = |name: &str, low: i32, high: i32| {
        let path = at(folder, name);
        let ring = format!("[[{low},{low}],[{high},{low}],[{high},{high}],[{low},{high}],[{low},{low}]]");
        fs::write(&path, format!(r#"{{"type":"Polygon","coordinates":[{ring}]}}"#)).unwrap();
        path
    };
    [square("first.geojson", 0, 2), square("second.geojson", 1, 3)]
}

#[test]
fn files_that_solve_writes_are_right() {
    let folder = tempdir().unwrap();
    let [first, second] = squares(&folder);
    let out = at(&folder, "out");
    assert_eq!(run(&["solve", "overlay2d", &first, &second, "--out", &out]).code, 0);
    let answers =
        ["union", "intersection", "difference", "symmetric-difference"].map(|part| format!("{out}/{part}.geojson"));
    let mut args = vec!["judge", "overlay2d", &first, &second];
    answers.iter().for_each(|file| args.extend(["--answer", file]));
    let told = run(&args);
    assert_eq!((told.code, told.stdout.contains(": right")), (0, true), "{}{}", told.stdout, told.stderr);

    // One part for another: the set is wrong, and the verdict says where.
    let swapped = format!("union={out}/intersection.geojson");
    let told = run(&["judge", "overlay2d", &first, &second, "--answer", &swapped]);
    assert_eq!(told.code, 100, "{}", told.stderr);
    assert!(told.stdout.contains(": wrong\n") && told.stdout.contains("wrong set (topology)"), "{}", told.stdout);

    let points = at(&folder, "points.csv");
    fs::write(&points, "0,0\n4,0\n4,4\n0,4\n1,2\n").unwrap();
    assert_eq!(run(&["solve", "delaunay2d", &points, "--out", &out]).code, 0);
    let triangles = format!("{out}/triangles.geojson");
    let told = run(&["judge", "delaunay2d", &points, "--answer", &triangles]);
    assert_eq!(told.code, 0, "{}{}", told.stdout, told.stderr);
}

#[test]
fn files_of_every_other_task_are_right_and_those_of_another_scene_are_not() {
    let folder = tempdir().unwrap();
    let scenes: [(&str, &str, &str, &[&str]); 7] = [
        ("contacts", "crossing-squares", "exact", &["contacts.json"]),
        ("crossings", "three-through-one-point", "exact", &["crossings.json"]),
        ("intervals", "three-cells", "exact", &["cells.csv"]),
        ("mesh-points", "two-tetrahedra", "exact", &["probes.csv"]),
        ("cubes", "twins$", "sos", &["measures.json"]),
        ("slices", "cube-in-thirds", "exact", &[]),
        ("snaps", "twice-and-crossed-snap", "exact", &["chains.geojson", "chains.wkt"]),
    ];
    for (suite, scene, backend, files) in scenes {
        let out = at(&folder, suite);
        let solved = run(&["solve", suite, "-f", scene, "-b", backend, "--out", &out]);
        assert_eq!(solved.code, 0, "{suite}: {}", solved.stderr);
        let mut all: Vec<Vec<String>> = files.iter().map(|file| vec![format!("{out}/{file}")]).collect();
        if files.is_empty() {
            let names = fs::read_dir(&out).unwrap().map(|file| file.unwrap().path().display().to_string());
            all.push(names.filter(|name| name.ends_with(".off")).collect());
        }
        for answer in all.iter().filter(|answer| fs::exists(&answer[0]).unwrap()) {
            let judged = |answer: &[String]| {
                let mut args = vec!["judge", suite, "-f", scene];
                answer.iter().for_each(|file| args.extend(["--answer", file]));
                let told = run(&args);
                (told.code, told.stdout + &told.stderr)
            };
            let (code, told) = judged(answer);
            assert!(code == 0 && told.contains(": right"), "{suite}: {told}");
            // Both cubes have faces in one plane: the verdict says that the length of edges is not judged.
            assert_eq!(told.contains("  judged: volume and area"), suite == "cubes", "{told}");
            // Less than all of it.
            let text = fs::read_to_string(&answer[0]).unwrap();
            let (code, told) = if answer.len() > 1 {
                judged(&answer[1..])
            } else {
                let other = text.replace('-', "").replace(['1', '2', '3'], "9");
                fs::write(&answer[0], other).unwrap();
                judged(answer)
            };
            assert!(code == 100 && told.contains(": wrong"), "{suite}: {told}");
        }
    }
}

#[test]
fn answers_in_other_forms_are_read_and_wrong_ones_are_findings() {
    let folder = tempdir().unwrap();
    let points = at(&folder, "points.csv");
    fs::write(&points, "0,0\n4,0\n4,4\n0,4\n1,2\n").unwrap();
    let answer = |name: &str, text: &str| {
        let path = at(&folder, name);
        fs::write(&path, text).unwrap();
        run(&["judge", "delaunay2d", &points, "--answer", &path, "--format", "json"])
    };
    let right = "[[0,1,4],[2,1,4],[2,4,3],[3,4,0]]";
    for (name, text) in [("a.json", right), ("b.csv", "a,b,c\n0,1,4\n2,1,4\n2,4,3\n3,4,0\n")] {
        let told = answer(name, text);
        assert_eq!((told.code, told.stdout.contains("\"verdict\":\"right\"")), (0, true), "{}", told.stdout);
    }
    for (text, check) in [
        ("[[0,1,4],[2,1,4],[2,4,3]]", "\"check\":\"convex\""),
        ("[[0,1,3],[1,2,3]]", "\"check\":\"copies\""),
        ("[[0,1,4],[2,1,4],[2,4,3],[3,4,9]]", "the index 9, but the scene has 5 points"),
        ("[[0,1,4],[2,1]]", "which is not a multiple of 3"),
    ] {
        let told = answer("c.json", text);
        assert_eq!((told.code, told.stdout.contains(check)), (100, true), "{text}: {}", told.stdout);
    }
    for (name, text, why) in [
        ("d.json", "[[0,1,1.5]]", "`1.5` is not a part of an array of whole numbers"),
        ("e.csv", "0,1,2\n0,x,2\n", "`x` is neither an index nor a label"),
        ("f.tif", "", "is read from OFF, OBJ, PLY, STL, GeoJSON, WKT, JSON or CSV"),
    ] {
        let told = answer(name, text);
        assert_eq!((told.code, told.stderr.contains(why)), (2, true), "{name}: {}", told.stderr);
    }
}

#[test]
fn a_rounded_solid_is_told_from_a_wrong_one() {
    let folder = tempdir().unwrap();
    let cube = |name: &str, low: f64, high: f64| {
        let path = at(&folder, name);
        let corner = |i: u8| {
            let along = |bit: u8| if i & bit == 0 { low } else { high };
            format!("{} {} {}\n", along(1), along(2), along(4))
        };
        let corners: String = (0..8).map(corner).collect();
        let faces = "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
        fs::write(&path, format!("OFF\n8 6 0\n{corners}{faces}")).unwrap();
        path
    };
    let (first, second) = (cube("first.off", 0.0, 2.0), cube("second.off", 1.0, 3.0));
    let judged = |file: &str| {
        let told = run(&["judge", "mesh-intersect", &first, &second, "--answer", &format!("intersection={file}")]);
        (told.code, told.stdout + &told.stderr)
    };
    let (code, told) = judged(&cube("right.off", 1.0, 2.0));
    assert_eq!(code, 0, "{told}");
    let (code, told) = judged(&cube("rounded.off", 1.0 - 1e-9, 2.0));
    assert!(code == 100 && told.contains(": rounded\n"), "{told}");
    let (code, told) = judged(&cube("wrong.off", 1.0, 2.5));
    assert!(code == 100 && told.contains(": wrong\n"), "{told}");
    let (code, told) = judged(&at(&folder, "nothing.off"));
    assert!(code == 2 && told.contains("nothing.off"), "{told}");
}

/// Points of GeoJSON are found by their coordinates: their order is free, each probe counts, and nothing else is taken.
#[test]
fn labels_of_points_are_read_in_any_order() {
    let folder = tempdir().unwrap();
    let map = at(&folder, "map.wkt");
    fs::write(&map, "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\n").unwrap();
    let probes = at(&folder, "probes.csv");
    fs::write(&probes, "x,y\n1,1\n9,9\n4,2\n").unwrap();
    let (asked, out) = (["polygon-locate", &map, &probes, "--set", "quick_stride=0"], at(&folder, "out"));
    let called = |command: &str, more: [&str; 2]| {
        let told = run(&[&[command], &asked[..], &more].concat());
        (told.code, told.stdout + &told.stderr)
    };
    assert_eq!(called("solve", ["--out", &out]).0, 0);
    let (code, told) = called("judge", ["--answer", &format!("{out}/probes.geojson")]);
    assert!(code == 0 && told.contains(": right"), "{told}");
    let point = |x: i32, y: i32, label: &str| {
        format!(
            r#"{{"type":"Feature","geometry":{{"type":"Point","coordinates":[{x},{y},0]}},"properties":{{{label}}}}}"#
        )
    };
    let judged = |points: &[String]| {
        let path = at(&folder, "found.geojson");
        fs::write(&path, format!(r#"{{"type":"FeatureCollection","features":[{}]}}"#, points.join(","))).unwrap();
        called("judge", ["--answer", &path])
    };
    let [border, inside, outside] =
        [point(4, 2, r#""label":-2"#), point(1, 1, r#""label":0"#), point(9, 9, r#""label":-1"#)];
    let (code, told) = judged(&[border.clone(), inside.clone(), outside.clone()]);
    assert!(code == 0 && told.contains(": right"), "{told}");
    for (points, code, why) in [
        (vec![border.clone(), inside.clone(), point(9, 9, r#""label":0"#)], 100, "label (topology)"),
        (vec![border.clone(), inside.clone()], 100, "`labels` has 2 labels for 3 probes"),
        (vec![border.clone(), inside.clone(), outside.clone(), point(2, 2, r#""label":0"#)], 2, "is not a probe"),
        (vec![border.clone(), inside.clone(), point(9, 9, r#""name":"sea""#)], 2, "`null` is not a part of"),
    ] {
        let (found, told) = judged(&points);
        assert!(found == code && told.contains(why), "{why}: {found}: {told}");
    }
}
