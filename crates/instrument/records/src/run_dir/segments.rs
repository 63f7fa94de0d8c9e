//! `segments.csv`: the bytes of each table that one scene on one backend has written.
//!
//! The parts of a run are merged scene by scene, in the order of the whole selection. Some tables do not name scenes,
//! and later versions of the tool may add tables that this code does not know. So a part records the length of each
//! table after each backend and scene.

use std::collections::BTreeMap;

crate::table! {
    /// `segments.csv`: the new length of a table that has grown by one scene on one backend.
    pub struct SegmentRow [Clone, PartialEq, Eq, Debug] in "segments.csv" {
        /// The position of the scene in the whole selection, from 0.
        pub place: u64 ["place"],
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The file of the table.
        pub table: String,
        /// The length of the table after this scene and backend, in bytes.
        pub bytes: u64 ["bytes"],
    }
}

/// The bytes in a table for one scene on one backend: the table's name, the start, and the end.
pub(super) type Piece = (String, u64, u64);

/// An error of segments that do not fit the folder's tables.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum SegmentError {
    /// The folder does not have the table.
    NoTable(String),
    /// The table does not grow in this segment.
    NotGrown(SegmentRow),
    /// The table has bytes that belong to no scene.
    NoScene(String),
}

impl std::fmt::Display for SegmentError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            SegmentError::NoTable(table) => write!(f, "there is no {table}"),
            SegmentError::NotGrown(SegmentRow { table, place, backend, .. }) => {
                write!(f, "{table} does not grow at scene {place} on {backend}")
            }
            SegmentError::NoScene(table) => write!(f, "{table} has bytes of no scene"),
        }
    }
}

/// The pieces of tables by scene and backend.
///
/// # Errors
/// If a table has shrunk or exceeds its length: the rows are not those of this folder.
pub(super) fn pieces(
    rows: &[SegmentRow],
    headers: &BTreeMap<String, u64>,
    lengths: &BTreeMap<String, u64>,
) -> Result<BTreeMap<(u64, String), Vec<Piece>>, SegmentError> {
    let mut ends = headers.clone();
    let mut pieces: BTreeMap<_, Vec<Piece>> = BTreeMap::new();
    for row in rows {
        let Some(end) = ends.get_mut(&row.table) else { return Err(SegmentError::NoTable(row.table.clone())) };
        if row.bytes <= *end {
            return Err(SegmentError::NotGrown(row.clone()));
        }
        let piece = (row.table.clone(), *end, row.bytes);
        pieces.entry((row.place, row.backend.clone())).or_default().push(piece);
        *end = row.bytes;
    }
    for (table, end) in &ends {
        if lengths.get(table) != Some(end) {
            return Err(SegmentError::NoScene(table.clone()));
        }
    }
    Ok(pieces)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(place: u64, table: &str, bytes: u64) -> SegmentRow {
        SegmentRow { place, backend: "exact".to_owned(), table: table.to_owned(), bytes }
    }

    #[test]
    fn every_byte_is_of_one_scene() {
        let of =
            |list: &[(&str, u64)]| list.iter().map(|(name, n)| ((*name).to_owned(), *n)).collect::<BTreeMap<_, _>>();
        let headers = of(&[("a.csv", 5), ("b.csv", 3)]);
        let rows = [row(4, "a.csv", 10), row(4, "b.csv", 4), row(9, "a.csv", 12)];
        let found = pieces(&rows, &headers, &of(&[("a.csv", 12), ("b.csv", 4)])).unwrap();
        let piece = |table: &str, from, to| (table.to_owned(), from, to);
        assert_eq!(found[&(4, "exact".to_owned())], [piece("a.csv", 5, 10), piece("b.csv", 3, 4)]);
        assert_eq!(found[&(9, "exact".to_owned())], [piece("a.csv", 10, 12)]);
        for lengths in [[("a.csv", 13), ("b.csv", 4)], [("a.csv", 12), ("b.csv", 5)]] {
            assert!(pieces(&rows, &headers, &of(&lengths)).unwrap_err().to_string().contains("bytes of no scene"));
        }
        let shrunk = pieces(&[row(1, "a.csv", 5)], &headers, &headers);
        assert_eq!(shrunk.unwrap_err().to_string(), "a.csv does not grow at scene 1 on exact");
    }
}
