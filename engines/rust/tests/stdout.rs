//! Stdout carries only the protocol, even if a library prints.

use std::io::Write;
use std::process::{Command, Output, Stdio};

/// A message of the protocol.
fn message(entries: &[(&str, &[u8])]) -> Vec<u8> {
    let length = |bytes: &[u8]| u32::try_from(bytes.len()).unwrap().to_le_bytes();
    let entry = |(key, value): &(&str, &[u8])| {
        [&[u8::try_from(key.len()).unwrap()], key.as_bytes(), &length(value), value].concat()
    };
    let body: Vec<u8> = entries.iter().flat_map(entry).collect();
    [&length(&body), body.as_slice()].concat()
}

/// The output of the engine for this input.
fn loud(args: &[&str], input: &[u8]) -> Output {
    let program = Command::new(env!("CARGO_BIN_EXE_loud"))
        .args(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn();
    let mut program = program.unwrap();
    program.stdin.take().unwrap().write_all(input).unwrap();
    program.wait_with_output().unwrap()
}

#[test]
#[cfg(unix)]
fn what_a_library_prints_goes_to_stderr() {
    let points: Vec<u8> = [0.0_f64, 0.0, 1.0, 5.0].iter().flat_map(|x| x.to_le_bytes()).collect();
    let scene = message(&[("type", b"scene"), ("dimension", b"2"), ("points", &points)]);
    let ids = [1, 0, 0, 0, 0, 0, 0, 0];
    let batch = message(&[("type", b"batch"), ("predicate", b"compare"), ("axis", b"x"), ("ids", &ids)]);
    let said = loud(&[], &[scene, batch].concat());
    assert!(said.status.success());
    assert_eq!(String::from_utf8_lossy(&said.stderr), "a library that says 1 and 0\n");
    let printed = b"a library";
    assert!(said.stdout.windows(printed.len()).all(|bytes| bytes != printed));
    let sign = [&b"\x05signs"[..], &1_u32.to_le_bytes(), &[1]].concat();
    assert!(said.stdout.ends_with(&sign), "{:?}", said.stdout);
}

#[test]
#[cfg(unix)]
fn a_panic_of_a_library_is_told_to_the_tool_alone() {
    let scene = message(&[("type", b"scene"), ("dimension", b"2"), ("points", &[0; 16])]);
    let batch = message(&[("type", b"batch"), ("predicate", b"compare"), ("axis", b"x"), ("ids", &[0; 8])]);
    let said = loud(&[], &[scene, batch].concat());
    assert!(said.status.success());
    assert_eq!(String::from_utf8_lossy(&said.stderr), "a library that says 0 and 0\n");
    assert!(String::from_utf8_lossy(&said.stdout).contains("compare(0 0) panicked: assertion"));
}

#[test]
fn the_version_is_one_line_and_other_input_is_refused() {
    let said = loud(&["--version"], b"");
    assert_eq!((said.status.code(), &said.stdout[..]), (Some(0), &b"1.0\n"[..]));
    let said = loud(&["--help"], b"");
    assert_eq!((said.status.code(), said.stdout.is_empty()), (Some(2), true));
    let said = loud(&[], b"GET / HTTP/1.1");
    let error = String::from_utf8_lossy(&said.stderr).into_owned();
    assert_eq!((said.status.code(), error.trim_end()), (Some(2), "engine: stdin ends within a message"));
}
