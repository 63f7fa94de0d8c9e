//! Error against conditioning: the share of wrong answers by how degenerate a query is.
//!
//! The degeneracy is log2(|determinant| / permanent), in rationals: 0 for none, about -53 where plain doubles lose the
//! sign. Queries are of general scenes, of scenes that miss a degeneracy by 4 to 2^20 ulps, and of degenerate scenes
//! with noise of 2^-52 to 2^-4 of their extent, so that every decade has some.

use std::collections::BTreeMap;

use predicament_corpus::{LoadedScene, Random, SceneFormat};
use predicament_judge::{log2_relative, verdict};
use predicament_predicates::{Sign, ZeroMeaning};
use predicament_records::{approximately, wilson};
use predicament_report::{Curve, Curves, XAxis, curves};
use predicament_tasks::signs::{SignQueries, Signs};
use predicament_tasks::{Compared, Contestant, Kind, Knob, Watch};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::inputs::Input;
use crate::stress::turned;
use crate::{Error, File};

/// The predicates, by task.
const TASKS: [&Signs; 4] = [&Signs::ORIENT2D, &Signs::ORIENT3D, &Signs::INCIRCLE, &Signs::INSPHERE];
/// Noise, as exponents of two, in units of a scene's extent.
const NOISE: [i32; 13] = [-52, -48, -44, -40, -36, -32, -28, -24, -20, -16, -12, -8, -4];
/// Keys of nearly degenerate scenes.
const NEAR: [&str; 3] = ["ulps = 4", "ulps = 1024", "ulps = 1048576"];
/// The bin of exact zeros.
pub(super) const ZERO: i32 = -1100;
/// The number of binary digits per bin.
pub(super) const BIN: i32 = 4;

/// The answers of a backend to queries of similar degeneracy: a row of `conditioning.csv`.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Conditioned {
    /// The task.
    pub task: String,
    /// The backend's name, with its parameters.
    pub backend: String,
    /// The least log2(|determinant| / permanent) of the bin, which has four binary digits; -1100 for exact zeros.
    pub log2_relative_det: i32,
    /// The number of answers.
    pub answers: u64,
    /// The number of answers that break the promise.
    pub wrong: u64,
    /// The number of zeros of a band, which are legal.
    pub in_band: u64,
    /// The share of wrong answers, with its 95 % interval.
    pub share: f64,
    /// The interval's lower end.
    pub low: f64,
    /// The interval's upper end.
    pub high: f64,
}

#[derive(Clone, Copy, Default)]
struct Bin {
    answers: u64,
    wrong: u64,
    in_band: u64,
}

/// The measurements of all backends on all predicates, with this many queries for each noise.
///
/// # Errors
/// [`Error::Stopped`] if the watch says so.
pub fn conditioning(
    backends: &[&dyn Contestant],
    queries: usize,
    seed: u64,
    watch: &Watch<'_>,
) -> Result<Vec<Conditioned>, Error> {
    let mut all = Vec::new();
    for asked in TASKS {
        let task = asked.name();
        let keyed = |family: &'static str, keys: &'static str| {
            Input { task: asked, of: Compared { kind: Kind::General, family, n: queries, keys } }.scene(seed)
        };
        let of = |family: &'static str| keyed(family, "");
        let noisy = |&exponent: &i32| {
            let degenerate = of("degen")?;
            let mut random = Random::new("conditioning", task, seed + u64::from(exponent.unsigned_abs()));
            let scene = &degenerate.scene;
            let coordinates = turned(Knob::Noise, exponent, scene.dimension(), scene.coordinates(), &mut random);
            degenerate.moved(coordinates).map_err(Error::unfit)
        };
        let mut scenes: Vec<LoadedScene> = NOISE.iter().map(noisy).collect::<Result<_, Error>>()?;
        scenes.extend(NEAR.iter().map(|keys| keyed("near", keys)).collect::<Result<Vec<_>, Error>>()?);
        scenes.extend([of("uniform")?, of("degen")?]);
        for backend in backends {
            let of_scenes: Vec<BTreeMap<i32, Bin>> = scenes.par_iter().map(|scene| bins(*backend, scene)).collect();
            watch.done(scenes.len() as u64)?;
            let mut bins: BTreeMap<i32, Bin> = BTreeMap::new();
            for (at, bin) in of_scenes.into_iter().flatten() {
                let sum = bins.entry(at).or_default();
                sum.answers += bin.answers;
                sum.wrong += bin.wrong;
                sum.in_band += bin.in_band;
            }
            all.extend(bins.into_iter().map(|(at, bin)| {
                let [low, high] = wilson(bin.wrong, bin.answers);
                Conditioned {
                    task: task.to_owned(),
                    backend: backend.name(),
                    log2_relative_det: at,
                    answers: bin.answers,
                    wrong: bin.wrong,
                    in_band: bin.in_band,
                    share: approximately(bin.wrong) / approximately(bin.answers),
                    low,
                    high,
                }
            }));
        }
    }
    Ok(all)
}

