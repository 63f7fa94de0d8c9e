//! The example engines, built and run as their pages say. They need a C++ compiler, Python and a crate. `cargo xtask
//! test` runs these tests if it finds them, and otherwise says that it does not.

use std::path::Path;

use crate::common::{SUITE, at, column, expect, read, run, tool, unsealed, write};
use tempfile::tempdir;

/// Asserts that an engine that computes like `naive` has the same rows as `naive`, except for its name. (The engine
/// expands orient3d in another order, which makes no difference far from ties.)
fn agrees_with_naive(engine: &str) {
    let filter = "/(uniform|grid|near|kettner|wide-mixed)-(compare|orient2d|incircle)|/(uniform|grid)-orient3d";
    agrees(engine, "naive", filter);
}

/// Asserts that an engine has the same rows as a backend in these scenes, except for its name.
fn agrees(engine: &str, backend: &str, filter: &str) {
    agrees_in(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../engines")), engine, backend, filter);
}

/// An engine of this folder has the same rows as a backend in these scenes, but for its name.
pub fn agrees_in(engines: &Path, engine: &str, backend: &str, filter: &str) {
    let folder = tempdir().unwrap();
    let call = |args: &[&str]| {
        let output = tool(args).env("PREDICAMENT_ENGINES", engines).output().unwrap();
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        (output.status.code(), text(output.stdout) + &text(output.stderr))
    };
    let built = call(&["engines", "build", engine]);
    assert_eq!(built.0, Some(0), "{}", built.1);
    let out = at(&folder, "run");
    let backends = format!("{backend},engine:{engine}");
    let ran = call(&["run", "families", "-f", filter, "-b", &backends, "--out", &out]);
    assert_eq!(ran.0, Some(100), "its mistakes are expected of nobody: {}", ran.1);
    let summary = read(&out, "summary.csv");
    // Compare the columns between the backend and the status.
    let rows = |backend: &str| -> Vec<String> {
        let of = summary.lines().filter(|line| line.split(',').nth(4) == Some(backend));
        of.map(|line| line.replace(backend, "").rsplit_once(',').unwrap().0.to_owned()).collect()
    };
    let (ours, theirs) = (rows(backend), rows(&format!("engine:{engine}")));
    assert!(ours.len() >= 10, "{summary}");
    assert_eq!(ours, theirs);
    let findings = read(&out, "findings.csv");
    assert!(findings.lines().any(|line| line.contains(&format!("engine:{engine}"))), "{findings}");
}

/// Writes an engine in Python whose `orient2d` is this line.
fn python(folder: &tempfile::TempDir, name: &str, orient2d: &str) -> String {
    let helper = concat!(env!("CARGO_MANIFEST_DIR"), "/../engines/python");
    let engine = format!(
        "import sys\nsys.path.insert(0, {helper:?})\nimport predicament_engine\nclass Mine:\n  name = 'mine'\n  \
         version = '1'\n  zero = 'exact'\n  def orient2d(self, a, b, c):\n    {orient2d}\n\
         predicament_engine.serve(Mine())\n"
    );
    std::fs::create_dir(folder.path().join(name)).unwrap();
    write(folder, &format!("{name}/{name}.py"), &engine);
    let config = format!("name = \"mine\"\nrun = [\"python3\", \"{name}.py\"]\n");
    write(folder, &format!("{name}/engine.toml"), &config)
}

const DETERMINANT: &str = "return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])";

#[test]
#[ignore = "needs Python"]
fn an_engine_in_python_is_found_again_by_its_file() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    python(&folder, "here", DETERMINANT);
    let out = at(&folder, "run");
    let call = |args: &[&str]| {
        let told = crate::common::told(tool(args).current_dir(&folder).output().unwrap());
        (told.code, told.stdout + &told.stderr)
    };
    let (code, told) = call(&["run", &suite, "-b", "engine:here/engine.toml,exact", "--out", "run"]);
    assert_eq!(code, 100, "{told}");
    let id = &column(&read(&out, "findings.csv"), "finding_id")[0];
    // Run from another folder, with the engine named: reading a run folder never starts a program.
    let here = format!("mine={}", at(&folder, "here/engine.toml"));
    let refused = expect(2, &["replay", id, "--run", &out, "-b", "exact"]).stderr;
    assert!(refused.contains(&format!("add --engine {here}")), "{refused}");
    let replayed = expect(0, &["replay", id, "--run", &out, "-b", "exact", "--engine", &here]);
    assert!(replayed.stdout.contains("engine:mine"), "{}", replayed.stdout);
    let (code, told) = call(&["run", &suite, "-b", "engine:here/engine.toml", "--isolate", "--out", "apart"]);
    assert_eq!(code, 100, "{told}");
    let rows = |run: &str| read(&at(&folder, run), "summary.csv").lines().filter(|l| l.contains("mine,e")).count();
    assert_eq!(column(&read(&at(&folder, "apart"), "summary.csv"), "overreach"), ["1", "0"], "{}", rows("apart"));
    // Make a run that was interrupted before it began.
    crate::common::rewrite(&out, "summary.csv", &format!("{}\n", read(&out, "summary.csv").lines().next().unwrap()));
    write(&folder, "run/state.json", &unsealed(&out, "state.json").replace("complete", "interrupted"));
    let resumed = crate::common::run(&["run", "--resume", &out, "--engine", &here]);
    assert_eq!(resumed.code, 100, "{}", resumed.stderr);
    // An engine with another version or another name is another engine.
    write(&folder, "run/state.json", &unsealed(&out, "state.json").replace("complete", "interrupted"));
    for (file, from, to, why) in [
        (
            "here.py",
            "version = '1'",
            "version = '2'",
            "the version of engine:mine was `1` when the run was begun, and is `2` now",
        ),
        (
            "engine.toml",
            "\"mine\"",
            "\"other\"",
            "the engine there is called `other`; use that name, or change it back",
        ),
    ] {
        let file = format!("here/{file}");
        let before = std::fs::read_to_string(at(&folder, &file)).unwrap();
        write(&folder, &file, &before.replace(from, to));
        let refused = expect(2, &["run", "--resume", &out, "--engine", &here]).stderr;
        assert!(refused.contains(why), "{refused}");
        write(&folder, &file, &before);
    }
    assert_eq!(
        crate::common::run(&["run", "--resume", &out, "--engine", &here]).code,
        100,
        "with the engine that it was begun with"
    );
    // Two engines with one name are two backends.
    python(&folder, "there", DETERMINANT);
    let (code, told) = call(&["run", &suite, "-b", "engine:here/engine.toml,engine:there/engine.toml", "--out", "two"]);
    assert!(code == 2 && told.contains("two engines are called `engine:mine`"), "{told}");
}

