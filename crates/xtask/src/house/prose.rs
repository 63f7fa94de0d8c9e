//! Rules for texts that a machine can check: first words of doc comments, the length of comment lines and of sentences.

use std::path::{Path, PathBuf};

use super::sources;

/// Words that a doc comment does not begin with: the reader would look for their noun in another place.
const BARE: [&str; 7] = ["Those", "That", "Of", "So", "By", "What", "None"];
/// The columns of a comment line, at most.
const COLUMNS: usize = 120;
/// The words of a sentence, at most.
const WORDS: usize = 35;

/// The doc comments of a file that begin with a bare word, and its comment lines that are too long, by line.
fn comments(source: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut is_doc_before = false;
    for (at, line) in (1..).zip(source.lines()) {
        let text = line.trim_start();
        let doc = text.strip_prefix("///").or_else(|| text.strip_prefix("//!"));
        if text.starts_with("//") && line.chars().count() > COLUMNS && !text.contains("| ") {
            found.push(format!("{at}: a comment of {} columns; {COLUMNS} are the limit", line.chars().count()));
        }
        if let Some(doc) = doc.filter(|_| !is_doc_before) {
            let word = doc.trim_start().split([' ', ',']).next().unwrap_or_default();
            if BARE.contains(&word) {
                found.push(format!("{at}: a doc comment begins with `{word}`; name the thing that it is about"));
            }
        }
        is_doc_before = doc.is_some();
    }
    found
}

/// The sentences of a page with too many words: how many, and how they begin. Code, tables and generated parts are left
/// out.
fn sentences(page: &str) -> Vec<String> {
    let mut prose = String::new();
    let (mut is_code, mut is_made) = (false, page.starts_with("<!-- made by"));
    for line in page.lines() {
        let text = line.trim_start();
        is_code ^= text.starts_with("```");
        is_made |= text.starts_with("<!-- predicament:");
        let item = text
            .split_once([' ', '.'])
            .is_some_and(|(mark, _)| mark == "*" || mark == "-" || mark.parse::<u32>().is_ok());
        if is_code || is_made || text.is_empty() || text.starts_with(['#', '<', '`', '|']) {
            prose.push('\n');
        } else {
            prose.push(if item { '\n' } else { ' ' });
            prose += text;
        }
        if text.starts_with("<!-- /predicament") {
            is_made = false;
        }
    }
    let is_end = |word: &str| word.trim_end_matches(['*', '_', '"', ')']).ends_with(['.', '!', '?', ':', ';']);
    let mut found = Vec::new();
    for paragraph in prose.lines() {
        let words: Vec<&str> = paragraph.split_whitespace().collect();
        for sentence in words.split_inclusive(|word| is_end(word)) {
            if sentence.len() > WORDS {
                found.push(format!("a sentence of {} words: {} …", sentence.len(), sentence[..8].join(" ")));
            }
        }
    }
    found
}

fn pages(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let of = |path: PathBuf| if path.is_dir() { pages(&path) } else { vec![path] };
    entries.flat_map(of).filter(|path| path.extension().is_some_and(|end| end == "md")).collect()
}

fn failures(files: Vec<PathBuf>, check: fn(&str) -> Vec<String>) -> Vec<String> {
    let of = |path: &PathBuf| {
        let text = std::fs::read_to_string(path).expect("a text");
        let told = check(&text).into_iter().map(|what| format!("{}: {what}", path.display()));
        told.collect::<Vec<String>>()
    };
    files.iter().flat_map(of).collect()
}

#[test]
fn comments_begin_with_their_subject_and_fit_the_screen() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let files: Vec<PathBuf> =
        ["crates", "harness", "examples"].iter().flat_map(|folder| sources(&root.join(folder))).collect();
    assert!(files.len() > 800, "{}", files.len());
    let found = failures(files, comments);
    assert!(found.is_empty(), "{} comments:\n{}", found.len(), found.join("\n"));
}

#[test]
fn sentences_of_pages_are_short() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files = pages(&root.join("docs"));
    files.extend(["README.md", "CONTRIBUTING.md"].map(|page| root.join(page)));
    assert!(files.len() > 40, "{}", files.len());
    let found = failures(files, sentences);
    assert!(found.is_empty(), "{} sentences:\n{}", found.len(), found.join("\n"));
}

#[test]
fn what_is_hard_to_read_is_found() {
    let source = "/// Those of the scene.\nfn a() {}\n/// The vertices.\n/// Of the scene.\nfn b() {}\n";
    assert_eq!(comments(source).len(), 1, "a second line may begin with any word");
    assert_eq!(comments(&format!("    // {}\n", "word ".repeat(24))).len(), 1);
    let long = "word ".repeat(36);
    assert_eq!(sentences(&format!("# Title\n\nShort one. {long}\n")).len(), 1);
    for fine in [
        "word ".repeat(35),
        format!("```\n{long}\n```\n"),
        format!("| {long} |"),
        "word ".repeat(20) + "end. " + &"word ".repeat(20),
    ] {
        assert_eq!(sentences(&fine), [""; 0]);
    }
}
