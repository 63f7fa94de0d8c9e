//! An error in a run and its copy in a bench count once.

use std::path::Path;

use predicament_export::{Exported, Format};
use predicament_records::{Class, Env, Outcome, Plan, RunWriter, Status, SummaryRow};
use tempfile::tempdir;

use crate::common::{env, exported, plan, scene};

/// Writes a run or a bench that has judged these scenes on `naive`, each with seven wrong answers.
fn write(folder: &Path, timed: bool, scenes: &[&str], env: &Env) {
    let plan = Plan { timed, scenes: scenes.iter().map(|name| scene(name)).collect(), ..plan() };
    let mut writer = RunWriter::create(folder, &plan, env, &[]).unwrap();
    for scene in &plan.scenes {
        let mut row = SummaryRow::new(scene, "naive", 10, Status::Expected);
        (*row.count_mut(Class::SignFlip), *row.count_mut(Class::Agree)) = (7, 3);
        writer.write(&[row]).unwrap();
    }
    writer.finish(Outcome::Complete).unwrap();
}

fn rows(of: &Exported) -> u64 {
    of.files.iter().find(|file| file.path.ends_with("summary.csv")).unwrap().rows
}

#[test]
fn a_bench_adds_no_error_that_its_run_has_found() {
    let folder = tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let (run, bench, other, out) = (at("run"), at("bench"), at("other"), at("out"));
    let env = env("2026-01-05T03:00:00Z");
    write(&run, false, &["a", "b"], &env);
    write(&bench, true, &["a", "b", "c"], &env);
    let both = exported(&[&run, &bench], Format::Csv, &out).unwrap();
    assert_eq!(rows(&both), 3, "a and b of the run, and what the bench alone has judged");
    assert!(both.notes.iter().any(|note| note.starts_with("bench: 2 rows")), "{:?}", both.notes);
    // A bench exported alone has all of its rows, and so has a bench by another build of the tool.
    assert_eq!(rows(&exported(&[&bench], Format::Csv, &out).unwrap()), 3);
    write(&other, true, &["a", "b"], &Env { commit: Some("another".to_owned()), ..env });
    assert_eq!(rows(&exported(&[&run, &other], Format::Csv, &out).unwrap()), 4);
}
