//! The command line of the study of resolution, its survey and its rows.

use predicament_predicates::Dimension;
use predicament_tasks::{AnswerError, Contestant};
use serde::Serialize;

use super::{Ask, FEATURES, Feature, Location, Survey, length, location, plots, survey, table};
use crate::contacts::contacts;
use crate::{Common, Error, File, Host, Precision, Study};

/// Features of every size and shallow crossings, as backends register them.
#[derive(Clone, Debug, clap::Args)]
pub struct Resolution {
    /// Backends
    #[arg(
        short = 'b',
        long = "backend",
        value_name = "BACKEND",
        default_value = "tolerance,tolerance:f32,sos,sos:per-mesh,exact"
    )]
    pub backends: Vec<String>,

    /// Positions for each size, and pairs of edges for each angle
    #[arg(long, default_value_t = 200, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub trials: u32,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// Shares of features that survive, and errors of crossings.
#[derive(Clone, Debug)]
pub struct Resolved {
    /// Each feature under each backend.
    pub features: Vec<(&'static Feature, String, Survey)>,
    /// The shallow crossings of each backend.
    pub crossings: Vec<(String, Vec<Location>)>,
}

impl Study for Resolution {
    const NAME: &'static str = "resolution";
    const ASKS: &'static str = "Measure what tolerances cost: the smallest feature that survives, in units of L";
    const HELP: &'static str = "\
Each feature (a gap, a tooth through an edge, a cell around a vertex ...) is made in sizes from 1e-9 to 0.4, in units \
of L, and put in random positions. It survives if its contacts are registered correctly, with nothing more degenerate \
beside them.

Files in the folder: resolution.csv (the share that survives, by size), location.csv (the distance along the edge \
between a crossing and its registered place, by angle), resolution.md (the printed tables), resolution.svg, \
location.svg, and both as PDF.

Examples:
  predicament study resolution --out target/resolution
  predicament study resolution -b tolerance,exact --trials 1000 --out target/resolution";

    const NEEDS_FOLDER: bool = true;
    type Measured = Resolved;

    fn backends(&self) -> Vec<String> {
        self.backends.clone()
    }

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Resolved, Error> {
        host.begin((backends.len() * (FEATURES.len() + 1)) as u64, "features");
        let mut resolved = Resolved { features: Vec::new(), crossings: Vec::new() };
        for feature in FEATURES {
            for &backend in backends {
                let shares = Resolution::ask(
                    backend,
                    &format!("`{}`", feature.name),
                    feature.dimension,
                    |ask, length, precision| survey(feature, ask, length, precision, self.trials, self.common.seed),
                );
                resolved.features.push((feature, backend.name(), shares?));
                host.watch().done(1)?;
            }
        }
        for &backend in backends {
            let errors = Resolution::ask(backend, "shallow crossings", Dimension::Two, |ask, length, precision| {
                location(ask, length, precision, self.trials, self.common.seed)
            });
            resolved.crossings.push((backend.name(), errors?));
            host.watch().done(1)?;
        }
        Ok(resolved)
    }

    fn rows(&self, measured: &Resolved) -> Result<Vec<File>, Error> {
        let shares = measured.features.iter().flat_map(|(feature, backend, survey)| {
            survey.shares.iter().map(|&(size_over_l, survived)| Share {
                feature: feature.name,
                dimension: feature.dimension.count(),
                tolerance: feature.tolerance,
                backend,
                size_over_l,
                survived,
            })
        });
        let errors = measured.crossings.iter().flat_map(|(backend, locations)| {
            locations.iter().map(|&Location { angle, crossed, registered, crossings, worst, mean }| Shallow {
                backend,
                angle,
                crossed,
                registered,
                crossings,
                worst_over_l: worst,
                mean_over_l: mean,
            })
        });
        Ok(vec![File::csv("resolution.csv", shares)?, File::csv("location.csv", errors)?])
    }

    fn page(&self, measured: &Resolved) -> String {
        table::page(measured)
    }

    fn plots(&self, measured: &Resolved) -> Result<Vec<File>, Error> {
        plots::all(measured)
    }
}

impl Resolution {
    /// Measures one thing with a function that needs a backend's contacts, its L, and its precision.
    fn ask<T>(
        backend: &dyn Contestant,
        what: &str,
        dimension: Dimension,
        measure: impl FnOnce(&Ask, f64, Precision) -> Result<T, AnswerError>,
    ) -> Result<T, Error> {
        let name = backend.name();
        measure(&|scene, a, b| contacts(backend, scene, [a, b]), length(&name, dimension), Precision::of_backend(&name))
            .map_err(|why| Error::unfit(format!("{name} on {what}: {why}")))
    }
}

#[derive(Serialize)]
struct Share<'a> {
    feature: &'a str,
    dimension: usize,
    tolerance: &'a str,
    backend: &'a str,
    size_over_l: f64,
    survived: f64,
}

#[derive(Serialize)]
struct Shallow<'a> {
    backend: &'a str,
    angle: f64,
    crossed: u32,
    registered: u32,
    crossings: u32,
    worst_over_l: f64,
    mean_over_l: f64,
}
