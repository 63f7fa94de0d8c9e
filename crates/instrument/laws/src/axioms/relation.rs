//! The three-term Grassmann-Plücker relations, also through points at infinity.
//!
//! A predicate of r vertices is the determinant, the *bracket*, of r vectors: the rows (coordinates, lift, 1) of the
//! vertices, with the columns that the predicate uses. Let x stand for r − 2 vectors that all six brackets share. Then
//!
//! \[x a b\]\[x c d\] − \[x a c\]\[x b d\] + \[x a d\]\[x b c\] = 0.
//!
//! Three numbers that add up to zero are all zero, or two of them have opposite signs. This condition needs the signs
//! only.
//!
//! The determinant of directions from the origin is a bracket as well, of vectors without a 1. With x for the vertex
//! around which a, b, c, d lie, its relation says that their order around x is cyclic.
//!
//! # Points at infinity
//! A vector need not be a vertex. The unit vector of a column, the point at infinity in that direction, removes its row
//! and its column from a bracket. The remaining bracket belongs to a predicate of fewer dimensions:
//!
//! | predicate | struck | left | sign |
//! |---|---|---|---|
//! | orient2d (x, y, 1) | ∞y in front | compare in x | − |
//! | orient3d (x, y, z, 1) | ∞z in front | orient2d in xy | + |
//! | incircle (x, y, lift, 1) | ∞lift in front | orient2d in xy | + |
//! | insphere (x, y, z, lift, 1) | ∞lift in front | orient3d | − |
//!
//! A relation with one, two or three such vectors thus links predicates to each other. A perturbation of the
//! coordinates does not move points at infinity. A perturbation of the lift, as one more coordinate, does not move them
//! either. The relations therefore hold for every consistently perturbed scene. They fail if two predicates use
//! different perturbations; they exist to detect this.
//!
//! Removing a coordinate of a lifted predicate leaves no predicate (the lift is a sum over all coordinates), so only
//! ∞lift occurs there. Points at infinity among the shared vectors give relations of the remaining predicate.

use predicament_predicates::{Axis, Plane, Predicates, Question, Sign, Vertex};

use super::{Answer, Law, Violation, Zeros, says_nothing};

/// The direction of a point at infinity.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Direction {
    /// Along an axis.
    Axis(Axis),
    /// Along the lift of `incircle` and `insphere`.
    Lift,
}

impl std::fmt::Display for Direction {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Direction::Axis(Axis::X) => f.write_str("x"),
            Direction::Axis(Axis::Y) => f.write_str("y"),
            Direction::Axis(Axis::Z) => f.write_str("z"),
            Direction::Lift => f.write_str("lift"),
        }
    }
}

/// The maximum number of vectors in a bracket.
const ROWS: usize = 5;

/// A Grassmann-Plücker relation, applicable to any vertices.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Relation {
    question: Question,
    at_infinity: Vec<Direction>,
    vertices: usize,
    /// The factors of the three products, one after the other.
    brackets: [Bracket; 6],
}

/// A bracket with its points at infinity removed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Bracket {
    sign: Sign,
    /// The question, or `None` if only the 1 remains.
    question: Option<Question>,
    /// The indices of the question's vertices among the relation's; as many are used as the question takes.
    places: [u8; ROWS],
}

/// A vector of a bracket: one of the relation's vertices, or a point at infinity.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Vector {
    Vertex(u8),
    AtInfinity(Direction),
}

/// All relations that contain brackets of this predicate, starting with the relation without points at infinity.
///
/// Empty for a comparison, whose relations say that the order is transitive, and for formulas that are not
/// determinants.
#[must_use]
pub fn relations(question: Question) -> Vec<Relation> {
    let directions = directions(question);
    let subsets = (0_u32..1 << directions.len()).map(|subset| {
        let bits = directions.iter().enumerate().filter(|(bit, _)| subset >> bit & 1 == 1);
        bits.map(|(_, &direction)| direction).collect::<Vec<_>>()
    });
    let mut all: Vec<Relation> = subsets.filter_map(|at_infinity| Relation::new(question, &at_infinity)).collect();
    all.sort_by_key(|relation| relation.at_infinity.len());
    match question {
        Question::Compare(_) => Vec::new(),
        Question::Derived(derived) if !derived.formula().is_determinant() => Vec::new(),
        _ => all,
    }
}

