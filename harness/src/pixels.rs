//! A query as a raster: one of its vertices moves over a square of nearby places, and every backend answers at each
//! place.
//!
//! Kettner, Mehlhorn, Pion, Schirra and Yap have shown the effect of doubles on an orientation in this way. The scene
//! keeps its extent and the order of its vertices, so a backend that depends on either answers as it does in the scene.

use predicament_corpus::LoadedScene;
use predicament_predicates::{Axis, Dimension, Query, QuerySet, Question, Scene, Sign, Vertex};
use predicament_report::{Column, PixelMap, Standing};
use predicament_tasks::signs::{SignQueries, classes};
use predicament_tasks::{AnyCase, Class, Contestant};

use crate::exit::Failure;

/// The step from one place of a raster to the next.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Step {
    /// A number of doubles.
    Ulps(u64),
    /// A length, which is rounded at every place.
    Length(f64),
}

/// A query and the movement of one of its vertices.
#[derive(Clone, Debug)]
pub struct Walk<'a> {
    pub scene: &'a Scene,
    pub query: &'a Query,
    /// The position in the query of the moving vertex, from 0.
    pub place: usize,
    /// The axes of the movement, to the right and upwards.
    pub axes: [Axis; 2],
    pub step: Step,
    pub side: usize,
}

/// A scene with a raster of queries, the lowest row first.
pub struct Raster {
    pub scene: Scene,
    pub content: SignQueries,
    pub side: usize,
}

impl Walk<'_> {
    /// The scene with all places in place of the moving vertex, and one query for each place.
    pub fn raster(&self) -> Result<Raster, Failure> {
        let (scene, side) = (self.scene, self.side);
        let (question, args) = self.query.question().ok_or_else(|| {
            Failure::usage(format!("`{}` does not ask for a sign; name a query of a predicate", self.query))
        })?;
        if let Some(bad) = args.iter().find(|v| v.is_constructed() || !scene.has(**v)) {
            return Err(Failure::usage(format!("{}: {bad} is not an input vertex of the scene", self.query)));
        }
        scene.has_dimension_for(question.kind()).map_err(|why| Failure::usage(why.to_string()))?;
        has_axes(scene, named_axes(question).iter().chain(&self.axes))?;
        let &walker = args
            .get(self.place)
            .ok_or_else(|| Failure::usage(format!("{} has {} vertices, from 0 on", self.query, args.len())))?;
        if args.iter().filter(|&&v| v == walker).count() > 1 {
            return Err(Failure::usage(format!("{}: {walker} occurs twice; move another vertex", self.query)));
        }
        let places = self.places(walker)?;
        let count = side * side;
        // The places take the position of the moving vertex in the order of vertices.
        let moved =
            |v: Vertex| Vertex::input(if v.index() > walker.index() { v.index() + count - 1 } else { v.index() });
        let width = scene.dimension().count();
        let (before, after) = scene.coordinates().split_at(walker.index() * width);
        let coordinates = [before, &places.concat(), &after[width..]].concat();
        let mut made = Scene::new(scene.dimension(), coordinates).map_err(Failure::usage)?;
        if let Some(weight) = scene.weights().get(walker.index()) {
            let (before, after) = scene.weights().split_at(walker.index());
            let weights = [before, &vec![*weight; count], &after[1..]].concat();
            made = made.with_weights(weights).map_err(Failure::usage)?;
        }
        if let Some(lengths) = scene.primitive_lengths() {
            made = made.with_primitive_lengths(lengths);
        }
        if let Some(second) = scene.second_mesh() {
            let second = scene.vertices().filter(|v| second[v.index()] && *v != walker).map(moved);
            made = made.with_second_mesh(second.collect::<Vec<_>>());
        }
        let asked = (0..count).flat_map(|at| {
            args.iter().map(move |&v| if v == walker { Vertex::input(walker.index() + at) } else { moved(v) })
        });
        let queries = QuerySet::new(question, asked.collect());
        Ok(Raster { scene: made, content: SignQueries { queries, expected: None }, side })
    }

    /// The coordinates of all places, row by row from below, with the original vertex in the middle.
    fn places(&self, walker: Vertex) -> Result<Vec<Vec<f64>>, Failure> {
        let at = self.scene.point(walker);
        let [right, up] = self.axes.map(Axis::index);
        let half = i64::try_from(self.side / 2).map_err(Failure::usage)?;
        let along = |axis: usize| -> Result<Vec<f64>, Failure> {
            let places: Vec<f64> = (-half..-half + i64::try_from(self.side).map_err(Failure::usage)?)
                .map(|steps| stepped(at[axis], steps, self.step))
                .collect();
            match places.iter().find(|x| !x.is_finite()) {
                Some(_) => Err(Failure::usage("the raster exceeds the range of doubles; use a smaller step or side")),
                None => Ok(places),
            }
        };
        let (columns, rows) = (along(right)?, along(up)?);
        let place = |y: f64, x: f64| {
            let mut place = at.to_vec();
            (place[right], place[up]) = (x, y);
            place
        };
        Ok(rows.iter().flat_map(|&y| columns.iter().map(move |&x| place(y, x))).collect())
    }
}

