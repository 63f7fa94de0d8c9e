//! Run folders: written, killed and read back.

use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::Path;

use predicament_records::{
    Class, EngineFile, Env, ExpectedFile, FORMAT, FindingRow, Interface, Level, Outcome, PhaseRow, Plan, PlannedScene,
    PrecisionRow, Record, Row, RowError, RunDir, RunWriter, Shard, StageRow, Status, SummaryRow, TableSpec,
    ThroughputRow,
};
use serde::{Deserialize, Serialize};

/// A row of a task's own table.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct PairRow {
    pub scene: String,
    pub backend: String,
    pub ended: u64,
    pub asked: Option<u64>,
}

impl Row for PairRow {
    const FILE: &'static str = "pairs.csv";
    const COLUMNS: &'static [&'static str] = &["scene", "backend", "ended", "asked"];

    fn check(&self) -> Result<(), RowError> {
        if self.asked.is_some_and(|asked| asked < self.ended) {
            Err(RowError::Contradiction("more have ended"))
        } else {
            Ok(())
        }
    }
}

/// The tables besides the tables that every run has.
pub const MORE: [TableSpec; 1] = [TableSpec::of::<PairRow>()];

pub fn create(folder: &Path, plan: &Plan, env: &Env) -> Result<RunWriter, predicament_records::Error> {
    RunWriter::create(folder, plan, env, &MORE)
}

pub fn resume(folder: &Path) -> Result<(RunWriter, RunDir), predicament_records::Error> {
    RunWriter::resume(folder, Env::default, &MORE)
}

fn scene(name: &str) -> PlannedScene {
    PlannedScene {
        suite: "near, or \"far\"".to_owned(),
        scene: name.to_owned(),
        scene_id: "0123abcd".to_owned(),
        task: "orient2d".to_owned(),
        family: "near".to_owned(),
        queries: 3,
    }
}

fn engine() -> EngineFile {
    EngineFile { file: "far/engine.toml".to_owned(), sha256: "0".repeat(64), version: Some("1".to_owned()) }
}

pub fn plan() -> Plan {
    Plan {
        format: FORMAT,
        created_by: "0.1.0".to_owned(),
        level: Level::Full,
        suites: vec![scene("").suite],
        hashes: [(scene("").suite, "0f1e".to_owned())].into(),
        engines: [("engine:mine".to_owned(), engine())].into(),
        answers: true,
        permutations: Some(7),
        timed: false,
        paths: [(scene("").suite, "far/near.toml".to_owned())].into(),
        scenes: vec![scene("one"), scene("two")],
        backends: vec!["exact".to_owned()],
        only: [].into(),
        judged_whole: ["hull2d".to_owned()].into(),
        ladder: vec!["filter".to_owned(), "wide integer".to_owned()],
        whole: None,
        shard: Shard::new(2, 3).unwrap(),
        not_selected: Vec::new(),
        left_out: Vec::new(),
        expected: Some(ExpectedFile { file: "far/expected.toml".to_owned(), sha256: "0f".to_owned() }),
        findings_per_class: 5,
    }
}

pub fn summary(name: &str) -> SummaryRow {
    let mut row = SummaryRow::new(&scene(name), "exact", 3, Status::Unexpected);
    for (count, class) in (10..).zip(Class::ALL) {
        *row.count_mut(class) = count;
    }
    row
}

pub fn finding() -> FindingRow {
    FindingRow {
        finding_id: "007".to_owned(),
        suite: "near, or \"far\"".to_owned(),
        scene: "one\ntwo".to_owned(),
        scene_id: "0123abcd".to_owned(),
        task: "orient2d".to_owned(),
        backend: "exact".to_owned(),
        class: Class::SignFlip,
        check: String::new(),
        query: "0 1 2".to_owned(),
        got: "+".to_owned(),
        truth: "-".to_owned(),
        log2_relative_det: Some(f64::NEG_INFINITY),
        distance_over_l: Some(5e-324),
        stage: "filter".to_owned(),
    }
}

fn throughput() -> ThroughputRow {
    ThroughputRow {
        task: "orient2d".to_owned(),
        family: "near".to_owned(),
        backend: "exact".to_owned(),
        interface: Interface::Batch,
        engine_version: "0.1.0".to_owned(),
        queries: u64::MAX,
        sample: 0,
        ns_per_query: 0.1 + 0.2,
    }
}

