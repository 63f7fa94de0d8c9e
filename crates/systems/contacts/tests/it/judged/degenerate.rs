//! Contacts that affect other contacts: crossings at merged points, clusters on edges, triangles in one plane.

use predicament_contacts::algorithm::arrangement::Arrangement;
use predicament_contacts::algorithm::pairs::{Contact, Contacts};
use predicament_contacts::checks::pairs::{Seat, boundaries, clusters, collapses, loose_ends};
use predicament_exact::Exact;
use predicament_mesh::{Complex, Simplex, Simplices};
use predicament_predicates::{Scene, Vertex};

use super::{Pair, SQUARE, TWO_OCTAHEDRA, surfaces, vertex_pairs};

const OTHER: [[f64; 2]; 4] = [[2.0, 2.0], [6.0, 2.0], [6.0, 6.0], [2.0, 6.0]];
const HALF: [f64; 4] = [0.5, 0.5, 0.0, 0.0];
const WHOLE: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

#[test]
fn a_crossing_of_edges_with_a_common_merged_point_is_that_point() {
    let pair = Pair::polygons(&SQUARE, &OTHER);
    let exact = pair.contacts(&Exact);
    let merged = |pairs: &[[u32; 2]]| {
        let mut found = exact.clone();
        found.registered.splice(0..0, vertex_pairs(pairs).registered);
        Seat::ALL.map(|seat| {
            let merged = pair.crossings(&found, seat);
            assert_eq!(merged.count(), merged.of_edges + merged.at_points);
            (merged.of_edges, merged.absorbed)
        })
    };
    assert_eq!(merged(&[]), [(2, 0); 3]);
    // The corner (4, 4) and the other curve's (2, 2) are on both pairs of edges that cross, and (4, 0) and (6, 2) on
    // one.
    assert_eq!(merged(&[[2, 0]]), [(0, 2); 3]);
    assert_eq!(merged(&[[1, 1]]), [(1, 1); 3]);
    assert_eq!(merged(&[[0, 2]]), [(2, 0); 3]);
}

#[test]
fn a_vertex_on_an_edge_is_no_crossing_of_edges() {
    let pair = Pair::polygons(&SQUARE, &[[4.0, 2.0], [9.0, 1.0], [9.0, 3.0]]);
    let found = pair.contacts(&Exact);
    assert_eq!(found.registered.len(), 1);
    for seat in Seat::ALL {
        let merged = pair.crossings(&found, seat);
        assert_eq!((merged.of_edges, merged.absorbed, merged.unfaithful.len()), (0, 0, 0), "{seat}");
    }
}

#[test]
fn only_pairs_of_vertices_count_as_registered_in_a_cluster() {
    let pair = Pair::polygons(&SQUARE, &[[0.0, 0.0], [9.0, 0.0], [9.0, 9.0]]);
    // One corner of the triangle is merged with two corners of the square, and with a side and another point of it.
    let mut planted = vertex_pairs(&[[0, 0], [1, 0]]);
    let sides = [[2, 3], [1, 2]].map(|side| pair.a.find(&side.map(Vertex::input)).unwrap());
    let corner = Simplex { rank: 0, index: 0 };
    planted.registered.extend(sides.map(|side| Contact { a: side, b: corner, on_a: HALF, on_b: WHOLE }));
    let edge = pair.b.find(&[4, 5].map(Vertex::input)).unwrap();
    planted.registered.push(Contact { a: corner, b: edge, on_a: WHOLE, on_b: HALF });
    let arrangement = Arrangement::new(&pair.scene, pair.complexes(), &planted);
    let found = clusters(&arrangement, &planted);
    assert_eq!(found.len(), 1);
    assert_eq!((found[0].vertices.each_ref().map(Vec::len), found[0].unregistered), ([2, 1], 0));
}

#[test]
fn an_edge_that_collapsed_may_still_pass_another_point() {
    let pair = Pair::polygons(&SQUARE, &[[0.0, 0.0], [9.0, 9.0], [2.0, -1.0]]);
    // Both ends of the square's lower side are merged with one corner, and its middle with another corner.
    let mut planted = vertex_pairs(&[[0, 0], [1, 0]]);
    let side = pair.a.find(&[0, 1].map(Vertex::input)).unwrap();
    planted.registered.push(Contact { a: side, b: Simplex { rank: 0, index: 2 }, on_a: HALF, on_b: WHOLE });
    let arrangement = Arrangement::new(&pair.scene, pair.complexes(), &planted);
    let found = collapses(&arrangement, pair.complexes());
    assert_eq!(found.iter().map(|c| (c.edge, c.between)).collect::<Vec<_>>(), [(side.index, 1)]);
}

/// Two tetrahedra that stand on one plane from either side; their triangles there form a star.
#[test]
fn triangles_in_one_plane_overlap() {
    let points = [
        [0.0, 0.0, 0.0],
        [6.0, 0.0, 0.0],
        [3.0, 6.0, 0.0],
        [3.0, 2.0, 5.0],
        [0.0, 4.0, 0.0],
        [6.0, 4.0, 0.0],
        [3.0, -2.0, 0.0],
        [3.0, 2.0, -5.0],
    ];
    let scene = Scene::from_points3(&points).unwrap();
    let of = |from: usize| {
        let faces = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];
        let triangles = faces.map(|face| face.map(|corner: usize| Vertex::input(from + corner))).to_vec();
        Complex::new(&scene, &Simplices { triangles, ..Simplices::default() }).unwrap()
    };
    let pair = Pair { a: of(0), b: of(4), scene };
    let found = pair.contacts(&Exact);
    let arrangement = Arrangement::new(&pair.scene, pair.complexes(), &found);
    let ends = loose_ends(pair.complexes(), &found, &arrangement).unwrap();
    assert_eq!((ends.piercings, ends.overlaps, ends.loose), (0, 1, vec![]));
    // Six crossings of edges: every triangle has a crossing on its boundary.
    let found = boundaries(pair.complexes(), &found).unwrap();
    assert_eq!((found.checked, found.degenerate, found.odd), (0, 8, vec![]));
}

#[test]
fn boundaries_without_a_contact_are_not_checked() {
    let pair = surfaces(&TWO_OCTAHEDRA);
    let found = pair.contacts(&Exact);
    let none = boundaries(pair.complexes(), &Contacts::default()).unwrap();
    assert_eq!((none.checked, none.degenerate), (0, 0));
    let pierces = |complex: &Complex, own: fn(&Contact) -> Simplex, triangle: &[Vertex; 3]| {
        let on_edge = |edge: Simplex| complex.vertices_of(edge).iter().all(|vertex| triangle.contains(vertex));
        found.registered.iter().map(own).any(|own| own.rank == 1 && on_edge(own))
    };
    let of_a = pair.a.triangles().iter().filter(|t| pierces(&pair.a, |contact| contact.a, t)).count();
    let of_b = pair.b.triangles().iter().filter(|t| pierces(&pair.b, |contact| contact.b, t)).count();
    let right = boundaries(pair.complexes(), &found).unwrap();
    assert_eq!(right.checked, of_a + of_b);
    assert!(right.checked < 16, "{right:?}");
}
