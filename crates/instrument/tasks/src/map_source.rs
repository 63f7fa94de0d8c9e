//! Maps that a table refers to or contains: TopoJSON, GeoJSON, WKT, or polygons; whole maps, or some of their regions.

use predicament_corpus::{Context, Origin};
use predicament_formats::{
    Cache, CorpusError, Decimals, Entry, Field, Fields, ImportedMap, Keeps, TableKind, geometry, read_polygons,
    topojson,
};

use crate::map_loops::{MapLoops, NEEDED};

static MAP: TableKind =
    TableKind::new("map", &["path", "topojson", "fetch", "object", "member", "polygons", "ids", "regions"]);

/// The source of a map.
#[derive(Clone, Debug)]
pub enum MapSource {
    /// An object of a TopoJSON file.
    Topology {
        /// The file.
        origin: Origin,
        /// The object's name.
        object: String,
        /// True if decimals that are not doubles are rounded.
        round: bool,
        /// The selection of its regions.
        selected: Selected,
    },
    /// A GeoJSON or WKT file, or a member of a JSON file.
    Geometry {
        /// The file.
        origin: Origin,
        /// The member, if the file has several.
        member: Option<String>,
        /// True if decimals that are not doubles are rounded.
        round: bool,
        /// The selection of its regions.
        selected: Selected,
    },
    /// Polygons in the suite.
    Written(ImportedMap),
    /// Loops of points.
    Loops(MapLoops),
}

impl MapSource {
    /// Reads `map`, or `points` and `loops`.
    pub fn of_scene(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<MapSource, CorpusError> {
        let loops = ["points", "loops", "regions"].into_iter().find_map(|key| fields.get(key));
        match loops {
            Some(_) if fields.get("map").is_none() => Ok(MapSource::Loops(MapLoops::read(context, fields)?)),
            Some(loops) => Err(loops.error("a map with two sources", "keep `map`, or `points` and `loops`")),
            None => {
                let map = fields.required("map");
                let map = map.map_err(|missing| fields.lacking(NEEDED, missing))?;
                MapSource::read(context, &map)
            }
        }
    }

    /// Reads `path`, `topojson` or `fetch` with `object` or `member`, or `polygons`; and `ids` or `regions`.
    pub fn read(context: &Context<'_>, map: &Field<'_, '_>) -> Result<MapSource, CorpusError> {
        const ONE: &str = "one of `path`, `topojson`, `fetch` and `polygons`";
        let table = map.fields(&MAP)?;
        let round = context.round();
        let selected = Selected::read(&table)?;
        let member = || table.get("member").map(|member| member.string()).transpose();
        let places = (table.get("path"), table.get("topojson"), table.get("fetch"), table.get("polygons"));
        let source = match places {
            (Some(path), None, None, None) => {
                MapSource::Geometry { origin: Origin::path(context, &path)?, member: member()?, round, selected }
            }
            (None, Some(path), None, None) => {
                let object = table.required("object")?.string()?;
                MapSource::Topology { origin: Origin::path(context, &path)?, object, round, selected }
            }
            (None, None, Some(key), None) => {
                let origin = Origin::fetched(context, &key)?;
                match table.get("object") {
                    Some(object) => MapSource::Topology { origin, object: object.string()?, round, selected },
                    None => MapSource::Geometry { origin, member: member()?, round, selected },
                }
            }
            (None, None, None, Some(polygons)) => {
                if let Some(key) = table.get("ids").or_else(|| table.get("regions")) {
                    return Err(key.error(
                        "`ids` and `regions` select from files, not from `polygons`",
                        "remove the key, and write only the polygons that you want",
                    ));
                }
                MapSource::Written(read_polygons(&polygons)?)
            }
            (None, None, None, None) => {
                let missing = map.error("a map without a source", format!("write {ONE}"));
                return Err(table.lacking(ONE, missing));
            }
            _ => return Err(map.error("a map with more than one source", format!("keep {ONE}"))),
        };
        table.finish()?;
        Ok(source)
    }

    /// The map.
    pub fn map(&self, cache: &Cache) -> Result<ImportedMap, CorpusError> {
        match self {
            MapSource::Topology { origin, object, round, selected } => {
                let (name, text) = origin.text(cache)?;
                rounding(*round, |decimals| {
                    selected.of(|keeps| topojson::read_some(&name, &text, object, decimals, keeps))
                })
            }
            MapSource::Geometry { origin, member, round, selected } => {
                let (name, bytes) = origin.bytes(cache)?;
                rounding(*round, |decimals| {
                    selected.of(|keeps| geometry::read_part(&name, bytes, decimals, member.as_deref(), keeps))?.map()
                })
            }
            MapSource::Written(map) => Ok(map.clone()),
            MapSource::Loops(loops) => loops.map(cache),
        }
    }

    /// The fetched file, if any.
    pub fn entry(&self) -> Option<&Entry> {
        match self {
            MapSource::Topology { origin, .. } | MapSource::Geometry { origin, .. } => origin.entry(),
            MapSource::Written(_) => None,
            MapSource::Loops(loops) => loops.entry(),
        }
    }
}

/// The selection of a file's regions that form the map.
#[derive(Clone, Debug)]
pub enum Selected {
    /// All regions of the file.
    All,
    /// The regions whose ids begin with a prefix.
    Ids {
        /// The prefix.
        begin: String,
        /// The suite that contains it.
        file: String,
        /// Its line.
        line: usize,
    },
    /// The regions with these indices.
    Numbers {
        /// The indices, ascending, from 0 in the file's order, each with its line in the suite.
        numbers: Vec<(usize, usize)>,
        /// The suite.
        file: String,
    },
}

impl Selected {
    fn read(table: &Fields<'_, '_>) -> Result<Selected, CorpusError> {
        match (table.get("ids"), table.get("regions")) {
            (None, None) => Ok(Selected::All),
            (Some(_), Some(regions)) => Err(regions.error("regions by ids and by numbers", "keep one of the two")),
            (Some(ids), None) => {
                let begin = ids.string()?;
                if begin.is_empty() {
                    return Err(ids.error("`ids` is empty", "write how ids begin, or leave `ids` out"));
                }
                Ok(Selected::Ids { begin, file: ids.file().to_owned(), line: ids.line() })
            }
            (None, Some(regions)) => {
                const NUMBERS: &str = "an array of the numbers of regions, from 0 in the file's order";
                let mut numbers: Vec<(usize, usize)> = Vec::new();
                for number in regions.items(NUMBERS)? {
                    let (value, line) = (number.count(0..=u64::from(u32::MAX))?, number.line());
                    if numbers.last().is_some_and(|&(last, _)| last >= value) {
                        return Err(number.error("regions out of order", "write each once, the smallest first"));
                    }
                    numbers.push((value, line));
                }
                if numbers.is_empty() {
                    return Err(regions.error("`regions` is empty", format!("write {NUMBERS}")));
                }
                Ok(Selected::Numbers { numbers, file: regions.file().to_owned() })
            }
        }
    }

