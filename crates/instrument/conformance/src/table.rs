//! The sign scenes of the corpora, in a table that needs no reader of suites.
//!
//! `scenes.txt` is generated from the suites in `corpora/`; a test of the crate `tasks` compares it with them. It holds
//! the scenes that are written out, and the name and parameters of each generated family. The queries of families are
//! not in it: the crate `families` makes them, as it does for the harness.
//!
//! A line begins with the kind of its content:
//! * `family PREDICATE NAME KEY=VALUE …`: a generated family;
//! * `scene SUITE/NAME PREDICATE WAY DIMENSION`: a scene; all lines up to the next scene are its own;
//! * `p BITS …`: a point; `ssi`, `lpi`, `tpi` and the indices of points: a constructed vertex;
//! * `q VERTEX …`: a query; `all`: all combinations of vertices, in order.

use predicament_predicates::PredicateKind;

use crate::Shape;
use crate::query::{Query, Subject};

/// The table.
pub const TABLE: &str = include_str!("scenes.txt");

/// A scene that is written out.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Written {
    pub name: &'static str,
    pub kind: PredicateKind,
    /// The axis or plane; empty if the predicate has neither.
    pub way: &'static str,
    pub dimension: usize,
    points: Vec<Vec<f64>>,
    constructions: Vec<(Shape, Vec<usize>)>,
    queries: Option<Vec<Vec<usize>>>,
}

/// A generated family with its parameters.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Recipe {
    pub kind: PredicateKind,
    pub family: &'static str,
    parameters: Vec<(&'static str, &'static str)>,
}

/// The scenes and the families of the table.
///
/// # Panics
/// If the table is damaged; tests read it whole.
pub(crate) fn read(text: &'static str) -> (Vec<Written>, Vec<Recipe>) {
    let (mut scenes, mut recipes): (Vec<Written>, Vec<Recipe>) = Default::default();
    for line in text.lines().filter(|line| !line.starts_with('#') && !line.is_empty()) {
        let mut words = line.split(' ');
        let first = words.next().unwrap_or_default();
        let rest: Vec<&'static str> = words.collect();
        let bad = || -> ! { panic!("scenes.txt: {line}") };
        match (first, rest.as_slice()) {
            ("family", [kind, family, parameters @ ..]) => recipes.push(Recipe {
                kind: kind.parse().unwrap_or_else(|_| bad()),
                family,
                parameters: parameters.iter().map(|pair| pair.split_once('=').unwrap_or_else(|| bad())).collect(),
            }),
            ("scene", [name, kind, way, dimension]) => scenes.push(Written {
                name,
                kind: kind.parse().unwrap_or_else(|_| bad()),
                way: if *way == "-" { "" } else { way },
                dimension: dimension.parse().unwrap_or_else(|_| bad()),
                points: Vec::new(),
                constructions: Vec::new(),
                queries: Some(Vec::new()),
            }),
            (word, words) => {
                let Some(scene) = scenes.last_mut() else { bad() };
                let indices = || -> Vec<usize> { words.iter().map(|w| w.parse().unwrap_or_else(|_| bad())).collect() };
                let bits = |w: &&str| f64::from_bits(u64::from_str_radix(w, 16).unwrap_or_else(|_| bad()));
                match word {
                    "p" => scene.points.push(words.iter().map(bits).collect()),
                    "ssi" => scene.constructions.push((Shape::Ssi, indices())),
                    "lpi" => scene.constructions.push((Shape::Lpi, indices())),
                    "tpi" => scene.constructions.push((Shape::Tpi, indices())),
                    "all" => scene.queries = None,
                    "q" => {
                        let points = scene.points.len();
                        let vertex = |w: &&str| match w.strip_prefix('c') {
                            Some(index) => index.parse::<usize>().map(|index| points + index),
                            None => w.parse(),
                        };
                        let query = words.iter().map(|w| vertex(w).unwrap_or_else(|_| bad())).collect();
                        scene.queries.as_mut().unwrap_or_else(|| bad()).push(query);
                    }
                    _ => bad(),
                }
            }
        }
    }
    (scenes, recipes)
}

impl Written {
    /// True if the scene has constructed vertices.
    pub(crate) fn is_indirect(&self) -> bool {
        !self.constructions.is_empty()
    }

    /// At most `most` of the scene's queries, evenly spread, asked in this way.
    pub(crate) fn queries(&self, way: usize, most: usize) -> Vec<Query<f64>> {
        let all = match &self.queries {
            Some(queries) => queries.clone(),
            None => combinations(self.points.len() + self.constructions.len(), self.kind.arity()),
        };
        let step = all.len().div_ceil(most.max(1)).max(1);
        all.iter().step_by(step).map(|query| self.query(way, query)).collect()
    }

    fn query(&self, way: usize, vertices: &[usize]) -> Query<f64> {
        let mut query = Query { way, shapes: Vec::new(), coordinates: Vec::new() };
        for &vertex in vertices {
            let own = [vertex];
            let (shape, inputs) = match vertex.checked_sub(self.points.len()) {
                None => (Shape::Input, own.as_slice()),
                Some(index) => (self.constructions[index].0, self.constructions[index].1.as_slice()),
            };
            query.shapes.push(shape);
            query.coordinates.extend(inputs.iter().flat_map(|&input| &self.points[input]));
        }
        query
    }
}

