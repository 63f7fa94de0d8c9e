//! The errors of the values that the algorithms compute, against exact values.
//!
//! The exact values are rationals; roots are enclosed to 2⁻¹⁹². Coordinates are numbers of the precision between −½ and
//! ½, so that L is 1. Lengths are between 1 and 4.

use predicament_contacts::checks::audit::{Published, Symbol};
use predicament_corpus::Random;
use predicament_error_calculus::{Adversary, Enclosure, Perturbed};
use predicament_formats::bits::power_of_two;
use predicament_predicates::{Band, Dimension};
use predicament_tasks::{Stop, Watch};
use predicament_tolerance::bounds::quantities::{self, Named, Normalization, Points};
use predicament_tolerance::bounds::{Derivation, algorithms, derivations};
use predicament_tolerance::{Float, Tolerances2d, Tolerances3d};
use rayon::prelude::*;
use rug::Rational;

use super::climb::climb;
use crate::Precision;

/// A bound and the largest error found.
#[derive(Clone, PartialEq, Debug)]
pub struct Observed {
    /// The algorithm that computes the quantity.
    pub algorithm: u8,
    /// The section with the bound.
    pub section: &'static str,
    /// The name of the bounded value, such as `E[d²]`.
    pub name: String,
    /// The precision of the computation.
    pub precision: Precision,
    /// The derived bound over ε: first and second order at this ε.
    pub derived: f64,
    /// The largest error found, over ε.
    pub observed: f64,
}

impl Observed {
    /// The error over its bound.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.observed / self.derived
    }
}

/// Searches for the largest error of every bound that has one.
///
/// # Errors
/// [`Stop`] if the watch says so; it counts bounds.
pub fn errors(effort: [u64; 2], seed: u64, watch: &Watch) -> Result<Vec<Observed>, Stop> {
    let all: Vec<Derivation> = derivations().into_iter().filter(|row| algorithm(row).is_some()).collect();
    let rows: Vec<(&Derivation, Precision)> =
        all.iter().flat_map(|row| Precision::ALL.into_iter().map(move |precision| (row, precision))).collect();
    let one = |(row, precision): (&Derivation, Precision)| {
        let observed = match precision {
            Precision::Double => search::<f64>(row, precision, effort, seed),
            Precision::Single => search::<f32>(row, precision, effort, seed),
        };
        watch.done(1).map(|()| observed)
    };
    let found: Result<Vec<Option<Observed>>, Stop> = rows.into_par_iter().map(one).collect();
    Ok(found?.into_iter().flatten().collect())
}

/// The algorithm that computes the quantity; `None` if no algorithm does, and for magnitudes.
fn algorithm(row: &Derivation) -> Option<u8> {
    if row.is_magnitude || row.derived.is_none() || row.published.is_none() {
        return None;
    }
    let number = match row.section {
        "4.1" | "figure 1" => 1,
        "4.2" => 2,
        "4.3" => 3,
        "4.4" => 4,
        "4.5" => 5,
        "figure 5" => 6,
        "5.1" if row.name == "R[L̂]" => 6,
        "5.2" => 7,
        "5.3" => 8,
        "5.4" => 9,
        "5.5" => 10,
        "5.6" => 11,
        "5.7" => 12,
        _ => return None,
    };
    Some(number)
}

fn epsilon<F: Float>() -> Rational {
    Rational::from_f64(F::EPSILON.wide()).expect("finite")
}

fn exact(x: f64) -> Rational {
    Rational::from_f64(x).expect("inputs and results are finite")
}

fn search<F: Float>(row: &Derivation, precision: Precision, effort: [u64; 2], seed: u64) -> Option<Observed> {
    let algorithm = algorithm(row)?;
    let name = format!("{} {} {}", row.section, row.name, precision.name());
    let mut random = Random::new("worst", &name, seed);
    let found = match row.section {
        "figure 1" | "figure 5" => lengths::<F, 1>(&mut random, effort, |[length]| tolerance::<F>(row, length)),
        "4.1" | "5.1" => lengths::<F, 2>(&mut random, effort, |sides| whole_length::<F>(row.section, sides)),
        section if section.starts_with('4') => coordinates::<F, 12>(&mut random, effort, |x| {
            let points: [[f64; 2]; 6] = std::array::from_fn(|i| [x[2 * i], x[2 * i + 1]]);
            let of =
                |points: &Points<Perturbed, 2>| quantities::plane_section(section, points, Normalization::Reciprocal);
            off(row, &points, of, |points| quantities::plane_section::<F>(section, points, Normalization::Reciprocal))
        }),
        section => coordinates::<F, 18>(&mut random, effort, |x| {
            let points: [[f64; 3]; 6] = std::array::from_fn(|i| [x[3 * i], x[3 * i + 1], x[3 * i + 2]]);
            let of =
                |points: &Points<Perturbed, 3>| quantities::space_section(section, points, Normalization::Reciprocal);
            off(row, &points, of, |points| quantities::space_section::<F>(section, points, Normalization::Reciprocal))
        }),
    };
    let at = row.derived.as_ref()?.at(&epsilon::<F>()) / epsilon::<F>();
    let observed = found.unwrap_or(0.0) / F::EPSILON.wide();
    Some(Observed {
        algorithm,
        section: row.section,
        name: row.name.clone(),
        precision,
        derived: at.to_f64(),
        observed,
    })
}

