//! The sixteen classes of answers, their severities, and the gate's status of a scene.
//!
//! They live in the lowest crate because the oracle assigns them and the report prints them, and neither depends on the
//! other.

use crate::UnknownName;

/// The comparison of an answer with the truth and with the backend's promise.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Class {
    /// The answer is the exact sign.
    Agree,
    /// The exact sign is zero and the answer is not: promised by backends that break ties.
    TieBroken,
    /// The answer is zero for a value within the upper tolerance: promised by backends with a band.
    InBand,
    /// The answer is zero for a value beyond the upper tolerance, or for any nonzero value if the backend has no band.
    Overreach,
    /// The exact sign is zero and the answer is not, although the backend promised to report degeneracies.
    MissedZero,
    /// The answer is the opposite sign.
    SignFlip,
    /// Answers contradict each other.
    Inconsistent,
    /// The arithmetic produced a NaN.
    Nan,
    /// A topology check failed.
    Topology,
    /// A check of a whole scene failed only by the rounding of output coordinates, within the check's stated bound.
    Rounded,
    /// The backend panicked.
    Panic,
    /// The backend took too long.
    Timeout,
    /// The backend declined the scene or the predicate.
    Declined,
    /// A library reported an error for valid input.
    Refused,
    /// A library gave an answer for invalid input.
    Accepted,
    /// The same query, asked again, got another answer.
    Unstable,
}

impl Class {
    /// All sixteen classes, in the order of the columns of `summary.csv`.
    pub const ALL: [Class; 16] = [
        Class::Agree,
        Class::TieBroken,
        Class::InBand,
        Class::Overreach,
        Class::MissedZero,
        Class::SignFlip,
        Class::Inconsistent,
        Class::Nan,
        Class::Topology,
        Class::Rounded,
        Class::Panic,
        Class::Timeout,
        Class::Declined,
        Class::Refused,
        Class::Accepted,
        Class::Unstable,
    ];

    /// The class's name in every file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Class::Agree => "agree",
            Class::TieBroken => "tie_broken",
            Class::InBand => "in_band",
            Class::Overreach => "overreach",
            Class::MissedZero => "missed_zero",
            Class::SignFlip => "sign_flip",
            Class::Inconsistent => "inconsistent",
            Class::Nan => "nan",
            Class::Topology => "topology",
            Class::Rounded => "rounded",
            Class::Panic => "panic",
            Class::Timeout => "timeout",
            Class::Declined => "declined",
            Class::Refused => "refused",
            Class::Accepted => "accepted",
            Class::Unstable => "unstable",
        }
    }

    /// Returns true if the backend's promise allows the class.
    ///
    /// Every other class is a finding, and a finding must be expected. (The oracle assigns `TieBroken` and `InBand`
    /// only to backends that promise them.)
    #[must_use]
    pub const fn is_legal(self) -> bool {
        matches!(self, Class::Agree | Class::TieBroken | Class::InBand)
    }

    /// Returns true if the class is a wrong answer to a single query, for every backend.
    ///
    /// Reports count such answers per million queries and plot them against time.
    #[must_use]
    pub const fn is_wrong_answer(self) -> bool {
        matches!(
            self,
            Class::Overreach | Class::MissedZero | Class::SignFlip | Class::Inconsistent | Class::Nan | Class::Unstable
        )
    }

    /// Returns true if the class describes single answers, not a whole scene.
    #[must_use]
    pub const fn is_answer(self) -> bool {
        !matches!(
            self,
            Class::Topology
                | Class::Rounded
                | Class::Panic
                | Class::Timeout
                | Class::Declined
                | Class::Refused
                | Class::Accepted
        )
    }

    /// The severity of the class.
    #[must_use]
    pub const fn severity(self) -> Severity {
        match self {
            Class::Agree | Class::TieBroken => Severity::Right,
            Class::InBand => Severity::Undecided,
            Class::Rounded => Severity::Rounded,
            Class::Refused => Severity::Refused,
            Class::Accepted => Severity::Accepted,
            Class::Panic | Class::Timeout | Class::Declined => Severity::NotDone,
            Class::Overreach
            | Class::MissedZero
            | Class::SignFlip
            | Class::Inconsistent
            | Class::Nan
            | Class::Topology
            | Class::Unstable => Severity::Broken,
        }
    }
}

