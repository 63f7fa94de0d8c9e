//! The key `queries`: the vertices of the queries.

use super::random::{RandomQueries, vertex};
use predicament_formats::{CorpusError, Field, Fields};
use predicament_predicates::{Axis, Dimension, Plane, PredicateKind, QuerySet, Question, Scene, UnknownName, Vertex};

/// The maximum number of combinations; more are a mistake, not a scene.
const MOST_COMBINATIONS: usize = 1_000_000;

/// The `queries` of a scene, before its points are known.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    question: Question,
    choice: Choice,
    line: usize,
}

#[derive(Clone, Debug)]
enum Choice {
    Tuples,
    All,
    Random(RandomQueries),
    Explicit(Vec<(usize, Vec<Vertex>)>),
}

impl Plan {
    /// Reads `queries`, `plane` and `axis`.
    pub(super) fn read(fields: &Fields<'_, '_>, kind: PredicateKind) -> Result<Plan, CorpusError> {
        let question = question(fields, kind)?;
        let arity = question.kind().arity();
        let field = fields.get("queries");
        let line = field.map_or(fields.line(), |field| field.line());
        let choice = match field {
            None => Choice::Tuples,
            Some(field) if field.is_array() => Choice::Explicit(explicit(&field, arity)?),
            Some(field) if field.is_table() => Choice::Random(RandomQueries::read(&field, arity)?),
            Some(field) => match field.str()? {
                "tuples" => Choice::Tuples,
                "all" => Choice::All,
                other => {
                    return Err(field.error(
                        format!("no choice of queries is called `{other}`"),
                        "write \"tuples\", \"all\", { random = 1000 } or arrays of indices",
                    ));
                }
            },
        };
        Ok(Plan { question, choice, line })
    }

    /// The queries about the vertices of a scene.
    pub(super) fn queries(&self, file: &str, scene: &Scene) -> Result<QuerySet, CorpusError> {
        let (points, constructed) = (scene.len(), scene.constructions().len());
        let error = |line, message: String, cure: &str| CorpusError::file(file, message, cure).at_line(line);
        let kind = self.question.kind();
        let arity = kind.arity();
        if let Err((message, cure)) = fits(self.question, scene.dimension()) {
            return Err(error(self.line, message, &cure));
        }
        let args = match &self.choice {
            Choice::Tuples if constructed > 0 => {
                let message = "tuples consist of points, but the scene has constructed vertices".to_owned();
                return Err(error(self.line, message, "write `queries`: \"all\", or arrays such as [\"c0\", 0, 1]"));
            }
            Choice::Tuples if points < arity => return Err(error(self.line, too_few(points, kind), "add points")),
            Choice::Tuples => (0..points - points % arity).map(Vertex::input).collect(),
            Choice::Random(_) if points + constructed < arity => {
                return Err(error(self.line, too_few(points + constructed, kind), "add points"));
            }
            Choice::Random(random) => {
                random.draw(kind, points + constructed).into_iter().map(|number| vertex(number, points)).collect()
            }
            Choice::All => {
                let vertices = points + constructed;
                let count = combinations(vertices, arity).filter(|count| (1..=MOST_COMBINATIONS).contains(count));
                if count.is_none() {
                    let message =
                        format!("{vertices} points have 0 or more than {MOST_COMBINATIONS} combinations of {arity}");
                    return Err(error(self.line, message, "list the queries that matter"));
                }
                all(vertices, arity).into_iter().map(|number| vertex(number, points)).collect()
            }
            Choice::Explicit(queries) => {
                let mut args = Vec::with_capacity(queries.len() * arity);
                for (line, query) in queries {
                    for vertex in query {
                        let (index, count, what, first) = match vertex.construction() {
                            None => (vertex.index(), points, "points", "0"),
                            Some(index) => (index, constructed, "constructed vertices", "c0"),
                        };
                        if index >= count {
                            let message = format!("query index {vertex} is out of range: the scene has {count} {what}");
                            return Err(error(*line, message, &format!("indices count from {first}")));
                        }
                    }
                    args.extend(query);
                }
                args
            }
        };
        Ok(QuerySet::new(self.question, args))
    }

