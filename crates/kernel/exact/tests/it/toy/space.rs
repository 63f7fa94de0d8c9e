//! Filters of higher degree in tiny formats: every tetrahedron of two bits, and samples where filters can be certain.
//!
//! Every query can be tried in formats of two bits only. There a filter of degree three or more is never certain,
//! because its constant exceeds one. So these formats try the errors. The filters are tried in formats of five to seven
//! bits, at random places of all queries. Their constants are ((1 + u)ⁿ − 1) / (1 − u)ⁿ for n roundings a term, and two
//! more.

use predicament_exact::anywhere::Bounded;

use super::*;
use crate::common::Random;

/// The constant for the roundings of a term.
fn constant_of(u: f64, roundings: i32) -> f64 {
    ((1.0 + u).powi(roundings) - 1.0) / (1.0 - u).powi(roundings + 2)
}

/// The determinant of the rows, in these columns, one bit each.
fn determinant<const N: usize>(rows: &[[i128; N]], columns: u32) -> i128 {
    let Some((first, rest)) = rows.split_first() else { return 1 };
    let kept = (0..N).filter(|column| columns >> column & 1 == 1).zip([1, -1].into_iter().cycle());
    kept.filter(|&(column, _)| first[column] != 0)
        .map(|(column, sign)| sign * first[column] * determinant(rest, columns & !(1 << column)))
        .sum()
}

/// The exact determinant of differences to the last point, with their squared lengths if `lifted`.
pub(crate) fn exact<const D: usize, const N: usize>(points: &[[i64; D]; N], lifted: bool) -> i128 {
    let last = points[N - 1];
    // (Four columns at most.)
    let row = |point: &[i64; D]| {
        let mut row = [0; 4];
        (0..D).for_each(|axis| row[axis] = i128::from(point[axis] - last[axis]));
        if lifted {
            row[D] = row.iter().map(|x| x * x).sum();
        }
        row
    };
    let rows: [[i128; 4]; N] = std::array::from_fn(|at| row(&points[at]));
    determinant(&rows[..N - 1], (1 << (N - 1)) - 1)
}

/// Asks a filter about points at random, with coordinates in a range; returns the number that it decides.
fn sampled<const P: i32, const K: i32, const Q: i32, const D: usize, const N: usize>(
    range: [i32; 2],
    count: usize,
    filter: impl Fn([[Toy<P, K, Q>; D]; N]) -> Bounded<Toy<P, K, Q>>,
    truth: impl Fn(&[[i64; D]; N]) -> i128,
) -> Result<usize, String> {
    let all = Toy::<P, K, Q>::all(range);
    let mut random = Random(7);
    let mut decided = 0;
    for _ in 0..count {
        let points: [[i64; D]; N] = std::array::from_fn(|_| std::array::from_fn(|_| all[random.below(all.len())]));
        let found = filter(points.map(|point| point.map(Toy::of)));
        if found.determinant.0.abs() > found.bound.0 {
            decided += 1;
            let exact = truth(&points);
            if (found.determinant.0 > 0.0) != (exact > 0) || exact == 0 {
                return Err(format!("{points:?}: {found:?}, and exactly {exact}"));
            }
        }
    }
    println!("{decided} of {count} queries are certain, of {}^{} in all", all.len(), D * N);
    Ok(decided)
}

/// The filters of a format in which most products are normal, and of one in which most underflow.
///
/// `share` times the proved constants.
fn filters<const Q: i32>(lowest: i32, count: usize, share: f64) -> [Result<usize, String>; 3] {
    let space = sampled::<5, 40, Q, 3, 4>(
        [lowest, 2],
        count,
        |points| anywhere::orient3d_by(points, Toy::above(share * constant_of(1.0 / 32.0, 8)), Toy::of(8)),
        |points| exact(points, false),
    );
    let circle = sampled::<6, 40, Q, 2, 4>(
        [lowest, 2],
        count,
        |points| anywhere::incircle_by(points, Toy::above(share * constant_of(1.0 / 64.0, 11)), Toy::of(16)),
        |points| exact(points, true),
    );
    let sphere = sampled::<7, 60, Q, 3, 5>(
        [lowest, 2],
        count,
        |points| anywhere::insphere_by(points, Toy::above(share * constant_of(1.0 / 128.0, 18)), Toy::of(64)),
        |points| exact(points, true),
    );
    [space, circle, sphere]
}

