//! The command line of the study of repetition, its survey and its output.

use std::collections::BTreeMap;

use predicament_corpus::LoadedScene;
use predicament_predicates::{Class, PredicateKind, Sign, ZeroMeaning};
use predicament_tasks::Contestant;
use predicament_tasks::signs::SignQueries;
use serde::Serialize;

use super::answers::{Given, again, given};
use super::{Row, Way, table};
use crate::compare::{Input, compared, inputs};
use crate::{Common, Error, File, Host, Study};

/// Questions that are asked again in several ways.
#[derive(Clone, Debug, clap::Args)]
pub struct Repeat {
    /// Backends and engines
    #[arg(
        short = 'b',
        long = "backend",
        value_name = "BACKEND",
        default_value = "exact,sos,sos:edelsbrunner-mucke,sos:per-mesh,tolerance,naive,epsilon:1e-10,shewchuk"
    )]
    pub backends: Vec<String>,

    /// Tasks; all if left out
    #[arg(long = "task", value_name = "TASK", value_delimiter = ',')]
    pub tasks: Vec<String>,

    /// The size of a scene, at most: queries, or the task's own measure
    #[arg(long, default_value_t = 200, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub size: u32,

    /// Print the answers, as a new process does for its parent
    #[arg(long, hide = true)]
    pub answers: bool,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// All comparisons, or the first answers alone.
#[derive(Clone, Debug, Default)]
pub struct Measured {
    /// The comparisons.
    pub rows: Vec<Row>,
    /// The first answers, in the order of the scenes.
    answers: Vec<Answered>,
}

/// The answers of one backend to one scene.
#[derive(Clone, Debug, Serialize, serde::Deserialize)]
struct Answered {
    task: String,
    scene: String,
    answers: String,
}

impl Study for Repeat {
    const NAME: &'static str = "repeat";
    const ASKS: &'static str = "Ask the same again, in seven ways: does a backend give the same answer twice?";
    const HELP: &'static str = "\
Each backend answers scenes of every task, and answers them again: in the same process, in a new one, on 1, 2 and 8 \
threads, with the queries in another order, and, where a backend does not break ties by the numbers of vertices, with \
other numbers. Equal answers are `agree`; others are `unstable`, with both answers. No truth is needed. The last two \
ways are for signs.

The exit code is 100 if an answer is unstable.

Files in the folder: repeat.csv (each scene in each way), repeat.md (the printed tables).

Examples:
  predicament study repeat
  predicament study repeat -b engine:geos,engine:cgal --task orient2d,triangulate --out target/repeat
  predicament study repeat -b fault:unsteady-order,fault:unsteady-time     planted faults";

    type Measured = Measured;

    fn backends(&self) -> Vec<String> {
        self.backends.clone()
    }

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Measured, Error> {
        let tasks = compared(host.tasks(), &self.tasks, "asked again")?;
        let scenes: Vec<(Input, LoadedScene)> =
            inputs(&tasks).iter().map(|input| self.scene(input)).collect::<Result<_, _>>()?;
        host.begin((backends.len() * scenes.len()) as u64, "scenes");
        let mut measured = Measured::default();
        for &backend in backends {
            host.turn_to(&backend.name());
            let firsts: Vec<Given> = scenes.iter().map(|(input, loaded)| given(input.task, loaded, backend)).collect();
            if self.answers {
                let answered = |((_, loaded), first): (&(Input, LoadedScene), &Given)| Answered {
                    task: loaded.task.to_owned(),
                    scene: loaded.name.clone(),
                    answers: first.text(),
                };
                measured.answers.extend(scenes.iter().zip(&firsts).map(answered));
                continue;
            }
            let elsewhere = self.elsewhere(backend, host)?;
            for ((input, loaded), first) in scenes.iter().zip(&firsts) {
                let ways = Way::ALL.into_iter().filter(|&way| way != Way::Ids || is_by_place(backend, loaded));
                for way in ways {
                    let second = match way {
                        Way::Process => elsewhere.get(&(loaded.task.to_owned(), loaded.name.clone())).cloned(),
                        _ => again(way, input.task, loaded, backend, self.common.seed),
                    };
                    measured.rows.extend(second.map(|second| row(backend, loaded, way, first, &second)));
                }
                host.watch().done(1)?;
            }
        }
        Ok(measured)
    }

