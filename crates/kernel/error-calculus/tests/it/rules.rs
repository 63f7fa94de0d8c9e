//! Each rule against the worst case: all operands at both ends of their errors, in exact rationals.

use predicament_error_calculus::rules::{self, Error, as_printed, largest_epsilon};
use proptest::prelude::*;
use rug::Rational;

const SIGNS: [i32; 3] = [-1, 0, 1];

/// Zero, the paper's a and b, and far larger errors.
fn errors() -> impl Strategy<Value = Error> {
    let a = prop_oneof![Just(0), 1..100, 1..5000];
    let b = prop_oneof![Just(0), 1..1000, 1..50_000_000];
    (a, b).prop_map(|(a, b)| Error { a: (a, 4).into(), b: (b, 4).into() })
}

fn magnitudes() -> impl Strategy<Value = Rational> {
    (1_i64..1_000_000, 1_i64..1000).prop_map(Rational::from)
}

/// Values of ε up to 10⁻⁵, which is drawn often.
fn epsilons() -> impl Strategy<Value = Rational> {
    prop_oneof![
        Just(largest_epsilon()),
        (1_u32..60).prop_map(|e| largest_epsilon() >> e),
        (1_i32..1000).prop_map(|k| largest_epsilon() * Rational::from((k, 1000))),
    ]
}

/// All ways in which two operands and the result can be off, as factors.
fn worst(epsilon: &Rational, e1: &Error, e2: &Error) -> Vec<[Rational; 3]> {
    let ends = |error: Rational| SIGNS.map(|sign| -> Rational { Rational::from(&error * sign) + 1 });
    let mut all = Vec::new();
    for x in ends(e1.at(epsilon)) {
        for y in ends(e2.at(epsilon)) {
            for z in ends(epsilon.clone()) {
                all.push([x.clone(), y.clone(), z]);
            }
        }
    }
    all
}

fn at_most(error: Rational, bound: &Rational) -> bool {
    error.abs() <= *bound
}

/// Returns true if a rule for sums holds for all values up to c₁ and c₂.
///
/// The values are tested at their ends and in the middle.
fn sum_holds(error: &Error, epsilon: &Rational, [c1, c2]: [&Rational; 2], e1: &Error, e2: &Error) -> bool {
    let bound = error.at(epsilon) * Rational::from(c1 + c2);
    let parts = [(1, 1), (-1, 1), (1, 2), (-1, 3)].map(Rational::from);
    let values: Vec<_> = parts.iter().flat_map(|x| parts.iter().map(move |y| (x, y))).collect();
    worst(epsilon, e1, e2).into_iter().all(|[x, y, z]| {
        values.iter().all(|(part1, part2)| {
            let (x1, x2) = (Rational::from(c1 * *part1), Rational::from(c2 * *part2));
            // absolute errors: relative to c, whatever the value is
            let off = |c: &Rational, factor: &Rational| Rational::from(factor - 1) * c;
            let computed = ((&x1 + off(c1, &x)) + (&x2 + off(c2, &y))) * &z;
            at_most(computed - x1 - x2, &bound)
        })
    })
}

