//! Where the scenes of runs are from, and how to cite it.

pub mod bibtex;

use std::collections::{BTreeMap, BTreeSet};

use predicament_corpus::Level;
use predicament_records::{Plan, RunDir};
use predicament_report::Source;

use crate::select::{Selector, suite_of};
use crate::tool::Tool;

/// The sources of scenes, and the scenes whose source is unknown.
#[derive(Default)]
pub struct Sources {
    /// The sources that suites name, in the order of the texts.
    pub named: Vec<Source>,
    /// Scenes that have no source, by suite.
    pub silent: BTreeMap<String, u64>,
    /// Scenes of suites that can't be read any more or have changed, by suite.
    pub unknown: BTreeMap<String, u64>,
}

/// The sources of the scenes of runs, from their suites. A scene that several runs have counts once.
pub fn sources(runs: &[RunDir], tool: &Tool) -> Sources {
    let mut sources = Sources::default();
    let mut seen: BTreeSet<[&str; 2]> = BTreeSet::new();
    let mut named: BTreeMap<String, (BTreeSet<String>, u64)> = BTreeMap::new();
    for run in runs {
        let mut of_suites: BTreeMap<&str, BTreeMap<String, String>> = BTreeMap::new();
        for scene in &run.plan.scenes {
            if !seen.insert([&scene.suite, &scene.scene_id]) {
                continue;
            }
            let of = of_suites.entry(&scene.suite).or_insert_with(|| of_suite(run, &scene.suite, tool));
            match of.get(&scene.scene).map(|text| text.trim()) {
                None => *sources.unknown.entry(scene.suite.clone()).or_default() += 1,
                Some("") => *sources.silent.entry(scene.suite.clone()).or_default() += 1,
                Some(text) => {
                    let (suites, scenes) = named.entry(text.to_owned()).or_default();
                    suites.insert(scene.suite.clone());
                    *scenes += 1;
                }
            }
        }
    }
    let source = |(text, (suites, scenes)): (String, (BTreeSet<String>, u64))| {
        let is_own = is_own(&text);
        Source { text, suites: suites.into_iter().collect(), scenes, is_own }
    };
    sources.named = named.into_iter().map(source).collect();
    sources
}

/// The sources of a suite's scenes by their names; nothing if the suite can't be read.
fn of_suite(run: &RunDir, suite: &str, tool: &Tool) -> BTreeMap<String, String> {
    let plan: &Plan = &run.plan;
    let selector =
        Selector { suites: vec![suite_of(&run.path, plan, suite)], filter: None, level: Level::Quick, cache: None };
    let Ok(selection) = selector.select(tool) else { return BTreeMap::new() };
    selection.defs().into_iter().map(|def| (def.name.clone(), def.source.clone())).collect()
}

/// True for a source that is the work of a suite's author or of this tool, and is no publication.
fn is_own(source: &str) -> bool {
    const WORDS: [&str; 8] =
        ["by hand", "hand-made", "generat", "written for", "found ", "reduced", "cargo fuzz", "made by"];
    let text = source.to_lowercase();
    bibtex::paper(source).is_none() && (WORDS.iter().any(|word| text.starts_with(word)) || text.ends_with(", reduced"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_source_is_a_publication_or_the_author_s_own() {
        for own in ["by hand", "generated", "Found by hill climbing", "lecture/ear-cut-across, reduced"] {
            assert!(is_own(own), "{own}");
        }
        for other in ["generated; Wang, Jiang, Schroeder, Teran: Robust Intersections", "mapbox/earcut, issue 45"] {
            assert!(!is_own(other), "{other}");
        }
    }
}
