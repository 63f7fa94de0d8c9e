//! Tests of the backend against an engine that behaves, and against one that misbehaves in every way.

#[cfg(target_os = "linux")]
mod processes;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use predicament_engines::{Config, Engine, EngineError, Message, Step, chore};
use predicament_predicates::{
    Axis, Backend, Broken, Class, Construction, Counts, Off, Plane, PredicateKind, Predicates, Question, Scene, Sign,
    Vertex,
};

/// The test engine with this kind of failure. It runs in the folder of the tests, which still exists when it restarts.
fn engine(way: &str) -> Result<Engine, EngineError> {
    let folder = tempfile::tempdir().unwrap();
    let mut config = config(folder.path(), way)?;
    config.folder = Path::new(env!("CARGO_MANIFEST_DIR")).to_owned();
    Engine::start(config)
}

fn config(folder: &Path, way: &str) -> Result<Config, EngineError> {
    let program = env!("CARGO_BIN_EXE_engine-of-tests").replace('\\', "/");
    let text = format!(
        "name = \"tests\"\nversion = [\"{program}\", \"version\"]\nrun = [\"{program}\", \"{way}\"]\ntimeout = 1\n\
         build = [[\"{program}\", \"version\"], [\"{program}\", \"none\"]]\nclean = [[\"./no-such-program\"]]\n"
    );
    let file = folder.join("engine.toml");
    std::fs::write(&file, text).unwrap();
    Config::read(&file)
}

fn scene() -> Scene {
    Scene::from_points2(&[[0.0, 0.0], [4.0, 0.0], [1.0, 2.0], [2.0, 0.0], [0.1, 0.1]]).unwrap()
}

fn v<const N: usize>(ids: [usize; N]) -> [Vertex; N] {
    ids.map(Vertex::input)
}

const QUERIES: [[usize; 3]; 4] = [[0, 1, 2], [1, 0, 2], [0, 1, 3], [0, 4, 2]];

fn ask(session: &dyn Predicates) -> Vec<Sign> {
    let mut out = vec![Sign::Zero; QUERIES.len()];
    session.orient2d_batch(Plane::Xy, &QUERIES.map(v), &mut out);
    out
}

const SIGNS: [Sign; 4] = [Sign::Positive, Sign::Negative, Sign::Zero, Sign::Positive];

#[test]
fn signs_times_and_counts_come_back() {
    let engine = engine("").unwrap();
    assert_eq!(engine.name(), "engine:tests");
    assert_eq!(engine.version().as_deref(), Some("library 7.1"), "by its command");
    let (scene, counts) = (scene(), Counts::new());
    let session = engine.prepare(&scene, &counts).unwrap();
    assert_eq!(session.own_nanoseconds(), Some(0));
    assert_eq!(ask(&session), SIGNS);
    assert_eq!(session.own_nanoseconds(), Some(1000));
    assert_eq!(counts.get(PredicateKind::Orient2d, 0), 4);
    let [a, b, c] = v([0, 1, 2]);
    assert_eq!(session.orient2d(Plane::Xy, a, b, c), Sign::Positive);
    assert_eq!(session.compare(Axis::X, a, b), Sign::Negative);
    assert!(session.supports(PredicateKind::Incircle).unwrap_err().reason.contains("does not offer"));
    assert_eq!(session.estimate(Question::Orient2d(Plane::Xy), &[a, b, c]), None);
}

#[test]
fn sessions_take_turns_with_their_scenes() {
    let engine = engine("").unwrap();
    let scenes =
        [scene(), Scene::from_points2(&[[0.0, 0.0], [4.0, 0.0], [1.0, -2.0], [2.0, 1.0], [0.0, 1.0]]).unwrap()];
    let sessions = scenes.each_ref().map(|scene| engine.prepare(scene, Off).unwrap());
    let other = [Sign::Negative, Sign::Positive, Sign::Positive, Sign::Negative];
    for _ in 0..3 {
        assert_eq!(ask(&sessions[0]), SIGNS);
        assert_eq!(ask(&sessions[1]), other);
    }
}

#[test]
fn scenes_are_asked_about_from_many_threads() {
    let engine = engine("").unwrap();
    let scenes: Vec<Scene> = (0..6)
        .map(|k| {
            Scene::from_points2(&[[0.0, 0.0], [4.0, 0.0], [f64::from(k), 2.0 - f64::from(k)], [2.0, 0.0], [0.1, 0.1]])
        })
        .collect::<Result<_, _>>()
        .unwrap();
    let signs = |k: usize| [Sign::Positive, Sign::Zero, Sign::Negative][k.saturating_sub(1).min(2)];
    std::thread::scope(|scope| {
        for (k, scene) in scenes.iter().enumerate() {
            let engine = &engine;
            scope.spawn(move || {
                let session = engine.prepare(scene, Off).unwrap();
                for _ in 0..50 {
                    assert_eq!(ask(&session)[0], signs(k), "{k}");
                }
            });
        }
    });
}