/// Returns true if a rule for roots holds, by comparing squares, so that nothing is rounded.
fn root_holds(error: &Error, epsilon: &Rational, e: &Error) -> bool {
    let bound = error.at(epsilon);
    let low = Rational::from(1 - &bound).max(Rational::new());
    let (low, high) = (low.square(), (bound + 1_i32).square());
    worst(epsilon, e, &Error::none()).into_iter().all(|[x, _, z]| {
        let square = x * z.square();
        low <= square && square <= high
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(1000)))]

    #[test]
    fn b_and_d_are_sound(e1 in errors(), e2 in errors(), c1 in magnitudes(), c2 in magnitudes(), epsilon in epsilons()) {
        prop_assert!(sum_holds(&rules::sum(&c1, &e1, &c2, &e2), &epsilon, [&c1, &c2], &e1, &e2));
    }

    #[test]
    fn c_is_sound(e1 in errors(), e2 in errors(), c1 in magnitudes(), c2 in magnitudes(), epsilon in epsilons()) {
        let bound = rules::sum_of_same_sign(&e1, &e2).at(&epsilon);
        for [x, y, z] in worst(&epsilon, &e1, &e2) {
            for (x1, x2) in [(&c1, &c2), (&c1, &Rational::new()), (&Rational::new(), &c2)] {
                let computed = (Rational::from(x1 * &x) + Rational::from(x2 * &y)) * &z;
                let sum = Rational::from(x1 + x2);
                prop_assert!(at_most(computed / &sum - 1, &bound));
            }
        }
    }

    #[test]
    fn e_is_sound(epsilon in epsilons()) {
        for [_, _, z] in worst(&epsilon, &Error::none(), &Error::none()) {
            prop_assert!(at_most(z - 1, &rules::exact_difference().at(&epsilon)));
        }
    }

    #[test]
    fn f_is_sound(e1 in errors(), e2 in errors(), epsilon in epsilons()) {
        let bound = rules::product(&e1, &e2).at(&epsilon);
        for [x, y, z] in worst(&epsilon, &e1, &e2) {
            prop_assert!(at_most(x * y * z - 1, &bound));
        }
    }

    #[test]
    fn g_is_sound(e1 in errors(), e2 in errors(), epsilon in epsilons()) {
        match rules::quotient(&e1, &e2) {
            None => prop_assert!(e2.at(&largest_epsilon()) >= 1),
            Some(error) => for [x, y, z] in worst(&epsilon, &e1, &e2) {
                prop_assert!(at_most(x / y * z - 1, &error.at(&epsilon)));
            },
        }
    }

    #[test]
    fn h_is_sound(e in errors(), epsilon in epsilons()) {
        match rules::root(&e) {
            None => prop_assert!(e.at(&largest_epsilon()) >= 1),
            Some(error) => prop_assert!(root_holds(&error, &epsilon, &e)),
        }
    }

    /// The second-order coefficient b of the calculus equals the paper's, where the paper's is right.
    #[test]
    fn small_errors_have_the_columns_of_the_paper(
        a1 in 0..20_i32, a2 in 0..20_i32, b1 in 0..300_i32, b2 in 0..300_i32, c1 in magnitudes(), c2 in magnitudes(),
    ) {
        let [e1, e2] = [(a1, b1), (a2, b2)].map(|(a, b)| Error { a: a.into(), b: b.into() });
        let c = Rational::from(&c1 + &c2);
        let mean = |x1: i32, x2: i32| (Rational::from(&c1 * x1) + Rational::from(&c2 * x2)) / &c;
        let sum = Error { a: mean(a1, a2) + 1, b: mean(a1 + b1, a2 + b2) + 1 };
        prop_assert_eq!(rules::sum(&c1, &e1, &c2, &e2), sum);
        let b = 1 + (a1 + b1).max(a2 + b2);
        prop_assert_eq!(rules::sum_of_same_sign(&e1, &e2), Error { a: (1 + a1.max(a2)).into(), b: b.into() });
        let b = (1 + a1) * (1 + a2) + b1 + b2;
        prop_assert_eq!(rules::product(&e1, &e2), Error { a: (1 + a1 + a2).into(), b: b.into() });
        prop_assert_eq!(rules::quotient(&e1, &e2), Some(Error { a: (1 + a1 + a2).into(), b: (b + a2 * a2).into() }));
        let eighth = Rational::from((a1 * a1, 8));
        let bars = (Rational::from((a1, 2)) - eighth).abs();
        let b = Rational::from((b1, 2)) + bars + 1;
        prop_assert_eq!(rules::root(&e1), Some(Error { a: Rational::from((a1, 2)) + 1, b }));
    }
}

#[test]
fn the_printed_b_of_sums_is_unsound_for_large_b() {
    let (c, e) = (Rational::from(10), Error { a: 0.into(), b: 50_000.into() });
    let epsilon = largest_epsilon();
    assert!(!sum_holds(&as_printed::sum(&c, &e, &c, &e), &epsilon, [&c, &c], &e, &e));
    assert!(sum_holds(&rules::sum(&c, &e, &c, &e), &epsilon, [&c, &c], &e, &e));
    let small = Error { a: 4.into(), b: 8.into() };
    assert!(sum_holds(&as_printed::sum(&c, &small, &c, &small), &epsilon, [&c, &c], &small, &small));
}

/// Without the bars the column is too small for a₁ ≥ 2 + 2√2, as for the squared distance in space (a₁ = 5, b₁ = 13):
/// the bars are part of the rule.
#[test]
fn the_b_of_roots_needs_its_bars() {
    for (a, b, without) in [((4, 1), 8, true), ((19, 4), 0, true), ((5, 1), 0, false), ((5, 1), 13, false)] {
        let e = Error { a: a.into(), b: b.into() };
        let half = |x: &Rational| Rational::from(x / 2);
        let eighth = Rational::from(e.a.square_ref()) / 8;
        let bare = Error { a: half(&e.a) + 1, b: half(&e.b) + half(&e.a) - eighth + 1 };
        for epsilon in [largest_epsilon(), largest_epsilon() >> 40] {
            assert_eq!(root_holds(&bare, &epsilon, &e), without, "{e:?}");
            assert!(root_holds(&rules::root(&e).unwrap(), &epsilon, &e), "{e:?}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(1000)))]

    /// x + y that is at least (c₁ + c₂)/factor, with all errors at their ends.
    #[test]
    fn a_lower_bound_is_sound(
        e1 in errors(), e2 in errors(), c1 in magnitudes(), c2 in magnitudes(), epsilon in epsilons(), part in 1..100_i32,
    ) {
        let c = Rational::from(&c1 + &c2);
        let factor = Rational::from((100, part));
        let value = Rational::from(&c / &factor);
        let bound = rules::bounded_below(&rules::inherited(&c1, &e1, &c2, &e2), &factor).at(&epsilon);
        for [x, y, z] in worst(&epsilon, &e1, &e2) {
            let off = (x - 1_i32) * &c1 + (y - 1_i32) * &c2;
            let computed: Rational = (&value + off) * z;
            prop_assert!(at_most(computed / &value - 1, &bound));
        }
    }
}

#[test]
fn powers_of_two_are_known() {
    for (x, is) in [((1, 1), true), ((-8, 1), true), ((1, 64), true), ((3, 4), false), ((0, 1), false), ((5, 1), false)]
    {
        assert_eq!(rules::is_power_of_two(&Rational::from(x)), is, "{x:?}");
    }
}
