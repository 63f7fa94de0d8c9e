//! Figures 1 and 5 as exact numbers: each tolerance is c ε^e L^p with c a rational multiple of 1 or √3.

use predicament_error_calculus::Enclosure;
use rug::Rational;

/// The number n/d, or n/d · √3.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Coefficient {
    numerator: u32,
    denominator: u32,
    root3: bool,
}

impl Coefficient {
    const fn new(numerator: u32, denominator: u32) -> Coefficient {
        Coefficient { numerator, denominator, root3: false }
    }

    const fn root3(numerator: u32, denominator: u32) -> Coefficient {
        Coefficient { numerator, denominator, root3: true }
    }

    /// The rational factor.
    #[must_use]
    pub fn rational(self) -> Rational {
        Rational::from((self.numerator, self.denominator))
    }

    /// Returns true if √3 is a factor.
    #[must_use]
    pub fn has_root3(self) -> bool {
        self.root3
    }

    /// The coefficient as a number.
    #[must_use]
    pub fn value(self) -> Enclosure {
        let value = Enclosure::exact(self.rational());
        if self.root3 { value * Enclosure::exact(3.into()).sqrt() } else { value }
    }
}

/// A row of Figure 1 or 5.
#[derive(Clone, Debug)]
pub struct Tolerance {
    /// The symbol in the paper.
    pub symbol: &'static str,
    /// The coefficient c of T₋.
    pub lower: Coefficient,
    /// The coefficient c of T.
    pub width: Coefficient,
    /// The coefficient c of T₊.
    ///
    /// Where the figure has "≈" it is that of the constraint that defines it.
    pub upper: Coefficient,
    /// T₊ as printed.
    pub printed_upper: &'static str,
    /// 4e, for the factor ε^e.
    pub epsilon_quarters: u32,
    /// p, for the factor L^p.
    pub length: u32,
    /// R\[T\] over ε, as printed.
    pub printed_relative: u32,
}

const fn row(
    symbol: &'static str,
    [lower, width, upper]: [Coefficient; 3],
    printed_upper: &'static str,
    epsilon_quarters: u32,
    length: u32,
) -> Tolerance {
    Tolerance { symbol, lower, width, upper, printed_upper, epsilon_quarters, length, printed_relative: 4 }
}

const fn halves(lower: u32, width: u32, upper: u32) -> [Coefficient; 3] {
    [Coefficient::new(lower, 2), Coefficient::new(width, 2), Coefficient::new(upper, 2)]
}

const fn whole(lower: u32, width: u32, upper: u32) -> [Coefficient; 3] {
    [Coefficient::new(lower, 1), Coefficient::new(width, 1), Coefficient::new(upper, 1)]
}

const fn up_to(lower: u32, width: u32, upper: Coefficient) -> [Coefficient; 3] {
    [Coefficient::new(lower, 1), Coefficient::new(width, 1), upper]
}

const QUARTERS: [Coefficient; 3] = [Coefficient::new(2, 1), Coefficient::new(9, 4), Coefficient::new(5, 2)];

/// The tolerances of Figure 1.
pub const FIGURE_1: [Tolerance; 4] = [
    row("σ", halves(12, 13, 14), "7.0", 2, 1),
    row("τ", halves(8, 9, 10), "5.0", 2, 1),
    row("σ̂", halves(10, 11, 12), "6.0", 2, 1),
    row("κ", whole(10, 21, 32), "32", 4, 2),
];

/// The tolerances of Figure 5.
pub const FIGURE_5: [Tolerance; 12] = [
    row("σ", halves(12, 13, 14), "7.0", 1, 1),
    row("τ", halves(8, 9, 10), "5.0", 1, 1),
    row("δ", QUARTERS, "2.5", 1, 1),
    row("γ", QUARTERS, "2.5", 1, 1),
    row("σ̂", halves(10, 11, 12), "6.0", 1, 1),
    row("λ", whole(910, 1215, 1521), "1521", 4, 4),
    row("φ", halves(300, 940, 1521), "760.5", 4, 4),
    row("ν", [Coefficient::new(13_689, 4), Coefficient::new(13_689, 2), Coefficient::new(41_067, 4)], "10266.75", 4, 4),
    row("ζ", up_to(658, 1317, Coefficient::root3(4563, 4)), "≈1976", 4, 4),
    row("μ", whole(16, 24, 32), "32", 3, 3),
    row("ξ", up_to(28, 56, Coefficient::root3(48, 1)), "≈83", 3, 3),
    row("ρ", up_to(28, 56, Coefficient::root3(48, 1)), "≈83", 3, 3),
];

