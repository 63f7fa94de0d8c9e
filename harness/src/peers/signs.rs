//! Sign scenes, asked of every crate in two ways: by vertex id through the
//! scene's array of points, and by raw coordinates.
//!
//! A crate without sessions prepares nothing: its session is the array. Where a
//! crate wants circles and spheres through points of one orientation, the
//! queries are rearranged before anybody looks at a clock, as by a caller that
//! knows the orientation of its triangles; queries whose points allow for no
//! such order (all five in a plane, say) are not asked.
//!
//! No crate has batches: each is asked one query at a time, in the orders in which backends are ([`Rounds`]).
//!
//! No crate knows constructed vertices. They are computed in doubles before
//! anybody looks at a clock, and stand in the array after the scene's points.

use std::hint::black_box;
use std::sync::atomic::{Ordering, compiler_fence};
use std::time::{Duration, Instant};

use predicament_controls::constructed;
use predicament_judge as judge;
use predicament_predicates::{Axis, Plane, QuerySet, Question, Scene, Sign, Vertex};
use predicament_tasks::signs::SignQueries;
use predicament_tasks::{AnyCase, Rounds, Stopwatch};

use super::Peer;
use super::judged::Judged;
use super::libraries::{Exact, Geogram, GeometryPredicates, Robust, Simplicity};
use super::predicate::{Library, Predicate};
use super::tables::RAW;

/// All crates, in both ways, where the case is one of signs.
pub fn peers(case: &dyn AnyCase) -> Vec<Peer<'_>> {
    let content = case.loaded().content::<SignQueries>();
    let both = content.zip(case.truth().downcast_ref::<Vec<Sign>>());
    both.map(|(content, truth)| of_scene(&case.loaded().scene, &content.queries, truth)).unwrap_or_default()
}

/// All crates, in both ways. None of them has a comparison to offer that would
/// be worth its name.
fn of_scene<'a>(scene: &'a Scene, queries: &QuerySet, truth: &[Sign]) -> Vec<Peer<'a>> {
    let points2 = |plane: Plane| points(scene, plane.axes());
    let points3 = || points(scene, [Axis::X, Axis::Y, Axis::Z]);
    let asked = Asked { scene, question: queries.question() };
    let args = queries.flat();
    match queries.question() {
        Question::Compare(_) => Vec::new(),
        Question::Orient2d(plane) => asked.all::<2, 3>(&points2(plane), args.as_chunks().0, truth),
        Question::Orient3d => asked.all::<3, 4>(&points3(), args.as_chunks().0, truth),
        Question::Incircle => asked.all::<2, 4>(&points2(Plane::Xy), args.as_chunks().0, truth),
        Question::Insphere => asked.all::<3, 5>(&points3(), args.as_chunks().0, truth),
    }
}

/// Some coordinates of every vertex, the constructed ones after the others.
fn points<const D: usize>(scene: &Scene, axes: [Axis; D]) -> Vec<[f64; D]> {
    let all = [scene.coordinates(), &constructed(scene)].concat();
    all.chunks_exact(scene.dimension().count()).map(|point| axes.map(|axis| point[axis.index()])).collect()
}

/// What all queries of a scene have in common.
struct Asked<'a> {
    scene: &'a Scene,
    question: Question,
}

impl<'a> Asked<'a> {
    fn all<const D: usize, const N: usize>(
        &self,
        points: &[[f64; D]],
        queries: &[[Vertex; N]],
        truth: &[Sign],
    ) -> Vec<Peer<'a>>
    where
        Exact: Predicate<D, N>,
        Robust: Predicate<D, N>,
        GeometryPredicates: Predicate<D, N>,
        Geogram: Predicate<D, N>,
        Simplicity: Predicate<D, N>,
    {
        let of = [
            Self::both::<Robust, D, N>,
            Self::both::<GeometryPredicates, D, N>,
            Self::both::<Geogram, D, N>,
            Self::both::<Simplicity, D, N>,
        ];
        let (by_id, raw): (Vec<_>, Vec<_>) =
            of.into_iter().map(|both| both(self, points, queries, truth).into()).unzip();
        by_id.into_iter().chain([self.raw::<Exact, D, N>(points, queries, truth)]).chain(raw).collect()
    }

