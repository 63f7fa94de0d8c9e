//! The exact contacts of two complexes: which simplices meet, by linear equations in rationals.
//!
//! # Definition
//! A simplex is a list of vertices. Its *open* simplex is the set of all Σ wᵢ pᵢ with weights wᵢ > 0 that add up to
//! one, whether or not the points are in general position; the closed simplex allows zero weights. A *sub-pair* of
//! (s, t) is a pair of non-empty faces of s and of t, other than (s, t) itself. The pair (s, t) is **registered** iff
//! the open simplices of s and t have a common point, and no sub-pair's open simplices have one. It has **ended** iff a
//! sub-pair is registered, which is so iff the open simplices of a sub-pair meet.
//!
//! The registered pairs thus describe the common points of two closed simplices by their carriers of the lowest
//! dimensions. For example, two edges that share a vertex register one pair: that vertex with itself.
//!
//! # Why there is no hierarchy here
//! The algorithm under test visits pairs level by level: first the pairs whose ranks add up to 0, then 1, and so on to
//! the dimension D. It remembers which pairs it has registered. The definition needs neither levels nor memory. Write a
//! common point as weights w ≥ 0 on the vertices of both simplices: D + 2 linear equations (one point, two sums of
//! one). Their solutions are a polytope, and every pair of faces whose open simplices meet is the support of one of its
//! points. The minimal supports are those of the vertices of the polytope: if the columns of a support are dependent,
//! moving along the dependency, within the support, ends at a smaller support; if they are independent, the support has
//! no other solution. Hence
//!
//! > (s, t) is registered iff its equations have exactly one solution, and all weights of it are positive.
//!
//! There are at most as many independent columns as equations, so the ranks of a registered pair add up to D at most:
//! pairs beyond the last level need not be tested. Registration depends on the pair alone, so pairs can be judged one
//! at a time and in any order.
//!
//! # Cost
//! All pairs of simplices whose boxes have a common point are tested. A closed simplex lies in the box of its vertices,
//! and comparing doubles is exact, so no contact is lost where boxes are apart. The boxes of the second complex are
//! sorted by their lower ends, along the axis where most other boxes end too early or start too late; there is no other
//! index. [`sample`] says which simplices of the first complex are judged when all would take too long. [`contact`] can
//! judge any pair that a backend registers, so the sample limits only the search for pairs that the backend has missed.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use predicament_predicates::{Dimension, Scene, Vertex};
use rug::{Integer, Rational};

use crate::Sample;
use crate::determinant::rational;

/// The weights of a point in a simplex, one per vertex, in the order of the vertices.
pub type Weights = Vec<Rational>;

/// A registered pair.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Contact {
    /// The indices of the two simplices in the two lists.
    pub pair: [usize; 2],
    /// The only common point, as its weights on each simplex.
    pub weights: [Weights; 2],
}

/// Input points as integers, in units of one power of two.
type Points = BTreeMap<Vertex, Vec<Integer>>;

fn points(scene: &Scene, vertices: impl IntoIterator<Item = Vertex>) -> Points {
    let exact = |v| (v, scene.point(v).iter().map(|&x| rational(x)).collect());
    let points: BTreeMap<Vertex, Vec<Rational>> = vertices.into_iter().map(exact).collect();
    let mut denominator = Integer::from(1);
    points.values().flatten().for_each(|x| denominator.lcm_mut(x.denom()));
    let whole = |x: &Rational| Integer::from(&denominator / x.denom()) * x.numer();
    points.iter().map(|(&v, point)| (v, point.iter().map(whole).collect())).collect()
}

/// The only common point of two simplices if the pair is registered, else `None`.
///
/// # Panics
/// If a simplex has no vertices, or has a vertex that is not an input vertex of the scene.
#[must_use]
pub fn contact(scene: &Scene, s: &[Vertex], t: &[Vertex]) -> Option<[Weights; 2]> {
    meeting(&points(scene, s.iter().chain(t).copied()), s, t)
}

