//! The derived bounds as a page, `docs/BOUNDS.md`.

use std::fmt::Write as _;

use predicament_tolerance::bounds::coefficient::defined;
use predicament_tolerance::bounds::constraints::{
    At, Constraint, Decision, Origin, constraints, epsilons, validity_limit,
};
use predicament_tolerance::bounds::decimal::{rounded_up, scientific_down};
use predicament_tolerance::bounds::{Derivation, Verdict, derivations, other_orders};

use super::table::{DECIMALS, State, first, state};

const INTRODUCTION: &str = "\
# Error bounds and tolerances, derived
`predicament study bounds` prints this page, except the worst cases, which `predicament study worst` finds. A test
compares the page with the command's output. `--format csv` prints the same rows, with the expression of every quantity.

The `tolerance` backend implements *Robust Intersections under Floating Point* (Wang,
Jiang, Schroeder and Teran). Its promise rests on bounds of rounding errors, and on
constraints that relate the tolerances to these bounds. The paper states both; this
page derives them again. The functions that compute areas, volumes, lengths and
weights run on numbers that carry (s, c, p, n, a, b, r, v) by the paper's rules A to
K. A quantity is at most c L^p. Its error is at most aε + bε², relative to the
quantity if r is 1, and relative to c L^p if r is 0. All values are exact, except
that √c is rounded up.

ε is the machine epsilon, the distance from 1 to the next number. Every operation is
charged with ε, although rounding to nearest loses at most half of it. All bounds
hold for ε < 10⁻⁵.

Differences from the printed paper:

* Rules B and D have their 1 outside of the fraction in column b. This changes only
  b, and no whole number below.
* Each b includes a 1 for all terms of third and higher order. If these terms need
  more, b is the value that they need at ε = 10⁻⁵.
* Rule G has c = 1, which is right for a coordinate of a unit vector but not for
  1/m. The published bounds are for u = û · (1/m), computed in this order.
* A magnitude may have a power of ε: c ε^e L^p. Only tolerances have one. With it,
  Algorithms 1 and 6 run on the same numbers from √ε on. L stands for the number from
  which the tolerances are computed, and La and Lb for the numbers that give L.
* A product with a power of two is exact, and ε is a power of two: 2^−k.
* A difference that is bounded from below has two errors: its own rounding, relative
  to the difference, and the errors of its operands, divided by the bound. Rule D
  takes both relative to c₁ + c₂, which is too much for 1 − 7ε^¼, a number near 1.
";

/// The page.
pub fn page() -> String {
    let mut page = INTRODUCTION.to_owned();
    let all = derivations();
    bounds(&mut page, &all);
    others(&mut page);
    definitions(&mut page);
    decided(&mut page, &constraints());
    page
}

fn heading(page: &mut String, title: &str) {
    write!(page, "\n## {title}\n").expect("a string");
}

fn paragraph(page: &mut String, text: &str) {
    writeln!(page, "{text}").expect("a string");
}

/// A Markdown table; `|` in a cell is escaped.
fn table(page: &mut String, header: &[&str], rows: impl IntoIterator<Item = Vec<String>>) {
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    page.push('\n');
    page.push_str(&line(header.iter().map(|&cell| cell.to_owned()).collect()));
    page.push_str(&line(vec!["---".to_owned(); header.len()]));
    for row in rows {
        page.push_str(&line(row.iter().map(|cell| cell.replace('|', "\\|")).collect()));
    }
}

fn whole(n: Option<u32>) -> String {
    n.map_or_else(|| "none".to_owned(), |n| n.to_string())
}

fn count(all: &[Derivation], verdict: Verdict) -> usize {
    all.iter().filter(|derivation| derivation.verdict() == verdict).count()
}

fn bounds(page: &mut String, all: &[Derivation]) {
    heading(page, "Bounds");
    let published = all.len() - count(all, Verdict::Ours);
    let [same, smaller, larger, invalid] =
        [Verdict::Reproduced, Verdict::Smaller, Verdict::Larger, Verdict::Invalid].map(|verdict| count(all, verdict));
    paragraph(
        page,
        &format!(
            "Of {published} published figures, the derivation reproduces {same} to the unit. It makes {smaller} smaller (the\n\
             published figures hold) and {larger} larger, and finds {invalid} invalid.\n"
        ),
    );
    paragraph(
        page,
        "\
`derived` is (a·ε + b·ε²) / ε at ε = 10⁻⁵, times c for E, rounded up to a whole number.
`first` is the coefficient of ε alone. The larger and the invalid figures:

* R[T] ≤ 4ε of figure 5 is right for lengths. The factor is 5 for λ, φ, ν and ζ (εL⁴),
  and 8 for μ, ξ and ρ (ε^¾L³). Nothing uses the wrong bounds: volumes and their
  tolerances have slack.
* √(ζ² − κ²) is the root of a difference, and the error of the difference is not
  relative to the difference. Nothing uses its bound.

R[L̂] ≤ 5ε of 4.1 and 5.1 holds for the numbers La and Lb. If La and Lb are rounded
differences of coordinates, the bound is one ε larger (the rows `ours`). Then 5ε
still holds in the plane, and in space if 5/2 · 7ε^¼ ≤ 1 − 7ε^¼, that is, up to
ε = 2.7·10⁻⁶. The backend rounds its sides up, so the factor 1 + 5ε is enough for L.",
    );
    table(
        page,
        &["section", "bound", "published", "derived", "first", "c", "p", "e", "a", "b", "r", "verdict"],
        all.iter().map(|derivation| {
            let State { c, p, e, a, b, r } = state(derivation);
            let derived = whole(derivation.whole());
            let published = derivation.published.map_or_else(|| "–".to_owned(), |n| n.to_string());
            let verdict = derivation.verdict().as_str().to_owned();
            let first = first(derivation.derived.as_ref());
            let name = if derivation.is_magnitude { "c of m²".to_owned() } else { derivation.name.clone() };
            vec![derivation.section.to_owned(), name, published, derived, first, c, p, e, a, b, r, verdict]
        }),
    );
}

