//! `expect update` and `expect prune` update a file of expectations from a run.

use tempfile::{TempDir, tempdir};

use crate::common::{SUITE, at, expect, run, unsealed, write};

/// Runs a suite on two backends with a file of expectations.
fn go(folder: &TempDir, suite: &str, known: &str, name: &str) -> String {
    let out = at(folder, name);
    let code = run(&["run", suite, "-b", "exact,naive", "-q", "--expected", known, "--out", &out]).code;
    assert!([0, 100, 101].contains(&code), "{code}");
    out
}

#[test]
fn an_update_makes_the_gate_green_and_a_prune_takes_it_back() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let known = write(&folder, "known.toml", "# What is known.\n");
    let run = go(&folder, &suite, &known, "run");
    let update = ["expect", "update", &run, "--expected", &known, "--reason"];
    expect(2, &update[..5]);
    let told = expect(2, &[&update[..], &["  "]].concat()).stderr;
    assert!(told.contains("--reason is empty"), "{told}");

    // First only show the changes.
    let why = "2^-53 is lost against 12";
    let told = expect(0, &[&update[..], &[why, "--dry-run"]].concat()).stdout;
    assert!(told.contains("+backend = \"naive\"\n") && told.contains("@@ -1 +1,"), "{told}");
    assert_eq!(std::fs::read_to_string(&known).unwrap(), "# What is known.\n");
    expect(100, &["gate", &run, "--expected", &known]);
    expect(0, &[&update[..], &[why]].concat());
    expect(0, &["gate", &run, "--expected", &known]);
    let text = std::fs::read_to_string(&known).unwrap();
    assert!(text.starts_with("# What is known.\n\n[[expect]]\n") && text.contains(why), "{text}");
    assert!(expect(0, &[&update[..], &[why]].concat()).stdout.contains("nothing to change"));
    let prune = |run: &str, more: &[&str]| {
        expect(0, &[&["corpus", "expect", "prune", run, "--expected", &known][..], more].concat()).stdout
    };
    assert!(prune(&run, &[]).contains("nothing to change"));

    // A second scene of the same kind is added to the first scene's table.
    let more = SUITE
        .replace("wrong-once", "wrong-again")
        .split_once("[[scene]]")
        .unwrap()
        .1
        .replace("0x1.0000000000001p-1", "0x1.0000000000003p-1");
    let suite =
        write(&folder, "mine.toml", &format!("{SUITE}\n[[scene]]{}", more.split_once("\n[[scene]]").unwrap().0));
    let run = go(&folder, &suite, &known, "run-2");
    expect(100, &["gate", &run, "--expected", &known]);
    expect(0, &["corpus", "expect", "update", &run, "--expected", &known, "--reason", why]);
    let both = text.replace("    \"mine/wrong-once\",\n", "    \"mine/wrong-once\",\n    \"mine/wrong-again\",\n");
    assert_eq!(std::fs::read_to_string(&known).unwrap(), both);
    expect(0, &["gate", &run, "--expected", &known]);

    // One scene is right now and one is gone. Expectations of other backends and of the other level stay.
    let others = "\n[[expect]]\nbackend = \"sos\" # not run\nclass = \"nan\"\nscene = \"mine/*\"\nreason = \"r\"\n\n\
                  [[expect]]\nbackend = \"naive\"\nclass = \"nan\"\nscene = \"mine/plain\"\nlevel = \"full\"\nreason = \"r\"\n\n\
                  [[expect]]\nbackend = [\"naive\"]\nclass = \"overreach\"\nscene = [\"mine/wrong*\", \"mine/long-gone\"]\nreason = \"r\"\n";
    std::fs::write(&known, both.clone() + others).unwrap();
    let suite =
        write(&folder, "mine.toml", &std::fs::read_to_string(&suite).unwrap().replace("0x1.0000000000003p-1", "0x1p3"));
    let run = go(&folder, &suite, &known, "run-3");
    expect(101, &["gate", &run, "--expected", &known]);
    let told = prune(&run, &["--dry-run"]);
    assert!(told.contains("-    \"mine/wrong-again\",\n"), "{told}");
    assert!(
        told.contains("`mine/wrong*` matches scenes that show overreach on naive and scenes that do not"),
        "{told}"
    );
    assert_eq!(std::fs::read_to_string(&known).unwrap(), both.clone() + others, "nothing was written");
    prune(&run, &[]);
    let left = text.clone() + &others.replace(", \"mine/long-gone\"", "");
    assert_eq!(std::fs::read_to_string(&known).unwrap(), left);
    // A file with Windows line ends keeps them.
    let crlf = |text: &str| text.replace('\n', "\r\n");
    std::fs::write(&known, crlf(&(both.clone() + others))).unwrap();
    prune(&run, &[]);
    assert_eq!(std::fs::read_to_string(&known).unwrap(), crlf(&left));
    std::fs::write(&known, "# What is known.\r\n").unwrap();
    let first = at(&folder, "run");
    expect(0, &["corpus", "expect", "update", &first, "--expected", &known, "--reason", why]);
    assert_eq!(std::fs::read_to_string(&known).unwrap(), crlf(&text));
    // Narrow the glob by hand, as the message says.
    std::fs::write(&known, left.replace("mine/wrong*", "mine/wrong-once")).unwrap();
    expect(0, &["gate", &run, "--expected", &known]);
}

