//! Planted faults: each check of a predicate finds one that only it can find, or that it is for.

use std::cmp::Ordering;

use predicament_conformance::{Answer, Error, Law, Sign, check};

use crate::exact::{incircle, insphere, orient2d, orient3d};

fn single<const D: usize>(point: [f64; D]) -> [f64; D] {
    #[allow(clippy::cast_possible_truncation)] // the fault
    point.map(|x| f64::from(x as f32))
}

/// A cast to f32 on the way to exact arithmetic, in each predicate.
#[test]
fn a_planted_cast_to_f32_is_found_in_each_predicate() {
    let reports = [
        check::orient2d(|a, b, c| caught(&[a, b, c], || orient2d(single(a), single(b), single(c))))
            .cases(2000)
            .report()
            .findings
            .len(),
        check::orient3d(|a, b, c, d| caught(&[a, b, c, d], || orient3d(single(a), single(b), single(c), single(d))))
            .cases(2000)
            .report()
            .findings
            .len(),
        check::incircle(|a, b, c, d| caught(&[a, b, c, d], || incircle(single(a), single(b), single(c), single(d))))
            .cases(2000)
            .report()
            .findings
            .len(),
        check::insphere(|a, b, c, d, e| {
            caught(&[a, b, c, d, e], || insphere(single(a), single(b), single(c), single(d), single(e)))
        })
        .cases(2000)
        .report()
        .findings
        .len(),
    ];
    assert!(reports.iter().all(|&findings| findings > 3), "{reports:?}");
}

/// Undecided where a single would be infinite: the fault is the rounding.
fn caught<const D: usize>(points: &[[f64; D]], sign: impl FnOnce() -> Sign) -> Option<Sign> {
    points.as_flattened().iter().all(|x| x.abs() < 1e38).then(sign)
}

/// The errors of a predicate, by kind.
fn errors(predicate: impl FnMut([f64; 2], [f64; 2], [f64; 2]) -> Answer) -> Vec<Error> {
    let report = check::orient2d(predicate).cases(2000).report();
    assert!(!report.conforms());
    let mut errors: Vec<Error> = report.findings.iter().map(|finding| finding.error).collect();
    errors.sort_unstable();
    errors.dedup();
    errors
}

#[test]
fn each_kind_of_error_is_found_and_named() {
    let on_zero = |answer: fn() -> Answer| {
        move |a, b, c| match orient2d(a, b, c) {
            Sign::Zero => answer(),
            sign => sign.into(),
        }
    };
    assert_eq!(errors(on_zero(|| 1.into())), [Error::MissedZero]);
    assert_eq!(errors(on_zero(|| f64::NAN.into())), [Error::NotANumber]);
    assert_eq!(errors(on_zero(|| None::<Sign>.into())), [Error::Undecided]);
    assert_eq!(errors(on_zero(|| panic!("a tie"))), [Error::Panicked]);
    let near = |a: [f64; 2], b, c| if a[0] == 0.5 { orient2d(a, b, c).into() } else { Answer::from(0) };
    assert_eq!(errors(near), [Error::FalseZero]);
    let far = |a: [f64; 2], b, c| {
        let sign = orient2d(a, b, c);
        if a[0].abs() > 1e9 { (-sign).into() } else { sign.into() }
    };
    assert_eq!(errors(far), [Error::Flipped]);
}

/// The number of broken pairs of each law, for a predicate that is wrong in general.
fn broken(predicate: impl FnMut([f64; 2], [f64; 2], [f64; 2]) -> Sign) -> [u64; 3] {
    let report = check::orient2d(predicate).report();
    assert!(report.laws.iter().all(|law| law.tested > 500), "{report}");
    assert!(report.laws.iter().all(|law| (law.broken > 0) == law.first.is_some()));
    let of = |law: Law| report.laws.iter().find(|report| report.law == law).unwrap().broken;
    Law::ALL.map(of)
}

