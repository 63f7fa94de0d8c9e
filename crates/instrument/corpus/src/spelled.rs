//! Scenes in written form: points, and lists of vertices under the keys of a suite.
//!
//! A loaded scene may come from a generator, a download or a mesh file. A search for smaller or nearby scenes needs a
//! form that it can edit without knowing the task: which items can be left out, which vertices they refer to, and which
//! numbers can be changed. [`Spelled`] is that form. It becomes a scene again through the suite's text, so that a suite
//! can hold every scene that a search finds.

use std::fmt::Write as _;

use predicament_formats::{CorpusError, Manifest, hexfloat, is_exact};
use predicament_predicates::{Construction, Vertex};

use crate::{Level, LoadedScene, Suite, Vocabulary};

/// A scene in written form, to be edited and read again.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Spelled {
    /// The name of the task.
    pub task: &'static str,
    /// The `points`, with two or three coordinates and perhaps a weight each; the key is omitted if the list is empty.
    pub points: Vec<Vec<f64>>,
    /// The `constructed` vertices, defined by vertices of `points`.
    pub constructions: Vec<Construction>,
    /// Keys with fixed values, as TOML.
    pub words: Vec<(&'static str, String)>,
    /// All lists of items.
    pub lists: Vec<List>,
    /// True if the scene has a truth of decimals: coordinates are written as the shortest decimals of their doubles.
    pub decimals: bool,
}

/// The items under one key.
#[derive(Clone, PartialEq, Debug)]
pub struct List {
    /// The key, with a dot if it is in a table: `a.edges`.
    pub key: &'static str,
    /// Its items.
    pub items: Items,
    /// The minimum number of items under the key; with 0 the key of an empty list is omitted.
    pub least: usize,
}

/// The items of a list.
#[derive(Clone, PartialEq, Debug)]
pub enum Items {
    /// Single vertices.
    Vertices(Vec<Vertex>),
    /// Tuples with a fixed number of vertices: queries, segments, triangles.
    Tuples(Vec<Vec<Vertex>>),
    /// Lists of three or more vertices: loops, faces.
    Loops(Vec<Vec<Vertex>>),
    /// Tuples of vertices, each with a row of numbers under a separate key: triangles with their regions.
    Labelled {
        /// The tuples.
        tuples: Vec<Vec<Vertex>>,
        /// The key of the rows.
        key: &'static str,
        /// One row for each tuple.
        rows: Vec<Vec<u32>>,
    },
    /// Rows of coordinates that are not vertices of `points`: probes, cubes.
    Rows(Vec<Vec<f64>>),
    /// Polygons of rings of points that are not vertices of `points`: the regions of a map.
    Polygons(Vec<Vec<Vec<Vec<f64>>>>),
}

impl Items {
    /// Items that are tuples of equal length.
    #[must_use]
    pub fn tuples<const N: usize>(tuples: &[[Vertex; N]]) -> Items {
        Items::Tuples(tuples.iter().map(|tuple| tuple.to_vec()).collect())
    }

