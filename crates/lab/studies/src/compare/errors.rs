//! The distance of registered contacts from the points where the simplices meet, in rationals.
//!
//! A pair that meets exactly as registered has exact weights, and a position. A scheme with tolerances also registers
//! other pairs: for example two vertices for an edge that passes one of them closely. The error of such a contact is
//! its distance to the nearest point where the two complexes meet. Conversely, the error of each point where they meet
//! is its distance to the nearest registered contact.

use predicament_contacts::algorithm::pairs::{Contact, Contacts, Weights};
use predicament_contacts::task::Complexes;
use predicament_judge::contacts::{contact, contacts};
use predicament_judge::rational;
use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Dimension, Scene, Vertex};
use predicament_records::Spread;
use predicament_tolerance::{Tolerances2d, Tolerances3d};
use rug::Rational;

/// The maximum number of registered contacts that are measured in a scene, at even steps.
const LOOKED_AT: usize = 400;

/// The errors of contacts.
#[derive(Clone, PartialEq, Default, Debug)]
pub(super) struct Errors {
    /// Distances of contacts from the nearest point where the complexes meet, in scene units, on both simplices.
    pub location: Vec<f64>,
    /// The location errors in units of the scene's L.
    pub location_over_l: Vec<f64>,
    /// Largest differences of a weight from the exact one.
    pub weight: Vec<f64>,
    /// Distances of points where the complexes meet from the nearest registered contact, in units of L.
    pub missed_over_l: Vec<f64>,
    /// The number of contacts of simplices that do not meet, or not in a unique point.
    pub apart: u64,
    /// The number of contacts in scenes where nothing meets.
    pub alone: u64,
    /// The number of contacts that were measured.
    pub looked_at: u64,
}

/// The quantiles of errors at a quarter, half, 99 % and all.
pub(super) struct Tail {
    pub quartile: f64,
    pub median: f64,
    pub most: f64,
    pub max: f64,
}

/// The tail of errors; `None` if there are none.
pub(super) fn tail(errors: &[f64]) -> Option<Tail> {
    let mut sorted = errors.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let at = |percent: usize| sorted[((sorted.len() * percent).div_ceil(100)).clamp(1, sorted.len()) - 1];
    let spread = Spread::of(errors.iter().copied())?;
    Some(Tail { quartile: at(25), median: spread.median, most: at(99), max: spread.max })
}

impl Errors {
    /// Adds the contacts of a scene.
    pub fn add(&mut self, scene: &Scene, content: &Complexes, found: &Contacts, exact_places: &[Vec<f64>]) {
        let length = length(scene, content);
        let step = found.registered.len().div_ceil(LOOKED_AT).max(1);
        for registered in found.registered.iter().step_by(step) {
            self.looked_at += 1;
            let simplices = simplices(content, registered);
            let Some(exact) = contact(scene, simplices[0], simplices[1]) else {
                self.apart += 1;
                let place = place(scene, simplices[0], &registered.on_a);
                match nearest(&place, exact_places) {
                    Some(distance) => {
                        self.location.push(distance);
                        self.location_over_l.push(distance / length);
                    }
                    None => self.alone += 1,
                }
                continue;
            };
            let (mut location, mut weight) = (0.0_f64, 0.0_f64);
            for ((corners, said), exact) in simplices.iter().zip([&registered.on_a, &registered.on_b]).zip(&exact) {
                let off = off(said, exact);
                weight = off.iter().fold(weight, |most, x| most.max(x.to_f64().abs()));
                location = location.max(distance(scene, corners, &off));
            }
            self.location.push(location);
            self.location_over_l.push(location / length);
            self.weight.push(weight);
        }
        let on_first = |registered: &Contact| place(scene, simplices(content, registered)[0], &registered.on_a);
        let registered: Vec<Vec<f64>> = found.registered.iter().map(on_first).collect();
        for exact in exact_places {
            // If nothing is registered, every point is missed by the maximum error.
            self.missed_over_l.push(nearest(exact, &registered).map_or(1.0, |distance| distance / length));
        }
    }

