//! Squares with random holes that touch each other, the square, and islands in the holes.
//!
//! A loop is drawn corner by corner. A corner is a vertex of the loops before it, another vertex at its place, a point
//! in the middle of an edge, or anywhere. A loop that makes the polygon invalid is dropped, and the next one is drawn.

use predicament_corpus::Random;
use predicament_formats::bits::integer;
use predicament_predicates::{Plane, Scene, Vertex};

use super::shapes::Shape;
use crate::checks::Polygon;

/// The length of a square's side, and the distance between squares.
const SIDE: i64 = 12;
const PITCH: i64 = 16;
/// The maximum number of loops of a square, and of loops that are drawn for it.
const LOOPS: usize = 8;
const TRIES: usize = 40;

/// One square with its holes.
struct Nest {
    points: Vec<[i64; 2]>,
    loops: Vec<Vec<usize>>,
}

/// Squares side by side, of about n vertices together.
pub(super) fn touching(n: usize, rng: &mut Random) -> Shape {
    let (mut points, mut loops): Shape = (Vec::new(), Vec::new());
    let mut left = 0;
    while points.len() < n.max(12) {
        let nest = Nest::new(rng);
        let first = points.len();
        points.extend(nest.points.iter().map(|&[x, y]| [integer(x + left), integer(y)]));
        loops.extend(nest.loops.iter().map(|one| one.iter().map(|corner| first + corner).collect()));
        left += PITCH;
    }
    (points, loops)
}

impl Nest {
    fn new(rng: &mut Random) -> Nest {
        let square = vec![[0, 0], [SIDE, 0], [SIDE, SIDE], [0, SIDE]];
        let mut nest = Nest { points: square, loops: vec![(0..4).collect()] };
        for _ in 0..TRIES {
            if nest.loops.len() < LOOPS {
                nest.add(rng);
            }
        }
        nest
    }

    /// Draws a loop, and keeps it if the polygon stays valid.
    fn add(&mut self, rng: &mut Random) {
        let points = self.points.len();
        let corners = below(rng, 3) / 2 + 3;
        let mut one = vec![self.corner(None, rng)];
        while one.len() < corners {
            one.push(self.corner(Some(self.points[one[0]]), rng));
        }
        self.loops.push(one);
        if !self.is_valid() {
            self.loops.pop();
            self.points.truncate(points);
        }
    }

    /// A corner of a loop, within a few units of its first corner.
    fn corner(&mut self, near: Option<[i64; 2]>, rng: &mut Random) -> usize {
        let [one, at] = {
            let one = &self.loops[below(rng, self.loops.len())];
            let at = below(rng, one.len());
            [one[at], one[(at + 1) % one.len()]]
        };
        let [p, q] = [self.points[one], self.points[at]];
        let kind = below(rng, if near.is_some() { 12 } else { 5 });
        let point = match kind {
            0 => return one,
            1 => p,
            2 | 3 => {
                let parts = greatest_common_divisor(p[0] - q[0], p[1] - q[1]).max(1);
                let part = rng.integer(0, parts);
                [0, 1].map(|axis: usize| p[axis] + (q[axis] - p[axis]) / parts * part)
            }
            _ => {
                let place = |axis: usize| match near {
                    None => rng.integer(0, SIDE),
                    Some(near) => near[axis] + rng.integer(-4, 4),
                };
                [0, 1].map(place).map(|along: i64| along.clamp(0, SIDE))
            }
        };
        self.points.push(point);
        self.points.len() - 1
    }

    fn is_valid(&self) -> bool {
        let points: Vec<[f64; 2]> = self.points.iter().map(|p| p.map(integer)).collect();
        let scene = Scene::from_points2(&points).expect("small integers are finite");
        let is_short = |one: &Vec<usize>| (0..one.len()).any(|at| one[at] == one[(at + 1) % one.len()]);
        let vertices = |one: &Vec<usize>| one.iter().copied().map(Vertex::input).collect();
        !self.loops.iter().any(is_short)
            && Polygon::new(&scene, Plane::Xy, false, &self.loops.iter().map(vertices).collect::<Vec<_>>())
                .fault()
                .is_none()
    }
}

fn below(rng: &mut Random, count: usize) -> usize {
    let most = i64::try_from(count).expect("scenes are smaller than memory") - 1;
    usize::try_from(rng.integer(0, most)).unwrap_or(0)
}

fn greatest_common_divisor(a: i64, b: i64) -> i64 {
    if b == 0 { a.abs() } else { greatest_common_divisor(b, a % b) }
}
