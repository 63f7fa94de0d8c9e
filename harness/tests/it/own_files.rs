//! The user's own data from end to end: the advice in error messages works, and rounding is reported.

use crate::common::{at, column, expect, read, write};
use tempfile::{TempDir, tempdir};

const POINTS: &str = "x,y\n0.1000000000000000001,0.5\n12,12\n24,24\n";

fn suite(folder: &TempDir, name: &str, more: &str) -> String {
    let text = format!(
        "title = \"t\"\n{more}\n[[scene]]\nname = \"a\"\ntask = \"orient2d\"\npoints = {{ path = \"p.csv\" }}\n"
    );
    write(folder, name, &text)
}

#[test]
fn fmt_does_for_csv_what_the_error_advises() {
    let folder = tempdir().unwrap();
    let (suite, points) = (suite(&folder, "s.toml", ""), write(&folder, "p.csv", POINTS));
    let told = expect(104, &["corpus", "verify", &suite]);
    let advice = format!(
        "p.csv:2: decimal 0.1000000000000000001 has digits that no double holds; run `predicament corpus fmt {points}` and use the file that it writes, or"
    );
    assert!(told.stderr.contains(&advice), "{}", told.stderr);
    assert_eq!(expect(104, &["corpus", "fmt", "--check", &points]).stdout, format!("would change: {points}\n"));
    assert_eq!(std::fs::read_to_string(&points).unwrap(), POINTS, "to check is not to change");
    let beside = at(&folder, "p.hex.csv");
    assert_eq!(expect(0, &["corpus", "fmt", &points]).stdout, format!("written: {beside}\n"));
    let tidy = POINTS.replace("0.1000000000000000001,0.5", "# 0.1000000000000000001\n0x1.999999999999ap-4,0.5");
    assert_eq!(std::fs::read_to_string(&points).unwrap(), POINTS, "the file itself stays");
    assert_eq!(std::fs::read_to_string(&beside).unwrap(), tidy);
    expect(0, &["ask", "orient2d", "--points", &beside, "-b", "exact"]);
    // What is tidy needs no other file.
    let told = expect(0, &["corpus", "fmt", &beside]);
    assert!(
        told.stdout.is_empty() && told.stderr.contains("p.hex.csv: every decimal is read as it is"),
        "{}",
        told.stderr
    );
    std::fs::remove_file(&beside).unwrap();
    assert_eq!(expect(0, &["corpus", "fmt", "--in-place", &points]).stdout, format!("changed: {points}\n"));
    assert_eq!(std::fs::read_to_string(&points).unwrap(), tidy);
    expect(0, &["corpus", "fmt", "--check", &points]);
    expect(0, &["corpus", "verify", &suite]);
    expect(2, &["corpus", "fmt", "--check", "--in-place", &points]);
    let names: Vec<String> = std::fs::read_dir(folder.path())
        .unwrap()
        .map(|file| file.unwrap().file_name().into_string().unwrap())
        .collect();
    assert_eq!(names.len(), 2, "nothing is left beside: {names:?}");
}

#[test]
#[cfg(unix)]
fn fmt_keeps_links_and_permissions() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = tempdir().unwrap();
    let points = write(&folder, "real.csv", POINTS);
    std::fs::set_permissions(&points, std::fs::Permissions::from_mode(0o640)).unwrap();
    symlink("real.csv", at(&folder, "p.csv")).unwrap();
    expect(0, &["corpus", "fmt", "--in-place", &at(&folder, "p.csv")]);
    assert!(std::fs::symlink_metadata(at(&folder, "p.csv")).unwrap().is_symlink());
    assert!(std::fs::read_to_string(&points).unwrap().contains("# 0.1000000000000000001\n"));
    assert_eq!(std::fs::metadata(&points).unwrap().permissions().mode() & 0o777, 0o640);
}

