//! An external task: its own key, family and table, on every built-in backend without code there that names it.

use std::any::Any;
use std::sync::atomic::AtomicBool;

use predicament_bundle::Systems;
use predicament_corpus::{
    Canon, Content, Context, Family, Level, LoadedScene, Parts, Recipe, SceneFormat, Source, Suite, Vocabulary,
};
use predicament_formats::{Cache, CorpusError, Fields, Manifest, read_points};
use predicament_oracle::roster::backend;
use predicament_oracle::run;
use predicament_predicates::{Dimension, Plane, PredicateKind, Predicates, Query, Question, Scene, Sign, Vertex};
use predicament_records::{Env, Interface, Outcome as Ended, Plan, Row, RunDir, RunWriter, TableSpec};
use predicament_report::{Block, Cell, Section, Table, html, markdown};
use predicament_tasks::output::{self, Choice, Files};
use predicament_tasks::{
    Answer, AnyCase, AnyTask, Asked, Budget, Case, Class, Contestant, ExplainError, Explanation, Finding, Halt, How,
    Outcome, Purpose, Stop, Task, TaskList, Watch, digest,
};
use serde::{Deserialize, Serialize};

/// The task that counts the left turns of a path.
#[derive(Clone, Copy, Debug)]
struct LeftTurns;

/// A path from every n-th point to the next.
#[derive(Debug)]
struct Stride(usize);

impl Stride {
    fn turns(&self, scene: &Scene) -> Vec<[Vertex; 3]> {
        let path: Vec<Vertex> = scene.vertices().step_by(self.0).collect();
        path.windows(3).map(|turn| [turn[0], turn[1], turn[2]]).collect()
    }
}

impl Content for Stride {
    fn count(&self) -> usize {
        1
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("left-turns");
        canon.count(self.0);
    }
}

#[derive(Clone, Default, PartialEq, Debug)]
struct Count(u64);

impl Answer for Count {
    fn digest(&self) -> u64 {
        digest(self.0.to_le_bytes().into_iter())
    }
}

/// A row of `turns.csv`.
#[derive(PartialEq, Debug, Serialize, Deserialize)]
struct TurnRow {
    scene: String,
    backend: String,
    found: u64,
    truth: u64,
}

impl Row for TurnRow {
    const FILE: &'static str = "turns.csv";
    const COLUMNS: &'static [&'static str] = &["scene", "backend", "found", "truth"];
}

/// Paths between a pixel near (0.5, 0.5), (12, 12) and (24, 24), as in the pictures of Kettner et al.: plain floating
/// point gets many turns wrong.
static FAMILIES: [Family; 1] = [Family {
    name: "to-and-fro",
    reported_as: Some("to-and-fro"),
    parameters: &["width"],
    about: "paths through pixels near a line",
    read: |_, fields| {
        let width = fields.integer_or("width", 16, 1..=256)?;
        Ok(Recipe::new(
            |n| 6 * n,
            move |making| {
                let pixel = |k: u64| 0.5 + f64::from(u32::try_from(k % width).unwrap()) * f64::EPSILON / 2.0;
                let lap = |k: u64| [pixel(k), pixel(k / width), 12.0, 12.0, 24.0, 24.0];
                let points = (0..making.n as u64).flat_map(lap).collect();
                Parts::new(Scene::new(Dimension::Two, points).unwrap(), Stride(1))
            },
        ))
    },
}];

impl SceneFormat for LeftTurns {
    fn name(&self) -> &'static str {
        "left-turns"
    }

    fn about(&self) -> &'static str {
        "how many turns to the left a path takes"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "stride"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    fn read(&self, _: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        let points = fields.required("points")?;
        let (dimension, coordinates) = read_points(&points)?;
        let scene =
            Scene::new(dimension, coordinates).map_err(|error| points.error(error.to_string(), "correct it"))?;
        let stride = fields.get("stride").map_or(Ok(1), |field| field.count(1..=9))?;
        Ok(Source::Written(Parts::new(scene, Stride(stride))))
    }

    fn families(&self) -> &'static [Family] {
        &FAMILIES
    }
}

