//! Prepared scenes behind an opaque pointer: made, counted and freed.

use predicament_predicates::{Dimension, Vertex};

use super::{Points, guarded, predicament_result};
use crate::centred;
use crate::failure::Failure;
use crate::failure::predicament_result::*;
use crate::number::Number;
use crate::prepared::{Prepared, Rule};

/// The points of one scene, prepared for many queries, and the vertices that were constructed from them.
///
/// The program owns a scene from predicament_scene_new() to predicament_scene_free(). Threads may query one scene at
/// the same time. While a thread adds vertices to it or frees it, no other thread may use it.
pub struct predicament_scene(pub(super) Prepared);

/// A coordinate of a scene.
trait Coordinate: Copy {
    /// Coordinates of points as doubles that give the same signs.
    fn doubles(coordinates: Vec<Self>, dimension: usize) -> Result<Vec<f64>, Failure>;
}

impl<T: Number> Coordinate for T {
    fn doubles(coordinates: Vec<T>, _: usize) -> Result<Vec<f64>, Failure> {
        Ok(coordinates.into_iter().map(T::double).collect())
    }
}

impl Coordinate for i64 {
    fn doubles(coordinates: Vec<i64>, dimension: usize) -> Result<Vec<f64>, Failure> {
        centred::doubles(&coordinates, dimension).map_err(|point| Failure::at(PREDICAMENT_RANGE, point))
    }
}

/// Makes a scene of these points.
///
/// # Safety
/// The pointers keep the rules of the module.
unsafe fn make<T: Coordinate>(
    points: Points<T>,
    dimension: i32,
    backend: i32,
    scene: *mut *mut predicament_scene,
    bad: *mut usize,
) -> predicament_result {
    let body = || {
        if scene.is_null() {
            return Err(PREDICAMENT_NULL.into());
        }
        // SAFETY: it is not NULL, so it can be written.
        unsafe { scene.write_unaligned(std::ptr::null_mut()) };
        let rule = match backend {
            0 => Rule::Exact,
            1 => Rule::Sos,
            _ => return Err(PREDICAMENT_ARGUMENT.into()),
        };
        let (dimension, coordinates) = match dimension {
            // SAFETY: the caller's promise.
            2 => (Dimension::Two, unsafe { coordinates::<T, 2>(points)? }),
            // SAFETY: the caller's promise.
            3 => (Dimension::Three, unsafe { coordinates::<T, 3>(points)? }),
            _ => return Err(PREDICAMENT_ARGUMENT.into()),
        };
        let coordinates = T::doubles(coordinates, dimension.count())?;
        let made = Box::new(predicament_scene(Prepared::new(rule, dimension, coordinates)?));
        // SAFETY: as above.
        unsafe { scene.write_unaligned(Box::into_raw(made)) };
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { guarded(bad, body) }
}

/// The coordinates of points of `D` numbers.
///
/// # Safety
/// The points keep the rules of the module.
unsafe fn coordinates<T: Copy, const D: usize>(points: Points<T>) -> Result<Vec<T>, Failure> {
    let points = points.checked::<D>()?;
    if points.count > Vertex::MAX_INPUT {
        return Err(PREDICAMENT_TOO_MANY.into());
    }
    let mut coordinates = Vec::with_capacity(points.count * D);
    for index in 0..points.count {
        // SAFETY: the points are checked, and the index is below their count.
        coordinates.extend(unsafe { points.get::<D>(index) });
    }
    Ok(coordinates)
}

/// Makes a scene of points, which are copied.
///
/// @param points  the points: two or three coordinates each, one after another
/// @param count  the number of points, at most 2^31
/// @param stride  the distance from one point to the next in bytes; at least the size of a point
/// @param dimension  2 or 3
/// @param backend  a predicament_backend
/// @param scene  receives the scene, or NULL after a failure
/// @param bad  receives the index of the bad point after a failure; may be NULL
/// @return PREDICAMENT_OK; PREDICAMENT_NOT_FINITE for the first bad point; PREDICAMENT_NULL, PREDICAMENT_ARGUMENT or
/// PREDICAMENT_TOO_MANY; PREDICAMENT_UNSUPPORTED if the library was built without PREDICAMENT_SOS
///
/// The caller owns the scene and frees it by predicament_scene_free(). The arrays are borrowed for the call. A scene
/// takes memory of 8 bytes a coordinate. The process ends if the system has not enough memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_new(
    points: *const f64,
    count: usize,
    stride: usize,
    dimension: i32,
    backend: i32,
    scene: *mut *mut predicament_scene,
    bad: *mut usize,
) -> predicament_result {
    let points = Points { first: points, count, stride };
    // SAFETY: the rules of the module.
    unsafe { make(points, dimension, backend, scene, bad) }
}

