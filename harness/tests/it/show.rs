//! `show`: scenes, answers and findings as pictures and as data; `map`: one vertex of a query moves.

use std::collections::BTreeMap;

use serde_json::Value;
use tempfile::tempdir;

use crate::common::{at, column, expect, read, run, write};

/// A few scenes of each task from the embedded suites.
fn scenes() -> BTreeMap<String, Vec<[String; 2]>> {
    let listed = expect(0, &["corpus", "list", "--scenes", "--format", "json"]).stdout;
    let mut scenes: BTreeMap<String, Vec<[String; 2]>> = BTreeMap::new();
    for suite in listed.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()) {
        for scene in suite["scenes"].as_array().unwrap() {
            let word = |of: &Value| of.as_str().unwrap_or_default().to_owned();
            let name = suite.get("suite").or(suite.get("name")).map(word).unwrap();
            let of_task = scenes.entry(word(&scene["task"])).or_default();
            if suite["needs_fetch"] != Value::Bool(true) {
                of_task.push([name, word(&scene["name"])]);
            }
        }
    }
    // Take the middle scene and the last.
    for of_task in scenes.values_mut() {
        *of_task = [of_task.len() / 2, of_task.len() - 1].map(|at| of_task[at].clone()).into();
    }
    scenes
}

/// The layers of a drawing, with the number of their parts.
fn layers(json: &str) -> Vec<(String, u64)> {
    let drawing: Value = serde_json::from_str(json).unwrap();
    let layer = |layer: &Value| (layer["name"].as_str().unwrap().to_owned(), layer["parts"].as_u64().unwrap());
    drawing["layers"].as_array().unwrap().iter().map(layer).collect()
}

#[test]
fn every_task_draws_its_scenes_and_answers() {
    let folder = tempdir().unwrap();
    let scenes = scenes();
    assert!(scenes.len() >= 20, "{scenes:?}");
    for (task, scenes) in scenes {
        let mut differ = false;
        for [suite, scene] in &scenes {
            let filter = format!("^{}$", format!("{suite}/{scene}").replace('.', "\\."));
            let show = |backend: &[&str], file: &str| {
                let out = at(&folder, file);
                let words = ["show", suite, "-f", &filter, "--out", &out];
                expect(0, &[&words[..], backend].concat());
                std::fs::read_to_string(out).unwrap()
            };
            // A task that accepts no broken ties is answered by a backend without them.
            let solved = |backend: &&str| {
                run(&["solve", suite, "-f", &filter, "-b", backend, "--out", &at(&folder, "solved")]).code == 0
            };
            let backend = ["exact", "sos:per-mesh"].into_iter().find(solved).expect("a backend");
            let (given, found) = (layers(&show(&[], "given.json")), layers(&show(&["-b", backend], "found.json")));
            assert!(given.iter().any(|(_, parts)| *parts > 0), "{task}: {given:?}");
            differ |= given != found;
            if !differ {
                continue;
            }
            assert!(show(&["-b", backend], "found.svg").contains("</svg>"), "{task}");
            break;
        }
        // Tasks with only signs or numbers as answers have no drawing of their own.
        let is_formula = scenes.iter().all(|[suite, _]| suite == "formulas" || suite == "sphere");
        let has_shape = !is_formula
            && !["compare", "orient2d", "orient3d", "incircle", "insphere", "interval", "cube-union"]
                .contains(&task.as_str());
        assert_eq!(differ, has_shape, "{task}: {scenes:?}");
    }
}

const TRIANGLE: &str =
    "title = \"Mine\"\n[[scene]]\nname = \"hull\"\ntask = \"hull2d\"\npoints = [[0, 0], [8, 0], [0, 8], [1, 1]]\n";

/// The coordinates are those of the suite: the centre of the box is (4, 4), half of its side is 4.
#[test]
fn places_are_where_the_scene_says() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", TRIANGLE);
    let out = at(&folder, "hull.json");
    expect(0, &["draw", "scene", &suite, "-f", "hull", "-b", "exact", "--out", &out]);
    let drawing: Value = serde_json::from_str(&std::fs::read_to_string(&out).unwrap()).unwrap();
    let hull = &drawing["layers"][0];
    assert_eq!((hull["name"].as_str(), hull["lengths"].as_array().map(Vec::len)), (Some("hull"), Some(1)));
    let million = 1_000_000;
    let corners = serde_json::json!([-million, -million, 0, million, -million, 0, -million, million, 0]);
    assert_eq!(
        (&hull["points"], &hull["at"], &drawing["unit"]),
        (&corners, &serde_json::json!([0, 1, 2]), &serde_json::json!(4.0))
    );

    // With vertex 3 as the centre, points nearer than 2 are drawn.
    let svg = at(&folder, "near.svg");
    expect(0, &["draw", "scene", &suite, "-f", "hull", "--around", "3", "--radius", "2", "--out", &svg]);
    let svg = std::fs::read_to_string(svg).unwrap();
    assert!(svg.contains("<circle cx=\"380.0\""), "{svg}");
    // A page with a view is self-contained.
    let page = at(&folder, "hull.html");
    expect(0, &["draw", "scene", &suite, "-f", "hull", "-b", "exact", "--out", &page]);
    let page = std::fs::read_to_string(page).unwrap();
    assert!(page.contains("predicamentView(JSON.parse") && !page.contains("src=\"http"));
}

