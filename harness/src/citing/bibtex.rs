//! BibTeX: the tool, the papers that it stands on, and entries for other sources.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use predicament_report::Source;

use super::Sources;

/// The papers; the file explains its form.
const PAPERS: &str = include_str!("papers.bib");
/// The mark of a line that says which sources are the paper below.
const MARK: &str = "% source: ";
/// The longest key of an entry that is made from a source, in characters.
const LONGEST_KEY: usize = 60;

/// The entry of the tool.
pub fn tool(commit: Option<&str>) -> String {
    let commit = commit.map_or(String::new(), |commit| format!(", commit {commit}"));
    format!(
        "@misc{{predicament,\n  author       = {{{{The predicament authors}}}},\n  title        = {{predicament: A \
         Differential Test Harness for Geometric Predicates}},\n  howpublished = {{Computer program}},\n  note         = \
         {{Version {}{commit}}},\n}}\n",
        env!("CARGO_PKG_VERSION")
    )
}

/// All papers that the project stands on, each below a comment that says what stands on it.
pub fn papers() -> String {
    blocks().map(|block| without_marks(block) + "\n").collect::<Vec<_>>().join("\n")
}

/// The paper that a source names, as a block of the file of papers.
pub fn paper(source: &str) -> Option<&'static str> {
    blocks().find(|block| block.lines().filter_map(|line| line.strip_prefix(MARK)).any(|text| source.contains(text)))
}

/// The blocks of the file that have an entry.
fn blocks() -> impl Iterator<Item = &'static str> {
    PAPERS.split("\n\n").map(str::trim).filter(|block| block.contains("\n@"))
}

/// A block without the lines that say which sources it is.
fn without_marks(block: &str) -> String {
    let lines = block.lines().filter(|line| !line.starts_with(MARK));
    lines.collect::<Vec<_>>().join("\n")
}

/// The entry of a block, without its comments.
fn entry(block: &str) -> &str {
    block.find("\n@").map_or(block, |at| &block[at + 1..])
}

/// The sources of runs: a paper once, below all sources that name it; a `@misc` for another publication; and a comment
/// for scenes that are not from a publication.
pub fn of(sources: &Sources) -> String {
    let mut of_papers: BTreeMap<&str, Vec<&Source>> = BTreeMap::new();
    let (mut others, mut own) = (Vec::new(), Vec::new());
    for source in &sources.named {
        match paper(&source.text) {
            Some(block) => of_papers.entry(entry(block)).or_default().push(source),
            None if source.is_own => own.push(source),
            None => others.push(source),
        }
    }
    let mut text = String::new();
    for (entry, named) in of_papers {
        named.iter().for_each(|source| text += &about(source));
        let _ = writeln!(text, "{entry}\n");
    }
    let mut keys = BTreeSet::new();
    for source in others {
        let key = unique(&mut keys, &key(&source.text));
        let title = escaped(&source.text);
        text += &about(source);
        let _ = writeln!(text, "@misc{{{key},\n  title = {{{{{title}}}}},\n}}\n");
    }
    if !own.is_empty() {
        text += "% Scenes that are not from a publication:\n";
        own.into_iter().for_each(|source| text += &about(source));
        text += "\n";
    }
    for (what, scenes) in
        [("no key `source`", &sources.silent), ("a suite that is unreadable or has changed", &sources.unknown)]
    {
        if !scenes.is_empty() {
            let list: Vec<String> = scenes.iter().map(|(suite, count)| format!("{suite} ({count})")).collect();
            let _ = writeln!(text, "% Scenes with {what}: {}\n", list.join(", "));
        }
    }
    text.trim_end().to_owned() + "\n"
}

/// A comment with a source, its suites and the number of its scenes.
fn about(source: &Source) -> String {
    let scenes = if source.scenes == 1 { "1 scene".to_owned() } else { format!("{} scenes", source.scenes) };
    // To BibTeX an @ begins an entry, in a comment too.
    let text = crate::out::one_line(&source.text).replace('@', " at ");
    format!("% {text} ({scenes} of {})\n", source.suites.join(", "))
}

/// A text with the signs escaped that TeX would obey.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for c in crate::out::one_line(text).chars() {
        match c {
            '&' | '%' | '#' | '_' | '$' => escaped.extend(['\\', c]),
            '{' | '}' => escaped.push(if c == '{' { '(' } else { ')' }),
            '\\' => escaped += "\\textbackslash ",
            '~' => escaped += "\\textasciitilde ",
            '^' => escaped += "\\textasciicircum ",
            _ => escaped.push(c),
        }
    }
    escaped
}

