//! The crate `delaunay`: its `AdaptiveKernel`, which breaks ties by Simulation of Simplicity.
//!
//! The kernel takes the place of a point in the slice for its identity, and the later place moves further. Asked as it stands, that
//! is the argument's place. The crate's own callers sort the points of a simplex by vertex key first and ask spheres with
//! the query last (`core::util::canonical_points`): that is the engine `delaunay-sorted`.
//!
//! `in_sphere` is a side, whatever the orientation, so the determinant's sign is that times the kernel's orientation of the
//! simplex. Where the kernel has an error in place of an answer (its terms are those of first order) the answer is zero, and so it is
//! where a vertex comes twice.

use delaunay::geometry::kernel::{AdaptiveKernel, Kernel};
use delaunay::geometry::point::Point;
use delaunay::geometry::traits::coordinate::Coordinate;
use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, by_id, locked};

/// The kernel, with points as they come or sorted by vertex.
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
