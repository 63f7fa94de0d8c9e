//! The reader of GeoJSON (RFC 7946).
//!
//! The crate `geojson` rounds every number to a double while it reads; here a number must keep its text, to be read
//! losslessly or refused. `serde_json` keeps texts (`RawValue`) and their positions. A `crs` and other members that do
//! not affect shapes are skipped.

use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::Value;
use serde_json::value::RawValue;

use super::features::{CLOSE, DEEPEST, Feature, Geometry, Position, Shape, open};
use super::{ImportNotes, Keeps, id_text};
use crate::coordinate;
use crate::decimals::{Place as Written, ends, explain, shown};
use crate::{CorpusError, Decimals, Lines};

/// Any object of GeoJSON.
#[derive(Deserialize)]
struct Object<'t> {
    #[serde(rename = "type")]
    kind: Option<String>,
    #[serde(borrow)]
    features: Option<&'t RawValue>,
    #[serde(borrow)]
    geometry: Option<&'t RawValue>,
    #[serde(borrow)]
    geometries: Option<&'t RawValue>,
    #[serde(borrow)]
    coordinates: Option<&'t RawValue>,
    properties: Option<Properties>,
    id: Option<Value>,
}

#[derive(Deserialize)]
struct Properties {
    name: Option<Value>,
}

/// A collection of features, for a reader of one pass.
#[derive(Deserialize)]
struct Collection<'t> {
    #[serde(rename = "type")]
    kind: &'t str,
    #[serde(borrow)]
    features: Vec<&'t RawValue>,
}

/// A feature, for a reader of one pass.
#[derive(Deserialize)]
struct Plain<'t> {
    #[serde(rename = "type")]
    kind: Option<&'t str>,
    #[serde(borrow)]
    geometry: Option<Member<'t>>,
    properties: Option<Properties>,
    id: Option<Value>,
}

/// An object that is a member of another; an array of its values, which serde would accept, is refused.
struct Member<'t>(Object<'t>);

impl<'de: 't, 't> Deserialize<'de> for Member<'t> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Member<'t>, D::Error> {
        struct Members<'t>(PhantomData<&'t ()>);
        impl<'de: 't, 't> Visitor<'de> for Members<'t> {
            type Value = Member<'t>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, members: A) -> Result<Member<'t>, A::Error> {
                Object::deserialize(MapAccessDeserializer::new(members)).map(Member)
            }
        }
        deserializer.deserialize_map(Members(PhantomData))
    }
}

/// Parses an object of JSON; `None` if it is not one, or has other members.
fn only_object<'t, T: Deserialize<'t>>(text: &'t str) -> Option<T> {
    if text.trim_ascii_start().starts_with('{') { serde_json::from_str(text).ok() } else { None }
}

/// A path in the file: `features[3].geometry.coordinates[0][2]`.
#[derive(Clone, Copy)]
struct Place<'p> {
    before: Option<&'p Place<'p>>,
    step: Step<'p>,
}

#[derive(Clone, Copy)]
enum Step<'p> {
    Key(&'p str),
    Index(usize),
}

impl Place<'_> {
    fn key<'s>(&'s self, key: &'s str) -> Place<'s> {
        Place { before: Some(self), step: Step::Key(key) }
    }

    fn index(&self, index: usize) -> Place<'_> {
        Place { before: Some(self), step: Step::Index(index) }
    }

    /// The path, shortened to its beginning and end if it is long.
    fn short(&self) -> String {
        ends(&self.to_string(), 120)
    }
}

impl fmt::Display for Place<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(before) = self.before {
            write!(f, "{before}")?;
        }
        match (self.step, self.before.is_some_and(|before| before.before.is_some())) {
            (Step::Key(key), true) => write!(f, ".{key}"),
            (Step::Key(key), false) => f.write_str(key),
            (Step::Index(index), _) => write!(f, "[{index}]"),
        }
    }
}

