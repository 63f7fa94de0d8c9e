//! All numbers of limbs, with numbers that fill them, against the exact backend and polynomials in integers of any
//! size.

use predicament_exact::Exact;
use predicament_predicates::{Backend, Off, Predicates, Question};

use super::*;
use crate::constructed::rigid;

/// A small generator for reproducible samples (xorshift).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, bound: usize) -> usize {
        usize::try_from(self.next() >> 8).unwrap() % bound
    }

    /// A random integer below 2^bits in magnitude, mostly close to it; beyond 53 bits it ends in zeros.
    fn whole(&mut self, bits: u32) -> f64 {
        let digits = bits.min(53);
        let magnitude =
            2f64.powi((bits - digits).cast_signed()) * f64::from_bits(0x3ff0_0000_0000_0000 | self.next() >> 12);
        // A number from 1 to 2, cut off after this many digits.
        let magnitude = (magnitude * 2f64.powi(digits.cast_signed() - 1)).trunc();
        if self.below(2) == 0 { magnitude } else { -magnitude }
    }
}

/// The cases of a question by the limbs that it takes.
const COMPARE: [&str; 5] = ["one limb", "two limbs", "7 limbs", "14 limbs", "others"];

/// The number of questions for each number of limbs, and of ties broken there.
#[derive(Default, Debug)]
struct Seen([[usize; 2]; COMPARE.len()]);

impl Seen {
    fn check<const N: usize, const S: usize>(
        &mut self,
        session: &predicament_exact::Session<'_, Off>,
        (question, args): (Question, [Vertex; N]),
        limits: [u32; 2],
        decided: Decided,
    ) {
        let scene = session.scene();
        let second = scene.second_mesh().unwrap();
        let points = Named::new(scene, second, args).expect("flats of one mesh").points::<S>(scene);
        let tier = match (short(&points), long(&points)) {
            (Some((_, bits)), _) if bits <= limits[0] => 0,
            (Some((_, bits)), _) if bits <= limits[1] => 1,
            (Some(_), _) => 2,
            (None, Some(_)) => 3,
            (None, None) => 4,
        };
        assert_eq!(decided.is_some(), tier < 4);
        let Some(decided) = decided else {
            self.0[4][0] += 1;
            return;
        };
        let unmoved = question.ask(session, &args);
        let expected = if unmoved.is_zero() { rigid::decide(scene, question, &args) } else { Some((unmoved, 0)) };
        assert_eq!(decided, expected, "{question:?} of {args:?} by {} in {scene:?}", COMPARE[tier]);
        self.0[tier][usize::from(unmoved.is_zero() && decided.is_some())] += 1;
    }
}

/// Asks about all points of lines and planes of two times seven points.
fn ask_all(points: &[[f64; 3]; 14], [orders, turns]: [&mut Seen; 2]) {
    let scene = Scene::from_points3(points).unwrap().with_second_mesh((7..14).map(Vertex::input));
    let [a, b, c, d, e, f, g, s, t, u, v, w, x, y] = std::array::from_fn(Vertex::input);
    let mut session = Exact.prepare(&scene, Off).unwrap();
    let made: Vec<Vertex> = [
        Construction::Lpi { line: [a, b], plane: [s, t, u] },
        Construction::Lpi { line: [a, b], plane: [v, w, x] },
        Construction::Lpi { line: [s, t], plane: [c, d, e] },
        Construction::Lpi { line: [c, f], plane: [d, e, g] },
        Construction::Lpi { line: [w, y], plane: [s, v, x] },
    ]
    .into_iter()
    .filter_map(|of| session.construct(&[of]).ok())
    .flatten()
    .chain([a, s, y])
    .collect();
    let second = scene.second_mesh().unwrap();
    for (at, &p) in made.iter().enumerate() {
        for (next, &q) in made.iter().enumerate().skip(at + 1) {
            for axis in [Axis::X, Axis::Y, Axis::Z] {
                let decided = compare(session.scene(), second, axis, [p, q]);
                orders.check::<2, 11>(&session, (Question::Compare(axis), [p, q]), [7, 17], decided);
            }
            for &r in &made[next + 1..] {
                for plane in [Plane::Xy, Plane::Yz, Plane::Zx] {
                    let decided = orient2d(session.scene(), second, plane, [q, p, r]);
                    turns.check::<3, 16>(&session, (Question::Orient2d(plane), [q, p, r]), [4, 10], decided);
                }
            }
        }
    }
}

