//! Validation that a mesh bounds its regions: it does not cross itself, and is not inside out.
//!
//! The first property is decided for all pairs of triangles whose boxes meet: no edge of one passes through the inside
//! of the other, and no two triangles lie on each other: a region between them would be flat. Parts may touch in points
//! and edges. If edges cross edges, meshes can overlap without such a passage. The second test finds this, and meshes
//! that are inside out. It compares the stated regions in front of a triangle's middle and behind it with the winding
//! numbers of all other triangles. It tests a sample of triangles, one of each component before all others.

use predicament_judge::solids::{Materials, Place};
use predicament_judge::{rational, sign};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Plane, Question, Scene, Sign, Vertex};
use rug::Rational;

use super::content::TwoMeshes;

/// The maximum number of triangles of both meshes that are checked by default; larger meshes are checked on request.
pub(super) const CHECKED: usize = 2_000;
/// The number of triangles whose sides are tested.
const SAMPLED: usize = 24;
/// Directions of rays, in general position for most meshes.
const DIRECTIONS: [[i32; 3]; 4] = [[83, 31, 17], [-29, 71, 43], [13, -47, 97], [-61, -7, 89]];

/// True if meshes are refused unless `check` is false: they are small enough to be checked, and invalid.
pub(super) fn is_refused(scene: &Scene, meshes: [&MaterialMesh; 2]) -> bool {
    let count: usize = meshes.iter().map(|mesh| mesh.triangles().len()).sum();
    count <= CHECKED && meshes.into_iter().any(|mesh| flaw(scene, mesh).is_some())
}

/// The reason why a scene is not one of the task, and the fix.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Invalid {
    /// The reason, with the place.
    pub why: String,
    /// The fix, in one line.
    pub cure: &'static str,
}

/// The first flaw of meshes that are small enough to be checked, unless they are taken as they are.
pub(super) fn invalid(scene: &Scene, content: &TwoMeshes) -> Option<Invalid> {
    if content.is_as_it_is || content.triangles() > CHECKED {
        return None;
    }
    let mut both = content.meshes.iter().zip(["first", "second"]);
    both.find_map(|(mesh, name)| {
        let flaw = flaw(scene, mesh)?;
        let why = flaw.told(&format!("the {name} mesh"), |triangle| triangle.to_string());
        Some(Invalid { why, cure: flaw.cure() })
    })
}

/// A flaw of a mesh.
pub(super) enum Flaw {
    /// Two triangles pass through each other.
    Crossing([usize; 2]),
    /// Two triangles of one plane have a part in common.
    Overlap([usize; 2]),
    /// The stated region in front of this triangle, or behind it, is wrong.
    Side { triangle: usize, is_front: bool, region: u32, place: Place },
}

impl Flaw {
    /// The first triangle of the flaw.
    pub fn triangle(&self) -> usize {
        match self {
            Flaw::Crossing([a, b]) | Flaw::Overlap([a, b]) => *a.min(b),
            Flaw::Side { triangle, .. } => *triangle,
        }
    }

    /// The fix, in one line.
    pub fn cure(&self) -> &'static str {
        match self {
            Flaw::Crossing(_) => {
                "cut them where they cross (`corpus resolve` does so), or write `check = false` to take the mesh as it is"
            }
            Flaw::Overlap(_) => {
                "unite the parts of the mesh first (`corpus resolve` does so), or write `check = false` to take the mesh \
                 as it is"
            }
            Flaw::Side { .. } => {
                "turn over the parts that are inside out, and join the parts that overlap (`corpus resolve` joins \
                 them); or write `check = false` to take the mesh as it is"
            }
        }
    }

    /// The flaw as text, for a mesh and triangles with these names.
    pub fn told(&self, mesh: &str, name: impl Fn(usize) -> String) -> String {
        match self {
            Flaw::Crossing([a, b]) => {
                format!("triangles {} and {} of {mesh} pass through each other", name(*a), name(*b))
            }
            Flaw::Overlap([a, b]) => {
                format!("triangles {} and {} of {mesh} lie on each other", name(*a), name(*b))
            }
            Flaw::Side { triangle, is_front, region, place } => {
                let side = if *is_front { "in front of" } else { "behind" };
                let there = match place {
                    Place::In(region) => format!("region {region}"),
                    Place::Windings(windings) => {
                        let each = windings.iter().map(|(region, winding)| format!("{winding} times region {region}"));
                        each.collect::<Vec<_>>().join(" and ")
                    }
                    Place::On(_) => "another triangle".to_owned(),
                };
                format!("{side} triangle {} of {mesh} is {there}; expected: region {region}", name(*triangle))
            }
        }
    }
}

