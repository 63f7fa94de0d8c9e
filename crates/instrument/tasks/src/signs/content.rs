//! The queries of a scene of signs: `points` with `queries`, or a `fixture`.

use predicament_corpus::{
    Canon, Content, Context, Elsewhere, Items, Level, List, Parts, PointSource, Source, Spelled, spelled_points,
};
use predicament_formats::{Cache, CorpusError, Entry, Field, Fields, RowKind, read_rows};
use predicament_predicates::{Derived, PredicateKind, QuerySet, Question, Scene, Sign, Vertex};

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
    /// A list of queries without published signs.
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
            // The formula is part of the question; its name alone could be used for two.
            Question::Derived(derived) => format!(" {}", derived.formula().text()),
            Question::Orient3d | Question::Incircle | Question::Insphere => String::new(),
        };
        canon.text(&format!("{}{of}", question.kind()));
        canon.vertices(self.queries.flat());
    }

    /// Writes the queries without published signs.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let question = self.queries.question();
        let words = match question {
            Question::Compare(axis) => vec![("axis", format!("\"{}\"", axis.name()))],
            Question::Orient2d(plane) => vec![("plane", format!("\"{}\"", plane.name()))],
            Question::Orient3d | Question::Incircle | Question::Insphere | Question::Derived(_) => Vec::new(),
        };
        let queries = self.queries.flat().chunks_exact(question.kind().arity()).map(<[Vertex]>::to_vec).collect();
        let lists = vec![List::required("queries", Items::Tuples(queries))];
        Some(Spelled { words, lists, ..spelled_points(scene) })
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
    if let PredicateKind::Derived(derived) = kind
        && derived.formula().is_weighted()
    {
        let plan = Plan::read(fields, kind)?;
        let scene = weighted(derived, points)?;
        let queries = plan.queries(fields.file(), &scene)?;
        let remarks = plan.remark(&scene).into_iter().collect();
        return Ok(Source::Written(Parts { remarks, ..Parts::new(scene, SignQueries::new(queries)) }));
    }
    let asked = Asked {
        plan: Plan::read(fields, kind)?,
        constructed: Constructions::read(fields, kind)?,
        file: fields.file().to_owned(),
        points: PointSource::read(context, points, fields.file())?,
    };
    if asked.points.is_written() {
        // No cache is read: all coordinates are in the suite.
        return Ok(Source::Written(asked.load(Level::Quick, &Cache::new(""))?));
    }
    Ok(Source::elsewhere(asked))
}

/// A scene of weighted points: the last number of each point is its weight.
fn weighted(derived: Derived, points: &Field<'_, '_>) -> Result<Scene, CorpusError> {
    let width = derived.formula().coordinates();
    let kind = RowKind {
        name: "weighted point",
        widths: width..=width,
        numbers: "numbers",
        cure: "give every point its coordinates and then its weight",
    };
    let rows = read_rows(points, &kind)?;
    let weights = rows.numbers.chunks_exact(width).map(|point| point[width - 1]).collect();
    let coordinates = rows.numbers.chunks_exact(width).flat_map(|point| &point[..width - 1]).copied().collect();
    let scene = Scene::new(derived.dimension(), coordinates).and_then(|scene| scene.with_weights(weights));
    scene.map_err(|error| points.error(error.to_string(), "correct the points"))
}

/// Points, written out or in a data file beside the suite, and the queries about them.
struct Asked {
    points: PointSource,
    file: String,
    constructed: Constructions,
    plan: Plan,
}

impl Elsewhere for Asked {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (mut scene, notes) = self.points.scene(cache)?;
        self.constructed.add_to(&mut scene, &self.file)?;
        let queries = self.plan.queries(&self.file, &scene)?;
        let remarks = self.plan.remark(&scene).into_iter().collect();
        Ok(Parts { notes, remarks, ..Parts::new(scene, SignQueries::new(queries)) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.points.entry()
    }
}
