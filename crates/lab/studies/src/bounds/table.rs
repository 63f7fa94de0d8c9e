//! The derived bounds and the decided constraints as one CSV table: a row per bound, and per constraint and ε.

use predicament_error_calculus::Bound;
use predicament_tolerance::bounds::coefficient::defined;
use predicament_tolerance::bounds::constraints::{At, constraints, epsilons};
use predicament_tolerance::bounds::decimal::{rounded_up, scientific_down};
use predicament_tolerance::bounds::{Derivation, derivations, other_orders};
use serde::Serialize;

/// Decimals of c, a and b.
pub const DECIMALS: u32 = 4;

/// A row. Numbers that are not whole are rounded up, slacks down.
#[derive(Default, Serialize)]
struct Row<'a> {
    /// `bound`, `division` (bounds with û/m), `definition` or `constraint`.
    table: &'a str,
    section: &'a str,
    name: &'a str,
    published: String,
    derived: String,
    c: String,
    p: String,
    e: String,
    a: String,
    b: String,
    r: String,
    epsilon: &'a str,
    slack: String,
    verdict: &'a str,
    expression: &'a str,
}

/// The state of a quantity, as text; empty where it is invalid.
pub struct State {
    pub c: String,
    pub p: String,
    pub e: String,
    pub a: String,
    pub b: String,
    pub r: String,
}

/// c, p, e, a, b and r of a derived quantity.
pub fn state(derivation: &Derivation) -> State {
    let quantity = &derivation.quantity;
    let (magnitude, error) = (quantity.magnitude(), quantity.error());
    let of_magnitude =
        |text: fn(&predicament_error_calculus::Magnitude) -> String| magnitude.map(text).unwrap_or_default();
    State {
        c: of_magnitude(|m| rounded_up(&m.c, DECIMALS)),
        p: of_magnitude(|m| m.p().to_string()),
        e: of_magnitude(|m| m.e().to_string()),
        a: error.map(|error| rounded_up(&error.a, DECIMALS)).unwrap_or_default(),
        b: error.map(|error| rounded_up(&error.b, DECIMALS)).unwrap_or_default(),
        r: if quantity.is_valid() { u8::from(quantity.is_relative()).to_string() } else { String::new() },
    }
}

/// The derived coefficient of ε before it is made whole.
pub fn first(bound: Option<&Bound>) -> String {
    bound.map_or_else(|| "none".to_owned(), |bound| rounded_up(&bound.first, DECIMALS))
}

/// The table as CSV text.
///
/// # Errors
/// The errors of the CSV writer.
pub fn csv() -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let tables = [("bound", derivations()), ("division", other_orders())];
    for (table, derivation) in tables.iter().flat_map(|(table, rows)| rows.iter().map(move |row| (table, row))) {
        let State { c, p, e, a, b, r } = state(derivation);
        writer.serialize(Row {
            table,
            section: derivation.section,
            name: &derivation.name,
            published: derivation.published.map(|n| n.to_string()).unwrap_or_default(),
            derived: derivation.whole().map(|n| n.to_string()).unwrap_or_default(),
            c,
            p,
            e,
            a,
            b,
            r,
            verdict: derivation.verdict().as_str(),
            expression: derivation.quantity.expression(),
            ..Row::default()
        })?;
    }
    for row in defined() {
        writer.serialize(Row {
            table: "definition",
            section: row.section,
            name: &format!("{}₊ = {}", row.symbol, row.formula),
            published: row.tolerance.printed_upper.to_owned(),
            derived: rounded_up(&row.value().upper, DECIMALS),
            verdict: if row.is_as_printed() { "reproduced" } else { "other" },
            ..Row::default()
        })?;
    }
    for constraint in constraints() {
        for (epsilon, value) in epsilons() {
            let at = At::new(value);
            let slack = constraint.slack(&at).map(|slack| scientific_down(&slack.lower));
            writer.serialize(Row {
                table: "constraint",
                section: constraint.section,
                name: &constraint.text,
                epsilon,
                slack: slack.unwrap_or_default(),
                verdict: constraint.decide(&at).as_str(),
                ..Row::default()
            })?;
        }
    }
    writer.flush()?;
    let bytes = writer.into_inner().map_err(csv::IntoInnerError::into_error)?;
    Ok(String::from_utf8(bytes).expect("written from strings"))
}