/// Signs that are wrong, and yet break one law only.
#[test]
fn each_law_has_a_fault_that_breaks_it_alone() {
    let order = |a: [f64; 2], b: [f64; 2]| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]));
    let parity = |a, b, c| {
        let swaps = [order(a, b), order(b, c), order(a, c)].iter().filter(|order| order.is_gt()).count();
        if swaps.is_multiple_of(2) { Sign::Positive } else { Sign::Negative }
    };
    let are_distinct = |a, b, c| ![order(a, b), order(b, c), order(a, c)].contains(&Ordering::Equal);
    // A tie is broken by the order of points, which is kept by translation and by scaling: only swaps of equal points
    // contradict each other.
    let tie = |a, b, c| match orient2d(a, b, c) {
        Sign::Zero => Sign::Positive,
        sign => sign,
    };
    let [swaps, moves, scales] = broken(tie);
    assert!(swaps > 0 && moves == 0 && scales == 0, "{swaps} {moves} {scales}");
    // Signs that depend on the place: positive parity beyond a line, the right sign on this side.
    let place = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        let is_beyond = [a, b, c].iter().any(|p| p[0] < 0.0) && [a, b, c].iter().any(|p| p[0] > 0.0);
        if is_beyond && are_distinct(a, b, c) { parity(a, b, c) } else { orient2d(a, b, c) }
    };
    let [swaps, moves, scales] = broken(place);
    assert!(swaps == 0 && moves > 0 && scales == 0, "{swaps} {moves} {scales}");
    // Signs that depend on the size: the same for all translations, as the differences are.
    let size = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        let is_small = [[a, b], [b, c], [a, c]]
            .iter()
            .all(|[p, q]| exact_difference(*p, *q).is_some_and(|d| d.iter().all(|x| x.abs() < 1e-12)));
        if is_small && are_distinct(a, b, c) { parity(a, b, c) } else { orient2d(a, b, c) }
    };
    let [swaps, moves, scales] = broken(size);
    assert!(swaps == 0 && moves == 0 && scales > 0, "{swaps} {moves} {scales}");
}

/// The difference of two points, if doubles hold it.
fn exact_difference(p: [f64; 2], q: [f64; 2]) -> Option<[f64; 2]> {
    let difference = [p[0] - q[0], p[1] - q[1]];
    let is_exact = |i: usize| q[i] + difference[i] == p[i] && p[i] - difference[i] == q[i];
    (is_exact(0) && is_exact(1)).then_some(difference)
}

#[test]
fn the_other_convention_is_named_and_can_be_turned() {
    let turned = |a, b, c| -orient2d(a, b, c);
    let report = check::orient2d(turned).cases(2000).report();
    assert!(report.notes.iter().any(|note| note.contains("`.opposite()`")), "{report}");
    check::orient2d(turned).cases(2000).opposite().assert();
}

#[test]
fn a_filter_may_be_undecided_and_still_has_to_decide() {
    let filter = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        let (left, right) = ((a[0] - c[0]) * (b[1] - c[1]), (a[1] - c[1]) * (b[0] - c[0]));
        let (determinant, bound) = (left - right, 4e-16 * (left.abs() + right.abs()));
        let fits = left.abs() + right.abs() < 1e300 && left.abs() + right.abs() > 1e-280;
        (fits && determinant.abs() > bound).then_some(determinant)
    };
    let strict = check::orient2d(filter).report();
    assert!(!strict.conforms() && strict.wrong == 0 && strict.undecided > 0, "{strict}");
    check::orient2d(filter).may_be_undecided().assert();
    let never = check::orient2d(|_: [f64; 2], _, _| None::<i8>).may_be_undecided().report();
    assert!(!never.conforms(), "a predicate that decides nothing does not conform");
    let nothing = check::orient2d(orient2d).exponents(2000..=2001).report();
    assert_eq!(nothing.asked, nothing.sources.iter().map(|source| source.asked).sum::<u64>());
}

#[test]
#[should_panic(expected = "assert_eq!(Answer::from(answer), Answer::Sign(Sign::")]
fn assert_prints_a_test() {
    check::orient2d(crate::peers::naive).called("crate::peers::naive").assert();
}

/// The regression test that a finding prints, as it was pasted here.
mod pasted {
    include!("pasted.rs");
}

#[test]
fn a_finding_is_small_and_its_test_can_be_pasted() {
    let truncated = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| pasted::orient2d(a, b, c);
    let report = check::orient2d(truncated).called("orient2d").report();
    let text = report.to_string();
    for part in ["ranking on the same queries", "antisymmetry", "scaling by 2^k", "shrunk: got", "0x1", "#[test]"] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let finding = report.findings.iter().find(|finding| finding.error == Error::Flipped).unwrap();
    assert_ne!(finding.shrunk_got.to_string(), finding.shrunk_truth.to_string());
    let bits = |points: &[[f64; 2]]| points.iter().flatten().filter(|x| **x != 0.0).count();
    assert!(bits(&finding.shrunk) < bits(&finding.points), "{finding}");
    let file = include_str!("pasted.rs");
    let expected = finding.test.replace("#[test]\n", "#[test]\n#[should_panic(expected = \"assertion\")]\n");
    if std::env::var_os("UPDATE").is_some() {
        let head = file.split_once("/// Answered").map_or(file, |(head, _)| head);
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/it/pasted.rs");
        std::fs::write(path, format!("{head}{expected}")).unwrap();
    }
    assert!(file.ends_with(&expected), "run the test with UPDATE=1: {expected}");
}
