//! Triangulations of small polygons, checked completely: sides, areas and counts in integers.

use std::collections::BTreeMap;

use predicament_exact::Exact;
use predicament_predicates::{Axis, Backend, Construction, Declined, Off, Plane, Predicates, Scene, Sign, Vertex};
use predicament_sos::Sos;
use predicament_triangulate::algorithm::{
    MOST, Method, Triangulation, oriented, projection, triangulate, triangulate_few,
};
use proptest::prelude::*;
use proptest::strategy::ValueTree;

pub(super) const METHODS: [Method; 2] = [Method::Ears, Method::Monotone];

type Loops = Vec<Vec<Vertex>>;

pub(super) fn scene(points: &[[i32; 2]]) -> Scene {
    let points: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::from)).collect();
    Scene::from_points2(&points).unwrap()
}

fn loops(of: &[&[usize]]) -> Loops {
    of.iter().map(|one| one.iter().copied().map(Vertex::input).collect()).collect()
}

pub(super) fn doubled_area(points: &[[i32; 2]], corners: &[Vertex]) -> i64 {
    let at = |i: usize| points[corners[i % corners.len()].index()].map(i64::from);
    (0..corners.len()).map(|i| at(i)[0] * at(i + 1)[1] - at(i)[1] * at(i + 1)[0]).sum()
}

/// Checks that sides balance, no triangle is negative and areas add up; returns the numbers of all triangles and of
/// triangles without area.
pub(super) fn check(points: &[[i32; 2]], loops: &Loops, found: &Triangulation) -> (usize, usize) {
    assert_eq!(found.broken, None, "{points:?} {loops:?}");
    let mut sides: BTreeMap<[Vertex; 2], i64> = BTreeMap::new();
    let mut add = |corners: &[Vertex], sign: i64| {
        for at in 0..corners.len() {
            let [a, b] = [corners[at], corners[(at + 1) % corners.len()]];
            *sides.entry([a.min(b), a.max(b)]).or_default() += if a < b { sign } else { -sign };
        }
    };
    found.triangles.iter().for_each(|triangle| add(triangle, 1));
    loops.iter().for_each(|one| add(one, -1));
    assert!(sides.values().all(|sum| *sum == 0), "{loops:?} {:?}", found.triangles);
    let areas: Vec<i64> = found.triangles.iter().map(|triangle| doubled_area(points, triangle)).collect();
    assert!(areas.iter().all(|area| *area >= 0), "{points:?} {loops:?} {:?}", found.triangles);
    let whole: i64 = loops.iter().map(|one| doubled_area(points, one)).sum();
    assert_eq!(areas.iter().sum::<i64>(), whole, "{points:?} {loops:?} {:?}", found.triangles);
    (areas.len(), areas.iter().filter(|area| **area == 0).count())
}

/// Triangulates by both methods, exactly and perturbed; returns the exact numbers of all triangles and of triangles
/// without area.
fn both(points: &[[i32; 2]], loops: &Loops, is_simple: bool) -> [(usize, usize); 2] {
    let scene = scene(points);
    let exact = Exact.prepare(&scene, Off).unwrap();
    let sos = Sos::default();
    let sos = sos.prepare(&scene, Off).unwrap();
    METHODS.map(|method| {
        let found = check(points, loops, &triangulate(&exact, Plane::Xy, false, loops, method));
        if is_simple {
            let perturbed = check(points, loops, &triangulate(&sos, Plane::Xy, false, loops, method));
            assert_eq!(perturbed.0, found.0);
        }
        found
    })
}

#[test]
fn vertices_in_line_make_no_flat_triangle() {
    // A square with vertices in the middle of its sides, two on one side.
    let points = [[0, 0], [1, 0], [2, 0], [3, 0], [3, 3], [2, 3], [0, 3], [0, 1]];
    assert_eq!(both(&points, &loops(&[&[0, 1, 2, 3, 4, 5, 6, 7]]), true), [(6, 0); 2]);
    // A triangle with all vertices but one on one line.
    let points = [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [1, 1]];
    assert_eq!(both(&points, &loops(&[&[0, 1, 2, 3, 4, 5]]), true), [(4, 0); 2]);
    // A comb with its teeth in line.
    let points = [[0, 0], [8, 0], [8, 2], [7, 2], [6, 1], [5, 2], [4, 2], [3, 1], [2, 2], [1, 2], [0, 2]];
    assert_eq!(both(&points, &loops(&[&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10]]), true), [(9, 0); 2]);
}

