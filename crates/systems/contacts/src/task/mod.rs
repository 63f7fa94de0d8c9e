//! `contacts2d`, `contacts3d`: the pairs of simplices of two complexes that meet.
//!
//! The hierarchy of Wang, Jiang, Schroeder and Teran, driven by any backend: the most degenerate pairs come first, and
//! a pair is not queried once a pair of its faces is registered.

mod band;
mod checks;
mod classes;
pub(crate) mod content;
mod generate;
mod judge;
mod order;
mod pairs;
mod replies;
mod section;
mod sigma;
mod spoiled;
mod timed;
mod topology;

use crate::algorithm::pairs::{Contact, Contacts as Registered, Weights, contacts};
use crate::truth::{Pair, Truth};
use predicament_corpus::{Context, Family, InDecimals, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_judge::Judged;
use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Declined, Dimension, PredicateKind, Predicates, Query, Scene, Vertex};
use predicament_records::{RunDir, TableSpec};
use predicament_report::Section;
use predicament_report::drawing::{Role, Shape};
use std::collections::BTreeMap;

pub use content::Complexes;
pub use generate::thresholds;
pub use section::ContactRow;

use pairs::closure;
use predicament_tasks::output::{self, Canvas, Each, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::{
    Agreement, Answer, Asked, Case, Check, Compared, Contestant, ExplainError, Explanation, Halt, How, Knob, Outcome,
    Spoiled, Stop, Task, Turns, Watch, digest,
};

/// The task, in the plane or in space.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Contacts {
    dimension: Dimension,
}

impl Contacts {
    /// The task `contacts2d`: two complexes in the plane.
    pub const IN_PLANE: Contacts = Contacts { dimension: Dimension::Two };
    /// The task `contacts3d`: two complexes in space.
    pub const IN_SPACE: Contacts = Contacts { dimension: Dimension::Three };
}

impl Answer for Registered {
    fn digest(&self) -> u64 {
        let simplex = |simplex: Simplex| [u32::from(simplex.rank), simplex.index];
        let pairs = self.registered.iter().flat_map(|contact| [contact.a, contact.b]);
        digest(pairs.flat_map(simplex).flat_map(u32::to_le_bytes))
    }
}

impl SceneFormat for Contacts {
    fn name(&self) -> &'static str {
        match self.dimension {
            Dimension::Two => "contacts2d",
            Dimension::Three => "contacts3d",
        }
    }

    fn template(&self) -> String {
        match self.dimension {
            Dimension::Two => include_str!("template2d.txt").to_owned(),
            Dimension::Three => include_str!("template3d.txt").to_owned(),
        }
    }

    fn about(&self) -> &'static str {
        match self.dimension {
            Dimension::Two => "the contacts between two complexes in the plane (Wang et al.)",
            Dimension::Three => "the contacts between two complexes in space (Wang et al.)",
        }
    }

    fn in_decimals(&self) -> InDecimals {
        InDecimals::Integers
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "a", "b"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points", "a", "b", "polygons"]
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["a", "b"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        content::Written::read(context, fields, self.dimension)?.source()
    }

    fn sample_keys(&self) -> &'static [&'static str] {
        &["shift = 1"]
    }

    fn families(&self) -> &'static [Family] {
        match self.dimension {
            Dimension::Two => &generate::PLANE,
            Dimension::Three => &generate::SPACE,
        }
    }
}

impl Task for Contacts {
    type Content = Complexes;
    type Truth = Truth;
    type Answer = Registered;

    fn has_two_meshes(&self) -> bool {
        true
    }

