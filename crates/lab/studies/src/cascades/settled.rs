//! Results that are adapted to the next operand first: thick primitives, and contacts of the tolerance scheme.
//!
//! Overlapping parts are merged first. Then plain floating point combines the polygons, as all common points should now
//! be vertices.

use std::collections::{BTreeMap, HashMap};
use std::time::{Duration, Instant};

use predicament_contacts::algorithm::arrangement::{Arrangement, MergedPoint, Side, Stand};
use predicament_contacts::algorithm::pairs::Weights;
use predicament_contacts::algorithm::thick::{self, Disc, Drawing, settle};
use predicament_mesh::{Complex, Simplex, Simplices};
use predicament_overlay::algorithm::overlay::{Contradiction, Edge, Method as Search, Polygon, Regions, Rule, overlay};
use predicament_predicates::{Predicates, Scene, Vertex};
use predicament_tasks::Contestant;

use super::cascade::{Loop, Operand};
use super::current::{Points, cleaned};
use super::rounded::{in_session, place};
use super::step::{End, Stepped, Then, shape_of};
use super::whole::origins;
use crate::contacts::contacts;

/// The number of times that each operand passes an edge, from its lower vertex to its higher.
type Passes = BTreeMap<[Vertex; 2], [i32; 2]>;

/// Adds passes of an operand over an edge.
fn pass(passes: &mut Passes, from: Vertex, to: Vertex, operand: usize, times: i32) {
    let (ends, sign) = if from < to { ([from, to], 1) } else { ([to, from], -1) };
    if from != to {
        passes.entry(ends).or_default()[operand] += sign * times;
    }
}

/// An operand as the edges that it passes.
fn polygon(passes: &Passes, operand: usize) -> Polygon {
    let of = |(&[from, to], times): (&[Vertex; 2], &[i32; 2])| {
        let times = times[operand];
        let edge = if times < 0 { Edge::whole(to, from) } else { Edge::whole(from, to) };
        std::iter::repeat_n(edge, times.unsigned_abs() as usize)
    };
    Polygon { loops: vec![passes.iter().flat_map(of).collect()], rule: Rule::NonZero }
}

/// A result in floating point, with the positions of its vertices.
struct Combined {
    result: Regions,
    at: HashMap<Vertex, [f64; 2]>,
    constructed: usize,
    broken: Option<Contradiction>,
}

fn combined(float: &dyn Contestant, scene: &Scene, passes: &Passes, step: &Operand) -> Result<Combined, End> {
    in_session(float, scene, &mut |session| {
        let operands = [0, 1].map(|operand| polygon(passes, operand));
        let [a, b] = &operands;
        let made = overlay(session, [a, b], Search::Grid)?;
        let result = made.regions(step.operation);
        let session: &dyn Predicates = &*session;
        let vertices = result.regions.iter().flat_map(|region| region.loops()).flatten().map(|edge| edge.from);
        let at = vertices.map(|v| (v, place(session, v))).collect();
        let broken = made.arrangement.broken.or(result.broken);
        Ok(Combined { at, constructed: session.scene().constructions().len(), broken, result })
    })
}

