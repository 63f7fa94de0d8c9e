//! The judge of ties of formulas: the syntax tree, evaluated on coordinates that are polynomials in infinitesimals.
//!
//! A product of infinitesimals is the list of their powers, the smallest infinitesimal first. Products compare like
//! these lists: the smallest infinitesimal that occurs decides. No list of terms is derived, and no product is left
//! out.

use std::collections::BTreeMap;

use predicament_predicates::formula::{Ring, interpret};
use predicament_predicates::{Derived, Scene, Sign, Vertex};
use rug::Rational;

use crate::Scheme;

/// A polynomial in infinitesimals: the powers of each product, and its coefficient, which is not zero.
///
/// A list of powers is empty if all powers are zero.
#[derive(Clone, Default)]
struct Series(BTreeMap<Vec<u8>, Rational>);

impl Series {
    fn gain(&mut self, powers: Vec<u8>, coefficient: Rational) {
        let sum = self.0.entry(powers).or_default();
        *sum += coefficient;
    }

    fn without_zeros(mut self) -> Series {
        self.0.retain(|_, coefficient| !coefficient.is_zero());
        self
    }

    /// The sign if all infinitesimals are positive: that of the largest product.
    fn sign(&self) -> Sign {
        self.0.first_key_value().map_or(Sign::Zero, |(_, coefficient)| coefficient.cmp0().into())
    }
}

impl Ring for Series {
    fn whole(number: f64) -> Series {
        let mut series = Series::default();
        series.gain(Vec::new(), Rational::from_f64(number).unwrap_or_default());
        series.without_zeros()
    }

    fn plus(&self, other: &Series, minus: bool) -> Series {
        let mut sum = self.clone();
        for (powers, coefficient) in &other.0 {
            sum.gain(powers.clone(), if minus { Rational::from(-coefficient) } else { coefficient.clone() });
        }
        sum.without_zeros()
    }

    fn times(&self, other: &Series) -> Series {
        let mut product = Series::default();
        for (left, a) in &self.0 {
            for (right, b) in &other.0 {
                let powers = match (left.is_empty(), right.is_empty()) {
                    (true, _) => right.clone(),
                    (_, true) => left.clone(),
                    _ => left.iter().zip(right).map(|(x, y)| x + y).collect(),
                };
                product.gain(powers, Rational::from(a * b));
            }
        }
        product.without_zeros()
    }

    fn negated(&self) -> Series {
        Series::default().plus(self, true)
    }
}

/// The sign of a formula at vertices that have moved; zero if it is zero wherever they are.
pub(super) fn judge(scheme: Scheme, scene: &Scene, derived: Derived, vertices: &[Vertex]) -> Sign {
    let count = derived.formula().coordinates();
    let ranks = Derived::ranks(vertices);
    let places = vertices.len() * count;
    moved(scene, derived, vertices, |argument, axis| {
        let within = if scheme == Scheme::PerCoordinate { axis } else { count - 1 - axis };
        // The first power is that of the smallest infinitesimal.
        let mut powers = vec![0; places];
        powers[places - 1 - (ranks[argument] * count + within)] = 1;
        Some(powers)
    })
}

/// The sign of a formula if the vertices of the second mesh have moved by (ε, ε², ε³); a weight is the next coordinate.
pub(super) fn judge_per_mesh(scene: &Scene, derived: Derived, vertices: &[Vertex]) -> Sign {
    let second = scene.second_mesh().unwrap_or_default();
    moved(scene, derived, vertices, |argument, axis| {
        let moves = second.get(vertices[argument].index()).copied().unwrap_or(false);
        moves.then(|| vec![u8::try_from(axis + 1).unwrap_or(u8::MAX)])
    })
}

/// The sign of a formula if coordinates of its arguments move by products of infinitesimals.
fn moved(
    scene: &Scene,
    derived: Derived,
    vertices: &[Vertex],
    powers: impl Fn(usize, usize) -> Option<Vec<u8>>,
) -> Sign {
    let points = derived.with_points(scene, vertices, |points| {
        let coordinate = |argument: usize, (axis, &x): (usize, &f64)| {
            let mut moved = Series::whole(x);
            if let Some(powers) = powers(argument, axis) {
                moved.gain(powers, Rational::from(1));
            }
            moved
        };
        let point =
            |(argument, point): (usize, &&[f64])| point.iter().enumerate().map(|at| coordinate(argument, at)).collect();
        points.iter().enumerate().map(point).collect()
    });
    interpret(derived.formula(), points).map_or(Sign::Zero, |value| value.sign())
}
