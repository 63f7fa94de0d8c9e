//! Truth and judged code meet in the vocabulary only: what is reachable from both, by crates and by modules.
//!
//! The rule about imports ([`truth`](super::truth)) reads the files of truths. This one follows imports, from file to
//! file within a system, and from crate to crate.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use super::truth::{code, paths};
use super::{dependencies, manifests, sources, systems};

/// The crates that compute what is true.
const TRUTHS: [&str; 2] = ["judge", "conformance"];
/// The crates that are judged: backends, and what algorithms are made of.
const JUDGED: [&str; 6] = ["exact", "sos", "tolerance", "lanes", "grid", "controls"];
/// The crates that both may reach: questions and answers, the type of a sign, formulas as text.
const VOCABULARY: [&str; 3] = ["predicates", "arithmetic", "formula"];
/// The crates that a truth of a system reaches beside the judge: connectivity.
const OF_SYSTEMS: [&str; 1] = ["mesh"];

/// The crates of the workspace that each crate names.
fn graph() -> BTreeMap<String, Vec<String>> {
    let own = |name: &str| name.strip_prefix("predicament-").map(str::to_owned);
    let read = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).expect("a manifest");
        let name = text.lines().find_map(|line| line.strip_prefix("name = \"")?.strip_suffix('"')).and_then(own)?;
        Some((name, dependencies(&text).into_iter().filter_map(own).collect()))
    };
    manifests().into_iter().filter_map(read).collect()
}

/// All crates that these reach, with themselves.
fn reached(graph: &BTreeMap<String, Vec<String>>, from: &[&str]) -> BTreeSet<String> {
    let mut all = BTreeSet::new();
    let mut open: Vec<String> = from.iter().map(|name| (*name).to_owned()).collect();
    while let Some(name) = open.pop() {
        if all.insert(name.clone()) {
            open.extend(graph.get(&name).cloned().unwrap_or_default());
        }
    }
    all
}

/// The crates that truths and judged code share beyond the vocabulary.
fn shared(graph: &BTreeMap<String, Vec<String>>, truths: &[&str], judged: &[&str]) -> Vec<String> {
    let judged = reached(graph, judged);
    let both = reached(graph, truths).into_iter().filter(|name| judged.contains(name));
    both.filter(|name| !VOCABULARY.contains(&name.as_str())).collect()
}

#[test]
fn truths_and_what_they_judge_share_the_vocabulary_only() {
    let graph = graph();
    for name in TRUTHS.iter().chain(&JUDGED).chain(&VOCABULARY).chain(&OF_SYSTEMS) {
        assert!(graph.contains_key(*name), "there is no crate `{name}`");
    }
    let truths = [&TRUTHS[..], &OF_SYSTEMS].concat();
    assert_eq!(shared(&graph, &truths, &JUDGED), [""; 0], "truth and judged code share these");
    // A planted edge is found, also behind another crate.
    let mut planted = graph.clone();
    planted.get_mut("mesh").expect("a crate").push("grid".to_owned());
    assert_eq!(shared(&planted, &truths, &JUDGED), ["grid"]);
}

/// The module of a file below `src`: `truth`, `sides` for `truth/sides.rs`.
fn module(path: &Path) -> Vec<String> {
    let mut words: Vec<String> =
        path.with_extension("").iter().map(|word| word.to_string_lossy().into_owned()).collect();
    if words.last().is_some_and(|last| ["mod", "lib"].contains(&last.as_str())) {
        words.pop();
    }
    words
}

/// The files of a crate that a file names: the longest module of each path, and the modules below the file.
fn named(from: &[String], text: &str, modules: &BTreeSet<Vec<String>>) -> BTreeSet<Vec<String>> {
    let mut all = BTreeSet::new();
    for path in paths(&code(text)) {
        // A visibility, or the value `self`.
        if ["crate", "self", "super"].contains(&path.as_str()) {
            continue;
        }
        let mut words = path.split("::").peekable();
        let mut at: Vec<String> = from.to_vec();
        match words.peek() {
            Some(&"crate") => {
                at.clear();
                words.next();
            }
            Some(&"self" | &"super") => {}
            // A name of this module, or a crate.
            _ => {
                let below = [from, &[path.split("::").next().unwrap_or_default().to_owned()]].concat();
                if modules.contains(&below) {
                    all.insert(below);
                }
                continue;
            }
        }
        for word in words {
            match word {
                "super" => drop(at.pop()),
                "self" => {}
                word => at.push(word.to_owned()),
            }
        }
        while !at.is_empty() && !modules.contains(&at) {
            at.pop();
        }
        if !at.is_empty() {
            all.insert(at);
        }
    }
    all
}

/// The chains of modules from a truth to an algorithm.
fn leaks(files: &BTreeMap<Vec<String>, String>) -> Vec<String> {
    let modules: BTreeSet<Vec<String>> = files.keys().cloned().collect();
    let is_truth = |module: &&Vec<String>| {
        module.first().is_some_and(|first| ["truth", "checks", "answer"].contains(&first.as_str()))
            && module.last().is_none_or(|last| last != "tests")
    };
    let mut found = Vec::new();
    for start in modules.iter().filter(is_truth) {
        let (mut seen, mut open) = (BTreeSet::new(), vec![vec![start.clone()]]);
        while let Some(chain) = open.pop() {
            let last = chain.last().expect("one at least").clone();
            if last.first().is_some_and(|first| first == "algorithm") {
                found.push(chain.iter().map(|module| module.join("::")).collect::<Vec<_>>().join(" -> "));
                continue;
            }
            if seen.insert(last.clone()) {
                let next = named(&last, &files[&last], &modules);
                open.extend(next.into_iter().map(|module| [&chain[..], &[module]].concat()));
            }
        }
    }
    found.sort();
    found.dedup();
    found
}

/// The sources of a crate by module.
fn by_module(folder: &Path) -> BTreeMap<Vec<String>, String> {
    let source = folder.join("src");
    let read = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).expect("a file");
        (module(path.strip_prefix(&source).expect("below")), text)
    };
    sources(&source).into_iter().map(read).collect()
}

#[test]
fn no_module_leads_from_a_truth_to_an_algorithm() {
    let mut all = Vec::new();
    for folder in systems() {
        let name = folder.file_name().expect("a name").to_string_lossy().into_owned();
        all.extend(leaks(&by_module(&folder)).into_iter().map(|chain| format!("{name}: {chain}")));
    }
    assert_eq!(all, [""; 0], "{}", all.join("\n"));
}

#[test]
fn a_leak_behind_another_module_is_seen() {
    let files = |content: &str| {
        BTreeMap::from([
            (vec!["truth".to_owned()], "use crate::task::content::Map;\nmod sides;".to_owned()),
            (vec!["truth".to_owned(), "sides".to_owned()], "use super::super::answer::Side;".to_owned()),
            (vec!["task".to_owned()], "mod content;\nuse crate::algorithm::run;".to_owned()),
            (vec!["task".to_owned(), "content".to_owned()], format!("pub(super) fn a() {{}}\n{content}")),
            (vec!["answer".to_owned()], String::new()),
            (vec!["algorithm".to_owned()], String::new()),
        ])
    };
    assert_eq!(leaks(&files("use predicament_mesh::Map;")), [""; 0]);
    assert_eq!(leaks(&files("use crate::algorithm::Index;")), ["truth -> task::content -> algorithm"]);
}
