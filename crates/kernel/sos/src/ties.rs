//! The breaking of a tie by a term list.
//!
//! [`Session`](crate::Session) uses these parts. They are public for experiments and planted faults. Three examples
//! make a wrong backend from right parts: a table with one sign swapped, a sorting whose parity is dropped, and
//! arguments in their given order, as if positions were identities.

use predicament_predicates::{Axis, Plane, Predicates, Question, Scene, Sign, Vertex};

use crate::{
    Term,
    lift::{Lifted, PLACES},
};

/// Vertices in the order of their identity.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Sorted<const N: usize> {
    /// The vertices, ascending.
    pub vertices: [Vertex; N],
    /// The sign of the permutation that sorts the vertices.
    ///
    /// A determinant of the sorted rows times this sign is the determinant of the rows as given.
    pub parity: Sign,
}

impl<const N: usize> Sorted<N> {
    /// Sorts the vertices; `None` if a vertex occurs twice.
    ///
    /// Two equal rows stay equal under every perturbation, so the perturbed determinant is zero as well.
    #[inline]
    #[must_use]
    pub fn new(mut vertices: [Vertex; N]) -> Option<Sorted<N>> {
        // Without branches: the order of arguments is unpredictable.
        let mut odd = false;
        for end in (1..N).rev() {
            for i in 0..end {
                let (a, b) = (vertices[i], vertices[i + 1]);
                odd ^= a > b;
                vertices[i] = a.min(b);
                vertices[i + 1] = a.max(b);
            }
        }
        let distinct = vertices.windows(2).fold(true, |distinct, pair| distinct & (pair[0] != pair[1]));
        let parity = if odd { Sign::Negative } else { Sign::Positive };
        distinct.then_some(Sorted { vertices, parity })
    }
}

/// The first nonzero term: its sign, and its place in `terms`.
///
/// `rows[k]` is the vertex that the terms call row k: for a right answer, the k-th smallest of distinct vertices.
/// `None` if every term is zero, which can happen only for a list that has lost its last, constant term.
///
/// `signs` must answer exactly; it evaluates the minors that are predicates of fewer dimensions.
///
/// # Panics
/// If a term names a row or column that the question doesn't have.
#[must_use]
pub fn decide<P: Predicates>(signs: &P, question: Question, terms: &[Term], rows: &[Vertex]) -> Option<(Sign, usize)> {
    let (axes, orientation) = columns(question);
    let lifted = Lifted::new(signs.scene(), axes, rows);
    let twins = Twins::new(signs.scene(), axes, rows);
    let sign_of = |term: &Term| {
        if twins.are_among(term.rows) { Sign::Zero } else { coefficient(signs, axes, term, rows, &lifted) }
    };
    let (place, sign) = terms.iter().map(sign_of).enumerate().find(|(_, sign)| !sign.is_zero())?;
    Some((sign * orientation, place))
}

/// Rows with equal coordinates: the most frequent tie.
///
/// Many terms are zero for that reason and need not be evaluated.
struct Twins {
    /// For each row, the first one with the same coordinates.
    firsts: [u8; PLACES],
}

impl Twins {
    fn new(scene: &Scene, axes: &[Axis], rows: &[Vertex]) -> Twins {
        let mut firsts = [0, 1, 2, 3, 4];
        // (A constructed vertex has no coordinates to compare.)
        let are_equal = |a: Vertex, b: Vertex| {
            let is_input = !a.is_constructed() & !b.is_constructed();
            is_input && axes.iter().all(|&axis| scene.coordinate(axis, a) == scene.coordinate(axis, b))
        };
        for (row, &vertex) in rows.iter().enumerate().skip(1) {
            if let Some(first) = rows[..row].iter().position(|&earlier| are_equal(earlier, vertex)) {
                firsts[row] = firsts[first];
            }
        }
        Twins { firsts }
    }

    /// Returns true if two of these rows are equal, so that every minor of them is zero.
    fn are_among(&self, rows: &[u8]) -> bool {
        let mut seen = 0_u8;
        rows.iter().any(|&row| {
            let bit = 1 << self.firsts[usize::from(row)];
            let is_twin = seen & bit != 0;
            seen |= bit;
            is_twin
        })
    }
}

/// The axes behind the columns, ascending as in the tables, and the sign of that permutation.
///
/// The plane zx is the mirror image of xz.
pub(crate) fn columns(question: Question) -> (&'static [Axis], Sign) {
    match question {
        Question::Compare(Axis::X) => (&[Axis::X], Sign::Positive),
        Question::Compare(Axis::Y) => (&[Axis::Y], Sign::Positive),
        Question::Compare(Axis::Z) => (&[Axis::Z], Sign::Positive),
        Question::Orient2d(Plane::Xy) | Question::Incircle => (&[Axis::X, Axis::Y], Sign::Positive),
        Question::Orient2d(Plane::Yz) => (&[Axis::Y, Axis::Z], Sign::Positive),
        Question::Orient2d(Plane::Zx) => (&[Axis::X, Axis::Z], Sign::Negative),
        Question::Orient3d | Question::Insphere => (&[Axis::X, Axis::Y, Axis::Z], Sign::Positive),
        Question::Derived(_) => panic!("{} has terms of its own", question.kind()),
    }
}

