//! The keys of families' tables, and the recipes that they give.

use predicament_corpus::{Parts, Random, Recipe};
use predicament_families::{
    self as families, Arrangement, Cloud, Directions, Kind, Ordinary, PixelError, PixelMap, Trouble,
};
use predicament_formats::bits::power_of_two;
use predicament_formats::{CorpusError, Field, Fields, Written};
use predicament_predicates::PredicateKind;

use super::{Asked, by_query, formula};
use crate::typed::{typed as typed_of, word};

/// Reads `ulps`.
pub(super) fn near(task: &'static str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let ulps = fields.integer_or("ulps", 4, 1..=1 << 20)?.cast_signed();
    by_query(task, fields, move |kind, rng, out| near_of(kind, ulps, rng, out))
}

fn near_of(kind: PredicateKind, ulps: i64, rng: &mut Random, out: &mut Vec<f64>) {
    match kind {
        PredicateKind::Derived(derived) => formula::near(derived.formula(), ulps, rng, out),
        _ => families::near(kind, ulps, rng, out),
    }
}

/// A query whose answer is 0.
pub(super) fn degenerate(kind: PredicateKind, rng: &mut Random, out: &mut Vec<f64>) {
    match kind {
        PredicateKind::Derived(derived) => formula::tie(derived.formula(), rng, out),
        _ => families::degenerate(kind, rng, out),
    }
}

/// An ordinary query, scaled as a whole.
pub(super) fn wide_scaled(kind: PredicateKind, rng: &mut Random, out: &mut Vec<f64>) {
    families::wide_scaled_by(rng, out, |ordinary, rng, out| match ordinary {
        Ordinary::Uniform => families::uniform(kind, rng, out),
        Ordinary::Near { ulps } => near_of(kind, ulps, rng, out),
        Ordinary::Degenerate => degenerate(kind, rng, out),
    });
}

/// Reads `digits`.
pub(super) fn decimal(task: &'static str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let digits = fields.integer_or("digits", 1, 1..=9).map(|n| u32::try_from(n).unwrap_or(9))?;
    by_query(task, fields, move |kind, rng, out| families::decimal(kind, digits, rng, out))
}

/// Reads `digits`, `figure` and `place`.
pub(super) fn typed(task: &'static str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let (typed, asked) = (typed_of(fields)?, Asked::read(task, fields, None)?);
    Ok(Recipe::new(
        move |n| asked.coordinates(n),
        move |making| {
            let (mut rng, mut numerators) = (making.random(), Vec::new());
            (0..making.n).for_each(|_| typed.query(asked.kind(), &mut rng, &mut numerators));
            let written = Written::new(typed.digits, asked.in_its_plane(numerators));
            let cloud = Cloud { coordinates: written.doubles(), ..Cloud::default() };
            Parts { written: Some(written), ..asked.parts(cloud) }
        },
    ))
}

/// Reads `figure`.
pub(super) fn sphere(task: &'static str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let figures = Directions::ALL.map(Directions::name);
    let directions = word(fields, "figure", &figures)?.and_then(Directions::named).unwrap_or(Directions::General);
    by_query(task, fields, move |_, rng, out| directions.query(rng, out))
}

/// Reads a table of the family `band`, which has no parameters of its own.
pub(super) fn band(task: &'static str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let asked = Asked::read(task, fields, None)?;
    Ok(Recipe::new(
        move |n| asked.coordinates(n + 1),
        move |making| asked.placed(families::band(asked.kind(), making.n, &mut making.random()), making),
    ))
}

/// Reads a table of the family `scattered`, which has no parameters of its own.
pub(super) fn scattered(task: &'static str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let asked = Asked::read(task, fields, None)?;
    let coordinates = move |n| families::SCATTERED_POINTS as u64 * n * asked.dimension.count() as u64;
    Ok(Recipe::new(coordinates, move |making| {
        asked.placed(families::scattered(asked.kind(), making.n, &mut making.random()), making)
    }))
}

/// Reads `p`, `q`, `r`, `side` and `step`.
pub(super) fn pixels(task: &'static str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let map = pixel_map(fields)?;
    let asked = Asked::read(task, fields, None)?;
    let size = map.pixels();
    let width = asked.dimension.count() as u64;
    Ok(Recipe::new(move |n| (n + 2) * width, move |making| asked.placed(map.points(), making)).of_size(size))
}

/// Reads `p`, `q`, `r`, `side` (256) and `step` (2^-53).
fn pixel_map(fields: &Fields<'_, '_>) -> Result<PixelMap, CorpusError> {
    let corner = fields.required("p")?;
    let against = [point(&fields.required("q")?)?, point(&fields.required("r")?)?];
    let side = fields.integer_or("side", families::SIDE, 1..=4096)?.cast_signed();
    let given = fields.get("step");
    let step = given.as_ref().map_or(Ok(power_of_two(families::STEP)), Field::coordinate)?;
    PixelMap::new(point(&corner)?, against, side, step).map_err(|why| match (why, given) {
        (PixelError::Step, Some(step)) => step.error("`step` is not a power of two", "write one such as \"0x1p-53\""),
        (PixelError::Step, None) => unreachable!("the usual step is a power of two"),
        (PixelError::Inexact { x, steps }, _) => {
            corner.error(format!("{x:e} + {steps} steps is not a double"), "choose a larger `step`")
        }
    })
}

fn point(field: &Field<'_, '_>) -> Result<[f64; 2], CorpusError> {
    let coordinates = field.items("a point: an array of two coordinates")?;
    let coordinates = coordinates.map(|x| x.coordinate()).collect::<Result<Vec<_>, _>>()?;
    let found = coordinates.len();
    coordinates
        .try_into()
        .map_err(|_| field.error(format!("a point of {found} coordinates"), "a pixel map is flat: write two"))
}

/// Reads a family of constructions from independent random points.
pub(super) fn constructed_uniform(
    task: &'static str,
    fields: &Fields<'_, '_>,
    kinds: &'static [Kind],
) -> Result<Recipe, CorpusError> {
    constructed(task, fields, Arrangement { kinds, trouble: Trouble::Uniform, halvings: halvings(fields)? })
}

/// Reads a family of constructions in exact ties.
pub(super) fn constructed_degenerate(
    task: &'static str,
    fields: &Fields<'_, '_>,
    kinds: &'static [Kind],
) -> Result<Recipe, CorpusError> {
    constructed(task, fields, Arrangement { kinds, trouble: Trouble::Degenerate, halvings: halvings(fields)? })
}

/// Reads a family of constructions beside ties, with `ulps`.
pub(super) fn constructed_near(
    task: &'static str,
    fields: &Fields<'_, '_>,
    kinds: &'static [Kind],
) -> Result<Recipe, CorpusError> {
    let ulps = fields.integer_or("ulps", 1, 1..=1 << 20)?.cast_signed();
    constructed(task, fields, Arrangement { kinds, trouble: Trouble::Near { ulps }, halvings: halvings(fields)? })
}

/// Reads `halvings`.
fn halvings(fields: &Fields<'_, '_>) -> Result<i64, CorpusError> {
    fields.integer_or("halvings", 0, 0..=900).map(u64::cast_signed)
}

fn constructed(task: &'static str, fields: &Fields<'_, '_>, arrangement: Arrangement) -> Result<Recipe, CorpusError> {
    let asked = Asked::read(task, fields, Some(arrangement.dimension()))?;
    Ok(Recipe::new(Arrangement::coordinates, move |making| {
        asked.parts(arrangement.queries(asked.question, making.n, making.random()))
    }))
}
