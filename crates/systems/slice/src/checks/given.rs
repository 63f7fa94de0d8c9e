//! The check of a given mesh: its faces do not pass through each other, and none is there twice.
//!
//! Faces may touch. Two faces without a common edge may lie on each other if they look in opposite directions: two
//! solids of one mesh stand on each other. Faces of four or more corners must be polygons. They are divided by a fan if
//! they are convex; other faces are not compared.

use predicament_judge::boxes::{Boxes, extent};
use predicament_judge::{rational, sign};
use predicament_predicates::{Plane, Question, Scene, Sign, Vertex};
use predicament_triangulate::checks as polygon;
use predicament_triangulate::checks::Polygon;
use rug::Rational;

use super::exact::volume;

/// The maximum number of faces of a mesh that are compared.
pub const COMPARED: usize = 2_000;

/// The reason why faces are not a mesh to slice.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Fault {
    /// Two faces pass through each other.
    Crossing([usize; 2]),
    /// Two faces overlap in one plane, and look in one direction.
    Doubled([usize; 2]),
    /// Two faces with a common edge lie on each other.
    Folded([usize; 2]),
    /// A closed part of the mesh has no volume; this is one of its faces.
    Flat(usize),
    /// The volume of the closed mesh is negative.
    InsideOut,
    /// Two corners of a face in a row are at one place.
    Repeated(usize),
    /// The corners of a face do not make a polygon.
    NoPolygon {
        /// The face.
        face: usize,
        /// The reason.
        fault: polygon::Fault,
    },
}

impl Fault {
    /// The first face of the fault, if it is at one.
    #[must_use]
    pub fn face(&self) -> Option<usize> {
        match *self {
            Fault::Crossing([face, _]) | Fault::Doubled([face, _]) | Fault::Folded([face, _]) => Some(face),
            Fault::Flat(face) | Fault::Repeated(face) | Fault::NoPolygon { face, .. } => Some(face),
            Fault::InsideOut => None,
        }
    }

    /// The reason in words, with faces named by a function, and the fix.
    #[must_use]
    pub fn told(&self, face: impl Fn(usize) -> String) -> (String, &'static str) {
        match *self {
            Fault::NoPolygon { face: a, ref fault } => {
                (format!("face {} is not a polygon: {fault}", face(a)), fault.cure())
            }
            Fault::InsideOut => ("the mesh is inside out: its volume is negative".to_owned(), "turn all faces over"),
            Fault::Folded([a, b]) => (
                format!("faces {} and {} with a common edge lie on each other", face(a), face(b)),
                "leave out the part between them",
            ),
            Fault::Crossing([a, b]) => (
                format!("faces {} and {} pass through each other", face(a), face(b)),
                "divide the mesh where it crosses itself",
            ),
            Fault::Doubled([a, b]) => {
                (format!("faces {} and {} lie on each other, and look in one direction", face(a), face(b)), "keep one")
            }
            Fault::Repeated(a) => {
                (format!("face {} has two corners in a row at one place", face(a)), "leave one of them out")
            }
            Fault::Flat(a) => (format!("the closed part with face {} has no volume", face(a)), "leave the part out"),
        }
    }
}

