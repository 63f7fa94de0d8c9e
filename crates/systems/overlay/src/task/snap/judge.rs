//! Judging of chains by their definition, with crossings found in rationals.

use crate::algorithm::snap::{Drawing, Method};
use crate::checks::snap::{Flaw, Promise, Rounded, flaws, new_crossings};
use crate::truth::SEGMENTS;
use predicament_predicates::{Query, Vertex};

use super::{Chains, Contradiction, Drawn, Snap2d, SnapRow, points};
use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Stop};

pub fn judge(case: &Case<'_, Snap2d>, asked: &Asked<'_>, answer: &Chains, outcome: &mut Outcome) -> Result<(), Stop> {
    let content = case.content;
    if let Some(rule) = answer.broken.map(Contradiction::rule) {
        note(outcome, content, rule, "violated".to_owned(), &[], asked.budget.findings_per_class);
        if answer.snapped.chains.len() != content.segments.len() {
            return Ok(());
        }
    }
    asked.watch.done(0)?;
    let points = points(case.scene());
    let number = |v: Vertex| u32::try_from(v.index()).expect("fewer than 2^32 vertices");
    let segments: Vec<[u32; 2]> = content.segments.iter().map(|ends| ends.map(number)).collect();
    let chains = answer.pixels();
    let rounded = Rounded {
        points: &points,
        segments: &segments,
        crossings: &case.truth.crossings,
        exponent: content.pixel,
        chains: &chains,
        step: segments.len().div_ceil(SEGMENTS).max(1),
    };
    let promise = match content.method {
        Method::Naive => Promise::Rounded,
        Method::Snap => Promise::Snapped,
        Method::Iterated => Promise::Iterated,
    };
    let (found, new) = case.once(asked, || chains.clone(), || Ok((flaws(rounded, promise), new_crossings(&chains))))?;
    asked.watch.done(0)?;
    let most = asked.budget.findings_per_class;
    for flaw in &found {
        let of: Vec<usize> = match *flaw {
            Flaw::Ends(at)
            | Flaw::NotHot(at)
            | Flaw::Missing(at)
            | Flaw::Strange(at)
            | Flaw::Backwards(at)
            | Flaw::Near(at) => vec![at],
            Flaw::Crossing(at, other) => vec![at, other],
        };
        let chain = |&at: &usize| chains[at].iter().map(|[x, y]| format!("({x}, {y})")).collect::<Vec<_>>().join(" ");
        let got = of.iter().map(chain).collect::<Vec<_>>().join(" and ");
        note(outcome, content, flaw.name(), got, &of, most);
    }
    if found.is_empty() && answer.broken.is_none() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
    let drawing = Drawing { points: &points, segments: &segments, crossings: &[], touching: &[] };
    outcome.row(&SnapRow {
        suite: case.loaded.suite.clone(),
        scene: case.loaded.name.clone(),
        scene_id: case.loaded.id.clone(),
        backend: asked.backend.name(),
        method: super::method_name(content.method).to_owned(),
        pixel: content.pixel,
        hot: answer.snapped.pixels.len() as u64,
        merged: answer.snapped.merged as u64,
        edges: answer.snapped.edges().len() as u64,
        new_crossings: new as u64,
        drift: answer.snapped.drift(drawing, content.pixel),
    });
    Ok(())
}

fn note(outcome: &mut Outcome, content: &Drawn, check: &'static str, got: String, of: &[usize], most: usize) {
    outcome.note(Class::Topology, most, || {
        let ends: Vec<Vertex> = of.iter().flat_map(|&at| content.segments[at]).collect();
        let queries = if ends.is_empty() { Vec::new() } else { vec![Query::of_task("snap2d", &ends)] };
        Finding::plain(Class::Topology, check, queries, got, "holds".to_owned())
    });
}
