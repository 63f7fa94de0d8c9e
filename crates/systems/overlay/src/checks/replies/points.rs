//! Points at which results are tested. Any point is right; these find narrow parts and wrong sides of edges.

type Double = [f64; 2];

/// The distances of points beside edges: in units of the tested distance, then of the largest distance of rounding.
const BESIDE: ([f64; 3], [f64; 2]) = ([2.0, 64.0, 65_536.0], [4.0, 1024.0]);

/// Points between and beside edges. With `cells`, a point between any two neighbouring edges at each height between the
/// heights of ends and crossings; always points beside edges and in the box of all edges.
pub(super) fn candidates(edges: &[[Double; 2]], within: [f64; 2], cells: bool, most: usize) -> Vec<Double> {
    let mut points = Vec::new();
    if cells {
        between(edges, &mut points);
    }
    beside(edges, within, most, &mut points);
    anywhere(edges, most / 8 + 32, &mut points);
    points.retain(|p| p.iter().all(|x| x.is_finite()));
    points
}

/// The middle of each cell: a strip between two heights, between two edges.
fn between(edges: &[[Double; 2]], points: &mut Vec<Double>) {
    let mut heights: Vec<f64> = edges.as_flattened().iter().map(|end| end[1]).collect();
    for (at, one) in edges.iter().enumerate() {
        heights.extend(edges[..at].iter().filter_map(|other| height_of_crossing(*one, *other)));
    }
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    for strip in heights.windows(2) {
        let y = strip[0] / 2.0 + strip[1] / 2.0;
        let mut at: Vec<f64> = edges
            .iter()
            .filter(|[a, b]| (a[1] < y) != (b[1] < y))
            .map(|[a, b]| a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
            .collect();
        at.sort_by(f64::total_cmp);
        points.extend(at.windows(2).map(|pair| [pair[0] / 2.0 + pair[1] / 2.0, y]));
    }
}

/// The height at which two edges cross, approximately.
fn height_of_crossing([a, b]: [Double; 2], [c, d]: [Double; 2]) -> Option<f64> {
    let [u, v, w] = [[b, a], [d, c], [c, a]].map(|[p, q]| [p[0] - q[0], p[1] - q[1]]);
    let cross = |[x, y]: Double, [z, w]: Double| x * w - y * z;
    let determinant = cross(u, v);
    let [t, s] = [cross(w, v) / determinant, cross(w, u) / determinant];
    ((0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&s)).then(|| a[1] + t * u[1])
}

/// Points on both sides of edges, at several distances and places.
fn beside(edges: &[[Double; 2]], [within, coarsest]: [f64; 2], most: usize, points: &mut Vec<Double>) {
    let step = (edges.len() * 30).div_ceil(most.max(1)).max(1);
    for [a, b] in edges.iter().step_by(step) {
        let along = [b[0] - a[0], b[1] - a[1]];
        let length = along[0].hypot(along[1]);
        for part in [0.5, 0.117, 0.809] {
            let near = BESIDE.0.iter().map(|units| units * within);
            for distance in near.chain(BESIDE.1.iter().map(|units| units * coarsest)) {
                let off = distance / length;
                for side in [off, -off] {
                    points.push([a[0] + part * along[0] - side * along[1], a[1] + part * along[1] + side * along[0]]);
                }
            }
        }
    }
}

/// Points spread over the box of all edges, and a little around it.
fn anywhere(edges: &[[Double; 2]], count: usize, points: &mut Vec<Double>) {
    let range = |axis: usize| {
        let along = edges.as_flattened().iter().map(|end| end[axis]);
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    };
    let ranges = [0, 1].map(range);
    let mut part = [0.0_f64; 2];
    for _ in 0..count {
        // Steps by approximate irrational numbers: spread evenly.
        part = [(part[0] + 0.754_877_666_246_692_8).fract(), (part[1] + 0.569_840_290_998_053_2).fract()];
        points.push([0, 1].map(|axis: usize| {
            let [low, high] = ranges[axis];
            low + (part[axis] * 1.2 - 0.1) * (high - low)
        }));
    }
}
