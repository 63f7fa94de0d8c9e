//! Every file under `bad/` fails with exactly the error in its first line: file, line, problem and fix.

use std::path::{Path, PathBuf};

use predicament_corpus::{Level, Library, Suite};
use predicament_formats::{Cache, CorpusError, ErrorKind, Manifest};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/bad")
}

/// Parses and loads a suite as `run` would.
fn load(name: &str, text: &str, cache: &Cache) -> Result<(), CorpusError> {
    let suite = Suite::parse(predicament_bundle::vocabulary(), name, text, Some(&folder()), &Manifest::default())?;
    suite.scenes.iter().try_for_each(|scene| scene.load(Level::Quick, cache).map(drop))
}

/// The names of all tasks, in the order of messages.
fn tasks() -> String {
    predicament_bundle::vocabulary().names().collect::<Vec<_>>().join(", ")
}

/// The names of all families, each at its first occurrence.
fn families() -> String {
    let mut names: Vec<&str> = Vec::new();
    for family in predicament_bundle::vocabulary().tasks().iter().flat_map(|task| task.families()) {
        if !names.contains(&family.name) {
            names.push(family.name);
        }
    }
    names.join(", ")
}

#[test]
fn every_bad_file_says_where_what_and_what_to_do() {
    let cache = Cache::new(folder().join("no-cache"));
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder()).unwrap().map(|file| file.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    files.sort();
    assert!(files.len() > 40, "the bad files are gone");
    let mut wrong = Vec::new();
    for path in files {
        let name = path.file_name().unwrap().to_str().unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        let expected = text.lines().next().unwrap().trim_start_matches("# ");
        let expected = expected.replace("{families}", &families()).replace("{tasks}", &tasks());
        let got = match load(name, &text, &cache) {
            Ok(()) => "no error".to_owned(),
            Err(error) => {
                assert_eq!(error.kind, ErrorKind::Corpus, "{name}");
                error.to_string().replace(&format!("{}/", folder().display()), "")
            }
        };
        if got != expected {
            wrong.push(format!("{name}\n  expected {expected}\n  got      {got}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_good_file_has_no_error() {
    let text = std::fs::read_to_string(folder().join("nan.toml")).unwrap().replace("nan]", "0.25]");
    load("good.toml", &text, &Cache::new(folder())).unwrap();
}

#[test]
fn the_same_scene_in_two_suites_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let suite = "title = \"t\"\n[[scene]]\nname = \"a\"\ntask = \"compare\"\npoints = [[0, 0], [1, 1]]\n";
    std::fs::write(folder.path().join("one.toml"), suite).unwrap();
    let generated = "[[generate]]\nfamily = \"grid\"\ntask = \"compare\"\nn = 5\n";
    std::fs::write(folder.path().join("three.toml"), format!("title = \"t\"\n{generated}")).unwrap();
    Library::from_dir(predicament_bundle::vocabulary(), folder.path()).unwrap();
    std::fs::write(folder.path().join("two.toml"), suite.replace("\"a\"", "\"b\"")).unwrap();
    let error = Library::from_dir(predicament_bundle::vocabulary(), folder.path()).unwrap_err();
    assert_eq!(error.line(), Some(2));
    assert!(error.to_string().contains("two.toml:2: scene `two/b` has the same content as `one/a`"), "{error}");

    // Generated scenes are compared after they are loaded.
    std::fs::write(folder.path().join("two.toml"), format!("title = \"t\"\n{generated}name = \"again\"\n")).unwrap();
    let library = Library::from_dir(predicament_bundle::vocabulary(), folder.path()).unwrap();
    let error = library.verify(Level::Quick, &Cache::new(folder.path()), |_| ()).unwrap_err();
    assert!(error.to_string().contains("two.toml:2: scene `two/again` has the same content"), "{error}");
}

#[test]
fn what_is_not_there_is_a_usage_error() {
    let library = Library::embedded(predicament_bundle::vocabulary()).unwrap();
    let error = library.suite("clasics").unwrap_err();
    assert_eq!(error.kind, ErrorKind::Usage);
    assert!(
        error
            .to_string()
            .starts_with("clasics: no suite has this name; did you mean `classics`? use one of bands, classics"),
        "{error}"
    );
    assert_eq!(library.suite("no/such/file.toml").unwrap_err().kind, ErrorKind::Usage);
    assert_eq!(
        Library::from_dir(predicament_bundle::vocabulary(), Path::new("/no/such/folder")).unwrap_err().kind,
        ErrorKind::Usage
    );
}

#[test]
fn data_that_was_not_fetched_is_an_error_that_says_how() {
    let library = Library::embedded(predicament_bundle::vocabulary()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    for suite in library.suites().unwrap().iter().filter(|suite| suite.needs_fetch) {
        let error = suite.scenes[0].load(Level::Quick, &Cache::new(folder.path())).unwrap_err();
        assert_eq!(error.kind, ErrorKind::Corpus);
        assert!(error.to_string().ends_with("has not been fetched; run `predicament corpus fetch`"), "{error}");
    }
}
