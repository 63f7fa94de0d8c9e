//! The reader of `[[generate]]` tables.

use predicament_formats::{Cache, CorpusError, Field, Fields, MOST_COORDINATES, read_points};
use predicament_predicates::Dimension;

use super::Context;
use super::scene::{SceneDef, check_name, define};
use crate::loaded::moved;
use crate::{Elsewhere, Family, Level, Making, Parts, Recipe, SceneFormat, Source};

/// The maximum number of queries; more would exceed a scene's vertex ids.
const MOST_QUERIES: u64 = 100_000_000;

/// A generated scene that is not yet generated.
struct Generated {
    recipe: Recipe,
    making: Making,
    /// The numbers of queries at level quick and at level full.
    amount: [usize; 2],
    /// The coordinates that replace the generated points, if they are written.
    places: Option<Places>,
}

/// The points of a generated scene, written in the suite.
struct Places {
    dimension: Dimension,
    coordinates: Vec<f64>,
    file: String,
    line: usize,
}

impl Places {
    /// Reads the value of `coordinates`.
    fn read(field: &Field<'_, '_>) -> Result<Places, CorpusError> {
        let (dimension, coordinates) = read_points(field)?;
        Ok(Places { dimension, coordinates, file: field.file().to_owned(), line: field.line() })
    }

    /// The generated scene with its points moved to these coordinates.
    fn of(&self, made: Parts) -> Result<Parts, CorpusError> {
        let error = |message: String| {
            let cure = "write as many points as the family makes, or remove `coordinates`";
            CorpusError::file(&self.file, message, cure).at_line(self.line)
        };
        if made.scene.dimension() != self.dimension {
            let [made, has] = [made.scene.dimension(), self.dimension].map(Dimension::count);
            return Err(error(format!("the family makes points of {made} coordinates, and these have {has}")));
        }
        let (scene, content) =
            moved(&made.scene, &made.content, self.coordinates.clone()).map_err(|why| error(why.to_string()))?;
        Ok(Parts { scene, content, written: None, ..made })
    }
}

impl Elsewhere for Generated {
    fn load(&self, level: Level, _: &Cache) -> Result<Parts, CorpusError> {
        let made = self.recipe.make(&Making { n: level.of(self.amount), level, ..self.making });
        match &self.places {
            Some(places) => places.of(made),
            None => Ok(made),
        }
    }
}

/// Reads a `[[generate]]` table.
pub(super) fn read(context: &Context<'_>, fields: Fields<'_, '_>) -> Result<SceneDef, CorpusError> {
    let task = context.vocabulary.task(&fields.required("task")?)?;
    let family = context.vocabulary.family(&fields.required("family")?, task)?;
    let seed = fields.integer_or("seed", 0, 0..=u64::MAX)?;
    let recipe = (family.read)(task.name(), &fields)?;
    let amount = amount(&fields, &recipe)?;
    let places = fields.get("coordinates").map(|field| Places::read(&field)).transpose()?;
    let name = match fields.get("name") {
        Some(field) => {
            let name = field.string()?;
            check_name(&field, &name)?;
            name
        }
        None => default_name(family, &fields, task)?,
    };
    let reported_as = family.reported_as.map_or_else(|| name.clone(), str::to_owned);
    let making = Making { family: family.name, task: task.name(), seed, n: 0, level: Level::Quick };
    define(context, fields, name, task, &reported_as, Source::elsewhere(Generated { recipe, making, amount, places }))
}

/// Reads `n` and `n_full`; recipes of a fixed size have neither.
fn amount(fields: &Fields<'_, '_>, recipe: &Recipe) -> Result<[usize; 2], CorpusError> {
    if let Some(n) = recipe.fixed_size {
        let size = u64::try_from(n).unwrap_or(u64::MAX);
        if !fits(recipe, size) {
            let message = format!("the scene has about {} coordinates", recipe.coordinates(size));
            return Err(fields.error(message, format!("choose parameters for at most {MOST_COORDINATES}")));
        }
        return Ok([n, n]);
    }
    let count = |key: &str, field: Field<'_, '_>| {
        let n = field.integer(1..=MOST_QUERIES)?;
        if fits(recipe, n) {
            return Ok(usize::try_from(n).unwrap_or(usize::MAX));
        }
        let message = format!(
            "`{key}` is {n}: a scene of about {} coordinates; the maximum is {MOST_COORDINATES}",
            recipe.coordinates(n)
        );
        let cure = match most(recipe) {
            0 => "choose fewer random points".to_owned(),
            most => format!("choose at most {most}"),
        };
        Err(field.error(message, cure))
    };
    let quick = count("n", fields.required("n")?)?;
    let full = fields.get("n_full").map_or(Ok(quick), |field| count("n_full", field))?;
    Ok([quick, full])
}

/// True if a scene of n is small enough to generate.
fn fits(recipe: &Recipe, n: u64) -> bool {
    usize::try_from(recipe.coordinates(n)).is_ok_and(|coordinates| coordinates <= MOST_COORDINATES)
}

/// The largest n whose scene is small enough, by bisection.
fn most(recipe: &Recipe) -> u64 {
    let [mut fit, mut unfit] = [0, MOST_QUERIES + 1];
    while unfit - fit > 1 {
        let middle = fit.midpoint(unfit);
        if fits(recipe, middle) { fit = middle } else { unfit = middle }
    }
    fit
}

/// The default name: family, task, and every written parameter, as in `near-orient2d-ulps-4`.
fn default_name(family: &Family, fields: &Fields<'_, '_>, task: &dyn SceneFormat) -> Result<String, CorpusError> {
    let mut name = format!("{}-{}", family.name, task.name());
    for key in task.naming_keys().iter().chain(family.parameters) {
        if let Some(field) = fields.again(key) {
            name.push_str(&format!("-{key}-{}", field.plain()?));
        }
    }
    Ok(name)
}
