//! Differences that zeros within a band allow, decided in rationals.

use std::cell::RefCell;
use std::collections::HashMap;

use predicament_judge::is_within;
use predicament_laws::published;
use predicament_predicates::{Predicates, Question, Vertex};

use crate::algorithm::questions::{self, Asked};
use crate::answer::{Nearest, Pair};
use crate::truth::Truth;

/// The bands of one session: the largest values for which it may answer zero.
pub(super) struct Bands<'a> {
    session: &'a dyn Predicates,
    /// The bands that were derived.
    known: RefCell<HashMap<Question, f64>>,
}

impl<'a> Bands<'a> {
    /// The published bands of a session.
    pub(super) fn new(session: &'a dyn Predicates) -> Bands<'a> {
        Bands { session, known: RefCell::default() }
    }

    fn is_open(&self, question: Question, args: &[Vertex]) -> bool {
        let derive = || published::band(self.session, question).map_or(0.0, |band| band.upper);
        let upper = *self.known.borrow_mut().entry(question).or_insert_with(derive);
        upper > 0.0 && is_within(self.session.scene(), question, args, upper)
    }

    fn any(&self, asked: Asked) -> bool {
        asked.into_iter().any(|(question, args)| self.is_open(question, &args))
    }

    /// True if a sign that tells this answer from the truth is zero within the bands.
    ///
    /// A pair that only one of them has is allowed if a sign that says that its nearest points are inside the features
    /// is open, or the comparison with a pair of the other one. Another kind is allowed if a sign that says that a pair
    /// meets is open, or if each crossing has an open sign.
    pub(super) fn allow(&self, got: &Nearest, truth: &Truth) -> bool {
        let scene = self.session.scene();
        let wanted: Vec<Pair> = truth.pairs.iter().copied().collect();
        if got.kind != truth.kind {
            let crossings = &truth.crossings;
            let can_be_missed = || crossings.iter().all(|pair| self.any(questions::crossing(pair)));
            return got.pairs.iter().chain(&wanted).any(|pair| self.any(questions::meeting(scene, pair)))
                || !crossings.is_empty() && can_be_missed();
        }
        let only = |these: &[Pair], others: &[Pair]| {
            let others = others.to_vec();
            these.iter().filter(|pair| !others.contains(pair)).copied().collect::<Vec<_>>()
        };
        let is_allowed = |pair: &Pair, others: &[Pair]| {
            self.any(questions::inside(scene, pair))
                || others.iter().any(|other| {
                    let asked = questions::comparing(scene, pair, other);
                    asked.is_some_and(|(question, args, _)| self.is_open(question, &args))
                })
        };
        only(&got.pairs, &wanted).iter().all(|pair| is_allowed(pair, &wanted))
            && only(&wanted, &got.pairs).iter().all(|pair| is_allowed(pair, &got.pairs))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use predicament_predicates::{Backend, Dimension, Off, Scene};
    use predicament_tasks::Watch;
    use predicament_tolerance::Tolerance;

    use super::super::TwoObjects;
    use super::*;
    use crate::answer::Kind;

    /// True if a tolerance may say that a segment along the x-axis is apart from these edges, which all cross it.
    fn may_be_missed(edges: &[[[f64; 2]; 2]]) -> bool {
        let points: Vec<f64> = [[[-5.0, 0.0], [5.0, 0.0]].as_slice(), edges.as_flattened()].concat().concat();
        let scene = Scene::new(Dimension::Two, points).unwrap();
        let edge = |at: usize| vec![Vertex::input(2 * at), Vertex::input(2 * at + 1)];
        let parts = [vec![edge(0)], (1..=edges.len()).map(edge).collect()];
        let content = TwoObjects::new(Dimension::Two, parts);
        let never = AtomicBool::new(false);
        let truth = Truth::new(&scene, content.objects(), &Watch::new(&never, None, &|_| {})).unwrap();
        assert_eq!((truth.kind, truth.crossings.len()), (Kind::Crossing, edges.len()));
        let tolerance = Tolerance::<f64>::default();
        let session = tolerance.prepare(&scene, Off).unwrap();
        Bands::new(&session).allow(&Nearest { kind: Kind::Apart, pairs: Vec::new() }, &truth)
    }

    #[test]
    fn one_sure_crossing_is_not_missed() {
        let (sure, slight) = ([[0.0, -1.0], [0.0, 1.0]], [[3.0, -1e-17], [3.0, 1.0]]);
        assert!(may_be_missed(&[slight]));
        assert!(!may_be_missed(&[sure]) && !may_be_missed(&[sure, slight]));
    }
}
