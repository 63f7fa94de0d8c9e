//! `bench --judged`: what a run has judged is taken over.

use tempfile::tempdir;

use crate::common::{at, column, expect, read, rewrite, run, write};

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

#[test]
fn a_scene_that_became_slower_is_seen_beside_a_slow_one() {
    let folder = tempdir().unwrap();
    let scene = |n: u32| format!("[[generate]]\nname = \"u{n}\"\nfamily = \"uniform\"\ntask = \"orient2d\"\nn = {n}\n");
    let suite = write(&folder, "mine.toml", &format!("title = \"Mine\"\n{}{}", scene(10), scene(20)));
    let bench = |name: &str, suite: &str, times: [u32; 2]| {
        let out = at(&folder, name);
        expect(0, &["bench", suite, "-b", "exact", "--samples", "2", "--sample-ms", "0", "--out", &out]);
        let [first, second] =
            times.map(|ns| [0, 1].map(|sample| format!("orient2d,uniform,exact,1,10,{sample},{ns}.5\n")));
        let head = read(&out, "throughput.csv").lines().next().unwrap().to_owned();
        rewrite(&out, "throughput.csv", &format!("{head}\n{}{}", first.concat(), second.concat()));
        out
    };
    let state = read(&bench("stopped", &suite, [2, 90]), "state.json").replace("complete", "interrupted");
    write(&folder, "stopped/state.json", &state);
    let refused = expect(2, &["run", "--resume", &at(&folder, "stopped")]);
    assert!(refused.stderr.contains("a bench can't be resumed"), "{}", refused.stderr);
    let (then, same, now) =
        (bench("then", &suite, [2, 90]), bench("same", &suite, [2, 80]), bench("now", &suite, [20, 90]));
    expect(0, &["gate", &same, "--baseline", &then, "--time"]);
    let slower = expect(102, &["gate", &now, "--baseline", &then, "--time"]);
    let said = "slower: orient2d uniform on exact: 20.50 ns/query, was 2.50 (8.20 times)";
    assert!(slower.stdout.contains(said), "{}", slower.stdout);
    // Of other scenes nothing is said.
    let other = write(&folder, "other.toml", &format!("title = \"Other\"\n{}{}", scene(10), scene(30)));
    let other = expect(0, &["gate", &bench("other", &other, [20, 90]), "--baseline", &then, "--time"]);
    let why = "times were not judged: orient2d";
    let all = ["other scenes were timed than in the baseline", why];
    assert!(all.iter().all(|part| other.stdout.contains(part)), "{}", other.stdout);
}
