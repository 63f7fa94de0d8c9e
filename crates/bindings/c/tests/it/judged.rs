//! Every function against the judge, on points in general position, on a grid, near lines and planes, and of mixed
//! exponents.

use predicament_predicates::{Axis, Construction, Plane, Predicates, Question, Sign};
use predicament_sos::{Scheme, infinitesimal};

use super::*;
use predicament::ffi::predicament_backend::{PREDICAMENT_EXACT, PREDICAMENT_SOS};

/// The points of a scene.
const POINTS: u32 = 40;
/// The queries of each question about a scene.
const QUERIES: usize = 150;

const FLAT: [Question; 4] =
    [Question::Compare(Axis::X), Question::Compare(Axis::Y), Question::Orient2d(Plane::Xy), Question::Incircle];
const SOLID: [Question; 8] = [
    Question::Compare(Axis::X),
    Question::Compare(Axis::Y),
    Question::Compare(Axis::Z),
    Question::Orient2d(Plane::Xy),
    Question::Orient2d(Plane::Yz),
    Question::Orient2d(Plane::Zx),
    Question::Orient3d,
    Question::Insphere,
];

fn questions(dimension: usize) -> &'static [Question] {
    if dimension == 2 { &FLAT } else { &SOLID }
}

#[derive(Clone, Copy, Debug)]
enum Family {
    Uniform,
    Grid,
    Near,
    Wide,
}

/// The coordinates of random points.
fn points(family: Family, dimension: usize, random: &mut Random) -> Vec<f64> {
    let mut coordinate = |at: usize, family| match family {
        Family::Uniform => random.unit(),
        Family::Grid => f64::from(random.below(4)),
        // Points with equal coordinates, moved by a few ulps.
        Family::Near => {
            let x = 0.5 + f64::from(u32::try_from(at).unwrap()) / 64.0;
            f64::from_bits(x.to_bits() + u64::from(random.below(3)))
        }
        Family::Wide => {
            let exponent = i32::try_from(random.below(601)).unwrap() - 300;
            (random.unit() - 0.5) * 2_f64.powi(exponent)
        }
    };
    (0..POINTS as usize * dimension).map(|at| coordinate(at / dimension, family)).collect()
}

fn queries(arity: usize, vertices: &[u32], random: &mut Random) -> Vec<u32> {
    let last = u32::try_from(vertices.len()).unwrap();
    (0..QUERIES * arity).map(|_| vertices[random.below(last) as usize]).collect()
}

/// The truth of a query, without and with perturbation.
fn truth(scene: &Scene, question: Question, ids: &[u32]) -> [i8; 2] {
    let vertices = vertices(ids);
    let exact = predicament_judge::sign(scene, question, &vertices);
    let perturbed = match exact {
        Sign::Zero => infinitesimal::judge(Scheme::PerCoordinate, scene, question, &vertices),
        sign => sign,
    };
    [exact, perturbed].map(Sign::as_i8)
}

/// The sign of a query about points that are not in a scene, by the functions for one type of number.
macro_rules! singly {
    ($question:expr, $points:expr, $compare:ident $orient2d:ident $orient3d:ident $incircle:ident $insphere:ident) => {{
        let (points, mut sign) = ($points, 99);
        let (p, out) = (|at: usize| points[at].as_ptr(), &raw mut sign);
        // SAFETY: the points have the coordinates that the question reads.
        let result = unsafe {
            match $question {
                Question::Compare(axis) => $compare(axis as i32, p(0), p(1), out),
                Question::Orient2d(_) => $orient2d(p(0), p(1), p(2), out),
                Question::Orient3d => $orient3d(p(0), p(1), p(2), p(3), out),
                Question::Incircle => $incircle(p(0), p(1), p(2), p(3), out),
                Question::Insphere => $insphere(p(0), p(1), p(2), p(3), p(4), out),
                Question::Derived(_) => panic!("not a function of the library"),
            }
        };
        assert_eq!(result, PREDICAMENT_OK);
        sign
    }};
}

