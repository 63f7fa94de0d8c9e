//! Results as data: `export`, `schema`, and the page about them.
//!
//! These tests run the page's examples for DuckDB and pandas if both are available: `cargo xtask nightly` installs them
//! and names their Python in `PREDICAMENT_PYTHON`. The examples for R run if R has the packages.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use predicament::records::moment;
use predicament::records::{Env, Interface, Outcome, Plan, PlannedScene, RunDir, RunWriter, Shard, ThroughputRow};
use serde_json::Value;
use tempfile::tempdir;

use crate::common::{SUITE, at, column, expect, read, run, tables, unsealed, write};

const PAGE: &str = include_str!("../../../docs/DATA.md");

#[test]
fn every_table_of_a_run_is_exported() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let (out, data) = (at(&folder, "run"), at(&folder, "data"));
    run(&["run", &suite, "-b", "exact,naive", "--answers", "-q", "--out", &out]);
    let told = expect(0, &["data", "export", &out, "--out", &data]);
    assert_eq!(told.stderr, "", "all tables have a schema, and the run is complete");
    assert!(told.stdout.contains("data/answers.parquet: 4 rows, "), "{}", told.stdout);
    let mut names: Vec<String> = tables(&out).into_iter().map(|(name, _)| name.replace(".csv", ".parquet")).collect();
    names.extend(["costs.parquet", "runs.parquet", "scenes.parquet", "throughput.parquet"].map(str::to_owned));
    names.sort();
    let mut there: Vec<String> =
        std::fs::read_dir(&data).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    there.sort();
    assert_eq!(there, names);

    // As CSV, a table has the cells of the run, with four columns in front.
    let csv = at(&folder, "csv");
    expect(0, &["data", "export", &out, "--out", &csv, "--format", "csv"]);
    for (name, text) in tables(&out) {
        let rest = |line: &str| line.splitn(5, ',').nth(4).unwrap_or_default().to_owned();
        let cut: String = read(&csv, &name).lines().map(|line| rest(line) + "\n").collect();
        assert_eq!(cut, text, "{name}");
    }
    let runs = read(&csv, "runs.csv");
    assert_eq!(column(&runs, "outcome"), ["complete"]);
    let date = &column(&runs, "date")[0];
    assert!(moment::seconds(date).is_some(), "the moment is written down: {date}");
}

#[test]
fn what_can_not_be_exported_is_named() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let (out, data) = (at(&folder, "run"), at(&folder, "data"));
    run(&["run", &suite, "-b", "exact,naive", "-q", "--out", &out]);
    let told = expect(2, &["data", "export", &at(&folder, "nowhere"), "--out", &data]);
    assert!(told.stderr.contains("nowhere"), "{}", told.stderr);
    let summary = read(&out, "summary.csv");
    std::fs::write(Path::new(&out).join("summary.csv"), &summary[..summary.len() - 1]).unwrap();
    let told = expect(2, &["data", "export", &out, "--out", &data]);
    assert!(
        told.stderr.contains("summary.csv: ") && told.stderr.contains(" bytes are left of the "),
        "{}",
        told.stderr
    );
    assert_eq!(std::fs::read_dir(&data).unwrap().count(), 0, "nothing was written");
    std::fs::write(Path::new(&out).join("summary.csv"), &summary).unwrap();
    let state = Path::new(&out).join("state.json");
    std::fs::write(&state, unsealed(&out, "state.json").replace("\"complete\"", "\"interrupted\"")).unwrap();
    let told = expect(0, &["data", "export", folder.path().to_str().unwrap(), "--out", &data]);
    assert!(
        told.stderr.contains("1 run not complete (see the column `outcome` of `runs`): run is interrupted"),
        "{}",
        told.stderr
    );
}

