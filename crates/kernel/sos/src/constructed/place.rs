//! The simplest definition of a point of a question.
//!
//! Two lines through one vertex meet in that vertex, and two planes through two vertices meet in their line. A share of
//! one or zero is an end of its segment. If the point exists at all, its row is that of the simpler definition times a
//! factor, which the weight has as well; so the simpler definition gives the signs. Then the definitions alone prove
//! many determinants to be zero wherever the vertices are.

use predicament_predicates::{Construction, Question, Scene, Vertex};
use smallvec::SmallVec;

use crate::integer::Integer;

/// A point of a question: an input vertex, or the point where lines and planes meet.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Place {
    Input(Vertex),
    /// A construction; canonical, if the place is [`simple`](Place::simple).
    Meet(Construction),
}

impl Place {
    pub(super) fn of(scene: &Scene, v: Vertex) -> Place {
        v.construction().map_or(Place::Input(v), |index| Place::Meet(scene.constructions()[index]))
    }

    /// The simplest definition of a vertex that is a point of the given scene.
    pub(super) fn simple(scene: &Scene, v: Vertex) -> Place {
        match Place::of(scene, v) {
            Place::Input(v) => Place::Input(v),
            Place::Meet(construction) => simplified(construction.canonical()),
        }
    }

    /// The input vertices behind the place, as often as they occur.
    pub(super) fn vertices(&self) -> SmallVec<[Vertex; 9]> {
        match self {
            Place::Input(v) => SmallVec::from_slice(&[*v]),
            Place::Meet(construction) => construction.flats().flatten().copied().collect(),
        }
    }

    /// Returns true if the place is on the plane of three vertices by definition.
    pub(super) fn on_plane(&self, on: &[Vertex; 3]) -> bool {
        match self {
            Place::Input(v) => on.contains(v),
            Place::Meet(Construction::Lpi { line, plane }) => plane == on || common(line, on).len() == 2,
            Place::Meet(Construction::Ratio { ends, .. }) => common(ends, on).len() == 2,
            Place::Meet(Construction::Tpi(planes)) => planes.contains(on),
            Place::Meet(Construction::Ssi(_)) => false,
        }
    }

    /// Returns true if the place is on the line of two vertices by definition.
    fn on_line(&self, on: &[Vertex; 2]) -> bool {
        match self {
            Place::Input(v) => on.contains(v),
            Place::Meet(Construction::Ssi(lines)) => lines.contains(on),
            Place::Meet(Construction::Lpi { line, .. }) => line == on,
            Place::Meet(Construction::Ratio { ends, .. }) => ends == on,
            Place::Meet(Construction::Tpi(_)) => false,
        }
    }

    /// Returns true if a projection of the scene may move the point relative to the others.
    ///
    /// Lines and planes meet where their images meet. A share of a segment is a ratio of lengths, which a projection
    /// changes.
    pub(super) fn is_affine(&self) -> bool {
        matches!(self, Place::Meet(Construction::Ratio { .. }))
    }
}

fn common(a: &[Vertex], b: &[Vertex]) -> SmallVec<[Vertex; 3]> {
    a.iter().copied().filter(|v| b.contains(v)).collect()
}

/// The simplified form of a canonical construction.
///
/// A construction without a point, however the vertices move, is unchanged.
fn simplified(construction: Construction) -> Place {
    match construction {
        Construction::Ssi([first, second]) => {
            if let [v] = *common(&first, &second) {
                return Place::Input(v);
            }
        }
        Construction::Lpi { line, plane } => {
            if let [v] = *common(&line, &plane) {
                return Place::Input(v);
            }
        }
        Construction::Tpi([first, second, third]) => {
            match *common(&common(&first, &second), &third) {
                [] => {}
                [v] => return Place::Input(v),
                _ => return Place::Meet(construction),
            }
            for (a, b, plane) in [(first, second, third), (second, third, first), (third, first, second)] {
                if let [p, q] = *common(&a, &b) {
                    return simplified(Construction::Lpi { line: [p, q], plane }.canonical());
                }
            }
        }
        Construction::Ratio { ends: [a, c], share } => match share.fraction() {
            [1, 1] => return Place::Input(a),
            [0, _] => return Place::Input(c),
            _ => {}
        },
    }
    Place::Meet(construction)
}

