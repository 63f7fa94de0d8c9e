//! Folders from other people: no program that a folder names is started.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use predicament::records::{
    Class, EngineFile, Env, FORMAT, FindingRow, Level, Outcome, Plan, PlannedScene, RunWriter, Shard, Status,
    SummaryRow,
};
use tempfile::{TempDir, tempdir};

use crate::common::{SUITE, Told, at, column, expect, read, told, tool, write};

/// The way in which a folder names a program.
#[derive(Clone, Copy, Debug)]
enum Attack {
    /// The name of an engine, with the file in the folder and its digest.
    ByPlan,
    /// The file itself, in place of a backend's name.
    ByName,
}

/// A run folder made by an attacker, whose engine creates a file when it is started.
struct Stranger {
    folder: TempDir,
    backend: String,
}

impl Stranger {
    fn new(attack: Attack, outcome: Outcome) -> Stranger {
        let folder = tempdir().unwrap();
        let suite = write(&folder, "mine.toml", SUITE);
        let honest = at(&folder, "honest");
        expect(100, &["run", &suite, "-b", "exact,naive", "--out", &honest]);
        // Put the engine where the plan says, which is also where the tool looks for engines if this is the current
        // folder.
        let evil = folder.path().join("run/engines/evil");
        let mark = at(&folder, "started");
        let touch = format!("[\"touch\", {mark:?}]");
        let text = format!("name = \"evil\"\nversion = {touch}\nrun = {touch}\n");
        let file = evil.join("engine.toml").display().to_string();
        let sha256 = sha256(&write(&folder, "text", &text));
        let file_of = EngineFile { file: file.clone(), sha256, version: Some("1".to_owned()) };
        let (backend, engines) = match attack {
            Attack::ByPlan => ("engine:evil".to_owned(), BTreeMap::from([("engine:evil".to_owned(), file_of)])),
            Attack::ByName => (format!("engine:{file}"), BTreeMap::new()),
        };
        let run = predicament::records::RunDir::open(Path::new(&honest)).unwrap();
        let backends = vec!["exact".to_owned(), backend.clone()];
        let plan =
            Plan { backends, engines, format: FORMAT, level: Level::Quick, shard: Shard::WHOLE, ..run.plan.clone() };
        let mut writer = RunWriter::create(folder.path().join("run"), &plan, &Env::default(), &[]).unwrap();
        let scene: &PlannedScene = &run.plan.scenes[0];
        let mut row = SummaryRow::new(scene, &backend, scene.queries, Status::Unexpected);
        *row.count_mut(Class::SignFlip) = 1;
        let summary = vec![SummaryRow::new(scene, "exact", scene.queries, Status::Ok), row];
        let finding = &run.findings[0];
        let of_query = FindingRow { backend: backend.clone(), ..finding.clone() };
        let (query, class) = (String::new(), Class::Topology);
        let of_scene = FindingRow { finding_id: "0123456789ab".to_owned(), query, class, ..of_query.clone() };
        writer.write(&summary).unwrap();
        writer.write(&[of_query, of_scene]).unwrap();
        writer.finish(outcome).unwrap();
        std::fs::create_dir_all(&evil).unwrap();
        std::fs::write(&file, &text).unwrap();
        Stranger { folder, backend }
    }

    /// Calls the tool from a folder; also returns whether the engine was started.
    fn call(&self, from: &str, args: &[&str]) -> (Told, bool) {
        let mut command: Command = tool(args);
        command.current_dir(self.folder.path().join(from)).env_remove("PREDICAMENT_ENGINES");
        let told = told(command.output().unwrap());
        let mark = self.folder.path().join("started");
        let is_started = mark.exists();
        let _ = std::fs::remove_file(mark);
        (told, is_started)
    }
}

fn sha256(file: &str) -> String {
    let output = Command::new("sha256sum").arg(file).output().unwrap();
    String::from_utf8(output.stdout).unwrap().split_whitespace().next().unwrap().to_owned()
}

