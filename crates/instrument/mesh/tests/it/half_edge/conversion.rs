//! Conversion from indexed faces and back, and refused faces.

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{ConversionError, IndexedFaces};
use predicament_predicates::Vertex;
use proptest::prelude::*;

use super::loops::Loops;
use super::shapes::{cube, grid, mesh, octahedron};

fn v(index: usize) -> Vertex {
    Vertex::input(index)
}

#[test]
fn faces_come_back_as_they_were() {
    for mesh in [octahedron(), cube(), grid(3, 2, false), grid(3, 4, true)] {
        assert_eq!(mesh.validate(), Ok(()));
        assert_eq!(Loops::of(&mesh).check(), Ok(()));
        let (vertices, faces) = mesh.to_indexed();
        let again = HalfEdgeMesh::new(vertices.clone(), &faces).unwrap();
        assert_eq!(again.to_indexed(), (vertices, faces));
        assert_eq!(Loops::of(&again), Loops::of(&mesh));
    }
    let triangles = [[0, 1, 2], [2, 1, 3]];
    let (vertices, again) = mesh(5, &triangles).unwrap().to_triangles().unwrap();
    assert_eq!((vertices.len(), again), (5, triangles.to_vec()));
    let faces: Vec<usize> = mesh(4, &[&[0, 1, 2][..], &[2, 1, 3, 0]]).unwrap().faces().map(|f| f.index()).collect();
    assert_eq!(faces, [0, 1]);
    let refused = mesh(4, &[&[0, 1, 2][..], &[2, 1, 3, 0]]).unwrap().to_triangles().unwrap_err();
    assert_eq!(refused.to_string(), "f1");
    assert_eq!(HalfEdgeMesh::new(Vec::new(), &IndexedFaces::default()).unwrap().validate(), Ok(()));
}

#[test]
fn euler_counts_of_known_shapes() {
    let counts = |mesh: &HalfEdgeMesh| Loops::of(mesh).counts();
    assert_eq!(counts(&octahedron()), [6, 12, 8, 0]);
    assert_eq!(counts(&cube()), [8, 12, 6, 0]);
    assert_eq!(counts(&grid(3, 2, false)), [12, 17, 6, 1]);
    assert_eq!(counts(&grid(3, 4, true)), [12, 24, 12, 0]);
    let torus = grid(3, 4, true);
    assert_eq!((torus.vertex_count(), torus.edge_count(), torus.face_count()), (12, 24, 12));
}

#[test]
fn faces_over_a_scene_and_over_constructed_vertices() {
    let faces = [[v(0), v(1), v(2)], [v(2), v(1), v(4)]];
    let mesh = HalfEdgeMesh::of_scene(5, &faces).unwrap();
    let alone: Vec<usize> = mesh.vertices().filter(|&v| mesh.degree(v) == 0).map(|v| v.index()).collect();
    assert_eq!(alone, [3]);
    let refused = HalfEdgeMesh::of_scene(4, &faces).unwrap_err();
    assert_eq!(refused, ConversionError::NoSuchVertex { face: 1, corner: 4, vertices: 4 });
    let c = Vertex::constructed(7);
    let constructed = HalfEdgeMesh::new(vec![v(3), c, v(0)], &[[0, 1, 2]].into_iter().collect()).unwrap();
    assert_eq!(Loops::of(&constructed).faces, [[v(0), v(3), c]]);
    assert!(HalfEdgeMesh::of_scene(4, &[[v(0), v(1), c]]).is_err());
}

