//! Coefficients by their definition, in rationals: the reference for filters, integers and predicates.

use predicament_predicates::Sign;
use rug::Rational;

use crate::Term;

/// The number as a rational.
pub(crate) fn rational(x: f64) -> Rational {
    Rational::from_f64(x).expect("finite")
}

/// The determinant, expanded along its first row.
pub(crate) fn determinant(rows: &[Vec<Rational>]) -> Rational {
    let Some((first, rest)) = rows.split_first() else { return Rational::from(1) };
    let without = |column: usize| {
        let strike = |row: &Vec<Rational>| [&row[..column], &row[column + 1..]].concat();
        determinant(&rest.iter().map(strike).collect::<Vec<_>>())
    };
    let term = |column: usize| without(column) * &first[column];
    (0..rows.len()).map(|column| if column % 2 == 0 { term(column) } else { -term(column) }).sum()
}

/// The remaining minor of sorted points: coordinates, the lift if there is one, and 1.
pub(crate) fn minor<const D: usize>(points: &[[f64; D]], term: &Term) -> Rational {
    let row = |&row: &u8| -> Vec<Rational> {
        let point = points[usize::from(row)];
        let lift = term.lift.map(|lift| -> Rational {
            let origin = |axis: usize| lift.about[axis].map_or(0.0, |about| points[usize::from(about)][axis]);
            (0..D).map(|axis| (rational(point[axis]) - rational(origin(axis))).square()).sum()
        });
        let coordinates = term.columns.iter().map(|&column| rational(point[usize::from(column)]));
        coordinates.chain(lift).chain([Rational::from(1)]).collect()
    };
    determinant(&term.rows.iter().map(row).collect::<Vec<_>>())
}

/// The sign of the whole coefficient.
pub(crate) fn coefficient<const D: usize>(points: &[[f64; D]], term: &Term) -> Sign {
    let gap = term.gap.map_or(Rational::from(1), |gap| {
        let [from, to] = [gap.from, gap.to].map(|row| rational(points[usize::from(row)][usize::from(gap.column)]));
        from - to
    });
    term.sign * Sign::from((minor(points, term) * gap).cmp0())
}