#[test]
fn the_empty_predicate_costs_what_the_binding_costs() {
    let engine = engine("").unwrap();
    let (binding, scene) = (engine.binding().unwrap(), scene());
    assert_eq!(binding.name(), "engine:tests/empty");
    assert!(binding.binding().is_none());
    let session = binding.prepare(&scene, Off).unwrap();
    assert_eq!(ask(&session), [Sign::Zero; 4]);
    assert_eq!(session.own_nanoseconds(), Some(10));
}

#[test]
fn what_an_engine_declines_is_declined() {
    let scene = scene();
    let declined = |way: &str| engine(way).unwrap().prepare(&scene, Off).map(|_| ()).unwrap_err().to_string();
    assert_eq!(declined("decline scene"), "scene declined: not today");
    assert_eq!(declined("single"), "scene declined: coordinates that are not singles");
    let mut constructed = scene.clone();
    constructed.construct(Construction::Ssi([v([0, 1]), v([2, 3])])).unwrap();
    assert!(engine("").unwrap().prepare(&constructed, Off).is_err());
    let engine = engine("single").unwrap();
    let singles = Scene::from_points2(&[[0.5, 0.25]]).unwrap();
    assert!(engine.prepare(&singles, Off).is_ok());
}

#[test]
fn an_engine_that_goes_wrong_breaks_its_session_and_is_started_again() {
    let scene = scene();
    for (way, class, check, said) in [
        (
            "crash on batch",
            Class::Panic,
            "crashed",
            "the process ended with code 3; stderr: about to end / this is the reason",
        ),
        ("abort on batch", Class::Panic, "crashed", "the process was ended by signal 6 (abort)"),
        ("forgets", Class::Panic, "protocol", "an answer `signs` without the `id` of its question"),
        ("crumbs", Class::Panic, "protocol", "a message of more than 64 entries"),
        ("many entries", Class::Panic, "protocol", "an answer of 1073676302 bytes; at most 65540 are allowed"),
        ("long value", Class::Panic, "protocol", "an answer of 1073676312 bytes; at most 65540 are allowed"),
        ("silent on batch", Class::Timeout, "silence", "no answer to `batch` within 1s"),
        (
            "garbage on batch",
            Class::Panic,
            "protocol",
            "no message: it begins with the bytes `orie`; an engine prints to stderr, not to stdout",
        ),
        ("error on batch", Class::Panic, "engine error", "out of triangles"),
        ("short", Class::Panic, "protocol", "3 signs came back for 4 queries; stderr: one sign is missing"),
        ("slow clock", Class::Panic, "protocol", "`ns` is 18446744073709551615, and the answer took "),
        ("odd byte", Class::Panic, "protocol", "orient2d(xy; 0 1 2) was answered by the byte 9"),
        ("decline batch", Class::Declined, "batch", "not today"),
        ("declines a query", Class::Declined, "query", "1 queries of a batch, the first orient2d(xy; 0 1 2)"),
    ] {
        let engine = engine(way).unwrap();
        for _ in 0..2 {
            let session = engine.prepare(&scene, Off).unwrap();
            let thrown = catch_unwind(AssertUnwindSafe(|| ask(&session))).unwrap_err();
            let broken = thrown.downcast::<Broken>().unwrap_or_else(|_| panic!("{way}: another panic"));
            assert_eq!((broken.class, broken.check), (class, check), "{way}");
            // The reported duration of an answer varies.
            let told = broken.message.get(..said.len()).filter(|_| said.ends_with(' ')).unwrap_or(&broken.message);
            assert_eq!(told, said, "{way}");
        }
    }
}

/// A question for a task, with a scene of this many bytes and the wanted size of the answer.
fn question(scene: usize, wanted: usize) -> Message {
    Message::new("task")
        .with("task", "hull2d")
        .with("numbers:points", vec![0; scene])
        .with("word:wanted", format!("{wanted:010}"))
}

/// 256 bytes for each byte of the question, and 16 MiB.
#[test]
fn an_answer_to_a_task_has_a_limit_that_grows_with_the_scene() {
    let engine = engine("").unwrap();
    for scene in [0, 80_000] {
        let limit = (1 << 24) + 256 * question(scene, 0).size();
        let (answer, _) = engine.ask_task(&question(scene, limit)).unwrap().unwrap();
        assert!(limit - answer.size() < 100, "{} bytes of {limit}", answer.size());
        let broken = engine.ask_task(&question(scene, limit + 1)).unwrap_err();
        let said = format!("an answer of {} bytes; at most {limit} are allowed", limit + 1);
        assert_eq!((broken.class, broken.check, &*broken.message), (Class::Panic, "protocol", &*said));
    }
}

