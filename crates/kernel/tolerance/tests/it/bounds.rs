//! The derived bounds against arithmetic: floats, and an adversary that errs by ε in every operation.

use predicament_error_calculus::rules::largest_epsilon;
use predicament_error_calculus::{Adversary, Enclosure, Perturbed, Quantity, Root};
use predicament_predicates::{Backend, Band, Dimension, Off, PredicateKind, Predicates, Scene};
use predicament_tolerance::bounds::coefficient::{Defined, FIGURE_1, FIGURE_5, Tolerance as Row, defined};
use predicament_tolerance::bounds::constraints::{
    At, Constraint, Decision, Origin, constraints, epsilons, validity_limit,
};
use predicament_tolerance::bounds::quantities::{Named, Normalization, Points, plane, space};
use predicament_tolerance::bounds::{Verdict, algorithms, derivations};
use predicament_tolerance::{Misscaled, Tolerance, Tolerances2d, Tolerances3d};
use proptest::prelude::*;
use rug::Rational;

fn bounded<const D: usize>() -> Points<Quantity, D> {
    std::array::from_fn(|point| std::array::from_fn(|axis| Quantity::coordinate(&format!("{point}.{axis}"))))
}

/// The error |computed − exact|, the bound of the calculus for it, and whether the magnitude bound holds.
fn check(bound: &Quantity, epsilon: &Rational, length: &Rational, exact: &Rational, computed: &Rational) {
    // the exact roots are enclosed to 2⁻¹⁹²
    let tiny: Rational = Rational::from(1) >> 150_u32;
    let magnitude = bound.magnitude().expect("valid");
    let p = u32::try_from(magnitude.length_quarters / 4).expect("not negative");
    let unit = (0..p).fold(Rational::from(1), |unit, _| unit * length);
    let size = exact.clone().abs();
    assert!(size <= (Rational::from(&magnitude.c + &tiny)) * &unit, "{}", bound.expression());
    let allowed = match bound.relative() {
        Some(relative) => relative.at(epsilon) * &size,
        None => bound.absolute().expect("valid").at(epsilon) * &unit,
    };
    let off = Rational::from(computed - exact).abs();
    assert!(off <= allowed + tiny * unit, "{} is off by {}", bound.expression(), off.to_f64());
}

/// All quantities of the sections, computed with or without an adversary's errors.
fn perturbed<const D: usize>(points: &Points<Rational, D>, adversary: &Adversary) -> Points<Perturbed, D> {
    std::array::from_fn(|i| std::array::from_fn(|axis| adversary.input(points[i][axis].clone())))
}

type Compute<N, const D: usize> = fn(&Points<N, D>, Normalization) -> Vec<Named<N>>;

/// Tests the bounds against an adversary on one set of points, with L the unit.
fn withstand<const D: usize>(
    sections: (Compute<Quantity, D>, Compute<Perturbed, D>),
    points: &Points<Rational, D>,
    epsilon: &Rational,
    adversary: &Adversary,
) {
    for normalization in [Normalization::Reciprocal, Normalization::Division] {
        let bounds = sections.0(&bounded(), normalization);
        let values = sections.1(&perturbed(points, adversary), normalization);
        for (bound, value) in bounds.iter().zip(values) {
            check(&bound.value, epsilon, &Rational::from(1), &value.value.exact, &value.value.computed);
        }
    }
}

/// Compares floats with exact numbers, with |coordinate| ≤ L/2.
fn rounded<N: Root + Copy, const D: usize>(
    sections: (Compute<Quantity, D>, Compute<Perturbed, D>, Compute<N, D>),
    points: &Points<N, D>,
    rational: fn(N) -> Rational,
    epsilon: &Rational,
    length: &Rational,
) {
    let exact: Points<Rational, D> = points.map(|point| point.map(rational));
    let exact = perturbed(&exact, &Adversary::new(Rational::new));
    for normalization in [Normalization::Reciprocal, Normalization::Division] {
        let bounds = sections.0(&bounded(), normalization);
        let exact = sections.1(&exact, normalization);
        let computed = sections.2(points, normalization);
        for ((bound, exact), computed) in bounds.iter().zip(exact).zip(computed) {
            check(&bound.value, epsilon, length, &exact.value.exact, &rational(computed.value));
        }
    }
}

