//! The changes from one run to another.

use serde_json::Value;
use tempfile::tempdir;

use crate::common::{at, expect, run};

#[test]
fn what_changed_was_added_and_removed_is_told() {
    let folder = tempdir().unwrap();
    let suite = |name: &str, scenes: &[(&str, &str)]| {
        let path = at(&folder, name);
        let scene = |(name, x): &(&str, &str)| {
            format!(
                "[[scene]]\nname = \"{name}\"\ntask = \"orient2d\"\npoints = [[0, 0], [1, 1], [{x}, {x}], [7, 0], [\"0x1p1000\", \"0x1p1000\"], [\"0x1p1000\", \"0x1.8p1000\"]]\nqueries = [[0, 1, 2], [0, 4, 5]]\n"
            )
        };
        let text = format!("title = \"t\"\n{}", scenes.iter().map(scene).collect::<String>());
        std::fs::write(&path, text).unwrap();
        path
    };
    let go = |suite: &str, name: &str, backends: &str| {
        let out = at(&folder, name);
        assert!([0, 100].contains(&run(&["run", suite, "-b", backends, "-q", "--out", &out]).code));
        out
    };
    let one = suite("mine.toml", &[("a", "2"), ("b", "3"), ("c", "4")]);
    let before = go(&one, "before", "exact,sos");
    let told = expect(0, &["data", "diff", &before, &go(&one, "again", "exact,sos")]);
    assert!(told.stdout.contains("| 6 | 0 | 0 | 0 |"), "{}", told.stdout);

    // One scene is removed, one is added, one has other contents, and one backend is added.
    let other = suite("mine.toml", &[("a", "2"), ("b", "5"), ("d", "6")]);
    let now = go(&other, "now", "exact,sos");
    let json: Value =
        serde_json::from_str(&expect(0, &["data", "diff", &now, "--baseline", &before, "--format", "json"]).stdout)
            .unwrap();
    let scenes = |of: &str| -> Vec<String> {
        json[of].as_array().unwrap().iter().map(|pair| pair["scene"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!((json["unchanged"].as_u64(), scenes("changed").len()), (Some(2), 0));
    assert_eq!(
        (scenes("removed"), scenes("added")),
        (
            vec!["b", "b", "c", "c"].into_iter().map(String::from).collect(),
            vec!["b", "b", "d", "d"].into_iter().map(String::from).collect()
        )
    );

    // An unexpected wrong sign is a change for the worse.
    let naive = go(&other, "naive", "exact,naive");
    let told = run(&["data", "diff", &now, &naive, "--format", "json"]);
    let json: Value = serde_json::from_str(&told.stdout).unwrap();
    let wrong = json["added"].as_array().unwrap().iter().any(|pair| pair["status"][1] == "unexpected");
    assert_eq!(told.code, if wrong { 100 } else { 0 }, "{}", told.stdout);
    assert!(wrong, "products of naive overflow: {}", told.stdout);
    expect(2, &["data", "diff", &before, &at(&folder, "nowhere")]);
}