#[test]
fn an_engine_that_goes_wrong_on_a_task_breaks_this_answer_and_is_started_again() {
    for (way, class, check, said) in [
        ("crash on task", Class::Panic, "crashed", "the process ended with code 3; stderr: about to end / this is the"),
        ("abort on task", Class::Panic, "crashed", "the process was ended by signal 6 (abort)"),
        ("silent on task", Class::Timeout, "silence", "no answer to `task` within 1s"),
        ("half an answer", Class::Panic, "protocol", "a message that ends after 48 of its 100 bytes"),
        ("garbage on task", Class::Panic, "protocol", "no message: it begins with the bytes `orie`"),
        ("error on task", Class::Refused, "refused valid input", "out of triangles"),
        #[cfg(target_os = "linux")]
        ("ends and leaves its pipe", Class::Panic, "crashed", "the process ended with code 0"),
    ] {
        let engine = engine(way).unwrap();
        // More often than an engine of predicates may fail in a row.
        for _ in 0..if way == "crash on task" { 7 } else { 2 } {
            let broken = engine.ask_task(&question(16, 100)).map(|_| ()).unwrap_err();
            assert_eq!((broken.class, broken.check), (class, check), "{way}: {broken}");
            assert!(broken.message.starts_with(said), "{way}: {broken}");
        }
    }
    let declined = engine("decline task").unwrap().ask_task(&question(16, 100)).unwrap();
    assert!(declined.is_err_and(|declined| declined.to_string().contains("not today")));
}

/// The message with which a session breaks on a query.
fn breaks(session: &dyn Predicates) -> String {
    let thrown = catch_unwind(AssertUnwindSafe(|| ask(session))).unwrap_err();
    thrown.downcast::<Broken>().unwrap_or_else(|_| panic!("another panic")).to_string()
}

#[test]
fn an_answer_to_another_question_is_no_answer() {
    let scene = scene();
    // Detected by the question's number.
    for (way, said) in [
        ("twice", "protocol: it sent an extra message `signs`, without a question"),
        ("again", "protocol: an answer to question `3`, where question 4 was asked"),
    ] {
        let engine = engine(way).unwrap();
        let session = engine.prepare(&scene, Off).unwrap();
        assert_eq!(ask(&session), SIGNS, "{way}: the first batch");
        // The second of two simultaneous answers is under way.
        std::thread::sleep(std::time::Duration::from_millis(100));
        assert_eq!(breaks(&session), said, "{way}");
    }
    // Detected by the greeting after it.
    let said = "protocol: it sent an extra message `signs`, without a question";
    let once = engine("without id, twice").unwrap();
    assert_eq!(breaks(&once.prepare(&scene, Off).unwrap()), said);
    let late = engine("without id, again").unwrap();
    let session = late.prepare(&scene, Off).unwrap();
    assert_eq!(ask(&session), SIGNS, "the first batch");
    assert_eq!(breaks(&session), said);
}

#[test]
fn an_engine_that_repeats_no_numbers_is_an_engine() {
    let scene = scene();
    for way in ["without id, ", "without id, nan", "without id, one greeting"] {
        let engine = engine(way).unwrap();
        let session = engine.prepare(&scene, Off).unwrap();
        (0..3).for_each(|_| assert_eq!(ask(&session)[1..], SIGNS[1..], "{way}"));
    }
    let declines = engine("without id, decline batch").unwrap();
    let session = declines.prepare(&scene, Off).unwrap();
    (0..3).for_each(|_| assert_eq!(breaks(&session), "batch: not today"));
}

#[test]
fn an_engine_that_always_breaks_is_given_up() {
    let (engine, scene) = (engine("crash on batch").unwrap(), scene());
    let broken = || {
        let session = engine.prepare(&scene, Off).unwrap();
        let thrown = catch_unwind(AssertUnwindSafe(|| ask(&session))).unwrap_err();
        thrown.downcast::<Broken>().unwrap_or_else(|_| panic!("another panic")).message
    };
    for _ in 0..5 {
        assert!(broken().starts_with("the process ended with code 3"));
    }
    let thrown = catch_unwind(AssertUnwindSafe(|| engine.prepare(&scene, Off).map(|_| ()))).unwrap_err();
    let broken = thrown.downcast::<Broken>().unwrap_or_else(|_| panic!("another panic"));
    assert!(broken.message.starts_with("given up after 5 failures in a row; the last: crashed: "), "{broken}");
}

