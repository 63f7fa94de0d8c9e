//! The kinds of tables in files, with all keys that they know.
//!
//! Which keys a table takes depends on its task and its family; that is found
//! out while it is read. These lists serve the errors on the way there: where
//! a required key is missing, a key that no such table knows is usually the
//! missing one, misspelled.

use std::borrow::Cow;

/// A kind of table.
#[derive(Clone, Debug)]
pub struct TableKind {
    /// What errors call it, after "a".
    pub name: &'static str,
    /// Every key that some table of the kind takes.
    pub keys: Cow<'static, [&'static str]>,
}

impl TableKind {
    /// A kind of table with these keys.
    #[must_use]
    pub const fn new(name: &'static str, keys: &'static [&'static str]) -> TableKind {
        TableKind { name, keys: Cow::Borrowed(keys) }
    }
}

/// `{ path = "…" }` in the place of points.
pub static POINTS: TableKind = TableKind::new("reference to points", &["path", "fetch"]);
pub(crate) static MANIFEST: TableKind = TableKind::new("fetch manifest", &["file"]);
pub(crate) static FILE: TableKind = TableKind::new("file", &["key", "manager", "package", "version", "file", "sha256"]);
