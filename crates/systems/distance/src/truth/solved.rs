//! The nearest points of two simplices, by linear algebra in rationals.
//!
//! A point of a simplex is its first corner plus a combination of edges. The squared distance of two such points is
//! quadratic in the k + l weights of both simplices, and its derivatives vanish where the weights solve the normal
//! equations. The solution is single if the matrix of scalar products is regular. It is inside both simplices if all
//! barycentric coordinates are positive.

use predicament_judge::determinant;
use rug::Rational;

/// A point in space or in the plane.
pub(super) type Point = Vec<Rational>;

fn minus(p: &Point, q: &Point) -> Point {
    p.iter().zip(q).map(|(x, y)| Rational::from(x - y)).collect()
}

fn dot(p: &Point, q: &Point) -> Rational {
    p.iter().zip(q).map(|(x, y)| Rational::from(x * y)).sum()
}

/// The nearest points of two simplices.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Solved {
    /// The squared distance.
    pub squared: Rational,
    /// The point of each simplex.
    pub points: [Vec<Rational>; 2],
}

/// The nearest points of the inside of two simplices; `None` if there are not exactly two such points.
///
/// The simplices are given by their corners. The inside of a vertex is the vertex.
pub(super) fn solved(one: &[&Point], other: &[&Point]) -> Option<Solved> {
    let edges = |corners: &[&Point]| corners[1..].iter().map(|p| minus(p, corners[0])).collect::<Vec<Point>>();
    let (ahead, back) = (edges(one), edges(other));
    let between = minus(other[0], one[0]);
    // The difference of the points is `between` minus the weighted sum of these directions.
    let negated = back.iter().map(|edge| edge.iter().map(|x| Rational::from(-x)).collect::<Point>());
    let directions: Vec<Point> = ahead.iter().cloned().chain(negated).collect();
    let weights = weights(&directions, &between)?;
    let (of_one, of_other) = weights.split_at(ahead.len());
    let is_inside = |weights: &[Rational]| weights.iter().sum::<Rational>() < 1;
    if !is_inside(of_one) || !is_inside(of_other) {
        return None;
    }
    let place = |corner: &Point, edges: &[Point], weights: &[Rational]| {
        let mut place = corner.clone();
        for (edge, weight) in edges.iter().zip(weights) {
            place.iter_mut().zip(edge).for_each(|(x, along)| *x += Rational::from(along * weight));
        }
        place
    };
    let points = [place(one[0], &ahead, of_one), place(other[0], &back, of_other)];
    let difference = minus(&points[0], &points[1]);
    Some(Solved { squared: dot(&difference, &difference), points })
}

/// The weights of the directions whose sum is nearest to a vector; `None` if there are several, or one is not positive.
///
/// The first weight that is not positive ends the search: a point of the inside has none.
fn weights(directions: &[Point], vector: &Point) -> Option<Vec<Rational>> {
    let rows: Vec<Vec<Rational>> =
        directions.iter().map(|one| directions.iter().map(|other| dot(one, other)).collect()).collect();
    if rows.is_empty() {
        return Some(Vec::new());
    }
    let right: Vec<Rational> = directions.iter().map(|direction| dot(direction, vector)).collect();
    let whole = determinant(&rows);
    if whole == 0 {
        return None;
    }
    let weight = |at: usize| {
        let mut replaced = rows.clone();
        replaced.iter_mut().zip(&right).for_each(|(row, right)| row[at].clone_from(right));
        let weight = determinant(&replaced) / &whole;
        (weight > 0).then_some(weight)
    };
    (0..directions.len()).map(weight).collect()
}
