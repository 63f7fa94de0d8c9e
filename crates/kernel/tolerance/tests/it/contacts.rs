//! The backend's contacts: its requirements on a scene, and its answers on input outside of the algorithms' range.

use std::ops::{Add, Div, Mul, Neg, Sub};

use predicament_error_calculus::{Field, Ring, Root};
use predicament_predicates::{Backend, Declined, Off, Predicates, Scene, Vertex};
use predicament_tolerance::{ContactTolerances, Float, Tolerance, Tolerances2d, Tolerances3d};

const SINGLE: Tolerance<f32> = Tolerance::new();
const PRINTED: Tolerance = Tolerance::as_printed();

fn v<const N: usize>(indices: [usize; N]) -> [Vertex; N] {
    indices.map(Vertex::input)
}

fn plane(points: &[[f64; 2]], lengths: [f64; 2]) -> Scene {
    Scene::from_points2(points).unwrap().with_primitive_lengths(lengths)
}

fn space(points: &[[f64; 3]], lengths: [f64; 2]) -> Scene {
    Scene::from_points3(points).unwrap().with_primitive_lengths(lengths)
}

fn declined<F: Float>(scene: &Scene) -> Option<Declined> {
    match Tolerance::<F>::new().prepare(scene, Off) {
        Ok(session) => session.supports_contacts().err(),
        Err(declined) => Some(declined),
    }
}

#[test]
fn without_the_lengths_of_primitives_contacts_are_declined() {
    let scene = Scene::from_points2(&[[0.0, 0.0], [1.0, 1.0]]).unwrap();
    let session = Tolerance.prepare(&scene, Off).unwrap();
    assert!(session.supports_contacts().unwrap_err().reason.contains("the lengths of both meshes' primitives"));
    assert_eq!(session.contact_band([0, 0]), None);
    let with = scene.clone().with_primitive_lengths([1.0, 0.5]);
    let session = Tolerance.prepare(&with, Off).unwrap();
    assert_eq!(session.supports_contacts(), Ok(()));
    assert_eq!(
        session.contact_tolerances(),
        Ok(&ContactTolerances::Plane(Tolerances2d::from_lengths(1.0, 0.5))),
        "Algorithm 1"
    );
}

#[test]
fn bands_are_those_of_the_pairs_that_register_degeneracies() {
    let scene = plane(&[[0.0, 0.0], [9.0, 1.0]], [2.0, 1.0]);
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let t = Tolerances2d::from_lengths(2.0, 1.0);
    assert_eq!(session.contact_band([0, 0]), Some(t.sigma));
    assert_eq!([[0, 1], [1, 0]].map(|ranks| session.contact_band(ranks)), [Some(t.tau); 2]);
    assert_eq!([[1, 1], [0, 2], [2, 0]].map(|ranks| session.contact_band(ranks)), [None; 3]);
    assert_eq!(session.reach(), t.sigma.upper);
    assert_eq!(session.tolerances2d(predicament_predicates::Plane::Xy).unwrap().length, 9.0, "signs keep their own L");

    let scene = space(&[[0.0; 3], [9.0; 3]], [2.0, 1.0]);
    let session = SINGLE.prepare(&scene, Off).unwrap();
    let t = Tolerances3d::<f32>::from_lengths(2.0, 1.0);
    let bands = [[0, 0], [0, 1], [2, 0], [1, 1]].map(|ranks| session.contact_band(ranks));
    assert_eq!(bands, [t.sigma, t.tau, t.delta, t.gamma].map(Some));
    assert_eq!([[1, 2], [2, 1], [0, 3], [3, 0]].map(|ranks| session.contact_band(ranks)), [None; 4]);
    assert_eq!(session.reach(), t.sigma.upper);
}

#[test]
fn all_bands_are_those_of_the_figure() {
    let flat = plane(&[[0.0, 0.0], [9.0, 1.0]], [2.0, 1.0]);
    let bands = ContactTolerances::<f64>::new(&flat).unwrap().bands();
    assert_eq!(bands, Tolerances2d::<f64>::from_lengths(2.0, 1.0).bands());
    let deep = space(&[[0.0; 3], [9.0; 3]], [2.0, 1.0]);
    let bands = ContactTolerances::<f64>::new(&deep).unwrap().bands();
    assert_eq!(bands, Tolerances3d::<f64>::from_lengths(2.0, 1.0).bands());
    assert_eq!(bands.len(), 12);
}

