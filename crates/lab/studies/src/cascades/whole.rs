//! Results kept whole: one scene of all operands, with vertices constructed at the crossings of edges.

use std::collections::BTreeMap;
use std::time::Instant;

use predicament_judge::{point, rational};
use predicament_overlay::algorithm::overlay::{Edge, Known, Method as Search, Polygon, Region, Rule, combine_next};
use predicament_overlay::checks::overlay::{Point, Shape};
use predicament_predicates::{Plane, Predicates, Vertex};
use predicament_tasks::Contestant;

use super::cascade::{Loop, Operand};
use super::current::Points;
use super::step::{End, Stepped, Then};

/// Does the steps.
pub(super) fn run(backend: &dyn Contestant, start: &Loop, steps: &[Operand], then: &mut Then<'_>) -> Result<(), End> {
    let mut points = Points::default();
    let polygon = |edges: Vec<Edge>| Polygon { loops: vec![edges], rule: Rule::NonZero };
    let first = vec![Region { outer: points.edges(start), holes: Vec::new() }];
    let operands: Vec<Polygon> = steps.iter().map(|step| polygon(points.edges(&step.corners))).collect();
    let scene = points.scene()?;
    let mut end = Ok(());
    backend.with_session(&scene, &mut |session| end = follow(session, first.clone(), &operands, steps, then))?;
    end
}

fn follow(
    session: &mut dyn Predicates,
    mut current: Vec<Region>,
    operands: &[Polygon],
    steps: &[Operand],
    then: &mut Then<'_>,
) -> Result<(), End> {
    let mut known = Known::default();
    for (step, operand) in steps.iter().zip(operands) {
        let before = session.scene().constructions().len();
        let clock = Instant::now();
        let result = combine_next(session, &mut known, &current, operand, step.operation, Search::Grid)?;
        let elapsed = clock.elapsed();
        current = result.regions;
        let regions = || -> Vec<Vec<Vec<Vertex>>> {
            current.iter().map(|region| region.loops().map(|one| origins(one)).collect()).collect()
        };
        let session = &*session;
        let places = Places { session };
        then.call(Stepped {
            elapsed,
            constructed: session.scene().constructions().len() - before,
            collapsed: 0,
            held: session.scene().len() + session.scene().constructions().len(),
            thickness: 0.0,
            broken: result.broken.map(Into::into),
            is_gone: current.is_empty(),
            shape: &|| places.shape(&regions()),
            turned: &|| places.rounds().then(|| places.turned(&regions())),
        })?;
    }
    Ok(())
}

/// The first ends of a loop's edges.
pub(super) fn origins(edges: &[Edge]) -> Vec<Vertex> {
    edges.iter().map(|edge| edge.from).collect()
}

/// The positions of vertices, actual and by definition.
pub(super) struct Places<'s> {
    pub session: &'s dyn Predicates,
}

impl Places<'_> {
    /// Returns true if constructed vertices are rounded.
    fn rounds(&self) -> bool {
        let scene = self.session.scene();
        (0..scene.constructions().len()).any(|at| self.session.rounded_point(Vertex::constructed(at)).is_some())
    }

    /// The position by definition; the origin for a definition without a point.
    fn defined(&self, v: Vertex) -> Point {
        let found = point(self.session.scene(), v).and_then(|point| Point::try_from(point).ok());
        found.unwrap_or_default()
    }

    /// The session's position; the origin if that is not finite.
    fn actual(&self, v: Vertex) -> Point {
        match self.session.rounded_point(v).map(<[f64; 2]>::try_from) {
            Some(Ok(rounded)) if rounded.iter().all(|x| x.is_finite()) => rounded.map(rational),
            Some(_) => Point::default(),
            None if v.is_constructed() => self.defined(v),
            None => self.session.scene().point2(Plane::Xy, v).map(rational),
        }
    }

    fn shape(&self, regions: &[Vec<Vec<Vertex>>]) -> Shape {
        let mut known: BTreeMap<Vertex, Point> = BTreeMap::new();
        let mut at = |v: &Vertex| known.entry(*v).or_insert_with(|| self.actual(*v)).clone();
        let regions =
            regions.iter().map(|region| region.iter().map(|one| one.iter().map(&mut at).collect()).collect()).collect();
        Shape { regions }
    }

    /// The number of corners that turn differently from their definitions.
    pub fn turned(&self, regions: &[Vec<Vec<Vertex>>]) -> usize {
        turned(regions, |v| self.defined(v), |v| self.actual(v))
    }
}

/// The number of corners with a constructed vertex whose turn differs between two positions of their vertices.
pub(super) fn turned(
    regions: &[Vec<Vec<Vertex>>],
    mut before: impl FnMut(Vertex) -> Point,
    mut after: impl FnMut(Vertex) -> Point,
) -> usize {
    let mut differs = |corner: [Vertex; 3]| {
        corner.iter().any(|v| v.is_constructed())
            && turn(corner.map(&mut before)).cmp0() != turn(corner.map(&mut after)).cmp0()
    };
    let of_loop = |one: &Vec<Vertex>| {
        let corner = |at: usize| [0, 1, 2].map(|next| one[(at + next) % one.len()]);
        (0..one.len()).map(corner).filter(|corner| differs(*corner)).count()
    };
    regions.iter().flatten().map(of_loop).sum()
}

fn turn([a, b, c]: [Point; 3]) -> rug::Rational {
    let minus = |p: &Point, i: usize| rug::Rational::from(&p[i] - &a[i]);
    minus(&b, 0) * minus(&c, 1) - minus(&b, 1) * minus(&c, 0)
}
