//! The judgement of one answer by the guarantee of its tolerance.

use std::cmp::Ordering;

use crate::answer::Weights;
use predicament_error_calculus::Enclosure;
use predicament_predicates::{Band, Dimension, Predicates};
use rug::Rational;

use super::pair::{Feet, Pair, PairKind};
use super::quantity::Quantity;
use super::reading::Readings;
use predicament_laws::published::Published;

/// The verdict on an answer: the guarantee holds, or how it is broken.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Verdict {
    /// The answer is right: registered up to T₋ and not beyond T₊; a pair of full dimension, if and only if it crosses.
    Agree,
    /// The distance is between T₋ and T₊: either answer is right.
    InBand,
    /// The pair is registered beyond T₊, with a foot outside, or without a crossing.
    Overreach,
    /// The pair is not registered, although it is within T₋ or crosses.
    Missed,
    /// The pair is rightly registered, but a quantity that the paper bounds away from zero is below its bound: a
    /// sub-pair should have been registered.
    Unguarded,
    /// The pair is registered with a weight outside of [0, 1].
    BadWeight,
    /// The pair is registered although a sub-pair is, or although it must not be queried.
    Unasked,
    /// The answer contradicts the tests of the algorithm: a test that has to fail passed, or not all tests passed
    /// although they have to. See [`Readings`](super::Readings).
    Misread,
}

impl Verdict {
    /// All verdicts.
    pub const ALL: [Verdict; 8] = [
        Verdict::Agree,
        Verdict::InBand,
        Verdict::Overreach,
        Verdict::Missed,
        Verdict::Unguarded,
        Verdict::BadWeight,
        Verdict::Unasked,
        Verdict::Misread,
    ];

    /// True if the guarantee holds.
    #[must_use]
    pub const fn is_legal(self) -> bool {
        matches!(self, Verdict::Agree | Verdict::InBand)
    }

    /// The verdict's name, in lower case with underscores.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Verdict::Agree => "agree",
            Verdict::InBand => "in_band",
            Verdict::Overreach => "overreach",
            Verdict::Missed => "missed",
            Verdict::Unguarded => "unguarded",
            Verdict::BadWeight => "bad_weight",
            Verdict::Unasked => "unasked",
            Verdict::Misread => "misread",
        }
    }
}

/// A verdict, and the distance of the pair from the threshold.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Judgement {
    /// The verdict.
    pub verdict: Verdict,
    /// The largest error of a weight, if the pair was rightly registered.
    pub weight_error: Option<f64>,
    /// The distance from T₋ or T₊, like [`Bands::from_threshold`].
    pub from_threshold: Option<f64>,
    /// The smallest quotient of a guarded quantity and its lower bound, both squared, if the pair was rightly
    /// registered.
    pub room: Option<f64>,
}

impl Judgement {
    /// A judgement of a pair that must not be queried.
    pub(super) const fn unasked() -> Judgement {
        Judgement { verdict: Verdict::Unasked, weight_error: None, from_threshold: None, room: None }
    }
}

/// The published bands for contacts, and the bounds derived from them, squared.
///
/// The session's own bands do not matter. For sessions without bands all are zero: then the guarantee is that of exact
/// arithmetic, a pair is registered if and only if it meets.
#[derive(Clone, Debug)]
pub struct Bands {
    /// T₋² and T₊² of vertex-vertex, edge-vertex, edge-edge and triangle-vertex.
    limits: [[Rational; 2]; 4],
    /// For each kind, the lower bounds of its guarded quantities, squared; the last bound is for all further
    /// quantities.
    bounds: [Vec<Rational>; 6],
    /// The published tolerances, for single tests of the algorithms.
    published: Option<Published>,
}

impl Bands {
    /// The bands that a session has to keep.
    #[must_use]
    pub fn of<S: Predicates + ?Sized>(session: &S) -> Bands {
        match Published::of(session) {
            Some(published) => Bands::published(published),
            None => Bands::new(session.scene().dimension(), |_| None),
        }
    }

    /// The published bands, for whole pairs and for single tests.
    #[must_use]
    pub fn published(published: Published) -> Bands {
        let dimension = published.dimension();
        let of = |kind: PairKind| {
            let symbol = published.distance(kind.ranks());
            symbol.map_or_else(Default::default, |symbol| {
                let [lower, _, upper] = published.limits(symbol).clone();
                [lower, upper]
            })
        };
        Bands { published: Some(published.clone()), ..Bands::squared(dimension, of) }
    }

