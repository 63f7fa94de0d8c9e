//! Checks of parts of a closed mesh that other programs cut by planes, in doubles.
//!
//! A program's vertices are rounded, so its parts are compared with the mesh at a distance, `within`, which is that of
//! its farthest vertex from the mesh's surface and the planes, and at least that of a few roundings.
//!
//! * `vertex off the cuts`: each vertex is within that distance of a face of the mesh or of a plane.
//! * `open part`: at each edge of a part, as many triangles come as go. Vertices at one place are one vertex here.
//! * `part across a plane`: no part has vertices on both sides of a plane that are farther than the distance from it.
//! * `wrong part`: a point that is farther than that from the mesh's surface and from all planes is in exactly one part
//!   if it is inside of the mesh, and otherwise in no part. Every cell between the planes has
//!   such points: they show a small part that is lost.
//! * `crossing faces`: no edge of a part passes through a triangle of it by more than the distance.
//! * `volume of parts`: the volumes of all parts add up to that of the mesh, up to the volume of their surfaces widened
//!   by the distance.
//! * `Euler characteristic of parts`: the sum over all parts is that of the cut solid (module `euler`).
//!
//! The boundary of a true part consists of pieces of faces and of planes. A surface whose vertices are within δ of
//! where they belong is within δ of the true one, because the distance of two triangles is largest at their corners. So
//! a part differs from the true one only within δ of faces and planes, and that is all that the checks demand. A part
//! may be given in several pieces: together they must have each point once.

use predicament_judge::rational;
use predicament_judge::skin::{Corners, Skin, area, candidates, length};
use rug::Rational;

use super::exact::Plane;
use super::{euler, pieces};

/// The check of vertices.
pub const OFF: &str = "vertex off the cuts";
/// The check of edges.
pub const OPEN: &str = "open part";
/// The check of planes.
pub const SIDE: &str = "part across a plane";
/// The check of points.
pub const PART: &str = "wrong part";
/// The check of triangles that pass through each other.
pub const CROSSING: &str = "crossing faces";
/// The check of volumes.
pub const VOLUME: &str = "volume of parts";
/// The check of components, cavities and handles.
pub const EULER: &str = "Euler characteristic of parts";

/// A violation of a law.
#[derive(Clone, PartialEq, Debug)]
pub struct Violation {
    /// The name of the check.
    pub check: &'static str,
    /// The first place, in words.
    pub what: String,
    /// The distance from the mesh and the planes that explains it; `None` if no distance does.
    pub distance: Option<f64>,
}

/// A closed mesh, and the planes that cut it.
pub struct Cuts {
    mesh: Skin,
    planes: Vec<Plane>,
    /// Three points of each plane.
    corners: Vec<Corners>,
}

impl Cuts {
    /// A closed mesh of triangles, and planes by three points each.
    #[must_use]
    pub fn new(mesh: Vec<Corners>, planes: &[Corners]) -> Cuts {
        let plane = |points: &Corners| {
            let [a, b, c] = points.map(|p| p.map(rational));
            Plane::of([&a, &b, &c])
        };
        Cuts { mesh: Skin::new(mesh), planes: planes.iter().map(plane).collect(), corners: planes.to_vec() }
    }

    /// The distance of a point from the mesh and the planes. The search begins at a distance.
    fn distance(&self, p: [f64; 3], from: f64) -> f64 {
        let exact = p.map(rational);
        let of_planes = self.planes.iter().map(|plane| plane.distance(&exact)).fold(f64::INFINITY, f64::min);
        // Distances from the mesh cost more.
        if of_planes <= from { of_planes } else { of_planes.min(self.mesh.distance(p, from)) }
    }

    /// The largest distance of a vertex from the mesh and the planes; zero without vertices.
    #[must_use]
    pub fn farthest(&self, parts: &[Skin], nearest: f64) -> f64 {
        let mut vertices: Vec<[f64; 3]> =
            parts.iter().flat_map(|part| part.triangles().as_flattened()).copied().collect();
        vertices.sort_by(|p, q| p.partial_cmp(q).unwrap_or(std::cmp::Ordering::Equal));
        vertices.dedup();
        vertices.into_iter().map(|p| self.distance(p, nearest)).fold(0.0, f64::max)
    }

