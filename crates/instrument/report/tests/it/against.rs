//! Comparisons with earlier runs, sections in the user's own pages, and tables for papers.

use predicament_records::{Class, RunDir, Status};
use predicament_report::{Section, against, html, markdown, splice, write_pages};

fn runs() -> Vec<RunDir> {
    ["../tasks/tests/data/checked", "../tasks/tests/data/timed"].map(|path| RunDir::open(path).unwrap()).into()
}

fn said(section: Section) -> String {
    markdown(&[], &[section]).unwrap()
}

#[test]
fn a_run_beside_itself_has_changed_in_nothing() {
    let page = said(against(&runs(), &runs()).unwrap());
    let pairs: usize = runs().iter().map(|run| run.summary.len()).sum();
    assert!(page.contains(&format!("| {pairs} | 0 | 0 | 0 |")), "{page}");
    assert!(!page.contains("### Changed"), "{page}");
    assert!(page.contains("### Times relative to the earlier run"), "{page}");
    assert!(page.lines().filter(|line| line.contains("1.0×")).count() > 2, "{page}");
}

/// A planted regression: one scene has new wrong answers, one takes twice as long, one is gone.
#[test]
fn what_changed_is_named() {
    let earlier = runs();
    let mut now = runs();
    let row = now[0].summary.iter_mut().find(|row| row.status == Status::Ok && row.has_answers()).unwrap();
    *row.count_mut(Class::SignFlip) += 7;
    row.status = Status::Unexpected;
    let (scene, backend) = (row.scene.clone(), row.backend.clone());
    let gone = now[0].summary.iter().position(|row| row.status == Status::Expected).unwrap();
    now[0].summary.edit(|rows| drop(rows.remove(gone)));
    let timed = now[1].throughput[0].backend.clone();
    for row in now[1].throughput.iter_mut().filter(|row| row.backend == timed) {
        row.ns_per_query *= 2.0;
    }
    let page = said(against(&now, &earlier).unwrap());
    let pairs: usize = now.iter().map(|run| run.summary.len()).sum();
    assert!(page.contains(&format!("| {} | 1 | 0 | 1 |", pairs - 1)), "{page}");
    let changed = page.lines().find(|line| line.contains("sign\\_flip 7")).unwrap();
    assert!(changed.contains(&scene) && changed.contains(&format!("`{backend}`")) && changed.contains("sign\\_flip 0"));
    assert!(changed.contains("unexpected") && changed.ends_with("| worse |"), "{changed}");
    let slower: Vec<&str> =
        page.lines().filter(|line| line.contains(&format!("| `{timed}` |")) && line.contains("2.0×")).collect();
    assert!(!slower.is_empty(), "{page}");
    // The section is first on both pages.
    let page = html(&now, &[against(&now, &earlier).unwrap()], &[]).unwrap();
    let place = |id: &str| page.find(&format!("<section id=\"{id}\">")).unwrap();
    assert!(place("against") < place("heat"));
    // Each backend has a ring beside its mark, which the plot of the run alone does not have.
    let plot = |id: &str| page[place(id)..].split("</svg>").next().unwrap().to_owned();
    let [both, alone] = ["against", "tradeoff"].map(|id| plot(id).matches("<circle").count());
    assert_eq!(both, 2 * alone, "{alone}");
}

