//! The session type of all controls: a scene, and a way to compute determinants.

use predicament_lanes::{self as lanes, Along, View, Whole, Xy, Yz, Zx};
use predicament_predicates::{
    Axis, Construction, Declined, Derived, Dimension, Plane, PredicateKind, Predicates, Question, Refused, Scene, Sign,
    Tally, Vertex, answer_by,
};

use crate::determinant::Determinant;
use crate::rounded;

/// A control's arithmetic: a determinant for each predicate, and the number whose sign it answers.
pub(crate) trait Float:
    Determinant<1, 2> + Determinant<2, 3> + Determinant<3, 4> + Determinant<2, 4> + Determinant<3, 5> + Send + Sync
{
    /// True if batches use vector registers, for formulas without branches; else batches are loops over single queries.
    const IN_LANES: bool;

    /// True if formulas are evaluated: not for the predicates of a library.
    const EVALUATES_FORMULAS: bool = true;

    /// The number whose sign is the answer, computed from the determinant.
    #[inline(always)]
    fn value(&self, determinant: f64) -> f64 {
        determinant
    }
}

/// Answers a batch in vector registers. It is generic over the formula rather than over the session, since each formula
/// has two session types.
#[inline(never)]
fn in_lanes<F: Float + Determinant<D, N>, V: View<E, D>, const E: usize, const D: usize, const N: usize>(
    float: &F,
    points: &[[f64; E]],
    (queries, out): (&[[Vertex; N]], &mut [Sign]),
    elsewhere: &dyn Fn([Vertex; N]) -> Sign,
) {
    let value = |points| float.value(float.determinant(points));
    lanes::answer::<V, E, D, N>(points, queries, out, value, elsewhere);
}

/// A control, prepared for one scene.
pub struct Session<'s, F, T> {
    /// The scene, including vertices constructed during the session.
    scene: Scene,
    /// The scene's points, in the slice of its dimension; the other slice is empty.
    points2: &'s [[f64; 2]],
    points3: &'s [[f64; 3]],
    /// The coordinates of all vertices in scenes with constructed vertices: first the input vertices, then the
    /// constructed vertices as computed. Else empty.
    all: Vec<f64>,
    float: F,
    tally: T,
}

impl<'s, F, T> Session<'s, F, T> {
    pub(crate) fn new(scene: &'s Scene, float: F, tally: T) -> Session<'s, F, T> {
        let (points2, points3): (&[_], &[_]) = match scene.dimension() {
            Dimension::Two => (scene.coordinates().as_chunks().0, &[]),
            Dimension::Three => (&[], scene.coordinates().as_chunks().0),
        };
        let all = if scene.constructions().is_empty() { Vec::new() } else { rounded::all(scene) };
        Session { scene: scene.clone(), points2, points3, all, float, tally }
    }
}

/// A view of coordinates: those of input vertices only, or (`ALL`) of constructed vertices too. Scenes without
/// constructed vertices have no overhead.
#[derive(Clone, Copy)]
struct Points<'a, const ALL: bool> {
    dimension: Dimension,
    points2: &'a [[f64; 2]],
    points3: &'a [[f64; 3]],
    input: usize,
}

impl<const ALL: bool> Points<'_, ALL> {
    #[inline(always)]
    fn place(self, v: Vertex) -> usize {
        match v.construction() {
            Some(index) if ALL => self.input + index,
            _ => v.index(),
        }
    }

    #[inline(always)]
    fn coordinate(self, axis: Axis, v: Vertex) -> f64 {
        match self.dimension {
            Dimension::Two => self.points2[self.place(v)][axis.index()],
            Dimension::Three => self.points3[self.place(v)][axis.index()],
        }
    }

    // Always inlined: points that go through memory cost several times the determinant.

    #[inline(always)]
    fn flat<const N: usize>(self, plane: Plane, vertices: [Vertex; N]) -> [[f64; 2]; N] {
        let mut points = [[0.0; 2]; N];
        if let (Dimension::Two, Plane::Xy) = (self.dimension, plane) {
            for (point, v) in points.iter_mut().zip(vertices) {
                *point = self.points2[self.place(v)];
            }
        } else {
            let [x, y] = plane.axes().map(Axis::index);
            for (point, v) in points.iter_mut().zip(vertices) {
                let solid = self.points3[self.place(v)];
                *point = [solid[x], solid[y]];
            }
        }
        points
    }

    #[inline(always)]
    fn solid<const N: usize>(self, vertices: [Vertex; N]) -> [[f64; 3]; N] {
        let mut points = [[0.0; 3]; N];
        for (point, v) in points.iter_mut().zip(vertices) {
            *point = self.points3[self.place(v)];
        }
        points
    }
}

