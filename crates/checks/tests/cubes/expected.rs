//! Random cubes against what they have on average.

use predicament_algorithms::cube_union::cube_union;
use predicament_checks::cubes::Expected;

use crate::scenes::uniform;

/// Measures of several unions, and their distance from the expected ones in
/// standard errors, estimated from how they scatter.
fn scores(cubes: u32, density: f64, runs: u32) -> [f64; 3] {
    let unit = f64::from(1 << 30);
    let mut samples = [const { Vec::new() }; 3];
    let mut edge = 0;
    for run in 0..runs {
        let (lowers, length) = uniform(cubes, density, u64::from(1000 + run));
        let mass = cube_union(&lowers, length).unwrap();
        edge = length;
        #[allow(clippy::cast_precision_loss)] // far from the last bit
        for (samples, (sum, scale)) in samples.iter_mut().zip([
            (mass.volume, unit * unit * unit),
            (mass.area, unit * unit),
            (mass.edge_length, unit),
        ]) {
            samples.push(sum as f64 / scale);
        }
    }
    let expected = Expected::new(cubes, f64::from(edge) / unit);
    let expected = [expected.volume, expected.area, expected.edge_length];
    let runs = f64::from(runs);
    [0, 1, 2].map(|at| {
        let mean = samples[at].iter().sum::<f64>() / runs;
        let variance = samples[at].iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (runs - 1.0);
        let error = (variance / runs).sqrt();
        let score = (mean - expected[at]) / error;
        println!(
            "{cubes} cubes, density {density}: {mean:.9} for {:.9}, off by {score:+.2} of {:.1e}",
            expected[at],
            error / expected[at]
        );
        // The scatter is small, or the check would be empty.
        assert!(error / expected[at] < 0.01, "standard error {error} of {}", expected[at]);
        score
    })
}

/// |t| > 5 with 7 degrees of freedom or more: once in 600 for honest samples; these are seeded.
fn assert_near(scores: [f64; 3]) {
    assert!(scores.iter().all(|score| score.abs() < 5.0), "off by {scores:?} standard errors");
}

#[test]
fn a_hundred_thousand_cubes_have_the_expected_measures() {
    assert_near(scores(100_000, 1.0, 8));
}

#[test]
fn a_thousand_cubes_have_the_expected_measures_at_all_densities() {
    for density in [0.1, 1.0, 4.0] {
        assert_near(scores(1000, density, 200));
    }
}

#[test]
fn a_handful_of_cubes_has_the_expected_measures() {
    // Where one cube more or less among the others makes all the difference.
    for (cubes, density) in [(3, 0.3), (8, 0.9)] {
        assert_near(scores(cubes, density, 4000));
    }
}

#[test]
#[ignore = "ten seconds on one core"]
fn a_million_cubes_have_the_expected_measures() {
    assert_near(scores(1_000_000, 1.0, 8));
}

#[test]
#[ignore = "two minutes on one core"]
fn ten_million_cubes_have_the_expected_measures() {
    assert_near(scores(10_000_000, 1.0, 8));
}
