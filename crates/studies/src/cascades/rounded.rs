//! Results that are brought back to doubles after each step: vertex by vertex, or by snap rounding.

use std::collections::HashMap;
use std::time::{Duration, Instant};

use predicament_algorithms::overlay::{Edge, Method as Search, Polygon, Rule, overlay};
use predicament_algorithms::snap::{Drawing, Method as Snapping, snap};
use predicament_judge::{nearest, point, rational};
use predicament_predicates::{Construction, Plane, Predicates, Scene, Vertex};
use predicament_tasks::Contestant;

use super::cascade::{Loop, Operand};
use super::current::{Pair, cleaned};
use super::survey::{End, Stepped, Then, shape_of};
use super::whole::{origins, turned};

/// What a step leaves.
struct Made {
    regions: Vec<Vec<Loop>>,
    elapsed: Duration,
    constructed: usize,
    broken: Option<&'static str>,
    turned: Option<usize>,
}

/// Rounds every vertex of a result to the nearest double, or takes it where the session has put it.
pub(super) fn run(backend: &dyn Contestant, start: &Loop, steps: &[Operand], then: &mut Then<'_>) -> Result<(), End> {
    each(start, steps, then, |pair, step, wants_turned| {
        in_session(backend, &pair.scene, &mut |session| {
            let clock = Instant::now();
            let [a, b] = &pair.operands;
            let made = overlay(session, [a, b], Search::Grid).map_err(|why| why.to_string())?;
            let result = made.regions(&*session, step.operation);
            let session = &*session;
            let mut places: HashMap<Vertex, [f64; 2]> = HashMap::new();
            let vertices: Vec<Vec<Vec<Vertex>>> =
                result.regions.iter().map(|region| region.loops().map(|one| origins(one)).collect()).collect();
            let mut at = |v: &Vertex| *places.entry(*v).or_insert_with(|| place(session, *v));
            let regions = vertices
                .iter()
                .map(|region| region.iter().map(|one| one.iter().map(&mut at).collect()).collect())
                .collect();
            let elapsed = clock.elapsed();
            let turned = wants_turned.then(|| {
                let defined = |v: Vertex| point(session.scene(), v).and_then(|point| point.try_into().ok());
                turned(&vertices, |v| defined(v).unwrap_or_default(), |v| places[&v].map(rational))
            });
            Ok(Made {
                regions,
                elapsed,
                constructed: session.scene().constructions().len(),
                broken: made.arrangement.broken.or(result.broken),
                turned,
            })
        })
    })
}

/// Snaps edges and crossings to pixels, then combines what has become of the operands: their chains cross nowhere.
pub(super) fn run_snapped(
    backend: &dyn Contestant,
    bits: u32,
    start: &Loop,
    steps: &[Operand],
    then: &mut Then<'_>,
) -> Result<(), End> {
    // All coordinates are below 4.
    let exponent = 2 - i32::try_from(bits).unwrap_or(50);
    each(start, steps, then, |pair, step, _| {
        let mut constructed = 0;
        let clock = Instant::now();
        let chains = in_session(backend, &pair.scene, &mut |session| {
            let [a, b] = &pair.operands;
            let made = overlay(session, [a, b], Search::Grid).map_err(|why| why.to_string())?;
            constructed = session.scene().constructions().len();
            let segments = &made.arrangement.segments;
            snapped(session.scene(), &pair.operands, segments, exponent)
        })?;
        in_session(backend, &chains.scene, &mut |session| {
            let [a, b] = &chains.operands;
            let made = overlay(session, [a, b], Search::Grid).map_err(|why| why.to_string())?;
            let result = made.regions(&*session, step.operation);
            let session = &*session;
            let at = |v: &Vertex| place(session, *v);
            let loops = |region: &predicament_algorithms::overlay::Region| {
                region.loops().map(|one| origins(one).iter().map(at).collect()).collect()
            };
            Ok(Made {
                regions: result.regions.iter().map(loops).collect(),
                elapsed: clock.elapsed(),
                // Chains meet in vertices: whatever is constructed now should not be there.
                constructed: constructed + session.scene().constructions().len(),
                broken: made.arrangement.broken.or(result.broken),
                turned: None,
            })
        })
    })
}

