//! What is compared with what, in panels, headlines and `figures.csv`.

use predicament_records::{Class, Interface, PlannedScene, RunDir, Status, SummaryRow, ThroughputRow};
use predicament_report::{markdown, scatter, write_pages};

fn runs() -> Vec<RunDir> {
    ["../tasks/tests/data/checked", "../tasks/tests/data/timed"].map(|path| RunDir::open(path).unwrap()).into()
}

/// The runs with three more families of `orient2d` that all backends but `sos` were checked and timed on: `exact` in 8 ns,
/// `naive` in 1 and `shewchuk` in 32.
fn with_families_that_sos_lacks() -> Vec<RunDir> {
    let mut runs = runs();
    for family in ["one", "two", "three"] {
        let scene = PlannedScene {
            suite: "more".to_owned(),
            scene: family.to_owned(),
            scene_id: format!("{family:0>8}"),
            task: "orient2d".to_owned(),
            family: family.to_owned(),
            queries: 1000,
        };
        for (backend, ns_per_query) in [("exact", 8.0), ("naive", 1.0), ("shewchuk", 32.0)] {
            let row = SummaryRow { agree: 1000, ..SummaryRow::new(&scene, backend, 1000, Status::Ok) };
            runs[0].summary.push(row);
            runs[1].throughput.push(ThroughputRow {
                task: scene.task.clone(),
                family: family.to_owned(),
                backend: backend.to_owned(),
                interface: Interface::Batch,
                engine_version: "1".to_owned(),
                queries: 1000,
                sample: 0,
                ns_per_query,
            });
        }
        for run in &mut runs {
            run.plan.scenes.push(scene.clone());
        }
    }
    runs
}

/// `figures.csv`, row by row, by column.
fn figures(runs: &[RunDir]) -> Vec<std::collections::BTreeMap<String, String>> {
    let folder = tempfile::tempdir().unwrap();
    write_pages(runs, &[], &[], folder.path()).unwrap();
    let mut reader = csv::Reader::from_path(folder.path().join("figures.csv")).unwrap();
    reader.deserialize().map(Result::unwrap).collect()
}

#[test]
fn a_backend_that_did_little_is_partial_and_takes_nothing_from_the_others() {
    let runs = with_families_that_sos_lacks();
    let page = markdown(&runs, &[]).unwrap();
    // exact: (21 · 2.25 · 8³)^(1/5) = 7.53, shewchuk (42 · 9 · 32³)^(1/5) = 26.2.
    assert!(page.contains("| exact | 5 of 5 | 1,103,000 | 0 | 0 | 7.53 | 26.2 | 0.29× | yes |"), "{page}");
    // sos over its own two, beside shewchuk over these two: as without the others.
    assert!(page.contains("| sos | 2 of 5 | 1,100,000 | 0 | 0 | 8.83 | 19.4 | 0.45× | partial |"), "{page}");
    // And beside all others on these two.
    assert!(page.contains("| 2 | orient2d | sos | 2 of 5 | 6.87 | 8.83 | 1.12 | 19.4 |"), "{page}");
    assert!(page.contains("1,103,012 | 2,000 |  |  |  |  |  |  | 0.45× (partial: 2 pairs) |"), "{page}");
    assert!(
        page.contains("over 5 pairs of task and family that all 3 compared backends did; sos did too few"),
        "{page}"
    );
    // The same rule where ties are compared with exact: sos did two of five families, and nobody else breaks ties.
    assert!(page.contains("| 3 | 1.3× (partial: 2 families) |"), "{page}");

    let [before, after] = [self::runs(), runs].map(|runs| scatter(&runs).unwrap().unwrap().svg);
    assert!(before.contains("orient2d, 2 of 2 families") && after.contains("orient2d, 5 of 5 families"));
    // Marks have a radius of 4; one of them is hollow, and says on how many families it stands.
    let hollow =
        |svg: &str| svg.lines().filter(|line| line.contains("r=\"4\"") && line.contains("fill=\"none\"")).count();
    assert_eq!((hollow(&before), hollow(&after)), (0, 1), "{after}");
    assert!(after.contains("sos (2)") && !before.contains("sos (2)"));
}

