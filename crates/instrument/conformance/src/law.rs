//! Laws between the answers to a query and to its images: they need no judge.
//!
//! The crate `laws` checks more laws, between answers of sessions. Here a predicate is a function of coordinates, so
//! the laws are about exact images of the points.

use predicament_predicates::Sign;

use crate::Number;
use crate::query::Query;

/// A law that answers can break.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Law {
    /// Two arguments exchanged: the opposite sign.
    Antisymmetry,
    /// All points moved by the same vector, without rounding: the same sign.
    Translation,
    /// All coordinates times a power of two, without rounding: the same sign.
    Scaling,
}

impl Law {
    /// All laws, in the order of reports.
    pub const ALL: [Law; 3] = [Law::Antisymmetry, Law::Translation, Law::Scaling];

    /// The law's name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Law::Antisymmetry => "antisymmetry",
            Law::Translation => "translation",
            Law::Scaling => "scaling by 2^k",
        }
    }

    /// The exact images of a query, and the factor of the sign.
    pub(crate) fn images<T: Number>(self, query: &Query<T>, dimension: usize) -> (Vec<Query<T>>, Sign) {
        match self {
            Law::Antisymmetry => {
                let last = query.shapes.len() - 1;
                ((0..last).map(|first| query.swapped(dimension, first, first + 1)).collect(), Sign::Negative)
            }
            Law::Translation => {
                let to_origin = || {
                    let by: Option<Vec<T>> = query.coordinates[..dimension].iter().map(|&x| T::ZERO.minus(x)).collect();
                    query.moved(&by?)
                };
                let by_itself = || {
                    let largest = query.coordinates.iter().filter_map(|x| Some((x.bits()?[0], *x))).max_by_key(|x| x.0);
                    query.moved(&vec![largest?.1.rounded(1); dimension])
                };
                (
                    [to_origin(), by_itself()].into_iter().flatten().filter(|image| image != query).collect(),
                    Sign::Positive,
                )
            }
            Law::Scaling => {
                let powers: &[i32] = if T::IS_FLOAT { &[1, -1, 40, -40, 300, -300] } else { &[1, -1, 12, -12] };
                let images = powers.iter().filter_map(|&k| query.times_power(k)).filter(|image| image != query);
                (images.collect(), Sign::Positive)
            }
        }
    }
}

impl std::fmt::Display for Law {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;

    #[test]
    fn images_are_exact_and_others_are_left_out() {
        let of = |law: Law, coordinates: [f64; 4]| {
            let query = Query { way: 0, shapes: vec![Shape::Input; 2], coordinates: coordinates.to_vec() };
            law.images(&query, 2).0.into_iter().map(|image| image.coordinates).collect::<Vec<_>>()
        };
        let moved = of(Law::Translation, [1.0, 2.0, 3.0, 5.0]);
        assert_eq!(moved, [[0.0, 0.0, 2.0, 3.0], [5.0, 6.0, 7.0, 9.0]], "to the origin, and by the largest");
        assert_eq!(of(Law::Translation, [1.0, 0.0, 1e-30, 0.0]).len(), 0, "a sum would be rounded");
        assert_eq!(of(Law::Antisymmetry, [1.0, 2.0, 3.0, 5.0]), [[3.0, 5.0, 1.0, 2.0]]);
        assert_eq!(of(Law::Scaling, [1.0, 2.0, 3.0, 5.0]).len(), 6);
        assert_eq!(of(Law::Scaling, [1.0, 0.0, f64::MAX, 0.0]).len(), 3, "smaller ones");
    }
}
