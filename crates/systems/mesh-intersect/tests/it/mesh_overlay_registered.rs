//! Tests of overlays by registered contacts against those by exact signs, and against the laws of an overlay.

use predicament_exact::Exact;
use predicament_mesh_intersect::algorithm::overlay::{Undone, Zeros, mesh_overlay, mesh_overlay_registered};
use predicament_predicates::{Backend, Off, Predicates, Vertex};
use predicament_tolerance::Tolerance;

use crate::common::overlaid::Pair;
use crate::common::shapes::{Random, Shape};

/// The outcome of a pair.
#[derive(PartialEq, Eq, Debug)]
enum Became {
    Same { constructed: usize },
    Contact([Vec<Vertex>; 2]),
}

/// Overlays a pair by contacts. If the overlay is done, it equals the one by exact signs, and each registered point is
/// near the exact one.
fn by_contacts(first: &Shape, second: &Shape) -> Became {
    let pair = Pair::without_truth(first.clone(), second.clone());
    let meshes = pair.meshes();
    let lengths = meshes.each_ref().map(|mesh| mesh.primitive_length(&pair.scene));
    let scene = pair.scene.clone().with_primitive_lengths(lengths);
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let mut steps = 0;
    let done = mesh_overlay_registered(&session, meshes.clone(), &mut |_| steps += 1);
    let (overlay, points) = match done {
        Ok(done) => done,
        Err(Undone::Contact(simplices)) => return Became::Contact(simplices),
        Err(why) => panic!("{why}: {:?}", pair.shapes),
    };
    assert_eq!(steps, 5);
    let mut exact = Exact.prepare(&scene, Off).unwrap();
    let truth = mesh_overlay(&mut exact, meshes, Zeros::Zero).unwrap();
    assert_eq!(overlay.regions(), truth.regions(), "{:?}", pair.shapes);
    assert_eq!(overlay.constructions(), truth.constructions());
    let reach = scene.coordinates().iter().fold(0.0_f64, |reach, x| reach.max(x.abs()));
    let exactly = predicament_judge::Points::of(exact.scene());
    let constructed = overlay.constructions().len();
    for v in (0..constructed).map(Vertex::constructed) {
        let point = exactly.point(v).unwrap();
        let place = points.place(v);
        assert_eq!(points.rounded_point(v), Some(&place[..]));
        // The error of a weight is at most a quarter power of epsilon (Algorithm 11), here far less.
        for (x, exact) in place.iter().zip(point.iter()) {
            assert!((x - exact.to_f64()).abs() <= 1e-9 * reach, "{v}: {x} {exact}");
        }
    }
    Became::Same { constructed }
}

#[test]
fn what_is_in_general_position_is_as_exact_signs_have_it() {
    let (mut random, mut constructed, mut near) = (Random(11), 0, 0);
    let mut add = |first: &Shape, second: &Shape| match by_contacts(first, second) {
        Became::Same { constructed: more } => constructed += more,
        Became::Contact(_) => near += 1,
    };
    let pairs = predicament_effort::scaled(300);
    for _ in 0..pairs {
        let mut shape = || loop {
            // (Three planes seldom share a point in integers, and thirds are not exact.)
            let shape = Shape::tetrahedron([(); 4].map(|()| random.point(1_000).map(|x| x / 3.0)));
            if !shape.triangles.is_empty() {
                return shape;
            }
        };
        add(&shape(), &shape());
    }
    let sphere = Shape::sphere(1000.0, 3);
    add(&sphere, &sphere.clone().moved([310.0, 220.0, 170.0]));
    add(
        &Shape::torus([3000.0, 1000.0], [12, 8]),
        &Shape::torus([3000.0, 1000.0], [12, 8]).moved([710.0, 520.0, 330.0]),
    );
    assert!(constructed > 150 && near < 5 + pairs / 30, "{constructed} {near} of {pairs}");
}

#[test]
fn what_touches_is_named() {
    let cube = Shape::cuboid([0.0; 3], [2.0; 3]);
    let rank = |simplices: &[Vec<Vertex>; 2]| simplices.each_ref().map(|simplex| simplex.len() - 1);
    for (other, ranks) in [
        (cube.clone(), [0, 0]),
        (cube.clone().moved([0.5, 0.0, 0.0]), [0, 1]),
        (cube.clone().moved([0.25, 0.5, 2.0]), [0, 2]),
        (cube.clone().moved([1e-12, 0.0, 0.0]), [0, 0]),
    ] {
        let Became::Contact(simplices) = by_contacts(&cube, &other) else { panic!("they touch") };
        assert_eq!(rank(&simplices), ranks, "{simplices:?}");
    }
    // Apart by more than σ, which is 0.0032 here; a thousandth is not.
    let apart = by_contacts(&cube, &cube.clone().moved([2.0625, 0.5, 0.25]));
    assert_eq!(apart, Became::Same { constructed: 0 });
}

#[test]
fn a_session_without_lengths_registers_nothing() {
    let cube = Shape::cuboid([0.0; 3], [2.0; 3]);
    let pair = Pair::without_truth(cube.clone(), cube);
    let session = Tolerance.prepare(&pair.scene, Off).unwrap();
    let refused = mesh_overlay_registered(&session, pair.meshes(), &mut |_| {}).unwrap_err();
    assert!(matches!(refused, Undone::Refused(_)) && refused.to_string().contains("lengths"), "{refused}");
}
