//! Tests of arrangements and Boolean operations against rationals: every pair of segments, every edge for every point.

use std::collections::{BTreeMap, BTreeSet};

use predicament_exact::Exact;
use predicament_overlay::algorithm::overlay::{
    Arrangement, Edge, Method, Operation, Overlay, Polygon, Region, Regions, Rule, arrange, overlay,
};
use predicament_predicates::{Backend, Construction, Off, Predicates, Scene, Vertex};
use predicament_sos::Sos;
use rug::Rational;

use crate::common::winding::{Point, point};

/// A generator of pseudorandom numbers.
pub(crate) struct Numbers(pub u64);

impl Numbers {
    pub(crate) fn below(&mut self, n: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        u32::try_from(self.0 >> 33).unwrap() % n
    }

    pub(crate) fn points(&mut self, count: usize, side: u32) -> Vec<[f64; 2]> {
        (0..count).map(|_| [f64::from(self.below(side)), f64::from(self.below(side))]).collect()
    }
}

fn minus(p: &Point, q: &Point) -> Point {
    [0, 1].map(|i: usize| Rational::from(&p[i] - &q[i]))
}

fn cross(u: &Point, v: &Point) -> Rational {
    Rational::from(&u[0] * &v[1]) - Rational::from(&u[1] * &v[0])
}

/// The intersection of two lines.
fn meet([a, b]: [&Point; 2], [c, d]: [&Point; 2]) -> Option<Point> {
    let (u, v) = (minus(b, a), minus(d, c));
    let weight = cross(&u, &v);
    let part = (weight.cmp0().is_ne()).then(|| cross(&minus(c, a), &v) / weight)?;
    Some([0, 1].map(|i: usize| Rational::from(&part * &u[i]) + &a[i]))
}

/// The coordinates of a vertex.
fn at(scene: &Scene, v: Vertex) -> Point {
    match scene.construction(v) {
        None => point(scene, v),
        Some(Construction::Ssi([[a, b], [c, d]])) => {
            let [a, b, c, d] = [a, b, c, d].map(|&v| point(scene, v));
            meet([&a, &b], [&c, &d]).expect("a crossing")
        }
        Some(other) => panic!("{other}"),
    }
}

fn is_on(p: &Point, [a, b]: [&Point; 2]) -> bool {
    let between = |i: usize| (a[i] <= p[i] && p[i] <= b[i]) || (b[i] <= p[i] && p[i] <= a[i]);
    cross(&minus(b, a), &minus(p, a)).cmp0().is_eq() && between(0) && between(1)
}

/// Points and edges of an arrangement, by comparing every pair.
fn by_definition(segments: &[[Point; 2]]) -> (BTreeSet<Point>, BTreeSet<[Point; 2]>) {
    let mut points: BTreeSet<Point> = segments.iter().flatten().cloned().collect();
    for (i, [a, b]) in segments.iter().enumerate() {
        for [c, d] in &segments[..i] {
            let found = meet([a, b], [c, d]).filter(|p| is_on(p, [a, b]) && is_on(p, [c, d]));
            points.extend(found);
        }
    }
    let mut edges = BTreeSet::new();
    for [a, b] in segments {
        let mut on: Vec<&Point> = points.iter().filter(|p| is_on(p, [a, b])).collect();
        on.sort();
        edges.extend(on.windows(2).map(|pair| [pair[0].clone(), pair[1].clone()]));
    }
    (points, edges)
}

fn components(points: &BTreeSet<Point>, edges: &BTreeSet<[Point; 2]>) -> usize {
    let mut class: BTreeMap<&Point, usize> = points.iter().zip(0..).collect();
    for [a, b] in edges {
        let (low, high) = (class[a].min(class[b]), class[a].max(class[b]));
        class.values_mut().filter(|class| **class == high).for_each(|class| *class = low);
    }
    class.values().collect::<BTreeSet<_>>().len()
}

