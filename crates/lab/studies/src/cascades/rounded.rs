//! Results that are rounded to doubles after each step, vertex by vertex.

use std::time::{Duration, Instant};

use predicament_judge::{nearest, point, rational};
use predicament_overlay::algorithm::overlay::{Contradiction, Method as Search, combine};
use predicament_predicates::{Declined, Plane, Predicates, Scene, Vertex};
use predicament_tasks::Contestant;

use super::cascade::{Loop, Operand};
use super::current::{Current, Places, Ring, cleaned};
use super::step::{End, Stepped, Then, shape_of};
use super::whole::{origins, turned};

/// The result of a step.
pub(super) struct Made {
    pub regions: Vec<Vec<Ring>>,
    pub elapsed: Duration,
    pub constructed: usize,
    pub broken: Option<Contradiction>,
    pub turned: Option<usize>,
}

/// Does the steps; rounds every vertex to the nearest double, or uses the session's rounded point.
pub(super) fn run(backend: &dyn Contestant, start: &Loop, steps: &[Operand], then: &mut Then<'_>) -> Result<(), End> {
    each(start, steps, then, |current, step, wants_turned| {
        let clock = Instant::now();
        let operand = current.ring(&step.corners);
        let pair = current.pair(&operand)?;
        in_session(backend, &pair.scene, &mut |session| {
            let result = combine(session, &pair.first, &pair.second, step.operation, Search::Grid)?;
            let session = &*session;
            let mut places = Places::new(&pair, session);
            let regions = places.rings(&mut current.points, &result.regions);
            let elapsed = clock.elapsed();
            let turned = wants_turned.then(|| {
                let vertices: Vec<Vec<Vec<Vertex>>> =
                    result.regions.iter().map(|region| region.loops().map(|one| origins(one)).collect()).collect();
                let defined = |v: Vertex| point(session.scene(), v).and_then(|point| point.try_into().ok());
                let rounded = |v: Vertex| {
                    let at = places.of(&mut current.points, v);
                    current.points.points[at as usize].map(rational)
                };
                turned(&vertices, |v| defined(v).unwrap_or_default(), rounded)
            });
            Ok(Made {
                regions,
                elapsed,
                constructed: session.scene().constructions().len(),
                broken: result.broken,
                turned,
            })
        })
    })
}

/// The steps, one scene each.
pub(super) fn each(
    start: &Loop,
    steps: &[Operand],
    then: &mut Then<'_>,
    mut make: impl FnMut(&mut Current, &Operand, bool) -> Result<Made, End>,
) -> Result<(), End> {
    let mut current = Current::new(start);
    for (at, step) in steps.iter().enumerate() {
        let made = make(&mut current, step, then.is_sampled(at))?;
        let clock = Instant::now();
        let (regions, collapsed) = cleaned(made.regions);
        current.replace(regions);
        then.call(Stepped {
            elapsed: made.elapsed + clock.elapsed(),
            constructed: made.constructed,
            collapsed,
            held: current.held(),
            thickness: 0.0,
            broken: made.broken.map(Into::into),
            is_gone: current.regions.is_empty(),
            shape: &|| shape_of(&current.loops()),
            turned: &|| made.turned,
        })?;
    }
    Ok(())
}

/// Calls a function with a session of this scene; returns its result.
pub(super) fn in_session<T>(
    backend: &dyn Contestant,
    scene: &Scene,
    ask: &mut dyn FnMut(&mut dyn Predicates) -> Result<T, End>,
) -> Result<T, End> {
    let mut answer = None;
    backend.with_session(scene, &mut |session| answer = Some(ask(session)))?;
    answer.ok_or_else(|| Declined::scene("the backend asked for no session"))?
}

/// The double in place of a vertex: the session's rounded point, or else the nearest double.
pub(super) fn place(session: &dyn Predicates, v: Vertex) -> [f64; 2] {
    if !v.is_constructed() {
        return session.scene().point2(Plane::Xy, v);
    }
    if let Some(Ok(rounded)) = session.rounded_point(v).map(<[f64; 2]>::try_from) {
        return rounded;
    }
    let exact = point(session.scene(), v).unwrap_or_default();
    [0, 1].map(|axis: usize| exact.get(axis).map_or(f64::NAN, nearest))
}
