//! The interface between backends and algorithms.
//!
//! # Orientation
//! One convention, stated here and tested against the crate `robust`:
//! * [`Predicates::orient2d`] is positive when a, b, c turn counterclockwise.
//! * [`Predicates::orient3d`] is positive when d lies below the plane of a, b, c,
//!   that is, on the side from which they are seen clockwise; they are seen
//!   counterclockwise from above (Shewchuk's convention).
//! * [`Predicates::incircle`] is positive when d is inside the circle of a
//!   counterclockwise a, b, c.
//! * [`Predicates::insphere`] is positive when e is inside the sphere of
//!   a, b, c, d with a positive `orient3d`.

use crate::{
    Axis, Band, Construction, Constructs, Contract, Counts, Declined, Derived, Dimension, Off, Plane, PredicateKind,
    Question, Refused, Scene, Sessions, Sign, Tally, Vertex, contact,
};
use alloc::{boxed::Box, string::String, vec::Vec};

/// The way in which a backend answers a batch of queries.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Batches {
    /// The backend has code for batches, such as vector instructions.
    Own,
    /// A batch is a loop over single queries.
    Loop,
}

/// A method that answers predicates: exact, perturbed, or with tolerances.
///
/// It prepares a session for each scene.
pub trait Backend: Send + Sync {
    /// A backend prepared for one scene.
    type Session<'s, T: Tally + 's>: Predicates + 's
    where
        Self: 's;

    /// The backend's name, with its parameters, on the command line and in every file.
    fn name(&self) -> String;

    /// The backend's promise about its answers to this predicate.
    fn contract(&self, kind: PredicateKind) -> Contract;

    /// The names of the stages that can settle a query, cheapest first; at
    /// most [`MAX_STAGES`](crate::MAX_STAGES).
    fn stages(&self) -> &'static [&'static str];

    /// The way in which sessions answer batches of this predicate.
    ///
    /// The default is a loop over single queries.
    fn batches(&self, kind: PredicateKind) -> Batches {
        let _ = kind;
        Batches::Loop
    }

    /// The way in which sessions answer a call to [construct](Predicates::construct) vertices.
    ///
    /// The default is to decline.
    fn constructs(&self) -> Constructs {
        Constructs::Declines
    }

    /// The version of the library behind the backend; `None` if this project implements it.
    fn version(&self) -> Option<String> {
        None
    }

    /// The same backend with predicates that return zero at once, to time the calls alone.
    ///
    /// It is for backends whose calls cost something, such as bindings of a library in another language.
    fn binding(&self) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }

    /// Prepares a session for a scene, which may inspect the scene's coordinates here.
    ///
    /// # Errors
    /// [`Declined`] if the backend cannot handle the scene at all.
    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Self::Session<'s, T>, Declined>;

    /// Prepares a session behind a pointer, for callers that are not generic, with or without counts of stages.
    ///
    /// The crate that calls this method compiles the sessions. A backend that writes the method with
    /// [`boxed_here!`](crate::boxed_here) compiles them in its own crate, once for all callers.
    ///
    /// # Errors
    /// The errors of [`prepare`](Backend::prepare).
    fn boxed<'s>(&'s self, scene: &'s Scene, counts: Option<&'s Counts>) -> Result<Box<dyn Predicates + 's>, Declined> {
        Ok(match counts {
            Some(counts) => Box::new(self.prepare(scene, counts)?),
            None => Box::new(self.prepare(scene, Off)?),
        })
    }
}

/// Geometric predicates on the vertices of one prepared scene.
///
/// The same query has the same answer from every thread, whatever was queried or constructed before:
/// [`construct`](Predicates::construct) adds vertices and changes none. A predicate that
/// [`supports`](Predicates::supports) refuses panics; call `supports` first, once per scene.
pub trait Predicates: Send + Sync {
    /// The scene that the session was prepared for, plus the vertices that the session has constructed since.
    fn scene(&self) -> &Scene;