fn pairs(count: usize) -> Vec<[Vertex; 2]> {
    (0..count).map(|i| [2 * i, 2 * i + 1].map(Vertex::input)).collect()
}

fn whole(segments: &[[Vertex; 2]]) -> Vec<Edge> {
    segments.iter().map(|&[a, b]| Edge::whole(a, b)).collect()
}

/// The arrangement by a backend, after a check that both methods agree.
fn arranged<B: Backend>(backend: &B, scene: &Scene, edges: &[Edge]) -> (Arrangement, Scene) {
    let [grid, sweep] = [Method::Grid, Method::Sweep].map(|method| {
        let mut session = backend.prepare(scene, Off).unwrap();
        let arrangement = arrange(&mut session, edges, method).unwrap();
        (arrangement, session.scene().clone())
    });
    let words = |(arrangement, scene): &(Arrangement, Scene)| {
        let vertex = |&v: &Vertex| scene.construction(v).map_or(v.to_string(), ToString::to_string);
        let vertices: Vec<String> = arrangement.vertices.iter().map(vertex).collect();
        (vertices, arrangement.pieces.clone(), arrangement.subdivision.clone(), arrangement.broken)
    };
    assert_eq!(words(&grid), words(&sweep), "both methods");
    grid
}

#[test]
fn arrangements_are_those_of_every_pair() {
    let mut numbers = Numbers(1);
    for round in 0..300 {
        let count = 2 + round % 14;
        let side = [3, 5, 9, 40][round % 4];
        let points = numbers.points(2 * count, side);
        let scene = Scene::from_points2(&points).unwrap();
        let segments = pairs(count);
        let (found, after) = arranged(&Exact, &scene, &whole(&segments));
        assert_eq!(found.broken, None, "round {round}");
        let exact: Vec<[Point; 2]> = segments.iter().map(|ends| ends.map(|v| point(&scene, v))).collect();
        let (points, edges) = by_definition(&exact);
        let nodes: Vec<Point> = found.vertices.iter().map(|&v| at(&after, v)).collect();
        assert_eq!(nodes.iter().cloned().collect::<BTreeSet<_>>(), points, "round {round}");
        assert_eq!(nodes.len(), points.len(), "each once");
        let sorted = |ends: [u32; 2]| {
            let [a, b] = ends.map(|node| nodes[node as usize].clone());
            if a < b { [a, b] } else { [b, a] }
        };
        let pieces: Vec<[Point; 2]> = found.pieces.iter().map(|piece| sorted(piece.ends)).collect();
        assert_eq!(pieces.iter().cloned().collect::<BTreeSet<_>>(), edges, "round {round}");
        assert_eq!(pieces.len(), edges.len(), "each once");
        let components = components(&points, &edges);
        assert_eq!(found.subdivision.components(), components);
        assert_eq!(points.len() + found.subdivision.faces(), edges.len() + 1 + components, "Euler, round {round}");
    }
}

#[test]
fn broken_ties_make_arrangements_by_either_method() {
    let mut numbers = Numbers(2);
    let mut declined = 0;
    for round in 0..150 {
        let count = 2 + round % 12;
        let scene = Scene::from_points2(&numbers.points(2 * count, [3, 5, 9][round % 3])).unwrap();
        // Each vertex is an end once, in random order.
        let mut order: Vec<Vertex> = scene.vertices().collect();
        order.sort_by_cached_key(|v| (numbers.below(1 << 20), *v));
        let edges = whole(order.as_chunks().0);
        let sos = Sos::default();
        let refused = arrange(&mut sos.prepare(&scene, Off).unwrap(), &edges, Method::Grid).is_err();
        if refused {
            // Two segments of one line that cross once they are perturbed.
            declined += 1;
            continue;
        }
        let (found, _) = arranged(&sos, &scene, &edges);
        assert_eq!(found.broken, None);
        // No two vertices coincide: each end is a node, and each other node has four edges.
        let ends = found.vertices.iter().filter(|v| !v.is_constructed()).count();
        assert_eq!(ends, 2 * count);
        let euler = found.vertices.len() + found.subdivision.faces();
        assert_eq!(euler, found.pieces.len() + 1 + found.subdivision.components());
        for node in 0..u32::try_from(found.vertices.len()).unwrap() {
            let degree = found.subdivision.leaving(node).len();
            assert_eq!(degree, if found.vertices[node as usize].is_constructed() { 4 } else { 1 });
        }
    }
    assert!(declined < 100, "{declined}");
}