/// The first flaw of a mesh.
pub(super) fn flaw(scene: &Scene, mesh: &MaterialMesh) -> Option<Flaw> {
    let crossing = pair(scene, mesh, &|a, b| passes(scene, a, b) || passes(scene, b, a)).map(Flaw::Crossing);
    let overlap = || pair(scene, mesh, &|a, b| overlap(scene, a, b)).map(Flaw::Overlap);
    crossing.or_else(overlap).or_else(|| side(scene, mesh))
}

/// The first pair of triangles whose boxes meet that has a property; the first index is the lower one.
fn pair(scene: &Scene, mesh: &MaterialMesh, has: &dyn Fn([Vertex; 3], [Vertex; 3]) -> bool) -> Option<[usize; 2]> {
    let boxes: Vec<[[f64; 2]; 3]> = mesh.triangles().iter().map(|triangle| bounds(scene, *triangle)).collect();
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|&a, &b| boxes[a][0][0].total_cmp(&boxes[b][0][0]));
    let mut found: Option<[usize; 2]> = None;
    for (at, &first) in order.iter().enumerate() {
        let beside = order[at + 1..].iter().take_while(|&&second| boxes[second][0][0] <= boxes[first][0][1]);
        for &second in beside {
            let is_near = (1..3).all(|axis| {
                let [[low, high], [from, to]] = [boxes[first][axis], boxes[second][axis]];
                low <= to && from <= high
            });
            let pair = [first.min(second), first.max(second)];
            if is_near && found.is_none_or(|found| pair < found) {
                let [a, b] = pair.map(|at| mesh.triangles()[at]);
                if has(a, b) {
                    found = Some(pair);
                }
            }
        }
    }
    found
}

fn bounds(scene: &Scene, triangle: [Vertex; 3]) -> [[f64; 2]; 3] {
    let corners = triangle.map(|v| scene.point3(v));
    [0, 1, 2].map(|axis| {
        let [a, b, c] = corners.map(|corner| corner[axis]);
        [a.min(b).min(c), a.max(b).max(c)]
    })
}

/// True if two triangles of one plane have more in common than their borders: no edge of either has the other beyond
/// it.
fn overlap(scene: &Scene, first: [Vertex; 3], second: [Vertex; 3]) -> bool {
    let [a, b, c] = first;
    let is_off = |v: &Vertex| sign(scene, Question::Orient3d, &[a, b, c, *v]) != Sign::Zero;
    if second.iter().any(is_off) {
        return false;
    }
    let turn = |plane: Plane, [a, b, c]: [Vertex; 3]| sign(scene, Question::Orient2d(plane), &[a, b, c]);
    let planes = [Plane::Xy, Plane::Yz, Plane::Zx];
    let Some(plane) = planes.into_iter().find(|plane| !turn(*plane, first).is_zero()) else { return false };
    let has_beyond = |corners: [Vertex; 3], other: [Vertex; 3]| {
        let inside = turn(plane, corners);
        let [a, b, c] = corners;
        [[a, b], [b, c], [c, a]].into_iter().any(|[u, v]| other.iter().all(|w| turn(plane, [u, v, *w]) != inside))
    };
    !has_beyond(first, second) && !has_beyond(second, first)
}

