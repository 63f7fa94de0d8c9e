//! The sources of signs for the checks, and the tally of failed checks.

use predicament_predicates::{Predicates, Question, Scene, Sign, Vertex};

/// The sources of signs, and the limits of the checks.
#[derive(Clone, Copy)]
pub struct Signs<'a> {
    /// The exact signs.
    pub exact: &'a dyn Predicates,
    /// The signs of the perturbed scene, if ties are broken.
    pub perturbed: Option<&'a dyn Predicates>,
    /// The number of ties that are decided for each check.
    pub ties: usize,
    /// The number of pairs of a point and a face that are checked.
    pub pairs: usize,
}

/// A check that failed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Flaw {
    /// The check's name.
    pub check: &'static str,
    /// The number of places where it failed.
    pub places: usize,
    /// The vertices of the first place.
    pub vertices: Vec<Vertex>,
    /// The description of the first place.
    pub what: String,
}

/// A turn that should be positive and is zero.
struct Tie {
    check: &'static str,
    question: Question,
    args: Vec<Vertex>,
}

/// A collection of flaws by check, and of ties to decide.
pub struct Tally<'a> {
    /// The sources of signs.
    pub signs: Signs<'a>,
    flaws: Vec<Flaw>,
    ties: Vec<Tie>,
}

impl<'a> Tally<'a> {
    /// An empty tally.
    #[must_use]
    pub fn new(signs: Signs<'a>) -> Tally<'a> {
        Tally { signs, flaws: Vec::new(), ties: Vec::new() }
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &'a Scene {
        self.signs.exact.scene()
    }

    /// True if ties stay ties, so that zero is an answer.
    pub fn has_ties(&self) -> bool {
        self.signs.perturbed.is_none()
    }

    /// True if no flaw was found so far.
    pub fn is_clean(&self) -> bool {
        self.flaws.is_empty()
    }

    /// Counts a flaw, and keeps the description of the first flaw of each check.
    pub fn flaw(&mut self, check: &'static str, vertices: &[Vertex], what: impl FnOnce() -> String) {
        match self.flaws.iter_mut().find(|flaw| flaw.check == check) {
            Some(flaw) => flaw.places += 1,
            None => self.flaws.push(Flaw { check, places: 1, vertices: vertices.to_vec(), what: what() }),
        }
    }

    /// Checks that a turn is positive and, if a check is given for zero, not zero. With broken ties, a zero turn has to
    /// be positive in the perturbed scene.
    pub fn positive(
        &mut self,
        check: &'static str,
        of_zero: Option<&'static str>,
        question: Question,
        args: &[Vertex],
    ) {
        match (question.ask(self.signs.exact, args), of_zero) {
            (Sign::Negative, _) => self.flaw(check, args, || format!("{} is negative", question.query(args))),
            (Sign::Zero, _) if !self.has_ties() => self.ties.push(Tie { check, question, args: args.to_vec() }),
            (Sign::Zero, Some(of_zero)) => self.flaw(of_zero, args, || format!("{} is zero", question.query(args))),
            _ => {}
        }
    }

    /// Returns all flaws, after deciding an even sample of the ties.
    pub fn finish(mut self) -> Vec<Flaw> {
        let ties = std::mem::take(&mut self.ties);
        if let Some(perturbed) = self.signs.perturbed {
            for tie in ties.iter().step_by(ties.len().div_ceil(self.signs.ties.max(1)).max(1)) {
                if tie.question.ask(perturbed, &tie.args) == Sign::Negative {
                    let query = tie.question.query(&tie.args);
                    self.flaw(tie.check, &tie.args, || format!("{query} is negative in the perturbed scene"));
                }
            }
        }
        self.flaws
    }
}
