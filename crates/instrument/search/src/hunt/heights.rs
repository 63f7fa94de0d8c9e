//! The height of a scene: the measure that a hunt climbs before it finds anything.
//!
//! Each measure has its own island, so that measures need not be weighed against each other. Heights are integers
//! (thousandths), so that a hunt can be saved and resumed exactly. They decide nothing.
//!
//! Measures of signs: how degenerate a query is that is not a tie, how far rounding carries plain doubles, how
//! degenerate a query is that a backend settles before its last stage, and the number of ties. Measures of other tasks:
//! how near points are to points and lines, the number of points on them, the number of answers within a promise, and
//! the number of unwanted findings.

use predicament_corpus::LoadedScene;
use predicament_formats::bits::{lowest_bit, top_exponent};
use predicament_judge as judge;
use predicament_predicates::{Counts, Dimension, PredicateKind, Question, Scene, Vertex};
use predicament_tasks::signs::SignQueries;
use predicament_tasks::{Class, Contestant, Outcome, digest};

use super::Quarry;
use super::twofold::{Points, Rounding};

/// A measure of a scene's height.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Height {
    /// Its name.
    pub name: &'static str,
    /// Its meaning and unit.
    pub what: &'static str,
}

/// The measures of signs, in this order.
const OF_SIGNS: [Height; 4] = [
    Height { name: "degenerate", what: "-log2(|det| / permanent) of the most degenerate query that is not a tie" },
    Height {
        name: "rounding",
        what: "how far rounding carries a plain double determinant to the wrong side, in units of u times the \
               permanent",
    },
    Height {
        name: "shortcut",
        what: "-log2(|det| / permanent) of the most degenerate query that a backend settled before its last stage",
    },
    Height { name: "ties", what: "ties among the first vertices, of the predicate and of turns in the first plane" },
];
/// The index of the measure that is climbed without a backend.
pub(super) const ROUNDING: usize = 1;

/// The measures of other tasks, in this order.
const OF_OTHERS: [Height; 4] = [
    Height { name: "near", what: "-log2 of the least distance of a point to a point or a line, over the extent" },
    Height { name: "ties", what: "number of points on other points or on lines" },
    Height { name: "within promises", what: "answers that differ from the exact answer but are legal" },
    Height { name: "unwanted", what: "findings of other classes and checks than the wanted ones" },
];

/// The measures of a task's scenes.
#[must_use]
pub fn heights(task: &str) -> &'static [Height] {
    if kind_of(task).is_some() { &OF_SIGNS } else { &OF_OTHERS }
}

/// The predicate of a task of signs.
pub(super) fn kind_of(task: &str) -> Option<PredicateKind> {
    task.parse().ok()
}

/// The maximum degeneracy; larger values come from another range, not from more degeneracy.
const MOST_DEGENERATE: f64 = 160.0;

/// A measure, converted to thousandths.
fn thousandths(x: f64) -> i64 {
    #[allow(clippy::cast_possible_truncation)] // clamped
    let whole = (x.clamp(-1e6, 1e6) * 1000.0).floor() as i64;
    whole
}

/// The maximum number of queries that are measured.
const QUERIES: usize = 6;
/// The maximum number of vertices among which ties are counted.
const VERTICES: usize = 7;

/// The heights of a scene by each measure of its task.
pub(super) fn of(loaded: &LoadedScene, quarry: &Quarry<'_>, outcomes: &[Outcome]) -> Vec<i64> {
    match loaded.content::<SignQueries>() {
        Some(content) => of_signs(&loaded.scene, content, &quarry.shown_by),
        None => of_others(&loaded.scene, quarry, outcomes),
    }
}

