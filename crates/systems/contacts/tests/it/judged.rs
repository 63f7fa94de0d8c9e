//! Merged curves and surfaces of exact, perturbed and damaged contact sets.

mod degenerate;
mod oriented;
mod pierced;

use std::collections::BTreeSet;

use predicament_contacts::algorithm::arrangement::Arrangement;
use predicament_contacts::algorithm::pairs::{Contact, Contacts, contacts};
use predicament_contacts::checks::pairs::{
    Crossings, NotOriented, Piercings, Seat, Side, boundaries, clusters, collapses, crossings, is_embedded, loose_ends,
    oriented_surface, piercings,
};
use predicament_exact::Exact;
use predicament_mesh::{Complex, PolygonMap, Simplex, Simplices};
use predicament_polygon_locate::truth::{Edges, map_flaws};
use predicament_predicates::{Backend, Off, Scene, Sign, Vertex};
use predicament_sos::{Scheme, Sos};
use proptest::prelude::*;

/// Two complexes over the points of one scene.
struct Pair {
    scene: Scene,
    a: Complex,
    b: Complex,
}

impl Pair {
    /// Two closed polygons of the plane.
    fn polygons(a: &[[f64; 2]], b: &[[f64; 2]]) -> Pair {
        let scene = Scene::from_points2(&[a, b].concat()).unwrap();
        let ring = |from: usize, n: usize| {
            let edges = (0..n).map(|i| [from + i, from + (i + 1) % n].map(Vertex::input)).collect();
            Complex::new(&scene, &Simplices { edges, ..Simplices::default() }).unwrap()
        };
        let (a, b) = (ring(0, a.len()), ring(a.len(), b.len()));
        Pair { scene, a, b }
    }

    fn contacts<B: Backend>(&self, backend: &B) -> Contacts {
        contacts(&backend.prepare(&self.scene, Off).unwrap(), &self.a, &self.b)
    }

    fn complexes(&self) -> [&Complex; 2] {
        [&self.a, &self.b]
    }

    fn crossings(&self, contacts: &Contacts, seat: Seat) -> Crossings {
        let arrangement = Arrangement::new(&self.scene, self.complexes(), contacts);
        crossings(&self.scene, self.complexes(), contacts, &arrangement, seat).unwrap()
    }
}

fn vertex_pairs(pairs: &[[u32; 2]]) -> Contacts {
    let vertex = |index| Simplex { rank: 0, index };
    let one = [1.0, 0.0, 0.0, 0.0];
    let contact = |&[a, b]: &[u32; 2]| Contact { a: vertex(a), b: vertex(b), on_a: one, on_b: one };
    Contacts { registered: pairs.iter().map(contact).collect(), ..Contacts::default() }
}

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];

#[test]
fn a_crossing_that_is_not_registered_is_missed_and_named() {
    let pair = Pair::polygons(&SQUARE, &[[2.0, 2.0], [6.0, 2.0], [6.0, 6.0], [2.0, 6.0]]);
    let mut found = pair.contacts(&Exact);
    for seat in Seat::ALL {
        let right = pair.crossings(&found, seat);
        assert_eq!((right.of_edges, right.at_points, right.unfaithful.len()), (2, 0, 0));
    }
    let lost = found.registered.pop().unwrap();
    let wrong = pair.crossings(&found, Seat::A);
    assert!(wrong.is_odd());
    assert_eq!(wrong.unfaithful.len(), 1);
    assert_eq!(wrong.unfaithful[0].edges, [lost.a.index, lost.b.index]);
    assert_eq!((wrong.unfaithful[0].registered, wrong.unfaithful[0].found), (0, 1));
}

#[test]
fn a_crossing_that_is_not_there_is_named_too() {
    let pair = Pair::polygons(&SQUARE, &[[12.0, 2.0], [16.0, 2.0], [16.0, 6.0]]);
    let edge = |index| Simplex { rank: 1, index };
    let half = [0.5, 0.5, 0.0, 0.0];
    let planted = Contacts {
        registered: vec![Contact { a: edge(0), b: edge(0), on_a: half, on_b: half }],
        ..Contacts::default()
    };
    let wrong = pair.crossings(&planted, Seat::Middle);
    assert!(wrong.is_odd());
    assert_eq!((wrong.unfaithful[0].registered, wrong.unfaithful[0].found), (1, 0));
}

