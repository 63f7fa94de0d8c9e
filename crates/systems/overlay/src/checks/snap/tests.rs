//! Tests of the parts of the check against simpler code.

use super::*;

fn point(quarters: [i32; 2]) -> Point {
    quarters.map(|x| Rational::from((x, 4)))
}

/// True if a point is in the half-open square around a centre.
fn is_in(p: &Point, pixel: Pixel) -> bool {
    (0..2).all(|axis| {
        let off = p[axis].clone() - pixel[axis];
        off >= Rational::from((-1, 2)) && off < Rational::from((1, 2))
    })
}

/// Decides like `meets` if a point of the segment is in the pixel. Between the points where the segment passes a
/// border's line it is completely inside or outside. So these points, the ends and one point between any two are
/// enough.
fn has_point_in([a, b]: [&Point; 2], pixel: Pixel) -> bool {
    let mut places = vec![Rational::new(), Rational::from(1)];
    for axis in 0..2 {
        let along = Rational::from(&b[axis] - &a[axis]);
        for border in [Rational::from((-1, 2)), Rational::from((1, 2))] {
            if !along.is_zero() {
                places.push((border + pixel[axis] - &a[axis]) / &along);
            }
        }
    }
    places.retain(|t| *t >= 0 && *t <= 1);
    places.sort();
    let between: Vec<Rational> = places.windows(2).map(|pair| (pair[0].clone() + &pair[1]) / 2).collect();
    places.iter().chain(&between).any(|t| {
        let at = [0, 1].map(|axis: usize| Rational::from(&b[axis] - &a[axis]) * t + &a[axis]);
        is_in(&at, pixel)
    })
}

#[test]
fn segments_meet_the_pixels_that_they_have_a_point_in() {
    // Quarters from -5/4 to 5/4, so that ends are inside, outside, on borders and on corners of pixels around the
    // origin.
    let mut seen = [0; 2];
    let ends: Vec<[i32; 2]> = (-5..=5).flat_map(|x| (-5..=5).map(move |y| [x, y])).collect();
    for (at, &a) in ends.iter().enumerate() {
        for &b in ends.iter().skip(at % 3).step_by(3) {
            let [p, q] = [point(a), point(b)];
            let pixel = [[0, 0], [1, -1], [-1, 0]][at % 3];
            let expected = has_point_in([&p, &q], pixel);
            assert_eq!(meets([&p, &q], pixel), expected, "{a:?} to {b:?} in quarters, {pixel:?}");
            seen[usize::from(expected)] += 1;
        }
    }
    assert!(seen[0] > 1000 && seen[1] > 1000, "{seen:?}");
}

#[test]
fn points_are_in_the_pixel_whose_square_they_are_in() {
    for x in -12..=12 {
        for y in [-7, -6, -2, -1, 0, 1, 2, 3, 6] {
            let p = point([x, y]);
            assert!(is_in(&p, pixel(&p)), "{x} {y} in quarters, {:?}", pixel(&p));
        }
    }
    assert_eq!(pixel(&point([2, -2])), [1, 0], "lower borders belong to a pixel, upper ones do not");
}

#[test]
fn lines_meet_where_both_of_them_are() {
    let meet = |a, b, c, d| meeting([&point(a), &point(b)], [&point(c), &point(d)]);
    assert_eq!(meet([0, 0], [4, 4], [0, 4], [4, 0]), point([2, 2]));
    assert_eq!(meet([1, 0], [1, 9], [0, 3], [7, 3]), point([1, 3]));
    assert_eq!(meet([0, 3], [7, 3], [1, 0], [1, 9]), point([1, 3]));
    // The lines y = x/2 + 1 and y = 3 - x/4, beyond the ends of the first segment.
    assert_eq!(meet([0, 4], [4, 6], [0, 12], [16, 8]), [Rational::from((8, 3)), Rational::from((7, 3))]);
}

#[test]
fn boxes_have_the_hot_pixels_between_their_corners() {
    let mut hot: Vec<Pixel> = (-3..=3).flat_map(|x| (-3..=3).map(move |y| [x, y])).collect();
    hot.retain(|[x, y]| (x + 2 * y) % 3 != 0);
    for &a in &hot {
        for &b in &hot {
            let is_between = |axis: usize, p: Pixel| a[axis].min(b[axis]) <= p[axis] && p[axis] <= a[axis].max(b[axis]);
            let expected: Vec<Pixel> = hot.iter().copied().filter(|&p| is_between(0, p) && is_between(1, p)).collect();
            assert_eq!(boxed(&hot, [a, b]).collect::<Vec<_>>(), expected, "{a:?} {b:?}");
        }
    }
}

#[test]
fn edges_of_several_chains_cross_once() {
    let across = vec![[0, 0], [4, 4], [8, 0]];
    let over = vec![[0, 4], [4, 0], [8, 4]];
    assert_eq!(new_crossings(&[across.clone(), over.clone()]), 2);
    assert_eq!(new_crossings(&[across.clone(), over.clone(), over.clone(), across.clone()]), 2);
    assert_eq!(crossed(&[over.clone(), across.clone()]).collect::<Vec<_>>(), [[1, 0], [0, 1]]);
    // In reverse they are the same edges.
    let back: Vec<Pixel> = over.iter().rev().copied().collect();
    assert_eq!(new_crossings(&[across.clone(), over, back]), 2);
    // An edge that ends where another begins does not cross it; an edge that passes over its end does.
    assert_eq!(new_crossings(&[vec![[0, 0], [4, 0]], vec![[4, 0], [4, 4]]]), 0);
    assert_eq!(new_crossings(&[vec![[0, 0], [4, 0]], vec![[4, -4], [4, 4]]]), 1);
    assert_eq!(new_crossings(&[vec![[0, 0], [3, 0]], vec![[4, -4], [4, 4]]]), 0);
    assert_eq!(new_crossings(&[across]), 0);
}
