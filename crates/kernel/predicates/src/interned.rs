//! A list of constructions that holds each construction once.
//!
//! A vertex is its definition, so the same definition always gives the same vertex. Ids are indices in the list: they
//! depend only on the order in which definitions are added.
//!
//! A hash table of ids, with open addressing, finds the index; the definitions themselves are in the list. At most half
//! of the table is occupied. A look-up therefore compares one or two definitions, and the table takes 8 to 16 bytes per
//! vertex.
//!
//! The last definitions that are in ascending order are not in the table: a greater definition is new, and bisection
//! finds the others. Algorithms that construct many vertices in one call define them in this order.

use crate::{Construction, Vertex};
use alloc::{vec, vec::Vec};

/// Constructions in canonical form, by id, and the id of each.
#[derive(Clone, Default)]
pub(crate) struct Interned {
    list: Vec<Construction>,
    /// The number of constructions in the table: the first of the list. The others are in ascending order.
    indexed: usize,
    /// The hash table: index in the list plus one, or 0 for a free slot.
    ///
    /// An entry is at the first slot from its hash on that was free. The number of slots is a power of two, or zero.
    table: Vec<u32>,
}

impl Interned {
    /// The constructions in the order of their ids.
    #[inline]
    pub(crate) fn list(&self) -> &[Construction] {
        &self.list
    }

    /// The vertex of a construction; `None` if it is not in the list.
    #[inline]
    pub(crate) fn find(&self, construction: &Construction) -> Option<Vertex> {
        let found = if self.indexed == 0 { None } else { self.look_up(construction) };
        found.or_else(|| {
            let last = &self.list[self.indexed..];
            let at = if self.is_after_all(construction) { None } else { last.binary_search(construction).ok() };
            at.map(|at| Vertex::constructed(self.indexed + at))
        })
    }

    #[inline]
    fn look_up(&self, construction: &Construction) -> Option<Vertex> {
        let mut place = self.home(construction);
        loop {
            match self.table[place] {
                0 => return None,
                entry if self.list[entry as usize - 1] == *construction => {
                    return Some(Vertex::constructed(entry as usize - 1));
                }
                _ => place = (place + 1) & (self.table.len() - 1),
            }
        }
    }

    /// The vertex of a construction, which is added if it is not in the list; `None` if there are too many.
    #[inline]
    pub(crate) fn intern(&mut self, construction: Construction) -> Option<Vertex> {
        // The usual case: everything is in ascending order.
        if self.indexed == 0 && self.is_after_all(&construction) {
            return self.append(construction);
        }
        self.find(&construction).or_else(|| self.push(construction))
    }

    /// Adds a construction that is not in the list; `None` if there are too many.
    #[inline]
    pub(crate) fn push(&mut self, construction: Construction) -> Option<Vertex> {
        if !self.is_after_all(&construction) {
            self.index();
        }
        self.append(construction)
    }

    #[inline]
    fn append(&mut self, construction: Construction) -> Option<Vertex> {
        if self.list.len() == Vertex::MAX_CONSTRUCTED {
            return None;
        }
        self.list.push(construction);
        Some(Vertex::constructed(self.list.len() - 1))
    }

    /// Returns true if a construction is greater than all those that are not in the table.
    #[inline]
    fn is_after_all(&self, construction: &Construction) -> bool {
        self.list[self.indexed..].last().is_none_or(|greatest| construction.is_after(greatest))
    }

    /// Reserves space for `more` constructions.
    pub(crate) fn reserve(&mut self, more: usize) {
        self.list.reserve(more);
    }

    /// Adds all constructions to the table.
    #[cold]
    #[inline(never)]
    fn index(&mut self) {
        if self.table.len() < 2 * self.list.len() {
            self.table = vec![0; (2 * self.list.len()).next_power_of_two().max(16)];
            self.indexed = 0;
        }
        for index in self.indexed..self.list.len() {
            let mut place = self.home(&self.list[index]);
            while self.table[place] != 0 {
                place = (place + 1) & (self.table.len() - 1);
            }
            self.table[place] = entry(index + 1);
        }
        self.indexed = self.list.len();
    }

