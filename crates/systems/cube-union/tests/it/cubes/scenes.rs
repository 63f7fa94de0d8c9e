//! Test scenes of cubes.

/// The SplitMix64 generator.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A random number from 0 to below `end`.
    pub fn below(&mut self, end: i64) -> i64 {
        (self.next() % end.cast_unsigned()).cast_signed()
    }

    /// `count` random lower corners in [0, end)³.
    pub fn lowers(&mut self, count: usize, end: i64) -> Vec<[i64; 3]> {
        (0..count).map(|_| [(); 3].map(|()| self.below(end))).collect()
    }

    pub fn shuffled<T: Clone>(&mut self, list: &[T]) -> Vec<T> {
        let mut list = list.to_vec();
        for end in (1..list.len()).rev() {
            let at = usize::try_from(self.below(i64::try_from(end).unwrap() + 1)).unwrap();
            list.swap(end, at);
        }
        list
    }
}

/// A lattice of n × n × n lower corners a pitch apart, x fastest.
pub fn lattice(n: i64, pitch: i64) -> Vec<[i64; 3]> {
    let at = move |i: i64| [i % n, i / n % n, i / (n * n)].map(|c| c * pitch);
    (0..n * n * n).map(at).collect()
}

/// Random cubes in a cube of edge 2^30, and their edge: `density` of them cover a point on average.
pub fn uniform(count: u32, density: f64, seed: u64) -> (Vec<[i32; 3]>, i32) {
    let mut random = Random::new(seed);
    #[allow(clippy::cast_possible_truncation)] // below 2^30
    let edge = (f64::from(1 << 30) * (density / f64::from(count)).cbrt()) as i32;
    let range = i64::from((1 << 30) - edge);
    let mut lower = || [(); 3].map(|()| i32::try_from(random.below(range)).unwrap());
    ((0..count).map(|_| lower()).collect(), edge)
}