impl Relation {
    /// The relation of brackets of this predicate in which a, b, … are points at infinity in these directions, each at
    /// most once, and all other vectors are vertices. `None` if one of its brackets is not a predicate.
    #[must_use]
    pub fn new(question: Question, at_infinity: &[Direction]) -> Option<Relation> {
        let shared = question.kind().arity() - 2;
        let twice = at_infinity.iter().enumerate().any(|(at, direction)| at_infinity[..at].contains(direction));
        if at_infinity.len() > 4 || twice {
            return None;
        }
        let mut vertices = (0_u8..).map(Vector::Vertex);
        let common: Vec<Vector> = vertices.by_ref().take(shared).collect();
        let others = at_infinity.iter().map(|&direction| Vector::AtInfinity(direction)).chain(vertices);
        let others: Vec<Vector> = others.take(4).collect();
        let pairs = [[0, 1], [2, 3], [0, 2], [1, 3], [0, 3], [1, 2]];
        let mut brackets = Vec::new();
        for pair in pairs {
            let vectors = [common.as_slice(), &pair.map(|at: usize| others[at])].concat();
            brackets.push(Bracket::new(question, vectors)?);
        }
        let vertices = shared + 4 - at_infinity.len();
        let brackets = brackets.try_into().ok()?;
        Some(Relation { question, at_infinity: at_infinity.to_vec(), vertices, brackets })
    }

    /// The law that the relation is a case of.
    #[must_use]
    pub fn law(&self) -> Law {
        if self.at_infinity.is_empty() { Law::GrassmannPlucker } else { Law::MixedGrassmannPlucker }
    }

    /// The predicate of the brackets, before rows and columns are struck.
    #[must_use]
    pub fn question(&self) -> Question {
        self.question
    }

    /// The points at infinity.
    #[must_use]
    pub fn at_infinity(&self) -> &[Direction] {
        &self.at_infinity
    }

    /// The number of vertices of the relation.
    #[must_use]
    pub fn vertices(&self) -> usize {
        self.vertices
    }

    /// All choices of the relation's vertices among the first n of a scene, and of the vertices among them that all
    /// brackets share. Other orders of the shared vertices or of the others give the same relation if the session is
    /// antisymmetric.
    pub fn tuples(&self, n: usize) -> impl Iterator<Item = Vec<Vertex>> + use<> {
        let (vertices, shared) = (self.vertices, self.question.kind().arity() - 2);
        choices(n, vertices).flat_map(move |chosen| {
            choices(vertices, shared).map(move |first| {
                let rest = (0..vertices).filter(|place| !first.contains(place));
                first.iter().copied().chain(rest).map(|place| Vertex::input(chosen[place])).collect()
            })
        })
    }

    /// The predicates that the relation queries.
    pub fn questions(&self) -> impl Iterator<Item = Question> {
        let asked: Vec<Question> = self.brackets.iter().filter_map(|bracket| bracket.question).collect();
        (0..asked.len())
            .filter(|&at| !asked[..at].contains(&asked[at]))
            .map(|at| asked[at])
            .collect::<Vec<_>>()
            .into_iter()
    }

    /// Checks the relation for these vertices, by querying all six brackets.
    ///
    /// # Panics
    /// If there are fewer than [`Relation::vertices`] vertices.
    pub fn check<P: Predicates + ?Sized>(&self, session: &P, vertices: &[Vertex], zeros: Zeros) -> Option<Violation> {
        let ask = |bracket: &Bracket| {
            let (question, args) = bracket.query(vertices)?;
            Some(question.ask(session, &args[..question.kind().arity()]))
        };
        self.violation(vertices, self.brackets.each_ref().map(ask), zeros)
    }

