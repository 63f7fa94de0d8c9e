//! Constructed vertices: intersection points of lines and planes through other vertices.
//!
//! Overlays, slices and unions make such vertices, and round them if they store coordinates. A [`Construction`] stores
//! the definition of the vertex instead, so that a backend can answer about the exact point (*indirect predicates*,
//! Attene 2020). Two vertices are equal if their definitions are equal: two constructions of one point are two
//! vertices, and only a predicate can tell that they coincide.
//!
//! A point that is required to lie on a line is a vertex of this kind as well: αa + (1 − α)c, with an exact [`Share`] α
//! (Franklin and Magalhães, section 3). As an input point with rounded coordinates it would lie beside the line, and a
//! perturbation would move it off.
//!
//! A definition names vertices that exist already, input or constructed, so definitions are never circular.

use crate::{Dimension, Share, Vertex};
use alloc::{
    string::{String, ToString},
    vec::Vec,
};

/// The definition of a constructed vertex: the identities of other vertices.
///
/// [`Construction::canonical`] sorts by id the vertices of a line or a plane, and the lines or planes of one kind; the
/// point does not depend on their order. Only arithmetic can tell whether lines and planes meet in a unique point. A
/// backend that computes the point refuses the definition otherwise.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Construction {
    /// The 2D point where two lines meet, each given by a segment on it.
    ///
    /// The segments themselves need not reach that point.
    Ssi([[Vertex; 2]; 2]),
    /// The 3D point where a line meets a plane.
    Lpi {
        /// Two points of the line.
        line: [Vertex; 2],
        /// Three points of the plane.
        plane: [Vertex; 3],
    },
    /// The 3D point where three planes meet, each given by three of its points.
    Tpi([[Vertex; 3]; 3]),
    /// The point αa + (1 − α)c of the line through a and c, in 2D and 3D.
    ///
    /// It exists for all a and c, and it is between them if α is between 0 and 1.
    Ratio {
        /// The points a and c.
        ends: [Vertex; 2],
        /// The share α of a.
        share: Share,
    },
}

impl Construction {
    /// The same construction with ids sorted wherever their order does not matter.
    #[inline(always)]
    #[must_use]
    pub fn canonical(self) -> Construction {
        match self {
            Construction::Ssi(lines) => Construction::Ssi(two(lines.map(two))),
            Construction::Lpi { line, plane } => Construction::Lpi { line: two(line), plane: three(plane) },
            Construction::Tpi(planes) => Construction::Tpi(three(planes.map(three))),
            Construction::Ratio { ends: [a, c], share } if c.index() < a.index() => {
                Construction::Ratio { ends: [c, a], share: share.rest() }
            }
            Construction::Ratio { .. } => self,
        }
    }

    /// The dimension of the scenes that can hold this construction; `None` if all can.
    #[must_use]
    pub const fn dimension(&self) -> Option<Dimension> {
        match self {
            Construction::Ssi(_) => Some(Dimension::Two),
            Construction::Lpi { .. } | Construction::Tpi(_) => Some(Dimension::Three),
            Construction::Ratio { .. } => None,
        }
    }

    /// Returns true if only input vertices define the construction.
    #[inline]
    #[must_use]
    pub fn is_of_inputs(&self) -> bool {
        let none = |flat: &[Vertex]| flat.iter().all(|vertex| !vertex.is_constructed());
        match self {
            Construction::Ssi(lines) => none(lines.as_flattened()),
            Construction::Lpi { line, plane } => none(line) && none(plane),
            Construction::Tpi(planes) => none(planes.as_flattened()),
            Construction::Ratio { ends, .. } => none(ends),
        }
    }

