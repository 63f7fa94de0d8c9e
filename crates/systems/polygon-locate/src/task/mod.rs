//! The task `polygon-locate`: the region of a map in which each probe lies.
//!
//! Franklin and Magalhães, section 4.2. Each point of the plane should be in exactly one face of a tiling, also on
//! borders and corners.

mod checks;
pub(crate) mod content;
mod generate;
mod judge;
mod made;
mod probes;
mod read;
mod replies;
mod section;
mod spoiled;

use crate::algorithm::{Location, Locations, Scratch, locate_all, question_all};
use crate::truth::Truth;
use predicament_corpus::{Context, Family, InDecimals, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_mesh::PolygonMap;
use predicament_predicates::{Declined, PredicateKind, Predicates, Query, Scene, Vertex};
use predicament_records::{RunDir, TableSpec};
use predicament_report::Section;
use predicament_report::drawing::Role;

pub use content::{MapWithProbes, Probe, ProbeKind};
pub use section::LocateRow;

use predicament_tasks::output::{self, Canvas, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, ExplainError, Explanation, Halt, How, Knob, Outcome, Purpose,
    Spoiled, Stop, Task, Turns, Watch, digest,
};

/// A layer of probes in the drawing of an answer, by the number of regions that they are in or on.
type CountLayer = (&'static str, Role, fn(usize) -> bool);
const LAYERS: [CountLayer; 3] = [
    ("in no region", Role::Faint, |count| count == 0),
    ("in one region", Role::Found, |count| count == 1),
    ("in several, or on a boundary", Role::Mark, |count| count > 1),
];

/// The task `polygon-locate`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct PolygonLocate;

/// The locations of all probes.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Located(pub Locations);

impl Answer for Located {
    /// Digests for each probe the number of regions that contain it, the number of boundaries, then the regions.
    fn digest(&self) -> u64 {
        digest(self.0.iter().flat_map(|location| {
            // A map has far fewer than 2^32 regions, so both lengths fit.
            #[allow(clippy::cast_possible_truncation)]
            let lengths = [location.inside.len() as u32, location.boundary.len() as u32];
            let regions = location.inside.iter().chain(location.boundary).copied();
            lengths.into_iter().chain(regions).flat_map(u32::to_le_bytes)
        }))
    }
}

impl SceneFormat for PolygonLocate {
    fn name(&self) -> &'static str {
        "polygon-locate"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "the region of a map in which a point lies (Franklin and Magalhães, 4.2)"
    }

    fn in_decimals(&self) -> InDecimals {
        InDecimals::Integers
    }

    fn keys(&self) -> &'static [&'static str] {
        &["map", "points", "loops", "regions", "probes", "random", "random_full", "seed", "quick_stride", "full_stride"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["map", "polygons", "points", "probes"]
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["map", "probes"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        Ok(Source::elsewhere(read::ProbedMap::read(context, fields)?))
    }

    fn families(&self) -> &'static [Family] {
        &generate::FAMILIES
    }

    fn sample_keys(&self) -> &'static [&'static str] {
        &["random = 20", "random_full = 30"]
    }

    fn generator_keys(&self) -> &'static [&'static str] {
        &["random", "random_full", "quick_stride", "full_stride"]
    }
}

impl Task for PolygonLocate {
    type Content = MapWithProbes;
    type Truth = Truth;
    type Answer = Located;

