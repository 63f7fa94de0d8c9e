//! The memory and CPU time of the process; Linux only.

use std::fs;

/// The peak memory of the process, in KiB.
pub fn peak_kib() -> Result<u64, String> {
    let path = "/proc/self/status";
    let status = fs::read_to_string(path).map_err(|error| format!("{path}: {error}; peak memory is read there"))?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"));
    let value = line.and_then(|line| line.split_whitespace().nth(1)?.parse().ok());
    value.ok_or_else(|| format!("{path}: no line `VmHWM: … kB`"))
}

/// The CPU time of all living threads, in seconds: on a busy machine more reliable than elapsed time.
pub fn cpu_seconds() -> Result<f64, String> {
    let folder = "/proc/self/task";
    let failed = |error: std::io::Error| format!("{folder}: {error}; CPU time is read there");
    let mut nanoseconds = 0_u64;
    for task in fs::read_dir(folder).map_err(failed)? {
        let path = task.map_err(failed)?.path().join("schedstat");
        let text = fs::read_to_string(&path).map_err(failed)?;
        let first = text.split_whitespace().next().and_then(|first| first.parse::<u64>().ok());
        nanoseconds += first.ok_or_else(|| format!("{}: no number of nanoseconds", path.display()))?;
    }
    #[allow(clippy::cast_precision_loss)] // far from 2^53
    Ok(nanoseconds as f64 * 1e-9)
}
