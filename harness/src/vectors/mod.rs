//! Test vectors: queries of scenes with everything that is known about them, as JSON, for tests without this tool.

pub mod tasks;

use std::collections::BTreeSet;

use predicament_corpus::{LoadedScene, content_id};
use predicament_formats::{Written, bits, hexfloat};
use predicament_judge as judge;
use predicament_laws::published;
use predicament_predicates::{Construction, PredicateKind, Question, Scene, Sign, Vertex};
use predicament_tasks::signs::SignQueries;
use predicament_tasks::{Contestant, symbol};
use serde_json::{Map, Value, json};

use crate::exit::Failure;
use crate::tool::Tool;

/// The version of the rows: a new version adds rows and keys, and changes none.
pub const VERSION: u32 = 1;

/// The name of the schema of the rows, a file beside them.
pub const SCHEMA: &str = "predicament-vectors-1.schema.json";

/// The backends whose truths are in the rows.
pub struct Vectors {
    sos: [Box<dyn Contestant>; 2],
    tolerance: Box<dyn Contestant>,
    seen: BTreeSet<String>,
}

/// A query alone: the points that it needs, in the order of the scene, and the vertices that it asks about.
struct Alone {
    scene: Scene,
    question: Question,
    args: Vec<Vertex>,
    written: Option<Written>,
}

impl Vectors {
    /// No rows yet.
    pub fn new(tool: &Tool) -> Result<Vectors, Failure> {
        let backend = |name: &str| tool.backend(name).map_err(Failure::usage);
        let sos = [backend("sos")?, backend("sos:edelsbrunner-mucke")?];
        Ok(Vectors { sos, tolerance: backend("tolerance")?, seen: BTreeSet::new() })
    }

    /// The rows of the queries of a scene, without those that came before.
    ///
    /// # Errors
    /// If the scene asks no predicate, or asks a formula.
    pub fn rows(&mut self, loaded: &LoadedScene) -> Result<Vec<Value>, Failure> {
        let source = format!("{}/{}", loaded.suite, loaded.name);
        let content = loaded.content::<SignQueries>();
        let queries = content.map(|content| &content.queries);
        let of_five = queries.filter(|queries| !matches!(queries.question(), Question::Derived(_)));
        let queries = of_five.ok_or_else(|| {
            Failure::usage(format!("{source}: vectors are queries of the five predicates; choose scenes by -f"))
        })?;
        let mut rows = Vec::new();
        for query in 0..queries.len() {
            let alone = Alone::of(loaded, queries.question(), queries.args(query));
            let id = content_id(&alone.scene, &SignQueries::new(alone.queries()));
            if self.seen.insert(id.clone()) {
                rows.push(self.row(&id, &alone, &source));
            }
        }
        Ok(rows)
    }

    fn row(&self, id: &str, alone: &Alone, source: &str) -> Value {
        let Alone { scene, question, args, written } = alone;
        let verdict = judge::verdict(scene, *question, args);
        let doubles = verdict.sign();
        let decimals = written
            .as_ref()
            .map(|written| judge::Decimals::new(scene, written.digits(), written.numerators()).sign(*question, args));
        let width = scene.dimension().count();
        let table = |cell: &dyn Fn(usize) -> String| -> Vec<Vec<String>> {
            (0..scene.len()).map(|point| (0..width).map(|axis| cell(point * width + axis)).collect()).collect()
        };
        let mut row = Map::new();
        let mut put = |key: &str, value: Value| row.insert(key.to_owned(), value);
        put("id", id.into());
        put("predicate", question.kind().name().into());
        match question {
            Question::Compare(axis) => drop(put("axis", axis.name().into())),
            Question::Orient2d(plane) if width == 3 => drop(put("plane", plane.name().into())),
            _ => {}
        }
        put("hex", json!(table(&|at| hexfloat::format(scene.coordinates()[at]))));
        // The shortest decimal of each double, or the decimal that was written.
        put(
            "decimal",
            json!(table(&|at| written.as_ref().map_or_else(|| shortest(scene.coordinates()[at]), |w| w.text(at)))),
        );
        if !scene.constructions().is_empty() {
            put("constructed", scene.constructions().iter().map(construction).collect());
        }
        put("vertices", args.iter().map(ToString::to_string).collect());
        put("doubles", symbol(doubles).into());
        put("decimals", decimals.map_or(Value::Null, |sign| symbol(sign).into()));
        for (key, backend) in [("sos", &self.sos[0]), ("sos_edelsbrunner_mucke", &self.sos[1])] {
            put(key, ties(backend.as_ref(), alone));
        }
        put("band", self.band(alone));
        put("flags", flags(alone, doubles, decimals, judge::log2_relative(&verdict)).into());
        put("source", source.into());
        Value::Object(row)
    }

