//! Defects of the loops of regions, decided in rationals.

use std::cmp::Ordering;

use rug::Rational;

use super::plane::{Common, Neighbours, Point, area, winding};
use predicament_judge::sum::sum;

/// Regions as loops: the outer one, then the holes.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Shape {
    /// For each region its loops as corners, the outer one first.
    pub regions: Vec<Vec<Vec<Point>>>,
}

/// Counts of loops and pairs of edges that no result should have.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Defects {
    /// Pairs of edges whose inner points cross.
    pub crossings: usize,
    /// Pairs of edges that touch or overlap, except in a point that is an end of both.
    pub touches: usize,
    /// Loops with the wrong orientation: clockwise outer loops, or counterclockwise holes.
    pub inverted: usize,
    /// Loops without area.
    pub flat: usize,
}

impl Shape {
    fn loops(&self) -> impl Iterator<Item = (usize, &Vec<Point>)> + Clone {
        self.regions.iter().flat_map(|region| region.iter().enumerate())
    }

    /// The edges of all loops.
    pub fn edges(&self) -> impl Iterator<Item = [&Point; 2]> + Clone {
        self.loops().flat_map(|(_, one)| one.iter().zip(one.iter().cycle().skip(1)).map(|(a, b)| [a, b]))
    }

    /// Twice the area: that of outer loops less that of holes, if no loop is inverted.
    #[must_use]
    pub fn area(&self) -> Rational {
        sum(self
            .loops()
            .map(|(_, one)| area(one.iter().zip(one.iter().cycle().skip(1)).map(|(a, b)| [a, b])))
            .collect())
    }

    /// The winding number of the loops around a point; `None` for a point on an edge.
    #[must_use]
    pub fn winding(&self, p: &Point) -> Option<i32> {
        winding(self.edges(), p)
    }

    /// The numbers of wrong loops and pairs of edges; every pair of edges near each other is tested.
    #[must_use]
    pub fn defects(&self) -> Defects {
        let mut defects = Defects::default();
        for (place, one) in self.loops() {
            let wanted = if place == 0 { Ordering::Greater } else { Ordering::Less };
            match area(one.iter().zip(one.iter().cycle().skip(1)).map(|(a, b)| [a, b])).cmp0() {
                Ordering::Equal => defects.flat += 1,
                found if found != wanted => defects.inverted += 1,
                _ => {}
            }
        }
        let all: Vec<[&Point; 2]> = self.edges().collect();
        let count = all.len();
        let Some(neighbours) = Neighbours::new(all) else { return defects };
        let mut near = Vec::new();
        for at in 0..count {
            neighbours.of(at, &mut near);
            for other in near.iter().map(|&other| other as usize).filter(|&other| other < at) {
                match neighbours.common(at, other) {
                    Common::Nothing => {}
                    Common::Crossing => defects.crossings += 1,
                    Common::Touch => defects.touches += 1,
                }
            }
        }
        defects
    }
}

/// The winding number of closed chains of points around a point; `None` for a point on an edge.
#[must_use]
pub fn winding_of(loops: &[Vec<Point>], p: &Point) -> Option<i32> {
    winding(loops.iter().flat_map(|one| one.iter().zip(one.iter().cycle().skip(1)).map(|(a, b)| [a, b])), p)
}
