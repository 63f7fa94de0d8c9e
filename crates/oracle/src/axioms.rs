//! Samples of answers held against each other: argument orders and relations.
//!
//! The laws themselves are in the crate `checks`; this file picks which tuples
//! of a scene are asked. The choice depends on indices only, never on chance
//! or time, so a finding comes back in every run.
//!
//! That ties are broken at all, and no sign changed, is seen when every query
//! is held against the truth, so those two laws are not asked again.

use predicament_checks::axioms::{
    Law, Relation, Violation, Zeros, antisymmetry, independence_of_later_vertices, independence_of_place, relations,
    transitivity,
};
use predicament_predicates::{
    Axis, Backend, Contract, Dimension, Off, Plane, Predicates, QuerySet, Question, Scene, Vertex, ZeroMeaning,
};
use rayon::prelude::*;

use crate::outcome::Finding;
use crate::signs::{Budget, SignCase, class_of};
use crate::{Class, ClassCounts, Stop, Watch};

/// What the laws found: all is counted, the first violations are kept. There can be millions.
#[derive(Default)]
pub(crate) struct Violations {
    /// Queries whose own answer was legal, but contradicted by another order
    /// of the arguments: they leave these classes.
    pub moved: ClassCounts,
    /// Relations between different queries that don't hold.
    pub relations: u64,
    first: Vec<Violation>,
}

/// Queries or tuples to a chunk of the sample.
const CHUNK: usize = 256;

pub(crate) fn check<B: Backend, P: Predicates>(
    backend: &B,
    session: &P,
    contract: Contract,
    case: &SignCase,
    budget: Budget,
    watch: &Watch,
) -> Result<Violations, Stop> {
    let mut found = orders(session, contract, case, budget, watch)?;
    let zeros = Zeros::promised(|kind| backend.contract(kind));
    found.merge(related(session, zeros, case, budget, watch)?, budget);
    if budget.thorough {
        found.merge(places(session, case, budget, watch)?, budget);
        found.merge(later_vertices(backend, session, zeros, case, budget, watch)?, budget);
    }
    Ok(found)
}

impl Violations {
    /// Notes one, of a query that leaves its class or of a relation between queries.
    fn note(&mut self, leaves: Option<Class>, violation: Violation, budget: Budget) {
        match leaves {
            Some(class) => self.moved.add(class, 1),
            None => self.relations += 1,
        }
        if self.first.len() < budget.findings_per_class {
            self.first.push(violation);
        }
    }

    /// Adds what came after.
    fn merge(&mut self, later: Violations, budget: Budget) {
        self.moved.merge(&later.moved);
        self.relations += later.relations;
        self.first.extend(later.first);
        self.first.truncate(budget.findings_per_class);
    }

    /// The first ones, in words.
    pub fn findings(&self) -> impl Iterator<Item = Finding> {
        self.first.iter().map(|violation| {
            let answers = &violation.answers;
            let queries: Vec<_> = answers.iter().map(|answer| answer.question.describe(&answer.args)).collect();
            Finding {
                class: Class::Inconsistent,
                check: violation.law.name().to_owned(),
                query: queries.join(" | "),
                got: answers.iter().map(|answer| answer.sign.symbol()).collect(),
                truth: String::new(),
                log2_relative_det: None,
                distance_over_l: None,
                stage: None,
            }
        })
    }
}

/// All orders of the arguments of evenly spread queries, as many as the budget pays for.
fn orders<P: Predicates>(
    session: &P,
    contract: Contract,
    case: &SignCase,
    budget: Budget,
    watch: &Watch,
) -> Result<Violations, Stop> {
    let question = case.queries.question();
    let orders: usize = (1..=question.kind().arity()).product();
    let sample: Vec<usize> = affordable(case.queries.len(), orders, budget.permutations).collect();
    in_chunks(&sample, budget, watch, |&query| {
        let violation = antisymmetry(session, question, case.queries.args(query), contract.zero).into_iter().next()?;
        let class = class_of(session, contract, case, query);
        class.is_legal().then_some((Some(class), violation))
    })
}

/// Transitivity and the three-term relations on evenly spread tuples of vertices; in
/// a hurry only those of comparisons and orientations by themselves.
fn related(
    session: &dyn Predicates,
    zeros: Zeros,
    case: &SignCase,
    budget: Budget,
    watch: &Watch,
) -> Result<Violations, Stop> {
    let mut found = Violations::default();
    let asked = asked(case, budget.thorough);
    for question in asked {
        if let Question::Compare(axis) = question {
            let sample = tuples(case, 3, budget.relations);
            found.merge(
                in_chunks(&sample, budget, watch, |tuple| {
                    let &[a, b, c] = tuple.as_slice() else { return None };
                    transitivity(session, axis, [a, b, c], zeros.of(question.kind())).map(|violation| (None, violation))
                })?,
                budget,
            );
        }
        let lifted = matches!(question, Question::Incircle | Question::Insphere);
        let wanted = |relation: &Relation| budget.thorough || (!lifted && relation.law() == Law::GrassmannPlucker);
        for relation in relations(question).into_iter().filter(wanted) {
            let supported = relation.questions().all(|question| session.supports(question.kind()).is_ok());
            let sample = if supported { tuples(case, relation.vertices(), budget.relations) } else { Vec::new() };
            let look = |tuple: &Vec<Vertex>| relation.check(session, tuple, zeros).map(|violation| (None, violation));
            found.merge(in_chunks(&sample, budget, watch, look)?, budget);
        }
    }
    Ok(found)
}

