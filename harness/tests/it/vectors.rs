//! The published test vectors: the tool makes the same rows again, ids are unique, and flags are counted again in
//! rationals.

use std::collections::BTreeSet;

use predicament_formats::hexfloat;
use rug::Rational;
use serde_json::Value;

use crate::common::expect;

/// The bytes that a packed file may have.
const MOST: usize = 5_000_000;

fn published(name: &str) -> String {
    let packed = std::fs::read(format!("../vectors/{name}.json.gz")).unwrap();
    assert!(packed.len() < MOST, "{name}: {} bytes", packed.len());
    let mut text = String::new();
    std::io::Read::read_to_string(&mut flate2::read::GzDecoder::new(&packed[..]), &mut text).unwrap();
    text
}

fn rows(text: &str) -> Vec<Value> {
    serde_json::from_str::<Value>(text).unwrap()["rows"].as_array().unwrap().clone()
}

#[test]
fn the_suites_give_the_published_rows_again() {
    for (name, suite, scene) in [
        ("vectors", "predicament-vectors-1", "uniform-incircle"),
        ("vectors", "predicament-vectors-1", "decimals-orient2d-metres-general-1"),
        ("tasks", "predicament-task-vectors-1", "hull-sliver-3"),
        ("tasks", "predicament-task-vectors-1", "parcels-survey-rectangle-2"),
    ] {
        let text = published(name);
        let ids: BTreeSet<String> = rows(&text).iter().map(|row| row["id"].to_string()).collect();
        assert_eq!(ids.len(), rows(&text).len(), "{name}: ids are unique");
        let file = format!("../vectors/{suite}.toml");
        let made = expect(0, &["corpus", "gen", &file, "-f", &format!("/{scene}$"), "--json"]).stdout;
        let made: Vec<&str> = made.lines().skip(1).filter(|line| line.starts_with('{')).collect();
        assert!(!made.is_empty(), "{scene}");
        let line = |row: &&str| row.trim_end_matches(',').to_owned();
        let published: BTreeSet<String> = text.lines().map(|row| line(&row)).collect();
        assert!(made.iter().all(|row| published.contains(&line(row))), "{scene}: other rows than the published ones");
    }
}

/// Products of a determinant beyond the largest double, and bits of the determinant below the smallest.
fn beyond(row: &Value) -> Option<[bool; 2]> {
    let number = |x: &Value| Rational::from_f64(hexfloat::parse(x.as_str()?).ok()?);
    let point = |v: &Value| -> Option<Vec<Rational>> {
        row["hex"][v.as_str()?.parse::<usize>().ok()?].as_array()?.iter().map(number).collect()
    };
    let points: Vec<Vec<Rational>> = row["vertices"].as_array()?.iter().map(point).collect::<Option<_>>()?;
    let is_lifted = ["incircle", "insphere"].contains(&row["predicate"].as_str()?);
    if row["predicate"] == "compare" || row.get("plane").is_some() {
        return None;
    }
    let (last, rest) = points.split_last()?;
    let rows: Vec<Vec<Rational>> = rest
        .iter()
        .map(|point| {
            let mut of: Vec<Rational> = point.iter().zip(last).map(|(x, y)| Rational::from(x - y)).collect();
            if is_lifted {
                of.push(of.iter().map(|x| Rational::from(x * x)).sum());
            }
            of
        })
        .collect();
    let (mut sum, mut largest) = (Rational::new(), Rational::new());
    products(&rows, &mut (0..rows.len()).collect(), 0, &mut |product| {
        largest = largest.clone().max(product.clone().abs());
        sum += product;
    });
    let limit = Rational::from(rug::Integer::from(1) << 1024);
    Some([largest >= limit, sum.denom().significant_bits() > 1075])
}

/// All products of a determinant, with their signs.
fn products(rows: &[Vec<Rational>], columns: &mut Vec<usize>, from: usize, each: &mut impl FnMut(Rational)) {
    if from == columns.len() {
        let inversions = (0..from).flat_map(|j| (0..j).map(move |i| (i, j)));
        let odd = inversions.filter(|&(i, j)| columns[i] > columns[j]).count() % 2 == 1;
        let product: Rational = rows.iter().zip(columns.iter()).map(|(row, &column)| &row[column]).product();
        return each(if odd { -product } else { product });
    }
    for at in from..columns.len() {
        columns.swap(from, at);
        products(rows, columns, from + 1, each);
        columns.swap(from, at);
    }
}

/// The rows that need a flag and do not have it, and the numbers of rows that need each.
fn counted(rows: &[Value]) -> (Vec<String>, [usize; 2]) {
    let (mut missing, mut needed) = (Vec::new(), [0; 2]);
    for row in rows {
        let Some(is) = beyond(row) else { continue };
        for ((flag, is), needed) in ["overflow", "underflow"].into_iter().zip(is).zip(&mut needed) {
            *needed += usize::from(is);
            if is && !row["flags"].as_array().unwrap().iter().any(|own| own == flag) {
                missing.push(format!("{}: {flag}", row["id"]));
            }
        }
    }
    (missing, needed)
}

#[test]
fn flags_say_what_rationals_say() {
    let all = rows(&published("vectors"));
    assert_eq!(all.len(), 20_000);
    // Every row of the wide families, and a sample of the others.
    let is_wide = |row: &Value| row["source"].as_str().unwrap().contains("wide");
    let asked: Vec<Value> = all
        .into_iter()
        .enumerate()
        .filter(|(at, row)| at % 8 == 0 || (is_wide(row) && at % 2 == 0))
        .map(|(_, row)| row)
        .collect();
    let (missing, needed) = counted(&asked);
    assert!(missing.is_empty(), "{missing:?}");
    assert!(needed.iter().all(|&count| count > 20), "{needed:?}");
    // A planted fault: rows without their flags.
    let mut stripped = asked;
    stripped.iter_mut().for_each(|row| row["flags"] = Value::Array(Vec::new()));
    assert_eq!(counted(&stripped).0.len(), needed.iter().sum::<usize>());
}
