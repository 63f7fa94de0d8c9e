//! The task `mesh-locate`: the region of a multi-material mesh in which each probe lies.
//!
//! PinMesh (Franklin and Magalhães, section 4.4). Each point of space should be in exactly one region, whichever
//! direction a ray from it has, also on lines through vertices and edges.

mod bands;
mod checks;
pub mod content;
pub mod generate;
mod judge;
mod made;
mod mesh_file;
mod phases;
pub mod probes;
pub mod read;
pub mod regions;
mod replies;
mod section;
mod spoiled;

use crate::algorithm::{Location, Ray, Scratch, locate_all, question_all};
use crate::truth::Truth;
use predicament_corpus::{Context, Family, InDecimals, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_judge::solids::{Materials, Place};
use predicament_mesh::OUTSIDE;
use predicament_predicates::{Declined, PredicateKind, Predicates, Query, Scene};
use predicament_records::{RunDir, TableSpec};
use predicament_report::Section;
use predicament_report::drawing::Role;

pub use content::{Probe, ProbeKind, ProbedMesh};
pub use section::MeshLocateRow;

use predicament_tasks::output::{self, Canvas, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, ExplainError, Explanation, Halt, How, Knob, Outcome, Phase,
    Purpose, Spoiled, Stop, Task, Turns, Watch, digest,
};

/// A layer of probes in the drawing of an answer.
type LocationLayer = (&'static str, Role, fn(&Location) -> bool);
const LAYERS: [LocationLayer; 5] = [
    ("outside", Role::Given, |location| *location == Location::In(OUTSIDE)),
    ("in a region", Role::Found, |location| matches!(location, Location::In(region) if *region != OUTSIDE)),
    ("on the mesh", Role::Second, |location| matches!(location, Location::On(_))),
    ("contradictory", Role::Mark, |location| *location == Location::Contradiction),
    ("undecided", Role::Faint, |location| *location == Location::Undecided),
];

/// The task `mesh-locate`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MeshLocate;

/// The locations of all probes.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Located(pub Vec<Location>);

impl Answer for Located {
    fn digest(&self) -> u64 {
        digest(self.0.iter().flat_map(|location| {
            let [kind, number] = match *location {
                Location::In(region) => [0, region],
                Location::On(triangle) => [1, triangle],
                Location::Contradiction => [2, 0],
                Location::Undecided => [3, 0],
            };
            [kind, number].into_iter().flat_map(u32::to_le_bytes)
        }))
    }
}

impl SceneFormat for MeshLocate {
    fn name(&self) -> &'static str {
        "mesh-locate"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "the region of a multi-material mesh in which a point lies (Franklin and Magalhães, 4.4)"
    }

    fn in_decimals(&self) -> InDecimals {
        InDecimals::Integers
    }

    fn keys(&self) -> &'static [&'static str] {
        &[
            "mesh",
            "points",
            "triangles",
            "regions",
            "tetrahedra",
            "probes",
            "random",
            "random_full",
            "seed",
            "quick_stride",
            "full_stride",
        ]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points", "probes"]
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["mesh", "probes"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        read::read(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &generate::FAMILIES
    }

    fn sample_keys(&self) -> &'static [&'static str] {
        &["random = 20", "random_full = 30"]
    }

    fn generator_keys(&self) -> &'static [&'static str] {
        &["random", "random_full", "quick_stride", "full_stride"]
    }
}

impl Task for MeshLocate {
    type Content = ProbedMesh;
    type Truth = Truth;
    type Answer = Located;

