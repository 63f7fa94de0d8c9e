//! The studies from end to end: exit codes, files, and the suite that `parity` writes.

use crate::common::{at, column, expect, read, run, write};
use tempfile::tempdir;

#[test]
fn what_is_proved_keeps_the_laws_and_what_rounds_breaks_them() {
    let told = expect(0, &["study", "laws", "-b", "exact,sos", "--tuples", "20000", "--format", "csv"]);
    let numbers = |name: &str| column(&told.stdout, name).iter().map(|n| n.parse::<u64>().unwrap()).collect::<Vec<_>>();
    let [tuples, violations, panics] = ["tuples", "violations", "panics"].map(numbers);
    assert!(tuples.iter().sum::<u64>() >= 2 * 20_000, "{}", told.stdout);
    assert!(violations.iter().chain(&panics).all(|&n| n == 0), "{}", told.stdout);
    for law in ["never-zero", "antisymmetry", "transitivity", "grassmann-plucker", "mixed-grassmann-plucker"] {
        assert!(column(&told.stdout, "law").iter().any(|name| name == law), "{law}");
    }
    let tuples = predicament_effort::some_or_all("2000", "20000");
    let told = expect(100, &["study", "laws", "-b", "naive,fault:sos-place-as-identity", "--tuples", tuples]);
    for needle in ["| antisymmetry", "naive", "orient2d(xy; ", "equals-exact"] {
        assert!(told.stdout.contains(needle), "{needle}: {}", told.stdout);
    }
}

#[test]
fn mistakes_are_answered_with_what_there_is() {
    assert!(expect(2, &["study", "laws", "-b", "exat"]).stderr.contains("no backend is called `exat`"));
    expect(2, &["study", "laws", "--format", "xml"]);
}

#[test]
fn the_smallest_scenes_read_back_and_still_cross_an_odd_number_of_times() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "out");
    let told = expect(
        0,
        &["study", "parity", "--pairs", "300", "--seed", "3", "--shrink", "3", "--threads", "2", "--out", &out],
    );
    assert_eq!(told.stdout, format!("{}\n{out}\n", read(&out, "parity.md")));
    assert_eq!(column(&read(&out, "parity.csv"), "pairs"), ["900"; 6]);
    let (suite, again) = (format!("{out}/smallest.toml"), at(&folder, "again"));
    // findings are unexpected, because no expectations are given
    expect(100, &["run", &suite, "-b", "exact,sos,tolerance,tolerance:f32", "--out", &again]);
    let summary = read(&again, "summary.csv");
    let scenes = column(&summary, "scene");
    let odd = column(&summary, "topology");
    assert!(scenes.iter().any(|scene| scene.contains("f64")) && scenes.iter().any(|scene| scene.contains("f32")));
    for ((scene, backend), odd) in scenes.iter().zip(column(&summary, "backend")).zip(odd) {
        match backend.as_str() {
            "exact" | "sos" => assert_eq!(odd, "0", "{scene} on {backend}"),
            "tolerance" if scene.contains("f64") => assert_ne!(odd, "0", "{scene} on {backend}"),
            "tolerance:f32" if scene.contains("f32") => assert_ne!(odd, "0", "{scene} on {backend}"),
            _ => {}
        }
    }
    let findings = read(&again, "findings.csv");
    assert!(findings.contains("crossing parity") && findings.contains("cross"), "{findings}");
}

#[test]
fn the_smallest_scenes_of_the_embedded_suite_are_odd_with_tolerances_alone() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "out");
    run(&["run", "contacts", "-f", "/odd-", "-b", "exact,sos,tolerance,tolerance:f32", "--out", &out]);
    let summary = read(&out, "summary.csv");
    let odd: Vec<(String, String)> = column(&summary, "scene")
        .into_iter()
        .zip(column(&summary, "backend"))
        .zip(column(&summary, "topology"))
        .filter(|(_, odd)| odd != "0")
        .map(|(pair, _)| pair)
        .collect();
    for name in ["odd-snap", "odd-bend", "odd-collapse", "odd-everywhere"] {
        assert!(odd.contains(&(name.to_owned(), "tolerance".to_owned())), "{name}: {odd:?}");
    }
    assert!(odd.contains(&("odd-everywhere-f32".to_owned(), "tolerance:f32".to_owned())), "{odd:?}");
    assert!(odd.iter().all(|(_, backend)| backend.starts_with("tolerance")), "{odd:?}");
}

