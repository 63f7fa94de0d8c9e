//! The union of closed cubes: the cells, squares, edges and points of a grid, counted.
//!
//! # Definition
//! Cubes are closed sets, and nothing is moved. The boundary has the area of the grid's squares between a filled and an
//! empty cell. Its edges are the edges of the grid around which it is not flat: one cell of four is filled, or three,
//! or two that are opposite; the length of the last counts once. The union has the squares, edges and points of its
//! cells, and its Euler characteristic is points − edges + squares − cells. A vertex is a point around which the eight
//! octants are not the same along any axis. Its [`Shape`] is its kind.
//!
//! # How
//! The planes of all faces cut space into cells, a plane of several faces once. Rows of bits along z are the cells, and
//! a square, an edge or a point is a bit of the words that combine the two, four or eight rows around it. Every element
//! of the grid is visited, so time and memory are limited: [`Cubes::closed`] refuses larger grids.

use std::collections::BTreeMap;

use rug::{Integer, Rational};

use super::Cubes;

/// The kind of a vertex: the number of filled octants, the number of pairs of them that have a face in common, and the
/// number of pairs that have only an edge in common. Turns and mirror images have one shape, and all else differs.
pub type Shape = [u32; 3];

/// The measures of the union of closed cubes, in the scene's units.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Closed {
    /// The volume.
    pub volume: Rational,
    /// The area of the boundary.
    pub area: Rational,
    /// The length of the boundary's edges.
    pub edge_length: Rational,
    /// The Euler characteristic of the union as a closed set.
    pub euler_characteristic: i64,
    /// The numbers of vertices by shape.
    pub vertices: BTreeMap<Shape, u64>,
}

/// The largest number of words, of 64 cells each, that are counted: 400 cubes without common planes have 8.3 million.
const MOST_WORDS: usize = 1 << 24;

/// The shape of a vertex with these octants. Octant x + 2y + 4z is bit x + 2y + 4z, with 1 for the upper side.
#[must_use]
pub fn shape(octants: u8) -> Shape {
    let filled = || (0..8_u32).filter(move |octant| octants >> octant & 1 == 1);
    let pairs = |apart: u32| {
        let others = |one: u32| filled().filter(move |other| *other > one && (one ^ other).count_ones() == apart);
        filled().map(|one| others(one).count()).sum::<usize>()
    };
    // (of 28 pairs)
    [filled().count(), pairs(1), pairs(2)].map(|count| u32::try_from(count).unwrap_or(u32::MAX))
}

/// The planes across an axis, ascending, and the ranks of each cube's lower and upper plane.
struct Planes {
    at: Vec<Integer>,
    ranks: Vec<[usize; 2]>,
}

impl Planes {
    fn new(cubes: &Cubes, axis: usize) -> Planes {
        let ends = |lower: &[Integer; 3]| [lower[axis].clone(), Integer::from(&lower[axis] + &cubes.edge)];
        let mut at: Vec<Integer> = cubes.lowers.iter().flat_map(ends).collect();
        at.sort();
        at.dedup();
        let rank = |end: &Integer| at.partition_point(|plane| plane < end);
        let ranks = cubes.lowers.iter().map(|lower| ends(lower).each_ref().map(rank)).collect();
        Planes { at, ranks }
    }

    /// The width of a slab: slab s ends at plane s. The outer slabs count as 0.
    fn width(&self, slab: usize) -> Integer {
        match (slab.checked_sub(1).and_then(|start| self.at.get(start)), self.at.get(slab)) {
            (Some(start), Some(end)) => Integer::from(end - start),
            _ => Integer::new(),
        }
    }
}

/// The cells of a slab across x: a row of bits for each slab across y, with a bit for each slab across z.
struct Section {
    rows: Vec<Vec<u64>>,
}

impl Section {
    /// The filled cells of a slab.
    fn new([x, y, z]: [&Planes; 3], slab: usize) -> Section {
        let mut rows = vec![vec![0; z.at.len() / 64 + 1]; y.at.len() + 1];
        for (cube, &[first, last]) in x.ranks.iter().enumerate() {
            if first < slab && slab <= last {
                let [from, to] = y.ranks[cube];
                for row in &mut rows[from + 1..=to] {
                    let [from, to] = z.ranks[cube];
                    (from + 1..=to).for_each(|cell| row[cell / 64] |= 1 << (cell % 64));
                }
            }
        }
        Section { rows }
    }

    /// A word of a row: its cells, and for each cell the next one along z.
    fn cells(&self, row: usize, word: usize) -> [u64; 2] {
        let row = &self.rows[row];
        [row[word], row[word] >> 1 | row.get(word + 1).map_or(0, |next| next << 63)]
    }
}

/// The bits for which the cells around an edge, in a circle, make it an edge of the boundary.
fn is_edge([a, b, c, d]: [u64; 4]) -> u64 {
    (a ^ b ^ c ^ d) | (!(a ^ c) & !(b ^ d) & (a ^ b))
}

/// The bits of which one word at least has a one.
fn any<const N: usize>(words: [u64; N]) -> u64 {
    words.into_iter().fold(0, |any, cells| any | cells)
}

/// The cells around an edge in a circle, from two rows with their next cells.
fn circle([[a, b], [d, c]]: [[u64; 2]; 2]) -> [u64; 4] {
    [a, b, c, d]
}

/// The number of ones.
fn count(words: impl Iterator<Item = u64>) -> u64 {
    words.map(|word| u64::from(word.count_ones())).sum()
}

