//! The time to read data files, against parsers that do not check whether a decimal is a double.
//!
//! The plain parsers split text into words and call `fast-float2`: they report neither lines nor lost digits. The
//! script `reading.py` beside this file times libraries of Python on the files that `READING_KEEP=FOLDER` keeps.

use std::hint::black_box;
use std::path::PathBuf;
use std::time::Instant;

use predicament_corpus::Random;
use predicament_formats::{Decimals, mesh as meshes, points};

/// The number of times that each reader reads each file.
const ROUNDS: usize = 7;
/// The number of points of a table, and of faces of a mesh.
const SIZE: usize = 1_000_000;

type Reader<'r> = (&'r str, &'r dyn Fn(Vec<u8>) -> usize);

/// Times readers in turns on one file; prints medians, and ratios to the last reader.
fn compare(name: &str, bytes: &[u8], readers: &[Reader<'_>]) {
    if let Some(folder) = std::env::var_os("READING_KEEP") {
        std::fs::write(PathBuf::from(folder).join(name), bytes).expect("a folder that can be written");
    }
    let mut times = vec![Vec::new(); readers.len()];
    let mut counts = vec![0; readers.len()];
    for round in 0..ROUNDS {
        for turn in 0..readers.len() {
            let at = (round + turn) % readers.len();
            let copy = bytes.to_vec();
            let start = Instant::now();
            counts[at] = black_box(readers[at].1(black_box(copy)));
            times[at].push(start.elapsed().as_secs_f64());
        }
    }
    let median = |times: &mut Vec<f64>| {
        times.sort_unstable_by(f64::total_cmp);
        times[times.len() / 2]
    };
    let medians: Vec<f64> = times.iter_mut().map(median).collect();
    println!("{name}: {} bytes", bytes.len());
    let plain = medians.last().copied().unwrap_or(f64::NAN);
    for (((name, _), time), count) in readers.iter().zip(&medians).zip(counts) {
        println!("  {name:<12} {:8.1} ms  {:5.2}  {count} numbers", 1e3 * time, time / plain);
    }
}

fn coordinate(bytes: &[u8]) -> f64 {
    fast_float2::parse(bytes).expect("a number")
}

/// The numbers of a table by the crate `csv`.
fn plain_csv(bytes: Vec<u8>) -> usize {
    let mut reader = csv::Reader::from_reader(&bytes[..]);
    let (mut record, mut numbers) = (csv::ByteRecord::new(), Vec::new());
    while reader.read_byte_record(&mut record).expect("a table") {
        numbers.extend(record.iter().map(coordinate));
    }
    numbers.len()
}

/// The points and faces of an OFF file.
fn plain_off(bytes: Vec<u8>) -> usize {
    let mut words = bytes.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()).skip(1);
    let mut word = || words.next().expect("a word");
    let whole = |word: &[u8]| std::str::from_utf8(word).ok().and_then(|text| text.parse().ok()).expect("a count");
    let [points, faces, _]: [usize; 3] = [whole(word()), whole(word()), whole(word())];
    let numbers: Vec<f64> = (0..3 * points).map(|_| coordinate(word())).collect();
    let ids: Vec<usize> = (0..4 * faces).map(|_| whole(word())).collect();
    numbers.len() + black_box(ids).len() / 4 * 3
}

/// The corners of an STL file in binary, with equal points joined.
fn plain_stl(bytes: Vec<u8>) -> usize {
    let mut known = std::collections::HashMap::new();
    let mut ids = Vec::new();
    for face in bytes[84..].as_chunks::<50>().0 {
        for corner in face[12..48].as_chunks::<12>().0 {
            let next = known.len();
            ids.push(*known.entry(*corner).or_insert(next));
        }
    }
    3 * known.len() + black_box(ids).len()
}

