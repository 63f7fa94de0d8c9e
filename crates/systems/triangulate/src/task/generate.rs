//! Families of polygons: stars, spirals, combs, grids, nested rings, touching holes, slivers, mazes.

use predicament_corpus::{Family, Making, Parts, Recipe};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{Scene, Vertex};

use super::Polygons;
use super::content::read_method;
use super::shapes::{self, Shape};
use super::touching;

macro_rules! family {
    ($name:literal, $parameters:expr, $about:literal, $make:expr) => {
        Family {
            name: $name,
            reported_as: Some($name),
            parameters: $parameters,
            about: $about,
            read: |_, fields| $make(fields),
        }
    };
}

/// The families of polygons.
pub(super) static FAMILIES: [Family; 8] = [
    family!(
        "polygon-star",
        &["bits", "edges"],
        "a star around the origin, its corners at random distances",
        |fields: &Fields<'_, '_>| {
            let bits = u32::try_from(fields.integer_or("bits", 52, 8..=52)?).unwrap_or(52);
            let divided = is(fields, "edges", "divided")?;
            recipe(fields, move |making| shapes::star(making.n, bits, divided, &mut making.random()))
        }
    ),
    family!("polygon-spiral", &[], "a square spiral", |fields: &Fields<'_, '_>| {
        recipe(fields, |making| shapes::spiral(making.n))
    }),
    family!(
        "polygon-comb",
        &["teeth"],
        "a comb: the tips of its teeth are collinear, and so are the gaps between them",
        |fields: &Fields<'_, '_>| {
            let sideways = is(fields, "teeth", "sideways")?;
            recipe(fields, move |making| shapes::comb(making.n, sideways))
        }
    ),
    family!(
        "polygon-grid",
        &["holes"],
        "a square with square holes in rows and columns; holes may touch in their corners",
        |fields: &Fields<'_, '_>| {
            let touching = is(fields, "holes", "touching")?;
            recipe(fields, move |making| shapes::grid(making.n, touching))
        }
    ),
    family!(
        "polygon-rings",
        &["vertices"],
        "nested rings that touch in points that have one vertex or two",
        |fields: &Fields<'_, '_>| {
            let apart = is(fields, "vertices", "apart")?;
            recipe(fields, move |making| shapes::rings(making.n, apart))
        }
    ),
    family!(
        "polygon-touching",
        &[],
        "squares with random holes that touch: vertex to vertex, vertex to edge, holes to the square",
        |fields: &Fields<'_, '_>| { recipe(fields, |making| touching::touching(making.n, &mut making.random())) }
    ),
    family!("polygon-sliver", &["places"], "a polygon along a diagonal, a few ulps wide", |fields: &Fields<'_, '_>| {
        let far = is(fields, "places", "far")?;
        recipe(fields, move |making| shapes::sliver(making.n, far, &mut making.random()))
    }),
    family!("polygon-maze", &[], "the outline of a random maze, with many collinear vertices", |fields: &Fields<
        '_,
        '_,
    >| {
        recipe(fields, |making| shapes::maze(making.n, &mut making.random()))
    }),
];

/// True if a key is present; it has one legal value.
fn is(fields: &Fields<'_, '_>, key: &'static str, value: &str) -> Result<bool, CorpusError> {
    let Some(field) = fields.get(key) else { return Ok(false) };
    match field.str()? {
        word if word == value => Ok(true),
        word => {
            Err(field
                .error(format!("`{word}` is not a value of `{key}`"), format!("write \"{value}\", or leave it out")))
        }
    }
}

fn recipe(
    fields: &Fields<'_, '_>,
    shape: impl Fn(&Making) -> Shape + Send + Sync + 'static,
) -> Result<Recipe, CorpusError> {
    let method = read_method(fields)?;
    let make = move |making: &Making| {
        let (points, loops) = shape(making);
        let scene = Scene::from_points2(&points).expect("generators make finite points");
        let vertices = |one: Vec<usize>| one.into_iter().map(Vertex::input).collect();
        let loops = loops.into_iter().map(vertices).collect();
        Parts::new(scene, Polygons { polygons: vec![loops], method })
    };
    // The smallest shapes have up to sixteen vertices; each further nest of rings has at least four more.
    Ok(Recipe::new(|n| 3 * n + 100, make))
}
