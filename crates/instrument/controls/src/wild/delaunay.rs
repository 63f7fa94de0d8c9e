//! `delaunay`: its `AdaptiveKernel`, which breaks ties by Simulation of Simplicity.
//!
//! The kernel takes the place of a point in the slice for its identity, and the
//! later place moves further. Asked as it stands, that is the argument's place.
//! The crate's own callers sort the points of a simplex by vertex key first and ask
//! spheres with the query last (`core::util::canonical_points`); [`Delaunay::sorted`] does that.
//!
//! `in_sphere` is a side, whatever the orientation, so the determinant's sign is
//! that times the kernel's orientation of the simplex. Where the kernel has an
//! error in place of an answer (its terms are those of first order) we have a zero.

use delaunay::geometry::kernel::{AdaptiveKernel, Kernel};
use delaunay::geometry::point::Point as At;
use delaunay::geometry::traits::coordinate::Coordinate;
use predicament_predicates::{PredicateKind, Sign, ZeroMeaning};

use super::{Library, Point, sorted};

/// The crate `delaunay`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Delaunay {
    /// Whether points are sorted by key before the kernel sees them.
    pub sorted: bool,
}

impl Delaunay {
    /// The sign of the orientation of D + 1 points, in the crate's convention.
    fn orientation<const D: usize, const N: usize>(self, points: [Point<D>; N]) -> Sign
    where
        AdaptiveKernel<f64>: Kernel<D, Scalar = f64>,
    {
        let (in_order, parity) = sorted(points);
        if parity.is_zero() {
            return Sign::Zero;
        }
        let (points, parity) = if self.sorted { (in_order, parity) } else { (points, Sign::Positive) };
        sign(AdaptiveKernel::new().orientation(&points.map(|point| At::new(point.at))).ok()) * parity
    }

    /// Whether the query is inside the sphere of D + 1 points.
    fn side<const D: usize, const N: usize>(self, simplex: [Point<D>; N], query: Point<D>) -> Sign
    where
        AdaptiveKernel<f64>: Kernel<D, Scalar = f64>,
    {
        if simplex.iter().any(|point| point.key == query.key) {
            return Sign::Zero;
        }
        let simplex = if self.sorted { sorted(simplex).0 } else { simplex };
        sign(AdaptiveKernel::new().in_sphere(&simplex.map(|point| At::new(point.at)), &At::new(query.at)).ok())
    }
}

impl Library for Delaunay {
    fn name(&self) -> &'static str {
        if self.sorted { "delaunay:sorted" } else { "delaunay" }
    }

    fn zero(&self, kind: PredicateKind) -> Option<ZeroMeaning> {
        (kind != PredicateKind::Compare).then_some(ZeroMeaning::Never)
    }

    fn orient2d(&self, points: [Point<2>; 3]) -> Sign {
        self.orientation(points)
    }

    fn orient3d(&self, points: [Point<3>; 4]) -> Sign {
        self.orientation(points)
    }

    fn incircle(&self, [a, b, c, d]: [Point<2>; 4]) -> Sign {
        self.orient2d([a, b, c]) * self.side([a, b, c], d)
    }

    fn insphere(&self, [a, b, c, d, e]: [Point<3>; 5]) -> Sign {
        self.orient3d([a, b, c, d]) * self.side([a, b, c, d], e)
    }
}

fn sign(answer: Option<i32>) -> Sign {
    answer.map_or(Sign::Zero, |answer| Sign::from(answer.cmp(&0)))
}
