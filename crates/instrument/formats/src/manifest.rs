//! The manifest `fetch.toml`: real data by package manager, package, version, file and hash.

use std::collections::BTreeMap;

use crate::document::{Document, Field, Fields};
use crate::{CorpusError, tables};

/// A package manager whose ordinary client fetches packages.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Manager {
    /// `npm`, from the npm registry.
    Npm,
    /// `cargo`, from its default registry.
    Cargo,
    /// `pip`, from the Python Package Index: the wheel.
    Pip,
    /// `apt-get`, from the sources of a Debian system.
    Apt,
}

impl Manager {
    /// The manager's name in the manifest, which is the client's name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Manager::Npm => "npm",
            Manager::Cargo => "cargo",
            Manager::Pip => "pip",
            Manager::Apt => "apt",
        }
    }
}

impl std::fmt::Display for Manager {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

/// A file of a published package.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Entry {
    /// The key by which suites refer to the file.
    pub key: String,
    /// The package manager.
    pub manager: Manager,
    /// The name of the package.
    pub package: String,
    /// The exact version of the package.
    pub version: String,
    /// The file's path in the package; it may continue inside a `.tar.gz`.
    pub file: String,
    /// The file's SHA-256 in lower-case hex.
    pub sha256: String,
}

/// The entries of a manifest, by key.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Manifest {
    entries: BTreeMap<String, Entry>,
}

impl Manifest {
    /// Reads a manifest: `[[file]]` tables.
    ///
    /// # Errors
    /// [`CorpusError`] at the line that is wrong.
    pub fn parse(file: &str, text: &str) -> Result<Manifest, CorpusError> {
        let document = Document::new(file, text);
        let root = document.parse()?;
        let fields = Fields::new(&document, &tables::MANIFEST, root.get_ref(), 0);
        let mut entries = BTreeMap::new();
        if let Some(files) = fields.get("file") {
            for table in files.items("[[file]] tables")? {
                let entry = read(table.fields(&tables::FILE)?)?;
                if entries.contains_key(&entry.key) {
                    return Err(table.error(format!("the key `{}` is taken", entry.key), "give every file its own key"));
                }
                entries.insert(entry.key.clone(), entry);
            }
        }
        fields.finish()?;
        Ok(Manifest { entries })
    }

    /// The entry with this key.
    #[must_use]
    pub fn entry(&self, key: &str) -> Option<&Entry> {
        self.entries.get(key)
    }

    /// All entries, in the order of their keys.
    pub fn entries(&self) -> impl ExactSizeIterator<Item = &Entry> {
        self.entries.values()
    }
}

fn read(fields: Fields<'_, '_>) -> Result<Entry, CorpusError> {
    let entry = Entry {
        key: plain_name(&fields.required("key")?)?,
        manager: manager(&fields.required("manager")?)?,
        package: package(&fields.required("package")?)?,
        version: plain_name(&fields.required("version")?)?,
        file: path(&fields.required("file")?)?,
        sha256: sha256(&fields.required("sha256")?)?,
    };
    fields.finish()?;
    Ok(entry)
}

fn manager(field: &Field<'_, '_>) -> Result<Manager, CorpusError> {
    match field.str()? {
        "npm" => Ok(Manager::Npm),
        "cargo" => Ok(Manager::Cargo),
        "pip" => Ok(Manager::Pip),
        "apt" => Ok(Manager::Apt),
        other => Err(field.error(format!("no package manager is called `{other}`"), "use npm, cargo, pip or apt")),
    }
}

fn is_plain(name: &str) -> bool {
    !name.is_empty()
        && name.bytes().all(|b| b.is_ascii_alphanumeric() || b"._-+".contains(&b))
        && !name.starts_with(['.', '-'])
}

/// Reads a word that is safe in a file name and on a command line.
fn plain_name(field: &Field<'_, '_>) -> Result<String, CorpusError> {
    let name = field.string()?;
    if is_plain(&name) {
        Ok(name)
    } else {
        Err(field.error(format!("`{name}` is not a plain name"), "use letters, digits, . _ - +"))
    }
}

/// Reads a package's name: plain, or npm's `@scope/name`.
fn package(field: &Field<'_, '_>) -> Result<String, CorpusError> {
    let name = field.string()?;
    let bare = name.strip_prefix('@').unwrap_or(&name);
    let parts = bare.split('/').collect::<Vec<_>>();
    let most = if name.starts_with('@') { 2 } else { 1 };
    if parts.len() <= most && parts.iter().all(|part| is_plain(part)) {
        Ok(name)
    } else {
        Err(field.error(format!("`{name}` is not a package name"), "write the name in the registry"))
    }
}

/// Reads a path that stays inside the package.
fn path(field: &Field<'_, '_>) -> Result<String, CorpusError> {
    let path = field.string()?;
    if path.split('/').all(is_plain) {
        Ok(path)
    } else {
        Err(field.error(format!("`{path}` is not a path in a package"), "write names joined by /, without . and .."))
    }
}

fn sha256(field: &Field<'_, '_>) -> Result<String, CorpusError> {
    let text = field.string()?;
    if text.len() == 64 && text.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b)) {
        Ok(text)
    } else {
        Err(field.error(format!("`{text}` is not a SHA-256"), "write 64 lower-case hex digits"))
    }
}
