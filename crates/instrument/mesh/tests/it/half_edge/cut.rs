//! Cutting a mesh open along edges.

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{HalfEdge, OperationError};

use super::shapes::{between, cube, grid, mesh, octahedron};

fn checked(mesh: &HalfEdgeMesh) {
    mesh.validate().unwrap_or_else(|why| panic!("{why}"));
}

/// The number of connected parts.
fn parts(mesh: &HalfEdgeMesh) -> usize {
    let most = mesh.vertices().map(|v| v.index() + 1).max().unwrap_or(0);
    let mut of: Vec<usize> = (0..most).collect();
    for _ in 0..most {
        for h in mesh.half_edges() {
            let [a, b] = [mesh.start(h), mesh.end(h)].map(|v| v.index());
            let least = of[a].min(of[b]);
            (of[a], of[b]) = (least, least);
        }
    }
    mesh.vertices().filter(|v| of[v.index()] == v.index()).count()
}

#[test]
fn a_cube_cut_around_comes_apart() {
    let mut m = cube();
    // The edges around the face 0 3 2 1.
    let around: Vec<HalfEdge> = [[0, 3], [3, 2], [2, 1], [1, 0]].map(|[a, b]| between(&m, a, b)).to_vec();
    m.set_user_data(m.opposite(around[2]), 7);
    let old: Vec<HalfEdge> = around.iter().map(|&h| m.opposite(h)).collect();
    let cut = m.cut_along(&around).unwrap();
    checked(&m);
    assert_eq!((m.vertex_count(), m.edge_count(), m.face_count(), parts(&m)), (12, 16, 6, 2));
    for ((&h, &o), [beside_h, beside_o]) in around.iter().zip(&old).zip(cut) {
        assert_eq!((m.opposite(h), m.opposite(o)), (beside_h, beside_o));
        assert!(m.is_boundary(beside_h) && m.is_boundary(beside_o));
        assert_eq!(m.loop_of(beside_h).count(), 4);
        assert_eq!(m.user_data(beside_h), m.user_data(o));
        let f = m.face(h);
        assert!(m.loop_of(h).all(|h| m.face(h) == f));
    }
    // After both are covered, they are closed.
    for h in [m.opposite(around[0]), m.opposite(old[0])] {
        m.cover_boundary_loop(h).unwrap();
    }
    checked(&m);
    assert_eq!(m.boundary_loops(1).count(), 0);
}

#[test]
fn a_slit_keeps_a_mesh_in_one_piece() {
    let mut m = octahedron();
    let [first, second] = [between(&m, 1, 2), between(&m, 2, 3)];
    assert_eq!(m.cut_along(&[first]), Err(OperationError::EdgeExists(first)), "two edges between the same vertices");
    m.cut_along(&[first, second]).unwrap();
    checked(&m);
    assert_eq!((m.vertex_count(), m.edge_count(), parts(&m)), (7, 14, 1), "the vertex between them is divided");
    let slit: Vec<HalfEdge> = m.boundary_loops(1).collect();
    assert_eq!(m.loop_of(slit[0]).count(), 4);
}

#[test]
fn cuts_reach_boundaries_and_cross() {
    let mut m = grid(4, 4, false);
    let path = |m: &HalfEdgeMesh, ids: &[usize]| -> Vec<HalfEdge> {
        ids.windows(2).map(|pair| between(m, pair[0], pair[1])).collect()
    };
    let mut edges = path(&m, &[2, 7, 12, 17, 22]);
    edges.extend(path(&m, &[14, 13, 12, 11, 10]));
    m.cut_along(&edges).unwrap();
    checked(&m);
    assert_eq!((m.face_count(), parts(&m)), (16, 4));
    assert_eq!(m.vertex_count(), 4 * 9);
    assert_eq!(m.vertices().filter(|&v| m.gaps(v) > 1).count(), 0, "each fan has its vertex");
}

#[test]
fn what_is_no_edge_between_faces_is_refused() {
    let mut m = grid(2, 2, false);
    let outer = between(&m, 1, 0);
    let inner = between(&m, 1, 4);
    let before = format!("{m:?}");
    assert_eq!(m.cut_along(&[outer]), Err(OperationError::OnBoundary(outer)));
    assert_eq!(m.cut_along(&[inner, m.opposite(inner)]), Err(OperationError::EdgeListedTwice(m.opposite(inner))));
    assert_eq!(format!("{m:?}"), before);
    m.cut_along(&[inner]).unwrap();
    checked(&m);
    let beside = m.opposite(inner);
    assert_eq!(m.cut_along(&[inner]), Err(OperationError::OnBoundary(beside)));
}

/// Two tetrahedra that touch along an edge, as one mesh in which one face passes by the edge: the mesh is divided
/// there.
#[test]
fn what_touches_along_an_edge_comes_apart() {
    // A roof over the quadrangle 0 1 2 3 whose ridge has come down to the diagonal from 0 to 2.
    let mut m = mesh(4, &[vec![0, 1, 2, 3], vec![2, 1, 0], vec![0, 3, 2]]).unwrap();
    let corner = |m: &HalfEdgeMesh, from, to| between(m, from, to);
    let (first, second, ridge) = (corner(&m, 3, 0), corner(&m, 1, 2), corner(&m, 0, 2));
    assert_eq!(m.split_face(first, second), Err(OperationError::EdgeExists(ridge)));
    let ([h, o], divided) = m.divide_at_edge(first, second, ridge).unwrap();
    checked(&m);
    assert_eq!((m.vertex_count(), m.edge_count(), m.face_count(), parts(&m)), (6, 6, 4, 2));
    assert_eq!(divided.len(), 2);
    assert_eq!([h, o].map(|h| m.loop_of(h).count()), [3; 2]);
    assert_eq!([m.start(h), m.end(h)].map(|v| m.scene_vertex(v).index()), [0, 2]);
    assert!(m.opposite(h) != o && m.opposite(o) != h);
    let again = m.opposite(h);
    assert_eq!(m.divide_at_edge(m.next(h), h, again), Err(OperationError::TooFewHalfEdges(m.next(h))));
}
