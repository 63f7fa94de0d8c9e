//! The rows of an audit: an algorithm, a precision, and a form of Algorithms 3 and 8.

use predicament_contacts::checks::audit::{PairKind, Symbol};
use predicament_predicates::Dimension;
use predicament_tolerance::Misscaled;

use crate::Precision;

/// One of the paper's algorithms on pairs: 2 to 5 in the plane, 7 to 12 in space.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Algorithm {
    /// The dimension of its space.
    pub dimension: Dimension,
    /// The pairs that it decides.
    pub kind: PairKind,
}

impl Algorithm {
    /// All ten, in the order of their numbers.
    pub fn all() -> impl Iterator<Item = Algorithm> {
        let of = |dimension: Dimension| {
            let fits = move |kind: &PairKind| kind.ranks().map(usize::from).iter().sum::<usize>() <= dimension.count();
            PairKind::ALL.into_iter().filter(fits).map(move |kind| Algorithm { dimension, kind })
        };
        of(Dimension::Two).chain(of(Dimension::Three))
    }

    /// Its number in the paper.
    #[must_use]
    pub const fn number(self) -> u8 {
        let first = match self.dimension {
            Dimension::Two => 2,
            Dimension::Three => 7,
        };
        first + self.kind as u8
    }

    /// Whether Algorithm 3 or 8 is asked about its pair or a sub-pair.
    #[must_use]
    pub fn has_edges(self) -> bool {
        self.kind != PairKind::VertexVertex
    }
}

/// Which form of Algorithms 3 and 8 decides edges with vertices, and by which tolerances.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    /// û = B − A.
    Corrected,
    /// û = A − B.
    AsPrinted,
    /// û = B − A, and a tolerance that is not the paper's.
    Misscaled(Misscaled),
}

/// One stream of decisions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Row {
    /// The algorithm.
    pub algorithm: Algorithm,
    /// The binary format that it runs in.
    pub precision: Precision,
    /// The form of the algorithm that decides edges with vertices.
    pub form: Form,
}

impl Form {
    /// What is wrong with its tolerances, `corrected` if nothing.
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
    /// Whether a tolerance is one that the row's form has wrong; every one where it has none wrong.
    #[must_use]
    pub fn concerns(self, symbol: Symbol) -> bool {
        match self.form {
            Form::Corrected | Form::AsPrinted => true,
            Form::Misscaled(misscaled) => {
                misscaled.dimension == self.algorithm.dimension && misscaled.symbol == symbol.name()
            }
        }
    }

    /// `corrected`; `as printed` where the algorithm itself is, and else which
    /// printed algorithm is asked about its sub-pairs.
    #[must_use]
    pub fn variant(self) -> &'static str {
        match (self.form, self.algorithm.kind, self.algorithm.dimension) {
            (Form::Corrected | Form::Misscaled(_), ..) | (Form::AsPrinted, PairKind::EdgeVertex, _) => self.form.name(),
            (Form::AsPrinted, _, Dimension::Two) => "over printed 3",
            (Form::AsPrinted, _, Dimension::Three) => "over printed 8",
        }
    }
}

/// All rows: each algorithm in both precisions, and again over the printed
/// form where that is asked at all.
#[must_use]
pub fn rows() -> Vec<Row> {
    let with = |form: Form| {
        let algorithms = Algorithm::all().filter(move |algorithm| form == Form::Corrected || algorithm.has_edges());
        algorithms.flat_map(move |algorithm| Precision::ALL.map(|precision| Row { algorithm, precision, form }))
    };
    with(Form::Corrected).chain(with(Form::AsPrinted)).collect()
}
