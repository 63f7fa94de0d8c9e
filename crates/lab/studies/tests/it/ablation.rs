//! The study of devices: answers do not depend on a device, and a variant with other answers is found.

use predicament_oracle::roster::WITHOUT;
use predicament_studies::ablation::{Ablation, Row, saved};
use predicament_studies::{Common, Study};

use crate::{backend, quiet};

/// A study of small scenes, and its rows for these variants.
fn study(variants: &[&str], tasks: &[&str]) -> (Ablation, Vec<Row>) {
    let tasks = tasks.iter().map(|&task| task.to_owned()).collect();
    let study = Ablation { backends: Vec::new(), tasks, samples: 1, size: Some(15), common: Common::default() };
    let backends: Vec<_> = variants.iter().map(|name| backend(name)).collect();
    let backends: Vec<_> = backends.iter().map(AsRef::as_ref).collect();
    let rows = study.survey(&backends, &quiet()).unwrap();
    (study, rows)
}

#[test]
fn every_variant_of_the_default_gives_the_answers_of_the_whole() {
    let devices = ["plan", "static", "semi-static", "doubles", "integers", "batch", "near-search", "empty-cells"];
    let devices = devices.map(|of| format!("exact{WITHOUT}{of}"));
    let variants: Vec<&str> = ["exact"].into_iter().chain(devices.iter().map(String::as_str)).collect();
    let (study, rows) = study(&variants, &["orient2d", "insphere", "hull3d"]);
    assert!(study.holds(&rows));
    assert!(rows.iter().all(|row| row.answers == "equal" && row.samples == 1), "{rows:?}");
    assert!(rows.iter().all(|row| row.whole == "exact:without=nothing" && row.low <= row.ratio), "{rows:?}");
    // Two predicates by two interfaces, and one algorithm, each on three kinds of scenes.
    assert_eq!(rows.len(), variants.len() * (2 * 2 + 1) * 3);
    let interfaces = ["single", "batch", "whole"].map(|by| rows.iter().filter(|row| row.interface == by).count());
    assert_eq!(interfaces, [2, 2, 1].map(|n| n * 3 * variants.len()), "a loop counts as a batch");
    let page = study.page(&rows);
    assert!(
        page.contains("| exact | plan | static | semi-static | doubles | integers | batch | near-search | "),
        "{page}"
    );
    assert!(page.contains("| batches, degenerate | 2 | ") && page.contains("| algorithms, general | 1 | "), "{page}");
    assert!(page.contains(&saved(&rows).unwrap()), "{page}");
}

#[test]
fn shortcuts_of_algorithms_and_of_ties_change_no_answer() {
    let near = study(&["exact:without=near-search"], &["contacts2d", "contacts3d"]).1;
    let cells = study(&["exact:without=empty-cells"], &["mesh-locate"]).1;
    let others = ["sos:without=leading", "sos:per-mesh:without=set-aside"];
    let ties = study(&others[..1], &["orient2d", "orient3d", "incircle", "insphere", "hull2d"]).1;
    let aside = study(&others[1..], &["mesh-intersect"]).1;
    for rows in [near, cells, ties, aside] {
        assert!(rows.iter().all(|row| row.answers == "equal"), "{rows:?}");
    }
}

#[test]
fn a_variant_with_other_answers_is_found_and_its_times_are_not_published() {
    let (study, rows) = study(&["exact:without=static", "naive"], &["orient2d"]);
    let wrong: Vec<&Row> = rows.iter().filter(|row| row.answers == "unequal").collect();
    assert!(!wrong.is_empty() && wrong.iter().all(|row| row.backend == "naive" && row.kind != "general"), "{rows:?}");
    assert!(!study.holds(&rows) && study.page(&rows).contains("| unequal |"));
    assert!(saved(&rows).is_err());
}
