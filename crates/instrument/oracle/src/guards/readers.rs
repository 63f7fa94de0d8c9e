//! Guards of the file readers, which read files with known contents, written here by a few lines that share nothing
//! with the readers.

use predicament_corpus::{Canon, Content, content_id};
use predicament_formats::{Decimals, geometry, mesh, points, read_coordinate};
use predicament_predicates::Scene;

use super::{Facts, Guard, Guarded, Held};
use crate::faults::Area;

/// Rows of coordinates.
type Points = Vec<Vec<f64>>;
/// Faces, as the coordinates of their corners.
type Faces = Vec<Vec<[f64; 3]>>;
/// Rings and lines, as the coordinates of their points.
type Chains = Vec<Vec<[f64; 2]>>;

/// The functions that read files: each is the real function, unless a fault replaces it. `None` means a refused file.
pub(super) trait Reading {
    /// Reads a coordinate.
    fn coordinate(&self, text: &str) -> Option<f64> {
        read_coordinate(text).ok()
    }

    /// Reads the points of a file.
    fn points(&self, file: &str, bytes: &[u8]) -> Option<Points> {
        let read = points::read(file, bytes.to_vec(), &Decimals::new(false)).ok()?;
        Some(read.coordinates.chunks(read.dimension.count()).map(<[f64]>::to_vec).collect())
    }

    /// Reads the faces of a mesh.
    fn faces(&self, file: &str, bytes: &[u8]) -> Option<Faces> {
        let read = mesh::read(file, bytes.to_vec(), &Decimals::new(false)).ok()?;
        let corner = |&v: &u32| read.points.get(v as usize).copied();
        read.faces.iter().map(|face| face.iter().map(corner).collect()).collect()
    }

    /// Reads the rings of all polygons.
    fn rings(&self, file: &str, bytes: &[u8]) -> Option<Chains> {
        let read = geometry::read(file, bytes.to_vec(), &Decimals::new(false)).ok()?;
        let shapes = read.features.into_iter().flat_map(|feature| feature.shapes);
        let rings = shapes.filter_map(|shape| match shape {
            geometry::Shape::Polygon(rings) => Some(rings),
            _ => None,
        });
        Some(rings.flatten().map(|ring| ring.iter().map(|position| position.at).collect()).collect())
    }

    /// Reads the ends of all segments of lines.
    fn segments(&self, file: &str, bytes: &[u8]) -> Option<Chains> {
        let read = geometry::read(file, bytes.to_vec(), &Decimals::new(false)).ok()?.edges();
        let ends = |edge: &[predicament_predicates::Vertex; 2]| edge.map(|v| read.points[v.index()]).to_vec();
        Some(read.edges.iter().map(ends).collect())
    }

    /// The id of a scene with these points and no questions.
    fn id(&self, points: &[[f64; 2]]) -> Option<String> {
        Some(content_id(&Scene::from_points2(points).ok()?, &Nothing))
    }
}

/// A content without questions.
#[derive(Debug)]
struct Nothing;

impl Content for Nothing {
    fn count(&self) -> usize {
        0
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("nothing");
    }
}

/// The real functions, without a fault.
pub(super) struct Real;

impl Reading for Real {}

/// The guards of the readers.
pub const GUARDS: &[Guard] = &[
    guard("hex floats", "a double written digit by digit from its bits is read back unchanged"),
    guard("decimals", "a decimal is read if a double prints as it, and refused otherwise"),
    guard("written points", "points written as CSV are all read back, with each coordinate in its place"),
    guard("written meshes", "faces written as OFF, OBJ, PLY and STL, in ASCII and binary, keep their corners"),
    guard("written rings", "rings written as GeoJSON and WKT keep their corners, each once"),
    guard("written lines", "lines written as GeoJSON and WKT keep their segments, without segments between lines"),
    guard(
        "content ids",
        "the id of a known scene is the same in every version; it changes with a bit or the order; -0 counts as 0",
    ),
];

const fn guard(name: &'static str, means: &'static str) -> Guard {
    Guard { area: Area::Readers, name, means }
}

/// The result of each guard.
pub(super) fn held(reading: &dyn Reading) -> Vec<Held> {
    let guards: [fn(&dyn Reading, &mut Facts); 7] = [hex_floats, decimals, csv, meshes, rings, lines, ids];
    let held = |(guard, look): (&Guard, fn(&dyn Reading, &mut Facts))| {
        let mut facts = Facts::default();
        look(reading, &mut facts);
        facts.held(guard.name)
    };
    GUARDS.iter().zip(guards).map(held).collect()
}