    /// Checks [`Relation::check`] for several tuples of vertices, with one batch per predicate.
    ///
    /// # Panics
    /// If a tuple has fewer than [`Relation::vertices`] vertices.
    pub fn check_all<P: Predicates + ?Sized>(
        &self,
        session: &P,
        tuples: &[Vec<Vertex>],
        zeros: Zeros,
    ) -> Vec<Option<Violation>> {
        let mut answers = vec![[None; 6]; tuples.len()];
        for question in self.questions() {
            let mut asked = Vec::new();
            let of_it = |bracket: &&Bracket| bracket.question == Some(question);
            for tuple in tuples {
                let args = self.brackets.iter().filter(of_it).filter_map(|bracket| bracket.query(tuple));
                args.for_each(|(_, args)| asked.extend_from_slice(&args[..question.kind().arity()]));
            }
            let mut signs = vec![Sign::Zero; asked.len() / question.kind().arity()];
            question.ask_batch(session, &asked, &mut signs);
            let places = answers.iter_mut().flat_map(|answers| answers.iter_mut().zip(&self.brackets));
            let places = places.filter(|(_, bracket)| of_it(bracket));
            places.zip(signs).for_each(|((place, _), sign)| *place = Some(sign));
        }
        tuples.iter().zip(answers).map(|(tuple, answers)| self.violation(tuple, answers, zeros)).collect()
    }

    /// The violation among the answers to the brackets that have a question.
    fn violation(&self, vertices: &[Vertex], answers: [Option<Sign>; 6], zeros: Zeros) -> Option<Violation> {
        let mut signs = [Sign::Zero; 6];
        for ((sign, bracket), answer) in signs.iter_mut().zip(&self.brackets).zip(answers) {
            *sign = bracket.sign;
            if let (Some(question), Some(answer)) = (bracket.question, answer) {
                if says_nothing(answer, zeros.of(question.kind())) {
                    return None;
                }
                *sign = *sign * answer;
            }
        }
        let terms = [signs[0] * signs[1], -(signs[2] * signs[3]), signs[4] * signs[5]];
        let balanced = terms.contains(&Sign::Positive) == terms.contains(&Sign::Negative);
        let answers = || {
            self.brackets.iter().zip(answers).filter_map(|(bracket, sign)| {
                let (question, args) = bracket.query(vertices)?;
                Some(Answer { question, args: args[..question.kind().arity()].to_vec(), sign: sign? })
            })
        };
        (!balanced).then(|| Violation { law: self.law(), answers: answers().collect() })
    }
}

/// Every choice of `size` numbers below `n`, ascending.
fn choices(n: usize, size: usize) -> impl Iterator<Item = Vec<usize>> {
    let mut next = (size <= n).then(|| (0..size).collect::<Vec<usize>>());
    std::iter::from_fn(move || {
        let choice = next.take()?;
        // The last number that can still grow grows by one, and the later numbers follow consecutively.
        if let Some(at) = (0..size).rev().find(|&at| choice[at] < n - size + at) {
            let mut following = choice.clone();
            (at..size).for_each(|place| following[place] = choice[at] + 1 + place - at);
            next = Some(following);
        }
        Some(choice)
    })
}

impl Bracket {
    /// The question and its vertices among the relation's, as many as the question takes; `None` if only the 1 remains.
    fn query(&self, vertices: &[Vertex]) -> Option<(Question, [Vertex; ROWS])> {
        Some((self.question?, self.places.map(|place| vertices[usize::from(place)])))
    }

    /// Strikes rows and columns until only vertices are left. Returns `None` if the remainder is not a predicate.
    fn new(question: Question, mut vectors: Vec<Vector>) -> Option<Bracket> {
        // The column of ones comes last and has no direction.
        let mut columns = directions(question);
        let mut sign = Sign::Positive;
        while let Some((row, direction)) = vectors.iter().enumerate().find_map(|(row, vector)| match vector {
            Vector::AtInfinity(direction) => Some((row, *direction)),
            Vector::Vertex(_) => None,
        }) {
            let column = columns.iter().position(|&column| column == direction)?;
            vectors.remove(row);
            columns.remove(column);
            if (row + column) % 2 == 1 {
                sign = -sign;
            }
        }
        let (left, orientation) = predicate(question, &columns)?;
        let mut places = [0; ROWS];
        for (place, vector) in places.iter_mut().zip(vectors) {
            let Vector::Vertex(vertex) = vector else { return None };
            *place = vertex;
        }
        Some(Bracket { sign: sign * orientation, question: left, places })
    }
}

