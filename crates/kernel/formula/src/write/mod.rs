//! Source code of a predicate: the filter, and exact numbers behind it, in one file without dependencies.
//!
//! The code has the operations of the program in the program's order. So the filter's proof holds for it, if the
//! compiler neither contracts products and sums to fused operations nor uses wider registers.

mod compiled;
mod cpp;
mod python;
mod rust;

pub use compiled::compiled;
pub use cpp::{cpp, cpp_engine};
pub use python::python;
pub use rust::rust;

use crate::{Accuracy, Formula, Op, Slack};

/// Points for the tests of generated code, with the sign at each, from an exact evaluation of the caller's.
pub type Cases = [(Vec<Vec<f64>>, i8)];

/// The name of a coordinate's variable.
fn coordinate(formula: &Formula, point: usize, axis: usize) -> String {
    let is_weight = axis == formula.dimension();
    format!("{}{}", formula.points()[point], if is_weight { 'w' } else { ['x', 'y', 'z'][axis.min(2)] })
}

/// The variables of all coordinates of a point, in order.
fn coordinates(formula: &Formula, point: usize) -> Vec<String> {
    (0..formula.coordinates()).map(|axis| coordinate(formula, point, axis)).collect()
}

/// The name as an identifier: letters, digits and underscores, not beginning with a digit.
fn identifier(formula: &Formula) -> String {
    let name: String =
        formula.name().chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' }).collect();
    if name.starts_with(|c: char| c.is_ascii_digit()) { format!("p{name}") } else { name }
}

/// One line of straight-line code: a variable, and its expression in the notation that C, Rust and Python share.
struct Line {
    name: String,
    value: String,
}

/// The lines of the filter: values, then magnitudes where they differ from the values.
struct Filtered {
    values: Vec<Line>,
    magnitudes: Vec<Line>,
    /// The expressions of the result and of its magnitude.
    result: [String; 2],
    /// The magnitudes whose sum the slack needs, and its power.
    leaves: Vec<String>,
    power: Option<u32>,
}

/// The filter as lines; `abs` writes the absolute value of a variable, `number` a constant.
fn filtered(formula: &Formula, abs: impl Fn(&str) -> String, number: impl Fn(f64) -> String) -> Filtered {
    let (ops, filter) = (formula.program().ops(), formula.filter());
    let mut names: Vec<String> = Vec::new();
    let mut sizes: Vec<String> = Vec::new();
    let (mut values, mut magnitudes) = (Vec::new(), Vec::new());
    for (at, &op) in ops.iter().enumerate() {
        let of = |at: usize| names[at].clone();
        let value = match op {
            Op::Coordinate { point, axis } => {
                names.push(coordinate(formula, point, axis));
                sizes.push(abs(&names[at]));
                continue;
            }
            Op::Constant(constant) => {
                names.push(number(constant));
                sizes.push(number(constant.abs()));
                continue;
            }
            Op::Add(a, b) => format!("{} + {}", of(a), of(b)),
            Op::Sub(a, b) => format!("{} - {}", of(a), of(b)),
            Op::Mul(a, b) => format!("{} * {}", of(a), of(b)),
            Op::Neg(a) => format!("-{}", of(a)),
        };
        let name = format!("v{at}");
        values.push(Line { name: name.clone(), value });
        let size = match (filter.errors()[at].accuracy, op) {
            (Accuracy::Magnitude, Op::Add(a, b) | Op::Sub(a, b)) => Some(format!("{} + {}", sizes[a], sizes[b])),
            (Accuracy::Magnitude, Op::Mul(a, b)) => Some(format!("{} * {}", sizes[a], sizes[b])),
            (Accuracy::Magnitude, Op::Neg(a)) => {
                names.push(name);
                sizes.push(sizes[a].clone());
                continue;
            }
            _ => None,
        };
        match size {
            Some(value) => {
                magnitudes.push(Line { name: format!("m{at}"), value });
                sizes.push(format!("m{at}"));
            }
            // A value that is never negative is its own magnitude.
            None if filter.errors()[at].is_nonnegative => sizes.push(name.clone()),
            None => sizes.push(abs(&name)),
        }
        names.push(name);
    }
    let last = ops.len() - 1;
    let power = match filter.slack() {
        Slack::None => None,
        Slack::Power(power) => Some(power),
    };
    let leaves = filter.leaves().iter().map(|&at| sizes[at].clone()).collect();
    Filtered { values, magnitudes, result: [names[last].clone(), sizes[last].clone()], leaves, power }
}

/// The sum of terms as a balanced tree, which has the fewest additions one after another.
fn balanced(terms: &[String]) -> String {
    let half = terms.len().div_ceil(2);
    match terms {
        [] => "0.0".to_owned(),
        [one] => one.clone(),
        [_, _] => terms.join(" + "),
        _ => {
            let [first, second] = [&terms[..half], &terms[half..]].map(|part| (balanced(part), part.len()));
            let bracket = |(sum, count): (String, usize)| if count > 1 { format!("({sum})") } else { sum };
            format!("{} + {}", bracket(first), bracket(second))
        }
    }
}

/// The comment at the top of a file, line by line.
fn heading(formula: &Formula) -> Vec<String> {
    let [n, m] = formula.filter().roundings();
    let signature = format!("{}({})", identifier(formula), formula.points().join(", "));
    let mut lines = vec![format!("{signature}: {}.", formula.about()), String::new()];
    lines.push("The sign of".to_owned());
    lines.extend(formula.text().split(';').map(|part| format!("    {}", part.trim())));
    lines.push(String::new());
    lines.push(format!(
        "Degree {}. The filter holds for all finite doubles: a term goes through {n} roundings, a term of the magnitude",
        formula.polynomial().degree()
    ));
    lines.push(format!(
        "through {m}, and sigma = 2^-960 covers underflow. The exact numbers behind it never round. Written by"
    ));
    lines.push("`predicament derive`; docs/FORMULAS.md of that project has the proof.".to_owned());
    lines
}
