//! Each law about overlays finds what violates it.

use predicament_checks::overlay::{Check, Defects, Expected, Graph, Operands, Point, Results, Shape, winding_of};
use rug::Rational;

const EXPECTED: Expected = Expected { has_areas: true, edges_crossed: 1_000, located: 1_000 };

fn at(x: i32, y: i32) -> Point {
    [x, y].map(Rational::from)
}

fn loop_of(corners: &[[i32; 2]]) -> Vec<Point> {
    corners.iter().map(|&[x, y]| at(x, y)).collect()
}

/// A square with one diagonal, and a segment in one of its halves.
fn graph() -> Graph {
    let nodes = loop_of(&[[0, 0], [8, 0], [8, 8], [0, 8], [5, 2], [6, 2]]);
    let edges = vec![[0, 1], [1, 2], [2, 3], [3, 0], [0, 2], [4, 5]];
    Graph {
        segments: edges.iter().map(|ends: &[u32; 2]| ends.map(|node| nodes[node as usize].clone())).collect(),
        chains: edges.iter().map(|ends| ends.to_vec()).collect(),
        nodes,
        // Around the lower right half, the upper left one, and the outside.
        next: vec![2, 7, 9, 1, 6, 3, 8, 5, 4, 0, 11, 10],
        face: vec![1, 0, 1, 0, 2, 0, 2, 0, 2, 1, 1, 1],
        edges,
        faces: 3,
    }
}

fn found(graph: &Graph) -> Vec<Check> {
    graph.flaws(EXPECTED).into_iter().map(|flaw| flaw.check).collect()
}

#[test]
fn an_arrangement_satisfies_the_laws() {
    assert_eq!(graph().flaws(EXPECTED), []);
}

#[test]
fn each_law_of_arrangements_is_violated_by_something() {
    let violated = |wrong: &dyn Fn(&mut Graph)| {
        let mut graph = graph();
        wrong(&mut graph);
        found(&graph)
    };
    assert_eq!(violated(&|g| g.nodes[5] = at(5, 2)), [Check::Nodes, Check::Chain]);
    assert_eq!(violated(&|g| g.chains[0] = vec![0]), [Check::Chain, Check::Edges]);
    assert_eq!(violated(&|g| g.chains[3].reverse()), [Check::Chain]);
    assert_eq!(violated(&|g| g.segments[1] = [at(8, 0), at(8, 9)]), [Check::Chain]);
    // The inner segment is longer than it was found to be, and crosses the diagonal.
    let crossing = violated(&|g| {
        g.nodes[4] = at(1, 2);
        g.segments[5][0] = at(1, 2);
    });
    assert!(crossing.contains(&Check::Crossing), "{crossing:?}");
    // An end touches the diagonal, which has no node there.
    let touching = violated(&|g| {
        g.nodes[4] = at(2, 2);
        g.segments[5][0] = at(2, 2);
    });
    assert!(touching.contains(&Check::Crossing), "{touching:?}");
    assert_eq!(violated(&|g| g.faces = 4), [Check::Euler, Check::Boundary]);
    assert_eq!(violated(&|g| g.next.swap(0, 2)), [Check::Boundary]);
    assert_eq!(violated(&|g| g.face[0] = 2), [Check::Boundary]);
    for face in [0, 2] {
        let nested = violated(&|g| [10, 11].into_iter().for_each(|half| g.face[half] = face));
        assert_eq!(nested, [Check::Nesting]);
    }
}

fn square(low: i32, high: i32) -> Vec<Point> {
    loop_of(&[[low, low], [high, low], [high, high], [low, high]])
}

fn operands() -> Operands {
    let odd: fn(i32) -> bool = |winding| winding % 2 != 0;
    Operands { loops: [vec![square(0, 6)], vec![square(2, 4), square(5, 8)]], rules: [odd; 2] }
}

fn reversed(mut one: Vec<Point>) -> Vec<Point> {
    one.reverse();
    one
}

/// One square with two others, of which one is a hole of the difference.
fn results() -> Results {
    let union = loop_of(&[[0, 0], [6, 0], [6, 5], [8, 5], [8, 8], [5, 8], [5, 6], [0, 6]]);
    let difference = loop_of(&[[0, 0], [6, 0], [6, 5], [5, 5], [5, 6], [0, 6]]);
    let rest = loop_of(&[[6, 5], [8, 5], [8, 8], [5, 8], [5, 6], [6, 6]]);
    let with_hole = vec![difference, reversed(square(2, 4))];
    Results {
        regions: [
            vec![vec![union]],
            vec![vec![square(2, 4)], vec![square(5, 6)]],
            vec![with_hole.clone()],
            vec![with_hole, vec![rest]],
        ],
    }
}

