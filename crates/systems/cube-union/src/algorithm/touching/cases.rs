//! The cases in which the octants around a point are filled.
//!
//! Octant x + 2y + 4z is on the upper side along an axis if the axis' term is there; bit k of a pattern is octant k.

/// A case: the patterns that the symmetries of a cube make of one pattern.
pub(in crate::algorithm) struct Case {
    pub(in crate::algorithm) name: &'static str,
    /// One of the patterns. The terms below belong to it.
    pub(in crate::algorithm) octants: u8,
    /// The factor of xyz in the volume.
    pub(super) volume: i8,
    /// The factors of yz, zx and xy in the area.
    pub(super) area: [i8; 3],
    /// The factors of x, y and z in the length of edges.
    pub(super) edges: [i8; 3],
    /// The term in the Euler characteristic of the closed set, in eighths.
    pub(in crate::algorithm) euler: i8,
}

/// A row of the table.
const fn case(name: &'static str, octants: u8, volume: i8, area: [i8; 3], edges: [i8; 3], euler: i8) -> Case {
    Case { name, octants, volume, area, edges, euler }
}

/// The cases of general position, which come first.
pub(super) const GENERAL: usize = 3;
/// The cases that are vertices, which come before the others.
pub(super) const VERTICES: usize = 16;

/// All cases.
#[rustfmt::skip]
pub(super) static CASES: [Case; 22] = [
    case("corner",                  0b0000_0001,  1, [ 1,  1,  1], [ 1,  1,  1],  1),
    case("edge-face",               0b0001_1111, -1, [-1, -1, -1], [ 1,  1, -1], -1),
    case("three-faces",             0b0111_1111,  1, [ 1,  1,  1], [-1, -1, -1],  1),
    case("corners-at-edge",         0b0000_0110, -2, [ 0,  0, -2], [ 0,  0,  1], -2),
    case("corners-at-point",        0b0001_1000,  0, [-2, -2,  2], [ 0,  0,  0], -6),
    case("bend",                    0b0000_0111, -1, [-1, -1, -1], [-1, -1,  1], -1),
    case("bar-and-corner",          0b0001_1001,  1, [-1, -1,  1], [-1, -1,  0], -3),
    case("three-corners",           0b0001_0110, -3, [-1, -1, -1], [ 0,  0,  0], -1),
    case("tripod",                  0b0001_0111, -2, [-2, -2, -2], [ 0,  0,  0], -2),
    case("stair",                   0b0001_1011,  0, [-2,  0,  0], [ 0,  0,  0], -2),
    case("bend-and-corner",         0b0001_1110, -2, [ 0,  0,  0], [ 1,  1,  0],  0),
    case("alternate",               0b0110_1001,  4, [ 0,  0,  0], [ 0,  0,  0],  4),
    case("but-bar-and-corner",      0b0011_1101,  1, [ 1, -1, -1], [ 0,  1,  1],  1),
    case("but-three-corners",       0b0110_1011,  3, [-1,  1,  1], [ 0,  0,  0],  3),
    case("but-corners-at-edge",     0b0110_1111,  2, [ 0,  0,  2], [ 0,  0, -1],  2),
    case("but-corners-at-point",    0b0111_1110,  0, [ 2,  2,  2], [ 0,  0,  0],  2),
    case("outside",                 0b0000_0000,  0, [ 0,  0,  0], [ 0,  0,  0],  0),
    case("edge",                    0b0000_0011,  0, [ 0,  0,  0], [ 0,  0,  0],  0),
    case("face",                    0b0000_1111,  0, [ 0,  0,  0], [ 0,  0,  0],  0),
    case("crossed-edges",           0b0011_1100,  0, [ 0,  0,  0], [ 0,  0,  0],  0),
    case("reflex-edge",             0b0011_1111,  0, [ 0,  0,  0], [ 0,  0,  0],  0),
    case("inside",                  0b1111_1111,  0, [ 0,  0,  0], [ 0,  0,  0],  0),
];

/// The names of the vertices that need faces in one plane, in the order of their counts.
pub const TIED: [&str; VERTICES - GENERAL] = {
    let mut names = [""; VERTICES - GENERAL];
    let mut at = GENERAL;
    while at < VERTICES {
        names[at - GENERAL] = CASES[at].name;
        at += 1;
    }
    names
};

/// The terms of a pattern.
#[derive(Clone, Copy)]
pub(super) struct Terms {
    /// The place of the pattern's case in the table.
    pub(super) case: usize,
    pub(super) volume: i8,
    pub(super) area: [i8; 3],
    pub(super) edges: [i8; 3],
}