#[test]
#[ignore = "needs Python"]
#[cfg(target_os = "linux")]
fn an_engine_in_python_that_loops_ends_with_its_worker() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let engine = python(&folder, "endless", "while True: pass");
    let out = at(&folder, "run");
    let backend = format!("engine:{engine}");
    // A time limit is enough to run it in a separate process.
    let told = crate::common::run(&["run", &suite, "-b", &backend, "--timeout", "0.5", "--out", &out]);
    assert_eq!(told.code, 103, "{}", told.stderr);
    assert_eq!(column(&read(&out, "summary.csv"), "timeout"), ["1", "1"]);
    let place = folder.path().join("endless");
    let runs_there = |entry: &std::path::PathBuf| std::fs::read_link(entry.join("cwd")).is_ok_and(|cwd| cwd == place);
    let left = std::fs::read_dir("/proc").unwrap().flatten().map(|entry| entry.path()).filter(runs_there).count();
    assert_eq!(left, 0, "processes that loop for ever");
}

#[test]
#[ignore = "needs a C++ compiler"]
fn what_a_library_prints_in_cpp_before_main_spoils_nothing() {
    let folder = tempdir().unwrap();
    let engine = "#include <predicament_engine.hpp>\nconst int loud = std::printf(\"a banner\\n\");\n\
        struct Mine {\n  static constexpr const char* name = \"loud\";\n  \
        static constexpr predicament::Zero zero = predicament::Zero::exact;\n  \
        static std::string version() { return \"1\"; }\n  \
        static double compare(int axis, const double* a, const double* b) { return a[axis] - b[axis]; }\n};\n\
        int main(int argc, char** argv) { return predicament::serve<Mine>(argc, argv); }\n";
    write(&folder, "engine.cpp", engine);
    let include = concat!(env!("CARGO_MANIFEST_DIR"), "/../engines/include");
    let build = format!("[\"c++\", \"-std=c++17\", \"-I\", {include:?}, \"engine.cpp\", \"-o\", \"engine\"]");
    let config = write(&folder, "engine.toml", &format!("name = \"loud\"\nbuild = [{build}]\nrun = [\"./engine\"]\n"));
    expect(0, &["engines", "build", &config]);
    let checked = expect(0, &["engines", "check", &config]);
    assert!(checked.stdout.contains("engine:loud: version 1; compare"), "{}", checked.stdout);
}

#[test]
#[ignore = "needs a C++ compiler"]
fn the_example_in_cpp_is_built_and_judged() {
    agrees_with_naive("naive-cpp");
}

