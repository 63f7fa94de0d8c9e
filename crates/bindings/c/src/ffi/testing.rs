//! Panics for the tests of the guard. C does not see them: their names are mangled, and linkers leave them out.

use super::{guarded, predicament_result, predicament_scene};

/// A function that panics, as a C program meets it.
///
/// # Safety
/// `bad` is NULL or can be written.
pub unsafe extern "C" fn panics(bad: *mut usize) -> predicament_result {
    // SAFETY: tests give a place or NULL.
    unsafe { guarded(bad, || panic!("planted")) }
}

/// Panics while the scene is changed.
///
/// # Safety
/// Nobody else uses the scene.
pub unsafe extern "C" fn panics_in(scene: *mut predicament_scene) -> predicament_result {
    let body = || {
        // SAFETY: the caller's promise.
        let scene = unsafe { scene.as_mut() }.expect("a scene");
        scene.0.change(|_| panic!("planted"))
    };
    // SAFETY: NULL is allowed.
    unsafe { guarded(std::ptr::null_mut(), body) }
}
