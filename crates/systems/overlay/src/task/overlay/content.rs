//! The keys of the task: `segments`, or two operands `first` and `second`; and the method.

use crate::algorithm::overlay::{Edge, Method, Polygon, Rule};
use predicament_corpus::{
    Canon, Content, Context, Elsewhere, Items, Level, List, Parts, PointSource, Source, Spelled, spelled_points,
};
use predicament_formats::{Cache, CorpusError, Entry, Field, Fields};
use predicament_predicates::{Dimension, Scene, Vertex};

use predicament_tasks::map_source::MapSource;

/// The input of an overlay.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Layers {
    /// Segments as pairs of ends, to be arranged.
    Segments(Vec<[Vertex; 2]>),
    /// Two operands, each as loops of vertices, and the rule for their inside.
    Polygons([Vec<Vec<Vertex>>; 2], Rule),
}

/// The input of an overlay, and the method.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Layered {
    /// The input.
    pub layers: Layers,
    /// The method to find segments that meet.
    pub method: Method,
}

impl Layered {
    /// The two operands; `None` if segments are arranged.
    #[must_use]
    pub fn operands(&self) -> Option<[Polygon; 2]> {
        match &self.layers {
            Layers::Segments(_) => None,
            Layers::Polygons(loops, rule) => Some(loops.each_ref().map(|loops| Polygon::of_vertices(loops, *rule))),
        }
    }

    /// The segments, or the sides of the polygons.
    pub(super) fn segments(&self) -> Vec<[Vertex; 2]> {
        match &self.layers {
            Layers::Segments(segments) => segments.clone(),
            Layers::Polygons(loops, _) => loops
                .iter()
                .flatten()
                .flat_map(|one| one.iter().zip(one.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]))
                .collect(),
        }
    }

    /// The segments as edges.
    pub(super) fn edges(&self) -> Vec<Edge> {
        match &self.layers {
            Layers::Segments(segments) => segments.iter().map(|&[a, b]| Edge::whole(a, b)).collect(),
            Layers::Polygons(..) => Vec::new(),
        }
    }

    /// The number of segments or corners.
    #[must_use]
    pub fn size(&self) -> usize {
        match &self.layers {
            Layers::Segments(segments) => segments.len(),
            Layers::Polygons(loops, _) => loops.iter().flatten().map(Vec::len).sum(),
        }
    }
}

impl Content for Layered {
    fn count(&self) -> usize {
        self.size()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("overlay2d");
        canon.text(method_name(self.method));
        match &self.layers {
            Layers::Segments(segments) => {
                canon.text("segments");
                canon.vertices(segments.as_flattened());
            }
            Layers::Polygons(operands, rule) => {
                canon.text(rule_name(*rule));
                for loops in operands {
                    canon.count(loops.len());
                    loops.iter().for_each(|one| canon.vertices(one));
                }
            }
        }
    }

    /// Returns `None` if there is nothing to overlay, as with two maps without rings.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let mut words = vec![("method", format!("\"{}\"", method_name(self.method)))];
        let lists = match &self.layers {
            Layers::Segments(segments) => vec![List::required("segments", Items::tuples(segments))],
            Layers::Polygons([first, second], rule) => {
                words.push(("rule", format!("\"{}\"", rule_name(*rule))));
                let [first, second] = [first, second].map(|loops| Items::Loops(loops.clone()));
                vec![List::required("first", first), List::new("second", second)]
            }
        };
        (!lists[0].items.is_empty()).then(|| Spelled { words, lists, ..spelled_points(scene) })
    }
}

/// The name of a method in suites.
pub(super) const fn method_name(method: Method) -> &'static str {
    match method {
        Method::Grid => "grid",
        Method::Sweep => "sweep",
    }
}

const fn rule_name(rule: Rule) -> &'static str {
    match rule {
        Rule::EvenOdd => "even-odd",
        Rule::NonZero => "non-zero",
    }
}