    /// Reads with only these regions; an error if there are none.
    fn of<T>(&self, read: impl FnOnce(&mut Keeps<'_>) -> Result<T, CorpusError>) -> Result<T, CorpusError> {
        match self {
            Selected::All => read(&mut |_, _| true),
            Selected::Ids { begin, file, line } => {
                let (mut seen, mut kept) = (0, 0);
                let found = read(&mut |_, id| {
                    let is_kept = id.is_some_and(|id| id.starts_with(begin.as_str()));
                    seen += 1;
                    kept += usize::from(is_kept);
                    is_kept
                })?;
                if kept == 0 {
                    let message = format!("no id of the {seen} regions begins with `{begin}`");
                    return Err(CorpusError::file(file, message, "correct `ids`").at_line(*line));
                }
                Ok(found)
            }
            Selected::Numbers { numbers, file } => {
                let mut seen = 0;
                let found = read(&mut |number, _| {
                    seen = number + 1;
                    numbers.binary_search_by_key(&number, |&(number, _)| number).is_ok()
                })?;
                if let Some((number, line)) = numbers.iter().find(|&&(number, _)| number >= seen) {
                    let message = format!("there is no region {number}: the file has {seen}");
                    return Err(CorpusError::file(file, message, "numbers count from 0").at_line(*line));
                }
                Ok(found)
            }
        }
    }
}

/// A map whose notes include the number of rounded decimals.
fn rounding(
    round: bool,
    read: impl FnOnce(&Decimals) -> Result<ImportedMap, CorpusError>,
) -> Result<ImportedMap, CorpusError> {
    let decimals = Decimals::new(round);
    let mut map = read(&decimals)?;
    map.notes.rounded += decimals.rounded();
    Ok(map)
}