/// The axes that a question names; it depends on no others.
fn named_axes(question: Question) -> Vec<Axis> {
    match question {
        Question::Compare(axis) => vec![axis],
        Question::Orient2d(plane) => plane.axes().to_vec(),
        Question::Orient3d | Question::Incircle | Question::Insphere | Question::Derived(_) => Vec::new(),
    }
}

/// Refuses axes that the scene lacks.
fn has_axes<'a>(scene: &Scene, mut axes: impl Iterator<Item = &'a Axis>) -> Result<(), Failure> {
    match axes.find(|axis| axis.index() >= scene.dimension().count()) {
        Some(missing) => Err(Failure::usage(format!("the scene has no {} axis", missing.name()))),
        None => Ok(()),
    }
}

/// The default axes of a raster: those that the question depends on.
pub fn axes(question: Question, scene: &Scene) -> [Axis; 2] {
    match (question, scene.dimension()) {
        (Question::Orient2d(plane), _) => plane.axes(),
        (Question::Compare(Axis::Z), Dimension::Three) => [Axis::Z, Axis::X],
        _ => [Axis::X, Axis::Y],
    }
}

/// The coordinate that is `steps` steps away.
fn stepped(x: f64, steps: i64, step: Step) -> f64 {
    match step {
        // Steps are far fewer than 2^53.
        #[allow(clippy::cast_precision_loss)]
        Step::Length(length) => x + steps as f64 * length,
        Step::Ulps(ulps) => {
            // Map doubles to integers in the same order, with one zero.
            let bits = x.to_bits().cast_signed();
            let place = if bits < 0 { i64::MIN - bits } else { bits };
            let moved = i128::from(place) + i128::from(steps) * i128::from(ulps);
            let Ok(moved) = i64::try_from(moved) else { return f64::INFINITY };
            f64::from_bits(if moved < 0 { i64::MIN.wrapping_sub(moved).cast_unsigned() } else { moved.cast_unsigned() })
        }
    }
}

/// The picture of one backend.
pub struct Tile {
    /// The pixels.
    pub map: PixelMap,
    /// The pixels that differ from the truth.
    pub difference: PixelMap,
    /// The number of negative, zero and positive answers.
    pub signs: [usize; 3],
    /// The number of answers that differ from the exact sign.
    pub differ: usize,
    /// The number of answers that the backend's contract does not allow.
    pub wrong: usize,
}

impl Tile {
    /// The caption: the number of each sign, of differences from the exact sign, and of wrong answers.
    pub fn caption(&self) -> String {
        let [negative, zero, positive] = self.signs;
        format!(
            "{negative:>8} -  {zero:>8} 0  {positive:>8} +  {:>8} differ from the exact sign, {} wrong",
            self.differ, self.wrong
        )
    }
}

/// Draws the answers of one backend to a square of queries.
pub fn tile(
    scene: &Scene,
    content: &SignQueries,
    truth: &[Sign],
    side: usize,
    backend: &dyn Contestant,
) -> Result<Tile, Failure> {
    let answers =
        classes(backend, scene, content, truth).map_err(|why| Failure::usage(format!("{}: {why}", backend.name())))?;
    of(&answers, truth, side)
}

/// The picture of the truth.
pub fn exact(truth: &[Sign], side: usize) -> Result<Tile, Failure> {
    let answers: Vec<(Sign, Class)> = truth.iter().map(|&sign| (sign, Class::Agree)).collect();
    of(&answers, truth, side)
}

fn of(answers: &[(Sign, Class)], truth: &[Sign], side: usize) -> Result<Tile, Failure> {
    let count = |sign: Sign| answers.iter().filter(|(answer, _)| *answer == sign).count();
    // The first queries are the lowest row: y grows upwards, as in every plot.
    let pixels: Vec<(Sign, Class, Sign)> = answers
        .chunks(side)
        .zip(truth.chunks(side))
        .rev()
        .flat_map(|(row, truth)| row.iter().zip(truth))
        .map(|(&(sign, class), &truth)| (sign, class, truth))
        .collect();
    let signs: Vec<i8> = pixels.iter().map(|(sign, ..)| sign.as_i8()).collect();
    let wrong: Vec<bool> = pixels.iter().map(|(_, class, _)| !class.is_legal()).collect();
    let standings: Vec<Standing> = pixels
        .iter()
        .map(|(sign, class, truth)| match (sign == truth, class.is_legal()) {
            (true, true) => Standing::Same,
            (false, true) => Standing::Legal,
            (_, false) => Standing::Wrong,
        })
        .collect();
    Ok(Tile {
        map: PixelMap::new(side, side, &signs, &wrong).map_err(Failure::usage)?,
        difference: PixelMap::difference(side, side, &standings).map_err(Failure::usage)?,
        signs: [Sign::Negative, Sign::Zero, Sign::Positive].map(count),
        differ: answers.iter().zip(truth).filter(|((answer, _), truth)| answer != *truth).count(),
        wrong: wrong.iter().filter(|&&wrong| wrong).count(),
    })
}

