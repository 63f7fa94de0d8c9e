//! Rows and derivatives against polynomials in integers of any size.

use predicament_exact::Exact;
use predicament_predicates::{Backend, Off};
use rug::{Integer, Rational, integer::Order};

use super::*;
use crate::constructed::moved::Moved;
use crate::constructed::search::integers;
use crate::constructed::series::{Cut, Number as _, Series};
use crate::constructed::testing::{Random, constructions};

fn value(number: Number) -> Rational {
    let magnitude = Rational::from(Integer::from_digits(number.limbs, Order::Lsf)) << (64 * number.low);
    if number.negative { -magnitude } else { magnitude }
}

/// Compares a vertex' row and derivatives with the coefficients of its polynomial.
fn check(scene: &Scene, rows: &Rows, index: usize) -> bool {
    let row = rows.of(scene, index);
    let Place::Meet(construction) = row.place else { return false };
    let dimension = scene.dimension().count();
    let (unit, coordinates) = integers(scene, &row.inputs);
    let cut = Cut::new([1]);
    let degree = match construction {
        Construction::Ssi(_) => 3,
        Construction::Lpi { .. } => 4,
        Construction::Tpi(_) => 7,
        Construction::Ratio { .. } => 1,
    };
    let columns: Vec<usize> = (0..=dimension).collect();
    let mut sign = Rational::new();
    for axis in 0..dimension {
        let moved: Vec<_> = coordinates
            .iter()
            .enumerate()
            .map(|(at, &(m, k))| {
                let mut series = Series::constant(&cut, Integer::from(m) << k);
                series[1] += i32::from(at == axis);
                series
            })
            .collect();
        let polynomial =
            Moved { dimension: scene.dimension(), cut: &cut, inputs: &row.inputs, coordinates: &moved }.row(&row.place);
        if sign == 0 {
            sign = Rational::from(polynomial[dimension][0].clone().signum());
            assert_eq!(row.weight, Sign::from(sign.cmp0()));
        }
        for (which, power) in [(0, 0), (axis + 1, 1)] {
            for &column in &columns {
                let entry = row.vector(which, [column])[0];
                let degree = degree - i32::from(column == dimension) - i32::from(power == 1);
                let expected = Rational::from(&polynomial[column][power]) << (degree * (unit + rows.shift(scene)));
                assert_eq!(value(entry), expected * &sign, "{which} of {} {construction}", Vertex::constructed(index));
                assert!(entry.is_zero() || entry.low >= row.span[0] && entry.top() <= row.span[1]);
            }
        }
    }
    assert_eq!(row.vector(0, [dimension])[0].cmp0(), std::cmp::Ordering::Greater);
    true
}

/// All kinds, with and without common vertices, at all scales.
///
/// Coordinates have one bit or many, and are as large and as small as possible.
#[test]
fn rows_and_derivatives_are_coefficients() {
    let mut random = Random(5);
    let (mut checked, mut twice) = ([0; 2], 0);
    for round in 0..predicament_effort::scaled(3000) {
        let dimension = 2 + round % 2;
        let points = if round % 4 < 2 { 6 } else { 10 };
        let bits = [1, 2, 53, 53, 100, 1000][round / 4 % 6];
        let coordinates: Vec<f64> = (0..points * dimension)
            .map(|_| {
                let magnitude = match bits {
                    1 | 2 => f64::from(u32::try_from(random.below(1 << bits)).unwrap()),
                    // Many digits, and exponents far from each other.
                    _ => {
                        let significand = f64::from_bits(1023 << 52 | u64::try_from(random.below(1 << 52)).unwrap());
                        let exponent = i32::try_from(random.below(2 * bits)).unwrap() - i32::try_from(bits).unwrap();
                        significand * 2f64.powi((exponent % 53 + exponent / 53 * 52).clamp(-1070, 1023))
                    }
                };
                if random.below(2) == 0 { magnitude } else { -magnitude }
            })
            .collect();
        // The smallest of all now and then, and the largest.
        let scale = |x: f64| match round / 24 % 3 {
            1 if bits <= 53 => x * f64::from_bits(1 << 10),
            2 if bits <= 53 => x * 2f64.powi(960),
            _ => x,
        };
        let dimension = if dimension == 2 {
            predicament_predicates::Dimension::Two
        } else {
            predicament_predicates::Dimension::Three
        };
        let mut scene = Scene::new(dimension, coordinates.into_iter().map(scale).collect()).unwrap();
        constructions(&mut random, &mut scene, 6);
        assert!(Exact.prepare(&scene, Off).is_ok());
        let rows = Rows::new(&scene);
        for index in 0..scene.constructions().len() {
            checked[dimension.count() - 2] += usize::from(check(&scene, &rows, index));
            twice += usize::from(!rows.of(&scene, index).is_linear);
        }
    }
    assert!(checked.iter().all(|&count| count > 100) && twice > 10, "{checked:?} {twice}");
}

/// Coordinates that fill their bits: the space suffices to the last sum.
#[test]
fn numbers_that_fill_their_limbs() {
    let mut random = Random(6);
    let largest = [f64::MAX, 2f64.powi(58) - 32.0, 2f64.powi(59) - 64.0, 1.0 - f64::EPSILON / 2.0];
    let mut checked = 0;
    for round in 0..predicament_effort::scaled(1000) {
        let (large, small) = (largest[round % 4], [1.0, 5e-324, 2f64.powi(-400), 3.0][round / 4 % 4]);
        let mut number = || [large, -large, large, -large, small, -small, large / 2.0][random.below(7)];
        let mut scene = Scene::from_points3(&[(); 9].map(|()| [number(), number(), number()])).unwrap();
        constructions(&mut random, &mut scene, 6);
        let rows = Rows::new(&scene);
        for index in 0..scene.constructions().len() {
            checked += usize::from(check(&scene, &rows, index));
        }
    }
    assert!(checked > 100, "{checked}");
}
