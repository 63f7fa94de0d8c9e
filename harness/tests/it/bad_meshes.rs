//! Bad mesh files of every format give one line with the file, the line or byte, and the cure, and exit code 104.

use crate::common::{at, expect, write};
use tempfile::{TempDir, tempdir};

#[derive(Clone, Copy, PartialEq, Debug)]
enum Format {
    Off,
    Obj,
    PlyText,
    PlyBinary,
    StlText,
    StlBinary,
}

use Format::{Obj, Off, PlyBinary, PlyText, StlBinary, StlText};

const ALL: [Format; 6] = [Off, Obj, PlyText, PlyBinary, StlText, StlBinary];
/// The formats that list points, which faces refer to by index.
const INDEXED: [Format; 4] = [Off, Obj, PlyText, PlyBinary];

/// A mesh: points, and faces as indices of points, from 0.
#[derive(Clone)]
struct Mesh {
    points: Vec<[f32; 3]>,
    faces: Vec<Vec<usize>>,
}

/// A mesh file, with the places of its parts.
struct File {
    name: &'static str,
    bytes: Vec<u8>,
    points: Vec<String>,
    faces: Vec<String>,
    /// The index of each point after reading, because STL files do not list points.
    numbers: Vec<usize>,
}

impl File {
    fn face(&self, face: usize) -> String {
        format!("{face} ({})", self.faces[face])
    }

    fn point(&self, point: usize) -> String {
        format!("{} ({})", self.numbers[point], self.points[point])
    }

    /// The prefix of a message about a place.
    fn place(&self, place: &str) -> String {
        match place.strip_prefix("line ") {
            Some(line) => format!("{}:{line}: ", self.name),
            None => format!("{}: at {place}: ", self.name),
        }
    }

    fn at_face(&self, face: usize) -> String {
        self.place(&self.faces[face])
    }

    fn at_point(&self, point: usize) -> String {
        self.place(&self.points[point])
    }
}

fn file(format: Format, mesh: &Mesh) -> File {
    let name = match format {
        Off => "m.off",
        Obj => "m.obj",
        PlyText | PlyBinary => "m.ply",
        StlText | StlBinary => "m.stl",
    };
    let numbers = (0..mesh.points.len()).collect();
    let mut file = File { name, bytes: Vec::new(), points: Vec::new(), faces: Vec::new(), numbers };
    let [points, faces] = [mesh.points.len(), mesh.faces.len()];
    let encoding = if format == PlyText { "ascii" } else { "binary_big_endian" };
    let head = match format {
        Off => format!("OFF\n{points} {faces} 0\n"),
        PlyText | PlyBinary => format!(
            "ply\nformat {encoding} 1.0\nelement vertex {points}\nproperty float x\nproperty float y\nproperty float z\n\
             element face {faces}\nproperty list uchar int vertex_indices\nend_header\n"
        ),
        Obj | StlText | StlBinary => String::new(),
    };
    file.bytes.extend(head.bytes());
    if matches!(format, StlText | StlBinary) {
        stl(format == StlText, mesh, &mut file);
        return file;
    }
    let here = |bytes: &[u8]| match format {
        PlyBinary => format!("byte {}", bytes.len()),
        _ => format!("line {}", 1 + bytes.iter().filter(|&&byte| byte == b'\n').count()),
    };
    let listed = |numbers: Vec<String>| numbers.join(" ") + "\n";
    for point in &mesh.points {
        file.points.push(here(&file.bytes));
        let text = listed(point.iter().map(ToString::to_string).collect());
        match format {
            PlyBinary => file.bytes.extend(point.iter().flat_map(|x| x.to_be_bytes())),
            Obj => file.bytes.extend(format!("v {text}").bytes()),
            _ => file.bytes.extend(text.bytes()),
        }
    }
    for face in &mesh.faces {
        file.faces.push(here(&file.bytes));
        let from = usize::from(format == Obj);
        let text = listed(face.iter().map(|corner| (corner + from).to_string()).collect());
        match format {
            PlyBinary => {
                file.bytes.push(u8::try_from(face.len()).unwrap());
                file.bytes.extend(face.iter().flat_map(|&corner| u32::try_from(corner).unwrap().to_be_bytes()));
            }
            Obj => file.bytes.extend(format!("f {text}").bytes()),
            _ => file.bytes.extend(format!("{} {text}", face.len()).bytes()),
        }
    }
    file
}

