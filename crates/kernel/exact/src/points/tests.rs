//! Predicates on points of every type of numbers, against integers and rationals of GMP.

use predicament_predicates::Sign;
use proptest::prelude::*;
use rug::Integer;

use super::{f32, i32, i64};
use crate::{NotFinite, orient2d, orient3d, rational, try_incircle, try_insphere, try_orient2d, try_orient3d};

/// The determinant of differences to the last point, with their squares if it is lifted, by Laplace's expansion.
fn truth<const D: usize, const N: usize>(points: [[i64; D]; N], lifted: bool) -> Sign {
    fn minor(rows: &[Vec<Integer>], column: usize) -> Integer {
        if rows.is_empty() {
            return Integer::from(1);
        }
        let mut sum = Integer::new();
        for at in 0..rows.len() {
            let others: Vec<Vec<Integer>> = [&rows[..at], &rows[at + 1..]].concat();
            let term = minor(&others, column + 1) * &rows[at][column];
            if at % 2 == 0 { sum += term } else { sum -= term }
        }
        sum
    }
    let rows: Vec<Vec<Integer>> = points[..N - 1]
        .iter()
        .map(|point| {
            let mut row: Vec<Integer> =
                point.iter().zip(points[N - 1]).map(|(&x, last)| Integer::from(x) - Integer::from(last)).collect();
            if lifted {
                row.push(row.iter().map(|x| x.clone().square()).sum());
            }
            row
        })
        .collect();
    Sign::from(minor(&rows, 0).cmp0())
}

/// Checks all predicates on five points of integers, and on points of 32 bits if they fit.
fn check(points: [[i64; 3]; 5]) {
    let [a, b, c, d, e] = points;
    let flat = points.map(|[x, y, _]| [x, y]);
    assert_eq!(i64::orient2d(flat[0], flat[1], flat[2]), truth([flat[0], flat[1], flat[2]], false), "{flat:?}");
    let four = [flat[0], flat[1], flat[2], flat[3]];
    assert_eq!(i64::incircle(four[0], four[1], four[2], four[3]), truth(four, true), "{four:?}");
    assert_eq!(i64::orient3d(a, b, c, d), truth([a, b, c, d], false), "{points:?}");
    assert_eq!(i64::insphere(a, b, c, d, e), truth(points, true), "{points:?}");
    if let Some([a, b, c, d, e]) = short(points) {
        let [p, q, r, s] = [a, b, c, d].map(|[x, y, _]| [x, y]);
        assert_eq!(i32::orient2d(p, q, r), truth([flat[0], flat[1], flat[2]], false));
        assert_eq!(i32::incircle(p, q, r, s), truth(four, true));
        assert_eq!(i32::orient3d(a, b, c, d), truth([points[0], points[1], points[2], points[3]], false));
        assert_eq!(i32::insphere(a, b, c, d, e), truth(points, true));
    }
}

/// The points as integers of 32 bits, if they all are.
fn short(points: [[i64; 3]; 5]) -> Option<[[core::primitive::i32; 3]; 5]> {
    let is_short = points.as_flattened().iter().all(|&x| core::primitive::i32::try_from(x).is_ok());
    is_short.then(|| points.map(|p| p.map(|x| core::primitive::i32::try_from(x).expect("checked"))))
}

