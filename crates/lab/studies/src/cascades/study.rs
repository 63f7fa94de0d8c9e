//! The command line of the study of cascades, its survey and its rows.

use predicament_report::text::in_order;
use predicament_tasks::Contestant;
use rug::Rational;
use serde::Serialize;

use super::method::FLOAT;
use super::survey::{Course, Followed, Plan};
use super::{Cascade, Keep, Method, Sample, plots, table};
use crate::{Common, Error, File, Host, Study};

/// Polygons that are combined repeatedly, by several methods.
#[derive(Clone, Debug, clap::Args)]
pub struct Cascades {
    /// Cascades; all if left out
    #[arg(short, long = "cascade", value_name = "CASCADE", value_enum, value_delimiter = ',')]
    pub cascades: Vec<Cascade>,

    /// Methods
    #[arg(short, long = "method", value_name = "METHOD", value_delimiter = ',', default_value = DEFAULT)]
    #[arg(help = "Methods: BACKEND, BACKEND+round, BACKEND+snap[:BITS], BACKEND+contacts, thick[:RADIUS]")]
    pub methods: Vec<Method>,

    /// Steps of each cascade
    #[arg(long, default_value_t = 100, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub steps: u32,

    /// Steps after which everything is measured, spread evenly
    #[arg(long, default_value_t = 10, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub samples: u32,

    /// Points that are located after each measured step
    #[arg(long, default_value_t = 64, value_name = "N")]
    pub probes: u32,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// The default methods, one or more of each philosophy.
const DEFAULT: &str = "exact,exact+snap,exact+round,sos,naive,naive+round,epsilon+round,thick,tolerance+contacts";

/// The measurements of all cascades.
#[derive(Clone, PartialEq, Debug)]
pub struct Measured {
    /// Each cascade by each method, in their order.
    pub followed: Vec<Followed>,
    /// Each cascade by the exact method, also if it was not requested.
    pub exact: Vec<Followed>,
}

impl Measured {
    /// Twice the true area after a step: the area of the exact method's result.
    fn area(&self, cascade: Cascade, step: usize) -> Option<&Rational> {
        let exact = self.exact.iter().find(|exact| exact.cascade == cascade)?;
        exact.samples.iter().find(|sample| sample.step == step).map(|sample| &sample.area)
    }

    /// The relative error of the area after a step.
    ///
    /// `None` if the exact method has no measurement after that step.
    #[must_use]
    pub fn area_error(&self, cascade: Cascade, sample: &Sample) -> Option<f64> {
        if sample.regions == 0 {
            return Some(1.0);
        }
        let truth = self.area(cascade, sample.step).filter(|area| area.cmp0().is_ne())?;
        Some((Rational::from(&sample.area - truth) / truth).abs().to_f64())
    }
}

impl Study for Cascades {
    const NAME: &'static str = "cascades";
    const ASKS: &'static str = "Combine polygons repeatedly, and measure the result: crossings, areas, bits, time";
    const HELP: &'static str = "\
The result of each Boolean operation is an operand of the next. Cascades: `rotate` unites a square with rotated \
copies of itself, `shave` cuts it by half-planes, `stars` unites stars one by one, `generalise` unites the regions of \
a map whose borders were generalised differently.

Methods:
  BACKEND            constructed vertices keep their definitions; naive and similar backends round each of them once
  BACKEND+round      each constructed vertex is rounded to the nearest double after each step
  BACKEND+snap:BITS  edges and crossings go to pixels by snap rounding (40 bits)
  BACKEND+contacts   operands are merged where the backend registers contacts, then combined in floating point
  thick:RADIUS       vertices and edges have radii; overlapping ones are made to coincide (1e-9)

Everything is measured in rationals: crossings that remain in the result, loops turned over, corners turned by \
rounding, the area compared with the area of `exact`, points on the wrong side, bits.

Files in the folder: cascades.csv (the measurements), times.csv, cascades.md (the printed tables), plots as SVG and \
PDF, and the operands of each cascade as WKT for other programs (`union;POLYGON ((…))`, one step per line). \
Everything except times is the same in every run.

Exit code 100 if exact or sos has a point on the wrong side, a crossing or a loop turned over, or if snap rounding \
leaves a crossing.

Examples:
  predicament study cascades --steps 50
  predicament study cascades -c stars --steps 1000 --out target/cascades
  predicament study cascades -c rotate -m exact,exact+snap:20,thick:1e-6 --samples 50";

    type Measured = Measured;