#[test]
fn so_is_one_that_always_answers_nonsense() {
    let (engine, scene) = (engine("odd byte").unwrap(), scene());
    let broken = || {
        let thrown = catch_unwind(AssertUnwindSafe(|| ask(&engine.prepare(&scene, Off).unwrap()))).unwrap_err();
        thrown.downcast::<Broken>().unwrap_or_else(|_| panic!("another panic")).message
    };
    for _ in 0..5 {
        assert!(broken().ends_with("was answered by the byte 9"));
    }
    assert!(broken().starts_with("given up after 5 failures in a row"));
}

/// An error about an engine without its prefix, the engine and its file.
fn unnamed(error: &str) -> &str {
    let (named, error) = error.split_once("engine.toml): ").unwrap_or_else(|| panic!("no file: {error}"));
    assert!(named.starts_with("engine:tests ("), "{named}");
    error
}

#[test]
#[cfg(unix)]
fn a_version_command_has_a_limit() {
    let folder = tempfile::tempdir().unwrap();
    let mut config = config(folder.path(), "").unwrap();
    config.version = ["yes", "7.1"].map(str::to_owned).to_vec();
    assert_eq!(Engine::start(config.clone()).unwrap().version().as_deref(), Some("7.1"));
    config.version = ["sleep", "1000"].map(str::to_owned).to_vec();
    let error = Engine::start(config).map(|_| ()).unwrap_err().to_string();
    assert_eq!(unnamed(&error), "`sleep 1000` printed no version within 1s");
}

/// An engine's texts appear in tables and on terminals.
#[test]
fn what_an_engine_says_is_bounded() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |way: &str| {
        let mut config = config(folder.path(), way).unwrap();
        config.version.clear();
        Engine::start(config).map(|_| ()).unwrap_err().to_string()
    };
    for (way, said) in [
        ("long name", "protocol: its name is empty, longer than 200 characters, or not one line"),
        ("two lines", "protocol: its version is empty, longer than 200 characters, or not one line"),
        ("long predicate", "protocol: it offers `xxx"),
    ] {
        let error = refused(way);
        let error = unnamed(&error);
        assert!(error.starts_with(said) && error.len() < 400, "{way}: {error}");
    }
    let (engine, scene) = (engine("long number").unwrap(), scene());
    let session = engine.prepare(&scene, Off).unwrap();
    let thrown = catch_unwind(AssertUnwindSafe(|| ask(&session))).unwrap_err();
    let broken = thrown.downcast::<Broken>().unwrap_or_else(|_| panic!("another panic"));
    assert!(broken.message.starts_with("`ns` of `signs` is `xxx") && broken.message.len() < 400, "{broken}");
}

#[test]
fn a_nan_is_a_zero_that_says_so() {
    let (engine, scene) = (engine("nan").unwrap(), scene());
    let session = engine.prepare(&scene, Off).unwrap();
    assert_eq!(ask(&session), [Sign::Zero, Sign::Negative, Sign::Zero, Sign::Positive]);
    let question = Question::Orient2d(Plane::Xy);
    assert!(session.estimate(question, &v([0, 1, 2])).is_some_and(f64::is_nan));
    assert_eq!(session.estimate(question, &v([0, 1, 3])), None, "a zero that is one");
}

#[test]
fn an_engine_that_does_not_greet_is_refused_at_once() {
    for (way, said) in [
        ("old", "protocol: it speaks protocol 0, and the tool 1; rebuild the engine"),
        ("odd", "protocol: it offers `sidedness`, which is not a predicate of the protocol"),
        ("silent on hello", "silence: no answer to `hello` within 1s"),
        ("crash on hello", "crashed: the process ended with code 3; stderr: about to end / this is the reason"),
        ("decline hello", "protocol: not today"),
    ] {
        assert_eq!(unnamed(&engine(way).map(|_| ()).unwrap_err().to_string()), said);
    }
}

#[test]
fn chores_run_in_turn_and_say_what_failed() {
    let folder = tempfile::tempdir().unwrap();
    let config = config(folder.path(), "").unwrap();
    let mut told = Vec::new();
    chore(&config, Step::Build, |line| told.push(line.to_owned())).unwrap();
    assert_eq!(told.len(), 2);
    assert!(told[0].ends_with(" version") && told[1].ends_with(" none"));
    let error = chore(&config, Step::Clean, |_| ()).unwrap_err().to_string();
    assert!(unnamed(&error).starts_with("`./no-such-program` did not start: "), "{error}");
    let mut failing = config.clone();
    failing.clean = vec![vec![env!("CARGO_BIN_EXE_engine-of-tests").to_owned(), "fails".to_owned()]];
    let error = chore(&failing, Step::Clean, |_| ()).unwrap_err().to_string();
    assert!(unnamed(&error).contains(" fails` failed: exit ") && error.ends_with("for a reason"), "{error}");
    chore(&config, Step::Install, |_| panic!("there is nothing to install")).unwrap();
}
