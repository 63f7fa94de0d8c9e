//! Minors with a lift column in plain floating point, and a bound on their error.
//!
//! The rows are differences to the last one, d = x − x′, which strikes the column of ones. The lift of a row is
//! relative to that of the last one as well. Along a column of the minor its origin may be anywhere (moving it adds
//! multiples of the other columns), so the origin is the last row and the share is d². Along the struck column, with
//! the origin o, the share is (x − o)² − (x′ − o)² = d·t with t = (x − o) + (x′ − o).
//!
//! # The bound
//! u = 2^-53. Each operation multiplies its exact result by a factor within 1 ± u of 1, and permanents (the same sums
//! with the magnitude of every difference and product) bound the cancellation. Counting factors: a difference has 1, t
//! has 2, d·t has 4, d² has 3; each d² that is added to d·t costs one more, so a lift has 5 in the plane and 6 in
//! space. In the plane its product with a difference has 7 and the minor 8; in space a cross product has 4, its product
//! with a lift 11, and the minor 13. The permanent has as many, and no subtraction among its sums. So the error is at
//! most ((1 + u)^13 − 1)/(1 − u)^13 < 14u times the computed permanent; the constant is 16u, a power of two, with which
//! a product is exact.
//!
//! # Range
//! The lifts' permanents are at most 2^400 together. Then differences in the columns are at most 2^200, cross products
//! 2^401, and nothing overflows. Products that underflow are off by 2^-1075 each, times their later factors: the three
//! of a lift by a cross product, the two of a cross product by a lift, in three terms less than 2^-668 together. 2^-600
//! in the bound covers that, and the losses of the permanent itself.

//!
//! # Where doubles make no error
//! Consider a scene where the exact backend's doubles make no error in a lifted predicate, of degree k in differences
//! of vertices. There every integer up to 2^53 in units of a power of two is a double, and so is every intermediate
//! less than 2^g·M^k, M a bound on differences, g = 7 for k = 5 and 4 for k = 4 (`Plan`). With M ≥ 1, and o a vertex'
//! coordinate, t is at most 2M, a lift less than 4M² in the plane and 6M² in space, a minor of it and a difference at
//! most 6M³ in the plane and 10M³ in space, one with two columns 3 · 2M² · 4M²: all less than that. There `EXACT` says
//! that an estimate is the determinant itself. An origin that is not a vertex' coordinate may be far away, so then it
//! does not.

use predicament_arithmetic::{bound, power_of_two};
use predicament_exact::estimate::{self, Estimate};
use predicament_predicates::Sign;

use crate::Lift;

/// The constant 16u, which multiplies the permanent.
const BOUND: f64 = power_of_two(-49);
/// A number far above all errors by underflow.
const TINY: f64 = power_of_two(-600);
/// The largest sum of lifts for which the bound is proved.
const LARGEST: f64 = power_of_two(400);

/// The lift's origin in the column that is not in the minor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Struck {
    /// The column.
    pub column: usize,
    /// The origin's coordinate there.
    pub origin: f64,
}

/// The sign of p − q.
#[inline(always)]
pub(crate) fn order(p: f64, q: f64) -> Sign {
    // A table lookup: a branch on a random sign costs more than the rest.
    const SIGNS: [Sign; 3] = [Sign::Negative, Sign::Zero, Sign::Positive];
    SIGNS[usize::from(p >= q) + usize::from(p > q)]
}

/// The turn of three points; `None` if rounding may have changed it.
///
/// Without a lift a product that underflows cannot mislead: if the other product is not small as well, it outweighs it,
/// and if it is, 2^-600 outweighs both.
#[inline(always)]
pub(crate) fn turn<const EXACT: bool>([p, q, r]: [[f64; 2]; 3]) -> Option<Sign> {
    let estimate = estimate::orient2d(p, q, r);
    certain::<EXACT>((estimate, estimate.permanent), bound::ORIENT2D)
}

/// The sign of the minor of three points with one coordinate, the lift and 1.
///
/// `None` if rounding may have changed it.
#[inline(always)]
pub(crate) fn flat<const D: usize>([p, q, r]: [&[f64; D]; 3], column: usize, struck: Struck) -> Option<Sign> {
    certain::<false>(minor2([p, q, r], column, struck), BOUND)
}

/// The sign of the minor of four points with two coordinates, the lift and 1.
///
/// `None` if rounding may have changed it.
#[inline(always)]
pub(crate) fn solid(points: [&[f64; 3]; 4], columns: [usize; 2], struck: Struck) -> Option<Sign> {
    certain::<false>(minor3(points, columns, struck), BOUND)
}

