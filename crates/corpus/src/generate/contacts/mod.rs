//! Two complexes that touch: curves in the plane, surfaces in space.
//!
//! The sizes are those of things that meet everywhere: every edge is short and
//! has a few of the other complex' edges around it, so that a scene of n
//! primitives has about n pairs worth looking at, whatever n.

mod polygons;
mod surfaces;

use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Dimension, Scene, Vertex};

use super::Random;
use crate::bits::rounded;
use crate::document::Fields;
use crate::sigma::sigma;
use crate::suite::{moved, shifted};
use crate::{CorpusError, Work};

/// A way to make two complexes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Pair {
    /// With coordinates of so many significant bits.
    PolygonsUniform(u32),
    PolygonsNear,
    PolygonsDegen,
    /// Moved by so many σ.
    CopyShifted(f64),
    /// With coordinates of so many significant bits.
    SurfacesUniform(u32),
    SurfacesDegen,
    /// Moved by so many σ.
    SurfacesShifted(f64),
}

/// A complex with the coordinates of its own points, numbered from 0.
struct Shape {
    coordinates: Vec<f64>,
    simplices: Simplices,
}

impl Shape {
    /// With every coordinate at the nearest number of so many significant bits.
    fn rounded(mut self, bits: u32) -> Shape {
        self.coordinates.iter_mut().for_each(|x| *x = rounded(*x, bits));
        self
    }
}

impl Pair {
    /// The pair with this family's name; none for other families.
    pub(super) fn read(family: &str, fields: &Fields<'_, '_>) -> Result<Option<Pair>, CorpusError> {
        let shift = || fields.required("shift")?.positive();
        let bits = || fields.integer_or("bits", 53, 24..=53).map(|bits| u32::try_from(bits).unwrap_or(53));
        Ok(Some(match family {
            "polygons-uniform" => Pair::PolygonsUniform(bits()?),
            "polygons-near" => Pair::PolygonsNear,
            "polygons-degen" => Pair::PolygonsDegen,
            "copy-shifted" => Pair::CopyShifted(shift()?),
            "surfaces-uniform" => Pair::SurfacesUniform(bits()?),
            "surfaces-degen" => Pair::SurfacesDegen,
            "surfaces-shifted" => Pair::SurfacesShifted(shift()?),
            _ => return Ok(None),
        }))
    }

    pub(super) fn dimension(self) -> Dimension {
        match self {
            Pair::PolygonsUniform(_) | Pair::PolygonsNear | Pair::PolygonsDegen | Pair::CopyShifted(_) => {
                Dimension::Two
            }
            Pair::SurfacesUniform(_) | Pair::SurfacesDegen | Pair::SurfacesShifted(_) => Dimension::Three,
        }
    }

    /// Two complexes with about `n` edges (in space, triangles) together; the
    /// points of the first come first.
    pub(super) fn make(self, n: usize, rng: &mut Random) -> (Scene, Work) {
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
            Pair::SurfacesDegen => [surfaces::boxes(n, rng), surfaces::boxes(n, rng)],
            Pair::SurfacesShifted(by) => self.with_copy(surfaces::lumpy(n, rng), by),
        };
        let start = a.coordinates.len() / self.dimension().count();
        let scene = self.scene([a.coordinates, b.coordinates].concat());
        let complex = |given: &Simplices| Complex::new(&scene, given).expect("simplices of the scene's points");
        let [a, b] = [complex(&a.simplices), complex(&shifted(&b.simplices, |v| Vertex::input(v.index() + start)))];
        (scene, Work::Contacts { a, b })
    }

    fn scene(self, coordinates: Vec<f64>) -> Scene {
        Scene::new(self.dimension(), coordinates).expect("generators make finite points")
    }

    /// σ between a shape and another whose primitives are as large.
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