/// The signs of queries about an array of points, by the functions for one type of number.
macro_rules! together {
    ($question:expr, $points:expr, $dimension:expr, $ids:expr,
     $compare:ident $orient2d:ident $orient3d:ident $incircle:ident $insphere:ident) => {{
        let (points, ids, dimension) = ($points, $ids, $dimension);
        let (count, stride) = (points.len() / dimension, dimension * size_of_val(&points[0]));
        let queries = ids.len() / $question.kind().arity();
        let (mut signs, mut bad) = (vec![99; queries], usize::MAX);
        let (p, i, s, b) = (points.as_ptr(), ids.as_ptr(), signs.as_mut_ptr(), &raw mut bad);
        // SAFETY: the lists have these lengths.
        let result = unsafe {
            match $question {
                Question::Compare(axis) => $compare(axis as i32, p, count, stride, i, queries, s, b),
                Question::Orient2d(_) => $orient2d(p, count, stride, i, queries, s, b),
                Question::Orient3d => $orient3d(p, count, stride, i, queries, s, b),
                Question::Incircle => $incircle(p, count, stride, i, queries, s, b),
                Question::Insphere => $insphere(p, count, stride, i, queries, s, b),
                Question::Derived(_) => panic!("not a function of the library"),
            }
        };
        assert_eq!((result, bad), (PREDICAMENT_OK, usize::MAX));
        signs
    }};
}

/// Returns true for the questions that the functions without a scene answer.
fn is_plain(question: Question) -> bool {
    !matches!(question, Question::Orient2d(Plane::Yz | Plane::Zx))
}

/// A scene of integers, or the failure and its place.
fn scene_of_integers(
    dimension: usize,
    points: &[i64],
    backend: predicament_backend,
) -> Result<Owned, (predicament_result, usize)> {
    let (mut scene, mut bad) = (std::ptr::null_mut(), usize::MAX);
    let (count, stride) = (points.len() / dimension, dimension * 8);
    let dimension = i32::try_from(dimension).unwrap();
    // SAFETY: the list has so many points.
    let made = unsafe {
        predicament_scene_new_i64(
            points.as_ptr(),
            count,
            stride,
            dimension,
            backend as i32,
            &raw mut scene,
            &raw mut bad,
        )
    };
    if made == PREDICAMENT_OK { Ok(Owned(scene)) } else { Err((made, bad)) }
}

/// Integers far beyond doubles, with small differences: signs of functions without a scene, and ties and constructed
/// vertices as in a scene about the origin.
#[test]
fn scenes_of_long_integers_have_the_signs_of_the_same_scene_elsewhere() {
    let mut random = Random(9);
    let mut zeros = 0;
    for (origin, unit) in [(i64::MAX - 40, 1), (i64::MIN, 1), ((1 << 60) + 1, 1), (-(1 << 62), 1 << 58), (7, 3)] {
        for dimension in [2, 3] {
            let small: Vec<i64> = (0..POINTS as usize * dimension).map(|_| i64::from(random.below(5))).collect();
            let points: Vec<i64> = small.iter().map(|&x| origin + x * unit).collect();
            let doubles: Vec<f64> = small.iter().map(|&x| f64::from(i32::try_from(x).unwrap())).collect();
            for backend in [PREDICAMENT_EXACT, PREDICAMENT_SOS] {
                let far = scene_of_integers(dimension, &points, backend).expect("a scene");
                let near = scene(dimension, &doubles, backend);
                for &question in questions(dimension) {
                    let ids = queries(question.kind().arity(), &Vec::from_iter(0..POINTS), &mut random);
                    let signs = ask_many(&far, question, &ids).expect("signs");
                    assert_eq!(signs, ask_many(&near, question, &ids).expect("signs"), "{origin} {question:?}");
                    zeros += signs.iter().filter(|&&sign| sign == 0).count();
                    if backend == PREDICAMENT_EXACT && is_plain(question) {
                        let alone = together!(
                            question, &points, dimension, &ids,
                            predicament_compare_batch_i64 predicament_orient2d_batch_i64 predicament_orient3d_batch_i64
                            predicament_incircle_batch_i64 predicament_insphere_batch_i64
                        );
                        assert_eq!(signs, alone, "{origin} {question:?}");
                    }
                }
            }
        }
    }
    assert!(zeros > 500, "{zeros}");
}

#[test]
fn long_integers_that_span_too_much_are_refused_with_the_point() {
    let refused = |points: &[i64]| scene_of_integers(2, points, PREDICAMENT_EXACT).err();
    let range = |point| Some((predicament_result::PREDICAMENT_RANGE, point));
    // A span of 2^54 is taken; one more is not, unless all differences are even.
    let (low, high) = ((1 << 60) + 1, (1 << 60) + 1 + (1 << 54));
    assert_eq!(refused(&[low, 0, high, 1]), None);
    assert_eq!(refused(&[low, 0, high + 1, 1, low + 1, 5]), range(1));
    assert_eq!(refused(&[low, 0, high + 2, 1]), None);
    // The axes have origins of their own; one of doubles stays where it is.
    assert_eq!(refused(&[i64::MAX, i64::MIN, i64::MAX - 9, i64::MIN + (1 << 40)]), None);
    assert_eq!(refused(&[0, 1 << 62, 0, 1]), None);
    assert_eq!(refused(&[0, i64::MAX, 0, i64::MIN]), range(1));
    assert_eq!(refused(&[]), None);
}

