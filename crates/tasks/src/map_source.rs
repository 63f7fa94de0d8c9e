//! Maps that a table refers to or writes out: TopoJSON, GeoJSON, WKT, or polygons.

use predicament_corpus::{Context, Origin};
use predicament_formats::{
    Cache, CorpusError, Decimals, Entry, Field, ImportedMap, TableKind, geometry, read_polygons, topojson,
};

static MAP: TableKind = TableKind::new("map", &["path", "topojson", "fetch", "object", "polygons"]);

/// Where a map is.
#[derive(Clone, Debug)]
pub(crate) enum MapSource {
    /// An object of a TopoJSON file.
    Topology { origin: Origin, object: String, round: bool },
    /// A GeoJSON or WKT file.
    Geometry { origin: Origin, round: bool },
    /// Polygons in the suite.
    Written(ImportedMap),
}

impl MapSource {
    /// Reads `path`, `topojson` or `fetch` with `object`, or `polygons`.
    pub(crate) fn read(context: &Context<'_>, map: &Field<'_, '_>) -> Result<MapSource, CorpusError> {
        const ONE: &str = "one of `path`, `topojson`, `fetch` and `polygons`";
        let table = map.fields(&MAP)?;
        let round = context.round();
        let places = (table.get("path"), table.get("topojson"), table.get("fetch"), table.get("polygons"));
        let source = match places {
            (Some(path), None, None, None) => MapSource::Geometry { origin: Origin::path(context, &path)?, round },
            (None, Some(path), None, None) => {
                let object = table.required("object")?.string()?;
                MapSource::Topology { origin: Origin::path(context, &path)?, object, round }
            }
            (None, None, Some(key), None) => {
                let origin = Origin::fetched(context, &key)?;
                match table.get("object") {
                    Some(object) => MapSource::Topology { origin, object: object.string()?, round },
                    None => MapSource::Geometry { origin, round },
                }
            }
            (None, None, None, Some(polygons)) => MapSource::Written(read_polygons(&polygons)?),
            (None, None, None, None) => {
                let missing = map.error("a map from nowhere", format!("write {ONE}"));
                return Err(table.lacking(ONE, missing));
            }
            _ => return Err(map.error("a map from more than one place", format!("keep {ONE}"))),
        };
        table.finish()?;
        Ok(source)
    }

    /// The map.
    pub(crate) fn map(&self, cache: &Cache) -> Result<ImportedMap, CorpusError> {
        match self {
            MapSource::Topology { origin, object, round } => {
                let (name, text) = origin.text(cache)?;
                rounding(*round, |decimals| topojson::read(&name, &text, object, decimals))
            }
            MapSource::Geometry { origin, round } => {
                let (name, bytes) = origin.bytes(cache)?;
                rounding(*round, |decimals| geometry::read(&name, bytes, decimals)?.map())
            }
            MapSource::Written(map) => Ok(map.clone()),
        }
    }

    /// The fetched file, if it needs one.
    pub(crate) fn entry(&self) -> Option<&Entry> {
        match self {
            MapSource::Topology { origin, .. } | MapSource::Geometry { origin, .. } => origin.entry(),
            MapSource::Written(_) => None,
        }
    }
}

/// A map with the number of decimals that were rounded in its notes.
fn rounding(
    round: bool,
    read: impl FnOnce(&Decimals) -> Result<ImportedMap, CorpusError>,
) -> Result<ImportedMap, CorpusError> {
    let decimals = Decimals::new(round);
    let mut map = read(&decimals)?;
    map.notes.rounded += decimals.rounded();
    Ok(map)
}
