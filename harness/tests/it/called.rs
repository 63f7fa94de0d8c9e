//! The tool inside the process of another program: texts, exit codes, interrupts.

use std::ffi::OsString;
use std::time::Duration;

use predicament::{Called, INCOMPLETE, NOTHING_SELECTED, OK, UNEXPECTED, USAGE, cli};

fn call(words: &[&str]) -> Called {
    cli().call(["predicament"].iter().chain(words).map(OsString::from))
}

#[test]
fn a_call_returns_its_texts_and_its_code() {
    let asked = call(&["ask", "orient2d", "0.5,0x1.0000000000001p-1", "12,12", "24,24", "-b", "exact,naive"]);
    assert!(asked.code == UNEXPECTED && asked.out.contains("overreach"), "{asked:?}");
    assert!(asked.told.starts_with("predicament: ") && asked.told.ends_with("exit code 100\n"), "{asked:?}");
    let quiet = call(&["-q", "ask", "orient2d", "0,0", "1,0", "0,1", "-b", "exact"]);
    assert_eq!((quiet.code, quiet.told.as_str()), (OK, ""));
    let again = call(&["ask", "orient2d", "0.5,0x1.0000000000001p-1", "12,12", "24,24", "-b", "exact,naive"]);
    assert_eq!(again, asked, "--quiet ends with its call");
}

#[test]
fn what_ends_a_program_returns_from_a_call() {
    for (words, code) in [
        (&["--help"][..], OK),
        (&["--version"], OK),
        (&[], USAGE),
        (&["run", "--no-such-option"], USAGE),
        (&["run", "no-such-suite"], USAGE),
        (&["run", ""], USAGE),
        (&["run", "filters", "-f", "^nothing$"], NOTHING_SELECTED),
    ] {
        let called = call(words);
        assert_eq!(called.code, code, "{words:?}");
        assert_eq!(called.told.is_empty(), code == OK, "{called:?}");
    }
    assert!(call(&["--help"]).out.contains("Exit codes"));
}

#[test]
fn an_interrupt_stops_a_call_and_not_the_next_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = folder.path().join("run").display().to_string();
    let words = ["run", "-b", "exact", "--out", &run];
    let stopped = std::thread::scope(|scope| {
        let calling = scope.spawn(|| call(&words));
        let summary = folder.path().join("run").join("summary.csv");
        while !calling.is_finished() {
            if summary.exists() {
                predicament::interrupt();
            }
            std::thread::sleep(Duration::from_millis(2));
        }
        calling.join().expect("the call does not panic")
    });
    assert_eq!(stopped.code, INCOMPLETE, "{stopped:?}");
    predicament::interrupt();
    assert_eq!(call(&["run", "filters", "-b", "exact", "--out", &format!("{run}-2")]).code, OK);
}