#[test]
fn no_pairs_and_no_folder_are_refused() {
    assert!(expect(2, &["study", "parity", "--pairs", "0", "--out", "x"]).stderr.contains("--pairs"));
    assert!(expect(2, &["study", "parity"]).stderr.contains("--out"));
    let folder = tempdir().unwrap();
    let file = write(&folder, "file", "");
    assert!(expect(2, &["study", "parity", "--pairs", "1", "--out", &file]).stderr.contains(&file));
}

#[test]
fn an_audit_passes_though_what_is_printed_does_not() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "out");
    let decisions = if predicament_effort::whole() { "500" } else { "50" };
    let told = expect(0, &["study", "audit", "--decisions", decisions, "--out", &out]);
    assert_eq!(told.stdout, format!("{}\n{out}\n", read(&out, "audit.md")));
    let csv = read(&out, "audit.csv");
    let broken: u64 =
        ["overreach", "missed"].iter().flat_map(|name| column(&csv, name)).map(|n| n.parse::<u64>().unwrap()).sum();
    assert!(broken > 0, "{csv}");
    assert!(expect(2, &["study", "audit", "--decisions", "0"]).stderr.contains("--decisions"));
}

#[test]
fn every_planted_tolerance_and_driver_is_found() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "out");
    let decisions = if predicament_effort::whole() { "3000" } else { "1000" };
    expect(0, &["study", "audit", "--planted", "--decisions", decisions, "--out", &out]);
    let found = column(&read(&out, "reads.csv"), "misread");
    assert!(found.len() == 2 * (17 + 9) && found.iter().all(|n| n != "0"), "{found:?}");
    let numbers = column(&read(&out, "constants.csv"), "is_published");
    assert!(numbers.len() == 64 && numbers.iter().all(|said| said == "false"), "{numbers:?}");
    // too few pairs to find anything, so the audit has to fail
    expect(100, &["study", "audit", "--planted", "--decisions", "1"]);
}

#[test]
fn resolution_leaves_tables_and_plots() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "out");
    let told = expect(0, &["study", "resolution", "-b", "tolerance", "--trials", "1", "--out", &out]);
    assert_eq!(told.stdout, format!("{}\n{out}\n", read(&out, "resolution.md")));
    assert!(["resolution.svg", "location.svg"].iter().all(|name| read(&out, name).starts_with("<svg")));
    assert!(column(&read(&out, "location.csv"), "backend").iter().all(|name| name == "tolerance"));
    assert!(expect(2, &["study", "resolution", "--trials", "0", "--out", &out]).stderr.contains("--trials"));
}

/// `run` accepts the suite that `stress --suites` writes.
#[test]
fn a_break_point_is_kept_as_a_suite() {
    let folder = tempdir().unwrap();
    let (out, suites, again) = (at(&folder, "out"), at(&folder, "kept/scale"), at(&folder, "again"));
    let few =
        ["-b", "exact,naive", "-t", "insphere", "-k", "scale", "--scenes", "1", "--samples", "0", "--tuples", "0"];
    expect(0, &[&["study", "stress"][..], &few, &["--suites", &suites, "--out", &out]].concat());
    let breaks = read(&out, "breaks.csv");
    let down = breaks.lines().find(|line| line.contains(",down,naive,")).unwrap();
    let at = down.split(',').nth(5).unwrap();
    let run_at = |position: &str| {
        let suite = format!("{suites}/scale_{position}.toml");
        run(&["run", &suite, "-b", "exact,naive", "--out", &format!("{again}{position}")]);
        let summary = read(&format!("{again}{position}"), "summary.csv");
        // A product that underflows to zero is an overreach.
        let classes = ["sign_flip", "missed_zero", "overreach"].map(|class| column(&summary, class));
        let backends = column(&summary, "backend").into_iter().enumerate();
        backends.map(|(at, backend)| (backend, classes.iter().any(|class| class[at] != "0"))).collect::<Vec<_>>()
    };
    assert_eq!(run_at(at), [("exact".to_owned(), false), ("naive".to_owned(), true)]);
    assert_eq!(run_at("0"), [("exact".to_owned(), false), ("naive".to_owned(), false)]);
}
