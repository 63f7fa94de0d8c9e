//! A plane in space as a planar scene: its vertices seen in a coordinate plane, where
//! [`mod@predicament_overlay::algorithm::overlay`] works.

use std::collections::HashMap;

use predicament_predicates::{
    Axis, Construction, DefinitionError, Plane, Predicates, Question, Refused, Scene, Sign, Vertex, answer_by,
};

use super::places::Places;

/// The line that contains a segment in the plane.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Line {
    /// The line of two input vertices.
    Edge([Vertex; 2]),
    /// The intersection of this plane with the plane of three input vertices.
    Cut([Vertex; 3]),
}

/// A session about vertices of a plane, each an input vertex of a 2D scene at the nearest doubles; all signs are those
/// of the session in space, which has exact zeros: several vertices may be one there.
///
/// Unequal nearest doubles have the order of the exact coordinates: if segments meet, their boxes in doubles have a
/// point in common too.
pub(crate) struct InPlane<'a> {
    session: &'a mut dyn Predicates,
    plane: Plane,
    /// The input vertices, then the constructed ones.
    flat: Scene,
    /// The vertex in space of each input vertex.
    vertices: Vec<Vertex>,
    /// The vertex in space of each constructed vertex.
    constructed: Vec<Vertex>,
    /// The line of each segment, by its ends.
    lines: HashMap<[Vertex; 2], Line>,
    /// Three input vertices of the plane, and a vertex that is not in it.
    of: ([Vertex; 3], Vertex),
}

impl<'a> InPlane<'a> {
    /// A session about these vertices of the plane of three input vertices, with a vertex that is not in it; `None` if
    /// no 2D scene can hold them.
    pub fn new(
        session: &'a mut dyn Predicates,
        places: &Places,
        plane: Plane,
        vertices: Vec<Vertex>,
        of: ([Vertex; 3], Vertex),
    ) -> Option<InPlane<'a>> {
        let axes = plane.axes().map(Axis::index);
        let point = |&v: &Vertex| {
            let point = places.nearest(session.scene(), v);
            axes.map(|axis| point[axis])
        };
        let points: Vec<[f64; 2]> = vertices.iter().map(point).collect();
        let flat = Scene::from_points2(&points).ok()?;
        Some(InPlane { session, plane, flat, vertices, constructed: Vec::new(), lines: HashMap::new(), of })
    }

    /// Stores the line of a segment of this scene.
    pub fn on_line(&mut self, [a, b]: [Vertex; 2], line: Line) {
        self.lines.insert([a.min(b), a.max(b)], line);
    }

    /// The vertex in space that corresponds to a vertex.
    pub fn vertex(&self, v: Vertex) -> Vertex {
        v.construction().map_or_else(|| self.vertices[v.index()], |index| self.constructed[index])
    }

    /// The session in space.
    pub fn space(&self) -> &dyn Predicates {
        &*self.session
    }
}

impl InPlane<'_> {
    /// The sign of the question in this plane; an overlay asks for orders and turns only.
    fn ask<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let args = args.map(|v| self.vertex(v));
        let in_space = match question {
            Question::Compare(axis) => Question::Compare(self.plane.axes()[axis.index()]),
            Question::Orient2d(_) => Question::Orient2d(self.plane),
            other => unreachable!("no overlay in a plane asks for {}", other.kind()),
        };
        in_space.ask(&*self.session, &args)
    }
}

impl Predicates for InPlane<'_> {
    fn scene(&self) -> &Scene {
        &self.flat
    }

    /// Constructs the crossings of lines in the plane, as points of a line and a plane in space, or of three planes.
    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        let InPlane { session, flat, constructed, lines, of: (corners, apart), .. } = self;
        flat.construct_all(definitions, |scene, vertex| {
            let Some(Construction::Ssi(segments)) = scene.construction(vertex) else {
                return Err(DefinitionError::Other("it is not a crossing of two segments".into()));
            };
            let definition = match segments.map(|segment| lines.get(&segment).copied()) {
                [Some(Line::Edge(line)), Some(Line::Edge([c, d]))] => Construction::Lpi { line, plane: [c, d, *apart] },
                [Some(Line::Edge(line)), Some(Line::Cut(plane))] | [Some(Line::Cut(plane)), Some(Line::Edge(line))] => {
                    Construction::Lpi { line, plane }
                }
                [Some(Line::Cut(first)), Some(Line::Cut(second))] => Construction::Tpi([*corners, first, second]),
                [None, _] | [_, None] => {
                    return Err(DefinitionError::Other("a segment is not on a line of two input vertices".into()));
                }
            };
            constructed.extend(
                session.construct(&[definition]).map_err(|why| DefinitionError::Other(why.to_string().into()))?,
            );
            Ok(())
        })
    }

    answer_by!(ask);
}
