//! Measures of random cubes, compared with their expected values.
//!
//! The allowed error of a mean follows from the scatter of the runs. A single run of 10^7 cubes has no scatter, so it
//! is compared with the scatter of smaller runs by a law. With N d³ = ρ fixed, cut the unit cube into N/ρ cells of edge
//! d. Volume, area and edge length are sums over the cells. The term of a cell depends only on the cubes of the cell
//! and its neighbours. So distant cells are all but independent, and all cells are alike except at the walls. The
//! variance of such a sum is proportional to its number of terms, and so is its mean. So the standard deviation,
//! relative to the mean, is κ(ρ) / √N, up to a part for the walls that goes to zero with d.

use predicament_cube_union::algorithm::cube_union;
use predicament_cube_union::checks::Expected;

use super::scenes::uniform;

/// The names of the measures.
const NAMES: [&str; 3] = ["volume", "area", "edge length"];

/// Measures of random unions, divided by the expected ones.
struct Sample {
    cubes: u32,
    /// For each measure, one value for each run, about 1.
    ratios: [Vec<f64>; 3],
}

impl Sample {
    fn new(cubes: u32, density: f64, runs: u32) -> Sample {
        let unit = f64::from(1 << 30);
        let mut ratios = [const { Vec::new() }; 3];
        // (the edge is the same for all)
        let edge = uniform(1, density / f64::from(cubes), 0).1;
        let expected = Expected::new(cubes, f64::from(edge) / unit);
        for run in 0..runs {
            let (lowers, length) = uniform(cubes, density, u64::from(1000 + run));
            assert_eq!(length, edge);
            let mass = cube_union(&lowers, length).unwrap();
            #[allow(clippy::cast_precision_loss)] // far from the last bit
            let found = [
                mass.volume as f64 / (unit * unit * unit) / expected.volume,
                mass.area as f64 / (unit * unit) / expected.area,
                mass.edge_length as f64 / unit / expected.edge_length,
            ];
            ratios.iter_mut().zip(found).for_each(|(ratios, found)| ratios.push(found));
        }
        Sample { cubes, ratios }
    }

    fn means(&self) -> [f64; 3] {
        self.ratios.each_ref().map(|ratios| ratios.iter().sum::<f64>() / count(ratios))
    }

    /// The scatter κ: the standard deviation of one run, times √N.
    fn scatter(&self) -> [f64; 3] {
        let means = self.means();
        [0, 1, 2].map(|at| {
            let squares: f64 = self.ratios[at].iter().map(|x| (x - means[at]).powi(2)).sum();
            (squares / (count(&self.ratios[at]) - 1.0) * f64::from(self.cubes)).sqrt()
        })
    }

    /// Asserts that the means are near 1, given the scatter κ.
    fn assert_near(&self, scatter: [f64; 3]) {
        for at in 0..3 {
            let (mean, runs) = (self.means()[at], count(&self.ratios[at]));
            let error = scatter[at] / (f64::from(self.cubes) * runs).sqrt();
            let score = (mean - 1.0) / error;
            println!(
                "{} cubes, {runs} runs: {} {mean:.9} of the expected, off by {score:+.2} of {error:.1e}",
                self.cubes, NAMES[at]
            );
            // The scatter has to be small, or the check would be empty.
            assert!(error < 0.01, "standard error {error} of the {}", NAMES[at]);
            // |t| > 5 with 7 degrees of freedom or more: once in 600 for correct samples; these are seeded.
            assert!(score.abs() < 5.0, "{} off by {score} standard errors", NAMES[at]);
        }
    }
}

#[allow(clippy::cast_precision_loss)] // few
fn count(list: &[f64]) -> f64 {
    list.len() as f64
}

/// Asserts that the runs have the expected measures, given their scatter.
fn assert_expected(cubes: u32, density: f64, runs: u32) {
    let sample = Sample::new(cubes, density, runs);
    sample.assert_near(sample.scatter());
}

#[test]
fn a_thousand_cubes_have_the_expected_measures_at_all_densities() {
    for density in [0.1, 1.0, 4.0] {
        assert_expected(1000, density, predicament_effort::cases(200));
    }
}

#[test]
fn a_handful_of_cubes_has_the_expected_measures() {
    // Few cubes: one cube more or less makes a large difference.
    for (cubes, density) in [(3, 0.3), (8, 0.9)] {
        assert_expected(cubes, density, predicament_effort::cases(4000));
    }
}

/// At whole effort; by default with a fiftieth of the cubes.
#[test]
fn a_hundred_thousand_cubes_have_the_expected_measures_and_scatter_by_the_law() {
    let [few, many] = [10_000, 100_000].map(|cubes| cubes / predicament_effort::some_or_all(50, 1));
    let (few, many) = (Sample::new(few, 1.0, 100), Sample::new(many, 1.0, 40));
    many.assert_near(many.scatter());
    for ((name, few), many) in NAMES.iter().zip(few.scatter()).zip(many.scatter()) {
        println!("{name}: κ = {few:.4} for few cubes, {many:.4} for ten times as many");
        // √F with 39 and 99 degrees of freedom is outside of this range once in 500; without the √N it would be about
        // 0.32.
        assert!((0.65..1.5).contains(&(many / few)), "{name}: κ = {few} for few cubes and {many} for many");
    }
}

/// At whole effort; by default with far fewer cubes.
#[test]
fn a_million_and_ten_million_cubes_have_the_expected_measures() {
    let less = predicament_effort::some_or_all(160, 1);
    let million = Sample::new(1_000_000 / less, 1.0, 8);
    million.assert_near(million.scatter());
    // One run: the remaining degrees of freedom, seven, are those of the scatter.
    Sample::new(10_000_000 / less, 1.0, 1).assert_near(million.scatter());
}
