//! The cascades: an initial polygon, and the operation of each step.
//!
//! They use only the four operations and square roots, which are the same everywhere. All coordinates are below 4.

use predicament_corpus::Random;
use predicament_formats::bits::{integer, step};
use predicament_overlay::algorithm::overlay::Operation;

/// The corners of a polygon, in their order.
pub type Loop = Vec<[f64; 2]>;

/// A step: an operation and its second operand.
#[derive(Clone, PartialEq, Debug)]
pub struct Operand {
    /// The operation; the first operand is the result so far.
    pub operation: Operation,
    /// The second operand: a simple counterclockwise loop.
    pub corners: Loop,
}

/// A sequence of Boolean operations.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, clap::ValueEnum)]
pub enum Cascade {
    /// A square united with its copy turned around its centre, every fourth time by almost the same angle as before
    Rotate,
    /// A square cut by half-planes that touch a circle; every fourth is an earlier one moved by an ulp
    Shave,
    /// Stars united one by one; every fourth is an earlier one moved by an ulp
    Stars,
    /// The regions of a map united one by one; every second one has borders with half the vertices, smoothed
    Generalise,
}

impl Cascade {
    /// All cascades.
    pub const ALL: [Cascade; 4] = [Cascade::Rotate, Cascade::Shave, Cascade::Stars, Cascade::Generalise];

    /// The cascade's name in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Cascade::Rotate => "rotate",
            Cascade::Shave => "shave",
            Cascade::Stars => "stars",
            Cascade::Generalise => "generalise",
        }
    }

    /// The initial loop, and the operation and second operand of each of `count` steps.
    #[must_use]
    pub fn steps(self, count: usize, seed: u64) -> (Loop, Vec<Operand>) {
        let mut random = Random::new(self.name(), "cascades", seed);
        match self {
            Cascade::Rotate => rotate(count),
            Cascade::Shave => shave(count),
            Cascade::Stars => stars(count, &mut random),
            Cascade::Generalise => generalise(count, &mut random),
        }
    }
}

/// Every other vertex of a line.
///
/// The inner ones are moved half way to the middle of their neighbours.
fn smoothed(line: &Loop) -> Loop {
    let mut kept: Loop = line.iter().step_by(2).copied().collect();
    for at in 1..kept.len().saturating_sub(1) {
        let [before, own, after] = [line[2 * at - 1], line[2 * at], line[2 * at + 1]];
        kept[at] = [0, 1].map(|axis: usize| own[axis] / 2.0 + (before[axis] + after[axis]) / 4.0);
    }
    kept
}

fn small(n: usize) -> f64 {
    integer(i64::try_from(n).expect("few steps"))
}

/// The values (cos, sin) of twice the angle whose tangent is t, rounded.
fn turned(t: f64) -> [f64; 2] {
    [(1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t)]
}

fn union(corners: Loop) -> Operand {
    Operand { operation: Operation::Union, corners }
}

fn rotate(count: usize) -> (Loop, Vec<Operand>) {
    let square = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
    let turn = |at: usize| {
        // By less than a right angle; every fourth by a tiny amount more than the one before.
        let t = if at % 4 == 3 { small(at - 1) * (1.0 + f64::EPSILON) } else { small(at) } / small(count + 1);
        let [c, s] = turned(t);
        union(square.map(|[x, y]| [c * x - s * y, s * x + c * y]).to_vec())
    };
    (square.to_vec(), (1..=count).map(turn).collect())
}

fn shave(count: usize) -> (Loop, Vec<Operand>) {
    let square = vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let mut steps: Vec<Operand> = Vec::with_capacity(count);
    for at in 0..count {
        let corners = if at % 4 == 3 {
            // The cut before the last, an ulp farther inside on one side.
            let mut corners = steps[at - 2].corners.clone();
            corners[0][0] = step(corners[0][0], if corners[0][0] > 0.0 { -1 } else { 1 });
            corners
        } else {
            // Directions spread over the circle by the golden ratio, in quarters of it.
            let around = small(at) * 0.618_033_988_749_894_9 * 4.0;
            let (quarter, part) = (around % 4.0, around.fract());
            let [c, s] = turned(part);
            let [c, s] = match quarter {
                q if q < 1.0 => [c, s],
                q if q < 2.0 => [-s, c],
                q if q < 3.0 => [-c, -s],
                _ => [s, -c],
            };
            // A box beside the line that touches the circle of radius 0.9.
            let at = |along: f64, out: f64| [c * out - s * along, s * out + c * along];
            vec![at(-1.5, 0.9), at(-1.5, 2.0), at(1.5, 2.0), at(1.5, 0.9)]
        };
        steps.push(Operand { operation: Operation::Difference, corners });
    }
    (square, steps)
}

