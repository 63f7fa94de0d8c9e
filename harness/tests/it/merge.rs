//! Merging parts of a run, and the refusals of merge.

use std::collections::BTreeSet;
use std::path::Path;

use tempfile::{TempDir, tempdir};

use crate::common::{at, expect, run, unsealed};

const PARTS: u32 = 7;
/// Suites with many kinds of tables. The filter below selects small scenes, because a merge does not depend on the size
/// of scenes.
const MANY: &[&str] = &["classics", "tilings", "cubes", "ties"];
const SMALL: &str =
    "^(classics/kettner-[ab]|tilings/crossing|cubes/(co|one|twins|off|slide)|ties/(grid-4x4|coincident)|mine/)";
/// A map of 64 pixels, which has a file besides the tables.
const MAP: &str = "title = \"Mine\"\n[[generate]]\nfamily = \"pixel-map\"\nname = \"neighbours\"\ntask = \"orient2d\"\n\
                   p = [0.5, 0.5]\nq = [12, 12]\nr = [24, 24]\nside = 8\n";
/// Two fast suites.
const QUICK: &[&str] = &["ties", "lecture"];

/// Runs one part, or everything; returns the folder.
fn of(folder: &TempDir, suites: &[&str], name: &str, shard: Option<u32>, more: &[&str]) -> String {
    let out = at(folder, name);
    let part = shard.map(|k| format!("{k}/{PARTS}"));
    let shard: Vec<&str> = part.iter().flat_map(|part| ["--shard", part]).collect();
    let words = [&["run"][..], suites, &["-b", "exact,sos,naive", "-q", "--out", &out], &shard, more].concat();
    assert!([0, 100].contains(&run(&words).code), "{words:?}");
    out
}

/// Makes all parts in parallel, because most of the time is spent waiting for the disk.
fn parts_of(folder: &TempDir, suites: &[&str], more: &[&str]) -> Vec<String> {
    std::thread::scope(|scope| {
        let part = |k| scope.spawn(move || of(folder, suites, &format!("part{k}"), Some(k), more));
        let parts: Vec<_> = (1..=PARTS).map(part).collect();
        parts.into_iter().map(|part| part.join().unwrap()).collect()
    })
}

fn merge(parts: &[String], out: &str, code: i32) -> String {
    let words: Vec<&str> =
        ["merge"].into_iter().chain(parts.iter().map(String::as_str)).chain(["--out", out]).collect();
    let done = expect(code, &words);
    format!("{}{}", done.stdout, done.stderr)
}

/// All files of a folder, except those with the machine or the times.
pub fn files(folder: &Path) -> BTreeSet<(String, Vec<u8>)> {
    let mut all = BTreeSet::new();
    let mut left = vec![folder.to_owned()];
    while let Some(here) = left.pop() {
        for entry in std::fs::read_dir(here).unwrap().map(|entry| entry.unwrap().path()) {
            if entry.is_dir() {
                left.push(entry);
            } else if entry.file_name().is_some_and(|name| name != "env.json" && name != "costs.csv") {
                let name = entry.strip_prefix(folder).unwrap().display().to_string();
                all.insert((name, std::fs::read(&entry).unwrap()));
            }
        }
    }
    all
}

#[test]
fn seven_parts_are_byte_for_byte_the_whole_run() {
    let folder = tempdir().unwrap();
    let mine = crate::common::write(&folder, "mine.toml", MAP);
    let suites = [MANY, &[&mine]].concat();
    let more: &[&str] = if predicament_effort::whole() { &["--answers"] } else { &["--answers", "-f", SMALL] };
    let whole = of(&folder, &suites, "whole", None, more);
    let mut parts = parts_of(&folder, &suites, more);
    parts.reverse();
    let out = at(&folder, "merged");
    // There are no expectations for the suite that is not embedded.
    let told = merge(&parts, &out, 100);
    let rows = std::fs::read_to_string(Path::new(&whole).join("summary.csv")).unwrap().lines().count() - 1;
    assert!(
        rows > 60 && told.contains("7 parts, ") && told.contains(&format!(", {rows} rows, 1 unexpected")),
        "{told}"
    );
    let (merged, expected) = (files(Path::new(&out)), files(Path::new(&whole)));
    let names = |files: &BTreeSet<(String, Vec<u8>)>| files.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&merged), names(&expected));
    assert!(
        names(&merged).iter().any(|name| name == "answers.csv")
            && names(&merged).iter().any(|name| name.starts_with("maps"))
    );
    for (ours, theirs) in merged.iter().zip(&expected) {
        assert!(ours == theirs, "{} differs", ours.0);
    }
    let env = std::fs::read_to_string(Path::new(&out).join("env.json")).unwrap();
    assert!(env.contains("7/7 on "), "the machines are named: {env}");
    // The merged folder is a run like any other.
    expect(100, &["gate", &out]);
    expect(0, &["report", &out, "--out", &at(&folder, "pages")]);
    assert!(merge(&parts, &out, 2).contains("the folder is not empty"), "a merge overwrites nothing");
}

