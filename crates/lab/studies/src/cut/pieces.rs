//! Tetrahedra cut in two by the sides of their vertices and the points on their edges.

use predicament_mesh::Complex;
use predicament_predicates::{Scene, Vertex};

use super::Sides;

/// The pieces of a lattice's tetrahedra.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Pieces {
    /// The number of tetrahedra with a piece on both sides.
    pub cut: usize,
    /// The number of tetrahedra with an edge that contradicts the sides of its ends: they have no pieces.
    pub inconsistent: usize,
    /// The number of tetrahedra with all vertices on the surface, or with an unknown vertex: they have no pieces
    /// either.
    pub undecided: usize,
    /// The volume of the tetrahedra without pieces.
    pub lost: f64,
    /// The volume inside.
    pub inside: f64,
    /// The volume of all pieces.
    pub sum: f64,
    /// The number of pieces with less than [`SLIVER`] of their tetrahedron.
    pub slivers: usize,
    /// The number of slivers without any volume.
    pub empty: usize,
    /// The number of edges that change sides with several points on them; the middle point is used.
    pub many: usize,
    /// The number of edges that change sides without a point on them; their middle is used.
    pub missing: usize,
    /// The inside share of each tetrahedron; `None` for those without pieces.
    pub shares: Vec<Option<f64>>,
    /// The number of connected parts of the pieces on each side, across faces: one if nothing is cut off.
    pub parts: [usize; 2],
}

/// The volume share of its tetrahedron below which a piece is a sliver.
pub const SLIVER: f64 = 1e-6;

impl Pieces {
    /// A planted fault: exchanges the least share of these tetrahedra with the largest.
    ///
    /// All tetrahedra of a lattice have one volume, so the total stays the same.
    pub fn exchange(&mut self, tetrahedra: impl Iterator<Item = usize>) {
        let known = tetrahedra.filter_map(|at| Some((at, self.shares[at]?)));
        let mut sorted: Vec<(usize, f64)> = known.collect();
        sorted.sort_by(|(_, a), (_, b)| a.total_cmp(b));
        if let [(least, _), .., (most, _)] = sorted[..] {
            self.shares.swap(least, most);
        }
    }
}

/// Cuts each tetrahedron.
///
/// A piece is the part on one side of the surface through the points on its edges; a quadrilateral is divided along the
/// diagonal from its first vertex. Volumes are sums of doubles: each is off by a few ε of its tetrahedron's.
///
/// # Panics
/// If the sides are of another lattice.
#[must_use]
pub fn pieces(scene: &Scene, lattice: &Complex, sides: &Sides) -> Pieces {
    let place = |v: Vertex| lattice.vertices().binary_search(&v).expect("a tetrahedron's vertex");
    let mut all = Pieces { shares: vec![None; lattice.tetrahedra().len()], ..Pieces::default() };
    let mut contradicted = vec![false; lattice.edges().len()];
    sides.contradicted.iter().for_each(|&edge| contradicted[edge as usize] = true);
    for (at, edge) in lattice.edges().iter().enumerate() {
        if let [Some(p), Some(q)] = edge.map(|v| sides.inside[place(v)])
            && p != q
        {
            all.many += usize::from(sides.points[at].len() > 1);
            all.missing += usize::from(sides.points[at].is_empty());
        }
    }
    let mut has = vec![[false; 2]; lattice.tetrahedra().len()];
    for (at, &corners) in lattice.tetrahedra().iter().enumerate() {
        let whole = volume(scene, corners);
        let edge = |i: usize, j: usize| {
            let [first, second] = [i.min(j), i.max(j)];
            lattice.find(&[corners[first], corners[second]]).expect("an edge of the tetrahedron").index as usize
        };
        let six = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]].map(|[i, j]| edge(i, j));
        if six.iter().any(|&edge| contradicted[edge]) {
            all.inconsistent += 1;
            all.lost += whole;
            continue;
        }
        // The position of the surface on the edge from one corner to the other, as a share of the way.
        let share = |i: usize, j: usize| {
            let points = &sides.points[edge(i, j)];
            let t = points.get(points.len() / 2).copied().unwrap_or(0.5);
            if i < j { t } else { 1.0 - t }
        };
        let of_corners = corners.map(place).map(|at| sides.inside[at]);
        let Some(inside) = fraction(of_corners, share) else {
            all.undecided += 1;
            all.lost += whole;
            continue;
        };
        let parts = [inside, 1.0 - inside];
        let there = [true, false].map(|side| of_corners.contains(&Some(side)));
        has[at] = there;
        all.cut += usize::from(there == [true; 2]);
        for (part, there) in parts.into_iter().zip(there) {
            if there {
                all.sum += part * whole;
                all.slivers += usize::from(part < SLIVER);
                all.empty += usize::from(part <= 0.0);
            }
        }
        all.inside += inside * whole;
        all.shares[at] = Some(inside);
    }
    all.parts = [0, 1].map(|side| parts(lattice, sides, &has, side));
    all
}