#[test]
fn doubles_have_the_signs_of_the_judge() {
    let mut random = Random(1);
    let mut zeros = 0;
    for family in [Family::Uniform, Family::Grid, Family::Near, Family::Wide] {
        for dimension in [2, 3] {
            let coordinates = points(family, dimension, &mut random);
            let truths = plain(dimension, &coordinates);
            let scenes = [PREDICAMENT_EXACT, PREDICAMENT_SOS].map(|backend| scene(dimension, &coordinates, backend));
            for &question in questions(dimension) {
                let arity = question.kind().arity();
                let ids = queries(arity, &Vec::from_iter(0..POINTS), &mut random);
                let truths = ids.chunks_exact(arity).map(|query| truth(&truths, question, query));
                let truths: Vec<[i8; 2]> = truths.collect();
                zeros += truths.iter().filter(|truth| truth[0] == 0).count();
                for (way, scene) in scenes.iter().enumerate() {
                    let signs = ask_many(scene, question, &ids).expect("signs");
                    for (at, query) in ids.chunks_exact(arity).enumerate() {
                        let said = (signs[at], ask(scene, question, query).expect("a sign"));
                        assert_eq!(said, (truths[at][way], truths[at][way]), "{family:?} {question:?} {query:?}");
                    }
                }
                if !is_plain(question) {
                    continue;
                }
                let signs = together!(question, &coordinates, dimension, &ids,
                    predicament_compare_batch predicament_orient2d_batch predicament_orient3d_batch
                    predicament_incircle_batch predicament_insphere_batch);
                for (at, query) in ids.chunks_exact(arity).enumerate() {
                    let corner = |&id: &u32| &coordinates[id as usize * dimension..][..dimension];
                    let corners: Vec<&[f64]> = query.iter().map(corner).collect();
                    let sign = singly!(question, &corners,
                        predicament_compare predicament_orient2d predicament_orient3d
                        predicament_incircle predicament_insphere);
                    assert_eq!((signs[at], sign), (truths[at][0], truths[at][0]), "{family:?} {question:?} {query:?}");
                }
            }
        }
    }
    assert!(zeros > 1000, "{zeros} ties");
}

/// A grid whose determinants overflow 32 bits, and floats whose determinants need more than doubles.
#[test]
fn floats_and_integers_have_the_signs_of_their_doubles() {
    let mut random = Random(2);
    for dimension in [2, 3] {
        let integers: Vec<i32> = (0..POINTS as usize * dimension)
            .map(|_| [i32::MIN, i32::MAX, 0, i32::MAX - 1][random.below(4) as usize] / 2 * 2)
            .collect();
        let floats: Vec<f32> = (0..integers.len()).map(|_| [0.1, 0.2, 1e9, -3e-30][random.below(4) as usize]).collect();
        let as_doubles: [Vec<f64>; 2] =
            [integers.iter().map(|&x| f64::from(x)).collect(), floats.iter().map(|&x| f64::from(x)).collect()];
        let truths = as_doubles.each_ref().map(|coordinates| plain(dimension, coordinates));
        let scenes = {
            let mut scenes = [std::ptr::null_mut(); 2];
            let [first, second] = scenes.each_mut().map(|scene| &raw mut *scene);
            let (count, stride, bad) = (POINTS as usize, dimension * 4, std::ptr::null_mut());
            let dimension = i32::try_from(dimension).unwrap();
            // SAFETY: the lists have so many points.
            let made = unsafe {
                [
                    predicament_scene_new_i32(integers.as_ptr(), count, stride, dimension, 0, first, bad),
                    predicament_scene_new_f32(floats.as_ptr(), count, stride, dimension, 0, second, bad),
                ]
            };
            assert_eq!(made, [PREDICAMENT_OK; 2]);
            scenes.map(Owned)
        };
        for &question in questions(dimension).iter().filter(|&&question| is_plain(question)) {
            let arity = question.kind().arity();
            let ids = queries(arity, &Vec::from_iter(0..POINTS), &mut random);
            let many = [
                together!(question, &integers, dimension, &ids,
                    predicament_compare_batch_i32 predicament_orient2d_batch_i32 predicament_orient3d_batch_i32
                    predicament_incircle_batch_i32 predicament_insphere_batch_i32),
                together!(question, &floats, dimension, &ids,
                    predicament_compare_batch_f32 predicament_orient2d_batch_f32 predicament_orient3d_batch_f32
                    predicament_incircle_batch_f32 predicament_insphere_batch_f32),
            ];
            for (at, query) in ids.chunks_exact(arity).enumerate() {
                let of_integers: Vec<&[i32]> =
                    query.iter().map(|&id| &integers[id as usize * dimension..][..dimension]).collect();
                let of_floats: Vec<&[f32]> =
                    query.iter().map(|&id| &floats[id as usize * dimension..][..dimension]).collect();
                let single = [
                    singly!(question, &of_integers,
                        predicament_compare_i32 predicament_orient2d_i32 predicament_orient3d_i32
                        predicament_incircle_i32 predicament_insphere_i32),
                    singly!(question, &of_floats,
                        predicament_compare_f32 predicament_orient2d_f32 predicament_orient3d_f32
                        predicament_incircle_f32 predicament_insphere_f32),
                ];
                for of in 0..2 {
                    let [exact, _] = truth(&truths[of], question, query);
                    let prepared = ask(&scenes[of], question, query).expect("a sign");
                    assert_eq!([many[of][at], single[of], prepared], [exact; 3], "{question:?} {query:?}");
                }
            }
        }
    }
}

