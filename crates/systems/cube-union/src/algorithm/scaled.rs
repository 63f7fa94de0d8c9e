//! Conversion of cubes in floating point to cubes in integers, without rounding.

use predicament_arithmetic::Parts;
use predicament_predicates::{Dimension, Scene, Vertex};

use super::CubesError;

/// The maximum number of bits of a coordinate, so that sums of two don't overflow.
const BITS: u32 = 62;

/// Congruent cubes in integers, and their unit.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ScaledCubes {
    /// The lower corners, in units.
    pub lowers: Vec<[i64; 3]>,
    /// The edge length, in units.
    pub edge: i64,
    /// The exponent of the unit, a power of two.
    pub exponent: i32,
}

/// The parts of a finite value; the significand is odd or zero.
fn parts(value: f64) -> Parts {
    Parts::of(value).expect("checked to be finite").odd()
}

/// The value in units of 2^unit, which must divide it and leave at most [`BITS`].
fn in_units(value: f64, unit: i32) -> i64 {
    let Parts { negative, significand, exponent } = parts(value);
    if significand == 0 {
        return 0;
    }
    let magnitude = (significand << (exponent - unit)).cast_signed();
    if negative { -magnitude } else { magnitude }
}

/// The range of bit positions of several numbers, and the owners of its ends.
#[derive(Default)]
struct Span {
    finest: Option<(i32, Option<usize>)>,
    largest: Option<(i32, Option<usize>)>,
}

impl Span {
    fn take(&mut self, value: f64, cube: Option<usize>) {
        let parts = parts(value);
        let (Some(lowest), Some(highest)) = (parts.lowest(), parts.highest()) else { return };
        if self.finest.is_none_or(|(exponent, _)| lowest < exponent) {
            self.finest = Some((lowest, cube));
        }
        if self.largest.is_none_or(|(top, _)| highest > top) {
            self.largest = Some((highest, cube));
        }
    }

    /// The exponent of the unit.
    fn unit(self) -> Result<i32, CubesError> {
        let (Some((unit, finest)), Some((top, largest))) = (self.finest, self.largest) else { return Ok(0) };
        let bits = top.abs_diff(unit);
        if bits > BITS { Err(CubesError::TooFine { largest, finest, bits }) } else { Ok(unit) }
    }
}

fn finite(point: [f64; 3], cube: usize) -> Result<[f64; 3], CubesError> {
    match point.iter().position(|value| !value.is_finite()) {
        Some(axis) => Err(CubesError::NotFinite { cube, axis, value: point[axis] }),
        None => Ok(point),
    }
}

impl ScaledCubes {
    /// Cubes by their lower corners and the length of their edges.
    ///
    /// # Errors
    /// [`CubesError`] if a number is not finite, the edge length is not
    /// positive, or no unit makes all numbers integers of at most 62 bits.
    pub fn new(lowers: &[[f64; 3]], edge: f64) -> Result<ScaledCubes, CubesError> {
        if !(edge > 0.0 && edge.is_finite()) {
            return Err(CubesError::Edge { edge });
        }
        let mut span = Span::default();
        span.take(edge, None);
        for (cube, &lower) in lowers.iter().enumerate() {
            finite(lower, cube)?.into_iter().for_each(|number| span.take(number, Some(cube)));
        }
        let unit = span.unit()?;
        let units = |value: f64| in_units(value, unit);
        Ok(ScaledCubes {
            lowers: lowers.iter().map(|lower| lower.map(units)).collect(),
            edge: units(edge),
            exponent: unit,
        })
    }

    /// The cubes of a scene: vertex 2i is the lower corner of cube i and vertex 2i + 1 the upper one. An empty scene
    /// has no cubes, of edge length 1.
    ///
    /// # Errors
    /// Like [`ScaledCubes::new`], and if the vertices are not pairs of corners of cubes of exactly equal size.
    pub fn of_scene(scene: &Scene) -> Result<ScaledCubes, CubesError> {
        let (vertices, dimension) = (scene.len(), scene.dimension());
        if dimension != Dimension::Three || !vertices.is_multiple_of(2) {
            return Err(CubesError::NoPairs { vertices, dimension: dimension.count() });
        }
        let point = |at: usize| {
            let point = scene.point(Vertex::input(at));
            [point[0], point[1], point[2]]
        };
        let mut span = Span::default();
        for at in 0..vertices {
            finite(point(at), at / 2)?.into_iter().for_each(|number| span.take(number, Some(at / 2)));
        }
        let unit = span.unit()?;
        let units = |at: usize| point(at).map(|value| in_units(value, unit));
        let mut cubes = ScaledCubes { lowers: Vec::with_capacity(vertices / 2), edge: 1, exponent: unit };
        for cube in 0..vertices / 2 {
            let (lower, upper) = (units(2 * cube), units(2 * cube + 1));
            for axis in 0..3 {
                let extent = upper[axis] - lower[axis];
                if (cube, axis) == (0, 0) {
                    if extent <= 0 {
                        return Err(CubesError::Edge { edge: point(1)[0] - point(0)[0] });
                    }
                    cubes.edge = extent;
                } else if extent != cubes.edge {
                    return Err(CubesError::Unequal { cube, axis });
                }
            }
            cubes.lowers.push(lower);
        }
        Ok(cubes)
    }
}
