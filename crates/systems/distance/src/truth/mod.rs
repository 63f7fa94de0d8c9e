//! The truth about two objects: every feature of one against every feature of the other, in rationals.
//!
//! A pair of features counts if its nearest points are single and inside both (`solved.rs`). The least squared distance
//! of all pairs is that of the boundaries. The computation uses no predicate and no tree. Doubles leave out only pairs
//! of parts whose boxes are farther apart along one axis than a distance that was found.

mod inside;
mod solved;

use std::collections::{BTreeMap, BTreeSet};

use predicament_judge::rational;
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::{Stop, Watch};
use rug::Rational;

use crate::answer::{Feature, Kind, Object, Pair};
use solved::Point;

pub use solved::Solved;

/// The nearest pairs of two objects, with their distance.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The way in which the objects lie.
    pub kind: Kind,
    /// The squared distance of the objects: zero if they have a common point.
    pub squared: Rational,
    /// The nearest pairs of features; empty if the objects cross or one is inside the other.
    pub pairs: BTreeSet<Pair>,
    /// The pairs of features that cross: two edges in the plane, an edge and a triangle in space.
    pub crossings: BTreeSet<Pair>,
}

/// The nearest points of a pair of features in a scene; `None` if they are not single, or not inside the features.
#[must_use]
pub fn measured(scene: &Scene, [one, other]: &Pair) -> Option<Solved> {
    let points = |feature: &Feature| feature.corners().iter().map(|&v| point(scene, v)).collect::<Vec<Point>>();
    let (one, other) = (points(one), points(other));
    solved::solved(&one.iter().collect::<Vec<_>>(), &other.iter().collect::<Vec<_>>())
}

fn point(scene: &Scene, v: Vertex) -> Point {
    scene.point(v).iter().map(|&x| rational(x)).collect()
}

/// The box of a part: the least and the largest coordinate along each axis.
type Extent = Vec<[f64; 2]>;

fn extent(scene: &Scene, part: &[Vertex]) -> Extent {
    let along = |axis: usize| part.iter().map(move |&v| scene.point(v)[axis]);
    let range =
        |axis: usize| [along(axis).fold(f64::INFINITY, f64::min), along(axis).fold(f64::NEG_INFINITY, f64::max)];
    (0..scene.dimension().count()).map(range).collect()
}

/// A number that is at most the largest gap of two boxes along an axis.
fn gap(one: &Extent, other: &Extent) -> f64 {
    let gaps = one.iter().zip(other).map(|([low, high], [from, to])| (from - high).max(low - to));
    let largest = gaps.fold(0.0, f64::max);
    if largest > 0.0 { largest.min(f64::MAX).next_down() } else { 0.0 }
}

impl Truth {
    /// Compares all pairs of features.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    pub fn new(scene: &Scene, objects: [&Object; 2], watch: &Watch) -> Result<Truth, Stop> {
        let dimension = scene.dimension().count();
        let points: BTreeMap<Vertex, Point> =
            objects.iter().flat_map(|object| object.vertices()).map(|v| (v, point(scene, v))).collect();
        let extents = objects.map(|object| object.parts().map(|part| extent(scene, part)).collect::<Vec<Extent>>());
        let (mut least, mut pairs): (Option<Rational>, BTreeSet<Pair>) = (None, BTreeSet::new());
        let (mut seen, mut crossings): (BTreeSet<Pair>, BTreeSet<Pair>) = (BTreeSet::new(), BTreeSet::new());
        // Near parts first, so that few pairs need rationals.
        let mut order: Vec<(f64, usize, usize)> = Vec::new();
        for (i, one) in extents[0].iter().enumerate() {
            watch.done(0)?;
            let first = extents[1].iter().enumerate().map(|(j, other)| (gap(one, other), i, j));
            order.extend(first.min_by(|one, other| one.0.total_cmp(&other.0)));
        }
        order.sort_unstable_by(|one, other| one.0.total_cmp(&other.0));
        order.truncate(64);
        let all = (0..extents[0].len()).flat_map(|i| (0..extents[1].len()).map(move |j| (i, j)));
        let early = order.into_iter().map(|(_, i, j)| (i, j)).collect::<Vec<_>>();
        // The largest double that is known to be at least the distance.
        let mut limit = f64::INFINITY;
        for (i, j) in early.into_iter().chain(all) {
            let apart = gap(&extents[0][i], &extents[1][j]);
            if apart > limit {
                continue;
            }
            watch.done(0)?;
            let [one, other] = [objects[0].parts().nth(i), objects[1].parts().nth(j)];
            let [Some(one), Some(other)] = [one, other] else { continue };
            for first in Feature::closure(one) {
                for second in Feature::closure(other) {
                    let rank = first.rank() + second.rank();
                    if rank > dimension || !seen.insert([first, second]) {
                        continue;
                    }
                    let corners = |feature: &Feature| feature.corners().iter().map(|v| &points[v]).collect::<Vec<_>>();
                    let Some(found) = solved::solved(&corners(&first), &corners(&second)) else { continue };
                    if rank == dimension {
                        crossings.insert([first, second]);
                    } else if least.as_ref().is_none_or(|least| found.squared < *least) {
                        limit = above(&found.squared);
                        (least, pairs) = (Some(found.squared), BTreeSet::from([[first, second]]));
                    } else if least.as_ref() == Some(&found.squared) {
                        pairs.insert([first, second]);
                    }
                }
            }
        }
        let squared = least.unwrap_or_default();
        let inside =
            |one: usize, other: usize| inside::has_inside(scene, objects[other], objects[one].vertices().into_iter());
        let crosses = !crossings.is_empty();
        let kind = match squared == 0 || crosses {
            true if crosses || inside(0, 1) || inside(1, 0) => Kind::Crossing,
            true => Kind::Touching,
            false if inside(0, 1) || inside(1, 0) => Kind::Contained,
            false => Kind::Apart,
        };
        let has_pairs = matches!(kind, Kind::Apart | Kind::Touching);
        let squared = if kind.is_zero() { Rational::new() } else { squared };
        Ok(Truth { kind, squared, pairs: if has_pairs { pairs } else { BTreeSet::new() }, crossings })
    }
}

/// A double whose square is at least this number.
fn above(squared: &Rational) -> f64 {
    root(squared).next_up()
}

/// The square root as a double, less than an ulp too small or too large; infinite if it is too large for doubles.
#[must_use]
pub fn root(squared: &Rational) -> f64 {
    if *squared == 0 {
        return 0.0;
    }
    // Scaled by a power of four to an integer of about 160 bits, whose root has 80.
    let bits = i64::from(squared.numer().significant_bits()) - i64::from(squared.denom().significant_bits());
    let half = i32::try_from((160 - bits).div_euclid(2)).expect("exponents of doubles are small");
    let scaled = if half >= 0 { squared.clone() << (2 * half) } else { squared.clone() >> (-2 * half) };
    let root = Rational::from(scaled.ceil().into_numer_denom().0.sqrt() + 1_u32);
    let root = if half >= 0 { root >> half } else { root << -half };
    // `to_f64` rounds towards zero, and the root is too large by less than a part in 2^79.
    root.to_f64()
}
