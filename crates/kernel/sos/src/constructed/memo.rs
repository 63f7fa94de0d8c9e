//! A cache of the latest ties about constructed vertices, with their results.
//!
//! Such a tie costs several times, sometimes a hundred times, as much as the zero that finds it. Algorithms soon ask
//! about the same vertices again in another order: around a triangle, from both sides of an edge. A tie is decided with
//! its vertices in ascending order; then the parity of the query's order is applied. So the answer is the same with and
//! without a memo, and so is the tally of stages.

use std::sync::Mutex;

use predicament_predicates::{Question, Scene, Sign, Vertex};

use super::decide;
use super::row::Rows;
use crate::ties::Sorted;

/// The number of cached ties.
///
/// It is enough for the threads of a machine to avoid each other, and too small to cache a whole list of queries.
const SLOTS: usize = 16;

/// The maximum number of vertices in a question about constructed ones.
const MOST: usize = 4;

struct Tie {
    question: Question,
    /// The vertices, ascending; the last one is repeated to fill the array.
    vertices: [Vertex; MOST],
    decided: Option<(Sign, usize)>,
}

/// The latest ties of one session, and the rows of its constructed vertices.
///
/// Ids of vertices never change, so entries stay true when vertices are added.
pub(crate) struct Memo {
    slots: [Mutex<Option<Tie>>; SLOTS],
    rows: Rows,
}

impl Memo {
    /// An empty memo.
    pub(crate) fn new(scene: &Scene) -> Memo {
        Memo { slots: Default::default(), rows: Rows::new(scene) }
    }

    /// Adds slots for new vertices of the scene.
    pub(crate) fn grow(&mut self, scene: &Scene) {
        self.rows.grow(scene);
    }

    /// The result of [`decide`], cached.
    ///
    /// # Panics
    /// As [`decide`].
    pub(crate) fn decide<const N: usize>(
        &self,
        scene: &Scene,
        question: Question,
        args: [Vertex; N],
    ) -> Option<(Sign, usize)> {
        // A tie with a vertex twice is not worth caching.
        let Some(Sorted { vertices: sorted, parity }) = Sorted::new(args) else {
            return decide(scene, &self.rows, question, args);
        };
        let vertices = std::array::from_fn(|at| sorted[at.min(N - 1)]);
        let slot = &self.slots[place(question, &vertices)];
        let known = slot.try_lock().ok().and_then(|slot| {
            let tie = slot.as_ref().filter(|tie| tie.question == question && tie.vertices == vertices)?;
            Some(tie.decided)
        });
        let decided = known.unwrap_or_else(|| {
            let decided = decide(scene, &self.rows, question, sorted);
            // Never waits: if another thread holds the slot, the result is not cached.
            if let Ok(mut slot) = slot.try_lock() {
                *slot = Some(Tie { question, vertices, decided });
            }
            decided
        });
        decided.map(|(sign, degree)| (sign * parity, degree))
    }
}

/// The slot index of a tie.
fn place(question: Question, vertices: &[Vertex; MOST]) -> usize {
    let kind = question.kind().index();
    let mixed = vertices.iter().fold(kind, |sum, v| {
        // (The multiplier is an odd number near 2^64 divided by the golden ratio; any other would do.)
        let number = 2 * v.construction().unwrap_or_else(|| v.index()) + usize::from(v.is_constructed());
        (sum ^ number).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29)
    });
    mixed % SLOTS
}

#[cfg(test)]
mod tests {
    use predicament_exact::Exact;
    use predicament_predicates::{Axis, Backend, Construction, Off, Plane, Predicates};

    use super::super::testing::search_all;
    use super::*;

    /// The four sides of a square and its diagonals: ties everywhere.
    fn scene() -> (Scene, Vec<Vertex>) {
        let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 0.0], [2.0, 4.0], [0.0, 2.0], [4.0, 2.0]];
        let mut scene = Scene::from_points2(&corners).unwrap();
        let v = Vertex::input;
        for lines in [[[v(0), v(2)], [v(1), v(3)]], [[v(4), v(5)], [v(6), v(7)]], [[v(0), v(2)], [v(4), v(5)]]] {
            scene.construct(Construction::Ssi(lines)).unwrap();
        }
        let all = scene.vertices().chain((0..3).map(Vertex::constructed)).collect();
        (scene, all)
    }

    #[test]
    fn a_memo_changes_no_answer_whatever_it_has_seen_before() {
        let (scene, all) = scene();
        let exact = Exact.prepare(&scene, Off).unwrap();
        let memo = Memo::new(&scene);
        let mut asked = 0;
        for rounds in 0..2 {
            for &a in &all {
                for &b in &all {
                    for axis in [Axis::X, Axis::Y].into_iter().filter(|&axis| exact.compare(axis, a, b).is_zero()) {
                        let question = Question::Compare(axis);
                        assert_eq!(memo.decide(&scene, question, [a, b]), search_all(&scene, question, &[a, b]));
                    }
                    for &c in all.iter().skip(rounds).filter(|&&c| exact.orient2d(Plane::Xy, a, b, c).is_zero()) {
                        let question = Question::Orient2d(Plane::Xy);
                        let args = [a, b, c];
                        assert_eq!(
                            memo.decide(&scene, question, args),
                            search_all(&scene, question, &args),
                            "{args:?}"
                        );
                        asked += 1;
                    }
                }
            }
        }
        assert!(asked > 500, "{asked}");
    }

    #[test]
    fn a_tie_in_another_order_is_not_decided_again() {
        let (scene, _) = scene();
        let memo = Memo::new(&scene);
        let [a, b, c] = [0, 1, 2].map(Vertex::constructed);
        let first = memo.decide(&scene, Question::Orient2d(Plane::Xy), [a, b, c]).unwrap();
        // A new decision would fail, since the empty scene lacks these vertices.
        let empty = Scene::from_points2(&[]).unwrap();
        let again = memo.decide(&empty, Question::Orient2d(Plane::Xy), [b, a, c]);
        assert_eq!(again, Some((-first.0, first.1)));
    }

    #[test]
    fn ties_spread_over_all_slots() {
        let all: Vec<Vertex> = (0..8).map(Vertex::input).chain((0..8).map(Vertex::constructed)).collect();
        let mut slots = [0; SLOTS];
        for (i, &a) in all.iter().enumerate() {
            for (j, &b) in all.iter().enumerate().skip(i + 1) {
                slots[place(Question::Compare(Axis::X), &[a, b, b, b])] += 1;
                all[j + 1..].iter().for_each(|&c| slots[place(Question::Orient2d(Plane::Xy), &[a, b, c, c])] += 1);
            }
        }
        // There are 680, 42 per slot.
        assert!(slots.iter().all(|count| (20..80).contains(count)), "{slots:?}");
    }
}
