//! Queries about the vertices of a scene.

use predicament_predicates::{Axis, Plane, Predicates, Question, Sign, Vertex};

use super::{PREDICAMENT_CONSTRUCTED, check_list, guarded, indices_of, list, predicament_result, predicament_scene};
use crate::failure::predicament_result::*;

/// Asks one query.
///
/// # Safety
/// `scene` is NULL or a scene that nobody changes; `sign` has place for one sign.
#[inline(always)]
unsafe fn ask<const N: usize>(
    scene: *const predicament_scene,
    question: Result<Question, predicament_result>,
    ids: [u32; N],
    sign: *mut i8,
    ask: impl FnOnce(&dyn Predicates, [Vertex; N]) -> Sign,
) -> predicament_result {
    let body = || {
        // SAFETY: the caller's promise.
        let scene = unsafe { scene.as_ref() }.ok_or(PREDICAMENT_NULL)?;
        if sign.is_null() {
            return Err(PREDICAMENT_NULL.into());
        }
        let vertices = ids.map(vertex);
        let answer = scene.0.ask(question?, &vertices, |session| ask(session, vertices))?;
        // SAFETY: it is not NULL, so it can be written.
        unsafe { sign.write(answer.as_i8()) };
        Ok(())
    };
    // SAFETY: NULL is allowed.
    unsafe { guarded(std::ptr::null_mut(), body) }
}

/// Asks many queries of `N` vertices.
///
/// # Safety
/// `scene` is NULL or a scene that nobody changes; the arrays keep the rules of the module.
unsafe fn ask_many<const N: usize>(
    scene: *const predicament_scene,
    question: Result<Question, predicament_result>,
    vertices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
) -> predicament_result {
    let body = || {
        // SAFETY: the caller's promise.
        let scene = unsafe { scene.as_ref() }.ok_or(PREDICAMENT_NULL)?;
        let question = question?;
        // SAFETY: every number of 32 bits is a `Vertex`, which is transparent; the rest is the caller's promise.
        let vertices = unsafe { list(vertices.cast::<Vertex>(), indices_of::<N>(queries)?)? };
        if queries == 0 {
            return scene.0.ask_batch(question, &[], &mut []);
        }
        check_list(signs.cast_const(), queries)?;
        // SAFETY: there is place for each query, apart from all inputs. It is filled with a value that is a `Sign`
        // before it becomes a list of them.
        let signs = unsafe {
            signs.write_bytes(0, queries);
            std::slice::from_raw_parts_mut(signs.cast::<Sign>(), queries)
        };
        scene.0.ask_batch(question, vertices, signs)
    };
    // SAFETY: the caller's promise.
    unsafe { guarded(bad, body) }
}

/// The vertex with this id.
#[inline(always)]
pub(super) fn vertex(id: u32) -> Vertex {
    let index = (id & !PREDICAMENT_CONSTRUCTED) as usize;
    if id & PREDICAMENT_CONSTRUCTED == 0 { Vertex::input(index) } else { Vertex::constructed(index) }
}

fn compare_of(axis: i32) -> Result<Question, predicament_result> {
    match axis {
        0 => Ok(Question::Compare(Axis::X)),
        1 => Ok(Question::Compare(Axis::Y)),
        2 => Ok(Question::Compare(Axis::Z)),
        _ => Err(PREDICAMENT_ARGUMENT),
    }
}

fn orient2d_of(plane: i32) -> Result<Question, predicament_result> {
    match plane {
        0 => Ok(Question::Orient2d(Plane::Xy)),
        1 => Ok(Question::Orient2d(Plane::Yz)),
        2 => Ok(Question::Orient2d(Plane::Zx)),
        _ => Err(PREDICAMENT_ARGUMENT),
    }
}

