//! `engines new`: what it writes and refuses; and for each language an engine that is built, greeted and judged by the
//! commands that it prints. Those tests need the language's program: `cargo xtask test` runs them where it is.

use std::path::{Path, PathBuf};

use crate::common::{Told, told, tool};
use crate::engines::agrees_in;
use predicament_effort::some_or_all;
use tempfile::{TempDir, tempdir};

const LANGUAGES: [&str; 4] = ["python", "cpp", "rust", "node"];

/// Calls the tool in a folder that has the engines, as a user who has set no variable.
fn call(folder: &Path, args: &[&str]) -> Told {
    told(tool(args).current_dir(folder).env_remove("PREDICAMENT_ENGINES").output().unwrap())
}

/// Writes the engine `mine` of a language; what the tool prints.
fn new(folder: &TempDir, language: &str) -> String {
    let new = call(folder.path(), &["engines", "new", "mine", "--language", language]);
    assert_eq!(new.code, 0, "{language}: {}", new.stderr);
    new.stdout
}

/// A new engine works as it says: the two commands that it prints, and the commands of its page in its own folder. It
/// answers all five predicates as `naive` does, right and wrong.
fn goes_as_it_says(language: &str) {
    let folder = tempdir().unwrap();
    let printed = new(&folder, language);
    let own = folder.path().join("engines/mine");
    let page = std::fs::read_to_string(own.join("README.md")).unwrap();
    // By default the page's commands alone: the printed ones differ from them in the folder.
    let both = [(&page, &*own), (&printed, folder.path())];
    for (text, place) in both.into_iter().take(some_or_all(1, 2)) {
        let commands = text.lines().filter_map(|line| line.trim_start().strip_prefix("predicament "));
        let commands: Vec<Vec<String>> = commands.map(words).collect();
        assert_eq!(commands.len(), 2, "{text}");
        // Beside the engine the run would be one of its files.
        let out = folder.path().join(format!("run-{}", place.components().count())).display().to_string();
        for (command, code, more) in [(&commands[0], 0, &[][..]), (&commands[1], 100, &["--out", &out])] {
            let command: Vec<&str> = command.iter().map(String::as_str).chain(more.iter().copied()).collect();
            let went = call(place, &command);
            assert_eq!(went.code, code, "{language}: {command:?}: {}{}", went.stdout, went.stderr);
        }
    }
    let checked = call(folder.path(), &["engines", "check", "mine"]);
    let offers = "-b engine:mine: version 1.0; compare, orient2d, orient3d, incircle, insphere; zero is zero";
    assert!(checked.code == 0 && checked.stdout.contains(offers), "{}{}", checked.stdout, checked.stderr);
    let families = some_or_all("near|wide-mixed", "uniform|grid|near|kettner|wide-mixed");
    let filter = &format!("/({families})-(compare|orient2d|orient3d|incircle|insphere)");
    agrees_in(&folder.path().join("engines"), "mine", "naive", filter);
}

/// The words of a command that a page shows: none has a blank in it.
fn words(line: &str) -> Vec<String> {
    line.split(' ').map(|word| word.trim_matches('\'').to_owned()).collect()
}

#[test]
#[ignore = "needs Python"]
fn a_new_engine_in_python_goes_as_it_says() {
    goes_as_it_says("python");
}

#[test]
#[ignore = "needs a C++ compiler"]
fn a_new_engine_in_cpp_goes_as_it_says() {
    goes_as_it_says("cpp");
}

#[test]
#[ignore = "needs cargo, and no registry"]
fn a_new_engine_in_rust_goes_as_it_says() {
    goes_as_it_says("rust");
}

#[test]
#[ignore = "needs Node"]
fn a_new_engine_in_node_goes_as_it_says() {
    goes_as_it_says("node");
}

/// Another sign is seen: the comparison with `naive` can fail.
#[test]
#[ignore = "needs Python"]
#[should_panic(expected = "assertion `left == right` failed")]
fn a_new_engine_in_python_that_differs_is_seen() {
    let folder = tempdir().unwrap();
    new(&folder, "python");
    let source = folder.path().join("engines/mine/engine.py");
    let text = std::fs::read_to_string(&source).unwrap();
    let other = text.replace("return a[axis] - b[axis]", "return b[axis] - a[axis]");
    assert!(text != other, "the predicate is there");
    std::fs::write(&source, other).unwrap();
    agrees_in(
        &folder.path().join("engines"),
        "mine",
        "naive",
        "/(uniform|grid|near|kettner|wide-mixed)-(compare|orient2d)",
    );
}