/// A fast backend that did little stands on no frontier and moves nobody off it.
#[test]
fn a_partial_mark_is_on_no_frontier() {
    let mut runs = with_families_that_sos_lacks();
    for row in runs[1].throughput.iter_mut().filter(|row| row.backend == "sos") {
        row.ns_per_query = 0.01;
    }
    let frontier: Vec<(String, String)> = figures(&runs)
        .into_iter()
        .filter(|row| row["panel"] == "orient2d")
        .map(|mut row| (row.remove("backend").unwrap(), row.remove("frontier").unwrap()))
        .collect();
    let expected = [("exact", "true"), ("sos", "false"), ("naive", "true"), ("shewchuk", "false")];
    assert_eq!(frontier, expected.map(|(a, b)| (a.to_owned(), b.to_owned())));
}

/// A page, a headline and the CSV tell one story.
#[test]
fn the_csv_has_the_figures_of_the_page() {
    let runs = with_families_that_sos_lacks();
    let (page, rows) = (markdown(&runs, &[]).unwrap(), figures(&runs));
    let from_glance = page.split_once("## Backends at a glance").expect("the section").1;
    assert_eq!(rows.len(), 8, "four backends, over all and on orient2d");
    for row in &rows {
        let is_all = row["panel"] == "all";
        let ratio = format!("{}×", predicament_records::format::significant(row["ratio"].parse().unwrap(), 2));
        let backend = if is_all { format!("| `{}` |", row["backend"]) } else { format!("| {} | ", row["backend"]) };
        let families = format!("| {} of 5 |", row["families"]);
        let found = from_glance.lines().find(|line| line.contains(&backend) && (is_all || line.contains(&families)));
        let line = found.unwrap_or_else(|| panic!("{row:?}: {page}"));
        assert!(line.contains(&format!("| {ratio}")), "{ratio}: {line}");
        assert_eq!(line.contains("partial"), row["standing"] == "partial", "{line}");
        assert_eq!(row["basis"], "5");
        assert_eq!(row["reference"], "shewchuk");
        if !is_all {
            let ns: f64 = row["ns_per_query"].parse().unwrap();
            let reference: f64 = row["reference_ns_per_query"].parse().unwrap();
            assert!((ns / reference - row["ratio"].parse::<f64>().unwrap()).abs() < 1e-9);
        }
    }
    let right = rows.iter().filter(|row| row["panel"] == "all" && row["standing"] == "compared");
    let right = right.filter(|row| row["wrong"] == "0" && row["failed_checks"] == "0");
    let best = right.min_by(|a, b| a["ratio"].parse::<f64>().unwrap().total_cmp(&b["ratio"].parse().unwrap())).unwrap();
    assert!(
        page.contains(&format!("right: {} is the fastest backend without a wrong answer", best["backend"])),
        "{page}"
    );
    assert_eq!(best["backend"], "exact");
}

/// Whether a backend is right is asked of what is compared: its times are about that.
#[test]
fn a_failed_check_counts_where_it_is_compared() {
    let fastest = |scene: &str| {
        let mut runs = runs();
        let row = runs[0].summary.iter_mut().find(|row| row.backend == "exact" && row.scene == scene).unwrap();
        *row.count_mut(Class::Topology) = 17;
        let page = markdown(&runs, &[]).unwrap();
        let at = page.find(" is the fastest backend").unwrap();
        page[..at].rsplit(' ').next().unwrap().to_owned()
    };
    assert_eq!(fastest("two-squares"), "exact", "nobody was timed there");
    assert_eq!(fastest("near-7"), "sos");
}