    /// The remark on queries by tuples that leave points over.
    pub(super) fn remark(&self, scene: &Scene) -> Option<String> {
        let (points, arity) = (scene.len(), self.question.kind().arity());
        let over = points % arity;
        let is_about = matches!(self.choice, Choice::Tuples) && over > 0;
        let are = if over == 1 { "is" } else { "are" };
        is_about.then(|| {
            format!(
                "{over} of {points} points {are} not in a query, at the end: {} takes {arity} points; `queries` \
                 selects others",
                self.question.kind()
            )
        })
    }
}

/// The error about a scene of fewer vertices than a query takes.
fn too_few(vertices: usize, kind: PredicateKind) -> String {
    let points = if vertices == 1 { "point is" } else { "points are" };
    format!("{vertices} {points} too few: {kind} takes {}", kind.arity())
}

/// The question that a table asks: its predicate with `plane` or `axis`.
pub(super) fn question(fields: &Fields<'_, '_>, kind: PredicateKind) -> Result<Question, CorpusError> {
    Ok(match kind {
        PredicateKind::Compare => Question::Compare(axis(fields)?),
        PredicateKind::Orient2d => Question::Orient2d(match fields.get("plane") {
            None => Plane::Xy,
            Some(field) => field
                .str()?
                .parse()
                .map_err(|unknown: UnknownName| field.error(unknown.to_string(), "write xy, yz or zx"))?,
        }),
        other => other.first_question(),
    })
}

/// The `axis` of a table; x by default.
pub fn axis(fields: &Fields<'_, '_>) -> Result<Axis, CorpusError> {
    fields.get("axis").map_or(Ok(Axis::X), |field| {
        field.str()?.parse().map_err(|unknown: UnknownName| field.error(unknown.to_string(), "write x, y or z"))
    })
}

/// Checks that a question applies to points of a dimension.
pub(super) fn fits(question: Question, dimension: Dimension) -> Result<(), (String, String)> {
    let needed = match question {
        Question::Compare(Axis::X | Axis::Y) | Question::Orient2d(Plane::Xy) => return Ok(()),
        other => other.kind().dimension().unwrap_or(Dimension::Three),
    };
    if dimension == needed {
        return Ok(());
    }
    let detail = match question {
        Question::Compare(_) => " along z",
        Question::Orient2d(_) => " in a plane with z",
        _ => "",
    };
    let message = format!(
        "{}{detail} takes points of {}, not of {} coordinates",
        question.kind(),
        needed.count(),
        dimension.count()
    );
    Err((message, format!("give every point {} coordinates", needed.count())))
}

fn explicit(field: &Field<'_, '_>, arity: usize) -> Result<Vec<(usize, Vec<Vertex>)>, CorpusError> {
    let queries = field.items("arrays of indices")?;
    if queries.len() == 0 {
        return Err(field.error("`queries` is empty", "write at least one query"));
    }
    queries
        .map(|query| {
            let indices = query.items("an array of indices")?;
            if indices.len() != arity {
                let message = format!("a query of {} indices; the predicate takes {arity}", indices.len());
                return Err(query.error(message, format!("write {arity} indices")));
            }
            let vertices = indices.map(|index| index.vertex()).collect::<Result<_, _>>()?;
            Ok((query.line(), vertices))
        })
        .collect()
}

/// The number of combinations; `None` on overflow.
fn combinations(n: usize, k: usize) -> Option<usize> {
    (0..k).try_fold(1_usize, |count, i| {
        let factor = n.checked_sub(i)?;
        Some(count.checked_mul(factor)? / (i + 1))
    })
}

/// Every choice of `k` among `n` indices, in lexicographic order.
fn all(n: usize, k: usize) -> Vec<usize> {
    let mut args = Vec::new();
    let mut choice: Vec<usize> = (0..k).collect();
    loop {
        args.extend(&choice);
        let Some(place) = (0..k).rev().find(|&place| choice[place] < n - k + place) else {
            return args;
        };
        choice[place] += 1;
        for later in place + 1..k {
            choice[later] = choice[later - 1] + 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_combinations_in_index_order() {
        assert_eq!(all(4, 3).as_chunks().0, [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]);
        for (n, k) in [(5, 5), (9, 3), (12, 4)] {
            let args = all(n, k);
            assert_eq!(Some(args.len() / k), combinations(n, k));
            assert!(args.chunks(k).is_sorted());
        }
        assert_eq!(combinations(2, 3), Some(0));
    }
}