fn of_signs(scene: &Scene, content: &SignQueries, backends: &[&dyn Contestant]) -> Vec<i64> {
    let question = content.queries.question();
    let mut degenerate = 0.0_f64;
    let mut rounding = f64::NEG_INFINITY;
    let mut relative = Vec::new();
    for query in 0..content.queries.len().min(QUERIES) {
        let args = content.queries.args(query);
        let log2 = judge::log2_relative(&judge::verdict(scene, question, args)).map(|log2| -log2);
        degenerate = degenerate.max(log2.unwrap_or(0.0));
        relative.push(log2.unwrap_or(0.0));
        if let Question::Derived(derived) = question {
            let one = Rounding::of_formula(derived, scene, args);
            rounding = rounding.max(one.wrong().unwrap_or_else(|| one.carried(2.0)));
        } else if let Some(points) = points(scene, question, args) {
            let one = Rounding::of(question.kind(), &points);
            rounding = rounding.max(one.wrong().unwrap_or_else(|| one.carried(2.0)));
        }
    }
    let shortcut = backends.first().map_or(0.0, |backend| shortcut(scene, content, *backend, &relative));
    vec![
        thousandths(degenerate.min(MOST_DEGENERATE)),
        thousandths(rounding),
        thousandths(shortcut.min(MOST_DEGENERATE)),
        ties_of(scene, question),
    ]
}

/// The coordinates of a query's points, with those of its plane first.
///
/// `None` if a vertex is constructed, and for formulas.
pub(super) fn points(scene: &Scene, question: Question, args: &[Vertex]) -> Option<Points> {
    if let Question::Derived(_) = question {
        return None;
    }
    let mut points = [[0.0; 3]; 5];
    for (place, &v) in points.iter_mut().zip(args) {
        if v.is_constructed() {
            return None;
        }
        for (x, axis) in place.iter_mut().zip(axes(question)) {
            *x = *scene.point(v).get(axis)?;
        }
    }
    Some(points)
}

/// The axes that a question uses, in its order.
pub(super) fn axes(question: Question) -> Vec<usize> {
    question.coordinates().to_vec()
}

/// The degeneracy of the most degenerate query that a backend settles before its last stage.
fn shortcut(scene: &Scene, content: &SignQueries, backend: &dyn Contestant, relative: &[f64]) -> f64 {
    let (question, stages) = (content.queries.question(), backend.stages().len());
    if stages < 2 {
        return 0.0;
    }
    let counts = Counts::new();
    let mut highest = 0.0_f64;
    // A backend that declines the predicate has no shortcut.
    let _ = backend.with_counted_session(scene, &counts, &mut |session| {
        if session.supports(question.kind()).is_err() {
            return;
        }
        for (query, &log2) in relative.iter().enumerate() {
            let last = || counts.get(question.kind(), stages - 1);
            let before = last();
            let _ = question.ask(session, content.queries.args(query));
            if last() == before {
                highest = highest.max(log2);
            }
        }
    });
    highest
}

/// The number of ties among the first vertices at different positions: ties of the predicate, and of turns in the first
/// plane. Points at one position count too.
fn ties_of(scene: &Scene, question: Question) -> i64 {
    let vertices: Vec<Vertex> = scene.vertices().take(VERTICES).collect();
    let mut ties = 0;
    for (kind, of) in [
        (question.kind(), axes(question)),
        (PredicateKind::Orient2d, (0..scene.dimension().count().min(2)).collect()),
        (PredicateKind::Compare, (0..scene.dimension().count()).collect()),
    ] {
        if let PredicateKind::Derived(_) = kind {
            // Turns and comparisons count; ties of a formula would need its exact value for each choice.
            continue;
        }
        subsets(vertices.len(), kind.arity(), &mut |chosen| {
            let mut points = [[0.0; 3]; 5];
            for (place, &at) in points.iter_mut().zip(chosen) {
                for (x, &axis) in place.iter_mut().zip(&of) {
                    *x = scene.point(vertices[at]).get(axis).copied().unwrap_or(0.0);
                }
            }
            let places = &points[..kind.arity()];
            let coincide = (1..places.len()).any(|at| places[..at].contains(&places[at]));
            // Points at one position make every query about them a tie: one tie is enough.
            ties += i64::from(if kind.arity() == 2 {
                coincide
            } else {
                !coincide && Rounding::of(kind, &points).vanishes()
            });
        });
    }
    1000 * ties
}

