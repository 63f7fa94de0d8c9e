//! JUnit files, for build servers.

use std::path::Path;

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

use crate::format::thousands;
use crate::{Class, Error, NotRun, Status, SummaryRow};

/// One test case for each scene on each backend, grouped by suite and sorted.
///
/// Unexpected findings and unexpected passes are failures. A planned pair that was not run is an error. A scene that
/// was declined as expected is skipped. `told` gives the body of a failure from its row.
///
/// # Errors
/// If the XML can't be written.
pub fn junit(
    name: &str,
    rows: &[SummaryRow],
    not_run: &[NotRun],
    told: &dyn Fn(&SummaryRow) -> String,
) -> Result<String, Error> {
    let mut cases: Vec<([&str; 5], Option<&SummaryRow>)> = Vec::new();
    cases.extend(rows.iter().map(|r| ([&*r.suite, &*r.scene, &*r.scene_id, &*r.task, &*r.backend], Some(r))));
    cases.extend(not_run.iter().map(|m| ([&*m.suite, &*m.scene, &*m.scene_id, &*m.task, &*m.backend], None)));
    cases.sort_by_key(|(key, _)| *key);

    let mut report = Report::new(name);
    for suite in cases.chunk_by(|(a, _), (b, _)| a[0] == b[0]) {
        let mut test_suite = TestSuite::new(xml(suite[0].0[0]));
        for &([suite, scene, scene_id, task, backend], row) in suite {
            let name = xml(&format!("{scene} [{backend}]"));
            let mut status = row.map_or_else(missing, outcome);
            if let Some(row) = row.filter(|row| !row.status.passes()) {
                status.set_description(xml(&told(row)));
            }
            let mut case = TestCase::new(name, status);
            case.set_classname(xml(&format!("{suite}.{task}")));
            case.extra.insert("id".into(), xml(scene_id).into());
            test_suite.add_test_case(case);
        }
        report.add_test_suite(test_suite);
    }
    report.to_string().map_err(|error| Error::new(Path::new(name), format!("no JUnit report: {error}")))
}

/// A text in which each character that XML 1.0 forbids is replaced. A parser rejects any file with such a character,
/// escaped or not.
fn xml(text: &str) -> String {
    let is_legal = |c: char| matches!(c, '\t' | '\n' | '\r' | ' '..='\u{FFFD}' | '\u{10000}'..);
    text.chars().map(|c| if is_legal(c) { c } else { char::REPLACEMENT_CHARACTER }).collect()
}

fn missing() -> TestCaseStatus {
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Error);
    status.set_type("not_run").set_message("planned, and not run");
    status
}

fn outcome(row: &SummaryRow) -> TestCaseStatus {
    let counts = || {
        let classes = Class::ALL.into_iter().filter(|&class| row.count(class) > 0);
        let counts: Vec<String> = classes.map(|class| format!("{class} {}", thousands(row.count(class)))).collect();
        format!("{} (queries {})", counts.join(", "), thousands(row.queries))
    };
    match row.status {
        Status::Unexpected => {
            let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
            status.set_type("unexpected").set_message(format!("unexpected finding: {}", counts()));
            status
        }
        Status::UnexpectedPass => {
            let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
            status.set_type("unexpected_pass").set_message(format!("an expected finding did not occur: {}", counts()));
            status
        }
        Status::Ok | Status::Expected if row.declined > 0 && !row.has_answers() => {
            let mut status = TestCaseStatus::skipped();
            status.set_type("declined").set_message("the backend declined");
            status
        }
        Status::Ok | Status::Expected => TestCaseStatus::success(),
    }
}