/// Does the steps with thick primitives: radii stay with vertices and edges from step to step.
pub(super) fn run_thick(
    float: &dyn Contestant,
    radius: f64,
    start: &Loop,
    steps: &[Operand],
    then: &mut Then<'_>,
) -> Result<(), End> {
    let mut current = ring(start, radius, 0);
    for step in steps {
        let clock = Instant::now();
        let offset = number(current.discs.len());
        let mut drawing = std::mem::take(&mut current);
        let operand = ring(&step.corners, radius, 1);
        drawing.discs.extend(operand.discs);
        drawing
            .edges
            .extend(operand.edges.iter().map(|edge| thick::Edge { ends: edge.ends.map(|end| end + offset), ..*edge }));
        let settled = settle(drawing);
        let thickness = settled.largest();
        let Drawing { discs, edges } = &settled.drawing;
        let mut points = Points::default();
        let vertices: Vec<Vertex> = discs.iter().map(|disc| points.vertex(disc.centre)).collect();
        let mut passes = Passes::new();
        let mut radii: HashMap<[Vertex; 2], f64> = HashMap::new();
        for edge in edges {
            let [from, to] = edge.ends.map(|end| vertices[end as usize]);
            (0..2).for_each(|operand| pass(&mut passes, from, to, operand, edge.passes[operand]));
            let known = radii.entry([from.min(to), from.max(to)]).or_default();
            *known = known.max(edge.radius);
        }
        let made = combined(float, &points.scene()?, &passes, step)?;
        let mut discs_of: HashMap<Vertex, f64> = HashMap::new();
        for (disc, v) in discs.iter().zip(&vertices) {
            let known = discs_of.entry(*v).or_default();
            *known = known.max(disc.radius);
        }
        let radius_of = |edge: &Edge| {
            let [a, b] = edge.support;
            radii.get(&[a.min(b), a.max(b)]).copied().unwrap_or(radius)
        };
        let mut places: HashMap<Vertex, u32> = HashMap::new();
        for one in made.result.regions.iter().flat_map(|region| region.loops()) {
            for (edge, next) in one.iter().zip(one.iter().cycle().skip(1)) {
                let mut vertex = |v: Vertex| {
                    *places.entry(v).or_insert_with(|| {
                        let radius = discs_of.get(&v).copied().unwrap_or_else(|| radius_of(edge));
                        current.discs.push(Disc { centre: made.at[&v], radius });
                        number(current.discs.len() - 1)
                    })
                };
                let ends = [vertex(edge.from), vertex(next.from)];
                current.edges.push(thick::Edge { ends, radius: radius_of(edge), passes: [1, 0] });
            }
        }
        let (regions, collapsed) = cleaned(loops(&made));
        let unsettled = (!settled.is_settled).then_some(super::Contradiction::Unsettled);
        then.call(Stepped {
            elapsed: clock.elapsed(),
            constructed: settled.crossed + made.constructed,
            collapsed: collapsed + settled.merged,
            held: current.discs.len(),
            thickness,
            broken: unsettled.or(made.broken.map(Into::into)),
            is_gone: regions.is_empty(),
            shape: &|| shape_of(&regions),
            turned: &|| None,
        })?;
    }
    Ok(())
}

/// A loop of thick edges.
fn ring(corners: &Loop, radius: f64, operand: usize) -> Drawing {
    let count = number(corners.len());
    let mut passes = [0; 2];
    passes[operand] = 1;
    Drawing {
        discs: corners.iter().map(|&centre| Disc { centre, radius }).collect(),
        edges: (0..count).map(|at| thick::Edge { ends: [at, (at + 1) % count], radius, passes }).collect(),
    }
}

fn loops(made: &Combined) -> Vec<Vec<Loop>> {
    let corner = |v: &Vertex| made.at[v];
    let of = |region: &predicament_overlay::algorithm::overlay::Region| {
        region.loops().map(|one| origins(one).iter().map(corner).collect()).collect()
    };
    made.result.regions.iter().map(of).collect()
}

/// Does the steps with the contacts that the tolerance scheme registers, once per step.
pub(super) fn run_contacts(
    backend: &dyn Contestant,
    float: &dyn Contestant,
    start: &Loop,
    steps: &[Operand],
    then: &mut Then<'_>,
) -> Result<(), End> {
    let mut current = vec![vec![start.clone()]];
    for step in steps {
        let clock = Instant::now();
        let merged = Merged::of(backend, &current, &step.corners)?;
        let made = combined(float, &merged.scene, &merged.passes, step)?;
        let (regions, collapsed) = cleaned(loops(&made));
        let elapsed: Duration = clock.elapsed();
        current = regions;
        then.call(Stepped {
            elapsed,
            constructed: merged.crossings + made.constructed,
            collapsed: collapsed + merged.merged,
            held: current.iter().flatten().map(Vec::len).sum(),
            thickness: 0.0,
            broken: made.broken.map(Into::into),
            is_gone: current.is_empty(),
            shape: &|| shape_of(&current),
            turned: &|| None,
        })?;
    }
    Ok(())
}

/// Two operands merged at their contacts.
struct Merged {
    scene: Scene,
    passes: Passes,
    crossings: usize,
    merged: usize,
}

