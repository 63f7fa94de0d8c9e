//! Solids and planes through them.

use predicament_corpus::{Family, Making, Parts, Random, Recipe};
use predicament_formats::bits::step;
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{Dimension, Scene, Vertex};

use super::content::{is_line, solid};
use predicament_tasks::solids::{self, Shape};

/// The choice of a plane.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Cut {
    /// Through three vertices of the mesh.
    Vertices,
    /// Through a vertex, across an axis.
    Axis,
    /// Through three points of the box.
    Random,
    /// Through three points a few ulps from vertices.
    Near,
}

const CUTS: [(&str, Cut); 4] =
    [("vertices", Cut::Vertices), ("axis", Cut::Axis), ("random", Cut::Random), ("near", Cut::Near)];

const PARAMETERS: &[&str] = &["planes", "cut"];

macro_rules! family {
    ($name:literal, $about:literal, $shape:path) => {
        Family {
            name: $name,
            reported_as: Some($name),
            parameters: PARAMETERS,
            about: $about,
            read: |_, fields| recipe(fields, $shape),
        }
    };
}

/// The families of solids.
pub(super) static FAMILIES: [Family; 7] = [
    family!("slice-sphere", "a sphere of about n triangles, and planes through it", solids::sphere),
    family!("slice-torus", "a torus of about n triangles: caps of two loops, nested or not", solids::torus),
    family!(
        "slice-lattice",
        "a lattice cube with about n squares: planes along faces and through vertices",
        solids::lattice
    ),
    family!("slice-comb", "a comb of about n corners: two faces that a plane crosses many times", solids::comb),
    family!("slice-fold", "a folded band of about n corners, its creases on two lines", solids::fold),
    family!("slice-shells", "n / 6 nested cubes: caps of nested loops", solids::shells),
    family!("slice-terrain", "an open surface of about n triangles: its loops are not planar", solids::terrain),
];

fn recipe(fields: &Fields<'_, '_>, shape: fn(usize, &mut Random) -> Shape) -> Result<Recipe, CorpusError> {
    let planes = usize::try_from(fields.integer_or("planes", 3, 1..=10_000)?).unwrap_or(usize::MAX);
    let cut = match fields.get("cut") {
        None => Cut::Vertices,
        Some(field) => {
            let name = field.str()?;
            let known = CUTS.iter().find(|(known, _)| *known == name).map(|(_, cut)| *cut);
            known.ok_or_else(|| {
                let names = CUTS.map(|(name, _)| format!("\"{name}\"")).join(", ");
                field.error(format!("unknown way to choose planes `{name}`"), format!("use one of {names}"))
            })?
        }
    };
    let make = move |making: &Making| {
        let mut rng = making.random();
        let Shape { points, faces } = shape(making.n, &mut rng);
        let vertices = points.len();
        let mut coordinates = points;
        let planes = (0..planes).map(|_| plane(cut, &mut coordinates, vertices, &mut rng)).collect();
        let scene = Scene::new(Dimension::Three, coordinates.into_flattened()).expect("generators make finite points");
        let solid = solid(&scene, vertices, faces, planes);
        Parts::new(scene, solid.unwrap_or_else(|wrong| panic!("the generated solid is invalid: {wrong:?}")))
    };
    // A closed mesh has at most two vertices for each face; a few vertices are made even for the smallest n.
    Ok(Recipe::new(move |n| 6 * n + 9 * planes as u64 + 1000, make))
}

/// A plane through the first `vertices` points; other points that it needs are appended.
fn plane(cut: Cut, points: &mut Vec<[f64; 3]>, vertices: usize, rng: &mut Random) -> [Vertex; 3] {
    let last = i64::try_from(vertices - 1).expect("scenes are smaller than memory");
    let any = |rng: &mut Random| usize::try_from(rng.integer(0, last)).expect("not negative");
    let mut chosen: [[f64; 3]; 3];
    loop {
        let three = [(); 3].map(|()| any(rng));
        chosen = three.map(|at| points[at]);
        match cut {
            Cut::Vertices => {
                if !is_flat(&chosen) {
                    return three.map(Vertex::input);
                }
                continue;
            }
            Cut::Axis => {
                let axis = usize::try_from(rng.integer(0, 2)).expect("not negative");
                let size = points[..vertices].as_flattened().iter().fold(1.0_f64, |size, x| size.max(x.abs()));
                chosen = [chosen[0]; 3];
                chosen[1][(axis + 1) % 3] += size;
                chosen[2][(axis + 2) % 3] += size;
            }
            Cut::Random => {
                let others = [(); 3].map(|()| points[any(rng)]);
                for (p, q) in chosen.iter_mut().zip(others) {
                    *p = [0, 1, 2].map(|i| p[i] + rng.unit() * (q[i] - p[i]));
                }
            }
            // Zero does not change: the next doubles are a thousand binary digits away.
            Cut::Near => {
                chosen = chosen.map(|p| p.map(|x| if x == 0.0 { x } else { step(x, rng.integer(-2, 2)) }));
            }
        }
        if !is_flat(&chosen) {
            break;
        }
    }
    chosen.map(|point| {
        points.push(point);
        Vertex::input(points.len() - 1)
    })
}

/// True if three points are on a line.
fn is_flat(points: &[[f64; 3]; 3]) -> bool {
    let scene = Scene::from_points3(points).expect("generators make finite points");
    is_line(&scene, [0, 1, 2].map(Vertex::input))
}