/// A family is one scene here and two there: what one backend did of it is not what another did.
#[test]
fn a_part_of_a_family_is_not_the_family() {
    // A second scene of `near`, a hundred times as slow, timed with fewer samples than the first.
    let twice = |backends: &[&str]| {
        let mut runs = runs();
        let again = runs[1].throughput.iter().filter(|row| row.family == "near" && row.sample < 2).cloned();
        let again: Vec<ThroughputRow> = again.filter(|row| backends.contains(&&*row.backend)).collect();
        let slower = again.into_iter().map(|row| ThroughputRow { ns_per_query: 100.0 * row.ns_per_query, ..row });
        runs[1].throughput.extend(slower.collect::<Vec<_>>());
        markdown(&runs, &[]).unwrap()
    };
    // The geometric mean of 21 and 2,200, the medians of the scenes; a median over all samples would be 24. Of shewchuk
    // it is that of 42 and 4,100.
    let page = twice(&["exact", "sos", "naive", "shewchuk"]);
    assert!(page.contains("| 2 | orient2d | near | 215 (20.0–2,400 · 0.52×) |"), "{page}");
    // Timed on exact only, it leaves `uniform` to compare: half of the families.
    let page = twice(&["exact"]);
    assert!(page.contains("| exact | 1 of 2 | 1,000,000 | 0 | 0 | 2.25 | 9.00 | 0.25× | yes |"), "{page}");

    assert!(
        page.contains("| 2 | orient2d | near | 215 (20.0–2,400) | 30.0 (29.5–31.0 · 1 of 2 scenes · 0.71×) |"),
        "{page}"
    );

    // An answer that is missing: `shewchuk` declined another scene of the family `near`.
    let mut runs = runs();
    let scene = PlannedScene { scene: "near-8".to_owned(), ..runs[1].plan.scenes[0].clone() };
    for backend in ["exact", "sos", "naive"] {
        runs[0].summary.push(SummaryRow { agree: 5, ..SummaryRow::new(&scene, backend, 5, Status::Ok) });
    }
    runs[0].summary.push(SummaryRow { declined: 1, ..SummaryRow::new(&scene, "shewchuk", 5, Status::Expected) });
    runs[1].plan.scenes.push(scene);
    let page = markdown(&runs, &[]).unwrap();
    assert!(page.contains("| shewchuk | 1 of 2 | 1,000,000 |"), "{page}");
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
    let rows = figures(&runs);
    let exact = rows.iter().find(|row| row["panel"] == "all" && row["backend"] == "exact").unwrap();
    assert_eq!(exact["basis"], "2");
    // √(1/2 · 1/4), twice as long in the mean over both runs.
    assert!((exact["ratio"].parse::<f64>().unwrap() - 0.5_f64.sqrt()).abs() < 1e-9, "{exact:?}");
    assert_eq!(rows.iter().filter(|row| row["panel"] == "orient2d").count(), 8, "a panel for each run");
}

#[test]
fn a_page_that_can_t_be_written_leaves_the_earlier_one() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    write_pages(&runs()[..1], &[], &[], folder.path()).unwrap();
    let before = std::fs::read_to_string(at("report.md")).unwrap();
    // No file can be written where a folder is, as none can on a full disk.
    std::fs::create_dir(at("scatter.svg.next")).unwrap();
    let error = write_pages(&runs(), &[], &[], folder.path()).unwrap_err();
    assert_eq!(error.path, at("scatter.svg.next"));
    assert_eq!(std::fs::read_to_string(at("report.md")).unwrap(), before);
    let mut names: Vec<String> = std::fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(
        names,
        ["figures.csv", "report.html", "report.md", "scatter.svg.next", "tables.tex", "ties.pdf", "ties.svg"]
    );
    std::fs::remove_dir(at("scatter.svg.next")).unwrap();
    write_pages(&runs(), &[], &[], folder.path()).unwrap();
    assert_ne!(std::fs::read_to_string(at("report.md")).unwrap(), before);
}
