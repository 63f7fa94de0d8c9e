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
        "The start of the run; null in older folders, which do not record it.",
    ),
    Column::new(
        "commit",
        Kind::Text,
        true,
        "",
        "The commit that the tool was built from; null if it was built outside of its repository.",
    ),
    Column::new(
        "machine",
        Kind::Text,
        false,
        "",
        "A digest of processor, cores and system; times of different machines are not comparable.",
    ),
];

/// The tables that are not files of a run folder but are built from its JSON files.
pub const OWN_TABLES: [TableSpec; 2] = [TableSpec::of::<RunRow>(), TableSpec::of::<PlannedScene>()];

predicament_records::table! {
    /// `runs`: a run or a bench, from its `plan.json`, `env.json` and `state.json`.
    pub struct RunRow [Clone, PartialEq, Eq, Debug] in "runs" {
        /// The outcome: `complete`; `unfinished` if the run was killed; `interrupted`; `timeout`; `running` if a
        /// process was writing the folder during the export.
        pub outcome: String,
        /// The command: `run` or `bench`.
        pub command: String,
        /// The level: `quick` or `full`.
        pub level: String,
        /// The part of the selection; `1/1` is the whole.
        pub shard: String,
        /// The number of planned scenes.
        pub scenes: u64,
        /// The planned backends, separated by commas.
        pub backends: String,
        /// The tool that wrote the folder, with its version.
        pub created_by: String,
        /// True if the sources differed from the commit.
        pub dirty: Option<bool>,
        /// The machine's name.
        pub node: Option<String>,
        /// The processor's name.
        pub cpu: Option<String>,
        /// The number of threads that can run at once.
        pub cores: Option<u64> ["threads"],
        /// The operating system and architecture.
        pub os: String,
        /// The frequency governor of the first core.
        pub governor: Option<String>,
        /// The compiler's version.
        pub rustc: Option<String>,
        /// The build profile of the tool and the compiler flags.
        pub opt_flags: Option<String>,
        /// True if debug assertions were compiled in; then the times are worthless.
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