/// Calls `visit` with each choice of `k` of the first `n` numbers, in order.
fn subsets(n: usize, k: usize, visit: &mut impl FnMut(&[usize])) {
    fn go(from: usize, n: usize, k: usize, chosen: &mut Vec<usize>, visit: &mut impl FnMut(&[usize])) {
        if chosen.len() == k {
            return visit(chosen);
        }
        for at in from..n {
            chosen.push(at);
            go(at + 1, n, k, chosen, visit);
            chosen.pop();
        }
    }
    go(0, n, k, &mut Vec::new(), visit);
}

/// The maximum number of points whose distances are measured.
const NEIGHBOURS: usize = 16;

fn of_others(scene: &Scene, quarry: &Quarry<'_>, outcomes: &[Outcome]) -> Vec<i64> {
    let count = |is: &dyn Fn(Class) -> bool| -> u64 {
        let of = |outcome: &Outcome| {
            Class::ALL.into_iter().filter(|&class| is(class)).map(|c| outcome.counts.get(c)).sum::<u64>()
        };
        outcomes.iter().map(of).sum()
    };
    let legal = count(&|class| class.is_legal() && class != Class::Agree);
    let unwanted = count(&|class| !class.is_legal() && quarry.wanted.class != Some(class) && class != Class::Declined);
    let (near, ties) = nearness(scene);
    let whole = |n: u64| i64::try_from(n.min(1_000_000)).unwrap_or(0) * 1000;
    vec![thousandths(near), ties, whole(legal), whole(unwanted)]
}

/// The nearness of a scene's points to each other and to the lines through two of them, and the number of points on
/// them.
fn nearness(scene: &Scene) -> (f64, i64) {
    let points: Vec<&[f64]> = scene.vertices().take(NEIGHBOURS).map(|v| scene.point(v)).collect();
    let apart = |p: &[f64], q: &[f64]| p.iter().zip(q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let extent = points.iter().flat_map(|p| points.iter().map(|q| apart(p, q))).fold(0.0, f64::max);
    let (mut least, mut ties) = (extent, 0);
    let mut note = |distance: f64| {
        if distance == 0.0 {
            ties += 1000;
        } else if distance < least {
            least = distance;
        }
    };
    subsets(points.len(), 2, &mut |pair| note(apart(points[pair[0]], points[pair[1]])));
    if scene.dimension() == Dimension::Two {
        subsets(points.len(), 3, &mut |three| {
            let mut rows = [[0.0; 3]; 5];
            for (row, &at) in rows.iter_mut().zip(three) {
                row[..2].copy_from_slice(&points[at][..2]);
            }
            let longest = subsets_of_three().map(|[a, b]| apart(points[three[a]], points[three[b]]));
            let longest = longest.into_iter().fold(0.0, f64::max);
            if longest > 0.0 {
                note(Rounding::of(PredicateKind::Orient2d, &rows).nearly.abs() / longest);
            }
        });
    }
    let near = (extent / least).log2();
    (if near.is_finite() { near.min(MOST_DEGENERATE) } else { 0.0 }, ties)
}

const fn subsets_of_three() -> [[usize; 2]; 3] {
    [[0, 1], [0, 2], [1, 2]]
}

/// A hash of a scene's behaviour: classes and stages by orders of magnitude, checks with findings, how large and fine
/// its coordinates are, and how degenerate it is.
pub(super) fn conduct(loaded: &LoadedScene, outcomes: &[Outcome], heights: &[i64]) -> u64 {
    let order = |count: u64| u64::BITS - count.leading_zeros();
    let mut text = String::new();
    for outcome in outcomes {
        for class in Class::ALL {
            text += &format!("{} ", order(outcome.counts.get(class)));
        }
        for (stage, settled) in &outcome.stages {
            text += &format!("{stage} {} ", order(*settled));
        }
        let mut checks: Vec<&str> = outcome.findings.iter().map(|finding| finding.check.as_str()).collect();
        checks.sort_unstable();
        checks.dedup();
        text += &checks.join(" ");
    }
    let coordinates = loaded.scene.coordinates();
    let top = coordinates.iter().filter_map(|&x| top_exponent(x)).max().unwrap_or(0);
    let low = coordinates.iter().filter_map(|&x| lowest_bit(x)).min().unwrap_or(0);
    text += &format!(" {} {} {}", top.div_euclid(128), low.div_euclid(128), heights.first().map_or(0, |h| h / 8000));
    digest(text.bytes())
}