    /// Removes all constructions after the first `count`.
    pub(crate) fn truncate(&mut self, count: usize) {
        while self.indexed > count {
            // Last in, first out: the removed entries have not displaced an entry that is still in the list.
            let mut place = self.home(&self.list[self.indexed - 1]);
            while self.table[place] != entry(self.indexed) {
                place = (place + 1) & (self.table.len() - 1);
            }
            self.table[place] = 0;
            self.indexed -= 1;
        }
        self.list.truncate(count);
    }

    /// The slot where the search begins.
    #[inline]
    fn home(&self, construction: &Construction) -> usize {
        #[allow(clippy::cast_possible_truncation)] // the mask keeps fewer bits
        let bits = construction.hash() as usize;
        bits & (self.table.len() - 1)
    }
}

/// A table entry: an index plus one. (There are at most 2^31 vertices.)
#[inline]
#[allow(clippy::cast_possible_truncation)]
fn entry(count: usize) -> u32 {
    count as u32
}

/// Compares the lists; the table follows from the list.
impl PartialEq for Interned {
    fn eq(&self, other: &Interned) -> bool {
        self.list == other.list
    }
}

/// Writes the list alone.
impl core::fmt::Debug for Interned {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        self.list.fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lines through neighbours in a grid: their ids differ in few bits.
    fn definition(i: usize) -> Construction {
        let v = Vertex::input;
        Construction::Ssi([[v(i % 64), v(i % 64 + 1)], [v(100 + i / 64), v(i / 64 + 200)]])
    }

    /// After any additions and removals, `find` finds exactly the constructions in the list.
    #[test]
    fn what_was_removed_leaves_no_trace() {
        let mut interned = Interned::default();
        let check = |interned: &Interned| {
            let count = interned.list().len();
            for i in 0..2100 {
                let found = interned.find(&definition(i));
                assert_eq!(found, (i < count).then(|| Vertex::constructed(i)), "{i} of {count}");
            }
        };
        for to in [1, 20, 7, 1000, 999, 0, 300, 2000, 1500, 1501, 16, 17] {
            for i in interned.list().len()..to {
                assert_eq!(interned.find(&definition(i)), None);
                assert_eq!(interned.intern(definition(i)), Some(Vertex::constructed(i)));
            }
            interned.truncate(to);
            check(&interned);
            let mut reserved = interned.clone();
            reserved.reserve(5000);
            check(&reserved);
            assert!(reserved == interned);
        }
    }

    /// Entries are as far from their hash slot as chance predicts: 1/2 at a load of one half, for uniform hashes.
    #[test]
    fn hashes_are_even() {
        let v = Vertex::input;
        let solid = |i: usize| Construction::Lpi { line: [v(i), v(i + 1)], plane: [v(i + 2), v(i + 3), v(i + 4)] };
        let planes = |i: usize| Construction::Tpi([[v(0), v(1), v(2)], [v(0), v(1), v(3 + i)], [v(5), v(6), v(7 + i)]]);
        let chained = |i: usize| Construction::Ssi([[v(0), v(i + 1)], [v(1), Vertex::constructed(i)]]);
        for define in [&definition as &dyn Fn(usize) -> Construction, &solid, &planes, &chained] {
            let mut interned = Interned::default();
            let mut steps = 0;
            for i in 0..1 << 12 {
                interned.intern(define(i));
            }
            interned.index();
            for i in 0..1 << 12 {
                let mut place = interned.home(&define(i));
                while interned.table[place] != entry(i + 1) {
                    place = (place + 1) & (interned.table.len() - 1);
                    steps += 1;
                }
            }
            assert_eq!(interned.table.len(), 1 << 13);
            assert!((1400..2800).contains(&steps), "{steps}");
        }
    }
}
