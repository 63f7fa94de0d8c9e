//! `ask`: one question about a few points, put to every backend.

use std::io::Read;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, TypedValueParser};
use predicament_corpus::{Level, LoadedScene, Suite};
use predicament_formats::{Columns, CoordinateError, CorpusError, Decimals, Manifest, Place, hexfloat, points};
use predicament_judge as judge;
use predicament_predicates::{Class, Derived, PredicateKind, Query, Question, Vertex};
use predicament_tasks::signs::SignQueries;
use predicament_tasks::{Budget, Contestant, Outcome, Watch, ids};
use serde_json::{Map, Value, json};

use crate::colour::{Paint, paint};
use crate::columns;
use crate::exit::{self, Failure};
use crate::out::program;
use crate::select::Selector;
use crate::told::point_lines;
use crate::tool::Tool;
use crate::{interrupt, progress};

const EXAMPLES: &str = "\
A point is its coordinates with commas between them: decimals that are exactly doubles, or hex floats. The points are \
taken in order, as many for each query as the predicate takes.

Columns: query and args, the exact sign, its value as the nearest double (inf, in JSON null, where it is beyond all) and as a \
fraction, then for each backend its answer, with the class where that is not \
`agree`, and the stage that decided it; in CSV three columns each, such as `naive answer`, `naive class`, `naive stage`. \
A backend that declines says why on stderr. With --decimals there are also sign and value of the decimals as they are \
written (columns `written` and `written_value`); the classes stay those of the doubles.

Examples:
  predicament ask orient2d 0,0 1,0 0.5,0x1p-60
  predicament ask incircle --round 0.1,0 0,0.1 -0.1,0 0,-0.1 -b exact,sos,naive,shewchuk
  predicament ask orient3d --points mesh.off --queries all --format csv > answers.csv
  predicament ask orient2d --points towns.csv --columns lon,lat --queries random:1000
  predicament ask orient2d --decimals 0.1,0.3 0.2,0.6 0.3,0.9      on a line as written, and their doubles are not
  predicament ask orient2d --plane yz --points - --format json < points.csv";

/// Ask about your own points: every backend's answer, the exact value, the class
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// A predicate: one of the five, one that is shipped as a formula, or one of --formula
    #[arg(value_name = "PREDICATE", value_parser = predicate())]
    pub task: PredicateKind,

    /// Points such as 0.5,1e3 or 0x1.8p+1,0,0
    #[arg(value_name = "POINT")]
    pub typed: Vec<String>,

    /// A file of points (CSV, GeoJSON, WKT, OFF, OBJ, PLY, STL), or - for lines of points on stdin
    #[arg(long, value_name = "FILE", conflicts_with = "typed")]
    pub points: Option<PathBuf>,

    /// The columns of x and y (and z) in a CSV file, by their names in the header or their numbers from 1
    #[arg(long, value_name = "COLUMNS", value_parser = columns::parse, requires = "points", conflicts_with = "typed")]
    pub columns: Option<Columns>,

    /// `tuples` (the points in order), `all` combinations, `random:N` or `random:N:SEED`, or ids such as `0,1,2 3,1,0`
    #[arg(long, default_value = "tuples", value_name = "QUERIES")]
    pub queries: String,

    /// For orient2d of points with three coordinates: xy, yz or zx
    #[arg(long, value_name = "PLANE")]
    pub plane: Option<String>,

    /// For compare: x, y or z
    #[arg(long, value_name = "AXIS")]
    pub axis: Option<String>,

    /// Take the nearest doubles of decimals that are none
    #[arg(long)]
    pub round: bool,

    /// Also the signs of the decimals as they are written, beside those of their doubles
    #[arg(long)]
    pub decimals: bool,

    /// Backends, several with commas or by repeating; all if left out
    #[arg(short = 'b', long = "backend", value_name = "BACKEND")]
    pub backends: Vec<String>,

    /// How to print: aligned text, CSV, or JSON with one object a line
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// The predicates by name.
fn predicate() -> impl TypedValueParser<Value = PredicateKind> {
    let derived = Derived::all().into_iter().map(PredicateKind::Derived);
    let all = PredicateKind::ALL.into_iter().chain(derived).map(PredicateKind::name).collect::<Vec<_>>();
    PossibleValuesParser::new(all).try_map(|name| name.parse::<PredicateKind>())
}

/// The name of the suite that is not written down.
const ASKED: &str = "ask";

/// The name in errors of points that are typed or piped in.
const STDIN: &str = "stdin";

/// Their name to what reads them.
const STDIN_CSV: &str = "stdin.csv";