    /// The number of items.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Items::Vertices(all) => all.len(),
            Items::Tuples(all) | Items::Loops(all) | Items::Labelled { tuples: all, .. } => all.len(),
            Items::Rows(all) => all.len(),
            Items::Polygons(all) => all.len(),
        }
    }

    /// True if there are no items.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Keeps the items for which `at` returns true, in their order.
    pub fn keep(&mut self, mut at: impl FnMut(usize) -> bool) {
        fn kept<T>(all: &mut Vec<T>, at: &mut impl FnMut(usize) -> bool) {
            let mut place = 0;
            all.retain(|_| (at(place), place += 1).0);
        }
        match self {
            Items::Vertices(all) => kept(all, &mut at),
            Items::Tuples(all) | Items::Loops(all) => kept(all, &mut at),
            Items::Labelled { tuples, rows, .. } => {
                let keep: Vec<bool> = (0..tuples.len()).map(at).collect();
                kept(tuples, &mut |place| keep[place]);
                kept(rows, &mut |place| keep[place]);
            }
            Items::Rows(all) => kept(all, &mut at),
            Items::Polygons(all) => kept(all, &mut at),
        }
    }

    /// The vertices of an item; empty for coordinates.
    #[must_use]
    pub fn vertices(&self, item: usize) -> &[Vertex] {
        match self {
            Items::Vertices(all) => std::slice::from_ref(&all[item]),
            Items::Tuples(all) | Items::Loops(all) | Items::Labelled { tuples: all, .. } => &all[item],
            Items::Rows(_) | Items::Polygons(_) => &[],
        }
    }

    /// Mutable references to every vertex of every item.
    pub fn vertices_mut(&mut self) -> Box<dyn Iterator<Item = &mut Vertex> + '_> {
        match self {
            Items::Vertices(all) => Box::new(all.iter_mut()),
            Items::Tuples(all) | Items::Loops(all) | Items::Labelled { tuples: all, .. } => {
                Box::new(all.iter_mut().flatten())
            }
            Items::Rows(_) | Items::Polygons(_) => Box::new(std::iter::empty()),
        }
    }

    /// Mutable references to every coordinate that is not one of `points`, by rows: a row is a point or another tuple
    /// of coordinates.
    pub fn rows_mut(&mut self) -> Box<dyn Iterator<Item = &mut Vec<f64>> + '_> {
        match self {
            Items::Rows(all) => Box::new(all.iter_mut()),
            Items::Polygons(all) => Box::new(all.iter_mut().flatten().flatten()),
            _ => Box::new(std::iter::empty()),
        }
    }
}

impl List {
    /// A list whose key is omitted if it is empty.
    #[must_use]
    pub fn new(key: &'static str, items: Items) -> List {
        List { key, items, least: 0 }
    }

    /// A list whose key is written even if it is empty.
    #[must_use]
    pub fn required(key: &'static str, items: Items) -> List {
        List { key, items, least: 1 }
    }

    /// True if the key is written: it is omitted only if the list is empty and may be.
    fn is_written(&self) -> bool {
        self.least > 0 || !self.items.is_empty()
    }
}

/// The name of a scene and its descriptions in the suite.
#[derive(Clone, Copy, Debug, Default)]
pub struct Heading<'a> {
    /// The name of the scene.
    pub name: &'a str,
    /// Free words for selecting scenes.
    pub tags: &'a [String],
    /// The origin of the scene.
    pub source: &'a str,
    /// One sentence about the scene.
    pub analysis: &'a str,
}

impl Spelled {
    /// Mutable references to all coordinates, by rows: first points, then lists.
    pub fn rows_mut(&mut self) -> impl Iterator<Item = &mut Vec<f64>> {
        self.points.iter_mut().chain(self.lists.iter_mut().flat_map(|list| list.items.rows_mut()))
    }

    /// All coordinates, by rows.
    #[must_use]
    pub fn rows(&self) -> Vec<&Vec<f64>> {
        let of_lists = self.lists.iter().flat_map(|list| -> Vec<&Vec<f64>> {
            match &list.items {
                Items::Rows(all) => all.iter().collect(),
                Items::Polygons(all) => all.iter().flatten().flatten().collect(),
                _ => Vec::new(),
            }
        });
        self.points.iter().chain(of_lists).collect()
    }

    /// A flag for each vertex: true if lists or constructions use it.
    #[must_use]
    pub fn named(&self) -> Vec<bool> {
        let mut named = vec![false; self.points.len()];
        let of_lists = self.lists.iter().flat_map(|list| (0..list.items.len()).flat_map(|at| list.items.vertices(at)));
        let of_constructions = self.constructions.iter().flat_map(|one| one.flats().flatten());
        for vertex in of_lists.chain(of_constructions).filter(|vertex| !vertex.is_constructed()) {
            if let Some(named) = named.get_mut(vertex.index()) {
                *named = true;
            }
        }
        named
    }