fn stage() -> StageRow {
    StageRow {
        task: "orient2d".to_owned(),
        family: "near".to_owned(),
        backend: "exact".to_owned(),
        stage: "filter".to_owned(),
        settled: 3,
    }
}

fn phase() -> PhaseRow {
    PhaseRow {
        suite: "sizes".to_owned(),
        scene: "torus-1e3".to_owned(),
        scene_id: "0123abcd".to_owned(),
        task: "mesh-locate".to_owned(),
        size: 1000,
        backend: String::new(),
        threads: 2,
        phase: "grid".to_owned(),
        unit: "triangle".to_owned(),
        count: 1000,
        bytes: None,
        sample: 0,
        ns_per_unit: 0.1,
    }
}

pub fn pair() -> PairRow {
    PairRow { scene: "a, \"b\"\nc".to_owned(), backend: "sos".to_owned(), ended: 5, asked: Some(7) }
}

pub fn precision() -> PrecisionRow {
    PrecisionRow {
        suite: "near, or \"far\"".to_owned(),
        scene: "one".to_owned(),
        scene_id: "0123abcd".to_owned(),
        lowest: -1074,
        bits: 2098,
        orient2d: "wide integer".to_owned(),
        orient3d: String::new(),
        incircle: "dyadic".to_owned(),
        insphere: String::new(),
    }
}

/// A run folder with one committed scene, whose writer is gone.
pub fn killed(folder: &Path) {
    let mut writer = create(folder, &plan(), &Env::collect("0.1.0")).unwrap();
    writer.write(&[finding()]).unwrap();
    writer.write(&[summary("one")]).unwrap();
    writer.commit().unwrap();
}

pub fn append(folder: &Path, file: &str, text: &str) {
    let mut file = OpenOptions::new().append(true).open(folder.join(file)).unwrap();
    file.write_all(text.as_bytes()).unwrap();
}

/// Appends to a table as the writer does, and updates the state.
pub fn append_known(folder: &Path, file: &str, text: &str) {
    append(folder, file, text);
    let path = folder.join("state.json");
    let mut state: serde_json::Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
    state["committed"][file] = fs::metadata(folder.join(file)).unwrap().len().into();
    let state_of = state.as_object_mut().unwrap();
    for forgotten in ["digests", "seal"] {
        state_of.remove(forgotten);
    }
    fs::write(&path, state.to_string()).unwrap();
}

#[test]
fn every_table_survives_the_disk() {
    let folder = tempfile::tempdir().unwrap();
    let env = Env::collect("0.1.0");
    let mut writer = create(folder.path(), &plan(), &env).unwrap();
    writer.write(&[summary("one"), summary("two")]).unwrap();
    writer.write(&[finding(), FindingRow { log2_relative_det: None, distance_over_l: None, ..finding() }]).unwrap();
    writer.write(&[throughput()]).unwrap();
    writer.write(&[stage()]).unwrap();
    writer.write(&[pair()]).unwrap();
    assert!(writer.write(&[PairRow { ended: 8, ..pair() }]).is_err());
    writer.append(&[Record::of(&PairRow { asked: None, ..pair() }).unwrap()]).unwrap();
    assert!(Record::of(&PairRow { ended: 8, ..pair() }).is_err());
    writer.write(&[precision()]).unwrap();
    writer.add_map("a map", b"not really a PNG").unwrap();
    assert!(writer.add_map("../escape", b"").is_err());
    writer.finish(Outcome::Complete).unwrap();

    let run = RunDir::open(folder.path()).unwrap();
    assert!(run.is_complete());
    assert_eq!((&run.plan, &run.env), (&plan(), &env));
    assert_eq!((run.plan.argument("near, or \"far\""), run.plan.argument("other")), ("far/near.toml", "other"));
    assert_eq!(run.summary, [summary("one"), summary("two")]);
    assert_eq!(run.findings[0], finding());
    assert_eq!(run.findings[1].log2_relative_det, None);
    let pairs = vec![pair(), PairRow { asked: None, ..pair() }];
    assert_eq!(run.records(MORE[0]), pairs.iter().map(|row| Record::of(row).unwrap()).collect::<Vec<_>>());
    assert_eq!(run.rows::<PairRow>().unwrap(), pairs);
    assert_eq!(run.throughput, [throughput()]);
    assert_eq!(run.stages, [stage()]);
    assert_eq!(run.precision, [precision()]);
    assert_eq!(run.maps, [("a map".to_owned(), b"not really a PNG".to_vec())]);
    assert_eq!(run.warnings, Vec::<String>::new());
}

