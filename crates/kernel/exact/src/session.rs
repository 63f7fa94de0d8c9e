//! The backend's session: the answers of a [`Decider`], tallied.
//!
//! Nothing else is generic over the tally, so a crate with its own tally compiles only this type.

use alloc::vec::Vec;
use predicament_predicates::{
    Axis, Construction, Declined, DefinitionError, Plane, PredicateKind, Predicates, Refused, Scene, Sessions, Sign,
    Tally, Vertex,
};

use crate::Exact;
use crate::batch::{Settled, Ties};
use crate::constructed::Constructed;
use crate::decider::{Decider, Filtered};

/// The exact backend's session, prepared for one scene.
pub struct Session<'s, T> {
    pub(crate) decider: Decider<'s>,
    /// The static bounds of formulas.
    #[cfg(feature = "formulas")]
    bounds: crate::derived::Bounds,
    tally: T,
}

impl<'s, T: Tally> Session<'s, T> {
    pub(crate) fn new(scene: &'s Scene, tally: T) -> Result<Session<'s, T>, Declined> {
        Ok(Session {
            decider: Decider::new(scene)?,
            #[cfg(feature = "formulas")]
            bounds: Default::default(),
            tally,
        })
    }

    /// The method [`Predicates::construct`] with an additional condition, for sessions that build on this one.
    ///
    /// The session `accepts` each new definition in canonical form, or refuses it.
    ///
    /// # Errors
    /// As [`Predicates::construct`], or with the reason from `accepts`.
    pub fn construct_where(
        &mut self,
        definitions: &[Construction],
        accepts: impl Fn(&Construction) -> Result<(), DefinitionError>,
    ) -> Result<Vec<Vertex>, Refused> {
        self.decider.construct_where(definitions, &accepts)
    }

    /// Returns true if doubles make no error in this predicate's determinant and its intermediates.
    ///
    /// This holds for any input vertices. The call makes the scene's plan.
    #[inline]
    #[must_use]
    pub fn is_double(&self, kind: PredicateKind) -> bool {
        self.decider.is_double(kind)
    }

    /// Returns true if doubles make no error in this predicate, and the plan is made.
    ///
    /// The call is a few instructions. A tie has made the plan. (For `orient2d`, the plan of the plane.)
    #[inline(always)]
    #[must_use]
    pub fn is_known_double(&self, kind: PredicateKind) -> bool {
        self.decider.is_known_double(kind)
    }

    /// The scene's constructed vertices.
    #[must_use]
    pub fn constructed(&self) -> &Constructed {
        self.decider.constructed()
    }

    /// The answer of [`Predicates::compare`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or axis.
    #[inline]
    #[must_use]
    pub fn decide_compare(&self, axis: Axis, a: Vertex, b: Vertex) -> (Sign, usize) {
        self.decider.decide_compare(axis, a, b)
    }

    /// The answer of [`Predicates::orient2d`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex, or lacks an axis of the plane.
    #[inline(always)]
    #[must_use]
    pub fn decide_orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        self.decider.decide_orient2d(plane, a, b, c)
    }

