//! Medians, spreads and geometric means of timings.

/// The median, the smallest and the largest of some samples.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Spread {
    /// The smallest sample.
    pub min: f64,
    /// The middle sample, or the mean of the middle two.
    pub median: f64,
    /// The largest sample.
    pub max: f64,
    /// The number of samples.
    pub samples: usize,
}

impl Spread {
    /// The spread of some numbers; `None` if there are none, or one is NaN.
    #[must_use]
    pub fn of(samples: impl IntoIterator<Item = f64>) -> Option<Spread> {
        let mut sorted: Vec<f64> = samples.into_iter().collect();
        if sorted.iter().any(|x| x.is_nan()) {
            return None;
        }
        sorted.sort_unstable_by(f64::total_cmp);
        let (&min, &max) = (sorted.first()?, sorted.last()?);
        let half = sorted.len() / 2;
        let median =
            if sorted.len().is_multiple_of(2) { sorted[half - 1].midpoint(sorted[half]) } else { sorted[half] };
        Some(Spread { min, median, max, samples: sorted.len() })
    }
}

/// The geometric mean of positive numbers; `None` if there are none.
#[must_use]
pub fn geometric_mean(numbers: impl IntoIterator<Item = f64>) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0.0);
    for x in numbers {
        sum += x.ln();
        count += 1.0;
    }
    (count > 0.0).then(|| (sum / count).exp())
}

/// Wilson's 95 % interval of the true share, given `count` of `of`. It is (0, 1) if `of` is zero.
///
/// (Wilson 1927; the normal quantile is 1.96.)
#[must_use]
pub fn wilson(count: u64, of: u64) -> [f64; 2] {
    const Z: f64 = 1.959_963_984_540_054;
    if of == 0 {
        return [0.0, 1.0];
    }
    let n = approximately(of);
    let share = approximately(count) / n;
    let middle = share + Z * Z / (2.0 * n);
    let reach = Z * (share * (1.0 - share) / n + Z * Z / (4.0 * n * n)).sqrt();
    let [low, high] = [middle - reach, middle + reach].map(|x| x / (1.0 + Z * Z / n));
    // At the ends, rounding could leave a small error.
    [if count == 0 { 0.0 } else { low.max(0.0) }, if count == of { 1.0 } else { high.min(1.0) }]
}

/// A count as a divisor: the nearest double. Above 2^53 its error is smaller than any digit that a report prints.
#[must_use]
#[allow(clippy::cast_precision_loss)]
pub fn approximately(count: u64) -> f64 {
    count as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_of_odd_and_even_counts() {
        let spread = Spread::of([3.0, 1.0, 10.0]).unwrap();
        assert_eq!(spread, Spread { min: 1.0, median: 3.0, max: 10.0, samples: 3 });
        assert_eq!(Spread::of([4.0, 1.0, 2.0, 100.0]).unwrap().median, 3.0);
        assert_eq!(Spread::of([]), None);
        assert_eq!(Spread::of([1.0, f64::NAN]), None);
    }

    #[test]
    fn intervals_of_shares() {
        // Expected values from a published table (Newcombe 1998, table I, method 3).
        for (count, of, low, high) in [(81, 263, 0.2553, 0.3662), (15, 148, 0.0624, 0.1605), (0, 20, 0.0, 0.1611)] {
            let [l, h] = wilson(count, of);
            assert!((l - low).abs() < 5e-5 && (h - high).abs() < 5e-5, "{count} of {of}: {l}, {h}");
        }
        assert_eq!(wilson(0, 0), [0.0, 1.0]);
        assert_eq!(wilson(7, 7)[1], 1.0);
    }

    #[test]
    fn geometric_means() {
        assert!((geometric_mean([2.0, 8.0]).unwrap() - 4.0).abs() < 1e-12);
        assert_eq!(geometric_mean([]), None);
    }
}
