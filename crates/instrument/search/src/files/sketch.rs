//! A file as pieces that can be removed: points, and items that name them.

use std::sync::Arc;

/// The kind of a shape.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    Point,
    Line,
    /// A face of a mesh, or a polygon: a border and its holes.
    Area,
}

impl Kind {
    /// The minimum number of corners of a loop that has lost corners.
    pub(super) fn least(self) -> usize {
        match self {
            Kind::Point => 1,
            Kind::Line => 2,
            Kind::Area => 3,
        }
    }
}

/// A part of an item: its loops name points by their indices.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Shape {
    pub kind: Kind,
    pub loops: Vec<Vec<usize>>,
}

/// The order of bytes of a binary file, or text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Encoding {
    Text,
    Little,
    Big,
}

/// The object around the geometry of a GeoJSON file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Outer {
    Collection,
    Feature,
    Geometry,
    Rings,
}

/// The format of a file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Form {
    Off,
    Obj,
    Ply(Encoding),
    Stl(Encoding),
    GeoJson(Outer),
    Wkt,
    /// Rows of cells: the line with the names of the columns, or an empty text, and the separator.
    Csv(String, &'static str),
}

/// A file as pieces. Points that no item names are not written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Sketch {
    pub(super) form: Form,
    /// The coordinates of each point, as text: a number keeps its digits until it is simplified.
    pub(super) points: Arc<Vec<Vec<String>>>,
    /// Faces, lines and points of a mesh; features of a map; rows of a table.
    pub(super) items: Vec<Arc<Vec<Shape>>>,
}

/// The sizes of files, added up.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Counts {
    /// Triangles and other faces, features, or rows.
    pub items: usize,
    /// Points that items name.
    pub points: usize,
    /// Characters of all coordinates; a zero has none.
    pub digits: usize,
    /// Items, loops, corners and points.
    pub pieces: usize,
}

impl Sketch {
    /// A flag for each point: true if an item names it.
    pub(super) fn used(&self) -> Vec<bool> {
        let mut used = vec![false; self.points.len()];
        for shape in self.items.iter().flat_map(|item| item.iter()) {
            shape.loops.iter().flatten().for_each(|&corner| used[corner] = true);
        }
        used
    }

    /// The indices of the points that items name.
    pub(super) fn places(&self) -> Vec<usize> {
        let used = self.used();
        (0..used.len()).filter(|&at| used[at]).collect()
    }
}

/// The characters of a coordinate; none for zero.
pub(super) fn cost(cell: &str) -> usize {
    if cell == "0" { 0 } else { cell.len() }
}

/// The sizes of these files, added up.
#[must_use]
pub fn counts(files: &[Sketch]) -> Counts {
    let mut counts = Counts::default();
    for file in files {
        counts.items += file.items.len();
        for shape in file.items.iter().flat_map(|item| item.iter()) {
            counts.pieces += 1 + shape.loops.iter().map(|one| 1 + one.len()).sum::<usize>();
        }
        for at in file.places() {
            counts.points += 1;
            counts.digits += file.points[at].iter().map(|cell| cost(cell)).sum::<usize>();
        }
    }
    counts.pieces += counts.items + counts.points;
    counts
}

/// Removes points that no item names from memory; the files are written as before.
pub(super) fn compact(files: &mut [Sketch]) {
    for file in files {
        let places = file.places();
        let mut numbers = vec![0; file.points.len()];
        places.iter().enumerate().for_each(|(number, &at)| numbers[at] = number);
        file.points = Arc::new(places.iter().map(|&at| file.points[at].clone()).collect());
        for item in &mut file.items {
            let corners = Arc::make_mut(item).iter_mut().flat_map(|shape| &mut shape.loops).flatten();
            corners.for_each(|corner| *corner = numbers[*corner]);
        }
    }
}
