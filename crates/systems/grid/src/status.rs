//! The status of a sweep line: the items that it crosses, from below to above, in blocks of bounded size.
//!
//! Only searches call a predicate: ⌈log₂⌉ times.

/// The mark of a missing number.
const NONE: u32 = u32::MAX;

/// The maximum number of items of a block.
const MOST: usize = 256;

/// A sequence of different items; an item is a small number.
#[derive(Default)]
pub struct Status {
    /// The blocks by their numbers; the numbers do not give their order.
    blocks: Vec<Vec<u32>>,
    /// The numbers of the blocks that are not empty, in order.
    order: Vec<u32>,
    /// Empty blocks, for reuse.
    free: Vec<u32>,
    /// The block of each item.
    home: Vec<u32>,
}

impl Status {
    /// The last item for which `is_below` is true, if such items come first; otherwise any of these items or `None`.
    pub fn last_below(&self, mut is_below: impl FnMut(u32) -> bool) -> Option<u32> {
        let block = self.order.partition_point(|&block| is_below(self.blocks[block as usize][0])).checked_sub(1)?;
        let items = &self.blocks[self.order[block] as usize];
        // The first item is known to be below.
        let at = items[1..].partition_point(|&item| is_below(item));
        Some(items[at])
    }

    /// The lowest item.
    pub fn first(&self) -> Option<u32> {
        self.order.first().map(|&block| self.blocks[block as usize][0])
    }

    /// The item directly above another one.
    pub fn above(&self, item: u32) -> Option<u32> {
        let home = self.home[item as usize];
        let own = &self.blocks[home as usize];
        if let Some(&next) = own.get(self.place(home, item) + 1) {
            return Some(next);
        }
        let block = self.order.iter().position(|&block| block == home)?;
        self.order.get(block + 1).map(|&block| self.blocks[block as usize][0])
    }

    /// Inserts an item directly above another one, or below all.
    pub fn insert_above(&mut self, other: Option<u32>, item: u32) {
        let (block, at) = match other {
            Some(other) => {
                let block = self.home[other as usize];
                (block, self.place(block, other) + 1)
            }
            None => match self.order.first() {
                Some(&block) => (block, 0),
                None => {
                    let block = self.new_block();
                    self.order.push(block);
                    (block, 0)
                }
            },
        };
        self.settle(item, block);
        self.blocks[block as usize].insert(at, item);
        if self.blocks[block as usize].len() > MOST {
            self.split(block);
        }
    }

    /// Removes an item.
    pub fn remove(&mut self, item: u32) {
        let block = self.home[item as usize];
        let at = self.place(block, item);
        self.blocks[block as usize].remove(at);
        if self.blocks[block as usize].is_empty() {
            self.order.retain(|&other| other != block);
            self.free.push(block);
        }
    }

    /// The number of items below this one.
    pub fn count_below(&self, item: u32) -> usize {
        let home = self.home[item as usize];
        let before = self.order.iter().take_while(|&&block| block != home);
        before.map(|&block| self.blocks[block as usize].len()).sum::<usize>() + self.place(home, item)
    }

    /// The position of an item in its block.
    fn place(&self, block: u32, item: u32) -> usize {
        self.blocks[block as usize].iter().position(|&other| other == item).unwrap_or_default()
    }

    fn settle(&mut self, item: u32, block: u32) {
        if self.home.len() <= item as usize {
            self.home.resize(item as usize + 1, NONE);
        }
        self.home[item as usize] = block;
    }

    fn new_block(&mut self) -> u32 {
        self.free.pop().unwrap_or_else(|| {
            self.blocks.push(Vec::with_capacity(MOST + 1));
            number(self.blocks.len() - 1)
        })
    }

    /// Moves the upper half of a block to a new one.
    fn split(&mut self, block: u32) {
        let new = self.new_block();
        let half = self.blocks[block as usize].split_off(MOST / 2);
        half.iter().for_each(|&item| self.home[item as usize] = new);
        self.blocks[new as usize] = half;
        let at = self.order.iter().position(|&other| other == block).unwrap_or_default();
        self.order.insert(at + 1, new);
    }
}

/// A position as it is stored: all lists here have fewer than 2^32 items.
fn number(place: usize) -> u32 {
    u32::try_from(place).unwrap_or(NONE)
}
