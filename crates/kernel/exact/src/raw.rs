//! Predicates on bare coordinates, without a prepared scene.
//!
//! They are for callers that have points and no scene. The filter is the one for any finite doubles
//! ([`anywhere`](crate::anywhere)): one comparison, and no branch before it. Queries that it leaves open use integers
//! of one limb if the differences are doubles that span few bits, else dyadic numbers.
//!
//! Coordinates must be finite; the functions panic otherwise.

use predicament_predicates::Sign;

use crate::ladder::alone;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};

// Open queries are passed on number by number: an array that must be in memory there would be built in memory before
// the filter, and every query would wait for it. (The same holds for values that a closure captures, if it is not
// inlined, and for points that a caller picks from a list: that is why filters are always inlined.)

/// The sign of (a − c) × (b − c): positive if a, b, c turn counterclockwise.
#[inline(always)]
#[must_use]
pub fn orient2d([[ax, ay], [bx, by], [cx, cy]]: [[f64; 2]; 3]) -> Sign {
    #[cold]
    #[inline(never)]
    fn climb(ax: f64, ay: f64, bx: f64, by: f64, cx: f64, cy: f64) -> Sign {
        alone::<Orient2d, 2, 3>(&[[ax, ay], [bx, by], [cx, cy]]).0
    }
    match Orient2d::anywhere([[ax, ay], [bx, by], [cx, cy]]).certain() {
        Some(sign) => sign,
        None => climb(ax, ay, bx, by, cx, cy),
    }
}

/// The sign of det(a − d, b − d, c − d): positive if d lies below the plane of a, b, c.
#[inline(always)]
#[must_use]
pub fn orient3d([[ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz]]: [[f64; 3]; 4]) -> Sign {
    #[cold]
    #[inline(never)]
    #[allow(clippy::too_many_arguments)]
    fn climb(
        ax: f64,
        ay: f64,
        az: f64,
        bx: f64,
        by: f64,
        bz: f64,
        cx: f64,
        cy: f64,
        cz: f64,
        dx: f64,
        dy: f64,
        dz: f64,
    ) -> Sign {
        alone::<Orient3d, 3, 4>(&[[ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz]]).0
    }
    match Orient3d::anywhere([[ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz]]).certain() {
        Some(sign) => sign,
        None => climb(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz),
    }
}

/// The sign of the circle test: positive if d is in the circle of a counterclockwise a, b, c.
#[inline(always)]
#[must_use]
pub fn incircle([[ax, ay], [bx, by], [cx, cy], [dx, dy]]: [[f64; 2]; 4]) -> Sign {
    #[cold]
    #[inline(never)]
    #[allow(clippy::too_many_arguments)]
    fn climb(ax: f64, ay: f64, bx: f64, by: f64, cx: f64, cy: f64, dx: f64, dy: f64) -> Sign {
        alone::<Incircle, 2, 4>(&[[ax, ay], [bx, by], [cx, cy], [dx, dy]]).0
    }
    match Incircle::anywhere([[ax, ay], [bx, by], [cx, cy], [dx, dy]]).certain() {
        Some(sign) => sign,
        None => climb(ax, ay, bx, by, cx, cy, dx, dy),
    }
}

/// The sign of the sphere test: positive if e is in the sphere of a positively oriented a, b, c, d.
#[inline(always)]
#[must_use]
pub fn insphere([a, b, c, d, e]: [[f64; 3]; 5]) -> Sign {
    #[cold]
    #[inline(never)]
    #[allow(clippy::too_many_arguments)]
    fn climb(
        ax: f64,
        ay: f64,
        az: f64,
        bx: f64,
        by: f64,
        bz: f64,
        cx: f64,
        cy: f64,
        cz: f64,
        dx: f64,
        dy: f64,
        dz: f64,
        ex: f64,
        ey: f64,
        ez: f64,
    ) -> Sign {
        alone::<Insphere, 3, 5>(&[[ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz], [ex, ey, ez]]).0
    }
    let ([ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz], [ex, ey, ez]) = (a, b, c, d, e);
    match Insphere::anywhere([[ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz], [ex, ey, ez]]).certain() {
        Some(sign) => sign,
        None => climb(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez),
    }
}
