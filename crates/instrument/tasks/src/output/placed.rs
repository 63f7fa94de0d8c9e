//! Positions of an answer's vertices: exact, and as doubles for formats that hold doubles.

use predicament_predicates::{Construction, Predicates, Scene, Vertex};

/// The session's rounded positions of the vertices that it constructed after the first `before`; `None` if it keeps
/// exact vertices, or did not construct any.
#[must_use]
pub fn rounded_points(session: &dyn Predicates, before: usize, count: usize) -> Option<Vec<[f64; 3]>> {
    let vertices = (0..count).map(|at| Vertex::constructed(before + at));
    let rounded = vertices.map(|v| session.rounded_point(v).and_then(|point| <[f64; 3]>::try_from(point).ok()));
    let rounded: Option<Vec<[f64; 3]>> = rounded.collect();
    rounded.filter(|points| !points.is_empty())
}

/// The scene of an answer in space.
pub struct Placed {
    /// The scene with all constructed vertices.
    pub exact: Scene,
    /// The scene for mesh files: a session that rounds has its own points there.
    pub meshes: Scene,
    /// The number of constructions before those of the answer, and the index of the first of its points, if these are
    /// rounded.
    rounded: Option<[usize; 2]>,
}

impl Placed {
    /// Adds constructions to the scene; `rounded` are their points if the session has rounded them.
    ///
    /// # Errors
    /// A construction that the scene does not accept, or a point that is not finite.
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

    /// The vertex in the scene for mesh files that corresponds to a vertex of the answer.
    #[must_use]
    pub fn place(&self, v: Vertex) -> Vertex {
        match (v.construction(), self.rounded) {
            (Some(index), Some([before, first])) => Vertex::input(first + index - before),
            _ => v,
        }
    }
}