fn meeting(points: &Points, s: &[Vertex], t: &[Vertex]) -> Option<[Weights; 2]> {
    // The first weight on each simplex is one minus the others, which leaves one equation for each axis: with p and q
    // the first vertices of s and t, Σ wᵢ (pᵢ − p) − Σ vⱼ (qⱼ − q) = q − p. The right side is the last column.
    let ([p, others @ ..], [q, others_of_t @ ..]) = (s, t) else { panic!("a simplex has vertices") };
    let [p, q] = [p, q].map(|v| &points[v]);
    let row = |axis: usize| -> Vec<Integer> {
        let on_s = others.iter().map(|v| Integer::from(&points[v][axis] - &p[axis]));
        let on_t = others_of_t.iter().map(|v| Integer::from(&q[axis] - &points[v][axis]));
        on_s.chain(on_t).chain([Integer::from(&q[axis] - &p[axis])]).collect()
    };
    let (mut on_s, denominator) = only_solution((0..p.len()).map(row).collect())?;
    let mut on_t = on_s.split_off(others.len());
    for of in [&mut on_s, &mut on_t] {
        let first = of.iter().fold(denominator.clone(), |rest, weight| rest - weight);
        of.insert(0, first);
    }
    if on_s.iter().chain(&on_t).any(|weight| weight.cmp0() != denominator.cmp0()) {
        return None;
    }
    let weights = |of: Vec<Integer>| of.into_iter().map(|weight| Rational::from((weight, &denominator))).collect();
    Some([weights(on_s), weights(on_t)])
}

/// The solution of linear equations, each with its right side last, if there is exactly one: numerators over one
/// denominator.
///
/// Gauss-Jordan elimination without fractions: after each step all entries are minors of the matrix, so that the
/// division by the last pivot has remainder zero.
fn only_solution(mut rows: Vec<Vec<Integer>>) -> Option<(Vec<Integer>, Integer)> {
    let unknowns = rows[0].len() - 1;
    let mut last = Integer::from(1);
    for at in 0..unknowns {
        let pivot = (at..rows.len()).find(|&row| rows[row][at].cmp0().is_ne())?;
        rows.swap(at, pivot);
        let by = rows[at].clone();
        for row in rows.iter_mut().enumerate().filter(|(row, _)| *row != at).map(|(_, row)| row) {
            let factor = row[at].clone();
            // The columns before `at` need no update.
            for (entry, of_pivot) in row.iter_mut().zip(&by).skip(at + 1) {
                *entry *= &by[at];
                *entry -= &factor * of_pivot;
                entry.div_exact_mut(&last);
            }
        }
        last.clone_from(&by[at]);
    }
    let is_consistent = rows[unknowns..].iter().all(|row| row[unknowns].cmp0().is_eq());
    // By now every pivot equals the last one.
    is_consistent.then(|| (rows.iter_mut().take(unknowns).filter_map(Vec::pop).collect(), last))
}

/// A registered sub-pair of two simplices, if the pair has ended: one of the lowest ranks.
///
/// # Panics
/// As [`contact`], and if a simplex has 32 vertices.
#[must_use]
pub fn ended_by(scene: &Scene, s: &[Vertex], t: &[Vertex]) -> Option<[Vec<Vertex>; 2]> {
    let [of_s, of_t] = [s, t].map(faces);
    let mut pairs: Vec<[&Vec<Vertex>; 2]> = of_s.iter().flat_map(|s| of_t.iter().map(move |t| [s, t])).collect();
    pairs.sort_by_key(|[s, t]| s.len() + t.len());
    // (s, t) is the largest and comes last.
    pairs.pop();
    let points = points(scene, s.iter().chain(t).copied());
    pairs.into_iter().find(|[s, t]| meeting(&points, s, t).is_some()).map(|pair| pair.map(Clone::clone))
}

/// The registered pairs that have ended, that is, with a registered sub-pair. A correct session never registers such a
/// pair, whatever its notion of contact.
///
/// Every simplex has its vertices in ascending order.
///
/// # Panics
/// If a simplex has 32 vertices.
#[must_use]
pub fn registered_twice(registered: &[[Vec<Vertex>; 2]]) -> Vec<[Vec<Vertex>; 2]> {
    let all: BTreeSet<&[Vec<Vertex>; 2]> = registered.iter().collect();
    let has_ended = |pair: &&[Vec<Vertex>; 2]| {
        let [of_s, of_t] = [0, 1].map(|side| faces(&pair[side]));
        let mut pairs = of_s.iter().flat_map(|s| of_t.iter().map(move |t| [s.clone(), t.clone()]));
        pairs.any(|sub| sub != **pair && all.contains(&sub))
    };
    all.iter().copied().filter(has_ended).cloned().collect()
}

/// All non-empty subsets of a simplex' vertices, in the simplex' order.
fn faces(simplex: &[Vertex]) -> Vec<Vec<Vertex>> {
    let subset = |bits: u32| (0..simplex.len()).filter(|i| bits >> i & 1 == 1).map(|i| simplex[i]).collect();
    (1_u32..1 << simplex.len()).map(subset).collect()
}

/// All registered pairs of two lists of simplices, as indices, in ascending order.
///
/// The lists should be closed under faces, as the simplices of a complex are. Whether a pair is registered does not
/// depend on the other simplices in the lists.
///
/// # Panics
/// As [`contact`].
#[must_use]
pub fn contacts<S: AsRef<[Vertex]>, T: AsRef<[Vertex]>>(scene: &Scene, a: &[S], b: &[T]) -> Vec<Contact> {
    contacts_of(scene, a, b, Sample::all(a.len()))
}

