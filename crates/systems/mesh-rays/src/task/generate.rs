//! Generated meshes, with queries through their vertices and edges, along edges, in planes of faces, and anywhere.

use predicament_corpus::{Family, Making, Random, Recipe};
use predicament_formats::bits::integer;
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::Vertex;
use predicament_tasks::solids::{self, Shape};

use super::content::parts;
use super::read::extent;

/// Points and triangles.
type Mesh = (Vec<[f64; 3]>, Vec<[Vertex; 3]>);

macro_rules! family {
    ($name:literal, $about:literal, $mesh:path) => {
        Family {
            name: $name,
            reported_as: Some($name),
            parameters: &[],
            about: $about,
            read: |_, fields| recipe(fields, $mesh),
        }
    };
}

/// The families of meshes.
pub(super) static FAMILIES: [Family; 6] = [
    family!("rays-sphere", "a sphere of about n triangles", sphere),
    family!("rays-torus", "a torus of about n triangles", torus),
    family!("rays-lattice", "the surface of a cube of unit cells, of about n triangles", lattice),
    family!("rays-sheet", "a flat sheet of about n triangles, open: many rays are in its plane", sheet),
    family!("rays-cubes", "nested cubes, one double apart", cubes),
    family!("rays-soup", "n triangles with small integer coordinates, which cross each other", soup),
];

/// The most queries of a generated scene.
const MOST: u64 = 10_000_000;

fn recipe(fields: &Fields<'_, '_>, mesh: fn(usize, &mut Random) -> Mesh) -> Result<Recipe, CorpusError> {
    let count = fields.integer_or("shots", 24, 0..=MOST)?;
    let extent = extent(fields)?;
    let make = move |making: &Making| {
        let mut random = making.random();
        let (points, triangles) = mesh(making.n, &mut random);
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        let rays: Vec<[f64; 6]> = (0..count).map(|at| aimed(at, &points, &triangles, &mut random)).collect();
        parts(points, &triangles, &rays, extent)
    };
    // There are at most three vertices for each triangle; a few are made even for the smallest n.
    Ok(Recipe::new(move |n| 9 * (n + 100) + 6 * count, make))
}

/// A query by one of eight rules in turn.
fn aimed(at: usize, points: &[[f64; 3]], triangles: &[[Vertex; 3]], random: &mut Random) -> [f64; 6] {
    let last = |count: usize| i64::try_from(count).expect("scenes are smaller than memory") - 1;
    let mut pick = |count: usize| usize::try_from(random.integer(0, last(count))).expect("not negative");
    let [a, b, c] = triangles[pick(triangles.len())].map(|v| points[v.index()]);
    let other = points[triangles[pick(triangles.len())][0].index()];
    let size = points.as_flattened().iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    let anywhere = [0, 1, 2].map(|_: usize| random.between(-2.0, 2.0) * size);
    let inside = [0, 1, 2].map(|_: usize| random.between(-0.5, 0.5) * size);
    let by = |f: &dyn Fn(usize) -> f64| [0, 1, 2].map(f);
    let [p, q] = match at % 8 {
        0 => [anywhere, inside],
        1 => [anywhere, a],
        2 => [a, other],
        3 => [by(&|i| a[i] / 2.0 + b[i] / 2.0), other],
        4 => [a, b],
        5 => [by(&|i| if i == at / 8 % 3 { a[i] - 4.0 * size } else { a[i] }), a],
        6 => [by(&|i| 2.0 * a[i] - b[i]), a],
        _ => [by(&|i| 3.0 * a[i] - b[i] - c[i]), a],
    };
    let is_line = p != q && p.iter().chain(&q).all(|x| x.is_finite());
    let [p, q] = if is_line { [p, q] } else { [by(&|i| a[i] - size), by(&|i| a[i] + size)] };
    [p[0], p[1], p[2], q[0], q[1], q[2]]
}

/// The points of a shape, and its faces cut into triangles.
fn mesh(shape: Shape) -> Mesh {
    let triangles = shape.cut(Vertex::input);
    (shape.points, triangles)
}

fn sphere(n: usize, random: &mut Random) -> Mesh {
    mesh(solids::sphere(n, random))
}

fn torus(n: usize, random: &mut Random) -> Mesh {
    mesh(solids::torus(n, random))
}

fn lattice(n: usize, random: &mut Random) -> Mesh {
    mesh(solids::lattice(n / 2, random))
}

fn sheet(n: usize, _: &mut Random) -> Mesh {
    let side = (n / 2).isqrt().max(1);
    let count = |i: usize| integer(i64::try_from(i).expect("scenes are smaller than memory"));
    let points = (0..=side).flat_map(|x| (0..=side).map(move |y| [count(x), count(y), 0.0])).collect();
    let at = |x: usize, y: usize| Vertex::input(x * (side + 1) + y);
    let square = |x: usize, y: usize| {
        let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
        [[a, b, c], [a, c, d]]
    };
    let triangles = (0..side).flat_map(|x| (0..side).flat_map(move |y| square(x, y))).collect();
    (points, triangles)
}

fn cubes(n: usize, _: &mut Random) -> Mesh {
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    let mut half = 1.0_f64;
    for _ in 0..(n / 12).max(1) {
        let first = points.len();
        points.extend((0..8).map(|at| [0, 1, 2].map(|axis: usize| if at >> axis & 1 == 0 { -half } else { half })));
        for [a, b, c, d] in
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] as [[usize; 4]; 6]
        {
            triangles.extend([[a, b, c], [a, c, d]].map(|corners| corners.map(|v| Vertex::input(first + v))));
        }
        half = half.next_down();
    }
    (points, triangles)
}

fn soup(n: usize, random: &mut Random) -> Mesh {
    let mut points = Vec::with_capacity(3 * n);
    while points.len() < 3 * n.max(1) {
        let [a, b, c] = [0, 1, 2].map(|_: usize| [0, 1, 2].map(|_: usize| integer(random.integer(-4, 4))));
        if a != b && b != c && c != a {
            points.extend([a, b, c]);
        }
    }
    let triangles = (0..points.len() / 3).map(|at| [3 * at, 3 * at + 1, 3 * at + 2].map(Vertex::input)).collect();
    (points, triangles)
}
