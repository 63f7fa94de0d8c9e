//! Small scenes full of ties.

use predicament_corpus::Random;
use predicament_predicates::{Dimension, Scene};

/// A kind of scene, in the plane and in space.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Family {
    /// A whole small grid in random order, with one point twice: 3 × 3, or the corners and the centre of a cube.
    Exhaustive,
    /// Points of a grid of four (three in space) values, many of them repeated.
    Grid,
    /// Integers up to 50, few ties.
    Integers,
    /// Points on one line or two, in space also on a plane.
    Lines,
    /// Integer points on one circle or sphere.
    Circle,
    /// A small grid 2^40 from the origin.
    Far,
    /// Powers of two from 2^-40 to 2^40, both signs, and zero.
    Mixed,
}

/// The number of vertices of a scene.
const POINTS: usize = 12;

impl Family {
    /// The families whose scenes are drawn at random.
    pub const RANDOM: [Family; 6] =
        [Family::Grid, Family::Integers, Family::Lines, Family::Circle, Family::Far, Family::Mixed];

    /// The family's name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Family::Exhaustive => "exhaustive",
            Family::Grid => "grid",
            Family::Integers => "integers",
            Family::Lines => "lines",
            Family::Circle => "circle",
            Family::Far => "far",
            Family::Mixed => "mixed",
        }
    }

    /// The scene with this number, and the random stream for its tuples.
    ///
    /// # Panics
    /// Never: all coordinates are finite.
    #[must_use]
    pub fn scene(self, dimension: Dimension, number: u64, seed: u64) -> (Scene, Random) {
        let d = dimension.count();
        let mut random = Random::new(&format!("laws/{}/{number}", self.name()), &format!("{d}"), seed);
        let points = self.points(d, number, &mut random);
        let coordinates = points.into_iter().flatten().collect();
        (Scene::new(dimension, coordinates).expect("whole points with finite coordinates"), random)
    }

    fn points(self, d: usize, number: u64, random: &mut Random) -> Vec<Vec<f64>> {
        let most = if d == 2 { 3 } else { 2 };
        match self {
            Family::Exhaustive => {
                let mut points = if d == 2 {
                    lattice(2, 1, |_| true)
                } else {
                    lattice(3, 1, |p| p.iter().all(|x| *x != 0.0) || p == [0.0; 3])
                };
                let twice = points[place(random, points.len())].clone();
                points.push(twice);
                if number > 0 {
                    shuffle(&mut points, random);
                }
                points
            }
            Family::Grid => draw(|| (0..d).map(|_| integer(random, 0, most)).collect()),
            Family::Integers => draw(|| (0..d).map(|_| integer(random, -50, 50)).collect()),
            Family::Lines => lines(d, random),
            Family::Circle => {
                let square = if d == 2 { [25.0, 65.0][place(random, 2)] } else { 9.0 };
                let all = lattice(d, 8, |p| p.iter().map(|x| x * x).sum::<f64>() == square);
                draw(|| all[place(random, all.len())].clone())
            }
            Family::Far => {
                let base: Vec<f64> = (0..d).map(|_| 2.0_f64.powi(40) * integer(random, -1, 1)).collect();
                draw(|| base.iter().map(|x| x + integer(random, 0, most)).collect())
            }
            Family::Mixed => {
                let values: Vec<f64> =
                    (0..4).map(|_| 2.0_f64.powi(exponent(random)) * integer(random, -1, 1)).collect();
                draw(|| (0..d).map(|_| values[place(random, values.len())]).collect())
            }
        }
    }
}

fn draw(point: impl FnMut() -> Vec<f64>) -> Vec<Vec<f64>> {
    std::iter::repeat_with(point).take(POINTS).collect()
}

/// Points at small steps from one of two points in one of two directions.
fn lines(d: usize, random: &mut Random) -> Vec<Vec<f64>> {
    let mut vector = || (0..d).map(|_| integer(random, -2, 2)).collect::<Vec<f64>>();
    let [origin, other, u, v] = std::array::from_fn(|_| vector());
    draw(|| {
        let from = if random.one_in(4) { &other } else { &origin };
        let [s, t] = [integer(random, -2, 2), if random.one_in(2) { integer(random, -1, 1) } else { 0.0 }];
        (0..d).map(|axis| from[axis] + s * u[axis] + t * v[axis]).collect()
    })
}

/// All points with coordinates from −most to most that `wanted` accepts.
fn lattice(d: usize, most: i32, wanted: impl Fn(&[f64]) -> bool) -> Vec<Vec<f64>> {
    let mut all: Vec<Vec<f64>> = vec![Vec::new()];
    for _ in 0..d {
        let longer = |point: &Vec<f64>| (-most..=most).map(|x| [point.as_slice(), &[f64::from(x)]].concat()).collect();
        all = all.iter().flat_map::<Vec<_>, _>(longer).collect();
    }
    all.retain(|point| wanted(point));
    all
}

#[allow(clippy::cast_precision_loss)] // small integers
fn integer(random: &mut Random, low: i64, high: i64) -> f64 {
    random.integer(low, high) as f64
}

fn exponent(random: &mut Random) -> i32 {
    i32::try_from(random.integer(-40, 40)).unwrap_or_default()
}

/// A random index below `n`.
pub(super) fn place(random: &mut Random, n: usize) -> usize {
    let last = i64::try_from(n).unwrap_or(i64::MAX) - 1;
    usize::try_from(random.integer(0, last)).unwrap_or_default()
}

fn shuffle<T>(items: &mut [T], random: &mut Random) {
    for last in (1..items.len()).rev() {
        items.swap(last, place(random, last + 1));
    }
}
