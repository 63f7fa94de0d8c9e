//! A process of the same program that works for this one, and ends with it.

use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use crate::exit::Failure;
use crate::interrupt;

/// The variable that tells a process that it is a worker.
const VARIABLE: &str = "PREDICAMENT_WORKER";

/// Where this process is a worker, it ends with the process that it works for.
pub fn end_with_parent() {
    if std::env::var_os(VARIABLE).is_some() {
        std::thread::spawn(|| {
            let _ = std::io::copy(&mut std::io::stdin(), &mut std::io::sink());
            interrupt::leave();
        });
    }
}

/// How long a child may take to end, and to end its engines, before it is killed.
pub const FAREWELL: Duration = Duration::from_secs(2);

/// This program again, not yet started.
pub fn command() -> Result<Command, Failure> {
    let program = std::env::current_exe().map_err(|error| Failure::usage(format!("this program: {error}")))?;
    let mut command = Command::new(program);
    command.arg("--quiet");
    Ok(command)
}

/// Starts a child that ends when this process does. What it says on stderr is for whoever reads its pipe.
pub fn start(mut command: Command) -> Result<Child, Failure> {
    // It ends with the other end of this pipe: nothing is left behind when this process is killed.
    command.env(VARIABLE, "1").stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
    let child = command.spawn().map_err(|error| Failure::usage(format!("a worker did not start: {error}")))?;
    // Where memory runs out, Linux ends this process first. Elsewhere there is no such file.
    let _ = std::fs::write(format!("/proc/{}/oom_score_adj", child.id()), "1000");
    Ok(child)
}

/// How a child came to its end.
pub enum End {
    Exit(Option<ExitStatus>),
    Limit(Duration),
    Interrupt,
}

/// Waits for the end, and makes one where the time is over.
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
        // At the end of its input it ends its engines and itself, if it still can.
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
