//! The exact union of congruent cubes: which cells of a grid are filled.
//!
//! # Definition
//! Vertices 2i and 2i + 1 of a scene are the lower and the upper corner of cube i. Cube i is moved along all axes by an
//! infinitesimal that is larger than those of all later cubes: of two equal coordinates, the coordinate of the cube
//! with the smaller number is larger. So no two faces are coplanar, and the boundary of the union is a surface. Volume,
//! area and edge length are the limits for infinitesimals that go to zero. Where the upper face of one cube is on the
//! lower face of another, their common part is no boundary if the first cube has the smaller number; otherwise it is
//! boundary on both sides. A seam between two coplanar faces is a step, which has two edges.
//!
//! The vertices are those of the *perturbed* union, even where several coincide after the limit. A vertex' kind is the
//! number of filled octants among the eight around it: 1 at a **corner** of a cube, 5 where an **edge meets a face**, 7
//! where **three faces** meet. (These are the only points with an odd number of filled octants; 3 is impossible, as
//! each plane has the face of one cube.)
//!
//! # How
//! The planes of all faces cut space into cells, each filled or empty: a grid of (2n)³ for n cubes, in which only the
//! order of the planes matters. A sweep along one axis visits one section at a time, stored as rows of bits. A row's
//! ends are the boundary across the row. Where the ends of two neighbouring rows differ, the section has a corner,
//! which is an edge along the sweep. Where the corners of two neighbouring sections differ, there is a vertex. Each of
//! the three axes is swept once, and all sweeps must find the same volume and vertices. Widths are integers over one
//! common denominator.
//!
//! [`Cubes::closed`] measures the union of closed cubes, which are not moved.
//!
//! The algorithm under test has no cells: it sums up the contributions of vertices. For thousands of cubes the sweep is
//! too slow; [`Cubes::sample`] says which cubes are then measured.

mod closed;

use std::cmp::Reverse;
use std::ops::RangeInclusive;

use predicament_predicates::{Dimension, Scene, Vertex};
use rug::{Integer, Rational};

use crate::determinant::rational;

pub use closed::{Closed, Shape, shape};

/// The reason why a scene is not a set of congruent cubes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NotCubes {
    /// The scene is 2D or has an odd number of vertices.
    NoPairs,
    /// A cube's extent along an axis (0 to 2) differs from the first cube's extent along x, or is not positive.
    Extent {
        /// The number of the cube.
        cube: usize,
        /// The number of the axis.
        axis: usize,
    },
}

impl std::fmt::Display for NotCubes {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            NotCubes::NoPairs => write!(f, "cubes are pairs of points in space"),
            NotCubes::Extent { cube, axis } => {
                write!(f, "cube {cube} is not as long along axis {axis} as the first one, or has no volume")
            }
        }
    }
}

impl std::error::Error for NotCubes {}

/// The measures of a union, in the scene's units.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Measures {
    /// The volume.
    pub volume: Rational,
    /// The area of the boundary.
    pub area: Rational,
    /// The length of the boundary's edges.
    pub edge_length: Rational,
    /// The numbers of vertices of the perturbed union.
    pub vertices: Vertices,
}

/// The number of vertices of a perturbed union, by kind.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Vertices {
    /// Corners of one cube: one octant is filled.
    pub corners: u64,
    /// Points where an edge of one cube meets a face of another: five octants are filled.
    pub edge_faces: u64,
    /// Points where faces of three cubes meet: seven octants are filled.
    pub three_faces: u64,
}

/// Congruent cubes with integer corners over one denominator.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cubes {
    /// The lower corners, times the denominator.
    lowers: Vec<[Integer; 3]>,
    /// The length of the edges, times the denominator.
    edge: Integer,
    denominator: Integer,
}

/// The largest number of cubes that are all measured; above it a sample is measured.
const MOST: usize = 400;