/// Integers of 64 bits that are not doubles. The judge sees doubles: the same points, or moved by a constant.
#[test]
fn long_integers_have_the_signs_of_their_differences() {
    let mut random = Random(5);
    for dimension in [2, 3] {
        // Far from zero, with differences that are doubles; and everything near both ends.
        let far = i64::MAX - 9;
        let near: Vec<i64> = (0..POINTS as usize * dimension).map(|_| far + i64::from(random.below(5))).collect();
        let wide: Vec<i64> = (0..POINTS as usize * dimension)
            .map(|_| [i64::MIN, i64::MIN >> 1, 0, -(i64::MIN >> 1)][random.below(4) as usize])
            .collect();
        let moved = near.iter().map(|&x| f64::from(i32::try_from(x - far).unwrap())).collect();
        #[allow(clippy::cast_precision_loss)] // powers of two
        let powers = wide.iter().map(|&x| x as f64).collect();
        for (integers, doubles) in [(near, moved), (wide, powers)] {
            let doubles: Vec<f64> = doubles;
            let scene = plain(dimension, &doubles);
            for &question in questions(dimension).iter().filter(|&&question| is_plain(question)) {
                let arity = question.kind().arity();
                let ids = queries(arity, &Vec::from_iter(0..POINTS), &mut random);
                let many = together!(question, &integers, dimension, &ids,
                    predicament_compare_batch_i64 predicament_orient2d_batch_i64 predicament_orient3d_batch_i64
                    predicament_incircle_batch_i64 predicament_insphere_batch_i64);
                for (at, query) in ids.chunks_exact(arity).enumerate() {
                    let corners: Vec<&[i64]> =
                        query.iter().map(|&id| &integers[id as usize * dimension..][..dimension]).collect();
                    let single = singly!(question, &corners,
                        predicament_compare_i64 predicament_orient2d_i64 predicament_orient3d_i64
                        predicament_incircle_i64 predicament_insphere_i64);
                    let [exact, _] = truth(&scene, question, query);
                    assert_eq!([many[at], single], [exact; 2], "{question:?} {query:?}");
                }
            }
        }
    }
}

/// Points between other data: the stride is larger than a point, and no coordinate is aligned.
#[test]
fn points_may_stand_anywhere() {
    let coordinates: [f64; 6] = [0.0, 0.0, 24.0, 24.0, 12.0, 12.0 + f64::EPSILON * 8.0];
    let mut bytes = [0xff_u8; 3 + 3 * 29];
    for (at, point) in coordinates.as_chunks::<2>().0.iter().enumerate() {
        for (axis, x) in point.iter().enumerate() {
            bytes[3 + at * 29 + axis * 8..][..8].copy_from_slice(&x.to_ne_bytes());
        }
    }
    let (ids, mut signs) = ([0, 1, 2, 1, 0, 2, 0, 1, 1], [99; 3]);
    let points = bytes[3..].as_ptr().cast();
    // SAFETY: three points at distances of 29 bytes.
    let result =
        unsafe { predicament_orient2d_batch(points, 3, 29, ids.as_ptr(), 3, signs.as_mut_ptr(), std::ptr::null_mut()) };
    assert_eq!((result, signs), (PREDICAMENT_OK, [1, -1, 0]));
    let mut made = std::ptr::null_mut();
    // SAFETY: the same.
    let result = unsafe { predicament_scene_new(points, 3, 29, 2, 0, &raw mut made, std::ptr::null_mut()) };
    let made = Owned(made);
    assert_eq!((result, ask(&made, Question::Orient2d(Plane::Xy), &[0, 1, 2])), (PREDICAMENT_OK, Ok(1)));
}

