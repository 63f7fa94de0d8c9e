//! `bench --judged`: what a run has judged is taken over.

use tempfile::tempdir;

use crate::common::{at, column, expect, read, run};

const SCENES: [&str; 4] = ["-f", "kettner-a1$|tilings/bricks|three-cells|cubes/twins", "-b", "exact,sos,naive"];

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
    // Peers, where they are built in, come on top.
    assert!(timed >= 4 * 3, "{told}");
    assert!(read(&out, "summary.csv").lines().all(|row| summary.contains(row)), "{summary}");

    // Were it judged again, the row would be as it was.
    let path = folder.path().join("run/summary.csv");
    let rows = read(&out, "summary.csv");
    let changed = rows.replacen(",ok", ",expected", 1);
    assert_ne!(changed, rows);
    std::fs::write(&path, &changed).unwrap();
    let state = read(&out, "state.json");
    let known = |rows: &str| format!("\"summary.csv\": {}", rows.len());
    std::fs::write(folder.path().join("run/state.json"), state.replace(&known(&rows), &known(&changed))).unwrap();
    let (_, _, summary) = bench("second");
    assert!(changed.lines().all(|row| summary.contains(row)), "{summary}");

    // Other answers than the judged ones are not timed.
    let path = folder.path().join("run/judged.csv");
    let digests = read(&out, "judged.csv");
    let digest = column(&digests, "digest").remove(0);
    std::fs::write(&path, digests.replacen(&digest, "0123456789abcdef", 1)).unwrap();
    let (told, fewer, _) = bench("third");
    assert!(told.contains("the timed answers are not the judged ones") && fewer == timed - 1, "{told}");
}
