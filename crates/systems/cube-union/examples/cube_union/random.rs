//! Random cubes, the same in every version.

/// The SplitMix64 generator.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}

/// `count` lower corners, uniform in [0, 2^30 − edge)³, and the edge for which `density` cubes cover a point on
/// average.
#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)] // below 2^30
pub fn cubes(count: usize, density: f64, seed: u64) -> (Vec<[i32; 3]>, i32) {
    let size = f64::from(1 << 30);
    let edge = ((size * (density / count as f64).cbrt()) as i32).clamp(1, 1 << 29);
    let range = f64::from((1 << 30) - edge);
    let mut random = Random(seed);
    let mut coordinate = || ((random.next() >> 11) as f64 * 2.0_f64.powi(-53) * range) as i32;
    ((0..count).map(|_| [coordinate(), coordinate(), coordinate()]).collect(), edge)
}
