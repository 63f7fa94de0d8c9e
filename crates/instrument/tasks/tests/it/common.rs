//! An independent judge: textbook determinants over rationals; and the pinned ids.

use std::collections::BTreeMap;
use std::path::PathBuf;

use predicament_corpus::LoadedScene;
use predicament_predicates::{QuerySet, Question, Sign, Vertex};
use predicament_tasks::signs::SignQueries;
use rug::Rational;

/// The queries of a sign scene.
pub fn queries(loaded: &LoadedScene) -> &QuerySet {
    let content: Option<&SignQueries> = loaded.content();
    &content.unwrap_or_else(|| panic!("{} asks for no signs", loaded.name)).queries
}

/// The exact determinant of one query: the homogeneous one, with a column of ones and no translation, in the
/// conventions of `Predicates`. Of a formula it is the expanded polynomial, monomial by monomial.
pub fn determinant(loaded: &LoadedScene, query: usize) -> Rational {
    let queries = queries(loaded);
    if let Question::Derived(derived) = queries.question() {
        let coordinates: Vec<Rational> = derived.with_points(&loaded.scene, queries.args(query), |points| {
            points.iter().flat_map(|point| point.iter().map(|&x| Rational::from_f64(x).unwrap())).collect()
        });
        let monomial = |(exponents, coefficient): (&[u8], i128)| {
            let powers = coordinates.iter().zip(exponents).flat_map(|(x, &power)| vec![x; power.into()]);
            powers.fold(Rational::from(coefficient), |product, x| product * x)
        };
        return derived.formula().polynomial().terms().map(monomial).sum();
    }
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

/// The determinant by Laplace expansion along the first column.
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

/// The file of a crate in which the ids of its tasks' scenes are pinned: those of signs are in this crate, those of a
/// system in its own crate.
pub const PINNED: &str = "tests/ids.txt";

/// The id of a scene, as a crate has pinned it.
pub struct Pinned {
    /// The id.
    pub id: String,
    /// The file.
    pub file: PathBuf,
    /// True if the scene has another id after it is written out: `spelled` of its content says why. The word `other`
    /// follows its name.
    pub is_other_once_written: bool,
}

/// The ids that crates have pinned, by the scenes' names.
pub fn pinned() -> BTreeMap<String, Pinned> {
    let systems = std::fs::read_dir("../../systems").unwrap().map(|entry| entry.unwrap().path().join(PINNED));
    let mut pinned: BTreeMap<String, Pinned> = BTreeMap::new();
    for file in systems.chain([PathBuf::from(PINNED)]).filter(|file| file.is_file()) {
        for line in std::fs::read_to_string(&file).unwrap().lines() {
            let words: Vec<&str> = line.split(' ').collect();
            let (id, name, is_other_once_written) = match words[..] {
                [id, name] => (id, name, false),
                [id, name, "other"] => (id, name, true),
                _ => panic!("{}: `{line}` is not an id, a name and perhaps `other`", file.display()),
            };
            let new = Pinned { id: id.to_owned(), file: file.clone(), is_other_once_written };
            let before = pinned.insert(name.to_owned(), new);
            assert!(before.is_none(), "{name} is in {} and {}", before.unwrap().file.display(), file.display());
        }
    }
    pinned
}
