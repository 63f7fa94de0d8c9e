//! A session whose signs are a hash of the question.

use predicament_predicates::{Predicates, Question, Scene, Sign, Vertex, answer_by};

/// A session that answers any sign, the same to the same query, with one zero in `zeros`.
pub struct Liar<'s> {
    pub scene: &'s Scene,
    pub seed: u64,
    pub zeros: u64,
}

impl Liar<'_> {
    fn sign<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let of_kind = match question {
            Question::Compare(axis) => axis.index(),
            Question::Orient2d(plane) => 3 + plane as usize,
            Question::Orient3d => 6,
            Question::Incircle | Question::Insphere | Question::Derived(_) => 7,
        };
        let hash = args.iter().map(|v| v.index()).chain([of_kind]).fold(self.seed, |hash, x| {
            let hash = (hash ^ x as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            hash ^ hash >> 29
        });
        if hash.is_multiple_of(self.zeros) {
            Sign::Zero
        } else if hash >> 32 & 1 == 0 {
            Sign::Negative
        } else {
            Sign::Positive
        }
    }
}

impl Predicates for Liar<'_> {
    fn scene(&self) -> &Scene {
        self.scene
    }

    answer_by!(sign);
}

/// A session with right answers, except for one in `odds`.
pub struct Slip<'s, P> {
    pub honest: &'s P,
    pub liar: Liar<'s>,
    pub odds: u64,
}

impl<P: Predicates> Slip<'_, P> {
    fn sign<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let hash = args.iter().fold(self.liar.seed, |hash, v| (hash ^ v.index() as u64).wrapping_mul(0x0100_0000_01b3));
        if (hash >> 20).is_multiple_of(self.odds) {
            self.liar.sign(question, args)
        } else {
            question.ask(self.honest, &args)
        }
    }
}

impl<P: Predicates> Predicates for Slip<'_, P> {
    fn scene(&self) -> &Scene {
        self.liar.scene
    }

    answer_by!(sign);
}
