//! Areas in rationals: of the result of an operation from its operands alone, strip by strip, and of a program's rings.

use rug::Rational;

use super::super::overlay::Point;
use super::Rings;
use crate::answer::Operation;
use predicament_judge::rational;
use predicament_judge::sum::sum;

/// Twice the area of a program's polygons: of the outer rings, less that of the holes.
pub(super) fn area_of_rings(rings: &Rings) -> Rational {
    let of_ring = |ring: &Vec<[f64; 2]>| {
        let exact: Vec<Point> = ring.iter().map(|p| p.map(rational)).collect();
        let sides = exact.iter().zip(exact.iter().cycle().skip(1));
        let twice = sides.map(|(a, b)| Rational::from(&a[0] * &b[1]) - Rational::from(&a[1] * &b[0]));
        sum(twice.collect()).abs()
    };
    let of_polygon = |polygon: &Vec<Vec<[f64; 2]>>| {
        let signed = polygon.iter().enumerate().map(|(at, ring)| if at == 0 { of_ring(ring) } else { -of_ring(ring) });
        sum(signed.collect())
    };
    sum(rings.iter().map(of_polygon).collect())
}

/// Twice the area of the result of an operation: between the heights of all ends and crossings, the edges divide each
/// strip into trapezoids, each of which is in the result or not.
pub(super) fn area_of_operation(
    operands: [&[[[f64; 2]; 2]]; 2],
    inside: fn(i32) -> bool,
    operation: Operation,
) -> Rational {
    let edge = |operand: usize| {
        move |ends: &[[f64; 2]; 2]| -> Option<(usize, [Point; 2])> {
            (ends[0][1] != ends[1][1]).then(|| (operand, ends.map(|end| end.map(rational))))
        }
    };
    let all: Vec<(usize, [Point; 2])> =
        operands.into_iter().enumerate().flat_map(|(at, edges)| edges.iter().filter_map(edge(at))).collect();
    let mut heights: Vec<Rational> = all.iter().flat_map(|(_, ends)| ends.iter().map(|end| end[1].clone())).collect();
    for (at, (_, one)) in all.iter().enumerate() {
        heights.extend(all[..at].iter().filter_map(|(_, other)| height_of_crossing(one, other)));
    }
    heights.sort();
    heights.dedup();
    let mut terms = Vec::new();
    for strip in heights.windows(2) {
        let middle = Rational::from(&strip[0] + &strip[1]) / 2;
        let height = Rational::from(&strip[1] - &strip[0]);
        let crossing = all.iter().filter(|(_, [a, b])| (a[1] < middle) != (b[1] < middle));
        let mut at: Vec<(Rational, usize, i32)> = crossing
            .map(|(operand, [a, b])| {
                let part = Rational::from(&middle - &a[1]) / Rational::from(&b[1] - &a[1]);
                let x = part * Rational::from(&b[0] - &a[0]) + &a[0];
                (x, *operand, if a[1] < b[1] { 1 } else { -1 })
            })
            .collect();
        at.sort();
        let mut winding = [0; 2];
        for pair in at.windows(2) {
            // An ascending edge has on its right one less than on its left.
            let (x, operand, way) = &pair[0];
            winding[*operand] -= way;
            if operation.holds(winding.map(inside)) {
                terms.push(Rational::from(&pair[1].0 - x) * &height * 2);
            }
        }
    }
    sum(terms)
}

/// The height at which two edges cross or touch.
fn height_of_crossing([a, b]: &[Point; 2], [c, d]: &[Point; 2]) -> Option<Rational> {
    let minus = |p: &Point, q: &Point| [0, 1].map(|i: usize| Rational::from(&p[i] - &q[i]));
    let cross = |u: &Point, v: &Point| Rational::from(&u[0] * &v[1]) - Rational::from(&u[1] * &v[0]);
    let [u, v, w] = [minus(b, a), minus(d, c), minus(c, a)];
    let determinant = cross(&u, &v);
    if determinant.is_zero() {
        return None;
    }
    let [t, s] = [cross(&w, &v) / &determinant, cross(&w, &u) / &determinant];
    let is_part = |x: &Rational| x.cmp0().is_ge() && *x <= 1;
    (is_part(&t) && is_part(&s)).then(|| t * &u[1] + &a[1])
}
