//! Volumes in rationals.

use rug::Rational;

type Point = [f64; 3];

fn exact(x: f64) -> Rational {
    Rational::from_f64(x).expect("coordinates are finite")
}

/// The volume enclosed by triangles that are all wound the same way, by the divergence theorem.
pub(super) fn enclosed(triangles: &[[Point; 3]]) -> Rational {
    let six: Rational = triangles
        .iter()
        .map(|corners| {
            let [a, b, c] = corners.map(|corner| corner.map(exact));
            let minor = |i: usize, j: usize| Rational::from(&b[i] * &c[j]) - Rational::from(&b[j] * &c[i]);
            Rational::from(&a[0] * &minor(1, 2))
                + Rational::from(&a[1] * &minor(2, 0))
                + Rational::from(&a[2] * &minor(0, 1))
        })
        .sum();
    six.abs() / 6
}

/// The volume below a sheet over the square [0, n]², above its plane z = 0.
pub(super) fn below(triangles: &[[Point; 3]], cubes: u32) -> Rational {
    let mut volume = Rational::new();
    for corners in triangles {
        let mut polygon: Vec<[Rational; 3]> = corners.iter().map(|corner| corner.map(exact)).collect();
        for axis in 0..2 {
            for (bound, upper) in [(0, false), (cubes, true)] {
                polygon = clipped(&polygon, axis, &Rational::from(bound), upper);
            }
        }
        let Some((first, rest)) = polygon.split_first() else { continue };
        for pair in rest.windows(2) {
            let [p, q] = [&pair[0], &pair[1]].map(|end| [0, 1].map(|axis| Rational::from(&end[axis] - &first[axis])));
            let twice = (Rational::from(&p[0] * &q[1]) - Rational::from(&p[1] * &q[0])).abs();
            let heights = Rational::from(&first[2] + &pair[0][2]) + &pair[1][2];
            volume += twice * heights / 6;
        }
    }
    volume
}

/// The part of a convex polygon on one side of a plane across an axis.
fn clipped(polygon: &[[Rational; 3]], axis: usize, bound: &Rational, upper: bool) -> Vec<[Rational; 3]> {
    let within = |point: &[Rational; 3]| if upper { point[axis] <= *bound } else { point[axis] >= *bound };
    let mut kept = Vec::new();
    for (at, to) in polygon.iter().enumerate() {
        let from = &polygon[(at + polygon.len() - 1) % polygon.len()];
        if within(from) != within(to) {
            let share = Rational::from(bound - &from[axis]) / Rational::from(&to[axis] - &from[axis]);
            kept.push([0, 1, 2].map(|axis| Rational::from(&to[axis] - &from[axis]) * &share + &from[axis]));
        }
        if within(to) {
            kept.push(to.clone());
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn volumes_of_known_bodies() {
        let [o, x, y, z] = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 5.0]];
        assert_eq!(enclosed(&[[o, y, x], [o, x, z], [o, z, y], [x, y, z]]), 10);
        let [a, b, c, d] = [[-1.0, -1.0, 1.0], [5.0, -1.0, 1.0], [5.0, 5.0, 1.0], [-1.0, 5.0, 1.0]];
        assert_eq!(below(&[[a, b, c], [a, c, d]], 2), 4);
        let slope = |[x, y, _]: Point| [x, y, x + y];
        assert_eq!(below(&[[a, b, c].map(slope), [a, c, d].map(slope)], 2), 8);
    }
}
