//! Causes of outcomes that no scene of the quick run has: a list by hand, and the table that counts it.
//!
//! The list is `causes.txt`. A line `== CAUSE` opens a cause. A line below it is a file or a folder of
//! `crates/systems`, and after a colon the text of a comparison there. Without a text the whole file or folder has the
//! cause, except for comparisons that are named elsewhere. Texts stay when lines move.

use std::collections::{BTreeMap, BTreeSet};

/// The causes, in the order of the table.
const LIST: &str = include_str!("../causes.txt");
/// The row of outcomes that the list does not have.
const OPEN: &str = "no scene found";

/// A cause of the list: a prefix of paths, and a comparison's text if it is for one.
struct Entry {
    cause: usize,
    path: &'static str,
    text: Option<&'static str>,
}

/// The list, and the numbers of unseen outcomes by cause and system.
pub struct Causes {
    names: Vec<&'static str>,
    entries: Vec<Entry>,
    used: BTreeSet<usize>,
    counts: BTreeMap<usize, BTreeMap<String, usize>>,
}

impl Causes {
    pub fn read() -> Result<Causes, String> {
        Causes::of(LIST)
    }

    fn of(list: &'static str) -> Result<Causes, String> {
        let mut causes =
            Causes { names: Vec::new(), entries: Vec::new(), used: BTreeSet::new(), counts: BTreeMap::new() };
        for line in list.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')) {
            if let Some(name) = line.strip_prefix("== ") {
                causes.names.push(name);
                continue;
            }
            let (path, text) = line.split_once(": ").map_or((line, None), |(path, text)| (path, Some(text)));
            let cause = causes.names.len().checked_sub(1).ok_or("switches: causes.txt has a line before any cause")?;
            causes.entries.push(Entry { cause, path, text });
        }
        Ok(causes)
    }

    /// Counts unseen outcomes of a comparison, and returns their cause.
    pub fn count(&mut self, system: &str, path: &str, text: &str, outcomes: usize) -> &'static str {
        let matches = |entry: &Entry| match entry.text {
            Some(of) => entry.path == path && of == text,
            None => path.starts_with(entry.path),
        };
        let named = |entry: &&(usize, &Entry)| entry.1.text.is_some();
        let all: Vec<(usize, &Entry)> = self.entries.iter().enumerate().filter(|(_, entry)| matches(entry)).collect();
        let found = all.iter().find(named).or(all.first());
        let cause = found.map_or(self.names.len(), |(_, entry)| entry.cause);
        self.used.extend(found.map(|(at, _)| *at));
        *self.counts.entry(cause).or_default().entry(system.to_owned()).or_default() += outcomes;
        self.names.get(cause).copied().unwrap_or(OPEN)
    }

    /// The table by cause, and lines of the list that no unseen outcome has.
    pub fn told(&self) -> String {
        let mut told = "\n| outcomes | why no scene has them | by crate |\n|---:|---|---|\n".to_owned();
        let mut sum = 0;
        for (&cause, by) in &self.counts {
            let count: usize = by.values().sum();
            let by: Vec<String> = by.iter().map(|(system, count)| format!("`{system}` {count}")).collect();
            told += &format!("| {count} | {} | {} |\n", self.names.get(cause).unwrap_or(&OPEN), by.join(", "));
            sum += count;
        }
        told += &format!("| {sum} | all | |\n");
        for (_, entry) in self.entries.iter().enumerate().filter(|(at, _)| !self.used.contains(at)) {
            let text = entry.text.map(|text| format!(": {text}")).unwrap_or_default();
            told += &format!("causes.txt names {}{text}, which is seen or is not there\n", entry.path);
        }
        told
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_counts_before_its_file_and_the_rest_is_open() {
        let mut causes = Causes::of("# why\n== apart\na/b.rs\n== named\na/b.rs: x < y\na/c.rs: gone\n").unwrap();
        assert_eq!(causes.count("a", "a/b.rs", "x > y", 2), "apart");
        assert_eq!(causes.count("a", "a/b.rs", "x < y", 1), "named");
        assert_eq!(causes.count("d", "d/e.rs", "x < y", 1), OPEN);
        let told = causes.told();
        for line in ["| 2 | apart | `a` 2 |", "| 1 | no scene found | `d` 1 |", "| 4 | all | |", "names a/c.rs: gone,"]
        {
            assert!(told.contains(line), "{line}: {told}");
        }
        assert!(Causes::read().is_ok_and(|causes| !causes.names.is_empty()));
        assert!(Causes::of("a/b.rs").is_err());
    }
}
