//! `shrink`, and `run --shrink`.

use std::fs;

use serde_json::Value;
use tempfile::{TempDir, tempdir};

use crate::common::{at, expect, run, tool, write};

/// Two families like the embedded ones, but smaller: the size of the shrunk scene does not depend on the size of the
/// original.
const SMALL: &str = "title = \"Small\"\n\
    [[generate]]\nfamily = \"near\"\ntask = \"orient3d\"\nn = 800\nseed = 3\nulps = 4\n\
    [[generate]]\nfamily = \"kettner\"\ntask = \"orient2d\"\nn = 600\nseed = 4\n";

/// Runs a suite and returns the id of its first finding of a class and check, and the folder.
fn found(folder: &TempDir, suite: &str, filter: &str, backends: &str, class: &str, check: &str) -> (String, String) {
    let out = at(folder, "run");
    let code = run(&["run", suite, "-f", filter, "-b", backends, "-q", "--out", &out]).code;
    assert!([0, 100].contains(&code), "{code}");
    let mut table = csv::Reader::from_path(format!("{out}/findings.csv")).unwrap();
    let heads = table.headers().unwrap().clone();
    let column = |name: &str| heads.iter().position(|head| head == name).unwrap();
    let (id, of_class, of_check) = (column("finding_id"), column("class"), column("check"));
    let row = table.records().map(Result::unwrap).find(|row| &row[of_class] == class && &row[of_check] == check);
    (row.expect("a finding")[id].to_owned(), out)
}

fn state(folder: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(format!("{folder}/shrink.json")).unwrap()).unwrap()
}

#[test]
fn a_wrong_sign_among_thousands_is_three_points() {
    let folder = tempdir().unwrap();
    let (id, run_dir) = found(&folder, "families", "/kettner-orient2d$", "naive:first,exact", "sign_flip", "sign");
    let [out, suite] = ["shrunk", "mine.toml"].map(|name| at(&folder, name));
    let told = expect(0, &["shrink", &id, "--run", &run_dir, "--out", &out, "--into", &suite]);
    let state = state(&out);
    assert_eq!((state["after"]["points"].as_u64(), state["end"].as_str()), (Some(3), Some("smallest")), "{state}");
    assert!(state["before"]["points"].as_u64() > Some(1000), "{state}");
    assert!(told.stdout.starts_with("[[scene]]\n"), "{}", told.stdout);
    // The suite has the scene, which shows the finding; the exact backend does not show it.
    let again = at(&folder, "again");
    assert_eq!(run(&["run", &suite, "-b", "naive:first", "-q", "--out", &again]).code, 100);
    let summary = fs::read_to_string(format!("{again}/findings.csv")).unwrap();
    assert!(summary.contains("sign_flip,sign,orient2d(xy; 0 1 2)"), "{summary}");
    expect(0, &["run", &suite, "-b", "exact,sos", "-q", "--out", &at(&folder, "exact")]);
    // Shrinking the same finding again replaces its scene.
    let before = fs::read_to_string(&suite).unwrap();
    expect(0, &["shrink", &id, "--run", &run_dir, "--out", &at(&folder, "two"), "--into", &suite]);
    assert_eq!(fs::read_to_string(&suite).unwrap().matches("[[scene]]").count(), 1);
    // If the user has a scene with its name, that is an error of the suite, which does not change.
    let before = before.replace("source = \"shrunk from", "source = \"seen in").replace("[0.5, 0.5]", "[0.5, 0.25]");
    fs::write(&suite, &before).unwrap();
    let told = expect(104, &["shrink", &id, "--run", &run_dir, "--out", &at(&folder, "three"), "--into", &suite]);
    assert!(told.stderr.contains("mine.toml"), "{}", told.stderr);
    assert_eq!(fs::read_to_string(&suite).unwrap(), before);
    let told = expect(2, &["shrink", &id, "--run", &run_dir, "--out", &out]);
    assert!(told.stderr.contains("--resume"), "{}", told.stderr);
}

