//! Exported cells equal the cells of the run folders.

use std::path::Path;

use predicament_export::{FRONT, Format};
use predicament_records::{Row, RunFolder, ThroughputRow, moment};
use tempfile::tempdir;

use crate::common::{Cell, KindsRow, csv_rows, exported, files, groups, kinds, read, start_run, write_run};

/// Asserts that an export has the cells of these runs, table by table, behind the columns in front.
fn assert_same(runs: &[&Path], out: &Path) {
    let mut tables: Vec<String> = runs.iter().flat_map(|run| RunFolder::open(run).unwrap().tables().unwrap()).collect();
    tables.sort();
    tables.dedup();
    assert!(tables.len() >= 5, "{tables:?}");
    for file in tables {
        let (names, rows) = read(&out.join(file.replace(".csv", ".parquet")));
        let mut rows = rows.iter();
        for run in runs.iter().filter(|run| run.join(&file).exists()) {
            let mut expected = csv_rows(run, &file).into_iter();
            assert_eq!(names[FRONT.len()..], expected.next().unwrap(), "{file}");
            for (line, expected) in expected.enumerate() {
                let row = rows.next().unwrap_or_else(|| panic!("{file} ends before row {line}"));
                assert_eq!(row.len(), FRONT.len() + expected.len());
                for (cell, expected) in row[FRONT.len()..].iter().zip(&expected) {
                    assert!(Cell::is(cell.as_ref(), expected), "{file}: {cell:?} is not `{expected}`");
                }
            }
        }
        assert_eq!(rows.next(), None, "{file} has more rows");
    }
}

#[test]
fn a_cell_that_differs_is_seen() {
    let real = Cell::Real(0.3_f64.to_bits());
    assert!(Cell::is(Some(&real), "0.3") && !Cell::is(Some(&real), "0.30000000000000004"));
    assert!(Cell::is(None, "") && !Cell::is(None, "0") && !Cell::is(Some(&Cell::Number(0)), ""));
    assert!(!Cell::is(Some(&Cell::Text("a".to_owned())), "a "));
}

#[test]
fn every_cell_of_csv_is_the_cell_of_parquet() {
    let folder = tempdir().unwrap();
    let [first, second, out] = ["first", "second", "out"].map(|name| folder.path().join(name));
    write_run(&first, "2026-01-05T03:00:00Z", &kinds());
    write_run(&second, "2026-01-06T03:00:00Z", &kinds()[..1]);
    exported(&[&second, &first], Format::Parquet, &out).unwrap();
    assert_same(&[&first, &second], &out);

    // Nulls are null in optional columns, and empty texts are texts.
    let (names, rows) = read(&out.join("kinds.parquet"));
    let cell = |row: usize, name: &str| rows[row][names.iter().position(|own| own == name).unwrap()].clone();
    for name in ["some_text", "some_number", "some_real", "some_flag"] {
        assert!(cell(0, name).is_some() && cell(1, name).is_none(), "{name}");
    }
    assert_eq!(cell(1, "text"), Some(Cell::Text(String::new())));
    assert_eq!(cell(2, "Real"), Some(Cell::Real((-0.0_f64).to_bits())));
    // The columns in front identify the runs; the earlier run is first, whatever the names.
    assert_eq!(names[..4], ["run", "date", "commit", "machine"]);
    let runs: Vec<Option<Cell>> = (0..4).map(|row| cell(row, "run")).collect();
    assert_eq!(runs, ["first", "first", "first", "second"].map(|run| Some(Cell::Text(run.to_owned()))));
    let began = moment::seconds("2026-01-06T03:00:00Z").unwrap();
    assert_eq!(cell(3, "date"), Some(Cell::Micros(i64::try_from(began).unwrap() * 1_000_000)));
    assert_eq!(cell(3, "commit"), Some(Cell::Text("0f1e2d3c".to_owned())));
    let (names, rows) = read(&out.join("scenes.parquet"));
    assert_eq!((names.len(), rows.len()), (10, 4));
}