    /// A hash that is the same on every machine and in every run.
    ///
    /// Its low bits are as good as its high bits. It does not resist deliberate collisions, but they only
    /// slow down the caller that makes them.
    #[inline]
    pub(crate) fn hash(&self) -> u64 {
        /// The start value of the hash for each kind.
        const KINDS: [u64; 4] =
            [0x1319_8a2e_0370_7344, 0xa409_3822_299f_31d0, 0x082e_fa98_ec4e_6c89, 0x4528_21e6_38d0_1377];
        match *self {
            Construction::Ssi([[a, b], [c, d]]) => mixed(mixed(KINDS[0], pair(a, b)), pair(c, d)),
            Construction::Lpi { line: [p, q], plane: [r, s, t] } => {
                mixed(mixed(mixed(KINDS[1], pair(p, q)), pair(r, s)), t.index() as u64)
            }
            Construction::Tpi([[a, b, c], [d, e, f], [g, h, i]]) => {
                let first = mixed(mixed(KINDS[2], pair(a, b)), pair(c, d));
                mixed(mixed(mixed(first, pair(e, f)), pair(g, h)), i.index() as u64)
            }
            Construction::Ratio { ends: [a, c], share } => {
                let [numerator, denominator] = share.fraction().map(i64::cast_unsigned);
                mixed(mixed(mixed(KINDS[3], pair(a, c)), numerator), denominator)
            }
        }
    }

    /// True if it is greater than another; as by `>`, but quick for crossings in the plane.
    #[inline]
    pub(crate) fn is_after(&self, other: &Construction) -> bool {
        match (self, other) {
            (Construction::Ssi([[a, b], [c, d]]), Construction::Ssi([[p, q], [r, s]])) => {
                let all = |a: &Vertex, b: &Vertex, c: &Vertex, d: &Vertex| [[*a, *b].place(), [*c, *d].place()];
                let [[a, b], [p, q]] = [all(a, b, c, d), all(p, q, r, s)];
                (a << 64 | b) > (p << 64 | q)
            }
            _ => self > other,
        }
    }

    /// The lines and planes that the point is on, each as the vertices that span it.
    pub fn flats(&self) -> impl Iterator<Item = &[Vertex]> {
        let (first, second, rest): (&[Vertex], Option<&[Vertex]>, &[[Vertex; 3]]) = match self {
            Construction::Ssi([first, second]) => (first, Some(second), &[]),
            Construction::Lpi { line, plane } => (line, Some(plane), &[]),
            Construction::Tpi([first, second, third]) => (first, Some(second), core::slice::from_ref(third)),
            Construction::Ratio { ends, .. } => (ends, None, &[]),
        };
        core::iter::once(first).chain(second).chain(rest.iter().map(<[Vertex; 3]>::as_slice))
    }
}

/// Writes the kind, then each line or plane, as in `SSI(0 1, 2 3)`, and the share of a ratio, as in `RATIO(0 1, 1/3)`.
impl core::fmt::Display for Construction {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let kind = match self {
            Construction::Ssi(_) => "SSI",
            Construction::Lpi { .. } => "LPI",
            Construction::Tpi(_) => "TPI",
            Construction::Ratio { .. } => "RATIO",
        };
        let mut flats: Vec<String> =
            self.flats().map(|flat| flat.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")).collect();
        if let Construction::Ratio { share, .. } = self {
            flats.push(share.to_string());
        }
        write!(f, "{kind}({})", flats.join(", "))
    }
}

/// The reason why a scene does not take a construction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ConstructionError {
    /// The construction belongs to scenes of another dimension.
    Dimension {
        /// The dimension of the scene.
        scene: Dimension,
        /// The dimension of the construction.
        construction: Dimension,
    },
    /// A defining vertex is neither an input vertex of the scene nor an earlier constructed vertex.
    Missing {
        /// The vertex.
        vertex: Vertex,
    },
    /// A line or a plane names a vertex twice.
    Repeated {
        /// The vertex.
        vertex: Vertex,
    },
    /// The scene has [`Vertex::MAX_CONSTRUCTED`] constructions already.
    TooMany,
}

impl core::fmt::Display for ConstructionError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            ConstructionError::Dimension { scene, construction } => {
                let [scene, construction] = [scene, construction].map(|dimension| dimension.count());
                write!(f, "the scene is {scene}D and the construction {construction}D")
            }
            ConstructionError::Missing { vertex } if vertex.is_constructed() => {
                write!(f, "{vertex} is not constructed before")
            }
            ConstructionError::Missing { vertex } => write!(f, "{vertex} is not an input vertex of the scene"),
            ConstructionError::Repeated { vertex } => write!(f, "vertex {vertex} stands twice in one line or plane"),
            ConstructionError::TooMany => write!(f, "a scene holds at most 2^31 constructed vertices"),
        }
    }
}