/// The scene's own question; with plenty of time also the same along the other axes and in the other planes.
fn asked(case: &SignCase, thorough: bool) -> Vec<Question> {
    let own = case.queries.question();
    let axes = [Axis::X, Axis::Y, Axis::Z];
    match (own, case.scene.dimension()) {
        (Question::Compare(_), dimension) if thorough => {
            axes.into_iter().take(dimension.count()).map(Question::Compare).collect()
        }
        (Question::Orient2d(_), Dimension::Three) if thorough => {
            [Plane::Xy, Plane::Yz, Plane::Zx].map(Question::Orient2d).into()
        }
        _ => vec![own],
    }
}

/// Queries to a batch in which each is asked: not a multiple of what any batch takes at a time.
const BATCH: usize = 61;

/// Evenly spread queries alone and in batches.
fn places(session: &dyn Predicates, case: &SignCase, budget: Budget, watch: &Watch) -> Result<Violations, Stop> {
    let sample: Vec<usize> = affordable(case.queries.len(), 1, budget.relations).collect();
    let batches: Vec<QuerySet> = sample
        .chunks(BATCH)
        .map(|queries| {
            let args = queries.iter().flat_map(|&query| case.queries.args(query)).copied().collect();
            QuerySet::new(case.queries.question(), args)
        })
        .collect();
    in_chunks(&batches, budget, watch, |batch| independence_of_place(session, batch).map(|violation| (None, violation)))
}

/// Evenly spread queries about the first half of the vertices, in a scene that has no others. (Not
/// where vertices are constructed, nor where there are two meshes: those scenes are no list of points.)
fn later_vertices<B: Backend>(
    backend: &B,
    session: &dyn Predicates,
    zeros: Zeros,
    case: &SignCase,
    budget: Budget,
    watch: &Watch,
) -> Result<Violations, Stop> {
    let (scene, question) = (case.scene, case.queries.question());
    let listed = scene.constructions().is_empty() && scene.second_mesh().is_none();
    let half = scene.len().div_ceil(2);
    let coordinates = scene.coordinates()[..half * scene.dimension().count()].to_vec();
    let first = Scene::new(scene.dimension(), coordinates).ok();
    let first = first.filter(|_| listed && zeros.of(question.kind()) != ZeroMeaning::Band);
    let Some(first) = first else { return Ok(Violations::default()) };
    let Ok(fewer) = backend.prepare(&first, Off) else { return Ok(Violations::default()) };
    let within: Vec<&[Vertex]> = (0..case.queries.len())
        .map(|query| case.queries.args(query))
        .filter(|args| args.iter().all(|v| v.index() < half))
        .collect();
    let sample: Vec<&[Vertex]> = affordable(within.len(), 1, budget.relations).map(|at| within[at]).collect();
    in_chunks(&sample, budget, watch, |args| {
        independence_of_later_vertices(&fewer, session, question, args).map(|violation| (None, violation))
    })
}

/// Distinct vertices: half of the tuples are neighbours in the query list (they
/// share a degeneracy), half are spread over the scene.
fn tuples(case: &SignCase, size: usize, wanted: usize) -> Vec<Vec<Vertex>> {
    let flat = case.queries.flat();
    if flat.len() < size {
        return Vec::new();
    }
    let windows = flat.len() - size + 1;
    let near = affordable(windows, 1, wanted.div_ceil(2)).map(|at| flat[at..at + size].to_vec());
    // Weyl sequence: spreads indices evenly without a random source.
    let spread = (0..wanted / 2).map(|i| {
        let place = |j: usize| {
            let weyl = ((i * size + j) as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) % flat.len() as u64;
            usize::try_from(weyl).unwrap_or_default()
        };
        (0..size).map(|j| flat[place(j)]).collect()
    });
    near.chain(spread)
        .filter(|tuple: &Vec<Vertex>| {
            let mut sorted = tuple.clone();
            sorted.sort_unstable();
            sorted.windows(2).all(|pair| pair[0] != pair[1])
        })
        .collect()
}

/// Evenly spread numbers below n, as many as the budget pays for.
fn affordable(n: usize, cost: usize, budget: usize) -> impl Iterator<Item = usize> {
    (0..n).step_by((n * cost).div_ceil(budget.max(1)).max(1))
}

/// Looks at all items in parallel, notes what is found in order, and stops when the watch says so.
fn in_chunks<T: Sync>(
    items: &[T],
    budget: Budget,
    watch: &Watch,
    look: impl Fn(&T) -> Option<(Option<Class>, Violation)> + Sync,
) -> Result<Violations, Stop> {
    let chunks: Result<Vec<Violations>, Stop> = items
        .par_chunks(CHUNK)
        .map(|chunk| {
            let mut found = Violations::default();
            for (leaves, violation) in chunk.iter().filter_map(&look) {
                found.note(leaves, violation, budget);
            }
            watch.done(0).map(|()| found)
        })
        .collect();
    let mut all = Violations::default();
    chunks?.into_iter().for_each(|found| all.merge(found, budget));
    Ok(all)
}
