//! The crate `robust` on all rows about input points: it is wrong only where its documentation excludes the input.

use predicament_vectors::{doubles, points, tasks, vectors};
use robust::{Coord, Coord3D};
use serde_json::Value;

fn flat(point: &[f64]) -> Coord<f64> {
    Coord { x: point[0], y: point[1] }
}

fn solid(point: &[f64]) -> Coord3D<f64> {
    Coord3D { x: point[0], y: point[1], z: point[2] }
}

/// The value by `robust`, or `None` for predicates that it lacks.
fn value(row: &Value) -> Option<f64> {
    let points = points(row)?;
    let p = |at: usize| points[at].as_slice();
    Some(match row["predicate"].as_str()? {
        "orient2d" => robust::orient2d(flat(p(0)), flat(p(1)), flat(p(2))),
        "orient3d" => robust::orient3d(solid(p(0)), solid(p(1)), solid(p(2)), solid(p(3))),
        "incircle" => robust::incircle(flat(p(0)), flat(p(1)), flat(p(2)), flat(p(3))),
        "insphere" => robust::insphere(solid(p(0)), solid(p(1)), solid(p(2)), solid(p(3)), solid(p(4))),
        _ => return None,
    })
}

/// The number of rows that `robust` is asked about, and the rows on which it is wrong.
fn asked_and_wrong(rows: &[Value]) -> (usize, Vec<&Value>) {
    let asked: Vec<(&Value, f64)> = rows.iter().filter_map(|row| Some((row, value(row)?))).collect();
    let sign = |value: f64| [("+", value > 0.0), ("-", value < 0.0), ("0", value == 0.0)];
    let is_wrong = |(row, value): &(&Value, f64)| !sign(*value).iter().any(|&(sign, is)| is && row["doubles"] == sign);
    (asked.len(), asked.iter().copied().filter(is_wrong).map(|(row, _)| row).collect())
}

fn has(row: &Value, flags: &[&str]) -> bool {
    row["flags"].as_array().is_some_and(|own| own.iter().any(|own| flags.iter().any(|flag| own == flag)))
}

#[test]
fn robust_is_right_within_its_range() {
    let mut rows = vectors();
    let (asked, wrong) = asked_and_wrong(&rows);
    println!("robust: {} of {asked} wrong", wrong.len());
    let strange = wrong.iter().find(|row| !has(row, &["underflow", "overflow"]));
    assert_eq!(strange, None);
    assert!(asked > 15_000 && !wrong.is_empty(), "rows with underflow and overflow make it wrong: {asked}");
    // A corrupted row is noticed.
    let plain = rows.iter().position(|row| row["doubles"] == "+" && value(row).is_some()).expect("a row");
    rows[plain]["doubles"] = "-".into();
    assert_eq!(asked_and_wrong(&rows[plain..=plain]).1.len(), 1);
}

/// Each pair of edges that `robust` says to cross is one of the contacts.
#[test]
fn robust_finds_the_contacts_of_edges() {
    let mut asked = 0;
    for row in tasks().iter().filter(|row| row["task"] == "contacts2d") {
        let ids = |value: &Value| -> Vec<usize> {
            value.as_array().expect("an array").iter().map(|id| id.to_string().parse().expect("an index")).collect()
        };
        let points = doubles(&row["decimal"]["points"]).expect("decimals");
        let edges =
            |key| -> Vec<[usize; 2]> { ids(&row["question"][key]).chunks(2).map(|at| [at[0], at[1]]).collect() };
        let at = |v: usize| flat(&points[2 * v..][..2]);
        let side = |[a, b]: [usize; 2], v: usize| robust::orient2d(at(a), at(b), at(v));
        let parts = |one: [usize; 2], [p, q]: [usize; 2]| side(one, p) * side(one, q) < 0.0;
        let (starts, all) = (ids(&row["doubles"]["pairs.starts"]), ids(&row["doubles"]["pairs"]));
        let pairs: Vec<Vec<usize>> = starts.windows(2).map(|at| sorted(&all[at[0]..at[1]])).collect();
        for a in edges("a.edges") {
            for b in edges("b.edges").into_iter().filter(|&b| parts(a, b) && parts(b, a)) {
                assert!(pairs.contains(&sorted(&[a, b].concat())), "{}: {a:?} and {b:?}", row["id"]);
                asked += 1;
            }
        }
    }
    println!("robust: {asked} crossings of edges");
    assert!(asked > 50, "{asked}");
}

fn sorted(ids: &[usize]) -> Vec<usize> {
    let mut ids = ids.to_vec();
    ids.sort_unstable();
    ids
}
