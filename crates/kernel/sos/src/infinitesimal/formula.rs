//! The judge of ties of formulas: the syntax tree, evaluated on coordinates that are polynomials in infinitesimals.
//!
//! A product of infinitesimals is the list of their powers, the smallest infinitesimal first. Products compare like
//! these lists: the smallest infinitesimal that occurs decides. No list of terms is derived.
//!
//! # Few infinitesimals first
//! A polynomial of twenty infinitesimals has thousands of products, and a large one nearly always decides. So only the
//! largest infinitesimals move first: without the smaller ones, exactly those products are left that have none of them.
//! Each of these is larger than any product with a smaller one, whose list has an earlier power that is not zero. So if
//! the rest is not zero, its largest product is the largest of all. Otherwise twice as many infinitesimals move.

use std::collections::BTreeMap;
use std::ops::AddAssign;

use predicament_predicates::formula::{Ring, interpret};
use predicament_predicates::{Derived, Scene, Sign, Vertex};
use rug::{Integer, Rational};
use smallvec::{SmallVec, smallvec};

use crate::Scheme;

/// Powers of infinitesimals: those of five vertices with four coordinates need no allocation.
type Powers = SmallVec<[u8; 20]>;

/// A polynomial in infinitesimals: the powers of each product, and its coefficient, which is not zero.
///
/// A list of powers is empty if all powers are zero. The coefficients are integers in units of one power of two, so
/// that no fraction is reduced.
#[derive(Clone, Default)]
struct Series {
    terms: BTreeMap<Powers, Integer>,
    exponent: i32,
}

impl Series {
    /// Adds a product with a coefficient, or with a product that becomes one.
    fn gain<C>(&mut self, powers: Powers, coefficient: C)
    where
        Integer: AddAssign<C>,
    {
        *self.terms.entry(powers).or_default() += coefficient;
    }

    fn without_zeros(mut self) -> Series {
        self.terms.retain(|_, coefficient| !coefficient.is_zero());
        self
    }

    /// One product of infinitesimals.
    fn infinitesimal(powers: Powers) -> Series {
        Series { terms: BTreeMap::from([(powers, Integer::from(1))]), exponent: 0 }
    }

    /// The same polynomial in units of 2^exponent, which is at most the present unit.
    fn in_units(mut self, exponent: i32) -> Series {
        let shift = self.exponent.abs_diff(exponent);
        if shift == 0 {
            return self;
        }
        self.terms.values_mut().for_each(|coefficient| *coefficient <<= shift);
        Series { exponent, ..self }
    }

    /// The sign if all infinitesimals are positive: that of the largest product.
    fn sign(&self) -> Sign {
        self.terms.first_key_value().map_or(Sign::Zero, |(_, coefficient)| coefficient.cmp0().into())
    }
}

impl Ring for Series {
    fn whole(number: f64) -> Series {
        let (value, denominator) = Rational::from_f64(number).unwrap_or_default().into_numer_denom();
        let exponent = 1 - i32::try_from(denominator.significant_bits()).expect("1,075 bits at most");
        let mut series = Series { terms: BTreeMap::new(), exponent };
        series.gain(Powers::new(), value);
        series.without_zeros()
    }

    fn plus(&self, other: &Series, minus: bool) -> Series {
        let exponent = self.exponent.min(other.exponent);
        let [mut sum, other] = [self, other].map(|series| series.clone().in_units(exponent));
        for (powers, coefficient) in other.terms {
            sum.gain(powers, if minus { -coefficient } else { coefficient });
        }
        sum.without_zeros()
    }

