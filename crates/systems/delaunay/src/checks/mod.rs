//! Exact checks of Delaunay triangulations.
//!
//! The caller provides the sessions that decide signs: exact ones and, if ties are broken, those of the perturbed
//! scene. The checks read only the input and the triangles, and use nothing of the algorithm.
//!
//! # The checks
//! * `vertices`: the corners of a triangle are three different vertices of the scene.
//! * `copies`: each vertex without a triangle is a copy: it has the coordinates of a smaller vertex that is in a
//!   triangle, and names the smallest such vertex. With broken ties there are no copies.
//! * `chain`: without triangles, all vertices in order, on one line.
//! * `edges`: each edge belongs to two triangles, in both directions, or to one.
//! * `hull`: the edges of one triangle are one cycle through different vertices.
//! * `convex`, `wound once`: that cycle turns to the left or goes straight on, and goes around once.
//! * `positive`: every triangle is counterclockwise; a flat triangle is legal only if the perturbation gives it area.
//! * `area`: the areas add up to that of the convex hull, which is computed from the points alone.
//! * `empty circle`: the circle of a triangle contains no vertex across one of its edges.
//! * `empty`: no circle contains any vertex: all pairs of triangles and vertices, if they are few.
//! * `fan`: if four vertices at an edge are cocircular, the smallest of them is on the edge. Triangulations of other
//!   programs are not held to this rule.
//! * `constraint`: each constraint is an edge, or a chain of edges on its line. Edges of constraints are left out of
//!   `empty circle` and `fan`; the triangulation is then the constrained one (Lee and Lin 1986).
//!
//! # Why they are enough
//! Let triangles be counterclockwise, meet along edges, and be bounded by one convex cycle that is wound once. Then
//! they cover its inside once: the number of triangles over a point does not change at an inner edge. All vertices are
//! corners, so the cycle is the hull. Then `empty circle` implies `empty` (Delaunay's lemma). Take the way from a
//! triangle to a vertex: the power of the vertex with respect to the circles of the passed triangles only decreases,
//! and it is zero for the last one. With `fan` at every edge, each cocircular face is a fan from its smallest vertex:
//! an edge opposite of that vertex would have it among its four vertices and not as an end.

mod flaws;
mod outline;

pub use flaws::{Cut, Found, flaws};
