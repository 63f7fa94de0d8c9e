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
    Axis, Band, Construction, Constructs, Contract, Counts, Declined, Dimension, Off, Plane, PredicateKind, Question,
    Refused, Scene, Sessions, Sign, Tally, Vertex, contact,
};

/// How a backend answers a batch of queries.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Batches {
    /// The backend has code for batches, such as in vector registers.
    Own,
    /// A batch is a loop over single queries.
    Loop,
}

/// A way to answer predicates: exact, perturbed, by tolerances. It prepares a session for a scene.
pub trait Backend: Send + Sync {
    /// A backend prepared for one scene.
    type Session<'s, T: Tally + 's>: Predicates + 's
    where
        Self: 's;

    /// The name on the command line and in every file, with its parameters.
    fn name(&self) -> String;

    /// What it promises about the answers to this predicate.
    fn contract(&self, kind: PredicateKind) -> Contract;

    /// The names of the stages that can settle a query, cheapest first; at
    /// most [`MAX_STAGES`](crate::MAX_STAGES).
    fn stages(&self) -> &'static [&'static str];

    /// Whether its sessions answer batches of this predicate by code of their own; if not said otherwise, by a loop over
    /// single queries.
    fn batches(&self, kind: PredicateKind) -> Batches {
        let _ = kind;
        Batches::Loop
    }

    /// What its sessions do when they are asked to
    /// [construct](Predicates::construct) vertices; if not said otherwise, they decline.
    fn constructs(&self) -> Constructs {
        Constructs::Declines
    }

    /// The version of the library behind it, where that is another one's.
    fn version(&self) -> Option<String> {
        None
    }

    /// The same backend with predicates that return zero at once, where the way to them costs
    /// something: what the binding of a library of another language takes.
    fn binding(&self) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }

    /// Prepares a session: the place to look at the scene's coordinates.
    ///
    /// # Errors
    /// [`Declined`] where the backend can't take the scene at all.
    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Self::Session<'s, T>, Declined>;

    /// A session behind a pointer, for callers that are generic over nothing; with counts of stages, or without.
    ///
    /// Whoever calls it compiles the sessions. A backend that writes the method out by [`boxed_here!`](crate::boxed_here) compiles them in its own
    /// crate, once for all callers.
    ///
    /// # Errors
    /// Those of [`prepare`](Backend::prepare).
    fn boxed<'s>(&'s self, scene: &'s Scene, counts: Option<&'s Counts>) -> Result<Box<dyn Predicates + 's>, Declined> {
        Ok(match counts {
            Some(counts) => Box::new(self.prepare(scene, counts)?),
            None => Box::new(self.prepare(scene, Off)?),
        })
    }
}

/// Geometric questions about the vertices of one prepared scene.
///
/// The same question has the same answer, from any thread, whatever was asked
/// or constructed before: [`construct`](Predicates::construct) adds vertices and
/// changes none. Asking a predicate that [`supports`](Predicates::supports)
/// refuses panics; ask first, once a scene.
pub trait Predicates: Send + Sync {
    /// The scene that the session was prepared for, with the vertices that it
    /// has constructed since.
    fn scene(&self) -> &Scene;

