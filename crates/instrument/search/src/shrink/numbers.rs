//! Simplification of coordinates: one dimension less, small integers, few bits, no offset.
//!
//! First all coordinates at once, since most findings depend on relations between coordinates; then one at a time.

use predicament_corpus::Spelled;

use super::size::{cost, exponent};
use super::{End, Search};
use crate::rows::width;

/// The maximum number of rows whose coordinates are simplified together; beyond it, they are simplified one at a time.
const MOST_ROWS: usize = 50;

/// Simplifies all coordinates.
pub(super) fn simplify(search: &mut Search<'_>) -> Result<(), End> {
    flatten(search)?;
    ranks(search)?;
    translate(search)?;
    scale(search)?;
    fewer_bits(search, &|_, _| true)?;
    for axis in 0..axes(&search.best) {
        fewer_bits(search, &|_, at| at == axis)?;
    }
    for row in 0..search.best.rows().len().min(MOST_ROWS) {
        fewer_bits(search, &|at, _| at == row)?;
    }
    loop {
        let before = search.size.clone();
        each(search)?;
        if search.size == before {
            return Ok(());
        }
    }
}

/// A copy of the scene with every coordinate replaced; the function takes the axis and the coordinate.
fn mapped(spelled: &Spelled, mut with: impl FnMut(usize, f64) -> f64) -> Option<Spelled> {
    let mut changed = spelled.clone();
    let mut finite = true;
    for row in changed.rows_mut() {
        let width = width(spelled, row.len());
        for (at, x) in row.iter_mut().enumerate() {
            *x = with(at % width, *x);
            finite &= x.is_finite();
        }
    }
    finite.then_some(changed)
}

fn axes(spelled: &Spelled) -> usize {
    spelled.rows().iter().map(|row| width(spelled, row.len())).max().unwrap_or(0)
}

/// Removes one coordinate axis, or makes it constant.
fn flatten(search: &mut Search<'_>) -> Result<(), End> {
    for axis in (0..axes(&search.best)).rev() {
        let mut less = search.best.clone();
        if less.points.iter().all(|point| point.len() == 3) {
            less.points.iter_mut().for_each(|point| {
                point.remove(axis);
            });
            // In 2D the plane of projection is the plane itself.
            less.words.retain(|(key, _)| *key != "plane" && *key != "axis");
            let with_axis = |axis: &str| {
                let mut less = less.clone();
                less.words.push(("axis", format!("\"{axis}\"")));
                less
            };
            for less in [less.clone(), with_axis("x"), with_axis("y")] {
                if search.try_one(less)? {
                    return Ok(());
                }
            }
        }
        if let Some(flat) = mapped(&search.best, |at, x| if at == axis { 0.0 } else { x }) {
            search.try_one(flat)?;
        }
    }
    Ok(())
}

/// Replaces coordinates by small integers in the same order: on each axis separately, and over all axes.
fn ranks(search: &mut Search<'_>) -> Result<(), End> {
    let ranked = |values: Vec<f64>| {
        let mut values = values;
        values.sort_by(f64::total_cmp);
        values.dedup_by(|a, b| a == b);
        values
    };
    let all = ranked(search.best.rows().into_iter().flatten().copied().collect());
    let rank = |values: &[f64], x: f64| small(values.partition_point(|&other| other < x));
    if let Some(simple) = mapped(&search.best, |_, x| rank(&all, x)) {
        search.try_one(simple)?;
    }
    let by_axis: Vec<Vec<f64>> = (0..axes(&search.best))
        .map(|axis| ranked(search.best.rows().iter().filter_map(|row| row.get(axis).copied()).collect()))
        .collect();
    for axis in 0..by_axis.len() {
        if let Some(simple) = mapped(&search.best, |at, x| if at == axis { rank(&by_axis[at], x) } else { x }) {
            search.try_one(simple)?;
        }
    }
    Ok(())
}

/// A count as a double, exactly.
fn small(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}

/// Moves the first row, or the least coordinate of each axis, to the origin, if no coordinate is rounded.
fn translate(search: &mut Search<'_>) -> Result<(), End> {
    let rows = search.best.rows();
    let Some(first) = rows.first().map(|row| (*row).clone()) else { return Ok(()) };
    let least: Vec<f64> = (0..axes(&search.best))
        .map(|axis| rows.iter().filter_map(|row| row.get(axis).copied()).fold(f64::INFINITY, f64::min))
        .collect();
    for origin in [first, least] {
        // By axis, as often only one axis has an offset, then all together.
        let count = origin.len();
        for axes in (0..count).map(|axis| axis..axis + 1).chain(std::iter::once(0..count)) {
            let mut exact = true;
            let moved = mapped(&search.best, |axis, x| match origin.get(axis) {
                Some(&o) if axes.contains(&axis) => {
                    let difference = x - o;
                    exact &= difference + o == x && x - difference == o;
                    difference
                }
                _ => x,
            });
            if let Some(moved) = moved.filter(|_| exact) {
                search.try_one(moved)?;
            }
        }
    }
    Ok(())
}

/// Multiplies all coordinates by a power of two, so that the largest is about one, or the smallest bit is one.
fn scale(search: &mut Search<'_>) -> Result<(), End> {
    let values: Vec<f64> = search.best.rows().into_iter().flatten().copied().filter(|&x| x != 0.0).collect();
    let Some(largest) = values.iter().map(|&x| exponent(x)).max() else { return Ok(()) };
    let lowest = values.iter().filter_map(|&x| predicament_formats::bits::lowest_bit(x)).min().unwrap_or(0);
    let lowest = i32::try_from(lowest).unwrap_or(0);
    let smallest = values.iter().map(|&x| exponent(x)).min().unwrap_or(0);
    for by in [-lowest, -largest, -smallest] {
        let mut exact = true;
        let scaled = mapped(&search.best, |_, x| {
            let scaled = times_power(x, by);
            exact &= times_power(scaled, -by) == x;
            scaled
        });
        if let Some(scaled) = scaled.filter(|_| exact) {
            search.try_one(scaled)?;
        }
    }
    Ok(())
}

