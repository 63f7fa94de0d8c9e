//! The integer types of coordinates.

/// A signed integer type, with the unsigned type of differences that the grid stores for each cube.
pub trait Coordinate: Copy + Ord + Into<i64> + Send + Sync {
    /// The distance from the least coordinate.
    type Offset: Copy + Default + Into<u64> + Send + Sync;

    /// The distance of this coordinate from `least`, which is not larger.
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
