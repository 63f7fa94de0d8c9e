//! Samples of answers compared with each other: argument orders and relations.
//!
//! The laws themselves are in the crate `laws`; this file selects the tuples of a scene. The choice depends on indices
//! only, never on chance or time, so a finding is reproducible.
//!
//! The comparison of every query with the truth already shows that ties are broken and no sign is changed, so those two
//! laws are not checked again.

use predicament_laws::axioms::{
    Law, Relation, Violation, Zeros, antisymmetry_of_all, independence_of_later_vertices_of_all, independence_of_place,
    relations, transitivity_of_all,
};
use predicament_predicates::{Axis, Dimension, Plane, QuerySet, Question, Scene, Vertex, ZeroMeaning};
use rayon::prelude::*;

use super::CHUNK;
use super::class::Given;
use crate::{Asked, Budget, Class, ClassCounts, Finding, Stop, Watch};

/// The violations of laws: all are counted, and the first are kept. There can be millions.
#[derive(Default)]
pub(super) struct Violations {
    /// Queries whose own answer was legal, but contradicted another order of the arguments: they leave these classes.
    pub moved: ClassCounts,
    /// The number of violated relations between different queries.
    pub relations: u64,
    first: Vec<Violation>,
}

/// The number of brackets of a relation.
const BRACKETS: usize = 6;

/// A violation, and the class that its query leaves.
type Found = Option<(Option<Class>, Violation)>;

pub(super) fn check(given: &Given<'_>, asked: &Asked<'_>) -> Result<Violations, Stop> {
    let (budget, watch) = (asked.budget, asked.watch);
    let mut found = orders(given, budget, watch)?;
    let zeros = Zeros::promised(|kind| asked.contract(kind));
    found.merge(related(given, zeros, budget, watch)?, budget);
    if budget.thorough {
        found.merge(places(given, budget, watch)?, budget);
        found.merge(later_vertices(given, asked, zeros)?, budget);
    }
    Ok(found)
}

impl Violations {
    /// Records a violation of a query that leaves its class, or of a relation between queries.
    fn note(&mut self, leaves: Option<Class>, violation: Violation, budget: Budget) {
        match leaves {
            Some(class) => self.moved.add(class, 1),
            None => self.relations += 1,
        }
        if self.first.len() < budget.findings_per_class {
            self.first.push(violation);
        }
    }

    /// Adds later violations.
    fn merge(&mut self, later: Violations, budget: Budget) {
        self.moved.merge(&later.moved);
        self.relations += later.relations;
        self.first.extend(later.first);
        self.first.truncate(budget.findings_per_class);
    }

    /// The first violations, in words.
    pub fn findings(&self) -> impl Iterator<Item = Finding> {
        self.first.iter().map(|violation| {
            let answers = &violation.answers;
            let queries = answers.iter().map(|answer| answer.question.query(&answer.args)).collect();
            let got = answers.iter().map(|answer| answer.sign.symbol()).collect();
            Finding::plain(Class::Inconsistent, violation.law.name(), queries, got, String::new())
        })
    }
}

/// Checks all orders of the arguments of evenly spread queries, as many as the budget allows.
fn orders(given: &Given<'_>, budget: Budget, watch: &Watch) -> Result<Violations, Stop> {
    let question = given.queries.question();
    let orders: usize = (1..=question.kind().arity()).product();
    let sample: Vec<usize> = Budget::spread(given.queries.len(), orders, budget.permutations).collect();
    let zero = given.contract.zero;
    in_chunks(&sample, orders, budget, watch, |sample| {
        let queries: Vec<&[Vertex]> = sample.iter().map(|&query| given.queries.args(query)).collect();
        let violations = antisymmetry_of_all(given.session, question, &queries, zero);
        let leaves = |(&query, violations): (&usize, Vec<Violation>)| {
            let violation = violations.into_iter().next()?;
            let class = given.class(query);
            class.is_legal().then_some((Some(class), violation))
        };
        sample.iter().zip(violations).map(leaves).collect()
    })
}

/// Checks transitivity and the three-term relations on evenly spread tuples of vertices; without plenty of time, only
/// the relations of comparisons alone and of orientations alone.
fn related(given: &Given<'_>, zeros: Zeros, budget: Budget, watch: &Watch) -> Result<Violations, Stop> {
    let session = given.session;
    let mut found = Violations::default();
    let asked = asked(given, budget.thorough);
    for question in asked {
        if let Question::Compare(axis) = question {
            let sample: Vec<[Vertex; 3]> = tuples(given, 3, budget.relations)
                .iter()
                .filter_map(|tuple| tuple.as_slice().try_into().ok())
                .collect();
            let zero = zeros.of(question.kind());
            let look = |sample: &[[Vertex; 3]]| of_relations(transitivity_of_all(session, axis, sample, zero));
            found.merge(in_chunks(&sample, 3, budget, watch, look)?, budget);
        }
        let lifted = question.kind().is_lifted();
        let wanted = |relation: &Relation| budget.thorough || (!lifted && relation.law() == Law::GrassmannPlucker);
        for relation in relations(question).into_iter().filter(wanted) {
            let supported = relation.questions().all(|question| session.supports(question.kind()).is_ok());
            let sample = if supported { tuples(given, relation.vertices(), budget.relations) } else { Vec::new() };
            let look = |sample: &[Vec<Vertex>]| of_relations(relation.check_all(session, sample, zeros));
            found.merge(in_chunks(&sample, BRACKETS, budget, watch, look)?, budget);
        }
    }
    Ok(found)
}