/// The text of expectations, given as scenes, backend and class.
fn entries(all: &[(&str, &str, &str)]) -> String {
    let entry = |(scene, backend, class): &(&str, &str, &str)| {
        format!("[[expect]]\nscene = \"{scene}\"\nbackend = \"{backend}\"\nclass = \"{class}\"\nreason = \"r\"\n")
    };
    all.iter().map(entry).collect()
}

#[test]
fn what_a_run_has_not_tried_stays() {
    let folder = tempdir().unwrap();
    let a = write(&folder, "a.toml", SUITE);
    let b = write(
        &folder,
        "b.toml",
        &SUITE.replace("0x1.0000000000001p-1", "0x1.0000000000003p-1").replace("1\", \"0\"]", "2\", \"0\"]"),
    );
    let known = write(&folder, "known.toml", "");
    let go = |name: &str, args: &[&str]| {
        let out = at(&folder, name);
        run(&[&["run", "-b", "naive", "-q", "--expected", &known, "--out", &out][..], args].concat());
        out
    };
    let prune = |run: &str| expect(0, &["corpus", "expect", "prune", run, "--expected", &known]).stdout;
    let text = || std::fs::read_to_string(&known).unwrap();
    let (both, one, part) = (go("both", &[&a, &b]), go("one", &[&a]), go("part", &[&a, "-f", "plain"]));

    // Expectations of another suite stay.
    expect(0, &["corpus", "expect", "update", &both, "--expected", &known, "--reason", "r"]);
    let before = text();
    assert!(before.contains("b/wrong-once"), "{before}");
    expect(0, &["gate", &one, "--expected", &known]);
    let told = prune(&one);
    assert!(told.contains("1 expectations stay, because the run has not tested them"), "{told}");
    assert!(told.contains("nothing to change"), "{told}");

    // Expectations of engines, which may be in any folder, and of globs that were tested only in part stay. Misspelled
    // ones are removed.
    let stay = [("a/*", "naive", "nan"), ("a/wrong-once", "engine:odd", "nan"), ("a/w*", "naive", "overreach")];
    let gone = [("a/long-gone", "naive", "nan"), ("a/plain", "nave", "nan"), ("a/p*", "naive", "overreach")];
    std::fs::write(&known, entries(&[&stay[..], &gone].concat())).unwrap();
    let gate = expect(101, &["gate", &part, "--expected", &known]).stdout;
    assert!(gate.contains(" 2 never true") && !gate.contains("engine:odd"), "{gate}");
    prune(&part);
    assert_eq!(text(), entries(&stay));
    // Now the run has tested all matching scenes.
    std::fs::write(&known, entries(&[("a/*", "naive", "nan")])).unwrap();
    prune(&one);
    assert_eq!(text(), "");

    // Without its file, the other scenes of a suite are unknown.
    std::fs::remove_file(&a).unwrap();
    let stay = [("a/wrong-once", "naive", "overreach"), ("a/p*", "naive", "inconsistent"), ("lost", "naive", "nan")];
    let gone = [("a/plain", "naive", "nan"), ("families/long-gone", "naive", "nan")];
    std::fs::write(&known, entries(&stay)).unwrap();
    assert!(expect(101, &["gate", &part, "--expected", &known]).stdout.contains(" 0 never true"));
    std::fs::write(&known, entries(&[&stay[..], &gone].concat())).unwrap();
    prune(&part);
    assert_eq!(text(), entries(&stay));
    // A name without a suite may belong to a suite that no run knows, so a person decides.
    std::fs::write(&known, entries(&[("lost", "naive", "nan")])).unwrap();
    let told = prune(&go("other", &[&b]));
    assert!(told.contains("known.toml:2: `lost` is not a known scene, for nan on naive; correct or drop"), "{told}");
}

