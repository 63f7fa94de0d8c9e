//! Whether faces make a mesh that planes can split: manifold, plane, with areas. Decided exactly.

use predicament_judge::{rational, sign};
use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{ConversionError, IndexedFaces};
use predicament_predicates::{Plane, Question, Scene, Sign, Vertex};
use rug::Rational;

/// What is wrong with a mesh: the face that it is about, if it is about one, the message, and the cure.
pub(super) struct Wrong {
    pub(super) face: Option<usize>,
    pub(super) message: String,
    pub(super) cure: String,
}

impl From<ConversionError> for Wrong {
    fn from(why: ConversionError) -> Wrong {
        use ConversionError as E;
        let face = match why {
            E::NoSuchVertex { face, .. } | E::TooFewCorners { face, .. } | E::RepeatedVertex { face, .. } => Some(face),
            E::ThreeFaces { faces: [.., face], .. } | E::FlippedFace { faces: [_, face], .. } => Some(face),
            E::TooMany | E::SeveralFans { .. } => None,
        };
        let text = why.to_string();
        let (message, cure) = text.split_once("; ").unwrap_or((&text, "correct it"));
        Wrong { face, message: message.to_owned(), cure: cure.to_owned() }
    }
}

/// For each face three of its vertices that turn as it does; and whether the mesh is closed.
pub(super) fn faces_of(
    scene: &Scene,
    vertices: usize,
    faces: &IndexedFaces,
) -> Result<(Vec<[Vertex; 3]>, bool), Wrong> {
    if faces.is_empty() {
        let cure = "give it faces".to_owned();
        return Err(Wrong { face: None, message: "a mesh without faces".to_owned(), cure });
    }
    let mesh = HalfEdgeMesh::new((0..vertices).map(Vertex::input).collect(), faces)?;
    let is_closed = !mesh.half_edges().any(|h| mesh.is_boundary(h));
    let support = |(face, corners): (usize, &[u32])| {
        let corners: Vec<Vertex> = corners.iter().map(|&corner| Vertex::input(corner as usize)).collect();
        let wrong = |message: String, cure: &str| Wrong { face: Some(face), message, cure: cure.to_owned() };
        let support = match corners[..] {
            [a, b, c] => Some([a, b, c]).filter(|triangle| has_area(scene, *triangle)),
            _ => support(scene, &corners),
        };
        let Some(support) = support else {
            return Err(wrong(format!("face {face} has no area"), "remove it, and join its neighbours"));
        };
        let [a, b, c] = support;
        let off = |v: &Vertex| !support.contains(v) && sign(scene, Question::Orient3d, &[a, b, c, *v]) != Sign::Zero;
        match corners.iter().find(|v| off(v)) {
            Some(v) => Err(wrong(
                format!("face {face} is not plane: vertex {v} is off the plane of {a}, {b} and {c}"),
                "divide it into triangles",
            )),
            None => Ok(support),
        }
    };
    Ok((faces.iter().enumerate().map(support).collect::<Result<_, _>>()?, is_closed))
}

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];

/// Whether three vertices are on no line.
fn has_area(scene: &Scene, triangle: [Vertex; 3]) -> bool {
    let [a, b, c] = triangle.map(|v| scene.point3(v));
    let surely = |plane: Plane| {
        let [i, j] = plane.axes().map(predicament_predicates::Axis::index);
        let products = [(b[i] - a[i]) * (c[j] - a[j]), (b[j] - a[j]) * (c[i] - a[i])];
        // Three roundings of each product, and one of the difference: far less than this share of them, where
        // nothing underflows.
        let size = products[0].abs() + products[1].abs();
        size > 1e-200 && size < 1e200 && (products[0] - products[1]).abs() > 1e-14 * size
    };
    PLANES.into_iter().any(surely)
        || PLANES.into_iter().any(|plane| sign(scene, Question::Orient2d(plane), &triangle) != Sign::Zero)
}

/// Three corners in a row that turn as the polygon does.
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
        // One that is convex is there: the leftmost of a simple polygon.
        let mut convex = triples.filter(|triple| sign(scene, Question::Orient2d(plane), triple) == turns);
        if turns == Sign::Zero { None } else { convex.next() }
    })
}
