//! `interval`: the cell of a partition of a line in which each probe lies.
//!
//! Franklin and Magalhães, section 4.1. This is the smallest algorithm in which a tie matters: a probe at an end is in
//! both cells, in one or in neither.

mod checks;
pub(crate) mod content;
mod generate;
mod judge;
mod replies;
mod spoiled;

use crate::algorithm::cells_at;
use crate::answer::{Found, Place};
use crate::truth;
use predicament_corpus::{Context, Family, InDecimals, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{PredicateKind, Predicates, Query, Scene, Vertex};
use predicament_report::drawing::Role;
use rayon::prelude::*;

pub use content::Cells;

use predicament_tasks::output::{self, Canvas, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, ExplainError, Explanation, Halt, How, Knob, Outcome, Spoiled,
    Stop, Task, Turns, Watch, digest,
};

/// The number of probes between two checks of the watch.
const CHUNK: usize = 1024;

/// A function that writes the cells of some probes to a slice.
type FindAll<'a> = dyn Fn((&mut [Found], &[Vertex])) -> Result<(), Stop> + Sync + 'a;

/// The task `interval`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Interval;

/// The cells of all probes, in order.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct CellsFound(pub Vec<Found>);

impl Answer for CellsFound {
    fn digest(&self) -> u64 {
        let end = (usize::MAX, Place::Outside);
        let places = self.0.iter().flat_map(|cells| cells.iter().copied().chain([end]));
        digest(places.flat_map(|(cell, place)| {
            let [a, b, c, d, e, f, g, h] = (cell as u64).to_le_bytes();
            [a, b, c, d, e, f, g, h, u8::from(place == Place::AtEnd)]
        }))
    }
}

impl SceneFormat for Interval {
    fn name(&self) -> &'static str {
        "interval"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "the cell of a partition of a line in which a point lies (Franklin and Magalhães, 4.1)"
    }

    fn in_decimals(&self) -> InDecimals {
        InDecimals::Integers
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "axis", "cells"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        content::read(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &generate::FAMILIES
    }

    fn sample_keys(&self) -> &'static [&'static str] {
        &["dimension = 3"]
    }

    fn generator_keys(&self) -> &'static [&'static str] {
        &["dimension", "axis"]
    }

    fn naming_keys(&self) -> &'static [&'static str] {
        &["dimension", "axis"]
    }
}

impl Task for Interval {
    type Content = Cells;
    type Truth = Vec<Found>;
    type Answer = CellsFound;

    fn compared(&self) -> &'static [Compared] {
        const { &[Compared::general("cells-uniform", 60), Compared::degenerate("cells-degen", 60)] }
    }

    fn turns(&self, knob: Knob) -> Turns {
        match knob {
            Knob::Shift | Knob::Scale | Knob::Aspect | Knob::Size => Turns::Everywhere,
            Knob::Translation => Turns::UpTo(32, "different ends are rounded to one place"),
            Knob::Precision => Turns::UpTo(29, "different ends are rounded to one place"),
            Knob::Noise | Knob::Pythagorean | Knob::Turn => {
                Turns::Nowhere("the ends of cells must keep their order along the axis")
            }
        }
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare]
    }

    fn looks_at_watch(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, content: &Cells, watch: &Watch) -> Result<Vec<Found>, Stop> {
        truth::truth(scene, content, watch)
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Cells,
        how: &How<'_>,
        answer: &mut CellsFound,
    ) -> Result<(), Halt> {
        let session = &*session;
        answer.0.resize(content.probes.len(), Vec::new());
        // Behind a pointer, so that the parallel loop is compiled once and not for each backend.
        let chunk: &FindAll<'_> = &|(found, probes)| {
            for (found, &probe) in found.iter_mut().zip(probes) {
                found.clear();
                found.extend(cells_at(session, content.axis, &content.cells, probe));
            }
            how.watch.done(probes.len() as u64)
        };
        answer.0.par_chunks_mut(CHUNK).zip(content.probes.par_chunks(CHUNK)).try_for_each(chunk)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Interval>,
        asked: &Asked<'_>,
        answer: &CellsFound,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, &answer.0, outcome)
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<Interval>> {
        spoiled::all()
    }

    fn replies(&self) -> Option<&'static dyn Replies<Interval>> {
        Some(&replies::Judge)
    }

    fn describe(&self, _: &LoadedScene, content: &Cells, _: &Watch) -> Result<String, Stop> {
        Ok(format!("{} cells, {} probes\n", content.cells.len(), content.probes.len()))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Cells,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let probe = query.vertices().next().ok_or_else(|| ExplainError::not_of_task(query, "names no probe"))?;
        let ask = |backend: &dyn Contestant| {
            let one = Cells { probes: vec![probe], ..content.clone() };
            backend.answer(self, scene, &one).map(|found| describe(&found.0[0]))
        };
        let about = Explanation { vertices: vec![probe], ..Explanation::default() };
        Ok(about.with_answers(backends, ask))
    }

    fn write(&self, _: &Scene, content: &Cells, answer: &CellsFound, files: &mut Files) -> Result<(), output::Error> {
        files.write("cells.csv", |out| {
            writeln!(out, "probe,cells,label")?;
            let mut lines = content.probes.iter().zip(&answer.0);
            lines.try_for_each(|(probe, cells)| {
                let (words, label) = (describe(cells), replies::label(cells).cast_signed());
                writeln!(out, "{probe},\"{words}\",{label}")
            })
        })
    }

    fn draw(&self, scene: &Scene, content: &Cells, _: Option<&CellsFound>, canvas: &mut Canvas) -> std::io::Result<()> {
        canvas.lines(scene, "cells", Role::Given, &content.cells)?;
        canvas.points(scene, "probes", Role::Mark, content.probes.iter().copied())?;
        Ok(())
    }
}

/// Cells in words: `in 3`, `at the end of 3, 4`.
#[must_use]
pub fn describe(cells: &Found) -> String {
    let of = |wanted: Place| {
        let cells = cells.iter().filter(|&&(_, place)| place == wanted);
        cells.map(|(cell, _)| cell.to_string()).collect::<Vec<_>>().join(", ")
    };
    match (of(Place::Inside), of(Place::AtEnd)) {
        (inside, ends) if inside.is_empty() && ends.is_empty() => "in none".to_owned(),
        (inside, ends) if ends.is_empty() => format!("in {inside}"),
        (inside, ends) if inside.is_empty() => format!("at the end of {ends}"),
        (inside, ends) => format!("in {inside}; at the end of {ends}"),
    }
}
