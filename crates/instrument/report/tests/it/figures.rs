//! The figures about a backend in tables, headlines, plots and `figures.csv`.

use std::collections::BTreeMap;

use predicament_records::{Class, Interface, PlannedScene, RunDir, Status, SummaryRow, ThroughputRow};
use predicament_report::{html, markdown, write_pages};
use proptest::prelude::*;

fn runs() -> Vec<RunDir> {
    ["../tasks/tests/data/checked", "../tasks/tests/data/timed"].map(|path| RunDir::open(path).unwrap()).into()
}

/// One run without rows.
fn empty() -> RunDir {
    let mut run = runs().remove(0);
    run.plan.scenes.clear();
    run.plan.backends.clear();
    run.summary.edit(Vec::clear);
    run.findings.edit(Vec::clear);
    run.stages.edit(Vec::clear);
    run.precision.edit(Vec::clear);
    run
}

fn scene(task: &str, family: &str, queries: u64) -> PlannedScene {
    PlannedScene {
        suite: "families".to_owned(),
        scene: format!("{family}-{task}"),
        scene_id: format!("{task}{family}"),
        task: task.to_owned(),
        family: family.to_owned(),
        queries,
    }
}

/// A result with these counts; if they are not of answers, all answers are right.
fn result(scene: &PlannedScene, backend: &str, counts: &[(Class, u64)]) -> SummaryRow {
    let mut row = SummaryRow::new(scene, backend, scene.queries, Status::Ok);
    counts.iter().for_each(|&(class, count)| *row.count_mut(class) = count);
    let is_undone = counts.iter().any(|(class, _)| !class.is_answer());
    row.agree = if is_undone { 0 } else { scene.queries - counts.iter().map(|(_, count)| count).sum::<u64>() };
    row
}

fn sample(scene: &PlannedScene, backend: &str, interface: Interface, ns_per_query: f64) -> ThroughputRow {
    ThroughputRow {
        task: scene.task.clone(),
        family: scene.family.clone(),
        backend: backend.to_owned(),
        interface,
        engine_version: "1".to_owned(),
        queries: scene.queries,
        sample: 0,
        ns_per_query,
    }
}

/// `figures.csv`, row by row, by column.
fn figures(runs: &[RunDir]) -> Vec<BTreeMap<String, String>> {
    let folder = tempfile::tempdir().unwrap();
    write_pages(runs, &[], &[], folder.path()).unwrap();
    let mut reader = csv::Reader::from_path(folder.path().join("figures.csv")).unwrap();
    reader.deserialize().map(Result::unwrap).collect()
}

/// The row of a backend over everything, for this interface.
fn overall(runs: &[RunDir], backend: &str, interface: &str) -> BTreeMap<String, String> {
    let row = |row: &BTreeMap<String, String>| {
        row["panel"] == "all" && row["backend"] == backend && row["interface"] == interface
    };
    figures(runs).into_iter().find(row).unwrap_or_else(|| panic!("no row of {backend}, {interface}"))
}

/// The line of a backend in the table of the first screen.
fn glance(runs: &[RunDir], backend: &str) -> String {
    let page = markdown(runs, &[]).unwrap();
    let rest = page.split_once("## Which backend to use").expect("the section").1;
    rest.lines().find(|line| line.starts_with(&format!("| `{backend}` |"))).expect("its row").to_owned()
}

/// The families of the audit: five of seven are easy for all; on `wide` shewchuk is wrong 5,329 times, and tolerance
/// declines.
fn with_wide(backends: &[&str]) -> Vec<RunDir> {
    let mut run = empty();
    for family in ["uniform", "grid", "near", "degen", "far", "wide", "wider"] {
        let scene = scene("orient2d", family, 10_000);
        for &backend in backends {
            let is_wide = family.starts_with("wide");
            let counts: &[(Class, u64)] = match backend {
                "shewchuk" if family == "wide" => &[(Class::SignFlip, 5_000)],
                "shewchuk" if family == "wider" => &[(Class::MissedZero, 329)],
                "tolerance" if is_wide => &[(Class::Declined, 1)],
                "tolerance" => &[(Class::InBand, 6_000)],
                "naive" => &[(Class::SignFlip, 1)],
                _ => &[],
            };
            let row = result(&scene, backend, counts);
            if row.has_answers() {
                let ns = match backend {
                    "naive" => 1.0,
                    "tolerance" => 1.1,
                    "exact" => 1.5,
                    _ => 4.0,
                };
                run.throughput.push(sample(&scene, backend, Interface::Single, ns));
            }
            run.summary.push(row);
        }
        run.plan.scenes.push(scene);
    }
    run.plan.backends = backends.iter().map(|&name| name.to_owned()).collect();
    vec![run]
}

