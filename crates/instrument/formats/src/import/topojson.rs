//! The importer of TopoJSON maps.
//!
//! TopoJSON stores borders as arcs that neighbours share, which is what an exact tiling needs. Vertices with equal
//! decoded coordinates become *one* vertex over the whole map: a symbolic perturbation moves vertices by identity, and
//! a border that two regions hold as different vertices would open into a sliver.
//!
//! Quantised coordinates are decoded as the format's reference client does: integer sums of the deltas, then
//! `k * scale + translate` with two roundings in double precision. The resulting doubles *are* the scene. Positions
//! that are not quantised are decimals, read as in suites.

use std::collections::BTreeMap;

use predicament_mesh::PolygonMap;
use predicament_predicates::Vertex;
use serde::Deserialize;
use serde_json::Value;
use serde_json::value::RawValue;

use super::shared::SharedVertices;
use super::{ImportNotes, ImportedMap, Keeps, id_text};
use crate::decimals::{Place, explain};
use crate::{CorpusError, Decimals, Lines};

#[derive(Deserialize)]
struct Topology<'t> {
    #[serde(rename = "type")]
    kind: String,
    transform: Option<Transform>,
    /// The positions of each arc, as the text of their numbers.
    #[serde(borrow)]
    arcs: Vec<Vec<Vec<&'t RawValue>>>,
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

/// A polygon: its rings, each a list of arc references.
type Polygon = Vec<Vec<i64>>;

/// Reads the polygons of one object.
///
/// # Errors
/// [`CorpusError`] at the line or the arc that is wrong.
pub fn read(file: &str, text: &str, object: &str, decimals: &Decimals) -> Result<ImportedMap, CorpusError> {
    read_some(file, text, object, decimals, &mut |_, _| true)
}

/// Reads the selected polygons of one object. Arcs are read completely, as they are shared.
///
/// # Errors
/// As [`read`].
pub fn read_some(
    file: &str,
    text: &str,
    object: &str,
    decimals: &Decimals,
    keeps: &mut Keeps<'_>,
) -> Result<ImportedMap, CorpusError> {
    let topology: Topology<'_> = serde_json::from_str(text).map_err(|error| {
        // serde_json appends the position, which is already in `line`.
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
    let mut notes = ImportNotes::default();
    let arcs = decode(file, text, &topology, decimals, &mut notes)?;
    let shared = SharedVertices::default();
    let mut importer = Importer { file, arcs, shared, map: PolygonMap::new(), notes, seen: 0 };
    importer.geometry(root, keeps)?;
    Ok(ImportedMap { points: importer.shared.into_points(), map: importer.map, notes: importer.notes })
}

/// The points of all arcs.
fn decode(
    file: &str,
    text: &str,
    topology: &Topology<'_>,
    decimals: &Decimals,
    notes: &mut ImportNotes,
) -> Result<Vec<Vec<[f64; 2]>>, CorpusError> {
    let bad = |arc: usize, message: &str| {
        CorpusError::file(file, format!("arc {arc}: {message}"), "give a valid TopoJSON file")
    };
    let lines = Lines::new(text);
    let mut arcs = Vec::with_capacity(topology.arcs.len());
    for (index, arc) in topology.arcs.iter().enumerate() {
        let mut sum = [0.0, 0.0];
        let mut points = Vec::with_capacity(arc.len());
        for position in arc {
            let (&[x, y], more) =
                position.split_first_chunk().ok_or_else(|| bad(index, "a position of less than two numbers"))?;
            notes.extra_coordinates += more.len();
            let point = match &topology.transform {
                None => {
                    let number = |raw: &RawValue| {
                        decimals.read(raw.get()).map_err(|why| {
                            let (message, cure) = explain(Place::Data, raw.get(), &why);
                            let line = lines.of(raw.get().as_ptr().addr() - text.as_ptr().addr());
                            CorpusError::file(file, format!("arc {index}: {message}"), cure).at_line(line)
                        })
                    };
                    [number(x)?, number(y)?]
                }
                Some(Transform { scale, translate }) => {
                    let delta = |raw: &RawValue| raw.get().parse().unwrap_or(f64::NAN);
                    sum = [sum[0] + delta(x), sum[1] + delta(y)];
                    if sum.iter().any(|s| s.fract() != 0.0 || s.is_nan() || s.abs() > MOST_QUANTA) {
                        return Err(bad(index, "a quantised position that is not an integer below 2^53"));
                    }
                    std::array::from_fn(|i| sum[i] * scale[i] + translate[i])
                }
            };
            if point.iter().any(|x: &f64| !x.is_finite()) {
                return Err(bad(index, "a position that is not finite"));
            }
            points.push(point);
        }
        arcs.push(points);
    }
    Ok(arcs)
}

/// The limit below which sums of deltas are exact.
const MOST_QUANTA: f64 = 9_007_199_254_740_992.0;

