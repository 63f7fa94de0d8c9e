//! The type of predicates from formulas in builds without formulas: there are none.

use crate::Dimension;

/// A predicate that is derived from a formula; without the feature `formulas` there is no such value.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Derived {}

#[allow(missing_docs)] // the docs are those of the type with formulas
impl Derived {
    #[must_use]
    pub fn named(_: &str) -> Option<Derived> {
        None
    }

    #[must_use]
    pub fn dimension(self) -> Dimension {
        match self {}
    }

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {}
    }

    #[must_use]
    pub fn arity(self) -> usize {
        match self {}
    }

    #[must_use]
    pub fn degree(self) -> u32 {
        match self {}
    }

    #[must_use]
    pub fn text(self) -> &'static str {
        match self {}
    }

    #[must_use]
    pub fn about(self) -> &'static str {
        match self {}
    }

    #[must_use]
    pub fn is_weighted(self) -> bool {
        match self {}
    }
}
