//! Predicates on doubles.

use super::{Points, compare_many, compare_single, many, predicament_result, single};
use crate::number;

/// The order of two points along an axis: the sign of a's coordinate minus b's.
///
/// @param axis  a predicament_axis
/// @param a, b  the points: as many coordinates each as the axis needs; only the coordinate on the axis is read
/// @param sign  receives -1, 0 or 1
/// @return PREDICAMENT_OK, PREDICAMENT_NULL, PREDICAMENT_NOT_FINITE, or PREDICAMENT_ARGUMENT for another axis
///
/// The pointers are borrowed for the call. Any thread may call at any time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_compare(
    axis: i32,
    a: *const f64,
    b: *const f64,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { compare_single(axis, [a, b], sign, number::compare) }
}

/// The turn a, b, c in the plane: 1 if counterclockwise, -1 if clockwise, 0 if the points are on one line.
///
/// @param a, b, c  the points: two coordinates each
/// @param sign  receives -1, 0 or 1
/// @return PREDICAMENT_OK, PREDICAMENT_NULL or PREDICAMENT_NOT_FINITE
///
/// The pointers are borrowed for the call. Any thread may call at any time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_orient2d(
    a: *const f64,
    b: *const f64,
    c: *const f64,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { single([a, b, c], sign, number::orient2d) }
}

/// The side of d on the plane through a, b, c: 1 if d is below, -1 if above, 0 if on the plane.
///
/// Above is the side from which a, b, c are seen counterclockwise.
///
/// @param a, b, c, d  the points: three coordinates each
/// @param sign  receives -1, 0 or 1
/// @return PREDICAMENT_OK, PREDICAMENT_NULL or PREDICAMENT_NOT_FINITE
///
/// The pointers are borrowed for the call. Any thread may call at any time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_orient3d(
    a: *const f64,
    b: *const f64,
    c: *const f64,
    d: *const f64,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { single([a, b, c, d], sign, number::orient3d) }
}

/// The place of d at the circle through a, b, c: 1 if inside, -1 if outside, 0 if on the circle.
///
/// This holds if a, b, c turn counterclockwise; otherwise the sign is the opposite.
///
/// @param a, b, c, d  the points: two coordinates each
/// @param sign  receives -1, 0 or 1
/// @return PREDICAMENT_OK, PREDICAMENT_NULL or PREDICAMENT_NOT_FINITE
///
/// The pointers are borrowed for the call. Any thread may call at any time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_incircle(
    a: *const f64,
    b: *const f64,
    c: *const f64,
    d: *const f64,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { single([a, b, c, d], sign, number::incircle) }
}

/// The place of e at the sphere through a, b, c, d: 1 if inside, -1 if outside, 0 if on the sphere.
///
/// This holds if predicament_orient3d() of a, b, c, d is 1; otherwise the sign is the opposite.
///
/// @param a, b, c, d, e  the points: three coordinates each
/// @param sign  receives -1, 0 or 1
/// @return PREDICAMENT_OK, PREDICAMENT_NULL or PREDICAMENT_NOT_FINITE
///
/// The pointers are borrowed for the call. Any thread may call at any time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_insphere(
    a: *const f64,
    b: *const f64,
    c: *const f64,
    d: *const f64,
    e: *const f64,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { single([a, b, c, d, e], sign, number::insphere) }
}

/// predicament_compare() for many queries about the points of one array.
///
/// @param axis  a predicament_axis
/// @param points  the points: as many coordinates each as the axis needs
/// @param count  the number of points
/// @param stride  the distance from one point to the next in bytes; at least the size of a point
/// @param indices  two indices of points for each query, below count
/// @param queries  the number of queries
/// @param signs  receives -1, 0 or 1 for each query; must not overlap the other arrays
/// @param bad  receives the index of the bad query after a failure; may be NULL
/// @return PREDICAMENT_OK; PREDICAMENT_INDEX or PREDICAMENT_NOT_FINITE for the first bad query: the signs of the
/// queries before it are written; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED, PREDICAMENT_ARGUMENT or
/// PREDICAMENT_TOO_MANY
///
/// The arrays are borrowed for the call. Any thread may call at any time. For many queries about the same points,
/// predicament_scene_compare_batch() is faster.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_compare_batch(
    axis: i32,
    points: *const f64,
    count: usize,
    stride: usize,
    indices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
) -> predicament_result {
    let points = Points { first: points, count, stride };
    // SAFETY: the rules of the module.
    unsafe { compare_many(axis, points, indices, queries, signs, bad, number::compare) }
}

