//! The audit of the constants: T₋, T and T₊ against the published ones.
//!
//! A wrong tolerance can have no visible effect: another test covers for it, or its T₋ and T₊ leave it enough slack
//! ([`Misscaled::keeps_its_promise`]). The constants still show it. So the constants of the code under audit are
//! compared with the figures, entered a second time for the audit alone
//! ([`Published`](predicament_contacts::checks::audit::Published)).

use predicament_contacts::checks::audit::Symbol;
use predicament_predicates::Dimension;
use predicament_tolerance::{Float, Misscaled};

use super::Scheme;
use super::row::Form;
use super::stream::length;
use crate::Precision;

/// The largest relative difference of a constant from the published one.
///
/// It is the rounding of single precision, a few times over.
pub const NEAR_CONSTANT: f64 = 1.0 / 1_048_576.0;

/// The number of lengths L at which each constant is compared.
const LENGTHS: u64 = 16;

/// A tolerance of the code under audit, and its ratios to the published one.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Constant {
    /// The dimension, which determines the figure.
    pub dimension: Dimension,
    /// The binary format of the computation.
    pub precision: Precision,
    /// The planted fault of the tolerances, if any.
    pub form: Form,
    /// The tolerance's symbol.
    pub symbol: Symbol,
    /// The ratios of T₋, T and T₊ to the published ones, where furthest from 1.
    pub quotients: [f64; 3],
}

impl Constant {
    /// Returns true if the constant equals the published one, up to rounding.
    #[must_use]
    pub fn is_published(&self) -> bool {
        self.quotients.iter().all(|quotient| (quotient - 1.0).abs() <= NEAR_CONSTANT)
    }
}

/// All tolerances of a form in both dimensions and precisions; only the wrong one for a form with a planted fault.
#[must_use]
pub fn constants(form: Form) -> Vec<Constant> {
    let mut all = Vec::new();
    for dimension in [Dimension::Two, Dimension::Three] {
        for precision in Precision::ALL {
            let of = match precision {
                Precision::Double => compare::<f64>,
                Precision::Single => compare::<f32>,
            };
            all.extend(of(dimension, precision, form));
        }
    }
    let concerns = |constant: &Constant| match form {
        Form::Misscaled(Misscaled { dimension, symbol, .. }) => {
            (constant.dimension, constant.symbol.name()) == (dimension, symbol)
        }
        Form::Corrected | Form::AsPrinted => true,
    };
    all.retain(concerns);
    all
}

fn compare<F: Float>(dimension: Dimension, precision: Precision, form: Form) -> Vec<Constant> {
    let mut constants: Vec<Constant> = Vec::new();
    for at in 0..LENGTHS {
        // A spread of exponents and of digits.
        let bits = at.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let scheme = Scheme::<F>::new(dimension, length(precision, bits), form);
        let published = scheme.published();
        for (name, band) in scheme.tolerances.bands() {
            let symbol = Symbol::ALL.into_iter().find(|symbol| symbol.name() == name).expect("a symbol of the paper");
            let [lower, width, upper] = published.rounded(symbol);
            let quotients = [band.lower / lower, band.width / width, band.upper / upper];
            match constants.iter_mut().find(|constant| constant.symbol == symbol) {
                Some(known) => {
                    for (most, quotient) in known.quotients.iter_mut().zip(quotients) {
                        if (quotient - 1.0).abs() > (*most - 1.0).abs() {
                            *most = quotient;
                        }
                    }
                }
                None => constants.push(Constant { dimension, precision, form, symbol, quotients }),
            }
        }
    }
    constants
}
