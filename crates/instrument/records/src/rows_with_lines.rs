//! Rows with the line numbers that they were read from.
//!
//! A report names the source line of each number. Rows are dropped if an earlier folder has them, sorted and selected,
//! so an index in the list does not identify a row: each row keeps its line number.

use std::ops::{Deref, Index, IndexMut};

/// The rows of a table, each with its line in the file; usable like a list of rows.
#[derive(Clone, PartialEq, Debug)]
pub struct Rows<R> {
    rows: Vec<R>,
    lines: Vec<Option<u64>>,
    is_part: bool,
}

impl<R> Rows<R> {
    /// Rows with their lines; `is_part` is true if the file has other rows too.
    pub(crate) fn read(lined: impl IntoIterator<Item = (u64, R)>, is_part: bool) -> Rows<R> {
        let (lines, rows) = lined.into_iter().map(|(line, row)| (Some(line), row)).unzip();
        Rows { rows, lines, is_part }
    }

    /// The rows, each with its line number; the header is line 1. The number is `None` if the row was not read from a
    /// file.
    pub fn lined(&self) -> impl Iterator<Item = (Option<u64>, &R)> {
        self.lines.iter().copied().zip(&self.rows)
    }

    /// True if the file has rows that are missing here: rows that an earlier folder has, or rows of an unfinished
    /// scene.
    #[must_use]
    pub fn is_part(&self) -> bool {
        self.is_part
    }

    /// Adds a row that is not in a file.
    pub fn push(&mut self, row: R) {
        self.rows.push(row);
        self.lines.push(None);
    }

    /// Keeps only the rows for which `keep` is true.
    pub fn retain(&mut self, mut keep: impl FnMut(&R) -> bool) {
        let before = self.len();
        self.edit(|rows| rows.retain(|(_, row)| keep(row)));
        self.is_part |= self.len() < before;
    }

    /// Sorts rows by a key; rows with equal keys keep their order.
    pub fn sort_by_cached_key<K: Ord>(&mut self, mut key: impl FnMut(&R) -> K) {
        self.edit(|rows| rows.sort_by_cached_key(|(_, row)| key(row)));
    }

    /// Changes the list of rows together with their lines.
    pub fn edit(&mut self, change: impl FnOnce(&mut Vec<(Option<u64>, R)>)) {
        let (lines, rows) = (std::mem::take(&mut self.lines), std::mem::take(&mut self.rows));
        let mut lined = lines.into_iter().zip(rows).collect();
        change(&mut lined);
        (self.lines, self.rows) = lined.into_iter().unzip();
    }

    /// The rows in their order, mutable.
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, R> {
        self.rows.iter_mut()
    }
}

impl<R> Default for Rows<R> {
    fn default() -> Rows<R> {
        Rows { rows: Vec::new(), lines: Vec::new(), is_part: false }
    }
}

/// Rows that are not in a file.
impl<R> From<Vec<R>> for Rows<R> {
    fn from(rows: Vec<R>) -> Rows<R> {
        Rows { lines: vec![None; rows.len()], rows, is_part: false }
    }
}

/// Rows that are not in a file.
impl<R> Extend<R> for Rows<R> {
    fn extend<I: IntoIterator<Item = R>>(&mut self, rows: I) {
        for row in rows {
            self.push(row);
        }
    }
}

/// The rows without their lines.
impl<R> From<Rows<R>> for Vec<R> {
    fn from(rows: Rows<R>) -> Vec<R> {
        rows.rows
    }
}

impl<R> Deref for Rows<R> {
    type Target = [R];

    fn deref(&self) -> &[R] {
        &self.rows
    }
}

impl<R> Index<usize> for Rows<R> {
    type Output = R;

    fn index(&self, at: usize) -> &R {
        &self.rows[at]
    }
}

impl<R> IndexMut<usize> for Rows<R> {
    fn index_mut(&mut self, at: usize) -> &mut R {
        &mut self.rows[at]
    }
}

impl<R> IntoIterator for Rows<R> {
    type Item = R;
    type IntoIter = std::vec::IntoIter<R>;

    fn into_iter(self) -> Self::IntoIter {
        self.rows.into_iter()
    }
}

impl<'r, R> IntoIterator for &'r Rows<R> {
    type Item = &'r R;
    type IntoIter = std::slice::Iter<'r, R>;

    fn into_iter(self) -> Self::IntoIter {
        self.rows.iter()
    }
}

impl<'r, R> IntoIterator for &'r mut Rows<R> {
    type Item = &'r mut R;
    type IntoIter = std::slice::IterMut<'r, R>;

    fn into_iter(self) -> Self::IntoIter {
        self.rows.iter_mut()
    }
}

impl<R: PartialEq> PartialEq<Vec<R>> for Rows<R> {
    fn eq(&self, rows: &Vec<R>) -> bool {
        self.rows == *rows
    }
}

impl<R: PartialEq, const N: usize> PartialEq<[R; N]> for Rows<R> {
    fn eq(&self, rows: &[R; N]) -> bool {
        self.rows == *rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_keep_their_lines() {
        let mut rows = Rows::read([(2, "b"), (3, "c"), (7, "a")], false);
        rows.sort_by_cached_key(|row| *row);
        assert_eq!(rows.lined().collect::<Vec<_>>(), [(Some(7), &"a"), (Some(2), &"b"), (Some(3), &"c")]);
        rows.retain(|_| true);
        assert!(!rows.is_part());
        rows.retain(|row| *row != "b");
        rows.push("d");
        assert_eq!(rows.lined().collect::<Vec<_>>(), [(Some(7), &"a"), (Some(3), &"c"), (None, &"d")]);
        assert!(rows.is_part(), "the file has another");
    }
}