fn coefficient<P: Predicates>(signs: &P, axes: &[Axis], term: &Term, rows: &[Vertex], lifted: &Lifted<'_>) -> Sign {
    let vertex = |row: u8| rows[usize::from(row)];
    let gap = match term.gap {
        Some(gap) => signs.compare(axes[usize::from(gap.column)], vertex(gap.from), vertex(gap.to)),
        None => Sign::Positive,
    };
    if gap.is_zero() {
        return gap;
    }
    let minor = match term.lift {
        Some(lift) => lifted.sign(term.rows, term.columns, lift),
        None => linear(signs, axes, term, vertex),
    };
    term.sign * gap * minor
}

/// The sign of a minor of coordinates and ones, which is a predicate of a projection.
fn linear<P: Predicates>(signs: &P, axes: &[Axis], term: &Term, vertex: impl Fn(u8) -> Vertex) -> Sign {
    match (term.rows, term.columns) {
        (&[_], &[]) => Sign::Positive,
        (&[a, b], &[x]) => signs.compare(axes[usize::from(x)], vertex(a), vertex(b)),
        (&[a, b, c], &[x, y]) => {
            let Some((plane, orientation)) = projection(axes[usize::from(x)], axes[usize::from(y)]) else {
                panic!("the columns of {term:?} don't ascend");
            };
            signs.orient2d(plane, vertex(a), vertex(b), vertex(c)) * orientation
        }
        (&[a, b, c, d], &[_, _, _]) => signs.orient3d(vertex(a), vertex(b), vertex(c), vertex(d)),
        _ => panic!("{term:?} is no minor"),
    }
}

/// The plane of two ascending axes, and the sign of the predicate there.
///
/// The plane zx is the mirror image of xz.
#[inline(always)]
pub(crate) const fn projection(x: Axis, y: Axis) -> Option<(Plane, Sign)> {
    match (x, y) {
        (Axis::X, Axis::Y) => Some((Plane::Xy, Sign::Positive)),
        (Axis::Y, Axis::Z) => Some((Plane::Yz, Sign::Positive)),
        (Axis::X, Axis::Z) => Some((Plane::Zx, Sign::Negative)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use predicament_predicates::Dimension;

    use super::*;

    #[test]
    fn rows_with_the_coordinates_of_another_are_twins() {
        // Rows 0 and 2 coincide, and so do 1, 3 and 4.
        let points = vec![1.0, 2.0, 3.0, 4.0, 1.0, 2.0, 3.0, 4.0, 3.0, 4.0, 1.0, 4.0];
        let scene = Scene::new(Dimension::Two, points).unwrap();
        let twins = |axes: &[Axis], rows: &[usize]| {
            let rows: Vec<Vertex> = rows.iter().map(|&row| Vertex::input(row)).collect();
            Twins::new(&scene, axes, &rows)
        };
        let both = [Axis::X, Axis::Y];
        let all = twins(&both, &[0, 1, 2, 3, 4]);
        assert_eq!(all.firsts, [0, 1, 0, 1, 1]);
        for (rows, are) in [
            (&[0, 1][..], false),
            (&[0, 2], true),
            (&[1, 2, 3], true),
            (&[0, 3, 4], true),
            (&[2, 4], false),
            (&[1], false),
            (&[], false),
        ] {
            assert_eq!(all.are_among(rows), are, "{rows:?}");
        }
        // One coordinate in common is not enough, unless the other is ignored.
        assert_eq!(twins(&both, &[0, 1, 5]).firsts, [0, 1, 2, 3, 4]);
        assert_eq!(twins(&[Axis::X], &[0, 1, 5]).firsts, [0, 1, 0, 3, 4]);
        assert_eq!(twins(&[Axis::Y], &[0, 1, 5]).firsts, [0, 1, 1, 3, 4]);
        // A constructed vertex has no known position.
        let constructed = [Vertex::input(0), Vertex::constructed(0), Vertex::constructed(0)];
        assert_eq!(Twins::new(&scene, &both, &constructed).firsts, [0, 1, 2, 3, 4]);
    }

    #[test]
    fn sorting_counts_exchanges() {
        let sorted = |at: [usize; 4]| Sorted::new(at.map(Vertex::input));
        let ascending = [1, 4, 6, 9].map(Vertex::input);
        for (at, parity) in [
            ([1, 4, 6, 9], Sign::Positive),
            ([4, 1, 6, 9], Sign::Negative),
            ([4, 6, 1, 9], Sign::Positive),
            ([9, 6, 4, 1], Sign::Positive),
            ([9, 1, 4, 6], Sign::Negative),
        ] {
            assert_eq!(sorted(at), Some(Sorted { vertices: ascending, parity }), "{at:?}");
        }
        for at in [[1, 1, 2, 3], [1, 2, 1, 3], [3, 2, 1, 3], [2, 3, 3, 1]] {
            assert_eq!(sorted(at), None, "{at:?}");
        }
    }
}
