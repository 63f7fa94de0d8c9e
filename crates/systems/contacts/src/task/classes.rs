//! The class of a pair of simplices.
//!
//! A pair is degenerate if its ranks add up to less than the dimension. If only one of backend and truth registers a
//! pair, its class is that of the first error:
//!
//! | who registers it | because | class |
//! |---|---|---|
//! | truth only | the backend registers faces of it, which don't meet | `overreach` |
//! | truth only, degenerate | | `missed_zero` |
//! | truth only, of full dimension | | `sign_flip` |
//! | backend only | faces of it meet, and the backend doesn't register them | `missed_zero` |
//! | backend only, degenerate | | `overreach` |
//! | backend only, of full dimension | | `sign_flip` |
//!
//! Backends that break ties are compared with the perturbed scene instead. Its registered pairs have to be registered,
//! and no others (`sign_flip`), and never a degenerate pair (`inconsistent`). If the result differs from the exact
//! scene's, a tie was broken: `tie_broken`.
//!
//! Backends with a band are judged by exact distances. A pair that keeps the guarantee and differs from the exact scene
//! is `in_band`.

use std::collections::{BTreeMap, BTreeSet};

use predicament_predicates::{Dimension, ZeroMeaning};

use super::pairs::{Pairs, is_degenerate};
use crate::truth::Pair;
use predicament_tasks::Class;

/// A class with the check that gives it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Judgement {
    pub class: Class,
    pub check: &'static str,
}

/// Registered pairs, and the references for their judgement.
pub(crate) struct Judge<'p> {
    pub dimension: Dimension,
    pub zero: ZeroMeaning,
    pub got: &'p Pairs<'p>,
    pub truth: &'p Pairs<'p>,
    pub perturbed: Option<&'p Pairs<'p>>,
    /// For bands: the pairs whose exact distance breaks the guarantee.
    pub audited: &'p BTreeMap<Pair, (Class, &'static str)>,
}

impl Judge<'_> {
    /// The pairs that have a class, in order.
    pub fn pairs(&self) -> BTreeSet<Pair> {
        let perturbed = self.perturbed.into_iter().flat_map(Pairs::iter);
        self.got.iter().chain(self.truth.iter()).chain(perturbed).chain(self.audited.keys().copied()).collect()
    }

    /// The class of a pair that the truth or the backend registers.
    pub fn class(&self, pair: Pair) -> Judgement {
        let [got, truth] = [self.got, self.truth].map(|pairs| pairs.contains(pair));
        let (class, check) = match self.zero {
            ZeroMeaning::Never => self.perturbed(pair, got, truth),
            ZeroMeaning::Exact => self.exact(pair, got, truth),
            ZeroMeaning::Band => self.band(pair, got, truth),
        };
        Judgement { class, check }
    }

    fn exact(&self, pair: Pair, got: bool, truth: bool) -> (Class, &'static str) {
        let degenerate = is_degenerate(self.dimension, pair);
        match (got, truth) {
            (true, true) => (Class::Agree, "contact"),
            (false, _) if self.got.ended_by(pair).is_some() => (Class::Overreach, "ended early"),
            (_, false) if self.truth.ended_by(pair).is_some() => (Class::MissedZero, "not ended"),
            (false, _) if degenerate => (Class::MissedZero, "contact"),
            (_, false) if degenerate => (Class::Overreach, "contact"),
            _ => (Class::SignFlip, "contact"),
        }
    }

    fn band(&self, pair: Pair, got: bool, truth: bool) -> (Class, &'static str) {
        match self.audited.get(&pair) {
            Some(&broken) => broken,
            None if got == truth => (Class::Agree, "contact"),
            None => (Class::InBand, "contact"),
        }
    }

    fn perturbed(&self, pair: Pair, got: bool, truth: bool) -> (Class, &'static str) {
        let degenerate = is_degenerate(self.dimension, pair);
        let perturbed = self.perturbed.map_or(got, |perturbed| perturbed.contains(pair));
        if got && degenerate {
            (Class::Inconsistent, "never degenerate")
        } else if got != perturbed {
            (Class::SignFlip, "perturbed contact")
        } else if got == truth {
            (Class::Agree, "contact")
        } else if got && self.truth.ended_by(pair).is_some() || truth && degenerate {
            (Class::TieBroken, "contact")
        } else {
            (Class::SignFlip, "contact")
        }
    }
}
