//! Meshes are written and read back, bit by bit; meshes that a format cannot hold are refused.

use predicament_formats::{Decimals, ExportError, MeshFormat, mesh, write_mesh};
use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::IndexedFaces;
use predicament_predicates::Vertex;
use proptest::prelude::*;

fn written(format: MeshFormat, points: &[[f64; 3]], faces: &IndexedFaces) -> Result<Vec<u8>, ExportError> {
    let mut bytes = Vec::new();
    write_mesh(&mut bytes, format, points, faces).map(|()| bytes)
}

fn bits(points: &[[f64; 3]]) -> Vec<[u64; 3]> {
    points.iter().map(|point| point.map(f64::to_bits)).collect()
}

/// The corners of all faces as coordinates.
fn corners(points: &[[f64; 3]], faces: &IndexedFaces) -> Vec<Vec<[u64; 3]>> {
    let place = |&corner: &u32| points[corner as usize].map(f64::to_bits);
    faces.iter().map(|corners| corners.iter().map(place).collect()).collect()
}

fn is_stl(format: MeshFormat) -> bool {
    matches!(format, MeshFormat::StlAscii | MeshFormat::StlBinary)
}

/// Writes and reads a mesh; decimals are read exactly or refused.
fn round_trip(format: MeshFormat, points: &[[f64; 3]], faces: &IndexedFaces) {
    let bytes = written(format, points, faces).unwrap_or_else(|why| panic!("{format:?}: {why}"));
    assert_eq!(bytes, written(format, points, faces).expect("again"), "the same bytes");
    let read = mesh::read(&format!("m{}", format.extension()), bytes, &Decimals::new(false));
    let read = read.unwrap_or_else(|why| panic!("{format:?}: {why}"));
    assert!(read.notes.is_clean() && read.edges.is_empty(), "{format:?}");
    assert_eq!(corners(&read.points, &read.faces), corners(points, faces), "{format:?}");
    if is_stl(format) {
        assert_eq!(read.points.len(), points.len(), "{format:?}");
    } else {
        assert_eq!(bits(&read.points), bits(points), "{format:?}");
        assert_eq!(&read.faces, faces, "{format:?}");
    }
}

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

fn single() -> impl Strategy<Value = f64> {
    any::<u32>().prop_map(|bits| f64::from(f32::from_bits(bits))).prop_filter("finite", |x| x.is_finite())
}

fn coordinate() -> impl Strategy<Value = f64> {
    let simple = prop::sample::select(vec![0.0, -0.0, 1.0, -0.5, 1e300, 5e-324, f64::MAX, 0.1]);
    prop_oneof![4 => finite(), 1 => simple]
}

/// A strategy for faces of three corners and more, over `vertices` vertices.
fn polygons(vertices: usize) -> impl Strategy<Value = IndexedFaces> {
    let all: Vec<u32> = (0..).take(vertices).collect();
    let face = prop::sample::subsequence(all, 3..=vertices).prop_shuffle();
    prop::collection::vec(face, 0..6).prop_map(|faces| faces.into_iter().collect())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn every_bit_comes_back(points in prop::collection::vec([coordinate(), coordinate(), coordinate()], 6), faces in polygons(6)) {
        for format in MeshFormat::ALL.into_iter().filter(|&format| !is_stl(format)) {
            round_trip(format, &points, &faces);
        }
    }

    #[test]
    fn every_bit_of_triangles_comes_back_from_stl(
        doubles in prop::collection::hash_set(prop::array::uniform3(any::<u64>()), 3..12),
        singles in prop::collection::vec([single(), single(), single()], 3..12),
    ) {
        for (points, format) in [
            (doubles.into_iter().map(|of| of.map(f64::from_bits)).collect::<Vec<_>>(), MeshFormat::StlAscii),
            (singles, MeshFormat::StlBinary),
        ] {
            let mut points: Vec<[f64; 3]> =
                points.into_iter().filter(|point| point.iter().all(|x| x.is_finite())).collect();
            points.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
            points.dedup();
            let last = u32::try_from(points.len()).expect("a few");
            if last >= 3 {
                round_trip(format, &points, &(2..last).map(|at| [at, 0, at - 1]).collect());
            }
        }
    }
}