/// Loops of random corners.
pub(crate) fn polygon(numbers: &mut Numbers, points: usize, rule: Rule) -> Polygon {
    let loops = 1 + numbers.below(3);
    let mut one = || -> Vec<Vertex> {
        let corners = 3 + numbers.below(5);
        (0..corners).map(|_| Vertex::input(numbers.below(u32::try_from(points).unwrap()) as usize)).collect()
    };
    Polygon::of_vertices(&(0..loops).map(|_| one()).collect::<Vec<_>>(), rule)
}

/// The winding number of edges around a point; `None` on an edge.
fn winding(edges: &[[Point; 2]], p: &Point) -> Option<i32> {
    let mut winding = 0;
    for [a, b] in edges {
        if is_on(p, [a, b]) {
            return None;
        }
        let side = cross(&minus(b, a), &minus(p, a));
        if a[1] <= p[1] && b[1] > p[1] && side > 0 {
            winding += 1;
        }
        if b[1] <= p[1] && a[1] > p[1] && side < 0 {
            winding -= 1;
        }
    }
    Some(winding)
}

fn ends_of(scene: &Scene, polygon: &Polygon) -> Vec<[Point; 2]> {
    polygon.loops.iter().flatten().map(|edge| [at(scene, edge.from), at(scene, edge.to)]).collect()
}

/// Twice the area of a polygon, by winding numbers.
pub(crate) fn area(scene: &Scene, polygon: &Polygon) -> Rational {
    ends_of(scene, polygon).iter().map(|[a, b]| cross(a, b)).sum()
}

fn holds(scene: &Scene, polygon: &Polygon, p: &Point) -> Option<bool> {
    winding(&ends_of(scene, polygon), p).map(|winding| polygon.rule.is_inside(winding))
}

/// Regions as a polygon, after checks of their form.
fn checked(session: &dyn Predicates, made: &Overlay, operation: Operation, what: &str) -> Polygon {
    let Regions { regions, broken } = made.regions(operation);
    assert_eq!((broken, made.arrangement.broken), (None, None), "{what}");
    let scene = session.scene();
    assert!(regions.is_sorted());
    for region in &regions {
        let doubled = |one: &Vec<Edge>| -> Rational {
            one.iter().map(|edge| cross(&at(scene, edge.from), &at(scene, edge.to))).sum()
        };
        assert!(region.holes.is_sorted());
        for (one, is_outer) in region.loops().zip(std::iter::once(true).chain(std::iter::repeat(false))) {
            let next = one.iter().cycle().skip(1);
            assert!(one.iter().zip(next).all(|(edge, next)| edge.to == next.from), "closed");
            let mut corners: Vec<Vertex> = one.iter().map(|edge| edge.from).collect();
            corners.sort_unstable();
            assert!(corners.windows(2).all(|pair| pair[0] != pair[1]), "simple");
            assert_eq!(corners.first(), one.first().map(|edge| &edge.from), "the first vertex comes first");
            for edge in one {
                let support = edge.support.map(|v| at(scene, v));
                assert!([edge.from, edge.to].iter().all(|&v| is_on(&at(scene, v), [&support[0], &support[1]])));
            }
            let area = doubled(one);
            assert!(if is_outer { area > 0 } else { area < 0 }, "outer loops counterclockwise, holes clockwise");
        }
    }
    Polygon::from(regions.as_slice())
}

