//! The error bounds that the paper states, as printed.

/// A bound of E or R.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// E: absolute, over ε L^p.
    Absolute,
    /// R: relative, over ε.
    Relative,
}

/// A stated bound.
#[derive(Clone, Copy, Debug)]
pub struct Published {
    /// Where it is stated.
    pub section: &'static str,
    /// Of what.
    pub symbol: &'static str,
    /// E or R.
    pub kind: Kind,
    /// The number before ε.
    pub figure: u32,
}

const fn e(section: &'static str, symbol: &'static str, figure: u32) -> Published {
    Published { section, symbol, kind: Kind::Absolute, figure }
}

const fn r(section: &'static str, symbol: &'static str, figure: u32) -> Published {
    Published { section, symbol, kind: Kind::Relative, figure }
}

/// All that sections 4 and 5 state under "Floating point". R\[T\] of the tables
/// stand with the tables, those of 4.1, 5.1 and 5.4.4 in [`TOLERANCES`].
pub const QUANTITIES: [Published; 42] = [
    r("4.2", "d²", 5),
    e("4.2", "d²", 9),
    r("4.3", "m", 4),
    e("4.3", "m", 5),
    e("4.3", "d", 19),
    e("4.3", "â", 19),
    e("4.3", "ā", 26),
    e("4.4", "a_P", 9),
    e("4.4", "a_Q", 9),
    e("4.4", "a_A", 9),
    e("4.4", "a_B", 9),
    e("4.5", "a_A", 9),
    e("4.5", "a_B", 9),
    e("4.5", "a_C", 9),
    r("5.2", "d²", 6),
    e("5.2", "d²", 16),
    r("5.3", "m", 4),
    e("5.3", "m", 7),
    e("5.3", "d²", 261),
    e("5.3", "â", 31),
    e("5.3", "ā", 42),
    e("5.4", "m²", 129),
    e("5.4", "d̂", 47),
    e("5.4", "d̂²", 589),
    e("5.4", "â", 129),
    e("5.4", "b̂", 129),
    e("5.4", "ā", 281),
    e("5.4", "b̄", 281),
    e("5.5", "m²", 129),
    e("5.5", "d̂", 47),
    e("5.5", "â", 445),
    e("5.5", "b̂", 129),
    e("5.5", "ĉ", 129),
    e("5.6", "v_A", 47),
    e("5.6", "v_B", 47),
    e("5.6", "v_C", 47),
    e("5.6", "v_P", 47),
    e("5.6", "v_Q", 47),
    e("5.7", "v_A", 47),
    e("5.7", "v_B", 47),
    e("5.7", "v_C", 47),
    e("5.7", "v_D", 47),
];

/// m² ≤ 12L⁴, stated in 5.4: the c of m².
pub const M_SQUARED: u32 = 12;

/// What the text says about L and the tolerances: 4.1, 5.1 and 5.4.4.
pub const TOLERANCES: [Published; 6] = [
    r("4.1", "L̂", 5),
    r("5.1", "L̂", 5),
    r("5.1", "ζ", 4),
    r("5.1", "ζ²", 9),
    r("5.1", "√(ζ² − κ²)", 5),
    r("5.4.4", "γ²", 10),
];
