//! Every format comes back as it was written.

use std::sync::Mutex;

use super::*;

fn sketch(name: &str, bytes: &[u8]) -> Sketch {
    Sketch::read(name, bytes.to_vec()).unwrap_or_else(|error| panic!("{error}"))
}

/// Red if a writer drops a face, a point or a digit. Degenerate faces are kept: the command judges them.
#[test]
fn what_is_written_is_read_again() {
    let faces = "0 0 0.1\n1 0 1e300\n0 1 -5e-324\n7 7 7\n";
    let off = sketch("a.off", format!("OFF 4 3 0\n{faces}3 0 1 2\n3 1 1 2\n2 0 1\n").as_bytes());
    let obj = sketch("a.obj", b"v 0 0 0.1\nv 1 0 1e300\nv 0 1 0\nl 1 3\nvn 0 0 1\nf 1//1 2//1 3//1\nf 1 1 1\n");
    let header = "element vertex 4\nproperty double x\nproperty double y\nproperty double z\nelement face 1\n\
        property list uchar int vertex_indices\nend_header\n";
    let ply = sketch("a.ply", format!("ply\nformat ascii 1.0\n{header}{faces}4 3 2 1 0\n").as_bytes());
    let mut binary = format!("ply\nformat binary_big_endian 1.0\n{header}").into_bytes();
    binary.extend((0..12).flat_map(|x| (f64::from(x) / 3.0).to_be_bytes()));
    binary.extend([3, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 3]);
    let facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 0\nendloop\nendfacet\n";
    let mut stl = vec![b' '; 80];
    stl.extend(1_u32.to_le_bytes());
    stl.extend([0; 12]);
    stl.extend([0.1_f32, 0.2, 0.3, 1e-45, 3e38, -0.0, 1.0, 2.0, 3.0].into_iter().flat_map(f32::to_le_bytes));
    stl.extend([0; 2]);
    let polygon =
        "{\"type\":\"MultiPolygon\",\"coordinates\":[[[[0,0],[1,0],[0,1],[0,0]]],[[[5,5],[6,5],[5,6],[5,5]]]]}";
    let feature = format!("{{\"type\":\"Feature\",\"properties\":null,\"geometry\":{polygon}}}");
    let all = format!("{{\"type\":\"FeatureCollection\",\"features\":[{feature},{feature}]}}");
    let mixed = "GEOMETRYCOLLECTION (POINT Z (1 2 3), LINESTRING Z (0 0 0, 1 1 1e-9))\nMULTIPOINT ((1 2), (3 4))\n";
    for (name, sketch) in [
        ("a.off", off),
        ("a.obj", obj),
        ("a.ply", ply),
        ("b.ply", sketch("b.ply", &binary)),
        ("a.stl", sketch("a.stl", format!("solid\n{facet}endsolid\n").as_bytes())),
        ("b.stl", sketch("b.stl", &stl)),
        ("a.geojson", sketch("a.geojson", all.as_bytes())),
        ("b.geojson", sketch("b.geojson", feature.as_bytes())),
        ("c.json", sketch("c.json", polygon.as_bytes())),
        ("d.json", sketch("d.json", b"[[[0,0],[1,0],[0,1]]]")),
        ("a.wkt", sketch("a.wkt", mixed.as_bytes())),
        ("a.csv", sketch("a.csv", b"# made\nname;x;y\na;0.10;2\nb;3;4\n")),
        ("a.txt", sketch("a.txt", b"1 2\n\n3   4\n")),
    ] {
        let written = sketch.written();
        let text = String::from_utf8_lossy(&written);
        // The points of a mesh that no face names are items.
        let again = Sketch::read(name, written.clone()).unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert_eq!(again, sketch, "{text}");
        assert_eq!(again.written(), written, "{name}");
    }
    assert_eq!(sketch("a.csv", b"name;x\na;0.10\n").written(), b"name;x\na;0.10\n");
}