/// An upper tolerance that a constraint defines by others.
pub struct Defined {
    /// The section with the definition.
    pub section: &'static str,
    /// The symbol of the tolerance.
    pub symbol: &'static str,
    /// The formula of the definition.
    pub formula: &'static str,
    /// The row of its figure.
    pub tolerance: &'static Tolerance,
    /// The rational factor of the formula's value.
    pub derived: Rational,
    /// True if √3 is the other factor.
    pub root3: bool,
}

impl Defined {
    /// Returns true if the table's number equals the formula's value.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.tolerance.upper.rational() == self.derived && self.tolerance.upper.has_root3() == self.root3
    }

    /// The value of the formula.
    #[must_use]
    pub fn value(&self) -> Enclosure {
        let value = Enclosure::exact(self.derived.clone());
        if self.root3 { value * Enclosure::exact(3.into()).sqrt() } else { value }
    }

    /// Returns true if the table prints the formula's value.
    ///
    /// The table prints the value itself, or after "≈" the nearest number of as many digits.
    #[must_use]
    pub fn is_as_printed(&self) -> bool {
        let printed = self.tolerance.printed_upper;
        let Some(whole) = printed.strip_prefix('≈') else {
            return !self.root3 && decimal(printed) == self.derived;
        };
        let value = self.value();
        let (whole, half) = (decimal(whole), Rational::from((1, 2)));
        value.lower > Rational::from(&whole - &half) && value.upper < whole + half
    }
}

/// A decimal of the tables, as a rational.
fn decimal(text: &str) -> Rational {
    let (whole, digits) = text.split_once('.').unwrap_or((text, ""));
    let number: u64 = format!("{whole}{digits}").parse().expect("a decimal");
    Rational::from((number, 10_u64.pow(u32::try_from(digits.len()).expect("few"))))
}

/// The row of a figure with this symbol.
///
/// # Panics
/// If the figure has no such symbol.
#[must_use]
pub fn named(figure: &'static [Tolerance], symbol: &str) -> &'static Tolerance {
    figure.iter().find(|row| row.symbol == symbol).expect("a symbol of the figure")
}

/// Every definition of an upper tolerance in sections 4 and 5.
#[must_use]
pub fn defined() -> Vec<Defined> {
    let c = |tolerance: Coefficient| tolerance.rational();
    let plane = |symbol| named(&FIGURE_1, symbol);
    let space = |symbol| named(&FIGURE_5, symbol);
    let two_tau: Rational = c(plane("τ").lower).square() * 2;
    let gap = |symbol| -> Rational { (c(space("τ").lower).square() - c(space(symbol).upper).square()).square() };
    let (gamma, delta) = (c(space("γ").lower), c(space("δ").lower));
    let edge = Rational::from(gamma.square_ref()) * Rational::from((&gamma).min(&delta));
    let face = Rational::from(delta.square_ref()) * &delta;
    let row = |section, tolerance: &'static Tolerance, formula, derived: Rational, root3| Defined {
        section,
        symbol: tolerance.symbol,
        formula,
        tolerance,
        derived,
        root3,
    };
    vec![
        row("4.4", plane("κ"), "2τ₋²", two_tau.clone(), false),
        row("4.5", plane("κ"), "2τ₋²", two_tau, false),
        row("5.4", space("λ"), "16(τ₋² − γ₊²)²", gap("γ") * 16, false),
        row("5.4", space("φ"), "8(τ₋² − γ₊²)²", gap("γ") * 8, false),
        row("5.5", space("ν"), "108(τ₋² − δ₊²)²", gap("δ") * 108, false),
        row("5.5", space("ζ"), "12√3(τ₋² − δ₊²)²", gap("δ") * 12, true),
        row("5.6", space("μ"), "4γ₋² min(γ₋, δ₋)", edge.clone() * 4, false),
        row("5.6", space("ξ"), "6√3γ₋² min(γ₋, δ₋)", edge * 6, true),
        row("5.7", space("ρ"), "6√3δ₋³", face * 6, true),
    ]
}
