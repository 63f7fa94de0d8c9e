//! Findings: queries with a wrong answer, and the test that reproduces each.

use std::fmt::Write as _;

use predicament_predicates::{PredicateKind, Sign};

use crate::check::{PLANE, SPACE};
use crate::query::{Query, Subject};
use crate::{Answer, Number, Point, Shape};

/// The result of asking a predicate.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Got {
    /// An answer.
    Answer(Answer),
    /// A panic with this message.
    Panic(String),
}

impl std::fmt::Display for Got {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Got::Answer(answer) => write!(f, "{answer}"),
            Got::Panic(message) => write!(f, "a panic ({message})"),
        }
    }
}

/// The kind of error in an answer.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Error {
    /// The opposite of the true sign.
    Flipped,
    /// A sign where zero is true.
    MissedZero,
    /// Zero where a sign is true.
    FalseZero,
    /// Not a number.
    NotANumber,
    /// No sign.
    Undecided,
    /// A panic.
    Panicked,
}

impl Error {
    /// The error in an answer; `None` if the answer is true.
    pub(crate) fn of(got: &Got, truth: Sign) -> Option<Error> {
        Some(match got {
            Got::Panic(_) => Error::Panicked,
            Got::Answer(Answer::Undecided) => Error::Undecided,
            Got::Answer(Answer::NotANumber) => Error::NotANumber,
            Got::Answer(Answer::Sign(sign)) if *sign == truth => return None,
            Got::Answer(Answer::Sign(Sign::Zero)) => Error::FalseZero,
            Got::Answer(Answer::Sign(_)) if truth.is_zero() => Error::MissedZero,
            Got::Answer(Answer::Sign(_)) => Error::Flipped,
        })
    }

    /// The error's name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Error::Flipped => "opposite sign",
            Error::MissedZero => "a sign for an exact zero",
            Error::FalseZero => "zero for a sign",
            Error::NotANumber => "NaN",
            Error::Undecided => "undecided",
            Error::Panicked => "panic",
        }
    }
}

/// A query with a wrong answer.
#[derive(Clone, PartialEq, Debug)]
pub struct Finding<P> {
    /// The family or the scene of the query.
    pub source: String,
    /// The number of the query in its family or scene.
    pub case: usize,
    /// The axis or the plane of the query; empty if the predicate has neither.
    pub way: &'static str,
    /// The kind of error.
    pub error: Error,
    /// The arguments.
    pub points: Vec<P>,
    /// The answer.
    pub got: Got,
    /// The exact sign.
    pub truth: Sign,
    /// The arguments of the smallest query found with the same kind of error.
    pub shrunk: Vec<P>,
    /// The answer to the shrunk query.
    pub shrunk_got: Got,
    /// The exact sign of the shrunk query.
    pub shrunk_truth: Sign,
    /// A test in Rust that reproduces the shrunk query.
    pub test: String,
    /// The coordinates of the query and of the shrunk query, in hexadecimal digits and in decimals.
    pub coordinates: [String; 2],
}

impl<P> std::fmt::Display for Finding<P> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let way = if self.way.is_empty() { String::new() } else { format!(", {}", self.way) };
        let error = self.error.name();
        writeln!(f, "{error} in {}, query {}{way}: got {}, true is {}", self.source, self.case, self.got, self.truth)?;
        f.write_str(&self.coordinates[0])?;
        writeln!(f, "  shrunk: got {}, true is {}", self.shrunk_got, self.shrunk_truth)?;
        write!(f, "{}{}", self.coordinates[1], self.test.trim_end())
    }
}

