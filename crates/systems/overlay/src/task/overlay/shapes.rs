//! Generated segments and pairs of polygons: points, and indices of them.

use predicament_corpus::Random;
use predicament_crossings::task::content::short;
use predicament_formats::bits::{integer, power_of_two, step};

/// Points and segments between them.
#[derive(Default)]
pub(super) struct Lines {
    pub points: Vec<[f64; 2]>,
    pub segments: Vec<[usize; 2]>,
}

impl Lines {
    fn push(&mut self, a: [f64; 2], b: [f64; 2]) {
        self.segments.push([self.points.len(), self.points.len() + 1]);
        self.points.extend([a, b]);
    }
}

/// Points and the loops of two operands.
#[derive(Default)]
pub(super) struct Pair {
    pub points: Vec<[f64; 2]>,
    pub loops: [Vec<Vec<usize>>; 2],
}

impl Pair {
    fn push(&mut self, operand: usize, corners: Vec<[f64; 2]>) {
        let from = self.points.len();
        self.loops[operand].push((from..from + corners.len()).collect());
        self.points.extend(corners);
    }
}

fn small(n: usize) -> i64 {
    i64::try_from(n).expect("scenes are smaller than memory")
}

/// Short segments, uniform in the unit square: each crosses about one other.
pub(super) fn uniform(n: usize, rng: &mut Random) -> Lines {
    let mut lines = Lines::default();
    for &[a, b] in short(n, rng).as_chunks().0 {
        lines.push(a, b);
    }
    lines
}

/// Vertical and horizontal lines of a square grid, with their ends on the outermost lines: in every point two cross or
/// touch.
pub(super) fn grid(n: usize, _: &mut Random) -> Lines {
    let side = small((n / 2).max(2));
    let mut lines = Lines::default();
    for i in 0..side {
        let [at, last] = [integer(i), integer(side - 1)];
        lines.push([at, 0.0], [at, last]);
        lines.push([0.0, at], [last, at]);
    }
    lines
}

/// Segments through one point, exactly.
pub(super) fn pencil(n: usize, rng: &mut Random) -> Lines {
    let most = 1 << 20;
    let mut lines = Lines::default();
    for at in 0..n {
        // Spread around, each with a different direction.
        let along = small(at) * 2 - small(n);
        let [x, y] = if at % 2 == 0 { [integer(along), integer(most)] } else { [integer(most), integer(along)] };
        let reach = integer(rng.integer(1, 4));
        lines.push([x, y], [-x * reach, -y * reach]);
    }
    lines
}

/// Bundles of segments an ulp apart, crossing each other.
pub(super) fn bundles(n: usize, rng: &mut Random) -> Lines {
    let mut lines = Lines::default();
    let each = 8;
    for bundle in 0..n.div_ceil(each) {
        let [a, b] = [(); 2].map(|()| [rng.between(1.0, 2.0), rng.between(1.0, 2.0)]);
        for at in 0..each.min(n - bundle * each) {
            let by = small(at);
            lines.push([a[0], step(a[1], by)], [b[0], step(b[1], by)]);
        }
    }
    lines
}

/// A star-shaped polygon around a point, with corners at distances from `low` to 1; the first half of the corners is on
/// the right, the other half on the left.
fn star(n: usize, [x, y]: [f64; 2], low: f64, rng: &mut Random) -> Vec<[f64; 2]> {
    let corners = n.max(4);
    let [first, second] = [corners / 2, corners - corners / 2];
    let mut points = Vec::with_capacity(corners);
    // Points on each half circle by the tangent of half the angle: only the four basic operations, which give the same
    // results on every platform.
    for (count, side) in [(first, 1.0), (second, -1.0)] {
        for at in 0..count {
            let t = (integer(small(at)) + rng.between(0.25, 0.75)) / integer(small(count)) * 2.0 - 1.0;
            let radius = rng.between(low, 1.0) * side;
            let [u, v] = [(1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t)];
            points.push([x + u * radius, y + v * radius]);
        }
    }
    points
}

/// Two stars around one point.
pub(super) fn stars(n: usize, rng: &mut Random) -> Pair {
    let mut pair = Pair::default();
    for operand in 0..2 {
        pair.push(operand, star(n, [0.0, 0.0], 0.5, rng));
    }
    pair
}

/// A star, and the same star moved to the right by one ulp of its largest coordinate.
pub(super) fn shifted(n: usize, rng: &mut Random) -> Pair {
    let mut pair = Pair::default();
    let corners = star(n, [3.0, 3.0], 0.5, rng);
    let moved = corners.iter().map(|&[x, y]| [x + power_of_two(-50), y]).collect();
    pair.push(0, corners);
    pair.push(1, moved);
    pair
}

/// Two round rings of about n corners each: between four crossings of borders, most edges meet nothing.
pub(super) fn rings(n: usize, rng: &mut Random) -> Pair {
    let corners_of_loop = (n / 3).max(3);
    let mut pair = Pair::default();
    for (operand, centre) in [[0.0, 0.0], [0.625, 0.25]].into_iter().enumerate() {
        let outer = star(corners_of_loop, centre, 1.0, rng);
        // A hole in the ring, and a disc in the hole, which begins at its top.
        for by in [1.0, -0.75, 0.125] {
            let scaled =
                |p: &[f64; 2]| [0, 1].map(|axis: usize| centre[axis] + (p[axis] - centre[axis]) * f64::abs(by));
            let mut corners: Vec<[f64; 2]> = outer.iter().map(scaled).collect();
            if by < 0.0 {
                corners.reverse();
            }
            if (0.0..0.5).contains(&by) {
                corners.rotate_left(corners_of_loop / 2);
            }
            pair.push(operand, corners);
        }
    }
    pair
}

/// A comb with vertical teeth and one with horizontal teeth: every tooth crosses every other, and edges overlap.
pub(super) fn combs(n: usize, _: &mut Random) -> Pair {
    let teeth = small((n / 4).max(1));
    let width = 2 * teeth;
    let mut corners = vec![[0, -1], [width - 1, -1]];
    for tooth in (0..teeth).rev() {
        corners.extend([[2 * tooth + 1, width], [2 * tooth, width]]);
        if tooth > 0 {
            corners.extend([[2 * tooth, 0], [2 * tooth - 1, 0]]);
        }
    }
    let mut pair = Pair::default();
    pair.push(0, corners.iter().map(|p| p.map(integer)).collect());
    // Mirrored on the diagonal, and reversed to counterclockwise.
    pair.push(1, corners.iter().rev().map(|&[x, y]| [integer(y), integer(x)]).collect());
    pair
}

/// Squares of integer sides in rows, some on top of each other, clockwise and counterclockwise: edges are shared
/// completely and in part.
pub(super) fn squares(n: usize, rng: &mut Random) -> Pair {
    let mut pair = Pair::default();
    let side = small(n.isqrt().max(2));
    for at in 0..n.max(2) {
        let [x, y] = [(); 2].map(|()| rng.integer(0, side));
        let [w, h] = [(); 2].map(|()| rng.integer(1, 3));
        let mut corners = vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]];
        if rng.one_in(2) {
            corners.reverse();
        }
        pair.push(at % 2, corners.into_iter().map(|p| p.map(integer)).collect());
    }
    pair
}
