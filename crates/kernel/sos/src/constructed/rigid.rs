//! Ties between two meshes, one of which has moved as a whole.
//!
//! The second mesh moves by (ε, ε², ε³). There is only one infinitesimal, so whole polynomials are affordable: they are
//! cut off at a power that most ties don't reach, then at larger ones, up to the largest possible power.

use predicament_predicates::{Question, Scene, Sign, Vertex};

use super::linear;
use super::moved::{Moved, inputs};
use super::place::Place;
use super::search::{Expression, integers};
use super::series::{Cut, Number, Series};
use super::{Determinant, Weight};
use crate::integer::Integer;

/// The powers at which polynomials are cut off, one after the other.
///
/// About input vertices the largest power is 12: ε, ε², ε³ and the square of ε³ in the four columns of spheres. Four
/// points of three planes each have products of 4 · 7 coordinates, each with ε³ at most.
const POWERS: [usize; 3] = [3, 12, 84];

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
    let constructed = places.iter().any(|place| matches!(place, Place::Meet(_)));
    let rigid = Rigid { scene, inputs: &inputs, second, constructed };
    let (sign, power) = rigid.leading(&Determinant { dimension, question, places })?;
    let meets = places.iter().filter(|place| matches!(place, Place::Meet(_)));
    let weight = |place: &Place| rigid.leading(&Weight(*place, dimension)).map_or(Sign::Zero, |(sign, _)| sign);
    let sign = meets.fold(sign, |sign, place| sign * weight(place));
    Some((sign, power))
}

struct Rigid<'q> {
    scene: &'q Scene,
    inputs: &'q [Vertex],
    second: &'q [bool],
    /// True if the question is about constructed vertices.
    constructed: bool,
}

impl Rigid<'_> {
    fn leading(&self, expression: &impl Expression) -> Option<(Sign, usize)> {
        let powers = if self.constructed { &POWERS[..] } else { &POWERS[..2] };
        powers.iter().find_map(|&largest| {
            let series = self.series(expression, largest);
            let power = series.iter().position(|coefficient| !coefficient.is_zero())?;
            Some((series[power].cmp0().into(), power))
        })
    }

    fn series(&self, expression: &impl Expression, largest: usize) -> Series<Integer> {
        let cut = Cut::new([largest]);
        let dimension = self.scene.dimension().count();
        let coordinate = |(at, (m, k)): (usize, (i64, u32))| {
            let mut series = Series::constant(&cut, Integer::from(m) << k);
            if self.second[self.inputs[at / dimension].index()] {
                series[at % dimension + 1] += &Integer::ONE;
            }
            series
        };
        let (_, coordinates) = integers(self.scene, self.inputs);
        let coordinates: Vec<_> = coordinates.into_iter().enumerate().map(coordinate).collect();
        expression.of(&Moved {
            dimension: self.scene.dimension(),
            cut: &cut,
            inputs: self.inputs,
            coordinates: &coordinates,
        })
    }
}
