//! A child process of the same program that works for this process and ends with it.

use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use crate::exit::Failure;
use crate::{host, interrupt};

/// The environment variable that marks a process as a worker.
const VARIABLE: &str = "PREDICAMENT_WORKER";

/// Ends this process when its parent ends, if this process is a worker.
pub fn end_with_parent() {
    if std::env::var_os(VARIABLE).is_some() {
        std::thread::spawn(|| {
            let _ = std::io::copy(&mut std::io::stdin(), &mut std::io::sink());
            interrupt::leave();
        });
    }
}

/// The time that a child has to end itself and its engines before it is killed.
pub const FAREWELL: Duration = Duration::from_secs(2);

/// A command that runs this program again.
pub fn command() -> Result<Command, Failure> {
    let own = || std::env::current_exe().map_err(|error| Failure::usage(format!("this program: {error}")));
    let words = match host::again() {
        Some(words) => words,
        None => vec![own()?.into()],
    };
    let [program, arguments @ ..] = words.as_slice() else {
        return Err(Failure::usage("the program around the tool does not say how it is started"));
    };
    let mut command = Command::new(program);
    command.args(arguments);
    command.arg("--quiet");
    Ok(command)
}

/// Starts a child that ends when this process does. The reader of its pipe gets its stderr.
pub fn start(mut command: Command, stdout: Stdio) -> Result<Child, Failure> {
    // The child ends when the other end of this pipe closes, so no child outlives a killed parent.
    command.env(VARIABLE, "1").stdin(Stdio::piped()).stdout(stdout).stderr(Stdio::piped());
    let child = command.spawn().map_err(|error| Failure::usage(format!("a worker did not start: {error}")))?;
    // When memory runs out, Linux kills this child first. Other systems do not have this file.
    let _ = std::fs::write(format!("/proc/{}/oom_score_adj", child.id()), "1000");
    Ok(child)
}

/// The end of a child process.
pub enum End {
    Exit(Option<ExitStatus>),
    Limit(Duration),
    Interrupt,
}

/// Waits for the child to end, and ends it when the time is over.
pub fn wait(child: &mut Child, limit: Option<Duration>) -> End {
    let start = Instant::now();
    loop {
        let end = match child.try_wait() {
            Ok(Some(status)) => return End::Exit(Some(status)),
            Ok(None) if interrupt::flag().load(Ordering::Relaxed) => End::Interrupt,
            Ok(None) => match limit.filter(|limit| start.elapsed() > *limit) {
                Some(limit) => End::Limit(limit),
                None => {
                    std::thread::sleep(Duration::from_millis(2));
                    continue;
                }
            },
            Err(_) => End::Exit(None),
        };
        // The child ends its engines and itself at the end of its input, if it still can.
        drop(child.stdin.take());
        let asked = Instant::now();
        while asked.elapsed() < FAREWELL && matches!(child.try_wait(), Ok(None)) {
            std::thread::sleep(Duration::from_millis(2));
        }
        let _ = child.kill();
        let _ = child.wait();
        return end;
    }
}
