//! The contents of a geometry file: points, lines and polygons with their line numbers, and the conversions for tasks.

use predicament_mesh::PolygonMap;
use predicament_predicates::{Dimension, Vertex};

use super::shared::SharedVertices;
use super::{ImportNotes, ImportedMap, rings};
use crate::CorpusError;

/// The maximum nesting of collections in collections.
pub(super) const DEEPEST: usize = 32;

/// A position, with its line in the file.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Position {
    /// The coordinates x and y.
    pub at: [f64; 2],
    /// The coordinate z, if there is one.
    pub height: Option<f64>,
    /// The line in the file, from 1.
    pub line: usize,
}

/// A part of a feature.
#[derive(Clone, PartialEq, Debug)]
pub enum Shape {
    /// A single point.
    Point(Position),
    /// A polyline.
    Line(Vec<Position>),
    /// Rings: the border and its holes. The last position, which repeats the first, is left out.
    Polygon(Vec<Vec<Position>>),
}

/// A region of a map: a name, its shapes, and the place in the file where it begins.
#[derive(Clone, PartialEq, Debug)]
pub struct Feature {
    /// The name, if the file has one.
    pub name: Option<String>,
    /// The line on which the feature begins, from 1.
    pub line: usize,
    /// The feature's parts in the order of the file.
    pub shapes: Vec<Shape>,
}

/// The contents of a geometry file.
#[derive(Clone, PartialEq, Debug)]
pub struct Geometry {
    /// The name of the file in errors.
    pub file: String,
    /// All features in the order of the file.
    pub features: Vec<Feature>,
    /// Notes about parts of the file that were left out.
    pub notes: ImportNotes,
}

/// Lines and points of the plane; positions with equal coordinates are one vertex.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct ImportedEdges {
    /// The coordinates of each vertex.
    pub points: Vec<[f64; 2]>,
    /// Isolated points.
    pub vertices: Vec<Vertex>,
    /// The edges of lines and rings.
    pub edges: Vec<[Vertex; 2]>,
    /// Counts of what the reader left out or changed.
    pub notes: ImportNotes,
}

impl Geometry {
    fn shapes(&self) -> impl Iterator<Item = (&Feature, &Shape)> {
        self.features.iter().flat_map(|feature| feature.shapes.iter().map(move |shape| (feature, shape)))
    }

    fn error(&self, line: usize, message: impl Into<String>, cure: &str) -> CorpusError {
        CorpusError::file(&self.file, message, cure).at_line(line)
    }

    /// All positions in the order of the file.
    pub(super) fn positions(&self) -> impl Iterator<Item = &Position> {
        self.shapes().flat_map(|(_, shape)| {
            let parts: Vec<&[Position]> = match shape {
                Shape::Point(position) => vec![std::slice::from_ref(position)],
                Shape::Line(line) => vec![line],
                Shape::Polygon(rings) => rings.iter().map(Vec::as_slice).collect(),
            };
            parts.into_iter().flatten()
        })
    }

    /// All positions in the order of the file, as points of two or of three coordinates.
    ///
    /// # Errors
    /// [`CorpusError`] if there are no positions, or only some have a height.
    pub fn points(&self) -> Result<(Dimension, Vec<f64>), CorpusError> {
        let mut dimension = None;
        let mut coordinates = Vec::new();
        for position in self.positions() {
            let found = if position.height.is_some() { Dimension::Three } else { Dimension::Two };
            let expected = *dimension.get_or_insert(found);
            if found != expected {
                let message = format!(
                    "a position of {} coordinates, but earlier positions have {}",
                    found.count(),
                    expected.count()
                );
                return Err(self.error(position.line, message, "give every position a height, or remove all heights"));
            }
            coordinates.extend(position.at);
            coordinates.extend(position.height);
        }
        let none = || CorpusError::file(&self.file, "the file has no points", "give it at least one");
        Ok((dimension.ok_or_else(none)?, coordinates))
    }

    /// The edges of the features' lines, in the order of the file.
    ///
    /// # Errors
    /// [`CorpusError`] if a shape is not a line.
    pub fn segments(&self) -> Result<ImportedEdges, CorpusError> {
        for (feature, shape) in self.shapes() {
            let what = match shape {
                Shape::Line(_) => continue,
                Shape::Point(_) => "a point is not a line",
                Shape::Polygon(_) => "a polygon is not a line",
            };
            return Err(self.error(feature.line, what, "give lines only: LineString or MultiLineString"));
        }
        Ok(self.edges())
    }

