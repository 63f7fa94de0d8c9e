//! The page about trust: every promise of a page has a row there, and every row says what it rests on.
//!
//! A promise is a sentence of the pages below with a word such as *always* or *proved*. A row quotes a part of it.

use std::path::Path;

/// The pages whose promises are held, relative to `docs`.
const PAGES: [&str; 4] = ["../README.md", "EXACT.md", "SOS.md", "TOLERANCE.md"];

/// The words that make a sentence a promise.
const WORDS: [&str; 12] = [
    "always",
    "never",
    "certain",
    "certainly",
    "guarantee",
    "guarantees",
    "proof",
    "proofs",
    "prove",
    "proved",
    "proves",
    "promise",
];

/// The labels of rows, the strongest first.
const LABELS: [&str; 7] =
    ["proved by machine", "computed exactly", "exhaustive", "proved on paper", "cited", "tested", "inspected"];

/// A row of the table: one claim.
struct Row<'t> {
    label: &'t str,
    /// The quoted parts of pages, each with the page.
    quotes: Vec<(&'t str, String)>,
    /// The files that the row names.
    files: Vec<&'t str>,
}

/// The rows of the table of claims.
fn rows(page: &str) -> Vec<Row<'_>> {
    let table = page.lines().skip_while(|line| !line.starts_with("| claim |")).skip(2);
    let lines = table.take_while(|line| line.starts_with('|'));
    lines
        .map(|line| {
            let cells: Vec<&str> = line.trim_matches('|').split(" | ").map(str::trim).collect();
            let [_, places, label, by, ..] = cells[..] else { panic!("four cells and more: {line}") };
            let files = by.split('`').skip(1).step_by(2).filter(|name| name.contains('/')).collect();
            Row { label, quotes: quotes(places), files }
        })
        .collect()
}

/// The quotations of a cell such as `[EXACT](EXACT.md) "one", "two"; [SOS](SOS.md#ties) "three"`.
fn quotes(places: &str) -> Vec<(&str, String)> {
    let mut all = Vec::new();
    for link in places.split("](").skip(1) {
        let Some((target, rest)) = link.split_once(')') else { continue };
        let page = target.split('#').next().unwrap_or_default();
        let rest = rest.split("; [").next().unwrap_or_default();
        // (A bar ends a cell, unless it is escaped.)
        all.extend(rest.split('"').skip(1).step_by(2).map(|quote| (page, quote.replace("\\|", "|"))));
    }
    all
}

/// The sentences of a page outside of blocks of code, headings apart, each on one line.
///
/// A row of a table about promises ends with a mark, so that it is one.
fn sentences(page: &str) -> Vec<String> {
    let text: Vec<&str> = page.split("\n```").step_by(2).collect();
    let mut paragraphs = vec![String::new()];
    let (mut after_heading, mut is_table, mut is_about_promises) = (false, false, false);
    for line in text.join("\n\n").lines().map(str::trim) {
        let is_row = line.starts_with('|');
        if is_row && !is_table {
            is_about_promises = line.contains("promise of");
        }
        let begins = line.is_empty()
            || after_heading
            || is_row
            || ["* ", "- ", "#", "<!--"].iter().any(|mark| line.starts_with(mark))
            || line.split_once(". ").is_some_and(|(number, _)| number.chars().all(|c| c.is_ascii_digit()));
        if begins {
            paragraphs.push(String::new());
        }
        let last = paragraphs.last_mut().expect("one at least");
        last.push_str(line);
        last.push_str(if is_row && is_about_promises && !line.contains("---") { " (promise) " } else { " " });
        (after_heading, is_table) = (line.starts_with('#'), is_row);
    }
    let is_text = |paragraph: &&String| !paragraph.starts_with('#') && !paragraph.starts_with("<!--");
    let split = |paragraph: &String| -> Vec<String> {
        // A row of a table is one.
        let is_row = paragraph.starts_with('|');
        let ends = if is_row { paragraph.clone() } else { paragraph.replace(". ", ".\n").replace("; ", ";\n") };
        ends.lines().map(|sentence| sentence.trim().to_owned()).collect()
    };
    paragraphs.iter().filter(is_text).flat_map(split).collect()
}

/// Returns true if a sentence promises something, names in code apart.
fn promises(sentence: &str) -> bool {
    let words = sentence.split('`').step_by(2).flat_map(|text| text.split(|c: char| !c.is_alphabetic()));
    words.into_iter().any(|word| WORDS.contains(&word.to_lowercase().as_str()))
}

/// The promises of a page that no row quotes.
fn orphans(name: &str, page: &str, rows: &[Row]) -> Vec<String> {
    let quoted: Vec<&String> =
        rows.iter().flat_map(|row| &row.quotes).filter(|(of, _)| *of == name).map(|(_, quote)| quote).collect();
    let is_orphan = |sentence: &String| promises(sentence) && !quoted.iter().any(|&quote| sentence.contains(quote));
    sentences(page).into_iter().filter(is_orphan).collect()
}

#[test]
fn every_promise_has_its_row() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |name: &str| {
        let path = root.join("docs").join(name);
        std::fs::read_to_string(&path).unwrap_or_else(|why| panic!("{}: {why}", path.display()))
    };
    let trust = read("TRUST.md");
    let rows = rows(&trust);
    assert!(rows.len() > 20, "{} rows", rows.len());
    for name in PAGES {
        let page = read(name);
        let orphans = orphans(name, &page, &rows);
        assert!(orphans.is_empty(), "docs/TRUST.md has no row for these promises of {name}:\n{}", orphans.join("\n"));
        let known = sentences(&page);
        for (_, quote) in rows.iter().flat_map(|row| &row.quotes).filter(|(of, _)| *of == name) {
            assert!(known.iter().any(|sentence| sentence.contains(quote.as_str())), "{name} does not say “{quote}”");
        }
    }
    for Row { label, quotes, files } in rows {
        assert!(LABELS.contains(&label), "`{label}` is no label");
        assert!(quotes.iter().all(|(page, _)| PAGES.contains(page)), "{quotes:?}");
        assert!(label == "inspected" || !files.is_empty(), "a row about {quotes:?} names no file");
        for file in files {
            assert!(root.join(file).exists(), "docs/TRUST.md names {file}, which is not there");
        }
    }
}

#[test]
fn an_orphan_is_seen() {
    let table = "| claim | where | label | by | cases |\n|---|---|---|---|---|\n| a | [EXACT](EXACT.md#a) \"is never wrong\" | tested | \
                 `crates/xtask` | 1 |\n";
    let rows = rows(table);
    assert_eq!(rows[0].quotes, [("EXACT.md", "is never wrong".to_owned())]);
    let page = "# Never\nIt is never\nwrong. This always ends; that may `never`.\n\n```\nnever\n```\nA certainty.\n";
    assert_eq!(orphans("EXACT.md", page, &rows), ["This always ends;"]);
    let table = "| a | promise of a sign |\n|---|---|\n| b | the sign |\n";
    assert_eq!(orphans("EXACT.md", table, &rows).len(), 2, "the head and the row");
    assert_eq!(orphans("SOS.md", page, &rows).len(), 2, "quoted of another page");
}
