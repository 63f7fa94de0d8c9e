//! Vertices as integers over a common weight, by joins and meets.
//!
//! In homogeneous coordinates the line through two points of the plane, and the intersection of two lines, are cross
//! products. One dimension higher, so are the plane through three points and the intersection of three planes. A line
//! meets a plane where the combination of its two points lies on the plane. No formula here subtracts one point from
//! another, which makes this independent of all computations that do.

use predicament_arithmetic::Parts;
use predicament_predicates::{Construction, NoPoint, Scene, Vertex};
use rug::Integer;

use predicament_formats::bits::lowest_bit;

/// The exact coordinates of a vertex times its weight, and the weight, which is positive; `None` for a construction
/// that gives no point.
///
/// # Panics
/// If the scene has no such vertex.
#[must_use]
pub fn homogeneous(scene: &Scene, v: Vertex) -> Option<Vec<Integer>> {
    match v.construction() {
        None => Some(input(scene, v)),
        Some(index) => meet(scene, &scene.constructions()[index]).ok(),
    }
}

/// [`homogeneous`] for a construction from vertices of the scene.
///
/// # Errors
/// The reason why the construction gives no point.
pub fn meet(scene: &Scene, construction: &Construction) -> Result<Vec<Integer>, NoPoint> {
    let span = |flat: &[Vertex]| -> Vec<Vec<Integer>> { flat.iter().map(|&v| input(scene, v)).collect() };
    let line = |flat: &[Vertex]| hyperplane(&span(flat)).ok_or(NoPoint::SegmentEnds);
    let plane = |flat: &[Vertex]| hyperplane(&span(flat)).ok_or(NoPoint::CollinearPlane);
    let (point, parallel) = match construction {
        Construction::Ssi([first, second]) => (cross(&[line(first)?, line(second)?]), NoPoint::ParallelLines),
        Construction::Lpi { line: ends, plane: flat } => {
            let (plane, ends) = (plane(flat)?, span(ends));
            let [p, q] = [&ends[0], &ends[1]];
            let [at_p, at_q] = [dot(&plane, p), dot(&plane, q)];
            let point = p.iter().zip(q).map(|(p, q)| Integer::from(&at_q * p) - Integer::from(&at_p * q)).collect();
            if ends_coincide(p, q) {
                return Err(NoPoint::LineEnds);
            }
            (point, NoPoint::ParallelToPlane)
        }
        Construction::Tpi([first, second, third]) => {
            (cross(&[plane(first)?, plane(second)?, plane(third)?]), NoPoint::Planes)
        }
        Construction::Ratio { ends, share } => {
            // The weights of both ends count, and so does that of the share.
            let (ends, [of_a, of_c]) = (span(ends), [share.fraction()[0], share.rest().fraction()[0]]);
            let last = ends[0].len() - 1;
            let [v, w] = [Integer::from(&ends[0][last] * of_c), Integer::from(&ends[1][last] * of_a)];
            let part = |(a, c): (&Integer, &Integer)| Integer::from(a * &w) + Integer::from(c * &v);
            (ends[0].iter().zip(&ends[1]).map(part).collect(), NoPoint::Unspecified)
        }
    };
    positive(point).ok_or(parallel)
}

/// The coordinates of an input vertex times a power of two, and that power.
fn input(scene: &Scene, v: Vertex) -> Vec<Integer> {
    let point = scene.point(v);
    let lowest = lowest_exponent(point.iter().copied()).min(0);
    let weight = Integer::from(1) << u32::try_from(-lowest).expect("not positive");
    point.iter().map(|&x| integer(x, lowest)).chain([weight]).collect()
}

/// The exponent of the lowest bit of any of these doubles; 0 if all are zero.
#[must_use]
pub fn lowest_exponent(values: impl Iterator<Item = f64>) -> i64 {
    values.filter_map(lowest_bit).min().unwrap_or(0)
}

/// The integer x·2^-lowest, for a double without bits below 2^lowest.
///
/// # Panics
/// If x has bits below 2^lowest.
#[must_use]
pub fn integer(x: f64, lowest: i64) -> Integer {
    let Parts { negative, significand, exponent } = Parts::of(x).expect("coordinates are finite").odd();
    if significand == 0 {
        return Integer::new();
    }
    let shift = u32::try_from(i64::from(exponent) - lowest).expect("the lowest is the least");
    let magnitude = Integer::from(significand) << shift;
    if negative { -magnitude } else { magnitude }
}

/// The line through two points or the plane through three; `None` if the points do not span it.
fn hyperplane(points: &[Vec<Integer>]) -> Option<Vec<Integer>> {
    let flat = cross(points);
    // The normal vanishes exactly for points that do not span a line or plane.
    let normal = &flat[..flat.len() - 1];
    normal.iter().any(|x| !x.is_zero()).then_some(flat)
}

