//! The preparation of a run: its plan, environment, tables and folder.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use predicament_corpus::Level;
use predicament_exact::Exact;
use predicament_predicates::Backend;
use predicament_records::{
    self as records, AnswerRow, CostRow, DecimalsRow, Env, ImportRow, PhaseRow, Plan, RunDir, RunFolder, SampledRow,
    SegmentRow, Shard, TableSpec,
};
use predicament_tasks::{Budget, Contestant};

use crate::exit::Failure;
use crate::judged::JudgedRow;
use crate::select::{Planned, Selection};
use crate::tool::Tool;

/// The sampling budget of a level.
pub fn budget(level: Level) -> Budget {
    match level {
        Level::Quick => Budget::QUICK,
        Level::Full => Budget::FULL,
    }
}

/// The tables of a run folder in addition to those of every run.
pub fn tables(tool: &Tool) -> Vec<TableSpec> {
    let mut tables = tool.tables();
    tables.extend([TableSpec::of::<JudgedRow>(), TableSpec::of::<DecimalsRow>()]);
    tables.extend([TableSpec::of::<SampledRow>(), TableSpec::of::<ImportRow>()]);
    tables
}

/// The tables of [`tables`], with that of all answers and that of the parts of a run if the plan asks for them.
pub fn tables_of(tool: &Tool, plan: &Plan) -> Vec<TableSpec> {
    let mut tables = tables_with(tool, plan.answers);
    tables.extend(plan.whole.is_some().then(TableSpec::of::<SegmentRow>));
    tables
}

/// The tables of [`tables`], with that of all answers if `answers` is set.
pub fn tables_with(tool: &Tool, answers: bool) -> Vec<TableSpec> {
    let mut tables = tables(tool);
    tables.extend(answers.then(TableSpec::of::<AnswerRow>));
    tables
}

/// All tables that a folder of a run or a bench may have, those of every run first.
pub fn every_table(tool: &Tool) -> Vec<TableSpec> {
    let rest = [
        TableSpec::of::<PhaseRow>(),
        TableSpec::of::<AnswerRow>(),
        TableSpec::of::<SegmentRow>(),
        TableSpec::of::<CostRow>(),
    ];
    records::TABLES.into_iter().chain(tables(tool)).chain(rest).collect()
}

/// The plan of a run over these scenes.
pub fn plan(
    tool: &Tool,
    selection: &Selection,
    scenes: &[Planned],
    backends: &[Box<dyn Contestant>],
    shard: Shard,
) -> Plan {
    let judged_whole = tool.tasks().iter().filter(|task| task.is_judged_whole());
    Plan {
        format: records::FORMAT,
        created_by: format!("predicament {}", env!("CARGO_PKG_VERSION")),
        level: match selection.level {
            Level::Quick => records::Level::Quick,
            Level::Full => records::Level::Full,
        },
        suites: selection.suites.iter().map(|suite| suite.name.clone()).collect(),
        paths: selection.paths(),
        hashes: selection.hashes(),
        engines: BTreeMap::new(),
        answers: false,
        permutations: None,
        timed: false,
        scenes: scenes.iter().map(|scene| scene.plan.clone()).collect(),
        backends: backends.iter().map(|backend| backend.name()).collect(),
        only: BTreeMap::new(),
        judged_whole: judged_whole.map(|task| task.name().to_owned()).collect(),
        ladder: Exact.stages().iter().map(|&stage| stage.to_owned()).collect(),
        shard,
        whole: None,
        not_selected: selection.not_selected.clone(),
        left_out: Vec::new(),
        expected: None,
        findings_per_class: budget(selection.level).findings_per_class as u64,
    }
}

/// The machine, the compiler, the source of the tool, and the version of the crate behind `shewchuk`.
pub fn env() -> Env {
    let mut env = Env::collect(env!("CARGO_PKG_VERSION"));
    env.rustc = Some(env!("PREDICAMENT_RUSTC").to_owned());
    env.opt_flags = Some(env!("PREDICAMENT_FLAGS").to_owned());
    env.commit = option_env!("PREDICAMENT_COMMIT").map(str::to_owned);
    env.dirty = option_env!("PREDICAMENT_DIRTY").map(|dirty| dirty == "true");
    env.peers.insert("robust".to_owned(), env!("PREDICAMENT_ROBUST").to_owned());
    env.command_line = crate::host::words().iter().map(|word| word.to_string_lossy().into_owned()).collect();
    env
}

/// The environment of [`env()`], with the versions of the libraries behind these backends.
pub fn env_of(backends: &[Box<dyn Contestant>]) -> Env {
    let mut env = env();
    env.peers.extend(backends.iter().filter_map(|backend| Some((backend.name(), backend.version()?))));
    env
}

/// Refuses to resume a run in which a backend had another version, because its rows would mix two versions.
///
/// # Errors
/// The first such backend, or an unreadable `env.json`.
pub fn same_versions(folder: &Path, backends: &[Box<dyn Contestant>]) -> Result<(), Failure> {
    if RunDir::is_unbegun(folder) {
        return Ok(());
    }
    let then = RunFolder::env(folder).map_err(Failure::usage)?.peers;
    for backend in backends {
        let (name, now) = (backend.name(), backend.version());
        if then.get(&name) != now.as_ref() {
            let told = |version: Option<&String>| {
                version.map_or_else(|| "unknown".to_owned(), |version| format!("`{version}`"))
            };
            return Err(Failure::usage(format!(
                "{}: the version of {name} was {} when the run was begun, and is {} now; restore it, or start a new run",
                folder.join("env.json").display(),
                told(then.get(&name)),
                told(now.as_ref())
            )));
        }
    }
    Ok(())
}

/// The first folder of `stem-1`, `stem-2` and so on that does not exist.
pub fn free_folder(stem: &str) -> PathBuf {
    let mut names = (1..).map(|n| PathBuf::from(format!("{stem}-{n}")));
    names.find(|path| !path.exists()).expect("some number is free")
}
