//! The derived constants beside the hand-made ones, and the filters against rationals.

use std::cmp::Ordering;

use predicament_arithmetic::bound;
use predicament_judge::formula_value;

use crate::common::{HAND_MADE, formula, slices};

#[test]
fn constants_are_at_most_half_as_large_again_as_the_hand_made_ones() {
    let hand_made = [bound::ORIENT2D, bound::ORIENT3D, bound::INCIRCLE, bound::INSPHERE];
    let roundings = [[3, 4], [7, 8], [10, 11], [15, 16]];
    for (((name, text, dimension), hand_made), roundings) in HAND_MADE.into_iter().zip(hand_made).zip(roundings) {
        let formula = formula(text, dimension);
        let ratio = formula.filter().constant() / hand_made;
        assert!((1.0..1.5).contains(&ratio), "{name}: {ratio}");
        assert_eq!(formula.filter().roundings(), roundings, "{name}");
    }
}

#[test]
fn static_bounds_are_at_most_half_as_large_again_as_the_hand_made_ones() {
    let extents = [1.0, 3.0, 0.5];
    let [x, y, z] = extents;
    let hand_made = [
        bound::static_orient2d([x, y]),
        bound::static_orient3d([x, y, z]),
        bound::static_incircle([x, y]),
        bound::static_insphere([x, y, z]),
    ];
    for ((name, text, dimension), hand_made) in HAND_MADE.into_iter().zip(hand_made) {
        let formula = formula(text, dimension);
        let extent = &extents[..dimension];
        let ratio = formula.filter().static_bound(formula.program(), extent, extent) / hand_made;
        assert!((0.99..1.5).contains(&ratio), "{name}: {ratio}");
    }
}

#[test]
fn bits_are_those_of_the_determinants() {
    // Magnitudes at coordinates of magnitude 1: 8, 48, 192 and 2304. So the logarithms are 3, 6, 8 and 12, and a sign.
    for ((name, text, dimension), bits) in HAND_MADE.into_iter().zip([110, 166, 221, 278]) {
        assert_eq!(formula(text, dimension).bits().of(53), bits, "{name}");
    }
}

/// A large weight multiplies a minor of products that underflow. The weight is a part of a factor only: the slack has
/// to grow with it.
#[test]
fn underflow_is_covered_where_a_part_of_a_factor_is_large() {
    let power = formula(
        "u = a - d; v = b - d; s = c - d; \
         det([u, sq(u) - (a.w - d.w)], [v, sq(v) - (b.w - d.w)], [s, sq(s) - (c.w - d.w)])",
        2,
    );
    // The minors are 1.1 and 1.4 times the smallest double, and both are rounded to it.
    let [tiny, large] = [2f64.powi(-537), 2f64.powi(600)];
    let points = [
        vec![1.1 * tiny, 0.0, -large * (1.0 - 2f64.powi(-20))],
        vec![1.4 * tiny, 0.0, -large],
        vec![0.0, tiny, 0.0],
        vec![0.0, 0.0, 0.0],
    ];
    let slices = slices(&points);
    let truth = formula_value(&power, &slices).unwrap().cmp0();
    assert_eq!((truth, power.estimate(&slices)[0] < 0.0), (Ordering::Greater, true), "the estimate is wrong");
    assert_eq!(power.certain(&slices), None);
    assert_eq!(power.sign(&slices), Some(truth));
}
