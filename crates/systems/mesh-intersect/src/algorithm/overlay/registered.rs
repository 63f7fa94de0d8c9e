//! Overlay by registered contacts, in floating point only (Wang, Jiang, Schroeder and Teran, Algorithms 7 to 12).
//!
//! A tolerance scheme decides which pairs of simplices are in contact, and gives weights for the point on either
//! simplex. The passages are the registered contacts, and a point is on its edge by its weight. All later predicates
//! use points in doubles. A contact of simplices smaller than an edge and a triangle is a degeneracy, and there is no
//! result, as with exact zeros.

use std::collections::BTreeMap;
use std::sync::Arc;

use predicament_mesh::{Complex, MaterialMesh, Simplices};
use predicament_predicates::{
    Construction, Declined, DefinitionError, PredicateKind, Predicates, Question, Refused, Scene, Sign, Vertex,
    answer_by,
};

use super::meet::Hit;
use super::near::Near;
use super::{Contradiction, Extent, MeshOverlay, Step, Undone, finish};
use predicament_contacts::algorithm::pairs::{Contact, contacts};

/// A session of points in doubles: those of a scene, and registered points. Signs are those of floating-point
/// determinants.
#[derive(Clone, Debug)]
pub struct Registered {
    scene: Scene,
    /// For each definition, its registered position.
    places: BTreeMap<Construction, [f64; 3]>,
    /// The constructed vertices, in order.
    points: Vec<[f64; 3]>,
}

/// Overlays two meshes with disjoint vertices by the contacts that a session registers; `done` is called after each
/// step. Also returns the positions of the constructed vertices.
///
/// # Errors
/// [`Undone::Contact`] if simplices smaller than an edge and a triangle are in contact; [`Undone::Refused`] if the
/// session registers no contacts; [`Undone::Broken`] if signs of doubles break an invariant.
pub fn mesh_overlay_registered(
    session: &dyn Predicates,
    meshes: [Arc<MaterialMesh>; 2],
    done: &mut dyn FnMut(Step),
) -> Result<(MeshOverlay, Registered), Undone> {
    let declined = |why: Declined| Undone::Refused(Refused::session(why.to_string()));
    session.supports_contacts().map_err(declined)?;
    let scene = session.scene();
    let both = [&*meshes[0], &*meshes[1]];
    let (near, bounds) = Near::of(scene, both, None);
    done(Step::Near);
    let near = [&near[0], &near[1]];
    let complexes = both.map(|mesh| {
        let triangles = mesh.triangles().to_vec();
        Complex::new(scene, &Simplices { triangles, ..Simplices::default() })
    });
    let [Ok(first), Ok(second)] = complexes else {
        return Err(Undone::Broken(Contradiction::Simplices));
    };
    let registered = contacts(session, &first, &second).registered;
    let mut points = Registered { scene: scene.clone(), places: BTreeMap::new(), points: Vec::new() };
    let mut hits = [Vec::new(), Vec::new()];
    let found = Found { complexes: [&first, &second], near, triangles: near.map(by_vertices(both)) };
    for contact in registered {
        found.add(&contact, both, &mut points, &mut hits)?;
    }
    hits.iter_mut().for_each(|hits| hits.sort_unstable_by_key(|hit| (hit.triangle, hit.edge)));
    done(Step::Passages);
    let before = scene.constructions().len();
    let overlay = finish(&mut points, &meshes, before, (near, &bounds), hits, Extent::Whole, done)?;
    Ok((overlay, points))
}

/// The indices of near triangles, by their vertices in ascending order.
type Triangles = BTreeMap<[Vertex; 3], Vec<u32>>;

