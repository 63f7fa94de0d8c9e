//! `audit`: each algorithm of the tolerance paper at its thresholds, judged by
//! exact distances.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use predicament_checks::audit::Verdict;
use predicament_oracle::Watch;
use predicament_oracle::audit::{Form, Row, Tally, Violation, audit, rows};
use serde::Serialize;

use crate::exit::{self, Failure};
use crate::{interrupt, progress};

const EXAMPLES: &str = "\
Pairs of simplices are made at the thresholds of the tolerances, with L between 2^-100 and 2^100
(2^-12 and 2^16 for f32). A pair of which no sub-pair is registered is a decision, and is judged
by exact distances: registered up to T-, not registered beyond T+, guarded quantities above their
bounds, weights in [0, 1]. As a second variant, Algorithms 3 and 8 are those that the paper
prints, and the others rest on them.

Written to the folder: audit.csv, audit.md (the table that is printed).

Exit code 100 if an algorithm that is not as printed breaks the guarantee.

Examples:
  predicament audit
  predicament audit --decisions 10000 --seed 2 --out target/audit";

/// Hold the tolerance paper's algorithms to their guarantee by exact distances
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Decisions of each algorithm, precision and variant
    #[arg(long, default_value_t = 1_000_000, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub decisions: u64,

    /// The seed of the pairs
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub seed: u64,

    /// The folder to write; made if missing
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args) -> exit::Outcome {
    if let Some(out) = &args.out {
        std::fs::create_dir_all(out).map_err(|error| Failure::usage(format!("{}: {error}", out.display())))?;
    }
    interrupt::listen();
    let rows = rows();
    let bar = progress::bar(rows.len() as u64 * args.decisions, "decisions");
    let told = |decisions: u64| bar.inc(decisions);
    let watch = Watch::new(interrupt::flag(), None, &told);
    let interrupted = |_| Failure { message: "interrupted; nothing was written".into(), code: exit::INCOMPLETE };
    let mut audited = Vec::new();
    for row in rows {
        bar.set_message(format!("Algorithm {} {} {}", row.algorithm.number(), row.precision.name(), row.variant()));
        audited.push((row, audit(row, args.decisions, args.seed, &watch).map_err(interrupted)?));
    }
    bar.finish_and_clear();
    let page = page(args, &audited);
    print!("{page}");
    if let Some(out) = &args.out {
        write_csv(&out.join("audit.csv"), &audited)?;
        let path = out.join("audit.md");
        std::fs::write(&path, page).map_err(|error| Failure::usage(format!("{}: {error}", path.display())))?;
        println!("\n{}", out.display());
    }
    let broken = audited.iter().any(|(row, tally)| row.form == Form::Corrected && tally.violations() > 0);
    Ok(if broken { exit::UNEXPECTED } else { exit::OK })
}

type Audited = (Row, Tally);

#[derive(Serialize)]
struct Record {
    algorithm: u8,
    dimension: usize,
    pair: &'static str,
    ranks: String,
    precision: &'static str,
    variant: &'static str,
    decisions: u64,
    ended: u64,
    registered: u64,
    not_registered: u64,
    near: u64,
    agree: u64,
    in_band: u64,
    overreach: u64,
    missed: u64,
    unguarded: u64,
    bad_weight: u64,
    weight_error: f64,
    least_guard: Option<f64>,
}

fn record((row, tally): &Audited) -> Record {
    let Row { algorithm, precision, .. } = *row;
    let [first, second] = algorithm.kind.ranks();
    Record {
        algorithm: algorithm.number(),
        dimension: algorithm.dimension.count(),
        pair: algorithm.kind.name(),
        ranks: format!("{first} {second}"),
        precision: precision.name(),
        variant: row.variant(),
        decisions: tally.decisions(),
        ended: tally.ended,
        registered: tally.registered,
        not_registered: tally.decisions() - tally.registered,
        near: tally.near,
        agree: tally.count(Verdict::Agree),
        in_band: tally.count(Verdict::InBand),
        overreach: tally.count(Verdict::Overreach),
        missed: tally.count(Verdict::Missed),
        unguarded: tally.count(Verdict::Unguarded),
        bad_weight: tally.count(Verdict::BadWeight),
        weight_error: tally.weight_error,
        least_guard: tally.room,
    }
}

fn write_csv(path: &Path, audited: &[Audited]) -> Result<(), Failure> {
    let failed = |error: csv::Error| Failure::usage(format!("{}: {error}", path.display()));
    let mut csv = csv::Writer::from_path(path).map_err(failed)?;
    for row in audited {
        csv.serialize(record(row)).map_err(failed)?;
    }
    csv.flush().map_err(|error| Failure::usage(format!("{}: {error}", path.display())))
}

/// The table, and the first violation of each row that has any, as Markdown.
fn page(args: &Args, audited: &[Audited]) -> String {
    let mut page = format!("`predicament audit --decisions {} --seed {}`\n\n", args.decisions, args.seed);
    page += "| Algorithm | precision | variant | decisions | ended | registered | not | near | agree | in band \
             | overreach | missed | unguarded | bad weight | weight error | least guard |\n";
    page += "|---|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for row in audited {
        let Record { algorithm, pair, ranks, precision, variant, decisions, ended, registered, .. } = record(row);
        let Record { not_registered, near, agree, in_band, overreach, missed, unguarded, .. } = record(row);
        let Record { bad_weight, weight_error, least_guard, .. } = record(row);
        #[allow(clippy::cast_precision_loss)] // a share to be read
        let near = format!("{:.1} %", near as f64 / decisions as f64 * 100.0);
        let guard = least_guard.map_or_else(|| "-".to_owned(), |guard| format!("{guard:.3}"));
        let _ = writeln!(
            page,
            "| {algorithm} {pair} ({ranks}) | {precision} | {variant} | {decisions} | {ended} | {registered} | \
             {not_registered} | {near} | {agree} | {in_band} | {overreach} | {missed} | {unguarded} | {bad_weight} | \
             {weight_error:.1e} | {guard} |",
        );
    }
    page += "\nEnded: besides the decisions, pairs of which a sub-pair is registered. Near: decisions with a distance \
             within 2^-20 of T- or T+, of the pair or, if it has no tolerance, of a facet. Least guard: the smallest \
             quotient of a guarded quantity and its lower bound, of registered pairs.\n";
    let first = audited.iter().filter_map(|(row, tally)| Some((row, tally.first.as_ref()?)));
    for (at, (row, violation)) in first.enumerate() {
        if at == 0 {
            page += "\nThe first decision of each row that breaks the guarantee:\n\n";
            page += "| Algorithm | precision | variant | | L | distance over L | first | second |\n";
            page += "|---|---|---|---|---:|---:|---|---|\n";
        }
        let Violation { verdict, length, pair, distance } = violation;
        let [first, second] = pair.each_ref().map(|simplex| points(simplex, row.algorithm.dimension.count()));
        let _ = writeln!(
            page,
            "| {} | {} | {} | {} | {length:e} | {:.2e} | {first} | {second} |",
            row.algorithm.number(),
            row.precision.name(),
            row.variant(),
            verdict.name(),
            distance / length,
        );
    }
    page
}

/// All digits: a violation can be repeated.
fn points(simplex: &[[f64; 3]], dimension: usize) -> String {
    let point = |point: &[f64; 3]| point[..dimension].iter().map(|x| format!("{x:e}")).collect::<Vec<_>>().join(", ");
    simplex.iter().map(|vertex| format!("({})", point(vertex))).collect::<Vec<_>>().join(" ")
}