    /// The answer of [`Predicates::orient3d`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 2D.
    #[inline(always)]
    #[must_use]
    pub fn decide_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        self.decider.decide_orient3d(a, b, c, d)
    }

    /// The answer of [`Session::decide_orient3d`] if the static filter decides; else `None`.
    ///
    /// # Panics
    /// If the scene is 2D.
    #[inline]
    #[must_use]
    pub fn filter_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Option<(Sign, usize)> {
        self.decider.filter_orient3d(a, b, c, d)
    }

    /// The answer of [`Predicates::incircle`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 3D.
    #[inline(always)]
    #[must_use]
    pub fn decide_incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        self.decider.decide_incircle(a, b, c, d)
    }

    /// The answer of [`Predicates::insphere`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 2D, or if a vertex is constructed.
    #[inline(always)]
    #[must_use]
    pub fn decide_insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> (Sign, usize) {
        self.decider.decide_insphere(a, b, c, d, e)
    }

    /// The result of the filter that [`Session::decide_orient2d`] runs first, with the points that it has read.
    #[inline(always)]
    #[must_use]
    pub fn filtered_orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Filtered<'s, 2, 3> {
        self.decider.filtered_orient2d(plane, a, b, c)
    }

    /// The turn of three vertices of the plane in integers, and their points, if integers come before any filter.
    ///
    /// `None` otherwise, or if a vertex is constructed. The stage is [`INTEGER`](crate::stage::INTEGER).
    #[inline(always)]
    #[must_use]
    pub fn turn_of_integers(&self, a: Vertex, b: Vertex, c: Vertex) -> Option<(Sign, [&'s [f64; 2]; 3])> {
        self.decider.turn_of_integers(a, b, c)
    }

    /// The result of the filter that [`Session::decide_orient3d`] runs first, with the points that it has read.
    #[inline(always)]
    #[must_use]
    pub fn filtered_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Filtered<'s, 3, 4> {
        self.decider.filtered_orient3d(a, b, c, d)
    }

    /// The result of the filter that [`Session::decide_incircle`] runs first, with the points that it has read.
    #[inline(always)]
    #[must_use]
    pub fn filtered_incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Filtered<'s, 2, 4> {
        self.decider.filtered_incircle(a, b, c, d)
    }

    /// The result of the filter that [`Session::decide_insphere`] runs first, with the points that it has read.
    #[inline(always)]
    #[must_use]
    pub fn filtered_insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Filtered<'s, 3, 5> {
        self.decider.filtered_insphere(a, b, c, d, e)
    }

    /// The answer of [`Session::decide_orient2d`] to a query that its first filter has [left](Filtered::Left).
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[must_use]
    pub fn decide_left_orient2d(&self, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        self.decider.climb_orient2d(Plane::Xy, a, b, c)
    }

    /// The answer of [`Session::decide_orient3d`] to a query that its first filter has [left](Filtered::Left).
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[must_use]
    pub fn decide_left_orient3d(&self, determinant: f64, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        self.decider.open_orient3d(determinant, a, b, c, d)
    }

    /// The answer of [`Session::decide_incircle`] to a query that its first filter has [left](Filtered::Left).
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[must_use]
    pub fn decide_left_incircle(&self, determinant: f64, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        self.decider.open_incircle(determinant, a, b, c, d)
    }

    /// The answer of [`Session::decide_insphere`] to a query that its first filter has [left](Filtered::Left).
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[must_use]
    pub fn decide_left_insphere(
        &self,
        determinant: f64,
        a: Vertex,
        b: Vertex,
        c: Vertex,
        d: Vertex,
        e: Vertex,
    ) -> (Sign, usize) {
        self.decider.open_insphere(determinant, [a, b, c, d, e])
    }

    /// Returns true if turns in the plane are decided in integers, one by one: then a batch is a loop.
    #[must_use]
    pub fn turns_in_integers(&self) -> bool {
        self.decider.turns_in_integers()
    }

    /// Answers as [`Predicates::orient2d_batch`], and breaks ties where many of them are found in doubles.
    ///
    /// Not tallied. Ties that remain open, or are found in another way, are zero.
    ///
    /// # Panics
    /// As [`Predicates::orient2d_batch`].
    #[inline]
    pub fn orient2d_batch_with(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign], ties: impl Ties<2, 3>) {
        self.decider.orient2d_batch_with(plane, queries, out, ties);
    }

    /// Answers as [`Predicates::orient3d_batch`], and breaks ties where many of them are found in doubles.
    ///
    /// See [`Session::orient2d_batch_with`].
    ///
    /// # Panics
    /// As [`Predicates::orient3d_batch`].
    #[inline]
    pub fn orient3d_batch_with(&self, queries: &[[Vertex; 4]], out: &mut [Sign], ties: impl Ties<3, 4>) {
        self.decider.orient3d_batch_with(queries, out, ties);
    }

    /// Answers as [`Predicates::incircle_batch`], and breaks ties where many of them are found in doubles.
    ///
    /// See [`Session::orient2d_batch_with`].
    ///
    /// # Panics
    /// As [`Predicates::incircle_batch`].
    #[inline]
    pub fn incircle_batch_with(&self, queries: &[[Vertex; 4]], out: &mut [Sign], ties: impl Ties<2, 4>) {
        self.decider.incircle_batch_with(queries, out, ties);
    }

    /// Answers as [`Predicates::insphere_batch`], and breaks ties where many of them are found in doubles.
    ///
    /// See [`Session::orient2d_batch_with`].
    ///
    /// # Panics
    /// As [`Predicates::insphere_batch`].
    #[inline]
    pub fn insphere_batch_with(&self, queries: &[[Vertex; 5]], out: &mut [Sign], ties: impl Ties<3, 5>) {
        self.decider.insphere_batch_with(queries, out, ties);
    }

    /// The answer of [`Predicates::sign`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If a vertex is constructed or out of range, or the number of vertices is not the formula's.
    #[cfg(feature = "formulas")]
    #[must_use]
    pub fn decide_derived(&self, predicate: predicament_predicates::Derived, vertices: &[Vertex]) -> (Sign, usize) {
        self.bounds.decide(self.decider.scene(), predicate, vertices)
    }

    #[inline(always)]
    fn tallied(&self, kind: PredicateKind, (sign, stage): (Sign, usize)) -> Sign {
        self.tally.settled(kind, stage);
        sign
    }

    #[inline]
    fn tally_all(&self, kind: PredicateKind, settled: Settled) {
        if T::LISTENS {
            let some = settled.into_iter().enumerate().filter(|&(_, count)| count > 0);
            some.for_each(|(stage, count)| self.tally.settled_many(kind, stage, count));
        }
    }
}

