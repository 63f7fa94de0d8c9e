//! Misuse gives a code and the place of the bad item.

use std::ffi::CStr;
use std::ptr::{null, null_mut};

use predicament_predicates::{Axis, Plane};

use super::*;
use predicament::ffi::predicament_backend::{PREDICAMENT_EXACT, PREDICAMENT_SOS};
use predicament::ffi::predicament_result::*;

const A: [f64; 3] = [0.0, 0.0, 0.0];
const B: [f64; 3] = [1.0, 0.0, 0.0];
const C: [f64; 3] = [0.0, 1.0, 0.0];

/// Both results of a call: its code and the sign that it left.
fn turn(a: *const f64, b: *const f64, c: *const f64) -> (predicament_result, i8) {
    let mut sign = 99;
    // SAFETY: a pointer is NULL or leads to two coordinates.
    (unsafe { predicament_orient2d(a, b, c, &raw mut sign) }, sign)
}

#[test]
fn single_queries_refuse_null_and_numbers_that_are_not_finite() {
    assert_eq!(turn(A.as_ptr(), B.as_ptr(), C.as_ptr()), (PREDICAMENT_OK, 1));
    assert_eq!(turn(null(), B.as_ptr(), C.as_ptr()), (PREDICAMENT_NULL, 99));
    assert_eq!(turn(A.as_ptr(), B.as_ptr(), null()), (PREDICAMENT_NULL, 99));
    // SAFETY: all pointers are NULL or lead to points.
    unsafe {
        assert_eq!(predicament_orient2d(A.as_ptr(), B.as_ptr(), C.as_ptr(), null_mut()), PREDICAMENT_NULL);
        let mut sign = 99;
        for wrong in [-1, 3, i32::MIN, i32::MAX] {
            let result = predicament_compare(wrong, A.as_ptr(), B.as_ptr(), &raw mut sign);
            assert_eq!((result, sign), (PREDICAMENT_ARGUMENT, 99));
        }
        assert_eq!(predicament_compare(2, null(), B.as_ptr(), &raw mut sign), PREDICAMENT_NULL);
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let bad = [1.0, x, 0.5];
            assert_eq!(turn(A.as_ptr(), B.as_ptr(), bad.as_ptr()), (PREDICAMENT_NOT_FINITE, 99));
            let (a, b, c, bad) = (A.as_ptr(), B.as_ptr(), C.as_ptr(), bad.as_ptr());
            assert_eq!(predicament_compare(0, a, bad, &raw mut sign), PREDICAMENT_OK, "another coordinate");
            assert_eq!(predicament_compare(1, a, bad, &raw mut sign), PREDICAMENT_NOT_FINITE);
            assert_eq!(predicament_incircle(a, b, bad, c, &raw mut sign), PREDICAMENT_NOT_FINITE);
            assert_eq!(predicament_orient3d(a, b, bad, c, &raw mut sign), PREDICAMENT_NOT_FINITE);
            assert_eq!(predicament_insphere(a, b, c, a, bad, &raw mut sign), PREDICAMENT_NOT_FINITE);
        }
        let bad = [f32::NAN; 3];
        let bad = bad.as_ptr();
        assert_eq!(predicament_insphere_f32(bad, bad, bad, bad, bad, &raw mut sign), PREDICAMENT_NOT_FINITE);
    }
}

/// Calls orient2d on an array.
fn turns(points: &[f64], stride: usize, ids: &[u32]) -> (predicament_result, usize, Vec<i8>) {
    let (mut signs, mut bad) = (vec![99; ids.len() / 3], 77);
    let (count, out) = (points.len() * 8 / stride.max(16), signs.as_mut_ptr());
    // SAFETY: the list has so many points.
    let result = unsafe {
        predicament_orient2d_batch(points.as_ptr(), count, stride, ids.as_ptr(), signs.len(), out, &raw mut bad)
    };
    (result, bad, signs)
}