    /// Adds the errors of another scene.
    pub fn merge(&mut self, other: Errors) {
        self.location.extend(other.location);
        self.location_over_l.extend(other.location_over_l);
        self.weight.extend(other.weight);
        self.missed_over_l.extend(other.missed_over_l);
        self.apart += other.apart;
        self.alone += other.alone;
        self.looked_at += other.looked_at;
    }
}

/// The points where the complexes of a scene meet, rounded.
pub(super) fn exact_places(scene: &Scene, content: &Complexes) -> Vec<Vec<f64>> {
    let all = |complex: &Complex| -> Vec<Vec<Vertex>> {
        let counts =
            [complex.vertices().len(), complex.edges().len(), complex.triangles().len(), complex.tetrahedra().len()];
        let of_rank = |(rank, count): (u8, usize)| {
            let count = u32::try_from(count).expect("a complex has fewer than 2^32 simplices");
            (0..count).map(move |index| complex.vertices_of(Simplex { rank, index }).to_vec())
        };
        (0..).zip(counts).flat_map(of_rank).collect()
    };
    let (a, b) = (all(&content.a), all(&content.b));
    let place = |found: &predicament_judge::contacts::Contact| {
        let (corners, weights) = (&a[found.pair[0]], &found.weights[0]);
        let along = |axis: usize| -> Rational {
            corners.iter().zip(weights).map(|(&v, w)| rational(scene.point(v)[axis]) * w).sum()
        };
        (0..scene.dimension().count()).map(|axis| along(axis).to_f64()).collect()
    };
    contacts(scene, &a, &b).iter().map(place).collect()
}

/// The point of a simplex with these weights.
fn place(scene: &Scene, corners: &[Vertex], weights: &Weights) -> Vec<f64> {
    let along = |axis: usize| corners.iter().zip(weights).map(|(&v, w)| scene.point(v)[axis] * w).sum();
    (0..scene.dimension().count()).map(along).collect()
}

/// The distance of the nearest point; `None` if there are none.
fn nearest(of: &[f64], places: &[Vec<f64>]) -> Option<f64> {
    let distance = |place: &Vec<f64>| of.iter().zip(place).map(|(x, y)| (x - y) * (x - y)).sum::<f64>();
    places.iter().map(distance).min_by(f64::total_cmp).map(f64::sqrt)
}

fn simplices<'a>(content: &'a Complexes, registered: &Contact) -> [&'a [Vertex]; 2] {
    [content.a.vertices_of(registered.a), content.b.vertices_of(registered.b)]
}

/// The differences of weights from the exact ones; a NaN counts as 1.
fn off(said: &Weights, exact: &[Rational]) -> Vec<Rational> {
    let off =
        |(said, exact): (&f64, &Rational)| if said.is_finite() { rational(*said) - exact } else { Rational::from(1) };
    said.iter().zip(exact).map(off).collect()
}

/// The length of a sum of vertices with these weights, rounded.
fn distance(scene: &Scene, corners: &[Vertex], weights: &[Rational]) -> f64 {
    let along = |axis: usize| -> Rational {
        corners.iter().zip(weights).map(|(&v, w)| rational(scene.point(v)[axis]) * w).sum()
    };
    let squares = (0..scene.dimension().count()).map(|axis| along(axis).to_f64().powi(2));
    squares.sum::<f64>().sqrt()
}

/// The paper's L of two complexes, from the largest box edges of their primitives (Algorithms 1 and 6).
fn length(scene: &Scene, content: &Complexes) -> f64 {
    let [a, b] = scene.primitive_lengths().unwrap_or_else(|| {
        // The box of all points, which is longer than any primitive.
        let along = |complex: &Complex, axis: usize| {
            let all = || complex.vertices().iter().map(|&v| scene.point(v)[axis]);
            all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
        };
        let longest =
            |complex: &Complex| (0..scene.dimension().count()).map(|axis| along(complex, axis)).fold(0.0, f64::max);
        [longest(&content.a), longest(&content.b)]
    });
    match scene.dimension() {
        Dimension::Two => Tolerances2d::from_lengths(a, b).length,
        Dimension::Three => Tolerances3d::from_lengths(a, b).length,
    }
}