#[test]
fn a_chain_counts_once_if_sides_change_and_not_if_they_do_not() {
    // b runs along the square's lower side, comes from below and leaves inwards or downwards
    for (leaves, count) in [([3.5, 2.0], 1), ([3.5, -2.0], 0)] {
        let pair = Pair::polygons(&SQUARE, &[[1.0, 0.0], [3.0, 0.0], leaves, [9.0, 1.0], [9.0, -3.0], [0.0, -3.0]]);
        let along = pair.contacts(&Exact);
        // Without the later crossing, which compensates for it.
        let vertices: Vec<Contact> = along.registered.iter().filter(|contact| contact.b.rank == 0).copied().collect();
        for seat in Seat::ALL {
            let at_chain =
                pair.crossings(&Contacts { registered: vertices.clone(), ..Contacts::default() }, seat).at_points;
            assert_eq!(at_chain % 2, count, "{seat}");
            assert!(!pair.crossings(&along, seat).is_odd());
        }
    }
}

#[test]
fn the_seat_decides_where_edges_go() {
    // All of b is inside the square, and one corner of it is registered with the square's left side, from (0, 0) to (0,
    // 8). If the point is on the side, b touches from within. If the side moves to the corner, even half way, the side
    // passes another corner of b, which is then outside.
    let square = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];
    let pair = Pair::polygons(&square, &[[1.0, 2.0], [0.25, 4.0], [6.0, 3.0]]);
    let side = pair.a.find(&[0, 3].map(Vertex::input)).unwrap();
    let corner = Simplex { rank: 0, index: 0 };
    let contact = Contact { a: side, b: corner, on_a: [0.75, 0.25, 0.0, 0.0], on_b: [1.0, 0.0, 0.0, 0.0] };
    let planted = Contacts { registered: vec![contact], ..Contacts::default() };
    let merged = Seat::ALL.map(|seat| pair.crossings(&planted, seat));
    assert_eq!(merged.each_ref().map(Crossings::is_odd), [false, true, true]);
    let passed = pair.b.find(&[5, 6].map(Vertex::input)).unwrap();
    let named = merged.map(|merged| merged.unfaithful.iter().map(|pair| pair.edges).collect::<Vec<_>>());
    assert_eq!(named, [vec![], vec![[side.index, passed.index]], vec![[side.index, passed.index]]]);
}

#[test]
fn an_open_curve_is_refused_by_its_vertex() {
    let scene = Scene::from_points2(&SQUARE).unwrap();
    let path = |edges: &[[usize; 2]]| {
        let edges = edges.iter().map(|edge| edge.map(Vertex::input)).collect();
        Complex::new(&scene, &Simplices { edges, ..Simplices::default() }).unwrap()
    };
    let (a, b) = (path(&[[0, 1], [1, 2], [0, 2]]), path(&[[0, 1], [1, 3]]));
    let none = Contacts::default();
    let arrangement = Arrangement::new(&scene, [&a, &b], &none);
    let refused = crossings(&scene, [&a, &b], &none, &arrangement, Seat::A).unwrap_err();
    assert_eq!(refused, NotOriented::Open { side: Side::B, vertex: Vertex::input(0), degree: 1 });
    assert!(refused.to_string().contains("complex B is not a closed curve: vertex 0 has 1 edges"));
}

#[test]
fn clusters_and_collapses_are_reported_with_their_sizes() {
    let pair = Pair::polygons(&SQUARE, &[[0.0, 0.0], [9.0, 0.0], [9.0, 9.0]]);
    // b0 is merged with two ends of an edge, b1 with another vertex and the first of these
    let planted = vertex_pairs(&[[0, 0], [1, 0], [1, 1], [3, 2]]);
    let arrangement = Arrangement::new(&pair.scene, pair.complexes(), &planted);
    let found = clusters(&arrangement, &planted);
    assert_eq!(found.len(), 1);
    assert_eq!(
        found[0].vertices,
        [vec![0, 1], vec![4, 5]].map(|side| side.into_iter().map(Vertex::input).collect::<Vec<_>>())
    );
    assert_eq!(found[0].unregistered, 1, "a0 with b1");
    let collapsed = collapses(&arrangement, pair.complexes());
    let edges: Vec<(Side, u32, usize)> = collapsed.iter().map(|c| (c.side, c.edge, c.between)).collect();
    assert_eq!(edges, [(Side::A, 0, 0), (Side::B, 0, 0)]);
    assert_eq!(
        clusters(
            &Arrangement::new(&pair.scene, pair.complexes(), &vertex_pairs(&[[0, 0], [1, 1]])),
            &vertex_pairs(&[[0, 0], [1, 1]])
        ),
        []
    );
}