/// The simplices of contacts.
struct Found<'a> {
    complexes: [&'a Complex; 2],
    near: [&'a Near; 2],
    triangles: [Triangles; 2],
}

impl Found<'_> {
    /// Adds a contact to the passages; if a triangle occurs several times, the edge passes through each copy.
    fn add(
        &self,
        contact: &Contact,
        meshes: [&MaterialMesh; 2],
        points: &mut Registered,
        hits: &mut [Vec<Hit>; 2],
    ) -> Result<(), Undone> {
        let of = [contact.a, contact.b];
        let vertices = [0, 1].map(|mesh: usize| self.complexes[mesh].vertices_of(of[mesh]));
        let (mesh, ends, corners, weights) = match vertices {
            [&[p, q], &[a, b, c]] => (0, [p, q], [a, b, c], contact.on_a),
            [&[a, b, c], &[p, q]] => (1, [p, q], [a, b, c], contact.on_b),
            other => return Err(Undone::Contact(other.map(<[Vertex]>::to_vec))),
        };
        let edge = self.near[mesh].edge(ends[0], ends[1]).ok_or(Undone::Broken(Contradiction::Apart))?;
        let triangles = self.triangles[1 - mesh].get(&corners).ok_or(Undone::Broken(Contradiction::Apart))?;
        for &triangle in triangles {
            let plane = meshes[1 - mesh].triangles()[self.near[1 - mesh].triangles[triangle as usize] as usize];
            let [from, to] = ends.map(|v| points.orient3d(plane[0], plane[1], plane[2], v));
            let begins = if from.is_zero() { -to } else { from };
            if begins.is_zero() || to == begins {
                return Err(Undone::Broken(Contradiction::Ends));
            }
            hits[mesh].push(Hit { edge, triangle, is_first_behind: begins == Sign::Positive });
            let [p, q] = ends.map(|v| points.scene.point3(v));
            let place = [0, 1, 2].map(|axis| weights[0] * p[axis] + weights[1] * q[axis]);
            points.places.insert(Construction::Lpi { line: ends, plane }.canonical(), place);
        }
        Ok(())
    }
}

/// Returns a function that finds the triangles of the near part of either mesh by their vertices.
fn by_vertices(meshes: [&MaterialMesh; 2]) -> impl FnMut(&Near) -> Triangles {
    let mut meshes = meshes.into_iter();
    move |near| {
        let mesh = meshes.next().expect("two meshes");
        let mut triangles = Triangles::new();
        for (&of, place) in near.triangles.iter().zip(0..) {
            let mut corners = mesh.triangles()[of as usize];
            corners.sort_unstable();
            triangles.entry(corners).or_default().push(place);
        }
        triangles
    }
}

impl Registered {
    /// The position of a vertex.
    #[must_use]
    pub fn place(&self, v: Vertex) -> [f64; 3] {
        v.construction().map_or_else(|| self.scene.point3(v), |index| self.points[index])
    }
}

fn minus<const D: usize>(a: [f64; D], b: [f64; D]) -> [f64; D] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

impl Registered {
    /// The sign of the determinant of the positions; `supports` refuses circles and spheres.
    fn ask<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let places = args.map(|v| self.place(v));
        Sign::of(match (question, &places[..]) {
            (Question::Compare(axis), [a, b]) => a[axis.index()] - b[axis.index()],
            (Question::Orient2d(plane), &[a, b, c]) => {
                let [a, b, c] = [a, b, c].map(|point: [f64; 3]| plane.axes().map(|axis| point[axis.index()]));
                let [p, q] = [minus(a, c), minus(b, c)];
                p[0] * q[1] - p[1] * q[0]
            }
            (Question::Orient3d, &[a, b, c, d]) => {
                let [p, q, r] = [minus(a, d), minus(b, d), minus(c, d)];
                let minor = |i: usize, j: usize| p[i] * q[j] - p[j] * q[i];
                minor(1, 2) * r[0] + minor(2, 0) * r[1] + minor(0, 1) * r[2]
            }
            _ => unreachable!("{} is declined", question.kind()),
        })
    }
}

impl Predicates for Registered {
    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        let (places, points) = (&self.places, &mut self.points);
        self.scene.construct_all(definitions, |scene, vertex| {
            let definition = scene.construction(vertex).expect("just constructed");
            points.push(*places.get(definition).ok_or(DefinitionError::Other("it is not registered".into()))?);
            Ok(())
        })
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        match kind {
            PredicateKind::Incircle | PredicateKind::Insphere => {
                Err(Declined::predicate(kind, "registered points have no tolerance for circles"))
            }
            kind => self.scene.has_dimension_for(kind),
        }
    }

    fn rounded_point(&self, v: Vertex) -> Option<&[f64]> {
        Some(&self.points.get(v.construction()?)?[..])
    }

    answer_by!(ask);
}
