//! `corpus new`: the suite fits the data, runs as it is, and overwrites nothing without leave.

use crate::common::{at, column, expect, read, tool, write};
use tempfile::{TempDir, tempdir};

/// Makes a suite of data, runs it, and gives its text.
fn made(folder: &TempDir, data: &str, more: &[&str], task: &str) -> String {
    let name = data.replace('.', "-");
    let (file, out) = (at(folder, &format!("{name}.toml")), at(folder, &name));
    let told = expect(0, &[&["corpus", "new", &file, "--points", data], more].concat());
    assert!(
        told.stdout.starts_with(&format!("{data}: ")) && told.stdout.contains(&format!(" of {task}\n")),
        "{}",
        told.stdout
    );
    expect(0, &["run", &file, "-b", "exact", "--out", &out]);
    assert_eq!(column(&read(&out, "summary.csv"), "task"), [task], "{data}");
    std::fs::read_to_string(&file).unwrap()
}

#[test]
fn a_suite_fits_its_data() {
    let folder = tempdir().unwrap();
    let rows = |n: u32, head: &str| {
        (0..n).fold(format!("{head}\n"), |text, k| text + &format!("{k},{},{},t\n", k * k % 97, k % 89))
    };
    write(&folder, "towns.csv", &rows(4000, "id,lat,lon,name"));
    write(&folder, "few.csv", &rows(500, "id,lat,lon,name"));
    write(&folder, "odd.csv", &rows(30, "id,a,b,name"));
    write(&folder, "plain.csv", "0,0\n1,0\n0,1\n");
    write(&folder, "space.csv", "x,y,z\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n");
    write(&folder, "land.geojson", r#"{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}"#);
    write(&folder, "roads.wkt", "LINESTRING (0 0, 1 1, 2 0)");
    write(&folder, "places.wkt", "POINT (0 0)\nPOINT (1 1)\nPOINT (2 1)");
    write(&folder, "mixed.wkt", "POINT (0 0)\nLINESTRING (0 0, 1 1)\nPOLYGON ((0 0, 2 0, 0 2, 0 0))");
    write(&folder, "closed.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    write(&folder, "open.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n");
    write(&folder, "cloud.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\n");
    let text = made(&folder, "towns.csv", &[], "orient2d");
    assert!(text.contains("points = { path = \"towns.csv\", columns = [\"lon\", \"lat\"] }\n"), "{text}");
    assert!(
        text.contains("\nqueries = { random = 1000, seed = 1 }\n") && text.contains("\n# round = true\n"),
        "{text}"
    );
    let text = made(&folder, "few.csv", &[], "orient2d");
    assert!(text.contains("\nqueries = \"tuples\"\n"), "{text}");
    let text = made(&folder, "odd.csv", &["--columns", "2,3"], "orient2d");
    assert!(text.contains("points = { path = \"odd.csv\", columns = [2, 3] }\n"), "{text}");
    let text = made(&folder, "plain.csv", &[], "orient2d");
    assert!(text.contains("points = { path = \"plain.csv\" }\n"), "{text}");
    for (data, task) in [
        ("space.csv", "orient3d"),
        ("land.geojson", "polygon-locate"),
        ("roads.wkt", "crossings"),
        ("places.wkt", "orient2d"),
        ("mixed.wkt", "contacts2d"),
        ("closed.off", "mesh-locate"),
        ("cloud.obj", "orient3d"),
    ] {
        made(&folder, data, &[], task);
    }
    made(&folder, "open.off", &[], "slice");
    // Any task that is named, if it can read the data.
    std::fs::remove_file(at(&folder, "towns-csv.toml")).unwrap();
    std::fs::remove_dir_all(at(&folder, "towns-csv")).unwrap();
    let text = made(&folder, "towns.csv", &["--task", "delaunay2d"], "delaunay2d");
    assert!(text.contains("columns = [\"lon\", \"lat\"]") && !text.contains("{queries}"), "{text}");
}

#[test]
fn decimals_are_rounded_only_where_they_need_it() {
    let folder = tempdir().unwrap();
    write(&folder, "long.csv", "id,x,y\n1,0.1000000000000000001,0.5\n2,0.2000000000000000001,3\n3,4,0.7\n");
    let text = made(&folder, "long.csv", &[], "orient2d");
    let comment = "# 2 decimals of long.csv have digits that no double holds. Their nearest doubles are used; the report counts them.\n";
    assert!(text.contains(&format!("{comment}round = true\n")), "{text}");
    assert_eq!(column(&read(&at(&folder, "long-csv"), "imports.csv"), "rounded"), ["2"]);
    write(&folder, "short.csv", "id,x,y\n1,0.1,0.5\n2,0.2,3\n3,4,0.7\n");
    assert!(made(&folder, "short.csv", &[], "orient2d").contains("\n# round = true\n"));
    write(&folder, "map.wkt", "POLYGON ((0.1000000000000000001 0, 1 0, 0 1, 0.1000000000000000001 0))");
    assert!(made(&folder, "map.wkt", &[], "polygon-locate").contains("digits that no double holds. "));
}

#[test]
fn data_are_found_from_here_and_from_the_suite() {
    let folder = tempdir().unwrap();
    std::fs::create_dir_all(folder.path().join("suites")).unwrap();
    std::fs::create_dir_all(folder.path().join("data")).unwrap();
    write(&folder, "data/p.csv", "0,0\n1,0\n0,1\n");
    write(&folder, "suites/q.csv", "0,0\n1,0\n0,2\n");
    for (data, file) in [
        ("data/p.csv", "suites/a.toml"),
        ("suites/q.csv", "suites/b.toml"),
        ("q.csv", "suites/c.toml"),
        ("data/p.csv", "d.toml"),
    ] {
        let done = tool(&["corpus", "new", file, "--points", data]).current_dir(folder.path()).output().unwrap();
        assert!(done.status.success(), "{data}: {}", String::from_utf8_lossy(&done.stderr));
        expect(0, &["corpus", "verify", &at(&folder, file)]);
    }
    let text = std::fs::read_to_string(at(&folder, "suites/b.toml")).unwrap();
    assert!(text.contains("path = \"q.csv\""), "{text}");
    // Data may come later.
    let told = expect(0, &["corpus", "new", &at(&folder, "e.toml"), "--points", "later.csv"]);
    assert!(told.stderr.contains("later.csv is not there; the suite needs it to run"), "{}", told.stderr);
    expect(104, &["corpus", "verify", &at(&folder, "e.toml")]);
    write(&folder, "later.csv", "0,0\n1,0\n0,1\n");
    expect(0, &["corpus", "verify", &at(&folder, "e.toml")]);
}

#[test]
fn data_that_do_not_fit_make_no_suite() {
    let folder = tempdir().unwrap();
    write(&folder, "odd.csv", "id,a,b\n1,2,3\n");
    write(&folder, "bad.csv", "id,lon,lat\n1,2,x\n");
    write(&folder, "two.csv", "0,0\n1,0\n");
    write(&folder, "flat.csv", "0,0\n1,0\n0,1\n1,1\n");
    write(&folder, "m.off", "OFF\n1 0 0\n0 0\n");
    write(&folder, "p.dat", "0,0\n");
    let file = at(&folder, "mine.toml");
    for (data, more, said) in [
        (
            "odd.csv",
            &[][..],
            "odd.csv:1: the columns are id, a, b; name the columns of x and y, or give their \
          numbers from 1",
        ),
        ("odd.csv", &["--columns", "a,c"], "odd.csv:1: there is no column `c`: the columns are id, a, b"),
        ("bad.csv", &[], "bad.csv:2: column `lat`: `x` is not a number"),
        ("two.csv", &[], "two.csv: 2 points are too few: orient2d takes 3; add points"),
        ("flat.csv", &["--task", "orient3d"], "flat.csv: orient3d takes points of 3, not of 2 coordinates; give"),
        ("m.off", &[], "m.off:"),
        ("p.dat", &[], "p.dat: the file name does not show its format"),
    ] {
        let refused = expect(104, &[&["corpus", "new", &file, "--points", data], more].concat());
        assert!(refused.stderr.contains(said) && refused.stdout.is_empty(), "{data}: {}", refused.stderr);
        assert_eq!(refused.stderr.lines().count(), 1, "{}", refused.stderr);
        assert!(!folder.path().join("mine.toml").exists(), "{data}: nothing is written");
    }
}

#[test]
fn a_file_is_overwritten_only_with_leave() {
    let folder = tempdir().unwrap();
    let file = write(&folder, "mine.toml", "title = \"mine\"\n");
    let refused = expect(2, &["corpus", "new", &file]).stderr;
    assert!(refused.contains("mine.toml: the file is there; name another, or overwrite it with --force"), "{refused}");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "title = \"mine\"\n");
    // What is wrong leaves the file as it is, even then.
    write(&folder, "bad.csv", "1,x\n");
    expect(104, &["corpus", "new", &file, "--force", "--points", "bad.csv"]);
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "title = \"mine\"\n");
    expect(0, &["corpus", "new", &file, "--force"]);
    expect(0, &["corpus", "verify", &file]);
}