#[test]
fn an_edge_passes_through_its_vertices_in_the_order_of_their_weights() {
    let pair =
        Pair::polygons(&[[8.0, 0.0], [0.0, 0.0], [4.0, 9.0]], &[[6.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, -3.0]]);
    let found = pair.contacts(&Exact);
    let arrangement = Arrangement::new(&pair.scene, pair.complexes(), &found);
    let path = arrangement.path(Side::A, 0);
    let names: Vec<usize> = path
        .iter()
        .map(|&at| arrangement.points()[at].vertices.iter().flatten().next().expect("vertices only").index())
        .collect();
    assert_eq!(names, [0, 3, 5, 4, 1], "from the edge's lower vertex at x = 8 to the other at x = 0");
}

/// Two vertices on an edge that are so close that their weights do not determine the order, in either order of their
/// indices.
#[test]
fn vertices_on_an_edge_are_in_the_order_of_their_places() {
    let diagonal = [[0.0, 4.0], [24.0, 24.0], [-12.0, -12.0]];
    let [p, q] = [[0.5; 2], [0.5 + 8.0 * f64::EPSILON; 2]];
    let ring = [p, [0.0, 0.0], [0.0, 1.0], q, [1.0, 0.0]];
    for first in 0..ring.len() {
        let mut corners = ring;
        corners.rotate_left(first);
        let pair = Pair::polygons(&diagonal, &corners);
        let found = pair.contacts(&Exact);
        let weights: BTreeSet<u64> = found.registered.iter().map(|contact| contact.on_a[1].to_bits()).collect();
        assert_eq!((found.registered.len(), weights.len()), (3, 2), "p and q have the same weight");
        let arrangement = Arrangement::new(&pair.scene, pair.complexes(), &found);
        let side = pair.a.find(&[1, 2].map(Vertex::input)).unwrap();
        let vertex = |&at: &usize| arrangement.points()[at].vertices.iter().flatten().copied().next();
        let passed: Vec<Vertex> = arrangement.path(Side::A, side.index).iter().filter_map(vertex).collect();
        let places: Vec<&[f64]> = passed.iter().map(|&v| pair.scene.point(v)).collect();
        assert_eq!(places, [[24.0, 24.0], q, p, [0.0, 0.0], [-12.0, -12.0]]);
        for seat in Seat::ALL {
            let merged = pair.crossings(&found, seat);
            assert!(!merged.is_odd() && merged.unfaithful.is_empty(), "{seat}: {merged:?}");
        }
    }
}

/// A vertex on an edge and a crossing close behind it: their weights are one double, which is less than the vertex'
/// position.
#[test]
fn a_vertex_stays_before_a_crossing_with_its_weight() {
    let beside = 1.0 + f64::EPSILON;
    let pair =
        Pair::polygons(&[[0.0, 0.0], [3.0, 0.0], [1.5, -9.0]], &[[1.0, 0.0], [1.0, -1.0], [beside, 1.0], [0.5, 1.0]]);
    let found = pair.contacts(&Exact);
    let side = pair.a.find(&[0, 1].map(Vertex::input)).unwrap();
    let on_side = found.registered.iter().filter(|contact| contact.a == side);
    let weights: Vec<f64> = on_side.map(|contact| contact.on_a[1]).collect();
    assert_eq!(weights, [1.0 / 3.0; 2], "a vertex and a crossing");
    let arrangement = Arrangement::new(&pair.scene, pair.complexes(), &found);
    let is_vertex = |&at: &usize| arrangement.points()[at].vertices.iter().flatten().next().is_some();
    let path: Vec<bool> = arrangement.path(Side::A, side.index).iter().map(is_vertex).collect();
    assert_eq!(path, [true, true, false, true], "end, vertex, crossing, end");
}

