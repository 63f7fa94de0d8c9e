//! The table of a race.

use std::fmt::Write as _;

use crate::contest::{Made, Outcome};

/// The value below which a part of sorted values lies; NaN if there are none.
fn percentile(sorted: &[f64], part: f64) -> f64 {
    let last = sorted.len().saturating_sub(1);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
    let at = (part * last as f64).round() as usize;
    sorted.get(at).copied().unwrap_or(f64::NAN)
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_unstable_by(f64::total_cmp);
    values
}

/// Times in milliseconds, ratios to the first contestant and failures, as Markdown.
pub fn table(names: &[&str], pairs: &[Vec<Made>]) -> String {
    let mut text = format!("{} pairs; milliseconds of right results; ratios to {}\n\n", pairs.len(), names[0]);
    text += "| | right | median | 10 % | 90 % | 99 % | ratio: median | 10 % | 90 % \
             | refused | crashed | timed out | not closed | other volume |\n";
    text += "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for (at, name) in names.iter().enumerate() {
        let is_right = |made: &Made| made.outcome == Outcome::Right;
        let right = || pairs.iter().filter(|pair| is_right(&pair[at]));
        let times = sorted(right().map(|pair| 1e3 * pair[at].seconds));
        let ratios = sorted(right().filter(|pair| is_right(&pair[0])).map(|pair| pair[at].seconds / pair[0].seconds));
        let count = |outcome| pairs.iter().filter(|pair| pair[at].outcome == outcome).count();
        let [median, tenth, most, nearly] = [0.5, 0.1, 0.9, 0.99].map(|part| percentile(&times, part));
        let [ratio, low, high] = [0.5, 0.1, 0.9].map(|part| percentile(&ratios, part));
        let failures = [Outcome::Refused, Outcome::Crashed, Outcome::TimedOut, Outcome::Open, Outcome::Volume];
        let failures = failures.map(|outcome| count(outcome).to_string()).join(" | ");
        writeln!(
            text,
            "| {name} | {} | {median:.2} | {tenth:.2} | {most:.1} | {nearly:.1} | {ratio:.2} | {low:.2} | {high:.2} \
             | {failures} |",
            times.len()
        )
        .expect("a string");
    }
    text
}
