//! Rings of polygons: removal of repeated points, and polygons written in a suite.

use predicament_mesh::PolygonMap;
use predicament_predicates::Vertex;

use super::shared::SharedVertices;
use super::{ImportNotes, ImportedMap};
use crate::CorpusError;
use crate::document::Field;

/// A ring without vertices that repeat their predecessor (cyclically); `None` if fewer than three are left.
pub(super) fn ring(mut vertices: Vec<Vertex>, notes: &mut ImportNotes) -> Option<Vec<Vertex>> {
    let all = vertices.len();
    vertices.dedup();
    while vertices.len() > 1 && vertices.first() == vertices.last() {
        vertices.pop();
    }
    notes.repeated_points += all - vertices.len();
    if vertices.len() < 3 {
        notes.degenerate_rings += 1;
        return None;
    }
    Some(vertices)
}

/// Adds a region, or counts it as empty.
pub(super) fn push(map: &mut PolygonMap, name: Option<String>, rings: Vec<Vec<Vertex>>, notes: &mut ImportNotes) {
    if rings.is_empty() {
        notes.empty_regions += 1;
        return;
    }
    let name = name.unwrap_or_else(|| format!("region {}", map.regions().len()));
    map.push(name, rings).expect("rings of at least three vertices, none repeated at once");
}

/// Reads polygons written in a suite, each a region: arrays of rings, which are arrays of points. The first point of a
/// ring may be repeated at its end.
///
/// # Errors
/// [`CorpusError`] at the line that is wrong.
pub fn read_polygons(field: &Field<'_, '_>) -> Result<ImportedMap, CorpusError> {
    const POINTS: &str = "a ring: an array of points of two coordinates";
    let (mut vertices, mut map, mut notes) = (SharedVertices::default(), PolygonMap::new(), ImportNotes::default());
    for polygon in field.items("polygons: arrays of rings")? {
        let mut rings = Vec::new();
        for written in polygon.items("a polygon: an array of rings")? {
            let mut corners = Vec::new();
            for point in written.items(POINTS)? {
                let numbers: Vec<f64> = point.items(POINTS)?.map(|x| x.coordinate()).collect::<Result<_, _>>()?;
                let &[x, y] = numbers.as_slice() else {
                    return Err(point.error(format!("a point of {} coordinates", numbers.len()), "write two"));
                };
                corners.push(vertices.vertex([x, y]));
            }
            if corners.len() > 1 && corners.first() == corners.last() {
                corners.pop();
            }
            rings.extend(ring(corners, &mut notes));
        }
        push(&mut map, None, rings, &mut notes);
    }
    if map.regions().is_empty() {
        return Err(field.error("polygons without a ring of three points", "write a ring of at least three points"));
    }
    Ok(ImportedMap { points: vertices.into_points(), map, notes })
}
