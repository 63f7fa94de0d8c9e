//! The expected measures of the union of random cubes.
//!
//! N cubes of edge d < 1/2 have their lower corners uniform in [0, 1 − d]³. A cube covers a point x of the axis with
//! the probability p₁(x) = |[x − d, x] ∩ [0, 1 − d]| / (1 − d). It rises from 0 to w = d / (1 − d) over a ramp of
//! length d, stays there, and falls over another ramp. With p = p₁(x)p₁(y)p₁(z):
//! * A point is in the union with the probability 1 − (1 − p)^N, so E(volume) = ∫ 1 − (1 − p)^N.
//! * The lower x face of a cube is at a uniform x in [0, 1 − d]. A point (y, z) is on it with the probability
//!   p₁(y)p₁(z), and it is boundary if none of the other cubes covers it. By symmetry, E(area) = 6 ∫ N/(1 − d) ·
//!   p₁(y)p₁(z) (1 − p)^(N − 1) over those x and all y and z.
//! * The edges of cubes likewise have 12 ∫ N/(1 − d)² · p₁(z) (1 − p)^(N − 1) over those x and y and all z. The lines
//!   where the x face of one cube meets the y face of another have 12 ∫ N(N − 1)/(1 − d)² · p₁(x)p₁(y)p₁(z)² (1 − p)^(N
//!   − 2) over the same.
//!
//! Each integral splits into ramps and plateaus of each axis. On a ramp p₁ = ws with s uniform in [0, 1], on a plateau
//! s = 1. The integrands are smooth functions of the s, so Gauss' rule integrates them.

/// The expected mass properties of random cubes in the unit cube.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Expected {
    /// The expected volume.
    pub volume: f64,
    /// The expected area.
    pub area: f64,
    /// The expected edge length.
    pub edge_length: f64,
}

/// The number of nodes of Gauss' rule on each piece of a ramp.
const NODES: usize = 12;

/// Pairs for one axis: the factor s of p₁, and its weight, the length of the axis that has it.
struct Axis(Vec<[f64; 2]>);

impl Axis {
    /// An axis with this many ramps of length d, and a plateau on the rest of `length`.
    fn new(ramps: f64, d: f64, length: f64, pieces: u32) -> Axis {
        let mut all = vec![[1.0, length - ramps * d]];
        let width = 1.0 / f64::from(pieces);
        for piece in 0..pieces {
            for [at, weight] in gauss() {
                all.push([(f64::from(piece) + at) * width, weight * width * ramps * d]);
            }
        }
        Axis(all)
    }
}

