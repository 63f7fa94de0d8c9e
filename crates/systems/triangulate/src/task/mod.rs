//! The task `triangulate`: triangles of polygons with holes, in the plane and of faces in space.
//!
//! The methods are ear clipping and a plane sweep. Wrong signs cut ears across edges, join holes to vertices that they
//! do not see, and break the order of the sweep. The judge compares the result with the polygon's area, its edges and
//! the number of triangles.

mod checks;
mod content;
mod generate;
mod judge;
mod replies;
mod shapes;
mod spoiled;
mod touching;

use crate::algorithm::{Contradiction, Triangulation, oriented, projection, triangulate};
use crate::truth::Truth;
use predicament_corpus::{Context, Family, InDecimals, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{Dimension, Plane, PredicateKind, Predicates, Query, Scene, Vertex};
use predicament_report::drawing::Role;

pub use content::Polygons;

pub use checks::RULES;
use predicament_tasks::output::{Canvas, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, Dispute, ExplainError, Explanation, Halt, How, Knob, Outcome,
    Spoiled, Stop, Task, Turns, Watch, digest, output,
};

/// The task `triangulate`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Triangulate;

/// The triangulation of each polygon, in order.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Triangulated(pub Vec<Triangulation>);

impl Answer for Triangulated {
    fn digest(&self) -> u64 {
        let ids = |found: &Triangulation| {
            let triangles = found.triangles.as_flattened().iter().map(|v| v.index()).collect::<Vec<_>>();
            [triangles.len()].into_iter().chain(triangles)
        };
        digest(self.0.iter().flat_map(ids).flat_map(usize::to_le_bytes))
    }
}

impl SceneFormat for Triangulate {
    fn name(&self) -> &'static str {
        "triangulate"
    }

    fn about(&self) -> &'static str {
        "triangles of polygons with holes, by ear clipping or a plane sweep"
    }

    fn in_decimals(&self) -> InDecimals {
        InDecimals::Integers
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "loops", "regions", "map", "method"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points", "map", "polygons"]
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["map"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        content::read(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &generate::FAMILIES
    }

    fn generator_keys(&self) -> &'static [&'static str] {
        &["method"]
    }

    fn naming_keys(&self) -> &'static [&'static str] {
        &["method"]
    }
}

