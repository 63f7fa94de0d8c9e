//! The hierarchy with several backends, on pairs whose common points are known.

use predicament_contacts::algorithm::pairs::{Contact, contacts};
use predicament_exact::Exact;
use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};
use predicament_sos::{Scheme, Sos};

fn v<const N: usize>(indices: [usize; N]) -> [Vertex; N] {
    indices.map(Vertex::input)
}

/// The ranks and vertices of the contacts between two complexes.
fn registered<B: Backend>(backend: &B, scene: &Scene, a: &Simplices, b: &Simplices) -> Vec<(Vec<usize>, Vec<usize>)> {
    let session = backend.prepare(scene, Off).unwrap();
    session.supports_contacts().unwrap();
    let [a, b] = [a, b].map(|given| Complex::new(scene, given).unwrap());
    let indices = |vertices: &[Vertex]| vertices.iter().map(|v| v.index()).collect();
    let found = contacts(&session, &a, &b).registered;
    found.iter().map(|c: &Contact| (indices(a.vertices_of(c.a)), indices(b.vertices_of(c.b)))).collect()
}

fn edges(edges: &[[usize; 2]]) -> Simplices {
    Simplices { edges: edges.iter().map(|&edge| v(edge)).collect(), ..Simplices::default() }
}

fn triangle(triangle: [usize; 3]) -> Simplices {
    Simplices { triangles: vec![v(triangle)], ..Simplices::default() }
}

#[test]
fn exact_finds_the_carriers_of_lowest_dimension() {
    // A path through (0,0), (4,0), (4,4); the other path starts on a vertex of it, passes through one of its edges and
    // ends beside it.
    let scene = Scene::from_points2(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 0.0], [2.0, 0.0], [5.0, 3.0]]).unwrap();
    let (a, b) = (edges(&[[0, 1], [1, 2]]), edges(&[[3, 4], [4, 5]]));
    let expected = vec![(vec![0], vec![3]), (vec![0, 1], vec![4]), (vec![1, 2], vec![4, 5])];
    assert_eq!(registered(&Exact, &scene, &a, &b), expected);
}

#[test]
fn overlapping_edges_meet_in_their_ends() {
    let scene = Scene::from_points2(&[[0.0, 0.0], [4.0, 0.0], [2.0, 0.0], [6.0, 0.0]]).unwrap();
    let expected = vec![(vec![0, 1], vec![2]), (vec![1], vec![2, 3])];
    let mut found = registered(&Exact, &scene, &edges(&[[0, 1]]), &edges(&[[2, 3]]));
    found.sort();
    assert_eq!(found, expected);
}

#[test]
fn space_has_its_own_degeneracies() {
    let points = [
        [0.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [0.0, 4.0, 0.0], // a triangle in z = 0
        [1.0, 1.0, 0.0],
        [1.0, 1.0, 2.0], // stands on its inside
        [1.0, -1.0, 0.0],
        [1.0, 5.0, 0.0],  // crosses two of its edges in its plane
        [1.0, 1.0, -1.0], // below
    ];
    let scene = Scene::from_points3(&points).unwrap();
    let t = triangle([0, 1, 2]);
    assert_eq!(registered(&Exact, &scene, &t, &edges(&[[3, 4]])), [(vec![0, 1, 2], vec![3])]);
    assert_eq!(registered(&Exact, &scene, &t, &edges(&[[5, 6]])), [(vec![0, 1], vec![5, 6]), (vec![1, 2], vec![5, 6])]);
    assert_eq!(registered(&Exact, &scene, &t, &edges(&[[4, 7]])), [(vec![0, 1, 2], vec![4, 7])]);
    let cell = Simplices { tetrahedra: vec![v([0, 1, 2, 4])], ..Simplices::default() };
    let inside = Scene::from_points3(&[&points[..7], &[[0.5, 0.5, 0.5]]].concat()).unwrap();
    let point = Simplices { vertices: v([7]).to_vec(), ..Simplices::default() };
    assert_eq!(registered(&Exact, &inside, &cell, &point), [(vec![0, 1, 2, 4], vec![7])]);
}

#[test]
fn with_broken_ties_only_full_dimensions_meet() {
    let points: Vec<[f64; 2]> = (0..4).flat_map(|i| (0..4).map(move |j| [f64::from(i), f64::from(j)])).collect();
    let scene = Scene::from_points2(&[&points[..], &points[..]].concat()).unwrap();
    let path = |from: usize| edges(&[[0, 5], [5, 10], [10, 3], [3, 9], [9, 0]].map(|edge| edge.map(|i| i + from)));
    for scheme in [Scheme::PerCoordinate, Scheme::EdelsbrunnerMucke] {
        let found = registered(&Sos { scheme }, &scene, &path(0), &path(16));
        assert!(found.iter().all(|(a, b)| a.len() + b.len() == 4), "{found:?}");
        assert!(found.len().is_multiple_of(2), "two closed curves cross an even number of times: {found:?}");
    }
}

#[test]
fn arguments_in_another_order_make_no_difference() {
    let scene = Scene::from_points2(&[[0.0, 0.0], [4.0, 1.0], [1.0, -1.0], [3.0, 4.0], [0.0, 0.0]]).unwrap();
    let session = Exact.prepare(&scene, Off).unwrap();
    let [a, b] = [edges(&[[0, 1]]), edges(&[[2, 3], [3, 4]])].map(|given| Complex::new(&scene, &given).unwrap());
    let (there, back) = (contacts(&session, &a, &b), contacts(&session, &b, &a));
    assert_eq!(there.registered.len(), 2);
    for contact in &there.registered {
        let swapped = Contact { a: contact.b, b: contact.a, on_a: contact.on_b, on_b: contact.on_a };
        assert!(back.registered.contains(&swapped));
    }
}
