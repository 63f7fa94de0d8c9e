//! `gate --summary`: a verdict for a comment.

use tempfile::tempdir;

use crate::common::{SUITE, at, column, expect, read, rewrite, run, write};

#[test]
fn the_verdict_comes_first_and_says_what_to_type() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let none = write(&folder, "none.toml", "");
    let out = at(&folder, "run 1");
    expect(100, &["run", &suite, "-b", "exact,naive", "-q", "--expected", &none, "--out", &out]);
    let comment = at(&folder, "comment.md");
    let gate = |run: &str, expected: &str, more: &[&str]| {
        let words = [&["gate", run, "--expected", expected, "--summary", &comment][..], more].concat();
        let code = crate::common::run(&words).code;
        (code, std::fs::read_to_string(&comment).unwrap())
    };
    let (code, text) = gate(&out, &none, &[]);
    assert_eq!(code, 100);
    assert!(text.starts_with("## Gate: failed, unexpected findings (code 100)\n"), "{text}");
    assert!(text.contains("| 2 | 2 | 3 | 0 | 1 | 0 | 0 | 0 | 0 | 0 |"), "{text}");
    assert!(text.contains("* `unexpected: mine/wrong-once on naive: 1 overreach`"), "{text}");
    let id = column(&read(&out, "findings.csv"), "finding_id").remove(0);
    let typed = format!("`predicament replay {id} --run '{out}'`<br>`predicament shrink {id} --run '{out}'`");
    assert!(text.contains(&typed), "{text}");

    // The gate passes, and the baseline was right about the scene.
    let forgiving = "[[expect]]\nscene = \"wrong-once\"\nbackend = \"naive\"\nclass = \"overreach\"\nreason = \"r\"\n";
    let forgiving = write(&folder, "forgiving.toml", forgiving);
    let (code, text) = gate(&out, &forgiving, &[]);
    assert!(code == 0 && text.starts_with("## Gate: passed\n") && !text.contains("###"), "{text}");
    let before = at(&folder, "before");
    run(&["run", &suite, "-b", "exact,naive", "-q", "--expected", &none, "--out", &before]);
    let summary =
        read(&before, "summary.csv").replace(",1,0,0,0,1,0,0,0,0,0,0,0,0,0,0,", ",1,1,0,0,0,0,0,0,0,0,0,0,0,0,0,");
    rewrite(&before, "summary.csv", &summary);
    let (code, text) = gate(&out, &forgiving, &["--baseline", &before]);
    assert!(code == 100 && text.starts_with("## Gate: failed, more findings than in the baseline"), "{text}");
    assert!(text.contains("worse than the baseline: mine/wrong-once on naive: 1 overreach, was 0"), "{text}");
    assert!(text.contains("### First findings") && text.contains("### Beside the baseline"), "{text}");
    let stdout = run(&["gate", &out, "--expected", &forgiving, "--summary", "-"]).stdout;
    assert!(stdout.contains("## Gate: passed"), "{stdout}");
}

/// A run of four thousand unexpected rows, with long names and text that looks like markup.
#[test]
fn a_comment_is_never_too_long() {
    let folder = tempdir().unwrap();
    let scene = |n: usize| {
        format!(
            "[[scene]]\nname = \"a-long-name-of-a-scene-that-is-wrong-{n:04}\"\ntask = \"orient2d\"\n\
             points = [[\"0x1.0000000000001p-1\", \"0x1p-1\"], [{}, {}], [24, 24]]\n",
            n + 30,
            n + 30
        )
    };
    let text: String = (0..1000).map(scene).collect();
    let suite = write(&folder, "mine.toml", &format!("title = \"Mine\"\n{text}"));
    let none = write(&folder, "none.toml", "");
    let out = at(&folder, "run");
    let (backends, comment) = ("naive,naive:first,shewchuk,epsilon:1e-10", at(&folder, "comment.md"));
    run(&["run", &suite, "-b", backends, "-q", "--expected", &none, "--out", &out]);
    let before = at(&folder, "before");
    run(&["run", &suite, "-f", "0000$", "-b", "exact", "-q", "--expected", &none, "--out", &before]);
    expect(100, &["gate", &out, "--expected", &none, "--baseline", &before, "--summary", &comment, "--format", "json"]);
    let text = std::fs::read_to_string(&comment).unwrap();
    assert!(text.len() <= 65_536 && text.contains("more\n"), "{}", text.len());
    assert_eq!(text.matches("predicament shrink ").count(), 10);
}

/// Stdout has one text; each other text has its own file.
#[test]
fn outputs_do_not_mix() {
    let folder = tempdir().unwrap();
    let [out, file] = ["run", "one.txt"].map(|name| at(&folder, name));
    expect(0, &["run", "lecture", "-b", "exact", "-q", "--out", &out]);
    let told = expect(0, &["gate", &out, "--summary", "-"]);
    assert!(told.stdout.starts_with('#') && !told.stdout.contains("rows: "), "{}", told.stdout);
    let told = expect(2, &["gate", &out, "--summary", "-", "--format", "json"]);
    assert!(told.stderr.contains("name a file for --summary"), "{}", told.stderr);
    for (option, place) in [("--summary", format!("{out}/plan.json")), ("--junit", format!("{out}/../run/summary.csv"))]
    {
        let before = std::fs::read(&place).unwrap();
        let told = expect(2, &["gate", &out, option, &place]).stderr;
        assert!(
            told.contains("it would change the run") && told.contains(&format!("name another place for {option}")),
            "{told}"
        );
        assert_eq!(std::fs::read(&place).unwrap(), before);
    }
    let known = crate::common::write(&folder, "known.toml", "");
    let told = expect(2, &["gate", &out, "--expected", &known, "--suggest", &at(&folder, "./known.toml")]).stderr;
    assert!(told.contains("the command reads it"), "{told}");
    let told = expect(2, &["report", &out, "--out", &out]).stderr;
    assert!(told.contains("name another place for --out"), "{told}");
    let told = expect(2, &["gate", &out, "--summary", &file, "--junit", &file]);
    assert!(
        told.stderr.contains("--summary writes it, too; name another place for --junit")
            && !std::path::Path::new(&file).exists(),
        "{}",
        told.stderr
    );
}
