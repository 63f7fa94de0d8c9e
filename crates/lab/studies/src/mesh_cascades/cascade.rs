//! The cascades: an initial mesh, and the operation of each step.
//!
//! They use only the four operations and square roots, which are the same everywhere.

use std::collections::BTreeSet;

use predicament_corpus::Random;
use predicament_formats::bits::{integer, step};
use predicament_mesh_intersect::algorithm::cascade::Closed;
use predicament_overlay::algorithm::overlay::Operation;

use crate::solids::{boxed, sphere};

/// A step: an operation and its second operand.
#[derive(Clone, PartialEq, Debug)]
pub struct Operand {
    /// The operation; the first operand is the result so far.
    pub operation: Operation,
    /// The second operand.
    pub mesh: Closed,
    /// The operand's cell of a lattice, if it is one.
    pub cell: Option<[i64; 3]>,
}

/// A sequence of Boolean operations.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, clap::ValueEnum)]
pub enum Cascade {
    /// The cubes of a lattice united one by one, row by row, then subtracted in the same order
    Cubes,
    /// The cubes of a lattice united and subtracted in random orders
    Shuffled,
    /// A sphere cut by half-spaces; every fourth is an earlier one moved by an ulp
    Shave,
    /// A sphere united with copies of itself: moved by half of it, by an ulp, by 2^-30, not at all
    Copies,
}

impl Cascade {
    /// All cascades.
    pub const ALL: [Cascade; 4] = [Cascade::Cubes, Cascade::Shuffled, Cascade::Shave, Cascade::Copies];

    /// The cascade's name in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Cascade::Cubes => "cubes",
            Cascade::Shuffled => "shuffled",
            Cascade::Shave => "shave",
            Cascade::Copies => "copies",
        }
    }

    /// The initial mesh, and the operation and second operand of each of `count` steps.
    #[must_use]
    pub fn steps(self, count: usize, seed: u64) -> (Operand, Vec<Operand>) {
        let mut random = Random::new(self.name(), "mesh-cascades", seed);
        match self {
            Cascade::Cubes => cubes(count, None),
            Cascade::Shuffled => cubes(count, Some(&mut random)),
            Cascade::Shave => shave(count),
            Cascade::Copies => copies(count),
        }
    }
}

fn small(n: usize) -> f64 {
    integer(whole(n))
}

fn whole(n: usize) -> i64 {
    i64::try_from(n).expect("few steps")
}

fn cube(operation: Operation, cell: [i64; 3]) -> Operand {
    let corner = |at: usize| [0, 1, 2].map(|axis: usize| integer(cell[axis] + whole(at >> axis & 1)));
    Operand { operation, mesh: boxed([0, 1, 2, 3, 4, 5, 6, 7].map(corner)), cell: Some(cell) }
}

/// As many cubes as half of the steps plus one: all united, then all subtracted.
fn cubes(count: usize, random: Option<&mut Random>) -> (Operand, Vec<Operand>) {
    let cubes = count / 2 + 1;
    let side = (1..).find(|side: &usize| side.pow(3) >= cubes).expect("a lattice that is large enough");
    let cell = |at: usize| [at / side / side, at / side % side, at % side].map(whole);
    let mut up: Vec<[i64; 3]> = (0..cubes).map(cell).collect();
    let mut down = up.clone();
    if let Some(random) = random {
        for order in [&mut up, &mut down] {
            for at in (1..order.len()).rev() {
                let other = usize::try_from(random.integer(0, whole(at))).expect("not negative");
                order.swap(at, other);
            }
        }
    }
    let up: Vec<Operand> = up.into_iter().map(|cell| cube(Operation::Union, cell)).collect();
    let down = down.into_iter().map(|cell| cube(Operation::Difference, cell));
    let mut all = up.into_iter().chain(down).take(count + 1);
    let start = all.next().expect("there is a first cube");
    (start, all.collect())
}

/// A point of the golden spiral on the sphere: any two are distinct.
fn direction(at: usize, count: usize) -> [f64; 3] {
    let z = 1.0 - (2.0 * small(at) + 1.0) / small(count);
    let part = small(at) * 0.618_033_988_749_894_9 % 1.0;
    // Twice the angle whose tangent is t, in two half turns.
    let t = 2.0 * (part * 2.0 % 1.0) - 1.0;
    let [c, s] = [(1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t)];
    let turned = if part < 0.5 { 1.0 } else { -1.0 };
    let flat = (1.0 - z * z).max(0.0).sqrt() * turned;
    [flat * c, flat * s, z]
}

