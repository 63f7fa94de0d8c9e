//! The truth must be found without the algorithm: the allowed imports of `truth`, `checks` and `answer` of the systems.
//!
//! Allowed are the judge, the vocabulary, a scene's content, and the same folders of other systems; no algorithm, no
//! backend, no broad phase of algorithms. The check reads imports as written, and each path in braces separately.

use std::path::Path;

use super::sources;

/// The folders, or files, of a system to which the rule applies.
const HELD: [&str; 3] = ["truth", "checks", "answer"];

/// The vocabulary crates, and the judge.
const ALLOWED: [&str; 3] = ["predicament_judge", "predicament_predicates", "predicament_mesh"];

/// The types that stop a slow truth.
const STOPPING: [&str; 2] = ["predicament_tasks::Stop", "predicament_tasks::Watch"];

/// Files that may import more: the start of their path, the crates, and the reason.
const EXCEPTIONS: [(&str, &[&str], &str); 1] = [(
    "contacts/src/checks/audit",
    &["predicament_arithmetic", "predicament_error_calculus", "predicament_laws"],
    "the published bounds that tolerances are held to are enclosures in rationals, which the error calculus derives",
)];

/// The code without comments, up to the tests in the file.
pub(super) fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

/// The words of code, and the separators within paths.
fn tokens(code: &str) -> Vec<&str> {
    let mut all = Vec::new();
    let mut rest = code.trim_start();
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let end = match first {
            c if is_word(c) => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
            ':' if rest.starts_with("::") => 2,
            c => c.len_utf8(),
        };
        let (token, left) = rest.split_at(end);
        all.push(token);
        rest = left.trim_start();
    }
    all
}

fn is_word(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// All words and paths; a path with braces is split into its paths.
pub(super) fn paths(code: &str) -> Vec<String> {
    let tokens = tokens(code);
    let (mut all, mut at) = (Vec::new(), 0);
    while at < tokens.len() {
        at = if is_word(tokens[at]) { path(&tokens, at, "", &mut all) } else { at + 1 };
    }
    all
}

/// Reads the path that begins at an index; returns the index of its end.
fn path(tokens: &[&str], mut at: usize, before: &str, all: &mut Vec<String>) -> usize {
    let mut path = format!("{before}{}", tokens[at]);
    at += 1;
    while tokens.get(at) == Some(&"::") {
        match tokens.get(at + 1) {
            Some(&"{") => {
                at += 2;
                while at < tokens.len() && tokens[at] != "}" {
                    let before = format!("{path}::");
                    at = if is_word(tokens[at]) { self::path(tokens, at, &before, all) } else { at + 1 };
                }
                return at + 1;
            }
            Some(next) if is_word(next) => path = format!("{path}::{next}"),
            Some(&"*") => path = format!("{path}::*"),
            _ => break,
        }
        at += 2;
    }
    all.push(path);
    at
}

/// Returns true if a truth must not name this path; `more` are crates that it may name as an exception.
fn is_refused(path: &str, more: &[&str]) -> bool {
    let words: Vec<&str> = path.split("::").collect();
    let is_of = |crates: &[&str]| crates.contains(&words[0]);
    let is_held = |word: Option<&&str>| word.is_some_and(|word| HELD.contains(word));
    let of_algorithm = words.len() > 1 && words.contains(&"algorithm");
    let of_task = words.len() > 1 && words.contains(&"task") && !path.starts_with("crate::task::content::");
    let of_a_crate = words[0].starts_with("predicament_")
        && !is_of(&ALLOWED)
        && !is_of(more)
        && !STOPPING.contains(&path)
        && !is_held(words.get(1));
    of_algorithm || of_task || of_a_crate
}

/// The forbidden paths that a file names.
fn refused(text: &str, more: &[&str]) -> Vec<String> {
    paths(&code(text)).into_iter().filter(|path| is_refused(path, more)).collect()
}

/// Returns true if the rule applies to a file of a system, by its path in the system's folder; tests may import
/// anything.
fn is_held(path: &Path) -> bool {
    let mut words = path.iter().skip(1).filter_map(|word| word.to_str());
    let is_test = path.file_stem().is_some_and(|name| name == "tests");
    words.next() == Some("src")
        && words.next().is_some_and(|word| HELD.contains(&word.trim_end_matches(".rs")))
        && !is_test
}

#[test]
fn no_truth_imports_an_algorithm() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../systems");
    let (mut seen, mut needed) = (0, 0);
    let mut systems = std::collections::BTreeSet::new();
    for file in sources(&root) {
        let path = file.strip_prefix(&root).expect("a file of the systems");
        if !is_held(path) {
            continue;
        }
        let exception = EXCEPTIONS.iter().find(|(start, _, why)| path.starts_with(start) && !why.is_empty());
        let more = exception.map_or(&[][..], |(_, crates, _)| *crates);
        let text = std::fs::read_to_string(&file).expect("a file");
        assert_eq!(refused(&text, more), [""; 0], "{} is to be true without these", path.display());
        needed += usize::from(!refused(&text, &[]).is_empty());
        seen += 1;
        systems.extend(path.iter().next().map(ToOwned::to_owned));
    }
    assert!(seen > 50 && needed > 0, "{seen} files, {needed} of them exceptions");
    for folder in super::systems() {
        let has = |name: &str| folder.join("src").join(name).exists();
        assert!(has("algorithm"), "{} has no folder `src/algorithm`", folder.display());
        assert!(has("truth.rs") || has("truth/mod.rs"), "{} says nowhere what is true", folder.display());
        assert!(systems.contains(folder.file_name().expect("a name")), "no file of {} was looked at", folder.display());
    }
}