    fn compared(&self) -> &'static [Compared] {
        const { &[Compared::general("tiling", 6), Compared::degenerate("bricks", 6)] }
    }

    fn replies(&self) -> Option<&'static dyn Replies<PolygonLocate>> {
        Some(&replies::Judge)
    }

    fn turns(&self, knob: Knob) -> Turns {
        match knob {
            Knob::Translation => Turns::UpTo(44, "vertices are rounded to one place"),
            Knob::Precision => Turns::UpTo(45, "vertices are rounded to one place"),
            Knob::Size => Turns::UpTo(4, "a map of n courses has n² regions"),
            _ => Turns::Everywhere,
        }
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d]
    }

    fn looks_at_watch(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, content: &MapWithProbes, watch: &Watch) -> Result<Truth, Stop> {
        Truth::new(scene, content, watch)
    }

    fn sampled(&self, truth: &Truth) -> Option<String> {
        truth.sampled()
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &MapWithProbes,
        how: &How<'_>,
        answer: &mut Located,
    ) -> Result<(), Halt> {
        let (session, index) = (&*session, content.locate_index(session.scene()));
        let probes = content.vertices();
        answer.0 = match how.purpose {
            Purpose::Judge => how.watch.counted(|go_on| question_all(index, session, &probes, go_on))?,
            Purpose::Use | Purpose::Files => how.watch.counted(|go_on| locate_all(index, session, &probes, go_on))?,
        };
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, PolygonLocate>,
        asked: &Asked<'_>,
        answer: &Located,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, &answer.0, outcome)
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<PolygonLocate>> {
        spoiled::all()
    }

    fn describe(&self, loaded: &LoadedScene, content: &MapWithProbes, watch: &Watch) -> Result<String, Stop> {
        let truth = Truth::new(&loaded.scene, content, watch)?;
        let flaws = &truth.flaws;
        let grounds = truth.grounds(content.probes.len());
        let grounds: Vec<String> = grounds.into_iter().map(|(name, count)| format!("{count} {name}")).collect();
        Ok(format!(
            "{} regions, {} edges (an edge that two regions share counts twice), {} probes\nthe map's own flaws: {} \
             duplicate points, {} T-junctions, {} crossings, {} overlapping edges\nprobes by their surroundings: {}\n",
            content.map.regions().len(),
            content.map.edges().count(),
            content.probes.len(),
            flaws.duplicates.len(),
            flaws.junctions.len(),
            flaws.crossings.len(),
            flaws.overlaps.len(),
            grounds.join(", ")
        ))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &MapWithProbes,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let probe = query.vertices().next().ok_or_else(|| ExplainError::not_of_task(query, "names no probe"))?;
        let index = content.locate_index(scene);
        let ask = |backend: &dyn Contestant| {
            let mut told = Err(Declined::scene("the backend asked for no session"));
            let prepared = backend.with_session(scene, &mut |session| {
                told = self.supported(session).map(|()| {
                    let asked = describe(&content.map, index.question(session, probe, &mut Scratch::new()));
                    let by_shortcut = describe(&content.map, index.locate(session, probe, &mut Scratch::new()));
                    if asked == by_shortcut { asked } else { format!("{asked} (by the shortcut: {by_shortcut})") }
                });
            });
            prepared.and(told)
        };
        let about = Explanation { vertices: vec![probe], ..Explanation::default() };
        Ok(about.with_answers(backends, ask))
    }

    /// Offers GeoJSON: each probe as a point with the regions that it is in and on, and its label.
    fn write(
        &self,
        scene: &Scene,
        content: &MapWithProbes,
        answer: &Located,
        files: &mut Files,
    ) -> Result<(), output::Error> {
        files.write("probes.geojson", |out| {
            let name = |&region: &u32| content.map.regions()[region as usize].name.as_str();
            let names = |regions: &[u32]| regions.iter().map(name).map(str::to_owned).collect::<Vec<String>>();
            let features = content.probes.iter().zip(answer.0.iter()).map(|(probe, location)| {
                Ok(serde_json::json!({
                    "type": "Feature",
                    "geometry": { "type": "Point", "coordinates": scene.point(probe.vertex) },
                    "properties": {
                        "vertex": probe.vertex.to_string(),
                        "inside": names(location.inside),
                        "on": names(location.boundary),
                        "label": replies::label(location).cast_signed(),
                    },
                }))
            });
            output::collection(out, features)
        })
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &MapWithProbes,
        answer: Option<&Located>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        let rings =
            |region: &predicament_mesh::Region| region.rings.iter().map(|ring| ring.vertices().to_vec()).collect();
        canvas.areas(scene, "regions", Role::Given, content.map.regions().iter().map(rings))?;
        let probes = || content.probes.iter().map(|probe| probe.vertex);
        let Some(answer) = answer else {
            canvas.points(scene, "probes", Role::Second, probes())?;
            return Ok(());
        };
        let located: Vec<(Vertex, usize)> =
            probes().zip(answer.0.iter()).map(|(v, at)| (v, at.inside.len() + at.boundary.len())).collect();
        for (name, role, is) in LAYERS {
            canvas.points(scene, name, role, located.iter().filter(|(_, count)| is(*count)).map(|(v, _)| *v))?;
        }
        Ok(())
    }

    fn tables(&self) -> Vec<TableSpec> {
        vec![TableSpec::of::<LocateRow>()]
    }

    fn section(&self, runs: &[RunDir]) -> Result<Option<Section>, predicament_records::Error> {
        section::section(runs)
    }
}

/// The location as text: `in France; on Spain, Andorra`.
#[must_use]
pub fn describe(map: &PolygonMap, location: Location<'_>) -> String {
    let names = |regions: &[u32]| {
        let names = regions.iter().map(|&region| map.regions()[region as usize].name.as_str());
        names.collect::<Vec<_>>().join(", ")
    };
    match (location.inside, location.boundary) {
        ([], []) => "in none".to_owned(),
        (inside, []) => format!("in {}", names(inside)),
        ([], boundary) => format!("on {}", names(boundary)),
        (inside, boundary) => format!("in {}; on {}", names(inside), names(boundary)),
    }
}