fn shave(count: usize) -> (Operand, Vec<Operand>) {
    let mut steps: Vec<Operand> = Vec::with_capacity(count);
    for at in 0..count {
        let mesh = if at % 4 == 3 {
            // The cut before the last, an ulp farther inside at one corner.
            let mut mesh = steps[at - 2].mesh.clone();
            let x = &mut mesh.points[0][0];
            *x = step(*x, if *x > 0.0 { -1 } else { 1 });
            mesh
        } else {
            let out = direction(at, count);
            let helper = if out[0].abs() < 0.5 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
            let cross = |a: [f64; 3], b: [f64; 3]| {
                [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
            };
            let along = cross(out, helper);
            let beside = cross(out, along);
            // Beyond the plane that touches the sphere of radius 0.9.
            let corner = |at: usize| {
                let sign = |bit: usize| if at >> bit & 1 == 1 { 2.0 } else { -2.0 };
                let height = if at >> 2 & 1 == 1 { 2.0 } else { 0.9 };
                [0, 1, 2].map(|i: usize| along[i] * sign(0) + beside[i] * sign(1) + out[i] * height)
            };
            boxed([0, 1, 2, 3, 4, 5, 6, 7].map(corner))
        };
        steps.push(Operand { operation: Operation::Difference, mesh, cell: None });
    }
    (Operand { operation: Operation::Union, mesh: sphere(4), cell: None }, steps)
}

fn copies(count: usize) -> (Operand, Vec<Operand>) {
    let start = sphere(3);
    let copy = |at: usize| {
        let far = direction(at, count).map(|x| x / 2.0);
        let move_ = |point: &[f64; 3]| match at % 4 {
            0 => [0, 1, 2].map(|axis: usize| point[axis] + far[axis]),
            1 => point.map(|x| step(x, 1)),
            2 => point.map(|x| x + 1.0 / 1_073_741_824.0),
            _ => *point,
        };
        let mesh = Closed { points: start.points.iter().map(move_).collect(), triangles: start.triangles.clone() };
        Operand { operation: Operation::Union, mesh, cell: None }
    };
    let steps = (0..count).map(copy).collect();
    (Operand { operation: Operation::Union, mesh: start, cell: None }, steps)
}

/// Cubes of a lattice, and the number of squares around them.
#[derive(Clone, Default, Debug)]
pub(super) struct Cells(BTreeSet<[i64; 3]>);

impl Cells {
    pub fn apply(&mut self, operand: &Operand) {
        if let Some(cell) = operand.cell {
            match operand.operation {
                Operation::Union => self.0.insert(cell),
                _ => self.0.remove(&cell),
            };
        }
    }

    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// The number of squares between a cell of the set and a cell outside of it.
    pub fn squares(&self) -> usize {
        let exposed = |cell: &[i64; 3]| {
            let is_exposed = |way: usize| {
                let mut beside = *cell;
                beside[way / 2] += if way.is_multiple_of(2) { 1 } else { -1 };
                !self.0.contains(&beside)
            };
            (0..6).filter(|&way| is_exposed(way)).count()
        };
        self.0.iter().map(exposed).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operands_are_closed_and_seen_from_outside() {
        for cascade in Cascade::ALL {
            let (start, steps) = cascade.steps(24, 3);
            assert_eq!(steps.len(), 24);
            for Operand { mesh, .. } in steps.iter().chain([&start]) {
                assert_eq!(mesh.check(), Ok(()), "{cascade:?}");
                let volume: f64 = mesh
                    .triangles
                    .iter()
                    .map(|triangle| {
                        let [a, b, c] = triangle.map(|v| mesh.points[v as usize]);
                        a[0] * (b[1] * c[2] - b[2] * c[1])
                            + a[1] * (b[2] * c[0] - b[0] * c[2])
                            + a[2] * (b[0] * c[1] - b[1] * c[0])
                    })
                    .sum();
                assert!(volume > 0.0, "{cascade:?}");
            }
        }
    }

    #[test]
    fn lattices_end_with_nothing() {
        for cascade in [Cascade::Cubes, Cascade::Shuffled] {
            let (start, steps) = cascade.steps(1999, 1);
            let mut cells = Cells::default();
            cells.apply(&start);
            let most = steps
                .iter()
                .map(|step| {
                    cells.apply(step);
                    cells.count()
                })
                .max();
            assert_eq!((most, cells.count(), cells.squares()), (Some(1000), 0, 0));
        }
    }
}
