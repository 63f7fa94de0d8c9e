//! The names of the stages that settle queries: the exact backend's, those of constructed vertices, then one for each
//! term.

use predicament_exact::stage::NAMES as EXACT;
use predicament_predicates::{MAX_STAGES, PredicateKind};

use crate::Scheme;

/// The stages of ties about constructed vertices: the total degree of the deciding monomial.
const DEGREES: [&str; 4] = ["degree 1", "degree 2", "degree 3", "degree 4 or more"];

/// The index of the stage of a table's first term.
pub(crate) const FIRST_TERM: usize = EXACT.len() + DEGREES.len();

/// The stage of a tie about constructed vertices.
///
/// Degree 0, a constant, decides if the exact determinant is of a point that exists only after the move.
pub(crate) fn of_degree(degree: usize) -> usize {
    EXACT.len() + degree.clamp(1, DEGREES.len()) - 1
}

/// The stage of a tie that the term at this place decides; the last stage of the scheme if there are more terms.
#[cfg(feature = "formulas")]
pub(crate) fn of_term(scheme: Scheme, place: usize) -> usize {
    (FIRST_TERM + place).min(names(scheme).len() - 1)
}

#[rustfmt::skip]
const TERMS: [&str; 60] = [
    "term 1", "term 2", "term 3", "term 4", "term 5", "term 6", "term 7", "term 8", "term 9", "term 10",
    "term 11", "term 12", "term 13", "term 14", "term 15", "term 16", "term 17", "term 18", "term 19", "term 20",
    "term 21", "term 22", "term 23", "term 24", "term 25", "term 26", "term 27", "term 28", "term 29", "term 30",
    "term 31", "term 32", "term 33", "term 34", "term 35", "term 36", "term 37", "term 38", "term 39", "term 40",
    "term 41", "term 42", "term 43", "term 44", "term 45", "term 46", "term 47", "term 48", "term 49", "term 50",
    "term 51", "term 52", "term 53", "term 54", "term 55", "term 56", "term 57", "term 58", "term 59", "term 60",
];

static ALL: [&str; FIRST_TERM + TERMS.len()] = {
    let mut all = [""; FIRST_TERM + TERMS.len()];
    let mut i = 0;
    while i < all.len() {
        all[i] = if i < EXACT.len() {
            EXACT[i]
        } else if i < FIRST_TERM {
            DEGREES[i - EXACT.len()]
        } else {
            TERMS[i - FIRST_TERM]
        };
        i += 1;
    }
    all
};

/// All stages of a scheme: as many terms as its longest table has.
pub(crate) const fn names(scheme: Scheme) -> &'static [&'static str] {
    ALL.split_at(FIRST_TERM + longest(scheme)).0
}

const fn longest(scheme: Scheme) -> usize {
    let mut longest = 0;
    let mut i = 0;
    while i < PredicateKind::ALL.len() {
        let terms = scheme.terms(PredicateKind::ALL[i]).len();
        if terms > longest {
            longest = terms;
        }
        i += 1;
    }
    longest
}

// Every term has a separate stage.
const _: () = assert!(FIRST_TERM + longest(Scheme::PerCoordinate) <= MAX_STAGES);
const _: () = assert!(FIRST_TERM + longest(Scheme::EdelsbrunnerMucke) <= MAX_STAGES);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_are_named_after_what_decides() {
        for scheme in Scheme::ALL {
            let names = names(scheme);
            assert_eq!(names[..EXACT.len()], EXACT[..]);
            let degrees = [0, 1, 2, 3, 4, 5, 12].map(|degree| names[of_degree(degree)]);
            let [first, second, third, more] = DEGREES;
            assert_eq!(degrees, [first, first, second, third, more, more, more]);
            assert_eq!(names[FIRST_TERM], "term 1");
            let lists = PredicateKind::ALL.map(|kind| scheme.terms(kind).len());
            let most = lists.into_iter().max().unwrap();
            assert_eq!(names[names.len() - 1], format!("term {most}"), "of {lists:?}");
        }
    }
}
