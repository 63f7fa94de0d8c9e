//! Removes expectations that no scene shows any more.
//!
//! A table expects each of its classes of each of its scenes on each of its backends. An expectation that the run has
//! not tested stays.

use std::collections::BTreeMap;

use predicament_formats::CorpusError;
use predicament_oracle::pattern::Pattern;

use super::edits::Edits;
use super::table::TableText;
use super::{Entry, tables};

/// The evidence of a run about one scene pattern, backend and class.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Told {
    /// Every matching scene of the run shows the class.
    Kept,
    /// The run has not tested the expectation, or not on all matching scenes.
    Untried,
    /// The pattern matches no known scene and does not name its suite; a person has to decide whether it is wrong.
    Nameless,
    /// Some matching scenes show the class and some do not; a person has to narrow the pattern.
    Partly,
    /// No matching scene shows the class.
    Gone,
}

/// The result of pruning.
pub struct Pruned {
    pub edits: Edits,
    /// The number of removed expectations, each of a pattern, backend and class.
    pub gone: usize,
    /// The number of expectations that stay because the run has not tested them.
    pub untried: usize,
    /// The expectations that a person has to edit, one line each.
    pub by_hand: Vec<String>,
}

/// Removes expectations that are gone according to `told`, for each pattern, backend and class. Tables of another level
/// stay as they are.
///
/// # Errors
/// If the file can't be read.
pub fn prune(
    file: &str,
    text: &str,
    level: &str,
    told: impl Fn(&Pattern, &str, &str) -> Told,
) -> Result<Pruned, CorpusError> {
    let mut pruned = Pruned { edits: Edits::default(), gone: 0, untried: 0, by_hand: Vec::new() };
    for table in tables(file, text)? {
        if table.level.as_ref().is_some_and(|(name, _)| name != level) {
            pruned.untried += table.scenes.items.len() * table.backends.items.len() * table.classes.items.len();
            continue;
        }
        let mut left: Vec<(String, String, Vec<String>)> = Vec::new();
        let before = pruned.gone;
        for (pattern, at) in &table.scenes.items {
            let glob = Pattern::new(pattern).map_err(|error| {
                CorpusError::file(file, error.to_string(), "write e.g. `near-*`").at_line(table.line)
            })?;
            let place = format!("{file}:{}: `{pattern}`", text[..at.start].matches('\n').count() + 1);
            for backend in table.backends.values() {
                let stays = |class: &String| pruned.stays(told(&glob, &backend, class), &place, &backend, class);
                let classes: Vec<String> = table.classes.values().into_iter().filter(stays).collect();
                if !classes.is_empty() {
                    left.push((pattern.clone(), backend, classes));
                }
            }
        }
        if pruned.gone > before {
            rewrite(text, &table, left, &mut pruned.edits);
        }
    }
    Ok(pruned)
}

impl Pruned {
    /// Counts or records the evidence for a pattern, backend and class; returns true if the file keeps the expectation.
    fn stays(&mut self, told: Told, place: &str, backend: &str, class: &str) -> bool {
        match told {
            Told::Gone => self.gone += 1,
            Told::Kept => {}
            Told::Untried => self.untried += 1,
            Told::Nameless => self.by_hand.push(format!(
                "{place} is not a known scene, for {class} on {backend}; correct or drop it by hand, or name its suite"
            )),
            Told::Partly => self.by_hand.push(format!(
                "{place} matches scenes that show {class} on {backend} and scenes that do not; narrow it by hand"
            )),
        }
        told != Told::Gone
    }
}

