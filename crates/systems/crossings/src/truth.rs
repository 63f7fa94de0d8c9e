//! The crossings by linear equations in rationals, segment by segment.
//!
//! Every pair of segments is solved for the two fractions at which they meet. The crossings of a segment are sorted by
//! these fractions. The computation uses no predicate, no constructed vertex and no broad phase.
//!
//! A perturbed scene has only signs. There, too, every pair is checked, and a crossing's rank along its segment is the
//! number of crossings before it.

use predicament_judge::{Judged, TieJudge, rational, sign};
use predicament_predicates::{Axis, Construction, Plane, Predicates, Question, Scene, Sign, Vertex};
use rayon::prelude::*;
use rug::Rational;

use predicament_tasks::{Stop, Watch};

/// The crossings along a segment: groups of segments that cross it in one point, ascending.
pub type Along = Vec<Vec<u32>>;

/// The crossings of each segment.
///
/// # Errors
/// [`Stop`] if the watch stops the computation.
///
/// # Panics
/// If there are 2^32 segments.
pub fn crossings(scene: &Scene, segments: &[[Vertex; 2]], watch: &Watch) -> Result<Vec<Along>, Stop> {
    let ends: Vec<[[Rational; 2]; 2]> =
        segments.iter().map(|ends| ends.map(|v| scene.point2(Plane::Xy, v).map(rational))).collect();
    let boxes: Vec<[[f64; 2]; 2]> = segments.iter().map(|&ends| extent(scene, ends)).collect();
    let of = |at: usize| -> Result<Along, Stop> {
        let others = (0..ends.len()).filter(|&other| other != at && overlap(boxes[at], boxes[other]));
        let mut found: Vec<(Rational, u32)> = others
            .filter_map(|other| {
                let number = u32::try_from(other).expect("fewer than 2^32 segments");
                Some((crossing(&ends[at], &ends[other])?, number))
            })
            .collect();
        found.sort();
        let mut along: Along = Vec::new();
        for (place, (fraction, other)) in found.iter().enumerate() {
            match along.last_mut() {
                Some(group) if found[place - 1].0 == *fraction => group.push(*other),
                _ => along.push(vec![*other]),
            }
        }
        watch.done(1).map(|()| along)
    };
    (0..ends.len()).into_par_iter().map(of).collect()
}

fn extent(scene: &Scene, [a, b]: [Vertex; 2]) -> [[f64; 2]; 2] {
    let (a, b) = (scene.point2(Plane::Xy, a), scene.point2(Plane::Xy, b));
    [0, 1].map(|axis: usize| [a[axis].min(b[axis]), a[axis].max(b[axis])])
}

