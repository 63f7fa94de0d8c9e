//! The intersection of two surfaces, by their registrations.

use std::collections::{BTreeMap, BTreeSet};

use predicament_mesh::{Complex, Simplex};

use super::Arrangement;
use crate::algorithm::pairs::Contacts;

/// The merged points that a triangle of each complex have in common.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Meeting {
    /// The triangles, by their indices in the complexes.
    pub triangles: [u32; 2],
    /// The merged points on both, ascending. One point: the triangles touch there. Two points: they meet along a piece
    /// of a curve. More points: they overlap.
    pub points: Vec<usize>,
}

/// All pairs of triangles with a merged point in common.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Intersection {
    /// The pairs, in the order of the triangles.
    pub meetings: Vec<Meeting>,
}

impl Intersection {
    /// The meeting of these two triangles, if they have a merged point in common.
    #[must_use]
    pub fn of(&self, triangles: [u32; 2]) -> Option<&Meeting> {
        let place = self.meetings.binary_search_by_key(&triangles, |meeting| meeting.triangles).ok()?;
        Some(&self.meetings[place])
    }

    /// The pieces of the intersection curves, each by its ends, the lower point first. A piece along an edge that
    /// triangles share is listed once.
    #[must_use]
    pub fn pieces(&self) -> Vec<[usize; 2]> {
        let pieces = self.meetings.iter().filter_map(|meeting| <[usize; 2]>::try_from(&meeting.points[..]).ok());
        pieces.collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// The number of pairs of triangles that overlap.
    #[must_use]
    pub fn overlaps(&self) -> usize {
        self.meetings.iter().filter(|meeting| meeting.points.len() > 2).count()
    }
}

impl Arrangement {
    /// The intersection of two surfaces that were merged by these contacts: each registration between faces of two
    /// triangles puts its point on both.
    ///
    /// # Panics
    /// If the arrangement was made from other contacts.
    #[must_use]
    pub fn intersection(&self, complexes: [&Complex; 2], contacts: &Contacts) -> Intersection {
        assert_eq!(contacts.registered.len(), self.of_contacts().len(), "the arrangement's own contacts");
        let above = complexes.map(triangles_above);
        let mut meetings: BTreeMap<[u32; 2], BTreeSet<usize>> = BTreeMap::new();
        for (contact, &point) in contacts.registered.iter().zip(self.of_contacts()) {
            let [of_a, of_b] = [(&above[0], contact.a), (&above[1], contact.b)].map(|(above, face)| above.get(&face));
            for &s in of_a.into_iter().flatten() {
                for &t in of_b.into_iter().flatten() {
                    meetings.entry([s, t]).or_default().insert(point);
                }
            }
        }
        let meeting =
            |(triangles, points): (_, BTreeSet<usize>)| Meeting { triangles, points: points.into_iter().collect() };
        Intersection { meetings: meetings.into_iter().map(meeting).collect() }
    }
}

/// For each face, the triangles that contain it, itself included.
fn triangles_above(complex: &Complex) -> BTreeMap<Simplex, Vec<u32>> {
    let mut above: BTreeMap<Simplex, Vec<u32>> = BTreeMap::new();
    for (index, &[a, b, c]) in (0_u32..).zip(complex.triangles()) {
        for face in [&[a][..], &[b], &[c], &[a, b], &[a, c], &[b, c], &[a, b, c]] {
            let face = complex.find(face).expect("a complex has the faces of its simplices");
            above.entry(face).or_default().push(index);
        }
    }
    above
}