/// Reads the selected features of a GeoJSON file.
///
/// # Errors
/// [`CorpusError`] at the line that is wrong, with the path in the file if the line is not enough.
pub fn read(file: &str, text: &str, decimals: &Decimals, keeps: &mut Keeps<'_>) -> Result<Geometry, CorpusError> {
    // A collection is read in one pass. If that fails, the passes below find out why.
    if let Some(Collection { kind, features }) = only_object(text)
        && kind == "FeatureCollection"
    {
        let mut reader = Reader::new(file, text, decimals);
        reader.all(features, &ROOT, keeps)?;
        return Ok(reader.finish());
    }
    let (mut reader, whole) = Reader::open(file, text, decimals)?;
    if whole.get().starts_with('[') {
        reader.bare_rings(whole, &ROOT, keeps)?;
    } else {
        reader.feature(whole, &ROOT, keeps)?;
    }
    Ok(reader.finish())
}

/// Reads an array of rings that is a member of a JSON object.
///
/// # Errors
/// As [`read`], and if the member does not exist.
pub fn read_member(
    file: &str,
    text: &str,
    member: &str,
    decimals: &Decimals,
    keeps: &mut Keeps<'_>,
) -> Result<Geometry, CorpusError> {
    let (mut reader, whole) = Reader::open(file, text, decimals)?;
    if !whole.get().starts_with('{') {
        return Err(reader.error(whole, &ROOT, "not an object", "leave out `member`"));
    }
    let members: BTreeMap<String, &RawValue> = reader.parsed(whole)?;
    let Some(rings) = members.get(member) else {
        let known: Vec<String> = members.keys().map(|name| format!("`{}`", shown(name))).collect();
        let message = format!("the object has no member `{}`", shown(member));
        return Err(reader.error(whole, &ROOT, &message, format!("use one of {}", ends(&known.join(", "), 120))));
    };
    reader.bare_rings(rings, &ROOT.key(member), keeps)?;
    Ok(reader.finish())
}

const ROOT: Place<'static> = Place { before: None, step: Step::Key("") };

struct Reader<'r, 't> {
    file: &'r str,
    text: &'t str,
    lines: Lines,
    decimals: &'r Decimals,
    notes: ImportNotes,
    features: Vec<Feature>,
    /// The number of features seen so far.
    seen: usize,
}

impl<'r, 't> Reader<'r, 't> {
    fn new(file: &'r str, text: &'t str, decimals: &'r Decimals) -> Reader<'r, 't> {
        let (lines, notes) = (Lines::new(text), ImportNotes::default());
        Reader { file, text, lines, decimals, notes, features: Vec::new(), seen: 0 }
    }

    /// A reader, and the whole file as one value: the syntax of the file is checked completely before any part is read.
    fn open(
        file: &'r str,
        text: &'t str,
        decimals: &'r Decimals,
    ) -> Result<(Reader<'r, 't>, &'t RawValue), CorpusError> {
        let reader = Reader::new(file, text, decimals);
        let whole = reader.part(text, 0)?;
        Ok((reader, whole))
    }

    fn finish(self) -> Geometry {
        Geometry { file: self.file.to_owned(), features: self.features, notes: self.notes }
    }

    /// True if the next feature is selected.
    fn is_wanted(&mut self, id: Option<&str>, keeps: &mut Keeps<'_>) -> bool {
        let number = self.seen;
        self.seen += 1;
        keeps(number, id)
    }

    fn line(&self, raw: &str) -> usize {
        self.lines.of(raw.as_ptr().addr() - self.text.as_ptr().addr())
    }

    fn error(&self, raw: &RawValue, place: &Place<'_>, message: &str, cure: impl Into<String>) -> CorpusError {
        let place = place.short();
        let message = if place.is_empty() { message.to_owned() } else { format!("{place}: {message}") };
        CorpusError::file(self.file, message, cure).at_line(self.line(raw.get()))
    }

