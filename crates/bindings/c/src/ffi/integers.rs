//! Predicates on integers of 32 bits. Each is a double without rounding, so these are the predicates on doubles.

use super::{Points, compare_many, compare_single, many, predicament_result, single};
use crate::number;

/// The same as predicament_compare(), for points of 32-bit integers.
///
/// @copydetails predicament_compare
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_compare_i32(
    axis: i32,
    a: *const i32,
    b: *const i32,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { compare_single(axis, [a, b], sign, number::compare) }
}

/// The same as predicament_orient2d(), for points of 32-bit integers.
///
/// @copydetails predicament_orient2d
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_orient2d_i32(
    a: *const i32,
    b: *const i32,
    c: *const i32,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { single([a, b, c], sign, number::orient2d) }
}

/// The same as predicament_orient3d(), for points of 32-bit integers.
///
/// @copydetails predicament_orient3d
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_orient3d_i32(
    a: *const i32,
    b: *const i32,
    c: *const i32,
    d: *const i32,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { single([a, b, c, d], sign, number::orient3d) }
}

/// The same as predicament_incircle(), for points of 32-bit integers.
///
/// @copydetails predicament_incircle
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_incircle_i32(
    a: *const i32,
    b: *const i32,
    c: *const i32,
    d: *const i32,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { single([a, b, c, d], sign, number::incircle) }
}

/// The same as predicament_insphere(), for points of 32-bit integers.
///
/// @copydetails predicament_insphere
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_insphere_i32(
    a: *const i32,
    b: *const i32,
    c: *const i32,
    d: *const i32,
    e: *const i32,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { single([a, b, c, d, e], sign, number::insphere) }
}

/// The same as predicament_compare_batch(), for points of 32-bit integers.
///
/// @copydetails predicament_compare_batch
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_compare_batch_i32(
    axis: i32,
    points: *const i32,
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

/// The same as predicament_orient2d_batch(), for points of 32-bit integers.
///
/// @copydetails predicament_orient2d_batch
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_orient2d_batch_i32(
    points: *const i32,
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

/// The same as predicament_orient3d_batch(), for points of 32-bit integers.
///
/// @copydetails predicament_orient3d_batch
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_orient3d_batch_i32(
    points: *const i32,
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

/// The same as predicament_incircle_batch(), for points of 32-bit integers.
///
/// @copydetails predicament_incircle_batch
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_incircle_batch_i32(
    points: *const i32,
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

/// The same as predicament_insphere_batch(), for points of 32-bit integers.
///
/// @copydetails predicament_insphere_batch
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_insphere_batch_i32(
    points: *const i32,
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
