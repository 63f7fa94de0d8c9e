//! Points in meshes through the tool: refusals with their places, answers, and output files.

use crate::common::{Told, at, column, expect, read, write};
use tempfile::{TempDir, tempdir};

const HEAD: &str = "title = \"t\"\n[[scene]]\nname = \"a\"\ntask = \"mesh-locate\"\n";
const POINTS: &str = "points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [5, 5, 5]]\n";
const CLOSED: &str = "[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]";
const OFF: &str = "OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

/// The one-line message of the tool, without the folder.
fn said(folder: &TempDir, told: &Told) -> String {
    assert_eq!(told.stderr.lines().count(), 1, "{}", told.stderr);
    let line = told.stderr.trim_end().replace(&format!("{}/", folder.path().display()), "");
    line.strip_prefix("predicament: ").expect("the tool's name").to_owned()
}

#[test]
fn meshes_that_are_none_are_refused_where_they_are_written() {
    let folder = tempdir().unwrap();
    let open = |line: usize, region: usize, ends: [usize; 2], of: usize, first: &str| {
        let [a, b] = ends;
        format!(
            "s.toml:{line}: region {region} is not closed at the edge of vertices {a} and {b}: its {of} triangle(s) there, such as {first}, do not use the edge equally often in both directions; close the mesh, turn the triangle over, or "
        )
    };
    let none = "s.toml:2: a mesh without triangles; give it some";
    let cure = "write for each face the region in front of it and the one behind, 0 for outside";
    let of = |written: &str| format!("{POINTS}triangles = [{CLOSED}]\n{written}");
    let regions = |written: &str| of(&format!("regions = [{written}]"));
    let tetrahedra = |written: &str| format!("{POINTS}tetrahedra = [\n{written}]");
    let triangles = |written: &str| format!("{POINTS}triangles = [\n{written}]");
    let cases = [
        (triangles("[0, 2, 1],\n[0, 1, 3],\n[1, 2, 3]"), open(7, 0, [0, 2], 1, "0 (line 7)") + "give each"),
        (triangles(&format!("{CLOSED},\n[0, 1, 4]")), open(7, 0, [0, 1], 3, "1 (line 7)") + "give each"),
        (triangles("[0, 2, 1],\n[0, 1, 3],\n[1, 2, 3],\n[0, 2, 3]"), open(7, 0, [0, 2], 2, "0 (line 7)") + "give each"),
        (regions("[0, 1], [0, 1], [0, 1], [0, 2]"), open(6, 1, [0, 2], 2, "0 (line 6)") + "correct its regions at s.toml:7"),
        (triangles(""), none.into()),
        (tetrahedra(""), none.into()),
        ("points = []\ntriangles = []".into(), "s.toml:5: a scene without points; write at least one point".into()),
        (POINTS.into(), "s.toml:2: a mesh without `triangles` or `tetrahedra`; write `mesh`, or `points` with".into()),
        (regions("[0, 1], [0, 1]"), format!("s.toml:7: 2 pairs of regions for 4 faces; {cure}")),
        (regions("[0, 1, 2]"), format!("s.toml:7: 3 regions for one face; {cure}")),
        (regions("[0, -1]"), "s.toml:7: `regions` is -1; choose an integer from 0 to 2147483648".into()),
        (regions("[0, 4294967297]"), "s.toml:7: `regions` is 4294967297; choose an integer".into()),
        (of("regions = 5"), "s.toml:7: `regions` is of type integer; write pairs of region numbers, or".into()),
        (triangles("[0, 2, 1],\n[0, 1, 9]"), "s.toml:8: triangle 1 (line 8) has vertex 9, but the mesh has no such".into()),
        (triangles("[0, 2, 1],\n[0, 1, 1]"), "s.toml:8: triangle 1 (line 8) has vertex 1 twice; remove it".into()),
        (triangles("[0, 2]"), "s.toml:7: a triangle of 2 corners; give it 3".into()),
        (
            tetrahedra("[0, 1, 2, 3],\n[0, 1, 2, 4]"),
            "s.toml:8: tetrahedra 0 (line 7) and 1 (line 8) are on the same side of the face of vertices 1, 0 and 2; remove".into(),
        ),
        (
            tetrahedra("[0, 1, 2, 3],\n[0, 1, 3, 4],\n[0, 1, 2, 3]"),
            "s.toml:9: tetrahedra 0 (line 7) and 2 (line 9) are on the same side of the face".into(),
        ),
        (tetrahedra("[0, 1, 2, 2]"), "s.toml:7: the tetrahedron of 0, 1, 2 and 2 has no volume; remove it".into()),
        (tetrahedra("[0, 1, 2, 9]"), "s.toml:7: index 9 is out of range: the mesh has 5 points; indices".into()),
        (
            tetrahedra("[0, 1, 2, 3]") + "\nregions = [[0, 1]]",
            "s.toml:8: `regions` beside `tetrahedra`; remove it: each tetrahedron is a region, the first is 1".into(),
        ),
        (
            of("tetrahedra = [[0, 1, 2, 3]]"),
            "s.toml:7: both `triangles` and `tetrahedra`; keep one: the tool finds the triangles of tetrahedra".into(),
        ),
        (of("mesh = { path = \"m.off\" }"), "s.toml:5: both `mesh` and `points`; remove this one: the file has".into()),
        (
            "points = [[0, 0], [1, 0], [0, 1]]\ntriangles = [[0, 1, 2]]".into(),
            "s.toml:5: `points` have 2 coordinates each; meshes need 3; give every point 3".into(),
        ),
        (of("probes = [[1, 1]]"), "s.toml:7: a probe with 2 coordinates; give it three".into()),
        (of("probes = [1, 1, 1]"), "s.toml:7: `probes` is of type integer; write three coordinates".into()),
        (of("probes = [[1, 1, nan]]"), "s.toml:7: coordinate `nan` is not finite; remove the point".into()),
        (of("probes = [[\"a\", 1, 1]]"), "s.toml:7: `a` is not a number; write a decimal or a hex float".into()),
        (of("probes = { path = \"p.csv\" }"), "s.toml:7: with p.csv: `probes` have 2 coordinates each; meshes need 3".into()),
        (of("random = 100000000"), "s.toml:2: a mesh with 100000036 probes has too many coordinates: a scene has at most 268435456".into()),
        ("mesh = { path = \"p.csv\" }".into(), "p.csv: the file is not a mesh; name a .off, .obj, .ply or .stl file".into()),
    ];
    write(&folder, "p.csv", "1,1\n");
    let out = at(&folder, "out");
    for (at, (scene, expected)) in cases.into_iter().enumerate() {
        let suite = write(&folder, "s.toml", &format!("{HEAD}{scene}\n"));
        let found = said(&folder, &expect(104, &["corpus", "verify", &suite]));
        if at == 0 {
            // A run gives the same message.
            assert_eq!(said(&folder, &expect(104, &["run", &suite, "-b", "exact", "--out", &out])), found);
        }
        assert!(found.starts_with(&expected), "{scene}: {found}\n  expected {expected}");
    }
}

