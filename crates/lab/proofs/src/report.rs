//! All proofs, as tables.

use std::path::Path;

use crate::filters::{Kind, filters};
use crate::gappa::{self, Gappa};
use crate::rules::MODEL;
use crate::{approximations, linear, tolerances};

/// The predicate whose whole proof Coq checks again.
const BY_COQ: &str = "orient3d";

/// Proves everything, and prints the tables.
///
/// Scripts go to `folder`, for reading; what Coq checks goes there too. The lemma takes half of the time, and shares
/// nothing with the rest: it runs beside it.
///
/// # Errors
/// What is not proved.
pub fn all(folder: &Path) -> Result<(), String> {
    std::thread::scope(|scope| {
        let lemma = gappa::is_here("coqc").then(|| scope.spawn(|| lemma(folder)));
        tables(folder)?;
        let Some(lemma) = lemma else {
            println!("NOT RUN: there is no `coqc` here, so Coq checked none of them again.");
            return Ok(());
        };
        let checked = by_coq(folder)?;
        lemma.join().map_err(|_| "the thread that calls Coq has panicked".to_owned())??;
        println!("Coq checked the lemma about incircle; with 13 in place of 14 it refuses the proof.");
        println!("Coq checked {checked} of them again: all of {BY_COQ} for any doubles, and the model of rounding.");
        Ok(())
    })
}

/// Proves everything by Gappa, and prints the tables.
fn tables(folder: &Path) -> Result<(), String> {
    let gappa = Gappa::default();
    for (_, script) in MODEL {
        gappa.ask(script, &[])?;
    }
    println!("| predicate | filter | in the code, in u | proved, in u | slack in ulps |");
    println!("|---|---|---:|---:|---:|");
    let mut refused = 0;
    let mut rows = Vec::new();
    for filter in filters() {
        rows.extend(filter.prove(&gappa)?);
    }
    for filter in linear::filters() {
        rows.push(filter.prove(&gappa)?);
    }
    for row in rows {
        let of_u = |x: f64| x / (f64::EPSILON / 2.0);
        let ulps = row.constant.to_bits() - row.least.to_bits();
        let (constant, least) = (of_u(row.constant), of_u(row.least));
        println!("| {} | {} | {constant:.16} | {least:.16} | {ulps} |", row.name, row.kind);
        // The least constant is proved; the double below it has to be refused.
        if gappa.proves(&row.below) {
            return Err(format!("a constant that is an ulp too small is proved:\n{}", row.below));
        }
        refused += 1;
    }
    println!("\n{refused} constants that are an ulp too small were refused.");
    println!("\n| constructed vertex | stated, in u | proved, in u |\n|---|---:|---:|");
    for row in approximations::prove(&gappa)? {
        println!("| {} | {} | {:.10} |", row.name, row.stated, value(&row.proved));
    }
    println!("\n| section | bound | stated, in ε | proved for f64 | proved for f32 |\n|---|---|---:|---:|---:|");
    for (double, single) in tolerances::prove(&gappa, 53)?.iter().zip(tolerances::prove(&gappa, 24)?) {
        let [in_f64, in_f32] = [value(&double.proved), value(&single.proved)];
        println!("| {} | {} | {} | {in_f64:.4} | {in_f32:.4} |", double.section, double.name, double.stated);
    }
    let scripts = gappa.scripts();
    let whole = scripts.join("\n");
    let file = folder.join("scripts.g");
    std::fs::write(&file, whole).map_err(|error| format!("{}: {error}", file.display()))?;
    println!("\nGappa proved {} scripts; they are in {}.", scripts.len(), file.display());
    Ok(())
}

/// The lemma of `docs/FILTERS.md` about the differences of incircle.
const LEMMA: &str = include_str!("../coq/incircle.v");
/// The axioms of the real numbers of Coq's library, on which the lemma may rest.
const AXIOMS: [&str; 2] =
    ["ClassicalDedekindReals.sig_forall_dec", "FunctionalExtensionality.functional_extensionality_dep"];

/// Has Coq check the lemma about incircle, and refuse a stronger one.
fn lemma(folder: &Path) -> Result<(), String> {
    let printed = gappa::by_coq(LEMMA, folder, "incircle")?;
    let is_axiom = |line: &&str| !line.starts_with(' ') && *line != "Axioms:";
    if let Some(other) = printed.lines().filter(is_axiom).find(|line| !AXIOMS.iter().any(|name| line.starts_with(name)))
    {
        return Err(format!("the lemma about incircle rests on {other}"));
    }
    let stronger = LEMMA.replace("+ 14 * Rabs D.", "+ 13 * Rabs D.");
    if stronger == LEMMA || gappa::by_coq(&stronger, folder, "incircle_13").is_ok() {
        return Err("coqc accepts a lemma about incircle that is not the one proved".to_owned());
    }
    Ok(())
}

/// A script with a hint that is wrong, so that Gappa proves what is not true.
const WRONG: &str = "{ x in [0, 1] -> y in [0, 1] }\ny -> x;\n";

/// Checks the proofs of one predicate by Coq, which has to refuse a wrong hint; returns their number.
fn by_coq(folder: &Path) -> Result<usize, String> {
    let gappa = Gappa::default();
    for (_, script) in MODEL {
        gappa.ask(script, &[])?;
    }
    let filter = filters().into_iter().find(|filter| filter.name == BY_COQ).expect("one of the predicates");
    gappa.ask(&filter.script(&gappa, Kind::Anywhere, filter.constant)?, &[])?;
    let scripts = gappa.scripts();
    gappa::by_coq(&gappa::for_coq(&scripts)?, folder, BY_COQ)?;
    if gappa::by_coq(&gappa::for_coq(&[WRONG.to_owned()])?, folder, "wrong").is_ok() {
        return Err("coqc accepts a proof by a wrong hint".to_owned());
    }
    Ok(scripts.len())
}

/// A number of Gappa as a double, for printing.
#[must_use]
pub fn value(number: &str) -> f64 {
    let (mantissa, exponent) = number.split_once('b').unwrap_or((number, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    // (In two steps: the mantissa is large where the power is small.)
    let half = 2_f64.powi(exponent / 2);
    mantissa.parse::<f64>().unwrap_or(f64::NAN) * half * 2_f64.powi(exponent - exponent / 2)
}
