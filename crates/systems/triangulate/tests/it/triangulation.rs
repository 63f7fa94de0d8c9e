//! Each check of triangulations fails on an output that is wrong in its way, and not on the others.

use predicament_predicates::{Plane, Scene, Vertex};
use predicament_triangulate::checks::{Fault, FaultKind, Flat, Flaw, Polygon, flaws, limit_flaws, uncovered};

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
}

/// Loops that bound no polygon, each with its reason, over vertices that loops share and over vertices of their own.
#[test]
fn loops_that_bound_no_polygon() {
    let square: [[f64; 2]; 4] = [[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]];
    let fault = |more: &[[f64; 2]], of: &[&[usize]]| {
        let points: Vec<[f64; 2]> = square.iter().chain(more).copied().collect();
        let polygon = polygon(&points, of);
        polygon.fault().map(|fault| (fault.kind, fault.vertices.iter().map(|v| v.index()).collect::<Vec<_>>()))
    };
    let outer: &[usize] = &[0, 1, 2, 3];
    // A loop that goes to a vertex and back: the same vertices, or others in the same places, or one edge longer.
    assert_eq!(fault(&[[3.0, 3.0]], &[&[0, 1, 2, 4, 2, 3]]), Some((FaultKind::Spike, vec![2, 4, 4, 2])));
    assert_eq!(fault(&[[3.0, 3.0], [6.0, 6.0]], &[&[0, 1, 2, 4, 5, 3]]), Some((FaultKind::Spike, vec![2, 4, 4, 5])));
    assert_eq!(fault(&[[3.0, 3.0], [5.0, 5.0]], &[&[0, 1, 2, 4, 5, 3]]), Some((FaultKind::Spike, vec![2, 4, 4, 5])));
    assert_eq!(fault(&[[1.0, 1.0], [3.0, 3.0]], &[&[0, 4, 5]]).unwrap().0, FaultKind::Spike, "no area");
    // A loop twice, a hole along an edge, two holes with a common edge, and an island that fills a hole.
    let holes = [[1.0, 1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0], [1.0, 1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0]];
    let hole: &[usize] = &[4, 5, 6, 7];
    for twice in [&[4, 5, 6, 7][..], &[7, 6, 5, 4], &[8, 9, 10, 11], &[10, 9, 8, 11]] {
        for of in [&[outer, hole, twice][..], &[hole, twice]] {
            assert_eq!(fault(&holes, of).expect("a loop twice").0, FaultKind::Doubled, "{of:?}");
        }
    }
    for beside in [&[5, 6, 12][..], &[9, 10, 12]] {
        let more: Vec<[f64; 2]> = holes.iter().copied().chain([[5.0, 2.0]]).collect();
        assert_eq!(fault(&more, &[outer, hole, beside]).expect("a wall without width").0, FaultKind::Doubled);
        assert_eq!(fault(&more, &[hole, beside]), None, "side by side");
    }
    for inside in [&[4, 5, 12][..], &[8, 9, 12], &[6, 7, 12], &[10, 11, 12]] {
        let more: Vec<[f64; 2]> = holes.iter().copied().chain([[2.0, 2.0]]).collect();
        for of in [&[outer, hole, inside][..], &[hole, inside]] {
            assert_eq!(fault(&more, of).expect("a loop on the edge around it").0, FaultKind::Doubled, "{of:?}");
        }
    }
    // A common part of two edges.
    assert_eq!(fault(&[[1.0, 0.0], [3.0, 0.0], [2.0, 2.0]], &[outer, &[4, 5, 6]]).unwrap().0, FaultKind::Overlap);
    assert_eq!(fault(&[[0.0, 0.0], [3.0, 0.0], [2.0, 2.0]], &[outer, &[4, 5, 6]]).unwrap().0, FaultKind::Overlap);
    // Edges that cross; loops that cross at a vertex of both, at vertices in one place, and in the middle of edges.
    let across = [[0.0, 0.0], [3.0, -3.0], [3.0, 3.0], [3.0, 0.0], [5.0, 3.0], [5.0, 0.0], [5.0, -3.0]];
    assert_eq!(fault(&[], &[&[0, 2, 1, 3]]), Some((FaultKind::Cross, vec![0, 2, 1, 3])));
    assert_eq!(fault(&across, &[outer, &[0, 5, 6]]).unwrap().0, FaultKind::Cross);
    assert_eq!(fault(&across, &[outer, &[6, 7, 5, 10, 9, 8]]), Some((FaultKind::Cross, vec![7])));
    let at_a_corner = [[0.0, 0.0], [-1.0, -2.0], [1.0, 2.0], [2.0, 1.0]];
    assert_eq!(fault(&at_a_corner, &[outer, &[0, 5, 6]]).unwrap().0, FaultKind::Spike, "no area");
    let at_a_corner = [[0.0, 0.0], [-1.0, 1.0], [-1.0, -1.0], [2.0, 1.0], [1.0, 2.0]];
    for (inside, outside) in [(&[0, 7, 8], &[0, 5, 6]), (&[4, 7, 8], &[4, 5, 6]), (&[4, 7, 8], &[0, 5, 6])] {
        assert_eq!(fault(&at_a_corner, &[outer, inside, outside]), None, "{inside:?} {outside:?}");
        let one: Vec<usize> = inside.iter().chain(outside).copied().collect();
        assert_eq!(fault(&at_a_corner, &[outer, &one]).unwrap().0, FaultKind::Cross, "one loop goes in and out");
    }
    for through in [&[6, 0, 7, 5][..], &[6, 4, 7, 5]] {
        let found = fault(&[[0.0, 0.0], [-2.0, 3.0], [-2.0, -1.0], [3.0, 3.0]], &[outer, through]).unwrap();
        assert_eq!(found.0, FaultKind::Cross, "{through:?}");
    }
    let fault = Fault { kind: FaultKind::Spike, vertices: vertices([2, 4, 4, 5]).to_vec() };
    let said = "the edges from 2 to 4 and from 4 to 5 are a spike, forth and back";
    assert_eq!((fault.to_string().as_str(), fault.cure()), (said, "leave the spike out"));
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
}

