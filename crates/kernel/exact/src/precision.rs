//! The precision plan of a scene, for reports.
//!
//! It describes the scene's coordinates and the arithmetic chosen for each predicate.

use alloc::{vec, vec::Vec};
use predicament_arithmetic::{Arithmetic, Plan, Span};
use predicament_predicates::{Dimension, PredicateKind, Scene};

use crate::determinant::{self, Determinant};
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};

/// The precision that the coordinates of a scene need.
#[derive(Clone, PartialEq, Debug)]
pub struct Precision {
    /// The coordinate range of each axis: x, y and, in space, z.
    pub axes: Vec<Span>,
    /// The exponent of the lowest bit: every coordinate is a multiple of two to this power.
    pub lowest: i32,
    /// The bit length of the largest difference of two coordinates of an axis, in units of the lowest bit.
    pub bits: i32,
    /// The choice for each predicate that the scene has.
    ///
    /// In space `orient2d` is that of the widest pair of axes; a projection may need less.
    pub choices: Vec<Choice>,
}

/// The arithmetic and static bound chosen for one predicate.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Choice {
    /// The predicate.
    pub predicate: PredicateKind,
    /// The magnitude from which on plain floating point has the right sign, in units of the determinant.
    ///
    /// `None` if filters are not allowed, zero if doubles make no error.
    pub static_bound: Option<f64>,
    /// The cheapest arithmetic that makes no error.
    pub arithmetic: Arithmetic,
}

impl Precision {
    /// The precision plan of a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Precision {
        match scene.dimension() {
            Dimension::Two => {
                let plan = Plan::<2>::of(scene.coordinates().as_chunks().0);
                let extent = plan.axes().map(|axis| axis.extent());
                let choices = vec![
                    choice(PredicateKind::Orient2d, &plan, determinant::ORIENT2D, Orient2d::static_bound(extent)),
                    choice(PredicateKind::Incircle, &plan, determinant::INCIRCLE, Incircle::static_bound(extent)),
                ];
                Precision::new(&plan, choices)
            }
            Dimension::Three => {
                let plan = Plan::<3>::of(scene.coordinates().as_chunks().0);
                let extent = plan.axes().map(|axis| axis.extent());
                let mut sorted = extent;
                sorted.sort_unstable_by(f64::total_cmp);
                let flat = Orient2d::static_bound([sorted[1], sorted[2]]);
                let choices = vec![
                    choice(PredicateKind::Orient2d, &plan, determinant::ORIENT2D, flat),
                    choice(PredicateKind::Orient3d, &plan, determinant::ORIENT3D, Orient3d::static_bound(extent)),
                    choice(PredicateKind::Insphere, &plan, determinant::INSPHERE, Insphere::static_bound(extent)),
                ];
                Precision::new(&plan, choices)
            }
        }
    }

    fn new<const D: usize>(plan: &Plan<D>, choices: Vec<Choice>) -> Precision {
        Precision { axes: plan.axes().to_vec(), lowest: plan.lowest(), bits: plan.bits(), choices }
    }
}

fn choice<const D: usize>(
    predicate: PredicateKind,
    plan: &Plan<D>,
    determinant: Determinant,
    static_bound: f64,
) -> Choice {
    let arithmetic = plan.arithmetic(determinant.form);
    let static_bound = match arithmetic {
        Arithmetic::Double => Some(0.0),
        _ => plan.allows_filters(determinant.form).then_some(static_bound),
    };
    Choice { predicate, static_bound, arithmetic }
}