#[test]
fn what_meshes_may_be_is_answered() {
    let folder = tempdir().unwrap();
    let with = |points: &str| format!("points = [{points}]\ntriangles = [{CLOSED}]\nrandom = 20\n");
    let twice = |more: &str| {
        format!(
            "points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], {more}]\n\
             triangles = [{CLOSED}, [4, 6, 5], [4, 5, 7], [5, 6, 7], [6, 4, 7]]\nprobes = [[1.25, 1.25, 1.25]]\n"
        )
    };
    let cases = [
        ("no area", with("[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]"), 0),
        ("all in one place", with("[0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]"), 0),
        (
            "1e300 beside 1e-300",
            "round = true\n".to_owned()
                + &with("[\"-1e300\", 0, 0], [\"1e300\", 0, 0], [0, \"1e300\", 0], [0, 0, \"1e-300\"]"),
            0,
        ),
        ("two that cross", twice("[1, 1, 1], [5, 1, 1], [1, 5, 1], [1, 1, 5]"), 1),
        ("one region in itself", twice("[-9, -9, -9], [40, 0, 0], [0, 40, 0], [0, 0, 40]"), 1),
        (
            "inside out",
            with("[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]") + "regions = [[1, 0], [1, 0], [1, 0], [1, 0]]",
            1,
        ),
        (
            "the largest region",
            with("[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]")
                + "regions = [[0, 2147483648], [0, 2147483648], [0, 2147483648], [0, 2147483648]]",
            0,
        ),
    ];
    for (what, scene, contradicts) in cases {
        let suite = write(&folder, "s.toml", &format!("{HEAD}{scene}\n"));
        let out = at(&folder, what);
        expect(0, &["run", &suite, "-b", "exact", "--out", &out]);
        let summary = read(&out, "summary.csv");
        assert_eq!(column(&summary, "agree"), column(&summary, "queries"), "{what}");
        let located = column(&read(&out, "mesh_locate.csv"), "contradictions");
        let contradictions: u64 = located.iter().map(|count| count.parse::<u64>().unwrap()).sum();
        assert_eq!(u64::from(contradictions > 0), contradicts, "{what}");
    }
}