    fn times(&self, other: &Series) -> Series {
        let mut product = Series { terms: BTreeMap::new(), exponent: self.exponent + other.exponent };
        for (left, a) in &self.terms {
            for (right, b) in &other.terms {
                let powers = match (left.is_empty(), right.is_empty()) {
                    (true, _) => right.clone(),
                    (_, true) => left.clone(),
                    _ => left.iter().zip(right).map(|(x, y)| x + y).collect(),
                };
                product.gain(powers, a * b);
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
    let all = vertices.len() * derived.formula().coordinates();
    let mut active = 2.min(all);
    loop {
        let sign = by_largest(active, scheme, scene, derived, vertices);
        if !sign.is_zero() || active == all {
            return sign;
        }
        active = (2 * active).min(all);
    }
}

/// The sign if only so many of the largest infinitesimals move coordinates.
fn by_largest(active: usize, scheme: Scheme, scene: &Scene, derived: Derived, vertices: &[Vertex]) -> Sign {
    let count = derived.formula().coordinates();
    let ranks = Derived::ranks(vertices);
    moved(scene, derived, vertices, |argument, axis| {
        let within = if scheme == Scheme::PerCoordinate { axis } else { count - 1 - axis };
        let number = ranks[argument] * count + within;
        // The first power is that of the smallest infinitesimal.
        (number < active).then(|| {
            let mut powers = smallvec![0; active];
            powers[active - 1 - number] = 1;
            powers
        })
    })
}

/// The sign of a formula if the vertices of the second mesh have moved by η·(ε, ε², ε³), with η smaller than every
/// power of ε; a weight is the next coordinate.
pub(super) fn judge_per_mesh(scene: &Scene, derived: Derived, vertices: &[Vertex]) -> Sign {
    let second = scene.second_mesh().unwrap_or_default();
    moved(scene, derived, vertices, |argument, axis| {
        let moves = second.get(vertices[argument].index()).copied().unwrap_or(false);
        moves.then(|| smallvec![1, u8::try_from(axis + 1).unwrap_or(u8::MAX)])
    })
}

/// The sign of a formula if coordinates of its arguments move by products of infinitesimals.
fn moved(
    scene: &Scene,
    derived: Derived,
    vertices: &[Vertex],
    powers: impl Fn(usize, usize) -> Option<Powers>,
) -> Sign {
    let points = derived.with_points(scene, vertices, |points| {
        let coordinate = |argument: usize, (axis, &x): (usize, &f64)| {
            let still = Series::whole(x);
            match powers(argument, axis) {
                Some(powers) => still.plus(&Series::infinitesimal(powers), false),
                None => still,
            }
        };
        let point =
            |(argument, point): (usize, &&[f64])| point.iter().enumerate().map(|at| coordinate(argument, at)).collect();
        points.iter().enumerate().map(point).collect()
    });
    interpret(derived.formula(), points).map_or(Sign::Zero, |value| value.sign())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (x + ε)(y + δ) for doubles of all magnitudes: its coefficients are xy, x, y and 1, in whatever unit.
    #[test]
    fn units_change_no_polynomial() {
        let numbers = [0.0, 1.0, -0.75, 1e300, f64::MIN_POSITIVE, -f64::from_bits(3)];
        let rational = |x: f64| Rational::from_f64(x).expect("finite");
        for x in numbers {
            for y in numbers {
                let moved = |x, powers| Series::whole(x).plus(&Series::infinitesimal(powers), false);
                let product = moved(x, smallvec![1, 0]).times(&moved(y, smallvec![0, 1]));
                let of = |series: &Series, powers: &[u8]| {
                    let coefficient = series.terms.get(powers).cloned().unwrap_or_default();
                    Rational::from(coefficient) << series.exponent
                };
                let found = [&[][..], &[0, 1], &[1, 0], &[1, 1]].map(|powers| of(&product, powers));
                assert_eq!(found, [rational(x) * rational(y), rational(x), rational(y), Rational::from(1)], "{x} {y}");
                let difference = Series::whole(x).plus(&Series::whole(y), true);
                assert_eq!(of(&difference, &[]), rational(x) - rational(y));
                assert_eq!(product.plus(&product, true).sign(), Sign::Zero, "{x} {y}");
            }
        }
    }

    /// Points of a small grid, many of them equal, and vertices that occur twice: often small infinitesimals decide, or
    /// none.
    #[test]
    fn few_infinitesimals_decide_as_all_of_them_do() {
        let mut state = 3_u64;
        let mut next = move |bound: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            u32::try_from(state >> 33).expect("31 bits") % bound
        };
        let [mut late, mut zeros] = [0; 2];
        for &derived in Derived::shipped() {
            let (arity, dimension) = (derived.arity(), derived.dimension());
            for round in 0..12 {
                let mut numbers = |count| (0..count).map(|_| f64::from(next(1 + round % 3))).collect();
                let (coordinates, weights) = (numbers(arity * dimension.count()), numbers(arity));
                let scene = Scene::new(dimension, coordinates).unwrap().with_weights(weights).unwrap();
                let mut vertices: Vec<Vertex> = (0..arity).map(Vertex::input).collect();
                vertices.rotate_left(round as usize % arity);
                if round % 4 == 3 {
                    vertices[0] = vertices[1];
                }
                for scheme in Scheme::ALL {
                    let by = |active| by_largest(active, scheme, &scene, derived, &vertices);
                    let all = by(arity * derived.formula().coordinates());
                    assert_eq!(judge(scheme, &scene, derived, &vertices), all, "{} {scene:?}", derived.name());
                    zeros += usize::from(all.is_zero());
                    late += usize::from(!all.is_zero() && by(2).is_zero());
                }
            }
        }
        assert!(late > 20 && zeros > 5, "{late} {zeros}");
    }
}
