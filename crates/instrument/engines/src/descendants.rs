//! Processes that an engine has started and that have left its group, on Linux.
//!
//! Ending the group of the engine does not end a process in its own session. If the parent of such a process ends, the
//! system reparents it to the first process of the machine, where its origin is lost. So this process becomes the
//! parent of its engines' orphans and ends them with the engine. It ends processes that descend from the engine when
//! the engine is ended, and processes with the engine's mark in their environment. Both must be descendants of this
//! process.
//!
//! A process escapes if it has a new environment and its parents ended before the engine did.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Once;
use std::time::Duration;

use rustix::process::{
    Pid, PidfdFlags, Signal, WaitOptions, getpid, pidfd_open, pidfd_send_signal, set_child_subreaper, waitpid,
};

use crate::mark::MARK;

/// The maximum number of rounds of ending: a process may start another one while it is being ended.
const ROUNDS: usize = 50;
/// The pause after each round of ending.
const MOMENT: Duration = Duration::from_millis(2);

/// A process id with its start time, since ids are reused.
type Identity = (u32, u64);

/// The state of a process, as the system reports it.
struct Seen {
    parent: u32,
    group: u32,
    start: u64,
    has_ended: bool,
}

/// Makes this process the parent of its descendants' orphans.
pub fn adopt() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let _ = set_child_subreaper(Some(getpid()));
    });
}

/// The current descendants of a process.
pub fn of(process: u32) -> BTreeSet<Identity> {
    let all = processes();
    below(&all, [process].into()).into_iter().filter_map(|at| Some((at, all.get(&at)?.start))).collect()
}

/// Ends the processes of an engine: known processes, those of its group and those with its mark.
pub fn end(engine: u32, mark: &str, mut known: BTreeSet<Identity>) {
    let mark = format!("{MARK}={mark}").into_bytes();
    for _ in 0..ROUNDS {
        let all = processes();
        let is_its_own = |at: u32, seen: &Seen| {
            known.contains(&(at, seen.start)) || seen.group == engine || (!seen.has_ended && has_mark(at, &mark))
        };
        let here = below(&all, [std::process::id()].into());
        let own: BTreeSet<u32> = here.into_iter().filter(|at| *at != engine && is_its_own(*at, &all[at])).collect();
        let own: BTreeSet<u32> = below(&all, own.clone()).into_iter().chain(own).collect();
        if own.is_empty() {
            return;
        }
        for at in own {
            let seen = &all[&at];
            known.insert((at, seen.start));
            if !seen.has_ended {
                kill(at, seen.start);
            } else if let Some(pid) = pid(at).filter(|_| seen.parent == std::process::id()) {
                // It is a child of this process, and no other code waits for its status.
                let _ = waitpid(Some(pid), WaitOptions::NOHANG);
            }
        }
        std::thread::sleep(MOMENT);
    }
}

/// Ends the process with this id and start time, and no other process.
fn kill(process: u32, start: u64) {
    let Some(pid) = pid(process) else { return };
    if let Ok(handle) = pidfd_open(pid, PidfdFlags::empty())
        && seen(process).is_some_and(|seen| seen.start == start)
    {
        let _ = pidfd_send_signal(handle, Signal::KILL);
    }
}

fn pid(process: u32) -> Option<Pid> {
    i32::try_from(process).ok().and_then(Pid::from_raw)
}

/// All processes that the system reports, by id.
fn processes() -> BTreeMap<u32, Seen> {
    let entries = std::fs::read_dir("/proc").into_iter().flatten().flatten();
    let numbers = entries.filter_map(|entry| entry.file_name().to_str()?.parse().ok());
    numbers.filter_map(|number| Some((number, seen(number)?))).collect()
}

fn seen(process: u32) -> Option<Seen> {
    let stat = std::fs::read(format!("/proc/{process}/stat")).ok()?;
    parse(&String::from_utf8_lossy(&stat))
}

/// Parses a line of `/proc/N/stat`. The second field is a name in parentheses, which may contain any bytes.
fn parse(stat: &str) -> Option<Seen> {
    let fields: Vec<&str> = stat[stat.rfind(')')? + 1..].split_ascii_whitespace().collect();
    let has_ended = matches!(*fields.first()?, "Z" | "X" | "x");
    let (parent, group) = (fields.get(1)?.parse().ok()?, fields.get(2)?.parse().ok()?);
    Some(Seen { parent, group, start: fields.get(19)?.parse().ok()?, has_ended })
}

/// True if the initial environment of a process has the mark.
fn has_mark(process: u32, mark: &[u8]) -> bool {
    let environment = std::fs::read(format!("/proc/{process}/environ")).unwrap_or_default();
    environment.split(|&byte| byte == 0).any(|variable| variable == mark)
}

/// The descendants of these processes, without the processes themselves.
fn below(all: &BTreeMap<u32, Seen>, roots: BTreeSet<u32>) -> BTreeSet<u32> {
    let mut children: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    all.iter().for_each(|(&at, seen)| children.entry(seen.parent).or_default().push(at));
    let (mut found, mut next) = (BTreeSet::new(), Vec::from_iter(roots));
    while let Some(parent) = next.pop() {
        next.extend(children.get(&parent).into_iter().flatten().filter(|&&child| found.insert(child)));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_process_is_read_by_the_last_parenthesis_of_its_line() {
        let line = "7 (a) Z 1 (b)) S 3 4 5 0 -1 4194304 1 2 3 4 5 6 7 8 20 0 1 0 991 10 11";
        let seen = parse(line).unwrap();
        assert_eq!((seen.parent, seen.group, seen.start, seen.has_ended), (3, 4, 991, false));
        assert!(parse(&line.replace(" S ", " Z ")).unwrap().has_ended);
        assert!(parse("7 (a) S 3").is_none() && parse("").is_none());
    }

    #[test]
    fn descendants_are_those_of_any_depth_without_their_root() {
        let process = |parent| Seen { parent, group: 0, start: 0, has_ended: false };
        let all = BTreeMap::from([(1, 0), (2, 1), (3, 2), (4, 3), (5, 1), (6, 5)].map(|(at, up)| (at, process(up))));
        assert_eq!(below(&all, [2].into()), [3, 4].into());
        assert_eq!(below(&all, [3, 5].into()), [4, 6].into());
        assert_eq!(below(&all, [1].into()), [2, 3, 4, 5, 6].into());
        assert!(below(&all, [9].into()).is_empty());
    }
}
