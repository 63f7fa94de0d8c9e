//! Borders: the two neighbours of each are right and wrong, also when the suite is read again.

use std::sync::atomic::AtomicBool;

use predicament_corpus::{Level, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_studies::border::Borders;
use predicament_studies::{Common, Study};
use predicament_tasks::{Budget, Watch, run};

use crate::{backend, quiet};

fn study(families: &[&str], queries: u32) -> Borders {
    let families = families.iter().map(|family| (*family).to_owned()).collect();
    Borders { backends: Vec::new(), families, queries, borders: 1, common: Common::default() }
}

#[test]
fn each_border_is_right_on_one_side_and_wrong_on_the_other() {
    let study = study(&["near", "kettner", "degen"], 60);
    let naive = backend("naive");
    let found = study.survey(&[naive.as_ref()], &quiet()).unwrap();
    assert!(found.len() > 4, "plain doubles are wrong in several families: {found:?}");
    let files = study.suites(&found).unwrap();
    let suite =
        Suite::parse(predicament_bundle::vocabulary(), "border.toml", files[0].text(), None, &Manifest::default());
    let scenes = suite.unwrap().scenes;
    assert_eq!(scenes.len(), 2 * found.len());
    let (never, silent) = (AtomicBool::new(false), |_: u64| {});
    let watch = Watch::new(&never, None, &silent);
    for pair in scenes.chunks(2) {
        let mut points = Vec::new();
        for (scene, is_wrong) in pair.iter().zip([false, true]) {
            let loaded = scene.load(Level::Quick, &Cache::new("nowhere")).unwrap();
            let task = predicament_bundle::task(loaded.task).unwrap();
            let case = task.case(&loaded, &watch).unwrap();
            let budget = Budget { permutations: 0, relations: 0, ..Budget::QUICK };
            let outcome = run(case.as_ref(), naive.as_ref(), budget, &watch).unwrap();
            assert_eq!(outcome.counts.findings() > 0, is_wrong, "{}: {:?}", loaded.name, outcome.findings);
            points.push(loaded.scene.coordinates().to_vec());
        }
        let differ: Vec<usize> = (0..points[0].len()).filter(|&at| points[0][at] != points[1][at]).collect();
        let [at] = differ[..] else { panic!("one coordinate differs: {points:?}") };
        let [right, wrong] = [0, 1].map(|side| points[side][at]);
        assert!(right == wrong.next_up() || right == wrong.next_down(), "{right:e} and {wrong:e} are neighbours");
    }
}

/// A backend without wrong answers has no border, and the page says so.
#[test]
fn what_is_never_wrong_has_no_border() {
    let study = study(&["near"], 20);
    let found = study.survey(&[backend("exact").as_ref()], &quiet()).unwrap();
    assert!(found.is_empty() && study.page(&found).contains("No answer was wrong"));
}
