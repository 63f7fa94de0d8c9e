//! Resumed runs, and the refusal of changed files.

use std::fs;
use std::path::Path;

use predicament_records::{Env, Outcome, PrecisionRow, Record, Row, RunDir, RunWriter};

use crate::run_dir::{PairRow, append, create, finding, killed, pair, plan, precision, resume, summary};

#[test]
fn a_resumed_run_forgets_the_scene_that_was_not_committed() {
    let folder = tempfile::tempdir().unwrap();
    killed(folder.path());
    // The second scene: a whole finding, half a stage row, and no summary.
    append(folder.path(), "findings.csv", "008,s,n,i,t,b,nan,c,q,+,-,,,\n");
    append(folder.path(), "stages.csv", "orient2d,near,ex");
    assert_eq!(RunDir::open(folder.path()).unwrap().findings.len(), 1, "what was committed");

    let (mut writer, done) = resume(folder.path()).unwrap();
    assert_eq!(done.findings, [finding()]);
    assert_eq!(done.summary, [summary("one")]);
    assert_eq!(done.warnings, Vec::<String>::new());
    writer.write(&[summary("two")]).unwrap();
    writer.finish(Outcome::Complete).unwrap();

    let run = RunDir::open(folder.path()).unwrap();
    assert!(run.is_complete());
    assert_eq!(run.summary, [summary("one"), summary("two")]);
    let error = resume(folder.path()).err().unwrap();
    assert!(error.to_string().contains("complete"), "{error}");
}

/// Removes a table; with `forgotten` also from the state, as if the tool had not had the table when the folder was
/// made.
fn take_away(folder: &Path, file: &str, forgotten: bool) {
    fs::remove_file(folder.join(file)).unwrap();
    if forgotten {
        let path = folder.join("state.json");
        let mut state: serde_json::Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
        for of in ["committed", "digests"] {
            assert!(state[of].as_object_mut().unwrap().remove(file).is_some(), "{file} was known");
        }
        state.as_object_mut().unwrap().remove("seal");
        fs::write(&path, state.to_string()).unwrap();
    }
}

#[test]
fn a_table_younger_than_the_folder_is_empty_and_started_when_resumed() {
    let folder = tempfile::tempdir().unwrap();
    killed(folder.path());
    take_away(folder.path(), PrecisionRow::FILE, true);
    assert_eq!(RunDir::open(folder.path()).unwrap().precision, []);

    let (mut writer, done) = resume(folder.path()).unwrap();
    assert_eq!(done.precision, []);
    assert_eq!(done.summary, [summary("one")]);
    writer.write(&[precision()]).unwrap();
    drop(writer); // killed once more, before a commit
    let (mut writer, done) = resume(folder.path()).unwrap();
    assert_eq!(done.precision, []);
    writer.write(&[precision()]).unwrap();
    writer.commit().unwrap();
    writer.finish(Outcome::Interrupted).unwrap();
    assert_eq!(resume(folder.path()).unwrap().1.precision, [precision()]);

    take_away(folder.path(), PrecisionRow::FILE, false);
    assert!(RunDir::open(folder.path()).is_err(), "the run had written it");
    assert!(resume(folder.path()).is_err(), "the run had written it");
}

#[test]
fn tables_of_tasks_grow_and_shrink_with_the_others() {
    let folder = tempfile::tempdir().unwrap();
    drop(RunWriter::create(folder.path(), &plan(), &Env::default(), &[]).unwrap());
    assert_eq!(RunDir::open(folder.path()).unwrap().rows::<PairRow>().unwrap(), [], "there is no such table");
    let (mut writer, _) = RunWriter::resume(folder.path(), Env::default, &[]).unwrap();
    let error = writer.write(&[pair()]).unwrap_err().to_string();
    assert!(error.contains("pairs.csv: a run folder has no such table"), "{error}");
    assert!(writer.append(&[Record::of(&pair()).unwrap()]).is_err());
    drop(writer);

    // Resumed with a table that is younger than the folder: it is started, committed, and cut back like the others.
    let (mut writer, _) = resume(folder.path()).unwrap();
    writer.write(&[pair()]).unwrap();
    writer.commit().unwrap();
    writer.write(&[PairRow { ended: 1, ..pair() }]).unwrap();
    drop(writer);
    assert_eq!(RunDir::open(folder.path()).unwrap().rows::<PairRow>().unwrap().len(), 1, "what was committed");
    let (writer, done) = resume(folder.path()).unwrap();
    assert_eq!(done.rows::<PairRow>().unwrap(), [pair()]);
    writer.finish(Outcome::Complete).unwrap();
    append(folder.path(), PairRow::FILE, "half,a");
    assert!(RunDir::open(folder.path()).unwrap_err().to_string().contains("6 bytes were added"));
}

#[test]
fn a_run_that_lost_rows_can_t_be_resumed() {
    let folder = tempfile::tempdir().unwrap();
    killed(folder.path());
    let path = folder.path().join("summary.csv");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, &text[..text.len() - 1]).unwrap();
    let error = resume(folder.path()).err().unwrap();
    assert!(error.to_string().contains("bytes are left"), "{error}");
}

