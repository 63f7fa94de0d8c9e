//! Cells of the plane with the segments that pass through them.
//!
//! A segment is entered only in the cells that it passes through, not in all cells of its box: a long diagonal is in as
//! many cells as a horizontal segment of the same length.
//!
//! # Why no common point is missed
//! Coordinates are mapped to units of cells, in doubles: a halving, a subtraction and a multiplication. So each is
//! within 2^-50 of its own size, and so within 2^-38, of the exact image. The place where a segment passes a row is
//! interpolated from these. A segment that rises by less than a quarter of a row is taken with its whole width.
//! Otherwise the quotient's error is below 2^-35 and the error of the width times it below 2^-22. Every bound is moved
//! outward by [`MARGIN`], which is more. So the cell of a segment's point lists the segment, and two segments with a
//! common point are in one cell together.
//!
//! # How many cells
//! One for a few segments, otherwise about two for each segment. If segments are long, there are fewer: at most about
//! four entries per segment.

use std::ops::Range;

use crate::parallel;
use crate::steps::extent;

/// A segment by its ends.
type Segment = [[f64; 2]; 2];

/// The distance by which bounds are moved outward, in units of a cell.
const MARGIN: f64 = 1.0 / 1024.0;
/// The maximum number of rows, and of columns.
const MOST: f64 = 4096.0;
/// Cells per segment.
const CELLS: f64 = 2.0;
/// Entries per segment beyond the first, along each axis.
const CROSSED: f64 = 1.5;
/// The number of segments below which there is one cell: pairs are compared sooner than entered in cells.
const FEW: usize = 24;
/// The extent below which halving is not exact: such an extent is one cell.
const SMALLEST: f64 = 1e-290;

/// The map of coordinates along an axis to units of cells.
#[derive(Clone, Copy, Debug)]
struct Axis {
    origin: f64,
    scale: f64,
    count: usize,
}

impl Axis {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 1 to `MOST`
    fn new([low, high]: [f64; 2], count: f64) -> Axis {
        let half_extent = high / 2.0 - low / 2.0;
        if half_extent > SMALLEST {
            let count = count.clamp(1.0, MOST).floor();
            Axis { origin: low / 2.0, scale: count / half_extent, count: count as usize }
        } else {
            Axis { origin: 0.0, scale: 0.0, count: 1 }
        }
    }

    #[inline]
    fn place(&self, x: f64) -> f64 {
        (x / 2.0 - self.origin) * self.scale
    }

    /// The cells from a little before one place to a little after another.
    #[inline]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // `as` saturates, which is the clamp we want
    fn cells(&self, low: f64, high: f64) -> [usize; 2] {
        [((low - MARGIN) as usize).min(self.count - 1), ((high + MARGIN) as usize).min(self.count - 1)]
    }
}

/// A uniform grid over segments; a segment is identified by its index 0, 1, 2 ….
#[derive(Clone, Debug)]
pub struct Raster {
    columns: Axis,
    rows: Axis,
    /// The index of each cell's first entry, row after row, and at the end the number of entries.
    starts: Vec<u32>,
    entries: Vec<u32>,
}

impl Raster {
    /// A grid over these segments.
    ///
    /// # Panics
    /// If there are 2^30 segments or more.
    #[must_use]
    pub fn new(segments: &[Segment]) -> Raster {
        assert!(segments.len() < 1 << 30, "a raster holds fewer than 2^30 segments");
        let [columns, rows] = axes(segments);
        let mut raster = Raster { columns, rows, starts: Vec::new(), entries: Vec::new() };
        // Each thread enters all segments in rows of its own.
        let threads = parallel::threads(segments.len());
        let bands = parallel::in_parts(rows.count, threads, &|rows| raster.band(segments, &rows));
        (raster.starts, raster.entries) = bands.joined(|(starts, entries), (own, mut band)| {
            let before = number(entries.len());
            starts.extend(own.iter().map(|start| before + start));
            entries.append(&mut band);
        });
        raster.starts.push(number(raster.entries.len()));
        raster
    }

    /// The index of the first entry of each cell in some rows, and the entries.
    fn band(&self, segments: &[Segment], rows: &Range<usize>) -> (Vec<u32>, Vec<u32>) {
        let base = rows.start * self.columns.count;
        let mut starts = Vec::with_capacity(rows.len() * self.columns.count + 1);
        starts.resize(rows.len() * self.columns.count, 0_u32);
        for segment in segments {
            self.pass(segment, rows, |first, last| {
                starts[first - base..=last - base].iter_mut().for_each(|count| *count += 1);
            });
        }
        // From counts to ends; filled from the last entry back, they become starts.
        let mut end = 0;
        for start in &mut starts {
            end += *start;
            *start = end;
        }
        let mut entries = vec![0; end as usize];
        let count = u32::try_from(segments.len()).unwrap_or(u32::MAX);
        for (number, segment) in (0..count).zip(segments).rev() {
            self.pass(segment, rows, |first, last| {
                for start in &mut starts[first - base..=last - base] {
                    *start -= 1;
                    entries[*start as usize] = number;
                }
            });
        }
        (starts, entries)
    }

