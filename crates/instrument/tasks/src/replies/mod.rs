//! Answers of other programs: whole triangulations, hulls, overlays and solids that somebody else's library computes.
//!
//! A backend of this project answers with vertices that keep their definitions, and is judged without a tolerance. A
//! program of another library answers with indices of points and with coordinates in doubles. This module has the form
//! of its questions and answers; the trait [`Replies`] is the judge, and each task that is open to other programs has
//! one.
//!
//! * [`Arrays`]: named arrays, which travel between programs; [`question`]: a scene as arrays.
//! * [`Reply`]: an answer, with its time; [`Part`]: one array of it, or several that belong together.
//! * [`Replies`]: the judge of a task's answers; [`SpoiledReply`]: a right answer with a planted fault.
//! * [`Bound`]: the distances by which rounding can move a vertex.
//! * `invalid`: scenes that a program should refuse.
//! * [`Program`]: something that answers; [`ByProgram`]: its solver for a task.

mod arrays;
mod bound;
mod by_program;
mod invalid;
mod question;
mod row;
mod shape;
mod shown;
mod smallest;
mod spoiled;
mod unasked;

use predicament_predicates::{Declined, Scene};

pub use arrays::{Array, Arrays, Malformed};
pub use bound::{Bound, COARSEST, Far, NEAREST};
pub use by_program::{ByProgram, Program};
pub use invalid::{ACCEPTED, ANSWER, REFUSED};
pub(crate) use invalid::{accepted, not_asked, refused};
pub use question::question;
pub use row::{ReplyRow, add_row};
pub use shape::{Mesh, Rings};
pub(crate) use shown::{draw, write};
pub use smallest::smallest_at_each_place;
pub(crate) use spoiled::Planted;
pub use spoiled::SpoiledReply;

use crate::{Asked, Case, Check, Class, Finding, Outcome, Stop, Task, digest};

/// The name of the check of an answer's form.
pub const FORM: &str = "form of an answer";

/// The check of an answer's form, which every judge of replies has.
pub const FORM_CHECK: Check =
    Check::topology(FORM, "an answer has the arrays of its task: finite numbers, whole tuples, indices of points");

/// An answer of a program.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Reply {
    /// Its arrays.
    pub arrays: Arrays,
    /// The time that the program took, in nanoseconds, by its own clock.
    pub nanoseconds: u64,
    /// The most memory that the program has had, in bytes, if it says so.
    pub bytes: Option<u64>,
}

impl Reply {
    /// The reply with its coordinates times a power of ten, which round to the nearest doubles.
    pub(crate) fn scaled(&self, parts: &[Part], digits: u32) -> Reply {
        let mut scaled = self.clone();
        let Some(factor) = i32::try_from(digits).ok().map(|digits| 10_f64.powi(digits)).filter(|_| digits > 0) else {
            return scaled;
        };
        for part in parts {
            let key = match part.form {
                Form::Polygons | Form::Lines => part.name.to_owned(),
                Form::Mesh | Form::Meshes => format!("{}.vertices", part.name),
                _ => continue,
            };
            if let Some(Array::Numbers(numbers)) = scaled.arrays.get_mut(&key) {
                numbers.iter_mut().for_each(|x| *x *= factor);
            }
        }
        scaled
    }

    /// A digest of the arrays.
    #[must_use]
    pub fn digest(&self) -> u64 {
        let bytes = self.arrays.iter().flat_map(|(name, array)| -> Vec<u8> {
            let values: Vec<u8> = match array {
                Array::Word(word) => word.clone().into_bytes(),
                Array::Ids(ids) => ids.iter().flat_map(|id| id.to_le_bytes()).collect(),
                Array::Numbers(numbers) => numbers.iter().flat_map(|x| x.to_le_bytes()).collect(),
            };
            name.bytes().chain([0]).chain(values).collect()
        });
        digest(bytes)
    }
}

/// The form of a part of an answer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    /// `NAME`: three indices of points for each triangle.
    Triangles,
    /// `NAME`: indices of points, one after the other around a polygon.
    Loop,
    /// `NAME`: a label for each probe.
    Labels,
    /// `NAME`: the coordinates of rings, a point after the other; `NAME.starts`: the place of each ring's first point,
    /// and the number of points; `NAME.polygons`: the place of each polygon's first ring, and the number of rings.
    Polygons,
    /// `NAME.vertices`: the coordinates of vertices; `NAME.triangles`: three indices of these for each triangle.
    Mesh,
    /// A [`Mesh`](Form::Mesh) with `NAME.starts`: the place of each part's first triangle, and the number of triangles.
    Meshes,
    /// `NAME`: the coordinates of polylines, a point after the other; `NAME.starts`: the place of each line's first
    /// point, and the number of points.
    Lines,
    /// `NAME`: indices in lists of different lengths; `NAME.starts`: the place of each list's first index, and the
    /// number of indices. The words are the keys of an object in a JSON file: their values together are a list.
    Lists(&'static [&'static str]),
    /// `NAME`: one number.
    Number,
}

