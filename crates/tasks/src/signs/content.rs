//! `points` with `queries`, or a `fixture`: what a scene of signs asks.

use std::path::PathBuf;

use predicament_corpus::{Canon, Content, Context, Elsewhere, Level, Parts, Source};
use predicament_formats::{Cache, CorpusError, Field, Fields, POINTS, read_csv, read_points};
use predicament_predicates::{PredicateKind, QuerySet, Question, Scene, Sign};

use super::constructed::Constructions;
use super::fixture::Fixture;
use super::queries::Plan;

/// Queries of one predicate.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SignQueries {
    /// The queries.
    pub queries: QuerySet,
    /// The signs that the data's author expects, query by query.
    pub expected: Option<Vec<Sign>>,
}

impl SignQueries {
    /// Queries without published signs.
    #[must_use]
    pub fn new(queries: QuerySet) -> SignQueries {
        SignQueries { queries, expected: None }
    }
}

impl Content for SignQueries {
    fn count(&self) -> usize {
        self.queries.len()
    }

    fn canon(&self, canon: &mut Canon) {
        let question = self.queries.question();
        let of = match question {
            Question::Compare(axis) => format!(" {}", axis.name()),
            Question::Orient2d(plane) => format!(" {}", plane.name()),
            Question::Orient3d | Question::Incircle | Question::Insphere => String::new(),
        };
        canon.text(&format!("{}{of}", question.kind()));
        canon.vertices(self.queries.flat());
    }
}

/// Reads a `[[scene]]` table.
pub(super) fn read(kind: PredicateKind, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    match (fields.get("points"), fields.get("fixture")) {
        (Some(points), None) => from_points(kind, context, fields, &points),
        (None, Some(fixture)) => Ok(Source::elsewhere(Fixture::read(kind, context, &fixture)?)),
        (None, None) => {
            let missing = fields.error("a scene without content", "write `points` or `fixture`");
            Err(fields.lacking("one of `points` and `fixture`", missing))
        }
        (Some(_), Some(_)) => Err(fields.error("a scene with both `points` and `fixture`", "keep one of them")),
    }
}

fn from_points(
    kind: PredicateKind,
    context: &Context<'_>,
    fields: &Fields<'_, '_>,
    points: &Field<'_, '_>,
) -> Result<Source, CorpusError> {
    let plan = Plan::read(fields, kind)?;
    let constructed = Constructions::read(fields, kind)?;
    let file = fields.file().to_owned();
    if !points.is_array() {
        let table = points.fields(&POINTS)?;
        let path = context.path(&table.required("path")?)?;
        table.finish()?;
        return Ok(Source::elsewhere(Csv { path, file, line: fields.line(), constructed, plan }));
    }
    let (dimension, coordinates) = read_points(points)?;
    let mut scene =
        Scene::new(dimension, coordinates).map_err(|error| points.error(error.to_string(), "correct the points"))?;
    constructed.add_to(&mut scene, &file)?;
    let queries = plan.queries(&file, &scene)?;
    Ok(Source::Written(Parts::new(scene, SignQueries::new(queries))))
}

/// Points in a CSV file beside the suite.
struct Csv {
    path: PathBuf,
    file: String,
    line: usize,
    constructed: Constructions,
    plan: Plan,
}

impl Elsewhere for Csv {
    fn load(&self, _: Level, _: &Cache) -> Result<Parts, CorpusError> {
        let (dimension, coordinates) = read_csv(&self.path)?;
        let mut scene = Scene::new(dimension, coordinates).map_err(|error| {
            CorpusError::file(&self.file, error.to_string(), "correct the points").at_line(self.line)
        })?;
        self.constructed.add_to(&mut scene, &self.file)?;
        let queries = self.plan.queries(&self.file, &scene)?;
        Ok(Parts::new(scene, SignQueries::new(queries)))
    }
}