/// Writes the triangles after one that is dropped because its corners coincide, so that the indices of faces differ
/// from those in the file.
fn stl(is_text: bool, mesh: &Mesh, file: &mut File) {
    let first = mesh.faces[0][0];
    let dropped = vec![first, first, first];
    if is_text {
        file.bytes.extend(b"solid x\n");
    } else {
        file.bytes.resize(80, b' ');
        file.bytes.extend(u32::try_from(mesh.faces.len() + 1).unwrap().to_le_bytes());
    }
    file.points = vec![String::new(); mesh.points.len()];
    let mut read = 0;
    for (index, face) in std::iter::once(&dropped).chain(&mesh.faces).enumerate() {
        let line = 2 + index * 7;
        let byte = 84 + index * 50;
        if index > 0 {
            file.faces.push(if is_text { format!("line {line}") } else { format!("byte {byte}") });
        }
        for (corner, &point) in face.iter().enumerate() {
            if file.points[point].is_empty() {
                let [line, byte] = [line + 2 + corner, byte + 12 + 12 * corner];
                file.points[point] = if is_text { format!("line {line}") } else { format!("byte {byte}") };
                file.numbers[point] = read;
                read += 1;
            }
        }
        let corners = face.iter().map(|&point| mesh.points[point]);
        if is_text {
            let corners: String = corners.map(|[x, y, z]| format!("vertex {x} {y} {z}\n")).collect();
            file.bytes.extend(format!("facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n").bytes());
        } else {
            let numbers = std::iter::once([0.0; 3]).chain(corners);
            file.bytes.extend(numbers.flatten().flat_map(f32::to_le_bytes));
            file.bytes.extend([0, 0]);
        }
    }
    if is_text {
        file.bytes.extend(b"endsolid x\n");
    }
}

fn tetrahedron() -> Mesh {
    Mesh {
        points: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]],
        faces: vec![vec![0, 2, 1], vec![0, 1, 3], vec![1, 2, 3], vec![2, 0, 3]],
    }
}

/// The tetrahedron with another last face.
fn with_last(face: &[usize]) -> Mesh {
    let mut mesh = tetrahedron();
    mesh.faces[3] = face.to_vec();
    mesh
}

/// The tetrahedron with more points and another face.
fn with_more(points: &[[f32; 3]], face: &[usize]) -> Mesh {
    let mut mesh = tetrahedron();
    mesh.points.extend(points);
    mesh.faces.push(face.to_vec());
    mesh
}

/// Asserts that a task on the file refuses it and, for one format, that a suite with the file does too.
fn refused(folder: &TempDir, format: Format, file: &File, what: &str, expected: &str) {
    let what = format!("{what} in {format:?}");
    let path = at(folder, file.name);
    std::fs::write(&path, &file.bytes).unwrap();
    let out = at(folder, "out");
    let line = |told: &str| {
        assert_eq!(told.lines().count(), 1, "{what}: {told}");
        told.trim_end().replace(&format!("{}/", folder.path().display()), "")
    };
    let told = expect(104, &["solve", "slice", &path, "-b", "exact", "--set", "closed=true", "--out", &out]);
    let said = line(&told.stderr);
    assert!(said.starts_with(&format!("predicament: {expected}")), "{what}: {said}\n  expected {expected}");
    assert!(!folder.path().join("out").exists(), "{what}: nothing is written");
    if format != StlBinary {
        return;
    }
    let suite = format!(
        "title = \"t\"\n[[scene]]\nname = \"a\"\ntask = \"slice\"\nmesh = {{ path = \"{}\" }}\nclosed = true\n",
        file.name
    );
    let suite = write(folder, "s.toml", &suite);
    assert_eq!(line(&expect(104, &["run", &suite, "--out", &out]).stderr), said, "{what}");
}

