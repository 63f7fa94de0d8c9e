//! Generators of point clouds: in general position, and near and in every degenerate position.

use crate::algorithm::{PlaneMethod, SpaceMethod};
use predicament_corpus::{Family, Parts, Random, Recipe};
use predicament_formats::bits::integer;
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::Scene;

use super::cloud::{Cloud, Method, method};

/// A generator: this number of points of a family, from these random numbers.
type Points = fn(usize, &mut Random) -> Vec<f64>;

macro_rules! family {
    ($method:ty, $name:literal, $points:expr, $about:literal) => {
        Family {
            name: $name,
            reported_as: Some($name),
            parameters: &[],
            about: $about,
            read: |_, fields| recipe::<$method>(fields, $points),
        }
    };
}

/// The families of points of the plane.
pub(super) static PLANE: [Family; 7] = [
    family!(PlaneMethod, "hull-square", uniform::<2>, "points uniform in the unit square"),
    family!(PlaneMethod, "hull-disc", ball::<2>, "points uniform in a disc"),
    family!(PlaneMethod, "hull-circle", sphere::<2>, "points on a circle, rounded to doubles"),
    family!(PlaneMethod, "hull-cocircular", cocircular, "integer points on one circle, exactly"),
    family!(PlaneMethod, "hull-grid", grid::<2>, "points on small integers: many on one line, many at one place"),
    family!(PlaneMethod, "hull-collinear", collinear::<2>, "integer points on one line, some at one place"),
    family!(PlaneMethod, "hull-sliver", sliver::<2>, "points within a few ulps of a line"),
];

/// The families of points of space.
pub(super) static SPACE: [Family; 8] = [
    family!(SpaceMethod, "hull-cube", uniform::<3>, "points uniform in the unit cube"),
    family!(SpaceMethod, "hull-ball", ball::<3>, "points uniform in a ball"),
    family!(SpaceMethod, "hull-sphere", sphere::<3>, "points on a sphere, rounded to doubles"),
    family!(SpaceMethod, "hull-cospherical", cospherical, "integer points on one sphere, exactly"),
    family!(
        SpaceMethod,
        "hull-lattice",
        grid::<3>,
        "points on small integers: many in one plane, on one line or at one place"
    ),
    family!(SpaceMethod, "hull-coplanar", coplanar, "integer points in one plane"),
    family!(SpaceMethod, "hull-line", collinear::<3>, "integer points on one line, some at one place"),
    family!(SpaceMethod, "hull-slab", sliver::<3>, "points within a few ulps of a plane"),
];

fn recipe<M: Method>(fields: &Fields<'_, '_>, points: Points) -> Result<Recipe, CorpusError> {
    let method = method::<M>(fields)?;
    Ok(Recipe::new(
        |n| n.saturating_mul(M::DIMENSION.count() as u64),
        move |making| {
            let coordinates = points(making.n, &mut making.random());
            let scene = Scene::new(M::DIMENSION, coordinates).expect("generators make finite points");
            let cloud = Cloud { points: scene.len(), method };
            Parts::new(scene, cloud)
        },
    ))
}

fn points<const D: usize>(n: usize, mut point: impl FnMut() -> [f64; D]) -> Vec<f64> {
    (0..n).flat_map(|_| point()).collect()
}

fn uniform<const D: usize>(n: usize, rng: &mut Random) -> Vec<f64> {
    points(n, || [(); D].map(|()| rng.unit()))
}

/// A point of the unit ball around the origin, and its squared distance from the origin.
fn in_ball<const D: usize>(rng: &mut Random) -> ([f64; D], f64) {
    loop {
        let point = [(); D].map(|()| rng.between(-1.0, 1.0));
        let square: f64 = point.iter().map(|x| x * x).sum();
        if square <= 1.0 {
            return (point, square);
        }
    }
}

fn ball<const D: usize>(n: usize, rng: &mut Random) -> Vec<f64> {
    points(n, || in_ball::<D>(rng).0)
}

