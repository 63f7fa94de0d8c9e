//! Tests of meshes that cross themselves, against volumes and winding numbers from other sources, and with all pairs of
//! triangles in rationals.

use std::collections::{BTreeMap, BTreeSet};

use predicament_exact::Exact;
use predicament_judge::solids::Boundary;
use predicament_judge::{Points, rational};
use predicament_mesh_intersect::algorithm::resolve::{Counts, PASSES, resolved, rounded};
use predicament_mesh_intersect::algorithm::rounding::Closed;
use predicament_predicates::{Construction, Vertex};
use rug::Rational;

use crate::common::shapes::{Random, Shape};
use crate::common::touching::improper;
use crate::common::volumes::{Point, area, volume};

fn closed(shape: &Shape) -> Closed {
    let triangles = shape.triangles.iter().map(|triangle| triangle.map(|v| u32::try_from(v).unwrap()));
    Closed { points: shape.points.clone(), triangles: triangles.collect() }
}

/// Several solids as one mesh.
fn heap(shapes: &[Shape]) -> Closed {
    closed(&shapes.iter().fold(Shape::default(), |all, shape| all.and(shape)))
}

/// A tetrahedron, counterclockwise as seen from outside; `None` if it has no volume.
fn tetrahedron(points: [[f64; 3]; 4]) -> Option<Shape> {
    let shape = Shape::solid(points.to_vec(), vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    match volume(&surface(&closed(&shape))).cmp0() {
        std::cmp::Ordering::Less => Some(shape.inverted()),
        std::cmp::Ordering::Equal => None,
        std::cmp::Ordering::Greater => Some(shape),
    }
}

/// The triangles of a mesh of doubles.
fn surface(mesh: &Closed) -> Vec<[Point; 3]> {
    mesh.triangles.iter().map(|triangle| triangle.map(|v| mesh.points[v as usize].map(rational))).collect()
}

/// A resolution in rationals.
struct Found {
    surface: Vec<[Point; 3]>,
    counts: Counts,
    /// The positions of the result's vertices where three planes meet.
    corners: BTreeSet<Point>,
}

fn resolve(mesh: &Closed) -> Result<Found, String> {
    let resolved = resolved(&Exact, mesh).map_err(|why| why.to_string())?;
    let mut points = Points::of(&resolved.scene);
    let mut places: BTreeMap<Vertex, Point> = BTreeMap::new();
    let mut corners = BTreeSet::new();
    for &v in resolved.triangles.as_flattened() {
        places.entry(v).or_insert_with(|| {
            let definition = resolved.scene.construction(v).copied();
            let known = definition.map_or(v, |definition| points.construct(&[definition]).unwrap()[0]);
            let point = <[Rational; 3]>::try_from(points.point(known).unwrap().into_owned()).unwrap();
            if matches!(definition, Some(Construction::Tpi(_))) {
                corners.insert(point.clone());
            }
            point
        });
    }
    let surface = resolved.triangles.iter().map(|triangle| triangle.map(|v| places[&v].clone())).collect();
    Ok(Found { surface, counts: resolved.counts, corners })
}

/// The flaw of a surface: without area, open, or crossing itself.
fn flaw(surface: &[[Point; 3]]) -> Option<String> {
    if surface.iter().any(|triangle| area(triangle).iter().all(|x| x.cmp0().is_eq())) {
        return Some("a triangle has no area".to_owned());
    }
    let mut edges: BTreeMap<[&Point; 2], i32> = BTreeMap::new();
    for [a, b, c] in surface {
        for [a, b] in [[a, b], [b, c], [c, a]] {
            *edges.entry(if a < b { [a, b] } else { [b, a] }).or_default() += if a < b { 1 } else { -1 };
        }
    }
    if edges.values().any(|uses| *uses != 0) {
        return Some("an open edge".to_owned());
    }
    improper(surface).first().map(|pair| format!("triangles {pair:?} meet"))
}

/// The flaw of the resolution of a mesh whose inside has the volume `wanted`.
fn wrong(mesh: &Closed, wanted: &Rational) -> Option<String> {
    let found = match resolve(mesh) {
        Ok(found) => found,
        Err(why) => return Some(why),
    };
    let own = volume(&found.surface);
    flaw(&found.surface).or_else(|| (own != *wanted).then(|| format!("the volume is {own}, not {wanted}")))
}

fn right(mesh: &Closed, wanted: impl Into<Rational>) -> Found {
    assert_eq!(wrong(mesh, &wanted.into()), None);
    resolve(mesh).unwrap()
}

#[test]
fn two_boxes_are_their_union() {
    let first = Shape::cuboid([0.0; 3], [4.0; 3]);
    let second = Shape::cuboid([1.0, 2.0, 3.0], [7.0, 8.0, 9.0]);
    let found = right(&heap(&[first.clone(), second]), 64 + 216 - 3 * 2);
    assert!(found.counts.cut > 0 && found.counts.dropped > 0, "{:?}", found.counts);
    // Nested or separate boxes are not cut.
    let inner = Shape::cuboid([1.0; 3], [2.0; 3]);
    let found = right(&heap(&[first.clone(), inner.clone()]), 64);
    assert_eq!((found.counts.cut, found.counts.dropped, found.surface.len()), (0, 12, 12));
    let apart = Shape::cuboid([5.0; 3], [6.0; 3]);
    assert_eq!(right(&heap(&[first.clone(), apart]), 65).counts.cut, 0);
    // A cavity stays.
    assert_eq!(right(&heap(&[first, inner.inverted()]), 63).surface.len(), 24);
}

#[test]
fn a_mesh_twice_is_there_once() {
    let sphere = Shape::sphere(64.0, 2);
    let once = surface(&closed(&sphere));
    let found = right(&heap(&[sphere.clone(), sphere]), volume(&once));
    assert_eq!((found.counts.pairs, found.surface), (0, once));
}

#[test]
fn three_planes_meet_in_a_corner() {
    let slabs = [[1.0, 9.0, 9.0], [9.0, 3.0, 9.0], [9.0, 9.0, 5.0]].map(|high| Shape::cuboid([0.0; 3], high));
    // Apart, so that no face lies on another.
    let slabs: Vec<Shape> = slabs.into_iter().zip([0.0, 1.0, 2.0]).map(|(slab, by)| slab.moved([-by; 3])).collect();
    let inside = |x: i32, y: i32, z: i32| {
        let low = |by: i32, wide: [i32; 3]| [x, y, z].iter().zip(wide).all(|(&x, wide)| -by <= x && x < wide - by);
        low(0, [1, 9, 9]) || low(1, [9, 3, 9]) || low(2, [9, 9, 5])
    };
    let range = || -2..9;
    let all = range().flat_map(|x| range().flat_map(move |y| range().map(move |z| (x, y, z))));
    let cells = all.filter(|&(x, y, z)| inside(x, y, z)).count();
    let found = right(&heap(&slabs), cells);
    assert!(found.corners.contains(&[1, 2, 3].map(Rational::from)), "{:?}", found.corners);
}

#[test]
fn faces_of_one_plane_are_cut_together() {
    let base = Shape::cuboid([0.0; 3], [6.0, 6.0, 2.0]);
    let second = Shape::cuboid([2.0, 2.0, 0.0], [9.0, 5.0, 2.0]);
    right(&heap(&[base.clone(), second]), 72 + 18);
    let on_top = Shape::cuboid([1.0, 1.0, 2.0], [3.0, 4.0, 3.0]);
    right(&heap(&[base.clone(), on_top]), 72 + 6);
    // A part that is turned inside out is subtracted inside another part, and has no effect elsewhere.
    let hole = Shape::cuboid([1.0, 1.0, -3.0], [3.0, 4.0, 2.0]).inverted();
    right(&heap(&[base, hole]), 72 - 12);
}

#[test]
fn folds_and_what_is_inside_out_vanish() {
    let points = [[0.0, 0.0, 0.0], [6.0, 0.0, 0.0], [0.0, 6.0, 0.0], [1.0, 1.0, 6.0]];
    let whole = tetrahedron(points).unwrap();
    right(&closed(&whole), 36);
    assert!(right(&closed(&whole.clone().inverted()), 0).surface.is_empty());
    // A face is replaced by three triangles to a point of its plane beside it: two of them lie on the third, and on
    // each other.
    let mut folded = closed(&whole);
    folded.points.push([7.0, 5.0, 0.0]);
    let [a, b, c] = folded.triangles.remove(0);
    folded.triangles.extend([[a, b, 4], [b, c, 4], [c, a, 4]]);
    let found = right(&folded, 36);
    assert!(found.counts.pairs > 0);
    let flat: Rational = found.surface.iter().map(|triangle| area(triangle)[2].clone().abs() / 2u32).sum();
    assert_eq!(flat, 36, "the base of 18, seen from both sides");
    // Two tetrahedra at one corner, one of them inside out.
    let other = tetrahedron(points.map(|p| p.map(|x| -x))).unwrap();
    right(&heap(&[whole.clone(), other.clone()]), 72);
    right(&heap(&[whole, other.inverted()]), 36);
}

#[test]
fn corners_that_touch_a_face_are_joined() {
    let base = Shape::cuboid([0.0; 3], [8.0, 8.0, 2.0]);
    let spike = |x: f64, y: f64| {
        tetrahedron([[x, y, 2.0], [x + 1.0, y, 5.0], [x, y + 1.0, 5.0], [x - 1.0, y - 1.0, 5.0]]).unwrap()
    };
    // In a triangle, on a diagonal, on an edge.
    let own = volume(&surface(&closed(&spike(0.0, 0.0))));
    let found = right(&heap(&[base, spike(5.0, 2.0), spike(3.0, 3.0), spike(8.0, 4.0)]), own * 3 + 128);
    assert!(found.counts.cut > 0);
}

#[test]
fn a_mesh_that_is_open_is_refused() {
    let mut mesh = closed(&Shape::cuboid([0.0; 3], [1.0; 3]));
    mesh.triangles.pop();
    assert!(resolve(&mesh).is_err());
    assert!(resolve(&Closed::default()).unwrap().surface.is_empty());
}

/// Boxes of a small lattice, some of them inside out, and the number of cells with more normal boxes than reversed
/// ones.
fn boxes(seed: u64) -> (Closed, usize) {
    let mut random = Random(seed);
    let mut cells: BTreeMap<[i32; 3], i32> = BTreeMap::new();
    let mut shapes = Vec::new();
    for _ in 0..2 + random.below(4) {
        let low = [(); 3].map(|()| i32::try_from(random.below(4)).unwrap());
        let high = low.map(|x| x + 1 + i32::try_from(random.below(3)).unwrap());
        let is_out = random.below(4) > 0;
        let shape = Shape::cuboid(low.map(f64::from), high.map(f64::from));
        shapes.push(if is_out { shape } else { shape.inverted() });
        for x in low[0]..high[0] {
            for y in low[1]..high[1] {
                for z in low[2]..high[2] {
                    *cells.entry([x, y, z]).or_default() += if is_out { 1 } else { -1 };
                }
            }
        }
    }
    (heap(&shapes), cells.values().filter(|times| **times > 0).count())
}

fn flaws_of_boxes(cases: u64) -> Vec<String> {
    let flaw = |seed: u64| {
        let (mesh, cells) = boxes(seed);
        wrong(&mesh, &Rational::from(cells)).map(|why| format!("{seed}: {why}"))
    };
    (1..=cases).filter_map(flaw).collect()
}

#[test]
fn boxes_are_their_cells() {
    let flaws = flaws_of_boxes(predicament_effort::cases(400).into());
    assert!(flaws.is_empty(), "{} flaws, first: {}", flaws.len(), flaws[0]);
}

/// Tetrahedra of integer or other coordinates, some of them inside out.
fn soup(seed: u64, point: &dyn Fn(&mut Random) -> [f64; 3]) -> Closed {
    let mut random = Random(seed);
    let mut shapes = Vec::new();
    for _ in 0..2 + random.below(5) {
        let points = [(); 4].map(|()| point(&mut random));
        let is_out = random.below(4) > 0;
        shapes.extend(tetrahedron(points).map(|shape| if is_out { shape } else { shape.inverted() }));
    }
    heap(&shapes)
}

/// The points with a wrong winding number in a surface, and the number of points tested.
fn misplaced(mesh: &Closed, surface: Vec<[Point; 3]>, random: &mut Random, reach: f64) -> [usize; 2] {
    let [before, after] = [self::surface(mesh), surface].map(|surface| {
        let corners = (0..).step_by(3).take(surface.len()).map(|first| [first, first + 1, first + 2]).collect();
        Boundary::new(surface.into_flattened(), corners)
    });
    let mut counts = [0; 2];
    for _ in 0..40 {
        let q = [(); 3].map(|()| random.whole(1 << 20) / f64::from(1 << 20) * reach);
        if let (Some(before), Some(after)) = (before.winding(q), after.winding(q)) {
            counts[1] += 1;
            counts[0] += usize::from(after != i64::from(before > 0));
        }
    }
    counts
}

#[test]
fn soups_are_where_they_go_around() {
    let mut looked_at = 0;
    for seed in 1..=u64::from(predicament_effort::cases(400)) {
        let mesh = soup(seed, &|random| random.point(4));
        let found = resolve(&mesh).unwrap_or_else(|why| panic!("{seed}: {why}"));
        assert_eq!(flaw(&found.surface), None, "{seed}");
        let [wrong, all] = misplaced(&mesh, found.surface, &mut Random(seed), 4.0);
        assert_eq!(wrong, 0, "{seed}");
        looked_at += all;
    }
    assert!(looked_at > 100, "{looked_at}");
}

#[test]
fn soups_are_rounded() {
    let (mut most, mut moved) = (0, 0.0_f64);
    for seed in 1..=u64::from(predicament_effort::cases(400)) {
        let mesh = soup(seed, &|random| random.point(1 << 16).map(|x| x / 3.0));
        let (closed, counts) = rounded(&Exact, &mesh).unwrap_or_else(|why| panic!("{seed}: {why}"));
        assert_eq!(counts.left, 0, "{seed}: {counts:?}");
        assert_eq!(closed.check(), Ok(()), "{seed}");
        let surface = surface(&closed);
        assert_eq!(flaw(&surface), None, "{seed}");
        assert_eq!(misplaced(&mesh, surface, &mut Random(seed), f64::from(1 << 16) / 3.0)[0], 0, "{seed}");
        (most, moved) = (most.max(counts.passes), moved.max(counts.farthest));
    }
    assert!(most <= PASSES && moved > 0.0 && moved < 1e-9, "{most} {moved}");
}
