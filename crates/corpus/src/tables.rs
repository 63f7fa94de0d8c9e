//! The kinds of tables in suites and manifests, with all keys that they know.
//!
//! Which keys a table takes depends on its task and its family; that is found
//! out while it is read. These lists serve the errors on the way there: where
//! a required key is missing, a key that no such table knows is usually the
//! missing one, misspelled.

/// A kind of table.
#[derive(Debug)]
pub(crate) struct TableKind {
    /// What errors call it, after "a".
    pub(crate) name: &'static str,
    /// Every key that some table of the kind takes.
    pub(crate) keys: &'static [&'static str],
}

const fn kind(name: &'static str, keys: &'static [&'static str]) -> TableKind {
    TableKind { name, keys }
}

pub(crate) static SUITE: TableKind = kind("suite", &["title", "description", "scene", "generate"]);

pub(crate) static SCENE: TableKind = kind(
    "scene",
    &[
        "name",
        "task",
        "points",
        "constructed",
        "queries",
        "axis",
        "plane",
        "fixture",
        "map",
        "cells",
        "cubes",
        "a",
        "b",
        "random",
        "random_full",
        "seed",
        "quick_stride",
        "full_stride",
        "tags",
        "source",
        "analysis",
    ],
);

pub(crate) static GENERATOR: TableKind = kind(
    "generator",
    &[
        "name",
        "task",
        "family",
        "n",
        "n_full",
        "seed",
        "dimension",
        "axis",
        "plane",
        "ulps",
        "digits",
        "p",
        "q",
        "r",
        "side",
        "step",
        "shift",
        "bits",
        "density",
        "pitch",
        "edge",
        "random",
        "random_full",
        "quick_stride",
        "full_stride",
        "tags",
        "source",
        "analysis",
    ],
);

pub(crate) static POINTS: TableKind = kind("reference to points", &["path"]);
pub(crate) static CUBES: TableKind = kind("reference to cubes", &["path"]);
pub(crate) static CONSTRUCTION: TableKind = kind("construction", &["ssi", "lpi", "tpi"]);
pub(crate) static FIXTURE: TableKind = kind("fixture", &["fetch"]);
pub(crate) static MAP: TableKind = kind("map", &["topojson", "fetch", "object"]);
pub(crate) static COMPLEX: TableKind = kind(
    "complex",
    &["vertices", "edges", "triangles", "tetrahedra", "closed", "path", "topojson", "fetch", "object", "shifted"],
);
pub(crate) static MANIFEST: TableKind = kind("fetch manifest", &["file"]);
pub(crate) static FILE: TableKind = kind("file", &["key", "manager", "package", "version", "file", "sha256"]);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn generators_know_the_parameters_of_all_families() {
        for family in crate::families() {
            for parameter in family.parameters {
                assert!(GENERATOR.keys.contains(parameter), "{} has `{parameter}`", family.name);
            }
        }
    }
}