/// The registered pairs of a sample of the first list with the second list.
///
/// # Panics
/// As [`contact`], and if the sample was made for another number of simplices.
#[must_use]
pub fn contacts_of<S: AsRef<[Vertex]>, T: AsRef<[Vertex]>>(
    scene: &Scene,
    a: &[S],
    b: &[T],
    sample: Sample,
) -> Vec<Contact> {
    assert_eq!(sample.of(), a.len(), "the sample is of the first list");
    let most = scene.dimension().count() + 2;
    let points = points(scene, scene.vertices());
    let around: Vec<Bounds> = sample.places().map(|first| Bounds::of(scene, a[first].as_ref())).collect();
    let boxes = (0..scene.dimension().count())
        .map(|axis| Boxes::new(axis, b.iter().map(|t| Bounds::of(scene, t.as_ref())).collect()))
        .min_by_key(|boxes| around.iter().map(|around| boxes.window(around).len()).sum::<usize>())
        .expect("two axes or three");
    let mut found = Vec::new();
    for (first, around) in sample.places().zip(&around) {
        let s = a[first].as_ref();
        let start = found.len();
        boxes.near(around, |second| {
            let t = b[second].as_ref();
            if s.len() + t.len() <= most
                && let Some(weights) = meeting(&points, s, t)
            {
                found.push(Contact { pair: [first, second], weights });
            }
        });
        found[start..].sort_by_key(|contact| contact.pair);
    }
    found
}

/// The budget for the contacts of one scene, in comparisons of boxes.
const BUDGET: u64 = 1_000_000_000;
/// The further cost per simplex of the pairs whose boxes meet, in comparisons of boxes, for the plane and for space.
/// Space has more such pairs, with larger equations.
const NEAR: [u64; 2] = [20_000, 200_000];

/// The sample of the first list to judge, given the numbers of simplices in both lists: all if that takes about a
/// second at most, else every n-th.
#[must_use]
pub fn sample(dimension: Dimension, [a, b]: [usize; 2]) -> Sample {
    let near = NEAR[usize::from(dimension == Dimension::Three)];
    Sample::within(BUDGET, a, b as u64 + near)
}

/// Boxes in the order of their lower ends along an axis.
struct Boxes {
    axis: usize,
    sorted: Vec<(Bounds, usize)>,
    /// The highest upper end among each box and the boxes before it.
    highest: Vec<f64>,
}

impl Boxes {
    fn new(axis: usize, boxes: Vec<Bounds>) -> Boxes {
        let mut sorted: Vec<(Bounds, usize)> = boxes.into_iter().zip(0..).collect();
        sorted.sort_by(|(a, _), (b, _)| a.low[axis].total_cmp(&b.low[axis]));
        let highest = sorted.iter().scan(f64::NEG_INFINITY, |highest, (bounds, _)| {
            *highest = highest.max(bounds.high[axis]);
            Some(*highest)
        });
        Boxes { axis, highest: highest.collect(), sorted }
    }

    /// The range of boxes that can overlap `around`: boxes before it end too early, boxes behind it start too late.
    fn window(&self, around: &Bounds) -> Range<usize> {
        let first = self.highest.partition_point(|&highest| highest < around.low[self.axis]);
        let last = self.sorted.partition_point(|(bounds, _)| bounds.low[self.axis] <= around.high[self.axis]);
        first.min(last)..last
    }

    /// Calls `take` with the index of every box that is not apart from `around`.
    fn near(&self, around: &Bounds, mut take: impl FnMut(usize)) {
        for (bounds, place) in &self.sorted[self.window(around)] {
            if !around.is_apart(bounds) {
                take(*place);
            }
        }
    }
}

/// The bounding box of some points; in the plane its third axis has zeros.
struct Bounds {
    low: [f64; 3],
    high: [f64; 3],
}

impl Bounds {
    fn of(scene: &Scene, simplex: &[Vertex]) -> Bounds {
        let point = |&v: &Vertex| -> [f64; 3] {
            match (scene.dimension(), scene.point(v)) {
                (Dimension::Two, point) => [point[0], point[1], 0.0],
                (Dimension::Three, point) => [point[0], point[1], point[2]],
            }
        };
        let [mut low, mut high] = [point(simplex.first().expect("a simplex has vertices")); 2];
        for point in simplex[1..].iter().map(point) {
            for axis in 0..3 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        Bounds { low, high }
    }

    fn is_apart(&self, other: &Bounds) -> bool {
        (0..3).any(|axis| self.high[axis] < other.low[axis] || other.high[axis] < self.low[axis])
    }
}