#[test]
fn long_coordinates_are_as_long_as_the_table_says() {
    let points = |largest: f64, unit: f64| [[unit, 0.0, 0.0], [0.0, -largest * unit, 0.0], [0.0; 3]];
    let below = 2f64.powi(124) - 2f64.powi(71);
    for unit in [1.0, f64::from_bits(1), 2f64.powi(500)] {
        let [u, v, origin] = long(&points(below, unit)).expect("124 bits");
        assert!(origin.iter().all(|x| x.is_zero()) && u[1].is_zero());
        assert_eq!((u[0].limbs(), v[1].is_negative()), (&[1, 0], true));
        assert!(long(&points(2f64.powi(124), unit)).is_none(), "125 bits, by {unit:e}");
    }
}

/// Without ties: with a limb too few the highest bits would be lost.
#[test]
fn numbers_that_fill_their_limbs() {
    let (mut random, mut orders, mut turns) = (Random(11), Seen::default(), Seen::default());
    for bits in (1_u32..22).chain(56..66).chain(118..136).chain([30_u32, 53, 90, 180]) {
        for round in 0..predicament_effort::scaled(60) {
            // Some as small as others are large; or as far apart as possible, and one in the middle.
            let largest = 2f64.powi(bits.cast_signed()) - 2f64.powi(bits.saturating_sub(53).cast_signed());
            let mut number = |place: usize| match (round % 2, place % 5) {
                (0, 0) => random.whole(bits.min(20)),
                (0, _) => random.whole(bits),
                (_, 0) => [1.0, -1.0][random.below(2)],
                _ => [largest, -largest][random.below(2)],
            };
            let mut points = std::array::from_fn(|i| [0, 1, 2].map(|axis| number(i + axis + round / 2)));
            if round % 2 == 1 {
                points[[0, 2, 7, 11][round / 2 % 4]] = [0.0; 3];
            }
            ask_all(&points, [&mut orders, &mut turns]);
        }
    }
    for seen in [orders, turns] {
        assert!(seen.0.iter().all(|[count, _]| *count > 100), "{seen:?}");
    }
}

/// Points of a small grid, with a separate unit for each axis: zero determinants stay zero.
#[test]
fn ties_in_any_number_of_limbs() {
    let (mut random, mut orders, mut turns) = (Random(12), Seen::default(), Seen::default());
    let tenths = 0.1;
    let units = [
        [1.0, 1.0, 1.0],
        [3.0, 7.0, 5.0],
        [21.0, 101.0, 1.0],
        [1001.0, 4099.0, 77.0],
        [tenths, 3.0 * tenths, 7.0 * tenths],
        [1.0, 2f64.powi(40) + 1.0, 2f64.powi(80)],
        [1e300, 1e300, 1e280],
        [5e-324, 2f64.powi(-1000), 3.0 * 5e-324],
        [1.0, 1e200, 1e-200],
    ];
    for unit in units {
        for round in 0..predicament_effort::scaled(150) {
            let side = [2, 3, 4][round % 3];
            let mut digit = || f64::from(u32::try_from(random.below(side)).unwrap());
            let points = std::array::from_fn(|_| unit.map(|unit| unit * digit()));
            ask_all(&points, [&mut orders, &mut turns]);
        }
    }
    for seen in [orders, turns] {
        assert!(seen.0[..4].iter().all(|[_, ties]| *ties > 30) && seen.0[4][0] > 30, "{seen:?}");
    }
}
