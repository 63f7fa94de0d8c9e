//! Readers of data files: any bytes are read or refused with a one-line error, never with a panic.
//!
//! The first byte chooses the format and whether decimals are rounded; the others are the file. For binary PLY and STL
//! they are the part after a header, since random bytes would hardly ever form a header.

use predicament_formats::{
    Columns, CorpusError, Decimals, Manifest, Position, fmt_csv, geometry, mesh, points, recognised_columns, topojson,
};

/// The formats, as the ends of file names.
const NAMES: [&str; 12] = [
    "a.csv",
    "a.geojson",
    "a.wkt",
    "a.off",
    "a.obj",
    "a.ply",
    "a.stl",
    "a.csv.gz",
    "a.topojson",
    "little.ply",
    "big.ply",
    "binary.stl",
];

/// The file that bytes encode.
fn file(name: &str, bytes: &[u8]) -> Vec<u8> {
    let header = |encoding: &str| {
        format!(
            "ply\nformat {encoding} 1.0\nelement vertex 3\nproperty char x\nproperty short y\nproperty float z\n\
             element face 2\nproperty list char short vertex_index\nend_header\n"
        )
        .into_bytes()
    };
    let mut file = match name {
        "little.ply" => header("binary_little_endian"),
        "big.ply" => header("binary_big_endian"),
        "binary.stl" => {
            let triangles = u32::try_from(bytes.len() / 50).unwrap_or(u32::MAX);
            [&[b' '; 80][..], &triangles.to_le_bytes()].concat()
        }
        _ => Vec::new(),
    };
    file.extend(bytes);
    file
}

/// Reads bytes as the file of some format, in every way that tasks use.
///
/// # Panics
/// If an error is not a single line or has no position in the file, if a part of a mesh has no position, if a rewritten
/// file is rewritten again, or if it reads differently.
pub fn check(bytes: &[u8]) {
    let Some((&head, bytes)) = bytes.split_first() else { return };
    let name = NAMES[usize::from(head >> 1) % NAMES.len()];
    let file = file(name, bytes);
    let bytes = file.as_slice();
    let decimals = || Decimals::new(head & 1 == 1);
    if name == "a.topojson" {
        if let Ok(text) = std::str::from_utf8(bytes) {
            one_line(topojson::read(name, text, "o", &decimals()));
            one_line(Manifest::parse(name, text));
        }
        return;
    }
    one_line(points::read(name, bytes.to_vec(), &decimals()));
    // What a header names without doubt is there.
    if let Some(found) = one_line(recognised_columns(name, bytes.to_vec())).flatten()
        && let Some(why) = points::read_columns(name, bytes.to_vec(), Some(&found.columns), &decimals()).err()
    {
        assert!(!why.message.contains("there is no column"), "{why}");
    }
    if let Some(geometry) = one_line(geometry::read(name, bytes.to_vec(), &decimals())) {
        one_line(geometry.segments());
        let _ = geometry.edges();
        one_line(geometry.map());
    }
    check_mesh(name, bytes, &decimals());
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if name == "a.csv" {
        check_rewritten(name, text, None);
        for columns in ["2,1", "y,x", "1,3,2"] {
            check_rewritten(name, text, Columns::parse(columns).as_ref().ok());
        }
    }
}

/// Rewrites decimals of a CSV file: a second time changes nothing, and the new file is read as the old one with its
/// decimals rounded.
fn check_rewritten(name: &str, text: &str, columns: Option<&Columns>) {
    let Some(tidy) = one_line(fmt_csv(name, text, columns)) else { return };
    assert_eq!(fmt_csv(name, &tidy, columns).as_ref(), Ok(&tidy), "rewritten twice");
    let again = points::read_columns(name, tidy.into_bytes(), columns, &Decimals::new(false));
    let rounded = points::read_columns(name, text.into(), columns, &Decimals::new(true));
    let bits = |points: points::ImportedPoints| points.coordinates.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(again.ok().map(bits), rounded.ok().map(bits), "rewritten is rounded");
}

/// Reads a mesh: every error, every point and every face has a position inside the file.
fn check_mesh(name: &str, bytes: &[u8], decimals: &Decimals) {
    let lines = 1 + bytes.iter().filter(|byte| matches!(byte, b'\n' | b'\r')).count();
    let is_there = |position: Position| match position {
        Position::Line(line) => (1..=lines).contains(&line),
        Position::Byte(byte) => byte <= bytes.len(),
    };
    let read = mesh::read(name, bytes.to_vec(), decimals);
    if let Err(why) = &read {
        let is_packed = name.ends_with(".gz");
        assert!(is_packed || why.position.is_none_or(is_there), "{why}: {lines} lines, {} bytes", bytes.len());
    }
    let Some(mesh) = one_line(read) else { return };
    let points = (0..mesh.points.len()).map(|point| mesh.places.point(point));
    let faces = (0..mesh.faces.len()).map(|face| mesh.places.face(face));
    assert!(points.chain(faces).all(|place| place.is_some_and(is_there)), "{name}: {:?}", mesh.places);
    assert_eq!(mesh.places.point(mesh.points.len()).or(mesh.places.face(mesh.faces.len())), None, "{name}");
}