    /// One crate, in both ways.
    fn both<L: Library + Predicate<D, N>, const D: usize, const N: usize>(
        &self,
        points: &[[f64; D]],
        queries: &[[Vertex; N]],
        truth: &[Sign],
    ) -> [Peer<'a>; 2] {
        let (arranged, truth): (Vec<_>, Vec<_>) = match self.base::<L>() {
            Some(base) => {
                queries.iter().zip(truth).filter_map(|(&args, &truth)| self.rearranged(args, truth, base)).unzip()
            }
            None => (queries.to_vec(), truth.to_vec()),
        };
        let mut by_id = self.by_id::<L, D, N>(points.to_vec(), &arranged, &truth);
        let mut raw = self.raw::<L, D, N>(points, &arranged, &truth);
        if raw.outcome.counts == by_id.outcome.counts {
            raw.remarks.clear();
        }
        let not_asked = queries.len() - arranged.len();
        if not_asked > 0 {
            by_id.remarks.push(format!("{}: {not_asked} not asked, as no order of their points suits it", L::NAME));
        }
        [by_id, raw]
    }

    /// By vertex id, through the scene's array of points.
    fn by_id<L: Library + Predicate<D, N>, const D: usize, const N: usize>(
        &self,
        points: Vec<[f64; D]>,
        queries: &[[Vertex; N]],
        truth: &[Sign],
    ) -> Peer<'a> {
        let places = self.places(queries);
        let at = |i: usize| places[i].map(Vertex::index);
        let judged = self
            .judged::<L>(L::NAME.to_owned())
            .judge(queries.as_flattened(), truth, &|i| (L::sign(&points, at(i)), L::is_nan(&points, at(i))));
        judged.timed(Watch::new(places, move |at: &[Vertex; N]| L::sign(&points, at.map(Vertex::index))))
    }

    /// By the coordinates of each query.
    fn raw<L: Library + Predicate<D, N>, const D: usize, const N: usize>(
        &self,
        points: &[[f64; D]],
        queries: &[[Vertex; N]],
        truth: &[Sign],
    ) -> Peer<'a> {
        let places: [usize; N] = std::array::from_fn(|i| i);
        let coordinates: Vec<[[f64; D]; N]> =
            self.places(queries).into_iter().map(|at| at.map(|v| points[v.index()])).collect();
        let judged = self.judged::<L>(format!("{RAW}{}", L::NAME)).judge(queries.as_flattened(), truth, &|i| {
            (L::sign(&coordinates[i], places), L::is_nan(&coordinates[i], places))
        });
        judged.timed(Watch::new(coordinates, move |points: &[[f64; D]; N]| L::sign(points, places)))
    }

    /// The places of the vertices in the array of points: their ids, but for constructed ones.
    fn places<const N: usize>(&self, queries: &[[Vertex; N]]) -> Vec<[Vertex; N]> {
        let place = |v: Vertex| v.construction().map_or(v, |index| Vertex::input(self.scene.len() + index));
        queries.iter().map(|args| args.map(place)).collect()
    }

    fn judged<L: Library>(&self, name: String) -> Judged<'_> {
        Judged { scene: self.scene, question: self.question, zero: L::ZERO, name, version: L::VERSION }
    }

    /// The orientation that a crate wants under this question, if it cares.
    fn base<L: Library>(&self) -> Option<Sign> {
        match self.question {
            Question::Incircle => L::BASE.map(|base| base.circle),
            Question::Insphere => L::BASE.map(|base| base.sphere),
            _ => None,
        }
    }

    /// The same circle or sphere with its first points of this orientation, and
    /// the sign of its determinant then; none where they are degenerate in any order.
    fn rearranged<const N: usize>(&self, args: [Vertex; N], truth: Sign, base: Sign) -> Option<([Vertex; N], Sign)> {
        let question = if N == 4 { Question::Orient2d(Plane::Xy) } else { Question::Orient3d };
        // The last point stays the last if it can.
        (0..N).rev().find_map(|last| {
            let mut args = args;
            args[last..].rotate_left(1);
            let moved = if (N - 1 - last).is_multiple_of(2) { truth } else { -truth };
            let found = judge::sign(self.scene, question, &args[..N - 1]);
            if found == -base {
                args.swap(0, 1);
            }
            (!found.is_zero()).then_some((args, moved * found * base))
        })
    }
}

/// Queries, and a way to answer one.
struct Watch<Q, F> {
    queries: Vec<Q>,
    ask: F,
    rounds: Rounds,
}

impl<Q, F: Fn(&Q) -> Sign> Watch<Q, F> {
    fn new(queries: Vec<Q>, ask: F) -> Watch<Q, F> {
        Watch { rounds: Rounds::of(queries.len()), queries, ask }
    }
}