/// Random errors: −ε, ε or something between, mostly an end.
fn adversary(seed: u64, epsilon: &Rational) -> Adversary {
    let (mut state, epsilon) = (seed, epsilon.clone());
    Adversary::new(move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let k = [-4, -4, -4, 4, 4, 4, 0, 1][(state >> 61) as usize];
        Rational::from(&epsilon * k) / 4
    })
}

/// Six points with coordinates between −½ and ½, in 512ths, with A different from B.
///
/// The ends and repeated values are frequent.
fn points<const D: usize>() -> impl Strategy<Value = [[i16; D]; 6]> {
    let coordinate = prop_oneof![2 => Just(-256_i16), 2 => Just(256), 1 => -3..4_i16, 6 => -256..=256_i16];
    prop::collection::vec(coordinate, 6 * D)
        .prop_map(|all| std::array::from_fn(|i| std::array::from_fn(|axis| all[i * D + axis])))
        .prop_filter("an edge has a length", |points: &[[i16; D]; 6]| points[0] != points[1])
}

/// The points as floats: each 512th of L is off its grid by a few digits.
fn off_grid<const D: usize>(points: [[i16; D]; 6], seed: u64) -> Points<f64, D> {
    let mut state = seed;
    points.map(|point| {
        point.map(|k| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            #[allow(clippy::cast_precision_loss)] // 20 bits fit
            let off = (state >> 44) as f64 * 2.0_f64.powi(-31);
            let x = f64::from(k) / 512.0;
            if x > 0.0 { x - off } else { x + off }
        })
    })
}

fn of_f32(x: f32) -> Rational {
    Rational::from_f32(x).expect("finite")
}

fn of_f64(x: f64) -> Rational {
    Rational::from_f64(x).expect("finite")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(50, 150)))]

    #[test]
    fn the_plane_withstands_an_adversary(points in points::<2>(), seed: u64, halvings in 0_u32..40) {
        let epsilon = largest_epsilon() >> halvings;
        let points = points.map(|point| point.map(|k| Rational::from((k, 512))));
        withstand((plane, plane), &points, &epsilon, &adversary(seed, &epsilon));
    }

    #[test]
    fn space_withstands_an_adversary(points in points::<3>(), seed: u64, halvings in 0_u32..40) {
        let epsilon = largest_epsilon() >> halvings;
        let points = points.map(|point| point.map(|k| Rational::from((k, 512))));
        withstand((space, space), &points, &epsilon, &adversary(seed, &epsilon));
    }

    #[test]
    fn floats_stay_within_the_bounds(flat in points::<2>(), deep in points::<3>(), seed: u64, exponent in -8..8_i32) {
        let (flat, deep) = (off_grid(flat, seed), off_grid(deep, !seed));
        let scale = 2.0_f64.powi(exponent);
        let length = of_f64(scale);
        let epsilon = of_f64(f64::EPSILON);
        rounded((plane, plane, plane), &flat.map(|p| p.map(|x| x * scale)), of_f64, &epsilon, &length);
        rounded((space, space, space), &deep.map(|p| p.map(|x| x * scale)), of_f64, &epsilon, &length);
        let epsilon = of_f32(f32::EPSILON);
        #[allow(clippy::cast_possible_truncation)] // the rounded number is the input
        let narrow = |x: f64| (x * scale) as f32;
        rounded((plane, plane, plane), &flat.map(|p| p.map(narrow)), of_f32, &epsilon, &length);
        rounded((space, space, space), &deep.map(|p| p.map(narrow)), of_f32, &epsilon, &length);
    }
}

#[test]
fn every_published_bound_of_a_quantity_is_reproduced() {
    let all = derivations();
    let of_sections = all.iter().filter(|row| row.section.len() == 3 && !matches!(row.section, "4.1" | "5.1"));
    assert_eq!(of_sections.clone().count(), 43);
    for row in of_sections {
        assert_eq!(row.verdict(), Verdict::Reproduced, "{} {}: {:?}", row.section, row.name, row.whole());
    }
}

