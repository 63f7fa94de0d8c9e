//! The search for worst inputs, with a small effort.

use predicament_studies::Host;

use predicament_studies::worst::Found;

use predicament_studies::worst::{Worst, errors, guards};

use predicament_studies::{Common, Study};

use crate::quiet;

#[test]
fn errors_come_near_their_bounds_and_not_beyond() {
    let host = quiet();
    let found = errors([1, 60], 1, host.watch()).unwrap();
    // 42 quantities, both L̂ and 16 tolerances, in two precisions
    assert_eq!(found.len(), 2 * (42 + 2 + 16));
    for row in &found {
        assert!(row.share() <= 0.5 + 1e-6, "rounding to nearest loses half at most: {row:?}");
    }
    let reached = found.iter().filter(|row| row.share() > 0.02).count();
    assert!(reached > 60, "{reached} of {} errors are more than a fiftieth of their bound", found.len());
    assert_eq!(errors([1, 60], 1, host.watch()).unwrap(), found, "the same seed finds the same");
    let study = Worst { steps: 60, climbs: 1, common: Common::default() };
    let wrong = found.iter().cloned().map(|mut row| {
        row.derived /= 64.0;
        row
    });
    let wrong = Found { errors: wrong.collect(), guards: Vec::new() };
    assert!(study.holds(&Found { errors: found, guards: Vec::new() }));
    assert!(!study.holds(&wrong), "bounds that are too small are found out");
}

#[test]
fn guards_are_above_their_bounds_and_a_climb_lowers_them() {
    let host = quiet();
    let [little, more] = [5, 150].map(|steps| guards([1, steps], 1, host.watch()).unwrap());
    assert_eq!(more.len(), 2 * 8, "all algorithms but those of two vertices");
    assert!(more.iter().all(|row| row.least >= 1.0 - 1e-12), "{more:?}");
    let sum = |rows: &[predicament_studies::worst::Guard]| rows.iter().map(|row| row.least).sum::<f64>();
    assert!(sum(&more) < sum(&little));
}
