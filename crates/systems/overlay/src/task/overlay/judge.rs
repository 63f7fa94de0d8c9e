//! Judging of arrangements and results by their laws, decided in rationals.

use crate::algorithm::overlay::{Contradiction, Edge, Operation, Polygon, Region, Rule};
use std::collections::BTreeMap;

use crate::checks::overlay::{Expected, Flaw, Graph, Operands, Point, Results, Windings};
use predicament_judge::{Points, rational};
use predicament_predicates::{PredicateKind, Scene, Vertex, ZeroMeaning};

use super::content::Layers;
use super::{Layered, Overlaid, Overlay2d, Shortcut};
use predicament_tasks::rounding::{Excuse, Rounding};
use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Stop, bits};

/// The number of edges compared with their neighbours, at the two levels.
const EDGES_CROSSED: [usize; 2] = [1_000, 20_000];
/// The number of points and components located, at the two levels.
const LOCATED: [usize; 2] = [24, 200];
/// The number of points that are located in results.
const PROBES: usize = 200;

/// The parts of the check that are sampled, as text.
pub(super) fn sampled(content: &Layered) -> Option<String> {
    (content.size() > EDGES_CROSSED[0]).then(|| {
        "all nodes, chains and boundaries; an even sample of neighbouring edges, components and points".to_owned()
    })
}

/// Judges an arrangement and, for polygons, the results.
pub(super) fn judge(
    case: &Case<'_, Overlay2d>,
    asked: &Asked<'_>,
    answer: &Overlaid,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let broken = answer.overlay.arrangement.broken.into_iter();
    for rule in broken.chain(answer.regions.iter().filter_map(|made| made.broken)).map(Contradiction::rule) {
        note(outcome, Class::Topology, rule, "violated".to_owned(), rule);
    }
    asked.watch.done(0)?;
    let at = match Places::new(case.scene(), answer) {
        Ok(at) => at,
        Err(v) => {
            let got = format!("{v} has no finite coordinates");
            note(outcome, Class::Topology, "vertex not finite", got, "every vertex is a point");
            return Ok(());
        }
    };
    let expected = Expected {
        has_areas: asked.contract(PredicateKind::Orient2d).zero != ZeroMeaning::Never,
        edges_crossed: EDGES_CROSSED[usize::from(asked.budget.thorough)],
        located: LOCATED[usize::from(asked.budget.thorough)],
    };
    asked.watch.done(0)?;
    let contract = asked.contract(PredicateKind::Orient2d);
    // Proved signs are exact signs, or those of one perturbed scene.
    let is_sure = contract.proved && contract.zero != ZeroMeaning::Band;
    let key = || (is_sure, expected.has_areas, answer.clone(), answer.rounded.as_deref().map(bits));
    let (found, of_third) = case.once(asked, key, || {
        let of_third = if is_sure { flaws_of_third(case, answer, expected) } else { Vec::new() };
        Ok((flaws(case, asked, answer, &at, expected)?, of_third))
    })?;
    let is_metric = |flaw: &&Flaw| flaw.check.is_metric();
    let mut excuse = None;
    if answer.rounded.is_some() && found.iter().any(|flaw| is_metric(&flaw)) {
        let (rounding, exactly) = at.exactly(case.scene(), answer);
        // Only the metric laws count here, so samples are minimal.
        let few = Expected { edges_crossed: 1, located: 1, ..expected };
        let violated = flaws(case, asked, answer, &exactly, few)?;
        let violated = violated.iter().filter(is_metric).map(|flaw| flaw.check).collect();
        excuse = Some(Excuse { rounding, violated });
    }
    if is_sure {
        let points = answer.scene.as_ref().map(Points::of);
        let place = |v: Vertex| points.as_ref()?.point(v).map(|point| point.into_owned());
        for Shortcut { name, short, whole } in &answer.shortcuts {
            let [got, wanted] = [short, whole].map(|made| by_place(&made.regions, &place));
            if got != wanted || short.broken.is_some() || whole.broken.is_some() {
                let got = format!("{name}: {} regions", got.len());
                note(outcome, Class::Topology, "shortcut", got, &format!("{} regions", wanted.len()));
            }
        }
    }
    let told = |flaw: &Flaw| format!("{} times, first: {}", flaw.count, flaw.what);
    for flaw in found {
        let excuse = excuse.as_ref().filter(|_| is_metric(&&flaw));
        let (class, got) = Excuse::judged(excuse, &flaw.check, told(&flaw));
        note(outcome, class, flaw.check.name(), got, flaw.check.law());
    }
    for flaw in of_third {
        let got = format!("union and third polygon: {}", told(&flaw));
        note(outcome, Class::Topology, flaw.check.name(), got, flaw.check.law());
    }
    if outcome.findings.is_empty() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
    Ok(())
}

