//! The points that predicates are evaluated on.
//!
//! A scene holds only numbers: finite doubles, two or three per vertex, and a weight if the scene has weights. Tasks,
//! queries and polygons live elsewhere. The scene refuses NaN and infinity once, so backends need not check.
//!
//! A session constructs vertices in its own scene, which begins as a copy of the scene that it was prepared for. A copy
//! shares all lists with the original, so its cost is constant. Input vertices never change; the list of constructions
//! is copied when the first construction is added.

mod construct;

use alloc::sync::Arc;
use alloc::{vec, vec::Vec};

use crate::interned::Interned;
use crate::{Axis, Construction, Declined, Plane, PredicateKind, Vertex};

/// The number of coordinates of a point.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Dimension {
    /// Two coordinates: the plane.
    Two,
    /// Three coordinates: space.
    Three,
}

impl Dimension {
    /// The dimension of points with this number of coordinates; `None` if there is no such dimension.
    #[must_use]
    pub const fn of(count: usize) -> Option<Dimension> {
        match count {
            2 => Some(Dimension::Two),
            3 => Some(Dimension::Three),
            _ => None,
        }
    }

    /// 2 or 3.
    #[inline]
    #[must_use]
    pub const fn count(self) -> usize {
        match self {
            Dimension::Two => 2,
            Dimension::Three => 3,
        }
    }
}

/// The reason why a list of numbers is not a scene.
#[derive(Clone, PartialEq, Debug)]
pub enum SceneError {
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// The index of the vertex.
        vertex: usize,
        /// The index of the coordinate.
        axis: usize,
        /// The value found.
        value: f64,
    },
    /// The number of coordinates is not a multiple of the dimension.
    Ragged {
        /// The number of coordinates.
        coordinates: usize,
        /// The number of coordinates of a point.
        dimension: usize,
    },
    /// The number of weights is not the number of points.
    Weights {
        /// The number of weights.
        weights: usize,
        /// The number of points.
        points: usize,
    },
    /// There are more points than [`Vertex::MAX_INPUT`].
    TooMany {
        /// The number of points.
        points: usize,
    },
}

impl core::fmt::Display for SceneError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            SceneError::NotFinite { vertex, axis, value } => {
                write!(f, "point {vertex}: coordinate {axis} is {value}; every coordinate must be finite")
            }
            SceneError::Ragged { coordinates, dimension } => {
                write!(f, "{coordinates} coordinates don't divide into points of {dimension}")
            }
            SceneError::Weights { weights, points } => {
                write!(f, "there are {weights} weights for {points} points; give one for each point")
            }
            SceneError::TooMany { points } => {
                write!(f, "{points} points are more than the 2^31 that a scene can hold")
            }
        }
    }
}

impl core::error::Error for SceneError {}

/// The vertices of one scene, by index; all coordinates are finite.
///
/// [`Scene::len`], [`Scene::vertices`] and [`Scene::point`] are about the input vertices. The scene knows vertices
/// [constructed](Scene::construct) from them by definition only.
///
/// A clone shares coordinates and constructions with the original. Constructions that are added later to one of them
/// are not in the other.
#[derive(Clone, PartialEq, Debug)]
pub struct Scene {
    dimension: Dimension,
    coordinates: Arc<[f64]>,
    constructions: Arc<Interned>,
    primitive_lengths: Option<[f64; 2]>,
    /// For each vertex, true if it is in the second of two meshes; empty if there are not two.
    second_mesh: Arc<[bool]>,
    /// For each vertex its weight; empty if the scene has no weights.
    weights: Arc<[f64]>,
}

impl Scene {
    /// A scene from coordinates, point after point.
    ///
    /// # Errors
    /// [`SceneError`] with the first coordinate that is not finite, or if the coordinates don't divide into points.
    pub fn new(dimension: Dimension, coordinates: Vec<f64>) -> Result<Scene, SceneError> {
        let stride = dimension.count();
        if !coordinates.len().is_multiple_of(stride) {
            return Err(SceneError::Ragged { coordinates: coordinates.len(), dimension: stride });
        }
        let points = coordinates.len() / stride;
        if points > Vertex::MAX_INPUT {
            return Err(SceneError::TooMany { points });
        }
        if let Some(at) = coordinates.iter().position(|c| !c.is_finite()) {
            return Err(SceneError::NotFinite { vertex: at / stride, axis: at % stride, value: coordinates[at] });
        }
        Ok(Scene {
            dimension,
            coordinates: coordinates.into(),
            constructions: Arc::default(),
            primitive_lengths: None,
            second_mesh: Arc::default(),
            weights: Arc::default(),
        })
    }