type Add = unsafe extern "C" fn(*mut predicament_scene, *const u32, usize, *mut u32, *mut usize) -> predicament_result;

/// Adds vertices; returns their ids, or the failure and its place.
fn add(scene: &Owned, add: Add, definitions: &[u32], of: usize) -> Result<Vec<u32>, (predicament_result, usize)> {
    let (mut ids, mut bad) = (vec![0; definitions.len() / of], usize::MAX);
    // SAFETY: the lists have these lengths.
    let result = unsafe { add(scene.0, definitions.as_ptr(), ids.len(), ids.as_mut_ptr(), &raw mut bad) };
    if result == PREDICAMENT_OK { Ok(ids) } else { Err((result, bad)) }
}

fn definition(ids: &[u32]) -> Construction {
    match vertices(ids)[..] {
        [a, b, c, d] => Construction::Ssi([[a, b], [c, d]]),
        [a, b, c, d, e] => Construction::Lpi { line: [a, b], plane: [c, d, e] },
        [a, b, c, d, e, f, g, h, i] => Construction::Tpi([[a, b, c], [d, e, f], [g, h, i]]),
        _ => panic!("{ids:?}"),
    }
}

#[test]
fn constructed_vertices_are_exact_points() {
    let mut random = Random(3);
    let ways: [(usize, &[(Add, usize)]); 2] = [
        (2, &[(predicament_scene_add_ssi, 4)]),
        (3, &[(predicament_scene_add_lpi, 5), (predicament_scene_add_tpi, 9)]),
    ];
    for (dimension, ways) in ways {
        let coordinates = points(Family::Grid, dimension, &mut random);
        let mut truths = predicament_judge::Judged::exact(&plain(dimension, &coordinates));
        let scenes = [PREDICAMENT_EXACT, PREDICAMENT_SOS].map(|backend| scene(dimension, &coordinates, backend));
        let (mut all, mut refused) = (Vec::from_iter(0..POINTS), 0);
        for &(way, of) in ways {
            // One at a time, as many definitions of a grid have no point.
            let mut good = Vec::new();
            while good.len() < 12 * of {
                let ids: Vec<u32> = (0..of).map(|_| random.below(POINTS)).collect();
                let judged = truths.construct(&[definition(&ids)]);
                let added = scenes.each_ref().map(|scene| add(scene, way, &ids, of));
                assert_eq!(added.each_ref().map(Result::is_ok), [judged.is_ok(); 2], "{ids:?}: {judged:?} {added:?}");
                refused += usize::from(judged.is_err());
                if let [Ok(exact), Ok(sos)] = added {
                    assert_eq!(exact, sos);
                    good.extend(ids);
                    all.extend(exact);
                }
            }
            // All at once they are the same vertices.
            let again = scene(dimension, &coordinates, PREDICAMENT_EXACT);
            assert_eq!(add(&again, way, &good, of).map(|ids| ids.len()), Ok(12));
        }
        assert!(refused > 0, "{refused} refused");
        let counts = scenes.each_ref().map(|scene| {
            // SAFETY: the scene is not freed.
            unsafe { [predicament_scene_points(scene.0), predicament_scene_constructed(scene.0)] }
        });
        assert_eq!(counts, [[40, truths.scene().constructions().len()]; 2]);
        for &question in questions(dimension).iter().filter(|question| !question.kind().is_lifted()) {
            let arity = question.kind().arity();
            let ids = queries(arity, &all, &mut random);
            for (way, scene) in scenes.iter().enumerate() {
                let signs = ask_many(scene, question, &ids).expect("signs");
                for (query, sign) in ids.chunks_exact(arity).zip(signs) {
                    let truth = truth(truths.scene(), question, query)[way];
                    let single = ask(scene, question, query).expect("a sign");
                    assert_eq!([sign, single], [truth; 2], "{question:?} {query:?}");
                }
            }
        }
    }
}
