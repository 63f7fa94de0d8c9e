//! The backend's session: the answers of a [`Decider`], tallied.
//!
//! Nothing else is generic over the tally, so a crate with its own tally compiles only this type.

use alloc::vec::Vec;
use predicament_predicates::{
    Axis, Construction, Declined, DefinitionError, Plane, PredicateKind, Predicates, Refused, Scene, Sessions, Sign,
    Tally, Vertex,
};

use crate::Exact;
use crate::batch::Settled;
use crate::constructed::Constructed;
use crate::decider::Decider;

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

    /// Returns true if doubles make no error in this predicate of three or more differences, and the plan is made.
    ///
    /// The call is a few instructions. A tie has made the plan.
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
