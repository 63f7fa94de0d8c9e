//! Every exponent with every other, on grids from the least subnormal to 2^1023.
//!
//! Queries that differ by the order of their points or axes count as one here, and come in a random order. Signs and
//! significands are random too, but nothing else: each combination of exponents that a test names occurs at full
//! effort, and a random one in fifty by default. Each query goes through sessions, batches, raw predicates and each
//! rung that can run alone, against exact values.
//!
//! | predicate | combinations | ties, each with its neighbours at one ulp |
//! |---|---|---|
//! | compare | all exponents of doubles, two coordinates | the same |
//! | orient2d | 15 and zero, six coordinates | on lines y = c and y = 2^k x: 15 and zero |
//! | incircle | 8 and zero, eight coordinates | corners of boxes: 15 and zero; of trapezoids: 11 and zero |
//! | orient3d | 4 and zero, twelve coordinates; 9 of points plus 9 of axes | on planes z = 2^k x: 4 and zero |
//! | insphere | 2 and zero, fifteen coordinates; 9 of points plus 9 of axes | corners of boxes: 7 and zero; mirror images: 15 |
//!
//! All but compare have, at each of 15 places, all combinations of two to four exponents that are close.

mod exam;

use crate::common::Random;
use exam::{Exam, INCIRCLE, INSPHERE, ORIENT2D, ORIENT3D, Seen, double};
use predicament_exact::Exact;
use predicament_predicates::{Axis, Backend, Off, Predicates, Scene, Sign};

/// Exponents at the limits of doubles, of normal doubles, and of the filters of each predicate.
const GRID: [i32; 15] = [-1074, -1022, -850, -600, -484, -323, -242, -141, -53, 0, 53, 200, 340, 511, 1023];

/// Zero, and `count` exponents of [`GRID`].
fn grid(count: usize) -> Vec<Option<i32>> {
    let some = (0..count).map(|i| GRID[i * (GRID.len() - 1) / (count - 1)]);
    std::iter::once(None).chain(some.map(Some)).collect()
}

/// Calls f with every multiset of N of this many things.
fn multisets<const N: usize>(things: usize, mut f: impl FnMut([usize; N])) {
    let mut chosen = [0; N];
    loop {
        f(chosen);
        let Some(last) = chosen.iter().rposition(|&i| i + 1 < things) else { return };
        let next = chosen[last] + 1;
        chosen[last..].fill(next);
    }
}

/// Calls f with every assignment of one of this many things to each coordinate of N points.
///
/// Assignments that differ only by the order of points and axes count as one.
fn combinations<const D: usize, const N: usize>(things: usize, mut f: impl FnMut([[usize; D]; N])) {
    let points = things.pow(u32::try_from(D).expect("2 or 3"));
    // All but the first, which changes nothing.
    let others = &orders::<D>()[1..];
    multisets::<N>(points, |chosen| {
        let rows = chosen.map(|mut point| {
            std::array::from_fn(|_| {
                let digit = point % things;
                point /= things;
                digit
            })
        });
        let sorted = |order: &[usize; D]| {
            let mut rows = rows.map(|row: [usize; D]| order.map(|axis| row[axis]));
            rows.sort_unstable();
            rows
        };
        let mut own = rows;
        own.sort_unstable();
        if others.iter().all(|order| own <= sorted(order)) {
            f(rows);
        }
    });
}

/// All orders of D things.
fn orders<const D: usize>() -> Vec<[usize; D]> {
    let mut orders = vec![std::array::from_fn(|i| i)];
    for i in 1..D {
        for j in 0..i {
            for mut order in orders.clone() {
                order.swap(i, j);
                if !orders.contains(&order) {
                    orders.push(order);
                }
            }
        }
    }
    orders
}

/// All combinations of these exponents in all coordinates.
fn every_combination<const D: usize, const N: usize>(exam: &mut Exam<D, N>, grid: &[Option<i32>]) {
    combinations::<D, N>(grid.len(), |rows| {
        let points = rows.map(|row| row.map(|i| exam.double(grid[i])));
        exam.check(points);
    });
}

/// Tests all combinations of close exponents, at each place of [`GRID`], twelve times.
///
/// The rungs for few bits answer these.
fn every_narrow_combination<const D: usize, const N: usize>(exam: &mut Exam<D, N>, above: &[i32]) {
    for base in GRID.repeat(12) {
        let grid: Vec<_> = above.iter().map(|above| Some((base + above).min(1023))).collect();
        every_combination(exam, &grid);
    }
}

/// Tests all combinations of exponents of points and of axes, which are added for each coordinate.
fn every_point_and_axis<const D: usize, const N: usize>(exam: &mut Exam<D, N>, exponents: usize) {
    let grid: Vec<i32> = grid(exponents).into_iter().flatten().collect();
    multisets::<N>(grid.len(), |points| {
        multisets::<D>(grid.len(), |axes| {
            let points =
                points.map(|point| axes.map(|axis| exam.double(Some((grid[point] + grid[axis]).clamp(-1074, 1023)))));
            exam.check(points);
        });
    });
}

/// Checks that each sign occurred this often, and every rung, in proportion to the effort.
fn assert_all(seen: &Seen, signs: usize) {
    let [signs, each] = [signs, 500].map(|count| count / exam::one_in());
    assert!(seen.signs.iter().all(|&n| n > signs), "{seen:?}");
    assert!([seen.filtered, seen.double, seen.integer, seen.wide_integer].iter().all(|&n| n > each), "{seen:?}");
}

