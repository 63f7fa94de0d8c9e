//! Ties about constructed vertices.
//!
//! A vertex where lines and planes meet moves with the input vertices that define it. Its determinants are polynomials
//! of higher degree in the same infinitesimals, too many for lists of terms: every combination of shared vertices would
//! need one. So the polynomial stays a program: rows and determinants ([`moved`]) in numbers that carry a few
//! infinitesimals ([`series`]), and a search for the one monomial that decides ([`search`]). Definitions are simplified
//! first ([`place`]), and every zero of the search is proved to be zero ([`certain`]). Most ties are broken before
//! that: by a few determinants ([`first`]) of rows that a session stores ([`row`]), or by those of the points' ends
//! ([`ends`]).
//!
//! Infinitesimals are compared as in [`Scheme::PerCoordinate`](crate::Scheme): coordinate number n of the scene by the
//! n-th, each smaller than any power of the one before. With ε^(B^n) this is the order for every base B beyond the
//! largest degree, so answers about input vertices and answers about constructed ones are answers about one moved
//! scene.
//!
//! # What remains zero
//! Some determinants are zero wherever the input vertices are: a vertex constructed on a plane is on that plane, and
//! two definitions can be of one point (two lines through a common vertex meet there). They are identities of geometry
//! and not ties; the answer is zero. Between input vertices the only identity is a vertex that occurs twice.
//!
//! # One level
//! Only input vertices may define a vertex here. Each further level multiplies the degree, by four for lines and by
//! nine for three planes, and the number of input vertices behind one question: a determinant of four vertices of three
//! planes has degree 28 in 36 vertices, and of four such vertices of the second level up to degree 252 in 324. The
//! search for the deciding monomial is proved and affordable for the first level, not for the second.

mod certain;
mod common_line;
pub(crate) mod corner;
mod ends;
mod factors;
mod first;
pub(crate) mod fixed;
mod limit;
mod linear;
mod memo;
mod moved;
mod place;
mod residue;
pub(crate) mod rigid;
mod row;
mod search;
mod series;
#[cfg(test)]
mod testing;

use predicament_predicates::{Axis, Construction, Declined, DefinitionError, Question, Scene, Sign, Vertex};

use certain::Matrix;
use first::Known;
pub use limit::{Limit, Ratio, limit};
pub(crate) use memo::Memo;
use moved::{Moved, inputs};
use place::{Place, depend};
use row::Rows;
use search::{Expression, Search};
use series::Number;
use smallvec::{SmallVec, smallvec};

use crate::Scheme;

/// The reason why all schemes but one decline constructed vertices.
pub(crate) fn others_only() -> String {
    format!("only the scheme `{}` moves constructed vertices", Scheme::PerCoordinate)
}

/// Checks that only input vertices define a construction; the error says why that is required.
pub(crate) fn is_of_inputs(construction: &Construction) -> Result<(), DefinitionError> {
    if construction.is_of_inputs() {
        return Ok(());
    }
    let reason = "a perturbation applies only to vertices that input vertices define, not to vertices defined by \
                  constructed vertices";
    Err(DefinitionError::OfConstructed { reason })
}

/// Checks that only input vertices define the constructions of a scene.
pub(crate) fn are_of_inputs(scene: &Scene) -> Result<(), Declined> {
    let checked = scene.constructions().iter().enumerate().try_for_each(|(index, construction)| {
        is_of_inputs(construction)
            .map_err(|why| format!("{}, constructed as {construction}: {why}", Vertex::constructed(index)))
    });
    checked.map_err(Declined::scene)
}

/// The side of a tie, whose unperturbed determinant is zero, and the degree of the deciding monomial.
///
/// `None` if the determinant is zero wherever the input vertices are. All constructed vertices are points of the given
/// scene.
///
/// # Panics
/// If the scene lacks a vertex, or the question is about circles or spheres.
fn decide<const N: usize>(scene: &Scene, rows: &Rows, question: Question, args: [Vertex; N]) -> Option<(Sign, usize)> {
    if let (Question::Compare(axis), [u, v]) = (question, &args[..])
        && let Some(decided) = common_line::decide(scene, axis, [*u, *v])
    {
        return Some(decided);
    }
    decide_from(scene, rows, question, args, 1)
}

/// The sign of a determinant and the degree of the deciding monomial, which is `least`, zero or one, or higher.
///
/// # Panics
/// As [`decide`].
fn decide_from<const N: usize>(
    scene: &Scene,
    rows: &Rows,
    question: Question,
    args: [Vertex; N],
    least: usize,
) -> Option<(Sign, usize)> {
    match ends::decide(scene, rows, question, args) {
        Known::Broken(sign, degree) => return Some((sign, degree)),
        Known::Identity => return None,
        Known::Open => {}
    }
    if let Some(value) = factors::decide(scene, rows, question, &args) {
        return value;
    }
    match first::decide(scene, rows, question, args, least) {
        Known::Broken(sign, degree) => Some((sign, degree)),
        Known::Identity => None,
        Known::Open => search_all(scene, rows, question, &args),
    }
}

/// The result of `decide` by a search through all monomials.
fn search_all(scene: &Scene, rows: &Rows, question: Question, args: &[Vertex]) -> Option<(Sign, usize)> {
    let places: SmallVec<[Place; 4]> = args.iter().map(|&v| Place::simple(scene, v)).collect();
    if depend(question, &places) {
        return None;
    }
    let inputs = inputs(&places);
    let (search, dimension) = (Search::new(scene, &inputs), scene.dimension().count());
    let leading = search.leading_of_tie(&Determinant { dimension, question, places: &places })?;
    let weights = args.iter().filter_map(|v| v.construction()).map(|index| rows.of(scene, index).weight);
    Some((weights.fold(leading.sign(), |sign, weight| sign * weight), leading.degree()))
}

struct Determinant<'q> {
    dimension: usize,
    question: Question,
    places: &'q [Place],
}

impl Expression for Determinant<'_> {
    fn of<S: Number>(&self, moved: &Moved<'_, S>) -> S {
        moved.determinant(self.question, self.places)
    }

    fn matrix(&self) -> Matrix {
        let axes: SmallVec<[Axis; 4]> = match self.question {
            Question::Compare(axis) => SmallVec::from_slice(&[axis]),
            Question::Orient2d(plane) => SmallVec::from_slice(&plane.axes()),
            Question::Orient3d => SmallVec::from_slice(&[Axis::X, Axis::Y, Axis::Z]),
            Question::Incircle | Question::Insphere | Question::Derived(_) => {
                panic!("{} is about input vertices", self.question.kind())
            }
        };
        let columns = axes.iter().map(|axis| axis.index()).chain([self.dimension]);
        Matrix { places: SmallVec::from_slice(self.places), columns: columns.collect() }
    }
}

/// The weight of a place in a scene of some dimension.
struct Weight(Place, usize);

impl Expression for Weight {
    fn of<S: Number>(&self, moved: &Moved<'_, S>) -> S {
        moved.weight(&self.0)
    }

    fn matrix(&self) -> Matrix {
        Matrix { places: smallvec![self.0], columns: smallvec![self.1] }
    }
}