impl Cubes {
    /// The cubes of a scene.
    ///
    /// # Errors
    /// [`NotCubes`] if the scene does not hold cubes, or the cubes differ in size.
    pub fn of_scene(scene: &Scene) -> Result<Cubes, NotCubes> {
        if scene.dimension() != Dimension::Three || !scene.len().is_multiple_of(2) {
            return Err(NotCubes::NoPairs);
        }
        let points: Vec<[Rational; 3]> = scene.vertices().map(|v: Vertex| scene.point3(v).map(rational)).collect();
        let mut denominator = Integer::from(1);
        for coordinate in points.as_flattened() {
            denominator.lcm_mut(coordinate.denom());
        }
        let units = |x: &Rational| Integer::from(x.numer() * &denominator) / x.denom();
        let mut cubes = Cubes {
            lowers: Vec::with_capacity(points.len() / 2),
            edge: Integer::from(1),
            denominator: Integer::from(1),
        };
        for (cube, ends) in points.chunks(2).enumerate() {
            let [lower, upper] = [0, 1].map(|end| [0, 1, 2].map(|axis| units(&ends[end][axis])));
            for axis in 0..3 {
                let extent = Integer::from(&upper[axis] - &lower[axis]);
                if (cube, axis) == (0, 0) {
                    cubes.edge = extent.clone();
                }
                if extent != cubes.edge || extent.cmp0().is_le() {
                    return Err(NotCubes::Extent { cube, axis });
                }
            }
            cubes.lowers.push(lower);
        }
        cubes.denominator = denominator;
        Ok(cubes)
    }

    /// The number of cubes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.lowers.len()
    }

    /// True if there are no cubes.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.lowers.is_empty()
    }

    /// The indices of the cubes to measure, ascending: all up to 400 cubes, else the 200 to 400 cubes in a part of the
    /// bounding box. The box is split into halves with equal numbers of cubes, across the axis along which the lower
    /// corners extend furthest. The lower half is kept, and split again, until it has few enough cubes.
    ///
    /// A sample is a union in its own right, as dense as the whole. Judge and backend both measure the sample.
    #[must_use]
    pub fn sample(&self) -> Vec<usize> {
        self.sample_of(MOST)
    }

    /// [`Cubes::sample`] with a limit other than 400.
    ///
    /// # Panics
    /// If the limit is zero.
    #[must_use]
    pub fn sample_of(&self, most: usize) -> Vec<usize> {
        assert!(most > 0, "a sample has cubes");
        let mut kept: Vec<usize> = (0..self.len()).collect();
        while kept.len() > most {
            let along = |axis: usize| kept.iter().map(move |&cube| &self.lowers[cube][axis]);
            let extent =
                |axis: usize| along(axis).max().zip(along(axis).min()).map(|(most, least)| Integer::from(most - least));
            // Ties between extents go to the first axis.
            let axis = [0, 1, 2].into_iter().max_by_key(|&axis| (extent(axis), Reverse(axis))).unwrap_or(0);
            kept.sort_by_key(|&cube| (&self.lowers[cube][axis], cube));
            kept.truncate(kept.len().div_ceil(2));
        }
        kept.sort_unstable();
        kept
    }

    /// The given cubes only, in the given order.
    ///
    /// # Panics
    /// If a cube does not exist.
    #[must_use]
    pub fn only(&self, cubes: &[usize]) -> Cubes {
        Cubes { lowers: cubes.iter().map(|&cube| self.lowers[cube].clone()).collect(), ..self.clone() }
    }

    /// The measures of the union.
    ///
    /// # Panics
    /// If the sweeps along the three axes contradict each other.
    #[must_use]
    pub fn measures(&self) -> Measures {
        let axes = [0, 1, 2].map(|axis| Faces::new(self, axis));
        let sweeps = [0, 1, 2].map(|axis| Sweep::along([0, 1, 2].map(|next| &axes[(axis + next) % 3])));
        let [first, others @ ..] = &sweeps;
        for other in others {
            assert_eq!((&first.volume, first.vertices), (&other.volume, other.vertices), "one union by three ways");
        }
        let power = |exponent: u32| Integer::from(rug::ops::Pow::pow(&self.denominator, exponent));
        Measures {
            volume: Rational::from((first.volume.clone(), power(3))),
            area: Rational::from((sweeps.iter().map(|sweep| &sweep.area).sum::<Integer>(), power(2))),
            edge_length: Rational::from((sweeps.iter().map(|sweep| &sweep.edge_length).sum::<Integer>(), power(1))),
            vertices: first.vertices,
        }
    }
}

