//! A lattice of tetrahedra, and surfaces that cut it.
//!
//! The lattice has integer points, n cubes along each axis with six tetrahedra each. The triangles of a surface are
//! about as large as the faces of the lattice, so each cut tetrahedron meets a few of them.

use predicament_contacts::task::Complexes;
use predicament_corpus::Random;
use predicament_formats::bits::{integer, rounded};
use predicament_mesh::{Complex, Simplices};
use predicament_predicates::Vertex;
use rug::Rational;

use super::volume;

type Point = [f64; 3];

/// The number of bits of coordinates, which either precision can represent.
const BITS: u32 = 24;

/// The surface that cuts the lattice.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, clap::ValueEnum)]
pub enum Shape {
    /// A flat sheet, wider than the lattice; the inside is below it.
    Plane,
    /// A sheet with waves of eight cubes.
    Wave,
    /// A ball of two fifths of the lattice; in degenerate placement an octahedron.
    Sphere,
}

/// The placement of the surface in the lattice.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, clap::ValueEnum)]
pub enum Placement {
    /// General position.
    General,
    /// The surface's vertices are vertices of the lattice.
    Degenerate,
    /// The same as `Degenerate`, with each vertex moved by at most σ along each axis.
    Near,
}

impl Shape {
    /// All shapes, in the order of reports.
    pub const ALL: [Shape; 3] = [Shape::Plane, Shape::Wave, Shape::Sphere];

    /// The shape's name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Shape::Plane => "plane",
            Shape::Wave => "wave",
            Shape::Sphere => "sphere",
        }
    }
}

impl Placement {
    /// All placements, in the order of reports.
    pub const ALL: [Placement; 3] = [Placement::General, Placement::Degenerate, Placement::Near];

    /// The placement's name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Placement::General => "general",
            Placement::Degenerate => "degenerate",
            Placement::Near => "near",
        }
    }
}

/// A lattice with a surface.
#[derive(Clone, Debug)]
pub struct Scene {
    /// All points, with the lattice's first.
    pub scene: predicament_predicates::Scene,
    /// The lattice and the surface.
    pub complexes: Complexes,
    /// The volume of the lattice that is inside of the surface, exactly.
    pub inside: Rational,
}

impl Scene {
    /// The lattice of n³ cubes, with a surface.
    ///
    /// # Panics
    /// If there are fewer than four or more than 1,000 cubes along an axis.
    #[must_use]
    pub fn new(shape: Shape, placement: Placement, cubes: u32, seed: u64) -> Scene {
        assert!((4..=1000).contains(&cubes), "4 to 1000 cubes along each axis");
        let mut rng = Random::new(&format!("cut/{}/{}", shape.name(), placement.name()), "contacts3d", seed);
        let (mut points, tetrahedra) = lattice(cubes);
        let (surface, triangles) = match shape {
            Shape::Sphere => sphere(placement, cubes, &mut rng),
            Shape::Plane | Shape::Wave => sheet(shape, placement, cubes, &mut rng),
        };
        let surface: Vec<Point> = surface.into_iter().map(|point| point.map(|x| rounded(x, BITS))).collect();
        let corners: Vec<[Point; 3]> = triangles.iter().map(|triangle| triangle.map(|at| surface[at])).collect();
        let inside = match shape {
            Shape::Sphere => volume::enclosed(&corners),
            Shape::Plane | Shape::Wave => volume::below(&corners, cubes),
        };
        let first = points.len();
        points.extend(surface);
        let scene = predicament_predicates::Scene::from_points3(&points).expect("coordinates are finite");
        let complex = |given: &Simplices| Complex::new(&scene, given).expect("simplices of the scene");
        let a = complex(&Simplices { tetrahedra, ..Simplices::default() });
        let triangles = triangles.into_iter().map(|triangle| triangle.map(|at| Vertex::input(first + at))).collect();
        let b = complex(&Simplices { triangles, ..Simplices::default() });
        let (scene, complexes) = Complexes { a, b }.in_scene(scene);
        Scene { scene, complexes, inside }
    }
}