impl Merged {
    fn of(backend: &dyn Contestant, regions: &[Vec<Loop>], corners: &Loop) -> Result<Merged, End> {
        let mut sides = [Points::default(), Points::default()];
        let first: Vec<Edge> = regions.iter().flatten().flat_map(|one| sides[0].edges(one)).collect();
        let second = sides[1].edges(corners);
        let offset = sides[0].points.len();
        let moved = |v: Vertex| Vertex::input(v.index() + offset);
        let operands = [
            first.iter().map(|edge| [edge.from, edge.to]).collect::<Vec<_>>(),
            second.iter().map(|edge| [moved(edge.from), moved(edge.to)]).collect(),
        ];
        let scene = Scene::from_points2(&[sides[0].points.as_slice(), &sides[1].points].concat());
        let scene = scene?;
        let complex = |edges: &Vec<[Vertex; 2]>| {
            Complex::new(&scene, &Simplices { edges: edges.clone(), ..Simplices::default() })
        };
        let [a, b] = [complex(&operands[0])?, complex(&operands[1])?];
        let lengths = [&a, &b].map(|complex| complex.primitive_length(&scene));
        let scene = scene.with_primitive_lengths(lengths);
        let found = contacts(backend, &scene, [&a, &b])?;
        let arrangement = Arrangement::new(&scene, [&a, &b], &found);
        let seats = Seats { scene: &scene, complexes: [&a, &b], arrangement: &arrangement };
        let mut points = Points::default();
        let nodes: Vec<Vertex> = arrangement.points().iter().map(|point| points.vertex(seats.of(point))).collect();
        let mut passes = Passes::new();
        for (operand, (side, complex)) in Side::BOTH.into_iter().zip([&a, &b]).enumerate() {
            let place: HashMap<[Vertex; 2], u32> = complex.edges().iter().copied().zip(0..).collect();
            for &[from, to] in &operands[operand] {
                let path = arrangement.path(side, place[&[from.min(to), from.max(to)]]);
                let times = if from < to { 1 } else { -1 };
                for pair in path.windows(2) {
                    pass(&mut passes, nodes[pair[0]], nodes[pair[1]], operand, times);
                }
            }
        }
        let crossings = arrangement.points().iter().filter(|point| point.is_new()).count();
        let merged = scene.len() + crossings - arrangement.points().len();
        Ok(Merged { scene: points.scene()?, passes, crossings, merged })
    }
}

/// The positions of merged points: on the first operand if it has the point, else on the second.
struct Seats<'a> {
    scene: &'a Scene,
    complexes: [&'a Complex; 2],
    arrangement: &'a Arrangement,
}

impl Seats<'_> {
    fn of(&self, point: &MergedPoint) -> [f64; 2] {
        let stand = |side: Side| point.stand(side).map(|stand| self.stand(side, stand));
        Side::BOTH.into_iter().find_map(stand).unwrap_or([0.0; 2])
    }

    fn stand(&self, side: Side, stand: Stand) -> [f64; 2] {
        let raw = |v: Vertex| self.scene.point2(predicament_predicates::Plane::Xy, v);
        match stand {
            Stand::Vertex(v) => raw(v),
            Stand::Inside(simplex, weights) => self.between(side, simplex, weights),
        }
    }

    fn between(&self, side: Side, simplex: Simplex, weights: Weights) -> [f64; 2] {
        let complex = self.complexes[side as usize];
        let corners = complex.vertices_of(simplex);
        let mut at = [0.0; 2];
        for (&corner, weight) in corners.iter().zip(weights) {
            // A merged corner has the position of its class.
            let class = complex.vertices().binary_search(&corner).ok().and_then(|place| u32::try_from(place).ok());
            let class = class.map(|place| &self.arrangement.points()[self.arrangement.of_vertex(side, place)]);
            let corner = match class.and_then(|class| class.vertices[0].first()) {
                Some(&first) => self.scene.point2(predicament_predicates::Plane::Xy, first),
                None => self.scene.point2(predicament_predicates::Plane::Xy, corner),
            };
            (0..2).for_each(|axis| at[axis] += weight * corner[axis]);
        }
        at
    }
}

fn number(place: usize) -> u32 {
    u32::try_from(place).expect("fewer than 2^32 vertices")
}
