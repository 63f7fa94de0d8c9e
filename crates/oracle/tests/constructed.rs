//! Ties about constructed vertices, broken and judged.

use std::sync::atomic::AtomicBool;

use predicament_corpus::{Cache, Level, Library};
use predicament_oracle::signs::Budget;
use predicament_oracle::{Case, Class, Watch, roster};

/// Of each kind of construction; `run` asks for all of them.
#[test]
fn ties_about_constructed_vertices_are_broken_as_the_judge_does() {
    let library = Library::embedded().unwrap();
    let scenes = library.suites().iter().filter(|suite| suite.name == "constructed").flat_map(|suite| &suite.scenes);
    let (mut ties, flag) = (0, AtomicBool::new(false));
    for def in scenes.filter(|def| !def.name.contains("tpi") || def.name.contains("compare")) {
        let loaded = def.load(Level::Quick, &Cache::new("")).unwrap();
        let quiet = |_: u64| {};
        let watch = Watch::new(&flag, None, &quiet);
        let case = Case::new(&loaded, &watch).unwrap();
        let outcome = case.run(roster::backend("sos").unwrap().as_ref(), Budget::QUICK, &watch).unwrap();
        assert_eq!(outcome.findings, [], "{}", loaded.name);
        let broken = outcome.counts.get(Class::TieBroken);
        assert!(broken > 0 || !loaded.name.contains("degen"), "{}: {:?}", loaded.name, outcome.counts);
        ties += broken;
    }
    assert!(ties > 1000, "{ties}");
}