    /// Bands by the ranks of a pair, the higher first, without limits for single tests.
    #[must_use]
    pub fn new(dimension: Dimension, band: impl Fn([u8; 2]) -> Option<Band>) -> Bands {
        let square = |x: f64| Rational::from_f64(x).expect("a tolerance is finite").square();
        let of = |kind: PairKind| match band(kind.ranks()) {
            Some(band) => [square(band.lower), square(band.upper)],
            None => Default::default(),
        };
        Bands::squared(dimension, of)
    }

    fn squared(dimension: Dimension, of: impl Fn(PairKind) -> [Rational; 2]) -> Bands {
        let kinds = [PairKind::VertexVertex, PairKind::EdgeVertex, PairKind::EdgeEdge, PairKind::TriangleVertex];
        let limits = kinds.map(of);
        let bounds = PairKind::ALL.map(|kind| bounds(kind, dimension, &limits));
        Bands { limits, bounds, published: None }
    }

    /// The largest distance at which a pair may be registered.
    #[must_use]
    pub fn reach(&self) -> f64 {
        let upper = self.limits.iter().map(|[_, upper]| upper).max().expect("four kinds");
        Enclosure::exact(upper.clone()).sqrt().upper.to_f64().next_up()
    }

    /// The smallest quotient of a guarded quantity and its lower bound, squared, for a pair that is within T₊ or
    /// crosses and has no sub-pair within T₋.
    ///
    /// `None` for other pairs, for which the paper claims nothing, and if nothing is guarded.
    #[must_use]
    pub fn guard(&self, pair: &Pair) -> Option<f64> {
        let within = |pair: &Pair, feet: &Feet, limit: usize| {
            let limits = self.limits.get(pair.kind() as usize).filter(|_| !pair.is_top());
            limits.is_none_or(|limits| feet.distance_squared.compare(&limits[limit]) != Ordering::Greater)
        };
        let feet = pair.feet().filter(|feet| within(pair, feet, 1))?;
        let mut sub_pairs = pair.sub_pairs();
        let is_degenerate = sub_pairs.any(|sub_pair| sub_pair.feet().is_some_and(|feet| within(&sub_pair, &feet, 0)));
        if is_degenerate { None } else { self.room(pair, &feet) }
    }

    /// True if an answer breaks the promise of a single test, for any sub-pairs; always false if there are no such
    /// promises.
    #[must_use]
    pub fn misreads(&self, pair: &Pair, registered: bool) -> bool {
        self.published
            .as_ref()
            .and_then(|published| Readings::of(published, pair).expected())
            .is_some_and(|has| has != registered)
    }

    /// True if there are promises for single tests.
    #[must_use]
    pub fn has_readings(&self) -> bool {
        self.published.is_some()
    }

    /// The verdict on a pair without a registered sub-pair.
    #[must_use]
    pub fn judge(&self, pair: &Pair, got: Option<&[Weights; 2]>) -> Judgement {
        let feet = pair.feet();
        let beyond = |limit: usize| {
            feet.as_ref().is_none_or(|feet| match self.limits.get(pair.kind() as usize) {
                Some(limits) if !pair.is_top() => feet.distance_squared.compare(&limits[limit]) == Ordering::Greater,
                _ => false,
            })
        };
        let verdict = match (got, beyond(0), beyond(1)) {
            (None, false, _) => Verdict::Missed,
            (None, true, false) => Verdict::InBand,
            (None, true, true) => Verdict::Agree,
            (Some(_), _, true) => Verdict::Overreach,
            (Some(got), _, _) if !got.as_flattened().iter().all(|w| (0.0..=1.0).contains(w)) => Verdict::BadWeight,
            (Some(_), ..) if feet.as_ref().is_some_and(|feet| !self.guards(pair, feet)) => Verdict::Unguarded,
            (Some(_), true, false) => Verdict::InBand,
            (Some(_), false, false) => Verdict::Agree,
        };
        let verdict = if verdict.is_legal() && self.misreads(pair, got.is_some()) { Verdict::Misread } else { verdict };
        let from_threshold = feet.as_ref().and_then(|feet| self.off(pair, feet));
        let registered = feet.zip(got).filter(|_| verdict != Verdict::Overreach);
        let room = registered.as_ref().and_then(|(feet, _)| self.room(pair, feet));
        Judgement { verdict, weight_error: registered.map(|(feet, got)| feet.weight_error(got)), from_threshold, room }
    }

