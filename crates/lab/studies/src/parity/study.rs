//! The survey of the study of parity.

use predicament_tasks::Contestant;

use super::searched::{Measured, Parity, Searched};
use super::{Census, Find, Recipe, Smallest, search, smallest, space, suite, table};
use crate::{Common, Error, File, Host, Precision, Study};

/// The number of pairs of each recipe between two checks of the watch.
const PART: u64 = 500;
/// The default number of finds to shrink.
const FINDS: usize = 16;

impl Study for Parity {
    const NAME: &'static str = "parity";
    const ASKS: &'static str = "Count odd crossings of random polygons after merging, and shrink the pairs found";
    const HELP: &'static str = "\
Two closed curves cross an even number of times. The study makes pairs of random simple polygons, with a few corners \
far away and a few within some multiples of sigma of each other. Exact, perturbed and tolerant predicates register \
their contacts; the polygons are merged where they are in contact; and their crossings are counted for each rule for \
the place of merged points. There are three recipes, and pairs for the tolerances of each precision.

Files in the folder: parity.csv and parity.md (the counts), smallest.toml (the smallest pairs found with an odd \
number of crossings, as a suite that `predicament run` reads; without --shrink it has no scenes).

With `--dimension 3` the pairs are closed surfaces, which cross in closed curves. The study counts curves with loose \
ends, and triangles whose boundary pierces the other surface an odd number of times, for four recipes; \
parity-space.csv replaces parity.csv.

Examples:
  predicament study parity --out target/parity
  predicament study parity --pairs 2000 --shrink 50 --out target/parity
  predicament study parity --dimension 3 --pairs 2000 --out target/parity-space
  predicament run target/parity/smallest.toml -b exact,sos,tolerance,tolerance:f32";

    const NEEDS_FOLDER: bool = true;
    type Measured = Measured;

    /// The backends: exact, perturbed, and the tolerances of each precision; in space also perturbed per mesh.
    fn backends(&self) -> Vec<String> {
        let tolerances = Precision::ALL.map(Precision::tolerance);
        let per_mesh = (self.dimension == 3).then_some("sos:per-mesh");
        ["exact", "sos"].into_iter().chain(tolerances).chain(per_mesh).map(ToOwned::to_owned).collect()
    }

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Measured, Error> {
        let [exact, sos, double, single, more @ ..] = backends else {
            return Err(Error::unfit("parity needs exact, sos and the tolerances"));
        };
        let precisions = Precision::ALL.into_iter().zip([*double, *single]);
        if let [per_mesh] = more {
            let backends = [*exact, *sos, *per_mesh, *double, *single];
            let one = |(precision, tolerance): (Precision, &dyn Contestant)| {
                let census = self.count_surfaces(&backends, precision, host)?;
                let place = census.backends.iter().position(|name| *name == tolerance.name());
                let finds = census.found.iter().filter(|found| Some(found.backend) == place).collect();
                let smallest = self.shrink([tolerance, *exact], precision, finds, host)?;
                Ok(Searched { precision, census, smallest })
            };
            return Ok(Measured::Space(precisions.map(one).collect::<Result<_, Error>>()?));
        }
        let one = |(precision, tolerance): (Precision, &dyn Contestant)| {
            let backends = [*exact, *sos, tolerance];
            let census = self.count(backends, precision, host)?;
            // Finds of exact and perturbed signs would be our own errors and are only counted; the finds of tolerances
            // are shrunk.
            let name = tolerance.name();
            let finds = census.found.iter().filter(|found| found.backend == name).collect();
            let smallest = self.shrink([tolerance, *exact], precision, finds, host)?;
            Ok(Searched { precision, census, smallest })
        };
        Ok(Measured::Plane(precisions.map(one).collect::<Result<_, Error>>()?))
    }

    fn rows(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        Ok(vec![match measured {
            Measured::Plane(searched) => table::csv(searched)?,
            Measured::Space(searched) => space::csv(searched)?,
        }])
    }

    fn page(&self, measured: &Measured) -> String {
        match measured {
            Measured::Plane(searched) => table::page(self, searched),
            Measured::Space(searched) => space::page(self, searched),
        }
    }

    fn suites(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        Ok(vec![match measured {
            Measured::Plane(searched) => suite::polygons(self, searched)?,
            Measured::Space(searched) => suite::surfaces(self, searched)?,
        }])
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
            census = census.and(search(&backends, precision, self.common.seed, from..to));
            host.watch().done((to - from) * recipes)?;
            from = to;
        }
        Ok(census)
    }

    /// Shrinks some of the finds of a tolerance backend.
    fn shrink<F: Find>(
        &self,
        [tolerance, exact]: [&dyn Contestant; 2],
        precision: Precision,
        finds: Vec<&F>,
        host: &dyn Host,
    ) -> Result<Smallest<F>, Error> {
        let step = finds.len().div_ceil(self.shrink.max(1)).max(1);
        let chosen: Vec<&F> = finds.into_iter().step_by(step).take(self.shrink).collect();
        host.begin(chosen.len() as u64, "finds");
        let mut kept = Smallest::<F>::new();
        for some in chosen.chunks(FINDS) {
            for (kind, small) in smallest([tolerance, exact], precision, self.common.seed, some) {
                small.keep(&mut kept, kind);
            }
            host.watch().done(some.len() as u64)?;
        }
        Ok(kept)
    }

    fn count_surfaces(
        &self,
        backends: &[&dyn Contestant],
        precision: Precision,
        host: &dyn Host,
    ) -> Result<space::Census, Error> {
        let recipes = space::Recipe::ALL.len() as u64;
        host.begin(self.pairs * recipes, "pairs");
        let mut census = space::Census::default();
        let mut from = 0;
        while from < self.pairs {
            let to = (from + PART).min(self.pairs);
            census = census.and(space::search(backends, precision, self.common.seed, from..to));
            host.watch().done((to - from) * recipes)?;
            from = to;
        }
        Ok(census)
    }
}
