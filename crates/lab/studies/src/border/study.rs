//! The command line of the study of borders, its survey and its output.

use std::fmt::Write as _;

use predicament_corpus::{Items, Level, List, LoadedScene, Spelled, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_predicates::{PredicateKind, Question};
use predicament_tasks::signs::SignQueries;
use predicament_tasks::{AnyTask, Budget, Contestant, Finding, run, vocabulary};
use serde::Serialize;

use super::{Border, border, suite};
use crate::steps::surveyed;
use crate::{Common, Error, File, Host, Study};

/// Wrong answers, and the borders next to them.
#[derive(Clone, Debug, clap::Args)]
pub struct Borders {
    /// Backends and engines
    #[arg(short = 'b', long = "backend", value_name = "BACKEND", default_value = "naive,epsilon:1e-10,shewchuk")]
    pub backends: Vec<String>,

    /// Families of the suites in which wrong answers are looked for
    #[arg(
        long = "family",
        value_delimiter = ',',
        default_value = "near,kettner,degen,uniform,wide-scaled,wide-mixed,far",
        value_name = "FAMILY"
    )]
    pub families: Vec<String>,

    /// Queries of each predicate in each family
    #[arg(long, default_value_t = 500, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub queries: u32,

    /// Borders of each predicate in each family
    #[arg(long, default_value_t = 1, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub borders: u32,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// A border of a backend.
#[derive(Clone, PartialEq, Debug)]
pub struct Found {
    /// The backend.
    pub backend: String,
    /// The family of the wrong query.
    pub family: String,
    /// The wrong query.
    pub question: Question,
    /// The coordinates at which the answer is wrong.
    pub input: Vec<f64>,
    /// The border.
    pub border: Border,
    /// The finding at the wrong neighbour.
    pub finding: Finding,
}

/// One answer, without laws between answers.
const BUDGET: Budget = Budget { permutations: 0, relations: 0, ..Budget::QUICK };

impl Study for Borders {
    const NAME: &'static str = "border";
    const ASKS: &'static str = "Find pairs of neighbouring doubles: the backend is right at one and wrong at the other";
    const HELP: &'static str = "\
A wrong answer of each predicate is taken from each family. Each coordinate is moved in both directions, in doubling \
steps, until the answer keeps the backend's promise; then bisection ends at two neighbouring doubles. The nearest border of \
all coordinates is kept.

Files in the folder: border.csv (one row a border), border.md (the printed table), border.toml (a suite with two scenes \
for each border, for `predicament run`).

Examples:
  predicament study border -b naive --out target/border
  predicament study border -b engine:geos --borders 5 --out target/border";

    type Measured = Vec<Found>;

    fn backends(&self) -> Vec<String> {
        self.backends.clone()
    }

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Vec<Found>, Error> {
        let of_kind = |kind: &PredicateKind| host.tasks().iter().copied().find(|task| task.name() == kind.name());
        let tasks: Vec<&'static dyn AnyTask> = PredicateKind::DETERMINANTS.iter().filter_map(of_kind).collect();
        let on_task = |(backend, task)| self.families.iter().map(move |family| (backend, task, family));
        let of_backend = |&backend| tasks.iter().map(move |&task| (backend, task)).collect::<Vec<_>>();
        let steps = backends.iter().flat_map(of_backend).flat_map(on_task).collect();
        surveyed(
            host,
            "families",
            steps,
            |(backend, ..)| backend.name(),
            |(backend, task, family)| self.of_family(task, family, backend, host),
        )
    }

    fn rows(&self, measured: &Vec<Found>) -> Result<Vec<File>, Error> {
        Ok(vec![File::csv("border.csv", measured.iter().map(Row::of))?])
    }

    fn page(&self, measured: &Vec<Found>) -> String {
        let mut page =
            "| backend | predicate | family | class | coordinate | right at | wrong at | doubles from the find |\n\
                        |---|---|---|---|---:|---:|---:|---:|\n"
                .to_owned();
        for row in measured.iter().map(Row::of) {
            let Row { backend, predicate, family, class, coordinate, right, wrong, steps, .. } = row;
            // Writing to a String cannot fail.
            let _ = writeln!(
                page,
                "| `{backend}` | {predicate} | {family} | {class} | {coordinate} | {right:?} | {wrong:?} | {steps} |"
            );
        }
        if measured.is_empty() {
            page += "\nNo answer was wrong.\n";
        }
        page
    }

    fn suites(&self, measured: &Vec<Found>) -> Result<Vec<File>, Error> {
        Ok(vec![suite::of(measured)])
    }
}