    /// Constructs the vertices that these definitions define, and returns them in the same order.
    ///
    /// The call takes the session mutably. Algorithms call it between parallel phases, with all vertices that one phase
    /// has found. Ids depend only on the definitions and their order. If a definition already has a vertex, from the
    /// scene or an earlier call, the same vertex is returned, also if the definition names the same lines and planes in
    /// another order. A definition may name constructed vertices, including vertices of this call. The cost depends on
    /// the definitions, not on the scene.
    ///
    /// The default declines; [`Backend::constructs`] says so in advance.
    ///
    /// # Errors
    /// [`Refused`] with the first definition that the session does not take, such as two parallel lines. Then the
    /// session has constructed none of the definitions.
    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        let _ = definitions;
        Err(Refused::session("the backend answers about the vertices that a scene is prepared with"))
    }

    /// Checks that the session answers this predicate.
    ///
    /// The default checks that the scene has the dimension for it, and declines predicates from formulas.
    ///
    /// # Errors
    /// [`Declined`] with the reason.
    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        if let PredicateKind::Derived(_) = kind {
            return Err(Declined::predicate(
                kind,
                "the backend does not evaluate formulas, or its crate is built without the feature `formulas`",
            ));
        }
        self.scene().has_dimension_for(kind)
    }

    /// The sign of a's coordinate minus b's along an axis.
    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign;

    /// The turn a, b, c in a coordinate plane: the sign of
    /// (a − c)₁(b − c)₂ − (a − c)₂(b − c)₁, twice the signed area.
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign;

    /// Positive when d lies below the plane of a, b, c: the sign of
    /// det(a − d, b − d, c − d).
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign;

    /// Positive when d is inside the circle of a counterclockwise a, b, c (2D scenes).
    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign;

    /// Positive when e is inside the sphere of a positively oriented a, b, c, d.
    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign;

    /// The sign of a predicate from a formula, with the formula's points in the order of the vertices.
    ///
    /// The five predicates above are fast paths; this method is the way to all others.
    ///
    /// # Panics
    /// If the session does not [support](Predicates::supports) the predicate, as by default.
    fn sign(&self, predicate: Derived, vertices: &[Vertex]) -> Sign {
        let _ = vertices;
        panic!("{} is a formula, which this session does not evaluate", predicate.name())
    }

    /// [`Predicates::sign`] for many queries, in order; `vertices` has their vertices, query after query.
    fn sign_batch(&self, predicate: Derived, vertices: &[Vertex], out: &mut [Sign]) {
        for (query, out) in vertices.chunks_exact(predicate.arity()).zip(out) {
            *out = self.sign(predicate, query);
        }
    }

    /// The floating-point determinant from which the answer was computed, or `None` if there was none.
    ///
    /// Error measures read it, and the oracle uses it to detect a NaN.
    fn estimate(&self, question: Question, args: &[Vertex]) -> Option<f64> {
        let _ = (question, args);
        None
    }

    /// The rounded coordinates that a session uses for a constructed vertex.
    ///
    /// `None` for sessions that answer about the exact point, and for input vertices.
    fn rounded_point(&self, v: Vertex) -> Option<&[f64]> {
        let _ = v;
        None
    }

    /// The total time of all predicates so far, in nanoseconds, by the session's own clock.
    ///
    /// `None` if the caller's clock already measures the predicates alone.
    fn own_nanoseconds(&self) -> Option<u64> {
        None
    }

    /// The same backend without the perturbation: it answers zero for a tie.
    ///
    /// An exact session returns its own backend here; `None` if signs are rounded. Algorithms use it to map results
    /// back to the unperturbed input.
    fn unperturbed(&self) -> Option<&dyn Sessions> {
        None
    }

    /// Returns true if the session perturbs the scene's [second mesh](Scene::with_second_mesh) as a whole.
    ///
    /// It then answers as if exactly the vertices of that mesh had moved by η·(ε, ε², ε³), with infinitesimals η and ε.
    /// The first one is smaller than every power of the second. The move changes nothing within a mesh.
    fn moves_second_mesh(&self) -> bool {
        false
    }

    /// Returns true if algorithms may take this shortcut of theirs, which changes no answer.
    ///
    /// A control returns false for one shortcut, to measure what it saves. An algorithm asks once for a scene.
    fn allows(&self, shortcut: &str) -> bool {
        let _ = shortcut;
        true
    }

    /// The tolerance band of this question, for sessions whose zero is a band.
    ///
    /// In space each projection of `orient2d` can have its own band.
    fn band(&self, question: Question) -> Option<Band> {
        let _ = question;
        None
    }

    /// The largest distance at which the session may still register a feature, in scene units.
    ///
    /// Broad phases inflate their boxes by this distance. It is zero for sessions that answer exact or perturbed signs.
    fn reach(&self) -> f64 {
        0.0
    }

    /// The tolerance band, in scene units, of a contact pair, by the ranks of its two simplices in either order.
    ///
    /// It is a distance, for pairs that register degeneracies. `None` for pairs of full dimension, which have no band,
    /// and for sessions without contact tolerances.
    fn contact_band(&self, ranks: [u8; 2]) -> Option<Band> {
        let _ = ranks;
        None
    }

    /// Checks that the session answers contact queries between two meshes.
    ///
    /// # Errors
    /// [`Declined`] with the reason.
    fn supports_contacts(&self) -> Result<(), Declined> {
        self.supports(PredicateKind::Compare)?;
        self.supports(PredicateKind::Orient2d)?;
        match self.scene().dimension() {
            Dimension::Two => Ok(()),
            Dimension::Three => self.supports(PredicateKind::Orient3d),
        }
    }

    /// Returns true if the session registers the two vertices, one of each mesh, as one point.
    ///
    /// This query and the following ones are the pairs of a hierarchy. Each pair is queried only if none of its
    /// sub-pairs was registered (a sub-pair is a face of one simplex with a face of the other). Then its answer says
    /// whether the two simplices meet, and the weights say where. The session chooses the method; the default uses
    /// signs.
    fn vertex_vertex(&self, a: Vertex, p: Vertex) -> bool {
        contact::vertex_vertex(self, a, p)
    }

    /// The position of the vertex on the edge if the session registers it there, else `None`.
    ///
    /// The position is a fraction of the way from the edge's first vertex to its second.
    fn edge_vertex(&self, edge: [Vertex; 2], p: Vertex) -> Option<f64> {
        contact::edge_vertex(self, edge, p)
    }

    /// The point where two edges meet, as the fraction of the way along each, or `None`.
    ///
    /// In the plane the point is a crossing, in space a degeneracy.
    fn edge_edge(&self, e: [Vertex; 2], f: [Vertex; 2]) -> Option<[f64; 2]> {
        contact::edge_edge(self, e, f)
    }

    /// The barycentric coordinates of the vertex in the triangle, or `None` if it is outside.
    ///
    /// In space such a vertex is a degeneracy.
    fn triangle_vertex(&self, triangle: [Vertex; 3], p: Vertex) -> Option<[f64; 3]> {
        contact::triangle_vertex(self, triangle, p)
    }

    /// The point where the edge pierces the triangle, or `None` (3D scenes).
    ///
    /// The point is given by its barycentric coordinates and by its fraction of the way along the edge.
    fn triangle_edge(&self, triangle: [Vertex; 3], edge: [Vertex; 2]) -> Option<([f64; 3], f64)> {
        contact::triangle_edge(self, triangle, edge)
    }

    /// The barycentric coordinates of the vertex in the tetrahedron, or `None` if it is outside (3D scenes).
    fn tetrahedron_vertex(&self, tetrahedron: [Vertex; 4], p: Vertex) -> Option<[f64; 4]> {
        contact::tetrahedron_vertex(self, tetrahedron, p)
    }

    /// [`Predicates::compare`] for many pairs, in order.
    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        for (&[a, b], out) in queries.iter().zip(out) {
            *out = self.compare(axis, a, b);
        }
    }

    /// [`Predicates::orient2d`] for many triples, in order.
    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        for (&[a, b, c], out) in queries.iter().zip(out) {
            *out = self.orient2d(plane, a, b, c);
        }
    }

    /// [`Predicates::orient2d`] of one line through a and b with many points c, in order.
    fn orient2d_line(&self, plane: Plane, [a, b]: [Vertex; 2], points: &[Vertex], out: &mut [Sign]) {
        for (&c, out) in points.iter().zip(out) {
            *out = self.orient2d(plane, a, b, c);
        }
    }

    /// [`Predicates::orient3d`] for many quadruples, in order.
    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        for (&[a, b, c, d], out) in queries.iter().zip(out) {
            *out = self.orient3d(a, b, c, d);
        }
    }

    /// [`Predicates::orient3d`] of one plane through a, b and c with many points d, in order.
    fn orient3d_plane(&self, [a, b, c]: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) {
        for (&d, out) in points.iter().zip(out) {
            *out = self.orient3d(a, b, c, d);
        }
    }

    /// [`Predicates::incircle`] for many quadruples, in order.
    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        for (&[a, b, c, d], out) in queries.iter().zip(out) {
            *out = self.incircle(a, b, c, d);
        }
    }

    /// [`Predicates::insphere`] for many quintuples, in order.
    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        for (&[a, b, c, d, e], out) in queries.iter().zip(out) {
            *out = self.insphere(a, b, c, d, e);
        }
    }
}
