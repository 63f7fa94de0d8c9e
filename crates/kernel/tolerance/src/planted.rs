//! Planted faults: tolerances that differ from the paper's.
//!
//! T₋, T and T₊ are off together, so the backend keeps its declared band. Only a comparison with the published figures
//! detects the fault.
//!
//! A tolerance of twice the correct value is beyond the published T₊, and breaks its promise; this holds for all 16. A
//! tolerance of half the correct value is below T₋ if T₋ > T/2: σ, τ, γ, δ, σ̂, λ and μ. For the others T/2 ≥ T₋, and
//! the promise, that all up to T₋ is registered, is kept except for rounding: [`Misscaled::keeps_its_promise`]. For λ
//! it is kept too, as the test after it takes its place.

use predicament_predicates::{Band, Dimension};

use crate::{ContactTolerances, Float, Tolerances2d, Tolerances3d};

/// A tolerance of twice or half its correct value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Misscaled {
    /// The dimension of its figure: 2D for Figure 1, 3D for Figure 5.
    pub dimension: Dimension,
    /// The tolerance's symbol in the paper.
    pub symbol: &'static str,
    /// True if the tolerance is halved, false if it is doubled.
    pub halved: bool,
    /// The fault's name in a backend's name.
    pub fault: &'static str,
    /// The fault in one line.
    pub what: &'static str,
}

/// Lists both faults of a tolerance, doubled and halved.
macro_rules! misscaled {
    ($($dimension:ident $symbol:literal $name:literal $of:literal,)*) => {
        [$(
            Misscaled {
                dimension: Dimension::$dimension,
                symbol: $symbol,
                halved: false,
                fault: concat!("tolerance-doubled-", $name),
                what: concat!($of, " twice the published, and claimed so"),
            },
            Misscaled {
                dimension: Dimension::$dimension,
                symbol: $symbol,
                halved: true,
                fault: concat!("tolerance-halved-", $name),
                what: concat!($of, " half of the published, and claimed so"),
            },
        )*]
    };
}

impl Misscaled {
    /// All such faults: each tolerance of Figures 1 and 5 that an algorithm compares with.
    pub const ALL: [Misscaled; 32] = misscaled![
        Two "σ" "sigma-2d" "σ of the plane, of two vertices:",
        Two "τ" "tau-2d" "τ of the plane, of an edge and a vertex:",
        Two "σ̂" "sigma-hat-2d" "σ̂ of the plane, the least length of an edge:",
        Two "κ" "kappa" "κ, areas in the plane:",
        Three "σ" "sigma-3d" "σ of space, of two vertices:",
        Three "τ" "tau-3d" "τ of space, of an edge and a vertex:",
        Three "δ" "delta" "δ, of a triangle and a vertex:",
        Three "γ" "gamma" "γ, of two edges:",
        Three "σ̂" "sigma-hat-3d" "σ̂ of space, the least length of an edge:",
        Three "λ" "lambda" "λ, the squared area of two edges:",
        Three "φ" "phi" "φ, the weights of two edges:",
        Three "ν" "nu" "ν, the squared area of a triangle:",
        Three "ζ" "zeta" "ζ, the weights of a triangle:",
        Three "μ" "mu" "μ, volumes of an edge with the edges of a triangle:",
        Three "ξ" "xi" "ξ, volumes of a triangle with the ends of an edge:",
        Three "ρ" "rho" "ρ, volumes of a vertex with the faces of a tetrahedron:",
    ];

    /// The faults whose effect on an answer can be detected.
    pub fn visible() -> impl Iterator<Item = Misscaled> {
        Misscaled::ALL.into_iter().filter(|misscaled| !misscaled.keeps_its_promise())
    }

    /// The fault in words, with dashes.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.fault.trim_start_matches("tolerance-")
    }

    /// Returns true if the paper's promise about the tolerance still holds, except for the slack for rounding.
    ///
    /// Everything up to T₋ must be found within T, and nothing beyond T₊. This holds for T/2 if T/2 ≥ T₋: κ 10.5
    /// against 10, φ 235 against 150, ν 3422.25 against the same, ζ 658.5 against 658, ξ and ρ 28 against 28. The fault
    /// loses T − T₋, the slack for rounding, which `predicament study bounds` decides about. If T/2 is T₋ itself, about
    /// one in a hundred pairs at T₋ shows the fault in single precision, by rounding. λ/2 is below λ₋. But if m² ≤ λ₋ =
    /// 910 ε L⁴, then â or ā is 455 ε L⁴ at most, below φ = 470 ε L⁴, so the pair is not registered anyway.
    #[must_use]
    pub fn keeps_its_promise(self) -> bool {
        self.halved && matches!(self.symbol, "κ" | "λ" | "φ" | "ν" | "ζ" | "ξ" | "ρ")
    }

    /// The tolerances of the plane with this fault.
    #[must_use]
    pub fn plane<F: Float>(self, mut tolerances: Tolerances2d<F>) -> Tolerances2d<F> {
        if self.dimension == Dimension::Two {
            self.scale(tolerances.bands_mut());
        }
        tolerances
    }

    /// The tolerances of space with this fault.
    #[must_use]
    pub fn space<F: Float>(self, mut tolerances: Tolerances3d<F>) -> Tolerances3d<F> {
        if self.dimension == Dimension::Three {
            self.scale(tolerances.bands_mut());
        }
        tolerances
    }

    /// The contact tolerances with this fault.
    #[must_use]
    pub fn contacts<F: Float>(self, tolerances: ContactTolerances<F>) -> ContactTolerances<F> {
        match tolerances {
            ContactTolerances::Plane(plane) => ContactTolerances::Plane(self.plane(plane)),
            ContactTolerances::Space(space) => ContactTolerances::Space(self.space(space)),
        }
    }

    fn scale<const N: usize>(self, bands: [(&'static str, &mut Band); N]) {
        let factor = if self.halved { 0.5 } else { 2.0 };
        for (_, band) in bands.into_iter().filter(|(symbol, _)| *symbol == self.symbol) {
            let Band { lower, width, upper } = *band;
            *band = Band { lower: lower * factor, width: width * factor, upper: upper * factor };
        }
    }
}
