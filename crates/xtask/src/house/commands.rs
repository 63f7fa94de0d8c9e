//! Commands of cargo in pages name packages, benches and examples that exist.

use std::collections::BTreeSet;

use super::links::pages;
use super::{manifests, sources};
use crate::command::root;

/// The names of packages, benches and examples of the workspace, each after the option that names it.
fn targets() -> BTreeSet<(&'static str, String)> {
    let mut known = BTreeSet::new();
    for manifest in manifests() {
        let text = std::fs::read_to_string(&manifest).expect("a manifest");
        let mut section = "";
        for line in text.lines() {
            if line.starts_with('[') {
                section = line;
            } else if let Some(name) = line.strip_prefix("name = \"").and_then(|rest| rest.strip_suffix('"')) {
                let option = if section == "[[bench]]" { "--bench" } else { "-p" };
                known.insert((option, name.to_owned()));
            }
        }
        let examples = Some(manifest.with_file_name("examples")).filter(|folder| folder.is_dir());
        for path in examples.iter().flat_map(|folder| sources(folder)) {
            let of = if path.ends_with("main.rs") { path.parent().expect("a folder") } else { path.as_path() };
            known.insert(("--example", of.file_stem().expect("a name").to_string_lossy().into_owned()));
        }
    }
    known
}

/// The packages, benches and examples that commands of a page name and that are not known.
///
/// Commands about a manifest of another workspace are left out.
fn unknown<'p>(page: &'p str, known: &BTreeSet<(&'static str, String)>) -> Vec<&'p str> {
    let own = page.lines().filter(|line| !line.contains("--manifest-path"));
    let words: Vec<&str> = own.flat_map(|line| line.split([' ', '`'])).filter(|word| !word.is_empty()).collect();
    let commands = words.windows(2).filter(|pair| match pair[0] {
        "-p" => pair[1].starts_with("predicament-"),
        "--bench" | "--example" => true,
        _ => false,
    });
    commands
        .filter(|pair| !known.iter().any(|(option, name)| *option == pair[0] && name == pair[1]))
        .map(|pair| pair[1])
        .collect()
}

#[test]
fn commands_of_pages_name_what_exists() {
    let known = targets();
    assert!(known.len() > 60, "{} targets", known.len());
    let mut wrong = Vec::new();
    for path in pages(&root()).iter().filter(|path| !path.ends_with("HISTORY.md") && *path != "CHANGELOG.md") {
        let page = std::fs::read_to_string(root().join(path)).expect("a page");
        wrong.extend(unknown(&page, &known).into_iter().map(|name| format!("{path}: {name}")));
    }
    assert!(wrong.is_empty(), "commands name what is not there:\n{}", wrong.join("\n"));
}

#[test]
fn a_lost_package_bench_or_example_is_seen() {
    let known = BTreeSet::from([("-p", "predicament-a".to_owned()), ("--bench", "b".to_owned())]);
    let page = "`cargo bench -p predicament-a --bench b` and\ncargo run -p predicament-b --example c --bench d\n-p 80";
    assert_eq!(unknown(page, &known), ["predicament-b", "c", "d"]);
}
