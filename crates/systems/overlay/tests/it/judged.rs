//! Tests that each law about overlays finds its violations.

use predicament_overlay::checks::overlay::{
    Check, Defects, Expected, Graph, Operands, Point, Results, Shape, Windings, winding_of,
};
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

/// The graph with one edge reversed.
fn turned(mut graph: Graph, edge: usize) -> Graph {
    graph.edges[edge].reverse();
    graph.segments[edge].reverse();
    graph.chains[edge].reverse();
    let half = |half: usize| if half / 2 == edge { half ^ 1 } else { half };
    let halves = 0..graph.next.len();
    let next = |at: usize| u32::try_from(half(graph.next[half(at)] as usize)).unwrap();
    let (next, face) = (halves.clone().map(next).collect(), halves.map(|at| graph.face[half(at)]).collect());
    Graph { next, face, ..graph }
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
    // The inner segment is longer than the arrangement says, and crosses the diagonal.
    let crossing = violated(&|g| {
        g.nodes[4] = at(1, 2);
        g.segments[5][0] = at(1, 2);
    });
    assert!(crossing.contains(&Check::Crossing), "{crossing:?}");
    // An end touches the diagonal, where there is no node.
    let touching = violated(&|g| {
        g.nodes[4] = at(2, 2);
        g.segments[5][0] = at(2, 2);
    });
    assert!(touching.contains(&Check::Crossing), "{touching:?}");
    assert_eq!(violated(&|g| g.faces = 4), [Check::Euler, Check::Boundary]);
    assert_eq!(violated(&|g| g.next.swap(0, 2)), [Check::Boundary]);
    assert_eq!(violated(&|g| g.face[0] = 2), [Check::Boundary]);
    assert_eq!(violated(&|g| g.next[3] = 12), [Check::Boundary], "there are halves 0 to 11");
    assert_eq!(violated(&|g| g.next[3] = u32::MAX), [Check::Boundary]);
    for face in [0, 2] {
        let nested = violated(&|g| [10, 11].into_iter().for_each(|half| g.face[half] = face));
        assert_eq!(nested, [Check::Nesting]);
    }
}

#[test]
fn a_node_beside_its_segment_is_no_flaw_of_the_chain_unless_it_goes_back() {
    // A segment of two edges, with nothing around it.
    let along = |x: Rational, y: Rational| Graph {
        nodes: vec![at(0, 0), [x, y], at(8, 0)],
        segments: vec![[at(0, 0), at(8, 0)]],
        chains: vec![vec![0, 1, 2]],
        edges: vec![[0, 1], [1, 2]],
        next: vec![2, 0, 3, 1],
        face: vec![0; 4],
        faces: 1,
    };
    let little = || Rational::from((1, 1_u64 << 52));
    assert_eq!(along(Rational::from(3), Rational::new()).flaws(EXPECTED), []);
    let beside = along(Rational::from(3), -little()).flaws(EXPECTED);
    assert_eq!(beside.iter().map(|flaw| flaw.check).collect::<Vec<_>>(), [Check::OnSegment]);
    assert_eq!(beside[0].what, "node 1 is 2.220446049250313e-16 off segment 0");
    assert!(Check::OnSegment.is_metric() && !Check::Chain.is_metric());
    // Beyond an end the chain goes back, which is not a metric flaw.
    assert_eq!(found(&along(-little(), Rational::new())), [Check::Chain, Check::OnSegment, Check::Crossing]);
}

#[test]
fn directions_of_edges_do_not_matter() {
    for turns in 0..1_u32 << 6 {
        let graph = (0..6).filter(|edge| turns >> edge & 1 == 1).fold(graph(), turned);
        assert_eq!(found(&graph), [], "{turns:b}");
        for face in [0, 2] {
            let mut graph = graph.clone();
            [10, 11].into_iter().for_each(|half| graph.face[half] = face);
            assert_eq!(found(&graph), [Check::Nesting], "{turns:b}");
        }
        let mut graph = graph;
        graph.faces = 4;
        assert_eq!(found(&graph), [Check::Euler, Check::Boundary], "{turns:b}");
    }
}

#[test]
fn winding_numbers_follow_from_what_passes_edges() {
    // The lower right half once, and the whole square twice.
    let right = Windings {
        passes: vec![[1, 2], [1, 2], [0, 2], [0, 2], [-1, 0], [0, 0]],
        faces: vec![[0, 0], [1, 2], [0, 2]],
        modulo_two: false,
    };
    assert_eq!(right.flaws(&graph()), []);
    assert_eq!([0, 1].map(|operand| right.only(operand)), [Some(1), Some(2)]);
    let violated = |wrong: &dyn Fn(&mut Windings)| {
        let mut windings = right.clone();
        wrong(&mut windings);
        windings.flaws(&graph()).into_iter().map(|flaw| (flaw.check, flaw.count)).collect::<Vec<_>>()
    };
    assert_eq!(violated(&|w| w.faces[2][0] = 1), [(Check::Winding, 3)], "each edge around the face");
    assert_eq!(violated(&|w| w.passes[0][1] = 1), [(Check::Winding, 1)], "an edge that is counted once");
    assert_eq!(violated(&|w| w.passes[4][0] = 1), [(Check::Winding, 1)], "an edge in the other direction");
    assert_eq!(violated(&|w| w.faces.iter_mut().for_each(|face| face[0] += 1)), [(Check::Winding, 1)], "outside");
    assert_eq!(violated(&|w| w.faces.truncate(2)), [(Check::Winding, 6)], "three edges, two operands");
    // With parity only, twice counts as zero.
    let parity = Windings { faces: vec![[0, 0], [1, 0], [0, 0]], modulo_two: true, ..right.clone() };
    assert_eq!((parity.flaws(&graph()), parity.only(0)), (vec![], None));
    let several = Windings { faces: vec![[0, 0], [1, 2], [0, -2]], ..right };
    assert_eq!([0, 1].map(|operand| several.only(operand)), [Some(1), None]);
}

