//! The payload that a session throws if it cannot answer.

use crate::Class;
use alloc::string::String;

/// The reason why a session stopped in the middle of a scene: its process crashed, hung, or answered nonsense.
///
/// The methods of [`Predicates`](crate::Predicates) return signs, so a session that cannot give a sign
/// [`throw`](Broken::throw)s this value. The code that runs a backend on a scene catches it and records it as the
/// outcome.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Broken {
    /// The class of the scene: [`Class::Panic`], [`Class::Timeout`], [`Class::Declined`] or [`Class::Refused`].
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
    #[cfg(feature = "std")]
    pub fn throw(self) -> ! {
        std::panic::resume_unwind(std::boxed::Box::new(self))
    }
}

impl core::fmt::Display for Broken {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{}: {}", self.check, self.message)
    }
}

impl core::error::Error for Broken {}
