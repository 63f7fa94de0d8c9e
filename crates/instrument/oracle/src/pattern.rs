//! Which scenes a pattern of a file of expectations names.
//!
//! Nearly all patterns are the name of one scene. A glob becomes a regular expression, and thousands of those cost a third of a second at the
//! start of every run. So a name is compared as a string, and a glob is compiled when it is first asked; it is parsed before only where
//! it can be wrong.

use std::sync::{Arc, OnceLock};

use globset::{Glob, GlobMatcher};

/// The glob that matches this text alone.
#[must_use]
pub fn escape(text: &str) -> String {
    // In a class a backslash is itself; globset leaves it as it is, where it takes away the meaning of what follows.
    globset::escape(text).replace('\\', "[\\]")
}

/// A glob over `scene` and `suite/scene`. A clone shares what is compiled.
#[derive(Clone, Debug)]
pub struct Pattern(Arc<Inner>);

#[derive(Debug)]
enum Inner {
    Name(String),
    Glob(String, OnceLock<GlobMatcher>),
}

/// The signs of globs that stand by themselves: nothing can be wrong with them.
const SINGLE: [char; 2] = ['*', '?'];
/// The other signs of globs.
const OTHERS: [char; 7] = ['[', ']', '{', '}', '\\', '!', ','];

/// A text that is not a pattern. It displays the text and what is wrong with it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PatternError(globset::Error);

impl std::fmt::Display for PatternError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.fmt(f)
    }
}

impl std::error::Error for PatternError {}

impl Pattern {
    /// Reads a glob.
    ///
    /// # Errors
    /// What is wrong with it, in one line that repeats it.
    pub fn new(text: &str) -> Result<Pattern, PatternError> {
        let can_be_wrong = text.contains(OTHERS);
        if can_be_wrong {
            Glob::new(text).map_err(PatternError)?;
        }
        let is_glob = can_be_wrong || text.contains(SINGLE);
        Ok(Pattern(Arc::new(if is_glob {
            Inner::Glob(text.to_owned(), OnceLock::new())
        } else {
            Inner::Name(text.to_owned())
        })))
    }

    /// The pattern as it was written.
    #[must_use]
    pub fn text(&self) -> &str {
        match &*self.0 {
            Inner::Name(text) | Inner::Glob(text, _) => text,
        }
    }

    /// The text with which every name begins that the pattern matches.
    #[must_use]
    pub fn prefix(&self) -> &str {
        self.text().split(SINGLE).next().and_then(|text| text.split(OTHERS).next()).unwrap_or_default()
    }

    /// The one name that it matches, if nothing in it means anything else.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        matches!(*self.0, Inner::Name(_)).then(|| self.text())
    }

    /// Whether it says of which suites the scenes are.
    #[must_use]
    pub fn has_suite(&self) -> bool {
        self.text().contains('/')
    }

    /// Whether a scene of this suite may match a pattern that says of which suites the scenes are.
    #[must_use]
    pub fn may_be_of(&self, suite: &str) -> bool {
        let of = self.text().split_once('/').map_or("", |(of, _)| of);
        // What is no glob by itself ends in the middle of a group or class: that may be anything.
        Glob::new(of).map_or(true, |of| of.compile_matcher().is_match(suite))
    }

    /// Whether it matches a scene by its name, or by that of its suite and its own.
    #[must_use]
    pub fn names(&self, suite: &str, scene: &str) -> bool {
        match &*self.0 {
            Inner::Name(name) => {
                name == scene || name.strip_prefix(suite).and_then(|rest| rest.strip_prefix('/')) == Some(scene)
            }
            Inner::Glob(..) => self.is_match(scene) || self.is_match(&format!("{suite}/{scene}")),
        }
    }

    /// Whether it matches this text.
    #[must_use]
    pub fn is_match(&self, text: &str) -> bool {
        match &*self.0 {
            Inner::Name(name) => name == text,
            Inner::Glob(glob, matcher) => {
                let compile =
                    || Glob::new(glob).expect("it was read, or nothing can be wrong with it").compile_matcher();
                matcher.get_or_init(compile).is_match(text)
            }
        }
    }
}
