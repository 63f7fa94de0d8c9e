//! The ways in which a session decides passages.

use crate::algorithm::overlay::Zeros;
use predicament_predicates::{Predicates, Question};

use super::content::TwoMeshes;

/// The way in which a session overlays meshes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Manner {
    /// Orientation signs decide passages.
    Signs(Zeros),
    /// Registered contacts decide passages: the session's zeros are bands, which the hierarchy of contacts interprets.
    Contacts,
}

/// The way for a session. If the sign is that of a floating-point determinant, a zero cannot be refused.
pub(super) fn manner(session: &dyn Predicates, content: &TwoMeshes) -> Manner {
    let [[a, b, c], [d, ..]] = [0, 1].map(|mesh: usize| content.meshes[mesh].triangles()[0]);
    let question = Question::Orient3d;
    if session.band(question).is_some() {
        return Manner::Contacts;
    }
    let is_rounded = session.estimate(question, &[a, b, c, d]).is_some();
    Manner::Signs(if is_rounded { Zeros::Positive } else { Zeros::Zero })
}
