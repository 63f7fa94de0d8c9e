//! What a session throws where it cannot answer.

use crate::Class;

/// Why a session broke off in the middle of a scene: the process behind it crashed, fell silent, or answered nonsense.
///
/// The methods of [`Predicates`](crate::Predicates) return signs, so a session that cannot give one
/// [`throw`](Broken::throw)s this; who runs a backend on a scene catches it and makes it the outcome.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Broken {
    /// The class of the scene: [`Class::Panic`], [`Class::Timeout`] or [`Class::Declined`].
    pub class: Class,
    /// What has found it: `crashed`, `silence`, `protocol`, …
    pub check: &'static str,
    /// What happened, in one line.
    pub message: String,
}

impl Broken {
    /// Unwinds with this. No panic hook is called: nothing is printed.
    ///
    /// # Panics
    /// Always.
    pub fn throw(self) -> ! {
        std::panic::resume_unwind(Box::new(self))
    }
}

impl std::fmt::Display for Broken {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.check, self.message)
    }
}

impl std::error::Error for Broken {}