#[test]
fn what_a_third_backend_declines_is_still_an_error_of_the_others() {
    for backends in [&["exact", "naive", "shewchuk"][..], &["exact", "naive", "shewchuk", "tolerance"]] {
        let row = overall(&with_wide(backends), "shewchuk", "single");
        assert_eq!((&*row["wrong"], &*row["queries"], &*row["families"]), ("5329", "70000", "7"));
        let row = glance(&with_wide(backends), "shewchuk");
        assert!(row.contains("| 70,000 | 92.4 % | 0 % | 7.6 % (5,329; 7.42 to 7.81 %) | 0 % |"), "{row}");
    }
    let lazy = overall(&with_wide(&["naive", "tolerance"]), "tolerance", "single");
    let shares = ["right", "undecided", "wrong", "not_done", "families", "reference_families"].map(|key| &*lazy[key]);
    assert_eq!(shares, ["20000", "30000", "0", "20000", "5", "7"]);
}

#[test]
fn who_decides_nothing_has_no_price_of_being_right() {
    let page = markdown(&with_wide(&["exact", "naive", "shewchuk", "tolerance"]), &[]).unwrap();
    let headline = page.lines().find(|line| line.contains("the price of being right")).unwrap();
    assert!(headline.starts_with("- **1.5×** the price of being right: exact is the cheapest backend"), "{headline}");
    let page = markdown(&with_wide(&["naive", "shewchuk", "tolerance"]), &[]).unwrap();
    assert!(page.contains("- **—** the price of being right: no backend answers everything"), "{page}");
}

/// A task whose answers are judged as a whole: exact is right, tolerance breaks a law in one scene of four, naive
/// rounds in one.
fn with_slices() -> Vec<RunDir> {
    let mut run = empty();
    run.plan.judged_whole = ["slice".to_owned()].into();
    run.plan.backends = ["exact", "tolerance", "naive"].map(str::to_owned).into();
    for (at, family) in ["a", "b", "c", "d"].into_iter().enumerate() {
        let scene = scene("slice", family, 7);
        for backend in ["exact", "tolerance", "naive"] {
            let counts: &[(Class, u64)] = match (backend, at) {
                ("tolerance", 0) => &[(Class::Topology, 2)],
                ("naive", 1) => &[(Class::Rounded, 3)],
                _ => &[],
            };
            run.summary.push(result(&scene, backend, counts));
            run.throughput.push(sample(&scene, backend, Interface::Whole, 100.0));
        }
        run.plan.scenes.push(scene);
    }
    vec![run]
}

#[test]
fn a_failed_check_is_in_every_figure() {
    let runs = with_slices();
    let row = overall(&runs, "tolerance", "whole");
    let scenes =
        ["queries", "scenes", "scenes_held", "scenes_rounded", "scenes_broken", "families"].map(|key| &*row[key]);
    assert_eq!(scenes, ["0", "4", "3", "0", "1", "4"], "its time stands");
    assert!(
        glance(&runs, "tolerance").contains("| 4 | 25.0 % (1; 4.56 to 69.9 %) |"),
        "{}",
        glance(&runs, "tolerance")
    );
    assert_eq!(overall(&runs, "naive", "whole")["scenes_rounded"], "1");
    // Two plots, of all tasks and of slices, with a mark for each backend; the broken one is above the shelf.
    let heights = |runs: &[RunDir]| {
        let folder = tempfile::tempdir().unwrap();
        write_pages(runs, &[], &[], folder.path()).unwrap();
        ["overall-scenes.svg", "speed-slice.svg"].map(|file| {
            let svg = std::fs::read_to_string(folder.path().join(file)).unwrap();
            let at = svg
                .split("<circle ")
                .skip(1)
                .map(|mark| mark.split("cy=\"").nth(1).unwrap().split('"').next().unwrap());
            at.map(|y| y.parse::<i32>().unwrap()).collect::<Vec<_>>()
        })
    };
    for marks in heights(&runs) {
        assert_eq!(marks.len(), 3);
        assert!(marks[1] < marks[0] && marks[0] == marks[2], "tolerance is above the others: {marks:?}");
    }
    // A former fault: the count of failed checks is dropped.
    let mut dropped = runs;
    dropped[0].summary.iter_mut().for_each(|row| row.topology = 0);
    assert_ne!(heights(&dropped)[0][1], heights(&with_slices())[0][1]);
}

