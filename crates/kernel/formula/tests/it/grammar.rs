//! Formulas as text: what they mean, and where a mistake is.

use predicament_formula::{Definition, Formula};
use predicament_judge::formula_value;

use crate::common::formula;

#[test]
fn mistakes_are_shown_at_their_place_with_a_cure() {
    for (text, place, said) in [
        ("det(a - c, b c)", "c", "`)` is missing"),
        ("a.x b.x", "b", "should end here"),
        ("det(a - c)", "a - c", "rows of 1"),
        ("sq(a - b) / 2", "/", "no division"),
        ("sqrt(a.x)", "sqrt", "compare squares"),
        ("a - b", "a - b", "a number is needed"),
        ("1.5 * a.x", "1.5", "whole"),
        ("a.x - a.x", "a.x - a.x", "always zero"),
        ("(a.x", "", "`)` is missing"),
        ("a.q", "q", "coordinates are x, y, z and w"),
        ("a.x ^ 99", "99", "exponent"),
        ("a * b", "a * b", "dot(u, v) or cross(u, v)"),
        ("a.x + b", "a.x + b", "can not be added"),
        ("u = v; v = a - b; sq(u)", "v", "neither defined nor a point"),
        ("3 * 4", "3 * 4", "1 to 8 points"),
        ("dot(a)", "dot(a)", "two arguments"),
        ("foo(a)", "foo", "no function is called `foo`"),
        ("a.x $ 1", "$", "not part of a formula"),
    ] {
        let error = Formula::new(Definition::anonymous(text)).expect_err(text);
        assert!(error.reason.contains(said), "{text}: {}", error.reason);
        assert!(text[error.span.clone()].contains(place), "{text}: {:?}", error.span);
        assert!(error.shown(text).contains('^'), "{}", error.shown(text));
    }
}

#[test]
fn the_smallest_dimension_that_fits_is_meant() {
    let dimension = |text: &str| Formula::new(Definition::anonymous(text)).unwrap().dimension();
    assert_eq!(dimension("det(a - c, b - c)"), 2);
    assert_eq!(dimension("det(a - d, b - d, c - d)"), 3);
    assert_eq!(dimension("a.w - b.w"), 2);
    let weighted = formula("det([a - c, a.w - c.w], [b - c, b.w - c.w], [a.x - b.x, 1, 0])", 2);
    assert!(weighted.is_weighted() && weighted.coordinates() == 3);
    assert_eq!(dimension("sq(p - a) - sq(p - b)"), 2);
}

#[test]
fn operators_mean_what_they_mean_in_rationals() {
    for (text, points, value) in [
        ("a.x - b.y * 2", [[5.0, 0.0], [0.0, 3.0]], -1.0),
        ("(a.x - b.y) * -2", [[5.0, 0.0], [0.0, 3.0]], -4.0),
        ("a.x ^ 3 - sq(b.y)", [[2.0, 0.0], [0.0, 3.0]], -1.0),
        ("u = a - b; dot(u, [u.y, 2 * u.x]) # a comment", [[2.0, 7.0], [1.0, 3.0]], 12.0),
        ("cross(a, b)", [[2.0, 7.0], [1.0, 3.0]], -1.0),
        ("det([a, 1], [b, 1], [0, 0, 1])", [[2.0, 7.0], [1.0, 3.0]], -1.0),
        ("-a.x + -b.y - -3", [[2.0, 0.0], [0.0, 4.0]], -3.0),
    ] {
        let formula = formula(text, 2);
        let points: Vec<&[f64]> = points.iter().map(<[f64; 2]>::as_slice).collect();
        assert_eq!(formula_value(&formula, &points).unwrap(), value, "{text}");
        assert_eq!(formula.estimate(&points)[0], value, "{text}");
    }
    let space = formula("dot(cross(a - d, b - d), c - d) - det(a - d, b - d, c - d) + a.x - b.x", 3);
    assert_eq!(space.polynomial().len(), 2, "a triple product is a determinant");
}

#[test]
fn symmetries_of_determinants_are_found() {
    for (text, dimension) in [("det(a - c, b - c)", 2), ("det(a - d, b - d, c - d)", 3)] {
        let formula = formula(text, dimension);
        let swaps = formula.swaps();
        let all: usize = (1..=formula.arity()).product();
        assert_eq!(swaps.len(), all - 1, "every permutation keeps or turns the sign");
        assert_eq!(swaps.iter().filter(|swap| swap.turns).count(), all / 2);
    }
    let distance = formula("sq(p - a) - sq(p - b)", 2);
    assert_eq!(distance.points(), ["a", "b", "p"]);
    assert_eq!(distance.swaps().len(), 1);
    assert!(distance.swaps()[0].turns && distance.swaps()[0].to == [1, 0, 2]);
}

#[test]
fn determinants_of_directions_are_known_as_such() {
    for (text, is) in [
        ("det(a, b, c)", true),
        ("3 * det(b, a)", true),
        ("dot(cross(a, b), c)", true),
        ("det(a - d, b - d, c - d)", false),
        ("det(a, b, c) * sq(a)", false),
        ("det(a, b, c) + a.x * b.y * c.z", false),
        ("a.x * b.x - a.y * b.y", false),
        ("det([a, a.w], [b, b.w], [c, c.w], [d, d.w])", true),
    ] {
        assert_eq!(Formula::new(Definition::anonymous(text)).unwrap().is_determinant(), is, "{text}");
    }
}
