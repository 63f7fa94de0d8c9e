//! The judge prepared for one scene: each constructed point is solved for once.
//!
//! A point of three planes takes four determinants of rationals, and a scene
//! asks about the same points again and again. [`Points`] keeps them, as
//! rationals and over one denominator.

use std::borrow::Cow;
use std::sync::OnceLock;

use predicament_predicates::{Construction, NoPoint, Question, Refused, Scene, Sign, Vertex};
use rug::Rational;

use crate::constructed;
use crate::determinant::{Verdict, sign_of_rows, verdict_of};
use crate::row::Row;

/// A constructed vertex over one denominator, and as rationals if anybody asks for them.
struct Solved {
    row: Row,
    point: OnceLock<Vec<Rational>>,
}

/// Truth about one scene. Constructed points are computed when they are first
/// asked for, by whichever thread that is, and kept.
pub struct Points {
    scene: Scene,
    constructed: Vec<OnceLock<Option<Solved>>>,
}

impl Points {
    /// Nothing is computed yet.
    #[must_use]
    pub fn of(scene: &Scene) -> Points {
        Points { scene: scene.clone(), constructed: scene.constructions().iter().map(|_| OnceLock::new()).collect() }
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Adds the vertices that these definitions define.
    ///
    /// # Errors
    /// [`Refused`] with the first definition whose lines and planes meet in no single point.
    pub fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        let vertices =
            self.scene.construct_all(definitions, |scene, vertex| match constructed::row(scene, vertex) {
                Some(_) => Ok(()),
                None => Err(NoPoint::Unspecified.into()),
            })?;
        self.constructed.resize_with(self.scene.constructions().len(), OnceLock::new);
        Ok(vertices)
    }

    /// The exact coordinates of a vertex, as by the function [`point`](crate::point).
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

    /// The exact sign of a query, as by the function [`sign`](crate::sign).
    ///
    /// # Panics
    /// If the query does not fit the scene, or is about a construction that is no point.
    #[must_use]
    pub fn sign(&self, question: Question, args: &[Vertex]) -> Sign {
        sign_of_rows(&self.scene, question, args, |v| match v.construction() {
            None => Cow::Owned(constructed::certain_row(&self.scene, v)),
            Some(index) => Cow::Borrowed(&self.solved(index, v).unwrap_or_else(|| panic!("{v} is no point")).row),
        })
    }

    /// The exact determinant of a query with its permanent, as by the function [`verdict`](crate::verdict).
    ///
    /// # Panics
    /// As [`sign`](Points::sign).
    #[must_use]
    pub fn verdict(&self, question: Question, args: &[Vertex]) -> Verdict {
        verdict_of(question, args, |v| self.point(v).unwrap_or_else(|| panic!("{v} is no point")))
    }

    fn solved(&self, index: usize, v: Vertex) -> Option<&Solved> {
        let solve = || Some(Solved { row: constructed::row(&self.scene, v)?, point: OnceLock::new() });
        self.constructed[index].get_or_init(solve).as_ref()
    }
}
