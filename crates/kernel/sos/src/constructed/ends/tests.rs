//! Ties of points with degenerate ends, against the search through all monomials.

use predicament_exact::Exact;
use predicament_predicates::{Backend, Dimension, Off, Plane};

use super::*;
use crate::constructed::testing::{Random, constructions, search_all};

/// The number of ties by result: identities, the deciding degree, and ties that remain open.
type Counts = [usize; 5];

fn check<const N: usize>(scene: &Scene, rows: &Rows, question: Question, args: [Vertex; N], counts: &mut Counts) {
    let known = match decide(scene, rows, question, args) {
        Known::Broken(sign, degree) => Some((sign, degree)),
        Known::Identity => None,
        Known::Open => {
            counts[4] += 1;
            return;
        }
    };
    counts[known.map_or(0, |(_, degree)| degree)] += 1;
    assert_eq!(known, search_all(scene, question, &args), "{question:?} of {args:?} in {scene:?}");
}

/// Asks about ties of any vertices.
fn ask(random: &mut Random, scene: &Scene, counts: &mut [Counts; 3]) {
    let (exact, rows) = (Exact.prepare(scene, Off).unwrap(), Rows::new(scene));
    let mut all: Vec<Vertex> = scene.vertices().collect();
    all.extend((0..scene.constructions().len()).flat_map(|at| [Vertex::constructed(at); 3]));
    for _ in 0..20 {
        let [a, b, c, d] = std::array::from_fn(|_| all[random.below(all.len())]);
        if [a, b, c, d].iter().all(|v| !v.is_constructed()) || [b, c, d].contains(&a) || [c, d].contains(&b) || c == d {
            continue;
        }
        let (axes, planes) = if scene.dimension() == Dimension::Two { (2, 1) } else { (3, 3) };
        let axis = [Axis::X, Axis::Y, Axis::Z][random.below(axes)];
        let plane = [Plane::Xy, Plane::Yz, Plane::Zx][random.below(planes)];
        use predicament_predicates::Predicates;
        match random.below(axes) {
            0 if exact.compare(axis, a, b).is_zero() => {
                check(scene, &rows, Question::Compare(axis), [a, b], &mut counts[0]);
            }
            1 if exact.orient2d(plane, a, b, c).is_zero() => {
                check(scene, &rows, Question::Orient2d(plane), [a, b, c], &mut counts[1]);
            }
            2 if exact.orient3d(a, b, c, d).is_zero() => {
                check(scene, &rows, Question::Orient3d, [a, b, c, d], &mut counts[2]);
            }
            _ => {}
        }
    }
}

/// Points of a small grid, most of them on one face or one line along the axes, shared by lines and planes.
#[test]
fn ends_decide_as_the_search() {
    let (mut random, mut counts) = (Random(91), [[0; 5]; 3]);
    for round in 0..predicament_effort::scaled(1200) {
        let dimension = if round % 4 == 0 { Dimension::Two } else { Dimension::Three };
        let unit = [1.0, 0.1, 3e-320, 2f64.powi(900)][round / 4 % 4];
        let points = [6, 8, 11][round / 16 % 3];
        let axes = dimension.count();
        let mut coordinates: Vec<f64> =
            (0..points * axes).map(|_| f64::from(u32::try_from(random.below(4)).unwrap()) * unit).collect();
        let fixed = random.below(axes);
        for point in coordinates.chunks_mut(axes) {
            if random.below(5) > 0 {
                point[fixed] = unit;
            }
            if round % 3 == 0 && random.below(3) > 0 {
                point[(fixed + 1) % axes] = 2.0 * unit;
            }
        }
        let mut scene = Scene::new(dimension, coordinates).unwrap();
        constructions(&mut random, &mut scene, 9);
        ask(&mut random, &scene, &mut counts);
    }
    let some = predicament_effort::scaled(60);
    let degrees = counts.iter().zip([2, 3, 3]);
    let decided = degrees.flat_map(|(counts, end)| &counts[1..end]).all(|count| *count > some);
    assert!(decided && counts.iter().all(|counts| counts[0] > some), "{counts:?}");
}

#[test]
fn monomials_are_in_their_order_with_their_minors() {
    for (rows, count) in [(2, 3), (3, 13), (4, 73)] {
        let all = monomials(rows);
        assert_eq!(all.len(), count);
        assert!(all.is_sorted_by(|a, b| a.bits < b.bits));
        for monomial in all {
            let degree = monomial.bits.count_ones();
            assert_eq!(monomial.rows.count_ones() + degree, u32::try_from(rows).unwrap(), "{:b}", monomial.bits);
            assert_eq!(monomial.columns.count_ones() + degree + 1, u32::try_from(rows).unwrap(), "{:b}", monomial.bits);
        }
    }
}
