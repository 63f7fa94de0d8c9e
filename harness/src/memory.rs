//! The memory that the system has left: a scene that needs more is refused before it fills the memory.

use std::fs;

const GIB: f64 = 1_073_741_824.0;

/// Refuses work that needs more bytes than `limit` GiB, or than the system has left.
///
/// # Errors
/// The message for the user.
pub fn check(needed: u64, limit: Option<f64>) -> Result<(), String> {
    let Some(left) = limit.or_else(|| available().map(gib)) else { return Ok(()) };
    let needed = gib(needed);
    if needed <= left {
        return Ok(());
    }
    let cure = match limit {
        Some(_) => "raise --memory, or take fewer vertices",
        None => "take fewer vertices, or a machine with more memory; --memory GIB sets the limit",
    };
    Err(format!("the answer needs about {needed:.3} GiB of memory, and {left:.3} GiB may be used: {cure}"))
}

#[allow(clippy::cast_precision_loss)] // an approximate amount
fn gib(bytes: u64) -> f64 {
    bytes as f64 / GIB
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
        assert_eq!(check(1 << 30, Some(1.0)), Ok(()));
        let refused = check(3 << 29, Some(1.0)).expect_err("too much");
        assert!(refused.contains("1.500 GiB") && refused.contains("1.000 GiB") && refused.contains("--memory"));
    }

    #[test]
    fn the_kernels_table_is_read() {
        assert_eq!(of_meminfo("MemTotal:  9 kB\nMemAvailable:   12 kB\nSwapFree: 1 kB\n"), Some(12 << 10));
        assert_eq!(of_meminfo("MemTotal:  9 kB\n"), None);
        assert_eq!(of_meminfo("MemAvailable: x kB\n"), None);
    }
}