/// The sign of the minor of some sorted points with these columns, a lift and 1; `None` if rounding may have changed
/// it.
///
/// Along each column that is not in the minor, the share of a lift is d·t with a separate origin, which the bound
/// allows: three of them are added with as many roundings as one of them and two squares.
#[inline(always)]
pub(crate) fn lifted<const EXACT: bool, const D: usize>(
    points: &[[f64; D]],
    rows: &[u8],
    columns: &[u8],
    lift: Lift,
) -> Option<Sign> {
    certain::<EXACT>(lifted_minor(points, rows, columns, lift)?, BOUND)
}

/// The estimate for [`lifted`]; `None` if there is no code for this number of rows or columns.
#[inline(always)]
fn lifted_minor<const D: usize>(points: &[[f64; D]], rows: &[u8], columns: &[u8], lift: Lift) -> Option<Ranged> {
    let at = |row: u8| &points[usize::from(row)];
    let mut origin = [None; D];
    for (axis, origin) in origin.iter_mut().enumerate() {
        *origin = lift.about[axis].map_or(Some(0.0), |about| Some(at(about)[axis]));
    }
    for &column in columns {
        origin[usize::from(column)] = None;
    }
    let row = |row: u8, last: u8| {
        let [point, last] = [at(row), at(last)];
        let (mut lift, mut size) = (0.0, 0.0);
        for axis in 0..D {
            let difference = point[axis] - last[axis];
            match origin[axis] {
                None => {
                    lift += difference * difference;
                    size += difference * difference;
                }
                Some(origin) => {
                    let [from, to] = [point[axis] - origin, last[axis] - origin];
                    lift += difference * (from + to);
                    size += difference.abs() * (from.abs() + to.abs());
                }
            }
        }
        let difference = |column: Option<&u8>| column.map_or(0.0, |&x| point[usize::from(x)] - last[usize::from(x)]);
        Row { differences: [difference(columns.first()), difference(columns.get(1))], lift, size }
    };
    match (rows, columns) {
        (&[p, last], []) => {
            let p = row(p, last);
            Some((Estimate { determinant: p.lift, permanent: p.size }, p.size))
        }
        (&[p, q, last], [_]) => Some(along(&row(p, last), &row(q, last))),
        (&[p, q, r, last], [_, _]) => Some(across(&row(p, last), &row(q, last), &row(r, last))),
        _ => None,
    }
}

/// An estimate, and the sum of the lifts' permanents.
type Ranged = (Estimate, f64);

#[inline(always)]
fn certain<const EXACT: bool>((estimate, lifts): Ranged, bound: f64) -> Option<Sign> {
    if EXACT {
        return estimate.above(0.0);
    }
    // (With NaN the comparison fails.)
    if lifts <= LARGEST { estimate.above(bound * estimate.permanent + TINY) } else { None }
}

/// The minor as [`flat`] estimates it, and the bound that its magnitude must exceed for its sign to be certain.
#[inline(always)]
pub(crate) fn flat_value<const D: usize>(points: [&[f64; D]; 3], column: usize, struck: Struck) -> (f64, f64) {
    value(minor2(points, column, struck))
}

/// The minor as [`solid`] estimates it, and the bound for its sign.
#[inline(always)]
pub(crate) fn solid_value(points: [&[f64; 3]; 4], columns: [usize; 2], struck: Struck) -> (f64, f64) {
    value(minor3(points, columns, struck))
}

#[inline(always)]
fn value((estimate, lifts): Ranged) -> (f64, f64) {
    let bound = if lifts <= LARGEST { BOUND * estimate.permanent + TINY } else { f64::NAN };
    (estimate.determinant, bound)
}

/// A row of a minor: differences to the last row, and the lift with its permanent.
struct Row<const K: usize> {
    differences: [f64; K],
    lift: f64,
    size: f64,
}

// Functions, and loops over indices, stay in registers; closures and `map` may not.
impl<const K: usize> Row<K> {
    #[inline(always)]
    fn new<const D: usize>(point: &[f64; D], last: &[f64; D], columns: [usize; K], struck: Struck) -> Row<K> {
        let [x, y] = [point[struck.column], last[struck.column]];
        let [from, to] = [x - struck.origin, y - struck.origin];
        let difference = x - y;
        let mut lift = difference * (from + to);
        let mut size = difference.abs() * (from.abs() + to.abs());
        let mut differences = [0.0; K];
        for i in 0..K {
            let difference = point[columns[i]] - last[columns[i]];
            lift += difference * difference;
            size += difference * difference;
            differences[i] = difference;
        }
        Row { differences, lift, size }
    }
}

