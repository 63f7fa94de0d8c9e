//! The contacts driver, compared with brute force over random complexes on small grids with many degeneracies.

use crate::common::hierarchy::{Pair, brute_force};
use crate::common::whim::Whim;
use predicament_contacts::algorithm::pairs::{Contact, Contacts, contacts, contacts2d, contacts3d};
use predicament_controls::Naive;
use predicament_effort::some_or_all;
use predicament_exact::Exact;
use predicament_mesh::{Complex, Simplex, Simplices};
use predicament_predicates::{Backend, Dimension, Off, Predicates, Scene, Vertex};
use predicament_sos::{Scheme, Sos};
use predicament_tolerance::Tolerance;
use proptest::prelude::*;

fn pair([a, b]: [&Complex; 2], contact: &Contact) -> Pair {
    let on = |complex: &Complex, simplex: Simplex, weights: [f64; 4]| {
        let vertices = complex.vertices_of(simplex);
        assert!(weights[vertices.len()..].iter().all(|&w| w == 0.0));
        vertices.iter().copied().zip(weights).collect()
    };
    Pair {
        a: a.vertices_of(contact.a).to_vec(),
        b: b.vertices_of(contact.b).to_vec(),
        on_a: on(a, contact.a, contact.on_a),
        on_b: on(b, contact.b, contact.on_b),
    }
}

fn mirrored(contacts: &Contacts) -> Vec<Contact> {
    let swap = |c: &Contact| Contact { a: c.b, b: c.a, on_a: c.on_b, on_b: c.on_a };
    let mut swapped: Vec<Contact> = contacts.registered.iter().map(swap).collect();
    swapped.sort_by_key(|c| (c.a.rank + c.b.rank, c.a, c.b));
    swapped
}

fn with_threads<T: Send>(threads: usize, f: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(f)
}

/// Checks the laws of the driver that hold for any session that registers nothing beyond its reach.
fn check<S: Predicates>(session: &S, a: &Complex, b: &Complex) -> Contacts {
    let found = contacts(session, a, b);
    let (expected, counts) = brute_force(session, a, b);
    let pairs: Vec<Pair> = found.registered.iter().map(|contact| pair([a, b], contact)).collect();
    assert_eq!(pairs, expected);
    assert!(found.registered.is_sorted_by_key(|c| (c.a.rank + c.b.rank, c.a, c.b)));
    assert_eq!(found.levels.len(), counts.len());
    for (level, count) in found.levels.iter().zip(&counts) {
        assert_eq!((level.ranks, level.registered), (count.ranks, count.registered));
        assert_eq!(level.candidates, level.ended + level.asked);
        assert!(level.ended <= count.ended && level.asked <= count.asked);
    }
    let back = contacts(session, b, a);
    assert_eq!(mirrored(&back), found.registered);
    for level in &found.levels {
        let [i, j] = level.ranks;
        let other = back.levels.iter().find(|other| other.ranks == [j, i]).unwrap();
        let key = |l: &predicament_contacts::algorithm::pairs::Level| (l.candidates, l.ended, l.asked, l.registered);
        assert_eq!(key(other), key(level));
    }
    for threads in [1, 3] {
        assert_eq!(with_threads(threads, || contacts(session, a, b)), found, "{threads} threads");
    }
    found
}

/// Points on a small grid, repeated twice, and simplices by indices of points.
#[derive(Clone, Debug)]
struct Given {
    points: Vec<Vec<i8>>,
    cells: [Vec<Vec<usize>>; 2],
    /// True if the second complex uses the vertices of the first.
    shared: bool,
}

impl Given {
    fn scene(&self, dimension: Dimension) -> Scene {
        let coordinates: Vec<f64> = self.points.iter().flatten().map(|&c| f64::from(c)).collect();
        Scene::new(dimension, coordinates).unwrap()
    }

    fn complexes(&self, scene: &Scene) -> [Complex; 2] {
        let half = self.points.len() / 2;
        [0, 1].map(|which| {
            let mut given = Simplices::default();
            for cell in &self.cells[which] {
                let (from, count) = if self.shared { (0, 2 * half) } else { (which * half, half) };
                let mut vertices: Vec<Vertex> = cell.iter().map(|&i| Vertex::input(from + i % count)).collect();
                vertices.sort_unstable();
                vertices.dedup();
                match *vertices {
                    [a] => given.vertices.push(a),
                    [a, b] => given.edges.push([a, b]),
                    [a, b, c] => given.triangles.push([a, b, c]),
                    [a, b, c, d] => given.tetrahedra.push([a, b, c, d]),
                    _ => unreachable!(),
                }
            }
            Complex::new(scene, &given).unwrap()
        })
    }
}

