//! A predicate in Rust.

use std::fmt::Write as _;

use super::{Cases, balanced, coordinate, coordinates, filtered, heading, identifier};
use crate::{Formula, Op};

/// Exact numbers, in as few lines as they take.
const EXACT: &str = include_str!("exact.rs.txt");

/// The predicate as a Rust file: a function, exact numbers, and tests of these cases.
#[must_use]
pub fn rust(formula: &Formula, cases: &Cases) -> String {
    let mut text = String::new();
    for line in heading(formula) {
        let _ = writeln!(text, "{}", format!("//! {line}").trim_end());
    }
    text.push_str("\nuse std::cmp::Ordering;\n\n");
    let (name, count) = (identifier(formula), formula.coordinates());
    let parameters: Vec<String> = formula.points().iter().map(|point| format!("{point}: [f64; {count}]")).collect();
    let _ = writeln!(text, "/// The sign, for any finite coordinates{}.", weights(formula));
    let _ = writeln!(text, "pub fn {name}({}) -> Ordering {{", parameters.join(", "));
    unpack(formula, &mut text);
    let filter = filtered(formula, |name| format!("{name}.abs()"), |number| format!("{number:?}"));
    for line in filter.values.iter().chain(&filter.magnitudes) {
        let _ = writeln!(text, "    let {} = {};", line.name, line.value);
    }
    let [value, magnitude] = &filter.result;
    let slack = match filter.power {
        None => "0.0".to_owned(),
        Some(0) => {
            let _ = writeln!(text, "    const SIGMA: f64 = {:e}; // 2^-960", 2f64.powi(-960));
            "SIGMA * 2.0".to_owned()
        }
        Some(power) => {
            let _ = writeln!(text, "    let sum = {};", balanced(&filter.leaves));
            let powers = vec!["sum"; power as usize].join(" * ");
            let _ = writeln!(text, "    const SIGMA: f64 = {:e}; // 2^-960", 2f64.powi(-960));
            format!("SIGMA * (1.0 + {powers})")
        }
    };
    let constant = formula.filter().constant();
    let bound = if constant > 0.0 { format!("{constant:e} * {magnitude} + {slack}") } else { slack };
    let _ = writeln!(text, "    let bound = {bound};");
    let _ = writeln!(text, "    if {value}.abs() > bound {{");
    let _ = writeln!(
        text,
        "        return if {value}.is_sign_negative() {{ Ordering::Less }} else {{ Ordering::Greater }};"
    );
    let arguments = formula.points().join(", ");
    let _ = writeln!(text, "    }}\n    {name}_exact({arguments})\n}}\n");
    let _ = writeln!(text, "/// The sign by exact numbers alone.");
    let _ = writeln!(text, "#[cold]\n#[inline(never)]\nfn {name}_exact({}) -> Ordering {{", parameters.join(", "));
    unpack(formula, &mut text);
    exact_lines(formula, &mut text);
    let _ = writeln!(text, "}}\n\n{}", EXACT.trim_end());
    tests(formula, cases, &mut text);
    text
}

fn weights(formula: &Formula) -> &'static str {
    if formula.is_weighted() { "; the last coordinate is the weight" } else { "" }
}

fn unpack(formula: &Formula, text: &mut String) {
    for (at, point) in formula.points().iter().enumerate() {
        let used = |axis: usize| {
            let is_used = formula
                .program()
                .ops()
                .iter()
                .any(|&op| matches!(op, Op::Coordinate { point, axis: of } if point == at && of == axis));
            if is_used { coordinate(formula, at, axis) } else { "_".to_owned() }
        };
        let names: Vec<String> = (0..coordinates(formula, at).len()).map(used).collect();
        let _ = writeln!(text, "    let [{}] = {point};", names.join(", "));
    }
}

fn exact_lines(formula: &Formula, text: &mut String) {
    let ops = formula.program().ops();
    for (at, &op) in ops.iter().enumerate() {
        let value = match op {
            Op::Coordinate { point, axis } => format!("Exact::new({})", coordinate(formula, point, axis)),
            Op::Constant(number) => format!("Exact::new({number:?})"),
            Op::Add(a, b) => format!("e{a}.plus(&e{b}, false)"),
            Op::Sub(a, b) => format!("e{a}.plus(&e{b}, true)"),
            Op::Mul(a, b) => format!("e{a}.times(&e{b})"),
            Op::Neg(a) => format!("e{a}.negated()"),
        };
        if at + 1 == ops.len() {
            let _ = writeln!(text, "    {value}.sign()");
        } else {
            let _ = writeln!(text, "    let e{at} = {value};");
        }
    }
}

fn tests(formula: &Formula, cases: &Cases, text: &mut String) {
    if cases.is_empty() {
        return;
    }
    let name = identifier(formula);
    text.push_str("\n#[cfg(test)]\nmod tests {\n    use super::*;\n\n    #[test]\n    fn signs_are_right() {\n");
    text.push_str("        let bits = f64::from_bits;\n");
    for (points, sign) in cases {
        let point = |point: &Vec<f64>| {
            let numbers: Vec<String> = point.iter().map(|x| format!("bits(0x{:016x})", x.to_bits())).collect();
            format!("[{}]", numbers.join(", "))
        };
        let arguments: Vec<String> = points.iter().map(point).collect();
        let sign = ["Less", "Equal", "Greater"][usize::try_from(sign + 1).unwrap_or(1)];
        let _ = writeln!(text, "        assert_eq!({name}({}), Ordering::{sign});", arguments.join(", "));
    }
    text.push_str("    }\n}\n");
}
