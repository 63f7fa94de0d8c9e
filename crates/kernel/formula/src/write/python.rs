//! A predicate in Python.

use std::fmt::Write as _;

use super::{Cases, balanced, coordinates, filtered, heading, identifier};
use crate::Formula;

/// The predicate as a Python file: a function, tests of these cases, and an engine.
///
/// Exact numbers are `fractions.Fraction`. Run as a program the file is an engine, with `predicament_engine.py` beside
/// it; with `--test` it runs its tests.
#[must_use]
pub fn python(formula: &Formula, cases: &Cases) -> String {
    let name = identifier(formula);
    let mut text = "\"\"\"".to_owned();
    for line in heading(formula) {
        let _ = writeln!(text, "{line}");
    }
    text.push_str("\"\"\"\n\nimport sys\nfrom fractions import Fraction\n\n\n");
    let parameters = formula.points().join(", ");
    let _ = writeln!(text, "def {name}({parameters}):");
    let _ = writeln!(text, "    \"\"\"The sign, -1, 0 or 1, for any finite coordinates.\"\"\"");
    let unpack = |text: &mut String| {
        for (at, point) in formula.points().iter().enumerate() {
            let _ = writeln!(text, "    {} = {point}", coordinates(formula, at).join(", "));
        }
    };
    unpack(&mut text);
    let filter = filtered(formula, |name| format!("abs({name})"), |number| format!("{number:?}"));
    for line in filter.values.iter().chain(&filter.magnitudes) {
        let _ = writeln!(text, "    {} = {}", line.name, line.value);
    }
    let [value, magnitude] = &filter.result;
    let slack = match filter.power {
        None => "0.0".to_owned(),
        Some(0) => "2.0**-959".to_owned(),
        Some(power) => {
            let _ = writeln!(text, "    sizes = {}", balanced(&filter.leaves));
            format!("2.0**-960 * (1.0 + {})", vec!["sizes"; power as usize].join(" * "))
        }
    };
    let constant = formula.filter().constant();
    let bound = if constant > 0.0 { format!("{constant:e} * {magnitude} + {slack}") } else { slack };
    let _ = writeln!(text, "    bound = {bound}");
    let _ = writeln!(text, "    if abs({value}) > bound:");
    let _ = writeln!(text, "        return 1 if {value} > 0 else -1");
    let _ = writeln!(text, "    return {name}_exact({parameters})\n\n");
    let _ = writeln!(text, "def {name}_exact({parameters}):");
    let _ = writeln!(text, "    \"\"\"The sign by fractions alone.\"\"\"");
    let points: Vec<String> = formula.points().iter().map(|point| format!("[Fraction(x) for x in {point}]")).collect();
    let _ = writeln!(text, "    {} = {}", formula.points().join(", "), points.join(", "));
    unpack(&mut text);
    for line in &filtered(formula, |name| name.to_owned(), |number| format!("{number:.0}")).values {
        let _ = writeln!(text, "    {} = {}", line.name, line.value);
    }
    let _ = writeln!(text, "    return ({value} > 0) - ({value} < 0)\n\n");
    text.push_str("def test():\n    \"\"\"Compares signs with exact ones, at points near and on the zeros.\"\"\"\n");
    text.push_str("    hexes = float.fromhex\n");
    for (points, sign) in cases {
        let point = |point: &Vec<f64>| {
            let numbers: Vec<String> = point.iter().map(|x| format!("hexes(\"{}\")", hex(*x))).collect();
            format!("({})", numbers.join(", "))
        };
        let arguments: Vec<String> = points.iter().map(point).collect();
        let _ = writeln!(text, "    assert {name}({}) == {sign}", arguments.join(", "));
    }
    let _ = write!(
        text,
        "\n\nclass Engine:\n    name = \"{name}\"\n    version = \"1.0\"\n    zero = \"exact\"\n    \
         formulas = {{\"{}\": ({}, {})}}\n\n    {name} = staticmethod({name})\n\n\n\
         if __name__ == \"__main__\":\n    if sys.argv[1:] == [\"--test\"]:\n        test()\n    else:\n        \
         import predicament_engine\n\n        predicament_engine.serve(Engine())\n",
        formula.name(),
        formula.arity(),
        formula.dimension(),
    );
    text
}

/// A double as Python's `float.fromhex` reads it.
pub(super) fn hex(x: f64) -> String {
    let bits = x.to_bits();
    let (field, fraction) = (bits >> 52 & 0x7ff, bits & ((1 << 52) - 1));
    let sign = if x.is_sign_negative() { "-" } else { "" };
    let (lead, field) = if field == 0 { (0, 1) } else { (1, field) };
    format!("{sign}0x{lead}.{fraction:013x}p{}", i64::try_from(field).unwrap_or(0) - 1023)
}
