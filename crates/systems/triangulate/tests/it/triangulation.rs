//! Each check of triangulations fails on an output that is wrong in its way, and not on the others.

use predicament_predicates::{Plane, Scene, Vertex};
use predicament_triangulate::checks::{Flat, Flaw, Polygon, flaws, uncovered};

fn vertices<const N: usize>(of: [usize; N]) -> [Vertex; N] {
    of.map(Vertex::input)
}

fn loops(of: &[&[usize]]) -> Vec<Vec<Vertex>> {
    of.iter().map(|one| one.iter().copied().map(Vertex::input).collect()).collect()
}

fn polygon(points: &[[f64; 2]], of: &[&[usize]]) -> Polygon {
    Polygon::new(&Scene::from_points2(points).unwrap(), Plane::Xy, false, &loops(of))
}

fn found(polygon: &Polygon, triangles: &[[usize; 3]], flat: Flat) -> Vec<Flaw> {
    flaws(polygon, &triangles.iter().map(|&triangle| vertices(triangle)).collect::<Vec<_>>(), flat)
}

fn checks(polygon: &Polygon, triangles: &[[usize; 3]]) -> Vec<&'static str> {
    found(polygon, triangles, Flat::WhereLoopsTouch).into_iter().map(|flaw| flaw.check).collect()
}

/// A square with a vertex in the middle of its lower side.
fn square() -> Polygon {
    polygon(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]], &[&[0, 1, 2, 3, 4]])
}

#[test]
fn right_triangles_pass() {
    assert_eq!(found(&square(), &[[0, 1, 4], [1, 3, 4], [1, 2, 3]], Flat::WhereLoopsTouch), []);
    assert_eq!((square().area(), square().corners()), (4.into(), 5));
}

/// The first flaw of each check, with the value found and the value expected.
#[test]
fn flaws_say_what_is_wrong_and_where() {
    let said = |polygon: &Polygon, triangles: &[[usize; 3]]| -> Vec<String> {
        let flaws = found(polygon, triangles, Flat::WhereLoopsTouch);
        flaws.iter().map(|flaw| format!("{}: {}, not {}", flaw.check, flaw.got, flaw.truth)).collect()
    };
    let square = square();
    let right = [[0, 1, 4], [1, 3, 4], [1, 2, 3]];
    let none = said(&square, &[right[0], right[1], right[2], [0, 1, 7]]);
    assert_eq!(none[0], "vertices: 0 1 7, not three vertices of the polygon");
    assert_eq!(none[1], "count: 4 triangles, not 3 triangles");
    let flat = said(&square, &[[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    let truth = "counterclockwise, or flat if loops touch there";
    assert_eq!(flat, [format!("positive: the triangle 0 1 2 is flat, not {truth}")]);
    let missing = [
        "count: 2 triangles, not 3 triangles",
        "area: 3, not 4",
        "boundary: the side from 1 to 2 is in 0 triangles, the opposite side in 0, not the side from 1 to 2 is in 1 triangles, the opposite side in 0",
        "diagonals: the side from 1 to 3 is in 1 triangles, the opposite side in 0, not the side from 1 to 3 is in 1 triangles, the opposite side in 1",
    ];
    assert_eq!(said(&square, &right[..2]), missing);
    let plain = polygon(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]], &[&[0, 1, 2, 3]]);
    let half = said(&plain, &[[0, 1, 2], [1, 2, 3]]);
    assert_eq!(half[2], "overlap: the triangles 0 1 2 and 1 2 3 overlap, not no inner point in common");
    let mirrored = said(&plain, &[[0, 2, 1], [0, 2, 3]]);
    assert_eq!(mirrored[0], format!("positive: the triangle 0 2 1 is clockwise, not {truth}"));
}

#[test]
fn each_check_fails_on_what_it_is_for() {
    let square = square();
    let right = [[0, 1, 4], [1, 3, 4], [1, 2, 3]];
    // A vertex that is not in the polygon, and a vertex that occurs twice.
    assert_eq!(checks(&square, &[right[0], right[1], right[2], [0, 0, 1]])[..2], ["vertices", "count"]);
    assert_eq!(checks(&square, &[right[0], right[1], right[2], [0, 1, 7]])[..2], ["vertices", "count"]);
    // A triangle is missing.
    assert_eq!(checks(&square, &right[..2]), ["count", "area", "boundary", "diagonals"]);
    // A triangle without area where none is needed.
    assert_eq!(checks(&square, &[[0, 1, 2], [0, 2, 3], [0, 3, 4]]), ["positive"]);
    assert_eq!(found(&square, &[[0, 1, 2], [0, 2, 3], [0, 3, 4]], Flat::Anywhere), []);
    // The sides are right, but one triangle is clockwise, so others overlap.
    let reflex = polygon(&[[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]], &[&[0, 1, 2, 3]]);
    assert_eq!(checks(&reflex, &[[0, 1, 2], [0, 2, 3]]), [""; 0]);
    assert_eq!(checks(&reflex, &[[0, 1, 3], [1, 2, 3]]), ["positive"]);
    // A triangle twice: one too many, too much area, and its sides too often.
    let twice = checks(&square, &[right[0], right[1], right[2], right[2]]);
    assert_eq!(twice, ["count", "area", "boundary", "diagonals", "overlap"]);
    // One triangle of each of the two divisions of a quadrilateral: area and count are right, sides are not.
    let plain = polygon(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]], &[&[0, 1, 2, 3]]);
    assert_eq!(checks(&plain, &[[0, 1, 2], [1, 2, 3]]), ["boundary", "diagonals", "overlap"]);
    // A square covered twice, by both divisions: each side of the loop is in two triangles.
    let both = checks(&plain, &[[0, 1, 2], [0, 2, 3], [0, 1, 3], [1, 2, 3]]);
    assert_eq!(both, ["count", "area", "boundary", "overlap"]);
}

