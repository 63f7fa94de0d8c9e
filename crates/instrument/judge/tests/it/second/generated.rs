//! The second judge on generated queries, on points in maps by winding, and on hulls in space by every simplex.

use predicament_families as families;
use predicament_judge::locate::{Location, locate};
use predicament_predicates::PredicateKind;

use super::*;
use crate::random::{Grid, Random, Regions, effort, map};

/// A generator of single queries.
type Family = fn(PredicateKind, &mut families::Random, &mut Vec<f64>);

/// All generators of single queries.
const FAMILIES: [(&str, Family); 8] = [
    ("uniform", families::uniform),
    ("grid", families::grid),
    ("near", |kind, rng, out| families::near(kind, 4, rng, out)),
    ("kettner", families::kettner),
    ("degenerate", families::degenerate),
    ("wide, scaled", families::wide_scaled),
    ("wide, mixed", families::wide_mixed),
    ("far", families::far),
];

/// Generated queries of each predicate, and how many signs are zero and how many differ, if the second judge reads
/// points as `read` does.
fn signs(each: usize, read: fn(&[f64]) -> Vec<f64>) -> [usize; 3] {
    let kinds = [
        (PredicateKind::Orient2d, Question::Orient2d(Plane::Xy), false),
        (PredicateKind::Orient3d, Question::Orient3d, false),
        (PredicateKind::Incircle, Question::Incircle, true),
        (PredicateKind::Insphere, Question::Insphere, true),
    ];
    let [mut asked, mut zeros, mut different] = [0; 3];
    for (name, family) in FAMILIES {
        for (kind, question, is_lifted) in kinds {
            let mut rng = families::Random::new(name, &kind.to_string(), 11);
            for _ in 0..each {
                let mut coordinates = Vec::new();
                family(kind, &mut rng, &mut coordinates);
                let dimension = families::native(kind);
                let points: Vec<Vec<f64>> = coordinates.chunks(dimension).map(read).collect();
                let space = Dimension::of(dimension).expect("two or three");
                let scene = Scene::new(space, coordinates).expect("finite");
                let args: Vec<Vertex> = (0..points.len()).map(Vertex::input).collect();
                let units = in_units(&points);
                let rows: Vec<Vec<BigInt>> =
                    if is_lifted { units.iter().map(|point| lifted(point)).collect() } else { units };
                let second = volume(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>());
                asked += 1;
                zeros += usize::from(second.sign() == Side::NoSign);
                different += usize::from(sign(&scene, question, &args) != of(&second));
            }
        }
    }
    [asked, zeros, different]
}

#[test]
fn both_judges_agree_on_generated_queries() {
    let [asked, zeros, different] = signs(predicament_effort::scaled(4000), <[f64]>::to_vec);
    println!("{asked} generated signs, {zeros} of them zero, {different} different");
    assert_eq!(different, 0, "of {asked}");
    assert!(asked >= 6400 && zeros > asked / 20, "{asked} signs, {zeros} zero");
    // A planted fault: the second judge loses the last bit of each coordinate.
    let [asked, _, different] = signs(20, |point| point.iter().map(|x| f64::from_bits(x.to_bits() & !1)).collect());
    println!("without the last bit, {different} of {asked} are different");
    assert!(different > 0, "without the last bit");
}

/// The quadrant of a point around a probe; `None` at the probe itself.
fn quadrant(point: &[BigInt], probe: &[BigInt]) -> Option<i32> {
    let [x, y] = [0, 1].map(|axis| of(&(&point[axis] - &probe[axis])));
    match (x, y) {
        (Sign::Zero, Sign::Zero) => None,
        (Sign::Positive, Sign::Zero | Sign::Positive) => Some(0),
        (Sign::Zero | Sign::Negative, Sign::Positive) => Some(1),
        (Sign::Negative, Sign::Zero | Sign::Negative) => Some(2),
        (Sign::Zero | Sign::Positive, Sign::Negative) => Some(3),
    }
}

