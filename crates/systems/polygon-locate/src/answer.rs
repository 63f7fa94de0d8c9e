//! Locations of points: the type of the algorithm's answers and of the truth.

/// The location of a point: the regions that contain it and the regions whose boundary contains it, ascending; no
/// region is in both.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Location<'a> {
    /// Regions with an odd crossing number.
    pub inside: &'a [u32],
    /// Regions that own an edge through the point, by the session's answers.
    pub boundary: &'a [u32],
}

/// The answers to many queries, in order, in two flat arrays.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Locations {
    inside: Lists,
    boundary: Lists,
    asked: usize,
}

/// Lists of regions, one after another.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
struct Lists {
    /// The end index of each list.
    ends: Vec<usize>,
    items: Vec<u32>,
}

impl Lists {
    const EMPTY: Lists = Lists { ends: Vec::new(), items: Vec::new() };

    fn push(&mut self, list: &[u32]) {
        self.items.extend_from_slice(list);
        self.ends.push(self.items.len());
    }

    /// Reserves memory for all these lists at once.
    fn reserve<'a>(&mut self, lists: impl Iterator<Item = &'a Lists>) {
        let [ends, items] =
            lists.fold([0, 0], |[ends, items], list| [ends + list.ends.len(), items + list.items.len()]);
        self.ends.reserve_exact(ends);
        self.items.reserve_exact(items);
    }

    fn append(&mut self, other: &Lists) {
        let base = self.items.len();
        self.ends.extend(other.ends.iter().map(|end| base + end));
        self.items.extend_from_slice(&other.items);
    }

    fn get(&self, at: usize) -> &[u32] {
        let start = if at == 0 { 0 } else { self.ends[at - 1] };
        &self.items[start..self.ends[at]]
    }
}

impl Locations {
    fn none(asked: usize) -> Locations {
        Locations { inside: Lists::EMPTY, boundary: Lists::EMPTY, asked }
    }

    /// An empty result with capacity for `asked` queries.
    pub(crate) fn with_capacity(asked: usize) -> Locations {
        let mut all = Locations::none(asked);
        all.inside.ends.reserve_exact(asked);
        all.boundary.ends.reserve_exact(asked);
        all
    }

    /// Adds the answer to the next query.
    pub(crate) fn push(&mut self, location: Location<'_>) {
        self.inside.push(location.inside);
        self.boundary.push(location.boundary);
    }

    /// Concatenates the answers of all parts, for `asked` queries.
    pub(crate) fn joined<'a, I: Iterator<Item = &'a Locations>>(asked: usize, parts: impl Fn() -> I) -> Locations {
        let mut all = Locations::none(asked);
        all.inside.reserve(parts().map(|part| &part.inside));
        all.boundary.reserve(parts().map(|part| &part.boundary));
        for part in parts() {
            all.inside.append(&part.inside);
            all.boundary.append(&part.boundary);
        }
        all
    }

    /// Collects answers: the regions that contain each query, and the regions whose boundary contains it, both
    /// ascending.
    #[must_use]
    pub fn of(answers: impl Iterator<Item = (Vec<u32>, Vec<u32>)>) -> Locations {
        let mut all = Locations::none(0);
        for (inside, boundary) in answers {
            all.push(Location { inside: &inside, boundary: &boundary });
            all.asked += 1;
        }
        all
    }

    /// The number of answered queries; these are the first ones.
    #[must_use]
    pub fn len(&self) -> usize {
        self.inside.ends.len()
    }

    /// True if no query is answered.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// True if all queries are answered; false after an early stop.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.len() == self.asked
    }

    /// The regions that contain query `at`, ascending.
    ///
    /// # Panics
    /// If the query is not answered.
    #[must_use]
    pub fn inside(&self, at: usize) -> &[u32] {
        self.inside.get(at)
    }

    /// The regions whose boundary contains query `at`, ascending.
    ///
    /// # Panics
    /// If the query is not answered.
    #[must_use]
    pub fn boundary(&self, at: usize) -> &[u32] {
        self.boundary.get(at)
    }

    /// The location of query `at`.
    ///
    /// # Panics
    /// If the query is not answered.
    #[must_use]
    pub fn get(&self, at: usize) -> Location<'_> {
        Location { inside: self.inside(at), boundary: self.boundary(at) }
    }

    /// The answers in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Location<'_>> + '_ {
        (0..self.len()).map(|at| self.get(at))
    }
}
