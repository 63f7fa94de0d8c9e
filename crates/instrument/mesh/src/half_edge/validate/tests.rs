//! Each violation is planted and reported with its handle and text; traversals of a broken mesh end.

use super::*;
use crate::half_edge::{IndexedFaces, REMOVED};
use predicament_predicates::Vertex;

/// A strip of three triangles and a separate tetrahedron: vertices 0 to 4 and 5 to 8; and one vertex without edges.
fn mesh() -> HalfEdgeMesh {
    let triangles = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [5, 6, 7], [5, 8, 6], [6, 8, 7], [7, 8, 5]];
    let faces: IndexedFaces = triangles.into_iter().collect();
    let mesh = HalfEdgeMesh::new((0..10).map(Vertex::input).collect(), &faces).unwrap();
    assert_eq!(mesh.validate(), Ok(()));
    mesh
}

fn half_edge(mesh: &HalfEdgeMesh, from: u32, to: u32) -> HalfEdge {
    mesh.find(MeshVertex(from), MeshVertex(to)).unwrap()
}

/// The violation after a change; checks that all traversals end.
fn broken(change: impl Fn(&mut HalfEdgeMesh)) -> Violation {
    let mut mesh = mesh();
    change(&mut mesh);
    let violation = mesh.validate().expect_err("the change is seen");
    let steps = mesh.end.len() + 1;
    let known = |h: HalfEdge| {
        let links = [mesh.next(h), mesh.opposite(h)].into_iter().all(|h| mesh.has_half_edge(h));
        links && mesh.has_vertex(mesh.end(h)) && mesh.face(h).is_none_or(|f| mesh.has_face(f))
    };
    // Traversals need not handle links to elements that do not exist.
    if mesh.half_edges().all(known) {
        let anchored = |v: &MeshVertex| mesh.half_edge_of_vertex(*v).is_none_or(|h| mesh.has_half_edge(h));
        let vertices: Vec<MeshVertex> = mesh.vertices().filter(anchored).collect();
        for h in mesh.half_edges() {
            assert!(mesh.loop_of(h).count() <= steps);
            let _ = mesh.previous(h);
        }
        for &v in &vertices {
            assert!(mesh.ring(v).count() <= steps);
            for &other in &vertices {
                let _ = mesh.find(v, other);
            }
        }
        assert!(mesh.faces_once(vertices.iter().copied(), 1).count() <= steps);
        assert!(mesh.boundary_loops(1).count() <= steps);
    }
    violation
}

#[test]
fn links_to_nothing_are_seen() {
    let h = half_edge(&mesh(), 0, 1);
    let far = HalfEdge(77);
    let [from, to] = [h, far].map(Element::HalfEdge);
    assert_eq!(broken(|m| m.next[h.index()] = far), Violation::Link(from, to));
    assert_eq!(broken(|m| m.opposite[h.index()] = far), Violation::Link(from, to));
    let violation = Violation::Link(from, Element::Vertex(MeshVertex(77)));
    assert_eq!(broken(|m| m.end[h.index()] = MeshVertex(77)), violation);
    assert_eq!(violation.to_string(), "half-edge h0 links to vertex v77, which the mesh does not have");
    let violation = Violation::Link(from, Element::Face(Face(77)));
    assert_eq!(broken(|m| m.face[h.index()] = Face(77)), violation);
    let violation = Violation::Link(Element::Face(Face(1)), to);
    assert_eq!(broken(|m| m.face_half_edge[1] = far), violation);
    let violation = Violation::Link(Element::Vertex(MeshVertex(1)), to);
    assert_eq!(broken(|m| m.vertex_half_edge[1] = far), violation);
}

#[test]
fn free_places_that_are_used_and_used_ones_that_are_free_are_seen() {
    let h = half_edge(&mesh(), 0, 1);
    let expected = Violation::Storage(Element::HalfEdge(h));
    assert_eq!(broken(|m| m.free_half_edges.push(h)), expected);
    assert_eq!(expected.to_string(), "half-edge h0 is neither in use nor free once");
    assert_eq!(broken(|m| m.end[h.index()] = MeshVertex::NONE), expected);
    assert_eq!(
        broken(|m| m.delete_face(Face(2))),
        Violation::Link(Element::HalfEdge(HalfEdge(6)), Element::Face(Face(2)))
    );
    assert_eq!(broken(|m| m.face_half_edge[2] = HalfEdge::NONE), Violation::Storage(Element::Face(Face(2))));
    let vertex = |v| Violation::Storage(Element::Vertex(MeshVertex(v)));
    assert_eq!(broken(|m| m.vertex_half_edge[9] = REMOVED), vertex(9));
    assert_eq!(broken(|m| m.free_vertices.push(MeshVertex(40))), vertex(40));
}

#[test]
fn wrong_opposites_are_seen() {
    let m = mesh();
    let (h, o) = (half_edge(&m, 0, 1), half_edge(&m, 1, 0));
    let violation = Violation::OwnOpposite(h);
    assert_eq!(broken(|m| m.opposite[h.index()] = h), violation);
    assert_eq!(violation.to_string(), "half-edge h0 is its own opposite");
    assert_eq!(broken(|m| m.opposite[h.index()] = half_edge(m, 2, 0)), Violation::Opposite(h));
    assert_eq!(broken(|m| m.opposite[o.index()] = half_edge(m, 2, 0)), Violation::Opposite(h));
    assert_eq!(broken(|m| m.end[h.index()] = MeshVertex(0)), Violation::OneVertex(h));
}

