//! `geogram_predicates`: a port of geogram's PCK.
//!
//! Its orientations are exact, zeros and all. Its circles and spheres break ties
//! by keys: the *lift* of a vertex moves and nothing else does, so four points on
//! a line or five on a plane stay a zero, and rightly.
//!
//! It asks for a side, not for the sign of a determinant, and only of a base
//! (three points, or four) that is positive by its own orientation, which in
//! space is the opposite of ours; a flat base is outside its domain. So the last
//! of the points that leaves a base is the query, the base is turned round if
//! need be, and the side becomes the determinant's sign by the orientation.

use geogram_predicates::{SosPoint, in_circle_2d_sos, in_sphere_3d_sos, orient_2d, orient_3d};
use predicament_predicates::{PredicateKind, Sign, ZeroMeaning};

use super::{Library, Point, sorted};

/// The crate `geogram_predicates`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Geogram;

impl Library for Geogram {
    fn name(&self) -> &'static str {
        "geogram"
    }

    fn zero(&self, kind: PredicateKind) -> Option<ZeroMeaning> {
        match kind {
            PredicateKind::Compare => None,
            PredicateKind::Orient2d | PredicateKind::Orient3d => Some(ZeroMeaning::Exact),
            PredicateKind::Incircle | PredicateKind::Insphere => Some(ZeroMeaning::Never),
        }
    }

    fn orient2d(&self, points: [Point<2>; 3]) -> Sign {
        let [a, b, c] = points.map(|point| point.at);
        ours(orient_2d(&a, &b, &c))
    }

    fn orient3d(&self, points: [Point<3>; 4]) -> Sign {
        let [a, b, c, d] = points.map(|point| point.at);
        -ours(orient_3d(&a, &b, &c, &d))
    }

    fn incircle(&self, points: [Point<2>; 4]) -> Sign {
        by_a_base(points, |&[a, b, c, d]| {
            let orientation = self.orient2d([a, b, c]);
            let [a, b] = if orientation == Sign::Negative { [b, a] } else { [a, b] };
            let side = || ours(in_circle_2d_sos(&keyed(a), &keyed(b), &keyed(c), &keyed(d)));
            (!orientation.is_zero()).then(|| orientation * side())
        })
    }

    fn insphere(&self, points: [Point<3>; 5]) -> Sign {
        by_a_base(points, |&[a, b, c, d, e]| {
            let orientation = self.orient3d([a, b, c, d]);
            let [a, b] = if orientation == Sign::Positive { [b, a] } else { [a, b] };
            let side = || ours(in_sphere_3d_sos(&keyed(a), &keyed(b), &keyed(c), &keyed(d), &keyed(e)));
            (!orientation.is_zero()).then(|| orientation * side())
        })
    }
}

/// The answer for the last point, or for one before it where the others are flat; zero where all are.
fn by_a_base<const D: usize, const N: usize>(
    points: [Point<D>; N],
    ask: impl Fn(&[Point<D>; N]) -> Option<Sign>,
) -> Sign {
    if sorted(points).1.is_zero() {
        return Sign::Zero;
    }
    let mut points = points;
    let mut parity = Sign::Positive;
    for query in (0..N).rev() {
        if let Some(sign) = ask(&points) {
            return parity * sign;
        }
        if query > 0 {
            points.swap(query - 1, N - 1);
            parity = -parity;
        }
    }
    Sign::Zero
}

fn keyed<const D: usize>(point: Point<D>) -> SosPoint<D> {
    SosPoint::new(point.at, point.key as u64)
}

fn ours(sign: geogram_predicates::Sign) -> Sign {
    match sign {
        geogram_predicates::Sign::Negative => Sign::Negative,
        geogram_predicates::Sign::Zero => Sign::Zero,
        geogram_predicates::Sign::Positive => Sign::Positive,
    }
}