    /// The published band of the tolerance scheme for the query alone; null if it has none.
    fn band(&self, alone: &Alone) -> Value {
        let mut band = None;
        let declined = self.tolerance.with_session(&alone.scene, &mut |session| {
            band = session.supports(alone.question.kind()).ok().and_then(|()| published::band(session, alone.question));
        });
        let hex = |x: f64| hexfloat::format(x);
        match (declined, band) {
            (Ok(()), Some(band)) => json!([hex(band.lower), hex(band.upper)]),
            _ => Value::Null,
        }
    }
}

impl Alone {
    fn of(loaded: &LoadedScene, question: Question, args: &[Vertex]) -> Alone {
        let whole = &loaded.scene;
        let mut inputs: Vec<Vertex> = Vec::new();
        let mut constructed: Vec<usize> = Vec::new();
        let mut open: Vec<Vertex> = args.to_vec();
        while let Some(v) = open.pop() {
            match v.construction() {
                None => inputs.push(v),
                Some(index) => {
                    constructed.push(index);
                    open.extend(whole.constructions()[index].flats().flatten());
                }
            }
        }
        inputs.sort_unstable();
        inputs.dedup();
        constructed.sort_unstable();
        constructed.dedup();
        let renumbered = |v: Vertex| match v.construction() {
            None => Vertex::input(inputs.binary_search(&v).unwrap_or(0)),
            Some(index) => Vertex::constructed(constructed.binary_search(&index).unwrap_or(0)),
        };
        let width = whole.dimension().count();
        let at = |v: &Vertex| v.index() * width..(v.index() + 1) * width;
        let coordinates = inputs.iter().flat_map(|v| &whole.coordinates()[at(v)]).copied().collect();
        let mut scene = Scene::new(whole.dimension(), coordinates).expect("points of a scene");
        for &index in &constructed {
            let definition = match whole.constructions()[index] {
                Construction::Ssi(lines) => Construction::Ssi(lines.map(|line| line.map(renumbered))),
                Construction::Lpi { line, plane } => {
                    Construction::Lpi { line: line.map(renumbered), plane: plane.map(renumbered) }
                }
                Construction::Tpi(planes) => Construction::Tpi(planes.map(|plane| plane.map(renumbered))),
                Construction::Ratio { ends, share } => Construction::Ratio { ends: ends.map(renumbered), share },
            };
            scene.construct(definition).expect("the points of a construction are in the scene");
        }
        let written = loaded.written.as_ref().map(|written| {
            let numerators = inputs.iter().flat_map(|v| &written.numerators()[at(v)]).copied().collect();
            Written::new(written.digits(), numerators)
        });
        Alone { scene, question, args: args.iter().map(|&v| renumbered(v)).collect(), written }
    }

    fn queries(&self) -> predicament_predicates::QuerySet {
        predicament_predicates::QuerySet::new(self.question, self.args.clone())
    }
}