#[test]
fn single_queries_and_batches_are_apart() {
    let mut run = empty();
    run.plan.backends = ["exact", "naive", "shewchuk"].map(str::to_owned).into();
    let scene = scene("incircle", "uniform", 1000);
    for (backend, single, batch, interface) in [
        ("exact", 15.0, 3.0, Interface::Batch),
        ("naive", 12.0, 2.0, Interface::Batch),
        ("shewchuk", 24.0, 24.0, Interface::Loop),
    ] {
        let counts: &[(Class, u64)] = if backend == "naive" { &[(Class::SignFlip, 1)] } else { &[] };
        run.summary.push(result(&scene, backend, counts));
        run.throughput.push(sample(&scene, backend, Interface::Single, single));
        run.throughput.push(sample(&scene, backend, interface, batch));
    }
    run.plan.scenes.push(scene);
    let runs = [run];
    let exact = glance(&runs, "exact");
    assert!(exact.ends_with("| 1.2× (1 of 1 families) | 1.5× (1 of 1 families) |"), "{exact}");
    let loops = glance(&runs, "shewchuk");
    assert!(loops.ends_with("| 2.0× (1 of 1 families) | 12× (a loop; 1 of 1 families) |"), "{loops}");
    let page = markdown(&runs, &[]).unwrap();
    let told = "1.2× of naive's time for a single query (1 pair), 1.5× of naive's time for a batch (1 pair)";
    assert!(page.contains(told), "{page}");
}

/// A page, a headline and the CSV agree.
#[test]
fn the_csv_has_the_figures_of_the_page() {
    let runs = runs();
    // exact over naive: near 21/1.25, uniform 2.25/1; √(16.8 · 2.25) = 6.148.
    let exact = overall(&runs, "exact", "single");
    assert!((exact["ratio"].parse::<f64>().unwrap() - 37.8_f64.sqrt()).abs() < 1e-9);
    assert!(glance(&runs, "exact").ends_with("| 6.1× (2 of 2 families) |"));
    // naive has 400 + 2000 + 100 queries, 2 and 1 of them wrong.
    let naive = overall(&runs, "naive", "single");
    let counts = ["queries", "right", "undecided", "wrong", "not_done"].map(|key| &*naive[key]);
    assert_eq!(counts, ["1105012", "1102509", "0", "2503", "0"]);
    let tolerance = overall(&runs, "tolerance", "");
    assert_eq!(
        ["queries", "right", "undecided", "not_done"].map(|key| &*tolerance[key]),
        ["1105000", "1039000", "61000", "5000"]
    );
    for row in figures(&runs) {
        let number = |key: &str| row[key].parse::<u64>().unwrap();
        let shares: u64 = ["right", "undecided", "wrong", "not_done"].map(number).iter().sum();
        assert_eq!(shares, number("queries"), "{row:?}");
        let scenes: u64 =
            ["held", "rounded", "broken", "not_done"].map(|key| number(&format!("scenes_{key}"))).iter().sum();
        assert_eq!(scenes, number("scenes"), "{row:?}");
    }
}

/// A family has one scene in one run and two in another: results of one scene must not be compared with those of two.
#[test]
fn a_part_of_a_family_is_not_the_family() {
    // A second scene of `near`, a hundred times as slow, timed with fewer samples than the first.
    let twice = |backends: &[&str]| {
        let mut runs = runs();
        let again = runs[1].throughput.iter().filter(|row| row.family == "near" && row.sample < 2).cloned();
        let again: Vec<ThroughputRow> = again.filter(|row| backends.contains(&&*row.backend)).collect();
        let slower = again.into_iter().map(|row| ThroughputRow { ns_per_query: 100.0 * row.ns_per_query, ..row });
        runs[1].throughput.extend(slower.collect::<Vec<_>>());
        let scene = PlannedScene { scene: "near-8".to_owned(), ..runs[1].plan.scenes[0].clone() };
        runs[1].plan.scenes.push(scene);
        runs
    };
    // The geometric mean of 21 and 2,200, the medians of the scenes; a median over all samples would be 24. For naive
    // it is that of 1.25 and 137.5.
    let page = markdown(&twice(&["exact", "sos", "naive", "shewchuk"]), &[]).unwrap();
    assert!(page.contains("| 2 | orient2d | near | single | 215 (20.0–2,400 · 16×) |"), "{page}");
    // `near` is timed on two backends only, so it is a pair of just these two.
    let runs = twice(&["exact", "naive"]);
    assert_eq!(overall(&runs, "exact", "single")["families"], "2");
    assert_eq!(overall(&runs, "shewchuk", "single")["families"], "1");
    let page = markdown(&runs, &[]).unwrap();
    assert!(page.contains("30.0 (29.5–31.0 · 1 of 2 scenes)"), "{page}");
}

/// Two benches of one family are one pair: the mean of both ratios.
#[test]
fn what_was_timed_twice_is_one_pair() {
    let mut runs = runs();
    let mut again = runs[1].clone();
    for row in again.throughput.iter_mut().filter(|row| row.backend == "exact") {
        row.ns_per_query *= 4.0;
    }
    runs.push(again);
    let exact = overall(&runs, "exact", "single");
    assert_eq!(exact["families"], "2");
    // The mean over both runs is twice as long.
    assert!((exact["ratio"].parse::<f64>().unwrap() - 2.0 * 37.8_f64.sqrt()).abs() < 1e-9, "{exact:?}");
}

