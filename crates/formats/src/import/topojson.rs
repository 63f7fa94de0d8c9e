//! The importer of TopoJSON maps.
//!
//! TopoJSON stores borders as arcs that neighbours share, which is what an
//! exact tiling needs. Vertices with equal decoded coordinates become *one*
//! vertex over the whole map: a symbolic perturbation moves vertices by
//! identity, and a border that two regions hold as different vertices would
//! open into a sliver.
//!
//! Quantised coordinates are decoded as the format's reference client does:
//! integer sums of the deltas, then `k * scale + translate` with two roundings
//! in double precision. The doubles that come out *are* the scene.

use std::collections::{BTreeMap, HashMap};

use predicament_mesh::PolygonMap;
use predicament_predicates::Vertex;
use serde::Deserialize;
use serde_json::Value;

use super::ImportNotes;
use crate::CorpusError;

/// A map and its vertices' coordinates.
#[derive(Debug)]
pub struct ImportedMap {
    /// The coordinates of each vertex.
    pub points: Vec<[f64; 2]>,
    /// The regions.
    pub map: PolygonMap,
    /// What was left out.
    pub notes: ImportNotes,
}

#[derive(Deserialize)]
struct Topology {
    #[serde(rename = "type")]
    kind: String,
    transform: Option<Transform>,
    arcs: Vec<Vec<Vec<f64>>>,
    objects: BTreeMap<String, Geometry>,
}

#[derive(Deserialize)]
struct Transform {
    scale: [f64; 2],
    translate: [f64; 2],
}

#[derive(Deserialize)]
struct Geometry {
    #[serde(rename = "type")]
    kind: Option<String>,
    arcs: Option<Value>,
    geometries: Option<Vec<Geometry>>,
    properties: Option<Value>,
    id: Option<Value>,
}

/// One polygon: its rings, each a list of arc references.
type Polygon = Vec<Vec<i64>>;

/// Reads the polygons of one object.
pub fn read(file: &str, text: &str, object: &str) -> Result<ImportedMap, CorpusError> {
    let topology: Topology = serde_json::from_str(text).map_err(|error| {
        // serde_json appends the place, which is in the line already.
        let whole = error.to_string();
        let message = whole.rsplit_once(" at line ").map_or(whole.as_str(), |(message, _)| message);
        let cure = if error.is_eof() { "the file ends early: fetch or copy it again" } else { "give a TopoJSON file" };
        CorpusError::file(file, format!("not TopoJSON: {message}"), cure).at_line(error.line())
    })?;
    if topology.kind != "Topology" {
        let message = format!("the file's type is `{}`, not `Topology`", topology.kind);
        return Err(CorpusError::file(file, message, "convert it to TopoJSON"));
    }
    let Some(root) = topology.objects.get(object) else {
        let known: Vec<_> = topology.objects.keys().map(String::as_str).collect();
        let message = format!("the topology has no object `{object}`");
        return Err(CorpusError::file(file, message, format!("use one of {}", known.join(", "))));
    };
    let mut importer = Importer { file, arcs: decode(file, &topology)?, ..Importer::default() };
    importer.geometry(root)?;
    Ok(ImportedMap { points: importer.points, map: importer.map, notes: importer.notes })
}

/// Every arc's points.
fn decode(file: &str, topology: &Topology) -> Result<Vec<Vec<[f64; 2]>>, CorpusError> {
    let bad = |arc: usize, message: &str| {
        CorpusError::file(file, format!("arc {arc}: {message}"), "give a valid TopoJSON file")
    };
    let mut arcs = Vec::with_capacity(topology.arcs.len());
    for (index, arc) in topology.arcs.iter().enumerate() {
        let mut sum = [0.0, 0.0];
        let mut points = Vec::with_capacity(arc.len());
        for position in arc {
            let &[x, y, ..] = position.as_slice() else {
                return Err(bad(index, "a position of less than two numbers"));
            };
            let point = match &topology.transform {
                None => [x, y],
                Some(Transform { scale, translate }) => {
                    sum = [sum[0] + x, sum[1] + y];
                    if sum.iter().any(|s| s.fract() != 0.0 || s.abs() > MOST_QUANTA) {
                        return Err(bad(index, "a quantised position that is no integer below 2^53"));
                    }
                    std::array::from_fn(|i| sum[i] * scale[i] + translate[i])
                }
            };
            if point.iter().any(|x| !x.is_finite()) {
                return Err(bad(index, "a position that is not finite"));
            }
            points.push(point);
        }
        arcs.push(points);
    }
    Ok(arcs)
}