    /// The difference between a pair's distance and the nearer of T₋ and T₊, as a fraction of that limit; for a pair
    /// with a tolerance and feet inside.
    ///
    /// The value is for statistics only: it comes from rounded values.
    #[must_use]
    pub fn from_threshold(&self, pair: &Pair) -> Option<f64> {
        self.off(pair, &pair.feet()?)
    }

    fn off(&self, pair: &Pair, feet: &Feet) -> Option<f64> {
        let limits = self.limits.get(pair.kind() as usize).filter(|[lower, _]| !pair.is_top() && !lower.is_zero())?;
        let off = limits.each_ref().map(|limit| (feet.distance_squared.over(limit).sqrt() - 1.0).abs());
        Some(off[0].min(off[1]))
    }

    fn room(&self, pair: &Pair, feet: &Feet) -> Option<f64> {
        let quotients = self.guarded(pair, feet).filter(|(_, bound)| !bound.is_zero());
        quotients.map(|(quantity, bound)| quantity.over(bound)).reduce(f64::min)
    }

    /// True if every guarded quantity is at least the bound that the paper derives from "no sub-pair is registered".
    fn guards(&self, pair: &Pair, feet: &Feet) -> bool {
        self.guarded(pair, feet).all(|(quantity, bound)| quantity.compare(bound) != Ordering::Less)
    }

    /// The guarded quantities with their bounds.
    fn guarded<'f>(&'f self, pair: &Pair, feet: &'f Feet) -> impl Iterator<Item = (&'f Quantity, &'f Rational)> {
        let bounds = &self.bounds[pair.kind() as usize];
        let guarded = feet.guarded.iter().enumerate();
        guarded.filter_map(|(i, quantity)| Some((quantity, bounds.get(i).or(bounds.last())?)))
    }
}

/// The bounds that sections 4.3 to 5.7 derive, squared, in the order of [`Feet::guarded`].
fn bounds(kind: PairKind, dimension: Dimension, limits: &[[Rational; 2]; 4]) -> Vec<Rational> {
    let [[sigma, _], [tau, tau_upper], [gamma, gamma_upper], [delta, delta_upper]] = limits;
    let squared = |x: &Rational| Rational::from(x.square_ref());
    // (τ₋² − γ₊²)⁴ and (τ₋² − δ₊²)⁴
    let gap = |upper: &Rational| squared(&squared(&Rational::from(tau - upper)));
    // γ₋⁴ min(γ₋, δ₋)²
    let slab = || squared(gamma) * gamma.min(delta);
    match (kind, dimension) {
        (PairKind::VertexVertex, _) => vec![],
        // â² and ā² against σ₋² − τ₊²
        (PairKind::EdgeVertex, _) => vec![Rational::from(sigma - tau_upper)],
        // κ₊ = 2τ₋²
        (PairKind::EdgeEdge | PairKind::TriangleVertex, Dimension::Two) => vec![squared(tau) * 4],
        // λ₊ = 16(τ₋² − γ₊²)² and φ₊ = 8(τ₋² − γ₊²)²
        (PairKind::EdgeEdge, _) => vec![gap(gamma_upper) * 256, gap(gamma_upper) * 64],
        // ν₊ = 108(τ₋² − δ₊²)² and ζ₊ = 12√3(τ₋² − δ₊²)²
        (PairKind::TriangleVertex, _) => vec![gap(delta_upper) * 11664, gap(delta_upper) * 432],
        // μ₊ = 4γ₋² min(γ₋, δ₋), three times, and ξ₊ = 6√3γ₋² min(γ₋, δ₋)
        (PairKind::TriangleEdge, _) => vec![slab() * 16, slab() * 16, slab() * 16, slab() * 108],
        // ρ₊ = 6√3δ₋³
        (PairKind::TetrahedronVertex, _) => vec![squared(delta) * delta * 108],
    }
}

#[cfg(test)]
mod tests;
