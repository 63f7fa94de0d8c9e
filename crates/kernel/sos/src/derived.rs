//! Ties of predicates from formulas: the terms that the formula derives, evaluated in exact numbers until one decides.
//!
//! Arguments that the formula lets change places are sorted first: terms take long to derive, and there is one list for
//! each order of the arguments.

use predicament_predicates::formula::{Order, Terms, exact};
use predicament_predicates::{Derived, Scene, Sign, Vertex};

use crate::Scheme;

/// The sign of a tie, and the place of the deciding term.
///
/// `None` if the perturbation leaves the tie: a vertex occurs twice, and the formula vanishes wherever the vertices
/// are.
///
/// # Panics
/// If the list of terms is too long to derive; [`is_derivable`] tells.
pub(crate) fn tie(scheme: Scheme, scene: &Scene, derived: Derived, vertices: &[Vertex]) -> Option<(Sign, usize)> {
    let order = match scheme {
        Scheme::PerCoordinate => Order::FirstLargest,
        Scheme::EdelsbrunnerMucke => Order::LastLargest,
    };
    let (formula, mut vertices) = (derived.formula(), vertices.to_vec());
    let turns = formula.sort(&mut vertices, |a, b| a.index() < b.index());
    let terms = formula.terms(&Derived::ranks(&vertices), order);
    first(&terms.unwrap_or_else(|why| panic!("{why}")), scene, derived, &vertices, turns)
}

/// The sign of a tie if the second mesh moves by η·(ε, ε², ε³), and the place of the deciding power.
pub(crate) fn moved_tie(
    second: &[bool],
    scene: &Scene,
    derived: Derived,
    vertices: &[Vertex],
) -> Option<(Sign, usize)> {
    let (formula, mut vertices) = (derived.formula(), vertices.to_vec());
    let moves = |v: &Vertex| second.get(v.index()).copied().unwrap_or(false);
    let turns = formula.sort(&mut vertices, |a, b| !moves(a) && moves(b));
    let terms = formula.moved_terms(&vertices.iter().map(moves).collect::<Vec<bool>>());
    first(&terms.unwrap_or_else(|why| panic!("{why}")), scene, derived, &vertices, turns)
}

/// The sign of the first term that is not zero, and its place; `turns` if the order of the vertices turns the sign.
fn first(terms: &Terms, scene: &Scene, derived: Derived, vertices: &[Vertex], turns: bool) -> Option<(Sign, usize)> {
    derived.with_points(scene, vertices, |points| {
        let signs = terms.programs().iter().map(|program| Sign::from(exact::dyadic(program, points)));
        let (sign, place) = signs.zip(0..).find(|(sign, _)| !sign.is_zero())?;
        Some((if turns { -sign } else { sign }, place))
    })
}

/// Checks that the terms of a formula can be derived.
///
/// # Errors
/// The reason.
pub(crate) fn is_derivable(derived: Derived) -> Result<(), String> {
    let ranks: Vec<usize> = (0..derived.formula().arity()).collect();
    derived.formula().terms(&ranks, Order::FirstLargest).map(|_| ())
}