/// The terms of each pattern. (The table does not compile if a pattern is without a case.)
pub(super) static TERMS: [Terms; 256] = terms();

const PERMUTATIONS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// The pattern in the mirror and with other axes: axis i is axis `from[i]` of the original, and turned round if bit i
/// of `turned` is set.
const fn image(octants: u8, from: [usize; 3], turned: usize) -> u8 {
    let (mut image, mut octant) = (0, 0);
    while octant < 8 {
        let (mut at, mut axis) = (0, 0);
        while axis < 3 {
            at |= ((octant >> from[axis] ^ turned >> axis) & 1) << axis;
            axis += 1;
        }
        image |= (octants >> octant & 1) << at;
        octant += 1;
    }
    image
}

/// The direction of an axis in the image.
const fn direction(turned: usize, axis: usize) -> i8 {
    if turned >> axis & 1 == 1 { -1 } else { 1 }
}

const fn terms() -> [Terms; 256] {
    let none = Terms { case: CASES.len(), volume: 0, area: [0; 3], edges: [0; 3] };
    let mut terms = [none; 256];
    let mut number = 0;
    while number < CASES.len() {
        let case = &CASES[number];
        let mut symmetry = 0;
        while symmetry < 48 {
            let (from, turned) = (PERMUTATIONS[symmetry / 8], symmetry % 8);
            let sign = [direction(turned, 0), direction(turned, 1), direction(turned, 2)];
            let of = &mut terms[image(case.octants, from, turned) as usize];
            assert!(of.case == CASES.len() || of.case == number, "no pattern has two cases");
            *of = Terms {
                case: number,
                volume: sign[0] * sign[1] * sign[2] * case.volume,
                area: [
                    sign[1] * sign[2] * case.area[from[0]],
                    sign[2] * sign[0] * case.area[from[1]],
                    sign[0] * sign[1] * case.area[from[2]],
                ],
                edges: [sign[0] * case.edges[from[0]], sign[1] * case.edges[from[1]], sign[2] * case.edges[from[2]]],
            };
            symmetry += 1;
        }
        number += 1;
    }
    let mut pattern = 0;
    while pattern < 256 {
        assert!(terms[pattern].case < CASES.len(), "every pattern has a case");
        pattern += 1;
    }
    terms
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sum over octants, with the product of their directions along these axes as signs.
    fn sum(of: impl Fn(usize) -> bool, axes: &[usize]) -> i8 {
        let sign = |octant: usize| axes.iter().map(|axis| if octant >> axis & 1 == 1 { 1 } else { -1 }).product::<i8>();
        (0..8).filter(|&octant| of(octant)).map(sign).sum()
    }

    #[test]
    fn the_terms_are_what_the_octants_say() {
        for (pattern, terms) in TERMS.iter().enumerate() {
            let is_filled = |octant: usize| pattern >> octant & 1 == 1;
            assert_eq!(terms.volume, -sum(is_filled, &[0, 1, 2]), "{pattern:#b}");
            let mut euler = if pattern == 0 { 0 } else { 8 } - sum(is_filled, &[]);
            for axis in 0..3 {
                let [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
                let is_border =
                    |octant: usize| octant >> axis & 1 == 0 && is_filled(octant) != is_filled(octant | 1 << axis);
                assert_eq!(terms.area[axis], sum(is_border, &[j, k]), "{pattern:#b}");
                let quarters = |side: usize| {
                    [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[a, b]| is_filled(side << axis | a << j | b << k))
                };
                let is_edge = |side: usize| {
                    let [a, b, c, d] = quarters(side);
                    i8::from(a ^ b ^ c ^ d || (a == c && b == d && a != b))
                };
                assert_eq!(terms.edges[axis], is_edge(0) - is_edge(1), "{pattern:#b}");
                for side in [0, 1] {
                    euler -= 4 * i8::from(quarters(side).contains(&true));
                    for other in [0, 1] {
                        let one = side << j | other << k;
                        euler += 2 * i8::from(is_filled(one) || is_filled(one | 1 << axis));
                    }
                }
            }
            assert_eq!(CASES[terms.case].euler, euler, "{pattern:#b}");
        }
    }

    #[test]
    fn patterns_that_are_no_vertices_are_constant_along_an_axis() {
        for (pattern, terms) in TERMS.iter().enumerate() {
            let is_constant = (0..3).any(|axis| (0..8).all(|o| pattern >> o & 1 == pattern >> (o ^ 1 << axis) & 1));
            assert_eq!(terms.case >= VERTICES, is_constant, "{pattern:#b}");
        }
    }
}
