//! Checks that the judge depends on the vocabulary and on libraries of numbers, not on code that it judges.

/// The names under `[dependencies]` of a manifest.
fn dependencies(manifest: &str) -> Vec<&str> {
    let lines = manifest.lines().skip_while(|line| *line != "[dependencies]").skip(1);
    let lines = lines.take_while(|line| !line.starts_with('['));
    let lines = lines.filter(|line| !line.trim().is_empty() && !line.starts_with('#'));
    lines.filter_map(|line| line.split(['.', ' ', '=']).next()).collect()
}

#[test]
fn no_path_leads_from_the_judge_to_what_it_judges() {
    assert_eq!(
        dependencies(include_str!("../../Cargo.toml")),
        ["predicament-predicates", "num-bigint", "rug", "gmp-mpfr-sys"],
        "anything else needs a reason: the truth may share no code with a backend or an algorithm"
    );
    assert_eq!(
        dependencies(include_str!("../../../../kernel/predicates/Cargo.toml")),
        ["predicament-arithmetic", "predicament-formula", "serde"]
    );
    // Of arithmetic the vocabulary has the type of an answer, and no operation.
    let vocabulary = include_str!("../../../../kernel/predicates/src/lib.rs");
    let used: Vec<&str> = vocabulary.lines().filter(|line| line.contains("predicament_arithmetic")).collect();
    assert_eq!(used, ["pub use predicament_arithmetic::Sign;"]);
    // Of formulas the judge reads the syntax tree, and no program, filter or term that backends use.
    let formula = include_str!("../../src/formula.rs");
    let used: Vec<&str> = formula.lines().filter(|line| line.contains("::formula::")).collect();
    assert_eq!(used, ["use predicament_predicates::formula::{Formula, Ring, interpret};"]);
    for other in [".program()", ".estimate(", ".sign(", ".certain(", ".polynomial()", ".terms("] {
        assert!(!formula.contains(other), "the judge of formulas calls {other}");
    }
    // The rational backend computes in rationals as well: in code of its own, from the programs of formulas.
    let controls = dependencies(include_str!("../../../controls/Cargo.toml"));
    assert!(controls.contains(&"rug") && !controls.contains(&"predicament-judge"), "{controls:?}");
    for file in [
        include_str!("../../../controls/src/rational.rs"),
        include_str!("../../../controls/src/rational/determinant.rs"),
        include_str!("../../../controls/src/rational/meet.rs"),
        include_str!("../../../controls/src/rational/session.rs"),
    ] {
        let code: String = file.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
        for shared in ["predicament_judge", "interpret", "Ring", "#[path"] {
            assert!(!code.contains(shared), "the rational backend and the judge share {shared}");
        }
    }
    // The manifest reader finds a dependency that exists.
    assert!(dependencies(include_str!("../../../../systems/contacts/Cargo.toml")).contains(&"predicament-mesh"));
}
