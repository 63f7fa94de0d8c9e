//! Right answers with planted faults, which prove that the checks find faults that no backend has.

use crate::algorithm::Place;

use super::{Cells, CellsFound, Interval};
use predicament_tasks::{Class, Spoiled};

pub(super) fn all() -> Vec<Spoiled<Interval>> {
    vec![
        Spoiled::new(
            "interval-loses-a-point",
            "the first point in a cell is reported in no cell",
            "exact",
            &[(Class::Topology, "gap")],
            |_, _, answer: &mut CellsFound| {
                if let Some(found) = answer.0.iter_mut().find(|found| !found.is_empty()) {
                    found.clear();
                }
            },
        ),
        Spoiled::new(
            "interval-stray-point",
            "the first point in no cell is reported in the first cell",
            "exact",
            &[(Class::Topology, "stray")],
            |_, _, answer: &mut CellsFound| {
                if let Some(found) = answer.0.iter_mut().find(|found| found.is_empty()) {
                    found.push((0, Place::Inside));
                }
            },
        ),
        Spoiled::new(
            "interval-unbroken-tie",
            "points in a cell are reported at its end and at the end of the next cell",
            "sos",
            &[(Class::Inconsistent, "never zero")],
            |_, content: &Cells, answer: &mut CellsFound| {
                let last = content.cells.len().saturating_sub(1);
                for_each_inside(answer, |cell| {
                    let both = if cell < last { [cell, cell + 1] } else { [cell.saturating_sub(1), cell] };
                    both.map(|cell| (cell, Place::AtEnd)).to_vec()
                });
            },
        ),
        Spoiled::new(
            "interval-takes-an-end",
            "a point at the ends of two cells is reported in the first of these cells",
            "exact",
            &[(Class::MissedZero, "cells")],
            |_, _, answer: &mut CellsFound| {
                for found in answer.0.iter_mut().filter(|found| found.len() == 2) {
                    *found = vec![(found[0].0, Place::Inside)];
                }
            },
        ),
        Spoiled::new(
            "interval-next-cell",
            "points are reported in a neighbour of their cell",
            "exact",
            &[(Class::SignFlip, "cells")],
            |_, content: &Cells, answer: &mut CellsFound| {
                let last = content.cells.len().saturating_sub(1);
                for_each_inside(answer, |cell| {
                    vec![(if cell < last { cell + 1 } else { cell.saturating_sub(1) }, Place::Inside)]
                });
            },
        ),
    ]
}

/// Replaces the cells of each point that is inside one cell.
fn for_each_inside(answer: &mut CellsFound, with: impl Fn(usize) -> Vec<(usize, Place)>) {
    for found in &mut answer.0 {
        if let [(cell, Place::Inside)] = found[..] {
            *found = with(cell);
        }
    }
}