/// A row of `border.csv`.
#[derive(Serialize)]
struct Row<'f> {
    backend: &'f str,
    predicate: &'static str,
    family: &'f str,
    class: &'static str,
    coordinate: usize,
    right: f64,
    wrong: f64,
    steps: u128,
    got: &'f str,
    truth: &'f str,
    /// All coordinates of the wrong query.
    coordinates: String,
}

impl<'f> Row<'f> {
    fn of(found: &'f Found) -> Row<'f> {
        let Found { backend, family, question, input, border, finding } = found;
        Row {
            backend,
            predicate: question.kind().name(),
            family,
            class: finding.class.name(),
            coordinate: border.coordinate,
            right: border.right,
            wrong: border.wrong,
            steps: border.steps,
            got: &finding.got,
            truth: &finding.truth,
            coordinates: input.iter().map(|&x| predicament_formats::hexfloat::format(x)).collect::<Vec<_>>().join(" "),
        }
    }
}

impl Borders {
    /// The borders of the first wrong answers in a family.
    fn of_family(
        &self,
        task: &'static dyn AnyTask,
        family: &str,
        backend: &dyn Contestant,
        host: &dyn Host,
    ) -> Result<Vec<Found>, Error> {
        let loaded = self.scene(task, family)?;
        let mut found = Vec::new();
        for finding in outcome(task, &loaded, backend, host)? {
            let Some(query) = finding.queries.first() else { continue };
            let Some(alone) = alone(task, &loaded, query)? else { continue };
            let input = alone.scene.coordinates().to_vec();
            let verdict = |coordinates: &[f64]| -> Option<Option<Finding>> {
                let moved = alone.clone().moved(coordinates.to_vec()).ok()?;
                Some(outcome(task, &moved, backend, host).ok()?.into_iter().next())
            };
            // An answer that depends on the rest of its scene has no border of its own.
            if !matches!(verdict(&input), Some(Some(_))) {
                continue;
            }
            let Some(border) = border(&input, |moved| verdict(moved).map(|finding| finding.is_none())) else {
                continue;
            };
            host.watch().done(0)?;
            let input: Vec<f64> = input
                .iter()
                .enumerate()
                .map(|(at, &x)| if at == border.coordinate { border.wrong } else { x })
                .collect();
            let Some(Some(finding)) = verdict(&input) else { continue };
            let question = alone.content::<SignQueries>().expect("a scene of signs").queries.question();
            found.push(Found { backend: backend.name(), family: family.to_owned(), question, input, border, finding });
            if found.len() as u64 == u64::from(self.borders) {
                break;
            }
        }
        Ok(found)
    }

    fn scene(&self, task: &'static dyn AnyTask, family: &str) -> Result<LoadedScene, Error> {
        let text = format!(
            "title = \"border\"\n[[generate]]\nname = \"border\"\nfamily = \"{family}\"\ntask = \"{}\"\nn = {}\nseed = {}\n",
            task.name(),
            self.queries,
            self.common.seed
        );
        let suite = Suite::parse(&vocabulary(&[task]), "border", &text, None, &Manifest::default());
        let cache = Cache::new("border");
        suite.and_then(|suite| suite.scenes[0].load(Level::Quick, &cache)).map_err(Error::unfit)
    }
}

/// The findings of a backend on a scene about single signs; none if it declines.
fn outcome(
    task: &'static dyn AnyTask,
    loaded: &LoadedScene,
    backend: &dyn Contestant,
    host: &dyn Host,
) -> Result<Vec<Finding>, Error> {
    let case = task.case(loaded, host.watch())?;
    let outcome = run(case.as_ref(), backend, BUDGET, host.watch())?;
    Ok(outcome.findings.into_iter().filter(|finding| finding.class.is_wrong_answer()).collect())
}

/// The scene with the points of one query alone.
fn alone(
    task: &'static dyn AnyTask,
    loaded: &LoadedScene,
    query: &predicament_predicates::Query,
) -> Result<Option<LoadedScene>, Error> {
    let vertices: Vec<_> = query.vertices().collect();
    let Some(mut spelled) = loaded.spelled().filter(|_| vertices.iter().all(|v| !v.is_constructed())) else {
        return Ok(None);
    };
    spelled.points = vertices.iter().map(|&v| loaded.scene.point(v).to_vec()).collect();
    let args = (0..vertices.len()).map(predicament_predicates::Vertex::input).collect();
    spelled.lists = vec![List::required("queries", Items::Tuples(vec![args]))];
    let spelled: Spelled = spelled;
    spelled.loaded(&vocabulary(&[task]), "border").map(Some).map_err(Error::unfit)
}
