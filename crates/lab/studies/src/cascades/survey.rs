//! The cascades by each method, step by step.

use super::contradiction::Contradiction;
use std::time::Duration;

use predicament_corpus::Random;
use predicament_judge::rational;
use predicament_overlay::algorithm::overlay::Operation;
use predicament_overlay::checks::overlay::{Point, winding_of};
use predicament_tasks::{Contestant, Watch};

use super::cascade::{Cascade, Loop, Operand};
use super::method::{Keep, Method};
use super::sample::{Probe, Sample, bits, lost};
use super::step::{End, Stepped, Then};
use super::{rounded, settled, snapped, whole};
use crate::Error;

/// The numbers of steps and of measurements.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Plan {
    /// Steps of each cascade.
    pub steps: usize,
    /// Steps after which everything is measured, spread evenly, including the last.
    pub samples: usize,
    /// Points that are located after each measured step.
    pub probes: usize,
    /// The seed of operands and probes.
    pub seed: u64,
}

/// The result of one method on one cascade.
#[derive(Clone, PartialEq, Debug)]
pub struct Followed {
    /// The cascade.
    pub cascade: Cascade,
    /// The method.
    pub method: Method,
    /// The measurements, in the order of the steps.
    pub samples: Vec<Sample>,
    /// The first rule of the algorithm that signs have broken, and its step.
    pub broken: Option<(usize, Contradiction)>,
    /// The step that failed, and the reason.
    pub ended: Option<(usize, String)>,
}

/// A cascade with its expected results.
pub(super) struct Course {
    pub cascade: Cascade,
    pub start: Loop,
    pub steps: Vec<Operand>,
    pub samples: Vec<usize>,
    pub probes: Vec<Probe>,
}

impl Course {
    /// The operands, and the sides of probes by the operands alone.
    pub fn new(cascade: Cascade, plan: Plan) -> Course {
        let (start, steps) = cascade.steps(plan.steps, plan.seed);
        let mut samples: Vec<usize> = (1..=plan.samples).map(|at| (plan.steps * at).div_ceil(plan.samples)).collect();
        samples.dedup();
        let mut random = Random::new(cascade.name(), "probes", plan.seed);
        let places = (0..plan.probes).map(|at| place(&start, &steps, at, &mut random)).collect::<Vec<_>>();
        let probes = places.into_iter().map(|at| followed(at.map(rational), &start, &steps)).collect();
        Course { cascade, start, steps, samples, probes }
    }

    /// The result of a method on the cascade.
    pub fn follow(
        &self,
        method: &Method,
        backend: &dyn Contestant,
        float: &dyn Contestant,
        watch: &Watch<'_>,
    ) -> Result<Followed, Error> {
        let mut found =
            Followed { cascade: self.cascade, method: method.clone(), samples: Vec::new(), broken: None, ended: None };
        let (mut at, mut constructed, mut collapsed) = (0, 0, 0);
        let (mut elapsed, mut before) = (Duration::ZERO, 0);
        let mut note = |stepped: Stepped<'_>| {
            watch.done(1).map_err(End::Stopped)?;
            at += 1;
            constructed += stepped.constructed;
            collapsed += stepped.collapsed;
            elapsed += stepped.elapsed;
            // The first step with a wrong result is measured, too.
            let mut is_sampled = self.samples.binary_search(&at).is_ok() || stepped.is_gone;
            if let Some(rule) = stepped.broken.filter(|_| found.broken.is_none()) {
                found.broken = Some((at, rule));
                is_sampled = true;
            }
            if is_sampled {
                let shape = (stepped.shape)();
                #[allow(clippy::cast_precision_loss)] // few steps
                let steps = (at - before) as f64;
                found.samples.push(Sample {
                    step: at,
                    regions: shape.regions.len(),
                    edges: shape.edges().count(),
                    area: shape.area(),
                    defects: shape.defects(),
                    turned: (stepped.turned)(),
                    lost: lost(&shape, &self.probes, at),
                    bits: bits(&shape),
                    constructed,
                    collapsed,
                    held: stepped.held,
                    thickness: stepped.thickness,
                    nanoseconds: elapsed.as_secs_f64() * 1e9 / steps,
                });
                (elapsed, before) = (Duration::ZERO, at);
            }
            if stepped.is_gone { Err(End::Failed("the result is empty".to_owned())) } else { Ok(()) }
        };
        let mut then = Then { samples: &self.samples, note: &mut note };
        let (start, steps) = (&self.start, self.steps.as_slice());
        let end = match method.keep {
            Keep::Whole => whole::run(backend, start, steps, &mut then),
            Keep::Rounded => rounded::run(backend, start, steps, &mut then),
            Keep::Snapped(bits) => snapped::run(backend, bits, start, steps, &mut then),
            Keep::Contacts => settled::run_contacts(backend, float, start, steps, &mut then),
            Keep::Thick(radius) => settled::run_thick(float, radius, start, steps, &mut then),
        };
        match end {
            Ok(()) => {}
            Err(End::Stopped(stop)) => return Err(stop.into()),
            Err(End::Failed(why)) => found.ended = Some((at + 1, why)),
        }
        Ok(found)
    }
}

/// A probe: every second one anywhere, the rest near a corner of an operand, from a tenth to 10^-9 off.
fn place(start: &Loop, steps: &[Operand], at: usize, random: &mut Random) -> [f64; 2] {
    let corners = || start.iter().chain(steps.iter().flat_map(|step| &step.corners));
    if at.is_multiple_of(2) {
        let range = |axis: usize| {
            let along = corners().map(|corner| corner[axis]);
            along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        return [0, 1].map(|axis| {
            let [low, high] = range(axis);
            random.between(low, high)
        });
    }
    let count = i64::try_from(corners().count()).unwrap_or(i64::MAX);
    let chosen = usize::try_from(random.integer(0, count - 1)).unwrap_or_default();
    let off = (0..random.integer(1, 9)).fold(1.0, |off, _| off / 10.0);
    let corner = corners().nth(chosen).copied().unwrap_or_default();
    corner.map(|x| x + random.between(-off, off))
}

/// The sides of a probe after each step, by the operands alone.
fn followed(at: Point, start: &Loop, steps: &[Operand]) -> Probe {
    let is_inside = |corners: &Loop| {
        let exactly: Vec<Point> = corners.iter().map(|corner| corner.map(rational)).collect();
        winding_of(&[exactly], &at).map(|winding| winding != 0)
    };
    let sides: Option<Vec<(Operation, bool)>> =
        steps.iter().map(|step| Some((step.operation, is_inside(&step.corners)?))).collect();
    let inside = is_inside(start).zip(sides).map(|(mut is_in, sides)| {
        let next = |(operation, second): (Operation, bool)| {
            is_in = operation.holds([is_in, second]);
            is_in
        };
        sides.into_iter().map(next).collect()
    });
    Probe { at, inside }
}
