//! The results for the unperturbed meshes: their limits as the perturbation goes to zero, and the limits in doubles.
//!
//! An overlay's results are those of perturbed meshes. Users want the results for the given meshes, in a file of
//! doubles. Both steps run when an answer is judged or written, and not when it is timed.

use crate::algorithm::limit::{self, limit};
use crate::algorithm::overlay::{MeshOverlay, Solid, Undone};
use crate::algorithm::rounding::{NotRounded, Rounded, rounded};
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{Construction, Declined, Predicates};

/// The results of all operations without the perturbation.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Settled {
    /// The results in the order of [`Operation::ALL`].
    pub results: [Result; 4],
    /// All constructions, of the overlay and after it.
    pub constructions: Vec<Construction>,
}

/// The unperturbed result of an operation.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Result {
    /// The limit.
    pub solid: Solid,
    /// The numbers of elements of the perturbed result without extent.
    pub counts: limit::Counts,
    /// The limit in doubles.
    pub rounded: Rounded,
}

/// The reason why a result has no limit, or none in doubles.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum Unsettled {
    /// The backend declines the scene without the perturbation.
    Declined(Declined),
    /// A result has no limit.
    Undone(Undone),
    /// A limit cannot be rounded to doubles.
    NotRounded(NotRounded),
}

impl std::error::Error for Unsettled {}

impl From<Declined> for Unsettled {
    fn from(why: Declined) -> Unsettled {
        Unsettled::Declined(why)
    }
}

impl std::fmt::Display for Unsettled {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Unsettled::Declined(why) => why.fmt(f),
            Unsettled::Undone(why) => why.fmt(f),
            Unsettled::NotRounded(why) => why.fmt(f),
        }
    }
}

/// The results of an overlay without the session's perturbation; `None` if the session rounds, and cannot return exact
/// zeros.
///
/// # Errors
/// [`Unsettled`], for example if a constructed vertex is not a point of the unperturbed meshes.
pub(super) fn settled(
    session: &dyn Predicates,
    overlay: &MeshOverlay,
    solids: &[Solid; 4],
    before: usize,
) -> Option<std::result::Result<Settled, Unsettled>> {
    let exact = session.unperturbed()?;
    let scene = session.scene().clone();
    let mut settled: std::result::Result<Settled, Unsettled> = Ok(Settled::default());
    let asked = exact.with_session(&scene, &mut |session| {
        let mut one = |solid: &Solid| -> std::result::Result<Result, Unsettled> {
            let limit = limit(session, overlay, solid.clone()).map_err(Unsettled::Undone)?;
            let rounded = rounded(exact, session, &limit).map_err(Unsettled::NotRounded)?;
            Ok(Result { solid: limit.solid, counts: limit.counts, rounded })
        };
        let results: std::result::Result<Vec<Result>, Unsettled> = solids.iter().map(&mut one).collect();
        settled = results.map(|results| {
            let results = <[Result; 4]>::try_from(results).unwrap_or_default();
            Settled { results, constructions: session.scene().constructions()[before..].to_vec() }
        });
    });
    Some(asked.map_err(Unsettled::Declined).and(settled))
}

impl Settled {
    /// The results by operation.
    pub(super) fn by_operation(&self) -> impl Iterator<Item = (Operation, &Result)> {
        Operation::ALL.into_iter().zip(&self.results)
    }
}
