//! Exact homogeneous coordinates of vertices, input and constructed.
//!
//! Rows are stored here once they are computed, [on demand](super::demand).
//!
//! # Alignment
//! All coordinates of a scene are scaled by one power of two, so that the largest lies just below 2^58 (this changes no
//! sign). A coordinate whose lowest bit is at most 58 bits below the scene's top is then one limb, and six bits remain
//! for sums: a line and plane's point has entries below 2^240 and takes four limbs, that of three planes has entries
//! below 2^421 and takes seven.
//!
//! Rows of vertices that constructed vertices define have no such limit. They are in lowest terms instead: see
//! [`deep`](super::deep).

use alloc::{boxed::Box, vec::Vec};

use predicament_arithmetic::{
    ExponentRange,
    dyadic::{Number, Space},
    power_of_two,
};
use predicament_predicates::{Axis, Scene, Vertex};

use super::filter::Approximate;
use crate::once::Once;

/// The bit length of the scene's largest coordinate after scaling.
const TOP: i32 = 58;

/// The error of a rounded coordinate in units of u, relative to the coordinate.
///
/// It is slightly more than the rounding error relative to the rounded number.
pub(super) const ERRORS: f64 = 1.0 + 1.0 / 64.0;

/// The number of vertices whose slots are allocated together, when the first of their rows is needed.
const TOGETHER: usize = 16;

type Slots = [Once<Row>; TOGETHER];

/// The rows that have been computed.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    /// The exponent of the scale, computed on first use.
    shift: Once<i32>,
    slots: Vec<Once<Box<Slots>>>,
    pub count: usize,
}

impl Rows {
    /// Adds a vertex whose row is not computed yet.
    #[inline]
    pub fn push(&mut self) {
        if self.count.is_multiple_of(TOGETHER) {
            self.slots.push(Once::new());
        }
        self.count += 1;
    }

    /// Removes all constructed vertices after the first `count`.
    pub fn truncate(&mut self, count: usize) {
        self.slots.truncate(count.div_ceil(TOGETHER));
        if let Some(slots) = self.slots.get_mut(count / TOGETHER).and_then(Once::get_mut) {
            slots[count % TOGETHER..].fill_with(Once::new);
        }
        self.count = count;
    }

    /// Reserves space for `more` vertices.
    pub fn reserve(&mut self, more: usize) {
        self.slots.reserve(more.div_ceil(TOGETHER));
    }
}

/// An exact row: coordinates and a positive weight, and the coordinates as doubles.
#[derive(Clone, Debug)]
pub(super) struct Row {
    /// The coordinates as doubles.
    ///
    /// They are within [`ERRORS`]·u relative to the double, or within 2^-400. NaN from about 2^1000 on.
    rounded: [f64; 3],
    /// The [`head`] of each entry.
    heads: [u64; 4],
    /// The limbs of all entries.
    limbs: Box<[u64]>,
}

/// A number without its limbs: its length, its sign, and its place.
#[allow(clippy::cast_sign_loss)] // bits of an i32
fn head(number: Number, negative: bool) -> u64 {
    let length = u64::try_from(number.limbs.len()).expect("a length of 31 bits");
    assert!(length < 1 << 31, "a length of 31 bits");
    length << 33 | u64::from(negative) << 32 | u64::from(number.low as u32)
}

impl Row {
    /// A coordinate by its axis; the index after the last axis is the weight.
    #[inline(always)]
    #[allow(clippy::cast_possible_wrap, clippy::cast_possible_truncation)] // the lower half, bits of an i32; a length of 31 bits
    fn entry(&self, at: usize) -> Number<'_> {
        let length = |head: u64| (head >> 33) as usize;
        let (head, [x, y, z, _]) = (self.heads[at], self.heads.map(length));
        let start = [0, x, x + y, x + y + z][at];
        let limbs = &self.limbs[start..start + length(head)];
        Number { limbs, low: head as u32 as i32, negative: head >> 32 & 1 == 1 }
    }

    /// The rounded coordinates, as many as the dimension.
    #[inline(always)]
    pub fn rounded(&self, dimension: usize) -> &[f64] {
        &self.rounded[..dimension]
    }
}

/// The exact coordinates of a vertex.
#[derive(Clone, Copy)]
pub(super) enum Found<'a> {
    /// The coordinates of an input vertex.
    Input(&'a [f64]),
    /// The row of a constructed vertex.
    Constructed(&'a Row),
}

impl Found<'_> {
    /// Coordinates as doubles, with their error bounds.
    #[inline(always)]
    pub fn rounded<const K: usize>(self, axes: [Axis; K]) -> [Approximate; K] {
        let (point, errors): (&[f64], f64) = match self {
            Found::Input(point) => (point, 0.0),
            Found::Constructed(row) => (&row.rounded, ERRORS),
        };
        axes.map(|axis| Approximate::within(point[axis.index()], errors))
    }
}

