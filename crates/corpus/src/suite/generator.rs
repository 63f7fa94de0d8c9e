//! `[[generate]]` tables.

use predicament_formats::{Cache, CorpusError, Field, Fields};

use super::Context;
use super::scene::{SceneDef, define};
use crate::{Elsewhere, Family, Level, Making, Parts, Recipe, SceneFormat, Source};

/// More queries than this don't fit a scene's vertex ids.
const MOST_QUERIES: u64 = 100_000_000;

/// A generated scene before it is generated.
struct Generated {
    recipe: Recipe,
    making: Making,
    /// How many queries at level quick, and at level full.
    amount: [usize; 2],
}

impl Elsewhere for Generated {
    fn load(&self, level: Level, _: &Cache) -> Result<Parts, CorpusError> {
        Ok(self.recipe.make(&Making { n: level.of(self.amount), level, ..self.making }))
    }
}

/// Reads a `[[generate]]` table.
pub(super) fn read(context: &Context<'_>, fields: Fields<'_, '_>) -> Result<SceneDef, CorpusError> {
    let task = context.vocabulary.task(&fields.required("task")?)?;
    let family = context.vocabulary.family(&fields.required("family")?, task)?;
    let seed = fields.integer_or("seed", 0, 0..=u64::MAX)?;
    let recipe = (family.read)(task.name(), &fields)?;
    let amount = amount(&fields, &recipe)?;
    let name = match fields.get("name") {
        Some(name) => name.string()?,
        None => default_name(family, &fields, task)?,
    };
    let reported_as = family.reported_as.map_or_else(|| name.clone(), str::to_owned);
    let making = Making { family: family.name, task: task.name(), seed, n: 0, level: Level::Quick };
    define(context, fields, name, task.name(), &reported_as, Source::elsewhere(Generated { recipe, making, amount }))
}

/// `n` and `n_full`; recipes of a fixed size have neither.
fn amount(fields: &Fields<'_, '_>, recipe: &Recipe) -> Result<[usize; 2], CorpusError> {
    if let Some(n) = recipe.fixed_size {
        return Ok([n, n]);
    }
    let count = |field: Field<'_, '_>| field.count(1..=MOST_QUERIES);
    let quick = count(fields.required("n")?)?;
    let full = fields.get("n_full").map_or(Ok(quick), count)?;
    Ok([quick, full])
}

/// Family, task, and every parameter that was written: `near-orient2d-ulps-4`.
fn default_name(family: &Family, fields: &Fields<'_, '_>, task: &dyn SceneFormat) -> Result<String, CorpusError> {
    let mut name = format!("{}-{}", family.name, task.name());
    for key in task.naming_keys().iter().chain(family.parameters) {
        if let Some(field) = fields.again(key) {
            name.push_str(&format!("-{key}-{}", field.plain()?));
        }
    }
    Ok(name)
}