fn ring(n: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; 2]>> {
    let coordinate = (0..6_i8).prop_map(f64::from);
    prop::collection::vec([coordinate.clone(), coordinate], n)
}

/// Corners on six lines through the origin: far from it, a few ulps apart, and as close to it as doubles can be.
fn along_lines(n: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; 2]>> {
    let far = prop_oneof![
        4 => (-6..=6_i8).prop_map(|at| f64::from(at) * 4.0),
        6 => (0..12_u8).prop_map(|ulps| 0.5 + f64::from(ulps) * f64::EPSILON / 2.0),
        2 => (0..12_u8).prop_map(|ulps| -3.0 - f64::from(ulps) * f64::EPSILON * 2.0),
        1 => (0..6_u64).prop_map(f64::from_bits),
        1 => (0..6_u64).prop_map(|ulps| f64::from_bits(0x7fd0_0000_0000_0000 + ulps)),
    ];
    let lines = [[1.0, 1.0], [1.0, 0.0], [0.0, 1.0], [1.0, -1.0], [1.0, 2.0], [2.0, 1.0]];
    let line = prop_oneof![3 => Just(lines[0]), 4 => prop::sample::select(lines.to_vec())];
    prop::collection::vec((line, far).prop_map(|([x, y], far)| [x * far, y * far]), n)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(3000)))]

    /// Curves on a small grid, where nearly everything is degenerate: curves through themselves, edges without length,
    /// edges on edges.
    #[test]
    fn exact_and_perturbed_contacts_of_closed_curves_are_even(a in ring(3..8), b in ring(3..8)) {
        let pair = Pair::polygons(&a, &b);
        let exact = pair.contacts(&Exact);
        let sos = [Scheme::PerCoordinate, Scheme::EdelsbrunnerMucke].map(|scheme| pair.contacts(&Sos { scheme }));
        for seat in Seat::ALL {
            let merged = pair.crossings(&exact, seat);
            prop_assert!(!merged.is_odd(), "{seat}: {merged:?}");

            prop_assert_eq!(merged.unfaithful, vec![]);
            for contacts in &sos {
                prop_assert!(!pair.crossings(contacts, seat).is_odd());
            }
        }
    }

    /// Curves on a few lines through one point: most edges lie on each other, and weights do not determine the order of
    /// many vertices on one edge.
    #[test]
    fn curves_along_few_lines_are_even(a in along_lines(3..8), b in along_lines(3..8)) {
        let pair = Pair::polygons(&a, &b);
        let exact = pair.contacts(&Exact);
        for seat in Seat::ALL {
            let merged = pair.crossings(&exact, seat);
            prop_assert!(!merged.is_odd() && merged.unfaithful.is_empty(), "{seat}: {merged:?}");
            for scheme in [Scheme::PerCoordinate, Scheme::EdelsbrunnerMucke] {
                let merged = pair.crossings(&pair.contacts(&Sos { scheme }), seat);
                prop_assert!(!merged.is_odd(), "{scheme}, {seat}: {merged:?}");
            }
        }
    }

    /// Compares with the flaws of a map with only this region.
    #[test]
    fn a_ring_is_embedded_if_it_is_a_map_without_flaws(ring in ring(3..7)) {
        let pair = Pair::polygons(&ring, &SQUARE);
        let exact = Exact.prepare(&pair.scene, Off).unwrap();
        let mut map = PolygonMap::new();
        map.push("ring", vec![(0..ring.len()).map(Vertex::input).collect()]).unwrap();
        let flaws = map_flaws(&Edges::new(&map, &pair.scene), &exact);
        prop_assert_eq!(is_embedded(&exact, &pair.a), flaws.is_empty());
    }

    /// For any registrations: the number of all crossings of closed curves is even, so the registered number is odd
    /// only together with the unregistered one.
    #[test]
    fn odd_counts_are_accounted_for(
        a in ring(3..8), b in ring(3..8), keep in any::<u64>(), merge in prop::collection::vec([0..8_u32, 0..8_u32], 0..4),
    ) {
        let pair = Pair::polygons(&a, &b);
        let mut damaged = pair.contacts(&Exact);
        let mut bit = 0;
        damaged.registered.retain(|_| { bit += 1; keep >> (bit % 64) & 1 == 1 });
        let [n, m] = [a.len(), b.len()].map(|n| u32::try_from(n).unwrap());
        damaged.registered.extend(vertex_pairs(&merge.iter().map(|&[i, j]| [i % n, j % m]).collect::<Vec<_>>()).registered);
        for seat in Seat::ALL {
            let merged = pair.crossings(&damaged, seat);
            let off: usize = merged.unfaithful.iter().map(|pair| pair.registered.abs_diff(pair.found)).sum();
            prop_assert_eq!(merged.is_odd(), !off.is_multiple_of(2));
        }
    }

    /// A second definition of a crossing at one common point, by angles: one curve changes sides of the other if its
    /// arcs leave in different sectors.
    #[test]
    fn a_common_point_counts_as_the_cyclic_order_of_its_arcs(arcs in prop::array::uniform4([-4..=4_i8, -4..=4_i8])) {
        let angle = |[x, y]: [i8; 2]| f64::from(y).atan2(f64::from(x));
        let angles = arcs.map(angle);
        let distinct = (0..4).all(|i| (0..i).all(|j| (angles[i] - angles[j]).abs() > 1e-9));
        prop_assume!(distinct && arcs.iter().all(|arc| *arc != [0, 0]));
        let [a1, a2, b1, b2] = arcs.map(|arc| arc.map(f64::from));
        let pair = Pair::polygons(&[[0.0, 0.0], a1, a2], &[[0.0, 0.0], b1, b2]);
        let between = |angle: f64| (angles[0].min(angles[1])..angles[0].max(angles[1])).contains(&angle);
        let changes = between(angles[2]) != between(angles[3]);
        for seat in Seat::ALL {
            let at_point = pair.crossings(&vertex_pairs(&[[0, 0]]), seat).at_points;
            prop_assert_eq!(at_point % 2 == 1, changes);
        }
    }
}

