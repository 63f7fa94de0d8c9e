//! Ties between two meshes, one of which has moved as a whole.
//!
//! The second mesh moves by δ = η·(ε, ε², ε³), where η is smaller than every power of ε. So a monomial is the larger
//! the lower its degree is in δ, and of one degree the lower its power of ε is. Without η, ε³ and ε·ε² are equal though
//! their degrees differ, and the sign of their sum depends on the unit of length: two questions about one scene could
//! contradict each other, as each computes in a unit of its own.
//!
//! There are only two infinitesimals, so whole polynomials are affordable: they are cut off at a degree that most ties
//! don't reach, then at larger ones, up to the largest possible degree.

use predicament_predicates::{Construction, Question, Scene, Sign, Vertex};

use super::linear;
use super::moved::{Moved, inputs};
use super::place::Place;
use super::search::{Expression, integers};
use super::series::{Cut, Number, Series};
use super::{Determinant, Weight};
use crate::integer::Integer;

/// The degrees in δ at which polynomials are cut off, one after the other, before the largest one.
const DEGREES: [usize; 2] = [1, 5];

/// The side of a tie, and the deciding power of ε; `None` if the determinant is zero however far the second mesh moves.
///
/// # Panics
/// If the scene lacks a vertex or does not have two meshes.
pub(crate) fn decide(scene: &Scene, question: Question, args: &[Vertex]) -> Option<(Sign, usize)> {
    let second = scene.second_mesh().expect("a scene with two meshes");
    let places: Vec<Place> = args.iter().map(|&v| Place::of(scene, v)).collect();
    let inputs = inputs(&places);
    let moving = inputs.iter().filter(|v| second[v.index()]).count();
    if moving == 0 || moving == inputs.len() {
        return None;
    }
    linear::decide(scene, second, question, &places).unwrap_or_else(|| by_powers(scene, second, question, &places))
}

/// The result of `decide` by whole polynomials, for all places.
pub(super) fn by_powers(scene: &Scene, second: &[bool], question: Question, places: &[Place]) -> Option<(Sign, usize)> {
    let (dimension, inputs) = (scene.dimension().count(), inputs(places));
    // The lift of a circle or sphere has degree 2, but its determinant has a row less than arguments.
    let largest = places.iter().map(degree).sum();
    let rigid = Rigid { scene, inputs: &inputs, second, largest };
    let (sign, power) = rigid.leading(&Determinant { dimension, question, places })?;
    let meets = places.iter().filter(|place| matches!(place, Place::Meet(_)));
    let weight = |place: &Place| rigid.leading(&Weight(*place, dimension)).map_or(Sign::Zero, |(sign, _)| sign);
    let sign = meets.fold(sign, |sign, place| sign * weight(place));
    Some((sign, power))
}

/// The degree of a row's coordinates in those of the input vertices.
fn degree(place: &Place) -> usize {
    match place {
        Place::Input(_) | Place::Meet(Construction::Ratio { .. }) => 1,
        Place::Meet(Construction::Ssi(_)) => 3,
        Place::Meet(Construction::Lpi { .. }) => 4,
        Place::Meet(Construction::Tpi(_)) => 7,
    }
}

struct Rigid<'q> {
    scene: &'q Scene,
    inputs: &'q [Vertex],
    second: &'q [bool],
    /// The largest possible degree of the question.
    largest: usize,
}

impl Rigid<'_> {
    fn leading(&self, expression: &impl Expression) -> Option<(Sign, usize)> {
        let mut degrees = DEGREES.into_iter().filter(|degree| *degree < self.largest).chain([self.largest]);
        degrees.find_map(|largest| {
            let cut = Cut::new([largest, 2 * largest]);
            let series = self.series(expression, &cut);
            let mut monomials = (0..=largest).flat_map(|degree| (0..=2 * degree).map(move |more| [degree, more]));
            monomials.find_map(|[degree, more]| {
                let coefficient = &series[cut.place(0, degree)? + cut.place(1, more)?];
                (!coefficient.is_zero()).then(|| (coefficient.cmp0().into(), degree + more))
            })
        })
    }

    /// The polynomial in the length of δ and in ε, whose powers are counted beyond those of the degree.
    fn series(&self, expression: &impl Expression, cut: &Cut) -> Series<Integer> {
        let dimension = self.scene.dimension().count();
        let coordinate = |(at, (m, k)): (usize, (i64, u32))| {
            let mut series = Series::constant(cut, Integer::from(m) << k);
            if self.second[self.inputs[at / dimension].index()] {
                let places = [cut.place(0, 1), cut.place(1, at % dimension)];
                series[places.into_iter().flatten().sum::<usize>()] += &Integer::ONE;
            }
            series
        };
        let (_, coordinates) = integers(self.scene, self.inputs);
        let coordinates: Vec<_> = coordinates.into_iter().enumerate().map(coordinate).collect();
        expression.of(&Moved { dimension: self.scene.dimension(), cut, inputs: self.inputs, coordinates: &coordinates })
    }
}