#[test]
fn wrong_chains_are_seen() {
    let m = mesh();
    let (h, before) = (half_edge(&m, 1, 2), half_edge(&m, 0, 1));
    assert_eq!(broken(|m| m.next[h.index()] = h), Violation::OwnNext(h));
    assert_eq!(broken(|m| m.next[before.index()] = half_edge(m, 2, 0)), Violation::Start(before));
    // The half-edge from 1 to 3 starts at 1 too, and follows the half-edge from 2 to 1.
    let (other, shared) = (half_edge(&m, 2, 1), half_edge(&m, 1, 3));
    assert_eq!(broken(|m| m.next[before.index()] = shared), Violation::SharedNext(before, other));
    assert_eq!(m.next(other), shared);
}

#[test]
fn wrong_faces_are_seen() {
    let m = mesh();
    let h = half_edge(&m, 0, 1);
    let before = half_edge(&m, 2, 0);
    assert_eq!(broken(|m| m.face[h.index()] = Face(1)), Violation::FaceChanges(h));
    assert_eq!(broken(|m| m.face[h.index()] = Face::NONE), Violation::FaceChanges(h));
    assert!(before > h);
    assert_eq!(broken(|m| m.face_half_edge[0] = half_edge(m, 5, 6)), Violation::FaceHalfEdge(Face(0)));
    let second = |m: &mut HalfEdgeMesh| m.fill_loop(half_edge(m, 5, 6), Some(Face(0)));
    // The tetrahedron's face has no half-edges left, which is reported before its second loop.
    assert_eq!(broken(second), Violation::FaceHalfEdge(Face(3)));
    let second = |m: &mut HalfEdgeMesh| {
        second(m);
        m.delete_face(Face(3));
    };
    assert_eq!(broken(second), Violation::SecondLoop(Face(0), half_edge(&m, 5, 6)));
    // An isolated edge, with a face on both of its sides.
    let digon = |m: &mut HalfEdgeMesh| {
        let [h, o] = m.new_edge(MeshVertex(9), MeshVertex(8));
        m.set_next(h, o);
        m.set_next(o, h);
        let f = m.new_face(h);
        m.fill_loop(h, Some(f));
        m.vertex_half_edge[9] = o;
    };
    assert_eq!(broken(digon), Violation::TooFewHalfEdges(Face(7)));
    // Without the face, the edge is in a second ring of vertex 8.
    let wire = |m: &mut HalfEdgeMesh| {
        digon(m);
        m.open_face(Face(7)).unwrap();
    };
    let Violation::SecondRing(MeshVertex(8), h) = broken(wire) else { panic!("a second ring") };
    assert_eq!(h.index(), m.end.len());
}

#[test]
fn wrong_vertices_are_seen() {
    let m = mesh();
    let h = half_edge(&m, 0, 1);
    assert_eq!(broken(|m| m.vertex_half_edge[4] = h), Violation::VertexHalfEdge(MeshVertex(4)));
    // A vertex that has half-edges, but no link to them.
    let into = m.half_edges().find(|&h| m.end(h) == MeshVertex(4)).unwrap();
    assert_eq!(broken(|m| m.vertex_half_edge[4] = HalfEdge::NONE), Violation::SecondRing(MeshVertex(4), into));
    // One vertex shared by the strip and the tetrahedron.
    let merged = |m: &mut HalfEdgeMesh| {
        let all: Vec<HalfEdge> = m.ring(MeshVertex(8)).collect();
        all.into_iter().for_each(|h| m.end[h.index()] = MeshVertex(4));
        m.vertex_half_edge[8] = HalfEdge::NONE;
    };
    assert!(matches!(broken(merged), Violation::SecondRing(MeshVertex(4), _)));
}

#[test]
fn second_edges_are_seen() {
    // Between 0 and 3, in the boundary loop of the strip: the new edge splits the loop in two.
    let m = mesh();
    let doubled = |m: &mut HalfEdgeMesh| {
        let (first, second) = (half_edge(m, 1, 0), half_edge(m, 3, 1));
        assert!(m.is_boundary(first) && m.is_boundary(second) && m.next(second) == first);
        m.link(first, second);
    };
    let Violation::SecondEdge(a, b) = broken(doubled) else { panic!("a second edge") };
    assert_eq!([a, b].map(|h| h.index() < m.end.len()), [true, false]);
    assert!(broken(doubled).to_string().ends_with("join the same vertices"));
}

/// A chain of nexts that runs into a cycle that does not contain its start.
#[test]
fn traversals_end_where_links_never_come_back() {
    let mut m = mesh();
    let h = half_edge(&m, 0, 1);
    let tetrahedron = half_edge(&m, 5, 6);
    m.next[h.index()] = tetrahedron;
    assert_eq!(m.loop_of(h).count(), m.end.len() + 1);
    assert_eq!(m.ring(MeshVertex(1)).count(), m.end.len() + 1);
    assert!(m.vertex_loop(h).count() > 10);
    let from = m.opposite(h);
    assert_eq!(m.previous(from).map(|h| m.next(h)), Some(from));
}
