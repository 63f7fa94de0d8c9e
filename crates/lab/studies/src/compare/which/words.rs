//! A description of each backend in sentences.

use crate::folder::FolderError;
use predicament_records::format::significant;
use predicament_tasks::Kind;

use super::files::Files;
use crate::compare::measure::FEATURES;
use crate::compare::standing::backends as backends_of;
use crate::compare::words::{
    counted, input, largest, listed, millionths, percents, scenes as scenes_in_words, share, short,
};
use crate::compare::{InputKey, Measure, REFERENCE, Share, Standing, inputs_of};

/// The numbers of inputs and scenes.
pub(super) fn scenes(files: &Files) -> Result<String, FolderError> {
    let measures = files.measures()?;
    let inputs = inputs_of(&measures);
    let mut tasks: Vec<&str> = inputs.iter().map(|([task, ..], _)| *task).collect();
    tasks.dedup();
    let (single, several): (Vec<_>, Vec<_>) = inputs.iter().partition(|(_, n)| *n == 1);
    let mut text =
        format!("{} inputs of {} tasks, {} backends.", inputs.len(), tasks.len(), backends_of(&measures).len());
    let ends = several.iter().map(|(_, n)| *n).min().zip(several.iter().map(|(_, n)| *n).max());
    if let Some((least, most)) = ends {
        let each = if least == most { scenes_in_words(least) } else { format!("{least} to {}", scenes_in_words(most)) };
        text += &format!(" {} inputs have {each}, all distinct.", several.len());
    }
    if !single.is_empty() {
        let names: Vec<String> = single.iter().map(|(of, _)| input(of)).collect();
        text += &format!(
            " {} inputs have one scene, because their families are deterministic; their intervals are wide: {}.",
            single.len(),
            listed(&names)
        );
    }
    Ok(text)
}

/// A paragraph for each backend.
pub(super) fn backends(files: &Files) -> Result<String, FolderError> {
    let (measures, promises) = (files.measures()?, files.promises()?);
    let paragraph = |backend: &&str| {
        let promise = promises.iter().find(|of| of.backend == **backend);
        let promise =
            promise.ok_or_else(|| FolderError::Lacks { file: "promises.csv", what: format!("row of {backend}") })?;
        let standing = Standing::of(&measures, backend, |_| true);
        let proved = if promise.proved { "proved" } else { "not proved" };
        let sentences = [
            Some(format!("{}, {proved}.", promise.promise)),
            takes(&measures, &standing),
            wrong(&standing),
            undecided(&standing),
            breaks(&measures, &standing),
            rounded(&standing),
            not_done(&measures, &standing),
            loses(&measures, backend),
        ];
        let sentences: Vec<String> = sentences.into_iter().flatten().collect();
        Ok(format!("* **{backend}**: {}", sentences.join(" ")))
    };
    let all: Result<Vec<String>, FolderError> = backends_of(&measures).iter().map(paragraph).collect();
    Ok(all?.join("\n"))
}

/// The sentence about its time, over all pairs and by kind of input.
fn takes(measures: &[Measure], of: &Standing<'_>) -> Option<String> {
    if of.backend == REFERENCE {
        return Some("It is the reference for times.".to_owned());
    }
    let Some(time) = of.time else { return Some(format!("It and {REFERENCE} have no timed input in common.")) };
    let by_kind = Kind::ALL.into_iter().filter_map(|kind| {
        let time = Standing::of(measures, of.backend, |[_, other, _]| *other == kind.name()).time?;
        Some(format!("{} on {} input ({})", significant(time.value, 2), kind.name(), time.pairs))
    });
    Some(format!(
        "Takes {} times as long as {REFERENCE} over {} of {} inputs, from {} to {}: {}.",
        significant(time.value, 3),
        time.pairs,
        time.of,
        significant(time.range[0], 2),
        significant(time.range[1], 2),
        listed(&by_kind.collect::<Vec<_>>())
    ))
}

