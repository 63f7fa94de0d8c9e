//! Cells of a line and unions of cubes, from end to end.

use crate::common::{at, column, expect, read, write};
use tempfile::tempdir;

#[test]
fn cells_are_judged_replayed_and_timed() {
    let folder = tempdir().unwrap();
    let (out, bench) = (at(&folder, "run"), at(&folder, "bench"));
    let scenes = ["intervals", "-f", "three-cells|neighbours", "-b", "exact,sos,epsilon:1e-10"];
    expect(0, &[&["run"][..], &scenes, &["--out", &out]].concat());
    expect(0, &["gate", &out]);
    let findings = read(&out, "findings.csv");
    let told = expect(0, &["replay", &column(&findings, "finding_id")[0], "--run", &out, "-b", "exact,sos"]);
    for needle in ["interval(", "  vertex ", "at the end of", "  exact  ", "  sos  "] {
        assert!(told.stdout.contains(needle), "{needle}: {}", told.stdout);
    }
    expect(0, &[&["bench"][..], &scenes, &["--samples", "1", "--sample-ms", "0", "--out", &bench]].concat());
    assert_eq!(column(&read(&bench, "throughput.csv"), "task"), ["interval"; 6]);
}

#[test]
fn unions_are_measured_timed_and_reported() {
    let folder = tempdir().unwrap();
    let (out, bench, report) = (at(&folder, "run"), at(&folder, "bench"), at(&folder, "report"));
    let scenes = ["cubes", "-f", "corner-in-corner|twins|cubes-lattice-touching", "-b", "exact,sos"];
    expect(0, &[&["run"][..], &scenes, &["--out", &out]].concat());
    expect(0, &["gate", &out]);
    let masses = read(&out, "masses.csv");
    let [volume, truth] = ["volume", "true_volume"].map(|name| column(&masses, name));
    assert_eq!(volume.len(), 6);
    assert_eq!(volume, truth, "{masses}");
    let [edges, expected] = ["edge_length", "limit_edge_length"].map(|name| column(&masses, name));
    assert_eq!(edges, expected, "{masses}");
    let twins = |row: &usize| column(&masses, "scene")[*row] == "twins";
    let of_twins: Vec<&str> = (0..6).filter(twins).map(|row| edges[row].as_str()).collect();
    assert_eq!(of_twins, ["12.0", "36.0"], "one cube, or steps: {masses}");
    expect(0, &[&["bench"][..], &scenes, &["--samples", "1", "--sample-ms", "0", "--out", &bench]].concat());
    expect(0, &["report", &out, &bench, "--out", &report]);
    let markdown = read(&report, "report.md");
    for needle in ["## Unions of cubes", "corner-in-corner (cubes) | sos | 2 | 15.0000 |", "## Ties"] {
        assert!(markdown.contains(needle), "{needle}: {markdown}");
    }
    // Comparisons have one term.
    assert!(markdown.contains("\n| cube-union | sos | "), "{markdown}");
}

#[test]
fn a_file_of_cubes_is_run_or_refused_by_its_line() {
    let folder = tempdir().unwrap();
    let suite = "title = \"t\"\n[[scene]]\nname = \"a\"\ntask = \"cube-union\"\ncubes = { path = \"cubes.csv\" }\n";
    let suite = write(&folder, "mine.toml", suite);
    write(&folder, "cubes.csv", "# x, y, z, edge\n0, 0, 0, 2\n1, 1, 1, 2\n");
    let out = at(&folder, "run");
    expect(0, &["run", &suite, "-b", "exact,sos", "--out", &out]);
    assert_eq!(column(&read(&out, "masses.csv"), "volume"), ["15.0", "15.0"]);
    write(&folder, "cubes.csv", "# x, y, z, edge\n0, 0, 0, 2\n1, 1, 1, 3\n");
    let told = expect(104, &["run", &suite, "-b", "exact", "--out", &at(&folder, "other")]);
    assert!(told.stderr.contains("cubes.csv:3: cube 1: the edge length is 3"), "{}", told.stderr);
}

/// Measures that are not doubles are printed as zero or infinite, but judged exactly.
#[test]
fn cubes_of_any_size_are_judged() {
    let folder = tempdir().unwrap();
    let scene = |name: &str, size: &str| {
        format!("[[scene]]\nname = \"{name}\"\ntask = \"cube-union\"\ncubes = [[0, 0, 0, \"{size}\"]]\n")
    };
    let suite = format!("title = \"Sizes\"\n{}{}", scene("tiny", "0x1p-400"), scene("huge", "0x1p600"));
    let (suite, out) = (write(&folder, "sizes.toml", &suite), at(&folder, "run"));
    expect(0, &["run", &suite, "-b", "exact,sos", "--out", &out]);
    assert_eq!(column(&read(&out, "masses.csv"), "true_volume"), ["0.0", "0.0", "inf", "inf"]);
    expect(0, &["report", &out, "--out", &at(&folder, "report")]);
}
