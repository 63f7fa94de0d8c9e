//! Delta debugging: the smallest scene that still shows a finding.
//!
//! The search is greedy: a scene proposes [reductions](Shrink::reductions), the boldest first. The first one that still
//! shows the finding replaces the scene, until none does. The same scene always gives the same result.

use predicament_search::shrink::descent::{Descent, Evaluations};

/// A scene that can be made smaller.
pub trait Shrink: Sized {
    /// The measure of a scene, compared from the most important part to the least.
    type Size: Ord;

    /// The size of the scene.
    fn size(&self) -> Self::Size;

    /// Scenes that may be smaller, the boldest first.
    ///
    /// The search skips those that are not smaller.
    fn reductions(&self) -> Vec<Self>;
}

/// The smallest scene found, and the effort.
#[derive(Clone, PartialEq, Debug)]
pub struct Shrunk<S> {
    /// The smallest scene.
    pub scene: S,
    /// The number of reductions that were taken.
    pub taken: u64,
    /// The number of scenes that were tried.
    pub tried: u64,
    /// True if no reduction of it shows the finding; false if the limit came first.
    pub minimal: bool,
}

/// Shrinks a scene while `shows` says that it shows the finding, trying at most `limit` scenes.
///
/// It does not try the scene itself.
pub fn shrink<S: Shrink>(scene: S, limit: u64, mut shows: impl FnMut(&S) -> bool) -> Shrunk<S> {
    let mut shows = |candidate: &S, evaluations: &mut Evaluations| {
        evaluations.count()?;
        Ok(shows(candidate))
    };
    let mut search = Descent::new(scene, S::size, Evaluations { made: 0, most: limit }, &mut shows);
    let minimal = loop {
        let reductions = search.best.reductions();
        match search.try_each(reductions) {
            Ok(true) => {}
            Ok(false) => break true,
            Err(_) => break false,
        }
    };
    Shrunk { scene: search.best, taken: search.taken, tried: search.evaluations.made, minimal }
}

/// The length of a coordinate: the bits from its first to its last set bit.
///
/// For a fraction the number of bits after the point is added. Zero for zero.
#[must_use]
pub fn length(x: f64) -> u32 {
    if x == 0.0 {
        return 0;
    }
    let bits = x.abs().to_bits();
    // Counted from the exponent of the last place: subnormals have that of the first normal.
    let (field, fraction) = (bits >> 52, bits & ((1 << 52) - 1));
    let significand = if field == 0 { fraction } else { fraction | 1 << 52 };
    let odd = significand >> significand.trailing_zeros();
    let last = i64::try_from(field.max(1)).expect("eleven bits") - 1075 + i64::from(significand.trailing_zeros());
    let behind = u32::try_from((-last).max(0)).expect("at most 1074");
    (64 - odd.leading_zeros()) + behind
}

/// Shorter coordinates close to this one, the shortest first.
///
/// They are zero, then roundings to more and more bits, each down and up in magnitude. Infinities are excluded.
#[must_use]
pub fn shorter(x: f64) -> Vec<f64> {
    let mut candidates = vec![0.0];
    let (sign, bits) = (x.to_bits() & 1 << 63, x.to_bits() & !(1 << 63));
    for dropped in (1..=52).rev() {
        let down = bits >> dropped << dropped;
        for rounded in [down, down + (1 << dropped)] {
            candidates.push(f64::from_bits(rounded | sign));
        }
    }
    candidates.retain(|&candidate| candidate.is_finite() && length(candidate) < length(x));
    candidates.dedup();
    candidates
}

/// The lists with one element removed, for each element.
pub fn without_each<T: Clone>(list: &[T]) -> impl Iterator<Item = Vec<T>> {
    (0..list.len()).map(|at| [&list[..at], &list[at + 1..]].concat())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rug::Rational;

    use super::*;

    #[derive(Clone, PartialEq, Debug)]
    struct Numbers(Vec<f64>);

    impl Shrink for Numbers {
        type Size = (usize, u32);

        fn size(&self) -> (usize, u32) {
            (self.0.len(), self.0.iter().map(|&x| length(x)).sum())
        }

        fn reductions(&self) -> Vec<Numbers> {
            let dropped = without_each(&self.0).map(Numbers);
            let rounded = self.0.iter().enumerate().flat_map(|(at, &x)| {
                shorter(x).into_iter().map(move |y| {
                    let mut numbers = self.0.clone();
                    numbers[at] = y;
                    Numbers(numbers)
                })
            });
            // Growing is not a reduction, and must not keep the search from ending.
            dropped.chain(rounded).chain([Numbers([&self.0[..], &[1.0]].concat())]).collect()
        }
    }

    #[test]
    fn what_is_not_needed_goes() {
        let scene = Numbers(vec![0.3, 17.25, -4.0, 5.5, 99.0]);
        let shrunk = shrink(scene.clone(), 10_000, |numbers| numbers.0.iter().any(|&x| x > 5.0 && x < 9.0));
        assert_eq!(shrunk.scene, Numbers(vec![8.0]));
        assert!(shrunk.minimal && shrunk.taken > 0 && shrunk.tried >= shrunk.taken);
        let cut = shrink(scene.clone(), 1, |_| false);
        assert_eq!((cut.scene, cut.tried, cut.minimal), (scene, 1, false));
    }

    #[test]
    fn lengths_of_known_numbers() {
        let lengths = [0.0, -0.0, 1.0, -8.0, 13.0, 6.5, 0.25, f64::from_bits(1)].map(length);
        assert_eq!(lengths, [0, 0, 1, 1, 4, 5, 3, 1075]);
    }

    proptest! {
        /// Compares with rationals.
        #[test]
        fn length_is_that_of_numerator_and_denominator(x in any::<f64>()) {
            prop_assume!(x.is_finite() && x != 0.0);
            let value = Rational::from_f64(x).unwrap();
            let odd = value.numer().clone() >> value.numer().find_one(0).unwrap();
            prop_assert_eq!(length(x), odd.significant_bits() + value.denom().significant_bits() - 1);
        }

        #[test]
        fn shorter_numbers_are_shorter_and_of_one_sign(x in any::<f64>()) {
            prop_assume!(x.is_finite());
            for y in shorter(x) {
                prop_assert!(length(y) < length(x) && y.is_finite());
                prop_assert!(y == 0.0 || y.is_sign_negative() == x.is_sign_negative());
            }
            prop_assert!(x == 0.0 || shorter(x).first() == Some(&0.0));
        }
    }
}