#[test]
fn tetrahedra_that_cross_are_no_fault_of_a_backend() {
    let folder = tempdir().unwrap();
    let suite = format!(
        "{HEAD}points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [1, 1, 1], [5, 1, 1], [1, 5, 1], [1, 1, 5]]\n\
         tetrahedra = [[0, 1, 2, 3], [4, 5, 6, 7]]\nprobes = [[1.25, 1.25, 1.25]]\nquick_stride = 0\n"
    );
    let (suite, out) = (write(&folder, "s.toml", &suite), at(&folder, "out"));
    expect(0, &["run", &suite, "-b", "exact,sos,tolerance", "--answers", "--out", &out]);
    let answers = read(&out, "answers.csv");
    assert_eq!(column(&answers, "answer"), ["in no one region"; 3]);
    // A point in the band of the mesh has no region either, if the mesh contradicts itself.
    let suite = std::fs::read_to_string(&suite).unwrap().replace("quick_stride = 0", "quick_stride = 1");
    let (suite, out) = (write(&folder, "all.toml", &suite), at(&folder, "all"));
    expect(0, &["run", &suite, "-b", "exact,tolerance", "--out", &out]);
    assert_eq!(column(&read(&out, "summary.csv"), "in_band").iter().filter(|count| *count != "0").count(), 1);
    assert!(answers.contains("in no one region; winding numbers 0: -1, 1: 1, 2: 1"), "{answers}");
}

