//! A second judge by other routes, without GMP, against the first one on the points of every embedded scene.
//!
//! The first judge subtracts a point and expands a determinant of rationals. This one works in integers of a common
//! unit and subtracts nothing: a turn is the area of the doubled polygon, a side of a plane the volume of the
//! tetrahedron by its faces, a circle the volume of the lifted tetrahedron, a sphere that of the lifted simplex by its
//! five facets. Hulls come from triangles: a point is extreme unless it is in a triangle or a segment of others.

mod generated;

use num_bigint::{BigInt, Sign as Side};
use predicament_judge::{Judged, hull, sign};
use predicament_predicates::{Axis, Dimension, Plane, Question, Scene, Sign, Vertex};

/// The coordinates of points as integers of one unit.
fn in_units(points: &[Vec<f64>]) -> Vec<Vec<BigInt>> {
    let parts = |x: f64| {
        let (bits, negative) = (x.abs().to_bits(), x < 0.0);
        let exponent = i64::try_from(bits >> 52).expect("11 bits");
        let significand = bits & ((1 << 52) - 1) | if exponent == 0 { 0 } else { 1 << 52 };
        (BigInt::from(significand) * if negative { -1 } else { 1 }, exponent.max(1))
    };
    let lowest = points.iter().flatten().map(|&x| parts(x).1).min().unwrap_or(0);
    let unit = |x: f64| parts(x).0 << u64::try_from(parts(x).1 - lowest).expect("the lowest is least");
    points.iter().map(|point| point.iter().map(|&x| unit(x)).collect()).collect()
}

fn of(x: &BigInt) -> Sign {
    match x.sign() {
        Side::Minus => Sign::Negative,
        Side::NoSign => Sign::Zero,
        Side::Plus => Sign::Positive,
    }
}

/// The determinant of rows, by the first row.
fn determinant(rows: &[&[BigInt]]) -> BigInt {
    let Some((first, rest)) = rows.split_first() else { return BigInt::from(1) };
    let minor = |column: usize| {
        let without: Vec<Vec<BigInt>> = rest
            .iter()
            .map(|row| row.iter().enumerate().filter(|(at, _)| *at != column).map(|(_, x)| x.clone()).collect())
            .collect();
        determinant(&without.iter().map(Vec::as_slice).collect::<Vec<_>>())
    };
    let terms = first.iter().enumerate().map(|(at, x)| x * minor(at) * if at.is_multiple_of(2) { 1 } else { -1 });
    terms.sum()
}

/// The volume of a simplex times the factorial of its dimension: the sum over its facets, seen from the origin.
fn volume(corners: &[&[BigInt]]) -> BigInt {
    let facets = (0..corners.len()).map(|left_out| {
        let facet: Vec<&[BigInt]> =
            corners.iter().enumerate().filter(|(at, _)| *at != left_out).map(|(_, corner)| *corner).collect();
        // The last corner's facet keeps the order; each one before turns it over.
        determinant(&facet) * if (corners.len() - 1 - left_out).is_multiple_of(2) { 1 } else { -1 }
    });
    facets.sum()
}

/// Twice the area of a triangle, doubled: each corner's x times the way from the corner before to the corner after.
fn area([a, b, c]: [&[BigInt]; 3]) -> BigInt {
    let corner = |at: &[BigInt], before: &[BigInt], after: &[BigInt]| &at[0] * (&after[1] - &before[1]);
    corner(a, c, b) + corner(b, a, c) + corner(c, b, a)
}

/// A point with its squared length.
fn lifted(point: &[BigInt]) -> Vec<BigInt> {
    let square: BigInt = point.iter().map(|x| x * x).sum();
    point.iter().cloned().chain([square]).collect()
}

