//! The session of an engine that is prepared for a scene.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use predicament_predicates::{
    Axis, Broken, Class, Declined, Derived, Dimension, Plane, PredicateKind, Predicates, Question, Scene, Sign, Tally,
    Vertex, answer_by,
};

use crate::command::printable;
use crate::process::Process;
use crate::started::Shared;
use crate::{Bound, Message, ProtocolError};

/// The byte for the sign −1.
const NEGATIVE: u8 = 255;
/// The byte for the sign 0.
const ZERO: u8 = 0;
/// The byte for the sign +1.
const POSITIVE: u8 = 1;
/// The byte for a declined query.
const DECLINED: u8 = 2;
/// The byte for an answer that is NaN.
const NAN: u8 = 3;
/// The tolerance for an engine's clock that is ahead of the tool's.
pub(crate) const CLOCKS: Duration = Duration::from_millis(10);

/// A counter of queries for any tally type: algorithms are compiled for one session type.
trait Counted: Send + Sync {
    fn settled(&self, kind: PredicateKind, count: u64);
}

impl<T: Tally> Counted for T {
    fn settled(&self, kind: PredicateKind, count: u64) {
        self.settled_many(kind, 0, count);
    }
}

/// An engine prepared for one scene. The scene is sent again if another session has sent its scene since.
pub struct Session<'s> {
    shared: Arc<Shared>,
    scene: &'s Scene,
    /// The message `scene`, and a hash of it.
    message: Message,
    number: u64,
    empty: bool,
    tally: Box<dyn Counted + 's>,
    /// The queries whose answer was NaN.
    nans: Mutex<HashSet<(Question, Vec<Vertex>)>>,
}

impl<'s> Session<'s> {
    pub(crate) fn prepare<T: Tally + 's>(
        shared: Arc<Shared>,
        empty: bool,
        scene: &'s Scene,
        tally: T,
    ) -> Result<Session<'s>, Declined> {
        if shared.hello.predicates.is_empty() {
            return Err(Declined::scene("the engine answers whole tasks, not predicates"));
        }
        if !scene.constructions().is_empty() {
            return Err(Declined::scene("the protocol has no constructed vertices"));
        }
        // The check is whether each coordinate survives the conversion.
        #[allow(clippy::cast_possible_truncation)]
        let single = |x: &f64| f64::from(*x as f32) == *x;
        if shared.hello.single && !scene.coordinates().iter().all(single) {
            return Err(Declined::scene("coordinates that are not singles"));
        }
        let points: Vec<u8> = scene.coordinates().iter().flat_map(|x| x.to_le_bytes()).collect();
        let dimension = match scene.dimension() {
            Dimension::Two => "2",
            Dimension::Three => "3",
        };
        let mut message = Message::new("scene").with("dimension", dimension).with("points", points);
        if !scene.weights().is_empty() {
            let weights: Vec<u8> = scene.weights().iter().flat_map(|x| x.to_le_bytes()).collect();
            message = message.with("weights", weights);
        }
        let mut hasher = DefaultHasher::new();
        message.hash(&mut hasher);
        let number = hasher.finish();
        let session = Session { scene, message, number, empty, tally: Box::new(tally), nans: Mutex::default(), shared };
        match session.ask(|_| Ok(())) {
            Ok(Ok(())) => Ok(session),
            Ok(Err(declined)) => Err(Declined::scene(printable(&declined.reason))),
            Err(broken) => broken.throw(),
        }
    }

    /// Runs a question on a process that has the scene.
    fn ask<R>(&self, ask: impl FnOnce(&mut Process) -> Result<R, Broken>) -> Result<Result<R, Declined>, Broken> {
        self.shared.processes.ask((Some(&self.message), self.number), || self.shared.start(), ask)
    }

    /// The answers to queries, given by the ids of all their vertices; `shown` describes a query in words.
    fn signs(&self, question: Question, ids: &[u8], queries: usize, shown: &dyn Fn(usize) -> String) -> Vec<u8> {
        let kind = question.kind();
        let mut batch = Message::new("batch").with("predicate", kind.name());
        match question {
            Question::Compare(axis) => batch = batch.with("axis", axis.name()),
            Question::Orient2d(plane) => batch = batch.with("plane", plane.name()),
            Question::Orient3d | Question::Incircle | Question::Insphere | Question::Derived(_) => {}
        }
        if self.empty {
            batch = batch.with("empty", "1");
        }
        let batch = batch.with("ids", ids);
        let asked = self.ask(|process| {
            let start = Instant::now();
            let answer = process.ask_batch(&batch, Bound::answer(queries))?;
            let read = read_signs(&answer, queries, start.elapsed(), shown);
            read.map_err(|error| process.broken(Class::Panic, "protocol", error.to_string()))
        });
        let answered = match asked {
            Ok(Ok(answered)) => answered,
            Ok(Err(scene_declined)) => {
                Broken { class: Class::Declined, check: "prepare", message: scene_declined.reason }.throw()
            }
            Err(broken) => broken.throw(),
        };
        match answered {
            Ok((signs, nanoseconds)) => {
                self.shared.spent(nanoseconds);
                self.shared.processes.works();
                self.tally.settled(kind, queries as u64);
                signs
            }
            Err(reason) => {
                Broken { class: Class::Declined, check: "batch", message: printable(&reason.reason) }.throw()
            }
        }
    }

    fn batch<const N: usize>(&self, question: Question, queries: &[[Vertex; N]], out: &mut [Sign]) {
        self.flat_batch(question, queries.as_flattened(), out);
    }

    /// Answers queries whose vertices follow one another.
    fn flat_batch(&self, question: Question, vertices: &[Vertex], out: &mut [Sign]) {
        if vertices.is_empty() {
            return;
        }
        let queries: Vec<&[Vertex]> = vertices.chunks_exact(question.kind().arity()).collect();
        // Vertices of a scene have ids below 2^31.
        let id = |v: &Vertex| u32::try_from(v.index()).expect("ids of input vertices").to_le_bytes();
        let ids: Vec<u8> = vertices.iter().flat_map(id).collect();
        let signs = self.signs(question, &ids, queries.len(), &|at| question.query(queries[at]).to_string());
        for ((query, &byte), out) in queries.iter().zip(&signs).zip(out) {
            *out = match byte {
                NEGATIVE => Sign::Negative,
                POSITIVE => Sign::Positive,
                NAN => {
                    let mut nans = self.nans.lock().unwrap_or_else(PoisonError::into_inner);
                    nans.insert((question, query.to_vec()));
                    Sign::Zero
                }
                DECLINED => {
                    let count = signs.iter().filter(|&&byte| byte == DECLINED).count();
                    let message = format!("{count} queries of a batch, the first {}", question.query(query));
                    Broken { class: Class::Declined, check: "query", message }.throw()
                }
                _ => Sign::Zero,
            };
        }
    }

    fn one<const N: usize>(&self, question: Question, query: [Vertex; N]) -> Sign {
        let mut out = [Sign::Zero];
        self.batch(question, &[query], &mut out);
        out[0]
    }
}