/// The vector that is orthogonal to all rows; there is one row fewer than coordinates.
fn cross(rows: &[Vec<Integer>]) -> Vec<Integer> {
    (0..=rows.len())
        .map(|left_out| {
            let columns: Vec<usize> = (0..=rows.len()).filter(|&column| column != left_out).collect();
            let minor = determinant(rows, &columns);
            if left_out % 2 == 0 { minor } else { -minor }
        })
        .collect()
}

fn determinant(rows: &[Vec<Integer>], columns: &[usize]) -> Integer {
    let Some((first, rest)) = rows.split_first() else { return Integer::from(1) };
    let mut sum = Integer::new();
    for (at, &column) in columns.iter().enumerate() {
        let others: Vec<usize> = columns.iter().copied().filter(|&other| other != column).collect();
        let term = determinant(rest, &others) * &first[column];
        if at % 2 == 0 { sum += term } else { sum -= term }
    }
    sum
}

fn dot(a: &[Integer], b: &[Integer]) -> Integer {
    a.iter().zip(b).map(|(a, b)| Integer::from(a * b)).sum()
}

fn ends_coincide(p: &[Integer], q: &[Integer]) -> bool {
    let (at_p, at_q) = (&p[p.len() - 1], &q[q.len() - 1]);
    p.iter().zip(q).all(|(p, q)| Integer::from(p * at_q) == Integer::from(q * at_p))
}

/// The point with a positive weight; `None` for a point at infinity.
fn positive(point: Vec<Integer>) -> Option<Vec<Integer>> {
    match point.last()?.cmp0() {
        std::cmp::Ordering::Greater => Some(point),
        std::cmp::Ordering::Equal => None,
        std::cmp::Ordering::Less => Some(point.into_iter().map(|x| -x).collect()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Rational;

    fn v<const N: usize>(indices: [usize; N]) -> [Vertex; N] {
        indices.map(Vertex::input)
    }

    fn point(scene: &Scene, construction: Construction) -> Result<Vec<Rational>, NoPoint> {
        meet(scene, &construction).map(|row| {
            let (weight, entries) = row.split_last().unwrap();
            assert!(weight.cmp0().is_gt());
            entries.iter().map(|x| Rational::from((x.clone(), weight.clone()))).collect()
        })
    }

    #[test]
    fn known_meeting_points() {
        // Points of different exponents, so that their weights differ.
        let plane = Scene::from_points2(&[[0.0, 0.0], [3.0, 3.0], [0.0, 0.5], [1e300, 0.5], [-0.0, -7.0]]).unwrap();
        let half = Rational::from((1, 2));
        let ssi = |first, second| point(&plane, Construction::Ssi([v(first), v(second)]));
        assert_eq!(ssi([0, 1], [2, 3]), Ok(vec![half.clone(), half.clone()]));
        assert_eq!(ssi([4, 2], [3, 2]), Ok(vec![Rational::new(), half]));
        assert_eq!(ssi([0, 2], [2, 4]), Err(NoPoint::ParallelLines));
        let tiny = f64::from_bits(1);
        let space = Scene::from_points3(&[
            [0.0, 0.0, 3.0],
            [1.0, 0.0, 3.0],
            [0.0, tiny, 3.0],
            [0.0, 0.0, 0.0],
            [1.0, 2.0, 4.0],
            [1.0, 2.0, 4.0],
            [2.0, 0.0, 3.0],
        ])
        .unwrap();
        let lpi = |line, plane| point(&space, Construction::Lpi { line: v(line), plane: v(plane) });
        assert_eq!(lpi([3, 4], [0, 1, 2]), Ok([(3, 4), (3, 2), (3, 1)].map(Rational::from).to_vec()));
        assert_eq!(lpi([0, 1], [0, 1, 2]), Err(NoPoint::ParallelToPlane));
        assert_eq!(lpi([4, 5], [0, 1, 2]), Err(NoPoint::LineEnds));
        assert_eq!(lpi([3, 4], [0, 1, 6]), Err(NoPoint::CollinearPlane));
        let tpi = |first, second, third| point(&space, Construction::Tpi([v(first), v(second), v(third)]));
        assert_eq!(tpi([0, 1, 2], [0, 1, 3], [0, 2, 3]), Ok([0, 0, 3].map(Rational::from).to_vec()));
        let pencil = tpi([0, 1, 2], [0, 1, 3], [0, 1, 4]);
        assert_eq!(pencil, Err(NoPoint::Planes));
    }
}