/// The sign of a tie by a scheme, from its independent judge, and the term that decides it; null if there is no tie or
/// the scheme declines.
fn ties(backend: &dyn Contestant, alone: &Alone) -> Value {
    let Some(perturbed) = backend.tie_judge() else { return Value::Null };
    let Ok((sign, stage)) = backend.ask(&alone.scene, alone.question, &alone.args) else { return Value::Null };
    if !judge::sign(&alone.scene, alone.question, &alone.args).is_zero() {
        return Value::Null;
    }
    let truth = perturbed(&alone.scene, alone.question, &alone.args);
    // A term of the backend is worth nothing if its sign is wrong.
    let term =
        stage.filter(|_| sign == truth).and_then(|stage| stage.strip_prefix("term ")).and_then(|n| n.parse().ok());
    json!({ "sign": symbol(truth), "term": term.map_or(Value::Null, |n: u64| n.into()) })
}

/// A construction as a list: its kind, then its lines and planes.
fn construction(of: &Construction) -> Value {
    let flats: Vec<Vec<String>> = of.flats().map(|flat| flat.iter().map(ToString::to_string).collect()).collect();
    match of {
        Construction::Ssi(_) => json!({ "ssi": flats }),
        Construction::Lpi { .. } => json!({ "lpi": flats }),
        Construction::Tpi(_) => json!({ "tpi": flats }),
        Construction::Ratio { share, .. } => json!({ "ratio": flats, "share": share.to_string() }),
    }
}

/// The shortest decimal of a double.
fn shortest(x: f64) -> String {
    let (plain, scientific) = (format!("{x}"), format!("{x:e}"));
    if plain.len() <= 24 { plain } else { scientific }
}

/// The flags of a query: what makes it hard, from its coordinates and its signs alone.
fn flags(alone: &Alone, doubles: Sign, decimals: Option<Sign>, log2_relative: Option<f64>) -> Vec<&'static str> {
    let Alone { scene, question, .. } = alone;
    let width = scene.dimension().count();
    let points: Vec<&[f64]> = scene.coordinates().chunks(width).collect();
    let mut differences: Vec<f64> = Vec::new();
    let (mut extent, mut largest) = (0.0_f64, 0.0_f64);
    for axis in 0..width {
        let column = || points.iter().map(|point| point[axis]);
        let last = points.last().map_or(0.0, |point| point[axis]);
        differences.extend(column().map(|x| x - last).filter(|&x| x != 0.0).map(f64::abs));
        let (low, high) = (column().fold(f64::INFINITY, f64::min), column().fold(f64::NEG_INFINITY, f64::max));
        extent = extent.max(high - low);
        largest = largest.max(column().fold(0.0, |most: f64, x| most.max(x.abs())));
    }
    // The number of differences in a product of the determinant.
    let degree = match question.kind() {
        PredicateKind::Compare => 1,
        PredicateKind::Orient2d => 2,
        PredicateKind::Orient3d => 3,
        PredicateKind::Incircle => 4,
        _ => 5,
    };
    let lowest = scene.coordinates().iter().filter_map(|&x| bits::lowest_bit(x)).min().unwrap_or(0);
    let highest = differences.iter().filter_map(|&x| bits::top_exponent(x.min(f64::MAX))).max().unwrap_or(0);
    let of_coordinates = || scene.coordinates().iter().filter(|&&x| x != 0.0).map(|x| x.abs().log2());
    let spread = of_coordinates().fold(f64::NEG_INFINITY, f64::max) - of_coordinates().fold(f64::INFINITY, f64::min);
    [
        ("tie", doubles.is_zero()),
        ("near", !doubles.is_zero() && log2_relative.is_some_and(|log| log < -40.0)),
        ("constructed", !scene.constructions().is_empty()),
        ("decimal", decimals.is_some()),
        ("decimals-differ", decimals.is_some_and(|sign| sign != doubles)),
        ("underflow", lowest * degree < bits::LOWEST),
        ("overflow", (highest + 1) * degree > bits::HIGHEST),
        ("far", extent > 0.0 && largest > 65_536.0 * extent),
        ("mixed", spread > 53.0),
        ("coincident", (0..points.len()).any(|at| points[..at].contains(&points[at]))),
    ]
    .into_iter()
    .filter_map(|(flag, is)| is.then_some(flag))
    .collect()
}
