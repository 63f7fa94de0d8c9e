//! Single operations and traversals, on small hand-made meshes.

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{Face, HalfEdge, MeshVertex, OperationError};
use predicament_predicates::Vertex;

use super::loops::Loops;
use super::shapes::{between, cube, grid, mesh, octahedron, two_squares};

fn indices(mesh: &HalfEdgeMesh, vertices: impl Iterator<Item = MeshVertex>) -> Vec<usize> {
    vertices.map(|v| mesh.scene_vertex(v).index()).collect()
}

fn checked(mesh: &HalfEdgeMesh) -> Loops {
    mesh.validate().unwrap_or_else(|why| panic!("{why}"));
    let loops = Loops::of(mesh);
    loops.check().unwrap_or_else(|why| panic!("{why}"));
    loops
}

fn vertex(mesh: &HalfEdgeMesh, index: usize) -> MeshVertex {
    mesh.vertices().find(|&v| mesh.scene_vertex(v) == Vertex::input(index)).expect("a vertex")
}

fn all_faces(mesh: &HalfEdgeMesh) -> Vec<Face> {
    mesh.faces().collect()
}

#[test]
fn loops_and_rings() {
    let mut m = grid(2, 2, false);
    // 6 7 8
    // 3 4 5
    // 0 1 2
    let h = between(&m, 0, 1);
    assert_eq!(indices(&m, m.vertex_loop(h)), [1, 4, 3, 0]);
    assert_eq!(indices(&m, m.vertex_loop(m.opposite(h))), [0, 3, 6, 7, 8, 5, 2, 1]);
    let ring = |m: &HalfEdgeMesh, v: usize| {
        let mut starts = indices(m, m.ring(vertex(m, v)).map(|h| m.start(h)));
        starts.sort_unstable();
        starts
    };
    assert_eq!(ring(&m, 4), [1, 3, 5, 7]);
    assert_eq!(ring(&m, 1), [0, 2, 4]);
    assert_eq!(ring(&m, 0), [1, 3]);
    assert_eq!([0, 1, 4].map(|v| m.gaps(vertex(&m, v))), [1, 1, 0]);
    for h in m.half_edges() {
        assert_eq!(m.previous(h).map(|before| m.next(before)), Some(h));
        assert_eq!(m.find(m.start(h), m.end(h)), Some(h));
    }
    assert_eq!(m.find(vertex(&m, 0), vertex(&m, 4)), None);
    let boundaries: Vec<HalfEdge> = m.boundary_loops(1).collect();
    assert_eq!(boundaries.len(), 1);
    assert_eq!(m.loop_of(boundaries[0]).count(), 8);
    assert_eq!(m.boundary_loops(1).count(), 0, "all of them have the marker");
    m.clear_markers();
    assert_eq!(m.boundary_loops(1).count(), 1);
    let [low, right] = [1, 5].map(|v| vertex(&m, v));
    // The faces of 5 that are not faces of 1, as in the lecture.
    let places = |faces: Vec<Face>| faces.iter().map(|f| f.index()).collect::<Vec<_>>();
    let mut first = places(m.faces_once([low].into_iter(), 1).collect());
    first.sort_unstable();
    assert_eq!(first, [0, 1]);
    assert_eq!(places(m.faces_once([right].into_iter(), 1).collect()), [3]);
}

#[test]
fn user_data_and_markers_go_along() {
    let mut m = cube();
    let h = between(&m, 0, 1);
    m.set_user_data(h, 5);
    m.set_marker(m.opposite(h), 7);
    let v = m.split_edge(h, Vertex::input(8)).unwrap();
    assert_eq!((m.end(h), m.user_data(m.next(h))), (v, 5));
    assert_eq!(m.marker(m.opposite(h)), 7);
    assert_eq!(m.marker(m.opposite(m.next(h))), 7);
    let f = m.face(h).unwrap();
    m.set_face_user_data(f, 11);
    m.set_face_marker(f, 2);
    m.set_vertex_user_data(v, 13);
    m.set_vertex_marker(v, 3);
    let mut other = HalfEdgeMesh::default();
    let moved = m.unhook_faces(&[f], &mut other).unwrap();
    assert_eq!((other.face_user_data(moved[0]), other.face_marker(moved[0])), (11, 2));
    let there = vertex(&other, 8);
    assert_eq!((other.vertex_user_data(there), other.vertex_marker(there)), (13, 3));
    assert_eq!(other.user_data(between(&other, 8, 1)), 5);
}

