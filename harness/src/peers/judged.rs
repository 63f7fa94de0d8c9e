//! A crate's answers held against the exact signs.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Once;

use predicament_judge as judge;
use predicament_predicates::{Question, Scene, Sign, Vertex, ZeroMeaning};
use predicament_records::Interface;
use predicament_tasks::signs::{Answers, classify};
use predicament_tasks::{Answer, Budget, Class, Finding, Outcome, Stopwatch};

use super::{Peer, Timed};

/// One crate on one scene.
pub struct Judged<'a> {
    /// The scene that vertices belong to.
    pub scene: &'a Scene,
    /// What is asked.
    pub question: Question,
    /// What the crate means by zero.
    pub zero: ZeroMeaning,
    /// The name in tables.
    pub name: String,
    /// The version that is linked in.
    pub version: &'static str,
}

/// Answers with their outcome, ready to become a [`Peer`].
pub struct Verdict {
    name: String,
    version: &'static str,
    outcome: Outcome,
    answers: Answers,
    remarks: Vec<String>,
}

impl Judged<'_> {
    /// Asks every query once. `ask` gives an answer, and whether it was a NaN
    /// that the caller would have taken for a zero. A crate that panics over a
    /// query is asked about the others, but not timed.
    pub fn judge(self, args: &[Vertex], truth: &[Sign], ask: &dyn Fn(usize) -> (Sign, bool)) -> Verdict {
        let arity = self.question.kind().arity();
        let mut outcome = Outcome { queries: truth.len() as u64, ..Outcome::default() };
        let mut answers = Answers(Vec::with_capacity(truth.len()));
        let mut first = None;
        let asked = quietly(|| {
            let ask = |query| catch_unwind(AssertUnwindSafe(|| ask(query))).ok();
            (0..truth.len()).map(ask).collect::<Vec<_>>()
        });
        for ((answer, args), &truth) in asked.into_iter().zip(args.chunks(arity)).zip(truth) {
            let class = match answer {
                None => Class::Panic,
                Some((_, true)) => Class::Nan,
                Some((sign, false)) => classify(self.zero, None, sign, truth, |limit| {
                    judge::is_within(self.scene, self.question, args, limit)
                }),
            };
            outcome.counts.add(class, 1);
            if !class.is_legal() && outcome.counts.get(class) <= Budget::QUICK.findings_per_class as u64 {
                let finding = self.finding(class, args, truth, answer.map(|(sign, _)| sign));
                first.get_or_insert_with(|| self.in_words(&finding, args));
                outcome.findings.push(finding);
            }
            answers.0.extend(answer.map(|(sign, _)| sign));
        }
        let wrong = outcome.counts.findings();
        let remark = first.map(|first| format!("{}: {wrong} of {} wrong; first, {first}", self.name, outcome.queries));
        Verdict { name: self.name, version: self.version, outcome, answers, remarks: Vec::from_iter(remark) }
    }

    fn finding(&self, class: Class, args: &[Vertex], truth: Sign, got: Option<Sign>) -> Finding {
        Finding {
            class,
            check: "sign".to_owned(),
            queries: vec![self.question.query(args)],
            got: got.map_or_else(|| "panic".to_owned(), |sign| sign.to_string()),
            truth: truth.to_string(),
            log2_relative_det: judge::log2_relative(&judge::verdict(self.scene, self.question, args)),
            distance_over_l: None,
            stage: None,
        }
    }

    /// A finding with its points, to be asked again elsewhere.
    fn in_words(&self, finding: &Finding, args: &[Vertex]) -> String {
        let point = |&v: &Vertex| match self.scene.construction(v) {
            Some(construction) => construction.to_string(),
            None => format!("{:?}", self.scene.point(v)),
        };
        let points: Vec<String> = args.iter().map(point).collect();
        format!(
            "{} is {} and {} says {} ({}): {}",
            finding.query_text(),
            finding.truth,
            self.name,
            finding.got,
            finding.class.name(),
            points.join(" ")
        )
    }
}

impl Verdict {
    /// With the work that it is about: timed only if every query had an answer.
    pub fn timed<'a>(self, watch: impl Stopwatch + 'a) -> Peer<'a> {
        let Verdict { name, version, outcome, answers, mut remarks } = self;
        let panics = outcome.counts.get(Class::Panic);
        let timed = (panics == 0).then(|| Timed {
            watch: Box::new(watch),
            interface: Interface::Single,
            judged: answers.digest(),
        });
        if panics > 0 {
            remarks.push(format!("{name}: not timed, {panics} queries made it panic"));
        }
        Peer { name, version: version.to_owned(), outcome, timed, remarks }
    }
}

thread_local! {
    /// Whether this thread's panics are somebody else's and counted.
    static QUIET: Cell<bool> = const { Cell::new(false) };
}

/// Runs `work` without a word about its panics; `work` has to catch them.
fn quietly<T>(work: impl FnOnce() -> T) -> T {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let hook = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            if !QUIET.get() {
                hook(info);
            }
        }));
    });
    QUIET.set(true);
    let done = work();
    QUIET.set(false);
    done
}

#[cfg(test)]
mod tests {
    use super::*;
    use predicament_predicates::Plane;

    struct Never;

    impl Stopwatch for Never {
        fn pass(&mut self) -> std::time::Duration {
            unreachable!("nothing is timed here")
        }

        fn digest(&self) -> u64 {
            unreachable!("nothing is timed here")
        }
    }

    fn judge(zero: ZeroMeaning, truth: &[Sign], ask: &dyn Fn(usize) -> (Sign, bool)) -> Peer<'static> {
        let scene = Scene::from_points2(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();
        let judged = Judged {
            scene: &scene,
            question: Question::Orient2d(Plane::Xy),
            zero,
            name: "it".to_owned(),
            version: "1",
        };
        let args: Vec<Vertex> = truth.iter().flat_map(|_| scene.vertices()).collect();
        judged.judge(&args, truth, ask).timed(Never)
    }

    #[test]
    fn every_way_of_being_wrong_is_counted_by_its_name() {
        use Sign::{Negative, Positive, Zero};
        let truth = [Positive, Positive, Zero, Zero, Positive];
        let answers = [(Negative, false), (Zero, false), (Positive, false), (Zero, true), (Positive, false)];
        let peer = judge(ZeroMeaning::Exact, &truth, &|i| answers[i]);
        for class in [Class::SignFlip, Class::Overreach, Class::MissedZero, Class::Nan, Class::Agree] {
            assert_eq!(peer.outcome.counts.get(class), 1, "{}", class.name());
        }
        assert_eq!(peer.outcome.findings.len(), 4);
        assert!(peer.timed.is_some(), "wrong answers are timed, and told");
        let breaks_ties = judge(ZeroMeaning::Never, &truth, &|i| answers[i]);
        assert_eq!(breaks_ties.outcome.counts.get(Class::TieBroken), 1);
    }

    #[test]
    fn a_panic_is_counted_and_told_and_ends_the_timing() {
        let peer = judge(ZeroMeaning::Exact, &[Sign::Positive; 3], &|i| {
            assert_ne!(i, 1, "a precondition");
            (Sign::Positive, false)
        });
        assert_eq!(peer.outcome.counts.get(Class::Panic), 1);
        assert_eq!(peer.outcome.counts.get(Class::Agree), 2);
        assert!(peer.timed.is_none());
        assert_eq!(peer.remarks.len(), 2);
        assert!(peer.remarks[1].contains("not timed, 1 queries made it panic"), "{:?}", peer.remarks);
    }
}
