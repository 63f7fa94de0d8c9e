//! Algorithms 1 and 6 from L on, over any number type, in the pseudocode's order of multiplications.
//!
//! The products of powers of ε and L are those of [`Tolerances2d`](crate::Tolerances2d) and
//! [`Tolerances3d`](crate::Tolerances3d). A test checks that the results on doubles are identical bit by bit.

use predicament_error_calculus::Root;
use rug::Rational;

use super::coefficient::{FIGURE_1, FIGURE_5, Tolerance};
use crate::{tolerances2d, tolerances3d};

/// The middle values of Figure 1, Algorithm 1, from its line 6 on.
///
/// `number` makes constants, all of which floats can represent.
pub fn plane<N: Root>(epsilon: &N, length: &N, number: impl Fn(Rational) -> N) -> Vec<(&'static Tolerance, N)> {
    let [t, square] = tolerances2d::units(epsilon.clone(), length.clone());
    let value = |tolerance: &Tolerance| {
        let c = number(tolerance.width.rational());
        // κ = 21 ε L²
        if tolerance.symbol == "κ" { c * epsilon.clone() * square.clone() } else { c * t.clone() }
    };
    FIGURE_1.iter().map(|tolerance| (tolerance, value(tolerance))).collect()
}

/// The middle values of Figure 5, Algorithm 6, from its line 8 on.
pub fn space<N: Root>(epsilon: &N, length: &N, number: impl Fn(Rational) -> N) -> Vec<(&'static Tolerance, N)> {
    let [c, e, f] = tolerances3d::units(epsilon.clone(), length.clone());
    let unit = |tolerance: &Tolerance| match tolerance.length {
        1 => c.clone(),
        3 => e.clone(),
        _ => f.clone(),
    };
    FIGURE_5.iter().map(|tolerance| (tolerance, number(tolerance.width.rational()) * unit(tolerance))).collect()
}

/// The length L̂ = (La + Lb)/(1 − 7 ε^(1/2) or 7 ε^(1/4)) of 4.1 and 5.1.
///
/// The factor 1 + 5ε of L covers its error. The sum (La + Lb) is first, the one division last.
///
/// `difference` makes 1 − 7 ε^… of the two; its error is relative to itself only because of a lower bound.
pub fn length<N: Root>(sides: [N; 2], root: N, seven: N, difference: impl Fn(N) -> N) -> N {
    let [la, lb] = sides;
    (la + lb) / difference(N::one() - seven * root)
}