/// The signs and the nanoseconds of an answer to `queries` queries, or the reason why the engine declines them.
///
/// A break of the protocol is an error. An engine cannot spend more time on an answer than the tool waited.
fn read_signs(
    answer: &Message,
    queries: usize,
    waited: Duration,
    shown: &dyn Fn(usize) -> String,
) -> Result<Result<(Vec<u8>, u64), Declined>, ProtocolError> {
    match answer.kind().as_str() {
        "declined" => return Ok(Err(Declined::scene(answer.required("reason")?))),
        "signs" => {}
        other => return Err(ProtocolError::BatchAnsweredBy(other.to_owned())),
    }
    let missing = || ProtocolError::Missing { message: "signs".to_owned(), key: "signs".to_owned() };
    let signs = answer.bytes("signs").ok_or_else(missing)?;
    if signs.len() != queries {
        return Err(ProtocolError::Signs { came: signs.len(), queries });
    }
    let known = [NEGATIVE, ZERO, POSITIVE, DECLINED, NAN];
    if let Some(at) = signs.iter().position(|byte| !known.contains(byte)) {
        return Err(ProtocolError::NotASign { query: shown(at), byte: signs[at] });
    }
    let nanoseconds = answer.number("ns")?;
    if Duration::from_nanos(nanoseconds) > 2 * waited + CLOCKS {
        return Err(ProtocolError::Time { said: nanoseconds, took: waited });
    }
    Ok(Ok((signs.to_vec(), nanoseconds)))
}

impl Predicates for Session<'_> {
    fn scene(&self) -> &Scene {
        self.scene
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        self.scene.has_dimension_for(kind)?;
        if self.shared.hello.predicates.contains(&kind) {
            Ok(())
        } else {
            Err(Declined::predicate(kind, "the engine does not offer it"))
        }
    }

    answer_by!(one);

    fn sign(&self, predicate: Derived, vertices: &[Vertex]) -> Sign {
        let mut out = [Sign::Zero];
        self.flat_batch(Question::Derived(predicate), vertices, &mut out);
        out[0]
    }

    fn sign_batch(&self, predicate: Derived, vertices: &[Vertex], out: &mut [Sign]) {
        self.flat_batch(Question::Derived(predicate), vertices, out);
    }

    /// Returns NaN if the engine's answer to this query was NaN.
    fn estimate(&self, question: Question, args: &[Vertex]) -> Option<f64> {
        let nans = self.nans.lock().unwrap_or_else(PoisonError::into_inner);
        (!nans.is_empty() && nans.contains(&(question, args.to_vec()))).then_some(f64::NAN)
    }

    /// The engine's own time for all batches so far.
    fn own_nanoseconds(&self) -> Option<u64> {
        Some(self.shared.nanoseconds())
    }

    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        self.batch(Question::Compare(axis), queries, out);
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        self.batch(Question::Orient2d(plane), queries, out);
    }

    fn orient2d_line(&self, plane: Plane, [a, b]: [Vertex; 2], points: &[Vertex], out: &mut [Sign]) {
        let queries: Vec<[Vertex; 3]> = points.iter().map(|&c| [a, b, c]).collect();
        self.batch(Question::Orient2d(plane), &queries, out);
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        self.batch(Question::Orient3d, queries, out);
    }

    fn orient3d_plane(&self, [a, b, c]: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) {
        let queries: Vec<[Vertex; 4]> = points.iter().map(|&d| [a, b, c, d]).collect();
        self.batch(Question::Orient3d, &queries, out);
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        self.batch(Question::Incircle, queries, out);
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        self.batch(Question::Insphere, queries, out);
    }
}
