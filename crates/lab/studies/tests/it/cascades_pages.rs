//! The rows, tables and plots of cascades show the measurements.

use std::collections::BTreeMap;

use predicament_studies::cascades::{Cascade, Contradiction, Measured};
use predicament_studies::{File, Study};

use crate::cascades::{cascades, measured};

/// Three steps by two methods, with an error of each kind that is not in the last sample.
fn planted() -> (impl Study<Measured = Measured>, Measured) {
    let study = cascades(Cascade::Stars, &["exact", "naive"], 3);
    let mut found = measured(&study);
    let naive = &mut found.followed[1];
    naive.samples[0].defects.touches = 2;
    naive.samples[1].defects.crossings = 3;
    naive.samples[1].defects.flat = 6;
    (naive.samples[0].defects.inverted, naive.samples[1].defects.inverted) = (4, 1);
    (naive.samples[1].lost, naive.samples[1].collapsed) = (5, 7);
    (naive.samples[0].turned, naive.samples[1].turned, naive.samples[2].turned) = (Some(8), Some(9), Some(0));
    naive.samples[1].area *= 2;
    naive.broken = Some((2, Contradiction::Unsettled));
    naive.ended = Some((4, "no more".to_owned()));
    (study, found)
}

fn file(files: Vec<File>, name: &str) -> Option<String> {
    files.into_iter().find(|file| file.name == name).map(|file| file.text().to_owned())
}

#[test]
fn rows_have_the_measurements() {
    let (study, found) = planted();
    let text = file(study.rows(&found).unwrap(), "cascades.csv").unwrap();
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let head = lines.next().unwrap();
    let rows: Vec<BTreeMap<&str, &str>> = lines.map(|line| head.iter().copied().zip(line).collect()).collect();
    let samples: Vec<_> = found.followed.iter().flat_map(|one| &one.samples).collect();
    assert_eq!(rows.len(), samples.len());
    for (row, sample) in rows.iter().zip(&samples) {
        for (name, value) in [
            ("step", sample.step),
            ("regions", sample.regions),
            ("edges", sample.edges),
            ("crossings", sample.defects.crossings),
            ("touches", sample.defects.touches),
            ("inverted_loops", sample.defects.inverted),
            ("flat_loops", sample.defects.flat),
            ("wrong_points", sample.lost),
            ("constructed", sample.constructed),
            ("collapsed", sample.collapsed),
            ("vertices_held", sample.held),
        ] {
            assert_eq!(row[name], value.to_string(), "{name}");
        }
        let area: f64 = row["area"].parse().unwrap();
        assert!((area - sample.area.to_f64() / 2.0).abs() < 1e-12);
        assert_eq!(row["turned_corners"], sample.turned.map_or_else(String::new, |turned| turned.to_string()));
    }
    let of_naive = |name: &str| rows[3..].iter().map(|row| row[name]).collect::<Vec<_>>();
    assert_eq!(of_naive("method"), ["naive"; 3]);
    assert_eq!(
        of_naive("broken"),
        ["", "thick primitives settle", "thick primitives settle"],
        "from the step on that breaks it"
    );
    assert_eq!(of_naive("ended"), ["", "", "step 4: no more"], "after the last step");
    assert!((rows[4]["area_error"].parse::<f64>().unwrap() - 1.0).abs() < 1e-9, "twice the area");
}

#[test]
fn a_table_has_the_worst_of_all_samples() {
    let (study, found) = planted();
    let page = study.page(&found);
    let cells = |line: &str| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect::<Vec<_>>();
    let head = page.lines().find(|line| line.starts_with("| method")).map(cells).unwrap();
    let naive =
        page.lines().find(|line| line.starts_with("| naive") || line.starts_with("| `naive`")).map(cells).unwrap();
    let row: BTreeMap<String, String> = head.into_iter().zip(naive).collect();
    for (name, value) in [
        ("steps", "3"),
        ("crossings", "3"),
        ("touches", "2"),
        ("inverted", "4"),
        ("turned", "17"),
        ("wrong points", "5"),
        ("area error", "1.0e0"),
    ] {
        assert_eq!(row[name], value, "{name}");
    }
    for line in [
        "naive: edges of the result cross, first seen after step 2",
        "naive: a loop is turned over, first seen after step 1",
        "naive: points are on the wrong side, first seen after step 2",
        "naive: step 2 breaks the rule: thick primitives settle",
        "naive: step 4 cannot be done: no more",
    ] {
        assert!(page.contains(line), "{line}");
    }
}

#[test]
fn plots_have_whatever_is_wrong() {
    let study = cascades(Cascade::Stars, &["exact"], 3);
    let clean = measured(&study);
    let plot = |found: &Measured| file(study.plots(found).unwrap(), "stars-wrong.svg");
    assert_eq!(plot(&clean), None, "nothing is wrong");
    for plant in [
        |found: &mut Measured| found.followed[0].samples[1].defects.crossings = 1,
        |found: &mut Measured| found.followed[0].samples[1].defects.inverted = 1,
        |found: &mut Measured| found.followed[0].samples[1].lost = 1,
    ] {
        let mut found = clean.clone();
        plant(&mut found);
        assert!(plot(&found).is_some());
    }
}

#[test]
fn operands_are_written_as_closed_rings() {
    let study = cascades(Cascade::Shave, &["exact"], 4);
    let text = file(study.suites(&measured(&study)).unwrap(), "shave.wkt").unwrap();
    let (start, steps) = Cascade::Shave.steps(4, 1);
    let wanted =
        std::iter::once(("start", &start)).chain(steps.iter().map(|step| (step.operation.name(), &step.corners)));
    let mut lines = text.lines();
    for (name, corners) in wanted {
        let (operation, ring) = lines.next().unwrap().split_once(";POLYGON ((").unwrap();
        let ring: Vec<[f64; 2]> = ring
            .trim_end_matches("))")
            .split(", ")
            .map(|point| {
                let (x, y) = point.split_once(' ').unwrap();
                [x, y].map(|x| x.parse().unwrap())
            })
            .collect();
        assert_eq!((operation, &ring[..corners.len()]), (name, corners.as_slice()));
        assert_eq!((ring.len(), ring.last()), (corners.len() + 1, corners.first()));
    }
    assert_eq!(lines.next(), None);
}