/// A part of an answer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Part {
    /// Its name.
    pub name: &'static str,
    /// Its form.
    pub form: Form,
    /// Its meaning, in one line.
    pub what: &'static str,
    /// False if an answer may leave it out.
    pub is_required: bool,
}

impl Part {
    /// A part that every answer has.
    #[must_use]
    pub const fn new(name: &'static str, form: Form, what: &'static str) -> Part {
        Part { name, form, what, is_required: true }
    }

    /// A part that an answer may leave out.
    #[must_use]
    pub const fn optional(name: &'static str, form: Form, what: &'static str) -> Part {
        Part { is_required: false, ..Part::new(name, form, what) }
    }
}

/// The reason why an answer was not judged to the end.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Unjudged {
    /// Its form is wrong.
    Malformed(Malformed),
    /// The watch stopped the judge.
    Stopped(Stop),
}

impl From<Malformed> for Unjudged {
    fn from(malformed: Malformed) -> Unjudged {
        Unjudged::Malformed(malformed)
    }
}

impl From<Stop> for Unjudged {
    fn from(stop: Stop) -> Unjudged {
        Unjudged::Stopped(stop)
    }
}

/// The start of an engine for a task: a function that answers it in plain doubles, to be replaced.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Example {
    /// The suites with scenes of the task, as arguments of `run`.
    pub suites: &'static str,
    /// The function in each language, by the language's name in `engines new --language`.
    pub functions: &'static [(&'static str, &'static str)],
}

/// The judge of other programs' answers to the scenes of a task.
pub trait Replies<T: Task>: Sync {
    /// The parts of an answer.
    fn parts(&self) -> &'static [Part];

    /// The start of an engine for the task.
    fn example(&self) -> Example;

    /// Checks that the scene can be put to other programs.
    ///
    /// # Errors
    /// [`Declined`] with the reason if it cannot.
    fn open(&self, scene: &Scene, content: &T::Content) -> Result<(), Declined> {
        let _ = (scene, content);
        Ok(())
    }

    /// Adds arrays that the written form of a scene does not have, and that programs need.
    fn more(&self, scene: &Scene, content: &T::Content, question: &mut Arrays) {
        let _ = (scene, content, question);
    }

    /// Judges an answer: adds findings, or [`Class::Agree`] for the whole scene.
    ///
    /// # Errors
    /// [`Unjudged`] if the answer has a wrong form, or the watch stops the judge.
    fn judge(
        &self,
        case: &Case<'_, T>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged>;

    /// A backend's answer in the form of a program's answer, with constructed vertices at their nearest doubles.
    fn reply_of(&self, scene: &Scene, content: &T::Content, answer: &T::Answer) -> Arrays;

    /// The checks of the judge, besides those of the task's own judge and [`FORM_CHECK`].
    fn checks(&self) -> &'static [Check];

    /// Right answers with planted faults, each of which the judge must find.
    fn spoiled(&self) -> Vec<SpoiledReply<T>>;
}

/// Judges a reply by the judge of its task: a wrong form becomes a finding.
pub(crate) fn judge<T: Task>(
    judge: &dyn Replies<T>,
    case: &Case<'_, T>,
    asked: &Asked<'_>,
    reply: &Reply,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    match judge.judge(case, asked, reply, outcome) {
        Ok(()) => {
            if outcome.findings.is_empty() && outcome.counts.get(Class::Agree) == 0 {
                outcome.counts.add(Class::Agree, outcome.queries);
            }
            Ok(())
        }
        Err(Unjudged::Malformed(malformed)) => {
            note(outcome, Class::Topology, FORM, malformed.to_string(), "arrays as docs/ENGINES.md describes them");
            Ok(())
        }
        Err(Unjudged::Stopped(stop)) => Err(stop),
    }
}

/// The reason for declining a task that is not open to other programs.
pub(crate) fn not_open(task: &str) -> String {
    format!("{task} is not open to other programs")
}

/// Adds a finding about a whole answer.
pub fn note(outcome: &mut Outcome, class: Class, check: &str, got: String, law: &str) {
    outcome.counts.add(class, 1);
    outcome.findings.push(Finding::plain(class, check, Vec::new(), got, law.to_owned()));
}
