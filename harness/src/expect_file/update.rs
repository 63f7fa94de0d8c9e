//! Adds expectations from a run.

use predicament_formats::CorpusError;

use super::edits::Edits;
use super::{Entry, tables};

/// Adds expectations for the entries at this level and with this reason. A table with the same backends, classes, level
/// and reason gets more scenes; other entries become new tables at the end of the file.
///
/// # Errors
/// If the file can't be read.
pub fn update(file: &str, text: &str, entries: &[Entry], level: &str, reason: &str) -> Result<Edits, CorpusError> {
    let tables = tables(file, text)?;
    let sorted = |names: &[String]| {
        let mut names = names.to_vec();
        names.sort();
        names
    };
    let mut edits = Edits::default();
    let mut new = String::new();
    for entry in entries {
        let same = tables.iter().find(|table| {
            table.level.as_ref().is_some_and(|(name, _)| name == level)
                && table.reason.0 == reason
                && sorted(&table.backends.values()) == sorted(&entry.backends)
                && sorted(&table.classes.values()) == sorted(&entry.classes)
        });
        match same {
            Some(table) => table.scenes.append(text, &entry.scenes, &mut edits),
            None => {
                new += if text.is_empty() && new.is_empty() { "" } else { "\n" };
                new += &entry.text(level, Some(reason));
            }
        }
    }
    if !new.is_empty() {
        let end = if text.is_empty() || text.ends_with('\n') { "" } else { "\n" };
        // Separate tables by one empty line, unless the file already ends with one.
        let new = if text.ends_with("\n\n") { new.trim_start() } else { &new };
        edits.insert(text.len(), format!("{end}{new}"));
    }
    Ok(edits)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "# head\n\n[[expect]]\nbackend = \"naive\" # one\nclass = [\"nan\", \"overreach\"]\nlevel = \"quick\"\n\
                        scene = [\n  \"a/b\", # why\n  \"a/c\" # last\n]\nreason = \"r\"\n";

    fn entry(backend: &str, classes: &[&str], scenes: &[&str]) -> Entry {
        let strings = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
        Entry { backends: strings(&[backend]), classes: strings(classes), scenes: strings(scenes) }
    }

    #[test]
    fn a_table_of_the_same_kind_grows_and_comments_stay() {
        let add = |reason: &str| {
            update("f", FILE, &[entry("naive", &["overreach", "nan"], &["a/d", "a/e"])], "quick", reason).unwrap()
        };
        let grown = FILE.replace("\"a/c\" # last\n", "\"a/c\", # last\n  \"a/d\",\n  \"a/e\",\n");
        assert_eq!(add("r").apply(FILE), grown);
        // Another reason makes another table.
        let other = add("other").apply(FILE);
        assert!(other.starts_with(FILE) && other.ends_with("]\nlevel = \"quick\"\nreason = \"other\"\n"), "{other}");
        let inline = FILE.replace("[\n  \"a/b\", # why\n  \"a/c\" # last\n]", "\"a/b\"");
        let made = update("f", &inline, &[entry("naive", &["overreach", "nan"], &["a/d"])], "quick", "r").unwrap();
        assert!(made.apply(&inline).contains("scene = [\n    \"a/b\",\n    \"a/d\",\n]\nreason"));
        let inline = FILE.replace("[\n  \"a/b\", # why\n  \"a/c\" # last\n]", "[\"a/b\"]");
        let made = update("f", &inline, &[entry("naive", &["overreach", "nan"], &["a/d"])], "quick", "r").unwrap();
        assert!(made.apply(&inline).contains("scene = [\"a/b\", \"a/d\"]\nreason"));
        assert!(update("f", FILE, &[], "quick", "r").unwrap().is_empty());
    }

    #[test]
    fn an_empty_file_begins_with_its_first_table() {
        let made = update("f", "", &[entry("naive", &["nan"], &["a/d"])], "full", "say \"so\"").unwrap().apply("");
        assert_eq!(
            made,
            "[[expect]]\nbackend = \"naive\"\nclass = [\"nan\"]\nscene = [\n    \"a/d\",\n]\nlevel = \"full\"\nreason = 'say \"so\"'\n"
        );
    }
}
