//! The derived constants beside the hand-made ones, and the filters against rationals.

use predicament_arithmetic::bound;

use crate::common::{HAND_MADE, formula};

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
