//! A check as it runs: queries from scenes and families, answers, truth, laws, findings.

use std::collections::BTreeSet;

use predicament_predicates::{PredicateKind, Sign};

use crate::check::Check;
use crate::families::{constructs, queries};
use crate::finding::{Error, Finding, Got, lines, test};
use crate::plain::{Reference, references};
use crate::query::Query;
use crate::quiet::caught;
use crate::report::{Contradiction, LawReport, Rank, SourceReport, THIS};
use crate::table::{TABLE, read, way_of};
use crate::{Answer, Law, Number, Point, Report, shrink};

/// The number of queries on which laws are tested, about.
const LAWS: usize = 1000;
/// The maximum number of findings.
const MOST_FINDINGS: usize = 25;
/// The number of findings that are shrunk; the others are as they were found.
const SHRUNK: usize = 10;
/// A family has a convention if it has this many signs.
const ENOUGH: u64 = 30;

/// A check in progress.
struct Run<'f, P: Point> {
    check: Check<'f, P>,
    references: Vec<Reference<P::Number>>,
    wrong_references: Vec<u64>,
    report: Report<P>,
    /// The kinds of findings seen: the source, the error and the truth.
    seen: BTreeSet<(usize, Error, Sign)>,
    /// The number of queries from one test of the laws to the next.
    stride: u64,
}

pub(crate) fn run<P: Point>(check: Check<'_, P>) -> Report<P> {
    let subject = check.subject;
    let (scenes, recipes) = read(TABLE);
    let indirectly = if check.is_indirect { "indirect " } else { "" };
    let title =
        format!("{indirectly}{} of {}D points in {}, seed {}", subject.kind, P::DIMENSION, P::Number::NAME, check.seed);
    let laws = Law::ALL.map(|law| LawReport { law, tested: 0, broken: 0, first: None }).to_vec();
    let references = references();
    let mut run = Run {
        wrong_references: vec![0; references.len()],
        references,
        report: Report {
            title,
            asked: 0,
            wrong: 0,
            undecided: 0,
            panicked: 0,
            left_out: 0,
            laws,
            sources: Vec::new(),
            ranking: Vec::new(),
            findings: Vec::new(),
            notes: Vec::new(),
            may_be_undecided: check.may_be_undecided,
        },
        seen: BTreeSet::new(),
        stride: (check.cases / LAWS).max(1) as u64,
        check,
    };
    let (most, is_indirect) = (run.check.cases.div_ceil(20), run.check.is_indirect);
    for scene in scenes.iter().filter(|scene| is_indirect || !scene.is_indirect()) {
        if let Some(way) = way_of(scene, subject) {
            let fit =
                |query: Query<f64>, _| query.mapped_to(|all| all.iter().map(|&x| P::Number::exactly(x)).collect());
            run.source(scene.name.to_owned(), scene.queries(way, most), fit);
        }
    }
    // Circles and spheres through constructed points: the families of turns and sides, which have as many coordinates.
    let listed = match is_indirect && subject.kind.is_lifted() {
        true => {
            PredicateKind::ALL.into_iter().find(|kind| !kind.is_lifted() && kind.arity() + 1 == subject.kind.arity())
        }
        false => Some(subject.kind),
    };
    let recipes: Vec<_> = recipes
        .iter()
        .filter(|recipe| Some(recipe.kind) == listed && constructs(recipe.family).is_some() == is_indirect)
        .collect();
    let (cases, seed, ways) = (run.check.cases, run.check.seed, subject.ways.len());
    // Families for points of another dimension make no queries; they get no share.
    let fitting: Vec<_> =
        recipes.into_iter().filter(|recipe| !queries(recipe, subject, 0, seed, 8).is_empty()).collect();
    for recipe in &fitting {
        let n = (cases / fitting.len() / ways / recipe.costs(subject.kind)).max(1);
        for way in 0..ways {
            let name = match subject.ways[way].0 {
                "" => recipe.title(),
                way => format!("{} {way}", recipe.title()),
            };
            let fit = |query: Query<f64>, at| query.mapped_to(|all| P::Number::fitted(all, at));
            run.source(name, queries(recipe, subject, way, seed, n), fit);
        }
    }
    run.finish()
}