/// The length along z of the cells whose bits are set.
fn length(z: &Planes, words: impl Iterator<Item = u64>) -> Integer {
    let mut sum = Integer::new();
    for (at, mut word) in words.enumerate() {
        while word != 0 {
            let run = (word >> word.trailing_zeros()).trailing_ones();
            let first = 64 * at + word.trailing_zeros() as usize;
            sum += &z.at[first + run as usize - 1];
            sum -= &z.at[first - 1];
            let end = word.trailing_zeros() + run;
            word = if end == 64 { 0 } else { word >> end << end };
        }
    }
    sum
}

/// The sums so far, in units of the common denominator.
#[derive(Default)]
struct Sums {
    volume: Integer,
    area: Integer,
    edge_length: Integer,
    points: u64,
    edges: u64,
    squares: u64,
    cells: u64,
    vertices: BTreeMap<Shape, u64>,
}

impl Sums {
    /// Adds the squares, edges and points in a plane across x.
    fn add_plane(&mut self, [y, z]: [&Planes; 2], before: &Section, after: &Section, words: usize) {
        for row in 0..=y.at.len() {
            let width = y.width(row);
            let both = |word: usize| [before.cells(row, word), after.cells(row, word)];
            let squares = (0..words).map(|word| both(word)[0][0] ^ both(word)[1][0]);
            self.area += &width * length(z, squares);
            self.squares += count((0..words).map(|word| both(word)[0][0] | both(word)[1][0]));
            self.edge_length += width * count((0..words).map(|word| is_edge(circle(both(word)))));
            self.edges += count((0..words).map(|word| any(circle(both(word)))));
        }
        for plane in 0..y.at.len() {
            // Octant x + 2y + 4z, for the points at the upper end of the cells.
            let octants = |word: usize| {
                let [[a, b], [c, d]] = [plane, plane + 1].map(|row| [before, after].map(|of| of.cells(row, word)));
                [a[0], b[0], c[0], d[0], a[1], b[1], c[1], d[1]]
            };
            let around = |word: usize| {
                let [a, b, d, c, ..] = octants(word);
                [a, b, c, d]
            };
            self.edge_length += length(z, (0..words).map(|word| is_edge(around(word))));
            self.edges += count((0..words).map(|word| any(around(word))));
            for word in 0..words {
                let octants = octants(word);
                self.points += u64::from(any(octants).count_ones());
                let differs = |axis: usize| (0..8).fold(0, |any, o: usize| any | (octants[o] ^ octants[o ^ 1 << axis]));
                let mut vertices = differs(0) & differs(1) & differs(2);
                while vertices != 0 {
                    let bit = vertices.trailing_zeros();
                    vertices &= vertices - 1;
                    let pattern = (0..8).fold(0, |bits, o| bits | u8::from(octants[o] >> bit & 1 == 1) << o);
                    *self.vertices.entry(shape(pattern)).or_default() += 1;
                }
            }
        }
    }

    /// Adds the cells of a slab across x, and the squares and edges along x between them.
    fn add_slab(&mut self, [y, z]: [&Planes; 2], width: &Integer, slab: &Section, words: usize) {
        for row in 0..=y.at.len() {
            let area = width * y.width(row);
            self.volume += &area * length(z, (0..words).map(|word| slab.cells(row, word)[0]));
            self.cells += count((0..words).map(|word| slab.cells(row, word)[0]));
            let pairs = || (0..words).map(|word| slab.cells(row, word));
            self.area += area * count(pairs().map(|[low, high]| low ^ high));
            self.squares += count(pairs().map(|[low, high]| low | high));
        }
        for plane in 0..y.at.len() {
            let both = |word: usize| [plane, plane + 1].map(|row| slab.cells(row, word));
            let squares = (0..words).map(|word| both(word)[0][0] ^ both(word)[1][0]);
            self.area += width * length(z, squares);
            self.squares += count((0..words).map(|word| both(word)[0][0] | both(word)[1][0]));
            self.edge_length += width * Integer::from(count((0..words).map(|word| is_edge(circle(both(word))))));
            self.edges += count((0..words).map(|word| any(circle(both(word)))));
        }
    }
}

impl Cubes {
    /// True if two faces of two cubes are in one plane. Otherwise the union of closed cubes has the
    /// [measures](Cubes::measures) of the perturbed one.
    #[must_use]
    pub fn have_common_planes(&self) -> bool {
        (0..3).any(|axis| Planes::new(self, axis).at.len() < 2 * self.len())
    }

    /// The measures of the union of the cubes as closed sets, which does not depend on their order; `None` if the grid
    /// has more than 2^30 cells.
    #[must_use]
    pub fn closed(&self) -> Option<Closed> {
        let planes = [0, 1, 2].map(|axis| Planes::new(self, axis));
        let [x, y, z] = &planes;
        let words = z.at.len() / 64 + 1;
        let all = (x.at.len() + 1).checked_mul(y.at.len() + 1).and_then(|rows| rows.checked_mul(words));
        if all.is_none_or(|all| all > MOST_WORDS) {
            return None;
        }
        let mut sums = Sums::default();
        let mut before = Section::new([x, y, z], 0);
        for slab in 1..=x.at.len() {
            let after = Section::new([x, y, z], slab);
            sums.add_plane([y, z], &before, &after, words);
            sums.add_slab([y, z], &x.width(slab), &after, words);
            before = after;
        }
        let power = |exponent: u32| Integer::from(rug::ops::Pow::pow(&self.denominator, exponent));
        // (each below 2^33)
        let [points, edges, squares, cells] = [sums.points, sums.edges, sums.squares, sums.cells].map(u64::cast_signed);
        Some(Closed {
            volume: Rational::from((sums.volume, power(3))),
            area: Rational::from((sums.area, power(2))),
            edge_length: Rational::from((sums.edge_length, power(1))),
            euler_characteristic: points - edges + squares - cells,
            vertices: sums.vertices,
        })
    }
}
