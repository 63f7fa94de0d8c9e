//! Ordinary tables: points in some columns of a CSV file, asked about in one command.

use std::io::Write as _;
use std::process::Stdio;

use crate::common::{Told, at, column, expect, read, told, tool, write};
use tempfile::{TempDir, tempdir};

/// Rows of a number, a longitude, a latitude and a name, with these cells between and this sign before decimals.
fn towns(rows: u32, separator: &str, sign: &str) -> String {
    let decimal = |whole: u32, part: u32| format!("{whole}{sign}{part:05}");
    let row = |k: u32| {
        [
            format!("{k}"),
            decimal(6 + k % 4, k * 7919 % 100_000),
            decimal(46 + k % 2, k * 104_729 % 100_000),
            format!("\"St. {k}{separator} CH\""),
        ]
        .join(separator)
    };
    let head = ["id", "lon", "lat", "name"].join(separator);
    std::iter::once(head).chain((0..rows).map(row)).map(|line| line + "\r\n").collect()
}

/// The same points alone.
fn plain(folder: &TempDir, rows: u32) -> String {
    let text: String = towns(rows, ",", ".")
        .lines()
        .map(|line| line.split(',').skip(1).take(2).collect::<Vec<_>>().join(",") + "\n")
        .collect();
    write(folder, "plain.csv", &text)
}

const ASK: [&str; 7] = ["ask", "orient2d", "-b", "exact,naive", "--format", "csv", "--points"];

fn ask(more: &[&str]) -> Told {
    expect(0, &[&ASK, more].concat())
}

fn ask_stdin(text: &str, more: &[&str]) -> Told {
    let mut child = tool(&[&ASK[..], &["-"], more].concat())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    told(child.wait_with_output().unwrap())
}

#[test]
fn a_table_has_signs_in_one_command() {
    let folder = tempdir().unwrap();
    let (table, plain) = (write(&folder, "towns.csv", &towns(3000, ",", ".")), plain(&folder, 3000));
    let expected = ask(&[&plain]);
    assert_eq!((expected.stdout.lines().count(), expected.stderr.as_str()), (1001, ""));
    let found = ask(&[&table]);
    let note = format!(
        "predicament: {table}: x is the column `lon`, y is the column `lat`; the columns id, name are not read; --columns chooses others\n"
    );
    assert_eq!((found.stdout == expected.stdout, found.stderr), (true, note));
    for columns in ["lon,lat", "2,3", "lon,3"] {
        let named = ask(&[&table, "--columns", columns]);
        assert_eq!((named.stdout == expected.stdout, named.stderr.as_str()), (true, ""), "{columns}");
    }
    let commas = write(&folder, "commas.csv", &towns(3000, ";", ","));
    assert!(ask(&[&commas, "--columns", "lon,lat"]).stdout == expected.stdout, "decimal commas");
    let piped = ask_stdin(&towns(3000, ",", "."), &[]);
    assert!(
        piped.stdout == expected.stdout && piped.stderr.starts_with("predicament: stdin: x is the column `lon`"),
        "{}",
        piped.stderr
    );
    assert!(ask_stdin(&towns(3000, ";", ","), &["--columns", "2,3"]).stdout == expected.stdout);
    // The first column is x, whatever is before it in the file.
    let turned = ask(&[&table, "--columns", "lat,lon"]).stdout;
    let flipped = |sign: &String| if sign == "+" { "-".to_owned() } else { "+".to_owned() };
    assert_eq!(column(&turned, "exact"), column(&expected.stdout, "exact").iter().map(flipped).collect::<Vec<_>>());
}

#[test]
fn latitude_before_longitude_is_read_by_name() {
    let folder = tempdir().unwrap();
    let turned = write(&folder, "t.csv", "lat,lon\n46,7\n46,8\n47,8\n");
    let found = ask(&[&turned]);
    assert!(found.stderr.contains("x is the column `lon`, y is the column `lat`; --columns"), "{}", found.stderr);
    assert_eq!(column(&found.stdout, "exact"), ["+"]);
    // A suite says so itself.
    let suite = |columns: &str| {
        let scene = format!("[[scene]]\nname = \"a\"\ntask = \"orient2d\"\npoints = {{ path = \"t.csv\"{columns} }}\n");
        write(&folder, "s.toml", &format!("title = \"t\"\n{scene}"))
    };
    let refused = expect(104, &["run", &suite(""), "-b", "exact", "--out", &at(&folder, "run")]).stderr;
    let cure = "t.csv:1: the columns are lat, lon; name the columns of x and y: `columns = [\"lon\", \"lat\"]` beside \
         `path`, or";
    assert!(refused.contains(cure), "{refused}");
    expect(0, &["run", &suite(", columns = [\"lon\", \"lat\"]"), "-b", "exact", "--out", &at(&folder, "run")]);
}

