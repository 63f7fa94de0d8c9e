//! The study of scale: sizes, refusals, and memory beyond what a task states.

use predicament_studies::scale::{Row, Scale};
use predicament_studies::{Common, Study};

use crate::{backend, quiet};

fn study(tasks: &[&str], [min, max]: [u32; 2]) -> Scale {
    let tasks = tasks.iter().map(|&task| task.to_owned()).collect();
    Scale { backends: Vec::new(), tasks, min, max, memory: 1, alone: true, common: Common::default() }
}

fn rows(study: &Scale) -> Vec<Row> {
    let exact = backend("exact");
    study.survey(&[exact.as_ref()], &quiet()).unwrap()
}

#[test]
fn every_task_with_scenes_of_any_size_states_a_memory_that_suffices() {
    let study = study(&[], [30, 300]);
    let rows = rows(&study);
    let mut tasks: Vec<&str> = rows.iter().map(|row| row.task.as_str()).collect();
    tasks.dedup();
    assert_eq!(tasks, ["crossings", "hull3d", "delaunay2d", "overlay2d", "snap2d", "mesh-intersect"]);
    for pair in rows.chunks(2) {
        assert!(pair.iter().all(|row| row.outcome == "answered" && row.seconds > 0.0), "{pair:?}");
        let [small, large] = [&pair[0], &pair[1]];
        assert!(large.size >= 8 * small.size, "sizes are of the scene: {pair:?}");
        let size = |row: &Row| f64::from(u32::try_from(row.size).unwrap());
        let [sizes, stated] = [size(large) / size(small), large.stated / small.stated];
        assert!((0.8..1.25).contains(&(stated / sizes)), "the stated memory grows like the scene: {pair:?}");
    }
    assert!(study.holds(&rows), "{rows:?}");
    let much = Row { bytes: 1e9, ..rows[0].clone() };
    assert!(!study.holds(&vec![much]), "more than the task states is found");
}

#[test]
fn a_scene_that_needs_more_memory_than_is_allowed_is_not_answered() {
    let study = study(&["crossings"], [1_000_000, 1_000_000]);
    let rows = rows(&study);
    assert_eq!(rows[0].outcome, "refused");
    assert!(rows[0].seconds.is_nan() && rows[0].stated > 1e9 && study.holds(&rows));
    assert_eq!(rows[0].message, "needs 2 GiB by its task; --memory allows 1");
    assert!(study.page(&rows).contains("| 1000000 | - | - | - |"), "{}", study.page(&rows));
}
