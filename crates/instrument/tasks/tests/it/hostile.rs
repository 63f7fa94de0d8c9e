//! The hostile list: excessive requests of a suite or a data file are refused in one line, at once.

use std::io::Write;
use std::path::Path;

use flate2::{Compression, write::GzEncoder};
use predicament_corpus::{Level, Suite};
use predicament_formats::{Cache, CorpusError, Manifest};

/// Reads a suite and loads its scenes, as `run` would.
fn load(path: &Path) -> Result<(), CorpusError> {
    let suite = Suite::from_file(predicament_bundle::vocabulary(), path, &Manifest::default())?;
    suite.scenes.iter().try_for_each(|scene| scene.load(Level::Full, &Cache::new("nowhere")).map(drop))
}

/// An attack: a name for messages, the suite, and a part of the error.
struct Attack {
    name: String,
    suite: Vec<u8>,
    expected: &'static str,
}

fn scene(task: &str, rest: &str) -> Vec<u8> {
    format!("title = \"t\"\n[[scene]]\nname = \"x\"\ntask = \"{task}\"\n{rest}\n").into()
}

fn generator(task: &str, rest: &str) -> Vec<u8> {
    format!("title = \"t\"\n[[generate]]\ntask = \"{task}\"\n{rest}\n").into()
}

/// Suites that ask for too much by themselves.
fn suites() -> Vec<Attack> {
    let digits = "1".repeat(10_001);
    let deep = "[".repeat(100_000);
    let tables = format!("{}1", "{a=".repeat(100_000));
    let many = (0..200).map(|i| format!("[{i}, 0]")).collect::<Vec<_>>().join(", ");
    let list: Vec<(&str, Vec<u8>, &str)> = vec![
        (
            "n",
            generator("insphere", "family = \"uniform\"\nn = 100000000"),
            "`n` is 100000000: a scene of about 1500000000 coordinates; the maximum is 268435456; choose at most \
             17895697",
        ),
        (
            "n_full",
            generator("orient3d", "family = \"near\"\nn = 1\nn_full = 99999999"),
            "`n_full` is 99999999: a scene of about",
        ),
        (
            "n beyond any",
            generator("orient2d", "family = \"grid\"\nn = 18446744073709551615"),
            "choose an integer from 1 to 100000000",
        ),
        ("band", generator("orient3d", "family = \"band\"\nn = 100000000"), "choose at most 22369620"),
        ("constructed", generator("orient3d", "family = \"tpi-uniform\"\nn = 100000000"), "choose at most"),
        ("tiling", generator("polygon-locate", "family = \"tiling\"\nn = 100000000"), "choose at most"),
        ("bricks", generator("polygon-locate", "family = \"bricks\"\nn = 100000"), "choose at most"),
        ("random", generator("polygon-locate", "family = \"tiling\"\nn = 2000\nrandom = 100000000"), "choose at most"),
        (
            "random beyond any",
            generator("polygon-locate", "family = \"tiling\"\nn = 3\nrandom = 100000001"),
            "choose an integer from 0 to 100000000",
        ),
        ("cells", generator("interval", "family = \"cells-uniform\"\nn = 100000000"), "choose at most 26843544"),
        ("cubes", generator("cube-union", "family = \"cubes-lattice\"\nn = 100000000"), "choose at most 44739242"),
        ("segments", generator("crossings", "family = \"segments-uniform\"\nn = 100000000"), "choose at most 67108864"),
        ("polygons", generator("contacts2d", "family = \"polygons-uniform\"\nn = 100000000"), "choose at most"),
        ("surfaces", generator("contacts3d", "family = \"surfaces-degen\"\nn = 100000000"), "choose at most"),
        (
            "side",
            generator("orient2d", "family = \"pixel-map\"\np = [0.5, 0.5]\nq = [12, 12]\nr = [24, 24]\nside = 4097"),
            "choose an integer from 1 to 4096",
        ),
        (
            "halvings",
            generator("orient2d", "family = \"ssi-degen\"\nn = 1\nhalvings = 901"),
            "choose an integer from 0 to 900",
        ),
        (
            "digits",
            generator("orient2d", "family = \"decimal-collinear\"\nn = 1\ndigits = 10"),
            "choose an integer from 1 to 9",
        ),
        (
            "bits",
            generator("contacts2d", "family = \"polygons-uniform\"\nn = 10\nbits = 54"),
            "choose an integer from 24 to 53",
        ),
        (
            "ulps",
            generator("orient2d", "family = \"near\"\nn = 1\nulps = 1048577"),
            "choose an integer from 1 to 1048576",
        ),
        (
            "all",
            scene("insphere", &format!("queries = \"all\"\npoints = [{}]", many.replace(", 0]", ", 0, 0]"))),
            "200 points have 0 or more than 1000000 combinations of 5; list the queries that matter",
        ),
        (
            "a long number",
            scene("compare", &format!("points = [[\"{digits}\", 0], [1, 1]]")),
            ":5: a number of 10001 bytes: `111",
        ),
        (
            "a long bare number",
            scene("compare", &format!("points = [[{digits}.5, 0], [1, 1]]")),
            ":5: a number of 10003 bytes: `111",
        ),
        (
            "a long hex float",
            scene("compare", &format!("points = [[\"0x{digits}p0\", 0], [1, 1]]")),
            ":5: a number of 10005 bytes: `0x111",
        ),
        ("deep arrays", scene("compare", &format!("points = {deep}")), ":5: "),
        ("deep tables", scene("compare", &format!("points = {tables}")), ":5: "),
        (
            "an index beyond any",
            scene("compare", "points = [[0, 0], [1, 1]]\nqueries = [[0, 99999999999]]"),
            "choose an integer from 0 to 2147483647",
        ),
        (
            "a control character",
            scene("compare", "points = [[\"\\u001b[2J\", 0], [1, 1]]"),
            "`\\u{1b}[2J` is not a number",
        ),
        ("NUL", b"title = \"t\0\"\n".to_vec(), ":1: "),
        ("no UTF-8", b"title = \"t\"\n# \xff\n".to_vec(), ":2: the file is not text in UTF-8"),
        (
            "carriage returns only",
            scene("compare", "points = [[0, 0], [1, 1]]")
                .into_iter()
                .map(|b| if b == b'\n' { b'\r' } else { b })
                .collect(),
            ":1: ",
        ),
    ];
    list.into_iter().map(|(name, suite, expected)| Attack { name: name.to_owned(), suite, expected }).collect()
}

