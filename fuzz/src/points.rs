//! Points from bytes. Every string of bytes encodes a list of finite points; missing bytes at its end count as zeros.

/// The maximum number of points beyond those of one query: a scene's plan uses all of its points, including those
/// outside of the query.
const MORE: usize = 3;

/// The points that bytes encode, as many as there are bytes for: at least `least`, and at most [`MORE`] beyond.
///
/// A point starts with a byte for the way it is made:
/// * from its own coordinates: any finite double, a short number, or zero,
/// * from an earlier point, moved by some ulps,
/// * from two earlier points p and q, as p + k (q − p), moved by some ulps,
/// * from an earlier point by exchanging coordinates and changing signs, which keeps its distance to the origin, moved
///   by some ulps or not,
/// * from an earlier point, scaled by a power of two.
#[must_use]
pub fn from_bytes<const D: usize>(bytes: &[u8], least: usize) -> Vec<[f64; D]> {
    let mut bytes = Bytes(bytes);
    let mut points: Vec<[f64; D]> = Vec::with_capacity(least + MORE);
    while points.len() < least || (points.len() < least + MORE && !bytes.0.is_empty()) {
        let how = bytes.next();
        let point = match how % 8 {
            _ if points.is_empty() => own(&mut bytes),
            0 | 1 => own(&mut bytes),
            2 => moved(bytes.earlier(&points), &mut bytes),
            3 | 4 => {
                let (p, q) = (bytes.earlier(&points), bytes.earlier(&points));
                let k = f64::from(bytes.next_i8() % 8) / 2.0;
                moved(std::array::from_fn(|i| finite(p[i] + k * (q[i] - p[i]))), &mut bytes)
            }
            5 | 6 => {
                let mut point = bytes.earlier(&points);
                let bits = bytes.next();
                point.rotate_left(usize::from(bits >> 6) % D);
                let signed = std::array::from_fn(|i| if bits >> i & 1 == 1 { -point[i] } else { point[i] });
                if how & 0x80 == 0 { signed } else { moved(signed, &mut bytes) }
            }
            _ => {
                let point = bytes.earlier(&points);
                let scale = power_of_two(bytes.next_i8());
                point.map(|c| finite(c * scale))
            }
        };
        points.push(point);
    }
    points
}

/// A point with coordinates that are independent of earlier points.
fn own<const D: usize>(bytes: &mut Bytes) -> [f64; D] {
    std::array::from_fn(|_| match bytes.next() % 4 {
        0 => 0.0,
        1 => f64::from(bytes.next_i8()),
        2 => f64::from(bytes.next_i8()) * power_of_two(bytes.next_i8()),
        _ => finite(f64::from_bits(u64::from_le_bytes(std::array::from_fn(|_| bytes.next())))),
    })
}

/// The point with each coordinate up to 15 ulps away.
fn moved<const D: usize>(point: [f64; D], bytes: &mut Bytes) -> [f64; D] {
    point.map(|mut coordinate| {
        let ulps = bytes.next_i8() % 16;
        for _ in 0..ulps.unsigned_abs() {
            coordinate = if ulps < 0 { coordinate.next_down() } else { coordinate.next_up() };
        }
        finite(coordinate)
    })
}

/// The power 2^(8 exponent), from subnormal to huge.
fn power_of_two(exponent: i8) -> f64 {
    2.0_f64.powi(8 * i32::from(exponent))
}

/// The number itself; for a NaN or an infinity, the number without the topmost bit of its exponent, which is between 1
/// and 2 in magnitude.
fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { f64::from_bits(x.to_bits() & !(1 << 62)) }
}

/// Bytes, followed by zeros.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn next(&mut self) -> u8 {
        let (&first, rest) = self.0.split_first().unwrap_or((&0, &[]));
        self.0 = rest;
        first
    }

    fn next_i8(&mut self) -> i8 {
        self.next().cast_signed()
    }

    fn earlier<const D: usize>(&mut self, points: &[[f64; D]]) -> [f64; D] {
        points[usize::from(self.next()) % points.len()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn infinities_and_nans_become_numbers() {
        for x in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN, f64::from_bits(u64::MAX)] {
            assert!(finite(x).is_finite() && (1.0..2.0).contains(&finite(x).abs()));
        }
        assert_eq!(finite(f64::MAX), f64::MAX);
    }

    #[test]
    fn a_point_can_be_nearly_another_one() {
        // (3, 5); then the same with one ulp up and two down.
        let bytes = [0, 1, 3, 1, 5, 2, 0, 1, 0xfe];
        let points = from_bytes::<2>(&bytes, 2);
        assert_eq!(points, [[3.0, 5.0], [3.0_f64.next_up(), 5.0_f64.next_down().next_down()]]);
    }

    #[test]
    fn a_point_can_be_collinear_or_cocircular_with_others() {
        // (3, 5), (4, 7), then p + 2 (q − p), then (−5, 3) on the circle of the first.
        let bytes = [0, 1, 3, 1, 5, 0, 1, 4, 1, 7, 3, 0, 1, 4, 0, 0, 5, 0, 0x41];
        let points = from_bytes::<2>(&bytes, 3);
        assert_eq!(points, [[3.0, 5.0], [4.0, 7.0], [5.0, 9.0], [-5.0, 3.0]]);
    }

    #[test]
    fn no_bytes_are_the_origin() {
        assert_eq!(from_bytes::<3>(&[], 2), [[0.0; 3]; 2]);
    }
}
