//! Orientations of closed curves, and refused complexes.

use predicament_contacts::checks::pairs::{NotOriented, Side, oriented_curve, oriented_surface};
use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Scene, Sign, Vertex};

fn scene(points: usize) -> Scene {
    let points: Vec<[f64; 3]> = (0..points).map(|i| u8::try_from(i).unwrap()).map(|i| [f64::from(i); 3]).collect();
    Scene::from_points3(&points).unwrap()
}

fn curve(edges: &[[usize; 2]]) -> Complex {
    let edges = edges.iter().map(|edge| edge.map(Vertex::input)).collect();
    Complex::new(&scene(12), &Simplices { edges, ..Simplices::default() }).unwrap()
}

fn surface(triangles: &[[usize; 3]]) -> Complex {
    let triangles = triangles.iter().map(|triangle| triangle.map(Vertex::input)).collect();
    Complex::new(&scene(12), &Simplices { triangles, ..Simplices::default() }).unwrap()
}

#[test]
fn a_curve_is_followed_around_component_by_component() {
    let two = curve(&[[0, 5], [5, 2], [2, 7], [7, 0], [1, 3], [3, 4], [4, 1], [6, 8], [8, 9], [9, 6]]);
    let oriented = oriented_curve(&two, Side::A).unwrap();
    let mut entered = [const { Vec::new() }; 12];
    let mut left = [const { Vec::new() }; 12];
    for (&[a, b], (component, sign)) in two.edges().iter().zip(oriented) {
        let (from, to) = if sign == Sign::Positive { (a, b) } else { (b, a) };
        left[from.index()].push(component);
        entered[to.index()].push(component);
    }
    let components = [0, 1, 0, 1, 1, 0, 2, 0, 2, 2];
    for (vertex, component) in components.into_iter().enumerate() {
        assert_eq!((&entered[vertex], &left[vertex]), (&vec![component], &vec![component]), "{vertex}");
    }
}

#[test]
fn vertices_of_a_curve_have_two_edges() {
    let v = Vertex::input;
    let eight = curve(&[[0, 1], [1, 2], [2, 0], [2, 3], [3, 4], [4, 2]]);
    assert_eq!(oriented_curve(&eight, Side::B), Err(NotOriented::Open { side: Side::B, vertex: v(2), degree: 4 }));
    let path = curve(&[[1, 0], [0, 2]]);
    assert_eq!(oriented_curve(&path, Side::A), Err(NotOriented::Open { side: Side::A, vertex: v(1), degree: 1 }));
}

#[test]
fn edges_of_a_surface_have_two_triangles() {
    let v = Vertex::input;
    let book = surface(&[[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
    let refused = oriented_surface(&book, Side::A).unwrap_err();
    assert_eq!(refused, NotOriented::Border { side: Side::A, edge: [v(0), v(1)], degree: 3 });
    assert_eq!(refused.to_string(), "complex A is not a closed surface: edge [0, 1] has 3 triangles");
    let one_sided = NotOriented::OneSided { side: Side::B };
    assert_eq!(one_sided.to_string(), "complex B is a one-sided surface");
}

#[test]
fn surfaces_that_share_a_vertex_only_are_two() {
    let tetrahedron = |corners: [usize; 4]| {
        [0, 1, 2, 3].map(|left_out| {
            let three: Vec<usize> = (0..4).filter(|&i| i != left_out).map(|i| corners[i]).collect();
            [three[0], three[1], three[2]]
        })
    };
    let both = surface(&[tetrahedron([0, 1, 2, 3]), tetrahedron([3, 4, 5, 6])].concat());
    let components: Vec<usize> = oriented_surface(&both, Side::A).unwrap().iter().map(|(at, _)| *at).collect();
    assert_eq!(components, [0, 0, 0, 0, 1, 1, 1, 1]);
}