/// The inside share of a tetrahedron; `None` if no corner is known to be off the surface.
fn fraction(of_corners: [Option<bool>; 4], share: impl Fn(usize, usize) -> f64) -> Option<f64> {
    let which = |side: Option<bool>| (0..4).filter(|&at| of_corners[at] == side).collect::<Vec<usize>>();
    let (inside, outside) = (which(Some(true)), which(Some(false)));
    // A corner cut off; the share to corners on the surface is 1.
    let corner = |at: usize, others: &[usize]| others.iter().map(|&other| share(at, other)).product::<f64>();
    Some(match (&inside[..], &outside[..]) {
        ([], []) => return None,
        (_, []) => 1.0,
        ([], _) => 0.0,
        (&[one], others) => corner(one, others),
        (others, &[one]) => 1.0 - corner(one, others),
        (&[a, b], &[c, d]) => {
            let point = |from: usize, to: usize| {
                let mut weights = [0.0; 4];
                weights[from] = 1.0 - share(from, to);
                weights[to] = share(from, to);
                weights
            };
            let unit = |at: usize| std::array::from_fn(|other| f64::from(u8::from(at == other)));
            let wedge = [unit(a), point(a, c), point(a, d), unit(b), point(b, c), point(b, d)];
            [[0, 1, 2, 3], [1, 2, 3, 4], [2, 3, 4, 5]]
                .into_iter()
                .map(|corners| determinant(corners.map(|at| wedge[at])).abs())
                .sum()
        }
        _ => unreachable!("four corners"),
    })
}

/// The signed volume of a tetrahedron with these barycentric coordinates, as a share.
fn determinant(rows: [[f64; 4]; 4]) -> f64 {
    let minor = |columns: [usize; 2], [p, q]: [usize; 2]| {
        rows[p][columns[0]] * rows[q][columns[1]] - rows[p][columns[1]] * rows[q][columns[0]]
    };
    // By pairs of columns of the first two and the last two rows.
    let pairs = [
        ([0, 1], [2, 3], 1.0),
        ([0, 2], [1, 3], -1.0),
        ([0, 3], [1, 2], 1.0),
        ([1, 2], [0, 3], 1.0),
        ([1, 3], [0, 2], -1.0),
        ([2, 3], [0, 1], 1.0),
    ];
    pairs.into_iter().map(|(first, second, sign)| sign * minor(first, [0, 1]) * minor(second, [2, 3])).sum()
}

/// The volume of a tetrahedron: exact for tetrahedra of the lattice.
fn volume(scene: &Scene, corners: [Vertex; 4]) -> f64 {
    let [a, b, c, d] = corners.map(|v| scene.point3(v));
    let [u, v, w] = [b, c, d].map(|p| [0, 1, 2].map(|axis| p[axis] - a[axis]));
    let minor = |i: usize, j: usize| v[i] * w[j] - v[j] * w[i];
    (u[0] * minor(1, 2) + u[1] * minor(2, 0) + u[2] * minor(0, 1)).abs() / 6.0
}

/// The number of connected parts of the pieces on one side: across faces with a corner there.
fn parts(lattice: &Complex, sides: &Sides, has: &[[bool; 2]], side: usize) -> usize {
    let place = |v: &Vertex| lattice.vertices().binary_search(v).expect("a face's vertex");
    let mut first: Vec<Option<usize>> = vec![None; lattice.triangles().len()];
    let mut parent: Vec<usize> = (0..has.len()).collect();
    fn root(parent: &mut [usize], mut at: usize) -> usize {
        while parent[at] != at {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        at
    }
    for (at, &[a, b, c, d]) in lattice.tetrahedra().iter().enumerate() {
        if !has[at][side] {
            continue;
        }
        for face in [[a, b, c], [a, b, d], [a, c, d], [b, c, d]] {
            if !face.iter().any(|v| sides.inside[place(v)] == Some(side == 0)) {
                continue;
            }
            let face = lattice.find(&face).expect("a tetrahedron's face").index as usize;
            match first[face] {
                None => first[face] = Some(at),
                Some(other) => {
                    let [p, q] = [at, other].map(|at| root(&mut parent, at));
                    parent[p.max(q)] = p.min(q);
                }
            }
        }
    }
    (0..has.len()).filter(|&at| has[at][side] && parent[at] == at).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares with the volume below a plane through the midpoints.
    #[test]
    fn shares_of_known_cuts() {
        let half = |_: usize, _: usize| 0.5;
        let corners = |inside: [i8; 4]| inside.map(|side| (side != 0).then_some(side > 0));
        for (sides, share) in [
            ([1, -1, -1, -1], 0.125),
            ([1, 1, 1, -1], 0.875),
            ([1, 1, -1, -1], 0.5),
            ([-1, 1, -1, 1], 0.5),
            ([1, -1, 0, 0], 0.5),
            ([1, -1, -1, 0], 0.25),
            ([1, 1, -1, 0], 0.75),
            ([1, 1, 0, 0], 1.0),
            ([0, 0, 0, -1], 0.0),
        ] {
            assert_eq!(fraction(corners(sides), half), Some(share), "{sides:?}");
        }
        assert_eq!(fraction([None; 4], half), None);
        // A quarter of the way from the inside: the rest after four corners are cut off a plane.
        let quarter = |i: usize, j: usize| if i < j { 0.25 } else { 0.75 };
        let wedge = fraction(corners([1, 1, -1, -1]), quarter).unwrap();
        let other = fraction(corners([-1, -1, 1, 1]), quarter).unwrap();
        assert!((wedge - 0.15625).abs() < 1e-15 && (wedge + other - 1.0).abs() < 1e-15, "{wedge} {other}");
    }
}
