//! `bench --judged` uses the judgements of a run.

use tempfile::tempdir;

use crate::common::{at, column, expect, read, rewrite, run, unsealed, write};

const SCENES: [&str; 4] = ["-f", "kettner-a1$|tilings/crossing|three-cells|cubes/twins", "-b", "exact,sos,naive"];

#[test]
fn judgements_are_taken_over_and_answers_compared() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "run");
    run(&[&["run"][..], &SCENES, &["--out", &out]].concat());
    let bench = |name: &str| {
        let bench = at(&folder, name);
        let rest = ["--samples", "1", "--sample-ms", "0", "--judged", &out, "--out", &bench];
        let told = expect(0, &[&["bench"][..], &SCENES, &rest].concat()).stdout;
        (told, column(&read(&bench, "throughput.csv"), "backend").len(), read(&bench, "summary.csv"))
    };
    let (told, timed, summary) = bench("first");
    assert!(!told.contains("not timed"), "{told}");
    // Signs are timed one by one and in batches.
    assert!(timed >= 5 * 3, "{told}");
    assert!(read(&out, "summary.csv").lines().all(|row| summary.contains(row)), "{summary}");

    // If the answers were judged again, this row would be unchanged.
    let rows = read(&out, "summary.csv");
    let changed = rows.replacen(",ok", ",expected", 1);
    assert_ne!(changed, rows);
    rewrite(&out, "summary.csv", &changed);
    let (_, _, summary) = bench("second");
    assert!(changed.lines().all(|row| summary.contains(row)), "{summary}");

    // Answers that differ from the judged ones are not timed.
    let digests = read(&out, "judged.csv");
    let digest = column(&digests, "digest").remove(0);
    rewrite(&out, "judged.csv", &digests.replacen(&digest, "0123456789abcdef", 1));
    let (told, fewer, _) = bench("third");
    let interfaces = told.matches("the timed answers are not the judged ones").count();
    let of_signs = column(&digests, "task")[0] == "orient2d";
    assert_eq!((interfaces, fewer), if of_signs { (2, timed - 2) } else { (1, timed - 1) }, "{told}");
}

#[test]
fn a_scene_that_became_slower_is_seen_beside_a_slow_one() {
    let folder = tempdir().unwrap();
    let scene = |n: u32| format!("[[generate]]\nname = \"u{n}\"\nfamily = \"uniform\"\ntask = \"orient2d\"\nn = {n}\n");
    let suite = write(&folder, "mine.toml", &format!("title = \"Mine\"\n{}{}", scene(10), scene(20)));
    let timed = |name: &str, suite: &str, interface: &str, times: [u32; 2]| {
        let out = at(&folder, name);
        expect(0, &["bench", suite, "-b", "exact", "--samples", "2", "--sample-ms", "0", "--out", &out]);
        let [first, second] =
            times.map(|ns| [0, 1].map(|sample| format!("orient2d,uniform,exact,{interface},1,10,{sample},{ns}.5\n")));
        let head = read(&out, "throughput.csv").lines().next().unwrap().to_owned();
        rewrite(&out, "throughput.csv", &format!("{head}\n{}{}", first.concat(), second.concat()));
        out
    };
    let bench = |name: &str, suite: &str, times| timed(name, suite, "single", times);
    let state = unsealed(&bench("stopped", &suite, [2, 90]), "state.json").replace("complete", "interrupted");
    write(&folder, "stopped/state.json", &state);
    let refused = expect(2, &["run", "--resume", &at(&folder, "stopped")]);
    assert!(refused.stderr.contains("a bench cannot be resumed"), "{}", refused.stderr);
    let (then, same, now) =
        (bench("then", &suite, [2, 90]), bench("same", &suite, [2, 80]), bench("now", &suite, [20, 90]));
    expect(0, &["gate", &same, "--baseline", &then, "--time"]);
    let slower = expect(102, &["gate", &now, "--baseline", &then, "--time"]);
    let said = "slower: orient2d uniform on exact (single): 20.50 ns/query, was 2.50 (8.20 times)";
    assert!(slower.stdout.contains(said), "{}", slower.stdout);
    // Timings of batches and of single queries are not compared.
    let batches = timed("batches", &suite, "batch", [20, 90]);
    let batches = expect(0, &["gate", &batches, "--baseline", &then, "--time"]);
    assert!(!batches.stdout.contains("slower"), "{}", batches.stdout);
    // Timings of other scenes are not compared.
    let other = write(&folder, "other.toml", &format!("title = \"Other\"\n{}{}", scene(10), scene(30)));
    let other = expect(0, &["gate", &bench("other", &other, [20, 90]), "--baseline", &then, "--time"]);
    let why = "times were not judged: orient2d";
    let all = ["the baseline timed other scenes", why];
    assert!(all.iter().all(|part| other.stdout.contains(part)), "{}", other.stdout);
}

