//! `[[generate]]` tables.

use predicament_predicates::{Axis, Dimension};

use super::scene::{Content, Probing, SceneDef, define};
use super::{Context, contacts, queries};
use crate::document::{Field, Fields};
use crate::generate::{Amount, Family, Generator, Shape};
use crate::{CorpusError, Task};

/// More queries than this don't fit a scene's vertex ids.
const MOST_QUERIES: u64 = 100_000_000;

/// Reads a `[[generate]]` table.
pub(super) fn read(context: &Context<'_>, fields: Fields<'_, '_>) -> Result<SceneDef, CorpusError> {
    let task = fields.required("task")?.task()?;
    let family_field = fields.required("family")?;
    let family = Family::read(&family_field, &fields, task)?;
    let generator = Generator {
        seed: fields.integer_or("seed", 0, 0..=u64::MAX)?,
        amount: amount(&fields, &family)?,
        shape: shape(&fields, task, &family)?,
        family,
    };
    let name = match fields.get("name") {
        Some(name) => name.string()?,
        None => default_name(&generator, &fields, task)?,
    };
    // what contacts cost depends on the scene's size and on how near things are: each is a family of its own
    let family = match contacts::dimension(task) {
        Some(_) => name.clone(),
        None => generator.family.reported_as().to_owned(),
    };
    define(context, fields, name, task, &family, Content::Generated(generator))
}

/// `n` and `n_full`; families of a fixed size have neither.
fn amount(fields: &Fields<'_, '_>, family: &Family) -> Result<Amount, CorpusError> {
    if let Some(n) = family.fixed_size() {
        return Ok(Amount { quick: n, full: n });
    }
    let count = |field: Field<'_, '_>| field.count(1..=MOST_QUERIES);
    let quick = count(fields.required("n")?)?;
    let full = fields.get("n_full").map_or(Ok(quick), count)?;
    Ok(Amount { quick, full })
}

fn shape(fields: &Fields<'_, '_>, task: Task, family: &Family) -> Result<Shape, CorpusError> {
    match task {
        Task::Interval => {
            let axis = queries::axis(fields)?;
            let space = axis == Axis::Z || fields.integer_or("dimension", 2, 2..=3)? == 3;
            return Ok(Shape::Cells { axis, dimension: if space { Dimension::Three } else { Dimension::Two } });
        }
        Task::PolygonLocate => return Ok(Shape::Map(Probing::read(fields)?)),
        Task::CubeUnion => return Ok(Shape::Cubes),
        Task::Contacts2d | Task::Contacts3d => return Ok(Shape::Contacts),
        Task::Compare | Task::Orient2d | Task::Orient3d | Task::Incircle | Task::Insphere => {}
    }
    let question = queries::question(fields, task)?;
    let fits = |dimension, cure: &str| {
        queries::fits(question, dimension).map_err(|(message, _)| fields.error(message, cure)).map(|()| dimension)
    };
    if let Some(dimension) = family.dimension() {
        let dimension = fits(dimension, "choose an axis or a plane that the family's points have")?;
        return Ok(Shape::Signs { question, dimension });
    }
    let dimension = match (task, fields.get("dimension")) {
        (Task::Compare | Task::Orient2d, Some(field)) if field.integer(2..=3)? == 3 => Dimension::Three,
        (Task::Orient3d | Task::Insphere, _) => Dimension::Three,
        _ => Dimension::Two,
    };
    let dimension = fits(dimension, "write `dimension = 3`")?;
    Ok(Shape::Signs { question, dimension })
}

/// Family, task, and every parameter that was written: `near-orient2d-ulps-4`.
fn default_name(generator: &Generator, fields: &Fields<'_, '_>, task: Task) -> Result<String, CorpusError> {
    let mut name = format!("{}-{task}", generator.family.name());
    for key in ["dimension", "plane", "axis"].into_iter().chain(generator.family.parameters().iter().copied()) {
        if let Some(field) = fields.again(key) {
            name.push_str(&format!("-{key}-{}", field.plain()?));
        }
    }
    Ok(name)
}
