//! The crate `delaunay`: its `AdaptiveKernel`, which breaks ties by Simulation of Simplicity.
//!
//! The kernel uses the index of a point in the slice as the point's identity; later points move further. Without
//! sorting, the identity is the argument's position. The crate's own callers first sort the points of a simplex by
//! vertex key, and query spheres with the query point last (`core::util::canonical_points`): that is the engine
//! `delaunay-sorted`.
//!
//! `in_sphere` returns a side, whatever the orientation, so the determinant's sign is the side times the kernel's
//! orientation of the simplex. If the kernel returns an error instead of an answer (it has first-order terms only), the
//! answer is zero. It is also zero if a vertex occurs twice.

use delaunay::geometry::kernel::{AdaptiveKernel, Kernel};
use delaunay::geometry::point::Point;
use delaunay::geometry::traits::coordinate::Coordinate;
use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, by_id, locked};

/// The kernel, with points in the given order or sorted by vertex.
#[derive(Default)]
pub struct Delaunay<const SORTED: bool>;

impl<const SORTED: bool> Delaunay<SORTED> {
    fn orientation<const D: usize, const N: usize>(points: [Vertex<D>; N]) -> Answer
    where
        AdaptiveKernel<f64>: Kernel<D, Scalar = f64>,
    {
        let Some((sorted, odd)) = by_id(points) else { return Answer::Zero };
        let (points, odd) = if SORTED { (sorted, odd) } else { (points, false) };
        let sign = sign(AdaptiveKernel::new().orientation(&points.map(|point| Point::new(point.at))).ok());
        if odd { -sign } else { sign }
    }

    /// The sign of the determinant of a simplex and a query.
    fn sphere<const D: usize, const N: usize>(simplex: [Vertex<D>; N], query: Vertex<D>) -> Answer
    where
        AdaptiveKernel<f64>: Kernel<D, Scalar = f64>,
    {
        let orientation = Self::orientation(simplex);
        let sorted = by_id(simplex).filter(|_| simplex.iter().all(|point| point.id != query.id));
        let Some((sorted, _)) = sorted else { return Answer::Zero };
        let simplex = if SORTED { sorted } else { simplex };
        let simplex = simplex.map(|point| Point::new(point.at));
        let side = sign(AdaptiveKernel::new().in_sphere(&simplex, &Point::new(query.at)).ok());
        match orientation {
            Answer::Positive => side,
            Answer::Negative => -side,
            _ => Answer::Zero,
        }
    }
}

impl<const SORTED: bool> Engine for Delaunay<SORTED> {
    const NAME: &'static str = if SORTED { "delaunay-sorted" } else { "delaunay" };
    const ZERO: Zero = Zero::Never;
    const PREDICATES: &'static [Predicate] =
        &[Predicate::Orient2d, Predicate::Orient3d, Predicate::Incircle, Predicate::Insphere];
    const IN_ORDER: bool = true;

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "delaunay")
    }

    fn orient2d(&self, points: [Vertex<2>; 3]) -> Answer {
        Self::orientation(points)
    }

    fn orient3d(&self, points: [Vertex<3>; 4]) -> Answer {
        Self::orientation(points)
    }

    fn incircle(&self, [a, b, c, d]: [Vertex<2>; 4]) -> Answer {
        Self::sphere([a, b, c], d)
    }

    fn insphere(&self, [a, b, c, d, e]: [Vertex<3>; 5]) -> Answer {
        Self::sphere([a, b, c, d], e)
    }
}

fn sign(answer: Option<i32>) -> Answer {
    answer.map_or(Answer::Zero, |answer| answer.cmp(&0).into())
}