/// A data file, the scene that names it, and a part of the error.
fn data() -> Vec<(&'static str, Vec<u8>, &'static str)> {
    let long = "1".repeat(10_001);
    let json = |coordinates: &str| format!("{{\"type\": \"MultiPoint\", \"coordinates\": {coordinates}}}").into_bytes();
    let ply = |format: &str, count: &str, properties: &str| {
        format!("ply\nformat {format} 1.0\nelement vertex {count}\n{properties}end_header\n").into_bytes()
    };
    const XYZ: &str = "property float x\nproperty float y\nproperty float z\n";
    let list = "element face 1\nproperty list uint int vertex_indices\n";
    let mut long_list = ply("binary_little_endian", "0", &format!("{XYZ}{list}"));
    long_list.extend(u32::MAX.to_le_bytes());
    let mut stl = vec![0; 80];
    stl.extend(u32::MAX.to_le_bytes());
    vec![
        ("long.csv", format!("{long},0\n1,1\n").into(), ":1: a number of 10001 bytes: `111"),
        ("long-name.csv", format!("0,0\n{},1\n", "x".repeat(100_000)).into(), ":2: a number of 100000 bytes: `xxx"),
        ("nul.csv", b"0,0\n\0,1\n".to_vec(), ":2: `\\u{0}` is not a number"),
        ("not-text.csv", b"0,0\n\xff\xfe,1\n".to_vec(), ":2: the file is not text in UTF-8"),
        ("utf16.csv", b"\xff\xfe0\0,\x000\0".to_vec(), ":1: the file is not text in UTF-8"),
        ("quote.csv", b"0,0\n\"1,1\n2,2\n".to_vec(), ":2: a quote that is not closed"),
        ("blank.csv", b"\n\n#\n".to_vec(), "the file has no points"),
        ("bomb.csv.gz", packed(&vec![b'0'; 1 << 20]), ":1: point 0 has 1 coordinates"),
        ("not-packed.csv.gz", b"0,0\n".to_vec(), "the file can't be unpacked"),
        ("cut.csv.gz", packed(b"0,0\n1,1\n")[..18].to_vec(), "the file can't be unpacked"),
        ("deep.geojson", "[".repeat(1 << 20).into(), "not GeoJSON"),
        ("deep-objects.geojson", "{\"a\":".repeat(1 << 18).into(), "not GeoJSON"),
        (
            "deep-position.geojson",
            json(&format!("{}{}", "[".repeat(1 << 18), "]".repeat(1 << 18))),
            "a position of 1 numbers; write at least two",
        ),
        ("long.geojson", json(&format!("[[{long}, 0]]")), "a number of 10001 bytes"),
        ("overflow.geojson", json("[[1e999, 0]]"), "is beyond the largest double"),
        ("long-exponent.geojson", json(&format!("[[1e{}, 0]]", "9".repeat(9000))), "is beyond the largest double"),
        ("nul.geojson", b"{\"type\": \"Point\", \0".to_vec(), ":1: not GeoJSON"),
        ("cut.geojson", b"{\"type\": \"MultiPoint\", \"coordinates\": [[0, 0], [1".to_vec(), "the file ends early"),
        ("deep.wkt", "GEOMETRYCOLLECTION(".repeat(1 << 18).into(), "more than 32 nested collections"),
        ("parentheses.wkt", format!("POLYGON{}", "(".repeat(1 << 20)).into(), "`(` where a number should be"),
        ("long.wkt", format!("POINT ({long} 0)").into(), "a number of 10001 bytes"),
        ("word.wkt", "X".repeat(1 << 20).into(), "no geometry is called `XXX"),
        (
            "counts.off",
            b"OFF\n4294967295 4294967295 0\n0 0 0\n".to_vec(),
            "the file ends after 1 of its 4294967295 vertices",
        ),
        (
            "corners.off",
            b"OFF\n1 1 0\n0 0 0\n18446744073709551615 0 0 0\n".to_vec(),
            ":4: a face is the number of its corners",
        ),
        (
            "index.obj",
            b"v 0 0 0\nf 1 -9223372036854775808 1\n".to_vec(),
            ":2: `-9223372036854775808` is not one of the 1 vertices",
        ),
        ("counts.ply", ply("ascii", "18446744073709551615", XYZ), "elements `vertex` don't fit into 0 bytes"),
        (
            "counts-binary.ply",
            ply("binary_little_endian", "4294967295", XYZ),
            "elements `vertex` don't fit into 0 bytes",
        ),
        (
            "no-properties.ply",
            ply("binary_little_endian", "4294967295", ""),
            "elements `vertex` don't fit into 0 bytes",
        ),
        ("list.ply", long_list, "at byte 168: the file ends after 0 of its 1 elements `face`; correct"),
        ("counts.stl", stl, "a binary file of 84 bytes, and its 4294967295 triangles take 214748364834"),
        ("endless.stl", b"solid\n".repeat(1 << 18), ":2: `solid` is out of place"),
        ("unknown.xyz", b"0 0\n".to_vec(), "the file name does not show its format"),
    ]
}

fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut packer = GzEncoder::new(Vec::new(), Compression::best());
    packer.write_all(bytes).unwrap();
    packer.finish().unwrap()
}

/// Compares an error with the expectation: one short line.
fn hold(name: &str, found: Result<(), CorpusError>, expected: &str) -> Result<(), String> {
    let Err(error) = found else { return Err(format!("{name}: not refused")) };
    let line = error.to_string();
    if line.contains(expected) && line.len() < 700 && !line.contains(char::is_control) {
        Ok(())
    } else {
        Err(format!("{name}\n  expected {expected}\n  got      {line}"))
    }
}

#[test]
fn each_is_refused_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let suite = folder.path().join("s.toml");
    let mut wrong = Vec::new();
    let mut tried = 0;
    for Attack { name, suite: bytes, expected } in suites() {
        std::fs::write(&suite, bytes).unwrap();
        wrong.extend(hold(&name, load(&suite), expected).err());
        tried += 1;
    }
    for (file, bytes, expected) in data() {
        std::fs::write(folder.path().join(file), bytes).unwrap();
        std::fs::write(&suite, scene("compare", &format!("points = {{ path = \"{file}\" }}"))).unwrap();
        wrong.extend(hold(file, load(&suite), expected).err());
        tried += 1;
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert_eq!(tried, 62, "the list");
}

#[test]
#[cfg(unix)]
fn pipes_devices_and_folders_are_not_opened() {
    use std::process::Command;
    use std::sync::mpsc;
    use std::time::Duration;

    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    for pipe in ["pipe.csv", "pipe.toml"] {
        let made = Command::new("mkfifo").arg(at(pipe)).status();
        assert!(made.is_ok_and(|status| status.success()), "no pipe can be made here");
    }
    std::fs::create_dir(at("folder.csv")).unwrap();
    std::fs::create_dir(at("folder.toml")).unwrap();
    for (link, to) in
        [("zero.csv", "/dev/zero"), ("zero.toml", "/dev/zero"), ("link.csv", "pipe.csv"), ("loop.csv", "loop.csv")]
    {
        std::os::unix::fs::symlink(to, at(link)).unwrap();
    }
    let irregular = "it is not a regular file (a pipe or a device)";
    let mut attacks =
        vec![(at("pipe.toml"), irregular), (at("zero.toml"), irregular), (at("folder.toml"), "it is a folder")];
    for (file, expected) in [
        ("pipe.csv", irregular),
        ("link.csv", irregular),
        ("zero.csv", irregular),
        ("folder.csv", "it is a folder"),
        ("loop.csv", "the data file can't be read: "),
        ("", "it is a folder"),
    ] {
        let suite = at(&format!("{}.toml", attacks.len()));
        std::fs::write(&suite, scene("compare", &format!("points = {{ path = \"{file}\" }}"))).unwrap();
        attacks.push((suite, expected));
    }
    assert_eq!(attacks.len(), 9, "the list");
    for (suite, expected) in attacks {
        // Opening a pipe would wait.
        let (done, waiting) = mpsc::channel();
        let name = suite.display().to_string();
        std::thread::spawn(move || done.send(load(&suite)));
        let found = waiting.recv_timeout(Duration::from_secs(60)).unwrap_or_else(|_| panic!("{name}: waits"));
        hold(&name, found, expected).unwrap_or_else(|wrong| panic!("{wrong}"));
    }
}
