//! Folders that are read together: each scene on each backend counts once.

use std::path::{Path, PathBuf};

use predicament_records::{Error, RunDir, TableSpec};
use tempfile::{TempDir, tempdir};

const CHECKED: &str = "../tasks/tests/data/checked";

/// A copy of a hand-written run folder, with some text of its files replaced. Each replacement has to match.
pub(crate) fn copy(folder: &TempDir, name: &str, changes: &[(&str, &str, &str)]) -> PathBuf {
    let copy = folder.path().join(name);
    std::fs::create_dir(&copy).unwrap();
    let mut left = changes.to_vec();
    for file in std::fs::read_dir(CHECKED).unwrap().map(Result::unwrap) {
        let name = file.file_name().into_string().unwrap();
        let mut text = std::fs::read_to_string(file.path()).unwrap();
        left.retain(|(of, from, to)| {
            let is_here = *of == name && text.contains(from);
            text = if is_here { text.replace(from, to) } else { std::mem::take(&mut text) };
            !is_here
        });
        std::fs::write(copy.join(name), text).unwrap();
    }
    assert!(left.is_empty(), "nothing to replace: {left:?}");
    copy
}

fn open(paths: &[&Path]) -> Result<Vec<RunDir>, Error> {
    RunDir::open_all(paths)
}

/// The number of rows of each table, timings excepted, in all of these folders.
fn rows(runs: &[RunDir]) -> [usize; 5] {
    let count = |of: fn(&RunDir) -> usize| runs.iter().map(of).sum();
    [
        count(|run| run.summary.len()),
        count(|run| run.findings.len()),
        count(|run| run.stages.len()),
        count(|run| run.precision.len()),
        count(|run| run.not_run().len()),
    ]
}

fn remove_rows(folder: &Path, file: &str) {
    let path = folder.join(file);
    let header = std::fs::read_to_string(&path).unwrap().lines().next().unwrap().to_owned();
    std::fs::write(path, header + "\n").unwrap();
}

#[test]
fn what_two_folders_have_counts_once() {
    let folder = tempdir().unwrap();
    let (one, two) = (copy(&folder, "one", &[]), copy(&folder, "two", &[]));
    for path in [&one, &two] {
        std::fs::create_dir(path.join("maps")).unwrap();
        std::fs::write(path.join("maps/near exact.png"), b"picture").unwrap();
    }
    let alone = open(&[&one]).unwrap();
    assert_eq!(rows(&alone), [17, 7, 10, 4, 3]);
    let both = open(&[&one, &two]).unwrap();
    assert_eq!(rows(&both), rows(&alone));
    assert_eq!((both[0].summary.len(), both[1].summary.len()), (17, 0), "the first folder keeps its rows");
    assert_eq!((both[0].maps.len(), both[1].maps.len()), (1, 0));
    assert_eq!([0, 1].map(|run| both[run].warnings.len()), [alone[0].warnings.len(); 2], "nothing is lost");
}

/// Rows of the tasks' tables, which the folder knows only by their columns, count once.
#[test]
fn rows_of_tasks_count_once() {
    let folder = tempdir().unwrap();
    let (one, two) = (copy(&folder, "one", &[]), copy(&folder, "two", &[]));
    let both = open(&[&one, &two]).unwrap();
    let head = std::fs::read_to_string(Path::new(&one).join("masses.csv")).unwrap();
    // Columns live as long as the program.
    let columns = head.lines().next().unwrap().split(',').map(|name| &*name.to_owned().leak());
    let table =
        TableSpec { file: "masses.csv", columns: columns.collect::<Vec<&str>>().leak(), about: "", schema: &[] };
    assert_eq!(both.iter().map(|run| run.records(table).len()).collect::<Vec<_>>(), [2, 0]);

    // A row of a scene that only the second folder has stays.
    let more = copy(&folder, "more", &[("masses.csv", "twins,cfee99a36a037de1", "others,0000000000000001")]);
    let both = open(&[&one, &more]).unwrap();
    assert_eq!(both.iter().map(|run| run.records(table).len()).collect::<Vec<_>>(), [2, 1]);

    // If both folders are complete, different rows of one scene are a contradiction.
    let complete = ("state.json", "interrupted", "complete");
    let whole = copy(&folder, "whole", &[complete]);
    let other = copy(&folder, "other", &[complete, ("masses.csv", "exact,3,-2.0", "exact,3,-3.0")]);
    // The last line of its findings is cut off.
    for folder in [&whole, &other] {
        remove_rows(folder, "findings.csv");
    }
    let error = open(&[&whole, &other]).unwrap_err().to_string();
    for part in ["other/masses.csv: ", "cubes twins cfee99a36a037de1 exact has other rows", "whole/masses.csv"] {
        assert!(error.contains(part), "{error}");
    }
}

#[test]
fn a_folder_that_is_named_twice_is_read_once() {
    let folder = tempdir().unwrap();
    let one = copy(&folder, "one", &[]);
    let again = folder.path().join(".").join("one");
    let runs = open(&[&one, &again]).unwrap();
    assert_eq!(runs.len(), 1);
    assert!(runs[0].warnings.iter().any(|warning| warning.ends_with("named more than once, read once")));
}

#[test]
fn folders_that_disagree_are_an_error_that_names_both_and_the_row() {
    let folder = tempdir().unwrap();
    let one = copy(&folder, "one", &[]);
    let two = copy(&folder, "two", &[("summary.csv", "naive,100000,97500,", "naive,100000,97499,")]);
    let error = open(&[&one, &two]).unwrap_err().to_string();
    for part in ["two/summary.csv: ", "near/near-7 (orient2d) on naive has other counts", "one/summary.csv", "--judged"]
    {
        assert!(error.contains(part), "{error}");
    }
    let three = copy(&folder, "three", &[("precision.csv", "b2c3d4e5,-60,61", "b2c3d4e5,-60,62")]);
    let error = open(&[&one, &three]).unwrap_err().to_string();
    assert!(error.contains("near/uniform-1 has another row"), "{error}");
}

