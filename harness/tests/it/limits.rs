//! Limits of time and of samples.

use std::time::{Duration, Instant};

use tempfile::tempdir;

use crate::common::{SUITE, assert_same_tables, at, column, expect, read, run, write};

#[test]
fn a_timeout_is_counted_and_the_run_incomplete() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "run");
    let told =
        expect(103, &["run", "classics", "-f", "kettner-a1$", "-b", "exact,naive", "--timeout", "1e-9", "--out", &out]);
    assert!(told.stdout.contains("1 timeout"), "{}", told.stdout);
    assert_eq!(column(&read(&out, "summary.csv"), "timeout"), ["1", "1"]);
    // A timeout is an unexpected finding.
    expect(100, &["gate", &out]);
}

/// A suite with cubes that take minutes, followed by a scene of signs.
fn endless() -> String {
    let cubes = "[[generate]]\nfamily = \"cubes-uniform\"\ntask = \"cube-union\"\nn = 300000\nseed = 1\n\
                 density = 60.0\nsource = \"ours\"\nanalysis = \"Takes long.\"\n";
    SUITE.replacen("[[scene]]", &format!("{cubes}\n[[scene]]"), 1)
}

#[test]
fn an_algorithm_that_looks_at_no_clock_is_ended_and_the_run_goes_on() {
    let folder = tempdir().unwrap();
    let (suite, out) = (write(&folder, "endless.toml", &endless()), at(&folder, "run"));
    let start = Instant::now();
    let told = run(&["run", &suite, "-b", "exact,sos", "--timeout", "0.2", "--out", &out]);
    assert_eq!(told.code, 103, "{}", told.stderr);
    assert!(start.elapsed() < Duration::from_secs(20), "it took {:?}", start.elapsed());
    let summary = read(&out, "summary.csv");
    let rows: Vec<_> = column(&summary, "scene").into_iter().zip(column(&summary, "timeout")).collect();
    let late: Vec<bool> = rows.iter().map(|(scene, _)| scene.starts_with("cubes")).collect();
    assert_eq!(late, [true, true, false, false, false, false], "{summary}");
    assert!(rows.iter().zip(late).all(|((_, timeout), late)| (timeout == "1") == late), "{summary}");
    assert!(read(&out, "findings.csv").contains("took longer than 200ms"));
}

#[test]
fn a_process_of_its_own_finds_the_same() {
    let folder = tempdir().unwrap();
    let (plain, apart) = (at(&folder, "plain"), at(&folder, "apart"));
    let scenes = ["run", "-f", "cubes/(twins|slide)|contacts/tetrahedra|three-cells", "-b", "exact,sos"];
    run(&[&scenes[..], &["--out", &plain]].concat());
    run(&[&scenes[..], &["--timeout", "600", "--out", &apart]].concat());
    assert_same_tables(&plain, &apart, "judged in a process of its own");
    assert_eq!(column(&read(&apart, "judged.csv"), "backend").len(), 4 * 2);
}

#[test]
fn no_permutation_is_asked_where_none_is_paid_for() {
    let folder = tempdir().unwrap();
    let permuted = |permutations: &str| {
        let out = at(&folder, &format!("run{permutations}"));
        run(&[
            "run",
            "-f",
            "kettner-[ab]|contacts/polygons-degen",
            "-b",
            "naive,fault:sos-dropped-parity",
            "--permutations",
            permutations,
            "--out",
            &out,
        ]);
        let checks = column(&read(&out, "findings.csv"), "check");
        ["antisymmetry", "argument order"].map(|name| checks.iter().any(|check| check == name))
    };
    assert_eq!(permuted("5000"), [true, true]);
    assert_eq!(permuted("0"), [false, false]);
}
