//! Samples of answers held against each other: argument orders and relations.
//!
//! The laws themselves are in the crate `checks`; this file picks which tuples
//! of a scene are asked. The choice depends on indices only, never on chance
//! or time, so a finding comes back in every run.

use predicament_checks::axioms::{Violation, antisymmetry, grassmann_plucker2, grassmann_plucker3, transitivity};
use predicament_predicates::{Contract, PredicateKind, Predicates, Question, Vertex};
use rayon::prelude::*;

use crate::outcome::Finding;
use crate::signs::{Budget, SignCase, class_of, describe};
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

pub(crate) fn check<P: Predicates>(
    session: &P,
    contract: Contract,
    case: &SignCase,
    budget: Budget,
    watch: &Watch,
) -> Result<Violations, Stop> {
    let mut found = orders(session, contract, case, budget, watch)?;
    found.merge(relations(session, contract, case, budget, watch)?, budget);
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
            let queries: Vec<_> = answers.iter().map(|answer| describe(violation.question, &answer.args)).collect();
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
    let step = (case.queries.len() * orders).div_ceil(budget.permutations.max(1)).max(1);
    let sample: Vec<usize> = (0..case.queries.len()).step_by(step).collect();
    in_chunks(&sample, budget, watch, |&query| {
        let violation = antisymmetry(session, question, case.queries.args(query), contract.zero).into_iter().next()?;
        let class = class_of(session, contract, case, query);
        class.is_legal().then_some((Some(class), violation))
    })
}

/// Three-term relations and transitivity on evenly spread tuples of vertices.
fn relations<P: Predicates>(
    session: &P,
    contract: Contract,
    case: &SignCase,
    budget: Budget,
    watch: &Watch,
) -> Result<Violations, Stop> {
    let question = case.queries.question();
    let size = match question.kind() {
        PredicateKind::Compare => 3,
        PredicateKind::Orient2d => 5,
        PredicateKind::Orient3d => 6,
        PredicateKind::Incircle | PredicateKind::Insphere => return Ok(Violations::default()),
    };
    let sample = tuples(case, size, budget.relations);
    in_chunks(&sample, budget, watch, |tuple| {
        let violation = match (question, tuple.as_slice()) {
            (Question::Compare(axis), &[a, b, c]) => transitivity(session, axis, [a, b, c], contract.zero),
            (Question::Orient2d(plane), &[x, a, b, c, d]) => {
                grassmann_plucker2(session, plane, x, [a, b, c, d], contract.zero)
            }
            (Question::Orient3d, &[x, y, a, b, c, d]) => {
                grassmann_plucker3(session, [x, y], [a, b, c, d], contract.zero)
            }
            _ => None,
        };
        violation.map(|violation| (None, violation))
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
    let step = windows.div_ceil(wanted.div_ceil(2).max(1)).max(1);
    let near = (0..windows).step_by(step).map(|at| flat[at..at + size].to_vec());
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
