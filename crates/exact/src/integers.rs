//! The coordinates of a scene as integers.
//!
//! Where differences fit in one limb, coordinates become integers once, when
//! the scene is prepared, in units of its lowest bit: a query then only
//! subtracts. They are kept modulo 2^64, so that the points may be as far from
//! the origin as they like; only their differences have to fit. A coordinate
//! takes as much room as the double that it comes from.
//!
//! A scene that needs more is hardly ever one that needs it everywhere: it has
//! figures of many sizes, or a few coordinates with long tails. There it is
//! noted for each point which bits it has, and a query that has few gets a unit
//! of its own.

// Loops over indices stay in registers, where `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use predicament_arithmetic::{ExponentRange, Fixed, Plan, power_of_two, units};
use predicament_predicates::Vertex;

use crate::integer::BITS;
use crate::truncate::to_integer;

/// A scene's coordinates: one of the two lists, or none where integers are not needed.
pub(crate) struct Integers<const D: usize> {
    /// In units of the scene.
    units: Vec<[i64; D]>,
    /// Where the bits of each point are.
    spans: Vec<Span>,
}

/// The coordinates of a point are multiples of 2^`low`, less than 2^`high`.
#[derive(Clone, Copy)]
struct Span {
    low: i16,
    high: i16,
}

impl Span {
    /// The span of the origin: any unit will do.
    const NONE: Span = Span { low: i16::MAX, high: i16::MIN };

    fn of<const D: usize>(point: &[f64; D]) -> Span {
        let exponent = |e: i32| i16::try_from(e).expect("the exponent of a double");
        ExponentRange::of(point)
            .map_or(Span::NONE, |range| Span { low: exponent(range.lowest), high: exponent(range.highest) })
    }

    #[inline(always)]
    fn and(self, other: Span) -> Span {
        Span { low: self.low.min(other.low), high: self.high.max(other.high) }
    }
}

/// Differences of one limb, and the bits that they have at most.
pub(crate) type Short<const D: usize, const N: usize> = ([[Fixed<1>; D]; N], i32);

impl<const D: usize> Integers<D> {
    /// None: for scenes that don't need them.
    pub const NONE: Integers<D> = Integers { units: Vec::new(), spans: Vec::new() };

    pub fn new(plan: &Plan<D>, points: &[[f64; D]]) -> Integers<D> {
        if plan.has_finite_differences() && plan.bits() <= BITS[0] {
            Integers { units: plan.low_units(points), spans: Vec::new() }
        } else {
            Integers { units: Vec::new(), spans: points.iter().map(Span::of).collect() }
        }
    }

    /// The differences to the last of some vertices along some axes, in units of
    /// the scene; none if the scene has more bits, or no such vertex.
    #[inline(always)]
    pub fn of_scene<const E: usize, const N: usize>(
        &self,
        axes: [usize; E],
        vertices: [Vertex; N],
    ) -> Option<[[Fixed<1>; E]; N]> {
        let last = self.units.get(vertices[N - 1].index())?;
        let mut rows = [[Fixed::ZERO; E]; N];
        for row in 0..N - 1 {
            let point = self.units.get(vertices[row].index())?;
            for axis in 0..E {
                rows[row][axis] = Fixed::from(point[axes[axis]].wrapping_sub(last[axes[axis]]));
            }
        }
        Some(rows)
    }

    /// The same in units of the query, for scenes that have more bits; none if
    /// the query has more as well. `points` are those of the vertices.
    #[inline(always)]
    pub fn of_query<const E: usize, const N: usize>(
        &self,
        points: &[[f64; E]; N],
        vertices: [Vertex; N],
    ) -> Option<Short<E, N>> {
        let mut span = Span::NONE;
        for row in 0..N {
            span = span.and(*self.spans.get(vertices[row].index())?);
        }
        // Coordinates are less than 2^(high − low) in magnitude, their differences less than twice that.
        let (low, bits) = (i32::from(span.low), i32::from(span.high) - i32::from(span.low) + 1);
        if bits > BITS[0] || !(-1022..=1022).contains(&low) {
            return None;
        }
        let scale = power_of_two(-low);
        let mut rows = [[Fixed::ZERO; E]; N];
        for axis in 0..E {
            let last = to_integer(points[N - 1][axis] * scale);
            for row in 0..N - 1 {
                rows[row][axis] = Fixed::from(to_integer(points[row][axis] * scale) - last);
            }
        }
        Some((rows, bits))
    }
}

/// Differences of a query in two limbs.
pub(crate) struct Rows<const D: usize, const N: usize>([[i128; D]; N]);

impl<const D: usize, const N: usize> Rows<D, N> {
    /// The differences to the last of some points whose plan allows two limbs.
    #[inline(always)]
    pub fn new(points: &[[f64; D]; N], lowest: i32) -> Rows<D, N> {
        let mut rows = [[0; D]; N];
        for axis in 0..D {
            let last = units(points[N - 1][axis], lowest);
            for row in 0..N - 1 {
                rows[row][axis] = units(points[row][axis], lowest).wrapping_sub(last);
            }
        }
        Rows(rows)
    }

    /// The rows in some larger unit and the bits that they have, if one limb is enough.
    #[inline(always)]
    pub fn shortened(&self) -> Option<Short<D, N>> {
        let (mut bits, mut size) = (0, 0);
        for row in 0..N - 1 {
            for axis in 0..D {
                let x = self.0[row][axis];
                bits |= x;
                // The bits of |x|, or of |x| - 1.
                size |= x ^ (x >> 127);
            }
        }
        // At most that many zeros below, and no more than two to that in magnitude.
        let low = bits.trailing_zeros() & 127;
        let bits = (129 - size.leading_zeros()).saturating_sub(low).cast_signed();
        (bits <= BITS[0]).then(|| (self.shifted(low), bits))
    }

    /// The rows as they are.
    #[inline(always)]
    pub fn whole(&self) -> [[Fixed<2>; D]; N] {
        let mut rows = [[Fixed::ZERO; D]; N];
        for row in 0..N - 1 {
            for axis in 0..D {
                rows[row][axis] = Fixed::from(self.0[row][axis]);
            }
        }
        rows
    }

    /// The low limbs of the rows, shifted to the right.
    #[inline(always)]
    fn shifted(&self, by: u32) -> [[Fixed<1>; D]; N] {
        let mut shorter = [[Fixed::ZERO; D]; N];
        for row in 0..N - 1 {
            for axis in 0..D {
                #[allow(clippy::cast_possible_truncation)] // 62 bits
                let x = (self.0[row][axis] >> by) as i64;
                shorter[row][axis] = Fixed::from(x);
            }
        }
        shorter
    }
}
