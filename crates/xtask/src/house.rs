//! House rules that the compiler does not check, as tests.

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

/// The blocks of Rust of a page.
fn rust_blocks(page: &str) -> Vec<&str> {
    let blocks = page.split("```rust\n").skip(1);
    blocks.map(|rest| rest.split("\n```").next().unwrap_or_default()).collect()
}

/// The blocks of a page that are in none of these files.
fn unknown<'p>(page: &'p str, files: &[String]) -> Vec<&'p str> {
    rust_blocks(page).into_iter().filter(|block| !files.iter().any(|file| file.contains(block))).collect()
}

#[test]
fn the_page_about_tasks_shows_the_example_as_it_is() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |path: &Path| std::fs::read_to_string(path).unwrap_or_else(|why| panic!("{}: {why}", path.display()));
    let sources = std::fs::read_dir(root.join("examples/leftmost/src")).expect("the example");
    let sources: Vec<String> = sources.map(|entry| read(&entry.expect("a file").path())).collect();
    let page = read(&root.join("docs/TASKS.md"));
    assert!(rust_blocks(&page).len() >= 8, "the page shows code");
    assert_eq!(unknown(&page, &sources), [""; 0], "copy these from examples/leftmost/src");
}

#[test]
fn a_block_that_is_in_no_file_is_seen() {
    let page = "One:\n```rust\nfn a() {}\n```\nand\n```rust\nfn b() {}\n```\n";
    assert_eq!(unknown(page, &["fn a() {}\n".to_owned()]), ["fn b() {}"]);
}

#[test]
fn a_crate_without_the_feature_is_seen() {
    let manifest = "[dependencies]\nrug.workspace = true\ngmp-mpfr-sys.workspace = true\n\n[dev-dependencies]\n\
                    rug = \"1\"\nruggedness = \"1\"\n";
    assert_eq!(without_feature(manifest), ["dev-dependencies"]);
    assert_eq!(without_feature("[dependencies]\nruggedness = \"1\"\n"), [""; 0]);
}
