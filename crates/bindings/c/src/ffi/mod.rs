//! The functions of the header, the only module with unsafe code.
//!
//! Rules of every function, which the safety comments refer to:
//! * **Pointers.** A pointer that is not NULL points to as many values as the function's comment says. The caller
//!   promises that; the library can't check it. NULL and misaligned pointers have result codes. Points are read without
//!   alignment.
//! * **Borrowing.** The library uses a pointer during the call only. The exception is the scene, which
//!   `predicament_scene_new` makes and `predicament_scene_free` frees.
//! * **Panics.** [`guarded`] runs the body of each function that can panic, and makes a result code of a panic. A test
//!   reads this folder and fails if an exported function has no guard.
//!
//! Each function has the name that it has in C.

// In C every pointer is the caller's promise, and the header's comments say which. Enums that C passes are numbers
// here, because a number that is not in a Rust enum would be undefined behaviour.
#![allow(clippy::missing_safety_doc, clippy::too_many_arguments, non_camel_case_types)]

mod about;
mod constructed;
mod doubles;
mod floats;
mod integers;
mod longs;
mod names;
mod queries;
mod scenes;
#[doc(hidden)]
pub mod testing;

pub use about::*;
pub use constructed::*;
pub use doubles::*;
pub use floats::*;
pub use integers::*;
pub use longs::*;
pub use names::*;
pub use queries::*;
pub use scenes::*;

use std::panic::{AssertUnwindSafe, catch_unwind};

use predicament_predicates::Sign;

use crate::failure::Failure;
pub use crate::failure::predicament_result;
use crate::failure::predicament_result::*;

/// Runs the body of a function. A panic becomes `PREDICAMENT_INTERNAL`.
///
/// If the body fails, the index of the bad item goes to `bad`, unless that is NULL.
///
/// # Safety
/// `bad` is NULL or can be written.
#[inline(always)]
unsafe fn guarded(bad: *mut usize, body: impl FnOnce() -> Result<(), Failure>) -> predicament_result {
    // Unwinding leaves no broken state behind: inputs are borrowed for the call, and a scene marks itself as broken
    // while it is changed.
    match catch_unwind(AssertUnwindSafe(body)) {
        Ok(Ok(())) => PREDICAMENT_OK,
        // SAFETY: the caller's promise.
        Ok(Err(failure)) => unsafe { failed(bad, failure) },
        // SAFETY: the same.
        Err(panic) => unsafe { panicked(bad, panic) },
    }
}

/// The code of a failure, after its place has been written.
#[cold]
unsafe fn failed(bad: *mut usize, failure: Failure) -> predicament_result {
    if !bad.is_null() {
        // SAFETY: it is not NULL, so it can be written.
        unsafe { bad.write_unaligned(failure.at) };
    }
    failure.code
}

#[cold]
unsafe fn panicked(bad: *mut usize, panic: Box<dyn std::any::Any + Send>) -> predicament_result {
    // A payload can panic when it is dropped. It leaks instead: a panic is a defect, and rare.
    std::mem::forget(panic);
    // SAFETY: the caller's promise.
    unsafe { failed(bad, PREDICAMENT_INTERNAL.into()) }
}

/// Answers one query about points that are given by pointers to `D` numbers each.
///
/// # Safety
/// The pointers keep the rules of the module; `sign` has place for one sign.
#[inline(always)]
unsafe fn single<T: Copy, const D: usize, const N: usize>(
    points: [*const T; N],
    sign: *mut i8,
    predicate: impl FnOnce([[T; D]; N]) -> Result<Sign, predicament_result>,
) -> predicament_result {
    let body = || {
        if sign.is_null() | points.iter().fold(false, |any, point| any | point.is_null()) {
            return Err(PREDICAMENT_NULL.into());
        }
        // SAFETY: none is NULL, so each points to `D` numbers; they are read at any alignment.
        let points = points.map(|point| unsafe { point.cast::<[T; D]>().read_unaligned() });
        let answer = predicate(points)?;
        // SAFETY: it is not NULL, so it can be written.
        unsafe { sign.write(answer.as_i8()) };
        Ok(())
    };
    // SAFETY: NULL is allowed.
    unsafe { guarded(std::ptr::null_mut(), body) }
}

/// Points in the memory of a C program: `D` numbers each, at distances of `stride` bytes.
#[derive(Clone, Copy)]
struct Points<T> {
    first: *const T,
    count: usize,
    stride: usize,
}

impl<T: Copy> Points<T> {
    /// Checks what can be checked about points of `D` numbers.
    fn checked<const D: usize>(self) -> Result<Points<T>, predicament_result> {
        let (size, last) = (size_of::<[T; D]>(), self.count.saturating_sub(1));
        if self.first.is_null() && self.count > 0 {
            return Err(PREDICAMENT_NULL);
        }
        if self.stride < size {
            return Err(PREDICAMENT_ARGUMENT);
        }
        let end = last.checked_mul(self.stride).and_then(|start| start.checked_add(size));
        match end {
            Some(end) if isize::try_from(end).is_ok() => Ok(self),
            _ => Err(PREDICAMENT_TOO_MANY),
        }
    }

