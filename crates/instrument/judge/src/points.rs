//! The judge for one scene, with each constructed point solved once.
//!
//! A point of three planes takes four determinants of rationals, and the queries of a scene use the same points many
//! times. [`Points`] caches them, both as rationals and over one denominator.

use std::borrow::Cow;
use std::sync::OnceLock;

use predicament_predicates::{Construction, NoPoint, Question, Refused, Scene, Sign, Vertex};
use rug::Rational;

use crate::constructed;
use crate::determinant::{Verdict, sign_of_rows, verdict, verdict_of};
use crate::row::Row;

/// A constructed vertex over one denominator; its rationals are computed on first use.
struct Solved {
    row: Row,
    point: OnceLock<Vec<Rational>>,
}

/// The exact answers about one scene. The first thread that uses a constructed point computes it, and the point is
/// cached.
pub struct Points {
    scene: Scene,
    constructed: Vec<OnceLock<Option<Solved>>>,
}

impl Points {
    /// The judge of a scene, with no constructed point computed yet.
    #[must_use]
    pub fn of(scene: &Scene) -> Points {
        Points { scene: scene.clone(), constructed: scene.constructions().iter().map(|_| OnceLock::new()).collect() }
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Adds the vertices that these constructions define.
    ///
    /// # Errors
    /// [`Refused`] with the first construction whose lines and planes don't meet in a single point.
    pub fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        let mut solved = Vec::new();
        let vertices = self.scene.construct_all(definitions, |scene, vertex| {
            let row = constructed::row(scene, vertex).ok_or(NoPoint::Unspecified)?;
            solved.push(Solved { row, point: OnceLock::new() });
            Ok(())
        })?;
        // One for each new vertex, in their order.
        self.constructed.extend(solved.into_iter().map(|point| OnceLock::from(Some(point))));
        Ok(vertices)
    }

    /// The exact coordinates of a vertex, as from the function [`point`](crate::point).
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[must_use]
    pub fn point(&self, v: Vertex) -> Option<Cow<'_, [Rational]>> {
        match v.construction() {
            None => constructed::point(&self.scene, v).map(Cow::Owned),
            Some(index) => {
                let solved = self.solved(index, v)?;
                Some(Cow::Borrowed(&**solved.point.get_or_init(|| solved.row.point())))
            }
        }
    }

    /// The exact sign of a query, as from the function [`sign`](crate::sign).
    ///
    /// # Panics
    /// If the query does not fit the scene, or uses a construction that gives no point.
    #[must_use]
    pub fn sign(&self, question: Question, args: &[Vertex]) -> Sign {
        sign_of_rows(&self.scene, question, args, |v| match v.construction() {
            None => Cow::Owned(constructed::certain_row(&self.scene, v)),
            Some(index) => Cow::Borrowed(&self.solved(index, v).unwrap_or_else(|| panic!("{v} is not a point")).row),
        })
    }

    /// The exact determinant of a query with its permanent, as from the function [`verdict`](crate::verdict).
    ///
    /// # Panics
    /// As [`sign`](Points::sign).
    #[must_use]
    pub fn verdict(&self, question: Question, args: &[Vertex]) -> Verdict {
        if let Question::Derived(_) = question {
            return verdict(&self.scene, question, args);
        }
        verdict_of(question, args, |v| self.point(v).unwrap_or_else(|| panic!("{v} is not a point")))
    }

    fn solved(&self, index: usize, v: Vertex) -> Option<&Solved> {
        let solve = || Some(Solved { row: constructed::row(&self.scene, v)?, point: OnceLock::new() });
        self.constructed[index].get_or_init(solve).as_ref()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_that_are_constructed_together_have_their_own_rows() {
        let scene = Scene::from_points2(&[[0.0, 0.0], [4.0, 0.0], [1.0, -1.0], [1.0, 2.0], [3.0, -1.0], [2.0, 5.0]]);
        let scene = scene.expect("finite points");
        let ends = |at: usize| [at, at + 1].map(Vertex::input);
        let mut points = Points::of(&scene);
        let vertices =
            points.construct(&[Construction::Ssi([ends(0), ends(2)]), Construction::Ssi([ends(0), ends(4)])]);
        let places = vertices.expect("two points").into_iter().map(|v| {
            let point = points.point(v).expect("a point").into_owned();
            assert_eq!(Some(&point), crate::point(points.scene(), v).as_ref(), "{v}");
            point
        });
        let places: Vec<Vec<Rational>> = places.collect();
        assert_ne!(places[0], places[1]);
    }
}
