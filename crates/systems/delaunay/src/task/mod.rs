//! `delaunay2d`: the Delaunay triangulation of points of the plane.
//!
//! No other task asks more incircle queries: a wrong answer near zero keeps a wrong edge, or opens a hole. Its answer
//! is unique, so digests of different backends can be compared. With constraints, edges are given, and where they
//! cross, vertices are constructed at run time.

mod checks;
mod content;
mod generate;
mod judge;
mod replies;
mod spoiled;

use crate::algorithm::{Contradiction, Delaunay2, constrained_delaunay2d, delaunay2d};
use crate::truth::Truth;
use predicament_corpus::{Context, Family, InDecimals, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{Construction, PredicateKind, Predicates, Query, Refused, Scene, Vertex};
use predicament_report::drawing::Role;

pub use content::Sites;

use predicament_tasks::output::{Canvas, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, ExplainError, Explanation, Halt, How, Knob, Outcome, Spoiled,
    Stop, Task, Turns, Watch, digest, output,
};

/// The task `delaunay2d`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Delaunay2d;

/// The answer: a triangulation.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Triangles(pub Delaunay2);

impl Answer for Triangles {
    fn digest(&self) -> u64 {
        let Delaunay2 { triangles, chain, copies, constrained, crossings, broken } = &self.0;
        let definitions: Vec<Vertex> = crossings.iter().flat_map(Construction::flats).flatten().copied().collect();
        let constrained = constrained.as_flattened();
        let lists = [triangles.as_flattened(), chain, copies.as_flattened(), constrained, &definitions];
        // Without constraints, the output does not mention them.
        let count = if constrained.is_empty() { 3 } else { lists.len() };
        let ids = lists
            .into_iter()
            .take(count)
            .flat_map(|list| [list.len()].into_iter().chain(list.iter().map(|v| v.index())));
        digest(ids.flat_map(usize::to_le_bytes).chain(broken.map_or("", Contradiction::rule).bytes()))
    }
}

impl SceneFormat for Delaunay2d {
    fn name(&self) -> &'static str {
        "delaunay2d"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "the Delaunay triangulation of points in the plane; a rule cuts cocircular faces"
    }

    fn in_decimals(&self) -> InDecimals {
        InDecimals::Integers
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "constraints"]
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
}

/// The bytes of memory for each point.
const POINT: u64 = 256;

impl Task for Delaunay2d {
    type Content = Sites;
    type Truth = Truth;
    type Answer = Triangles;

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("delaunay-uniform", 60),
                Compared::near("delaunay-near-ring", 60),
                Compared::degenerate("delaunay-grid", 64),
            ]
        }
    }

    fn replies(&self) -> Option<&'static dyn Replies<Delaunay2d>> {
        Some(&replies::Judge)
    }

    fn turns(&self, _: Knob) -> Turns {
        Turns::Everywhere
    }

    fn takes_threads(&self) -> bool {
        true
    }

    fn memory(&self, scene: &Scene, _: &Sites) -> Option<u64> {
        Some(scene.len() as u64 * POINT)
    }

    fn scaled(&self) -> Option<Compared> {
        Some(Compared::general("delaunay-uniform", 1))
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d, PredicateKind::Incircle]
    }

    fn constructs(&self) -> bool {
        true
    }

    fn judges_whole(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, _: &Sites, watch: &Watch) -> Result<Truth, Stop> {
        watch.done(0)?;
        Ok(Truth::new(scene))
    }

    fn sampled(&self, truth: &Truth) -> Option<String> {
        truth.sampled()
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Sites,
        how: &How<'_>,
        answer: &mut Triangles,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        // Compiling it for each session is expensive, and not faster: the algorithm is bound by memory.
        answer.0 = solve(session, content)?;
        how.watch.done(content.points as u64)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Delaunay2d>,
        asked: &Asked<'_>,
        answer: &Triangles,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        asked.watch.done(0)?;
        judge::judge(case, asked, &answer.0, outcome);
        Ok(())
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<Delaunay2d>> {
        spoiled::all()
    }

    fn describe(&self, _: &LoadedScene, content: &Sites, watch: &Watch) -> Result<String, Stop> {
        watch.done(0)?;
        Ok(match content.constraints.len() {
            0 => format!("{} points\n", content.points),
            constraints => format!("{} points, {constraints} constraints\n", content.points),
        })
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Sites,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let vertices: Vec<Vertex> = query.vertices().collect();
        let ask =
            |backend: &dyn Contestant| backend.answer(self, scene, content).map(|found| describe(&found.0, &vertices));
        Ok(Explanation { vertices: vertices.clone(), ..Explanation::default() }.with_answers(backends, ask))
    }

    /// Offers SVG, GeoJSON and CSV of the triangles; chain, copies and edges of constraints as JSON; all vertices
    /// exactly.
    fn write(&self, scene: &Scene, _: &Sites, answer: &Triangles, files: &mut Files) -> Result<(), output::Error> {
        let found = &answer.0;
        files.broken(found.broken);
        let mut exact = scene.clone();
        for definition in &found.crossings {
            exact.construct(*definition).map_err(std::io::Error::other)?;
        }
        output::plane(files, &exact, "triangles", found.triangles.iter().map(|triangle| vec![triangle.to_vec()]))?;
        output::table(files, "triangles", &found.triangles)?;
        files.json("edges.json", || {
            let ids = |list: &[Vertex]| list.iter().map(ToString::to_string).collect::<Vec<_>>();
            let pairs = |pairs: &[[Vertex; 2]]| pairs.iter().map(|pair| ids(pair)).collect::<Vec<_>>();
            serde_json::json!({
                "chain": ids(&found.chain),
                "copies": pairs(&found.copies),
                "constrained": pairs(&found.constrained),
                "broken": found.broken.map(Contradiction::rule),
            })
        })?;
        let inputs = (0..scene.len()).map(Vertex::input);
        let crossings = (0..found.crossings.len()).map(Vertex::constructed);
        output::vertices(files, &exact, inputs.chain(crossings))
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &Sites,
        answer: Option<&Triangles>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        let mut exact = scene.clone();
        if let Some(Triangles(found)) = answer {
            for definition in &found.crossings {
                exact.construct(*definition).map_err(std::io::Error::other)?;
            }
            canvas.faces(&exact, "triangles", Role::Found, &found.triangles)?;
            canvas.lines(&exact, "constrained edges", Role::Second, &found.constrained)?;
        } else {
            canvas.lines(scene, "constraints", Role::Second, &content.constraints)?;
        }
        canvas.points(scene, "points", Role::Given, scene.vertices())?;
        Ok(())
    }
}

/// Computes the triangulation.
fn solve(session: &mut dyn Predicates, content: &Sites) -> Result<Delaunay2, Refused> {
    let found = match &content.constraints[..] {
        [] => delaunay2d(session),
        constraints => constrained_delaunay2d(session, constraints)?,
    };
    Ok(found.answer())
}

/// The triangles with any of these vertices, in words.
fn describe(found: &Delaunay2, vertices: &[Vertex]) -> String {
    let is_about = |triangle: &&[Vertex; 3]| {
        let common = triangle.iter().filter(|v| vertices.contains(v)).count();
        common >= vertices.len().clamp(1, 3)
    };
    let about: Vec<String> =
        found.triangles.iter().filter(is_about).take(6).map(|triangle| predicament_tasks::ids(triangle)).collect();
    if about.is_empty() { found.to_string() } else { format!("{found}; {}", about.join(", ")) }
}
