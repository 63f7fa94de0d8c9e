//! One query as text and back: findings name it, and `replay` asks it again.

use alloc::{borrow::ToOwned, string::String, vec, vec::Vec};
use core::fmt;
use core::str::FromStr;

use crate::{Axis, Plane, PredicateKind, Question, UnknownName, Vertex};

/// A query by name: the predicate or task, a detail, and vertices.
///
/// As text: `orient2d(xy; 0 1 2)`, `NAME(7)`, `NAME(0 1, 4 5)`: the name of a predicate or task, a detail if there is
/// one, and groups of vertices.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Query {
    /// The name of a predicate or task.
    pub what: String,
    /// The detail: an axis, a plane, or another parameter; `None` for most queries.
    pub detail: Option<String>,
    /// The vertices, in groups: one group for most queries, more if a task queries several simplices.
    pub args: Vec<Vec<Vertex>>,
}

impl Query {
    /// A query of a task about one group of vertices.
    #[must_use]
    pub fn of_task(task: &str, args: &[Vertex]) -> Query {
        Query { what: task.to_owned(), detail: None, args: vec![args.to_vec()] }
    }

    /// The predicate's question and its arguments; `None` if the query is of a task.
    #[must_use]
    pub fn question(&self) -> Option<(Question, &[Vertex])> {
        let detail = self.detail.as_deref();
        let question = match (self.what.parse::<PredicateKind>().ok()?.first_question(), detail) {
            (Question::Compare(_), Some(axis)) => Question::Compare(axis.parse().ok()?),
            (Question::Orient2d(_), Some(plane)) => Question::Orient2d(plane.parse().ok()?),
            (Question::Compare(_) | Question::Orient2d(_), None) | (_, Some(_)) => return None,
            (question, None) => question,
        };
        let [args] = self.args.as_slice() else { return None };
        (args.len() == question.kind().arity()).then_some((question, args))
    }

    /// All vertices, group after group.
    pub fn vertices(&self) -> impl Iterator<Item = Vertex> {
        self.args.iter().flatten().copied()
    }
}

impl fmt::Display for Query {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}(", self.what)?;
        if let Some(detail) = &self.detail {
            write!(f, "{detail}; ")?;
        }
        for (at, group) in self.args.iter().enumerate() {
            f.write_str(if at == 0 { "" } else { ", " })?;
            for (at, vertex) in group.iter().enumerate() {
                write!(f, "{}{vertex}", if at == 0 { "" } else { " " })?;
            }
        }
        f.write_str(")")
    }
}

/// The reason why a text is not a query.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ParseQueryError(String);

impl fmt::Display for ParseQueryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` is not a query; write a name and vertices, such as `orient2d(xy; 0 1 2)`", self.0)
    }
}

impl core::error::Error for ParseQueryError {}

/// Reads what `Display` writes.
impl FromStr for Query {
    type Err = ParseQueryError;

    fn from_str(text: &str) -> Result<Query, ParseQueryError> {
        let bad = || ParseQueryError(text.to_owned());
        let (what, rest) = text.strip_suffix(')').and_then(|text| text.split_once('(')).ok_or_else(bad)?;
        let (detail, groups) = match rest.split_once("; ") {
            Some((detail, groups)) => (Some(detail.to_owned()), groups),
            None => (None, rest),
        };
        let group = |group: &str| group.split(' ').map(str::parse).collect::<Result<Vec<Vertex>, _>>();
        let args = groups.split(", ").map(group).collect::<Result<Vec<_>, _>>().map_err(|_| bad())?;
        let named = !what.is_empty() && detail.as_deref() != Some("");
        if named { Ok(Query { what: what.to_owned(), detail, args }) } else { Err(bad()) }
    }
}

impl Question {
    /// The query of this question with these vertices.
    #[must_use]
    pub fn query(self, args: &[Vertex]) -> Query {
        let detail = match self {
            Question::Compare(axis) => Some(axis.name().to_owned()),
            Question::Orient2d(plane) => Some(plane.name().to_owned()),
            Question::Orient3d | Question::Incircle | Question::Insphere | Question::Derived(_) => None,
        };
        Query { what: self.kind().name().to_owned(), detail, args: vec![args.to_vec()] }
    }
}

impl Axis {
    /// `x`, `y` or `z`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Axis::X => "x",
            Axis::Y => "y",
            Axis::Z => "z",
        }
    }
}

impl FromStr for Axis {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Axis, UnknownName> {
        let axes = [Axis::X, Axis::Y, Axis::Z];
        axes.into_iter().find(|axis| axis.name() == name).ok_or_else(|| UnknownName::new("axis", name))
    }
}

impl Plane {
    /// `xy`, `yz` or `zx`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Plane::Xy => "xy",
            Plane::Yz => "yz",
            Plane::Zx => "zx",
        }
    }
}

impl FromStr for Plane {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Plane, UnknownName> {
        let planes = [Plane::Xy, Plane::Yz, Plane::Zx];
        planes.into_iter().find(|plane| plane.name() == name).ok_or_else(|| UnknownName::new("plane", name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn queries_read_back_as_they_are_written() {
        let [a, b, c, d] = [3, 1, 0, 5].map(Vertex::input);
        let ids = [a, b, Vertex::constructed(4), c, d];
        for question in [
            Question::Compare(Axis::Z),
            Question::Orient2d(Plane::Zx),
            Question::Orient3d,
            Question::Incircle,
            Question::Insphere,
        ] {
            let ids = &ids[..question.kind().arity()];
            let query = question.query(ids);
            assert_eq!(query.to_string().parse(), Ok(query.clone()));
            assert_eq!(query.question(), Some((question, ids)));
        }
        assert_eq!(Question::Orient2d(Plane::Xy).query(&ids[..3]).to_string(), "orient2d(xy; 3 1 c4)");
        let pair = Query { what: "of-pairs".to_owned(), detail: None, args: vec![vec![a, b], vec![c, d]] };
        assert_eq!(pair.to_string(), "of-pairs(3 1, 0 5)");
        assert_eq!(pair.to_string().parse(), Ok(pair));
        assert_eq!(Query::of_task("of-points", &[a]).to_string(), "of-points(3)");
    }

    #[test]
    fn what_is_no_query_is_refused() {
        for broken in ["", "orient2d", "(1 2)", "orient2d(xy; 1 2 d3)", "incircle(1 2 3 x)", "a(; 1)", "a()", "a(1,2)"]
        {
            assert!(broken.parse::<Query>().unwrap_err().to_string().contains(broken), "{broken}");
        }
        for other in ["orient2d(xy; 1 2)", "orient3d(xy; 1 2 3 4)", "compare(w; 1 2)", "hull(1 2 3)"] {
            assert_eq!(other.parse::<Query>().unwrap().question(), None, "{other}");
        }
    }
}