fn probes() -> Vec<Point> {
    let at = |x: i32| Rational::from((2 * x + 1, 2));
    (-1..9).flat_map(|x| (-1..9).map(move |y| [at(x), at(y)])).collect()
}

#[test]
fn results_satisfy_the_laws() {
    assert_eq!(results().flaws(&operands(), &probes(), EXPECTED), []);
}

#[test]
fn areas_of_operands_are_measured_by_their_rule() {
    let twice = vec![square(0, 6), square(2, 4)];
    let odd: fn(i32) -> bool = |winding| winding % 2 != 0;
    let any: fn(i32) -> bool = |winding| winding != 0;
    let operands = Operands { loops: [twice.clone(), twice], rules: [odd, any] };
    assert_eq!([0, 1].map(|operand| operands.area(operand).unwrap()), [64, 72], "twice the area");
    // A bow tie: two triangles that meet in a crossing.
    let tie = vec![loop_of(&[[0, 0], [6, 6], [6, 0], [0, 6]])];
    let operands = Operands { loops: [tie.clone(), tie], rules: [odd, any] };
    assert_eq!([0, 1].map(|operand| operands.area(operand).unwrap()), [36, 36]);
}

#[test]
fn each_law_of_results_is_violated_by_something() {
    let violated = |wrong: &dyn Fn(&mut Results)| {
        let mut results = results();
        wrong(&mut results);
        let flaws = results.flaws(&operands(), &probes(), EXPECTED);
        flaws.into_iter().map(|flaw| flaw.check).collect::<Vec<_>>()
    };
    // No hole.
    let dropped = violated(&|results| results.regions[2][0].truncate(1));
    assert_eq!(dropped, [Check::Area, Check::Membership]);
    // The other way around.
    let turned = violated(&|results| results.regions[0][0][0].reverse());
    assert_eq!(turned, [Check::Orientation, Check::Area, Check::Membership]);
    // The right area in the wrong place.
    let moved = violated(&|results| results.regions[1][0][0] = square(1, 3));
    assert_eq!(moved, [Check::Membership]);
    // A hole outside of its region.
    let outside = violated(&|results| results.regions[2][0][1] = reversed(square(10, 12)));
    assert_eq!(outside, [Check::Orientation, Check::Membership]);
    // Regions on top of each other.
    let crossing = violated(&|results| results.regions[1][1][0] = square(3, 4));
    assert!(crossing.contains(&Check::ResultCrossing), "{crossing:?}");
}

#[test]
fn a_shape_is_measured_as_it_is() {
    let outer = loop_of(&[[0, 0], [8, 0], [8, 8], [0, 8]]);
    let hole = loop_of(&[[2, 2], [2, 4], [4, 4], [4, 2]]);
    let shape = |loops: &[Vec<Point>]| Shape { regions: vec![loops.to_vec()] };
    let whole = shape(&[outer.clone(), hole.clone()]);
    assert_eq!(whole.defects(), Defects::default());
    assert_eq!((whole.area(), whole.edges().count()), (Rational::from(2 * (64 - 4)), 8));
    let located = [at(1, 1), at(3, 3), at(9, 9), at(2, 3)].map(|p| whole.winding(&p));
    assert_eq!(located, [Some(1), Some(0), Some(0), None]);
    assert_eq!(winding_of(std::slice::from_ref(&outer), &at(3, 3)), Some(1));
    let turned = |one: &Vec<Point>| one.iter().rev().cloned().collect::<Vec<_>>();
    let inverted = Defects { inverted: 1, ..Defects::default() };
    assert_eq!(shape(&[turned(&outer), hole.clone()]).defects(), inverted);
    assert_eq!(shape(&[outer.clone(), turned(&hole)]).defects(), inverted);
    let flat = loop_of(&[[1, 1], [2, 1], [3, 1]]);
    let of_flat = shape(&[outer.clone(), flat]).defects();
    assert_eq!((of_flat.flat, of_flat.touches, of_flat.crossings), (1, 2, 0), "its edges overlap the way back");
    // A bow tie crosses itself once.
    let bow = loop_of(&[[0, 0], [8, 8], [8, 0], [0, 6]]);
    let of_bow = shape(&[bow]).defects();
    assert_eq!((of_bow.crossings, of_bow.touches), (1, 0));
    // A hole whose corner is on the outer loop's edge touches it with both its edges there; at a corner it does not.
    let touching = loop_of(&[[0, 3], [4, 4], [4, 2]]);
    assert_eq!(shape(&[outer.clone(), touching]).defects().touches, 2);
    let at_a_corner = loop_of(&[[0, 0], [4, 4], [4, 2]]);
    assert_eq!(shape(&[outer, at_a_corner]).defects(), Defects::default());
    assert_eq!(Shape::default().defects(), Defects::default());
}
