//! `mesh-rays`: the vertices, edges and faces of a mesh that a line, a ray or a segment hits, in order.
//!
//! Picking, visibility, collision and parity tests all ask this question. Rays through vertices and along edges are
//! where they fail: a ray that misses both faces of an edge leaves a closed solid without a hit.

mod bands;
mod checks;
pub mod content;
pub mod generate;
mod judge;
mod made;
mod read;
mod replies;
mod spoiled;

use crate::algorithm::hits;
use crate::answer::{Feature, Hits, describe};
use crate::truth::Truth;
use predicament_corpus::{Context, Family, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{PredicateKind, Predicates, Query, Scene, Vertex};
use predicament_report::drawing::Role;

pub use content::RayScene;

use predicament_tasks::output::{Canvas, Each, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::segment_source::named;
use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, Dispute, ExplainError, Explanation, Halt, How, Knob, Outcome,
    Spoiled, Stop, Task, Turns, Watch, digest, output,
};

/// The task `mesh-rays`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MeshRays;

/// The hits of each query, in the order of the queries.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct RayHits(pub Vec<Hits>);

impl Answer for RayHits {
    fn digest(&self) -> u64 {
        let number = |v: Vertex| u32::try_from(v.index()).expect("ids have 32 bits");
        let one = |hits: &Hits| {
            let mut numbers = vec![u32::MAX];
            for group in &hits.groups {
                numbers.push(u32::MAX - 1);
                for hit in group {
                    match hit.feature {
                        Feature::Vertex(v) => numbers.extend([0, number(v)]),
                        Feature::Edge([u, v]) => numbers.extend([1, number(u), number(v)]),
                        Feature::Face(face) => numbers.extend([2, face]),
                    }
                    numbers.push(u32::from(hit.is_along));
                }
            }
            let sum = hits.crossings.unwrap_or(i64::MAX);
            numbers.into_iter().flat_map(u32::to_le_bytes).chain(sum.to_le_bytes()).collect::<Vec<u8>>()
        };
        digest(self.0.iter().flat_map(one))
    }
}

impl SceneFormat for MeshRays {
    fn name(&self) -> &'static str {
        "mesh-rays"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "the vertices, edges and faces of a mesh that lines, rays or segments hit, in order"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["mesh", "points", "triangles", "rays", "extent"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points", "rays"]
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["mesh", "rays"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        read::read(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &generate::FAMILIES
    }

    fn sample_keys(&self) -> &'static [&'static str] {
        &["shots = 12"]
    }

    fn generator_keys(&self) -> &'static [&'static str] {
        &["shots", "extent"]
    }
}

impl Task for MeshRays {
    type Content = RayScene;
    type Truth = Truth;
    type Answer = RayHits;

    fn has_two_meshes(&self) -> bool {
        true
    }

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("rays-torus", 48).with("shots = 48"),
                Compared::near("rays-cubes", 48).with("shots = 48"),
                Compared::degenerate("rays-lattice", 48).with("shots = 48"),
            ]
        }
    }

    fn replies(&self) -> Option<&'static dyn Replies<MeshRays>> {
        Some(&replies::Judge)
    }

    fn turns(&self, knob: Knob) -> Turns {
        match knob {
            Knob::Translation => Turns::UpTo(48, "both points of a ray are rounded to one place"),
            _ => Turns::Everywhere,
        }
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d, PredicateKind::Orient3d]
    }

    fn constructs(&self) -> bool {
        true
    }

    fn takes_threads(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, content: &RayScene, watch: &Watch) -> Result<Truth, Stop> {
        Truth::new(scene, content, watch)
    }

    fn sampled(&self, truth: &Truth) -> Option<String> {
        truth.sampled()
    }

    fn dispute(&self, case: &Case<'_, MeshRays>) -> Option<Dispute> {
        let is_point = |[p, q]: &[Vertex; 2]| case.scene().point3(*p) == case.scene().point3(*q);
        let at = case.content.rays.iter().position(is_point)?;
        let why = format!("the two points of ray {at} are equal");
        Some(Dispute::Invalid { why, cure: "give it a direction".to_owned() })
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &RayScene,
        how: &How<'_>,
        answer: &mut RayHits,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        let tree = content.tree(session.scene());
        answer.0 = hits(session, tree, content.extent, &content.rays)?;
        how.watch.done(content.rays.len() as u64)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, MeshRays>,
        asked: &Asked<'_>,
        answer: &RayHits,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, &answer.0, outcome)
    }

    fn size(&self, content: &RayScene) -> usize {
        content.triangles.len()
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<MeshRays>> {
        spoiled::all()
    }

    fn describe(&self, loaded: &LoadedScene, content: &RayScene, watch: &Watch) -> Result<String, Stop> {
        let truth = Truth::new(&loaded.scene, content, watch)?;
        let hits: usize = truth.known().iter().flat_map(|known| &known.groups).map(Vec::len).sum();
        let kind = if content.is_closed() { "closed" } else { "open" };
        let sampled = truth.sampled().map(|sampled| format!(" ({sampled})")).unwrap_or_default();
        Ok(format!(
            "{} triangles, {kind}, {} queries of extent {}: {hits} hits{sampled}\n",
            content.triangles.len(),
            content.rays.len(),
            content.extent.name(),
        ))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &RayScene,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let (at, about) = named(&content.rays, query)?;
        let told = |hits: &Hits| match hits.crossings {
            Some(sum) => format!("{}; crossings {sum}", describe(&hits.groups)),
            None => describe(&hits.groups),
        };
        let ask = |backend: &dyn Contestant| backend.answer(self, scene, content).map(|found| told(&found.0[at]));
        Ok(about.with_answers(backends, ask))
    }

    /// Offers the hits of each query, as text and as the triangles at each hit.
    fn write(
        &self,
        scene: &Scene,
        content: &RayScene,
        answer: &RayHits,
        files: &mut Files,
    ) -> Result<(), output::Error> {
        files.json("hits.json", || {
            let ray = move |(ends, hits): (&[Vertex; 2], &Hits)| {
                let words = |group: &Vec<_>| group.iter().map(ToString::to_string).collect::<Vec<String>>();
                serde_json::json!({
                    "points": ends.map(|v| scene.point(v).to_vec()),
                    "hits": hits.groups.iter().map(words).collect::<Vec<_>>(),
                    "faces": replies::faces(content, hits),
                    "crossings": hits.crossings,
                })
            };
            Each(move || content.rays.iter().zip(&answer.0).map(ray))
        })
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &RayScene,
        answer: Option<&RayHits>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        canvas.faces(scene, "mesh", Role::Faint, &content.triangles)?;
        canvas.lines(scene, content.extent.name(), Role::Second, &content.rays)?;
        let Some(answer) = answer else { return Ok(()) };
        let (mut vertices, mut edges, mut faces) = (Vec::new(), Vec::new(), Vec::new());
        for hit in answer.0.iter().flat_map(|hits| &hits.groups).flatten() {
            match hit.feature {
                Feature::Vertex(v) => vertices.push(v),
                Feature::Edge(ends) => edges.push(ends),
                Feature::Face(face) => faces.push(content.triangles[face as usize]),
            }
        }
        canvas.faces(scene, "faces that are hit", Role::Found, &faces)?;
        canvas.lines(scene, "edges that are hit", Role::Found, &edges)?;
        canvas.points(scene, "vertices that are hit", Role::Found, vertices)?;
        Ok(())
    }
}
