//! The server: stores the scene, answers messages, and times batches.

use std::hint::black_box;
use std::io::{Read, Write};
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::message::{Message, Reply};
use super::stdout::own_stdout;
use super::{Answer, Engine, Points, Precision, Predicate, Vertex, Zero};

/// The byte of a query not yet answered; it is not a byte of the protocol.
const NOT_ASKED: u8 = 128;

/// Runs an engine with these arguments.
pub fn main<E: Engine>(args: Vec<String>) -> Result<(), String> {
    match args.as_slice() {
        [] => {}
        [only] if only == "--version" => {
            println!("{}", E::version());
            return Ok(());
        }
        _ => return Err("usage: --version, or nothing: an engine on stdin and stdout".to_owned()),
    }
    let mut output = own_stdout()?;
    let hook = take_hook();
    set_hook(Box::new(move |info| {
        if !IN_LIBRARY.load(Ordering::Relaxed) {
            hook(info);
        }
    }));
    serve::<E>(std::io::stdin().lock(), &mut output).map_err(|why| format!("engine: {why}"))
}

/// Answers messages until the input ends.
fn serve<E: Engine>(mut input: impl Read, output: &mut impl Write) -> Result<(), String> {
    let mut server = Server::<E>::default();
    while let Some(message) = Message::read(&mut input)? {
        let reply = match server.answer(&message) {
            Ok(reply) => reply,
            Err(Refused::Declined(reason)) => Reply::new("declined").with("reason", reason),
            Err(Refused::Failed(what)) => Reply::new("error").with("message", what),
            Err(Refused::Malformed(what)) => return Err(what),
        };
        let reply = match message.bytes("id") {
            Some(id) => reply.with("id", id),
            None => reply,
        };
        reply.send(output)?;
    }
    Ok(())
}

/// The reason why a message gets no answer.
#[derive(PartialEq, Eq, Debug)]
pub(super) enum Refused {
    /// The scene or the predicate is not for this engine.
    Declined(String),
    /// The library failed.
    Failed(String),
    /// The message is not one of the protocol. The program ends.
    Malformed(String),
}

impl From<String> for Refused {
    fn from(what: String) -> Refused {
        Refused::Malformed(what)
    }
}

/// The points that predicates receive: those of the scene, or their projection to a plane, given by its axes.
type View = Option<[usize; 2]>;

/// An engine and its scene.
#[derive(Default)]
struct Server<E> {
    engine: E,
    dimension: usize,
    plane: Vec<[f64; 2]>,
    space: Vec<[f64; 3]>,
    projected: Vec<[f64; 2]>,
    /// The points that the engine has prepared; `None` at first.
    prepared: Option<View>,
}

impl<E: Engine> Server<E> {
    fn answer(&mut self, message: &Message) -> Result<Reply, Refused> {
        match message.kind().as_str() {
            "hello" => hello::<E>(message),
            "scene" => self.scene(message),
            "batch" => self.batch(message),
            "task" => super::tasks::answer(&self.engine, message),
            other => Err(Refused::Failed(format!("unknown message `{other}`"))),
        }
    }

    fn scene(&mut self, message: &Message) -> Result<Reply, Refused> {
        let points = message.need("points")?;
        self.dimension = match message.need("dimension")? {
            b"2" => 2,
            b"3" => 3,
            other => {
                let other = String::from_utf8_lossy(other);
                return Err(Refused::Malformed(format!("dimension `{other}` is neither 2 nor 3")));
            }
        };
        if points.len() % (8 * self.dimension) != 0 {
            return Err(Refused::Malformed(format!("points of {} bytes are no whole points", points.len())));
        }
        let coordinates: Vec<f64> = points.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
        (self.plane, self.space, self.prepared) = (Vec::new(), Vec::new(), None);
        if self.dimension == 2 {
            self.plane = coordinates.as_chunks().0.to_vec();
        } else {
            self.space = coordinates.as_chunks().0.to_vec();
        }
        let start = Instant::now();
        self.look(None)?;
        Ok(Reply::new("ready").with("ns", start.elapsed().as_nanos().to_string()))
    }

