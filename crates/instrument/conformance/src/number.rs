//! The types of coordinates: what a scene's doubles become in each, and what can be done to them without rounding.

use predicament_families::bits::{power_of_two, scale, top_exponent};
use predicament_judge::portable;

/// A type of coordinates: `f64`, `f32`, `i64` or `i32`.
pub trait Number: sealed::Sealed + Copy + PartialEq + std::fmt::Debug + std::fmt::Display + 'static {
    /// The type's name in Rust.
    const NAME: &'static str;
    /// True if the type has exponents.
    const IS_FLOAT: bool;
    /// Zero.
    const ZERO: Self;

    /// The number that equals a double; `None` if the type has no such number.
    fn exactly(x: f64) -> Option<Self>;

    /// Generated coordinates of one query in this type, rounded together so that the query keeps its difficulty; `None`
    /// if the type cannot hold a query like this one. `at` is the number of the query, and selects the magnitude of
    /// integers.
    fn fitted(query: &[f64], at: usize) -> Option<Vec<Self>>;

    /// The number for the judge.
    fn judged(self) -> portable::Number;

    /// The nearest double.
    fn nearest_double(self) -> f64;

    /// The sum, if it is exact.
    fn plus(self, other: Self) -> Option<Self>;

    /// The difference, if it is exact.
    fn minus(self, other: Self) -> Option<Self>;

    /// The number times 2^k, if it is exact.
    fn times_power(self, k: i32) -> Option<Self>;

    /// The exponents of the highest and the lowest bit; `None` for zero.
    fn bits(self) -> Option<[i64; 2]>;

    /// The nearest number with this many significant bits (1 to 53).
    fn rounded(self, bits: u32) -> Self;

    /// The number in hexadecimal digits.
    fn hex(self) -> String;

    /// The number as an expression of Rust, exactly.
    fn literal(self) -> String;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f64 {}
    impl Sealed for f32 {}
    impl Sealed for i64 {}
    impl Sealed for i32 {}
}

/// The exponents of the highest and the lowest bit of a double; `None` for zero.
fn bits_of(x: f64) -> Option<[i64; 2]> {
    Some([top_exponent(x)?, predicament_families::bits::lowest_bit(x)?])
}

/// The largest and the smallest exponent of the highest bits; `None` if all are zero.
fn tops(query: &[f64]) -> Option<[i64; 2]> {
    let tops = || query.iter().filter_map(|&x| top_exponent(x));
    Some([tops().max()?, tops().min()?])
}

/// The double in hexadecimal digits, as C and `%a` write it.
fn hex_of(x: f64) -> String {
    let (sign, bits) = (if x.is_sign_negative() { "-" } else { "" }, x.abs().to_bits());
    let (field, fraction) = (bits >> 52, bits & ((1 << 52) - 1));
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    match i64::try_from(field).unwrap_or(0) {
        0 if fraction == 0 => format!("{sign}0x0p+0"),
        0 => format!("{sign}0x0{point}{digits}p-1022"),
        field => format!("{sign}0x1{point}{digits}p{:+}", field - 1023),
    }
}

/// The sum of two doubles, if it is exact: if the error term of Knuth's sum is zero.
fn exact_sum(x: f64, y: f64) -> Option<f64> {
    let sum = x + y;
    let seen = sum - x;
    let error = (x - (sum - seen)) + (y - seen);
    (sum.is_finite() && error == 0.0).then_some(sum)
}

fn exact_scale(x: f64, k: i32) -> Option<f64> {
    let scaled = scale(x, k.into());
    (scaled.is_finite() && scale(scaled, -i64::from(k)) == x).then_some(scaled)
}

impl Number for f64 {
    const NAME: &'static str = "f64";
    const IS_FLOAT: bool = true;
    const ZERO: f64 = 0.0;

    fn exactly(x: f64) -> Option<f64> {
        Some(x)
    }

    fn fitted(query: &[f64], _: usize) -> Option<Vec<f64>> {
        Some(query.to_vec())
    }

    fn judged(self) -> portable::Number {
        portable::Number::of(self).expect("coordinates are finite")
    }

    fn nearest_double(self) -> f64 {
        self
    }

    fn plus(self, other: f64) -> Option<f64> {
        exact_sum(self, other)
    }

    fn minus(self, other: f64) -> Option<f64> {
        exact_sum(self, -other)
    }

    fn times_power(self, k: i32) -> Option<f64> {
        exact_scale(self, k)
    }

    fn bits(self) -> Option<[i64; 2]> {
        bits_of(self)
    }

    fn rounded(self, bits: u32) -> f64 {
        let rounded = predicament_families::bits::rounded(self, bits);
        if rounded.is_finite() { rounded } else { self }
    }

    fn hex(self) -> String {
        hex_of(self)
    }

    fn literal(self) -> String {
        format!("f64::from_bits(0x{:016x})", self.to_bits())
    }
}

