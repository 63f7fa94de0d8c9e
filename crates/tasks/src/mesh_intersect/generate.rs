//! Pairs of meshes by size, and where the second one is.

use predicament_corpus::{Family, Making, Random, Recipe};
use predicament_formats::bits::{integer, power_of_two, step};
use predicament_formats::{CorpusError, Fields};
use predicament_mesh::{MaterialMesh, OUTSIDE};
use predicament_predicates::Vertex;

use super::content::parts;
use crate::mesh_locate::generate::{lattice_of_tetrahedra, surface_of};
use crate::mesh_locate::probes::Surface;
use crate::solids::{self, Shape};

/// Where the second mesh is, which is a copy of the first.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Placed {
    /// Moved by parts of its size that are not short in binary, so that nothing is degenerate.
    Apart,
    /// In the same place.
    Same,
    /// Moved by one, in x.
    Step,
    /// Each coordinate moved by one double.
    Ulp,
    /// Moved by 2^-30.
    Hair,
    /// Turned by a quarter around z.
    Quarter,
    /// Turned a little around z, and rounded.
    Turned,
}

const PLACED: [(&str, Placed); 7] = [
    ("apart", Placed::Apart),
    ("same", Placed::Same),
    ("step", Placed::Step),
    ("ulp", Placed::Ulp),
    ("hair", Placed::Hair),
    ("quarter", Placed::Quarter),
    ("turned", Placed::Turned),
];

macro_rules! family {
    ($name:literal, $about:literal, $shape:path) => {
        Family {
            name: $name,
            reported_as: Some($name),
            parameters: &["placed"],
            about: $about,
            read: |_, fields| recipe(fields, $shape),
        }
    };
}

/// The families of pairs.
pub(super) static FAMILIES: [Family; 5] = [
    family!("intersect-spheres", "two spheres of about n triangles each", sphere),
    family!("intersect-tori", "two tori of about n triangles each", torus),
    family!(
        "intersect-cubes",
        "two cubes of unit cells, about n triangles each: they share planes, edges, corners",
        cubes
    ),
    family!("intersect-combs", "two prisms over combs of about n corners", combs),
    family!("intersect-tetrahedra", "two lattices of tetrahedra, each a region, about n triangles each", tetrahedra),
];

fn recipe(fields: &Fields<'_, '_>, shape: fn(usize, &mut Random) -> Surface) -> Result<Recipe, CorpusError> {
    let placed = match fields.get("placed") {
        None => Placed::Apart,
        Some(field) => {
            let name = field.str()?;
            let known = PLACED.iter().find(|(known, _)| *known == name).map(|(_, placed)| *placed);
            known.ok_or_else(|| {
                let names = PLACED.map(|(name, _)| format!("\"{name}\"")).join(", ");
                field.error(format!("no place of the second mesh is called `{name}`"), format!("use one of {names}"))
            })?
        }
    };
    let make = move |making: &Making| {
        let [first, mut second] = [(); 2].map(|()| shape(making.n, &mut making.random()));
        second.points.iter_mut().for_each(|point| *point = place(placed, *point));
        parts([first, second])
    };
    // At most as many vertices as triangles; a few are made even for the smallest n.
    Ok(Recipe::new(make).with_coordinates(|n| 6 * (n + 200)))
}

fn place(placed: Placed, [x, y, z]: [f64; 3]) -> [f64; 3] {
    match placed {
        Placed::Apart => [x + 1.0 / 3.0, y + 1.0 / 5.0, z + 1.0 / 7.0],
        Placed::Same => [x, y, z],
        Placed::Step => [x + 1.0, y, z],
        Placed::Ulp => [x, y, z].map(|x| step(x, 1)),
        Placed::Hair => [x, y, z].map(|x| x + power_of_two(-30)),
        Placed::Quarter => [-y, x, z],
        // A rotation by the angle whose tangent is 1/64, but for a factor near 1.
        Placed::Turned => [x - y / 64.0, y + x / 64.0, z + x / 128.0],
    }
}

fn closed(shape: Shape) -> Surface {
    surface_of(shape, [OUTSIDE, 1])
}

fn sphere(n: usize, rng: &mut Random) -> Surface {
    closed(solids::sphere(n, rng))
}

fn torus(n: usize, rng: &mut Random) -> Surface {
    closed(solids::torus(n, rng))
}

fn cubes(n: usize, rng: &mut Random) -> Surface {
    closed(solids::lattice(n / 2, rng))
}

/// A prism whose bottom and top are triangulated by the strips between its teeth, which all end on the same lines.
fn combs(n: usize, _: &mut Random) -> Surface {
    let teeth = (n / 24).max(1);
    let (mut points, mut corners): (Vec<[f64; 3]>, Vec<[Vertex; 3]>) = (Vec::new(), Vec::new());
    let count = |i: usize| integer(i64::try_from(i).expect("scenes are smaller than memory"));
    // Lines of vertices along the comb: its back, where teeth begin, and where they end, at the bottom and at the top.
    let line = |points: &mut Vec<[f64; 3]>, y: f64, z: f64| -> Vec<Vertex> {
        (0..2 * teeth)
            .map(|at| {
                points.push([count(at), y, z]);
                Vertex::input(points.len() - 1)
            })
            .collect()
    };
    let [low, high] = [0.0, 1.0].map(|z| [-1.0, 0.0, 4.0].map(|y| line(&mut points, y, z)));
    let mut square = |[a, b, c, d]: [Vertex; 4]| corners.extend([[a, b, c], [a, c, d]]);
    let [low_back, low_root, low_tip] = &low;
    let [high_back, high_root, high_tip] = &high;
    let last = 2 * teeth - 1;
    for at in 0..last {
        let next = at + 1;
        square([high_back[at], high_back[next], high_root[next], high_root[at]]);
        square([low_root[at], low_root[next], low_back[next], low_back[at]]);
        square([low_back[at], low_back[next], high_back[next], high_back[at]]);
        if at % 2 == 0 {
            square([high_root[at], high_root[next], high_tip[next], high_tip[at]]);
            square([low_tip[at], low_tip[next], low_root[next], low_root[at]]);
            square([low_tip[next], low_tip[at], high_tip[at], high_tip[next]]);
            square([low_tip[at], low_root[at], high_root[at], high_tip[at]]);
            square([low_root[next], low_tip[next], high_tip[next], high_root[next]]);
        } else {
            square([low_root[next], low_root[at], high_root[at], high_root[next]]);
        }
    }
    square([low_root[0], low_back[0], high_back[0], high_root[0]]);
    square([low_back[last], low_root[last], high_root[last], high_back[last]]);
    let mesh = MaterialMesh::of_closed(points.len(), corners);
    Surface {
        mesh: mesh.unwrap_or_else(|why| panic!("a generator made no mesh: {why}")),
        points,
        tetrahedra: Vec::new(),
    }
}

fn tetrahedra(n: usize, _: &mut Random) -> Surface {
    lattice_of_tetrahedra(n)
}
