//! Tests that the sample report and its figures agree.

use std::path::Path;

fn read(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(file);
    std::fs::read_to_string(&path).unwrap_or_else(|why| panic!("{}: {why}", path.display())).replace("\r\n", "\n")
}

/// The cells of a page's first table about backends, row by row, after a heading if there is one.
fn table(page: &str) -> Vec<Vec<&str>> {
    let page = page.split_once("## Which backend to use").map_or(page, |(_, rest)| rest);
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

/// Returns true if a factor such as `0.41×` is this ratio, rounded to its digits.
fn is_rounded(factor: &str, ratio: f64) -> bool {
    let digits = factor.trim_end_matches('×').replace(',', "");
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let decimals = i32::try_from(decimals).unwrap_or(i32::MAX);
    // Two digits of a number of at least 100 are rounded to tens or more.
    let unit =
        if decimals == 0 { 10_f64.powi(i32::try_from(digits.len()).unwrap_or(2) - 2) } else { 0.1_f64.powi(decimals) };
    digits.parse().is_ok_and(|shown: f64| (shown - ratio).abs() <= 0.501 * unit)
}

fn number(row: &[(&str, &str)], column: &str) -> f64 {
    value(row, column).parse().unwrap_or_else(|_| panic!("{column} is no number: {row:?}"))
}

#[test]
fn the_sample_report_has_its_first_table() {
    let report = read("reports/sample/report.md");
    let table = table(&report);
    assert!(table.len() > 8 && table[0].len() > 10, "{table:?}");
    for column in
        ["undecided", "wrong", "not done", "broken", "single query / naive", "batch / naive", "whole scene / naive"]
    {
        assert!(table[0].contains(&column), "{column}: {table:?}");
    }
}

#[test]
fn the_figures_agree_with_the_table() {
    let (report, csv) = (read("reports/sample/report.md"), read("reports/sample/figures.csv"));
    let (figures, table) = (rows(&csv), table(&report));
    let backends = &table[2..];
    for cells in backends {
        let of: Vec<_> = figures.iter().filter(|row| is_of(row, "all", cells[0])).collect();
        assert!(!of.is_empty(), "{} is not in figures.csv", cells[0]);
        for row in of {
            let shares: f64 = ["right", "undecided", "wrong", "not_done"].map(|share| number(row, share)).iter().sum();
            assert_eq!(shares, number(row, "queries"), "{row:?}");
            let at = |head: &str| table[0].iter().position(|cell| *cell == head).map_or("", |at| cells[at]);
            assert_eq!(at("answers").replace(',', ""), value(row, "queries"));
            let asked = match value(row, "interface") {
                "single" => at("single query / naive"),
                "batch" | "loop" => at("batch / naive"),
                "whole" => at("whole scene / naive"),
                _ => continue,
            };
            let (factor, basis) = asked.split_once(' ').unwrap_or_else(|| panic!("{asked}: {cells:?}"));
            assert!(is_rounded(factor, number(row, "ratio")), "{row:?}: {asked}");
            let families = format!("{} of {} families", value(row, "families"), value(row, "reference_families"));
            assert!(basis.contains(&families), "{row:?}: {asked}");
        }
    }
}

fn is_of(row: &[(&str, &str)], panel: &str, code: &str) -> bool {
    value(row, "panel") == panel && format!("`{}`", value(row, "backend")) == code
}

/// The cheapest backend that answers everything, is never wrong and breaks no law, with its time ratio for single
/// queries.
///
/// It considers rows of these panels. The ratio is the geometric mean over all their families.
fn cheapest<'c>(figures: &[Vec<(&str, &'c str)>], panels: &[&str]) -> Option<(&'c str, f64)> {
    let of_panels = || figures.iter().filter(|row| panels.contains(&value(row, "panel")));
    let faults = ["undecided", "wrong", "not_done", "scenes_broken", "scenes_not_done"];
    let mut names: Vec<&str> = of_panels().map(|row| value(row, "backend")).collect();
    names.sort_unstable();
    names.dedup();
    let priced = names.into_iter().filter_map(|name| {
        let own: Vec<_> = of_panels().filter(|row| value(row, "backend") == name).collect();
        let is_faultless = own.iter().all(|row| faults.iter().all(|fault| number(row, fault) == 0.0));
        let single: Vec<_> = own.iter().filter(|row| value(row, "interface") == "single").collect();
        let families: f64 = single.iter().map(|row| number(row, "families")).sum();
        let logs: f64 = single.iter().map(|row| number(row, "families") * number(row, "ratio").ln()).sum();
        (is_faultless && families > 0.0).then(|| (name, (logs / families).exp()))
    });
    priced.min_by(|a, b| a.1.total_cmp(&b.1))
}

#[test]
fn the_headline_is_the_rule_applied_to_the_figures() {
    let (report, csv) = (read("reports/sample/report.md"), read("reports/sample/figures.csv"));
    let figures = rows(&csv);
    let headline = report.lines().find(|line| line.contains("the price of being right")).expect("the headline");
    let everything = cheapest(&figures, &["all"]);
    // Shipped formulas are predicates as well.
    let catalogue = read("crates/kernel/formula/src/catalogue.rs");
    let formulas = catalogue.lines().filter_map(|line| line.trim().strip_prefix("name: \"")?.strip_suffix("\","));
    let question = read("crates/kernel/predicates/src/question.rs");
    let names = question.split_once("pub fn name(").expect("the names of predicates").1.lines();
    let names = names.take_while(|line| !line.starts_with("    }"));
    let own: Vec<&str> = names.filter_map(|line| line.trim().split_once(" => \"")?.1.strip_suffix("\",")).collect();
    assert_eq!(own.len(), 5, "{own:?}");
    let predicates: Vec<&str> = own.into_iter().chain(formulas).collect();
    assert!(predicates.len() > 5, "{predicates:?}");
    let (backend, ratio) = everything.or_else(|| cheapest(&figures, &predicates)).expect("a backend that is right");
    assert_eq!(headline.contains("on predicates alone"), everything.is_none(), "{headline}");
    assert!(headline.contains(&format!(": {backend} is the cheapest backend")), "{headline}");
    let shown = headline.split("**").nth(1).expect("a number in large print");
    assert!(is_rounded(shown, ratio), "{headline}: {ratio}");
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