/// The faces of an octahedron with these corners; opposite corners are consecutive.
fn octahedron(from: usize) -> Vec<[Vertex; 3]> {
    let corners = (0..8_usize).map(|octant| [0, 1, 2].map(|axis| from + 2 * axis + (octant >> axis & 1)));
    corners.map(|triangle| triangle.map(Vertex::input)).collect()
}

fn surfaces(points: &[[f64; 3]]) -> Pair {
    let scene = Scene::from_points3(points).unwrap();
    let of = |from| {
        let triangles = octahedron(from);
        Complex::new(&scene, &Simplices { triangles, ..Simplices::default() }).unwrap()
    };
    let (a, b) = (of(0), of(6));
    Pair { scene, a, b }
}

const TWO_OCTAHEDRA: [[f64; 3]; 12] = [
    [8.0, 0.0, 0.0],
    [-8.0, 0.0, 0.0],
    [0.0, 8.0, 0.0],
    [0.0, -8.0, 0.0],
    [0.0, 0.0, 8.0],
    [0.0, 0.0, -8.0],
    [13.0, 1.0, 2.0],
    [-3.0, 1.0, 2.0],
    [5.0, 9.0, 2.0],
    [5.0, -7.0, 2.0],
    [5.0, 1.0, 10.0],
    [5.0, 1.0, -6.0],
];

#[test]
fn a_lost_piercing_leaves_loose_ends() {
    let pair = surfaces(&TWO_OCTAHEDRA);
    let found = pair.contacts(&Exact);
    let ends = |contacts: &Contacts| {
        loose_ends(pair.complexes(), contacts, &Arrangement::new(&pair.scene, pair.complexes(), contacts)).unwrap()
    };
    let right = ends(&found);
    assert!(right.piercings >= 6 && right.loose.is_empty(), "{right:?}");
    assert_eq!(right.pieces, right.piercings, "a closed curve has as many pieces as points");
    for lost in 0..found.registered.len() {
        let mut damaged = found.clone();
        damaged.registered.remove(lost);
        let wrong = ends(&damaged);
        assert!(wrong.loose.len() >= 2 && wrong.loose.iter().any(|end| end.others == 0), "{wrong:?}");
    }
}