/// How answers are printed.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
pub enum Format {
    /// Columns for people.
    Text,
    /// One line for each query.
    Csv,
    /// One object for each query.
    Json,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    interrupt::leave_at_once();
    let backends = tool.pick(&args.backends)?;
    // Whoever types points into stdin is not disturbed.
    let is_typed = args.points.as_deref() == Some(Path::new("-"));
    let reading = (!is_typed).then(|| progress::working("reading points"));
    let loaded = load(args, tool)?;
    drop(reading);
    let working = progress::working("computing the truth");
    let quiet = |_: u64| {};
    let watch = Watch::new(interrupt::flag(), None, &quiet);
    let stopped = |_| Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE };
    let case = tool.task(loaded.task).case(&loaded, &watch).map_err(stopped)?;
    let budget = Budget { permutations: 0, relations: 0, ties: usize::MAX, answers: true, ..Budget::QUICK };
    let mut answered: Vec<(String, Outcome)> = Vec::new();
    let mut broken = 0;
    for backend in &backends {
        let backend: &dyn Contestant = backend.as_ref();
        working.now(format!("asking {}", backend.name()));
        let outcome = predicament_oracle::run(case.as_ref(), backend, budget, &watch).map_err(stopped)?;
        match outcome.findings.first().filter(|_| outcome.answers.is_empty()) {
            Some(why) => {
                broken += usize::from(why.class != Class::Declined);
                note!("{}: {}: {}", backend.name(), why.class, why.got);
            }
            None => answered.push((backend.name(), outcome)),
        }
    }
    working.now("comparing");
    let rows = rows(&loaded, &answered)?;
    drop(working);
    match args.format {
        Format::Text => text(&loaded, &rows, &answered),
        Format::Csv => csv(&rows, &answered).map_err(Failure::usage)?,
        Format::Json => rows.iter().for_each(|row| say!("{}", row.json())),
    }
    let wrong = answered.iter().flat_map(|(_, outcome)| &outcome.answers).filter(|line| !line.class.is_legal()).count();
    if wrong + broken == 0 {
        return Ok(exit::OK);
    }
    if broken > 0 {
        note!("{broken} backends gave no answer and did not decline: exit code {}", exit::UNEXPECTED);
    }
    if wrong > 0 {
        note!("{wrong} answers break the promises of their backends: exit code {}", exit::UNEXPECTED);
    }
    Ok(exit::UNEXPECTED)
}

/// One query with everybody's answer.
struct Row {
    query: String,
    args: String,
    sign: String,
    /// The determinant's nearest double, and all of it.
    value: f64,
    exact: String,
    /// The same three about the decimals as they are written, if they are asked about.
    written: Option<(String, f64, String)>,
    /// Backend, answer, class, stage.
    answers: Vec<[String; 4]>,
}

impl Row {
    fn json(&self) -> Value {
        let answers: Map<String, Value> = self
            .answers
            .iter()
            .map(|[backend, answer, class, stage]| {
                (backend.clone(), json!({ "answer": answer, "class": class, "stage": stage }))
            })
            .collect();
        let mut row = json!({
            "query": self.query,
            "args": self.args,
            "exact": self.sign,
            "value": self.value,
            "exact_value": self.exact,
            "answers": answers,
        });
        if let Some((sign, _, exact)) = &self.written {
            row["written"] = sign.as_str().into();
            row["written_value"] = exact.as_str().into();
        }
        row
    }
}

fn rows(loaded: &LoadedScene, answered: &[(String, Outcome)]) -> Result<Vec<Row>, Failure> {
    let content = loaded.content::<SignQueries>().ok_or_else(|| Failure::usage("a scene of another task"))?;
    let queries = &content.queries;
    let row = |at: usize| {
        let (question, args): (Question, _) = (queries.question(), queries.args(at));
        let verdict = judge::verdict(&loaded.scene, question, args);
        let query: Query = question.query(args);
        let answers = answered.iter().filter_map(|(backend, outcome)| {
            let line = outcome.answers.get(at)?;
            Some([backend.clone(), line.answer.clone(), line.class.name().to_owned(), line.stage.to_owned()])
        });
        Row {
            query: query.to_string(),
            args: ids(args),
            sign: verdict.sign().to_string(),
            value: verdict.determinant.to_f64(),
            exact: verdict.determinant.to_string(),
            written: loaded.written.as_ref().map(|written| {
                let judge = judge::Decimals::new(&loaded.scene, written.digits(), written.numerators());
                let verdict = judge.verdict(question, args);
                (verdict.sign().to_string(), verdict.determinant.to_f64(), verdict.determinant.to_string())
            }),
            answers: answers.collect(),
        }
    };
    Ok((0..queries.len()).map(row).collect())
}