    /// The numbers of one point.
    ///
    /// # Safety
    /// The points are checked for this `D` and keep the rules of the module; `index` is below `count`.
    #[inline(always)]
    unsafe fn get<const D: usize>(self, index: usize) -> [T; D] {
        // SAFETY: the point is one of `count` points that the caller has promised; offsets were checked.
        unsafe { self.first.byte_add(index * self.stride).cast::<[T; D]>().read_unaligned() }
    }
}

/// A list in the memory of a C program, or an empty list if `count` is 0.
///
/// # Safety
/// The pointer keeps the rules of the module: nobody writes to the list as long as the result is used.
#[inline]
unsafe fn list<'a, T>(first: *const T, count: usize) -> Result<&'a [T], predicament_result> {
    if count == 0 {
        return Ok(&[]);
    }
    check_list(first, count)?;
    // SAFETY: it is not NULL, aligned, and its size is less than half of the address space.
    Ok(unsafe { std::slice::from_raw_parts(first, count) })
}

/// Checks what can be checked about a list that is not empty.
fn check_list<T>(first: *const T, count: usize) -> Result<(), predicament_result> {
    let bytes = count.checked_mul(size_of::<T>()).and_then(|bytes| isize::try_from(bytes).ok());
    match bytes {
        _ if first.is_null() => Err(PREDICAMENT_NULL),
        _ if !first.is_aligned() => Err(PREDICAMENT_MISALIGNED),
        None => Err(PREDICAMENT_TOO_MANY),
        Some(_) => Ok(()),
    }
}

/// The number of indices of this many queries of `N` vertices.
fn indices_of<const N: usize>(queries: usize) -> Result<usize, predicament_result> {
    queries.checked_mul(N).ok_or(PREDICAMENT_TOO_MANY)
}

/// Answers many queries about points of `D` numbers, by indices.
///
/// # Safety
/// The pointers keep the rules of the module: `indices` has `N` indices a query, and `signs` a place for each.
#[inline(always)]
unsafe fn many<T: Copy, const D: usize, const N: usize>(
    points: Points<T>,
    indices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
    predicate: impl Fn([[T; D]; N]) -> Result<Sign, predicament_result>,
) -> predicament_result {
    let body = || {
        let points = points.checked::<D>()?;
        // SAFETY: the caller's promise.
        let indices = unsafe { list(indices, indices_of::<N>(queries)?)? };
        if queries > 0 {
            check_list(signs.cast_const(), queries)?;
        }
        for (at, query) in indices.as_chunks::<N>().0.iter().enumerate() {
            let query = query.map(|index| usize::try_from(index).unwrap_or(usize::MAX));
            if query.iter().fold(false, |any, &index| any | (index >= points.count)) {
                return Err(Failure::at(PREDICAMENT_INDEX, at));
            }
            // SAFETY: the points are checked, and the indices too.
            let corners = query.map(|index| unsafe { points.get::<D>(index) });
            let answer = predicate(corners).map_err(|code| Failure::at(code, at))?;
            // SAFETY: the caller has promised a place for each query.
            unsafe { signs.add(at).write(answer.as_i8()) };
        }
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { guarded(bad, body) }
}

/// The pointer to a coordinate, and one past it: the offset of an axis from 0 to 2.
fn offset(axis: i32) -> Result<usize, predicament_result> {
    usize::try_from(axis).ok().filter(|&axis| axis < 3).ok_or(PREDICAMENT_ARGUMENT)
}

/// Compares one coordinate of two points.
///
/// # Safety
/// As [`single`]; the points have a coordinate for the axis.
#[inline(always)]
unsafe fn compare_single<T: Copy>(
    axis: i32,
    points: [*const T; 2],
    sign: *mut i8,
    compare: impl FnOnce([[T; 1]; 2]) -> Result<Sign, predicament_result>,
) -> predicament_result {
    match offset(axis) {
        // SAFETY: the caller's promise. The offset of a NULL pointer stays NULL.
        Ok(axis) => unsafe {
            let at = |point: *const T| if point.is_null() { point } else { point.add(axis) };
            single(points.map(at), sign, compare)
        },
        Err(code) => code,
    }
}

/// Compares one coordinate of many pairs of points.
///
/// # Safety
/// As [`many`]; the points have a coordinate for the axis.
#[inline(always)]
unsafe fn compare_many<T: Copy>(
    axis: i32,
    points: Points<T>,
    indices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
    compare: impl Fn([[T; 1]; 2]) -> Result<Sign, predicament_result>,
) -> predicament_result {
    let body = || {
        let offset = offset(axis)?;
        // Each point has the coordinates up to this axis at least.
        let needed = (offset + 1) * size_of::<T>();
        if points.stride < needed { Err(PREDICAMENT_ARGUMENT.into()) } else { Ok(offset) }
    };
    match body() {
        Ok(offset) => {
            let first = if points.first.is_null() { points.first } else { points.first.wrapping_add(offset) };
            // SAFETY: the caller's promise, about the coordinates from this axis on.
            unsafe { many(Points { first, ..points }, indices, queries, signs, bad, compare) }
        }
        // SAFETY: the caller's promise.
        Err(failure) => unsafe { failed(bad, failure) },
    }
}