fn others(page: &mut String) {
    heading(page, "With true division");
    paragraph(page, "The bounds that depend on u are smaller than the published bounds, as u is û/m here.");
    let (ours, other) = (derivations(), other_orders());
    let before = |row: &Derivation| {
        let same = |other: &&Derivation| (other.section, &other.name) == (row.section, &row.name);
        whole(ours.iter().find(same).expect("the same bounds").whole())
    };
    table(
        page,
        &["section", "bound", "published", "û · (1/m)", "û/m"],
        other.iter().map(|row| {
            vec![row.section.to_owned(), row.name.clone(), whole(row.published), before(row), whole(row.whole())]
        }),
    );
}

fn definitions(page: &mut String) {
    let rows = defined();
    let printed = rows.iter().filter(|row| row.is_as_printed()).count();
    heading(page, "Tolerances that constraints define");
    paragraph(page, &format!("{printed} of {} formulas give the factor of ε^e L^p in figure 1 or 5.", rows.len()));
    table(
        page,
        &["section", "tolerance", "formula", "table", "derived", "used here"],
        rows.iter().map(|row| {
            let root = if row.root3 { " · √3" } else { "" };
            let value = rounded_up(&row.value().upper, DECIMALS);
            let derived = if row.root3 { format!("{}{root} ≈ {value}", row.derived) } else { value };
            let used = if row.is_exact() { "the same" } else { "another" };
            let printed = row.tolerance.printed_upper.to_owned();
            vec![row.section.into(), format!("{}₊", row.symbol), row.formula.into(), printed, derived, used.into()]
        }),
    );
}

fn decided(page: &mut String, all: &[Constraint]) {
    heading(page, "Constraints");
    paragraph(
        page,
        "\
Each cell is the left side minus the right side for L = 1, rounded down; ✗ marks a
constraint that fails. The comparison is exact: ε is a rational number, and rationals
enclose the roots. `paper` marks the tolerance constraints of sections 4 and 5,
`argument` the steps of 5.4.4, and `ours` the constraints that the arguments need or
that our bands for circles are designed for.

5.3 states its last constraint with slack on both sides of τ. The lower side compares
τ², and needs the row below it. 5.4.4 uses m² > λ₊ where only m² > λ₋ is known. The
bound g < 0 still holds up to the ε of the next table, but its displayed step ≤ −5
needs a smaller ε than the ε of f32. The claim itself, checked without the chain (the
two rows `direct`), holds for every ε = 2^−k < 10⁻⁵, that is, from 2^−17 on. It fails
at 10⁻⁵ itself.\n",
    );
    let epsilons = epsilons();
    let header: Vec<&str> =
        ["section", "constraint", "of"].into_iter().chain(epsilons.iter().map(|(name, _)| *name)).collect();
    for origin in [Origin::Paper, Origin::Argument, Origin::Ours] {
        let of: Vec<&Constraint> = all.iter().filter(|constraint| constraint.origin == origin).collect();
        let holding = epsilons.iter().map(|(name, epsilon)| {
            let at = At::new(epsilon.clone());
            let n = of.iter().filter(|constraint| constraint.decide(&at) == Decision::Holds).count();
            format!("{n} at {name}")
        });
        let holding: Vec<String> = holding.collect();
        paragraph(
            page,
            &format!("* {}: {} constraints. Satisfied: {}.", origin.as_str(), of.len(), holding.join(", ")),
        );
    }
    table(
        page,
        &header,
        all.iter().map(|constraint| {
            let cells = epsilons.iter().map(|(_, epsilon)| cell(constraint, &At::new(epsilon.clone())));
            let head = [constraint.section.to_owned(), constraint.text.clone(), constraint.origin.as_str().to_owned()];
            head.into_iter().chain(cells).collect()
        }),
    );
    heading(page, "Where a constraint ends");
    paragraph(page, "Bisection over numbers of three digits finds each limit; each number is decided as above.");
    table(
        page,
        &["section", "constraint", "holds at", "fails at"],
        all.iter().filter_map(|constraint| {
            let [holds, fails] = validity_limit(constraint)?;
            Some(vec![constraint.section.to_owned(), constraint.text.clone(), holds.to_string(), fails.to_string()])
        }),
    );
}

fn cell(constraint: &Constraint, at: &At) -> String {
    let slack = constraint.slack(at).map_or_else(|| "equal".to_owned(), |slack| scientific_down(&slack.lower));
    match constraint.decide(at) {
        Decision::Holds => slack,
        Decision::Fails => format!("✗ {slack}"),
        Decision::Undecided => format!("? {slack}"),
    }
}