#[test]
fn coordinates_that_are_not_of_the_format_are_named() {
    let scene = Scene::from_points3(&[[0.5, 1.0, 2.0], [3.0, 4.0, 5.0], [6.0, 0.1, 7.0]]).unwrap();
    let declined = SINGLE.prepare(&scene, Off).map(|_| ()).unwrap_err();
    let said = "point 2: coordinate 1 is 0.1, which f32 does not hold exactly, not even after a shift; \
                round the scene to f32 first";
    assert_eq!(declined.reason, said);
}

#[test]
fn pairs_of_the_plane_and_their_weights() {
    let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1e-9], [1.0, -1.0], [1.0, 3.0], [1.0, 1.0], [-1.0, 0.0]];
    let scene = plane(&points, [4.0, 4.0]);
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let [a, b, c, on, below, above, inside, behind] = v([0, 1, 2, 3, 4, 5, 6, 7]);
    assert!(session.vertex_vertex(a, a) && !session.vertex_vertex(a, b));
    assert_eq!(session.edge_vertex([a, b], on), Some(0.25));
    assert_eq!([inside, behind].map(|p| session.edge_vertex([a, b], p)), [None; 2]);
    assert_eq!(session.edge_edge([a, b], [below, above]), Some([0.25, 0.25]));
    assert_eq!(session.edge_edge([a, b], [above, inside]), None);
    assert_eq!(session.triangle_vertex([a, b, c], inside), Some([0.5, 0.25, 0.25]));
    assert_eq!(session.triangle_vertex([a, c, b], inside), Some([0.5, 0.25, 0.25]), "clockwise as well");
    assert_eq!(session.triangle_vertex([a, b, c], below), None);

    let session = PRINTED.prepare(&scene, Off).unwrap();
    assert_eq!(session.edge_vertex([a, b], on), None);
    assert_eq!(session.edge_vertex([a, b], behind), Some(0.25), "the mirror image");
}

