//! The crate `robust` on all rows about input points: it is wrong only where its documentation excludes the input.

use predicament_vectors::{double, vectors};
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

#[test]
fn hex_floats_are_read_exactly() {
    for (text, x) in [("0x1.8p+1", 3.0), ("-0x1p-1074", -5e-324), ("0x1.fffffffffffffp+1023", f64::MAX), ("0x0p+0", 0.0)] {
        assert_eq!(double(text), x, "{text}");
    }
}