fn sphere<const D: usize>(n: usize, rng: &mut Random) -> Vec<f64> {
    points(n, || {
        loop {
            let (point, square) = in_ball::<D>(rng);
            // Near the centre, rounding moves a point too far.
            if square > 1e-4 {
                return point.map(|x| x / square.sqrt());
            }
        }
    })
}

/// A random item.
fn one_of<T: Copy>(items: &[T], rng: &mut Random) -> T {
    let last = i64::try_from(items.len()).expect("fewer than 2^63") - 1;
    items[usize::try_from(rng.integer(0, last)).unwrap_or(0)]
}

/// Points on the circle x² + y² = (5³·13²·17·29·37)², which has 3,780 integer solutions: products of the Gaussian
/// primes and their conjugates.
fn cocircular(n: usize, rng: &mut Random) -> Vec<f64> {
    let times = |[a, b]: [i64; 2], [c, d]: [i64; 2]| [a * c - b * d, a * d + b * c];
    let mut all = vec![[1, 0], [0, 1], [-1, 0], [0, -1]];
    for (prime, power) in [([2, 1], 6), ([3, 2], 4), ([4, 1], 2), ([5, 2], 2), ([6, 1], 2)] {
        let conjugate = [prime[0], -prime[1]];
        let factors = (0..=power)
            .map(|own| (0..power).fold([1, 0], |product, at| times(product, if at < own { prime } else { conjugate })));
        all = factors.flat_map(|factor| all.iter().map(move |&z| times(z, factor))).collect();
    }
    points(n, || one_of(&all, rng).map(integer))
}

/// The squared radius of the sphere of [`cospherical`].
const SQUARE: i64 = 1_000_002;

/// Points on the sphere x² + y² + z² = 1,000,002: all integer solutions.
fn cospherical(n: usize, rng: &mut Random) -> Vec<f64> {
    let mut all = Vec::new();
    for x in 0..=SQUARE.isqrt() {
        for y in 0..=(SQUARE - x * x).isqrt() {
            let rest = SQUARE - x * x - y * y;
            let z = rest.isqrt();
            if z * z == rest {
                all.push([x, y, z]);
            }
        }
    }
    points(n, || one_of(&all, rng).map(|x| integer(if rng.one_in(2) { x } else { -x })))
}

/// Points on a grid with about as many places as points.
fn grid<const D: usize>(n: usize, rng: &mut Random) -> Vec<f64> {
    let power = u32::try_from(D).expect("two or three");
    let side = (1_i64..).find(|side| side.pow(power) >= i64::try_from(n).unwrap_or(i64::MAX)).unwrap_or(1);
    points(n, || [(); D].map(|()| integer(rng.integer(0, side - 1))))
}

fn collinear<const D: usize>(n: usize, rng: &mut Random) -> Vec<f64> {
    let most = i64::try_from(n).expect("scenes are smaller than memory");
    let step: [i64; D] = std::array::from_fn(|axis| [3, -7, 5][axis]);
    points(n, || {
        let at = rng.integer(-most, most);
        step.map(|step| integer(at * step))
    })
}

/// Points in the plane 2x − 3y + z = 0.
fn coplanar(n: usize, rng: &mut Random) -> Vec<f64> {
    let most = i64::try_from(n).expect("scenes are smaller than memory").clamp(4, 1 << 40);
    points(n, || {
        let [x, y] = [(); 2].map(|()| rng.integer(-most, most));
        [x, y, 3 * y - 2 * x].map(integer)
    })
}

/// Points whose last coordinate is the first, moved by up to two ulps.
fn sliver<const D: usize>(n: usize, rng: &mut Random) -> Vec<f64> {
    points(n, || {
        let mut point = [(); D].map(|()| rng.between(0.5, 24.0));
        let ulps = rng.integer(-2, 2);
        point[D - 1] = f64::from_bits(point[0].to_bits().wrapping_add_signed(ulps));
        point
    })
}
