//! Queries about numbers as people write them: decimals with few digits, exactly on a figure or one step beside it.
//!
//! Points are integers times one step. They are exact in decimals, and most of their doubles are other points. Half of
//! the queries are ties of the decimals; in the others, the last point is moved by one step along one axis.
//!
//! Neighbours are boxes (in the plane, parcels) that share a part of a side in decimals, corners on sides included.

use predicament_predicates::PredicateKind;

use crate::{Random, native};

/// The most digits behind the point.
pub const MOST_DIGITS: u32 = 12;

/// The figure that the points of a query are on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Figure {
    /// A line, plane, circle or sphere in general position.
    General,
    /// A rectangle or box, turned by an angle whose sine is rational.
    Rectangle,
    /// A grid along the axes.
    Grid,
}

/// The source of the coordinates: their distance from the origin, and their step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Place {
    /// Metres near the origin.
    Metres,
    /// Longitude and latitude in degrees.
    Degrees,
    /// Eastings and northings of a survey in metres, far from the origin.
    Survey,
    /// Millimetres near the origin, converted from fractions of an inch: halves of halves, as many as there are digits.
    Inches,
}

/// One kind of decimals.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Typed {
    /// The number of digits behind the point, at most [`MOST_DIGITS`].
    pub digits: u32,
    /// The figure that the points are on.
    pub figure: Figure,
    /// The source of the coordinates.
    pub place: Place,
}

/// Gives a type names for its values.
macro_rules! named {
    ($type:ident { $($value:ident = $name:literal),+ $(,)? }) => {
        impl $type {
            /// All values.
            pub const ALL: &[$type] = &[$($type::$value),+];

            /// The value's name in suites and tables.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $($type::$value => $name),+
                }
            }

            /// The value with this name.
            #[must_use]
            pub fn named(name: &str) -> Option<$type> {
                $type::ALL.iter().copied().find(|value| value.name() == name)
            }
        }
    };
}

named!(Figure { General = "general", Rectangle = "rectangle", Grid = "grid" });
named!(Place { Metres = "metres", Degrees = "degrees", Survey = "survey", Inches = "inches" });

impl Place {
    /// The centre of the coordinates, in whole units.
    const fn centre(self) -> [i128; 3] {
        match self {
            Place::Metres | Place::Inches => [0; 3],
            Place::Degrees => [13, 52, 0],
            Place::Survey => [455_000, 5_413_000, 300],
        }
    }
}

impl Typed {
    /// The predicates that have such queries.
    pub const KINDS: &[PredicateKind] =
        &[PredicateKind::Orient2d, PredicateKind::Orient3d, PredicateKind::Incircle, PredicateKind::Insphere];

    /// The distance of neighbouring points, in units of the last digit.
    fn step(self) -> i128 {
        match self.place {
            // 25.4 millimetres, halved once for each digit after the first: 254·5^(d−1) units of 10^−d.
            Place::Inches => 254 * 5_i128.pow(self.digits.saturating_sub(1)),
            Place::Metres | Place::Degrees | Place::Survey => 1,
        }
    }

    /// The size of a figure in steps: about ten units, and enough for a figure if there are few digits.
    fn size(self) -> i64 {
        let one = match self.place {
            Place::Inches => 1 << self.digits.saturating_sub(1),
            Place::Metres | Place::Degrees | Place::Survey => 10_i64.pow(self.digits),
        };
        (10 * one).max(60)
    }

    /// Appends the coordinates of one query, in units of the last digit.
    ///
    /// # Panics
    /// For a predicate without such queries, or for more than [`MOST_DIGITS`] digits.
    pub fn query(self, kind: PredicateKind, rng: &mut Random, out: &mut Vec<i128>) {
        assert!(self.digits <= MOST_DIGITS, "{} digits", self.digits);
        let mut points = match (kind, self.figure) {
            (PredicateKind::Orient2d, Figure::General) => line(self.size(), rng),
            (PredicateKind::Orient3d, Figure::General) => plane(self.size(), rng),
            (PredicateKind::Incircle, Figure::General) => round::<2>(4, 65, self.size(), rng),
            (PredicateKind::Insphere, Figure::General) => round::<3>(5, 15, self.size(), rng),
            (_, Figure::Rectangle) => corners(kind, turned(rng), self.size(), rng),
            (_, Figure::Grid) => corners(kind, [[1, 0, 0], [0, 1, 0], [0, 0, 1]], self.size(), rng),
            _ => panic!("{kind} has no decimals"),
        };
        let dimension = native(kind);
        if rng.one_in(2) {
            let last = points.len() - dimension;
            let axis = usize::try_from(rng.integer(0, dimension as i64 - 1)).unwrap_or(0);
            points[last + axis] += rng.nonzero(1);
        }
        let (step, one) = (self.step(), 10_i128.pow(self.digits));
        let centre = self.place.centre();
        out.extend(points.iter().enumerate().map(|(at, &x)| centre[at % dimension] * one + i128::from(x) * step));
    }
}