#[test]
fn sections_go_where_their_marks_are() {
    let page = "Before\n<!-- predicament: glance tables -->\nold\n<!-- /predicament -->\nbetween\n\
                <!-- predicament: ties -->\n<!-- /predicament -->\nafter\n";
    let (once, count) = splice(page, &runs(), &[], &|_| None).unwrap();
    assert_eq!(count, 2);
    assert!(once.starts_with("Before\n<!-- predicament: glance tables -->\n| backend |"), "{once}");
    assert!(once.contains("|\n<!-- /predicament -->\nbetween\n<!-- predicament: ties -->\n"), "{once}");
    assert!(once.ends_with("<!-- /predicament -->\nafter\n") && !once.contains("old"), "{once}");
    // The rows are those of the whole page.
    let whole = markdown(&runs(), &[]).unwrap();
    assert!(once.lines().filter(|line| line.starts_with("| `")).all(|line| whole.contains(line)));
    assert_eq!(splice(&once, &runs(), &[], &|_| None).unwrap().0, once, "and again");
    // A page with Windows line ends keeps them.
    let windows = splice(&page.replace('\n', "\r\n"), &runs(), &[], &|_| None).unwrap().0;
    assert_eq!(windows, once.replace('\n', "\r\n"));
}

#[test]
fn marks_that_name_nothing_are_refused() {
    let refused = |page: &str| splice(page, &runs(), &[], &|_| None).unwrap_err().message;
    assert!(refused("no marks").contains("there is no mark"));
    assert!(refused("\n<!-- predicament: nothing -->\n<!-- /predicament -->").starts_with("line 2: no section"));
    assert!(refused("<!-- predicament: glance -->\n").contains("<!-- /predicament -->"));
    assert!(refused("<!-- predicament: glance").contains("-->"));
    assert!(refused("x <!-- predicament: bogus --> y <!-- /predicament -->").starts_with("line 1: no section"));
    // The text between an unclosed mark and the next mark is not replaced.
    let forgotten =
        "\n<!-- predicament: glance -->\n\nMy text\n\n<!-- predicament: heat -->\nold\n<!-- /predicament -->\n";
    let why = refused(forgotten);
    assert!(why.starts_with("line 2: `<!-- predicament: glance -->` is not closed before line 6"), "{why}");
    // A mark without its end continues to the next mark: the message shows only its first line.
    let spoiled = "<!-- predicament: glance tab>\nold\n<!-- /predicament -->\nmine\n<!-- predicament: heat -->\n";
    let why = refused(spoiled);
    assert!(why.starts_with("line 1: `<!-- predicament: glance tab> -->` is not closed"), "{why}");
    assert_eq!(why.lines().count(), 1, "{why}");
}

#[test]
fn parts_of_ones_own_go_where_their_marks_are() {
    let part = |name: &str| match name {
        "which tree" => Some(Ok("a tree\n".to_owned())),
        "which words" => Some(Err("compare.csv: no such file".to_owned())),
        _ => None,
    };
    let of = |name: &str| format!("\n<!-- predicament: {name} -->\nold\n<!-- /predicament -->\n");
    let (page, count) = splice(&of("which tree"), &[], &[], &part).unwrap();
    assert_eq!((page, count), (of("which tree").replace("old", "a tree"), 1));
    let why = splice(&of("which words"), &[], &[], &part).unwrap_err().message;
    assert_eq!(why, "line 2: compare.csv: no such file");
    assert!(splice(&of("which nothing"), &[], &[], &part).unwrap_err().message.contains("no section is called"));
}

#[test]
fn tables_for_papers_have_the_same_cells() {
    let folder = tempfile::tempdir().unwrap();
    write_pages(&runs(), &[], &[], folder.path()).unwrap();
    let tex = std::fs::read_to_string(folder.path().join("tables.tex")).unwrap();
    assert_eq!(tex.matches("\\begin{tabular}").count(), tex.matches("\\end{tabular}").count());
    assert!(tex.contains("\\label{tab:glance-1}") && tex.contains("\\toprule"), "{tex}");
    assert!(tex.contains("1,100,000 & 2,270"), "numbers of the page");
    let glance = tex.split("\\label{tab:glance-1}").next().unwrap().rsplit("\\caption").next().unwrap();
    assert!(glance.contains("shares of all queries"), "{glance}");
    assert!(!tex.lines().any(|line| !line.starts_with('%') && line.replace("\\_", "").contains('_')), "{tex}");
}