/// Bounds of 4.1 and 5.1: one is less than published, and a difference of squares that may be zero has no bound of its
/// root.
#[test]
fn bounds_of_lengths_are_reproduced_but_for_two() {
    let all = derivations();
    let of_lengths = all.iter().filter(|row| matches!(row.section, "4.1" | "5.1"));
    let found: Vec<_> = of_lengths.map(|row| (row.section, row.name.as_str(), row.whole(), row.verdict())).collect();
    assert_eq!(
        found,
        [
            ("4.1", "R[L̂]", Some(4), Verdict::Smaller),
            ("5.1", "R[L̂]", Some(5), Verdict::Reproduced),
            ("5.1", "R[ζ]", Some(4), Verdict::Reproduced),
            ("5.1", "R[ζ²]", Some(9), Verdict::Reproduced),
            ("5.1", "R[√(ζ² − κ²)]", None, Verdict::Invalid),
        ]
    );
}

#[test]
fn the_algorithms_are_those_of_the_tolerances() {
    let constant = |c: Rational| c.to_f64();
    for length in [1.0, 0.3, 1e-20, 7.7e15] {
        let t = Tolerances2d::from_length(length);
        let computed = algorithms::plane(&f64::EPSILON, &length, constant);
        let bands = [t.sigma, t.tau, t.sigma_hat, t.kappa];
        assert_eq!(computed.iter().map(|(_, width)| *width).collect::<Vec<_>>(), bands.map(|band| band.width));
        assert_rows(&FIGURE_1, &bands, length);

        let t = Tolerances3d::from_length(length);
        let computed = algorithms::space(&f64::EPSILON, &length, constant);
        let bands = [t.sigma, t.tau, t.delta, t.gamma, t.sigma_hat, t.lambda, t.phi, t.nu, t.zeta, t.mu, t.xi, t.rho];
        assert_eq!(computed.iter().map(|(_, width)| *width).collect::<Vec<_>>(), bands.map(|band| band.width));
        assert_rows(&FIGURE_5, &bands, length);
    }
}

/// Checks that the rows of a figure are the tolerances of the backend, except for rounding.
fn assert_rows(figure: &[Row], bands: &[Band], length: f64) {
    let at = At::new(of_f64(f64::EPSILON));
    for (row, band) in figure.iter().zip(bands) {
        let powers = (0..row.length).fold(Rational::from(1), |power, _| power * of_f64(length));
        for (c, value) in [(row.lower, band.lower), (row.width, band.width), (row.upper, band.upper)] {
            let exact: Rational = at.of(row, c).upper * &powers;
            let off: Rational = of_f64(value) - &exact;
            assert!(off.abs() <= exact * of_f64(8.0 * f64::EPSILON), "{} {value}", row.symbol);
        }
    }
}

#[test]
fn what_the_enclosures_cannot_tell_apart_is_undecided() {
    let number = |x: (i32, i32)| Enclosure::exact(Rational::from(x));
    let greater = |left: Enclosure, right: Enclosure| {
        Constraint::greater("", Origin::Ours, "", move |_| [left.clone(), right.clone()])
    };
    let at = At::new(Rational::from((1, 100_000)));
    let two = number((2, 1)).sqrt() * number((2, 1)).sqrt();
    assert_eq!(greater(number((3, 1)), two.clone()).decide(&at), Decision::Holds);
    assert_eq!(greater(number((1, 1)), two.clone()).decide(&at), Decision::Fails);
    assert_eq!(greater(number((2, 1)), two).decide(&at), Decision::Undecided);
    assert_eq!(greater(number((2, 1)), number((2, 1))).decide(&at), Decision::Fails, "greater, not equal");
}