/// Sums of deltas are exact below this.
const MOST_QUANTA: f64 = 9_007_199_254_740_992.0;

#[derive(Default)]
struct Importer<'f> {
    file: &'f str,
    arcs: Vec<Vec<[f64; 2]>>,
    points: Vec<[f64; 2]>,
    // Only looked up, never iterated: its order reaches no output.
    vertices: HashMap<[u64; 2], Vertex>,
    map: PolygonMap,
    notes: ImportNotes,
}

impl Importer<'_> {
    fn error(&self, message: impl Into<String>) -> CorpusError {
        CorpusError::file(self.file, message, "give a TopoJSON object of polygons")
    }

    fn geometry(&mut self, geometry: &Geometry) -> Result<(), CorpusError> {
        let polygons: Vec<Polygon> = match geometry.kind.as_deref() {
            Some("GeometryCollection") => {
                for child in geometry.geometries.iter().flatten() {
                    self.geometry(child)?;
                }
                return Ok(());
            }
            Some("Polygon") => vec![self.arc_references(geometry)?],
            Some("MultiPolygon") => self.arc_references(geometry)?,
            // GeoJSON allows features without a place.
            None => {
                self.notes.empty_regions += 1;
                return Ok(());
            }
            Some(other) => return Err(self.error(format!("a geometry of type `{other}` bounds no region"))),
        };
        let mut rings = Vec::new();
        for arcs in polygons.iter().flatten() {
            rings.extend(self.ring(arcs)?);
        }
        if rings.is_empty() {
            self.notes.empty_regions += 1;
            return Ok(());
        }
        let name = self.name(geometry);
        self.map.push(name, rings).map_err(|error| self.error(error.to_string()))
    }

    fn arc_references<T: serde::de::DeserializeOwned>(&self, geometry: &Geometry) -> Result<T, CorpusError> {
        let arcs = geometry.arcs.clone().unwrap_or(Value::Null);
        serde_json::from_value(arcs).map_err(|error| self.error(format!("a geometry's arcs are malformed: {error}")))
    }

    /// The region's name property, else its id, else its place.
    fn name(&self, geometry: &Geometry) -> String {
        let name = geometry.properties.as_ref().and_then(|properties| properties.get("name"));
        match name.or(geometry.id.as_ref()) {
            Some(Value::String(name)) => name.clone(),
            Some(value @ Value::Number(_)) => value.to_string(),
            _ => format!("region {}", self.map.regions().len()),
        }
    }

    /// Joins arcs to a ring: each starts where the one before it ends.
    fn ring(&mut self, arcs: &[i64]) -> Result<Option<Vec<Vertex>>, CorpusError> {
        let mut ring: Vec<Vertex> = Vec::new();
        for (place, &reference) in arcs.iter().enumerate() {
            let reversed = reference < 0;
            let index = usize::try_from(if reversed { !reference } else { reference }).unwrap_or(usize::MAX);
            let count = self.arcs.len();
            let arc = self.arcs.get(index).ok_or_else(|| {
                self.error(format!("a ring refers to arc {reference}; the topology has {count} arcs"))
            })?;
            let mut points = arc.clone();
            if reversed {
                points.reverse();
            }
            for (at, point) in points.into_iter().enumerate() {
                let vertex = self.vertex(point);
                match ring.last() {
                    Some(&last) if last == vertex => {
                        // The joint of two arcs is in both; any other repetition is the data's.
                        self.notes.repeated_points += usize::from(at > 0);
                    }
                    Some(_) if at == 0 && place > 0 => {
                        return Err(self.error(format!("arc {reference} does not start where the arc before it ends")));
                    }
                    _ => ring.push(vertex),
                }
            }
        }
        if ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        if ring.len() < 3 {
            self.notes.degenerate_rings += 1;
            return Ok(None);
        }
        Ok(Some(ring))
    }

    /// The one vertex with these coordinates.
    fn vertex(&mut self, point: [f64; 2]) -> Vertex {
        // -0 and +0 are the same place.
        let key = point.map(|x| (x + 0.0).to_bits());
        let points = &mut self.points;
        *self.vertices.entry(key).or_insert_with(|| {
            points.push(point);
            Vertex::input(points.len() - 1)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two squares that share the border x = 1, as two arcs each.
    const SQUARES: &str = r#"{
        "type": "Topology",
        "transform": {"scale": [0.5, 0.25], "translate": [10, -10]},
        "objects": {"squares": {"type": "GeometryCollection", "geometries": [
            {"type": "Polygon", "arcs": [[0, 1]], "properties": {"name": "west"}},
            {"type": "MultiPolygon", "arcs": [[[-1, 2]], [[3]]], "id": 7},
            {"type": null}
        ]}},
        "arcs": [
            [[2, 0], [0, 2], [0, 0]],
            [[2, 2], [-2, 0], [0, -2], [2, 0]],
            [[2, 0], [2, 0], [0, 2], [-2, 0]],
            [[5, 5], [1, 1], [-1, -1]]
        ]
    }"#;

    #[test]
    fn shared_borders_share_vertices() {
        let imported = read("squares.json", SQUARES, "squares").unwrap();
        assert_eq!(imported.points[0], [11.0, -10.0]);
        assert_eq!(imported.points.len(), 8, "six corners, and the two points of the ring that is dropped");
        let regions = imported.map.regions();
        assert_eq!(regions.len(), 2);
        assert_eq!((regions[0].name.as_str(), regions[1].name.as_str()), ("west", "7"));
        let shared = |a: &[Vertex], b: &[Vertex]| a.iter().filter(|v| b.contains(v)).count();
        assert_eq!(shared(regions[0].rings[0].vertices(), regions[1].rings[0].vertices()), 2);
        assert_eq!(regions[1].rings.len(), 1);
        assert_eq!(imported.notes, ImportNotes { repeated_points: 2, degenerate_rings: 1, empty_regions: 1 });
    }

    #[test]
    fn unquantised_positions_are_absolute() {
        let text = r#"{"type": "Topology", "objects": {"o": {"type": "Polygon", "arcs": [[0]]}},
            "arcs": [[[0.5, 0.5], [2.5, 0.5, 9], [2.5, 1.5], [0.5, 0.5]]]}"#;
        let imported = read("a.json", text, "o").unwrap();
        assert_eq!(imported.points, [[0.5, 0.5], [2.5, 0.5], [2.5, 1.5]]);
        assert_eq!(imported.map.regions()[0].name, "region 0");
        assert!(imported.notes.is_clean());
    }

    #[test]
    fn what_is_wrong_is_said_in_one_line() {
        let error = |text: &str, object: &str| read("m.json", text, object).unwrap_err().to_string();
        assert_eq!(error(SQUARES, "circles"), "m.json: the topology has no object `circles`; use one of squares");
        assert!(error(&SQUARES.replace("[[0, 1]]", "[[0, 9]]"), "squares").contains("refers to arc 9"));
        assert!(error(&SQUARES.replace("[[0, 1]]", "[[0, 2]]"), "squares").contains("does not start where"));
        assert!(
            error(&SQUARES.replace("[2, 2], [-2", "[2.5, 2], [-2"), "squares").contains("arc 1: a quantised position")
        );
        assert!(error(&SQUARES.replace("[0, 2], [0, 0]", "[0]"), "squares").contains("arc 0: a position of less"));
        assert!(error(&SQUARES.replace("\"Polygon\"", "\"Point\""), "squares").contains("`Point` bounds no region"));
        assert!(error(&SQUARES.replace("\"Topology\"", "\"FeatureCollection\""), "squares").contains("not `Topology`"));
        let truncated = error(&SQUARES[..SQUARES.len() - 60], "squares");
        assert!(truncated.starts_with("m.json:12: not TopoJSON: EOF"), "{truncated}");
        assert!(truncated.ends_with("; the file ends early: fetch or copy it again"), "{truncated}");
    }
}