/// A command that fails on files with this property, and the number of its runs.
struct Fails(fn(&[&str]) -> bool, Mutex<usize>);

impl Command for Fails {
    fn fails(&self, files: &[Vec<u8>], _: &(dyn Fn() -> bool + Sync)) -> Result<Option<bool>, Halt> {
        let text = String::from_utf8_lossy(&files[0]);
        Ok(Some((self.0)(&text.lines().collect::<Vec<_>>())))
    }

    fn record(&self, _: &Digest, _: bool) -> Result<(), Halt> {
        *self.1.lock().unwrap() += 1;
        Ok(())
    }

    fn kept(&self, _: &[Vec<u8>], _: Counts) -> Result<(), Halt> {
        Ok(())
    }
}

/// The smallest file for these rows on some threads, and the number of runs.
fn smallest(rows: usize, threads: usize, fails: fn(&[&str]) -> bool) -> (String, usize) {
    let text: String = (0..rows).map(|at| format!("r{at},9\n")).collect();
    shrunk(sketch("a.csv", text.as_bytes()), threads, fails)
}

fn shrunk(sketch: Sketch, threads: usize, fails: fn(&[&str]) -> bool) -> (String, usize) {
    let command = Fails(fails, Mutex::new(0));
    let mut search = Search::new(vec![sketch], &command, HashMap::new());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| search.run()).unwrap();
    let runs = *command.1.lock().unwrap();
    (String::from_utf8(search.best[0].written()).unwrap(), runs)
}

/// Red if the search ends before chunks of one row: every chunk of two has an even one.
#[test]
fn no_single_row_can_be_removed_in_the_end() {
    let even: fn(&[&str]) -> bool =
        |rows| (0..32).all(|at| rows.iter().any(|row| row.starts_with(&format!("r{},", 2 * at))));
    let (left, runs) = smallest(64, 2, even);
    let expected: String = (0..32).map(|at| format!("r{},0\n", 2 * at)).collect();
    assert_eq!(left, expected);
    assert!((64..800).contains(&runs), "{runs}");
}

/// Red if a batch takes another success than its first.
#[test]
fn the_number_of_threads_does_not_matter() {
    let one_of_many: fn(&[&str]) -> bool = |rows| rows.iter().filter(|row| row.contains('3')).count() >= 2;
    let alone = smallest(50, 1, one_of_many).0;
    assert_eq!(alone.lines().count(), 2, "{alone}");
    for threads in [2, 3, 7] {
        assert_eq!(smallest(50, threads, one_of_many).0, alone, "{threads} threads");
    }
}

/// Red if points do not take the place of their neighbours: no face of a closed mesh can be removed alone.
#[test]
fn a_closed_mesh_stays_closed() {
    let n = 30;
    let ring: String = (0..n).map(|at| format!("{at} {} 0\n", at * at)).collect();
    let around = (0..n).map(|at| (at, (at + 1) % n));
    let faces: String = around.map(|(a, b)| format!("3 {a} {b} {n}\n3 {b} {a} {}\n", n + 1)).collect();
    let text = format!("OFF\n{} {} 0\n{ring}0 0 9\n0 0 -9\n{faces}", n + 2, 2 * n);
    let is_closed: fn(&[&str]) -> bool = |lines| {
        let counts: Vec<usize> = lines[1].split(' ').map(|word| word.parse().unwrap()).collect();
        let faces = lines[2 + counts[0]..].iter().map(|line| line.split(' ').skip(1).collect::<Vec<_>>());
        let edges: Vec<(&str, &str)> = faces.flat_map(|f| [(f[0], f[1]), (f[1], f[2]), (f[2], f[0])]).collect();
        counts[1] >= 4 && edges.iter().all(|(a, b)| edges.iter().filter(|edge| **edge == (*b, *a)).count() == 1)
    };
    let left = shrunk(sketch("a.off", text.as_bytes()), 2, is_closed).0;
    assert!(left.lines().nth(1).is_some_and(|counts| counts.ends_with(" 4 0")), "{left}");
}