#[test]
fn what_runs_out_of_evaluations_goes_on_and_ends_as_well() {
    let folder = tempdir().unwrap();
    let small = write(&folder, "small.toml", SMALL);
    let (id, run_dir) = found(&folder, &small, "/kettner-orient2d$", "naive:first", "sign_flip", "sign");
    let [short, long] = ["short", "long"].map(|name| at(&folder, name));
    let suite = at(&folder, "mine.toml");
    let limit = ["--evaluations", "5", "--into", &suite];
    let told = expect(0, &[&["shrink", &id, "--run", &run_dir, "--out", &short][..], &limit].concat());
    assert!(told.stderr.contains("--resume"), "{}", told.stderr);
    let before = state(&short);
    assert_eq!((before["end"].as_str(), before["evaluations"].as_u64()), (Some("evaluations"), Some(5)));
    // The smallest scene replaces the larger one; other scenes and their comments stay.
    let own = "# mine\n  [[scene]] # by hand\nname = \"own\"\ntask = \"orient2d\"\npoints = [[0, 0], [1, 0], [0, 1]]\nqueries = [[0, 1, 2]]\n\n\
               [[generate]]\nname = \"near\"\nfamily = \"near\"\ntask = \"orient3d\"\nn = 50\nseed = 3\n";
    let larger = fs::read_to_string(&suite).unwrap();
    // The file has Windows line ends and keeps them.
    fs::write(&suite, format!("{larger}\n{own}").replace('\n', "\r\n")).unwrap();
    expect(0, &["shrink", "--resume", &short, "--evaluations", "5000", "--into", &suite]);
    let written = fs::read_to_string(&suite).unwrap();
    let smallest = written.replace("\r\n", "\n");
    assert_eq!(smallest.replace('\n', "\r\n"), written);
    assert!(smallest.matches("[[scene]]").count() == 2 && smallest.contains(own), "{smallest}");
    assert!(smallest.len() < larger.len() + own.len() && smallest.contains(&id), "{smallest}");
    // A larger scene does not replace a smaller one, and the same scene is not added twice under another name.
    let again = at(&folder, "again");
    let told = expect(0, &[&["shrink", &id, "--run", &run_dir, "--out", &again][..], &limit].concat());
    assert!(told.stderr.contains("nothing was added: it already has an equally small scene"), "{}", told.stderr);
    let named = smallest.replace("name = \"orient2d-sign-flip", "name = \"another-sign-flip");
    assert_ne!(named, smallest);
    fs::write(&suite, &named).unwrap();
    let told = expect(0, &["shrink", "--resume", &short, "--into", &suite]);
    assert!(told.stderr.contains("nothing was added: it already has this scene in line"), "{}", told.stderr);
    assert_eq!(fs::read_to_string(&suite).unwrap(), named);
    // A state with another task or without a limit is refused.
    let file = format!("{short}/shrink.json");
    let text = fs::read_to_string(&file).unwrap();
    for (from, to, why) in [
        ("\"task\": \"orient2d\"", "\"task\": \"hull3d\"", "is not of the task `hull3d`"),
        ("\"limit\": 10.0", "\"limit\": -1.0", "`limit` is not a time limit"),
        ("\"class\": \"sign_flip\"", "\"class\": \"flip\"", "no class is called `flip`"),
        ("\"level\": \"quick\"", "\"level\": \"slow\"", "slow"),
        ("\"naive:first\"", "\"nave\"", "no backend is called `nave`"),
    ] {
        fs::write(&file, text.replace(from, to)).unwrap();
        let told = expect(2, &["shrink", "--resume", &short]);
        assert!(told.stderr.contains("shrink.json") && told.stderr.contains(why), "{}", told.stderr);
    }
    fs::write(&file, &text).unwrap();
    let scene = format!("{short}/shrunk.toml");
    let smallest = fs::read_to_string(&scene).unwrap();
    let points = smallest.split("points = ").nth(1).unwrap().split('\n').next().unwrap().to_owned();
    fs::write(&scene, smallest.replace(&points, "[[0, 0], [1, 0], [0, 1]]")).unwrap();
    let told = expect(2, &["shrink", "--resume", &short]);
    assert!(told.stderr.contains(&format!("{scene}: ")) && told.stderr.contains("does not show"), "{}", told.stderr);
    fs::write(&scene, smallest).unwrap();
    expect(0, &["shrink", &id, "--run", &run_dir, "--out", &long]);
    let (short, long) = (state(&short), state(&long));
    assert_eq!((&short["end"], &short["after"]["pieces"]), (&long["end"], &long["after"]["pieces"]), "{short} {long}");
}

#[test]
fn a_second_backend_has_to_show_it_and_another_must_not() {
    let folder = tempdir().unwrap();
    let small = write(&folder, "small.toml", SMALL);
    let (id, run_dir) = found(&folder, &small, "near.*orient3d", "naive,naive:first,shewchuk", "sign_flip", "sign");
    let out = at(&folder, "both");
    // Every intermediate scene shows the finding.
    let evaluations = if predicament_effort::whole() { "5000" } else { "400" };
    let more = ["-b", "naive:first", "--not-by", "shewchuk,exact", "--evaluations", evaluations];
    let args: Vec<&str> = ["shrink", &id, "--run", &run_dir, "--out", &out].into_iter().chain(more).collect();
    expect(0, &args);
    let suite = format!("{out}/shrunk.toml");
    for (backend, code) in [("naive", 100), ("naive:first", 100), ("shewchuk", 0), ("exact", 0)] {
        let name = at(&folder, &backend.replace(':', "-"));
        assert_eq!(run(&["run", &suite, "-b", backend, "-q", "--out", &name]).code, code, "{backend}");
    }
    // A backend can't show a finding and not show it.
    let told = expect(2, &["shrink", &id, "--run", &run_dir, "--out", &at(&folder, "none"), "--not-by", "naive"]);
    assert!(told.stderr.contains("does not show the finding"), "{}", told.stderr);
    assert!(!std::path::Path::new(&at(&folder, "none")).exists(), "no empty folder is left");
}

