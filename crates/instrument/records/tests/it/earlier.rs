//! Folders of earlier versions: their tables lack later columns.

use std::fs;
use std::path::Path;

use predicament_records::{Class, Env, Outcome, Plan, RunDir, Shard, merge};

use crate::run_dir::{MORE, append_known, create, plan, resume, summary};

/// A run folder whose `summary.csv` lacks the column of the class `unstable`.
fn earlier(folder: &Path, outcome: Option<Outcome>) {
    let mut writer = create(folder, &Plan { shard: Shard::WHOLE, ..plan() }, &Env::default()).unwrap();
    writer.write(&[summary("one"), summary("two")]).unwrap();
    match outcome {
        Some(outcome) => writer.finish(outcome).unwrap(),
        None => writer.commit().unwrap(),
    }
    let path = folder.join("summary.csv");
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains(",accepted,unstable,status\n"), "{text}");
    fs::write(&path, text.replace(",unstable,status", ",status").replace(",24,25,", ",24,")).unwrap();
    append_known(folder, "summary.csv", "");
}

#[test]
fn a_column_that_an_earlier_version_lacks_is_read_as_0() {
    let folder = tempfile::tempdir().unwrap();
    earlier(folder.path(), Some(Outcome::Complete));
    let run = RunDir::open(folder.path()).unwrap();
    for (row, name) in run.summary.iter().zip(["one", "two"]) {
        let mut expected = summary(name);
        *expected.count_mut(Class::Unstable) = 0;
        assert_eq!(*row, expected);
    }
    assert_eq!(run.summary.iter().count(), 2);
}

#[test]
fn rows_are_not_added_to_a_table_of_an_earlier_version() {
    let folder = tempfile::tempdir().unwrap();
    let (begun, done) = (folder.path().join("begun"), folder.path().join("done"));
    earlier(&begun, None);
    let resumed = resume(&begun).err().unwrap().to_string();
    earlier(&done, Some(Outcome::Complete));
    let merged =
        merge(&[done], &folder.path().join("merged"), &MORE, |_| Env::default()).unwrap_err().error.to_string();
    for error in [resumed, merged] {
        assert!(error.contains("summary.csv:1: another version of the tool wrote this table"), "{error}");
    }
}
