//! `derive`: a robust predicate from its polynomial.

use std::path::{Path, PathBuf};

use predicament_predicates::formula::{Formula, Order, write};
use predicament_predicates::{Derived, Sign};
use predicament_records::replace;
use predicament_tasks::signs::adversaries;
use predicament_tolerance::derived::error_bound;

use crate::exit::{self, Failure};
use crate::formulas;

const EXAMPLES: &str = "\
A formula is a polynomial in the coordinates of points: `a.x`, `a.y`, `a.z` and the weight `a.w`. `a - b` is a vector, \
`[u, s]` joins vectors and numbers, and det, dot, sq and cross are functions. `u = a - b;` names a part. All names \
that the formula does not define are points.

A TOML file has the keys `name` and `formula`, and perhaps `about`, `points` (their order) and `dimension`. With \
`--formula FILE` every other command knows the predicate by its name.

Examples:
  predicament derive 'det(a - c, b - c)'
  predicament derive 'sq(a - p) - sq(b - p)' --dimension 3 --name nearer --out nearer
  predicament derive power.toml --terms 40
  predicament ask --formula nearer/nearer.toml nearer 0,0 1,0 0,1
  predicament hunt --formula nearer/nearer.toml nearer -b naive";

/// Derive a robust predicate from a polynomial: its filter, bits, perturbation and code
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// A formula, or a TOML file with one
    #[arg(value_name = "FORMULA")]
    pub formula: String,

    /// The name of the predicate
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,

    /// The order of the points; alphabetical if left out
    #[arg(long, value_name = "POINTS", value_delimiter = ',')]
    pub points: Vec<String>,

    /// The number of coordinates of a point, without its weight; the smallest that fits if left out
    #[arg(long, value_name = "N")]
    pub dimension: Option<usize>,

    /// The number of perturbation terms to print
    #[arg(long, value_name = "N", default_value_t = 8)]
    pub terms: usize,

    /// A folder for the predicate in Rust, C++ and Python, with tests, and for its engines in C++ and Python
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// The number of test cases in written code.
const CASES: usize = 40;

/// Runs the command.
pub fn run(args: &Args) -> exit::Outcome {
    let mut definition = formulas::read(&args.formula)?;
    if let Some(name) = &args.name {
        definition.name.clone_from(name);
    }
    if !args.points.is_empty() {
        definition.points.clone_from(&args.points);
    }
    definition.dimension = args.dimension.or(definition.dimension);
    let formula = formulas::derive(definition)?;
    print(&formula, args.terms)?;
    if let Some(folder) = &args.out {
        let files = files(&formula);
        std::fs::create_dir_all(folder).map_err(Failure::io(folder))?;
        for (name, text) in &files {
            write_file(&folder.join(name), text)?;
        }
        say!();
        for (name, _) in &files {
            say!("{} written", folder.join(name).display());
        }
    }
    Ok(exit::OK)
}

fn print(formula: &Formula, most_terms: usize) -> Result<(), Failure> {
    let weight = if formula.is_weighted() { " and a weight" } else { "" };
    let polynomial = formula.polynomial();
    let homogeneous = if polynomial.is_homogeneous() { "homogeneous" } else { "not homogeneous" };
    say!("{}({}): {}", formula.name(), formula.points().join(", "), formula.about());
    say!("points           {} of {} coordinates{weight}", formula.arity(), formula.dimension());
    say!("polynomial       {} monomials, degree {}, {homogeneous}", polynomial.len(), polynomial.degree());
    let (swaps, turns) = (formula.swaps(), formula.swaps().iter().filter(|swap| swap.turns).count());
    say!("permutations     {} keep the sign, {turns} turn it", swaps.len() - turns);
    for swap in swaps.iter().filter(|swap| swap.to.len() <= 3 || swaps.len() <= 6) {
        let order: Vec<&str> = swap.to.iter().map(|&at| formula.points()[at].as_str()).collect();
        say!("                 {} of ({})", if swap.turns { "-" } else { "+" }, order.join(", "));
    }
    let [n, m] = formula.filter().roundings();
    let constant = formula.filter().constant();
    say!(
        "filter           |estimate| > {constant:e} * magnitude + slack: {n} roundings of a term, {m} of the magnitude"
    );
    let ones = vec![1.0; formula.coordinates()];
    let bound = formula.filter().static_bound(formula.program(), &ones, &ones);
    say!("static filter    {bound:e}, if coordinates and their differences are at most 1");
    let widths = [64, 128, 256, 512].map(|width| {
        let longest = formula.bits().longest(width);
        format!("{} in {width}", longest.map_or_else(|| "none".to_owned(), |bits| bits.to_string()))
    });
    say!("integers         coordinates of {} bits", widths.join(", "));
    say!("                 53-bit coordinates take {} bits with the sign", formula.bits().of(53));
    print_band(formula)?;
    print_terms(formula, most_terms)
}

fn print_band(formula: &Formula) -> Result<(), Failure> {
    let Ok(derived) = Derived::new(again(formula)?) else { return Ok(()) };
    match error_bound(derived) {
        Some((factor, power)) => {
            let step = factor + 1_u32;
            let [wide, upper] = [2, 3].map(|times: u32| step.clone() * times);
            say!("tolerance        T- = {step}, T = {wide}, T+ = {upper}, in units of eps * L^{power}");
        }
        None => say!("tolerance        T-, T, T+ = 1, 2, 3 times the static bound of a scene"),
    }
    Ok(())
}

