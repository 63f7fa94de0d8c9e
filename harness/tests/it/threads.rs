//! The number of threads does not change a byte of any table.

use tempfile::tempdir;

use crate::common::{assert_same_tables, at, run, tables};

/// A part of the corpora with signs, ties, findings and a row for every table.
const SOME: &str = "kettner-[ab]|wide-scaled-orient2d|grid-incircle|contacts/(surfaces|polygons)-degen|cubes/slide|snaps/drifting|mesh-points/two-tetrahedra|intersections/tetrahedra$|simplify/a-right-angle|written/tenths|tilings/";

#[test]
fn the_bytes_do_not_depend_on_the_number_of_threads() {
    let folder = tempdir().unwrap();
    // The smallest of the three maps has rows in their tables; the other two take as long as all other scenes.
    let scenes = if predicament_effort::whole() { SOME.to_owned() } else { format!("{SOME}crossing") };
    // Also the study with a folder that works in parallel.
    for args in [
        &["run", "-f", &scenes, "-b", "exact,sos,naive,tolerance"][..],
        &["study", "parity", "--pairs", "60", "--shrink", "1"],
    ] {
        let [one, many] = ["1", "5"].map(|threads| {
            let out = at(&folder, &format!("{}{threads}", args[0]));
            let told = run(&[args, &["--threads", threads, "--out", &out]].concat());
            assert!([0, 100].contains(&told.code), "{args:?}: {}", told.stderr);
            out
        });
        for (name, text) in tables(&one) {
            // At level quick, no scene is so large that only a part of its truth is computed, and no scene without a
            // download is changed while it is read. No other program answers here.
            let empty = ["sampled.csv", "imports.csv", "replies.csv"].contains(&name.as_str());
            assert!(text.lines().count() > 1 || empty, "{name} has rows");
        }
        if args[0] == "run" {
            assert!(tables(&one).iter().any(|(name, _)| name == "judged.csv"));
        }
        assert_same_tables(&one, &many, "five threads instead of one");
    }
    // The first violation of each law does not depend on the threads. A backend with violations shows that.
    let laws = ["study", "laws", "-b", "naive", "--tuples", "5000", "--format", "csv", "--threads"];
    let [one, many] = ["1", "5"].map(|threads| run(&[&laws[..], &[threads]].concat()).stdout);
    assert!(one.lines().count() > 1 && one == many, "{one}\n{many}");
}
