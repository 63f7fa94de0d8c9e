//! Collapsing edges and splitting vertices, on small hand-made meshes.

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{OperationError as E, Side};
use predicament_predicates::Vertex;

use super::loops::Loops;
use super::shapes::{between, cube, grid, mesh, octahedron, two_squares};

fn checked(mesh: &HalfEdgeMesh) -> Loops {
    mesh.validate().unwrap_or_else(|why| panic!("{why}"));
    let loops = Loops::of(mesh);
    loops.check().unwrap_or_else(|why| panic!("{why}"));
    loops
}

/// Collapses the edge from one vertex to another, and splits the vertex again.
fn goes_back(mut mesh: HalfEdgeMesh, from: usize, to: usize, counts: [i64; 4]) {
    let whole = checked(&mesh);
    let edge = between(&mesh, from, to);
    let kept = mesh.end(edge);
    let collapsed = mesh.collapse_edge(edge).unwrap();
    assert_eq!((collapsed.vertex, mesh.scene_vertex(kept)), (kept, Vertex::input(to)));
    assert_eq!(checked(&mesh).counts(), counts, "{from} to {to}");
    let again = mesh.split_vertex(collapsed.sides, Vertex::input(from)).unwrap();
    assert_eq!([mesh.start(again), mesh.end(again)].map(|v| mesh.scene_vertex(v).index()), [from, to]);
    assert_eq!(checked(&mesh), whole, "{from} to {to}");
}

#[test]
fn an_edge_is_collapsed_and_its_vertex_split_again() {
    goes_back(octahedron(), 1, 2, [5, 9, 6, 0]);
    goes_back(cube(), 0, 1, [7, 11, 6, 0]);
    // At a boundary, towards it, and between two faces of four.
    goes_back(grid(2, 2, false), 0, 1, [8, 11, 4, 1]);
    goes_back(grid(2, 2, false), 4, 1, [8, 11, 4, 1]);
    goes_back(grid(4, 5, true), 0, 1, [19, 39, 20, 0]);
    // A triangle on the boundary of a fan: its other edges become one.
    goes_back(mesh(4, &[[0, 1, 2], [0, 2, 3]]).unwrap(), 0, 1, [3, 3, 1, 1]);
    goes_back(mesh(4, &[[0, 1, 2], [0, 2, 3]]).unwrap(), 1, 0, [3, 3, 1, 1]);
}

#[test]
fn half_edges_outside_a_collapsed_triangle_stay() {
    let mut m = octahedron();
    let [edge, spoke] = [between(&m, 1, 2), between(&m, 0, 1)];
    m.set_user_data(m.opposite(spoke), 7);
    let removed = m.next(edge);
    m.collapse_edge(edge).unwrap();
    assert!(!m.has_half_edge(removed) && !m.has_half_edge(edge));
    assert_eq!(m.user_data(between(&m, 2, 0)), 7);
}

/// The collapse from one vertex to another is refused, and leaves no trace.
fn refused(mut mesh: HalfEdgeMesh, from: usize, to: usize, why: impl Fn(&HalfEdgeMesh) -> E) {
    let before = checked(&mesh);
    let wanted = why(&mesh);
    assert_eq!(mesh.collapse_edge(between(&mesh, from, to)), Err(wanted));
    assert!(!wanted.to_string().is_empty());
    assert_eq!(checked(&mesh), before);
}