fn print_terms(formula: &Formula, most: usize) -> Result<(), Failure> {
    let ranks: Vec<usize> = (0..formula.arity()).collect();
    let terms = formula.terms(&ranks, Order::FirstLargest).map_err(Failure::usage)?;
    let count = terms.programs().len();
    say!("perturbation     {count} terms for vertices in the order of their indices, x before y");
    let name = |variable: usize| {
        let (point, axis) = (variable / formula.coordinates(), variable % formula.coordinates());
        let axis = if axis == formula.dimension() { "w" } else { ["x", "y", "z"][axis.min(2)] };
        format!("{}.{axis}", formula.points()[point])
    };
    for (powers, term) in terms.powers().iter().zip(terms.coefficients()).take(most) {
        let powers = powers.iter().enumerate().filter(|(_, power)| **power > 0);
        let infinitesimals: Vec<String> = powers
            .map(|(at, power)| {
                format!("eps({}){}", name(at), if *power > 1 { format!("^{power}") } else { String::new() })
            })
            .collect();
        let monomial = |(exponents, coefficient): (&[u8], i128)| {
            let factors = exponents.iter().enumerate().filter(|(_, power)| **power > 0);
            let factors: Vec<String> = factors
                .map(|(at, power)| if *power > 1 { format!("{}^{power}", name(at)) } else { name(at) })
                .collect();
            match (coefficient, factors.is_empty()) {
                (_, true) => format!("{coefficient:+}"),
                (1, _) => format!("+ {}", factors.join(" ")),
                (-1, _) => format!("- {}", factors.join(" ")),
                _ => format!("{coefficient:+} {}", factors.join(" ")),
            }
        };
        let shown: Vec<String> = term.terms().take(6).map(monomial).collect();
        let more = if term.len() > 6 { format!(" ... ({} monomials)", term.len()) } else { String::new() };
        say!("  {:<32} {}{more}", infinitesimals.join(" "), shown.join(" "));
    }
    if count > most {
        say!("  {} more; --terms {count} prints all", count - most);
    }
    Ok(())
}

/// The same formula as a value of its own.
fn again(formula: &Formula) -> Result<Formula, Failure> {
    formulas::derive(formula.definition().clone())
}

/// The files of the predicate: code in three languages, the formula, and engines in Python and C++.
fn files(formula: &Formula) -> Vec<(String, String)> {
    let cases: Vec<(Vec<Vec<f64>>, i8)> =
        adversaries(formula, CASES, 1).into_iter().map(|(points, sign): (_, Sign)| (points, sign.as_i8())).collect();
    let name = formula.name();
    let points: Vec<String> = formula.points().iter().map(|point| format!("\"{point}\"")).collect();
    let definition = format!(
        "name = \"{name}\"\nabout = \"{}\"\npoints = [{}]\ndimension = {}\nformula = '''\n{}\n'''\n",
        formula.about().replace('"', "'"),
        points.join(", "),
        formula.dimension(),
        formula.text().trim()
    );
    let engine = format!(
        "name    = \"{name}\"\nabout   = \"A predicate from a formula, in Python\"\nneeds   = \"Python 3.8 or newer as python3\"\n\
         version = [\"python3\", \"{name}.py\", \"--version\"]\nrun     = [\"python3\", \"{name}.py\"]\n"
    );
    let in_cpp = format!("{name}-cpp");
    let flags = "\"-std=c++17\", \"-O2\", \"-ffp-contract=off\", \"-Wall\", \"-Wextra\"";
    let cpp_engine = format!(
        "name    = \"{in_cpp}\"\nabout   = \"A predicate from a formula, in C++\"\nneeds   = \"a C++17 compiler as c++\"\n\
         version = [\"./{in_cpp}\", \"--version\"]\nbuild   = [[\"c++\", {flags}, \"{name}.cpp\", \"-o\", \"{in_cpp}\"]]\n\
         run     = [\"./{in_cpp}\"]\nclean   = [[\"rm\", \"-f\", \"{in_cpp}\"]]\n"
    );
    let helpers = [
        ("predicament_engine.py", include_str!("../../templates/engine/python/predicament_engine.py")),
        ("predicament_engine.hpp", include_str!("../../templates/engine/cpp/predicament_engine.hpp")),
    ];
    let written = [
        (format!("{name}.toml"), definition),
        (format!("{name}.rs"), write::rust(formula, &cases)),
        (format!("{name}.hpp"), write::cpp(formula, &cases)),
        (format!("{name}.cpp"), write::cpp_engine(formula, &in_cpp)),
        (format!("{name}.py"), write::python(formula, &cases)),
        ("engine.toml".to_owned(), engine),
        ("engine-cpp.toml".to_owned(), cpp_engine),
    ];
    written.into_iter().chain(helpers.map(|(name, text)| (name.to_owned(), text.to_owned()))).collect()
}

fn write_file(path: &Path, text: &str) -> Result<(), Failure> {
    replace(path, text.as_bytes()).map_err(|error| Failure::usage(error.to_string()))
}