#[test]
fn a_lost_piercing_makes_boundaries_odd() {
    let pair = surfaces(&TWO_OCTAHEDRA);
    let found = pair.contacts(&Exact);
    let right = boundaries(pair.complexes(), &found).unwrap();
    assert!(right.checked >= 6 && right.degenerate == 0 && right.odd.is_empty(), "{right:?}");
    for lost in 0..found.registered.len() {
        let mut damaged = found.clone();
        let edge = damaged.registered.remove(lost);
        let side = if edge.a.rank == 1 { Side::A } else { Side::B };
        let wrong = boundaries(pair.complexes(), &damaged).unwrap();
        assert_eq!(wrong.odd.len(), 2, "the edge's two triangles");
        assert!(wrong.odd.iter().all(|&(of, _)| of == side), "{wrong:?}");
    }
    let mut merged = found;
    merged.registered.splice(0..0, vertex_pairs(&[[0, 0]]).registered);
    assert_eq!(boundaries(pair.complexes(), &merged).unwrap().degenerate, 8, "four triangles of each surface");
}

#[test]
fn surfaces_that_cross_or_touch_themselves_are_not_embedded() {
    let embedded = |points: &[[f64; 3]]| {
        let pair = surfaces(points);
        let exact = Exact.prepare(&pair.scene, Off).unwrap();
        pair.complexes().map(|complex| is_embedded(&exact, complex))
    };
    assert_eq!(embedded(&TWO_OCTAHEDRA), [true; 2]);
    // One vertex on another, edges that cross, an edge through a triangle, a vertex in a triangle.
    for through in
        [[-8.0, 0.0, 0.0], [0.0, 0.0, 8.0], [0.0, 9.0, 9.0], [-4.0, 9.0, 0.0], [-4.0, 9.0, 1.0], [-4.0, 2.0, 2.0]]
    {
        let mut points = TWO_OCTAHEDRA;
        points[0] = through;
        assert_eq!(embedded(&points), [false, true], "{through:?}");
    }
}

#[test]
fn an_open_surface_has_a_border() {
    let scene = Scene::from_points3(&TWO_OCTAHEDRA).unwrap();
    let of = |from, faces: usize| {
        let triangles = octahedron(from)[..faces].to_vec();
        Complex::new(&scene, &Simplices { triangles, ..Simplices::default() }).unwrap()
    };
    let (a, b) = (of(0, 8), of(6, 7));
    let none = Contacts::default();
    let refused = loose_ends([&a, &b], &none, &Arrangement::new(&scene, [&a, &b], &none)).unwrap_err();
    assert!(matches!(refused, NotOriented::Border { side: Side::B, degree: 1, .. }), "{refused}");
    assert_eq!(boundaries([&a, &b], &none), Err(refused));
}

#[test]
fn a_tetrahedron_has_two_sides_and_a_projective_plane_one() {
    let scene = Scene::from_points3(&TWO_OCTAHEDRA).unwrap();
    let of = |triangles: &[[usize; 3]]| {
        let triangles = triangles.iter().map(|triangle| triangle.map(Vertex::input)).collect();
        Complex::new(&scene, &Simplices { triangles, ..Simplices::default() }).unwrap()
    };
    let tetrahedron = of(&[[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]);
    let oriented = oriented_surface(&tetrahedron, Side::A).unwrap();
    let mut directed = BTreeSet::new();
    for (&[a, b, c], (component, sign)) in tetrahedron.triangles().iter().zip(oriented) {
        assert_eq!(component, 0);
        let [first, second] = if sign == Sign::Positive { [b, c] } else { [c, b] };
        directed.extend([[a, first], [first, second], [second, a]]);
    }
    assert_eq!(directed.len(), 12, "each edge once in either direction");

    let around = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 1]];
    let across = [[1, 2, 4], [2, 3, 5], [3, 4, 1], [4, 5, 2], [5, 1, 3]];
    let plane = of(&[around, across].concat());
    assert_eq!(oriented_surface(&plane, Side::B), Err(NotOriented::OneSided { side: Side::B }));
}

/// A closed curve of four edges through the octahedron, and the octahedron.
fn wire_and_skin(wire: [[f64; 3]; 4]) -> Pair {
    let scene = Scene::from_points3(&[&TWO_OCTAHEDRA[..6], &wire].concat()).unwrap();
    let edges = (0..4).map(|i| [6 + i, 6 + (i + 1) % 4].map(Vertex::input)).collect();
    let a = Complex::new(&scene, &Simplices { edges, ..Simplices::default() }).unwrap();
    let triangles = octahedron(0);
    let b = Complex::new(&scene, &Simplices { triangles, ..Simplices::default() }).unwrap();
    Pair { scene, a, b }
}

