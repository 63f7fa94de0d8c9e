//! The bisection: from a wrong answer outwards to a right one, and back to the border between them.

/// The doubles in their order, as integers: neighbours differ by one, and both zeros are 0.
///
/// A sum of two places has more than 64 bits.
fn place(x: f64) -> i128 {
    let magnitude = i128::from(x.abs().to_bits());
    if x.is_sign_negative() { -magnitude } else { magnitude }
}

/// The double at a place.
fn double(place: i128) -> f64 {
    let magnitude = f64::from_bits(u64::try_from(place.unsigned_abs()).unwrap_or(u64::MAX));
    if place < 0 { -magnitude } else { magnitude }
}

/// The place of the largest double.
const LAST: u64 = f64::MAX.to_bits();

/// Two neighbouring values of one coordinate.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Border {
    /// The index of the coordinate.
    pub coordinate: usize,
    /// The value at which the answer is wrong.
    pub wrong: f64,
    /// The neighbouring value at which the answer is right.
    pub right: f64,
    /// The number of doubles from the value where the search began to the wrong value.
    pub steps: u128,
}

/// The nearest border of a wrong input along one of its coordinates, by doubling steps and bisection; `None` if every
/// step along every coordinate is wrong too.
///
/// `is_right` returns the verdict about other coordinates, or `None` if there is none; then the search goes on as if
/// the answer were wrong.
pub fn border(input: &[f64], mut is_right: impl FnMut(&[f64]) -> Option<bool>) -> Option<Border> {
    let mut best: Option<Border> = None;
    let mut moved = input.to_vec();
    for coordinate in 0..input.len() {
        let from = place(input[coordinate]);
        for way in [1, -1] {
            if best.is_some_and(|best| best.steps == 0) {
                return best;
            }
            let mut right_at = |steps: i128| {
                moved[coordinate] = double(from + way * steps);
                is_right(&moved) == Some(true)
            };
            let room = i128::from(LAST) - way * from;
            let limit = best.map_or(room, |best| room.min(best.steps.cast_signed()));
            let (mut wrong, mut right) = (0_i128, 1);
            while right <= limit && !right_at(right) {
                wrong = right;
                // Beyond the largest step, the limit itself is the last try.
                right = if right > limit / 2 && right < limit { limit } else { 2 * right };
            }
            if right > limit {
                continue;
            }
            while right - wrong > 1 {
                let middle = wrong + (right - wrong) / 2;
                if right_at(middle) { right = middle } else { wrong = middle }
            }
            let [wrong_at, right_at] = [wrong, right].map(|steps| double(from + way * steps));
            let steps = wrong.unsigned_abs();
            if best.is_none_or(|best| steps < best.steps) {
                best = Some(Border { coordinate, wrong: wrong_at, right: right_at, steps });
            }
        }
        moved[coordinate] = input[coordinate];
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_border_is_between_two_neighbours() {
        let limit = 0.3;
        let found = border(&[7.0, 1.0], |x| Some(x[1] < limit)).unwrap();
        assert_eq!((found.coordinate, found.wrong, found.right), (1, limit, limit.next_down()));
        assert_eq!(found.steps.cast_signed(), place(1.0) - place(limit));
    }

    #[test]
    fn the_nearest_border_is_found_through_zero() {
        let found = border(&[5e-324, 1e9], |x| Some(x[0] <= -5e-324 || x[1] > 1e10)).unwrap();
        assert_eq!((found.coordinate, found.wrong, found.right, found.steps), (0, 0.0, -5e-324, 1));
    }

    #[test]
    fn what_is_wrong_everywhere_has_no_border() {
        assert_eq!(border(&[1.0, -1.0], |_| Some(false)), None);
        assert_eq!(border(&[1.0], |_| None), None);
    }
}
