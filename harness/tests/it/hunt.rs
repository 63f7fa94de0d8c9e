//! `hunt`: finds, folders, budgets and refusals.

use std::fs;

use serde_json::Value;
use tempfile::tempdir;

use crate::common::{at, expect, run};

fn state(folder: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(format!("{folder}/hunt.json")).unwrap()).unwrap()
}

#[test]
fn what_is_hunted_is_shrunk_and_kept_as_a_suite_that_shows_it() {
    let folder = tempdir().unwrap();
    let [out, suite] = ["out", "mine.toml"].map(|name| at(&folder, name));
    let hunt = ["hunt", "orient2d", "-b", "naive", "--class", "sign_flip", "--from", "shapes", "--evaluations", "1500"];
    let told = expect(0, &[&hunt[..], &["--finds", "1", "--out", &out, "--into", &suite]].concat());
    assert!(told.stdout.starts_with("1. sign_flip (sign) after "), "{}", told.stdout);
    let mut table = csv::Reader::from_path(format!("{out}/hunt.csv")).unwrap();
    let heads = "find,task,class,check,backend,evaluations,seconds,pieces_before,pieces_after,scene_id";
    assert_eq!(table.headers().unwrap().iter().collect::<Vec<_>>().join(","), heads);
    let rows: Vec<_> = table.records().map(Result::unwrap).collect();
    assert_eq!((rows.len(), &rows[0][2], &rows[0][4]), (1, "sign_flip", "naive"));
    for end in ["rs", "cpp", "py", "mjs"] {
        assert!(fs::read_to_string(format!("{out}/find-1.{end}")).unwrap().contains("orient2d("), "{end}");
    }
    // Both suites show the finding again, and an exact backend does not.
    for file in [&format!("{out}/finds.toml"), &suite] {
        let again = at(&folder, "again");
        assert_eq!(run(&["run", file, "-b", "naive", "-q", "--out", &again]).code, 100);
        assert!(fs::read_to_string(format!("{again}/findings.csv")).unwrap().contains("sign_flip,sign,"));
        fs::remove_dir_all(again).unwrap();
    }
    expect(0, &["run", &suite, "-b", "exact", "-q", "--out", &at(&folder, "exact")]);
    // A resumed hunt finds nothing more, and the suite already has the find.
    let before = fs::read_to_string(&suite).unwrap();
    expect(0, &["hunt", "--resume", &out, "--into", &suite]);
    assert_eq!(fs::read_to_string(&suite).unwrap(), before);
}

/// A hunt in two parts, and the same hunt in one part on other threads.
#[test]
fn a_hunt_in_two_parts_is_the_same() {
    let folder = tempdir().unwrap();
    let [parts, whole] = ["parts", "whole"].map(|name| at(&folder, name));
    let hunt = ["hunt", "incircle", "-b", "shewchuk", "--from", "shapes", "--seed", "5", "--evaluations"];
    expect(0, &[&hunt[..], &["90", "--out", &parts, "--threads", "1"]].concat());
    assert!(state(&parts)["state"]["evaluations"].as_u64() < Some(200));
    expect(0, &["hunt", "--resume", &parts, "--evaluations", "260", "--threads", "2"]);
    expect(0, &[&hunt[..], &["260", "--out", &whole, "--threads", "1"]].concat());
    // The seconds are wall time, so they are not compared.
    let found = |folder: &str| {
        let mut state = state(folder)["state"].clone();
        let finds = state["finds"].as_array_mut().unwrap();
        finds.iter_mut().for_each(|find| find["seconds"] = Value::Null);
        state
    };
    assert_eq!(found(&parts), found(&whole));
    let suite = |folder: &str| fs::read_to_string(format!("{folder}/finds.toml")).unwrap();
    assert_eq!(suite(&parts), suite(&whole));
}

#[test]
fn what_cannot_be_hunted_is_refused_with_the_cure() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "out");
    for (args, told) in [
        (
            vec!["hunt", "orient5d", "-b", "exact"],
            "no task is called `orient5d`; did you mean `orient2d`? use one of compare",
        ),
        (vec!["hunt", "orient2d", "-b", "exakt"], "exakt"),
        (vec!["hunt", "orient2d"], "--backend"),
        (
            vec!["hunt", "incircle", "-b", "sos:per-mesh", "--from", "shapes", "--out", &out],
            "sos:per-mesh declines all initial scenes",
        ),
        (
            vec!["hunt", "contacts2d", "-b", "exact", "--from", "shapes", "--out", &out],
            "these suites have no small scene of contacts2d to start from; name others with --from",
        ),
        (vec!["hunt", "--resume", "nowhere"], "name the folder of a `hunt` that was begun"),
        (vec!["hunt", "orient2d", "-b", "exact", "--class", "wrong"], "wrong"),
        (vec!["hunt", "orient2d", "-b", "sos", "--class", "tie_broken"], "findings do not have this class"),
        (vec!["hunt", "orient2d", "-b", "naive,exact", "--not-by", "naive"], "-b names it, too"),
        (vec!["hunt", "orient2d", "-b", "naive", "--finds", "0"], "--finds"),
        (vec!["hunt", "orient2d", "-b", "epsilon", "--not-by", "epsilon:1e-10"], "-b names it, too"),
    ] {
        let refused = expect(2, &args);
        assert!(refused.stderr.contains(told), "{args:?}: {}", refused.stderr);
    }
}

