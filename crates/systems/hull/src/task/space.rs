//! `hull3d`: the convex hull of points of space.

use crate::algorithm::{Hull3, SpaceMethod, hull3d};
use crate::checks::space_flaws;
use predicament_corpus::{Context, Family, InDecimals, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{PredicateKind, Predicates, Query, Scene, Vertex};
use predicament_report::drawing::Role;

use super::answer::{Hull3d, Surface};
use super::cloud::{self, Cloud, Method};
use super::judge::{Found, judge};
use super::replies::JudgeInSpace;
use super::{generate, template};
use crate::truth::Truth;
use predicament_tasks::output::{Canvas, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::{
    Asked, Case, Check, Compared, Contestant, ExplainError, Explanation, Halt, How, Knob, Outcome, Spoiled, Stop, Task,
    Turns, Watch, output,
};

impl SceneFormat for Hull3d {
    fn name(&self) -> &'static str {
        SpaceMethod::TASK
    }

    fn template(&self) -> String {
        template("[[0, 0, 0], [8, 0, 0], [0, 8, 0], [0, 0, 8], [2, 2, \"0x1.0p-60\"]]", "incremental", "hull-lattice")
    }

    fn about(&self) -> &'static str {
        "the faces of the convex hull of points in space, counterclockwise as seen from outside"
    }

    fn in_decimals(&self) -> InDecimals {
        InDecimals::Integers
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "method"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        cloud::read::<SpaceMethod>(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &generate::SPACE
    }

    fn generator_keys(&self) -> &'static [&'static str] {
        &["method"]
    }

    fn naming_keys(&self) -> &'static [&'static str] {
        &["method"]
    }
}

/// The bytes of memory for each point.
const POINT: u64 = 512;

impl Task for Hull3d {
    type Content = Cloud<SpaceMethod>;
    type Truth = Truth;
    type Answer = Surface;

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("hull-ball", 60),
                Compared::near("hull-slab", 60),
                Compared::degenerate("hull-lattice", 64),
            ]
        }
    }

    fn replies(&self) -> Option<&'static dyn Replies<Hull3d>> {
        Some(&JudgeInSpace)
    }

    fn turns(&self, _: Knob) -> Turns {
        Turns::Everywhere
    }

    fn takes_threads(&self) -> bool {
        true
    }

    fn memory(&self, scene: &Scene, _: &Cloud<SpaceMethod>) -> Option<u64> {
        Some(scene.len() as u64 * POINT)
    }

    fn scaled(&self) -> Option<Compared> {
        Some(Compared::general("hull-ball", 1))
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d, PredicateKind::Orient3d]
    }

    fn judges_whole(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, _: &Cloud<SpaceMethod>, watch: &Watch) -> Result<Truth, Stop> {
        watch.done(0)?;
        Ok(Truth::new(scene))
    }

    fn sampled(&self, truth: &Truth) -> Option<String> {
        truth.sampled()
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Cloud<SpaceMethod>,
        how: &How<'_>,
        answer: &mut Surface,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        answer.0 = hull3d(&*session, content.method);
        how.watch.done(content.points as u64)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Hull3d>,
        asked: &Asked<'_>,
        answer: &Surface,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        let hull = &answer.0;
        let found = Found {
            vertices: &hull.vertices,
            broken: hull.broken,
            flaws: &|signs| space_flaws(signs, &hull.vertices, &hull.faces),
        };
        judge(SpaceMethod::TASK, case, asked, &found, outcome);
        Ok(())
    }

    fn checks(&self) -> &'static [Check] {
        super::checks::IN_SPACE
    }

    fn spoiled(&self) -> Vec<Spoiled<Hull3d>> {
        super::spoiled::in_space()
    }

    fn describe(&self, loaded: &LoadedScene, content: &Cloud<SpaceMethod>, watch: &Watch) -> Result<String, Stop> {
        watch.done(0)?;
        let extreme = Truth::new(&loaded.scene).described();
        Ok(format!("{} points, by method {}; {extreme}\n", content.points, content.method.name()))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Cloud<SpaceMethod>,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let ask = |backend: &dyn Contestant| backend.answer(self, scene, content).map(|hull| hull.0.to_string());
        let explanation = Explanation { vertices: query.vertices().collect(), ..Explanation::default() };
        Ok(explanation.with_answers(backends, ask))
    }

    fn write(
        &self,
        scene: &Scene,
        _: &Cloud<SpaceMethod>,
        answer: &Surface,
        files: &mut Files,
    ) -> Result<(), output::Error> {
        let Hull3 { vertices, faces, broken } = &answer.0;
        files.broken(*broken);
        files.json("hull.json", || {
            let ids = |vertices: &Vec<Vertex>| vertices.iter().map(ToString::to_string).collect::<Vec<_>>();
            let faces: Vec<Vec<String>> = faces.iter().map(ids).collect();
            let edges = if vertices.len() == 2 { vec![ids(vertices)] } else { Vec::new() };
            serde_json::json!({ "vertices": ids(vertices), "edges": edges, "faces": faces })
        })?;
        if faces.is_empty() {
            let what = if vertices.len() == 2 { "a line between two points" } else { "one point" };
            files.note(format!(
                "the hull has no faces: it is {what}; hull.json and vertices.json have it, and there is no mesh"
            ));
            return output::all_vertices(files, scene, vertices.iter().copied());
        }
        if faces.len() == 2 {
            files.note("the hull has no volume: it is a polygon, written as two faces back to back");
        }
        output::mesh(files, scene, "hull", faces.iter().cloned())?;
        output::vertices(files, scene, vertices.iter().copied())
    }

    fn draw(
        &self,
        scene: &Scene,
        _: &Cloud<SpaceMethod>,
        answer: Option<&Surface>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        let faces = answer.into_iter().flat_map(|answer| &answer.0.faces);
        canvas.faces(scene, "hull", Role::Found, faces)?;
        canvas.points(scene, "points", Role::Given, scene.vertices())?;
        Ok(())
    }
}
