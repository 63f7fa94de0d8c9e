//! The crates, each behind [`Predicate`], with their conventions.
//!
//! `robust` and `geometry-predicates` are ports of Shewchuk's C, whose
//! conventions are ours. What the others need is said beside them, and that it
//! is right is tested on input that no rounding could spoil.

use predicament_exact::raw;
use predicament_predicates::{Sign, ZeroMeaning};
use robust::{Coord, Coord3D};
use simplicity::nalgebra::{Vector2, Vector3};

use super::predicate::{Base, Library, Predicate};

/// Our own `exact` on bare coordinates, without a prepared scene, as the other crates are asked.
pub enum Exact {}

impl Library for Exact {
    const NAME: &'static str = "exact";
    const VERSION: &'static str = env!("CARGO_PKG_VERSION");
    const ZERO: ZeroMeaning = ZeroMeaning::Exact;
}

impl Predicate<2, 3> for Exact {
    #[inline(always)]
    fn sign(points: &[[f64; 2]], at: [usize; 3]) -> Sign {
        raw::orient2d(at.map(|i| points[i]))
    }
}

impl Predicate<3, 4> for Exact {
    #[inline(always)]
    fn sign(points: &[[f64; 3]], at: [usize; 4]) -> Sign {
        raw::orient3d(at.map(|i| points[i]))
    }
}

impl Predicate<2, 4> for Exact {
    #[inline(always)]
    fn sign(points: &[[f64; 2]], at: [usize; 4]) -> Sign {
        raw::incircle(at.map(|i| points[i]))
    }
}

impl Predicate<3, 5> for Exact {
    #[inline(always)]
    fn sign(points: &[[f64; 3]], at: [usize; 5]) -> Sign {
        raw::insphere(at.map(|i| points[i]))
    }
}

/// `robust`.
pub enum Robust {}

impl Library for Robust {
    const NAME: &'static str = "robust";
    const VERSION: &'static str = env!("PREDICAMENT_ROBUST");
    const ZERO: ZeroMeaning = ZeroMeaning::Exact;
}

/// `geometry-predicates`.
pub enum GeometryPredicates {}

impl Library for GeometryPredicates {
    const NAME: &'static str = "geometry-predicates";
    const VERSION: &'static str = env!("PREDICAMENT_GEOMETRY_PREDICATES");
    const ZERO: ZeroMeaning = ZeroMeaning::Exact;
}

/// Crates that answer with a determinant.
macro_rules! determinants {
    ($($library:ty, $d:literal, $n:literal: $determinant:expr;)*) => {$(
        impl Predicate<$d, $n> for $library {
            #[inline(always)]
            fn sign(points: &[[f64; $d]], at: [usize; $n]) -> Sign {
                Sign::of($determinant(at.map(|i| points[i])))
            }

            fn is_nan(points: &[[f64; $d]], at: [usize; $n]) -> bool {
                $determinant(at.map(|i| points[i])).is_nan()
            }
        }
    )*};
}

determinants! {
    Robust, 2, 3: |[a, b, c]: [[f64; 2]; 3]| robust::orient2d(coord(a), coord(b), coord(c));
    Robust, 3, 4: |[a, b, c, d]: [[f64; 3]; 4]| robust::orient3d(coord3(a), coord3(b), coord3(c), coord3(d));
    Robust, 2, 4: |[a, b, c, d]: [[f64; 2]; 4]| robust::incircle(coord(a), coord(b), coord(c), coord(d));
    Robust, 3, 5: |[a, b, c, d, e]: [[f64; 3]; 5]| {
        robust::insphere(coord3(a), coord3(b), coord3(c), coord3(d), coord3(e))
    };
    GeometryPredicates, 2, 3: |[a, b, c]: [[f64; 2]; 3]| geometry_predicates::orient2d(a, b, c);
    GeometryPredicates, 3, 4: |[a, b, c, d]: [[f64; 3]; 4]| geometry_predicates::orient3d(a, b, c, d);
    GeometryPredicates, 2, 4: |[a, b, c, d]: [[f64; 2]; 4]| geometry_predicates::incircle(a, b, c, d);
    GeometryPredicates, 3, 5: |[a, b, c, d, e]: [[f64; 3]; 5]| geometry_predicates::insphere(a, b, c, d, e);
}

#[inline(always)]
fn coord([x, y]: [f64; 2]) -> Coord<f64> {
    Coord { x, y }
}

