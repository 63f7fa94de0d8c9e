//! Items with equal words: points at one position, triangles with the same corners.

use super::near::number;

/// The index for no item.
pub(super) const NONE: u32 = u32::MAX;

/// The bits of a point; −0 becomes 0.
pub(super) fn bits(p: [f64; 3]) -> [u64; 3] {
    p.map(|x| (x + 0.0).to_bits())
}

/// A hash of three words.
fn mixed(words: [u64; 3]) -> usize {
    // (Odd numbers without a pattern; any others would do.)
    let sum = words[0].wrapping_mul(0x9e37_79b9_7f4a_7c15)
        ^ words[1].wrapping_mul(0xc2b2_ae3d_27d4_eb4f).rotate_left(21)
        ^ words[2].wrapping_mul(0x1656_67b1_9e37_79f9).rotate_left(42);
    #[allow(clippy::cast_possible_truncation)] // the lower half is as good
    let low = (sum ^ sum >> 32) as usize;
    low
}

/// A hash table of items by three words, with linear probing.
pub(super) struct Table {
    slots: Vec<u32>,
}

impl Table {
    /// Inserts the items `0..count`; items without words are left out, and of those with the same words the first is
    /// kept.
    pub fn of(count: usize, words: &dyn Fn(usize) -> [u64; 3]) -> Table {
        let mut table = Table { slots: vec![NONE; (2 * count).next_power_of_two()] };
        for at in 0..count {
            let own = words(at);
            let slot = table.slot(own, &|other| words(other) == own);
            if table.slots[slot] == NONE {
                table.slots[slot] = number(at);
            }
        }
        table
    }

    /// The slot of an item, or the empty slot for it.
    fn slot(&self, words: [u64; 3], is_it: &dyn Fn(usize) -> bool) -> usize {
        let mut slot = mixed(words) & (self.slots.len() - 1);
        while self.slots[slot] != NONE && !is_it(self.slots[slot] as usize) {
            slot = (slot + 1) & (self.slots.len() - 1);
        }
        slot
    }

    pub fn get(&self, words: [u64; 3], is_it: &dyn Fn(usize) -> bool) -> u32 {
        self.slots[self.slot(words, is_it)]
    }
}
