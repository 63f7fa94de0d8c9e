//! Rules of the house that no compiler holds, as tests.

use std::path::{Path, PathBuf};

/// The manifests of all crates.
fn manifests() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let crates = std::fs::read_dir(root.join("crates")).expect("the crates");
    let mut all: Vec<PathBuf> = crates.map(|entry| entry.expect("a crate").path().join("Cargo.toml")).collect();
    all.push(root.join("harness/Cargo.toml"));
    all.sort();
    all
}

/// Sections that name `rug` without `gmp-mpfr-sys`.
fn without_feature(manifest: &str) -> Vec<&str> {
    let names = |section: &str, name: &str| {
        section.lines().any(|line| line.strip_prefix(name).is_some_and(|rest| rest.starts_with(['.', ' ', '='])))
    };
    let sections = manifest.split("\n[").filter(|section| names(section, "rug") && !names(section, "gmp-mpfr-sys"));
    sections.map(|section| section.lines().next().unwrap_or_default().trim_end_matches(']')).collect()
}

/// GMP is built once for each set of its features. A crate that names only `rug` makes a second one, with GMP's own
/// tests, as soon as it is built by itself: five minutes.
#[test]
fn whoever_names_rug_names_the_feature_of_gmp() {
    let manifests = manifests();
    assert!(manifests.len() > 10, "{manifests:?}");
    for path in manifests {
        let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert_eq!(without_feature(&text), [""; 0], "add gmp-mpfr-sys beside rug in {}", path.display());
    }
}

#[test]
fn a_crate_without_the_feature_is_seen() {
    let manifest = "[dependencies]\nrug.workspace = true\ngmp-mpfr-sys.workspace = true\n\n[dev-dependencies]\n\
                    rug = \"1\"\nruggedness = \"1\"\n";
    assert_eq!(without_feature(manifest), ["dev-dependencies"]);
    assert_eq!(without_feature("[dependencies]\nruggedness = \"1\"\n"), [""; 0]);
}
