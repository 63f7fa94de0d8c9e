//! Moves of a point onto or near the span of others, rounded to doubles.
//!
//! The nearest doubles to a point of a line are rarely on it. So the results are nearly degenerate, and sometimes
//! exactly degenerate, if all numbers are short.

use predicament_formats::bits::power_of_two;

use super::Draft;

/// A point and N others of its dimension, all at different positions.
fn spanned<const N: usize>(draft: &mut Draft<'_>) -> Option<(usize, [Vec<f64>; N])> {
    let (at, row) = draft.pick()?;
    let mut places = vec![at];
    let mut others: Vec<Vec<f64>> = Vec::new();
    for _ in 0..N {
        let (place, other) = draft.another(row.len(), &places)?;
        places.push(place);
        others.push(other);
    }
    Some((at, others.try_into().ok()?))
}

/// A parameter along a line: a fraction of small integers, or any number.
fn parameter(draft: &mut Draft<'_>) -> f64 {
    match draft.below(4) {
        0 => draft.random.unit(),
        1 => 4.0 * draft.random.unit() - 1.5,
        2 => {
            let power = power_of_two(draft.random.integer(-20, 3));
            if draft.random.one_in(3) { -power } else { power }
        }
        _ => {
            let [above, below] = [draft.random.nonzero(8), draft.random.integer(1, 8)];
            #[allow(clippy::cast_precision_loss)] // small
            let fraction = above as f64 / below as f64;
            fraction
        }
    }
}

/// The point p + t·(q − p).
fn along(p: &[f64], q: &[f64], t: f64) -> Vec<f64> {
    p.iter().zip(q).map(|(a, b)| a + t * (b - a)).collect()
}

/// The largest distance of two points along an axis.
fn reach(p: &[f64], q: &[f64]) -> f64 {
    p.iter().zip(q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Moves a point onto another point.
pub(super) fn onto_point(draft: &mut Draft<'_>) -> bool {
    let Some((at, [p])) = spanned::<1>(draft) else { return false };
    draft.put(at, &p)
}

/// Moves a point beside another point, at any distance.
pub(super) fn near_point(draft: &mut Draft<'_>) -> bool {
    let Some((at, [p, q])) = spanned::<2>(draft) else { return false };
    let near = off(draft, &p, reach(&p, &q));
    draft.put(at, &near)
}

/// A point displaced by some fraction of a length.
fn off(draft: &mut Draft<'_>, p: &[f64], length: f64) -> Vec<f64> {
    let part = power_of_two(-draft.random.integer(1, 60));
    p.iter().map(|x| x + length * part * (2.0 * draft.random.unit() - 1.0)).collect()
}

/// Moves a point onto the line of two others.
pub(super) fn onto_line(draft: &mut Draft<'_>) -> bool {
    let Some((at, [p, q])) = spanned::<2>(draft) else { return false };
    let t = parameter(draft);
    draft.put(at, &along(&p, &q, t))
}

/// Moves a point beside the line of two others, at any distance.
pub(super) fn near_line(draft: &mut Draft<'_>) -> bool {
    let Some((at, [p, q])) = spanned::<2>(draft) else { return false };
    let t = parameter(draft);
    let near = off(draft, &along(&p, &q, t), reach(&p, &q));
    draft.put(at, &near)
}

/// Moves a point onto the plane of three others; in 2D, onto the line from one point to a point of the others' line.
pub(super) fn onto_plane(draft: &mut Draft<'_>) -> bool {
    let Some((at, [p, q, r])) = spanned::<3>(draft) else { return false };
    let [s, t] = [parameter(draft), parameter(draft)];
    let onto = along(&along(&p, &q, s), &r, t);
    draft.put(at, &onto)
}

/// Moves a point to the fourth corner of a parallelogram.
pub(super) fn parallelogram(draft: &mut Draft<'_>) -> bool {
    let Some((at, [p, q, r])) = spanned::<3>(draft) else { return false };
    let corner: Vec<f64> = p.iter().zip(&q).zip(&r).map(|((a, b), c)| a + (b - c)).collect();
    draft.put(at, &corner)
}

/// Moves a point onto the circle of three others, or the sphere of four.
pub(super) fn onto_sphere(draft: &mut Draft<'_>) -> bool {
    let Some((at, row)) = draft.pick() else { return false };
    let mut places = vec![at];
    let mut others = Vec::new();
    for _ in 0..=row.len() {
        let Some((place, other)) = draft.another(row.len(), &places) else { return false };
        places.push(place);
        others.push(other);
    }
    let Some(center) = center(&others) else { return false };
    let on = if draft.random.one_in(2) {
        // The mirror image of one of them in the centre, along some axes: exact if numbers are short.
        let image = |(x, c): (&f64, &f64)| if draft.random.one_in(2) { 2.0 * c - x } else { *x };
        others[0].iter().zip(&center).map(image).collect()
    } else {
        let direction: Vec<f64> = center.iter().map(|_| 2.0 * draft.random.unit() - 1.0).collect();
        let length = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let arm: Vec<f64> = others[0].iter().zip(&center).map(|(x, c)| x - c).collect();
        let factor = length(&arm) / length(&direction);
        center.iter().zip(&direction).map(|(c, x)| c + factor * x).collect::<Vec<f64>>()
    };
    draft.put(at, &on)
}

/// The centre of the circle of three points or the sphere of four, by elimination.
fn center(points: &[Vec<f64>]) -> Option<Vec<f64>> {
    let (last, rest) = points.split_last()?;
    let n = last.len();
    let mut rows: Vec<Vec<f64>> = rest
        .iter()
        .map(|p| {
            let mut row: Vec<f64> = p.iter().zip(last).map(|(a, b)| a - b).collect();
            row.push(row.iter().map(|x| x * x).sum::<f64>() / 2.0);
            row
        })
        .collect();
    for column in 0..n {
        let pivot = (column..n).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))?;
        rows.swap(column, pivot);
        let top = rows[column].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(place, _)| *place != column) {
            let factor = row[column] / top[column];
            row.iter_mut().zip(&top).for_each(|(x, t)| *x -= factor * t);
        }
    }
    let center: Vec<f64> = (0..n).map(|axis| last[axis] + rows[axis][n] / rows[axis][axis]).collect();
    center.iter().all(|x| x.is_finite()).then_some(center)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn centers_are_as_far_from_all() {
        let circle = [vec![5.0, 0.0], vec![3.0, 4.0], vec![0.0, 5.0]];
        assert_eq!(center(&circle), Some(vec![0.0, 0.0]));
        let sphere = [vec![1.0, 1.0, 0.0], vec![2.0, 0.0, 0.0], vec![1.0, 0.0, 1.0], vec![0.0, 0.0, 0.0]];
        assert_eq!(center(&sphere), Some(vec![1.0, 0.0, 0.0]));
        assert_eq!(center(&[vec![0.0, 0.0], vec![1.0, 1.0], vec![2.0, 2.0]]), None);
    }
}
