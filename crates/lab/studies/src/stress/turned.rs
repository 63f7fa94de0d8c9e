//! The positions of points after a knob is turned.

use nalgebra::{Rotation2, Rotation3, Vector2, Vector3};
use predicament_corpus::Random;
use predicament_predicates::Dimension;
use predicament_tasks::{Knob, SHIFTED_BITS};

/// The coordinates for a position of the knob.
pub(crate) fn turned(
    knob: Knob,
    position: i32,
    dimension: Dimension,
    coordinates: &[f64],
    random: &mut Random,
) -> Vec<f64> {
    let extent = extent(coordinates);
    match knob {
        Knob::Size => coordinates.to_vec(),
        Knob::Noise if position == -1075 => coordinates.to_vec(),
        Knob::Noise => {
            let most = extent * power(position);
            coordinates.iter().map(|x| x + most * random.between(-1.0, 1.0)).collect()
        }
        Knob::Translation => {
            let way = if position == 0 { 0.0 } else { extent * power(position) };
            coordinates.iter().map(|x| x + way).collect()
        }
        Knob::Shift => {
            // Multiples of this unit: the sum of a coordinate of at most the extent and a distance of at most 2^28
            // extents has 53 bits.
            let unit = extent * power(-SHIFTED_BITS);
            let way = if position == 0 { 0.0 } else { extent * power(position) };
            coordinates.iter().map(|x| (x / unit).round_ties_even() * unit + way).collect()
        }
        // In two steps, since a single factor may not be a double.
        Knob::Scale => coordinates.iter().map(|x| x * power(position / 2) * power(position - position / 2)).collect(),
        Knob::Aspect => {
            let count = dimension.count();
            let factor = |at: usize| if at % count == count - 1 { power(-position) } else { 1.0 };
            coordinates.iter().enumerate().map(|(at, x)| x * factor(at)).collect()
        }
        Knob::Precision => {
            // Rounded to multiples of this unit.
            let unit = extent * power(position - 52);
            coordinates.iter().map(|x| if position == 0 { *x } else { (x / unit).round_ties_even() * unit }).collect()
        }
        Knob::Pythagorean => (0..position).fold(coordinates.to_vec(), |all, _| pythagorean(dimension, &all)),
        Knob::Turn => rotated(dimension, coordinates, f64::from(position) * std::f64::consts::FRAC_PI_2 / 16.0),
    }
}

/// The least power of two that bounds all coordinates.
fn extent(coordinates: &[f64]) -> f64 {
    let largest = coordinates.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let mut power = 1.0;
    while power < largest {
        power *= 2.0;
    }
    while power / 2.0 >= largest && power > f64::MIN_POSITIVE {
        power /= 2.0;
    }
    power
}

fn power(k: i32) -> f64 {
    predicament_formats::bits::power_of_two(i64::from(k))
}

/// The points turned by the angle of (3, 4, 5) and scaled by five, in the plane of the first two coordinates, then of
/// the last two.
///
/// Integers stay integers.
fn pythagorean(dimension: Dimension, coordinates: &[f64]) -> Vec<f64> {
    let mut all = coordinates.to_vec();
    match dimension {
        Dimension::Two => {
            for point in all.as_chunks_mut::<2>().0 {
                let [x, y] = *point;
                *point = [3.0 * x - 4.0 * y, 4.0 * x + 3.0 * y];
            }
        }
        Dimension::Three => {
            for point in all.as_chunks_mut::<3>().0 {
                let [x, y, z] = *point;
                let [x, y, z] = [3.0 * x - 4.0 * y, 4.0 * x + 3.0 * y, 5.0 * z];
                *point = [5.0 * x, 3.0 * y - 4.0 * z, 4.0 * y + 3.0 * z];
            }
        }
    }
    all
}

/// The points turned by an angle; in space about an axis in general position.
fn rotated(dimension: Dimension, coordinates: &[f64], angle: f64) -> Vec<f64> {
    let mut all = coordinates.to_vec();
    match dimension {
        Dimension::Two => {
            let rotation = Rotation2::new(angle);
            for point in all.as_chunks_mut::<2>().0 {
                *point = (rotation * Vector2::from(*point)).into();
            }
        }
        Dimension::Three => {
            let rotation = Rotation3::new(angle * Vector3::new(1.0, 2.0, 2.0) / 3.0);
            for point in all.as_chunks_mut::<3>().0 {
                *point = (rotation * Vector3::from(*point)).into();
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use predicament_tasks::RoundsScene;

    use super::*;

    /// Shifted points have the same differences as at rest, in rationals; translated ones do not.
    #[test]
    fn a_shift_keeps_all_differences_and_a_translation_does_not() {
        use predicament_judge::rational;
        let mut random = Random::new("knob", "shift", 1);
        let points: Vec<f64> = (0..60).map(|_| random.between(-3.0, 3.0)).collect();
        let differences = |knob: Knob, position: i32| -> Vec<rug::Rational> {
            let mut random = Random::new("knob", "shift", 2);
            let moved = turned(knob, position, Dimension::Two, &points, &mut random);
            moved.windows(3).map(|of| rational(of[2]) - rational(of[0])).collect()
        };
        for &position in Knob::Shift.positions() {
            assert_eq!(differences(Knob::Shift, position), differences(Knob::Shift, 0), "{position}");
        }
        let last = *Knob::Shift.positions().last().unwrap();
        assert_eq!(last + SHIFTED_BITS + 1, 53);
        assert_ne!(differences(Knob::Translation, 8), differences(Knob::Translation, 0));
        assert_eq!([Knob::Shift, Knob::Translation].map(Knob::rounds), [RoundsScene::Never, RoundsScene::Always]);
    }

    #[test]
    fn knobs_at_rest_change_nothing_and_exact_ones_nothing_that_is_counted() {
        let points = [1.0, 2.0, 3.0, -4.0, 0.5, 6.0];
        for knob in Knob::ALL {
            let mut random = Random::new("knob", "test", 1);
            let rest = knob.positions()[0];
            for dimension in [Dimension::Two, Dimension::Three] {
                assert_eq!(turned(knob, rest, dimension, &points, &mut random), points, "{knob:?}");
            }
        }
        let mut random = Random::new("knob", "test", 1);
        let twice = turned(Knob::Pythagorean, 2, Dimension::Two, &points, &mut random);
        // Lengths are 25 times as large, exactly.
        for (p, q) in points.as_chunks::<2>().0.iter().zip(twice.as_chunks::<2>().0) {
            assert_eq!(625.0 * (p[0] * p[0] + p[1] * p[1]), q[0] * q[0] + q[1] * q[1]);
        }
        assert_eq!(turned(Knob::Precision, 50, Dimension::Two, &points, &mut random), [0.0, 2.0, 4.0, -4.0, 0.0, 6.0]);
        assert_eq!(extent(&points), 8.0);
    }
}
