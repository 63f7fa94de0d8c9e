//! The RustSec advisory database: a folder `crates/PACKAGE` with one Markdown file per advisory, which begins with
//! TOML.

use std::path::{Path, PathBuf};

use super::version::{Version, meets};

/// An advisory, reduced to the fields that say which versions are affected.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Advisory {
    /// The advisory's id, such as `RUSTSEC-2024-0001`.
    pub id: String,
    /// The affected package.
    pub package: String,
    /// The day of publication.
    pub date: String,
    /// The kind of an advisory that is not a vulnerability: `unsound`, `unmaintained` or `notice`.
    pub informational: Option<String>,
    /// The fixed versions, as requirements.
    pub patched: Vec<String>,
    /// The versions that were never affected, as requirements.
    pub unaffected: Vec<String>,
    /// True if the advisory was withdrawn.
    pub is_withdrawn: bool,
}

impl Advisory {
    /// Reads the text of an advisory's file.
    ///
    /// # Errors
    /// The missing field, or the line that can't be read.
    pub fn read(text: &str) -> Result<Advisory, String> {
        let front = text.trim_start().strip_prefix("```toml\n").and_then(|rest| rest.split_once("\n```"));
        let (front, _) = front.ok_or("it does not begin with a block of TOML")?;
        let (mut advisory, mut table) = (Advisory::default(), String::new());
        let mut lines = front.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
        while let Some(line) = lines.next() {
            if let Some(header) = line.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
                table = header.0.trim().to_owned();
                continue;
            }
            let (key, value) = line.split_once('=').ok_or_else(|| format!("`{line}` is not a key with a value"))?;
            let mut value = value.trim().to_owned();
            // An array may continue over several lines.
            while value.starts_with('[') && !strings(&value)?.1 {
                value.push('\n');
                value += lines.next().ok_or_else(|| format!("the array of `{}` does not end", key.trim()))?;
            }
            advisory.set(&table, key.trim(), &value)?;
        }
        if advisory.id.is_empty() || advisory.package.is_empty() {
            return Err("it has no `id` or no `package`".to_owned());
        }
        Ok(advisory)
    }

    fn set(&mut self, table: &str, key: &str, value: &str) -> Result<(), String> {
        let one = || strings(value)?.0.into_iter().next().ok_or_else(|| format!("`{key}` is not a string"));
        match (table, key) {
            ("advisory", "id") => self.id = one()?,
            ("advisory", "package") => self.package = one()?,
            ("advisory", "date") => self.date = one()?,
            ("advisory", "informational") => self.informational = Some(one()?),
            ("advisory", "withdrawn") => self.is_withdrawn = true,
            ("versions", "patched") => self.patched = strings(value)?.0,
            ("versions", "unaffected") => self.unaffected = strings(value)?.0,
            _ => {}
        }
        Ok(())
    }

    /// Returns true if the advisory affects a version: the version is neither patched nor unaffected.
    ///
    /// # Errors
    /// If a requirement can't be read.
    pub fn affects(&self, version: &Version) -> Result<bool, String> {
        let mut is_affected = !self.is_withdrawn;
        for requirement in self.patched.iter().chain(&self.unaffected) {
            let met = meets(version, requirement);
            is_affected &= !met.ok_or_else(|| format!("`{requirement}` is not a requirement on versions"))?;
        }
        Ok(is_affected)
    }
}

/// The quoted strings of a TOML value, and true if a bracket ends it; text after `#` outside of quotes is a comment.
pub fn strings(value: &str) -> Result<(Vec<String>, bool), String> {
    let (mut all, mut rest) = (Vec::new(), value);
    while let Some(at) = rest.find(['"', '\'', ']', '#']) {
        match &rest[at..=at] {
            "]" => return Ok((all, true)),
            "#" => rest = rest[at..].split_once('\n').map_or("", |(_, next)| next),
            quote => {
                let (text, after) =
                    rest[at + 1..].split_once(quote).ok_or_else(|| format!("`{value}` has a string without an end"))?;
                all.push(text.to_owned());
                rest = after;
            }
        }
    }
    Ok((all, false))
}