    fn has_two_meshes(&self) -> bool {
        true
    }

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("locate-torus", 48).with("random = 60\nquick_stride = 0"),
                Compared::degenerate("locate-tetrahedra", 48).with("random = 0\nquick_stride = 3"),
            ]
        }
    }

    fn replies(&self) -> Option<&'static dyn Replies<MeshLocate>> {
        Some(&replies::Judge)
    }

    fn turns(&self, knob: Knob) -> Turns {
        match knob {
            Knob::Translation => Turns::UpTo(32, "a rounded mesh crosses itself"),
            Knob::Precision => Turns::UpTo(29, "a rounded mesh crosses itself"),
            _ => Turns::Everywhere,
        }
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d, PredicateKind::Orient3d]
    }

    fn takes_threads(&self) -> bool {
        true
    }

    fn looks_at_watch(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, content: &ProbedMesh, watch: &Watch) -> Result<Truth, Stop> {
        Truth::new(scene, content, watch)
    }

    fn sampled(&self, truth: &Truth) -> Option<String> {
        truth.sampled()
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &ProbedMesh,
        how: &How<'_>,
        answer: &mut Located,
    ) -> Result<(), Halt> {
        let (session, index) = (&*session, content.mesh_index(session.scene()));
        let probes = content.vertices();
        answer.0 = match how.purpose {
            Purpose::Judge => {
                let session: &dyn Predicates = session;
                how.watch.counted(|go_on| question_all(index, session, &probes, &Ray::ALL, go_on))?
            }
            Purpose::Use | Purpose::Files => how.watch.counted(|go_on| locate_all(index, session, &probes, go_on))?,
        };
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, MeshLocate>,
        asked: &Asked<'_>,
        answer: &Located,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, &answer.0, outcome)
    }

    fn size(&self, content: &ProbedMesh) -> usize {
        content.mesh.triangles().len()
    }

    fn building(&self, scene: &Scene, content: &ProbedMesh) -> Vec<Phase> {
        phases::building(scene, content)
    }

    fn asking<P: Predicates>(&self, session: &mut P, content: &ProbedMesh) -> Vec<Phase> {
        phases::asking(session, content)
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<MeshLocate>> {
        spoiled::all()
    }

    fn describe(&self, loaded: &LoadedScene, content: &ProbedMesh, watch: &Watch) -> Result<String, Stop> {
        let truth = Truth::new(&loaded.scene, content, watch)?;
        let [within, on, contradictions] = truth.counts();
        let sampled = truth.sampled().map(|sampled| format!(" ({sampled})")).unwrap_or_default();
        let kinds = ProbeKind::ALL.into_iter().map(|kind| {
            let count = content.probes.iter().filter(|probe| probe.kind == kind).count();
            (count > 0).then(|| format!("{count} {}", kind.name()))
        });
        let kinds: Vec<String> = kinds.flatten().collect();
        Ok(format!(
            "{} triangles, {} regions with the outside, {} probes: {}\n\
             {within} in a region, {on} on the mesh, {contradictions} in no one region{sampled}\n",
            content.mesh.triangles().len(),
            content.mesh.regions(),
            content.probes.len(),
            kinds.join(", "),
        ))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &ProbedMesh,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let probe = query.vertices().next().ok_or_else(|| ExplainError::not_of_task(query, "names no probe"))?;
        let index = content.mesh_index(scene);
        let ask = |backend: &dyn Contestant| {
            let mut told = Err(Declined::scene("the backend asked for no session"));
            let prepared = backend.with_session(scene, &mut |session| {
                told = self.supported(session).map(|()| {
                    let mut scratch = Scratch::new();
                    let by_rays = Ray::ALL.map(|ray| named(index.question(session, probe, ray, &mut scratch)));
                    let short = named(locate_all(index, session, &[probe], &|_| true)[0]);
                    if by_rays.iter().all(|by_ray| *by_ray == short) {
                        short
                    } else {
                        format!("{short}; by all triangles along +z, -z, +x, -x, +y, -y: {}", by_rays.join(", "))
                    }
                });
            });
            prepared.and(told)
        };
        let place = Materials::new(scene, content.mesh.triangles(), content.mesh.sides()).locate(probe);
        let (mut vertices, mut truth) = (vec![probe], judge::told(&place));
        if let Place::On(triangles) = &place {
            let corners = content.mesh.triangles()[triangles[0] as usize];
            truth.push_str(&format!(
                "; the corners of triangle {} are {}, {} and {}",
                triangles[0], corners[0], corners[1], corners[2]
            ));
            vertices.extend(corners);
        }
        let about = Explanation { vertices, truth: vec![truth], ..Explanation::default() };
        Ok(about.with_answers(backends, ask))
    }

    /// Offers a CSV file: each probe with its rule, its coordinates, the answer, the region that it is in or the
    /// triangle that it is on, and its label.
    fn write(
        &self,
        scene: &Scene,
        content: &ProbedMesh,
        answer: &Located,
        files: &mut Files,
    ) -> Result<(), output::Error> {
        files.write("probes.csv", |out| {
            writeln!(out, "vertex,kind,x,y,z,answer,region,triangle,label")?;
            for (probe, location) in content.probes.iter().zip(&answer.0) {
                let [x, y, z] = scene.point3(probe.vertex);
                let [answer, region, triangle] = match location {
                    Location::In(region) => ["in", &region.to_string(), ""].map(str::to_owned),
                    Location::On(triangle) => ["on", "", &triangle.to_string()].map(str::to_owned),
                    Location::Contradiction => ["contradiction", "", ""].map(str::to_owned),
                    Location::Undecided => ["undecided", "", ""].map(str::to_owned),
                };
                let (vertex, kind) = (probe.vertex, probe.kind.name());
                let label = replies::label(location).map_or_else(String::new, |label| label.cast_signed().to_string());
                writeln!(out, "{vertex},{kind},{x:?},{y:?},{z:?},{answer},{region},{triangle},{label}")?;
            }
            Ok(())
        })
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &ProbedMesh,
        answer: Option<&Located>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        let probes = || content.probes.iter().map(|probe| probe.vertex);
        canvas.faces(scene, "mesh", Role::Faint, content.mesh.triangles())?;
        let Some(Located(answer)) = answer else {
            canvas.points(scene, "probes", Role::Second, probes())?;
            return Ok(());
        };
        for (name, role, is) in LAYERS {
            let of = probes().zip(answer).filter(|(_, location)| is(location));
            canvas.points(scene, name, role, of.map(|(v, _)| v))?;
        }
        Ok(())
    }

    fn tables(&self) -> Vec<TableSpec> {
        vec![TableSpec::of::<MeshLocateRow>()]
    }

    fn section(&self, runs: &[RunDir]) -> Result<Option<Section>, predicament_records::Error> {
        section::section(runs)
    }
}

/// The location as text.
#[must_use]
pub fn named(location: Location) -> String {
    match location {
        Location::In(OUTSIDE) => "outside".to_owned(),
        Location::In(region) => format!("in region {region}"),
        Location::On(triangle) => format!("on triangle {triangle}"),
        Location::Contradiction => "in no one region".to_owned(),
        Location::Undecided => "undecided".to_owned(),
    }
}
