//! Judging of every probe against the crossing sums of the mesh, against the other axes, and against tetrahedra.
//!
//! A backend is judged by its answers about every triangle in the way. Users run, and benchmarks time, the method by
//! labels and by the nearest triangle. A backend whose signs are proved must give the same answers by that method.

use std::collections::BTreeMap;

use crate::algorithm::{Location, MeshIndex, Ray, Scratch, locate_all};
use predicament_judge::Sample;
use predicament_judge::solids::{Materials, Place};
use predicament_mesh::OUTSIDE;
use predicament_predicates::{PredicateKind, Predicates, Query, Vertex, ZeroMeaning};
use rayon::prelude::*;

use super::bands::Bands;
use super::content::ProbeKind;
use super::section::MeshLocateRow;
use super::{Located, MeshLocate, named};
use predicament_tasks::{Answer, AnswerLine, Asked, Case, Class, Finding, Outcome, Stop};

/// The maximum number of probes beyond the sample that the judge locates because their answer is not one region.
const MOST_ASKED_LATER: usize = 100;
/// The number of probes that are located along all axes, at the two levels of thoroughness.
const TURNED: [usize; 2] = [300, 3_000];

/// The class of a single answer, and the check that decides it. `bands` gives the answers that zeros within the
/// session's bands allow.
fn class_of(
    answer: Location,
    place: &Place,
    zero: ZeroMeaning,
    mesh_sides: &dyn Fn(u32) -> [u32; 2],
    bands: &dyn Fn(Location) -> bool,
) -> (Class, &'static str) {
    const EXACT: &str = "exact location";
    match (answer, place) {
        (Location::Undecided, Place::On(_)) if zero == ZeroMeaning::Band => (Class::MissedZero, "missed surface"),
        (Location::Undecided, _) if zero != ZeroMeaning::Band => (Class::Topology, "one region"),
        (Location::Undecided, _) if bands(answer) => (Class::InBand, EXACT),
        (Location::Undecided, _) => (Class::Overreach, "undecided location"),
        // A contradiction of the mesh itself is not the backend's fault.
        (Location::Contradiction, Place::Windings(_)) => (Class::Agree, EXACT),
        (Location::Contradiction, _) => (Class::Topology, "one region"),
        (Location::In(_), Place::Windings(_)) => (Class::SignFlip, EXACT),
        (Location::In(region), Place::In(truth)) if region == *truth => (Class::Agree, EXACT),
        (Location::In(_), Place::In(_)) => (Class::SignFlip, EXACT),
        (Location::On(_), Place::In(_) | Place::Windings(_)) => match zero {
            ZeroMeaning::Exact => (Class::Overreach, EXACT),
            ZeroMeaning::Band if bands(answer) => (Class::InBand, EXACT),
            ZeroMeaning::Band => (Class::Overreach, EXACT),
            ZeroMeaning::Never => (Class::Inconsistent, "unbroken tie"),
        },
        (Location::On(triangle), Place::On(triangles)) => match zero {
            ZeroMeaning::Never => (Class::Inconsistent, "unbroken tie"),
            _ if triangle == triangles[0] => (Class::Agree, EXACT),
            ZeroMeaning::Band if bands(answer) => (Class::InBand, EXACT),
            ZeroMeaning::Exact | ZeroMeaning::Band => (Class::Overreach, EXACT),
        },
        (Location::In(region), Place::On(triangles)) => {
            let is_around = triangles.iter().any(|&triangle| mesh_sides(triangle).contains(&region));
            match zero {
                // A perturbation moves the point to one of the regions that meet there.
                ZeroMeaning::Never if is_around => (Class::TieBroken, EXACT),
                ZeroMeaning::Never => (Class::Topology, "region not around"),
                ZeroMeaning::Exact | ZeroMeaning::Band => (Class::MissedZero, "missed surface"),
            }
        }
    }
}

/// True if a session of this kind can give both answers to one question.
fn agree(one: Location, other: Location, zero: ZeroMeaning) -> bool {
    // With a band, one ray may decide and another may not; if a point is on a triangle, all rays find it there. Two
    // different regions are not allowed.
    one == other || (zero == ZeroMeaning::Band && [one, other].iter().any(|at| !matches!(at, Location::In(_))))
}

