//! Process groups: a started process and all its descendants, which are ended together.
//!
//! The process leads its own group, and the remaining processes of the group are ended with it. On Linux, processes
//! that have left the group are ended too: see [`descendants`]. On other systems they stay.

use std::collections::BTreeMap;
use std::io::Error;
use std::process::{Child, Command};
use std::sync::{Mutex, PoisonError};

#[cfg(target_os = "linux")]
use crate::descendants;
use crate::mark::{MARK, mark};

/// The running groups: their marks by the id of their first process.
static RUNNING: Mutex<BTreeMap<u32, String>> = Mutex::new(BTreeMap::new());

/// Ends all engines of this process and their descendants, for a process that is about to exit without dropping them.
/// An engine that waits for input would end on its own, but an engine in a loop would not.
pub fn end_all() {
    let running = std::mem::take(&mut *RUNNING.lock().unwrap_or_else(PoisonError::into_inner));
    running.iter().for_each(|(&first, mark)| end(first, mark));
}

/// A process and its descendants, ended on drop.
pub struct Group {
    /// The first process of the group.
    pub child: Child,
}

impl Group {
    /// Starts the command as the first process of a group, with `memory` MiB for each process of the group.
    ///
    /// # Errors
    /// An error of the system: the program does not exist, or its memory can't be limited.
    pub fn start(command: &mut Command, memory: Option<u64>) -> Result<Group, Error> {
        let mark = mark();
        command.env(MARK, &mark);
        #[cfg(target_os = "linux")]
        descendants::adopt();
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(command, 0);
        let child = command.spawn()?;
        RUNNING.lock().unwrap_or_else(PoisonError::into_inner).insert(child.id(), mark);
        let group = Group { child };
        #[cfg(target_os = "linux")]
        memory.map_or(Ok(()), |mebibytes| limit(group.child.id(), mebibytes))?;
        #[cfg(not(target_os = "linux"))]
        let _ = memory;
        Ok(group)
    }

    /// Ends the processes that still run. The first process is waited for last: until then its id is not reused.
    pub fn end(&mut self) {
        let Some(mark) = RUNNING.lock().unwrap_or_else(PoisonError::into_inner).remove(&self.child.id()) else {
            return;
        };
        end(self.child.id(), &mark);
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Drop for Group {
    fn drop(&mut self) {
        self.end();
    }
}

/// Ends a group of processes, given by its first process' id, and the processes that have left the group.
fn end(first: u32, mark: &str) {
    // This must come first: after its parent has ended, an orphan no longer descends from the engine.
    #[cfg(target_os = "linux")]
    let known = descendants::of(first);
    #[cfg(unix)]
    if let Some(group) = i32::try_from(first).ok().and_then(rustix::process::Pid::from_raw) {
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
    #[cfg(target_os = "linux")]
    descendants::end(first, mark, known);
    #[cfg(not(target_os = "linux"))]
    let _ = (first, mark);
}

/// Limits the memory that a process, and each process that it starts, may write to.
#[cfg(target_os = "linux")]
fn limit(process: u32, mebibytes: u64) -> Result<(), Error> {
    use rustix::process::{Pid, Resource, Rlimit, getrlimit, prlimit};
    let wanted = mebibytes.saturating_mul(1 << 20);
    // An existing limit may be lower.
    let has = getrlimit(Resource::Data);
    let least = |limit: Option<u64>| Some(limit.map_or(wanted, |limit| limit.min(wanted)));
    let limit = Rlimit { current: least(has.current), maximum: least(has.maximum) };
    match prlimit(i32::try_from(process).ok().and_then(Pid::from_raw), Resource::Data, limit) {
        // The process has already ended, which is detected elsewhere.
        Ok(_) | Err(rustix::io::Errno::SRCH) => Ok(()),
        Err(error) => Err(Error::other(format!("its memory can't be limited: {error}; write `memory = 0`"))),
    }
}
