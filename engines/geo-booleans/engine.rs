//! The crate `geo`: `BooleanOps` with a rule. It applies the rule to all rings of an operand, of whatever polygon, so each
//! ring goes in as a polygon of its own.

use geo::algorithm::bool_ops::{BooleanOps, FillRule, OpType};
use geo::{Coord, LineString, MultiPolygon};
use predicament_engine::{Engine, Polygon, Results, Task, locked, serve};

#[derive(Default)]
struct Geo;

impl Engine for Geo {
    const NAME: &'static str = "geo-booleans";
    const TASKS: &'static [Task] = &[Task::Overlay2d];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "geo")
    }

    fn overlay2d(&self, first: &Polygon, second: &Polygon, even_odd: bool) -> Result<Results<Vec<Polygon>>, String> {
        let rule = if even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let [first, second] = [first, second].map(region);
        let result = |operation| Some(polygons(&first.boolean_op_with_fill_rule(&second, operation, rule)));
        Ok(Results {
            union: result(OpType::Union),
            intersection: result(OpType::Intersection),
            difference: result(OpType::Difference),
            symmetric_difference: result(OpType::Xor),
        })
    }
}

fn region(rings: &Polygon) -> MultiPolygon {
    let ring = |ring: &Vec<[f64; 2]>| LineString(ring.iter().map(|&[x, y]| Coord { x, y }).collect());
    MultiPolygon(rings.iter().map(|one| geo::Polygon::new(ring(one), Vec::new())).collect())
}

fn polygons(found: &MultiPolygon) -> Vec<Polygon> {
    let ring = |ring: &LineString| ring.coords().map(|at| [at.x, at.y]).collect();
    let rings = |one: &geo::Polygon| std::iter::once(one.exterior()).chain(one.interiors()).map(ring).collect();
    found.iter().map(rings).collect()
}

fn main() -> std::process::ExitCode {
    serve::<Geo>()
}
