//! How a session is asked what passes through what.

use crate::algorithm::overlay::Zeros;
use predicament_predicates::{Predicates, Question};

use super::content::TwoMeshes;

/// How a session overlays meshes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Manner {
    /// By the signs of orientations.
    Signs(Zeros),
    /// By the contacts that it registers: its zeros are bands, and what they mean is the hierarchy's business.
    Contacts,
}

/// How this session does. Where the sign is that of a floating-point determinant, a zero is nothing that could be refused.
pub(super) fn manner(session: &dyn Predicates, content: &TwoMeshes) -> Manner {
    let [[a, b, c], [d, ..]] = [0, 1].map(|mesh: usize| content.meshes[mesh].triangles()[0]);
    let question = Question::Orient3d;
    if session.band(question).is_some() {
        return Manner::Contacts;
    }
    let is_rounded = session.estimate(question, &[a, b, c, d]).is_some();
    Manner::Signs(if is_rounded { Zeros::Positive } else { Zeros::Refused })
}