/// Returns true if the definitions prove that the determinant of simple places is zero, wherever the input vertices
/// are.
///
/// The proof is by two names of one point, by places on a common line or plane, or by shares of segments. There may be
/// other reasons for zero.
pub(super) fn depend(question: Question, places: &[Place]) -> bool {
    let twice = (1..places.len()).any(|at| places[..at].contains(&places[at]));
    twice
        || shares_depend(places)
        || match question {
            Question::Orient2d(_) => collinear(places),
            Question::Orient3d => {
                let triples = (0..places.len()).any(|without| {
                    let three: SmallVec<[Place; 4]> =
                        places.iter().enumerate().filter(|(at, _)| *at != without).map(|(_, place)| *place).collect();
                    collinear(&three)
                });
                triples || coplanar(places)
            }
            Question::Compare(_) | Question::Incircle | Question::Insphere | Question::Derived(_) => false,
        }
}

/// Returns true if shares of segments and input vertices are dependent by their weights alone, as in Menelaus' theorem.
///
/// Let A have a row for each place: the weights of the input vertices in it. The determinant is that of A times the
/// rows of these vertices. So it is zero if the rows of A are dependent. Otherwise it is not zero for all vertices: the
/// product can be any matrix whose column of weights has the sums of A's rows.
///
/// Fewer than three shares are dependent only on a common line or plane, which [`depend`] finds by name.
fn shares_depend(places: &[Place]) -> bool {
    let shares = places.iter().filter(|place| place.is_affine()).count();
    if shares < 3 || !places.iter().all(|place| place.is_affine() || matches!(place, Place::Input(_))) {
        return false;
    }
    let mut vertices: SmallVec<[Vertex; 8]> = places.iter().flat_map(Place::vertices).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let mut rows: SmallVec<[Vec<Integer>; 4]> = places.iter().map(|place| weights(place, &vertices)).collect();
    while let Some(row) = rows.pop() {
        let Some(column) = row.iter().position(|weight| !weight.is_zero()) else { return true };
        for other in &mut rows {
            let factor = other[column].clone();
            for (x, weight) in other.iter_mut().zip(&row) {
                *x = &(&*x * &row[column]) - &(&factor * weight);
            }
        }
    }
    false
}

/// The weights of input vertices in an input vertex or in a share of a segment.
fn weights(place: &Place, vertices: &[Vertex]) -> Vec<Integer> {
    let weight = |&v: &Vertex| match *place {
        Place::Meet(Construction::Ratio { ends: [a, _], share }) if v == a => share.fraction()[0],
        Place::Meet(Construction::Ratio { ends: [_, c], share }) if v == c => share.rest().fraction()[0],
        Place::Input(input) => i64::from(v == input),
        Place::Meet(_) => 0,
    };
    vertices.iter().map(|v| Integer::from(weight(v))).collect()
}

/// Returns true if all places are on one line of two vertices, or of two planes.
fn collinear(places: &[Place]) -> bool {
    let on_all = |line: &[Vertex; 2]| places.iter().all(|place| place.on_line(line));
    // Input vertices alone are on no line, so one of the others names it.
    let on_one = places.iter().any(|place| match place {
        Place::Meet(Construction::Ssi(lines)) => lines.iter().any(on_all),
        Place::Meet(Construction::Lpi { line, .. }) => on_all(line),
        Place::Meet(Construction::Ratio { ends, .. }) => on_all(ends),
        Place::Meet(Construction::Tpi(_)) | Place::Input(_) => false,
    });
    on_one || planes_of_all(places).len() > 1
}

/// Returns true if all places are on one plane of three vertices.
fn coplanar(places: &[Place]) -> bool {
    !planes_of_all(places).is_empty()
}

/// The planes of three vertices that contain all places.
fn planes_of_all(places: &[Place]) -> SmallVec<[[Vertex; 3]; 4]> {
    let mut planes: SmallVec<[[Vertex; 3]; 12]> = SmallVec::new();
    let mut spanning: SmallVec<[Vertex; 8]> = SmallVec::new();
    for place in places {
        match place {
            Place::Input(v) => spanning.push(*v),
            Place::Meet(Construction::Lpi { line, plane }) => {
                spanning.extend_from_slice(line);
                planes.push(*plane);
            }
            Place::Meet(Construction::Tpi(of)) => planes.extend_from_slice(of),
            Place::Meet(Construction::Ratio { ends, .. }) => spanning.extend_from_slice(ends),
            Place::Meet(Construction::Ssi(_)) => {}
        }
    }
    // A plane without a name is spanned by vertices and lines with one.
    spanning.sort_unstable();
    spanning.dedup();
    for (i, &a) in spanning.iter().enumerate() {
        for (j, &b) in spanning.iter().enumerate().skip(i + 1) {
            planes.extend(spanning[j + 1..].iter().map(|&c| [a, b, c]));
        }
    }
    let mut of_all: SmallVec<[[Vertex; 3]; 4]> = SmallVec::new();
    for plane in planes {
        if !of_all.contains(&plane) && places.iter().all(|place| place.on_plane(&plane)) {
            of_all.push(plane);
        }
    }
    of_all
}

