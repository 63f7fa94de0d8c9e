//! Tolerances that are not the paper's.
//!
//! T₋, T and T₊ are off together, so that the backend keeps what it claims. Only
//! who holds it to the published figures can see it.

use predicament_predicates::Band;

use crate::{ContactTolerances, Float, Tolerances2d, Tolerances3d};

/// A tolerance that is twice or half of what it should be.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Misscaled {
    /// κ, doubled.
    DoubledKappa,
    /// λ, doubled.
    DoubledLambda,
    /// μ, halved.
    HalvedMu,
}

impl Misscaled {
    /// All of them.
    pub const ALL: [Misscaled; 3] = [Misscaled::DoubledKappa, Misscaled::DoubledLambda, Misscaled::HalvedMu];

    /// In words, with dashes.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Misscaled::DoubledKappa => "doubled-kappa",
            Misscaled::DoubledLambda => "doubled-lambda",
            Misscaled::HalvedMu => "halved-mu",
        }
    }

    /// The tolerances of the plane with the one that is off.
    #[must_use]
    pub fn plane<F: Float>(self, tolerances: Tolerances2d<F>) -> Tolerances2d<F> {
        match self {
            Misscaled::DoubledKappa => Tolerances2d { kappa: scaled(tolerances.kappa, 2.0), ..tolerances },
            Misscaled::DoubledLambda | Misscaled::HalvedMu => tolerances,
        }
    }

    /// Those of space.
    #[must_use]
    pub fn space<F: Float>(self, tolerances: Tolerances3d<F>) -> Tolerances3d<F> {
        match self {
            Misscaled::DoubledKappa => tolerances,
            Misscaled::DoubledLambda => Tolerances3d { lambda: scaled(tolerances.lambda, 2.0), ..tolerances },
            Misscaled::HalvedMu => Tolerances3d { mu: scaled(tolerances.mu, 0.5), ..tolerances },
        }
    }

    /// Those of contacts.
    #[must_use]
    pub fn contacts<F: Float>(self, tolerances: ContactTolerances<F>) -> ContactTolerances<F> {
        match tolerances {
            ContactTolerances::Plane(plane) => ContactTolerances::Plane(self.plane(plane)),
            ContactTolerances::Space(space) => ContactTolerances::Space(self.space(space)),
        }
    }
}

fn scaled(Band { lower, width, upper }: Band, factor: f64) -> Band {
    Band { lower: lower * factor, width: width * factor, upper: upper * factor }
}
