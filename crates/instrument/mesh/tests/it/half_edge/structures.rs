//! Winged, quad and radial edges: conversions to half-edges and back.

use std::collections::BTreeSet;

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{IndexedFaces, Links, Violation};
use predicament_mesh::structures::{Contradiction, QuadEdges, RadialEdges, Wedge, WingedEdges};
use predicament_predicates::Vertex;

use super::random::{Random, start};
use super::sequence::{KINDS, Sequence};
use super::shapes::{cube, grid, octahedron, polygon_and_fan};

/// Checks each conversion of a mesh and its inverse.
fn round_trips(mesh: &HalfEdgeMesh) -> Links {
    let links = mesh.to_links();
    let back = HalfEdgeMesh::from_links(&links).expect("a mesh");
    assert_eq!(back.to_links(), links);
    let counts = |mesh: &HalfEdgeMesh| [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()];
    assert_eq!(counts(&back), counts(mesh));
    let loops = |mesh: &HalfEdgeMesh| -> BTreeSet<Vec<Vertex>> {
        let of = |h| mesh.vertex_loop(h).map(|v| mesh.scene_vertex(v)).collect();
        mesh.half_edges().map(of).collect()
    };
    assert_eq!(loops(&back), loops(mesh));
    assert_eq!(WingedEdges::new(&links).to_links().as_ref(), Ok(&links));
    assert_eq!(QuadEdges::new(&links).to_links().as_ref(), Ok(&links));
    links
}

#[test]
fn winged_and_quad_edges_are_those_of_the_half_edges() {
    // The edge from 0 to 3 of the cube: its left face is 0, with the corners 0, 3, 2, 1; its right face is 5.
    let links = round_trips(&cube());
    let winged = WingedEdges::new(&links);
    let edge = winged.edges.iter().find(|edge| edge.ends == [0, 3]).expect("an edge");
    assert_eq!(edge.faces, [Some(0), Some(5)]);
    let ends = |at: u32| winged.edges[at as usize].ends.iter().copied().collect::<BTreeSet<u32>>();
    let wings = edge.wings.map(|wings| wings.map(ends));
    assert_eq!(wings, [[[0, 1], [2, 3]], [[3, 7], [0, 4]]].map(|side| side.map(BTreeSet::from)));
    // Around the vertex 0, counterclockwise from outside: 3, 4, 1 or a rotation of it.
    let quad = QuadEdges::new(&links);
    let at = (0..u32::try_from(quad.onext.len()).unwrap()).step_by(2);
    let destination = |edge: u32| quad.origin[QuadEdges::sym(edge) as usize];
    let first = at.clone().find(|&edge| quad.origin[edge as usize] == Some(0) && destination(edge) == Some(3));
    let ring = std::iter::successors(first, |&edge| Some(quad.onext[edge as usize])).take(4).map(destination);
    assert_eq!(ring.collect::<Vec<_>>(), [3, 1, 4, 3].map(Some));
}

#[test]
fn any_mesh_goes_through_other_structures_unchanged() {
    let mut random = Random(11);
    for round in 0..6 {
        let mut sequence = Sequence::new(start(round));
        round_trips(&sequence.mesh);
        for _ in 0..predicament_effort::some_or_all(60, 3_000) {
            if sequence.step(random.next() % KINDS, [random.next(), random.next()]).is_ok() {
                round_trips(&sequence.mesh);
            }
        }
    }
}

#[test]
fn links_that_contradict_each_other_are_found() {
    let links = round_trips(&octahedron());
    let (winged, quad) = (WingedEdges::new(&links), QuadEdges::new(&links));
    for e in 0..winged.edges.len() {
        for (side, wing) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let mut spoiled = winged.clone();
            let was = spoiled.edges[e].wings[side][wing];
            spoiled.edges[e].wings[side][wing] = (was + 1) % 12;
            assert!(matches!(spoiled.to_links(), Err(Contradiction::Edge(_))), "{e} {side} {wing}");
        }
    }
    for e in 0..quad.onext.len() {
        let mut spoiled = quad.clone();
        spoiled.onext[e] = (spoiled.onext[e] + 2) % 48;
        assert!(matches!(spoiled.to_links(), Err(Contradiction::Ring(_))), "{e}");
        let mut spoiled = quad.clone();
        spoiled.origin[e] = spoiled.origin[e].map(|at| (at + 1) % 6);
        assert!(spoiled.to_links().is_err(), "{e}");
    }
    for h in 0..links.half_edges.len() {
        let mut spoiled = links.clone();
        spoiled.half_edges[h].next ^= 1;
        assert!(HalfEdgeMesh::from_links(&spoiled).is_err(), "{h}");
    }
    let mut odd = links;
    odd.half_edges.pop();
    assert!(matches!(HalfEdgeMesh::from_links(&odd), Err(Violation::Link(..))));
}

/// The radial edges of a mesh in which no edge has more than two faces.
fn radial(mesh: &HalfEdgeMesh) -> RadialEdges {
    let (vertices, faces) = mesh.to_indexed();
    RadialEdges::new(vertices, faces, |edge, _| panic!("{edge:?} has more than two faces"))
}

