//! A scene with the session that is prepared for it, in one value.
//!
//! A session borrows its scene. A program in C holds both behind one pointer, so both are in a [`self_cell`].

use predicament_exact::Exact;
use predicament_predicates::{Axis, Backend, Construction, Dimension, Plane, PredicateKind, Predicates, Question};
use predicament_predicates::{Scene, SceneError, Sign, Vertex};
#[cfg(feature = "sos")]
use predicament_sos::{Scheme, Sos};

use crate::failure::Failure;
use crate::failure::predicament_result::*;

/// The number of queries of a batch that are checked and asked together.
const PART: usize = 1024;

/// The perturbation of scenes whose ties are broken.
#[cfg(feature = "sos")]
static SOS: Sos = Sos { scheme: Scheme::PerCoordinate };

type Session<'s> = Box<dyn Predicates + 's>;

self_cell::self_cell!(
    struct Pair {
        owner: Scene,
        #[covariant]
        dependent: Session,
    }
);

/// The backends whose sessions a scene can have.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Rule {
    /// Zero is zero.
    Exact,
    /// Ties are broken by Simulation of Simplicity.
    Sos,
}

/// A scene with its session.
pub(crate) struct Prepared {
    pair: Pair,
    /// The numbers of input vertices and of constructed vertices.
    counts: [usize; 2],
    /// The end of the ids of input vertices, and that of constructed vertices.
    ends: [u32; 2],
    /// The predicates that the session answers, by the index of their kind.
    answered: [bool; 5],
    /// True while the session is being changed, and for ever if that ended in a panic.
    is_broken: bool,
}

impl Prepared {
    /// A prepared scene of these coordinates, point after point.
    pub fn new(rule: Rule, dimension: Dimension, coordinates: Vec<f64>) -> Result<Prepared, Failure> {
        let scene = Scene::new(dimension, coordinates).map_err(|error| match error {
            SceneError::NotFinite { vertex, .. } => Failure::at(PREDICAMENT_NOT_FINITE, vertex),
            SceneError::TooMany { .. } => PREDICAMENT_TOO_MANY.into(),
            _ => Failure::from(PREDICAMENT_INTERNAL),
        })?;
        let pair = Pair::try_new(scene, |scene| match rule {
            Rule::Exact => Exact.boxed(scene, None),
            #[cfg(feature = "sos")]
            Rule::Sos => SOS.boxed(scene, None),
            #[cfg(not(feature = "sos"))]
            Rule::Sos => {
                Err(predicament_predicates::Declined::scene("the library was built without the feature `sos`"))
            }
        });
        let pair = pair.map_err(|_| Failure::from(PREDICAMENT_UNSUPPORTED))?;
        let mut prepared = Prepared { pair, counts: [0; 2], ends: [0; 2], answered: [false; 5], is_broken: false };
        prepared.read_session();
        Ok(prepared)
    }

    /// Reads which vertices the session has and which predicates it answers: constructed vertices can change both.
    fn read_session(&mut self) {
        let scene = self.session().scene();
        self.counts = [scene.len(), scene.constructions().len()];
        // (The last id of all is refused: 2^31 constructed vertices fit into no memory.)
        let end = |first: usize, count: usize| u32::try_from(first + count).unwrap_or(u32::MAX);
        self.ends = [end(0, self.counts[0]), end(Vertex::MAX_INPUT, self.counts[1])];
        self.answered = PredicateKind::ALL.map(|kind| self.session().supports(kind).is_ok());
    }

    #[inline(always)]
    fn session(&self) -> &Session<'_> {
        self.pair.borrow_dependent()
    }

    /// The numbers of input vertices and of constructed vertices.
    pub fn counts(&self) -> [usize; 2] {
        self.counts
    }

    /// Returns true if the scene lacks one of these vertices.
    #[inline(always)]
    fn lacks(&self, vertices: &[Vertex]) -> bool {
        // Without branches and lookups, so that many are compared at once.
        let [end, constructed_end] = self.ends;
        vertices.iter().fold(false, |any, &vertex| {
            let id = u32::try_from(vertex.index()).unwrap_or(u32::MAX);
            any | ((id >= end) & (!vertex.is_constructed() | (id >= constructed_end)))
        })
    }

    /// Checks that the session answers a question about some vertices.
    #[inline(always)]
    fn check(&self, question: Question) -> Result<(), Failure> {
        if self.is_broken {
            return Err(PREDICAMENT_INTERNAL.into());
        }
        let is_there = match (question, self.pair.borrow_owner().dimension()) {
            (Question::Compare(axis), Dimension::Two) => axis != Axis::Z,
            (Question::Orient2d(plane), Dimension::Two) => plane == Plane::Xy,
            _ => true,
        };
        let is_answered = self.answered.get(question.kind().index()).copied().unwrap_or(false);
        if is_there && is_answered { Ok(()) } else { Err(PREDICAMENT_UNSUPPORTED.into()) }
    }

    /// Checks the vertices of queries.
    #[inline(always)]
    fn check_vertices(&self, question: Question, vertices: &[Vertex]) -> Result<(), Failure> {
        if self.lacks(vertices) {
            return Err(PREDICAMENT_INDEX.into());
        }
        // Spheres take input vertices only.
        let constructed = || vertices.iter().fold(false, |any, vertex| any | vertex.is_constructed());
        if question == Question::Insphere && constructed() {
            return Err(PREDICAMENT_UNSUPPORTED.into());
        }
        Ok(())
    }

    /// The sign of one query, asked by `ask`.
    #[inline(always)]
    pub fn ask(
        &self,
        question: Question,
        vertices: &[Vertex],
        ask: impl FnOnce(&dyn Predicates) -> Sign,
    ) -> Result<Sign, Failure> {
        self.check(question)?;
        self.check_vertices(question, vertices)?;
        Ok(ask(self.session().as_ref()))
    }

    /// The signs of queries, whose vertices are in one list.
    ///
    /// # Errors
    /// A failure at the first bad query. The signs mean nothing then.
    pub fn ask_batch(&self, question: Question, vertices: &[Vertex], signs: &mut [Sign]) -> Result<(), Failure> {
        self.check(question)?;
        let arity = question.kind().arity();
        // By parts, so that vertices are in the cache when the session reads them after the check.
        for (part, (vertices, signs)) in vertices.chunks(PART * arity).zip(signs.chunks_mut(PART)).enumerate() {
            if self.check_vertices(question, vertices).is_err() {
                for (at, query) in vertices.chunks_exact(arity).enumerate() {
                    let place = part * PART + at;
                    self.check_vertices(question, query).map_err(|failure| Failure { at: place, ..failure })?;
                }
            }
            question.ask_batch(self.session(), vertices, signs);
        }
        Ok(())
    }

    /// The vertices of these definitions, constructed if they are new: all of them, or none.
    pub fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Failure> {
        self.change(|session| Ok(session.construct(definitions)?))
    }

    /// Changes the session. If `change` panics, the scene is broken.
    pub fn change<R>(&mut self, change: impl FnOnce(&mut dyn Predicates) -> Result<R, Failure>) -> Result<R, Failure> {
        if self.is_broken {
            return Err(PREDICAMENT_INTERNAL.into());
        }
        self.is_broken = true;
        let changed = self.pair.with_dependent_mut(|_, session| change(session.as_mut()));
        self.read_session();
        self.is_broken = false;
        changed
    }
}
