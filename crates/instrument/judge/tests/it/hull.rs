//! Extreme vertices against another definition: vertices that no simplex of the others contains (Carathéodory).

use std::collections::BTreeSet;

use predicament_judge::{Judged, hull};
use predicament_predicates::{Scene, Vertex};

use crate::random::{Random, effort};

type Point = [i64; 3];

fn less(p: Point, q: Point) -> Point {
    [0, 1, 2].map(|axis: usize| p[axis] - q[axis])
}

fn cross(p: Point, q: Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k): (usize, usize)| p[j] * q[k] - p[k] * q[j])
}

fn dot(p: Point, q: Point) -> i64 {
    (0..3).map(|axis| p[axis] * q[axis]).sum()
}

/// True if a point is in the segment between two others.
fn is_between(p: Point, [a, b]: [Point; 2]) -> bool {
    cross(less(a, p), less(b, p)) == [0; 3] && dot(less(a, p), less(b, p)) <= 0
}

/// True if a point is in a triangle with an area.
fn is_in_triangle(p: Point, [a, b, c]: [Point; 3]) -> bool {
    let normal = cross(less(b, a), less(c, a));
    let turn = |u: Point, v: Point| dot(cross(less(u, p), less(v, p)), normal);
    normal != [0; 3]
        && dot(less(p, a), normal) == 0
        && [turn(a, b), turn(b, c), turn(c, a)].iter().all(|&turn| turn >= 0)
}

/// True if a point is in a tetrahedron with a volume.
fn is_in_tetrahedron(p: Point, corners: [Point; 4]) -> bool {
    let volume = |[a, b, c, d]: [Point; 4]| dot(cross(less(b, a), less(c, a)), less(d, a));
    let whole = volume(corners);
    let parts = [0, 1, 2, 3].map(|at: usize| {
        let mut of = corners;
        of[at] = p;
        volume(of).signum() * whole.signum()
    });
    whole != 0 && parts.iter().all(|&part| part >= 0)
}

/// The extreme points by definition: the first vertex of each place that no simplex of other places contains.
fn extreme(points: &[Point]) -> Vec<usize> {
    let places: BTreeSet<Point> = points.iter().copied().collect();
    let is_extreme = |p: Point| {
        let others: Vec<Point> = places.iter().copied().filter(|&q| q != p).collect();
        let n = others.len();
        let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| [i, j]));
        let triples = pairs.clone().flat_map(|[i, j]| (j + 1..n).map(move |k| [i, j, k]));
        let fours = triples.clone().flat_map(|[i, j, k]| (k + 1..n).map(move |l| [i, j, k, l]));
        !(pairs.into_iter().any(|of| is_between(p, of.map(|at| others[at])))
            || triples.into_iter().any(|of| is_in_triangle(p, of.map(|at| others[at])))
            || fours.into_iter().any(|of| is_in_tetrahedron(p, of.map(|at| others[at]))))
    };
    let first = |p: Point| points.iter().position(|&q| q == p).unwrap();
    let mut found: Vec<usize> = places.iter().copied().filter(|&p| is_extreme(p)).map(first).collect();
    found.sort_unstable();
    found
}

/// Points of a lattice with `dimensions` dimensions, mapped into space by integers.
fn points(random: &mut Random, count: usize, dimensions: usize, end: usize) -> Vec<Point> {
    let mut whole = |end: usize| i64::try_from(random.below(end)).unwrap();
    let directions = [(); 3].map(|()| [(); 3].map(|()| whole(5) - 2));
    let lattice: Vec<Point> = (0..count).map(|_| [(); 3].map(|()| whole(end))).collect();
    let place = |p: Point| {
        if dimensions == 3 {
            return p;
        }
        [0, 1, 2].map(|axis: usize| (0..dimensions).map(|of| p[of] * directions[of][axis]).sum())
    };
    lattice.into_iter().map(place).collect()
}

fn indices(vertices: Vec<Vertex>) -> Vec<usize> {
    vertices.into_iter().map(Vertex::index).collect()
}

fn exact([x, y, z]: Point) -> [f64; 3] {
    [x, y, z].map(|x| f64::from(i32::try_from(x).unwrap()))
}

#[test]
fn extreme_vertices_are_those_in_no_simplex_of_others() {
    let mut random = Random::new(30);
    let mut of_sizes = [0_usize; 9];
    for round in 0..400 * effort() {
        let (count, end) = (1 + random.below(9), 2 + random.below(3));
        // The affine hull is a point, a line, a plane or space.
        let space = points(&mut random, count, round % 4, end);
        let scene = Scene::from_points3(&space.iter().map(|&p| exact(p)).collect::<Vec<_>>()).unwrap();
        let expected = extreme(&space);
        assert_eq!(indices(hull::extreme(&Judged::exact(&scene))), expected, "{space:?}");
        of_sizes[expected.len().min(8)] += 1;
        let plane: Vec<Point> = space.iter().map(|&[x, y, _]| [x, y, 0]).collect();
        let flat: Vec<[f64; 2]> = plane.iter().map(|&p| exact(p)).map(|[x, y, _]| [x, y]).collect();
        let scene = Scene::from_points2(&flat).unwrap();
        assert_eq!(indices(hull::extreme(&Judged::exact(&scene))), extreme(&plane), "{plane:?}");
    }
    assert!(of_sizes[1..8].iter().all(|&count| count > 8), "{of_sizes:?}");
}

#[test]
fn the_largest_scenes_that_are_judged_are_named() {
    use predicament_predicates::Dimension::{Three, Two};
    assert_eq!([hull::most(Two), hull::most(Three)], [40, 24]);
}