/// Judges the locations of all probes.
pub(super) fn judge(
    case: &Case<'_, MeshLocate>,
    asked: &Asked<'_>,
    answers: &[Location],
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let (content, truth) = (case.content, &case.truth);
    let contract = asked.contract(PredicateKind::Orient3d);
    let zero = contract.zero;
    let index = content.mesh_index(case.scene());
    let probes = content.vertices();
    let short = Located(locate_all(index, asked.session, &probes, &|_| true));
    outcome.digest = Some(short.digest());
    // Proved signs are exact signs, or those of one perturbed scene.
    let shortcut = (contract.proved && zero != ZeroMeaning::Band).then_some(&short.0);
    asked.watch.done(0)?;
    let turned = turned(index, asked, answers, &probes)?;
    let sides = |triangle: u32| content.mesh.sides()[triangle as usize];
    let judge = Materials::new(case.scene(), content.mesh.triangles(), content.mesh.sides());
    let in_bands = Bands::new(asked.session, content);
    let mut asked_later = 0;
    let mut rows: BTreeMap<ProbeKind, MeshLocateRow> = BTreeMap::new();
    for (at, &answer) in answers.iter().enumerate() {
        // The mesh itself may cause an answer that is not one region; then the judge locates the probe, even beyond the
        // sample.
        let is_open = answer == Location::Contradiction && truth.of(at).is_none() && asked_later < MOST_ASKED_LATER;
        asked_later += usize::from(is_open);
        let later = is_open.then(|| judge.locate(probes[at]));
        let known = truth.of(at).or(later.as_ref().map(|place| (place, None)));
        let (mut class, mut check) = match known {
            Some((place, _)) => class_of(answer, place, zero, &sides, &|answer| in_bands.allow(probes[at], answer)),
            None if answer == Location::Contradiction => (Class::Topology, "one region"),
            None => (Class::Agree, "one region"),
        };
        let (mut got, mut right) = (answer, known.map_or_else(|| "one region".to_owned(), |(place, _)| told(place)));
        let mut law = |holds: bool, broken: &'static str, other: Location, truth: String| {
            if class.is_legal() && !holds {
                (class, check, got, right) = (Class::Topology, broken, other, truth);
            }
        };
        let by_solids = known.and_then(|(_, solid)| solid);
        let fits = by_solids.is_none_or(|solid| match (answer, solid) {
            (Location::In(region), Place::In(truth)) => region == *truth,
            // A point on a border is on it, or broken ties put it into any region around; the truth by triangles
            // decides.
            (_, Place::On(_)) => true,
            // The point is in overlapping tetrahedra.
            (Location::Contradiction, Place::Windings(_)) => true,
            _ => matches!(answer, Location::On(_) | Location::Undecided) && zero == ZeroMeaning::Band,
        });
        law(fits, "tetrahedron", answer, by_solids.map_or_else(String::new, told));
        if let Some(&other) = turned.get(&at) {
            law(false, "direction", other, format!("{} along the other axes", named(answer)));
        }
        if let Some(&other) = shortcut.map(|all| &all[at]) {
            // Sums reveal contradictions of crossing surfaces; the nearest triangle does not.
            law(answer == other || answer == Location::Contradiction, "shortcut", other, named(answer));
        }
        let kind = content.probes[at].kind;
        let row = rows.entry(kind).or_insert_with(|| MeshLocateRow::of(case, asked, kind));
        row.count(answer, class, known.is_some());
        if asked.budget.answers {
            outcome.answers.push(AnswerLine {
                query: at,
                args: vec![probes[at]],
                answer: named(answer),
                exact: known.map_or_else(|| "not of the sample".to_owned(), |(place, _)| told(place)),
                class,
                stage: "",
            });
        }
        outcome.note(class, asked.budget.findings_per_class, || {
            Finding::plain(class, check, vec![Query::of_task("mesh-locate", &[probes[at]])], named(got), right)
        });
    }
    rows.values().for_each(|row| outcome.row(row));
    Ok(())
}

/// The probes of a sample whose location differs along another axis, and that location.
fn turned(
    index: &MeshIndex,
    asked: &Asked<'_>,
    answers: &[Location],
    probes: &[Vertex],
) -> Result<BTreeMap<usize, Location>, Stop> {
    let most = TURNED[usize::from(asked.budget.thorough)];
    let zero = asked.contract(PredicateKind::Orient3d).zero;
    let sample = Sample::within(most as u64, answers.len(), 1);
    let places: Vec<usize> = sample.places().collect();
    let session: &dyn Predicates = asked.session;
    let other = |&at: &usize| -> Result<Option<(usize, Location)>, Stop> {
        asked.watch.done(0)?;
        let mut scratch = Scratch::new();
        let others = Ray::ALL.iter().map(|&ray| index.question(session, probes[at], ray, &mut scratch));
        let differs = others.into_iter().find(|&other| !agree(answers[at], other, zero));
        Ok(differs.map(|other| (at, other)))
    };
    let found: Vec<Option<(usize, Location)>> = places.par_iter().map(other).collect::<Result<_, _>>()?;
    Ok(found.into_iter().flatten().collect())
}

/// The location as text.
pub(super) fn told(place: &Place) -> String {
    match place {
        Place::In(OUTSIDE) => "outside".to_owned(),
        Place::In(region) => format!("in region {region}"),
        Place::On(triangles) => match triangles.first() {
            Some(first) if triangles.len() == 1 => format!("on triangle {first}"),
            Some(first) => format!("on triangle {first} and {} more", triangles.len() - 1),
            None => "on a border".to_owned(),
        },
        Place::Windings(windings) => {
            let list: Vec<String> = windings.iter().map(|(region, winding)| format!("{region}: {winding}")).collect();
            format!("in no one region; winding numbers {}", list.join(", "))
        }
    }
}
