//! The error of a name that is not in a vocabulary.

use alloc::{borrow::ToOwned, string::String, vec::Vec};

/// A text that is not the name of any item of a vocabulary, such as the classes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UnknownName {
    /// The kind of item, in the singular: `class`, `axis`.
    pub kind: &'static str,
    /// The text that is not a name.
    pub name: String,
    /// The plural of `kind` and all valid names, if the message lists them.
    pub known: Option<(&'static str, Vec<&'static str>)>,
}

impl UnknownName {
    /// An error whose message lists no names.
    #[must_use]
    pub fn new(kind: &'static str, name: &str) -> UnknownName {
        UnknownName { kind, name: name.to_owned(), known: None }
    }

    /// The same error, with a message that lists the valid names.
    #[must_use]
    pub fn listing(self, plural: &'static str, names: impl IntoIterator<Item = &'static str>) -> UnknownName {
        UnknownName { known: Some((plural, names.into_iter().collect())), ..self }
    }
}

impl core::fmt::Display for UnknownName {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "no {} is called `{}`", self.kind, self.name)?;
        match &self.known {
            Some((plural, names)) => write!(f, "; the {plural} are {}", names.join(", ")),
            None => Ok(()),
        }
    }
}

impl core::error::Error for UnknownName {}