    /// The number of cells.
    #[must_use]
    pub fn count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The number of entries in all cells.
    #[must_use]
    pub fn entries(&self) -> usize {
        self.entries.len()
    }

    /// The segments that pass through a cell, ascending.
    #[inline]
    #[must_use]
    pub fn cell(&self, cell: usize) -> &[u32] {
        &self.entries[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }

    /// The ends of a segment in units of cells, relative to a cell's lower left corner.
    #[inline]
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // fewer than 2^12 rows and columns
    pub fn seen_from(&self, cell: usize, segment: &Segment) -> Segment {
        let corner = [(cell % self.columns.count) as f64, (cell / self.columns.count) as f64];
        segment.map(|[x, y]| [self.columns.place(x) - corner[0], self.rows.place(y) - corner[1]])
    }

    /// Visits, row by row from `y` upward, the segments in the columns that may contain an x from `low` to `high`. A
    /// segment may be visited several times. Ends when `visit`, given a row's segments and number, returns true.
    pub fn upward(&self, [low, high]: [f64; 2], y: f64, mut visit: impl FnMut(&[u32], usize) -> bool) {
        let [first, last] = self.columns.cells(self.columns.place(low), self.columns.place(high));
        let [lowest, _] = self.rows.cells(self.rows.place(y), self.rows.place(y));
        for row in lowest..self.rows.count {
            let start = row * self.columns.count;
            // The cells of a row are contiguous.
            let [from, to] = [self.starts[start + first], self.starts[start + last + 1]];
            if visit(&self.entries[from as usize..to as usize], row) {
                return;
            }
        }
    }

    /// The last row that may contain a y.
    #[must_use]
    pub fn last_row(&self, y: f64) -> usize {
        self.rows.cells(self.rows.place(y), self.rows.place(y))[1]
    }

    /// Visits for each of some rows the first and the last cell that a segment passes through.
    #[inline]
    #[allow(clippy::cast_precision_loss)] // fewer than 2^12 rows
    fn pass(&self, segment: &Segment, rows: &Range<usize>, mut visit: impl FnMut(usize, usize)) {
        let [[mut ax, mut ay], [mut bx, mut by]] = segment.map(|[x, y]| [self.columns.place(x), self.rows.place(y)]);
        if by < ay {
            ([ax, ay], [bx, by]) = ([bx, by], [ax, ay]);
        }
        let [bottom, top] = self.rows.cells(ay, by);
        let [lowest, end] = [bottom.max(rows.start), (top + 1).min(rows.end)];
        if lowest >= end {
            return;
        }
        let [left, right] = [ax.min(bx), ax.max(bx)];
        let rise = by - ay;
        if bottom == top || rise < 0.25 {
            let [first, last] = self.columns.cells(left, right);
            for row in lowest..end {
                let start = row * self.columns.count;
                visit(start + first, start + last);
            }
            return;
        }
        let slope = (bx - ax) / rise;
        let at = |y: f64| (ax + (y - ay) * slope).clamp(left, right);
        for row in lowest..end {
            let [low, high] = [row as f64 - MARGIN, row as f64 + 1.0 + MARGIN];
            let [x, z] = [at(low.max(ay)), at(high.min(by))];
            let [first, last] = self.columns.cells(x.min(z), x.max(z));
            let start = row * self.columns.count;
            visit(start + first, start + last);
        }
    }
}

fn number(entries: usize) -> u32 {
    u32::try_from(entries).expect("fewer than 2^32 entries")
}

/// Columns and rows for these segments.
#[allow(clippy::cast_precision_loss)] // about
fn axes(segments: &[Segment]) -> [Axis; 2] {
    let extents = [0, 1].map(|axis| extent(segments.as_flattened().iter().map(|end| end[axis])));
    if segments.len() < FEW {
        return extents.map(|extent| Axis::new(extent, 1.0));
    }
    let all = segments.len() as f64;
    // The mean number of cells that a segment crosses along each axis, at one cell per segment length.
    let crossed = [0, 1].map(|axis: usize| {
        let [low, high] = extents[axis];
        let half = (high / 2.0 - low / 2.0).max(f64::MIN_POSITIVE);
        segments.iter().map(|[a, b]| ((a[axis] / 2.0 - b[axis] / 2.0) / half).abs()).sum::<f64>()
    });
    let mut counts = crossed.map(|sum| (CROSSED * all / sum.max(1e-9)).clamp(1.0, MOST));
    let cells = counts[0] * counts[1];
    let most = (CELLS * all).max(1.0);
    if cells > most {
        // Fewer along both axes; if one axis already has one step, all of the reduction along the other.
        let factor = (most / cells).sqrt();
        counts = counts.map(|count| (count * factor).max(1.0));
        let excess = (counts[0] * counts[1] / most).max(1.0);
        counts = counts.map(|count| if count > 1.0 { (count / excess).max(1.0) } else { count });
    }
    [Axis::new(extents[0], counts[0]), Axis::new(extents[1], counts[1])]
}