/// The faces along one axis, in their perturbed order.
struct Faces {
    /// The coordinate of the face at each rank.
    at: Vec<Integer>,
    /// The cube that owns the face at each rank, and true if it is the cube's upper face.
    owners: Vec<(usize, bool)>,
    /// The ranks of each cube's lower and upper face.
    ranks: Vec<[usize; 2]>,
}

impl Faces {
    fn new(cubes: &Cubes, axis: usize) -> Faces {
        let sides = |(cube, lower): (usize, &[Integer; 3])| {
            [
                (lower[axis].clone(), Reverse(cube), false),
                (Integer::from(&lower[axis] + &cubes.edge), Reverse(cube), true),
            ]
        };
        let mut all: Vec<(Integer, Reverse<usize>, bool)> = cubes.lowers.iter().enumerate().flat_map(sides).collect();
        all.sort();
        let mut ranks = vec![[0; 2]; cubes.len()];
        for (rank, &(_, Reverse(cube), upper)) in all.iter().enumerate() {
            ranks[cube][usize::from(upper)] = rank;
        }
        let owners = all.iter().map(|&(_, Reverse(cube), upper)| (cube, upper)).collect();
        Faces { at: all.into_iter().map(|(at, ..)| at).collect(), owners, ranks }
    }

    /// The distance from the face of this rank to the next; zero after the last.
    fn width(&self, rank: usize) -> Integer {
        match self.at.get(rank + 1) {
            Some(next) => Integer::from(next - &self.at[rank]),
            None => Integer::new(),
        }
    }
}

/// A section of the union, across u: a row of bits for each strip between two faces along v. Bit k + 1 of a row is the
/// cell from face k along w to the next face. Strip 0, bit 0, the last strip and the last bit are outside of all cubes.
struct Section<'f> {
    v: &'f Faces,
    w: &'f Faces,
    words: usize,
    rows: Vec<u64>,
    /// The filled area.
    area: Integer,
    /// The sum over strips of the strip's width times its number of ends.
    ends: Integer,
    corners: u64,
}

impl<'f> Section<'f> {
    fn empty(v: &'f Faces, w: &'f Faces) -> Section<'f> {
        let strips = v.at.len() + 1;
        let words = (w.at.len() + 1).div_ceil(64);
        Section { v, w, words, rows: vec![0; strips * words], area: Integer::new(), ends: Integer::new(), corners: 0 }
    }

    fn row(&self, strip: usize) -> &[u64] {
        &self.rows[strip * self.words..][..self.words]
    }

    /// A word of the ends of a strip: bit k is set if exactly one side of face k along w is a filled cell.
    fn ends(&self, strip: usize, word: usize) -> u64 {
        let row = self.row(strip);
        let next = row.get(word + 1).map_or(0, |next| next << 63);
        row[word] ^ (row[word] >> 1 | next)
    }

    /// A word of the corners at a face along v: bit k is set if an odd number of the four cells around face k along w
    /// is filled.
    fn corners(&self, face: usize, word: usize) -> u64 {
        self.ends(face, word) ^ self.ends(face + 1, word)
    }

    /// The filled length of a strip, and the number of its ends.
    fn measure(&self, strip: usize) -> (Integer, u64) {
        let (mut length, mut ends) = (Integer::new(), 0);
        for word in 0..self.words {
            for bit in ones(self.ends(strip, word)) {
                let at = &self.w.at[64 * word + bit];
                // Ends alternate: start, end, start, …
                if ends % 2 == 0 {
                    length -= at
                } else {
                    length += at
                }
                ends += 1;
            }
        }
        (length, ends)
    }

    /// The number of corners at these faces along v.
    fn corners_at(&self, faces: RangeInclusive<usize>) -> u64 {
        let of_face =
            |face| (0..self.words).map(move |word| u64::from(self.corners(face, word).count_ones())).sum::<u64>();
        faces.map(of_face).sum()
    }

    /// Updates the sums after the strips of one cube were refilled.
    fn update(&mut self, before: &Section, [lower, upper]: [usize; 2]) {
        for strip in lower + 1..=upper {
            let width = self.v.width(strip - 1);
            if width.is_zero() || self.row(strip) == before.row(strip) {
                continue;
            }
            let [(length, ends), (length_before, ends_before)] = [self.measure(strip), before.measure(strip)];
            self.area += (length - length_before) * &width;
            self.ends += (Integer::from(ends) - ends_before) * width;
        }
        self.corners += self.corners_at(lower..=upper);
        self.corners -= before.corners_at(lower..=upper);
    }

    /// Refills the strips of a cube from the cubes that are present.
    fn fill(&mut self, [lower, upper]: [usize; 2], present: &[usize]) {
        self.rows[(lower + 1) * self.words..(upper + 1) * self.words].fill(0);
        for &cube in present {
            let [from, to] = self.v.ranks[cube];
            let [first, last] = self.w.ranks[cube];
            for strip in from.max(lower) + 1..=to.min(upper) {
                let row = &mut self.rows[strip * self.words..][..self.words];
                set(row, first + 1, last + 1);
            }
        }
    }

    /// The number of filled cells on both sides of face `k` along w, in the two strips that meet at `face` along v.
    fn filled(&self, face: usize, k: usize) -> u32 {
        let is_filled = |strip: usize, bit: usize| u32::from(self.row(strip)[bit / 64] >> (bit % 64) & 1 == 1);
        [face, face + 1].into_iter().flat_map(|strip| [k, k + 1].map(|bit| is_filled(strip, bit))).sum()
    }
}

