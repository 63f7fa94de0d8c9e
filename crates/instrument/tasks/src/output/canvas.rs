//! Positions of a scene's vertices in a drawing: offsets from an origin, from exact coordinates, rounded once.

use predicament_judge::{Points, nearest, rational};
use predicament_predicates::{Dimension, Scene, Vertex};
use predicament_report::drawing::{Drawing, Layer, Offset, Part, Role, Shape};
use rug::Rational;

use super::exactly;

/// A drawing to be filled with layers.
pub struct Canvas {
    drawing: Drawing,
    origin: [Rational; 3],
    /// The origin as doubles, if it consists of doubles.
    doubles: Option<[f64; 3]>,
}

impl Canvas {
    /// An empty canvas of a scene's dimension; offsets are from this vertex, or from zero.
    ///
    /// # Errors
    /// If the vertex is not a point.
    pub fn new(scene: &Scene, origin: Option<Vertex>) -> std::io::Result<Canvas> {
        let is_space = scene.dimension() == Dimension::Three;
        let drawing = Drawing { is_space, layers: Vec::new() };
        let Some(v) = origin else {
            return Ok(Canvas { drawing, origin: [0, 0, 0].map(Rational::from), doubles: Some([0.0; 3]) });
        };
        let mut exact = exactly(&Points::of(scene), v)?.into_iter();
        let origin = [0, 1, 2].map(|_| exact.next().unwrap_or_default());
        let doubles = v.construction().is_none().then(|| padded(scene.point(v)));
        Ok(Canvas { drawing, origin, doubles })
    }

    /// The drawing.
    #[must_use]
    pub fn finish(self) -> Drawing {
        self.drawing
    }

    /// Adds a layer of single vertices.
    ///
    /// # Errors
    /// If a vertex is not a point.
    pub fn points(
        &mut self,
        scene: &Scene,
        name: &str,
        role: Role,
        vertices: impl IntoIterator<Item = Vertex>,
    ) -> std::io::Result<&mut Layer> {
        let parts = vertices.into_iter().map(|v| vec![vec![v]]);
        self.layer(scene, name, role, Shape::Points, parts)
    }

    /// Adds a layer of paths from vertex to vertex.
    ///
    /// # Errors
    /// If a vertex is not a point.
    pub fn lines<L: AsRef<[Vertex]>>(
        &mut self,
        scene: &Scene,
        name: &str,
        role: Role,
        lines: impl IntoIterator<Item = L>,
    ) -> std::io::Result<&mut Layer> {
        let parts = lines.into_iter().map(|line| vec![line.as_ref().to_vec()]);
        self.layer(scene, name, role, Shape::Lines, parts)
    }

    /// Adds a layer of faces, one ring each.
    ///
    /// # Errors
    /// If a vertex is not a point.
    pub fn faces<F: AsRef<[Vertex]>>(
        &mut self,
        scene: &Scene,
        name: &str,
        role: Role,
        faces: impl IntoIterator<Item = F>,
    ) -> std::io::Result<&mut Layer> {
        let parts = faces.into_iter().map(|face| vec![face.as_ref().to_vec()]);
        self.layer(scene, name, role, Shape::Areas, parts)
    }

    /// Adds a layer of areas bounded by rings; in space, where rings need not be convex, only their lines.
    ///
    /// # Errors
    /// If a vertex is not a point.
    pub fn areas(
        &mut self,
        scene: &Scene,
        name: &str,
        role: Role,
        areas: impl IntoIterator<Item = Vec<Vec<Vertex>>>,
    ) -> std::io::Result<&mut Layer> {
        if !self.drawing.is_space {
            return self.layer(scene, name, role, Shape::Areas, areas.into_iter());
        }
        let closed = |ring: Vec<Vertex>| {
            let first = ring.first().copied();
            ring.into_iter().chain(first).collect::<Vec<Vertex>>()
        };
        let parts = areas.into_iter().map(|rings| rings.into_iter().map(closed).collect());
        self.layer(scene, name, role, Shape::Lines, parts)
    }

    /// Adds a layer of positions that are not vertices.
    pub fn places(
        &mut self,
        name: &str,
        role: Role,
        shape: Shape,
        parts: impl IntoIterator<Item = Part>,
    ) -> &mut Layer {
        let offset = |point: [f64; 3]| -> Offset {
            match self.doubles {
                Some(origin) => [0, 1, 2].map(|axis: usize| point[axis] - origin[axis]),
                None => [0, 1, 2].map(|axis: usize| nearest(&(rational(point[axis]) - &self.origin[axis]))),
            }
        };
        let path = |path: Vec<Offset>| path.into_iter().map(offset).collect();
        let parts = parts.into_iter().map(|part| part.into_iter().map(path).collect()).collect();
        self.push(name, role, shape, parts)
    }

    fn layer(
        &mut self,
        scene: &Scene,
        name: &str,
        role: Role,
        shape: Shape,
        parts: impl Iterator<Item = Vec<Vec<Vertex>>>,
    ) -> std::io::Result<&mut Layer> {
        let points = Points::of(scene);
        let path = |path: Vec<Vertex>| path.into_iter().map(|v| self.offset(&points, v)).collect();
        let part = |part: Vec<Vec<Vertex>>| part.into_iter().map(path).collect();
        let parts = parts.map(part).collect::<std::io::Result<Vec<Part>>>()?;
        Ok(self.push(name, role, shape, parts))
    }

    fn offset(&self, points: &Points, v: Vertex) -> std::io::Result<Offset> {
        if let (None, Some(origin)) = (v.construction(), self.doubles) {
            let point = padded(points.scene().point(v));
            return Ok([0, 1, 2].map(|axis: usize| point[axis] - origin[axis]));
        }
        let point = exactly(points, v)?;
        let along = |axis: usize| point.get(axis).map_or(0.0, |x| nearest(&Rational::from(x - &self.origin[axis])));
        Ok([0, 1, 2].map(along))
    }

    fn push(&mut self, name: &str, role: Role, shape: Shape, parts: Vec<Part>) -> &mut Layer {
        let layers = &mut self.drawing.layers;
        layers.push(Layer { name: name.to_owned(), role, shape, parts, labels: Vec::new(), is_shown: true });
        let last = layers.len() - 1;
        &mut layers[last]
    }
}

/// Coordinates, padded with zeros.
fn padded(point: &[f64]) -> [f64; 3] {
    [0, 1, 2].map(|axis: usize| point.get(axis).copied().unwrap_or(0.0))
}