#[test]
fn the_first_of_each_class_are_shrunk_after_a_run() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "run");
    let args = [
        "run",
        &write(&folder, "small.toml", SMALL),
        "-f",
        "/kettner-orient2d$",
        "-b",
        "naive:first,exact",
        "-q",
        "--out",
        &out,
        "--shrink",
        "1",
        "--expected",
        &write(&folder, "none.toml", ""),
    ];
    let told = run(&args);
    assert_eq!(told.code, 100, "{}", told.stderr);
    assert!(told.stdout.contains("shrunk.toml"), "{}\n{}", told.stdout, told.stderr);
    let suite = format!("{out}/shrunk/shrunk.toml");
    let text = fs::read_to_string(&suite).unwrap();
    let scenes = text.matches("[[scene]]").count();
    assert!(scenes >= 2 && text.contains("sign_flip") && text.contains("overreach"), "{text}");
    expect(0, &["corpus", "verify", &suite]);
    // A complete run still shrinks its findings, also if it was stopped while shrinking.
    fs::remove_dir_all(format!("{out}/shrunk")).unwrap();
    expect(100, &["run", "--resume", &out, "--shrink", "1"]);
    assert_eq!(fs::read_to_string(&suite).unwrap(), text);
    // The tests exist, with exact bits in Rust and hex floats in C++ and Python.
    let one = fs::read_dir(format!("{out}/shrunk")).unwrap().map(|entry| entry.unwrap().path());
    let one = one.into_iter().find(|path| path.is_dir()).unwrap();
    for (file, words) in [
        ("shrunk.rs", ["#[test]", "f64::from_bits(0x"]),
        ("shrunk.cpp", ["const double a[] = {", "0x1."]),
        ("shrunk.py", ["def test_", "h(\"0x1."]),
        ("shrunk.mjs", ["test(\"", "const a = ["]),
    ] {
        let text = fs::read_to_string(one.join(file)).unwrap();
        assert!(words.iter().all(|word| text.contains(word)), "{text}");
    }
}

/// In C++, constructed vertices are numbered after the points; both languages explain them.
#[test]
fn tests_of_constructed_vertices_have_their_definitions() {
    let folder = tempdir().unwrap();
    let [run_dir, out] = ["run", "shrunk"].map(|name| at(&folder, name));
    run(&["run", "constructed", "-f", "/kite$", "-b", "naive", "-q", "--out", &run_dir]);
    let findings = fs::read_to_string(format!("{run_dir}/findings.csv")).unwrap();
    let row = findings.lines().find(|line| line.contains("naive,missed_zero,sign")).expect("a finding");
    expect(0, &["shrink", row.split(',').next().unwrap(), "--run", &run_dir, "--out", &out]);
    let cpp = fs::read_to_string(format!("{out}/shrunk.cpp")).unwrap();
    for words in ["    enum { c0 = 6 };", "queries[][3] = {{0, 1, c0}};", "// plane = \"xy\"", "// c0 = SSI(2 3, 4 5)"]
    {
        assert!(cpp.contains(words), "{words}: {cpp}");
    }
    let python = fs::read_to_string(format!("{out}/shrunk.py")).unwrap();
    for words in ["queries = [[0, 1, \"c0\"]]", "# plane = \"xy\"", "# c0 = SSI(2 3, 4 5)"] {
        assert!(python.contains(words), "{words}: {python}");
    }
}

/// The generated tests run if there is Python, and fail for doubles.
#[test]
fn the_test_in_python_is_right() {
    let folder = tempdir().unwrap();
    let small = write(&folder, "small.toml", SMALL);
    let (id, run_dir) = found(&folder, &small, "/kettner-orient2d$", "naive:first", "sign_flip", "sign");
    let out = at(&folder, "shrunk");
    expect(0, &["shrink", &id, "--run", &run_dir, "--out", &out]);
    let text = fs::read_to_string(format!("{out}/shrunk.py")).unwrap();
    let name = text.lines().find_map(|line| line.strip_prefix("def ")).unwrap().trim_end_matches(':').to_owned();
    let exact = "from fractions import Fraction as F\ndef orient2d(a, b, c):\n    a, b, c = [[F(x) for x in p] for p in (a, b, c)]\n    \
                 return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])\n";
    let python = |predicate: &str| {
        let script = format!("{predicate}{text}\n{name}\n");
        std::process::Command::new("python3").args(["-c", &script]).output()
    };
    let Ok(right) = python(exact) else {
        eprintln!("no python3: its test was not run");
        return;
    };
    assert!(right.status.success(), "{}", String::from_utf8_lossy(&right.stderr));
    let doubles = exact.replace("F(x) for", "float(x) for");
    assert!(!python(&doubles).unwrap().status.success(), "{text}");
    // The tool itself runs.
    assert!(tool(&["--version"]).output().unwrap().status.success());
}
