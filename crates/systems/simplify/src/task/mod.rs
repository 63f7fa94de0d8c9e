//! `simplify`: a mesh with at most so many triangles, whose faces have not turned over.
//!
//! Level of detail, remeshing and transmission start with this question. Doubles fail at slivers and in flat regions:
//! the rounded normal of a face without area points anywhere, and the face turns over.

mod checks;
mod content;
mod generate;
mod judge;
mod read;
mod section;
mod spoiled;

use crate::algorithm::simplify;
use crate::answer::{Simplified, Step, same_facing};
use crate::checks::facing;
use crate::truth::{Component, Flaw, components};
use predicament_corpus::{Context, Family, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{PredicateKind, Predicates, Query, Scene, Vertex};
use predicament_records::{RunDir, TableSpec};
use predicament_report::Section;
use predicament_report::drawing::Role;

pub use content::MeshToSimplify;
pub use section::SimplifyRow;

use predicament_tasks::output::{Canvas, Files};
use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, Dispute, ExplainError, Explanation, Halt, How, Knob, Outcome,
    Spoiled, Stop, Task, Turns, Watch, digest, output,
};

/// The task `simplify`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Simplify;

impl Answer for Simplified {
    fn digest(&self) -> u64 {
        let id = |v: Vertex| u32::try_from(v.index()).expect("ids have 32 bits");
        let steps = self.steps.iter().flat_map(|step| match *step {
            Step::Collapse { gone, kept } => [u32::MAX, id(gone), id(kept), 0, 0],
            Step::Refusal { gone, kept, base: [b, c], sign } => {
                [u32::from(sign.as_i8().unsigned_abs()), id(gone), id(kept), id(b), id(c)]
            }
        });
        let corners = self.triangles.as_flattened().iter().map(|&v| id(v));
        digest(steps.chain(corners).flat_map(u32::to_le_bytes).chain(self.reach.to_le_bytes()))
    }
}

impl SceneFormat for Simplify {
    fn name(&self) -> &'static str {
        "simplify"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "a mesh with fewer triangles, by edge collapse, whose faces do not turn over"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["mesh", "points", "triangles", "target"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["mesh"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        read::read(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &generate::FAMILIES
    }

    fn generator_keys(&self) -> &'static [&'static str] {
        &["target", "scale", "flat", "far"]
    }
}

impl Task for Simplify {
    type Content = MeshToSimplify;
    type Truth = Result<Vec<Component>, Flaw>;
    type Answer = Simplified;

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("simplify-torus", 96),
                Compared::near("simplify-facets", 96),
                Compared::degenerate("simplify-lattice", 96),
            ]
        }
    }

    fn turns(&self, _: Knob) -> Turns {
        Turns::Everywhere
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Orient2d, PredicateKind::Derived(same_facing())]
    }

    fn judges_whole(&self) -> bool {
        true
    }

    fn looks_at_watch(&self) -> bool {
        true
    }

    fn truth(&self, _: &Scene, content: &MeshToSimplify, watch: &Watch) -> Result<Self::Truth, Stop> {
        watch.done(0)?;
        Ok(components(&content.triangles))
    }

    fn dispute(&self, case: &Case<'_, Simplify>) -> Option<Dispute> {
        let flaw = case.truth.as_ref().err()?;
        Some(Dispute::Invalid { why: flaw.to_string(), cure: "make the triangles an oriented surface".to_owned() })
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &MeshToSimplify,
        how: &How<'_>,
        answer: &mut Simplified,
    ) -> Result<(), Halt> {
        let mesh = content.mesh(session.scene());
        *answer = simplify(session, mesh, content.target, &mut |done| how.watch.done(done))?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Simplify>,
        asked: &Asked<'_>,
        answer: &Simplified,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, answer, outcome)
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<Simplify>> {
        spoiled::all()
    }

    fn tables(&self) -> Vec<TableSpec> {
        vec![TableSpec::of::<SimplifyRow>()]
    }

    fn section(&self, runs: &[RunDir]) -> Result<Option<Section>, predicament_records::Error> {
        section::section(runs)
    }

    fn describe(&self, _: &LoadedScene, content: &MeshToSimplify, _: &Watch) -> Result<String, Stop> {
        let told = match components(&content.triangles) {
            Ok(all) => {
                let genus: i64 = all.iter().map(|component| component.genus()).sum();
                let loops: usize = all.iter().map(|component| component.loops).sum();
                format!("{} components, genus {genus}, {loops} boundary loops", all.len())
            }
            Err(flaw) => flaw.to_string(),
        };
        Ok(format!("{} triangles to {}: {told}\n", content.triangles.len(), content.target))
    }

    /// Explains the face of a finding, named by the vertex that moves, the vertex that it moves into, and two corners.
    fn explain(
        &self,
        scene: &Scene,
        content: &MeshToSimplify,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let vertices: Vec<Vertex> = query.vertices().collect();
        if vertices.iter().any(|v| v.index() >= scene.len()) {
            return Err(ExplainError::not_in_scene(query, "the scene has no such vertex"));
        }
        let truth = match vertices[..] {
            [u, v, b, c] => {
                vec![format!("face {u} {b} {c}, with {u} moved into {v}: {}", facing(scene, [u, v, b, c]).name())]
            }
            _ => Vec::new(),
        };
        let about = Explanation { vertices, truth, ..Explanation::default() };
        let ask = |backend: &dyn Contestant| backend.answer(self, scene, content).map(|answer| told(&answer));
        Ok(about.with_answers(backends, ask))
    }

    /// Offers the mesh, and the steps as a JSON file.
    fn write(
        &self,
        scene: &Scene,
        _: &MeshToSimplify,
        answer: &Simplified,
        files: &mut Files,
    ) -> Result<(), output::Error> {
        output::mesh(files, scene, "simplified", answer.triangles.iter().map(|triangle| triangle.to_vec()))?;
        files.json("steps.json", || {
            let step = |step: &Step| match *step {
                Step::Collapse { gone, kept } => serde_json::json!({ "collapse": [gone.index(), kept.index()] }),
                Step::Refusal { gone, kept, base, sign } => serde_json::json!({
                    "refuse": [gone.index(), kept.index()],
                    "face": base.map(Vertex::index),
                    "sign": sign.as_i8(),
                }),
            };
            serde_json::json!({
                "steps": answer.steps.iter().map(step).collect::<Vec<_>>(),
                "triangles": answer.triangles.len(),
                "reach": answer.reach,
            })
        })
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &MeshToSimplify,
        answer: Option<&Simplified>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        let Some(answer) = answer else {
            canvas.faces(scene, "mesh", Role::Given, &content.triangles)?;
            return Ok(());
        };
        canvas.faces(scene, "simplified", Role::Found, &answer.triangles)?;
        canvas.faces(scene, "mesh", Role::Faint, &content.triangles)?.hide();
        Ok(())
    }
}

/// An answer in words.
fn told(answer: &Simplified) -> String {
    let refused = answer.steps.iter().filter(|step| matches!(step, Step::Refusal { .. })).count();
    let collapsed = answer.steps.len() - refused;
    let left = answer.triangles.len();
    format!("{left} triangles after {collapsed} collapses, {refused} refused; moved by at most {:e}", answer.reach)
}
