//! The chores of the project.
//!
//! `cargo xtask demo` runs the main job and leaves a report to open. `cargo xtask test` is everything that CI runs.
//! `cargo xtask nightly` runs the checks that take too long for every change.
//!
//! There are no dependencies, so that it starts before anything else is built. It also handles one requirement that
//! cargo can't: `rug` builds GMP, and GMP's configure needs `m4`.

mod advisories;
mod book;
mod browser;
mod c_library;
mod ci_page;
mod command;
mod compiler;
mod cpu;
mod data;
mod defects;
mod deny;
mod fuzz;
#[cfg(test)]
mod house;
mod m4;
mod memory;
mod mutants;
mod nightly;
mod pages;
mod prove;
mod python;
#[cfg(test)]
mod recipes;
mod sample;
mod scoreboard;
mod spread;
mod steps;
mod vectors;

use std::process::ExitCode;

const HELP: &str = "\
Chores for predicament.

Usage: cargo xtask <command>

Commands:
  demo   build the tool, run the embedded corpora, leave a report to open
  test   format, clippy, docs, tests, doc tests, the embedded corpora through the gate
  test CRATE...
         format, clippy, docs and the tests of these crates alone, such as `delaunay` (seconds after a change in it)
  nightly [STEP...]
         these steps, or all: lint, tests (whole), c-features, engines (of crates), benches (with peers), packages,
         prove, memory, defects, licences, advisories, ci-page, book, browser, data, wheel, vectors, spread,
         oldest-compiler, strangers (examples outside the workspace), fuzz (ten minutes of each target); prints how each
         step ended and how long it took
  engines [NAME...]
         install and build the engines of other libraries (CGAL, GEOS, libigl, crates, ...) for `run -b engine:NAME`: by
         apt, pip, npm and cargo, into their folders where the client can
  book   the pages of docs/ as a site with a search, by mdbook, in target/book; fails if a link leads nowhere
  browser [--accept]
         the report in Chromium: opened, searched, sorted, turned, printed, in light and dark, at three widths, with
         100,000 findings too, compared with pictures of it, and with faults planted; screenshots in target/browser.
         --accept makes new pictures to compare with. Says what is missing where there is no Chromium, Node.js or npm
  advisories [--db DIR]
         the lock files of cargo against a RustSec advisory database on this machine: DIR, or what cargo-audit or cargo-deny
         has left in cargo's folder; red if a version is vulnerable or unsound. Asks no network
  c-library [--prefix DIR | check | bench]
         the C library in release, with headers and files for pkg-config and CMake, under DIR or target/c-library/release.
         check compiles and runs its examples, as `test` does; bench times calls from C beside calls from Rust
  data   the blocks of docs/DATA.md, run by DuckDB and pandas in an environment of Python in target/data
  defects
         the programs of docs/defects: fetched, compiled, run, and compared with what their pages say (minutes)
  wheel  the Python package by maturin: a wheel and its sources, each installed in an environment of its own, the wheel
         tested (minutes)
  fuzz-seeds
         write what the fuzz targets start from, of the embedded suites, into fuzz/corpus
  pages  the pages that commands print anew: docs/CHECKS.md, docs/BOUNDS.md, docs/COMMANDS.md, the schema in docs/DATA.md
  memory
         the unsafe code of lanes and exact under AddressSanitizer and Miri, by a nightly toolchain; says what is missing
  prove  the constants of filters and the bounds of tolerances by Gappa, and one predicate by Coq too: each constant, the
         least that is proved, and the slack (half a minute). Says what is missing where there is no `gappa` or `coqc`
  sample [--resume]
         the sample report anew: embedded and fetched suites, times, comparison and knobs; `reports/sample` and the
         table of README (40 minutes). --resume keeps the steps that an earlier, stopped sample has done
  scoreboard [--resume]
         the sample scoreboard anew: the engines of whole tasks that are installed, on embedded and fetched suites, with
         times; `reports/scoreboard`
  mutants [--every N] [--from K] [--all-tests] [PACKAGE...]
         the mutation score: every N-th (50th) small change to arithmetic, exact, sos, tolerance, laws and judge, from
         the K-th on (0), by cargo-mutants and the tests of the package; with --all-tests what these miss is tried again
         by those of the packages above; prints what no test noticed (hours)
  mutants --planted [NAME...]
         the faults that are known by name, or those named: each is planted in a copy of the tree, and has to turn its test or
         its run of a suite red (minutes for each)
  mutants --score [--sample N] [--seed S] [--evaluations E] [--only CRATE]
         a sample of the changes of all algorithms (60): which ones the quick run and the gate notice, and which of the
         others a hunt of E evaluations (600) finds; lists the outcomes of comparisons that no suite has. One build has
         all changes (a quarter of an hour)
  spread a run in parts by GNU parallel, HyperQueue and Slurm, each with a part that is killed; says which of them is missing
  setup  only make sure that what the build needs is there (m4, a C compiler, make)
  help   this text

Examples:
  cargo xtask demo
  cargo xtask test
  cargo xtask test delaunay hull
  cargo xtask engines cgal-epick robust-predicates
";

fn main() -> ExitCode {
    if let Some(code) = compiler::called(&std::env::args_os().skip(1).collect::<Vec<_>>()) {
        return code;
    }
    let mut args = std::env::args().skip(1);
    let command = args.next().unwrap_or_else(|| "help".to_owned());
    let rest: Vec<String> = args.collect();
    let is_known = |argument: &str| {
        ["advisories", "c-library", "engines", "mutants", "nightly", "test"].contains(&command.as_str())
            || command == "browser" && argument == "--accept"
            || ["sample", "scoreboard"].contains(&command.as_str()) && argument == "--resume"
    };
    if let Some(extra) = rest.iter().find(|argument| !is_known(argument)) {
        eprintln!("xtask: unexpected argument `{extra}`; see `cargo xtask help`");
        return ExitCode::from(2);
    }
    let done = match command.as_str() {
        "demo" => m4::ensure().and_then(|()| steps::demo()),
        "test" if rest.is_empty() => m4::ensure().and_then(|()| steps::test()),
        "test" => m4::ensure().and_then(|()| steps::test_of(&rest)),
        "nightly" => m4::ensure().and_then(|()| nightly::check(&rest)),
        "book" => book::build(),
        "browser" => m4::ensure().and_then(|()| browser::check(false, !rest.is_empty())),
        "advisories" => advisories::check(&rest),
        "c-library" => c_library::make(&rest),
        "data" => data::check(),
        "defects" => defects::check(),
        "engines" => m4::ensure().and_then(|()| steps::engines(&rest)),
        "memory" => m4::ensure().and_then(|()| memory::check()),
        "mutants" => m4::ensure().and_then(|()| mutants::score(&rest)),
        "wheel" => m4::ensure().and_then(|()| python::wheel()),
        "spread" => m4::ensure().and_then(|()| spread::check()),
        "fuzz-seeds" => m4::ensure().and_then(|()| fuzz::seeds()),
        "pages" => m4::ensure().and_then(|()| pages::write()),
        "prove" => m4::ensure().and_then(|()| prove::check()),
        "sample" => m4::ensure().and_then(|()| sample::make(!rest.is_empty())),
        "scoreboard" => m4::ensure().and_then(|()| scoreboard::make(!rest.is_empty())),
        "setup" => m4::ensure(),
        "help" | "-h" | "--help" => {
            print!("{HELP}");
            Ok(())
        }
        other => Err(format!("no command is called `{other}`; see `cargo xtask help`")),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("xtask: {message}");
            ExitCode::FAILURE
        }
    }
}
