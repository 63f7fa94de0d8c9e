//! Tests of bounds by their formulas, and of verdicts at the limits of a band.

use predicament_predicates::Dimension::{Three, Two};

use super::*;

fn rationals(numbers: &[u32]) -> Vec<Rational> {
    numbers.iter().map(|&x| Rational::from(x)).collect()
}

/// The squares T₋² and T₊²: σ 90 and 100, τ 40 and 50, γ 20 and 27, δ 10 and 13.
fn limits() -> [[Rational; 2]; 4] {
    [[90, 100], [40, 50], [20, 27], [10, 13]].map(|pair| pair.map(Rational::from))
}

#[test]
fn bounds_are_those_of_the_formulas() {
    let of = |kind, dimension| bounds(kind, dimension, &limits());
    for dimension in [Two, Three] {
        assert_eq!(of(PairKind::VertexVertex, dimension), rationals(&[]));
        // σ₋² − τ₊²
        assert_eq!(of(PairKind::EdgeVertex, dimension), rationals(&[40]));
    }
    // (2τ₋²)²
    assert_eq!(of(PairKind::EdgeEdge, Two), rationals(&[6400]));
    assert_eq!(of(PairKind::TriangleVertex, Two), rationals(&[6400]));
    // τ₋² − γ₊² = 13, and 13⁴ = 28561, times 16² and 8²
    assert_eq!(of(PairKind::EdgeEdge, Three), rationals(&[7_311_616, 1_827_904]));
    // τ₋² − δ₊² = 27, and 27⁴ = 531441, times 108² and (12√3)²
    let triangle = [6_198_727_824_u64, 229_582_512].map(Rational::from);
    assert_eq!(of(PairKind::TriangleVertex, Three), triangle);
    // γ₋⁴ · 10 = 4000, times 4² three times, and (6√3)²
    assert_eq!(of(PairKind::TriangleEdge, Three), rationals(&[64_000, 64_000, 64_000, 432_000]));
    // δ₋⁶ (6√3)²
    assert_eq!(of(PairKind::TetrahedronVertex, Three), rationals(&[108_000]));
    // The smaller of γ and δ counts.
    let mut other = limits();
    other[3] = [30, 31].map(Rational::from);
    assert_eq!(bounds(PairKind::TriangleEdge, Three, &other)[0], 400 * 20 * 16);
}

/// Bands with σ from 2.5 to 3 and τ from 1 to 1.5, so that the foot of an edge is at least 2 from its ends.
fn bands() -> Bands {
    let band = |lower: f64, upper: f64| Some(Band { lower, width: f64::midpoint(lower, upper), upper });
    Bands::new(Two, |ranks| match ranks {
        [0, 0] => band(2.5, 3.0),
        [1, 0] => band(1.0, 1.5),
        _ => None,
    })
}

const START: [Weights; 2] = [[0.5, 0.5, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]];

/// The verdicts for a pair that is not registered and for a registered one.
fn verdicts(bands: &Bands, pair: &Pair) -> [Verdict; 2] {
    [bands.judge(pair, None).verdict, bands.judge(pair, Some(&START)).verdict]
}

fn vertices(distance: f64) -> Pair {
    Pair::new(&[[0.0, 0.0]], &[[distance, 0.0]])
}

/// An edge of length 8 and a vertex at this position along it and this distance off it.
fn beside(along: f64, off: f64) -> Pair {
    Pair::new(&[[0.0, 0.0], [8.0, 0.0]], &[[along, off]])
}

/// An edge of length 8 and an edge across its middle, from `from` to `to`.
fn across(from: f64, to: f64) -> Pair {
    Pair::new(&[[0.0, 0.0], [8.0, 0.0]], &[[4.0, from], [4.0, to]])
}

#[test]
fn up_to_the_lower_limit_a_pair_is_registered_and_beyond_the_upper_one_it_is_not() {
    let up_to = [Verdict::Missed, Verdict::Agree];
    let between = [Verdict::InBand; 2];
    let beyond = [Verdict::Agree, Verdict::Overreach];
    let at = |distance: f64| verdicts(&bands(), &vertices(distance));
    assert_eq!([0.0, 2.5, 2.5_f64.next_up(), 3.0, 3.0_f64.next_up()].map(at), [up_to, up_to, between, between, beyond]);
    let at = |off: f64| verdicts(&bands(), &beside(4.0, off));
    assert_eq!([0.0, 1.0, 1.0_f64.next_up(), 1.5, 1.5_f64.next_up()].map(at), [up_to, up_to, between, between, beyond]);
    // Beside the edge's end there is no foot, and without a tolerance there is no band.
    assert_eq!(verdicts(&bands(), &beside(-1.0, 0.0)), beyond);
    let none = Bands::new(Two, |_| None);
    assert_eq!([0.0, f64::MIN_POSITIVE].map(|at| verdicts(&none, &vertices(at))), [up_to, beyond]);
}

#[test]
fn pairs_of_full_dimension_are_registered_where_they_cross() {
    assert_eq!(verdicts(&bands(), &across(-1.0, 1.0)), [Verdict::Missed, Verdict::Agree]);
    assert_eq!(verdicts(&bands(), &across(0.0, 1.0)), [Verdict::Agree, Verdict::Overreach]);
    assert_eq!(verdicts(&bands(), &across(0.125, 1.0)), [Verdict::Agree, Verdict::Overreach]);
}

