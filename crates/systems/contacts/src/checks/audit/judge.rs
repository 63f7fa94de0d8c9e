//! Judges one answer by the guarantee of its tolerance.

use std::cmp::Ordering;

use crate::answer::Weights;
use predicament_error_calculus::Enclosure;
use predicament_predicates::{Band, Dimension, Predicates};
use rug::Rational;

use super::pair::{Feet, Pair, PairKind};
use super::quantity::Quantity;
use super::reading::Readings;
use predicament_laws::published::Published;

/// Whether an answer keeps the guarantee, and if not, how it fails.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Verdict {
    /// Registered up to T₋ and not beyond T₊; of pairs of full dimension, if
    /// and only if they cross.
    Agree,
    /// The distance is between T₋ and T₊: either answer is right.
    InBand,
    /// Registered beyond T₊, with a foot outside, or without a crossing.
    Overreach,
    /// Not registered up to T₋, or in spite of a crossing.
    Missed,
    /// Rightly registered, but a quantity that the paper bounds away from zero
    /// is below its bound: a sub-pair should have been registered.
    Unguarded,
    /// Registered with a weight that is not in [0, 1].
    BadWeight,
    /// Registered although a sub-pair was, or never to be asked about.
    Unasked,
    /// A test of the algorithm that has to fail passed, or all that have to pass did
    /// not: see [`Readings`](super::Readings).
    Misread,
}

impl Verdict {
    /// All of them.
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

    /// Whether the guarantee held.
    #[must_use]
    pub const fn is_legal(self) -> bool {
        matches!(self, Verdict::Agree | Verdict::InBand)
    }

    /// In lower case, with underscores.
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

/// A verdict, and how near its distance is to the threshold.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Judgement {
    /// The verdict.
    pub verdict: Verdict,
    /// Of a pair that was rightly registered: the largest difference of a
    /// weight to the exact one.
    pub weight_error: Option<f64>,
    /// How far the distance is from T₋ or T₊, as [`Bands::from_threshold`].
    pub from_threshold: Option<f64>,
    /// Of a pair that was rightly registered: the smallest quotient of a
    /// guarded quantity and its lower bound, squared as both are.
    pub room: Option<f64>,
}

impl Judgement {
    /// A verdict on a pair that was never to be asked about.
    pub(super) const fn unasked() -> Judgement {
        Judgement { verdict: Verdict::Unasked, weight_error: None, from_threshold: None, room: None }
    }
}

/// The bands that contacts are held to, and what follows from them, squared.
///
/// They are the published ones, whatever the session says of its own. Sessions without bands have zeros: then the guarantee is that of exact
/// arithmetic, a pair is registered if and only if it meets.
#[derive(Clone, Debug)]
pub struct Bands {
    /// T₋² and T₊² of vertex-vertex, edge-vertex, edge-edge and triangle-vertex.
    limits: [[Rational; 2]; 4],
    /// For each kind the lower bounds of its guarded quantities, squared; the
    /// last is for all that are left.
    bounds: [Vec<Rational>; 6],
    /// What the tests of the algorithms are held to.
    published: Option<Published>,
}

impl Bands {
    /// Those that a session has to keep.
    #[must_use]
    pub fn of<S: Predicates + ?Sized>(session: &S) -> Bands {
        match Published::of(session) {
            Some(published) => Bands::published(published),
            None => Bands::new(session.scene().dimension(), |_| None),
        }
    }

    /// The published ones, for whole pairs and for single tests.
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

    /// By the ranks of the pair, the higher first. Single tests are held to nothing.
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

    /// Of a pair that is within T₊ or crosses, and of which no sub-pair is within T₋: the
    /// smallest quotient of a guarded quantity and its lower bound, squared. None for
    /// other pairs, of which nothing is claimed, and where nothing is guarded.
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

    /// Whether an answer breaks the promise of a single test, whatever the
    /// sub-pairs are; never where no test is promised anything.
    #[must_use]
    pub fn misreads(&self, pair: &Pair, registered: bool) -> bool {
        self.published
            .as_ref()
            .and_then(|published| Readings::of(published, pair).expected())
            .is_some_and(|has| has != registered)
    }

    /// Whether tests are promised anything.
    #[must_use]
    pub fn has_readings(&self) -> bool {
        self.published.is_some()
    }

    /// The verdict on a pair of which no sub-pair is registered.
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

    /// Of a pair that has a tolerance and feet inside: the difference between
    /// its distance and the nearer of T₋ and T₊, as a part of that. To be
    /// counted and not to be relied on: it comes from rounded values.
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

    /// Whether every guarded quantity is at least what the paper derives from
    /// "no sub-pair is registered".
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

/// The bounds that 4.3 to 5.7 derive, squared, in the order of
/// [`Feet::guarded`].
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