#[test]
fn what_is_wrong_with_a_table_is_one_line_with_its_column() {
    let folder = tempdir().unwrap();
    for (text, options, code, said) in [
        (
            "id,a,b\n1,2,3\n",
            &[][..],
            104,
            "t.csv:1: the columns are id, a, b; name the columns of x and y, or give their numbers from 1: `columns =",
        ),
        (
            "id,lon,lat,x\n1,2,3,4\n",
            &[],
            104,
            "t.csv:1: the columns are id, lon, lat, x; name the columns of x and y, or give their",
        ),
        (
            "id,lon,lat\n1,2,3\n",
            &["--columns", "lom,lat"],
            104,
            "t.csv:1: there is no column `lom`: the columns are id, lon, lat; did you mean `lon`?",
        ),
        (
            "id,lon,lat\n1,2,3\n",
            &["--columns", "2,4"],
            104,
            "t.csv:1: there is no column 4: the first row has 3 cells; choose numbers from 1 to 3",
        ),
        (
            "id,lon,lat\n1,2,3\n2,5\n",
            &[],
            104,
            "t.csv:3: the row has 2 cells, the header has 3: column `lat` is missing; give every row",
        ),
        ("id,lon,lat\n1,2,3\n2,5,b\n", &[], 104, "t.csv:3: column `lat`: `b` is not a number; write a decimal"),
        ("id,lon,lat\n1,2,3\n2,5,\n", &[], 104, "t.csv:3: column `lat`: `` is not a number; write a decimal"),
        (
            "id,lon,lat\n1,2,0.1000000000000000001\n",
            &[],
            104,
            "t.csv:2: column `lat`: decimal 0.1000000000000000001 has digits that no double holds; add --round to read the nearest",
        ),
        (
            "id;lon;lat\n1;2,5;3\n2;5.5;1\n",
            &[],
            104,
            "t.csv:3: `5.5` has a point, and `2,5` in line 2 has a comma: a comma may be",
        ),
        (
            "1,2\n",
            &["--columns", "lon"],
            2,
            "'--columns <COLUMNS>': 1 column for the coordinates of a point; write two or three names",
        ),
        ("1,2\n", &["--columns", "1,0"], 2, "columns are numbered from 1; write two or three names"),
        ("1,2\n", &["--columns", "1,1"], 2, "the column `1` twice; write"),
    ] {
        let table = write(&folder, "t.csv", text);
        let refused = expect(code, &[&ASK[..], &[&table], options].concat());
        let line = refused.stderr.lines().find(|line| !line.contains(" is the column "));
        assert!(
            line.is_some_and(|line| line.contains(said)) && refused.stdout.is_empty(),
            "{text:?}: {}",
            refused.stderr
        );
    }
    let mesh = write(&folder, "m.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    let refused = expect(104, &[&ASK[..], &[&mesh, "--columns", "1,2"]].concat()).stderr;
    assert!(refused.contains("m.off: only CSV files have columns; leave the columns out"), "{refused}");
    expect(2, &["ask", "orient2d", "0,0", "1,0", "0,1", "--columns", "1,2"]);
    let refused =
        expect(2, &["solve", "classics", "-f", "kettner-a1", "--columns", "1,2", "--out", &at(&folder, "x")]).stderr;
    assert!(refused.contains("--columns is for a task on files; write the key in the suite"), "{refused}");
    let refused = expect(104, &["solve", "hull3d", &mesh, "--columns", "1,2", "--out", &at(&folder, "x")]);
    assert!(refused.stderr.contains("only CSV files have columns"), "{}", refused.stderr);
    let refused = expect(2, &["solve", "slice", &mesh, "--columns", "1,2", "--out", &at(&folder, "x")]).stderr;
    assert!(refused.contains("--columns is for files of points, but slice has none; leave it out"), "{refused}");
}

#[test]
fn a_task_on_a_table_reads_its_columns() {
    let folder = tempdir().unwrap();
    let (table, plain) = (write(&folder, "towns.csv", &towns(40, ",", ".")), plain(&folder, 40));
    let (with, without) = (at(&folder, "with"), at(&folder, "without"));
    expect(0, &["solve", "hull2d", &table, "--columns", "lon,lat", "--out", &with]);
    expect(0, &["solve", "hull2d", &plain, "--out", &without]);
    assert_eq!(read(&with, "hull.geojson"), read(&without, "hull.geojson"));
    let found = expect(0, &["draw", "scene", "delaunay2d", &table, "--out", &at(&folder, "net.svg")]);
    assert!(found.stderr.contains("x is the column `lon`"), "{}", found.stderr);
    // A map has no columns, its probes have.
    let map = write(&folder, "m.wkt", "POLYGON ((0 0, 20 0, 20 50, 0 50, 0 0))");
    expect(
        0,
        &[
            "solve",
            "polygon-locate",
            &map,
            &table,
            "--columns",
            "2,3",
            "--set",
            "quick_stride=0",
            "--out",
            &at(&folder, "in"),
        ],
    );
}

#[test]
fn random_queries_are_those_of_the_seed() {
    let folder = tempdir().unwrap();
    let table = write(&folder, "towns.csv", &towns(500, ",", "."));
    let args = |queries: &str| column(&ask(&[&table, "--columns", "2,3", "--queries", queries]).stdout, "args");
    let drawn = args("random:200:7");
    assert_eq!((drawn.len(), &drawn), (200, &args("random:200:7")));
    assert_eq!(drawn[..50], args("random:50:7"));
    assert_ne!(drawn, args("random:200:8"));
    assert_eq!(args("random:200"), args("random:200:0"));
    for query in &drawn {
        let mut ids: Vec<u32> = query.split(' ').map(|id| id.parse().unwrap()).collect();
        ids.sort_unstable();
        ids.dedup();
        assert!(ids.len() == 3 && ids[2] < 500, "{query}");
    }
    for queries in ["random:0", "random:", "random:-1", "random:5:x", "random:5:1:2", "random:99999999999"] {
        let refused = expect(2, &[&ASK[..], &[&table, "--columns", "2,3", "--queries", queries]].concat());
        assert_eq!(refused.stderr.lines().count(), 1, "{queries}: {}", refused.stderr);
    }
    let few = write(&folder, "few.csv", "0,0\n1,0\n");
    let refused = expect(2, &[&ASK[..], &[&few, "--queries", "random:5"]].concat()).stderr;
    assert!(refused.contains("2 points are too few: orient2d takes 3; add points"), "{refused}");
}

/// 500 points are 166 triples and two points more.
#[test]
fn points_that_are_left_over_are_a_note() {
    let folder = tempdir().unwrap();
    plain(&folder, 500);
    let path = at(&folder, "plain.csv");
    let asked = ask(&[&path]);
    assert_eq!(asked.stdout.lines().count(), 1 + 166);
    assert_eq!(
        asked.stderr,
        "predicament: 2 of 500 points are not in a query, at the end: orient2d takes 3 points; --queries selects \
         others\n"
    );
    assert_eq!(ask(&[&path, "-q"]).stderr, "");
    assert_eq!(ask(&[&path, "--queries", "random:10"]).stderr, "");
    let scene = "title = \"t\"\n[[scene]]\nname = \"a\"\ntask = \"orient2d\"\npoints = { path = \"plain.csv\" }\n";
    let suite = write(&folder, "mine.toml", scene);
    let note = "predicament: mine/a: 2 of 500 points are not in a query, at the end: orient2d takes 3 points; \
                `queries` selects others\n";
    let out = at(&folder, "run");
    for args in [&["corpus", "verify", &suite][..], &["run", &suite, "-b", "exact", "--out", &out]] {
        let told = expect(0, args);
        assert_eq!(told.stderr.matches(note).count(), 1, "{args:?}: {}", told.stderr);
    }
    assert_eq!(column(&read(&out, "summary.csv"), "queries"), ["166"]);
}