/// The nearest single.
#[allow(clippy::cast_possible_truncation)] // rounding is the purpose
fn single(x: f64) -> f32 {
    x as f32
}

impl Number for f32 {
    const NAME: &'static str = "f32";
    const IS_FLOAT: bool = true;
    const ZERO: f32 = 0.0;

    fn exactly(x: f64) -> Option<f32> {
        let rounded = single(x);
        (f64::from(rounded) == x).then_some(rounded)
    }

    /// Rounds. Beyond the range of singles a query is moved into it as a whole, or each exponent is, if the exponents
    /// of the query are far apart. The neighbours of 0.5 become neighbours among singles.
    fn fitted(query: &[f64], _: usize) -> Option<Vec<f32>> {
        let (near, more) = (power_of_two(-40), power_of_two(29));
        let moved = |x: f64| if (x - 0.5).abs() < near { 0.5 + (x - 0.5) * more } else { x };
        let is_beside_half = query.iter().filter(|&&x| x != 0.5 && (x - 0.5).abs() < near).count() > 1;
        let Some([most, least]) = tops(query) else { return Some(vec![0.0; query.len()]) };
        let smaller = |exponent: i64| exponent * 127 / 1023;
        let fitted: Vec<f32> = if is_beside_half {
            query.iter().map(|&x| single(moved(x))).collect()
        } else if most <= 127 && least >= -126 {
            query.iter().map(|&x| single(x)).collect()
        } else if most - least < 100 {
            query.iter().map(|&x| single(scale(x, smaller(most) - most))).collect()
        } else {
            let each = |&x: &f64| top_exponent(x).map_or(0.0, |top| single(scale(x, smaller(top) - top)));
            query.iter().map(each).collect()
        };
        fitted.iter().all(|x| x.is_finite()).then_some(fitted)
    }

    fn judged(self) -> portable::Number {
        f64::from(self).judged()
    }

    fn nearest_double(self) -> f64 {
        self.into()
    }

    fn plus(self, other: f32) -> Option<f32> {
        exact_sum(self.into(), other.into()).and_then(f32::exactly)
    }

    fn minus(self, other: f32) -> Option<f32> {
        self.plus(-other)
    }

    fn times_power(self, k: i32) -> Option<f32> {
        exact_scale(self.into(), k).and_then(f32::exactly)
    }

    fn bits(self) -> Option<[i64; 2]> {
        bits_of(self.into())
    }

    fn rounded(self, bits: u32) -> f32 {
        let rounded = single(f64::from(self).rounded(bits.min(24)));
        if rounded.is_finite() { rounded } else { self }
    }

    fn hex(self) -> String {
        hex_of(self.into())
    }

    fn literal(self) -> String {
        format!("f32::from_bits(0x{:08x})", self.to_bits())
    }
}

/// Implements the trait for an integer.
///
/// Generated queries are scaled to these numbers of bits in turn, the whole type first: differences overflow there,
/// and products further down.
macro_rules! integers {
    ($integer:ident, $levels:expr) => {
        impl Number for $integer {
            const NAME: &'static str = stringify!($integer);
            const IS_FLOAT: bool = false;
            const ZERO: $integer = 0;

            fn exactly(x: f64) -> Option<$integer> {
                #[allow(clippy::cast_possible_truncation)] // compared below
                let whole = x as i128;
                #[allow(clippy::cast_precision_loss)] // compared here
                let back = whole as f64;
                (back == x).then(|| $integer::try_from(whole).ok())?
            }

            /// Scales and rounds to integers of several magnitudes in turn; small integers stay as they are in every
            /// other query. A query whose exponents are further apart than the bits of the type has no equal here.
            fn fitted(query: &[f64], at: usize) -> Option<Vec<$integer>> {
                const LEVELS: &[i64] = &$levels;
                if at.is_multiple_of(2)
                    && let Some(same) = query.iter().map(|&x| $integer::exactly(x)).collect()
                {
                    return Some(same);
                }
                let Some([most, least]) = tops(query) else { return Some(vec![0; query.len()]) };
                if most - least > 60 {
                    return None;
                }
                let level = LEVELS[at / 2 % LEVELS.len()];
                // Queries without negative coordinates get some: half of the range would be unused.
                let is_positive = query.iter().all(|&x| x >= 0.0);
                let shift = level - 1 - most + i64::from(is_positive);
                let down = if is_positive { 1_i128 << level } else { 0 };
                let moved = |&x: &f64| {
                    #[allow(clippy::cast_possible_truncation)] // rounded to a whole number of at most 65 bits
                    let whole = scale(x, shift).round() as i128 - down;
                    $integer::try_from(whole).unwrap_or(if whole < 0 { $integer::MIN } else { $integer::MAX })
                };
                Some(query.iter().map(moved).collect())
            }

            fn judged(self) -> portable::Number {
                i64::from(self).into()
            }

            #[allow(clippy::cast_precision_loss, clippy::cast_lossless)] // the nearest double is the purpose
            fn nearest_double(self) -> f64 {
                self as f64
            }

            fn plus(self, other: $integer) -> Option<$integer> {
                self.checked_add(other)
            }

            fn minus(self, other: $integer) -> Option<$integer> {
                self.checked_sub(other)
            }

            fn times_power(self, k: i32) -> Option<$integer> {
                let factor = (1 as $integer).checked_shl(k.unsigned_abs()).filter(|&factor| factor > 0)?;
                if k >= 0 {
                    return self.checked_mul(factor);
                }
                (self % factor == 0).then(|| self / factor)
            }

            fn bits(self) -> Option<[i64; 2]> {
                let magnitude = self.unsigned_abs();
                (magnitude != 0).then(|| [magnitude.ilog2().into(), magnitude.trailing_zeros().into()])
            }

            fn rounded(self, bits: u32) -> $integer {
                let Some([top, _]) = self.bits() else { return self };
                let dropped = (top + 1 - i64::from(bits)).max(0);
                let unit = (1 as $integer).checked_shl(u32::try_from(dropped).unwrap_or(0)).unwrap_or(1);
                if unit <= 1 { self } else { self / unit * unit }
            }

            fn hex(self) -> String {
                let sign = if self < 0 { "-" } else { "" };
                format!("{sign}0x{:x}", self.unsigned_abs())
            }

            fn literal(self) -> String {
                if self == $integer::MIN { format!("{}::MIN", Self::NAME) } else { self.to_string() }
            }
        }
    };
}