/// The steps, one scene each.
fn each(
    start: &Loop,
    steps: &[Operand],
    then: &mut Then<'_>,
    make: impl Fn(&Pair, &Operand, bool) -> Result<Made, End>,
) -> Result<(), End> {
    let mut current = vec![vec![start.clone()]];
    for (at, step) in steps.iter().enumerate() {
        let clock = Instant::now();
        let pair = Pair::new(&current, &step.corners)?;
        let preparing = clock.elapsed();
        let made = make(&pair, step, then.is_sampled(at))?;
        let clock = Instant::now();
        let (regions, collapsed) = cleaned(made.regions);
        current = regions;
        then.call(Stepped {
            elapsed: preparing + made.elapsed + clock.elapsed(),
            constructed: made.constructed,
            collapsed,
            held: current.iter().flatten().map(Vec::len).sum(),
            thickness: 0.0,
            broken: made.broken,
            is_gone: current.is_empty(),
            shape: &|| Ok(shape_of(&current)),
            turned: &|| made.turned,
        })?;
    }
    Ok(())
}

/// What a session of this scene answers.
pub(super) fn in_session<T>(
    backend: &dyn Contestant,
    scene: &Scene,
    ask: &mut dyn FnMut(&mut dyn Predicates) -> Result<T, String>,
) -> Result<T, End> {
    let mut answer = None;
    backend.with_session(scene, &mut |session| answer = Some(ask(session))).map_err(|declined| declined.to_string())?;
    let answer = answer.ok_or_else(|| "the backend asked for no session".to_owned())?;
    Ok(answer?)
}

/// The double that stands for a vertex: as the session has rounded it, or else the nearest.
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

/// The operands as chains of pixels.
fn snapped(scene: &Scene, operands: &[Polygon; 2], segments: &[[Vertex; 2]], exponent: i32) -> Result<Pair, String> {
    let id = |v: Vertex| u32::try_from(v.index()).unwrap_or(u32::MAX);
    let sorted = |[a, b]: [Vertex; 2]| if a < b { [a, b] } else { [b, a] };
    let places: HashMap<[Vertex; 2], u32> = segments.iter().copied().zip(0..).collect();
    let crossings: Vec<[u32; 2]> = scene
        .constructions()
        .iter()
        .filter_map(|construction| match construction {
            Construction::Ssi(pair) => {
                let [s, t] = pair.map(|ends| places.get(&sorted(ends)).copied());
                Some([s?, t?])
            }
            _ => None,
        })
        .collect();
    let points: Vec<[f64; 2]> = scene.coordinates().as_chunks().0.to_vec();
    let ends: Vec<[u32; 2]> = segments.iter().map(|ends| ends.map(id)).collect();
    let drawing = Drawing { points: &points, segments: &ends, crossings: &crossings, touching: &[] };
    let chains = snap(drawing, exponent, Snapping::Snap).map_err(|why| why.to_string())?;
    let centres: Vec<[f64; 2]> = (0..).zip(&chains.pixels).map(|(pixel, _)| chains.centre(pixel, exponent)).collect();
    let scene = Scene::from_points2(&centres).map_err(|why| why.to_string())?;
    let of_edge = |edge: &Edge| -> Vec<Edge> {
        let ends = [edge.from, edge.to];
        let Some(&at) = places.get(&sorted(ends)) else { return Vec::new() };
        let mut chain: Vec<Vertex> =
            chains.chains[at as usize].iter().map(|&pixel| Vertex::input(pixel as usize)).collect();
        if sorted(ends) != ends {
            chain.reverse();
        }
        chain.windows(2).filter(|pair| pair[0] != pair[1]).map(|pair| Edge::whole(pair[0], pair[1])).collect()
    };
    let operands = operands.each_ref().map(|polygon| Polygon {
        loops: polygon.loops.iter().map(|one| one.iter().flat_map(of_edge).collect()).collect(),
        rule: Rule::NonZero,
    });
    Ok(Pair { scene, operands })
}