#[test]
fn areas_of_parts_add_up_to_that_of_their_union() {
    // Too many parts to measure strip by strip; clockwise, as in some files.
    let part = |x: i32, y: i32| reversed(loop_of(&[[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]]));
    let parts: Vec<Vec<Point>> = (0..10).flat_map(|x| (0..10).map(move |y| part(x, y))).collect();
    let any: fn(i32) -> bool = |winding| winding != 0;
    let operands = Operands { loops: [parts, vec![square(12, 14)]], rules: [any; 2] };
    assert_eq!((operands.area(0), operands.signed_area(0)), (None, Rational::from(-200)));
    let only = [Some(-1), Some(1)];
    let found = |results: &Results, only| {
        let flaws = results.flaws(&operands, &[], EXPECTED, only);
        flaws.into_iter().map(|flaw| flaw.check).collect::<Vec<_>>()
    };
    let [first, second] = [square(0, 10), square(12, 14)].map(|one| vec![one]);
    let both = vec![first.clone(), second.clone()];
    let right = Results { regions: [both.clone(), vec![], vec![first], both] };
    assert_eq!(found(&right, only), []);
    // All other laws hold when an operand is forgotten.
    let forgotten = Results { regions: [vec![second.clone()], vec![], vec![], vec![second]] };
    assert_eq!(found(&forgotten, [None; 2]), []);
    assert_eq!(found(&forgotten, only), [Check::Area]);
    let small = vec![square(12, 13)];
    let both = vec![right.regions[2][0].clone(), small];
    let smaller = Results { regions: [both.clone(), vec![], right.regions[2].clone(), both] };
    assert_eq!((found(&smaller, [None; 2]), found(&smaller, only)), (vec![], vec![Check::Area]));
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

/// A square with two others, one of which is a hole of the difference.
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
    assert_eq!(results().flaws(&operands(), &probes(), EXPECTED, [None; 2]), []);
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
        let flaws = results.flaws(&operands(), &probes(), EXPECTED, [None; 2]);
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
    // A hole outside its region.
    let outside = violated(&|results| results.regions[2][0][1] = reversed(square(10, 12)));
    assert_eq!(outside, [Check::Orientation, Check::Membership]);
    // Regions on top of each other.
    let crossing = violated(&|results| results.regions[1][1][0] = square(3, 4));
    assert!(crossing.contains(&Check::ResultCrossing), "{crossing:?}");
}

/// Tests that a loop without area is not inverted: it may have area only in the perturbed scene.
#[test]
fn loops_without_area_are_right_where_a_perturbation_may_leave_them() {
    let found = |one: Vec<Point>, has_areas: bool| {
        let mut results = results();
        results.regions[1].push(vec![one]);
        let flaws = results.flaws(&operands(), &[], Expected { has_areas, ..EXPECTED }, [None; 2]);
        flaws.iter().any(|flaw| flaw.check == Check::Orientation)
    };
    let flat = loop_of(&[[20, 20], [22, 22], [21, 21]]);
    assert!(found(flat.clone(), true) && !found(flat, false));
    for has_areas in [false, true] {
        assert!(found(reversed(square(20, 22)), has_areas) && !found(square(20, 22), has_areas));
    }
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

/// Tests that no pair of edges that meet is left out: rounded points select the pairs for comparison in rationals.
#[test]
fn no_pair_of_edges_that_meet_is_left_out() {
    // The sign of a turn in integers.
    let turn = |a: [i64; 2], b: [i64; 2], p: [i64; 2]| {
        let [[dx, dy], [ex, ey]] = [b, p].map(|q| [q[0] - a[0], q[1] - a[1]].map(i128::from));
        (dx * ey - dy * ex).signum()
    };
    let crosses = |[a, b]: [[i64; 2]; 2], [c, d]: [[i64; 2]; 2]| {
        turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0
    };
    let mut state = 1_u64;
    let mut random = |range: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i64::try_from((state >> 33) % range).unwrap()
    };
    let mut most = [0, 0];
    // Corners along a line, off it by a few units, with coordinates that barely fit doubles, and with longer ones.
    for (round, (scale, far)) in
        [(1 << 50, 0), (1 << 40, 0), (1, 1 << 52), (1 << 20, 1 << 58)].into_iter().cycle().take(80).enumerate()
    {
        let corners: Vec<[i64; 2]> = (0..24)
            .map(|_| {
                let along = random(9) * scale;
                [along + random(5) + far, along + random(5) - far]
            })
            .collect();
        let point = |p: &[i64; 2]| p.map(Rational::from);
        let edges: Vec<[[i64; 2]; 2]> =
            corners.chunks(3).flat_map(|c| [[c[0], c[1]], [c[1], c[2]], [c[2], c[0]]]).collect();
        let pairs = |i: usize| (0..i).map(move |j| (i, j));
        let wanted = (0..edges.len()).flat_map(pairs).filter(|&(i, j)| crosses(edges[i], edges[j])).count();
        let regions = vec![corners.chunks(3).map(|c| c.iter().map(point).collect()).collect()];
        assert_eq!(Shape { regions }.defects().crossings, wanted, "round {round}");
        most[usize::from(far > 0)] = most[usize::from(far > 0)].max(wanted);
    }
    assert!(most.iter().all(|&wanted| wanted > 20), "{most:?}");
}