/// The order of two vertices of a scene along an axis.
///
/// The sign is that of predicament_compare().
///
/// @param scene  a scene
/// @param axis  a predicament_axis that the scene has
/// @param a, b  indices of points, or ids of constructed vertices
/// @param sign  receives -1, 0 or 1
/// @return PREDICAMENT_OK, PREDICAMENT_NULL, PREDICAMENT_INDEX, PREDICAMENT_ARGUMENT, or PREDICAMENT_UNSUPPORTED if
/// the scene lacks the axis
///
/// The pointers are borrowed for the call. Any thread may call while no thread changes the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_compare(
    scene: *const predicament_scene,
    axis: i32,
    a: u32,
    b: u32,
    sign: *mut i8,
) -> predicament_result {
    let question = compare_of(axis);
    // SAFETY: the rules of the module.
    unsafe {
        ask(scene, question, [a, b], sign, |session, [a, b]| match question {
            Ok(Question::Compare(axis)) => session.compare(axis, a, b),
            _ => Sign::Zero,
        })
    }
}

/// The turn of three vertices of a scene in a coordinate plane.
///
/// The sign is that of predicament_orient2d().
///
/// @param scene  a scene
/// @param plane  a predicament_plane that the scene has
/// @param a, b, c  indices of points, or ids of constructed vertices
/// @param sign  receives -1, 0 or 1
/// @return PREDICAMENT_OK, PREDICAMENT_NULL, PREDICAMENT_INDEX, PREDICAMENT_ARGUMENT, or PREDICAMENT_UNSUPPORTED if
/// the scene lacks the plane
///
/// The pointers are borrowed for the call. Any thread may call while no thread changes the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_orient2d(
    scene: *const predicament_scene,
    plane: i32,
    a: u32,
    b: u32,
    c: u32,
    sign: *mut i8,
) -> predicament_result {
    let question = orient2d_of(plane);
    // SAFETY: the rules of the module.
    unsafe {
        ask(scene, question, [a, b, c], sign, |session, [a, b, c]| match question {
            Ok(Question::Orient2d(plane)) => session.orient2d(plane, a, b, c),
            _ => Sign::Zero,
        })
    }
}

/// The side of vertex d on the plane of three vertices, in a scene of space.
///
/// The sign is that of predicament_orient3d().
///
/// @param scene  a scene
/// @param a, b, c, d  indices of points, or ids of constructed vertices
/// @param sign  receives -1, 0 or 1
/// @return PREDICAMENT_OK, PREDICAMENT_NULL, PREDICAMENT_INDEX, or PREDICAMENT_UNSUPPORTED in a scene of the plane
///
/// The pointers are borrowed for the call. Any thread may call while no thread changes the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_orient3d(
    scene: *const predicament_scene,
    a: u32,
    b: u32,
    c: u32,
    d: u32,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe {
        ask(scene, Ok(Question::Orient3d), [a, b, c, d], sign, |session, [a, b, c, d]| session.orient3d(a, b, c, d))
    }
}

/// The place of vertex d at the circle through three vertices, in a scene of the plane.
///
/// The sign is that of predicament_incircle().
///
/// @param scene  a scene
/// @param a, b, c, d  indices of points, or ids of constructed vertices
/// @param sign  receives -1, 0 or 1
/// @return PREDICAMENT_OK, PREDICAMENT_NULL, PREDICAMENT_INDEX, or PREDICAMENT_UNSUPPORTED in a scene of space, or in
/// a scene of PREDICAMENT_SOS with constructed vertices
///
/// The pointers are borrowed for the call. Any thread may call while no thread changes the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_incircle(
    scene: *const predicament_scene,
    a: u32,
    b: u32,
    c: u32,
    d: u32,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe {
        ask(scene, Ok(Question::Incircle), [a, b, c, d], sign, |session, [a, b, c, d]| session.incircle(a, b, c, d))
    }
}

/// The place of vertex e at the sphere through four vertices, in a scene of space. They are points, not constructed
/// vertices.
///
/// The sign is that of predicament_insphere().
///
/// @param scene  a scene
/// @param a, b, c, d, e  indices of points, or ids of constructed vertices
/// @param sign  receives -1, 0 or 1
/// @return PREDICAMENT_OK, PREDICAMENT_NULL, PREDICAMENT_INDEX, or PREDICAMENT_UNSUPPORTED in a scene of the plane or
/// about a constructed vertex
///
/// The pointers are borrowed for the call. Any thread may call while no thread changes the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_insphere(
    scene: *const predicament_scene,
    a: u32,
    b: u32,
    c: u32,
    d: u32,
    e: u32,
    sign: *mut i8,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe {
        ask(scene, Ok(Question::Insphere), [a, b, c, d, e], sign, |session, [a, b, c, d, e]| {
            session.insphere(a, b, c, d, e)
        })
    }
}

