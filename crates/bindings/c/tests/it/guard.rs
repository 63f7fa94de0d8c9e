//! A panic does not leave the library.

use predicament::ffi::predicament_result::PREDICAMENT_INTERNAL;
use predicament::ffi::testing::{self, panics};
use predicament_predicates::Plane;

use super::*;

/// The functions that say nothing about points: they cannot panic, and have no guard.
const UNGUARDED: [&str; 2] = ["predicament_version", "predicament_result_text"];

/// Without the guard the process would end here: `extern "C"` functions abort when a panic leaves them.
#[test]
fn a_panic_becomes_a_code() {
    let mut bad = 77;
    // SAFETY: a place, and NULL.
    let results = unsafe { [panics(&raw mut bad), panics(std::ptr::null_mut())] };
    assert_eq!((results, bad), ([PREDICAMENT_INTERNAL; 2], 0));
}

/// The exported functions of a file whose bodies call none of the guarded helpers.
fn unguarded(source: &str) -> Vec<&str> {
    let helpers = ["guarded(", "single(", "compare_single(", "many(", "compare_many(", "make(", "counts("];
    let helpers = [&helpers[..], &["ask(", "ask_many::<", "add::<"]].concat();
    let functions = source.split("extern \"C\" fn ").skip(1).map(|rest| {
        let body = rest.split("\n}\n").next().unwrap_or_default();
        (rest.split('(').next().unwrap_or_default(), body.split_once(" {\n").map_or("", |(_, body)| body))
    });
    let bare = functions.filter(|(_, body)| !helpers.iter().any(|helper| body.contains(helper)));
    bare.map(|(name, _)| name).filter(|name| !UNGUARDED.contains(name)).collect()
}

#[test]
fn every_exported_function_is_guarded() {
    let (mut seen, mut helpers) = (0, String::new());
    for name in super::header::SOURCES {
        let source = file(name);
        assert_eq!(unguarded(&source), [""; 0], "{name}");
        seen += source.matches("#[unsafe(no_mangle)]").count();
        assert_eq!(
            source.matches("#[unsafe(no_mangle)]").count(),
            source.matches("extern \"C\" fn predicament").count()
        );
        helpers += &source;
    }
    assert!(seen > 45, "{seen} functions");
    // Each helper calls the guard, or another helper.
    helpers += &file("src/ffi/mod.rs");
    for name in ["single", "many", "make", "counts", "ask", "ask_many", "add"] {
        let body = helpers.split(&format!("unsafe fn {name}<")).nth(1);
        let body = body.or_else(|| helpers.split(&format!("unsafe fn {name}(")).nth(1)).expect("the helper");
        assert!(body.split("\n}\n").next().is_some_and(|body| body.contains("guarded(")), "{name} has no guard");
    }
    let planted = "pub extern \"C\" fn predicament_a(x: i32) -> i32 {\n    x / 0\n}\n\npub extern \"C\" fn predicament_b() {\n    unsafe { guarded(b, body) }\n}\n";
    assert_eq!(unguarded(planted), ["predicament_a"]);
}

/// A panic while a scene changes leaves a scene that only says so.
#[test]
fn a_scene_that_broke_answers_nothing() {
    let (turn, ids) = (Question::Orient2d(Plane::Xy), [0, 1, 2]);
    let scene = scene(2, &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0], predicament_backend::PREDICAMENT_EXACT);
    assert_eq!(ask(&scene, turn, &ids), Ok(1));
    // SAFETY: the scene is not freed.
    unsafe { testing::panics_in(scene.0) };
    assert_eq!(ask(&scene, turn, &ids), Err(PREDICAMENT_INTERNAL));
    assert_eq!(ask_many(&scene, turn, &ids), Err((PREDICAMENT_INTERNAL, 0)));
    let (mut id, definition) = (0, [0, 1, 1, 2]);
    // SAFETY: one definition.
    let added =
        unsafe { predicament_scene_add_ssi(scene.0, definition.as_ptr(), 1, &raw mut id, std::ptr::null_mut()) };
    assert_eq!((added, id), (PREDICAMENT_INTERNAL, 0));
}
