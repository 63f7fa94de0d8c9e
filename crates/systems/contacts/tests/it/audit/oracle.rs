//! The exact distances, compared with a second computation: the normal equations of the least squares problem, by
//! elimination, over all pairs of faces.

use std::collections::{BTreeMap, BTreeSet};

use predicament_contacts::checks::audit::Pair;
use proptest::prelude::*;
use rug::Rational;

/// Points of either dimension: those of the plane have z = 0.
type Simplex = Vec<[f64; 3]>;

/// All faces of a simplex, itself included.
fn faces(simplex: &[[f64; 3]]) -> Vec<Simplex> {
    let chosen =
        |subset: u32| simplex.iter().enumerate().filter(|(i, _)| subset >> i & 1 == 1).map(|(_, &p)| p).collect();
    (1_u32..1 << simplex.len()).map(chosen).collect()
}

/// The weights of the closest points of two simplices' carriers, and their squared distance; `None` if the closest
/// points are not unique.
fn closest(first: &[[f64; 3]], second: &[[f64; 3]]) -> Option<([Vec<Rational>; 2], Rational)> {
    let q = |x: f64| Rational::from_f64(x).unwrap();
    let row = |from: [f64; 3], to: [f64; 3]| -> Vec<Rational> { (0..3).map(|i| q(to[i]) - q(from[i])).collect() };
    let dot =
        |a: &[Rational], b: &[Rational]| -> Rational { a.iter().zip(b).map(|(x, y)| Rational::from(x * y)).sum() };
    // Minimise ‖f₀ + Σ xᵢ uᵢ − s₀ − Σ yⱼ vⱼ‖².
    let mut columns: Vec<Vec<Rational>> = first[1..].iter().map(|&p| row(first[0], p)).collect();
    columns.extend(second[1..].iter().map(|&p| row(p, second[0])));
    let right = row(first[0], second[0]);
    let mut system: Vec<Vec<Rational>> =
        columns.iter().map(|a| columns.iter().map(|b| dot(a, b)).chain([dot(a, &right)]).collect()).collect();
    let unknowns = columns.len();
    for pivot in 0..unknowns {
        let at = (pivot..unknowns).find(|&at| !system[at][pivot].is_zero())?;
        system.swap(pivot, at);
        let inverse = system[pivot][pivot].clone().recip();
        system[pivot].iter_mut().for_each(|x| *x *= &inverse);
        for other in (0..unknowns).filter(|&other| other != pivot) {
            let factor = system[other][pivot].clone();
            let change: Vec<Rational> = system[pivot].iter().map(|x| Rational::from(&factor * x)).collect();
            system[other].iter_mut().zip(change).for_each(|(x, change)| *x -= change);
        }
    }
    let solution: Vec<Rational> = system.iter().map(|row| row[unknowns].clone()).collect();
    let weights = |rest: &[Rational]| -> Vec<Rational> {
        let first = Rational::from(1) - rest.iter().cloned().sum::<Rational>();
        [&[first], rest].concat()
    };
    let weights = [weights(&solution[..first.len() - 1]), weights(&solution[first.len() - 1..])];
    let place = |simplex: &[[f64; 3]], weights: &[Rational], i: usize| -> Rational {
        simplex.iter().zip(weights).map(|(p, w)| q(p[i]) * w).sum()
    };
    let distance = (0..3).map(|i| (place(first, &weights[0], i) - place(second, &weights[1], i)).square()).sum();
    Some((weights, distance))
}

fn inside(weights: &[Vec<Rational>; 2]) -> bool {
    weights.iter().flatten().all(|weight| weight.is_positive())
}

/// The smallest distance over all pairs of faces whose closest points are inside both.
fn distance_squared(first: &[[f64; 3]], second: &[[f64; 3]]) -> Rational {
    let (of_first, of_second) = (faces(first), faces(second));
    let pairs = of_first.iter().flat_map(|s| of_second.iter().map(move |t| (s, t)));
    pairs.filter_map(|(s, t)| closest(s, t)).filter(|(weights, _)| inside(weights)).map(|(_, d)| d).min().unwrap()
}

fn simplex(points: usize, flat: bool) -> impl Strategy<Value = Simplex> {
    let z = if flat { 0..=0 } else { -2..=2 };
    proptest::collection::vec([-2..=2, -2..=2, z].prop_map(|p: [i32; 3]| p.map(f64::from)), points)
}

fn pair() -> impl Strategy<Value = (bool, Simplex, Simplex)> {
    let ranks = prop_oneof![Just((1, 1)), Just((2, 1)), Just((2, 2)), Just((3, 1)), Just((3, 2)), Just((4, 1))];
    (ranks, any::<bool>()).prop_flat_map(|((first, second), flat)| {
        let flat = flat && first + second < 5;
        (Just(flat), simplex(first, flat), simplex(second, flat))
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: predicament_effort::cases(3000), ..ProptestConfig::default() })]

    #[test]
    fn feet_weights_and_distances_are_those_of_least_squares((flat, first, second) in pair()) {
        let pair = if flat {
            let plane = |s: &Simplex| s.iter().map(|&[x, y, _]| [x, y]).collect::<Vec<_>>();
            Pair::new(&plane(&first), &plane(&second))
        } else {
            Pair::new(&first, &second)
        };
        let expected = closest(&first, &second).filter(|(weights, _)| inside(weights));
        let feet = pair.feet();
        prop_assert_eq!(feet.is_some(), expected.is_some());
        if let (Some(feet), Some((weights, distance))) = (feet, expected) {
            prop_assert_eq!(feet.weights(), weights);
            prop_assert_eq!(feet.distance_squared.value(), distance);
        }
        prop_assert_eq!(pair.distance_squared(), distance_squared(&first, &second));
    }
}

/// All faces of a triangle with all faces of an edge, without the pair of the whole simplices, each once.
#[test]
fn sub_pairs_are_pairs_of_faces() {
    let triangle = [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [0.0, 3.0, 1.0]];
    let edge = [[0.5, 0.5, 0.0], [0.75, 0.25, 4.0]];
    let mut counts = BTreeMap::new();
    let mut seen = BTreeSet::new();
    for pair in Pair::new(&triangle, &edge).sub_pairs() {
        *counts.entry(pair.kind().ranks()).or_insert(0) += 1;
        seen.insert(format!("{pair:?}"));
    }
    let expected = [([0, 0], 3 * 2), ([1, 0], 3 * 2 + 3), ([1, 1], 3), ([2, 0], 2)];
    assert_eq!(counts.into_iter().collect::<Vec<_>>(), expected);
    assert_eq!(seen.len(), 7 * 3 - 1);
}