#[test]
fn regions_and_probes_come_from_files() {
    let folder = tempdir().unwrap();
    let mesh = write(&folder, "m.off", OFF);
    let probes = write(&folder, "p.csv", "x,y,z\n1,1,1\n1,1,0\n9,9,9\n");
    let out = at(&folder, "out");
    let solve = |code: i32, regions: &str| {
        let path = write(&folder, "r.csv", regions);
        let set = format!("regions={{ path = \"{path}\" }}");
        let args = ["solve", "mesh-locate", &mesh, &probes, "--set", "quick_stride=0", "--set", &set, "--out", &out];
        expect(code, &args)
    };
    for good in ["front,behind\n0,7\n0,7\n0,7\n0,7\n", "# in front, behind\n0 7\n0 7\n\n0 7\n0 7\n"] {
        solve(0, good);
        assert_eq!(
            read(&out, "probes.csv"),
            "vertex,kind,x,y,z,answer,region,triangle,label\n\
             0,given,1.0,1.0,1.0,in,7,,7\n\
             6,given,1.0,1.0,0.0,on,,0,-2\n\
             1,given,9.0,9.0,9.0,in,0,,0\n"
        );
    }
    let cure = "write for each face the region in front of it and the one behind, 0 for outside";
    let integer = "write an integer from 0 to 2147483648";
    for (bad, expected) in [
        ("0,1\n0,1\n\n0,1\n", format!("r.csv:4: 3 pairs of regions for 4 faces; {cure}")),
        ("0,1\n0,1\n0,1\n0,1\n0,1\n0,1\n", format!("r.csv:5: 6 pairs of regions for 4 faces; {cure}")),
        ("0,1\n0,-1\n", format!("r.csv:2: `-1` is not a region number; {integer}")),
        ("0,1\n0.5,1\n", format!("r.csv:2: `0.5` is not a region number; {integer}")),
        (
            "0,1\n0,0.1000000000000000001\n",
            format!("r.csv:2: decimal 0.1000000000000000001 has digits that no double holds; {integer}"),
        ),
        ("0,2147483649\n", format!("r.csv:1: `2147483649` is not a region number; {integer}")),
        ("0,steel\n", "r.csv:1: `steel` is not a number; write a decimal or a hex".to_owned()),
        ("0,1,2\n", format!("r.csv:1: pair 0 has 3 regions; {cure}")),
        ("", "r.csv: the file has no pairs; write one pair a line".to_owned()),
    ] {
        let found = said(&folder, &solve(104, bad));
        assert!(found.starts_with(&expected), "{bad}: {found}\n  expected {expected}");
    }
    let found = said(&folder, &solve(104, "front,behind\n0,1\n0,1\n0,1\n0,2\n"));
    assert!(
        found.starts_with("m.off:7: region 1 is not closed at the edge of vertices 0 (line 3) and 2 (line 5): "),
        "{found}"
    );
    assert!(found.ends_with("or correct its regions at r.csv:2"), "{found}");
    // A quadrilateral is one face with two triangles.
    let quads = "OFF\n5 5 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n2 2 4\n4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
    let mesh = write(&folder, "m.off", quads);
    let regions = write(&folder, "r.csv", "0,3\n0,3\n0,3\n0,3\n0,3\n");
    let set = format!("regions={{ path = \"{regions}\" }}");
    expect(
        0,
        &[
            "solve",
            "mesh-locate",
            &mesh,
            "--set",
            "probes=[[2, 2, 1]]",
            "--set",
            "quick_stride=0",
            "--set",
            &set,
            "--out",
            &out,
        ],
    );
    assert_eq!(column(&read(&out, "probes.csv"), "region"), ["3"]);
}

#[test]
fn solve_says_how_to_round_what_is_set() {
    let folder = tempdir().unwrap();
    let (mesh, out) = (write(&folder, "m.off", OFF), at(&folder, "out"));
    let args = ["solve", "mesh-locate", &mesh, "--set", "probes=[[0.1000000000000000001, 1, 1]]", "--out", &out];
    let found = said(&folder, &expect(2, &args));
    assert_eq!(
        found,
        "mesh-locate: decimal 0.1000000000000000001 has digits that no double holds; add --round to read the nearest doubles"
    );
    expect(0, &[&args[..], &["--round"]].concat());
}

#[test]
fn findings_are_replayed_and_counted_in_the_report() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "run");
    expect(0, &["run", "mesh-points", "-f", "/two-tetrahedra$", "-b", "exact,naive:first", "--out", &out]);
    let findings = read(&out, "findings.csv");
    let (id, got) = (&column(&findings, "finding_id")[0], &column(&findings, "got")[0]);
    let told = expect(0, &["replay", id, "--run", &out]).stdout;
    assert!(told.contains(&format!("\n  naive:first              {got}\n")), "{told}");
    assert!(told.contains("\n  truth                    on triangle 5; the corners of triangle 5 are "), "{told}");
    assert!(told.contains("\n  exact                    on triangle 5\n"), "{told}");
    let pages = at(&folder, "pages");
    expect(0, &["report", &out, "--out", &pages]);
    let page = read(&pages, "report.md");
    let section = page.split("## Points in meshes").nth(1).expect("the section");
    let row = section.lines().find(|line| line.contains("| ulp | naive:first |")).expect("a row");
    assert!(row.ends_with("| 1 |"), "one is lost: {row}");
}

