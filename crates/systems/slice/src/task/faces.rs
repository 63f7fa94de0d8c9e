//! Exact validation of faces for slicing: manifold, planar, with areas.

use crate::checks::given::Fault;
use predicament_formats::{CorpusError, Places, Position};
use predicament_judge::{rational, sign};
use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{ConversionError, IndexedFaces};
use predicament_predicates::{Plane, Question, Scene, Sign, Vertex};
use rug::Rational;

/// The reason why a mesh is invalid.
#[derive(Debug)]
pub(super) enum Wrong {
    /// There are no faces.
    NoFaces,
    /// The faces do not make a half-edge mesh.
    NoMesh(ConversionError),
    /// All corners of a face are in line.
    NoArea { face: usize },
    /// A corner of a face is off the plane of three others.
    NotPlane { face: usize, vertex: Vertex, plane: [Vertex; 3] },
    /// Faces pass through each other or lie on each other, or a part has no volume.
    Fault(Fault),
    /// An edge has one face, although the mesh must be closed.
    Open { face: usize, edge: [Vertex; 2] },
}

impl From<ConversionError> for Wrong {
    fn from(why: ConversionError) -> Wrong {
        Wrong::NoMesh(why)
    }
}

impl Wrong {
    /// The error at its face or vertex in the file, otherwise at a line of the suite. The message names the other
    /// places.
    pub(super) fn error(&self, file: &str, places: &Places, line: Option<usize>) -> CorpusError {
        let own = self.position(places);
        let named = |name: fn(&Places, usize) -> String, position: Option<Position>, index: usize| {
            if own.is_some() && position == own { index.to_string() } else { name(places, index) }
        };
        let face = |face: usize| named(Places::face_name, places.face(face), face);
        let vertex = |v: Vertex| named(Places::point_name, places.point(v.index()), v.index());
        let (message, cure) = match self {
            Wrong::NoFaces => ("a mesh without faces".to_owned(), "give it faces"),
            Wrong::NoMesh(why) => why.explained(face, vertex),
            Wrong::NoArea { face } => (format!("face {face} has no area"), "remove it, and join its neighbours"),
            Wrong::NotPlane { face, vertex: v, plane } => {
                let ([a, b, c], v) = (plane.map(vertex), vertex(*v));
                let message = format!("face {face} is not planar: vertex {v} is not in the plane of {a}, {b} and {c}");
                (message, "divide it into triangles")
            }
            Wrong::Fault(fault) => fault.told(face),
            Wrong::Open { edge, .. } => {
                let [a, b] = edge.map(vertex);
                let message = format!("the edge of vertices {a} and {b} has a face on one side only");
                (message, "close the mesh, or leave out `closed = true`")
            }
        };
        CorpusError::file(file, message, cure).at(own.or(line.map(Position::Line)))
    }

    fn position(&self, places: &Places) -> Option<Position> {
        match self {
            Wrong::NoMesh(ConversionError::SeveralFans { vertex }) => places.point(vertex.index()),
            Wrong::NoMesh(why) => why.face().and_then(|face| places.face(face)),
            Wrong::NoArea { face } | Wrong::NotPlane { face, .. } | Wrong::Open { face, .. } => places.face(*face),
            Wrong::Fault(fault) => fault.face().and_then(|face| places.face(face)),
            Wrong::NoFaces => None,
        }
    }
}

/// For each face, three of its vertices that turn as it does; and true if the mesh is closed.
pub(super) fn faces_of(
    scene: &Scene,
    vertices: usize,
    faces: &IndexedFaces,
) -> Result<(Vec<[Vertex; 3]>, bool), Wrong> {
    if faces.is_empty() {
        return Err(Wrong::NoFaces);
    }
    let mesh = HalfEdgeMesh::new((0..vertices).map(Vertex::input).collect(), faces)?;
    let is_closed = !mesh.half_edges().any(|h| mesh.is_boundary(h));
    let support = |(face, corners): (usize, &[u32])| {
        let corners: Vec<Vertex> = corners.iter().map(|&corner| Vertex::input(corner as usize)).collect();
        let support = match corners[..] {
            [a, b, c] => Some([a, b, c]).filter(|triangle| has_area(scene, *triangle)),
            _ => support(scene, &corners),
        };
        let Some(support) = support else {
            return Err(Wrong::NoArea { face });
        };
        let [a, b, c] = support;
        let off = |v: &Vertex| !support.contains(v) && sign(scene, Question::Orient3d, &[a, b, c, *v]) != Sign::Zero;
        match corners.iter().find(|v| off(v)) {
            Some(&vertex) => Err(Wrong::NotPlane { face, vertex, plane: support }),
            None => Ok(support),
        }
    };
    Ok((faces.iter().enumerate().map(support).collect::<Result<_, _>>()?, is_closed))
}

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];

/// True if three vertices are not in line.
fn has_area(scene: &Scene, triangle: [Vertex; 3]) -> bool {
    let [a, b, c] = triangle.map(|v| scene.point3(v));
    let surely = |plane: Plane| {
        let [i, j] = plane.axes().map(predicament_predicates::Axis::index);
        let products = [(b[i] - a[i]) * (c[j] - a[j]), (b[j] - a[j]) * (c[i] - a[i])];
        // Each product has three roundings, the difference one. The total error is far below this share of the
        // products, without underflow.
        let size = products[0].abs() + products[1].abs();
        size > 1e-200 && size < 1e200 && (products[0] - products[1]).abs() > 1e-14 * size
    };
    PLANES.into_iter().any(surely)
        || PLANES.into_iter().any(|plane| sign(scene, Question::Orient2d(plane), &triangle) != Sign::Zero)
}

/// Three consecutive corners that turn as the polygon does.
fn support(scene: &Scene, corners: &[Vertex]) -> Option<[Vertex; 3]> {
    let point = |v: Vertex| scene.point3(v).map(rational);
    let next = |at: usize| (at + 1) % corners.len();
    PLANES.into_iter().find_map(|plane| {
        let [i, j] = plane.axes().map(predicament_predicates::Axis::index);
        let twice_area: Rational = (0..corners.len())
            .map(|at| {
                let [p, q] = [corners[at], corners[next(at)]].map(point);
                Rational::from(&p[i] * &q[j]) - Rational::from(&p[j] * &q[i])
            })
            .sum();
        let turns = Sign::from(twice_area.cmp0());
        let triples = (0..corners.len()).map(|at| [corners[at], corners[next(at)], corners[next(next(at))]]);
        // A simple polygon has a convex corner: the leftmost.
        let mut convex = triples.filter(|triple| sign(scene, Question::Orient2d(plane), triple) == turns);
        if turns == Sign::Zero { None } else { convex.next() }
    })
}