impl<T: Tally> Predicates for Session<'_, T> {
    #[inline]
    fn scene(&self) -> &Scene {
        self.decider.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.construct_where(definitions, |_| Ok(()))
    }

    #[cfg(feature = "formulas")]
    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        crate::derived::supports(self.scene(), kind)
    }

    #[cfg(feature = "formulas")]
    fn sign(&self, predicate: predicament_predicates::Derived, vertices: &[Vertex]) -> Sign {
        self.tallied(PredicateKind::Derived(predicate), self.decide_derived(predicate, vertices))
    }

    fn unperturbed(&self) -> Option<&dyn Sessions> {
        Some(&Exact)
    }

    #[inline]
    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.tallied(PredicateKind::Compare, self.decide_compare(axis, a, b))
    }

    #[inline]
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        self.tallied(PredicateKind::Orient2d, self.decide_orient2d(plane, a, b, c))
    }

    #[inline]
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tallied(PredicateKind::Orient3d, self.decide_orient3d(a, b, c, d))
    }

    #[inline]
    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tallied(PredicateKind::Incircle, self.decide_incircle(a, b, c, d))
    }

    #[inline]
    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.tallied(PredicateKind::Insphere, self.decide_insphere(a, b, c, d, e))
    }

    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        self.tally_all(PredicateKind::Compare, self.decider.compare_batch(axis, queries, out));
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        self.tally_all(PredicateKind::Orient2d, self.decider.orient2d_batch(plane, queries, out));
    }

    fn orient2d_line(&self, plane: Plane, line: [Vertex; 2], points: &[Vertex], out: &mut [Sign]) {
        self.tally_all(PredicateKind::Orient2d, self.decider.orient2d_line(plane, line, points, out));
    }

    fn orient3d_plane(&self, plane: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) {
        self.tally_all(PredicateKind::Orient3d, self.decider.orient3d_plane(plane, points, out));
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        self.tally_all(PredicateKind::Orient3d, self.decider.orient3d_batch(queries, out));
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        self.tally_all(PredicateKind::Incircle, self.decider.incircle_batch(queries, out));
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        self.tally_all(PredicateKind::Insphere, self.decider.insphere_batch(queries, out));
    }
}
