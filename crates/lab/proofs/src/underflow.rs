//! Terms that underflow can lose: each product is off by η, at most 2⁻¹⁰⁷⁵, and later factors multiply that.
//!
//! Losses are polynomials, and are compared with the slack of a filter by their coefficients.

use predicament_exact::constructed::filter::FLOOR;

use crate::chain::{ETA, magnitude};
use crate::polynomial::Polynomial;
use crate::trace::{Node, Traced};

/// Checks that each loss is η times a part of a term: of the largest permanent of the scene, two factors or more are
/// left.
pub fn divides(lost: &Polynomial, whole: &Polynomial) -> Result<(), String> {
    let is_part = |part: &[String], of: &[String]| {
        let mut of = of.iter();
        part.iter().all(|name| of.any(|known| known == name))
    };
    for monomial in lost.0.keys() {
        let rest: Vec<String> = monomial.iter().filter(|name| *name != ETA).cloned().collect();
        if !whole.0.keys().any(|term| term.len() >= rest.len() + 2 && is_part(&rest, term)) {
            return Err(format!("no term of the bound has the factors of {monomial:?}"));
        }
    }
    Ok(())
}

/// Checks that the static bound is the constant times the permanent of the extents, up to its rounding upwards.
pub fn is_bound(whole: &Polynomial, constant: f64, bound: fn([f64; 3]) -> f64) -> Result<(), String> {
    for extent in [[1.0, 1.0, 1.0], [3.0, 5.0, 7.0], [2.0, 64.0, 4096.0], [8192.0, 16.0, 1.0]] {
        let axis = |name: &str| extent[["x", "y", "z"].iter().position(|axis| name.ends_with(axis)).expect("an axis")];
        #[allow(clippy::cast_precision_loss)] // small
        let terms =
            whole.0.iter().map(|(monomial, c)| *c as f64 * monomial.iter().map(|name| axis(name)).product::<f64>());
        let [found, least] = [bound(extent), constant * terms.sum::<f64>()];
        // Its products are rounded up, ten at most.
        if !(found > least && found < least * (1.0 + 32.0 * f64::EPSILON)) {
            return Err(format!(
                "the static bound of extents {extent:?} is {found:e}, and should be {least:e} or hardly more"
            ));
        }
    }
    Ok(())
}

/// The atom of constructed vertices: |d| and both slacks.
pub fn with_slacks(difference: Traced) -> Polynomial {
    let Node::Sub(x, y) = difference.node() else { return magnitude(difference) };
    let slack = |x: Traced| Polynomial::symbol(&format!("slack of {}", x.text(1)));
    magnitude(difference).plus(&slack(x), 1).plus(&slack(y), 1)
}

/// The power of two that bounds η over three factors of a permanent of constructed vertices.
///
/// Each factor has the slacks of two coordinates, of at least [`FLOOR`].
pub fn over_three_slacks() -> i32 {
    let exponent = i32::try_from((2.0 * FLOOR).to_bits() >> 52).expect("11 bits");
    over_three(exponent - 1023)
}

/// The power of two that bounds η over three factors of at least 2 to this power.
pub fn over_three(least: i32) -> i32 {
    -1075 - 3 * least
}

/// A symbol with the extent of the scene in place of a difference that is not larger, along the same axis.
///
/// The function replaces differences between the pivot a and the point that is asked about (`queried`); all differences
/// if there is no such point.
pub fn extent_of(symbol: &str, queried: Option<&str>) -> String {
    let is_of = |point: &str| symbol.starts_with("|(a") && symbol.contains(&format!(" - {point}"));
    match symbol.strip_prefix("|(").and_then(|names| names.chars().nth(1)) {
        Some(axis) if queried.is_none_or(is_of) => format!("extent {axis}"),
        _ => symbol.to_owned(),
    }
}

/// Bounds of what underflow can lose.
pub struct Underflow {
    /// The factor of η·s/σ that bounds all losses of the filter for any doubles.
    pub anywhere: i64,
    /// The sum of the coefficients of all losses.
    pub terms: i64,
}

/// The least whole r for which `lost` is at most r·η·slack/σ, term by term.
///
/// Factors: a product of two symbols is at most half the sum of their squares, and η is below one. A term with two η
/// may have one symbol more, which is below 2¹⁰²⁴: η times that is below 2⁻⁵⁰, and counts as one.
pub fn covered(lost: &Polynomial, slack: &Polynomial) -> Result<i64, String> {
    let unit: Vec<(Vec<&String>, i64)> =
        slack.0.iter().map(|(m, c)| (m.iter().filter(|name| *name != "σ").collect(), *c)).collect();
    let has = |monomial: &[&String]| unit.iter().any(|(known, c)| known == monomial && *c >= 1);
    let mut most = 0;
    for (monomial, coefficient) in &lost.0 {
        let rest: Vec<&String> = monomial.iter().filter(|name| *name != ETA).collect();
        // (Of two η, one bounds a symbol.)
        let is_tiny = monomial.len() >= rest.len() + 2 && rest.len() == 1;
        let is_covered = has(&rest) || pairs(&rest).into_iter().any(|[a, b]| has(&a) && has(&b)) || is_tiny;
        if !is_covered {
            return Err(format!("the slack has no term for {monomial:?}"));
        }
        // (All terms count, though each of them has its own term of the slack.)
        most += coefficient;
    }
    Ok(most)
}

/// The two monomials whose mean bounds a product of three or fewer symbols: one of two symbols is replaced by the
/// other.
fn pairs<'a>(monomial: &[&'a String]) -> Vec<[Vec<&'a String>; 2]> {
    let mut all = Vec::new();
    for i in 0..monomial.len() {
        for j in 0..monomial.len() {
            if i != j {
                let with = |from: usize, to: usize| {
                    let mut changed = monomial.to_vec();
                    changed[from] = monomial[to];
                    changed.sort();
                    changed
                };
                all.push([with(i, j), with(j, i)]);
            }
        }
    }
    all
}