/// True if an edge of one triangle passes through the inside of another.
fn passes(scene: &Scene, edges: [Vertex; 3], [a, b, c]: [Vertex; 3]) -> bool {
    let ask = |args: [Vertex; 4]| sign(scene, Question::Orient3d, &args);
    let sides = edges.map(|v| ask([a, b, c, v]));
    (0..3).any(|at| {
        let next = (at + 1) % 3;
        let [p, q] = [edges[at], edges[next]];
        let is_through = sides[at] != Sign::Zero && sides[at] == -sides[next];
        is_through && {
            let turns = [ask([p, q, a, b]), ask([p, q, b, c]), ask([p, q, c, a])];
            turns[0] != Sign::Zero && turns == [turns[0]; 3]
        }
    })
}

/// The first triangle of a sample with wrong regions on its sides.
fn side(scene: &Scene, mesh: &MaterialMesh) -> Option<Flaw> {
    let materials = Materials::new(scene, mesh.triangles(), mesh.sides());
    let judge = materials.in_integers();
    for triangle in sample(mesh) {
        let corners = mesh.triangles()[triangle].map(|v| scene.point3(v).map(rational));
        let middle = [0, 1, 2].map(|axis: usize| {
            let sum: Rational = corners.iter().map(|corner| &corner[axis]).sum();
            sum / 3
        });
        let [front, behind] = mesh.sides()[triangle];
        for turn in [1, -1] {
            let beside =
                |those: &[u32]| DIRECTIONS.iter().find_map(|way| judge.beside(those, &middle, way.map(|x| x * turn)));
            let own = u32::try_from(triangle).unwrap_or(u32::MAX);
            let Some((is_front, place)) = beside(&[own]) else { continue };
            let region = if is_front { front } else { behind };
            let wrong = match place {
                Place::In(found) if found == region => None,
                // Beyond all coincident triangles here, there is one region.
                Place::On(others) => {
                    let all: Vec<u32> = [own].into_iter().chain(others).collect();
                    beside(&all).map(|(_, place)| place).filter(|place| matches!(place, Place::Windings(_)))
                }
                place => Some(place),
            };
            if let Some(place) = wrong {
                return Some(Flaw::Side { triangle, is_front, region, place });
            }
        }
    }
    None
}

/// The first triangle of each component, and others, evenly spread.
fn sample(mesh: &MaterialMesh) -> Vec<usize> {
    let count = mesh.triangles().iter().flatten().map(|v| v.index() + 1).max().unwrap_or(0);
    let mut parent: Vec<usize> = (0..count).collect();
    fn root(parent: &mut [usize], mut at: usize) -> usize {
        while parent[at] != at {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        at
    }
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|v| root(&mut parent, v.index()));
        parent[b] = a;
        let [a, c] = [a, c].map(|at| root(&mut parent, at));
        parent[c] = a;
    }
    let (mut seen, mut chosen) = (vec![false; count], Vec::new());
    for (at, triangle) in mesh.triangles().iter().enumerate() {
        let root = root(&mut parent, triangle[0].index());
        if !std::mem::replace(&mut seen[root], true) {
            chosen.push(at);
        }
    }
    chosen.truncate(SAMPLED / 2);
    let step = mesh.triangles().len().div_ceil(SAMPLED - chosen.len()).max(1);
    chosen.extend((0..mesh.triangles().len()).step_by(step));
    chosen.sort_unstable();
    chosen.dedup();
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_of_one_plane_lie_on_each_other_or_touch() {
        let points =
            [[0, 0, 0], [4, 0, 0], [0, 4, 0], [4, 4, 0], [1, 1, 0], [2, 1, 0], [1, 2, 0], [8, 0, 0], [0, 0, 4]];
        let scene = Scene::from_points3(&points.map(|point| point.map(f64::from))).unwrap();
        let lie = |second: [usize; 3]| overlap(&scene, [0, 1, 2].map(Vertex::input), second.map(Vertex::input));
        for (other, is_on) in [
            ([0, 1, 2], true),
            ([2, 1, 0], true),
            ([4, 5, 6], true),
            ([0, 1, 3], true),
            ([4, 7, 3], true),
            ([1, 2, 3], false),
            ([1, 7, 3], false),
            ([0, 1, 8], false),
        ] {
            assert_eq!(lie(other), is_on, "{other:?}");
            let [a, b, c] = other;
            assert_eq!(lie([b, a, c]), is_on, "{other:?} turned");
        }
    }
}
