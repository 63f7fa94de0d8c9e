//! The sample rule: all items while that is cheap, else evenly spaced items, and the text that describes it.

use predicament_judge::{Sample, contacts, locate};
use predicament_predicates::Dimension;

#[test]
fn small_scenes_are_judged_as_a_whole() {
    for sample in [contacts::sample(Dimension::Two, [480, 480]), locate::sample(2500, 3000), Sample::all(7)] {
        assert!(sample.is_all() && sample.len() == sample.of(), "{sample}");
    }
    assert_eq!(contacts::sample(Dimension::Two, [480, 480]).to_string(), "all 480");
    assert!(Sample::within(10, 0, 1).is_empty() && Sample::within(10, 0, 1).is_all());
}

#[test]
fn large_scenes_are_judged_at_even_distances() {
    let sample = Sample::within(100, 1000, 10);
    assert_eq!(sample.places().collect::<Vec<_>>(), [0, 100, 200, 300, 400, 500, 600, 700, 800, 900]);
    assert_eq!((sample.len(), sample.of(), sample.step()), (10, 1000, 100));
    assert_eq!(sample.to_string(), "10 of 1000, every 100th");
    assert!(sample.has(300) && !sample.has(301) && !sample.has(1000));
    // At least one item, whatever the cost.
    assert_eq!(Sample::within(1, 5, 1000).places().collect::<Vec<_>>(), [0]);
    for sample in [contacts::sample(Dimension::Three, [40_000, 40_000]), locate::sample(1_000_000, 1_000_000)] {
        assert!(!sample.is_all() && sample.len() > 50, "{sample}");
        assert_eq!(sample.places().len(), sample.len());
    }
}

#[test]
fn contacts_of_space_cost_more_than_those_of_the_plane() {
    let len = |dimension: Dimension| contacts::sample(dimension, [100_000, 30_000]).len();
    // A billion over 50,000 each, and over 230,000 each: every fifth, every 24th.
    assert_eq!([len(Dimension::Two), len(Dimension::Three)], [20_000, 4_167]);
}
