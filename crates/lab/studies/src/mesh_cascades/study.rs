//! The command line of the study of cascades of meshes, its survey and its rows.

use predicament_report::text::in_order;
use predicament_report::{Curve, Curves, curves};
use predicament_tasks::Contestant;
use serde::Serialize;

use super::survey::{Followed, follow};
use super::{Cascade, Sample, table};
use crate::cascades::Plan;
use crate::{Common, Error, File, Host, Study};

/// Meshes that are combined repeatedly, by several backends.
#[derive(Clone, Debug, clap::Args)]
pub struct MeshCascades {
    /// Cascades; all if left out
    #[arg(short, long = "cascade", value_name = "CASCADE", value_enum, value_delimiter = ',')]
    pub cascades: Vec<Cascade>,

    /// Backends
    #[arg(
        short,
        long = "backend",
        value_name = "BACKEND",
        value_delimiter = ',',
        default_value = "sos:per-mesh,naive"
    )]
    pub backends: Vec<String>,

    /// Steps of each cascade
    #[arg(long, default_value_t = 53, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub steps: u32,

    /// Steps after which everything is measured, spread evenly
    #[arg(long, default_value_t = 10, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub samples: u32,

    /// Points that are located after each measured step
    #[arg(long, default_value_t = 64, value_name = "N")]
    pub probes: u32,

    /// The treatment of a result that crosses itself once its vertices are doubles
    #[arg(long, value_enum, default_value_t = Rounding::Counted, value_name = "HOW")]
    pub rounding: Rounding,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// The treatment of flaws of rounding.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, clap::ValueEnum)]
pub enum Rounding {
    /// Flaws are counted
    #[default]
    Counted,
    /// Triangles that cross are cut, and the result is rounded again, until no triangles cross or their number grows
    Resolved,
}

/// A plot: the suffix of the file's name, its title, and the value of a sample.
type Plot = (&'static str, &'static str, fn(&Sample) -> f64);

/// The backend that takes limits.
const EXACT: &str = "exact";

/// The measurements of all cascades.
#[derive(Clone, PartialEq, Debug)]
pub struct Measured {
    /// Each cascade by each backend, in their order.
    pub followed: Vec<Followed>,
}

impl Study for MeshCascades {
    const NAME: &'static str = "mesh-cascades";
    const ASKS: &'static str = "Combine meshes repeatedly, and measure the result: volume, crossings, points, time";
    const HELP: &'static str = "\
The result of each Boolean operation is an operand of the next. Cascades: `cubes` unites the cubes of a lattice one \
by one and takes them away again, so that nothing remains after an odd number of steps (1999: a lattice of 10 by 10 \
by 10); `shuffled` does so in random orders; `shave` cuts a sphere by half-spaces; `copies` unites a sphere with \
copies of itself.

A step is an overlay with the signs of the backend. If the backend moves a mesh by an infinitesimal, the step then \
takes the limit of the result, with `exact`: vertices at one place are merged, and triangles without area and sheets \
without volume are removed. At the end vertices are rounded to the nearest doubles. For backends that do not break \
ties, zero counts as positive.

Everything is measured in rationals: volume, area and triangles, compared with the counted values (cubes, shuffled); \
open sides; triangles without area or through each other; points on the wrong side of the result, by all operands. \
`cleared` is the number of triangles cleared by limits; `moved` the vertices that were not doubles; `flaws` the \
triangles that turned over, folded or crossed when these vertices were rounded to the nearest doubles; `left` the \
flaws that remain after other doubles were tried. With --rounding resolved, a result that then crosses itself is cut \
at the crossings and rounded again, at most 16 times, and only a few times if the crossings become more. Then `cut` \
is the number of triangles cut for that, and `left` the pairs that cross in the end.

Files in the folder: mesh-cascades.csv, mesh-cascade-times.csv, mesh-cascades.md, plots as SVG and PDF. Everything \
except times is the same in every run.

Exit code 100 if sos:per-mesh has an error before rounding has left a flaw. A mesh with such a flaw crosses itself; \
later steps are shown, but not guaranteed.

Examples:
  predicament study mesh-cascades -c cubes --steps 1999 -b sos:per-mesh
  predicament study mesh-cascades -c shave,copies --steps 100 --out target/mesh-cascades
  predicament study mesh-cascades -c copies --steps 24 --rounding resolved";

    type Measured = Measured;

    fn backends(&self) -> Vec<String> {
        let mut names = self.backends.clone();
        if !names.iter().any(|name| name == EXACT) {
            names.push(EXACT.to_owned());
        }
        names
    }

