//! The hits of a query in a scene with broken ties, by the judge's signs.
//!
//! A perturbation by infinitesimals can only lead to faces that the unperturbed line meets, borders included. Each of
//! these is asked about. A hit's place is the number of hits before it, by constructed points. If a line is parallel to
//! the plane of a face before the perturbation, or the backend constructs no vertex, there are no such points. Then the
//! order has to agree with the places at which the unperturbed query meets the faces.

use std::collections::BTreeSet;

use predicament_judge::{Judged, TieJudge};
use predicament_predicates::{Axis, Construction, Predicates, Scene, Sign, Vertex};
use rug::Rational;

use super::Known;
use crate::answer::{Extent, Feature, Groups, Hit, edges};

/// The hits of one query in a scene with broken ties, faces only.
pub enum Perturbed {
    /// The hits in order.
    Ordered(Groups),
    /// The faces that are hit. Their order is not known.
    Faces(BTreeSet<u32>),
}

/// A line against a mesh in a scene with broken ties.
pub struct Ties<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The signs of ties.
    pub judge: &'a TieJudge,
    /// The mesh.
    pub triangles: &'a [[Vertex; 3]],
    /// The part of the line that counts.
    pub extent: Extent,
    /// True if points may be constructed.
    pub constructs: bool,
}

impl Ties<'_> {
    /// The hits of a query.
    #[must_use]
    pub fn hits(&self, ends: [Vertex; 2], known: &Known) -> Perturbed {
        let mut judged = Judged::perturbed(self.scene, self.judge);
        let faces: Vec<u32> = known.on_line.iter().filter(|&&face| self.is_hit(&judged, ends, face)).copied().collect();
        match self.constructs.then(|| self.ordered(&mut judged, ends, &faces)).flatten() {
            Some(groups) => Perturbed::Ordered(groups),
            None => Perturbed::Faces(faces.into_iter().collect()),
        }
    }

    fn is_hit(&self, judged: &Judged<'_>, [p, q]: [Vertex; 2], face: u32) -> bool {
        let [a, b, c] = self.triangles[face as usize];
        let sides = edges([a, b, c]).map(|[u, v]| judged.orient3d(p, q, u, v));
        let side = sides[0];
        let before = judged.orient3d(a, b, c, p) * side;
        let after = judged.orient3d(a, b, c, q) * side;
        side != Sign::Zero
            && sides == [side; 3]
            && (!self.extent.has_start() || before != Sign::Positive)
            && (!self.extent.has_end() || after != Sign::Negative)
    }

    /// The faces in order; `None` if the judge does not construct a hit.
    fn ordered(&self, judged: &mut Judged<'_>, ends: [Vertex; 2], faces: &[u32]) -> Option<Groups> {
        let definition = |face: &u32| Construction::Lpi { line: ends, plane: self.triangles[*face as usize] };
        let points = judged.construct(&faces.iter().map(definition).collect::<Vec<_>>()).ok()?;
        let [p, q] = ends;
        let axes = [Axis::X, Axis::Y, Axis::Z].map(|axis| (axis, judged.compare(axis, p, q)));
        let (axis, ahead) = axes.into_iter().find(|(_, sign)| *sign != Sign::Zero)?;
        let rank = |point: Vertex| points.iter().filter(|&&other| judged.compare(axis, other, point) == ahead).count();
        let mut ranked: Vec<(usize, Hit)> = faces
            .iter()
            .zip(&points)
            .map(|(&face, &point)| (rank(point), Hit { feature: Feature::Face(face), is_along: false }))
            .collect();
        ranked.sort_unstable();
        Some(ranked.chunk_by(|a, b| a.0 == b.0).map(|group| group.iter().map(|(_, hit)| *hit).collect()).collect())
    }
}

impl Perturbed {
    /// True if these are the hits.
    #[must_use]
    pub fn is(&self, groups: &Groups, known: &Known) -> bool {
        match self {
            Perturbed::Ordered(wanted) => groups == wanted,
            Perturbed::Faces(wanted) => {
                let face = |hit: &Hit| match hit.feature {
                    Feature::Face(face) if !hit.is_along => Some(face),
                    _ => None,
                };
                let Some(faces) = groups.iter().flatten().map(face).collect::<Option<Vec<u32>>>() else { return false };
                let is_set = faces.len() == wanted.len() && faces.iter().all(|face| wanted.contains(face));
                is_set && is_in_order(&faces, known)
            }
        }
    }

    /// The hits; `None` if their order is not known.
    #[must_use]
    pub fn groups(&self) -> Option<&Groups> {
        match self {
            Perturbed::Ordered(groups) => Some(groups),
            Perturbed::Faces(_) => None,
        }
    }
}

/// True if places can be chosen from what the faces have in common with the query, none before the one before it.
#[must_use]
pub fn is_in_order(faces: &[u32], known: &Known) -> bool {
    let mut reached: Option<&Rational> = None;
    faces.iter().filter_map(|face| known.met.iter().find(|met| met.face == *face)).all(|met| {
        let [from, to] = &met.part;
        let fits = reached.is_none_or(|reached| to >= reached);
        reached = Some(reached.map_or(from, |reached| reached.max(from)));
        fits
    })
}
