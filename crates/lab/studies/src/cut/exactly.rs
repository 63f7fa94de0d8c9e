//! The expected inside share of each tetrahedron, in rationals.
//!
//! A total can be right while its parts are not: one tetrahedron can lack what another has too much. So tetrahedra are
//! compared one by one with the result of the exact contacts. The contacts are the judge's, by linear equations in
//! rationals. The side of a corner is found by a ray in rationals. The volume of the same piece is computed in
//! rationals.

use std::collections::{BTreeMap, BTreeSet};

use predicament_judge::contacts::contacts;
use predicament_judge::solids::{Materials, Place};
use predicament_mesh::Complex;
use predicament_predicates::{Scene, Vertex};
use rug::Rational;

/// Exact shares of some tetrahedra.
#[derive(Clone, Debug, Default)]
pub struct Exactly {
    /// The number of tetrahedra in cubes that the surface's triangles reach into; the sample is taken from these.
    pub near: usize,
    /// The indices of the sampled tetrahedra, with the inside share.
    ///
    /// `None` if all corners are on the surface, so that they do not tell the side.
    pub shares: Vec<(usize, Option<Rational>)>,
}

/// The deviation of shares from the exact ones.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Deviation {
    /// The number of compared tetrahedra.
    pub checked: usize,
    /// The number of tetrahedra that are off by more than [`ROUNDING`], or have no pieces.
    pub off: usize,
    /// The largest difference of two shares.
    pub furthest: f64,
}

/// The allowed deviation of a share: 2⁻⁴⁴ or 256 ε.
///
/// A weight that is rounded once is off by ε/2, and so is one minus it. A corner cut off is a product of three, off by
/// 3ε. A piece with two corners is a sum of three determinants of weights, each of six products of four numbers up to
/// one: eighteen products off by 4ε or less each, and as much for their sums.
pub const ROUNDING: f64 = 1.0 / 17_592_186_044_416.0;

impl Exactly {
    /// The exact shares of the tetrahedra of every cube that a triangle's box reaches into, `most` of them at even
    /// steps.
    ///
    /// # Panics
    /// If a tetrahedron of the lattice is not within a unit cube.
    #[must_use]
    pub fn new(scene: &Scene, [lattice, surface]: [&Complex; 2], most: usize) -> Exactly {
        let near = near(scene, lattice, surface);
        let step = near.len().div_ceil(most.max(1)).max(1);
        let chosen: Vec<usize> = near.iter().copied().step_by(step).take(most).collect();
        let tetrahedra: Vec<[Vertex; 4]> = chosen.iter().map(|&at| lattice.tetrahedra()[at]).collect();
        let edges: BTreeSet<[Vertex; 2]> =
            tetrahedra.iter().flat_map(|&corners| SIX.map(|e| edge(corners, e))).collect();
        let edges: Vec<[Vertex; 2]> = edges.into_iter().collect();
        let points = points(scene, &edges, surface);
        let corners: BTreeSet<Vertex> = tetrahedra.iter().flatten().copied().collect();
        let sides: BTreeMap<Vertex, Option<bool>> = corners.into_iter().map(|v| (v, side(scene, surface, v))).collect();
        let shares = chosen.into_iter().zip(tetrahedra).map(|(at, corners)| {
            let share = |i: usize, j: usize| {
                let on = &points[&edge(corners, [i.min(j), i.max(j)])];
                let t = on.get(on.len() / 2).cloned().unwrap_or_else(|| Rational::from((1, 2)));
                if corners[i] < corners[j] { t } else { 1 - t }
            };
            (at, inside(corners.map(|v| sides[&v]), share))
        });
        Exactly { near: near.len(), shares: shares.collect() }
    }

    /// The deviation of the shares of all tetrahedra from the known exact ones.
    #[must_use]
    pub fn hold(&self, shares: &[Option<f64>]) -> Deviation {
        let mut deviation = Deviation { checked: self.shares.len(), ..Deviation::default() };
        for (at, exact) in &self.shares {
            match (exact, shares[*at]) {
                (Some(exact), Some(got)) => {
                    let off = Rational::from_f64(got).map_or(f64::INFINITY, |got| (got - exact).abs().to_f64());
                    deviation.off += usize::from(off > ROUNDING);
                    deviation.furthest = deviation.furthest.max(off);
                }
                (Some(_), None) => deviation.off += 1,
                (None, _) => {}
            }
        }
        deviation
    }
}

/// The edges of a tetrahedron.
const SIX: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

fn edge(corners: [Vertex; 4], [i, j]: [usize; 2]) -> [Vertex; 2] {
    let [a, b] = [corners[i], corners[j]];
    [a.min(b), a.max(b)]
}

/// The least and the largest coordinates of some vertices.
fn bounds(scene: &Scene, vertices: &[Vertex]) -> [[f64; 2]; 3] {
    [0, 1, 2].map(|axis: usize| {
        let along = || vertices.iter().map(|&v| scene.point3(v)[axis]);
        [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)]
    })
}