    /// Prepares the engine for these points.
    fn look(&mut self, view: View) -> Result<(), Refused> {
        if self.prepared == Some(view) {
            return Ok(());
        }
        self.prepared = None;
        if let Some([u, v]) = view {
            self.projected = self.space.iter().map(|point| [point[u], point[v]]).collect();
        }
        let points = match (view, self.dimension) {
            (Some(_), _) => Points::Plane(&self.projected),
            (None, 2) => Points::Plane(&self.plane),
            (None, _) => Points::Space(&self.space),
        };
        let prepared = caught(|| self.engine.prepare(points));
        let prepared = prepared.map_err(|panic| Refused::Failed(format!("prepare panicked: {panic}")))?;
        prepared.map_err(Refused::Declined)?;
        self.prepared = Some(view);
        Ok(())
    }

    fn batch(&mut self, message: &Message) -> Result<Reply, Refused> {
        let name = String::from_utf8_lossy(message.need("predicate")?).into_owned();
        if self.dimension == 0 {
            return Err(Refused::Malformed("a batch before any scene".to_owned()));
        }
        let predicate = E::PREDICATES.iter().copied().find(|predicate| predicate.name() == name);
        let predicate = predicate.ok_or_else(|| Refused::Declined(format!("this engine has no `{name}`")))?;
        let batch = Batch { message, name, empty: message.bytes("empty") == Some(b"1") };
        match predicate {
            Predicate::Compare => self.compare(&batch),
            Predicate::Orient2d => self.orient2d(&batch),
            Predicate::Orient3d => {
                self.has(3, &batch)?;
                batch.ask(&self.space, |points| self.engine.orient3d(points))
            }
            Predicate::Incircle => {
                self.has(2, &batch)?;
                batch.ask(&self.plane, |points| self.engine.incircle(points))
            }
            Predicate::Insphere => {
                self.has(3, &batch)?;
                batch.ask(&self.space, |points| self.engine.insphere(points))
            }
            Predicate::OrientOnSphere => {
                self.has(3, &batch)?;
                batch.ask(&self.space, |points| self.engine.orient_on_sphere(points))
            }
        }
    }

    /// Declines a predicate for points of another dimension.
    fn has(&mut self, dimension: usize, batch: &Batch) -> Result<(), Refused> {
        if self.dimension != dimension {
            return Err(Refused::Declined(format!("{} is about points of dimension {dimension}", batch.name)));
        }
        self.look(None)
    }

    fn compare(&mut self, batch: &Batch) -> Result<Reply, Refused> {
        let axis = batch.one_of("axis", &["x", "y", "z"][..self.dimension], None)?;
        self.look(None)?;
        if self.dimension == 2 {
            batch.ask(&self.plane, |points| self.engine.compare(axis, points.map(|point| along(axis, point))))
        } else {
            batch.ask(&self.space, |points| self.engine.compare(axis, points.map(|point| along(axis, point))))
        }
    }

    fn orient2d(&mut self, batch: &Batch) -> Result<Reply, Refused> {
        let planes = if self.dimension == 2 { &["xy"][..] } else { &["xy", "yz", "zx"] };
        let plane = batch.one_of("plane", planes, Some("xy"))?;
        if self.dimension == 2 {
            self.look(None)?;
            return batch.ask(&self.plane, |points| self.engine.orient2d(points));
        }
        let is_turned = E::IN_ORDER && plane == 2;
        self.look(Some(if is_turned { [0, 2] } else { [[0, 1], [1, 2], [2, 0]][plane] }))?;
        if is_turned {
            batch.ask(&self.projected, |points| -self.engine.orient2d(points))
        } else {
            batch.ask(&self.projected, |points| self.engine.orient2d(points))
        }
    }
}

fn hello<E: Engine>(message: &Message) -> Result<Reply, Refused> {
    let protocol = String::from_utf8_lossy(message.need("protocol")?);
    if protocol != "1" {
        return Err(Refused::Declined(format!("this engine speaks protocol 1, not {protocol}")));
    }
    let predicates: Vec<&str> = E::PREDICATES.iter().map(|predicate| predicate.name()).collect();
    let tasks: Vec<&str> = E::TASKS.iter().map(|task| task.name()).collect();
    let zero = match E::ZERO {
        Zero::Exact => "exact",
        Zero::Never => "never",
    };
    let precision = match E::PRECISION {
        Precision::F64 => "f64",
        Precision::F32 => "f32",
    };
    let about = Reply::new("hello").with("protocol", "1").with("name", E::NAME).with("version", E::version());
    let about = about.with("predicates", predicates.join(" ")).with("tasks", tasks.join(" "));
    Ok(about.with("zero", zero).with("precision", precision))
}

