//! Pages made from two small hand-written runs: one was interrupted while it checked answers, one timed them.
//!
//! The runs and the approved page are in the folder of the tasks, whose sections are part of the page; the sections
//! here are made by hand.

use predicament_records::{Class, DecimalsRow, Env, FindingRow, Outcome, RunDir, RunWriter, SampledRow, TableSpec};
use predicament_report::{Block, Cell, PixelMap, Section, Table, Tone, data_uri, html, markdown, write_pages};

fn runs() -> Vec<RunDir> {
    ["../tasks/tests/data/checked", "../tasks/tests/data/timed"].map(|path| RunDir::open(path).unwrap()).into()
}

/// The section of a task with every kind of content, and this text everywhere.
fn of_a_task(text: &str) -> Section {
    let mut table = Table::new(text).words(["word", text]).numbers(["number"]);
    table.push(vec![Cell::from(text).detail(text), Cell::code(text), Cell::count(1234).tone(Tone::Bad)]);
    Section {
        id: "toy",
        title: "Toys",
        lead: format!("A toy: {text}"),
        blocks: vec![
            Block::Table(table),
            Block::table_or(Table::new("").words(["nobody"]), "No toy was found."),
            Block::Note(text.to_owned(), Tone::Bad),
            Block::Command("predicament toy".to_owned()),
            Block::Plot {
                picture: "<svg class=\"toy\"></svg>".to_owned().into(),
                file: "toy.svg".into(),
                alt: "a toy".into(),
            },
        ],
    }
}

#[test]
fn without_sections_of_tasks_the_page_is_as_it_was_approved() {
    let page = markdown(&runs(), &[]).unwrap().replace("../tasks/", "");
    let golden = std::fs::read_to_string("../tasks/tests/data/report.md").unwrap().replace("\r\n", "\n");
    // The tasks' sections are between these two.
    let (before, rest) = golden.split_once("## Points in a map").unwrap();
    let (_, after) = rest.split_once("## What was not run").unwrap();
    let expected = format!("{before}## What was not run{after}");
    for (line, (new, old)) in page.lines().zip(expected.lines()).enumerate() {
        assert_eq!(new, old, "line {}", line + 1);
    }
    assert_eq!(page.lines().count(), expected.lines().count());
}

#[test]
fn a_section_of_a_task_stands_where_it_belongs_on_both_pages() {
    let page = markdown(&runs(), &[of_a_task("a_b"), Section { title: "More toys", ..of_a_task("c") }]).unwrap();
    let headings: Vec<&str> = page.lines().filter(|line| line.starts_with("## ")).collect();
    assert_eq!(headings[headings.len() - 4..], ["## Ties", "## Toys", "## More toys", "## What was not run"]);
    let section = page.split_once("## Toys").unwrap().1.split_once("## More toys").unwrap().0;
    let expected = "\n\nA toy: a\\_b\n\n### a\\_b\n\n| word | a\\_b | number |\n| --- | --- | ---: |\n\
                    | a\\_b (a\\_b) | `a_b` | 1,234 |\n\nNo toy was found.\n\n**a\\_b**\n\n\
                    ```\npredicament toy\n```\n\n![a toy](toy.svg)\n\n";
    assert_eq!(section, expected);
    let page = html(&runs(), &[of_a_task("a_b")], &[]).unwrap();
    let places = ["ties", "toy", "not-run"].map(|id| page.find(&format!("<section id=\"{id}\">")).unwrap());
    assert!(places.is_sorted(), "{places:?}");
    assert!(page.contains("<a href=\"#toy\">") && page.contains("<svg class=\"toy\">") && page.contains("1,234"));
    assert_balanced(&page);
}