#[test]
fn the_page_has_the_schema_and_every_column_a_meaning() {
    let printed = expect(0, &["data", "schema"]).stdout;
    let marked = PAGE
        .split_once("<!-- predicament: schema -->\n")
        .and_then(|(_, rest)| rest.split_once("\n<!-- /predicament -->"));
    let (schema, _) = marked.expect("the page has marks");
    assert!(schema == printed.trim_end(), "run `cargo xtask pages`");

    let json: Value = serde_json::from_str(&expect(0, &["data", "schema", "--format", "json"]).stdout).unwrap();
    let tables = json["tables"].as_array().unwrap();
    assert!(tables.len() >= 19, "{}", tables.len());
    for table in tables {
        assert!(!table["row"].as_str().unwrap().is_empty(), "{table}: say what a row is");
        assert!(!table["columns"].as_array().unwrap().is_empty(), "{table}: define it by `table!`");
        for column in table["columns"].as_array().unwrap() {
            assert!(column["meaning"].as_str().unwrap().len() > 8, "{}: say what {column} is", table["table"]);
        }
    }

    let folder = tempdir().unwrap();
    let page = write(&folder, "page.md", "a\n<!-- predicament: schema -->\nold\n<!-- /predicament -->\nb\n");
    expect(0, &["data", "schema", "--splice", &page]);
    let text = std::fs::read_to_string(&page).unwrap();
    assert_eq!(text, format!("a\n<!-- predicament: schema -->\n{}\n<!-- /predicament -->\nb\n", printed.trim_end()));
    let told = expect(2, &["data", "schema", "--splice", &write(&folder, "none.md", "no marks")]);
    assert!(told.stderr.contains("there is no `<!-- predicament: schema -->`"), "{}", told.stderr);
}

/// The first slower night of [`year`] (from 0), and the task and backend that become slower.
const SLOWER: (u64, &str, &str) = (230, "orient3d", "exact");

/// Writes benches of a year, one folder per night, named by its date.
fn year(folder: &Path, nights: u64) {
    let base = moment::seconds("2026-01-01T03:00:00Z").unwrap();
    let commit = |night: u64| format!("{:040x}", 0xC0FFEE + night / 2);
    for night in (0..nights).filter(|night| night % 41 != 17) {
        let started = moment::text(base + night * 86_400 + night % 7);
        let cpu = if night < 120 { "Example CPU" } else { "Faster CPU" };
        let env = Env {
            started: Some(started.clone()),
            cpu: Some(cpu.to_owned()),
            cores: Some(8),
            os: "linux x86_64".to_owned(),
            commit: Some(commit(night)),
            ..Env::default()
        };
        let mut rows = Vec::new();
        for (at, (task, family)) in
            [("orient2d", "near"), ("orient2d", "grid"), ("orient3d", "near"), ("orient3d", "uniform")]
                .into_iter()
                .enumerate()
        {
            for (backend, ns) in [("exact", 11.0), ("naive", 5.0), ("sos", 17.0)] {
                for sample in 0..3 {
                    let mut ns = ns * if night < 120 { 1.0 } else { 0.7 };
                    ns *= 1.0 + 0.03 * noise(&[night, at as u64, backend.len() as u64, sample]);
                    if night % 97 == 50 {
                        ns *= 3.0; // somebody else used the machine
                    }
                    if night >= SLOWER.0 && (task, backend) == (SLOWER.1, SLOWER.2) {
                        ns *= 1.2;
                    }
                    let [task, family, backend] = [task, family, backend].map(str::to_owned);
                    let engine_version = String::new();
                    rows.push(ThroughputRow {
                        task,
                        family,
                        backend,
                        interface: Interface::Batch,
                        engine_version,
                        queries: 1000,
                        sample,
                        ns_per_query: ns,
                    });
                }
            }
        }
        let mut writer = RunWriter::create(folder.join(&started[..10]), &plan(), &env, &[]).unwrap();
        writer.write(&rows).unwrap();
        writer.finish(Outcome::Complete).unwrap();
    }
}

/// A pseudo-random number from -1 to 1 that depends only on `of`.
fn noise(of: &[u64]) -> f64 {
    let mixed = of.iter().fold(0x9E37_79B9_7F4A_7C15_u64, |sum, part| {
        let sum = (sum ^ part).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        sum ^ (sum >> 29)
    });
    f64::from(u32::try_from(mixed >> 33).unwrap()) / f64::from(1_u32 << 30) - 1.0
}