fn along<const D: usize>(axis: usize, point: Vertex<D>) -> Vertex<1> {
    Vertex { at: [point.at[axis]], id: point.id }
}

/// A batch of queries of one predicate.
struct Batch<'m> {
    message: &'m Message,
    name: String,
    /// True if the batch is for a predicate that returns at once.
    empty: bool,
}

impl Batch<'_> {
    /// The index among `names` of a key's value.
    fn one_of(&self, key: &str, names: &[&str], default: Option<&str>) -> Result<usize, Refused> {
        let given = self.message.text(key).or(default.map(str::to_owned));
        let given = given.ok_or_else(|| format!("a message `batch` without `{key}`"))?;
        let found = names.iter().position(|name| *name == given);
        found.ok_or_else(|| Refused::Malformed(format!("`{given}` is no {key} of the scene")))
    }

    /// Answers all queries, with one byte each, and measures the time.
    fn ask<const D: usize, const N: usize>(
        &self,
        points: &[[f64; D]],
        predicate: impl Fn([Vertex<D>; N]) -> Answer,
    ) -> Result<Reply, Refused> {
        let bytes = self.message.need("ids")?;
        if bytes.len() % (4 * N) != 0 {
            let what = format!("ids of {} bytes are no whole queries of {}", bytes.len(), self.name);
            return Err(Refused::Malformed(what));
        }
        let ids: Vec<u32> = bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect();
        if let Some(id) = ids.iter().find(|&&id| id as usize >= points.len()) {
            return Err(Refused::Malformed(format!("vertex {id} of a scene of {}", points.len())));
        }
        let queries = ids.as_chunks().0;
        if self.empty {
            // `black_box` hides the result from the compiler and makes it build the arguments.
            let empty = |points: [Vertex<D>; N]| {
                black_box(points);
                black_box(Answer::Zero)
            };
            return self.each(points, queries, empty);
        }
        self.each(points, queries, predicate)
    }

    /// Calls `predicate` for each query and stores a byte for each. Only this loop is timed.
    fn each<const D: usize, const N: usize>(
        &self,
        points: &[[f64; D]],
        queries: &[[u32; N]],
        predicate: impl Fn([Vertex<D>; N]) -> Answer,
    ) -> Result<Reply, Refused> {
        let mut signs = vec![NOT_ASKED; queries.len()];
        let start = Instant::now();
        let asked = caught(|| {
            for (query, sign) in queries.iter().zip(&mut signs) {
                *sign = predicate(query.map(|id| Vertex { at: points[id as usize], id })) as u8;
            }
        });
        let ns = start.elapsed().as_nanos().to_string();
        match asked {
            Ok(()) => Ok(Reply::new("signs").with("ns", ns).with("signs", signs)),
            Err(panic) => {
                let at = signs.iter().position(|&sign| sign == NOT_ASKED).unwrap_or_default();
                let ids: Vec<String> = queries[at].iter().map(u32::to_string).collect();
                Err(Refused::Failed(format!("{}({}) panicked: {panic}", self.name, ids.join(" "))))
            }
        }
    }
}

/// True during a call of the library: its panics are reported to the tool, not to stderr with this machine's paths.
static IN_LIBRARY: AtomicBool = AtomicBool::new(false);