#[allow(private_bounds)] // the methods are private as well
impl<F: Float, T: Tally> Session<'_, F, T> {
    #[inline(always)]
    fn has_constructed(&self) -> bool {
        !self.all.is_empty()
    }

    #[inline(always)]
    fn input(&self) -> Points<'_, false> {
        let (points2, points3) = (self.points2, self.points3);
        Points { dimension: self.scene.dimension(), points2, points3, input: self.scene.len() }
    }

    #[inline(always)]
    fn all(&self) -> Points<'_, true> {
        let dimension = self.scene.dimension();
        let (points2, points3): (&[_], &[_]) = match dimension {
            Dimension::Two => (self.all.as_chunks().0, &[]),
            Dimension::Three => (&[], self.all.as_chunks().0),
        };
        Points { dimension, points2, points3, input: self.scene.len() }
    }

    /// The difference a − b, whose sign is the comparison.
    #[inline(always)]
    fn difference<const ALL: bool>(&self, points: Points<ALL>, axis: Axis, [a, b]: [Vertex; 2]) -> f64 {
        self.float.determinant([[points.coordinate(axis, a)], [points.coordinate(axis, b)]])
    }

    #[inline(always)]
    fn turn<const ALL: bool>(&self, points: Points<ALL>, plane: Plane, vertices: [Vertex; 3]) -> f64 {
        self.float.determinant(points.flat(plane, vertices))
    }

    #[inline(always)]
    fn side<const ALL: bool>(&self, points: Points<ALL>, vertices: [Vertex; 4]) -> f64 {
        self.float.determinant(points.solid(vertices))
    }

    // Kept out of line, for the sake of scenes without constructed vertices.

    #[inline(never)]
    fn difference_all(&self, axis: Axis, vertices: [Vertex; 2]) -> f64 {
        self.difference(self.all(), axis, vertices)
    }

    #[inline(never)]
    fn turn_all(&self, plane: Plane, vertices: [Vertex; 3]) -> f64 {
        self.turn(self.all(), plane, vertices)
    }

    #[inline(never)]
    fn side_all(&self, vertices: [Vertex; 4]) -> f64 {
        self.side(self.all(), vertices)
    }

    #[inline(never)]
    fn circle_all(&self, vertices: [Vertex; 4]) -> [[f64; 2]; 4] {
        self.all().flat(Plane::Xy, vertices)
    }

    /// Four points of a 2D scene.
    ///
    /// # Panics
    /// If the scene is 3D, where a circle through three points gives no side for a fourth; `supports` refuses it.
    #[inline(always)]
    fn circle(&self, vertices: [Vertex; 4]) -> [[f64; 2]; 4] {
        assert!(self.scene.dimension() == Dimension::Two, "incircle needs a 2D scene");
        if self.has_constructed() { self.circle_all(vertices) } else { self.input().flat(Plane::Xy, vertices) }
    }

    #[inline(always)]
    fn difference_of(&self, axis: Axis, vertices: [Vertex; 2]) -> f64 {
        if self.has_constructed() {
            return self.difference_all(axis, vertices);
        }
        self.difference(self.input(), axis, vertices)
    }

    #[inline(always)]
    fn turn_of(&self, plane: Plane, vertices: [Vertex; 3]) -> f64 {
        if self.has_constructed() {
            return self.turn_all(plane, vertices);
        }
        self.turn(self.input(), plane, vertices)
    }

    #[inline(always)]
    fn side_of(&self, vertices: [Vertex; 4]) -> f64 {
        if self.has_constructed() {
            return self.side_all(vertices);
        }
        self.side(self.input(), vertices)
    }

    #[inline(always)]
    fn settled(&self, kind: PredicateKind, determinant: f64) -> f64 {
        self.tally.settled(kind, 0);
        self.float.value(determinant)
    }

    /// The determinant of one of the five predicates. For a comparison it is the difference.
    ///
    /// # Panics
    /// For a wrong number of vertices, and for formulas.
    #[inline(always)]
    fn determinant_of(&self, question: Question, vertices: &[Vertex]) -> f64 {
        match (question, vertices) {
            (Question::Compare(axis), &[a, b]) => self.difference_of(axis, [a, b]),
            (Question::Orient2d(plane), &[a, b, c]) => self.turn_of(plane, [a, b, c]),
            (Question::Orient3d, &[a, b, c, d]) => self.side_of([a, b, c, d]),
            (Question::Incircle, &[a, b, c, d]) => self.float.determinant(self.circle([a, b, c, d])),
            (Question::Insphere, &[a, b, c, d, e]) => self.float.determinant(self.input().solid([a, b, c, d, e])),
            _ => unreachable!("{question:?} of {} vertices", vertices.len()),
        }
    }

    /// The number whose sign is the answer to one of the five predicates.
    #[inline(always)]
    pub(crate) fn value<const N: usize>(&self, question: Question, vertices: [Vertex; N]) -> f64 {
        self.settled(question.kind(), self.determinant_of(question, &vertices))
    }

    #[inline(always)]
    fn ask<const N: usize>(&self, question: Question, vertices: [Vertex; N]) -> Sign {
        Sign::of(self.value(question, vertices))
    }

    /// The value of a formula, in the order of operations of its program.
    fn formula_estimate(&self, derived: Derived, vertices: &[Vertex]) -> f64 {
        derived.with_points(&self.scene, vertices, |points| derived.formula().value(points))
    }
}

