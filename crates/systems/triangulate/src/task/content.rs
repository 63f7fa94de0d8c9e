//! The keys of the task: `points` and `loops`, or `map`; polygons to triangulate, in the plane or in space.

use crate::algorithm::Method;
use predicament_corpus::{
    Canon, Content, Context, Elsewhere, Items, Level, List, Parts, PointSource, Source, Spelled, spelled_points,
};
use predicament_formats::{Cache, CorpusError, Entry, Fields};
use predicament_predicates::{Scene, Vertex};

use crate::truth::{Examined, Flaw, first_flaw_if_all};
use predicament_tasks::map_loops::{Loops, MapLoops, labelled_loops, read_loops};
use predicament_tasks::map_source::MapSource;

/// Polygons and the method to triangulate them.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Polygons {
    /// The loops of each polygon, in either direction: a point is inside if an odd number of loops surrounds it. In
    /// space, all vertices of a polygon are in one plane.
    pub polygons: Vec<Vec<Vec<Vertex>>>,
    /// The method of triangulation.
    pub method: Method,
}

impl Content for Polygons {
    fn count(&self) -> usize {
        self.polygons.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("triangulate");
        canon.text(method_name(self.method));
        canon.count(self.polygons.len());
        for polygon in &self.polygons {
            canon.count(polygon.len());
            polygon.iter().for_each(|one| canon.vertices(one));
        }
    }

    /// Writes several polygons with `regions`, as a map. Returns `None` if there are no polygons.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let list = match &self.polygons[..] {
            [] => return None,
            [polygon] => List::required("loops", Items::Loops(polygon.clone())),
            polygons => labelled_loops(polygons)?,
        };
        let words = vec![("method", format!("\"{}\"", method_name(self.method)))];
        Some(Spelled { words, lists: vec![list], ..spelled_points(scene) })
    }
}

/// The name of a method in suites.
pub(super) const fn method_name(method: Method) -> &'static str {
    match method {
        Method::Ears => "ears",
        Method::Monotone => "monotone",
    }
}

/// Reads `method`.
pub(super) fn read_method(fields: &Fields<'_, '_>) -> Result<Method, CorpusError> {
    let Some(field) = fields.get("method") else { return Ok(Method::default()) };
    let name = field.str()?;
    let known = [Method::Monotone, Method::Ears].into_iter().find(|&method| method_name(method) == name);
    known.ok_or_else(|| field.error(format!("unknown method `{name}`"), "write \"monotone\" or \"ears\""))
}

/// Reads `points` and `loops`, perhaps with `regions`, or `map`; and `method`.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let method = read_method(fields)?;
    let Some(map) = fields.get("map") else {
        if fields.get("regions").is_some() {
            let map = MapSource::Loops(MapLoops::read(context, fields)?);
            return Ok(Source::elsewhere(InMap { map, method }));
        }
        let points = PointSource::read(context, &fields.required("points")?, fields.file())?;
        let asked = OfPoints {
            points,
            loops: fields.get("loops").map(|field| read_loops(&field)).transpose()?,
            file: fields.file().to_owned(),
            method,
            is_invalid: context.is_invalid(),
        };
        if asked.points.is_written() {
            // No cache is read: all coordinates are in the suite.
            return Ok(Source::Written(asked.load(Level::Quick, &Cache::new(""))?));
        }
        return Ok(Source::elsewhere(asked));
    };
    if let Some(other) = ["points", "loops", "regions"].into_iter().find_map(|key| fields.get(key)) {
        return Err(other.error("polygons with two sources", "keep `map`, or `points` and `loops`"));
    }
    Ok(Source::elsewhere(InMap { map: MapSource::read(context, &map)?, method }))
}

/// Loops over points that are written out or in a data file; without loops, all points in order make one loop.
struct OfPoints {
    points: PointSource,
    loops: Option<Loops>,
    file: String,
    method: Method,
    /// True if the scene is marked as invalid input.
    is_invalid: bool,
}

impl Elsewhere for OfPoints {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let points = self.points.located(cache)?;
        let scene = &points.scene;
        let loops = match &self.loops {
            Some(loops) => loops.clone(),
            None => vec![(0, scene.vertices().collect())],
        };
        for (line, one) in &loops {
            let error = |message: String, cure: &str| match line {
                0 => self.points.error(message, cure),
                line => CorpusError::file(&self.file, message, cure).at_line(*line),
            };
            if let Some(unknown) = one.iter().find(|v| v.index() >= scene.len()) {
                let message = format!("the corner {unknown} is out of range: the scene has {} points", scene.len());
                return Err(error(message, "indices count from 0"));
            }
            if one.len() < 3 {
                let message = format!("a loop with {} corners has no inside", one.len());
                return Err(error(message, "give it three corners, or leave it out"));
            }
            if let Some((corner, _)) = one.iter().zip(one.iter().cycle().skip(1)).find(|(a, b)| a == b) {
                let places = points.places(&[*corner]);
                return Err(error(format!("the corner {corner} occurs twice in a row{places}"), "write it once"));
            }
        }
        let loops: Vec<Vec<Vertex>> = loops.into_iter().map(|(_, one)| one).collect();
        if loops.is_empty() {
            return Err(self.points.error("a polygon without loops", "write at least one loop"));
        }
        // The judge finds the flaw again.
        let flaw = if self.is_invalid { None } else { Examined::new(scene, &loops).flaw };
        if let Some(Flaw { why, vertices, cure }) = flaw {
            return Err(self.points.error(why + &points.places(&vertices), cure));
        }
        Ok(Parts {
            notes: points.notes,
            ..Parts::new(points.scene, Polygons { polygons: vec![loops], method: self.method })
        })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.points.entry()
    }
}

/// The regions of a map, each as a polygon.
struct InMap {
    map: MapSource,
    method: Method,
}

impl Elsewhere for InMap {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let imported = self.map.map(cache)?;
        let rings = |region: &predicament_mesh::Region| -> Vec<Vec<Vertex>> {
            region.rings.iter().map(|ring| ring.vertices().to_vec()).collect()
        };
        let polygons: Vec<_> = imported.map.regions().iter().map(rings).filter(|rings| !rings.is_empty()).collect();
        let scene = Scene::from_points2(&imported.points)
            .map_err(|error| CorpusError::file("map", error.to_string(), "divide the data"))?;
        if let Some((region, Flaw { why, cure, .. })) = first_flaw_if_all(&scene, &polygons) {
            return Err(CorpusError::file("map", format!("region {region}: {why}"), cure));
        }
        Ok(Parts { notes: imported.notes, ..Parts::new(scene, Polygons { polygons, method: self.method }) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.map.entry()
    }
}