/// Quarter turns of an edge around a probe; `None` if the probe is on the edge.
fn turns([a, b]: [&[BigInt]; 2], probe: &[BigInt]) -> Option<i32> {
    let side = of(&area([a, b, probe]));
    Some(match (quadrant(b, probe)? - quadrant(a, probe)?).rem_euclid(4) {
        0 => 0,
        1 => 1,
        3 => -1,
        _ => match side {
            Sign::Positive => 2,
            Sign::Negative => -2,
            Sign::Zero => return None,
        },
    })
}

/// The location of a probe by the winding numbers of the rings; `None` if it is on an edge that bounds nothing.
fn by_winding(units: &[Vec<BigInt>], regions: &Regions, probe: usize) -> Option<Location> {
    let mut found = Location::default();
    for (region, rings) in (0..).zip(regions) {
        let edges: Vec<[usize; 2]> = rings
            .iter()
            .flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)))
            .map(|(u, v)| [u, v].map(|v| v.index()))
            .collect();
        let of_edge = |&[u, v]: &[usize; 2]| turns([&units[u], &units[v]], &units[probe]);
        let is_odd = |edge: &[usize; 2]| {
            let same = |&&[u, v]: &&[usize; 2]| [u, v] == *edge || [v, u] == *edge;
            !edges.iter().filter(same).count().is_multiple_of(2)
        };
        let on: Vec<&[usize; 2]> = edges.iter().filter(|edge| of_edge(edge).is_none()).collect();
        if on.iter().any(|edge| is_odd(edge)) {
            found.boundary.push(region);
        } else if on.is_empty() {
            let quarters: i32 = edges.iter().filter_map(of_edge).sum();
            if quarters / 4 % 2 != 0 {
                found.inside.push(region);
            }
        } else {
            return None;
        }
    }
    Some(found)
}

/// Probes in random maps, and how many places differ if the first ring of each map is forgotten by the second judge.
fn compared(forget: bool) -> [usize; 3] {
    let mut random = Random::new(5);
    let (mut asked, mut bounded, mut different) = (0, 0, 0);
    for at in 0..60 * effort() {
        let (scene, regions, _) = map(&mut random, [Grid::Whole, Grid::Fine, Grid::Wide][at % 3]);
        let points: Vec<Vec<f64>> = scene.coordinates().chunks(2).map(<[f64]>::to_vec).collect();
        let units = in_units(&points);
        let mut known = regions.clone();
        if forget {
            known[0].remove(0);
        }
        let probes: Vec<Vertex> = scene.vertices().collect();
        for (probe, first) in locate(&scene, &regions, &probes).into_iter().enumerate() {
            let Some(second) = by_winding(&units, &known, probe) else { continue };
            asked += 1;
            bounded += usize::from(!second.boundary.is_empty());
            different += usize::from(first != second);
        }
    }
    [asked, bounded, different]
}

#[test]
fn both_judges_agree_on_places_in_maps() {
    let [asked, bounded, different] = compared(false);
    println!("{asked} places, {bounded} of them on a boundary, {different} different");
    assert_eq!(different, 0, "of {asked}");
    assert!(asked > 500 && bounded > 100 && asked - bounded > 100, "{asked}, {bounded}");
    let [_, _, different] = compared(true);
    assert!(different > 10, "a ring that is forgotten: {different}");
}

