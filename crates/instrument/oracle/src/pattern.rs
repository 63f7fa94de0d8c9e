//! Patterns for scenes in a file of expectations.
//!
//! Nearly all patterns are the name of one scene. A glob becomes a regular expression, and compiling thousands of them
//! takes a third of a second at the start of every run. So a name is compared as a string, and a glob is compiled on
//! first use; it is parsed earlier only if it can be invalid.

use std::sync::{Arc, OnceLock};

use globset::{Glob, GlobMatcher};

/// The glob that matches this text only.
#[must_use]
pub fn escape(text: &str) -> String {
    // Globset leaves a backslash unescaped, where it would escape the next character. Inside a class a backslash is
    // literal.
    globset::escape(text).replace('\\', "[\\]")
}

/// A glob over `scene` and `suite/scene`. Clones share the compiled glob.
#[derive(Clone, Debug)]
pub struct Pattern(Arc<Inner>);

#[derive(Debug)]
enum Inner {
    Name(String),
    Glob(String, OnceLock<GlobMatcher>),
}

/// The glob characters that are always valid.
const SINGLE: [char; 2] = ['*', '?'];
/// The other glob characters.
const OTHERS: [char; 7] = ['[', ']', '{', '}', '\\', '!', ','];

/// The error for an invalid pattern. It displays the text and the error.
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
    /// The error on one line, with the text of the glob.
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

    /// The text of the pattern.
    #[must_use]
    pub fn text(&self) -> &str {
        match &*self.0 {
            Inner::Name(text) | Inner::Glob(text, _) => text,
        }
    }

    /// The common prefix of all names that the pattern matches.
    #[must_use]
    pub fn prefix(&self) -> &str {
        self.text().split(SINGLE).next().and_then(|text| text.split(OTHERS).next()).unwrap_or_default()
    }

    /// The only name that the pattern matches, if it has no glob characters.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        matches!(*self.0, Inner::Name(_)).then(|| self.text())
    }

    /// True if the pattern includes a suite.
    #[must_use]
    pub fn has_suite(&self) -> bool {
        self.text().contains('/')
    }

    /// True if a scene of this suite may match a pattern that includes a suite.
    #[must_use]
    pub fn may_be_of(&self, suite: &str) -> bool {
        let of = self.text().split_once('/').map_or("", |(of, _)| of);
        // If the suite part is not a valid glob, it ends inside a group or class, and may match anything.
        Glob::new(of).map_or(true, |of| of.compile_matcher().is_match(suite))
    }

    /// True if the pattern matches a scene's name, or its suite and name.
    #[must_use]
    pub fn names(&self, suite: &str, scene: &str) -> bool {
        match &*self.0 {
            Inner::Name(name) => {
                name == scene || name.strip_prefix(suite).and_then(|rest| rest.strip_prefix('/')) == Some(scene)
            }
            Inner::Glob(..) => {
                // Most globs begin with characters that most names do not begin with.
                let prefix = self.prefix();
                let may_be_of_suite = match prefix.strip_prefix(suite) {
                    Some(rest) => rest.is_empty() || rest.strip_prefix('/').is_some_and(|rest| scene.starts_with(rest)),
                    None => suite.starts_with(prefix),
                };
                (scene.starts_with(prefix) && self.is_match(scene))
                    || (may_be_of_suite && self.is_match(&format!("{suite}/{scene}")))
            }
        }
    }

    /// True if the pattern matches this text.
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
