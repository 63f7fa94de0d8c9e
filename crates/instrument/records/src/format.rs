//! Numbers as text for reports: thousands separators, significant digits.

use crate::stats::approximately;

/// A whole number with thousands separators: `1234567` as `1,234,567`.
#[must_use]
pub fn thousands(n: u64) -> String {
    separated(&n.to_string())
}

/// A non-negative number with this many significant digits: `12.3`, `0.0457`, `1,230`. Zero is `0`.
#[must_use]
pub fn significant(x: f64, digits: usize) -> String {
    if !x.is_finite() || x < 0.0 {
        return "—".to_owned();
    }
    if x == 0.0 {
        return "0".to_owned();
    }
    // Rounding comes first, as it can carry into the next power of ten.
    let scientific = format!("{x:.*e}", digits.saturating_sub(1));
    let exponent: i64 = scientific.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    if !(-6..15).contains(&exponent) {
        return scientific;
    }
    let rounded: f64 = scientific.parse().unwrap_or(x);
    let wanted = i64::try_from(digits).unwrap_or(i64::MAX);
    let decimals = usize::try_from(wanted.saturating_sub(exponent + 1)).unwrap_or(0);
    separated(&format!("{rounded:.decimals$}"))
}

/// A time in nanoseconds with three significant digits.
#[must_use]
pub fn nanoseconds(ns: f64) -> String {
    significant(ns, 3)
}

/// A factor with two significant digits: `0.61×`.
#[must_use]
pub fn factor(ratio: f64) -> String {
    format!("{}×", significant(ratio, 2))
}

/// A share in percent, rounded to 0 or 100 only if it is exactly that.
#[must_use]
pub fn percent(part: u64, whole: u64) -> String {
    let share = 100.0 * approximately(part) / approximately(whole);
    match part {
        _ if whole == 0 => "—".to_owned(),
        0 => "0 %".to_owned(),
        _ if part == whole => "100 %".to_owned(),
        _ if share < 0.1 => "<0.1 %".to_owned(),
        _ if share > 99.9 => ">99.9 %".to_owned(),
        _ => format!("{share:.1} %"),
    }
}

/// The rate in a million; `None` if `whole` is 0.
#[must_use]
pub fn per_million(part: u64, whole: u64) -> Option<f64> {
    (whole > 0).then(|| 1e6 * approximately(part) / approximately(whole))
}

/// A count with its noun, in the plural unless the count is 1: `1 scene`, `1,000 scenes`.
#[must_use]
pub fn counted(n: u64, noun: &str) -> String {
    let plural = if n == 1 { "" } else { "s" };
    format!("{} {noun}{plural}", thousands(n))
}

/// A length as a `u64`. No collection in memory has more than 2^64 items.
#[must_use]
pub fn length(n: usize) -> u64 {
    u64::try_from(n).unwrap_or(u64::MAX)
}

fn separated(number: &str) -> String {
    let (whole, fraction) = number.split_at(number.find('.').unwrap_or(number.len()));
    let mut text = String::with_capacity(number.len() + number.len() / 3);
    for (i, digit) in whole.chars().enumerate() {
        if i > 0 && (whole.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text + fraction
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_separated() {
        let cases = [(0, "0"), (999, "999"), (1_000, "1,000"), (1_234_567, "1,234,567")];
        for (n, text) in cases {
            assert_eq!(thousands(n), text);
        }
    }

    #[test]
    fn digits_mean_something() {
        let cases = [
            (12.34, "12.3"),
            (0.045_67, "0.0457"),
            (1_234.0, "1,230"),
            (9.999, "10.0"),
            (999.9, "1,000"),
            (0.0, "0"),
            (3.2e-9, "3.20e-9"),
            (f64::NAN, "—"),
        ];
        for (x, text) in cases {
            assert_eq!(significant(x, 3), text, "{x}");
        }
        assert_eq!(factor(0.614), "0.61×");
        assert_eq!(factor(123.0), "120×");
    }

    #[test]
    fn a_share_is_all_or_nothing_only_if_it_is() {
        assert_eq!(percent(0, 10), "0 %");
        assert_eq!(percent(10, 10), "100 %");
        assert_eq!(percent(1, 1_000_000), "<0.1 %");
        assert_eq!(percent(999_999, 1_000_000), ">99.9 %");
        assert_eq!(percent(1, 3), "33.3 %");
        assert_eq!(percent(0, 0), "—");
        assert_eq!(per_million(0, 0), None);
        assert_eq!(per_million(3, 2_000_000), Some(1.5));
    }
}
