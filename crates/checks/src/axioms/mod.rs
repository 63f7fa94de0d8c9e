//! Laws that the answers of one session must satisfy among themselves.
//!
//! The signs of one real (or one consistently perturbed) point set obey laws
//! that need no judge: swapping two arguments flips the sign, order is
//! transitive, and the orientations satisfy the three-term Grassmann-Plücker
//! relations, the axioms of a chirotope. A session that breaks one of them
//! answers about no point set at all.
//!
//! # What a zero counts for
//! * [`ZeroMeaning::Exact`] and [`ZeroMeaning::Never`]: a zero is a sign like
//!   the others, that of a determinant which vanishes. (A session that breaks
//!   ties still answers zero for repeated vertices, and rightly.)
//! * [`ZeroMeaning::Band`]: a zero says "too close to tell", and the band may
//!   be decided differently from one order of arguments to the next. So zeros
//!   break no law, and a law is checked only between answers that are signs.

mod antisymmetry;
mod plucker;
mod transitivity;

pub use antisymmetry::{antisymmetry, each_order};
pub use plucker::{grassmann_plucker2, grassmann_plucker3};
pub use transitivity::transitivity;

use predicament_predicates::{Question, Sign, Vertex, ZeroMeaning};

/// Which law is broken.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Law {
    /// A permutation of the arguments multiplies the sign by its parity.
    Antisymmetry,
    /// The three-term Grassmann-Plücker relation.
    GrassmannPlucker,
    /// The order along an axis is transitive.
    Transitivity,
}

impl Law {
    /// The name used in CSV files and reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Law::Antisymmetry => "antisymmetry",
            Law::GrassmannPlucker => "grassmann-plucker",
            Law::Transitivity => "transitivity",
        }
    }
}

/// One query with the answer it got.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Answer {
    /// The arguments, in the order in which they were given.
    pub args: Vec<Vertex>,
    /// What the session said.
    pub sign: Sign,
}

/// Answers that contradict each other.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Violation {
    /// The law they break.
    pub law: Law,
    /// What was asked.
    pub question: Question,
    /// The queries that can't all be right.
    pub answers: Vec<Answer>,
}

impl std::fmt::Display for Violation {
    /// One line: the law, and each query with its answer.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} broken by {}", self.law.name(), self.question.kind())?;
        for (at, Answer { args, sign }) in self.answers.iter().enumerate() {
            let args: Vec<String> = args.iter().map(ToString::to_string).collect();
            write!(f, "{} ({}) = {sign}", if at == 0 { ":" } else { "," }, args.join(" "))?;
        }
        Ok(())
    }
}

/// Whether a zero says nothing, so that no law can be read off it.
fn says_nothing(sign: Sign, zero: ZeroMeaning) -> bool {
    zero == ZeroMeaning::Band && sign.is_zero()
}
