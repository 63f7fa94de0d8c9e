//! The backend: exact first, the perturbation on ties only.

use predicament_exact::Exact;
use predicament_predicates::{
    Axis, Backend, Contract, Declined, Off, Plane, PredicateKind, Predicates, Question, Scene, Sign, Tally, Vertex,
    ZeroMeaning,
};

use crate::{Scheme, stage, ties, ties::Sorted};

/// The Simulation of Simplicity backend.
///
/// Its promise is proved: the sign of the real determinant where that is not
/// zero, and else the sign for all small enough ε > 0 of the determinant of
/// the scene that the scheme has moved. The answer is zero only if a vertex
/// comes twice in a query.
///
/// A scene with constructed vertices is declined.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Sos {
    /// How the scene is moved.
    pub scheme: Scheme,
}

impl Backend for Sos {
    type Session<'s, T: Tally + 's> = Session<'s, T>;

    /// `sos`, and the scheme if it is not the default.
    fn name(&self) -> String {
        match self.scheme {
            Scheme::PerCoordinate => "sos".to_owned(),
            Scheme::EdelsbrunnerMucke => format!("sos:{}", self.scheme),
        }
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Never, proved: true }
    }

    /// The exact backend's stages, then `term 1`, `term 2`… for ties: how deep
    /// in the predicate's list the deciding term stands.
    fn stages(&self) -> &'static [&'static str] {
        stage::names(self.scheme)
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s, T>, Declined> {
        if !scene.constructions().is_empty() {
            // What a vertex does that is constructed from perturbed ones is no term of these lists.
            return Err(Declined::scene("how a perturbation moves constructed vertices is not derived"));
        }
        Ok(Session { scheme: self.scheme, exact: Exact.prepare(scene, Off)?, tally })
    }
}

/// The backend, prepared for one scene.
pub struct Session<'s, T> {
    scheme: Scheme,
    exact: predicament_exact::Session<'s, Off>,
    tally: T,
}

impl<T: Tally> Session<'_, T> {
    #[inline(always)]
    fn settle<const N: usize>(&self, question: Question, args: [Vertex; N], (sign, stage): (Sign, usize)) -> Sign {
        if sign.is_zero() {
            return self.break_tie(question, args, stage);
        }
        self.tally.settled(question.kind(), stage);
        sign
    }

    #[cold]
    #[inline(never)]
    fn break_tie<const N: usize>(&self, question: Question, args: [Vertex; N], stage: usize) -> Sign {
        let kind = question.kind();
        let broken = Sorted::new(args).and_then(|sorted| {
            let (sign, depth) = ties::decide(&self.exact, question, self.scheme.terms(kind), &sorted.vertices)?;
            Some((sign * sorted.parity, stage::FIRST_TERM + depth))
        });
        let (sign, stage) = broken.unwrap_or((Sign::Zero, stage));
        self.tally.settled(kind, stage);
        sign
    }
}

impl<T: Tally> Session<'_, T> {
    /// The exact backend's batch, and then the ties that it has found.
    #[inline(always)]
    fn batch<const N: usize>(
        &self,
        question: Question,
        queries: &[[Vertex; N]],
        out: &mut [Sign],
        exact: impl Fn(&mut [Sign]),
    ) {
        if T::LISTENS {
            // Which of the exact backend's stages settled a query is known only where it is asked alone.
            for (query, out) in queries.iter().zip(out) {
                *out = question.ask(self, query);
            }
            return;
        }
        exact(out);
        // (A tie has no stage to be told of.)
        for (query, out) in queries.iter().zip(out).filter(|(_, out)| out.is_zero()) {
            *out = self.break_tie(question, *query, 0);
        }
    }
}

impl<T: Tally> Predicates for Session<'_, T> {
    #[inline]
    fn scene(&self) -> &Scene {
        self.exact.scene()
    }

    #[inline]
    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.settle(Question::Compare(axis), [a, b], self.exact.decide_compare(axis, a, b))
    }

    #[inline]
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        self.settle(Question::Orient2d(plane), [a, b, c], self.exact.decide_orient2d(plane, a, b, c))
    }

    #[inline]
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.settle(Question::Orient3d, [a, b, c, d], self.exact.decide_orient3d(a, b, c, d))
    }

    #[inline]
    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.settle(Question::Incircle, [a, b, c, d], self.exact.decide_incircle(a, b, c, d))
    }

    #[inline]
    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.settle(Question::Insphere, [a, b, c, d, e], self.exact.decide_insphere(a, b, c, d, e))
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        self.batch(Question::Orient2d(plane), queries, out, |out| self.exact.orient2d_batch(plane, queries, out));
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        self.batch(Question::Orient3d, queries, out, |out| self.exact.orient3d_batch(queries, out));
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        self.batch(Question::Incircle, queries, out, |out| self.exact.incircle_batch(queries, out));
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        self.batch(Question::Insphere, queries, out, |out| self.exact.insphere_batch(queries, out));
    }
}
