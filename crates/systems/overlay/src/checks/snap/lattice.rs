//! Edges between points with integer coordinates, below 2^60: exact in 128 bits.

use super::Pixel;

fn turn(a: Pixel, b: Pixel, c: Pixel) -> i128 {
    let [ab, ac] = [b, c].map(|p| [0, 1].map(|axis| i128::from(p[axis]) - i128::from(a[axis])));
    ab[0] * ac[1] - ab[1] * ac[0]
}

/// True if two edges have a point in common that is not an end of both. The same edge twice, and edges that share only
/// an end, do not cross.
pub fn cross([a, b]: [Pixel; 2], [c, d]: [Pixel; 2]) -> bool {
    if a == b || c == d || [a, b] == [c, d] || [a, b] == [d, c] {
        return false;
    }
    let are_apart = |[a, b]: [Pixel; 2], [c, d]: [Pixel; 2], axis: usize| a[axis].max(b[axis]) < c[axis].min(d[axis]);
    if (0..2).any(|axis| are_apart([a, b], [c, d], axis) || are_apart([c, d], [a, b], axis)) {
        return false;
    }
    let is_inside = |p: Pixel, [q, r]: [Pixel; 2]| {
        let within = |axis: usize| q[axis].min(r[axis]) <= p[axis] && p[axis] <= q[axis].max(r[axis]);
        p != q && p != r && within(0) && within(1) && turn(q, r, p) == 0
    };
    if is_inside(a, [c, d]) || is_inside(b, [c, d]) || is_inside(c, [a, b]) || is_inside(d, [a, b]) {
        return true;
    }
    let opposite = |s: i128, t: i128| (s < 0 && t > 0) || (s > 0 && t < 0);
    opposite(turn(a, b, c), turn(a, b, d)) && opposite(turn(c, d, a), turn(c, d, b))
}

