//! A fault of lifting: points moved by ε^(2^i) are lifted again, where squares collide.
//!
//! Franklin and Magalhães move coordinate i by ε^(2^i), so that every product of different infinitesimals has a
//! different power. A lifted determinant has squares as well, and (ε^(2^i))² is ε^(2^(i+1)), the next coordinate's. The
//! fault stores each term under its power, first-order terms first; of two terms with the same power, the later
//! overwrites the earlier.
//!
//! (Adding the terms would be correct: points that have really moved by ε^(2^i) are points, and break no law. Taking
//! the terms one after the other in any fixed order is correct as well, by another perturbation with infinitesimals in
//! nearly these proportions. Only the lost terms make answers contradict each other.)

use std::sync::OnceLock;

use predicament_predicates::{Scene, Sign, Vertex};
use rug::Rational;

use predicament_judge as judge;

/// The factor of a monomial from each row: the coordinate and power of its infinitesimal.
type Moves = Vec<Option<(usize, u32)>>;

/// The number of coordinates of a point.
const AXES: usize = 2;

/// The sign of the first non-zero coefficient for four points in the plane.
pub(super) fn decide(scene: &Scene, sorted: &[Vertex]) -> Option<Sign> {
    static MONOMIALS: OnceLock<Vec<Moves>> = OnceLock::new();
    let points: Vec<Vec<Rational>> =
        sorted.iter().map(|&v| scene.point(v).iter().map(|&x| judge::rational(x)).collect()).collect();
    let monomials = MONOMIALS.get_or_init(monomials);
    let signs = monomials.iter().map(|moves| {
        let rows: Vec<Vec<Rational>> = points.iter().zip(moves).map(|(point, &moved)| row(point, moved)).collect();
        Sign::from(judge::determinant(&rows).cmp0())
    });
    signs.into_iter().find(|sign| !sign.is_zero())
}

/// Products of infinitesimals by power; of those with equal power, one of the highest degree.
fn monomials() -> Vec<Moves> {
    let mut all: Vec<Moves> = vec![Vec::new()];
    for _ in 0..AXES + 2 {
        let moves = (0..AXES).flat_map(|axis| [1, 2].map(|power| Some((axis, power))));
        let moves: Vec<Option<(usize, u32)>> = std::iter::once(None).chain(moves).collect();
        let longer = |shorter: &Moves| moves.iter().map(|&next| [shorter.as_slice(), &[next]].concat()).collect();
        all = all.iter().flat_map::<Vec<Moves>, _>(longer).collect();
    }
    let degree = |moves: &Moves| moves.iter().flatten().map(|&(_, power)| power).sum::<u32>();
    let exponent = |moves: &Moves| {
        let of = |(row, moved): (usize, &Option<(usize, u32)>)| {
            moved.map_or(0, |(axis, power)| u64::from(power) << (row * AXES + axis))
        };
        moves.iter().enumerate().map(of).sum::<u64>()
    };
    all.sort_by_key(|moves| (exponent(moves), std::cmp::Reverse(degree(moves))));
    all.dedup_by_key(|moves| exponent(moves));
    all
}

/// A row of the matrix (coordinates, lift, 1), or the factor of its infinitesimal's power in the moved row.
fn row(point: &[Rational], moved: Option<(usize, u32)>) -> Vec<Rational> {
    let mut row = vec![Rational::new(); point.len() + 2];
    let lift = point.len();
    match moved {
        None => {
            row[..lift].clone_from_slice(point);
            row[lift] = point.iter().map(|x| Rational::from(x.square_ref())).sum();
            row[lift + 1] = Rational::from(1);
        }
        // (x + e)² = x² + 2x·e + e²
        Some((axis, 1)) => {
            row[axis] = Rational::from(1);
            row[lift] = Rational::from(&point[axis] * 2);
        }
        Some(_) => row[lift] = Rational::from(1),
    }
    row
}
