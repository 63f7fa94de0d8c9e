//! Doubles as integers times powers of two, for all of the judge's integers.

/// Returns s and e with |x| = s·2^e, for a finite x: e is the exponent of the last place, −1074 at least.
///
/// The arithmetic under test reads doubles with `Parts` of `predicament-arithmetic`. The judge has its own reader on
/// purpose: with a shared reader, one fault would hide in both.
///
/// # Panics
/// If `x` is not finite.
pub(crate) fn split(x: f64) -> (u64, i32) {
    let bits = x.to_bits();
    let fraction = bits & ((1 << 52) - 1);
    match i32::try_from(bits >> 52 & 0x7ff).expect("11 bits") {
        0x7ff => panic!("scenes hold finite coordinates only"),
        0 => (fraction, -1074),
        biased => (fraction | 1 << 52, biased - 1075),
    }
}