/// The sentence about its wrong answers.
fn wrong(of: &Standing<'_>) -> Option<String> {
    (of.answers.of > 0).then(|| format!("{} answers are wrong ({}).", counted(of.answers), millionths(of.answers)))
}

/// The sentence about its zeros within a band.
fn undecided(of: &Standing<'_>) -> Option<String> {
    (of.in_band.count > 0)
        .then(|| format!("{} of its answers are undecided: zeros within its band.", share(of.in_band)))
}

/// The sentence about the laws of whole scenes that it breaks, and the tasks.
fn breaks(measures: &[Measure], of: &Standing<'_>) -> Option<String> {
    (of.laws.of > 0).then(|| {
        if of.laws.count == 0 {
            return format!("Breaks a law in {} scenes ({}).", counted(of.laws), percents(of.laws));
        }
        let inputs = worst(measures, of.backend, |standing| standing.laws);
        format!("Breaks a law in {} scenes ({}): {}.", counted(of.laws), percents(of.laws), listed(&inputs))
    })
}

/// The sentence about scenes that are off by rounding only.
fn rounded(of: &Standing<'_>) -> Option<String> {
    let part = Share { count: of.scenes.rounded, of: of.scenes.asked };
    (part.count > 0)
        .then(|| format!("In {} scenes a check fails only because output coordinates are rounded.", counted(part)))
}

/// The sentence about scenes that it has not done.
fn not_done(measures: &[Measure], of: &Standing<'_>) -> Option<String> {
    let part = Share { count: of.scenes.not_done, of: of.scenes.asked };
    (part.count > 0).then(|| {
        let inputs = inputs_of(measures).into_iter().filter(|(input, _)| {
            let scenes = Standing::of(measures, of.backend, |other| other == input).scenes;
            scenes.asked > 0 && scenes.asked == scenes.not_done
        });
        let whole = match inputs.count() {
            0 => String::new(),
            1 => ", including all scenes of one input".to_owned(),
            n => format!(", including all scenes of {n} inputs"),
        };
        format!("Leaves {} scenes undone ({}){whole}.", counted(part), share(part))
    })
}

/// The inputs with a nonzero count, the largest share first, each with its count.
fn worst(measures: &[Measure], backend: &str, get: impl Fn(&Standing<'_>) -> Share) -> Vec<String> {
    let mut shares: Vec<(InputKey<'_>, Share)> = Vec::new();
    for (input, _) in inputs_of(measures) {
        shares.push((input, get(&Standing::of(measures, backend, |other| *other == input))));
    }
    shares.retain(|(_, share)| share.count > 0);
    shares.sort_by(|(_, a), (_, b)| b.value().partial_cmp(&a.value()).unwrap_or(std::cmp::Ordering::Equal));
    shares.iter().map(|(of, share)| format!("{} ({})", input(of), counted(*share))).collect()
}

/// The sentence about the features that it loses, and the error of its contacts.
fn loses(measures: &[Measure], backend: &str) -> Option<String> {
    let feature = |kind: &str| largest(measures, backend, |row| row.task == FEATURES && row.kind == kind);
    let [plane, space] = ["2D", "3D"].map(feature);
    let (plane, space) = (plane?, space?);
    let off = largest(measures, backend, |row| row.measure == "location: 99 %" && row.unit == "L");
    let off =
        off.map_or(String::new(), |off| format!(" Contacts are off by up to {} L in 99 % of cases.", short(Some(off))));
    let size = |size: f64| if size.is_infinite() { "any size".to_owned() } else { format!("{} L", short(Some(size))) };
    let lost = if plane == 0.0 && space == 0.0 {
        "Distinguishes the smallest features tried.".to_owned()
    } else {
        format!(
            "Features must be larger than {} in the plane and {} in space to be distinguished in every position.",
            size(plane),
            size(space)
        )
    };
    Some(lost + &off)
}
