//! Counting sort.

/// The numbers of items in groups.
pub(super) struct Counts {
    /// For each group the place of its first item, two places later.
    first: Vec<u32>,
    all: usize,
}

impl Counts {
    pub fn new(groups: usize) -> Counts {
        Counts { first: vec![0; groups + 2], all: 0 }
    }

    /// Counts an item of a group.
    #[inline]
    pub fn add(&mut self, group: u32) {
        self.first[group as usize + 2] += 1;
        self.all += 1;
    }

    /// The groups, to be filled with as many items as were counted.
    pub fn groups<T: Copy>(self, blank: T) -> Groups<T> {
        let Counts { mut first, all } = self;
        for group in 2..first.len() {
            first[group] += first[group - 1];
        }
        Groups { first, items: vec![blank; all] }
    }
}

/// Items by group, in the order given.
pub(super) struct Groups<T> {
    /// Filling a group makes its start that of the next one.
    first: Vec<u32>,
    items: Vec<T>,
}

impl<T> Groups<T> {
    /// Adds an item to a group.
    #[inline]
    pub fn add(&mut self, group: u32, item: T) {
        let place = &mut self.first[group as usize + 1];
        self.items[*place as usize] = item;
        *place += 1;
    }

    /// The place of each group's first item, the number of items; and all items.
    pub fn finish(mut self) -> (Vec<u32>, Vec<T>) {
        self.first.pop();
        (self.first, self.items)
    }
}
