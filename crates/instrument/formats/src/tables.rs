//! The kinds of tables in files, with all keys that they know.
//!
//! The keys that a table takes depend on its task and its family, which are known only while it is read. These lists
//! improve errors before that point: if a required key is missing, a key that no such table knows is usually the
//! missing key, misspelled.

use std::borrow::Cow;

/// A kind of table.
#[derive(Clone, Debug)]
pub struct TableKind {
    /// The name in errors, used after "a".
    pub name: &'static str,
    /// All keys that some table of the kind takes.
    pub keys: Cow<'static, [&'static str]>,
}

impl TableKind {
    /// A kind of table with these keys.
    #[must_use]
    pub const fn new(name: &'static str, keys: &'static [&'static str]) -> TableKind {
        TableKind { name, keys: Cow::Borrowed(keys) }
    }
}

/// The table `{ path = "…" }` that replaces points.
pub static POINTS: TableKind = TableKind::new("reference to points", &["path", "fetch", "columns"]);
pub(crate) static MANIFEST: TableKind = TableKind::new("fetch manifest", &["file"]);
pub(crate) static FILE: TableKind = TableKind::new("file", &["key", "manager", "package", "version", "file", "sha256"]);