    // Coordinates are singles, so that single-precision backends accept them.
    fn compared(&self) -> &'static [Compared] {
        match self.dimension {
            Dimension::Two => {
                const {
                    &[
                        Compared::general("polygons-uniform", 120).with("bits = 24"),
                        Compared::near("polygons-near", 120),
                        Compared::degenerate("polygons-degen", 120),
                    ]
                }
            }
            Dimension::Three => {
                const {
                    &[
                        Compared::general("surfaces-uniform", 160).with("bits = 24"),
                        Compared::near("surfaces-shifted", 160).with("shift = 1.0"),
                        Compared::degenerate("surfaces-degen", 160),
                    ]
                }
            }
        }
    }

    fn turns(&self, _: Knob) -> Turns {
        Turns::Everywhere
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d, PredicateKind::Orient3d]
    }

    fn supported(&self, session: &dyn Predicates) -> Result<(), Declined> {
        session.supports_contacts()
    }

    fn takes_threads(&self) -> bool {
        true
    }

    fn primitives(&self, scene: &Scene, content: &Complexes) -> Option<u64> {
        Some(timed::primitives(scene, content))
    }

    /// A table of both dimensions.
    fn timed(
        &self,
        run: &RunDir,
        primitives: &BTreeMap<String, u64>,
        threads: &[usize],
    ) -> Result<String, predicament_records::Error> {
        match self.dimension {
            Dimension::Two => timed::tables(run, primitives, threads),
            Dimension::Three => Ok(String::new()),
        }
    }

    fn truth(&self, scene: &Scene, content: &Complexes, watch: &Watch) -> Result<Truth, Stop> {
        Truth::new(scene, content, watch)
    }

    fn sampled(&self, truth: &Truth) -> Option<String> {
        truth.sampled()
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Complexes,
        how: &How<'_>,
        answer: &mut Registered,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        *answer = contacts(&*session, &content.a, &content.b);
        how.watch.done((content.a.len() + content.b.len()) as u64)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Contacts>,
        asked: &Asked<'_>,
        answer: &Registered,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, answer, outcome)
    }

    fn agreement(
        &self,
        case: &Case<'_, Contacts>,
        written: &Case<'_, Contacts>,
        _: &Asked<'_>,
        answer: &Registered,
        _: &Outcome,
    ) -> Result<Agreement, Stop> {
        Ok(judge::agreement([&case.truth, &written.truth], answer))
    }

    fn checks(&self) -> &'static [Check] {
        checks::checks(self.dimension)
    }

    fn spoiled(&self) -> Vec<Spoiled<Contacts>> {
        spoiled::all(*self)
    }

    fn replies(&self) -> Option<&'static dyn Replies<Contacts>> {
        Some(match self.dimension {
            Dimension::Two => &replies::IN_PLANE,
            Dimension::Three => &replies::IN_SPACE,
        })
    }

    fn describe(&self, _: &LoadedScene, content: &Complexes, _: &Watch) -> Result<String, Stop> {
        let line = |name: &str, complex: &Complex| {
            let [vertices, edges] = [complex.vertices().len(), complex.edges().len()];
            let [triangles, tetrahedra] = [complex.triangles().len(), complex.tetrahedra().len()];
            format!("{name}: {vertices} vertices, {edges} edges, {triangles} triangles, {tetrahedra} tetrahedra\n")
        };
        Ok(line("a", &content.a) + &line("b", &content.b))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Complexes,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let [s, t] = query.args.as_slice() else {
            return Err(ExplainError::not_of_task(query, "is not a pair of simplices"));
        };
        let both = content.a.find(s).zip(content.b.find(t));
        let missing = || ExplainError::not_in_scene(query, "the complexes have no such pair of simplices");
        let pair = both.map(|(s, t)| [s, t]).ok_or_else(missing)?;
        let truth = tell(scene, content, pair, &alone(scene, content, &Judged::again(scene), pair));
        let ask = |backend: &dyn Contestant| {
            let mut told = Err(Declined::scene("the backend asked for no session"));
            let prepared = backend.with_session(scene, &mut |session| {
                told = session
                    .supports_contacts()
                    .map(|()| tell(scene, content, pair, &alone(scene, content, session, pair)));
            });
            prepared.and(told)
        };
        let about = Explanation { vertices: query.vertices().collect(), truth: vec![truth], ..Explanation::default() };
        Ok(about.with_answers(backends, ask))
    }

    /// Offers a JSON file of all registered pairs with their weights, and an OBJ file of both complexes.
    fn write(
        &self,
        scene: &Scene,
        content: &Complexes,
        answer: &Registered,
        files: &mut Files,
    ) -> Result<(), output::Error> {
        files.json("contacts.json", || {
            let ids = |vertices: &[Vertex]| vertices.iter().map(ToString::to_string).collect::<Vec<_>>();
            let pair = move |contact: &Contact| {
                let [s, t] = vertices_of(content, [contact.a, contact.b]);
                serde_json::json!({
                    "a": ids(s),
                    "b": ids(t),
                    "on_a": &contact.on_a[..s.len()],
                    "on_b": &contact.on_b[..t.len()],
                })
            };
            Each(move || answer.registered.iter().map(pair))
        })?;
        files.write("complexes.obj", |out| out.write_all(object_file(scene, content).as_bytes()))
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &Complexes,
        answer: Option<&Registered>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        for (name, role, complex) in [("first", Role::Given, &content.a), ("second", Role::Second, &content.b)] {
            canvas.faces(scene, &format!("{name}: triangles"), role, complex.triangles())?;
            canvas.lines(scene, &format!("{name}: edges"), role, complex.edges())?;
        }
        let Some(answer) = answer else { return Ok(()) };
        // The position of a contact on the simplex of the first complex.
        let place = |contact: &Contact| {
            let [s, _] = vertices_of(content, [contact.a, contact.b]);
            vec![vec![weighted(scene, s, &contact.on_a)]]
        };
        canvas.places("contacts", Role::Mark, Shape::Points, answer.registered.iter().map(place));
        Ok(())
    }

    fn tables(&self) -> Vec<TableSpec> {
        vec![TableSpec::of::<ContactRow>()]
    }

    fn section(&self, runs: &[RunDir]) -> Result<Option<Section>, predicament_records::Error> {
        section::section(runs)
    }
}

