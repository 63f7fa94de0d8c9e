//! The backend's session: the results of a [`Breaker`], tallied.

use predicament_exact::{Exact, stage::COMPARE};
use predicament_predicates::{
    Axis, Construction, Declined, Plane, PredicateKind, Predicates, Refused, Scene, Sessions, Sign, Tally, Vertex,
};

use crate::breaker::Breaker;
#[cfg(feature = "formulas")]
use crate::{breaker::AS_EXACT, derived, stage};

/// The backend, prepared for one scene.
pub struct Session<'s, T> {
    breaker: Breaker<'s>,
    tally: T,
}

impl<'s, T: Tally> Session<'s, T> {
    pub(crate) fn new(breaker: Breaker<'s>, tally: T) -> Session<'s, T> {
        Session { breaker, tally }
    }

    #[inline(always)]
    fn tallied(&self, kind: PredicateKind, (sign, stage): (Sign, usize)) -> Sign {
        self.tally.settled(kind, stage);
        sign
    }

    /// Answers a batch, one by one if a tally listens.
    ///
    /// Only single queries tell which of the exact backend's stages settled them.
    #[inline(always)]
    fn batch<Q>(
        &self,
        queries: &[Q],
        out: &mut [Sign],
        single: impl Fn(&Q) -> Sign,
        all: impl FnOnce(&Breaker<'s>, &mut [Sign]),
    ) {
        if T::LISTENS {
            queries.iter().zip(out).for_each(|(query, out)| *out = single(query));
        } else {
            all(&self.breaker, out);
        }
    }
}

impl<T: Tally> Predicates for Session<'_, T> {
    #[inline]
    fn scene(&self) -> &Scene {
        self.breaker.exact.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.breaker.construct(definitions)
    }

    fn unperturbed(&self) -> Option<&dyn Sessions> {
        Some(&Exact)
    }

    /// Circles and spheres take input vertices only.
    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        let scene = self.scene();
        if kind.is_lifted() && !scene.constructions().is_empty() {
            return Err(Declined::predicate(kind, "ties of circles through constructed vertices are not broken"));
        }
        #[cfg(feature = "formulas")]
        if let PredicateKind::Derived(derived) = kind {
            derived::is_derivable(derived).map_err(|why| Declined::predicate(kind, why))?;
        }
        self.breaker.exact.supports(kind)
    }

    #[inline]
    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        let (kind, points) = (PredicateKind::Compare, self.breaker.points);
        let (Some(x), Some(y)) = (points.coordinate(axis, a), points.coordinate(axis, b)) else {
            return self.tallied(kind, self.breaker.compare_constructed(axis, a, b));
        };
        // Unequal coordinates have one of two orders; the exact backend would need two comparisons.
        if x != y {
            return self.tallied(kind, (if x > y { Sign::Positive } else { Sign::Negative }, COMPARE));
        }
        self.tallied(kind, Breaker::tie_compare(a, b))
    }

    #[inline]
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        self.tallied(PredicateKind::Orient2d, self.breaker.orient2d(plane, a, b, c))
    }

    #[inline]
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tallied(PredicateKind::Orient3d, self.breaker.orient3d(a, b, c, d))
    }

    #[inline]
    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tallied(PredicateKind::Incircle, self.breaker.incircle(a, b, c, d))
    }

    #[inline]
    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.tallied(PredicateKind::Insphere, self.breaker.insphere(a, b, c, d, e))
    }

    #[cfg(feature = "formulas")]
    fn sign(&self, predicate: predicament_predicates::Derived, vertices: &[Vertex]) -> Sign {
        let exact = self.breaker.exact.decide_derived(predicate, vertices);
        let decided = self.breaker.tied(exact, || {
            let decided = derived::tie(self.breaker.scheme, self.scene(), predicate, vertices);
            decided.map_or((Sign::Zero, AS_EXACT), |(sign, place)| (sign, stage::of_term(self.breaker.scheme, place)))
        });
        self.tallied(PredicateKind::Derived(predicate), decided)
    }

    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        let single = |&[a, b]: &[_; 2]| self.compare(axis, a, b);
        self.batch(queries, out, single, |breaker, out| breaker.compare_batch(axis, queries, out));
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        let single = |&[a, b, c]: &[_; 3]| self.orient2d(plane, a, b, c);
        self.batch(queries, out, single, |breaker, out| breaker.orient2d_batch(plane, queries, out));
    }

    fn orient2d_line(&self, plane: Plane, line: [Vertex; 2], vertices: &[Vertex], out: &mut [Sign]) {
        let single = |&c: &Vertex| self.orient2d(plane, line[0], line[1], c);
        self.batch(vertices, out, single, |breaker, out| breaker.orient2d_line(plane, line, vertices, out));
    }

    fn orient3d_plane(&self, plane: [Vertex; 3], vertices: &[Vertex], out: &mut [Sign]) {
        let single = |&d: &Vertex| self.orient3d(plane[0], plane[1], plane[2], d);
        self.batch(vertices, out, single, |breaker, out| breaker.orient3d_plane(plane, vertices, out));
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let single = |&[a, b, c, d]: &[_; 4]| self.orient3d(a, b, c, d);
        self.batch(queries, out, single, |breaker, out| breaker.orient3d_batch(queries, out));
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let single = |&[a, b, c, d]: &[_; 4]| self.incircle(a, b, c, d);
        self.batch(queries, out, single, |breaker, out| breaker.incircle_batch(queries, out));
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        let single = |&[a, b, c, d, e]: &[_; 5]| self.insphere(a, b, c, d, e);
        self.batch(queries, out, single, |breaker, out| breaker.insphere_batch(queries, out));
    }
}
