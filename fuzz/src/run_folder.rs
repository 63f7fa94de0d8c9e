//! Run folders: one file of a folder has fuzzed bytes; the folder is read or refused with a one-line error that names
//! the file.
//!
//! The first byte chooses the file. The other files of the folder are those of a small run. They have no digests, which
//! would cause a refusal of every change.

use std::path::PathBuf;
use std::sync::LazyLock;

use predicament_records::{
    Class, Env, FORMAT, Level, Lined, Outcome, Plan, PlannedScene, RunDir, RunWriter, SegmentRow, Shard, Status,
    SummaryRow, TableSpec,
};

/// The files, in the order of their numbers.
pub const FILES: [&str; 9] = [
    "plan.json",
    "state.json",
    "env.json",
    "summary.csv",
    "findings.csv",
    "throughput.csv",
    "stages.csv",
    "precision.csv",
    "segments.csv",
];

/// A folder of this process, with the text of its files.
static FOLDER: LazyLock<(PathBuf, Vec<Vec<u8>>)> = LazyLock::new(|| {
    let folder = std::env::temp_dir().join(format!("predicament-fuzz-{}", std::process::id()));
    let _ = std::fs::remove_dir_all(&folder);
    make(&folder).expect("the folder for temporary files is writable");
    let state = folder.join("state.json");
    let text = std::fs::read_to_string(&state).expect("it was written");
    let without = text.split(",\n  \"digests\"").next().unwrap_or_default().to_owned() + "\n}\n";
    std::fs::write(&state, without).expect("it was written");
    // Its JSON files have no seals either.
    for file in FILES.iter().filter(|file| file.ends_with(".json")).map(|file| folder.join(file)) {
        let text = std::fs::read_to_string(&file).expect("it was written");
        let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with("  \"seal\"")).collect();
        std::fs::write(&file, lines.join("\n") + "\n").expect("it was written");
    }
    let files = FILES.map(|file| std::fs::read(folder.join(file)).expect("it was written"));
    (folder, files.into())
});

fn make(folder: &PathBuf) -> Result<(), predicament_records::Error> {
    let scene = |name: &str| PlannedScene {
        suite: "s".to_owned(),
        scene: name.to_owned(),
        scene_id: "0123".to_owned(),
        task: "orient2d".to_owned(),
        family: "f".to_owned(),
        queries: 3,
    };
    let scenes = vec![scene("one"), scene("two")];
    let plan = Plan {
        format: FORMAT,
        created_by: "predicament 0.1.0".to_owned(),
        level: Level::Quick,
        suites: vec!["s".to_owned()],
        paths: [].into(),
        hashes: [].into(),
        engines: [].into(),
        answers: false,
        timed: false,
        whole: Some(predicament_records::Whole::new(&scenes, vec![0, 1])),
        scenes: scenes.clone(),
        backends: vec!["exact".to_owned()],
        only: [].into(),
        judged_whole: [].into(),
        ladder: Vec::new(),
        shard: Shard::WHOLE,
        not_selected: Vec::new(),
        left_out: Vec::new(),
        permutations: None,
        expected: None,
        findings_per_class: 25,
    };
    let mut writer = RunWriter::create(folder, &plan, &Env::default(), &[TableSpec::of::<SegmentRow>()])?;
    for (place, scene) in (0..).zip(&scenes) {
        let mut row = SummaryRow::new(scene, "exact", 3, Status::Ok);
        *row.count_mut(Class::Agree) = 3;
        writer.write(&[row])?;
        writer.commit_of(place, "exact")?;
    }
    writer.finish(Outcome::Interrupted)
}

/// The original text of a file.
#[must_use]
pub fn text_of(file: u8) -> Vec<u8> {
    FOLDER.1[usize::from(file) % FILES.len()].clone()
}

/// Runs one fuzz case.
///
/// # Panics
/// If an error is not a single line that names a file of the folder.
pub fn check(bytes: &[u8]) {
    let Some((&file, bytes)) = bytes.split_first() else { return };
    let (folder, files) = &*FOLDER;
    let file = usize::from(file) % FILES.len();
    let path = folder.join(FILES[file]);
    std::fs::write(&path, bytes).expect("the folder for temporary files is writable");
    let read = RunDir::open(folder);
    let lined = Lined::read(&path);
    std::fs::write(&path, &files[file]).expect("the folder for temporary files is writable");
    let said = [read.as_ref().err().map(ToString::to_string), lined.err().map(|error| error.to_string())];
    for said in said.into_iter().flatten() {
        // A message may quote a cell of a file, escaped or not; it must not become a separate line.
        assert!(said.starts_with(&*folder.display().to_string()), "{said:?}");
    }
    if let Ok(run) = read {
        let _ = run.timed_scenes();
        let _ = predicament_records::junit("fuzzed", &run.summary, &run.not_run(), &|row| row.scene.clone());
        let _ = run.rows::<SegmentRow>();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::bytes;

    #[test]
    fn the_folder_is_a_run_and_changes_are_read_or_refused() {
        for file in 0..9 {
            let text = text_of(file);
            check(&[&[file], text.as_slice()].concat());
            assert!(RunDir::open(&FOLDER.0).is_ok(), "{}", FILES[usize::from(file)]);
            for run in 0..200 {
                let random = bytes(run);
                let mut changed = text.clone();
                for change in random.chunks_exact(3).take(1 + usize::from(random[0] % 4)) {
                    let place = (usize::from(change[0]) * 256 + usize::from(change[1])) % (changed.len() + 1);
                    if change[2] % 2 == 0 { changed.insert(place, change[2]) } else { changed.truncate(place) }
                }
                check(&[&[file], changed.as_slice()].concat());
            }
        }
    }
}