/// Points in general position.
fn probes(numbers: &mut Numbers, side: u32) -> Vec<Point> {
    let coordinate = |numbers: &mut Numbers| Rational::from((numbers.below(side * 1009), 1009));
    (0..12).map(|_| [coordinate(numbers), coordinate(numbers)]).collect()
}

#[test]
fn operations_hold_the_points_that_they_have_to() {
    let mut numbers = Numbers(3);
    for round in 0..predicament_effort::some_or_all(100, 300) {
        let side = [4, 6, 12][round % 3];
        let scene = Scene::from_points2(&numbers.points(6 + round % 9, side)).unwrap();
        let rules = [[Rule::EvenOdd, Rule::NonZero], [Rule::NonZero, Rule::EvenOdd]][round % 2];
        let operands = rules.map(|rule| polygon(&mut numbers, scene.len(), rule));
        let method = if round % 5 == 0 { Method::Sweep } else { Method::Grid };
        let mut session = Exact.prepare(&scene, Off).unwrap();
        let made = overlay(&mut session, [&operands[0], &operands[1]], method).unwrap();
        let results = Operation::ALL.map(|operation| checked(&session, &made, operation, &format!("round {round}")));
        let areas = results.each_ref().map(|result| area(session.scene(), result));
        let [union, intersection, difference, either] = &areas;
        assert_eq!(Rational::from(union - intersection), *either, "round {round}");
        assert!(*difference >= 0 && difference <= either);
        for p in probes(&mut numbers, side) {
            let inside = operands.each_ref().map(|operand| holds(&scene, operand, &p));
            let [Some(a), Some(b)] = inside else { continue };
            for (operation, result) in Operation::ALL.into_iter().zip(&results) {
                let holds = holds(session.scene(), result, &p);
                assert_eq!(holds, Some(operation.holds([a, b])), "round {round}, {} at {p:?}", operation.name());
            }
        }
    }
}

#[test]
fn results_of_broken_ties_have_the_same_areas() {
    let mut numbers = Numbers(4);
    let mut judged = 0;
    for round in 0..150 {
        let scene = Scene::from_points2(&numbers.points(6 + round % 9, [4, 6, 12][round % 3])).unwrap();
        let operands = [(); 2].map(|()| polygon(&mut numbers, scene.len(), Rule::EvenOdd));
        let sos = Sos::default();
        let mut perturbed = sos.prepare(&scene, Off).unwrap();
        let Ok(by_sos) = overlay(&mut perturbed, [&operands[0], &operands[1]], Method::Grid) else { continue };
        judged += 1;
        let mut exact = Exact.prepare(&scene, Off).unwrap();
        let by_exact = overlay(&mut exact, [&operands[0], &operands[1]], Method::Grid).unwrap();
        for operation in Operation::ALL {
            let Regions { regions, broken } = by_sos.regions(operation);
            assert_eq!((broken, by_sos.arrangement.broken), (None, None), "round {round}");
            let moved = area(perturbed.scene(), &Polygon::from(regions.as_slice()));
            assert_eq!(moved, area(exact.scene(), &checked(&exact, &by_exact, operation, "exact")), "round {round}");
        }
    }
    assert!(judged > 60, "{judged}");
}

/// Tests that a result can be an operand: its new vertices are still defined by input vertices.
#[test]
fn regions_in_holes_have_holes() {
    // Six squares around each other, and two more in the innermost hole, which touch in a corner.
    let square = |x: f64, half: f64| [[x - half, -half], [x + half, -half], [x + half, half], [x - half, half]];
    let around = [7.0, 6.0, 5.0, 4.0, 3.0, 2.0].map(|half| square(0.0, half));
    let corner = |x: f64, y: f64| [[x, y], [x + 0.5, y], [x + 0.5, y + 0.5], [x, y + 0.5]];
    let points: Vec<[f64; 2]> = around.into_iter().chain([corner(0.0, 0.0), corner(-0.5, -0.5)]).flatten().collect();
    let scene = Scene::from_points2(&points).unwrap();
    let loops: Vec<Vec<Vertex>> = (0..8).map(|at| (4 * at..4 * at + 4).map(Vertex::input).collect()).collect();
    let polygon = Polygon::of_vertices(&loops, Rule::EvenOdd);
    for method in [Method::Grid, Method::Sweep] {
        let mut session = Exact.prepare(&scene, Off).unwrap();
        let made = overlay(&mut session, [&polygon, &Polygon::default()], method).unwrap();
        let Regions { regions, broken } = made.regions(Operation::Union);
        assert_eq!(broken, None);
        let sizes: Vec<(usize, usize)> =
            regions.iter().map(|one| (one.outer[0].from.index(), one.holes.len())).collect();
        assert_eq!(sizes, [(0, 1), (8, 1), (16, 1), (24, 0), (24, 0)], "{regions:?}");
    }
}

