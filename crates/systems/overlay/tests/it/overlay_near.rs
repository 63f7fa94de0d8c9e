//! Tests of results whose vertices differ from their estimates in doubles: events between a vertex and its estimate.

use predicament_exact::Exact;
use predicament_overlay::algorithm::overlay::{Edge, Method, Operation, Polygon, Region, Rule, combine};
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};
use rug::Rational;

use crate::overlay::{Numbers, area};

/// Two nearly parallel rising lines that cross near (1/2, 0): right of the crossing the first is above the second.
struct Wedge {
    lines: [[[f64; 2]; 2]; 2],
}

impl Wedge {
    /// Random lines whose slopes differ by a power of two.
    fn random(numbers: &mut Numbers, difference: i32) -> Wedge {
        let mut part = || f64::from(numbers.below(1 << 20)) / f64::from(1 << 20);
        let slope = 0.5 + part() / 2.0;
        let line = |slope: f64, [before, after]: [f64; 2]| {
            let [before, after] = [0.5 + before, 0.5 + after];
            [[0.5 - before, -slope * before], [0.5 + after, slope * after]]
        };
        let ends = [[part(), part()], [part(), part()]];
        Wedge { lines: [line(slope, ends[0]), line(slope - 2.0_f64.powi(difference), ends[1])] }
    }

    /// The heights of both lines at an x.
    fn heights(&self, x: &Rational) -> [Rational; 2] {
        self.lines.map(|line| {
            let [[a, b], [c, d]] = line.map(|p| p.map(|x| Rational::from_f64(x).unwrap()));
            let along = Rational::from(x - &a) / Rational::from(&c - &a);
            Rational::from(&d - &b) * along + b
        })
    }

    /// The x where the lines cross.
    fn crossing(&self) -> Rational {
        let [left, right] = [0, 1].map(|x| {
            let [e, f] = self.heights(&Rational::from(x));
            e - f
        });
        let along = Rational::from(&left - &right);
        left / along
    }
}

/// A polygon whose corners are appended to a list of points.
fn polygon(points: &mut Vec<[f64; 2]>, corners: &[[f64; 2]]) -> Polygon {
    let first = points.len();
    points.extend(corners);
    let vertices: Vec<Vertex> = (first..points.len()).map(Vertex::input).collect();
    Polygon::of_vertices(&[vertices], Rule::EvenOdd)
}

#[test]
fn what_is_between_a_vertex_and_its_estimate_is_found() {
    let mut numbers = Numbers(17);
    let (mut slabs, mut notches, rounds) = (0, 0, predicament_effort::some_or_all(40, 160));
    for round in 0..rounds {
        // Estimates have errors of about 2^-45, or of a thousandth of the whole.
        let is_flat = round % 8 > 5;
        let difference = i32::try_from(numbers.below(6)).unwrap() + if is_flat { -44 } else { -14 };
        let wedge = Wedge::random(&mut numbers, difference);
        let [[e0, e1], [f0, f1]] = wedge.lines;
        let apex = wedge.crossing();
        // Mirrored, and with the axes exchanged.
        let turned = |p: [f64; 2]| {
            let [x, y] = if round % 2 == 0 { p } else { [-p[0], p[1]] };
            if round % 4 < 2 { [x, y] } else { [y, x] }
        };
        let mut points = Vec::new();
        let mut add = |corners: &[[f64; 2]]| {
            let corners: Vec<[f64; 2]> = corners.iter().map(|&p| turned(p)).collect();
            polygon(&mut points, &corners)
        };
        let below = add(&[e0, e1, [0.5, -9.0]]);
        let above = add(&[f0, f1, [0.5, 9.0]]);
        // From the vertex to both sides, farther and farther.
        let mut seconds = Vec::new();
        for shift in 0..12_i32 {
            for side in [-1.0, 1.0] {
                let x = apex.to_f64() + side * 2.0_f64.powi(if is_flat { 3 * shift - 40 } else { shift - 52 });
                seconds.push(add(&[[x, -8.0], [x + 0.0625, -8.0], [x + 0.0625, 8.0], [x, 8.0]]));
                slabs += 1;
                let exactly = Rational::from_f64(x).unwrap();
                let [e, f] = wedge.heights(&exactly);
                let middle = (Rational::from(&e + &f) / 2_u32).to_f64();
                if f < middle && middle < e {
                    seconds.push(add(&[[x, middle], [x + 0.25, -0.5], [x + 0.25, 1.0]]));
                    notches += 1;
                }
            }
        }
        let scene = Scene::from_points2(&points).unwrap();
        let mut session = Exact.prepare(&scene, Off).unwrap();
        let mut combined = |first: &[Region], second: &Polygon, operation: Operation| {
            let made = combine(&mut session, first, second, operation, Method::Grid).unwrap();
            assert_eq!(made.broken, None, "round {round}, {}", operation.name());
            let area = area(session.scene(), &Polygon::from(made.regions.as_slice()));
            (made.regions, area)
        };
        let (first, _) = combined(&[], &below, Operation::Union);
        let (wedge, whole) = combined(&first, &above, Operation::Intersection);
        let corners = |region: &Region| region.outer.iter().map(|edge: &Edge| edge.from).collect::<Vec<_>>();
        assert!(whole > 0 && wedge.len() == 1 && corners(&wedge[0]).iter().any(|v| v.is_constructed()));
        for (at, second) in seconds.iter().enumerate() {
            let [rest, common] =
                [Operation::Difference, Operation::Intersection].map(|operation| combined(&wedge, second, operation));
            assert!(rest.1 >= 0 && common.1 >= 0, "round {round}, {at}");
            assert_eq!(Rational::from(&rest.1 + &common.1), whole, "round {round}, {at}");
            let both = combined(&rest.0, second, Operation::Union).1;
            let second = combined(&[], second, Operation::Union).1;
            assert_eq!(both, second + &rest.1, "round {round}, {at}");
        }
    }
    assert!(slabs > 12 * rounds && notches > 4 * rounds, "{slabs} slabs, {notches} notches");
}
