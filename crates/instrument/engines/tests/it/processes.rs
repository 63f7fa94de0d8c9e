//! The limits of an engine's processes, and the removal of all processes left behind.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use predicament_engines::{Config, Engine};
use predicament_predicates::{Backend, Broken, Off};
use tempfile::TempDir;

use crate::{ask, config, scene};

/// The configuration of an engine that leaves a process behind in this way, with a file for the process id.
fn leaving(folder: &TempDir, way: &str) -> Config {
    let mut config = config(folder.path(), way).unwrap();
    let file = folder.path().join("left").display().to_string();
    config.environment.insert("LEFT_BEHIND".to_owned(), file);
    config
}

/// The id of the process that was left behind.
fn left(folder: &TempDir) -> String {
    std::fs::read_to_string(folder.path().join("left")).unwrap().trim().to_owned()
}

/// True if a process runs; a zombie does not run.
fn runs(process: &str) -> bool {
    let stat = std::fs::read_to_string(Path::new("/proc").join(process).join("stat"));
    stat.is_ok_and(|stat| !stat.contains(") Z "))
}

#[test]
fn a_process_with_a_session_of_its_own_ends_with_its_engine_and_with_no_other() {
    for way in ["leaves a child", "leaves a stranger", "leaves an orphan"] {
        let folders = [(); 2].map(|()| tempfile::tempdir().unwrap());
        let [one, other] = folders.each_ref().map(|folder| Engine::start(leaving(folder, way)).unwrap());
        let [of_one, of_other] = folders.each_ref().map(left);
        assert!(runs(&of_one) && runs(&of_other), "{way}");
        drop(one);
        assert!(!runs(&of_one) && runs(&of_other), "{way}: only that of the engine that ended");
        let scene = scene();
        ask(&other.prepare(&scene, Off).unwrap());
        drop(other);
        assert!(!runs(&of_other), "{way}");
        // No zombie is left.
        assert!(!Path::new("/proc").join(&of_other).exists(), "{way}");
    }
}

#[test]
fn an_engine_has_a_limit_of_memory() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene();
    let hungry = |memory: &str| {
        let mut config = config(folder.path(), "hungry").unwrap();
        let text = std::fs::read_to_string(&config.file).unwrap().replace("timeout = 1", "timeout = 60");
        std::fs::write(&config.file, format!("memory = {memory}\nenvironment = {{ RUST_BACKTRACE = \"0\" }}\n{text}"))
            .unwrap();
        config = Config::read(&config.file).unwrap();
        let engine = Engine::start(config).unwrap();
        let session = engine.prepare(&scene, Off).unwrap();
        let asked = catch_unwind(AssertUnwindSafe(|| ask(&session)));
        asked.map_err(|thrown| thrown.downcast::<Broken>().map_or_else(|_| String::new(), |broken| broken.to_string()))
    };
    let said = "crashed: the process was ended by signal 6 (abort); stderr: memory allocation of 16777216 bytes failed";
    let error = hungry("256").unwrap_err();
    assert!(error.starts_with(said), "{error}");
    assert!(hungry("0").is_ok() && hungry("2048").is_ok(), "a GiB");
}
