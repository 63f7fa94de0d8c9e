//! The most memory that something takes, where the system says so.

/// The most memory that the process had while it did this, above what it had before, in bytes; none where the system does not say.
///
/// (Linux: writing 5 to `clear_refs` sets the largest resident size to the present one.) What other threads take is in it.
pub(super) fn peak(work: impl FnOnce()) -> Option<u64> {
    std::fs::write("/proc/self/clear_refs", "5").ok()?;
    let before = resident("VmRSS:")?;
    work();
    Some(resident("VmHWM:")?.saturating_sub(before))
}

fn resident(name: &str) -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(name))?;
    line.split_whitespace().next()?.parse::<u64>().ok().map(|kilobytes| kilobytes * 1024)
}