#[test]
fn batches_say_which_query_is_bad() {
    let points = [0.0, 0.0, 1.0, 0.0, 0.0, 1.0, f64::NAN, 0.0];
    assert_eq!(turns(&points, 16, &[0, 1, 2, 2, 1, 0]), (PREDICAMENT_OK, 77, vec![1, -1]));
    assert_eq!(turns(&points, 16, &[0, 1, 2, 2, 1, 4, 0, 1, 2]), (PREDICAMENT_INDEX, 1, vec![1, 99, 99]));
    assert_eq!(turns(&points, 16, &[0, 1, u32::MAX]), (PREDICAMENT_INDEX, 0, vec![99]));
    assert_eq!(turns(&points, 16, &[0, 1, 2, 2, 1, 0, 3, 1, 2]), (PREDICAMENT_NOT_FINITE, 2, vec![1, -1, 99]));
    assert_eq!(turns(&points, 15, &[0, 1, 2]).0, PREDICAMENT_ARGUMENT, "a stride in points, not in bytes");
    assert_eq!(turns(&points, 2, &[0, 1, 2]).0, PREDICAMENT_ARGUMENT);
    assert_eq!(turns(&[], 16, &[]), (PREDICAMENT_OK, 77, vec![]));
    assert_eq!(turns(&[], 16, &[0, 0, 0]), (PREDICAMENT_INDEX, 0, vec![99]));
    let (p, ids, mut signs, mut bad) = (points.as_ptr(), [0_u32; 6], [99_i8; 2], 77);
    let (i, s, b) = (ids.as_ptr(), signs.as_mut_ptr(), &raw mut bad);
    // SAFETY: pointers are NULL, or the lists are not read before their sizes are refused.
    unsafe {
        assert_eq!(predicament_orient2d_batch(null(), 3, 16, i, 1, s, b), PREDICAMENT_NULL);
        assert_eq!(predicament_orient2d_batch(p, 3, 16, null(), 1, s, b), PREDICAMENT_NULL);
        assert_eq!(predicament_orient2d_batch(p, 3, 16, i, 1, null_mut(), b), PREDICAMENT_NULL);
        assert_eq!(predicament_orient2d_batch(p, 3, 16, i, 1, s, null_mut()), PREDICAMENT_OK);
        assert_eq!(predicament_orient2d_batch(null(), 0, 16, null(), 0, null_mut(), b), PREDICAMENT_OK);
        assert_eq!(predicament_orient2d_batch(p, 3, 16, i.byte_add(2), 1, s, b), PREDICAMENT_MISALIGNED);
        assert_eq!(predicament_orient2d_batch(p, usize::MAX, 16, i, 1, s, b), PREDICAMENT_TOO_MANY);
        assert_eq!(predicament_orient2d_batch(p, 3, usize::MAX, i, 1, s, b), PREDICAMENT_TOO_MANY);
        assert_eq!(predicament_orient2d_batch(p, 3, 16, i, usize::MAX, s, b), PREDICAMENT_TOO_MANY);
        assert_eq!(predicament_orient2d_batch(p, 3, 16, i, usize::MAX / 16, s, b), PREDICAMENT_TOO_MANY);
        assert_eq!(predicament_compare_batch(2, p, 3, 16, i, 1, s, b), PREDICAMENT_ARGUMENT, "there is no z");
        assert_eq!(predicament_compare_batch(1, p, 3, 16, i, 3, s, b), PREDICAMENT_OK);
        assert_eq!(predicament_compare_batch(5, p, 3, 16, i, 1, s, b), PREDICAMENT_ARGUMENT);
    }
}

/// The result of making a scene, and the place of the bad point.
fn made(points: *const f64, count: usize, stride: usize, dimension: i32, backend: i32) -> (predicament_result, usize) {
    let (mut scene, mut bad) = (std::ptr::dangling_mut::<predicament_scene>(), 77);
    // SAFETY: the points are there, or their sizes are refused.
    let result =
        unsafe { predicament_scene_new(points, count, stride, dimension, backend, &raw mut scene, &raw mut bad) };
    assert!(result == PREDICAMENT_OK || scene.is_null(), "a failure leaves NULL");
    drop(Owned(scene));
    (result, bad)
}