fn stars(count: usize, random: &mut Random) -> (Loop, Vec<Operand>) {
    let reach = 1.5 / small(count.max(1)).sqrt();
    let mut star = |points: usize| {
        let [x, y] = [random.unit(), random.unit()];
        let corner = |at: usize| {
            let half = points / 2;
            let [u, v] = turned((small(at % half) + 0.5) / small(half) * 2.0 - 1.0);
            let radius = reach * if at.is_multiple_of(2) { 1.0 } else { 0.4 } * if at < half { 1.0 } else { -1.0 };
            [x + radius * u, y + radius * v]
        };
        (0..points).map(corner).collect::<Loop>()
    };
    let first = star(16);
    let mut steps: Vec<Operand> = Vec::with_capacity(count);
    for at in 0..count {
        let corners = if at % 4 == 3 {
            // An earlier one, moved by an ulp.
            steps[at / 2].corners.iter().map(|&[x, y]| [step(x, 1), y]).collect()
        } else {
            star(16)
        };
        steps.push(union(corners));
    }
    (first, steps)
}

/// The number of times that borders of regions are divided.
const LEVELS: u32 = 3;

fn generalise(count: usize, random: &mut Random) -> (Loop, Vec<Operand>) {
    // Regions in rows; each row from the left to the right.
    let across = (1..).find(|side| side * side > count).unwrap_or(1);
    let size = 2.0 / small(across);
    let mut corner = |_: usize| [random.between(-0.2, 0.2), random.between(-0.2, 0.2)];
    let shifts: Vec<[f64; 2]> = (0..(across + 1) * (across + 1)).map(&mut corner).collect();
    let place = |x: usize, y: usize| {
        let [dx, dy] = shifts[y * (across + 1) + x];
        [(small(x) + dx) * size, (small(y) + dy) * size]
    };
    // The border between two corners, from the lower to the higher: the same for both regions.
    let mut border = |a: [f64; 2], b: [f64; 2]| {
        let mut line = vec![a, b];
        for _ in 0..LEVELS {
            let mut finer = Vec::with_capacity(2 * line.len());
            for pair in line.windows(2) {
                let [from, to] = [pair[0], pair[1]];
                let by = random.between(-0.15, 0.15);
                let middle = [0, 1].map(|axis: usize| {
                    let across = to[1 - axis] - from[1 - axis];
                    (from[axis] + to[axis]) / 2.0 + by * if axis == 0 { -across } else { across }
                });
                finer.extend([from, middle]);
            }
            finer.extend(line.last());
            line = finer;
        }
        line
    };
    let (mut level, mut upright) = (Vec::new(), Vec::new());
    for y in 0..=across {
        for x in 0..across {
            level.push(border(place(x, y), place(x + 1, y)));
            upright.push(border(place(y, x), place(y, x + 1)));
        }
    }
    let region = |at: usize| {
        let (x, y) = (at % across, at / across);
        let sides = [
            (&level[y * across + x], false),
            (&upright[(x + 1) * across + y], false),
            (&level[(y + 1) * across + x], true),
            (&upright[x * across + y], true),
        ];
        let mut corners = Loop::new();
        for (line, backward) in sides {
            let mut kept = if (x + y) % 2 == 0 { line.clone() } else { smoothed(line) };
            if backward {
                kept.reverse();
            }
            kept.pop();
            corners.extend(kept);
        }
        corners
    };
    (region(0), (1..=count).map(|at| union(region(at))).collect())
}
