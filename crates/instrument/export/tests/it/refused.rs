//! Refused exports, which leave everything unchanged.

use std::fs;
use std::path::Path;

use predicament_export::{Format, Watch, export, find};
use predicament_records::TABLES;
use tempfile::tempdir;

use crate::common::{exported, files, kinds, known, write_run};

const DAY: &str = "2026-01-05T03:00:00Z";

/// A JSON file of a run folder without its seal, so that it may be changed.
fn unsealed(file: &Path) -> String {
    let text = fs::read_to_string(file).unwrap();
    text.lines().filter(|line| !line.starts_with("  \"seal\"")).map(|line| format!("{line}\n")).collect()
}

/// Asserts that an export fails with an error that contains `why`, and changes nothing.
fn refuse(folders: &[&Path], out: &Path, why: &str) {
    let before = files(out);
    let error = exported(folders, Format::Parquet, out).expect_err(why).to_string();
    assert!(error.contains(why), "{error}");
    assert!(files(out) == before, "something was left or changed");
}

#[test]
fn a_table_that_is_not_as_it_was_written_is_refused() {
    let folder = tempdir().unwrap();
    let [run, out] = ["run", "out"].map(|name| folder.path().join(name));
    write_run(&run, DAY, &kinds());
    let path = run.join("kinds.csv");
    let text = fs::read_to_string(&path).unwrap();
    for (broken, why) in [
        (text[..text.len() - 5].to_owned(), "kinds.csv: 184 bytes are left of the 189 that the run wrote"),
        (format!("{text}x"), "kinds.csv: 1 bytes were added after the run was complete"),
        (
            text.replace("0.30000000000000004", "0.30000000000000005"),
            "kinds.csv: it was edited after the run was complete",
        ),
    ] {
        fs::write(&path, broken).unwrap();
        refuse(&[&run], &out, why);
    }
    fs::remove_file(&path).unwrap();
    refuse(&[&run], &out, "kinds.csv: ");
    fs::write(&path, text).unwrap();
    exported(&[&run], Format::Parquet, &out).unwrap();
}

#[test]
fn cells_and_columns_are_held_to_the_schema() {
    let folder = tempdir().unwrap();
    let [run, out] = ["run", "out"].map(|name| folder.path().join(name));
    write_run(&run, DAY, &kinds());
    let state = run.join("state.json");
    fs::write(&state, "{\"outcome\": \"complete\", \"committed\": {}}").unwrap();
    let env = run.join("env.json");
    let whole = unsealed(&env);
    assert!(whole.contains(DAY));
    fs::write(&env, whole.replace(DAY, "yesterday")).unwrap();
    refuse(
        &[&run],
        &out,
        "env.json: `yesterday` in column `date` is not a moment like 2026-01-31T23:59:59Z; restore the file",
    );
    fs::write(&env, whole).unwrap();
    let path = run.join("throughput.csv");
    let text = fs::read_to_string(&path).unwrap();
    for (from, to, why) in [
        (",12.5", ",soon", "throughput.csv:2: `soon` in column `ns_per_query` is not a number"),
        (
            ",3,0",
            ",9223372036854775808,0",
            "throughput.csv:2: `9223372036854775808` in column `queries` is not a whole number",
        ),
        (",3,1", ",,1", "throughput.csv:3: `` in column `queries` is not a whole number"),
        (
            "sample",
            "simple",
            "throughput.csv:1: the columns must be task,family,backend,interface,engine_version,queries,sample,",
        ),
        (",3,0", ",3", "throughput.csv:2: there are 7 fields, and there should be 8"),
    ] {
        assert!(text.contains(from));
        fs::write(&path, text.replacen(from, to, 1)).unwrap();
        refuse(&[&run], &out, why);
    }
}

#[test]
fn folders_that_would_be_mistaken_are_refused() {
    let folder = tempdir().unwrap();
    let [a, b, out] = ["a/run", "b/run", "out"].map(|name| folder.path().join(name));
    write_run(&a, DAY, &kinds());
    write_run(&b, DAY, &kinds());
    refuse(&[&a, &b], &out, "the name of the run would be `run`");
    exported(&[folder.path()], Format::Parquet, &out).unwrap();
    // A file of another export would look like a table of this one.
    fs::write(out.join("answers.parquet"), "old").unwrap();
    refuse(&[&a], &out, "answers.parquet: this export does not have this table");
    fs::remove_file(out.join("answers.parquet")).unwrap();
    // Files left by a killed export are removed.
    fs::write(out.join(".answers.parquet.1.next"), "half").unwrap();
    exported(&[&a], Format::Parquet, &out).unwrap();
    assert!(files(&out).iter().all(|(name, _)| !name.ends_with(".next")));
    refuse(&[&a], &b, "it is a run folder");
    refuse(
        &[&folder.path().join("out")],
        &folder.path().join("other"),
        "it is not a run folder and does not contain run folders",
    );
    refuse(&[&folder.path().join("nowhere")], &folder.path().join("other"), "nowhere");
}

#[test]
fn a_run_that_lost_its_plan_is_not_passed_over() {
    let folder = tempdir().unwrap();
    let [all, csv, out] = ["all", "all/csv", "out"].map(|name| folder.path().join(name));
    let [whole, lost] = ["whole", "lost"].map(|name| all.join(name));
    for run in [&whole, &lost] {
        write_run(run, DAY, &kinds());
    }
    // An export and an unrelated folder have tables, too.
    exported(&[&whole], Format::Csv, &csv).unwrap();
    fs::create_dir(all.join("else")).unwrap();
    fs::write(all.join("else/summary.csv"), "a,b\n1,2\n").unwrap();
    assert_eq!(find(std::slice::from_ref(&all)).unwrap().others, [csv, all.join("else")]);
    fs::remove_file(lost.join("plan.json")).unwrap();
    let why = "lost/plan.json: the file is missing, but the folder has tables of a run; restore the file";
    refuse(&[&all], &out, why);
    refuse(&[&lost], &out, why);
    fs::remove_file(lost.join("state.json")).unwrap();
    refuse(&[&all], &out, why);
    // A folder without rows loses nothing.
    for table in TABLES {
        fs::write(lost.join(table.file), table.columns.join(",") + "\n").unwrap();
    }
    exported(&[&all], Format::Parquet, &out).unwrap();
}

#[test]
fn a_stop_leaves_what_was_there() {
    struct Stopped(bool);
    impl Watch for Stopped {
        fn is_stopped(&self) -> bool {
            self.0
        }
        fn done(&mut self) {
            self.0 = true;
        }
    }
    let folder = tempdir().unwrap();
    let [all, out] = ["all", "out"].map(|name| folder.path().join(name));
    for day in ["1", "2"] {
        write_run(&all.join(day), DAY, &kinds());
    }
    let found = find(std::slice::from_ref(&all)).unwrap();
    assert_eq!(export(&found.runs, &known(), Format::Parquet, &out, &mut Stopped(false)).unwrap(), None);
    assert!(files(&out).is_empty());
    assert!(export(&found.runs[..1], &known(), Format::Parquet, &out, &mut Stopped(false)).unwrap().is_some());
}