#[test]
fn what_cannot_be_shown_says_why() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", TRIANGLE);
    let out = at(&folder, "x.svg");
    let told = |words: &[&str]| expect(2, &[&["draw", "scene", &suite, "-f", "hull"], words].concat()).stderr;
    assert!(told(&["--out", "x.gif"]).contains(".svg, .html or .json"));
    assert!(told(&["--out", &out, "--layer", "hulls"]).contains("the drawing has hull, points"));
    assert!(told(&["--out", &out, "--around", "4"]).contains("no such vertex"));
    assert!(told(&["--out", &out, "--radius", "1"]).contains("--around"));
    assert!(told(&["--out", &out, "--look", "1"]).contains("30,25"));
    assert!(!std::path::Path::new(&out).exists());
}

#[test]
fn a_finding_is_shown_with_its_vertices_and_walks() {
    let folder = tempdir().unwrap();
    let points = "title = \"Mine\"\n[[scene]]\nname = \"near\"\ntask = \"orient2d\"\nqueries = [[0, 1, 2]]\n\
                  points = [[12, 12], [24, 24], [\"0x1.000000000000ep-1\", \"0x1.0000000000007p-1\"]]\n";
    let suite = write(&folder, "mine.toml", points);
    let run = at(&folder, "run");
    expect(0, &["run", &suite, "-b", "exact", "--out", &run]);
    crate::common::run(&["run", &suite, "-b", "naive", "--out", &at(&folder, "naive")]);
    let naive = at(&folder, "naive");
    let id = column(&read(&naive, "findings.csv"), "finding_id").first().cloned().expect("naive is wrong here");
    let out = at(&folder, "finding.json");
    expect(0, &["draw", "scene", "--finding", &id, "--run", &naive, "--out", &out]);
    assert!(layers(&std::fs::read_to_string(&out).unwrap()).contains(&("query".to_owned(), 3)));
    let out = at(&folder, "walk.svg");
    let told = expect(
        0,
        &["draw", "map", "--finding", &id, "--run", &naive, "-b", "naive,exact", "--side", "32", "--out", &out],
    );
    let lines: Vec<&str> = told.stdout.lines().collect();
    assert!(
        lines[1].starts_with("exact") && lines[1].ends_with("0 wrong") && !lines[0].ends_with(" 0 wrong"),
        "{lines:?}"
    );
    assert_eq!(std::fs::read_to_string(&out).unwrap().matches("<image").count(), 6);
    // The page has the same picture, and the orders of the vertices.
    let pages = at(&folder, "pages");
    expect(0, &["report", &naive, "--out", &pages]);
    let told = expect(0, &["replay", &id, "--run", &naive]).stdout;
    assert!(told.contains("exact sign"), "{told}");
}

/// The moving point gives the family of pictures of Kettner, Mehlhorn, Pion, Schirra and Yap.
#[test]
fn a_walk_is_the_picture_of_the_paper() {
    let folder = tempdir().unwrap();
    let step = "1.1102230246251565e-16";
    // The middle of the family's square of 256 doubles from 0.5.
    let points = "title = \"Mine\"\n[[scene]]\nname = \"middle\"\ntask = \"orient2d\"\nqueries = [[0, 1, 2]]\n\
                  points = [[\"0x1.0000000000080p-1\", \"0x1.0000000000080p-1\"], [12, 12], [24, 24]]\n";
    let suite = write(&folder, "mine.toml", points);
    let [whole, walk] = ["whole.png", "walk.png"].map(|name| at(&folder, name));
    let backends = ["-b", "naive,naive:first,exact,shewchuk"];
    expect(0, &[&["draw", "map", "kettner-pixels-a", "--out", &whole], &backends[..]].concat());
    let query = ["--query", "orient2d(xy; 0 1 2)", "--move", "0", "--side", "256"];
    for step in [step, "1ulp"] {
        let words = ["map", "middle", "--suite", &suite, "--step", step, "--out", &walk];
        expect(0, &[&words[..], &query, &backends].concat());
        assert!(std::fs::read(&whole).unwrap() == std::fs::read(&walk).unwrap(), "{step}");
    }
}