    /// One thread, because the steps are timed.
    fn threads(&self) -> Option<usize> {
        Some(1)
    }

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Measured, Error> {
        let names = self.backends();
        if backends.len() != names.len() {
            return Err(Error::unfit(format!("two of {} are the same backend; name it once", names.join(", "))));
        }
        let exact = backends[names.iter().position(|name| name == EXACT).unwrap_or(0)];
        let plan = Plan {
            steps: self.steps as usize,
            samples: self.samples.min(self.steps) as usize,
            probes: self.probes as usize,
            seed: self.common.seed,
        };
        let rounding = match self.rounding {
            Rounding::Counted => predicament_mesh_intersect::algorithm::cascade::Rounding::Counted,
            Rounding::Resolved => predicament_mesh_intersect::algorithm::cascade::Rounding::Resolved,
        };
        let cascades = if self.cascades.is_empty() { Cascade::ALL.to_vec() } else { self.cascades.clone() };
        host.begin(u64::from(self.steps) * (self.backends.len() * cascades.len()) as u64, "steps");
        let mut measured = Measured { followed: Vec::new() };
        for cascade in cascades {
            for &backend in &backends[..self.backends.len()] {
                host.turn_to(&format!("{} by {}", cascade.name(), backend.name()));
                measured.followed.push(follow(cascade, plan, rounding, backend, exact, host.watch())?);
            }
        }
        Ok(measured)
    }

    fn rows(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        let all = || measured.followed.iter().flat_map(|one| one.samples.iter().map(move |sample| (one, sample)));
        let rows = all().map(|(one, sample)| Row::of(one, sample));
        let times = all().map(|(one, sample)| Time {
            cascade: one.cascade.name(),
            backend: &one.backend,
            step: sample.step,
            nanoseconds_a_step: sample.nanoseconds,
        });
        Ok(vec![File::csv("mesh-cascades.csv", rows)?, File::csv("mesh-cascade-times.csv", times)?])
    }

    fn page(&self, measured: &Measured) -> String {
        table::page(self, measured)
    }

    fn plots(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        #[allow(clippy::cast_precision_loss)] // small counts
        let plots: [Plot; 3] = [
            ("triangles", "triangles", |sample| sample.triangles as f64),
            ("wrong", "open sides, crossings and wrong points", |sample| {
                (sample.open + sample.crossing + sample.wrong) as f64
            }),
            ("time", "microseconds per step", |sample| sample.nanoseconds / 1e3),
        ];
        let mut files = Vec::new();
        for cascade in in_order(measured.followed.iter().map(|one| one.cascade)) {
            for (name, what, value) in &plots {
                #[allow(clippy::cast_precision_loss)] // few steps
                let points = |one: &Followed| -> Vec<_> {
                    one.samples.iter().map(|sample| (sample.step as f64, value(sample))).collect()
                };
                let curve = |one: &Followed| Curve::new(one.backend.clone(), points(one));
                let of_cascade = measured.followed.iter().filter(|one| one.cascade == cascade).map(curve);
                // A name in the legend requires a line.
                let lines = of_cascade.filter(|curve| curve.points.iter().any(|(_, y)| *y > 0.0)).collect();
                let drawn = curves(&Curves { x: "step".into(), y: (*what).into(), curves: lines, ..Curves::default() });
                let picture = drawn.map_err(Error::format)?;
                files.extend(File::plot(format!("mesh-{}-{name}", cascade.name()), picture));
            }
        }
        Ok(files)
    }

    fn holds(&self, measured: &Measured) -> bool {
        // After rounding has left a flaw the next operand crosses itself, and nothing is promised.
        let is_right = |sample: &Sample| sample.done.left > 0 || sample.is_clean();
        let promised = measured.followed.iter().filter(|one| one.backend == "sos:per-mesh");
        promised.into_iter().all(|one| (one.ended.is_none() || one.done.left > 0) && one.samples.iter().all(is_right))
    }
}

#[derive(Serialize)]
struct Row<'a> {
    cascade: &'static str,
    backend: &'a str,
    step: usize,
    triangles: usize,
    points: usize,
    volume: f64,
    area: f64,
    true_volume: Option<usize>,
    true_area: Option<usize>,
    is_true: bool,
    open_sides: usize,
    flat_triangles: usize,
    crossings: usize,
    wrong_points: usize,
    constructed: usize,
    cleared: usize,
    moved: usize,
    flaws: usize,
    steps_resolved: usize,
    most_passes: usize,
    cut: usize,
    farthest: f64,
    left: usize,
    ended: String,
}

impl<'a> Row<'a> {
    fn of(one: &'a Followed, sample: &Sample) -> Row<'a> {
        let is_last = one.samples.last().is_some_and(|last| last.step == sample.step);
        let ended = one.ended.as_ref().filter(|_| is_last);
        Row {
            cascade: one.cascade.name(),
            backend: &one.backend,
            step: sample.step,
            triangles: sample.triangles,
            points: sample.points,
            volume: sample.volume.to_f64(),
            area: sample.area,
            true_volume: sample.truth.map(|[volume, _]| volume),
            true_area: sample.truth.map(|[_, area]| area),
            is_true: sample.is_true(),
            open_sides: sample.open,
            flat_triangles: sample.flat,
            crossings: sample.crossing,
            wrong_points: sample.wrong,
            constructed: sample.done.constructed,
            cleared: sample.done.cleared,
            moved: sample.done.moved,
            flaws: sample.done.flaws,
            steps_resolved: sample.done.resolved,
            most_passes: sample.done.passes,
            cut: sample.done.cut,
            farthest: sample.done.farthest,
            left: sample.done.left,
            ended: ended.map(|(step, why)| format!("step {step}: {why}")).unwrap_or_default(),
        }
    }
}

#[derive(Serialize)]
struct Time<'a> {
    cascade: &'static str,
    backend: &'a str,
    step: usize,
    nanoseconds_a_step: f64,
}