    /// A 2D scene from points.
    ///
    /// # Errors
    /// The errors of [`Scene::new`].
    pub fn from_points2(points: &[[f64; 2]]) -> Result<Scene, SceneError> {
        Scene::new(Dimension::Two, points.as_flattened().to_vec())
    }

    /// A 3D scene from points.
    ///
    /// # Errors
    /// The errors of [`Scene::new`].
    pub fn from_points3(points: &[[f64; 3]]) -> Result<Scene, SceneError> {
        Scene::new(Dimension::Three, points.as_flattened().to_vec())
    }

    /// The scene with the largest primitive lengths of its two meshes.
    ///
    /// A mesh's length is the largest edge of a primitive's bounding box, rounded up. Contact tolerances between the
    /// meshes are derived from these lengths.
    ///
    /// # Panics
    /// If a length is negative or NaN.
    #[must_use]
    pub fn with_primitive_lengths(mut self, lengths: [f64; 2]) -> Scene {
        assert!(lengths.iter().all(|&length| length >= 0.0), "a primitive has a length");
        self.primitive_lengths = Some(lengths);
        self
    }

    /// The scene with these vertices as the second of its two meshes.
    ///
    /// A perturbation that moves a mesh as a whole moves this mesh.
    ///
    /// # Panics
    /// If a vertex is not an input vertex of the scene.
    #[must_use]
    pub fn with_second_mesh(mut self, vertices: impl IntoIterator<Item = Vertex>) -> Scene {
        let mut second = vec![false; self.len()];
        vertices.into_iter().for_each(|v| second[v.index()] = true);
        self.second_mesh = second.into();
        self
    }

    /// The scene with a weight for each input vertex: the coordinate w of formulas.
    ///
    /// # Errors
    /// [`SceneError`] if there is not one weight for each vertex, or with the first weight that is not finite.
    pub fn with_weights(mut self, weights: Vec<f64>) -> Result<Scene, SceneError> {
        if weights.len() != self.len() {
            return Err(SceneError::Weights { weights: weights.len(), points: self.len() });
        }
        if let Some(vertex) = weights.iter().position(|weight| !weight.is_finite()) {
            return Err(SceneError::NotFinite { vertex, axis: self.dimension.count(), value: weights[vertex] });
        }
        self.weights = weights.into();
        Ok(self)
    }

    /// The scene with the weights of another scene's first vertices, if that has weights.
    ///
    /// # Panics
    /// If the other scene has weights for fewer vertices.
    #[must_use]
    pub fn with_weights_of(mut self, other: &Scene) -> Scene {
        if !other.weights.is_empty() {
            self.weights = other.weights[..self.len()].into();
        }
        self
    }

    /// The weights of the input vertices; empty if the scene has no weights.
    #[inline]
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// For each input vertex, true if it is in the second mesh; `None` if the scene does not have two meshes.
    #[inline]
    #[must_use]
    pub fn second_mesh(&self) -> Option<&[bool]> {
        (!self.second_mesh.is_empty()).then_some(&self.second_mesh)
    }

    /// The primitive lengths La and Lb of the two meshes; `None` if the scene does not have two.
    #[inline]
    #[must_use]
    pub fn primitive_lengths(&self) -> Option<[f64; 2]> {
        self.primitive_lengths
    }

    /// Returns true if this is a vertex of the scene, input or constructed.
    #[must_use]
    pub fn has(&self, v: Vertex) -> bool {
        match v.construction() {
            None => v.index() < self.len(),
            Some(index) => index < self.constructions.list().len(),
        }
    }

    /// The definition of this vertex, in canonical form.
    ///
    /// `None` for an input vertex and for a vertex that is not in this scene.
    #[must_use]
    pub fn construction(&self, v: Vertex) -> Option<&Construction> {
        self.constructions.list().get(v.construction()?)
    }

    /// The definition of each constructed vertex, in the order of ids.
    #[inline]
    #[must_use]
    pub fn constructions(&self) -> &[Construction] {
        self.constructions.list()
    }