/// Tries each kind of bad surface in each format that can hold it.
#[test]
fn surfaces_that_are_none_are_refused_where_they_are_written() {
    type Said = fn(&File) -> String;
    let kinds: [(&str, &[Format], Mesh, Said); 7] = [
        ("flipped", &ALL, with_last(&[0, 2, 3]), |file| {
            let [a, b] = [0, 2].map(|point| file.point(point));
            let rest = format!("faces {} and 3 both go from vertex {a} to vertex {b}; reverse", file.face(0));
            file.at_face(3) + &rest
        }),
        ("three faces", &ALL, with_more(&[[5.0; 3]], &[0, 1, 4]), |file| {
            let mut ends = [0, 1].map(|point| (file.numbers[point], file.point(point)));
            ends.sort_unstable();
            let [(_, a), (_, b)] = ends;
            let [i, j] = [0, 1].map(|face| file.face(face));
            file.at_face(4)
                + &format!(
                    "the edge of vertices {a} and {b} has more than two faces, {i}, {j} and 4 among them; remove"
                )
        }),
        ("open", &ALL, Mesh { faces: tetrahedron().faces[..3].to_vec(), ..tetrahedron() }, |file| {
            let [a, b] = [0, 2].map(|point| file.point(point));
            file.at_face(0) + &format!("the edge of vertices {a} and {b} has a face on one side only; close the mesh")
        }),
        ("fans", &ALL, with_more(&[[9.0; 3], [9.0, 8.0, 7.0]], &[0, 4, 5]), |file| {
            file.at_point(0) + "faces close around vertex 0, and it has more faces; give these"
        }),
        ("no area", &ALL, with_more(&[[9.0, 0.0, 0.0], [10.0, 0.0, 0.0], [12.0, 0.0, 0.0]], &[4, 5, 6]), |file| {
            file.at_face(4) + "face 4 has no area; remove it"
        }),
        (
            "not plane",
            &INDEXED,
            with_more(&[[9.0, 0.0, 0.0], [9.0, 1.0, 0.0], [8.0, 1.0, 0.0], [8.0, 0.0, 1.0]], &[4, 5, 6, 7]),
            |file| {
                let [off, a, b, c] = [7, 4, 5, 6].map(|point| file.point(point));
                file.at_face(4)
                    + &format!("face 4 is not planar: vertex {off} is not in the plane of {a}, {b} and {c}; divide it")
            },
        ),
        ("no faces", &INDEXED, Mesh { faces: Vec::new(), ..tetrahedron() }, |file| {
            format!("{}: a mesh without faces; give it faces", file.name)
        }),
    ];
    let folder = tempdir().unwrap();
    for (what, formats, mesh, said) in kinds {
        for &format in formats {
            let file = file(format, &mesh);
            refused(&folder, format, &file, what, &said(&file));
        }
    }
}