/// predicament_orient2d() for many queries about the points of one array.
///
/// @param points  the points: two coordinates each, one after another
/// @param count  the number of points
/// @param stride  the distance from one point to the next in bytes; at least the size of a point
/// @param indices  three indices of points for each query, below count
/// @param queries  the number of queries
/// @param signs  receives -1, 0 or 1 for each query; must not overlap the other arrays
/// @param bad  receives the index of the bad query after a failure; may be NULL
/// @return PREDICAMENT_OK; PREDICAMENT_INDEX or PREDICAMENT_NOT_FINITE for the first bad query: the signs of the
/// queries before it are written; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED, PREDICAMENT_ARGUMENT or
/// PREDICAMENT_TOO_MANY
///
/// The arrays are borrowed for the call. Any thread may call at any time. For many queries about the same points,
/// predicament_scene_orient2d_batch() is faster.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_orient2d_batch(
    points: *const f64,
    count: usize,
    stride: usize,
    indices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
) -> predicament_result {
    let points = Points { first: points, count, stride };
    // SAFETY: the rules of the module.
    unsafe { many(points, indices, queries, signs, bad, number::orient2d) }
}

/// predicament_orient3d() for many queries about the points of one array.
///
/// @param points  the points: three coordinates each, one after another
/// @param count  the number of points
/// @param stride  the distance from one point to the next in bytes; at least the size of a point
/// @param indices  four indices of points for each query, below count
/// @param queries  the number of queries
/// @param signs  receives -1, 0 or 1 for each query; must not overlap the other arrays
/// @param bad  receives the index of the bad query after a failure; may be NULL
/// @return PREDICAMENT_OK; PREDICAMENT_INDEX or PREDICAMENT_NOT_FINITE for the first bad query: the signs of the
/// queries before it are written; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED, PREDICAMENT_ARGUMENT or
/// PREDICAMENT_TOO_MANY
///
/// The arrays are borrowed for the call. Any thread may call at any time. For many queries about the same points,
/// predicament_scene_orient3d_batch() is faster.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_orient3d_batch(
    points: *const f64,
    count: usize,
    stride: usize,
    indices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
) -> predicament_result {
    let points = Points { first: points, count, stride };
    // SAFETY: the rules of the module.
    unsafe { many(points, indices, queries, signs, bad, number::orient3d) }
}

/// predicament_incircle() for many queries about the points of one array.
///
/// @param points  the points: two coordinates each, one after another
/// @param count  the number of points
/// @param stride  the distance from one point to the next in bytes; at least the size of a point
/// @param indices  four indices of points for each query, below count
/// @param queries  the number of queries
/// @param signs  receives -1, 0 or 1 for each query; must not overlap the other arrays
/// @param bad  receives the index of the bad query after a failure; may be NULL
/// @return PREDICAMENT_OK; PREDICAMENT_INDEX or PREDICAMENT_NOT_FINITE for the first bad query: the signs of the
/// queries before it are written; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED, PREDICAMENT_ARGUMENT or
/// PREDICAMENT_TOO_MANY
///
/// The arrays are borrowed for the call. Any thread may call at any time. For many queries about the same points,
/// predicament_scene_incircle_batch() is faster.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_incircle_batch(
    points: *const f64,
    count: usize,
    stride: usize,
    indices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
) -> predicament_result {
    let points = Points { first: points, count, stride };
    // SAFETY: the rules of the module.
    unsafe { many(points, indices, queries, signs, bad, number::incircle) }
}

/// predicament_insphere() for many queries about the points of one array.
///
/// @param points  the points: three coordinates each, one after another
/// @param count  the number of points
/// @param stride  the distance from one point to the next in bytes; at least the size of a point
/// @param indices  five indices of points for each query, below count
/// @param queries  the number of queries
/// @param signs  receives -1, 0 or 1 for each query; must not overlap the other arrays
/// @param bad  receives the index of the bad query after a failure; may be NULL
/// @return PREDICAMENT_OK; PREDICAMENT_INDEX or PREDICAMENT_NOT_FINITE for the first bad query: the signs of the
/// queries before it are written; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED, PREDICAMENT_ARGUMENT or
/// PREDICAMENT_TOO_MANY
///
/// The arrays are borrowed for the call. Any thread may call at any time. For many queries about the same points,
/// predicament_scene_insphere_batch() is faster.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_insphere_batch(
    points: *const f64,
    count: usize,
    stride: usize,
    indices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
) -> predicament_result {
    let points = Points { first: points, count, stride };
    // SAFETY: the rules of the module.
    unsafe { many(points, indices, queries, signs, bad, number::insphere) }
}
