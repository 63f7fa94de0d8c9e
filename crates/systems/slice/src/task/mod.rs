//! The task `slice`: a mesh split by planes, one after the other.
//!
//! The cascade of the lecture: each plane splits the results of the planes before it, so constructed edges are split
//! again. Exact arithmetic and Simulation of Simplicity keep the points. Controls round them between the cuts, and the
//! judge uses the rounded points.

mod checks;
mod content;
mod faces;
mod generate;
mod judge;
mod replies;
mod spoiled;

use crate::algorithm::{Sliced, Source, slice};
use crate::checks::given::Fault;
use predicament_corpus::{Context, Family, LoadedScene, SceneFormat, Source as SceneSource};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{PredicateKind, Predicates, Query, Scene, Vertex};
use predicament_report::drawing::Role;

pub use content::Solid;

pub use checks::{law, rounded};
use predicament_tasks::output::{Canvas, Files, Placed};
use predicament_tasks::replies::Replies;

use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, Dispute, ExplainError, Explanation, Halt, How, Knob, Outcome,
    Spoiled, Stop, Task, Turns, Watch, digest, output,
};

/// The task `slice`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Slice;

/// The parts, and the constructed vertices.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Cut {
    /// The parts.
    pub sliced: Sliced,
    /// The number of constructions that the scene had before.
    pub before: usize,
    /// The session's rounded positions of the constructed vertices; `None` if it keeps them exactly.
    pub rounded: Option<Vec<[f64; 3]>>,
}

impl Cut {
    fn with_points(session: &dyn Predicates, sliced: Sliced, before: usize) -> Cut {
        let rounded = output::rounded_points(session, before, sliced.constructions.len());
        Cut { rounded, sliced, before }
    }
}

impl Answer for Cut {
    fn digest(&self) -> u64 {
        let vertex = |v: Vertex| (v.index() as u64).to_le_bytes();
        let parts = self.sliced.parts.iter().flat_map(|part| {
            let ends = (part.triangles.len() as u64).to_le_bytes();
            let open = part.open.iter().flatten();
            part.triangles.as_flattened().iter().chain(open).map(move |&v| vertex(v)).chain([ends])
        });
        let broken = self.sliced.broken.map_or("", |(broken, _)| broken.rule());
        digest(parts.flatten().chain(broken.bytes()))
    }
}

impl SceneFormat for Slice {
    fn name(&self) -> &'static str {
        "slice"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "the parts of a mesh, cut by planes one after the other"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["mesh", "points", "faces", "planes", "closed"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points", "planes"]
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["mesh"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<SceneSource, CorpusError> {
        content::read(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &generate::FAMILIES
    }
}

impl Task for Slice {
    type Content = Solid;
    type Truth = Option<Fault>;
    type Answer = Cut;

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("slice-torus", 48).with("cut = \"random\""),
                Compared::degenerate("slice-lattice", 24).with("cut = \"vertices\""),
            ]
        }
    }