/// The new suite has the same data, and the same scenes.
#[test]
fn a_suite_is_rewritten_beside_itself() {
    let folder = tempdir().unwrap();
    write(&folder, "q.csv", "0,0\n12,12\n24,25\n");
    let text = "title = \"t\"\n[[scene]]\nname = \"a\"\ntask = \"orient2d\"\npoints = { path = \"q.csv\" }\n\
                [[scene]]\nname = \"b\"\ntask = \"orient2d\"\npoints = [[0.1000000000000000001, 0], [1, 0], [0, 1]]\n";
    let suite = write(&folder, "s.toml", text);
    expect(104, &["corpus", "verify", &suite]);
    let beside = at(&folder, "s.hex.toml");
    assert_eq!(expect(0, &["corpus", "fmt", &suite]).stdout, format!("written: {beside}\n"));
    assert_eq!(std::fs::read_to_string(&suite).unwrap(), text);
    expect(0, &["corpus", "verify", &beside]);
    assert!(
        expect(2, &["corpus", "fmt", &suite, "--columns", "1,2"]).stderr.contains("only CSV files have columns; leave")
    );
}

/// Numbers of rows may have digits that no double holds: they are no coordinates.
#[test]
fn fmt_leaves_other_columns_as_they_are() {
    let folder = tempdir().unwrap();
    let text = "id,name,lat,lon\n12345678901234567890,a,0.1000000000000000001,1\n";
    let points = write(&folder, "p.csv", text);
    let tidy = "id,name,lat,lon\n# 0.1000000000000000001\n12345678901234567890,a,0x1.999999999999ap-4,1\n";
    for columns in [&[][..], &["--columns", "lon,lat"], &["--columns", "4,3"]] {
        expect(0, &[&["corpus", "fmt", &points], columns].concat());
        assert_eq!(read(folder.path().to_str().unwrap(), "p.hex.csv"), tidy, "{columns:?}");
    }
    let told = expect(104, &["corpus", "fmt", &points, "--columns", "name,lat"]);
    assert!(told.stderr.contains("p.csv:2: column `name`: `a` is not a number"), "{}", told.stderr);
}

#[test]
fn fmt_says_what_it_can_t_rewrite() {
    let folder = tempdir().unwrap();
    for name in ["roads.geojson", "mesh.off", "p.csv.gz", "points"] {
        let file = write(&folder, name, "");
        let told = expect(2, &["corpus", "fmt", &file]);
        let wanted = "only suites and CSV files can be rewritten; name a .toml, .csv or .txt file; for other data write \
                      `round = true` in the scene";
        assert!(told.stderr.lines().count() == 1 && told.stderr.contains(wanted), "{}", told.stderr);
    }
}

#[test]
fn what_is_rounded_is_a_row_and_a_line_of_the_report() {
    let folder = tempdir().unwrap();
    write(&folder, "p.csv", POINTS);
    let (plain, rounded) = (suite(&folder, "plain.toml", ""), suite(&folder, "rounded.toml", "round = true"));
    let out = at(&folder, "run");
    expect(104, &["run", &plain, "--out", &out]);
    expect(0, &["run", &rounded, "-b", "exact,sos", "--out", &out]);
    let rows = read(&out, "imports.csv");
    assert_eq!((column(&rows, "suite"), column(&rows, "scene")), (vec!["rounded".to_owned()], vec!["a".to_owned()]));
    assert_eq!(
        (column(&rows, "rounded"), column(&rows, "repeated_points")),
        (vec!["1".to_owned()], vec!["0".to_owned()])
    );
    let timed = at(&folder, "bench");
    expect(0, &["bench", &rounded, "-b", "exact", "--samples", "1", "--out", &timed]);
    assert_eq!(read(&timed, "imports.csv"), rows);
    let pages = at(&folder, "report");
    expect(0, &["report", &out, "--out", &pages]);
    let page = read(&pages, "report.md");
    let table = page.split("Changed by the reader").nth(1).expect("the table");
    assert!(
        table.contains("| rounded | orient2d | 1 |") || table.contains("| rounded | a | orient2d | 1 |"),
        "{table}"
    );
    // If reading changed nothing, there is no note.
    write(&folder, "p.csv", "0,0\n1,0\n0,1\n");
    let clean = at(&folder, "clean");
    expect(0, &["run", &plain, "-b", "exact", "--out", &clean]);
    assert_eq!(read(&clean, "imports.csv").lines().count(), 1);
    expect(0, &["report", &clean, "--out", &at(&folder, "clean-report")]);
    assert!(!read(&at(&folder, "clean-report"), "report.md").contains("Changed by the reader"));
}