impl Task for Triangulate {
    type Content = Polygons;
    type Truth = Truth;
    type Answer = Triangulated;

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("polygon-star", 60),
                Compared::near("polygon-sliver", 60),
                Compared::degenerate("polygon-comb", 60),
            ]
        }
    }

    fn replies(&self) -> Option<&'static dyn Replies<Triangulate>> {
        Some(&replies::Judge)
    }

    fn turns(&self, knob: Knob) -> Turns {
        match knob {
            Knob::Translation => Turns::UpTo(32, "a rounded polygon crosses itself"),
            Knob::Precision => Turns::UpTo(37, "a rounded polygon crosses itself"),
            _ => Turns::Everywhere,
        }
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d]
    }

    fn judges_whole(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, content: &Polygons, watch: &Watch) -> Result<Truth, Stop> {
        Truth::new(scene, &content.polygons, watch)
    }

    fn sampled(&self, truth: &Truth) -> Option<String> {
        truth.sampled()
    }

    fn dispute(&self, case: &Case<'_, Triangulate>) -> Option<Dispute> {
        let flaw = case.truth.flaw()?;
        Some(Dispute::Invalid { why: flaw.why.clone(), cure: flaw.cure.to_owned() })
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Polygons,
        how: &How<'_>,
        answer: &mut Triangulated,
    ) -> Result<(), Halt> {
        answer.0.clear();
        for polygon in &content.polygons {
            answer.0.push(solve(session, polygon, content));
            how.watch.done(1)?;
        }
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Triangulate>,
        asked: &Asked<'_>,
        answer: &Triangulated,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, answer, outcome)
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<Triangulate>> {
        spoiled::all()
    }

    fn describe(&self, loaded: &LoadedScene, content: &Polygons, watch: &Watch) -> Result<String, Stop> {
        let truth = Truth::new(&loaded.scene, &content.polygons, watch)?;
        let loops: usize = content.polygons.iter().map(Vec::len).sum();
        let corners: usize = truth.polygons.iter().map(|examined| examined.polygon.corners()).sum();
        let touching: usize = truth.polygons.iter().map(|examined| examined.polygon.touches().touching.len()).sum();
        Ok(format!(
            "{} polygons, {loops} loops, {corners} corners; {touching} pairs of edges touch without a common vertex\n",
            content.polygons.len()
        ))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Polygons,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let vertices: Vec<_> = query.vertices().collect();
        let has = |polygon: &Vec<Vec<Vertex>>| vertices.iter().all(|v| polygon.iter().any(|one| one.contains(v)));
        let at = content.polygons.iter().position(has);
        let at = at.ok_or_else(|| ExplainError::not_in_scene(query, "no polygon of the scene has these vertices"))?;
        let ask = |backend: &dyn Contestant| {
            backend.answer(self, scene, content).map(|found| describe(&found.0[at], &vertices))
        };
        Ok(Explanation { vertices: vertices.clone(), ..Explanation::default() }.with_answers(backends, ask))
    }

    /// Offers meshes of faces in space, SVG, GeoJSON and WKT in the plane, and all vertices exactly.
    fn write(
        &self,
        scene: &Scene,
        content: &Polygons,
        answer: &Triangulated,
        files: &mut Files,
    ) -> Result<(), output::Error> {
        files.broken(answer.0.iter().find_map(|found| found.broken));
        let triangles: Vec<&[Vertex; 3]> = answer.0.iter().flat_map(|found| &found.triangles).collect();
        match scene.dimension() {
            Dimension::Two => {
                output::plane(files, scene, "triangles", triangles.iter().map(|triangle| vec![triangle.to_vec()]))?;
            }
            Dimension::Three => {
                output::mesh(files, scene, "triangles", triangles.iter().map(|triangle| triangle.to_vec()))?;
            }
        }
        output::vertices(files, scene, content.polygons.iter().flatten().flatten().copied())
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &Polygons,
        answer: Option<&Triangulated>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        let triangles = answer.into_iter().flat_map(|answer| &answer.0).flat_map(|found| &found.triangles);
        canvas.faces(scene, "triangles", Role::Found, triangles)?;
        let closed = |ring: &Vec<Vertex>| ring.iter().chain(ring.first()).copied().collect::<Vec<Vertex>>();
        canvas.lines(scene, "loops", Role::Given, content.polygons.iter().flatten().map(closed))?;
        Ok(())
    }
}

/// Orients the loops as they nest, in a plane in which the polygon is seen, and triangulates it.
fn solve(session: &dyn Predicates, polygon: &[Vec<Vertex>], content: &Polygons) -> Triangulation {
    let (plane, reversed) = match session.scene().dimension() {
        Dimension::Two => (Plane::Xy, false),
        Dimension::Three => match projection(session, polygon) {
            Some(seen) => seen,
            None => return Triangulation { triangles: Vec::new(), broken: Some(Contradiction::NoArea) },
        },
    };
    let loops = oriented(session, plane, reversed, polygon);
    triangulate(session, plane, reversed, &loops, content.method)
}

/// Vertices as text.
fn words(vertices: &[Vertex]) -> String {
    predicament_tasks::ids(vertices)
}

/// The triangles of a polygon at the given vertices, as text.
fn describe(found: &Triangulation, vertices: &[Vertex]) -> String {
    let is_about = |triangle: &&[Vertex; 3]| {
        let common = triangle.iter().filter(|v| vertices.contains(v)).count();
        common >= vertices.len().min(2)
    };
    let about: Vec<String> = found.triangles.iter().filter(is_about).take(6).map(|triangle| words(triangle)).collect();
    let broken = found.broken.map_or(String::new(), |broken| format!("; broken: {broken}"));
    format!("{} triangles; {}{broken}", found.triangles.len(), about.join(", "))
}