/// Tries each kind of wrong or truncated file in each format where it is possible.
#[test]
fn files_that_are_none_are_refused_where_they_are_wrong() {
    let folder = tempdir().unwrap();
    let refuse = |what: &str, format: Format, file: &File, expected: String| {
        refused(&folder, format, file, what, &expected);
    };
    let of_face = |format: Format| if matches!(format, PlyText | PlyBinary) { "face 3: " } else { "" };
    for format in INDEXED {
        let unknown = file(format, &with_last(&[2, 0, 9]));
        let (index, owner) =
            (9 + usize::from(format == Obj), if of_face(format).is_empty() { "" } else { " of face 3" });
        let said = format!("`{index}`{owner} is not one of the 4 vertices; indices count from");
        refuse("an unknown vertex", format, &unknown, unknown.at_face(3) + &said);
        let repeated = file(format, &with_last(&[2, 0, 2]));
        let said = format!("{}a face that names a vertex twice; divide it", of_face(format));
        refuse("a repeated vertex", format, &repeated, repeated.at_face(3) + &said);
        let short = file(format, &with_last(&[2, 0]));
        let said = format!("{}a face of 2 corners; give it three", of_face(format));
        refuse("two corners", format, &short, short.at_face(3) + &said);
    }
    let mut mesh = tetrahedron();
    mesh.points[3][1] = f32::NAN;
    for format in ALL {
        let said = match format {
            PlyBinary => "vertex 3 is not finite: (0, NaN, 4); remove the vertex",
            StlBinary => "triangle 2 has a corner that is not finite; remove the triangle",
            _ => "coordinate `NaN` is not finite; remove",
        };
        let file = file(format, &mesh);
        refuse("not a number", format, &file, file.at_point(3) + said);
    }
    for format in ALL {
        let mut short = file(format, &tetrahedron());
        // Cut inside the last face; in a text format, cut its last character and line end.
        let (cut, place, said) = match format {
            Off => (2, &short.faces[3], "a face is the number of its corners, then the corners; give"),
            Obj => (2, &short.faces[3], "a face of 2 corners; give it three"),
            PlyText => (2, &short.faces[3], "the line ends before `vertex_indices`; write"),
            PlyBinary => (2, &short.faces[3], "the file ends after 3 of its 4 elements `face`; correct the counts or"),
            StlText => (20, &"line 35".to_owned(), "the file ends before `endsolid`; fetch or copy it again"),
            StlBinary => (2, &"byte 80".to_owned(), "a binary file of 332 bytes, and its 5 triangles take 334; fetch"),
        };
        let expected = short.place(place) + said;
        short.bytes.truncate(short.bytes.len() - cut);
        refuse("the end cut off", format, &short, expected);
    }
    for (format, from, to, expected) in [
        (Off, "4 4 0", "4 5 0", "m.off:10: the file ends after 4 of its 5 faces; correct"),
        (Off, "4 4 0", "5 3 0", "m.off:7: a vertex of 4 numbers, and the first has 3; correct the counts"),
        (Off, "4 4 0", "4 3 0", "m.off:10: there is extra text after the 3 faces; correct"),
        (PlyText, "face 4", "face 5", "m.ply:17: the file ends after 4 of its 5 elements `face`; correct"),
        (
            PlyText,
            "face 4",
            "face 3",
            "m.ply:17: there is extra text after the elements that the header counts; \
                   correct",
        ),
        (PlyText, "vertex 4", "vertex 4000", "m.ply:3: 4000 elements `vertex` don't fit into"),
    ] {
        let mut wrong = file(format, &tetrahedron());
        let text = String::from_utf8(wrong.bytes).unwrap();
        assert!(text.contains(from));
        wrong.bytes = text.replacen(from, to, 1).into_bytes();
        refuse(&format!("{to} for {from}"), format, &wrong, expected.to_owned());
    }
    for (format, at, byte, expected) in [
        (PlyBinary, 114, b'5', "m.ply: at byte 266: the file ends after 4 of its 5 elements `face`; correct"),
        (PlyBinary, 114, b'3', "m.ply: at byte 253: 13 bytes follow the elements that the header counts; correct"),
        (StlBinary, 80, 6, "m.stl: at byte 80: a binary file of 334 bytes, and its 6 triangles take 384; fetch"),
    ] {
        let mut wrong = file(format, &tetrahedron());
        wrong.bytes[at] = byte;
        refuse("another count", format, &wrong, expected.to_owned());
    }
}

/// Tries surfaces without an inside, because their regions are not closed, in each format.
#[test]
fn open_and_turned_surfaces_have_no_regions() {
    let folder = tempdir().unwrap();
    let open = Mesh { faces: tetrahedron().faces[..3].to_vec(), ..tetrahedron() };
    for (what, mesh, count) in [("open", open, 1), ("turned", with_last(&[0, 2, 3]), 2)] {
        for format in ALL {
            let file = file(format, &mesh);
            let path = at(&folder, file.name);
            std::fs::write(&path, &file.bytes).unwrap();
            let told = expect(104, &["solve", "mesh-locate", &path, "--out", &at(&folder, "out")]);
            let said = told.stderr.trim_end().replace(&format!("{}/", folder.path().display()), "");
            let [a, b] = [0, 2].map(|point| file.point(point));
            let expected = format!(
                "predicament: {}region 0 is not closed at the edge of vertices {a} and {b}: its {count} triangle(s) there, such as {}, do not use the edge equally often in both directions; close the mesh, turn the triangle over, or give each face its `regions`",
                file.at_face(0),
                file.face(0)
            );
            assert_eq!(said, expected, "{what} in {format:?}");
        }
    }
}

/// A good mesh is read; otherwise the tests above would prove nothing.
#[test]
fn the_tetrahedron_is_read_from_every_format() {
    let folder = tempdir().unwrap();
    for format in ALL {
        let file = file(format, &tetrahedron());
        let path = at(&folder, file.name);
        std::fs::write(&path, &file.bytes).unwrap();
        let out = at(&folder, &format!("{format:?}"));
        expect(0, &["solve", "slice", &path, "-b", "exact", "--set", "closed=true", "--out", &out]);
    }
}