#[test]
fn areas_and_overlaps_are_told_apart() {
    // A filled hole: its edges become diagonals.
    let points = [[0.0, 0.0], [9.0, 0.0], [0.0, 9.0], [2.0, 2.0], [3.0, 2.0], [2.0, 3.0]];
    let ring = polygon(&points, &[&[0, 1, 2], &[3, 4, 5]]);
    let right = [[0, 1, 4], [0, 4, 3], [0, 3, 5], [0, 5, 2], [5, 4, 2], [4, 1, 2]];
    assert_eq!(checks(&ring, &right), [""; 0]);
    let filled: Vec<[usize; 3]> = right.into_iter().chain([[3, 4, 5]]).collect();
    assert_eq!(checks(&ring, &filled), ["count", "area", "boundary"]);
}

#[test]
fn loops_that_cross_are_said_first() {
    let points = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
    assert_eq!(checks(&polygon(&points, &[&[0, 1, 2, 3]]), &[[0, 1, 2]]), ["loops do not cross"]);
}

#[test]
fn numbers_of_triangles_where_loops_touch() {
    let area = |points: &[[f64; 2]], of: &[&[usize]], triangles: &[[usize; 3]]| {
        let polygon = polygon(points, of);
        assert_eq!(checks(&polygon, triangles), [""; 0]);
        polygon.area()
    };
    // A hole in a corner that shares the vertex of the outer loop.
    let points = [[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0], [2.0, 1.0], [1.0, 2.0], [0.0, 0.0]];
    let five = [[0, 1, 4], [4, 1, 2], [4, 2, 5], [5, 2, 3], [0, 5, 3]];
    assert_eq!(area(&points, &[&[0, 1, 2, 3], &[0, 4, 5]], &five) * 2, 69);
    // The same hole with its own vertex: two triangles at the edge without length.
    let seven = [[0, 1, 4], [0, 4, 6], [4, 1, 2], [4, 2, 5], [5, 2, 3], [6, 5, 3], [0, 6, 3]];
    assert_eq!(area(&points, &[&[0, 1, 2, 3], &[6, 4, 5]], &seven) * 2, 69);
    // A vertex of a hole on an edge: the triangle of both is flat, and allowed only there.
    let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 4.0], [2.0, 0.0], [2.5, 1.0], [1.5, 1.0]];
    let of: [&[usize]; 2] = [&[0, 1, 2], &[3, 4, 5]];
    let right = [[0, 1, 3], [3, 1, 4], [4, 1, 2], [5, 4, 2], [0, 5, 2], [0, 3, 5]];
    assert_eq!(area(&points, &of, &right) * 2, 15);
}

