//! Ties between two crossings on one segment, in closed form.
//!
//! To sort crossings along a segment is the most frequent question about constructed vertices, and where many segments
//! pass through one point, nearly all such questions are ties. The determinant of the question has factors that do not
//! matter. Let u be the crossing of the segment a, b with the line c, d, and v that with e, f. Let n and m be the turns
//! of a and b around c, d, and n' and m' those around e, f. Then u = a + λ(b − a) with λ = n/(n − m), and likewise v:
//!
//! u − v = (b − a) · (n'm − nm') / ((n − m)(n' − m'))
//!
//! The six vertices are distinct, so n' and m have no coordinate in common, nor have n and m'. Turns are linear in each
//! coordinate. So no infinitesimal has a square in P = n'm − nm', and a monomial is a set of infinitesimals: a mask, in
//! which a larger infinitesimal has a lower bit. Of two monomials, the one with the lower degree in the smallest
//! infinitesimal in which they differ is larger. That is the lower mask: masks are tried from zero on, and the first
//! one whose coefficient is not zero decides. A coefficient is n'[p]m[q] − n[r]m'[s], with the parts of the mask that
//! belong to the vertices of each turn.

use predicament_predicates::{Axis, Construction, Scene, Sign, Vertex};

use crate::whole::significand;

/// The maximum magnitude of a coordinate, as a power of two: a turn is below 3 · 2^60 and a coefficient below 2^125.
const BITS: u32 = 29;

type Point = [i64; 2];

/// The order of two crossings along an axis and the degree of the deciding monomial, if they tie.
///
/// `None` if they are not crossings of one segment with lines of other vertices in the plane, if a line is parallel to
/// the segment, or if the coordinates are not small integers in a common unit.
pub(super) fn decide(scene: &Scene, axis: Axis, [u, v]: [Vertex; 2]) -> Option<(Sign, usize)> {
    let crossing = |v: Vertex| match scene.constructions()[v.construction()?].canonical() {
        Construction::Ssi(lines) => Some(lines),
        _ => None,
    };
    let [first, second] = [crossing(u)?, crossing(v)?];
    let at = first.iter().position(|line| second.contains(line))?;
    let [segment, line] = [first[at], first[1 - at]];
    let other = second[usize::from(second[0] == segment)];
    let vertices = [segment[0], segment[1], line[0], line[1], other[0], other[1]];
    let (points, ranks) = (integers(scene, &vertices)?, ranks(&vertices)?);
    let [n, m, n2, m2] = [[2, 3, 0], [2, 3, 1], [4, 5, 0], [4, 5, 1]]
        .map(|of: [usize; 3]| Turn { points: of.map(|at| points[at]), shifts: of.map(|at| 2 * ranks[at]) });
    let weight = |n: &Turn, m: &Turn| Sign::from(n.coefficient(0).cmp(&m.coefficient(0)));
    let weights = weight(&n, &m) * weight(&n2, &m2);
    if weights.is_zero() {
        return None;
    }
    let [a, b] = [0, 1].map(|at: usize| (points[at][axis.index()], ranks[at]));
    // Both move forward, the vertex with the lower rank further.
    let (along, degree) = match b.0.cmp(&a.0) {
        std::cmp::Ordering::Equal => (Sign::from(a.1.cmp(&b.1)), 1),
        order => (Sign::from(order), 0),
    };
    (0..1_u32 << (2 * vertices.len())).find_map(|mask| {
        let product = |n: &Turn, m: &Turn| i128::from(n.coefficient(mask)) * i128::from(m.coefficient(mask));
        let sign = Sign::from(product(&n2, &m).cmp(&product(&n, &m2)));
        (!sign.is_zero()).then(|| (sign * along * weights, degree + mask.count_ones() as usize))
    })
}

/// The turn of three points as a polynomial in the infinitesimals of their coordinates.
struct Turn {
    points: [Point; 3],
    /// The place of the bit of each point's x in a mask; that of its y is next.
    shifts: [u32; 3],
}

impl Turn {
    /// The coefficient of a monomial; bits of other points are ignored.
    ///
    /// The turn is Σ xᵢ(yᵢ₊₁ − yᵢ₊₂), with indices modulo three.
    fn coefficient(&self, mask: u32) -> i64 {
        let point = |at: usize| self.points[at % 3];
        let [p, q, r] = self.shifts.map(|shift| mask >> shift & 3);
        let first = |axis: u32, at: usize| match axis {
            1 => point(at + 1)[1] - point(at + 2)[1],
            2 => point(at + 2)[0] - point(at + 1)[0],
            _ => 0,
        };
        let second = |one: u32, next: u32| match (one, next) {
            (1, 2) => 1,
            (2, 1) => -1,
            _ => 0,
        };
        match (p, q, r) {
            (0, 0, 0) => (0..3).map(|at| point(at)[0] * (point(at + 1)[1] - point(at + 2)[1])).sum(),
            (p, 0, 0) => first(p, 0),
            (0, q, 0) => first(q, 1),
            (0, 0, r) => first(r, 2),
            (p, q, 0) => second(p, q),
            (0, q, r) => second(q, r),
            (p, 0, r) => second(r, p),
            _ => 0,
        }
    }
}