/// The numbers of the page that need arithmetic, computed by hand from the rows.
#[test]
fn numbers_trace_to_rows() {
    let page = markdown(&runs(), &[]).unwrap();
    // One scene of naive has more findings than expected, and one has fewer: 17 results in all.
    let headline = "- **1** unexpected findings: of 17 pairs of scene and backend; 1 better than expected";
    assert!(page.contains(headline), "{page}");
    // exact over naive: near 21/1.25, uniform 2.25/1; √(16.8 · 2.25) = 6.148.
    assert!(page.contains("- **6.1×** the price of being right: exact is the cheapest"), "{page}");
    // naive on orient2d: 2502 of 1.1 million, and shewchuk √(42 · 9) = 19.44 ns beside its √(1.25 · 1.0) = 1.118 ns.
    assert!(page.contains("| orient2d | naive | single | 1,100,000 | 2,270 | 0 | 0 | 2 of 2 | 1.12 | 1.12 | 1.0× |"));
    assert!(page.contains("| orient2d | shewchuk | single | 1,100,000 | 0 | 0 | 0 | 2 of 2 | 19.4 | 1.12 | 17× |"));
    // sos near: 38000 of 100000.
    assert!(page.contains("| 1 | orient2d | near | sos | 100,000 | — | 61.0 % | 38.0 % | 1.0 % (to 3) |"));
    // Ties: 1,000 of 1.1 million; √(30/21 · 2.6/2.25) = 1.285 of exact's time. Terms 1 and 3 decided.
    assert!(page.contains("| orient2d | sos | 1,100,000 | 1,000 | \\<0.1 % | 3 | 1.3× (2 of 2 families) |"), "{page}");
    assert!(page.contains("| orient2d | sos | 990 | 0 | 10 | 0 | 0 | 0 | 0 | 0 | 0 | 0 | 0 |"), "{page}");
    // Two scenes of suite near got the same arithmetic, one of 54 bits and one of 61.
    assert!(page.contains("| 1 | near | near, uniform | 2 | 54 to 61 | −60 to −53 | integer | — | wide integer | — |"));
}

#[test]
fn broken_invariants_are_counted_by_scenes() {
    let mut runs = runs();
    runs.iter_mut().for_each(|run| run.findings.retain(|finding| finding.class != Class::Topology));
    assert!(!markdown(&runs, &[]).unwrap().contains("## Broken invariants"));
    let broken = |run: &RunDir, of: usize, check: &str, id: &str| {
        let row = &run.summary[of];
        FindingRow {
            finding_id: id.to_owned(),
            suite: row.suite.clone(),
            scene: row.scene.clone(),
            scene_id: row.scene_id.clone(),
            task: row.task.clone(),
            backend: row.backend.clone(),
            class: Class::Topology,
            check: check.to_owned(),
            ..run.findings[0].clone()
        }
    };
    let (row, other) = (0, 1);
    let run = &runs[0];
    assert_eq!(run.summary[row].task, run.summary[other].task);
    // Twice on one scene, once on another scene of the same task.
    let added = [(row, "loops do not cross", "a"), (row, "loops do not cross", "b"), (other, "area", "c")]
        .map(|(of, check, id)| broken(run, of, check, id));
    let names = [row, other].map(|of| (run.summary[of].scene.clone(), run.summary[of].backend.clone()));
    let rounded = FindingRow { class: Class::Rounded, ..broken(run, other, "volumes", "d") };
    let task = run.summary[other].task.clone();
    runs[0].findings.extend(added.into_iter().chain([rounded]));
    let page = markdown(&runs, &[]).unwrap();
    let section = page.split_once("## Broken invariants").unwrap().1.split_once("\n## ").unwrap().0;
    let line = |of: &str| section.lines().find(|line| line.starts_with(&format!("| {of} |"))).unwrap().to_owned();
    let head: Vec<String> = line("broken").split('|').map(|cell| cell.trim().to_owned()).collect();
    for (check, (scene, backend)) in ["loops do not cross", "area"].into_iter().zip(names) {
        let line = line(check);
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let at = head.iter().position(|head| *head == backend).unwrap_or_else(|| panic!("{backend}: {section}"));
        assert_eq!(cells[at], format!("1 ({scene})"));
        assert_eq!(cells.iter().filter(|cell| cell.starts_with("1 (")).count(), 1, "{line}");
    }
    assert!(line("scenes answered").contains(" 2 "), "{section}");
    // Checks that fail only by rounding are not among the broken ones.
    let (broken, rounded) = section.split_once(&format!("{task}, by rounding alone")).expect("a table of its own");
    assert!(!broken.contains("volumes") && rounded.contains("| volumes |") && !rounded.contains("area"), "{section}");
}

#[test]
fn html_has_every_section_and_needs_nothing_else() {
    let mut runs = runs();
    let png = PixelMap::new(2, 1, &[-1, 1], &[false, true]).unwrap().to_png(1).unwrap();
    runs[0].maps.push(("near-7".to_owned(), png.clone()));
    let page = html(&runs, &[of_a_task("toys")], &[]).unwrap();
    for id in [
        "heat",
        "glance",
        "tradeoff",
        "run",
        "answers",
        "findings",
        "speed",
        "throughput",
        "precision",
        "stages",
        "ties",
        "toy",
        "not-run",
        "maps",
    ] {
        assert!(page.contains(&format!("<section id=\"{id}\">")), "{id}");
        assert!(page.contains(&format!("<a href=\"#{id}\">")), "{id}");
    }
    assert!(page.contains(&data_uri(&png)));
    let foreign = without_scripts(&page).replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
    for word in ["http:", "https:", "<script", "@import", "<link", "url(", " src=\"/", " onclick="] {
        assert!(!foreign.contains(word), "{word}");
    }
    assert_balanced(&page);
}