impl core::fmt::Display for Class {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(self.name())
    }
}

impl core::str::FromStr for Class {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Class, UnknownName> {
        Class::ALL
            .into_iter()
            .find(|class| class.name() == name)
            .ok_or_else(|| UnknownName::new("class", name).listing("classes", Class::ALL.map(Class::name)))
    }
}

/// The severity of a result, for every backend alike.
///
/// Pages colour by severity and gates can filter by it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Severity {
    /// Nothing is wrong: the exact answer, or a tie broken as promised.
    Right,
    /// No decision: the value is within the tolerance band.
    Undecided,
    /// An output is off by the rounding of its coordinates, within a stated bound.
    Rounded,
    /// Valid input was refused with an error.
    Refused,
    /// Invalid input was accepted.
    Accepted,
    /// No answer: declined, out of time, or crashed.
    NotDone,
    /// A sign or a topology is wrong.
    Broken,
}

impl Severity {
    /// All seven severities, from good to bad.
    pub const ALL: [Severity; 7] = [
        Severity::Right,
        Severity::Undecided,
        Severity::Rounded,
        Severity::Refused,
        Severity::Accepted,
        Severity::NotDone,
        Severity::Broken,
    ];

    /// The severity's name in every file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Severity::Right => "right",
            Severity::Undecided => "undecided",
            Severity::Rounded => "rounded",
            Severity::Refused => "refused",
            Severity::Accepted => "accepted",
            Severity::NotDone => "not_done",
            Severity::Broken => "broken",
        }
    }
}

impl core::fmt::Display for Severity {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(self.name())
    }
}

impl core::str::FromStr for Severity {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Severity, UnknownName> {
        Severity::ALL
            .into_iter()
            .find(|severity| severity.name() == name)
            .ok_or_else(|| UnknownName::new("severity", name).listing("severities", Severity::ALL.map(Severity::name)))
    }
}

/// The gate's status of one scene on one backend.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Status {
    /// Every answer is legal.
    Ok,
    /// There are findings, and `expected.toml` lists all of them.
    Expected,
    /// There is a finding that no expectation lists.
    Unexpected,
    /// An expected finding did not occur.
    UnexpectedPass,
}

impl Status {
    /// All four statuses, from good to bad.
    pub const ALL: [Status; 4] = [Status::Ok, Status::Expected, Status::Unexpected, Status::UnexpectedPass];

    /// The status's name in every file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Status::Ok => "ok",
            Status::Expected => "expected",
            Status::Unexpected => "unexpected",
            Status::UnexpectedPass => "unexpected_pass",
        }
    }

    /// Returns true if the gate passes with this status.
    #[must_use]
    pub const fn passes(self) -> bool {
        matches!(self, Status::Ok | Status::Expected)
    }
}

impl core::fmt::Display for Status {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_what_serde_writes_and_reads() {
        for class in Class::ALL {
            assert_eq!(serde_json::to_string(&class).unwrap(), format!("\"{class}\""));
            assert_eq!(class.name().parse(), Ok(class));
        }
        for status in Status::ALL {
            assert_eq!(serde_json::to_string(&status).unwrap(), format!("\"{status}\""));
        }
        assert!("Agree".parse::<Class>().unwrap_err().to_string().contains("sign_flip"));
    }

    #[test]
    fn wrong_answers_are_answers() {
        let wrong: Vec<&str> = Class::ALL.into_iter().filter(|c| c.is_wrong_answer()).map(Class::name).collect();
        assert_eq!(wrong, ["overreach", "missed_zero", "sign_flip", "inconsistent", "nan", "unstable"]);
        assert!(Class::ALL.into_iter().all(|c| c.is_answer() || !c.is_wrong_answer()));
    }

    #[test]
    fn each_severity_has_a_class_and_wrong_answers_are_broken() {
        for severity in Severity::ALL {
            assert!(Class::ALL.into_iter().any(|class| class.severity() == severity), "{severity}");
            assert_eq!(severity.name().parse(), Ok(severity));
            assert_eq!(serde_json::to_string(&severity).unwrap(), format!("\"{severity}\""));
        }
        let broken = |class: Class| class.severity() == Severity::Broken;
        assert!(Class::ALL.into_iter().all(|c| broken(c) == (c.is_wrong_answer() || c == Class::Topology)));
    }
}
