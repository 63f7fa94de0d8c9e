//! Tests of the locations of merged points.

use crate::answer::{Contact, Contacts};
use predicament_mesh::Simplices;

use super::*;

const WHOLE: Weights = [1.0, 0.0, 0.0, 0.0];

/// A triangle with the corners 0, 1 and 2, and an edge from 3 to 4.
struct Pair {
    scene: Scene,
    a: Complex,
    b: Complex,
}

impl Pair {
    fn new(edge: [[f64; 2]; 2]) -> Pair {
        let corners = [[2.0, 4.0], [10.0, 8.0], [4.0, -6.0]];
        let scene = Scene::from_points2(&[&corners[..], &edge].concat()).unwrap();
        let triangles = vec![[0, 1, 2].map(Vertex::input)];
        let a = Complex::new(&scene, &Simplices { triangles, ..Simplices::default() }).unwrap();
        let edges = vec![[3, 4].map(Vertex::input)];
        let b = Complex::new(&scene, &Simplices { edges, ..Simplices::default() }).unwrap();
        Pair { scene, a, b }
    }

    /// A contact of the edge's first vertex with a simplex of the triangle, at these weights.
    fn first_on(&self, simplex: &[usize], on_a: Weights) -> Contact {
        let vertices: Vec<Vertex> = simplex.iter().copied().map(Vertex::input).collect();
        let b = self.b.find(&[Vertex::input(3)]).unwrap();
        Contact { a: self.a.find(&vertices).unwrap(), b, on_a, on_b: WHOLE }
    }

    /// The location of the point with this vertex, or of a crossing without vertices.
    fn places(&self, contacts: &[Contact], seat: Seat, vertex: usize) -> [f64; 2] {
        let contacts = Contacts { registered: contacts.to_vec(), ..Contacts::default() };
        let complexes = [&self.a, &self.b];
        let arrangement = Arrangement::new(&self.scene, complexes, &contacts);
        let seated = Seated::new(&self.scene, complexes, &arrangement, seat);
        let has = |point: &MergedPoint| point.vertices.iter().flatten().any(|v| v.index() == vertex);
        let at = arrangement.points().iter().position(has).unwrap();
        // The vertex 2 is not merged, and gives the common denominator.
        let alone = arrangement.points().iter().position(|point| point.vertices[0] == [Vertex::input(2)]).unwrap();
        let unit = Rational::from((seated.at(alone)[0].clone(), 4));
        let place = seated.at(at).each_ref().map(|x| (Rational::from(x) / &unit).to_f64());
        assert_eq!(seated.about[at], Some(place), "exact in doubles");
        place
    }

    fn at_all_seats(&self, contact: Contact) -> [[f64; 2]; 3] {
        [Seat::A, Seat::B, Seat::Middle].map(|seat| self.places(&[contact], seat, 3))
    }
}

const A_QUARTER: Weights = [0.75, 0.25, 0.0, 0.0];

#[test]
fn a_vertex_on_an_edge_moves_to_its_weights_or_the_edge_to_it() {
    let pair = Pair::new([[5.0, 10.0], [20.0, 20.0]]);
    let contact = pair.first_on(&[0, 1], A_QUARTER);
    assert_eq!(pair.at_all_seats(contact), [[4.0, 5.0], [5.0, 10.0], [4.5, 7.5]]);
    // A point on the line keeps its place.
    let pair = Pair::new([[8.0, 7.0], [20.0, 20.0]]);
    let contact = pair.first_on(&[0, 1], A_QUARTER);
    assert_eq!(pair.at_all_seats(contact), [[8.0, 7.0]; 3]);
}

#[test]
fn vertices_that_were_merged_are_at_one_of_them_or_half_way() {
    let pair = Pair::new([[5.0, 10.0], [20.0, 20.0]]);
    let contact = pair.first_on(&[0], WHOLE);
    assert_eq!(pair.at_all_seats(contact), [[2.0, 4.0], [5.0, 10.0], [3.5, 7.0]]);
    assert_eq!(pair.places(&[contact], Seat::A, 1), [10.0, 8.0]);
    assert_eq!(pair.places(&[contact], Seat::A, 4), [20.0, 20.0]);
}

#[test]
fn an_edge_goes_from_where_its_ends_were_merged() {
    // The corner 1 is merged with the corner 0 through the other edge's end, so the edge 0–1 has no length.
    let pair = Pair::new([[5.0, 10.0], [20.0, 20.0]]);
    let ends = [pair.first_on(&[0], WHOLE), pair.first_on(&[1], WHOLE)];
    assert_eq!(pair.places(&ends, Seat::A, 1), [2.0, 4.0]);
    // The edge 1–2 then begins there.
    let second =
        Contact { b: pair.b.find(&[Vertex::input(4)]).unwrap(), ..pair.first_on(&[1, 2], [0.5, 0.5, 0.0, 0.0]) };
    assert_eq!(pair.places(&[ends[0], ends[1], second], Seat::A, 4), [3.0, -1.0]);
}

#[test]
fn a_vertex_in_a_triangle_of_the_plane_stays_where_it_is() {
    let pair = Pair::new([[5.0, 3.0], [20.0, 20.0]]);
    let contact = pair.first_on(&[0, 1, 2], [0.5, 0.25, 0.25, 0.0]);
    assert_eq!(pair.at_all_seats(contact), [[5.0, 3.0]; 3]);
}