#[test]
fn columns_are_the_fields_in_their_order() {
    fn header<R: Row>(row: &R) -> Vec<String> {
        let mut csv = csv::Writer::from_writer(Vec::new());
        csv.serialize(row).unwrap();
        let text = String::from_utf8(csv.into_inner().unwrap()).unwrap();
        text.lines().next().unwrap().split(',').map(str::to_owned).collect()
    }
    assert_eq!(header(&summary("")), SummaryRow::COLUMNS);
    assert_eq!(header(&finding()), FindingRow::COLUMNS);
    assert_eq!(header(&throughput()), ThroughputRow::COLUMNS);
    assert_eq!(header(&stage()), StageRow::COLUMNS);
    assert_eq!(header(&precision()), PrecisionRow::COLUMNS);
    assert_eq!(header(&phase()), PhaseRow::COLUMNS);
    // The columns of classes hold the counts of their classes.
    let row = serde_json::to_value(summary("")).unwrap();
    for class in Class::ALL {
        assert_eq!(row[class.name()], summary("").count(class), "{class}");
    }
}

#[test]
fn phases_have_units_threads_and_times() {
    assert_eq!(phase().check(), Ok(()));
    assert!(PhaseRow { count: 0, ..phase() }.check().is_err());
    assert!(PhaseRow { threads: 0, ..phase() }.check().is_err());
    assert!([0.0, -1.0, f64::NAN].iter().all(|&ns_per_unit| PhaseRow { ns_per_unit, ..phase() }.check().is_err()));
}

#[test]
fn a_folder_that_is_not_empty_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    killed(folder.path());
    let before = fs::read(folder.path().join("summary.csv")).unwrap();
    let error = create(folder.path(), &plan(), &Env::default()).err().unwrap();
    assert!(error.to_string().contains("not empty"), "{error}");
    assert_eq!(fs::read(folder.path().join("summary.csv")).unwrap(), before);
}

#[test]
fn a_run_is_incomplete_until_it_says_otherwise() {
    let folder = tempfile::tempdir().unwrap();
    killed(folder.path());
    let run = RunDir::open(folder.path()).unwrap();
    assert_eq!(run.outcome, Outcome::Unfinished);
    assert!(!run.is_complete());
    let missing = run.not_run();
    assert_eq!((missing.len(), &*missing[0].scene, &*missing[0].backend), (1, "two", "exact"));

    let (writer, _) = resume(folder.path()).unwrap();
    writer.finish(Outcome::Complete).unwrap();
    let mut run = RunDir::open(folder.path()).unwrap();
    assert!(!run.is_complete(), "a planned scene is still missing");

    // A backend that runs for some tasks only misses no scenes of other tasks.
    run.plan.only = [("exact".to_owned(), [scene("two").task].into())].into();
    assert_eq!(run.not_run(), missing);
    run.plan.only = [("exact".to_owned(), ["another".to_owned()].into())].into();
    assert!(run.is_complete());
}

#[test]
fn a_line_that_was_cut_off_is_left_out_and_reported() {
    // Also in the middle of a character, and within quotes after a line break.
    for rest in [&b"near,two,01"[..], "near,tw\u{f6}".as_bytes().split_last().unwrap().1, b"007,\"a\nb\nc"] {
        let folder = tempfile::tempdir().unwrap();
        killed(folder.path());
        let path = folder.path().join("findings.csv");
        let mut file = OpenOptions::new().append(true).open(path).unwrap();
        file.write_all(rest).unwrap();
        let run = RunDir::open(folder.path()).unwrap();
        assert_eq!(run.findings, [finding()]);
        let said = format!("findings.csv: {} bytes of an unfinished scene were left out", rest.len());
        assert!(run.warnings[0].contains(&said), "{:?}", run.warnings);
    }
}

