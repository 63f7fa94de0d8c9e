//! The tasks of predicates, one for each, formulas too: signs of one predicate.
//!
//! They cover Shewchuk's tests and every degenerate scene that fits into a list of queries. Each answer is compared
//! with the exact sign, and samples of answers with each other (the laws of predicates).

mod axioms;
mod checks;
mod class;
mod constructed;
mod content;
mod degeneracy;
mod draw;
mod each_class;
mod error;
mod explain;
pub mod families;
mod fixture;
mod judge;
mod queries;
pub use queries::axis;
mod random;
mod truth;
mod write;

use predicament_corpus::{Context, Family, InDecimals, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields, Written};
use predicament_predicates::{Derived, PredicateKind, Predicates, Query, QuerySet, Scene, Sign};
use rayon::prelude::*;

pub use class::classify;
pub use content::SignQueries;
pub use degeneracy::{Histogram, degeneracy};
pub use each_class::classes;
pub use families::adversaries;
pub use truth::truth;

use crate::output::{self, Canvas, Files};
use crate::{
    Agreement, Answer, Asked, Case, Check, Compared, Contestant, Dispute, ExplainError, Explanation, Halt, How, Knob,
    Outcome, Stop, Task, Turns, Watch, digest,
};

/// The number of queries in a chunk: small enough to stop soon, large enough to have no overhead.
const CHUNK: usize = 4096;

/// The task of the signs of one predicate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Signs {
    kind: PredicateKind,
}

impl Signs {
    /// The order of two vertices along an axis.
    pub const COMPARE: Signs = Signs { kind: PredicateKind::Compare };
    /// The turn of three vertices.
    pub const ORIENT2D: Signs = Signs { kind: PredicateKind::Orient2d };
    /// The side of a plane.
    pub const ORIENT3D: Signs = Signs { kind: PredicateKind::Orient3d };
    /// The inside of a circle.
    pub const INCIRCLE: Signs = Signs { kind: PredicateKind::Incircle };
    /// The inside of a sphere.
    pub const INSPHERE: Signs = Signs { kind: PredicateKind::Insphere };

    /// The task of a predicate.
    #[must_use]
    pub const fn of(kind: PredicateKind) -> Signs {
        Signs { kind }
    }

    /// The predicate.
    #[must_use]
    pub const fn kind(self) -> PredicateKind {
        self.kind
    }
}

/// The answers to all queries, in order.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Answers(pub Vec<Sign>);

impl Answer for Answers {
    fn digest(&self) -> u64 {
        digest(self.0.iter().map(|sign| sign.as_i8().cast_unsigned()))
    }
}

impl SceneFormat for Signs {
    fn name(&self) -> &'static str {
        self.kind.name()
    }

    fn template(&self) -> String {
        let indices: Vec<String> = (0..self.kind.arity()).map(|index| index.to_string()).collect();
        let points = first_points(self.kind).join(",\n@written     ");
        let points = match self.kind {
            PredicateKind::Derived(derived) => example_points(derived).join(",\n@written     "),
            _ => points,
        };
        include_str!("template.txt")
            .replace("{points}", &format!("[\n@written     {points},\n@written ]"))
            .replace("{arity}", &self.kind.arity().to_string())
            .replace("{indices}", &format!("[[{}]]", indices.join(", ")))
    }

    fn about(&self) -> &'static str {
        self.kind.about()
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "constructed", "queries", "axis", "plane", "fixture"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points", "p", "q", "r", "step"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        content::read(self.kind, context, fields)
    }

    fn in_decimals(&self) -> InDecimals {
        match self.kind {
            PredicateKind::Derived(_) => InDecimals::Never,
            _ => InDecimals::AnyDigits,
        }
    }

    fn families(&self) -> &'static [Family] {
        families::of(self.kind)
    }

    fn sample_keys(&self) -> &'static [&'static str] {
        &["p = [0.5, 0.5]", "q = [12, 12]", "r = [24, 24]", "side = 5", "dimension = 3"]
    }

    fn generator_keys(&self) -> &'static [&'static str] {
        &["dimension", "axis", "plane"]
    }

    fn naming_keys(&self) -> &'static [&'static str] {
        &["dimension", "plane", "axis"]
    }
}

impl Task for Signs {
    type Content = SignQueries;
    type Truth = Vec<Sign>;
    type Answer = Answers;