/// Doubles of all kinds.
const DOUBLES: [f64; 10] = [
    0.0,
    1.0,
    -1.5,
    0.1,
    -0.1,
    f64::MAX,
    -f64::MIN_POSITIVE,
    f64::from_bits(1),
    f64::from_bits(0x800f_ffff_ffff_ffff),
    12_345.678_901_234_567,
];

/// The text of a double as C's `%a`, from its bits.
fn hex(x: f64) -> String {
    let bits = x.to_bits();
    let minus = if bits >> 63 == 1 { "-" } else { "" };
    let (exponent, fraction) = (bits >> 52 & 0x7ff, bits & ((1 << 52) - 1));
    match exponent {
        0 if fraction == 0 => format!("{minus}0x0p+0"),
        0 => format!("{minus}0x0.{fraction:013x}p-1022"),
        _ => format!("{minus}0x1.{fraction:013x}p{:+}", i128::from(exponent) - 1023),
    }
}

fn hex_floats(reading: &dyn Reading, facts: &mut Facts) {
    for x in DOUBLES {
        let text = hex(x);
        let got = reading.coordinate(&text);
        facts.hold(got.is_some_and(|got| got.to_bits() == x.to_bits()), || format!("{text} is read as {got:?}"));
    }
    for text in ["0x1.00000000000001p+0", "0x1p+1024", "0x1p-1075", "0x", "1.8p+1"] {
        let got = reading.coordinate(text);
        facts.hold(got.is_none(), || format!("{text}, which is not a double, is read as {got:?}"));
    }
}

fn decimals(reading: &dyn Reading, facts: &mut Facts) {
    for (text, bits) in [
        ("0", 0),
        ("0.5", 0x3fe0_0000_0000_0000),
        ("-2.25e1", 0xc036_8000_0000_0000),
        ("0.1000000000000000055511151231257827021181583404541015625", 0x3fb9_9999_9999_999a_u64),
        ("9007199254740991", 0x433f_ffff_ffff_ffff),
        ("16777217", 0x4170_0000_1000_0000),
        ("0.1", 0x3fb9_9999_9999_999a),
        ("0.10000000000000001", 0x3fb9_9999_9999_999a),
        ("-5e-324", 0x8000_0000_0000_0001),
        // 2^-44: its shortest identifying decimal is not the nearest decimal of 16 digits.
        ("5.684341886080802e-14", 0x3d30_0000_0000_0000),
    ] {
        let got = reading.coordinate(text);
        facts.hold(got.is_some_and(|got| got.to_bits() == bits), || format!("{text} is read as {got:?}"));
    }
    for text in [
        "0.1000000000000000001",
        "0.10000000000000004",
        "9007199254740993",
        "1e400",
        "1e-400",
        "",
        "1,5",
        "0.1f",
        "nan",
        "inf",
    ] {
        let got = reading.coordinate(text);
        facts.hold(got.is_none(), || format!("{text}, which is not a double, is read as {got:?}"));
    }
}

/// Points whose coordinates are all different.
fn known<const D: usize>(count: u32) -> Vec<[f64; D]> {
    let coordinate = |at: u32, axis: usize| {
        let axis = u32::try_from(axis).unwrap_or(0);
        f64::from(10 * at + axis) + f64::from(axis + 1) / 4.0
    };
    (0..count).map(|at| std::array::from_fn(|axis| coordinate(at, axis))).collect()
}

fn csv(reading: &dyn Reading, facts: &mut Facts) {
    fn text<const D: usize>(points: &[[f64; D]]) -> String {
        points.iter().map(|point| point.map(hex).join(",") + "\n").collect()
    }
    for count in [1, 2, 7] {
        let (flat, solid) = (known::<2>(count), known::<3>(count));
        for (text, points) in [
            (text(&flat), flat.iter().map(|point| point.to_vec()).collect::<Points>()),
            (text(&solid), solid.iter().map(|point| point.to_vec()).collect()),
        ] {
            let got = reading.points("written.csv", text.as_bytes());
            facts.hold(got.as_ref() == Some(&points), || format!("{points:?} are read as {got:?}"));
        }
    }
}