impl Task for LeftTurns {
    type Content = Stride;
    type Truth = u64;
    type Answer = Count;

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Orient2d]
    }

    fn truth(&self, scene: &Scene, content: &Stride, watch: &Watch) -> Result<u64, Stop> {
        watch.done(1)?;
        let sign = |turn: &[Vertex; 3]| predicament_judge::sign(scene, Question::Orient2d(Plane::Xy), turn);
        Ok(content.turns(scene).iter().filter(|turn| sign(turn) == Sign::Positive).count() as u64)
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Stride,
        how: &How<'_>,
        answer: &mut Count,
    ) -> Result<(), Halt> {
        let left = |&&[a, b, c]: &&[Vertex; 3]| session.orient2d(Plane::Xy, a, b, c) == Sign::Positive;
        answer.0 = content.turns(session.scene()).iter().filter(left).count() as u64;
        Ok(how.watch.done(1)?)
    }

    fn judge(
        &self,
        case: &Case<'_, LeftTurns>,
        asked: &Asked<'_>,
        answer: &Count,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        let class = if answer.0 == case.truth { Class::Agree } else { Class::SignFlip };
        outcome.note(class, asked.budget.findings_per_class, || {
            let path: Vec<Vertex> = case.scene().vertices().step_by(case.content.0).collect();
            let query = Query::of_task(self.name(), &path);
            Finding::plain(class, "left turns", vec![query], answer.0.to_string(), case.truth.to_string())
        });
        outcome.row(&TurnRow {
            scene: case.loaded.name.clone(),
            backend: asked.backend.name(),
            found: answer.0,
            truth: case.truth,
        });
        Ok(())
    }

    fn describe(&self, loaded: &LoadedScene, content: &Stride, _: &Watch) -> Result<String, Stop> {
        Ok(format!("{} turns\n", content.turns(&loaded.scene).len()))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Stride,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let about = Explanation { vertices: query.vertices().collect(), ..Explanation::default() };
        let ask = |backend: &dyn Contestant| backend.answer(self, scene, content).map(|count| count.0.to_string());
        Ok(about.with_answers(backends, ask))
    }

    fn write(&self, _: &Scene, _: &Stride, answer: &Count, files: &mut Files) -> Result<(), output::Error> {
        files.write("turns.txt", |out| writeln!(out, "{}", answer.0))
    }

    fn tables(&self) -> Vec<TableSpec> {
        vec![TableSpec::of::<TurnRow>()]
    }

    fn section(&self, runs: &[RunDir]) -> Result<Option<Section>, predicament_records::Error> {
        let mut table = Table::new("").words(["scene", "backend"]).numbers(["found", "truth"]);
        for run in runs {
            for row in run.rows::<TurnRow>()? {
                table.push(vec![row.scene.into(), row.backend.into(), Cell::count(row.found), Cell::count(row.truth)]);
            }
        }
        let some = !table.is_empty();
        let (lead, blocks) = ("Turns to the left.".to_owned(), vec![Block::Table(table)]);
        Ok(some.then_some(Section { id: "left-turns", title: "Left turns", lead, blocks }))
    }
}

const SUITE: &str = r#"
title = "t"
[[scene]]
name = "zigzag"
task = "left-turns"
stride = 2
points = [[0, 0], [9, 9], [1, 0], [9, 9], [2, 5], [9, 9], [3, 5], [9, 9], [0, 6]]
[[generate]]
family = "to-and-fro"
task = "left-turns"
n = 256
"#;