/// The positions of polygons in GeoJSON, by `serde_json`.
fn plain_geojson(bytes: Vec<u8>) -> usize {
    #[derive(serde::Deserialize)]
    struct Collection {
        features: Vec<Feature>,
    }
    #[derive(serde::Deserialize)]
    struct Feature {
        geometry: Geometry,
    }
    #[derive(serde::Deserialize)]
    struct Geometry {
        coordinates: Vec<Vec<[f64; 2]>>,
    }
    let all: Collection = serde_json::from_slice(&bytes).expect("GeoJSON");
    // A ring ends where it starts.
    all.features.iter().flat_map(|one| &one.geometry.coordinates).map(|ring| 2 * (ring.len() - 1)).sum()
}

/// A grid of triangles over a square, with heights: points and triangles.
fn terrain(random: &mut Random) -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let side = (SIZE / 2).isqrt();
    let points = (0..(side + 1) * (side + 1)).map(|_| [0, 1, 2].map(|_: usize| random.unit())).collect();
    let cells = (0..side * side).map(|at| at / side * (side + 1) + at % side);
    let faces = cells.flat_map(|at| [[at, at + 1, at + side + 2], [at, at + side + 2, at + side + 1]]);
    (points, faces.collect())
}

fn main() {
    let decimals = || Decimals::new(false);
    let mut random = Random::new("reading", "bench", 1);
    let own = |name: &'static str| {
        move |bytes: Vec<u8>| points::read(name, bytes, &decimals()).expect("points").coordinates.len()
    };
    let pairs: Vec<[f64; 2]> = (0..SIZE).map(|_| [random.unit(), random.between(-180.0, 180.0)]).collect();
    for (name, write) in [
        ("shortest.csv", (|x| format!("{x}")) as fn(f64) -> String),
        ("seventeen.csv", |x| format!("{x:.16e}")),
        ("six.csv", |x| format!("{x:.6}")),
    ] {
        let rows = pairs.iter().map(|[x, y]| format!("{},{}\n", write(*x), write(*y)));
        let text = std::iter::once("x,y\n".to_owned()).chain(rows).collect::<String>();
        compare(name, text.as_bytes(), &[("predicament", &own("points.csv")), ("csv", &plain_csv)]);
    }

    let (points, faces) = terrain(&mut random);
    let mesh = |name: &'static str| {
        move |bytes: Vec<u8>| {
            let mesh = meshes::read(name, bytes, &decimals()).expect("a mesh");
            3 * (mesh.points.len() + mesh.triangles.len())
        }
    };
    let head = format!("OFF\n{} {} 0\n", points.len(), faces.len());
    let rows = points.iter().map(|[x, y, z]| format!("{x} {y} {z}\n"));
    let triangles = faces.iter().map(|[a, b, c]| format!("3 {a} {b} {c}\n"));
    let text = std::iter::once(head).chain(rows).chain(triangles).collect::<String>();
    compare("mesh.off", text.as_bytes(), &[("predicament", &mesh("mesh.off")), ("words", &plain_off)]);

    let mut stl = vec![0; 80];
    stl.extend(u32::try_from(faces.len()).expect("a count").to_le_bytes());
    for face in &faces {
        stl.extend([0; 12]);
        #[allow(clippy::cast_possible_truncation)] // the format has singles
        stl.extend(face.iter().flat_map(|&v| points[v].map(|x| x as f32)).flat_map(f32::to_le_bytes));
        stl.extend([0; 2]);
    }
    compare("mesh.stl", &stl, &[("predicament", &mesh("mesh.stl")), ("HashMap", &plain_stl)]);

    let ring = |at: usize| {
        let corners = (0..10).map(|i| pairs[(10 * at + if i == 9 { 0 } else { i }) % SIZE]);
        let corners: Vec<String> = corners.map(|[x, y]| format!("[{x},{y}]")).collect();
        let geometry = format!("{{\"type\":\"Polygon\",\"coordinates\":[[{}]]}}", corners.join(","));
        format!("{{\"type\":\"Feature\",\"properties\":{{}},\"geometry\":{geometry}}}")
    };
    let features: Vec<String> = (0..SIZE / 10).map(ring).collect();
    let text = format!("{{\"type\":\"FeatureCollection\",\"features\":[{}]}}", features.join(","));
    compare(
        "rings.geojson",
        text.as_bytes(),
        &[("predicament", &own("rings.geojson")), ("serde_json", &plain_geojson)],
    );
}
