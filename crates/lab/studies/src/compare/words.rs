//! Numbers in words: shares with their intervals, counts with their denominators.

use predicament_records::format::{per_million, percent, significant, thousands};

use super::Measure;
use super::standing::{InputKey, Ratio, Share};

/// A count with its denominator, such as `12 of 820`.
pub(super) fn counted(share: Share) -> String {
    format!("{} of {}", thousands(share.count), thousands(share.of))
}

/// The interval of a share in percent: `0.84 to 2.5 %`, `at most 0.47 %`.
pub(super) fn percents(share: Share) -> String {
    ends(share.interval().map(|x| 100.0 * x), " %")
}

/// The interval of a share per million: `12 to 40 in a million`, `at most 12 in a million`.
pub(super) fn millionths(share: Share) -> String {
    ends(share.interval().map(|x| 1e6 * x), " in a million")
}

fn ends([low, high]: [f64; 2], unit: &str) -> String {
    if low == 0.0 {
        format!("at most {}{unit}", significant(high, 2))
    } else {
        format!("{} to {}{unit}", significant(low, 3), significant(high, 3))
    }
}

/// A share in percent; a dash if the denominator is zero.
pub(super) fn share(share: Share) -> String {
    if share.of == 0 { "–".to_owned() } else { percent(share.count, share.of) }
}

/// Wrong answers per million; a dash if the denominator is zero.
pub(super) fn rate(share: Share) -> String {
    per_million(share.count, share.of).map_or_else(|| "–".to_owned(), |x| significant(x, 3))
}

/// A ratio with three digits, such as `1.11×`.
pub(super) fn times(ratio: f64) -> String {
    format!("{}×", significant(ratio, 3))
}

/// The inputs of a ratio, such as `42 of 55 inputs`.
pub(super) fn pairs(ratio: &Ratio) -> String {
    format!("{} of {} inputs", ratio.pairs, ratio.of)
}

/// A number of scenes: `1 scene`, `20 scenes`.
pub(super) fn scenes(n: u64) -> String {
    predicament_records::format::counted(n, "scene")
}

/// The name of an input: `orient2d near`. A task has one family of each kind.
pub(super) fn input([task, kind, _]: &InputKey<'_>) -> String {
    format!("{task} {kind}")
}

/// A list in words: `a`, `a and b`, `a, b and c`.
pub(super) fn listed(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

/// A number in three digits.
pub(crate) fn short(value: Option<f64>) -> String {
    match value {
        None => "–".to_owned(),
        Some(0.0) => "0".to_owned(),
        Some(x) if x.is_infinite() => "none".to_owned(),
        Some(x) if (0.01..100.0).contains(&x) => {
            format!("{x:.3}").trim_end_matches('0').trim_end_matches('.').to_owned()
        }
        Some(x) if (100.0..1e7).contains(&x) => format!("{x:.0}"),
        Some(x) => format!("{x:.1e}"),
    }
}

/// The largest value of a backend's rows that `is_asked` selects.
pub(super) fn largest(measures: &[Measure], backend: &str, is_asked: impl Fn(&Measure) -> bool) -> Option<f64> {
    let of = measures.iter().filter(|row| row.backend == backend && is_asked(row));
    of.map(|row| row.value).max_by(f64::total_cmp)
}
