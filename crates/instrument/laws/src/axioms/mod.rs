//! Laws that the answers of one session must satisfy among themselves.
//!
//! The signs of one real (or one consistently perturbed) point set obey laws that need no judge: swapping two arguments
//! flips the sign, order is transitive, and the orientations satisfy the three-term Grassmann-Plücker relations, the
//! axioms of a chirotope. If a session breaks a law, no point set has its answers.
//!
//! * [`antisymmetry`], [`transitivity`], [`never_zero`]: within one predicate.
//! * [`Relation`]: Grassmann-Plücker relations, within one predicate or, through points at infinity, between a
//!   predicate and those of fewer dimensions.
//! * [`independence_of_place`], [`independence_of_later_vertices`]: an answer depends on its vertices only, not on
//!   other queries or later vertices.
//! * [`equals_reference`]: the only law here that needs the exact answer.
//!
//! Functions that end in `_of_all`, and [`Relation::check_all`], check many tuples in batches: a session may be a
//! program at the other end of a pipe, where each query is a message.
//!
//! # The meaning of a zero
//! * [`ZeroMeaning::Exact`] and [`ZeroMeaning::Never`]: a zero is a sign like the others, that of a determinant which
//!   vanishes. (A session that breaks ties still answers zero for repeated vertices, which is correct.)
//! * [`ZeroMeaning::Band`]: a zero means "too close to decide", and the answer within the band may differ from one
//!   order of arguments to the next. So zeros break no law, and laws are checked between non-zero answers only.

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

/// A law that answers can break.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Law {
    /// A session that breaks ties never answers zero for distinct vertices.
    NeverZero,
    /// A permutation of the arguments multiplies the sign by its parity.
    Antisymmetry,
    /// The order along an axis is transitive.
    Transitivity,
    /// The three-term Grassmann-Plücker relation of one predicate.
    GrassmannPlucker,
    /// The three-term relation with points at infinity, which links a predicate to those of fewer dimensions.
    MixedGrassmannPlucker,
    /// An answer does not depend on other queries in the same batch.
    Place,
    /// An answer does not depend on vertices numbered after its own.
    LaterVertices,
    /// An answer equals the exact sign, where the exact sign is not zero.
    Reference,
}

impl Law {
    /// All laws, in the order of reports.
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

    /// The law's name in CSV files and reports.
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

/// The meaning of zero in a session, for each predicate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Zeros([ZeroMeaning; PredicateKind::ALL.len()]);

impl Zeros {
    /// The meanings of zero that the contracts of a backend declare.
    #[must_use]
    pub fn promised(contract: impl Fn(PredicateKind) -> Contract) -> Zeros {
        Zeros(PredicateKind::ALL.map(|kind| contract(kind).zero))
    }

    /// The meaning of a zero of this predicate.
    #[must_use]
    pub fn of(self, kind: PredicateKind) -> ZeroMeaning {
        // Laws between predicates have no formulas in them; a formula has the meaning of the turn.
        self.0[if let PredicateKind::Derived(_) = kind { PredicateKind::Orient2d.index() } else { kind.index() }]
    }
}

/// Gives all predicates the same meaning of zero.
impl From<ZeroMeaning> for Zeros {
    fn from(zero: ZeroMeaning) -> Zeros {
        Zeros([zero; PredicateKind::ALL.len()])
    }
}

/// A query with its answer.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Answer {
    /// The question of the query.
    pub question: Question,
    /// The arguments, in the order of the query.
    pub args: Vec<Vertex>,
    /// The sign that the session returned.
    pub sign: Sign,
}

/// Answers that contradict each other.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Violation {
    /// The law that the answers break.
    pub law: Law,
    /// The queries that cannot all be right, with their answers.
    pub answers: Vec<Answer>,
}

impl std::fmt::Display for Violation {
    /// Writes one line: the law, and each query with its answer.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} broken", self.law.name())?;
        for (at, Answer { question, args, sign }) in self.answers.iter().enumerate() {
            write!(f, "{} {} = {sign}", if at == 0 { ":" } else { "," }, question.query(args))?;
        }
        Ok(())
    }
}

/// True if a zero means "undecided", so that no law applies to it.
fn says_nothing(sign: Sign, zero: ZeroMeaning) -> bool {
    zero == ZeroMeaning::Band && sign.is_zero()
}

/// True if the vertices are distinct.
fn are_distinct(args: &[Vertex]) -> bool {
    args.iter().enumerate().all(|(at, v)| !args[..at].contains(v))
}