#[inline(always)]
fn minor2<const D: usize>([p, q, r]: [&[f64; D]; 3], column: usize, struck: Struck) -> Ranged {
    let p = Row::new(p, r, [column], struck);
    let q = Row::new(q, r, [column], struck);
    along(&p, &q)
}

#[inline(always)]
fn along<const K: usize>(p: &Row<K>, q: &Row<K>) -> Ranged {
    let [x, y] = [p.differences[0], q.differences[0]];
    let determinant = x * q.lift - y * p.lift;
    let permanent = x.abs() * q.size + y.abs() * p.size;
    (Estimate { determinant, permanent }, p.size + q.size)
}

#[inline(always)]
fn minor3([p, q, r, s]: [&[f64; 3]; 4], columns: [usize; 2], struck: Struck) -> Ranged {
    let p = Row::new(p, s, columns, struck);
    let q = Row::new(q, s, columns, struck);
    let r = Row::new(r, s, columns, struck);
    across(&p, &q, &r)
}

#[inline(always)]
fn across(p: &Row<2>, q: &Row<2>, r: &Row<2>) -> Ranged {
    let [qr, rp, pq] = [cross(q, r), cross(r, p), cross(p, q)];
    let determinant = p.lift * qr[0] + q.lift * rp[0] + r.lift * pq[0];
    let permanent = p.size * qr[1] + q.size * rp[1] + r.size * pq[1];
    (Estimate { determinant, permanent }, p.size + q.size + r.size)
}

/// The cross product of two rows, and its permanent.
#[inline(always)]
fn cross(p: &Row<2>, q: &Row<2>) -> [f64; 2] {
    let ([px, py], [qx, qy]) = (p.differences, q.differences);
    let [left, right] = [px * qy, py * qx];
    [left - right, left.abs() + right.abs()]
}

#[cfg(test)]
mod tests {
    use predicament_predicates::PredicateKind;
    use proptest::prelude::*;
    use proptest::strategy::ValueTree;
    use rug::Rational;

    use super::*;
    use crate::definition::{self, determinant, rational};
    use crate::short;

    /// The exact minor by definition: columns, lift about the origin, ones; expanded along the last column.
    fn truth<const D: usize>(points: &[&[f64; D]], columns: &[usize], struck: Struck) -> Rational {
        let row = |point: &&[f64; D]| {
            let mut row: Vec<Rational> = columns.iter().map(|&column| rational(point[column])).collect();
            let squares: Rational = row.iter().map(|x| x.clone().square()).sum();
            row.push(squares + (rational(point[struck.column]) - rational(struck.origin)).square());
            row.push(Rational::from(1));
            row
        };
        determinant(&points.iter().map(row).collect::<Vec<_>>())
    }

    /// Asserts the properties of an estimate; returns true if the sign of its determinant is right.
    fn check((estimate, lifts): Ranged, certain: Option<Sign>, truth: &Rational) -> bool {
        let sign = Sign::from(truth.cmp0());
        assert!(certain.is_none_or(|certain| certain == sign), "{certain:?} is {sign:?}");
        if lifts <= LARGEST && estimate.permanent > 2.0 * TINY {
            // The bound as derived, not only as used.
            let error = (rational(estimate.determinant) - truth).abs();
            let allowed = rational(14.0 * f64::EPSILON / 2.0) * rational(estimate.permanent) + rational(TINY);
            assert!(error <= allowed, "{error} of {allowed}");
        }
        Sign::of(estimate.determinant) == sign
    }

    fn check_all(points: &[[f64; 3]; 5], is_about: bool, column: usize) -> [bool; 3] {
        let [p, q, r, s, first] = points.each_ref();
        let origin = |column: usize| if is_about { first[column] } else { 0.0 };
        // Flat minors of the first two axes, with the other one struck.
        let flat_column = column % 2;
        let struck = Struck { column: 1 - flat_column, origin: origin(1 - flat_column) };
        let triple = [p, q, r];
        let truth2 = truth(&triple, &[flat_column], struck);
        let two = check(minor2(triple, flat_column, struck), flat(triple, flat_column, struck), &truth2);
        assert!(short::flat(triple, flat_column, struck).is_none_or(|sign| sign == Sign::from(truth2.cmp0())));
        let columns = [[0, 1], [1, 2], [0, 2]][column];
        let struck = Struck { column: 3 - columns[0] - columns[1], origin: origin(3 - columns[0] - columns[1]) };
        let all = [p, q, r, s];
        let truth3 = truth(&all, &columns, struck);
        let three = check(minor3(all, columns, struck), solid(all, columns, struck), &truth3);
        assert!(short::solid(all, columns, struck).is_none_or(|sign| sign == Sign::from(truth3.cmp0())));
        let flat = triple.map(|point| columns.map(|column| point[column]));
        let ones = flat.map(|[x, y]| vec![rational(x), rational(y), Rational::from(1)]);
        let sign = Sign::from(determinant(&ones).cmp0());
        assert!(turn::<false>(flat).is_none_or(|certain| certain == sign));
        [two, three, Sign::of(estimate::orient2d(flat[0], flat[1], flat[2]).determinant) == sign]
    }