/// Each query with the exact sign and value, then a line for each backend; the points of a few queries at the end.
fn text(loaded: &LoadedScene, rows: &[Row], answered: &[(String, Outcome)]) {
    let names = || answered.iter().map(|(name, _)| name.chars().count());
    let width = names().max().unwrap_or(0).max("exact value".len());
    for (at, row) in rows.iter().enumerate() {
        if at > 0 {
            say!();
        }
        say!("{}", row.query);
        say!("  {:<width$}  {:<2} {:e}", "exact value", row.sign, row.value);
        if let Some((sign, value, _)) = &row.written {
            say!("  {:<width$}  {sign:<2} {value:e}", "as written");
        }
        for [backend, answer, class, stage] in &row.answers {
            let stage = if stage.is_empty() { String::new() } else { format!("by {stage}") };
            let line = format!("{answer:<2} {class:<11} {stage}");
            let painted = match class.parse::<Class>() {
                Ok(Class::Agree) => paint(Paint::Good, line.trim_end()),
                Ok(class) if class.is_legal() => paint(Paint::Plain, line.trim_end()),
                _ => paint(Paint::Bad, line.trim_end()),
            };
            say!("  {backend:<width$}  {painted}");
        }
    }
    if rows.len() <= 3 {
        say!();
        let mut vertices: Vec<Vertex> = Vec::new();
        for v in rows
            .iter()
            .filter_map(|row| row.query.parse::<Query>().ok())
            .flat_map(|query| query.vertices().collect::<Vec<_>>())
        {
            if !vertices.contains(&v) {
                vertices.push(v);
            }
        }
        for line in point_lines(loaded, &vertices) {
            say!("{line}");
        }
    }
}

fn csv(rows: &[Row], answered: &[(String, Outcome)]) -> Result<(), csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut head = ["query", "args", "exact", "value", "exact_value"].map(str::to_owned).to_vec();
    if rows.iter().any(|row| row.written.is_some()) {
        head.extend(["written", "written_value"].map(str::to_owned));
    }
    for (name, _) in answered {
        head.extend(["answer", "class", "stage"].map(|what| format!("{name} {what}")));
    }
    writer.write_record(&head)?;
    for row in rows {
        let mut cells =
            vec![row.query.clone(), row.args.clone(), row.sign.clone(), format!("{:e}", row.value), row.exact.clone()];
        cells.extend(row.written.iter().flat_map(|(sign, _, exact)| [sign.clone(), exact.clone()]));
        cells
            .extend(row.answers.iter().flat_map(|[_, answer, class, stage]| [answer, class, stage].map(String::clone)));
        writer.write_record(&cells)?;
    }
    let bytes = writer.into_inner().map_err(|error| error.into_error())?;
    say_text!("{}", String::from_utf8_lossy(&bytes));
    Ok(())
}

/// The points and the question, as a scene of a suite that is not written down.
fn load(args: &Args, tool: &Tool) -> Result<LoadedScene, Failure> {
    let queries = queries(&args.queries)?;
    let points = match &args.points {
        None if args.typed.is_empty() => {
            let message = format!("no points; write some, or name a file with --points: `{} ask --help`", program());
            return Err(Failure::usage(message));
        }
        None => listed(args.typed.iter().enumerate().map(|(at, text)| (format!("point {at}"), text.clone())), args)?,
        Some(file) if file.as_os_str() == "-" => {
            let mut bytes = Vec::new();
            std::io::stdin().read_to_end(&mut bytes).map_err(|error| Failure::usage(format!("{STDIN}: {error}")))?;
            let columns = args.columns.clone().or_else(|| columns::of_bytes(STDIN_CSV, STDIN, bytes.clone()));
            let decimals = Decimals::new(args.round);
            let read = points::read_columns(STDIN_CSV, bytes, columns.as_ref(), &decimals).map_err(for_ask)?;
            let rows = read.coordinates.chunks(read.dimension.count()).map(|row| written(row, args.decimals));
            format!("[{}]", rows.collect::<Vec<_>>().join(",\n"))
        }
        Some(file) => {
            let path = std::path::absolute(file).map_err(Failure::io(file))?;
            let columns = columns::of_file(file, args.columns.as_ref());
            columns::table(&path.display().to_string(), columns.as_ref())
        }
    };
    for (option, value, of) in
        [("--plane", &args.plane, PredicateKind::Orient2d), ("--axis", &args.axis, PredicateKind::Compare)]
    {
        if value.is_some() && args.task != of {
            return Err(Failure::usage(format!("{option} is for {of}, not for {}; leave it out", args.task)));
        }
    }
    let mut text = format!("title = \"Asked\"\n[[scene]]\nname = \"asked\"\ntask = \"{}\"\n", args.task);
    text += &format!("points = {points}\nqueries = {queries}\n");
    for (key, value) in [("plane", &args.plane), ("axis", &args.axis)] {
        if let Some(value) = value {
            text += &format!("{key} = {}\n", quoted(value));
        }
    }
    if args.decimals {
        text += "truth = \"decimals\"\n";
    }
    // Decimals that are typed are passed on as they are.
    if args.round && (args.points.is_some() || args.decimals) {
        text += "round = true\n";
    }
    let base = Some(Path::new("."));
    let is_stdin = args.points.as_deref() == Some(Path::new("-"));
    let told = |error: CorpusError| match is_stdin && error.file == ASKED {
        true => for_ask(CorpusError { message: format!("with {STDIN}: {}", error.message), ..error }),
        false => for_ask(error),
    };
    let suite = Suite::parse(tool.vocabulary(), ASKED, &text, base, &Manifest::default()).map_err(told)?;
    let cache = Selector::everything().cache()?;
    let loaded = suite.scenes[0].load(Level::Quick, &cache).map_err(told)?;
    for remark in &loaded.remarks {
        note!("{}", remark.replace("`queries` selects", "--queries selects"));
    }
    Ok(loaded)
}