/// The advisories of a database.
pub struct Database {
    /// All advisories that could be read.
    pub advisories: Vec<Advisory>,
    /// The files that could not be read, each with the reason.
    pub unread: Vec<String>,
}

impl Database {
    /// Reads a database from its folder.
    ///
    /// # Errors
    /// If the folder has no folder `crates`, or no advisory can be read.
    pub fn open(folder: &Path) -> Result<Database, String> {
        let mut database = Database { advisories: Vec::new(), unread: Vec::new() };
        for package in entries(&folder.join("crates"))? {
            let files = if package.is_dir() { entries(&package)? } else { Vec::new() };
            for file in files.iter().filter(|file| file.extension().is_some_and(|end| end == "md")) {
                let read = std::fs::read_to_string(file).map_err(|error| error.to_string());
                match read.and_then(|text| Advisory::read(&text)) {
                    Ok(advisory) => database.advisories.push(advisory),
                    Err(why) => database.unread.push(format!("{}: {why}", file.display())),
                }
            }
        }
        if database.advisories.is_empty() {
            return Err(format!("{} has no advisories", folder.display()));
        }
        Ok(database)
    }

    /// The day of the newest advisory.
    pub fn newest(&self) -> &str {
        self.advisories.iter().map(|advisory| advisory.date.as_str()).max().unwrap_or_default()
    }
}

/// The entries of a folder, sorted.
pub fn entries(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let failed = |error: std::io::Error| format!("{}: {error}", folder.display());
    let entries = std::fs::read_dir(folder).map_err(failed)?;
    let mut paths =
        entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<Vec<_>, _>>().map_err(failed)?;
    paths.sort();
    Ok(paths)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_advisory_is_read_as_far_as_it_matters() {
        let text = "```toml\n[advisory]\nid = \"RUSTSEC-2020-0001\" # its id\npackage = \"a\"\ndate = \"2020-01-02\"\n\
                    keywords = [\"x ]\", # not the end\n  'y']\ninformational = \"unsound\"\n\n[affected]\n\
                    functions = { \"a::b\" = [\"< 1.0.0\"] }\n\n[versions]\npatched = [\n  \">= 1.0.0\",\n  \
                    \"^0.9.1\",\n]\nunaffected = []\n```\n\n# A title\n";
        let advisory = Advisory::read(text).unwrap();
        assert_eq!((advisory.id.as_str(), advisory.package.as_str()), ("RUSTSEC-2020-0001", "a"));
        assert_eq!(
            (advisory.patched.as_slice(), advisory.unaffected.len()),
            (&[">= 1.0.0".into(), "^0.9.1".into()][..], 0)
        );
        assert_eq!((advisory.informational.as_deref(), advisory.is_withdrawn), (Some("unsound"), false));
        let affects = |text: &str| advisory.affects(&Version::parse(text).unwrap()).unwrap();
        assert!(affects("0.9.0") && !affects("0.9.1") && !affects("1.0.0"));
    }

    #[test]
    fn what_can_t_be_read_is_an_error() {
        for (text, said) in [
            ("# A title\n", "it does not begin with a block of TOML"),
            ("```toml\n[advisory]\nid = \"a\"\n```\n", "it has no `id` or no `package`"),
            ("```toml\nid\n```\n", "`id` is not a key with a value"),
            ("```toml\n[versions]\npatched = [\"1\",\n```\n", "the array of `patched` does not end"),
            ("```toml\n[advisory]\nid = \"a\n```\n", "`\"a` has a string without an end"),
        ] {
            assert_eq!(Advisory::read(text).unwrap_err(), said);
        }
        let odd = Advisory { patched: vec!["newest".to_owned()], ..Advisory::default() };
        assert!(odd.affects(&Version::parse("1.0.0").unwrap()).is_err());
    }
}
