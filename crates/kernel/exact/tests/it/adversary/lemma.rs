//! The lemma behind the constant of incircle: Σ |e·∂D/∂e| ≤ 3P + 14|D|.
//!
//! D is the determinant as a function of the differences e, and P its permanent. `docs/FILTERS.md` proves the lemma;
//! here a search tries to break it, and shows that 3 is not too much.

use crate::common::Random;

type Matrix = [[f64; 2]; 3];

/// The values D, Σ |e·∂D/∂e| and P, by the textbook.
fn sums(m: &Matrix) -> [f64; 3] {
    let lift = |i: usize| m[i][0] * m[i][0] + m[i][1] * m[i][1];
    let minor = |i: usize, j: usize| m[i][0] * m[j][1] - m[j][0] * m[i][1];
    let mut determinant = 0.0;
    let mut moved = 0.0;
    let mut permanent = 0.0;
    for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        determinant += lift(i) * minor(j, k);
        permanent += lift(i) * ((m[j][0] * m[k][1]).abs() + (m[k][0] * m[j][1]).abs());
        // The cofactors of x and y in row i, and the lift's own derivative.
        let cofactors = [m[j][1] * lift(k) - m[k][1] * lift(j), m[k][0] * lift(j) - m[j][0] * lift(k)];
        for (x, cofactor) in m[i].iter().zip(cofactors) {
            moved += (2.0 * x * x * minor(j, k) + x * cofactor).abs();
        }
    }
    [determinant, moved, permanent]
}

/// The matrix with the last row scaled so that the determinant vanishes: it is s·A + s²·B in a scale s.
fn tied(mut m: Matrix) -> Matrix {
    let [plus, ..] = sums(&m);
    let [minus, ..] = sums(&[m[0], m[1], m[2].map(|x| -x)]);
    let scale = (minus - plus) / (plus + minus);
    m[2] = m[2].map(|x| x * scale);
    m
}

/// The constant of P for which the lemma would just hold; `None` if no scale gives a tie.
fn needed(m: &Matrix) -> f64 {
    let [determinant, moved, permanent] = sums(m);
    let needed = (moved - 14.0 * determinant.abs()) / permanent;
    if needed.is_finite() { needed } else { 0.0 }
}

#[test]
fn the_lemma_holds_and_is_sharp() {
    let mut random = Random(40);
    let mut most = 0.0;
    for climb in 0..300 {
        let step = |random: &mut Random, range: f64| ((random.unit() - 0.5) * range).exp2();
        let mut m: Matrix = std::array::from_fn(|_| {
            std::array::from_fn(
                |_| if random.below(2) == 0 { step(&mut random, 20.0) } else { -step(&mut random, 20.0) },
            )
        });
        let on_tie = |m| if climb % 3 == 0 { m } else { tied(m) };
        let mut best = needed(&on_tie(m));
        for _ in 0..3000 {
            let mut moved = m;
            let range = *random.pick(&[8.0, 2.0, 0.3]);
            for _ in 0..=random.below(2) {
                moved[random.below(3)][random.below(2)] *= step(&mut random, range);
            }
            let needed = needed(&on_tie(moved));
            assert!(needed < 3.0 + 1e-6, "{needed} at {moved:?}");
            if needed >= best {
                (m, best) = (moved, needed);
            }
        }
        most = best.max(most);
    }
    assert!(most > 2.99, "{most}");
}
