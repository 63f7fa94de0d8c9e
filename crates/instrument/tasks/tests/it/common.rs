//! An independent judge: textbook determinants over rationals.

use predicament_corpus::LoadedScene;
use predicament_predicates::{QuerySet, Question, Sign, Vertex};
use predicament_tasks::signs::SignQueries;
use rug::Rational;

/// The queries of a sign scene.
pub fn queries(loaded: &LoadedScene) -> &QuerySet {
    let content: Option<&SignQueries> = loaded.content();
    &content.unwrap_or_else(|| panic!("{} asks for no signs", loaded.name)).queries
}

/// The exact determinant of one query: the homogeneous one, with a column of
/// ones and no translation, in the conventions of `Predicates`.
pub fn determinant(loaded: &LoadedScene, query: usize) -> Rational {
    let queries = queries(loaded);
    let row = |v: &Vertex| -> Vec<Rational> {
        let all: Vec<f64> = match queries.question() {
            Question::Compare(axis) => vec![loaded.scene.coordinate(axis, *v)],
            Question::Orient2d(plane) => loaded.scene.point2(plane, *v).to_vec(),
            _ => loaded.scene.point(*v).to_vec(),
        };
        let mut row: Vec<Rational> = all.iter().map(|&x| Rational::from_f64(x).unwrap()).collect();
        if matches!(queries.question(), Question::Incircle | Question::Insphere) {
            row.push(row.iter().map(|x| Rational::from(x.square_ref())).sum());
        }
        row.push(Rational::from(1));
        row
    };
    laplace(&queries.args(query).iter().map(row).collect::<Vec<_>>())
}

/// Along the first column.
fn laplace(rows: &[Vec<Rational>]) -> Rational {
    if rows.is_empty() {
        return Rational::from(1);
    }
    let mut sum = Rational::new();
    for at in 0..rows.len() {
        if rows[at][0].is_zero() {
            continue;
        }
        let rest: Vec<_> = (0..rows.len()).filter(|&i| i != at).map(|i| rows[i][1..].to_vec()).collect();
        let term = laplace(&rest) * &rows[at][0];
        if at % 2 == 0 { sum += term } else { sum -= term }
    }
    sum
}

/// The exact sign of one query.
pub fn sign(loaded: &LoadedScene, query: usize) -> Sign {
    Sign::from(determinant(loaded, query).cmp0())
}
