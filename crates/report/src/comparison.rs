//! Who is compared with whom, and on what: the one rule behind every mean.
//!
//! A mean over what each backend happened to do compares nothing: the one that leaves out what is hard looks fast. So
//! backends are compared on what all of them did, and a backend that did too little of it is set aside.

use std::cmp::Reverse;
use std::collections::BTreeSet;

/// Backends with what they are compared on.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Comparison<'r, C> {
    /// What all compared backends did.
    pub common: BTreeSet<C>,
    /// How much there was: what any backend did.
    pub of: usize,
    /// The compared backends, in the order in which they came.
    pub compared: Vec<&'r str>,
    /// The backends that were set aside, each with what it did: partial, and not to be compared with the others.
    pub partial: Vec<(&'r str, BTreeSet<C>)>,
}

impl<'r, C: Ord + Clone> Comparison<'r, C> {
    /// Compares backends on what all of them did. Where that is less than half of what any of them did, backends are set
    /// aside, one after the other: each time the one without which the others have the most in common; of several, the
    /// one that did the least, and of these the last. Backends that did nothing are left out.
    pub fn of(did: Vec<(&'r str, BTreeSet<C>)>) -> Comparison<'r, C> {
        let mut left: Vec<(&str, BTreeSet<C>)> = did.into_iter().filter(|(_, did)| !did.is_empty()).collect();
        let order: Vec<&str> = left.iter().map(|(backend, _)| *backend).collect();
        let of = left.iter().flat_map(|(_, did)| did).collect::<BTreeSet<_>>().len();
        let mut partial = Vec::new();
        loop {
            let common = in_common(left.iter().map(|(_, did)| did));
            if 2 * common.len() >= of || left.len() < 2 {
                partial.sort_by_key(|(backend, _)| order.iter().position(|other| other == backend));
                let compared = left.into_iter().map(|(backend, _)| backend).collect();
                return Comparison { common, of, compared, partial };
            }
            let without = |at: usize| {
                let others = left.iter().enumerate().filter(|(other, _)| *other != at);
                in_common(others.map(|(_, (_, did))| did)).len()
            };
            let worst = (0..left.len()).max_by_key(|&at| (without(at), Reverse(left[at].1.len()), at));
            partial.push(left.remove(worst.unwrap_or(0)));
        }
    }

    /// All backends, the compared ones first, each with what its mean is over and whether it is partial.
    pub fn each(&self) -> impl Iterator<Item = (&'r str, &BTreeSet<C>, bool)> {
        let compared = self.compared.iter().map(|backend| (*backend, &self.common, false));
        compared.chain(self.partial.iter().map(|(backend, did)| (*backend, did, true)))
    }
}

fn in_common<'s, C: Ord + Clone + 's>(mut sets: impl Iterator<Item = &'s BTreeSet<C>>) -> BTreeSet<C> {
    let first = sets.next().cloned().unwrap_or_default();
    sets.fold(first, |common, set| common.intersection(set).cloned().collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of<'r>(did: &[(&'r str, std::ops::Range<u32>)]) -> Comparison<'r, u32> {
        Comparison::of(did.iter().map(|(backend, did)| (*backend, did.clone().collect())).collect())
    }

    #[test]
    fn what_all_did_is_compared_while_it_is_half_of_what_anybody_did() {
        let half = of(&[("a", 0..10), ("b", 0..6), ("c", 1..10)]);
        assert_eq!(half.common, (1..6).collect());
        assert_eq!((half.of, half.compared.as_slice(), half.partial.len()), (10, &["a", "b", "c"][..], 0));
    }

    #[test]
    fn who_did_little_is_set_aside_and_takes_nothing_from_the_others() {
        let few = of(&[("little", 0..4), ("a", 0..21), ("less", 0..3), ("b", 0..21), ("nothing", 0..0)]);
        assert_eq!(few.common, (0..21).collect());
        assert_eq!(few.compared, ["a", "b"]);
        assert_eq!(few.partial, [("little", (0..4).collect()), ("less", (0..3).collect())]);
        let partial: Vec<bool> = few.each().map(|(_, _, is_partial)| is_partial).collect();
        assert_eq!(partial, [false, false, true, true]);
    }

    #[test]
    fn backends_with_nothing_in_common_are_not_compared() {
        // Without `odd` the others have all of theirs in common.
        assert_eq!(of(&[("odd", 10..20), ("a", 0..10), ("b", 0..10)]).compared, ["a", "b"]);
        let apart = of(&[("a", 0..5), ("b", 5..10)]);
        assert_eq!((apart.compared.as_slice(), apart.partial.len()), (&["a"][..], 1));
        assert_eq!(of(&[]), Comparison { common: BTreeSet::new(), of: 0, compared: vec![], partial: vec![] });
    }
}
