//! The key `fixture`: published rows with expected signs.

use predicament_corpus::{Context, Elsewhere, Level, Origin, Parts};
use predicament_formats::{
    Cache, CorpusError, Decimals, Entry, Field, ImportNotes, Place, TableKind, explain, shown, skipped,
};
use predicament_predicates::{Dimension, PredicateKind, QuerySet, Question, Scene, Sign};

use super::SignQueries;

static FIXTURE: TableKind = TableKind::new("fixture", &["fetch"]);

/// Rows of one predicate, fetched.
pub(super) struct Fixture {
    question: Question,
    origin: Origin,
    round: bool,
}

impl Fixture {
    /// Reads `fixture = { fetch = "…" }`.
    pub(super) fn read(
        kind: PredicateKind,
        context: &Context<'_>,
        fixture: &Field<'_, '_>,
    ) -> Result<Fixture, CorpusError> {
        if !PredicateKind::DETERMINANTS.contains(&kind) {
            let cure = format!("use {}", PredicateKind::DETERMINANTS.map(PredicateKind::name).join(", "));
            return Err(fixture.error(format!("no fixture has rows for {kind}"), cure));
        }
        let question = kind.first_question();
        let table = fixture.fields(&FIXTURE)?;
        let origin = Origin::fetched(context, &table.required("fetch")?)?;
        table.finish()?;
        Ok(Fixture { question, origin, round: context.round() })
    }
}

impl Elsewhere for Fixture {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let decimals = Decimals::new(self.round);
        let (file, text) = self.origin.text(cache)?;
        let (scene, expected) = read_fixture(&file, &text, self.question.kind(), &decimals)?;
        let queries = QuerySet::new(self.question, scene.vertices().collect());
        let notes = ImportNotes { rounded: decimals.rounded(), ..ImportNotes::default() };
        Ok(Parts { notes, ..Parts::new(scene, SignQueries { queries, expected: Some(expected) }) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.origin.entry()
    }
}

/// Reads a table of the crate `robust` (the fixtures of Shewchuk's predicates). A row is its number, the coordinates of
/// one query's points, and the expected sign, separated by blanks.
///
/// The rows have 17 significant digits, which name one double each; `round = true` reads that double.
fn read_fixture(
    file: &str,
    text: &str,
    kind: PredicateKind,
    decimals: &Decimals,
) -> Result<(Scene, Vec<Sign>), CorpusError> {
    let dimension = kind.dimension().unwrap_or(Dimension::Two);
    let width = kind.arity() * dimension.count() + 2;
    let mut coordinates = Vec::new();
    let mut expected = Vec::new();
    for (at, line) in text.lines().enumerate().filter(|(_, line)| !skipped(line)) {
        let error = |message: String, cure: &str| CorpusError::file(file, message, cure).at_line(at + 1);
        let cells: Vec<_> = line.split_ascii_whitespace().collect();
        if cells.len() != width {
            let message = format!("a row of {} cells; {kind} has {width}", cells.len());
            return Err(error(message, "fetch the file that the manifest names"));
        }
        for cell in &cells[1..width - 1] {
            let value = decimals.read(cell).map_err(|why| {
                let (message, cure) = explain(Place::Data, cell, &why);
                error(message, &cure)
            })?;
            coordinates.push(value);
        }
        expected.push(match cells[width - 1] {
            "-1" => Sign::Negative,
            "0" => Sign::Zero,
            "1" => Sign::Positive,
            other => return Err(error(format!("`{}` is not a sign", shown(other)), "a row ends in -1, 0 or 1")),
        });
    }
    let scene = Scene::new(dimension, coordinates)
        .map_err(|error| CorpusError::file(file, error.to_string(), "fetch the file that the manifest names"))?;
    Ok((scene, expected))
}