    /// The scene as a `[[scene]]` table. Coordinates are lossless: decimals if these are short and exact, else hex
    /// floats.
    #[must_use]
    pub fn table(&self, heading: Heading<'_>) -> String {
        let row = |coordinates: &[f64]| row(coordinates, self.decimals);
        let mut text = format!("[[scene]]\nname = {}\ntask = {}\n", quoted(heading.name), quoted(self.task));
        if !heading.tags.is_empty() {
            let tags: Vec<String> = heading.tags.iter().map(|tag| quoted(tag)).collect();
            let _ = writeln!(text, "tags = [{}]", tags.join(", "));
        }
        for (key, value) in [("source", heading.source), ("analysis", heading.analysis)] {
            if !value.is_empty() {
                let _ = writeln!(text, "{key} = {}", quoted(value));
            }
        }
        for (key, value) in &self.words {
            let _ = writeln!(text, "{key} = {value}");
        }
        if !self.points.is_empty() {
            write_items(&mut text, "points", self.points.iter().map(|point| row(point)));
        }
        if !self.constructions.is_empty() {
            write_items(&mut text, "constructed", self.constructions.iter().map(constructed));
        }
        for List { key, items, .. } in self.lists.iter().filter(|list| list.is_written()) {
            match items {
                Items::Vertices(all) => {
                    let _ = writeln!(text, "{key} = {}", ids(all));
                }
                Items::Tuples(all) | Items::Loops(all) => write_items(&mut text, key, all.iter().map(|one| ids(one))),
                Items::Labelled { tuples, key: labels, rows } => {
                    write_items(&mut text, key, tuples.iter().map(|one| ids(one)));
                    write_items(&mut text, labels, rows.iter().map(|row| label(row)));
                }
                Items::Rows(all) => write_items(&mut text, key, all.iter().map(|one| row(one))),
                Items::Polygons(all) => write_items(&mut text, key, all.iter().map(|rings| polygon(rings, row))),
            }
        }
        for table in self.emptied() {
            let _ = writeln!(text, "{table} = {{}}");
        }
        text
    }

    /// The tables whose lists are all omitted: a complex may be empty, but its table must be present.
    fn emptied(&self) -> Vec<&'static str> {
        let tables = |is_written: bool| {
            let lists = self.lists.iter().filter(move |list| list.is_written() == is_written);
            lists.filter_map(|list| Some(list.key.split_once('.')?.0))
        };
        let mut emptied: Vec<&'static str> =
            tables(false).filter(|table| !tables(true).any(|at| at == *table)).collect();
        emptied.dedup();
        emptied
    }

    /// The text of a suite with this scene only.
    #[must_use]
    pub fn suite(&self, title: &str, heading: Heading<'_>) -> String {
        format!("title = {}\n\n{}", quoted(title), self.table(heading))
    }

    /// The scene, read from its text.
    ///
    /// # Errors
    /// [`CorpusError`] if the text is not a scene of the task.
    pub fn loaded(&self, vocabulary: &Vocabulary, name: &str) -> Result<LoadedScene, CorpusError> {
        let text = self.suite("spelled", Heading { name, ..Heading::default() });
        let suite = Suite::parse(vocabulary, "spelled.toml", &text, None, &Manifest::default())?;
        suite.scenes[0].load(Level::Quick, &predicament_formats::Cache::new(""))
    }
}

impl LoadedScene {
    /// The scene in written form; `None` if its task does not support it.
    #[must_use]
    pub fn spelled(&self) -> Option<Spelled> {
        let mut spelled = Spelled { task: self.task, ..self.content.spelled(&self.scene)? };
        if self.is_invalid {
            spelled.words.push(("invalid", "true".to_owned()));
        }
        if let Some(written) = &self.written {
            let is_shortest = |(at, &x): (usize, &f64)| written.text(at) == decimal(x);
            if !self.scene.coordinates().iter().enumerate().all(is_shortest) {
                return None;
            }
            spelled.words.push(("truth", "\"decimals\"".to_owned()));
            spelled.decimals = true;
        }
        Some(spelled)
    }
}