/// Another level samples more, and other expectations give another status: the rows of the first folder count, and a
/// warning says so.
#[test]
fn another_level_or_status_is_told() {
    let folder = tempdir().unwrap();
    let one = copy(&folder, "one", &[]);
    let change = ("summary.csv", "naive,100000,97500,0,0,0,400,2000,100,", "naive,100000,97400,0,0,0,400,2000,200,");
    let full = copy(&folder, "full", &[change, ("plan.json", "\"quick\"", "\"full\"")]);
    let runs = open(&[&one, &full]).unwrap();
    assert_eq!(rows(&runs)[0], 17);
    let warning = runs[1].warnings.last().unwrap();
    assert!(warning.contains("1 rows have counts at another level than in ") && warning.contains("one"), "{warning}");

    let forgiven = copy(&folder, "forgiven", &[("summary.csv", ",unexpected\n", ",expected\n")]);
    let runs = open(&[&one, &forgiven]).unwrap();
    assert_eq!(rows(&runs)[0], 17);
    let warning = runs[1].warnings.last().unwrap();
    assert!(warning.contains("1 rows have a status by other expectations"), "{warning}");
    assert_eq!(runs[0].summary.iter().filter(|row| !row.status.passes()).count(), 2);
}

/// A bench with copied judgements has no stages: the stages of the run stay, in either order of the folders.
#[test]
fn stages_stay_with_the_folder_that_has_them() {
    let folder = tempdir().unwrap();
    let (run, bench) = (copy(&folder, "run", &[]), copy(&folder, "bench", &[]));
    remove_rows(&bench, "stages.csv");
    for order in [[&*run, &*bench], [&*bench, &*run]] {
        assert_eq!(rows(&open(&order).unwrap()), [17, 7, 10, 4, 3]);
    }
}

#[test]
fn stages_that_are_partly_repeated_are_left_out_with_a_warning() {
    let folder = tempdir().unwrap();
    let one = copy(&folder, "one", &[]);
    // A second scene of the family `near`, which only this folder has.
    let scene = r#"{ "suite": "near", "scene": "near-7","#;
    let another = r#"{ "suite": "near", "scene": "near-8", "scene_id": "a1b2c3d5", "task": "orient2d", "family": "near", "queries": 100000 },
    "#;
    let row = "near,near-7,a1b2c3d4,orient2d,exact,100000,";
    let rows_of_both =
        format!("near,near-8,a1b2c3d5,orient2d,exact,100000,100000,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,ok\n{row}");
    let more = [("plan.json", scene, &*format!("{another}{scene}")), ("summary.csv", row, &*rows_of_both)];
    let two = copy(&folder, "two", &more);
    let runs = open(&[&one, &two]).unwrap();
    assert_eq!(runs[1].summary.len(), 1, "the scene that only this folder has");
    // Rows of `orient2d near exact` would count near-7 twice.
    assert_eq!(runs[1].stages, []);
    let warning = runs[1].warnings.last().unwrap();
    assert!(warning.contains("stages of 1 groups, first orient2d near exact"), "{warning}");
}

/// A pair that one folder has planned and another has run is not missing.
#[test]
fn what_another_folder_has_is_not_missing() {
    let folder = tempdir().unwrap();
    let whole = copy(&folder, "whole", &[]);
    let nothing = copy(&folder, "nothing", &[]);
    remove_rows(&nothing, "summary.csv");
    assert_eq!(rows(&open(&[&nothing]).unwrap())[4], 20);
    for order in [[&*whole, &*nothing], [&*nothing, &*whole]] {
        assert_eq!(rows(&open(&order).unwrap())[4], 3);
    }
}

/// Each counting row is found in its line of the file, with all kinds of line ends; rows that an earlier folder has are
/// not listed.
#[test]
fn rows_know_their_lines() {
    let folder = tempdir().unwrap();
    let (one, two) = (copy(&folder, "one", &[]), copy(&folder, "two", &[]));
    // In the first folder, two rows in the middle are missing, line ends have two characters, and one line is empty.
    let path = one.join("summary.csv");
    let text = std::fs::read_to_string(&path).unwrap();
    let mut lines: Vec<&str> = text.lines().collect();
    let missing: Vec<&str> = lines.splice(5..7, [""]).collect();
    std::fs::write(&path, lines.join("\r\n") + "\r\n").unwrap();
    let runs = open(&[&one, &two]).unwrap();
    let mut checked = 0;
    for run in &runs {
        for file in ["summary.csv", "stages.csv", "precision.csv", "throughput.csv", "contacts.csv", "masses.csv"] {
            let text = std::fs::read_to_string(run.path.join(file)).unwrap();
            let lines: Vec<&str> = text.lines().collect();
            let lined = run.lined(file).unwrap().unwrap();
            assert_eq!(lined.columns.join(","), lines[0], "{file}");
            for (line, row) in lined.rows {
                let at = usize::try_from(line).unwrap() - 1;
                assert_eq!(row.join(","), lines[at].replace('"', ""), "{file}:{line}");
                checked += 1;
            }
        }
    }
    assert!(checked > 40, "{checked} rows");
    let left: Vec<String> =
        runs[1].lined("summary.csv").unwrap().unwrap().rows.into_iter().map(|(_, row)| row.join(",")).collect();
    assert_eq!(left, missing, "only what the first folder lacks");
    assert!(runs[1].summary.is_part() && !runs[0].summary.is_part());
    assert_eq!(runs[0].lined("no.csv"), Ok(None));
}
