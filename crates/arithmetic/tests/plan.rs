//! Plans at their edges: on the safe side arithmetic must be as promised, and
//! a little beyond it must be possible to break it.

use predicament_arithmetic::{Form, Plan, Regime, rational};

const PRODUCT: Form = Form { degree: 2, growth: 0 };

fn power(exponent: i32) -> f64 {
    2f64.powi(exponent)
}

fn regime(values: &[f64], form: Form) -> Regime {
    Plan::of(values).regime(form)
}

/// Dekker's product: a·b = high + low where nothing over- or underflows.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let split = |x: f64| {
        let c = 134_217_729.0 * x;
        let high = c - (c - x);
        (high, x - high)
    };
    let ((a1, a0), (b1, b0)) = (split(a), split(b));
    let high = a * b;
    (high, a0 * b0 - (((high - a1 * b1) - a0 * b1) - a1 * b0))
}

fn is_exact(a: f64, b: f64) -> bool {
    let (high, low) = two_product(a, b);
    match (rational(high), rational(low)) {
        (Some(high), Some(low)) => high + low == rational(a).unwrap() * rational(b).unwrap(),
        _ => false,
    }
}

#[test]
fn edges_are_where_the_proof_puts_them() {
    for degree in 1..=5 {
        let form = Form { degree, growth: 7 };
        let low = -(916 / degree);
        // A second value forces more than 53 bits.
        assert_eq!(regime(&[power(low), power(low + 60)], form), Regime::Safe, "degree {degree}");
        assert_eq!(regime(&[power(low - 1), power(low + 60)], form), Regime::Unproved, "degree {degree}");
        let high = (995 - 7) / degree - 1;
        assert_eq!(regime(&[power(high - 1), power(high - 60)], form), Regime::Safe, "degree {degree}");
        assert_eq!(regime(&[power(high), power(high - 60)], form), Regime::Unproved, "degree {degree}");
    }
    assert_eq!(regime(&[], PRODUCT), Regime::Exact);
    assert_eq!(regime(&[0.0, -0.0], PRODUCT), Regime::Exact);
    assert_eq!(regime(&[f64::INFINITY], PRODUCT), Regime::Unproved);
    assert_eq!(regime(&[f64::NAN], PRODUCT), Regime::Unproved);
    assert_eq!(regime(&[5e-324], PRODUCT), Regime::Unproved);
    assert_eq!(regime(&[f64::MAX], PRODUCT), Regime::Unproved);
}

#[test]
fn small_integers_are_exact() {
    let product = Form { degree: 2, growth: 1 };
    assert_eq!(regime(&[power(25) - 1.0, 1.0], product), Regime::Exact);
    assert_eq!(regime(&[power(25), 1.0], product), Regime::Safe);
    // The same numbers elsewhere on the exponent scale.
    assert_eq!(regime(&[power(-375) - power(-400), power(-400)], product), Regime::Exact);
    assert_eq!(regime(&[power(-435) - power(-460), power(-460)], product), Regime::Unproved);
}

#[test]
fn products_are_exact_up_to_the_lower_edge_and_not_far_below() {
    // 53-bit factors whose lowest bit is at the edge.
    let ugly = 1.0 + f64::EPSILON * 12_345_678_901.0;
    let factor = ugly.next_up() * power(52 - 458);
    assert_eq!(regime(&[factor], PRODUCT), Regime::Safe);
    assert!(is_exact(factor, factor));
    assert!(rational(two_product(factor, factor).1).unwrap() != 0, "the tail is what the edge is about");

    let below = factor * power(-132); // 2 (-458 - 132) < -1074
    assert_eq!(regime(&[below], PRODUCT), Regime::Unproved);
    assert!(!is_exact(below, below), "the tail is lost");
}

#[test]
fn products_are_exact_up_to_the_upper_edge_and_not_far_above() {
    let factor = (1.0 - f64::EPSILON) * power(496); // 2 (496 + 1) ≤ 995
    assert_eq!(regime(&[factor, 1.0], PRODUCT), Regime::Safe);
    assert!(is_exact(2.0 * factor, 2.0 * factor), "a difference can be twice a coordinate");
    let above = factor * power(17);
    assert_eq!(regime(&[above, 1.0], PRODUCT), Regime::Unproved);
    assert!(!is_exact(above, above), "overflow");
    // Degree one: the product fits, but not the splitter's.
    let factor = (1.0 - f64::EPSILON) * power(1000);
    assert_eq!(regime(&[factor, 1.0], Form { degree: 1, growth: 0 }), Regime::Unproved);
    assert!(!is_exact(factor, 1.0), "the splitter overflows");
}
