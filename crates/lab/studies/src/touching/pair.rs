//! Pairs of solids, with counted volumes and contacts.

use predicament_mesh_intersect::algorithm::cascade::Closed;

use crate::solids::{boxed, sphere};

/// Two solids.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, clap::ValueEnum)]
pub enum Pair {
    /// Two spheres in general position
    General,
    /// A sphere with itself
    Same,
    /// A block of unit squares with itself, moved by a lattice vector: the blocks overlap
    Shifted,
    /// Two stacks of unit cubes that share whole faces
    Faces,
    /// Two stacks of unit cubes whose faces overlap in part
    Parts,
    /// The stacks of `parts`, turned by the angle with cosine 3/5 and enlarged by 5
    Turned,
    /// Two stacks of unit cubes that share edges only
    Edges,
    /// Two stacks of unit cubes that share corners only
    Corners,
}

/// The counted truth about a pair.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Known {
    /// The volume of the union.
    pub union: f64,
    /// The number of points in which the solids touch, beside segments and faces.
    pub points: usize,
    /// The length of the segments in which the solids touch, beside faces.
    pub length: f64,
    /// The area in which the solids touch.
    pub area: f64,
}

impl Pair {
    /// All pairs.
    pub const ALL: [Pair; 8] =
        [Pair::General, Pair::Same, Pair::Shifted, Pair::Faces, Pair::Parts, Pair::Turned, Pair::Edges, Pair::Corners];

    /// The name of the pair in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Pair::General => "general",
            Pair::Same => "same",
            Pair::Shifted => "shifted",
            Pair::Faces => "faces",
            Pair::Parts => "parts",
            Pair::Turned => "turned",
            Pair::Edges => "edges",
            Pair::Corners => "corners",
        }
    }

    /// The two solids: spheres of 8 · 4^`levels` triangles, or blocks and stacks of `side` cubes along each axis.
    #[must_use]
    pub fn solids(self, side: u32, levels: usize) -> [Closed; 2] {
        let beside = |by: [f64; 3]| {
            let stack = stack(side);
            let other = moved(&stack, by);
            [stack, other]
        };
        match self {
            Pair::General => {
                let sphere = sphere(levels);
                let other = moved(&sphere, [0.5, 0.3, 0.1]);
                [sphere, other]
            }
            Pair::Same => [sphere(levels), sphere(levels)],
            Pair::Shifted => {
                let block = block(side);
                let other = moved(&block, [1.0, 1.0, 0.0]);
                [block, other]
            }
            Pair::Faces => beside([1.0, 0.0, 0.0]),
            Pair::Parts => beside(PART),
            Pair::Turned => beside(PART).map(|closed| {
                let turn = |[x, y, z]: [f64; 3]| [3.0 * x - 4.0 * y, 4.0 * x + 3.0 * y, 5.0 * z];
                Closed { points: closed.points.into_iter().map(turn).collect(), ..closed }
            }),
            Pair::Edges => beside([1.0, 1.0, 0.0]),
            Pair::Corners => beside([1.0, 1.0, 1.0]),
        }
    }

    /// The counted truth; `None` in general position, and for spheres.
    ///
    /// Along an axis, `side` cubes and as many others between them meet in 2 · `side` − 1 places.
    #[must_use]
    pub fn known(self, side: u32) -> Option<Known> {
        let n = f64::from(side);
        let meet = 2.0 * n - 1.0;
        let both = Known { union: 2.0 * n.powi(3), points: 0, length: 0.0, area: 0.0 };
        // A face of a cube and one of its neighbour overlap in a rectangle.
        let part = (1.0 - PART[1]) * (1.0 - PART[2]) * n * n * meet;
        match self {
            Pair::General | Pair::Same => None,
            Pair::Shifted => Some(Known { union: 2.0 * n.powi(3) - n * (n - 1.0).powi(2), ..both }),
            Pair::Faces => Some(Known { area: n * n * meet, ..both }),
            Pair::Parts => Some(Known { area: part, ..both }),
            Pair::Turned => Some(Known { union: 125.0 * both.union, area: 25.0 * part, ..both }),
            Pair::Edges => Some(Known { length: n * meet * meet, ..both }),
            Pair::Corners => {
                let along = 2 * side as usize - 1;
                Some(Known { points: along.pow(3), ..both })
            }
        }
    }
}

/// The move of a stack whose faces overlap those of the other in part.
const PART: [f64; 3] = [1.0, 0.5, 0.25];

fn moved(closed: &Closed, by: [f64; 3]) -> Closed {
    let points = closed.points.iter().map(|p| [0, 1, 2].map(|axis: usize| p[axis] + by[axis])).collect();
    Closed { points, triangles: closed.triangles.clone() }
}

/// Separate unit cubes, `side` along each axis, with gaps of one unit.
fn stack(side: u32) -> Closed {
    let mut all = Closed { points: Vec::new(), triangles: Vec::new() };
    for cell in (0..side.pow(3)).map(|cell| [cell / side / side, cell / side % side, cell % side]) {
        let first = u32::try_from(all.points.len()).expect("few points");
        let corner = |at: u32| [0, 1, 2].map(|axis: usize| f64::from(2 * cell[axis] + (at >> axis & 1)));
        let cube = boxed([0, 1, 2, 3, 4, 5, 6, 7].map(corner));
        all.points.extend(cube.points);
        all.triangles.extend(cube.triangles.iter().map(|triangle| triangle.map(|at| first + at)));
    }
    all
}

/// A cube of `side` units along each axis, whose surface has two triangles in each unit square.
fn block(side: u32) -> Closed {
    let mut numbers = std::collections::BTreeMap::new();
    let mut all = Closed { points: Vec::new(), triangles: Vec::new() };
    let mut vertex = |at: [u32; 3], points: &mut Vec<[f64; 3]>| {
        *numbers.entry(at).or_insert_with(|| {
            points.push(at.map(f64::from));
            u32::try_from(points.len() - 1).expect("few points")
        })
    };
    for axis in 0..3 {
        for (level, is_upper) in [(0, false), (side, true)] {
            for square in 0..side * side {
                let corner = |u: u32, v: u32| {
                    let mut at = [0; 3];
                    at[axis] = level;
                    at[(axis + 1) % 3] = square / side + u;
                    at[(axis + 2) % 3] = square % side + v;
                    at
                };
                let mut ring = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                if !is_upper {
                    ring.reverse();
                }
                let [a, b, c, d] = ring.map(|at| vertex(at, &mut all.points));
                all.triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    all
}
