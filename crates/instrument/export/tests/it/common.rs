//! Run folders to export, and a reader of the exported files.

use std::fs::File;
use std::path::{Path, PathBuf};

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use predicament_export::{Error, Exported, Format, Watch, export, find};
use predicament_records::{
    Env, FORMAT, FindingRow, Interface, Level, Outcome, Plan, PlannedScene, RunFolder, RunWriter, Shard, TABLES,
    TableSpec, ThroughputRow, serde,
};

predicament_records::table! {
    /// `kinds.csv`: a row with a column of each kind.
    pub struct KindsRow [Clone, PartialEq, Debug, Default] in "kinds.csv" {
        /// A text.
        pub text: String,
        /// A text or none.
        pub some_text: Option<String>,
        /// A whole number.
        pub number: i32,
        /// A whole number or none.
        pub some_number: Option<u64> ["bytes"],
        /// A double.
        pub real: f64 as "Real" ["L"],
        /// A double or none.
        pub some_real: Option<f64>,
        /// Yes or no.
        pub flag: bool,
        /// Yes, no or none.
        pub some_flag: Option<bool>,
    }
}

/// The tables that have a schema here.
pub fn known() -> Vec<TableSpec> {
    TABLES.into_iter().chain([TableSpec::of::<KindsRow>()]).collect()
}

pub struct Patient;

impl Watch for Patient {
    fn is_stopped(&self) -> bool {
        false
    }

    fn done(&mut self) {}
}

/// Exports the runs in these folders.
pub fn exported(folders: &[&Path], format: Format, out: &Path) -> Result<Exported, Error> {
    let folders: Vec<PathBuf> = folders.iter().map(|&folder| folder.to_owned()).collect();
    let found = find(&folders)?;
    Ok(export(&found.runs, &known(), format, out, &mut Patient)?.expect("nobody stops it"))
}

pub fn scene(name: &str) -> PlannedScene {
    PlannedScene {
        suite: "near, or \"far\"".to_owned(),
        scene: name.to_owned(),
        scene_id: "0123456789abcdef".to_owned(),
        task: "orient2d".to_owned(),
        family: "near".to_owned(),
        queries: 3,
    }
}

pub fn plan() -> Plan {
    Plan {
        format: FORMAT,
        created_by: "predicament 0.1.0".to_owned(),
        level: Level::Quick,
        suites: vec![scene("").suite],
        paths: [].into(),
        hashes: [].into(),
        engines: [].into(),
        answers: false,
        permutations: None,
        expected: None,
        timed: true,
        scenes: vec![scene("a"), scene("b")],
        backends: vec!["exact".to_owned(), "naive".to_owned()],
        only: [].into(),
        judged_whole: [].into(),
        ladder: Vec::new(),
        shard: Shard::WHOLE,
        whole: None,
        not_selected: Vec::new(),
        left_out: Vec::new(),
        findings_per_class: 25,
    }
}

pub fn env(started: &str) -> Env {
    Env {
        started: Some(started.to_owned()),
        cpu: Some("Example, 3 GHz".to_owned()),
        cores: Some(8),
        os: "linux x86_64".to_owned(),
        commit: Some("0f1e2d3c".to_owned()),
        dirty: Some(false),
        ..Env::default()
    }
}

pub fn kinds() -> Vec<KindsRow> {
    let full = KindsRow {
        text: "a, \"b\"\nc\u{1F600}".to_owned(),
        some_text: Some("x".to_owned()),
        number: i32::MIN,
        some_number: Some(1 << 48),
        real: 0.1 + 0.2,
        some_real: Some(f64::NEG_INFINITY),
        flag: true,
        some_flag: Some(false),
    };
    let odd = KindsRow { real: -0.0, some_real: Some(5e-324), number: -1, ..KindsRow::default() };
    vec![full, KindsRow::default(), odd]
}

/// A complete run.
pub fn write_run(folder: &Path, started: &str, kinds: &[KindsRow]) {
    start_run(folder, started, kinds).finish(Outcome::Complete).unwrap();
}