#[test]
fn an_update_counts_what_it_has_changed() {
    let folder = tempdir().unwrap();
    // Names with characters that are special in globs.
    for (at, name) in ["a\\\\b", "\\\\", "[a]{b,c}*?!\\\\*"].into_iter().enumerate() {
        let suite = write(&folder, "mine.toml", &SUITE.replace("wrong-once", name));
        let known = write(&folder, "known.toml", "");
        let run = go(&folder, &suite, &known, &format!("run-{at}"));
        let update = || expect(0, &["corpus", "expect", "update", &run, "--expected", &known, "--reason", "r"]).stdout;
        let told = update();
        assert!(told.ends_with(": 1 rows are expected from now on\n"), "{told}");
        expect(0, &["gate", &run, "--expected", &known]);
        assert!(update().contains("nothing to change"), "{name}");
    }
    // A row without an expected class is an unexpected pass, whatever its other expectations are.
    let suite = write(&folder, "mine.toml", SUITE);
    let known = write(&folder, "known.toml", &entries(&[("wrong-once", "naive", "nan")]));
    let run = go(&folder, &suite, &known, "run");
    let told = expect(0, &["corpus", "expect", "update", &run, "--expected", &known, "--reason", "r"]).stdout;
    assert!(told.ends_with(": 0 rows are expected from now on, 1 still unexpected pass\n"), "{told}");
    expect(101, &["gate", &run, "--expected", &known]);
}

#[test]
fn a_run_or_file_that_says_nothing_is_refused() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let known = write(&folder, "known.toml", "");
    let run = go(&folder, &suite, &known, "run");
    let state = std::path::Path::new(&run).join("state.json");
    let text = unsealed(&run, "state.json");
    std::fs::write(&state, text.replace("\"complete\"", "\"interrupted\"")).unwrap();
    let told = expect(103, &["corpus", "expect", "prune", &run, "--expected", &known]).stderr;
    assert!(told.contains("incomplete: interrupted; complete it first"), "{told}");
    std::fs::write(&state, text).unwrap();
    expect(2, &["corpus", "expect", "prune", &run, "--expected", &at(&folder, "nowhere.toml")]);
    let inline = "expect = [{ backend = \"sos\", class = \"nan\", scene = \"*\", reason = \"r\" }]\n";
    let told =
        expect(104, &["corpus", "expect", "prune", &run, "--expected", &write(&folder, "inline.toml", inline)]).stderr;
    assert!(told.contains("inline.toml:1: it is not a separate table; write it as [[expect]]"), "{told}");
    // The shipped file is edited only in the repository.
    let told = expect(2, &["corpus", "expect", "prune", &run]).stderr;
    assert!(told.contains("name a file with --expected"), "{told}");
    // A file that does not exist yet is created.
    let new = at(&folder, "new.toml");
    expect(0, &["corpus", "expect", "update", &run, "--expected", &new, "--reason", "r"]);
    expect(0, &["gate", &run, "--expected", &new]);
}