/// A file of the repository's engines and what a new engine calls it.
fn helpers(language: &str) -> Vec<(&'static str, &'static str)> {
    match language {
        "python" => vec![("python/predicament_engine.py", "predicament_engine.py")],
        "cpp" => vec![("include/predicament_engine.hpp", "predicament_engine.hpp")],
        "node" => vec![("node/predicament_engine.mjs", "predicament_engine.mjs")],
        _ => vec![
            ("rust/src/lib.rs", "predicament_engine/mod.rs"),
            ("rust/src/message.rs", "predicament_engine/message.rs"),
            ("rust/src/server.rs", "predicament_engine/server.rs"),
            ("rust/src/tasks.rs", "predicament_engine/tasks.rs"),
        ],
    }
}

/// The helpers in the binary are those of the repository, byte for byte. (A checkout without links would embed paths.)
#[test]
fn helpers_are_written_as_they_are() {
    let engines = Path::new(env!("CARGO_MANIFEST_DIR")).join("../engines");
    for language in LANGUAGES {
        let folder = tempdir().unwrap();
        new(&folder, language);
        for (ours, theirs) in helpers(language) {
            let [ours, theirs] =
                [engines.join(ours), folder.path().join("engines/mine").join(theirs)].map(|path| read(&path));
            assert!(ours == theirs, "{language}: another helper");
        }
    }
}

/// No template has a word left to be filled in, and each page has ten lines.
#[test]
fn templates_are_filled() {
    for language in LANGUAGES {
        let folder = tempdir().unwrap();
        let printed = new(&folder, language);
        let own = folder.path().join("engines/mine");
        assert!(printed.starts_with("engines/mine: written: "), "{printed}");
        assert_eq!(read(&own.join("README.md")).lines().count(), 10, "{language}");
        let helpers: Vec<PathBuf> = helpers(language).iter().map(|(_, path)| own.join(path)).collect();
        let mut seen = 0;
        for path in files(&own).into_iter().filter(|path| !helpers.contains(path)) {
            let text = read(&path);
            for word in ["{name}", "{program}", "{language}", "{source}", "{helper}", "{first}", "{next}"] {
                assert!(!text.contains(word), "{}: {word}", path.display());
            }
            seen += usize::from(text.contains("mine"));
        }
        assert_eq!(seen, 3, "the name is in the page, the configuration and the source");
    }
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|why| panic!("{}: {why}", path.display()))
}

/// All files in a folder, and in those in it.
fn files(folder: &Path) -> Vec<PathBuf> {
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    paths.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
}

#[test]
fn a_folder_that_is_there_is_not_touched() {
    let folder = tempdir().unwrap();
    new(&folder, "python");
    let before = read(&folder.path().join("engines/mine/engine.py"));
    for language in LANGUAGES {
        let again = call(folder.path(), &["engines", "new", "mine", "--language", language]);
        let said = "engines/mine: the folder is there; name another engine, or another folder with --out";
        assert!(again.code == 2 && again.stderr.contains(said), "{}", again.stderr);
    }
    assert_eq!(files(&folder.path().join("engines/mine")).len(), 4);
    assert_eq!(before, read(&folder.path().join("engines/mine/engine.py")));
    std::fs::write(folder.path().join("file"), "").unwrap();
    let within = call(folder.path(), &["engines", "new", "mine", "--language", "cpp", "--out", "file/mine"]);
    assert!(within.code == 2 && within.stderr.contains("file: "), "{}", within.stderr);
}

#[test]
fn names_and_languages_that_are_none_are_refused() {
    let folder = tempdir().unwrap();
    let long = "x".repeat(65);
    let rule = "is not a valid name of an engine; use up to 64 letters, digits, `-`, `_` and `.`, a letter or digit \
                first";
    for (name, said) in [
        ("../mine", rule),
        ("a/b", rule),
        ("a b", rule),
        ("..", rule),
        (".mine", rule),
        ("a\"b", rule),
        (&long, rule),
        ("mine.toml", "-b would take the engine `mine.toml` for a file; name it `mine`"),
    ] {
        let refused = call(folder.path(), &["engines", "new", name, "--language", "cpp"]);
        assert!(refused.code == 2 && refused.stderr.contains(said), "{name}: {}", refused.stderr);
    }
    let refused = call(folder.path(), &["engines", "new", "mine", "--language", "fortran"]);
    assert!(refused.code == 2 && refused.stderr.contains("[possible values: python, cpp, rust, node]"));
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0, "nothing is written");
}

