//! A predicate in C++17.

use std::fmt::Write as _;

use super::python::hex;
use super::{Cases, balanced, coordinate, filtered, heading, identifier};
use crate::{Formula, Op};

/// Exact numbers.
const EXACT: &str = include_str!("exact.hpp.txt");

/// The predicate as a C++ header: a function, exact numbers, and a function that runs tests of these cases.
#[must_use]
pub fn cpp(formula: &Formula, cases: &Cases) -> String {
    let mut text = String::new();
    for line in heading(formula) {
        let _ = writeln!(text, "{}", format!("// {line}").trim_end());
    }
    text.push_str(
        "// Compile with -ffp-contract=off: the proof is about separate products and sums.\n#pragma once\n\n",
    );
    for header in ["algorithm", "array", "cmath", "cstddef", "cstdint", "cstring", "utility", "vector"] {
        let _ = writeln!(text, "#include <{header}>");
    }
    let name = identifier(formula);
    let _ = writeln!(
        text,
        "\nnamespace {name}_predicate {{\n\nusing Point = std::array<double, {}>;\n",
        formula.coordinates()
    );
    text.push_str(EXACT.trim_end());
    let parameters: Vec<String> = formula.points().iter().map(|point| format!("const Point& {point}")).collect();
    let (parameters, arguments) = (parameters.join(", "), formula.points().join(", "));
    let _ = writeln!(text, "\n\n// The sign by exact numbers alone.\ninline int {name}_exact({parameters}) {{");
    let ops = formula.program().ops();
    for (at, &op) in ops.iter().enumerate() {
        let value = match op {
            Op::Coordinate { point, axis } => format!("Exact::of({}[{axis}])", formula.points()[point]),
            Op::Constant(number) => format!("Exact::of({number:?})"),
            Op::Add(a, b) => format!("e{a} + e{b}"),
            Op::Sub(a, b) => format!("e{a} - e{b}"),
            Op::Mul(a, b) => format!("e{a} * e{b}"),
            Op::Neg(a) => format!("-e{a}"),
        };
        let _ = writeln!(text, "    const Exact e{at} = {value};");
    }
    let _ = writeln!(text, "    return e{}.sign();\n}}\n", ops.len() - 1);
    let _ = writeln!(text, "// The sign, -1, 0 or 1, for any finite coordinates.");
    let _ = writeln!(text, "inline int {name}({parameters}) {{");
    for (point, of) in formula.points().iter().enumerate() {
        for axis in 0..formula.coordinates() {
            let reads = |op: &Op| matches!(*op, Op::Coordinate { point: p, axis: a } if (p, a) == (point, axis));
            if ops.iter().any(reads) {
                let _ = writeln!(text, "    const double {} = {of}[{axis}];", coordinate(formula, point, axis));
            }
        }
    }
    let filter = filtered(formula, |name| format!("std::fabs({name})"), |number| format!("{number:?}"));
    for line in filter.values.iter().chain(&filter.magnitudes) {
        let _ = writeln!(text, "    const double {} = {};", line.name, line.value);
    }
    let [value, magnitude] = &filter.result;
    let slack = match filter.power {
        None => "0.0".to_owned(),
        Some(0) => "2.0 * sigma".to_owned(),
        Some(power) => {
            let _ = writeln!(text, "    const double sum = {};", balanced(&filter.leaves));
            format!("sigma * (1.0 + {})", vec!["sum"; power as usize].join(" * "))
        }
    };
    if filter.power.is_some() {
        let _ = writeln!(text, "    const double sigma = 0x1p-960;");
    }
    let constant = formula.filter().constant();
    let bound = if constant > 0.0 { format!("{constant:e} * {magnitude} + {slack}") } else { slack };
    let _ = writeln!(text, "    const double bound = {bound};");
    let _ = writeln!(text, "    if (std::fabs({value}) > bound) return {value} > 0 ? 1 : -1;");
    let _ = writeln!(text, "    return {name}_exact({arguments});\n}}\n");
    let _ = writeln!(text, "// The number of wrong signs at points near and on the zeros.");
    let _ = writeln!(text, "inline int failures() {{\n    int wrong = 0;");
    for (points, sign) in cases {
        let point = |point: &Vec<f64>| {
            let numbers: Vec<String> = point.iter().map(|&x| hex(x)).collect();
            format!("Point{{{}}}", numbers.join(", "))
        };
        let arguments: Vec<String> = points.iter().map(point).collect();
        let _ = writeln!(text, "    wrong += {name}({}) != {sign};", arguments.join(", "));
    }
    let _ = writeln!(text, "    return wrong;\n}}\n\n}}  // namespace {name}_predicate");
    text
}

/// An engine of the predicate in C++, for the header of [`cpp`] and `predicament_engine.hpp`; with `--test` it runs the
/// tests.
///
/// The engine's name is `engine`.
#[must_use]
pub fn cpp_engine(formula: &Formula, engine: &str) -> String {
    let (name, called) = (identifier(formula), formula.name());
    let (mut parameters, mut arguments) = (Vec::new(), Vec::new());
    for point in formula.points() {
        let coordinates: Vec<String> = (0..formula.coordinates()).map(|axis| format!("{point}[{axis}]")).collect();
        parameters.push(format!("const double* {point}"));
        arguments.push(format!("{{{}}}", coordinates.join(", ")));
    }
    format!(
        "// The engine {engine} of the tool predicament; with --test, the tests of {called}.hpp.
#include <cstdio>
#include <cstring>
#include <string>
#include <tuple>

#include \"{called}.hpp\"
#include \"predicament_engine.hpp\"

namespace {{

int sign({parameters}) {{
    return {name}_predicate::{name}({arguments});
}}

struct Engine {{
    static constexpr const char* name = \"{engine}\";
    static constexpr predicament::Zero zero = predicament::Zero::exact;
    static std::string version() {{ return \"1.0\"; }}
    static constexpr auto formulas = std::make_tuple(predicament::formula<{arity}>(\"{called}\", {dimension}, sign));
}};

}}  // namespace

int main(int argc, char** argv) {{
    if (argc == 2 && std::strcmp(argv[1], \"--test\") == 0) {{
        const int wrong = {name}_predicate::failures();
        std::printf(\"%d wrong signs\\n\", wrong);
        return wrong == 0 ? 0 : 1;
    }}
    return predicament::serve<Engine>(argc, argv);
}}
",
        parameters = parameters.join(", "),
        arguments = arguments.join(", "),
        arity = formula.arity(),
        dimension = formula.dimension(),
    )
}
