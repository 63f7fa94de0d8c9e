//! The session of plain determinants, with a separate type for each pivot.
//!
//! A loop that tests for the pivot in every query takes up to three times as long as a loop with a fixed pivot. So the
//! session's type fixes the pivot, and a batch tests once: this baseline should be as fast as a single handwritten
//! determinant.

use predicament_predicates::{
    Axis, Band, Construction, Declined, Derived, Plane, PredicateKind, Predicates, Question, Refused, Scene, Sessions,
    Sign, Tally, Vertex, answer_by,
};

use crate::determinant::{Determinant, Pivot};
use crate::session::{Float, Session};

/// Defines types of determinants with a pivot that is fixed at compile time.
macro_rules! about {
    ($($name:ident: $in_lanes:literal)*) => {$(
        /// The determinants with this pivot.
        #[derive(Clone, Copy, Debug)]
        pub struct $name;

        impl<const D: usize, const N: usize> Determinant<D, N> for $name
        where
            Pivot: Determinant<D, N>,
        {
            #[inline(always)]
            fn determinant(&self, points: [[f64; D]; N]) -> f64 {
                Pivot::$name.determinant(points)
            }
        }

        impl Float for $name {
            const IN_LANES: bool = $in_lanes;
        }
    )*};
}

// (nalgebra's determinant is out of line and pivots: it branches.)
about!(Last: true First: true Homogeneous: false);

/// The session of plain determinants for one scene, by pivot.
pub enum NaiveSession<'s, T> {
    /// The session for [`Pivot::Last`].
    Last(Session<'s, Last, T>),
    /// The session for [`Pivot::First`].
    First(Session<'s, First, T>),
    /// The session for [`Pivot::Homogeneous`].
    Homogeneous(Session<'s, Homogeneous, T>),
}

impl<'s, T> NaiveSession<'s, T> {
    pub(crate) fn new(scene: &'s Scene, pivot: Pivot, tally: T) -> NaiveSession<'s, T> {
        match pivot {
            Pivot::Last => NaiveSession::Last(Session::new(scene, Last, tally)),
            Pivot::First => NaiveSession::First(Session::new(scene, First, tally)),
            Pivot::Homogeneous => NaiveSession::Homogeneous(Session::new(scene, Homogeneous, tally)),
        }
    }
}

/// Evaluates an expression with the session of any variant.
macro_rules! each {
    ($of:expr, $session:ident => $asked:expr) => {
        match $of {
            NaiveSession::Last($session) => $asked,
            NaiveSession::First($session) => $asked,
            NaiveSession::Homogeneous($session) => $asked,
        }
    };
}

/// The value of [`Sign::of`], from a table. After the match on pivots, `Sign::of` compiles to branches, and a
/// mispredicted sign of a random determinant costs more than the determinant.
#[inline(always)]
fn sign(x: f64) -> Sign {
    const SIGNS: [Sign; 4] = [Sign::Zero, Sign::Positive, Sign::Negative, Sign::Zero];
    SIGNS[usize::from(x > 0.0) | usize::from(x < 0.0) << 1]
}

impl<T: Tally> NaiveSession<'_, T> {
    #[inline(always)]
    fn ask<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        sign(each!(self, session => session.value(question, args)))
    }
}

// An omitted method would use its default instead of the session's own method.
#[deny(clippy::missing_trait_methods)]
impl<T: Tally> Predicates for NaiveSession<'_, T> {
    #[inline]
    fn scene(&self) -> &Scene {
        each!(self, session => session.scene())
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        each!(self, session => session.construct(definitions))
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        each!(self, session => session.supports(kind))
    }

    answer_by!(ask);

    fn sign(&self, predicate: Derived, vertices: &[Vertex]) -> Sign {
        each!(self, session => session.sign(predicate, vertices))
    }

    fn sign_batch(&self, predicate: Derived, vertices: &[Vertex], out: &mut [Sign]) {
        each!(self, session => session.sign_batch(predicate, vertices, out));
    }

    fn estimate(&self, question: Question, args: &[Vertex]) -> Option<f64> {
        each!(self, session => session.estimate(question, args))
    }

    fn rounded_point(&self, v: Vertex) -> Option<&[f64]> {
        each!(self, session => session.rounded_point(v))
    }

    fn own_nanoseconds(&self) -> Option<u64> {
        each!(self, session => session.own_nanoseconds())
    }

    fn unperturbed(&self) -> Option<&dyn Sessions> {
        each!(self, session => session.unperturbed())
    }

    fn moves_second_mesh(&self) -> bool {
        each!(self, session => session.moves_second_mesh())
    }

    fn allows(&self, shortcut: &str) -> bool {
        each!(self, session => session.allows(shortcut))
    }

    fn band(&self, question: Question) -> Option<Band> {
        each!(self, session => session.band(question))
    }

    fn reach(&self) -> f64 {
        each!(self, session => session.reach())
    }

    fn contact_band(&self, ranks: [u8; 2]) -> Option<Band> {
        each!(self, session => session.contact_band(ranks))
    }

    fn supports_contacts(&self) -> Result<(), Declined> {
        each!(self, session => session.supports_contacts())
    }

    fn vertex_vertex(&self, a: Vertex, p: Vertex) -> bool {
        each!(self, session => session.vertex_vertex(a, p))
    }

    fn edge_vertex(&self, edge: [Vertex; 2], p: Vertex) -> Option<f64> {
        each!(self, session => session.edge_vertex(edge, p))
    }

    fn edge_edge(&self, e: [Vertex; 2], f: [Vertex; 2]) -> Option<[f64; 2]> {
        each!(self, session => session.edge_edge(e, f))
    }

    fn triangle_vertex(&self, triangle: [Vertex; 3], p: Vertex) -> Option<[f64; 3]> {
        each!(self, session => session.triangle_vertex(triangle, p))
    }

    fn triangle_edge(&self, triangle: [Vertex; 3], edge: [Vertex; 2]) -> Option<([f64; 3], f64)> {
        each!(self, session => session.triangle_edge(triangle, edge))
    }

    fn tetrahedron_vertex(&self, tetrahedron: [Vertex; 4], p: Vertex) -> Option<[f64; 4]> {
        each!(self, session => session.tetrahedron_vertex(tetrahedron, p))
    }

    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        each!(self, session => session.compare_batch(axis, queries, out));
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        each!(self, session => session.orient2d_batch(plane, queries, out));
    }

    fn orient2d_line(&self, plane: Plane, line: [Vertex; 2], points: &[Vertex], out: &mut [Sign]) {
        each!(self, session => session.orient2d_line(plane, line, points, out));
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        each!(self, session => session.orient3d_batch(queries, out));
    }

    fn orient3d_plane(&self, plane: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) {
        each!(self, session => session.orient3d_plane(plane, points, out));
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        each!(self, session => session.incircle_batch(queries, out));
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        each!(self, session => session.insphere_batch(queries, out));
    }
}