#[test]
fn generated_scenes_are_written_out_as_a_suite() {
    let folder = tempdir().unwrap();
    let ids = |suite: &str, filter: &str| -> Vec<String> {
        let told = expect(0, &["corpus", "gen", suite, "-f", filter]).stdout;
        told.lines().filter_map(|line| Some(line.rsplit_once(", id ")?.1.trim_end_matches(')').to_owned())).collect()
    };
    let filter = "/(grid-orient3d|kettner-a1)$|degen-interval$";
    let text = expect(0, &["corpus", "gen", "families", "classics", "intervals", "-f", filter, "--toml"]).stdout;
    let suite = write(&folder, "mine.toml", &text);
    let (before, after) =
        (["families", "classics", "intervals"].map(|suite| ids(suite, filter)).concat(), ids(&suite, "."));
    assert!(before.len() >= 3 && before.len() == after.len(), "{before:?} {after:?}");
    // If the id of a scene changes, the suite says so.
    for (before, after) in before.iter().zip(&after) {
        let told = text.contains(&format!("# Its id is {after} here; it was {before}.\n"));
        assert_eq!(told, before != after, "{before} {after}");
    }
    assert_eq!(before.iter().zip(&after).filter(|(before, after)| before != after).count(), 1);
}

/// The name of a file is the name of its suite, and is printed in tables and terminals.
#[test]
#[cfg(unix)]
fn a_file_whose_name_has_control_characters_is_no_suite() {
    let folder = tempdir().unwrap();
    let told = expect(104, &["corpus", "verify", &write(&folder, "a\u{1b}[0mb.toml", crate::common::SUITE)]).stderr;
    assert!(told.contains("the suite's name `a\\u{1b}[0mb` has control characters; rename the file"), "{told}");
    assert!(!told.contains('\u{1b}'), "{told:?}");
    // Other characters that XML forbids are not control characters and are replaced.
    let suite = write(&folder, "\u{FFFE}.toml", crate::common::SUITE);
    let (run, junit) = (at(&folder, "run"), at(&folder, "junit.xml"));
    expect(0, &["run", &suite, "-b", "exact", "--out", &run]);
    expect(0, &["gate", &run, "--junit", &junit]);
    let xml = std::fs::read_to_string(&junit).unwrap();
    assert!(xml.contains("name=\"\u{FFFD}\"") && !xml.contains('\u{FFFE}'), "{xml}");
}

#[test]
fn a_scene_that_needs_more_memory_than_is_left_is_refused_before_it_is_solved() {
    let folder = tempdir().unwrap();
    let (points, out) = (write(&folder, "p.csv", "x,y\n0,0\n3,1\n1,3\n2,2\n"), at(&folder, "out"));
    let told = expect(2, &["solve", "delaunay2d", &points, "--memory", "1e-9", "--out", &out]);
    let parts = ["p.csv", "the answer needs about 1.0 KiB of memory, and 1.1 B may be used", "raise --memory"];
    assert!(parts.iter().all(|part| told.stderr.contains(part)), "{}", told.stderr);
    for limit in ["0", "-1", "nan", "much"] {
        let told = expect(2, &["solve", "delaunay2d", &points, "--memory", limit, "--out", &out]);
        assert!(told.stderr.contains("a number of GiB greater than zero"), "{}", told.stderr);
    }
    let space = write(&folder, "s.csv", "x,y,z\n0,0,0\n3,1,0\n1,3,0\n2,2,5\n");
    let lines = write(&folder, "l.wkt", "MULTILINESTRING ((0 0, 3 1), (1 3, 2 0))\n");
    for (task, scene) in [("crossings", &lines), ("snap2d", &lines), ("hull3d", &space)] {
        let told = expect(2, &["solve", task, scene, "--memory", "1e-9", "--out", &out]);
        assert!(told.stderr.contains("of memory, and 1.1 B may be used"), "{task}: {}", told.stderr);
    }
    assert!(!std::path::Path::new(&out).exists());
    expect(0, &["solve", "delaunay2d", &points, "--memory", "1", "--out", &out]);
}
