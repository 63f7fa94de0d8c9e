//! Pictures of one query: one to scale, and one in which the exact determinant separates points that nearly coincide.

use predicament_corpus::LoadedScene;
use predicament_judge::verdict;
use predicament_predicates::{Axis, Plane, Query, Question, Vertex};
use predicament_report::picture::{Named, pulled_apart, to_scale};

/// The distance of the last vertex from the line, circle, plane or sphere of the others, from the exact determinant.
/// `None` if the predicate has no distance.
pub fn distance(loaded: &LoadedScene, query: &Query) -> Option<f64> {
    let (question, args) = query.question()?;
    if args.iter().any(|v| v.is_constructed()) {
        return None;
    }
    let exact = |question: Question, args: &[Vertex]| verdict(&loaded.scene, question, args).determinant.to_f64();
    let determinant = exact(question, args);
    let space = || -> Vec<[f64; 3]> { args.iter().map(|&v| loaded.scene.point3(v)).collect() };
    let apart = match question {
        Question::Orient2d(plane) => along_line(&flat(loaded, args, plane.axes()), determinant)?,
        Question::Incircle => {
            let points = flat(loaded, args, [Axis::X, Axis::Y]);
            along_circle(&points, determinant, exact(Question::Orient2d(Plane::Xy), &args[..3]))?.1
        }
        Question::Orient3d => across_plane(&space(), determinant)?,
        Question::Insphere => across_sphere(&space(), determinant, exact(Question::Orient3d, &args[..4]))?,
        Question::Compare(_) | Question::Derived(_) => return None,
    };
    apart.last().map(|place| place[1].abs())
}

/// The coordinates of vertices along two axes.
fn flat(loaded: &LoadedScene, args: &[Vertex], axes: [Axis; 2]) -> Vec<[f64; 2]> {
    let place = |axis: Axis| [Axis::X, Axis::Y, Axis::Z].iter().position(|&other| other == axis).unwrap_or(0);
    args.iter().map(|&v| axes.map(|axis| loaded.scene.point(v)[place(axis)])).collect()
}

/// Pictures of a query about input vertices.
pub fn drawn(loaded: &LoadedScene, query: &Query) -> Option<Vec<(String, String)>> {
    let (question, args) = query.question()?;
    if args.iter().any(|v| v.is_constructed()) {
        return None;
    }
    // The exact determinant gives the distance and the side of the last point.
    let exact = |question: Question, args: &[Vertex]| verdict(&loaded.scene, question, args).determinant.to_f64();
    let determinant = exact(question, args);
    let space = || -> Vec<[f64; 3]> { args.iter().map(|&v| loaded.scene.point3(v)).collect() };
    let (seen, apart, [on, up]) = match question {
        Question::Orient2d(plane) => {
            let points = flat(loaded, args, plane.axes());
            let apart = along_line(&points, determinant)?;
            (Some((points, None)), apart, ["line a b", "left is up"])
        }
        Question::Incircle => {
            let points = flat(loaded, args, [Axis::X, Axis::Y]);
            let area = exact(Question::Orient2d(Plane::Xy), &args[..3]);
            let (circle, apart) = along_circle(&points, determinant, area)?;
            (Some((points, Some(circle))), apart, ["circle a b c", "outside is up"])
        }
        Question::Orient3d => (None, across_plane(&space(), determinant)?, ["plane a b c", "above is up"]),
        Question::Insphere => {
            let volume = exact(Question::Orient3d, &args[..4]);
            (None, across_sphere(&space(), determinant, volume)?, ["sphere a b c d", "outside is up"])
        }
        Question::Compare(_) | Question::Derived(_) => return None,
    };
    let named = |points: &[[f64; 2]]| -> Vec<Named> {
        let of = args.iter().zip('a'..).zip(points);
        of.map(|((v, letter), &at)| Named { name: format!("{letter} = {v}"), at }).collect()
    };
    let mut pictures = Vec::new();
    if let Some((points, circle)) = seen {
        let alt = format!("{}, to scale", question.kind().name());
        pictures.push((alt, to_scale(&named(&points), circle).ok()?));
    }
    let across = format!("across the {on} at a scale of its own, from the exact determinant; {up}");
    pictures.push((across, pulled_apart(&named(&apart), on).ok()?));
    Some(pictures)
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i: usize| a[i] - b[i])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Points by their distance along the direction from a to b, d with its exact distance from the plane of a, b and c. A
/// positive determinant is below.
fn across_plane(points: &[[f64; 3]], determinant: f64) -> Option<Vec<[f64; 2]>> {
    let [a, b, c, d] = *points else { return None };
    let (along, normal) = (minus(b, a), cross(minus(b, a), minus(c, a)));
    let (length, area) = (dot(along, along).sqrt(), dot(normal, normal).sqrt());
    let of = |p: [f64; 3]| dot(minus(p, a), along) / length;
    let apart = vec![[0.0, 0.0], [length, 0.0], [of(c), 0.0], [of(d), -determinant / area]];
    apart.as_flattened().iter().all(|x| x.is_finite()).then_some(apart)
}

/// The centre of the sphere of a, b, c and d as an offset from a, and its radius.
pub fn sphere(points: [[f64; 3]; 4]) -> Option<([f64; 3], f64)> {
    let [a, b, c, d] = points;
    let [b, c, d] = [b, c, d].map(|p| minus(p, a));
    let scaled = |p: [f64; 3], by: f64| p.map(|x| x * by);
    let [u, v, w] = [(cross(c, d), b), (cross(d, b), c), (cross(b, c), d)].map(|(of, p)| scaled(of, dot(p, p)));
    let twice = 2.0 * dot(b, cross(c, d));
    let from_a = [0, 1, 2].map(|i: usize| (u[i] + v[i] + w[i]) / twice);
    let radius = dot(from_a, from_a).sqrt();
    radius.is_finite().then_some((from_a, radius))
}