    fn compared(&self) -> &'static [Compared] {
        match self.kind {
            PredicateKind::Derived(_) => &[],
            PredicateKind::Insphere => {
                const {
                    &[
                        Compared::general("uniform", 500),
                        Compared::near("near", 500),
                        Compared::degenerate("degen", 500),
                    ]
                }
            }
            _ => {
                const {
                    &[
                        Compared::general("uniform", 1000),
                        Compared::near("near", 1000),
                        Compared::degenerate("degen", 1000),
                    ]
                }
            }
        }
    }

    fn turns(&self, _: Knob) -> Turns {
        Turns::Everywhere
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![self.kind]
    }

    fn looks_at_watch(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, content: &SignQueries, watch: &Watch) -> Result<Vec<Sign>, Stop> {
        truth::truth(scene, &content.queries, watch)
    }

    fn truth_as_written(
        &self,
        scene: &Scene,
        content: &SignQueries,
        written: &Written,
        watch: &Watch,
    ) -> Result<Vec<Sign>, Stop> {
        truth::as_written(scene, &content.queries, written, watch)
    }

    fn agreement(
        &self,
        _: &Case<'_, Signs>,
        written: &Case<'_, Signs>,
        _: &Asked<'_>,
        answer: &Answers,
        own: &Outcome,
    ) -> Result<Agreement, Stop> {
        Ok(truth::agreement(&written.truth, &answer.0, own))
    }

    fn dispute(&self, case: &Case<'_, Signs>) -> Option<Dispute> {
        truth::dispute(&case.content.queries, &case.truth, case.content.expected.as_deref()?)
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &SignQueries,
        how: &How<'_>,
        answer: &mut Answers,
    ) -> Result<(), Halt> {
        // The call of a batch is dynamic; its queries are not.
        signs(&*session, content, how, &mut answer.0)?;
        Ok(())
    }

    fn queries<'c>(&self, content: &'c SignQueries) -> Option<&'c QuerySet> {
        Some(&content.queries)
    }

    fn judge(
        &self,
        case: &Case<'_, Signs>,
        asked: &Asked<'_>,
        answer: &Answers,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, &answer.0, outcome)
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn describe(&self, loaded: &LoadedScene, content: &SignQueries, _: &Watch) -> Result<String, Stop> {
        let histogram = degeneracy(&loaded.scene, &content.queries);
        Ok(format!("{} queries; log2(|det| / permanent):\n{histogram}", content.queries.len()))
    }

    fn explain(
        &self,
        scene: &Scene,
        _: &SignQueries,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        explain::explain(scene, query, backends)
    }

    fn write(
        &self,
        scene: &Scene,
        content: &SignQueries,
        answer: &Answers,
        files: &mut Files,
    ) -> Result<(), output::Error> {
        write::write(scene, &content.queries, &answer.0, files)
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &SignQueries,
        _: Option<&Answers>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        draw::draw(scene, &content.queries, canvas)
    }
}

/// Computes all answers of a session, in order, on the threads of the current pool.
fn signs(session: &dyn Predicates, content: &SignQueries, how: &How<'_>, out: &mut Vec<Sign>) -> Result<(), Stop> {
    let queries = &content.queries;
    out.resize(queries.len(), Sign::Zero);
    let batch = |(chunk, out): (usize, &mut [Sign])| {
        queries.ask_batch(session, chunk * CHUNK..chunk * CHUNK + out.len(), out);
        how.watch.done(out.len() as u64)
    };
    if out.len() <= CHUNK || rayon::current_num_threads() == 1 {
        return out.chunks_mut(CHUNK).enumerate().try_for_each(batch);
    }
    out.par_chunks_mut(CHUNK).enumerate().try_for_each(batch)
}

/// Example points of the template for a formula.
fn example_points(derived: Derived) -> Vec<String> {
    let point = |at: usize| {
        let axis = at % derived.formula().dimension();
        let coordinates =
            (0..derived.formula().dimension()).map(|k| if k == axis { (at + 1).to_string() } else { "0".to_owned() });
        let weight = derived.formula().is_weighted().then(|| "0".to_owned());
        format!("[{}]", coordinates.chain(weight).collect::<Vec<_>>().join(", "))
    };
    (0..derived.formula().arity()).map(point).collect()
}

/// Example points of the template, for which plain doubles are wrong, or nearly.
fn first_points(kind: PredicateKind) -> &'static [&'static str] {
    match kind {
        PredicateKind::Compare => &["[0, 0]", "[\"0x1p-1074\", 0]"],
        PredicateKind::Orient2d => &["[0.5, \"0x1.0000000000001p-1\"]", "[12, 12]", "[24, 24]"],
        PredicateKind::Orient3d => &["[0, 0, 0]", "[1, 0, 0]", "[0, 1, 0]", "[0.25, 0.25, \"0x1p-60\"]"],
        PredicateKind::Incircle => &["[1, 0]", "[0, 1]", "[-1, 0]", "[0, \"-0x1.0000000000001p+0\"]"],
        PredicateKind::Derived(_) => &[],
        PredicateKind::Insphere => {
            &["[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]", "[-1, 0, 0]", "[0, 0, \"-0x1.0000000000001p+0\"]"]
        }
    }
}
