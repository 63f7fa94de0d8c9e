//! `crossings`: all crossings of a set of segments, sorted along each.
//!
//! This is the smallest algorithm that constructs vertices at run time; overlays, slices and unions do so many times
//! over. Exact arithmetic and Simulation of Simplicity keep the crossing points exact; the controls round them and sort
//! rounded points.

mod checks;
pub mod content;
mod judge;
pub mod memory;
mod replies;
mod spoiled;

use std::collections::BTreeMap;

use crate::algorithm::{Along, crossings};
use crate::truth;
use predicament_corpus::{Context, Family, InDecimals, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_judge::{nearest, point};
use predicament_predicates::{Construction, PredicateKind, Predicates, Query, Scene, Vertex};
use predicament_report::drawing::Role;

pub use content::Segments;

use predicament_tasks::output::{Canvas, Each, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::segment_source::named;
use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, ExplainError, Explanation, Halt, How, Knob, Outcome, Spoiled,
    Stop, Task, Turns, Watch, digest, output,
};

/// The task `crossings`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Crossings;

/// The crossings along each segment, in the order of the segments.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Crossed(pub Vec<Along>);

impl Answer for Crossed {
    fn digest(&self) -> u64 {
        let groups = self.0.iter().flat_map(|along| along.iter().map(Vec::as_slice).chain([&[u32::MAX][..]]));
        digest(groups.flat_map(|group| group.iter().chain([&(u32::MAX - 1)])).flat_map(|other| other.to_le_bytes()))
    }
}

impl SceneFormat for Crossings {
    fn name(&self) -> &'static str {
        "crossings"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "all crossings of a set of segments, sorted along each"
    }

    fn in_decimals(&self) -> InDecimals {
        InDecimals::Integers
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "segments"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["segments"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        content::read(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &content::FAMILIES
    }
}

impl Task for Crossings {
    type Content = Segments;
    type Truth = Vec<Along>;
    type Answer = Crossed;

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("segments-uniform", 60),
                Compared::near("segments-near", 30),
                Compared::degenerate("segments-lattice", 30),
            ]
        }
    }

    fn turns(&self, _: Knob) -> Turns {
        Turns::Everywhere
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d]
    }

    fn memory(&self, scene: &Scene, content: &Segments) -> Option<u64> {
        Some(memory::estimate(scene, &content.0, memory::Bytes { segment: 1_200, crossing: 1_000 }))
    }

    fn scaled(&self) -> Option<Compared> {
        Some(Compared::general("segments-short", 1))
    }

    fn constructs(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, content: &Segments, watch: &Watch) -> Result<Vec<Along>, Stop> {
        truth::crossings(scene, &content.0, watch)
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Segments,
        how: &How<'_>,
        answer: &mut Crossed,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        answer.0 = crossings(session, &content.0)?;
        how.watch.done(content.0.len() as u64)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Crossings>,
        asked: &Asked<'_>,
        answer: &Crossed,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, &answer.0, outcome)
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<Crossings>> {
        spoiled::all()
    }

    fn replies(&self) -> Option<&'static dyn Replies<Crossings>> {
        Some(&replies::Judge)
    }

    fn describe(&self, loaded: &LoadedScene, content: &Segments, watch: &Watch) -> Result<String, Stop> {
        let truth = truth::crossings(&loaded.scene, &content.0, watch)?;
        let crossings: usize = truth.iter().flatten().map(Vec::len).sum();
        Ok(format!("{} segments, {} crossings\n", content.0.len(), crossings / 2))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Segments,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let (at, about) = named(&content.0, query)?;
        let ask = |backend: &dyn Contestant| backend.answer(self, scene, content).map(|found| describe(&found.0[at]));
        Ok(about.with_answers(backends, ask))
    }

    fn write(
        &self,
        scene: &Scene,
        content: &Segments,
        answer: &Crossed,
        files: &mut Files,
    ) -> Result<(), output::Error> {
        // Each crossing of two segments, as the algorithm defines it, by segment and group.
        let mut exact = scene.clone();
        let mut crossings: Vec<Vec<Vec<Vertex>>> = Vec::with_capacity(content.0.len());
        for (ends, along) in content.0.iter().zip(&answer.0) {
            let mut crossing = |j: &u32| exact.construct(Construction::Ssi([*ends, content.0[*j as usize]]));
            let mut group = |group: &Vec<u32>| group.iter().map(&mut crossing).collect::<Result<Vec<_>, _>>();
            crossings.push(along.iter().map(&mut group).collect::<Result<_, _>>().map_err(std::io::Error::other)?);
        }
        let listed = &crossings;
        files.json("crossings.json", || {
            let segment = |((ends, along), crossings): ((&[Vertex; 2], &Along), &Vec<Vec<Vertex>>)| {
                let ids = |group: &Vec<Vertex>| group.iter().map(ToString::to_string).collect::<Vec<_>>();
                serde_json::json!({
                    "ends": ends.map(|v| scene.point(v).to_vec()),
                    "crossed_by": along,
                    "crossed_at": crossings.iter().map(ids).collect::<Vec<_>>(),
                })
            };
            Each(move || content.0.iter().zip(&answer.0).zip(listed).map(segment))
        })?;
        // Each crossing once, with its segments. Segments that cross only by wrong signs may be parallel: their lines
        // do not meet in a point.
        let mut pairs: BTreeMap<Vertex, [usize; 2]> = BTreeMap::new();
        for (i, (along, crossings)) in answer.0.iter().zip(&crossings).enumerate() {
            for (&j, &v) in along.iter().flatten().zip(crossings.iter().flatten()) {
                pairs.entry(v).or_insert([i, j as usize]);
            }
        }
        files.by_format("crossings.geojson", |out| {
            let feature = |(v, segments): (&Vertex, &[usize; 2])| {
                let at: Vec<f64> = point(&exact, *v)?.iter().map(nearest).collect();
                Some(Ok(serde_json::json!({
                    "type": "Feature",
                    "geometry": { "type": "Point", "coordinates": at },
                    "properties": { "vertex": v.to_string(), "segments": segments },
                })))
            };
            output::collection(out, pairs.iter().filter_map(feature))
        })?;
        let points = pairs.keys().copied().filter(|&v| point(&exact, v).is_some());
        output::vertices(files, &exact, content.0.as_flattened().iter().copied().chain(points))
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &Segments,
        answer: Option<&Crossed>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        canvas.lines(scene, "segments", Role::Given, &content.0)?;
        let Some(answer) = answer else { return Ok(()) };
        let mut scene = scene.clone();
        let mut crossings = Vec::new();
        for (at, along) in answer.0.iter().enumerate() {
            // Each pair is in the lists of both segments.
            for &other in along.iter().flatten().filter(|&&other| other as usize > at) {
                let lines = [content.0[at], content.0[other as usize]];
                let v = scene.construct(Construction::Ssi(lines)).map_err(std::io::Error::other)?;
                // Segments that cross only by wrong signs may be parallel: their lines do not meet in a point.
                crossings.extend(predicament_judge::point(&scene, v).is_some().then_some(v));
            }
        }
        canvas.points(&scene, "crossings", Role::Found, crossings)?;
        Ok(())
    }
}

/// The crossings along a segment in words: `3, 5 and 7, 2`.
#[must_use]
pub fn describe(along: &Along) -> String {
    if along.is_empty() {
        return "none".to_owned();
    }
    let group = |group: &Vec<u32>| group.iter().map(u32::to_string).collect::<Vec<_>>().join(" and ");
    along.iter().map(group).collect::<Vec<_>>().join(", ")
}