#[test]
fn faces_are_split_at_the_right_corner_anywhere_in_a_mesh() {
    let mut m = grid(2, 2, false);
    let [center, corner, far] = [4, 8, 6].map(|v| vertex(&m, v));
    let f = all_faces(&m)[3];
    assert_eq!(m.split_face_between(f, center, far), Err(OperationError::NotInFace(f, far)));
    // The result does not depend on where the ring of the center begins.
    let h = m.split_face_between(f, center, corner).unwrap();
    let loops = checked(&m);
    assert_eq!(loops.counts(), [9, 13, 5, 1]);
    assert_eq!(indices(&m, m.vertex_loop(h)), [8, 7, 4]);
    assert_eq!(indices(&m, m.vertex_loop(m.opposite(h))), [4, 5, 8]);
    assert_eq!(m.face(h), Some(f), "the loop of the first half-edge keeps the face");
    assert_eq!(m.join_faces(h), Ok(f));
    assert_eq!(checked(&m), Loops::of(&grid(2, 2, false)));
}

#[test]
fn ears_are_cut_until_a_triangle_is_left() {
    let corners: Vec<u32> = (0..12).collect();
    let mut m = mesh(12, &[corners]).unwrap();
    let before = between(&m, 11, 0);
    let face = m.face(before);
    for left in (4..=12).rev() {
        assert_eq!(m.loop_of(before).count(), left);
        let h = m.cut_ear(before).unwrap();
        assert_eq!((m.next(before), m.face(h)), (h, face));
        assert_eq!(m.loop_of(m.opposite(h)).count(), 3);
    }
    assert_eq!(m.cut_ear(before), Err(OperationError::TooFewHalfEdges(m.next(m.next(before)))));
    assert_eq!(checked(&m).counts(), [12, 21, 10, 1]);
    assert!(m.to_triangles().is_ok());
}

#[test]
fn a_hole_is_joined_to_its_face() {
    let mut m = two_squares();
    let whole = Loops::of(&m);
    let outer = between(&m, 3, 0);
    let hole = between(&m, 5, 4);
    let face = m.face(outer);
    assert!(m.is_boundary(hole));
    let h = m.insert_auxiliary_edge(outer, hole).unwrap();
    let loops = checked(&m);
    assert_eq!(loops.counts(), [8, 9, 2, 1]);
    assert_eq!(indices(&m, m.vertex_loop(outer)), [0, 4, 7, 6, 5, 4, 0, 1, 2, 3]);
    assert!(m.loop_of(h).all(|h| m.face(h) == face));
    // The face visits 4 twice now.
    let (f, v) = (face.unwrap(), vertex(&m, 4));
    assert_eq!(m.split_face_between(f, vertex(&m, 2), v), Err(OperationError::SeveralCorners(f, v)));
    // Without the square in it, the hole is a boundary.
    let mut open = m.clone();
    open.remove_faces(&[open.face(between(&open, 4, 5)).unwrap()]).unwrap();
    assert_eq!(checked(&open).counts(), [8, 9, 1, 2]);
    assert_eq!(m.join_faces(h), Err(OperationError::OneFace(h)));
    let back = m.remove_auxiliary_edge(h).unwrap();
    assert!(m.is_boundary(back) && m.face(outer) == face);
    assert_eq!(checked(&m), whole);
}

