//! Vertical strips of the plane, for finding the segments that a vertical ray can meet.
//!
//! An upward ray from a point meets only segments whose x-range contains the point's x and that reach up to the point.
//! The index therefore cuts the plane into columns, and enters each segment in every column that it reaches. A column
//! lists its segments from the highest down: a query reads one column and stops at the first segment that ends below
//! it.
//!
//! # How many columns
//! Let w be the width of a column and m the mean x-extent of n segments. There are about n(1 + m/w) entries, and a
//! column holds about 1 + w/m times the segments that a vertical line meets. At w = m/2 both overheads are small: 3n
//! entries, and 1.5 times the necessary entries per query. There are never more columns than segments.

use crate::steps::{Steps, extent};

/// The part of a segment that is in one column.
#[derive(Clone, Copy, Debug)]
struct Entry {
    low: f64,
    high: f64,
    top: f64,
    segment: u32,
}

impl Entry {
    #[inline]
    fn holds(&self, x: f64) -> bool {
        (self.low <= x) & (x <= self.high)
    }
}

/// A column index over segments of the plane; a segment is identified by its index 0, 1, 2 …
#[derive(Clone, Debug)]
pub struct Columns {
    steps: Steps,
    /// The index of each column's first entry, and at the end the number of entries.
    starts: Vec<usize>,
    /// The entries, column after column; in each from the highest `top` down, ties by index.
    entries: Vec<Entry>,
    /// The lowest y of each segment.
    bottoms: Vec<f64>,
}

impl Columns {
    /// An index of these segments, given by both ends.
    ///
    /// # Panics
    /// If there are 2^32 segments or more, or a coordinate is not finite.
    #[must_use]
    pub fn new(segments: &[[[f64; 2]; 2]]) -> Columns {
        assert!(u32::try_from(segments.len()).is_ok(), "a column index holds fewer than 2^32 segments");
        assert!(segments.as_flattened().as_flattened().iter().all(|c| c.is_finite()), "coordinates must be finite");

        let low = |&[a, b]: &[[f64; 2]; 2]| a[0].min(b[0]);
        let high = |&[a, b]: &[[f64; 2]; 2]| a[0].max(b[0]);
        let [left, right] = extent(segments.as_flattened().iter().map(|end| end[0]));
        let half_extent = if segments.is_empty() { 0.0 } else { right / 2.0 - left / 2.0 };
        let covered = segments.iter().map(|s| (high(s) / 2.0 - low(s) / 2.0) / half_extent).sum();
        let steps = Steps::new([left, right], column_count(segments.len(), half_extent, covered));
        let count = steps.count();
        let mut columns = Columns {
            steps,
            starts: vec![0; count + 1],
            entries: Vec::new(),
            bottoms: segments.iter().map(|[a, b]| a[1].min(b[1])).collect(),
        };

        for segment in segments {
            for column in columns.column(low(segment))..=columns.column(high(segment)) {
                columns.starts[column + 1] += 1;
            }
        }
        for column in 0..count {
            columns.starts[column + 1] += columns.starts[column];
        }

        // The segments are entered from the highest down, so every column is sorted.
        let entry_of = |(segment, place): (&[[f64; 2]; 2], u32)| {
            let top = segment[0][1].max(segment[1][1]);
            Entry { low: low(segment), high: high(segment), top, segment: place }
        };
        let mut by_top: Vec<Entry> = segments.iter().zip(0..).map(entry_of).collect();
        by_top.sort_unstable_by(|a, b| b.top.total_cmp(&a.top).then(a.segment.cmp(&b.segment)));
        let mut next = columns.starts.clone();
        let blank = Entry { low: 0.0, high: 0.0, top: 0.0, segment: 0 };
        columns.entries = vec![blank; columns.starts[count]];
        for entry in by_top {
            for next in &mut next[columns.column(entry.low)..=columns.column(entry.high)] {
                columns.entries[*next] = entry;
                *next += 1;
            }
        }
        columns
    }

    /// The number of columns; at least one.
    #[must_use]
    pub fn count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The number of entries in all columns, as a measure of memory.
    #[must_use]
    pub fn entries(&self) -> usize {
        self.entries.len()
    }

    /// The segments that an upward ray from `point` can meet, each once, from the highest down.
    ///
    /// These are the segments whose closed x-range contains the point's x and whose highest y is not below the point's
    /// by more than `reach`. The rule does not depend on the columns, except that a positive `reach` is rounded up.
    #[inline]
    pub fn above(&self, point: [f64; 2], reach: f64) -> impl Iterator<Item = u32> + '_ {
        let [x, _] = point;
        let entries = self.reaching_up_to(point, reach).iter();
        entries.filter(move |entry| entry.holds(x)).map(|entry| entry.segment)
    }

    /// The entries of the point's column, without those that end too far below it.
    #[inline]
    fn reaching_up_to(&self, [x, y]: [f64; 2], reach: f64) -> &[Entry] {
        let floor = if reach == 0.0 { y } else { (y - reach).next_down() };
        let entries = self.of(self.column(x));
        let end = entries.iter().position(|entry| entry.top < floor).unwrap_or(entries.len());
        &entries[..end]
    }

    /// The pairs of segments whose closed boxes meet, smaller index first. Every such pair comes in exactly one of the
    /// columns.
    pub fn overlaps(&self, column: usize) -> impl Iterator<Item = [u32; 2]> + '_ {
        let entries = self.of(column);
        entries.iter().enumerate().flat_map(move |(at, a)| {
            let bottom = self.bottoms[a.segment as usize];
            entries[at + 1..]
                .iter()
                .take_while(move |b| b.top >= bottom)
                // a pair belongs to the first column that both reach
                .filter(move |b| a.low <= b.high && b.low <= a.high && self.column(a.low.max(b.low)) == column)
                .map(|b| [a.segment.min(b.segment), a.segment.max(b.segment)])
        })
    }

    fn of(&self, column: usize) -> &[Entry] {
        &self.entries[self.starts[column]..self.starts[column + 1]]
    }

    #[inline]
    fn column(&self, x: f64) -> usize {
        self.steps.of(x)
    }
}

/// The number of columns: each about half as wide as the mean segment. `covered` is the sum of the segments' extents as
/// fractions of the whole extent.
#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a size to aim at
fn column_count(segments: usize, half_extent: f64, covered: f64) -> usize {
    if half_extent == 0.0 {
        return 1;
    }
    ((2.0 * segments as f64 / covered) as usize).clamp(1, segments.max(1))
}
