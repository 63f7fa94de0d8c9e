//! `hull2d`: the convex hull of points of the plane.

use crate::algorithm::{PlaneMethod, hull2d};
use crate::checks::plane_flaws;
use predicament_corpus::{Context, Family, InDecimals, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{PredicateKind, Predicates, Query, Scene};
use predicament_report::drawing::Role;

use super::answer::{Hull2d, Polygon};
use super::cloud::{self, Cloud, Method};
use super::judge::{Found, judge};
use super::replies::JudgeInPlane;
use super::{generate, template};
use crate::truth::Truth;
use predicament_tasks::output::{Canvas, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::{
    Asked, Case, Check, Compared, Contestant, ExplainError, Explanation, Halt, How, Knob, Outcome, Spoiled, Stop, Task,
    Turns, Watch, output,
};

impl SceneFormat for Hull2d {
    fn name(&self) -> &'static str {
        PlaneMethod::TASK
    }

    fn template(&self) -> String {
        template("[[0, 0], [8, 0], [8, 8], [0, 8], [4, \"0x1.0p-60\"]]", "chain", "hull-grid")
    }

    fn about(&self) -> &'static str {
        "the vertices of the convex hull of points in the plane, counterclockwise"
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
        cloud::read::<PlaneMethod>(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &generate::PLANE
    }

    fn generator_keys(&self) -> &'static [&'static str] {
        &["method"]
    }

    fn naming_keys(&self) -> &'static [&'static str] {
        &["method"]
    }
}

impl Task for Hull2d {
    type Content = Cloud<PlaneMethod>;
    type Truth = Truth;
    type Answer = Polygon;

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("hull-square", 60),
                Compared::near("hull-sliver", 60),
                Compared::degenerate("hull-grid", 64),
            ]
        }
    }

    fn replies(&self) -> Option<&'static dyn Replies<Hull2d>> {
        Some(&JudgeInPlane)
    }

    fn turns(&self, _: Knob) -> Turns {
        Turns::Everywhere
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d]
    }

    fn judges_whole(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, _: &Cloud<PlaneMethod>, watch: &Watch) -> Result<Truth, Stop> {
        watch.done(0)?;
        Ok(Truth::new(scene))
    }

    fn sampled(&self, truth: &Truth) -> Option<String> {
        truth.sampled()
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Cloud<PlaneMethod>,
        how: &How<'_>,
        answer: &mut Polygon,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        answer.0 = hull2d(&*session, content.method);
        how.watch.done(content.points as u64)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Hull2d>,
        asked: &Asked<'_>,
        answer: &Polygon,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        let hull = &answer.0;
        let found =
            Found { vertices: &hull.vertices, broken: hull.broken, flaws: &|signs| plane_flaws(signs, &hull.vertices) };
        judge(PlaneMethod::TASK, case, asked, &found, outcome);
        Ok(())
    }

    fn checks(&self) -> &'static [Check] {
        super::checks::IN_PLANE
    }

    fn spoiled(&self) -> Vec<Spoiled<Hull2d>> {
        super::spoiled::in_plane()
    }

    fn describe(&self, loaded: &LoadedScene, content: &Cloud<PlaneMethod>, watch: &Watch) -> Result<String, Stop> {
        watch.done(0)?;
        let extreme = Truth::new(&loaded.scene).described();
        Ok(format!("{} points, by method {}; {extreme}\n", content.points, content.method.name()))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Cloud<PlaneMethod>,
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
        _: &Cloud<PlaneMethod>,
        answer: &Polygon,
        files: &mut Files,
    ) -> Result<(), output::Error> {
        let hull = &answer.0.vertices;
        files.broken(answer.0.broken);
        if hull.len() < 3 {
            let what = if hull.len() == 2 { "a line between two points" } else { "one point" };
            files.note(format!("the hull has no area: it is {what}"));
        }
        output::plane(files, scene, "hull", std::iter::once(vec![hull.clone()]))?;
        output::vertices(files, scene, hull.iter().copied())
    }

    fn draw(
        &self,
        scene: &Scene,
        _: &Cloud<PlaneMethod>,
        answer: Option<&Polygon>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        let hull = answer.map(|answer| answer.0.vertices.clone()).filter(|hull| hull.len() > 1);
        canvas.areas(scene, "hull", Role::Found, hull.map(|hull| vec![hull]))?;
        canvas.points(scene, "points", Role::Given, scene.vertices())?;
        Ok(())
    }
}
