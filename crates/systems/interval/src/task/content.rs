//! The key `cells`: a row of cells of a line, and probes.

use predicament_corpus::{
    Canon, Content, Context, Elsewhere, Items, Level, List, Parts, PointSource, Source, Spelled, spelled_points,
};
use predicament_formats::{Cache, CorpusError, Entry, Fields};
use predicament_predicates::{Axis, Dimension, Scene, Vertex};

use predicament_tasks::signs::axis;

/// A row of cells of a line, and points to locate in them.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cells {
    /// The line's direction.
    pub axis: Axis,
    /// The cells from left to right, each by its left and its right end; the right end is the left end of the next
    /// cell. Ends with equal coordinates come by descending index, as Simulation of Simplicity orders them.
    pub cells: Vec<[Vertex; 2]>,
    /// The points to locate.
    pub probes: Vec<Vertex>,
}

impl Content for Cells {
    fn count(&self) -> usize {
        self.probes.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("interval");
        canon.count(self.axis.index());
        canon.vertices(self.cells.as_flattened());
        canon.vertices(&self.probes);
    }

    /// Points that do not end a cell are probes. The id includes the order of the probes; a suite lists them only in
    /// the order of their indices. In another order the id differs.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let words = vec![("axis", format!("\"{}\"", self.axis.name()))];
        Some(Spelled {
            words,
            lists: vec![List::required("cells", Items::tuples(&self.cells))],
            ..spelled_points(scene)
        })
    }
}

/// Reads `points`, `axis` and `cells`; every point that does not end a cell is a probe.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let points = PointSource::read(context, &fields.required("points")?, fields.file())?;
    let axis = axis(fields)?;
    let mut cells = Vec::new();
    for item in fields.required("cells")?.items("cells: arrays with the indices of two points")? {
        let ends: Vec<Vertex> =
            item.items("a cell: the indices of two points")?.map(|end| end.point()).collect::<Result<_, _>>()?;
        let count = ends.len();
        let ends: [Vertex; 2] = ends
            .try_into()
            .map_err(|_| item.error(format!("a cell with {count} ends"), "write the indices of two points"))?;
        cells.push((item.line(), ends));
    }
    let asked = Asked { points, axis, cells, file: fields.file().to_owned(), line: fields.line() };
    if asked.points.is_written() {
        // Nothing comes from the cache: everything is written out.
        return Ok(Source::Written(asked.load(Level::Quick, &Cache::new(""))?));
    }
    Ok(Source::elsewhere(asked))
}

/// The source of cells between points that are written out or in a data file.
struct Asked {
    points: PointSource,
    axis: Axis,
    /// Each cell with its line in the suite.
    cells: Vec<(usize, [Vertex; 2])>,
    file: String,
    line: usize,
}

impl Elsewhere for Asked {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (scene, notes) = self.points.scene(cache)?;
        let cells = self.cells(&scene)?;
        Ok(Parts { notes, ..Parts::new(scene, cells) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.points.entry()
    }
}

impl Asked {
    /// The cells, checked, and the probes.
    fn cells(&self, scene: &Scene) -> Result<Cells, CorpusError> {
        let error =
            |line: usize, message: String, cure: &str| Err(CorpusError::file(&self.file, message, cure).at_line(line));
        let axis = self.axis;
        if axis == Axis::Z && scene.dimension() == Dimension::Two {
            return error(self.line, "points with two coordinates have no z".to_owned(), "choose axis x or y");
        }
        let mut cells: Vec<[Vertex; 2]> = Vec::with_capacity(self.cells.len());
        let mut is_end = vec![false; scene.len()];
        for &(line, [left, right]) in &self.cells {
            if let Some(unknown) = [left, right].into_iter().find(|end| end.index() >= scene.len()) {
                let message = format!("the end {unknown} is out of range: the scene has {} points", scene.len());
                return error(line, message, "indices count from 0");
            }
            if let Some([_, before]) = cells.last()
                && *before != left
            {
                let message = format!("the cell begins at {left}, the one before it ends at {before}");
                return error(line, message, "write cells from left to right, each from the end of the one before");
            }
            let [from, to] = [left, right].map(|end| scene.coordinate(axis, end));
            if from > to || (from == to && left <= right) {
                let message =
                    format!("the cell from {left} at {from} to {right} at {to} goes to the left, or has no length");
                let cure = "write the left end first; if both ends are at one place, the end with the larger index, \
                            because symbolic perturbation moves it less";
                return error(line, message, cure);
            }
            is_end[left.index()] = true;
            is_end[right.index()] = true;
            cells.push([left, right]);
        }
        let probes: Vec<Vertex> = scene.vertices().filter(|vertex| !is_end[vertex.index()]).collect();
        if cells.is_empty() || probes.is_empty() {
            let message = format!("interval has {} cells and {} other points", cells.len(), probes.len());
            let cure = "write at least one of each: every point that is not an end is located";
            return error(self.line, message, cure);
        }
        Ok(Cells { axis, cells, probes })
    }
}