    /// The laws that the parts violate at this distance; `most` is the number of points that are tested, and of
    /// triangles that are compared with those near them.
    #[must_use]
    pub fn violations(&self, parts: &[Skin], [within, coarsest]: [f64; 2], most: usize) -> Vec<Violation> {
        let mut found = Vec::new();
        for (at, part) in parts.iter().enumerate() {
            if let Some(what) = part.open() {
                found.push(Violation { check: OPEN, what: format!("part {at}: {what}"), distance: None });
            }
            found.extend(self.across(at, part, within));
            if let Some(what) = part.pierced(within, most) {
                found.push(Violation { check: CROSSING, what: format!("part {at}: {what}"), distance: None });
            }
        }
        // A part on both sides of a plane is in two cells.
        let has_cells = found.iter().all(|flaw| flaw.check == CROSSING);
        found.extend(self.points(parts, [within, coarsest], most));
        found.extend(self.volume(parts, within));
        if has_cells {
            found.extend(self.euler(parts, within));
        }
        found
    }

    /// The sum that the parts of a right answer have.
    #[cfg(test)]
    fn wanted(&self) -> Option<i64> {
        euler::wanted(&self.mesh, &self.planes, 1e-15)
    }

    /// The sum of the Euler characteristics, where rounding cannot change it.
    fn euler(&self, parts: &[Skin], within: f64) -> Option<Violation> {
        let wanted = euler::wanted(&self.mesh, &self.planes, within)?;
        let sum = euler::found(parts, &self.planes, within, wanted).filter(|sum| *sum != wanted)?;
        let what = format!("the surfaces of all parts add up to {sum}, expected {wanted}");
        Some(Violation { check: EULER, what, distance: None })
    }

    /// The plane that a part is farthest across.
    fn across(&self, at: usize, part: &Skin, within: f64) -> Option<Violation> {
        let vertices: Vec<[Rational; 3]> = part.triangles().as_flattened().iter().map(|p| p.map(rational)).collect();
        let reach = |plane: &Plane| {
            let mut reach = [0.0_f64; 2];
            for p in &vertices {
                let side = match plane.side(p) {
                    std::cmp::Ordering::Less => 0,
                    std::cmp::Ordering::Equal => continue,
                    std::cmp::Ordering::Greater => 1,
                };
                reach[side] = reach[side].max(plane.distance(p));
            }
            reach[0].min(reach[1])
        };
        let all = self.planes.iter().map(reach).enumerate();
        let (plane, distance) = all.fold((0, 0.0), |most, one| if one.1 > most.1 { one } else { most });
        let what = || format!("part {at} is on both sides of plane {plane}, by {distance:e}");
        (distance > within).then(|| Violation { check: SIDE, what: what(), distance: Some(distance) })
    }

    /// Points beside the mesh and the parts that are in no part, in several, or in one though they are outside.
    fn points(&self, parts: &[Skin], [within, coarsest]: [f64; 2], most: usize) -> Option<Violation> {
        let beside = self.mesh.triangles().iter().chain(parts.iter().flat_map(Skin::triangles));
        let (mut wrong, mut count, mut worst) = (0, 0, None::<(f64, String)>);
        let middles = pieces::middles(self.mesh.triangles(), &self.corners, most / 2);
        for p in candidates(beside, [within, coarsest], most).into_iter().chain(middles) {
            let exact = p.map(rational);
            if self.mesh.is_near(p, within) || self.planes.iter().any(|plane| plane.distance(&exact) <= within) {
                continue;
            }
            let Some(wanted @ 0..=1) = self.mesh.winding(p) else { continue };
            let Some(windings) = parts.iter().map(|part| part.winding(p)).collect::<Option<Vec<i64>>>() else {
                continue;
            };
            count += 1;
            let around: i64 = windings.iter().sum();
            if around != wanted || windings.iter().any(|winding| !(0..=1).contains(winding)) {
                wrong += 1;
                let distance = self.distance(p, within);
                if worst.as_ref().is_none_or(|(most, _)| distance > *most) {
                    worst = Some((distance, format!("the parts go {around} times around {p:?}, expected {wanted}")));
                }
            }
        }
        worst.map(|(distance, what)| Violation {
            check: PART,
            what: format!("{what}; {wrong} of {count} points"),
            distance: Some(distance),
        })
    }

