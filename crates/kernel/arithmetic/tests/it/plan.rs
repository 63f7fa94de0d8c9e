//! Plans at their limits: within the limits arithmetic keeps its promise, and a little beyond them some input breaks
//! it.

use predicament_arithmetic::{Arithmetic, Form, Plan, exact_tail, rational, units};

const PRODUCT: Form = Form { degree: 2, growth: 0, integer_bits: [62, 126] };

fn power(exponent: i32) -> f64 {
    2f64.powi(exponent)
}

/// The plan for values along one axis, including zero.
fn plan(values: &[f64]) -> Plan<1> {
    Plan::of(&[values, &[0.0]].concat().iter().map(|&x| [x]).collect::<Vec<_>>())
}

#[test]
fn edges_are_where_the_proof_puts_them() {
    for degree in 1..=5 {
        let form = Form { degree, growth: 7, ..PRODUCT };
        let low = -(969 / degree);
        assert!(plan(&[power(low)]).allows_filters(form), "degree {degree}");
        assert!(!plan(&[power(low - 1)]).allows_filters(form), "degree {degree}");
        let high = (1023 - 7) / degree;
        assert!(plan(&[power(high).next_down()]).allows_filters(form), "degree {degree}");
        assert!(!plan(&[power(high)]).allows_filters(form), "degree {degree}");
    }
    for values in [f64::INFINITY, f64::NAN, 5e-324, f64::MAX] {
        assert!(!plan(&[values]).allows_filters(PRODUCT), "{values}");
    }
    assert!(Plan::<2>::of(&[]).allows_filters(PRODUCT));
    assert!(plan(&[-0.0]).allows_filters(PRODUCT));
}

#[test]
fn differences_count_and_not_the_distance_from_the_origin() {
    let far = |x: f64| Plan::of(&[[power(52) + x], [power(52)]]);
    assert_eq!((far(9.0).bits(), far(7.0).bits()), (4, 3));
    assert_eq!(far(7.0).lowest(), 0);
    assert_eq!(Plan::of(&[[3.0, 1.0], [3.0, 2.0]]).axes().map(|axis| axis.extent()), [0.0, 1.0]);
    let projected = Plan::of(&[[1.0, 2.0, 0.125], [3.0, 5.0, 0.5]]).project([1, 0]);
    assert_eq!((projected.lowest(), projected.bits()), (0, 2));
}

#[test]
fn points_in_one_place_have_differences_of_one_bit() {
    let plan = Plan::of(&[[3.0, 0.25]; 4]);
    assert_eq!((plan.lowest(), plan.bits()), (-2, 1));
    assert_eq!(Plan::<2>::of(&[]).bits(), 1);
}

/// A power of two that is a normal double and scales coordinates to integers of 63 bits.
#[test]
fn scales_are_normal_and_make_integers() {
    assert_eq!(plan(&[3.0, power(62)]).scale(), Some(1.0));
    assert_eq!(plan(&[3.0, power(63).next_down()]).scale(), Some(1.0));
    assert_eq!(plan(&[3.0, power(63)]).scale(), None, "64 bits");
    assert_eq!(plan(&[0.75]).scale(), Some(4.0));
    for (lowest, scale) in [(1022, Some(f64::MIN_POSITIVE)), (1023, None), (-1022, Some(power(1022))), (-1023, None)] {
        let value = if lowest < 0 { f64::MIN_POSITIVE * power(lowest + 1022) } else { power(lowest) };
        assert_eq!(plan(&[value]).scale(), scale, "2^{lowest}");
    }
    assert_eq!(Plan::of(&[[1.0, power(70)], [3.0, power(70)]]).scale(), None, "one axis is too long");
}

#[test]
fn extents_are_rounded_up_and_only_if_they_must() {
    let extent = |min: f64, max: f64| Plan::of(&[[min], [max]]).axes()[0].extent();
    assert_eq!(extent(0.0, 1.0 - power(-53)), 1.0 - power(-53));
    assert_eq!(extent(-power(-54), 1.0), 1.0f64.next_up(), "rounding to nearest would give 1");
    assert_eq!(extent(power(-54), 1.0), 1.0, "rounding to nearest is up");
    assert_eq!(extent(-f64::MAX, f64::MAX), f64::INFINITY);
    assert_eq!(extent(2.0, 2.0), 0.0);
}