#[test]
fn what_does_not_fit_is_named_and_nothing_is_written() {
    let folder = tempdir().unwrap();
    let parts = parts_of(&folder, QUICK, &[]);
    let out = at(&folder, "merged");
    let with = |at: usize, other: &str| {
        let mut parts = parts.clone();
        parts[at] = other.to_owned();
        parts
    };
    let told = merge(&parts[1..6], &out, 103);
    assert!(told.contains("of the 7 parts, these are missing: 1/7, 7/7"), "{told}");
    let again = of(&folder, QUICK, "again", Some(3), &[]);
    let told = merge(&with(4, &again), &out, 2);
    assert!(told.contains("part 3/7 is") && told.contains("part3 already"), "{told}");
    let whole = of(&folder, QUICK, "whole", None, &[]);
    assert!(merge(&with(2, &whole), &out, 2).contains("it is a whole run, not a part"));
    let filtered = of(&folder, QUICK, "filtered", Some(3), &["-f", "ties/"]);
    assert!(merge(&with(2, &filtered), &out, 2).contains("other scenes, or scenes with other contents"));
    let full = of(&folder, QUICK, "full", Some(3), &["--level", "full", "-f", "lecture/ear"]);
    assert!(merge(&with(2, &full), &out, 2).contains("level full and not quick"));
    let answers = of(&folder, QUICK, "answers", Some(3), &["--answers"]);
    assert!(merge(&with(2, &answers), &out, 2).contains("other settings (plan.json)"));

    // A part that was killed and a part with changed bytes are refused, with the reason.
    let state = Path::new(&again).join("state.json");
    let text = unsealed(&again, "state.json");
    std::fs::write(&state, text.replace("\"complete\"", "\"unfinished\"")).unwrap();
    assert!(merge(&with(2, &again), &out, 103).contains("part 3/7 is not complete; `run --resume` completes it"));
    std::fs::write(&state, text.replace("\"complete\"", "\"timeout\"")).unwrap();
    let told = merge(&with(2, &again), &out, 103);
    assert!(
        told.contains("part 3/7 ran out of time; run it again in another folder, with a longer --timeout"),
        "{told}"
    );
    std::fs::write(&state, &text).unwrap();
    let env = Path::new(&again).join("env.json");
    let machine = unsealed(&again, "env.json");
    std::fs::write(&env, machine.replace("\"peers\": {", "\"peers\": {\n\"engine:mine\": \"2\",")).unwrap();
    let told = merge(&with(2, &again), &out, 2);
    assert!(told.contains("a version differs from") && told.contains("engine:mine is `2` and not unknown"), "{told}");
    std::fs::write(&env, machine).unwrap();
    let segments = Path::new(&again).join("segments.csv");
    let rows = std::fs::read_to_string(&segments).unwrap();
    std::fs::write(&segments, rows.replacen("exact", "exsct", 1)).unwrap();
    assert!(merge(&with(2, &again), &out, 2).contains("segments.csv"));
    assert!(!Path::new(&out).exists(), "nothing was written");

    // A part that was ended before it began is incomplete; a part that lost its state is not.
    std::fs::remove_file(&state).unwrap();
    let lost = merge(&with(2, &again), &out, 2);
    assert!(
        lost.contains("state.json: there is no such file, and costs.csv has rows; restore it from a copy"),
        "{lost}"
    );
    expect(2, &["gate", &again]);
    for file in std::fs::read_dir(&again).unwrap().map(|entry| entry.unwrap().path()) {
        if !file.ends_with("plan.json") {
            if file.is_dir() { std::fs::remove_dir_all(file).unwrap() } else { std::fs::remove_file(file).unwrap() }
        }
    }
    for parts in [with(2, &again), with(0, &again)] {
        let told = merge(&parts, &out, 103);
        assert!(told.contains("the run ended before its first result; `run --resume` starts it"), "{told}");
    }
    expect(103, &["gate", &again]);
    expect(103, &["gate", &parts[0], "--baseline", &again]);
    expect(0, &["run", "--resume", &again]);
    merge(&with(2, &again), &out, 0);
}

