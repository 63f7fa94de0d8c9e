//! The regions of parts that their borders do not decide, and of triangles that the other mesh does not touch.
//!
//! Parts and triangles with a common vertex off the other mesh are in one region, and so are parts on both sides of an
//! edge off the other mesh. Union-find joins them. A set without a decided part is located: by a vertex off the other
//! mesh, or if there is none by a ray from a point of a part.

use std::collections::BTreeMap;
use std::sync::Arc;

use predicament_grid::Bounds;
use predicament_mesh::{MaterialMesh, OUTSIDE};
use predicament_mesh_locate::algorithm::Location;
use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::face::{Part, Place};
use crate::algorithm::overlay::near::number;
use crate::algorithm::overlay::regions::{Sets, locations};
use crate::algorithm::overlay::{Contradiction, Extent, Undone};
use crate::algorithm::ray::Ray;

/// A mesh whose regions are sought.
pub(super) struct Regions<'a> {
    pub session: &'a dyn Predicates,
    /// The mesh's triangles, by representatives, and `None` for those that the other mesh touches.
    pub untouched: &'a (dyn Fn(usize) -> Option<[Vertex; 3]> + Sync),
    pub count: usize,
    /// The parts of touched triangles.
    pub parts: &'a [Part],
    pub other: &'a Arc<MaterialMesh>,
    pub bounds: &'a Bounds<3>,
    pub extent: Extent,
}

/// The regions of a mesh.
pub(super) struct Decided {
    /// For each triangle that is not touched, its region of the other mesh.
    pub whole: Vec<Option<u32>>,
    /// For each part, its place.
    pub places: Vec<Place>,
}

impl Regions<'_> {
    pub fn decided(&self) -> Result<Decided, Undone> {
        let inputs = number(self.session.scene().len());
        // A number for each input vertex, for each part, and for the outside.
        let outside = inputs + number(self.parts.len());
        let of_part = |at: usize| inputs + number(at);
        let mut sets = Sets::new(outside as usize + 1);
        let at = |v: Vertex| number(v.index());
        for place in 0..self.count {
            if let Some([a, b, c]) = (self.untouched)(place) {
                sets.join(at(a), at(b));
                sets.join(at(b), at(c));
            }
        }
        let mut open: BTreeMap<[Vertex; 2], u32> = BTreeMap::new();
        for (part, place) in self.parts.iter().zip(0..) {
            part.off.iter().for_each(|&v| sets.join(at(v), of_part(place)));
            for &ends in &part.open {
                let other = *open.entry(ends).or_insert(of_part(place));
                sets.join(other, of_part(place));
            }
        }
        let mut known: BTreeMap<u32, u32> = BTreeMap::new();
        for (part, place) in self.parts.iter().zip(0..) {
            if let Place::Region(region) = part.place
                && *known.entry(sets.find(of_part(place))).or_insert(region) != region
            {
                return Err(Undone::Broken(Contradiction::OneRegion));
            }
        }
        self.locate(&mut sets, &mut known)?;
        let region = |sets: &mut Sets, place: u32| known.get(&sets.find(place)).copied();
        let whole = (0..self.count).map(|place| region(&mut sets, at((self.untouched)(place)?[0]))).collect();
        let place = |(part, place): (&Part, usize)| match part.place {
            Place::Unknown => region(&mut sets, of_part(place)).map_or(Place::Unknown, Place::Region),
            known => known,
        };
        let places = self.parts.iter().zip(0..).map(place).collect();
        Ok(Decided { whole, places })
    }

    /// Locates the sets that are not known.
    fn locate(&self, sets: &mut Sets, known: &mut BTreeMap<u32, u32>) -> Result<(), Undone> {
        let inputs = number(self.session.scene().len());
        let mut unknown: BTreeMap<u32, Vertex> = BTreeMap::new();
        let mut seen = BTreeMap::new();
        let corners = (0..self.count).filter_map(|place| (self.untouched)(place)).map(|corners| corners[0]);
        for v in corners.chain(self.parts.iter().flat_map(|part| part.off.first().copied())) {
            let root = sets.find(number(v.index()));
            if !known.contains_key(&root) {
                unknown.entry(root).or_insert(v);
            }
        }
        let scene = self.session.scene();
        unknown.retain(|root, v| {
            let p = scene.point3(*v);
            let is_far = !self.bounds.is_near(&Bounds { low: p, high: p }, 0.0);
            if is_far {
                seen.insert(*root, OUTSIDE);
            }
            !is_far
        });
        let queries: Vec<Vertex> = unknown.values().copied().collect();
        for (root, location) in unknown.into_keys().zip(locations(self.session, self.other, &queries, self.extent)) {
            let Location::In(region) = location else { return Err(Undone::Broken(Contradiction::VertexRegion)) };
            seen.insert(root, region);
        }
        known.extend(seen);
        for (part, place) in self.parts.iter().zip(0..) {
            let root = sets.find(inputs + place);
            if part.place == Place::Unknown && !known.contains_key(&root) {
                known.insert(root, self.by_ray(part.triangles[0])?);
            }
        }
        Ok(())
    }

    /// The region in which a triangle is, by a ray from a point of it.
    fn by_ray(&self, triangle: [Vertex; 3]) -> Result<u32, Undone> {
        let planes = match self.extent {
            Extent::Whole => &[Plane::Xy, Plane::Yz, Plane::Zx][..],
            // A ray across another plane would leave the column.
            Extent::Columns => &[Plane::Xy],
        };
        let [a, b, c] = triangle;
        let plane = planes.iter().find(|plane| !self.session.orient2d(**plane, a, b, c).is_zero());
        let ray = Ray::new(triangle, *plane.ok_or(Undone::Broken(Contradiction::VertexRegion))?);
        let mut sums: BTreeMap<u32, i32> = BTreeMap::new();
        for (&corners, &[front, behind]) in self.other.triangles().iter().zip(self.other.sides()) {
            let [entered, left] = match ray.passes(self.session, corners)? {
                Sign::Zero => continue,
                Sign::Positive => [front, behind],
                Sign::Negative => [behind, front],
            };
            *sums.entry(left).or_default() += 1;
            *sums.entry(entered).or_default() -= 1;
        }
        sums.remove(&OUTSIDE);
        sums.retain(|_, sum| *sum != 0);
        match sums.into_iter().collect::<Vec<_>>()[..] {
            [] => Ok(OUTSIDE),
            [(region, 1)] => Ok(region),
            _ => Err(Undone::Broken(Contradiction::VertexRegion)),
        }
    }
}