    /// The dimension of the scene's points.
    #[inline]
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// Checks that the predicate exists for points of this dimension.
    ///
    /// A 3D scene has three coordinate planes, so it has turns but no circles.
    ///
    /// # Errors
    /// [`Declined`] with the reason.
    pub fn has_dimension_for(&self, kind: PredicateKind) -> Result<(), Declined> {
        use PredicateKind::{Compare, Incircle, Insphere, Orient2d, Orient3d};
        match (kind, self.dimension) {
            (Compare | Orient2d, _) | (Incircle, Dimension::Two) | (Orient3d | Insphere, Dimension::Three) => Ok(()),
            (PredicateKind::Derived(derived), dimension) if derived.dimension() == dimension => {
                if derived.is_weighted() && self.weights.is_empty() && !self.is_empty() {
                    return Err(Declined::predicate(kind, "the scene has no weights"));
                }
                Ok(())
            }
            (_, Dimension::Two) => Err(Declined::predicate(kind, "the scene is 2D")),
            (_, Dimension::Three) => Err(Declined::predicate(kind, "the scene is 3D")),
        }
    }

    /// The number of input vertices.
    #[inline]
    #[must_use]
    pub fn len(&self) -> usize {
        // A division by a constant, which compiles to no division.
        match self.dimension {
            Dimension::Two => self.coordinates.len() / 2,
            Dimension::Three => self.coordinates.len() / 3,
        }
    }

    /// Returns true if there are no input vertices.
    #[inline]
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.coordinates.is_empty()
    }

    /// Every input vertex, in index order.
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = Vertex> + use<> {
        (0..self.len()).map(Vertex::input)
    }

    /// All coordinates, point after point.
    #[inline]
    #[must_use]
    pub fn coordinates(&self) -> &[f64] {
        &self.coordinates
    }

    /// The coordinates of one vertex, two or three of them.
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[inline]
    #[must_use]
    pub fn point(&self, v: Vertex) -> &[f64] {
        let stride = self.dimension.count();
        &self.coordinates[v.index() * stride..][..stride]
    }

    /// One coordinate of a vertex.
    ///
    /// # Panics
    /// If the scene has no such vertex or no such axis.
    #[inline]
    #[must_use]
    pub fn coordinate(&self, axis: Axis, v: Vertex) -> f64 {
        self.point(v)[axis.index()]
    }

    /// The projection of a vertex to a coordinate plane.
    ///
    /// # Panics
    /// If the scene has no such vertex, or the plane needs an axis that a 2D scene lacks.
    #[inline]
    #[must_use]
    pub fn point2(&self, plane: Plane, v: Vertex) -> [f64; 2] {
        let point = self.point(v);
        match plane {
            Plane::Xy => [point[0], point[1]],
            Plane::Yz => [point[1], point[2]],
            Plane::Zx => [point[2], point[0]],
        }
    }

    /// The coordinates of a vertex of a 3D scene.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 2D.
    #[inline]
    #[must_use]
    pub fn point3(&self, v: Vertex) -> [f64; 3] {
        let point = self.point(v);
        [point[0], point[1], point[2]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_what_is_not_finite_and_says_where() {
        let error = Scene::from_points2(&[[0.0, 1.0], [2.0, f64::NAN]]).unwrap_err();
        assert!(matches!(error, SceneError::NotFinite { vertex: 1, axis: 1, .. }));
        let error = Scene::from_points3(&[[f64::INFINITY, 1.0, 2.0]]).unwrap_err();
        assert!(error.to_string().contains("point 0: coordinate 0 is inf"), "{error}");
        let error = Scene::new(Dimension::Three, vec![0.0; 4]).unwrap_err();
        assert_eq!(error, SceneError::Ragged { coordinates: 4, dimension: 3 });
    }

    #[test]
    fn projections_take_the_axes_in_their_order() {
        let scene = Scene::from_points3(&[[1.0, 2.0, 3.0]]).unwrap();
        let v = Vertex::input(0);
        for plane in [Plane::Xy, Plane::Yz, Plane::Zx] {
            let by_axes = plane.axes().map(|axis| scene.coordinate(axis, v));
            assert_eq!(scene.point2(plane, v), by_axes);
        }
    }
}
