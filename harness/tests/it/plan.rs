//! A plan of work: its parts, their balance, and refusals.

use std::collections::BTreeMap;
use std::path::Path;

use sha2::{Digest, Sha256};
use tempfile::{TempDir, tempdir};

use crate::common::{at, column, expect, read, run, unsealed, write};
use crate::merge::files;

const PARTS: u32 = 7;
const BACKENDS: [&str; 2] = ["-b", "exact,naive"];

/// A suite of three scenes; `x` changes one of them.
fn suite(folder: &TempDir, x: u32) -> String {
    let scene = |name: &str, x: u32| {
        format!("[[scene]]\nname = \"{name}\"\ntask = \"orient2d\"\npoints = [[0, 0], [{x}, 1], [3, 8]]\n")
    };
    let text = format!("title = \"Mine\"\n{}{}{}", scene("a", x), scene("b", 4), scene("c", 5));
    write(folder, "mine.toml", &text)
}

/// Makes a plan with an empty file of expectations; returns the output.
fn plan(folder: &TempDir, words: &[&str], parts: u32, out: &str) -> String {
    let (parts, none) = (parts.to_string(), none(folder));
    expect(
        0,
        &[&["shard", "plan"][..], words, &BACKENDS, &["--expected", &none, "--shards", &parts, "--out", out]].concat(),
    )
    .stdout
}

/// An empty file of expectations; reading the shipped ones takes longer than most of these runs.
fn none(folder: &TempDir) -> String {
    write(folder, "none.toml", "")
}

/// Runs, with findings or without; returns the folder.
fn go(folder: &TempDir, name: &str, words: &[&str]) -> String {
    let out = at(folder, name);
    let none = none(folder);
    let words = [&["run", "-q", "--out", &out, "--expected", &none][..], words].concat();
    assert!([0, 100].contains(&run(&words).code), "{words:?}");
    out
}

/// Runs a part of a plan into a folder.
fn part(folder: &TempDir, plan: &str, k: u32, n: u32) -> String {
    go(folder, &format!("part{k}-of-{n}"), &["--plan", plan, "--shard", &format!("{k}/{n}")])
}

fn assert_same(one: &str, other: &str) {
    let (one, other) = (files(Path::new(one)), files(Path::new(other)));
    let differ: Vec<&String> = one.symmetric_difference(&other).map(|(name, _)| name).collect();
    assert!(differ.is_empty() && !one.is_empty(), "{differ:?}");
}

/// The work of each part of a plan, in microseconds.
fn loads(plan: &str) -> BTreeMap<u64, u64> {
    let plan: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(plan).unwrap()).unwrap();
    let mut loads: BTreeMap<u64, u64> = BTreeMap::new();
    for share in plan["shares"].as_array().unwrap() {
        *loads.entry(share["part"].as_u64().unwrap()).or_default() += share["cost_us"].as_u64().unwrap();
    }
    loads
}

