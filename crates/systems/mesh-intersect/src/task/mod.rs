//! The task `mesh-intersect`: two multi-material meshes, cut where they meet.
//!
//! 3D-EPUG-Overlay (Franklin and Magalhães, section 4.5). The answer is the whole overlay: pieces of all triangles,
//! each in a region of either mesh. Boolean operations select some of them.

mod checks;
mod content;
mod files;
mod flaw;
mod generate;
mod judge;
mod memory;
mod phases;
mod read;
mod replies;
mod section;
mod settled;
mod shapes;
mod spoiled;
mod spoiled_results;

use crate::algorithm::overlay::{Contacts, Contradiction, Regions, Source as OfMesh, Undone, mesh_overlay_as_answered};
use predicament_corpus::{Context, Family, InDecimals, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{Construction, Declined, PredicateKind, Predicates, Query, Scene, Vertex};

use predicament_records::{RunDir, TableSpec};
use predicament_report::Section;
use predicament_report::drawing::{Role, Shape};

use flaw::Invalid;

pub use content::TwoMeshes;
pub use section::MeshIntersectRow;
pub use settled::{Settled, Unsettled};

use predicament_tasks::output::{Canvas, Each, Files, Placed};
use predicament_tasks::replies::Replies;
use predicament_tasks::{
    Agreement, Answer, Asked, Case, Check, Compared, Contestant, Dispute, ExplainError, Explanation, Halt, How, Knob,
    Outcome, Phase, Purpose, Refusal, Spoiled, Stop, Task, Turns, Watch, digest, output,
};

/// The task `mesh-intersect`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MeshIntersect;

/// The overlay, and the constructed vertices.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Overlaid {
    /// All pieces, with the regions of both meshes on either side.
    pub regions: Regions,
    /// The surface of each operation, in the order of [`Operation::ALL`].
    pub solids: [Vec<[Vertex; 3]>; 4],
    /// For each triangle of these, its source.
    pub sources: [Vec<OfMesh>; 4],
    /// Where the solids touch without a common inside, if zeros are exact.
    pub contacts: Contacts,
    /// The constructions.
    pub constructions: Vec<Construction>,
    /// The number of constructions that the scene had before.
    pub before: usize,
    /// The session's rounded positions of the constructed vertices; `None` if it keeps them exactly.
    pub rounded: Option<Vec<[f64; 3]>>,
    /// The registered positions of the constructed vertices; `None` without registered contacts. The judge uses the
    /// points of the definitions.
    pub registered: Option<Vec<[f64; 3]>>,
    /// The results without the perturbation, and in doubles, or the reason why there are none; `None` if they were not
    /// requested, or the session rounds.
    pub settled: Option<std::result::Result<Settled, Unsettled>>,
    /// The first invariant that fails: then there are no other results.
    pub broken: Option<Contradiction>,
}

impl Overlaid {
    /// Overlays the meshes of a scene; with `settles`, also computes the results without the perturbation.
    ///
    /// # Errors
    /// [`Halt::Refused`] if the session does not construct a vertex, or registers a contact of smaller simplices than
    /// an edge and a triangle.
    fn of(session: &mut dyn Predicates, content: &TwoMeshes, settles: bool) -> Result<Overlaid, Halt> {
        memory::affordable(session.scene(), content)?;
        let before = session.scene().constructions().len();
        let overlaid = mesh_overlay_as_answered(session, content.meshes.clone(), &mut |_| {});
        let (overlay, registered) = match overlaid {
            Ok(overlaid) => overlaid,
            Err(Undone::Refused(why)) => return Err(why.into()),
            Err(touch @ Undone::Contact(_)) => {
                let why = format!("{touch}; use a backend that breaks ties, such as sos:per-mesh");
                return Err(Halt::Refused(Refusal { check: "touch", why: Declined::scene(why) }));
            }
            Err(own @ Undone::Own { .. }) => {
                let why = format!(
                    "{own}; unite the parts of that mesh first (`corpus resolve` does so), or use a backend that breaks \
                     ties, such as sos:per-mesh"
                );
                return Err(Halt::Refused(Refusal { check: "own parts", why: Declined::scene(why) }));
            }
            Err(Undone::Broken(rule)) => return Ok(Overlaid { before, broken: Some(rule), ..Overlaid::default() }),
        };
        let constructions = overlay.constructions().to_vec();
        let solids = Operation::ALL.map(|operation| overlay.solid(operation));
        Ok(Overlaid {
            settled: if settles { settled::settled(session, &overlay, &solids, before) } else { None },
            regions: overlay.regions(),
            contacts: if settles { overlay.contacts() } else { Contacts::default() },
            sources: solids.each_ref().map(|solid| solid.sources.clone()),
            solids: solids.map(|solid| solid.triangles),
            rounded: output::rounded_points(session, before, constructions.len()),
            registered: registered
                .and_then(|registered| output::rounded_points(&registered, before, constructions.len())),
            constructions,
            before,
            broken: None,
        })
    }
}