#[test]
fn a_line_that_parses_but_lacks_its_end_is_not_trusted() {
    let folder = tempfile::tempdir().unwrap();
    killed(folder.path());
    append(folder.path(), "stages.csv", "orient2d,near,exact,filter,12");
    let run = RunDir::open(folder.path()).unwrap();
    assert_eq!(run.stages, []);
    assert_eq!(run.warnings.len(), 1);
}

#[test]
fn a_complete_run_has_no_cut_lines() {
    let folder = tempfile::tempdir().unwrap();
    create(folder.path(), &plan(), &Env::default()).unwrap().finish(Outcome::Complete).unwrap();
    append(folder.path(), "stages.csv", "orient2d,near,exact,filter,1");
    let error = RunDir::open(folder.path()).unwrap_err().to_string();
    assert!(
        error.contains(
            "stages.csv: 28 bytes were added after the run was complete, according to state.json; restore \
                        both files"
        ),
        "{error}"
    );
}

#[test]
fn a_folder_has_one_writer_at_a_time() {
    let folder = tempfile::tempdir().unwrap();
    let writer = create(folder.path(), &plan(), &Env::default()).unwrap();
    let refused = "another process is writing this run; wait for its end, or stop it";
    assert!(resume(folder.path()).err().unwrap().to_string().ends_with(refused), "beside a live run");
    drop(writer);
    let (first, _) = resume(folder.path()).unwrap();
    assert!(resume(folder.path()).err().unwrap().to_string().ends_with(refused), "two at once");
    drop(first);
    assert!(resume(folder.path()).is_ok());
    let elsewhere = tempfile::tempdir().unwrap();
    assert!(resume(elsewhere.path()).is_err());
    assert_eq!(std::fs::read_dir(elsewhere.path()).unwrap().count(), 0, "a folder that is no run stays as it was");
}

#[test]
fn rows_that_are_there_twice_are_refused() {
    for (file, line) in [("summary.csv", 3), ("precision.csv", 3)] {
        for outcome in [Outcome::Complete, Outcome::Interrupted] {
            let folder = tempfile::tempdir().unwrap();
            let mut writer = create(folder.path(), &plan(), &Env::default()).unwrap();
            writer.write(&[summary("one")]).unwrap();
            writer.write(&[precision()]).unwrap();
            writer.commit().unwrap();
            match file {
                "summary.csv" => writer.write(&[summary("one")]).unwrap(),
                _ => writer.write(&[precision()]).unwrap(),
            }
            writer.commit().unwrap();
            writer.finish(outcome).unwrap();
            let error = RunDir::open(folder.path()).unwrap_err().to_string();
            assert!(error.contains(&format!("{file}:{line}: near, or \"far\", one, ")), "{error}");
            assert!(error.ends_with("is in line 2 already; two processes have written this run"), "{error}");
        }
    }
}

#[test]
fn a_complete_run_that_lost_lines_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let mut writer = create(folder.path(), &plan(), &Env::default()).unwrap();
    writer.write(&[summary("one"), summary("two")]).unwrap();
    writer.finish(Outcome::Complete).unwrap();
    let path = folder.path().join("summary.csv");
    let text = std::fs::read_to_string(&path).unwrap();
    let (kept, lost) = text.trim_end().rsplit_once('\n').unwrap();
    std::fs::write(&path, format!("{kept}\n")).unwrap();
    let error = RunDir::open(folder.path()).unwrap_err().to_string();
    let said = format!("{} bytes are left of the {} that the run wrote", text.len() - lost.len() - 1, text.len());
    assert!(error.contains(&said), "{error}");
}

#[test]
fn a_complete_run_that_was_edited_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let mut writer = create(folder.path(), &plan(), &Env::default()).unwrap();
    writer.write(&[summary("one"), summary("two")]).unwrap();
    writer.finish(Outcome::Complete).unwrap();
    RunDir::open(folder.path()).unwrap();
    let path = folder.path().join("summary.csv");
    let text = std::fs::read_to_string(&path).unwrap();
    // The same number of bytes as before.
    let edited = text.replacen(",10,", ",11,", 1);
    assert_ne!(edited, text);
    std::fs::write(&path, edited).unwrap();
    let error = RunDir::open(folder.path()).unwrap_err().to_string();
    assert!(
        error.contains(
            "summary.csv: its content differs from what the run wrote, according to state.json; restore \
                        both files"
        ),
        "{error}"
    );
}

