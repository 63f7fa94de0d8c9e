//! The law `repeat`: our backends keep it, and each planted fault breaks it in the ways in which it must.

use predicament_oracle::faults::Unsteady;
use predicament_predicates::Class;
use predicament_studies::repeat::{Repeat, Row, Way};
use predicament_studies::{Common, Study};

use crate::{backend, quiet};

/// The rows of a backend on tasks.
fn rows(name: &str, tasks: &[&str], size: u32) -> Vec<Row> {
    let tasks = tasks.iter().map(|task| (*task).to_owned()).collect();
    let study = Repeat { backends: Vec::new(), tasks, size, answers: false, common: Common::default() };
    study.survey(&[backend(name).as_ref()], &quiet()).unwrap().rows
}

fn unstable(rows: &[Row], way: Way) -> u64 {
    rows.iter().filter(|row| row.way == way.to_string()).map(|row| row.unstable).sum()
}

#[test]
fn what_depends_on_the_question_alone_is_stable() {
    for name in ["exact", "sos", "tolerance", "naive"] {
        let rows = rows(name, &["orient2d", "insphere", "hull2d"], 60);
        assert!(
            rows.iter().all(|row| row.unstable == 0 && [Class::Agree, Class::Declined].contains(&row.class)),
            "{rows:?}"
        );
        let has_ids = rows.iter().any(|row| row.way == Way::Ids.to_string());
        assert_eq!(has_ids, name != "sos", "{name}: who breaks ties by number is not asked with others");
        assert!(rows.iter().all(|row| row.way != Way::Process.to_string()), "this host starts no process");
    }
}

#[test]
fn each_planted_dependence_is_found() {
    for (fault, ways) in [
        (Unsteady::Global, vec![Way::Again, Way::Order]),
        (Unsteady::Time, vec![Way::Again]),
        (Unsteady::Threads, vec![Way::Threads(1)]),
        (Unsteady::Order, vec![Way::Order]),
        (Unsteady::Ids, vec![Way::Ids]),
    ] {
        let name = format!("fault:{}", fault.name());
        // The first answers come from more than one thread.
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
        let rows = pool.install(|| rows(&name, &["orient2d"], 200));
        for way in ways {
            assert!(unstable(&rows, way) > 0, "{name}: {way}: {rows:?}");
        }
        let first = rows.iter().find(|row| row.class == Class::Unstable).unwrap();
        assert!(first.first != first.second && first.query.starts_with("orient2d"), "both answers: {first:?}");
    }
}

#[test]
fn a_fault_is_found_in_no_other_way_than_its_own() {
    let rows = rows("fault:unsteady-ids", &["orient2d"], 200);
    let others = Way::ALL.into_iter().filter(|&way| way != Way::Ids);
    assert!(others.map(|way| unstable(&rows, way)).all(|unstable| unstable == 0), "{rows:?}");
}
