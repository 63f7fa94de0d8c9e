//! `cover`: triangles that close the holes of a mesh, or loops of points in space.
//!
//! A planar loop can be triangulated in its plane. A loop that is not planar has many covers, and most programs take
//! one of least area without a look at crossings. Whether triangles of a cover cross each other or the mesh is a
//! question of signs.

mod checks;
pub mod content;
pub mod generate;
mod judge;
pub mod read;
mod spoiled;

use crate::algorithm::Surface;
use crate::answer::{Cover, Reason};
use crate::truth::Truth;
use predicament_corpus::{Context, Family, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{PredicateKind, Predicates, Query, Scene, Vertex};
use predicament_report::drawing::Role;

pub use content::HoleScene;

use predicament_tasks::output::{Canvas, Each, Files};
use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, Dispute, ExplainError, Explanation, Halt, How, Knob, Outcome,
    Spoiled, Stop, Task, Turns, Watch, digest, output,
};

/// The task `cover`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CoverTask;

/// The covers of the loops, in their order.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Covers(pub Vec<Cover>);

impl Answer for Covers {
    fn digest(&self) -> u64 {
        let number = |v: &Vertex| u32::try_from(v.index()).expect("ids have 32 bits");
        let one = |cover: &Cover| -> Vec<u32> {
            match cover {
                Cover::Triangles(all) => [u32::MAX].into_iter().chain(all.as_flattened().iter().map(number)).collect(),
                Cover::Uncovered(Reason::Repeats) => vec![u32::MAX - 1],
                Cover::Uncovered(Reason::Crosses) => vec![u32::MAX - 2],
                Cover::Uncovered(Reason::Search) => vec![u32::MAX - 3],
            }
        };
        digest(self.0.iter().flat_map(one).flat_map(u32::to_le_bytes))
    }
}

impl SceneFormat for CoverTask {
    fn name(&self) -> &'static str {
        "cover"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "triangles that close the holes of a mesh, or loops in space, with the least area and without a crossing"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["mesh", "points", "triangles", "loops"]
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
}

impl Task for CoverTask {
    type Content = HoleScene;
    type Truth = Truth;
    type Answer = Covers;

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("cover-wave", 24),
                Compared::near("cover-close", 8),
                Compared::degenerate("cover-lattice", 7),
            ]
        }
    }

    fn turns(&self, _: Knob) -> Turns {
        Turns::Everywhere
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d, PredicateKind::Orient3d]
    }

    fn truth(&self, scene: &Scene, content: &HoleScene, watch: &Watch) -> Result<Truth, Stop> {
        Truth::new(scene, content, watch)
    }

    fn dispute(&self, case: &Case<'_, CoverTask>) -> Option<Dispute> {
        let why = format!("triangle {} of the mesh has no area", case.truth.flat?);
        Some(Dispute::Invalid { why, cure: "remove it, and join its neighbours".to_owned() })
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &HoleScene,
        how: &How<'_>,
        answer: &mut Covers,
    ) -> Result<(), Halt> {
        let mut surface = Surface::new(session.scene(), &content.triangles);
        answer.0.clear();
        for around in &content.loops {
            how.watch.done(1)?;
            answer.0.push(surface.cover(session, around));
        }
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, CoverTask>,
        asked: &Asked<'_>,
        answer: &Covers,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, &answer.0, outcome)
    }

    fn size(&self, content: &HoleScene) -> usize {
        content.triangles.len() + content.loops.iter().map(Vec::len).sum::<usize>()
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<CoverTask>> {
        spoiled::all()
    }

    fn describe(&self, _: &LoadedScene, content: &HoleScene, _: &Watch) -> Result<String, Stop> {
        let counts: Vec<String> = content.loops.iter().map(|around| around.len().to_string()).collect();
        Ok(format!("{} triangles, loops of {} points\n", content.triangles.len(), counts.join(", ")))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &HoleScene,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let vertices: Vec<Vertex> = query.vertices().collect();
        let at = content.loops.iter().position(|around| *around == vertices);
        let at = at.ok_or_else(|| ExplainError::not_in_scene(query, "the scene has no such loop"))?;
        let ask = |backend: &dyn Contestant| backend.answer(self, scene, content).map(|all| all.0[at].to_string());
        Ok(Explanation { vertices, ..Explanation::default() }.with_answers(backends, ask))
    }

    /// Offers the mesh with its covers, and the triangles of each cover.
    fn write(
        &self,
        scene: &Scene,
        content: &HoleScene,
        answer: &Covers,
        files: &mut Files,
    ) -> Result<(), output::Error> {
        let covers = answer.0.iter().flat_map(|cover| match cover {
            Cover::Triangles(all) => &all[..],
            Cover::Uncovered(_) => &[],
        });
        let all: Vec<Vec<Vertex>> = content.triangles.iter().chain(covers).map(|corners| corners.to_vec()).collect();
        output::mesh(files, scene, "covered", all.into_iter())?;
        files.json("covers.json", || {
            let ids = |vertices: &[Vertex]| vertices.iter().map(|v| v.index()).collect::<Vec<_>>();
            let one = move |(around, cover): (&Vec<Vertex>, &Cover)| match cover {
                Cover::Triangles(all) => {
                    let triangles: Vec<_> = all.iter().map(|corners| ids(corners)).collect();
                    serde_json::json!({ "loop": ids(around), "triangles": triangles })
                }
                Cover::Uncovered(reason) => serde_json::json!({ "loop": ids(around), "uncovered": reason.name() }),
            };
            Each(move || content.loops.iter().zip(&answer.0).map(one))
        })
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &HoleScene,
        answer: Option<&Covers>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        canvas.faces(scene, "mesh", Role::Faint, &content.triangles)?;
        let closed: Vec<Vec<Vertex>> =
            content.loops.iter().map(|around| around.iter().chain(around.first()).copied().collect()).collect();
        canvas.lines(scene, "loops", Role::Second, &closed)?;
        let Some(answer) = answer else { return Ok(()) };
        let covers = answer.0.iter().flat_map(|cover| match cover {
            Cover::Triangles(all) => &all[..],
            Cover::Uncovered(_) => &[],
        });
        canvas.faces(scene, "covers", Role::Found, covers.copied().collect::<Vec<_>>())?;
        Ok(())
    }
}