/// Without this, an interrupted part kept rows of an unfinished scene; resumed, it had bytes that belong to no scene,
/// and could not be merged.
#[test]
fn an_interrupted_run_takes_back_what_it_has_not_committed() {
    let folder = tempfile::tempdir().unwrap();
    killed(folder.path());
    let text = fs::read_to_string(folder.path().join("precision.csv")).unwrap();
    let (mut writer, _) = resume(folder.path()).unwrap();
    writer.write(&[precision()]).unwrap();
    writer.finish(Outcome::Interrupted).unwrap();
    assert_eq!(fs::read_to_string(folder.path().join("precision.csv")).unwrap(), text);
    let run = RunDir::open(folder.path()).unwrap();
    assert_eq!((run.outcome, run.warnings.len()), (Outcome::Interrupted, 0));
    assert_eq!(resume(folder.path()).unwrap().1.summary, [summary("one")]);
}

/// A run that was killed while its folder was made has a plan and no state; `resume` starts it.
#[test]
fn a_run_that_was_ended_before_its_first_commit_is_begun() {
    let folder = tempfile::tempdir().unwrap();
    let whole = tempfile::tempdir().unwrap();
    create(whole.path(), &plan(), &Env::default()).unwrap().finish(Outcome::Interrupted).unwrap();
    let begun = |files: &[&str]| {
        for file in files {
            fs::copy(whole.path().join(file), folder.path().join(file)).unwrap();
        }
    };
    begun(&["plan.json", "summary.csv"]);
    fs::write(folder.path().join("findings.csv"), "half").unwrap();
    let error = RunDir::open(folder.path()).unwrap_err().to_string();
    assert!(
        error.contains("state.json: there is no such file") && error.contains("`run --resume` starts it"),
        "{error}"
    );
    let (mut writer, done) = resume(folder.path()).unwrap();
    assert_eq!((done.plan, done.summary.len(), done.warnings.len()), (plan(), 0, 0));
    writer.write(&[summary("one")]).unwrap();
    writer.finish(Outcome::Complete).unwrap();
    // If rows were written, the state was lost, and the rows are kept.
    fs::remove_file(folder.path().join("state.json")).unwrap();
    let error = resume(folder.path()).err().unwrap().to_string();
    assert!(error.contains("summary.csv: it has rows, but state.json is missing"), "{error}");
    // A run that was killed while its plan was written is made anew.
    let early = tempfile::tempdir().unwrap();
    let left = ".plan.json.1.next";
    for file in ["run.lock", left] {
        fs::write(early.path().join(file), "half").unwrap();
    }
    create(early.path(), &plan(), &Env::default()).unwrap().finish(Outcome::Complete).unwrap();
    assert!(!early.path().join(left).exists());
}

/// A flipped bit in the state of an unfinished run is refused at any place. In a name, it would leave a file without
/// its digest, and add a name that the run did not write.
#[test]
fn flipped_bits_in_the_state_of_an_unfinished_run_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let mut writer = create(folder.path(), &plan(), &Env::default()).unwrap();
    writer.write(&[summary("one")]).unwrap();
    writer.add_map("map", b"0123").unwrap();
    writer.commit().unwrap();
    drop(writer);
    let path = folder.path().join("state.json");
    let state = fs::read(&path).unwrap();
    for place in 0..state.len() {
        let bit = place % 8;
        let mut changed = state.clone();
        changed[place] ^= 1 << bit;
        fs::write(&path, &changed).unwrap();
        let about = format!("bit {bit} of byte {place}: {}", String::from_utf8_lossy(&changed));
        let error = resume(folder.path()).err().unwrap_or_else(|| panic!("gone on with, {about}")).to_string();
        let has_cure = ["restore", "start a new run"].iter().any(|cure| error.contains(cure));
        assert!(error.contains("state.json") && has_cure, "{error}, {about}");
    }
    // Readers that know fewer tables notice a missing digest.
    let mut lacking: serde_json::Value = serde_json::from_slice(&state).unwrap();
    assert!(lacking["digests"].as_object_mut().unwrap().remove("pairs.csv").is_some());
    lacking.as_object_mut().unwrap().remove("seal");
    fs::write(&path, lacking.to_string()).unwrap();
    let error = RunDir::open(folder.path()).unwrap_err().to_string();
    assert!(error.contains("`digests` lacks pairs.csv"), "{error}");
    fs::write(&path, state).unwrap();
    assert_eq!(resume(folder.path()).unwrap().1.summary, [summary("one")], "nothing else was changed");
}

/// The state of an unfinished run has digests, too: a run with a changed byte is not resumed.
#[test]
fn changed_bytes_of_an_unfinished_run_are_refused() {
    for file in ["summary.csv", "findings.csv", "plan.json", "maps/map.png"] {
        let folder = tempfile::tempdir().unwrap();
        let mut writer = create(folder.path(), &plan(), &Env::default()).unwrap();
        writer.write(&[finding()]).unwrap();
        writer.write(&[summary("one")]).unwrap();
        writer.add_map("map", b"0123").unwrap();
        writer.commit().unwrap();
        drop(writer);
        assert!(RunDir::open(folder.path()).is_ok());
        let path = folder.path().join(file);
        let mut bytes = fs::read(&path).unwrap();
        let place = bytes.iter().rposition(|&byte| byte.is_ascii_digit()).unwrap();
        bytes[place] ^= 1;
        fs::write(&path, bytes).unwrap();
        for error in [RunDir::open(folder.path()).unwrap_err(), resume(folder.path()).err().unwrap()] {
            assert!(error.path.ends_with(file) && error.message.contains("its content differs"), "{error}");
        }
        fs::remove_file(&path).unwrap();
        assert!(RunDir::open(folder.path()).unwrap_err().path.ends_with(file), "it is gone");
    }
}
