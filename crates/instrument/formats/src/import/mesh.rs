//! Mesh importers: OFF, OBJ and PLY, and STL, in ASCII or in binary; all of them also compressed by gzip.
//!
//! Only points and faces are read. Faces with more than three corners are kept unchanged, and are also divided into
//! triangles by a fan around their first corner. Decimals are read as in suites: exactly doubles, or refused, or
//! rounded if the suite requests it.

pub use super::imported_mesh::ImportedMesh;
use super::{obj, off, ply, stl};
use crate::data::{DataFile, Format};
use crate::decimals::MOST_COORDINATES;
use crate::{CorpusError, Decimals};

/// Reads a file by its extension, `.off`, `.obj`, `.ply` or `.stl`, each optionally with `.gz` appended.
///
/// # Errors
/// [`CorpusError`] at the line that is wrong, or, in a binary file, at the byte where the wrong element begins.
pub fn read(file: &str, bytes: Vec<u8>, decimals: &Decimals) -> Result<ImportedMesh, CorpusError> {
    read_data(DataFile::open(file, bytes)?, decimals)
}

/// Reads a file like [`read`], with its degenerate faces: faces that name a vertex twice, or have one or two corners.
///
/// # Errors
/// As [`read`].
pub fn read_degenerate(file: &str, bytes: Vec<u8>, decimals: &Decimals) -> Result<ImportedMesh, CorpusError> {
    let mesh = ImportedMesh { keeps_degenerate: true, ..ImportedMesh::default() };
    read_into(mesh, DataFile::open(file, bytes)?, decimals)
}

pub(super) fn read_data(data: DataFile, decimals: &Decimals) -> Result<ImportedMesh, CorpusError> {
    read_into(ImportedMesh::default(), data, decimals)
}