/// predicament_scene_compare() for many queries.
///
/// @param scene  a scene
/// @param axis  a predicament_axis that the scene has
/// @param vertices  two vertices for each query: indices of points, or ids of constructed vertices
/// @param queries  the number of queries
/// @param signs  receives -1, 0 or 1 for each query; must not overlap the other array
/// @param bad  receives the index of the bad query after a failure; may be NULL
/// @return as predicament_scene_compare(), for the first bad query; PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
///
/// After a failure the signs mean nothing. The pointers are borrowed for the call. Any thread may call while no thread
/// changes the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_compare_batch(
    scene: *const predicament_scene,
    axis: i32,
    vertices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { ask_many::<2>(scene, compare_of(axis), vertices, queries, signs, bad) }
}

/// predicament_scene_orient2d() for many queries.
///
/// @param scene  a scene
/// @param plane  a predicament_plane that the scene has
/// @param vertices  three vertices for each query: indices of points, or ids of constructed vertices
/// @param queries  the number of queries
/// @param signs  receives -1, 0 or 1 for each query; must not overlap the other array
/// @param bad  receives the index of the bad query after a failure; may be NULL
/// @return as predicament_scene_orient2d(), for the first bad query; PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
///
/// After a failure the signs mean nothing. The pointers are borrowed for the call. Any thread may call while no thread
/// changes the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_orient2d_batch(
    scene: *const predicament_scene,
    plane: i32,
    vertices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { ask_many::<3>(scene, orient2d_of(plane), vertices, queries, signs, bad) }
}

/// predicament_scene_orient3d() for many queries.
///
/// @param scene  a scene
/// @param vertices  four vertices for each query: indices of points, or ids of constructed vertices
/// @param queries  the number of queries
/// @param signs  receives -1, 0 or 1 for each query; must not overlap the other array
/// @param bad  receives the index of the bad query after a failure; may be NULL
/// @return as predicament_scene_orient3d(), for the first bad query; PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
///
/// After a failure the signs mean nothing. The pointers are borrowed for the call. Any thread may call while no thread
/// changes the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_orient3d_batch(
    scene: *const predicament_scene,
    vertices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { ask_many::<4>(scene, Ok(Question::Orient3d), vertices, queries, signs, bad) }
}

/// predicament_scene_incircle() for many queries.
///
/// @param scene  a scene
/// @param vertices  four vertices for each query: indices of points, or ids of constructed vertices
/// @param queries  the number of queries
/// @param signs  receives -1, 0 or 1 for each query; must not overlap the other array
/// @param bad  receives the index of the bad query after a failure; may be NULL
/// @return as predicament_scene_incircle(), for the first bad query; PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
///
/// After a failure the signs mean nothing. The pointers are borrowed for the call. Any thread may call while no thread
/// changes the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_incircle_batch(
    scene: *const predicament_scene,
    vertices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { ask_many::<4>(scene, Ok(Question::Incircle), vertices, queries, signs, bad) }
}

/// predicament_scene_insphere() for many queries.
///
/// @param scene  a scene
/// @param vertices  five vertices for each query: indices of points, or ids of constructed vertices
/// @param queries  the number of queries
/// @param signs  receives -1, 0 or 1 for each query; must not overlap the other array
/// @param bad  receives the index of the bad query after a failure; may be NULL
/// @return as predicament_scene_insphere(), for the first bad query; PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
///
/// After a failure the signs mean nothing. The pointers are borrowed for the call. Any thread may call while no thread
/// changes the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_insphere_batch(
    scene: *const predicament_scene,
    vertices: *const u32,
    queries: usize,
    signs: *mut i8,
    bad: *mut usize,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { ask_many::<5>(scene, Ok(Question::Insphere), vertices, queries, signs, bad) }
}
