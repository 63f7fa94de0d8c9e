//! `run`, `replay`, `report` and `bench`, end to end.

use crate::common::{SUITE, assert_same_tables, at, column, expect, read, rewrite, run, tool, unsealed, write};
use tempfile::tempdir;

/// A part of the corpora with signs, ties, findings and a map.
const SOME: [&str; 4] = [
    "-f",
    "kettner-[ab]|wide-scaled-orient2d|grid-incircle|tilings/crossing|contacts/(surfaces|polygons)-degen|cubes/slide",
    "-b",
    "exact,sos,naive,tolerance",
];

fn some<'a>(rest: &[&'a str]) -> Vec<&'a str> {
    [&["run"][..], &SOME, rest].concat()
}

#[test]
fn shards_are_a_partition_of_the_whole() {
    let folder = tempdir().unwrap();
    let whole = at(&folder, "whole");
    run(&some(&["--out", &whole]));
    let mut parts: Vec<String> = Vec::new();
    for k in 1..=3 {
        let part = at(&folder, &format!("part{k}"));
        let shard = format!("{k}/3");
        if run(&some(&["--shard", &shard, "--out", &part])).code != 4 {
            parts.extend(read(&part, "summary.csv").lines().skip(1).map(str::to_owned));
        }
    }
    let mut rows: Vec<String> = read(&whole, "summary.csv").lines().skip(1).map(str::to_owned).collect();
    rows.sort();
    parts.sort();
    assert_eq!(rows, parts);
}

#[test]
#[cfg(unix)]
fn an_interrupted_run_says_so_and_goes_on_where_it_stopped() {
    let folder = tempdir().unwrap();
    let (whole, broken) = (at(&folder, "whole"), at(&folder, "broken"));
    let args = ["run", "families", "-f", "incircle|insphere", "-b", "exact,sos,sos:edelsbrunner-mucke", "--out"];
    run(&[&args[..], &[&whole]].concat());
    let mut child = tool(&[&args[..], &[&broken]].concat()).stdout(std::process::Stdio::null()).spawn().unwrap();
    // Wait until some rows are written, then interrupt.
    let rows =
        || std::fs::read_to_string(folder.path().join("broken/summary.csv")).map_or(0, |text| text.lines().count());
    while rows() < 3 && child.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    let code = child.wait().unwrap().code();
    assert_eq!(code, Some(103), "stopped with the code for incomplete");
    assert!(rows() < read(&whole, "summary.csv").lines().count(), "it was stopped before its end");
    assert_eq!(run(&["gate", &broken]).code, 103);
    let resumed = run(&["run", "--resume", &broken]);
    assert!([0, 100, 101].contains(&resumed.code), "{}", resumed.stderr);
    assert_same_tables(&whole, &broken, "after resuming");
    assert!(run(&["run", "--resume", &broken]).stderr.contains("nothing to resume"));
}

/// Samples that take a minute do not check the interrupt flag.
#[test]
#[cfg(unix)]
fn an_interrupted_bench_ends_in_the_middle_of_a_sample() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "bench");
    let args = ["bench", "-f", "families/(grid|near)-orient2d", "-b", "exact", "--sample-ms", "60000", "--out", &out];
    let mut child =
        tool(&args).stdout(std::process::Stdio::null()).stderr(std::process::Stdio::piped()).spawn().unwrap();
    // The judgement of the first scene is written before the scene is timed.
    let judged = || std::fs::metadata(folder.path().join("bench/judged.csv")).is_ok();
    while !judged() && child.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    std::thread::sleep(std::time::Duration::from_millis(200));
    std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    let ended = child.wait_with_output().unwrap();
    assert_eq!(ended.status.code(), Some(103));
    let said = String::from_utf8_lossy(&ended.stderr).into_owned();
    assert!(said.contains("stopping; finished work is kept"), "{said}");
    assert_eq!(run(&["gate", &out]).code, 103, "the folder says that it is not complete");
}