/// The result of the library's work, or the text of its panic.
pub(super) fn caught<R>(work: impl FnOnce() -> R) -> Result<R, String> {
    IN_LIBRARY.store(true, Ordering::Relaxed);
    let done = catch_unwind(AssertUnwindSafe(work));
    IN_LIBRARY.store(false, Ordering::Relaxed);
    done.map_err(|panic| {
        let text = panic.downcast_ref::<&str>().copied();
        text.or_else(|| panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("no message").to_owned()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Turns by doubles, with a query for each way to fail.
    #[derive(Default)]
    struct Turns {
        prepared: usize,
    }

    impl Engine for Turns {
        const NAME: &'static str = "turns";
        const ZERO: Zero = Zero::Exact;
        const PREDICATES: &'static [Predicate] =
            &[Predicate::Compare, Predicate::Orient2d, Predicate::Incircle, Predicate::OrientOnSphere];
        const IN_ORDER: bool = true;

        fn version() -> String {
            "1.0".to_owned()
        }

        fn prepare(&mut self, points: Points<'_>) -> Result<(), String> {
            self.prepared = match points {
                Points::Plane(points) => points.len(),
                Points::Space(points) => points.len(),
            };
            assert!(self.prepared < 8, "few points");
            if self.prepared == 7 { Err("seven".to_owned()) } else { Ok(()) }
        }

        fn compare(&self, axis: usize, [a, b]: [Vertex<1>; 2]) -> Answer {
            assert!(axis < 3 && self.prepared > 0);
            (a.at[0] - b.at[0]).into()
        }

        fn orient_on_sphere(&self, [a, b, c]: [Vertex<3>; 3]) -> Answer {
            let [u, v] = [b, c].map(|vertex| vertex.at);
            let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            a.at.iter().zip(cross).map(|(x, y)| x * y).sum::<f64>().into()
        }

        fn orient2d(&self, [a, b, c]: [Vertex<2>; 3]) -> Answer {
            match (a.id, b.id, c.id) {
                (0, 0, 0) => panic!("vertex {} thrice", a.id),
                (1, 1, 1) => Answer::Declined,
                (2, 2, 2) => f64::NAN.into(),
                _ => {
                    let [u, v] = [a, b].map(|p| [p.at[0] - c.at[0], p.at[1] - c.at[1]]);
                    (u[0] * v[1] - u[1] * v[0]).into()
                }
            }
        }
    }

    #[test]
    fn directions_are_those_of_a_scene_in_space() {
        let turn = || Reply::new("batch").with("predicate", "orient_on_sphere").with("ids", ids(&[0, 1, 2, 1, 0, 2]));
        let space = Reply::new("scene").with("dimension", "3");
        let space = space.with("points", doubles(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]));
        assert_eq!(last(&[space, turn()]).bytes("signs"), Some(&[1, 255][..]));
        let reason = last(&[plane(), turn()]).text("reason");
        assert_eq!(reason.as_deref(), Some("orient_on_sphere is about points of dimension 3"));
    }

    fn doubles(coordinates: &[f64]) -> Vec<u8> {
        coordinates.iter().flat_map(|x| x.to_le_bytes()).collect()
    }

    fn ids(ids: &[u32]) -> Vec<u8> {
        ids.iter().flat_map(|id| id.to_le_bytes()).collect()
    }

    /// A scene of three points in the plane.
    fn plane() -> Reply {
        Reply::new("scene").with("dimension", "2").with("points", doubles(&[0.0, 0.0, 4.0, 0.0, 1.0, 2.0]))
    }

    fn turns(of: &[u32]) -> Reply {
        Reply::new("batch").with("predicate", "orient2d").with("ids", ids(of))
    }

    /// The answers to these messages, and the server's final result.
    fn asked(questions: &[Reply]) -> (Vec<Message>, Result<(), String>) {
        let (mut input, mut output) = (Vec::new(), Vec::new());
        questions.iter().for_each(|question| question.send(&mut input).unwrap());
        let ended = serve::<Turns>(&*input, &mut output);
        let mut output = &*output;
        let answers = std::iter::from_fn(|| Message::read(&mut output).unwrap());
        (answers.collect(), ended)
    }

    /// The last of the answers.
    fn last(questions: &[Reply]) -> Message {
        let (mut answers, ended) = asked(questions);
        assert_eq!((answers.len(), ended), (questions.len(), Ok(())));
        answers.pop().unwrap()
    }

    #[test]
    fn it_says_what_it_is_and_repeats_numbers() {
        let hello = last(&[Reply::new("hello").with("protocol", "1").with("id", "17")]);
        for (key, value) in [
            ("type", "hello"),
            ("protocol", "1"),
            ("name", "turns"),
            ("version", "1.0"),
            ("predicates", "compare orient2d incircle orient_on_sphere"),
            ("zero", "exact"),
            ("precision", "f64"),
            ("id", "17"),
        ] {
            assert_eq!(hello.text(key).as_deref(), Some(value), "{key}");
        }
        let other = last(&[Reply::new("hello").with("protocol", "2")]);
        assert_eq!(other.text("reason").as_deref(), Some("this engine speaks protocol 1, not 2"));
    }

    #[test]
    fn signs_have_the_bytes_of_the_protocol() {
        let answer = last(&[plane(), turns(&[0, 1, 2, 1, 0, 2, 0, 0, 1, 1, 1, 1, 2, 2, 2])]);
        assert_eq!(answer.bytes("signs"), Some(&[1, 255, 0, 2, 3][..]));
        assert!(answer.text("ns").unwrap().parse::<u64>().is_ok());
        let compare =
            Reply::new("batch").with("predicate", "compare").with("axis", "y").with("ids", ids(&[0, 1, 0, 2]));
        assert_eq!(last(&[plane(), compare]).bytes("signs"), Some(&[0, 255][..]));
        let empty = turns(&[0, 0, 0, 0, 1, 2]).with("empty", "1");
        assert_eq!(last(&[plane(), empty]).bytes("signs"), Some(&[0, 0][..]), "nothing is asked");
    }

    /// Turns in space that are +, − and +; the third is −(x, z), by an engine that wants coordinates in order.
    #[test]
    fn points_in_space_are_projected_and_go_back() {
        let points = [0.0, 0.0, 0.0, 1.0, 0.0, 3.0, 5.0, 1.0, 2.0];
        let scene = || Reply::new("scene").with("dimension", "3").with("points", doubles(&points));
        let about = |plane| last(&[scene(), turns(&[0, 1, 2]).with("plane", plane)]).bytes("signs").unwrap().to_vec();
        assert_eq!([about("xy"), about("yz"), about("zx")].concat(), [1, 255, 1]);
        let again = [scene(), turns(&[0, 1, 2]).with("plane", "zx"), turns(&[0, 1, 2])];
        assert_eq!(last(&again).bytes("signs"), Some(&[1][..]));
    }

    #[test]
    fn a_panic_is_an_error_that_names_the_query() {
        let answer = last(&[plane(), turns(&[0, 1, 2, 0, 0, 0, 1, 0, 2]).with("id", "3")]);
        let told = [answer.kind(), answer.text("message").unwrap(), answer.text("id").unwrap()];
        assert_eq!(told, ["error", "orient2d(0 0 0) panicked: vertex 0 thrice", "3"]);
        let many = Reply::new("scene").with("dimension", "2").with("points", doubles(&[0.0; 16]));
        let answer = last(&[many, plane(), turns(&[0, 1, 2])]);
        assert_eq!(answer.bytes("signs"), Some(&[1][..]), "the next scene is answered");
        let many = Reply::new("scene").with("dimension", "2").with("points", doubles(&[0.0; 16]));
        assert!(last(&[many]).text("message").unwrap().starts_with("prepare panicked: few points"));
    }

    #[test]
    fn what_it_lacks_is_declined() {
        let reason = |questions: &[Reply]| last(questions).text("reason").expect("declined");
        let batch = |predicate| Reply::new("batch").with("predicate", predicate).with("ids", ids(&[0, 1, 2, 0]));
        assert_eq!(reason(&[plane(), batch("orient3d")]), "this engine has no `orient3d`");
        let space = Reply::new("scene").with("dimension", "3").with("points", doubles(&[0.0; 9]));
        assert_eq!(reason(&[space, batch("incircle")]), "incircle is about points of dimension 2");
        let seven = Reply::new("scene").with("dimension", "2").with("points", doubles(&[0.0; 14]));
        assert_eq!(reason(&[seven]), "seven");
        let listed = last(&[plane(), batch("incircle")]);
        assert_eq!(listed.bytes("signs"), Some(&[2][..]), "a predicate that is listed and not written");
        assert_eq!(last(&[Reply::new("what")]).text("message").as_deref(), Some("unknown message `what`"));
    }

    #[test]
    fn what_is_not_the_protocol_ends_it() {
        for (questions, why) in [
            (vec![turns(&[0, 1, 2])], "a batch before any scene"),
            (vec![plane(), turns(&[0, 1])], "ids of 8 bytes are no whole queries of orient2d"),
            (vec![plane(), turns(&[0, 1, 3])], "vertex 3 of a scene of 3"),
            (vec![plane(), turns(&[0, 1, 2]).with("plane", "yz")], "`yz` is no plane of the scene"),
            (vec![Reply::new("scene").with("dimension", "4").with("points", "")], "dimension `4` is neither 2 nor 3"),
            (
                vec![Reply::new("scene").with("dimension", "2").with("points", "1")],
                "points of 1 bytes are no whole points",
            ),
            (vec![Reply::new("scene").with("dimension", "2")], "a message `scene` without `points`"),
        ] {
            assert_eq!(asked(&questions).1, Err(why.to_owned()));
        }
    }
}
