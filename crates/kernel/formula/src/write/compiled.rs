//! Estimates and filters of formulas in Rust, for programs that have them compiled.

use std::fmt::Write as _;

use super::{balanced, coordinates, filtered};
use crate::{Formula, Op};

/// A module with the estimate, and the estimate with its bound, of each formula; a function finds them by name.
///
/// The operations are those of the programs, in the same order.
#[must_use]
pub fn compiled(formulas: &[&Formula]) -> String {
    let mut text = "//! The shipped predicates, compiled: their estimates, and the bounds of these.
//!
//! `write::compiled` has written the file, and a test holds the file to it. Values are those of the interpreted
//! programs, bit by bit. Bounds can differ in the last bit, as the slack is added up in another order.

use super::Compiled;

/// 2^-960, the unit of the slack for underflow.
const SIGMA: f64 = f64::from_bits(63 << 52);

/// The predicate with this name.
pub(super) fn named(name: &str) -> Option<Compiled> {
    Some(match name {
"
    .to_owned();
    for formula in formulas {
        let name = formula.name();
        let _ = writeln!(text, "        \"{name}\" => Compiled {{ estimate: {name}, bounded: bounded_{name} }},");
    }
    text.push_str("        _ => return None,\n    })\n}\n");
    for formula in formulas {
        function(formula, false, &mut text);
        function(formula, true, &mut text);
    }
    text
}

fn function(formula: &Formula, is_bounded: bool, text: &mut String) {
    let name = formula.name();
    let (prefix, result) = if is_bounded { ("bounded_", "[f64; 2]") } else { ("", "f64") };
    let _ = writeln!(text, "\nfn {prefix}{name}(points: &[&[f64]]) -> {result} {{");
    let is_used = |point: usize, axis: usize| {
        let reads = |op: &Op| matches!(*op, Op::Coordinate { point: p, axis: a } if (p, a) == (point, axis));
        formula.program().ops().iter().any(reads)
    };
    let points = (0..formula.arity()).map(|point| {
        let names = coordinates(formula, point).into_iter().enumerate();
        let names = names.map(|(axis, name)| if is_used(point, axis) { name } else { "_".to_owned() });
        format!("&[{}]", names.collect::<Vec<_>>().join(", "))
    });
    let _ = writeln!(text, "    let &[{}] = points else {{", points.collect::<Vec<_>>().join(", "));
    let missing = if is_bounded { "[0.0, f64::NAN]" } else { "f64::NAN" };
    let _ = writeln!(text, "        return {missing};\n    }};");
    let filter = filtered(formula, |name| format!("{name}.abs()"), |number| format!("{number:?}"));
    for line in &filter.values {
        let _ = writeln!(text, "    let {} = {};", line.name, line.value);
    }
    let [value, magnitude] = &filter.result;
    if !is_bounded {
        let _ = writeln!(text, "    {value}\n}}");
        return;
    }
    for line in &filter.magnitudes {
        let _ = writeln!(text, "    let {} = {};", line.name, line.value);
    }
    let slack = match filter.power {
        None => "0.0".to_owned(),
        Some(0) => "SIGMA * 2.0".to_owned(),
        Some(power) => {
            let _ = writeln!(text, "    let sum = {};", balanced(&filter.leaves));
            format!("SIGMA * (1.0 + {})", vec!["sum"; power as usize].join(" * "))
        }
    };
    let constant = formula.filter().constant();
    let bound = if constant > 0.0 { format!("{constant:e} * {magnitude} + {slack}") } else { slack };
    let _ = writeln!(text, "    [{value}, {bound}]\n}}");
}