#[test]
fn every_scene_has_one_precision_plan_whatever_the_backends() {
    let folder = tempdir().unwrap();
    let (one, many, old) = (at(&folder, "one"), at(&folder, "many"), at(&folder, "old"));
    let scenes = ["run", "families", "-f", "grid-(orient3d|incircle)|wide-scaled-orient2d", "-b"];
    run(&[&scenes[..], &["naive", "--out", &one]].concat());
    run(&[&scenes[..], &["exact,sos,naive", "--out", &many]].concat());
    let plans = read(&one, "precision.csv");
    assert_eq!(plans, read(&many, "precision.csv"));
    // Small integers are exact in doubles; a scene that spans most exponents is not exact even in integers.
    let choices = |scene: &str| {
        let line = plans.lines().find(|line| line.contains(scene)).unwrap_or_else(|| panic!("{scene}: {plans}"));
        line.splitn(6, ',').last().unwrap_or_default().to_owned()
    };
    assert_eq!(choices("grid-incircle"), "double,,double,");
    assert_eq!(choices("grid-orient3d"), "double,double,,double");
    assert_eq!(choices("wide-scaled-orient2d"), "dyadic,,dyadic,");
    // One row per scene.
    let mut scenes = column(&plans, "scene");
    scenes.sort();
    let mut checked = column(&read(&one, "summary.csv"), "scene");
    checked.sort();
    assert_eq!(scenes, checked);

    // When an older run folder without the table is resumed, its finished scenes get their precision plans.
    let state = unsealed(&one, "state.json").replace("\"complete\"", "\"interrupted\"");
    let known = format!("\"precision.csv\": {}", plans.len());
    assert!(state.contains(&known), "{state}");
    std::fs::create_dir(&old).unwrap();
    for file in [
        "plan.json",
        "env.json",
        "throughput.csv",
        "summary.csv",
        "findings.csv",
        "stages.csv",
        "locate.csv",
        "contacts.csv",
        "masses.csv",
        "judged.csv",
        "decimals.csv",
        "sampled.csv",
        "imports.csv",
        "snap.csv",
        "simplify.csv",
        "mesh_locate.csv",
        "mesh_intersect.csv",
        "replies.csv",
    ] {
        write(&folder, &format!("old/{file}"), &read(&one, file));
    }
    write(&folder, "old/state.json", &state.replace(&format!("{known},"), ""));
    run(&["run", "--resume", &old]);
    assert_same_tables(&one, &old, "after resuming");
}

/// A scene that is too large for the complete truth is recorded, and a small scene is not.
#[test]
fn what_is_held_against_a_part_of_the_truth_is_written_down() {
    let folder = tempdir().unwrap();
    // Up to a little more than 20,000 edges, all edges are checked.
    for (scene, edges, rows) in [("large", 25_000, 1), ("small", 1000, 0)] {
        let out = at(&folder, scene);
        let text = format!(
            "title = \"Edges\"\n[[generate]]\nname = \"{scene}\"\nfamily = \"polygons-uniform\"\ntask = \"contacts2d\"\n\
             n = {edges}\nbits = 24\nseed = 31\n"
        );
        let suite = write(&folder, &format!("{scene}-suite.toml"), &text);
        expect(0, &["run", &suite, "-b", "naive", "--permutations", "0", "--out", &out]);
        let sampled = read(&out, "sampled.csv");
        assert_eq!(column(&sampled, "scene"), vec![scene; rows], "{sampled}");
        assert_eq!(sampled.contains("simplices of the first complex"), rows > 0, "{sampled}");
    }
}

#[test]
fn a_finding_is_replayed_from_its_id() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "run");
    run(&["run", "classics", "tilings", "-f", "kettner|tilings/tiling", "-b", "naive,epsilon:1e-10", "--out", &out]);
    let findings = read(&out, "findings.csv");
    let (ids, checks) = (column(&findings, "finding_id"), column(&findings, "check"));
    for kind in ["sign", "antisymmetry", "false-boundary"] {
        let at = checks.iter().position(|check| check == kind).unwrap_or_else(|| panic!("a finding of {kind}"));
        let told = expect(0, &["replay", &ids[at], "--run", &out]);
        assert!(told.stdout.contains(&ids[at]) && told.stdout.contains("vertex "), "{}", told.stdout);
        assert!(told.stdout.lines().any(|line| line.trim_start().starts_with("exact ")), "{}", told.stdout);
    }
    expect(4, &["replay", "zzz", "--run", &out]);
    expect(2, &["replay", "zzz", "--run", &at(&folder, "nowhere")]);
}

