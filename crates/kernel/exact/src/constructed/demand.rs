//! The rows of constructed vertices, computed on first use.
//!
//! The row of a constructed vertex depends only on definitions and coordinates, so the result does not depend on which
//! thread asks first. The vertices that define a vertex come before it: their rows are computed first, one by one from
//! a work list, as a cascade can be deeper than the stack.

use alloc::vec;
use predicament_predicates::{Construction, NoPoint, Vertex};

use super::points;
use super::rows::{Found, Row, View};

impl<'a> View<'a> {
    /// A vertex with its exact coordinates.
    ///
    /// # Panics
    /// If there is no such vertex.
    #[inline(always)]
    pub fn find(self, v: Vertex) -> Found<'a> {
        match v.construction() {
            None => Found::Input(self.scene.point(v)),
            Some(index) => Found::Constructed(self.row(index)),
        }
    }

    /// The row of the constructed vertex with this index, which is known to have a point.
    ///
    /// # Panics
    /// If there is no such vertex.
    #[inline(always)]
    pub fn row(self, index: usize) -> &'a Row {
        self.computed(index).unwrap_or_else(|| self.row_and_before(index))
    }

    /// Computes the row for [`View::row`], after the rows that it depends on.
    #[cold]
    #[inline(never)]
    fn row_and_before(self, index: usize) -> &'a Row {
        self.compute_before(index);
        let row = || points::row(self, self.definition(index)).expect("it is certain that there is a point");
        self.slot(index).get_or_init(row)
    }

    /// The row of the last constructed vertex, or the reason why it has no point.
    pub fn admit(self) -> Result<&'a Row, NoPoint> {
        let last = self.rows.count - 1;
        self.compute_before(last);
        let row = points::row(self, self.definition(last))?;
        Ok(self.slot(last).get_or_init(|| row))
    }

    /// Computes the rows of the vertices that define a vertex.
    fn compute_before(self, index: usize) {
        if self.definition(index).is_of_inputs() {
            return;
        }
        let mut stack = vec![index];
        while let Some(&top) = stack.last() {
            let before = stack.len();
            let definition = self.definition(top);
            let vertices = definition.flats().flatten().filter_map(|v| v.construction());
            stack.extend(vertices.filter(|&v| self.slot(v).get().is_none()));
            if stack.len() == before {
                stack.pop();
                if top != index {
                    let row = || points::row(self, definition).expect("it is certain that there is a point");
                    self.slot(top).get_or_init(row);
                }
            }
        }
    }

    fn definition(self, index: usize) -> &'a Construction {
        &self.scene.constructions()[index]
    }
}