/// The first fault of a mesh of at most [`COMPARED`] faces; larger meshes are not examined.
#[must_use]
pub fn fault(scene: &Scene, faces: &[Vec<Vertex>], is_closed: bool) -> Option<Fault> {
    if faces.len() > COMPARED {
        return None;
    }
    for (at, face) in faces.iter().enumerate().filter(|(_, face)| face.len() > 3) {
        let ends = face.iter().zip(face.iter().cycle().skip(1));
        if ends.into_iter().any(|(&a, &b)| scene.point3(a) == scene.point3(b)) {
            return Some(Fault::Repeated(at));
        }
        if let Some(fault) = no_polygon(scene, face) {
            return Some(Fault::NoPolygon { face: at, fault });
        }
    }
    let fans = faces.iter().enumerate().filter_map(|(at, face)| Some((at, fan(scene, face)?)));
    let triangles: Vec<(usize, [Vertex; 3])> =
        fans.flat_map(|(at, fan)| fan.into_iter().map(move |triangle| (at, triangle))).collect();
    let boxes = Boxes::new(triangles.iter().map(|(_, triangle)| extent(triangle.map(|v| scene.point3(v)))).collect());
    let mut near = Vec::new();
    for (at, &(face, triangle)) in triangles.iter().enumerate() {
        boxes.near(&boxes.all()[at], 0.0, &mut near);
        near.sort_unstable();
        for &(other_face, other) in
            near.iter().map(|&other| other as usize).filter(|&other| other > at).map(|other| &triangles[other])
        {
            if other_face == face {
                continue;
            }
            let pair = [face, other_face];
            let shared = || faces[face].iter().filter(|v| faces[other_face].contains(v)).count();
            match meet(scene, triangle, other) {
                Meeting::Apart => {}
                Meeting::Crossing => return Some(Fault::Crossing(pair)),
                Meeting::SameWay => return Some(Fault::Doubled(pair)),
                Meeting::BackToBack if shared() == 2 => return Some(Fault::Folded(pair)),
                Meeting::BackToBack => {}
            }
        }
    }
    if is_closed { flat(scene, faces) } else { None }
}

/// The triangles of a fan around the first corner; `None` if a corner of the face is not convex.
fn fan(scene: &Scene, face: &[Vertex]) -> Option<Vec<[Vertex; 3]>> {
    let triangles: Vec<[Vertex; 3]> =
        (1..face.len().saturating_sub(1)).map(|at| [face[0], face[at], face[at + 1]]).collect();
    let plane = [Plane::Xy, Plane::Yz, Plane::Zx]
        .into_iter()
        .find(|&plane| triangles.iter().any(|triangle| !sign(scene, Question::Orient2d(plane), triangle).is_zero()))?;
    let turns = |corners: [Vertex; 3]| sign(scene, Question::Orient2d(plane), &corners);
    let count = face.len();
    let corners = (0..count).map(|at| [face[at], face[(at + 1) % count], face[(at + 2) % count]]);
    let mut signs =
        corners.map(turns).chain(triangles.iter().map(|&triangle| turns(triangle))).filter(|sign| !sign.is_zero());
    let first = signs.next()?;
    if !signs.all(|sign| sign == first) {
        return None;
    }
    Some(triangles.into_iter().filter(|&triangle| !turns(triangle).is_zero()).collect())
}

/// The reason why the corners of a face make no polygon, in the first coordinate plane in which they turn.
fn no_polygon(scene: &Scene, face: &[Vertex]) -> Option<polygon::Fault> {
    let of_three = |plane: Plane| {
        (1..face.len()).any(|at| {
            (at + 1..face.len())
                .any(|other| !sign(scene, Question::Orient2d(plane), &[face[0], face[at], face[other]]).is_zero())
        })
    };
    let plane = [Plane::Xy, Plane::Yz, Plane::Zx].into_iter().find(|&plane| of_three(plane))?;
    let polygon = Polygon::new(scene, plane, false, &[face.to_vec()]);
    polygon.fault().cloned()
}

/// The relation of two triangles.
enum Meeting {
    /// They touch, or are apart.
    Apart,
    /// An edge of one passes through the inside of the other.
    Crossing,
    /// They overlap in one plane, and look in one direction.
    SameWay,
    /// They overlap in one plane, and look in opposite directions.
    BackToBack,
}

