//! `distance`: the minimum distance of two objects, and the pairs of features that are nearest.
//!
//! Collision detection, clearances and contacts all ask this question. Parallel edges and faces have many nearest
//! points, and rounding decides between pairs whose distances differ by less than an ulp.

mod bands;
mod checks;
pub mod content;
mod generate;
mod judge;
mod read;
mod replies;
mod spoiled;

use crate::algorithm::questions::asks;
use crate::algorithm::{Indexed, nearest};
use crate::answer::{Feature, Nearest};
use crate::truth::{Truth, measured, root};
use predicament_corpus::{Context, Family, LoadedScene, SceneFormat, Source};
use predicament_formats::{CorpusError, Fields};
use predicament_judge::nearest as nearest_double;
use predicament_predicates::{Declined, Dimension, PredicateKind, Predicates, Query, Scene};
use predicament_report::drawing::{Role, Shape};

pub use content::TwoObjects;

use predicament_tasks::output::{Canvas, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, ExplainError, Explanation, Halt, How, Knob, Outcome, Phase,
    Refusal, Spoiled, Stop, Task, Turns, Watch, digest, output,
};

/// The task `distance`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Distance;

impl Answer for Nearest {
    fn digest(&self) -> u64 {
        let number = |at: usize| u32::try_from(at).expect("ids have 32 bits");
        let of_feature = |feature: &Feature| {
            let corners = feature.corners().iter().map(|v| number(v.index()));
            std::iter::once(number(feature.rank())).chain(corners).collect::<Vec<u32>>()
        };
        let pairs = self.pairs.iter().flatten().flat_map(of_feature);
        digest([self.kind as u32].into_iter().chain(pairs).flat_map(u32::to_le_bytes))
    }
}

impl SceneFormat for Distance {
    fn name(&self) -> &'static str {
        "distance"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "the minimum distance of two polygons or meshes, and the pairs of features that are nearest"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "from", "to"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["from", "to"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        read::read(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &generate::FAMILIES
    }
}

impl Task for Distance {
    type Content = TwoObjects;
    type Truth = Truth;
    type Answer = Nearest;

    fn has_two_meshes(&self) -> bool {
        true
    }

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("distance-spheres", 96),
                Compared::near("distance-near-lattices", 96),
                Compared::degenerate("distance-lattices", 96),
            ]
        }
    }

    fn replies(&self) -> Option<&'static dyn Replies<Distance>> {
        Some(&replies::Judge)
    }

    fn turns(&self, _: Knob) -> Turns {
        Turns::Everywhere
    }

    fn asks(&self, scene: &Scene) -> Vec<PredicateKind> {
        let side = (scene.dimension() == Dimension::Three).then_some(PredicateKind::Orient3d);
        [PredicateKind::Compare, PredicateKind::Orient2d].into_iter().chain(side).collect()
    }

    /// A session with an unperturbed one behind it need not break the ties of formulas.
    fn supported(&self, session: &dyn Predicates) -> Result<(), Declined> {
        if session.unperturbed().is_some() {
            return Ok(());
        }
        asks(session.scene().dimension()).into_iter().try_for_each(|kind| session.supports(kind))
    }

    fn truth(&self, scene: &Scene, content: &TwoObjects, watch: &Watch) -> Result<Truth, Stop> {
        Truth::new(scene, content.objects(), watch)
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &TwoObjects,
        how: &How<'_>,
        answer: &mut Nearest,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        let found = nearest(session, content.indexed(session.scene()));
        *answer = found.map_err(|why| Halt::Refused(Refusal { check: "supports", why }))?;
        how.watch.done(1)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Distance>,
        asked: &Asked<'_>,
        answer: &Nearest,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, answer, outcome)
    }

    /// Times the trees, which all backends share.
    fn building(&self, scene: &Scene, content: &TwoObjects) -> Vec<Phase> {
        let index = || content.objects().map(|object| Indexed::new(scene, object.clone()));
        vec![Phase::timed("trees", "part", self.size(content), index).0]
    }

    fn size(&self, content: &TwoObjects) -> usize {
        content.objects().iter().map(|object| object.len()).sum()
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<Distance>> {
        spoiled::all()
    }

    fn describe(&self, loaded: &LoadedScene, content: &TwoObjects, watch: &Watch) -> Result<String, Stop> {
        let truth = Truth::new(&loaded.scene, content.objects(), watch)?;
        let [first, second] = content.objects().map(|object| object.len());
        let parts = if loaded.scene.dimension() == Dimension::Two { "edges" } else { "triangles" };
        let distance = root(&truth.squared);
        let (kind, pairs) = (truth.kind.name(), truth.pairs.len());
        Ok(format!("{first} and {second} {parts}: {kind}, distance about {distance:e}, {pairs} nearest pairs\n"))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &TwoObjects,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let told = |found: &Nearest| judge::told(found.kind, &found.pairs);
        let ask = |backend: &dyn Contestant| backend.answer(self, scene, content).map(|found| told(&found));
        let about = Explanation { vertices: query.vertices().collect(), ..Explanation::default() };
        Ok(about.with_answers(backends, ask))
    }

    /// Offers the kind, the squared distance as a fraction, and the nearest pairs with their points.
    fn write(&self, scene: &Scene, _: &TwoObjects, answer: &Nearest, files: &mut Files) -> Result<(), output::Error> {
        files.json("distance.json", || {
            let ids = |feature: &Feature| feature.corners().iter().map(ToString::to_string).collect::<Vec<_>>();
            let pair = |[one, other]: &[Feature; 2]| {
                let points = measured(scene, &[*one, *other]).map(|solved| solved.points);
                let exact = |point: &Vec<rug::Rational>| point.iter().map(ToString::to_string).collect::<Vec<_>>();
                let points = points.map(|points| points.iter().map(exact).collect::<Vec<_>>());
                serde_json::json!({ "a": ids(one), "b": ids(other), "points": points })
            };
            let squared = replies::squared(scene, answer);
            serde_json::json!({
                "kind": answer.kind.name(),
                "squared_distance": squared.to_string(),
                "distance": root(&squared),
                "pairs": answer.pairs.iter().map(pair).collect::<Vec<_>>(),
            })
        })
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &TwoObjects,
        answer: Option<&Nearest>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        let names = [("first object", Role::Given), ("second object", Role::Second)];
        for ((name, role), object) in names.into_iter().zip(content.objects()) {
            if scene.dimension() == Dimension::Two {
                canvas.lines(scene, name, role, object.parts())?;
            } else {
                canvas.faces(scene, name, role, object.parts())?;
            }
        }
        let Some(answer) = answer else { return Ok(()) };
        let place = |point: &Vec<rug::Rational>| {
            [0, 1, 2].map(|axis: usize| point.get(axis).map(nearest_double).unwrap_or_default())
        };
        let pairs = answer.pairs.iter().filter_map(|pair| measured(scene, pair));
        let line = |solved: crate::truth::Solved| vec![solved.points.iter().map(place).collect::<Vec<_>>()];
        canvas.places("nearest points", Role::Mark, Shape::Lines, pairs.map(line));
        Ok(())
    }
}