/// The same as predicament_scene_new(), for points of floats.
///
/// @copydetails predicament_scene_new
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_new_f32(
    points: *const f32,
    count: usize,
    stride: usize,
    dimension: i32,
    backend: i32,
    scene: *mut *mut predicament_scene,
    bad: *mut usize,
) -> predicament_result {
    let points = Points { first: points, count, stride };
    // SAFETY: the rules of the module.
    unsafe { make(points, dimension, backend, scene, bad) }
}

/// The same as predicament_scene_new(), for points of 32-bit integers.
///
/// @copydetails predicament_scene_new
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_new_i32(
    points: *const i32,
    count: usize,
    stride: usize,
    dimension: i32,
    backend: i32,
    scene: *mut *mut predicament_scene,
    bad: *mut usize,
) -> predicament_result {
    let points = Points { first: points, count, stride };
    // SAFETY: the rules of the module.
    unsafe { make(points, dimension, backend, scene, bad) }
}

/// The same as predicament_scene_new(), for points of 64-bit integers. The result is PREDICAMENT_RANGE if the integers
/// along an axis span more than 2^54 times the largest power of two that divides all their differences.
///
/// @copydetails predicament_scene_new
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_new_i64(
    points: *const i64,
    count: usize,
    stride: usize,
    dimension: i32,
    backend: i32,
    scene: *mut *mut predicament_scene,
    bad: *mut usize,
) -> predicament_result {
    let points = Points { first: points, count, stride };
    // SAFETY: the rules of the module.
    unsafe { make(points, dimension, backend, scene, bad) }
}

/// Frees a scene and its constructed vertices.
///
/// @param scene  a scene of predicament_scene_new() that is not freed, or NULL; no thread may use it then or later
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_free(scene: *mut predicament_scene) {
    let body = || {
        if !scene.is_null() {
            // SAFETY: it comes from `Box::into_raw` in `make`, and the caller gives it back once.
            drop(unsafe { Box::from_raw(scene) });
        }
        Ok(())
    };
    // SAFETY: NULL is allowed.
    unsafe { guarded(std::ptr::null_mut(), body) };
}

/// The number of points of a scene.
///
/// @param scene  a scene; NULL gives 0
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_points(scene: *const predicament_scene) -> usize {
    // SAFETY: the caller's promise.
    unsafe { counts(scene)[0] }
}

/// The number of constructed vertices of a scene. Their ids are PREDICAMENT_CONSTRUCTED + 0, 1, 2 and so on.
///
/// @param scene  a scene; NULL gives 0
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_constructed(scene: *const predicament_scene) -> usize {
    // SAFETY: the caller's promise.
    unsafe { counts(scene)[1] }
}

/// The numbers of points and of constructed vertices; zeros for NULL.
///
/// # Safety
/// `scene` is NULL or a scene that nobody changes.
unsafe fn counts(scene: *const predicament_scene) -> [usize; 2] {
    let mut counts = [0; 2];
    let body = || {
        // SAFETY: the caller's promise.
        counts = unsafe { scene.as_ref() }.map_or([0; 2], |scene| scene.0.counts());
        Ok(())
    };
    // SAFETY: NULL is allowed.
    unsafe { guarded(std::ptr::null_mut(), body) };
    counts
}
