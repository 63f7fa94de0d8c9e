//! Generators of two complexes that touch: curves in the plane, surfaces in space.
//!
//! The complexes meet everywhere: every edge is short and has a few of the other complex' edges around it. So a scene
//! of n primitives has about n relevant pairs, for any n.

mod polygons;
mod surfaces;
pub mod thresholds;
mod typed;

use predicament_corpus::{Family, Parts, Random, Recipe};
use predicament_formats::bits::rounded;
use predicament_formats::{CorpusError, Fields};
use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Dimension, Scene, Vertex};
use predicament_tasks::typed::TYPED_KEYS;

use super::content::{Complexes, moved, shifted};
use super::sigma::sigma;

/// Reads `shift`, in units of σ.
fn shift(fields: &Fields<'_, '_>) -> Result<f64, CorpusError> {
    fields.required("shift")?.positive()
}

/// Reads `bits`, the significant bits of coordinates.
fn bits(fields: &Fields<'_, '_>) -> Result<u32, CorpusError> {
    fields.integer_or("bits", 53, 24..=53).map(|bits| u32::try_from(bits).unwrap_or(53))
}

type Read = fn(task: &'static str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError>;

/// A family of scenes. The cost of contacts depends on the scene's size and on the distances, so each scene is reported
/// as a separate family.
const fn family(name: &'static str, parameters: &'static [&'static str], about: &'static str, read: Read) -> Family {
    Family { name, reported_as: None, parameters, about, read }
}

/// The families of complexes in the plane.
pub(super) static PLANE: [Family; 6] = [
    family(
        "polygons-uniform",
        &["bits"],
        "two simple polygons that cross all around, in general position",
        |_, fields| Ok(Pair::PolygonsUniform(bits(fields)?).recipe()),
    ),
    family(
        "polygons-near",
        &[],
        "two polygons; vertices of one are within a few sigma of vertices and edges of the other",
        |_, _| Ok(Pair::PolygonsNear.recipe()),
    ),
    family(
        "polygons-degen",
        &[],
        "skylines on integers: shared vertices, vertices on edges, overlapping edges",
        |_, _| Ok(Pair::PolygonsDegen.recipe()),
    ),
    family("copy-shifted", &["shift"], "a polygon and a copy of it, moved by a number of sigma", |_, fields| {
        Ok(Pair::CopyShifted(shift(fields)?).recipe())
    }),
    family("thresholds-plane", &[], "pairs at the tolerances of Algorithms 2 to 5", |_, _| {
        Ok(Pair::Thresholds(Dimension::Two).recipe())
    }),
    family(
        "parcels",
        TYPED_KEYS,
        "parcels that share borders as written in decimals, for `truth = \"decimals\"`",
        |_, fields| typed::recipe::<2>(fields),
    ),
];

/// The families of complexes in space.
pub(super) static SPACE: [Family; 6] = [
    family(
        "surfaces-uniform",
        &["bits"],
        "two closed surfaces that cross everywhere, in general position",
        |_, fields| Ok(Pair::SurfacesUniform(bits(fields)?).recipe()),
    ),
    family(
        "surfaces-near",
        &[],
        "two closed surfaces; vertices of one are within a few sigma of vertices, edges and triangles of the other",
        |_, _| Ok(Pair::SurfacesNear.recipe()),
    ),
    family("surfaces-degen", &[], "boxes on integers that share corners, edges and parts of faces", |_, _| {
        Ok(Pair::SurfacesDegen.recipe())
    }),
    family(
        "surfaces-shifted",
        &["shift"],
        "a closed surface and a copy of it, moved by a number of sigma",
        |_, fields| Ok(Pair::SurfacesShifted(shift(fields)?).recipe()),
    ),
    family("thresholds-space", &[], "pairs at the tolerances of Algorithms 7 to 12", |_, _| {
        Ok(Pair::Thresholds(Dimension::Three).recipe())
    }),
    family(
        "blocks",
        TYPED_KEYS,
        "blocks that share parts of faces as written in decimals, for `truth = \"decimals\"`",
        |_, fields| typed::recipe::<3>(fields),
    ),
];

/// A generator of two complexes.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Pair {
    /// Polygons whose coordinates have this many significant bits.
    PolygonsUniform(u32),
    PolygonsNear,
    PolygonsDegen,
    /// A polygon and a copy moved by this many σ.
    CopyShifted(f64),
    /// Surfaces whose coordinates have this many significant bits.
    SurfacesUniform(u32),
    SurfacesNear,
    SurfacesDegen,
    /// A surface and a copy moved by this many σ.
    SurfacesShifted(f64),
    /// One pair for each test of each algorithm, repeated.
    Thresholds(Dimension),
}

/// A complex with the coordinates of its own points, numbered from 0.
struct Shape {
    coordinates: Vec<f64>,
    simplices: Simplices,
}

impl Shape {
    /// Rounds every coordinate to the nearest number with this many significant bits.
    fn rounded(mut self, bits: u32) -> Shape {
        self.coordinates.iter_mut().for_each(|x| *x = rounded(*x, bits));
        self
    }
}

impl Pair {
    fn recipe(self) -> Recipe {
        // A few points are made even for the smallest n.
        Recipe::new(|n| 9 * n + 1000, move |making| self.make(making.n, &mut making.random()))
    }

    fn dimension(self) -> Dimension {
        match self {
            Pair::PolygonsUniform(_) | Pair::PolygonsNear | Pair::PolygonsDegen | Pair::CopyShifted(_) => {
                Dimension::Two
            }
            Pair::SurfacesUniform(_) | Pair::SurfacesNear | Pair::SurfacesDegen | Pair::SurfacesShifted(_) => {
                Dimension::Three
            }
            Pair::Thresholds(dimension) => dimension,
        }
    }

    /// Makes two complexes with about `n` edges (in space, triangles) together; the points of the first come first.
    fn make(self, n: usize, rng: &mut Random) -> Parts {
        let n = n / 2;
        let [a, b] = match self {
            Pair::PolygonsUniform(bits) => [(); 2].map(|()| polygons::wavy(n, rng).rounded(bits)),
            Pair::PolygonsNear => {
                let a = polygons::wavy(n, rng);
                let b = polygons::near(&a, self.sigma_of(&a), rng);
                [a, b]
            }
            Pair::PolygonsDegen => [polygons::skyline(n, true, rng), polygons::skyline(n, false, rng)],
            Pair::CopyShifted(by) => self.with_copy(polygons::wavy(n, rng), by),
            Pair::SurfacesUniform(bits) => [(); 2].map(|()| surfaces::lumpy(n, rng).rounded(bits)),
            Pair::SurfacesNear => {
                let a = surfaces::lumpy(n, rng);
                let b = surfaces::near(&a, self.sigma_of(&a), rng);
                [a, b]
            }
            Pair::SurfacesDegen => [surfaces::boxes(n, rng), surfaces::boxes(n, rng)],
            Pair::SurfacesShifted(by) => self.with_copy(surfaces::lumpy(n, rng), by),
            Pair::Thresholds(dimension) => thresholds::shapes(dimension, n, rng),
        };
        let start = a.coordinates.len() / self.dimension().count();
        let scene = self.scene([a.coordinates, b.coordinates].concat());
        let complex = |given: &Simplices| Complex::new(&scene, given).expect("simplices of the scene's points");
        let [a, b] = [complex(&a.simplices), complex(&shifted(&b.simplices, |v| Vertex::input(v.index() + start)))];
        let (scene, complexes) = Complexes { a, b }.in_scene(scene);
        Parts::new(scene, complexes)
    }

    fn scene(self, coordinates: Vec<f64>) -> Scene {
        Scene::new(self.dimension(), coordinates).expect("generators make finite points")
    }

    /// The tolerance σ for a shape and another with primitives of the same size.
    fn sigma_of(self, shape: &Shape) -> f64 {
        let scene = self.scene(shape.coordinates.clone());
        let complex = Complex::new(&scene, &shape.simplices).expect("simplices of the scene's points");
        sigma(self.dimension(), [complex.primitive_length(&scene); 2])
    }

    fn with_copy(self, shape: Shape, by: f64) -> [Shape; 2] {
        let by = by * self.sigma_of(&shape);
        let scene = self.scene(shape.coordinates.clone());
        let vertices: Vec<Vertex> = scene.vertices().collect();
        let copy = Shape { coordinates: moved(&scene, &vertices, by).collect(), simplices: shape.simplices.clone() };
        [shape, copy]
    }
}
