//! Comparison of a session's answers with the surroundings of the probes.

use crate::answer::{Location, Locations};
use crate::truth::{Ground, Surroundings};
use predicament_predicates::ZeroMeaning;

/// The kind of error in an answer.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Fault {
    /// The answer has no region, but every sector is in one: the probe fell into a gap.
    Gap,
    /// The answer has two regions or more, but no sector is in more than one.
    Double,
    /// The answer has other regions than any sector.
    Misplaced,
    /// The answer has a boundary that the probe is not on, from a session whose zeros are exact or which has no zeros.
    FalseBoundary,
    /// The answer lacks a boundary that the probe is on, from a session whose zeros are exact.
    MissedBoundary,
    /// The answer has a boundary, from a session that breaks all ties; the probe is not itself a vertex of the map.
    UnbrokenTie,
}

impl Fault {
    /// The name used in CSV files and reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Fault::Gap => "gap",
            Fault::Double => "double",
            Fault::Misplaced => "misplaced",
            Fault::FalseBoundary => "false-boundary",
            Fault::MissedBoundary => "missed-boundary",
            Fault::UnbrokenTie => "unbroken-tie",
        }
    }

    /// True if the answer does not fit any sector, for any meaning of zeros; the other faults are broken promises about
    /// zeros.
    #[must_use]
    pub const fn is_topological(self) -> bool {
        matches!(self, Fault::Gap | Fault::Double | Fault::Misplaced)
    }
}

/// An answer that contradicts the surroundings of its probe.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct TilingViolation {
    /// The probe's index.
    pub probe: usize,
    /// The ground of the probe; never [`Ground::Defect`].
    pub ground: Ground,
    /// The kind of error.
    pub fault: Fault,
}

/// The numbers of answers by kind, for probes on one kind of ground.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Counts {
    /// Answers with a boundary.
    pub boundary: usize,
    /// Answers without a boundary and without a region.
    pub none: usize,
    /// Answers without a boundary, with one region.
    pub one: usize,
    /// Answers without a boundary, with two regions or more.
    pub more: usize,
}

impl Counts {
    /// The number of probes on this ground.
    #[must_use]
    pub fn probes(&self) -> usize {
        self.boundary + self.none + self.one + self.more
    }
}

/// The summary of all answers.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct TilingReport {
    counts: [Counts; Ground::ALL.len()],
    violations: Vec<TilingViolation>,
}

impl TilingReport {
    /// The numbers of answers by kind, for the probes on this ground.
    #[must_use]
    pub fn counts(&self, ground: Ground) -> Counts {
        self.counts[ground as usize]
    }

    /// The violations, in the order of the probes, at most one per probe.
    #[must_use]
    pub fn violations(&self) -> &[TilingViolation] {
        &self.violations
    }
}

/// Judges answers by the law of [the module](super) and by the meaning of the session's zeros; of an incomplete result,
/// the available part.
///
/// # Panics
/// If there are more answers than probes.
#[must_use]
pub fn tiling_report(surroundings: &Surroundings, answers: &Locations, zero: ZeroMeaning) -> TilingReport {
    assert!(answers.len() <= surroundings.len(), "{} answers to {} probes", answers.len(), surroundings.len());
    let mut report = TilingReport::default();
    for (probe, answer) in answers.iter().enumerate() {
        let ground = surroundings.ground(probe);
        let counts = &mut report.counts[ground as usize];
        match answer {
            Location { boundary: &[_, ..], .. } => counts.boundary += 1,
            Location { inside: &[], .. } => counts.none += 1,
            Location { inside: &[_], .. } => counts.one += 1,
            Location { inside: &[_, _, ..], .. } => counts.more += 1,
        }
        if ground != Ground::Defect {
            let fault = topology(surroundings, probe, answer).or_else(|| promise(surroundings, probe, answer, zero));
            report.violations.extend(fault.map(|fault| TilingViolation { probe, ground, fault }));
        }
    }
    report
}

/// The fault if no sector S has I ⊆ S ⊆ I ∪ B.
fn topology(surroundings: &Surroundings, probe: usize, answer: Location<'_>) -> Option<Fault> {
    let Location { inside, boundary } = answer;
    let accounted = |sector: &[u32]| {
        inside.iter().all(|region| sector.binary_search(region).is_ok())
            && sector
                .iter()
                .all(|region| inside.binary_search(region).is_ok() || boundary.binary_search(region).is_ok())
    };
    if surroundings.sectors(probe).any(accounted) {
        return None;
    }
    let ground = surroundings.ground(probe);
    Some(match inside.len() {
        0 if boundary.is_empty() && ground == Ground::Land => Fault::Gap,
        2.. if ground != Ground::Overlap => Fault::Double,
        _ => Fault::Misplaced,
    })
}

/// The fault if the named boundaries differ from the boundaries that the session promises.
fn promise(surroundings: &Surroundings, probe: usize, answer: Location<'_>, zero: ZeroMeaning) -> Option<Fault> {
    let truth = surroundings.boundary(probe);
    let named_in_vain = answer.boundary.iter().any(|region| truth.binary_search(region).is_err());
    match zero {
        ZeroMeaning::Band => None,
        _ if named_in_vain => Some(Fault::FalseBoundary),
        ZeroMeaning::Exact => (answer.boundary != truth).then_some(Fault::MissedBoundary),
        ZeroMeaning::Never => {
            let broken = answer.boundary.is_empty() || surroundings.is_map_vertex(probe);
            (!broken).then_some(Fault::UnbrokenTie)
        }
    }
}