impl<F: Float, T: Tally> Predicates for Session<'_, F, T> {
    #[inline]
    fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Constructs vertices; every result becomes a vertex, even if it is not finite.
    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        if self.all.is_empty() {
            self.all.extend_from_slice(self.scene.coordinates());
        }
        let all = &mut self.all;
        let before = all.len();
        let vertices = self.scene.construct_all(definitions, |scene, vertex| {
            rounded::push(all, scene, scene.construction(vertex).expect("just constructed"));
            Ok(())
        });
        if vertices.is_err() {
            all.truncate(before);
        }
        vertices
    }

    answer_by!(ask);

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        if matches!(kind, PredicateKind::Derived(_)) {
            if !F::EVALUATES_FORMULAS {
                return Err(Declined::predicate(kind, "the library has five predicates and no formulas"));
            }
            if !self.scene.constructions().is_empty() {
                return Err(Declined::predicate(kind, "formulas are about input vertices, not about constructed ones"));
            }
        }
        self.scene.has_dimension_for(kind)
    }

    fn sign(&self, predicate: Derived, vertices: &[Vertex]) -> Sign {
        Sign::of(self.settled(PredicateKind::Derived(predicate), self.formula_estimate(predicate, vertices)))
    }

    /// The determinant; `None` for a wrong number of vertices. For a comparison it is the difference.
    fn estimate(&self, question: Question, args: &[Vertex]) -> Option<f64> {
        match question {
            Question::Derived(derived) => (F::EVALUATES_FORMULAS && args.len() == derived.formula().arity())
                .then(|| self.formula_estimate(derived, args)),
            question => (args.len() == question.kind().arity()).then(|| self.determinant_of(question, args)),
        }
    }

    fn rounded_point(&self, v: Vertex) -> Option<&[f64]> {
        let stride = self.scene.dimension().count();
        let start = stride * (self.scene.len() + v.construction()?);
        self.all.get(start..start + stride)
    }

    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        let one = |pair| self.difference_of(axis, pair);
        let kind = PredicateKind::Compare;
        match (self.scene.dimension(), axis) {
            (Dimension::Two, Axis::X) => self.compare_lanes::<Along<0>, 2>(self.points2, queries, out, one),
            (Dimension::Two, Axis::Y) => self.compare_lanes::<Along<1>, 2>(self.points2, queries, out, one),
            // There is no such axis: the first query reports it.
            (Dimension::Two, Axis::Z) => self.one_by_one(kind, queries, out, one),
            (Dimension::Three, Axis::X) => self.compare_lanes::<Along<0>, 3>(self.points3, queries, out, one),
            (Dimension::Three, Axis::Y) => self.compare_lanes::<Along<1>, 3>(self.points3, queries, out, one),
            (Dimension::Three, Axis::Z) => self.compare_lanes::<Along<2>, 3>(self.points3, queries, out, one),
        }
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        let one = |triple| self.turn_of(plane, triple);
        match (self.scene.dimension(), plane) {
            (Dimension::Two, Plane::Xy) => self.turn_lanes::<Whole, 2>(self.points2, queries, out, one),
            (_, Plane::Xy) => self.turn_lanes::<Xy, 3>(self.points3, queries, out, one),
            (_, Plane::Yz) => self.turn_lanes::<Yz, 3>(self.points3, queries, out, one),
            (_, Plane::Zx) => self.turn_lanes::<Zx, 3>(self.points3, queries, out, one),
        }
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let one = |quadruple| self.side_of(quadruple);
        self.many::<Whole, 3, 3, 4>(PredicateKind::Orient3d, self.points3, (queries, out), one);
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let one = |quadruple| self.float.determinant(self.circle(quadruple));
        self.many::<Whole, 2, 2, 4>(PredicateKind::Incircle, self.points2, (queries, out), one);
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        let one = |quintuple| self.float.determinant(self.input().solid(quintuple));
        self.many::<Whole, 3, 3, 5>(PredicateKind::Insphere, self.points3, (queries, out), one);
    }
}