/// Both complexes as an OBJ file: coordinates as the shortest decimals that read back as the same doubles.
fn object_file(scene: &Scene, content: &Complexes) -> String {
    let mut text = String::new();
    for vertex in scene.vertices() {
        let point = scene.point(vertex);
        let z = point.get(2).copied().unwrap_or(0.0);
        text += &format!("v {:?} {:?} {z:?}\n", point[0], point[1]);
    }
    for (name, complex) in [("a", &content.a), ("b", &content.b)] {
        text += &format!("o {name}\n");
        let line = |kind: &str, simplex: &[Vertex]| {
            let ids: Vec<String> = simplex.iter().map(|v| (v.index() + 1).to_string()).collect();
            format!("{kind} {}\n", ids.join(" "))
        };
        text.extend(complex.edges().iter().map(|edge| line("l", edge)));
        text.extend(complex.triangles().iter().map(|triangle| line("f", triangle)));
    }
    text
}

/// A point of a simplex by its weights, in doubles: accurate enough for a picture.
fn weighted(scene: &Scene, simplex: &[Vertex], weights: &Weights) -> [f64; 3] {
    let mut place = [0.0; 3];
    for (&v, weight) in simplex.iter().zip(weights) {
        scene.point(v).iter().zip(&mut place).for_each(|(x, at)| *at += weight * x);
    }
    place
}

fn vertices_of(content: &Complexes, [s, t]: Pair) -> [&[Vertex]; 2] {
    [content.a.vertices_of(s), content.b.vertices_of(t)]
}

/// The query of a pair: `contacts2d(0 1, 4 5)`.
fn query(scene: &Scene, content: &Complexes, pair: Pair) -> Query {
    let args = vertices_of(content, pair).map(<[Vertex]>::to_vec).to_vec();
    Query { what: format!("contacts{}d", scene.dimension().count()), detail: None, args }
}

/// The contacts of one pair's faces, as separate complexes.
fn alone<S: Predicates + ?Sized>(scene: &Scene, content: &Complexes, session: &S, pair: Pair) -> Registered {
    let [s, t] = vertices_of(content, pair).map(|vertices| closure(scene, vertices));
    let mut found = contacts(session, &s, &t);
    // From indices in the two closures to indices in the complexes.
    let [a, b] = content.both();
    let find = |all: &Complex, one: &Complex, simplex: Simplex| all.find(one.vertices_of(simplex));
    found.registered.retain_mut(|contact| {
        let places = find(a, &s, contact.a).zip(find(b, &t, contact.b));
        places.map(|(a, b)| (contact.a, contact.b) = (a, b)).is_some()
    });
    found
}

/// The registered pairs of a pair and its faces, with the weights, in words.
fn tell(scene: &Scene, content: &Complexes, pair: Pair, contacts: &Registered) -> String {
    if contacts.registered.is_empty() {
        return "apart".to_owned();
    }
    let one = |contact: &Contact| {
        let this = [contact.a, contact.b];
        let [s, t] = vertices_of(content, this).map(<[Vertex]>::len);
        let weights = |of: Weights, n: usize| of[..n].iter().map(|w| format!("{w}")).collect::<Vec<_>>().join(" ");
        let at = format!("at {}; {}", weights(contact.on_a, s), weights(contact.on_b, t));
        let what =
            if this == pair { "registered".to_owned() } else { format!("ended by {}", query(scene, content, this)) };
        format!("{what} {at}")
    };
    contacts.registered.iter().map(one).collect::<Vec<_>>().join(", ")
}
