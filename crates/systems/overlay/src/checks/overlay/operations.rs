//! Checks of the results of Boolean operations against their operands.

use std::cmp::Ordering;

use rug::Rational;

use super::plane::{Common, Neighbours, Point, area, common, is_on, winding};
use super::{Check, Expected, Flaw, Flaws, stride};
use predicament_judge::sum::sum;

/// The maximum number of edges of an operand whose area is computed strip by strip.
const MOST_STRIPPED: usize = 160;

/// Two operands: closed chains of points, and their rules for the inside.
pub struct Operands {
    /// The loops of each operand.
    pub loops: [Vec<Vec<Point>>; 2],
    /// For each operand, a function that is true for winding numbers of inner points.
    pub rules: [fn(i32) -> bool; 2],
}

/// The results of all four operations, as loops: for each region the outer loop and its holes.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Results {
    /// The regions of union, intersection, difference and symmetric difference.
    pub regions: [Vec<Vec<Vec<Point>>>; 4],
}

fn edges(points: &[Point]) -> impl Iterator<Item = [&Point; 2]> + Clone {
    points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| [a, b])
}

impl Operands {
    fn edges(&self, operand: usize) -> impl Iterator<Item = [&Point; 2]> + Clone {
        self.loops[operand].iter().flat_map(|one| edges(one))
    }

    /// Twice the sum of the areas of an operand's loops: counterclockwise loops count positive, the others negative.
    #[must_use]
    pub fn signed_area(&self, operand: usize) -> Rational {
        sum(self.loops[operand].iter().map(|one| area(edges(one))).collect())
    }

    /// Twice the area of an operand, computed strip by strip between the heights of all ends and crossings; `None` if
    /// it has too many edges.
    #[must_use]
    pub fn area(&self, operand: usize) -> Option<Rational> {
        let all: Vec<[&Point; 2]> = self.edges(operand).filter(|[a, b]| a[1] != b[1]).collect();
        if all.len() > MOST_STRIPPED {
            return None;
        }
        let x_at = |[a, b]: [&Point; 2], y: &Rational| {
            let part = Rational::from(y - &a[1]) / Rational::from(&b[1] - &a[1]);
            part * Rational::from(&b[0] - &a[0]) + &a[0]
        };
        let mut heights: Vec<Rational> = all.iter().flatten().map(|p| p[1].clone()).collect();
        let neighbours = Neighbours::new(all.clone());
        let crosses = |i: usize, j: usize| match &neighbours {
            Some(neighbours) => neighbours.common(i, j) == Common::Crossing,
            None => common(all[i], all[j]) == Common::Crossing,
        };
        let mut near = Vec::new();
        for (i, &e) in all.iter().enumerate() {
            match &neighbours {
                Some(neighbours) => neighbours.of(i, &mut near),
                None => near = (0..).take(i).collect(),
            }
            let before = near.iter().map(|&j| j as usize).filter(|&j| j < i && crosses(i, j));
            for f in before.map(|j| all[j]) {
                // The point of e at parameter `part` is on f's line.
                let [from, to] = [e[0], e[1]].map(|p| super::plane::turn(f[0], f[1], p));
                let part = &from / Rational::from(&from - &to);
                heights.push(part * Rational::from(&e[1][1] - &e[0][1]) + &e[0][1]);
            }
        }
        heights.sort();
        heights.dedup();
        let mut terms = Vec::new();
        for strip in heights.windows(2) {
            let middle = Rational::from(&strip[0] + &strip[1]) / 2;
            let crossing = all.iter().filter(|[a, b]| (a[1] < middle) != (b[1] < middle));
            let mut at: Vec<(Rational, i32)> =
                crossing.map(|&e| (x_at(e, &middle), if e[0][1] < e[1][1] { 1 } else { -1 })).collect();
            at.sort();
            let mut winding = 0;
            let height = Rational::from(&strip[1] - &strip[0]);
            for pair in at.windows(2) {
                // An ascending edge has on its right one more than on its left.
                winding -= pair[0].1;
                if (self.rules[operand])(winding) {
                    terms.push(Rational::from(&pair[1].0 - &pair[0].0) * &height * 2);
                }
            }
        }
        Some(sum(terms))
    }
}

impl Results {
    /// The laws that these results violate; `probes` are points to locate. `only` is
    /// [`Windings::only`](super::Windings::only) of each operand.
    #[must_use]
    pub fn flaws(
        &self,
        operands: &Operands,
        probes: &[Point],
        expected: Expected,
        only: [Option<i32>; 2],
    ) -> Vec<Flaw> {
        let mut flaws = Flaws::default();
        for (name, regions) in NAMES.iter().zip(&self.regions) {
            orientation(name, regions, expected, &mut flaws);
            crossings(name, regions, expected, &mut flaws);
        }
        self.areas(operands, only, &mut flaws);
        self.membership(operands, probes, expected, &mut flaws);
        flaws.0
    }

