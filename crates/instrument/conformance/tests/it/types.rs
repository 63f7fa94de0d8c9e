//! Coordinates of every type: right predicates conform, and overflow is found.

use predicament_conformance::{Error, check};

use crate::exact;

#[test]
fn singles_have_their_own_near_misses() {
    check::orient2d(|a: [f32; 2], b, c| exact::orient2d(a.map(f64::from), b.map(f64::from), c.map(f64::from))).assert();
    let naive = |a: [f32; 2], b: [f32; 2], c: [f32; 2]| (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
    let report = check::orient2d(naive).report();
    for family in ["near", "kettner", "wide-scaled", "wide-mixed"] {
        let source = report.sources.iter().find(|source| source.name.starts_with(family)).unwrap();
        assert!(source.wrong > 0, "{family}\n{report}");
    }
    // Products of singles are doubles, and their difference keeps its sign within the range.
    let in_doubles = |a: [f32; 2], b: [f32; 2], c: [f32; 2]| {
        let [a, b, c] = [a, b, c].map(|p| p.map(f64::from));
        (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
    };
    let better = check::orient2d(in_doubles).report();
    assert!(better.wrong < report.wrong / 2, "{} {}", better.wrong, report.wrong);
    assert!(report.left_out > 0, "scenes of doubles are left out and counted");
}

#[test]
fn integers_overflow_where_the_type_is_too_small() {
    let wide = |a: [i32; 2], b: [i32; 2], c: [i32; 2]| {
        let [a, b, c] = [a, b, c].map(|p| p.map(i128::from));
        (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
    };
    check::orient2d(wide).assert();
    // Differences fit, products do not.
    let narrow = |a: [i32; 2], b: [i32; 2], c: [i32; 2]| {
        let [a, b, c] = [a, b, c].map(|p| p.map(i64::from));
        ((a[0] - c[0]).wrapping_mul(b[1] - c[1])).wrapping_sub((a[1] - c[1]).wrapping_mul(b[0] - c[0]))
    };
    let report = check::orient2d(narrow).report();
    assert!(report.findings.iter().any(|finding| finding.error == Error::Flipped), "{report}");
    let checked = |a: [i32; 2], b: [i32; 2], c: [i32; 2]| {
        let minus = |x: i32, y: i32| x.checked_sub(y).expect("a difference overflows");
        i64::from(minus(a[0], c[0])) * i64::from(minus(b[1], c[1]))
            - i64::from(minus(a[1], c[1])) * i64::from(minus(b[0], c[0]))
    };
    let report = check::orient2d(checked).report();
    assert!(report.panicked > 0 && report.wrong == 0, "{report}");
    assert!(report.findings[0].got.to_string().contains("a difference overflows"), "{report}");
}

#[test]
fn long_integers_overflow_in_128_bits() {
    let in_128 = |a: [i64; 2], b: [i64; 2], c: [i64; 2]| {
        let [a, b, c] = [a, b, c].map(|p| p.map(i128::from));
        let (left, right) = ((a[0] - c[0]) * (b[1] - c[1]), (a[1] - c[1]) * (b[0] - c[0]));
        left.cmp(&right)
    };
    let report = check::orient2d(in_128).report();
    assert_eq!(report.wrong + report.undecided, 0, "each product fits\n{report}");
    let in_doubles = |a: [i64; 2], b: [i64; 2], c: [i64; 2]| {
        #[allow(clippy::cast_precision_loss)] // the fault
        let [a, b, c] = [a, b, c].map(|p| p.map(|x| x as f64));
        (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
    };
    assert!(check::orient2d(in_doubles).report().wrong > 10);
    let incircle = |a: [i64; 2], b: [i64; 2], c: [i64; 2], d: [i64; 2]| {
        let rows = [a, b, c].map(|p| {
            let [x, y] = [0, 1].map(|i| i128::from(p[i]) - i128::from(d[i]));
            [x, y, x.wrapping_mul(x).wrapping_add(y.wrapping_mul(y))]
        });
        let minor =
            |i: usize, j: usize| rows[i][0].wrapping_mul(rows[j][1]).wrapping_sub(rows[i][1].wrapping_mul(rows[j][0]));
        let [a, b, c] = [minor(1, 2), minor(2, 0), minor(0, 1)];
        rows[0][2].wrapping_mul(a).wrapping_add(rows[1][2].wrapping_mul(b)).wrapping_add(rows[2][2].wrapping_mul(c))
    };
    assert!(check::incircle(incircle).report().wrong > 10, "squares overflow");
}