/// The columns of a predicate's matrix; a column of ones follows them.
fn directions(question: Question) -> Vec<Direction> {
    use Direction::Lift;
    let axes: &[Axis] = match question {
        Question::Compare(axis) => return vec![Direction::Axis(axis)],
        Question::Orient2d(plane) => return plane.axes().map(Direction::Axis).into(),
        Question::Incircle => &[Axis::X, Axis::Y],
        Question::Orient3d | Question::Insphere => &[Axis::X, Axis::Y, Axis::Z],
        Question::Derived(_) => return Vec::new(),
    };
    let lift = question.kind().is_lifted().then_some(Lift);
    axes.iter().copied().map(Direction::Axis).chain(lift).collect()
}

/// The predicate with these columns, which remain of `of`'s, and the sign of sorting them into its order.
///
/// The question is `None` if only the 1 remains. Returns `None` if the columns are not a predicate's.
fn predicate(of: Question, columns: &[Direction]) -> Option<(Option<Question>, Sign)> {
    let left = match *columns {
        _ if columns == directions(of) => of,
        [] => return Some((None, Sign::Positive)),
        [Direction::Axis(axis)] => Question::Compare(axis),
        [Direction::Axis(x), Direction::Axis(y)] => {
            let planes = [Plane::Xy, Plane::Yz, Plane::Zx];
            let plane = planes.into_iter().find(|plane| plane.axes().contains(&x) && plane.axes().contains(&y))?;
            let orientation = if plane.axes() == [x, y] { Sign::Positive } else { Sign::Negative };
            return Some((Some(Question::Orient2d(plane)), orientation));
        }
        [Direction::Axis(_), Direction::Axis(_), Direction::Axis(_)] => Question::Orient3d,
        _ => return None,
    };
    Some((Some(left), Sign::Positive))
}

#[cfg(test)]
mod tests {
    use super::*;
    use predicament_exact::Exact;
    use predicament_predicates::{Backend, Dimension, Off, Scene};

    const FLAT: [Question; 2] = [Question::Orient2d(Plane::Xy), Question::Incircle];
    const SOLID: [Question; 5] = [
        Question::Orient2d(Plane::Xy),
        Question::Orient2d(Plane::Yz),
        Question::Orient2d(Plane::Zx),
        Question::Orient3d,
        Question::Insphere,
    ];

    /// Ten points with small integer coordinates, some of them equal.
    fn scene(dimension: Dimension) -> Scene {
        let places = 0_u32..u32::try_from(10 * dimension.count()).unwrap();
        let coordinates = places.map(|i| f64::from(i.wrapping_mul(2_654_435_761) >> 29) - 3.0).collect();
        Scene::new(dimension, coordinates).unwrap()
    }

    /// The determinant of a bracket with its points at infinity, along the first row.
    fn determinant(rows: &[Vec<i64>]) -> i64 {
        let Some((first, rest)) = rows.split_first() else { return 1 };
        let minor = |column: usize| {
            let without = |row: &Vec<i64>| [&row[..column], &row[column + 1..]].concat();
            determinant(&rest.iter().map(without).collect::<Vec<_>>())
        };
        let sign = |column: usize| if column.is_multiple_of(2) { 1 } else { -1 };
        (0..first.len()).map(|column| sign(column) * first[column] * minor(column)).sum()
    }

    #[allow(clippy::cast_possible_truncation)] // small integers
    fn row(scene: &Scene, question: Question, vector: Vector) -> Vec<i64> {
        let columns = directions(question);
        match vector {
            Vector::AtInfinity(at) => columns.iter().map(|&column| i64::from(column == at)).chain([0]).collect(),
            Vector::Vertex(v) => {
                let point: Vec<i64> = scene.point(Vertex::input(v.into())).iter().map(|&x| x as i64).collect();
                let entry = |column: &Direction| match column {
                    Direction::Axis(axis) => point[axis.index()],
                    Direction::Lift => point.iter().map(|x| x * x).sum(),
                };
                columns.iter().map(entry).chain([1]).collect()
            }
        }
    }