#[test]
fn holes_and_islands() {
    let points = [
        [0, 0],
        [9, 0],
        [9, 9],
        [0, 9], // outside
        [1, 1],
        [8, 1],
        [8, 8],
        [1, 8], // a hole
        [2, 2],
        [7, 2],
        [7, 7],
        [2, 7], // an island
        [3, 3],
        [4, 3],
        [4, 4],
        [3, 4], // two holes in it
        [5, 5],
        [6, 5],
        [6, 6],
        [5, 6],
    ];
    let all = loops(&[&[0, 1, 2, 3], &[7, 6, 5, 4], &[8, 9, 10, 11], &[15, 14, 13, 12], &[19, 18, 17, 16]]);
    // n + 2h - 2c
    assert_eq!(both(&points, &all, true), [(20 + 6 - 4, 0); 2]);
    // Nesting orients loops of any direction.
    let scene = scene(&points);
    let session = Exact.prepare(&scene, Off).unwrap();
    for turned in 0..32 {
        let mut loops = all.clone();
        loops.iter_mut().enumerate().filter(|(at, _)| turned >> at & 1 == 1).for_each(|(_, one)| one.reverse());
        loops.reverse();
        let found = oriented(&session, Plane::Xy, false, &loops);
        for (one, right) in found.iter().rev().zip(&all) {
            assert_eq!(doubled_area(&points, one), doubled_area(&points, right));
        }
    }
}

#[test]
fn loops_that_touch_in_vertices() {
    // A hole that touches the outer loop in a vertex: the same vertex, and a different vertex at the same position.
    let points = [[0, 0], [6, 0], [6, 6], [0, 6], [2, 1], [1, 2], [0, 0]];
    assert_eq!(both(&points, &loops(&[&[0, 1, 2, 3], &[0, 5, 4]]), true), [(5, 0); 2]);
    let found = both(&points, &loops(&[&[0, 1, 2, 3], &[6, 5, 4]]), false);
    assert_eq!(found, [(7, 2); 2], "n + 2h - 2, two of them at the edge without length");
    // Two outer loops with a vertex in common, and one loop in the shape of a bow tie.
    let points = [[0, 0], [2, 0], [1, 1], [2, 2], [0, 2]];
    assert_eq!(both(&points, &loops(&[&[0, 1, 2], &[2, 3, 4]]), true), [(2, 0); 2]);
    assert_eq!(both(&points, &loops(&[&[0, 1, 2, 3, 4, 2]]), true), [(2, 0); 2]);
    // Three holes around one vertex.
    let points = [[-9, -9], [9, -9], [9, 9], [-9, 9], [0, 0], [3, 1], [3, 2], [-2, 3], [-3, 3], [-1, -4], [1, -4]];
    let three = loops(&[&[0, 1, 2, 3], &[4, 6, 5], &[4, 8, 7], &[4, 10, 9]]);
    assert_eq!(both(&points, &three, true), [(13 + 6 - 2 - 4, 0); 2]);
    let mut apart = points.to_vec();
    apart.extend([[0, 0], [0, 0]]);
    let three = loops(&[&[0, 1, 2, 3], &[4, 6, 5], &[11, 8, 7], &[12, 10, 9]]);
    assert_eq!(both(&apart, &three, false).map(|found| found.0), [13 + 6 - 2; 2]);
}

#[test]
fn vertices_on_edges_and_repeats() {
    // Four holes with a vertex on an edge: the lower, the upper, the left and the right edge.
    let points = [
        [0, 0],
        [12, 0],
        [12, 12],
        [0, 12],
        [3, 0],
        [4, 2],
        [2, 2],
        [6, 12],
        [5, 9],
        [7, 9],
        [0, 6],
        [2, 5],
        [2, 7],
        [12, 6],
        [10, 7],
        [10, 5],
    ];
    let all = loops(&[&[0, 1, 2, 3], &[4, 6, 5], &[7, 9, 8], &[10, 12, 11], &[13, 15, 14]]);
    let found = both(&points, &all, false);
    assert_eq!(found, [(16 + 8 - 2, 4); 2]);
    // Repeated vertices in a row.
    let points = [[0, 0], [0, 0], [4, 0], [4, 4], [4, 4], [4, 4], [0, 4]];
    assert_eq!(both(&points, &loops(&[&[0, 1, 2, 3, 4, 5, 6]]), false), [(5, 3); 2]);
}

