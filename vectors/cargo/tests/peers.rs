//! The crate `robust` on all rows about input points: it is wrong only where its documentation excludes the input.

use predicament_vectors::{double, tasks, vectors};
use robust::{Coord, Coord3D};

fn flat(point: &[f64]) -> Coord<f64> {
    Coord { x: point[0], y: point[1] }
}

fn solid(point: &[f64]) -> Coord3D<f64> {
    Coord3D { x: point[0], y: point[1], z: point[2] }
}

#[test]
fn robust_is_right_within_its_range() {
    let (mut asked, mut wrong) = (0, 0);
    for row in vectors() {
        let Some(points) = row.points() else { continue };
        let p = |at: usize| points[at].as_slice();
        let value = match row.predicate.as_str() {
            "orient2d" => robust::orient2d(flat(p(0)), flat(p(1)), flat(p(2))),
            "orient3d" => robust::orient3d(solid(p(0)), solid(p(1)), solid(p(2)), solid(p(3))),
            "incircle" => robust::incircle(flat(p(0)), flat(p(1)), flat(p(2)), flat(p(3))),
            "insphere" => robust::insphere(solid(p(0)), solid(p(1)), solid(p(2)), solid(p(3)), solid(p(4))),
            _ => continue,
        };
        let sign = if value > 0.0 { "+" } else if value < 0.0 { "-" } else { "0" };
        asked += 1;
        if value.is_nan() || sign != row.doubles {
            wrong += 1;
            let excluded = ["underflow", "overflow"].iter().any(|flag| row.flags.iter().any(|own| own == flag));
            assert!(excluded, "{}: {} says {value:e}, the truth is {}: {:?}", row.id, row.predicate, row.doubles, row.flags);
        }
    }
    println!("robust: {wrong} of {asked} wrong");
    assert!(asked > 15_000 && wrong > 0, "rows with underflow and overflow make it wrong: {wrong} of {asked}");
}

/// Each pair of edges that `robust` says to cross is one of the contacts.
#[test]
fn robust_finds_the_contacts_of_edges() {
    let mut asked = 0;
    for row in tasks().iter().filter(|row| row.task == "contacts2d") {
        let array = |value: &serde_json::Value| value.as_array().expect("an array").clone();
        let ids = |value| -> Vec<usize> { array(value).iter().map(|id| id.as_u64().unwrap() as usize).collect() };
        let points: Vec<f64> = array(&row.question["points"]).iter().map(|x| double(x.as_str().unwrap())).collect();
        let at = |v: usize| flat(&points[2 * v..][..2]);
        let edges = |key| -> Vec<[usize; 2]> { ids(&row.question[key]).chunks(2).map(|ends| [ends[0], ends[1]]).collect() };
        let side = |[a, b]: [usize; 2], v: usize| robust::orient2d(at(a), at(b), at(v));
        let parts = |one: [usize; 2], [p, q]: [usize; 2]| side(one, p) * side(one, q) < 0.0;
        let (starts, all) = (ids(&row.doubles["pairs.starts"]), ids(&row.doubles["pairs"]));
        let pairs: Vec<Vec<usize>> = starts.windows(2).map(|at| sorted(&all[at[0]..at[1]])).collect();
        for a in edges("a.edges") {
            for b in edges("b.edges").into_iter().filter(|&b| parts(a, b) && parts(b, a)) {
                assert!(pairs.contains(&sorted(&[a, b].concat())), "{}: {a:?} and {b:?}", row.id);
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

#[test]
fn hex_floats_are_read_exactly() {
    for (text, x) in [("0x1.8p+1", 3.0), ("-0x1p-1074", -5e-324), ("0x1.fffffffffffffp+1023", f64::MAX), ("0x0p+0", 0.0)] {
        assert_eq!(double(text), x, "{text}");
    }
}