fn read_into(mesh: ImportedMesh, data: DataFile, decimals: &Decimals) -> Result<ImportedMesh, CorpusError> {
    let file = data.file.clone();
    let mesh = match data.format {
        Format::Off => off::read(&file, &data.text()?, decimals, mesh),
        Format::Obj => obj::read(&file, &data.text()?, decimals, mesh),
        Format::Ply => ply::read(&file, &data.bytes, decimals, mesh),
        Format::Stl => stl::read(&file, data.bytes, decimals, mesh),
        Format::Csv | Format::GeoJson | Format::Wkt => {
            Err(CorpusError::file(&file, "the file is not a mesh", "name a .off, .obj, .ply or .stl file"))
        }
    }?;
    if 3 * mesh.points.len() > MOST_COORDINATES {
        let message = format!("a mesh of {} points", mesh.points.len());
        return Err(CorpusError::file(file, message, format!("a scene has at most {MOST_COORDINATES} coordinates")));
    }
    Ok(mesh)
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use predicament_predicates::Vertex;
    use proptest::prelude::*;

    use super::*;
    use crate::{Position, hexfloat};

    fn read(file: &str, text: &str) -> Result<ImportedMesh, CorpusError> {
        super::read(file, text.into(), &Decimals::new(false))
    }

    fn v<const N: usize>(indices: [usize; N]) -> [Vertex; N] {
        indices.map(Vertex::input)
    }

    #[test]
    fn the_same_shape_in_both_formats() {
        let off =
            "OFF # a pyramid\n5 2 0\n\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0 5e-1 # apex\n4 0 1 2 3\n3 4 0 1 255 0 0\n";
        let obj = "mtllib none\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.1 0.2 0.3\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\nv 0.5 0 0.5\nf -1 1 2\n";
        let [off, obj] = [read("a.off", off).unwrap(), read("a.OBJ", obj).unwrap()];
        let lines = |mesh: &ImportedMesh| {
            let at = |position: Option<Position>| position.map(|at| at.to_string()).unwrap_or_default();
            let points: Vec<String> = (0..6).map(|point| at(mesh.places.point(point))).collect();
            let faces: Vec<String> = (0..3).map(|face| at(mesh.places.face(face))).collect();
            [points.join(","), faces.join(",")].map(|lines| lines.replace("line ", ""))
        };
        assert_eq!(lines(&off), ["4,5,6,7,8,", "9,10,"]);
        assert_eq!(lines(&obj), ["2,3,4,5,8,", "7,9,"]);
        assert_eq!(off, ImportedMesh { places: off.places.clone(), ..obj });
        assert_eq!(off.triangles, [v([0, 1, 2]), v([0, 2, 3]), v([4, 0, 1])]);
        assert_eq!(off.faces, [vec![0, 1, 2, 3], vec![4, 0, 1]].into_iter().collect());
        assert_eq!(off.points[4], [0.5, 0.0, 0.5]);
        let mut packed = flate2::read::GzEncoder::new("OFF\n1 0 0\n1 2 3\n".as_bytes(), flate2::Compression::fast());
        let mut bytes = Vec::new();
        packed.read_to_end(&mut bytes).unwrap();
        assert_eq!(super::read("c.off.gz", bytes, &Decimals::new(false)).unwrap().points, [[1.0, 2.0, 3.0]]);
        assert_eq!(read("b.off", "OFF 0 0 0").unwrap(), ImportedMesh::default());
        assert_eq!(read("b.obj", "v 0 0 0\nv 1 1 1\nv 2 2 0\nl 1 2 3").unwrap().edges, [v([0, 1]), v([1, 2])]);
    }

    #[test]
    fn errors_name_file_line_and_cure() {
        let off = |text: &str| read("m.off", &format!("OFF\n{text}")).unwrap_err().to_string();
        let obj = |text: &str| read("m.obj", &format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{text}")).unwrap_err().to_string();
        for (got, expected) in [
            (off("2 0 0\n0 0 0\n"), "m.off:3: the file ends after 1 of its 2 vertices; correct"),
            (off("1 1 0\n0 0 0\n"), "m.off:3: the file ends after 0 of its 1 faces; correct"),
            (off("1 0 0\n0 0 0\n0 0 1\n"), "m.off:4: there is extra text after the 0 faces; correct"),
            (off("1 0\n0 0 0\n"), "m.off:2: three counts are expected"),
            (read("m.off", "# none\n").unwrap_err().to_string(), "m.off: the file ends before the word OFF; give"),
            (off(""), "m.off:1: the file ends before its counts; give"),
            (off("1 1 0\n0 0 0\n3 0 0 1\n"), "m.off:4: `1` is not one of the 1 vertices; indices count from 0"),
            (off("1 1 0\n0 0 0\n3 0 0\n"), "m.off:4: a face is the number of its corners, then the corners; give"),
            (off("2 1 0\n0 0 0\n3 0 1 2\n"), "m.off:4: a vertex of 4 numbers, and the first has 3; correct the counts"),
            (off("1 0 0\n0 0\n"), "m.off:3: a vertex of 2 coordinates; write three"),
            (off("1 0 0\n0 0 nan\n"), "m.off:3: coordinate `nan` is not finite; remove"),
            (obj("f 1 2\n"), "m.obj:4: a face of 2 corners; give it three"),
            (obj("f 1 2 4\n"), "m.obj:4: `4` is not one of the 3 vertices; indices count from 1"),
            (obj("f 0 1 2\n"), "m.obj:4: `0` is not one of the 3 vertices"),
            (obj("f -4 1 2\n"), "m.obj:4: `-4` is not one of the 3 vertices"),
            (obj("f 1 2 1\n"), "m.obj:4: a face that names a vertex twice; divide it"),
            (obj("l 1 2 2\n"), "m.obj:4: a line that names a vertex twice in a row; name it once"),
            (obj("l 1\n"), "m.obj:4: a line of 1 vertices; give it two"),
            (obj("v 1 0 0 2\n"), "m.obj:4: a vertex of weight 2; divide its coordinates by the weight"),
            (obj("v 1 0 0 1e400\n"), "m.obj:4: a vertex of weight 1e400; divide"),
            (obj("v 1 0 0 w\n"), "m.obj:4: `w` is not a number; write a number"),
            (obj("v 1 0 0 0.1 0.2 red\n"), "m.obj:4: `red` is not a number; write a number"),
            (obj("v 1 0 0 1 0.5\n"), "m.obj:4: a vertex of 5 numbers; write three coordinates, and perhaps"),
            (obj("v 1 0 0 1 0 0 0\n"), "m.obj:4: a vertex of 7 numbers; write"),
            (obj("curv 1 2\n"), "m.obj:4: `curv` is not understood; write"),
            (read("m.off", "solid\n").unwrap_err().to_string(), "m.off:1: the file starts with `solid`, not with OFF;"),
            (read("m.off.gz", "OFF").unwrap_err().to_string(), "m.off.gz: the file can't be unpacked: "),
            (
                super::read("m.off", b"OFF\n\xff".into(), &Decimals::new(false)).unwrap_err().to_string(),
                "m.off:2: the file is not text in UTF-8; write",
            ),
            (read("m.3ds", "").unwrap_err().to_string(), "m.3ds: the file name does not show its format; name"),
            (read("m.wkt", "").unwrap_err().to_string(), "m.wkt: the file is not a mesh; name"),
            (
                obj("v 0.1000000000000000001 0 0\n"),
                "m.obj:4: decimal 0.1000000000000000001 has digits that no double holds; write `round = true` in the scene",
            ),
            (off("99999999999 0 0\n0 0 0\n"), "m.off:3: the file ends after 1 of its 99999999999 vertices; correct"),
            (off("1 99999999999 0\n0 0 0\n"), "m.off:3: the file ends after 0 of its 99999999999 faces; correct"),
            (off("1 1 0\n0 0 0\n99999999999 0\n"), "m.off:4: a face is the number of its corners"),
        ] {
            assert!(got.starts_with(expected), "{got}\n  expected {expected}");
        }
    }

    #[test]
    fn rounding_is_counted() {
        let decimals = Decimals::new(true);
        let mesh =
            super::read("m.off", b"OFF 1 0 0\n0.1000000000000000001 0.5 0.3000000000000000001\n".into(), &decimals)
                .unwrap();
        assert_eq!((mesh.points[0], decimals.rounded()), ([0.1, 0.5, 0.3], 2));
    }

    fn finite() -> impl Strategy<Value = f64> {
        any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(64, 256)))]

        #[test]
        fn every_bit_comes_back(points in prop::collection::vec(prop::array::uniform3(finite()), 1..9), hex: bool) {
            let number = |x: &f64| if hex { hexfloat::format(*x) } else { format!("{x:.1074}") };
            let row = |point: &[f64; 3]| point.iter().map(number).collect::<Vec<_>>().join(" ");
            let rows: Vec<String> = points.iter().map(row).collect();
            let off = read("m.off", &format!("OFF {} 0 0\n{}\n", points.len(), rows.join("\n"))).unwrap();
            let obj = read("m.obj", &format!("v {}\n", rows.join("\nv "))).unwrap();
            let header = "format ascii 1.0\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
            let header = header.replacen('\n', &format!("\nelement vertex {}\n", points.len()), 1);
            let ply = read("m.ply", &format!("ply\n{header}{}\n", rows.join("\n"))).unwrap();
            let bits = |points: &[[f64; 3]]| points.as_flattened().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            for mesh in [off, obj, ply] {
                prop_assert_eq!(bits(&mesh.points), bits(&points));
            }
        }
    }

    proptest! {
        #[test]
        fn no_text_panics(text in "(OFF|v|f|ply)?[0-9 .\n/ vfl#-]{0,60}|\\PC{0,30}") {
            for file in ["m.off", "m.obj", "m.ply", "m.stl"] {
                let _ = read(file, &text);
            }
        }
    }
}