fn vocabulary() -> Vocabulary {
    let own = (LeftTurns, ()).tasks();
    Vocabulary::new(
        predicament_bundle::tasks().iter().copied().chain(own).map(|task| task as &'static dyn SceneFormat).collect(),
    )
}

fn parse(text: &str) -> Result<Vec<LoadedScene>, CorpusError> {
    let suite = Suite::parse(&vocabulary(), "s.toml", text, None, &Manifest::default())?;
    suite.scenes.iter().map(|scene| scene.load(Level::Quick, &Cache::new("nowhere"))).collect()
}

/// The written scene and the generated one.
fn scenes() -> [LoadedScene; 2] {
    parse(SUITE).unwrap().try_into().unwrap()
}

fn on(name: &str) -> Box<dyn Contestant> {
    backend(name, &(LeftTurns, Systems)).unwrap()
}

/// Calls a function with a watch that never stops it.
fn watched<T>(then: impl FnOnce(&Watch) -> T) -> T {
    then(&Watch::new(&AtomicBool::new(false), None, &|_| {}))
}

fn ran(loaded: &LoadedScene, backend: &dyn Contestant) -> Outcome {
    watched(|watch| {
        let case = LeftTurns.case(loaded, watch).unwrap();
        run(case.as_ref(), backend, Budget::QUICK, watch).unwrap()
    })
}

#[test]
fn its_scenes_are_read_from_suites() {
    let [zigzag, generated] = scenes();
    assert_eq!((zigzag.task, zigzag.count(), zigzag.content::<Stride>().unwrap().0), ("left-turns", 1, 2));
    assert_eq!((generated.name.as_str(), generated.family.as_str()), ("to-and-fro-left-turns", "to-and-fro"));
    assert_eq!((generated.scene.len(), generated.content::<Stride>().unwrap().0), (3 * 256, 1));
    let other = parse(&SUITE.replace("stride = 2", "stride = 1")).unwrap();
    assert_ne!(other[0].id, zigzag.id, "the stride is part of the scene");
    for (from, to, message) in [
        ("stride = 2", "stride = 0", "s.toml:6: "),
        ("stride = 2", "axis = \"x\"", "s.toml:6: a scene has no key `axis`"),
        (
            "\"to-and-fro\"",
            "\"to-and-fr\"",
            "s.toml:9: no family is called `to-and-fr`; did you mean `to-and-fro`? use one of ",
        ),
        ("n = 256", "n = 256\nheight = 1", "s.toml:12: "),
        ("task = \"left-turns\"\nn", "task = \"compare\"\nn", "use it for left-turns"),
        (
            "task = \"left-turns\"\ns",
            "task = \"compare\"\ns",
            "s.toml:6: `stride` is a key of left-turns, not of compare",
        ),
    ] {
        assert!(SUITE.contains(from), "{from}");
        let error = parse(&SUITE.replace(from, to)).map(drop).unwrap_err().to_string();
        assert!(error.contains(message), "{from}: {error}");
    }
}

#[test]
fn the_house_refuses_a_suite_of_a_task_that_it_was_not_told_of() {
    let parsed = Suite::parse(predicament_bundle::vocabulary(), "s.toml", SUITE, None, &Manifest::default());
    let error = parsed.unwrap_err().to_string();
    assert!(error.contains("`left-turns`") || error.contains("`stride`"), "{error}");
    let [zigzag, _] = scenes();
    let exact = backend("exact", &()).unwrap();
    let content = zigzag.content::<Stride>().unwrap();
    let answer = exact.answer(&LeftTurns, &zigzag.scene, content);
    assert_eq!(answer.map_err(|why| why.to_string()), Err("exact knows no task `left-turns`".to_owned()));
    let outcome = ran(&zigzag, exact.as_ref());
    assert_eq!(outcome.counts.get(Class::Panic), 1);
    assert!(
        outcome.findings[0].got.contains("exact does not have a solver for the task left-turns"),
        "{:?}",
        outcome.findings
    );
}

#[test]
fn exact_is_right_and_naive_is_not() {
    let [zigzag, generated] = scenes();
    // By hand: (0, 0), (1, 0), (2, 5), (3, 5), (0, 6) turns left, right, left.
    for name in ["exact", "naive"] {
        let outcome = ran(&zigzag, on(name).as_ref());
        assert_eq!((outcome.queries, outcome.counts.get(Class::Agree), outcome.findings.len()), (1, 1, 0), "{name}");
        assert_eq!(outcome.rows[0].fields, ["zigzag", name, "2", "2"]);
        assert_eq!(outcome.stages.iter().map(|&(_, settled)| settled).sum::<u64>(), 3, "{name}");
    }
    let right = ran(&generated, on("exact").as_ref());
    assert_eq!((right.counts.get(Class::Agree), right.counts.findings()), (1, 0));
    let wrong = ran(&generated, on("naive").as_ref());
    assert_eq!((wrong.counts.get(Class::SignFlip), wrong.counts.findings()), (1, 1));
    let finding = &wrong.findings[0];
    assert_eq!(finding.truth, right.rows[0].fields[2]);
    assert_ne!(finding.got, finding.truth);
    assert_ne!((right.digest, wrong.digest.is_some()), (wrong.digest, false));
    assert_eq!(finding.query_text().parse(), Ok(finding.queries[0].clone()));
}

#[test]
fn a_bad_answer_is_judged_wrong() {
    let [zigzag, _] = scenes();
    let exact = on("exact");
    let judged = |answer: &dyn Any| {
        watched(|watch| {
            let case = LeftTurns.case(&zigzag, watch).unwrap();
            assert_eq!(case.truth().downcast_ref(), Some(&2_u64));
            let mut outcome = Outcome::default();
            let judge = &mut |session: &mut dyn Predicates| {
                let asked = Asked { backend: exact.as_ref(), session, budget: Budget::QUICK, watch };
                AnyCase::judge(case.as_ref(), &asked, answer, &mut outcome).unwrap();
            };
            exact.with_session(&zigzag.scene, judge).unwrap();
            outcome
        })
    };
    assert_eq!(judged(&Count(2)).counts.findings(), 0);
    let outcome = judged(&Count(3));
    assert_eq!(outcome.counts.get(Class::SignFlip), 1);
    assert_eq!((outcome.findings[0].got.as_str(), outcome.findings[0].truth.as_str()), ("3", "2"));
    assert_eq!(outcome.findings[0].query_text(), "left-turns(0 2 4 6 8)");
    assert_eq!(outcome.digest, Some(Count(3).digest()));
}

#[test]
fn its_findings_can_be_asked_again() {
    let [_, generated] = scenes();
    let (exact, naive) = (on("exact"), on("naive"));
    let wrong = ran(&generated, naive.as_ref());
    let query = &wrong.findings[0].queries[0];
    let explained = LeftTurns.explain_query(&generated, query, &[exact.as_ref(), naive.as_ref()]).unwrap();
    assert_eq!(explained.vertices.len(), generated.scene.len());
    let finding = &wrong.findings[0];
    let rows = [("exact", &finding.truth), ("naive", &finding.got)];
    assert_eq!(explained.rows, rows.map(|(name, count)| (name.to_owned(), vec![count.clone()])));
    let missing = Query::of_task("left-turns", &[Vertex::input(generated.scene.len())]);
    let error = LeftTurns.explain_query(&generated, &missing, &[]).unwrap_err().to_string();
    assert!(error.contains("the scene has no vertex 768"), "{error}");
}

#[test]
fn its_answers_are_written_and_timed() {
    let [zigzag, _] = scenes();
    let exact = on("exact");
    let folder = tempfile::tempdir().unwrap();
    let mut files = Vec::new();
    let write = &mut |answer: &dyn Any| {
        files = LeftTurns.write_answer(&zigzag, answer, folder.path(), &Choice::default()).unwrap().files;
    };
    exact.answer_any("left-turns", &zigzag.scene, zigzag.content.as_ref(), Purpose::Files, write).unwrap();
    assert_eq!(files, [folder.path().join("turns.txt")]);
    assert_eq!(std::fs::read_to_string(&files[0]).unwrap(), "2\n");

    let solver = exact.solver("left-turns").unwrap();
    assert_eq!(solver.interfaces(zigzag.content.as_ref()), [Interface::Whole]);
    let mut stopwatch = solver.stopwatch(&zigzag.scene, zigzag.content.as_ref(), 1, Interface::Whole).unwrap().unwrap();
    stopwatch.pass();
    assert_eq!(stopwatch.digest(), Count(2).digest());
}

#[test]
fn its_rows_reach_the_report() {
    let folder = tempfile::tempdir().unwrap();
    let plan = Plan { scenes: Vec::new(), ..RunDir::open("tests/data/checked").unwrap().plan };
    let mut writer = RunWriter::create(folder.path(), &plan, &Env::default(), &LeftTurns.own_tables()).unwrap();
    let runs = [RunDir::open(folder.path()).unwrap()];
    assert_eq!(LeftTurns.own_section(&runs).unwrap(), None, "nothing ran yet");
    for name in ["exact", "naive"] {
        writer.append(&ran(&scenes()[0], on(name).as_ref()).rows).unwrap();
    }
    writer.finish(Ended::Complete).unwrap();
    let runs = [RunDir::open(folder.path()).unwrap()];
    let section = LeftTurns.own_section(&runs).unwrap().unwrap();
    let page = markdown(&runs, std::slice::from_ref(&section)).unwrap();
    assert!(page.contains("## Left turns\n\nTurns to the left.\n"), "{page}");
    assert!(page.contains("| zigzag | exact | 2 | 2 |\n| zigzag | naive | 2 | 2 |\n"), "{page}");
    assert!(html(&runs, &[section], &[]).unwrap().contains("<section id=\"left-turns\">"));
    // Other columns of the same length, in a folder that does not list its files: otherwise it would be refused.
    let [path, state] = [TurnRow::FILE, "state.json"].map(|file| folder.path().join(file));
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(path, text.replace("truth", "trust")).unwrap();
    let known = std::fs::read_to_string(&state).unwrap();
    let (before, _) = known.split_once(",\n  \"digests\"").unwrap();
    let before: Vec<&str> = before.lines().filter(|line| !line.starts_with("  \"seal\"")).collect();
    std::fs::write(state, before.join("\n") + "\n}\n").unwrap();
    let error = LeftTurns.own_section(&[RunDir::open(folder.path()).unwrap()]).unwrap_err().to_string();
    assert!(error.contains("turns.csv:1: the columns must be scene,backend,found,truth"), "{error}");
}
