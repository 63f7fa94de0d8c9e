//! Two closed surfaces merged by the contacts that a backend registers.

use predicament_contacts::algorithm::arrangement::Arrangement;
use predicament_contacts::algorithm::pairs::Contacts;
use predicament_contacts::checks::pairs::{Boundaries, LooseEnds, boundaries, loose_ends};
use predicament_tasks::{AnswerError, Contestant};

use super::SurfacePair;
use crate::contacts::contacts;

/// The ways in which registrations can contradict each other.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Broken {
    /// A curve comes to a piercing and has no continuation.
    NoWay,
    /// A curve comes to a piercing, and the two triangles overlap.
    ///
    /// They have more than one other point in common, and none of them is the next.
    NoDirection,
    /// The boundary of a triangle passes through the other surface an odd number of times.
    Odd,
}

impl Broken {
    /// All three ways, in the order of reports.
    pub const ALL: [Broken; 3] = [Broken::NoWay, Broken::NoDirection, Broken::Odd];

    /// The name of the contradiction in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Broken::NoWay => "a curve without a continuation",
            Broken::NoDirection => "a curve without a direction",
            Broken::Odd => "an odd boundary",
        }
    }
}

/// The results of merging two surfaces.
#[derive(Clone, PartialEq, Debug)]
pub struct Examined {
    /// The registered pairs.
    pub contacts: Contacts,
    /// The ends of curves of intersection.
    pub ends: LooseEnds,
    /// The numbers of times that boundaries of triangles pierce.
    pub boundaries: Boundaries,
}

impl Examined {
    /// The number of contradictions of this sort.
    #[must_use]
    pub fn count(&self, broken: Broken) -> usize {
        let ends = |way: bool| self.ends.loose.iter().filter(|end| (end.others == 0) == way).count();
        match broken {
            Broken::NoWay => ends(true),
            Broken::NoDirection => ends(false),
            Broken::Odd => self.boundaries.odd.len(),
        }
    }

    /// The sorts of contradictions that occur, in order.
    #[must_use]
    pub fn broken(&self) -> Vec<Broken> {
        Broken::ALL.into_iter().filter(|&broken| self.count(broken) > 0).collect()
    }
}

/// Registers the contacts of two surfaces with this backend, merges them, and counts contradictions.
///
/// # Errors
/// [`AnswerError`] if the backend declines.
///
/// # Panics
/// If a surface is not closed.
pub fn examine(backend: &dyn Contestant, pair: &SurfacePair) -> Result<Examined, AnswerError> {
    let (scene, complexes) = pair.scene();
    let both = complexes.both();
    let contacts = contacts(backend, &scene, both)?;
    let arrangement = Arrangement::new(&scene, both, &contacts);
    let ends = loose_ends(both, &contacts, &arrangement).expect("surfaces are closed");
    let boundaries = boundaries(both, &contacts).expect("surfaces are closed");
    Ok(Examined { contacts, ends, boundaries })
}