/// A suite with a scene of each kind of answer.
const SUITE: &str = "title = \"Mine\"\n\
    [[generate]]\nname = \"signs\"\nfamily = \"uniform\"\ntask = \"orient2d\"\nn = 5\nn_full = 9\n\
    [[generate]]\nname = \"bricks\"\nfamily = \"bricks\"\ntask = \"polygon-locate\"\nn = 4\n\
    [[generate]]\nname = \"left-out\"\nfamily = \"grid\"\ntask = \"orient2d\"\nn = 5\n";

const QUICKLY: [&str; 4] = ["--samples", "1", "--sample-ms", "0"];

#[test]
fn the_scenes_of_a_run_are_timed_and_no_others() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let (out, bench) = (at(&folder, "run"), at(&folder, "bench"));
    let backends = "exact,naive:nalgebra";
    run(&["run", &suite, "-f", "signs|bricks", "--level", "full", "-b", backends, "--out", &out]);
    let told = expect(0, &[&["bench", "--judged", &out, "--out", &bench][..], &QUICKLY].concat()).stdout;
    assert!(told.contains("4 judgements were taken over from"), "{told}");
    assert!(!told.contains("not timed"), "{told}");
    let of = |out: &str, key: &str| {
        let plan: serde_json::Value = serde_json::from_str(&read(out, "plan.json")).unwrap();
        plan[key].clone()
    };
    for key in ["scenes", "backends", "level", "suites", "paths", "hashes"] {
        assert_eq!(of(&bench, key), of(&out, key), "{key}");
    }
    assert_eq!(read(&bench, "summary.csv"), read(&out, "summary.csv"));
    // The interfaces of the rows.
    let throughput = read(&bench, "throughput.csv");
    let [tasks, names, interfaces, queries] =
        ["task", "backend", "interface", "queries"].map(|name| column(&throughput, name));
    let rows = (0..tasks.len()).map(|at| [&*tasks[at], &*names[at], &*interfaces[at]].join(" "));
    let rows: Vec<String> = rows.collect();
    let expected = [
        "orient2d exact single",
        "orient2d exact batch",
        "orient2d naive:nalgebra single",
        "orient2d naive:nalgebra loop",
        "polygon-locate exact whole",
        "polygon-locate naive:nalgebra whole",
    ];
    assert_eq!(rows, expected, "{throughput}");
    assert_eq!(queries[0], "9", "the level of the run");

    // With a filter and another backend there is no judgement to use.
    let filtered = at(&folder, "filtered");
    let args = ["bench", "--judged", &out, "-f", "signs", "-b", "shewchuk", "--out", &filtered];
    let told = expect(0, &[&args[..], &QUICKLY].concat()).stdout;
    assert!(told.contains("1 scenes timed") && told.contains("no judgement was taken over from"), "{told}");
}

#[test]
fn a_run_that_says_nothing_about_what_is_timed_is_refused() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let (out, bench) = (at(&folder, "run"), at(&folder, "bench"));
    expect(0, &["run", &suite, "-f", "signs", "-b", "exact", "--out", &out]);
    let refused = |why: &str, args: &[&str]| {
        let told = expect(2, &[&["bench", "--judged", &out, "--out", &bench][..], args, &QUICKLY].concat());
        assert!(told.stderr.contains(why), "{}", told.stderr);
        assert!(!std::path::Path::new(&bench).exists(), "nothing is begun");
    };
    refused("no scene of `classics` that is selected was judged in this run", &[&suite, "classics"]);
    refused("the run is of level quick, and --level asks for full", &["--level", "full"]);
    let told = expect(4, &["bench", "--judged", &out, "-f", "bricks", "--out", &bench]);
    assert!(told.stderr.contains("no scene of the run is selected"), "{}", told.stderr);
    write(&folder, "mine.toml", &SUITE.replace("n = 5", "n = 6"));
    refused(&format!("scene mine/signs of {suite} has changed since it was judged"), &[]);
}

#[test]
fn an_engine_of_a_run_is_not_started_unless_it_is_named() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let (out, bench) = (at(&folder, "run"), at(&folder, "bench"));
    expect(0, &["run", &suite, "-f", "signs", "-b", "exact", "--out", &out]);
    let marker = at(&folder, "started");
    let engine = format!("name = \"evil\"\nrun = [\"touch\", {marker:?}]\n");
    let engine = write(&folder, "engine.toml", &engine);
    let mut plan: serde_json::Value = serde_json::from_str(&unsealed(&out, "plan.json")).unwrap();
    plan["backends"] = serde_json::json!(["exact", "engine:evil"]);
    plan["engines"] = serde_json::json!({ "engine:evil": { "file": engine, "sha256": "" } });
    std::fs::write(format!("{out}/plan.json"), serde_json::to_string_pretty(&plan).unwrap()).unwrap();
    // Make a run without digests.
    rewrite(&out, "summary.csv", &read(&out, "summary.csv"));
    let told = expect(0, &[&["bench", "--judged", &out, "--out", &bench][..], &QUICKLY].concat()).stdout;
    assert!(told.contains("not timed: engine:evil; name it with -b to start it"), "{told}");
    assert!(!std::path::Path::new(&marker).exists(), "the engine was started");
}
