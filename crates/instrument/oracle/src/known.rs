//! The known scenes that expectations can refer to.
//!
//! A user's suite may be anywhere, or gone: an expectation about its scenes is not a mistake, and can't be checked
//! against a run. So a pattern that matches nothing is a mistake only if all scenes that it could match are known.

use std::collections::BTreeSet;
use std::ops::Bound;

use crate::pattern::Pattern;

/// The known scenes by suite and name, and their names.
#[derive(Default)]
pub struct Scenes {
    all: Vec<(String, String)>,
    names: BTreeSet<String>,
    suites: BTreeSet<String>,
    /// Suites that have further, unknown scenes.
    open: BTreeSet<String>,
}

impl Scenes {
    /// The scenes, by suite and name. `open` lists suites that may have other scenes, because their file can't be read.
    #[must_use]
    pub fn new(all: Vec<(String, String)>, open: BTreeSet<String>) -> Scenes {
        let names = all.iter().flat_map(|(suite, scene)| [scene.clone(), format!("{suite}/{scene}")]).collect();
        let suites = all.iter().map(|(suite, _)| suite.clone()).collect();
        Scenes { all, names, suites, open }
    }

    /// True if the name of a scene matches.
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

    /// True if a pattern may match a scene that is not known here: a scene of an open suite, or of an unknown suite in
    /// the pattern. A pattern without a suite only refers to known suites.
    #[must_use]
    pub fn may_be_elsewhere(&self, pattern: &Pattern) -> bool {
        let is_known = |name: &str| self.names.contains(name);
        if !pattern.has_suite() {
            // A scene of one suite is unrelated to a scene of another suite with the same name.
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