/// The answers of a backend to a scene, by degeneracy of the queries; empty if it declines.
fn bins(backend: &dyn Contestant, scene: &LoadedScene) -> BTreeMap<i32, Bin> {
    let mut bins: BTreeMap<i32, Bin> = BTreeMap::new();
    let Some(SignQueries { queries, .. }) = scene.content::<SignQueries>() else { return bins };
    let question = queries.question();
    let zero = backend.contract(question.kind()).zero;
    // The comparison counts declined queries; they are not counted again here.
    let _ = backend.with_session(&scene.scene, &mut |session| {
        if session.supports(question.kind()).is_err() {
            return;
        }
        for at in 0..queries.len() {
            let args = queries.args(at);
            let truth = verdict(&scene.scene, question, args);
            let exact = Sign::from(truth.determinant.cmp0());
            // From -1100 on, which no determinant of these scenes reaches; bins are small integers.
            #[allow(clippy::cast_possible_truncation)]
            let place = log2_relative(&truth).map_or(ZERO, |x| (x.max(-1000.0).floor() as i32).div_euclid(BIN) * BIN);
            let said = question.ask(session, args);
            let bin = bins.entry(place).or_default();
            bin.answers += 1;
            let is_band = said.is_zero() && zero == ZeroMeaning::Band && !exact.is_zero();
            let is_broken_tie = exact.is_zero() && zero == ZeroMeaning::Never && !said.is_zero();
            bin.in_band += u64::from(is_band);
            bin.wrong += u64::from(said != exact && !is_band && !is_broken_tie);
        }
    });
    bins
}

/// A plot for each task: wrong answers per million by degeneracy.
///
/// Bands show the zeros that a tolerance may answer.
pub(super) fn plots(measured: &[Conditioned]) -> Result<Vec<File>, Error> {
    let mut files = Vec::new();
    for task in TASKS.map(SceneFormat::name) {
        let mut backends: Vec<&str> = Vec::new();
        for row in measured.iter().filter(|row| row.task == task) {
            if !backends.contains(&row.backend.as_str()) {
                backends.push(&row.backend);
            }
        }
        let curve = |backend: &&str, value: &dyn Fn(&Conditioned) -> u64, name: String| {
            let of = measured.iter().filter(|row| row.task == task && row.backend == *backend);
            let not_zero = of.filter(|row| row.log2_relative_det > ZERO);
            let points = not_zero
                .map(|row| {
                    (f64::from(-row.log2_relative_det), 1e6 * approximately(value(row)) / approximately(row.answers))
                })
                .filter(|(x, y)| *x > 0.0 && *y > 0.0);
            Curve::new(name, points.collect::<Vec<_>>())
        };
        let wrong = backends.iter().map(|backend| curve(backend, &|row| row.wrong, (*backend).to_owned()));
        let bands =
            backends.iter().map(|backend| curve(backend, &|row| row.in_band, format!("{backend}, in its band")).band());
        let (lines, never): (Vec<Curve>, Vec<Curve>) = wrong.partition(|curve| !curve.points.is_empty());
        let bands = bands.filter(|curve| !curve.points.is_empty());
        let never: Vec<&str> = never.iter().map(|curve| curve.name.as_str()).collect();
        let never = (!never.is_empty()).then(|| Curve::new(format!("never wrong: {}", never.join(", ")), []));
        let lines = lines.into_iter().chain(bands).chain(never).collect();
        let (x, y) = ("-log2(|det| / permanent)".into(), "answers in 10^6".into());
        let picture = curves(&Curves { x, y, curves: lines, spread: XAxis::Linear }).map_err(Error::format)?;
        files.extend(File::plot(format!("conditioning-{task}"), picture));
    }
    Ok(files)
}

/// The bins in which backends are wrong, as Markdown.
pub(super) fn page(measured: &[Conditioned]) -> String {
    let mut page = String::new();
    if measured.is_empty() {
        return page;
    }
    page += "\n## Error against conditioning\n\n`wrong from` and `to` give the range of log2(|det| / permanent) in which the backend is wrong; `band from` and `to`, the range in which it answers zero within its band. Exact zeros are counted separately. The rows are in `conditioning.csv`.\n\n\
             | task | backend | wrong from | to | wrong in the worst bin | band from | to | exact zeros wrong |\n|---|---|---:|---:|---:|---:|---:|---:|\n";
    let mut seen: Vec<(&str, &str)> = Vec::new();
    for row in measured {
        let pair = (row.task.as_str(), row.backend.as_str());
        if seen.contains(&pair) {
            continue;
        }
        seen.push(pair);
        let of: Vec<&Conditioned> =
            measured.iter().filter(|other| (other.task.as_str(), other.backend.as_str()) == pair).collect();
        let range = |is: &dyn Fn(&Conditioned) -> bool| {
            let mut places =
                of.iter().filter(|row| row.log2_relative_det > ZERO && is(row)).map(|row| row.log2_relative_det);
            places.next().map(|first| [first, places.last().unwrap_or(first) + BIN])
        };
        let cell = |range: Option<[i32; 2]>, at: usize| range.map_or("-".to_owned(), |range| range[at].to_string());
        let (wrong, band) = (range(&|row| row.wrong > 0), range(&|row| row.in_band > 0));
        let worst = of.iter().filter(|row| row.log2_relative_det > ZERO).map(|row| row.share).fold(0.0, f64::max);
        let zeros = of.iter().find(|row| row.log2_relative_det == ZERO);
        let zeros = zeros.map_or("-".to_owned(), |row| format!("{:.0} %", 100.0 * row.share));
        page += &format!(
            "| {} | {} | {} | {} | {:.1} % | {} | {} | {zeros} |\n",
            pair.0,
            pair.1,
            cell(wrong, 0),
            cell(wrong, 1),
            100.0 * worst,
            cell(band, 0),
            cell(band, 1)
        );
    }
    page
}

/// The number of steps of a survey.
pub(super) fn steps(backends: usize) -> usize {
    TASKS.len() * backends * (NOISE.len() + NEAR.len() + 2)
}