integers!(i64, [63, 62, 53, 40, 31, 20]);
integers!(i32, [31, 30, 24, 20, 15, 10]);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_hexadecimal_digits() {
        for (x, hex) in [
            (1.0, "0x1p+0"),
            (-0.75, "-0x1.8p-1"),
            (0.1, "0x1.999999999999ap-4"),
            (5e-324, "0x0.0000000000001p-1022"),
            (0.0, "0x0p+0"),
            (f64::MAX, "0x1.fffffffffffffp+1023"),
        ] {
            assert_eq!(x.hex(), hex);
        }
        assert_eq!([(-255_i32).hex(), i32::MIN.hex()], ["-0xff", "-0x80000000"]);
        assert_eq!([7_i32.literal(), i64::MIN.literal()], ["7", "i64::MIN"]);
        assert_eq!(0.5_f32.literal(), "f32::from_bits(0x3f000000)");
    }

    #[test]
    fn operations_are_exact_or_refused() {
        assert_eq!(1.0_f64.plus(f64::EPSILON), Some(1.0 + f64::EPSILON));
        assert_eq!(1.0_f64.plus(1e-30), None);
        assert_eq!(1.0_f32.plus(f32::EPSILON / 4.0), None);
        assert_eq!(f64::MAX.times_power(1), None);
        assert_eq!(5e-324_f64.times_power(-1), None);
        assert_eq!(3_i32.times_power(-1), None);
        assert_eq!([6_i32.times_power(-1), i32::MAX.times_power(1)], [Some(3), None]);
        assert_eq!([1_i32.times_power(30), 1_i32.times_power(31), 1_i32.times_power(99)], [Some(1 << 30), None, None]);
        assert_eq!(i32::MAX.plus(1), None);
        assert_eq!([i32::exactly(7.0), i32::exactly(7.5), i32::exactly(3e9)], [Some(7), None, None]);
        assert_eq!(i64::exactly(9_223_372_036_854_775_808.0), None);
        assert_eq!(f32::exactly(0.1), None);
    }

    #[test]
    fn queries_keep_their_difficulty() {
        assert_eq!(f32::fitted(&[1e300, 1e299], 0).map(|all| all[0] / all[1] > 9.0), Some(true));
        let mixed = f32::fitted(&[1e300, 1e-300, 0.0], 0).unwrap();
        assert!(mixed[0] > 1e30 && mixed[1] < 1e-30 && mixed[1] > 0.0, "{mixed:?}");
        let beside = f32::fitted(&[0.5 + f64::EPSILON, 0.5 + 2.0 * f64::EPSILON, 12.0], 0).unwrap();
        assert!(beside[0] > 0.5 && beside[1] > beside[0], "{beside:?}");
        assert_eq!(i32::fitted(&[3.0, -4.0], 0), Some(vec![3, -4]), "as they are");
        assert_eq!(i32::fitted(&[1.0, -0.5], 1), Some(vec![1 << 30, -(1 << 29)]), "31 bits");
        assert_eq!(i32::fitted(&[1.0, 0.0, 1.5], 1), Some(vec![0, i32::MIN, 1 << 30]), "31 bits and a sign");
        assert_eq!(i64::fitted(&[1.0, 0.0], 1), Some(vec![0, i64::MIN]));
        assert_eq!(i32::fitted(&[1e300, 1e-300], 1), None);
        assert_eq!(i32::fitted(&[-1.0 - 1e-12], 1), Some(vec![i32::MIN >> 1]));
    }
}