    /// Compares every bracket of every relation, as a predicate with a fixed sign, with the determinant of its vectors.
    #[test]
    fn brackets_have_the_sign_of_their_determinant() {
        for (dimension, questions) in [(Dimension::Two, &FLAT[..]), (Dimension::Three, &SOLID[..])] {
            let scene = scene(dimension);
            let session = Exact.prepare(&scene, Off).unwrap();
            for &question in questions {
                let arity = question.kind().arity();
                let infinite = directions(question).into_iter().map(Vector::AtInfinity);
                let some: Vec<Vector> = infinite.chain((0..6).map(Vector::Vertex)).collect();
                let mut asked = 0;
                // The step is coprime to the number of vectors, so that each vector occurs at each position.
                let step = if predicament_effort::whole() || arity < 4 { 1 } else { 17 };
                for word in (0..some.len().pow(u32::try_from(arity).unwrap())).step_by(step) {
                    let digit = |place: u32| word / some.len().pow(place) % some.len();
                    let vectors: Vec<Vector> = (0_u32..).take(arity).map(|place| some[digit(place)]).collect();
                    let Some(bracket) = Bracket::new(question, vectors.clone()) else { continue };
                    let rows: Vec<Vec<i64>> = vectors.iter().map(|&v| row(&scene, question, v)).collect();
                    let answer = bracket.question.map_or(Sign::Positive, |question| {
                        let args = bracket.places.map(|place| Vertex::input(place.into()));
                        question.ask(&session, &args[..question.kind().arity()])
                    });
                    assert_eq!(bracket.sign * answer, Sign::from(determinant(&rows).cmp(&0)), "{vectors:?}");
                    asked += 1;
                }
                assert!(asked > 100, "{asked} brackets of {question:?}");
            }
        }
    }

    #[test]
    fn relations_reach_down_to_the_predicates_that_can_be_left() {
        let shape = |question| {
            let all = relations(question);
            all.iter().map(|r| (r.at_infinity.len(), r.vertices, r.questions().count())).collect::<Vec<_>>()
        };
        let turns = [(0, 5, 1), (1, 4, 2), (1, 4, 2), (2, 3, 3)];
        assert_eq!(shape(Question::Orient2d(Plane::Zx)), turns);
        let sides = [(0, 6, 1), (1, 5, 2), (1, 5, 2), (1, 5, 2), (2, 4, 4), (2, 4, 4), (2, 4, 4), (3, 3, 6)];
        assert_eq!(shape(Question::Orient3d), sides);
        assert_eq!(shape(Question::Incircle), [(0, 6, 1), (1, 5, 2)]);
        assert_eq!(shape(Question::Insphere), [(0, 7, 1), (1, 6, 2)]);
        assert_eq!(shape(Question::Compare(Axis::X)), []);
        let formula = |name| shape(Question::Derived(predicament_predicates::Derived::named(name).unwrap()));
        assert_eq!((formula("orient_on_sphere"), formula("same_facing")), (vec![(0, 5, 1)], Vec::new()));
        let up = Direction::Lift;
        assert_eq!(Relation::new(Question::Incircle, &[up, up]), None, "two equal vectors");
        assert_eq!(Relation::new(Question::Orient3d, &[up]), None, "no such column");
    }

    #[test]
    fn tuples_are_all_there_and_different() {
        for (relation, count) in [(0, 1260), (1, 840), (3, 360)] {
            // C(10, 5) · 5, C(10, 4) · 4, C(10, 3) · 3
            let relation = &relations(Question::Orient2d(Plane::Xy))[relation];
            let tuples: std::collections::BTreeSet<Vec<Vertex>> = relation.tuples(10).collect();
            assert_eq!((tuples.len(), relation.tuples(10).count()), (count, count));
            assert!(tuples.iter().all(|tuple| super::super::are_distinct(tuple)));
        }
        // C(8, 6) · C(6, 2) and C(8, 7) · C(7, 3)
        assert_eq!(relations(Question::Orient3d)[0].tuples(8).count(), 28 * 15);
        assert_eq!(relations(Question::Insphere)[0].tuples(8).count(), 8 * 35);
        assert_eq!(relations(Question::Insphere)[0].tuples(6).count(), 0);
    }
}