/// The violated laws, with vertices at these positions.
fn flaws(
    case: &Case<'_, Overlay2d>,
    asked: &Asked<'_>,
    answer: &Overlaid,
    at: &Places,
    expected: Expected,
) -> Result<Vec<Flaw>, Stop> {
    let (scene, content) = (case.scene(), case.content);
    let wanted = wanted(content);
    let graph = graph(scene, &wanted, answer, at);
    let mut flaws = graph.flaws(expected);
    asked.watch.done(0)?;
    if let Layers::Polygons(loops, rule) = &content.layers {
        let exactly = |one: &Vec<Vertex>| one.iter().map(|&v| input(scene, v)).collect();
        let loops = loops.each_ref().map(|loops| loops.iter().map(exactly).collect());
        let operands = Operands { loops, rules: [inside(*rule); 2] };
        let one = |edges: &Vec<Edge>| edges.iter().map(|edge| at.of(edge.from)).collect();
        let windings = Windings {
            passes: wanted.values().copied().collect(),
            faces: answer.overlay.windings.clone(),
            modulo_two: *rule == Rule::EvenOdd,
        };
        flaws.extend(windings.flaws(&graph));
        asked.watch.done(0)?;
        let mut results = Results::default();
        for (regions, made) in results.regions.iter_mut().zip(&answer.regions) {
            *regions = made.regions.iter().map(|region| region.loops().map(one).collect()).collect();
        }
        let only = [0, 1].map(|operand| windings.only(operand));
        flaws.extend(results.flaws(&operands, &probes(scene), expected, only));
    }
    Ok(flaws)
}

/// The laws that the results of the union and the third polygon violate, all at exact points.
fn flaws_of_third(case: &Case<'_, Overlay2d>, answer: &Overlaid, expected: Expected) -> Vec<Flaw> {
    let (false, Some(made)) = (answer.shortcuts.is_empty(), &answer.scene) else { return Vec::new() };
    let points = Points::of(made);
    let place = |v: Vertex| points.point(v).and_then(|point| point.into_owned().try_into().ok()).unwrap_or_default();
    let one = |edges: &Vec<Edge>| -> Vec<Point> { edges.iter().map(|edge| place(edge.from)).collect() };
    let of = |regions: &[Region]| regions.iter().map(|region| region.loops().map(one).collect()).collect();
    let polygons = [Polygon::from(answer.regions[0].regions.as_slice()), answer.third.clone()];
    let loops = polygons.each_ref().map(|polygon| polygon.loops.iter().map(one).collect());
    let operands = Operands { loops, rules: polygons.map(|polygon| inside(polygon.rule)) };
    let mut results = Results::default();
    for (regions, Shortcut { whole, .. }) in
        results.regions.iter_mut().zip(&answer.shortcuts[2 * Operation::ALL.len()..])
    {
        *regions = of(&whole.regions);
    }
    results.flaws(&operands, &probes(case.scene()), expected, [None; 2])
}

/// True for winding numbers of inner points.
fn inside(rule: Rule) -> fn(i32) -> bool {
    match rule {
        Rule::EvenOdd => |winding| winding % 2 != 0,
        Rule::NonZero => |winding| winding != 0,
    }
}

/// The loops of regions as points, each from its least corner on: the outer loop first, the holes sorted.
fn by_place<P: Ord>(regions: &[Region], place: &impl Fn(Vertex) -> P) -> Vec<Vec<Vec<P>>> {
    let loop_of = |one: &Vec<Edge>| {
        let mut corners: Vec<P> = one.iter().map(|edge| place(edge.from)).collect();
        // (A loop may pass its least corner twice.)
        let turned = |at: usize| corners[at..].iter().chain(&corners[..at]);
        let least = (0..corners.len()).min_by(|&a, &b| turned(a).cmp(turned(b))).unwrap_or(0);
        corners.rotate_left(least);
        corners
    };
    let region = |region: &Region| {
        let mut loops: Vec<Vec<P>> = region.loops().map(loop_of).collect();
        loops[1..].sort();
        loops
    };
    let mut all: Vec<Vec<Vec<P>>> = regions.iter().map(region).collect();
    all.sort();
    all
}

fn note(outcome: &mut Outcome, class: Class, check: &str, got: String, law: &str) {
    outcome.counts.add(class, 1);
    outcome.findings.push(Finding::plain(class, check, Vec::new(), got, law.to_owned()));
}

fn input(scene: &Scene, v: Vertex) -> Point {
    scene.point2(predicament_predicates::Plane::Xy, v).map(rational)
}

/// The positions of the vertices of an answer: exact, or as the session has rounded them.
struct Places {
    of: BTreeMap<Vertex, Point>,
}

