//! `gate` and `diff`: severities, improvements, expectations to prune, and the texts of JUnit failures.

use serde_json::Value;
use tempfile::tempdir;

use crate::common::{SUITE, at, column, expect, read, rewrite, write};

/// A tetrahedron cut where the edges have no points in doubles: each vertex is rounded, and no triangle turns over.
const ROUNDED: &str = r#"title = "Mine"

[[scene]]
name = "cut"
task = "slice"
round = true
points = [[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3]]
faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
planes = [[[0.1, 0.1, 1], [1, 0.1, 0.5], [0.1, 1, 0.7]]]
"#;

#[test]
fn what_is_rounded_is_gated_by_itself() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", ROUNDED);
    let none = write(&folder, "none.toml", "");
    let out = at(&folder, "run");
    expect(100, &["run", &suite, "-b", "naive,exact", "-q", "--expected", &none, "--out", &out]);
    let findings = read(&out, "findings.csv");
    assert!(column(&findings, "class").iter().all(|class| class == "rounded"), "{findings}");
    assert!(findings.contains("cap not in its plane") && findings.contains("has the largest error"), "{findings}");
    assert!(findings.contains("bound 4 ulp"), "{findings}");

    let gate = |code: i32, more: &[&str]| expect(code, &[&["gate", &*out, "--expected", &none], more].concat());
    gate(100, &[]);
    gate(100, &["--fail-on", "rounded"]);
    let told = gate(0, &["--fail-on", "broken,not_done"]).stdout;
    assert!(told.contains("let pass: unexpected: mine/cut on naive: ") && told.contains(", 1 let pass; "), "{told}");
    for wrong in ["right", "bad"] {
        let told = gate(2, &["--fail-on", wrong]).stderr;
        assert!(told.contains(&format!("`{wrong}`")), "{told}");
    }
    // An expected finding of a severity that does not count may be missing; one of a severity that counts may not.
    let known = |class: &str| {
        let text = format!("[[expect]]\nbackend = \"exact\"\nclass = \"{class}\"\nscene = \"cut\"\nreason = \"r\"\n");
        write(&folder, "known.toml", &text)
    };
    let gate = |code: i32, class: &str| {
        expect(code, &["gate", &out, "--expected", &known(class), "--fail-on", "broken,not_done"]).stdout
    };
    gate(0, "rounded");
    gate(101, "topology");
}

#[test]
fn what_is_mended_is_better_and_no_failure() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let none = write(&folder, "none.toml", "");
    let [bad, good] = ["bad", "good"].map(|name| at(&folder, name));
    for out in [&bad, &good] {
        expect(100, &["run", &suite, "-b", "naive", "-q", "--expected", &none, "--out", out]);
    }
    let summary =
        read(&good, "summary.csv").replace(",1,0,0,0,1,0,0,0,0,0,0,0,0,0,0,", ",1,1,0,0,0,0,0,0,0,0,0,0,0,0,0,");
    let summary = summary.replace(",unexpected\n", ",ok\n");
    assert_ne!(summary, read(&good, "summary.csv"), "the row was found");
    rewrite(&good, "summary.csv", &summary);
    let comment = at(&folder, "comment.md");
    let gate = ["gate", &good, "--expected", &none, "--baseline", &bad, "--summary", &comment];
    let told = expect(0, &gate).stdout;
    let mended = "mended since the baseline: mine/wrong-once on naive: overreach, was 1 (broken)";
    assert!(told.contains(mended) && told.contains("0 worse than the baseline, 1 better"), "{told}");
    let text = std::fs::read_to_string(&comment).unwrap();
    assert!(text.contains(&format!("### ✅ Better than the baseline\n\n* `{mended}`")), "{text}");
    assert!(!text.contains('❌'), "{text}");

    // A broken scene that is now only rounded is better, even if the rounding is unexpected and fails the gate.
    let milder = at(&folder, "milder");
    expect(100, &["run", &suite, "-b", "naive", "-q", "--expected", &none, "--out", &milder]);
    let summary =
        read(&milder, "summary.csv").replace(",1,0,0,0,1,0,0,0,0,0,0,0,0,0,0,", ",1,0,0,0,0,0,0,0,0,0,1,0,0,0,0,");
    rewrite(&milder, "summary.csv", &summary);
    let told = expect(100, &["gate", &milder, "--expected", &none, "--baseline", &bad]).stdout;
    assert!(told.contains("0 worse than the baseline, 2 better"), "{told}");
    assert!(told.contains("mine/wrong-once on naive: 1 rounded instead of broken answers"), "{told}");
    let gate = ["gate", &milder, "--expected", &none, "--baseline", &good, "--fail-on", "broken,not_done"];
    assert!(expect(0, &gate).stdout.contains("let pass: worse than the baseline: "));

    let told = expect(0, &["data", "diff", &bad, &good]).stdout;
    assert!(told.contains("### ✅ Better") && told.contains(mended) && !told.contains('❌'), "{told}");
    let told = expect(100, &["data", "diff", &good, &bad]).stdout;
    assert!(told.contains("### ❌ Worse\n\n* `worse than the baseline: mine/wrong-once"), "{told}");
    let json: Value =
        serde_json::from_str(&expect(100, &["data", "diff", &good, &bad, "--format", "json"]).stdout).unwrap();
    let changed = &json["changed"][0];
    assert_eq!((changed["worse"].as_str(), changed["better"].as_str()), (Some("broken"), None), "{json}");
}

