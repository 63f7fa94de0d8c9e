//! A line along z that is moved along y in a plane across x: the cubes that it meets, the octants around its points.

use super::levels::Levels;

/// The line in a plane.
pub(super) struct Line {
    /// The cubes that meet the plane, by their lower and by their upper faces along z.
    sorted: [Vec<u32>; 2],
    /// The place of each cube in these lists.
    places: [Vec<u32>; 2],
    /// The places of the cubes that meet the line, as bits.
    present: [Vec<u64>; 2],
    /// For each plane along z, the number of cubes that have the line's point there inside.
    covers: Vec<u32>,
}

impl Line {
    pub(super) fn new(z: &Levels) -> Line {
        let places = || vec![0; z.of.len()];
        Line {
            sorted: [Vec::new(), Vec::new()],
            places: [places(), places()],
            present: [Vec::new(), Vec::new()],
            covers: vec![0; z.faces.len()],
        }
    }

    /// Moves the line to a place before the first cubes of another plane, which are given as `sorted`.
    pub(super) fn restart(&mut self, sorted: [impl Iterator<Item = u32>; 2]) {
        for (end, cubes) in sorted.into_iter().enumerate() {
            self.sorted[end].clear();
            for (place, cube) in (0..).zip(cubes) {
                self.sorted[end].push(cube);
                self.places[end][cube as usize] = place;
            }
            self.present[end].clear();
            self.present[end].resize(self.sorted[end].len().div_ceil(64), 0);
        }
    }

    /// Adds a cube that meets the line, or removes it.
    pub(super) fn toggle(&mut self, cube: u32) {
        for end in [0, 1] {
            let place = self.places[end][cube as usize];
            self.present[end][place as usize / 64] ^= 1 << (place % 64);
        }
    }

    /// Counts a cube that has a part of the line inside.
    pub(super) fn cover(&mut self, z: &Levels, cube: u32) {
        self.inside(z, cube).iter_mut().for_each(|count| *count += 1);
    }

    /// Undoes [`Line::cover`].
    pub(super) fn uncover(&mut self, z: &Levels, cube: u32) {
        self.inside(z, cube).iter_mut().for_each(|count| *count -= 1);
    }

    fn inside(&mut self, z: &Levels, cube: u32) -> &mut [u32] {
        let [lower, upper] = z.of[cube as usize];
        &mut self.covers[lower as usize + 1..upper as usize]
    }

    /// True if all points of the line at the planes from `first` to `last` are inside of cubes.
    pub(super) fn is_covered(&self, [first, last]: [u32; 2]) -> bool {
        // By blocks, which the compiler makes loops without branches.
        let mut blocks = self.covers[first as usize..=last as usize].chunks(32);
        blocks.all(|block| block.iter().fold(true, |all, &count| all & (count > 0)))
    }

    fn cubes(&self, end: usize) -> impl Iterator<Item = u32> + '_ {
        self.present[end].iter().zip(self.sorted[end].chunks(64)).flat_map(|(&word, cubes)| {
            let mut word = word;
            std::iter::from_fn(move || {
                let cube = (word != 0).then(|| cubes[word.trailing_zeros() as usize]);
                word &= word.wrapping_sub(1);
                cube
            })
        })
    }

    /// Calls `found` with each plane along z where the line's octants change, and with their pattern around that point.
    /// `quarters` says which of the four quarters around the line a cube fills, between its planes along z.
    pub(super) fn sweep(&self, z: &Levels, quarters: impl Fn(u32) -> u8, mut found: impl FnMut(u32, u8)) {
        let [mut lowers, mut uppers] = [self.cubes(0).peekable(), self.cubes(1).peekable()];
        let plane = |cube: u32, end: usize| z.of[cube as usize][end];
        let mut covers = [0_i32; 4];
        let mut below = 0;
        while let Some(&upper) = uppers.peek() {
            let at = lowers.peek().map_or(plane(upper, 1), |&lower| plane(lower, 0).min(plane(upper, 1)));
            let mut count = |cube: u32, by: i32| {
                let quarters = quarters(cube);
                (0..4).for_each(|quarter| covers[quarter] += if quarters >> quarter & 1 == 1 { by } else { 0 });
            };
            while let Some(cube) = lowers.next_if(|&cube| plane(cube, 0) == at) {
                count(cube, 1);
            }
            while let Some(cube) = uppers.next_if(|&cube| plane(cube, 1) == at) {
                count(cube, -1);
            }
            let above = (0..4).fold(0, |bits, quarter| bits | u8::from(covers[quarter] > 0) << quarter);
            if above != below {
                found(at, below | above << 4);
            }
            below = above;
        }
    }
}