#[test]
fn surfaces_go_through_radial_edges_unchanged() {
    for mesh in [cube(), octahedron(), grid(4, 3, false), grid(4, 5, true), polygon_and_fan(7)] {
        let structure = radial(&mesh);
        for across in [Wedge::Inside, Wedge::Outside] {
            let back = HalfEdgeMesh::from_links(&structure.surfaces(across).expect("one side")).expect("a mesh");
            let corners = |mesh: &HalfEdgeMesh| {
                let (vertices, faces) = mesh.to_indexed();
                faces.iter().map(|face| face.iter().map(|&v| vertices[v as usize]).collect()).collect()
            };
            let mut faces: [Vec<Vec<Vertex>>; 2] = [corners(&mesh), corners(&back)];
            faces.iter_mut().flatten().for_each(|face| {
                let first = (0..face.len()).min_by_key(|&at| face[at]).unwrap_or(0);
                face.rotate_left(first);
            });
            assert_eq!(faces[0], faces[1]);
            assert_eq!([back.vertex_count(), back.edge_count()], [mesh.vertex_count(), mesh.edge_count()]);
        }
    }
}

#[test]
fn a_face_that_is_turned_over_is_found() {
    let (vertices, faces) = cube().to_indexed();
    let turned: IndexedFaces = (0..)
        .zip(faces.iter())
        .map(|(at, face)| {
            let mut face = face.to_vec();
            if at == 2 {
                face.reverse();
            }
            face
        })
        .collect();
    let structure = RadialEdges::new(vertices, turned, |_, _| ());
    for across in [Wedge::Inside, Wedge::Outside] {
        assert!(matches!(structure.surfaces(across), Err(Contradiction::Turned(_))));
    }
}

/// Two cubes that have the edge of their vertices 0 and 1 in common, along z. One has x and y positive, the other
/// negative; `turned` is true for two cavities.
fn two_cubes(turned: bool) -> RadialEdges {
    let [low, high] = [[0, 0, 0], [0, 0, 1]];
    let mut points: Vec<[i32; 3]> = vec![low, high];
    let mut faces = IndexedFaces::default();
    for sign in [1, -1] {
        let mut at = |x: i32, y: i32, z: i32| {
            let point = [sign * x, sign * y, z];
            let known = points.iter().position(|&other| other == point);
            let place = known.unwrap_or_else(|| {
                points.push(point);
                points.len() - 1
            });
            u32::try_from(place).unwrap()
        };
        let [a, b, c, d] = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| at(x, y, 0));
        let [e, f, g, h] = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| at(x, y, 1));
        for mut face in [[a, d, c, b], [e, f, g, h], [a, b, f, e], [b, c, g, f], [c, d, h, g], [d, a, e, h]] {
            if turned {
                face.reverse();
            }
            faces.push(face);
        }
    }
    order(points.len(), faces)
}

/// The radial edges of cubes at the edge of the vertices 0 and 1. In each cube's list the face at y = 0 is the third
/// and the face at x = 0 the sixth.
fn order(vertices: usize, faces: IndexedFaces) -> RadialEdges {
    RadialEdges::new((0..vertices).map(Vertex::input).collect(), faces, |edge, corners| {
        assert_eq!(edge, [0, 1]);
        assert_eq!(corners.len(), 4);
        // Counterclockwise from x: the faces along x, along y, along -x, along -y.
        corners.sort_by_key(|&corner| [2, 5, 8, 11].iter().position(|&face| face == corner / 4));
    })
}

#[test]
fn solids_that_touch_at_an_edge_become_apart_and_come_together_again() {
    let both = two_cubes(false);
    let apart = HalfEdgeMesh::from_links(&both.surfaces(Wedge::Inside).expect("two cubes")).expect("a mesh");
    assert_eq!([apart.vertex_count(), apart.edge_count(), apart.face_count()], [16, 24, 12]);
    let (vertices, faces) = apart.to_indexed();
    let corner = |&at: &u32| u32::try_from(vertices[at as usize].index()).unwrap();
    let together: IndexedFaces = faces.iter().map(|face| face.iter().map(corner).collect::<Vec<_>>()).collect();
    let again = order(14, together);
    assert_eq!(again.vertices, both.vertices);
    // The faces may begin at other corners.
    let sees = |of: &RadialEdges| -> BTreeSet<[u32; 3]> {
        let side = |at: u32| of.faces.corners()[at as usize / 2];
        (0..).zip(&of.radial).map(|(at, &seen)| [at / 8, seen / 8, side(at)]).collect()
    };
    assert_eq!(sees(&again), sees(&both));
    // Joined across the outside, two edges would have the same ends.
    let joined = both.surfaces(Wedge::Outside).expect("one surface");
    assert!(matches!(HalfEdgeMesh::from_links(&joined), Err(Violation::SecondEdge(..))));
    // For cavities it is the other way round.
    let cavities = two_cubes(true);
    let apart = HalfEdgeMesh::from_links(&cavities.surfaces(Wedge::Outside).expect("two")).expect("a mesh");
    assert_eq!(apart.vertex_count(), 16);
    let joined = cavities.surfaces(Wedge::Inside).expect("one surface");
    assert!(matches!(HalfEdgeMesh::from_links(&joined), Err(Violation::SecondEdge(..))));
}

#[test]
fn solids_that_touch_at_a_vertex_become_apart() {
    let faces = [[0_u32, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2], [0, 5, 4], [0, 6, 5], [0, 4, 6], [4, 5, 6]];
    let faces: IndexedFaces = faces.into_iter().collect();
    let both = RadialEdges::new((0..7).map(Vertex::input).collect(), faces, |_, _| panic!("two faces an edge"));
    for across in [Wedge::Inside, Wedge::Outside] {
        let apart = HalfEdgeMesh::from_links(&both.surfaces(across).expect("two")).expect("a mesh");
        assert_eq!([apart.vertex_count(), apart.edge_count(), apart.face_count()], [8, 12, 8]);
        assert_eq!(apart.vertices().filter(|&v| apart.scene_vertex(v) == Vertex::input(0)).count(), 2);
    }
}
