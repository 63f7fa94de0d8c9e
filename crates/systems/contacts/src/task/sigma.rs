//! The tolerance σ of the scheme of Wang, Jiang, Schroeder and Teran: two vertices within this distance are registered
//! as one. It is also the unit by which copies are moved.
//!
//! The formulas are those of Algorithms 1 and 6 with ε = 2^-52, the machine epsilon of double precision. They are
//! written out here because scenes must not depend on a backend: a scene stays the same if a backend's tolerances
//! change.

use predicament_predicates::Dimension;

/// The tolerance σ = 6.5·√ε·L in the plane, 6.5·ε^¼·L in space, rounded like any other coordinate of a generated scene.
///
/// L = (1 + 5ε)/(1 − 7√ε)·(La + Lb) in the plane, (1 + 5ε)/(1 − 7ε^¼)·(La + Lb) in space. La and Lb are the largest
/// bounding-box edges of a primitive of each complex.
pub(super) fn sigma(dimension: Dimension, [la, lb]: [f64; 2]) -> f64 {
    let root = match dimension {
        Dimension::Two => f64::EPSILON.sqrt(),
        Dimension::Three => f64::EPSILON.sqrt().sqrt(),
    };
    let length = (1.0 + 5.0 * f64::EPSILON) / (1.0 - 7.0 * root) * (la + lb);
    6.5 * (root * length)
}

/// A unit vector, exact up to the rounding of its decimals, that is not parallel to an axis. So a copy moved along it
/// has the intended distance and shares no coordinate with the original.
pub(super) fn direction(dimension: Dimension) -> &'static [f64] {
    match dimension {
        Dimension::Two => &[0.6, 0.8],
        Dimension::Three => &[0.48, 0.6, 0.64],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_formula_in_the_paper() {
        // √ε = 2^-26 and ε^¼ = 2^-13 are doubles.
        let plane = 6.5 * 2.0_f64.powi(-26) * 3.0;
        assert!((sigma(Dimension::Two, [1.0, 2.0]) / plane - 1.0).abs() < 2e-7);
        let space = 6.5 * 2.0_f64.powi(-13) * 3.0;
        assert!((sigma(Dimension::Three, [1.0, 2.0]) / space - 1.0).abs() < 1e-3);
        for dimension in [Dimension::Two, Dimension::Three] {
            let square: f64 = direction(dimension).iter().map(|x| x * x).sum();
            assert!((square - 1.0).abs() < 1e-15);
        }
    }
}
