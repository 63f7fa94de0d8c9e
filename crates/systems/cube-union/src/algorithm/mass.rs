//! What a vertex of the union adds to volume, area and edge length.

/// Mass properties of a union of cubes, exactly, in units of the input's
/// integers (their square for areas, their cube for volumes).
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Mass {
    /// The volume. Ties play no part in it.
    pub volume: i128,
    /// The area of the boundary, as the perturbation goes to zero.
    pub area: i128,
    /// The length of the boundary's edges, as the perturbation goes to zero.
    pub edge_length: i128,
    /// How many vertices the perturbed union has, by kind.
    pub vertices: Vertices,
}

/// The vertices of the union, by what meets there.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Vertices {
    /// Corners of one cube.
    pub corners: u64,
    /// Where an edge of one cube meets a face of another.
    pub edge_faces: u64,
    /// Where the faces of three cubes meet.
    pub three_faces: u64,
}

impl Vertices {
    /// All of them.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.corners + self.edge_faces + self.three_faces
    }

    /// The Euler characteristic of the boundary, 2 for each ball-like part.
    ///
    /// The boundary is flat but for its vertices, where the face angles add up
    /// to 3π/2 at a corner, to 5π/2 at an edge and a face, and to 3π/2 at three
    /// faces. What is missing to 2π adds up to 2πχ (Gauss-Bonnet), so χ is a
    /// quarter of the sum of +1, −1 and +1. None where that is not an even
    /// number, which no closed surface in space allows.
    #[must_use]
    pub fn euler_characteristic(&self) -> Option<i128> {
        let [corners, edge_faces, three_faces] = [self.corners, self.edge_faces, self.three_faces].map(i128::from);
        let quarters = corners - edge_faces + three_faces;
        (quarters % 8 == 0).then_some(quarters / 4)
    }
}

impl Mass {
    /// Adds the vertex at `at`, where the x, y and z face of these owners meet, so many times.
    ///
    /// Sums wrap: what is added and taken away again may exceed 128 bits as
    /// long as the totals don't.
    #[inline]
    pub(super) fn add(&mut self, [a, b, c]: [usize; 3], at: [i64; 3], upper: [bool; 3], times: u64) {
        let signed = |positive: bool, value: i64| if positive { value } else { -value };
        let along: [i64; 3] = std::array::from_fn(|axis| signed(upper[axis], at[axis]));
        let [x, y, z] = along.map(i128::from);
        let volume = (x * y).wrapping_mul(z);
        let area = (x * y).wrapping_add(y * z).wrapping_add(z * x);
        // An edge along an axis is convex if both faces that meet there are of one cube.
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
        self
    }
}