#[test]
fn many_corners_and_no_faces() {
    let points: Vec<[f64; 3]> = (0..300).map(|at| [f64::from(at), 0.1 * f64::from(at), -0.0]).collect();
    let faces: IndexedFaces = [(0..300).collect::<Vec<u32>>(), vec![2, 1, 0]].into_iter().collect();
    for format in MeshFormat::ALL {
        if is_stl(format) {
            assert!(matches!(written(format, &points, &faces), Err(ExportError::NoTriangle { face: 0, corners: 300 })));
            round_trip(format, &[], &IndexedFaces::default());
        } else {
            round_trip(format, &points, &faces);
            round_trip(format, &points, &IndexedFaces::default());
            round_trip(format, &[], &IndexedFaces::default());
        }
    }
}

#[test]
fn a_half_edge_mesh_goes_through_every_format() {
    let points: [[f64; 3]; 5] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, 0.25, -3.0]];
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|face| face.map(Vertex::input));
    let mut mesh = HalfEdgeMesh::of_scene(4, &faces).unwrap();
    let edge = mesh.half_edges().next().unwrap();
    let v = mesh.split_edge(edge, Vertex::input(4)).unwrap();
    for f in mesh.faces_once([v].into_iter(), 1).collect::<Vec<_>>() {
        let before = mesh.half_edge_in_face(f, v).unwrap();
        mesh.cut_ear(before).unwrap();
    }
    let (vertices, faces) = mesh.to_indexed();
    let points: Vec<[f64; 3]> = vertices.iter().map(|v| points[v.index()]).collect();
    assert_eq!((points.len(), faces.len()), (5, 6));
    for format in MeshFormat::ALL {
        round_trip(format, &points, &faces);
    }
}

#[test]
fn what_a_format_cannot_hold_is_refused_before_anything_is_written() {
    use MeshFormat::{Obj, Off, PlyAscii, PlyBinary, StlAscii, StlBinary};
    let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let of = |faces: &[&[u32]]| faces.iter().map(|face| face.iter().copied()).collect::<IndexedFaces>();
    let refused = |format, points: &[[f64; 3]], faces: &IndexedFaces| {
        let mut bytes = Vec::new();
        let why = write_mesh(&mut bytes, format, points, faces).expect_err("refused").to_string();
        assert!(bytes.is_empty() && !why.contains('\n'), "{why}");
        why
    };
    let quadrangle = of(&[&[0, 1, 2, 3]]);
    let triangles = of(&[&[0, 1, 2], &[0, 2, 3]]);
    let with = |at: usize, point: [f64; 3]| {
        let mut points = square;
        points[at] = point;
        points
    };
    for (got, expected) in [
        (refused(Off, &with(2, [1.0, f64::NAN, 0.0]), &quadrangle), "vertex 2 is not finite; no format can store it"),
        (
            refused(Obj, &square, &of(&[&[0, 1, 2], &[0, 1, 4]])),
            "face 1 has corner 4, which is not one of the 4 \
            vertices",
        ),
        (refused(PlyAscii, &square, &of(&[&[0, 1]])), "face 0 has 2 corners; give it three"),
        (refused(PlyBinary, &square, &of(&[&[0, 1, 0]])), "face 0 has vertex 0 twice; divide it"),
        (refused(StlAscii, &square, &quadrangle), "face 0 has 4 corners, and STL has triangles only; divide it"),
        (refused(StlAscii, &square, &of(&[&[0, 1, 2]])), "vertex 3 is in no face, and STL would lose it; remove it"),
        (
            refused(StlBinary, &with(3, [-0.0, 0.0, 0.0]), &triangles),
            "vertices 0 and 3 have the same coordinates, and STL would merge them; write PLY",
        ),
        (
            refused(StlBinary, &with(1, [0.1, 0.0, 0.0]), &triangles),
            "vertex 1 has a coordinate that is not a single, and binary STL would round it; write STL in ASCII",
        ),
    ] {
        assert!(got.starts_with(expected), "{got}");
    }
    // 1e300 and 1e-60 are not singles either; 0.1 rounded to a single is one.
    assert!(refused(StlBinary, &with(1, [1e300, 0.0, 0.0]), &triangles).contains("not a single"));
    assert!(refused(StlBinary, &with(1, [1e-60, 0.0, 0.0]), &triangles).contains("not a single"));
    round_trip(StlBinary, &with(1, [f64::from(0.1_f32), 0.0, 0.0]), &triangles);
}

#[test]
fn a_full_disk_is_an_error() {
    let mut room = [0_u8; 100];
    let points = [[0.1; 3]; 9];
    for format in [MeshFormat::Off, MeshFormat::PlyBinary] {
        let why = write_mesh(&mut room.as_mut_slice(), format, &points, &IndexedFaces::default()).expect_err("no room");
        assert!(why.to_string().starts_with("the mesh cannot be written: "), "{why}");
    }
}