    fn areas(&self, operands: &Operands, only: [Option<i32>; 2], flaws: &mut Flaws) {
        let areas = self.regions.each_ref().map(|regions| area_of(regions));
        let [union, both, first, either] = &areas;
        for (name, area) in NAMES.iter().zip(&areas).filter(|(_, area)| area.cmp0().is_lt()) {
            flaws.add(Check::Orientation, || format!("the {name} has the area {:e}", area.to_f64() / 2.0));
        }
        let mut law = |holds: bool, what: &str| {
            if !holds {
                let told: Vec<String> = areas.iter().map(|area| format!("{:e}", area.to_f64() / 2.0)).collect();
                flaws.add(Check::Area, || format!("{what}; union, intersection, differences: {}", told.join(", ")));
            }
        };
        law(Rational::from(union - both) == *either, "|A or B| - |A and B| is not |A xor B|");
        if let (Some(a), Some(b)) = (operands.area(0), operands.area(1)) {
            law(Rational::from(union + both) == Rational::from(&a + &b), "|A or B| + |A and B| is not |A| + |B|");
            law(Rational::from(first + both) == a, "|A not B| is not |A| - |A and B|");
        }
        // If parts do not overlap, their areas add up to that of their union, however many there are.
        if let Some(winding) = only[0] {
            law(
                Rational::from(first + both) * winding == operands.signed_area(0),
                "the loops of A do not add up to |A|",
            );
        }
        if let Some(winding) = only[1] {
            let second = Rational::from(union - first);
            law(second * winding == operands.signed_area(1), "the loops of B do not add up to |B|");
        }
    }

    fn membership(&self, operands: &Operands, probes: &[Point], expected: Expected, flaws: &mut Flaws) {
        for p in probes.iter().step_by(stride(probes.len(), expected.located)) {
            let of = [0, 1].map(|operand| winding(operands.edges(operand), p));
            let [Some(a), Some(b)] = of else { continue };
            let [a, b] = [(operands.rules[0])(a), (operands.rules[1])(b)];
            let wanted = [a || b, a && b, a && !b, a != b];
            for (at, regions) in self.regions.iter().enumerate() {
                let found = winding(regions.iter().flatten().flat_map(|one| edges(one)), p);
                // Loops do not overlap: the winding number of a point is one or zero.
                if found != Some(i32::from(wanted[at])) {
                    let place = [&p[0], &p[1]].map(Rational::to_f64);
                    flaws.add(Check::Membership, || {
                        format!(
                            "the winding number of {place:?} is {found:?} in the {}, expected {}",
                            NAMES[at], wanted[at]
                        )
                    });
                }
            }
        }
    }
}

const NAMES: [&str; 4] = ["union", "intersection", "difference", "symmetric difference"];

fn area_of(regions: &[Vec<Vec<Point>>]) -> Rational {
    sum(regions.iter().flatten().map(|one| area(edges(one))).collect())
}

fn orientation(name: &str, regions: &[Vec<Vec<Point>>], expected: Expected, flaws: &mut Flaws) {
    for (at, region) in regions.iter().enumerate() {
        for (place, one) in region.iter().enumerate() {
            let wanted = if place == 0 { Ordering::Greater } else { Ordering::Less };
            let found = area(edges(one)).cmp0();
            // A loop that has area only in the perturbed scene has none here.
            if found != wanted && (expected.has_areas || found.is_ne()) {
                flaws.add(Check::Orientation, || format!("loop {place} of region {at} of the {name} is {found:?}"));
            }
            // A hole is inside its outer loop: the test uses one of its corners that is not on that loop.
            let inside = one.iter().take(8).find_map(|p| winding(edges(&region[0]), p));
            if place > 0 && expected.has_areas && inside == Some(0) {
                flaws.add(Check::Orientation, || {
                    format!("hole {place} of region {at} of the {name} is outside its region")
                });
            }
        }
    }
}

fn crossings(name: &str, regions: &[Vec<Vec<Point>>], expected: Expected, flaws: &mut Flaws) {
    let all: Vec<[&Point; 2]> = regions.iter().flatten().flat_map(|one| edges(one)).collect();
    let count = all.len();
    let Some(neighbours) = Neighbours::new(all.clone()) else { return };
    let mut near = Vec::new();
    for at in (0..count).step_by(stride(count, expected.edges_crossed)) {
        neighbours.of(at, &mut near);
        for other in near.iter().map(|&other| other as usize).filter(|&other| other != at) {
            // Regions may touch in points, not along edges.
            let overlaps = || {
                let are_of_one_line = (0..2).all(|end| neighbours.side(at, other, end).is_eq());
                are_of_one_line && overlap(all[at], all[other])
            };
            if neighbours.common(at, other) == Common::Crossing || expected.has_areas && overlaps() {
                flaws.add(Check::ResultCrossing, || format!("edges {at} and {other} of the {name} cross"));
            }
        }
    }
}

/// True if two segments whose second one is in the line of the first have more than a point in common.
fn overlap([a, b]: [&Point; 2], [c, d]: [&Point; 2]) -> bool {
    let [low, high] = if a < b { [a, b] } else { [b, a] };
    let [from, to] = if c < d { [c, d] } else { [d, c] };
    low.max(from) < high.min(to) && (is_on(a, b, c) || is_on(a, b, d) || is_on(c, d, a))
}