/// Slacks of the constraints on lengths in space, by hand: τ is 4, 4½ and 5 ε^¼ there.
#[test]
fn slacks_on_lengths_in_space_are_those_by_hand() {
    let all = constraints();
    for exponent in [-60, -52, -24] {
        let epsilon = 2f64.powi(exponent);
        let at = At::new(of_f64(epsilon));
        let (root, fourth) = (epsilon.sqrt(), epsilon.sqrt().sqrt());
        let squares = 261.0 * epsilon + 9.0 * epsilon * 4.5 * 4.5 * root;
        for (text, expected) in [
            ("min(τ₊ − τ, τ − τ₋) > 131εL²/τ", 0.5 * fourth - 131.0 * epsilon / (4.5 * fourth)),
            ("τ² − τ₋² > 261εL² + 9ετ²", (4.5 * 4.5 - 16.0) * root - squares),
            ("τ₊² − τ² > 261εL² + 9ετ²", (25.0 - 4.5 * 4.5) * root - squares),
            ("√(σ₋² − τ₊²) > E[ā] = 42εL", (36.0_f64 - 25.0).sqrt() * fourth - 42.0 * epsilon),
            ("√(σ₋² − τ₊²) > E[â] = 31εL", (36.0_f64 - 25.0).sqrt() * fourth - 31.0 * epsilon),
            ("τ₊ < (√3/2) σ₋", (3f64.sqrt() / 2.0 * 6.0 - 5.0) * fourth),
        ] {
            let found = all.iter().find(|constraint| constraint.text == text && constraint.section.starts_with('5'));
            let slack = found.expect(text).slack(&at).expect("an inequality").lower.to_f64();
            assert!((slack - expected).abs() <= 1e-12 * expected.abs(), "{text}: {slack:e}, {expected:e}");
        }
    }
}

/// All constraints on the gaps of a tolerance, by the backend's own tolerances.
#[test]
fn slacks_on_rooms_are_those_of_the_bands() {
    let (flat, deep) = (Tolerances2d::from_length(1.0_f64), Tolerances3d::from_length(1.0_f64));
    let at = At::new(of_f64(f64::EPSILON));
    let mut found = 0;
    for constraint in constraints() {
        let bands = if constraint.section.starts_with('4') { &flat.bands()[..] } else { &deep.bands()[..] };
        let named = bands.iter().find(|(t, _)| constraint.text.starts_with(&format!("min({t}₊ − {t}, {t} − {t}₋) > ")));
        let Some((symbol, band)) = named else { continue };
        let (_, right) = constraint.text.split_once("> ").unwrap();
        let (k, of) = right.split_once('ε').unwrap();
        let unit = match of {
            "σ" => band.width,
            "L²/τ" => 1.0 / band.width,
            _ => 1.0,
        };
        let room = (band.upper - band.width).min(band.width - band.lower);
        let expected = room - k.parse::<f64>().unwrap() * f64::EPSILON * unit;
        let slack = constraint.slack(&at).unwrap().lower.to_f64();
        // Bands are rounded, by units of the values whose difference they are.
        let rounding = 8.0 * f64::EPSILON * band.upper;
        assert!((slack - expected).abs() <= rounding, "{} {symbol}: {slack:e}, {expected:e}", constraint.text);
        found += 1;
    }
    assert_eq!(found, 18);
}

/// The steps of 5.4.4 at the largest ε, by hand, from the numbers of figure 5 before the powers of ε.
#[test]
fn slacks_on_heights_are_those_by_hand() {
    let all = constraints();
    let epsilon = 1e-5_f64;
    let at = At::new(Rational::from((1, 100_000)));
    let coefficient = |symbol: &str| {
        let row = FIGURE_5.iter().find(|row| row.symbol == symbol).unwrap();
        [row.lower, row.width, row.upper].map(|c| c.value().upper.to_f64())
    };
    let ([below, gamma, above], [least, _, assumed]) = (coefficient("γ"), coefficient("λ"));
    let (fourth, more) = (epsilon.powf(0.25), 1.0 + epsilon);
    let root = 94.0 * 1.2_f64.sqrt() * fourth * more;
    let chain = |m_squared: f64| {
        let g = gamma * m_squared.sqrt();
        (2.0 / 35.0 - 1.2 * epsilon) * g * g - (root * g + 2209.0 * fourth * fourth * more)
    };
    let height = |sign: f64| {
        let factor = (1.0 + sign * 10.0 * epsilon) * (1.0 + sign * epsilon) / (1.0 - sign * epsilon);
        gamma * (factor * (least + sign * 129.0)).sqrt()
    };
    for (text, expected) in [
        (
            "1/7 > (1 + 12ε) R[m²] + 12ε, R[m²] < 129/910",
            1.0 / 7.0 - ((1.0 + 12.0 * epsilon) * 129.0 / least + 12.0 * epsilon),
        ),
        (
            "−5 ≥ (351/4)(6ε/5 − 2/35) + 94√(6/5) ε^¼ (1 + ε), displayed",
            87.75 * (2.0 / 35.0 - 1.2 * epsilon) - 5.0 - root,
        ),
        ("−400 ≥ −1755/4 + 47²√ε (1 + ε), displayed", 438.75 - 400.0 - 2209.0 * fourth * fourth * more),
        ("g(2γ²m²/35) < 0 where m² > λ₊, displayed", chain(assumed)),
        ("g(2γ²m²/35) < 0 where m² > λ₋, which is known", chain(least)),
        ("g′ < −0.9", 0.1 - epsilon - 188.0 / 351.0 * fourth * more),
        ("γ₊² > (6/5) γ²", above * above - 1.2 * gamma * gamma),
        ("(4/5) γ² > γ₋²", 0.8 * gamma * gamma - below * below),
        ("direct: what passes has d̂² ≤ γ₊²m²", above * least.sqrt() - height(1.0) - 47.0 * fourth),
        ("direct: what does not pass has d̂² > γ₋²m²", height(-1.0) - 47.0 * fourth - below * least.sqrt()),
    ] {
        let found = all.iter().find(|constraint| constraint.text == text).expect(text);
        let slack = found.slack(&at).expect("an inequality").lower.to_f64();
        assert!((slack - expected).abs() <= 1e-9 * expected.abs(), "{text}: {slack:e}, {expected:e}");
    }
}