/// The exact rows of a scene's vertices, with w > 0.
///
/// Rows of input vertices are read from the scene, those of constructed vertices are computed and stored.
#[derive(Clone, Copy)]
pub(super) struct View<'a> {
    /// The scene, for input vertices and for definitions of constructed ones.
    pub scene: &'a Scene,
    pub rows: &'a Rows,
}

impl<'a> View<'a> {
    /// The exponent of the scale, from one pass over all coordinates on first use.
    #[inline]
    fn shift(self) -> i32 {
        let scale = || ExponentRange::of(self.scene.coordinates()).map_or(0, |range| TOP - range.highest);
        *self.rows.shift.get_or_init(scale)
    }

    /// The coordinates of an input vertex, scaled; two limbs each.
    #[inline]
    pub fn input<'s, const K: usize>(self, space: &mut Space<'s>, v: Vertex, axes: [Axis; K]) -> [Number<'s>; K] {
        self.scaled(space, self.scene.point(v), axes)
    }

    #[inline(always)]
    fn scaled<'s, const K: usize>(self, space: &mut Space<'s>, point: &[f64], axes: [Axis; K]) -> [Number<'s>; K] {
        let shift = self.shift();
        let mut numbers = [Number::ZERO; K];
        for (number, axis) in numbers.iter_mut().zip(axes) {
            *number = Number::scaled(space, point[axis.index()], shift);
        }
        numbers
    }

    /// The row of a vertex, seen along these axes, with the weight last: R is K + 1.
    ///
    /// The space is for input vertices, two limbs per coordinate.
    #[inline]
    pub fn of<'s, const K: usize, const R: usize>(
        self,
        space: &mut Space<'s>,
        found: Found<'a>,
        axes: [Axis; K],
    ) -> [Number<'s>; R]
    where
        'a: 's,
    {
        const { assert!(R == K + 1, "a row is coordinates and a weight") };
        let mut row = [Number::ONE; R];
        match found {
            Found::Input(point) => row[..K].copy_from_slice(&self.scaled(space, point, axes)),
            Found::Constructed(stored) => {
                axes.iter().zip(&mut row).for_each(|(axis, number)| *number = stored.entry(axis.index()));
                row[K] = stored.entry(self.scene.dimension().count());
            }
        }
        row
    }

    /// A vertex with its exact coordinates; the row of a constructed vertex must have been computed.
    ///
    /// # Panics
    /// If there is no such vertex, or its row is not computed yet.
    pub fn known(self, v: Vertex) -> Found<'a> {
        match v.construction() {
            None => Found::Input(self.scene.point(v)),
            Some(index) => {
                Found::Constructed(self.computed(index).expect("what defines a vertex is computed before it"))
            }
        }
    }

    /// The row of the constructed vertex with this index, if it has been computed.
    #[inline(always)]
    pub fn computed(self, index: usize) -> Option<&'a Row> {
        self.rows.slots[index / TOGETHER].get().and_then(|slots| slots[index % TOGETHER].get())
    }

    /// The slot for the row of the constructed vertex with this index.
    pub fn slot(self, index: usize) -> &'a Once<Row> {
        let slots = self.rows.slots[index / TOGETHER].get_or_init(|| Box::new(core::array::from_fn(|_| Once::new())));
        &slots[index % TOGETHER]
    }

    /// A row of these numbers; a negative weight negates the whole row.
    pub fn store(self, coordinates: &[Number], weight: Number) -> Row {
        let numbers = coordinates.iter().chain([&weight]);
        let mut limbs = Vec::with_capacity(numbers.clone().map(|number| number.limbs.len()).sum());
        let mut heads = [0; 4];
        for (head, number) in heads.iter_mut().zip(numbers) {
            *head = self::head(*number, number.negative != weight.negative);
            limbs.extend_from_slice(number.limbs);
        }
        let mut rounded = [0.0; 3];
        for (rounded, &x) in rounded.iter_mut().zip(coordinates) {
            *rounded = self.rounded(x, weight);
        }
        Row { rounded, heads, limbs: limbs.into() }
    }

    /// A coordinate as a double, as in a [`Row`].
    fn rounded(self, x: Number, w: Number) -> f64 {
        let Some((quotient, exponent)) = x.quotient(w) else {
            return 0.0;
        };
        let exponent = exponent - self.shift();
        // A number of 65 bits at this exponent: no double here is subnormal or infinite.
        let magnitude = match exponent {
            ..-465 => 0.0,
            -465..=935 => quotient * power_of_two(exponent),
            936.. => f64::NAN,
        };
        if x.negative == w.negative { magnitude } else { -magnitude }
    }
}
