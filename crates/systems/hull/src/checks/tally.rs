//! What decides signs, and what was found.

use predicament_predicates::{Predicates, Question, Scene, Sign, Vertex};

/// What decides about hulls.
#[derive(Clone, Copy)]
pub struct Signs<'a> {
    /// The exact signs.
    pub exact: &'a dyn Predicates,
    /// Those of the perturbed scene, where ties are broken.
    pub perturbed: Option<&'a dyn Predicates>,
    /// How many ties of each check are decided.
    pub ties: usize,
    /// How many points are held against faces, in pairs.
    pub pairs: usize,
}

/// A check that failed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Flaw {
    /// Its name.
    pub check: &'static str,
    /// In how many places.
    pub places: usize,
    /// The vertices of the first of them.
    pub vertices: Vec<Vertex>,
    /// What is wrong there.
    pub what: String,
}

/// A turn that should be positive and is zero.
struct Tie {
    check: &'static str,
    question: Question,
    args: Vec<Vertex>,
}

/// Flaws by check, and ties to be decided.
pub struct Tally<'a> {
    /// What signs are asked of.
    pub signs: Signs<'a>,
    flaws: Vec<Flaw>,
    ties: Vec<Tie>,
}

impl<'a> Tally<'a> {
    /// Nothing found so far.
    #[must_use]
    pub fn new(signs: Signs<'a>) -> Tally<'a> {
        Tally { signs, flaws: Vec::new(), ties: Vec::new() }
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &'a Scene {
        self.signs.exact.scene()
    }

    /// Whether ties stand, and zero is an answer.
    pub fn has_ties(&self) -> bool {
        self.signs.perturbed.is_none()
    }

    /// Whether nothing was found so far.
    pub fn is_clean(&self) -> bool {
        self.flaws.is_empty()
    }

    /// Counts a flaw; of each check the first is described.
    pub fn flaw(&mut self, check: &'static str, vertices: &[Vertex], what: impl FnOnce() -> String) {
        match self.flaws.iter_mut().find(|flaw| flaw.check == check) {
            Some(flaw) => flaw.places += 1,
            None => self.flaws.push(Flaw { check, places: 1, vertices: vertices.to_vec(), what: what() }),
        }
    }

    /// The turn has to be positive, or, where there is a check for that, not zero: a tie that the perturbation breaks has
    /// to be positive in the perturbed scene.
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

    /// All flaws, after an even sample of the ties is decided.
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
