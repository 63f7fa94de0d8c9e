//! Indirect predicates: exact ones conform, and those that round the points first do not.

use predicament_conformance::{Point2, Point3, Sign, check};

use crate::exact::indirect;

#[test]
fn exact_conforms() {
    check::indirect::orient2d(indirect::orient2d).cases(300).assert();
    check::indirect::orient3d(indirect::orient3d).cases(300).assert();
    check::indirect::incircle(indirect::incircle).cases(100).assert();
    check::indirect::insphere(indirect::insphere).cases(60).assert();
    check::indirect::orient2d_of_3d(indirect::orient2d_of_3d).cases(300).assert();
    check::indirect::compare2d(indirect::compare2d).cases(300).assert();
    check::indirect::compare3d(indirect::compare3d).cases(300).assert();
}

/// The meeting point of lines in doubles.
fn rounded(point: Point2) -> [f64; 2] {
    match point {
        Point2::Input(point) => point,
        Point2::Ssi([[a, b], [c, d]]) => {
            let cross = |u: [f64; 2], v: [f64; 2]| u[0] * v[1] - u[1] * v[0];
            let minus = |p: [f64; 2], q: [f64; 2]| [p[0] - q[0], p[1] - q[1]];
            let (u, v) = (minus(b, a), minus(d, c));
            let t = cross(minus(c, a), v) / cross(u, v);
            [a[0] + t * u[0], a[1] + t * u[1]]
        }
    }
}

#[test]
fn exact_signs_about_rounded_points_are_wrong() {
    let report = check::indirect::orient2d(|a, b, c| {
        let [a, b, c] = [a, b, c].map(rounded);
        let is_finite = [a, b, c].as_flattened().iter().all(|x| x.is_finite());
        is_finite.then(|| crate::exact::orient2d(a, b, c))
    })
    .report();
    let of = |name: &str| report.sources.iter().find(|source| source.name.starts_with(name)).unwrap().wrong;
    assert!(of("ssi-near") > 50 && of("ssi-degen") > 50, "{report}");
    assert_eq!(of("ssi-uniform"), 0, "{report}");
    assert!(report.findings.iter().any(|finding| finding.test.contains("Point2::Ssi([[[")), "{report}");
    assert!(report.findings.iter().all(|finding| finding.coordinates[0].contains("SSI of")), "{report}");
    let plain = report.ranking.iter().find(|rank| rank.name == "plain f64").unwrap();
    assert!(plain.wrong > 100, "{report}");
}

#[test]
fn exact_circles_through_rounded_points_are_wrong() {
    let report = check::indirect::incircle(|a, b, c, d| {
        let [a, b, c, d] = [a, b, c, d].map(rounded);
        let is_finite = [a, b, c, d].as_flattened().iter().all(|x| x.is_finite());
        is_finite.then(|| crate::exact::incircle(a, b, c, d))
    })
    .cases(800)
    .report();
    let of = |name: &str| report.sources.iter().find(|source| source.name.starts_with(name)).unwrap().wrong;
    assert!(of("ssi-near") > 30 && of("ssi-degen") > 1, "{report}");
    assert_eq!(of("ssi-uniform"), 0, "{report}");
    assert!(report.findings.iter().any(|finding| finding.test.contains("Point2::Ssi([[[")), "{report}");
}

/// The last argument of a sphere is one of five: each set of arguments is constructed, by each kind of construction.
#[test]
fn a_fault_about_the_last_point_of_a_sphere_is_found() {
    let predicate = |a, b, c, d, e| match (c, e) {
        (Point3::Input(_), Point3::Tpi(_)) => Sign::Zero,
        _ => indirect::insphere(a, b, c, d, e),
    };
    let report = check::indirect::insphere(predicate).cases(80).report();
    assert!(report.wrong > 2, "{report}");
    let elsewhere = report.sources.iter().filter(|source| source.wrong > 0 && !source.name.contains("tpi"));
    assert_eq!(elsewhere.count(), 0, "{report}");
}

/// True if the weight of a constructed point is negative.
fn is_negative(point: Point3) -> bool {
    match point {
        Point3::Lpi { line: [p, q], plane: [a, b, c] } => {
            // Both ends of the line are input points: the side of the plane changes along it.
            let side = |x| crate::exact::orient3d(a, b, c, x);
            side(p) == Sign::Positive && side(q) == Sign::Negative
        }
        _ => false,
    }
}

/// Inverted where the weight of a constructed point is negative, as after a forgotten change of sign.
#[test]
fn a_forgotten_sign_of_the_weight_is_found() {
    let predicate = |a, b, c, d| {
        let sign = indirect::orient3d(a, b, c, d);
        if [a, b, c, d].into_iter().filter(|&point| is_negative(point)).count() % 2 == 1 { -sign } else { sign }
    };
    let report = check::indirect::orient3d(predicate).cases(300).report();
    let of = |name: &str| report.sources.iter().find(|source| source.name.starts_with(name)).unwrap().wrong;
    assert!(of("lpi-uniform") > 0 && of("tpi-uniform") == 0, "{report}");
    let predicate = |a, b, c, d, e| {
        let sign = indirect::insphere(a, b, c, d, e);
        if [a, b, c, d, e].into_iter().filter(|&point| is_negative(point)).count() % 2 == 1 { -sign } else { sign }
    };
    let report = check::indirect::insphere(predicate).cases(60).report();
    let of = |name: &str| report.sources.iter().find(|source| source.name.starts_with(name)).unwrap().wrong;
    assert!(of("lpi-uniform") > 0 && of("tpi-uniform") == 0, "{report}");
}

/// Each way is asked: a fault along one axis or in one plane is found there, and only there.
#[test]
fn every_axis_and_plane_is_asked() {
    use predicament_conformance::{Axis, Plane};
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        let predicate = |on, a, b| if on == axis { Sign::Zero } else { indirect::compare3d(on, a, b) };
        let report = check::indirect::compare3d(predicate).cases(100).report();
        assert!(report.wrong > 0, "{axis:?}");
        let end = format!(" {}", axis.name());
        let elsewhere = report.sources.iter().filter(|source| source.wrong > 0 && !source.name.ends_with(&end));
        assert_eq!(elsewhere.count(), 0, "{report}");
    }
    for plane in [Plane::Xy, Plane::Yz, Plane::Zx] {
        let predicate = |on, a, b, c| if on == plane { Sign::Zero } else { indirect::orient2d_of_3d(on, a, b, c) };
        let report = check::indirect::orient2d_of_3d(predicate).cases(100).report();
        let found = report.findings.iter().find(|finding| !finding.way.is_empty()).unwrap();
        assert!(found.test.contains("(Plane::") && found.way == plane.name(), "{report}");
    }
}