/// The indices of extreme points in the plane, of points that are all different.
fn extreme(points: &[&[BigInt]]) -> Vec<usize> {
    let turn = |a: usize, b: usize, c: usize| of(&area([points[a], points[b], points[c]]));
    let between = |p: usize, a: usize, b: usize| {
        let along = |axis: usize| (&points[p][axis] - &points[a][axis]) * (&points[b][axis] - &points[p][axis]);
        turn(a, b, p) == Sign::Zero && (0..2).all(|axis| of(&along(axis)) != Sign::Negative)
    };
    let inside = |p: usize, [a, b, c]: [usize; 3]| {
        let sides = [turn(a, b, p), turn(b, c, p), turn(c, a, p)];
        let all = |not: Sign| sides.iter().all(|&side| side != not);
        turn(a, b, c) != Sign::Zero && (all(Sign::Negative) || all(Sign::Positive))
    };
    let others = |p: usize| (0..points.len()).filter(move |&at| at != p);
    let is_extreme = |&p: &usize| {
        others(p).all(|a| {
            others(p)
                .filter(|&b| b > a)
                .all(|b| !between(p, a, b) && others(p).filter(|&c| c > b).all(|c| !inside(p, [a, b, c])))
        })
    };
    (0..points.len()).filter(is_extreme).collect()
}

/// A number of a suite: decimal, or hexadecimal as text.
fn number(value: &toml::Value) -> Option<f64> {
    let text = match value {
        toml::Value::Integer(n) => return i32::try_from(*n).ok().map(f64::from),
        toml::Value::Float(x) => return Some(*x),
        toml::Value::String(text) => text.as_str(),
        _ => return None,
    };
    let (negative, digits) = text.strip_prefix('-').map_or((false, text), |rest| (true, rest));
    let Some(hex) = digits.strip_prefix("0x") else { return text.parse().ok() };
    let (mantissa, exponent) = hex.split_once('p')?;
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let significand = u64::from_str_radix(&format!("{whole}{fraction}"), 16).ok()?;
    let exponent = exponent.parse::<i32>().ok()? - 4 * i32::try_from(fraction.len()).ok()?;
    // Halved in steps: powers below the normal ones are exact one by one, as the number is a double.
    #[allow(clippy::cast_precision_loss)] // 53 bits
    let mut x = significand as f64;
    for _ in 0..exponent.abs() {
        x *= if exponent < 0 { 0.5 } else { 2.0 };
    }
    Some(if negative { -x } else { x })
}

/// The points of all scenes of the corpora that have a list of points, with their names.
fn scenes() -> Vec<(String, Vec<Vec<f64>>)> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../corpora");
    let mut files: Vec<_> =
        std::fs::read_dir(folder).expect("the corpora").map(|file| file.expect("a file").path()).collect();
    files.sort();
    let mut found = Vec::new();
    for file in files.iter().filter(|file| file.extension().is_some_and(|end| end == "toml")) {
        let text = std::fs::read_to_string(file).expect("a suite");
        let suite: toml::Table = text.parse().unwrap_or_else(|why| panic!("{}: {why}", file.display()));
        for scene in suite.get("scene").and_then(toml::Value::as_array).into_iter().flatten() {
            let read = |point: &toml::Value| point.as_array()?.iter().map(number).collect::<Option<Vec<f64>>>();
            let points: Option<Vec<Vec<f64>>> =
                scene.get("points").and_then(toml::Value::as_array).and_then(|list| list.iter().map(read).collect());
            let name = scene.get("name").and_then(toml::Value::as_str).unwrap_or_default();
            if let Some(points) = points.filter(|points| !points.is_empty()) {
                found.push((format!("{}/{name}", file.file_stem().unwrap_or_default().display()), points));
            }
        }
    }
    found
}

/// Calls `visit` with some of the ways to choose `N` of `count`, at most `limit`, spread over all.
fn choices<const N: usize>(count: usize, limit: usize, mut visit: impl FnMut([usize; N])) {
    let all = count.pow(u32::try_from(N).expect("small"));
    let step = all.div_ceil(limit).max(1) | 1;
    for at in (0..all).step_by(step) {
        let mut rest = at;
        visit(std::array::from_fn(|_| {
            let one = rest % count;
            rest /= count;
            one
        }));
    }
}

