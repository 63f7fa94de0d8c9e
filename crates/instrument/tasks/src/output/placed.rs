//! Where the vertices of an answer are: exactly, and as doubles for formats that hold doubles.

use predicament_predicates::{Construction, Predicates, Scene, Vertex};

/// What a session has rounded the vertices to that it has constructed after the first `before`; none where it keeps them, or has none.
#[must_use]
pub fn rounded_points(session: &dyn Predicates, before: usize, count: usize) -> Option<Vec<[f64; 3]>> {
    let vertices = (0..count).map(|at| Vertex::constructed(before + at));
    let rounded = vertices.map(|v| session.rounded_point(v).and_then(|point| <[f64; 3]>::try_from(point).ok()));
    let rounded: Option<Vec<[f64; 3]>> = rounded.collect();
    rounded.filter(|points| !points.is_empty())
}

/// The scene of an answer in space.
pub struct Placed {
    /// The scene with all that was constructed.
    pub exact: Scene,
    /// The scene that meshes are written from: a session that rounds has its own points there.
    pub meshes: Scene,
    /// The constructions before those of the answer, and the place of the first of its points, where these are rounded.
    rounded: Option<[usize; 2]>,
}

impl Placed {
    /// The scene with these constructions, of which `rounded` are the points where the session has rounded them.
    ///
    /// # Errors
    /// A construction that the scene does not take, or a point that is not finite.
    pub fn new(
        scene: &Scene,
        constructions: &[Construction],
        before: usize,
        rounded: Option<&[[f64; 3]]>,
    ) -> std::io::Result<Placed> {
        let mut exact = scene.clone();
        for definition in constructions {
            exact.construct(*definition).map_err(std::io::Error::other)?;
        }
        let Some(rounded) = rounded else { return Ok(Placed { meshes: exact.clone(), exact, rounded: None }) };
        let coordinates = [scene.coordinates(), rounded.as_flattened()].concat();
        let meshes = Scene::new(scene.dimension(), coordinates).map_err(std::io::Error::other)?;
        Ok(Placed { exact, meshes, rounded: Some([before, scene.len()]) })
    }

    /// A vertex of the answer in the scene that meshes are written from.
    #[must_use]
    pub fn place(&self, v: Vertex) -> Vertex {
        match (v.construction(), self.rounded) {
            (Some(index), Some([before, first])) => Vertex::input(first + index - before),
            _ => v,
        }
    }
}
