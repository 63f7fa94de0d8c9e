//! Ctrl-C: asks the work to stop at the next chunk, so that what is done is
//! kept and the run says that it is incomplete. A second Ctrl-C kills.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

static STOP: AtomicBool = AtomicBool::new(false);

/// Starts listening. Called once, by commands whose work is worth keeping.
pub fn listen() {
    listen_and_say("what is done is kept");
}

/// The same, by commands whose work is worth nothing before its end.
pub fn listen_for_all() {
    listen_and_say("nothing is kept of what is not finished");
}

fn listen_and_say(kept: &'static str) {
    let installed = ctrlc::set_handler(move || {
        if STOP.swap(true, Ordering::SeqCst) {
            leave();
        }
        tell!("\n{}: stopping; {kept} (again to stop at once)", crate::out::program());
    });
    if let Err(error) = installed {
        tell!("{}: Ctrl-C will not be caught: {error}", crate::out::program());
    }
}

/// The same, for work that may be in the middle of something long that looks at no flag: after a while the process
/// ends as it is. What was committed to a run folder stays.
pub fn listen_for(grace: Duration) {
    listen();
    std::thread::spawn(move || {
        while !STOP.load(Ordering::SeqCst) {
            std::thread::sleep(Duration::from_millis(50));
        }
        std::thread::sleep(grace);
        tell!("{}: stopped in the middle of a scene; the scenes before it are kept", crate::out::program());
        leave();
    });
}

/// Ends this process in the middle of its work, and the engines that it has started.
pub fn leave() -> ! {
    predicament_engines::end_all();
    std::process::exit(i32::from(crate::exit::INCOMPLETE))
}

/// A limit of a file's size (`ulimit -f`) becomes an error of the file that reaches it, which is told, instead of the end of the process.
#[cfg(unix)]
pub fn outlive_limits() {
    let flag = std::sync::Arc::new(AtomicBool::new(false));
    if let Err(error) = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, flag) {
        tell!("{}: a limit of a file's size will end it: {error}", crate::out::program());
    }
}

/// There are no such limits.
#[cfg(not(unix))]
pub fn outlive_limits() {}

/// The flag that the work looks at.
pub fn flag() -> &'static AtomicBool {
    &STOP
}
