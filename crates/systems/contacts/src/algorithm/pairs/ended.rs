//! The ended pairs: pairs with a registered sub-pair.
//!
//! Registrations are few compared with the simplices, and those of one simplex are few compared with all. So they are
//! stored by the first simplex. One look-up for a simplex finds the registrations of its faces, for all its candidates.
//! Most simplices have none, and then their candidates need no test.

use predicament_mesh::{Complex, FaceFinder, Simplex};

use super::Contact;

/// The registered pairs of the previous levels, by their first simplex.
#[derive(Default)]
pub(super) struct Ended<'a> {
    tables: Option<Tables<'a>>,
}

struct Tables<'a> {
    faces: [FaceFinder<'a>; 2],
    /// For each rank, the start of each simplex' partners, and at the end their number.
    starts: [Vec<u32>; 4],
    partners: [Vec<Simplex>; 4],
}

impl<'a> Ended<'a> {
    /// Stores all registrations so far. Before the first registration, look-ups return at once.
    pub(super) fn learn(&mut self, [a, b]: [&'a Complex; 2], registered: &[Contact]) {
        if registered.is_empty() {
            return;
        }
        let faces = match self.tables.take() {
            Some(tables) => tables.faces,
            None => [a, b].map(FaceFinder::new),
        };
        let mut by_first: Vec<[Simplex; 2]> = registered.iter().map(|contact| [contact.a, contact.b]).collect();
        by_first.sort_unstable();
        let counts = [a.vertices().len(), a.edges().len(), a.triangles().len(), a.tetrahedra().len()];
        let mut starts = counts.map(|count| Vec::with_capacity(count + 1));
        let mut partners: [Vec<Simplex>; 4] = Default::default();
        for rank in 0..4_u8 {
            let of_rank = rank as usize;
            let mut pairs = by_first.iter().filter(|[s, _]| s.rank == rank).peekable();
            for index in 0..=counts[of_rank] {
                let start = partners[of_rank].len();
                starts[of_rank].push(u32::try_from(start).expect("fewer than 2^32 registrations"));
                while let Some([_, t]) = pairs.next_if(|[s, _]| s.index as usize == index) {
                    partners[of_rank].push(*t);
                }
            }
        }
        self.tables = Some(Tables { faces, starts, partners });
    }

    /// The simplices that `s` and its faces are registered with, in ascending order.
    pub(super) fn partners(&self, s: Simplex, partners: &mut Vec<Simplex>) {
        partners.clear();
        let Some(tables) = &self.tables else { return };
        tables.faces[0].each(s, |face| {
            let starts = &tables.starts[face.rank as usize];
            let [start, end] = [starts[face.index as usize], starts[face.index as usize + 1]];
            partners.extend(&tables.partners[face.rank as usize][start as usize..end as usize]);
        });
        partners.sort_unstable();
    }

    /// True if one of these [partners](Ended::partners) is a face of `t`, or `t`.
    pub(super) fn has_face(&self, partners: &[Simplex], t: Simplex) -> bool {
        let Some(tables) = self.tables.as_ref().filter(|_| !partners.is_empty()) else { return false };
        let mut has = false;
        tables.faces[1].each(t, |face| has |= partners.binary_search(&face).is_ok());
        has
    }
}