/// A random run: results and times of backends on families.
fn random_run() -> impl Strategy<Value = RunDir> {
    let cell = (0..8_u8, 1..400_u64, any::<bool>(), 1..50_u32);
    prop::collection::vec(prop::collection::vec(prop::option::weighted(0.8, cell), 5), 1..7).prop_map(|families| {
        let names = ["naive", "exact", "tolerance", "shewchuk", "engine:mine"];
        let tasks = ["orient2d", "slice", "polygon-locate"];
        let mut run = empty();
        run.plan.judged_whole = ["slice".to_owned()].into();
        run.plan.backends = names.map(str::to_owned).into();
        for (at, cells) in families.into_iter().enumerate() {
            let scene = scene(tasks[at % 3], &format!("family-{at}"), 1000);
            for (backend, cell) in names.into_iter().zip(cells) {
                let Some((class, count, is_timed, ns)) = cell else { continue };
                let class = [
                    Class::Agree,
                    Class::InBand,
                    Class::SignFlip,
                    Class::Topology,
                    Class::Rounded,
                    Class::Declined,
                    Class::Timeout,
                    Class::TieBroken,
                ][usize::from(class)];
                run.summary.push(result(&scene, backend, &[(class, count)]));
                if is_timed {
                    let ways: &[Interface] =
                        if at % 3 == 0 { &[Interface::Single, Interface::Batch] } else { &[Interface::Whole] };
                    let rows = ways.iter().map(|&interface| sample(&scene, backend, interface, f64::from(ns)));
                    run.throughput.extend(rows.collect::<Vec<_>>());
                }
            }
            run.plan.scenes.push(scene);
        }
        run
    })
}

/// The run without this backend.
fn without(run: &RunDir, backend: &str) -> RunDir {
    let mut run = run.clone();
    run.plan.backends.retain(|name| name != backend);
    run.summary.edit(|rows| rows.retain(|(_, row)| row.backend != backend));
    run.throughput.edit(|rows| rows.retain(|(_, row)| row.backend != backend));
    run
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    /// A figure about a backend does not depend on other backends, except for the reference's time.
    #[test]
    fn figures_about_a_backend_are_its_own(run in random_run(), gone in 1..5_usize) {
        let gone = ["naive", "exact", "tolerance", "shewchuk", "engine:mine"][gone];
        let said = |run: RunDir| {
            let mut rows = figures(&[run]);
            rows.retain(|row| row["backend"] != gone);
            // A task that only the other backend was timed on has no panel.
            rows.retain(|row| row["panel"] == "all" || !row["interface"].is_empty());
            rows
        };
        prop_assert_eq!(said(without(&run, gone)), said(run));
    }

    /// The colours of marks, and the rows of the table on the first screen, do not depend on other backends either.
    #[test]
    fn rows_and_colours_of_a_backend_are_its_own(run in random_run(), gone in 1..5_usize) {
        let names = ["naive", "exact", "tolerance", "shewchuk", "engine:mine"];
        let said = |run: RunDir| {
            let page = html(&[run], &[], &[]).unwrap();
            let of = |name: &&str| {
                let label = format!("\n{name}\n");
                let mut colours: Vec<String> = page
                    .split("<text ")
                    .filter(|text| text.contains(&label))
                    .map(|text| text.split("fill=\"").nth(1).unwrap()[..7].to_owned())
                    .collect();
                colours.dedup();
                colours
            };
            names.iter().filter(|name| **name != names[gone]).map(of).collect::<Vec<_>>()
        };
        for (with, without) in said(run.clone()).iter().zip(&said(without(&run, names[gone]))) {
            prop_assert!(with.len() <= 1 && (without.is_empty() || with == without), "{:?} {:?}", with, without);
        }
    }
}

#[test]
fn a_page_that_can_t_be_written_leaves_the_earlier_one() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    write_pages(&runs()[..1], &[], &[], folder.path()).unwrap();
    let before = std::fs::read_to_string(at("report.md")).unwrap();
    // A file can't be written in the place of a folder, like on a full disk.
    std::fs::create_dir(at("overall.svg")).unwrap();
    let error = write_pages(&runs(), &[], &[], folder.path()).unwrap_err();
    assert_eq!(error.path, at("overall.svg"));
    assert_eq!(std::fs::read_to_string(at("report.md")).unwrap(), before);
    let mut names: Vec<String> = std::fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, ["figures.csv", "overall.svg", "report.html", "report.md", "tables.tex", "ties.pdf", "ties.svg"]);
    std::fs::remove_dir(at("overall.svg")).unwrap();
    write_pages(&runs(), &[], &[], folder.path()).unwrap();
    assert_ne!(std::fs::read_to_string(at("report.md")).unwrap(), before);
}