#[test]
fn a_row_of_no_planned_scene_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let mut writer = create(folder.path(), &plan(), &Env::default()).unwrap();
    writer.write(&[summary("three")]).unwrap();
    writer.finish(Outcome::Complete).unwrap();
    let error = RunDir::open(folder.path()).unwrap_err().to_string();
    assert!(error.contains("summary.csv: a row about near, or \"far\"/three, which the plan does not have"), "{error}");
}

#[test]
fn errors_name_file_and_line() {
    let bad = [
        ("stages.csv", "a,b,c,d,1\na,b,c,d,-1\na,b,c,d,1\n", "stages.csv:3: "),
        ("stages.csv", "a,b,c,d\na,b,c,d,1\n", "stages.csv:2: there are 4 fields, and there should be 5"),
        ("throughput.csv", "t,f,b,single,v,1,0,NaN\n", "throughput.csv:2: ns_per_query is NaN, which is not a time"),
        ("throughput.csv", "t,f,b,single,v,1,0,0\n", "which is not a time"),
        ("precision.csv", "s,n,i,0,-1,double,,,\n", "precision.csv:2: bits is -1, which is not a number of bits"),
        ("summary.csv", "s,n,i,t,b,1,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,fine\n", "summary.csv:3: "),
    ];
    for (file, lines, message) in bad {
        let folder = tempfile::tempdir().unwrap();
        killed(folder.path());
        append_known(folder.path(), file, lines);
        let error = RunDir::open(folder.path()).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    }

    let folder = tempfile::tempdir().unwrap();
    killed(folder.path());
    append_known(folder.path(), "pairs.csv", "a,b,3,4\na,b,5,4\n");
    let error = RunDir::open(folder.path()).unwrap().rows::<PairRow>().unwrap_err().to_string();
    assert!(error.contains("pairs.csv:3: more have ended"), "{error}");
    fs::write(folder.path().join("pairs.csv"), "scene,asked\n").unwrap();
    append_known(folder.path(), "pairs.csv", "");
    let run = RunDir::open(folder.path()).unwrap();
    let error = run.rows::<PairRow>().unwrap_err().to_string();
    assert!(error.contains("pairs.csv:1: the columns must be scene,backend,ended,asked"), "{error}");
    assert_eq!(run.records(MORE[0]), [], "it has other columns");
    fs::write(folder.path().join("stages.csv"), "task,family\n").unwrap();
    append_known(folder.path(), "stages.csv", "");
    let error = RunDir::open(folder.path()).unwrap_err().to_string();
    assert!(error.contains("stages.csv:1: the columns must be task,family,backend"), "{error}");

    for file in ["stages.csv", "pairs.csv"] {
        let folder = tempfile::tempdir().unwrap();
        killed(folder.path());
        fs::remove_file(folder.path().join(file)).unwrap();
        let error =
            RunDir::open(folder.path()).err().unwrap_or_else(|| panic!("{file}: a missing table is no empty table"));
        assert!(error.to_string().contains(file), "{error}");
    }

    fs::write(folder.path().join("plan.json"), "{\n \"format\": 1,\n \"level\": \"slow\"\n}\n").unwrap();
    let error = RunDir::open(folder.path()).unwrap_err().to_string();
    assert!(error.contains("plan.json:3: unknown variant `slow`"), "{error}");
}

#[test]
fn newer_formats_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let plan = Plan { format: FORMAT + 1, ..plan() };
    drop(create(folder.path(), &plan, &Env::default()).unwrap());
    let error = RunDir::open(folder.path()).unwrap_err();
    assert!(error.message.contains("format 2"), "{error}");
}

#[test]
fn rows_that_make_no_sense_are_not_written() {
    let folder = tempfile::tempdir().unwrap();
    let mut writer = create(folder.path(), &plan(), &Env::default()).unwrap();
    assert!(writer.write(&[ThroughputRow { ns_per_query: f64::INFINITY, ..throughput() }]).is_err());
    assert!(writer.write(&[FindingRow { distance_over_l: Some(-1.0), ..finding() }]).is_err());
    assert!(writer.write(&[PrecisionRow { bits: -1, ..precision() }]).is_err());
}