/// Integers of any length, often the ends of the range and small ones.
fn integer() -> impl Strategy<Value = i64> {
    prop_oneof![
        any::<i64>(),
        (any::<i64>(), 0..64_u32).prop_map(|(x, by)| x >> by),
        prop::sample::select(vec![i64::MIN, i64::MAX, 0, 1, -1, (1 << 53) + 1, 1 - (1 << 53), 1 << 31]),
        -2..=2_i64,
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(4000)))]

    #[test]
    fn integers_have_the_sign_of_the_determinant(points in prop::collection::vec(integer(), 15)) {
        let mut all = [[0; 3]; 5];
        all.as_flattened_mut().copy_from_slice(&points);
        check(all);
        // Ties: the last point is an affine combination of others, as far as it fits.
        let [a, b, c, ..] = all.map(|p| p.map(|x| x >> 3));
        let d = [0, 1, 2].map(|axis| a[axis] + b[axis] - c[axis]);
        check([a, b, c, d, a]);
        check([a, b, c, [a[0], b[1], c[2]], d]);
    }

    #[test]
    fn singles_have_the_sign_of_the_same_doubles(bits in any::<[u32; 15]>(), near in any::<bool>()) {
        let mut numbers = bits.map(core::primitive::f32::from_bits).map(|x| if x.is_finite() { x } else { 0.5 });
        if near {
            numbers = bits.map(|x| 1.0 + core::primitive::f32::from_bits(0x3f80_0000 | x & 7));
        }
        let p: [[core::primitive::f32; 3]; 5] = std::array::from_fn(|i| std::array::from_fn(|j| numbers[3 * i + j]));
        let [a, b, c, d, e] = p.map(|p| p.map(f64::from));
        prop_assert_eq!(f32::orient3d(p[0], p[1], p[2], p[3]), rational::orient3d(a, b, c, d).sign());
        prop_assert_eq!(f32::insphere(p[0], p[1], p[2], p[3], p[4]), rational::insphere(a, b, c, d, e).sign());
        let q = p.map(|[x, y, _]| [x, y]);
        let [a, b, c, d] = [a, b, c, d].map(|[x, y, _]| [x, y]);
        prop_assert_eq!(f32::orient2d(q[0], q[1], q[2]), rational::orient2d(a, b, c).sign());
        prop_assert_eq!(f32::incircle(q[0], q[1], q[2], q[3]), rational::incircle(a, b, c, d).sign());
        prop_assert_eq!(f32::try_incircle(q[0], q[1], q[2], q[3]), Ok(rational::incircle(a, b, c, d).sign()));
    }
}

/// Puts a number that is not finite at each place, beside numbers for which filters decide and for which they do not.
#[test]
fn numbers_that_are_not_finite_are_errors_wherever_they_are() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for scale in [0.0, 1.0, 1e300, 5e-324] {
            let solid = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.2, 0.3, 0.4]];
            let solid = solid.map(|p: [f64; 3]| p.map(|x| x * scale));
            for (point, axis) in (0..5).flat_map(|point| (0..3).map(move |axis| (point, axis))) {
                let mut p = solid;
                p[point][axis] = value;
                let q = p.map(|[x, y, _]| [x, y]);
                let expected = |has: bool, sign: Result<Sign, NotFinite>| match sign {
                    Err(error) => {
                        assert!(has && (error.point, error.axis) == (point, axis), "{error}");
                        assert!(error.value == value || value.is_nan() && error.value.is_nan());
                    }
                    Ok(_) => assert!(!has, "{p:?}"),
                };
                expected(point < 3 && axis < 2, try_orient2d(q[0], q[1], q[2]));
                expected(point < 4 && axis < 2, try_incircle(q[0], q[1], q[2], q[3]));
                expected(point < 4, try_orient3d(p[0], p[1], p[2], p[3]));
                expected(true, try_insphere(p[0], p[1], p[2], p[3], p[4]));
            }
        }
    }
}

#[test]
#[should_panic(expected = "coordinate 1 of point 2 is NaN")]
fn the_panic_names_the_coordinate() {
    let _ = orient2d([0.0, 0.0], [1.0, 0.0], [1.0, f64::NAN]);
}

#[test]
fn points_are_whatever_converts_to_an_array() {
    struct Place {
        x: f64,
        y: f64,
    }
    impl From<Place> for [f64; 2] {
        fn from(Place { x, y }: Place) -> [f64; 2] {
            [x, y]
        }
    }
    assert_eq!(orient2d(Place { x: 0.0, y: 0.0 }, [1e-200, 0.0], (0.0, 1e-200)), Sign::Positive);
    assert_eq!(orient3d([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]), Sign::Positive);
}