#[inline(always)]
fn coord3([x, y, z]: [f64; 3]) -> Coord3D<f64> {
    Coord3D { x, y, z }
}

/// `geogram_predicates`: a port of geogram's PCK, by the predicates that leave ties alone.
///
/// Its `orient_3d` is the opposite of ours. Its circles and spheres ask for a
/// side and not for the sign of a determinant: its documentation wants the
/// points that define them positively oriented, by its own orientation, and it
/// panics where they are degenerate. (Asked all the same, its filter and its
/// exact stage answer by different conventions.)
pub enum Geogram {}

impl Library for Geogram {
    const NAME: &'static str = "geogram_predicates";
    const VERSION: &'static str = env!("PREDICAMENT_GEOGRAM_PREDICATES");
    const ZERO: ZeroMeaning = ZeroMeaning::Exact;
    const BASE: Option<Base> = Some(Base { circle: Sign::Positive, sphere: Sign::Negative });
}

impl Predicate<2, 3> for Geogram {
    #[inline(always)]
    fn sign(points: &[[f64; 2]], [a, b, c]: [usize; 3]) -> Sign {
        sign_of(geogram_predicates::orient_2d(&points[a], &points[b], &points[c]))
    }
}

impl Predicate<3, 4> for Geogram {
    #[inline(always)]
    fn sign(points: &[[f64; 3]], [a, b, c, d]: [usize; 4]) -> Sign {
        -sign_of(geogram_predicates::orient_3d(&points[a], &points[b], &points[c], &points[d]))
    }
}

impl Predicate<2, 4> for Geogram {
    #[inline(always)]
    fn sign(points: &[[f64; 2]], [a, b, c, d]: [usize; 4]) -> Sign {
        sign_of(geogram_predicates::in_circle_2d(&points[a], &points[b], &points[c], &points[d]))
    }
}

impl Predicate<3, 5> for Geogram {
    #[inline(always)]
    fn sign(points: &[[f64; 3]], [a, b, c, d, e]: [usize; 5]) -> Sign {
        // Outside, for a base that we call negative, is our positive.
        -sign_of(geogram_predicates::in_sphere_3d(&points[a], &points[b], &points[c], &points[d], &points[e]))
    }
}

#[inline(always)]
fn sign_of(sign: geogram_predicates::Sign) -> Sign {
    match sign {
        geogram_predicates::Sign::Negative => Sign::Negative,
        geogram_predicates::Sign::Zero => Sign::Zero,
        geogram_predicates::Sign::Positive => Sign::Positive,
    }
}

/// `simplicity`: Simulation of Simplicity after Edelsbrunner and Mücke, on
/// expansions of its own. It never answers zero, and goes by the place of a
/// point in the list.
pub enum Simplicity {}

impl Library for Simplicity {
    const NAME: &'static str = "simplicity";
    const VERSION: &'static str = env!("PREDICAMENT_SIMPLICITY");
    const ZERO: ZeroMeaning = ZeroMeaning::Never;
}

impl Predicate<2, 3> for Simplicity {
    #[inline(always)]
    fn sign(points: &[[f64; 2]], [a, b, c]: [usize; 3]) -> Sign {
        positive(simplicity::orient_2d(points, vector2, a, b, c))
    }
}

impl Predicate<3, 4> for Simplicity {
    #[inline(always)]
    fn sign(points: &[[f64; 3]], [a, b, c, d]: [usize; 4]) -> Sign {
        positive(simplicity::orient_3d(points, vector3, a, b, c, d))
    }
}

impl Predicate<2, 4> for Simplicity {
    #[inline(always)]
    fn sign(points: &[[f64; 2]], [a, b, c, d]: [usize; 4]) -> Sign {
        positive(simplicity::in_circle(points, vector2, a, b, c, d))
    }
}

impl Predicate<3, 5> for Simplicity {
    #[inline(always)]
    fn sign(points: &[[f64; 3]], [a, b, c, d, e]: [usize; 5]) -> Sign {
        positive(simplicity::in_sphere(points, vector3, a, b, c, d, e))
    }
}

#[inline(always)]
fn vector2(points: &[[f64; 2]], at: usize) -> Vector2<f64> {
    Vector2::from(points[at])
}

#[inline(always)]
fn vector3(points: &[[f64; 3]], at: usize) -> Vector3<f64> {
    Vector3::from(points[at])
}

#[inline(always)]
fn positive(positive: bool) -> Sign {
    if positive { Sign::Positive } else { Sign::Negative }
}