/// The tetrahedra in unit cubes that meet the box of a triangle, borders included.
fn near(scene: &Scene, lattice: &Complex, surface: &Complex) -> Vec<usize> {
    #[allow(clippy::cast_possible_truncation)] // whole and small
    let whole = |x: f64| x.floor() as i64;
    let mut cubes: BTreeSet<[i64; 3]> = BTreeSet::new();
    for triangle in surface.triangles() {
        // A triangle on the border of cubes reaches into the cubes on both sides.
        let [x, y, z] = bounds(scene, triangle).map(|[low, high]| whole(low.ceil()) - 1..=whole(high));
        for i in x {
            for j in y.clone() {
                cubes.extend(z.clone().map(|k| [i, j, k]));
            }
        }
    }
    let is_near = |corners: &[Vertex; 4]| cubes.contains(&bounds(scene, corners).map(|[low, _]| whole(low)));
    (0..lattice.tetrahedra().len()).filter(|&at| is_near(&lattice.tetrahedra()[at])).collect()
}

/// The points of the surface on each edge: shares of the way from its first end, ascending.
fn points(scene: &Scene, edges: &[[Vertex; 2]], surface: &Complex) -> BTreeMap<[Vertex; 2], Vec<Rational>> {
    let vertices = surface.vertices().iter().map(std::slice::from_ref);
    let of_surface: Vec<&[Vertex]> = vertices
        .chain(surface.edges().iter().map(|edge| &edge[..]))
        .chain(surface.triangles().iter().map(|triangle| &triangle[..]))
        .collect();
    let mut points: BTreeMap<[Vertex; 2], Vec<Rational>> = edges.iter().map(|&edge| (edge, Vec::new())).collect();
    for contact in contacts(scene, edges, &of_surface) {
        let [on_edge, _] = contact.weights;
        let of_edge = points.get_mut(&edges[contact.pair[0]]).expect("an edge of the list");
        of_edge.extend(on_edge.into_iter().nth(1));
    }
    points.values_mut().for_each(|points| points.sort_unstable());
    points
}

/// Returns true if a vertex is inside of the surface, that is, below a sheet; `None` if it is on the surface.
///
/// # Panics
/// If every tried ray touches the border of a triangle.
fn side(scene: &Scene, surface: &Complex, q: Vertex) -> Option<bool> {
    let [x, y, _] = scene.point3(q);
    // Nearly vertical rays stay within less than 1 of the vertex as seen from above.
    let is_near = |triangle: &&[Vertex; 3]| {
        let [along_x, along_y, _] = bounds(scene, &triangle[..]);
        [(x, along_x), (y, along_y)].iter().all(|(x, [low, high])| low - 1.0 <= *x && *x <= high + 1.0)
    };
    let triangles: Vec<[Vertex; 3]> = surface.triangles().iter().filter(is_near).copied().collect();
    // Complexes do not say which side of a triangle is in front: each triangle that the ray passes changes the winding
    // of region 1 by one, up or down, and an odd winding is inside.
    let sides = vec![[0, 1]; triangles.len()];
    let materials = Materials::new(scene, &triangles, &sides);
    let rays = [[31, 17, 100_003], [-13, 41, 100_019], [7, -29, 100_043], [-37, -11, 100_057]];
    match rays.into_iter().find_map(|ray| materials.winding(q, ray)).expect("one of the rays passes beside all edges") {
        Place::On(_) => None,
        Place::In(region) => Some(region == 1),
        Place::Windings(windings) => Some(windings.iter().any(|&(region, winding)| region == 1 && winding % 2 != 0)),
    }
}

/// The share inside, by the sides of the corners; `None` if all are on the surface.
fn inside(sides: [Option<bool>; 4], share: impl Fn(usize, usize) -> Rational) -> Option<Rational> {
    let of = |side: bool| (0..4).filter(|&at| sides[at] == Some(side)).collect::<Vec<usize>>();
    let cut_off = |at: usize, others: &[usize]| -> Rational {
        others.iter().fold(Rational::from(1), |product, &other| product * share(at, other))
    };
    Some(match (&of(true)[..], &of(false)[..]) {
        ([], []) => return None,
        (_, []) => Rational::from(1),
        ([], _) => Rational::new(),
        (&[one], others) => cut_off(one, others),
        (others, &[one]) => 1 - cut_off(one, others),
        // Two and two: the part at the second corner beyond the first one's cut, and so on, as products.
        (&[a, b], &[c, d]) => {
            let [ac, ad, bc, bd] = [[a, c], [a, d], [b, c], [b, d]].map(|[from, to]| share(from, to));
            // Tetrahedra (a, ac, ad, b), (ac, ad, b, bc) and (ad, b, bc, bd) by their barycentric coordinates.
            let first = Rational::from(&ac * &ad);
            let second = Rational::from(1 - &ac) * &ad * &bc;
            let third = Rational::from(1 - &ad) * &bc * &bd;
            first + second + third
        }
        _ => unreachable!("four corners"),
    })
}
