//! The payload that a session throws if it cannot answer.

use crate::Class;

/// The reason why a session stopped in the middle of a scene: its process crashed, hung, or answered nonsense.
///
/// The methods of [`Predicates`](crate::Predicates) return signs, so a session that cannot give a sign
/// [`throw`](Broken::throw)s this value. The code that runs a backend on a scene catches it and records it as the
/// outcome.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Broken {
    /// The class of the scene: [`Class::Panic`], [`Class::Timeout`] or [`Class::Declined`].
    pub class: Class,
    /// The name of the check that failed: `crashed`, `silence`, `protocol`, …
    pub check: &'static str,
    /// A description of the failure, in one line.
    pub message: String,
}

impl Broken {
    /// Unwinds with this value as the payload; no panic hook runs, so nothing is printed.
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
