//! Pages made from two small runs that were written by hand: one was
//! interrupted while it checked answers, one timed them.

use predicament_report::{PixelMap, RunDir, data_uri, html, markdown, scatter, write_pages};

const GOLDEN: &str = "tests/data/report.md";

fn runs() -> Vec<RunDir> {
    ["tests/data/checked", "tests/data/timed"].map(|path| RunDir::open(path).unwrap()).into()
}

/// To accept a new page: `UPDATE=1 cargo test -p predicament-report`, then read the difference.
#[test]
fn markdown_is_as_it_was_read_and_approved() {
    let page = markdown(&runs()).unwrap();
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(GOLDEN, &page).unwrap();
    }
    let golden = std::fs::read_to_string(GOLDEN).unwrap().replace("\r\n", "\n");
    for (line, (new, old)) in page.lines().zip(golden.lines()).enumerate() {
        assert_eq!(new, old, "line {}", line + 1);
    }
    assert_eq!(page.lines().count(), golden.lines().count());
}

/// The numbers of the golden page that take some arithmetic, worked out by hand from the rows.
#[test]
fn numbers_trace_to_rows() {
    let page = markdown(&runs()).unwrap();
    // naive: (400 + 2000 + 100) + 2 + 1 wrong. exact, sos and naive answered 1,105,012 queries,
    // shewchuk and tolerance, which declined one scene, 1,100,000.
    assert!(page.contains("2,503 of 5,515,036 answers are wrong"));
    // exact against shewchuk: near 21/42, uniform 2.25/9; √(1/2 · 1/4) = 0.354.
    assert!(page.contains("**0.35×** the time of shewchuk"));
    // naive on orient2d: 2502 of 1.1 million; √(1.25 · 1.0) = 1.118 ns.
    assert!(page.contains("| naive | 2 | 1,100,000 | 2,502 | 2,270 | 1.12 | yes |"));
    // sos near: 38000 of 100000.
    assert!(page.contains("| 1 | orient2d | near | sos | 100,000 | — | 61.0 % | 38.0 % | 1.0 % (to 3) |"));
    // Ties: 1,000 of 1.1 million; √(30/21 · 2.6/2.25) = 1.285 of exact's time. Terms 1 and 3 decided.
    assert!(page.contains("| 1 | orient2d | sos | 1,100,000 | 1,000 | \\<0.1 % | 3 | 1.3× |"), "{page}");
    assert!(page.contains("| 1 | orient2d | sos | 990 | 0 | 10 | 0 | 0 | 0 | 0 | 0 | 0 | 0 | 0 |"), "{page}");
    // A union that came out right, and one that came out negative.
    assert!(page.contains("| 1 | corner-in-corner (cubes) | sos | 2 | 15.0000 | 42.0000 | 48.0000 | 14 | 6 | 0 |"));
    assert!(page.contains("| 1 | twins (cubes) | exact | 3 | −2.00000 (true: 1.00000) |"), "{page}");
    // exact, edges with vertices: 1 of 4 and 3 of 4 had ended; then 2 of 9, 1 of 3 and none of none.
    let contacts = "| 1 | two-triangles (contacts) | contacts2d | exact | 1 (0 % ended) | 1 (50.0 % ended) | 2 (25.0 % ended) |  |";
    assert!(page.contains(contacts), "{page}");
    // Two scenes of suite near got the same, one of 54 bits and one of 61.
    assert!(page.contains("| 1 | near | near, uniform | 2 | 54 to 61 | −60 to −53 | integer | — | wide integer | — |"));
}

#[test]
fn html_has_every_section_and_needs_nothing_else() {
    let mut runs = runs();
    let png = PixelMap::new(2, 1, &[-1, 1], &[false, true]).unwrap().to_png(1).unwrap();
    runs[0].maps.push(("near-7".to_owned(), png.clone()));
    let page = html(&runs).unwrap();
    for id in [
        "run",
        "answers",
        "findings",
        "speed",
        "throughput",
        "precision",
        "stages",
        "ties",
        "locate",
        "contacts",
        "cubes",
        "not-run",
        "maps",
    ] {
        assert!(page.contains(&format!("<section id=\"{id}\">")), "{id}");
        assert!(page.contains(&format!("<a href=\"#{id}\">")), "{id}");
    }
    assert!(page.contains(&data_uri(&png)));
    let foreign = page.replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
    for word in ["http:", "https:", "<script", "@import", "<link", "url("] {
        assert!(!foreign.contains(word), "{word}");
    }
    assert_balanced(&page);
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
    let page = html(&runs).unwrap();
    assert!(!page.contains("<script"));
    assert!(page.contains("&lt;script&gt;"));
    assert_balanced(&page);
    assert!(!markdown(&runs).unwrap().replace("\\<", "").contains("<script"));
}

#[test]
fn the_order_of_rows_changes_nothing() {
    let (forward, mut backward) = (runs(), runs());
    for run in &mut backward {
        run.summary.reverse();
        run.findings.reverse();
        run.throughput.reverse();
        run.locate.reverse();
        run.contacts.reverse();
        run.precision.reverse();
    }
    assert_eq!(html(&forward).unwrap(), html(&backward).unwrap());
    assert_eq!(markdown(&forward).unwrap(), markdown(&backward).unwrap());
}

#[test]
fn a_single_wrong_answer_moves_the_mark_and_the_headline() {
    let (before, mut after) = (runs(), runs());
    let row = after[0].summary.iter_mut().find(|row| row.backend == "exact" && row.scene == "near-7").unwrap();
    row.agree -= 1;
    row.sign_flip += 1;
    assert_ne!(scatter(&before).unwrap(), scatter(&after).unwrap());
    let page = markdown(&after).unwrap();
    assert!(page.contains("2,504 of 5,515,036"));
    assert!(page.contains("sos is the fastest backend without a wrong answer"));
}

#[test]
fn without_both_times_and_answers_there_is_no_plot() {
    let runs = runs();
    assert_eq!(scatter(&runs[..1]).unwrap(), None);
    assert_eq!(scatter(&runs[1..]).unwrap(), None);
    assert!(markdown(&runs[..1]).unwrap().contains("No backend was both checked and timed"));
}

#[test]
fn pages_are_written_beside_their_plot() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new/report");
    write_pages(&runs(), &out).unwrap();
    let plot = std::fs::read_to_string(out.join("scatter.svg")).unwrap();
    assert!(plot.starts_with("<svg") && plot.contains("shewchuk") && !plot.contains("#010203"));
    let ties = std::fs::read_to_string(out.join("ties.svg")).unwrap();
    assert!(ties.starts_with("<svg") && ties.contains("sos"), "{ties}");
    let page = std::fs::read_to_string(out.join("report.md")).unwrap();
    assert!(page.contains("(scatter.svg)") && page.contains("(ties.svg)"));
    assert!(std::fs::read_to_string(out.join("report.html")).unwrap().contains("<svg class=\"scatter\""));
}

/// Every element that is opened is closed, in the right order.
fn assert_balanced(page: &str) {
    const VOID: [&str; 3] = ["meta", "img", "!doctype"];
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