/// The product 2^k x, if that is a double.
fn times(x: f64, k: i32) -> Option<f64> {
    let half = |k: i32| 2f64.powi(k);
    let scaled = x * half(k / 2) * half(k - k / 2);
    let back = scaled * half(-k / 2) * half(k / 2 - k);
    (scaled.is_finite() && back == x).then_some(scaled)
}

#[test]
fn compare() {
    let mut random = Random(1);
    let values: Vec<f64> = (-1074..=1023)
        .flat_map(|exponent| [double(&mut random, Some(exponent), false), double(&mut random, Some(exponent), false)])
        .flat_map(|x| [x, x.next_up(), x.next_down()])
        .filter(|x| x.is_finite())
        .chain([0.0, -0.0])
        .collect();
    let points: Vec<[f64; 2]> = values.iter().map(|&x| [1.0, x]).collect();
    let scene = Scene::from_points2(&points).expect("finite");
    let session = Exact.prepare(&scene, Off).expect("any scene");
    // Sorted by bits as integers, which is the order of doubles of one sign.
    let key = |x: f64| if x < 0.0 { -(x.abs().to_bits().cast_signed()) } else { x.abs().to_bits().cast_signed() };
    let keys: Vec<i64> = values.iter().map(|&x| key(x)).collect();
    let vertices: Vec<_> = scene.vertices().collect();
    // Each with all others; by default every twentieth, with a changing offset.
    let step = predicament_effort::divisor();
    for (i, (&a, x)) in vertices.iter().zip(&keys).enumerate() {
        for (&b, y) in vertices.iter().zip(&keys).skip(i % step).step_by(step) {
            assert_eq!(session.compare(Axis::Y, a, b), Sign::from(x.cmp(y)), "{x:#x} {y:#x}");
        }
    }
}

#[test]
fn orient2d() {
    let mut exam = Exam::new(ORIENT2D, 2);
    every_combination(&mut exam, &grid(15));
    every_narrow_combination(&mut exam, &[0, 3, 24, 55]);
    let grid = grid(15);
    for &common in &grid {
        multisets::<3>(grid.len(), |chosen| {
            let xs = chosen.map(|i| exam.double(grid[i]));
            let level = exam.double(common);
            exam.check_around(xs.map(|x| [x, level]));
            let k = common.unwrap_or(1) / 2;
            if let [Some(p), Some(q), Some(r)] = xs.map(|x| times(x, k)) {
                exam.check_around([[xs[0], p], [xs[1], q], [xs[2], r]]);
            }
        });
    }
    assert_all(&exam.end(), 20_000);
}

#[test]
fn incircle() {
    let mut exam = Exam::new(INCIRCLE, 3);
    every_combination(&mut exam, &grid(8));
    every_narrow_combination(&mut exam, &[0, 3, 24]);
    let all = grid(15);
    multisets::<2>(all.len(), |[i, j]| {
        multisets::<2>(all.len(), |[k, l]| {
            let [x, p] = [i, j].map(|i| exam.double(all[i]));
            let [y, q] = [k, l].map(|i| exam.double(all[i]));
            exam.check_around([[x, y], [p, y], [p, q], [x, q]]);
        });
    });
    let some = grid(11);
    for &i in &some {
        for &j in &some {
            multisets::<2>(some.len(), |[k, l]| {
                let [x, y] = [i, j].map(|exponent| exam.double(exponent));
                let [p, q] = [k, l].map(|k| exam.double(some[k]));
                exam.check_around([[x, p], [-x, p], [y, q], [-y, q]]);
            });
        }
    }
    assert_all(&exam.end(), 20_000);
}

#[test]
fn orient3d() {
    let mut exam = Exam::new(ORIENT3D, 4);
    every_combination(&mut exam, &grid(predicament_effort::some_or_all(3, 4)));
    every_narrow_combination(&mut exam, &[0, 5]);
    every_point_and_axis(&mut exam, 9);
    let grid = grid(4);
    for k in [0, 1, -60, 400] {
        multisets::<4>(grid.len() * grid.len(), |chosen| {
            let points = chosen.map(|i| [i / grid.len(), i % grid.len()].map(|i| exam.double(grid[i])));
            let heights = points.map(|[x, _]| times(x, k));
            if let [Some(a), Some(b), Some(c), Some(d)] = heights {
                let heights = [a, b, c, d];
                exam.check_around(std::array::from_fn(|i| [points[i][0], points[i][1], heights[i]]));
            }
        });
    }
    assert_all(&exam.end(), 20_000);
}

#[test]
fn insphere() {
    let mut exam = Exam::new(INSPHERE, 5);
    every_combination(&mut exam, &grid(2));
    every_narrow_combination(&mut exam, &[0, 4]);
    every_point_and_axis(&mut exam, 9);
    let some = grid(7);
    let pairs = some.len() * (some.len() + 1) / 2;
    let mut sides = Vec::with_capacity(pairs);
    multisets::<2>(some.len(), |pair| sides.push(pair));
    // Four corners of a box determine its sphere if they are not in a plane.
    const CORNERS: [usize; 5] = [0b000, 0b001, 0b010, 0b100, 0b111];
    multisets::<3>(sides.len(), |chosen| {
        let axes = chosen.map(|i| sides[i].map(|i| exam.double(some[i])));
        exam.check_around(CORNERS.map(|corner| std::array::from_fn(|axis| axes[axis][corner >> axis & 1])));
    });
    for x in GRID {
        for y in GRID {
            for z in GRID {
                let point = [x, y, z].map(|exponent| exam.double(Some(exponent)));
                exam.check_around(CORNERS.map(|mirror| {
                    std::array::from_fn(|axis| if mirror >> axis & 1 == 1 { -point[axis] } else { point[axis] })
                }));
            }
        }
    }
    assert_all(&exam.end(), 10_000);
}
