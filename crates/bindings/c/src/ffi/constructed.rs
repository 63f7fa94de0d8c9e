//! Vertices that are constructed from others.

use predicament_predicates::{Construction, Vertex};

use super::queries::vertex;
use super::{check_list, guarded, indices_of, list, predicament_result, predicament_scene};
use crate::failure::predicament_result::*;

/// Constructs the vertices of definitions of `N` vertices.
///
/// # Safety
/// `scene` is NULL or a scene that nobody else uses; the arrays keep the rules of the module.
unsafe fn add<const N: usize>(
    scene: *mut predicament_scene,
    definitions: *const u32,
    count: usize,
    vertices: *mut u32,
    bad: *mut usize,
    construction: impl Fn([Vertex; N]) -> Construction,
) -> predicament_result {
    let body = || {
        // SAFETY: the caller's promise.
        let scene = unsafe { scene.as_mut() }.ok_or(PREDICAMENT_NULL)?;
        // SAFETY: the caller's promise.
        let definitions = unsafe { list(definitions, indices_of::<N>(count)?)? };
        if count > 0 {
            check_list(vertices.cast_const(), count)?;
        }
        let definitions: Vec<Construction> =
            definitions.as_chunks::<N>().0.iter().map(|ids| construction(ids.map(vertex))).collect();
        for (at, id) in scene.0.construct(&definitions)?.into_iter().enumerate() {
            // SAFETY: there is place for a vertex of each definition.
            unsafe { vertices.add(at).write(number(id)) };
        }
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { guarded(bad, body) }
}

/// The id of a vertex.
fn number(vertex: Vertex) -> u32 {
    u32::try_from(vertex.index()).expect("an id has 32 bits")
}

/// Adds vertices to a scene of the plane: each is the point where two lines meet.
///
/// Queries are about the exact point, which is not rounded.
///
/// @param scene  a scene
/// @param definitions  four vertices each: two of the first line, two of the second
/// @param count  the number of definitions
/// @param vertices  receives the id of each vertex, with the bit PREDICAMENT_CONSTRUCTED
/// @param bad  receives the index of the bad definition after a failure; may be NULL
/// @return PREDICAMENT_OK; for the first bad definition PREDICAMENT_INDEX, PREDICAMENT_REPEATED, PREDICAMENT_NO_POINT
/// or PREDICAMENT_UNSUPPORTED; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
///
/// All vertices are added, or none. Later definitions may name earlier vertices of the same call, except in a scene of
/// PREDICAMENT_SOS, whose definitions name points only. A definition that the scene has already gives the same id. The
/// arrays are borrowed for the call. While it runs, no other thread may use the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_add_ssi(
    scene: *mut predicament_scene,
    definitions: *const u32,
    count: usize,
    vertices: *mut u32,
    bad: *mut usize,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe { add::<4>(scene, definitions, count, vertices, bad, |[a, b, c, d]| Construction::Ssi([[a, b], [c, d]])) }
}

/// Adds vertices to a scene of space: each is the point where a line meets a plane.
///
/// Queries are about the exact point, which is not rounded.
///
/// @param scene  a scene
/// @param definitions  five vertices each: two of the line, three of the plane
/// @param count  the number of definitions
/// @param vertices  receives the id of each vertex, with the bit PREDICAMENT_CONSTRUCTED
/// @param bad  receives the index of the bad definition after a failure; may be NULL
/// @return PREDICAMENT_OK; for the first bad definition PREDICAMENT_INDEX, PREDICAMENT_REPEATED, PREDICAMENT_NO_POINT
/// or PREDICAMENT_UNSUPPORTED; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
///
/// All vertices are added, or none. Later definitions may name earlier vertices of the same call, except in a scene of
/// PREDICAMENT_SOS, whose definitions name points only. A definition that the scene has already gives the same id. The
/// arrays are borrowed for the call. While it runs, no other thread may use the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_add_lpi(
    scene: *mut predicament_scene,
    definitions: *const u32,
    count: usize,
    vertices: *mut u32,
    bad: *mut usize,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe {
        add::<5>(scene, definitions, count, vertices, bad, |[a, b, c, d, e]| Construction::Lpi {
            line: [a, b],
            plane: [c, d, e],
        })
    }
}

/// Adds vertices to a scene of space: each is the point where three planes meet.
///
/// Queries are about the exact point, which is not rounded.
///
/// @param scene  a scene
/// @param definitions  nine vertices each: three of each plane
/// @param count  the number of definitions
/// @param vertices  receives the id of each vertex, with the bit PREDICAMENT_CONSTRUCTED
/// @param bad  receives the index of the bad definition after a failure; may be NULL
/// @return PREDICAMENT_OK; for the first bad definition PREDICAMENT_INDEX, PREDICAMENT_REPEATED, PREDICAMENT_NO_POINT
/// or PREDICAMENT_UNSUPPORTED; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
///
/// All vertices are added, or none. Later definitions may name earlier vertices of the same call, except in a scene of
/// PREDICAMENT_SOS, whose definitions name points only. A definition that the scene has already gives the same id. The
/// arrays are borrowed for the call. While it runs, no other thread may use the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn predicament_scene_add_tpi(
    scene: *mut predicament_scene,
    definitions: *const u32,
    count: usize,
    vertices: *mut u32,
    bad: *mut usize,
) -> predicament_result {
    // SAFETY: the rules of the module.
    unsafe {
        add::<9>(scene, definitions, count, vertices, bad, |[a, b, c, d, e, f, g, h, i]| {
            Construction::Tpi([[a, b, c], [d, e, f], [g, h, i]])
        })
    }
}
