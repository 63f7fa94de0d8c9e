//! README, the sample report and its figures tell one story.

use std::path::Path;

fn read(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(file);
    std::fs::read_to_string(&path).unwrap_or_else(|why| panic!("{}: {why}", path.display())).replace("\r\n", "\n")
}

/// The cells of the first table about backends of a page, after their heading if there is one, row by row.
fn table(page: &str) -> Vec<Vec<&str>> {
    let page = page.split_once("## Backends at a glance").map_or(page, |(_, rest)| rest);
    let lines =
        page.lines().skip_while(|line| !line.starts_with("| backend |")).take_while(|line| line.starts_with('|'));
    lines.map(|line| line.trim_matches('|').split('|').map(str::trim).collect()).collect()
}

/// The rows of a CSV file without quotes, by column.
fn rows(csv: &str) -> Vec<Vec<(&str, &str)>> {
    assert!(!csv.contains('"'), "a value is quoted");
    let mut lines = csv.lines();
    let columns: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    lines.map(|line| columns.iter().copied().zip(line.split(',')).collect()).collect()
}

fn value<'c>(row: &[(&str, &'c str)], column: &str) -> &'c str {
    row.iter().find(|(name, _)| *name == column).unwrap_or_else(|| panic!("no column {column}")).1
}

/// Whether a factor such as `0.41×` is this ratio, rounded to its digits.
fn is_rounded(factor: &str, ratio: f64) -> bool {
    let digits = factor.trim_end_matches('×').replace(',', "");
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let decimals = i32::try_from(decimals).unwrap_or(i32::MAX);
    // Two digits of a number from 100 on are rounded to tens or more.
    let unit =
        if decimals == 0 { 10_f64.powi(i32::try_from(digits.len()).unwrap_or(2) - 2) } else { 0.1_f64.powi(decimals) };
    digits.parse().is_ok_and(|shown: f64| (shown - ratio).abs() <= 0.501 * unit)
}

#[test]
fn the_table_of_readme_is_that_of_the_sample_report() {
    let (readme, report) = (read("README.md"), read("reports/sample/report.md"));
    let (ours, theirs) = (table(&readme), table(&report));
    assert!(theirs.len() > 8 && theirs[0].len() > 10, "{theirs:?}");
    for column in ["topology", "declined", "time / shewchuk"] {
        assert!(theirs[0].contains(&column), "{column}: {theirs:?}");
    }
    assert_eq!(ours.len(), theirs.len(), "copy the first table of reports/sample/report.md into README.md");
    for (ours, theirs) in ours.iter().zip(&theirs) {
        assert_eq!(ours, theirs, "copy the first table of reports/sample/report.md into README.md");
    }
}

#[test]
fn the_headline_and_the_figures_agree_with_the_table() {
    let (readme, report, csv) =
        (read("README.md"), read("reports/sample/report.md"), read("reports/sample/figures.csv"));
    let figures = rows(&csv);
    let all: Vec<_> = figures.iter().filter(|row| value(row, "panel") == "all").collect();
    let table = table(&report);
    assert_eq!(all.len(), table.len() - 2, "a row for each backend");
    for (row, cells) in all.iter().zip(&table[2..]) {
        assert_eq!(cells[0], format!("`{}`", value(row, "backend")));
        let time = cells.last().expect("a cell");
        let factor = time.split(' ').next().unwrap_or_default();
        assert!(is_rounded(factor, value(row, "ratio").parse().expect("a ratio")), "{row:?}: {time}");
        assert_eq!(time.contains("partial"), value(row, "standing") == "partial", "{row:?}");
    }
    let is_right = |row: &&&Vec<(&str, &str)>| {
        value(row, "standing") == "compared" && value(row, "wrong") == "0" && value(row, "failed_checks") == "0"
    };
    let ratio = |row: &[(&str, &str)]| value(row, "ratio").parse::<f64>().expect("a ratio");
    let best =
        all.iter().filter(is_right).min_by(|a, b| ratio(a).total_cmp(&ratio(b))).expect("a backend that is right");
    let headline = report.lines().find(|line| line.contains("the price of being right")).expect("the headline");
    let basis = format!("over {} pairs of task and family that all", value(best, "basis"));
    assert!(headline.contains(&format!("{} is the fastest backend", value(best, "backend"))), "{headline}");
    assert!(headline.contains(&basis), "{headline}");
    let number = headline.split("**").nth(1).expect("a number in large print");
    assert!(is_rounded(number, ratio(best)), "{headline}");
    let said = format!("over the {} pairs of task and family that all", value(best, "basis"));
    assert!(readme.replace('\n', " ").contains(&said), "README says on what the last column is: {said}");
}

#[test]
fn a_table_that_differs_is_seen() {
    let page = "a\n\n| backend | time |\n| --- | ---: |\n| `exact` | 0.41× |\n\n| backend | other |\n";
    assert_eq!(table(page), [vec!["backend", "time"], vec!["---", "---:"], vec!["`exact`", "0.41×"]]);
    assert_ne!(table(page), table(&page.replace("0.41", "0.42")));
    assert!(is_rounded("0.41×", 0.4071) && !is_rounded("0.42×", 0.4071) && is_rounded("1.0×", 1.0));
    assert!(is_rounded("120×", 123.0) && !is_rounded("130×", 123.0) && is_rounded("27×", 26.9));
    let csv = rows("panel,ratio\nall,0.4\n");
    assert_eq!(value(&csv[0], "ratio"), "0.4");
}
