//! Cells of the plane with the segments near them and the sum of the labels above them.
//!
//! The segments are boundaries: each has a label, a set. At every vertex, each member is in the labels of an even
//! number of segments, as for closed boundaries. A query asks for the *cover* of a point: the sum modulo 2 of the
//! labels of all segments that an upward ray from it crosses. The ray crosses a segment iff the point is below it and
//! is *past* exactly one of its ends. Past an end is one bit, here whether the point's x is larger.
//!
//! # One row at a time
//! A ray from a cell is long, and most crossings are the same for all points of the cell. The ray crosses a segment
//! above the row iff the point is past one end only. So the labels of these segments sum up to
//!
//! > Σ over vertices v: past(v) · Σ of the labels of segments above the row at v.
//!
//! If all segments at v are above the row, the inner sum is zero, because all labels at v sum up to zero. Otherwise it
//! is the sum of the labels of the other segments at v. Such a segment leaves the row through its top, and v is its
//! upper end. So the sum above a row needs only the segments that leave the row upward, each at its upper end. There
//! are three kinds of upper ends:
//! * Ends in columns to the left are past for every point of the cell; they are summed up beforehand.
//! * Ends in columns to the right are not past.
//! * Ends in the cell's own column are the *pivots* of the cell; they are tested for each point. A segment with a pivot
//!   in a cell reaches that cell, so it is already listed there.
//!
//! The method does not depend on how a tie at x is broken, as long as past(v) is one bit per vertex and point: the
//! caller may use any predicate.
//!
//! # How many cells
//! Rows and columns are equally spaced, and there are about four times as many cells as segments. If segments are long,
//! there are fewer cells, so that there are never more than four entries per segment.

use crate::steps::{Steps, extent};

type Segment = [[f64; 2]; 2];

/// The maximum number of cells, and of entries, per segment.
const PER_SEGMENT: usize = 4;

/// A running sum of labels modulo 2.
pub trait Labels {
    /// Resets the sum to the empty set.
    fn clear(&mut self);
    /// Adds the label of a segment.
    fn toggle(&mut self, segment: u32);
    /// A number that identifies the sum to the caller.
    fn number(&mut self) -> u32;
}

/// The first or the second end of a segment.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum End {
    /// The end that was given first.
    First,
    /// The other end.
    Second,
}

/// A segment that reaches a cell.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Both ends, as the caller gave them.
    pub ends: Segment,
    /// The index of the segment.
    pub segment: u32,
    /// The end that is above the cell's row and in its column: the label counts once more for points past it.
    pub pivot: Option<End>,
}

impl Entry {
    /// The lowest and the highest y of the segment.
    #[inline]
    #[must_use]
    pub fn y_range(&self) -> [f64; 2] {
        let [[_, a], [_, b]] = self.ends;
        if a <= b { [a, b] } else { [b, a] }
    }
}

/// The data of a cell.
///
/// The cover of a point of the cell is the sum of three parts: `above`, the labels of entries with a pivot that the
/// point is past, and the labels of entries that the ray crosses.
#[derive(Clone, Copy, Debug)]
pub struct Cell<'a> {
    /// The number of the sum of all labels that count once for every point of the cell.
    pub above: u32,
    /// The segments whose boxes reach the cell, by ascending index.
    pub entries: &'a [Entry],
}

#[derive(Clone, Copy, Default, Debug)]
struct Head {
    /// The index of the first entry.
    start: u32,
    above: u32,
}

/// A grid of equal cells over closed boundaries in the plane.
#[derive(Clone, Debug)]
pub struct Cells {
    grid: Grid,
    /// The cells, row after row, and one more that ends the last.
    heads: Vec<Head>,
    entries: Vec<Entry>,
}

impl Cells {
    /// A grid over these segments, given by both ends.
    ///
    /// # Panics
    /// If there are 2^32 segments or more, or a coordinate is not finite.
    #[must_use]
    pub fn new(segments: &[Segment], labels: &mut impl Labels) -> Cells {
        assert!(segments.as_flattened().as_flattened().iter().all(|c| c.is_finite()), "coordinates must be finite");
        let grid = Grid::over(segments);
        let mut cells = Cells { heads: vec![Head::default(); grid.len() + 1], entries: Vec::new(), grid };
        cells.enter(segments);
        cells.sum_up(segments, labels);
        cells
    }

    /// The number of cells; at least one.
    #[must_use]
    pub fn count(&self) -> usize {
        self.grid.len()
    }

    /// The number of entries in all cells.
    #[must_use]
    pub fn entries(&self) -> usize {
        self.entries.len()
    }