impl<P: Point> Run<'_, P> {
    /// Asks all queries of a family or a scene.
    fn source(
        &mut self,
        name: String,
        queries: Vec<Query<f64>>,
        fit: impl Fn(Query<f64>, usize) -> Option<Query<P::Number>>,
    ) {
        let mut counts = SourceReport { name, ..SourceReport::default() };
        let (mut signs, mut flips) = (0, 0);
        for (case, query) in queries.into_iter().enumerate() {
            let fitted = fit(query, case).filter(|query| self.is_within(query));
            let known = fitted.and_then(|query| Some((query.points::<P>()?, query.truth(self.check.subject)?, query)));
            let Some((points, truth, query)) = known else {
                counts.left_out += 1;
                continue;
            };
            counts.asked += 1;
            let got = self.ask(query.way, &points);
            for (reference, wrong) in self.references.iter().zip(&mut self.wrong_references) {
                *wrong += u64::from((reference.answer)(&query, self.check.subject) != truth.into());
            }
            let error = Error::of(&got, truth);
            signs += u64::from(!truth.is_zero());
            flips += u64::from(error == Some(Error::Flipped));
            match error {
                None => {}
                Some(Error::Undecided) => counts.undecided += 1,
                Some(Error::Panicked) => counts.panicked += 1,
                Some(Error::Flipped | Error::MissedZero | Error::FalseZero | Error::NotANumber) => counts.wrong += 1,
            }
            if let Some(error) = error
                && !(error == Error::Undecided && self.check.may_be_undecided)
            {
                self.note(&counts.name, case, &query, points.clone(), got.clone(), truth, error);
            }
            if (self.report.asked + counts.asked).is_multiple_of(self.stride)
                && let Got::Answer(Answer::Sign(sign)) = got
            {
                self.test_laws(&query, &points, sign);
            }
        }
        if counts.name.starts_with("uniform") && signs >= ENOUGH && flips == signs {
            self.report.notes.push(format!(
                "all {signs} answers of the family uniform have the opposite sign: if that is the predicate's \
                 convention, add `.opposite()`"
            ));
        }
        self.report.asked += counts.asked;
        self.report.wrong += counts.wrong;
        self.report.undecided += counts.undecided;
        self.report.panicked += counts.panicked;
        self.report.left_out += counts.left_out;
        self.report.sources.push(counts);
    }

    fn is_within(&self, query: &Query<P::Number>) -> bool {
        match (&self.check.exponents, query.exponents()) {
            (Some(exponents), Some([high, low])) => exponents.contains(&high) && exponents.contains(&low),
            _ => true,
        }
    }

    fn ask(&mut self, way: usize, points: &[P]) -> Got {
        match caught(|| (self.check.predicate)(way, points)) {
            Ok(answer) => Got::Answer(answer),
            Err(message) => Got::Panic(message),
        }
    }

    /// Keeps the first finding of each kind in each source.
    #[allow(clippy::too_many_arguments)] // one of each
    fn note(
        &mut self,
        source: &str,
        case: usize,
        query: &Query<P::Number>,
        points: Vec<P>,
        got: Got,
        truth: Sign,
        error: Error,
    ) {
        let is_new = self.seen.insert((self.report.sources.len(), error, truth));
        if !is_new || self.report.findings.len() >= MOST_FINDINGS {
            return;
        }
        let subject = self.check.subject;
        let small = if self.report.findings.len() < SHRUNK {
            shrink::shrink(query, subject.dimension, |smaller| {
                let (Some(points), Some(truth)) = (smaller.points::<P>(), smaller.truth(subject)) else { return false };
                self.is_within(smaller) && Error::of(&self.ask(smaller.way, &points), truth) == Some(error)
            })
        } else {
            query.clone()
        };
        let shrunk: Vec<P> = small.points().unwrap_or_default();
        let shrunk_got = self.ask(small.way, &shrunk);
        let shrunk_truth = small.truth(subject).unwrap_or(truth);
        self.report.findings.push(Finding {
            source: source.to_owned(),
            case,
            way: subject.ways[query.way].0,
            error,
            points,
            got,
            truth,
            test: test(
                subject,
                &self.check.call,
                &format!("{source}, query {case}"),
                &small,
                &shrunk,
                &shrunk_got,
                shrunk_truth,
            ),
            coordinates: [lines::<P>(query), lines::<P>(&small)],
            shrunk,
            shrunk_got,
            shrunk_truth,
        });
    }

    /// Compares an answer with the answers to exact images of the query.
    fn test_laws(&mut self, query: &Query<P::Number>, points: &[P], sign: Sign) {
        for (at, law) in Law::ALL.into_iter().enumerate() {
            let (images, factor) = law.images(query, self.check.subject.dimension);
            for image in images.into_iter().filter(|image| self.is_within(image)).collect::<Vec<_>>() {
                let Some(moved) = image.points::<P>() else { continue };
                let got = self.ask(image.way, &moved);
                if got == Got::Answer(Answer::Undecided) {
                    continue;
                }
                let report = &mut self.report.laws[at];
                report.tested += 1;
                if got != Got::Answer(Answer::Sign(sign * factor)) {
                    report.broken += 1;
                    let own = Got::Answer(Answer::Sign(sign));
                    report
                        .first
                        .get_or_insert_with(|| Contradiction { points: [points.to_vec(), moved], got: [own, got] });
                }
            }
        }
    }

    fn finish(mut self) -> Report<P> {
        let own = self.report.wrong + self.report.undecided + self.report.panicked;
        let others = self.references.iter().zip(&self.wrong_references);
        let others = others.map(|(reference, &wrong)| Rank { name: reference.name, wrong });
        self.report.ranking = [Rank { name: "the exact sign", wrong: 0 }, Rank { name: THIS, wrong: own }]
            .into_iter()
            .chain(others)
            .collect();
        self.report.ranking.sort_by_key(|rank| rank.wrong);
        self.report
    }
}