/// The coordinates in a common unit; `None` if they are too large in it.
fn integers(scene: &Scene, vertices: &[Vertex; 6]) -> Option<[Point; 6]> {
    let mut parts = [[(0, 0); 2]; 6];
    let mut unit = i32::MAX;
    for (part, &v) in parts.iter_mut().zip(vertices) {
        *part = <[f64; 2]>::try_from(scene.point(v)).ok()?.map(significand);
        unit = part.iter().filter(|(m, _)| *m != 0).fold(unit, |unit, (_, exponent)| unit.min(*exponent));
    }
    let mut points = [[0; 2]; 6];
    for (x, (m, exponent)) in points.as_flattened_mut().iter_mut().zip(parts.as_flattened()) {
        let (m, raised): (i64, i32) = (*m, if *m == 0 { 0 } else { exponent - unit });
        let bits = (u64::BITS - m.unsigned_abs().leading_zeros()).checked_add(raised.unsigned_abs())?;
        if bits > BITS {
            return None;
        }
        *x = m << raised;
    }
    Some(points)
}

/// The places of vertices in ascending order; `None` if one occurs twice.
fn ranks(vertices: &[Vertex; 6]) -> Option<[u32; 6]> {
    let mut ranks = [0; 6];
    for (at, &v) in vertices.iter().enumerate() {
        for (other, &w) in vertices[..at].iter().enumerate() {
            match w.cmp(&v) {
                std::cmp::Ordering::Less => ranks[at] += 1,
                std::cmp::Ordering::Greater => ranks[other] += 1,
                std::cmp::Ordering::Equal => return None,
            }
        }
    }
    Some(ranks)
}

#[cfg(test)]
mod tests {
    use predicament_exact::Exact;
    use predicament_predicates::{Backend, Off, Predicates, Question};

    use super::super::testing::{Random, search_all};
    use super::*;

    /// Four segments through one or two points: most crossings on a segment tie.
    fn segments(random: &mut Random, unit: f64) -> Vec<[f64; 2]> {
        let whole = |n: usize| f64::from(i32::try_from(n).unwrap());
        let mut points = Vec::new();
        while points.len() < 8 {
            let way = [0, 1].map(|_: usize| whole(random.below(7)) - 3.0);
            let (back, on) = (whole(random.below(3) + 1), whole(random.below(3) + 1));
            let through = [whole(random.below(2)), 0.0];
            if way != [0.0; 2] {
                points.push([0, 1].map(|i: usize| unit * (through[i] - back * way[i])));
                points.push([0, 1].map(|i: usize| unit * (through[i] + on * way[i])));
            }
        }
        points
    }

    #[test]
    fn crossings_on_one_segment_have_the_order_of_the_search() {
        let (mut random, mut seen) = (Random(31), [0; 5]);
        for round in 0..200 {
            let points = segments(&mut random, [1.0, 0.375, 1e-30, 1e20][round % 4]);
            let ids: [Vertex; 8] = random.different(8);
            let mut placed = points.clone();
            ids.iter().zip(&points).for_each(|(id, point)| placed[id.index()] = *point);
            let mut scene = Scene::from_points2(&placed).unwrap();
            let line = |at: usize| [ids[2 * at], ids[2 * at + 1]];
            let definitions: Vec<Construction> = {
                let mut session = Exact.prepare(&scene, Off).unwrap();
                let pairs = (0..4).flat_map(|i| (0..4).filter(move |j| i != *j).map(move |j| [i, j]));
                let all = pairs.map(|pair| Construction::Ssi(pair.map(line)));
                all.filter(|one| session.construct(&[*one]).is_ok()).collect()
            };
            let all: Vec<Vertex> = definitions.into_iter().map(|one| scene.construct(one).unwrap()).collect();
            let exact = Exact.prepare(&scene, Off).unwrap();
            for (&u, &v) in all.iter().flat_map(|u| all.iter().map(move |v| (u, v))).filter(|(u, v)| u != v) {
                for axis in [Axis::X, Axis::Y].into_iter().filter(|&axis| exact.compare(axis, u, v).is_zero()) {
                    let found = decide(&scene, axis, [u, v]);
                    seen[found.map_or(0, |(_, degree)| degree.min(4))] += 1;
                    if found.is_some() {
                        let wanted = search_all(&scene, Question::Compare(axis), &[u, v]);
                        assert_eq!(found, wanted, "{axis:?} of {u}, {v} in {scene:?}");
                    }
                }
            }
        }
        // Open (two crossings that are not on one segment), then by degree.
        assert!(seen[0] > 100 && seen[1] > 1000 && seen[2] > 100, "{seen:?}");
    }

    #[test]
    fn large_coordinates_are_left_open() {
        let points = |far: f64| [[-1.0, 0.0], [far, 0.0], [0.0, -1.0], [0.0, 1.0], [1.0, 1.0], [-1.0, -1.0]];
        for (far, is_decided) in [(5.0, true), (536_870_911.0, true), (536_870_912.0, false)] {
            let mut scene = Scene::from_points2(&points(far)).unwrap();
            let line = |at: usize| [Vertex::input(at), Vertex::input(at + 1)];
            let [u, v] = [2, 4].map(|at| scene.construct(Construction::Ssi([line(0), line(at)])).unwrap());
            let found = decide(&scene, Axis::X, [u, v]);
            assert_eq!(found.is_some(), is_decided, "{far}");
            assert!(found.is_none() || found == search_all(&scene, Question::Compare(Axis::X), &[u, v]));
        }
    }
}