/// Every run records the source of the tool, if git is available.
#[test]
fn a_run_says_what_the_tool_was_built_from() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let out = at(&folder, "run");
    expect(0, &["run", &suite, "-b", "exact", "--out", &out]);
    let env = read(&out, "env.json");
    assert!(env.contains("\"opt_flags\": \"profile ") && env.contains("; RUSTFLAGS: "), "{env}");
    let git = std::process::Command::new("git").args(["rev-parse", "HEAD"]).output();
    match git.ok().filter(|output| output.status.success()) {
        Some(output) => {
            let commit = String::from_utf8(output.stdout).unwrap();
            assert!(env.contains(&format!("\"commit\": \"{}\"", commit.trim_end())), "{env}");
            assert!(env.contains("\"dirty\": true") || env.contains("\"dirty\": false"), "{env}");
        }
        None => assert!(env.contains("\"commit\": null") && env.contains("\"dirty\": null"), "{env}"),
    }
}

/// A bench keeps the judgements of its scenes; they do not count as second answers.
#[test]
fn a_run_and_a_bench_of_it_have_as_many_answers_as_were_asked() {
    let folder = tempdir().unwrap();
    let (out, bench, own) = (at(&folder, "run"), at(&folder, "bench"), at(&folder, "own"));
    let scenes = ["-f", "kettner-pixels-a|tilings/bricks|cubes/corner-in-corner", "-b", "exact,sos,naive,shewchuk"];
    let quickly = ["--samples", "1", "--sample-ms", "0", "--out"];
    run(&[&["run"][..], &scenes, &["--out", &out]].concat());
    expect(0, &[&["bench"][..], &scenes, &["--judged", &out], &quickly, &[&bench]].concat());
    expect(0, &[&["bench"][..], &scenes, &quickly, &[&own]].concat());
    let summary = read(&out, "summary.csv");
    let number = |name: &str| column(&summary, name).iter().map(|n| n.parse().unwrap()).collect::<Vec<u64>>();
    // A union of cubes is judged as one answer.
    let rows_of = column(&summary, "backend").into_iter().zip(column(&summary, "task")).zip(number("queries"));
    let asked: u64 = rows_of
        .filter(|((backend, task), _)| backend == "sos" && task != "cube-union")
        .map(|(_, queries)| queries)
        .sum();
    let text = |n: u64| if n < 1000 { n.to_string() } else { format!("{},{:03}", n / 1000, n % 1000) };
    let (rows, ties) = (text(number("queries").len() as u64), text(number("tie_broken").iter().sum()));
    // In any order, with one or two folders of timings, and with a folder named twice.
    for (at_report, folders) in [[&out, &bench, &out], [&bench, &out, &bench], [&out, &own, &bench]].iter().enumerate()
    {
        let report = at(&folder, &format!("report-{at_report}"));
        expect(0, &["report", folders[0], folders[1], folders[2], "--out", &report]);
        let page = read(&report, "report.md");
        assert!(page.contains(&format!("of {rows} pairs of scene and backend")), "{folders:?}: {page}");
        let glance = page.split("\n## Which backend to use\n").nth(1).unwrap();
        let glance = glance.lines().find(|line| line.starts_with("| `sos` |")).unwrap();
        assert!(glance.starts_with(&format!("| `sos` | {} | 100 % |", text(asked))), "{folders:?}: {glance}");
        assert!(glance.contains("| 2 | 0 % ("), "{folders:?}: {glance}");
        let classes = page.split("\n### By backend, over all suites\n").nth(1).unwrap().split("\n### ").next().unwrap();
        let with_ties =
            classes.lines().filter(|line| line.contains("| sos |") && line.contains(&format!("| {ties} |")));
        assert_eq!(with_ties.count(), 1, "{folders:?}: {classes}");
        let stages = page.split("\n## Stages\n").nth(1).unwrap().split("\n## ").next().unwrap();
        let bricks = stages.lines().filter(|line| line.contains("| polygon-locate | bricks | sos |"));
        assert_eq!(bricks.count(), 1, "{folders:?}: {stages}");
        let cubes = page.split("\n## Unions of cubes\n").nth(1).unwrap().split("\n## ").next().unwrap();
        assert_eq!(cubes.matches("| corner-in-corner (cubes) | sos |").count(), 1, "{folders:?}: {cubes}");
    }
}

/// Only one of the two folders can be right, so nothing is reported.
#[test]
fn a_report_of_folders_that_disagree_is_an_error_that_names_both() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let (one, two, report) = (at(&folder, "one"), at(&folder, "two"), at(&folder, "report"));
    for out in [&one, &two] {
        run(&["run", &suite, "-b", "naive", "--out", out]);
    }
    let summary =
        read(&two, "summary.csv").replace(",1,0,0,0,1,0,0,0,0,0,0,0,0,0,0,", ",1,1,0,0,0,0,0,0,0,0,0,0,0,0,0,");
    assert_ne!(summary, read(&two, "summary.csv"), "the row was found");
    rewrite(&two, "summary.csv", &summary);
    let told = expect(2, &["report", &one, &two, "--out", &report]);
    for part in [&*one, &*two, "mine/wrong-once (orient2d) on naive has other counts"] {
        assert!(told.stderr.contains(part), "{part}: {}", told.stderr);
    }
    assert!(!std::path::Path::new(&report).exists(), "no page of it");
}