#[test]
fn an_engine_goes_where_it_is_told() {
    let folder = tempdir().unwrap();
    let out = call(folder.path(), &["engines", "new", "mine", "--language", "node", "--out", "my tools/mine"]);
    let run = "  predicament run families -f 'near.*orient2d' -b 'engine:my tools/mine/engine.toml,exact'\n";
    assert!(out.code == 0 && out.stdout.ends_with(run), "{}{}", out.stdout, out.stderr);
    assert!(folder.path().join("my tools/mine/engine.mjs").is_file());
    let mut variable = tool(&["engines", "new", "mine.2", "--language", "c++"]);
    variable.current_dir(&folder).env("PREDICAMENT_ENGINES", "of all projects");
    let variable = told(variable.output().unwrap());
    assert!(variable.stdout.contains("\n  predicament engines build mine.2\n"), "{}", variable.stdout);
    assert!(folder.path().join("of all projects/mine.2/engine.cpp").is_file());
}

/// A folder without engines says how to make the first one.
#[test]
fn a_folder_without_engines_says_how_to_begin() {
    let folder = tempdir().unwrap();
    let none = call(folder.path(), &["engines"]);
    let said = "engines has no engines; `predicament engines new NAME --language LANGUAGE` writes one there";
    assert!(none.code == 4 && none.stderr.contains(said), "{}", none.stderr);
}

#[test]
#[ignore = "needs Python"]
fn a_new_engine_of_a_task_in_python_is_judged_on_the_scenes_of_the_task() {
    tasks_are_judged("python");
}

#[test]
#[ignore = "needs Node"]
fn a_new_engine_of_a_task_in_node_is_judged_on_the_scenes_of_the_task() {
    tasks_are_judged("node");
}

#[test]
#[ignore = "needs a C++ compiler"]
fn a_new_engine_of_a_task_in_cpp_is_judged_on_the_scenes_of_the_task() {
    tasks_are_judged("cpp");
}

#[test]
#[ignore = "needs cargo, and no registry"]
fn a_new_engine_of_a_task_in_rust_is_judged_on_the_scenes_of_the_task() {
    tasks_are_judged("rust");
}

fn tasks_are_judged(language: &str) {
    let folder = tempdir().unwrap();
    let all = [
        "overlay2d",
        "mesh-intersect",
        "delaunay2d",
        "hull2d",
        "hull3d",
        "triangulate",
        "polygon-locate",
        "mesh-locate",
        "mesh-rays",
        "distance",
        "contacts2d",
        "contacts3d",
        "crossings",
        "interval",
        "cube-union",
        "slice",
        "snap2d",
    ];
    for task in &all[..some_or_all(if language == "python" { 3 } else { 1 }, all.len())] {
        let new = call(folder.path(), &["engines", "new", task, "--language", language, "--task", task]);
        assert_eq!(new.code, 0, "{task}: {}", new.stderr);
        let built = call(folder.path(), &["engines", "build", task]);
        assert_eq!(built.code, 0, "{language}: {task}: {}{}", built.stdout, built.stderr);
        let checked = call(folder.path(), &["engines", "check", task]);
        assert!(checked.code == 0 && checked.stdout.contains(&format!("tasks {task}")), "{task}: {}", checked.stdout);
        let run = new.stdout.lines().last().unwrap().trim();
        let words: Vec<&str> = run.split(' ').skip(1).chain(["--out", task]).collect();
        let told = call(folder.path(), &words);
        // Plain doubles are right about cells of a line.
        assert_eq!(told.code, if *task == "interval" { 0 } else { 100 }, "{run}: {}", told.stderr);
        let summary = std::fs::read_to_string(folder.path().join(task).join("summary.csv")).unwrap();
        let header: Vec<&str> = summary.lines().next().unwrap().split(',').collect();
        let column = |name: &str| header.iter().position(|of| *of == name).unwrap();
        let rows = summary.lines().filter(|line| line.contains(&format!(",{task},engine:{task},")));
        let rows: Vec<Vec<&str>> = rows.map(|line| line.split(',').collect()).collect();
        let right = rows.iter().filter(|row| row.last() == Some(&"ok")).count();
        assert!(right > 0, "{task}: some answers are right, of {}", rows.len());
        assert!(rows.iter().all(|row| row[column("timeout")] == "0"), "{task}: nothing takes long");
    }
    let refused = call(folder.path(), &["engines", "new", "x", "--language", language, "--task", "hull4d"]);
    assert!(refused.code == 2 && refused.stderr.contains("hull2d"), "{}", refused.stderr);
}
