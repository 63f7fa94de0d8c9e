//! Features that scripts and shells need: JSON, quiet mode, completions, manual pages, and one line about suites that
//! are not run.

use crate::common::{SUITE, at, expect, run, told, tool, write};
use serde_json::Value;
use tempfile::tempdir;

#[test]
fn a_script_reads_what_the_gate_says() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let (out, empty) = (at(&folder, "run"), write(&folder, "empty.toml", ""));
    run(&["run", &suite, "--expected", &empty, "-b", "naive,exact", "--out", &out]);
    let told: Value =
        serde_json::from_str(&expect(100, &["gate", &out, "--expected", &empty, "--format", "json"]).stdout).unwrap();
    assert_eq!((&told["rows"], &told["ok"], &told["unexpected"]), (&4.into(), &3.into(), &1.into()), "{told}");
    assert_eq!(told["failed"][0], "unexpected: mine/wrong-once on naive: 1 overreach");
    assert_eq!(told["outcome"], "complete");
}

#[test]
fn a_script_reads_the_scorecard() {
    let only =
        ["setup", "selftest", "-f", "classics/kettner-a1$", "--only", "fault:sos-swapped-term", "--format", "json"];
    let told = run(&only).stdout;
    let lines: Vec<Value> = told.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines.len(), 6, "five honest backends and the fault: {told}");
    assert_eq!(lines[0]["name"], "exact");
    assert_eq!(lines[0]["verdict"], "clean");
}

#[test]
fn a_script_reads_what_there_is() {
    let told = expect(0, &["corpus", "list", "--format", "json"]).stdout;
    let suites: Vec<Value> = told.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let classics = suites.iter().find(|suite| suite["suite"] == "classics").unwrap();
    let scenes = classics["scenes"].as_array().unwrap();
    assert!(scenes.iter().any(|scene| scene["name"] == "kettner-a1" && scene["task"] == "orient2d"), "{classics}");
    assert!(suites.iter().any(|suite| suite["needs_fetch"] == true));
}

#[test]
fn what_is_not_run_is_one_line_and_none_if_quiet() {
    let folder = tempdir().unwrap();
    for (suites, said) in [(&["classics"][..], None), (&[][..], Some("corpus fetch` gets their data, then name them"))]
    {
        let call = |out: &str, more: &[&str]| {
            let out = at(&folder, out);
            let args = ["run", "-f", "kettner-a1$", "-b", "exact", "--out", &out];
            expect(0, &[&args[..], suites, more].concat()).stderr
        };
        let name = suites.len().to_string();
        let told = call(&name, &[]);
        assert_eq!(told.lines().count(), said.iter().len(), "whoever names a suite hears nothing of others: {told}");
        assert!(said.is_none_or(|said| told.contains(said)), "{told}");
        assert_eq!(call(&format!("{name}-quiet"), &["--quiet"]), "");
    }
}

/// A user who runs their own suite gets no notes about the shipped corpora and expectations.
#[test]
fn a_suite_of_ones_own_is_not_told_about_the_others() {
    let folder = tempdir().unwrap();
    let (suite, out, both) = (write(&folder, "mine.toml", SUITE), at(&folder, "run"), at(&folder, "both"));
    run(&["run", &suite, "-b", "exact", "--out", &out]);
    let told = expect(0, &["gate", &out]);
    assert_eq!(told.stdout.lines().count(), 1, "{}", told.stdout);
    let json: Value = serde_json::from_str(&expect(0, &["gate", &out, "--format", "json"]).stdout).unwrap();
    assert_eq!(json["not_held"], serde_json::json!([]));
    let own = "[[expect]]\nscene = \"plain\"\nbackend = \"naive\"\nclass = \"nan\"\nreason = \"of another run\"\n";
    let told = expect(0, &["gate", &out, "--expected", &write(&folder, "own.toml", own)]);
    assert!(told.stdout.starts_with("1 expectations do not apply to this run's"), "their own are: {}", told.stdout);
    run(&["run", &suite, "classics", "-f", "plain|kettner-a1", "-b", "exact", "--out", &both]);
    let told = expect(0, &["gate", &both]);
    assert!(told.stdout.contains(" expectations do not apply to this run's"), "with one of ours: {}", told.stdout);
    let told = expect(0, &["corpus", "verify", &suite]);
    assert_eq!((told.stdout.lines().count(), told.stderr.lines().count()), (1, 0), "{}{}", told.stdout, told.stderr);
    let told = expect(0, &["corpus", "verify", "-f", "classics/"]);
    assert!(told.stderr.contains("not verified: fixtures"), "suites without their data are named: {}", told.stderr);
}