/// The tiles as columns of a sheet.
pub fn columns(tiles: Vec<(String, Tile)>) -> Vec<Column> {
    let column = |(name, tile): (String, Tile)| {
        let [negative, zero, positive] = tile.signs;
        let lines = vec![
            format!("{negative} negative"),
            format!("{zero} zero"),
            format!("{positive} positive"),
            format!("{} differ, {} wrong", tile.differ, tile.wrong),
        ];
        Column { name, answers: tile.map, difference: tile.difference, lines }
    };
    tiles.into_iter().map(column).collect()
}

/// The queries of a scene as a square raster.
pub fn square(loaded: &LoadedScene) -> Result<Raster, Failure> {
    let Some(content) = loaded.content::<SignQueries>() else {
        return Err(Failure::usage(format!("`{}` does not ask for signs; only sign scenes can be drawn", loaded.name)));
    };
    let count = content.queries.len();
    let side = count.isqrt();
    if side == 0 || side * side != count {
        let message = format!("`{}` has {count} queries, which is not a square number", loaded.name);
        return Err(Failure::usage(format!("{message}; choose one with --query; its last vertex then moves")));
    }
    Ok(Raster { scene: loaded.scene.clone(), content: content.clone(), side })
}

/// Draws the answers of one backend to a scene with a square number of queries.
pub fn of_square(case: &dyn AnyCase, backend: &dyn Contestant) -> Result<Tile, Failure> {
    let Raster { scene, content, side } = square(case.loaded())?;
    let signs = case.truth().downcast_ref::<Vec<Sign>>().map_or(&[][..], Vec::as_slice);
    tile(&scene, &content, signs, side, backend)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn doubles_are_counted_through_zero() {
        let tiny = f64::from_bits(1);
        for (x, steps, to) in [
            (1.0, 1, 1.0 + f64::EPSILON),
            (1.0, -1, 1.0 - f64::EPSILON / 2.0),
            (tiny, -1, 0.0),
            (tiny, -2, -tiny),
            (-tiny, 2, tiny),
            (0.0, 1, tiny),
            (-0.0, -1, -tiny),
            (-1.0, 1, -1.0 + f64::EPSILON / 2.0),
        ] {
            assert_eq!(stepped(x, steps, Step::Ulps(1)), to, "{x:?} and {steps}");
        }
        assert_eq!(stepped(f64::MAX, 1, Step::Ulps(1)), f64::INFINITY);
        assert_eq!(stepped(1.0, 3, Step::Length(0.5)), 2.5);
    }

    #[test]
    fn the_walking_vertex_keeps_its_place_among_the_others() {
        let scene = Scene::from_points2(&[[0.0, 0.0], [5.0, 5.0], [1.0, 1.0], [9.0, 0.0]]).unwrap();
        let query: Query = "orient2d(xy; 0 2 3)".parse().unwrap();
        let walk =
            Walk { scene: &scene, query: &query, place: 1, axes: [Axis::X, Axis::Y], step: Step::Length(1.0), side: 3 };
        let raster = walk.raster().unwrap();
        assert_eq!(raster.scene.len(), 3 + 9);
        // The lowest row from left to right, with the vertex itself in the middle.
        let at = |query: usize| {
            raster.content.queries.args(query).iter().map(|&v| raster.scene.point(v).to_vec()).collect::<Vec<_>>()
        };
        assert_eq!(at(0), [vec![0.0, 0.0], vec![0.0, 0.0], vec![9.0, 0.0]]);
        assert_eq!(at(4), [vec![0.0, 0.0], vec![1.0, 1.0], vec![9.0, 0.0]]);
        assert_eq!(at(5)[1], [2.0, 1.0]);
        assert!(Walk { place: 3, ..walk.clone() }.raster().is_err());
        assert!(Walk { axes: [Axis::X, Axis::Z], ..walk.clone() }.raster().is_err());
        assert!(Walk { step: Step::Length(f64::MAX), side: 5, ..walk }.raster().is_err());
    }
}