    /// Parses a part of the file, which starts at a line (counted from 0).
    fn part<'p, T: Deserialize<'p>>(&self, text: &'p str, line: usize) -> Result<T, CorpusError> {
        serde_json::from_str(text).map_err(|error| {
            // serde_json appends the position, which is already in `line`.
            let whole = error.to_string();
            let message = whole.rsplit_once(" at line ").map_or(whole.as_str(), |(message, _)| message);
            let cure = if error.is_eof() {
                "the file ends early: fetch or copy it again"
            } else {
                "give a valid GeoJSON file"
            };
            CorpusError::file(self.file, format!("not GeoJSON: {message}"), cure).at_line(line + error.line())
        })
    }

    fn parsed<T: Deserialize<'t>>(&self, raw: &'t RawValue) -> Result<T, CorpusError> {
        self.part(raw.get(), self.line(raw.get()) - 1)
    }

    /// Reads a collection of features, a feature, or a geometry.
    fn feature(&mut self, raw: &'t RawValue, place: &Place<'_>, keeps: &mut Keeps<'_>) -> Result<(), CorpusError> {
        let object = self.object(raw, place)?;
        let line = self.line(raw.get());
        match object.kind.as_deref() {
            Some("FeatureCollection") => {
                let features = object.features.ok_or_else(|| {
                    self.error(raw, place, "a FeatureCollection without features", "give it `features`")
                })?;
                self.all(self.items(features, &place.key("features"))?, place, keeps)
            }
            Some("Feature") => self.one(object, line, place, keeps),
            Some("Topology") => {
                let cure = "for a map write `topojson = \"…\"` and `object = \"…\"`; else convert it to GeoJSON";
                Err(self.error(raw, place, "the file is TopoJSON", cure))
            }
            _ => {
                if !self.is_wanted(None, keeps) {
                    return Ok(());
                }
                let mut shapes = Vec::new();
                self.geometry(raw, place, 0, &mut shapes)?;
                self.features.push(Feature { name: None, line, shapes });
                Ok(())
            }
        }
    }

    /// Reads the features of a collection.
    fn all(
        &mut self,
        features: Vec<&'t RawValue>,
        place: &Place<'_>,
        keeps: &mut Keeps<'_>,
    ) -> Result<(), CorpusError> {
        let place = place.key("features");
        for (index, raw) in features.into_iter().enumerate() {
            let place = place.index(index);
            let line = self.line(raw.get());
            let Some(Plain { kind: Some("Feature"), geometry, properties, id }) = only_object(raw.get()) else {
                let object = self.object(raw, &place)?;
                if object.kind.as_deref() != Some("Feature") {
                    return Err(self.error(raw, &place, "not a Feature", "list features only"));
                }
                self.one(object, line, &place, keeps)?;
                continue;
            };
            if !self.is_wanted(id_text(id.as_ref()).as_deref(), keeps) {
                continue;
            }
            let mut shapes = Vec::new();
            let read = geometry
                .map_or(Ok(()), |Member(object)| self.shapes(object, raw, &place.key("geometry"), 0, &mut shapes));
            if read.is_err() {
                // The same error, with the line of the geometry.
                let object = self.object(raw, &place)?;
                let geometry = object.geometry.map(|raw| self.geometry(raw, &place.key("geometry"), 0, &mut shapes));
                geometry.unwrap_or(read)?;
            }
            let name = super::topojson::name(properties.and_then(|all| all.name).as_ref(), id.as_ref());
            self.features.push(Feature { name, line, shapes });
        }
        Ok(())
    }

    /// Reads a feature, which starts at a line.
    fn one(
        &mut self,
        object: Object<'t>,
        line: usize,
        place: &Place<'_>,
        keeps: &mut Keeps<'_>,
    ) -> Result<(), CorpusError> {
        if !self.is_wanted(id_text(object.id.as_ref()).as_deref(), keeps) {
            return Ok(());
        }
        let mut shapes = Vec::new();
        if let Some(geometry) = object.geometry {
            self.geometry(geometry, &place.key("geometry"), 0, &mut shapes)?;
        }
        let name = super::topojson::name(object.properties.and_then(|all| all.name).as_ref(), object.id.as_ref());
        self.features.push(Feature { name, line, shapes });
        Ok(())
    }

    /// Reads the rings of one polygon and nothing around them, closed or not: the format of triangulators' test data.
    fn bare_rings(&mut self, raw: &'t RawValue, place: &Place<'_>, keeps: &mut Keeps<'_>) -> Result<(), CorpusError> {
        if !self.is_wanted(None, keeps) {
            return Ok(());
        }
        let mut rings = Vec::new();
        for (index, ring) in self.items(raw, place)?.into_iter().enumerate() {
            let positions = self.positions(ring, &place.index(index))?;
            rings.push(open(positions.clone()).unwrap_or(positions));
        }
        self.features.push(Feature { name: None, line: self.line(raw.get()), shapes: vec![Shape::Polygon(rings)] });
        Ok(())
    }

    fn geometry(
        &mut self,
        raw: &'t RawValue,
        place: &Place<'_>,
        depth: usize,
        shapes: &mut Vec<Shape>,
    ) -> Result<(), CorpusError> {
        let object = self.object(raw, place)?;
        self.shapes(object, raw, place, depth, shapes)
    }

    /// Adds the shapes of a geometry.
    fn shapes(
        &mut self,
        object: Object<'t>,
        raw: &'t RawValue,
        place: &Place<'_>,
        depth: usize,
        shapes: &mut Vec<Shape>,
    ) -> Result<(), CorpusError> {
        let kind = object.kind.as_deref().unwrap_or_default();
        if kind == "GeometryCollection" {
            if depth == DEEPEST {
                let message = format!("more than {DEEPEST} nested collections");
                return Err(self.error(raw, place, &message, "list their members in one"));
            }
            let members = object.geometries.ok_or_else(|| {
                self.error(raw, place, "a GeometryCollection without geometries", "give it `geometries`")
            })?;
            for (index, member) in self.items(members, &place.key("geometries"))?.into_iter().enumerate() {
                self.geometry(member, &place.key("geometries").index(index), depth + 1, shapes)?;
            }
            return Ok(());
        }
        let known = ["Point", "MultiPoint", "LineString", "MultiLineString", "Polygon", "MultiPolygon"];
        if !known.contains(&kind) {
            let message = if kind.is_empty() {
                "an object without a type".to_owned()
            } else {
                format!("no geometry is of type `{}`", shown(kind))
            };
            return Err(self.error(raw, place, &message, format!("use one of {}", known.join(", "))));
        }
        let coordinates = object
            .coordinates
            .ok_or_else(|| self.error(raw, place, &format!("a {kind} without coordinates"), "give it `coordinates`"))?;
        let place = &place.key("coordinates");
        match kind {
            "Point" => {
                // An empty array is a point without a position.
                if !self.items(coordinates, place)?.is_empty() {
                    shapes.push(Shape::Point(self.position(coordinates, place)?));
                }
            }
            "MultiPoint" => shapes.extend(self.positions(coordinates, place)?.into_iter().map(Shape::Point)),
            "LineString" => shapes.push(Shape::Line(self.positions(coordinates, place)?)),
            "MultiLineString" => {
                for (index, line) in self.items(coordinates, place)?.into_iter().enumerate() {
                    shapes.push(Shape::Line(self.positions(line, &place.index(index))?));
                }
            }
            "Polygon" => shapes.push(self.polygon(coordinates, place)?),
            _ => {
                for (index, polygon) in self.items(coordinates, place)?.into_iter().enumerate() {
                    shapes.push(self.polygon(polygon, &place.index(index))?);
                }
            }
        }
        Ok(())
    }

    fn polygon(&mut self, raw: &'t RawValue, place: &Place<'_>) -> Result<Shape, CorpusError> {
        if let Some(rings) = self.plain(raw.get(), 3)
            && let Ok(rings) = rings.into_iter().map(open).collect()
        {
            return Ok(Shape::Polygon(rings));
        }
        let mut rings = Vec::new();
        for (index, ring) in self.items(raw, place)?.into_iter().enumerate() {
            let place = place.index(index);
            let positions = self.positions(ring, &place)?;
            rings.push(open(positions).map_err(|(line, what)| {
                CorpusError::file(self.file, format!("{}: {what}", place.short()), CLOSE).at_line(line)
            })?);
        }
        Ok(Shape::Polygon(rings))
    }

    fn positions(&mut self, raw: &'t RawValue, place: &Place<'_>) -> Result<Vec<Position>, CorpusError> {
        if let Some(positions) = self.plain(raw.get(), 2).and_then(|mut lists| lists.pop()) {
            return Ok(positions);
        }
        let items = self.items(raw, place)?.into_iter().enumerate();
        items.map(|(index, position)| self.position(position, &place.index(index))).collect()
    }

    fn position(&mut self, raw: &'t RawValue, place: &Place<'_>) -> Result<Position, CorpusError> {
        let numbers = self.items(raw, place)?;
        let (&[x, y], rest) = numbers.split_first_chunk().ok_or_else(|| {
            self.error(raw, place, &format!("a position of {} numbers", numbers.len()), "write at least two")
        })?;
        let number = |raw: &RawValue| {
            self.decimals.read(raw.get()).map_err(|why| {
                let (message, cure) = explain(Written::Data, raw.get(), &why);
                self.error(raw, place, &message, cure)
            })
        };
        let at = [number(x)?, number(y)?];
        let height = rest.first().map(|z| number(z)).transpose()?;
        self.notes.extra_coordinates += rest.len().saturating_sub(1);
        Ok(Position { at, height, line: self.line(raw.get()) })
    }

    /// Reads an array of positions of two numbers each (`deep` = 2), or an array of such arrays (3), without another
    /// parse; `None` if it is something else, or a number is not a coordinate. The text is known to be valid JSON.
    fn plain(&self, text: &'t str, deep: usize) -> Option<Vec<Vec<Position>>> {
        if self.decimals.keeps() {
            return None;
        }
        let (mut lists, mut list, mut numbers) = (Vec::new(), Vec::new(), [0.0; 2]);
        let (mut depth, mut count, mut start, mut at) = (0, 0, 0, 0);
        let mut total = 0;
        while let Some(&byte) = text.as_bytes().get(at) {
            match byte {
                b'[' => (depth, count, start) = (depth + 1, 0, at),
                b'-' | b'0'..=b'9' if depth == deep && count < 2 => {
                    let rest = &text[at..];
                    let end =
                        rest.bytes().position(|byte| !matches!(byte, b'-' | b'+' | b'.' | b'e' | b'E' | b'0'..=b'9'));
                    let word = &rest[..end?];
                    numbers[count] = coordinate::read(word).ok()?;
                    (at, count) = (at + word.len() - 1, count + 1);
                }
                b']' if depth == deep && count == 2 => {
                    depth -= 1;
                    list.push(Position { at: numbers, height: None, line: self.line(&text[start..]) });
                }
                b']' if depth + 1 == deep => {
                    depth -= 1;
                    total += list.len();
                    lists.push(std::mem::take(&mut list));
                }
                b']' if depth > 0 && depth < deep => depth -= 1,
                b',' | b' ' | b'\t' | b'\n' | b'\r' => {}
                _ => return None,
            }
            at += 1;
        }
        self.decimals.count(2 * total).ok()?;
        Some(lists)
    }

    /// Parses an object; an array of its values, which serde would accept, is refused.
    fn object(&self, raw: &'t RawValue, place: &Place<'_>) -> Result<Object<'t>, CorpusError> {
        if !raw.get().starts_with('{') {
            return Err(self.error(raw, place, "not an object", "give an object with a `type`"));
        }
        self.parsed(raw)
    }

    /// The members of an array.
    fn items(&self, raw: &'t RawValue, place: &Place<'_>) -> Result<Vec<&'t RawValue>, CorpusError> {
        if !raw.get().starts_with('[') {
            return Err(self.error(raw, place, "not an array", "give an array"));
        }
        self.parsed(raw)
    }
}

#[cfg(test)]
mod tests;
