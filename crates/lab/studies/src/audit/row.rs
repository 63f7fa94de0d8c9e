//! The rows of an audit: an algorithm, a precision, and a form of Algorithms 3 and 8.

use predicament_contacts::checks::audit::{PairKind, Symbol};
use predicament_predicates::Dimension;
use predicament_tolerance::Misscaled;

use crate::Precision;

/// One of the paper's algorithms on pairs: 2 to 5 in the plane, 7 to 12 in space.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Algorithm {
    /// The dimension of the algorithm's space.
    pub dimension: Dimension,
    /// The kind of pairs that the algorithm decides.
    pub kind: PairKind,
}

impl Algorithm {
    /// All ten algorithms, in the order of their numbers.
    pub fn all() -> impl Iterator<Item = Algorithm> {
        let of = |dimension: Dimension| {
            let fits = move |kind: &PairKind| kind.ranks().map(usize::from).iter().sum::<usize>() <= dimension.count();
            PairKind::ALL.into_iter().filter(fits).map(move |kind| Algorithm { dimension, kind })
        };
        of(Dimension::Two).chain(of(Dimension::Three))
    }

    /// The algorithm's number in the paper.
    #[must_use]
    pub const fn number(self) -> u8 {
        let first = match self.dimension {
            Dimension::Two => 2,
            Dimension::Three => 7,
        };
        first + self.kind as u8
    }

    /// Returns true if Algorithm 3 or 8 decides its pair or a sub-pair.
    #[must_use]
    pub fn has_edges(self) -> bool {
        self.kind != PairKind::VertexVertex
    }
}

/// The form of Algorithms 3 and 8, which decide edges with vertices, and their tolerances.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    /// The corrected form, û = B − A.
    Corrected,
    /// The printed form, û = A − B.
    AsPrinted,
    /// The corrected form, with a tolerance that differs from the paper's.
    Misscaled(Misscaled),
}

/// One stream of decisions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Row {
    /// The algorithm.
    pub algorithm: Algorithm,
    /// The binary format of the computation.
    pub precision: Precision,
    /// The form of the algorithm that decides edges with vertices.
    pub form: Form,
}

impl Form {
    /// The name of its tolerances' fault, `corrected` if there is none.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Form::Corrected => "corrected",
            Form::AsPrinted => "as printed",
            Form::Misscaled(misscaled) => misscaled.name(),
        }
    }
}

impl Row {
    /// Returns true if the row's form has this tolerance wrong, or has no tolerance wrong.
    #[must_use]
    pub fn concerns(self, symbol: Symbol) -> bool {
        match self.form {
            Form::Corrected | Form::AsPrinted => true,
            Form::Misscaled(misscaled) => {
                misscaled.dimension == self.algorithm.dimension && misscaled.symbol == symbol.name()
            }
        }
    }

    /// The text `corrected`, `as printed`, or the printed algorithm that decides its sub-pairs.
    ///
    /// It is `as printed` if the algorithm itself has the printed form.
    #[must_use]
    pub fn variant(self) -> &'static str {
        match (self.form, self.algorithm.kind, self.algorithm.dimension) {
            (Form::Corrected | Form::Misscaled(_), ..) | (Form::AsPrinted, PairKind::EdgeVertex, _) => self.form.name(),
            (Form::AsPrinted, _, Dimension::Two) => "over printed 3",
            (Form::AsPrinted, _, Dimension::Three) => "over printed 8",
        }
    }
}

/// All rows: each algorithm in both precisions, and again with the printed form if that form decides anything.
#[must_use]
pub fn rows() -> Vec<Row> {
    let with = |form: Form| {
        let algorithms = Algorithm::all().filter(move |algorithm| form == Form::Corrected || algorithm.has_edges());
        algorithms.flat_map(move |algorithm| Precision::ALL.map(|precision| Row { algorithm, precision, form }))
    };
    with(Form::Corrected).chain(with(Form::AsPrinted)).collect()
}
