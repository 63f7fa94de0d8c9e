//! Generated polygons of about n vertices: points, and loops of their indices.

use predicament_corpus::Random;
use predicament_formats::bits::{integer, power_of_two};

/// Points, and loops with the inside on their left.
pub(super) type Shape = (Vec<[f64; 2]>, Vec<Vec<usize>>);

fn small(n: usize) -> i64 {
    i64::try_from(n).expect("scenes are smaller than memory")
}

fn one_loop(points: Vec<[i64; 2]>) -> Shape {
    let all = (0..points.len()).collect();
    (points.into_iter().map(|p| p.map(integer)).collect(), vec![all])
}

/// A star-shaped polygon around the origin: vertices by angle, at distances from 0.1 to 1, on a grid of 2^-bits.
/// `divided` adds three vertices on each edge.
pub(super) fn star(n: usize, bits: u32, divided: bool, rng: &mut Random) -> Shape {
    let corners = (if divided { n / 4 } else { n }).max(4);
    let [first, second] = [corners / 2, corners - corners / 2];
    let unit = power_of_two(-i64::from(bits));
    let mut points = Vec::with_capacity(corners);
    // Points on each half circle by the tangent of half the angle: only the four basic operations, which give the same
    // results on every platform.
    for (count, side) in [(first, 1.0), (second, -1.0)] {
        for at in 0..count {
            let t = (integer(small(at)) + rng.between(0.25, 0.75)) / integer(small(count)) * 2.0 - 1.0;
            let radius = rng.between(0.1, 1.0) * side;
            let [x, y] = [(1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t)];
            // Rounded to multiples of four, so that the points between are on the grid.
            points.push([x, y].map(|c| (c * radius / (4.0 * unit)).round() * (4.0 * unit)));
        }
    }
    if divided {
        let ends = points.iter().cycle().skip(1);
        let between = |(p, q): (&[f64; 2], &[f64; 2])| {
            [0.0, 0.25, 0.5, 0.75].map(|part| [0, 1].map(|axis: usize| p[axis] + (q[axis] - p[axis]) * part))
        };
        points = points.iter().zip(ends).flat_map(between).collect();
    }
    let all = (0..points.len()).collect();
    (points, vec![all])
}

/// A spiral out and back, one unit to the left.
pub(super) fn spiral(n: usize) -> Shape {
    let turns = (n / 2).max(2);
    let directions = [[1, 0], [0, 1], [-1, 0], [0, -1]];
    let mut at = [0, 0];
    let (mut out, mut back) = (Vec::with_capacity(2 * turns), Vec::with_capacity(turns));
    for turn in 0..turns {
        // The previous and the next direction; at the ends there is only one.
        let next = directions[turn % 4];
        let last = if turn == 0 { [0, 0] } else { directions[(turn + 3) % 4] };
        let left = |[x, y]: [i64; 2]| [-y, x];
        let ahead = if turn + 1 == turns { [0, 0] } else { left(next) };
        let behind = left(last);
        out.push(at);
        back.push([0, 1].map(|axis: usize| at[axis] + ahead[axis] + behind[axis]));
        let length = 4 * (small(turn) / 2 + 1);
        at = [0, 1].map(|axis: usize| at[axis] + next[axis] * length);
    }
    out.extend(back.into_iter().rev());
    one_loop(out)
}

/// A comb whose teeth are as high as their number, with their tips in line.
pub(super) fn comb(n: usize, sideways: bool) -> Shape {
    let teeth = small(n.saturating_sub(3) / 2).max(1);
    let height = teeth + 2;
    let mut points = vec![[0, 0], [2 * teeth, 0]];
    for tooth in (0..teeth).rev() {
        points.push([2 * tooth + 2, height]);
        points.push([2 * tooth + 1, 1]);
    }
    points.push([0, height]);
    if sideways {
        points.iter_mut().for_each(|[x, y]| (*x, *y) = (-*y, *x));
    }
    one_loop(points)
}

/// A square with k by k holes. With `touching`, the holes are the squares of a chessboard, with common corners.
pub(super) fn grid(n: usize, touching: bool) -> Shape {
    let holes = small((n / 4).isqrt().max(1));
    let (pitch, side) = if touching { (1, holes + 2) } else { (2, 2 * holes + 1) };
    let mut points: Vec<[i64; 2]> = vec![[0, 0], [side, 0], [side, side], [0, side]];
    let mut loops: Vec<Vec<usize>> = vec![vec![0, 1, 2, 3]];
    // Common corners are one vertex: corner (i, j) of a chessboard has a fixed index.
    let corner = |i: i64, j: i64| usize::try_from(4 + i * (holes + 1) + j).expect("not negative");
    if touching {
        points.extend((0..=holes).flat_map(|i| (0..=holes).map(move |j| [i + 1, j + 1])));
    }
    for i in 0..holes {
        for j in 0..holes {
            if touching {
                if (i + j) % 2 == 0 {
                    loops.push(vec![corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)]);
                }
                continue;
            }
            let first = points.len();
            let [x, y] = [i, j].map(|at| pitch * at + 1);
            points.extend([[x, y], [x, y + 1], [x + 1, y + 1], [x + 1, y]]);
            loops.push((first..first + 4).collect());
        }
    }
    (points.into_iter().map(|p| p.map(integer)).collect(), loops)
}

/// The number of rings of a nest; sizes halve every two rings.
const NESTED: usize = 40;

