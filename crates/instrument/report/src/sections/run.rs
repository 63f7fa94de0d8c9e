//! The section on the run: its content, its machine, and its outcome.

use std::collections::BTreeSet;
use std::path::Path;

use super::some_of;
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Env, Outcome, RunDir};
use predicament_records::format::{length, thousands};

pub fn section(runs: &[RunDir]) -> Section {
    let heads = (1..=runs.len()).map(|i| if runs.len() > 1 { format!("run {i}") } else { "run".to_owned() });
    let mut table = Table::new("").words([""]).words(heads);
    for (label, cell) in LINES {
        table.push([Cell::from(*label)].into_iter().chain(runs.iter().map(cell)).collect());
    }
    let mut blocks = vec![Block::Table(table)];
    for run in runs {
        blocks.extend(run.warnings.iter().map(|warning| Block::Note(warning.clone(), Tone::Bad)));
        if run.env.debug_assertions {
            let note = format!("{}: built with debug assertions; its timings mean nothing.", run.path.display());
            blocks.push(Block::Note(note, Tone::Bad));
        }
    }
    Section { id: "run", title: "What was run", lead: String::new(), blocks }
}

type Line = (&'static str, fn(&RunDir) -> Cell);

const LINES: &[Line] = &[
    ("folder", |run| Cell::code(run.path.display().to_string())),
    ("outcome", outcome),
    ("level", |run| run.plan.level.to_string().into()),
    ("shard", |run| Cell::from(run.plan.shard.to_string()).detail(run.env.parts.join(", "))),
    ("suites", |run| named(&run.plan.suites)),
    ("scenes", |run| thousands(length(run.plan.scenes.len())).into()),
    ("queries in them", |run| thousands(run.plan.scenes.iter().map(|scene| scene.queries).sum()).into()),
    ("tasks", tasks),
    ("backends", |run| named(&run.plan.backends)),
    ("findings kept", |run| {
        format!("{} of each class for each scene and backend", thousands(run.plan.findings_per_class)).into()
    }),
    ("version", version),
    ("commit", commit),
    ("command", command),
    ("processor", processor),
    ("system", |run| or_unknown(&run.env.os)),
    ("compiler", |run| or_unknown(run.env.rustc.as_deref().unwrap_or(""))),
    ("flags", |run| or_unknown(run.env.opt_flags.as_deref().unwrap_or(""))),
    ("frequency governor", |run| or_unknown(run.env.governor.as_deref().unwrap_or(""))),
    ("features compiled in", |run| features(&run.env.compiled_features)),
    ("features of the processor", |run| features(&run.env.detected_features)),
    ("peers", peers),
];

fn outcome(run: &RunDir) -> Cell {
    let missing = run.not_run().len();
    match run.outcome {
        Outcome::Complete if missing == 0 => Cell::from(run.outcome.describe()).tone(Tone::Good),
        Outcome::Complete => {
            Cell::from(format!("complete, except for {missing} that were planned but not run")).tone(Tone::Bad)
        }
        _ => Cell::from(run.outcome.describe()).tone(Tone::Bad),
    }
}

/// The command line; the program by its name, without its folder.
fn command(run: &RunDir) -> Cell {
    let mut words = run.env.command_line.clone();
    if let Some(program) = words.first_mut()
        && let Some(name) = Path::new(&*program).file_name()
    {
        *program = name.to_string_lossy().into_owned();
    }
    Cell::code(words.join(" "))
}

fn named(names: &[String]) -> Cell {
    Cell::from(some_of(names.iter().map(String::as_str), 30)).detail(thousands(length(names.len())))
}

fn tasks(run: &RunDir) -> Cell {
    let tasks: BTreeSet<&str> = run.plan.scenes.iter().map(|scene| &*scene.task).collect();
    some_of(tasks.into_iter(), usize::MAX).into()
}

fn version(run: &RunDir) -> Cell {
    format!("{}; folder made by {}, format {}", run.env.package_version, run.plan.created_by, run.plan.format).into()
}

fn commit(run: &RunDir) -> Cell {
    let Some(commit) = &run.env.commit else { return or_unknown("") };
    match run.env.dirty {
        Some(true) => Cell::code(commit).detail("with changes that were not committed").tone(Tone::Notable),
        _ => Cell::code(commit),
    }
}

fn processor(run: &RunDir) -> Cell {
    let Env { cpu, cores, .. } = &run.env;
    let cell = or_unknown(cpu.as_deref().unwrap_or(""));
    match cores {
        Some(cores) => cell.detail(format!("{} threads", thousands(*cores))),
        None => cell,
    }
}

fn features(names: &[String]) -> Cell {
    if names.is_empty() { Cell::from("none beyond the baseline") } else { names.join(", ").into() }
}

fn peers(run: &RunDir) -> Cell {
    let peers = run.env.peers.iter().map(|(name, version)| format!("{name} {version}"));
    match peers.collect::<Vec<_>>().join(", ") {
        none if none.is_empty() => Cell::from("none").tone(Tone::Muted),
        peers => peers.into(),
    }
}

fn or_unknown(text: &str) -> Cell {
    if text.is_empty() { Cell::from("unknown").tone(Tone::Muted) } else { text.into() }
}
