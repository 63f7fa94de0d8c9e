//! The peak memory of a computation, if the system reports it.

use std::path::Path;

/// The peak memory of the process during `work`, above its memory before, in bytes; `None` if the system does not
/// report it. It includes the memory of other threads.
///
/// Memory that the process has freed before may serve `work` and is not counted. (Linux: writing 5 to `clear_refs`
/// resets the largest resident size to the present one.)
pub(crate) fn peak(work: impl FnOnce()) -> Option<u64> {
    peak_of(Path::new("/proc/self"), work)
}

fn peak_of(process: &Path, work: impl FnOnce()) -> Option<u64> {
    let reset = std::fs::write(process.join("clear_refs"), "5");
    let before = reset.ok().and_then(|()| resident(process, "VmRSS:"));
    work();
    Some(resident(process, "VmHWM:")?.saturating_sub(before?))
}

fn resident(process: &Path, name: &str) -> Option<u64> {
    let status = std::fs::read_to_string(process.join("status")).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(name))?;
    line.split_whitespace().next()?.parse::<u64>().ok().map(|kilobytes| kilobytes * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_work_is_done_where_no_memory_is_reported() {
        let mut is_done = false;
        assert_eq!(peak_of(Path::new("/no/such/folder"), || is_done = true), None);
        assert!(is_done);
    }
}