/// Reduces a table to these patterns, backends and classes. The table keeps the first group that fits into one table;
/// the other groups become new tables after it.
fn rewrite(text: &str, table: &TableText, left: Vec<(String, String, Vec<String>)>, edits: &mut Edits) {
    let mut alike: Vec<Entry> = Vec::new();
    for (pattern, backend, classes) in left {
        let same = |entry: &&mut Entry| entry.classes == classes && entry.backends == [backend.as_str()];
        match alike.iter_mut().find(same) {
            Some(entry) => entry.scenes.push(pattern),
            None => alike.push(Entry { backends: vec![backend], classes, scenes: vec![pattern] }),
        }
    }
    let mut by: BTreeMap<(Vec<String>, Vec<String>), usize> = BTreeMap::new();
    let mut entries: Vec<Entry> = Vec::new();
    for entry in alike {
        let at = *by.entry((entry.classes.clone(), entry.scenes.clone())).or_insert(entries.len());
        match entries.get_mut(at) {
            Some(same) => same.backends.extend(entry.backends),
            None => entries.push(entry),
        }
    }
    let Some((first, more)) = entries.split_first() else {
        edits.replace(table.with_its_comment(text), "");
        return;
    };
    let has = |names: &[String], name: &str| names.iter().any(|other| other == name);
    table.scenes.keep(text, |name| has(&first.scenes, name), edits);
    table.backends.keep(text, |name| has(&first.backends, name), edits);
    table.classes.keep(text, |name| has(&first.classes, name), edits);
    let level = table.level.as_ref().map(|(_, written)| &**written);
    let new: String = more.iter().map(|entry| format!("\n{}", entry.written(level, &table.reason.1))).collect();
    if !new.is_empty() {
        let end = if text[..table.lines.end].ends_with('\n') { "" } else { "\n" };
        edits.insert(table.lines.end, format!("{end}{new}"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "# head\n\n# about a\n[[expect]]\nbackend = [\"p\", \"q\"]\nclass = [\"nan\", \"overreach\"]\nscene = [\n    \"a\", # why\n    \
                        \"b\",\n    \"c\"\n]\nreason = \"\"\"\nlong\n\"\"\"\n\n# about z\n[[expect]]\nbackend = \"p\"\nclass = \"nan\"\n\
                        scene = \"z\"\nlevel = \"full\"\nreason = \"r\" # end\n";

    fn without(gone: &[(&str, &str, &str)]) -> String {
        let told = |glob: &Pattern, backend: &str, class: &str| {
            let is_gone = |of: &&(&str, &str, &str)| {
                glob.text() == of.0 && ["*", backend].contains(&of.1) && ["*", class].contains(&of.2)
            };
            if gone.iter().any(|of| is_gone(&of)) { Told::Gone } else { Told::Kept }
        };
        prune("f", FILE, "quick", told).unwrap().edits.apply(FILE)
    }

    #[test]
    fn what_is_gone_is_taken_out_and_the_rest_stays_as_it_was() {
        assert_eq!(without(&[]), FILE);
        assert_eq!(without(&[("a", "*", "*")]), FILE.replace("    \"a\", # why\n", ""));
        assert_eq!(without(&[("c", "*", "*")]), FILE.replace("    \"c\"\n", ""));
        let all = [("a", "p", "*"), ("b", "p", "*"), ("c", "p", "*")];
        assert_eq!(without(&all), FILE.replace("[\"p\", \"q\"]", "[\"q\"]"));
        let (head, rest) = FILE.split_at(FILE.find("# about a").unwrap());
        let rest = &rest[rest.find("# about z").unwrap()..];
        assert_eq!(without(&[("a", "*", "*"), ("b", "*", "*"), ("c", "*", "*")]), format!("{head}{rest}"));
        // A run of one level is no evidence for a table of the other level.
        assert_eq!(without(&[("z", "*", "*")]), FILE);
    }

    #[test]
    fn a_table_that_is_no_product_any_more_becomes_several() {
        let made = without(&[("b", "*", "nan")]);
        let own = "\n[[expect]]\nbackend = [\"p\", \"q\"]\nclass = [\"overreach\"]\nscene = [\n    \"b\",\n]\nreason = \"\"\"\nlong\n\"\"\"\n";
        let expected = FILE.replace("    \"b\",\n", "").replacen("long\n\"\"\"\n", &format!("long\n\"\"\"\n{own}"), 1);
        assert_eq!(made, expected);
        let tables = tables("f", &made).unwrap();
        assert_eq!(tables.len(), 3);
        // Every expectation that is not gone occurs exactly once.
        let made = without(&[("b", "p", "nan"), ("c", "q", "*")]);
        let mut all = Vec::new();
        for table in super::tables("f", &made).unwrap().iter().take_while(|table| table.level.is_none()) {
            for scene in table.scenes.values() {
                for backend in table.backends.values() {
                    all.extend(table.classes.values().into_iter().map(|class| format!("{scene} {backend} {class}")));
                }
            }
        }
        all.sort();
        let left =
            ["a p nan", "a p overreach", "a q nan", "a q overreach", "b p overreach", "b q nan", "b q overreach"];
        assert_eq!(all, [&left[..], &["c p nan", "c p overreach"]].concat());
    }
}
