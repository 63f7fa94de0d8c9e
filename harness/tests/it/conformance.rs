//! Conformance tests of another crate.

use crate::common::{at, write};
use predicament::example::Mine;
use tempfile::tempdir;

#[test]
fn findings_and_expectations_that_nothing_can_meet_fail_it() {
    let folder = tempdir().unwrap();
    let check = |filter: &str, expected: &str| {
        let test = predicament::conformance(Mine).filter(filter).folder(at(&folder, "run"));
        test.expected(write(&folder, "expected.toml", expected)).check()
    };
    let entry = |scene: &str| {
        format!(
            "[[expect]]\nscene = \"{scene}\"\nbackend = \"mine\"\nclass = \"overreach\"\nreason = \"plain doubles\"\n"
        )
    };
    let holds = check("^families/(uniform|grid)-orient2d", "").unwrap();
    assert!(holds.starts_with("mine: 10000 answers to 2 scenes, none unexpected"), "{holds}");
    let found = check("^families/kettner-orient2d", "").unwrap_err();
    assert!(found.contains("mine: 1 of 1 scenes are not as expected") && found.contains("vertex"), "{found}");
    assert!(found.contains("let answer = orient2d(a, b, c);") && found.contains("f64::from_bits(0x"), "{found}");
    let never = check("^families/uniform-orient2d", &entry("families/unifrom-*")).unwrap_err();
    assert!(never.contains("mine: expectations that nothing can meet\n"), "{never}");
    assert!(never.contains("expected.toml:1: no scene is called `families/unifrom-*`"), "{never}");
    // The contents of the folder are replaced only if it is a run.
    write(&folder, "precious.txt", "mine");
    let refused = predicament::conformance(Mine).folder(folder.path()).check().unwrap_err();
    assert!(refused.ends_with("the folder does not hold a run; name another"), "{refused}");
    assert!(folder.path().join("precious.txt").exists());
    // The filter leaves this scene out.
    check("^families/uniform-orient2d", &entry("families/kettner-orient2d")).unwrap();
}
