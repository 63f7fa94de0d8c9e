//! Generated multi-material meshes of a given size.

use predicament_corpus::{Family, Making, Random, Recipe};
use predicament_formats::bits::{integer, power_of_two};
use predicament_formats::{CorpusError, Fields};
use predicament_mesh::{MaterialMesh, OUTSIDE};
use predicament_predicates::Vertex;

use super::probes::{Probing, Surface, with_probes};
use predicament_tasks::solids::{self, Shape};

/// Options: points may be rotated and moved.
#[derive(Clone, Copy)]
struct Changes {
    tilt: bool,
    jitter: bool,
}

macro_rules! family {
    ($name:literal, $about:literal, $parameters:expr, $shape:path) => {
        Family {
            name: $name,
            reported_as: Some($name),
            parameters: $parameters,
            about: $about,
            read: |_, fields| recipe(fields, $shape),
        }
    };
}

/// The families of meshes.
pub(super) static FAMILIES: [Family; 7] = [
    family!("locate-sphere", "a sphere of about n triangles", &[], sphere),
    family!("locate-torus", "a torus of about n triangles", &[], torus),
    family!("locate-boxes", "boxes with common faces, each a region", &["tilt"], boxes),
    family!("locate-tetrahedra", "a lattice of tetrahedra, each a region", &["tilt", "jitter"], tetrahedra),
    family!("locate-shells", "two spheres, 2^-40 of their radius apart", &[], shells),
    family!("locate-cubes", "nested cubes, one double apart", &[], cubes),
    family!("locate-needles", "n / 4 tetrahedra, a million times as long as wide, across the axes", &[], needles),
];

fn recipe(fields: &Fields<'_, '_>, shape: fn(usize, Changes, &mut Random) -> Surface) -> Result<Recipe, CorpusError> {
    let probing = Probing::read(fields)?;
    let changes = Changes { tilt: fields.bool_or("tilt", false)?, jitter: fields.bool_or("jitter", false)? };
    let probes = probing.clone();
    let make = move |making: &Making| {
        with_probes(shape(making.n, changes, &mut making.random()), None, &probing, making.level)
    };
    // There are at most as many vertices as triangles; a few are made even for the smallest n.
    Ok(Recipe::new(move |n| 3 * (n + 100 + probes.count(n + 100)), make))
}

/// The triangles of faces, with the given regions in front and behind.
fn triangles(faces: &Shape, first: usize, sides: [u32; 2]) -> (Vec<[Vertex; 3]>, Vec<[u32; 2]>) {
    let vertex = |corner: u32| Vertex::input(first + corner as usize);
    let fan = |corners: &[u32]| {
        let (a, rest) = corners.split_first().expect("a face has corners");
        rest.windows(2).map(|next| [*a, next[0], next[1]].map(vertex)).collect::<Vec<_>>()
    };
    let triangles: Vec<[Vertex; 3]> = faces.faces.iter().flat_map(fan).collect();
    let sides = vec![sides; triangles.len()];
    (triangles, sides)
}

/// Builds closed surfaces, each with the regions outside and inside it.
fn surfaces(shapes: Vec<(Shape, [u32; 2])>) -> Surface {
    let (mut points, mut corners, mut sides) = (Vec::new(), Vec::new(), Vec::new());
    for (shape, regions) in shapes {
        let (of_shape, of_sides) = triangles(&shape, points.len(), regions);
        corners.extend(of_shape);
        sides.extend(of_sides);
        points.extend(shape.points);
    }
    let mesh = MaterialMesh::new(points.len(), corners, sides);
    Surface {
        mesh: mesh.unwrap_or_else(|why| panic!("the generated mesh is invalid: {why}")),
        points,
        tetrahedra: Vec::new(),
    }
}

/// Builds a closed surface with the given regions outside and inside it.
pub fn surface_of(shape: Shape, sides: [u32; 2]) -> Surface {
    surfaces(vec![(shape, sides)])
}

/// A lattice of tetrahedra with about n faces.
pub fn lattice_of_tetrahedra(n: usize) -> Surface {
    let Lattice { points, tetrahedra } = lattice(side(n, 12));
    of_tetrahedra(points, tetrahedra.into_iter().map(|(corners, _)| corners).collect())
}

fn sphere(n: usize, _: Changes, rng: &mut Random) -> Surface {
    surfaces(vec![(solids::sphere(n, rng), [OUTSIDE, 1])])
}

fn torus(n: usize, _: Changes, rng: &mut Random) -> Surface {
    surfaces(vec![(solids::torus(n, rng), [OUTSIDE, 1])])
}

fn shells(n: usize, _: Changes, rng: &mut Random) -> Surface {
    let outer = solids::sphere(n / 2, rng);
    let mut inner = solids::sphere(n / 2, rng);
    for x in inner.points.as_flattened_mut() {
        *x *= 1.0 - power_of_two(-40);
    }
    surfaces(vec![(outer, [OUTSIDE, 1]), (inner, [1, 2])])
}

fn cubes(n: usize, _: Changes, _: &mut Random) -> Surface {
    let mut half = 1.0_f64;
    let mut shapes = Vec::new();
    for region in 1..=(n / 12).max(1) {
        let region = u32::try_from(region).expect("scenes are smaller than memory");
        let corner = |at: usize| [0, 1, 2].map(|axis: usize| if at >> axis & 1 == 0 { -half } else { half });
        let mut shape = Shape { points: (0..8).map(corner).collect(), ..Shape::default() };
        for square in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
            shape.faces.push(square);
        }
        shapes.push((shape, [region - 1, region]));
        half = half.next_down();
    }
    surfaces(shapes)
}