#[test]
fn adjacent_loops_keep_their_common_edge() {
    let points = [[0, 0], [2, 0], [4, 0], [4, 3], [2, 3], [0, 3], [2, 1]];
    let both_sides = loops(&[&[0, 1, 6, 4, 5], &[1, 2, 3, 4, 6]]);
    assert_eq!(both(&points, &both_sides, true), [(6, 0); 2]);
}

/// Constructs the corners of the loops as intersections of vertical lines with a plane, in a session.
fn cut<P: Predicates>(session: &mut P, loops: &[Vec<[i32; 2]>], scene: &Scene) -> Loops {
    let plane = [0, 1, 2].map(|back| Vertex::input(scene.len() - 1 - back));
    let mut at = 0;
    let mut corner = |_: &[i32; 2]| {
        at += 2;
        Construction::Lpi { line: [at - 2, at - 1].map(Vertex::input), plane }
    };
    let definitions: Vec<Construction> = loops.iter().flatten().map(&mut corner).collect();
    let mut vertices = session.construct(&definitions).unwrap().into_iter();
    loops.iter().map(|one| vertices.by_ref().take(one.len()).collect()).collect()
}

#[test]
fn constructed_vertices_and_planes_seen_from_behind() {
    // A square with vertices in line and a square hole, in the plane z = 3x − y + 1/2.
    let loops = vec![
        vec![[0, 0], [3, 0], [6, 0], [6, 6], [3, 6], [0, 6], [0, 3]],
        vec![[2, 2], [2, 3], [2, 4], [4, 4], [4, 2]],
    ];
    let mut points: Vec<[f64; 3]> = Vec::new();
    for [x, y] in loops.iter().flatten().map(|corner| corner.map(f64::from)) {
        points.extend([[x, y, -100.0], [x, y, 100.0]]);
    }
    points.extend([[0.0, 0.0, 0.5], [1.0, 0.0, 3.5], [0.0, 1.0, -0.5]]);
    let scene = Scene::from_points3(&points).unwrap();
    let mut exact = Exact.prepare(&scene, Off).unwrap();
    let of_exact = cut(&mut exact, &loops, &scene);
    assert_eq!(projection(&exact, &of_exact), Some((Plane::Xy, false)));
    let backwards: Loops = of_exact.iter().map(|one| one.iter().rev().copied().collect()).collect();
    assert_eq!(projection(&exact, &backwards), Some((Plane::Xy, true)));
    let sos = Sos::default();
    let mut sos = sos.prepare(&scene, Off).unwrap();
    let of_sos = cut(&mut sos, &loops, &scene);
    assert_eq!(of_sos, of_exact, "ids go by definitions");
    for method in METHODS {
        for (loops, reversed) in [(&of_exact, false), (&backwards, true)] {
            let found = triangulate(&exact, Plane::Xy, reversed, loops, method);
            assert_eq!((found.broken, found.triangles.len()), (None, 12 + 2 - 2));
            let wanted = if reversed { Sign::Negative } else { Sign::Positive };
            assert!(found.triangles.iter().all(|&[a, b, c]| exact.orient2d(Plane::Xy, a, b, c) == wanted));
        }
        let found = triangulate(&sos, Plane::Xy, false, &of_sos, method);
        assert_eq!((found.broken, found.triangles.len()), (None, 12));
        assert!(found.triangles.iter().all(|&[a, b, c]| exact.orient2d(Plane::Xy, a, b, c) != Sign::Negative));
    }
}