#[test]
fn a_report_has_errors_and_timings_on_one_page() {
    let folder = tempdir().unwrap();
    let (out, bench, report) = (at(&folder, "run"), at(&folder, "bench"), at(&folder, "report"));
    let scenes = ["-f", "kettner-pixels-a|tilings/bricks", "-b", "exact,naive,shewchuk"];
    run(&[&["run"][..], &scenes, &["--out", &out]].concat());
    expect(0, &[&["bench"][..], &scenes, &["--samples", "3", "--sample-ms", "0", "--out", &bench]].concat());
    let throughput = read(&bench, "throughput.csv");
    // A scene of signs through two interfaces and one of whole answers, three backends, three samples.
    let backends = column(&throughput, "backend");
    assert_eq!(backends.len(), 3 * 3 * 3, "{throughput}");
    assert!(column(&throughput, "ns_per_query").iter().all(|ns| ns.parse::<f64>().unwrap() > 0.0));
    expect(0, &["report", &out, &bench, "--out", &report]);
    let (html, markdown) = (read(&report, "report.html"), read(&report, "report.md"));
    for page in [&html, &markdown] {
        for needle in ["kettner-pixels-a", "shewchuk", "polygon-locate", "needs fetched data"] {
            assert!(page.contains(needle), "{needle}");
        }
    }
    assert!(html.contains("<svg") && !html.contains("src=\"http"));
    assert!(read(&report, "tables.tex").contains("\\begin{tabular}"));
}

#[test]
fn a_report_beside_an_earlier_run_and_in_a_page_of_ones_own() {
    let folder = tempdir().unwrap();
    let (before, now, report) = (at(&folder, "before"), at(&folder, "now"), at(&folder, "report"));
    let page = at(&folder, "page.md");
    run(&["run", "-f", "kettner-pixels-a", "-b", "exact,naive", "--out", &before]);
    run(&["run", "-f", "kettner-pixels-a|tilings/bricks", "-b", "exact", "--out", &now]);
    std::fs::write(&page, "Mine\n<!-- predicament: glance tables -->\n<!-- /predicament -->\n").unwrap();
    expect(0, &["report", &now, "--baseline", &before, "--splice", &page, "--out", &report]);
    let markdown = read(&report, "report.md");
    // One pair is unchanged, one is new, and one is gone.
    assert!(
        markdown.contains("## Changes since the earlier run") && markdown.contains("| 1 | 0 | 1 | 1 |"),
        "{markdown}"
    );
    let spliced = std::fs::read_to_string(&page).unwrap();
    assert!(spliced.starts_with("Mine\n") && spliced.contains("\n| `exact` | "), "{spliced}");
    std::fs::write(&page, "no marks\n").unwrap();
    let said = expect(2, &["report", &now, "--splice", &page, "--out", &report]).stderr;
    assert!(said.contains("page.md") && said.contains("there is no mark"), "{said}");
    assert_eq!(std::fs::read_to_string(&page).unwrap(), "no marks\n");
    // A missing closing mark must not delete text.
    let forgotten = "<!-- predicament: glance -->\n\nMy long text\n\n<!-- predicament: findings -->\nold\n<!-- /predicament -->\nend\n";
    std::fs::write(&page, forgotten).unwrap();
    let said = expect(2, &["report", &now, "--splice", &page, "--out", &report]).stderr;
    assert!(said.contains("page.md: line 1: ") && said.contains("is not closed before line 5"), "{said}");
    assert_eq!(std::fs::read_to_string(&page).unwrap(), forgotten);
    // A page with CR LF line ends keeps them everywhere.
    std::fs::write(&page, "Mine\r\n<!-- predicament: glance tables -->\r\n<!-- /predicament -->\r\n").unwrap();
    expect(0, &["report", &now, "--splice", &page, "--out", &report]);
    let spliced = std::fs::read_to_string(&page).unwrap();
    assert!(spliced.contains("\r\n| `exact` | ") && !spliced.replace("\r\n", "").contains(['\r', '\n']), "{spliced}");
}

