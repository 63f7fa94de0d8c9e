//! `laws`: the laws of predicates, held against backends on tuples full of ties.

use std::fmt::Write as _;

use clap::ValueEnum;
use predicament_oracle::Watch;
use predicament_oracle::laws::{Row, Survey, survey};
use serde::Serialize;

use crate::exit::{self, Failure};
use crate::markdown::{in_order, markdown};
use crate::{interrupt, progress, roster};

const EXAMPLES: &str = "\
The scenes have about a dozen vertices: whole small grids with one point twice, of which every
tuple is tried, and random ones (small grids, integers, lines, circles and spheres, far from the
origin, mixed exponents), of which --tuples are drawn. The laws are in docs/LAWS.md; none of
them needs a judge but `equals-exact`.

A cell of the table counts violations; with a slash, of how many tuples, where a backend answers about
fewer than others. A dash: declined, or not promised. `2p` are two panics.

Exit code 100 if a backend breaks a law, or panics.

Examples:
  predicament laws
  predicament laws -b sos,sos:edelsbrunner-mucke --tuples 10000000
  predicament laws -b naive,shewchuk,fault:sos-colliding-lift --seed 2
  predicament laws --format csv > laws.csv";

/// What is asked when nobody chooses: those whose promise is proved.
const DEFAULT: &str = "exact,sos,sos:edelsbrunner-mucke,tolerance";

/// Hold backends to the laws of predicates: antisymmetry, transitivity, Grassmann-Plücker relations
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Backends, by commas or repeated
    #[arg(short = 'b', long = "backend", value_name = "BACKEND", default_value = DEFAULT)]
    pub backends: Vec<String>,

    /// Random tuples of each backend, rounded up to whole scenes
    #[arg(long, default_value_t = 1_000_000, value_name = "N")]
    pub tuples: u64,

    /// The seed of the scenes
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub seed: u64,

    /// Threads; all cores if left out
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,

    /// A table of violations with the first of each, or one CSV row for each backend and law
    #[arg(long, value_enum, default_value_t = Format::Md)]
    pub format: Format,
}

/// What to print.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Format {
    /// Backend, law, predicates, tuples, violations, panics, first.
    Csv,
    /// Tables as Markdown, aligned.
    Md,
}

/// One backend and what came of each law.
struct Surveyed {
    backend: String,
    rows: Vec<Row>,
}

/// Runs the command.
pub fn run(args: &Args) -> exit::Outcome {
    super::run::set_threads(args.threads)?;
    let backends = roster::pick(&args.backends)?;
    let plan = Survey { tuples: args.tuples, seed: args.seed };
    interrupt::listen();
    let bar = progress::bar(plan.total() * backends.len() as u64, "tuples");
    let told = |tuples: u64| bar.inc(tuples);
    let watch = Watch::new(interrupt::flag(), None, &told);
    let interrupted = |_| Failure { message: "interrupted; nothing was printed".into(), code: exit::INCOMPLETE };
    let mut surveyed = Vec::new();
    // A panic is counted and the first is told in the report; a million need no million backtraces.
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    for backend in &backends {
        bar.set_message(backend.name());
        let rows = survey(backend.as_ref(), plan, &watch);
        surveyed.push(rows.map(|rows| Surveyed { backend: backend.name(), rows }));
    }
    std::panic::set_hook(hook);
    bar.finish_and_clear();
    let surveyed = surveyed.into_iter().collect::<Result<Vec<_>, _>>().map_err(interrupted)?;
    match args.format {
        Format::Csv => print!("{}", csv_text(&surveyed)?),
        Format::Md => print!("{}", page(args, &surveyed)),
    }
    let holds = surveyed.iter().flat_map(|one| &one.rows).all(Row::holds);
    Ok(if holds { exit::OK } else { exit::UNEXPECTED })
}

#[derive(Serialize)]
struct Record<'a> {
    backend: &'a str,
    law: &'a str,
    predicates: &'a str,
    tuples: u64,
    violations: u64,
    panics: u64,
    first: String,
}

fn csv_text(surveyed: &[Surveyed]) -> Result<String, Failure> {
    let mut csv = csv::Writer::from_writer(Vec::new());
    for Surveyed { backend, rows } in surveyed {
        for Row { law, subject, tuples, violations, panics, first } in rows {
            let first = first.as_ref().map(ToString::to_string).unwrap_or_default();
            let (law, tuples) = (law.name(), *tuples);
            let (violations, panics) = (*violations, *panics);
            csv.serialize(Record { backend, law, predicates: subject, tuples, violations, panics, first })
                .map_err(Failure::usage)?;
        }
    }
    let bytes = csv.into_inner().map_err(Failure::usage)?;
    String::from_utf8(bytes).map_err(Failure::usage)
}

/// The table, and the first violation of each law that a backend breaks.
fn page(args: &Args, surveyed: &[Surveyed]) -> String {
    let names: Vec<&str> = surveyed.iter().map(|one| one.backend.as_str()).collect();
    let mut page = format!("`predicament laws -b {} --tuples {} --seed {}`\n", names.join(","), args.tuples, args.seed);
    let laws = in_order(surveyed.iter().flat_map(|one| &one.rows).map(|row| (row.law, row.subject.as_str())));
    let heads = ["law", "predicates", "tuples"].into_iter().chain(names).map(ToOwned::to_owned).collect();
    let mut rows: Vec<Vec<String>> = Vec::new();
    for (law, subject) in laws {
        let of = |one: &&Surveyed| one.rows.iter().find(|row| row.law == law && row.subject == subject).cloned();
        let rows_of: Vec<Option<Row>> = surveyed.iter().map(|one| of(&one)).collect();
        let most = rows_of.iter().flatten().map(|row| row.tuples).max().unwrap_or(0);
        let cells = rows_of.iter().map(|row| row.as_ref().map_or_else(|| "-".to_owned(), |row| cell(row, most)));
        rows.push([law.name().to_owned(), subject.to_owned(), most.to_string()].into_iter().chain(cells).collect());
    }
    let total = |one: &Surveyed| one.rows.iter().map(|row| row.tuples).sum::<u64>().to_string();
    let totals = surveyed.iter().map(total);
    rows.push(["tuples of all laws", "", ""].into_iter().map(ToOwned::to_owned).chain(totals).collect());
    markdown(&mut page, "Violations", 2, heads, rows);
    for Surveyed { backend, rows } in surveyed {
        for (at, row) in rows.iter().filter(|row| !row.holds()).enumerate() {
            if at == 0 {
                let _ = writeln!(page, "\nFirst of `{backend}`\n");
            }
            if let Some(first) = &row.first {
                let _ = writeln!(page, "* {}: {first}", row.subject);
            }
        }
    }
    page
}

fn cell(row: &Row, most: u64) -> String {
    if row.is_declined() {
        return "-".to_owned();
    }
    let of = if row.tuples == most { String::new() } else { format!("/{}", row.tuples) };
    let panics = if row.panics == 0 { String::new() } else { format!(" + {}p", row.panics) };
    format!("{}{of}{panics}", row.violations)
}
