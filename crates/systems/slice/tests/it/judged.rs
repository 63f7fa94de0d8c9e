//! Tests of parts of meshes: correct parts have no flaw, and the check for each kind of damage reports it.

use predicament_predicates::{Scene, Vertex};
use predicament_slice::checks::given::{self, Fault};
use predicament_slice::checks::{Check, Expected, Part, Piece, Slices};
use rug::Rational;

const STRICT: Expected = Expected { is_closed: true, has_areas: true, may_stand: false, triangles_crossed: 1000 };

/// A cube of edge 4, and its lower and upper halves with caps in the plane z = 2, by hand.
fn halves() -> Slices {
    let square = [[0, 0], [4, 0], [4, 4], [0, 4]];
    let level = |z: i32| square.map(|[x, y]| [x, y, z].map(Rational::from));
    // 0 to 3 below, 4 to 7 above, 8 to 11 between.
    let points = [level(0), level(4), level(2)].concat();
    let faces = vec![
        vec![0, 3, 2, 1],
        vec![4, 5, 6, 7],
        vec![0, 1, 5, 4],
        vec![1, 2, 6, 5],
        vec![2, 3, 7, 6],
        vec![3, 0, 4, 7],
    ];
    let boxed = |low: u32, high: u32, bottom: Piece, top: Piece| {
        let mut part = Part::default();
        let mut push = |[a, b, c, d]: [u32; 4], piece| {
            part.triangles.extend([[a, b, c], [a, c, d]]);
            part.pieces.extend([piece; 2]);
        };
        push([low, low + 3, low + 2, low + 1], bottom);
        push([high, high + 1, high + 2, high + 3], top);
        for side in 0..4 {
            let next = (side + 1) % 4;
            push([low + side, low + next, high + next, high + side], Piece::Face(2 + side as usize));
        }
        part
    };
    let parts = vec![boxed(0, 8, Piece::Face(0), Piece::Cap(0)), boxed(8, 4, Piece::Cap(0), Piece::Face(1))];
    Slices { points, faces, planes: vec![[8, 9, 10]], parts }
}

fn found(slices: &Slices, expected: Expected) -> Vec<Check> {
    slices.flaws(expected).into_iter().map(|flaw| flaw.check).collect()
}

#[test]
fn right_parts_have_no_flaw() {
    assert_eq!(halves().flaws(STRICT), []);
}

/// A kind of damage to parts, and the checks that report it.
type Spoilt = (&'static str, fn(&mut Slices), &'static [Check]);

