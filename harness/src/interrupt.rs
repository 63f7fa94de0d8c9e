//! Ctrl-C: asks the work to stop at the next chunk, so that what is done is
//! kept and the run says that it is incomplete. A second Ctrl-C kills.

use std::sync::atomic::{AtomicBool, Ordering};

static STOP: AtomicBool = AtomicBool::new(false);

/// Starts listening. Called once, by commands whose work is worth keeping.
pub fn listen() {
    let installed = ctrlc::set_handler(|| {
        if STOP.swap(true, Ordering::SeqCst) {
            std::process::exit(i32::from(crate::exit::INCOMPLETE));
        }
        eprintln!("\n{}: stopping; what is done is kept (again to stop at once)", crate::out::program());
    });
    if let Err(error) = installed {
        eprintln!("{}: Ctrl-C will not be caught: {error}", crate::out::program());
    }
}

/// The flag that the work looks at.
pub fn flag() -> &'static AtomicBool {
    &STOP
}