/// The lattice: its points and tetrahedra.
///
/// Tetrahedra go from a corner of a cube to the opposite one along one axis after the other.
fn lattice(cubes: u32) -> (Vec<Point>, Vec<[Vertex; 4]>) {
    let cubes = cubes as usize;
    let stride = cubes + 1;
    let number = |[x, y, z]: [usize; 3]| Vertex::input((x * stride + y) * stride + z);
    let each = |count: usize| (0..count.pow(3)).map(move |at| [at / count / count, at / count % count, at % count]);
    let points = each(stride).map(|place| place.map(whole)).collect();
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let tetrahedra = each(cubes).flat_map(|origin| {
        orders.map(|order| {
            let mut corner = origin;
            let mut corners = [number(origin); 4];
            for (axis, place) in order.into_iter().zip(&mut corners[1..]) {
                corner[axis] += 1;
                *place = number(corner);
            }
            corners
        })
    });
    (points, tetrahedra.collect())
}

fn whole(count: usize) -> f64 {
    integer(i64::try_from(count).expect("small counts"))
}

/// σ of the scheme for triangles of this size beside the lattice's, in double precision.
const SIGMA: f64 = 6.5 / 8192.0 * 2.0;

/// The random offset of a coordinate in near placement.
fn aside(placement: Placement, rng: &mut Random) -> f64 {
    if placement == Placement::Near { SIGMA * rng.between(-1.0, 1.0) } else { 0.0 }
}

/// A sheet of squares, wider than the lattice by two cubes.
///
/// Its height is about half of the lattice's.
fn sheet(shape: Shape, placement: Placement, cubes: u32, rng: &mut Random) -> (Vec<Point>, Vec<[usize; 3]>) {
    let side = cubes as usize + 5;
    let middle = whole(cubes as usize / 2);
    let offset = match placement {
        Placement::General => [0, 1, 2].map(|_| rng.between(0.1, 0.4)),
        Placement::Degenerate | Placement::Near => [0.0; 3],
    };
    let mut points = Vec::with_capacity(side * side);
    for i in 0..side {
        for j in 0..side {
            let waves = match shape {
                // From -1 to 1 and back in eight steps, in two directions.
                Shape::Wave => [i, i + j].map(|at| (whole(at % 8) - 4.0).abs() / 2.0 - 1.0).iter().sum::<f64>(),
                Shape::Plane | Shape::Sphere => 0.0,
            };
            // In general position it is tilted as well.
            let tilt = offset[0] * (whole(i) + 0.5 * whole(j)) / whole(side);
            let height = if placement == Placement::General { waves } else { waves.round() };
            let place = [whole(i) - 2.0 + offset[0], whole(j) - 2.0 + offset[1], middle + height + offset[2] + tilt];
            points.push(place.map(|x| x + aside(placement, rng)));
        }
    }
    let mut triangles = Vec::new();
    for i in 0..side - 1 {
        for j in 0..side - 1 {
            let [a, b, c, d] = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[k, l]| (i + k) * side + j + l);
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    (points, triangles)
}

/// An octahedron with its faces divided at integer points.
///
/// Unless the placement is degenerate, it is pushed out to a sphere.
fn sphere(placement: Placement, cubes: u32, rng: &mut Random) -> (Vec<Point>, Vec<[usize; 3]>) {
    let radius = i64::from(cubes * 2 / 5).max(1);
    let middle = whole(cubes as usize / 2);
    let offset = match placement {
        Placement::General => [0, 1, 2].map(|_| rng.between(0.1, 0.4)),
        Placement::Degenerate | Placement::Near => [0.0; 3],
    };
    let mut numbers = std::collections::BTreeMap::new();
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    for octant in 0..8 {
        let signs: [i64; 3] = std::array::from_fn(|axis| if octant >> axis & 1 == 0 { 1 } else { -1 });
        let mut vertex = |i: i64, j: i64| {
            let place = [i * signs[0], j * signs[1], (radius - i - j) * signs[2]];
            *numbers.entry(place).or_insert_with(|| {
                let place = place.map(integer);
                let length = place.iter().map(|x| x * x).sum::<f64>().sqrt();
                let out = if placement == Placement::General { integer(radius) / length } else { 1.0 };
                points.push([0, 1, 2].map(|axis| middle + offset[axis] + out * place[axis] + aside(placement, rng)));
                points.len() - 1
            })
        };
        for i in 0..radius {
            for j in 0..radius - i {
                let mut faces = vec![[vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)]];
                if i + j + 1 < radius {
                    faces.push([vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]);
                }
                // All are wound the same way, seen from outside.
                let flip = signs.iter().product::<i64>() < 0;
                triangles.extend(faces.into_iter().map(|[a, b, c]| if flip { [a, c, b] } else { [a, b, c] }));
            }
        }
    }
    (points, triangles)
}