fn plan() -> Plan {
    let scene = |task: &str, family: &str| PlannedScene {
        suite: "families".to_owned(),
        scene: format!("{family}-{task}"),
        scene_id: format!("{:016x}", task.len() + family.len()),
        task: task.to_owned(),
        family: family.to_owned(),
        queries: 1000,
    };
    Plan {
        format: predicament::records::FORMAT,
        created_by: "predicament 0.1.0".to_owned(),
        level: predicament::records::Level::Quick,
        suites: vec!["families".to_owned()],
        paths: BTreeMap::new(),
        hashes: BTreeMap::new(),
        engines: BTreeMap::new(),
        answers: false,
        permutations: None,
        expected: None,
        timed: true,
        scenes: vec![scene("orient2d", "near"), scene("orient3d", "near")],
        backends: ["exact", "naive", "sos"].map(str::to_owned).into(),
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

#[test]
fn many_nights_are_one_table() {
    let folder = tempdir().unwrap();
    let (nights, csv) = (at(&folder, "nightly"), at(&folder, "csv"));
    year(Path::new(&nights), 12);
    expect(0, &["data", "export", &nights, "--out", &csv, "--format", "csv"]);
    let text = read(&csv, "throughput.csv");
    let mut runs = column(&text, "run");
    assert_eq!(runs.len(), 12 * 36);
    runs.dedup();
    assert_eq!((runs.len(), &*runs[0], &*runs[11]), (12, "2026-01-01", "2026-01-12"));
    assert_eq!(column(&text, "date")[36], "2026-01-02T03:00:01Z");
}

/// The Python that has DuckDB and pandas.
fn python(script: &str, folder: &Path) -> String {
    let python = std::env::var("PREDICAMENT_PYTHON")
        .expect("PREDICAMENT_PYTHON names a Python with duckdb, pandas and pyarrow: `cargo xtask nightly` makes one");
    let done = Command::new(python).args(["-c", script]).current_dir(folder).output().expect("Python starts");
    assert!(done.status.success(), "{script}\n{}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

/// The first block of the page in this language that contains this text.
fn block(language: &str, with: &str) -> &'static str {
    let blocks = PAGE.split("```").skip(1).step_by(2).filter_map(|block| block.split_once('\n'));
    let mut found = blocks.filter(|(of, text)| *of == language && text.contains(with)).map(|(_, text)| text);
    found.next().unwrap_or_else(|| panic!("the page has no block of {language} with `{with}`"))
}

/// The result of a block of SQL, as CSV without quotes.
fn duckdb(sql: &str, folder: &Path) -> String {
    std::fs::write(folder.join("query.sql"), sql).unwrap();
    let script = "import duckdb\nresult = duckdb.sql(open('query.sql').read())\nprint(','.join(result.columns))\n\
                  for row in result.fetchall(): print(','.join(map(str, row)))";
    python(script, folder)
}

/// Runs some scenes and exports them into the folder `data`. Returns the number of wrong answers by task and backend,
/// counted from the run, as CSV.
fn wrong_answers(folder: &tempfile::TempDir) -> String {
    let out = at(folder, "run");
    run(&[
        "run",
        "classics",
        "families",
        "-f",
        "classics/|families/.*orient2d",
        "-b",
        "exact,naive,epsilon:1e-10",
        "-q",
        "--out",
        &out,
    ]);
    expect(0, &["data", "export", &out, "--out", &at(folder, "data")]);
    let mut wrong: BTreeMap<(String, String), [u64; 3]> = BTreeMap::new();
    for row in &RunDir::open(&out).unwrap().summary {
        let of = wrong.entry((row.task.clone(), row.backend.clone())).or_default();
        *of = [of[0] + row.queries, of[1] + row.wrong(), of[2] + u64::from(row.topology > 0)];
    }
    let mut lines: Vec<_> = wrong.into_iter().filter(|(_, [_, wrong, broken])| wrong + broken > 0).collect();
    lines.sort_by_key(|(names, [_, wrong, _])| (std::cmp::Reverse(*wrong), names.clone()));
    assert!(lines.len() >= 2, "{lines:?}");
    let expected: String = std::iter::once("task,backend,queries,wrong,broken\n".to_owned())
        .chain(lines.iter().map(|((task, backend), [queries, wrong, broken])| {
            format!("{task},{backend},{queries},{wrong},{broken}\n")
        }))
        .collect();
    println!("{expected}");
    expected
}

#[test]
#[ignore = "needs R with nanoparquet and dplyr; `cargo xtask nightly` runs it where they are"]
fn page_in_r_counts_wrong_answers_as_the_run_does() {
    let folder = tempdir().unwrap();
    let expected = wrong_answers(&folder);
    let script = at(&folder, "block.R");
    std::fs::write(&script, block("r", "read_parquet")).unwrap();
    // Names are sorted by bytes, whatever the locale of the machine.
    let done = Command::new("Rscript").arg(&script).current_dir(folder.path()).env("LC_ALL", "C").output();
    let done = done.expect("R is installed");
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert_eq!(String::from_utf8(done.stdout).unwrap(), expected);
}

#[test]
#[ignore = "needs Python with duckdb, pandas and pyarrow; `cargo xtask nightly` runs it"]
fn page_of_data_counts_wrong_answers_as_the_run_does() {
    let folder = tempdir().unwrap();
    let expected = wrong_answers(&folder);
    assert_eq!(duckdb(block("sql", "summary.parquet"), folder.path()), expected);
    assert_eq!(python(block("python", "read_parquet"), folder.path()).trim_end(), expected.trim_end());
    // Every table is read, with the types of the schema.
    let json: Value = serde_json::from_str(&expect(0, &["data", "schema", "--format", "json"]).stdout).unwrap();
    let types = [
        ("text", "VARCHAR"),
        ("int64", "BIGINT"),
        ("float64", "DOUBLE"),
        ("bool", "BOOLEAN"),
        ("timestamp", "TIMESTAMP"),
    ];
    let columns = |table: &Value| -> Vec<(String, String)> {
        let columns = table["columns"].as_array().unwrap().iter();
        columns
            .map(|column| (column["name"].as_str().unwrap().to_owned(), column["type"].as_str().unwrap().to_owned()))
            .collect()
    };
    let tables = json["tables"].as_array().unwrap();
    let mut seen = 0;
    for table in &tables[1..] {
        let file = format!("data/{}.parquet", table["table"].as_str().unwrap());
        if folder.path().join(&file).exists() {
            let expected: String = columns(&tables[0])
                .into_iter()
                .chain(columns(table))
                .map(|(name, kind)| {
                    let kind = types.iter().find(|(own, _)| *own == kind).unwrap().1;
                    format!("{name},{kind}\n")
                })
                .collect();
            let told = duckdb(
                &format!("SELECT column_name, column_type FROM (DESCRIBE SELECT * FROM '{file}')"),
                folder.path(),
            );
            assert_eq!(told, format!("column_name,column_type\n{expected}"), "{file}");
            seen += 1;
        }
    }
    assert!(seen >= 15, "{seen}");
}

#[test]
#[ignore = "needs Python with duckdb, pandas and pyarrow; `cargo xtask nightly` runs it"]
fn page_of_data_finds_the_night_that_was_slower() {
    let folder = tempdir().unwrap();
    let nights = at(&folder, "nightly");
    year(Path::new(&nights), 365);
    expect(0, &["data", "export", &nights, "--out", &at(&folder, "data")]);
    let told = duckdb(block("sql", "-- slower"), folder.path());
    println!("{told}");
    let (night, task, backend) = SLOWER;
    let date = moment::text(moment::seconds("2026-01-01T03:00:00Z").unwrap() + night * 86_400);
    let [commit, before] = [night, night - 1].map(|night| format!("{:040x}", 0xC0FFEE + night / 2));
    let lines: Vec<&str> = told.lines().collect();
    assert_eq!(lines.len(), 2, "{told}");
    assert_eq!(lines[0], "date,commit,commit_before,task,backend,interface,families,times_as_slow");
    let start = format!("{} 03:00:0{},{commit},{before},{task},{backend},batch,2,1.", &date[..10], night % 7);
    assert!(lines[1].starts_with(&start), "{} does not start with {start}", lines[1]);

    // In a year without the slower night the query must not raise an alarm.
    let plain = folder.path().join("plain");
    for entry in std::fs::read_dir(&nights).unwrap().map(|entry| entry.unwrap()) {
        if entry.file_name().to_str().unwrap() < &date[..10] {
            std::fs::create_dir_all(&plain).unwrap();
            std::fs::rename(entry.path(), plain.join(entry.file_name())).unwrap();
        }
    }
    expect(0, &["data", "export", plain.to_str().unwrap(), "--out", &at(&folder, "data")]);
    assert_eq!(duckdb(block("sql", "-- slower"), folder.path()).lines().count(), 1);
}
