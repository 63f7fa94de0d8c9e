//! A process that was started, with all that it starts in turn: they end together.
//!
//! The process is the first of a group of its own, and what is left of the group is
//! ended with it. On Linux, processes that have left the group are ended, too: see
//! [`descendants`]. Elsewhere they stay.

use std::collections::BTreeMap;
use std::io::Error;
use std::process::{Child, Command};
use std::sync::{Mutex, PoisonError};

#[cfg(target_os = "linux")]
use crate::descendants;
use crate::mark::{MARK, mark};

/// The groups that are running: their marks by the number of their first process.
static RUNNING: Mutex<BTreeMap<u32, String>> = Mutex::new(BTreeMap::new());

/// Ends all engines of this process and what they have started, for a process that is about to exit without
/// dropping them. An engine that waits for input would end by itself; one that loops would not.
pub fn end_all() {
    let running = std::mem::take(&mut *RUNNING.lock().unwrap_or_else(PoisonError::into_inner));
    running.iter().for_each(|(&first, mark)| end(first, mark));
}

/// A process and what it starts; ended when it is dropped.
pub(crate) struct Group {
    pub child: Child,
}

impl Group {
    /// Starts the command as the first process of a group, each process of which may have so many MiB of memory.
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

    /// Ends what still runs. The first process is waited for last: until then nobody else has its number.
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

/// Ends a group of processes, by the number of its first, and what has left the group.
fn end(first: u32, mark: &str) {
    // Before anything is ended: an orphan descends from the engine no more.
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

/// Limits the memory that a process may write to, and each process that it starts.
#[cfg(target_os = "linux")]
fn limit(process: u32, mebibytes: u64) -> Result<(), Error> {
    use rustix::process::{Pid, Resource, Rlimit, getrlimit, prlimit};
    let wanted = mebibytes.saturating_mul(1 << 20);
    // A limit that holds already may be lower.
    let has = getrlimit(Resource::Data);
    let least = |limit: Option<u64>| Some(limit.map_or(wanted, |limit| limit.min(wanted)));
    let limit = Rlimit { current: least(has.current), maximum: least(has.maximum) };
    match prlimit(i32::try_from(process).ok().and_then(Pid::from_raw), Resource::Data, limit) {
        // It has ended already, which shows elsewhere.
        Ok(_) | Err(rustix::io::Errno::SRCH) => Ok(()),
        Err(error) => Err(Error::other(format!("its memory can't be limited: {error}; write `memory = 0`"))),
    }
}
