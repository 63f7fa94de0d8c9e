//! Predicates that people use: plain doubles, a fixed epsilon, and the crate `robust`.

use predicament_conformance::{Error, Report, check};
use robust::{Coord, Coord3D};

fn p2([x, y]: [f64; 2]) -> Coord<f64> {
    Coord { x, y }
}

fn p3([x, y, z]: [f64; 3]) -> Coord3D<f64> {
    Coord3D { x, y, z }
}

pub fn naive(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
}

/// The number of wrong answers in sources that begin with these words.
fn wrong<P>(report: &Report<P>, sources: &[&str]) -> u64 {
    let of = |name: &str| sources.iter().any(|source| name.starts_with(source));
    report.sources.iter().filter(|source| of(&source.name)).map(|source| source.wrong).sum()
}

#[test]
fn plain_doubles_are_wrong_near_lines_and_beyond_the_range() {
    let report = check::orient2d(naive).report();
    for source in ["near", "kettner", "decimal", "wide", "pixel-map", "classics/kettner"] {
        assert!(wrong(&report, &[source]) > 0, "{source}\n{report}");
    }
    assert_eq!(wrong(&report, &["grid"]), 0, "{report}");
    let ranks: Vec<(&str, u64)> = report.ranking.iter().map(|rank| (rank.name, rank.wrong)).collect();
    assert_eq!(ranks[0], ("the exact sign", 0));
    let of = |name: &str| ranks.iter().find(|rank| rank.0 == name).unwrap().1;
    assert_eq!(of("this predicate"), of("plain f64"), "{report}");
    assert!(of("plain f32") > of("plain f64"), "{report}");
    assert!(!report.conforms());
}

#[test]
fn an_epsilon_answers_zero_for_signs() {
    let report = check::orient2d(|a, b, c| {
        let determinant = naive(a, b, c);
        if determinant.abs() < 1e-10 { 0.0 } else { determinant }
    })
    .report();
    let errors: Vec<Error> = report.findings.iter().map(|finding| finding.error).collect();
    assert!(errors.contains(&Error::FalseZero), "{report}");
    assert!(wrong(&report, &["near"]) > 100, "{report}");
}

/// The crate promises the exact sign unless a product overflows or underflows.
#[test]
fn robust_is_right_within_its_range_and_wrong_beyond() {
    let orient2d = |a, b, c| robust::orient2d(p2(a), p2(b), p2(c));
    let orient3d = |a, b, c, d| robust::orient3d(p3(a), p3(b), p3(c), p3(d));
    let incircle = |a, b, c, d| robust::incircle(p2(a), p2(b), p2(c), p2(d));
    let insphere = |a, b, c, d, e| robust::insphere(p3(a), p3(b), p3(c), p3(d), p3(e));
    check::orient2d(orient2d).cases(4000).exponents(-400..=400).assert();
    check::orient3d(orient3d).cases(4000).exponents(-250..=250).assert();
    check::incircle(incircle).cases(4000).exponents(-200..=200).assert();
    check::insphere(insphere).cases(4000).exponents(-160..=160).assert();
    let beyond = [
        check::orient2d(orient2d).cases(4000).report().sources,
        check::orient3d(orient3d).cases(4000).report().sources,
        check::incircle(incircle).cases(4000).report().sources,
        check::insphere(insphere).cases(4000).report().sources,
    ];
    for sources in beyond {
        let wide = |wide: bool| -> u64 {
            sources.iter().filter(|source| source.name.starts_with("wide") == wide).map(|source| source.wrong).sum()
        };
        assert!(wide(true) > 50, "overflow and underflow are found: {sources:?}");
        assert_eq!(wide(false), 0, "{sources:?}");
    }
}

#[test]
fn queries_outside_of_the_exponents_are_counted() {
    let report = check::orient2d(naive).cases(2000).exponents(-60..=10).report();
    let wide: Vec<_> = report.sources.iter().filter(|source| source.name.starts_with("wide")).collect();
    assert!(wide.iter().all(|source| source.left_out > 20), "{wide:?}");
    assert_eq!(report.left_out, report.sources.iter().map(|source| source.left_out).sum::<u64>());
}
