//! Tests of lossless suites: only decimals that are not doubles are rewritten.

use predicament_corpus::fmt;
use predicament_formats::read_coordinate;
use proptest::prelude::*;

const SUITE: &str = r#"# a comment that stays
title = "t"   # and this one

[[scene]]
name = "a"
task = "orient2d"
points = [
    ["0.1000000000000000001", 0.2000000000000000001],   # first
    [8, "0x1.8p+1"],
  ['-1.0000000000000000001e-1', "0.5"], [0.1, "-1e-1"]]

[[generate]]
family = "pixel-map"
task = "orient2d"
name = "b"
p = [0.5, 0.3000000000000000001]
q = [12, 12]
r = ["24", "24"]"#;

#[test]
fn only_inexact_decimals_change_and_stay_as_comments() {
    let expected = SUITE
        .replace(
            "[\"0.1000000000000000001\", 0.2000000000000000001],   # first",
            "[\"0x1.999999999999ap-4\", \"0x1.999999999999ap-3\"],   # first  # 0.1000000000000000001, 0.2000000000000000001",
        )
        .replace(
            "['-1.0000000000000000001e-1', \"0.5\"], [0.1, \"-1e-1\"]]",
            "[\"-0x1.999999999999ap-4\", \"0.5\"], [0.1, \"-1e-1\"]]  # -1.0000000000000000001e-1",
        )
        .replace("[0.5, 0.3000000000000000001]", "[0.5, \"0x1.3333333333333p-2\"]  # 0.3000000000000000001");
    let once = fmt(predicament_bundle::vocabulary(), "s.toml", SUITE).unwrap();
    assert_eq!(once, expected);
    assert_eq!(fmt(predicament_bundle::vocabulary(), "s.toml", &once).unwrap(), once);
    let windows = SUITE.replace('\n', "\r\n");
    assert_eq!(fmt(predicament_bundle::vocabulary(), "s.toml", &windows).unwrap(), expected.replace('\n', "\r\n"));
}

#[test]
fn what_no_double_is_near_to_is_refused() {
    for (bad, message) in
        [("inf", "not finite"), ("1e400", "beyond"), ("1e-400", "half the smallest"), ("\"x\"", "not a number")]
    {
        let text = SUITE.replace("0.2000000000000000001]", &format!("{bad}]"));
        let error = fmt(predicament_bundle::vocabulary(), "s.toml", &text).unwrap_err().to_string();
        assert!(error.starts_with("s.toml:8: ") && error.contains(message), "{error}");
    }
}

proptest! {
    #[test]
    fn rewriting_keeps_the_nearest_doubles(points in proptest::collection::vec((-1e9..1e9f64, any::<f32>()), 1..20)) {
        let points: Vec<_> = points.into_iter().filter(|(_, y)| y.is_finite() && *y != 0.0).collect();
        // Shortest decimals of doubles, which are doubles, and decimals of 20 digits, most of which are not.
        let rows: String = points.iter().map(|(x, y)| format!("  [{x:?}, \"{y:.19e}\"],\n")).collect();
        let text = format!("title = \"t\"\n[[scene]]\nname = \"a\"\ntask = \"compare\"\npoints = [\n{rows}]\n");
        let once = fmt(predicament_bundle::vocabulary(), "s.toml", &text).unwrap();
        prop_assert_eq!(&fmt(predicament_bundle::vocabulary(), "s.toml", &once).unwrap(), &once);
        let mut read = Vec::new();
        for row in once.lines().filter(|line| line.starts_with("  [")) {
            let row = row.split_once(']').unwrap().0.trim_start_matches(['[', ' ']);
            for cell in row.split(", ") {
                read.push(read_coordinate(cell.trim_matches('"')).unwrap());
            }
        }
        let meant: Vec<f64> = points.iter().flat_map(|(x, y)| [*x, format!("{y:.19e}").parse().unwrap()]).collect();
        prop_assert_eq!(read, meant);
    }
}
