//! The filter of constructed vertices that is linear in their slacks, in tiny formats: all turns of a few numbers.
//!
//! A certain sign has to be that of all points within the slacks. A turn is linear in each coordinate, so the corners
//! of the slacks decide. Numbers are large enough that values, bounds or the last product, by 1/u, overflow.

use predicament_exact::constructed::filter::Approximate;
use predicament_exact::constructed::tight::{self, TURN};

use super::*;

/// The numbers of turns that were tried, that are certain, and that are so by a value that overflows in units of u.
type Counts = [u64; 3];

/// Tries all turns of the numbers: as they are, and with each pattern of points that have a slack.
fn every_turn<const P: i32, const K: i32>(numbers: &[i64], step: usize, roundings: i64) -> Result<Counts, String> {
    type Format<const P: i32, const K: i32> = Toy<P, K, 0>;
    let [unit, units] = [2_f64.powi(-P), 2_f64.powi(P)].map(Format::<P, K>::rounded);
    // The roundings of the bound, of the differences in it and of the value, by the proof in `tight`.
    let room = Format::<P, K>::above((1.0 + unit.0) / (1.0 - unit.0).powi(10));
    let total = numbers.len().pow(6);
    let mut counts = [0; 3];
    for at in (0..total).step_by(step) {
        let mut rest = at;
        let points: [[i64; 2]; 3] = [[(); 2]; 3].map(|point| {
            point.map(|()| {
                let number = numbers[rest % numbers.len()];
                rest /= numbers.len();
                number
            })
        });
        for pattern in 0..8_u32 {
            // A quantum or none, which is so many u.
            let wrong = [0, 1, 2].map(|point| i64::from(pattern >> point & 1));
            let near = |point: usize| {
                points[point].map(|x| Approximate::near(Format::<P, K>::of(x), Format::of(wrong[point] << P)))
            };
            let found = tight::turn([near(0), near(1), near(2)], unit);
            counts[0] += 1;
            if !found.is_certain(room, Format::of(roundings), units) {
                continue;
            }
            counts[1] += 1;
            counts[2] += u64::from(found.value.0.is_finite() && (found.value * units).0.is_infinite());
            let expected = if found.value.0 > 0.0 { 1 } else { -1 };
            for corner in 0..64_u32 {
                let moved = |point: usize, axis: usize| {
                    let way = i64::from(corner >> (2 * point + axis) & 1) * 2 - 1;
                    points[point][axis] + way * wrong[point]
                };
                let [a, b, c] = [0, 1, 2].map(|point| [moved(point, 0), moved(point, 1)]);
                let turn = (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
                if turn.signum() != expected {
                    return Err(format!("{points:?}, wrong by {wrong:?}: {found:?}, and exactly {turn}"));
                }
            }
        }
    }
    Ok(counts)
}

/// Numbers of three magnitudes of a format of 4 bits, whose differences need rounding.
const NUMBERS: [i64; 7] = [-40, -9, -1, 0, 8, 11, 44];
/// The bound of a turn: see [`TURN`].
const ROUNDINGS: i64 = 1;

#[test]
fn no_turn_within_slacks_is_certain_and_wrong() {
    assert!((TURN - 1.0).abs() < f64::EPSILON);
    // Without overflow, with overflow of the last product, and with overflow of values.
    let step = predicament_effort::some_or_all(7, 1);
    let all = [
        every_turn::<4, 20>(&NUMBERS, step, ROUNDINGS),
        every_turn::<4, 10>(&NUMBERS, step, ROUNDINGS),
        every_turn::<4, 8>(&NUMBERS, step, ROUNDINGS),
    ];
    let all = all.map(|counts| counts.unwrap_or_else(|why| panic!("{why}")));
    println!("turns, certain, of them with an overflow in units of u: {all:?}");
    assert!(all.iter().all(|[tried, certain, _]| *certain > tried / 20), "{all:?}");
    assert_eq!(all[0][2], 0);
    assert!(all[1..].iter().all(|[_, certain, over]| *over > certain / 10), "{all:?}");
}

#[test]
fn a_bound_without_the_roundings_of_products_is_found() {
    assert!(every_turn::<4, 20>(&NUMBERS, 1, -2).is_err());
}