/// Tries the attack with each command that reads a folder, from outside and from inside the folder.
#[test]
#[cfg(target_os = "linux")]
fn no_command_starts_what_a_folder_names() {
    for attack in [Attack::ByPlan, Attack::ByName] {
        let stranger = Stranger::new(attack, Outcome::Complete);
        let run = at(&stranger.folder, "run");
        let ids = column(&read(&run, "findings.csv"), "finding_id");
        let honest = at(&stranger.folder, "honest");
        let (known, junit) = (write(&stranger.folder, "known.toml", ""), at(&stranger.folder, "junit.xml"));
        for from in [".", "run"] {
            let out = |name: &str| at(&stranger.folder, &format!("{name}-{from}-out", from = from.len()));
            let [report, merged, exported, picture, bench] =
                ["report", "merged", "exported", "picture.svg", "bench"].map(out);
            let silent: [&[&str]; 11] = [
                &["report", &run, "--out", &report],
                &["report", &run, &honest, "--baseline", &honest, "--out", &report],
                &["gate", &run, "--junit", &junit],
                &["gate", &run, "--baseline", &honest],
                &["data", "diff", &run, &honest],
                &["shard", "merge", &run, "--out", &merged],
                &["data", "export", &run, "--out", &exported],
                &["draw", "scene", "--finding", &ids[0], "--run", &run, "--out", &picture],
                &["corpus", "expect", "update", &run, "--expected", &known, "--reason", "r", "--dry-run"],
                &["corpus", "expect", "prune", &run, "--expected", &known, "--dry-run"],
                &["bench", "--judged", &run, "--samples", "1", "--out", &bench],
            ];
            for args in silent {
                let (told, is_started) = stranger.call(from, args);
                assert!(!is_started, "{attack:?}, from {from}: {args:?} started it: {}{}", told.stdout, told.stderr);
                assert!(!told.stderr.contains("panicked"), "{args:?}: {}", told.stderr);
            }
            for id in &ids {
                for args in
                    [&["replay", id, "--run", &run][..], &["shrink", id, "--run", &run, "--out", &out("shrink")]]
                {
                    let (told, is_started) = stranger.call(from, args);
                    assert!(
                        !is_started,
                        "{attack:?}, from {from}: {args:?} started it: {}{}",
                        told.stdout, told.stderr
                    );
                    let is_told = told.stderr.contains("--engine") && told.stderr.contains("plan.json");
                    assert!(told.code == 2 && is_told, "{args:?}: {}{}", told.stdout, told.stderr);
                }
            }
        }
    }
}

/// A run, a shrink and a hunt are resumed only with programs that the user names.
#[test]
#[cfg(target_os = "linux")]
fn no_folder_is_gone_on_with_by_its_own_programs() {
    for attack in [Attack::ByPlan, Attack::ByName] {
        let stranger = Stranger::new(attack, Outcome::Interrupted);
        let run = at(&stranger.folder, "run");
        let suite = at(&stranger.folder, "mine.toml");
        let (shrunk, hunted) = (at(&stranger.folder, "shrunk"), at(&stranger.folder, "hunted"));
        let id = column(&read(&at(&stranger.folder, "honest"), "findings.csv"), "finding_id")[0].clone();
        let honest = at(&stranger.folder, "honest");
        expect(0, &["shrink", &id, "--run", &honest, "--out", &shrunk]);
        expect(
            0,
            &[
                "hunt",
                "orient2d",
                "-b",
                "naive",
                "--from",
                &suite,
                "--evaluations",
                "1",
                "--finds",
                "99",
                "--out",
                &hunted,
            ],
        );
        for (folder, file) in [(&shrunk, "shrink.json"), (&hunted, "hunt.json")] {
            let text = read(folder, file).replace("\"naive\"", &format!("{:?}", stranger.backend));
            std::fs::write(Path::new(folder).join(file), text).unwrap();
        }
        for args in [
            &["run", "--resume", &run][..],
            &["shrink", "--resume", &shrunk, "--evaluations", "9000"],
            &["hunt", "--resume", &hunted, "--evaluations", "99"],
        ] {
            for from in [".", "run"] {
                let (told, is_started) = stranger.call(from, args);
                assert!(!is_started, "{attack:?}, from {from}: {args:?} started it: {}{}", told.stdout, told.stderr);
                assert!(told.code == 2 && told.stderr.contains("--engine"), "{args:?}: {}{}", told.stdout, told.stderr);
            }
        }
        // If the user names the engine, it is started; a folder can't do that.
        let file = at(&stranger.folder, "run/engines/evil/engine.toml");
        let (told, is_started) = stranger.call(".", &["run", "--resume", &run, "--engine", &format!("evil={file}")]);
        assert!(is_started == matches!(attack, Attack::ByPlan), "{}{}", told.stdout, told.stderr);
    }
}

/// A note names a suite outside the folder before it is read.
#[test]
fn a_suite_that_a_folder_names_is_told_of() {
    let folder = tempdir().unwrap();
    let (suite, run) = (write(&folder, "mine.toml", SUITE), at(&folder, "run"));
    expect(100, &["run", &suite, "-b", "exact,naive", "--out", &run]);
    let id = &column(&read(&run, "findings.csv"), "finding_id")[0];
    let told = expect(0, &["replay", id, "--run", &run]).stderr;
    assert!(
        told.contains("names the suite file") && told.contains("mine.toml for `mine`; reading that file"),
        "{told}"
    );
}
