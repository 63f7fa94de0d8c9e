//! The points that predicates are evaluated on.
//!
//! A scene holds only numbers: finite doubles, two or three per vertex, and a weight if the scene has weights. Tasks,
//! queries and polygons live elsewhere. The scene refuses NaN and infinity once, so backends need not check.
//!
//! A session constructs vertices in its own scene, which begins as a copy of the scene that it was prepared for. A copy
//! shares all lists with the original, so its cost is constant. Input vertices never change; the list of constructions
//! is copied when the first construction is added.

use alloc::sync::Arc;
use alloc::{vec, vec::Vec};

use crate::interned::Interned;
use crate::{Axis, Construction, ConstructionError, Declined, DefinitionError, Plane, PredicateKind, Refused, Vertex};

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

    /// The vertex that this construction defines: a new vertex, or the existing vertex of the same definition.
    ///
    /// Definitions that differ only in order have the same vertex.
    ///
    /// # Errors
    /// [`ConstructionError`] if the construction is for another dimension, names a vertex that the scene lacks, names a
    /// vertex twice in one line or plane, or if there are too many constructions already.
    pub fn construct(&mut self, construction: Construction) -> Result<Vertex, ConstructionError> {
        let construction = self.checked(construction)?;
        match self.constructions.find(&construction) {
            Some(vertex) => Ok(vertex),
            None => Arc::make_mut(&mut self.constructions).push(construction).ok_or(ConstructionError::TooMany),
        }
    }

    /// Constructs many vertices, in order: all of them, or none.
    ///
    /// The method calls `admit` for each new vertex, in their order. There a session computes the point, or says why
    /// there is none. The scene that it gets has the vertex, and may have some of the later ones. Definitions may name
    /// vertices that earlier definitions of the call define.
    ///
    /// # Errors
    /// [`Refused::Definition`] for the first definition that the scene or `admit` does not take. The scene is then
    /// unchanged; the caller must remove whatever `admit` has stored for earlier vertices.
    pub fn construct_all(
        &mut self,
        definitions: &[Construction],
        mut admit: impl FnMut(&Scene, Vertex) -> Result<(), DefinitionError>,
    ) -> Result<Vec<Vertex>, Refused> {
        let before = self.constructions.list().len();
        let mut vertices = Vec::with_capacity(definitions.len());
        while vertices.len() < definitions.len() {
            let (done, mut next) = (vertices.len(), self.constructions.list().len());
            let mut error = self.add_some(&definitions[done..], &mut vertices).map_err(DefinitionError::from);
            for at in done..vertices.len() {
                if vertices[at].construction() == Some(next) {
                    next += 1;
                    if let Err(reason) = admit(self, vertices[at]) {
                        vertices.truncate(at);
                        error = Err(reason);
                        break;
                    }
                }
            }
            if let Err(reason) = error {
                if self.constructions.list().len() > before {
                    Arc::make_mut(&mut self.constructions).truncate(before);
                }
                let index = vertices.len();
                return Err(Refused::Definition { index, definition: definitions[index], reason });
            }
        }
        Ok(vertices)
    }

    /// Adds the vertices of the first definitions: those that exist already, then some of the others, or those before
    /// an error.
    fn add_some(&mut self, definitions: &[Construction], added: &mut Vec<Vertex>) -> Result<(), ConstructionError> {
        let mut left = definitions.iter();
        let first = loop {
            let Some(&definition) = left.next() else { return Ok(()) };
            let definition = self.checked(definition)?;
            match self.constructions.find(&definition) {
                Some(vertex) => added.push(vertex),
                None => break definition,
            }
        };
        let (dimension, inputs) = (self.dimension, self.len());
        let list = Arc::make_mut(&mut self.constructions);
        list.reserve(left.len() + 1);
        added.push(list.push(first).ok_or(ConstructionError::TooMany)?);
        for &definition in left.take(TOGETHER) {
            let definition = canonical(definition, dimension, [inputs, list.list().len()]);
            let Some(vertex) = definition.and_then(|definition| list.intern(definition)) else {
                break;
            };
            added.push(vertex);
        }
        Ok(())
    }

    /// The canonical form of a construction, if the scene can take it.
    #[inline]
    fn checked(&self, construction: Construction) -> Result<Construction, ConstructionError> {
        let counts = [self.len(), self.constructions.list().len()];
        canonical(construction, self.dimension, counts).ok_or_else(|| self.why_not(construction))
    }

    /// The error of a construction.
    #[cold]
    #[inline(never)]
    fn why_not(&self, construction: Construction) -> ConstructionError {
        if let Some(of) = construction.dimension()
            && of != self.dimension
        {
            return ConstructionError::Dimension { scene: self.dimension, construction: of };
        }
        let construction = construction.canonical();
        let faults = construction.flats().find_map(|flat| {
            let missing = flat.iter().find(|&&vertex| !self.has(vertex));
            let repeated = flat.windows(2).find(|pair| pair[0] == pair[1]);
            match (missing, repeated) {
                (Some(&vertex), _) => Some(ConstructionError::Missing { vertex }),
                (None, Some(pair)) => Some(ConstructionError::Repeated { vertex: pair[0] }),
                (None, None) => None,
            }
        });
        faults.expect("its lines and planes do not have vertices of the scene, each once")
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

/// The number of new vertices that are added together.
const TOGETHER: usize = 256;

/// The canonical form of a construction, if it is one of a scene with these counts of input and constructed vertices.
#[inline(always)]
fn canonical(construction: Construction, dimension: Dimension, counts: [usize; 2]) -> Option<Construction> {
    if construction.dimension().is_some_and(|of| of != dimension) {
        return None;
    }
    let construction = construction.canonical();
    let is_spanned = match &construction {
        Construction::Ssi([first, second]) => spans(first, counts) & spans(second, counts),
        Construction::Lpi { line, plane } => spans(line, counts) & spans(plane, counts),
        Construction::Tpi([p, q, r]) => spans(p, counts) & spans(q, counts) & spans(r, counts),
        Construction::Ratio { ends, .. } => spans(ends, counts),
    };
    is_spanned.then_some(construction)
}

/// Returns true if the vertices are in range for these counts of input and constructed vertices, distinct and sorted.
#[inline(always)]
fn spans<const N: usize>(flat: &[Vertex; N], [inputs, constructed]: [usize; 2]) -> bool {
    let known = flat.iter().all(|v| match v.construction() {
        None => v.index() < inputs,
        Some(index) => index < constructed,
    });
    // Sorted, so equal vertices would be adjacent.
    known & (1..N).all(|i| flat[i - 1] < flat[i])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NoPoint;

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
    fn constructions_are_interned_by_definition() {
        let mut scene = Scene::from_points2(&[[0.0, 0.0], [2.0, 2.0], [0.0, 2.0], [2.0, 0.0], [1.0, 1.0]]).unwrap();
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(Vertex::input);
        let x = scene.construct(Construction::Ssi([[a, b], [c, d]])).unwrap();
        let y = scene.construct(Construction::Ssi([[a, e], [c, d]])).unwrap();
        assert_eq!([x, y], [0, 1].map(Vertex::constructed), "the same point, by other lines");
        assert_eq!(scene.construct(Construction::Ssi([[d, c], [b, a]])), Ok(x));
        assert_eq!(scene.construction(x), Some(&Construction::Ssi([[a, b], [c, d]])));
        assert_eq!(scene.constructions().len(), 2);
        assert_eq!((scene.construction(a), scene.construction(Vertex::constructed(2))), (None, None));
        assert_eq!((scene.len(), scene.vertices().len()), (5, 5), "constructed vertices are not input");
    }

    #[test]
    fn constructions_that_make_no_sense_are_refused() {
        let mut scene = Scene::from_points3(&[[0.0; 3]; 6]).unwrap();
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(Vertex::input);
        let lpi = |line, plane| Construction::Lpi { line, plane };
        let outside = Vertex::input(6);
        assert_eq!(scene.construct(lpi([a, a], [b, c, d])), Err(ConstructionError::Repeated { vertex: a }));
        assert_eq!(scene.construct(lpi([a, b], [d, c, d])), Err(ConstructionError::Repeated { vertex: d }));
        assert_eq!(scene.construct(lpi([a, outside], [b, c, d])), Err(ConstructionError::Missing { vertex: outside }));
        let later = Vertex::constructed(0);
        assert_eq!(scene.construct(lpi([a, later], [b, c, d])), Err(ConstructionError::Missing { vertex: later }));
        assert!(matches!(
            scene.construct(Construction::Ssi([[a, b], [c, d]])),
            Err(ConstructionError::Dimension { .. })
        ));
        let x = scene.construct(lpi([a, b], [c, d, e])).expect("whether they meet is not the scene's business");
        assert_eq!(x, later);
        let on_itself = lpi([a, Vertex::constructed(1)], [b, c, d]);
        let missing = scene.construct(on_itself).unwrap_err();
        assert_eq!(missing.to_string(), "c1 is not constructed before");
        assert_eq!(scene.constructions().len(), 1);
    }

    #[test]
    fn constructions_stand_on_earlier_ones() {
        let mut scene = Scene::from_points3(&[[0.0; 3]; 6]).unwrap();
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(Vertex::input);
        let x = scene.construct(Construction::Lpi { line: [a, b], plane: [c, d, e] }).unwrap();
        let y = scene.construct(Construction::Tpi([[x, b, a], [a, b, d], [c, d, x]])).unwrap();
        assert_eq!([x, y], [0, 1].map(Vertex::constructed));
        assert_eq!(scene.constructions().iter().map(Construction::is_of_inputs).collect::<Vec<_>>(), [true, false]);
        assert_eq!(scene.constructions()[1].to_string(), "TPI(0 1 3, 0 1 c0, 2 3 c0)");
        assert!(scene.has(y) && scene.has(e) && !scene.has(Vertex::constructed(2)) && !scene.has(Vertex::input(6)));
    }

    #[test]
    fn many_are_constructed_in_order_or_none_of_them() {
        let mut scene = Scene::from_points2(&[[0.0, 0.0], [2.0, 2.0], [0.0, 2.0], [2.0, 0.0], [1.0, 1.0]]).unwrap();
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(Vertex::input);
        let [x, y, z] = [0, 1, 2].map(Vertex::constructed);
        let ssi = |p, q| Construction::Ssi([p, q]);
        assert_eq!(scene.construct(ssi([a, b], [c, d])), Ok(x));
        let copy = scene.clone();
        let definitions = [ssi([a, e], [c, d]), ssi([c, d], [b, a]), ssi([x, e], [y, a]), ssi([e, a], [d, c])];
        let mut admitted = Vec::new();
        let vertices = scene.construct_all(&definitions, |scene, vertex| {
            assert!(scene.has(vertex));
            admitted.push(vertex);
            Ok(())
        });
        assert_eq!((vertices, admitted), (Ok(vec![y, x, z, y]), vec![y, z]));
        assert_eq!(copy.constructions().len(), 1, "a clone keeps its own");

        let mut again = copy.clone();
        let refused =
            again.construct_all(
                &definitions,
                |_, vertex| {
                    if vertex == z { Err(NoPoint::ParallelLines.into()) } else { Ok(()) }
                },
            );
        let refused = refused.unwrap_err();
        assert_eq!(
            refused,
            Refused::Definition { index: 2, definition: definitions[2], reason: NoPoint::ParallelLines.into() }
        );
        assert_eq!(again, copy);
        assert_eq!(again.construct_all(&definitions[2..], |_, _| Ok(())).unwrap_err().index(), Some(0), "c1 is gone");
        assert_eq!(again.construct(ssi([x, b], [c, d])), Ok(y), "its id is free");
        assert_eq!(again.construct_all(&definitions[..2], |_, _| Ok(())), Ok(vec![z, x]), "so is its definition");
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
