//! The columns in front of every table, which identify the run, and a table of the runs themselves.

use predicament_records::{Column, Kind, PlannedScene, Record, RunFolder, TableSpec, serde};

use crate::Found;

/// The columns that every exported table begins with.
pub const FRONT: [Column; 4] = [
    Column::new(
        "run",
        Kind::Text,
        false,
        "",
        "The run: its folder's name, or the path from the folder that was exported.",
    ),
    Column::new(
        "date",
        Kind::Timestamp,
        true,
        "UTC",
        "When the run began; none in folders made before it was written down.",
    ),
    Column::new(
        "commit",
        Kind::Text,
        true,
        "",
        "The commit that the tool was built from; none where it was built outside of its repository.",
    ),
    Column::new(
        "machine",
        Kind::Text,
        false,
        "",
        "Digest of processor, cores and system: times of two machines are not compared.",
    ),
];

/// The tables that are not files of a run folder but are built from its JSON files.
pub const OWN_TABLES: [TableSpec; 2] = [TableSpec::of::<RunRow>(), TableSpec::of::<PlannedScene>()];

predicament_records::table! {
    /// `runs`: a run or a bench, from its `plan.json`, `env.json` and `state.json`.
    pub struct RunRow [Clone, PartialEq, Eq, Debug] in "runs" {
        /// How it ended: `complete`; `unfinished` if it was killed, `interrupted`, `timeout`; `running` if a process
        /// was writing it during the export.
        pub outcome: String,
        /// What was done: `run` or `bench`.
        pub command: String,
        /// How thorough it was: `quick` or `full`.
        pub level: String,
        /// Which part of the selection it is: `1/1` is all of it.
        pub shard: String,
        /// The scenes that were planned.
        pub scenes: u64,
        /// The backends that were planned, separated by commas.
        pub backends: String,
        /// The tool that made the folder, with its version.
        pub created_by: String,
        /// Whether the sources differed from the commit.
        pub dirty: Option<bool>,
        /// The machine's name.
        pub node: Option<String>,
        /// The processor's name.
        pub cpu: Option<String>,
        /// How many threads could run at once.
        pub cores: Option<u64> ["threads"],
        /// The operating system and architecture.
        pub os: String,
        /// How the system chose the frequency of the first core.
        pub governor: Option<String>,
        /// The compiler's version.
        pub rustc: Option<String>,
        /// The profile that the tool was built with and the flags given to the compiler.
        pub opt_flags: Option<String>,
        /// Whether debug assertions were compiled in: such times are worthless.
        pub debug_assertions: bool,
        /// The command line.
        pub command_line: String,
    }
}

impl RunRow {
    /// The row of a run.
    #[must_use]
    pub fn of(run: &RunFolder) -> RunRow {
        let RunFolder { plan, env, outcome, is_being_written, .. } = run;
        let outcome = if *is_being_written { "running" } else { outcome.name() };
        RunRow {
            outcome: outcome.to_owned(),
            command: if plan.timed { "bench" } else { "run" }.to_owned(),
            level: plan.level.to_string(),
            shard: plan.shard.to_string(),
            scenes: plan.scenes.len() as u64,
            backends: plan.backends.join(","),
            created_by: plan.created_by.clone(),
            dirty: env.dirty,
            node: env.node.clone(),
            cpu: env.cpu.clone(),
            cores: env.cores,
            os: env.os.clone(),
            governor: env.governor.clone(),
            rustc: env.rustc.clone(),
            opt_flags: env.opt_flags.clone(),
            debug_assertions: env.debug_assertions,
            command_line: env.command_line.join(" "),
        }
    }
}

/// The cells of a run for the columns in front.
pub(crate) fn cells(found: &Found, run: &RunFolder) -> [String; 4] {
    let env = &run.env;
    let or_empty = |text: &Option<String>| text.clone().unwrap_or_default();
    [found.run.clone(), or_empty(&env.started), or_empty(&env.commit), env.fingerprint()]
}

/// The rows of a run in the tables that are built from its JSON files.
pub(crate) fn own_rows(run: &RunFolder) -> impl Iterator<Item = Result<Record, predicament_records::Error>> {
    std::iter::once(Record::of(&RunRow::of(run))).chain(run.plan.scenes.iter().map(Record::of))
}