#[test]
fn scenes_are_refused_with_the_bad_point() {
    let points = [0.0, 0.0, 1.0, 0.0, 0.0, f64::INFINITY];
    let p = points.as_ptr();
    assert_eq!(made(p, 2, 16, 2, 0), (PREDICAMENT_OK, 77));
    assert_eq!(made(p, 3, 16, 2, 0), (PREDICAMENT_NOT_FINITE, 2));
    assert_eq!(made(p, 2, 24, 3, 0), (PREDICAMENT_NOT_FINITE, 1));
    assert_eq!(made(null(), 0, 16, 2, 1), (PREDICAMENT_OK, 77));
    assert_eq!(made(null(), 1, 16, 2, 1).0, PREDICAMENT_NULL);
    assert_eq!(made(p, 1, 16, 3, 0).0, PREDICAMENT_ARGUMENT);
    assert_eq!(made(p, usize::MAX, 16, 2, 0).0, PREDICAMENT_TOO_MANY);
    assert_eq!(made(p, (1 << 31) + 1, 16, 2, 0).0, PREDICAMENT_TOO_MANY);
    for (dimension, backend) in [(1, 0), (4, 0), (0, 0), (2, 2), (2, -1)] {
        assert_eq!(made(p, 2, 24, dimension, backend).0, PREDICAMENT_ARGUMENT, "{dimension} {backend}");
    }
    // SAFETY: NULL is refused, freed and counted.
    unsafe {
        assert_eq!(predicament_scene_new(p, 2, 16, 2, 0, null_mut(), null_mut()), PREDICAMENT_NULL);
        predicament_scene_free(null_mut());
        assert_eq!((predicament_scene_points(null()), predicament_scene_constructed(null())), (0, 0));
    }
}

#[test]
fn scenes_refuse_queries_that_they_cannot_answer() {
    let flat = scene(2, &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0], PREDICAMENT_EXACT);
    let solid = scene(3, &[A, B, C, [0.0, 0.0, 1.0], [1.0; 3]].concat(), PREDICAMENT_SOS);
    let turn = Question::Orient2d(Plane::Xy);
    assert_eq!(ask(&flat, turn, &[0, 1, 4]), Err(PREDICAMENT_INDEX));
    assert_eq!(ask(&flat, turn, &[0, 1, PREDICAMENT_CONSTRUCTED]), Err(PREDICAMENT_INDEX));
    assert_eq!(ask(&flat, turn, &[0, 1, u32::MAX]), Err(PREDICAMENT_INDEX));
    assert_eq!(ask(&flat, Question::Orient2d(Plane::Yz), &[0, 1, 2]), Err(PREDICAMENT_UNSUPPORTED));
    assert_eq!(ask(&flat, Question::Compare(Axis::Z), &[0, 1]), Err(PREDICAMENT_UNSUPPORTED));
    assert_eq!(ask(&flat, Question::Orient3d, &[0, 1, 2, 3]), Err(PREDICAMENT_UNSUPPORTED));
    assert_eq!(ask(&flat, Question::Insphere, &[0, 1, 2, 3, 0]), Err(PREDICAMENT_UNSUPPORTED));
    assert_eq!(ask(&solid, Question::Incircle, &[0, 1, 2, 3]), Err(PREDICAMENT_UNSUPPORTED));
    assert_eq!(ask(&solid, Question::Orient3d, &[0, 1, 2, 3]), Ok(-1));
    assert_eq!(ask_many(&flat, turn, &[0, 1, 2, 0, 1, 4]), Err((PREDICAMENT_INDEX, 1)));
    let mut many = [0, 1, 2].repeat(5000);
    many[3 * 4321 + 1] = 4;
    assert_eq!(ask_many(&flat, turn, &many), Err((PREDICAMENT_INDEX, 4321)));
    assert_eq!(ask_many(&flat, turn, &[]), Ok(vec![]));
    assert_eq!(ask_many(&flat, Question::Orient3d, &[]), Err((PREDICAMENT_UNSUPPORTED, 0)));
    let (ids, mut signs, mut bad) = ([0_u32; 4], [99_i8], 77);
    let (i, s, b) = (ids.as_ptr(), signs.as_mut_ptr(), &raw mut bad);
    // SAFETY: pointers are NULL, or sizes are refused before a list is read.
    unsafe {
        let flat = flat.0;
        assert_eq!(predicament_scene_orient2d(null(), 0, 0, 1, 2, s), PREDICAMENT_NULL);
        assert_eq!(predicament_scene_orient2d(flat, 0, 0, 1, 2, null_mut()), PREDICAMENT_NULL);
        assert_eq!(predicament_scene_orient2d(flat, 3, 0, 1, 2, s), PREDICAMENT_ARGUMENT);
        assert_eq!(predicament_scene_compare(flat, -1, 0, 1, s), PREDICAMENT_ARGUMENT);
        assert_eq!(predicament_scene_orient2d_batch(null(), 0, i, 1, s, b), PREDICAMENT_NULL);
        assert_eq!(predicament_scene_orient2d_batch(flat, 0, null(), 1, s, b), PREDICAMENT_NULL);
        assert_eq!(predicament_scene_orient2d_batch(flat, 0, i, 1, null_mut(), b), PREDICAMENT_NULL);
        assert_eq!(predicament_scene_orient2d_batch(flat, 0, i.byte_add(1), 1, s, b), PREDICAMENT_MISALIGNED);
        assert_eq!(predicament_scene_orient2d_batch(flat, 0, i, usize::MAX, s, b), PREDICAMENT_TOO_MANY);
        assert_eq!(predicament_scene_orient2d_batch(flat, 9, i, 1, s, b), PREDICAMENT_ARGUMENT);
    }
    assert_eq!(signs, [99], "a refused query leaves its sign alone");
}