/// A lattice with the given number of cubes along each axis, six tetrahedra in each; returns each tetrahedron with its
/// cube's number.
struct Lattice {
    points: Vec<[f64; 3]>,
    tetrahedra: Vec<([Vertex; 4], usize)>,
}

fn lattice(side: usize) -> Lattice {
    let stride = side + 1;
    let at = |[x, y, z]: [usize; 3]| Vertex::input((x * stride + y) * stride + z);
    let count = |i: usize| integer(i64::try_from(i).expect("scenes are smaller than memory"));
    let mut points = Vec::with_capacity(stride.pow(3));
    for x in 0..stride {
        for y in 0..stride {
            points.extend((0..stride).map(|z| [x, y, z].map(count)));
        }
    }
    let mut tetrahedra = Vec::with_capacity(6 * side.pow(3));
    for cube in 0..side.pow(3) {
        let origin = [cube / side / side, cube / side % side, cube % side];
        for (order, is_even) in [
            ([0, 1, 2], true),
            ([1, 2, 0], true),
            ([2, 0, 1], true),
            ([1, 0, 2], false),
            ([0, 2, 1], false),
            ([2, 1, 0], false),
        ] {
            // From a corner to the opposite one, one axis after the other.
            let mut corner = origin;
            let mut corners = [at(corner); 4];
            for (axis, next) in order.into_iter().zip(&mut corners[1..]) {
                corner[axis] += 1;
                *next = at(corner);
            }
            if is_even {
                corners.swap(0, 1);
            }
            tetrahedra.push((corners, cube));
        }
    }
    Lattice { points, tetrahedra }
}

/// The side of a lattice that has about n triangles, with `each` triangles for each cube.
fn side(n: usize, each: usize) -> usize {
    let mut side = 1;
    while each * (side + 1_usize).pow(3) <= n {
        side += 1;
    }
    side
}

/// Two rotations whose sines and cosines are 3/5 and 4/5, times 25: integers stay integers.
fn turned([x, y, z]: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = [3.0 * x + 4.0 * y, 3.0 * y - 4.0 * x, 5.0 * z];
    [5.0 * x, 3.0 * y + 4.0 * z, 3.0 * z - 4.0 * y]
}

fn of_tetrahedra(points: Vec<[f64; 3]>, tetrahedra: Vec<[Vertex; 4]>) -> Surface {
    let mesh = MaterialMesh::of_tetrahedra(points.len(), &tetrahedra);
    Surface { mesh: mesh.unwrap_or_else(|why| panic!("the generated mesh is invalid: {why}")), points, tetrahedra }
}

fn tetrahedra(n: usize, changes: Changes, rng: &mut Random) -> Surface {
    let Lattice { mut points, tetrahedra } = lattice(side(n, 12));
    for point in &mut points {
        if changes.jitter {
            // Less than a twelfth: no tetrahedron of the lattice changes its orientation.
            *point = point.map(|x| x + rng.between(-0.0625, 0.0625));
        }
        if changes.tilt {
            *point = turned(*point);
        }
    }
    of_tetrahedra(points, tetrahedra.into_iter().map(|(corners, _)| corners).collect())
}

/// Boxes of a lattice with planes at uneven distances; only faces between boxes are kept.
fn boxes(n: usize, changes: Changes, rng: &mut Random) -> Surface {
    let side = side(n, 6);
    let Lattice { mut points, tetrahedra } = lattice(side);
    let mut planes = [(); 3].map(|()| vec![0.0]);
    for planes in &mut planes {
        for at in 0..side {
            planes.push(planes[at] + integer(rng.integer(1, 16)));
        }
    }
    let stride = side + 1;
    for (at, point) in points.iter_mut().enumerate() {
        let place = [at / stride / stride, at / stride % stride, at % stride];
        *point = [0, 1, 2].map(|axis: usize| planes[axis][place[axis]]);
        if changes.tilt {
            *point = turned(*point);
        }
    }
    let corners: Vec<[Vertex; 4]> = tetrahedra.iter().map(|(corners, _)| *corners).collect();
    let whole = of_tetrahedra(points, corners);
    let region = |of: u32| match of {
        OUTSIDE => OUTSIDE,
        of => u32::try_from(tetrahedra[of as usize - 1].1 + 1).expect("fewer cubes than tetrahedra"),
    };
    let (mut corners, mut sides) = (Vec::new(), Vec::new());
    for (triangle, of) in whole.mesh.triangles().iter().zip(whole.mesh.sides()) {
        let of = of.map(region);
        if of[0] != of[1] {
            corners.push(*triangle);
            sides.push(of);
        }
    }
    let mesh = MaterialMesh::new(whole.points.len(), corners, sides);
    Surface {
        mesh: mesh.unwrap_or_else(|why| panic!("the generated mesh is invalid: {why}")),
        points: whole.points,
        tetrahedra: Vec::new(),
    }
}

fn needles(n: usize, _: Changes, rng: &mut Random) -> Surface {
    let side = (n / 4).isqrt().max(1);
    let (mut points, mut tetrahedra) = (Vec::new(), Vec::new());
    let count = |i: usize| integer(i64::try_from(4 * i).expect("scenes are smaller than memory"));
    for place in 0..side * side {
        let [x, y] = [place / side, place % side].map(count);
        let first = points.len();
        let tip = [x + integer(rng.integer(0, 1)), y + integer(rng.integer(0, 1)), power_of_two(20)];
        points.extend([[x, y, 0.0], [x + 1.0, y, 0.0], [x, y + 1.0, 0.0], tip].map(turned));
        // The tip is above the three corners, which are counterclockwise from there.
        tetrahedra.push([1, 0, 2, 3].map(|corner| Vertex::input(first + corner)));
    }
    of_tetrahedra(points, tetrahedra)
}
