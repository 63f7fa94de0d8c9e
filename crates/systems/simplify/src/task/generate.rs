//! Generated meshes: smooth, flat, nearly flat, thin and open, of any size and place.

use predicament_corpus::{Family, Making, Parts, Random, Recipe};
use predicament_formats::bits::integer;
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{Dimension, Scene, Vertex};
use predicament_tasks::solids::{self, Shape};

use super::content::MeshToSimplify;

/// Points and triangles.
type Mesh = (Vec<[f64; 3]>, Vec<[usize; 3]>);

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
pub(super) static FAMILIES: [Family; 9] = [
    family!("simplify-sphere", "a sphere of about n triangles", sphere),
    family!("simplify-torus", "a torus of about n triangles: the handle stays", torus),
    family!(
        "simplify-lattice",
        "the surface of a cube of unit cells, of about n triangles: its sides are flat",
        lattice
    ),
    family!("simplify-facets", "the same cube, turned: its sides are flat but for rounding", facets),
    family!("simplify-terrain", "an open surface of about n triangles", terrain),
    family!("simplify-slab", "a box of about n triangles, as thick as the last bit of its width", slab),
    family!("simplify-needles", "two fans of n / 2 slivers around a thin axis", needles),
    family!("simplify-thread", "a tube of about n triangles around a segment, as thin as rounding makes it", thread),
    family!("simplify-strip", "a tube of about n triangles around a segment: none has an area", strip),
];

fn recipe(fields: &Fields<'_, '_>, mesh: fn(usize, &mut Random) -> Mesh) -> Result<Recipe, CorpusError> {
    let factor = |key| fields.get(key).map_or(Ok(1.0), |field| field.positive());
    let target = fields.get("target").map(|field| field.count(0..=u64::from(u32::MAX))).transpose()?;
    let (scale, flat) = (factor("scale")?, factor("flat")?);
    let far = fields.get("far").map_or(Ok(0.0), |field| field.positive())?;
    let make = move |making: &Making| {
        let (points, triangles) = mesh(making.n, &mut making.random());
        let place = |[x, y, z]: [f64; 3]| [x, y, z * flat].map(|x| x * scale + far);
        let coordinates: Vec<f64> = points.into_iter().flat_map(place).collect();
        let scene = Scene::new(Dimension::Three, coordinates).expect("`scale` and `far` keep points finite");
        let triangles: Vec<[Vertex; 3]> = triangles.iter().map(|corners| corners.map(Vertex::input)).collect();
        let target = target.unwrap_or(triangles.len() / 4);
        Parts::new(scene, MeshToSimplify { triangles, target })
    };
    // A mesh has at most two vertices for each triangle; a few are made even for the smallest n.
    Ok(Recipe::new(|n| 6 * n + 1000, make))
}

/// The points of a shape, and its faces cut into triangles.
fn mesh(shape: Shape) -> Mesh {
    let triangles = shape.cut(|corner| corner);
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

fn terrain(n: usize, random: &mut Random) -> Mesh {
    mesh(solids::terrain(n, random))
}

/// The lattice, turned by the angles of two Pythagorean triangles; its coordinates are rounded.
fn facets(n: usize, random: &mut Random) -> Mesh {
    let (points, triangles) = lattice(n, random);
    let turned = |[x, y, z]: [f64; 3]| {
        let [x, y] = [0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y];
        let [y, z] = [(5.0 * y - 12.0 * z) / 13.0, (12.0 * y + 5.0 * z) / 13.0];
        [x, y, z]
    };
    (points.into_iter().map(turned).collect(), triangles)
}

/// The number of a grid's points, as a double.
fn double(i: usize) -> f64 {
    integer(i64::try_from(i).expect("scenes are smaller than memory"))
}

/// Two grids of unit squares, an ulp of one above each other, and a wall around.
fn slab(n: usize, _: &mut Random) -> Mesh {
    let side = (n / 4).isqrt().max(1);
    let row = side + 1;
    let grid = |z: f64| (0..row).flat_map(move |x| (0..row).map(move |y| [double(x), double(y), z]));
    let points = grid(1.0).chain(grid(1.0_f64.next_up())).collect();
    let at = |layer: usize, x: usize, y: usize| (layer * row + x) * row + y;
    let mut triangles = Vec::new();
    let mut square = |[a, b, c, d]: [usize; 4]| triangles.extend([[a, b, c], [a, c, d]]);
    for x in 0..side {
        for y in 0..side {
            let around = |layer| [at(layer, x, y), at(layer, x + 1, y), at(layer, x + 1, y + 1), at(layer, x, y + 1)];
            square(around(1));
            let [a, b, c, d] = around(0);
            square([d, c, b, a]);
        }
    }
    for i in 0..side {
        for [p, q] in
            [[[i, 0], [i + 1, 0]], [[side, i], [side, i + 1]], [[i + 1, side], [i, side]], [[0, i + 1], [0, i]]]
        {
            square([at(0, p[0], p[1]), at(0, q[0], q[1]), at(1, q[0], q[1]), at(1, p[0], p[1])]);
        }
    }
    (points, triangles)
}

/// Points around an axis, joined to both of its ends. Their distance from the axis is far below its length.
fn needles(n: usize, random: &mut Random) -> Mesh {
    let count = (n / 2).max(3);
    let mut points = vec![[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]];
    // Along a square that stands on its tip.
    let around = |i: usize| {
        let (quarter, along) = (4 * i / count, double(4 * i % count) / double(count));
        let [x, y] = [1.0 - along, along];
        [[x, y], [-y, x], [-x, -y], [y, -x]][quarter]
    };
    points.extend((0..count).map(|i| {
        let [x, y] = around(i);
        let size = random.between(1.0, 2.0) / 1_099_511_627_776.0;
        [x * size, y * size, random.between(-0.5, 0.5)]
    }));
    let corner = |i: usize| 2 + i % count;
    let triangles = (0..count).flat_map(|i| [[0, corner(i + 1), corner(i)], [1, corner(i), corner(i + 1)]]).collect();
    (points, triangles)
}

/// A tube whose points are on one line but for rounding: every face is a sliver.
fn thread(n: usize, random: &mut Random) -> Mesh {
    let (points, triangles) = torus(n, random);
    let near_line = |_| {
        let along = random.unit();
        [along, along / 3.0, along / 7.0]
    };
    (points.into_iter().map(near_line).collect(), triangles)
}

/// A tube whose points are all on one line.
fn strip(n: usize, random: &mut Random) -> Mesh {
    let (points, triangles) = torus(n, random);
    let size = i64::try_from(points.len()).expect("scenes are smaller than memory");
    let on_line = |_| {
        let along = integer(random.integer(-size, size));
        [along, 2.0 * along, 3.0 * along]
    };
    (points.into_iter().map(on_line).collect(), triangles)
}