    fn volume(&self, parts: &[Skin], within: f64) -> Option<Violation> {
        let sum: Rational = parts.iter().map(Skin::six).sum();
        let off = (sum - self.mesh.six()).abs().to_f64() / 6.0;
        let all = || self.mesh.triangles().iter().chain(parts.iter().flat_map(Skin::triangles));
        let (area, length): (f64, f64) = (all().map(area).sum(), all().map(length).sum());
        let discs = 16.0 * length * within * within;
        let allowed = 4.0 * area * within + discs * (1.0 + within / length.max(f64::MIN_POSITIVE));
        let what = || format!("the volumes of all parts are {off:e} off; rounding explains {allowed:.1e}");
        (off > allowed).then(|| Violation { check: VOLUME, what: what(), distance: Some(off / area) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box from one corner to the other, with its triangles turned outwards.
    fn solid([low, high]: [[f64; 3]; 2]) -> Vec<Corners> {
        let corner =
            |bits: usize| [0, 1, 2].map(|axis: usize| if bits >> axis & 1 == 1 { high[axis] } else { low[axis] });
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]].map(|t| t.map(corner))).collect()
    }

    fn laws(parts: &[Vec<Corners>]) -> Vec<(&'static str, bool)> {
        let plane = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 1.0]];
        let cuts = Cuts::new(solid([[0.0; 3], [2.0, 1.0, 1.0]]), &[plane]);
        let parts: Vec<Skin> = parts.iter().map(|part| Skin::new(part.clone())).collect();
        let found = cuts.violations(&parts, [1e-15, 1e-6], 2_000);
        found.into_iter().map(|found| (found.check, found.distance.is_some_and(|off| off < 1e-6))).collect()
    }

    #[test]
    fn a_box_is_cut_into_two() {
        let [left, right] = [solid([[0.0; 3], [1.0; 3]]), solid([[1.0, 0.0, 0.0], [2.0, 1.0, 1.0]])];
        assert!(laws(&[left.clone(), right.clone()]).is_empty());
        assert_eq!(laws(&[solid([[0.0; 3], [2.0, 1.0, 1.0]])]), [(SIDE, false)], "not cut");
        let all = [(PART, false), (VOLUME, false), (EULER, false)];
        assert_eq!(laws(std::slice::from_ref(&left)), all, "a part lost");
        assert_eq!(laws(&[left.clone(), right.clone(), right.clone()]), all, "one twice");
        // Not cut in the plane, but by the millionth part of a millionth beside it.
        let x = 1.0 + 1e-12;
        let beside = [solid([[0.0; 3], [x, 1.0, 1.0]]), solid([[x, 0.0, 0.0], [2.0, 1.0, 1.0]])];
        assert_eq!(laws(&beside), [(SIDE, true)]);
        // Two pieces of one part are as good as one.
        let low = solid([[0.0; 3], [1.0, 1.0, 0.5]]);
        let high = solid([[0.0, 0.0, 0.5], [1.0; 3]]);
        assert!(laws(&[low, high, right]).is_empty());
    }
    /// The tip of a tetrahedron is lost. Its volume is that of the surface moved by half a millionth, but its middle is
    /// far from surface and plane. So few points beside triangles miss it.
    #[test]
    fn a_small_part_that_is_lost_is_not_rounded() {
        let [o, x, y, z] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
        let [u, v, w] = [[3.9375, 0.0, 0.0], [3.9375, 0.0625, 0.0], [3.9375, 0.0, 0.0625]];
        let plane = [u, [3.9375, 1.0, 0.0], [3.9375, 0.0, 1.0]];
        let cuts = Cuts::new(vec![[o, y, x], [o, x, z], [x, y, z], [o, z, y]], &[plane]);
        let rest = vec![[o, z, y], [u, v, w], [o, y, v], [o, v, u], [o, u, w], [o, w, z], [y, z, w], [y, w, v]];
        let tip = vec![[u, w, v], [u, v, x], [v, w, x], [w, u, x]];
        let laws = |parts: &[Vec<Corners>]| -> Vec<(&str, bool)> {
            let parts: Vec<Skin> = parts.iter().map(|part| Skin::new(part.clone())).collect();
            let found = cuts.violations(&parts, [1e-15, 1e-6], 60);
            found.into_iter().map(|found| (found.check, found.distance.is_some_and(|off| off < 1e-6))).collect()
        };
        assert!(laws(&[rest.clone(), tip]).is_empty());
        assert_eq!(laws(&[rest]), [(PART, false), (VOLUME, true), (EULER, false)]);
    }

    /// A bar with many triangles, cut once. A needle of air in a part begins on its surface and ends at the other side:
    /// its volume is below all bounds, and few points beside triangles miss it. The sum does not.
    #[test]
    fn a_cavity_that_no_point_sees_changes_the_sum() {
        let part = |from: f64, steps: u32| -> Vec<Corners> {
            let ring = |at: u32| {
                let x = from + f64::from(at) / f64::from(steps);
                [[x, 0.0, 0.0], [x, 1.0, 0.0], [x, 1.0, 1.0], [x, 0.0, 1.0]]
            };
            let ends = |[a, b, c, d]: [[f64; 3]; 4]| [[a, b, c], [a, c, d]];
            let band = |at: u32| {
                let (low, high) = (ring(at), ring(at + 1));
                (0..4_usize).flat_map(move |i| {
                    let j = (i + 1) % 4;
                    [[low[i], low[j], high[j]], [low[i], high[j], high[i]]]
                })
            };
            let [first, last] = [ends(ring(0)).map(|[a, b, c]| [a, c, b]), ends(ring(steps))];
            first.into_iter().chain((0..steps).flat_map(band)).chain(last).collect()
        };
        let plane = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 1.0]];
        let cuts = Cuts::new(solid([[0.0; 3], [2.0, 1.0, 1.0]]), &[plane]);
        let laws = |parts: &[Vec<Corners>]| -> Vec<&str> {
            let parts: Vec<Skin> = parts.iter().map(|part| Skin::new(part.clone())).collect();
            cuts.violations(&parts, [1e-15, 1e-6], 240).into_iter().map(|found| found.check).collect()
        };
        let (left, right) = (part(0.0, 64), part(1.0, 64));
        assert!(laws(&[left.clone(), right.clone()]).is_empty());
        let (x, e) = (0.40625, 2.0_f64.powi(-24));
        let [a, b, c, d] = [[x, 0.5, 0.0], [x + e, 0.5, 0.0], [x, 0.5 + e, 0.0], [x, 0.5, 1.0]];
        let needle = [[a, b, c], [a, d, b], [b, d, c], [c, d, a]];
        assert!(Skin::new(needle.to_vec()).six() < 0, "turned inwards");
        assert_eq!(laws(&[[left, needle.to_vec()].concat(), right]), [EULER]);
    }

    /// A square frame, cut by up to three planes.
    #[test]
    fn the_sum_knows_holes_lines_and_points() {
        let square = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
        let (outer, inner) = (square(-2.0, 2.0), square(-1.0, 1.0));
        let at = |[x, y]: [f64; 2], z: f64| [x, y, z];
        let mut frame: Vec<Corners> = Vec::new();
        let mut quad = |a, b, c, d| frame.extend([[a, b, c], [a, c, d]]);
        for i in 0..4 {
            let j = (i + 1) % 4;
            quad(at(outer[i], 0.0), at(outer[j], 0.0), at(outer[j], 1.0), at(outer[i], 1.0));
            quad(at(inner[j], 0.0), at(inner[i], 0.0), at(inner[i], 1.0), at(inner[j], 1.0));
            quad(at(outer[i], 1.0), at(outer[j], 1.0), at(inner[j], 1.0), at(inner[i], 1.0));
            quad(at(outer[j], 0.0), at(outer[i], 0.0), at(inner[i], 0.0), at(inner[j], 0.0));
        }
        let mesh = Skin::new(frame);
        assert!(mesh.open().is_none());
        let wanted = |planes: &[Corners]| Cuts::new(mesh.triangles().to_vec(), planes).wanted();
        let x = |x: f64| [[x, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]];
        let y = |y: f64| [[0.0, y, 0.0], [0.0, y, 1.0], [1.0, y, 0.0]];
        let z = |z: f64| [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]];
        assert_eq!(wanted(&[]), Some(0), "a torus");
        assert_eq!(wanted(&[x(0.25)]), Some(4), "two arcs");
        assert_eq!(wanted(&[z(0.5)]), Some(0), "two tori");
        assert_eq!(wanted(&[x(1.5)]), Some(2), "a bar and a narrower frame");
        assert_eq!(wanted(&[x(0.25), y(0.125)]), Some(8), "four corners");
        assert_eq!(wanted(&[x(1.5), y(1.25)]), Some(6), "a corner, two bars and a frame");
        assert_eq!(wanted(&[x(1.5), y(1.25), z(0.5)]), Some(12), "each of the four twice");
        assert_eq!(wanted(&[x(1.0)]), None, "through corners");
        assert_eq!(wanted(&[x(0.25), x(0.25 + 1e-14)]), None, "nearly one plane");
    }
}