/// Starts a run and leaves it unfinished.
pub fn start_run(folder: &Path, started: &str, kinds: &[KindsRow]) -> RunWriter {
    let mut writer = RunWriter::create(folder, &plan(), &env(started), &[TableSpec::of::<KindsRow>()]).unwrap();
    writer.write(kinds).unwrap();
    let sample = |sample| ThroughputRow {
        task: "orient2d".to_owned(),
        family: "near".to_owned(),
        backend: "exact".to_owned(),
        interface: Interface::Batch,
        engine_version: String::new(),
        queries: 3,
        sample,
        ns_per_query: 12.5,
    };
    writer.write(&[sample(0), sample(1)]).unwrap();
    let finding = FindingRow {
        finding_id: "00".repeat(6),
        suite: scene("").suite,
        scene: "a".to_owned(),
        scene_id: scene("a").scene_id,
        task: "orient2d".to_owned(),
        backend: "naive".to_owned(),
        class: predicament_records::Class::SignFlip,
        check: "sign".to_owned(),
        query: String::new(),
        got: "+".to_owned(),
        truth: "−".to_owned(),
        log2_relative_det: Some(f64::NEG_INFINITY),
        distance_over_l: None,
        stage: String::new(),
    };
    writer.write(&[finding]).unwrap();
    writer.commit().unwrap();
    writer
}

/// Reads a Parquet file: its columns, and each cell; `None` for a null.
pub fn read(path: &Path) -> (Vec<String>, Vec<Vec<Option<Cell>>>) {
    let reader = SerializedFileReader::new(File::open(path).unwrap()).unwrap();
    let schema = reader.metadata().file_metadata().schema_descr();
    let names = schema.columns().iter().map(|column| column.name().to_owned()).collect();
    let rows = reader
        .get_row_iter(None)
        .unwrap()
        .map(|row| row.unwrap().get_column_iter().map(|(_, field)| Cell::of(field)).collect::<Vec<_>>());
    (names, rows.collect())
}

/// The number of row groups of a file.
pub fn groups(path: &Path) -> usize {
    SerializedFileReader::new(File::open(path).unwrap()).unwrap().num_row_groups()
}

/// A cell of a Parquet file.
#[derive(Clone, PartialEq, Debug)]
pub enum Cell {
    Text(String),
    Number(i64),
    Real(u64),
    Flag(bool),
    Micros(i64),
}

impl Cell {
    fn of(field: &Field) -> Option<Cell> {
        match field {
            Field::Null => None,
            Field::Str(text) => Some(Cell::Text(text.clone())),
            Field::Long(number) => Some(Cell::Number(*number)),
            Field::Double(number) => Some(Cell::Real(number.to_bits())),
            Field::Bool(flag) => Some(Cell::Flag(*flag)),
            Field::TimestampMicros(micros) => Some(Cell::Micros(*micros)),
            other => panic!("a column of another type: {other:?}"),
        }
    }

    /// True if a CSV cell has the same value.
    pub fn is(cell: Option<&Cell>, text: &str) -> bool {
        match cell {
            None => text.is_empty(),
            Some(Cell::Text(own)) => own == text,
            Some(Cell::Number(own)) => text.parse() == Ok(*own),
            Some(Cell::Real(own)) => text.parse::<f64>().is_ok_and(|number| number.to_bits() == *own),
            Some(Cell::Flag(own)) => text.parse() == Ok(*own),
            Some(Cell::Micros(_)) => false,
        }
    }
}

/// The rows of a CSV table of a run folder.
pub fn csv_rows(folder: &Path, file: &str) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    let run = RunFolder::open(folder).unwrap();
    let each = |_, record: &csv::StringRecord| {
        rows.push(record.iter().map(str::to_owned).collect());
        Ok(())
    };
    run.each_row(file, each).unwrap();
    rows
}

/// The files of a folder with their bytes.
pub fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut files: Vec<_> = entries
        .map(|entry| entry.unwrap().path())
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read(&path).unwrap()))
        .collect();
    files.sort();
    files
}