/// The value that was read, if any; an error must be one line.
fn one_line<T>(result: Result<T, CorpusError>) -> Option<T> {
    match result {
        Ok(read) => Some(read),
        Err(error) => {
            let line = error.to_string();
            assert!(!line.contains(['\n', '\r']), "{line:?}");
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::bytes;

    #[test]
    fn random_bytes_are_refused_in_one_line() {
        for run in 0..4000 {
            check(&bytes(run));
        }
    }

    /// Files with a decimal that no double is printed as.
    const FILES: [&str; 7] = [
        "x,y\n0.1000000000000000001,2\n\"3\",0x1p0\n",
        r#"{"type": "LineString", "coordinates": [[0.1000000000000000001, 0], [1, 1]]}"#,
        "POLYGON ((0 0, 1 0, 0 1.1000000000000000001, 0 0))",
        "OFF 3 1 0\n0 0 0\n1 0 0\n0 1.1000000000000000001 0\n3 0 1 2\n",
        "v 0 0 0.1000000000000000001\n",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0.1000000000000000001\n",
        "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1.1000000000000000001 0\nendloop\nendfacet\nendsolid\n",
    ];

    #[test]
    fn files_of_each_format_are_read() {
        for (at, text) in FILES.into_iter().enumerate() {
            for round in [0, 1] {
                let head = 2 * u8::try_from(at).expect("twelve formats") + round;
                check(&[&[head], text.as_bytes()].concat());
                // The first half of the same file.
                check(&[&[head], &text.as_bytes()[..text.len() / 2]].concat());
                let read = points::read(NAMES[at], text.into(), &Decimals::new(round == 1));
                assert_eq!(read.is_ok(), round == 1, "{}: {read:?}", NAMES[at]);
            }
        }
    }

    /// A mesh of three points and two faces behind each header, complete and changed.
    #[test]
    fn binary_files_are_read() {
        let places = [[0_i8, 0], [1, 0], [0, 1]];
        for (at, name) in NAMES.into_iter().enumerate().filter(|(_, name)| name.starts_with(['l', 'b'])) {
            let is_big = name == "big.ply";
            let short = |x: i16| if is_big { x.to_be_bytes() } else { x.to_le_bytes() };
            let mut body = Vec::new();
            if name == "binary.stl" {
                let corners = places.map(|[x, y]| [f32::from(x), f32::from(y), 0.0]);
                for corners in [corners, [corners[1], corners[0], corners[2]]] {
                    body.extend([0; 12]);
                    body.extend(corners.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
                    body.extend([0; 2]);
                }
            } else {
                for [x, y] in places {
                    body.extend(x.to_le_bytes());
                    body.extend(short(y.into()));
                    body.extend([0; 4]);
                }
                for face in [[0, 1, 2], [1, 0, 2]] {
                    body.push(3);
                    body.extend(face.into_iter().flat_map(short));
                }
            }
            let read = mesh::read(name, file(name, &body), &Decimals::new(false)).expect(name);
            assert_eq!((read.points.len(), read.faces.len()), (3, 2), "{name}");
            let head = 2 * u8::try_from(at).expect("twelve formats");
            for run in 0..2000_u64 {
                let random = bytes(run);
                let mut body = body.clone();
                for change in random.chunks_exact(3).take(usize::from(random[0] % 4)) {
                    let place = usize::from(change[0]) % body.len();
                    match change[1] % 8 {
                        0 => body.truncate(place.max(1)),
                        1 => body.push(change[2]),
                        _ => body[place] = change[2],
                    }
                }
                check(&[&[head], body.as_slice()].concat());
            }
        }
    }

    /// Each file with a few of its bytes changed, left out, or taken from another file.
    #[test]
    fn changed_files_are_read_or_refused() {
        for (at, text) in FILES.into_iter().enumerate() {
            for run in 0..2000_u64 {
                let random = bytes(run);
                let mut file = text.as_bytes().to_vec();
                for change in random.chunks_exact(4).take(1 + usize::from(random[0] % 4)) {
                    let place = usize::from(change[0]) * 256 + usize::from(change[1]);
                    let place = place % (file.len() + 1);
                    let other = FILES[usize::from(change[2]) % FILES.len()].as_bytes();
                    match change[3] % 4 {
                        0 => file.insert(place, change[2]),
                        1 => drop(file.drain(place..file.len().min(place + usize::from(change[2] % 8)))),
                        2 => drop(
                            file.splice(place..place, other[..other.len().min(usize::from(change[1] % 32))].to_vec()),
                        ),
                        _ => file.truncate(place.max(1)),
                    }
                }
                let head = 2 * u8::try_from(at).expect("twelve formats") + u8::from(run % 2 == 0);
                check(&[&[head], file.as_slice()].concat());
            }
        }
    }
}