impl Answer for Overlaid {
    fn digest(&self) -> u64 {
        let number = |n: usize| (n as u64).to_le_bytes();
        let pieces = self.regions.triangles.iter().zip(&self.regions.sides).flat_map(|(triangle, sides)| {
            let pairs = sides.map(|side| self.regions.pairs[side as usize]);
            let regions = pairs.into_iter().flatten().map(|region| region as usize);
            triangle.map(Vertex::index).into_iter().chain(regions).collect::<Vec<_>>()
        });
        digest(pieces.flat_map(number).chain(self.broken.map_or("", Contradiction::rule).bytes()))
    }
}

impl SceneFormat for MeshIntersect {
    fn name(&self) -> &'static str {
        "mesh-intersect"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "two multi-material meshes, cut where they meet (Franklin and Magalhães, 4.5)"
    }

    fn in_decimals(&self) -> InDecimals {
        InDecimals::Integers
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "first", "second", "first_regions", "second_regions", "moved", "check"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["first", "second"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        read::read(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &generate::FAMILIES
    }
}

impl Task for MeshIntersect {
    type Content = TwoMeshes;
    type Truth = Option<Invalid>;
    type Answer = Overlaid;

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("intersect-spheres", 40).with("placed = \"apart\""),
                Compared::near("intersect-spheres", 24).with("placed = \"ulp\""),
                Compared::degenerate("intersect-cubes", 24).with("placed = \"step\""),
            ]
        }
    }

    fn replies(&self) -> Option<&'static dyn Replies<MeshIntersect>> {
        Some(&replies::Judge)
    }

    fn turns(&self, knob: Knob) -> Turns {
        match knob {
            Knob::Translation => Turns::UpTo(32, "rounded meshes cross themselves"),
            Knob::Shift | Knob::Precision => Turns::Nowhere("rounded meshes cross themselves"),
            _ => Turns::Everywhere,
        }
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d, PredicateKind::Orient3d]
    }

    fn takes_threads(&self) -> bool {
        true
    }

    fn memory(&self, scene: &Scene, content: &TwoMeshes) -> Option<u64> {
        Some(memory::estimate(scene, content, memory::FILES))
    }

    fn scaled(&self) -> Option<Compared> {
        Some(Compared::general("intersect-spheres", 1).with("placed = \"apart\""))
    }

    fn constructs(&self) -> bool {
        true
    }

    fn has_two_meshes(&self) -> bool {
        true
    }

    fn judges_whole(&self) -> bool {
        true
    }

    /// The reason why the meshes are not valid, if they are small enough to be checked. The task has no other truth:
    /// the laws and the meshes suffice.
    fn truth(&self, scene: &Scene, content: &TwoMeshes, watch: &Watch) -> Result<Option<Invalid>, Stop> {
        watch.done(0)?;
        Ok(flaw::invalid(scene, content))
    }

    fn sampled(&self, _: &Option<Invalid>) -> Option<String> {
        None
    }

    /// Meshes that do not bound their regions, as after random moves of points. `check = false` takes them as they are.
    fn dispute(&self, case: &Case<'_, MeshIntersect>) -> Option<Dispute> {
        let Invalid { why, cure } = case.truth.as_ref()?.clone();
        Some(Dispute::Invalid { why, cure: cure.to_owned() })
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &TwoMeshes,
        how: &How<'_>,
        answer: &mut Overlaid,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        let settles = how.purpose != Purpose::Use;
        *answer = Overlaid::of(session, content, settles)?;
        how.watch.done(content.triangles() as u64)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, MeshIntersect>,
        asked: &Asked<'_>,
        answer: &Overlaid,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        outcome.sampled = judge::sampled(case.content);
        section::rows(case, asked, answer, outcome);
        judge::judge(case, asked, answer, outcome)
    }

    /// The overlay over the written points: constructed vertices keep their definitions, and no vertex is rounded. The
    /// results without the perturbation are about the doubles alone.
    fn agreement(
        &self,
        _: &Case<'_, MeshIntersect>,
        written: &Case<'_, MeshIntersect>,
        asked: &Asked<'_>,
        answer: &Overlaid,
        own: &Outcome,
    ) -> Result<Agreement, Stop> {
        let over = Overlaid { rounded: None, registered: None, settled: None, ..answer.clone() };
        let mut outcome = Outcome::default();
        judge::laws(written, asked, &over, &mut outcome)?;
        Ok(Agreement::of_wholes(own, &outcome))
    }

    fn building(&self, _: &Scene, content: &TwoMeshes) -> Vec<Phase> {
        phases::building(content)
    }

    fn asking<P: Predicates>(&self, session: &mut P, content: &TwoMeshes) -> Vec<Phase> {
        phases::asking(session, content)
    }

    fn tables(&self) -> Vec<TableSpec> {
        vec![TableSpec::of::<MeshIntersectRow>()]
    }

    fn section(&self, runs: &[RunDir]) -> Result<Option<Section>, predicament_records::Error> {
        section::section(runs)
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<MeshIntersect>> {
        let mut all = spoiled::all();
        all.extend(spoiled_results::all());
        all
    }

    fn describe(&self, _: &LoadedScene, content: &TwoMeshes, _: &Watch) -> Result<String, Stop> {
        let [first, second] = content.meshes.each_ref().map(|mesh| (mesh.triangles().len(), mesh.regions() - 1));
        Ok(format!("{} triangles around {} regions, and {} around {}\n", first.0, first.1, second.0, second.1))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &TwoMeshes,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let _ = query;
        let ask = |backend: &dyn Contestant| backend.answer(self, scene, content).map(|answer| told(&answer));
        Ok(Explanation::default().with_answers(backends, ask))
    }

    /// Offers a mesh for each operation, in doubles if the result is known without the perturbation, otherwise
    /// perturbed; also the statistics of rounding, all vertices exactly, and a JSON file of all pieces.
    fn write(&self, scene: &Scene, _: &TwoMeshes, answer: &Overlaid, files: &mut Files) -> Result<(), output::Error> {
        let placed = Placed::new(
            scene,
            &answer.constructions,
            answer.before,
            answer.rounded.as_ref().or(answer.registered.as_ref()).map(|points| &points[..]),
        )?;
        files.broken(answer.broken);
        if let Some(Ok(settled)) = &answer.settled {
            files::settled(settled, files)?;
        } else {
            for (operation, solid) in Operation::ALL.iter().zip(&answer.solids) {
                let face = |triangle: &[Vertex; 3]| triangle.map(|v| placed.place(v)).to_vec();
                output::mesh(files, &placed.meshes, operation.name(), solid.iter().map(face))?;
            }
        }
        let regions = &answer.regions;
        files.json("pieces.json", || {
            let piece = move |at: usize| {
                let sides = regions.sides[at].map(|side| regions.pairs[side as usize]);
                serde_json::json!({
                    "vertices": regions.triangles[at].map(|v| v.to_string()),
                    "mesh": regions.sources[at].mesh + 1,
                    "triangle": regions.sources[at].triangle,
                    "front": sides[0],
                    "behind": sides[1],
                })
            };
            let pieces = Each(move || (0..regions.triangles.len()).map(piece));
            files::Pieces { broken: answer.broken.map(Contradiction::rule), pieces }
        })?;
        if answer.contacts != Contacts::default() {
            let place = |v: Vertex| placed.exact.construction(v).is_none().then(|| placed.exact.point3(v));
            files.json("contacts.json", || files::contacts(&answer.contacts, &place))?;
        }
        match &answer.rounded {
            None => output::vertices(files, &placed.exact, regions.triangles.as_flattened().iter().copied()),
            Some(_) => Ok(()),
        }
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &TwoMeshes,
        answer: Option<&Overlaid>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        let given = [("first", Role::Given), ("second", Role::Second)];
        for ((name, role), mesh) in given.into_iter().zip(&content.meshes) {
            canvas.faces(scene, name, role, mesh.triangles())?.is_shown = answer.is_none();
        }
        let Some(answer) = answer else { return Ok(()) };
        if let Some(Ok(settled)) = &answer.settled {
            for (operation, result) in settled.by_operation() {
                let closed = &result.rounded.closed;
                let face = |triangle: &[u32; 3]| vec![triangle.map(|v| closed.points[v as usize]).to_vec()];
                let layer =
                    canvas.places(operation.name(), Role::Found, Shape::Areas, closed.triangles.iter().map(face));
                layer.is_shown = operation == Operation::Union;
            }
            return Ok(());
        }
        let rounded = answer.rounded.as_ref().or(answer.registered.as_ref());
        let placed = Placed::new(scene, &answer.constructions, answer.before, rounded.map(|points| &points[..]))?;
        for (operation, solid) in Operation::ALL.into_iter().zip(&answer.solids) {
            let faces = solid.iter().map(|triangle| triangle.map(|v| placed.place(v)));
            let layer = canvas.faces(&placed.meshes, operation.name(), Role::Found, faces)?;
            layer.is_shown = operation == Operation::Union;
        }
        Ok(())
    }
}

fn told(answer: &Overlaid) -> String {
    if let Some(broken) = answer.broken {
        return format!("broken: {broken}");
    }
    let solids = Operation::ALL.iter().zip(&answer.solids);
    let solids: Vec<String> = solids.map(|(of, solid)| format!("{} of {}", of.name(), solid.len())).collect();
    format!(
        "{} points, {} pieces; triangles: {}",
        answer.constructions.len(),
        answer.regions.triangles.len(),
        solids.join(", ")
    )
}
