//! The table of `docs/PEERS.md` is what the tool prints today.

use crate::common::{at, column, expect, read};

#[test]
fn the_committed_table_of_wrong_answers_is_the_one_that_comes_out() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = at(&folder, "bench");
    let told = expect(
        0,
        &[
            "bench",
            "families",
            "decimals",
            "fixtures",
            "-b",
            "exact",
            "--samples",
            "1",
            "--sample-ms",
            "0",
            "--out",
            &out,
        ],
    );
    let (_, table) = told.stdout.split_once("Wrong answers\n").expect("peers go wrong on the wide families");
    assert!(table.lines().count() > 10, "{table}");
    let page = include_str!("../../../docs/PEERS.md");
    assert!(page.contains(table.trim()), "docs/PEERS.md has another table than this one:\n{table}");
    // What is timed by vertex id is timed by coordinates too, and `exact` makes no error at all.
    let backends = column(&read(&out, "throughput.csv"), "backend");
    for peer in ["robust", "geometry-predicates", "geogram_predicates", "simplicity"] {
        let times = |name: &str| backends.iter().filter(|backend| *backend == name).count();
        assert!(times(peer) > 0 && times(peer) == times(&format!("raw:{peer}")), "{peer}");
    }
    let summary = read(&out, "summary.csv");
    let wrong_of = |class: &str| -> u64 {
        let rows = column(&summary, "backend").into_iter().zip(column(&summary, class));
        rows.filter(|(backend, _)| backend == "exact").map(|(_, n)| n.parse::<u64>().expect("a count")).sum()
    };
    for class in ["overreach", "missed_zero", "sign_flip", "inconsistent", "nan", "panic"] {
        assert_eq!(wrong_of(class), 0, "{class}");
    }
}

/// The crates that find the pairs of two complexes find all that there are,
/// and are not asked where contacts are degenerate.
#[test]
fn peers_find_the_pairs_of_contacts_in_general_position() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = at(&folder, "bench");
    let scenes = "contacts/(polygons-uniform|surfaces-uniform|touching-squares|tetrahedra)$";
    expect(0, &["bench", "-f", scenes, "-b", "exact", "--samples", "1", "--sample-ms", "0", "--out", &out]);
    let summary = read(&out, "summary.csv");
    let all = |name: &str| column(&summary, name);
    let number = |name: &str| -> Vec<u64> { all(name).iter().map(|n| n.parse().expect("a count")).collect() };
    let (agree, flips, declined) = (number("agree"), number("sign_flip"), number("declined"));
    let mut seen = Vec::new();
    for (row, (scene, backend)) in all("scene").into_iter().zip(all("backend")).enumerate() {
        if backend == "exact" {
            continue;
        }
        let general = scene.ends_with("-uniform");
        assert_eq!((agree[row] > 0, flips[row], declined[row] > 0), (general, 0, !general), "{scene} {backend}");
        seen.push((scene, backend));
    }
    for (scene, peers) in [("polygons-uniform", 2), ("surfaces-uniform", 1), ("touching-squares", 2), ("tetrahedra", 1)]
    {
        assert_eq!(seen.iter().filter(|(of, _)| of == scene).count(), peers, "{scene}");
    }
    let timed = column(&read(&out, "throughput.csv"), "backend");
    assert!(["geo:sweep", "rstar"].iter().all(|peer| timed.iter().any(|backend| backend == peer)), "{timed:?}");
}

/// The crates break the laws that `docs/LAWS.md` says, and no others.
#[test]
fn the_committed_table_of_laws_is_the_one_that_comes_out() {
    let crates = ["simplicity", "geogram", "rgeometry", "delaunay", "delaunay:sorted", "axiolid", "hyperlimit"];
    let args = ["laws", "-b", &crates.join(","), "--tuples", "200000", "--seed", "1", "--format", "csv"];
    let told = expect(100, &args).stdout;
    let all = |name: &str| column(&told, name);
    let number = |name: &str| -> Vec<u64> { all(name).iter().map(|n| n.parse().expect("a count")).collect() };
    let (tuples, violations, panics) = (number("tuples"), number("violations"), number("panics"));
    let (backends, laws, predicates) = (all("backend"), all("law"), all("predicates"));
    let letters = |predicates: &str| -> String {
        let letter = |name: &str| match name {
            "compare" => 'c',
            "orient2d" => '2',
            "orient3d" => '3',
            "incircle" => 'C',
            "insphere" => 'S',
            other => panic!("no letter for {other}"),
        };
        predicates.split('+').map(letter).collect()
    };
    let cell = |backend: &str, law: &str| -> String {
        let rows = (0..tuples.len()).filter(|&row| backends[row] == backend && laws[row] == law && tuples[row] > 0);
        let rows: Vec<usize> = rows.collect();
        let broken =
            rows.iter().filter(|&&row| violations[row] + panics[row] > 0).map(|&row| letters(&predicates[row]));
        let mut broken: Vec<String> = broken.collect();
        broken.sort();
        match (rows.is_empty(), broken.is_empty()) {
            (true, _) => "-".to_owned(),
            (false, true) => "0".to_owned(),
            (false, false) => broken.join(" "),
        }
    };
    let page = include_str!("../../../docs/LAWS.md");
    let (_, table) = page.split_once("| law | exact, sos, ").expect("the table");
    let (_, table) = table.split_once("|---|\n").expect("its rows");
    let mut seen = 0;
    for line in table.lines().take_while(|line| line.starts_with('|')) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let said = cells[4..].iter().map(|cell| cell.trim_end_matches(" (mixed)").to_owned());
        let said: Vec<String> = said.collect();
        let named: Vec<&str> = match cells[0] {
            "independence-of-place, -of-later-vertices" => {
                vec!["independence-of-place", "independence-of-later-vertices"]
            }
            law => vec![law],
        };
        for law in named {
            assert_eq!(crates.map(|name| cell(name, law)).to_vec(), said, "{law}");
            seen += 1;
        }
    }
    let distinct: std::collections::BTreeSet<&String> = laws.iter().collect();
    assert_eq!(seen, distinct.len(), "a row for each law");
}
