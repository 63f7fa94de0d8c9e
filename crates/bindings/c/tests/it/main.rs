//! Tests of the functions as a C program calls them: by pointers, codes and out-parameters.

#![allow(unsafe_code)]

mod guard;
mod header;
mod judged;
mod misuse;
mod package;
mod threads;

use std::path::PathBuf;

use predicament::ffi::predicament_result::{self, PREDICAMENT_OK};
use predicament::ffi::*;
use predicament_predicates::{Dimension, Question, Scene, Vertex};

/// A file of this crate.
fn file(name: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|why| panic!("{}: {why}", path.display()))
}

/// Random numbers (SplitMix64).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ x >> 31
    }

    fn below(&mut self, bound: u32) -> u32 {
        u32::try_from(self.bits() % u64::from(bound)).unwrap()
    }

    /// A number from 0 to 1.
    fn unit(&mut self) -> f64 {
        f64::from(self.below(1 << 31)) * 2_f64.powi(-31) + f64::from(self.below(1 << 20)) * 2_f64.powi(-51)
    }
}

/// A scene that is freed at the end of a test.
struct Owned(*mut predicament_scene);

impl Drop for Owned {
    fn drop(&mut self) {
        // SAFETY: it was made by `scene`, and is freed once.
        unsafe { predicament_scene_free(self.0) }
    }
}

/// A scene of these coordinates.
fn scene(dimension: usize, coordinates: &[f64], backend: predicament_backend) -> Owned {
    let mut scene = std::ptr::null_mut();
    let (count, stride) = (coordinates.len() / dimension, dimension * 8);
    let dimension = i32::try_from(dimension).unwrap();
    // SAFETY: the list has so many points.
    let made = unsafe {
        let points = coordinates.as_ptr();
        predicament_scene_new(points, count, stride, dimension, backend as i32, &raw mut scene, std::ptr::null_mut())
    };
    assert_eq!((made, scene.is_null()), (PREDICAMENT_OK, false));
    Owned(scene)
}

/// The same scene for the judge.
fn plain(dimension: usize, coordinates: &[f64]) -> Scene {
    Scene::new(Dimension::of(dimension).unwrap(), coordinates.to_vec()).unwrap()
}

/// The answer of a scene to one query.
fn ask(scene: &Owned, question: Question, ids: &[u32]) -> Result<i8, predicament_result> {
    let (mut sign, scene) = (99, scene.0.cast_const());
    let out = &raw mut sign;
    // SAFETY: the scene is not freed, and `sign` is there.
    let result = unsafe {
        match (question, ids) {
            (Question::Compare(axis), &[a, b]) => predicament_scene_compare(scene, axis as i32, a, b, out),
            (Question::Orient2d(plane), &[a, b, c]) => predicament_scene_orient2d(scene, plane as i32, a, b, c, out),
            (Question::Orient3d, &[a, b, c, d]) => predicament_scene_orient3d(scene, a, b, c, d, out),
            (Question::Incircle, &[a, b, c, d]) => predicament_scene_incircle(scene, a, b, c, d, out),
            (Question::Insphere, &[a, b, c, d, e]) => predicament_scene_insphere(scene, a, b, c, d, e, out),
            _ => panic!("{question:?} of {ids:?}"),
        }
    };
    if result == PREDICAMENT_OK { Ok(sign) } else { Err(result) }
}

/// The answers of a scene to many queries, or the failure and its place.
fn ask_many(scene: &Owned, question: Question, ids: &[u32]) -> Result<Vec<i8>, (predicament_result, usize)> {
    let queries = ids.len() / question.kind().arity();
    let (mut signs, mut bad, scene) = (vec![99; queries], usize::MAX, scene.0.cast_const());
    let (ids, out, bad_out) = (ids.as_ptr(), signs.as_mut_ptr(), &raw mut bad);
    // SAFETY: the lists have these lengths.
    let result = unsafe {
        match question {
            Question::Compare(axis) => predicament_scene_compare_batch(scene, axis as i32, ids, queries, out, bad_out),
            Question::Orient2d(plane) => {
                predicament_scene_orient2d_batch(scene, plane as i32, ids, queries, out, bad_out)
            }
            Question::Orient3d => predicament_scene_orient3d_batch(scene, ids, queries, out, bad_out),
            Question::Incircle => predicament_scene_incircle_batch(scene, ids, queries, out, bad_out),
            Question::Insphere => predicament_scene_insphere_batch(scene, ids, queries, out, bad_out),
            Question::Derived(_) => panic!("not a function of the library"),
        }
    };
    if result == PREDICAMENT_OK { Ok(signs) } else { Err((result, bad)) }
}

/// The vertices with these ids.
fn vertices(ids: &[u32]) -> Vec<Vertex> {
    let input = |id: u32| Vertex::input(id as usize);
    let other = |id: u32| Vertex::constructed((id - PREDICAMENT_CONSTRUCTED) as usize);
    ids.iter().map(|&id| if id < PREDICAMENT_CONSTRUCTED { input(id) } else { other(id) }).collect()
}