#[test]
fn constructed_vertices_are_judged_replayed_and_timed() {
    let folder = tempdir().unwrap();
    let (out, bench) = (at(&folder, "run"), at(&folder, "bench"));
    let scenes = ["constructed", "-f", "/(kite|ssi-degen-orient2d)$", "-b", "exact,sos,sos:edelsbrunner-mucke,naive"];
    expect(0, &[&["run"][..], &scenes, &["--out", &out]].concat());
    expect(0, &["gate", &out]);
    let summary = read(&out, "summary.csv");
    let answers = column(&summary, "backend").into_iter().zip(column(&summary, "agree"));
    let exact: Vec<String> = answers.filter(|(backend, _)| backend == "exact").map(|(_, agree)| agree).collect();
    assert_eq!(exact, ["84", "2000"], "{summary}");
    assert_eq!(column(&summary, "declined").iter().filter(|declined| *declined == "1").count(), 2, "{summary}");
    let stages = column(&read(&out, "stages.csv"), "backend");
    assert!(stages.iter().filter(|backend| *backend == "exact").count() > 1, "a filter and what comes after it");

    let findings = read(&out, "findings.csv");
    let id = column(&findings, "query").iter().position(|query| query.contains(" c")).expect("a wrong answer");
    let told = expect(
        0,
        &["replay", &column(&findings, "finding_id")[id], "--run", &out, "-b", "exact,sos:edelsbrunner-mucke"],
    );
    for needle in ["  SSI(2 3, 4 5)\n", "exact sign", "scene declined"] {
        assert!(told.stdout.contains(needle), "{needle}: {}", told.stdout);
    }

    let told = expect(0, &[&["bench"][..], &scenes, &["--samples", "1", "--sample-ms", "0", "--out", &bench]].concat());
    assert!(told.stdout.contains("not timed: constructed/kite on sos:edelsbrunner-mucke"), "{}", told.stdout);
    let throughput = read(&bench, "throughput.csv");
    let timed = column(&throughput, "backend");
    assert_eq!(timed.iter().filter(|name| ["exact", "naive"].contains(&name.as_str())).count(), 8, "{throughput}");
}

#[test]
fn contacts_are_judged_replayed_timed_and_reported() {
    let folder = tempdir().unwrap();
    let (out, bench, report) = (at(&folder, "run"), at(&folder, "bench"), at(&folder, "report"));
    let scenes = ["contacts", "-f", "polygons-(near|degen)|tetrahedra", "-b", "exact,sos,tolerance,epsilon:1e-10"];
    expect(0, &[&["run"][..], &scenes, &["--out", &out]].concat());
    let contacts = read(&out, "contacts.csv");
    let number = |name: &str| column(&contacts, name).iter().map(|n| n.parse().unwrap()).collect::<Vec<u64>>();
    let [candidates, ended, asked, registered] = ["candidates", "ended", "asked", "registered"].map(number);
    // Two scenes with six kinds of pairs and one with ten, on four backends.
    assert_eq!(candidates.len(), 4 * (6 + 6 + 10));
    assert!(
        (0..candidates.len()).all(|row| candidates[row] == ended[row] + asked[row] && registered[row] <= asked[row])
    );
    let ranks: Vec<u64> = number("rank_a").iter().zip(number("rank_b")).map(|(a, b)| a + b).collect();
    for (row, backend) in column(&contacts, "backend").iter().enumerate().filter(|(_, backend)| *backend == "sos") {
        let dimension = if column(&contacts, "task")[row] == "contacts2d" { 2 } else { 3 };
        assert!(registered[row] == 0 || ranks[row] == dimension, "{backend} registers what is degenerate");
    }

    let findings = read(&out, "findings.csv");
    let id = column(&findings, "class").iter().position(|class| class == "overreach").expect("a wrong answer");
    let id = &column(&findings, "finding_id")[id];
    let told = expect(0, &["replay", id, "--run", &out, "-b", "exact,tolerance"]);
    for needle in ["contacts2d(", "  vertex ", "\n  truth  ", "\n  exact  ", "\n  tolerance  ", "registered at "] {
        assert!(told.stdout.contains(needle), "{needle}: {}", told.stdout);
    }

    expect(0, &[&["bench"][..], &scenes, &["--samples", "1", "--sample-ms", "0", "--out", &bench]].concat());
    let throughput = read(&bench, "throughput.csv");
    assert_eq!(column(&throughput, "queries").len(), 3 * 4, "{throughput}");
    expect(0, &["report", &out, &bench, "--out", &report]);
    let markdown = read(&report, "report.md");
    assert!(markdown.contains("## Contacts") && markdown.contains("% ended"), "{markdown}");
}