/// The error of a section's quantity: relative to itself if the bound is relative, else over L^p = 1.
fn off<F: Float, const D: usize>(
    row: &Derivation,
    points: &[[f64; D]; 6],
    exactly: impl Fn(&Points<Perturbed, D>) -> Vec<Named<Perturbed>>,
    computed: impl Fn(&Points<F, D>) -> Vec<Named<F>>,
) -> Option<f64> {
    let place = |all: &str| row.name == format!("E[{all}]") || row.name == format!("R[{all}]");
    let floats: Points<F, D> = points.map(|point| point.map(F::nearest));
    let all = computed(&floats);
    let at = all.iter().position(|named| place(named.symbol))?;
    let computed = all[at].value.wide();
    if !computed.is_finite() {
        return None;
    }
    let honest = Adversary::new(Rational::new);
    let inputs: Points<Perturbed, D> = points.map(|point| point.map(|x| honest.input(exact(x))));
    if points[0] == points[1] {
        return None;
    }
    let value = exactly(&inputs).swap_remove(at).value.exact;
    let off = (exact(computed) - &value).abs();
    if !row.name.starts_with('R') {
        return Some(off.to_f64());
    }
    if value.is_zero() { None } else { Some((off / value.abs()).to_f64()) }
}

/// The relative error of a tolerance of Algorithm 1 or 6.
fn tolerance<F: Float>(row: &Derivation, length: f64) -> Option<f64> {
    let halvings = 1023 - u32::try_from(F::EPSILON.wide().to_bits() >> 52).expect("eleven bits");
    let symbol = Symbol::ALL.into_iter().find(|symbol| row.name == format!("R[{}]", symbol.name()))?;
    let dimension = if row.section == "figure 1" { Dimension::Two } else { Dimension::Three };
    let published = Published::new(dimension, halvings, &Enclosure::exact(exact(length)));
    let band: Band = match dimension {
        Dimension::Two => {
            let t = Tolerances2d::<F>::from_length(F::nearest(length));
            match symbol {
                Symbol::Sigma => t.sigma,
                Symbol::Tau => t.tau,
                Symbol::SigmaHat => t.sigma_hat,
                _ => t.kappa,
            }
        }
        Dimension::Three => {
            let t = Tolerances3d::<F>::from_length(F::nearest(length));
            match symbol {
                Symbol::Sigma => t.sigma,
                Symbol::Tau => t.tau,
                Symbol::Delta => t.delta,
                Symbol::Gamma => t.gamma,
                Symbol::SigmaHat => t.sigma_hat,
                Symbol::Lambda => t.lambda,
                Symbol::Phi => t.phi,
                Symbol::Nu => t.nu,
                Symbol::Zeta => t.zeta,
                Symbol::Mu => t.mu,
                Symbol::Xi => t.xi,
                Symbol::Rho | Symbol::Kappa => t.rho,
            }
        }
    };
    let width = Enclosure::exact(published.limits(symbol)[1].clone()).sqrt().lower;
    Some(((exact(band.width) - &width) / width).abs().to_f64())
}

/// The relative error of L̂.
fn whole_length<F: Float>(section: &str, sides: [f64; 2]) -> Option<f64> {
    let root = if section == "4.1" { F::EPSILON.sqrt() } else { F::EPSILON.sqrt().sqrt() };
    let computed = algorithms::length(sides.map(F::nearest), root, F::nearest(7.0), |difference| difference);
    let epsilon = Enclosure::exact(epsilon::<F>());
    let root = if section == "4.1" { epsilon.sqrt() } else { epsilon.sqrt().sqrt() };
    let seven = Enclosure::exact(7.into());
    let sum = Enclosure::exact(exact(sides[0]) + exact(sides[1]));
    let value = (sum * (Enclosure::exact(1.into()) - seven * root).reciprocal()).lower;
    Some(((exact(computed.wide()) - &value) / value).abs().to_f64())
}

fn coordinates<F: Float, const N: usize>(
    random: &mut Random,
    effort: [u64; 2],
    value: impl Fn(&[f64; N]) -> Option<f64>,
) -> Option<f64> {
    let draw = |random: &mut Random| -> f64 {
        let x = match random.integer(0, 3) {
            0 => 0.5 - power_of_two(-random.integer(2, 30)) * random.unit(),
            _ => random.between(0.0, 0.5),
        };
        F::nearest(if random.one_in(2) { x } else { -x }).wide()
    };
    let start = |random: &mut Random| std::array::from_fn(|_| draw(random));
    let change = |random: &mut Random, from: &[f64; N]| {
        let mut to = *from;
        for _ in 0..random.integer(1, 3) {
            let at = usize::try_from(random.integer(0, i64::try_from(N).expect("few") - 1)).expect("not negative");
            let by = random.between(-1.0, 1.0) * power_of_two(-random.integer(1, 52));
            to[at] = if random.one_in(8) { draw(random) } else { F::nearest((to[at] + by).clamp(-0.5, 0.5)).wide() };
        }
        to
    };
    climb(random, effort, start, change, value).map(|(value, _)| value)
}

fn lengths<F: Float, const N: usize>(
    random: &mut Random,
    effort: [u64; 2],
    value: impl Fn([f64; N]) -> Option<f64>,
) -> Option<f64> {
    let start = |random: &mut Random| std::array::from_fn(|_| F::nearest(random.between(1.0, 4.0)).wide());
    let change = |random: &mut Random, from: &[f64; N]| {
        from.map(|x: f64| {
            let by = random.between(-1.0, 1.0) * power_of_two(-random.integer(1, 52));
            F::nearest((x + by).clamp(1.0, 4.0)).wide()
        })
    };
    climb(random, effort, start, change, |x: &[f64; N]| value(*x)).map(|(value, _)| value)
}