#[test]
fn pairs_of_space_and_their_weights() {
    let points = [
        [0.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [0.0, 4.0, 0.0],
        [0.0, 0.0, 4.0],
        [1.0, 1e-5, 0.0],
        [1.0, -1.0, 1e-5],
        [1.0, 3.0, 1e-5],
        [1.0, 1.0, -1e-5],
        [1.0, 1.0, -2.0],
        [1.0, 1.0, 2.0],
        [0.5, 0.5, 1.0],
        [-1.0, 1e-5, 0.0],
        [1.0, 1.0, -1e-10],
    ];
    let scene = space(&points, [4.0, 4.0]);
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let [a, b, c, d, on, below, above, lifted, down, up, inside, behind, touching] =
        v([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]);
    assert!(session.vertex_vertex(a, a) && !session.vertex_vertex(a, b));
    assert_eq!(session.edge_vertex([a, b], on), Some(0.25));
    assert_eq!([up, behind].map(|p| session.edge_vertex([a, b], p)), [None; 2]);
    assert_eq!(session.edge_edge([a, b], [below, above]), Some([0.25, 0.25]));
    assert_eq!(session.edge_edge([a, b], [down, up]), None);
    assert_eq!(session.triangle_vertex([a, b, c], lifted), Some([0.5, 0.25, 0.25]));
    assert_eq!([up, below].map(|p| session.triangle_vertex([a, b, c], p)), [None; 2]);
    assert_eq!(session.triangle_edge([a, b, c], [down, up]), Some(([0.5, 0.25, 0.25], 0.5)));
    assert_eq!(session.triangle_edge([a, b, c], [touching, up]), None, "an end within ξ");
    assert_eq!(session.tetrahedron_vertex([a, b, c, d], inside), Some([0.5, 0.125, 0.125, 0.25]));
    assert_eq!(session.tetrahedron_vertex([b, a, c, d], inside), Some([0.125, 0.5, 0.125, 0.25]));
    assert_eq!(session.tetrahedron_vertex([a, b, c, d], down), None);

    let session = PRINTED.prepare(&scene, Off).unwrap();
    assert_eq!(session.edge_vertex([a, b], on), None);
    assert_eq!(session.edge_vertex([a, b], behind), Some(0.25), "the mirror image");
}

/// Asks all contact queries about these vertices and p; every answer must be "not registered".
fn asks_nothing_of(scene: &Scene, simplex: [usize; 4], p: usize) {
    let session = Tolerance.prepare(scene, Off).unwrap();
    let [a, b, c, d] = v(simplex);
    let p = Vertex::input(p);
    assert_eq!(session.edge_vertex([a, b], p), None);
    assert_eq!(session.edge_edge([a, b], [c, p]), None);
    assert_eq!(session.triangle_vertex([a, b, c], p), None);
    assert_eq!(session.triangle_edge([a, b, c], [d, p]), None);
    assert_eq!(session.tetrahedron_vertex([a, b, c, d], p), None);
}

#[test]
fn simplices_without_an_extent_only_meet_in_their_vertices() {
    // Vertices 0, 1, 2 and 3 are repeated, in a line and in a plane; 4 coincides with the first.
    let on_a_point = [[1.0, 2.0, 3.0]; 5];
    let in_a_line = [[0.0; 3], [0.0; 3], [1.0, 0.0, 0.0], [0.5, 0.0, 0.0], [0.25, 0.0, 0.0]];
    let in_a_plane = [[0.0; 3], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.25, 0.0]];
    for points in [on_a_point, in_a_line, in_a_plane] {
        for scale in [1.0, 1e-9, 1e9] {
            let points = points.map(|p| p.map(|x| x * scale));
            let scene = space(&points, [scale, scale]);
            asks_nothing_of(&scene, [0, 1, 2, 3], 4);
            let session = Tolerance.prepare(&scene, Off).unwrap();
            assert!(session.vertex_vertex(Vertex::input(0), Vertex::input(1)), "different ids, equal coordinates");
        }
    }
    let scene = plane(&[[0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [0.25, 0.0]], [1.0, 1.0]);
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let [a, b, c, p] = v([0, 1, 2, 3]);
    assert_eq!(session.edge_vertex([a, b], p), None);
    assert_eq!(session.edge_edge([a, b], [c, p]), None);
    assert_eq!(session.triangle_vertex([a, b, c], p), None);
    assert!(session.edge_vertex([a, c], p).is_some(), "an edge that has a length");
}

#[test]
fn where_all_primitives_are_points_only_equal_ones_are_registered() {
    // The squares of these differences underflow to zero.
    let points = [[1.0, 1.0], [1.0, 1.0], [0.0, 0.0], [1e-200, 0.0], [-0.0, 0.0]];
    let scene = plane(&points, [0.0, 0.0]);
    let session = Tolerance.prepare(&scene, Off).unwrap();
    assert_eq!(session.supports_contacts(), Ok(()));
    assert_eq!(session.reach(), 0.0);
    let [a, b, c, d, e] = v([0, 1, 2, 3, 4]);
    assert!(session.vertex_vertex(a, b) && session.vertex_vertex(c, e));
    assert!(!session.vertex_vertex(a, c) && !session.vertex_vertex(c, d));
}

#[test]
fn pairs_further_apart_than_their_lengths_are_never_registered() {
    // Primitives of size 1, far apart: errors would be as large as those of the distance.
    let far = 2.0_f64.powi(60);
    let points = [[0.0, 0.0], [1.0, 0.0], [far, -far], [far + 2048.0, far], [f64::MAX, f64::MAX], [-f64::MAX, 0.5]];
    let scene = Scene::from_points2(&points[..4]).unwrap().with_primitive_lengths([1.0, 1.0]);
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let [a, b, c, d] = v([0, 1, 2, 3]);
    assert_eq!(session.edge_edge([a, b], [c, d]), None);
    assert_eq!(session.edge_vertex([a, b], c), None);
    assert!(!session.vertex_vertex(a, c));
}

#[test]
fn what_underflows_or_overflows_is_declined() {
    let flat = |x: f64| plane(&[[0.0, 0.0], [1.0, 1.0]], [x, 0.0]);
    let deep = |x: f64| space(&[[0.0; 3], [1.0; 3]], [x, 0.0]);
    for x in [1e-150, 1e154, f64::MAX] {
        let reason = declined::<f64>(&flat(x)).unwrap_or_else(|| panic!("{x:e}")).reason;
        assert!(reason.contains("L = ") && reason.contains("f64"), "{reason}");
    }
    // ε^(3/2) L⁶ and L⁶ limit the range: L⁴ alone would allow more.
    for x in [1e-48, 1e52, 1e78, f64::MAX] {
        assert!(declined::<f64>(&deep(x)).unwrap_or_else(|| panic!("{x:e}")).reason.contains("six lengths"));
    }
    for x in [1e-140, 1.0, 1e153] {
        assert_eq!(declined::<f64>(&flat(x)), None, "{x:e}");
    }
    for x in [1e-46, 1.0, 1e50] {
        assert_eq!(declined::<f64>(&deep(x)), None, "{x:e}");
    }
    for x in [1e-17, 1e19, 1e60] {
        assert!(declined::<f32>(&flat(x)).is_some(), "{x:e}");
    }
    for x in [1e-6, 1e7] {
        assert!(declined::<f32>(&deep(x)).is_some(), "{x:e}");
    }
    for x in [1e-14, 1e18] {
        assert_eq!(declined::<f32>(&flat(x)), None, "{x:e}");
    }
    for x in [1e-4, 1e5] {
        assert_eq!(declined::<f32>(&deep(x)), None, "{x:e}");
    }
}

#[test]
fn single_precision_takes_only_what_it_holds() {
    let scene = plane(&[[0.0, 0.0], [1.0, 0.1]], [1.0, 1.0]);
    let reason = declined::<f32>(&scene).unwrap().reason;
    assert!(reason.contains("point 1: coordinate 1 is 0.1") && reason.contains("round the scene"), "{reason}");
    assert!(declined::<f32>(&plane(&[[1e60, 0.0], [-1e60, 0.0]], [1.0, 1.0])).is_some());
    assert!(declined::<f32>(&plane(&[[1e-60, 0.0], [1.0, 0.0]], [1.0, 1.0])).is_some());
    let rounded = plane(&[[0.0, 0.0], [1.0, f64::from(0.1_f32)]], [1.0, 1.0]);
    assert_eq!(declined::<f32>(&rounded), None);
    // Its bands are wide: 4.5 √ε L with ε = 2⁻²³.
    let near = [[0.0, 0.0], [1.0, 0.0], [0.5, f64::from(2.0_f32.powi(-9))]];
    let [a, b, p] = v([0, 1, 2]);
    let scene = plane(&near, [1.0, 1.0]);
    assert_eq!(SINGLE.prepare(&scene, Off).unwrap().edge_vertex([a, b], p), Some(0.5));
    assert_eq!(Tolerance.prepare(&scene, Off).unwrap().edge_vertex([a, b], p), None);
    assert_eq!(SINGLE.name(), "tolerance:f32");
    assert_eq!(Tolerance::<f32>::as_printed().name(), "fault:tolerance-as-printed:f32");
    assert_eq!((Tolerance.name(), PRINTED.name()), ("tolerance".to_string(), "fault:tolerance-as-printed".to_string()));
}

/// A format similar to half precision: ε = 2⁻¹⁰.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
struct Half(f64);

macro_rules! operator {
    ($trait:ident, $method:ident, $op:tt) => {
        impl $trait for Half {
            type Output = Half;
            fn $method(self, other: Half) -> Half {
                Half(self.0 $op other.0)
            }
        }
    };
}

operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

impl Neg for Half {
    type Output = Half;
    fn neg(self) -> Half {
        Half(-self.0)
    }
}

impl Ring for Half {
    fn abs(self) -> Half {
        Half(self.0.abs())
    }
}

impl Field for Half {
    fn one() -> Half {
        Half(1.0)
    }
}

impl Root for Half {
    fn sqrt(self) -> Half {
        Half(self.0.sqrt())
    }
}

impl Float for Half {
    const NAME: &'static str = "half";
    const EPSILON: Half = Half(1.0 / 1024.0);
    const MIN_POSITIVE: Half = Half(1.0 / 16384.0);
    const ZERO: Half = Half(0.0);

    fn wide(self) -> f64 {
        self.0
    }

    fn nearest(x: f64) -> Half {
        Half(x)
    }

    fn above(x: f64) -> Half {
        Half(x)
    }
}

#[test]
fn formats_too_coarse_for_the_proofs_are_declined() {
    let scene = plane(&[[0.0, 0.0], [1.0, 1.0]], [1.0, 1.0]);
    let declined = Tolerance::<Half>::new().prepare(&scene, Off).map(|_| ()).unwrap_err();
    assert!(declined.reason.contains("below 1e-5; that of half is 9.765625e-4"), "{declined}");
}

#[test]
#[should_panic(expected = "below 1e-5; that of half")]
fn formats_too_coarse_for_the_proofs_have_no_tolerances_in_the_plane() {
    let _ = Tolerances2d::from_length(Half(1.0));
}

#[test]
#[should_panic(expected = "below 1e-5; that of half")]
fn formats_too_coarse_for_the_proofs_have_no_tolerances_in_space() {
    let _ = Tolerances3d::from_lengths(Half(1.0), Half(1.0));
}