/// Slacks for the bands of `incircle` and `insphere`: 130, 260, 390 and 1130, 2260, 3390 times ε.
#[test]
fn slacks_on_circles_are_those_by_hand() {
    let all = constraints();
    for epsilon in [f64::EPSILON, f64::from(f32::EPSILON)] {
        let at = At::new(of_f64(epsilon));
        for (text, expected) in [
            ("incircle: min(T₊ − T, T − T₋) > 129εL⁴ + 5εT", 130.0 - 129.0 - 5.0 * epsilon * 260.0),
            ("incircle: T₋ > E = 129εL⁴", 1.0),
            ("insphere: min(T₊ − T, T − T₋) > 1129εL⁵ + 6εT", 1130.0 - 1129.0 - 6.0 * epsilon * 2260.0),
            ("insphere: T₋ > E = 1129εL⁵", 1.0),
        ] {
            let found = all.iter().find(|constraint| constraint.text == text).expect(text);
            assert_eq!(found.origin.as_str(), "ours");
            let slack = found.slack(&at).expect("an inequality").lower.to_f64() / epsilon;
            assert!((slack - expected).abs() <= 1e-9, "{text}: {slack:e}, {expected:e}");
        }
    }
}

#[test]
fn claims_are_decided_at_unit_roundoff_machine_epsilon_and_the_largest() {
    let found = epsilons().map(|(name, epsilon)| (name, epsilon.to_f64()));
    let halves = 0.5_f64;
    let expected = [
        ("2^-53", halves.powi(53)),
        ("2^-52", f64::EPSILON),
        ("2^-24", halves.powi(24)),
        ("2^-23", f64::from(f32::EPSILON)),
        ("10^-5", 1e-5),
    ];
    // (A rational is rounded toward zero.)
    assert!(found.iter().zip(&expected).all(|(x, y)| x.0 == y.0 && (x.1 - y.1).abs() <= 1e-20), "{found:?}");
}

/// All doubled tolerances are detected, and of the halved ones σ, τ, γ, δ, σ̂ and μ: the others keep the promise.
#[test]
fn planted_tolerances_that_keep_their_promise_are_not_visible() {
    assert_eq!(Misscaled::visible().filter(|planted| !planted.halved).count(), 16);
    let halved: Vec<&str> = Misscaled::visible().filter(|planted| planted.halved).map(Misscaled::name).collect();
    assert_eq!(
        halved,
        [
            "halved-sigma-2d",
            "halved-tau-2d",
            "halved-sigma-hat-2d",
            "halved-sigma-3d",
            "halved-tau-3d",
            "halved-delta",
            "halved-gamma",
            "halved-sigma-hat-3d",
            "halved-mu",
        ]
    );
}

