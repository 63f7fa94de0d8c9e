//! The contacts of an answer, compared with the [truth](crate::truth::contacts) about both meshes.

use std::collections::BTreeMap;

use predicament_predicates::Vertex;
use rug::Rational;

use super::chains::{Chain, Segments, plane};
use super::{Laws, Point, Violations, note};
use crate::answer::{Contact, Contacts};
use crate::truth::contacts::contacts;

impl Laws<'_> {
    fn at(&self, v: Vertex) -> &Point {
        &self.points[self.place(v)]
    }

    /// Compares contacts with all intersections of two triangles: faces for each pair of triangles, segments as one
    /// set, and points.
    pub fn contacts(&self, listed: &Contacts, found: &mut Violations) {
        let given = &self.points[..self.scene.len()];
        let Some(truth) = contacts(given, [&self.meshes[0], &self.meshes[1]]) else { return };
        let mut faces: BTreeMap<[u32; 2], (Chain, Rational)> = BTreeMap::new();
        let area = |corners: [&Point; 3]| plane(corners).map_or_else(Rational::new, |(_, area)| area);
        for (of, polygon) in &truth.faces {
            let (chain, left) = faces.entry(*of).or_default();
            for pair in polygon[1..].windows(2) {
                let corners = [&polygon[0], &pair[0], &pair[1]];
                chain.add(corners, 1);
                *left += area(corners);
            }
        }
        let of_first = |Contact { of, .. }: &Contact| self.meshes[0].triangles()[of[0] as usize];
        for face in &listed.faces {
            let front = area(of_first(face).map(|v| self.at(v)));
            let (chain, left) = faces.entry(face.of).or_default();
            for &[a, b, c] in &face.triangles {
                let corners = [a, b, c].map(|v| self.at(v));
                let own = area(corners);
                let corners = if own.cmp0() == front.cmp0() { [a, b, c] } else { [a, c, b] }.map(|v| self.at(v));
                chain.add(corners, -1);
                *left -= area(corners);
            }
        }
        let wrong = || faces.iter().filter_map(|(of, (chain, left))| Some((of, chain.rest()?, left)));
        if let Some((of, at, left)) = wrong().next() {
            let got = format!(
                "{} of {} faces, first that of triangles {of:?}, near {at:?}: {:e} is missing of its area as seen along an \
                 axis",
                wrong().count(),
                truth.faces.len(),
                left.to_f64().abs() / 2.0
            );
            let law = "solids touch in the common parts of two triangles in one plane, one solid on either side";
            note(found, "faces of contact", got, law);
        }
        let mut segments = Segments::default();
        truth.segments.iter().for_each(|[a, b]| segments.add([a, b], 1));
        listed.segments.iter().for_each(|ends| segments.add(ends.map(|v| self.at(v)), -1));
        if let Some(at) = segments.rest() {
            let got = format!("{} listed, and one is wrong or missing at {at:?}", listed.segments.len());
            let law = "solids touch in the segments of both surfaces without a common inside or a face of contact";
            note(found, "segments of contact", got, law);
        }
        let mut points: BTreeMap<&Point, i64> = truth.points.iter().map(|p| (p, 1)).collect();
        listed.points.iter().for_each(|&v| *points.entry(self.at(v)).or_default() -= 1);
        if let Some((at, times)) = points.iter().find(|(_, times)| **times != 0) {
            let at = at.each_ref().map(Rational::to_f64);
            let got = if *times > 0 { format!("{at:?} is not listed") } else { format!("{at:?} is listed") };
            let law =
                "solids touch in the points of both surfaces without a common inside, a face or a segment of contact";
            note(found, "points of contact", got, law);
        }
    }
}