#[test]
#[ignore = "needs Python"]
fn the_example_in_python_is_judged() {
    agrees_with_naive("naive-python");
}

/// The backend `shewchuk` uses the same crate, in this process.
#[test]
#[ignore = "needs a crate from the registry"]
fn the_example_in_rust_is_built_and_judged() {
    agrees("robust", "shewchuk", "/(uniform|grid|near|kettner|wide-mixed)-(orient2d|orient3d|incircle|insphere)");
}

/// A copy of the Python example and its helper in a folder with this name; returns the path of its configuration.
fn copied(folder: &tempfile::TempDir, name: &str) -> String {
    let engines = Path::new(env!("CARGO_MANIFEST_DIR")).join("../engines");
    for (from, to) in [("python", "python"), ("naive-python", name)] {
        let to = folder.path().join(to);
        std::fs::create_dir_all(&to).unwrap();
        for file in std::fs::read_dir(engines.join(from)).unwrap().map(|entry| entry.unwrap().path()) {
            if file.is_file() {
                std::fs::copy(&file, to.join(file.file_name().unwrap())).unwrap();
            }
        }
    }
    at(folder, &format!("{name}/engine.toml"))
}

#[test]
#[ignore = "needs Python"]
fn an_engine_in_python_by_path_is_found_again() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let (one, two) = (copied(&folder, "mine"), copied(&folder, "another"));
    let (out, apart) = (at(&folder, "run"), at(&folder, "apart"));
    let backends = format!("exact,engine:{one}");
    expect(100, &["run", &suite, "-b", &backends, "--out", &out]);
    let id = column(&read(&out, "findings.csv"), "finding_id")[0].clone();
    let named = format!("naive-python={one}");
    for more in [
        &["--engine", &named][..],
        &["-b", "engine:naive-python,exact", "--engine", &named],
        &["-b", &format!("engine:{two}")],
    ] {
        let told = run(&[&["replay", &id, "--run", &out], more].concat());
        assert!(
            told.code == 0 && told.stdout.contains("engine:naive-python"),
            "{more:?}: {}{}",
            told.stdout,
            told.stderr
        );
    }
    let late = at(&folder, "late");
    expect(103, &["run", &suite, "-b", &backends, "--timeout", "1e-9", "--out", &late]);
    let resumed = run(&["run", "--resume", &late, "--engine", &named]);
    assert!(resumed.stdout.contains("timeout"), "{}{}", resumed.stdout, resumed.stderr);
    expect(100, &["run", &suite, "-b", &backends, "--isolate", "--out", &apart]);
    crate::common::assert_same_tables(&out, &apart, "in a process of its own");
    // Rows of two engines with one name would be ambiguous.
    let both = format!("engine:{one},engine:{two}");
    let refused = expect(2, &["run", &suite, "-b", &both, "--out", &at(&folder, "both")]);
    assert!(refused.stderr.contains("two engines are called `engine:naive-python`: "), "{}", refused.stderr);
    let in_folder = |args: &[&str]| tool(args).env("PREDICAMENT_ENGINES", folder.path()).output().unwrap();
    let refused = in_folder(&["run", &suite, "-b", "engine:mine", "--out", &at(&folder, "named")]);
    let said = String::from_utf8(refused.stderr).unwrap();
    assert!(
        refused.status.code() == Some(2) && said.contains("is called `naive-python`; give it the name of its folder"),
        "{said}"
    );
}

/// An engine with the name of a backend is a different backend everywhere.
#[test]
#[ignore = "needs Python"]
fn an_engine_in_python_called_as_a_backend_is_told_apart() {
    let folder = tempdir().unwrap();
    let engine = copied(&folder, "exact");
    let text = std::fs::read_to_string(&engine).unwrap().replace("\"naive-python\"", "\"exact\"");
    std::fs::write(&engine, text).unwrap();
    let (suite, out) = (write(&folder, "mine.toml", SUITE), at(&folder, "run"));
    let known = "[[expect]]\nscene = \"*\"\nbackend = \"exact\"\nclass = \"overreach\"\nreason = \"of the other\"\n";
    let known = write(&folder, "known.toml", known);
    let backends = format!("exact,engine:{engine}");
    expect(100, &["run", &suite, "-b", &backends, "--expected", &known, "--out", &out]);
    let rows = read(&out, "summary.csv");
    assert_eq!(column(&rows, "backend"), ["exact", "engine:exact", "exact", "engine:exact"]);
    assert_eq!(column(&rows, "overreach"), ["0", "1", "0", "0"]);
    assert_eq!(column(&rows, "status"), ["unexpected_pass", "unexpected", "unexpected_pass", "ok"]);
}