    /// The cell of all points with this x and a y from `low` to `high`; `None` if they are in several cells. A segment
    /// whose x-range contains x and that the cell does not list is strictly above `high` or strictly below `low`.
    #[inline]
    #[must_use]
    pub fn at(&self, x: f64, [low, high]: [f64; 2]) -> Option<Cell<'_>> {
        let row = self.grid.rows.of(low);
        if row != self.grid.rows.of(high) {
            return None;
        }
        let cell = self.grid.cell([row, self.grid.columns.of(x)]);
        let [head, next] = [self.heads[cell], self.heads[cell + 1]];
        Some(Cell { above: head.above, entries: &self.entries[head.start as usize..next.start as usize] })
    }

    fn enter(&mut self, segments: &[Segment]) {
        for segment in segments {
            for place in self.grid.reached(segment) {
                self.heads[self.grid.cell(place)].start += 1;
            }
        }
        // from counts to ends; filled from the last entry back, they become starts
        let mut end = 0;
        for head in &mut self.heads {
            end += head.start;
            head.start = end;
        }
        let blank = Entry { ends: [[0.0; 2]; 2], segment: 0, pivot: None };
        self.entries = vec![blank; end as usize];
        for (segment, number) in segments.iter().zip(numbers(segments)).rev() {
            let (upper, end) = upper_end(segment);
            let [top, column_of_upper] = self.grid.place(upper);
            for [row, column] in self.grid.reached(segment) {
                let is_pivot = row < top && column == column_of_upper;
                let at = &mut self.heads[self.grid.cell([row, column])].start;
                *at -= 1;
                self.entries[*at as usize] = Entry { ends: *segment, segment: number, pivot: is_pivot.then_some(end) };
            }
        }
    }

    /// Sums up along each row the labels of ends that are past from the next column on.
    fn sum_up(&mut self, segments: &[Segment], labels: &mut impl Labels) {
        let mut past: Vec<(usize, u32)> = Vec::new();
        for (segment, number) in segments.iter().zip(numbers(segments)) {
            let [_, column] = self.grid.place(upper_end(segment).0);
            if column + 1 < self.grid.columns.count() {
                let [[bottom, top], _] = self.grid.ranges(segment);
                past.extend((bottom..top).map(|row| (self.grid.cell([row, column + 1]), number)));
            }
        }
        past.sort_unstable();
        let mut news = past.chunk_by(|a, b| a.0 == b.0).peekable();
        let mut above = 0;
        for (cell, head) in self.heads.iter_mut().enumerate() {
            if cell % self.grid.columns.count() == 0 {
                labels.clear();
                above = labels.number();
            }
            if let Some(news) = news.next_if(|news| news[0].0 == cell) {
                news.iter().for_each(|&(_, segment)| labels.toggle(segment));
                above = labels.number();
            }
            head.above = above;
        }
    }
}

fn numbers(segments: &[Segment]) -> std::ops::Range<u32> {
    0..u32::try_from(segments.len()).expect("a grid holds fewer than 2^32 segments")
}

/// The higher end of a segment. If both ends are equally high, no row lies between them, and either is correct.
fn upper_end(&[a, b]: &Segment) -> ([f64; 2], End) {
    if a[1] > b[1] { (a, End::First) } else { (b, End::Second) }
}

/// The geometry of the cells.
#[derive(Clone, Copy, Debug)]
struct Grid {
    columns: Steps,
    rows: Steps,
}

impl Grid {
    /// A grid with the maximum number of cells, or fewer if these have too many entries: it halves the columns or the
    /// rows, whichever are crossed more.
    fn over(segments: &[Segment]) -> Grid {
        let x = extent(segments.as_flattened().iter().map(|end| end[0]));
        let y = extent(segments.as_flattened().iter().map(|end| end[1]));
        let most = PER_SEGMENT * segments.len();
        let side = most.isqrt().max(1);
        let mut counts = [side; 2];
        loop {
            let grid = Grid { columns: Steps::new(x, counts[0]), rows: Steps::new(y, counts[1]) };
            let mut cuts = [0, 0];
            let mut entries = 0_usize;
            for segment in segments {
                let [rows, columns] = grid.ranges(segment).map(|[low, high]| high - low);
                cuts[0] += columns;
                cuts[1] += rows;
                entries = entries.saturating_add((columns + 1).saturating_mul(rows + 1));
            }
            // One cell has an entry for each segment, which are fewer than 2^32: the loop ends there at the latest.
            if entries <= most && u32::try_from(entries).is_ok() {
                return grid;
            }
            let more = usize::from(cuts[1] > cuts[0]);
            counts[more] = counts[more].div_ceil(2);
        }
    }

    fn len(&self) -> usize {
        self.rows.count() * self.columns.count()
    }

    #[inline]
    fn cell(&self, [row, column]: [usize; 2]) -> usize {
        row * self.columns.count() + column
    }

    /// The row and the column of a point.
    fn place(&self, [x, y]: [f64; 2]) -> [usize; 2] {
        [self.rows.of(y), self.columns.of(x)]
    }

    /// The first and the last row and column that a segment's box reaches.
    fn ranges(&self, segment: &Segment) -> [[usize; 2]; 2] {
        let [a, b] = segment.map(|end| self.place(end));
        [0, 1].map(|axis| [a[axis].min(b[axis]), a[axis].max(b[axis])])
    }

    fn reached(&self, segment: &Segment) -> impl Iterator<Item = [usize; 2]> + use<> {
        let [[bottom, top], [left, right]] = self.ranges(segment);
        (bottom..=top).flat_map(move |row| (left..=right).map(move |column| [row, column]))
    }
}
