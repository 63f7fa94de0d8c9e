//! Exact homogeneous coordinates of vertices, input and constructed.
//!
//! # Alignment
//! All coordinates of a scene are scaled by one power of two, so that the
//! largest lies just below 2^58 (signs don't see it). A coordinate whose lowest
//! bit is no more than 58 bits below the scene's top is then one limb, and six
//! bits are left for sums: a line and plane's point has entries below 2^240 and
//! takes four limbs, that of three planes has entries below 2^421 and takes seven.
//!
//! Rows of vertices that constructed vertices define have no such limit. They
//! are in lowest terms instead: see [`deep`](super::deep).

use predicament_arithmetic::{
    ExponentRange,
    dyadic::{Number, Space},
};
use predicament_predicates::{Axis, Scene, Vertex};

/// The bits of the scene's largest coordinate after scaling.
const TOP: i32 = 58;

/// The error of an approximation in units of u, in relation to the
/// approximation: a hair more than rounding, in relation to what is rounded.
pub(super) const ERRORS: f64 = 1.0 + 1.0 / 64.0;

/// Where the limbs of a stored number are.
#[derive(Clone, Copy, Debug)]
struct Entry {
    start: usize,
    length: usize,
    low: i32,
    negative: bool,
}

/// The exact rows of a scene's vertices: those of input vertices are read
/// from the scene, those of constructed ones are stored, with w > 0.
#[derive(Clone, Debug)]
pub(super) struct Rows<'s> {
    /// Asked for its input vertices only.
    scene: &'s Scene,
    /// The exponent of the scale, once it is needed.
    shift: Option<i32>,
    /// Coordinates and weight, vertex after vertex.
    entries: Vec<Entry>,
    limbs: Vec<u64>,
}

impl<'s> Rows<'s> {
    /// No constructed vertex yet.
    pub fn new(scene: &'s Scene) -> Rows<'s> {
        Rows { scene, shift: None, entries: Vec::new(), limbs: Vec::new() }
    }

    /// Finds the scale, for the first vertex that is constructed: one look at all coordinates.
    pub fn align(&mut self) {
        if self.shift.is_none() {
            self.shift = Some(ExponentRange::of(self.scene.coordinates()).map_or(0, |range| TOP - range.highest));
        }
    }

    /// No scale is as good as any before something is constructed.
    #[inline(always)]
    fn shift(&self) -> i32 {
        self.shift.unwrap_or(0)
    }

    /// The next constructed vertex. Weights that are negative turn the row's signs.
    pub fn push(&mut self, coordinates: &[Number], weight: Number) {
        for number in coordinates.iter().chain([&weight]) {
            let (start, length) = (self.limbs.len(), number.limbs.len());
            self.limbs.extend_from_slice(number.limbs);
            self.entries.push(Entry { start, length, low: number.low, negative: number.negative != weight.negative });
        }
    }

    /// Removes all constructed vertices but the first so many.
    pub fn truncate(&mut self, count: usize) {
        let entries = count * (self.scene.dimension().count() + 1);
        if let Some(first) = self.entries.get(entries) {
            self.limbs.truncate(first.start);
            self.entries.truncate(entries);
        }
    }

    /// The coordinates of an input vertex, scaled; two limbs each.
    #[inline]
    pub fn input<'a, const K: usize>(&self, space: &mut Space<'a>, v: Vertex, axes: [Axis; K]) -> [Number<'a>; K] {
        let point = self.scene.point(v);
        let mut numbers = [Number::ZERO; K];
        for (number, axis) in numbers.iter_mut().zip(axes) {
            *number = Number::scaled(space, point[axis.index()], self.shift());
        }
        numbers
    }

    /// The row of a vertex, seen along these axes: R is K + 1, the weight
    /// comes last. The space is for input vertices, two limbs a coordinate.
    #[inline]
    pub fn of<'a, const K: usize, const R: usize>(
        &'a self,
        space: &mut Space<'a>,
        v: Vertex,
        axes: [Axis; K],
    ) -> [Number<'a>; R] {
        const { assert!(R == K + 1, "a row is coordinates and a weight") };
        let mut row = [Number::ONE; R];
        match v.construction() {
            None => row[..K].copy_from_slice(&self.input(space, v, axes)),
            Some(index) => {
                let dimension = self.scene.dimension().count();
                let entries = self.row(index);
                for (number, axis) in row.iter_mut().zip(axes) {
                    *number = self.number(entries[..dimension][axis.index()]);
                }
                row[K] = self.number(entries[dimension]);
            }
        }
        row
    }

    /// A coordinate of a constructed vertex as a double: within [`ERRORS`]·u, in
    /// relation to the double, or within 2^-400. NaN from about 2^1000 on.
    pub fn approximation(&self, index: usize, axis: usize) -> f64 {
        let row = self.row(index);
        let [x, w] = [axis, self.scene.dimension().count()].map(|entry| self.number(row[entry]));
        let Some((quotient, exponent)) = x.quotient(w) else {
            return 0.0;
        };
        let exponent = exponent - self.shift();
        // A number of 65 bits at this exponent: no double here is subnormal, none infinite.
        let magnitude = match exponent {
            ..-465 => 0.0,
            -465..=935 => quotient * 2f64.powi(exponent),
            936.. => f64::NAN,
        };
        if x.negative { -magnitude } else { magnitude }
    }

    /// Coordinates and weight of a constructed vertex.
    fn row(&self, index: usize) -> &[Entry] {
        let length = self.scene.dimension().count() + 1;
        &self.entries[index * length..][..length]
    }

    fn number(&self, Entry { start, length, low, negative }: Entry) -> Number<'_> {
        Number { limbs: &self.limbs[start..start + length], low, negative }
    }
}
