//! The cascades of meshes by each backend, step by step.

use std::time::{Duration, Instant};

use predicament_corpus::Random;
use predicament_judge::rational;
use predicament_mesh_intersect::algorithm::cascade as steps;
use predicament_mesh_intersect::algorithm::overlay::Zeros;
use predicament_mesh_intersect::algorithm::sessions::Sessions;
use predicament_predicates::{Declined, PredicateKind, Predicates, Scene, ZeroMeaning};
use predicament_tasks::{Contestant, Watch};

use super::cascade::{Cascade, Cells};
use super::sample::{Done, Probe, Sample, measured};
use crate::Error;
use crate::cascades::Plan;

/// The result of one backend on one cascade.
#[derive(Clone, PartialEq, Debug)]
pub struct Followed {
    /// The cascade.
    pub cascade: Cascade,
    /// The backend's name.
    pub backend: String,
    /// The measurements, in the order of the steps.
    pub samples: Vec<Sample>,
    /// The sums over all steps.
    pub done: Done,
    /// The step that failed, and the reason.
    pub ended: Option<(usize, String)>,
}

struct Of<'a>(&'a dyn Contestant);

impl Sessions for Of<'_> {
    fn with_session(&self, scene: &Scene, ask: &mut dyn FnMut(&mut dyn Predicates)) -> Result<(), Declined> {
        self.0.with_session(scene, ask)
    }
}

/// Does the steps of a cascade by a backend.
///
/// If the backend breaks ties, `exact` takes the limits and resolves flaws of rounding; else the backend does both.
pub(super) fn follow(
    cascade: Cascade,
    plan: Plan,
    rounding: steps::Rounding,
    backend: &dyn Contestant,
    exact: &dyn Contestant,
    watch: &Watch<'_>,
) -> Result<Followed, Error> {
    let (start, operands) = cascade.steps(plan.steps, plan.seed);
    let breaks_ties = backend.contract(PredicateKind::Orient3d).zero == ZeroMeaning::Never;
    let (own, exact) = (Of(backend), Of(exact));
    let steps = steps::Cascade {
        perturbed: &own,
        exact: if breaks_ties { &exact } else { &own },
        zeros: if breaks_ties { Zeros::Zero } else { Zeros::Positive },
        rounding,
    };
    let mut cells = start.cell.map(|_| Cells::default());
    if let Some(cells) = &mut cells {
        cells.apply(&start);
    }
    let mut random = Random::new(cascade.name(), "mesh-cascades probes", plan.seed);
    let reach = start.mesh.points.iter().chain(operands.iter().flat_map(|step| &step.mesh.points));
    let range = reach.flatten().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &x| [low.min(x), high.max(x)]);
    let mut probes: Vec<Probe> = (0..plan.probes)
        .map(|_| Probe::new([(); 3].map(|()| rational(random.between(range[0], range[1]))), &start.mesh))
        .collect();
    let mut found =
        Followed { cascade, backend: backend.name(), samples: Vec::new(), done: Done::default(), ended: None };
    let mut result = start.mesh;
    let (mut elapsed, mut before) = (Duration::ZERO, 0);
    for (at, step) in (1..).zip(&operands) {
        watch.done(1)?;
        let clock = Instant::now();
        // From inside of a pool, short loops are not handed over.
        let made = rayon::scope(|_| steps.combine([&result, &step.mesh], step.operation));
        elapsed += clock.elapsed();
        match made {
            Ok((next, what)) => {
                result = next;
                found.done.add(&what);
            }
            Err(why) => {
                found.ended = Some((at, why.to_string()));
                break;
            }
        }
        if let Some(cells) = &mut cells {
            cells.apply(step);
        }
        probes.iter_mut().for_each(|probe| probe.apply(step));
        // The k-th of n samples is after step k·steps/n, rounded down.
        if at * plan.samples / plan.steps > (at - 1) * plan.samples / plan.steps {
            #[allow(clippy::cast_precision_loss)] // few steps
            let nanoseconds = elapsed.as_secs_f64() * 1e9 / (at - before) as f64;
            found.samples.push(measured(at, &result, cells.as_ref(), &probes, found.done, nanoseconds));
            (elapsed, before) = (Duration::ZERO, at);
        }
    }
    Ok(found)
}
