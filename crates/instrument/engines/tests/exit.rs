//! The end of all engines before an exit: a separate test, as it ends all engines of its process.
#![cfg(target_os = "linux")]

use std::path::PathBuf;

use predicament_engines::{Config, Engine, end_all};

#[test]
fn before_an_exit_all_that_engines_have_started_is_ended() {
    let folder = tempfile::tempdir().unwrap();
    let mut left: Vec<PathBuf> = Vec::new();
    let mut start = |way: &str| {
        let (program, number) = (env!("CARGO_BIN_EXE_engine-of-tests"), folder.path().join(way));
        let text = format!(
            "name = \"tests\"\nrun = [{program:?}, {way:?}]\nenvironment = {{ LEFT_BEHIND = \"{}\" }}\n",
            number.display()
        );
        let file = folder.path().join("engine.toml");
        std::fs::write(&file, text).unwrap();
        let engine = Engine::start(Config::read(&file).unwrap()).unwrap();
        let process = std::fs::read_to_string(number).unwrap();
        left.push(PathBuf::from("/proc").join(process.trim()));
        engine
    };
    let engines = ["leaves a child", "leaves a stranger", "leaves an orphan"].map(&mut start);
    assert!(left.iter().all(|process| process.exists()));
    end_all();
    assert!(left.iter().all(|process| !process.exists()), "ended, and asked how");
    drop(engines);
}
