//! The memory that the system has left: a scene that needs more is refused before it fills the memory.

use std::fs;

/// The names of units, each 1024 times the one before.
const UNITS: [&str; 4] = ["B", "KiB", "MiB", "GiB"];
const GIB: f64 = 1_073_741_824.0;

/// Reads a limit in GiB, as bytes.
///
/// # Errors
/// The message for the user.
pub fn limit(text: &str) -> Result<f64, String> {
    let gib = text.parse::<f64>().ok().filter(|gib| *gib > 0.0 && gib.is_finite());
    gib.map(|gib| gib * GIB)
        .ok_or_else(|| "the limit is a number of GiB greater than zero, such as 8 or 0.5".to_owned())
}

/// Refuses work that needs more bytes than `limit`, or than the system has left.
///
/// # Errors
/// The message for the user.
#[allow(clippy::cast_precision_loss)] // approximate amounts
pub fn check(needed: u64, limit: Option<f64>) -> Result<(), String> {
    let Some(left) = limit.or_else(|| available().map(|bytes| bytes as f64)) else { return Ok(()) };
    let needed = needed as f64;
    if needed <= left {
        return Ok(());
    }
    let cure = match limit {
        Some(_) => "raise --memory, or take fewer vertices",
        None => "take fewer vertices, or a machine with more memory; --memory GIB sets the limit",
    };
    let [needed, left] = [needed, left].map(amount);
    Err(format!("the answer needs about {needed} of memory, and {left} may be used: {cure}"))
}

/// Bytes in the largest unit of which there is at least one.
fn amount(mut bytes: f64) -> String {
    let mut unit = 0;
    while bytes >= 1024.0 && unit + 1 < UNITS.len() {
        bytes /= 1024.0;
        unit += 1;
    }
    format!("{bytes:.1} {}", UNITS[unit])
}

/// The bytes that processes can still take, by the kernel and by the control group; `None` if it is not known.
fn available() -> Option<u64> {
    let text = |path: &str| fs::read_to_string(path).ok();
    let whole = text("/proc/meminfo").and_then(|text| of_meminfo(&text))?;
    let number = |path: &str| text(path).and_then(|text| text.trim().parse::<u64>().ok());
    let of_group = number("/sys/fs/cgroup/memory.max")
        .zip(number("/sys/fs/cgroup/memory.current"))
        .map(|(most, used)| most.saturating_sub(used));
    Some(of_group.map_or(whole, |of_group| of_group.min(whole)))
}

/// The available bytes that `/proc/meminfo` states.
fn of_meminfo(text: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()?.checked_mul(1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_than_is_left_is_refused_with_both_amounts() {
        assert_eq!(check(1 << 30, Some(GIB)), Ok(()));
        let refused = check(3 << 29, Some(GIB)).expect_err("too much");
        assert!(refused.contains("1.5 GiB") && refused.contains("1.0 GiB") && refused.contains("--memory"));
        assert_eq!([0.0, 1023.0, 1024.0, 5e6].map(amount), ["0.0 B", "1023.0 B", "1.0 KiB", "4.8 MiB"]);
    }

    #[test]
    fn a_limit_is_a_number_above_zero() {
        assert_eq!(limit("0.5"), Ok(GIB / 2.0));
        for text in ["0", "-1", "nan", "inf", "1e999", "", "8 GiB"] {
            assert!(limit(text).is_err(), "{text}");
        }
    }

    #[test]
    fn the_kernels_table_is_read() {
        assert_eq!(of_meminfo("MemTotal:  9 kB\nMemAvailable:   12 kB\nSwapFree: 1 kB\n"), Some(12 << 10));
        assert_eq!(of_meminfo("MemTotal:  9 kB\n"), None);
        assert_eq!(of_meminfo("MemAvailable: x kB\n"), None);
    }
}
