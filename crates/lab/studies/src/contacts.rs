//! The contacts of two complexes, as a backend registers them.
//!
//! Parity and resolution use contacts; the code to query a backend for them is only here.

use predicament_contacts::algorithm::pairs::Contacts;
use predicament_contacts::task;
use predicament_mesh::Complex;
use predicament_predicates::{Dimension, Scene};
use predicament_tasks::{AnswerError, Contestant};

/// All contacts of two complexes of a scene, which must have the lengths of their primitives.
///
/// # Errors
/// [`AnswerError`] if the backend declines.
pub(crate) fn contacts(
    backend: &dyn Contestant,
    scene: &Scene,
    [a, b]: [&Complex; 2],
) -> Result<Contacts, AnswerError> {
    let task = match scene.dimension() {
        Dimension::Two => task::Contacts::IN_PLANE,
        Dimension::Three => task::Contacts::IN_SPACE,
    };
    backend.answer(&task, scene, &task::Complexes { a: a.clone(), b: b.clone() })
}