#[test]
fn what_the_tool_was_built_from_stands_beside_the_run() {
    let mut runs = runs();
    for (run, dirty) in runs.iter_mut().zip([true, false]) {
        let env = &mut run.env;
        (env.commit, env.dirty, env.governor) =
            (Some("c0ffee".to_owned()), Some(dirty), Some("performance".to_owned()));
    }
    let page = markdown(&runs, &[]).unwrap();
    assert!(page.contains("| commit | `c0ffee` (with changes that were not committed) | `c0ffee` |"), "{page}");
    assert!(page.contains("| frequency governor | performance | performance |"), "{page}");
}

#[test]
fn names_can_t_smuggle_markup_into_a_page() {
    let mut runs = runs();
    let evil = "<script>alert(1)</script>\"&|";
    runs[0].summary[3].backend = evil.to_owned();
    runs[0].findings[0].scene = evil.to_owned();
    runs[0].precision[0].orient2d = evil.to_owned();
    runs[0].stages[0].stage = evil.to_owned();
    runs[1].throughput[0].backend = evil.to_owned();
    runs[0].summary[0].suite = evil.to_owned();
    let sections = [of_a_task(evil)];
    let page = html(&runs, &sections, &[]).unwrap();
    assert!(!without_scripts(&page).contains("<script"));
    assert!(page.contains("&lt;script&gt;"));
    assert_balanced(&page);
    // Commands and code are printed unchanged: neither is markup in Markdown.
    let page = markdown(&runs, &sections).unwrap().replace(&format!("`{}`", evil.replace('|', "\\|")), "");
    assert!(!page.replace("\\<", "").contains("<script"));
}

/// Scenes that were judged in part are listed once, for any number of backends.
#[test]
fn a_scene_that_was_judged_in_part_is_named() {
    let plan = &runs()[0].plan;
    let rows = ["exact", "sos"].map(|backend| SampledRow::new(&plan.scenes[0], backend, "9 of 1,000 probes"));
    let row = format!("| {} | {} | {} | 9 of 1,000 probes |", rows[0].suite, rows[0].scene, rows[0].task);
    let page = |rows: &[SampledRow]| {
        let folder = tempfile::tempdir().unwrap();
        let mut writer =
            RunWriter::create(folder.path(), plan, &Env::default(), &[TableSpec::of::<SampledRow>()]).unwrap();
        writer.write(rows).unwrap();
        writer.finish(Outcome::Complete).unwrap();
        markdown(&[RunDir::open(folder.path()).unwrap()], &[]).unwrap().replace("\\-", "-")
    };
    let (with, without) = (page(&rows), page(&[]));
    assert_eq!(with.matches(&row).count(), 1, "{with}");
    assert!(
        with.contains("Compared with the truth of only a part") && !without.contains("Compared with the truth"),
        "{without}"
    );
}

/// Answers about decimals have a section of their own, with ties and other signs apart; runs without them have none.
#[test]
fn answers_about_decimals_are_shown_beside_those_about_doubles() {
    let plan = &runs()[0].plan;
    let counts = DecimalsRow {
        answers: 8,
        doubles: 8,
        written: 5,
        ties: 4,
        ties_found: 1,
        ..DecimalsRow::new(&plan.scenes[0], "exact")
    };
    let page = |rows: &[DecimalsRow]| {
        let folder = tempfile::tempdir().unwrap();
        let mut writer =
            RunWriter::create(folder.path(), plan, &Env::default(), &[TableSpec::of::<DecimalsRow>()]).unwrap();
        writer.write(rows).unwrap();
        writer.finish(Outcome::Complete).unwrap();
        markdown(&[RunDir::open(folder.path()).unwrap()], &[]).unwrap().replace("\\-", "-")
    };
    let (with, without) = (page(std::slice::from_ref(&counts)), page(&[]));
    assert!(with.contains("| 8 | 100 % | 62.5 % | 25.0 % | 100 % |"), "{with}");
    assert!(!without.contains("What was written"), "{without}");
}