#[test]
fn a_curve_leaves_a_surface_as_often_as_it_enters() {
    let pair = wire_and_skin([[-9.0, 1.0, 2.0], [9.0, 1.5, 1.0], [1.0, 12.0, 2.0], [1.0, -12.0, 2.5]]);
    let exact = Exact.prepare(&pair.scene, Off).unwrap();
    let found = pair.contacts(&Exact);
    let through = |contacts: &Contacts| piercings(&exact, pair.complexes(), Side::B, contacts).unwrap();
    let right = through(&found);
    let all: Vec<_> = right.iter().collect();
    assert_eq!(all, [(&[0, 0], &Piercings { forward: 2, backward: 2, undecided: 0, degenerate: 0 })]);
    for lost in 0..found.registered.len() {
        let mut damaged = found.clone();
        damaged.registered.remove(lost);
        assert!(through(&damaged)[&[0, 0]].is_violated());
    }
    // A curve on a corner: the law doesn't apply, and the result says so.
    let pair = wire_and_skin([[8.0, 0.0, 0.0], [20.0, 1.0, 0.0], [20.0, 9.0, 3.0], [11.0, 9.0, -5.0]]);
    let exact = Exact.prepare(&pair.scene, Off).unwrap();
    let touching = piercings(&exact, pair.complexes(), Side::B, &pair.contacts(&Exact)).unwrap();
    assert!(touching[&[0, 0]].degenerate == 1 && !touching[&[0, 0]].is_applicable());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(600)))]

    #[test]
    fn exact_and_perturbed_surfaces_have_no_loose_ends(
        points in prop::collection::vec(prop::array::uniform3((0..5_i8).prop_map(f64::from)), 12),
    ) {
        let pair = surfaces(&points);
        let loose = |contacts: &Contacts| {
            loose_ends(pair.complexes(), contacts, &Arrangement::new(&pair.scene, pair.complexes(), contacts)).unwrap()
        };
        let ends = loose(&pair.contacts(&Exact));
        prop_assert_eq!(&ends.loose, &vec![], "{:?}", ends);
        let odd = |contacts: &Contacts| boundaries(pair.complexes(), contacts).unwrap().odd;
        prop_assert_eq!(odd(&pair.contacts(&Exact)), vec![]);
        for scheme in [Scheme::PerCoordinate, Scheme::EdelsbrunnerMucke] {
            let ends = loose(&pair.contacts(&Sos { scheme }));
            prop_assert_eq!(&ends.loose, &vec![], "{}", scheme);
            prop_assert_eq!(ends.overlaps, 0);
            prop_assert_eq!(odd(&pair.contacts(&Sos { scheme })), vec![]);
        }
    }

    #[test]
    fn exact_and_perturbed_curves_pierce_as_often_both_ways(
        points in prop::collection::vec(prop::array::uniform3((0..6_i8).prop_map(f64::from)), 10),
    ) {
        let scene = Scene::from_points3(&points).unwrap();
        let edges = (0..4).map(|i| [6 + i, 6 + (i + 1) % 4].map(Vertex::input)).collect();
        let a = Complex::new(&scene, &Simplices { edges, ..Simplices::default() }).unwrap();
        let triangles = octahedron(0);
        let b = Complex::new(&scene, &Simplices { triangles, ..Simplices::default() }).unwrap();
        let pair = Pair { scene, a, b };
        let exact = Exact.prepare(&pair.scene, Off).unwrap();
        let found = piercings(&exact, pair.complexes(), Side::B, &pair.contacts(&Exact)).unwrap();
        prop_assert!(found.values().all(|pair| !pair.is_violated()), "{found:?}");
        let sos = Sos::default();
        let session = sos.prepare(&pair.scene, Off).unwrap();
        let found = piercings(&session, pair.complexes(), Side::B, &pair.contacts(&sos)).unwrap();
        prop_assert!(found.values().all(|pair| pair.is_applicable() && !pair.is_violated()), "{found:?}");
    }
}