/// Distinct points in angular order around a centre; the loop is simple.
fn star(points: &[[i32; 2]]) -> Option<Vec<[i32; 2]>> {
    let half = |&[x, y]: &[i32; 2]| u8::from(y < 0 || y == 0 && x < 0);
    let cross = |p: &[i32; 2], q: &[i32; 2]| p[0] * q[1] - p[1] * q[0];
    let mut around: Vec<[i32; 2]> = points.iter().copied().filter(|p| *p != [0, 0]).collect();
    around.sort_by(|p, q| half(p).cmp(&half(q)).then(0.cmp(&cross(p, q))));
    around.dedup_by(|p, q| half(p) == half(q) && cross(p, q) == 0);
    let is_around = (0..around.len()).all(|at| cross(&around[at], &around[(at + 1) % around.len()]) > 0);
    (is_around && around.len() >= 3).then_some(around)
}

/// Tests loops with every kind of corner: each answer is right, and for a convex loop it equals the answer with a mesh
/// and an order.
#[test]
fn short_loops_need_no_order() {
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let (mut convex, mut same, mut others, mut in_line) = (0, 0, 0, 0);
    for case in 0..predicament_effort::scaled(6_000) {
        let most = [3, 8, 40][case % 3];
        let points = prop::collection::vec([-most..=most, -most..=most], 4..20);
        let Some(points) = star(&points.new_tree(&mut runner).unwrap().current()) else { continue };
        let (scene, count) = (scene(&points), points.len());
        let exact = Exact.prepare(&scene, Off).unwrap();
        let loops = vec![(case % count..count).chain(0..case % count).map(Vertex::input).collect::<Vec<_>>()];
        let found = triangulate(&exact, Plane::Xy, false, &loops, Method::Ears);
        let turn = |at: usize| {
            let [a, b, c] = [0, 1, 2].map(|by| loops[0][(at + by) % count]);
            exact.orient2d(Plane::Xy, a, b, c)
        };
        let is_convex = (0..count).all(|at| turn(at) == Sign::Positive);
        let few = triangulate_few(&exact, Plane::Xy, false, &loops[0], |_, _, _| true, |_| false);
        let backwards: Vec<Vertex> = loops[0].iter().rev().copied().collect();
        let reversed = triangulate_few(&exact, Plane::Xy, true, &backwards, |_, _, _| true, |_| false);
        assert_eq!(reversed.map(|made| made.len()), Some(count - 2));
        if is_convex {
            assert_eq!(few.as_ref(), Some(&found.triangles));
            convex += 1;
        }
        // If `in_line` does not know three vertices in line, the function returns `None`.
        let unknown = triangulate_few(&exact, Plane::Xy, false, &loops[0], |_, _, _| false, |_| false);
        assert!(unknown.is_none() || unknown == few);
        assert!(unknown.is_none() || (0..count).all(|at| !turn(at).is_zero()));
        in_line += usize::from(unknown.is_none());
        // A vertex is on the boundary of the convex hull if all others are on one side of a line through it.
        let is_outer = |v: Vertex| {
            loops[0]
                .iter()
                .any(|&w| v != w && loops[0].iter().all(|&x| exact.orient2d(Plane::Xy, v, w, x) != Sign::Negative))
        };
        let are_in_line = |a, b, c| exact.orient2d(Plane::Xy, a, b, c).is_zero();
        let known = triangulate_few(&exact, Plane::Xy, false, &loops[0], are_in_line, is_outer);
        assert_eq!(known, few);
        let triangles = few.expect("a star has an ear");
        if triangles == found.triangles {
            same += 1
        } else {
            others += 1
        }
        let (_, flat) = check(&points, &loops, &Triangulation { triangles, broken: None });
        assert_eq!(flat, 0);
    }
    assert!(convex > 10 && in_line > 10 && same > 10 * others, "{convex} {in_line} {same} {others}");
}

#[test]
fn short_loops_that_are_none_are_left_to_others() {
    let square = [[0, 0], [2, 0], [2, 2], [0, 2], [2, 0]];
    let scene = scene(&square);
    let exact = Exact.prepare(&scene, Off).unwrap();
    let few = |of: &[usize]| {
        let vertices: Vec<Vertex> = of.iter().copied().map(Vertex::input).collect();
        triangulate_few(&exact, Plane::Xy, false, &vertices, |_, _, _| false, |_| false)
    };
    assert_eq!(few(&[0, 1, 2, 3]).map(|made| made.len()), Some(2));
    assert_eq!(few(&[3, 2, 1, 0]), None, "no corner is an ear");
    assert_eq!(few(&[0, 1]), None);
    assert_eq!(few(&[0, 1, 2, 1]), None, "a vertex comes twice");
    assert_eq!(few(&[0, 1, 4, 2, 3]), None, "two vertices at one place");
    assert_eq!(few(&(0..=MOST).collect::<Vec<_>>()), None, "too many");
}