#[test]
fn an_unexpected_pass_says_what_to_prune_and_how() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let text = "# head\n\n[[expect]]\nbackend = \"naive\"\nclass = \"overreach\"\nscene = \"wrong-once\"\nreason = \"r\"\n\n\
                [[expect]]\nbackend = \"naive\"\nclass = \"nan\"\nscene = \"mine/pl*\"\nreason = \"r\"\n";
    let known = write(&folder, "known.toml", text);
    let out = at(&folder, "my run");
    expect(101, &["run", &suite, "-b", "naive", "-q", "--expected", &known, "--out", &out]);
    let junit = at(&folder, "junit.xml");
    let told = expect(101, &["gate", &out, "--expected", &known, "--junit", &junit]).stdout;
    let unmet = format!("{known}:9: `mine/pl*` on naive: no nan of mine/plain any more");
    assert!(told.contains(&format!("not met: {unmet}")), "{told}");
    let prune = format!("predicament corpus expect prune '{out}' --expected {known}");
    assert!(told.contains(&format!("remove unmet expectations with: {prune}\n")), "{told}");
    assert!(std::fs::read_to_string(&junit).unwrap().contains(&unmet));
    expect(0, &["corpus", "expect", "prune", &out, "--expected", &known]);
    expect(0, &["gate", &out, "--expected", &known]);
}

#[test]
fn a_failure_of_junit_has_the_finding_and_its_points() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", &format!("{SUITE}{}", ROUNDED.split_once("\n\n").unwrap().1));
    let none = write(&folder, "none.toml", "");
    let [out, junit] = ["run", "junit.xml"].map(|name| at(&folder, name));
    expect(100, &["run", &suite, "-b", "naive", "-q", "--expected", &none, "--out", &out]);
    expect(100, &["gate", &out, "--expected", &none, "--junit", &junit]);
    let text = std::fs::read_to_string(&junit).unwrap();
    let id = column(&read(&out, "findings.csv"), "finding_id").remove(0);
    for line in [
        "overreach (sign), broken\n",
        "query   orient2d(xy; 0 1 2)\n",
        "vertex        0  (0.5000000000000001, 0.5)  = (0x1.0000000000001p-1, 0x1p-1)\n",
        "got     0\n",
        "truth   ",
        &format!("replay  predicament replay {id} --run {out}"),
        // For a scene as a whole, its points.
        "(wrong side), rounded\n",
        "vertex        3  (0.0, 0.0, 3.0)  = (0x0p+0, 0x0p+0, 0x1.8p+1)\n",
    ] {
        assert!(text.contains(line), "{line}: {text}");
    }
}
