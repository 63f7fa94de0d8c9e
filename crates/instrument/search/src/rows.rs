//! Rows of several points: a ray is a row of the coordinates of two points.

use predicament_corpus::Spelled;

/// The number of coordinates of a point in a row of this length. The row holds several points, one after the other, if
/// its length is a multiple of the length of the scene's points.
pub(crate) fn width(spelled: &Spelled, length: usize) -> usize {
    match spelled.points.first().map(Vec::len) {
        Some(width) if length > width && length.is_multiple_of(width) => width,
        _ => length,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_of_two_points_has_the_width_of_one() {
        let solid = Spelled { points: vec![vec![0.0; 3]], ..Spelled::default() };
        assert_eq!([3, 4, 6].map(|length| width(&solid, length)), [3, 4, 3]);
        let none = Spelled::default();
        assert_eq!(width(&none, 4), 4);
    }
}
