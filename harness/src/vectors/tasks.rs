//! Test vectors for tasks: whole scenes as arrays, with answers that the judge found right.

use predicament_corpus::LoadedScene;
use predicament_formats::{bits, hexfloat};
use predicament_tasks::replies::{Array, Arrays};
use predicament_tasks::{Budget, Contestant, Purpose, Watch};
use serde_json::{Map, Value};

use super::shortest;
use crate::exit::{self, Failure};
use crate::interrupt;
use crate::tool::Tool;

/// The name of the schema of the rows, a file beside them.
pub const SCHEMA: &str = "predicament-task-vectors-1.schema.json";

/// The tasks whose right answer is unique, up to its order.
pub const TASKS: &[&str] = &["polygon-locate", "mesh-locate", "hull2d", "contacts2d", "contacts3d"];

/// The row of a scene: its question as a program of another language gets it, and the right answer.
///
/// # Errors
/// If the answers of the task are not unique, or the scene is not one for other programs.
pub fn row(tool: &Tool, loaded: &LoadedScene) -> Result<Value, Failure> {
    let source = format!("{}/{}", loaded.suite, loaded.name);
    if !TASKS.contains(&loaded.task) {
        let message =
            format!("{source}: vectors are queries of the five predicates, or scenes of {}", TASKS.join(", "));
        return Err(Failure::usage(format!("{message}; choose scenes by -f")));
    }
    let exact = tool.backend("exact").map_err(Failure::usage)?;
    let question = tool.task(loaded.task).question(&loaded.scene, loaded.content.as_ref());
    let question = question.map_err(|why| Failure::usage(format!("{source}: {why}")))?;
    let answer = answer(tool, loaded, exact.as_ref())?;
    let written = loaded.similar.as_ref().map(|similar| self::answer(tool, similar, exact.as_ref())).transpose()?;
    let mut row = Map::new();
    row.insert("id".to_owned(), loaded.id.clone().into());
    row.insert("task".to_owned(), loaded.task.into());
    row.insert("question".to_owned(), arrays(&question, &|x| hexfloat::format(x)));
    let numerals = |x: f64| shortest(x);
    row.insert("decimal".to_owned(), written_points(loaded).unwrap_or_else(|| numbers(&question, &numerals)));
    row.insert("doubles".to_owned(), arrays(&answer, &numerals));
    row.insert("decimals".to_owned(), written.as_ref().map_or(Value::Null, |answer| arrays(answer, &numerals)));
    row.insert("flags".to_owned(), flags(loaded, written.map(|written| written != answer)).into());
    row.insert("source".to_owned(), source.into());
    Ok(Value::Object(row))
}

/// The exact answer to a scene, after the judge of the task found nothing wrong with it.
fn answer(tool: &Tool, loaded: &LoadedScene, exact: &dyn Contestant) -> Result<Arrays, Failure> {
    let (task, scene, content) = (tool.task(loaded.task), &loaded.scene, loaded.content.as_ref());
    let mut arrays = None;
    let asked = exact.answer_any(task.name(), scene, content, Purpose::Use, &mut |answer| {
        arrays = task.as_reply(scene, content, answer);
    });
    asked.map_err(Failure::usage)?;
    let arrays = arrays.ok_or_else(|| Failure::usage(format!("{} has no form for programs", task.name())))?;
    let quiet = |_: u64| {};
    let watch = Watch::new(interrupt::flag(), None, &quiet);
    let stopped = |_| Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE };
    let case = task.case(loaded, &watch).map_err(stopped)?;
    let outcome = predicament_oracle::run(case.as_ref(), exact, Budget::FULL, &watch).map_err(stopped)?;
    match outcome.findings.first() {
        None => Ok(arrays),
        Some(finding) => {
            Err(Failure::usage(format!("{}: the judge does not confirm `exact`: {}", loaded.name, finding.got)))
        }
    }
}

fn arrays(all: &Arrays, number: &dyn Fn(f64) -> String) -> Value {
    let value = |array: &Array| match array {
        Array::Word(word) => Value::from(word.as_str()),
        Array::Ids(ids) => ids.iter().copied().collect(),
        Array::Numbers(numbers) => numbers.iter().map(|&x| number(x)).collect(),
    };
    all.iter().map(|(name, array)| (name.to_owned(), value(array))).collect::<Map<_, _>>().into()
}

/// The arrays of coordinates alone.
fn numbers(all: &Arrays, number: &dyn Fn(f64) -> String) -> Value {
    let mut kept = Arrays::default();
    let coordinates = all.iter().filter(|(_, array)| matches!(array, Array::Numbers(_)));
    coordinates.for_each(|(name, array)| kept.add(name, array.clone()));
    arrays(&kept, number)
}

/// The points as they were written; `None` if the scene has no truth of decimals.
fn written_points(loaded: &LoadedScene) -> Option<Value> {
    let written = loaded.written.as_ref()?;
    let points: Value = (0..written.numerators().len()).map(|at| written.text(at)).collect();
    Some([("points".to_owned(), points)].into_iter().collect::<Map<_, _>>().into())
}

/// The flags of a scene, from its coordinates and its two answers alone.
fn flags(loaded: &LoadedScene, differ: Option<bool>) -> Vec<&'static str> {
    let width = loaded.scene.dimension().count();
    let points: Vec<&[f64]> = loaded.scene.coordinates().chunks(width).collect();
    let top = |x: &f64| bits::top_exponent(*x);
    let exponents = || loaded.scene.coordinates().iter().filter(|x| **x != 0.0).filter_map(top);
    let spread = exponents().max().zip(exponents().min()).map_or(0, |(most, least)| most - least);
    let is_twice = |at: usize| points[..at].contains(&points[at]);
    [
        ("decimal", differ.is_some()),
        ("decimals-differ", differ == Some(true)),
        ("mixed", spread > 53),
        ("coincident", (0..points.len()).any(is_twice)),
    ]
    .into_iter()
    .filter_map(|(flag, is)| is.then_some(flag))
    .collect()
}