impl Recipe {
    /// The family with its parameters, for people.
    pub(crate) fn title(&self) -> String {
        let parameters: Vec<String> = self.parameters.iter().map(|(key, value)| format!(" {key}={value}")).collect();
        // The points of a pixel map are too long for a title; its corner tells maps apart.
        if self.parameters.iter().any(|(key, _)| *key == "q") {
            let of = |wanted| self.parameters.iter().find(|(key, _)| *key == wanted).map_or("", |(_, value)| value);
            return format!("{} {}", self.family, of("name"));
        }
        format!("{}{}", self.family, parameters.concat())
    }

    /// The factor by which a query of this family takes longer than others, about: integers of thousands of bits.
    pub(crate) fn costs(&self, kind: PredicateKind) -> usize {
        match (self.family, kind) {
            ("wide-mixed", PredicateKind::Insphere) => 8,
            ("wide-mixed", _) => 4,
            _ => 1,
        }
    }

    /// A parameter as a number; `usual` if the table does not name it.
    pub(crate) fn whole(&self, key: &str, usual: i64) -> i64 {
        self.text(key).map_or(usual, |value| value.parse().unwrap_or_else(|_| panic!("scenes.txt: {key}={value}")))
    }

    /// A parameter as a point: bits with a comma between.
    pub(crate) fn point(&self, key: &str) -> [f64; 2] {
        let read = |bits: &str| u64::from_str_radix(bits, 16).ok().map(f64::from_bits);
        let point = self.text(key).and_then(|value| value.split_once(','));
        let point = point.and_then(|(x, y)| Some([read(x)?, read(y)?]));
        point.unwrap_or_else(|| panic!("scenes.txt: {} without the point {key}", self.family))
    }

    fn text(&self, key: &str) -> Option<&'static str> {
        self.parameters.iter().find(|(known, _)| *known == key).map(|(_, value)| *value)
    }
}

/// The way of a subject that a scene asks for; `None` if the subject has no such way.
pub(crate) fn way_of(scene: &Written, subject: Subject) -> Option<usize> {
    let fits = scene.kind == subject.kind && scene.dimension == subject.dimension;
    let is_first = |name: &str| name.is_empty() || matches!(scene.way, "" | "xy");
    subject.ways.iter().position(|&(name, _)| fits && (name == scene.way || is_first(name) && subject.ways.len() == 1))
}

/// Every choice of `k` among `n` indices, in lexicographic order.
fn combinations(n: usize, k: usize) -> Vec<Vec<usize>> {
    let mut all = Vec::new();
    let mut choice: Vec<usize> = (0..k).collect();
    if k > n {
        return all;
    }
    loop {
        all.push(choice.clone());
        let Some(place) = (0..k).rev().find(|&place| choice[place] < n - k + place) else { return all };
        choice[place] += 1;
        for later in place + 1..k {
            choice[later] = choice[later - 1] + 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_read_whole() {
        let (scenes, recipes) = read(TABLE);
        assert!(scenes.len() > 20 && recipes.len() > 50, "{} scenes, {} families", scenes.len(), recipes.len());
        for scene in &scenes {
            let queries = scene.queries(0, usize::MAX);
            assert!(!queries.is_empty(), "{}", scene.name);
            let sizes =
                |query: &Query<f64>| query.shapes.iter().map(|shape| shape.size() * scene.dimension).sum::<usize>();
            assert!(queries.iter().all(|query| query.coordinates.len() == sizes(query)), "{}", scene.name);
            assert!(queries.iter().all(|query| query.shapes.len() == scene.kind.arity()), "{}", scene.name);
        }
        assert!(scenes.iter().any(Written::is_indirect));
    }

    #[test]
    fn a_table_line_by_line() {
        let (scenes, recipes) = read(
            "# a comment\nfamily orient2d near ulps=4\nscene one/two orient2d xy 2\np 3ff0000000000000 0\np 0 0\np 0 \
             3ff0000000000000\np 0 0\nssi 0 1 2 3\nq 0 1 c0\n",
        );
        assert_eq!((recipes[0].title().as_str(), recipes[0].whole("ulps", 1)), ("near ulps=4", 4));
        let query = &scenes[0].queries(0, 10)[0];
        assert_eq!(query.shapes, [Shape::Input, Shape::Input, Shape::Ssi]);
        assert_eq!(query.coordinates[..4], [1.0, 0.0, 0.0, 0.0]);
        assert_eq!(query.coordinates.len(), 12);
    }

    #[test]
    fn all_combinations_in_order() {
        assert_eq!(combinations(4, 3), [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]);
        assert_eq!(combinations(2, 3), Vec::<Vec<usize>>::new());
    }

    #[test]
    #[should_panic(expected = "scenes.txt: mystery 1")]
    fn a_damaged_table_is_refused() {
        let _ = read("scene one/two orient2d xy 2\nmystery 1\n");
    }
}