#[test]
fn shells_and_man_know_every_command() {
    let folder = tempdir().unwrap();
    for shell in ["bash", "zsh", "fish"] {
        let text = expect(0, &["setup", "completions", shell]).stdout;
        assert!(text.contains("predicament") && text.contains("selftest"), "{shell}: {text}");
    }
    let pages = at(&folder, "man1");
    expect(0, &["setup", "man", "--out", &pages]);
    let page = |name: &str| std::fs::read_to_string(folder.path().join("man1").join(name)).unwrap();
    assert!(page("predicament.1").contains("differential test harness"));
    for (name, said) in [("run", "isolate"), ("corpus-fmt", "check"), ("ask", "incircle"), ("study-laws", "tuples")] {
        assert!(page(&format!("predicament-{name}.1")).contains(said), "{name}");
    }
}

#[test]
fn the_page_of_commands_is_what_the_tool_prints() {
    let page = include_str!("../../../docs/COMMANDS.md");
    assert_eq!(expect(0, &["setup", "man", "--format", "md"]).stdout, page, "run `cargo xtask pages`");
    let fits = |line: &str| line.chars().count() <= 100 || !line.trim().contains(' ');
    assert!(page.lines().all(fits), "a help text is wider than 100 columns");
}

/// Help texts have no line break inside a paragraph.
#[test]
fn help_is_as_wide_as_the_terminal() {
    let commands = [&["run"][..], &["ask"], &["hunt"], &["setup", "selftest"], &["study", "compare"], &["draw", "map"]];
    for command in commands {
        for columns in ["60", "80", "100"] {
            let mut help = tool(&[command, &["--help"]].concat());
            let told = told(help.env("COLUMNS", columns).output().unwrap()).stdout;
            let width: usize = columns.parse().unwrap();
            let lines: Vec<&str> = told.lines().collect();
            let fits =
                |line: &&str| line.chars().count() <= width || line.contains("Usage:") || !line.trim().contains(' ');
            let wide: Vec<&&str> = lines.iter().filter(|line| !fits(line)).collect();
            assert!(wide.is_empty(), "{command:?} {columns}: {wide:?}");
            let is_prose =
                |line: &str| line.starts_with(char::is_alphabetic) && !line.contains("  ") && !line.ends_with(':');
            for pair in lines.windows(2).filter(|pair| is_prose(pair[0]) && is_prose(pair[1])) {
                let word = pair[1].split(' ').next().unwrap_or_default();
                let fits = pair[0].chars().count() + 1 + word.chars().count() <= width;
                assert!(!fits, "{command:?} {columns}: `{}` goes on with `{word}`", pair[0]);
            }
        }
    }
}

#[test]
fn earlier_names_of_commands_work_and_say_the_new_ones() {
    let told = expect(0, &["bounds"]);
    assert_eq!(told.stderr, "predicament: `bounds` is `study bounds` now\n");
    assert_eq!(told.stdout, expect(0, &["study", "bounds"]).stdout);
    let told = expect(0, &["-q", "doctor", "--scene", "classics/kettner-a1$"]);
    assert!(told.stderr.is_empty() && told.stdout.contains("kettner-a1"), "{}{}", told.stdout, told.stderr);
    let help = expect(0, &["--help"]).stdout;
    let commands = help.lines().filter(|line| line.starts_with("  ") && line.as_bytes()[2].is_ascii_lowercase());
    assert_eq!(commands.count(), 19, "{help}");
}