#[test]
fn an_edge_in_common_is_one_of_two_loops_from_both_sides() {
    let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [4.0, 0.0], [4.0, 2.0], [1.0, 1.0]];
    // Squares side by side, in any direction.
    for second in [&[1, 4, 5, 2][..], &[2, 5, 4, 1]] {
        let neighbors = polygon(&points, &[&[0, 1, 2, 3], second]);
        assert_eq!((neighbors.fault(), neighbors.area()), (None, 8.into()), "{second:?}");
    }
    // A loop that goes to a vertex inside it and back along the same edge.
    let slit = polygon(&points, &[&[0, 1, 2, 6, 2, 3]]).fault().expect("one edge twice");
    let [a, b] = vertices([2, 6]);
    let said = format!("the edges from {a} to {b} and from {b} to {a} cross, or overlap on a line");
    assert_eq!(slit, (said, vec![a, b, b, a]));
    // The same loop twice.
    assert!(polygon(&points, &[&[0, 1, 2, 3], &[0, 1, 2, 3]]).fault().is_some());
}

/// Triangles of other programs may leave out a vertex in the middle of an edge, use any vertex of a place, and have no
/// area. They must cover the polygon once.
#[test]
fn other_programs_need_not_use_all_vertices() {
    let said = |polygon: &Polygon, triangles: &[[usize; 3]]| -> Vec<String> {
        let flaws = uncovered(polygon, &triangles.iter().map(|&triangle| vertices(triangle)).collect::<Vec<_>>());
        flaws.iter().map(|flaw| format!("{}: {}, not {}", flaw.check, flaw.got, flaw.truth)).collect()
    };
    let checks = |polygon: &Polygon, triangles: &[[usize; 3]]| -> Vec<String> {
        said(polygon, triangles).iter().map(|flaw| flaw.split(':').next().unwrap().to_owned()).collect()
    };
    let square = square();
    for right in [
        &[[0, 1, 4], [1, 3, 4], [1, 2, 3]][..],
        &[[0, 2, 3], [0, 3, 4]],
        // The vertex in the middle is on one side of a diagonal only, or in a triangle without area.
        &[[0, 1, 2], [0, 2, 4], [2, 3, 4]],
    ] {
        assert_eq!(said(&square, right), [""; 0], "{right:?}");
    }
    let missing = [
        "area: 2, not 4",
        "boundary: from 0 to 4, triangles pass 0 times more than back, not from 0 to 4, triangles pass -1 times more than \
         back",
        "diagonals: from 0 to 3, triangles pass -1 times more than back, not from 0 to 3, triangles pass 0 times more than \
         back",
    ];
    assert_eq!(said(&square, &[[0, 2, 3]]), missing);
    // The area is right, but a part is covered twice, and another part is not covered.
    assert_eq!(checks(&square, &[[0, 2, 3], [0, 2, 3]]), ["boundary", "diagonals"]);
    assert_eq!(checks(&square, &[[0, 1, 4], [1, 3, 4], [1, 2, 3], [0, 1, 7]]), ["vertices"]);
    // Three vertices at one place, and a hole that touches the corner there.
    let corner = [[0.0, 0.0], [0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0], [1.0, 2.0], [2.0, 1.0]];
    let touching = polygon(&corner, &[&[0, 1, 2, 3, 4], &[5, 6, 7]]);
    let around = [[0, 2, 7], [7, 2, 3], [7, 3, 6], [6, 3, 4], [1, 6, 4]];
    assert_eq!(said(&touching, &around), [""; 0]);
    assert_eq!(checks(&touching, &around[1..]), ["area", "boundary", "diagonals"]);
    // Loops that cross bound no polygon.
    let tangled = polygon(&[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]], &[&[0, 1, 2, 3]]);
    assert_eq!(checks(&tangled, &[[0, 2, 1]]), ["loops do not cross"]);
}
