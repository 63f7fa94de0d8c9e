//! The exact backend with every query made twice: a measure of how much of an input's time is spent on predicates.
//!
//! An input whose time hardly grows would take as long with any backend, so a ratio of times on it says nothing about
//! backends. The measure needs no third backend, so the choice of backends does not change which inputs are excluded.

use std::hint::black_box;

use predicament_exact::Exact;
use predicament_predicates::{
    Axis, Backend, Construction, Constructs, Contract, Declined, Plane, PredicateKind, Predicates, Question, Refused,
    Scene, Sessions, Sign, Tally, Vertex, answer_by,
};

/// The exact backend, which computes each answer twice.
#[derive(Clone, Copy, Debug)]
pub struct Twice;

/// A session that makes each query of another session twice.
#[derive(Debug)]
pub struct Asked<P>(P);

impl Backend for Twice {
    type Session<'s, T: Tally + 's> = Asked<<Exact as Backend>::Session<'s, T>>;

    fn name(&self) -> String {
        "exact:twice".to_owned()
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        Exact.contract(kind)
    }

    fn stages(&self) -> &'static [&'static str] {
        Exact.stages()
    }

    fn constructs(&self) -> Constructs {
        Exact.constructs()
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Self::Session<'s, T>, Declined> {
        Exact.prepare(scene, tally).map(Asked)
    }
}

impl<P: Predicates> Asked<P> {
    /// The second of two answers.
    #[inline(always)]
    fn twice<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        black_box(question.ask(&self.0, &black_box(args)));
        question.ask(&self.0, &args)
    }
}

/// Implements batches by the second of two calls.
macro_rules! batches_twice {
    ($($method:ident($($name:ident: $type:ty),*);)+) => {
        $(fn $method(&self, $($name: $type,)* out: &mut [Sign]) {
            self.0.$method($($name,)* out);
            black_box(&mut *out);
            self.0.$method($($name,)* out);
        })+
    };
}

impl<P: Predicates> Predicates for Asked<P> {
    fn scene(&self) -> &Scene {
        self.0.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.0.construct(definitions)
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        self.0.supports(kind)
    }

    fn unperturbed(&self) -> Option<&dyn Sessions> {
        self.0.unperturbed()
    }

    fn rounded_point(&self, v: Vertex) -> Option<&[f64]> {
        self.0.rounded_point(v)
    }

    answer_by!(twice);

    batches_twice! {
        compare_batch(axis: Axis, queries: &[[Vertex; 2]]);
        orient2d_batch(plane: Plane, queries: &[[Vertex; 3]]);
        orient2d_line(plane: Plane, line: [Vertex; 2], points: &[Vertex]);
        orient3d_batch(queries: &[[Vertex; 4]]);
        orient3d_plane(plane: [Vertex; 3], points: &[Vertex]);
        incircle_batch(queries: &[[Vertex; 4]]);
        insphere_batch(queries: &[[Vertex; 5]]);
    }
}
