//! `selftest`: plants faults and sees whether they are caught.
//!
//! Each faulty backend claims a real contract and runs through the embedded
//! corpora like any other. A fault that produces no finding means that the
//! corpora or the checks have a hole. The real backends of proved contracts
//! run beside them and must come out clean, or the score would mean nothing.

use std::collections::{BTreeMap, BTreeSet};

use predicament_corpus::Level;
use predicament_oracle::faults::Fault;
use predicament_records::Shard;
use predicament_tasks::{Class, Contestant, Watch};

use crate::exit::{self, Failure};
use crate::select::Selector;
use crate::tool::Tool;
use crate::{expectations, interrupt, progress};

const EXAMPLES: &str = "\
Examples:
  predicament selftest
  predicament selftest --list
  predicament selftest -f kettner                  which faults does one part of the corpora catch?
  predicament run -b fault:sos-swapped-term        a planted fault in a run of its own; `gate` turns red";

/// Backends that must have no finding but the expected ones.
const CLEAN: [&str; 4] = ["exact", "sos", "sos:edelsbrunner-mucke", "tolerance"];

/// Plant faulty backends; each must be caught
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Only scenes whose `suite/scene` matches this regular expression
    #[arg(short = 'f', long = "filter", value_name = "RE")]
    pub filter: Option<String>,

    /// Name the faults and stop
    #[arg(long)]
    pub list: bool,
}

/// What caught a fault: class and check, and how often.
type Catches = BTreeMap<(Class, String), u64>;

/// Runs the command.
pub fn run(args: Args, tool: &Tool) -> exit::Outcome {
    if args.list {
        for fault in Fault::ALL {
            say!("fault:{:<24} {}", fault.name(), fault.what());
        }
        return Ok(exit::OK);
    }
    let selector = Selector { filter: args.filter, ..Selector::everything() };
    let selection = selector.select(tool)?;
    let mut scenes = selection.plan(Shard::WHOLE)?;
    let names = CLEAN.iter().map(ToString::to_string);
    let names: Vec<String> = names.chain(Fault::ALL.iter().map(|fault| format!("fault:{}", fault.name()))).collect();
    let contestants: Result<Vec<Box<dyn Contestant>>, String> = names.iter().map(|name| tool.backend(name)).collect();
    let contestants = contestants.map_err(Failure::usage)?;
    let expected = expectations::load(tool, None)?;
    interrupt::listen();
    let bar = progress::bar(scenes.len() as u64, "scenes");
    let quiet = |_: u64| {};
    let mut caught: Vec<Catches> = vec![Catches::new(); contestants.len()];
    let interrupted = |_| Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE };
    for scene in &mut scenes {
        let loaded = scene.take(&selection)?;
        let watch = Watch::new(interrupt::flag(), None, &quiet);
        let case = tool.task(loaded.task).case(&loaded, &watch).map_err(interrupted)?;
        // What an honest backend is known to show catches no faulty one.
        let mut known: BTreeSet<(Class, String)> = BTreeSet::new();
        for (at, (contestant, caught)) in contestants.iter().zip(&mut caught).enumerate() {
            let budget = super::run::budget(Level::Quick);
            let outcome =
                predicament_oracle::run(case.as_ref(), contestant.as_ref(), budget, &watch).map_err(interrupted)?;
            let (level, name) = (Level::Quick.name(), contestant.name());
            let is_expected =
                |class| expected.matching(&loaded.suite, &loaded.name, &name, level).any(|entry| entry.class == class);
            for finding in outcome.findings.iter().filter(|finding| finding.class != Class::Declined) {
                let catch = (finding.class, finding.check.clone());
                if at < CLEAN.len() && is_expected(finding.class) {
                    known.insert(catch);
                } else if !known.contains(&catch) {
                    *caught.entry(catch).or_default() += 1;
                }
            }
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(scorecard(&names, &caught))
}

fn scorecard(names: &[String], caught: &[Catches]) -> u8 {
    let mut holes = 0;
    for (name, caught) in names.iter().zip(caught) {
        let planted = name.starts_with("fault:");
        let good = planted != caught.is_empty();
        holes += usize::from(!good);
        let verdict = match (planted, good) {
            (true, true) => "caught",
            (true, false) => "NOT CAUGHT",
            (false, true) => "clean",
            (false, false) => "NOT CLEAN",
        };
        let by: Vec<String> = caught.iter().map(|((class, check), _)| format!("{class} ({check})")).collect();
        say!("{name:<30} {verdict:<11} {}", by.join(", "));
    }
    say!("{} of {} as they should be", names.len() - holes, names.len());
    if holes == 0 { exit::OK } else { exit::UNEXPECTED }
}