#[test]
fn what_a_truth_may_not_import_is_seen() {
    let refused = |text: &str| refused(text, &[]);
    let rights = "use crate::answer::Place;\nuse crate::task::content::{Cells};\nuse predicament_judge::{Judged, hull};\n\
                  use predicament_tasks::{Stop, Watch};\nuse predicament_slice::checks::Part;\n// crate::algorithm::place\n\
                  fn f() { rug::Integer::from(1) }\n#[cfg(test)]\nmod tests { use predicament_exact::Exact; }\n";
    assert_eq!(refused(rights), [""; 0]);
    for (wrong, named) in [
        ("use crate::algorithm::Place;", "crate::algorithm::Place"),
        ("pub use crate::{answer::Place, algorithm::{place, self}};", "crate::algorithm::place"),
        ("fn f() { super::super::algorithm::place() }", "super::super::algorithm::place"),
        ("use predicament_hull::algorithm::Hull;", "predicament_hull::algorithm::Hull"),
        ("use predicament_exact::Exact;", "predicament_exact::Exact"),
        ("use predicament_sos as sos;", "predicament_sos"),
        ("let index = predicament_grid::BoxIndex::<2>::new(boxes);", "predicament_grid::BoxIndex"),
        ("use predicament_tasks::{Outcome, Stop};", "predicament_tasks::Outcome"),
        ("use crate::task::judge::judge;", "crate::task::judge::judge"),
    ] {
        assert_eq!(refused(wrong).first().map(String::as_str), Some(named));
    }
    let audit = "use predicament_laws::published::Symbol;";
    assert_eq!(super::truth::refused(audit, EXCEPTIONS[0].1), [""; 0]);
    assert_eq!(refused(audit), ["predicament_laws::published::Symbol"]);
    let held = |path: &str| is_held(Path::new(path));
    assert!(held("hull/src/truth.rs") && held("hull/src/checks/flaws.rs") && held("hull/src/answer.rs"));
    assert!(
        !held("hull/src/task/checks.rs") && !held("hull/src/checks/flaws/tests.rs") && !held("hull/tests/it/truth.rs")
    );
}
