//! The result of a check, and its text.

use std::fmt::{Display, Formatter, Result};

use crate::finding::{Finding, Got};
use crate::{Law, Point};

/// The result of a check.
#[derive(Clone, PartialEq, Debug)]
pub struct Report<P> {
    /// The predicate, the type of its coordinates, and the seed.
    pub title: String,
    /// The number of queries that were asked.
    pub asked: u64,
    /// The number of answers with a wrong sign, or NaN.
    pub wrong: u64,
    /// The number of queries without a sign.
    pub undecided: u64,
    /// The number of panics.
    pub panicked: u64,
    /// The number of queries that were not asked: the type cannot hold them, or they are outside of the exponents.
    pub left_out: u64,
    /// The laws, in the order of [`Law::ALL`].
    pub laws: Vec<LawReport<P>>,
    /// The families and scenes.
    pub sources: Vec<SourceReport>,
    /// The predicate among others on the same queries, the best first.
    pub ranking: Vec<Rank>,
    /// The first finding of each kind in each family and scene.
    pub findings: Vec<Finding<P>>,
    /// Remarks on the predicate as a whole.
    pub notes: Vec<String>,
    /// True if undecided answers are within the predicate's promise.
    pub may_be_undecided: bool,
}

/// The counts of a family or a scene.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct SourceReport {
    /// The name of the family with its parameters, or of the scene.
    pub name: String,
    /// The number of queries that were asked.
    pub asked: u64,
    /// The number of answers with a wrong sign, or NaN.
    pub wrong: u64,
    /// The number of queries without a sign.
    pub undecided: u64,
    /// The number of panics.
    pub panicked: u64,
    /// The number of queries that were not asked.
    pub left_out: u64,
}

/// A law: how often it was tested, and how often the answers broke it.
#[derive(Clone, PartialEq, Debug)]
pub struct LawReport<P> {
    /// The law.
    pub law: Law,
    /// The number of pairs of a query and an image.
    pub tested: u64,
    /// The number of pairs whose answers contradict each other.
    pub broken: u64,
    /// The first contradiction.
    pub first: Option<Contradiction<P>>,
}

/// Two answers that contradict each other.
#[derive(Clone, PartialEq, Debug)]
pub struct Contradiction<P> {
    /// The arguments of both queries.
    pub points: [Vec<P>; 2],
    /// Both answers.
    pub got: [Got; 2],
}

/// A predicate in the ranking.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Rank {
    /// The name.
    pub name: &'static str,
    /// The number of queries without the right sign.
    pub wrong: u64,
}

/// The name of the checked predicate in the ranking.
pub(crate) const THIS: &str = "this predicate";

/// The number of findings that the text shows.
const SHOWN: usize = 5;

impl<P> Report<P> {
    /// True if the predicate conforms: every answer is the exact sign, and no law is broken.
    ///
    /// A predicate that may be undecided must still decide one query. A check without queries does not conform.
    #[must_use]
    pub fn conforms(&self) -> bool {
        let decides = if self.may_be_undecided { self.undecided < self.asked } else { self.undecided == 0 };
        let laws = self.laws.iter().all(|law| law.broken == 0);
        self.asked > 0 && self.wrong == 0 && self.panicked == 0 && decides && laws
    }
}

/// A number with commas between its thousands.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

impl<P: Point> Display for Report<P> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let [asked, wrong, undecided, panicked, left_out] =
            [self.asked, self.wrong, self.undecided, self.panicked, self.left_out].map(grouped);
        writeln!(f, "{}", self.title)?;
        writeln!(
            f,
            "{asked} queries: {wrong} wrong, {undecided} undecided, {panicked} panics; {left_out} queries left out"
        )?;
        for note in &self.notes {
            writeln!(f, "note: {note}")?;
        }
        writeln!(f, "\n{:<44} {:>9}", "ranking on the same queries", "not right")?;
        for (place, rank) in self.ranking.iter().enumerate() {
            let equal = self.ranking.iter().position(|other| other.wrong == rank.wrong).unwrap_or(place);
            writeln!(f, "  {}. {:<39} {:>9}", equal + 1, rank.name, grouped(rank.wrong))?;
        }
        writeln!(f, "\n{:<44} {:>9} {:>9}", "laws between answers", "tested", "broken")?;
        for law in &self.laws {
            writeln!(f, "  {:<42} {:>9} {:>9}", law.law.name(), grouped(law.tested), grouped(law.broken))?;
            if let Some(Contradiction { points: [own, image], got: [first, second] }) = &law.first {
                writeln!(f, "    {own:?}: {first}\n    {image:?}: {second}")?;
            }
        }
        let is_bad = |source: &&SourceReport| source.wrong + source.undecided + source.panicked > 0;
        if self.sources.iter().any(|source| is_bad(&source)) {
            writeln!(
                f,
                "\n{:<44} {:>9} {:>9} {:>9} {:>9}",
                "families and scenes", "queries", "wrong", "undecided", "panics"
            )?;
        }
        for source in self.sources.iter().filter(is_bad) {
            let counts = [source.asked, source.wrong, source.undecided, source.panicked].map(grouped);
            writeln!(f, "  {:<42} {:>9} {:>9} {:>9} {:>9}", source.name, counts[0], counts[1], counts[2], counts[3])?;
        }
        for (at, finding) in self.findings.iter().take(SHOWN).enumerate() {
            writeln!(f, "\nfinding {} of {}: {finding}", at + 1, self.findings.len())?;
        }
        if self.findings.len() > SHOWN {
            writeln!(f, "\n{} more findings in `Report::findings`", self.findings.len() - SHOWN)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands() {
        let all = [0, 999, 1000, 1_234_567].map(grouped);
        assert_eq!(all, ["0", "999", "1,000", "1,234,567"]);
    }
}
