//! Pixel maps: the colour of each answer, and which answers count as wrong.

use std::collections::BTreeSet;

use tempfile::tempdir;

use crate::common::{at, expect, read, run, write};

type Colour = [u8; 3];

const RED: Colour = [230, 120, 90];
const YELLOW: Colour = [250, 225, 110];
const BLUE: Colour = [110, 165, 225];
const DARK_YELLOW: Colour = [130, 95, 0];

/// The colours of a PNG file and its width.
fn decode(path: &str) -> (usize, Vec<Colour>) {
    let mut decoder = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(path).unwrap()));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    (usize::try_from(info.width).unwrap(), bytes[..info.buffer_size()].as_chunks().0.to_vec())
}

/// Checks one pixel of each colour, as README and `map --help` name them. A point above the diagonal is left of the
/// line.
#[test]
fn left_is_blue_right_is_red_the_line_is_yellow_and_wrong_is_dark() {
    let folder = tempdir().unwrap();
    let picture = |backend: &str| {
        let out = at(&folder, &format!("{}.png", backend.replace(':', "-")));
        let told = expect(0, &["draw", "map", "kettner-pixels-a", "-b", backend, "--out", &out]);
        let (width, pixels) = decode(&out);
        assert_eq!((width, pixels.len()), (256, 256 * 256));
        (told.stdout.lines().next().unwrap().to_owned(), pixels)
    };
    let colours = |pixels: &[Colour]| pixels.iter().copied().collect::<BTreeSet<_>>();

    let (caption, exact) = picture("exact");
    assert_eq!([exact[0], exact[255], exact[256 * 255], exact[256 * 256 - 1]], [BLUE, YELLOW, YELLOW, RED]);
    assert_eq!(colours(&exact), BTreeSet::from([BLUE, RED, YELLOW]));
    assert!(caption.starts_with("exact") && caption.contains(" 0 differ from the exact sign, 0 wrong"), "{caption}");

    // Ties are broken as the backend promises, so their colour differs from the exact one but is not dark.
    let (caption, sos) = picture("sos");
    assert_eq!(colours(&sos), BTreeSet::from([BLUE, RED]));
    assert!(caption.contains(" 256 differ from the exact sign, 0 wrong"), "{caption}");
    // All points are within the band.
    let (caption, tolerance) = picture("tolerance");
    assert_eq!(colours(&tolerance), BTreeSet::from([YELLOW]));
    assert!(caption.contains(" 65280 differ from the exact sign, 0 wrong"), "{caption}");
    // The same answers without a promise are wrong.
    let (caption, epsilon) = picture("epsilon:1e-10");
    assert_eq!(colours(&epsilon), BTreeSet::from([YELLOW, DARK_YELLOW]));
    assert!(caption.contains(" 65280 differ from the exact sign, 65280 wrong"), "{caption}");

    let help = expect(0, &["draw", "map", "--help"]).stdout;
    assert!(help.contains("red/yellow/blue for -/0/+"), "{help}");
    let readme = std::fs::read_to_string("../README.md").unwrap().replace('\n', " ");
    assert!(readme.contains("blue is left, red is right, yellow is on the line, and dark is wrong"), "{readme}");
}

#[test]
fn what_cannot_be_drawn_is_said_before_anything_is_written() {
    let folder = tempdir().unwrap();
    let refused = |words: &[&str], name: &str, said: &str| {
        let out = at(&folder, name);
        let told =
            run(&[&["draw", "map", "kettner-a1-global", "-b", "exact", "--side", "5", "--out", &out], words].concat());
        assert!(told.code == 2 && told.stderr.contains(said), "{words:?}: {} {}", told.code, told.stderr);
        assert!(!folder.path().join(name).exists(), "{name}");
    };
    for words in [
        &["--query", "orient2d(yz; 0 1 2)"][..],
        &["--query", "orient2d(yz; 0 1 2)", "--plane", "xy"],
        &["--query", "orient2d(xy; 0 1 2)", "--plane", "yz"],
        &["--query", "compare(z; 0 1)"],
    ] {
        refused(words, "z.svg", "the scene has no z axis");
    }
    for name in ["c.jpg", "c", "c.PNG"] {
        refused(&["--query", "orient2d(xy; 0 1 2)"], name, &format!("{name}: name a file that ends in .png or .svg"));
    }
}

/// Scenes with the same name in two suites have separate pictures.
#[test]
fn pictures_of_a_run_go_by_scenes_and_not_by_names() {
    let folder = tempdir().unwrap();
    let name = "a/b: c";
    let pixels = |x: &str| {
        format!(
            "title = \"Mine\"\n[[generate]]\nfamily = \"pixel-map\"\nname = {name:?}\ntask = \"orient2d\"\n\
             p = [{x}, 0.5]\nq = [12, 12]\nr = [24, 24]\ntags = [\"picture\"]\n"
        )
    };
    let (one, two) = (write(&folder, "one.toml", &pixels("0.5")), write(&folder, "two.toml", &pixels("0.25")));
    let (run, report) = (at(&folder, "run"), at(&folder, "report"));
    expect(0, &["run", &one, &two, "-b", "exact", "--out", &run]);
    let files: Vec<_> =
        std::fs::read_dir(at(&folder, "run/maps")).unwrap().map(|entry| entry.unwrap().path()).collect();
    let [one, two] = &files[..] else { panic!("{files:?}") };
    assert_ne!(std::fs::read(one).unwrap(), std::fs::read(two).unwrap());
    expect(0, &["report", &run, "--out", &report]);
    let page = read(&report, "report.html").replace("&#x2f;", "/");
    assert!(["one", "two"].iter().all(|suite| page.contains(&format!("{suite}/{name} exact"))), "both have captions");
}