/// The scene's own question; with plenty of time, also the question along the other axes and in the other planes.
fn asked(given: &Given<'_>, thorough: bool) -> Vec<Question> {
    let own = given.queries.question();
    let axes = [Axis::X, Axis::Y, Axis::Z];
    match (own, given.scene.dimension()) {
        (Question::Compare(_), dimension) if thorough => {
            axes.into_iter().take(dimension.count()).map(Question::Compare).collect()
        }
        (Question::Orient2d(_), Dimension::Three) if thorough => {
            [Plane::Xy, Plane::Yz, Plane::Zx].map(Question::Orient2d).into()
        }
        _ => vec![own],
    }
}

/// The number of queries in a batch of the check: not a multiple of any backend's batch size.
const BATCH: usize = 61;

/// Compares evenly spread queries alone and in batches.
fn places(given: &Given<'_>, budget: Budget, watch: &Watch) -> Result<Violations, Stop> {
    let sample: Vec<usize> = Budget::spread(given.queries.len(), 1, budget.relations).collect();
    let batches: Vec<QuerySet> = sample
        .chunks(BATCH)
        .map(|queries| {
            let args = queries.iter().flat_map(|&query| given.queries.args(query)).copied().collect();
            QuerySet::new(given.queries.question(), args)
        })
        .collect();
    in_chunks(&batches, BATCH, budget, watch, |batches| {
        of_relations(batches.iter().map(|batch| independence_of_place(given.session, batch)).collect())
    })
}

/// Compares evenly spread queries about the first half of the vertices with a scene that has only these. (Not for
/// constructed vertices or two meshes: those scenes are not lists of points.)
fn later_vertices(given: &Given<'_>, asked: &Asked<'_>, zeros: Zeros) -> Result<Violations, Stop> {
    let (scene, question, budget) = (given.scene, given.queries.question(), asked.budget);
    let listed = scene.constructions().is_empty() && scene.second_mesh().is_none();
    let half = scene.len().div_ceil(2);
    let coordinates = scene.coordinates()[..half * scene.dimension().count()].to_vec();
    let first = Scene::new(scene.dimension(), coordinates).ok().map(|first| first.with_weights_of(scene));
    let first = first.filter(|_| listed && zeros.of(question.kind()) != ZeroMeaning::Band);
    let Some(first) = first else { return Ok(Violations::default()) };
    let within: Vec<&[Vertex]> = (0..given.queries.len())
        .map(|query| given.queries.args(query))
        .filter(|args| args.iter().all(|v| v.index() < half))
        .collect();
    let sample: Vec<&[Vertex]> = Budget::spread(within.len(), 1, budget.relations).map(|at| within[at]).collect();
    let mut found = Ok(Violations::default());
    let prepared = asked.backend.with_session(&first, &mut |fewer| {
        found = in_chunks(&sample, 1, budget, asked.watch, |sample| {
            of_relations(independence_of_later_vertices_of_all(fewer, given.session, question, sample))
        });
    });
    // A backend that declines the smaller scene has not answered anything about it.
    prepared.map_or_else(|_| Ok(Violations::default()), |()| found)
}

/// Distinct vertices: half of the tuples are neighbours in the query list (they
/// share a degeneracy), half are spread over the scene.
fn tuples(given: &Given<'_>, size: usize, wanted: usize) -> Vec<Vec<Vertex>> {
    let flat = given.queries.flat();
    if flat.len() < size {
        return Vec::new();
    }
    let windows = flat.len() - size + 1;
    let near = Budget::spread(windows, 1, wanted.div_ceil(2)).map(|at| flat[at..at + size].to_vec());
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

/// Violations between different queries, which leave no class.
fn of_relations(violations: Vec<Option<Violation>>) -> Vec<Found> {
    violations.into_iter().map(|violation| Some((None, violation?))).collect()
}

/// Checks all items in parallel, in chunks, records violations in order, and stops if the watch says so. An item costs
/// `cost` queries; a chunk has at most as many queries as a chunk of the scene's own.
fn in_chunks<T: Sync>(
    items: &[T],
    cost: usize,
    budget: Budget,
    watch: &Watch,
    look: impl Fn(&[T]) -> Vec<Found> + Sync,
) -> Result<Violations, Stop> {
    let chunks: Result<Vec<Violations>, Stop> = items
        .par_chunks((CHUNK / cost).max(1))
        .map(|chunk| {
            let mut found = Violations::default();
            for (leaves, violation) in look(chunk).into_iter().flatten() {
                found.note(leaves, violation, budget);
            }
            watch.done(0).map(|()| found)
        })
        .collect();
    let mut all = Violations::default();
    chunks?.into_iter().for_each(|found| all.merge(found, budget));
    Ok(all)
}