#[test]
fn a_run_of_default_backends_says_which_others_there_are() {
    let folder = tempdir().unwrap();
    let (all, one, pages) = (at(&folder, "all"), at(&folder, "one"), at(&folder, "pages"));
    let line = "not run: sos:per-mesh, exact:rational, tolerance:f32, naive:nalgebra; \
                `-b sos:per-mesh,exact:rational,tolerance:f32,naive:nalgebra` runs them\n";
    let scenes = ["run", "classics", "-f", "kettner-a1$"];
    let told = run(&[&scenes[..], &["--out", &all]].concat());
    assert!(told.stdout.ends_with(line), "{}", told.stdout);
    let told = run(&[&scenes[..], &["-b", "exact", "--out", &one]].concat());
    assert!(!told.stdout.contains("not run:"), "{}", told.stdout);
    // The second of two meshes is moved where there are two meshes.
    let two = at(&folder, "two");
    let told = run(&["run", "classics", "touching", "-f", "kettner-a1$|vertex-on-vertex$", "--out", &two]);
    assert!(
        told.stdout.ends_with(
            "not run: exact:rational, tolerance:f32, naive:nalgebra; \
             `-b exact:rational,tolerance:f32,naive:nalgebra` runs them\n"
        ),
        "{}",
        told.stdout
    );
    assert!(told.stdout.contains("; complete\n"), "{}", told.stdout);
    let rows = read(&two, "summary.csv");
    let of = |backend: &str| rows.lines().filter(|row| row.split(',').any(|cell| cell == backend)).count();
    assert_eq!([of("exact"), of("sos:per-mesh")], [2, 1], "{rows}");
    for (out, is_said) in [(&all, true), (&one, false)] {
        expect(0, &["report", out, "--out", &pages]);
        let page = read(&pages, "report.md");
        assert_eq!(page.contains("Backends that were not named") && page.contains("naive:nalgebra"), is_said, "{page}");
    }
}

#[test]
fn a_report_has_the_comparison_in_the_run_s_folder_or_says_how_to_make_it() {
    let folder = tempdir().unwrap();
    let (out, pages) = (at(&folder, "run"), at(&folder, "pages"));
    run(&["run", "classics", "-f", "kettner-a1$", "-b", "exact", "--out", &out]);
    let page = || {
        expect(0, &["report", &out, "--out", &pages]);
        read(&pages, "report.md")
    };
    let compared = at(&folder, "run/compare");
    let without = page();
    let command = format!("predicament study compare --out {compared}");
    assert!(without.contains("Which backend for what") && without.contains(&command), "{without}");
    let few = ["-b", "exact,naive", "-t", "orient2d", "--scenes", "1", "--samples", "0"];
    expect(0, &[&["study", "compare"][..], &few, &["--out", &compared]].concat());
    let with = page();
    assert!(with.contains("Backends on scenes of each kind") && !with.contains(&command), "{with}");
    // The decision tree is on the first screen, with or without a comparison.
    assert!([&without, &with].iter().all(|page| page.contains("(which.svg)")), "{with}");
    // A section that can't be made is refused with the name of the missing file.
    let own = at(&folder, "page.md");
    std::fs::write(&own, "<!-- predicament: which laws -->\n<!-- /predicament -->\n").unwrap();
    let why = expect(2, &["report", &out, "--out", &pages, "--splice", &own]).stderr;
    assert!(why.contains("stress-laws.csv") && why.contains("line 1"), "{why}");
    std::fs::write(&own, "<!-- predicament: which ranking -->\n<!-- /predicament -->\n").unwrap();
    expect(0, &["report", &out, "--out", &pages, "--splice", &own]);
    assert!(std::fs::read_to_string(&own).unwrap().contains("| `naive` |"));
    // The comparison may also be next to the tables of the run; a folder named twice appears once.
    std::fs::rename(format!("{compared}/compare.csv"), format!("{out}/compare.csv")).unwrap();
    assert!(page().contains("Backends on scenes of each kind"));
    let named = at(&folder, "named");
    expect(0, &[&["study", "compare"][..], &few, &["--out", &named]].concat());
    expect(0, &["report", &out, &named, "--out", &pages]);
    assert_eq!(read(&pages, "report.md").matches("Backends on scenes of each kind").count(), 1);
}