#[test]
fn parts_by_a_plan_are_the_whole_with_costs_and_without() {
    let folder = tempdir().unwrap();
    let suites = ["lecture"];
    let whole = go(&folder, "whole", &[&suites[..], &BACKENDS].concat());
    let by_id = at(&folder, "by-id.json");
    let told = plan(&folder, &suites, PARTS, &by_id);
    assert!(told.contains("unknown") && told.contains("7/7 "), "{told}");
    // Without costs, a plan has the same parts as `--shard`.
    let alone = go(&folder, "alone", &[&["--shard", "3/7"][..], &suites, &BACKENDS].concat());
    let planned = part(&folder, &by_id, 3, PARTS);
    assert_eq!(read(&alone, "summary.csv"), read(&planned, "summary.csv"));

    let weighed = at(&folder, "weighed.json");
    let told = plan(&folder, &[&suites[..], &["--costs", &whole]].concat(), PARTS, &weighed);
    let scenes = column(&read(&whole, "precision.csv"), "scene").len();
    assert!(told.contains(&format!("costs of {scenes} scenes measured, of 0 estimated")), "{told}");
    let again = at(&folder, "again.json");
    plan(&folder, &[&suites[..], &["--costs", &whole]].concat(), PARTS, &again);
    assert_eq!(std::fs::read(&weighed).unwrap(), std::fs::read(&again).unwrap(), "nothing but what it is made of");
    let loads = loads(&weighed);
    assert_eq!(loads.len(), PARTS as usize, "no part is idle: {loads:?}");

    let parts: Vec<String> = (1..=PARTS)
        .map(|k| go(&folder, &format!("weighed{k}"), &["--plan", &weighed, "--shard", &format!("{k}/{PARTS}")]))
        .collect();
    let merged = at(&folder, "merged");
    let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
    assert_eq!(run(&[&["shard", "merge", "--out", &merged][..], &parts].concat()).code, 100, "naive is wrong here");
    assert_same(&whole, &merged);
    let hash = |file: &str| -> String {
        let json: serde_json::Value = serde_json::from_str(file).unwrap();
        json["hash"].as_str().or(json["plan"].as_str()).unwrap().to_owned()
    };
    assert_eq!(hash(&read(&merged, "env.json")), hash(&std::fs::read_to_string(&weighed).unwrap()));
    // A merged run has costs to plan with, like a single run.
    let counted = |folder: &str| column(&read(folder, "costs.csv"), "scene").len();
    assert_eq!(counted(&merged), counted(&whole));
    plan(&folder, &[&suites[..], &["--costs", &merged]].concat(), 2, &at(&folder, "next.json"));
    // The same parts, except that one is from another plan.
    let told =
        expect(2, &[&["shard", "merge", "--out", &at(&folder, "mixed"), &planned][..], &parts[1..]].concat()).stderr;
    assert!(told.contains("made by the plan"), "{told}");
    // A part that claims a scene of another part, and a merge without the last part.
    let places = |part: &str| -> serde_json::Value {
        let plan: serde_json::Value = serde_json::from_str(&read(part, "plan.json")).unwrap();
        plan["whole"]["places"].clone()
    };
    let file = Path::new(parts[1]).join("plan.json");
    let text = read(parts[1], "plan.json");
    let mut claims: serde_json::Value = serde_json::from_str(&text).unwrap();
    claims["whole"]["places"][0] = places(parts[0])[0].clone();
    claims.as_object_mut().unwrap().remove("seal");
    std::fs::write(&file, claims.to_string()).unwrap();
    let out = at(&folder, "doubled");
    let told = expect(2, &[&["shard", "merge", "--out", &out][..], &parts].concat()).stderr;
    assert!(told.contains("plan.json: its content differs from what the run wrote"), "{told}");
    // The part is refused even if its digest is forged.
    let state = unsealed(parts[1], "state.json");
    let forged = {
        let mut state: serde_json::Value = serde_json::from_str(&state).unwrap();
        let digest = Sha256::digest(claims.to_string());
        state["digests"]["plan.json"] = digest.iter().map(|byte| format!("{byte:02x}")).collect::<String>().into();
        state.to_string()
    };
    std::fs::write(Path::new(parts[1]).join("state.json"), forged).unwrap();
    let told = expect(2, &[&["shard", "merge", "--out", &out][..], &parts].concat()).stderr;
    assert!(told.contains("of the whole is also in another part"), "{told}");
    std::fs::write(&file, text).unwrap();
    std::fs::write(Path::new(parts[1]).join("state.json"), state).unwrap();
    let told = expect(103, &[&["shard", "merge", "--out", &out][..], &parts[..6]].concat()).stderr;
    assert!(told.contains("these are missing: 7/7") && !Path::new(&out).exists(), "{told}");
    // The whole plan on one machine.
    let at_once = go(&folder, "at-once", &["--plan", &weighed]);
    assert_same(&whole, &at_once);
}