/// The path of a suite's file comes from the first part, whatever the order of the folders; a symlink may be the output
/// folder.
#[test]
fn the_order_of_the_folders_changes_nothing() {
    let folder = tempdir().unwrap();
    let suite = crate::common::write(&folder, "mine.toml", crate::common::SUITE);
    std::fs::create_dir(at(&folder, "sub")).unwrap();
    let names = [at(&folder, "sub/../mine.toml"), suite];
    let part = |k: usize| {
        let out = at(&folder, &format!("part{k}"));
        let shard = format!("{k}/2");
        let told = run(&["run", &names[k - 1], "-b", "exact", "-q", "--shard", &shard, "--out", &out]);
        assert!([0, 4].contains(&told.code), "{}", told.stderr);
        out
    };
    let (one, two) = (part(1), part(2));
    let [forth, back] = ["forth", "back"].map(|name| at(&folder, name));
    merge(&[one.clone(), two.clone()], &forth, 0);
    std::fs::create_dir(at(&folder, "empty")).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink(at(&folder, "empty"), &back).unwrap();
    merge(&[two, one], &back, 0);
    assert_eq!(files(Path::new(&forth)), files(Path::new(&back)));
}

/// A part that was stopped and resumed is the same as one that was not.
#[test]
fn a_resumed_part_is_merged_like_any_other() {
    let folder = tempdir().unwrap();
    let part = of(&folder, QUICK, "part1", Some(1), &[]);
    let cut = of(&folder, QUICK, "cut", Some(1), &[]);
    // Truncate the tables as the segments say, as after the first scenes, with a half-written row at the end.
    let cut_path = Path::new(&cut);
    let segments = std::fs::read_to_string(cut_path.join("segments.csv")).unwrap();
    let rows: Vec<&str> = segments.lines().collect();
    let kept = rows.iter().rposition(|row| row.contains(",sos,")).unwrap().min(rows.len() / 2);
    let last = rows[kept].split(',').take(2).collect::<Vec<_>>();
    let kept = rows.iter().rposition(|row| row.split(',').take(2).eq(last.iter().copied())).unwrap();
    let mut lengths: std::collections::BTreeMap<String, u64> = std::collections::BTreeMap::new();
    for row in &rows[1..=kept] {
        let cells: Vec<&str> = row.split(',').collect();
        lengths.insert(cells[2].to_owned(), cells[3].parse().unwrap());
    }
    let kept_rows = rows[..=kept].join("\n") + "\n";
    lengths.insert("segments.csv".to_owned(), kept_rows.len() as u64);
    let mut state: serde_json::Value = serde_json::from_str(&unsealed(&cut, "state.json")).unwrap();
    state["outcome"] = "unfinished".into();
    state["digests"] = serde_json::json!({});
    let tables: Vec<String> = state["committed"].as_object().unwrap().keys().cloned().collect();
    for table in tables {
        let path = cut_path.join(&table);
        let bytes = std::fs::read(&path).unwrap();
        let header = bytes.iter().position(|&byte| byte == b'\n').unwrap() as u64 + 1;
        let length = lengths.get(&table).copied().unwrap_or(header);
        state["committed"][&table] = length.into();
        let end = (usize::try_from(length).unwrap() + 7).min(bytes.len());
        std::fs::write(&path, &bytes[..end]).unwrap();
    }
    std::fs::write(cut_path.join("state.json"), state.to_string()).unwrap();
    expect(0, &["run", "--resume", &cut, "-q"]);
    let differ: Vec<String> =
        files(Path::new(&part)).symmetric_difference(&files(cut_path)).map(|(name, _)| name.clone()).collect();
    assert!(differ.is_empty(), "{differ:?}");
}

/// A single part is the whole, so that scripts with any number of parts can end with a merge.
#[test]
fn a_single_part_is_merged_into_the_same() {
    let folder = tempdir().unwrap();
    let [plan, part, out] = ["plan.json", "part", "merged"].map(|name| at(&folder, name));
    expect(0, &["shard", "plan", "lecture", "-b", "exact", "--shards", "1", "--out", &plan]);
    expect(0, &["run", "--plan", &plan, "--shard", "1/1", "-q", "--out", &part]);
    assert!(merge(std::slice::from_ref(&part), &out, 0).contains("1 part, "));
    assert_eq!(files(Path::new(&part)), files(Path::new(&out)));
    expect(0, &["gate", &out]);
    // A single part given twice is refused.
    assert!(merge(&[part.clone(), part], &at(&folder, "two"), 2).contains("it is a whole run, not a part"));
}
