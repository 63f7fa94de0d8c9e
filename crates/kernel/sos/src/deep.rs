//! Ties that the leading terms leave open: the rest of each list, without terms that are zero for equal points.
//!
//! A term with two rows of one point is zero. So for each pair of equal rows a mask says which terms remain. The terms
//! that all masks keep are evaluated, in doubles first, on a copy of the points in the order of their vertices.

use predicament_predicates::{Axis, PredicateKind, Predicates, Scene, Sign, Vertex};

use crate::filter;
use crate::lift::Lifted;
use crate::ties::{Sorted, projection};
use crate::{Scheme, Term};

/// Pairs of up to five rows.
const PAIRS: [[u8; 2]; 10] = [[0, 1], [0, 2], [1, 2], [0, 3], [1, 3], [2, 3], [0, 4], [1, 4], [2, 4], [3, 4]];

/// For each pair of rows, the terms of a list that do not have both of them, as a bit mask.
type Masks = [u64; PAIRS.len()];

const fn masks(terms: &[Term]) -> Masks {
    assert!(terms.len() <= 64, "a bit for each term");
    let mut masks = [0; PAIRS.len()];
    let mut place = 0;
    while place < terms.len() {
        let mut rows = 0_u8;
        let mut at = 0;
        while at < terms[place].rows.len() {
            rows += 1 << terms[place].rows[at]; // (no row twice)
            at += 1;
        }
        let mut pair = 0;
        while pair < PAIRS.len() {
            let both = (1 << PAIRS[pair][0]) + (1 << PAIRS[pair][1]);
            if rows & both != both {
                masks[pair] |= 1 << place;
            }
            pair += 1;
        }
        place += 1;
    }
    masks
}

/// The masks of each scheme's lists, for predicates of many terms.
static MASKS: [[Masks; PredicateKind::ALL.len()]; Scheme::ALL.len()] = {
    let mut all = [[[0; PAIRS.len()]; PredicateKind::ALL.len()]; Scheme::ALL.len()];
    let mut scheme = 0;
    while scheme < all.len() {
        let mut kind = 0;
        while kind < all[scheme].len() {
            all[scheme][kind] = masks(Scheme::ALL[scheme].terms(PredicateKind::ALL[kind]));
            kind += 1;
        }
        scheme += 1;
    }
    all
};

/// The first nonzero term from a place on: its sign, and its place in the list of the scheme.
///
/// `None` if a vertex occurs twice or is not an input vertex. `all` are the scene's points, `exact` answers exactly,
/// and minors may be exact in doubles.
#[inline(never)]
pub(crate) fn decide<const D: usize, const N: usize>(
    scheme: Scheme,
    kind: PredicateKind,
    exact: &predicament_exact::Session<'_, predicament_predicates::Off>,
    all: &[[f64; D]],
    args: [Vertex; N],
    is_exact: bool,
    from: usize,
) -> Option<(Sign, usize)> {
    let Sorted { vertices, parity } = Sorted::new(args)?;
    let mut points = [[0.0; D]; N];
    for (point, v) in points.iter_mut().zip(vertices) {
        *point = *all.get(v.index())?;
    }
    let terms = scheme.terms(kind);
    let mut left = u64::MAX >> (64 - terms.len()) & u64::MAX << from;
    for ([i, j], mask) in PAIRS.into_iter().zip(&MASKS[scheme as usize][kind.index()]) {
        if usize::from(j) < N && points[usize::from(i)] == points[usize::from(j)] {
            left &= mask;
        }
    }
    let asked = Asked { exact, scene: exact.scene(), vertices: &vertices, points: &points, is_exact };
    while left != 0 {
        let place = left.trailing_zeros() as usize;
        let sign = asked.coefficient(&terms[place]);
        if !sign.is_zero() {
            return Some((sign * parity, place));
        }
        left &= left - 1;
    }
    None
}

/// The sorted vertices of a tie, and their points.
struct Asked<'a, const D: usize> {
    exact: &'a predicament_exact::Session<'a, predicament_predicates::Off>,
    scene: &'a Scene,
    vertices: &'a [Vertex],
    points: &'a [[f64; D]],
    /// True if doubles make no error in minors.
    is_exact: bool,
}

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

impl<const D: usize> Asked<'_, D> {
    fn coefficient(&self, term: &Term) -> Sign {
        let order = |column: u8, from: u8, to: u8| {
            let [p, q] = [from, to].map(|row| self.points[usize::from(row)][usize::from(column)]);
            filter::order(p, q)
        };
        let gap = term.gap.map_or(Sign::Positive, |gap| order(gap.column, gap.from, gap.to));
        if gap.is_zero() {
            return gap;
        }
        let vertex = |row: u8| self.vertices[usize::from(row)];
        let minor = match (term.rows, term.columns, term.lift) {
            (rows, columns, Some(lift)) => {
                // An origin that is not a vertex may be anywhere.
                let is_free =
                    (0..D).any(|axis| lift.about[axis].is_none() && !columns.iter().any(|&x| usize::from(x) == axis));
                let sign = if self.is_exact && !is_free {
                    filter::lifted::<true, _>(self.points, rows, columns, lift)
                } else {
                    filter::lifted::<false, _>(self.points, rows, columns, lift)
                };
                sign.unwrap_or_else(|| Lifted::new(self.scene, &AXES[..D], self.vertices).sign(rows, columns, lift))
            }
            (&[_], &[], None) => Sign::Positive,
            (&[a, b], &[x], None) => order(x, a, b),
            (&[a, b, c], &[x, y], None) => {
                let [i, j] = [x, y].map(usize::from);
                let flat = [a, b, c].map(|row| {
                    let point = &self.points[usize::from(row)];
                    [point[i], point[j]]
                });
                let sign = if self.is_exact { filter::turn::<true>(flat) } else { filter::turn::<false>(flat) };
                sign.unwrap_or_else(|| {
                    let (plane, orientation) = projection(AXES[i], AXES[j]).expect("columns ascend");
                    self.exact.decide_orient2d(plane, vertex(a), vertex(b), vertex(c)).0 * orientation
                })
            }
            (&[a, b, c, d], &[_, _, _], None) => {
                self.exact.decide_orient3d(vertex(a), vertex(b), vertex(c), vertex(d)).0
            }
            _ => panic!("{term:?} is no minor"),
        };
        term.sign * gap * minor
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn masks_leave_the_terms_without_both_rows() {
        let mut left_out = 0;
        for scheme in Scheme::ALL {
            for kind in PredicateKind::ALL {
                let terms = scheme.terms(kind);
                for (pair, [i, j]) in PAIRS.into_iter().enumerate() {
                    let mask = MASKS[scheme as usize][kind.index()][pair];
                    for (place, term) in terms.iter().enumerate() {
                        let has_both = term.rows.contains(&i) && term.rows.contains(&j);
                        assert_eq!(mask >> place & 1 == 0, has_both, "{scheme:?}, {kind:?}, {i} and {j}, term {place}");
                        left_out += usize::from(has_both);
                    }
                    assert_eq!(mask.checked_shr(u32::try_from(terms.len()).unwrap()).unwrap_or(0), 0);
                }
            }
        }
        assert!(left_out > 100, "{left_out}");
    }
}