#[test]
fn a_plan_that_does_not_fit_is_refused() {
    let folder = tempdir().unwrap();
    let (mine, file, out) = (suite(&folder, 2), at(&folder, "plan.json"), at(&folder, "out"));
    let none = none(&folder);
    plan(&folder, &[&mine], 3, &file);
    let refused = |plan: &str, shard: &str, why: &str| {
        let told = expect(2, &["run", "--plan", plan, "--expected", &none, "--shard", shard, "--out", &out]).stderr;
        assert!(told.contains(why) && !Path::new(&out).exists(), "{told}");
    };
    refused(&file, "1/4", "the plan has 3 parts and not 4; write --shard k/3");
    // Each change is one byte.
    let text = std::fs::read_to_string(&file).unwrap();
    let part = text.find("\"part\": 1").or(text.find("\"part\": 3")).unwrap() + "\"part\": ".len();
    let hash = text.find("\"hash\": \"").unwrap() + "\"hash\": \"".len();
    for (at_byte, by) in [(part, "2"), (hash, if text.as_bytes()[hash] == b'0' { "1" } else { "0" }), (1, " ")] {
        let mut changed = text.clone();
        changed.replace_range(at_byte..=at_byte, by);
        assert_ne!(changed, text);
        refused(&write(&folder, "changed.json", &changed), "1/3", "changed.json");
    }
    refused(&write(&folder, "no.json", "{}"), "1/3", "it is not a work plan");
    // Rows would be inconsistent if parts used different expectations.
    let other = write(&folder, "other.toml", "# none");
    let told = expect(2, &["run", "--plan", &file, "--expected", &other, "--shard", "1/3", "--out", &out]).stderr;
    assert!(told.contains("it was made for other expectations"), "{told}");
    expect(2, &["shard", "plan", &mine, "--out", &file]);

    // One scene has changed: its part reports that, and the other parts report that the file has changed.
    suite(&folder, 7);
    let told: Vec<String> = (1..=3)
        .map(|k| {
            expect(2, &["run", "--plan", &file, "--expected", &none, "--shard", &format!("{k}/3"), "--out", &out])
                .stderr
        })
        .collect();
    let count = |what: &str| told.iter().filter(|told| told.contains(what)).count();
    assert_eq!(count(&format!("scene mine/a of {mine} has changed since the plan was made")), 1, "{told:?}");
    assert_eq!(count("the suite `mine` of "), 2, "{told:?}");
}

#[test]
fn a_part_of_a_plan_is_resumed_as_it_was_planned() {
    let folder = tempdir().unwrap();
    let (mine, file) = (suite(&folder, 2), at(&folder, "plan.json"));
    let costs = go(&folder, "costs", &[&[&*mine][..], &BACKENDS].concat());
    plan(&folder, &[&mine, "--costs", &costs], 2, &file);
    let out = part(&folder, &file, 2, 2);
    let before = files(Path::new(&out));
    // Make a run that was killed before its first scene.
    let mut state: serde_json::Value = serde_json::from_str(&unsealed(&out, "state.json")).unwrap();
    state["outcome"] = "unfinished".into();
    state["digests"] = serde_json::json!({});
    let tables: Vec<String> = state["committed"].as_object().unwrap().keys().cloned().collect();
    for table in tables {
        state["committed"][&table] = (read(&out, &table).find('\n').unwrap() + 1).into();
    }
    std::fs::write(Path::new(&out).join("state.json"), state.to_string()).unwrap();
    let told = expect(2, &["run", "--resume", &out, "--expected", &write(&folder, "other.toml", "# none")]).stderr;
    assert!(told.contains("begun with other expectations"), "{told}");
    expect(0, &["run", "-q", "--resume", &out, "--expected", &none(&folder)]);
    assert_eq!(before, files(Path::new(&out)));
    // A scene measured twice counts once.
    let told = plan(&folder, &[&mine, "--costs", &out], 1, &at(&folder, "again.json"));
    assert!(told.contains(" of 0 unknown"), "{told}");
}

#[test]
fn costs_that_are_not_there_are_an_error() {
    let folder = tempdir().unwrap();
    let told = expect(2, &["shard", "plan", "ties", "--costs", &at(&folder, "nowhere")]).stderr;
    assert!(told.contains("costs.csv is missing: the folder is"), "{told}");
    let out = go(&folder, "run", &["lecture", "-f", "ear", "-b", "exact"]);
    let costs = read(&out, "costs.csv");
    assert_eq!(column(&costs, "backend"), ["exact", "truth"].repeat(column(&costs, "scene").len() / 2));
    std::fs::write(Path::new(&out).join("costs.csv"), costs.replace(",exact,", ",exact,many")).unwrap();
    let told = expect(2, &["shard", "plan", "lecture", "--costs", &out]).stderr;
    assert!(told.contains("costs.csv:2: it is not a row of costs"), "{told}");
}
