//! Tests of `scoreboard`, on a run of this project's own backends.

use std::fs;

use tempfile::tempdir;

use crate::common::{at, run};

#[test]
fn libraries_stand_side_by_side_with_their_smallest_scenes() {
    let folder = tempdir().unwrap();
    let (of_delaunay, out) = (at(&folder, "run"), at(&folder, "scoreboard"));
    // (The errors of naive are known.)
    assert_eq!(run(&["run", "delaunay", "-b", "exact,naive", "--out", &of_delaunay]).code, 0);
    let timed = at(&folder, "bench");
    let bench =
        ["bench", "--judged", &of_delaunay, "-f", "uniform", "-b", "exact,naive", "--samples", "1", "--out", &timed];
    assert_eq!(run(&bench).code, 0);
    let told = run(&["scoreboard", &of_delaunay, &timed, "--out", &out]);
    assert_eq!(told.code, 0, "{}", told.stderr);
    let page = fs::read_to_string(format!("{out}/delaunay2d.md")).unwrap();
    let row = |name: &str| {
        let line = page.lines().find(|line| line.starts_with(&format!("| `{name}` |"))).unwrap();
        line.split('|').skip(2).take(8).map(|cell| cell.trim().parse::<usize>().unwrap()).collect::<Vec<_>>()
    };
    let [exact, naive] = ["exact", "naive"].map(row);
    let scenes = exact[0];
    assert!(scenes > 30, "{page}");
    assert_eq!(exact, [scenes, scenes, 0, 0, 0, 0, 0, 0]);
    // Scenes, and then right, rounded, broken, failed, refused, accepted and declined ones.
    assert_eq!((naive[0], naive[1..].iter().sum::<usize>()), (scenes, scenes));
    assert!(naive[3] > 0, "{page}");
    // The unit of times is `exact`, on the one family that was timed.
    let exact = page.lines().find(|line| line.starts_with("| `exact` |")).unwrap();
    assert!(exact.contains("| 1.00 (1) |") && page.contains("time / `exact` (families)"), "{exact}");
    // The smallest broken scene is there as a suite, and naive is wrong on it.
    let smallest = format!("{out}/scenes/delaunay2d-naive-broken.toml");
    assert!(page.contains("scenes/delaunay2d-naive-broken.toml") && page.contains("delaunay2d-naive-broken.svg"));
    let again = run(&["run", &smallest, "-b", "naive", "--out", &at(&folder, "again")]);
    assert_eq!(again.code, 100, "{}", again.stderr);
    // The pages in HTML have the same figures and pictures, and find each other.
    let [index, html] = ["index", "delaunay2d"].map(|name| fs::read_to_string(format!("{out}/{name}.html")).unwrap());
    assert!(
        index.contains("<a href=\"delaunay2d.html\">")
            && index.contains(&format!("<td class=n>{scenes} of {scenes}</td>"))
    );
    for part in
        ["<a href=\"index.html\">", "<code>naive</code>", "src=\"scenes/delaunay2d-naive-broken.svg\"", "1.00 (1)"]
    {
        assert!(html.contains(part), "{part}: {html}");
    }
    // The counts are those of the run.
    let csv = fs::read_to_string(format!("{out}/scoreboard.csv")).unwrap();
    assert!(csv.contains(&format!("delaunay2d,exact,delaunay,{scenes},{scenes},0,0,0,0,0,0\n")), "{csv}");

    let signs = at(&folder, "signs");
    run(&["run", "classics", "-b", "exact", "--out", &signs]);
    let told = run(&["scoreboard", &signs, "--out", &at(&folder, "none")]);
    assert_eq!((told.code, told.stderr.contains("open to other programs")), (4, true), "{}", told.stderr);
}
