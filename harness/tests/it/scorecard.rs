//! The scorecard of planted faults, and the page of all checks.

use std::process::Stdio;

use serde_json::Value;
use tempfile::tempdir;

use crate::common::{at, expect, tool};

#[test]
fn the_page_of_checks_is_what_the_tool_prints() {
    let page = expect(0, &["setup", "selftest", "--checks", "--format", "md"]).stdout;
    let kept = include_str!("../../../docs/CHECKS.md");
    assert!(page == kept, "run `cargo xtask pages`:\n{page}");
    let table = expect(0, &["setup", "selftest", "--checks", "--format", "csv"]).stdout;
    let rows = page.lines().filter(|line| line.starts_with("| ")).count() - 2;
    assert_eq!(table.lines().count() - 1, rows, "a row for each check");
    assert!(table.starts_with("check,class,tasks,holds,faults\n"), "{table}");
}

/// Faults in readers need no scene, so this test is fast.
#[test]
fn a_check_that_is_off_turns_the_card_red() {
    let only = ["setup", "selftest", "--only", "readers:swaps-axes,readers:obj-from-zero", "--format", "json"];
    let told = expect(0, &only).stdout;
    let lines: Vec<Value> = told.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let by_name =
        |name: &str| lines.iter().find(|line| line["name"] == name).unwrap_or_else(|| panic!("{name}: {told}"));
    assert_eq!(by_name("readers")["verdict"], "clean");
    let fault = by_name("readers:swaps-axes");
    assert_eq!((&fault["verdict"], &fault["area"], &fault["scenes"]), (&"caught".into(), &"readers".into(), &1.into()));
    assert!(fault["queries"].as_u64() > Some(10), "{fault}");
    for off in ["written points", "readers:written points"] {
        let told = expect(100, &[&only[..], &["--without", off]].concat()).stdout;
        assert!(told.contains("NOT CAUGHT"), "{told}");
    }
    expect(0, &[&only[..], &["--without", "sign_flip/perturbed sign"]].concat());
    let told = expect(2, &[&only[..], &["--without", "no such check"]].concat());
    assert!(told.stderr.contains("no check is called `no such check`"), "{}", told.stderr);
}

#[test]
fn the_card_is_a_table_too() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "card");
    let args = ["setup", "selftest", "-f", "^filters/", "--only", "fault:exact-relative-filter", "--shrink"];
    let told = expect(0, &[&args[..], &["--out", &out]].concat()).stdout;
    assert!(told.contains("points pieces"), "{told}");
    let table = std::fs::read_to_string(format!("{out}/selftest.csv")).unwrap();
    let fault = table.lines().find(|line| line.starts_with("fault:")).unwrap();
    let cells: Vec<&str> = fault.split(',').collect();
    assert_eq!(cells[..4], ["fault:exact-relative-filter", "filters", "caught", "1"], "{table}");
    assert_eq!(cells[5], "3", "three points show it: {table}");
    assert!(std::fs::read_to_string(format!("{out}/checks.csv")).unwrap().contains("grassmann-plucker"));
}

#[test]
fn options_that_would_do_nothing_are_refused() {
    for ask in ["--list", "--checks"] {
        for more in ["--out=zz", "--shrink", "--everything", "--without=sign", "--filter=a"] {
            let told = expect(2, &["setup", "selftest", ask, more]).stderr;
            let option = more.split('=').next().unwrap();
            let is_told = told.contains("cannot be used with") && told.contains(ask) && told.contains(option);
            assert!(is_told, "{told}");
        }
    }
    expect(2, &["setup", "selftest", "--checks", "--only", "readers:swaps-axes"]);
    let told = expect(0, &["setup", "selftest", "--list", "--only", "readers:swaps-axes"]).stdout;
    assert!(told.starts_with("readers:swaps-axes "), "{told}");
}

/// A card of some scenes would report faults as missed that other scenes show.
#[test]
#[cfg(target_os = "linux")]
fn an_interrupted_selftest_says_that_nothing_is_kept() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "card");
    let args =
        ["setup", "selftest", "--only", "fault:exact-flushed", "--everything", "--format", "json", "--out", &out];
    let mut child = tool(&args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    // Until the tool listens, the signal would end it.
    let id = child.id().to_string();
    let listens = || {
        let status = std::fs::read_to_string(format!("/proc/{id}/status")).unwrap_or_default();
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap_or("0").trim();
        u64::from_str_radix(caught, 16).unwrap_or(0) & 2 != 0
    };
    while !listens() && child.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    std::process::Command::new("kill").args(["-INT", &id]).status().unwrap();
    let told = crate::common::told(child.wait_with_output().unwrap());
    assert_eq!((told.code, &*told.stdout), (103, ""), "{}", told.stderr);
    assert!(told.stderr.contains("stopping; unfinished work is lost"), "{}", told.stderr);
    assert!(told.stderr.contains("interrupted: no card"), "{}", told.stderr);
    assert_eq!(std::fs::read_dir(&out).unwrap().count(), 0);
}