impl core::error::Error for ConstructionError {}

/// Vertices, lines and planes with a sort key.
trait Place: Copy {
    /// A number in sort order: by the first vertex, then the next.
    fn place(self) -> u128;
}

impl Place for Vertex {
    #[inline(always)]
    fn place(self) -> u128 {
        self.index() as u128
    }
}

impl<const N: usize> Place for [Vertex; N] {
    #[inline(always)]
    fn place(self) -> u128 {
        const { assert!(N <= 4, "32 bits each") };
        self.into_iter().fold(0, |place, v| place << 32 | v.place())
    }
}

#[inline(always)]
fn two<X: Place>([a, b]: [X; 2]) -> [X; 2] {
    if b.place() < a.place() { [b, a] } else { [a, b] }
}

#[inline(always)]
fn three<X: Place>([a, b, c]: [X; 3]) -> [X; 3] {
    let [a, b] = two([a, b]);
    let [b, c] = two([b, c]);
    let [a, b] = two([a, b]);
    [a, b, c]
}

/// Mixes 64 bits into a hash by combining both halves of a product.
#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // halves of 128 bits
fn mixed(hash: u64, bits: u64) -> u64 {
    /// An odd number without a pattern: the digits of π after the point.
    const FACTOR: u64 = 0x243f_6a88_85a3_08d3;
    let product = u128::from(hash ^ bits) * u128::from(FACTOR);
    product as u64 ^ (product >> 64) as u64
}

#[inline(always)]
fn pair(a: Vertex, b: Vertex) -> u64 {
    (a.index() as u64) << 32 | b.index() as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ids<const N: usize>(indices: [usize; N]) -> [Vertex; N] {
        indices.map(Vertex::input)
    }

    #[test]
    fn canonical_forms_forget_the_order_and_nothing_else() {
        let ssi = |p, q| Construction::Ssi([ids(p), ids(q)]).canonical();
        assert_eq!(ssi([3, 2], [1, 0]), ssi([0, 1], [2, 3]));
        assert_ne!(ssi([0, 2], [1, 3]), ssi([0, 1], [2, 3]), "other lines");
        let lpi = |line, plane| Construction::Lpi { line: ids(line), plane: ids(plane) }.canonical();
        assert_eq!(lpi([9, 1], [8, 2, 5]), lpi([1, 9], [2, 5, 8]));
        assert_ne!(lpi([1, 2], [3, 4, 5]), lpi([1, 3], [2, 4, 5]));
        let tpi = |p, q, r| Construction::Tpi([ids(p), ids(q), ids(r)]).canonical();
        assert_eq!(tpi([8, 7, 6], [5, 4, 3], [2, 1, 0]), tpi([0, 1, 2], [3, 4, 5], [6, 7, 8]));
        assert_eq!(tpi([8, 7, 6], [5, 4, 3], [2, 1, 0]).to_string(), "TPI(0 1 2, 3 4 5, 6 7 8)");
        assert_eq!(lpi([9, 1], [8, 2, 5]).to_string(), "LPI(1 9, 2 5 8)");
        let ratio =
            |ends, share: &str| Construction::Ratio { ends: ids(ends), share: share.parse().unwrap() }.canonical();
        assert_eq!(ratio([4, 2], "1/3"), ratio([2, 4], "2/3"));
        assert_eq!(ratio([2, 4], "-4/6"), ratio([4, 2], "5/3"));
        assert_ne!(ratio([2, 4], "1/3"), ratio([4, 2], "1/3"));
        assert_eq!(ratio([4, 2], "1/3").to_string(), "RATIO(2 4, 2/3)");
        assert_eq!(ratio([4, 2], "1/3").flats().collect::<Vec<_>>(), [&ids([2, 4])[..]]);
    }
}