/// Reads `method`.
pub(super) fn read_method(fields: &Fields<'_, '_>) -> Result<Method, CorpusError> {
    let Some(field) = fields.get("method") else { return Ok(Method::default()) };
    let name = field.str()?;
    let known = [Method::Grid, Method::Sweep].into_iter().find(|&method| method_name(method) == name);
    known.ok_or_else(|| field.error(format!("unknown method `{name}`"), "write \"grid\" or \"sweep\""))
}

fn read_rule(fields: &Fields<'_, '_>) -> Result<Rule, CorpusError> {
    let Some(field) = fields.get("rule") else { return Ok(Rule::default()) };
    let name = field.str()?;
    let known = [Rule::EvenOdd, Rule::NonZero].into_iter().find(|&rule| rule_name(rule) == name);
    known.ok_or_else(|| field.error(format!("unknown rule `{name}`"), "write \"even-odd\" or \"non-zero\""))
}

/// Reads `points` with `segments`, or with `first` and `second`; or maps as these.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let method = read_method(fields)?;
    let rule = read_rule(fields)?;
    let [a, b] = [fields.get("first"), fields.get("second")];
    if let Some(map) = a.as_ref().filter(|a| a.is_table()) {
        if let Some(other) = fields.get("points").or_else(|| fields.get("segments")) {
            return Err(other.error("polygons with two sources", "keep the maps, or `points`"));
        }
        let second = b.as_ref().map(|b| MapSource::read(context, b)).transpose()?;
        let maps = [Some(MapSource::read(context, map)?), second];
        return Ok(Source::elsewhere(InMaps { maps, rule, method }));
    }
    let points = PointSource::read(context, &fields.required("points")?, fields.file())?;
    let segments = fields.get("segments");
    let layers = match (a, segments) {
        (Some(_), Some(segments)) => {
            return Err(segments.error("segments and polygons", "keep `segments`, or `first` and `second`"));
        }
        (Some(a), None) => {
            let second = b.map_or_else(|| Ok(Vec::new()), |b| read_lists(&b, LOOPS))?;
            Lists::Loops([read_lists(&a, LOOPS)?, second])
        }
        (None, Some(segments)) => Lists::Segments(read_lists(&segments, SEGMENTS)?),
        (None, None) => {
            let error =
                CorpusError::file(fields.file(), "nothing to overlay", "write `segments`, or `first` and `second`");
            return Err(error.at_line(fields.required("points")?.line()));
        }
    };
    let asked = OfPoints { points, layers, rule, method, file: fields.file().to_owned() };
    if asked.points.is_written() {
        // No cache is read: all coordinates are in the suite.
        return Ok(Source::Written(asked.load(Level::Quick, &Cache::new(""))?));
    }
    Ok(Source::elsewhere(asked))
}

const LOOPS: &str = "loops: arrays with the indices of points, one array for each loop";
const SEGMENTS: &str = "segments: arrays with the indices of two points";

/// Lists of vertices, each with its line in the suite.
type Listed = Vec<(usize, Vec<Vertex>)>;

fn read_lists(field: &Field<'_, '_>, wanted: &str) -> Result<Listed, CorpusError> {
    let one = |item: Field<'_, '_>| {
        let corners: Vec<Vertex> = item.items(wanted)?.map(|corner| corner.point()).collect::<Result<_, _>>()?;
        Ok((item.line(), corners))
    };
    field.items(wanted)?.map(one).collect()
}

enum Lists {
    Segments(Listed),
    Loops([Listed; 2]),
}

/// Segments or loops over points that are written out or in a data file.
struct OfPoints {
    points: PointSource,
    layers: Lists,
    rule: Rule,
    method: Method,
    file: String,
}

