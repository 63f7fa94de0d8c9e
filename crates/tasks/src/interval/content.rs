//! `cells`: a row of cells of a line, and points to find in them.

use predicament_corpus::{Canon, Content};
use predicament_formats::{CorpusError, Fields, read_points};
use predicament_predicates::{Axis, Dimension, Scene, Vertex};

use crate::signs::axis;

/// A row of cells of a line, and points to find in them.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cells {
    /// The line's direction.
    pub axis: Axis,
    /// The cells from left to right, each by its left and its right end,
    /// which is the left end of the next. Ends with equal coordinates come
    /// by descending number, as Simulation of Simplicity orders them.
    pub cells: Vec<[Vertex; 2]>,
    /// What to locate.
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
}

/// Reads `points`, `axis` and `cells`; every point that ends no cell is a probe.
pub(super) fn read(fields: &Fields<'_, '_>) -> Result<(Scene, Cells), CorpusError> {
    let field = fields.required("points")?;
    let (dimension, coordinates) = read_points(&field)?;
    let scene =
        Scene::new(dimension, coordinates).map_err(|error| field.error(error.to_string(), "correct the points"))?;
    let axis = axis(fields)?;
    if axis == Axis::Z && dimension == Dimension::Two {
        return Err(fields.error("points of two coordinates have no z", "choose axis x or y"));
    }
    let mut cells: Vec<[Vertex; 2]> = Vec::new();
    let mut is_end = vec![false; scene.len()];
    for item in fields.required("cells")?.items("cells: arrays of the indices of two points")? {
        let ends: Vec<Vertex> =
            item.items("a cell: the indices of two points")?.map(|end| end.point()).collect::<Result<_, _>>()?;
        let count = ends.len();
        let [left, right] = ends
            .try_into()
            .map_err(|_| item.error(format!("a cell of {count} ends"), "write the indices of two points"))?;
        if let Some(unknown) = [left, right].into_iter().find(|end| end.index() >= scene.len()) {
            let message = format!("the end {unknown} is out of range: the scene has {} points", scene.len());
            return Err(item.error(message, "indices count from 0"));
        }
        if let Some([_, before]) = cells.last()
            && *before != left
        {
            let message = format!("the cell begins at {left}, the one before it ends at {before}");
            return Err(item.error(message, "write cells from left to right, each from the end of the one before"));
        }
        let [from, to] = [left, right].map(|end| scene.coordinate(axis, end));
        if from > to || (from == to && left <= right) {
            let message = format!("the cell from {left} at {from} to {right} at {to} goes to the left, or nowhere");
            let cure = "write the left end first; of two ends at one place that with the larger index, \
                        which symbolic perturbation moves less";
            return Err(item.error(message, cure));
        }
        is_end[left.index()] = true;
        is_end[right.index()] = true;
        cells.push([left, right]);
    }
    let probes: Vec<Vertex> = scene.vertices().filter(|vertex| !is_end[vertex.index()]).collect();
    if cells.is_empty() || probes.is_empty() {
        let message = format!("interval has {} cells and {} other points", cells.len(), probes.len());
        return Err(fields.error(message, "write at least one of each: every point that ends no cell is located"));
    }
    Ok((scene, Cells { axis, cells, probes }))
}