/// The faces of a tetrahedron, with coordinates that are all singles, for STL.
fn tetrahedron() -> (Vec<[f64; 3]>, [[usize; 3]; 4]) {
    (known::<3>(4), [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
}

fn meshes(reading: &dyn Reading, facts: &mut Facts) {
    let (points, faces) = tetrahedron();
    let corners: Faces = faces.iter().map(|face| face.map(|v| points[v]).to_vec()).collect();
    let lines = |before: &str| -> String { points.iter().map(|[x, y, z]| format!("{before}{x} {y} {z}\n")).collect() };
    let listed = |before: &str, from: usize| -> String {
        faces.iter().map(|face| format!("{before}{}\n", face.map(|v| (v + from).to_string()).join(" "))).collect()
    };
    let off = format!("OFF\n4 4 0\n{}{}", lines(""), listed("3 ", 0));
    let obj = format!("{}{}", lines("v "), listed("f ", 1));
    let head = "element vertex 4\nproperty double x\nproperty double y\nproperty double z\n\
                element face 4\nproperty list uchar int vertex_indices\nend_header\n";
    let ply = format!("ply\nformat ascii 1.0\n{head}{}{}", lines(""), listed("3 ", 0));
    let mut binary_ply = format!("ply\nformat binary_little_endian 1.0\n{head}").into_bytes();
    points.as_flattened().iter().for_each(|x| binary_ply.extend(x.to_le_bytes()));
    for face in faces {
        binary_ply.push(3);
        face.iter().for_each(|&v| binary_ply.extend(i32::try_from(v).unwrap_or(0).to_le_bytes()));
    }
    let facet = |face: &[usize; 3]| -> String {
        let corner = |&v: &usize| format!("vertex {} {} {}\n", points[v][0], points[v][1], points[v][2]);
        format!("facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n", face.iter().map(corner).collect::<String>())
    };
    let stl = format!("solid known\n{}endsolid known\n", faces.iter().map(facet).collect::<String>());
    let files = [
        ("known.off", off.into_bytes()),
        ("known.obj", obj.into_bytes()),
        ("known.ply", ply.into_bytes()),
        ("known.ply", binary_ply),
        ("known.stl", stl.into_bytes()),
        ("known.stl", binary_stl(&points, &faces)),
    ];
    for (file, bytes) in files {
        let got = reading.faces(file, &bytes);
        facts.hold(got.as_ref() == Some(&corners), || format!("{file}: {corners:?} are read as {got:?}"));
    }
}

/// Binary STL: a header of 80 bytes, the number of triangles, and each triangle with its normal and two more bytes;
/// little-endian.
fn binary_stl(points: &[[f64; 3]], faces: &[[usize; 3]]) -> Vec<u8> {
    // All coordinates are singles.
    #[allow(clippy::cast_possible_truncation)]
    let single = |x: f64| x as f32;
    let mut bytes = vec![0; STL_HEAD];
    bytes.extend(u32::try_from(faces.len()).unwrap_or(0).to_le_bytes());
    for face in faces {
        bytes.extend([0; 12]);
        face.iter().flat_map(|&v| points[v]).for_each(|x| bytes.extend(single(x).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

const STL_HEAD: usize = 80;

/// An outer ring with a hole, and a triangle.
fn known_rings() -> [Vec<Vec<[f64; 2]>>; 2] {
    [
        vec![vec![[0.0, 0.0], [9.0, 0.5], [8.0, 7.0], [1.0, 8.0]], vec![[2.0, 2.0], [3.0, 5.0], [4.0, 2.5]]],
        vec![vec![[20.0, 0.0], [25.0, 1.0], [21.0, 6.0]]],
    ]
}

/// The points of a ring with the first repeated at the end.
fn closed(ring: &[[f64; 2]]) -> Vec<[f64; 2]> {
    ring.iter().chain(ring.first()).copied().collect()
}

fn json(chain: &[[f64; 2]]) -> String {
    let places: Vec<String> = chain.iter().map(|[x, y]| format!("[{x},{y}]")).collect();
    format!("[{}]", places.join(","))
}

fn wkt(chain: &[[f64; 2]]) -> String {
    let places: Vec<String> = chain.iter().map(|[x, y]| format!("{x} {y}")).collect();
    format!("({})", places.join(", "))
}

fn rings(reading: &dyn Reading, facts: &mut Facts) {
    let polygons = known_rings();
    let wanted: Chains = polygons.iter().flatten().cloned().collect();
    let all = |form: fn(&[[f64; 2]]) -> String| {
        polygons.each_ref().map(|rings| rings.iter().map(|ring| form(&closed(ring))).collect::<Vec<_>>().join(","))
    };
    let [first, second] = all(json);
    let geojson = format!("{{\"type\":\"MultiPolygon\",\"coordinates\":[[{first}],[{second}]]}}");
    let [first, second] = all(wkt);
    let wkt = format!("MULTIPOLYGON (({first}), ({second}))");
    for (file, text) in [("known.geojson", geojson), ("known.wkt", wkt)] {
        let got = reading.rings(file, text.as_bytes());
        facts.hold(got.as_ref() == Some(&wanted), || format!("{file}: {wanted:?} are read as {got:?}"));
    }
}

fn lines(reading: &dyn Reading, facts: &mut Facts) {
    let lines = [vec![[0.0, 0.0], [1.0, 2.0], [3.0, 1.0]], vec![[10.0, 0.0], [11.0, 5.0]]];
    let wanted: Chains = lines.iter().flat_map(|line| line.windows(2).map(<[_]>::to_vec)).collect();
    let geojson =
        format!("{{\"type\":\"MultiLineString\",\"coordinates\":[{}]}}", lines.each_ref().map(|l| json(l)).join(","));
    let wkt = format!("MULTILINESTRING ({})", lines.each_ref().map(|l| wkt(l)).join(", "));
    for (file, text) in [("known.geojson", geojson), ("known.wkt", wkt)] {
        let got = reading.segments(file, text.as_bytes());
        facts.hold(got.as_ref() == Some(&wanted), || format!("{file}: {wanted:?} are read as {got:?}"));
    }
}

/// The id of the scene, fixed since ids were introduced.
const PINNED: &str = "0fa27daf00cfd24b";

fn ids(reading: &dyn Reading, facts: &mut Facts) {
    let points = [[0.5, 1.0], [0.0, 3.0], [-2.0, 0.1]];
    let id = reading.id(&points);
    facts.hold(id.as_deref() == Some(PINNED), || format!("the id of a known scene is {id:?}"));
    let zero = reading.id(&[[0.5, 1.0], [-0.0, 3.0], [-2.0, 0.1]]);
    facts.hold(zero == id, || "-0 is not 0".to_owned());
    let others = [
        [[1.0, 0.5], [0.0, 3.0], [-2.0, 0.1]],
        [[0.0, 3.0], [0.5, 1.0], [-2.0, 0.1]],
        [[0.5, 1.0], [0.0, 3.0], [-2.0, 0.1_f64.next_up()]],
        [[0.5, 1.0], [0.0, 3.0], [2.0, 0.1]],
    ];
    for other in others {
        let got = reading.id(&other);
        facts.hold(got.is_some() && got != id, || format!("{points:?} and {other:?} have one id"));
    }
}

macro_rules! faults {
    ($($type:ident, $name:literal, $what:literal, $caught_by:expr, { $($body:item)* })*) => {
        $(
            struct $type;
            impl Reading for $type {
                $($body)*
            }
        )*

        /// The faults in the readers.
        pub const FAULTS: &[Guarded] = &[$(Guarded {
            area: Area::Readers,
            name: $name,
            what: $what,
            caught_by: $caught_by,
            run: || held(&$type),
        }),*];
    };
}

/// A double rounded to the nearest single.
fn as_single(x: f64) -> f64 {
    #[allow(clippy::cast_possible_truncation)]
    f64::from(x as f32)
}

faults! {
    SwapsAxes, "swaps-axes", "x and y of points are exchanged", &["written points"], {
        fn points(&self, file: &str, bytes: &[u8]) -> Option<Points> {
            let mut points = Real.points(file, bytes)?;
            points.iter_mut().for_each(|point| point.swap(0, 1));
            Some(points)
        }
    }
    DropsLastPoint, "drops-last-point", "the last point of a file is lost", &["written points"], {
        fn points(&self, file: &str, bytes: &[u8]) -> Option<Points> {
            let mut points = Real.points(file, bytes)?;
            points.pop();
            Some(points)
        }
    }
    RoundsToSingle, "rounds-to-single", "coordinates are rounded to singles", &["decimals", "hex floats"], {
        fn coordinate(&self, text: &str) -> Option<f64> {
            Real.coordinate(text).map(as_single)
        }
    }
    TakesNearest, "takes-nearest", "a decimal that no double prints as is read as the nearest double", &["decimals"], {
        fn coordinate(&self, text: &str) -> Option<f64> {
            Real.coordinate(text).or_else(|| text.parse().ok().filter(|x: &f64| x.is_finite()))
        }
    }
    ForgetsMinus, "forgets-minus", "the sign of a hex float is lost", &["hex floats"], {
        fn coordinate(&self, text: &str) -> Option<f64> {
            Real.coordinate(if text.starts_with("-0x") { &text[1..] } else { text })
        }
    }
    ObjFromZero, "obj-from-zero", "corners of OBJ are counted from 0", &["written meshes"], {
        fn faces(&self, file: &str, bytes: &[u8]) -> Option<Faces> {
            if !file.ends_with(".obj") {
                return Real.faces(file, bytes);
            }
            let text = String::from_utf8_lossy(bytes);
            let points: Vec<[f64; 3]> = text.lines().filter_map(|line| {
                let mut numbers = line.strip_prefix("v ")?.split(' ').filter_map(|x| x.parse().ok());
                Some([numbers.next()?, numbers.next()?, numbers.next()?])
            }).collect();
            let face = |line: &str| -> Option<Vec<[f64; 3]>> {
                line.split(' ').map(|at| points.get(at.parse::<usize>().ok()? % points.len()).copied()).collect()
            };
            text.lines().filter_map(|line| line.strip_prefix("f ")).map(face).collect()
        }
    }
    StlByteOrder, "stl-byte-order", "binary STL is read as big-endian", &["written meshes"], {
        fn faces(&self, file: &str, bytes: &[u8]) -> Option<Faces> {
            let mut bytes = bytes.to_vec();
            if file.ends_with(".stl") && !bytes.starts_with(b"solid") {
                for facet in bytes[STL_HEAD + 4..].chunks_mut(50) {
                    facet[..48].chunks_mut(4).for_each(<[u8]>::reverse);
                }
            }
            Real.faces(file, &bytes)
        }
    }
    TurnsFaces, "turns-faces", "the corners of faces are read in reverse", &["written meshes"], {
        fn faces(&self, file: &str, bytes: &[u8]) -> Option<Faces> {
            let mut faces = Real.faces(file, bytes)?;
            faces.iter_mut().for_each(|face| face.reverse());
            Some(faces)
        }
    }
    KeepsClosingPoint, "keeps-closing-point", "the repeated last point of a ring becomes a corner", &["written \
                        rings"], {
        fn rings(&self, file: &str, bytes: &[u8]) -> Option<Chains> {
            Some(Real.rings(file, bytes)?.iter().map(|ring| closed(ring)).collect())
        }
    }
    LosesHoles, "loses-holes", "only the first ring of a polygon is read", &["written rings"], {
        fn rings(&self, file: &str, bytes: &[u8]) -> Option<Chains> {
            let read = geometry::read(file, bytes.to_vec(), &Decimals::new(false)).ok()?;
            let shapes = read.features.into_iter().flat_map(|feature| feature.shapes);
            let outer = shapes.filter_map(|shape| match shape {
                geometry::Shape::Polygon(rings) => rings.into_iter().next(),
                _ => None,
            });
            Some(outer.map(|ring| ring.iter().map(|position| position.at).collect()).collect())
        }
    }
    JoinsLines, "joins-lines", "the end of a line is joined to the beginning of the next", &["written lines"], {
        fn segments(&self, file: &str, bytes: &[u8]) -> Option<Chains> {
            let segments = Real.segments(file, bytes)?;
            let between = segments.windows(2).filter(|pair| pair[0].last() != pair[1].first());
            let joints: Chains = between.map(|pair| vec![pair[0][1], pair[1][0]]).collect();
            Some(segments.iter().cloned().chain(joints).collect())
        }
    }
    IdOfSingles, "id-of-singles", "the id of a scene is computed from its coordinates as singles", &["content ids"], {
        fn id(&self, points: &[[f64; 2]]) -> Option<String> {
            let singles: Vec<[f64; 2]> = points.iter().map(|point| point.map(as_single)).collect();
            Real.id(&singles)
        }
    }
    IdOfSorted, "id-of-sorted", "the id of a scene does not depend on the order of its points", &["content ids"], {
        fn id(&self, points: &[[f64; 2]]) -> Option<String> {
            let mut sorted = points.to_vec();
            sorted.sort_by(|p, q| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])));
            Real.id(&sorted)
        }
    }
}