impl<Q, F: Fn(&Q) -> Sign> Stopwatch for Watch<Q, F> {
    fn pass(&mut self) -> Duration {
        self.passes(1)
    }

    fn passes(&mut self, count: u32) -> Duration {
        let Watch { queries, ask, rounds } = self;
        rounds.time(count, |order, out| {
            let queries = black_box(&*queries);
            let start = Instant::now();
            match order {
                None => singly(queries.iter(), out, &*ask),
                // (Coordinates of so many queries would not stay in a cache.)
                Some(order) => singly(order.iter().map(|&at| &queries[at as usize]), out, &*ask),
            }
            black_box(&mut *out);
            start.elapsed()
        })
    }

    fn digest(&self) -> u64 {
        self.rounds.digest()
    }
}

/// Asks queries one at a time, as backends are asked: no two are answered at once.
#[inline(always)]
fn singly<'q, Q: 'q>(queries: impl Iterator<Item = &'q Q>, out: &mut [Sign], ask: impl Fn(&Q) -> Sign) {
    for (query, out) in queries.zip(out) {
        *out = ask(query);
        compiler_fence(Ordering::SeqCst);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use predicament_predicates::{Construction, PredicateKind};
    use predicament_tasks::Class;

    const QUESTIONS: [Question; 4] =
        [Question::Orient2d(Plane::Xy), Question::Orient3d, Question::Incircle, Question::Insphere];

    /// Small integers from a linear congruence (Knuth's MMIX constants): no
    /// crate has to round anything.
    fn integers(n: usize) -> Vec<f64> {
        let mut state = 20_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let four_bits = u8::try_from(state >> 60).expect("four bits are left");
            f64::from(four_bits) - 8.0
        };
        (0..n).map(|_| next()).collect()
    }

    fn scene_for(question: Question, points: usize) -> Scene {
        match question.kind() {
            PredicateKind::Orient2d | PredicateKind::Incircle => {
                Scene::from_points2(integers(2 * points).as_chunks().0)
            }
            _ => Scene::from_points3(integers(3 * points).as_chunks().0),
        }
        .unwrap()
    }

    /// Every point with those that follow it, and what is true about them.
    fn asked(scene: &Scene, question: Question) -> (QuerySet, Vec<Sign>) {
        let vertices: Vec<Vertex> = scene.vertices().collect();
        let args = vertices.windows(question.kind().arity()).flatten().copied().collect();
        let queries = QuerySet::new(question, args);
        let truth = (0..queries.len()).map(|i| judge::sign(scene, question, queries.args(i))).collect();
        (queries, truth)
    }

    #[test]
    fn conventions_are_mapped_and_ties_go_by_the_promise() {
        for question in QUESTIONS {
            let scene = scene_for(question, 3000);
            let (queries, truth) = asked(&scene, question);
            let ties = truth.iter().filter(|sign| sign.is_zero()).count() as u64;
            assert!(0 < ties && ties < 600, "{question:?}: {ties} ties");
            let peers = of_scene(&scene, &queries, &truth);
            assert_eq!(peers.len(), 9);
            for peer in peers {
                let counts = &peer.outcome.counts;
                assert_eq!(counts.findings(), 0, "{question:?}: {:?}", peer.remarks);
                let broken = if peer.name.ends_with("simplicity") { ties } else { 0 };
                assert_eq!(counts.get(Class::TieBroken), broken, "{question:?}: {}", peer.name);
                assert!(peer.outcome.queries > 2900, "{question:?}: {} was asked too little", peer.name);
            }
        }
    }

    #[test]
    fn a_mapping_that_is_turned_round_is_noticed() {
        for question in QUESTIONS {
            let scene = scene_for(question, 100);
            let (queries, truth) = asked(&scene, question);
            let turned: Vec<Sign> = truth.iter().map(|&sign| -sign).collect();
            for peer in of_scene(&scene, &queries, &turned) {
                let (flipped, zeros) = (peer.outcome.counts.get(Class::SignFlip), peer.outcome.queries);
                assert!(flipped > 80 && flipped <= zeros, "{question:?}: {}", peer.name);
                assert!(peer.name.starts_with("raw:") || peer.remarks[0].contains("wrong; first"));
            }
        }
    }

    #[test]
    fn what_is_timed_is_what_was_judged() {
        for question in QUESTIONS {
            let scene = scene_for(question, 200);
            let (queries, truth) = asked(&scene, question);
            for peer in of_scene(&scene, &queries, &truth) {
                let mut timed = peer.timed.expect("nobody panics over small integers");
                assert_ne!(timed.watch.digest(), timed.judged, "{}: before the first pass all is zero", peer.name);
                timed.watch.pass();
                assert_eq!(timed.watch.digest(), timed.judged, "{question:?}: {}", peer.name);
            }
        }
    }

    #[test]
    fn rearranged_queries_have_the_base_that_was_asked_for_and_their_own_truth() {
        for (question, base) in
            [(Question::Incircle, Question::Orient2d(Plane::Xy)), (Question::Insphere, Question::Orient3d)]
        {
            let scene = scene_for(question, 2000);
            let (queries, truth) = asked(&scene, question);
            let asked = Asked { scene: &scene, question };
            let mut moved = 0;
            for wanted in [Sign::Positive, Sign::Negative] {
                for (i, &truth) in truth.iter().enumerate() {
                    moved += match queries.args(i) {
                        &[a, b, c, d] => check(&asked, base, [a, b, c, d], truth, wanted),
                        &[a, b, c, d, e] => check(&asked, base, [a, b, c, d, e], truth, wanted),
                        args => panic!("{} arguments", args.len()),
                    };
                }
            }
            assert!(moved > 10, "{question:?}: a degenerate base came up {moved} times only");
        }
    }

    /// One query; 1 if another point had to become the last.
    fn check<const N: usize>(asked: &Asked, base: Question, args: [Vertex; N], truth: Sign, wanted: Sign) -> u32 {
        match asked.rearranged(args, truth, wanted) {
            Some((new, sign)) => {
                assert_eq!(judge::sign(asked.scene, base, &new[..N - 1]), wanted);
                assert_eq!(judge::sign(asked.scene, asked.question, &new), sign);
                let sorted = |mut args: [Vertex; N]| {
                    args.sort_unstable();
                    args
                };
                assert_eq!(sorted(new), sorted(args));
                u32::from(new[N - 1] != args[N - 1])
            }
            None => {
                assert_eq!(truth, Sign::Zero, "without any base there is no determinant");
                0
            }
        }
    }

    #[test]
    fn constructed_vertices_are_points_that_were_rounded() {
        // The diagonals of a square meet in (1, 1), and of a kite in (1/3, 1/3), which is no double.
        let mut scene = Scene::from_points2(&[
            [0.0, 0.0],
            [2.0, 2.0],
            [0.0, 2.0],
            [2.0, 0.0],
            [0.0, 1.0],
            [0.5, 0.0],
            [3.0, 0.0],
            [-1.0, 2.0],
        ])
        .unwrap();
        let v = Vertex::input;
        let x = scene.construct(Construction::Ssi([[v(0), v(1)], [v(2), v(3)]])).unwrap();
        let y = scene.construct(Construction::Ssi([[v(0), v(1)], [v(4), v(5)]])).unwrap();
        let args = [[x, v(0), v(3)], [y, v(0), v(1)], [v(4), y, v(5)], [v(6), x, v(7)]].concat();
        let queries = QuerySet::new(QUESTIONS[0], args);
        let truth: Vec<Sign> = (0..4).map(|i| judge::sign(&scene, QUESTIONS[0], queries.args(i))).collect();
        assert_eq!(truth, [Sign::Positive, Sign::Zero, Sign::Zero, Sign::Zero]);
        for peer in of_scene(&scene, &queries, &truth) {
            assert_eq!(peer.outcome.queries, 4);
            if !peer.name.ends_with("simplicity") {
                assert!(peer.outcome.counts.get(Class::Agree) >= 3, "{}: {:?}", peer.name, peer.remarks);
            }
        }
    }

    #[test]
    fn underflow_is_told_in_words() {
        // Twice the area is 1e-400: no double, and not zero.
        let scene = Scene::from_points2(&[[0.0, 0.0], [1e-200, 0.0], [0.0, 1e-200]]).unwrap();
        let (queries, truth) = asked(&scene, QUESTIONS[0]);
        assert_eq!(truth, [Sign::Positive]);
        let peers = of_scene(&scene, &queries, &truth);
        let robust = peers.iter().find(|peer| peer.name == "robust").unwrap();
        assert_eq!(robust.outcome.counts.get(Class::Overreach), 1);
        let told = "robust: 1 of 1 wrong; first, orient2d(xy; 0 1 2) is + and robust says 0 (overreach): \
                    [0.0, 0.0] [1e-200, 0.0] [0.0, 1e-200]";
        assert_eq!(robust.remarks, [told]);
    }
}