    /// Few values with long significands, and a few ulps beside them: minors are zero, or nearly.
    fn near_ties() -> impl Strategy<Value = [[f64; 3]; 5]> {
        let coordinate = (0..4_u8, -2..=2_i64).prop_map(|(digit, ulps)| {
            let x = 1.1 * f64::from(digit);
            if digit == 0 { x } else { f64::from_bits(x.to_bits().wrapping_add_signed(ulps)) }
        });
        prop::array::uniform5(prop::array::uniform3(coordinate))
    }

    fn any_points() -> impl Strategy<Value = [[f64; 3]; 5]> {
        let any = any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite());
        let ends = prop_oneof![Just(-230), Just(-1070), Just(190), Just(340), Just(600)];
        let scaled = (1..9_i32, ends).prop_map(|(digit, exponent)| f64::from(digit) * 2_f64.powi(exponent));
        prop::array::uniform5(prop::array::uniform3(prop_oneof![any, scaled, (-3..=3_i32).prop_map(f64::from)]))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(20_000)))]

        #[test]
        fn certain_is_right_near_ties(points in near_ties(), is_about: bool, column in 0..3_usize) {
            check_all(&points, is_about, column);
        }

        #[test]
        fn certain_is_right_for_all_exponents(points in any_points(), is_about: bool, column in 0..3_usize) {
            check_all(&points, is_about, column);
        }
    }

    /// The signs of the estimates themselves are sometimes wrong.
    ///
    /// Without a bound the tests above would fail.
    #[test]
    fn near_ties_need_the_bound() {
        let mut runner = proptest::test_runner::TestRunner::deterministic();
        let mut wrong = [0; 3];
        for case in 0..3000 {
            let points = near_ties().new_tree(&mut runner).expect("a case").current();
            for (wrong, right) in wrong.iter_mut().zip(check_all(&points, case % 2 == 0, case % 3)) {
                *wrong += usize::from(!right);
            }
        }
        assert!(wrong.iter().all(|&count| count > 0), "{wrong:?}");
    }

    /// The permanent by definition, and the sum of the lifts' permanents.
    ///
    /// They are of differences to the last row and of lifts along these axes.
    fn permanent<const D: usize>(
        points: &[&[f64; D]],
        columns: &[usize],
        axes: &[(usize, Option<f64>)],
    ) -> [Rational; 2] {
        fn of(rows: &[Vec<Rational>]) -> Rational {
            let Some((first, rest)) = rows.split_first() else { return Rational::from(1) };
            let without = |column: usize| {
                of(&rest.iter().map(|row| [&row[..column], &row[column + 1..]].concat()).collect::<Vec<_>>())
            };
            (0..rows.len()).map(|column| without(column) * &first[column]).sum()
        }
        let (last, points) = points.split_last().expect("a last row");
        let apart = |x: f64, y: f64| (rational(x) - rational(y)).abs();
        let size = |point: &[f64; D]| -> Rational {
            let share = |&(axis, origin): &(usize, Option<f64>)| {
                let difference = apart(point[axis], last[axis]);
                match origin {
                    None => difference.square(),
                    Some(origin) => difference * (apart(point[axis], origin) + apart(last[axis], origin)),
                }
            };
            axes.iter().map(share).sum()
        };
        let row = |point: &&[f64; D]| -> Vec<Rational> {
            let differences = columns.iter().map(|&column| apart(point[column], last[column]));
            differences.chain([size(point)]).collect()
        };
        let rows: Vec<Vec<Rational>> = points.iter().map(row).collect();
        let lifts = rows.iter().map(|row| &row[columns.len()]).sum();
        [of(&rows), lifts]
    }

    fn is_near(computed: f64, exact: &Rational) -> bool {
        (rational(computed) - exact).abs() <= rational(14.0 * f64::EPSILON / 2.0) * exact
    }

    /// Checks every lifted minor of a scheme, for points near ties.
    ///
    /// It compares the determinant with its definition, within the bound, and the permanent.
    fn check_lifted<const D: usize>(points: &[[f64; D]], terms: &[crate::Term]) {
        for term in terms {
            let Some(lift) = term.lift else { continue };
            let rows: Vec<&[f64; D]> = term.rows.iter().map(|&row| &points[usize::from(row)]).collect();
            let columns: Vec<usize> = term.columns.iter().copied().map(usize::from).collect();
            let origin = |axis: usize| lift.about[axis].map_or(0.0, |row| points[usize::from(row)][axis]);
            let truth = definition::minor(points, term);
            let (estimate, lifts) = lifted_minor(points, term.rows, term.columns, lift).expect("rows and columns");
            let sign = lifted::<false, D>(points, term.rows, term.columns, lift);
            check((estimate, lifts), sign, &truth);
            let along = |axis: usize| (!columns.contains(&axis)).then(|| origin(axis));
            let axes: Vec<(usize, Option<f64>)> = (0..D).map(|axis| (axis, along(axis))).collect();
            let [of_rows, of_lifts] = permanent(&rows, &columns, &axes);
            assert!(is_near(estimate.permanent, &of_rows), "{} is {of_rows}: {term:?}", estimate.permanent);
            assert!(is_near(lifts, &of_lifts), "{lifts} is {of_lifts}: {term:?}");
        }
    }

    #[test]
    fn lifted_minors_and_their_permanents_are_those_of_the_definition() {
        let mut runner = proptest::test_runner::TestRunner::deterministic();
        for _ in 0..predicament_effort::cases(400) {
            let points = near_ties().new_tree(&mut runner).expect("a case").current();
            for scheme in crate::Scheme::ALL {
                check_lifted(&points, scheme.terms(PredicateKind::Insphere));
                check_lifted(&points.map(|[x, y, _]| [x, y]), scheme.terms(PredicateKind::Incircle));
            }
            let [p, q, r, s, first] = points.each_ref();
            for origin in [0.0, first[2]] {
                let struck = Struck { column: 2, origin };
                let (estimate, lifts) = minor2([p, q, r], 0, struck);
                let [of_rows, of_lifts] = permanent(&[p, q, r], &[0], &[(0, None), (2, Some(origin))]);
                assert!(is_near(estimate.permanent, &of_rows) && is_near(lifts, &of_lifts));
                let (estimate, lifts) = minor3([p, q, r, s], [0, 1], struck);
                let axes = [(0, None), (1, None), (2, Some(origin))];
                let [of_rows, of_lifts] = permanent(&[p, q, r, s], &[0, 1], &axes);
                assert!(is_near(estimate.permanent, &of_rows) && is_near(lifts, &of_lifts));
            }
        }
    }

    #[test]
    fn all_lifted_minors_of_general_position_are_certain() {
        let points = [[0.1, 0.7, 0.2], [0.9, 0.3, 0.5], [0.4, 0.2, 0.8], [0.6, 0.5, 0.1], [0.3, 0.8, 0.6]];
        let mut minors = 0;
        for scheme in crate::Scheme::ALL {
            for term in scheme.terms(PredicateKind::Insphere) {
                if let Some(lift) = term.lift {
                    minors += 1;
                    assert!(lifted::<false, 3>(&points, term.rows, term.columns, lift).is_some(), "{term:?}");
                }
            }
            let points = points.map(|[x, y, _]| [x, y]);
            for term in scheme.terms(PredicateKind::Incircle) {
                if let Some(lift) = term.lift {
                    assert!(lifted::<false, 2>(&points, term.rows, term.columns, lift).is_some(), "{term:?}");
                }
            }
        }
        assert!(minors > 20, "{minors}");
    }

    #[test]
    fn general_position_is_certain() {
        let points = [[0.1, 0.7, 0.2], [0.9, 0.3, 0.5], [0.4, 0.2, 0.8], [0.6, 0.5, 0.1]];
        let [p, q, r, s] = points.each_ref();
        assert!(flat([p, q, r], 0, Struck { column: 1, origin: 0.2 }).is_some());
        assert!(solid([p, q, r, s], [0, 1], Struck { column: 2, origin: 0.0 }).is_some());
        assert!(turn::<false>([[0.1, 0.7], [0.9, 0.3], [0.4, 0.2]]).is_some());
    }
}
