//! Families of segments and of pairs of polygons.

use crate::algorithm::overlay::Rule;
use predicament_corpus::{Family, Making, Parts, Random, Recipe};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{Scene, Vertex};

use predicament_tasks::typed::{Neighbours, RING, TYPED_KEYS, typed};

use super::content::{Layered, Layers, read_method};
use super::shapes::{self, Lines, Pair};

macro_rules! family {
    ($name:literal, $about:literal, $recipe:ident, $shape:path) => {
        Family {
            name: $name,
            reported_as: Some($name),
            parameters: &[],
            about: $about,
            read: |_, fields| $recipe(fields, $shape),
        }
    };
}

/// The families of overlays.
pub(super) static FAMILIES: [Family; 10] = [
    family!("overlay-segments", "short segments: each crosses about one other", lines, shapes::uniform),
    family!("overlay-grid", "vertical and horizontal lines of a grid that end on each other", lines, shapes::grid),
    family!("overlay-pencil", "segments through one point", lines, shapes::pencil),
    family!("overlay-bundles", "bundles of eight segments an ulp apart", lines, shapes::bundles),
    family!("overlay-stars", "two stars of n corners around one point", pairs, shapes::stars),
    family!("overlay-shifted", "a star of n corners and a copy of it, moved by an ulp", pairs, shapes::shifted),
    family!("overlay-rings", "two rings with a disc inside, most edges of which meet nothing", pairs, shapes::rings),
    family!("overlay-combs", "two combs of about n corners across each other", pairs, shapes::combs),
    family!("overlay-squares", "squares on integers that share edges and parts of edges", pairs, shapes::squares),
    Family {
        name: "overlay-parcels",
        reported_as: Some("overlay-parcels"),
        parameters: TYPED_KEYS,
        about: "parcels that share borders as written in decimals, for `truth = \"decimals\"`",
        read: parcels,
    },
];

/// Two layers of parcels; a border of each parcel is on one of the other layer.
fn parcels(_: &str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let (method, typed) = (read_method(fields)?, typed(fields)?);
    let make = move |making: &Making| {
        let neighbours = Neighbours::<2>::new(typed, making);
        let ring = |first: usize| RING.map(|corner| Vertex::input(first + corner)).to_vec();
        let loops = neighbours.first_corners().map(|firsts| firsts.into_iter().map(ring).collect());
        let parts = parts(&neighbours.points, Layers::Polygons(loops, Rule::NonZero), method);
        Parts { written: Some(neighbours.written), ..parts }
    };
    Ok(Recipe::new(|n| 2 * n + 16, make))
}

fn lines(fields: &Fields<'_, '_>, shape: fn(usize, &mut Random) -> Lines) -> Result<Recipe, CorpusError> {
    let method = read_method(fields)?;
    let make = move |making: &Making| {
        let Lines { points, segments } = shape(making.n, &mut making.random());
        let segments = segments.into_iter().map(|ends| ends.map(Vertex::input)).collect();
        parts(&points, Layers::Segments(segments), method)
    };
    Ok(Recipe::new(|n| 4 * n + 16, make))
}

fn pairs(fields: &Fields<'_, '_>, shape: fn(usize, &mut Random) -> Pair) -> Result<Recipe, CorpusError> {
    let method = read_method(fields)?;
    let make = move |making: &Making| {
        let Pair { points, loops } = shape(making.n, &mut making.random());
        let vertices = |one: Vec<usize>| one.into_iter().map(Vertex::input).collect();
        let loops = loops.map(|loops| loops.into_iter().map(vertices).collect());
        parts(&points, Layers::Polygons(loops, Rule::NonZero), method)
    };
    Ok(Recipe::new(|n| 8 * n + 64, make))
}

fn parts(points: &[[f64; 2]], layers: Layers, method: crate::algorithm::overlay::Method) -> Parts {
    let scene = Scene::from_points2(points).expect("generators make finite points");
    Parts::new(scene, Layered { layers, method })
}