    /// Constructs the vertices that these definitions define, and returns them
    /// in the same order.
    ///
    /// Algorithms call it between their parallel phases, with all vertices that
    /// one phase has found: it takes the session for itself. Ids depend on the
    /// definitions and their order alone. A definition gets the vertex that it
    /// has already, from the scene or an earlier call, also if it names the
    /// same lines and planes in another order. It may name constructed
    /// vertices, those of this call included. The cost is that of the
    /// definitions, not of the scene.
    ///
    /// If not said otherwise, the session declines;
    /// [`Backend::constructs`] tells in advance.
    ///
    /// # Errors
    /// [`Refused`] with the first definition that the session does not take,
    /// such as one of parallel lines. Then none of them has been constructed.
    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        let _ = definitions;
        Err(Refused::session("the backend answers about the vertices that a scene is prepared with"))
    }

    /// Whether the session answers this predicate: if not said otherwise,
    /// where the scene has the dimension for it.
    ///
    /// # Errors
    /// [`Declined`] with the reason.
    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        self.scene().has_dimension_for(kind)
    }

    /// The sign of a's coordinate minus b's.
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

    /// The floating-point determinant that the answer stood on, if there was
    /// one: what error measures look at, and how a NaN is found.
    fn estimate(&self, question: Question, args: &[Vertex]) -> Option<f64> {
        let _ = (question, args);
        None
    }

    /// The coordinates that stand for a constructed vertex from then on, in sessions that round; none where answers are
    /// about the very point, and for input vertices.
    fn rounded_point(&self, v: Vertex) -> Option<&[f64]> {
        let _ = v;
        None
    }

    /// The time that all predicates so far have taken by the session's own clock, in nanoseconds; none where the
    /// caller's clock sees nothing else.
    fn own_nanoseconds(&self) -> Option<u64> {
        None
    }

    /// What answers the same questions without the perturbation, with a zero where something is zero: the session's own backend, if it is
    /// exact; none where signs are rounded. By it results are taken back to where the input is.
    fn unperturbed(&self) -> Option<&dyn Sessions> {
        None
    }

    /// Whether the session answers as if all vertices of the scene's [second mesh](Scene::with_second_mesh) had moved by (ε, ε², ε³), and
    /// no others: then nothing changes within a mesh.
    fn moves_second_mesh(&self) -> bool {
        false
    }

    /// The tolerance band of this question, for sessions whose zero is a band.
    /// (In space each projection of `orient2d` can have its own.)
    fn band(&self, question: Question) -> Option<Band> {
        let _ = question;
        None
    }

    /// How far beyond a feature the session may still register it, in scene
    /// units: broad phases inflate their boxes by this. Zero for all whose
    /// answers are signs of exact or perturbed points.
    fn reach(&self) -> f64 {
        0.0
    }

    /// The tolerance band of a pair that registers degeneracies, by the ranks
    /// of its two simplices in either order: a distance, in scene units. None
    /// for pairs of full dimension, which are right or nothing, and for
    /// sessions without tolerances for contacts.
    fn contact_band(&self, ranks: [u8; 2]) -> Option<Band> {
        let _ = ranks;
        None
    }

    /// Whether the session answers about contacts between two meshes.
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

    /// Whether the two vertices, of two meshes, are registered as one.
    ///
    /// This and the questions that follow are the pairs of a hierarchy. Each
    /// is asked only where no sub-pair of it (a face of the one with a face of
    /// the other) was registered before; then its answer says whether the two
    /// meet, and weights say where. How they are settled is the session's
    /// business; by default it is by signs.
    fn vertex_vertex(&self, a: Vertex, p: Vertex) -> bool {
        contact::vertex_vertex(self, a, p)
    }

    /// Whether the vertex is registered as one of the edge's points, and the
    /// fraction of the way from the edge's first vertex to its second.
    fn edge_vertex(&self, edge: [Vertex; 2], p: Vertex) -> Option<f64> {
        contact::edge_vertex(self, edge, p)
    }

    /// Whether two edges meet, and the fraction of the way along each. In the
    /// plane this is a crossing, in space a degeneracy.
    fn edge_edge(&self, e: [Vertex; 2], f: [Vertex; 2]) -> Option<[f64; 2]> {
        contact::edge_edge(self, e, f)
    }

    /// Whether the vertex is in the triangle, and its barycentric coordinates
    /// there. In space this is a degeneracy.
    fn triangle_vertex(&self, triangle: [Vertex; 3], p: Vertex) -> Option<[f64; 3]> {
        contact::triangle_vertex(self, triangle, p)
    }

    /// Whether the edge pierces the triangle: the barycentric coordinates of
    /// the point there, and the fraction of the way along the edge (3D scenes).
    fn triangle_edge(&self, triangle: [Vertex; 3], edge: [Vertex; 2]) -> Option<([f64; 3], f64)> {
        contact::triangle_edge(self, triangle, edge)
    }

    /// Whether the vertex is in the tetrahedron, and its barycentric
    /// coordinates there (3D scenes).
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
