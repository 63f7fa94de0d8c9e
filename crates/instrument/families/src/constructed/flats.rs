//! Lines and planes, each given by points of it.

use predicament_predicates::{Dimension, Question};

use crate::Random;
use crate::bits::{integer, power_of_two};

/// A point with coordinates in the family's own order: coordinates that the question uses come first. In the plane the
/// third one is 0.
pub(super) type Point = [f64; 3];
/// Two points of a line or three of a plane.
pub(super) type Flat = Vec<Point>;

/// The source of lines and planes.
pub(super) enum Source {
    /// Points uniform in the unit square or cube.
    Anywhere,
    /// Lines and planes through the rational point `numerator / denominator`, times [`UNIT`].
    Pencil { numerator: [i64; 3], denominator: i64 },
}

/// The exponent of the unit of a pencil's coordinates, which are integers below 2^48.
const UNIT: i64 = -48;
/// The magnitude of numerators, times the denominator.
const PLACE: i64 = 1 << 46;
/// The magnitude of direction components, times the denominator.
const DIRECTION: i64 = 1 << 15;
/// The maximum distance of a line's points, in directions.
const STEPS: i64 = 1 << 27;
/// The magnitude of the components of a plane's second direction.
const SECOND: i64 = 1 << 45;

impl Source {
    /// A pencil whose point can be a tie of this question.
    pub(super) fn pencil(question: Question, rng: &mut Random) -> Source {
        let denominator = 2 * rng.integer(0, 6) + 1;
        let mut numerator = [0; 3].map(|_| rng.integer(-PLACE, PLACE) * denominator + rng.integer(0, denominator - 1));
        if let Question::Compare(_) = question {
            // The compared coordinate must be a double, so that input vertices can share it.
            numerator[0] -= numerator[0].rem_euclid(denominator);
        }
        Source::Pencil { numerator, denominator }
    }

    /// A line from this source.
    pub(super) fn line(&self, dimension: Dimension, rng: &mut Random) -> Flat {
        match self {
            Source::Anywhere => (0..2).map(|_| anywhere(dimension, rng)).collect(),
            Source::Pencil { .. } => self.spanned(|w| w, None, dimension, rng),
        }
    }

    /// A hyperplane from this source: a line in the plane, a plane in space.
    pub(super) fn hyperplane(&self, dimension: Dimension, rng: &mut Random) -> Flat {
        match (self, dimension) {
            (_, Dimension::Two) => self.line(dimension, rng),
            (Source::Anywhere, Dimension::Three) => (0..3).map(|_| anywhere(dimension, rng)).collect(),
            (Source::Pencil { .. }, Dimension::Three) => {
                let second = [0; 3].map(|_| rng.nonzero(SECOND));
                self.spanned(|w| w, Some(second), dimension, rng)
            }
        }
    }

    /// A hyperplane whose points, and all points on it, are a tie in any query: with equal first coordinates for a
    /// comparison, over one line for a turn.
    pub(super) fn base(&self, question: Question, dimension: Dimension, rng: &mut Random) -> Flat {
        let mut base = match (self, question, dimension) {
            (Source::Pencil { .. }, Question::Compare(_), Dimension::Two) => {
                return self.spanned(|[_, y, z]| [0, y, z], None, dimension, rng);
            }
            (Source::Pencil { .. }, Question::Compare(_), Dimension::Three) => {
                let second = [0, rng.nonzero(SECOND), rng.nonzero(SECOND)];
                return self.spanned(|[_, y, z]| [0, y, z], Some(second), dimension, rng);
            }
            (Source::Pencil { .. }, Question::Orient2d(_), Dimension::Three) => {
                let second = [0, 0, rng.nonzero(SECOND)];
                return self.spanned(|w| w, Some(second), dimension, rng);
            }
            _ => self.hyperplane(dimension, rng),
        };
        let first = base[0];
        match (question, base.as_mut_slice()) {
            (Question::Compare(_), points) => points.iter_mut().for_each(|point| point[0] = first[0]),
            (Question::Orient2d(_), [_, _, third]) => (third[0], third[1]) = (first[0], first[1]),
            _ => {}
        }
        base
    }

    /// Points of a pencil's line with a direction that `restrict` finally adjusts, or of a plane with a second
    /// direction.
    ///
    /// If w ≡ −N modulo d, the point a = (N + w)/d is integer, and N/d is the point a − w/d of every line through a
    /// along w.
    fn spanned(
        &self,
        restrict: impl Fn([i64; 3]) -> [i64; 3],
        second: Option<[i64; 3]>,
        dimension: Dimension,
        rng: &mut Random,
    ) -> Flat {
        let Source::Pencil { numerator, denominator } = self else { unreachable!("points anywhere have no lattice") };
        let w = restrict(numerator.map(|n| rng.nonzero(DIRECTION) * denominator - n.rem_euclid(*denominator)));
        let first = rng.nonzero(STEPS);
        let other = loop {
            let other = rng.nonzero(STEPS);
            if other != first {
                break other;
            }
        };
        let at = |steps: i64, second: [i64; 3]| -> Point {
            std::array::from_fn(|i| {
                if i == dimension.count() {
                    return 0.0;
                }
                let a = (numerator[i] + w[i]) / denominator;
                integer(a + steps * w[i] + second[i]) * power_of_two(UNIT)
            })
        };
        let mut points = vec![at(first, [0; 3]), at(other, [0; 3])];
        points.extend(second.map(|second| at(0, second)));
        points
    }
}

fn anywhere(dimension: Dimension, rng: &mut Random) -> Point {
    let [x, y] = [rng.unit(), rng.unit()];
    [x, y, if dimension == Dimension::Three { rng.unit() } else { 0.0 }]
}

/// True if these meet in one point with a wide margin: the weight of the point, relative to the differences that it is
/// a product of, is at least 2^-20. Rounding makes less than 2^-40 of that, so the weight is not zero either.
pub(super) fn meet(dimension: Dimension, flats: &[&[Point]]) -> bool {
    let differences = |flat: &[Point]| -> Vec<Point> { flat[1..].iter().map(|&p| minus(p, flat[0])).collect() };
    let spans: Vec<Vec<Point>> = flats.iter().map(|flat| differences(flat)).collect();
    let normal = |span: &[Point]| match *span {
        [u] => [-u[1], u[0], 0.0],
        [u, v] => cross(u, v),
        _ => unreachable!("two or three points"),
    };
    let weight = match (dimension, spans.as_slice()) {
        (Dimension::Two, [first, second]) => dot(normal(first), second[0]),
        (Dimension::Three, [line, plane]) => dot(normal(plane), line[0]),
        (Dimension::Three, [l, m, n]) => dot(normal(l), cross(normal(m), normal(n))),
        _ => unreachable!("two or three lines and planes"),
    };
    let size: f64 = spans.iter().flatten().map(|u| u.iter().fold(0.0_f64, |most, x| most.max(x.abs()))).product();
    weight.abs() > power_of_two(-20) * size
}

fn minus(p: Point, q: Point) -> Point {
    std::array::from_fn(|i| p[i] - q[i])
}

fn cross(p: Point, q: Point) -> Point {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

fn dot(p: Point, q: Point) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}