/// Adds the points where lines meet; returns ids, or the failure and its place.
fn add_ssi(scene: &Owned, definitions: &[u32]) -> Result<Vec<u32>, (predicament_result, usize)> {
    let (mut ids, mut bad) = (vec![0; definitions.len() / 4], 77);
    let count = ids.len();
    // SAFETY: the lists have these lengths.
    let result =
        unsafe { predicament_scene_add_ssi(scene.0, definitions.as_ptr(), count, ids.as_mut_ptr(), &raw mut bad) };
    if result == PREDICAMENT_OK { Ok(ids) } else { Err((result, bad)) }
}

#[test]
fn definitions_are_refused_with_their_place() {
    // A square, and a point on its diagonal.
    let square = [0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 0.0, 2.0, 1.5, 1.5];
    let [exact, sos] = [PREDICAMENT_EXACT, PREDICAMENT_SOS].map(|backend| scene(2, &square, backend));
    let first = PREDICAMENT_CONSTRUCTED;
    for scene in [&exact, &sos] {
        assert_eq!(add_ssi(scene, &[0, 2, 1, 3, 0, 1, 2, 3]), Err((PREDICAMENT_NO_POINT, 1)), "parallel lines");
        assert_eq!(add_ssi(scene, &[0, 0, 1, 3]), Err((PREDICAMENT_REPEATED, 0)));
        assert_eq!(add_ssi(scene, &[0, 2, 1, 3, 0, 2, 1, 5]), Err((PREDICAMENT_INDEX, 1)));
        assert_eq!(add_ssi(scene, &[0, first, 1, 3]), Err((PREDICAMENT_INDEX, 0)), "nothing was added so far");
        assert_eq!(add_ssi(scene, &[]), Ok(vec![]));
        assert_eq!(add_ssi(scene, &[0, 2, 1, 3, 3, 1, 2, 0]), Ok(vec![first, first]), "one definition");
        assert_eq!(ask(scene, Question::Compare(Axis::X), &[first, 4]), Ok(-1));
        let (mut id, mut bad, ids) = (0, 0, [0_u32, 1, 2, 3, 4, 0, 1, 2, 3]);
        let (i, v, b) = (ids.as_ptr(), &raw mut id, &raw mut bad);
        // SAFETY: the lists are there or refused.
        unsafe {
            assert_eq!(predicament_scene_add_lpi(scene.0, i, 1, v, b), PREDICAMENT_UNSUPPORTED, "a scene of the plane");
            assert_eq!(predicament_scene_add_tpi(scene.0, i, 1, v, b), PREDICAMENT_UNSUPPORTED);
            assert_eq!(predicament_scene_add_ssi(null_mut(), i, 1, v, b), PREDICAMENT_NULL);
            assert_eq!(predicament_scene_add_ssi(scene.0, null(), 1, v, b), PREDICAMENT_NULL);
            assert_eq!(predicament_scene_add_ssi(scene.0, i, 1, null_mut(), b), PREDICAMENT_NULL);
            assert_eq!(predicament_scene_add_ssi(scene.0, i, 1, v.byte_add(1), b), PREDICAMENT_MISALIGNED);
            assert_eq!(predicament_scene_add_ssi(scene.0, i, usize::MAX / 4, v, b), PREDICAMENT_TOO_MANY);
        }
    }
    assert_eq!(add_ssi(&exact, &[first, 1, 0, 4]).map(|ids| ids.len()), Ok(1), "a line through a constructed vertex");
    assert_eq!(add_ssi(&sos, &[first, 1, 0, 4]), Err((PREDICAMENT_UNSUPPORTED, 0)));
    let circle = [0, 1, 2, first];
    assert_eq!(ask(&exact, Question::Incircle, &circle), Ok(1));
    assert_eq!(ask(&sos, Question::Incircle, &circle), Err(PREDICAMENT_UNSUPPORTED));
    assert_eq!(ask_many(&sos, Question::Incircle, &circle), Err((PREDICAMENT_UNSUPPORTED, 0)));
}