/// Points by their distance from a, e with its exact distance from the sphere of a, b, c and d; outside is positive.
fn across_sphere(points: &[[f64; 3]], power: f64, volume: f64) -> Option<Vec<[f64; 2]>> {
    let [a, b, c, d, _] = *points else { return None };
    let (_, radius) = sphere([a, b, c, d])?;
    // As for a circle, with the volume in place of the area.
    let outside = -power / volume / (2.0 * radius);
    let mut apart: Vec<[f64; 2]> = points
        .iter()
        .map(|&p| {
            let by = minus(p, a);
            [dot(by, by).sqrt(), 0.0]
        })
        .collect();
    apart[4][1] = outside;
    apart.as_flattened().iter().all(|x| x.is_finite()).then_some(apart)
}

/// Points by their distance along the line from a to b, c with its exact distance from the line. The determinant is
/// twice the area; positive is to the left.
fn along_line(points: &[[f64; 2]], determinant: f64) -> Option<Vec<[f64; 2]>> {
    let [a, b, c] = *points else { return None };
    let along = [b[0] - a[0], b[1] - a[1]];
    let length = along[0].hypot(along[1]);
    let of = |p: [f64; 2]| ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / length;
    let apart = vec![[0.0, 0.0], [length, 0.0], [of(c), determinant / length]];
    (length > 0.0 && apart.as_flattened().iter().all(|x| x.is_finite())).then_some(apart)
}

/// The circle of a, b and c, and the points by their angles on it, d with its exact distance from the circle; outside
/// is positive.
#[allow(clippy::type_complexity)] // a circle, and points
fn along_circle(points: &[[f64; 2]], power: f64, area: f64) -> Option<(([f64; 2], f64), Vec<[f64; 2]>)> {
    let [a, b, c, d] = *points else { return None };
    let [b, c] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1]]);
    let squares = [b, c].map(|p| p[0] * p[0] + p[1] * p[1]);
    let twice = 2.0 * (b[0] * c[1] - b[1] * c[0]);
    let from_a = [(c[1] * squares[0] - b[1] * squares[1]) / twice, (b[0] * squares[1] - c[0] * squares[0]) / twice];
    let radius = from_a[0].hypot(from_a[1]);
    let centre = [a[0] + from_a[0], a[1] + from_a[1]];
    let angle = |p: [f64; 2]| (p[1] - centre[1]).atan2(p[0] - centre[0]) * radius;
    // The determinant is orient2d(a, b, c) times (radius² − squared distance from the centre).
    let outside = -power / area / (2.0 * radius);
    let mut apart: Vec<[f64; 2]> = points.iter().map(|&p| [angle(p), 0.0]).collect();
    apart[3] = [angle(d), outside];
    let finite = apart.as_flattened().iter().chain(&centre).all(|x| x.is_finite());
    finite.then_some(((centre, radius), apart))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_point_is_on_its_side_of_the_line() {
        // c is left of the line from a to b, by 2^-60.
        let apart = along_line(&[[0.0, 0.0], [2.0, 0.0], [1.0, 0.0]], 2_f64.powi(-59)).unwrap();
        assert_eq!(apart, [[0.0, 0.0], [2.0, 0.0], [1.0, 2_f64.powi(-60)]]);
        assert_eq!(along_line(&[[1.0, 1.0], [1.0, 1.0], [2.0, 0.0]], 0.0), None);
    }

    #[test]
    fn the_last_point_is_inside_of_the_circle_or_outside() {
        let points = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -2.0]];
        // orient2d is 2, and the squared radius minus the squared distance is 1 - 4.
        let ((centre, radius), apart) = along_circle(&points, -6.0, 2.0).unwrap();
        assert_eq!((centre, radius), ([0.0, 0.0], 1.0));
        assert_eq!(apart[3][1], 1.5, "outside, about by 1");
        assert!(along_circle(&points, 1e-20, 2.0).unwrap().1[3][1] < 0.0, "inside");
        assert_eq!(along_circle(&[[0.0; 2]; 4], 0.0, 0.0), None);
    }

    /// The signs agree with the judge's determinants.
    #[test]
    fn the_last_point_is_above_the_plane_or_outside_of_the_sphere() {
        let at = |points: &[[f64; 3]], question: Question| {
            let scene = predicament_predicates::Scene::from_points3(points).unwrap();
            let args: Vec<Vertex> = (0..points.len()).map(Vertex::input).collect();
            verdict(&scene, question, &args).determinant.to_f64()
        };
        let plane = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        for height in [0.5, -0.25] {
            let points = [&plane[..], &[[1.0, 0.0, height]]].concat();
            let apart = across_plane(&points, at(&points, Question::Orient3d)).unwrap();
            assert_eq!(apart[3], [1.0, height]);
        }
        let sphere = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]];
        for (z, outside) in [(-1.5, 0.625), (-0.5, -0.375)] {
            let points = [&sphere[..], &[[0.0, 0.0, z]]].concat();
            let volume = at(&sphere, Question::Orient3d);
            let apart = across_sphere(&points, at(&points, Question::Insphere), volume).unwrap();
            // The distance is half of the difference of the squares.
            assert!((apart[4][1] - outside).abs() < 1e-12, "{apart:?}");
        }
    }
}
