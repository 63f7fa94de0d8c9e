//! Delaunay triangulations held to what they are.
//!
//! Signs are decided by sessions that are handed in: exact ones, and where ties are broken those of the perturbed scene. Only
//! the input and the triangles are looked at; nothing of the algorithm is used.
//!
//! # The checks
//! * `vertices`: corners are vertices of the scene, three different ones.
//! * `copies`: each vertex that is in no triangle is a copy: it has the coordinates of a smaller vertex that is in one, and of
//!   those the smallest. Where ties are broken there are none.
//! * `chain`: without triangles, all vertices in order, in one line.
//! * `edges`: each edge is one of two triangles, in both directions, or of one.
//! * `hull`: the edges of one triangle are one cycle through different vertices.
//! * `convex`, `wound once`: that cycle turns to the left or goes straight on, and goes around once.
//! * `positive`: every triangle is counterclockwise; flat only where the perturbation opens it.
//! * `area`: the areas add up to that of the convex hull, which is found from the points alone.
//! * `empty circle`: across no edge is a vertex in the circle of a triangle.
//! * `empty`: in no circle is any vertex: all triangles and all vertices, where they are few.
//! * `fan`: where four vertices at an edge are on one circle, the smallest of them is on the edge.
//! * `constraint`: each constraint is an edge, or a chain of edges in its line. Edges of constraints are left out of
//!   `empty circle` and `fan`; the triangulation is then the constrained one (Lee and Lin 1986).
//!
//! # Why they are enough
//! Triangles that are counterclockwise, meet along edges, and are bounded by one convex cycle that is wound once cover the
//! inside of it once: the number of triangles over a point changes at no edge inside. All vertices are corners, so the cycle is
//! the hull. Then `empty circle` implies `empty` (Delaunay's lemma): on the way from a triangle to a vertex, the power of the
//! vertex in regard to the circles of the triangles that are passed only falls, and it is zero for the last one.
//! With `fan` at every edge, each face on a circle is one: an edge opposite of its smallest vertex would have that vertex
//! among the four and not on it.

mod flaws;
mod outline;

pub use flaws::{Found, flaws};
