//! Generators of cells of a line, and of points at their ends, beside them and between them.

use predicament_corpus::{Family, Parts, Random, Recipe, numbered};
use predicament_formats::bits::integer;
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{Axis, Dimension, Scene, Vertex};

use super::Cells;
use predicament_tasks::signs::axis;

/// The families of cells.
pub(super) static FAMILIES: [Family; 2] = [
    Family {
        name: "cells-uniform",
        reported_as: Some("cells-uniform"),
        parameters: &[],
        about: "cells of a line with ends uniform in [0, 1)",
        read: |_, fields| recipe(Ends::Uniform, fields),
    },
    Family {
        name: "cells-degen",
        reported_as: Some("cells-degen"),
        parameters: &[],
        about: "cells of a line with ends on small integers: many have no length",
        read: |_, fields| recipe(Ends::Repeated, fields),
    },
];

/// Reads `axis` and `dimension`.
fn recipe(ends: Ends, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let axis = axis(fields)?;
    let space = axis == Axis::Z || fields.integer_or("dimension", 2, 2..=3)? == 3;
    let dimension = if space { Dimension::Three } else { Dimension::Two };
    // Ends, and four probes for each.
    let coordinates = move |n| 5 * (n + 1) * dimension.count() as u64;
    Ok(Recipe::new(coordinates, move |making| {
        let (scene, cells) = make(ends, making.n, axis, dimension, &mut making.random());
        Parts::new(scene, cells)
    }))
}

/// The distribution of the ends of cells.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Ends {
    /// Uniform in [0, 1).
    Uniform,
    /// Random among half as many integers as there are cells: rows of cells have zero length.
    Repeated,
}

/// `n` cells along the axis, and probes: three for every end (at it, one double before and one behind), and as many
/// probes anywhere as there are ends.
///
/// Indices of ends are in random order, and the points are anywhere along the other axes.
fn make(ends: Ends, n: usize, axis: Axis, dimension: Dimension, rng: &mut Random) -> (Scene, Cells) {
    let most = i64::try_from(n.div_ceil(2)).expect("scenes are smaller than memory");
    let end = |rng: &mut Random| match ends {
        Ends::Uniform => rng.unit(),
        Ends::Repeated => integer(rng.integer(0, most)),
    };
    let ends: Vec<f64> = (0..=n).map(|_| end(rng)).collect();
    let mut places: Vec<f64> = ends.iter().flat_map(|&end| [end, end.next_down(), end.next_up()]).collect();
    places.extend((0..=n).map(|_| end(rng)));
    let shift = places.len().div_ceil(2);
    let mut order: Vec<usize> = (0..=n).collect();
    order.sort_by(|&a, &b| ends[a].total_cmp(&ends[b]).then(b.cmp(&a)));
    let cells = order.windows(2).map(|pair| [pair[0], pair[1]].map(|end| Vertex::input(end + shift))).collect();
    let (along, probes) = numbered(ends, &places);
    let mut coordinates = Vec::with_capacity(along.len() * dimension.count());
    for c in along {
        coordinates
            .extend((0..dimension.count()).map(|at| if at == axis.index() { c } else { integer(rng.integer(0, 3)) }));
    }
    let scene = Scene::new(dimension, coordinates).expect("generators make finite points");
    (scene, Cells { axis, cells, probes })
}
