//! Directions of piercings, and the components of degenerate contacts.

use std::collections::BTreeMap;

use predicament_contacts::algorithm::pairs::{Contact, Contacts};
use predicament_contacts::checks::pairs::{Piercings, Side, piercings};
use predicament_exact::Exact;
use predicament_mesh::{Complex, Simplex, Simplices};
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};

use super::wire_and_skin;

const WHOLE: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

#[test]
fn the_law_is_about_piercings_both_ways() {
    let violated = |forward, backward, undecided, degenerate| {
        let found = Piercings { forward, backward, undecided, degenerate };
        (found.is_applicable(), found.is_violated())
    };
    assert_eq!(violated(0, 0, 0, 0), (true, false));
    assert_eq!(violated(2, 2, 0, 0), (true, false));
    assert_eq!(violated(2, 1, 0, 0), (true, true));
    assert_eq!(violated(1, 2, 0, 0), (true, true));
    assert_eq!(violated(1, 1, 1, 0), (true, true));
    assert_eq!(violated(1, 1, 2, 0), (true, true));
    assert_eq!(violated(2, 1, 1, 1), (false, false));
}

/// A curve of three edges beside a tetrahedron; its first edge is registered to pierce the triangle in the plane z = 0.
/// The edge's ends have these heights.
fn through(heights: [f64; 2]) -> Piercings {
    let [p, q] = heights;
    let points = [
        [0.0, 0.0, 0.0],
        [9.0, 0.0, 0.0],
        [0.0, 9.0, 0.0],
        [2.0, 2.0, 9.0],
        [1.0, 1.0, p],
        [2.0, 1.0, q],
        [20.0, 20.0, 1.0],
    ];
    let scene = Scene::from_points3(&points).unwrap();
    let edges = [[4, 5], [5, 6], [4, 6]].map(|edge| edge.map(Vertex::input)).to_vec();
    let a = Complex::new(&scene, &Simplices { edges, ..Simplices::default() }).unwrap();
    let triangles = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]].map(|three| three.map(Vertex::input)).to_vec();
    let b = Complex::new(&scene, &Simplices { triangles, ..Simplices::default() }).unwrap();
    let session = Exact.prepare(&scene, Off).unwrap();
    let find = |complex: &Complex, vertices: &[usize]| {
        complex.find(&vertices.iter().copied().map(Vertex::input).collect::<Vec<_>>()).unwrap()
    };
    let contact = Contact { a: find(&a, &[4, 5]), b: find(&b, &[0, 1, 2]), on_a: WHOLE, on_b: WHOLE };
    let planted = Contacts { registered: vec![contact], ..Contacts::default() };
    let found = piercings(&session, [&a, &b], Side::B, &planted).unwrap();
    // The same with the complexes in the other order.
    let turned = Contact { a: contact.b, b: contact.a, ..contact };
    let turned = Contacts { registered: vec![turned], ..Contacts::default() };
    assert_eq!(piercings(&session, [&b, &a], Side::A, &turned).unwrap(), found);
    assert_eq!(found.len(), 1);
    found[&[0, 0]]
}

#[test]
fn the_direction_of_a_piercing_is_told_by_the_end_that_is_off_the_plane() {
    let [up, down] = [through([-1.0, 1.0]), through([1.0, -1.0])];
    assert_eq!([up.forward + down.forward, up.backward + down.backward], [1, 1]);
    assert_eq!([up.forward + up.backward, up.undecided, up.degenerate], [1, 0, 0]);
    assert_eq!([through([0.0, 1.0]), through([-1.0, 0.0])], [up; 2]);
    assert_eq!([through([0.0, -1.0]), through([1.0, 0.0])], [down; 2]);
    assert_eq!(through([0.0, 0.0]), Piercings { undecided: 1, ..Piercings::default() });
}

#[test]
fn a_curve_of_the_second_complex_is_counted_like_one_of_the_first() {
    let pair = wire_and_skin([[-9.0, 1.0, 2.0], [9.0, 1.5, 1.0], [1.0, 12.0, 2.0], [1.0, -12.0, 2.5]]);
    let session = Exact.prepare(&pair.scene, Off).unwrap();
    let found = predicament_contacts::algorithm::pairs::contacts(&session, &pair.b, &pair.a);
    let right = piercings(&session, [&pair.b, &pair.a], Side::A, &found).unwrap();
    let known = Piercings { forward: 2, backward: 2, undecided: 0, degenerate: 0 };
    assert_eq!(right, BTreeMap::from([([0, 0], known)]));
}

/// Two curves, and two tetrahedra with one common vertex: a contact belongs to the components that have all of its
/// vertices.
#[test]
fn a_degenerate_contact_is_of_the_components_that_have_all_of_it() {
    let point = |i: u16| [f64::from(i), f64::from(i * i % 7), f64::from(i * i * i % 11)];
    let scene = Scene::from_points3(&(0..13).map(point).collect::<Vec<_>>()).unwrap();
    let edges = [[7, 8], [8, 9], [7, 9], [10, 11], [11, 12], [10, 12]].map(|edge| edge.map(Vertex::input)).to_vec();
    let a = Complex::new(&scene, &Simplices { edges, ..Simplices::default() }).unwrap();
    let faces = |[p, q, r, s]: [usize; 4]| [[p, q, r], [p, q, s], [p, r, s], [q, r, s]];
    let triangles = [faces([0, 1, 2, 3]), faces([3, 4, 5, 6])].concat();
    let triangles = triangles.into_iter().map(|three| three.map(Vertex::input)).collect();
    let b = Complex::new(&scene, &Simplices { triangles, ..Simplices::default() }).unwrap();
    let session = Exact.prepare(&scene, Off).unwrap();
    assert_eq!(session.scene().len(), 13);
    let degenerate = |on_wire: &[usize], on_skin: &[usize]| {
        let find = |complex: &Complex, vertices: &[usize]| -> Simplex {
            complex.find(&vertices.iter().copied().map(Vertex::input).collect::<Vec<_>>()).unwrap()
        };
        let contact = Contact { a: find(&a, on_wire), b: find(&b, on_skin), on_a: WHOLE, on_b: WHOLE };
        let planted = Contacts { registered: vec![contact; 2], ..Contacts::default() };
        let found = piercings(&session, [&a, &b], Side::B, &planted).unwrap();
        assert!(found.values().all(|pair| *pair == Piercings { degenerate: 2, ..Piercings::default() }), "{found:?}");
        found.into_keys().collect::<Vec<_>>()
    };
    assert_eq!(degenerate(&[8], &[1]), [[0, 0]]);
    assert_eq!(degenerate(&[10], &[3]), [[1, 0], [1, 1]]);
    assert_eq!(degenerate(&[8, 9], &[3]), [[0, 0], [0, 1]]);
    assert_eq!(degenerate(&[11], &[2, 3]), [[1, 0]]);
    assert_eq!(degenerate(&[11, 12], &[3, 4]), [[1, 1]]);
    assert_eq!(degenerate(&[7], &[3, 5, 6]), [[0, 1]]);
}