    fn turns(&self, knob: Knob) -> Turns {
        match knob {
            Knob::Shift | Knob::Scale | Knob::Aspect | Knob::Size => Turns::Everywhere,
            Knob::Translation => Turns::UpTo(32, "a rounded mesh crosses itself"),
            Knob::Precision => Turns::UpTo(29, "a rounded mesh crosses itself"),
            Knob::Pythagorean => Turns::UpTo(8, "coordinates need more than 53 bits, and faces do not stay flat"),
            Knob::Noise | Knob::Turn => Turns::Nowhere("faces with four corners do not stay flat"),
        }
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d, PredicateKind::Orient3d]
    }

    fn constructs(&self) -> bool {
        true
    }

    fn judges_whole(&self) -> bool {
        true
    }

    /// The truth is the mesh's fault, if it has one. Otherwise the laws and the mesh suffice.
    fn truth(&self, scene: &Scene, content: &Solid, watch: &Watch) -> Result<Option<Fault>, Stop> {
        let fault = content.fault(scene);
        watch.done(0)?;
        Ok(fault)
    }

    fn dispute(&self, case: &Case<'_, Slice>) -> Option<Dispute> {
        let (why, cure) = case.truth.as_ref()?.told(|face| face.to_string());
        Some(Dispute::Invalid { why, cure: cure.to_owned() })
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Solid,
        how: &How<'_>,
        answer: &mut Cut,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        let before = session.scene().constructions().len();
        let sliced = slice(session, content.mesh(), &content.supports, &content.planes)?;
        *answer = Cut::with_points(session, sliced, before);
        how.watch.done(content.faces.len() as u64)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Slice>,
        asked: &Asked<'_>,
        answer: &Cut,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        asked.watch.done(0)?;
        judge::judge(case, asked, answer, outcome)
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<Slice>> {
        spoiled::all()
    }

    fn replies(&self) -> Option<&'static dyn Replies<Slice>> {
        Some(&replies::Judge)
    }

    fn describe(&self, _: &LoadedScene, content: &Solid, _: &Watch) -> Result<String, Stop> {
        let closed = if content.is_closed { "closed" } else { "open" };
        Ok(format!("{} faces, {closed}, and {} planes\n", content.faces.len(), content.planes.len()))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Solid,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let _ = query;
        let ask = |backend: &dyn Contestant| backend.answer(self, scene, content).map(|cut| told(&cut.sliced));
        Ok(Explanation::default().with_answers(backends, ask))
    }

    /// Offers each part as meshes, all vertices exactly, and a JSON file with the origin of each triangle.
    fn write(&self, scene: &Scene, _: &Solid, answer: &Cut, files: &mut Files) -> Result<(), output::Error> {
        let parts = &answer.sliced.parts;
        files.broken(answer.sliced.broken.map(|(broken, _)| broken));
        let placed = Placed::new(scene, &answer.sliced.constructions, answer.before, answer.rounded.as_deref())?;
        for (at, part) in parts.iter().enumerate() {
            let face = |triangle: &[Vertex; 3]| triangle.map(|v| placed.place(v)).to_vec();
            output::mesh(files, &placed.meshes, &format!("part-{at}"), part.triangles.iter().map(face))?;
        }
        files.json("parts.json", || {
            let ids = |vertices: &[Vertex]| vertices.iter().map(ToString::to_string).collect::<Vec<_>>();
            let part = |part: &crate::algorithm::Part| {
                let triangle = |(triangle, source): (&[Vertex; 3], &Source)| serde_json::json!({ "vertices": ids(triangle), "of": name(*source) });
                let triangles: Vec<serde_json::Value> =
                    part.triangles.iter().zip(&part.sources).map(triangle).collect();
                let open: Vec<Vec<String>> = part.open.iter().map(|around| ids(around)).collect();
                serde_json::json!({ "triangles": triangles, "open": open })
            };
            serde_json::json!({
                "parts": parts.iter().map(part).collect::<Vec<_>>(),
                "broken": answer.sliced.broken.map(|(broken, _)| broken.rule()),
            })
        })?;
        if answer.rounded.is_some() {
            return Ok(());
        }
        let used = parts.iter().flat_map(|part| part.triangles.as_flattened().iter().copied());
        output::vertices(files, &placed.exact, used)
    }

    fn draw(&self, scene: &Scene, content: &Solid, answer: Option<&Cut>, canvas: &mut Canvas) -> std::io::Result<()> {
        let face = |face: &[u32]| face.iter().map(|&v| Vertex::input(v as usize)).collect::<Vec<Vertex>>();
        let given = content.faces.iter().map(face);
        let Some(answer) = answer else {
            canvas.faces(scene, "faces", Role::Given, given)?;
            canvas.faces(scene, "points of planes", Role::Mark, &content.planes)?;
            return Ok(());
        };
        let parts = &answer.sliced.parts;
        let placed = Placed::new(scene, &answer.sliced.constructions, answer.before, answer.rounded.as_deref())?;
        let place = |v| placed.place(v);
        for (at, part) in parts.iter().enumerate() {
            let role = [Role::Found, Role::Second, Role::Given, Role::Mark][at % 4];
            let faces = part.triangles.iter().map(|triangle| triangle.map(place));
            canvas.faces(&placed.meshes, &format!("part {at}"), role, faces)?;
        }
        let open =
            parts.iter().flat_map(|part| &part.open).map(|around| around.iter().map(|&v| place(v)).collect::<Vec<_>>());
        canvas.lines(&placed.meshes, "open loops", Role::Mark, open)?;
        canvas.faces(scene, "given faces", Role::Faint, given)?.hide();
        Ok(())
    }
}

fn name(source: Source) -> String {
    match source {
        Source::Face(face) => format!("face {face}"),
        Source::Cap(plane) => format!("cap {plane}"),
        Source::Cover => "cover".to_owned(),
    }
}

fn told(sliced: &Sliced) -> String {
    let triangles: usize = sliced.parts.iter().map(|part| part.triangles.len()).sum();
    let parts = format!("{} parts of {triangles} triangles", sliced.parts.len());
    match sliced.broken {
        None => parts,
        Some((broken, _)) => format!("{parts}; broken: {broken}"),
    }
}