#[test]
fn each_arithmetic_is_chosen_up_to_its_last_bit() {
    let product = Form { degree: 2, growth: 1, ..PRODUCT };
    let arithmetic = |bits: i32, lowest: i32| {
        // From 1 to 2^bits − 1 if that is a double, else just below 2^bits.
        let largest = power(bits).next_down();
        let largest = if bits < 53 { power(bits) - 1.0 } else { largest };
        let plan = plan(&[power(lowest), largest * power(lowest)]);
        assert_eq!(plan.bits(), bits);
        plan.arithmetic(product)
    };
    for lowest in [0, -400, 300] {
        assert_eq!([26, 27].map(|bits| arithmetic(bits, lowest)), [Arithmetic::Double, Arithmetic::Integer]);
        assert_eq!([62, 63].map(|bits| arithmetic(bits, lowest)), [Arithmetic::Integer, Arithmetic::WideInteger]);
        assert_eq!([126, 127].map(|bits| arithmetic(bits, lowest)), [Arithmetic::WideInteger, Arithmetic::Dyadic]);
    }
    assert_eq!(arithmetic(26, -600), Arithmetic::Integer, "products of doubles underflow");
    assert_eq!(plan(&[f64::MAX, -f64::MAX]).arithmetic(product), Arithmetic::Dyadic, "a difference overflows");
    assert_eq!(Plan::<2>::of(&[]).arithmetic(product), Arithmetic::Double);
    assert_eq!(Arithmetic::ALL.map(Arithmetic::name), ["double", "integer", "wide integer", "dyadic"]);
}

#[test]
fn units_reach_both_ends_of_the_range() {
    for x in [5e-324, f64::MIN_POSITIVE, 1.0, -0.75, power(1023), 3.0 * power(971)] {
        let plan = plan(&[x]);
        let [[one]] = plan.low_units(&[[x]])[..] else { panic!("one point") };
        assert_eq!(one % 2, if x < 0.0 { -1 } else { 1 }, "{x} is an odd multiple of its lowest bit");
        assert_eq!(units(x, plan.lowest()), i128::from(one));
    }
}

/// Its significand has no bit to lose, whatever the unit is.
#[test]
fn zero_is_zero_in_any_unit() {
    for lowest in [-1074, -1011, -1010, -1000, 0, 971, 1023] {
        for zero in [0.0, -0.0] {
            assert_eq!(units(zero, lowest), 0, "in units of 2^{lowest}");
        }
    }
}

/// The processor's conversion equals the shifts, also modulo 2^64 far from the origin.
#[test]
fn both_kinds_of_units_are_the_same() {
    let values = [0.0, -0.0, 1.0, -1.5, 0.1, -3.0 * power(-40), 1024.0];
    for scale in [1.0, power(-1000), power(900), power(-1018), power(-1074 + 60)] {
        for far in [0.0, power(8), power(52), -power(60), power(64), -power(65)] {
            let points: Vec<[f64; 2]> = values.iter().map(|&x| [(x + far) * scale, -x * scale]).collect();
            let plan = Plan::of(&points);
            for (point, found) in points.iter().zip(plan.low_units(&points)) {
                #[allow(clippy::cast_possible_truncation)] // modulo 2^64
                let expected = point.map(|x| units(x, plan.lowest()) as i64);
                assert_eq!(found, expected, "{point:?}");
            }
            let distance = rational(points[6][0]).unwrap() - rational(points[3][0]).unwrap();
            let found = plan.low_units(&points);
            let difference = found[6][0].wrapping_sub(found[3][0]);
            assert!(plan.bits() > 62 || distance == rug::Rational::from(difference) << plan.lowest());
        }
    }
}

#[test]
fn products_are_exact_up_to_the_lower_edge_and_not_far_below() {
    // Two factors at the limit: their product is a multiple of 2^-969, and its rounding error is normal.
    let factor = (1.0 + f64::EPSILON) * power(52 - 484);
    assert!(plan(&[factor]).allows_filters(PRODUCT));
    let relative = |x: f64| {
        let exact = rational(x).unwrap() * rational(x).unwrap();
        ((rational(x * x).unwrap() - &exact) / exact).abs().to_f64()
    };
    assert!(relative(factor) <= f64::EPSILON / 2.0);
    let below = factor * power(-150);
    assert!(!plan(&[below]).allows_filters(PRODUCT));
    assert!(relative(below) > f64::EPSILON, "the product is subnormal");
}

#[test]
fn tails_complete_differences() {
    for (a, b) in [(1.0, 1e-20), (0.1, -0.3), (5e-324, 1.0), (power(1000), 1.0), (3.0, 3.0), (1e-308, -1e-300)] {
        let head = a - b;
        let tail = exact_tail(a, b, head);
        assert_eq!(rational(head).unwrap() + rational(tail).unwrap(), rational(a).unwrap() - rational(b).unwrap());
    }
}