#[test]
fn a_collapse_that_changes_the_surface_is_refused_by_name() {
    let face = |m: &HalfEdgeMesh, from, to| m.face(between(m, from, to)).unwrap();
    let tetrahedron = mesh(4, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]).unwrap();
    refused(tetrahedron, 0, 1, |m| E::SameVertices(face(m, 2, 3), face(m, 3, 2)));
    refused(mesh(3, &[[0, 1, 2]]).unwrap(), 0, 1, |m| E::OneEdge(m.end(between(m, 1, 2))));
    refused(mesh(5, &[[0, 1, 2], [2, 3, 4]]).unwrap(), 0, 1, |m| E::NoFace(between(m, 2, 1)));
    refused(mesh(3, &[[0, 1, 2], [0, 2, 1]]).unwrap(), 0, 1, |m| E::OneVertex(m.end(between(m, 1, 2))));
    // A strip of two squares: the edge between them joins two places of its boundary.
    refused(grid(2, 1, false), 1, 4, |m| E::Pinched(m.end(between(m, 1, 4))));
    let bipyramid = [[0, 1, 3], [1, 2, 3], [2, 0, 3], [1, 0, 4], [2, 1, 4], [0, 2, 4]];
    refused(mesh(5, &bipyramid).unwrap(), 0, 1, |m| E::EdgeExists(between(m, 2, 1)));
    let mut wires = mesh(3, &[[0, 1, 2]]).unwrap();
    let only = wires.faces().next().unwrap();
    wires.open_face(only).unwrap();
    refused(wires, 0, 1, |m| E::OnBoundary(between(m, 0, 1)));
    let mut joined = two_squares();
    let h = joined.insert_auxiliary_edge(between(&joined, 3, 0), between(&joined, 5, 4)).unwrap();
    assert_eq!(joined.collapse_edge(h), Err(E::OneFace(h)));
    let gone = between(&octahedron(), 1, 2);
    let mut m = octahedron();
    m.collapse_edge(gone).unwrap();
    assert_eq!(m.collapse_edge(gone), Err(E::NoSuchHalfEdge(gone)));
}

#[test]
fn a_split_that_no_collapse_undoes_is_refused_by_name() {
    let split = |m: &HalfEdgeMesh, left: Side, right: Side| {
        let (mut copy, before) = (m.clone(), checked(m));
        let refused = copy.split_vertex([left, right], Vertex::input(99)).unwrap_err();
        assert_eq!(checked(&copy), before);
        refused
    };
    let m = octahedron();
    let [one, two, far] = [between(&m, 1, 2), between(&m, 0, 2), between(&m, 0, 1)];
    assert_eq!(split(&m, Side::Edge(one), Side::Edge(far)), E::TwoVertices(one, far));
    assert_eq!(split(&m, Side::Edge(one), Side::Edge(one)), E::OneVertex(m.start(one)));
    assert_eq!(split(&m, Side::Corner(two), Side::Corner(two)), E::OneLoop(two, two));
    let pillow = mesh(3, &[[0, 1, 2], [0, 2, 1]]).unwrap();
    let [a, b] = [between(&pillow, 1, 0), between(&pillow, 2, 0)];
    let faces = [a, b].map(|h| pillow.face(h).unwrap());
    assert_eq!(split(&pillow, Side::Edge(a), Side::Edge(b)), E::SameVertices(faces[0], faces[1]));
    let mut wires = mesh(4, &[[0, 1, 2], [2, 3, 0]]).unwrap();
    let second = wires.face(between(&wires, 2, 3)).unwrap();
    wires.open_face(second).unwrap();
    let [h, inner] = [between(&wires, 3, 0), between(&wires, 2, 0)];
    assert_eq!(split(&wires, Side::Edge(h), Side::Edge(inner)), E::NoFace(h));
    // Two squares with one common corner: each takes its own boundary.
    let pinched = mesh(7, &[[0, 1, 2, 3], [2, 4, 5, 6]]).unwrap();
    let [near, other] = [between(&pinched, 1, 2), between(&pinched, 6, 2)];
    assert_eq!(split(&pinched, Side::Corner(near), Side::Corner(other)), E::Pinched(pinched.end(near)));
    let outer = [near, other].map(|h| pinched.opposite(pinched.next(h)));
    assert_eq!(split(&pinched, Side::Corner(outer[0]), Side::Corner(outer[1])), E::OnBoundary(outer[0]));
}
