//! The filter whose bound is linear in the slacks, at the corners of what the slacks allow.

use predicament_exact::constructed::{
    Constructed,
    filter::{self, Approximate},
    tight,
};
use predicament_predicates::{Construction, Dimension, Sign, Vertex};
use rug::Rational;

use super::scenes::{distinct, scene};
use crate::common::Random;

/// The determinant of the differences to the last point, by expansion.
fn determinant<const D: usize>(points: &[[Rational; D]]) -> Rational {
    let rows: Vec<Vec<Rational>> =
        points[..D].iter().map(|p| p.iter().zip(&points[D]).map(|(x, y)| Rational::from(x - y)).collect()).collect();
    let minor = |p: &[Rational], q: &[Rational], i: usize, j: usize| {
        Rational::from(&p[i] * &q[j]) - Rational::from(&p[j] * &q[i])
    };
    match D {
        2 => minor(&rows[0], &rows[1], 0, 1),
        _ => (0..3).map(|k| minor(&rows[1], &rows[2], (k + 1) % 3, (k + 2) % 3) * &rows[0][k]).sum(),
    }
}

/// The number of certain and of wrong answers for queries whose true points are as far off as slacks allow.
///
/// Each query is nearly a tie. Every true coordinate is off in the direction that changes the determinant most. The
/// filter is told `granted` of the slacks.
fn corners<const D: usize>(
    seed: u64,
    granted: f64,
    answer: impl Fn(&[[Approximate; D]]) -> Option<Sign>,
) -> (usize, usize) {
    let mut random = Random(seed);
    let (mut certain, mut wrong) = (0, 0);
    for _ in 0..predicament_effort::scaled(20_000) {
        let slack: Vec<f64> = (0..=D).map(|_| 2f64.powi(i32::try_from(random.below(40)).expect("below 40"))).collect();
        let mut points: Vec<[f64; D]> = (0..=D).map(|_| std::array::from_fn(|_| random.unit() - 0.5)).collect();
        // The last point is moved into the line or plane of the others, and a little out of it.
        let shares: Vec<f64> = (0..D).map(|_| random.unit()).collect();
        let sum: f64 = shares.iter().sum();
        let away = slack.iter().fold(0.0, |most: f64, &x| most.max(x)) * 2f64.powi(-52) * random.unit();
        points[D] = std::array::from_fn(|axis| {
            (0..D).map(|i| shares[i] / sum * points[i][axis]).sum::<f64>() + away * (random.unit() - 0.5)
        });
        let exact = |x: f64| Rational::from_f64(x).expect("finite");
        let points: Vec<[Rational; D]> = points.iter().map(|p| std::array::from_fn(|axis| exact(p[axis]))).collect();
        let value = determinant(&points);
        let mut corner = points.clone();
        for i in 0..=D {
            for axis in 0..D {
                let mut moved = points.clone();
                moved[i][axis] += 1;
                let grows = determinant(&moved) > value;
                let off = exact(slack[i]) >> 53;
                if grows == (value > 0) { corner[i][axis] -= off } else { corner[i][axis] += off }
            }
        }
        let truth = Sign::from(determinant(&corner).cmp0());
        let near: Vec<[Approximate; D]> = points
            .iter()
            .zip(&slack)
            .map(|(p, slack)| std::array::from_fn(|axis| Approximate::near(p[axis].to_f64(), slack * granted)))
            .collect();
        if let Some(sign) = answer(&near) {
            certain += 1;
            wrong += usize::from(sign != truth);
        }
    }
    (certain, wrong)
}

#[test]
fn no_corner_of_the_slacks_has_another_sign() {
    let all = predicament_effort::scaled(20_000);
    let flat = |granted| corners::<2>(31, granted, |p| tight::orient2d(p[0], p[1], p[2]));
    let solid = |granted| corners::<3>(32, granted, |p| tight::orient3d(p[0], p[1], p[2], p[3]));
    for (certain, wrong) in [flat(1.0), solid(1.0)] {
        assert!(certain > all / 20 && certain < all / 2, "{certain} of {all}: too few near ties");
        assert_eq!(wrong, 0, "of {certain}");
    }
    for (certain, wrong) in [flat(0.9), solid(0.9)] {
        assert!(wrong > 0, "of {certain}");
    }
}

/// Points of three planes leave several percent open to the other filter, and hardly one to this one.
#[test]
fn few_general_queries_are_open() {
    let mut random = Random(33);
    let mut scene = scene(&mut random, Dimension::Three, 300, |random| 2.0 * random.unit() - 1.0);
    for _ in 0..300 {
        let planes =
            Construction::Tpi([distinct(&mut random, 300), distinct(&mut random, 300), distinct(&mut random, 300)]);
        scene.construct(planes).expect("input vertices");
    }
    let constructed = Constructed::new(&scene).expect("points");
    let (mut open, mut still) = (0, 0);
    for _ in 0..4000 {
        let query: [Vertex; 4] = distinct(&mut random, 300);
        let [a, b, c, d] = query.map(|v| {
            let (point, slack) = constructed.near(Vertex::constructed(v.index()));
            [0, 1, 2].map(|axis| Approximate::near(point[axis], slack))
        });
        open += usize::from(filter::orient3d(a, b, c, d, filter::ORIENT3D).is_none());
        still += usize::from(tight::orient3d(a, b, c, d).is_none());
    }
    assert!(open > 80 && still < 2, "{open} and {still} of 4000");
}
