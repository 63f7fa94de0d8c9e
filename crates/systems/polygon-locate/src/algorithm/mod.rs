//! Location of points in the regions of a map (Franklin & Magalhães, 4.2).
//!
//! A ray goes up from the query point. The point is inside a region iff the ray crosses the region's boundary an *odd*
//! number of times (the paper says even, which is a slip). An edge is crossed iff the point's x lies in the half-open
//! interval l ≤ x < r of its ends and the point is below it.
//!
//! One pass over the edges above the point answers for all regions at once. A border between two regions is one edge:
//! it is tested once, and toggles both regions. So however wrong a backend's signs are, two neighbours cannot disagree
//! about their common border. A wrong sign moves the point *across* it; only signs that contradict each other make gaps
//! and overlaps.
//!
//! # Zeros
//! The same code serves exact, perturbed and tolerant sessions:
//! * a zero of the comparison counts as "left or equal", so a vertical edge and a touched right end are not crossings;
//! * a zero of the orientation, with the point's x in the closed x-range of the edge, puts the point *on the boundary*
//!   of the edge's regions. Then "inside" has no meaning for them, and their parity is not reported;
//! * under Simulation of Simplicity a zero never occurs for distinct vertices, and the code becomes the paper's
//!   algorithm.
//!
//! ```
//! # use predicament_polygon_locate::algorithm::{LocateIndex, locate_all};
//! # use predicament_exact::Exact;
//! # use predicament_mesh::PolygonMap;
//! # use predicament_predicates::{Backend, Off, Scene, Vertex};
//! let scene = Scene::from_points2(&[[0., 0.], [4., 0.], [0., 4.], [1., 1.], [2., 2.]])?;
//! let mut map = PolygonMap::new();
//! map.push("triangle", vec![(0..3).map(Vertex::input).collect()])?;
//!
//! let index = LocateIndex::new(&map, &scene);
//! let session = Exact.prepare(&scene, Off)?;
//! let queries = [Vertex::input(3), Vertex::input(4)];
//! let answers = locate_all(&index, &session, &queries, &|_| true);
//! assert_eq!((answers.inside(0), answers.boundary(0)), (&[0][..], &[][..]));
//! assert_eq!((answers.inside(1), answers.boundary(1)), (&[][..], &[0][..]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod all;
mod index;
mod single;
pub mod special;

pub use crate::answer::{Location, Locations};
pub use all::{CHUNK, locate_all, locate_all_specially, question_all};
pub use index::LocateIndex;
pub use single::Scratch;