/// The key of an entry: the letters and digits of a source, with hyphens between them.
fn key(text: &str) -> String {
    let is_kept = |c: &char| c.is_ascii_alphanumeric();
    let words = text.split(|c: char| !is_kept(&c)).filter(|word| !word.is_empty());
    let key: String = words.collect::<Vec<_>>().join("-").to_lowercase().chars().take(LONGEST_KEY).collect();
    let key = key.trim_end_matches('-');
    if key.is_empty() { "source".to_owned() } else { key.to_owned() }
}

/// A key that was not used before.
fn unique(keys: &mut BTreeSet<String>, key: &str) -> String {
    let numbered = (2..).map(|number| format!("{key}-{number}"));
    let found = std::iter::once(key.to_owned()).chain(numbered).find(|key| keys.insert(key.clone()));
    found.unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The error of a text as BibTeX: a key, or braces that do not match.
    fn wrong(text: &str) -> Option<String> {
        let entries = text.lines().filter(|line| !line.starts_with('%'));
        let entries = entries.collect::<Vec<_>>().join("\n");
        let mut keys = BTreeSet::new();
        for entry in format!("\n{entries}").split("\n@").skip(1) {
            let (kind, rest) = entry.split_once('{')?;
            let (key, _) = rest.split_once(',')?;
            if !kind.chars().all(|c| c.is_ascii_lowercase()) || !keys.insert(key) {
                return Some(format!("@{kind}{{{key}"));
            }
            let unescaped = entry.replace("\\{", "").replace("\\}", "");
            if unescaped.matches('{').count() != unescaped.matches('}').count() || !entry.trim_end().ends_with('}') {
                return Some(format!("braces of {key}"));
            }
        }
        None
    }

    fn source(text: &str, is_own: bool) -> Source {
        Source { text: text.to_owned(), suites: vec!["a".to_owned(), "b".to_owned()], scenes: 2, is_own }
    }

    #[test]
    fn papers_are_bibtex_without_addresses() {
        let text = papers();
        assert_eq!(wrong(&text), None);
        assert_eq!(text.matches("\n@").count(), 9);
        assert!(
            !text.contains("source:") && ["doi", "url", "http"].iter().all(|word| !text.to_lowercase().contains(word))
        );
        for (source, key) in [
            ("Kettner, Mehlhorn, Pion, Schirra, Yap: Classroom examples, failure A1", "kettner-2008"),
            ("crate robust 1.2.0, fixtures/orient2d.txt (J. R. Shewchuk's predicates)", "shewchuk-1997"),
            ("Franklin and Magalhães 2022, 4.1", "franklin-magalhaes-2022"),
        ] {
            assert!(paper(source).is_some_and(|block| block.contains(key)), "{source}");
        }
        assert_eq!(paper("mapbox/earcut, issue 45"), None);
        assert!(wrong("@misc{a,\n}\n@misc{a,\n}\n").is_some() && wrong("@misc{a,\n  title = {{x},\n}\n").is_some());
    }

    #[test]
    fn each_source_has_one_entry() {
        let named = vec![
            source("A & B_1, 100 %", false),
            source("A, B 1: 100", false),
            source("Kettner, failure A1", false),
            source("Kettner, failure B2", false),
            source("by hand", true),
            source("{x}\n\\y@z", false),
        ];
        let silent = BTreeMap::from([("c".to_owned(), 3)]);
        let text = of(&Sources { named, silent, unknown: BTreeMap::from([("d".to_owned(), 1)]) });
        assert_eq!(wrong(&text), None, "{text}");
        assert_eq!(text.matches("\n@").count(), 4, "{text}");
        for line in [
            "% Kettner, failure A1 (2 scenes of a, b)\n% Kettner, failure B2 (2 scenes of a, b)\n@article{kettner-2008,",
            "@misc{a-b-1-100,\n  title = {{A \\& B\\_1, 100 \\%}},\n}\n",
            "@misc{a-b-1-100-2,\n",
            "@misc{x-y-z,\n  title = {{(x) \\textbackslash y@z}},\n}\n",
            "\\y at z (2 scenes of a, b)\n@misc{x-y-z",
            "% Scenes that are not from a publication:\n% by hand (2 scenes of a, b)\n",
            "% Scenes with no key `source`: c (3)\n",
            "% Scenes with a suite that is unreadable or has changed: d (1)\n",
        ] {
            assert!(text.contains(line), "{line}\n{text}");
        }
    }
}