const SPOILT: &[Spoilt] = &[
    (
        "a triangle of a side is lost",
        |slices| {
            slices.parts[0].triangles.pop();
            slices.parts[0].pieces.pop();
        },
        &[Check::Closed, Check::FaceArea],
    ),
    (
        "an open loop in a part of a closed mesh",
        |slices| {
            let part = &mut slices.parts[0];
            let [a, b, c] = part.triangles.remove(0);
            part.pieces.remove(0);
            part.open.push(vec![a, b, c]);
        },
        &[Check::Closed, Check::FaceArea],
    ),
    (
        "a face in the other part",
        |slices| {
            let (triangle, piece) = (slices.parts[1].triangles.remove(2), slices.parts[1].pieces.remove(2));
            slices.parts[0].triangles.push(triangle);
            slices.parts[0].pieces.push(piece);
        },
        &[Check::Closed, Check::Side],
    ),
    (
        "a point of the cut is moved off the plane, in its face",
        |slices| slices.points[8][2] += Rational::from((1, 1 << 30)),
        // The point is one of the plane's three, so the plane moves and the fourth point is off it.
        &[Check::Side, Check::CapInPlane],
    ),
    (
        "a point of the cut is moved out of a face",
        |slices| slices.points[9][0] += Rational::from((1, 1 << 30)),
        &[Check::PieceInFace, Check::FaceArea, Check::Volume],
    ),
    (
        "a cap that faces into its part",
        |slices| slices.parts[0].triangles[2..4].iter_mut().for_each(|triangle| triangle.reverse()),
        &[Check::Closed, Check::CapOrientation, Check::Volume],
    ),
    (
        "a cap that faces into its part, and is off its plane by what rounding could do",
        |slices| {
            slices.points[11][2] += Rational::from((1, 1_u64 << 52));
            slices.parts[0].triangles[2..4].iter_mut().for_each(|triangle| triangle.reverse());
        },
        &[Check::Closed, Check::Side, Check::CapInPlane, Check::CapOrientation, Check::Volume],
    ),
    (
        "both caps face into their parts",
        |slices| {
            slices.parts[0].triangles[2..4].iter_mut().for_each(|triangle| triangle.reverse());
            slices.parts[1].triangles[0..2].iter_mut().for_each(|triangle| triangle.reverse());
        },
        &[Check::Closed, Check::CapOrientation],
    ),
    (
        "a piece that is turned over",
        |slices| slices.parts[0].triangles[0].reverse(),
        &[Check::Closed, Check::PieceOrientation, Check::FaceArea],
    ),
    (
        "a face is covered twice",
        |slices| {
            for _ in 0..2 {
                let (triangle, piece) = (slices.parts[0].triangles[0], slices.parts[0].pieces[0]);
                slices.parts[0].triangles.push(triangle);
                slices.parts[0].pieces.push(piece);
            }
        },
        &[Check::Closed, Check::FaceArea],
    ),
    (
        "a triangle without area, and what it takes to close the part",
        |slices| {
            // The bottom again with its corner at the middle of a diagonal.
            let middle = u32::try_from(slices.points.len()).unwrap();
            slices.points.push([2, 2, 0].map(Rational::from));
            slices.parts[0].triangles.splice(0..1, [[0, 3, 2], [0, 2, middle], [0, middle, 2]]);
            slices.parts[0].pieces.splice(0..1, [Piece::Face(0); 3]);
        },
        &[Check::Degenerate],
    ),
    (
        "the volumes of the parts are one too much, in one more part",
        |slices| {
            let part = slices.parts[0].clone();
            slices.parts.push(part);
        },
        &[Check::FaceArea, Check::Volume],
    ),
    (
        "a spike through the opposite side",
        |slices| {
            let tip = u32::try_from(slices.points.len()).unwrap();
            slices.points.push([2, 1, -9].map(Rational::from));
            // From the upper cap of the lower part.
            let [a, b, c] = slices.parts[0].triangles[2];
            slices.parts[0].triangles.splice(2..3, [[a, b, tip], [b, c, tip], [c, a, tip]]);
            slices.parts[0].pieces.splice(2..3, [Piece::Cap(0); 3]);
        },
        &[Check::CapInPlane, Check::SelfIntersection, Check::Volume],
    ),
];

#[test]
fn each_way_to_spoil_parts_is_seen_by_its_checks() {
    let mut seen = Vec::new();
    for (what, spoil, checks) in SPOILT {
        let mut slices = halves();
        spoil(&mut slices);
        let found = found(&slices, STRICT);
        for check in *checks {
            assert!(found.contains(check), "{what}: {found:?}");
        }
        seen.extend(checks.iter().copied());
    }
    for check in Check::ALL {
        assert!(seen.contains(&check), "{} is never violated", check.name());
    }
}

#[test]
fn what_breaks_ties_may_have_triangles_without_area() {
    let mut slices = halves();
    let (_, spoil, _) = SPOILT.iter().find(|(what, ..)| what.starts_with("a triangle without area")).unwrap();
    spoil(&mut slices);
    assert_eq!(found(&slices, Expected { has_areas: false, ..STRICT }), []);
    assert_eq!(found(&slices, STRICT), [Check::Degenerate]);
}

#[test]
fn an_open_loop_closes_a_part_of_an_open_mesh() {
    let mut slices = halves();
    let part = &mut slices.parts[0];
    let bottom: Vec<[u32; 3]> = part.triangles.drain(0..2).collect();
    part.pieces.drain(0..2);
    part.open.push(vec![0, 3, 2, 1]);
    assert_eq!(bottom.len(), 2);
    slices.faces.remove(0);
    for part in &mut slices.parts {
        for piece in &mut part.pieces {
            if let Piece::Face(face) = piece {
                *face -= 1;
            }
        }
    }
    assert_eq!(found(&slices, Expected { is_closed: false, ..STRICT }), []);
    slices.parts[0].open[0].reverse();
    assert_eq!(found(&slices, Expected { is_closed: false, ..STRICT }), [Check::Closed]);
}

