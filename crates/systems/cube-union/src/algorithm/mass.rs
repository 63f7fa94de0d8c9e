//! The contribution of a vertex of the union to volume, area and edge length.

use super::touching::{TIED, cases};

/// The exact mass properties of a union of cubes, in units of the input's integers (their square for areas, their cube
/// for volumes): of the perturbed union, or of the closed one.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Mass {
    /// The volume, which does not depend on ties.
    pub volume: i128,
    /// The area of the boundary; of a perturbed union, as the perturbation goes to zero.
    pub area: i128,
    /// The length of the boundary's edges; of a perturbed union, as the perturbation goes to zero.
    pub edge_length: i128,
    /// The numbers of vertices of the union, by kind.
    pub vertices: Vertices,
}

/// The numbers of vertices of the union, by kind.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Vertices {
    /// Corners of one cube.
    pub corners: u64,
    /// Points where an edge of one cube meets a face of another.
    pub edge_faces: u64,
    /// Points where the faces of three cubes meet.
    pub three_faces: u64,
    /// Vertices of the cases [`TIED`], which need faces in one plane: a perturbed union has none of them.
    pub tied: [u64; TIED.len()],
}

impl Vertices {
    /// The total number of vertices.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.corners + self.edge_faces + self.three_faces + self.tied.iter().sum::<u64>()
    }

    /// The number of vertices of each case, with the octants that are filled around one of them: octant x + 2y + 4z is
    /// bit x + 2y + 4z, with 1 for the upper side.
    pub fn by_octants(&self) -> impl Iterator<Item = (u8, u64)> {
        cases().map(|case| case.octants).zip(self.counts())
    }

    /// The number of vertices of each case, with the case's name.
    pub fn by_name(&self) -> impl Iterator<Item = (&'static str, u64)> {
        cases().map(|case| case.name).zip(self.counts())
    }

    /// The numbers in the order of the table of cases.
    fn counts(&self) -> impl Iterator<Item = u64> {
        [self.corners, self.edge_faces, self.three_faces].into_iter().chain(self.tied)
    }

    /// The Euler characteristic of the closed union, parts − tunnels + cavities; `None` if the numbers fit no union.
    #[must_use]
    pub fn of_the_union(&self) -> Option<i128> {
        let eighths: i128 = cases().zip(self.counts()).map(|(case, of)| i128::from(case.euler) * i128::from(of)).sum();
        (eighths % 8 == 0).then_some(eighths / 8)
    }

    /// The Euler characteristic of the boundary, 2 for each ball-like part; `None` if the numbers fit no closed
    /// surface.
    ///
    /// It is twice that [of the union](Vertices::of_the_union). The boundary of a union with [`tied`](Vertices::tied)
    /// vertices may not be a surface, and the answer is `None`.
    ///
    /// The boundary is flat except at its vertices. There the face angles add up to 3π/2 at a corner, to 5π/2 at an
    /// edge and a face, and to 3π/2 at three faces. The differences from 2π add up to 2πχ (Gauss-Bonnet), so χ is a
    /// quarter of the sum of +1, −1 and +1. A closed surface in space has an even χ, so any other number gives `None`.
    #[must_use]
    pub fn euler_characteristic(&self) -> Option<i128> {
        let [corners, edge_faces, three_faces] = [self.corners, self.edge_faces, self.three_faces].map(i128::from);
        let quarters = corners - edge_faces + three_faces;
        (quarters % 8 == 0 && self.tied == [0; TIED.len()]).then_some(quarters / 4)
    }
}

impl Mass {
    /// Adds the vertex at `at`, the meeting point of the x, y and z face of these owners, `times` times.
    ///
    /// Sums wrap: intermediate sums may exceed 128 bits as long as the totals don't.
    #[inline]
    pub(super) fn add(&mut self, [a, b, c]: [usize; 3], at: [i64; 3], upper: [bool; 3], times: u64) {
        let signed = |positive: bool, value: i64| if positive { value } else { -value };
        let along: [i64; 3] = std::array::from_fn(|axis| signed(upper[axis], at[axis]));
        let [x, y, z] = along.map(i128::from);
        let volume = (x * y).wrapping_mul(z);
        let area = (x * y).wrapping_add(y * z).wrapping_add(z * x);
        // An edge along an axis is convex if both faces that meet there belong to one cube.
        let convex = [b == c, c == a, a == b];
        let length: i128 = (0..3).map(|axis| i128::from(signed(convex[axis], along[axis]))).sum();
        let same = convex.map(u64::from).iter().sum::<u64>();
        let is_edge_face = same == 1;
        let factor = if is_edge_face { -i128::from(times) } else { i128::from(times) };
        self.sum(volume.wrapping_mul(factor), area.wrapping_mul(factor), length.wrapping_mul(factor));
        self.vertices.corners += times * u64::from(same == 3);
        self.vertices.edge_faces += times * u64::from(is_edge_face);
        self.vertices.three_faces += times * u64::from(same == 0);
    }

    #[inline]
    fn sum(&mut self, volume: i128, area: i128, length: i128) {
        self.volume = self.volume.wrapping_add(volume);
        self.area = self.area.wrapping_add(area);
        self.edge_length = self.edge_length.wrapping_add(length);
    }

    /// The sums over both sets of vertices.
    pub(super) fn merge(mut self, other: Mass) -> Mass {
        self.sum(other.volume, other.area, other.edge_length);
        self.vertices.corners += other.vertices.corners;
        self.vertices.edge_faces += other.vertices.edge_faces;
        self.vertices.three_faces += other.vertices.three_faces;
        self.vertices.tied.iter_mut().zip(other.vertices.tied).for_each(|(sum, count)| *sum += count);
        self
    }
}