/// A hole touches an edge of the square in the middle. Triangles cover the same points in either direction.
#[test]
fn the_limit_is_the_polygon_itself() {
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 0.0], [3.0, 1.0], [1.0, 1.0]];
    let polygon = polygon(&points, &[&[0, 1, 2, 3], &[4, 5, 6]]);
    let said = |triangles: &[[usize; 3]]| -> Vec<String> {
        let flaws = limit_flaws(&polygon, &triangles.iter().map(|&triangle| vertices(triangle)).collect::<Vec<_>>());
        flaws.iter().map(|flaw| format!("{}: {}, not {}", flaw.check, flaw.got, flaw.truth)).collect()
    };
    let checks = |triangles: &[[usize; 3]]| -> Vec<String> {
        said(triangles).iter().map(|flaw| flaw.split(':').next().unwrap().to_owned()).collect()
    };
    let both = ["area of the limit", "inside of the limit"];
    let right = [[0, 4, 6], [4, 1, 5], [1, 2, 5], [5, 2, 3], [3, 6, 5], [0, 6, 3]];
    assert_eq!(said(&right), [""; 0]);
    assert_eq!(said(&right.map(|[a, b, c]| [c, b, a])), [""; 0], "in either direction");
    // With the flat triangle at the touch, or without it.
    let with_flat: Vec<[usize; 3]> = right.into_iter().chain([[0, 1, 4]]).collect();
    assert_eq!(said(&with_flat), [""; 0]);
    // The hole is filled, by a triangle that is clockwise: areas with signs would cancel.
    let filled: Vec<[usize; 3]> = right.into_iter().chain([[4, 6, 5], [4, 5, 6]]).collect();
    assert_eq!(checks(&filled), both);
    let twice: Vec<[usize; 3]> = right.into_iter().chain([right[2]]).collect();
    assert_eq!(checks(&twice), both);
    assert_eq!(checks(&right[1..]), both);
    assert_eq!(said(&right[1..])[0], "area of the limit: 14, not 15");
    // The area is right, but one part is covered twice and another is not covered.
    assert_eq!(checks(&[right[0], right[0], right[2], right[3], right[4], right[5]]), [both[1]]);
}

/// Two corners at one place in a row: triangles without area at the edge between them may be there or not.
#[test]
fn edges_without_length_leave_flat_triangles_open() {
    let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    let square = polygon(&points, &[&[0, 1, 2, 3, 4]]);
    assert_eq!(square.fault(), None);
    assert_eq!(checks(&square, &[[0, 1, 4], [1, 2, 3], [1, 3, 4]]), [""; 0]);
    assert_eq!(checks(&square, &[[0, 1, 4], [1, 3, 4]]), [""; 0]);
    assert_eq!(checks(&square, &[[0, 1, 4]]), ["area", "boundary", "diagonals"]);
    assert_eq!(checks(&square, &[[0, 1, 4], [0, 1, 4]]), ["boundary", "diagonals"]);
    let point = polygon(&[[0.0, 0.0], [0.0, 0.0], [0.0, 0.0]], &[&[0, 1, 2]]);
    let fault = point.fault().expect("one place");
    assert_eq!((fault.kind, fault.cure()), (FaultKind::Point, "leave the loop out"));
}