#[test]
fn samples_of_triangles_find_what_is_near_them() {
    let mut slices = halves();
    let (_, spoil, _) = SPOILT.iter().find(|(what, ..)| what.starts_with("a spike")).unwrap();
    spoil(&mut slices);
    for triangles_crossed in [14, 100] {
        let expected = Expected { triangles_crossed, ..STRICT };
        assert!(found(&slices, expected).contains(&Check::SelfIntersection), "{triangles_crossed}");
    }
}

/// The number of times that two triangles of one part pass through each other, without any other law.
fn crossings(corners: [[[i32; 3]; 3]; 2], expected: Expected) -> usize {
    let points = corners.as_flattened().iter().map(|p| p.map(Rational::from)).collect();
    let part = Part { triangles: vec![[0, 1, 2], [3, 4, 5]], pieces: vec![Piece::Face(0); 2], ..Part::default() };
    let slices = Slices { points, faces: vec![vec![0, 1, 2], vec![3, 4, 5]], planes: Vec::new(), parts: vec![part] };
    let flaws = slices.flaws_of_surface(expected);
    flaws.iter().filter(|flaw| flaw.check == Check::SelfIntersection).count()
}

#[test]
fn edges_that_pass_beside_a_triangle_do_not_pass_through_it() {
    let flat = [[0, 0, 0], [8, 0, 0], [0, 8, 0]];
    // An upright triangle with an edge that crosses the plane of the flat triangle at this point.
    let upright = |x: i32, y: i32| [[x, y, -2], [x, y, 2], [x + 1, y + 3, 9]];
    let (mut through, mut beside) = (0, 0);
    for (x, y) in (0..8).flat_map(|x| (0..8).map(move |y| (x, y))) {
        for turn in 0..3 {
            let (mut first, mut second) = (flat, upright(x, y));
            first.rotate_left(turn);
            second.rotate_right(turn);
            // The upright triangle meets the plane in the segment from (x, y) to at most a third of the way to its far
            // corner.
            let is_inside = x > 0 && y > 0 && x + y < 8;
            if is_inside {
                assert_eq!(crossings([first, second], STRICT), 1, "{x} {y}");
                assert_eq!(crossings([second, first], STRICT), 1, "{x} {y}");
                through += 1;
            } else if x + y > 8 {
                assert_eq!(crossings([first, second], STRICT), 0, "{x} {y}");
                assert_eq!(crossings([second, first], STRICT), 0, "{x} {y}");
                beside += 1;
            }
        }
    }
    assert!(through > 50 && beside > 50, "{through} through, {beside} beside");
}

#[test]
fn faces_lie_on_each_other_where_solids_may_stand() {
    let up = [[0, 0, 0], [8, 0, 0], [0, 8, 0]];
    let [on_it, away] = [[[1, 1, 0], [1, 3, 0], [3, 1, 0]], [[9, 9, 0], [9, 12, 0], [12, 9, 0]]];
    let standing = Expected { may_stand: true, ..STRICT };
    assert_eq!([STRICT, standing].map(|expected| crossings([up, on_it], expected)), [1, 0]);
    assert_eq!([STRICT, standing].map(|expected| crossings([up, away], expected)), [0, 0]);
    // Both look up.
    let turned = [on_it[0], on_it[2], on_it[1]];
    assert_eq!([STRICT, standing].map(|expected| crossings([up, turned], expected)), [1, 1]);
}

#[test]
fn metric_flaws_say_by_how_much() {
    let mut slices = halves();
    slices.points[11][2] += Rational::from((1, 1 << 20));
    slices.points[9][0] += Rational::from((1, 1 << 10));
    let flaws = slices.flaws(STRICT);
    let metric = Check::ALL.into_iter().filter(|check| check.is_metric());
    assert_eq!(flaws.iter().map(|flaw| flaw.check).collect::<Vec<_>>(), metric.collect::<Vec<_>>());
    let told = |check: Check| &*flaws.iter().find(|flaw| flaw.check == check).unwrap().what;
    assert_eq!(told(Check::Side), "part 0 is on both sides of plane 0, by 9.5367431640625e-7");
    assert_eq!(told(Check::CapInPlane), "a cap of part 0 is 9.5367431640625e-7 off plane 0");
    assert_eq!(told(Check::PieceInFace), "a piece of face 3 is 9.765625e-4 off its plane");
    assert!(told(Check::FaceArea).starts_with("the 4 pieces of face 2 have "), "{}", told(Check::FaceArea));
}

