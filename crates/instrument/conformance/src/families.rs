//! The queries of a family, from the generators that the harness runs.

use predicament_families::{
    self as families, Arrangement, Cloud, Kind, PixelMap, Random, SIDE, STEP, Trouble, bits::power_of_two,
};
use predicament_predicates::{Axis, Construction, Plane, PredicateKind, Question, Vertex};

use crate::Shape;
use crate::query::{Query, Subject};
use crate::table::Recipe;

/// The question of a way of a subject.
fn question(subject: Subject, way: usize) -> Question {
    match (subject.kind, subject.ways[way].0) {
        (PredicateKind::Compare, "y") => Question::Compare(Axis::Y),
        (PredicateKind::Compare, "z") => Question::Compare(Axis::Z),
        (PredicateKind::Orient2d, "yz") => Question::Orient2d(Plane::Yz),
        (PredicateKind::Orient2d, "zx") => Question::Orient2d(Plane::Zx),
        (kind, _) => kind.first_question(),
    }
}

/// The kinds of vertices that a family constructs; `None` for families of input points.
pub(crate) fn constructs(family: &str) -> Option<&'static [Kind]> {
    let (kinds, _) = family.rsplit_once('-')?;
    match kinds {
        "ssi" => Some(&[Kind::Ssi]),
        "lpi" => Some(&[Kind::Lpi]),
        "tpi" => Some(&[Kind::Tpi]),
        "lpi-tpi" => Some(&[Kind::Lpi, Kind::Tpi]),
        _ => None,
    }
}

/// `n` queries of a family, asked in a way of the subject; none if the family is for points of another dimension.
///
/// # Panics
/// If no family has the recipe's name.
pub(crate) fn queries(recipe: &Recipe, subject: Subject, way: usize, seed: u64, n: usize) -> Vec<Query<f64>> {
    let mut random = Random::new(recipe.family, subject.kind.name(), seed);
    let cloud = match constructs(recipe.family) {
        Some(kinds) => {
            let arrangement = arrangement(recipe, kinds);
            if arrangement.dimension().count() != subject.dimension {
                return Vec::new();
            }
            arrangement.queries(question(subject, way), n, random)
        }
        None => cloud(recipe, subject.kind, n, &mut random),
    };
    let dimension = subject.dimension;
    let vertices =
        cloud.args.clone().unwrap_or_else(|| (0..cloud.coordinates.len() / dimension).map(Vertex::input).collect());
    let step = (vertices.len() / subject.kind.arity()).div_ceil(n.max(1)).max(1);
    vertices
        .chunks_exact(subject.kind.arity())
        .step_by(step)
        .map(|query| query_of(&cloud, dimension, way, query))
        .collect()
}

fn query_of(cloud: &Cloud, dimension: usize, way: usize, vertices: &[Vertex]) -> Query<f64> {
    let mut query = Query { way, shapes: Vec::new(), coordinates: Vec::new() };
    let mut push = |v: &Vertex| {
        let at = v.index() * dimension;
        query.coordinates.extend_from_slice(&cloud.coordinates[at..at + dimension]);
    };
    for v in vertices {
        match v.construction().map(|index| &cloud.constructions[index]) {
            None => push(v),
            Some(construction) => construction.flats().flatten().for_each(&mut push),
        }
    }
    let shape = |v: &Vertex| match v.construction().map(|index| &cloud.constructions[index]) {
        None => Shape::Input,
        Some(Construction::Ssi(_)) => Shape::Ssi,
        Some(Construction::Lpi { .. }) => Shape::Lpi,
        Some(Construction::Tpi(_)) => Shape::Tpi,
        Some(Construction::Ratio { .. }) => unreachable!("families construct where lines and planes meet"),
    };
    query.shapes = vertices.iter().map(shape).collect();
    query
}

fn arrangement(recipe: &Recipe, kinds: &'static [Kind]) -> Arrangement {
    let trouble = match recipe.family.rsplit_once('-') {
        Some((_, "uniform")) => Trouble::Uniform,
        Some((_, "near")) => Trouble::Near { ulps: recipe.whole("ulps", 1) },
        Some((_, "degen")) => Trouble::Degenerate,
        _ => panic!("no family is called {}", recipe.family),
    };
    Arrangement { kinds, trouble, halvings: recipe.whole("halvings", 0) }
}

fn cloud(recipe: &Recipe, kind: PredicateKind, n: usize, random: &mut Random) -> Cloud {
    let mut coordinates = Vec::new();
    let mut each = |query: &dyn Fn(PredicateKind, &mut Random, &mut Vec<f64>)| {
        (0..n).for_each(|_| query(kind, random, &mut coordinates));
    };
    match recipe.family {
        "uniform" => each(&families::uniform),
        "grid" => each(&families::grid),
        "near" => {
            let ulps = recipe.whole("ulps", 4);
            each(&|kind, random, out| families::near(kind, ulps, random, out));
        }
        "kettner" => each(&families::kettner),
        "degen" => each(&families::degenerate),
        "decimal-collinear" | "decimal-coplanar" | "decimal-cocircular" | "decimal-cospherical" => {
            let digits = u32::try_from(recipe.whole("digits", 1)).unwrap_or(1);
            each(&|kind, random, out| families::decimal(kind, digits, random, out));
        }
        "midpoint-collinear" => each(&families::midpoint),
        "wide-scaled" => each(&families::wide_scaled),
        "wide-mixed" => each(&families::wide_mixed),
        "far" => each(&families::far),
        "scattered" => return families::scattered(kind, n, random),
        "band" => return families::band(kind, n, random),
        "pixel-map" => {
            let side = recipe.whole("side", SIDE.cast_signed());
            let [p, q, r] = ["p", "q", "r"].map(|key| recipe.point(key));
            let map = PixelMap::new(p, [q, r], side, power_of_two(STEP));
            return map.unwrap_or_else(|why| panic!("scenes.txt: {why:?}")).points();
        }
        other => panic!("no family is called {other}"),
    }
    Cloud { coordinates, ..Cloud::default() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::{TABLE, read};

    /// Every family of the table makes queries, and the first of them stay the same if there are more.
    #[test]
    fn every_family_of_the_table_is_known() {
        for recipe in read(TABLE).1 {
            let dimensions = match constructs(recipe.family) {
                Some(kinds) => arrangement(&recipe, kinds).dimension().count(),
                None => predicament_families::native(recipe.kind),
            };
            let subject = Subject { kind: recipe.kind, dimension: dimensions, ways: &[("", &[0, 1, 2])] };
            let [few, many] = [10, 40].map(|n| queries(&recipe, subject, 0, 1, n));
            assert_eq!((few.len(), many.len()), (10, 40), "{}", recipe.title());
            assert_ne!(queries(&recipe, subject, 0, 2, 40) == many, recipe.family != "pixel-map", "{}", recipe.title());
        }
    }
}
