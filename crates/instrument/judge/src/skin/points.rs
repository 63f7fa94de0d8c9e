//! Points at which solids are tested. Any point is right; these find thin parts and wrong sides of triangles.

use super::Corners;

type Double = [f64; 3];

/// The distances of points beside triangles: in units of the tested distance, then of the largest distance of rounding.
const BESIDE: ([f64; 3], [f64; 2]) = ([2.0, 64.0, 65_536.0], [4.0, 1024.0]);
/// The places of points in a triangle: the middle, and near two corners.
const PLACES: [Double; 3] = [[0.35, 0.33, 0.32], [0.93, 0.04, 0.03], [0.02, 0.05, 0.93]];

fn less(p: Double, q: Double) -> Double {
    [0, 1, 2].map(|i: usize| p[i] - q[i])
}

fn cross(p: Double, q: Double) -> Double {
    [0, 1, 2].map(|i: usize| {
        let [j, k] = [(i + 1) % 3, (i + 2) % 3];
        p[j] * q[k] - p[k] * q[j]
    })
}

fn norm(p: Double) -> f64 {
    p[0].hypot(p[1]).hypot(p[2])
}

/// The area of a triangle, approximately.
#[must_use]
pub fn area([a, b, c]: &Corners) -> f64 {
    norm(cross(less(*b, *a), less(*c, *a))) / 2.0
}

/// The length of a triangle's sides, approximately.
#[must_use]
pub fn length([a, b, c]: &Corners) -> f64 {
    norm(less(*b, *a)) + norm(less(*c, *b)) + norm(less(*a, *c))
}

/// Points on both sides of triangles, and anywhere in their box: at distances in units of `within` and of `coarsest`.
/// About `most` triangles' sides are used, spread evenly.
#[must_use]
pub fn candidates<'t>(
    triangles: impl Iterator<Item = &'t Corners> + Clone,
    [within, coarsest]: [f64; 2],
    most: usize,
) -> Vec<Double> {
    let mut points = Vec::new();
    let each = 2 * (BESIDE.0.len() + BESIDE.1.len()) * PLACES.len();
    let step = (triangles.clone().count() * each).div_ceil(most.max(1)).max(1);
    for corners in triangles.clone().step_by(step) {
        let [a, b, c] = *corners;
        let normal = cross(less(b, a), less(c, a));
        let size = norm(normal);
        for [u, v, w] in PLACES {
            let on = [0, 1, 2].map(|i: usize| u * a[i] + v * b[i] + w * c[i]);
            let near = BESIDE.0.iter().map(|units| units * within);
            for distance in near.chain(BESIDE.1.iter().map(|units| units * coarsest)) {
                let off = distance / size;
                for side in [off, -off] {
                    points.push([0, 1, 2].map(|i: usize| on[i] + side * normal[i]));
                }
            }
        }
    }
    let range = |axis: usize| {
        let along = triangles.clone().flatten().map(|corner| corner[axis]);
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    };
    let ranges = [0, 1, 2].map(range);
    let mut part = [0.0_f64; 3];
    for _ in 0..most / 8 + 32 {
        // Steps by approximate irrational numbers: spread evenly.
        let steps = [0.819_172_513_396_164_4, 0.671_043_606_703_789_2, 0.549_700_477_901_961_3];
        part = [0, 1, 2].map(|i: usize| (part[i] + steps[i]).fract());
        points.push([0, 1, 2].map(|axis: usize| {
            let [low, high] = ranges[axis];
            low + (part[axis] * 1.2 - 0.1) * (high - low)
        }));
    }
    points.retain(|p| p.iter().all(|x| x.is_finite()));
    points
}