/// An error about data, with the cure of this command: there is no suite to write `round` in.
fn for_ask(error: CorpusError) -> Failure {
    if error.file == ASKED {
        let cure = error.cure.replace("write `queries`", "choose others with --queries");
        return Failure::usage(format!("{}; {cure}", error.message));
    }
    let cure = match error.cure.find("write `round = true`") {
        Some(_) => "add --round to read the nearest doubles".to_owned(),
        None => error.cure.clone(),
    };
    let file = error.file.replace(STDIN_CSV, STDIN);
    CorpusError { cure, file, ..error }.into()
}

fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}

/// Points that were typed, as hex floats.
fn listed(points: impl Iterator<Item = (String, String)>, args: &Args) -> Result<String, Failure> {
    let decimals = Decimals::new(args.round);
    let mut rows = Vec::new();
    for (place, text) in points {
        let bare = text.trim().trim_start_matches(['(', '[']).trim_end_matches([')', ']']);
        let cells = bare.split(|c: char| c == ',' || c == ';' || c.is_whitespace()).filter(|cell| !cell.is_empty());
        let (mut row, mut texts) = (Vec::new(), Vec::new());
        for cell in cells {
            let x = decimals.read(cell).map_err(|error| {
                let (message, cure) = predicament_formats::explain(Place::Data, cell, &error);
                let inexact = matches!(error, CoordinateError::Inexact { .. });
                let cure = if inexact { "add --round to take its nearest double".to_owned() } else { cure };
                Failure::usage(format!("{place}: {message}; {cure}"))
            })?;
            row.push(x);
            texts.push(quoted(cell));
        }
        let (fits, cure) = match args.task {
            PredicateKind::Derived(derived) => {
                let count = derived.formula().coordinates();
                let weight = if derived.formula().is_weighted() { ", the last of them the weight" } else { "" };
                (row.len() == count, format!("{} takes {count}{weight}", derived.formula().name()))
            }
            _ => ((2..=3).contains(&row.len()), "write two or three: 0.5,1".to_owned()),
        };
        if !fits {
            return Err(Failure::usage(format!("{place}: {} coordinates in `{text}`; {cure}", row.len())));
        }
        rows.push(if args.decimals { format!("[{}]", texts.join(", ")) } else { written(&row, false) });
    }
    Ok(format!("[{}]", rows.join(",\n")))
}

/// A point as an array of hex floats, or of shortest decimals.
fn written(point: &[f64], decimals: bool) -> String {
    let one = |&x: &f64| if decimals { format!("\"{x}\"") } else { format!("\"{}\"", hexfloat::format(x)) };
    let cells: Vec<String> = point.iter().map(one).collect();
    format!("[{}]", cells.join(", "))
}

/// `--queries` as the value of the key.
fn queries(text: &str) -> Result<String, Failure> {
    if ["tuples", "all"].contains(&text) {
        return Ok(format!("\"{text}\""));
    }
    if let Some(random) = text.strip_prefix("random:") {
        let (count, seed) = random.split_once(':').unwrap_or((random, "0"));
        let is_count = |text: &str| text.parse::<u64>().is_ok();
        if !is_count(count) || !is_count(seed) {
            return Err(Failure::usage(format!(
                "--queries: `{text}` is not valid; write random:N or random:N:SEED, such as random:1000:1"
            )));
        }
        return Ok(format!("{{ random = {count}, seed = {seed} }}"));
    }
    let queries = text.split(|c: char| c == ';' || c.is_whitespace()).filter(|query| !query.is_empty());
    let query = |query: &str| {
        let ids: Result<Vec<u32>, _> = query.split(',').map(str::parse).collect();
        let ids = ids.map_err(|_| {
            Failure::usage(format!(
                "--queries: `{query}` is not a query; write `tuples`, `all`, `random:N` or ids such as `0,1,2 3,1,0`"
            ))
        })?;
        Ok(format!("[{}]", ids.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")))
    };
    Ok(format!("[{}]", queries.map(query).collect::<Result<Vec<_>, Failure>>()?.join(", ")))
}
