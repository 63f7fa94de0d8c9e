//! Parcels and blocks that share parts of sides as written in decimals.

use predicament_corpus::{Making, Parts, Recipe};
use predicament_formats::{CorpusError, Fields};
use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Dimension, Scene, Vertex};
use predicament_tasks::typed::{FACES, Neighbours, RING, typed};

use super::Complexes;

/// Reads the keys of decimals; `D` is the dimension.
pub(super) fn recipe<const D: usize>(fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let typed = typed(fields)?;
    let make = move |making: &Making| {
        let neighbours = Neighbours::<D>::new(typed, making);
        let dimension = if D == 2 { Dimension::Two } else { Dimension::Three };
        let scene = Scene::new(dimension, neighbours.points.as_flattened().to_vec()).expect("finite points");
        let complex = |firsts: Vec<usize>| {
            let mut all = Simplices::default();
            for first in firsts {
                let corner = |at: usize| Vertex::input(first + at);
                match dimension {
                    Dimension::Two => all.edges.extend((0..4).map(|at| [RING[at], RING[(at + 1) % 4]].map(corner))),
                    Dimension::Three => all.triangles.extend(FACES.map(|face| face.map(corner))),
                }
            }
            Complex::new(&scene, &all).expect("simplices of the scene's points")
        };
        let [a, b] = neighbours.first_corners().map(complex);
        let (scene, complexes) = Complexes { a, b }.in_scene(scene);
        Parts { written: Some(neighbours.written), ..Parts::new(scene, complexes) }
    };
    Ok(Recipe::new(|n| 3 * n + 48, make))
}