#[allow(private_bounds)] // the methods are private as well
impl<F: Float, T: Tally> Session<'_, F, T> {
    fn compare_lanes<V: View<E, 1>, const E: usize>(
        &self,
        points: &[[f64; E]],
        queries: &[[Vertex; 2]],
        out: &mut [Sign],
        one: impl Fn([Vertex; 2]) -> f64,
    ) {
        self.many::<V, E, 1, 2>(PredicateKind::Compare, points, (queries, out), one);
    }

    fn turn_lanes<V: View<E, 2>, const E: usize>(
        &self,
        points: &[[f64; E]],
        queries: &[[Vertex; 3]],
        out: &mut [Sign],
        one: impl Fn([Vertex; 3]) -> f64,
    ) {
        self.many::<V, E, 2, 3>(PredicateKind::Orient2d, points, (queries, out), one);
    }

    /// Answers a batch, in vector registers if the formula supports them. The formula is used for points in view, and
    /// `one` for queries with other vertices.
    #[inline(always)]
    fn many<V: View<E, D>, const E: usize, const D: usize, const N: usize>(
        &self,
        kind: PredicateKind,
        points: &[[f64; E]],
        (queries, out): (&[[Vertex; N]], &mut [Sign]),
        one: impl Fn([Vertex; N]) -> f64,
    ) where
        F: Determinant<D, N>,
    {
        if !F::IN_LANES {
            return self.one_by_one(kind, queries, out, one);
        }
        let answered = queries.len().min(out.len()) as u64;
        let elsewhere = |query| Sign::of(self.float.value(one(query)));
        in_lanes::<F, V, E, D, N>(&self.float, points, (queries, out), &elsewhere);
        self.tally.settled_many(kind, 0, answered);
    }

    #[inline(always)]
    fn one_by_one<const N: usize>(
        &self,
        kind: PredicateKind,
        queries: &[[Vertex; N]],
        out: &mut [Sign],
        one: impl Fn([Vertex; N]) -> f64,
    ) {
        for (&query, out) in queries.iter().zip(out) {
            *out = Sign::of(self.settled(kind, one(query)));
        }
    }
}
