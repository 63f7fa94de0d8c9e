//! Long work on another thread, while this one listens for Ctrl-C.

use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// The time between two looks at pending signals.
const LOOK: Duration = Duration::from_millis(5);
/// The memory for the stack of the work: what a main thread has.
const STACK: usize = 8 << 20;

/// Does work without the lock of the interpreter. If a signal raises an exception, `cancel` asks the work to stop, and
/// the exception is raised when it has.
pub fn interruptible<T: Send>(
    py: Python<'_>,
    cancel: impl Fn() + Send + Sync,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    py.detach(|| {
        std::thread::scope(|scope| {
            let worker = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work)?;
            let mut raised = None;
            while !worker.is_finished() {
                std::thread::sleep(LOOK);
                if raised.is_none() {
                    raised = Python::attach(|py| py.check_signals()).err();
                    raised.iter().for_each(|_| cancel());
                }
            }
            let done = worker.join().map_err(|_| PyRuntimeError::new_err("the work has panicked"));
            raised.map_or(done, Err)
        })
    })
}
