//! A scene with its points elsewhere.

use std::sync::Arc;

use predicament_corpus::LoadedScene;
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::contacts::Complexes;

use crate::Error;

/// The scene over other points: the second of two meshes and the lengths of primitives are found anew.
pub(crate) fn moved(mut loaded: LoadedScene, coordinates: Vec<f64>) -> Result<LoadedScene, Error> {
    let scene = Scene::new(loaded.scene.dimension(), coordinates).map_err(Error::unfit)?;
    let second: Option<Vec<Vertex>> = loaded
        .scene
        .second_mesh()
        .map(|second| second.iter().enumerate().filter(|(_, is)| **is).map(|(at, _)| Vertex::input(at)).collect());
    let scene = match second {
        Some(second) => scene.with_second_mesh(second),
        None => scene,
    };
    loaded.scene = match loaded.content::<Complexes>() {
        Some(complexes) => {
            let (scene, complexes) = complexes.clone().in_scene(scene);
            loaded.content = Arc::new(complexes);
            scene
        }
        None => scene,
    };
    Ok(loaded)
}