/// The nodes and weights of Gauss' rule on [0, 1]: zeros of a Legendre polynomial, by Newton's method.
fn gauss() -> [[f64; 2]; NODES] {
    let n = f64::from(u32::try_from(NODES).unwrap_or(u32::MAX));
    std::array::from_fn(|k| {
        let k = f64::from(u32::try_from(k).unwrap_or(u32::MAX));
        let mut x = (std::f64::consts::PI * (k + 0.75) / (n + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..100 {
            let (mut last, mut now) = (1.0, x);
            let mut degree = 1.0;
            while degree < n {
                (last, now) = (now, ((2.0 * degree + 1.0) * x * now - degree * last) / (degree + 1.0));
                degree += 1.0;
            }
            slope = n * (x * now - last) / (x * x - 1.0);
            let step = now / slope;
            x -= step;
            if step.abs() < 1e-16 {
                break;
            }
        }
        [(1.0 - x) / 2.0, 1.0 / ((1.0 - x * x) * slope * slope)]
    })
}

/// The integral ∫ f(sx, sy, sz) over all three axes.
fn integral(axes: [&Axis; 3], f: impl Fn([f64; 3]) -> f64) -> f64 {
    let mut sum = 0.0;
    for &[x, by_x] in &axes[0].0 {
        for &[y, by_y] in &axes[1].0 {
            for &[z, by_z] in &axes[2].0 {
                sum += by_x * by_y * by_z * f([x, y, z]);
            }
        }
    }
    sum
}

impl Expected {
    /// The expected measures of this number of cubes with this edge.
    ///
    /// # Panics
    /// If there are no cubes, or the edge is not between 0 and 1/2.
    #[must_use]
    pub fn new(cubes: u32, edge: f64) -> Expected {
        Expected::with_pieces(cubes, edge, 4)
    }

    /// The expected measures as in [`Expected::new`], with ramps cut into this many pieces; a test compares several
    /// numbers of pieces.
    ///
    /// # Panics
    /// Like [`Expected::new`].
    #[must_use]
    pub fn with_pieces(cubes: u32, edge: f64, pieces: u32) -> Expected {
        assert!(cubes > 0 && edge > 0.0 && edge < 0.5, "some cubes, with edges between 0 and 1/2");
        let (n, d) = (f64::from(cubes), edge);
        let w = d / (1.0 - d);
        // The places of a point, and the places of a lower face.
        let (points, faces) = (Axis::new(2.0, d, 1.0, pieces), Axis::new(1.0, d, 1.0 - d, pieces));
        // The logarithm of (1 − p)^m, and the power.
        let log_free = |[x, y, z]: [f64; 3], m: f64| m * (-w * w * w * x * y * z).ln_1p();
        let free = |s: [f64; 3], m: f64| log_free(s, m).exp();
        let volume = integral([&points, &points, &points], |s| -log_free(s, n).exp_m1());
        let by_face = n / (1.0 - d);
        let area = integral([&faces, &points, &points], |s| w * s[1] * w * s[2] * free(s, n - 1.0));
        let by_edge = by_face / (1.0 - d);
        let convex = integral([&faces, &faces, &points], |s| w * s[2] * free(s, n - 1.0));
        let reflex = integral([&faces, &faces, &points], |s| {
            let [x, y, z] = s.map(|s| w * s);
            x * y * z * z * free(s, n - 2.0)
        });
        Expected { volume, area: 6.0 * by_face * area, edge_length: 12.0 * by_edge * (convex + (n - 1.0) * reflex) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_cube_has_its_own_measures() {
        for d in [1e-3, 0.1, 0.3, 0.49] {
            let one = Expected::new(1, d);
            let pairs = [(one.volume, d * d * d), (one.area, 6.0 * d * d), (one.edge_length, 12.0 * d)];
            for (found, known) in pairs {
                assert!((found / known - 1.0).abs() < 1e-12, "{found} for {known}");
            }
        }
    }

    #[test]
    fn the_volume_of_two_cubes_is_known() {
        // E|A ∩ B| = (E of the overlap of two intervals)³, that is, the cube of ∫ p₁².
        for d in [0.01, 0.2, 0.4] {
            let w: f64 = d / (1.0 - d);
            let overlap = w * w * ((1.0 - 2.0 * d) + 2.0 * d / 3.0);
            let known = 2.0 * d * d * d - overlap.powi(3);
            assert!((Expected::new(2, d).volume / known - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn more_nodes_change_nothing() {
        let of = [(1000, 0.3), (100_000, 0.0215), (10_000_000, 0.00464), (1000, 0.1)];
        for (cubes, d) in of.into_iter().step_by(predicament_effort::some_or_all(2, 1)) {
            let (few, many) = (Expected::new(cubes, d), Expected::with_pieces(cubes, d, 9));
            for [few, many] in [[few.volume, many.volume], [few.area, many.area], [few.edge_length, many.edge_length]] {
                assert!((few / many - 1.0).abs() < 1e-9, "{cubes} of {d}: {few} and {many}");
            }
        }
    }

    #[test]
    fn far_from_the_walls_the_volume_is_exponential() {
        // With N d³ = 1 and d small, the union is the whole cube without a share of 1/e, up to terms in d.
        let cubes = 1_000_000_000_u32;
        let volume = Expected::new(cubes, f64::from(cubes).cbrt().recip()).volume;
        assert!((volume - (1.0 - (-1.0_f64).exp())).abs() < 3e-3, "{volume}");
    }
}
