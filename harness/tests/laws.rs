//! `predicament laws` from end to end.

mod common;

use common::{column, expect};

#[test]
fn what_is_proved_keeps_the_laws_and_what_rounds_breaks_them() {
    let told = expect(0, &["laws", "-b", "exact,sos", "--tuples", "20000", "--format", "csv"]);
    let numbers = |name: &str| column(&told.stdout, name).iter().map(|n| n.parse::<u64>().unwrap()).collect::<Vec<_>>();
    let [tuples, violations, panics] = ["tuples", "violations", "panics"].map(numbers);
    assert!(tuples.iter().sum::<u64>() >= 2 * 20_000, "{}", told.stdout);
    assert!(violations.iter().chain(&panics).all(|&n| n == 0), "{}", told.stdout);
    for law in ["never-zero", "antisymmetry", "transitivity", "grassmann-plucker", "mixed-grassmann-plucker"] {
        assert!(column(&told.stdout, "law").iter().any(|name| name == law), "{law}");
    }
    let told = expect(100, &["laws", "-b", "naive,fault:sos-place-as-identity", "--tuples", "20000"]);
    for needle in ["| antisymmetry", "naive", "orient2d(xy; ", "equals-exact"] {
        assert!(told.stdout.contains(needle), "{needle}: {}", told.stdout);
    }
}

#[test]
fn the_bytes_do_not_depend_on_the_number_of_threads() {
    let survey = |threads: &str| {
        let args = ["laws", "-b", "naive", "--tuples", "20000", "--format", "csv", "--threads", threads];
        expect(100, &args).stdout
    };
    assert_eq!(survey("1"), survey("3"));
}

#[test]
fn mistakes_are_answered_with_what_there_is() {
    assert!(expect(2, &["laws", "-b", "exat"]).stderr.contains("no backend is called `exat`"));
    expect(2, &["laws", "--format", "xml"]);
}