/// Nests of squares and diamonds in turn, side by side. Each ring has its corners at the midpoints of the next larger
/// ring's edges, where that ring has vertices. With `apart`, the two rings have different vertices at one position.
pub(super) fn rings(n: usize, apart: bool) -> Shape {
    let mut points: Vec<[f64; 2]> = Vec::new();
    let mut loops = Vec::new();
    let all = (n / if apart { 8 } else { 4 }).max(2);
    for first in (0..all).step_by(NESTED) {
        let x = integer(small(first / NESTED)) * 4.0;
        // The four midpoints of the previous ring.
        let mut middles: Option<[usize; 4]> = None;
        for ring in 0..NESTED.min(all - first) {
            let r = power_of_two(-small(ring / 2));
            let unit = if ring % 2 == 0 {
                [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            } else {
                [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]]
            };
            let corners: [[f64; 2]; 4] = unit.map(|[u, v]| [x + u * r, v * r]);
            let corner_ids = middles.filter(|_| !apart).unwrap_or_else(|| {
                points.extend(corners);
                std::array::from_fn(|at| points.len() - 4 + at)
            });
            let middle_ids: [usize; 4] = std::array::from_fn(|at| points.len() + at);
            for at in 0..4 {
                let [p, q] = [corners[at], corners[(at + 1) % 4]];
                points.push([0, 1].map(|axis: usize| p[axis] / 2.0 + q[axis] / 2.0));
            }
            let mut one: Vec<usize> = (0..4).flat_map(|at| [corner_ids[at], middle_ids[at]]).collect();
            if ring % 2 == 1 {
                one.reverse();
            }
            loops.push(one);
            // The lower midpoint of a square is the first corner of its diamond; the lower left midpoint of a diamond
            // comes last.
            let [a, b, c, d] = middle_ids;
            middles = Some(if ring % 2 == 0 { [a, b, c, d] } else { [d, a, b, c] });
        }
    }
    (points, loops)
}

/// A sliver along the diagonal, with y − x within a few units. With `far`, it lies in three places with units of the
/// last place of each, as in the pictures of Kettner and others: there differences are rounded.
pub(super) fn sliver(n: usize, far: bool, rng: &mut Random) -> Shape {
    let count = small((n / 2).max(6));
    let places: Vec<[f64; 2]> = if far {
        let place = |(at, unit): (f64, i64)| {
            (0..count / 3).map(move |i| [at + integer(i) * power_of_two(unit), power_of_two(unit)])
        };
        [(0.5, -53), (12.0, -49), (24.0, -48)].into_iter().flat_map(place).collect()
    } else {
        (0..count).map(|x| [integer(x), power_of_two(-30)]).collect()
    };
    let mut side = |low: i64| -> Vec<[f64; 2]> {
        places.iter().map(|&[x, unit]| [x, x + integer(low + rng.integer(0, 3)) * unit]).collect()
    };
    let mut points = side(0);
    let mut upper = side(4);
    upper.reverse();
    points.append(&mut upper);
    let all = (0..points.len()).collect();
    (points, vec![all])
}

/// The outline of a random tree on a grid, thickened to unit squares; each edge has length one.
pub(super) fn maze(n: usize, rng: &mut Random) -> Shape {
    // A tree of k² nodes covers 2k² − 1 squares and has 4k² sides.
    let k = (n / 4).isqrt().max(2);
    let width = 2 * k + 1;
    // Squares of the maze have odd indices; a frame of empty squares surrounds them.
    let mut filled = vec![false; width * width];
    let mut path = vec![(1, 1)];
    filled[width + 1] = true;
    while let Some(&(x, y)) = path.last() {
        let steps: [(usize, usize); 4] = [(x + 2, y), (x, y + 2), (x.wrapping_sub(2), y), (x, y.wrapping_sub(2))];
        let open = |&(x, y): &(usize, usize)| x < width && y < width && !filled[y * width + x];
        let free: Vec<(usize, usize)> = steps.into_iter().filter(open).collect();
        if free.is_empty() {
            path.pop();
            continue;
        }
        let pick = usize::try_from(rng.integer(0, small(free.len()) - 1)).unwrap_or(0);
        let (u, v) = free[pick];
        filled[v * width + u] = true;
        filled[(y + v) / 2 * width + (x + u) / 2] = true;
        path.push((u, v));
    }
    // The outline is counterclockwise around the squares: for each grid point, the end of the edge that leaves it.
    let is_filled = |x: usize, y: usize| filled[y * width + x];
    let mut next = vec![None; (width + 1) * (width + 1)];
    let point = |x: usize, y: usize| y * (width + 1) + x;
    for y in 1..width - 1 {
        for x in 1..width - 1 {
            if !is_filled(x, y) {
                continue;
            }
            let sides = [
                (is_filled(x, y - 1), (x, y), (x + 1, y)),
                (is_filled(x + 1, y), (x + 1, y), (x + 1, y + 1)),
                (is_filled(x, y + 1), (x + 1, y + 1), (x, y + 1)),
                (is_filled(x - 1, y), (x, y + 1), (x, y)),
            ];
            for (_, from, to) in sides.into_iter().filter(|(is_inner, _, _)| !is_inner) {
                next[point(from.0, from.1)] = Some(to);
            }
        }
    }
    let mut points = Vec::new();
    let mut at = (1, 1);
    while let Some(to) = next[point(at.0, at.1)].take() {
        points.push([at.0, at.1].map(small));
        at = to;
    }
    one_loop(points)
}