    fn backends(&self) -> Vec<String> {
        let mut names = vec![Method::exact().backend, FLOAT.to_owned()];
        for method in &self.methods {
            if !names.contains(&method.backend) {
                names.push(method.backend.clone());
            }
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
        let backend = |name: &str| backends[names.iter().position(|other| other == name).unwrap_or(0)];
        let plan = Plan {
            steps: self.steps as usize,
            samples: self.samples.min(self.steps) as usize,
            probes: self.probes as usize,
            seed: self.common.seed,
        };
        let exact = Method::exact();
        let methods = in_order(self.methods.iter());
        let others = methods.iter().filter(|method| ***method != exact).count() as u64;
        let cascades = if self.cascades.is_empty() { Cascade::ALL.to_vec() } else { self.cascades.clone() };
        host.begin(u64::from(self.steps) * (others + 1) * cascades.len() as u64, "steps");
        let mut measured = Measured { followed: Vec::new(), exact: Vec::new() };
        for cascade in cascades {
            host.watch().done(0)?;
            let course = Course::new(cascade, plan);
            let follow = |method: &Method| {
                host.turn_to(&format!("{} by {method}", cascade.name()));
                course.follow(method, backend(&method.backend), backend(FLOAT), host.watch())
            };
            let reference = follow(&exact)?;
            for &method in &methods {
                let followed = if *method == exact { reference.clone() } else { follow(method)? };
                measured.followed.push(followed);
            }
            measured.exact.push(reference);
        }
        Ok(measured)
    }

    fn rows(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        let all = || {
            measured
                .followed
                .iter()
                .flat_map(|one| one.samples.iter().map(move |sample| (one, one.method.to_string(), sample)))
        };
        let rows = all().map(|(one, method, sample)| Row::of(measured, one, method, sample));
        let times = all().map(|(one, method, sample)| Time {
            cascade: one.cascade.name(),
            method,
            step: sample.step,
            nanoseconds_a_step: sample.nanoseconds,
        });
        Ok(vec![File::csv("cascades.csv", rows)?, File::csv("times.csv", times)?])
    }

    /// The operands, so that other programs can do the same.
    fn suites(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        let operands = |one: &Followed| {
            let (start, steps) = one.cascade.steps(self.steps as usize, self.common.seed);
            let first = format!("start;{}\n", wkt(&start));
            let rest = steps.iter().map(|step| format!("{};{}\n", step.operation.name(), wkt(&step.corners)));
            File::new(format!("{}.wkt", one.cascade.name()), std::iter::once(first).chain(rest).collect::<String>())
        };
        Ok(measured.exact.iter().map(operands).collect())
    }

    fn page(&self, measured: &Measured) -> String {
        table::page(self, measured)
    }

    fn plots(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        plots::all(measured)
    }

    fn holds(&self, measured: &Measured) -> bool {
        measured.followed.iter().chain(&measured.exact).all(|one| {
            let clean = |sample: &Sample| sample.defects.crossings == 0 && sample.defects.inverted == 0;
            let right = |sample: &Sample| sample.lost == 0;
            let is_done = one.ended.is_none() && one.broken.is_none();
            (!one.method.is_planar() || is_done && one.samples.iter().all(clean))
                && (!one.method.is_exact() || one.samples.iter().all(right))
        })
    }
}

/// A loop as a polygon, with decimals that are read back as the same doubles.
fn wkt(corners: &[[f64; 2]]) -> String {
    let points: Vec<String> = corners.iter().chain(corners.first()).map(|[x, y]| format!("{x} {y}")).collect();
    format!("POLYGON (({}))", points.join(", "))
}

#[derive(Serialize)]
struct Row {
    cascade: &'static str,
    method: String,
    step: usize,
    regions: usize,
    edges: usize,
    area: f64,
    area_error: Option<f64>,
    crossings: usize,
    touches: usize,
    inverted_loops: usize,
    flat_loops: usize,
    turned_corners: Option<usize>,
    wrong_points: usize,
    bits: u32,
    constructed: usize,
    collapsed: usize,
    vertices_held: usize,
    thickness: Option<f64>,
    broken: &'static str,
    ended: String,
}

impl Row {
    fn of(measured: &Measured, one: &Followed, method: String, sample: &Sample) -> Row {
        let is_last = one.samples.last().is_some_and(|last| last.step == sample.step);
        let ended = one.ended.as_ref().filter(|_| is_last);
        Row {
            cascade: one.cascade.name(),
            method,
            step: sample.step,
            regions: sample.regions,
            edges: sample.edges,
            area: sample.area.to_f64() / 2.0,
            area_error: measured.area_error(one.cascade, sample),
            crossings: sample.defects.crossings,
            touches: sample.defects.touches,
            inverted_loops: sample.defects.inverted,
            flat_loops: sample.defects.flat,
            turned_corners: sample.turned,
            wrong_points: sample.lost,
            bits: sample.bits,
            constructed: sample.constructed,
            collapsed: sample.collapsed,
            vertices_held: sample.held,
            thickness: matches!(one.method.keep, Keep::Thick(_)).then_some(sample.thickness),
            broken: one.broken.filter(|(step, _)| *step <= sample.step).map_or("", |(_, broken)| broken.rule()),
            ended: ended.map(|(step, why)| format!("step {step}: {why}")).unwrap_or_default(),
        }
    }
}

#[derive(Serialize)]
struct Time {
    cascade: &'static str,
    method: String,
    step: usize,
    nanoseconds_a_step: f64,
}