/// The points and constructions of a scene, without questions; each point ends with its weight if the scene has
/// weights.
#[must_use]
pub fn spelled_points(scene: &predicament_predicates::Scene) -> Spelled {
    let weight = |v: Vertex| scene.weights().get(v.index()).copied();
    let points = scene.vertices().map(|v| scene.point(v).iter().copied().chain(weight(v)).collect()).collect();
    Spelled { points, constructions: scene.constructions().to_vec(), ..Spelled::default() }
}

/// A text as a TOML basic string.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            letter if letter.is_control() => {
                let _ = write!(quoted, "\\u{:04X}", u32::from(letter));
            }
            letter => quoted.push(letter),
        }
    }
    quoted.push('"');
    quoted
}

/// A coordinate as TOML: a decimal if it is short and exact, else a hex float in quotes.
#[must_use]
pub fn coordinate(x: f64) -> String {
    let is_integer = x == x.trunc() && x.abs() <= 9_007_199_254_740_992.0;
    let decimal = if is_integer { format!("{x:.0}") } else { format!("{x:?}") };
    if is_exact(&decimal) && (is_integer || decimal.len() <= 12) {
        decimal
    } else {
        format!("\"{}\"", hexfloat::format(x))
    }
}

/// The shortest decimal of a double, without an exponent.
fn decimal(x: f64) -> String {
    format!("{}", x + 0.0)
}

fn row(coordinates: &[f64], decimals: bool) -> String {
    let one = |&x: &f64| if decimals { format!("\"{}\"", decimal(x)) } else { coordinate(x) };
    let all: Vec<String> = coordinates.iter().map(one).collect();
    format!("[{}]", all.join(", "))
}

/// The TOML of a row; a row of one number is written as the number.
fn label(row: &[u32]) -> String {
    if let [one] = row { one.to_string() } else { format!("{row:?}") }
}

fn polygon(rings: &[Vec<Vec<f64>>], row: impl Fn(&[f64]) -> String) -> String {
    let ring = |points: &Vec<Vec<f64>>| {
        let points: Vec<String> = points.iter().map(|point| row(point)).collect();
        format!("[{}]", points.join(", "))
    };
    let rings: Vec<String> = rings.iter().map(ring).collect();
    format!("[{}]", rings.join(", "))
}

fn ids(vertices: &[Vertex]) -> String {
    let name = |v: &Vertex| if v.is_constructed() { format!("\"{v}\"") } else { v.to_string() };
    format!("[{}]", vertices.iter().map(name).collect::<Vec<_>>().join(", "))
}

fn constructed(construction: &Construction) -> String {
    let kind = match construction {
        Construction::Ssi(_) => "ssi",
        Construction::Lpi { .. } => "lpi",
        Construction::Tpi(_) => "tpi",
        Construction::Ratio { ends, share } => return format!("{{ ratio = {}, share = \"{share}\" }}", ids(ends)),
    };
    let flats: Vec<String> = construction.flats().map(ids).collect();
    format!("{{ {kind} = [{}] }}", flats.join(", "))
}

/// Writes one item per line, or all on one line if they are short.
fn write_items(text: &mut String, key: &str, items: impl Iterator<Item = String>) {
    let items: Vec<String> = items.collect();
    let width: usize = items.iter().map(|item| item.len() + 2).sum();
    let _ = if width <= 90 {
        writeln!(text, "{key} = [{}]", items.join(", "))
    } else {
        let lines: String = items.iter().map(|item| format!("    {item},\n")).collect();
        writeln!(text, "{key} = [\n{lines}]")
    };
}