fn meet(scene: &Scene, first: [Vertex; 3], second: [Vertex; 3]) -> Meeting {
    let sides_of = |[a, b, c]: [Vertex; 3], others: [Vertex; 3]| {
        others.map(|v| if [a, b, c].contains(&v) { Sign::Zero } else { sign(scene, Question::Orient3d, &[a, b, c, v]) })
    };
    let of_second = sides_of(first, second);
    if of_second == [Sign::Zero; 3] {
        return overlap(scene, first, second);
    }
    let is_across = |sides: [Sign; 3]| sides.contains(&Sign::Positive) && sides.contains(&Sign::Negative);
    if !is_across(of_second) {
        return Meeting::Apart;
    }
    let of_first = sides_of(second, first);
    match is_across(of_first) && (pierces(scene, second, of_second, first) || pierces(scene, first, of_first, second)) {
        true => Meeting::Crossing,
        false => Meeting::Apart,
    }
}

/// True if an edge of a triangle, whose corners are on these sides of another triangle, passes through its inside.
fn pierces(scene: &Scene, [a, b, c]: [Vertex; 3], sides: [Sign; 3], [p, q, r]: [Vertex; 3]) -> bool {
    [(a, sides[0], b, sides[1]), (b, sides[1], c, sides[2]), (c, sides[2], a, sides[0])].into_iter().any(
        |(u, from, v, to)| {
            let turns = [[p, q], [q, r], [r, p]].map(|[x, y]| {
                if [u, v].contains(&x) || [u, v].contains(&y) {
                    Sign::Zero
                } else {
                    sign(scene, Question::Orient3d, &[u, v, x, y])
                }
            });
            from * to == Sign::Negative && turns[0] != Sign::Zero && turns == [turns[0]; 3]
        },
    )
}

/// Compares two triangles in one plane. They overlap if no line along a side of one separates them.
fn overlap(scene: &Scene, first: [Vertex; 3], second: [Vertex; 3]) -> Meeting {
    let turn = |plane: Plane, [a, b, c]: [Vertex; 3]| {
        if a == b || b == c || a == c { Sign::Zero } else { sign(scene, Question::Orient2d(plane), &[a, b, c]) }
    };
    let plane = [Plane::Xy, Plane::Yz, Plane::Zx].into_iter().find(|&plane| !turn(plane, first).is_zero());
    let Some(plane) = plane else { return Meeting::Apart };
    let (way, other_way) = (turn(plane, first), turn(plane, second));
    let separates = |[a, b, c]: [Vertex; 3], way: Sign, other: [Vertex; 3]| {
        [[a, b], [b, c], [c, a]].into_iter().any(|[p, q]| other.iter().all(|&v| turn(plane, [p, q, v]) != way))
    };
    if separates(first, way, second) || separates(second, other_way, first) {
        return Meeting::Apart;
    }
    if way == other_way { Meeting::SameWay } else { Meeting::BackToBack }
}

/// The first closed part without volume, by its first face, or the whole mesh if its volume is negative. Faces with a
/// common vertex are of one part.
fn flat(scene: &Scene, faces: &[Vec<Vertex>]) -> Option<Fault> {
    let mut part: Vec<usize> = (0..scene.len()).collect();
    fn root(part: &mut [usize], mut at: usize) -> usize {
        while part[at] != at {
            part[at] = part[part[at]];
            at = part[at];
        }
        at
    }
    for face in faces {
        for pair in face.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|v| root(&mut part, v.index()));
            part[a.max(b)] = a.min(b);
        }
    }
    let mut volumes: Vec<(Rational, Option<usize>)> = vec![(Rational::new(), None); scene.len()];
    for (at, face) in faces.iter().enumerate() {
        let entry = &mut volumes[root(&mut part, face.first()?.index())];
        entry.1.get_or_insert(at);
        let points: Vec<[Rational; 3]> = face.iter().map(|&v| scene.point3(v).map(rational)).collect();
        for pair in points.get(1..).unwrap_or_default().windows(2) {
            entry.0 += volume([&points[0], &pair[0], &pair[1]]);
        }
    }
    let whole: Rational = volumes.iter().map(|(volume, _)| volume).sum();
    let flat = volumes.into_iter().filter(|(volume, _)| volume.is_zero()).find_map(|(_, face)| face);
    flat.map(Fault::Flat).or((whole < 0).then_some(Fault::InsideOut))
}