impl Elsewhere for OfPoints {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (scene, notes) = self.points.scene(cache)?;
        if scene.dimension() == Dimension::Three {
            let message = "overlay2d takes points with 2 coordinates, not 3";
            return Err(self.points.error(message, "give every point 2 coordinates"));
        }
        let error =
            |line: usize, message: String, cure: &str| CorpusError::file(&self.file, message, cure).at_line(line);
        let layers = match &self.layers {
            Lists::Segments(listed) => {
                let mut segments = Vec::with_capacity(listed.len());
                for (line, ends) in listed {
                    self.known(&scene, *line, ends)?;
                    let &[a, b] = ends.as_slice() else {
                        let message = format!("a segment with {} ends", ends.len());
                        return Err(error(*line, message, "write the indices of two points"));
                    };
                    if a == b {
                        return Err(error(*line, format!("both ends are point {a}"), "name two points"));
                    }
                    segments.push([a, b]);
                }
                if segments.is_empty() {
                    return Err(self.points.error("a scene without segments", "write at least one"));
                }
                Layers::Segments(segments)
            }
            Lists::Loops(operands) => {
                for (line, one) in operands.iter().flatten() {
                    self.known(&scene, *line, one)?;
                    if one.len() < 3 {
                        let message = format!("a loop with {} corners has no inside", one.len());
                        return Err(error(*line, message, "give it three corners, or leave it out"));
                    }
                    if one.first() == one.last() {
                        let message = format!("the corner {} is both the first and the last of its loop", one[0]);
                        return Err(error(*line, message, "write it once: the reader closes loops"));
                    }
                    if let Some(pair) = one.windows(2).find(|pair| pair[0] == pair[1]) {
                        let message = format!("the corner {} occurs twice in a row", pair[0]);
                        return Err(error(*line, message, "write it once"));
                    }
                }
                if operands[0].is_empty() {
                    return Err(self.points.error("an operand without loops", "write at least one loop for `first`"));
                }
                let plain = operands.each_ref().map(|loops| loops.iter().map(|(_, one)| one.clone()).collect());
                Layers::Polygons(plain, self.rule)
            }
        };
        Ok(Parts { notes, ..Parts::new(scene, Layered { layers, method: self.method }) })
    }
}

impl OfPoints {
    fn known(&self, scene: &Scene, line: usize, vertices: &[Vertex]) -> Result<(), CorpusError> {
        let Some(unknown) = vertices.iter().find(|v| v.index() >= scene.len()) else { return Ok(()) };
        let message = format!("the point {unknown} is out of range: the scene has {} points", scene.len());
        Err(CorpusError::file(&self.file, message, "indices count from 0").at_line(line))
    }
}

/// Two maps, each an operand: a point is inside if an odd number of its regions' rings surrounds it. Points with equal
/// coordinates are merged.
struct InMaps {
    maps: [Option<MapSource>; 2],
    rule: Rule,
    method: Method,
}

impl Elsewhere for InMaps {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let mut welded: std::collections::HashMap<[u64; 2], Vertex> = std::collections::HashMap::new();
        let mut points: Vec<[f64; 2]> = Vec::new();
        let mut notes = predicament_formats::ImportNotes::default();
        let mut operands = [Vec::new(), Vec::new()];
        for (loops, map) in operands.iter_mut().zip(&self.maps) {
            let Some(map) = map else { continue };
            let imported = map.map(cache)?;
            notes.add(&imported.notes);
            let mut weld = |v: &Vertex| {
                let point = imported.points[v.index()];
                // Zero has two signs and one position.
                *welded.entry(point.map(|x| (x + 0.0).to_bits())).or_insert_with(|| {
                    points.push(point);
                    Vertex::input(points.len() - 1)
                })
            };
            for ring in imported.map.regions().iter().flat_map(|region| &region.rings) {
                loops.push(ring.vertices().iter().map(&mut weld).collect());
            }
        }
        let scene = Scene::from_points2(&points)
            .map_err(|error| CorpusError::file("map", error.to_string(), "divide the data"))?;
        let layers = Layers::Polygons(operands, self.rule);
        Ok(Parts { notes, ..Parts::new(scene, Layered { layers, method: self.method }) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.maps.iter().flatten().find_map(MapSource::entry)
    }
}