#[test]
fn the_order_of_rows_changes_nothing() {
    let (forward, mut backward) = (runs(), runs());
    for run in &mut backward {
        run.summary.edit(|rows| rows.reverse());
        run.findings.edit(|rows| rows.reverse());
        // Samples of one backend keep the order of measurement.
        run.throughput.edit(|rows| rows.sort_by(|(_, a), (_, b)| b.backend.cmp(&a.backend)));
        run.precision.edit(|rows| rows.reverse());
    }
    assert_eq!(html(&forward, &[], &[]).unwrap(), html(&backward, &[], &[]).unwrap());
    assert_eq!(markdown(&forward, &[]).unwrap(), markdown(&backward, &[]).unwrap());
}

#[test]
fn a_single_wrong_answer_moves_the_mark_and_the_headline() {
    let (before, mut after) = (runs(), runs());
    let row = after[0].summary.iter_mut().find(|row| row.backend == "exact" && row.scene == "near-7").unwrap();
    row.agree -= 1;
    row.sign_flip += 1;
    let plot = |runs: &[RunDir]| html(runs, &[], &[]).unwrap().split("<svg").nth(1).unwrap().to_owned();
    assert_ne!(plot(&before), plot(&after));
    let page = markdown(&after, &[]).unwrap();
    assert!(page.contains("the price of being right: sos is the cheapest backend"), "{page}");
}

#[test]
fn without_both_times_and_answers_there_is_no_plot() {
    let runs = runs();
    let pages = [&runs[..1], &runs[1..]].map(|runs| markdown(runs, &[]).unwrap());
    assert!(pages.iter().all(|page| !page.contains("overall.svg")));
    assert!(markdown(&runs, &[]).unwrap().contains("overall.svg"));
    let left_out = "Sections with nothing to show, which are left out: Speed against error, Throughput, Phases.";
    assert!(pages[0].contains(left_out) && !pages[0].contains("## Throughput"), "{}", pages[0]);
}

#[test]
fn pages_are_written_beside_their_plot() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new/report");
    write_pages(&runs(), &[of_a_task("toys")], &[], &out).unwrap();
    let plot = std::fs::read_to_string(out.join("overall.svg")).unwrap();
    assert!(plot.starts_with("<svg") && plot.contains("shewchuk") && !plot.contains("#010203"));
    let ties = std::fs::read_to_string(out.join("ties.svg")).unwrap();
    assert!(ties.starts_with("<svg") && ties.contains("sos"), "{ties}");
    assert_eq!(std::fs::read_to_string(out.join("toy.svg")).unwrap(), "<svg class=\"toy\"></svg>");
    for name in ["overall.pdf", "ties.pdf"] {
        assert!(std::fs::read(out.join(name)).unwrap().starts_with(b"%PDF-"), "{name}");
    }
    assert!(!out.join("toy.pdf").exists(), "the toy has none");
    let page = std::fs::read_to_string(out.join("report.md")).unwrap();
    assert!(page.contains("(toy.svg)") && page.contains("(overall.svg)") && page.contains("(ties.svg)"));
    assert!(std::fs::read_to_string(out.join("report.html")).unwrap().contains("<svg class=\"scatter\""));
}

/// A page without the licences of its libraries and without its last elements: the libraries, the rows, and its own
/// scripts.
fn without_scripts(page: &str) -> String {
    let [libraries, rows] =
        ["libraries", "rows"].map(|id| format!("<script type=\"application/octet-stream\" id=\"{id}\">"));
    let (text, packed) = page.split_once(&libraries).expect("libraries");
    let (libraries, packed) = packed.split_once("</script>\n").expect("their end");
    let (rows, rest) = packed.strip_prefix(&rows).expect("rows").split_once("</script>\n<script>\n").expect("scripts");
    let is_packed = |text: &str| text.chars().all(|c| c.is_ascii_alphanumeric() || "+/=".contains(c));
    assert!(is_packed(libraries) && is_packed(rows), "both are in base 64");
    let (_, end) = rest.split_once("</script>").expect("scripts end");
    assert_eq!(end.trim(), "</body>\n</html>");
    let (text, licences) = text.split_once("<!--").expect("the licences");
    assert!(licences.ends_with("\n-->\n"), "the comment is the last thing before the libraries");
    format!("{text}{end}")
}

/// Asserts that every opened element is closed, in the right order.
fn assert_balanced(page: &str) {
    const VOID: [&str; 3] = ["meta", "img", "!doctype"];
    let page = without_scripts(page);
    let mut open: Vec<&str> = Vec::new();
    for tag in page.split('<').skip(1) {
        let (tag, _) = tag.split_once('>').expect("a tag ends");
        let name = tag.split([' ', '\n', '/']).find(|name| !name.is_empty()).expect("a tag has a name");
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(name), "</{name}>");
        } else if !tag.ends_with('/') && !VOID.contains(&name) {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "{open:?}");
}