#[test]
fn what_is_no_manifold_is_refused_by_edge_and_vertex() {
    let refused = |vertices, faces: &[&[u32]]| mesh(vertices, faces).expect_err("refused").to_string();
    for (got, expected) in [
        (refused(4, &[&[0, 1, 2], &[0, 1]]), "face 1 has 2 corners; give it three, or remove it"),
        (refused(3, &[&[0, 1, 3]]), "face 0 has corner 3, which is not one of the 3 vertices; correct the index"),
        (refused(3, &[&[9, 1, 2]]), "face 0 has corner 9, which is not one of the 3 vertices; correct the index"),
        (refused(4, &[&[0, 1, 2, 1]]), "face 0 has vertex 1 twice; divide it, or remove it"),
        (refused(3, &[&[1, 1, 2]]), "face 0 has vertex 1 twice; divide it, or remove it"),
        (
            refused(4, &[&[0, 1, 2], &[3, 0, 1]]),
            "faces 0 and 1 both go from vertex 0 to vertex 1; reverse the corners of one, or remove one if they are the same",
        ),
        (
            refused(4, &[&[2, 1, 0], &[3, 1, 0]]),
            "faces 0 and 1 both go from vertex 1 to vertex 0; reverse the corners of one, or remove one if they are the same",
        ),
        (
            refused(5, &[&[0, 1, 2], &[1, 0, 3], &[1, 0, 4]]),
            "the edge of vertices 0 and 1 has more than two faces, 0, 1 and 2 among them; \
             remove all but two, or give the others vertices of their own",
        ),
        (
            refused(6, &[&[2, 1, 0], &[3, 2, 1], &[4, 5, 1], &[4, 2, 1], &[1, 2, 5]]),
            "the edge of vertices 1 and 2 has more than two faces, 0, 1 and 3 among them; \
             remove all but two, or give the others vertices of their own",
        ),
        // Two tetrahedra that share a vertex.
        (
            refused(
                7,
                &[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0], &[0, 4, 5], &[0, 6, 4], &[4, 6, 5], &[5, 6, 0]],
            ),
            "faces close around vertex 0, and it has more faces; give these a vertex of their own",
        ),
        // A tetrahedron and a triangle that share a vertex.
        (
            refused(6, &[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0], &[3, 4, 5]]),
            "faces close around vertex 3, and it has more faces; give these a vertex of their own",
        ),
    ] {
        assert_eq!(got, expected);
    }
}

#[test]
fn open_fans_at_one_vertex_are_one_ring() {
    // Three triangles that share vertex 0 and nothing else.
    let pinched = mesh(7, &[[0, 1, 2], [0, 3, 4], [0, 5, 6]]).unwrap();
    assert_eq!(pinched.validate(), Ok(()));
    let shared = pinched.vertices().next().unwrap();
    assert_eq!((pinched.degree(shared), pinched.gaps(shared)), (6, 3));
    let loops = Loops::of(&pinched);
    assert_eq!(loops.check(), Ok(()));
    assert_eq!((loops.boundaries.len(), loops.boundaries[0].len()), (1, 9));
}

/// True if faces make a mesh, by brute force. The corners are valid.
fn is_manifold(faces: &[Vec<u32>]) -> bool {
    let sides =
        |face: &[u32]| -> Vec<[u32; 2]> { (0..face.len()).map(|at| [face[at], face[(at + 1) % face.len()]]).collect() };
    let all: Vec<[u32; 2]> = faces.iter().flat_map(|face| sides(face)).collect();
    let directed_once = all.iter().all(|edge| all.iter().filter(|other| *other == edge).count() == 1);
    // At a vertex, two corners are linked if the outgoing edge of one is the incoming edge of the other. A closed chain
    // must contain all corners.
    let single = |v: u32| {
        let corners: Vec<[u32; 2]> = faces
            .iter()
            .filter_map(|face| {
                let at = face.iter().position(|&corner| corner == v)?;
                Some([face[(at + face.len() - 1) % face.len()], face[(at + 1) % face.len()]])
            })
            .collect();
        corners.iter().all(|first| {
            let (mut current, mut steps) = (first, 1);
            while let Some(next) = corners.iter().find(|corner| corner[1] == current[0]) {
                if next == first {
                    return steps == corners.len();
                }
                (current, steps) = (next, steps + 1);
            }
            true
        })
    };
    directed_once && (0..8).all(single)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(20_000)))]

    #[test]
    fn any_faces_make_a_valid_mesh_or_are_refused(
        faces in prop::collection::vec(prop::sample::subsequence((0..7_u32).collect::<Vec<_>>(), 3..5).prop_shuffle(), 0..6)
    ) {
        let made = mesh(7, &faces);
        prop_assert_eq!(made.is_ok(), is_manifold(&faces), "{:?}", made);
        if let Ok(mesh) = made {
            prop_assert_eq!(mesh.validate(), Ok(()));
            let loops = Loops::of(&mesh);
            prop_assert_eq!(loops.check(), Ok(()));
            let listed: IndexedFaces = faces.iter().map(|face| face.iter().copied()).collect();
            prop_assert_eq!(mesh.to_indexed().1, listed);
        }
    }
}