#[test]
fn no_sampled_query_of_higher_degree_is_certain_and_wrong() {
    let count = predicament_effort::scaled(1_000_000);
    for decided in [filters::<10>(8, count, 1.0), filters::<10>(5, count, 1.0), filters::<10>(2, count, 1.0)] {
        let [space, circle, sphere] = decided.map(|one| one.unwrap_or_else(|why| panic!("{why}")));
        println!("{space} tetrahedra, {circle} circles and {sphere} spheres of {count} each are certain");
    }
}

#[test]
fn constants_that_are_too_small_are_found_for_each() {
    for found in filters::<10>(8, 200_000, 0.02) {
        assert!(found.is_err(), "{found:?}");
    }
}

/// Tries the tetrahedra of the numbers in a range: errors are within `n` roundings before the last sum, and the loss by
/// underflow.
fn every_tetrahedron<const P: i32, const K: i32, const Q: i32>(
    range: [i32; 2],
    step: usize,
    n: i32,
) -> Result<u64, String> {
    let rows = differences::<3>(&Toy::<P, K, Q>::all(range));
    let u = 2_f64.powi(-P);
    let quantum = 2_f64.powi(-Q);
    let zero = Toy::of(0);
    let mut count = 0;
    for (index, x) in rows.iter().enumerate().step_by(step) {
        // (The first two axes exchanged: the same products, exchanged.)
        for y in &rows[index..] {
            let minors = [(1, 2), (2, 0), (0, 1)].map(|(a, b)| [x[a] * y[b], x[b] * y[a]]);
            for z in &rows {
                let point = |at: usize| [x[at], y[at], z[at]].map(Toy::<P, K, Q>::of);
                let found = estimate::orient3d(point(0), point(1), point(2), [zero; 3]);
                if !found.permanent.0.is_finite() {
                    continue;
                }
                count += 1;
                let exact: i64 = (0..3).map(|at| z[at] * (minors[at][0] - minors[at][1])).sum();
                let permanent: i64 = (0..3).map(|at| z[at].abs() * (minors[at][0].abs() + minors[at][1].abs())).sum();
                let heights: i64 = z.iter().map(|z| z.abs()).sum();
                #[allow(clippy::cast_precision_loss)] // below 2^53
                let [exact, permanent] = [exact, permanent].map(|x| x as f64 * quantum.powi(3));
                #[allow(clippy::cast_precision_loss)]
                let lost = quantum * 2.0 * (heights as f64 * quantum + 1.0);
                let bound = bound([permanent, lost], u, n);
                if (found.determinant.0 - exact).abs() > bound {
                    return Err(format!("{x:?}, {y:?}, {z:?}: {found:?}, and exactly {exact} of {permanent}"));
                }
            }
        }
    }
    Ok(count)
}

/// One row in 160 by day, at night all.
#[test]
fn errors_of_every_tetrahedron_of_two_bits_are_counted() {
    let step = predicament_effort::some_or_all(160, 1);
    for count in [every_tetrahedron::<2, 20, 0>([0, 1], step, 7), every_tetrahedron::<2, 20, 3>([0, 1], step, 7)] {
        let count = count.unwrap_or_else(|why| panic!("{why}"));
        println!("{count} tetrahedra");
        assert!(count > 100_000);
    }
    assert!(every_tetrahedron::<2, 20, 0>([0, 1], 160, -1).is_err(), "without any rounding");
}
