//! Ctrl-C asks the work to stop at the next chunk; finished work is kept and the run is marked as incomplete. A second
//! Ctrl-C kills. A program that calls the tool in its own process keeps its Ctrl-C ([`host`]).

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::host;

static STOP: AtomicBool = AtomicBool::new(false);

/// Starts to listen for Ctrl-C. Commands whose partial work is worth keeping call this once.
pub fn listen() {
    listen_and_say("finished work is kept");
}

/// Starts to listen for Ctrl-C, for commands whose partial work is worth nothing.
pub fn listen_for_all() {
    listen_and_say("unfinished work is lost");
}

fn listen_and_say(kept: &'static str) {
    if host::is_called() {
        return;
    }
    let installed = ctrlc::set_handler(move || {
        if STOP.swap(true, Ordering::SeqCst) {
            leave();
        }
        tell!("\n{}: stopping; {kept} (again to stop at once)", crate::out::program());
    });
    if let Err(error) = installed {
        tell!("{}: Ctrl-C cannot be caught: {error}", crate::out::program());
    }
}

/// Starts to listen for Ctrl-C, for work that may not check the flag for a long time. After `grace` the process ends;
/// what was committed to a run folder stays.
pub fn listen_for(grace: Duration) {
    listen();
    if host::is_called() {
        return;
    }
    std::thread::spawn(move || {
        while !STOP.load(Ordering::SeqCst) {
            std::thread::sleep(Duration::from_millis(50));
        }
        std::thread::sleep(grace);
        tell!("{}: stopped in the middle of a scene; finished scenes are kept", crate::out::program());
        leave();
    });
}

/// Ctrl-C ends the process at once: for commands whose complete files stay and whose other work is worth nothing.
pub fn leave_at_once() {
    if host::is_called() {
        return;
    }
    let installed = ctrlc::set_handler(|| {
        tell!("\n{}: stopped; complete files are kept", crate::out::program());
        leave();
    });
    if let Err(error) = installed {
        tell!("{}: Ctrl-C cannot be caught: {error}", crate::out::program());
    }
}

/// Ends this process in the middle of its work, with the engines that it has started and without unfinished files.
pub fn leave() -> ! {
    predicament_records::abandon_files();
    predicament_engines::end_all();
    std::process::exit(i32::from(crate::exit::INCOMPLETE))
}

/// A limit of a file's size (`ulimit -f`) becomes an error of the file that reaches it, instead of the end of the
/// process.
#[cfg(unix)]
pub fn outlive_limits() {
    let flag = std::sync::Arc::new(AtomicBool::new(false));
    if let Err(error) = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, flag) {
        tell!("{}: a file size limit will end the process: {error}", crate::out::program());
    }
}

/// Does nothing: this system has no such limits.
#[cfg(not(unix))]
pub fn outlive_limits() {}

/// The flag that asks the work to stop.
pub fn flag() -> &'static AtomicBool {
    &STOP
}