#[test]
fn auxiliary_edges_that_would_glue_or_cut_are_refused() {
    let mut m = two_squares();
    let [a, b] = [between(&m, 0, 1), between(&m, 4, 5)];
    assert_eq!(m.insert_auxiliary_edge(a, b), Err(OperationError::TwoFaces(a, b)));
    let c = between(&m, 2, 3);
    assert_eq!(m.insert_auxiliary_edge(a, c), Err(OperationError::OneLoop(a, c)));
    let [a, c] = [m.opposite(a), m.opposite(c)];
    assert_eq!(m.insert_auxiliary_edge(a, c), Err(OperationError::OneLoop(a, c)));
    assert_eq!(m.remove_auxiliary_edge(a), Err(OperationError::NotAuxiliary(a)));
    let inside = m.opposite(a);
    assert_eq!(m.insert_auxiliary_edge(inside, m.opposite(inside)), Err(OperationError::EdgeExists(a)));
    let outside = m.opposite(m.next(inside));
    assert_eq!(m.insert_auxiliary_edge(inside, outside), Err(OperationError::OneVertex(m.end(inside))));
    assert_eq!(checked(&m), Loops::of(&two_squares()));
}

#[test]
fn edges_are_flipped_and_flipped_back() {
    let mut m = octahedron();
    let before = Loops::of(&m);
    let h = between(&m, 0, 1);
    m.flip_edge(h).unwrap();
    assert_ne!(checked(&m), before);
    assert_eq!(indices(&m, [m.start(h), m.end(h)].into_iter()), [4, 2]);
    m.flip_edge(h).unwrap();
    assert_eq!(checked(&m), before);
    // A tetrahedron already has all possible edges.
    let mut small = mesh(4, &[[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]).unwrap();
    let h = between(&small, 0, 1);
    assert_eq!(small.flip_edge(h), Err(OperationError::EdgeExists(between(&small, 2, 3))));
    let mut squares = cube();
    let h = between(&squares, 0, 1);
    assert!(matches!(squares.flip_edge(h), Err(OperationError::NoTriangle(_))));
    // Two triangles on the same three vertices.
    let mut pillow = mesh(3, &[[0, 1, 2], [2, 1, 0]]).unwrap();
    let h = between(&pillow, 0, 1);
    assert_eq!(pillow.flip_edge(h), Err(OperationError::OneVertex(vertex(&pillow, 2))));
}

#[test]
fn removed_faces_leave_linked_boundaries() {
    let mut m = octahedron();
    let faces = all_faces(&m);
    m.remove_faces(&[faces[0]]).unwrap();
    assert_eq!(checked(&m).counts(), [6, 12, 7, 1]);
    // Also the opposite face at vertex 0: the vertex is then pinched.
    m.remove_faces(&[faces[2]]).unwrap();
    assert_eq!(m.gaps(vertex(&m, 0)), 2);
    checked(&m);
    m.remove_faces(&[faces[1], faces[3]]).unwrap();
    let rest = checked(&m);
    assert_eq!(rest.counts(), [5, 8, 4, 1], "vertex 0 is gone");
    let loops: Vec<HalfEdge> = m.boundary_loops(1).collect();
    m.cover_boundary_loop(loops[0]).unwrap();
    assert_eq!(checked(&m).counts(), [5, 8, 5, 0]);
    let all = all_faces(&m);
    m.remove_faces(&all).unwrap();
    assert_eq!(checked(&m).counts(), [0; 4]);
    assert_eq!((m.vertex_count(), m.edge_count(), m.face_count()), (0, 0, 0));
}

#[test]
fn unhooked_faces_are_whole_in_the_other_mesh() {
    let mut m = grid(3, 3, false);
    let faces = all_faces(&m);
    let all = Loops::of(&m);
    let chosen = [faces[4], faces[1], faces[8]];
    let mut other = HalfEdgeMesh::default();
    let moved = m.unhook_faces(&chosen, &mut other).unwrap();
    let (rest, part) = (checked(&m), checked(&other));
    assert_eq!(moved.len(), 3);
    assert_eq!([rest.faces.len(), part.faces.len()], [6, 3]);
    let mut both = [rest.faces, part.faces].concat();
    both.sort();
    assert_eq!(both, all.faces, "each face is in one of both, with its vertices");
    // The last face touches the middle face in a vertex, where the part is pinched.
    assert_eq!(other.vertices().filter(|&v| other.gaps(v) == 2).count(), 1);
    let more = all_faces(&m)[0];
    // There it becomes a separate part, with its own copies of vertices.
    m.unhook_faces(&[more], &mut other).unwrap();
    assert_eq!(other.validate(), Ok(()));
    assert_eq!((other.face_count(), other.vertex_count()), (4, 9 + 4));
    checked(&m);
}

#[test]
fn what_would_break_an_invariant_is_refused_by_handle() {
    use OperationError as E;
    let mut m = grid(2, 1, false);
    let (inner, outer) = (between(&m, 1, 4), between(&m, 1, 0));
    let faces = all_faces(&m);
    let mut empty = octahedron();
    let all = all_faces(&empty);
    empty.remove_faces(&all).unwrap();
    let mut full = cube();
    assert_eq!(empty.split_edge(inner, Vertex::input(0)), Err(E::NoSuchHalfEdge(inner)));
    assert_eq!(empty.open_face(faces[0]), Err(E::NoSuchFace(faces[0])));
    assert_eq!(m.split_face(outer, inner), Err(E::OnBoundary(outer)));
    assert_eq!(m.split_face(inner, m.opposite(inner)), Err(E::TwoFaces(inner, m.opposite(inner))));
    assert_eq!(m.split_face(inner, inner), Err(E::OneVertex(m.end(inner))));
    assert_eq!(m.split_face(inner, m.next(inner)), Err(E::TooFewHalfEdges(inner)));
    assert_eq!(m.join_faces(outer), Err(E::OnBoundary(outer)));
    assert_eq!(m.join_edges(vertex(&m, 1)), Err(E::NotTwoEdges(vertex(&m, 1))));
    assert_eq!(m.cover_boundary_loop(inner), Err(E::NotOnBoundary(inner)));
    assert_eq!(m.flip_edge(outer), Err(E::OnBoundary(outer)));
    assert_eq!(m.remove_faces(&[faces[1], faces[0], faces[1]]), Err(E::ListedTwice(faces[1])));
    let mut other = HalfEdgeMesh::default();
    assert_eq!(m.unhook_faces(&[faces[0], faces[0]], &mut other), Err(E::ListedTwice(faces[0])));
    assert_eq!(Loops::of(&m), Loops::of(&grid(2, 1, false)));
    // The last triangle of a strip: its corner cannot be removed.
    let mut strip = mesh(4, &[[0, 1, 2], [2, 1, 3]]).unwrap();
    let corner = vertex(&strip, 0);
    assert!(matches!(strip.join_edges(corner), Err(E::TooFewHalfEdges(_))));
    // The diagonal of a square that another face already has as an edge.
    let mut doubled = mesh(5, &[&[0, 1, 2, 3][..], &[0, 2, 4]]).unwrap();
    let f = all_faces(&doubled)[0];
    let (a, c) = (vertex(&doubled, 0), vertex(&doubled, 2));
    let exists = doubled.split_face_between(f, a, c).unwrap_err();
    assert_eq!(exists, E::EdgeExists(between(&doubled, 0, 2)));
    assert!(exists.to_string().ends_with("joins the same vertices already"));
    // A single remaining edge is not an auxiliary edge.
    full.remove_faces(&all_faces(&full)[1..]).unwrap();
    let f = all_faces(&full)[0];
    let h = full.open_face(f).unwrap();
    assert_eq!(full.remove_auxiliary_edge(h), Err(E::NotAuxiliary(h)));
    assert_eq!(checked(&full).counts(), [4, 4, 0, 2], "four wires in a circle");
}

#[test]
fn an_edge_that_leads_nowhere_else_stays() {
    let mut m = mesh(6, &[[0, 1, 2], [3, 4, 5]]).unwrap();
    let h = m.insert_auxiliary_edge(between(&m, 2, 0), between(&m, 4, 3)).unwrap();
    let v = m.split_edge(h, Vertex::input(6)).unwrap();
    // 6 is then a dead end.
    m.remove_auxiliary_edge(h).unwrap();
    assert_eq!(m.degree(v), 1);
    checked(&m);
    let dead_end = m.find(v, vertex(&m, 3)).unwrap();
    assert_eq!(m.remove_auxiliary_edge(dead_end), Err(OperationError::LastEdge(v)));
    assert_eq!(m.remove_auxiliary_edge(m.opposite(dead_end)), Err(OperationError::LastEdge(v)));
    assert_eq!(m.join_edges(v), Err(OperationError::NotTwoEdges(v)));
}