#[test]
fn names_in_tables() {
    let origins = [Origin::Paper, Origin::Argument, Origin::Ours].map(Origin::as_str);
    assert_eq!(origins, ["paper", "argument", "ours"]);
    let decisions = [Decision::Holds, Decision::Fails, Decision::Undecided].map(Decision::as_str);
    assert_eq!(decisions, ["holds", "fails", "undecided"]);
    let verdicts = [Verdict::Reproduced, Verdict::Smaller, Verdict::Larger, Verdict::Invalid, Verdict::Ours];
    assert_eq!(verdicts.map(Verdict::as_str), ["reproduced", "smaller", "larger", "invalid", "ours"]);
}

/// Figures 1 and 5 print the formulas' values; rounded ones to the nearest whole number, 1975.8 and 83.1 twice.
#[test]
fn definitions_are_as_they_are_printed() {
    let all = defined();
    assert_eq!(all.len(), 9);
    for row in &all {
        assert!(row.is_exact() && row.is_as_printed(), "{} {}", row.section, row.symbol);
        let value = row.value();
        let nearest = value.lower.clone().round();
        assert_eq!(row.tolerance.printed_upper.starts_with('≈'), row.root3);
        if row.root3 {
            assert_eq!(row.tolerance.printed_upper, format!("≈{nearest}"));
        }
    }
    // One of the rounded values in place of another.
    let zeta = all.iter().find(|row| row.symbol == "ζ").unwrap();
    for (factor, is_printed) in [(0.999, false), (0.9999, true), (1.0003, true), (1.001, false)] {
        let derived = Rational::from(&zeta.derived * &of_f64(factor));
        let other = Defined { derived, formula: "", ..*zeta };
        assert_eq!((other.is_exact(), other.is_as_printed()), (false, is_printed), "{factor}");
    }
}

/// Each planted tolerance is off by a factor of two, with its band, and no other is.
#[test]
fn a_planted_tolerance_is_off_and_no_other() {
    let flat = Tolerances2d::from_length(1.0_f64);
    let deep = Tolerances3d::from_length(1.0_f64);
    for planted in Misscaled::ALL {
        let factor = if planted.halved { 0.5 } else { 2.0 };
        let mut off = 0;
        let before = [&flat.bands()[..], &deep.bands()[..]];
        let after = [&planted.plane(flat).bands()[..], &planted.space(deep).bands()[..]];
        for (dimension, (before, after)) in [Dimension::Two, Dimension::Three].iter().zip(before.iter().zip(after)) {
            for ((symbol, is), (same, became)) in before.iter().zip(after) {
                assert_eq!(symbol, same);
                let is_meant = *dimension == planted.dimension && *symbol == planted.symbol;
                off += usize::from(is_meant);
                let by = if is_meant { factor } else { 1.0 };
                assert_eq!(
                    [became.lower, became.width, became.upper],
                    [is.lower, is.width, is.upper].map(|x| x * by),
                    "{symbol}: {}",
                    planted.fault
                );
            }
        }
        assert_eq!(off, 1, "{}", planted.fault);
        assert_eq!(format!("tolerance-{}", planted.name()), planted.fault);
    }
}

/// 16 L⁴ and 128 L⁵ must be doubles, and a millionth of a millionth of them must be normal.
#[test]
fn bands_of_circles_are_declined_where_determinants_leave_the_range() {
    let declines = |dimension: usize, largest: f64| {
        let mut coordinates = vec![0.0; 5 * dimension];
        coordinates[dimension] = largest;
        let scene = Scene::new(if dimension == 2 { Dimension::Two } else { Dimension::Three }, coordinates).unwrap();
        let kind = if dimension == 2 { PredicateKind::Incircle } else { PredicateKind::Insphere };
        Tolerance.prepare(&scene, Off).unwrap().supports(kind).is_err()
    };
    // 16 · 2^(4 · 255) is 2^1024, and 128 · 2^(5 · 203.4) is.
    assert_eq!([2f64.powi(255).next_down(), 2f64.powi(255)].map(|length| declines(2, length)), [false, true]);
    assert_eq!([203, 204].map(|exponent| declines(3, 2f64.powi(exponent))), [false, true]);
    // 200 ε L⁴ and 2000 ε L⁵, some 2^-44 and 2^-41, down to 2^-1022.
    assert_eq!([-240, -247].map(|exponent| declines(2, 2f64.powi(exponent))), [false, true]);
    assert_eq!([-190, -198].map(|exponent| declines(3, 2f64.powi(exponent))), [false, true]);
}

