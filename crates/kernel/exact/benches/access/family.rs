//! Point families of the benchmark, in which all small subsets are equally hard to decide.

use crate::common::{Random, nudge};

/// The distribution of a scene's points.
#[derive(Clone, Copy, PartialEq)]
pub enum Family {
    Uniform,
    Near,
    Mixed,
    LargeNear,
    Ties,
    Lattice,
    Mesh,
}

impl Family {
    pub const ALL: [(Family, &str); 7] = [
        (Family::Uniform, "uniform"),
        (Family::Near, "near"),
        (Family::Mixed, "mixed"),
        (Family::LargeNear, "large near"),
        (Family::Ties, "ties"),
        (Family::Lattice, "lattice"),
        (Family::Mesh, "mesh"),
    ];

    /// `count` points, on a circle or sphere if `round`, else on a line or plane.
    pub fn points<const D: usize>(self, random: &mut Random, count: usize, round: bool) -> Vec<[f64; D]> {
        if self == Family::Mesh {
            return height_field(random, count);
        }
        let circle = if self == Family::Ties && round { lattice_circle() } else { Vec::new() };
        let each = |_| match self {
            #[allow(clippy::cast_precision_loss)] // a small number
            Family::Lattice => std::array::from_fn(|_| random.below(16) as f64),
            Family::Mesh => unreachable!("points of a mesh depend on each other"),
            Family::Uniform => random.points::<1, D>(Random::unit)[0],
            Family::Near => surface(random, round).map(|x| nudged(random, x)),
            Family::LargeNear => surface(random, round).map(|x: f64| nudged(random, 1e6 * x)),
            Family::Mixed => random.points::<1, D>(|random| {
                let exponent = i32::try_from(random.below(81)).expect("small") - 40;
                (1.0 + random.unit()) * 2f64.powi(exponent)
            })[0],
            Family::Ties if round => {
                let [x, y] = *random.pick(&circle);
                let mut p = [0.0; D];
                (p[0], p[1]) = (x, y);
                p.rotate_right(random.below(D));
                p
            }
            Family::Ties => {
                #[allow(clippy::cast_precision_loss)] // 30 bits fit
                let mut p: [f64; D] = std::array::from_fn(|_| random.below(1 << 30) as f64);
                p[D - 1] = if D == 3 { 3.0 * p[0] + 5.0 * p[1] } else { 3.0 * p[0] };
                p
            }
        };
        (0..count).map(each).collect()
    }
}

impl Family {
    /// The vertices of a query of a scene with this many vertices: any, or neighbours in a mesh.
    pub fn query<const N: usize>(self, random: &mut Random, vertices: usize) -> [usize; N] {
        if self != Family::Mesh {
            return std::array::from_fn(|_| random.below(vertices));
        }
        let (width, first) = (width(vertices), random.below(vertices));
        let around = [0, 1, width, width + 1, 2, 2 * width, width + 2, 2 * width + 1];
        let turned = random.below(around.len());
        std::array::from_fn(|i| (first + around[(turned + 3 * i) % around.len()]) % vertices)
    }
}

fn width(vertices: usize) -> usize {
    vertices.isqrt().max(3)
}

/// A terrain over a jittered grid, row after row; in the plane, the grid alone.
///
/// The grid's vertices are moved by up to a third of its width.
fn height_field<const D: usize>(random: &mut Random, count: usize) -> Vec<[f64; D]> {
    let width = width(count);
    let each = |at: usize| {
        #[allow(clippy::cast_precision_loss)] // small numbers
        let [x, y] = [(at % width) as f64, (at / width) as f64].map(|x| x + random.unit() / 3.0);
        let z = (x / 50.0).sin() * (y / 70.0).cos() * 20.0 + random.unit() / 10.0;
        let mut p = [z; D];
        (p[0], p[1]) = (x, y);
        p
    };
    (0..count).map(each).collect()
}

/// A point of a circle or sphere, or of a line or plane, except for rounding.
fn surface<const D: usize>(random: &mut Random, round: bool) -> [f64; D] {
    let mut p: [f64; D] = random.points::<1, D>(Random::unit)[0];
    if round {
        let p = p.map(|x| x - 0.5);
        let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
        return p.map(|x| x / length);
    }
    p[D - 1] = 0.1 + p[..D - 1].iter().sum::<f64>() / 3.0;
    p
}

fn nudged(random: &mut Random, x: f64) -> f64 {
    let ulps = *random.pick(&[0, 0, 1, -1, 2, -2]);
    nudge(x, ulps)
}

/// The 540 integer points of the circle of radius 5²·13·17·29 about the origin.
fn lattice_circle() -> Vec<[f64; 2]> {
    const RADIUS: i64 = 5 * 5 * 13 * 17 * 29;
    let mut points = Vec::new();
    for x in -RADIUS..=RADIUS {
        let square = RADIUS * RADIUS - x * x;
        let y = square.isqrt();
        if y * y == square {
            #[allow(clippy::cast_precision_loss)] // 18 bits fit
            let [x, y] = [x as f64, y as f64];
            points.push([x, y]);
            if y != 0.0 {
                points.push([x, -y]);
            }
        }
    }
    assert_eq!(points.len(), 540);
    points
}