/// True if the squared distance of a point from an edge is at least a given fraction. Coordinates are below 2^31, and
/// the fraction's terms below 2^60: then only larger distances saturate.
pub fn distance2_at_least([a, b]: [Pixel; 2], p: Pixel, [numerator, denominator]: [i128; 2]) -> bool {
    let difference = |p: Pixel, q: Pixel| [0, 1].map(|axis| i128::from(p[axis]) - i128::from(q[axis]));
    let dot = |p: [i128; 2], q: [i128; 2]| p[0] * q[0] + p[1] * q[1];
    let [ab, ap, bp] = [difference(b, a), difference(p, a), difference(p, b)];
    let square = dot(ab, ab);
    let (distance, over) = match dot(ab, ap) {
        before if before <= 0 => (dot(ap, ap), 1),
        along if along >= square => (dot(bp, bp), 1),
        _ => {
            let height = ab[0] * ap[1] - ab[1] * ap[0];
            (height.unsigned_abs().checked_pow(2).and_then(|h| i128::try_from(h).ok()).unwrap_or(i128::MAX), square)
        }
    };
    distance.saturating_mul(denominator) >= over.saturating_mul(numerator)
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::*;

    /// All points of a lattice.
    fn lattice(end: i64) -> Vec<Pixel> {
        (0..end).flat_map(|x| (0..end).map(move |y| [x, y])).collect()
    }

    fn rational(p: Pixel) -> [Rational; 2] {
        p.map(Rational::from)
    }

    fn less([ax, ay]: &[Rational; 2], [bx, by]: &[Rational; 2]) -> [Rational; 2] {
        [Rational::from(ax - bx), Rational::from(ay - by)]
    }

    fn dot([ax, ay]: &[Rational; 2], [bx, by]: &[Rational; 2]) -> Rational {
        Rational::from(ax * bx) + Rational::from(ay * by)
    }

    /// True if a number is from 0 to 1.
    fn is_share(x: &Rational) -> bool {
        *x >= 0 && *x <= 1
    }

    /// The parameter s along the edge with p = a + s (b − a), if p is on it.
    fn place_on([a, b]: [Pixel; 2], p: Pixel) -> Option<Rational> {
        let [a, b, p] = [a, b, p].map(rational);
        let (along, to) = (less(&b, &a), less(&p, &a));
        let place = dot(&along, &to) / dot(&along, &along);
        let on = [0, 1].map(|i: usize| &a[i] + Rational::from(&place * &along[i]));
        (on == p && is_share(&place)).then_some(place)
    }

    /// True if edges that are not empty have a point in common that is not an end of both, by the equations of their
    /// points.
    fn have_common_point(e: [Pixel; 2], f: [Pixel; 2]) -> bool {
        let ([a, b], [c, d]) = (e.map(rational), f.map(rational));
        let (u, v, w) = (less(&b, &a), less(&d, &c), less(&c, &a));
        let determinant = Rational::from(&u[1] * &v[0]) - Rational::from(&u[0] * &v[1]);
        let is_inner = |s: &Rational| *s > 0 && *s < 1;
        if determinant.is_zero() {
            // On a line or parallel: an end inside the other edge.
            let inside = |edge: [Pixel; 2], p: Pixel| place_on(edge, p).is_some_and(|s| is_inner(&s));
            return e.iter().any(|&p| inside(f, p)) || f.iter().any(|&p| inside(e, p));
        }
        // a + s u = c + t v
        let s = (Rational::from(&w[1] * &v[0]) - Rational::from(&w[0] * &v[1])) / &determinant;
        let t = (Rational::from(&u[0] * &w[1]) - Rational::from(&u[1] * &w[0])) / &determinant;
        is_share(&s) && is_share(&t) && (is_inner(&s) || is_inner(&t))
    }

    #[test]
    fn edges_of_a_small_lattice_cross_where_they_have_a_common_point() {
        let points = lattice(3);
        let edges: Vec<[Pixel; 2]> = points.iter().flat_map(|&a| points.iter().map(move |&b| [a, b])).collect();
        let mut seen = [0; 2];
        for &e in &edges {
            for &f in &edges {
                let is_empty = e[0] == e[1] || f[0] == f[1];
                let expected = !is_empty && have_common_point(e, f);
                assert_eq!(cross(e, f), expected, "{e:?} {f:?}");
                seen[usize::from(expected)] += 1;
            }
        }
        assert!(seen[0] > 1000 && seen[1] > 500, "{seen:?}");
    }

    #[test]
    fn edges_of_a_line_cross_where_they_overlap() {
        // All orders of ends along a line that is not one of the axes.
        let on = |at: i64| [3 * at - 2, 5 - 2 * at];
        for [a, b, c, d] in (0..625).map(|code: i64| [code % 5, code / 5 % 5, code / 25 % 5, code / 125]) {
            let is_empty = a == b || c == d;
            let (low, high) = (a.min(b).max(c.min(d)), a.max(b).min(c.max(d)));
            let is_same = a.min(b) == c.min(d) && a.max(b) == c.max(d);
            let expected = !is_empty && !is_same && low < high;
            assert_eq!(cross([on(a), on(b)], [on(c), on(d)]), expected, "{a} {b} and {c} {d}");
        }
    }

    #[test]
    fn distances_from_edges_are_those_of_the_nearest_point() {
        let points = lattice(4);
        let mut seen = [0; 3];
        for &a in &points {
            for &b in points.iter().filter(|&&b| b != a) {
                for &p in &points {
                    let [ra, rb, rp] = [a, b, p].map(rational);
                    let along = less(&rb, &ra);
                    let place = dot(&along, &less(&rp, &ra)) / dot(&along, &along);
                    seen[if place <= 0 {
                        0
                    } else if place >= 1 {
                        2
                    } else {
                        1
                    }] += 1;
                    let place = place.clamp(&0, &1);
                    let nearest = [0, 1].map(|i: usize| &ra[i] + Rational::from(&place * &along[i]));
                    let to = less(&rp, &nearest);
                    let square = dot(&to, &to);
                    let at_least = |bound: &Rational| {
                        let [numerator, denominator] = [bound.numer(), bound.denom()].map(|n| n.to_i128().unwrap());
                        distance2_at_least([a, b], p, [numerator, denominator])
                    };
                    let what = format!("{p:?} from {a:?} {b:?}: {square}");
                    assert!(at_least(&square), "{what}");
                    assert!(!at_least(&(square.clone() + Rational::from((1, 1000)))), "{what}");
                    assert!(at_least(&(square - Rational::from((1, 1000)))), "{what}");
                }
            }
        }
        assert!(seen.iter().all(|&count| count > 500), "{seen:?}");
    }

    #[test]
    fn edges_of_pixels_far_apart_do_not_overflow() {
        let far = 1 << 59;
        assert!(cross([[-far, -far], [far, far]], [[-far, far], [far, -far]]));
        assert!(!cross([[-far, -far], [far, far]], [[-far, 1 - far], [far, far + 1]]));
        // The height of a corner over the diagonal.
        let far = 1 << 28;
        assert!(distance2_at_least([[-far, -far], [far, far]], [far, -far], [2 * i128::from(far).pow(2), 1]));
        assert!(!distance2_at_least([[-far, -far], [far, far]], [far, -far], [2 * i128::from(far).pow(2) + 1, 1]));
        // The largest extent: the comparison is right, although the square is beyond 128 bits.
        let far = (1 << 31) - 1;
        assert!(distance2_at_least([[-far, -far], [far, far]], [far, -far], [1 << 59, 1]));
        assert!(!distance2_at_least([[-far, -far], [far, far]], [0, 1], [1, 1]));
        assert!(distance2_at_least([[-far, -far], [far, far]], [0, 1], [1, 2]));
    }
}
