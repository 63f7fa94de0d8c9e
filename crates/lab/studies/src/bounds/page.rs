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
Printed by `predicament study bounds`; a test compares this page with the command's
output, up to the worst cases, which `predicament study worst` searches for. `--format csv` has the same rows, with the expression of every quantity.

The `tolerance` backend is *Robust Intersections under Floating Point* (Wang, Jiang,
Schroeder and Teran). Its promise rests on bounds of rounding errors and on
constraints that tie tolerances to them. The paper states both; here they are
derived again. The functions that compute areas, volumes, lengths and weights run
on numbers that carry (s, c, p, n, a, b, r, v) by the paper's rules A to K: a
quantity is at most c L^p, and off by at most aε + bε², of itself where r is 1 and of
c L^p where it is 0. All of that is exact, but for √c, which is rounded up.

ε is the machine epsilon, the distance from 1 to the next number, and every
operation is charged with it; rounding to nearest loses half of that at most. All
bounds hold for ε < 10⁻⁵.

What is not as the paper prints it:

* Rules B and D have their 1 outside of the fraction in column b. That changes b
  alone, and no whole number below.
* Each b has a 1 for all terms of third order and more. Where they are more than
  that, b is what they need at ε = 10⁻⁵.
* Rule G has c = 1, which is right for a coordinate of a unit vector and not for
  1/m. The published bounds are those of u = û · (1/m), computed in this order.
* Magnitudes may have a power of ε: c ε^e L^p. Only tolerances do, and with it
  Algorithms 1 and 6 run on the same numbers from √ε on. L is taken as the number
  that they are computed from, and La and Lb as the numbers that L is.
* A product with a power of two rounds nothing, and ε is one: 2^−k.
* A difference that is bounded from below is off by its own rounding, which is
  relative to it, and by what its operands bring, over the bound. Rule D has both
  relative to c₁ + c₂: too much for 1 − 7ε^¼, a number near 1.
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
            "Of {published} published figures {same} come out to the unit, {smaller} smaller (the published one\n\
             holds), {larger} larger and {invalid} not at all.\n"
        ),
    );
    paragraph(
        page,
        "\
`derived` is a·ε + b·ε² over ε, times c for E, rounded up to a whole number at ε = 10⁻⁵;
`first` is the part before ε alone. What is larger or invalid:

* R[T] ≤ 4ε of figure 5 is right for lengths. λ, φ, ν and ζ (εL⁴) have 5, μ, ξ and ρ
  (ε^¾L³) have 8. Nothing uses the wrong ones: volumes and their tolerances have room.
* √(ζ² − κ²) is the root of a difference whose error isn't relative to it. Nothing
  uses its bound.

R[L̂] ≤ 5ε of 4.1 and 5.1 holds for the numbers La and Lb. If these are differences
of coordinates that were rounded, it is one ε more (the rows of ours): 5ε still
hold in the plane, and in space where 5/2 · 7ε^¼ ≤ 1 − 7ε^¼, that is up to
ε = 2.7·10⁻⁶. The backend rounds its sides up, so that L needs no more than the
factor 1 + 5ε.",
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
    paragraph(page, "With u = û/m the bounds that depend on u are smaller, and not the published ones.");
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
    paragraph(page, &format!("{printed} of {} formulas give the number of figure 1 or 5, over ε^e L^p.", rows.len()));
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
Left side minus right side for L = 1, rounded down; ✗ where the constraint fails. The
comparison is exact: ε is a rational number, roots are enclosed by rationals.
`paper` are the tolerance constraints of sections 4 and 5, `argument` are steps of
5.4.4, and `ours` what the arguments need or our bands for circles are made for.

5.3 states its last constraint with room on both sides of τ. For the lower side τ²
is what is compared, and it needs the row below it. In 5.4.4, m² > λ₊ is used where
only m² > λ₋ is known; the bound g < 0 still comes out up to the ε of the next
table, and its displayed step ≤ −5 needs a smaller ε than that of f32. The
claim itself, checked without the chain (the two rows `direct`), holds for every
ε = 2^−k < 10⁻⁵, that is from 2^−17 on; at 10⁻⁵ itself it doesn't come out.\n",
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
        paragraph(page, &format!("* {}: of {}, {} hold.", origin.as_str(), of.len(), holding.join(", ")));
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
    paragraph(page, "Found by bisection over numbers of three digits, each decided as above.");
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
