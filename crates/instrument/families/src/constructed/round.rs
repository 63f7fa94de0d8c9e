//! Questions about circles and spheres through vertices where lines and planes meet.
//!
//! A query begins with points of one circle or sphere, with integer coordinates. In place of a point comes a vertex
//! where lines and planes through this point meet: the points that define them are a few integer steps away from it, so
//! the vertex is the point exactly. For queries one ulp beside a tie, one coordinate of each definition is moved.

use predicament_predicates::{Construction, Question, Vertex};

use super::flats::{Flat, Point, meet};
use super::{Arrangement, Kind, Trouble, line, plane};
use crate::bits::{integer, scale, step};
use crate::{Cloud, Random, decimal, native, uniform};

/// The magnitude of the components of directions, next to points with at most 33 bits.
const DIRECTION: i64 = 1 << 20;
/// The maximum number of directions from a point to those that define its lines and planes.
const STEPS: i64 = 7;

/// A scene of `n` queries with their points; none if the question is not about points of this dimension.
pub(super) fn queries(arrangement: Arrangement, question: Question, n: usize, mut rng: Random) -> Cloud {
    let (kind, width) = (question.kind(), arrangement.dimension().count());
    let mut cloud = Cloud { args: Some(Vec::new()), ..Cloud::default() };
    if native(kind) != width {
        return cloud;
    }
    for query in 0..n {
        let mut points = Vec::new();
        match arrangement.trouble {
            Trouble::Uniform => uniform(kind, &mut rng, &mut points),
            Trouble::Near { .. } | Trouble::Degenerate => decimal(kind, 0, &mut rng, &mut points),
        }
        // All sets of arguments in turn; a few queries already have each argument constructed.
        let places = 1 + 11 * query % ((1 << kind.arity()) - 1);
        for (place, point) in points.chunks_exact(width).enumerate() {
            let point: Point = std::array::from_fn(|axis| point.get(axis).copied().unwrap_or(0.0));
            let vertex = if places >> place & 1 == 1 {
                construct(&mut cloud, arrangement, point, &mut rng)
            } else {
                input(&mut cloud, width, point)
            };
            cloud.args.get_or_insert_default().push(vertex);
        }
    }
    cloud.coordinates.iter_mut().for_each(|x| *x = scale(*x, -arrangement.halvings));
    cloud
}

fn input(cloud: &mut Cloud, width: usize, point: Point) -> Vertex {
    cloud.coordinates.extend_from_slice(&point[..width]);
    Vertex::input(cloud.coordinates.len() / width - 1)
}

/// A vertex at the point, or an ulp beside it.
fn construct(cloud: &mut Cloud, arrangement: Arrangement, point: Point, rng: &mut Random) -> Vertex {
    let (kinds, dimension) = (arrangement.kinds, arrangement.dimension());
    let kind = if rng.one_in(2) { kinds[0] } else { kinds[kinds.len() - 1] };
    let unit = if arrangement.trouble == Trouble::Uniform { -20 } else { 0 };
    let mut flats: Vec<Flat> = loop {
        let mut flat = |is_line: bool| through(point, is_line, dimension.count(), unit, rng);
        let flats = match kind {
            Kind::Ssi => vec![flat(true), flat(true)],
            Kind::Lpi => vec![flat(true), flat(false)],
            Kind::Tpi => vec![flat(false), flat(false), flat(false)],
        };
        if meet(dimension, &flats.iter().map(Vec::as_slice).collect::<Vec<_>>()) {
            break flats;
        }
    };
    if let Trouble::Near { ulps } = arrangement.trouble {
        let mut draw = |count: usize| rng.integer(0, i64::try_from(count).expect("a handful") - 1).unsigned_abs();
        let [flat, axis] = [draw(flats.len()), draw(dimension.count())].map(|at| usize::try_from(at).expect("a few"));
        let moved = &mut flats[flat][0][axis];
        *moved = step(*moved, rng.integer(-ulps, ulps));
    }
    let vertices: Vec<Vec<Vertex>> =
        flats.iter().map(|flat| flat.iter().map(|&p| input(cloud, dimension.count(), p)).collect()).collect();
    let construction = match (kind, vertices.as_slice()) {
        (Kind::Ssi, [first, second]) => Construction::Ssi([line(first), line(second)]),
        (Kind::Lpi, [ends, spanning]) => Construction::Lpi { line: line(ends), plane: plane(spanning) },
        (Kind::Tpi, [first, second, third]) => Construction::Tpi([plane(first), plane(second), plane(third)]),
        _ => unreachable!("two or three parts"),
    };
    cloud.constructions.push(construction);
    Vertex::constructed(cloud.constructions.len() - 1)
}

/// Points of a line or plane through a point, each some steps along one of its directions away from the point.
fn through(point: Point, is_line: bool, width: usize, unit: i64, rng: &mut Random) -> Flat {
    let mut direction =
        || -> [i64; 3] { std::array::from_fn(|axis| if axis < width { rng.nonzero(DIRECTION) } else { 0 }) };
    let (u, v) = (direction(), direction());
    let [i, j, k] = [0; 3].map(|_| rng.integer(1, STEPS));
    // The third point of a plane is on the other side of the point: the three are never in one line.
    let steps: &[[i64; 2]] = if is_line { &[[i, 0], [-j, 0]] } else { &[[i, 0], [0, j], [-k, -k]] };
    let at =
        |&[i, j]: &[i64; 2]| std::array::from_fn(|axis| point[axis] + scale(integer(i * u[axis] + j * v[axis]), unit));
    steps.iter().map(at).collect()
}