impl Places {
    fn new(scene: &Scene, answer: &Overlaid) -> Result<Places, Vertex> {
        let points = answer.scene.as_ref().map(Points::of);
        let mut of = BTreeMap::new();
        for (at, &v) in answer.overlay.arrangement.vertices.iter().enumerate() {
            let point = if !v.is_constructed() {
                input(scene, v)
            } else if let Some(rounded) = &answer.rounded {
                let point = rounded[at];
                if !point.iter().all(|x| x.is_finite()) {
                    return Err(v);
                }
                point.map(rational)
            } else {
                let point = points.as_ref().and_then(|points| points.point(v)).ok_or(v)?;
                <[rug::Rational; 2]>::try_from(point.into_owned()).map_err(|_| v)?
            };
            of.insert(v, point);
        }
        Ok(Places { of })
    }

    /// The positions with all rounded vertices replaced by their exact positions.
    fn exactly(&self, scene: &Scene, answer: &Overlaid) -> (Rounding<2>, Places) {
        let vertices = &answer.overlay.arrangement.vertices;
        let rounded = answer.rounded.iter().flatten().zip(vertices).filter(|(_, v)| v.is_constructed());
        let (constructed, rounded): (Vec<Vertex>, Vec<[f64; 2]>) = rounded.map(|(point, &v)| (v, *point)).unzip();
        let scene = answer.scene.as_ref().unwrap_or(scene);
        let rounding = Rounding::new(scene, constructed.iter().copied().zip(rounded));
        let mut of = self.of.clone();
        of.extend(constructed.into_iter().zip(rounding.exact.iter().cloned()));
        (rounding, Places { of })
    }

    fn of(&self, v: Vertex) -> Point {
        self.of.get(&v).cloned().unwrap_or_default()
    }
}

/// The arrangement as numbers, with the segments that it must represent.
fn graph(scene: &Scene, wanted: &BTreeMap<[Vertex; 2], [i64; 2]>, answer: &Overlaid, at: &Places) -> Graph {
    let arrangement = &answer.overlay.arrangement;
    let subdivision = &arrangement.subdivision;
    let halves = 0..u32::try_from(2 * arrangement.pieces.len()).unwrap_or(u32::MAX);
    // Each required segment, and its chain, if any.
    let place: BTreeMap<[Vertex; 2], usize> = arrangement.segments.iter().copied().zip(0..).collect();
    let chain = |segment: &[Vertex; 2]| place.get(segment).map_or_else(Vec::new, |&at| arrangement.chain(at).to_vec());
    Graph {
        nodes: arrangement.vertices.iter().map(|&v| at.of(v)).collect(),
        chains: wanted.keys().map(chain).collect(),
        segments: wanted.keys().map(|ends| ends.map(|v| input(scene, v))).collect(),
        edges: arrangement.pieces.iter().map(|piece| piece.ends).collect(),
        next: halves.clone().map(|half| subdivision.next(half)).collect(),
        face: halves.map(|half| subdivision.face(half)).collect(),
        faces: subdivision.faces(),
    }
}

/// The segments that the arrangement must contain, each once: all, or those that an operand passes in one direction
/// more often than in the other (with an even-odd rule, an odd number of times). With each, for both operands, the
/// number of times that it is passed from its lower end to the other, less the times back.
fn wanted(content: &Layered) -> BTreeMap<[Vertex; 2], [i64; 2]> {
    let mut passed: BTreeMap<[Vertex; 2], [i64; 2]> = BTreeMap::new();
    match &content.layers {
        Layers::Segments(segments) => {
            for &[a, b] in segments {
                passed.insert([a.min(b), a.max(b)], [1, 1]);
            }
        }
        Layers::Polygons(operands, rule) => {
            for (operand, loops) in operands.iter().enumerate() {
                for one in loops {
                    for (&a, &b) in one.iter().zip(one.iter().cycle().skip(1)).filter(|(a, b)| a != b) {
                        passed.entry([a.min(b), a.max(b)]).or_default()[operand] += if a < b { 1 } else { -1 };
                    }
                }
            }
            let is_even_odd = *rule == Rule::EvenOdd;
            passed.retain(|_, times| times.iter().any(|times| if is_even_odd { times % 2 != 0 } else { *times != 0 }));
        }
    }
    passed
}

/// Points in the scene's box, in general position.
fn probes(scene: &Scene) -> Vec<Point> {
    let coordinates = scene.coordinates();
    let range = |axis: usize| {
        let along = coordinates.iter().skip(axis).step_by(2);
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &x| [low.min(x), high.max(x)])
    };
    let ranges = [0, 1].map(range);
    // Multiples of approximate irrational numbers: spread evenly, and not on any relevant line.
    let part = |at: usize, step: u64| {
        let at = u64::try_from(at).unwrap_or(0) + 1;
        rug::Rational::from((at.wrapping_mul(step) >> 11, 1_u64 << 53))
    };
    (0..PROBES)
        .map(|at| {
            let parts = [part(at, 0xC13F_A9A9_02A6_328F), part(at, 0x91E1_0DA5_C79E_7B1C)];
            [0, 1].map(|axis: usize| {
                let [low, high] = ranges[axis].map(rational);
                rug::Rational::from(&high - &low) * &parts[axis] + low
            })
        })
        .collect()
}