struct Importer<'f> {
    file: &'f str,
    arcs: Vec<Vec<[f64; 2]>>,
    shared: SharedVertices<2>,
    map: PolygonMap,
    notes: ImportNotes,
    /// The number of geometries seen so far, not counting collections.
    seen: usize,
}

impl Importer<'_> {
    fn error(&self, message: impl Into<String>) -> CorpusError {
        CorpusError::file(self.file, message, "give a TopoJSON object of polygons")
    }

    fn geometry(&mut self, geometry: &Geometry, keeps: &mut Keeps<'_>) -> Result<(), CorpusError> {
        if geometry.kind.as_deref() == Some("GeometryCollection") {
            return geometry.geometries.iter().flatten().try_for_each(|child| self.geometry(child, keeps));
        }
        let number = self.seen;
        self.seen += 1;
        if !keeps(number, id_text(geometry.id.as_ref()).as_deref()) {
            return Ok(());
        }
        let polygons: Vec<Polygon> = match geometry.kind.as_deref() {
            Some("Polygon") => vec![self.arc_references(geometry)?],
            Some("MultiPolygon") => self.arc_references(geometry)?,
            // GeoJSON allows features without a geometry.
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
        let named = geometry.properties.as_ref().and_then(|properties| properties.get("name"));
        let name = name(named, geometry.id.as_ref());
        let name = name.unwrap_or_else(|| format!("region {}", self.map.regions().len()));
        self.map.push(name, rings).map_err(|error| self.error(error.to_string()))
    }

    fn arc_references<T: serde::de::DeserializeOwned>(&self, geometry: &Geometry) -> Result<T, CorpusError> {
        let arcs = geometry.arcs.clone().unwrap_or(Value::Null);
        serde_json::from_value(arcs).map_err(|error| self.error(format!("a geometry's arcs are malformed: {error}")))
    }

    /// Joins arcs into a ring: each arc starts where the one before it ends.
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
                let vertex = self.shared.vertex(point);
                match ring.last() {
                    Some(&last) if last == vertex => {
                        // The joint of two arcs is in both; any other repetition comes from the data.
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
}

/// A region's name property, else its id.
pub(super) fn name(name: Option<&Value>, id: Option<&Value>) -> Option<String> {
    id_text(name.or(id))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(file: &str, text: &str, object: &str) -> Result<ImportedMap, CorpusError> {
        super::read(file, text, object, &Decimals::new(false))
    }

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
        assert_eq!(
            imported.notes,
            ImportNotes { repeated_points: 2, degenerate_rings: 1, empty_regions: 1, ..ImportNotes::default() }
        );
    }

    #[test]
    fn some_regions_are_read_by_number_or_id() {
        let some = |wanted: &dyn Fn(usize, Option<&str>) -> bool| {
            let keeps: &mut Keeps<'_> = &mut |number, id| wanted(number, id);
            read_some("squares.json", SQUARES, "squares", &Decimals::new(false), keeps).unwrap()
        };
        let west = some(&|number, _| number == 0);
        assert_eq!((west.map.regions()[0].name.as_str(), west.points.len()), ("west", 4));
        let notes = ImportNotes { repeated_points: 1, ..ImportNotes::default() };
        assert_eq!((west.map.regions().len(), west.notes), (1, notes));
        let seventh = some(&|_, id| id == Some("7"));
        assert_eq!((seventh.map.regions()[0].name.as_str(), seventh.notes.degenerate_rings), ("7", 1));
        assert_eq!(some(&|number, _| number == 2).notes, ImportNotes { empty_regions: 1, ..ImportNotes::default() });
    }

    #[test]
    fn unquantised_positions_are_absolute() {
        let text = r#"{"type": "Topology", "objects": {"o": {"type": "Polygon", "arcs": [[0]]}},
            "arcs": [[[0.5, 0.5], [2.5, 0.5, 9], [2.5, 1.5], [0.5, 0.5]]]}"#;
        let imported = read("a.json", text, "o").unwrap();
        assert_eq!(imported.points, [[0.5, 0.5], [2.5, 0.5], [2.5, 1.5]]);
        assert_eq!(imported.map.regions()[0].name, "region 0");
        assert_eq!(imported.notes, ImportNotes { extra_coordinates: 1, ..ImportNotes::default() });
        let text = text.replace("[2.5, 1.5]", "\n[2.5, 0.1000000000000000001]");
        let error = read("a.json", &text, "o").unwrap_err().to_string();
        assert!(
            error.starts_with(
                "a.json:3: arc 0: decimal 0.1000000000000000001 has digits that no double holds; write `round = true`"
            ),
            "{error}"
        );
        let decimals = Decimals::new(true);
        assert_eq!(super::read("a.json", &text, "o", &decimals).unwrap().points[2], [2.5, 0.1]);
        assert_eq!(decimals.rounded(), 1);
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
