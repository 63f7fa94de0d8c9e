//! The peak memory of a computation, if the system reports it.

/// The peak memory of the process during `work`, above its memory before, in bytes.
///
/// `None` if the system does not report it. (Linux: writing 5 to `clear_refs` resets the largest resident size to the
/// present one.) It includes the memory of other threads.
pub(crate) fn peak(work: impl FnOnce()) -> Option<u64> {
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