/// Meshes that are refused: each with its fault, over vertices of its own.
#[test]
fn faces_that_are_no_mesh_to_slice() {
    let tetrahedron = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let with = |more: &[[f64; 3]], other: &[[usize; 3]]| {
        let points: Vec<[f64; 3]> = tetrahedron.iter().chain(more).copied().collect();
        let scene = Scene::from_points3(&points).unwrap();
        let all: Vec<Vec<Vertex>> =
            faces.iter().chain(other).map(|face| face.iter().map(|&at| Vertex::input(at)).collect()).collect();
        given::fault(&scene, &all, true)
    };
    let copy = [[4, 6, 5], [4, 5, 7], [5, 6, 7], [6, 4, 7]];
    let moved = |by: [f64; 3]| tetrahedron.map(|p| [0, 1, 2].map(|axis: usize| p[axis] + by[axis]));
    assert_eq!(with(&[], &[]), None);
    assert_eq!(with(&tetrahedron, &copy), Some(Fault::Doubled([0, 4])));
    assert_eq!(with(&moved([1.0, 1.0, 0.0]), &copy), Some(Fault::Doubled([0, 4])));
    assert_eq!(with(&moved([0.5, 0.5, 0.5]), &copy), Some(Fault::Crossing([2, 4])));
    assert_eq!(with(&moved([4.0, 0.0, 0.0]), &copy), None, "they touch in a corner");
    assert_eq!(with(&moved([9.0, 0.0, 0.0]), &copy), None, "apart");
    // A solid that stands on a face of another, over vertices of its own.
    let below = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, -4.0]];
    let turned = copy.map(|[a, b, c]| [a, c, b]);
    assert_eq!(with(&below, &turned), None);
    // Two faces back to back, apart from the rest.
    let flat = [[9.0, 0.0, 0.0], [9.0, 4.0, 0.0], [9.0, 0.0, 4.0]];
    assert_eq!(with(&flat, &[[4, 5, 6], [4, 6, 5]]), Some(Fault::Flat(4)));
    assert_eq!(
        given::fault(
            &Scene::from_points3(&flat).unwrap(),
            &[vec![0, 1, 2].into_iter().map(Vertex::input).collect()],
            false
        ),
        None
    );
    // One mesh alone: inside out, folded, and faces that are not polygons.
    let alone = |points: &[[f64; 3]], faces: &[&[usize]], is_closed: bool| {
        let all: Vec<Vec<Vertex>> =
            faces.iter().map(|face| face.iter().copied().map(Vertex::input).collect()).collect();
        given::fault(&Scene::from_points3(points).unwrap(), &all, is_closed)
    };
    let inverted = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
    let inverted: Vec<&[usize]> = inverted.iter().map(|face| face.as_slice()).collect();
    assert_eq!(alone(&tetrahedron, &inverted, true), Some(Fault::InsideOut));
    let square = [[1.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(alone(&square, &[&[1, 2, 3], &[0, 3, 2]], false), Some(Fault::Folded([0, 1])));
    assert_eq!(alone(&square, &[&[0, 1, 2], &[0, 2, 3]], false), None);
    assert_eq!(alone(&square, &[&[0, 1, 2, 3]], false), None);
    let crossed = alone(&square, &[&[0, 2, 1, 3]], false).expect("a bow tie");
    assert_eq!(crossed.face(), Some(0));
    assert!(crossed.told(|face| face.to_string()).0.starts_with("face 0 is not a polygon: the edges from 0 to 2 and"));
    let repeated = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    assert_eq!(alone(&repeated, &[&[0, 3, 1, 2]], false), Some(Fault::Repeated(0)));
    let (why, cure) = Fault::Flat(4).told(|face| face.to_string());
    assert_eq!((why.as_str(), cure), ("the closed part with face 4 has no volume", "leave the part out"));
}
