//! The JUnit report, read back with the library's own parser.

use predicament_records::{RunDir, SummaryRow, junit};
use quick_junit::{NonSuccessKind, Report, TestCaseStatus};

/// The body of a failed test case: text that XML has to escape.
fn told(row: &SummaryRow) -> String {
    format!("<first> of {}\u{1b}\nand so on", row.scene)
}

#[test]
fn every_pair_of_scene_and_backend_is_a_case() {
    let run = RunDir::open("../tasks/tests/data/checked").unwrap();
    let xml = junit("predicament", &run.summary, &run.not_run(), &told).unwrap();
    let report = Report::deserialize_from_str(&xml).unwrap();
    assert_eq!(report.tests, 20, "4 scenes on 5 backends");
    assert_eq!((report.failures, report.errors, report.skipped), (2, 3, 1));
    let suites: Vec<&str> = report.test_suites.iter().map(|suite| suite.name.as_str()).collect();
    assert_eq!(suites, ["maps", "near"]);

    let case = |name: &str| {
        let mut cases = report.test_suites.iter().flat_map(|suite| &suite.test_cases);
        &cases.find(|case| case.name.as_str() == name).unwrap().status
    };
    let TestCaseStatus::NonSuccess { kind, message, description, .. } = case("uniform-1 [naive]") else {
        panic!("a failure")
    };
    let body = description.as_ref().unwrap().as_str();
    assert_eq!(body, "<first> of uniform-1\u{FFFD}\nand so on");
    assert_eq!(*kind, NonSuccessKind::Failure);
    let message = message.as_ref().unwrap().as_str();
    assert_eq!(message, "unexpected finding: agree 999,998, sign_flip 2 (queries 1,000,000)");
    let TestCaseStatus::NonSuccess { ty, .. } = case("cube|corner_1 [naive]") else { panic!("a failure") };
    assert_eq!(ty.as_ref().unwrap().as_str(), "unexpected_pass");
    assert!(matches!(case("near-7 [naive]"), TestCaseStatus::Success { .. }), "expected findings pass");
    assert!(matches!(case("cube|corner_1 [tolerance]"), TestCaseStatus::Skipped { .. }));
    let TestCaseStatus::NonSuccess { kind, description, .. } = case("two-squares [shewchuk]") else {
        panic!("an error")
    };
    assert_eq!(*description, None, "nothing was found where nothing was run");
    assert_eq!(*kind, NonSuccessKind::Error, "planned and not run");
}

#[test]
fn the_order_of_rows_changes_nothing() {
    let mut run = RunDir::open("../tasks/tests/data/checked").unwrap();
    let forward = junit("predicament", &run.summary, &[], &told).unwrap();
    run.summary.edit(|rows| rows.reverse());
    assert_eq!(junit("predicament", &run.summary, &[], &told).unwrap(), forward);
}

#[test]
fn names_with_markup_stay_names() {
    let mut run = RunDir::open("../tasks/tests/data/checked").unwrap();
    run.summary.edit(|rows| rows.truncate(1));
    run.summary[0].scene = "<a & \"b\">".to_owned();
    let xml = junit("predicament", &run.summary, &[], &told).unwrap();
    let report = Report::deserialize_from_str(&xml).unwrap();
    assert_eq!(report.test_suites[0].test_cases[0].name.as_str(), "<a & \"b\"> [exact]");
    // XML can't represent some characters.
    run.summary[0].scene = "a\u{FFFE}b\u{FFFF}c\u{1}d\u{1b}[0me\u{FFFD}\u{10FFFF}".to_owned();
    run.summary[0].suite = "s\u{FFFF}".to_owned();
    let xml = junit("predicament", &run.summary, &[], &told).unwrap();
    assert!(!xml.contains(['\u{FFFE}', '\u{FFFF}', '\u{1}', '\u{1b}']), "{xml}");
    let suite = &Report::deserialize_from_str(&xml).unwrap().test_suites[0];
    assert_eq!(suite.name.as_str(), "s\u{FFFD}");
    let name = "a\u{FFFD}b\u{FFFD}c\u{FFFD}d\u{FFFD}[0me\u{FFFD}\u{10FFFF} [exact]";
    assert_eq!(suite.test_cases[0].name.as_str(), name);
}
