//! `cube-union`: volume, area and edge length of a union of congruent cubes.
//!
//! Franklin and Magalhães, section 4.3. In the relevant scenes every face coincides with others. A backend that breaks
//! ties has no degenerate cases, and its answer is the union of cubes that are moved by infinitesimals. The answer of
//! every other backend is the union of closed cubes.

mod checks;
mod content;
mod generate;
mod judge;
mod replies;
mod section;
mod spoiled;

use std::collections::BTreeMap;

use crate::algorithm::{Mass, cube_union_by};
use crate::truth::Truth;
use predicament_corpus::{Context, Family, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{PredicateKind, Predicates, Query, Scene, Vertex};
use predicament_records::{RunDir, TableSpec};
use predicament_report::Section;
use predicament_report::drawing::{Role, Shape};

pub use content::Cubes;
pub use section::MassRow;

use predicament_tasks::output::{self, Canvas, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, ExplainError, Explanation, Halt, How, Knob, Outcome, Spoiled,
    Stop, Task, Turns, Watch, digest,
};

/// The task `cube-union`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CubeUnion;

/// The mass properties of a union, and the exponent of their unit.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Union {
    /// The mass properties, in units of a power of two.
    pub mass: Mass,
    /// The exponent of the unit: lengths are multiples of 2^`exponent`.
    pub exponent: i32,
}

impl Answer for Union {
    fn digest(&self) -> u64 {
        let (mass, of) = (&self.mass, self.mass.vertices);
        let sums = [mass.volume, mass.area, mass.edge_length].map(i128::to_le_bytes);
        let counts = of.by_name().map(|(_, count)| count.to_le_bytes());
        digest(sums.into_iter().flatten().chain(counts.flatten()))
    }
}

impl SceneFormat for CubeUnion {
    fn name(&self) -> &'static str {
        "cube-union"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "volume, area and edge length of a union of congruent cubes (Franklin and Magalhães, 4.3)"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["cubes"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["cubes"]
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["cubes"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        content::read(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &generate::FAMILIES
    }
}

impl Task for CubeUnion {
    type Content = Cubes;
    type Truth = Truth;
    type Answer = Union;

    fn compared(&self) -> &'static [Compared] {
        const { &[Compared::general("cubes-uniform", 30), Compared::degenerate("cubes-degen", 30)] }
    }

    fn turns(&self, knob: Knob) -> Turns {
        match knob {
            Knob::Size => Turns::Everywhere,
            Knob::Scale => Turns::UpTo(250, "volumes are not doubles"),
            Knob::Translation => Turns::UpTo(16, "corners are rounded, and the cubes then differ in size"),
            Knob::Noise | Knob::Shift | Knob::Aspect | Knob::Precision => {
                Turns::Nowhere("all cubes must keep one size")
            }
            Knob::Pythagorean | Knob::Turn => Turns::Nowhere("the faces of cubes are across the axes"),
        }
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare]
    }

    fn judges_whole(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, _: &Cubes, watch: &Watch) -> Result<Truth, Stop> {
        Truth::new(scene, watch)
    }

    fn sampled(&self, truth: &Truth) -> Option<String> {
        truth.sampled()
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Cubes,
        how: &How<'_>,
        answer: &mut Union,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        let (mass, exponent) = cube_union_by(&*session).expect("the reader refuses cubes whose sums overflow");
        *answer = Union { mass, exponent };
        how.watch.done(content.cubes as u64)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, CubeUnion>,
        asked: &Asked<'_>,
        answer: &Union,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, answer, outcome);
        Ok(())
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<CubeUnion>> {
        spoiled::all()
    }

    fn replies(&self) -> Option<&'static dyn Replies<CubeUnion>> {
        Some(&replies::Judge)
    }

    fn describe(&self, _: &LoadedScene, content: &Cubes, _: &Watch) -> Result<String, Stop> {
        Ok(format!("{} cubes\n", content.cubes))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Cubes,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let _ = query;
        let ask =
            |backend: &dyn Contestant| backend.answer(self, scene, content).map(|union| format!("{:?}", union.mass));
        Ok(Explanation::default().with_answers(backends, ask))
    }

    fn write(&self, _: &Scene, _: &Cubes, answer: &Union, files: &mut Files) -> Result<(), output::Error> {
        let Union { mass, exponent } = answer;
        let of = mass.vertices;
        files.write("union.json", |out| {
            // Exact: integers times powers of two. A JSON number would round beyond 2^53, so sums are strings.
            let json = serde_json::json!({
                "unit_exponent": exponent,
                "volume": mass.volume.to_string(),
                "area": mass.area.to_string(),
                "edge_length": mass.edge_length.to_string(),
                "corners": of.corners,
                "edge_faces": of.edge_faces,
                "three_faces": of.three_faces,
                // Vertices that need faces in one plane.
                "tied": of.by_name().skip(3).filter(|&(_, count)| count > 0).collect::<BTreeMap<_, _>>(),
                "euler_characteristic": of.of_the_union().map(|euler| euler.to_string()),
            });
            writeln!(out, "{json:#}")
        })?;
        // The same in the scene's units, in doubles, as other programs compute them.
        files.json("measures.json", || {
            let [volume, area, edge_length] = replies::measures(answer);
            serde_json::json!({ "volume": volume, "area": area, "edge_length": edge_length })
        })
    }

    fn draw(&self, scene: &Scene, content: &Cubes, _: Option<&Union>, canvas: &mut Canvas) -> std::io::Result<()> {
        let corners = |cube: usize| [2 * cube, 2 * cube + 1].map(|at| scene.point3(Vertex::input(at)));
        let faces = (0..content.cubes).flat_map(|cube| faces(corners(cube)));
        canvas.places("cubes", Role::Given, Shape::Areas, faces.map(|face| vec![face.to_vec()]));
        Ok(())
    }

    fn tables(&self) -> Vec<TableSpec> {
        vec![TableSpec::of::<MassRow>()]
    }

    fn section(&self, runs: &[RunDir]) -> Result<Option<Section>, predicament_records::Error> {
        section::section(runs)
    }
}

/// The six faces of the cube with these corners.
fn faces([low, high]: [[f64; 3]; 2]) -> Vec<[[f64; 3]; 4]> {
    let side = |axis: usize, at: f64| {
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        [[low[u], low[v]], [high[u], low[v]], [high[u], high[v]], [low[u], high[v]]].map(|[x, y]| {
            let mut corner = [at; 3];
            corner[u] = x;
            corner[v] = y;
            corner
        })
    };
    (0..3).flat_map(|axis| [side(axis, low[axis]), side(axis, high[axis])]).collect()
}
