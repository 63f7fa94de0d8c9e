//! The integers that coordinates may be.

/// A signed integer, and the unsigned one that differences fit in: what the
/// grid stores for each cube.
pub trait Coordinate: Copy + Ord + Into<i64> + Send + Sync {
    /// The distance from the least coordinate.
    type Offset: Copy + Default + Into<u64> + Send + Sync;

    /// How far this is from `least`, which is not larger.
    fn offset(self, least: Self) -> Self::Offset;
}

impl Coordinate for i32 {
    type Offset = u32;

    #[inline]
    fn offset(self, least: i32) -> u32 {
        self.abs_diff(least)
    }
}

impl Coordinate for i64 {
    type Offset = u64;

    #[inline]
    fn offset(self, least: i64) -> u64 {
        self.abs_diff(least)
    }
}
