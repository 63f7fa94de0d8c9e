//! Precision plans as text.

use predicament_arithmetic::Span;
use predicament_exact::{Choice, Precision};

/// The lines of a precision plan.
pub fn lines(precision: &Precision) -> Vec<String> {
    let axes = precision.axes.iter().zip(["x", "y", "z"]).map(|(span, name)| axis(name, span));
    let all = format!("all: multiples of 2^{}, differences of {} bits", precision.lowest, precision.bits);
    axes.chain([all]).chain(precision.choices.iter().map(choice)).collect()
}

fn axis(name: &str, span: &Span) -> String {
    match span.range {
        Some(range) => format!(
            "{name}:   {:e} to {:e}; multiples of 2^{}, less than 2^{}",
            span.min, span.max, range.lowest, range.highest
        ),
        None => format!("{name}:   all zero"),
    }
}

fn choice(choice: &Choice) -> String {
    let filter = match choice.static_bound {
        Some(0.0) => "no filter: doubles make no error".to_owned(),
        Some(bound) => format!("doubles are trusted from {bound:e} on, then {}", choice.arithmetic.name()),
        None => format!("no filter holds: {}", choice.arithmetic.name()),
    };
    format!("{:<9} {filter}", choice.predicate.to_string())
}