#[test]
fn results_are_overlaid_again_without_deeper_vertices() {
    let mut numbers = Numbers(5);
    for round in 0..200 {
        let side = [4, 6, 12][round % 3];
        let scene = Scene::from_points2(&numbers.points(8 + round % 9, side)).unwrap();
        let operands = [(); 3].map(|()| polygon(&mut numbers, scene.len(), Rule::EvenOdd));
        let mut session = Exact.prepare(&scene, Off).unwrap();
        let first = overlay(&mut session, [&operands[0], &operands[1]], Method::Grid).unwrap();
        let operation = Operation::ALL[round % 4];
        let once = checked(&session, &first, operation, &format!("first, round {round}"));
        let method = if round % 3 == 0 { Method::Sweep } else { Method::Grid };
        let second = overlay(&mut session, [&once, &operands[2]], method).unwrap();
        let after = Operation::ALL[(round / 4) % 4];
        let twice = checked(&session, &second, after, &format!("second, round {round}, {method:?}"));
        assert!(session.scene().constructions().iter().all(Construction::is_of_inputs));
        for p in probes(&mut numbers, side) {
            let inside = operands.each_ref().map(|operand| holds(&scene, operand, &p));
            let [Some(a), Some(b), Some(c)] = inside else { continue };
            let wanted = after.holds([operation.holds([a, b]), c]);
            assert_eq!(holds(session.scene(), &twice, &p), Some(wanted), "round {round}");
        }
        // The same again with itself changes nothing, except the choice of the vertex at a position with several.
        let third = overlay(&mut session, [&twice, &twice], Method::Grid).unwrap();
        let same = checked(&session, &third, Operation::Intersection, "third");
        let [mut same, mut twice] = [&same, &twice].map(|polygon| ends_of(session.scene(), polygon));
        same.sort();
        twice.sort();
        assert_eq!(same, twice, "round {round}");
        assert_eq!(checked(&session, &third, Operation::SymmetricDifference, "third").loops.len(), 0);
    }
}

/// The loops of regions as coordinates, each from its least corner on.
pub(crate) fn by_place(scene: &Scene, regions: &[Region]) -> Vec<Vec<Vec<Point>>> {
    let loop_of = |one: &Vec<Edge>| {
        let mut corners: Vec<Point> = one.iter().map(|edge| at(scene, edge.from)).collect();
        let least = (0..corners.len()).min_by_key(|&i| &corners[i]).unwrap();
        corners.rotate_left(least);
        corners
    };
    let region = |region: &Region| {
        let mut loops: Vec<Vec<Point>> = region.loops().map(loop_of).collect();
        loops[1..].sort();
        loops
    };
    let mut all: Vec<_> = regions.iter().map(region).collect();
    all.sort();
    all
}

