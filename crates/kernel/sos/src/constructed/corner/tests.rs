//! Turns of points at input vertices, against polynomials in integers of any size.

use predicament_exact::Exact;
use predicament_predicates::Backend;

use super::*;
use crate::constructed::rigid;
use crate::constructed::testing::Random;
use predicament_predicates::Question;

/// A double from −1 to 1, or a small integer.
#[allow(clippy::cast_precision_loss)] // the number has 53 bits
fn coordinate(random: &mut Random, grid: bool) -> f64 {
    let number = random.below(1 << 53) as f64 * 2f64.powi(-52) - 1.0;
    if grid { (number * 2.0).round() } else { number }
}

/// The number of turns by the power that decides, and of those that are left to integers.
#[derive(Default, Debug)]
struct Seen {
    powers: [usize; 7],
    left: usize,
}

/// Two meshes of the same six points, with points of lines of one mesh and planes of the other that share a corner.
fn ask_all(points: &[[f64; 3]; 6], random: &mut Random, seen: &mut Seen) {
    let both = [&points[..], &points[..]].concat();
    let scene = Scene::from_points3(&both).unwrap().with_second_mesh((6..12).map(Vertex::input));
    let mut session = Exact.prepare(&scene, Off).unwrap();
    let mut made: Vec<Vertex> = [1, 4, 6, 9].map(Vertex::input).to_vec();
    for _ in 0..8 {
        let mut order: [usize; 6] = std::array::from_fn(|at| at);
        (1..6).for_each(|at| order.swap(at, random.below(at + 1)));
        let [first, second] = [[6, 0], [0, 6], [0, 6], [6, 6]][random.below(4)];
        let mut line = [order[0], order[1]].map(|at| Vertex::input(at + first));
        let mut plane = [order[0], order[2], order[3]].map(|at| Vertex::input(at + second));
        line.rotate_left(random.below(2));
        plane.rotate_left(random.below(3));
        made.extend(session.construct(&[Construction::Lpi { line, plane }]).into_iter().flatten());
    }
    let moves = scene.second_mesh().unwrap();
    for _ in 0..20 {
        let mut left = made.clone();
        let args: [Vertex; 3] = std::array::from_fn(|_| left.swap_remove(random.below(left.len())));
        let plane = [Plane::Xy, Plane::Yz, Plane::Zx][random.below(3)];
        let Some((sign, power)) = orient2d(&session, moves, plane, args) else {
            seen.left += 1;
            continue;
        };
        let scene = session.scene();
        let unmoved = session.orient2d(plane, args[0], args[1], args[2]);
        let expected =
            if unmoved.is_zero() { rigid::decide(scene, Question::Orient2d(plane), &args) } else { Some((unmoved, 0)) };
        assert_eq!(Some((sign, power)), expected, "{args:?} of {scene:?}");
        seen.powers[power] += 1;
    }
}

#[test]
fn turns_are_those_of_polynomials() {
    let mut random = Random(31);
    let mut seen = [Seen::default(), Seen::default()];
    for round in 0..predicament_effort::scaled(4000) {
        let is_grid = round % 4 == 0;
        // Nearly flat scenes and far scales too: terms cancel there, and underflow.
        let scale = [1.0, 1.0, 2f64.powi(-60), 2f64.powi(-200), 2f64.powi(300)][round / 4 % 5];
        let thin = [1.0, 1.0, 2f64.powi(-30), 2f64.powi(-52)][round / 20 % 4];
        let points = std::array::from_fn(|_| {
            let [x, y, z] = std::array::from_fn(|_| coordinate(&mut random, is_grid));
            [x * scale, y * scale, (if is_grid { z } else { x + y + z * thin }) * scale]
        });
        ask_all(&points, &mut random, &mut seen[usize::from(is_grid)]);
    }
    for Seen { powers, left } in &seen {
        assert!(powers[..3].iter().chain([left]).all(|count| *count > 30), "{seen:?}");
    }
    assert!(seen[1].powers[3] > 5, "{seen:?}");
}

/// Sums of terms that cancel: the real number is zero, and the double nearly always is not.
#[test]
fn what_cancels_is_not_certain() {
    let mut random = Random(32);
    let mut computed = 0;
    for _ in 0..1000 {
        let [a, b, c] = std::array::from_fn(|_| Near::exact(coordinate(&mut random, false)));
        let zero = a.plus(b).times(c).minus(a.times(c)).minus(b.times(c));
        assert_eq!(zero.sign(), None, "{a:?} {b:?} {c:?}");
        let one = a.times(a.inverse().unwrap()).minus(Near::exact(1.0));
        assert_eq!(one.sign(), None, "{a:?}");
        computed += usize::from(zero.value != 0.0) + usize::from(one.value != 0.0);
    }
    assert!(computed > 300, "{computed}");
}

/// Beyond the range of doubles nothing is certain.
#[test]
fn numbers_at_the_ends_of_the_range_have_no_sign() {
    let [tiny, huge] = [1e-200, 1e200].map(Near::exact);
    assert_eq!([tiny.times(tiny).sign(), huge.times(huge).sign()], [None, None]);
    assert_eq!(huge.times(huge).minus(huge.times(huge)).sign(), None);
    assert!([f64::from_bits(1), 1e-290, 1e290].map(Near::exact).into_iter().all(|x| x.inverse().is_none()));
    assert_eq!(tiny.times(huge).sign(), Some(Sign::Positive));
}