/// The value x · 2^by, in steps that are doubles.
fn times_power(x: f64, by: i32) -> f64 {
    let mut scaled = x;
    let mut left = by;
    while left != 0 {
        let step = left.clamp(-1000, 1000);
        scaled *= f64::powi(2.0, step);
        left -= step;
    }
    scaled
}

/// The nearest double with a significand of `bits` bits.
fn rounded(x: f64, bits: u32) -> f64 {
    if x == 0.0 || bits >= 53 {
        return x;
    }
    let drop = 53 - bits;
    let half = 1_u64 << (drop - 1);
    f64::from_bits((x.to_bits() + half) >> drop << drop)
}

/// The value x rounded to a multiple of 2^unit.
fn to_multiple(x: f64, unit: i32) -> f64 {
    let scaled = times_power(x, -unit);
    if scaled.is_finite() { times_power(scaled.round(), unit) } else { x }
}

/// Removes bits of the selected coordinates at once: from their significands, and below one power of two.
fn fewer_bits(search: &mut Search<'_>, is_one: &dyn Fn(usize, usize) -> bool) -> Result<(), End> {
    for bits in [1, 2, 3, 4, 6, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 50, 51, 52] {
        if try_some(search, is_one, &|x| rounded(x, bits))? {
            break;
        }
    }
    let rows = search.best.rows().into_iter().enumerate();
    let chosen = rows.flat_map(|(row, all)| all.iter().enumerate().map(move |(axis, &x)| (row, axis, x)));
    let chosen = chosen.filter(|&(row, axis, x)| x != 0.0 && is_one(row, axis));
    let Some(largest) = chosen.map(|(_, _, x)| exponent(x)).max() else { return Ok(()) };
    for below in [0, 1, 2, 3, 4, 6, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 50, 51, 52, 53, 56, 60] {
        if try_some(search, is_one, &|x| to_multiple(x, largest - below))? {
            break;
        }
    }
    Ok(())
}

/// Tries the scene with some of its coordinates replaced; true if it replaces the best one.
fn try_some(
    search: &mut Search<'_>,
    is_one: &dyn Fn(usize, usize) -> bool,
    with: &dyn Fn(f64) -> f64,
) -> Result<bool, End> {
    let mut changed = search.best.clone();
    let mut finite = true;
    for (row, all) in changed.rows_mut().enumerate() {
        for (_, x) in all.iter_mut().enumerate().filter(|(axis, _)| is_one(row, *axis)) {
            *x = with(*x);
            finite &= x.is_finite();
        }
    }
    if finite { search.try_one(changed) } else { Ok(false) }
}

/// Simplifies each coordinate separately.
fn each(search: &mut Search<'_>) -> Result<(), End> {
    let rows = search.best.rows().len();
    for row in 0..rows {
        let mut axis = 0;
        while let Some(x) = search.best.rows().get(row).and_then(|row| row.get(axis).copied()) {
            for simple in simpler(x) {
                let mut changed = search.best.clone();
                if let Some(place) = changed.rows_mut().nth(row).and_then(|row| row.get_mut(axis)) {
                    *place = simple;
                }
                if search.try_one(changed)? {
                    break;
                }
            }
            axis += 1;
        }
    }
    Ok(())
}

/// Numbers that are simpler than this one, the simplest first.
fn simpler(x: f64) -> Vec<f64> {
    let sign = if x < 0.0 { -1.0 } else { 1.0 };
    let mut all = vec![0.0, 1.0, -1.0, 2.0, 3.0, 0.5, x.round(), x.trunc(), -x];
    if x != 0.0 {
        let power = exponent(x);
        all.extend([power, power + 1].map(|power| sign * times_power(1.0, power)));
        all.extend([1, 2, 3, 4, 6, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 50, 51, 52].map(|bits| rounded(x, bits)));
        // The same bits nearer to one, for numbers that only have to be small or large.
        all.extend([power / 2, power - power.signum()].map(|shift| times_power(x, shift - power)));
    }
    let mut simple: Vec<f64> = Vec::new();
    for other in all {
        if other.is_finite() && cost(other) < cost(x) && simple.iter().all(|it| it.to_bits() != other.to_bits()) {
            simple.push(other);
        }
    }
    simple.sort_by_key(|&x| cost(x));
    simple
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn simpler_numbers_are_simpler_and_bounded() {
        for x in [0.1, -0.1, 1e300, f64::from_bits(1), f64::MAX, -7.0, 1.0 + f64::EPSILON] {
            let all = simpler(x);
            assert!(!all.is_empty() && all.len() < 40, "{x}");
            assert!(all.iter().all(|&it| cost(it) < cost(x)), "{x}");
        }
        assert!(simpler(0.0).is_empty());
        assert_eq!(simpler(-0.0), vec![0.0_f64]);
        assert_eq!([rounded(0.1, 1), rounded(7.0, 2), rounded(f64::MAX, 1)], [0.125, 8.0, f64::INFINITY]);
        assert_eq!(times_power(f64::from_bits(1), 1074), 1.0);
        assert_eq!([to_multiple(0.3, -1), to_multiple(0.3, -2), to_multiple(-5.0, 1)], [0.5, 0.25, -6.0]);
    }
}