#[test]
fn a_backend_is_hunted_by_its_short_name() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "out");
    expect(0, &["hunt", "orient2d", "-b", "epsilon", "--from", "shapes", "--evaluations", "50", "--out", &out]);
    assert_eq!(state(&out)["order"]["shown_by"], serde_json::json!(["epsilon:1e-10"]));
    expect(0, &["hunt", "--resume", &out, "--evaluations", "100"]);
}

/// Errors in `hunt.json` name it, because the scenes in it have no file of their own.
#[test]
fn a_changed_hunt_is_refused_with_the_name_of_its_file() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "out");
    expect(0, &["hunt", "orient2d", "-b", "naive", "--from", "shapes", "--evaluations", "300", "--out", &out]);
    let file = format!("{out}/hunt.json");
    let text = fs::read_to_string(&file).unwrap();
    let whole: Value = serde_json::from_str(&text).unwrap();
    let refused = |spoil: &dyn Fn(&mut Value), why: &str| {
        let mut spoiled = whole.clone();
        spoil(&mut spoiled);
        fs::write(&file, spoiled.to_string()).unwrap();
        let told = expect(2, &["hunt", "--resume", &out, "--evaluations", "400"]).stderr;
        let named = told.starts_with(&format!("predicament: {file}: ")) && told.contains(why);
        assert!(named && told.lines().count() == 1, "{why}: {told}");
    };
    let cut = |text: &mut Value| *text = text.as_str().unwrap().replacen("[[", "[[,", 2).into();
    assert!(!whole["state"]["finds"].as_array().unwrap().is_empty());
    refused(&|hunt| cut(&mut hunt["state"]["finds"][0]["shrunk"]), "find 1: line ");
    refused(&|hunt| cut(&mut hunt["state"]["islands"][0]["members"][0]["scene"]), " of the scene: ");
    refused(&|hunt| drop(hunt["state"]["islands"].as_array_mut().unwrap().pop()), "islands where the task has");
    refused(&|hunt| hunt["state"]["finds"][0]["class"] = "flip".into(), "no class is called `flip`");
    refused(&|hunt| hunt["order"]["class"] = "flip".into(), "no class is called `flip`");
    refused(&|hunt| hunt["order"]["task"] = "orient5d".into(), "there is no task `orient5d`");
    refused(&|hunt| hunt["order"]["shown_by"][0] = "naife".into(), "no backend is called `naife`");
    refused(&|hunt| hunt["order"]["limit"] = (-1.0).into(), "`limit` is not a time limit");
    refused(&|hunt| hunt["order"]["suites"] = ["no-such-suite"].into(), "no-such-suite");
    fs::write(&file, text).unwrap();
    expect(0, &["hunt", "--resume", &out, "--evaluations", "400"]);
}

/// Maps and meshes are read when they are run, and have hundreds of probes.
#[test]
fn maps_and_meshes_are_hunted() {
    let folder = tempdir().unwrap();
    for task in ["polygon-locate", "mesh-locate", "mesh-intersect"] {
        let [suite, out] = ["toml", "out"].map(|end| at(&folder, &format!("{task}.{end}")));
        expect(0, &["corpus", "new", &suite, "--task", task]);
        let hunt =
            ["hunt", task, "-b", "naive", "--from", &suite, "--finds", "1", "--evaluations", "600", "--out", &out];
        let told = expect(0, &hunt);
        assert!(told.stdout.starts_with("1. "), "{task}: {}{}", told.stdout, told.stderr);
        let again = at(&folder, &format!("again-{task}"));
        let finds = format!("{out}/finds.toml");
        assert_eq!(run(&["run", &finds, "-b", "naive", "-q", "--out", &again]).code, 100, "{task}");
    }
}

/// Cubes are rows of four numbers, which have no shear mutation.
#[test]
fn unions_of_cubes_are_hunted() {
    let folder = tempdir().unwrap();
    for seed in ["1", "2"] {
        let out = at(&folder, seed);
        let told =
            expect(0, &["hunt", "cube-union", "-b", "exact", "--evaluations", "200", "--seed", seed, "--out", &out]);
        assert!(told.stdout.contains("done") || told.stderr.contains("done"), "{} {}", told.stdout, told.stderr);
    }
    // Two findings in one scene are two finds and one scene of the suite.
    let [out, suite] = ["finds", "mine.toml"].map(|name| at(&folder, name));
    let hunt = ["hunt", "cube-union", "-b", "epsilon:1e-10", "--seed", "11", "--evaluations", "100", "--out", &out];
    expect(0, &[&hunt[..], &["--into", &suite]].concat());
    let text = fs::read_to_string(format!("{out}/finds.toml")).unwrap();
    let rows = fs::read_to_string(format!("{out}/hunt.csv")).unwrap().lines().count() - 1;
    assert!(text.matches("[[scene]]").count() < rows && text.contains(" as well"), "{rows} finds: {text}");
    for file in [&format!("{out}/finds.toml"), &suite] {
        expect(0, &["corpus", "verify", file]);
    }
}
