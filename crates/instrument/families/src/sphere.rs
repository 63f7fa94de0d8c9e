//! Directions on the unit sphere, rounded to doubles, in the positions that algorithms on the sphere get wrong.

use crate::Random;
use crate::bits::{integer, power_of_two, step};

/// The position of three directions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Directions {
    /// Random directions.
    General,
    /// Three directions exactly on a great circle.
    GreatCircle,
    /// A direction, its antipode or a neighbour of the antipode, and any other direction.
    Antipodal,
    /// Two directions and the rounded midpoint of the edge between them.
    Midpoint,
    /// Three directions a few ulps apart.
    Close,
}

impl Directions {
    /// All positions.
    pub const ALL: [Directions; 5] =
        [Directions::General, Directions::GreatCircle, Directions::Antipodal, Directions::Midpoint, Directions::Close];

    /// The position's name in suites.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Directions::General => "general",
            Directions::GreatCircle => "great-circle",
            Directions::Antipodal => "antipodal",
            Directions::Midpoint => "midpoint",
            Directions::Close => "close",
        }
    }

    /// The position with this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Directions> {
        Directions::ALL.into_iter().find(|directions| directions.name() == name)
    }

    /// Three directions in random order; their lengths are 1 up to roundings.
    pub fn query(self, rng: &mut Random, out: &mut Vec<f64>) {
        let (a, b) = (direction(rng), direction(rng));
        let mut three = match self {
            Directions::General => [a, b, direction(rng)],
            Directions::GreatCircle => on_great_circle(rng),
            Directions::Antipodal if rng.one_in(2) => [a, a.map(|x| -x), b],
            Directions::Antipodal => [a, moved(a.map(|x| -x), rng), b],
            Directions::Midpoint => [a, normalized([a[0] + b[0], a[1] + b[1], a[2] + b[2]]), b],
            Directions::Close => [a, moved(a, rng), moved(a, rng)],
        };
        rng.shuffle(&mut three);
        out.extend(three.as_flattened());
    }
}

/// A random direction.
fn direction(rng: &mut Random) -> [f64; 3] {
    loop {
        let of_cube: [f64; 3] = std::array::from_fn(|_| rng.between(-1.0, 1.0));
        let square: f64 = of_cube.iter().map(|x| x * x).sum();
        if (0.25..1.0).contains(&square) {
            return normalized(of_cube);
        }
    }
}

fn normalized([x, y, z]: [f64; 3]) -> [f64; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

/// Each coordinate moved by at most 4 ulps.
fn moved(point: [f64; 3], rng: &mut Random) -> [f64; 3] {
    point.map(|x| step(x, rng.integer(-4, 4)))
}

/// Three directions in a plane through the origin whose normal has small integers, one of them 1.
///
/// Two coordinates are multiples of 2^-50, so the third is one as well, without rounding.
fn on_great_circle(rng: &mut Random) -> [[f64; 3]; 3] {
    let [m, n] = [0; 2].map(|_| integer(rng.integer(-3, 3)));
    let axis = usize::try_from(rng.integer(0, 2)).unwrap_or(0);
    std::array::from_fn(|_| {
        let [u, v, _] = direction(rng);
        let [x, y, _] = normalized([u, v, m * u + n * v]).map(|x| (x * power_of_two(50)).round() * power_of_two(-50));
        let mut point = [x, y, m * x + n * y];
        point.rotate_right(axis);
        point
    })
}