/// Handwritten folders, one of an older version: without a date, commit or digests.
#[test]
fn older_folders_are_exported_with_nulls() {
    let folder = tempdir().unwrap();
    let [checked, timed] = ["checked", "timed"].map(|name| Path::new("../tasks/tests/data").join(name));
    let told = exported(&[&checked, &timed], Format::Parquet, folder.path()).unwrap();
    assert_same(&[&checked, &timed], folder.path());
    let (_, rows) = read(&folder.path().join("summary.parquet"));
    assert_eq!((&rows[0][1], &rows[0][2]), (&None, &None));
    // Tables of tasks have no schema here: their columns are text, and a note says so.
    assert!(
        told.notes.iter().any(|note| note.starts_with("contacts.csv: this tool does not have a schema")),
        "{:?}",
        told.notes
    );
    assert!(!told.notes.iter().any(|note| note.contains("summary.csv")));
}

#[test]
fn a_large_table_has_groups_and_the_same_cells() {
    let folder = tempdir().unwrap();
    let [run, out] = ["run", "out"].map(|name| folder.path().join(name));
    let rows: Vec<KindsRow> = (0..70_000)
        .map(|number| KindsRow { number, some_real: (number % 3 == 0).then_some(0.5), ..KindsRow::default() })
        .collect();
    write_run(&run, "2026-01-05T03:00:00Z", &rows);
    exported(&[&run], Format::Parquet, &out).unwrap();
    assert_eq!(groups(&out.join("kinds.parquet")), 2);
    assert_same(&[&run], &out);
}

#[test]
fn the_same_folders_give_the_same_bytes() {
    let folder = tempdir().unwrap();
    let all = folder.path().join("all");
    for (name, day) in [("b/run", 5), ("b/bench", 6), ("a", 7)] {
        write_run(&all.join(name), &format!("2026-01-0{day}T03:00:00Z"), &kinds());
    }
    for format in [Format::Parquet, Format::Csv] {
        let [one, two] = [1, 2].map(|n| folder.path().join(format!("{}{n}", format.ending())));
        exported(&[&all], format, &one).unwrap();
        exported(&[&all], format, &two).unwrap();
        // A second export to the same place.
        exported(&[&all], format, &two).unwrap();
        assert!(!files(&one).is_empty() && files(&one) == files(&two));
        assert!(files(&one).iter().all(|(name, _)| name.ends_with(format.ending())), "nothing is left beside them");
    }
    let text = std::fs::read_to_string(folder.path().join("csv1/throughput.csv")).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], format!("run,date,commit,machine,{}", ThroughputRow::COLUMNS.join(",")));
    assert!(lines[1].starts_with("b/run,2026-01-05T03:00:00Z,0f1e2d3c,"), "{}", lines[1]);
    assert!(lines[6].starts_with("a,2026-01-07T03:00:00Z,") && lines.len() == 7, "{lines:?}");
}

#[test]
fn runs_that_are_not_complete_are_marked() {
    let folder = tempdir().unwrap();
    let all = folder.path().join("all");
    write_run(&all.join("whole"), "2026-01-05T03:00:00Z", &kinds());
    drop(start_run(&all.join("killed"), "2026-01-06T03:00:00Z", &kinds()));
    // Rows written after the last commit do not belong to a finished scene.
    let mut cut = std::fs::OpenOptions::new().append(true).open(all.join("killed/kinds.csv")).unwrap();
    std::io::Write::write_all(&mut cut, b"half a ro").unwrap();
    let running = start_run(&all.join("running"), "2026-01-07T03:00:00Z", &kinds());
    let out = folder.path().join("out");
    let told = exported(&[&all], Format::Parquet, &out).unwrap();
    drop(running);
    let outcome = |run: &str, outcome: &str| (run.to_owned(), outcome.to_owned());
    assert_eq!(told.incomplete, [outcome("killed", "unfinished"), outcome("running", "running")]);
    assert!(told.notes[0].ends_with("kinds.csv: 9 bytes of an unfinished scene were left out"), "{:?}", told.notes);
    let (names, rows) = read(&out.join("runs.parquet"));
    let place = names.iter().position(|name| name == "outcome").unwrap();
    let outcomes: Vec<&Option<Cell>> = rows.iter().map(|row| &row[place]).collect();
    assert_eq!(
        outcomes,
        ["complete", "unfinished", "running"].map(|text| Some(Cell::Text(text.to_owned()))).iter().collect::<Vec<_>>()
    );
    assert_eq!(read(&out.join("kinds.parquet")).1.len(), 9);
}
