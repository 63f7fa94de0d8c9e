//! A law about a predicate, and its check on a tuple of vertices.

use predicament_laws::axioms::{
    Law, Relation, Violation, Zeros, antisymmetry, equals_reference, independence_of_later_vertices,
    independence_of_place, never_zero, relations, transitivity,
};
use predicament_predicates::{
    Axis, Derived, Dimension, Plane, PredicateKind, Predicates, QuerySet, Question, Vertex, ZeroMeaning,
};

/// A law about a predicate.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Check {
    law: Law,
    question: Question,
    relation: Option<Relation>,
}

/// All laws about scenes of this dimension.
#[must_use]
pub fn checks(dimension: Dimension) -> Vec<Check> {
    let axes = [Axis::X, Axis::Y, Axis::Z].into_iter().take(dimension.count()).map(Question::Compare);
    let questions: Vec<Question> = match dimension {
        Dimension::Two => axes.chain([Question::Orient2d(Plane::Xy), Question::Incircle]).collect(),
        Dimension::Three => {
            let planes = [Plane::Xy, Plane::Yz, Plane::Zx].map(Question::Orient2d);
            let formulas = Derived::shipped()
                .iter()
                .filter(|formula| formula.formula().is_determinant() && formula.dimension() == dimension);
            let formulas = formulas.map(|&formula| Question::Derived(formula));
            axes.chain(planes).chain([Question::Orient3d, Question::Insphere]).chain(formulas).collect()
        }
    };
    let mut checks = Vec::new();
    for law in Law::ALL {
        for &question in &questions {
            let check = Check { law, question, relation: None };
            match (law, question) {
                (Law::Transitivity, Question::Compare(_)) => checks.push(check),
                (Law::Transitivity, _) => {}
                (Law::GrassmannPlucker | Law::MixedGrassmannPlucker, _) => {
                    let of_law = relations(question).into_iter().filter(|relation| relation.law() == law);
                    checks.extend(of_law.map(|relation| Check { relation: Some(relation), ..check.clone() }));
                }
                _ => checks.push(check),
            }
        }
    }
    checks
}

/// The sessions for checking a tuple.
pub(super) struct Sessions<'a> {
    /// The backend's session, of the whole scene.
    pub session: &'a dyn Predicates,
    /// The backend's session, of the first vertices.
    pub fewer: Option<&'a dyn Predicates>,
    /// An exact session.
    pub reference: &'a dyn Predicates,
    /// The backend's meaning of zero.
    pub zeros: Zeros,
    /// Returns true if a query is zero however the input moves.
    pub is_identity: &'a dyn Fn(Question, &[Vertex]) -> bool,
}

impl Check {
    /// The law of the check.
    #[must_use]
    pub fn law(&self) -> Law {
        self.law
    }

    /// The names of the law's predicates, as in `compare+orient2d`.
    #[must_use]
    pub fn subject(&self) -> String {
        let mut kinds = self.kinds();
        kinds.sort_unstable();
        kinds.dedup();
        kinds.into_iter().map(PredicateKind::name).collect::<Vec<_>>().join("+")
    }

    /// The predicates that the check queries.
    #[must_use]
    pub fn kinds(&self) -> Vec<PredicateKind> {
        match &self.relation {
            Some(relation) => relation.questions().map(Question::kind).collect(),
            None => vec![self.question.kind()],
        }
    }

    /// The number of vertices of a tuple.
    #[must_use]
    pub fn vertices(&self) -> usize {
        match &self.relation {
            Some(relation) => relation.vertices(),
            None if self.law == Law::Transitivity => 3,
            None => self.question.kind().arity(),
        }
    }

    /// Returns true if a backend with this meaning of zero promises the law.
    pub(super) fn is_promised(&self, zeros: Zeros) -> bool {
        let zero = zeros.of(self.question.kind());
        match self.law {
            Law::NeverZero => zero == ZeroMeaning::Never,
            // A tolerance depends on the extent of the scene.
            Law::LaterVertices => zero != ZeroMeaning::Band,
            _ => true,
        }
    }

    /// The first `n` vertices of a scene in every order that can make a difference.
    pub(super) fn tuples(&self, n: usize) -> Vec<Vec<Vertex>> {
        if let Some(relation) = &self.relation {
            return relation.tuples(n).collect();
        }
        let mut all: Vec<Vec<Vertex>> = vec![Vec::new()];
        // One law covers the order of arguments, another the direction of a comparison.
        let ordered = self.law == Law::Transitivity;
        for _ in 0..self.vertices() {
            let next = |tuple: &Vec<Vertex>| {
                let from = if ordered { 0 } else { tuple.last().map_or(0, |v| v.index() + 1) };
                let others = (from..n).map(Vertex::input).filter(|v| !tuple.contains(v));
                others.map(|v| [tuple.as_slice(), &[v]].concat()).collect()
            };
            all = all.iter().flat_map::<Vec<_>, _>(next).collect();
        }
        all
    }

    /// Returns true if tuples are checked together, in batches of queries.
    pub(super) fn in_batches(&self) -> bool {
        self.law == Law::Place
    }

    /// Checks one tuple, or several one after the other for a law about batches.
    pub(super) fn look(&self, on: &Sessions<'_>, tuple: &[Vertex]) -> Option<Violation> {
        let (session, question) = (on.session, self.question);
        let zero = on.zeros.of(question.kind());
        match (self.law, question) {
            (Law::NeverZero, _) => never_zero(session, question, tuple, zero, |args| (on.is_identity)(question, args)),
            (Law::Antisymmetry, _) => antisymmetry(session, question, tuple, zero).into_iter().next(),
            (Law::Transitivity, Question::Compare(axis)) => {
                transitivity(session, axis, [tuple[0], tuple[1], tuple[2]], zero)
            }
            (Law::Place, _) => independence_of_place(session, &QuerySet::new(question, tuple.to_vec())),
            (Law::LaterVertices, _) => independence_of_later_vertices(on.fewer?, session, question, tuple),
            (Law::Reference, _) => equals_reference(session, on.reference, question, tuple, zero),
            _ => self.relation.as_ref().and_then(|relation| relation.check(session, tuple, on.zeros)),
        }
    }
}
