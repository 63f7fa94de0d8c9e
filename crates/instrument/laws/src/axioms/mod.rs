//! Laws that the answers of one session must satisfy among themselves.
//!
//! The signs of one real (or one consistently perturbed) point set obey laws
//! that need no judge: swapping two arguments flips the sign, order is
//! transitive, and the orientations satisfy the three-term Grassmann-Plücker
//! relations, the axioms of a chirotope. A session that breaks one of them
//! answers about no point set at all.
//!
//! * [`antisymmetry`], [`transitivity`], [`never_zero`]: within one predicate.
//! * [`Relation`]: Grassmann-Plücker relations, within one predicate or, through
//!   points at infinity, between a predicate and those of fewer dimensions.
//! * [`independence_of_place`], [`independence_of_later_vertices`]: an answer
//!   belongs to its vertices, not to what else is asked or is in the scene.
//! * [`equals_reference`]: the one law here that needs the truth.
//!
//! Functions that end in `_of_all`, and [`Relation::check_all`], look at many tuples and ask in batches: a session may
//! be a program at the other end of a pipe, where each question is a message.
//!
//! # What a zero counts for
//! * [`ZeroMeaning::Exact`] and [`ZeroMeaning::Never`]: a zero is a sign like
//!   the others, that of a determinant which vanishes. (A session that breaks
//!   ties still answers zero for repeated vertices, and rightly.)
//! * [`ZeroMeaning::Band`]: a zero says "too close to tell", and the band may
//!   be decided differently from one order of arguments to the next. So zeros
//!   break no law, and a law is checked only between answers that are signs.

mod antisymmetry;
mod never_zero;
mod place;
mod reference;
mod relation;
mod transitivity;

pub use antisymmetry::{antisymmetry, antisymmetry_of_all, each_order};
pub use never_zero::never_zero;
pub use place::{independence_of_later_vertices, independence_of_later_vertices_of_all, independence_of_place};
pub use reference::equals_reference;
pub use relation::{Direction, Relation, relations};
pub use transitivity::{transitivity, transitivity_of_all};

use predicament_predicates::{Contract, PredicateKind, Question, Sign, Vertex, ZeroMeaning};

/// Which law is broken.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Law {
    /// A session that breaks ties answers zero for no distinct vertices.
    NeverZero,
    /// A permutation of the arguments multiplies the sign by its parity.
    Antisymmetry,
    /// The order along an axis is transitive.
    Transitivity,
    /// The three-term Grassmann-Plücker relation of one predicate.
    GrassmannPlucker,
    /// The same with points at infinity, which ties a predicate to those of fewer dimensions.
    MixedGrassmannPlucker,
    /// An answer does not depend on what is asked beside it.
    Place,
    /// An answer does not depend on vertices that come after its own.
    LaterVertices,
    /// The exact sign, where that is not zero.
    Reference,
}

impl Law {
    /// All of them, in the order of reports.
    pub const ALL: [Law; 8] = [
        Law::NeverZero,
        Law::Antisymmetry,
        Law::Transitivity,
        Law::GrassmannPlucker,
        Law::MixedGrassmannPlucker,
        Law::Place,
        Law::LaterVertices,
        Law::Reference,
    ];

    /// The name used in CSV files and reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Law::NeverZero => "never-zero",
            Law::Antisymmetry => "antisymmetry",
            Law::Transitivity => "transitivity",
            Law::GrassmannPlucker => "grassmann-plucker",
            Law::MixedGrassmannPlucker => "mixed-grassmann-plucker",
            Law::Place => "independence-of-place",
            Law::LaterVertices => "independence-of-later-vertices",
            Law::Reference => "equals-exact",
        }
    }
}

/// What a session means by zero, predicate by predicate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Zeros([ZeroMeaning; PredicateKind::ALL.len()]);

impl Zeros {
    /// As the contracts of a backend say.
    #[must_use]
    pub fn promised(contract: impl Fn(PredicateKind) -> Contract) -> Zeros {
        Zeros(PredicateKind::ALL.map(|kind| contract(kind).zero))
    }

    /// The meaning of a zero of this predicate.
    #[must_use]
    pub fn of(self, kind: PredicateKind) -> ZeroMeaning {
        self.0[kind.index()]
    }
}

/// The same for all predicates.
impl From<ZeroMeaning> for Zeros {
    fn from(zero: ZeroMeaning) -> Zeros {
        Zeros([zero; PredicateKind::ALL.len()])
    }
}

/// One query with the answer it got.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Answer {
    /// What was asked.
    pub question: Question,
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
    /// The queries that can't all be right.
    pub answers: Vec<Answer>,
}

impl std::fmt::Display for Violation {
    /// One line: the law, and each query with its answer.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} broken", self.law.name())?;
        for (at, Answer { question, args, sign }) in self.answers.iter().enumerate() {
            write!(f, "{} {} = {sign}", if at == 0 { ":" } else { "," }, question.query(args))?;
        }
        Ok(())
    }
}

/// Whether a zero says nothing, so that no law can be read off it.
fn says_nothing(sign: Sign, zero: ZeroMeaning) -> bool {
    zero == ZeroMeaning::Band && sign.is_zero()
}

/// Whether no vertex comes twice.
fn are_distinct(args: &[Vertex]) -> bool {
    args.iter().enumerate().all(|(at, v)| !args[..at].contains(v))
}