/// Two boxes in `D` dimensions that share a part of a side, each by its 2^D corners in units of the last digit.
///
/// The bits of a corner's index say at which end of the box it is, along each direction.
pub type Neighbours<const D: usize> = [Vec<[i128; D]>; 2];

impl Typed {
    /// Pairs of neighbours in a row, without common points of different pairs. The directions of a box are those of the
    /// figure, and turn counterclockwise.
    ///
    /// # Panics
    /// For more than [`MOST_DIGITS`] digits.
    #[must_use]
    pub fn neighbours<const D: usize>(self, pairs: usize, rng: &mut Random) -> Vec<Neighbours<D>> {
        assert!(self.digits <= MOST_DIGITS, "{} digits", self.digits);
        let (step, one, centre) = (self.step(), 10_i128.pow(self.digits), self.place.centre());
        let gap = 8 * i128::from(self.size());
        let pair = |at: i128| -> Neighbours<D> {
            let along = match self.figure {
                Figure::General => skew::<D>(rng),
                Figure::Rectangle => turned(rng),
                Figure::Grid => [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
            };
            let from: [i64; D] = origin(self.size(), rng);
            let longest = (self.size() / 60).max(2);
            let mut length = || rng.integer(1, longest);
            let first: [[i64; 2]; 3] = std::array::from_fn(|_| [0, length()]);
            // The second box begins where the first ends; its other sides overlap those of the first.
            let second: [[i64; 2]; 3] = std::array::from_fn(|axis| {
                let [_, end] = first[axis];
                let low = if axis == 0 { end } else { end - length() };
                [low, end + length()]
            });
            [first, second].map(|ranges| {
                let corner = |bits: usize| -> [i128; D] {
                    std::array::from_fn(|i| {
                        let reach: i64 = (0..D).map(|axis| ranges[axis][bits >> axis & 1] * along[axis][i]).sum();
                        let row = if i == 0 { at * gap } else { 0 };
                        centre[i] * one + (i128::from(from[i] + reach) + row) * step
                    })
                };
                (0..1 << D).map(corner).collect()
            })
        };
        (0..).take(pairs).map(pair).collect()
    }
}

/// Independent directions of small integers, which turn counterclockwise.
fn skew<const D: usize>(rng: &mut Random) -> [[i64; 3]; 3] {
    loop {
        let mut along: [[i64; 3]; 3] = std::array::from_fn(|_| std::array::from_fn(|_| rng.nonzero(25)));
        if D == 2 {
            along[2] = [0, 0, 1];
        }
        let [u, v, w] = along;
        let minor = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
        if minor(1, 2) * w[0] + minor(2, 0) * w[1] + minor(0, 1) * w[2] > 0 {
            return along;
        }
    }
}

/// A point of a cube of this size.
fn origin<const D: usize>(size: i64, rng: &mut Random) -> [i64; D] {
    std::array::from_fn(|_| rng.integer(-size, size))
}

/// Two different multiples, from 1 to 4.
fn multiples(rng: &mut Random) -> [i64; 2] {
    let first = rng.integer(1, 4);
    let second = rng.integer(1, 3);
    [first, if second < first { second } else { second + 1 }]
}

/// Three points of a line.
fn line(size: i64, rng: &mut Random) -> Vec<i64> {
    let from: [i64; 2] = origin(size, rng);
    let along: [i64; 2] = std::array::from_fn(|_| rng.nonzero(size / 4));
    let [first, second] = multiples(rng);
    [0, first, second].iter().flat_map(|k| [0, 1].map(|i| from[i] + k * along[i])).collect()
}

/// Four points of a plane.
fn plane(size: i64, rng: &mut Random) -> Vec<i64> {
    let from: [i64; 3] = origin(size, rng);
    let [u, v]: [[i64; 3]; 2] = std::array::from_fn(|_| std::array::from_fn(|_| rng.nonzero(size / 4)));
    let [j, k] = multiples(rng);
    [[0, 0], [1, 0], [0, 1], [j, k]]
        .iter()
        .flat_map(|[j, k]| [0, 1, 2].map(|i| from[i] + j * u[i] + k * v[i]))
        .collect()
}

/// Distinct points of a circle or sphere: integer points of one of this radius, scaled.
fn round<const D: usize>(count: usize, radius: i64, size: i64, rng: &mut Random) -> Vec<i64> {
    let mut found: Vec<[i64; D]> = Vec::new();
    while found.len() < count {
        let mut point: [i64; D] = std::array::from_fn(|_| rng.integer(-radius, radius));
        // The last coordinate follows from the others, if it is an integer.
        let rest = radius * radius - point[..D - 1].iter().map(|x| x * x).sum::<i64>();
        let root = if rest < 0 { continue } else { rest.isqrt() };
        point[D - 1] = if point[D - 1] < 0 { -root } else { root };
        if root * root == rest && !found.contains(&point) {
            found.push(point);
        }
    }
    let centre: [i64; D] = origin(size, rng);
    let scale = rng.integer(1, (size / radius).max(1));
    found.iter().flat_map(|point| -> [i64; D] { std::array::from_fn(|i| centre[i] + scale * point[i]) }).collect()
}

/// Three orthogonal vectors of equal length: the axes turned about the third by an angle of rational sine.
fn turned(rng: &mut Random) -> [[i64; 3]; 3] {
    const TRIPLES: [[i64; 3]; 4] = [[4, 3, 5], [12, 5, 13], [15, 8, 17], [24, 7, 25]];
    let [c, s, length] = TRIPLES[usize::try_from(rng.integer(0, 3)).unwrap_or(0)];
    [[c, s, 0], [-s, c, 0], [0, 0, length]]
}

/// Corners of a rectangle or box along three directions; for orientations the last point is on a side of it.
fn corners(kind: PredicateKind, [u, v, w]: [[i64; 3]; 3], size: i64, rng: &mut Random) -> Vec<i64> {
    let from: [i64; 3] = origin(size, rng);
    let longest = (size / 60).max(2);
    let [a, b, c]: [i64; 3] = std::array::from_fn(|_| rng.integer(1, longest));
    let places: &[[i64; 3]] = &match kind {
        PredicateKind::Orient2d => [[0, 0, 0], [2 * a, 0, 0], [a, 0, 0], [0; 3], [0; 3]],
        PredicateKind::Orient3d => [[0, 0, 0], [a, 0, 0], [0, 0, c], [2 * a, 0, 3 * c], [0; 3]],
        PredicateKind::Incircle => [[0, 0, 0], [a, 0, 0], [a, b, 0], [0, b, 0], [0; 3]],
        _ => [[0, 0, 0], [a, 0, 0], [0, b, 0], [0, 0, c], [a, b, c]],
    }[..kind.arity()];
    let dimension = native(kind);
    let point =
        |[j, k, l]: &[i64; 3]| (0..dimension).map(|i| from[i] + j * u[i] + k * v[i] + l * w[i]).collect::<Vec<_>>();
    places.iter().flat_map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn orient2d(p: &[i128]) -> i128 {
        (p[0] - p[4]) * (p[3] - p[5]) - (p[1] - p[5]) * (p[2] - p[4])
    }

    #[test]
    fn half_of_the_queries_are_ties_and_all_are_of_the_place() {
        for &place in Place::ALL {
            for &figure in Figure::ALL {
                for digits in [0, 1, 2, MOST_DIGITS] {
                    let typed = Typed { digits, figure, place };
                    let mut rng = Random::new("decimals", "test", 0);
                    let mut out = Vec::new();
                    (0..200).for_each(|_| typed.query(PredicateKind::Orient2d, &mut rng, &mut out));
                    let ties = out.chunks(6).filter(|query| orient2d(query) == 0).count();
                    // On a grid the side is along an axis, and half of the moves are along it.
                    assert!((70..180).contains(&ties), "{typed:?}: {ties}");
                    let step = typed.step();
                    let centre = |at: usize| place.centre()[at % 2] * 10_i128.pow(digits);
                    assert!(out.iter().enumerate().all(|(at, x)| (x - centre(at)) % step == 0), "{typed:?}");
                }
            }
        }
    }

    /// The second box begins on a side of the first, and reaches beyond one of its corners; no two pairs meet.
    #[test]
    fn neighbours_share_a_part_of_a_side() {
        for &figure in Figure::ALL {
            for digits in [0, 3, MOST_DIGITS] {
                let typed = Typed { digits, figure, place: Place::Survey };
                let pairs = typed.neighbours::<2>(20, &mut Random::new("decimals", "test", 0));
                let widest = |pair: &Neighbours<2>| {
                    let along = || pair.iter().flatten().map(|corner| corner[0]);
                    [along().min().unwrap(), along().max().unwrap()]
                };
                assert!(pairs.windows(2).all(|two| widest(&two[0])[1] < widest(&two[1])[0]), "{typed:?}");
                for [first, second] in &pairs {
                    let side = |p: [i128; 2], q: [i128; 2], r: [i128; 2]| orient2d(&[p, q, r].concat());
                    assert!(side(first[0], first[1], first[2]) > 0 && side(second[0], second[1], second[2]) > 0);
                    // The side at the far end of the first direction; the corners of the second box on its line.
                    let [from, to] = [first[1], first[3]];
                    let on = [second[0], second[2]];
                    assert!(on.iter().all(|&corner| side(from, to, corner) == 0), "{typed:?}");
                    let before = |p: [i128; 2], q: [i128; 2]| {
                        (0..2).map(|i| (to[i] - from[i]) * (q[i] - p[i])).sum::<i128>() > 0
                    };
                    assert!(before(on[0], to) && before(from, on[1]), "{typed:?}");
                }
            }
        }
    }

    #[test]
    fn names_are_read_back() {
        assert!(Place::ALL.iter().all(|&place| Place::named(place.name()) == Some(place)));
        assert_eq!(Figure::named("round"), None);
    }
}