#[cfg(test)]
mod tests {
    use predicament_predicates::{Axis, Plane};

    use super::*;

    const fn v(index: usize) -> Vertex {
        Vertex::input(index)
    }

    fn input(index: usize) -> Place {
        Place::Input(v(index))
    }

    fn ssi(line: [usize; 2], other: [usize; 2]) -> Place {
        simplified(Construction::Ssi([line.map(v), other.map(v)]).canonical())
    }

    fn lpi(line: [usize; 2], plane: [usize; 3]) -> Place {
        simplified(Construction::Lpi { line: line.map(v), plane: plane.map(v) }.canonical())
    }

    fn ratio(ends: [usize; 2], share: &str) -> Place {
        simplified(Construction::Ratio { ends: ends.map(v), share: share.parse().unwrap() }.canonical())
    }

    /// The middle of a segment, by its vertices' digits.
    fn half(ends: &str) -> Place {
        let mut ends = ends.bytes().map(|digit| usize::from(digit - b'0'));
        ratio(std::array::from_fn(|_| ends.next().expect("two digits")), "1/2")
    }

    fn tpi(first: [usize; 3], second: [usize; 3], third: [usize; 3]) -> Place {
        simplified(Construction::Tpi([first.map(v), second.map(v), third.map(v)]).canonical())
    }

    #[test]
    fn lines_and_planes_with_common_vertices_have_simpler_points() {
        assert_eq!(ssi([3, 1], [1, 2]), input(1));
        assert_eq!(lpi([5, 2], [4, 5, 6]), input(5));
        assert_eq!(tpi([0, 1, 2], [4, 3, 0], [0, 5, 6]), input(0));
        for planes in
            [[[0, 1, 2], [2, 1, 3], [4, 5, 6]], [[4, 5, 6], [0, 1, 2], [1, 3, 2]], [[1, 2, 3], [6, 4, 5], [2, 0, 1]]]
        {
            let [first, second, third] = planes;
            assert_eq!(tpi(first, second, third), lpi([1, 2], [4, 5, 6]), "{planes:?}");
        }
        // Of two vertices of the third plane, one is on the line of the others.
        assert_eq!(tpi([0, 1, 2], [1, 2, 3], [2, 5, 6]), input(2));
        for place in [ssi([0, 1], [2, 3]), lpi([0, 1], [2, 3, 4]), tpi([0, 1, 2], [3, 4, 5], [0, 3, 6])] {
            assert!(matches!(place, Place::Meet(_)), "{place:?}");
        }
        assert_eq!([ratio([3, 1], "1"), ratio([3, 1], "0"), ratio([1, 3], "4/4")], [3, 1, 1].map(input));
        assert!(matches!(ratio([1, 3], "-1"), Place::Meet(_)));
        // No points: a line twice, a line in a plane, and planes with a common line.
        assert!(matches!(ssi([0, 1], [1, 0]), Place::Meet(_)));
        assert!(matches!(lpi([0, 1], [1, 2, 0]), Place::Meet(_)));
        assert!(matches!(tpi([0, 1, 2], [0, 1, 3], [0, 1, 4]), Place::Meet(_)));
    }