    fn rows(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        if self.answers {
            return Ok(vec![File::csv("answers.csv", &measured.answers)?]);
        }
        Ok(vec![File::csv("repeat.csv", &measured.rows)?])
    }

    fn page(&self, measured: &Measured) -> String {
        table::page(&measured.rows)
    }

    fn holds(&self, measured: &Measured) -> bool {
        measured.rows.iter().all(|row| row.class != Class::Unstable)
    }

    fn prints_rows(&self) -> bool {
        self.answers
    }
}

impl Repeat {
    /// The scene of an input, of at most the size that is asked for.
    fn scene(&self, input: &Input) -> Result<(Input, LoadedScene), Error> {
        let size = usize::try_from(self.size).unwrap_or(usize::MAX);
        let input = input.sized(input.of.n.min(size));
        Ok((input, input.scene(self.common.seed)?))
    }

    /// The answers of a backend in a new process, by task and scene; empty if the host starts none.
    fn elsewhere(&self, backend: &dyn Contestant, host: &dyn Host) -> Result<BTreeMap<(String, String), Given>, Error> {
        let (seed, size) = (self.common.seed, self.size);
        let words = format!("study repeat --answers --seed {seed} --size {size} -b");
        let mut arguments: Vec<String> = words.split(' ').map(str::to_owned).collect();
        arguments.push(backend.name());
        if !self.tasks.is_empty() {
            arguments.extend(["--task".to_owned(), self.tasks.join(",")]);
        }
        let Some(printed) = host.again(&arguments)? else { return Ok(BTreeMap::new()) };
        let read = |row: Result<Answered, csv::Error>| {
            let Answered { task, scene, answers } = row.map_err(Error::unfit)?;
            Ok(((task, scene), parsed(&answers)))
        };
        let printed = printed.map_err(Error::unfit)?;
        csv::Reader::from_reader(printed.as_bytes()).deserialize().map(read).collect()
    }
}

/// The answers that a new process has printed.
fn parsed(text: &str) -> Given {
    let signs: Option<Vec<_>> = text.chars().map(Sign::from_symbol).collect();
    match (signs, u64::from_str_radix(text, 16)) {
        // A digest has more than signs; sixteen zeros are as likely as any other digest.
        (Some(signs), _) if !text.is_empty() => Given::Signs(signs),
        (_, Ok(digest)) => Given::Whole(digest),
        _ => {
            let (class, why) = text.split_once(": ").unwrap_or((text, ""));
            Given::None { class: class.parse().unwrap_or(Class::Panic), why: why.to_owned() }
        }
    }
}

/// True if the backend's answers to the scene's predicate depend on places only: it does not break ties.
fn is_by_place(backend: &dyn Contestant, loaded: &LoadedScene) -> bool {
    let kind: Option<PredicateKind> = loaded.content::<SignQueries>().map(|content| content.queries.question().kind());
    kind.is_some_and(|kind| backend.contract(kind).zero != ZeroMeaning::Never)
}

/// The comparison of a scene's first answers with those of a way.
fn row(backend: &dyn Contestant, loaded: &LoadedScene, way: Way, first: &Given, second: &Given) -> Row {
    let (answers, unstable, at) = first.differences(second);
    let class = match (unstable, first) {
        (0, Given::None { class, .. }) => *class,
        (0, _) => Class::Agree,
        _ => Class::Unstable,
    };
    let query = |at: usize| {
        let queries = loaded.content::<SignQueries>().map(|content| &content.queries);
        queries.map_or_else(String::new, |queries| queries.question().query(queries.args(at)).to_string())
    };
    let (query, first, second) = at.map_or_else(Default::default, |(at, first, second)| (query(at), first, second));
    Row {
        backend: backend.name(),
        task: loaded.task.to_owned(),
        scene: loaded.name.clone(),
        way: way.to_string(),
        class,
        answers,
        unstable,
        query,
        first,
        second,
    }
}
