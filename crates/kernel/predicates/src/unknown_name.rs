//! Why a text is the name of nothing in a vocabulary.

/// A text that is not the name of any item of a vocabulary, such as that of the classes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UnknownName {
    /// What was asked for, in the singular: `class`, `axis`.
    pub kind: &'static str,
    /// The text.
    pub name: String,
    /// The plural of `kind` and all names that there are, where the message lists them.
    pub known: Option<(&'static str, Vec<&'static str>)>,
}

impl UnknownName {
    /// An error whose message lists no names.
    #[must_use]
    pub fn new(kind: &'static str, name: &str) -> UnknownName {
        UnknownName { kind, name: name.to_owned(), known: None }
    }

    /// The same error, with a message that lists the names that there are.
    #[must_use]
    pub fn listing(self, plural: &'static str, names: impl IntoIterator<Item = &'static str>) -> UnknownName {
        UnknownName { known: Some((plural, names.into_iter().collect())), ..self }
    }
}

impl std::fmt::Display for UnknownName {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "no {} is called `{}`", self.kind, self.name)?;
        match &self.known {
            Some((plural, names)) => write!(f, "; the {plural} are {}", names.join(", ")),
            None => Ok(()),
        }
    }
}

impl std::error::Error for UnknownName {}