/// The bits that are set in a word, ascending.
fn ones(mut word: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = (word != 0).then(|| word.trailing_zeros() as usize);
        word &= word.wrapping_sub(1);
        bit
    })
}

/// Sets the bits from `start` to before `end`.
fn set(row: &mut [u64], start: usize, end: usize) {
    for (word, bits) in row.iter_mut().enumerate().take(end.div_ceil(64)).skip(start / 64) {
        let from = start.saturating_sub(64 * word);
        let to = (end - 64 * word).min(64);
        *bits |= (u64::MAX << from) & (u64::MAX >> (64 - to));
    }
}

/// The results of one sweep.
#[derive(Default)]
struct Sweep {
    volume: Integer,
    /// The area of the faces across the third axis.
    area: Integer,
    /// The length of the edges along the sweep.
    edge_length: Integer,
    vertices: Vertices,
}

impl Sweep {
    /// Sweeps along u through sections of strips along v and rows along w.
    fn along([u, v, w]: [&Faces; 3]) -> Sweep {
        let mut sweep = Sweep::default();
        let mut section = Section::empty(v, w);
        let mut present: Vec<usize> = Vec::new();
        for (rank, &(cube, is_upper)) in u.owners.iter().enumerate() {
            if is_upper {
                present.retain(|&other| other != cube);
            } else {
                present.push(cube);
            }
            // Behind the face only the strips of its owner can differ.
            let strips = v.ranks[cube];
            let before = Section { rows: section.rows.clone(), area: Integer::new(), ends: Integer::new(), ..section };
            section.fill(strips, &present);
            section.update(&before, strips);
            sweep.add_vertices(&before, &section, strips);
            let width = u.width(rank);
            sweep.volume += &width * &section.area;
            sweep.area += &width * &section.ends;
            sweep.edge_length += width * section.corners;
        }
        sweep
    }

    /// The vertices in the plane between two sections that differ in the strips of a cube.
    fn add_vertices(&mut self, before: &Section, after: &Section, [lower, upper]: [usize; 2]) {
        for face in lower..=upper {
            for word in 0..after.words {
                for bit in ones(before.corners(face, word) ^ after.corners(face, word)) {
                    let k = 64 * word + bit;
                    match before.filled(face, k) + after.filled(face, k) {
                        1 => self.vertices.corners += 1,
                        5 => self.vertices.edge_faces += 1,
                        7 => self.vertices.three_faces += 1,
                        filled => unreachable!("{filled} octants filled around a vertex"),
                    }
                }
            }
        }
    }
}