#[test]
fn phases_are_timed_one_by_one_and_the_report_plots_their_growth() {
    let folder = tempdir().unwrap();
    write(&folder, "m.off", OFF);
    let torus = |n: usize| {
        format!(
            "[[generate]]\nname = \"torus-{n}\"\nfamily = \"locate-torus\"\ntask = \"mesh-locate\"\nn = {n}\nquick_stride = 0\nrandom = 30\n"
        )
    };
    let read_one = "[[scene]]\nname = \"file\"\ntask = \"mesh-locate\"\nmesh = { path = \"m.off\" }\nrandom = 3\n";
    let other =
        "[[scene]]\nname = \"none\"\ntask = \"orient2d\"\npoints = [[0, 0], [1, 0], [0, 1]]\nqueries = [[0, 1, 2]]\n";
    let suite = format!("title = \"t\"\n{}{}{}{read_one}{other}", torus(100), torus(200), torus(400));
    let suite = write(&folder, "s.toml", &suite);
    let bench = |name: &str| {
        let out = at(&folder, name);
        let more = ["-b", "exact,sos", "--threads", "2", "--samples", "2", "--sample-ms", "0", "--out", &out];
        expect(0, &[&["bench", &suite][..], &more].concat());
        out
    };
    let (one, two) = (bench("one"), bench("two"));
    let phases = read(&one, "phases.csv");
    let of = |name: &str| column(&phases, name);
    let rows: Vec<[String; 5]> = (0..of("scene").len())
        .map(|row| ["scene", "phase", "backend", "threads", "sample"].map(|name| of(name)[row].clone()))
        .collect();
    let mut expected = Vec::new();
    for (scene, first) in [("torus-100", 1), ("torus-200", 1), ("torus-400", 1), ("file", 0)] {
        for sample in ["0", "1"] {
            for (backend, phases) in [
                ("", &["reading", "checking", "grid"][first..]),
                ("exact", &["labels", "queries"]),
                ("sos", &["labels", "queries"]),
            ] {
                for threads in ["1", "2"] {
                    expected
                        .extend(phases.iter().map(|phase| [scene, phase, backend, threads, sample].map(str::to_owned)));
                }
            }
        }
    }
    assert_eq!(rows, expected);
    for (phase, (unit, bytes)) in of("phase").iter().zip(of("unit").iter().zip(of("bytes"))) {
        assert_eq!(unit == "query", phase == "queries");
        assert_eq!(bytes.is_empty(), ["queries", "reading"].contains(&phase.as_str()), "{phase}");
    }
    let sizes = of("size").into_iter().zip(of("count")).zip(of("unit")).filter(|(_, unit)| unit == "triangle");
    assert!(sizes.map(|((size, count), _)| (size == count).then_some(size)).all(|size| size.is_some()));
    // The whole pass is timed with both numbers of threads as well.
    let families = column(&read(&one, "throughput.csv"), "family");
    assert!(
        ["locate-torus", "locate-torus on 2 threads", "file on 2 threads"]
            .iter()
            .all(|name| families.contains(&(*name).to_owned()))
    );
    // Timings of two folders are shown side by side.
    let pages = at(&folder, "pages");
    expect(0, &["report", &one, &two, "--out", &pages]);
    let page = read(&pages, "report.md");
    let section = page.split("\n## Phases\n").nth(1).expect("the section");
    assert!(
        section.contains("(growth-mesh-locate-torus.svg)")
            && section.contains("| 1 | mesh-locate | torus-100 (s) | 98 | grid (a triangle) | — | 2 |")
            && section.contains("The first 30 of "),
        "{section}"
    );
    for (file, line) in [
        ("growth-mesh-locate-torus.svg", "1: grid, a triangle"),
        ("growth-mesh-locate-torus-sos.svg", "2: queries, a query"),
    ] {
        let growth = read(&pages, file);
        assert!(growth.contains(line), "{growth}");
    }
    assert!(!section.contains("(growth-mesh-locate-file"), "one size grows into nothing");
}
