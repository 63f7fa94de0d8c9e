//! Boolean operations on closed meshes of doubles, whose results are such meshes again: cascades.
//!
//! Each step is an overlay of the two meshes ([`mod@crate::algorithm::overlay`]), one of which moves by an infinitesimal, the limit of its result
//! ([`mod@crate::algorithm::limit`]), and the limit rounded to doubles ([`mod@crate::algorithm::rounding`]). Where the vertices of a result are
//! doubles, a step is exact: then results are those of the operations on point sets, regularised, whatever was done before.
//!
//! Where they are not, the mesh of doubles may cross itself, and then it is no operand. With [`Rounding::Resolved`] what crosses is resolved and rounded
//! again ([`mod@crate::algorithm::resolve`]), until nothing does.

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

/// What a step has done.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Step {
    /// Points that were constructed.
    pub constructed: usize,
    /// What of the perturbed result was without extent.
    pub limit: limit::Counts,
    /// What rounding has done.
    pub rounding: rounding::Counts,
    /// What was resolved of what rounding has left; none where that was not asked for.
    pub resolved: Option<resolve::Counts>,
}

impl Step {
    /// Flaws that the result has: pairs that cross after resolution, where that was asked for; else also folds and triangles that have turned over.
    #[must_use]
    pub fn left(&self) -> usize {
        self.resolved.map_or(self.rounding.left, |resolved| resolved.left)
    }
}

/// What becomes of flaws of rounding.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Rounding {
    /// They are counted.
    #[default]
    Counted,
    /// They are resolved, and what comes of that is rounded again.
    Resolved,
}

/// Why there is no result.
#[derive(Clone, PartialEq, Debug)]
pub enum NoStep {
    /// A triangle of a mesh is wrong: of the first, 0, or of the second, 1.
    Mesh(usize, MaterialError),
    /// A coordinate is not finite, or there are too many vertices.
    Scene(SceneError),
    /// A backend does not take the scene.
    Declined(Declined),
    /// There is no overlay, or no limit of it.
    Undone(Undone),
    /// A result is no mesh of doubles.
    Rounding(NotRounded),
    /// A result crosses itself, and that is not resolved.
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

/// How steps are done.
#[derive(Clone, Copy)]
pub struct Cascade<'a> {
    /// Moves the second mesh as a whole, so that nothing between the two touches.
    pub perturbed: &'a dyn Sessions,
    /// Says zero where something is zero.
    pub exact: &'a dyn Sessions,
    /// What a zero of the first is.
    pub zeros: Zeros,
    /// What becomes of flaws of rounding.
    pub rounding: Rounding,
}

impl Cascade<'_> {
    /// The result of an operation on two closed meshes. No mesh at all is empty space.
    ///
    /// Only what is above, below and beside the box of the other mesh is overlaid; the rest stays as it is, or goes. That the
    /// operands are closed is not checked ([`Closed::check`]).
    ///
    /// Many steps on small meshes are best called from a thread of a rayon pool: from outside each of their short loops is handed to one.
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
