//! Every constraint that the paper puts on its tolerances, for the values that the crate computes.
//!
//! The arithmetic is rational, at ε = 2⁻⁵² and L = 1. Square roots are eliminated by squaring or, if √3 defines a
//! value, bounded.

use predicament_predicates::Band;
use predicament_tolerance::{Tolerances2d, Tolerances3d};
use rug::Rational;

fn q(x: f64) -> Rational {
    Rational::from_f64(x).expect("finite")
}

fn eps() -> Rational {
    q(f64::EPSILON)
}

fn sq(x: f64) -> Rational {
    q(x) * q(x)
}

/// The smaller of the two distances from T to its neighbours.
fn room(band: Band) -> Rational {
    (q(band.upper) - q(band.width)).min(q(band.width) - q(band.lower))
}

/// Returns true if |x − y| ≤ 4ε y, for y given exactly.
fn is_close(x: f64, y: &Rational) -> bool {
    (q(x) - y).abs() <= eps() * 4 * y
}

/// Checks the constraints on lengths, which 4.3 and 5.3 share.
///
/// `reject` bounds the error of the edge length, `weight` that of both weights.
fn check_lengths(sigma: Band, tau: Band, sigma_hat: Band, reject: u32, weight: u32) {
    assert!(room(sigma) > eps() * 8 * q(sigma.width), "min(σ₊ − σ, σ − σ₋) > 8εσ");
    assert_eq!(sigma.lower, sigma_hat.upper, "σ₋ = σ̂₊");
    assert!(q(sigma_hat.lower) > eps() * reject, "σ̂₋ > E[m]");
    assert!(sq(tau.upper) * 4 < sq(sigma.lower) * 3, "τ₊ < (√3/2) σ₋");
    let weight_bound = eps() * weight;
    assert!(sq(sigma.lower) - sq(tau.upper) > weight_bound.square(), "√(σ₋² − τ₊²) > E[a]");
}

#[test]
fn the_plane() {
    let t = Tolerances2d::from_length(1.0);
    check_lengths(t.sigma, t.tau, t.sigma_hat, 5, 26);
    assert!(room(t.sigma_hat) > eps() * 8);
    assert!(room(t.tau) > eps() * 20);
    assert_eq!(q(t.kappa.upper), sq(t.tau.lower) * 2, "κ₊ = 2τ₋²");
    assert!(q(t.kappa.lower) > eps() * 9, "κ₋ > E[a]");
    assert!(room(t.kappa) > eps() * 10);
}

#[test]
fn space() {
    let t = Tolerances3d::from_length(1.0);
    check_lengths(t.sigma, t.tau, t.sigma_hat, 7, 42);
    assert!(room(t.sigma_hat) > eps() * 9);
    assert!(room(t.tau) > eps() * 131 / q(t.tau.width));
    // a condition that 5.3 needs on the lower side without stating it
    assert!(sq(t.tau.width) - sq(t.tau.lower) > eps() * 261 + eps() * 9 * sq(t.tau.width));

    let edge_gap = (sq(t.tau.lower) - sq(t.gamma.upper)).square();
    assert_eq!(q(t.lambda.upper), Rational::from(&edge_gap * 16), "λ₊ = 16(τ₋² − γ₊²)²");
    assert_eq!(q(t.phi.upper), edge_gap * 8, "φ₊ = 8(τ₋² − γ₊²)²");
    assert!(room(t.lambda) > eps() * 130);
    assert!(room(t.phi) > eps() * 282);

    let face_gap = (sq(t.tau.lower) - sq(t.delta.upper)).square();
    assert_eq!(q(t.nu.upper), Rational::from(&face_gap * 108), "ν₊ = 108(τ₋² − δ₊²)²");
    assert!(is_close_to_root3(t.zeta.upper, &(face_gap * 12)), "ζ₊ = 12√3 (τ₋² − δ₊²)²");
    assert!(room(t.nu) > eps() * 130);
    assert!(room(t.zeta) > eps() * 446);

    let cube = sq(t.gamma.lower) * q(t.gamma.lower.min(t.delta.lower));
    assert_eq!(q(t.mu.upper), Rational::from(&cube * 4), "μ₊ = 4γ₋² min(γ₋, δ₋)");
    assert!(is_close_to_root3(t.xi.upper, &Rational::from(&cube * 6)), "ξ₊ = 6√3 γ₋² min(γ₋, δ₋)");
    let face_cube = sq(t.delta.lower) * q(t.delta.lower);
    assert!(is_close_to_root3(t.rho.upper, &(face_cube * 6)), "ρ₊ = 6√3 δ₋³");
    for volume in [t.mu, t.xi, t.rho] {
        assert!(q(volume.lower) > eps() * 47, "T₋ > E[v]");
        assert!(room(volume) > eps() * 48);
    }
}

/// Returns true if x is √3 y up to 4ε: both are positive, so squares are compared.
fn is_close_to_root3(x: f64, y: &Rational) -> bool {
    let square = Rational::from(y * y) * 3;
    let off: Rational = sq(x) - &square;
    off.abs() <= eps() * 8 * square
}

#[test]
fn the_last_line_of_5_4_4() {
    // E[γ²m²] < γ²m²/7 and E[d²] < 2γ²m²/35 leave γ² between 5/4 γ₋² and 5/6 γ₊²
    for band in [Tolerances3d::from_length(1.0).gamma, Tolerances3d::from_length(1.0).delta] {
        assert!(sq(band.lower) * 5 <= sq(band.width) * 4);
        assert!(sq(band.width) * 6 <= sq(band.upper) * 5);
    }
}

#[test]
fn length_holds_both_primitives_and_sigma_plus() {
    for (la, lb) in [(1.0, 1.0), (0.1, 3.0), (1e-30, 7.3), (123.456, 0.0)] {
        let t = Tolerances2d::from_lengths(la, lb);
        assert!(q(t.length) >= q(la) + q(lb) + q(t.sigma.upper), "2D: {la} {lb}");
        let t = Tolerances3d::from_lengths(la, lb);
        assert!(q(t.length) >= q(la) + q(lb) + q(t.sigma.upper), "3D: {la} {lb}");
    }
}

#[test]
fn the_tables_as_printed_at_any_length() {
    // products round by u = ε/2 each; the longest, 1317 (ε ((L L)(L L))), by four of them
    for length in [1.0, 0.3, 1e-20, 7.7e15] {
        let l = q(length);
        let root = q(f64::EPSILON.sqrt());
        let t = Tolerances2d::from_length(length);
        assert!(is_close(t.sigma.width, &(root.clone() * &l * q(6.5))));
        assert!(is_close(t.kappa.width, &(eps() * &l * &l * 21)));

        let fourth = q(2.0_f64.powi(-13));
        let cubed = Rational::from(&l * &l) * &l;
        let t = Tolerances3d::from_length(length);
        assert!(is_close(t.delta.width, &(fourth.clone() * &l * q(2.25))));
        assert!(is_close(t.xi.width, &(root * fourth * &cubed * 56)));
        assert!(is_close(t.zeta.width, &(eps() * cubed * l * 1317)));
    }
}