#[test]
fn spheres_refuse_constructed_vertices() {
    let corners = [A, B, C, [0.0, 0.0, 1.0], [1.0; 3]].concat();
    for backend in [PREDICAMENT_EXACT, PREDICAMENT_SOS] {
        let solid = scene(3, &corners, backend);
        let (mut id, definition) = (0, [0_u32, 4, 1, 2, 3]);
        // SAFETY: one definition.
        let added = unsafe { predicament_scene_add_lpi(solid.0, definition.as_ptr(), 1, &raw mut id, null_mut()) };
        assert_eq!((added, id), (PREDICAMENT_OK, PREDICAMENT_CONSTRUCTED));
        assert_eq!(ask(&solid, Question::Insphere, &[0, 1, 2, 3, id]), Err(PREDICAMENT_UNSUPPORTED));
        let many = ask_many(&solid, Question::Insphere, &[0, 1, 2, 3, 4, 0, 1, 2, 3, id]);
        let place = usize::from(backend == PREDICAMENT_EXACT);
        assert_eq!(many, Err((PREDICAMENT_UNSUPPORTED, place)), "SoS refuses all spheres then");
        assert_eq!(ask(&solid, Question::Orient3d, &[0, 1, 2, id]), Ok(-1));
    }
}

#[test]
fn every_code_has_a_text_of_its_own() {
    // SAFETY: texts of the library end with NUL.
    let text = |code| unsafe { CStr::from_ptr(predicament_result_text(code)) }.to_str().unwrap();
    let texts: std::collections::BTreeSet<&str> = (0..12).map(text).collect();
    assert_eq!(texts.len(), 12);
    assert_eq!((text(PREDICAMENT_OK as i32), text(PREDICAMENT_INTERNAL as i32)), ("ok", "internal error"));
    for strange in [-1, 12, i32::MIN, i32::MAX] {
        assert_eq!(text(strange), "not a result code");
    }
    // SAFETY: the same.
    let version = unsafe { CStr::from_ptr(predicament_version()) };
    assert_eq!(version.to_str(), Ok(env!("CARGO_PKG_VERSION")));
}
