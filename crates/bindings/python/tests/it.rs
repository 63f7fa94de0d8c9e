//! The Python package as cargo builds it: names that have to be the same in several files.
//!
//! These tests do not load the library, which needs an interpreter; they make cargo build it. `cargo xtask test` then
//! runs the tests beside this file, in Python.

use std::collections::BTreeSet;
use std::path::Path;

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|why| panic!("{}: {why}", path.display()))
}

/// The names behind a prefix, up to the next mark.
fn names<'t>(text: &'t str, prefix: &str, end: char) -> BTreeSet<&'t str> {
    text.split(prefix).skip(1).filter_map(|rest| rest.split(end).next()).collect()
}

#[test]
fn the_stubs_have_each_function_of_the_module() {
    let source = read("src/lib.rs");
    let added: BTreeSet<&str> = names(&source, "wrap_pyfunction!(", ',');
    let added: BTreeSet<&str> = added.into_iter().filter_map(|path| path.rsplit("::").next()).collect();
    let stubs = read("python/predicament/_native.pyi");
    assert_eq!(added, names(&stubs, "\ndef ", '('));
    assert!(added.len() > 8);
}

#[test]
fn every_test_file_is_named_as_pytest_looks_for_it() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let files = std::fs::read_dir(folder).expect("the tests").map(|file| file.expect("a file").file_name());
    let files: Vec<String> = files.map(|name| name.to_string_lossy().into_owned()).collect();
    for file in files.iter().filter(|file| file.ends_with(".py")) {
        let has_tests = read(&format!("tests/{file}")).contains("\ndef test_");
        assert_eq!(has_tests, file.starts_with("test_"), "{file}");
    }
    assert!(files.iter().filter(|file| file.starts_with("test_")).count() > 6);
}