/// A test in Rust that reproduces the answer to one query about input points, as checks write it.
///
/// `call` is the predicate's path; `source` says where the query is from. Returns `None` for a predicate that checks do
/// not know, or if the number of points or coordinates is not the predicate's.
#[must_use]
pub fn regression_test(
    kind: PredicateKind,
    call: &str,
    source: &str,
    points: &[&[f64]],
    got: Answer,
    truth: Sign,
) -> Option<String> {
    let query = Query { way: 0, shapes: vec![Shape::Input; points.len()], coordinates: points.concat() };
    let subject = |ways| Subject { kind, dimension: points.first().map_or(0, |point| point.len()), ways };
    let got = Got::Answer(got);
    match kind {
        PredicateKind::Orient2d | PredicateKind::Incircle if points.len() == kind.arity() => {
            Some(test::<[f64; 2]>(subject(PLANE), call, source, &query, &query.points()?, &got, truth))
        }
        PredicateKind::Orient3d | PredicateKind::Insphere if points.len() == kind.arity() => {
            Some(test::<[f64; 3]>(subject(SPACE), call, source, &query, &query.points()?, &got, truth))
        }
        _ => None,
    }
}

/// The names of arguments.
const LETTERS: [&str; 5] = ["a", "b", "c", "d", "e"];

/// The lines that show the points of a query: its coordinates in hexadecimal digits, and in decimals.
pub(crate) fn lines<P: Point>(query: &Query<P::Number>) -> String {
    let mut text = String::new();
    let mut rest = query.coordinates.as_slice();
    for (letter, shape) in LETTERS.iter().zip(&query.shapes) {
        let (own, others) = rest.split_at(shape.size() * P::DIMENSION);
        rest = others;
        let coordinates = |of: &dyn Fn(&P::Number) -> String| {
            let each: Vec<String> = own
                .chunks(P::DIMENSION)
                .map(|point| format!("[{}]", point.iter().map(of).collect::<Vec<_>>().join(", ")))
                .collect();
            each.join(" ")
        };
        let name = match shape {
            Shape::Input => String::new(),
            other => format!("{} of ", format!("{other:?}").to_uppercase()),
        };
        let hex = coordinates(&|x| x.hex());
        let decimal = coordinates(&|x| format!("{x:?}"));
        let _ = writeln!(text, "    {letter} = {name}{hex} = {decimal}");
    }
    text
}

/// The test that reproduces a query: it compiles where `call` is a predicate, and fails as long as the answer is wrong.
pub(crate) fn test<P: Point>(
    subject: Subject,
    call: &str,
    source: &str,
    query: &Query<P::Number>,
    points: &[P],
    got: &Got,
    truth: Sign,
) -> String {
    // Letters and digits in lower case, with one underscore for all between.
    let plain = |text: &str| -> String {
        let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
        words.map(str::to_ascii_lowercase).collect::<Vec<_>>().join("_")
    };
    let (way, _) = subject.ways[query.way];
    let name = format!("{}_{}", plain(call), plain(&source.replace(", query", "")));
    let mut text = format!("/// Answered: {got}; found in {source}.\n#[test]\nfn {name}() {{\n");
    let is_indirect = points.iter().any(|point| point.literal().starts_with("Point"));
    let (first, names) = match (subject.kind, way) {
        (_, "") => (String::new(), "Answer"),
        (PredicateKind::Compare, way) => (format!("Axis::{}, ", way.to_uppercase()), "Answer, Axis"),
        (_, way) => (format!("Plane::{}{}, ", way[..1].to_uppercase(), &way[1..]), "Answer, Plane"),
    };
    let kind = if is_indirect { format!(", Point{}", P::DIMENSION) } else { String::new() };
    let _ = writeln!(text, "    use predicament_conformance::{{{names}{kind}, Sign}};");
    for (letter, point) in LETTERS.iter().zip(points) {
        let decimal = if P::Number::IS_FLOAT && !is_indirect { format!(" // {point:?}") } else { String::new() };
        let _ = writeln!(text, "    let {letter} = {};{decimal}", point.literal());
    }
    let arguments = LETTERS[..points.len()].join(", ");
    let _ = writeln!(text, "    let answer = {call}({first}{arguments});");
    let _ = writeln!(text, "    assert_eq!(Answer::from(answer), Answer::Sign(Sign::{truth:?}));");
    text + "}\n"
}