#[test]
fn both_judges_agree_on_the_points_of_every_scene() {
    let limit = if predicament_effort::whole() { 4000 } else { 40 };
    let (mut asked, mut zeros, mut hulls) = (0, 0, 0);
    let scenes = scenes();
    assert!(scenes.len() > 50, "{} scenes", scenes.len());
    for (name, points) in scenes {
        let dimension = points[0].len();
        let coordinates = points.concat();
        let Some(space) = Dimension::of(dimension) else { continue };
        let Ok(scene) = Scene::new(space, coordinates) else { continue };
        let units = in_units(&points);
        let lifts: Vec<Vec<BigInt>> = units.iter().map(|point| lifted(point)).collect();
        let at = Vertex::input;
        let mut same = |question: Question, args: &[usize], second: &BigInt| {
            let args: Vec<Vertex> = args.iter().map(|&i| at(i)).collect();
            assert_eq!(sign(&scene, question, &args), of(second), "{name}: {}", question.query(&args));
            asked += 1;
            zeros += usize::from(second.sign() == Side::NoSign);
        };
        // (Of long lists the first points.)
        let count = points.len().min(300);
        choices::<2>(count, limit, |[a, b]| {
            same(Question::Compare(Axis::X), &[a, b], &(&units[a][0] - &units[b][0]));
        });
        if dimension == 2 {
            choices::<3>(count, limit, |[a, b, c]| {
                same(Question::Orient2d(Plane::Xy), &[a, b, c], &area([&units[a], &units[b], &units[c]]));
            });
            choices::<4>(count, limit, |args| {
                let second = volume(&args.map(|i| lifts[i].as_slice()));
                same(Question::Incircle, &args, &second);
            });
        } else {
            choices::<4>(count, limit, |args| {
                let second = volume(&args.map(|i| units[i].as_slice()));
                same(Question::Orient3d, &args, &second);
            });
            choices::<5>(count, limit, |args| {
                let second = volume(&args.map(|i| lifts[i].as_slice()));
                same(Question::Insphere, &args, &second);
            });
        }
        let are_different = count == points.len() && (1..count).all(|i| !units[..i].contains(&units[i]));
        if dimension == 2 && are_different && (3..=12).contains(&count) {
            let slices: Vec<&[BigInt]> = units.iter().map(Vec::as_slice).collect();
            let second: Vec<Vertex> = extreme(&slices).into_iter().map(at).collect();
            assert_eq!(hull::extreme(&Judged::exact(&scene)), second, "the hull of {name}");
            hulls += 1;
        }
    }
    println!("{asked} signs, {zeros} of them zero, {hulls} hulls");
    assert!(asked > 10_000 && zeros > 500 && hulls > 20, "{asked} signs, {zeros} zero, {hulls} hulls");
}

/// The second judge can disagree: with a lift that is one unit too long, with a lift that forgets an axis.
#[test]
fn a_planted_fault_is_found() {
    let points = vec![vec![5.0, 0.0], vec![3.0, 4.0], vec![0.0, 5.0], vec![-4.0, 3.0]];
    let scene = Scene::new(Dimension::Two, points.concat()).expect("finite");
    let args: Vec<Vertex> = (0..4).map(Vertex::input).collect();
    let truth = sign(&scene, Question::Incircle, &args);
    let right: Vec<Vec<BigInt>> = in_units(&points).iter().map(|point| lifted(point)).collect();
    assert_eq!((truth, of(&volume(&right.iter().map(Vec::as_slice).collect::<Vec<_>>()))), (Sign::Zero, Sign::Zero));
    let mut moved = right.clone();
    moved[2][2] += 1;
    assert_ne!(of(&volume(&moved.iter().map(Vec::as_slice).collect::<Vec<_>>())), truth);
    let forgets: Vec<Vec<BigInt>> =
        in_units(&points).iter().map(|p| vec![p[0].clone(), p[1].clone(), &p[0] * &p[0]]).collect();
    assert_ne!(of(&volume(&forgets.iter().map(Vec::as_slice).collect::<Vec<_>>())), truth);
}
