//! The scenes that expectations can be about, as far as they are known.
//!
//! A suite of the user's may be anywhere, or gone: what names its scenes is no mistake, and can't be held against a run. So a pattern that
//! matches nothing is a mistake only where all scenes that it could match are known.

use std::collections::BTreeSet;
use std::ops::Bound;

use crate::pattern::Pattern;

/// Scenes by suite and name, and all that they are called.
#[derive(Default)]
pub struct Scenes {
    all: Vec<(String, String)>,
    names: BTreeSet<String>,
    suites: BTreeSet<String>,
    /// Suites that have more scenes than these.
    open: BTreeSet<String>,
}

impl Scenes {
    /// These scenes, by suite and name. `open` names suites of which others may be there: those whose file can't be looked at.
    #[must_use]
    pub fn new(all: Vec<(String, String)>, open: BTreeSet<String>) -> Scenes {
        let names = all.iter().flat_map(|(suite, scene)| [scene.clone(), format!("{suite}/{scene}")]).collect();
        let suites = all.iter().map(|(suite, _)| suite.clone()).collect();
        Scenes { all, names, suites, open }
    }

    /// Whether a scene has a name that matches.
    #[must_use]
    pub fn has_any(&self, pattern: &Pattern) -> bool {
        let prefix = pattern.prefix();
        let candidates = self.names.range::<str, _>((Bound::Included(prefix), Bound::Unbounded));
        candidates.take_while(|name| name.starts_with(prefix)).any(|name| pattern.is_match(name))
    }

    /// The scenes that match, by suite and name.
    pub fn matching<'a>(&'a self, pattern: &'a Pattern) -> impl Iterator<Item = &'a (String, String)> {
        self.all.iter().filter(|(suite, scene)| pattern.names(suite, scene))
    }

    /// Whether a pattern may be about a scene that is not among these: one of an open suite, or of a suite that it
    /// names and that is not known. A pattern without a suite is taken to be about the known ones.
    #[must_use]
    pub fn may_be_elsewhere(&self, pattern: &Pattern) -> bool {
        let is_known = |name: &str| self.names.contains(name);
        if !pattern.has_suite() {
            // The scene of one suite says nothing of that of another with the same name.
            return self
                .open
                .iter()
                .any(|suite| !pattern.name().is_some_and(|name| is_known(&format!("{suite}/{name}"))));
        }
        if pattern.name().is_some_and(is_known) {
            return false;
        }
        let may_be_of = |suite: &String| pattern.may_be_of(suite);
        self.open.iter().any(may_be_of) || !self.suites.iter().any(may_be_of)
    }
}