#[test]
fn a_guarded_quantity_is_at_least_its_bound() {
    let registered = |pair: &Pair| bands().judge(pair, Some(&START)).verdict;
    let [below, above] = [2.0_f64.next_down(), 6.0_f64.next_up()];
    assert_eq!([2.0, 6.0].map(|along| registered(&beside(along, 1.0))), [Verdict::Agree; 2]);
    assert_eq!([below, above].map(|along| registered(&beside(along, 1.0))), [Verdict::Unguarded; 2]);
    assert_eq!([below, above].map(|along| registered(&beside(along, 1.25))), [Verdict::Unguarded; 2]);
    // Twice the area is 8 times the height, and at least 2τ₋² = 2.
    assert_eq!(registered(&across(-0.25, 1.0)), Verdict::Agree);
    assert_eq!(registered(&across(-0.25_f64.next_down(), 1.0)), Verdict::Unguarded);
    assert_eq!(registered(&across(-1.0, 0.25_f64.next_down())), Verdict::Unguarded);
}

#[test]
fn weights_are_between_zero_and_one() {
    let verdict = |weights: [Weights; 2]| bands().judge(&beside(4.0, 1.0), Some(&weights)).verdict;
    let start = START;
    assert_eq!(verdict([[0.0, 1.0, 0.0, 0.0], start[1]]), Verdict::Agree);
    for wrong in [-f64::from_bits(1), 1.0_f64.next_up(), f64::NAN] {
        assert_eq!(verdict([[wrong, 0.5, 0.0, 0.0], start[1]]), Verdict::BadWeight, "{wrong}");
        assert_eq!(verdict([start[0], [1.0, 0.0, 0.0, wrong]]), Verdict::BadWeight, "{wrong}");
    }
}

#[test]
fn a_judgement_says_how_near_it_was() {
    let judged = |pair: &Pair, got: Option<&[Weights; 2]>| {
        let Judgement { weight_error, from_threshold, room, .. } = bands().judge(pair, got);
        [weight_error, from_threshold, room]
    };
    // The foot is 3 and 5 from the ends; at least 2 is required. The weights are 5/8 and 3/8.
    assert_eq!(judged(&beside(3.0, 0.75), Some(&START)), [Some(0.125), Some(0.25), Some(2.25)]);
    assert_eq!(
        judged(&beside(6.5, 1.25), Some(&START)),
        [Some(0.3125), Some(f64::abs(1.25 / 1.5 - 1.0)), Some(0.5625)]
    );
    assert_eq!(judged(&beside(3.0, 0.75), None), [None, Some(0.25), None]);
    assert_eq!(judged(&beside(3.0, 3.0), Some(&START)), [None, Some(1.0), None], "overreach");
    assert_eq!(judged(&beside(-1.0, 0.0), Some(&START)), [None; 3], "no foot");
    assert_eq!(judged(&across(-1.0, 2.0), Some(&START)), [Some(1.0 / 3.0), None, Some(16.0)]);
    assert_eq!(Bands::new(Two, |_| None).from_threshold(&vertices(1.0)), None);
    assert_eq!(bands().from_threshold(&vertices(2.0)), Some(1.0 - 0.8));
}

#[test]
fn what_is_guarded_is_claimed_of_pairs_without_a_sub_pair_only() {
    let bands = bands();
    assert_eq!(bands.guard(&beside(4.0, 1.5)), Some(4.0));
    assert_eq!(bands.guard(&beside(4.0, 1.5_f64.next_up())), None, "beyond the upper limit");
    // At (2, 1.5) the vertex is 2.5 from the edge's end.
    assert_eq!(bands.guard(&beside(2.0, 1.5)), None);
    assert!(bands.guard(&beside(2.0_f64.next_up(), 1.5)).is_some_and(|room| (1.0..1.0001).contains(&room)));
    assert_eq!(bands.guard(&beside(-1.0, 0.0)), None, "no foot");
    // Both ends are beyond 1 of the other edge: 8 · 1.25 is five times the claimed bound.
    assert_eq!(bands.guard(&across(-1.25, 4.0)), Some(25.0));
    assert_eq!(bands.guard(&across(-1.0, 4.0)), None);
    assert_eq!(bands.guard(&vertices(1.0)), None, "nothing is guarded");
}

#[test]
fn bands_reach_as_far_as_the_widest_of_them() {
    assert_eq!(bands().reach(), 3.0_f64.next_up());
    assert_eq!(Bands::new(Three, |_| None).reach(), f64::from_bits(1));
}

#[test]
fn tests_are_promised_something_by_published_bands_alone() {
    // Tolerances for ε = 1/16 and L = 1: σ from 1.5 to 1.75, τ from 1 to 1.25, σ̂ from 1.25 to 1.5.
    let published = Bands::published(Published::new(Two, 4, &Enclosure::exact(1.into())));
    assert_eq!([&published, &bands()].map(Bands::has_readings), [true, false]);
    let misreads = |bands: &Bands, pair: &Pair| [false, true].map(|registered| bands.misreads(pair, registered));
    assert_eq!(misreads(&published, &vertices(1.5)), [true, false]);
    assert_eq!(misreads(&published, &vertices(1.625)), [false, false]);
    assert_eq!(misreads(&published, &vertices(1.875)), [false, true]);
    assert_eq!(misreads(&bands(), &vertices(1.0)), [false, false]);
    assert_eq!(verdicts(&published, &vertices(1.5)), [Verdict::Missed, Verdict::Agree]);
    assert_eq!(published.from_threshold(&vertices(2.0)), Some(2.0 / 1.75 - 1.0));
}
