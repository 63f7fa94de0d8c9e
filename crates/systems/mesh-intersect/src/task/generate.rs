//! Pairs of meshes by size, and the placement of the second mesh.

use predicament_corpus::{Family, Making, Parts, Random, Recipe};
use predicament_formats::bits::{power_of_two, step};
use predicament_formats::{CorpusError, Fields};
use predicament_mesh::{MaterialMesh, OUTSIDE};
use predicament_predicates::Vertex;

use super::content::parts;
use super::shapes::{checkers, combs, crowd, needles, terrain};
use predicament_mesh_locate::task::generate::{lattice_of_tetrahedra, surface_of};
use predicament_mesh_locate::task::probes::Surface;
use predicament_tasks::solids::{self, Shape};
use predicament_tasks::typed::{FACES, Neighbours, TYPED_KEYS, typed};

/// The placement of the second mesh, a copy of the first.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Placed {
    /// Moved by fractions of its size with long binary expansions, so that nothing is degenerate.
    Apart,
    /// At the same position.
    Same,
    /// Moved by one, in x.
    Step,
    /// Each coordinate moved by one double.
    Ulp,
    /// Moved by 2^-30.
    Hair,
    /// Rotated by a quarter turn around z.
    Quarter,
    /// Rotated a little around z, and rounded.
    Turned,
    /// Moved by half a cell along each axis.
    Half,
    /// Scaled up by 1 + 2^-20 from the origin.
    Offset,
    /// Moved by two, in x: unit spheres touch in a vertex.
    Tangent,
    /// Moved by slightly less than two.
    Nearly,
    /// Scaled down by 2^40 around the origin.
    Tiny,
}

const PLACED: [(&str, Placed); 12] = [
    ("apart", Placed::Apart),
    ("same", Placed::Same),
    ("step", Placed::Step),
    ("ulp", Placed::Ulp),
    ("hair", Placed::Hair),
    ("quarter", Placed::Quarter),
    ("turned", Placed::Turned),
    ("half", Placed::Half),
    ("offset", Placed::Offset),
    ("tangent", Placed::Tangent),
    ("nearly", Placed::Nearly),
    ("tiny", Placed::Tiny),
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
pub(super) static FAMILIES: [Family; 11] = [
    family!("intersect-spheres", "two spheres of about n triangles each", sphere),
    family!("intersect-tori", "two tori of about n triangles each", torus),
    family!(
        "intersect-cubes",
        "two cubes of unit cells, about n triangles each: they share planes, edges, corners",
        cubes
    ),
    family!("intersect-combs", "two prisms over combs of about n corners", combs),
    family!("intersect-tetrahedra", "two lattices of tetrahedra, each a region, about n triangles each", tetrahedra),
    family!("intersect-shells", "two nests of cubes, every second cube a cavity, about n corners each", shells),
    family!("intersect-checkers", "two heaps of cubes that share edges and corners, about n triangles each", checkers),
    family!("intersect-needles", "two rows of long tetrahedra, about n triangles each", needles),
    family!("intersect-crowds", "two crowds of tetrahedra, about n triangles each", crowd),
    Family {
        name: "intersect-terrains",
        reported_as: Some("intersect-terrains"),
        parameters: &["ground"],
        about: "two solids under terrains of about n triangles each, over a common ground or apart",
        read: terrains,
    },
    Family {
        name: "intersect-blocks",
        reported_as: Some("intersect-blocks"),
        parameters: TYPED_KEYS,
        about: "blocks that share parts of faces as written in decimals, for `truth = \"decimals\"`",
        read: blocks,
    },
];

/// Two lists of blocks; a face of each block is on one of the other list.
fn blocks(_: &str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let typed = typed(fields)?;
    let make = move |making: &Making| {
        let Neighbours { written, points, count } = Neighbours::<3>::new(typed, making);
        let list = |at: usize| {
            let points: Vec<_> = points[at * 8 * count..][..8 * count].to_vec();
            let face = |block: usize| FACES.map(|face| face.map(|corner| Vertex::input(8 * block + corner)));
            let triangles: Vec<_> = (0..count).flat_map(face).collect();
            let mesh = MaterialMesh::of_closed(points.len(), triangles).expect("triangles of the points");
            Surface { points, mesh, tetrahedra: Vec::new() }
        };
        Parts { written: Some(written), ..parts([list(0), list(1)]) }
    };
    Ok(Recipe::new(|n| 3 * n + 48, make))
}

fn recipe(fields: &Fields<'_, '_>, shape: fn(usize, &mut Random) -> Surface) -> Result<Recipe, CorpusError> {
    let placed = match fields.get("placed") {
        None => Placed::Apart,
        Some(field) => {
            let name = field.str()?;
            let known = PLACED.iter().find(|(known, _)| *known == name).map(|(_, placed)| *placed);
            known.ok_or_else(|| {
                let names = PLACED.map(|(name, _)| format!("\"{name}\"")).join(", ");
                field.error(format!("unknown place of the second mesh `{name}`"), format!("use one of {names}"))
            })?
        }
    };
    let make = move |making: &Making| {
        let [first, mut second] = [(); 2].map(|()| shape(making.n, &mut making.random()));
        second.points.iter_mut().for_each(|point| *point = place(placed, *point));
        parts([first, second])
    };
    // There are at most as many vertices as triangles; a few are made even for the smallest n.
    Ok(Recipe::new(|n| 6 * (n + 200), make))
}

fn place(placed: Placed, [x, y, z]: [f64; 3]) -> [f64; 3] {
    match placed {
        Placed::Apart => [x + 1.0 / 3.0, y + 1.0 / 5.0, z + 1.0 / 7.0],
        Placed::Same => [x, y, z],
        Placed::Step => [x + 1.0, y, z],
        Placed::Ulp => [x, y, z].map(|x| step(x, 1)),
        Placed::Hair => [x, y, z].map(|x| x + power_of_two(-30)),
        Placed::Quarter => [-y, x, z],
        // A rotation by the angle whose tangent is 1/64, except for a factor near 1.
        Placed::Turned => [x - y / 64.0, y + x / 64.0, z + x / 128.0],
        Placed::Half => [x + 0.5, y + 0.5, z + 0.5],
        Placed::Offset => [x, y, z].map(|x| x + x * power_of_two(-20)),
        Placed::Tangent => [x + 2.0, y, z],
        Placed::Nearly => [x + (2.0 - power_of_two(-40)), y, z],
        Placed::Tiny => [x, y, z].map(|x| x * power_of_two(-40)),
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

fn tetrahedra(n: usize, _: &mut Random) -> Surface {
    lattice_of_tetrahedra(n)
}

fn shells(n: usize, rng: &mut Random) -> Surface {
    closed(solids::shells(n, rng))
}

/// Two terrains with different heights, over the same squares or over different ones.
fn terrains(_: &str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let is_shared = match fields.get("ground") {
        None => false,
        Some(field) => match field.str()? {
            "shared" => true,
            "apart" => false,
            other => return Err(field.error(format!("unknown ground `{other}`"), "use \"shared\" or \"apart\"")),
        },
    };
    let make = move |making: &Making| {
        let mut random = making.random();
        let [first, mut second] = [(); 2].map(|()| terrain(making.n, &mut random));
        if !is_shared {
            second.points.iter_mut().for_each(|point| *point = place(Placed::Apart, *point));
        }
        parts([first, second])
    };
    Ok(Recipe::new(|n| 6 * (n + 200), make))
}
