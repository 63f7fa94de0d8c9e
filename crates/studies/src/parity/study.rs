//! The command line of the study of parity, and its survey.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use predicament_tasks::Contestant;

use super::{Census, Found, Kind, Recipe, Small, search, smallest, suite, table};
use crate::{Error, File, Host, Precision, Study};

/// Random polygons that cross an odd number of times once merged.
#[derive(Clone, Debug, clap::Args)]
pub struct Parity {
    /// Pairs of each recipe, in each precision
    #[arg(long, default_value_t = 40_000, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub pairs: u64,

    /// The seed of the pairs
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub seed: u64,

    /// Finds to shrink in each precision, evenly spread over all
    #[arg(long, default_value_t = 200, value_name = "N")]
    pub shrink: usize,

    /// Threads; all if left out
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,

    /// The folder to write; made if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

/// The finds in one precision.
#[derive(Clone, PartialEq, Debug)]
pub struct Searched {
    /// The precision of the tolerances.
    pub precision: Precision,
    /// The counts, and all finds.
    pub census: Census,
    /// The smallest pairs that finds were shrunk to.
    pub smallest: BTreeMap<Kind, Small>,
}

/// So many pairs of each recipe between two looks at the watch.
const PART: u64 = 500;
/// So many finds.
const FINDS: usize = 16;

impl Study for Parity {
    const NAME: &'static str = "parity";
    const ASKS: &'static str = "Count odd crossings of random polygons after merging, and shrink those found";
    const HELP: &'static str = "\
Two closed curves cross an even number of times. Pairs of random simple polygons, with a few corners
far away and a few within some multiples of sigma of each other, are registered by exact, perturbed
and tolerant predicates, merged where they are in contact, and their crossings counted, for each rule
about where merged points sit. There are three recipes, and pairs for the tolerances of either precision.

Written to the folder: parity.csv and parity.md (the counts), smallest.toml (the smallest pairs found
with an odd number of crossings, as a suite that `predicament run` reads; empty of scenes without --shrink).

Examples:
  predicament parity --out target/parity
  predicament parity --pairs 2000 --shrink 50 --out target/parity
  predicament run target/parity/smallest.toml -b exact,sos,tolerance,tolerance:f32";

    type Measured = Vec<Searched>;

    /// Exact, perturbed, and the tolerances of each precision.
    fn backends(&self) -> Vec<String> {
        let tolerances = Precision::ALL.map(Precision::tolerance);
        ["exact", "sos"].into_iter().chain(tolerances).map(ToOwned::to_owned).collect()
    }

    fn threads(&self) -> Option<usize> {
        self.threads
    }

    fn out(&self) -> Option<&Path> {
        Some(&self.out)
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Vec<Searched>, Error> {
        let [exact, sos, tolerances @ ..] = backends else {
            return Err(Error::unfit("parity needs exact, sos and the tolerances"));
        };
        let one = |(precision, tolerance): (Precision, &&dyn Contestant)| {
            let backends = [*exact, *sos, *tolerance];
            let census = self.count(backends, precision, host)?;
            let smallest = self.shrink(backends, precision, &census, host)?;
            Ok(Searched { precision, census, smallest })
        };
        Precision::ALL.into_iter().zip(tolerances).map(one).collect()
    }

    fn rows(&self, measured: &Vec<Searched>) -> Result<Vec<File>, Error> {
        Ok(vec![table::csv(measured)?])
    }

    fn page(&self, measured: &Vec<Searched>) -> String {
        table::page(self, measured)
    }

    fn suites(&self, measured: &Vec<Searched>) -> Result<Vec<File>, Error> {
        Ok(vec![suite::smallest(self, measured)?])
    }
}

impl Parity {
    fn count(&self, backends: [&dyn Contestant; 3], precision: Precision, host: &dyn Host) -> Result<Census, Error> {
        let recipes = Recipe::ALL.len() as u64;
        host.begin(self.pairs * recipes, "pairs");
        let mut census = Census::default();
        let mut from = 0;
        while from < self.pairs {
            let to = (from + PART).min(self.pairs);
            census = census.and(search(&backends, precision, self.seed, from..to));
            host.watch().done((to - from) * recipes)?;
            from = to;
        }
        Ok(census)
    }

    fn shrink(
        &self,
        [exact, _, tolerance]: [&dyn Contestant; 3],
        precision: Precision,
        census: &Census,
        host: &dyn Host,
    ) -> Result<BTreeMap<Kind, Small>, Error> {
        // exact and perturbed finds are a fault of ours, and are counted; here are those of tolerances
        let name = tolerance.name();
        let finds: Vec<&Found> = census.found.iter().filter(|found| found.backend == name).collect();
        let step = finds.len().div_ceil(self.shrink.max(1)).max(1);
        let chosen: Vec<&Found> = finds.into_iter().step_by(step).take(self.shrink).collect();
        host.begin(chosen.len() as u64, "finds");
        let mut kept = BTreeMap::new();
        for some in chosen.chunks(FINDS) {
            for (kind, small) in smallest([tolerance, exact], precision, self.seed, some) {
                small.keep(&mut kept, kind);
            }
            host.watch().done(some.len() as u64)?;
        }
        Ok(kept)
    }
}
