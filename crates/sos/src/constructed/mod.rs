//! Ties about constructed vertices.
//!
//! A vertex where lines and planes meet moves with the input vertices that
//! define it. Its determinants are polynomials of higher degree in the same
//! infinitesimals, too many for lists of terms: every combination of shared
//! vertices would need one. So the polynomial stays a program: rows and
//! determinants ([`moved`]) in numbers that carry a few infinitesimals
//! ([`series`]), and a search for the one monomial that decides ([`search`]).
//!
//! Infinitesimals are compared as in [`Scheme::PerCoordinate`](crate::Scheme):
//! coordinate number n of the scene by the n-th, each smaller than any power
//! of the one before. With ε^(B^n) this is the order for every base B
//! beyond the largest degree, so answers about input vertices and answers about
//! constructed ones are answers about one moved scene.
//!
//! # What remains zero
//! Some determinants are zero wherever the input vertices are: a vertex
//! constructed on a plane is on that plane, and two definitions can be of one
//! point (two lines through a common vertex meet there). Those are identities of
//! geometry and no ties; the answer is zero. Between input vertices there are
//! none but those of a vertex that is asked for twice.
//!
//! # One level
//! Only input vertices may define a vertex here. Each further level multiplies
//! the degree, by four for lines and by nine for three planes, and the number
//! of input vertices behind one question: a determinant of four vertices of
//! three planes has degree 28 in 36 vertices, and of four such vertices of the
//! second level up to degree 252 in 324. The search for the deciding monomial
//! is proved and affordable for the first, not for the second.

mod limit;
mod moved;
mod residue;
pub(crate) mod rigid;
mod search;
mod series;

use predicament_predicates::{Construction, Declined, Question, Scene, Sign, Vertex};

pub use limit::{Limit, limit};
use moved::{Moved, inputs};
use search::{Expression, Search};
use series::{Coefficient, Series};

use crate::Scheme;

/// Why the schemes but one decline constructed vertices.
pub(crate) fn others_only() -> String {
    format!("constructed vertices are moved by the scheme `{}` only", Scheme::PerCoordinate)
}

/// Whether only input vertices define it, and why that has to be.
pub(crate) fn is_of_inputs(construction: &Construction) -> Result<(), String> {
    if construction.is_of_inputs() {
        return Ok(());
    }
    Err("a perturbation moves vertices that input vertices define, not those that constructed ones do".to_owned())
}

/// The same for all constructions of a scene.
pub(crate) fn are_of_inputs(scene: &Scene) -> Result<(), Declined> {
    let checked = scene.constructions().iter().enumerate().try_for_each(|(index, construction)| {
        is_of_inputs(construction)
            .map_err(|why| format!("{}, constructed as {construction}: {why}", Vertex::constructed(index)))
    });
    checked.map_err(Declined::scene)
}

/// The side of a tie, and the degree of the monomial that decides; none if
/// the determinant is zero wherever the input vertices are.
///
/// # Panics
/// If the scene lacks a vertex, or the question is about circles or spheres.
pub(crate) fn decide(scene: &Scene, question: Question, args: &[Vertex]) -> Option<(Sign, usize)> {
    let inputs = inputs(scene, args);
    let search = Search::new(scene, &inputs);
    let leading = search.leading(&Determinant { question, args })?;
    let weights = args.iter().filter(|v| v.is_constructed());
    let sign = weights.fold(leading.sign(), |sign, &v| {
        let weight = Weight(v);
        match search.unmoved(&weight) {
            // A weight that is always zero is that of lines or planes that never meet in a point.
            Sign::Zero => sign * search.leading(&weight).map_or(Sign::Zero, |weight| weight.sign()),
            unmoved => sign * unmoved,
        }
    });
    Some((sign, leading.degree()))
}

struct Determinant<'q> {
    question: Question,
    args: &'q [Vertex],
}

impl Expression for Determinant<'_> {
    fn of<C: Coefficient>(&self, moved: &Moved<'_, C>) -> Series<C> {
        moved.determinant(self.question, self.args)
    }
}

struct Weight(Vertex);

impl Expression for Weight {
    fn of<C: Coefficient>(&self, moved: &Moved<'_, C>) -> Series<C> {
        moved.weight(self.0)
    }
}
