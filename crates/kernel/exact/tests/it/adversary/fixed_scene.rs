//! Queries that reach the static bounds.

use predicament_arithmetic::bound::{self, static_incircle, static_insphere, static_orient2d, static_orient3d};
use predicament_effort::scaled;
use predicament_exact::estimate::{self, Estimate};

use super::climb;
use super::traced;
use super::verdict::Verdict;
use crate::common::{Random, nudge};
use crate::rational;

/// Every query that the static filter accepts, the semi-static filter must accept.
///
/// Given that, the static bound is as good as it can be: queries between opposite corners of the scene's box nearly
/// have the permanent that it assumes, and convict a bound two percent smaller.
#[test]
fn two_percent_of_each_are_caught_at_the_corners() {
    let mut random = Random(30);
    for _ in 0..scaled(1000) {
        let corner: [f64; 3] = std::array::from_fn(|_| (random.unit() + 0.01) * (40.0 * random.unit() - 20.0).exp2());
        let origin: [f64; 3] = std::array::from_fn(|axis| -corner[axis] * random.unit());
        let near = |random: &mut Random| corner.map(|x| nudge(x, -i64::try_from(random.below(4)).expect("small")));
        let [a, b, c, d] = std::array::from_fn(|_| near(&mut random));
        let extent: [f64; 3] = std::array::from_fn(|axis| corner[axis] - origin[axis]);
        let flat = |p: [f64; 3]| [p[0], p[1]];
        let [a2, b2, c2, origin2, extent2] = [a, b, c, origin, extent].map(flat);
        reaches(estimate::orient2d(a2, b2, origin2), bound::ORIENT2D, static_orient2d(extent2));
        reaches(estimate::orient3d(a, b, c, origin), bound::ORIENT3D, static_orient3d(extent));
        reaches(estimate::incircle(a2, b2, c2, origin2), bound::INCIRCLE, static_incircle(extent2));
        reaches(estimate::insphere(a, b, c, d, origin), bound::INSPHERE, static_insphere(extent));
    }
}

fn reaches(estimate: Estimate, constant: f64, fixed: f64) {
    let least = constant * estimate.permanent;
    let certain = |determinant| Estimate { determinant, ..estimate }.certain(constant).is_some();
    assert!(certain(fixed), "{fixed} is less than {least}");
    assert!(!certain(0.98 * fixed), "0.98 · {fixed} is more than {least}");
}

/// The errors of orient2d reach the static bound as well, within two percent.
///
/// All four differences are just above 1, from a corner of the scene.
#[test]
fn two_percent_of_static_orient2d_are_caught_by_errors() {
    let mut random = Random(31);
    // Just beyond the midpoint of two doubles above 1, minus 1.
    let rounded = |random: &mut Random, up: bool| {
        let half = ((random.unit() * 2f64.powi(27)).floor() + 0.5) * f64::EPSILON;
        if up { half.next_up() } else { half.next_down() }
    };
    let queries = (0..300_000).map(|_| {
        let a = [rounded(&mut random, true), rounded(&mut random, false)];
        let b = [rounded(&mut random, false), rounded(&mut random, true)];
        [a, b, [-1.0, -1.0]]
    });
    let score = |points: &[[f64; 2]; 3]| climb::badness(traced::orient2d(points), 15.0);
    let points = queries.max_by(|p, q| score(p).total_cmp(&score(q))).expect("queries");
    let [a, b, c] = points;
    let extent = std::array::from_fn(|axis| a[axis].max(b[axis]) - c[axis]);
    let verdict = Verdict::new(traced::orient2d, &points, &rational::orient2d(a, b, c));
    let fixed = static_orient2d(extent);
    assert!(verdict.below(fixed, 15.0), "{points:?}");
    assert!(!verdict.below(0.98 * fixed, 15.0), "{points:?}");
}