/// Tests laws between results of the same operands: A or B is B or A, and (A not B) or (A and B) is A.
#[test]
fn operations_satisfy_the_laws_of_sets() {
    let mut numbers = Numbers(13);
    for round in 0..150 {
        let scene = Scene::from_points2(&numbers.points(6 + round % 9, [4, 6, 12][round % 3])).unwrap();
        let [a, b] = [(); 2].map(|()| polygon(&mut numbers, scene.len(), [Rule::EvenOdd, Rule::NonZero][round % 2]));
        let mut session = Exact.prepare(&scene, Off).unwrap();
        let mut regions = |first: &Polygon, second: &Polygon, operation: Operation| {
            let made = overlay(&mut session, [first, second], Method::Grid).unwrap();
            let made = made.regions(operation).regions;
            (by_place(session.scene(), &made), Polygon::from(made.as_slice()))
        };
        for operation in [Operation::Union, Operation::Intersection, Operation::SymmetricDifference] {
            assert_eq!(
                regions(&a, &b, operation).0,
                regions(&b, &a, operation).0,
                "round {round}, {}",
                operation.name()
            );
        }
        let [rest, common] =
            [Operation::Difference, Operation::Intersection].map(|operation| regions(&a, &b, operation).1);
        let nothing = Polygon::default();
        let whole = regions(&a, &nothing, Operation::Union).0;
        assert_eq!(corners_of(regions(&rest, &common, Operation::Union).0), corners_of(whole), "round {round}");
        assert_eq!(regions(&rest, &common, Operation::Intersection).0, Vec::<Vec<Vec<Point>>>::new(), "round {round}");
        let [there, back] = [[&a, &b], [&b, &a]].map(|[a, b]| regions(a, b, Operation::Difference).1);
        let either = regions(&there, &back, Operation::Union).0;
        assert_eq!(either, regions(&a, &b, Operation::SymmetricDifference).0, "round {round}");
    }
}

/// Loops without their straight corners.
fn corners_of(regions: Vec<Vec<Vec<Point>>>) -> Vec<Vec<Vec<Point>>> {
    let turns = |one: &Vec<Point>, i: usize| {
        let [before, here, after] = [i + one.len() - 1, i, i + 1].map(|i| &one[i % one.len()]);
        cross(&minus(here, before), &minus(after, here)).cmp0().is_ne()
    };
    let kept = |one: Vec<Point>| (0..one.len()).filter(|&i| turns(&one, i)).map(|i| one[i].clone()).collect();
    regions.into_iter().map(|region| region.into_iter().map(kept).collect()).collect()
}

#[test]
fn segments_through_one_point_are_entries_of_it() {
    // In the centre all cross; outside it, none.
    let spokes = 400_u32;
    let points: Vec<[f64; 2]> = (0..spokes)
        .flat_map(|i| {
            let (x, y) = (f64::from(i) - f64::from(spokes) / 2.0, 300.0);
            [[x, y], [-x, -y]]
        })
        .collect();
    let scene = Scene::from_points2(&points).unwrap();
    let edges = whole(&pairs(spokes as usize));
    let (found, after) = arranged(&Exact, &scene, &edges);
    assert_eq!(found.vertices.len(), 2 * spokes as usize + 1);
    assert_eq!(found.pieces.len(), 2 * spokes as usize);
    let mut session = Exact.prepare(&scene, Off).unwrap();
    arrange(&mut session, &edges, Method::Grid).unwrap();
    assert!(after.constructions().len() < 10 * spokes as usize, "{} vertices", after.constructions().len());
}

#[test]
fn too_many_crossings_are_refused() {
    if predicament_effort::divisor() > 1 {
        // Seventeen million crossings take a while.
        return;
    }
    let lines = 4_200_u32;
    let across = (0..lines).flat_map(|i| {
        let at = f64::from(i);
        [[at, -1.0], [at, 4_200.0], [-1.0, at], [4_200.0, at]]
    });
    let scene = Scene::from_points2(&across.collect::<Vec<_>>()).unwrap();
    let mut session = Exact.prepare(&scene, Off).unwrap();
    let refused = arrange(&mut session, &whole(&pairs(2 * lines as usize)), Method::Grid).unwrap_err();
    assert!(refused.to_string().contains("more than 16777216 crossings: divide the scene"), "{refused}");
}
