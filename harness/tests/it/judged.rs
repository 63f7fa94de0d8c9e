//! `bench --judged`: what a run has judged is taken over.

use tempfile::tempdir;

use crate::common::{at, column, expect, read, rewrite, run};

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
    let rows = read(&out, "summary.csv");
    let changed = rows.replacen(",ok", ",expected", 1);
    assert_ne!(changed, rows);
    rewrite(&out, "summary.csv", &changed);
    let (_, _, summary) = bench("second");
    assert!(changed.lines().all(|row| summary.contains(row)), "{summary}");

    // Other answers than the judged ones are not timed.
    let digests = read(&out, "judged.csv");
    let digest = column(&digests, "digest").remove(0);
    rewrite(&out, "judged.csv", &digests.replacen(&digest, "0123456789abcdef", 1));
    let (told, fewer, _) = bench("third");
    assert!(told.contains("the timed answers are not the judged ones") && fewer == timed - 1, "{told}");
}