    /// Points as vertices, and the edges of lines and of rings.
    #[must_use]
    pub fn edges(&self) -> ImportedEdges {
        let mut notes = self.notes;
        let mut shared = SharedVertices::default();
        let (mut vertices, mut edges) = (Vec::new(), Vec::new());
        for (_, shape) in self.shapes() {
            match shape {
                Shape::Point(position) => vertices.push(vertex(position, &mut shared, &mut notes)),
                Shape::Line(line) => {
                    let line: Vec<Vertex> = line.iter().map(|at| vertex(at, &mut shared, &mut notes)).collect();
                    for pair in line.windows(2) {
                        if pair[0] == pair[1] {
                            notes.repeated_points += 1;
                        } else {
                            edges.push([pair[0], pair[1]]);
                        }
                    }
                }
                Shape::Polygon(rings) => {
                    for ring in rings.iter().filter_map(|ring| cleaned(ring, &mut shared, &mut notes)) {
                        let next = ring.iter().cycle().skip(1);
                        edges.extend(ring.iter().zip(next).map(|(&a, &b)| [a, b]));
                    }
                }
            }
        }
        ImportedEdges { points: shared.into_points(), vertices, edges, notes }
    }

    /// All polylines as they are in the file, in the plane; points and polygons are left out.
    #[must_use]
    pub fn lines(&self) -> Vec<Vec<[f64; 2]>> {
        let lines = self.shapes().filter_map(|(_, shape)| match shape {
            Shape::Line(line) => Some(line.iter().map(|position| position.at).collect()),
            Shape::Point(_) | Shape::Polygon(_) => None,
        });
        lines.collect()
    }

    /// The rings of all polygons as they are in the file, in the plane; points and lines are left out.
    #[must_use]
    pub fn polygons(&self) -> Vec<Vec<Vec<[f64; 2]>>> {
        let places = |ring: &Vec<Position>| ring.iter().map(|position| position.at).collect();
        let rings = self.shapes().filter_map(|(_, shape)| match shape {
            Shape::Polygon(rings) => Some(rings.iter().map(places).collect()),
            Shape::Point(_) | Shape::Line(_) => None,
        });
        rings.collect()
    }

    /// The map of the features' polygons; each feature is a region.
    ///
    /// # Errors
    /// [`CorpusError`] if a shape is not a polygon.
    pub fn map(self) -> Result<ImportedMap, CorpusError> {
        let mut notes = self.notes;
        let (mut shared, mut map) = (SharedVertices::default(), PolygonMap::new());
        for feature in &self.features {
            let mut all = Vec::new();
            for shape in &feature.shapes {
                let Shape::Polygon(rings) = shape else {
                    let what = if matches!(shape, Shape::Point(_)) { "a point" } else { "a line" };
                    let message = format!("{what} bounds no region");
                    return Err(self.error(feature.line, message, "give polygons only: Polygon or MultiPolygon"));
                };
                all.extend(rings.iter().filter_map(|ring| cleaned(ring, &mut shared, &mut notes)));
            }
            rings::push(&mut map, feature.name.clone(), all, &mut notes);
        }
        if map.regions().is_empty() {
            return Err(CorpusError::file(self.file, "the file has no region", "give it at least one polygon"));
        }
        Ok(ImportedMap { points: shared.into_points(), map, notes })
    }
}

/// The vertex of a position in the plane.
fn vertex(position: &Position, shared: &mut SharedVertices<2>, notes: &mut ImportNotes) -> Vertex {
    notes.extra_coordinates += usize::from(position.height.is_some());
    shared.vertex(position.at)
}

fn cleaned(ring: &[Position], shared: &mut SharedVertices<2>, notes: &mut ImportNotes) -> Option<Vec<Vertex>> {
    let vertices = ring.iter().map(|position| vertex(position, shared, notes)).collect();
    rings::ring(vertices, notes)
}

/// A ring without its last position, which must repeat the first. The error is a line and a message.
pub(super) fn open(mut ring: Vec<Position>) -> Result<Vec<Position>, (usize, &'static str)> {
    if let [first, .., last] = ring.as_slice() {
        if (first.at, first.height) != (last.at, last.height) {
            return Err((last.line, "the ring is not closed"));
        }
        ring.pop();
    }
    Ok(ring)
}

/// The fix for a ring that is not closed.
pub(super) const CLOSE: &str = "repeat its first position at its end";