    #[test]
    fn places_depend_by_definition() {
        let turn = Question::Orient2d(Plane::Xy);
        let cases: &[(Question, &[Place], bool)] = &[
            (Question::Compare(Axis::X), &[lpi([0, 1], [2, 3, 4]), lpi([1, 0], [4, 3, 2])], true),
            (Question::Compare(Axis::X), &[lpi([0, 1], [2, 3, 4]), lpi([0, 1], [2, 3, 5])], false),
            (Question::Incircle, &[input(0), input(1), input(2), input(0)], true),
            (Question::Incircle, &[input(0), input(1), input(2), input(3)], false),
            // In the plane: a line, or two of them.
            (turn, &[input(0), input(1), ssi([0, 1], [2, 3])], true),
            (turn, &[ssi([2, 3], [0, 1]), input(1), ssi([0, 1], [4, 5])], true),
            (turn, &[ssi([2, 3], [0, 1]), ssi([0, 1], [6, 7]), ssi([4, 5], [0, 1])], true),
            (turn, &[input(0), input(2), ssi([0, 1], [2, 3])], false),
            (turn, &[ssi([2, 3], [0, 1]), input(1), ssi([0, 2], [4, 5])], false),
            (turn, &[input(0), input(1), input(2)], false),
            // Shares of segments: on the line of their ends.
            (turn, &[ratio([0, 1], "1/3"), input(1), input(0)], true),
            (turn, &[ratio([0, 1], "1/3"), ratio([1, 0], "1/3"), ratio([0, 1], "5/2")], true),
            (turn, &[ratio([0, 1], "1/3"), ssi([0, 1], [2, 3]), input(1)], true),
            (turn, &[ratio([0, 1], "1/2"), ratio([1, 2], "1/2"), ratio([0, 2], "1/2")], false),
            (Question::Compare(Axis::X), &[ratio([0, 1], "1/3"), ratio([1, 0], "2/3")], true),
            (Question::Compare(Axis::X), &[ratio([0, 1], "1/3"), ratio([1, 0], "1/3")], false),
            (Question::Orient3d, &[ratio([0, 1], "1/3"), ratio([1, 2], "1/3"), input(0), input(2)], true),
            (Question::Orient3d, &[ratio([0, 1], "1/3"), lpi([1, 2], [4, 5, 6]), input(0), input(2)], true),
            (Question::Orient3d, &[ratio([0, 1], "1/3"), ratio([1, 2], "1/3"), input(0), input(3)], false),
            // Menelaus' theorem: a line across the sides of a triangle, a plane across those of a quadrilateral.
            (turn, &[ratio([0, 1], "1/3"), ratio([1, 2], "1/3"), ratio([2, 0], "4/3")], true),
            (turn, &[ratio([0, 1], "1/3"), ratio([1, 2], "1/3"), ratio([2, 0], "5/4")], false),
            (Question::Orient3d, &["01", "12", "23", "03"].map(half), true),
            (Question::Orient3d, &["01", "12", "23", "13"].map(half), false),
            (Question::Orient3d, &[ratio([0, 1], "1/3"), ratio([0, 3], "1/3"), half("12"), half("23")], true),
            (Question::Orient3d, &[ratio([0, 1], "1/3"), ratio([0, 3], "2/3"), half("12"), half("23")], false),
            (Question::Orient3d, &[half("01"), half("12"), half("23"), lpi([0, 3], [4, 5, 6])], false),
            // In space: a named line, or the line of two planes.
            (turn, &[input(0), lpi([0, 1], [2, 3, 4]), input(1)], true),
            (turn, &[lpi([0, 1], [5, 6, 7]), lpi([0, 1], [2, 3, 4]), input(1)], true),
            (turn, &[lpi([0, 2], [5, 6, 7]), lpi([0, 1], [2, 3, 4]), input(1)], false),
            (turn, &[tpi([0, 1, 2], [3, 4, 5], [6, 7, 8]), lpi([0, 1], [3, 4, 5]), lpi([4, 5], [0, 1, 2])], true),
            (turn, &[tpi([0, 1, 2], [3, 4, 5], [6, 7, 8]), lpi([0, 1], [3, 4, 5]), lpi([4, 5], [0, 1, 6])], false),
            // Four places: three of them on a line, or all in a plane, named or not.
            (Question::Orient3d, &[input(5), input(0), lpi([0, 1], [2, 3, 4]), input(1)], true),
            (Question::Orient3d, &[input(0), input(0), input(1), input(2)], true),
            (Question::Orient3d, &[input(0), input(1), input(2), lpi([3, 4], [0, 1, 2])], true),
            (Question::Orient3d, &[input(0), input(1), input(3), lpi([3, 4], [0, 1, 2])], false),
            (
                Question::Orient3d,
                &[lpi([0, 1], [3, 4, 5]), lpi([1, 2], [3, 4, 5]), lpi([0, 2], [6, 7, 8]), input(1)],
                true,
            ),
            (
                Question::Orient3d,
                &[lpi([0, 1], [3, 4, 5]), lpi([1, 2], [3, 4, 6]), lpi([0, 6], [5, 7, 8]), input(1)],
                false,
            ),
            (Question::Orient3d, &[input(0), input(1), input(2), input(3)], false),
        ];
        for (question, places, expected) in cases {
            for turned in 0..places.len() {
                let mut places = places.to_vec();
                places.rotate_left(turned);
                assert_eq!(depend(*question, &places), *expected, "{question:?} of {places:?}");
            }
        }
    }
}