/// A session whose signs come from a hash of the question.
struct Dice<'s> {
    scene: &'s Scene,
    seed: u64,
    /// The number of right answers out of every eight.
    right: u64,
}

impl Dice<'_> {
    fn roll(&self, question: u64, vertices: &[Vertex], truth: f64) -> Sign {
        let mut x = self.seed ^ question;
        for v in vertices {
            x = (x ^ v.index() as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            x ^= x >> 29;
        }
        if x & 7 < self.right {
            Sign::of(truth)
        } else {
            [Sign::Negative, Sign::Zero, Sign::Positive][(x >> 8) as usize % 3]
        }
    }
}

impl Predicates for Dice<'_> {
    fn scene(&self) -> &Scene {
        self.scene
    }

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        let truth = self.scene.coordinate(axis, a) - self.scene.coordinate(axis, b);
        self.roll(axis.index() as u64, &[a, b], truth)
    }

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        let [a2, b2, c2] = [a, b, c].map(|v| self.scene.point2(plane, v));
        let truth = (a2[0] - c2[0]) * (b2[1] - c2[1]) - (a2[1] - c2[1]) * (b2[0] - c2[0]);
        self.roll(3, &[a, b, c], truth)
    }

    fn orient3d(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("not asked")
    }

    fn incircle(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("not asked")
    }

    fn insphere(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("not asked")
    }

    fn supports_contacts(&self) -> Result<(), Declined> {
        Ok(())
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn whatever_signs_are_the_sweep_ends(
        points in prop::collection::vec([-6..6_i32, -6..6], 3..24),
        picks in prop::collection::vec(prop::collection::vec(0..24_usize, 0..9), 1..5),
        seed: u64,
        right in 0..8_u64,
    ) {
        let scene = scene(&points);
        let pick = |one: &Vec<usize>| one.iter().map(|at| Vertex::input(at % points.len())).collect();
        let loops: Loops = picks.iter().map(pick).collect();
        let session = Dice { scene: &scene, seed, right };
        let turned = oriented(&session, Plane::Xy, false, &loops);
        prop_assert_eq!(turned.len(), loops.len());
        let corners: usize = loops.iter().map(Vec::len).sum();
        for method in METHODS {
            for reversed in [false, true] {
                let found = triangulate(&session, Plane::Xy, reversed, &turned, method);
                prop_assert!(found.triangles.len() <= 3 * corners, "{} of {corners}", found.triangles.len());
            }
        }
        projection(&session, &loops);
    }

    /// Tests loops without shared vertices: under the sweep, sides balance whatever the signs are.
    #[test]
    fn whatever_signs_are_the_sweep_closes(
        points in prop::collection::vec([-50..50_i32, -50..50], 3..40),
        cuts in prop::collection::vec(3..9_usize, 1..6),
        seed: u64,
        right in 0..8_u64,
    ) {
        let scene = scene(&points);
        let mut rest: Vec<Vertex> = scene.vertices().collect();
        let mut loops = Loops::new();
        for cut in cuts {
            if rest.len() >= cut {
                let tail = rest.split_off(cut);
                loops.push(std::mem::replace(&mut rest, tail));
            }
        }
        let session = Dice { scene: &scene, seed, right };
        let found = triangulate(&session, Plane::Xy, false, &loops, Method::Monotone);
        let mut sides: BTreeMap<[Vertex; 2], i64> = BTreeMap::new();
        let mut add = |corners: &[Vertex], sign: i64| for at in 0..corners.len() {
            let [a, b] = [corners[at], corners[(at + 1) % corners.len()]];
            *sides.entry([a.min(b), a.max(b)]).or_default() += if a < b { sign } else { -sign };
        };
        found.triangles.iter().for_each(|triangle| add(triangle, 1));
        loops.iter().for_each(|one| add(one, -1));
        prop_assert!(sides.values().all(|sum| *sum == 0));
    }
}