/// The extreme points in space: those in no segment, triangle or tetrahedron of others (Carathéodory).
///
/// Points are all different. Without `solids` tetrahedra are left out: a planted fault.
fn extreme_in_space(points: &[&[BigInt]], solids: bool) -> Vec<usize> {
    let flat = |p: usize, [i, j]: [usize; 2]| [points[p][i].clone(), points[p][j].clone()];
    let turn = |axes: [usize; 2], [a, b, c]: [usize; 3]| {
        let [a, b, c] = [a, b, c].map(|p| flat(p, axes));
        of(&area([&a, &b, &c]))
    };
    let planes = [[0, 1], [1, 2], [2, 0]];
    let side = |corners: [usize; 4]| of(&volume(&corners.map(|at| points[at])));
    let on_segment = |p: usize, a: usize, b: usize| {
        let along = |axis: usize| (&points[p][axis] - &points[a][axis]) * (&points[b][axis] - &points[p][axis]);
        planes.iter().all(|&axes| turn(axes, [a, b, p]) == Sign::Zero)
            && (0..3).all(|axis| of(&along(axis)) != Sign::Negative)
    };
    let in_triangle = |p: usize, [a, b, c]: [usize; 3]| {
        let Some(&axes) = planes.iter().find(|&&axes| turn(axes, [a, b, c]) != Sign::Zero) else { return false };
        let whole = turn(axes, [a, b, c]);
        side([a, b, c, p]) == Sign::Zero
            && [[a, b, p], [b, c, p], [c, a, p]].iter().all(|&part| turn(axes, part) != -whole)
    };
    let in_solid = |p: usize, corners: [usize; 4]| {
        let whole = side(corners);
        whole != Sign::Zero
            && (0..4).all(|at| {
                let mut part = corners;
                part[at] = p;
                side(part) != -whole
            })
    };
    let is_extreme = |&p: &usize| {
        let others: Vec<usize> = (0..points.len()).filter(|&at| at != p).collect();
        let after = |at: usize| others.iter().copied().filter(move |&other| other > at);
        !others.iter().any(|&a| {
            after(a).any(|b| {
                on_segment(p, a, b)
                    || after(b)
                        .any(|c| in_triangle(p, [a, b, c]) || solids && after(c).any(|d| in_solid(p, [a, b, c, d])))
            })
        })
    };
    (0..points.len()).filter(is_extreme).collect()
}

/// Scenes in space of a few different points: from the corpora, and at random.
fn clouds() -> Vec<Vec<Vec<f64>>> {
    let mut random = Random::new(9);
    let drawn = (0..12 * effort()).map(|at| {
        let grid = [Grid::Whole, Grid::Fine, Grid::Wide][at % 3];
        let count = 4 + random.below(6);
        grid.coordinates(&mut random, 3 * count, 4).chunks(3).map(<[f64]>::to_vec).collect()
    });
    let embedded = scenes().into_iter().map(|(_, points)| points);
    let all = drawn.chain(embedded.filter(|points: &Vec<Vec<f64>>| {
        points[0].len() == 3 && points.len() <= predicament_effort::some_or_all(8, 12)
    }));
    let distinct = |mut points: Vec<Vec<f64>>| {
        let mut kept: Vec<Vec<f64>> = Vec::new();
        points.retain(|point| {
            let is_new = !kept.contains(point);
            kept.push(point.clone());
            is_new
        });
        points
    };
    all.map(distinct).collect()
}

#[test]
fn both_judges_agree_on_hulls_in_space() {
    let (mut hulls, mut inner, mut different) = (0, 0, 0);
    for points in clouds() {
        let scene = Scene::new(Dimension::Three, points.concat()).expect("finite");
        let first: Vec<usize> = hull::extreme(&Judged::exact(&scene)).iter().map(|v| v.index()).collect();
        let units = in_units(&points);
        let slices: Vec<&[BigInt]> = units.iter().map(Vec::as_slice).collect();
        assert_eq!(first, extreme_in_space(&slices, true), "the hull of {points:?}");
        hulls += 1;
        inner += points.len() - first.len();
        different += usize::from(first != extreme_in_space(&slices, false));
    }
    println!("{hulls} hulls with {inner} points that are not extreme; {different} hulls need a tetrahedron");
    assert!(hulls > 30 && inner > 20 && different > 0, "{hulls} hulls, {inner} inner points, {different}");
}
