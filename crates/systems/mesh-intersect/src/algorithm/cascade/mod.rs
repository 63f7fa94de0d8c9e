//! Cascades: Boolean operations on closed meshes of doubles, whose results are again such meshes.
//!
//! Each step is an overlay of the two meshes ([`mod@crate::algorithm::overlay`]), one of which moves by an
//! infinitesimal, the limit of its result ([`mod@crate::algorithm::limit`]), and the limit rounded to doubles
//! ([`mod@crate::algorithm::rounding`]). If the vertices of a result are doubles, a step is exact: then results are
//! those of the operations on point sets, regularised, whatever steps came before.
//!
//! Otherwise the mesh of doubles may cross itself, and then it is not a valid operand. With [`Rounding::Resolved`]
//! crossings are resolved and rounded again ([`mod@crate::algorithm::resolve`]), until none remain.

mod columns;

use predicament_mesh::MaterialError;
use predicament_predicates::{Declined, SceneError};

use self::columns::Columns;
use crate::algorithm::limit::{self, limit};
use crate::algorithm::overlay::{Undone, Zeros, overlay_of_columns};
use crate::algorithm::resolve::{self, Unresolved, rounded_since};
use crate::algorithm::rounding::{self, NotRounded, rounded};
use crate::algorithm::sessions::{Sessions, with};
use predicament_overlay::algorithm::overlay::Operation;

pub use crate::algorithm::rounding::Closed;

/// Statistics of a step.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Step {
    /// The number of points constructed.
    pub constructed: usize,
    /// The parts of the perturbed result without extent.
    pub limit: limit::Counts,
    /// Statistics of rounding.
    pub rounding: rounding::Counts,
    /// Statistics of the resolution of rounding flaws; `None` if it was not requested.
    pub resolved: Option<resolve::Counts>,
}

impl Step {
    /// The number of flaws of the result: pairs that cross after resolution, if it was requested; otherwise also folds
    /// and reversed triangles.
    #[must_use]
    pub fn left(&self) -> usize {
        self.resolved.map_or(self.rounding.left, |resolved| resolved.left)
    }
}

/// The treatment of rounding flaws.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Rounding {
    /// Flaws are counted.
    #[default]
    Counted,
    /// Flaws are resolved, and the result is rounded again.
    Resolved,
}

/// The reason why there is no result.
#[derive(Clone, PartialEq, Debug)]
pub enum NoStep {
    /// A triangle of a mesh is invalid: of the first mesh (0), or of the second (1).
    Mesh(usize, MaterialError),
    /// A coordinate is not finite, or there are too many vertices.
    Scene(SceneError),
    /// A backend declines the scene.
    Declined(Declined),
    /// The overlay, or the limit of its result, fails.
    Undone(Undone),
    /// A result cannot be rounded to a mesh of doubles.
    Rounding(NotRounded),
    /// A result crosses itself, and the resolution fails.
    Unresolved(Unresolved),
}

impl std::fmt::Display for NoStep {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            NoStep::Mesh(mesh, why) => write!(f, "the {} mesh: {why}", ["first", "second"][*mesh]),
            NoStep::Scene(why) => why.fmt(f),
            NoStep::Declined(why) => why.fmt(f),
            NoStep::Undone(why) => why.fmt(f),
            NoStep::Rounding(why) => why.fmt(f),
            NoStep::Unresolved(why) => why.fmt(f),
        }
    }
}

impl std::error::Error for NoStep {}

impl From<Declined> for NoStep {
    fn from(why: Declined) -> NoStep {
        NoStep::Declined(why)
    }
}

/// The configuration of steps.
#[derive(Clone, Copy)]
pub struct Cascade<'a> {
    /// The backend that moves the second mesh as a whole, so that the two meshes never touch.
    pub perturbed: &'a dyn Sessions,
    /// The backend that returns exact zeros.
    pub exact: &'a dyn Sessions,
    /// The meaning of a zero of `perturbed`.
    pub zeros: Zeros,
    /// The treatment of rounding flaws.
    pub rounding: Rounding,
}

impl Cascade<'_> {
    /// The result of an operation on two closed meshes. An empty mesh is empty space.
    ///
    /// Only the part above, below and beside the box of the other mesh is overlaid; the rest is kept or dropped
    /// unchanged. The function does not check that the operands are closed ([`Closed::check`]).
    ///
    /// Call many steps on small meshes from a thread of a rayon pool: from outside, each of their short loops has to
    /// enter the pool.
    ///
    /// # Errors
    /// [`NoStep`], with the first reason.
    pub fn combine(&self, operands: [&Closed; 2], operation: Operation) -> Result<(Closed, Step), NoStep> {
        let columns = Columns::of(operands);
        if columns.near.iter().any(Vec::is_empty) {
            let (joined, _) = columns.joined(operands, operation, None);
            return Ok((joined, Step::default()));
        }
        let scene = columns.scene(operands).map_err(NoStep::Scene)?;
        let meshes = columns.meshes(operands)?;
        let (overlay, scene) = with(self.perturbed, &scene, &mut |session| {
            let overlay = overlay_of_columns(session, meshes.clone(), self.zeros).map_err(NoStep::Undone)?;
            Ok::<_, NoStep>((overlay, session.scene().clone()))
        })?;
        let (result, limit) = with(self.exact, &scene, &mut |session| {
            let limit = limit(session, &overlay, overlay.solid(operation)).map_err(NoStep::Undone)?;
            let result = rounded(self.exact, session, &limit).map_err(NoStep::Rounding)?;
            Ok::<_, NoStep>((result, limit.counts))
        })?;
        let (mut joined, moved) = columns.joined(operands, operation, Some(&result));
        let rounding = result.counts;
        let mut resolved = None;
        if self.rounding == Rounding::Resolved {
            let mut counts = resolve::Counts::default();
            if rounding.moved > 0 {
                (joined, counts) =
                    rounded_since(self.exact, joined, moved, rounding.left > 0).map_err(NoStep::Unresolved)?;
            }
            resolved = Some(counts);
        }
        let step = Step { constructed: overlay.constructions().len(), limit, rounding, resolved };
        Ok((joined, step))
    }
}