#[test]
fn a_validity_limit_is_where_the_constraint_ends() {
    let below = |limit: (i64, i64)| {
        let limit = Rational::from(limit);
        Constraint::greater("", Origin::Ours, "", move |at| [Enclosure::exact(limit.clone()), at.times(1)])
    };
    let limits = |constraint: &Constraint| validity_limit(constraint).map(|ends| ends.map(|end| end.to_string()));
    let ends = |holds: &str, fails: &str| Some([holds.to_owned(), fails.to_owned()]);
    assert_eq!(limits(&below((3, 10_000_000))), ends("2.99e-7", "3.00e-7"));
    assert_eq!(limits(&below((100_001, 100_000_000_000))), ends("1.00e-6", "1.01e-6"));
    assert_eq!(limits(&below((1, 10_000))), None, "holds everywhere");
    assert_eq!(limits(&below((0, 1))), None, "holds nowhere");
}

#[test]
fn the_claim_of_5_4_4_holds_for_every_binary_epsilon_and_its_chain_does_not() {
    let all = constraints();
    let of = |needle: &str| -> Vec<&Constraint> { all.iter().filter(|row| row.text.contains(needle)).collect() };
    let holds = |row: &Constraint, e: u32| row.decide(&At::new(Rational::from(1) >> e)) == Decision::Holds;
    let (direct, known, step) = (of("direct: "), of("where m² > λ₋"), of("−5 ≥"));
    assert_eq!([direct.len(), known.len(), step.len()], [2, 1, 1]);
    for e in 17..=112 {
        assert!(direct.iter().all(|row| holds(row, e)), "2^-{e}");
        assert_eq!(holds(known[0], e), e >= 19, "2^-{e}");
        assert_eq!(holds(step[0], e), e >= 52, "2^-{e}");
    }
}

/// The length L̂ = (La + Lb)/(1 − s) with s = 7√ε or 7ε^¼, by hand.
///
/// A sum, a difference and a quotient are rounded. s contributes its error relative to 1 − s: the rounding of its
/// product, of its root, and half of that of the root in it.
#[test]
fn bounds_of_lengths_are_those_by_hand() {
    let all = derivations();
    let first = |section: &str, name: &str| {
        let row = all.iter().find(|row| row.section == section && row.name == name).unwrap();
        row.derived.as_ref().unwrap().first.to_f64()
    };
    let of_shift = |s: f64, roundings: f64| 3.0 + roundings * s / (1.0 - s);
    let (plane, space) = (of_shift(7.0 * 1e-5_f64.sqrt(), 2.0), of_shift(7.0 * 1e-5_f64.powf(0.25), 2.5));
    for (derived, by_hand) in [
        (first("4.1", "R[L̂]"), plane),
        (first("5.1", "R[L̂]"), space),
        (first("ours", "R[L̂ of 4.1, sides rounded]"), plane + 1.0),
        (first("ours", "R[L̂ of 5.1, sides rounded]"), space + 1.0),
    ] {
        assert!(by_hand - 1e-12 < derived && derived < by_hand + 1e-6, "{derived} {by_hand}");
    }
    // As a number: 3/(1 − 7/100).
    let length = algorithms::length([1.0, 2.0], 0.01, 7.0, |difference| difference);
    assert!((length * 0.93 - 3.0_f64).abs() < 1e-12, "{length}");
}

/// 260 ε L⁴ and 2260 ε L⁵, each product rounded once: of L² and L⁴, of L⁵, with ε and with the constant.
#[test]
fn widths_of_the_bands_of_circles() {
    let all = derivations();
    for (name, c, length_quarters, roundings) in [("R[T incircle]", 260, 16, 4), ("R[T insphere]", 2260, 20, 5)] {
        let row = all.iter().find(|row| row.section == "ours" && row.name == name).unwrap();
        let magnitude = row.quantity.magnitude().unwrap();
        assert_eq!(
            (&magnitude.c, magnitude.length_quarters, magnitude.epsilon_quarters),
            (&c.into(), length_quarters, 4)
        );
        assert_eq!(row.derived.as_ref().unwrap().first, roundings, "{name}");
    }
}
