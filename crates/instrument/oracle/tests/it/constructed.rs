//! Ties about constructed vertices, broken and judged.

use predicament_tasks::Class;

use crate::common::{definitions, judged_by_name, loaded};

/// A tie for each kind of construction; `run` tests all of them.
#[test]
fn ties_about_constructed_vertices_are_broken_as_the_judge_does() {
    let scenes = definitions().into_iter().filter(|scene| scene.suite == "constructed");
    let mut ties = 0;
    for definition in scenes.filter(|scene| !scene.name.contains("tpi") || scene.name.contains("compare")) {
        let outcome = judged_by_name(&loaded(&definition), "sos");
        let name = &definition.name;
        assert_eq!(outcome.findings, [], "{name}");
        let broken = outcome.counts.get(Class::TieBroken);
        assert!(broken > 0 || !name.contains("degen"), "{name}: {:?}", outcome.counts);
        ties += broken;
    }
    assert!(ties > 1000, "{ties}");
}
