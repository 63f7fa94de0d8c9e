//! The command line tool inside this process.

use std::ffi::OsString;

use predicament::{Host, cli};
use pyo3::prelude::*;

use crate::waiting::interruptible;

/// The program around the tool: this interpreter with the package.
fn host(py: Python<'_>) -> PyResult<Host> {
    let python: OsString = py.import("sys")?.getattr("executable")?.extract()?;
    let again = if python.is_empty() { Vec::new() } else { vec![python, "-m".into(), "predicament".into()] };
    Ok(Host { name: "predicament".to_owned(), again })
}

fn words(args: Vec<OsString>) -> impl Iterator<Item = OsString> + Send {
    std::iter::once(OsString::from("predicament")).chain(args)
}

/// Runs a command; returns its exit code, and what it would write to stdout and to stderr.
///
/// Ctrl-C stops the command as it stops the tool: finished work is kept.
#[pyfunction]
pub fn call(py: Python<'_>, args: Vec<OsString>) -> PyResult<(u8, String, String)> {
    let host = host(py)?;
    let called = interruptible(py, predicament::interrupt, || cli().hosted(host).call(words(args)))?;
    Ok((called.code, called.out, called.told))
}

/// The main function of the program `predicament`: runs a command, and returns the exit code.
///
/// The process is the tool's: it writes to stdout and stderr, and takes Ctrl-C.
#[pyfunction]
pub fn main(py: Python<'_>, args: Vec<OsString>) -> PyResult<u8> {
    let host = host(py)?;
    Ok(py.detach(|| cli().hosted(host).main_with(words(args))))
}