/// True if two boxes have a common point: comparing doubles is exact.
fn overlap(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> bool {
    a.iter().zip(b).all(|(a, b)| a[0] <= b[1] && b[0] <= a[1])
}

/// The fraction along the first segment at which the inner points of both meet in one point.
fn crossing([a, b]: &[[Rational; 2]; 2], [p, q]: &[[Rational; 2]; 2]) -> Option<Rational> {
    let minus = |u: &[Rational; 2], v: &[Rational; 2]| [0, 1].map(|i: usize| Rational::from(&u[i] - &v[i]));
    let cross = |[ux, uy]: &[Rational; 2], [vx, vy]: &[Rational; 2]| Rational::from(ux * vy) - Rational::from(uy * vx);
    let (along, other, between) = (minus(b, a), minus(q, p), minus(p, a));
    let determinant = cross(&along, &other);
    if determinant.cmp0().is_eq() {
        return None;
    }
    // a + t·along = p + s·other.
    let t = cross(&between, &other) / &determinant;
    let s = cross(&between, &along) / &determinant;
    let inside = |x: &Rational| x.cmp0().is_gt() && *x < 1;
    (inside(&t) && inside(&s)).then_some(t)
}

/// The fractions along the first segment between which it has points in common with the second one; `None` if it has
/// none. Both segments are closed. The fraction of a segment without a length is 0 to 1.
#[must_use]
pub fn common(scene: &Scene, one: [Vertex; 2], other: [Vertex; 2]) -> Option<[Rational; 2]> {
    let place = |v: Vertex| scene.point2(Plane::Xy, v).map(rational);
    let ([a, b], [p, q]) = (one.map(place), other.map(place));
    let minus = |u: &[Rational; 2], v: &[Rational; 2]| [0, 1].map(|i: usize| Rational::from(&u[i] - &v[i]));
    let cross = |[ux, uy]: &[Rational; 2], [vx, vy]: &[Rational; 2]| Rational::from(ux * vy) - Rational::from(uy * vx);
    let dot = |[ux, uy]: &[Rational; 2], [vx, vy]: &[Rational; 2]| Rational::from(ux * vx) + Rational::from(uy * vy);
    let (along, across, between) = (minus(&b, &a), minus(&q, &p), minus(&p, &a));
    let is_in = |x: &Rational| x.cmp0().is_ge() && *x <= 1;
    let determinant = cross(&along, &across);
    if !determinant.is_zero() {
        let t = cross(&between, &across) / &determinant;
        let s = cross(&between, &along) / &determinant;
        return (is_in(&t) && is_in(&s)).then(|| [t.clone(), t]);
    }
    let square = dot(&along, &along);
    if square.is_zero() {
        // A point: on the other segment, or equal to it.
        let length = dot(&across, &across);
        let back = minus(&a, &p);
        let is_on = if length.is_zero() {
            back.iter().all(Rational::is_zero)
        } else {
            cross(&across, &back).is_zero() && is_in(&(dot(&across, &back) / &length))
        };
        return is_on.then(|| [Rational::new(), Rational::from(1)]);
    }
    // Parallel, or the other one is a point.
    if !cross(&along, &between).is_zero() {
        return None;
    }
    let [s, t] = [&p, &q].map(|end| dot(&along, &minus(end, &a)) / &square);
    let (from, to) = if s <= t { (s, t) } else { (t, s) };
    let (from, to) = (from.max(Rational::new()), to.min(Rational::from(1)));
    (from <= to).then_some([from, to])
}

/// The crossings of each segment in a scene with broken ties; `None` if the judge does not construct a crossing.
///
/// # Errors
/// [`Stop`] if the watch stops the computation.
///
/// # Panics
/// If there are 2^32 segments.
pub fn perturbed(
    scene: &Scene,
    ties: &TieJudge,
    segments: &[[Vertex; 2]],
    watch: &Watch,
) -> Result<Option<Vec<Along>>, Stop> {
    let mut judged = Judged::perturbed(scene, ties);
    let crossings = |at: usize| -> Result<Vec<usize>, Stop> {
        watch.done(0)?;
        Ok((0..segments.len()).filter(|&other| other != at && cross(&judged, segments[at], segments[other])).collect())
    };
    let of: Vec<Vec<usize>> = (0..segments.len()).into_par_iter().map(crossings).collect::<Result<_, _>>()?;
    let definition = |at: usize, other: usize| Construction::Ssi([segments[at], segments[other]]);
    let all = of.iter().enumerate().flat_map(|(at, others)| others.iter().map(move |&other| definition(at, other)));
    let Ok(points) = judged.construct(&all.collect::<Vec<_>>()) else { return Ok(None) };
    let mut points = points.into_iter();
    let points: Vec<Vec<Vertex>> = of.iter().map(|others| points.by_ref().take(others.len()).collect()).collect();
    let along = |at: usize| -> Result<Along, Stop> {
        watch.done(0)?;
        let [a, b] = segments[at];
        // The axis is one on which the ends differ. The ends differ on at least one axis, as they are two vertices.
        let axes = [Axis::X, Axis::Y].map(|axis| (axis, judged.compare(axis, a, b)));
        let (axis, ahead) = axes.into_iter().find(|(_, sign)| *sign != Sign::Zero).unwrap_or((Axis::X, Sign::Zero));
        let before = |p: &&Vertex, q: Vertex| ahead != Sign::Zero && judged.compare(axis, **p, q) == ahead;
        let rank = |q: Vertex| points[at].iter().filter(|p| before(p, q)).count();
        let mut ranked: Vec<(usize, u32)> = of[at]
            .iter()
            .zip(&points[at])
            .map(|(&other, &q)| (rank(q), u32::try_from(other).expect("fewer than 2^32 segments")))
            .collect();
        ranked.sort_unstable();
        Ok(ranked.chunk_by(|p, q| p.0 == q.0).map(|group| group.iter().map(|&(_, other)| other).collect()).collect())
    };
    (0..segments.len()).into_par_iter().map(along).collect::<Result<_, _>>().map(Some)
}

/// True if the ends of each segment are on different sides of the other one.
fn cross(judged: &Judged<'_>, one: [Vertex; 2], other: [Vertex; 2]) -> bool {
    let parts = |[a, b]: [Vertex; 2], ends: [Vertex; 2]| {
        let [p, q] = ends.map(|end| judged.orient2d(Plane::Xy, a, b, end));
        p * q == Sign::Negative
    };
    parts(one, other) && parts(other, one)
}

/// True if an end of one segment is on the line of the other.
#[must_use]
pub fn touches(scene: &Scene, [a, b]: [Vertex; 2], [p, q]: [Vertex; 2]) -> bool {
    let on = |u, v, w| sign(scene, Question::Orient2d(Plane::Xy), &[u, v, w]).is_zero();
    on(a, b, p) || on(a, b, q) || on(p, q, a) || on(p, q, b)
}
