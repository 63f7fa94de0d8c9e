//! Laws that answers must satisfy, whatever the truth is, decided exactly.
//!
//! A sign can be judged by the exact sign. Whole families of signs can also be
//! judged by one another, and the output of an algorithm by the geometry
//! around it, without knowing which single answer was wrong:
//!
//! * [`audit`]: contacts held to exact distances;
//! * [`axioms`]: laws between the answers to related queries;
//! * [`contacts`]: registered pairs, and the curves and surfaces that they merge;
//! * [`cubes`]: unions of cubes, measured another way;
//! * [`delaunay`]: Delaunay triangulations, all circles empty;
//! * [`hull`]: convex hulls, convex and around all points;
//! * [`overlay`]: arrangements of segments, and Boolean operations on polygons;
//! * [`partition`]: points of a line in its cells;
//! * [`mod@slice`]: the parts that planes make of a mesh;
//! * [`snap`]: drawings rounded to pixels;
//! * [`tiling`]: points of the plane in the regions of a map;
//! * [`triangulation`]: triangles of polygons.

pub mod audit;
pub mod axioms;
pub mod contacts;
pub mod cubes;
pub mod delaunay;
pub mod hull;
pub mod overlay;
pub mod partition;
pub mod slice;
pub mod snap;
mod sum;
pub mod tiling;
pub mod triangulation;