fn given(dimension: usize, side: i8, shared: bool) -> impl Strategy<Value = Given> {
    let points = prop::collection::vec(prop::collection::vec(0..side, dimension), 2..24);
    let cells = || prop::collection::vec(prop::collection::vec(0_usize..1000, 1..dimension + 2), 0..10);
    (points, cells(), cells()).prop_map(move |(mut points, a, b)| {
        if points.len() % 2 == 1 {
            points.pop();
        }
        Given { points, cells: [a, b], shared }
    })
}

/// Checks weights of backends that use signs: they add up to one, for any signs.
fn check_weights(found: &Contacts) {
    for weights in found.registered.iter().flat_map(|c| [c.on_a, c.on_b]) {
        assert!(weights.iter().all(|w| (0.0..=1.0).contains(w)), "{weights:?}");
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-15, "{weights:?}");
    }
}

fn check_tolerance<F: predicament_tolerance::Float>(scene: &Scene, a: &Complex, b: &Complex) {
    let scene = scene.clone().with_primitive_lengths([a, b].map(|complex| complex.primitive_length(scene)));
    let backend = Tolerance::<F>::new();
    let session = backend.prepare(&scene, Off).unwrap();
    session.supports_contacts().unwrap();
    check(&session, a, b);
}

/// Checks exact, perturbed, tolerant and random answers on one scene.
fn check_all(given: &Given, dimension: Dimension) {
    let scene = given.scene(dimension);
    let [a, b] = given.complexes(&scene);
    check_weights(&check(&Exact.prepare(&scene, Off).unwrap(), &a, &b));
    check_tolerance::<f64>(&scene, &a, &b);
    check_tolerance::<f32>(&scene, &a, &b);
    for scheme in [Scheme::PerCoordinate, Scheme::EdelsbrunnerMucke] {
        let sos = Sos { scheme };
        let found = check(&sos.prepare(&scene, Off).unwrap(), &a, &b);
        check_weights(&found);
        let common = |c: &Contact| a.vertices_of(c.a).iter().any(|v| b.vertices_of(c.b).contains(v));
        let top = |c: &Contact| usize::from(c.a.rank + c.b.rank) == dimension.count();
        // a vertex meets itself, moved or not
        let itself = |c: &Contact| c.a.rank + c.b.rank == 0 && common(c);
        assert!(found.registered.iter().all(|c| top(c) || itself(c)), "{:?}", found.registered);
    }
    for reach in [0.0, 0.5, 1.0, 2.0] {
        for odds in [1, 2, 5] {
            check(&Whim { scene: &scene, reach, odds }, &a, &b);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: some_or_all(16, 96), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn in_the_plane(given in given(2, 4, false)) {
        check_all(&given, Dimension::Two);
    }

    #[test]
    fn in_space(given in given(3, 3, false)) {
        check_all(&given, Dimension::Three);
    }

    #[test]
    fn with_common_vertices(flat in given(2, 4, true), solid in given(3, 3, true)) {
        check_all(&flat, Dimension::Two);
        check_all(&solid, Dimension::Three);
    }
}

#[test]
fn more_than_one_piece_of_work() {
    let half = some_or_all(310, 620);
    let count = u32::try_from(2 * half - half / 15).unwrap();
    let points: Vec<[f64; 2]> = (0..count).map(|i| [f64::from(i % 60), f64::from(i / 60 % 7)]).collect();
    let scene = Scene::from_points2(&points).unwrap();
    let path = |from: usize, to: usize| -> Simplices {
        let edges = (from..to - 1).map(|i| [i, i + 1].map(Vertex::input)).collect();
        Simplices { edges, ..Simplices::default() }
    };
    let [a, b] = [path(0, half), path(half, points.len())].map(|given| Complex::new(&scene, &given).unwrap());
    let found = contacts2d(&Exact.prepare(&scene, Off).unwrap(), &a, &b);
    let (expected, _) = brute_force(&Exact.prepare(&scene, Off).unwrap(), &a, &b);
    assert_eq!(found.registered.iter().map(|c| pair([&a, &b], c)).collect::<Vec<_>>(), expected);
    assert_eq!(with_threads(1, || contacts2d(&Exact.prepare(&scene, Off).unwrap(), &a, &b)), found);
}

/// If all boxes overlap, there are more pairs than a piece of work keeps, and the pairs are searched again for each
/// level.
#[test]
fn more_pairs_than_are_kept() {
    const COUNT: u32 = 140;
    let side = f64::from(COUNT);
    let mut points: Vec<[f64; 2]> = Vec::new();
    for i in (0..COUNT).map(f64::from) {
        points.extend([[i, 0.0], [side - i, side]]);
    }
    for i in (0..COUNT).map(f64::from) {
        // Edges through a point of the first edges, from a point of them, or from no point of them.
        points.extend([[0.0, if i % 2.0 == 0.0 { i } else { i + 0.5 }], [side, side - i]]);
    }
    points[COUNT as usize * 2] = points[0];
    let scene = Scene::from_points2(&points).unwrap();
    let path = |from: u32, to: u32| -> Simplices {
        let ends = |i: u32| [2 * i, 2 * i + 1].map(|v| Vertex::input(v as usize));
        Simplices { edges: (from..to).map(ends).collect(), ..Simplices::default() }
    };
    let complexes = [path(0, COUNT), path(COUNT, 2 * COUNT)].map(|given| Complex::new(&scene, &given).unwrap());
    let [a, b] = &complexes;
    let found = check(&Exact.prepare(&scene, Off).unwrap(), a, b);
    let last = found.levels.iter().find(|level| level.ranks == [1, 1]).unwrap();
    assert!(last.candidates > 32 * 512, "{last:?}");
    assert!(found.levels[0].registered > 0 && found.levels[1].ended > 0, "{:?}", found.levels);
    check(&Whim { scene: &scene, reach: 1.0, odds: 3 }, a, b);
}

/// Each vertex belongs to many triangles, each edge to two, in different pieces of work.
#[test]
fn faces_of_many_are_looked_at_once() {
    let side = some_or_all(9_u32, 13);
    let mut points: Vec<[f64; 3]> = Vec::new();
    let grids = [0_u32, 1].map(|which| {
        let first = points.len();
        for i in 0..=side * (side + 1) + side {
            let [x, y] = [i % (side + 1), i / (side + 1)];
            let z = f64::from((x * 7 + y * 3 + which * (x * 5 + y)) % 3);
            points.push([f64::from(x), f64::from(y), z]);
        }
        let at = |x: u32, y: u32| Vertex::input(first + (y * (side + 1) + x) as usize);
        let cells = (0..side).flat_map(|x| (0..side).map(move |y| [x, y]));
        let triangles = cells.flat_map(|[x, y]| {
            [[at(x, y), at(x + 1, y), at(x, y + 1)], [at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)]]
        });
        Simplices { triangles: triangles.collect(), ..Simplices::default() }
    });
    let scene = Scene::from_points3(&points).unwrap();
    let [a, b] = grids.map(|given| Complex::new(&scene, &given).unwrap());
    let found = check(&Exact.prepare(&scene, Off).unwrap(), &a, &b);
    assert!(found.levels.iter().filter(|level| level.registered > 0).count() >= 2, "{:?}", found.levels);
}

#[test]
fn nothing_meets_nothing() {
    let scene = Scene::from_points2(&[[0.0, 0.0], [1.0, 1.0]]).unwrap();
    let session = Exact.prepare(&scene, Off).unwrap();
    let edge = Simplices { edges: vec![[Vertex::input(0), Vertex::input(1)]], ..Simplices::default() };
    let [none, edge] = [Simplices::default(), edge].map(|given| Complex::new(&scene, &given).unwrap());
    for (a, b) in [(&none, &none), (&none, &edge), (&edge, &none)] {
        let found = contacts2d(&session, a, b);
        assert!(found.registered.is_empty());
        assert_eq!(found.levels.iter().map(|level| level.candidates).sum::<u64>(), 0);
        assert_eq!(found.levels.len(), 6);
    }
}

#[test]
#[should_panic(expected = "contacts3d needs a 3D scene")]
fn space_is_not_the_plane() {
    let scene = Scene::from_points2(&[]).unwrap();
    let _ = contacts3d(&Naive::default().prepare(&scene, Off).unwrap(), &Complex::default(), &Complex::default());
}

#[test]
#[should_panic(expected = "contacts2d needs a 2D scene")]
fn the_plane_is_not_space() {
    let scene = Scene::from_points3(&[]).unwrap();
    let _ = contacts2d(&Naive::default().prepare(&scene, Off).unwrap(), &Complex::default(), &Complex::default());
}
